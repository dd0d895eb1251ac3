//! `[gas.walls]`: whose heat transfer coefficient, or given.

use crate::document::{Field, Section};
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::Strokes;
use lanchester_model::WallModel;
use std::f64::consts::TAU;

impl<'a> Reader<'a> {
    /// The coefficient, with the keys that its model needs and no others.
    pub(super) fn wall_model(&mut self, section: &'a Section, strokes: Strokes) -> Option<WallModel> {
        let word = section.word("model").or("woschni")?;
        let needed: &[&str] = match word {
            "constant" => &["coefficient"],
            "table" => &["angles", "coefficients"],
            _ => &[],
        };
        let mut is_good = true;
        for key in ["coefficient", "angles", "coefficients"] {
            if section.has(key) && !needed.contains(&key) {
                let model = if key == "coefficient" { "constant" } else { "table" };
                let because = format!("the heat transfer coefficient is that of the model \"{word}\"");
                self.without_effect(
                    section,
                    key,
                    &because,
                    &format!("write model = \"{model}\", or leave it out"),
                );
                is_good = false;
            }
        }
        let model = match word {
            "constant" => self
                .required(section, "coefficient", section.number("coefficient"))
                .map(|coefficient| WallModel::Constant { coefficient }),
            "table" => self.wall_table(section, strokes),
            "hohenberg" => Some(WallModel::Hohenberg),
            _ => Some(WallModel::Woschni),
        };
        model.filter(|_| is_good)
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
