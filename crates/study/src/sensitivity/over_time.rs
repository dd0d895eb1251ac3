//! A quantity with its first two derivatives by time, each of them with its derivative by one input: dual numbers of dual numbers.

use num_dual::{Dual2, Dual64, DualNum};

/// A quantity over time: value `re`, rate `v1` and second derivative `v2`.
pub(super) type OverTime = Dual2<Dual64>;

/// What does not depend on the input.
pub(super) fn known(value: f64) -> Dual64 {
    Dual64::new(value, 0.0)
}

/// What does not depend on time.
pub(super) fn constant(value: Dual64) -> OverTime {
    OverTime::from_re(value)
}

/// `factor` times a quantity over time, where the factor does not depend on time.
pub(super) fn times(quantity: OverTime, factor: Dual64) -> OverTime {
    OverTime::new(quantity.re * factor, quantity.v1 * factor, quantity.v2 * factor)
}

/// Cosine and sine of an angle [rad] that grows at a constant rate [rad/s].
pub(super) fn circle(angle: Dual64, rate: Dual64) -> [OverTime; 2] {
    let (sin, cos) = OverTime::new(angle, rate, known(0.0)).sin_cos();
    [cos, sin]
}
