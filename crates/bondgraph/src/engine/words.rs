//! Numbers and sums as the graph file writes them.

/// Directions closer to an axis than this lie on it.
const ROUNDING: f64 = 1e-15;

/// A number with all its digits.
pub(crate) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number with its unit; a nought with its unit too.
pub(crate) fn quantity(value: f64, unit: &str) -> String {
    format!("{value:?} {unit}")
}

/// Cosine and sine, noughts where rounding alone keeps them from it.
pub(crate) fn direction(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin].map(|value| if value.abs() < ROUNDING { 0.0 } else { value })
}

/// `SUM factor * name`, without what is nought; factors of 1 are not written.
pub(crate) fn combination(terms: &[(f64, &str)]) -> String {
    let mut text = String::new();
    for (factor, name) in terms {
        if *factor == 0.0 || name.is_empty() || *name == "0" {
            continue;
        }
        let minus = *factor < 0.0;
        text += match (text.is_empty(), minus) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = factor.abs();
        if size != 1.0 {
            text += &format!("{size:?}*");
        }
        let simple = !name.contains(' ') || is_quantity(name);
        text += &if simple { (*name).to_owned() } else { format!("({name})") };
    }
    if text.is_empty() { "0".into() } else { text }
}

/// Whether a text is one number with its unit.
fn is_quantity(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit()) && !text.contains(['+', '*', '('])
}

/// Rows of entries as the key `matrix` takes them.
pub(crate) fn matrix(rows: &[Vec<String>]) -> String {
    rows.iter().map(|row| row.join("; ")).collect::<Vec<_>>().join(" | ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_read_as_a_person_writes_them() {
        assert_eq!(combination(&[(1.0, "a"), (-1.0, "b"), (0.0, "c"), (0.5, "d")]), "a - b + 0.5*d");
        assert_eq!(combination(&[(-2.0, "a + b")]), "-2.0*(a + b)");
        assert_eq!(combination(&[(0.0, "a"), (1.0, "0")]), "0");
        assert_eq!(combination(&[(1.0, "0.25 m"), (1.0, "x")]), "0.25 m + x");
    }

    #[test]
    fn directions_along_the_axes_are_exact() {
        assert_eq!(direction(std::f64::consts::FRAC_PI_2), [0.0, 1.0]);
        assert_eq!(direction(std::f64::consts::PI), [-1.0, 0.0]);
    }
}
