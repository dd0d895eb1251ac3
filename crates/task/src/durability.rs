//! How long crankshaft and bearings live, as criteria: oil films and safeties, of which more is better.
//!
//! They need more than the closed form: films of `film`, formulas of `strength`, finite elements of `flex`. Whoever knows these gives their
//! numbers through [`DurabilityMeter`]; balancing and studies know the trait alone. None of them is convex in the weights of an engine.

use lanchester_model::Engine;
use lanchester_results::{Counted, Output, Place, Quantity, Size};
use lanchester_units::{BadQuantity, Dimension, nearest, parse};
use serde::{Deserialize, Serialize};

/// A number of which more is better: the smallest over the cycle, the parts and the speeds that count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DurabilityCriterion {
    /// Smallest oil film of all main and big-end bearings [m].
    LeastFilm,
    /// Smallest oil film of one main bearing, by index as in [`lanchester_model::EngineParts::main_bearings`], or of all [m].
    MainFilm(Option<usize>),
    /// Smallest oil film of the big-end bearing of one cylinder, by index, or of all [m].
    CrankpinFilm(Option<usize>),
    /// Smallest safety by the formulas after IACS UR M53 of one throw, by index, or of all [1]. Forces of pistons and rods count, what turns with the
    /// crankshaft does not: counterweights do not change it.
    RuleSafety(Option<usize>),
    /// Smallest safety against fatigue of the fillets of crankshaft 1 by finite elements [1].
    FilletSafety,
}

/// Why a criterion has no number.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Unmeasured {
    /// What is missing or cannot be computed.
    pub reason: String,
    /// What would give it.
    pub remedy: String,
}

/// A criterion of an engine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Measured {
    /// It is known.
    Known {
        /// In the unit of the criterion.
        value: f64,
        /// Which part has it: "main bearing 3", "pin 2 at web 3".
        place: String,
        /// At which speed of crankshaft 1 [rad/s].
        speed: f64,
        /// What it leaves out, and why; empty: nothing that others count.
        #[serde(default, skip_serializing_if = "String::is_empty")]
        left_out: String,
    },
    /// It is not: never 0.
    Unknown(Unmeasured),
}

impl Measured {
    /// The number, if there is one.
    pub fn value(&self) -> Option<f64> {
        match self {
            Measured::Known { value, .. } => Some(*value),
            Measured::Unknown(_) => None,
        }
    }

    /// The smaller of two; what is not known comes first, since nobody knows how small it is.
    pub fn smaller(self, other: Measured) -> Measured {
        match (&self, &other) {
            (Measured::Unknown(_), _) => self,
            (_, Measured::Unknown(_)) => other,
            (Measured::Known { value: a, .. }, Measured::Known { value: b, .. }) => {
                if b < a {
                    other
                } else {
                    self
                }
            }
        }
    }
}

/// Whoever can tell criteria of durability of an engine.
pub trait DurabilityMeter: Sync {
    /// These criteria of `engine`, in their order. The engine as a whole is given: with its weights, at its speeds.
    fn measure(&self, engine: &Engine, criteria: &[DurabilityCriterion]) -> Vec<Measured>;
}

/// A criterion that must not fall below a value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct AtLeast {
    /// What.
    pub criterion: DurabilityCriterion,
    /// Smallest value, in the criterion's SI unit.
    pub least: f64,
}

/// Films and safeties that balancing is to care for.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct DurabilityWish {
    /// What is to be large, in order of priority.
    pub maximise: Vec<DurabilityCriterion>,
    /// What must hold.
    pub at_least: Vec<AtLeast>,
}

impl DurabilityWish {
    /// Whether nothing is wished for.
    pub fn is_empty(&self) -> bool {
        self.maximise.is_empty() && self.at_least.is_empty()
    }

    /// All that it names: first what is to be large, then what must hold.
    pub fn criteria(&self) -> Vec<DurabilityCriterion> {
        self.maximise.iter().copied().chain(self.at_least.iter().map(|one| one.criterion)).collect()
    }
}

impl DurabilityCriterion {
    /// Those of the whole engine.
    pub const WHOLE: [DurabilityCriterion; 5] = [
        DurabilityCriterion::LeastFilm,
        DurabilityCriterion::MainFilm(None),
        DurabilityCriterion::CrankpinFilm(None),
        DurabilityCriterion::RuleSafety(None),
        DurabilityCriterion::FilletSafety,
    ];

    /// What it is in the words of all studies.
    pub fn output(self) -> Output {
        let numbered = |quantity, index: Option<usize>| Output {
            place: index.map_or(Place::Any, |index| Place::Number(index + 1)),
            ..Output::of(quantity)
        };
        match self {
            DurabilityCriterion::LeastFilm => Output::of(Quantity::LeastFilm),
            DurabilityCriterion::MainFilm(index) => numbered(Quantity::MainFilm, index),
            DurabilityCriterion::CrankpinFilm(index) => numbered(Quantity::CrankpinFilm, index),
            DurabilityCriterion::RuleSafety(index) => numbered(Quantity::RuleSafety, index),
            DurabilityCriterion::FilletSafety => Output::of(Quantity::FilletSafety),
        }
    }

    /// The criterion that an output is, if it is one.
    pub fn of(output: &Output) -> Option<DurabilityCriterion> {
        if output.counted != Counted::Usual || output.size != Size::Peak {
            return None;
        }
        let index = match output.place {
            Place::Number(number) => Some(number.checked_sub(1)?),
            Place::Any => None,
            Place::Largest | Place::Named(_) => return None,
        };
        Some(match output.quantity {
            Quantity::LeastFilm => DurabilityCriterion::LeastFilm,
            Quantity::MainFilm => DurabilityCriterion::MainFilm(index),
            Quantity::CrankpinFilm => DurabilityCriterion::CrankpinFilm(index),
            Quantity::RuleSafety => DurabilityCriterion::RuleSafety(index),
            Quantity::FilletSafety => DurabilityCriterion::FilletSafety,
            _ => return None,
        })
    }

    /// As files and command lines call it.
    pub fn name(self) -> String {
        self.output().to_string()
    }

    /// Name for tables.
    pub fn title(self) -> String {
        self.output().title()
    }

    /// Its SI unit; empty for a plain number.
    pub fn unit(self) -> &'static str {
        self.output().unit()
    }

    /// Whether it is about oil films.
    pub fn is_film(self) -> bool {
        self.unit() == "m"
    }

    /// Whether unbalances on the crankshaft change it: not the force of a rod on its pin, nor what follows from it alone, but that of their inertia on torsional vibration.
    pub fn depends_on_unbalances(self) -> bool {
        !matches!(self, DurabilityCriterion::CrankpinFilm(_) | DurabilityCriterion::RuleSafety(_))
    }

    /// Reads a criterion of an engine, such as "least film", "main-bearing film 3" or "rule safety".
    ///
    /// # Errors
    /// [`BadQuantity`] if there is no such criterion, or the engine has no such part.
    pub fn read(text: &str, engine: &Engine) -> Result<DurabilityCriterion, BadQuantity> {
        let criterion = DurabilityCriterion::named(text)?;
        criterion.check(engine)?;
        Ok(criterion)
    }

    /// As [`DurabilityCriterion::read`], of any engine.
    ///
    /// # Errors
    /// [`BadQuantity`] if there is no such criterion.
    pub fn named(text: &str) -> Result<DurabilityCriterion, BadQuantity> {
        let text = text.trim();
        let short: String = text.chars().take(60).collect();
        let found = text.parse::<Output>().ok().and_then(|output| DurabilityCriterion::of(&output));
        found.ok_or_else(|| {
            let names: Vec<String> = DurabilityCriterion::WHOLE.iter().map(|one| one.name()).collect();
            let hint = match nearest(text, names.iter().map(String::as_str)) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None => format!("there are \"{}\"", names.join("\", \"")),
            };
            BadQuantity { message: format!("there is no film and no safety \"{short}\""), hint }
        })
    }

    /// Refuses a part that the engine does not have.
    ///
    /// # Errors
    /// [`BadQuantity`] with the number of those that it has.
    pub fn check(self, engine: &Engine) -> Result<(), BadQuantity> {
        let (index, count, what) = match self {
            DurabilityCriterion::MainFilm(Some(index)) => {
                (index, engine.main_bearings().len(), "main bearing")
            }
            DurabilityCriterion::CrankpinFilm(Some(index)) => (index, engine.cylinders.len(), "cylinder"),
            DurabilityCriterion::RuleSafety(Some(index)) => (index, engine.throws.len(), "throw"),
            _ => return Ok(()),
        };
        if index < count {
            return Ok(());
        }
        let hint = match count {
            0 => format!("leave it out: the engine has no {what}"),
            1 => format!("there is {what} 1"),
            _ => format!("there are {what}s 1 to {count}"),
        };
        Err(BadQuantity { message: format!("there is no {what} {}", index + 1), hint })
    }

    /// A value of it from text: a length with its unit, or a plain number.
    ///
    /// # Errors
    /// [`BadQuantity`] if it is none, or not above 0.
    pub fn amount(self, text: &str) -> Result<f64, BadQuantity> {
        let text = text.trim();
        let value = match self.is_film() {
            true => parse(text, Dimension::Length, &self.name()).map_err(BadQuantity::from)?,
            false => {
                text.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| BadQuantity {
                    message: format!("\"{}\" needs a plain number, got \"{text}\"", self.name()),
                    hint: "write it like 1.3".into(),
                })?
            }
        };
        if value > 0.0 {
            return Ok(value);
        }
        Err(BadQuantity {
            message: format!("the smallest \"{}\" must be above 0, got {text}", self.name()),
            hint: match self.is_film() {
                true => "write it like 2 um".into(),
                false => "write it like 1.3".into(),
            },
        })
    }
}

impl AtLeast {
    /// Reads "least film = 2 um" or "rule safety = 1.3"; `option` names what asks for it in the message.
    ///
    /// # Errors
    /// [`BadQuantity`] if it is no criterion of the engine, an equals sign and a value above 0.
    pub fn read(text: &str, engine: &Engine, option: &str) -> Result<AtLeast, BadQuantity> {
        let Some((name, value)) = text.rsplit_once('=') else {
            return Err(BadQuantity {
                message: format!("`{option}` needs a film or safety and its smallest value, got \"{text}\""),
                hint: format!("for example {option} \"least film = 2 um\" or {option} \"rule safety = 1.3\""),
            });
        };
        let criterion = DurabilityCriterion::read(name, engine)?;
        Ok(AtLeast { criterion, least: criterion.amount(value)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn four() -> Engine {
        let text = lanchester_file::template("in-line-4").expect("it is in the gallery").text;
        lanchester_file::read(text).engine().expect("no mistakes")
    }

    #[test]
    fn criteria_are_read_as_they_are_written() {
        let numbered = [
            DurabilityCriterion::MainFilm(Some(2)),
            DurabilityCriterion::CrankpinFilm(Some(3)),
            DurabilityCriterion::RuleSafety(Some(0)),
        ];
        for criterion in DurabilityCriterion::WHOLE.into_iter().chain(numbered) {
            assert_eq!(DurabilityCriterion::read(&criterion.name(), &four()), Ok(criterion));
        }
        assert_eq!(
            AtLeast::read("main-bearing film 3 = 2.5 um", &four(), "at least"),
            Ok(AtLeast { criterion: numbered[0], least: 2.5e-6 })
        );
        assert_eq!(AtLeast::read("rule safety=1.3", &four(), "at least").map(|one| one.least), Ok(1.3));
    }

    #[test]
    fn what_is_none_is_refused_with_what_there_is() {
        let refused = |text: &str| AtLeast::read(text, &four(), "at least").expect_err(text);
        assert!(refused("main-bearing film 6 = 1 um").hint.contains("1 to 5"));
        assert!(refused("crankpin film 5 = 1 um").hint.contains("cylinders 1 to 4"));
        assert!(refused("leest film = 1 um").hint.contains("least film"));
        assert!(refused("force = 1 N").message.contains("no film and no safety"));
        for text in
            ["least film = 1", "least film = 0 um", "rule safety = 1.3 um", "rule safety = 0", "least film"]
        {
            assert!(!refused(text).hint.is_empty(), "{text}");
        }
    }

    #[test]
    fn what_is_not_known_is_never_the_larger_one() {
        let known =
            |value| Measured::Known { value, place: String::new(), speed: 1.0, left_out: String::new() };
        let unknown = || Measured::Unknown(Unmeasured { reason: "no oil".into(), remedy: "give it".into() });
        assert_eq!(known(2.0).smaller(known(1.0)).value(), Some(1.0));
        assert_eq!(known(2.0).smaller(unknown()).value(), None);
        assert_eq!(unknown().smaller(known(2.0)).value(), None);
    }
}
