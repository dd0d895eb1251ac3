//! Roots of a function of one variable.

/// A bracketed root: the function changes its sign between `before` and `after`, which lie within the tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Last place with the sign of the start.
    pub before: f64,
    /// First place with the other sign.
    pub after: f64,
}

/// The change of sign of `f` between `a` and `b`, to `tolerance`, by the ITP method: never more than one evaluation worse
/// than bisection. `negative_at_a` says which sign counts as that of `a`, so that a start at zero is no difficulty.
///
/// Source: Oliveira, Takahashi, ACM Transactions on Mathematical Software 47 (2020), no. 1, article 5.
pub fn bisect(
    mut f: impl FnMut(f64) -> f64,
    a: f64,
    b: f64,
    fa: f64,
    fb: f64,
    negative_at_a: bool,
    tolerance: f64,
) -> Root {
    let sign = if negative_at_a { 1.0 } else { -1.0 };
    let (mut before, mut after, mut low, mut high) = (a, b, sign * fa, sign * fb);
    let halvings = ((b - a).abs() / tolerance.max(f64::MIN_POSITIVE)).log2().ceil().max(0.0);
    let most = halvings as usize + 2;
    for iteration in 0..200 {
        let width = after - before;
        let middle = before + 0.5 * width;
        if width.abs() <= tolerance || middle == before || middle == after {
            break;
        }
        let spread = high - low;
        let secant = if spread > 0.0 && low.is_finite() && high.is_finite() {
            before - low * width / spread
        } else {
            middle
        };
        let toward = (middle - secant).signum();
        let truncation = 0.2 / (b - a).abs() * width * width;
        let truncated =
            if truncation.abs() <= (middle - secant).abs() { secant + toward * truncation } else { middle };
        let left = most.saturating_sub(iteration);
        let reach = (0.5 * tolerance * 2f64.powi(left.min(1000) as i32) - 0.5 * width.abs()).max(0.0);
        let mut place = if (truncated - middle).abs() <= reach { truncated } else { middle - toward * reach };
        if !((place - before) * width > 0.0 && (after - place) * width > 0.0) {
            place = middle;
        }
        let value = sign * f(place);
        if value > 0.0 {
            after = place;
            high = value;
        } else {
            before = place;
            low = value;
        }
    }
    Root { before, after }
}

/// The zero of a continuous function between `a` and `b`, where it has the opposite signs `at_a` and `at_b`, to rounding: the Illinois
/// rule, kept honest by a bisection every fourth step. A value no larger than `settled` counts as zero.
///
/// It is quicker than [`bisect`] where the function is smooth, and bounds nothing where it is not.
///
/// Source: Dowell, Jarratt, BIT 11 (1971), pages 168 to 174.
pub fn illinois(
    mut a: f64,
    mut at_a: f64,
    mut b: f64,
    mut at_b: f64,
    settled: f64,
    mut f: impl FnMut(f64) -> f64,
) -> f64 {
    for iteration in 0..100 {
        let width = b - a;
        if width.abs() <= 4.0 * f64::EPSILON * (1.0 + a.abs()) {
            break;
        }
        let secant = b - at_b * width / (at_b - at_a);
        // Every fourth step halves the bracket, whatever the secant says.
        let trial = if iteration % 4 == 3 || !secant.is_finite() { a + 0.5 * width } else { secant };
        let value = f(trial);
        if value.abs() <= settled {
            return trial;
        }
        if (value > 0.0) == (at_b > 0.0) {
            at_a *= 0.5;
        } else {
            (a, at_a) = (b, at_b);
        }
        (b, at_b) = (trial, value);
    }
    b
}

/// The last place on the way from `holding`, where a condition holds, to `other`, where it may not, at which it still holds, by halving
/// to the last digit.
pub fn last_holding(mut holds: impl FnMut(f64) -> bool, mut holding: f64, mut other: f64) -> f64 {
    for _ in 0..200 {
        let middle = (holding + other) / 2.0;
        if middle == holding || middle == other {
            break;
        }
        if holds(middle) { holding = middle } else { other = middle }
    }
    holding
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_and_limits_are_found_to_rounding() {
        let cubic = |x: f64| x * x * x - 2.0;
        let mut evaluations = 0;
        let counted = |x| {
            evaluations += 1;
            cubic(x)
        };
        let found = illinois(0.5, cubic(0.5), 2.5, cubic(2.5), 0.0, counted);
        assert!((found - 2f64.cbrt()).abs() < 1e-15 && evaluations < 20, "{found} after {evaluations}");
        // A steep step, which no secant helps with.
        let step = |x: f64| if x < 1.7 { -1e-30 } else { 1e30 };
        let found = illinois(0.5, step(0.5), 2.5, step(2.5), 0.0, step);
        assert!((found - 1.7).abs() < 1e-6, "{found}");
        let last = last_holding(|x| x * x <= 2.0, 1.0, 2.0);
        assert!(last * last <= 2.0 && last.next_up() * last.next_up() > 2.0, "{last}");
    }

    #[test]
    fn roots_are_bracketed_to_the_tolerance_whatever_the_function_looks_like() {
        type Case = (fn(f64) -> f64, f64);
        let functions: [Case; 4] = [
            (|x| x * x * x - 2.0, 2f64.cbrt()),
            (|x| if x < 1.7 { -1e-30 } else { 1e30 }, 1.7),
            (|x| (x - 1.2).powi(9), 1.2),
            (|x| 1.0 / (3.0 - x) - 0.5, 1.0),
        ];
        for (f, root) in functions {
            let mut evaluations = 0;
            let found = bisect(
                |x| {
                    evaluations += 1;
                    f(x)
                },
                0.5,
                2.5,
                f(0.5),
                f(2.5),
                f(0.5) < 0.0,
                1e-12,
            );
            assert!(found.before <= root + 1e-13 && root <= found.after + 1e-13, "{found:?} misses {root}");
            assert!(found.after - found.before <= 1e-12, "{found:?} is wide");
            assert!(evaluations <= 45, "{evaluations} evaluations");
        }
    }
}
