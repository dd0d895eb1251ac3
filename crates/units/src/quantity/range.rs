//! Which values of a quantity are accepted, in an engine file as in an option.

use super::{Dimension, Refusal, readable};

/// Which values of a quantity make sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// Any sign.
    Any,
    /// 0 or more.
    NotNegative,
    /// More than 0.
    Positive,
}

/// Sizes in SI beyond which nothing is accepted, with much to spare: squares and products of them stay finite.
pub const LARGEST: f64 = 1e12;
/// Smallest value of what must be positive.
pub const SMALLEST: f64 = 1e-12;
/// Temperatures [K] of gas and walls that an engine may have: from liquid nitrogen to above any flame.
const TEMPERATURES: [f64; 2] = [77.0, 5000.0];

/// What to do about a number that is out of its range.
const CHECK: &str = "check the number and its unit";

/// The value [SI], or why it is out of range; `got` is its text, `example` what stands in its place in a good file, if anything.
pub fn within(
    value: f64,
    dimension: Dimension,
    bound: Bound,
    key: &str,
    got: &str,
    example: Option<&str>,
) -> Result<f64, Refusal> {
    let refuse = |message: String, hint: String| {
        Err(Refusal { code: "E0108", message, label: "out of range".into(), hint })
    };
    if dimension == Dimension::Temperature {
        let [lowest, highest] = TEMPERATURES;
        if (lowest..=highest).contains(&value) {
            return Ok(value);
        }
        let message =
            format!("`{key}` is outside the accepted range [{lowest} K, {highest} K], got {}", got.trim());
        return refuse(message, CHECK.into());
    }
    let needed = match bound {
        Bound::NotNegative if value < 0.0 => "must not be negative",
        Bound::Positive if value <= 0.0 => "must be more than 0",
        _ => "",
    };
    if !needed.is_empty() {
        let hint = example.map_or_else(|| CHECK.to_string(), |example| format!("for example {example}"));
        return refuse(format!("`{key}` {needed}, got {}", got.trim()), hint);
    }
    let lowest = match bound {
        Bound::Any => -LARGEST,
        Bound::NotNegative => 0.0,
        Bound::Positive => SMALLEST,
    };
    if (lowest..=LARGEST).contains(&value) {
        return Ok(value);
    }
    let [lowest, highest] = [lowest, LARGEST].map(|end| readable(end, dimension));
    refuse(
        format!("`{key}` is outside the accepted range [{lowest}, {highest}], got {}", got.trim()),
        CHECK.into(),
    )
}
