//! Sums and products of twice the digits: what cancels in the coefficients of a polynomial leaves no rounding.

use std::ops::{Add, Mul};

/// A number as the sum of two, the second below the last digit of the first.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Double {
    high: f64,
    low: f64,
}

impl From<f64> for Double {
    fn from(high: f64) -> Double {
        Double { high, low: 0.0 }
    }
}

impl Double {
    /// The sum of both parts.
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// The sum of two numbers and what its rounding leaves.
    fn sum(a: f64, b: f64) -> Double {
        let high = a + b;
        let of_b = high - a;
        Double { high, low: (a - (high - of_b)) + (b - of_b) }
    }

    /// Divided by a whole number.
    pub fn over(self, divisor: f64) -> Double {
        let high = self.high / divisor;
        let rest = (-high).mul_add(divisor, self.high) + self.low;
        Double::sum(high, rest / divisor)
    }
}

impl Add for Double {
    type Output = Double;

    fn add(self, other: Double) -> Double {
        let sum = Double::sum(self.high, other.high);
        Double::sum(sum.high, sum.low + (self.low + other.low))
    }
}

impl Mul for Double {
    type Output = Double;

    fn mul(self, other: Double) -> Double {
        let high = self.high * other.high;
        let rest = self.high.mul_add(other.high, -high);
        Double::sum(high, rest + (self.high * other.low + self.low * other.high))
    }
}

#[cfg(test)]
mod tests {
    use super::Double;

    #[test]
    fn what_cancels_leaves_no_rounding() {
        let third = Double::from(1.0).over(3.0);
        let rest = (third * Double::from(3.0) + Double::from(-1.0)).value();
        assert!(rest.abs() < 1e-31, "{rest:e}");
        let large = Double::from(1e16) + Double::from(1.0) + Double::from(-1e16);
        assert_eq!(large.value(), 1.0);
        // (1 + e)(1 - e) = 1 - e^2
        let e = f64::EPSILON;
        let product = Double::from(1.0 + e) * Double::from(1.0 - e) + Double::from(-1.0);
        assert_eq!(product.value(), -e * e);
    }
}
