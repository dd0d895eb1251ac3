//! Quantities at the door: `"79.5 mm"` to SI and back.
//!
//! A power of ten is applied to the decimal text before it becomes a binary number, so `"144 mm"` and `"0.144 m"`
//! are the same number, and writing back in millimetres or grams loses nothing.

mod rewrite;

pub(crate) use rewrite::rewritten;

use crate::nearest::nearest;
use std::f64::consts::PI;

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dimension {
    Length,
    Mass,
    Angle,
    Speed,
    Unbalance,
    Inertia,
    Share,
    Force,
    Pressure,
    Torque,
    Density,
    Velocity,
    Acceleration,
    Area,
    Temperature,
    Energy,
    SpecificEnergy,
    SpecificHeat,
    HeatTransfer,
    Stiffness,
    Damping,
    PressurePerSpeed,
    PressurePerSpeedSquared,
}

impl Dimension {
    /// All dimensions, in the order of the reference.
    pub(crate) const ALL: [Dimension; 23] = [
        Dimension::Length,
        Dimension::Mass,
        Dimension::Angle,
        Dimension::Speed,
        Dimension::Unbalance,
        Dimension::Inertia,
        Dimension::Share,
        Dimension::Force,
        Dimension::Pressure,
        Dimension::Torque,
        Dimension::Density,
        Dimension::Velocity,
        Dimension::Acceleration,
        Dimension::Area,
        Dimension::Temperature,
        Dimension::Energy,
        Dimension::SpecificEnergy,
        Dimension::SpecificHeat,
        Dimension::HeatTransfer,
        Dimension::Stiffness,
        Dimension::Damping,
        Dimension::PressurePerSpeed,
        Dimension::PressurePerSpeedSquared,
    ];

    /// Name with its article, for messages.
    pub(crate) fn with_article(self) -> &'static str {
        match self {
            Dimension::Length => "a length",
            Dimension::Mass => "a mass",
            Dimension::Angle => "an angle",
            Dimension::Speed => "a speed",
            Dimension::Unbalance => "an unbalance",
            Dimension::Inertia => "a moment of inertia",
            Dimension::Share => "a share",
            Dimension::Force => "a force",
            Dimension::Pressure => "a pressure",
            Dimension::Torque => "a torque",
            Dimension::Density => "a density",
            Dimension::Velocity => "a velocity",
            Dimension::Acceleration => "an acceleration",
            Dimension::Area => "an area",
            Dimension::Temperature => "a temperature",
            Dimension::Energy => "an energy",
            Dimension::SpecificEnergy => "an energy per mass",
            Dimension::SpecificHeat => "a specific heat",
            Dimension::HeatTransfer => "a heat transfer coefficient",
            Dimension::Stiffness => "a stiffness",
            Dimension::Damping => "a damping coefficient",
            Dimension::PressurePerSpeed => "a pressure per speed",
            Dimension::PressurePerSpeedSquared => "a pressure per speed squared",
        }
    }

    /// Name for tables and the JSON Schema.
    pub(crate) fn name(self) -> &'static str {
        self.with_article().trim_start_matches("a ").trim_start_matches("an ")
    }

    /// Units in the order in which hints name them.
    pub(crate) fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }

    /// `m, mm, cm, um, in, ft or thou`.
    pub(crate) fn unit_list(self) -> String {
        one_of(self.units().map(|unit| unit.name))
    }
}

/// A unit: `value in SI = number * 10^exponent * factor + zero`.
#[derive(Debug)]
pub(crate) struct Unit {
    pub(crate) name: &'static str,
    pub(crate) dimension: Dimension,
    exponent: i32,
    factor: f64,
    /// Where its scale begins, in SI: 0 but for temperatures.
    zero: f64,
}

const fn unit(dimension: Dimension, name: &'static str, exponent: i32, factor: f64) -> Unit {
    Unit { name, dimension, exponent, factor, zero: 0.0 }
}

const fn from_zero(dimension: Dimension, name: &'static str, factor: f64, zero: f64) -> Unit {
    Unit { name, dimension, exponent: 0, factor, zero }
}

/// International pound [kg] and inch [m] (exact since 1959), standard gravity [m/s^2] (CGPM 1901).
const POUND: f64 = 0.453_592_37;
const INCH: f64 = 0.0254;
const STANDARD_GRAVITY: f64 = 9.806_65;
/// 0 degrees Celsius [K].
const ICE_POINT: f64 = 273.15;

static UNITS: [Unit; 81] = {
    use Dimension::*;
    [
        unit(Length, "mm", -3, 1.0),
        unit(Length, "m", 0, 1.0),
        unit(Length, "cm", -2, 1.0),
        unit(Length, "um", -6, 1.0),
        unit(Length, "in", 0, INCH),
        unit(Length, "ft", 0, 0.3048),
        unit(Length, "thou", -3, INCH),
        unit(Mass, "kg", 0, 1.0),
        unit(Mass, "g", -3, 1.0),
        unit(Mass, "lb", 0, POUND),
        unit(Mass, "oz", 0, POUND / 16.0),
        unit(Angle, "deg", 0, PI / 180.0),
        unit(Angle, "rad", 0, 1.0),
        unit(Speed, "rpm", 0, PI / 30.0),
        unit(Speed, "rad/s", 0, 1.0),
        unit(Speed, "Hz", 0, 2.0 * PI),
        unit(Unbalance, "kg m", 0, 1.0),
        unit(Unbalance, "kg mm", -3, 1.0),
        unit(Unbalance, "g mm", -6, 1.0),
        unit(Unbalance, "g cm", -5, 1.0),
        unit(Unbalance, "g in", -3, INCH),
        unit(Unbalance, "oz in", 0, POUND / 16.0 * INCH),
        unit(Unbalance, "lb in", 0, POUND * INCH),
        unit(Inertia, "kg m2", 0, 1.0),
        unit(Inertia, "kg mm2", -6, 1.0),
        unit(Inertia, "kg cm2", -4, 1.0),
        unit(Inertia, "g mm2", -9, 1.0),
        unit(Inertia, "lb in2", 0, POUND * INCH * INCH),
        unit(Share, "%", -2, 1.0),
        unit(Force, "N", 0, 1.0),
        unit(Force, "kN", 3, 1.0),
        unit(Force, "lbf", 0, POUND * STANDARD_GRAVITY),
        unit(Pressure, "bar", 5, 1.0),
        unit(Pressure, "Pa", 0, 1.0),
        unit(Pressure, "kPa", 3, 1.0),
        unit(Pressure, "MPa", 6, 1.0),
        unit(Pressure, "psi", 0, POUND * STANDARD_GRAVITY / (INCH * INCH)),
        unit(Torque, "N m", 0, 1.0),
        unit(Torque, "kN m", 3, 1.0),
        unit(Torque, "lbf ft", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(Torque, "lbf in", 0, POUND * STANDARD_GRAVITY * INCH),
        unit(Density, "kg/m3", 0, 1.0),
        unit(Density, "g/cm3", 3, 1.0),
        unit(Density, "kg/dm3", 3, 1.0),
        unit(Density, "lb/in3", 0, POUND / (INCH * INCH * INCH)),
        unit(Density, "lb/ft3", 0, POUND / (0.3048 * 0.3048 * 0.3048)),
        unit(Velocity, "mm/s", -3, 1.0),
        unit(Velocity, "m/s", 0, 1.0),
        unit(Velocity, "in/s", 0, INCH),
        unit(Acceleration, "m/s2", 0, 1.0),
        unit(Acceleration, "mm/s2", -3, 1.0),
        unit(Area, "mm2", -6, 1.0),
        unit(Area, "cm2", -4, 1.0),
        unit(Area, "m2", 0, 1.0),
        unit(Area, "in2", 0, INCH * INCH),
        unit(Temperature, "K", 0, 1.0),
        from_zero(Temperature, "degC", 1.0, ICE_POINT),
        from_zero(Temperature, "degF", 1.0 / 1.8, ICE_POINT - 32.0 / 1.8),
        unit(Energy, "J", 0, 1.0),
        unit(Energy, "kJ", 3, 1.0),
        unit(Energy, "ft lbf", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(SpecificEnergy, "MJ/kg", 6, 1.0),
        unit(SpecificEnergy, "kJ/kg", 3, 1.0),
        unit(SpecificEnergy, "J/kg", 0, 1.0),
        unit(SpecificHeat, "J/kg/K", 0, 1.0),
        unit(SpecificHeat, "kJ/kg/K", 3, 1.0),
        unit(HeatTransfer, "W/m2/K", 0, 1.0),
        unit(HeatTransfer, "kW/m2/K", 3, 1.0),
        unit(Stiffness, "N/mm", 3, 1.0),
        unit(Stiffness, "N/m", 0, 1.0),
        unit(Stiffness, "kN/mm", 6, 1.0),
        unit(Stiffness, "lbf/in", 0, POUND * STANDARD_GRAVITY / INCH),
        unit(Damping, "N s/m", 0, 1.0),
        unit(Damping, "N s/mm", 3, 1.0),
        unit(Damping, "lbf s/in", 0, POUND * STANDARD_GRAVITY / INCH),
        unit(PressurePerSpeed, "bar s/m", 5, 1.0),
        unit(PressurePerSpeed, "kPa s/m", 3, 1.0),
        unit(PressurePerSpeed, "Pa s/m", 0, 1.0),
        unit(PressurePerSpeedSquared, "bar s2/m2", 5, 1.0),
        unit(PressurePerSpeedSquared, "kPa s2/m2", 3, 1.0),
        unit(PressurePerSpeedSquared, "Pa s2/m2", 0, 1.0),
    ]
};

/// Other spellings that people write, to be named in a hint; none is read.
const SPELLINGS: [(&str, &str); 43] = [
    ("°", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("grad", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("1/min", "rpm"),
    ("/min", "rpm"),
    ("min-1", "rpm"),
    ("u/min", "rpm"),
    ("tr/min", "rpm"),
    ("rev/min", "rpm"),
    ("r/min", "rpm"),
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

/// Why a text is no quantity of the dimension that is due.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Refusal {
    pub(crate) code: &'static str,
    pub(crate) message: String,
    pub(crate) label: String,
    pub(crate) hint: String,
}

/// The quantity in SI, or why it is none.
///
/// `key` names what asks for it, in messages.
pub(crate) fn parse(text: &str, dimension: Dimension, key: &str) -> Result<f64, Refusal> {
    let trimmed = text.trim();
    let split = number_length(trimmed);
    let (number, rest) = trimmed.split_at(split);
    let unit_text = rest.trim();
    if !number.contains(|c: char| c.is_ascii_digit()) {
        return Err(no_number(trimmed, dimension, key));
    }
    if let Some(refusal) = misspelled_number(number, unit_text, dimension) {
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
            hint: format!("write it in {}", dimension.unit_list()),
        });
    }
    match scaled(number, unit.exponent).map(|value| value * unit.factor + unit.zero) {
        Some(value) if value.is_finite() => Ok(value),
        _ => Err(not_finite(key)),
    }
}

/// What to say of a bare number where a unit is due.
pub(crate) fn missing_unit(number: &str, dimension: Dimension, key: &str) -> Refusal {
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
pub(crate) fn not_finite(key: &str) -> Refusal {
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

/// Bytes of the leading text that is meant as a number: what a number is made of, with separators that are mistakes.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let is_exponent = matches!(bytes[end], b'e' | b'E')
            && end > 0
            && bytes[end - 1] != b'.'
            && match bytes.get(end + 1) {
                Some(b'+' | b'-') => bytes.get(end + 2).is_some_and(u8::is_ascii_digit),
                Some(digit) => digit.is_ascii_digit(),
                None => false,
            };
        let is_sign =
            matches!(bytes[end], b'+' | b'-') && (end == 0 || matches!(bytes[end - 1], b'e' | b'E'));
        let is_number =
            matches!(bytes[end], b'0'..=b'9' | b'.' | b',' | b'_' | b'\'') || is_exponent || is_sign;
        let is_group = bytes[end] == b' '
            && bytes.get(end + 1).is_some_and(u8::is_ascii_digit)
            && end > 0
            && bytes[end - 1].is_ascii_digit();
        if !is_number && !is_group {
            break;
        }
        end += 1;
    }
    // An apostrophe after the last digit is a (misspelled) unit, not a separator.
    while end > 0 && bytes[end - 1] == b'\'' {
        end -= 1;
    }
    end
}

/// A decimal comma, separators between digits, or more than one point.
fn misspelled_number(number: &str, unit: &str, dimension: Dimension) -> Option<Refusal> {
    let with_unit = |number: &str| {
        let unit = if unit.is_empty() { dimension.units().next().map_or("", |unit| unit.name) } else { unit };
        format!("\"{number} {unit}\"")
    };
    let commas = number.matches(',').count();
    if commas == 1 && !number.contains(['.', ' ', '_', '\'']) {
        let mut hint = format!("write {}", with_unit(&number.replace(',', ".")));
        let after_comma = number.split(',').nth(1).unwrap_or("");
        if after_comma.len() == 3 && after_comma.bytes().all(|byte| byte.is_ascii_digit()) {
            hint += &format!(", or {} if the comma parts thousands", with_unit(&number.replace(',', "")));
        }
        return Some(Refusal {
            code: "E0104",
            message: "decimal comma".into(),
            label: "comma in a number".into(),
            hint,
        });
    }
    if number.contains([',', ' ', '_', '\'']) {
        return Some(Refusal {
            code: "E0105",
            message: "a number without separators between its digits is needed".into(),
            label: "separator in a number".into(),
            hint: format!("write {}", with_unit(&number.replace([',', ' ', '_', '\''], ""))),
        });
    }
    if number.parse::<f64>().is_err() {
        return Some(Refusal {
            code: "E0105",
            message: format!("{number} is no number"),
            label: "no number".into(),
            hint: format!("write a plain decimal number such as {}", with_unit("12.5")),
        });
    }
    None
}

fn unknown_unit(number: &str, text: &str, dimension: Dimension, key: &str) -> Refusal {
    let spelled = SPELLINGS.iter().find(|(other, _)| other.eq_ignore_ascii_case(text)).map(|(_, name)| *name);
    let near = spelled
        .filter(|name| dimension.units().any(|unit| unit.name == *name))
        .or_else(|| nearest(&canonical(text), dimension.units().map(|unit| unit.name)));
    Refusal {
        code: "E0102",
        message: format!("`{key}` has the unknown unit \"{text}\""),
        label: "unknown unit".into(),
        hint: match near {
            Some(name) => format!("write \"{number} {name}\""),
            None => format!("{} is written in {}", dimension.with_article(), dimension.unit_list()),
        },
    }
}

/// The unit of this name: `kg m`, `kg*m`, `kg·m` and `kgm` are one, so are `m2`, `m^2` and `m²`.
fn find_unit(text: &str) -> Option<&'static Unit> {
    let name = canonical(text);
    UNITS
        .iter()
        .find(|unit| unit.name == name)
        .or_else(|| UNITS.iter().find(|unit| unit.name.contains(' ') && unit.name.replace(' ', "") == name))
}

fn canonical(text: &str) -> String {
    let text = text
        .replace(['*', '·', '⋅', '\u{a0}'], " ")
        .replace('²', "2")
        .replace('³', "3")
        .replace('^', "")
        .replace(['µ', 'μ'], "u");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `number * 10^exponent`, rounded once.
fn scaled(number: &str, exponent: i32) -> Option<f64> {
    let (mantissa, own) = match number.split_once(['e', 'E']) {
        Some((mantissa, own)) => (mantissa, own.parse::<i32>().ok()?),
        None => (number, 0),
    };
    format!("{mantissa}e{}", own.saturating_add(exponent)).parse().ok()
}

/// `value` [SI] as text that [`parse`] reads back into the same double, in the unit that reads best.
pub(crate) fn exact_text(value: f64, dimension: Dimension) -> String {
    text_that(value, dimension, |read| read == value)
}

/// Doubles to either side of a guess that [`text_that`] tries.
const NEIGHBOURS: usize = 8;

/// Text of a value at or next to `guess` [SI] that reads back as one that `fits`, in the unit that reads best; the
/// text of the guess itself if none does.
pub(crate) fn text_that(guess: f64, dimension: Dimension, fits: impl Fn(f64) -> bool) -> String {
    let (nice, plain) = match dimension {
        Dimension::Length => ("mm", "m"),
        Dimension::Mass => ("kg", "kg"),
        Dimension::Angle => ("deg", "rad"),
        Dimension::Speed => ("rpm", "rad/s"),
        Dimension::Unbalance => ("kg m", "kg m"),
        Dimension::Inertia => ("kg mm2", "kg m2"),
        Dimension::Share => ("%", "%"),
        Dimension::Force => ("N", "N"),
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
        Dimension::Stiffness => ("N/mm", "N/m"),
        Dimension::Damping => ("N s/m", "N s/m"),
        Dimension::PressurePerSpeed => ("bar s/m", "Pa s/m"),
        Dimension::PressurePerSpeedSquared => ("bar s2/m2", "Pa s2/m2"),
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
pub(crate) fn neighbours(value: f64) -> Vec<f64> {
    let mut found = vec![value];
    let (mut up, mut down) = (value, value);
    for _ in 0..NEIGHBOURS {
        (up, down) = (up.next_up(), down.next_down());
        found.extend([up, down]);
    }
    found
}

impl Unit {
    /// Texts that may read back as `value`, the shortest first.
    fn candidates(&self, value: f64) -> impl Iterator<Item = String> {
        let number = (value - self.zero) / self.factor;
        [Some(12), None].into_iter().map(move |digits| {
            let text = match digits {
                Some(digits) => format!("{number:.digits$e}"),
                None => format!("{number:e}"),
            };
            decimal(&text, -self.exponent)
        })
    }
}

/// `1.25e-1` times `10^exponent` without an exponent where that is short, without trailing zeros.
fn decimal(scientific: &str, exponent: i32) -> String {
    let (mantissa, own) = scientific.split_once('e').unwrap_or((scientific, "0"));
    let exponent = own.parse::<i32>().unwrap_or(0) + exponent;
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(mantissa) => ("-", mantissa),
        None => ("", mantissa),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_end_matches('0');
    if digits.is_empty() {
        return format!("{sign}0");
    }
    let point = exponent + whole.len() as i32;
    let count = digits.len() as i32;
    match point {
        -5..=0 => format!("{sign}0.{}{digits}", "0".repeat(-point as usize)),
        1..=16 if point >= count => format!("{sign}{digits}{}", "0".repeat((point - count) as usize)),
        1..=16 => format!("{sign}{}.{}", &digits[..point as usize], &digits[point as usize..]),
        _ if count == 1 => format!("{sign}{digits}e{}", point - 1),
        _ => format!("{sign}{}.{}e{}", &digits[..1], &digits[1..], point - 1),
    }
}

/// For messages: four significant digits in the unit that engineers use.
pub(crate) fn readable(value: f64, dimension: Dimension) -> String {
    let name = match dimension {
        Dimension::Length => "mm",
        Dimension::Inertia => "kg mm2",
        Dimension::Angle => "deg",
        Dimension::Speed => "rpm",
        Dimension::Share => "%",
        _ => dimension.units().next().map_or("", |unit| unit.name),
    };
    let Some(unit) = UNITS.iter().find(|unit| unit.name == name) else { return value.to_string() };
    let number = (value - unit.zero) / unit.factor;
    format!("{} {name}", decimal(&format!("{number:.3e}"), -unit.exponent))
}

/// `a, b or c`.
pub(crate) fn one_of<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => (*one).to_string(),
        [rest @ .., last] => format!("{} or {last}", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests;
