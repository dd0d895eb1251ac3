//! A signed speed ratio as a fraction, so that orders and periods stay exact.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// Speed of a shaft over that of crankshaft 1, in lowest terms; the sign is the sense of rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ratio {
    numerator: i32,
    denominator: u32,
}

impl Ratio {
    /// Crankshaft speed, with the crank.
    pub const ONE: Ratio = Ratio { numerator: 1, denominator: 1 };

    /// The fraction in lowest terms; `None` if either part is 0.
    pub fn new(numerator: i32, denominator: u32) -> Option<Ratio> {
        if numerator == 0 || denominator == 0 {
            return None;
        }
        let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator);
        Some(Ratio { numerator: numerator / divisor as i32, denominator: denominator / divisor })
    }

    /// A whole ratio; `None` for 0.
    pub fn whole(numerator: i32) -> Option<Ratio> {
        Ratio::new(numerator, 1)
    }

    /// Numerator with the sign.
    pub fn numerator(self) -> i32 {
        self.numerator
    }

    /// Denominator.
    pub fn denominator(self) -> u32 {
        self.denominator
    }

    /// As a number.
    pub fn value(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }
}

/// Greatest common divisor; the other number if one is 0.
pub fn greatest_common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            write!(f, "{}", self.numerator)
        } else {
            write!(f, "{}/{}", self.numerator, self.denominator)
        }
    }
}

impl schemars::JsonSchema for Ratio {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Ratio".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A whole number, or a fraction such as `1/2`.",
            "type": "string",
        })
    }
}

impl Serialize for Ratio {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Ratio {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Ratio, D::Error> {
        let text = String::deserialize(deserializer)?;
        let (numerator, denominator) = text.split_once('/').unwrap_or((&text, "1"));
        let ratio = numerator.parse().ok().zip(denominator.parse().ok());
        ratio.and_then(|(numerator, denominator)| Ratio::new(numerator, denominator)).ok_or_else(|| {
            de::Error::custom(format_args!(
                "a speed ratio must be a whole number or a fraction other than 0, such as `-1/2`, got `{text}`"
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_read_as_it_is_written() {
        for ratio in [Ratio::ONE, Ratio::new(-1, 2).unwrap(), Ratio::whole(-3).unwrap()] {
            let text = serde_json::to_string(&ratio).unwrap();
            assert_eq!(serde_json::from_str::<Ratio>(&text).unwrap(), ratio);
        }
        assert!(serde_json::from_str::<Ratio>("\"0\"").is_err());
        assert!(serde_json::from_str::<Ratio>("\"1/x\"").is_err());
    }

    #[test]
    fn lowest_terms_and_sign() {
        let ratio = Ratio::new(-4, 6).unwrap();
        assert_eq!((ratio.numerator(), ratio.denominator()), (-2, 3));
        assert_eq!(ratio.to_string(), "-2/3");
        assert_eq!(Ratio::whole(2).unwrap().to_string(), "2");
        assert!(Ratio::new(0, 3).is_none() && Ratio::new(3, 0).is_none());
    }
}
