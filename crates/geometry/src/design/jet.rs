//! What a formula must have so that it can be differentiated, and the functions of this design's formulas with their derivatives.

use super::arc;
use super::number::Number;
use lanchester_numerics::Jet;

/// What a jet is made of: it can be differentiated.
pub(super) trait Base: Number {
    /// Cosine of an angle within [0, pi].
    fn cos(self) -> Self;
    /// Derivatives of [`Number::segment`] by the angle, of an order from 0 to 2.
    fn segment_by(self, order: usize) -> [Self; 3];
    /// `min(d, 0)`.
    fn negative_part(self) -> Self;
    /// One below zero, zero above: the derivative of [`Base::negative_part`].
    fn below_zero(self) -> Self;
}

impl Base for f64 {
    fn cos(self) -> f64 {
        f64::cos(self)
    }
    fn segment_by(self, order: usize) -> [f64; 3] {
        arc::segment(self, order)
    }
    fn negative_part(self) -> f64 {
        self.min(0.0)
    }
    fn below_zero(self) -> f64 {
        f64::from(u8::from(self < 0.0))
    }
}

impl<T: Base, const N: usize> Number for Jet<T, N> {
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn late_sine(self) -> Self {
        self.chain(self.value.late_sine(), self.value.cos().negative_part())
    }
    fn half_tangent(self) -> Self {
        let tangent = self.value.half_tangent();
        self.chain(tangent, (T::of(1.0) + tangent.square()).times(0.5))
    }
    fn segment(self) -> [Self; 3] {
        let (values, slopes) = (self.value.segment_by(0), self.value.segment_by(1));
        std::array::from_fn(|k| self.chain(values[k], slopes[k]))
    }
}
