//! Quantities at the door: `"79.5 mm"` to SI and back.
//!
//! A power of ten is applied to the decimal text before it becomes a binary number, so `"144 mm"` and `"0.144 m"`
//! are the same number, and writing back in millimetres or grams loses nothing.

mod decimal;
mod number;
mod range;
mod refusal;
mod rewrite;
mod suggestion;
mod unit;
mod word_list;

pub use range::{Bound, LARGEST, SMALLEST, within};
pub use refusal::Refusal;
pub use rewrite::rewritten;
pub use unit::{ALIASES, Dimension};
pub use word_list::one_of;

use decimal::decimal;
use number::{misspelled, scaled, split};
use suggestion::unknown_unit;
use unit::{UNITS, Unit, find_unit};

/// The quantity in SI, or why it is none.
///
/// `key` names what asks for it, in messages.
pub fn parse(text: &str, dimension: Dimension, key: &str) -> Result<f64, Refusal> {
    let trimmed = text.trim();
    let (number, unit_text) = split(trimmed);
    if !number.contains(|c: char| c.is_ascii_digit()) {
        return Err(no_number(trimmed, dimension, key));
    }
    if let Some(refusal) = misspelled(number, unit_text, dimension) {
        return Err(refusal);
    }
    if unit_text.is_empty() {
        return Err(missing_unit(number, dimension, key));
    }
    let Some(unit) = find_unit(unit_text) else {
        return Err(unknown_unit(number, unit_text, dimension, key));
    };
    if unit.dimension != dimension {
        return Err(Refusal {
            code: "E0103",
            message: format!(
                "`{key}` needs {}, got {}",
                dimension.with_article(),
                unit.dimension.with_article()
            ),
            label: format!("{} is a unit of {}", unit.name, unit.dimension.name()),
            hint: match (dimension, unit.dimension) {
                (Dimension::Viscosity, Dimension::KinematicViscosity) => suggestion::KINEMATIC.into(),
                _ => format!("write it in {}", dimension.unit_list()),
            },
        });
    }
    match scaled(number, unit.exponent).map(|value| value * unit.factor + unit.zero) {
        Some(value) if value.is_finite() => Ok(value),
        _ => Err(not_finite(key)),
    }
}

/// What to say of a bare number where a unit is due.
pub fn missing_unit(number: &str, dimension: Dimension, key: &str) -> Refusal {
    let first = dimension.units().next().map_or("", |unit| unit.name);
    let units = dimension.unit_list();
    Refusal {
        code: "E0101",
        message: format!(
            "`{key}` needs {} with its unit, got the bare number {number}",
            dimension.with_article()
        ),
        label: "unit missing".into(),
        hint: format!("write \"{number} {first}\", or another of {units}"),
    }
}

/// What to say of `inf`, `nan` and numbers beyond the range of a double.
pub fn not_finite(key: &str) -> Refusal {
    Refusal {
        code: "E0106",
        message: format!("`{key}` is not finite"),
        label: "not a finite number".into(),
        hint: "give the value itself".into(),
    }
}

fn no_number(text: &str, dimension: Dimension, key: &str) -> Refusal {
    let word = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if ["inf", "nan", "infinity"].iter().any(|not| word.starts_with(not)) {
        return not_finite(key);
    }
    let first = dimension.units().next().map_or("", |unit| unit.name);
    let (message, label) = if text.is_empty() {
        (format!("`{key}` needs {} with its unit, got an empty text", dimension.with_article()), "empty")
    } else {
        (format!("`{key}` needs {} with its unit, got no number", dimension.with_article()), "no number here")
    };
    Refusal {
        code: "E0105",
        message,
        label: label.into(),
        hint: if text.starts_with(['−', '–']) {
            "write the minus sign as \"-\"".into()
        } else {
            format!("write a number and a unit, such as \"1.5 {first}\"")
        },
    }
}

/// `value` [SI] as text that [`parse`] reads back into the same double, in the unit that reads best.
pub fn exact_text(value: f64, dimension: Dimension) -> String {
    text_that(value, dimension, |read| read == value)
}

/// Doubles to either side of a guess that [`text_that`] tries.
const NEIGHBOURS: usize = 8;

/// Text of a value at or next to `guess` [SI] that reads back as one that `fits`, in the unit that reads best; the
/// text of the guess itself if none does.
pub fn text_that(guess: f64, dimension: Dimension, fits: impl Fn(f64) -> bool) -> String {
    let (nice, plain) = match dimension {
        Dimension::Length => ("mm", "m"),
        Dimension::Mass => ("kg", "kg"),
        Dimension::Angle => ("deg", "rad"),
        Dimension::Speed => ("rpm", "rad/s"),
        Dimension::Unbalance => ("kg m", "kg m"),
        Dimension::Inertia => ("kg mm2", "kg m2"),
        Dimension::Share => ("%", "%"),
        Dimension::Force => ("N", "N"),
        // Strengths and moduli: no gas has such a pressure.
        Dimension::Pressure if guess.abs() >= 1e8 => ("MPa", "Pa"),
        Dimension::Pressure => ("bar", "Pa"),
        Dimension::Torque => ("N m", "N m"),
        Dimension::Density => ("kg/m3", "kg/m3"),
        Dimension::Velocity => ("mm/s", "m/s"),
        Dimension::Acceleration => ("m/s2", "m/s2"),
        Dimension::Area => ("mm2", "m2"),
        Dimension::Temperature => ("K", "K"),
        Dimension::Energy => ("J", "J"),
        Dimension::SpecificEnergy => ("MJ/kg", "J/kg"),
        Dimension::SpecificHeat => ("J/kg/K", "J/kg/K"),
        Dimension::HeatTransfer => ("W/m2/K", "W/m2/K"),
        Dimension::ThermalConductance => ("W/K", "W/K"),
        Dimension::HeatCapacity => ("kJ/K", "J/K"),
        Dimension::Stiffness => ("N/mm", "N/m"),
        Dimension::Damping => ("N s/m", "N s/m"),
        Dimension::PressurePerSpeed => ("bar s/m", "Pa s/m"),
        Dimension::PressurePerSpeedSquared => ("bar s2/m2", "Pa s2/m2"),
        Dimension::Time => ("s", "s"),
        Dimension::Power => ("kW", "W"),
        Dimension::AngularStiffness => ("N m/rad", "N m/rad"),
        Dimension::AngularDamping => ("N m s/rad", "N m s/rad"),
        Dimension::PerSpeed => ("1/rpm", "s/rad"),
        Dimension::Rate => ("1/s", "1/s"),
        Dimension::Viscosity => ("mPa s", "Pa s"),
        Dimension::KinematicViscosity => ("cSt", "m2/s"),
    };
    let guess = guess + 0.0;
    neighbours(guess)
        .into_iter()
        .flat_map(|value| [nice, plain].map(|name| (value, name)))
        .filter_map(|(value, name)| Some((value, UNITS.iter().find(|unit| unit.name == name)?)))
        .flat_map(|(value, unit)| unit.candidates(value).map(|number| format!("{number} {}", unit.name)))
        .find(|text| parse(text, dimension, "").is_ok_and(&fits))
        .unwrap_or_else(|| format!("{guess} {plain}"))
}

/// The value and the doubles next to it, nearest first.
pub fn neighbours(value: f64) -> Vec<f64> {
    let mut found = vec![value];
    let (mut up, mut down) = (value, value);
    for _ in 0..NEIGHBOURS {
        (up, down) = (up.next_up(), down.next_down());
        found.extend([up, down]);
    }
    found
}

/// For messages: four significant digits in the unit that engineers use.
pub fn readable(value: f64, dimension: Dimension) -> String {
    let Some(unit) = message_unit(dimension) else { return value.to_string() };
    let number = (value - unit.zero) / unit.factor;
    format!("{} {}", decimal(&format!("{number:.3e}"), -unit.exponent), unit.name)
}

/// A value and how far it is from another, for one message: both to the same decimal, so that value, difference and
/// other add up as they are printed.
pub fn readable_difference(value: f64, other: f64, dimension: Dimension) -> [String; 2] {
    let Some(unit) = message_unit(dimension) else {
        return [value, (value - other).abs()].map(|v| v.to_string());
    };
    let number = |value: f64| value / unit.factor * 10f64.powi(-unit.exponent);
    let (value, other) = (number(value), number(other));
    let sizes = [value, value - other].map(f64::abs).into_iter().filter(|size| *size > 0.0);
    let smallest = sizes.fold(f64::INFINITY, f64::min);
    let fourth_digit = if smallest.is_finite() { 3 - smallest.log10().floor() as i32 } else { 0 };
    let decimals = fourth_digit.clamp(0, 12) as usize;
    let rounded = |number: f64| format!("{number:.decimals$}").parse::<f64>().unwrap_or(number);
    [value, (rounded(value) - rounded(other)).abs()]
        .map(|number| format!("{number:.decimals$} {}", unit.name))
}

/// The unit of messages.
fn message_unit(dimension: Dimension) -> Option<&'static Unit> {
    let name = match dimension {
        Dimension::Length => "mm",
        Dimension::Inertia => "kg mm2",
        Dimension::Angle => "deg",
        Dimension::Speed => "rpm",
        Dimension::Share => "%",
        _ => dimension.units().next().map_or("", |unit| unit.name),
    };
    UNITS.iter().find(|unit| unit.name == name)
}

#[cfg(test)]
mod tests;
