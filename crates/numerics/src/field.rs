//! Values that can be divided, whose roots and directions can be taken: numbers, intervals, and either with derivatives.

use crate::interval::Interval;
use crate::jet::{Jet, Ring};
use std::f64::consts::FRAC_PI_2;

/// A [`Ring`] with reciprocals, roots and directions.
///
/// ```
/// use lanchester_numerics::{Field, Interval, Jet, Ring};
/// // sqrt(x) and its slope while x runs from 1 to 4: from 1 to 2, and from 1/4 to 1/2.
/// let x = Jet::<Interval, 1>::variable(Interval::new(1.0, 4.0), 0);
/// assert_eq!(x.root(), Jet { value: Interval::new(1.0, 2.0), by: [Interval::new(0.25, 0.5)] });
/// ```
pub trait Field: Ring {
    /// 1 over this.
    fn inverse(self) -> Self;
    /// Its square root.
    fn root(self) -> Self;
    /// Sine and cosine of this as an angle [rad].
    fn sin_cos(self) -> [Self; 2];
}

impl Field for f64 {
    fn inverse(self) -> f64 {
        1.0 / self
    }
    fn root(self) -> f64 {
        self.sqrt()
    }
    fn sin_cos(self) -> [f64; 2] {
        let (sin, cos) = f64::sin_cos(self);
        [sin, cos]
    }
}

impl Field for Interval {
    /// Of an interval that has 0 in it: all numbers.
    fn inverse(self) -> Interval {
        if self.low <= 0.0 && self.high >= 0.0 {
            return Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        Interval { low: 1.0 / self.high, high: 1.0 / self.low }
    }
    /// What lies below 0 counts as 0.
    fn root(self) -> Interval {
        Interval { low: self.low.max(0.0).sqrt(), high: self.high.max(0.0).sqrt() }
    }
    fn sin_cos(self) -> [Interval; 2] {
        [sine(self), sine(Interval { low: self.low + FRAC_PI_2, high: self.high + FRAC_PI_2 })]
    }
}

/// All sines of an interval of angles.
fn sine(angle: Interval) -> Interval {
    let (a, b) = (angle.low.sin(), angle.high.sin());
    // Whether some first + 2 pi k lies in it.
    let holds = |first: f64| {
        let turns = ((angle.low - first) / std::f64::consts::TAU).ceil();
        first + turns * std::f64::consts::TAU <= angle.high
    };
    Interval {
        low: if holds(-FRAC_PI_2) { -1.0 } else { a.min(b) },
        high: if holds(FRAC_PI_2) { 1.0 } else { a.max(b) },
    }
}

impl<T: Field, const N: usize> Field for Jet<T, N> {
    fn inverse(self) -> Self {
        let value = self.value.inverse();
        self.chain(value, -value.square())
    }
    fn root(self) -> Self {
        let value = self.value.root();
        self.chain(value, value.times(2.0).inverse())
    }
    fn sin_cos(self) -> [Self; 2] {
        let [sin, cos] = self.value.sin_cos();
        [self.chain(sin, cos), self.chain(cos, -sin)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `1 / sqrt(2 + sin x)`.
    fn sample<T: Field>(x: T) -> T {
        (T::of(2.0) + x.sin_cos()[0]).root().inverse()
    }

    #[test]
    fn derivatives_are_the_differences() {
        for at in [-2.0, -0.3, 0.0, 1.1, 2.9] {
            let x = Jet::<f64, 1>::variable(at, 0);
            let twice = Jet { value: x, by: [Jet::of(1.0)] };
            let got = sample::<Jet<Jet<f64, 1>, 1>>(twice);
            let step = 1e-4;
            let (below, here, above) = (sample(at - step), sample(at), sample(at + step));
            assert!((got.value.value - here).abs() < 1e-15);
            // Central differences: truncation near 1e-9, rounding near 1e-8 in the second.
            assert!((got.value.by[0] - (above - below) / (2.0 * step)).abs() < 1e-8);
            assert!((got.by[0].by[0] - (above - 2.0 * here + below) / (step * step)).abs() < 1e-6);
        }
    }

    #[test]
    fn intervals_hold_all_values() {
        for (low, high) in [(-0.4, 0.3), (1.2, 1.9), (-1.8, -1.5), (2.0, 9.0), (40.0, 40.5), (-7.0, -6.0)] {
            let range = Interval::new(low, high);
            let whole = sample::<Jet<Interval, 1>>(Jet::variable(range, 0));
            for k in 0..=50 {
                let at = low + (high - low) * f64::from(k) / 50.0;
                let one = sample::<Jet<f64, 1>>(Jet::variable(at, 0));
                let holds = |range: Interval, x: f64| range.low - 1e-14 <= x && x <= range.high + 1e-14;
                assert!(holds(whole.value, one.value) && holds(whole.by[0], one.by[0]), "{low} {high} {at}");
            }
        }
        assert_eq!(Interval::new(0.0, 7.0).sin_cos()[0], Interval::new(-1.0, 1.0));
        assert_eq!(Interval::new(-1.0, 2.0).inverse().high, f64::INFINITY);
        assert_eq!(Interval::new(-1.0, 4.0).root(), Interval::new(0.0, 2.0));
    }
}
