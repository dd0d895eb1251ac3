//! What to write in place of a unit that is not known. A suggestion never changes what the number says: it is the same unit
//! in its right spelling, or the number in another unit. Where neither is sure, the units are listed.

use super::decimal::decimal;
use super::number::scaled;
use super::unit::{Unit, canonical};
use super::{Dimension, Refusal};

/// What to do with a kinematic viscosity where a dynamic one is wanted.
pub(super) const KINEMATIC: &str = "a kinematic viscosity times the density is the dynamic one: 1 cSt at 850 kg/m3 is 0.85 mPa s; an engine file has `kinematic_viscosity` with `density` beside it";

/// Other spellings of the same unit, to be named in a hint; none is read.
const SPELLINGS: [(&str, &str); 37] = [
    ("°", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("u/min", "rpm"),
    ("tr/min", "rpm"),
    ("rps", "Hz"),
    ("rev/s", "Hz"),
    ("\"", "in"),
    ("inch", "in"),
    ("inches", "in"),
    ("'", "ft"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("mil", "thou"),
    ("lbs", "lb"),
    ("gram", "g"),
    ("grams", "g"),
    ("kilogram", "kg"),
    ("percent", "%"),
    ("g/cc", "g/cm3"),
    ("g/ml", "g/cm3"),
    ("t/m3", "g/cm3"),
    ("kg/l", "kg/dm3"),
    ("lbs/in3", "lb/in3"),
    ("lb/cu in", "lb/in3"),
    ("lb/cu ft", "lb/ft3"),
    ("C", "degC"),
    ("°C", "degC"),
    ("celsius", "degC"),
    ("F", "degF"),
    ("°F", "degF"),
    ("kelvin", "K"),
    ("J/(kg K)", "J/kg/K"),
    ("J/kgK", "J/kg/K"),
    ("kJ/(kg K)", "kJ/kg/K"),
];

/// Prefixes of the SI with their powers of ten.
const PREFIXES: [(&str, i32); 9] =
    [("n", -9), ("u", -6), ("m", -3), ("c", -2), ("d", -1), ("h", 2), ("k", 3), ("M", 6), ("G", 9)];

/// What to say of a unit that is not known.
pub(super) fn unknown_unit(number: &str, text: &str, dimension: Dimension, key: &str) -> Refusal {
    Refusal {
        code: "E0102",
        message: format!("`{key}` has the unknown unit \"{text}\""),
        label: "unknown unit".into(),
        hint: match suggestion(number, text, dimension) {
            _ if dimension == Dimension::Viscosity && is_kinematic(text) => KINEMATIC.into(),
            Some(quantity) => format!("write \"{quantity}\""),
            None => format!("{} is written in {}", dimension.with_article(), dimension.unit_list()),
        },
    }
}

/// Whether a unit is one of kinematic viscosity: a number in it says nothing without the density.
fn is_kinematic(text: &str) -> bool {
    ["cst", "st", "mm2/s", "mm\u{b2}/s", "m2/s", "m\u{b2}/s"].contains(&text.trim().to_lowercase().as_str())
}

/// The same quantity as it is read.
fn suggestion(number: &str, text: &str, dimension: Dimension) -> Option<String> {
    let spelled = SPELLINGS.iter().find(|(other, _)| other.eq_ignore_ascii_case(text)).map(|(_, name)| *name);
    if let Some(name) = spelled.filter(|name| dimension.units().any(|unit| unit.name == *name)) {
        return Some(format!("{number} {name}"));
    }
    let text = canonical(text);
    if let Some((unit, exponent)) = prefixed(&text, dimension) {
        let value = scaled(number, 0).filter(|value| value.is_finite())?;
        return Some(format!("{} {}", decimal(&format!("{value:e}"), exponent), unit.name));
    }
    let unit = only(dimension, |unit| is_respelled(&text, unit.name))
        .or_else(|| only(dimension, |unit| has_letters_swapped(&text, unit.name)))?;
    Some(format!("{number} {}", unit.name))
}

/// The one unit of the dimension that fits.
fn only(dimension: Dimension, fits: impl Fn(&Unit) -> bool) -> Option<&'static Unit> {
    let mut found = dimension.units().filter(|unit| fits(unit));
    found.next().filter(|_| found.next().is_none())
}

/// A unit behind a prefix of the SI, and the power of ten between them: 1 hPa is 10^2 Pa, 1 dm2 is 10^-2 m2.
fn prefixed(text: &str, dimension: Dimension) -> Option<(&'static Unit, i32)> {
    PREFIXES.iter().find_map(|(prefix, exponent)| {
        let rest = text.strip_prefix(prefix)?;
        let unit = dimension.units().find(|unit| unit.name == rest)?;
        let first = unit.name.split([' ', '/']).next().unwrap_or("");
        let power = first.chars().last().and_then(|last| last.to_digit(10)).unwrap_or(1);
        Some((unit, exponent * power as i32))
    })
}

/// Whether a unit is the text but for blanks, hyphens and capitals; small m and capital M of a prefix are not alike.
fn is_respelled(text: &str, name: &str) -> bool {
    let plain = |text: &str| text.replace([' ', '-'], "").to_lowercase();
    plain(text) == plain(name) && !(name.starts_with('M') && text.starts_with('m'))
}

/// Whether the letters of a unit are those of the text in another order: "rmp".
fn has_letters_swapped(text: &str, name: &str) -> bool {
    let sorted = |text: &str| {
        let mut letters: Vec<char> = text.chars().collect();
        letters.sort_unstable();
        letters
    };
    sorted(text) == sorted(name)
}
