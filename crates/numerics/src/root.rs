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

#[cfg(test)]
mod tests {
    use super::*;

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
