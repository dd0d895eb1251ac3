//! The one rule of rounding in print: a value below a billionth of the largest of its kind is rounding and is shown as 0.
//!
//! Of one kind is what is added up in the same sum, or could be: forces with forces, couples with couples, unbalances
//! with unbalances. The largest is that of the parts that have to cancel, not of what is left of them:
//!
//! | where                                   | the largest of a kind is                                         |
//! |-----------------------------------------|------------------------------------------------------------------|
//! | loads of an engine                      | of the whole, any part, any cylinder (`kit::magnitude`)          |
//! | answers of balancing                    | of all moving masses together (`lanchester_balance::natural`)    |
//! | inside the crankshaft                   | of all cases that are compared                                   |
//! | unbalances of a crank, planes, weights  | of all that the table has                                        |
//! | any other column                        | of the column                                                    |
//!
//! Sums of a few hundred terms in double precision lose at most about 1e-13 of the largest term; a billionth leaves room
//! for quadratures and for what an optimiser closes, and no instrument of the field resolves it.

/// A value below this share of the largest of its kind is rounding.
const SHARE: f64 = 1e-9;

/// Moments of forces that all pass through one point vanish with all their parts: at this lever [m] the forces tell what is
/// rounding then.
const LEVER: f64 = 0.01;

/// Below this values are rounding, where the largest of their kind is `largest`, in the same unit.
pub(crate) fn below(largest: f64) -> f64 {
    SHARE * largest.abs()
}

/// The largest of a kind of moments [N m] of forces up to `force` [N]: at least theirs at a lever of a centimetre.
pub(crate) fn largest_moment(moment: f64, force: f64) -> f64 {
    moment.abs().max(LEVER * force.abs())
}

/// The same as [`below`] of the largest of `values`; what is not finite counts for nothing.
pub(crate) fn among(values: impl IntoIterator<Item = f64>) -> f64 {
    below(values.into_iter().filter(|v| v.is_finite()).fold(0.0, |most: f64, v| most.max(v.abs())))
}

/// The value, or 0 where it is not above `noise`.
pub(crate) fn clean(value: f64, noise: f64) -> f64 {
    if value.abs() <= noise { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_billionth_of_the_largest_is_nothing_and_a_hair_more_is_something() {
        let noise = among([3.0, -5e3, f64::NAN, f64::INFINITY]);
        assert_eq!(noise, below(5e3));
        assert_eq!(clean(-5e-6, noise), 0.0);
        assert_eq!(clean(5.1e-6, noise), 5.1e-6);
        assert!(clean(f64::NAN, noise).is_nan(), "what is not known stays so");
        assert_eq!(among([]), 0.0);
    }
}
