//! Films and safeties of an engine in another size.

use super::meter::{DurabilityRequest, EngineDurability};
use crate::pressure::measured::TraceFile;
use lanchester_model::{DrivelineInertia, Engine};
use lanchester_study::compare::Similar;
use lanchester_task::{DurabilityCriterion, DurabilityMeter, Measured, Unmeasured};

/// Films of main bearings and of big ends, safety after UR M53 and, where it is asked for, that of fillets by finite elements, at the smaller of two speeds
/// of the original [rad/s].
pub(crate) fn similar_durability(
    engine: &Engine,
    traces: &[TraceFile],
    similar: Similar,
    speeds: [f64; 2],
    driveline: &[DrivelineInertia],
    finite_elements: bool,
) -> [Measured; 4] {
    let factor = similar.speed_of_original();
    let mut speeds: Vec<f64> = speeds.iter().map(|speed| speed * factor).collect();
    speeds.dedup();
    let request = DurabilityRequest {
        speeds,
        weights_alone: false,
        length: similar.length,
        speed_of_original: factor,
        finite_elements,
        driveline: Some(driveline.to_vec()),
    };
    let asked = [
        DurabilityCriterion::MainFilm(None),
        DurabilityCriterion::CrankpinFilm(None),
        DurabilityCriterion::RuleSafety(None),
        DurabilityCriterion::FilletSafety,
    ];
    let mut found = EngineDurability::new(Ok(traces), request).measure(engine, &asked).into_iter();
    let missing =
        || Unmeasured { reason: "it was not computed".into(), remedy: "compare it by itself".into() };
    std::array::from_fn(|_| found.next().unwrap_or_else(|| Measured::Unknown(missing())))
}
