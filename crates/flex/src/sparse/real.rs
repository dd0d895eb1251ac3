//! The two precisions of a factor.

use faer::traits::RealField;

/// Numbers that a factor may be made of.
pub trait Real: RealField + Copy + Send + Sync {
    /// The nearest one.
    fn from_double(value: f64) -> Self;
    /// The same in double precision.
    fn to_double(self) -> f64;
    /// `self - a b`, in one rounding where `FMA`.
    fn less_product<const FMA: bool>(self, a: Self, b: Self) -> Self;
}

impl Real for f64 {
    fn from_double(value: f64) -> f64 {
        value
    }
    fn to_double(self) -> f64 {
        self
    }
    #[inline(always)]
    fn less_product<const FMA: bool>(self, a: f64, b: f64) -> f64 {
        if FMA { (-a).mul_add(b, self) } else { self - a * b }
    }
}

impl Real for f32 {
    fn from_double(value: f64) -> f32 {
        value as f32
    }
    fn to_double(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn less_product<const FMA: bool>(self, a: f32, b: f32) -> f32 {
        if FMA { (-a).mul_add(b, self) } else { self - a * b }
    }
}
