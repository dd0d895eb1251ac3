//! Quantities outside an engine file: the options of a command line.

use crate::quantity::{Dimension, parse};

/// Why a text is no quantity of the kind that is due.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct BadQuantity {
    /// What was needed and what was got.
    pub message: String,
    /// What to do.
    pub hint: String,
}

/// A speed with its unit, such as "4000 rpm" [rad/s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of speed.
pub fn speed(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Speed, option)
}

/// A length with its unit, such as "-120 mm" [m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of length.
pub fn length(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Length, option)
}

fn of_dimension(text: &str, dimension: Dimension, option: &str) -> Result<f64, BadQuantity> {
    parse(text, dimension, option)
        .map_err(|refusal| BadQuantity { message: refusal.message, hint: refusal.hint })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_speed_and_what_is_none() {
        assert_eq!(speed("60 rpm", "--speed"), Ok(std::f64::consts::TAU));
        assert_eq!(length("-12 mm", "--about"), Ok(-0.012));
        let refused = speed("60 mm", "--speed").unwrap_err();
        assert!(refused.message.contains("--speed") && refused.hint.contains("rpm"), "{refused:?}");
    }
}
