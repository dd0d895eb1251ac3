//! Lists and ranges of quantities: `60 deg, 90 deg`, `60 deg .. 120 deg by 15 deg`.

use crate::failure::Failure;

/// Most values of one list.
const MOST: f64 = 100_000.0;

/// The values of a list, ranges spread out; `one` reads a value.
pub fn value_list(
    text: &str,
    option: &str,
    one: impl Fn(&str) -> Result<f64, Failure>,
) -> Result<Vec<f64>, Failure> {
    let mut values = Vec::new();
    for part in text.split(',').map(str::trim) {
        let Some((from, rest)) = part.split_once("..") else {
            values.push(one(part)?);
            continue;
        };
        let Some((to, step)) = rest.split_once(" by ") else {
            return Err(Failure::input(
                format_args!("{option} needs the step of a range, got `{part}`"),
                format_args!("write it behind the range: `{part} by ...`"),
            ));
        };
        let (from, to, step) = (one(from.trim())?, one(to.trim())?, one(step.trim())?);
        let steps = (to - from) / step;
        if !(steps >= -1e-9 && step > 0.0) {
            return Err(Failure::input(
                format_args!(
                    "{option} needs a range from the smaller to the larger in steps above 0, got `{part}`"
                ),
                "write the smaller value first, and a step above 0",
            ));
        }
        if steps > MOST {
            return Err(Failure::input(
                format_args!("{option} has more than {MOST} values: `{part}`"),
                "take larger steps",
            ));
        }
        values.extend((0..=(steps + 1e-9) as usize).map(|k| from + k as f64 * step));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Result<Vec<f64>, Failure> {
        value_list(text, "--x", |one| {
            one.parse().map_err(|_| Failure::input(format_args!("no number: `{one}`"), "write one"))
        })
    }

    #[test]
    fn lists_and_ranges_mix() {
        assert_eq!(numbers("1, 3 .. 6 by 1.5, -2").ok(), Some(vec![1.0, 3.0, 4.5, 6.0, -2.0]));
        // A range ends where its last whole step does.
        assert_eq!(numbers("0 .. 1 by 0.4").ok(), Some(vec![0.0, 0.4, 0.8]));
        assert_eq!(numbers("2 .. 2 by 1").ok(), Some(vec![2.0]));
        for wrong in ["1 .. 2", "2 .. 1 by 1", "1 .. 2 by 0", "1 .. 2 by -1", "0 .. 1 by 1e-9", "a", ""] {
            assert!(numbers(wrong).is_err(), "{wrong}");
        }
    }
}
