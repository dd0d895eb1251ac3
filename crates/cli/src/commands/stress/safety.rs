//! A static safety that is wanted.

use crate::failure::Failure;
use crate::files::tell;
use lanchester::report::FilletFatigue;

/// Whether a static safety is as wanted; says so where it is not.
pub(super) fn is_safe(found: Option<f64>, wanted: Option<f64>) -> bool {
    let Some(wanted) = wanted else { return true };
    match found {
        Some(safety) if safety >= wanted => return true,
        Some(safety) => tell(format_args!("the static safety is {safety:.3}, wanted is {wanted}")),
        None => tell(
            "the static safety is not known: give yield_strength or a preset in [crank.material], and fillets",
        ),
    }
    false
}

/// Whether a fillet's safety against fatigue is as wanted; says so where it is not. `under`: what it was loaded by.
pub(super) fn endures(fillet: &FilletFatigue, under: &str, wanted: f64) -> bool {
    let is_safe = fillet.is_safe(wanted);
    if !is_safe {
        let of_amplitude = fillet.point.safety_of_amplitude == Some(fillet.least_safety());
        tell(format_args!(
            "the safety against fatigue{} at {} ({under}) is {:.3}, wanted is {wanted}",
            if of_amplitude { " of the amplitude alone" } else { "" },
            fillet.name,
            fillet.least_safety()
        ));
    }
    is_safe
}

/// A safety that is wanted.
pub(super) fn wanted_safety(safety: Option<f64>) -> Result<Option<f64>, Failure> {
    match safety {
        Some(safety) if !(safety > 0.0 && safety.is_finite()) => Err(Failure::input(
            format_args!("--safety needs a number above 0, got {safety}"),
            "for example --safety 1.5",
        )),
        other => Ok(other),
    }
}
