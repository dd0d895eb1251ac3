//! A crank angle with its direction, found once for all pistons.

use lanchester_model::Ratio;
use num_complex::Complex64;

/// Crank angle of crankshaft 1 and its direction `e^{i theta}`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turned {
    /// `theta` [rad].
    pub theta: f64,
    direction: Complex64,
}

impl Turned {
    /// At `theta` [rad].
    pub fn at(theta: f64) -> Turned {
        Turned { theta, direction: Complex64::cis(theta) }
    }

    /// `e^{i n theta}`: how far a crankshaft with the speed ratio `n` has turned.
    pub fn by(&self, ratio: Ratio) -> Complex64 {
        match (ratio.numerator(), ratio.denominator()) {
            (1, 1) => self.direction,
            (-1, 1) => self.direction.conj(),
            _ => Complex64::cis(ratio.value() * self.theta),
        }
    }
}
