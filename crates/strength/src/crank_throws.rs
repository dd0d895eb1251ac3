//! From the elements of a crankshaft to the throws of the sheet.

use crate::error::{Need, StrengthError};
use crate::section::WebSection;
use lanchester_model::{CrankElement, CrankElementForm, Disc, EngineParts, Fillet, OilHole, RoundBar};
use serde::Serialize;

/// A throw between two main bearings.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RuleThrow {
    /// Index of the throw in the engine.
    pub throw: usize,
    /// Planes of the main bearings in front of and behind it [m].
    pub mains: [f64; 2],
    /// Plane of the middle of its pin, where the rods act [m].
    pub pin: f64,
    /// Crank radius [m].
    pub radius: f64,
    /// Planes of the middles of its webs [m].
    pub webs: [f64; 2],
    /// Numbers of its webs along the crankshaft, from 1.
    pub web_numbers: [usize; 2],
    /// Numbers of its journals, from 1.
    pub journals: [usize; 2],
    /// Sizes at its webs.
    pub sections: [WebSection; 2],
    /// Oil bore of the pin.
    pub oil_hole: Option<OilHole>,
    /// 1 where the crankshaft turns from +x to +y, else -1: the sense in which a driving force acts across the throw.
    pub sense: f64,
}

impl RuleThrow {
    /// The same throw with all its lengths times `length`.
    pub fn scaled(mut self, length: f64) -> RuleThrow {
        self.radius *= length;
        self.pin *= length;
        for plane in self.mains.iter_mut().chain(&mut self.webs) {
            *plane *= length;
        }
        if let Some(hole) = &mut self.oil_hole {
            hole.diameter *= length;
        }
        self.sections = self.sections.map(|own| WebSection {
            pin_diameter: own.pin_diameter * length,
            pin_bore: own.pin_bore * length,
            pin_fillet: own.pin_fillet * length,
            pin_recess: own.pin_recess * length,
            oil_bore: own.oil_bore.map(|bore| bore * length),
            journal_diameter: own.journal_diameter * length,
            journal_bore: own.journal_bore * length,
            journal_fillet: own.journal_fillet * length,
            journal_recess: own.journal_recess * length,
            crank_radius: own.crank_radius * length,
            web_thickness: own.web_thickness * length,
            web_width: own.web_width * length,
        });
        self
    }

    /// Share of a force on the pin that the main bearing in front carries [1]; the rest goes to the one behind.
    pub fn front_share(&self) -> f64 {
        (self.mains[1] - self.pin) / (self.mains[1] - self.mains[0])
    }
}

/// The throws of a crankshaft from the free end on.
///
/// # Errors
/// [`StrengthError`] where the engine gives no body, or lacks fillets, or has throws without a main bearing between them: all at once.
pub fn rule_throws(engine: &EngineParts, crankshaft: usize) -> Result<Vec<RuleThrow>, StrengthError> {
    let elements = engine.crank_elements(crankshaft)?;
    let mains = engine.main_planes(crankshaft);
    let sense =
        engine.crankshafts.get(crankshaft).map_or(1.0, |own| f64::from(own.ratio.numerator().signum()));
    let mut needs = Vec::new();
    let mut throws = Vec::new();
    for (place, element) in elements.iter().enumerate() {
        let CrankElementForm::Pin { throw, bar, oil_hole } = &element.form else { continue };
        let neighbours = Neighbours::of(&elements, place);
        let Some(Neighbours { journals, webs }) = neighbours else {
            needs.push(Need {
                place: format!("throw {}", throw + 1),
                what: "a main bearing on either side of it is needed, it shares a web with another throw or has none between".into(),
                remedy: "the rule covers one throw between two main bearings: choose wider spacing or web distance, or judge it by finite elements".into(),
            });
            continue;
        };
        let planes = journals.map(|(journal, element, _)| main_in(element, &mains, journal, &mut needs));
        let pin = Round::of(bar, &format!("pin {}", throw + 1), "pin_fillet", &mut needs);
        let rounds = journals.map(|(journal, _, bar)| {
            Round::of(bar, &format!("journal {}", journal + 1), "journal_fillet", &mut needs)
        });
        let sections = [0, 1].map(|side| WebSection {
            pin_diameter: bar.diameter,
            pin_bore: bar.bore,
            pin_fillet: pin.radius,
            pin_recess: pin.recess,
            oil_bore: oil_hole.map(|hole| hole.diameter),
            journal_diameter: rounds[side].diameter,
            journal_bore: rounds[side].bore,
            journal_fillet: rounds[side].radius,
            journal_recess: rounds[side].recess,
            crank_radius: bar.centre.norm(),
            web_thickness: webs[side].element.length(),
            web_width: web_width(webs[side].discs, bar.diameter, rounds[side].diameter),
        });
        if let [Some(front), Some(rear)] = planes {
            throws.push(RuleThrow {
                throw: *throw,
                mains: [front, rear],
                pin: middle(element),
                radius: bar.centre.norm(),
                webs: webs.map(|web| middle(web.element)),
                web_numbers: webs.map(|web| web.index + 1),
                journals: journals.map(|(journal, _, _)| journal + 1),
                sections,
                oil_hole: *oil_hole,
                sense,
            });
        }
    }
    // A journal between two throws is met twice.
    let mut once: Vec<Need> = Vec::new();
    for need in needs {
        if !once.contains(&need) {
            once.push(need);
        }
    }
    let needs = once;
    if needs.is_empty() {
        Ok(throws)
    } else {
        Err(StrengthError::Needs { crankshaft: crankshaft + 1, needs })
    }
}

fn middle(element: &CrankElement) -> f64 {
    0.5 * (element.faces[0] + element.faces[1])
}

/// A web beside a pin.
#[derive(Clone, Copy)]
struct OwnWeb<'a> {
    index: usize,
    element: &'a CrankElement,
    discs: [Disc; 2],
}

/// Webs and journals on both sides of a pin.
struct Neighbours<'a> {
    journals: [(usize, &'a CrankElement, &'a RoundBar); 2],
    webs: [OwnWeb<'a>; 2],
}

impl Neighbours<'_> {
    /// Those of the pin at `place`; `None` where a web leads to another pin.
    fn of(elements: &[CrankElement], place: usize) -> Option<Neighbours<'_>> {
        let web = |index: usize| {
            let element = elements.get(index)?;
            match element.form {
                CrankElementForm::Web { web, shared_with: None, discs } => {
                    Some(OwnWeb { index: web, element, discs })
                }
                _ => None,
            }
        };
        let journal = |index: usize| {
            let element = elements.get(index)?;
            match &element.form {
                CrankElementForm::Journal { journal, bar } => Some((*journal, element, bar)),
                _ => None,
            }
        };
        Some(Neighbours {
            journals: [journal(place.checked_sub(2)?)?, journal(place + 2)?],
            webs: [web(place - 1)?, web(place + 1)?],
        })
    }
}

/// The plane of the main bearing within a journal.
fn main_in(journal: &CrankElement, mains: &[f64], index: usize, needs: &mut Vec<Need>) -> Option<f64> {
    let within = |z: &&f64| **z >= journal.faces[0] && **z <= journal.faces[1];
    let found = mains.iter().find(within).copied();
    if found.is_none() {
        let [from, to] = journal.faces.map(|z| 1e3 * z);
        needs.push(Need {
            place: format!("journal {}", index + 1),
            what: format!("a main bearing between {from:.1} mm and {to:.1} mm is needed, none stands there"),
            remedy: "give the planes with mains in [crank]".into(),
        });
    }
    found
}

/// A pin or journal with its fillet.
struct Round {
    diameter: f64,
    bore: f64,
    radius: f64,
    recess: f64,
}

impl Round {
    fn of(bar: &RoundBar, place: &str, key: &str, needs: &mut Vec<Need>) -> Round {
        let fillet = bar.fillets.iter().flatten().next().copied().unwrap_or_default();
        let Fillet { radius, recess } = fillet;
        let got = match radius {
            Some(radius) if radius > 0.0 => None,
            Some(_) => Some("is 0 (sharp)"),
            None => Some("is not given"),
        };
        if let Some(got) = got {
            needs.push(Need {
                place: place.to_owned(),
                what: format!("a fillet radius above 0 is needed, it {got}"),
                remedy: format!("give {key} in [crank.body]"),
            });
        }
        Round { diameter: bar.diameter, bore: bar.bore, radius: radius.unwrap_or(0.0), recess }
    }
}

/// Width of a plain web across its throw, in the middle of the overlap of pin and journal [m].
///
/// ```text
/// x = (D_G/2 + E - D/2)/2      B = 2 (R_1 - x c)/sqrt(1 - c^2),  c = (R_1 - R_2)/E, between the points where the tangents touch
/// ```
/// with the disc R_1 about the crank axis and R_2 about the pin. Counterweights do not count.
fn web_width([axis, pin]: [Disc; 2], pin_diameter: f64, journal_diameter: f64) -> f64 {
    let radius = (pin.centre - axis.centre).norm();
    let x = 0.5 * (0.5 * journal_diameter + radius - 0.5 * pin_diameter);
    let c = (axis.radius - pin.radius) / radius;
    let half = if x <= axis.radius * c {
        (axis.radius * axis.radius - x * x).max(0.0).sqrt()
    } else if x >= radius + pin.radius * c {
        (pin.radius * pin.radius - (x - radius) * (x - radius)).max(0.0).sqrt()
    } else {
        (axis.radius - x * c) / ((1.0 - c) * (1.0 + c)).sqrt()
    };
    2.0 * half
}
