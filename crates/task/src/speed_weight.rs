//! A speed at which loads are judged, with its weight: `2000 rpm * 2`.

use crate::option::{BadQuantity, speed};

/// What stands between a speed and its weight.
const TIMES: char = '*';

/// Largest and smallest weight: what is further from 1 is no weight but a slip.
const WEIGHTS: [f64; 2] = [1e-6, 1e6];

/// A speed [rad/s] and its weight, 1 where there is none: `2000 rpm` or `2000 rpm * 2`; `option` names what asks for it in the message.
///
/// # Errors
/// [`BadQuantity`] as [`speed`], and where the weight is no number above 0.
pub fn weighted_speed(text: &str, option: &str) -> Result<(f64, f64), BadQuantity> {
    let Some((before, weight)) = text.rsplit_once(TIMES) else { return Ok((speed(text, option)?, 1.0)) };
    let got: String = weight.trim().chars().take(40).collect();
    let weight = weight.trim().parse::<f64>().ok();
    match weight.filter(|weight| (WEIGHTS[0]..=WEIGHTS[1]).contains(weight)) {
        Some(weight) => Ok((speed(before, option)?, weight)),
        None => Err(BadQuantity {
            message: format!(
                "the weight of a speed in {option} must be a number from {:e} to {:e}, got \"{got}\"",
                WEIGHTS[0], WEIGHTS[1]
            ),
            hint: format!(
                "write {option} '{} * 2': what the load at this speed is multiplied by",
                before.trim().chars().take(40).collect::<String>()
            ),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_speed_may_have_a_weight() {
        let rpm = PI / 30.0;
        for (text, want) in [
            ("2000 rpm", (2000.0 * rpm, 1.0)),
            (" 2000 rpm * 2 ", (2000.0 * rpm, 2.0)),
            ("50 rad/s*0.5", (50.0, 0.5)),
        ] {
            let (speed, weight) = weighted_speed(text, "--speed").expect(text);
            assert!((speed - want.0).abs() < 1e-9 && weight == want.1, "{text}");
        }
        for (text, word) in [
            ("2000 rpm * 0", "\"0\""),
            ("2000 rpm * -1", "\"-1\""),
            ("2000 rpm * nan", "\"nan\""),
            ("2000 rpm * inf", "\"inf\""),
            ("2000 rpm *", "\"\""),
            ("2000 rpm * two", "\"two\""),
        ] {
            let refused = weighted_speed(text, "--speed").expect_err(text);
            assert!(
                refused.message.contains(word) && refused.hint.contains("2000 rpm * 2"),
                "{text}: {refused:?}"
            );
        }
        assert!(weighted_speed("fast * 2", "--speed").expect_err("no speed").message.contains("--speed"));
    }
}
