//! Comparing numbers that rounding or a model's error keeps apart.

use num_complex::Complex64;
use std::fmt::LowerExp;

/// How far two numbers may be apart, and why so far and no farther.
#[derive(Debug, Clone, Copy)]
pub struct Within<'a> {
    /// In the unit of the numbers.
    absolute: f64,
    /// Of the size of the number wanted.
    share: f64,
    reason: &'a str,
}

impl<'a> Within<'a> {
    /// So much, in the unit of the numbers.
    pub fn absolute(tolerance: f64, reason: &'a str) -> Within<'a> {
        Within { absolute: tolerance, share: 0.0, reason }
    }

    /// So much of the size of the number wanted.
    pub fn share(tolerance: f64, reason: &'a str) -> Within<'a> {
        Within { absolute: 0.0, share: tolerance, reason }
    }

    /// So much of a scale: of the largest terms of a sum, where the sum may be small.
    pub fn of(scale: f64, tolerance: f64, reason: &'a str) -> Within<'a> {
        Within::absolute(tolerance * scale.abs(), reason)
    }

    /// So much more, in the unit of the numbers.
    pub fn and(self, absolute: f64) -> Within<'a> {
        Within { absolute: self.absolute + absolute, ..self }
    }
}

/// What can be close to another.
pub trait Number: LowerExp {
    /// How far it is from another.
    fn distance(&self, other: &Self) -> f64;
    /// How far it is from 0.
    fn size(&self) -> f64;
}

impl Number for f64 {
    fn distance(&self, other: &f64) -> f64 {
        (self - other).abs()
    }

    fn size(&self) -> f64 {
        self.abs()
    }
}

impl Number for Complex64 {
    fn distance(&self, other: &Complex64) -> f64 {
        (self - other).norm()
    }

    fn size(&self) -> f64 {
        self.norm()
    }
}

/// Whether `got` is `wanted` within a tolerance; what is wrong in words otherwise. What is not a number is close to nothing.
///
/// # Errors
/// What is compared, both numbers, their difference, the tolerance and its reason.
pub fn close<N: Number>(what: &str, got: N, wanted: N, within: Within) -> Result<(), String> {
    let allowed = within.absolute + within.share * wanted.size();
    let off = got.distance(&wanted);
    if off <= allowed {
        return Ok(());
    }
    let reason = within.reason;
    Err(format!("{what}: got {got:e}, wanted {wanted:e}, off by {off:e}, allowed {allowed:e}: {reason}"))
}

/// Asserts that `got` is `wanted` within a tolerance.
///
/// # Panics
/// Where it is not: with what [`close`] says.
#[track_caller]
pub fn assert_close<N: Number>(what: &str, got: N, wanted: N, within: Within) {
    if let Err(wrong) = close(what, got, wanted, within) {
        panic!("{wrong}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_absolute_a_share_or_both() {
        let off = |got: f64, wanted: f64, within: Within| close("x", got, wanted, within).is_err();
        assert!(!off(1.0 + 1e-9, 1.0, Within::absolute(2e-9, "so")));
        assert!(off(1.0 + 3e-9, 1.0, Within::absolute(2e-9, "so")));
        assert!(!off(-100.0 - 1e-7, -100.0, Within::share(2e-9, "so")));
        assert!(off(-100.0 - 3e-7, -100.0, Within::share(2e-9, "so")));
        assert!(!off(1e-7, 0.0, Within::of(-100.0, 2e-9, "so")));
        assert!(off(1e-7, 0.0, Within::share(2e-9, "so")));
        assert!(!off(1e-7, 0.0, Within::share(2e-9, "so").and(1e-6)));
        // Nothing is close to what is not a number, however far it may be.
        for (got, wanted) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, 1.0)] {
            assert!(off(got, wanted, Within::absolute(1e300, "so")), "{got} {wanted}");
        }
    }

    #[test]
    fn a_difference_is_told_with_its_reason() {
        let wrong = close("force [N]", 1.5, 1.0, Within::absolute(0.25, "half of the last printed digit"));
        assert_eq!(
            wrong,
            Err("force [N]: got 1.5e0, wanted 1e0, off by 5e-1, allowed 2.5e-1: half of the last printed digit"
                .to_owned())
        );
        let turned = Complex64::new(0.0, 2.0);
        assert!(close("phasor", turned, -turned, Within::share(1.0, "half a turn")).is_err());
        assert!(close("phasor", turned, turned * 1.5, Within::share(1.0, "a third")).is_ok());
    }
}
