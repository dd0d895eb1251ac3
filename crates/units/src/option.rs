//! Quantities outside an engine file: the options of a command line.

use crate::quantity::{Bound, Dimension, Refusal, parse, within};

/// Why a text is no quantity of the kind that is due.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct BadQuantity {
    /// What was needed and what was got.
    pub message: String,
    /// What to do.
    pub hint: String,
}

impl From<Refusal> for BadQuantity {
    fn from(refusal: Refusal) -> BadQuantity {
        BadQuantity { message: refusal.message, hint: refusal.hint }
    }
}

/// A speed with its unit, such as "4000 rpm" [rad/s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of speed, or outside the accepted range, more than 0.
pub fn speed(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Speed, Bound::Positive, option)
}

/// A speed from which something starts, with its unit: 0 is standstill [rad/s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of speed, or outside the accepted range, 0 or more.
pub fn start_speed(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Speed, Bound::NotNegative, option)
}

/// A length with its unit, such as "-120 mm" [m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of length.
pub fn length(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Length, Bound::Any, option)
}

/// A mass with its unit, such as "412 g" [kg]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of mass, or outside the accepted range, 0 or more.
pub fn mass(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Mass, Bound::NotNegative, option)
}

/// An angle with its unit, such as "180 deg" [rad]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of angle.
pub fn angle(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Angle, Bound::Any, option)
}

/// An inertia with its unit, such as "0.02 kg m2" [kg m^2]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of inertia, or outside the accepted range, 0 or more.
pub fn inertia(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Inertia, Bound::NotNegative, option)
}

/// A pressure with its unit, such as "1.2 bar" [Pa]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of pressure, or outside the accepted range, 0 or more.
pub fn pressure(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Pressure, Bound::NotNegative, option)
}

/// A torque with its unit, such as "95 N m" [N m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of torque, or outside the accepted range, 0 or more.
pub fn torque(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Torque, Bound::NotNegative, option)
}

/// A stiffness with its unit, such as "200 N/um" [N/m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of stiffness, or outside the accepted range, more than 0.
pub fn stiffness(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Stiffness, Bound::Positive, option)
}

/// A time with its unit, such as "30 s" or "5 min" [s]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number above 0 with a unit of time.
pub fn time(text: &str, option: &str) -> Result<f64, BadQuantity> {
    const UNITS: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("min", 60.0), ("h", 3600.0)];
    let text = text.trim();
    let (number, unit) = text.split_at(text.trim_end_matches(|c: char| c.is_ascii_alphabetic()).len());
    let factor = UNITS.iter().find(|(name, _)| *name == unit).map(|(_, factor)| factor);
    let time = number.trim().parse::<f64>().ok().zip(factor).map(|(number, factor)| number * factor);
    time.filter(|time| time.is_finite() && *time > 0.0).ok_or_else(|| BadQuantity {
        message: format!("`{option}` needs a time above 0 with its unit, got \"{text}\""),
        hint: "write a number with ms, s, min or h, such as \"30 s\"".into(),
    })
}

/// A share such as "50%", "50 %" or "0.5"; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number, or a bare number beyond 2, which is meant in percent.
pub fn share(text: &str, option: &str) -> Result<f64, BadQuantity> {
    match text.trim().parse::<f64>() {
        Ok(bare) if (0.0..=2.0).contains(&bare) => Ok(bare),
        Ok(bare) if bare > 2.0 && bare.is_finite() => Err(BadQuantity {
            message: format!("`{option}` needs a share, got the bare number {bare}"),
            hint: format!("write {bare}% or {}", bare / 100.0),
        }),
        Ok(bare) if bare < 0.0 => {
            within(bare, Dimension::Share, Bound::NotNegative, option, text, None).map_err(BadQuantity::from)
        }
        _ => of_dimension(text, Dimension::Share, Bound::NotNegative, option),
    }
}

/// An unbalance with its unit, such as "0.03 kg m" [kg m]; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number of 0 or more with a unit of unbalance.
pub fn unbalance(text: &str, option: &str) -> Result<f64, BadQuantity> {
    of_dimension(text, Dimension::Unbalance, Bound::NotNegative, option)
}

/// An unbalance [kg m], given as itself or as a mass at `radius`; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if it is neither, not above 0, or a mass without a radius.
pub fn mass_or_unbalance(text: &str, radius: Option<f64>, option: &str) -> Result<f64, BadQuantity> {
    let example = "write a mass such as \"5 g\", which counts at the radius of the weight, or an unbalance such as \"200 g mm\"";
    let hinted = |refusal: Refusal| BadQuantity { message: refusal.message, hint: example.into() };
    let mass = parse(text, Dimension::Mass, option);
    let own = if mass.is_ok() { Dimension::Mass } else { Dimension::Unbalance };
    let is_mass = mass.is_ok();
    let value = mass.or_else(|_| parse(text, Dimension::Unbalance, option)).map_err(hinted)?;
    let value = within(value, own, Bound::Positive, option, text, None).map_err(hinted)?;
    match (is_mass, radius) {
        (false, _) => Ok(value),
        (true, Some(radius)) => Ok(value * radius),
        (true, None) => Err(BadQuantity {
            message: format!("a mass in `{option}` needs the radius of every weight"),
            hint: "give an unbalance such as \"200 g mm\", or radius in [balance]".into(),
        }),
    }
}

/// A quantity [SI] within the range that a key of the engine file has too; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] if the text is no number with a unit of the dimension, or outside the range.
pub fn of_dimension(
    text: &str,
    dimension: Dimension,
    bound: Bound,
    option: &str,
) -> Result<f64, BadQuantity> {
    let value = parse(text, dimension, option).map_err(BadQuantity::from)?;
    within(value, dimension, bound, option, text, None).map_err(BadQuantity::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_speed_and_what_is_none() {
        assert_eq!(speed("60 rpm", "--speed"), Ok(std::f64::consts::TAU));
        assert_eq!(length("-12 mm", "--about"), Ok(-0.012));
        assert_eq!(mass("412 g", "--bobweight"), Ok(0.412));
        assert_eq!((time("1.5 min", "--time-limit"), time("20ms", "--time-limit")), (Ok(90.0), Ok(0.02)));
        for text in ["5", "0 s", "-1 s", "5 kg", "inf s", "s", ""] {
            assert!(time(text, "--time-limit").is_err_and(|bad| bad.hint.contains("30 s")), "{text}");
        }
        assert_eq!(angle("180 deg", "--angle"), Ok(std::f64::consts::PI));
        assert_eq!(inertia("2 kg m2", "--inertia"), Ok(2.0));
        assert_eq!((share("50%", "--share"), share("0.5", "--share")), (Ok(0.5), Ok(0.5)));
        assert!(share("50", "--share").unwrap_err().hint.starts_with("write 50%"));
        // What a key of the engine file does not take, no option takes.
        for text in ["-500 rpm", "0 rpm", "1e20 rpm"] {
            let refused = speed(text, "--speed").unwrap_err();
            assert!(refused.message.contains("--speed") && !refused.hint.is_empty(), "{refused:?}");
        }
        assert_eq!(start_speed("0 rpm", "--start"), Ok(0.0));
        assert!(start_speed("-5 rpm", "--start").is_err());
        assert!(mass("-1 kg", "--oil").is_err() && share("-0.5", "--share").is_err());
        assert!(inertia("-1 kg m2", "--inertia").is_err() && length("1e20 m", "--about").is_err());
        let refused = speed("60 mm", "--speed").unwrap_err();
        assert!(refused.message.contains("--speed") && refused.hint.contains("rpm"), "{refused:?}");
    }
}
