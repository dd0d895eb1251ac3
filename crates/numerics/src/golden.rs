//! The largest value of a function of one variable that rises and then falls.

/// What a step leaves of the bracket: the golden ratio's inverse.
const SHARE: f64 = 0.618_033_988_749_894_9;

/// Place and value of the largest value of `f` between `from` and `to`, by so many steps of the golden section: each leaves 0.618 of
/// the bracket and takes one evaluation. Where `f` has several hills, it is the top of one of them.
///
/// # Errors
/// The first one of `f`.
///
/// # Source
/// Kiefer, "Sequential minimax search for a maximum", Proceedings of the American Mathematical Society 4 (1953).
pub fn golden_section<E>(
    mut from: f64,
    mut to: f64,
    steps: usize,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let (mut left, mut right) = (to - SHARE * (to - from), from + SHARE * (to - from));
    let (mut at_left, mut at_right) = (f(left)?, f(right)?);
    for _ in 0..steps {
        if at_left >= at_right {
            (to, right, at_right) = (right, left, at_left);
            left = to - SHARE * (to - from);
            at_left = f(left)?;
        } else {
            (from, left, at_left) = (left, right, at_right);
            right = from + SHARE * (to - from);
            at_right = f(right)?;
        }
    }
    Ok(if at_left >= at_right { (left, at_left) } else { (right, at_right) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_top_of_a_hill_is_found_at_the_golden_rate() {
        let mut evaluations = 0;
        let hill = |x: f64| {
            evaluations += 1;
            Ok::<f64, ()>(-(x - 0.3).powi(2))
        };
        let (place, value) = golden_section(-1.0, 2.0, 30, hill).expect("it cannot fail");
        assert!((place - 0.3).abs() < 3.0 * SHARE.powi(30) && value > -1e-10, "{place} {value}");
        assert_eq!(evaluations, 32);
        assert_eq!(golden_section(0.0, 1.0, 5, |_| Err("no")), Err("no"));
        // A hill at an end is found there.
        let (place, _) = golden_section(0.0, 1.0, 30, Ok::<f64, ()>).expect("it cannot fail");
        assert!(place > 1.0 - 1e-5);
    }
}
