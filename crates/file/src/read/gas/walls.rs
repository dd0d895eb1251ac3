//! `[gas.walls]`: whose heat transfer coefficient, or given.

use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;
use lanchester_model::{WallBody, WallModel};
use std::f64::consts::TAU;

/// Keys of the model "conductance".
const BODY: [&str; 5] =
    ["conductance", "body_capacity", "body_to_ambient", "body_temperature", "ambient_temperature"];

/// Keys of walls with areas, which a conductance does without.
const SURFACES: [&str; 6] = [
    "temperature",
    "piston_temperature",
    "head_temperature",
    "liner_temperature",
    "piston_area",
    "head_area",
];

impl<'a> Reader<'a> {
    /// The coefficient, with the keys that its model needs and no others.
    pub(super) fn wall_model(
        &mut self,
        section: &'a Section,
        strokes: Strokes,
        surroundings: f64,
    ) -> Option<WallModel> {
        let word = section.word("model").or("woschni")?;
        let needed: &[&str] = match word {
            "constant" => &["coefficient"],
            "table" => &["angles", "coefficients"],
            "conductance" => &BODY,
            _ => &[],
        };
        let mut is_good = true;
        for key in ["coefficient", "angles", "coefficients"].into_iter().chain(BODY) {
            if section.has(key) && !needed.contains(&key) {
                let model = match key {
                    "coefficient" => "constant",
                    "angles" | "coefficients" => "table",
                    _ => "conductance",
                };
                let because = format!("the heat to the walls is that of the model \"{word}\"");
                self.without_effect(
                    section,
                    key,
                    &because,
                    &format!("write model = \"{model}\", or leave it out"),
                );
                is_good = false;
            }
        }
        for key in SURFACES {
            if section.has(key) && word == "conductance" {
                let because = "a conductance goes to one body, without areas";
                self.without_effect(section, key, because, "write `body_temperature`, or leave it out");
                is_good = false;
            }
        }
        let model = match word {
            "constant" => self
                .required(section, "coefficient", section.number("coefficient"))
                .map(|coefficient| WallModel::Constant { coefficient }),
            "table" => self.wall_table(section, strokes),
            "conductance" => self.wall_body(section, surroundings).map(WallModel::Conductance),
            "hohenberg" => Some(WallModel::Hohenberg),
            _ => Some(WallModel::Woschni),
        };
        model.filter(|_| is_good)
    }

    /// The body that takes the heat.
    fn wall_body(&mut self, section: &'a Section, surroundings: f64) -> Option<WallBody> {
        let [conductance, capacity, to_ambient] = ["conductance", "body_capacity", "body_to_ambient"]
            .map(|key| self.required(section, key, section.number(key)));
        let ambient = section.number("ambient_temperature").or(surroundings);
        let temperature = match section.number("body_temperature") {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        Some(WallBody {
            conductance: conductance?,
            capacity: capacity?,
            to_ambient: to_ambient?,
            ambient: ambient?,
            temperature: temperature?,
        })
    }

    fn wall_table(&mut self, section: &'a Section, strokes: Strokes) -> Option<WallModel> {
        for key in ["angles", "coefficients"] {
            if !section.has(key) {
                let message = format!("a table of heat transfer coefficients needs `{key}`");
                self.missing(section.span.clone(), message, section.example(key));
            }
        }
        let (Field::Given(angles), Field::Given(coefficients)) =
            (section.numbers("angles"), section.numbers("coefficients"))
        else {
            return None;
        };
        let list =
            |spots: &[crate::document::Spot<f64>]| spots.iter().map(|spot| spot.value).collect::<Vec<_>>();
        let (span, got) = (angles.span.clone(), [angles.value.len(), coefficients.value.len()]);
        let (angles, coefficients) = (list(&angles.value), list(&coefficients.value));
        let cycle = TAU * f64::from(strokes.revolutions());
        let fault = if got[0] != got[1] || got[0] == 0 {
            Some((
                format!("`angles` and `coefficients` need as many values, got {} and {}", got[0], got[1]),
                "give one coefficient an angle",
            ))
        } else if angles.windows(2).any(|pair| pair[1] <= pair[0]) {
            Some(("`angles` must rise".to_owned(), "sort them, each with its coefficient"))
        } else if angles[angles.len() - 1] - angles[0] >= cycle {
            let whole = cycle.to_degrees();
            Some((
                format!("`angles` must lie within one cycle of {whole:.0} deg"),
                "leave out the last, which is the first of the next cycle",
            ))
        } else {
            None
        };
        match fault {
            Some((message, hint)) => {
                self.mistakes.push(Mistake::error("E1202", span, message).label("out of range").hint(hint));
                None
            }
            None => Some(WallModel::Table { angles, coefficients }),
        }
    }
}
