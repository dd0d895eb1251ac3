//! Static cases of the engine file.

use crate::stress::mesh::StressMesh;
use crate::stress::request::{GivenForce, StaticRequest, StressError, StressLoad};
use lanchester_flex::crank_case::CrankSupport;
use lanchester_task::{StressCaseLoad, StressCaseTask, StressSupport, Tasks};

/// Rings where the file does not say: a bearing shell with its bore [m], [Pa].
const RING: [f64; 2] = [5e-3, 210e9];

/// The static case of this name.
///
/// # Errors
/// [`StressError::NoCase`] with the names that there are.
pub fn stress_case<'a>(tasks: &'a Tasks, name: &str) -> Result<&'a StressCaseTask, StressError> {
    let task = tasks.stress.as_ref();
    task.and_then(|task| task.case(name)).ok_or_else(|| StressError::NoCase {
        name: name.to_owned(),
        known: task.map_or_else(Vec::new, |task| task.cases.iter().map(|case| case.name.clone()).collect()),
    })
}

impl StaticRequest {
    /// A case of the file on a mesh, whose crankshaft becomes that of the case.
    pub fn of_case(case: &StressCaseTask, mesh: StressMesh) -> StaticRequest {
        let load = match &case.load {
            StressCaseLoad::Angle { angle } => StressLoad::Angles(vec![*angle]),
            StressCaseLoad::Forces { forces, angle } => StressLoad::Given {
                forces: forces
                    .iter()
                    .map(|own| GivenForce {
                        pin: own.throw + 1,
                        radial: own.radial,
                        tangential: own.tangential,
                    })
                    .collect(),
                angle: *angle,
            },
        };
        let support = match &case.support {
            StressSupport::ClampedEnds => CrankSupport::ClampedEnds,
            StressSupport::Journals => CrankSupport::Journals,
            StressSupport::Rings { thickness, modulus } => CrankSupport::Rings {
                thickness: thickness.unwrap_or(RING[0]),
                modulus: modulus.unwrap_or(RING[1]),
            },
            StressSupport::Springs { stiffness } => CrankSupport::Springs { stiffness: stiffness.clone() },
            StressSupport::Film => CrankSupport::Films,
            StressSupport::Free => CrankSupport::Free,
        };
        StaticRequest {
            name: Some(case.name.clone()),
            mesh: StressMesh {
                crankshaft: case.crankshaft,
                own: mesh.own.filter(|_| case.crankshaft == 0),
                ..mesh
            },
            support,
            load,
            speeds: case.speed.into_iter().collect(),
            ..StaticRequest::default()
        }
    }
}
