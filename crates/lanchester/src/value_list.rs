//! Lists and ranges of quantities: `60 deg, 90 deg`, `60 deg .. 120 deg by 15 deg`.

use lanchester_units::BadQuantity;

/// Most values of one list.
const MOST: f64 = 100_000.0;

/// The values of a list, ranges spread out; `one` reads a value, and `option` names what asks for them in messages.
///
/// # Errors
/// Those of `one`; a range without a step, with one that is not above 0, from the larger to the smaller, or of more than 100 000 values.
pub fn value_list<E: From<BadQuantity>>(
    text: &str,
    option: &str,
    one: impl Fn(&str) -> Result<f64, E>,
) -> Result<Vec<f64>, E> {
    let bad = |message: String, hint: String| E::from(BadQuantity { message, hint });
    let mut values = Vec::new();
    for part in text.split(',').map(str::trim) {
        let Some((from, rest)) = part.split_once("..") else {
            values.push(one(part)?);
            continue;
        };
        let Some((to, step)) = rest.split_once(" by ") else {
            return Err(bad(
                format!("{option} needs the step of a range, got `{part}`"),
                format!("write it behind the range: `{part} by ...`"),
            ));
        };
        let (from, to, step) = (one(from.trim())?, one(to.trim())?, one(step.trim())?);
        let steps = (to - from) / step;
        if !(steps >= -1e-9 && step > 0.0) {
            return Err(bad(
                format!(
                    "{option} needs a range from the smaller to the larger in steps above 0, got `{part}`"
                ),
                "write the smaller value first, and a step above 0".to_owned(),
            ));
        }
        if steps > MOST {
            return Err(bad(
                format!("{option} has more than {MOST} values: `{part}`"),
                "take larger steps".to_owned(),
            ));
        }
        values.extend((0..=(steps + 1e-9) as usize).map(|k| from + k as f64 * step));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Result<Vec<f64>, BadQuantity> {
        value_list(text, "angles", |one| {
            let wrong =
                |_| BadQuantity { message: format!("no number: `{one}`"), hint: "write one".to_owned() };
            one.parse().map_err(wrong)
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
