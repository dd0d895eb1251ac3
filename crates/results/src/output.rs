//! An output in words, and words as an output.

use crate::quantity::{Parts, Quantity};
use lanchester_units::nearest;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Highest order: loads of higher ones are nothing but rounding.
pub const LARGEST_ORDER: f64 = 1000.0;

/// Largest denominator of an order that is written as a fraction.
const LARGEST_DENOMINATOR: u32 = 64;

/// Which way a load turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// With the crank: of order 1 a weight on the crank removes it.
    Forward,
    /// Against the crank.
    Backward,
}

/// An axis across the crank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Up.
    X,
    /// Across.
    Y,
}

/// Of which part.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// Of the engine; of parts, of whichever the one who asks takes: all together or the one with the largest.
    Any,
    /// Of the part with the largest.
    Largest,
    /// Of the part of this number, from 1.
    Number(usize),
    /// Of the part of this name.
    Named(String),
}

/// Which number of a quantity over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Size {
    /// Largest amount; of what does not run over the cycle the amount itself.
    Peak,
    /// Mean over the cycle.
    Mean,
    /// Root mean square over the cycle.
    Rms,
    /// Amount of one order [cycles per revolution of crankshaft 1].
    Order(f64),
}

/// Which loads count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Counted {
    /// Those that the one who asks takes where nothing is said.
    Usual,
    /// Inertia alone.
    Inertia,
    /// Gas alone.
    Gas,
    /// Inertia and gas.
    All,
}

/// A number of an engine: `[gas|inertia] [forward|backward] [largest] QUANTITY [x|y] [number or name] [order N|mean|rms] [with gas]`.
///
/// [`fmt::Display`] writes what [`FromStr`] reads; [`Output::title`] is for tables.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Output {
    /// Of what.
    pub quantity: Quantity,
    /// Along which axis; `None` for the resultant, or where there are none.
    pub axis: Option<Axis>,
    /// Of which part.
    pub place: Place,
    /// Which number of it.
    pub size: Size,
    /// Which way it turns; `None` for both together.
    pub sense: Option<Sense>,
    /// Which loads count.
    pub counted: Counted,
}

/// Why a text is no output.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OutputError {
    /// No quantity has this name.
    #[error("there is no quantity \"{got}\"")]
    Unknown {
        /// The text, shortened.
        got: String,
        /// The name that comes nearest.
        nearest: Option<&'static str>,
    },
    /// The order is no number from 0, exclusive, to [`LARGEST_ORDER`].
    #[error("an order is a number above 0 and up to 1000, such as 2, 0.5 or 1/2, got \"{got}\"")]
    Order {
        /// What stands there.
        got: String,
    },
    /// A part of this kind goes by a whole number from 1 on.
    #[error("a {of} goes by its number from 1 on, got \"{got}\"")]
    Number {
        /// The quantity.
        of: &'static str,
        /// What stands there.
        got: String,
    },
    /// It does not run over the cycle: it has no mean, no root mean square and no orders.
    #[error("{of} is one number of the cycle: it has no mean, no rms and no orders")]
    Size {
        /// The quantity.
        of: &'static str,
    },
    /// What follows the quantity says nothing of it.
    #[error("\"{got}\" says nothing of {of}")]
    Rest {
        /// The quantity.
        of: &'static str,
        /// What follows it.
        got: String,
    },
}

impl Output {
    /// The peak of a quantity: the resultant, of any part, both senses, the usual loads.
    pub fn of(quantity: Quantity) -> Output {
        let (axis, place, size) = (None, Place::Any, Size::Peak);
        Output { quantity, axis, place, size, sense: None, counted: Counted::Usual }
    }

    /// The same of one order.
    pub fn order(self, order: f64) -> Output {
        Output { size: Size::Order(order), ..self }
    }

    /// The same in one sense.
    pub fn turning(self, sense: Sense) -> Output {
        Output { sense: Some(sense), ..self }
    }

    /// The same of certain loads.
    pub fn counting(self, counted: Counted) -> Output {
        Output { counted, ..self }
    }

    /// Its SI unit; empty for a plain number.
    pub fn unit(&self) -> &'static str {
        self.quantity.unit()
    }

    /// Name for tables: `forward force of order 1`, `mean torque`, `mount force front`.
    pub fn title(&self) -> String {
        let mut words = vec![];
        match self.size {
            Size::Mean => words.push("mean".to_owned()),
            Size::Rms => words.push("rms".to_owned()),
            Size::Peak | Size::Order(_) => {}
        }
        match self.counted {
            Counted::Inertia => words.push("inertia".to_owned()),
            Counted::Gas => words.push("gas".to_owned()),
            Counted::Usual | Counted::All => {}
        }
        words.extend(self.sense.map(|sense| sense.name().to_owned()));
        if self.place == Place::Largest {
            words.push("largest".to_owned());
        }
        words.push(self.quantity.title().to_owned());
        words.extend(self.axis.map(|axis| axis.name().to_owned()));
        words.extend(self.place_name());
        if let Size::Order(order) = self.size {
            words.push(format!("of order {}", order_text(order)));
        }
        if self.counted == Counted::All {
            words.push("with gas".to_owned());
        }
        words.join(" ")
    }

    /// As [`Output::title`], with `peak` where nothing else says which number over the cycle it is: `peak force`.
    pub fn sized_title(&self) -> String {
        match self.size == Size::Peak && self.quantity.is_over_cycle() {
            true => format!("peak {}", self.title()),
            false => self.title(),
        }
    }

    fn place_name(&self) -> Option<String> {
        match &self.place {
            Place::Any | Place::Largest => None,
            Place::Number(number) => Some(number.to_string()),
            Place::Named(name) => Some(name.clone()),
        }
    }
}

impl Sense {
    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Sense::Forward => "forward",
            Sense::Backward => "backward",
        }
    }
}

impl Axis {
    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
        }
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.counted {
            Counted::Inertia => f.write_str("inertia ")?,
            Counted::Gas => f.write_str("gas ")?,
            Counted::Usual | Counted::All => {}
        }
        if let Some(sense) = self.sense {
            write!(f, "{} ", sense.name())?;
        }
        if self.place == Place::Largest {
            f.write_str("largest ")?;
        }
        f.write_str(self.quantity.name())?;
        if let Some(axis) = self.axis {
            write!(f, " {}", axis.name())?;
        }
        if let Some(place) = self.place_name() {
            write!(f, " {place}")?;
        }
        match self.size {
            Size::Peak => {}
            Size::Mean => f.write_str(" mean")?,
            Size::Rms => f.write_str(" rms")?,
            Size::Order(order) => write!(f, " order {}", order_text(order))?,
        }
        match self.counted {
            Counted::All => f.write_str(" with gas"),
            Counted::Usual | Counted::Inertia | Counted::Gas => Ok(()),
        }
    }
}

/// Takes a word with the space behind it from the front of a text.
fn take<T: Copy>(text: &mut &str, words: &[(&str, T)]) -> Option<T> {
    let (rest, found) = words.iter().find_map(|(word, value)| Some((after(text, word)?, *value)))?;
    *text = rest;
    Some(found)
}

fn after<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    text.strip_prefix(word)?.strip_prefix(' ')
}

fn before<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    match text.strip_suffix(word)? {
        "" => Some(""),
        rest => rest.strip_suffix(' '),
    }
}

fn short(text: &str) -> String {
    text.chars().take(60).collect()
}

impl FromStr for Output {
    type Err = OutputError;

    /// Reads what [`Output`] describes; spaces count once, `of order` is `order`, and `peak` may stand before the quantity.
    fn from_str(text: &str) -> Result<Output, OutputError> {
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let mut front = words.as_str();
        let part = take(&mut front, &[("gas", Counted::Gas), ("inertia", Counted::Inertia)]);
        let sense = take(&mut front, &[("forward", Sense::Forward), ("backward", Sense::Backward)]);
        let before_quantity =
            take(&mut front, &[("peak", Size::Peak), ("mean", Size::Mean), ("rms", Size::Rms)]);
        let largest = take(&mut front, &[("largest", ()), ("any", ())]).is_some();
        let Some((quantity, mut rest)) = Quantity::starting(front) else {
            let names = Quantity::all().map(Quantity::name);
            return Err(OutputError::Unknown { got: short(&words), nearest: nearest(front, names) });
        };
        let strange = |got: &str| OutputError::Rest { of: quantity.name(), got: short(got) };
        let whole = rest;
        let with_gas = before(rest, "with gas");
        rest = with_gas.unwrap_or(rest);
        let counted = match (part, with_gas.is_some()) {
            (Some(_), true) => return Err(strange(whole)),
            (Some(part), false) => part,
            (None, true) => Counted::All,
            (None, false) => Counted::Usual,
        };
        let mut size = before_quantity;
        let mut said = |new: Size| if size.replace(new).is_some() { Err(strange(whole)) } else { Ok(()) };
        if let Some(earlier) = before(rest, "mean") {
            said(Size::Mean)?;
            rest = earlier;
        } else if let Some(earlier) = before(rest, "rms") {
            said(Size::Rms)?;
            rest = earlier;
        } else if let Some((earlier, number)) = split_order(rest) {
            said(Size::Order(read_order(number)?))?;
            rest = earlier;
        }
        let size = size.unwrap_or(Size::Peak);
        if size != Size::Peak && !quantity.is_over_cycle() {
            return Err(OutputError::Size { of: quantity.name() });
        }
        if sense.is_some() && !(quantity.turns() && matches!(size, Size::Order(_))) {
            return Err(strange(&words));
        }
        let axis = match (quantity.parts(), rest) {
            (Parts::Axes, "x") => Some(Axis::X),
            (Parts::Axes, "y") => Some(Axis::Y),
            _ => None,
        };
        if axis.is_some() {
            rest = "";
        }
        let place = match (quantity.parts(), rest) {
            (Parts::Numbered | Parts::Mounts, "") if largest && !quantity.more_is_better() => Place::Largest,
            (_, _) if largest => return Err(strange(&words)),
            (_, "") => Place::Any,
            (Parts::Numbered, number) => match number.parse::<usize>() {
                Ok(number @ 1..) => Place::Number(number),
                _ => return Err(OutputError::Number { of: quantity.name(), got: short(number) }),
            },
            (Parts::Mounts, name) => Place::Named(name.to_owned()),
            (Parts::Engine | Parts::Axes, rest) => return Err(strange(rest)),
        };
        Ok(Output { quantity, axis, place, size, sense, counted })
    }
}

/// What stands before `order N` or `of order N`, and N.
fn split_order(text: &str) -> Option<(&str, &str)> {
    let (earlier, number) = match text.strip_prefix("order ") {
        Some(number) if !number.contains("order ") => ("", number),
        _ => text.rsplit_once(" order ").or_else(|| Some(("", text.strip_prefix("order ")?)))?,
    };
    Some((before(earlier, "of").unwrap_or(earlier), number))
}

/// `2`, `0.5` or `1/2`.
fn read_order(text: &str) -> Result<f64, OutputError> {
    let number = |text: &str| {
        let plain = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
        text.parse::<f64>().ok().filter(|_| plain)
    };
    let order = match text.split_once('/') {
        Some((above, below)) => number(above.trim()).zip(number(below.trim())).map(|(a, b)| a / b),
        None => number(text),
    };
    let order = order.filter(|order| order.is_finite() && *order > 0.0 && *order <= LARGEST_ORDER);
    order.ok_or_else(|| OutputError::Order { got: short(text) })
}

/// An order as people write it: `2`, `0.5`; a fraction, `2/3`, where three decimals do not say it all.
pub fn order_text(order: f64) -> String {
    if (1e3 * order).fract() == 0.0 {
        return format!("{order}");
    }
    let fraction = (1..=LARGEST_DENOMINATOR).find_map(|denominator| {
        let numerator = (order * f64::from(denominator)).round();
        (numerator / f64::from(denominator) == order).then_some((numerator, denominator))
    });
    match fraction {
        Some((numerator, denominator)) => format!("{numerator}/{denominator}"),
        None => format!("{order}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> Output {
        text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    #[test]
    fn the_four_ways_of_speaking_are_one() {
        let force = Output::of(Quantity::Force);
        assert_eq!(read("force"), force);
        assert_eq!(read("peak force"), force);
        for text in ["force order 2", "force  of  order 2", "force order 4/2"] {
            assert_eq!(read(text), force.clone().order(2.0), "{text}");
        }
        assert_eq!(read("backward force order 1"), force.order(1.0).turning(Sense::Backward));
        let main = Output { place: Place::Number(2), ..Output::of(Quantity::MainBearingLoad) };
        for text in ["main-bearing load 2", "main bearing 2", "main bearing load 2", "main load 2"] {
            assert_eq!(read(text), main, "{text}");
        }
        let rms = Output { size: Size::Rms, counted: Counted::All, ..main };
        assert_eq!(read("main-bearing load 2 rms with gas"), rms);
        assert_eq!(read("largest main-bearing load rms").place, Place::Largest);
        assert_eq!(read("inertia torque order 1").counted, Counted::Inertia);
        assert_eq!(read("torque mean"), read("mean torque"));
        assert_eq!(read("firing order 1.5").size, Size::Order(1.5));
        assert_eq!(read("couple x").axis, Some(Axis::X));
        assert_eq!(read("mount force front left order 2").place, Place::Named("front left".into()));
    }

    #[test]
    fn what_should_be_large_goes_by_its_smallest_part() {
        assert_eq!(read("least film"), Output::of(Quantity::LeastFilm));
        let third = Output { place: Place::Number(3), ..Output::of(Quantity::MainFilm) };
        for text in ["main-bearing film 3", "main bearing film 3", "least main-bearing film 3", "main film 3"]
        {
            assert_eq!(read(text), third, "{text}");
        }
        assert_eq!(third.unit(), "m");
        assert_eq!(read("big-end film 2").to_string(), "crankpin film 2");
        assert_eq!(read("rule safety 1").title(), "safety after UR M53 1");
        assert!(Quantity::all().filter(|quantity| quantity.more_is_better()).all(|q| !q.is_over_cycle()));
        for text in ["largest main-bearing film", "fillet safety 2", "least film 1"] {
            assert!(matches!(text.parse::<Output>(), Err(OutputError::Rest { .. })), "{text}");
        }
        assert!(matches!("crankpin film order 1".parse::<Output>(), Err(OutputError::Size { .. })));
    }

    #[test]
    fn what_says_nothing_is_refused_with_its_reason() {
        let refused = |text: &str| text.parse::<Output>().expect_err(text);
        assert!(matches!(refused("forse"), OutputError::Unknown { nearest: Some("force"), .. }));
        assert!(matches!(refused(""), OutputError::Unknown { .. }));
        for text in [
            "force order 0",
            "force order -1",
            "force order 1e3",
            "force order 1/0",
            "force order",
            "force order 1001",
        ] {
            let error = refused(text);
            assert!(matches!(error, OutputError::Order { .. } | OutputError::Rest { .. }), "{text}: {error}");
        }
        for text in [
            "force z",
            "forward torque order 1",
            "forward force",
            "largest force",
            "gas torque with gas",
            "mean torque rms",
            "cost 3",
        ] {
            assert!(matches!(refused(text), OutputError::Rest { .. }), "{text}: {}", refused(text));
        }
        for text in ["main-bearing load 0", "crankpin two", "side thrust -1"] {
            assert!(matches!(refused(text), OutputError::Number { .. }), "{text}: {}", refused(text));
        }
        for text in ["length order 1", "added mass rms", "mean excess energy"] {
            assert!(matches!(refused(text), OutputError::Size { .. }), "{text}: {}", refused(text));
        }
    }

    #[test]
    fn titles_are_for_people() {
        for (text, title) in [
            ("force", "force"),
            ("forward force order 1", "forward force of order 1"),
            ("gas torque order 1/2", "gas torque of order 0.5"),
            ("gas torque mean", "mean gas torque"),
            ("torque order 1/3", "torque of order 1/3"),
            ("main-bearing load 3 rms", "rms main-bearing load 3"),
            ("uneven firing", "unevenness of firing"),
            ("firing order 1.5", "firing harmonic of order 1.5"),
            ("mount force rear with gas", "mount force rear with gas"),
        ] {
            assert_eq!(read(text).title(), title);
        }
    }

    fn outputs() -> impl Strategy<Value = Output> {
        let quantity = proptest::sample::select(Quantity::all().collect::<Vec<_>>());
        let size = prop_oneof![
            Just(Size::Peak),
            Just(Size::Mean),
            Just(Size::Rms),
            (1u32..1001, 1u32..65)
                .prop_map(|(above, below)| Size::Order(f64::from(above) / f64::from(below))),
        ];
        let counted =
            proptest::sample::select(vec![Counted::Usual, Counted::Inertia, Counted::Gas, Counted::All]);
        (quantity, size, counted, 0usize..9, any::<bool>(), "[a-z]{1,6}( [a-z]{1,6})?").prop_map(
            |(quantity, size, counted, number, forward, name)| {
                let mut output = Output { counted, ..Output::of(quantity) };
                if quantity.is_over_cycle() {
                    output.size = size;
                }
                if quantity.turns() && matches!(output.size, Size::Order(_)) && number % 2 == 1 {
                    output.sense = Some(if forward { Sense::Forward } else { Sense::Backward });
                }
                match quantity.parts() {
                    Parts::Axes if number > 5 => output.axis = Some(if forward { Axis::X } else { Axis::Y }),
                    Parts::Numbered | Parts::Mounts if number == 0 && !quantity.more_is_better() => {
                        output.place = Place::Largest;
                    }
                    Parts::Numbered if forward && number > 0 => output.place = Place::Number(number),
                    Parts::Mounts if forward => output.place = Place::Named(name),
                    _ => {}
                }
                output
            },
        )
    }

    proptest! {
        #[test]
        fn prop_every_output_is_read_as_it_is_written(output in outputs()) {
            // Names that end like a size or begin like nothing else would be read as such: they are words of the vocabulary.
            let words = ["mean", "rms", "order", "of", "gas"];
            let clear = match &output.place {
                Place::Named(name) => !name.split(' ').any(|word| words.contains(&word)),
                _ => true,
            };
            prop_assume!(clear);
            let text = output.to_string();
            prop_assert_eq!(text.parse::<Output>(), Ok(output), "{}", text);
        }

        #[test]
        fn prop_no_text_panics(text in ".{0,40}") {
            let _ = text.parse::<Output>();
        }
    }
}
