//! A quantity with its first two derivatives by time, each of them with its derivative by one input.

use num_dual::{Dual64, DualNum};
use std::ops::{Add, Mul, Sub};

/// A quantity over time: value, rate and second derivative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet {
    pub value: Dual64,
    pub rate: Dual64,
    pub bend: Dual64,
}

/// What does not depend on the input.
pub(super) fn known(value: f64) -> Dual64 {
    Dual64::new(value, 0.0)
}

impl Jet {
    pub fn constant(value: Dual64) -> Jet {
        Jet { value, rate: known(0.0), bend: known(0.0) }
    }

    /// Cosine and sine of an angle [rad] that grows at a constant rate [rad/s].
    pub fn circle(angle: Dual64, rate: Dual64) -> [Jet; 2] {
        let (sin, cos) = (angle.sin(), angle.cos());
        [
            Jet { value: cos, rate: -sin * rate, bend: -cos * rate * rate },
            Jet { value: sin, rate: cos * rate, bend: -sin * rate * rate },
        ]
    }

    /// `w = sqrt(y)`: `w' = y'/(2 w)`, `w'' = (y''/2 - w'^2)/w`.
    pub fn sqrt(self) -> Jet {
        let value = self.value.sqrt();
        let rate = self.rate / (value * 2.0);
        Jet { value, rate, bend: (self.bend / 2.0 - rate * rate) / value }
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, other: Jet) -> Jet {
        Jet { value: self.value + other.value, rate: self.rate + other.rate, bend: self.bend + other.bend }
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, other: Jet) -> Jet {
        Jet { value: self.value - other.value, rate: self.rate - other.rate, bend: self.bend - other.bend }
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, other: Jet) -> Jet {
        Jet {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            bend: self.bend * other.value + self.rate * other.rate * 2.0 + self.value * other.bend,
        }
    }
}

impl Mul<Dual64> for Jet {
    type Output = Jet;
    fn mul(self, factor: Dual64) -> Jet {
        Jet { value: self.value * factor, rate: self.rate * factor, bend: self.bend * factor }
    }
}
