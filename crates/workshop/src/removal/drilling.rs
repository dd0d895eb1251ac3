//! Which holes to drill for a correction, and what they leave.

use crate::error::WorkshopError;
use crate::removal::hole::Hole;
use crate::removal::hole_search::{Search, search};
use crate::rotor::correction::{Correction, correction, graded};
use crate::rotor::grade::Grade;
use crate::rotor::plane::PlaneUnbalance;
use lanchester_task::workshop::{Drill, Sheet};
use num_complex::Complex64;
use serde::Serialize;

/// Holes for the correction of a sheet.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Drilling {
    /// [`WORKSHOP_VERSION`](crate::WORKSHOP_VERSION).
    pub version: u32,
    /// Name of the sheet.
    pub name: String,
    /// The correction that the holes are for.
    pub correction: Correction,
    /// Holes of every plane that is drilled.
    pub planes: Vec<DrilledPlane>,
    /// The balance quality grade with these holes, and with the weights of the other planes as told.
    pub grade_after: Option<Grade>,
    /// Whether the grade is kept with these holes; without a grade, whether every plane comes as near to what is wanted as
    /// its steps of depth allow.
    pub holds: bool,
}

/// Holes of one plane.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DrilledPlane {
    /// Name of the plane.
    pub plane: String,
    /// Unbalance to remove [kg m]: its argument is the angle on the rotor.
    #[schemars(with = "[f64; 2]")]
    pub wanted: Complex64,
    /// The holes, by angle.
    pub holes: Vec<Hole>,
    /// What they leave to remove [kg m].
    #[schemars(with = "[f64; 2]")]
    pub left: Complex64,
    /// What may be left [kg m]: the plane's share of the grade; without one, what a step of depth makes.
    pub tolerance: f64,
    /// Whether no more than that is left.
    pub kept: bool,
    /// Whether every set of holes was looked at; if not, a better one may exist.
    pub complete: bool,
}

/// The holes for the correction of a sheet, in every plane with `drill`.
///
/// Of all sets of allowed holes the one that leaves the least; sets that leave no more than the plane's tolerance count as
/// equally good, and of those the one with the fewest holes is taken, then the one that leaves the least.
///
/// # Errors
/// [`WorkshopError`] as for [`correction`], and where no plane is drilled or no trial weight has been tried.
pub fn drilling(sheet: &Sheet) -> Result<Drilling, WorkshopError> {
    if sheet.planes.iter().all(|plane| plane.drill.is_none()) {
        return Err(WorkshopError::missing(
            "a plane with `drill`",
            "drilling",
            "add drill = { direction = \"radial\", diameters = [..], max_depth = .., density = .. } to a [[plane]]",
        ));
    }
    let correction = correction(sheet)?;
    if correction.planes.is_empty() {
        return Err(WorkshopError::missing(
            "a run with a trial weight",
            "drilling",
            "measure a run with a trial weight: the correction of the sheet says where",
        ));
    }
    let mut planes = Vec::new();
    // What is left in every plane of the correction, as an unbalance to put on.
    let mut left = Vec::new();
    for wanted in &correction.planes {
        let source = sheet.planes.iter().find(|plane| plane.name == wanted.plane);
        let (Some(plane), Some((drill, radius))) =
            (source, source.and_then(|plane| plane.drill.as_ref().zip(plane.radius)))
        else {
            left.push(wanted.left);
            continue;
        };
        let share = correction
            .grade_now
            .as_ref()
            .and_then(|grade| grade.planes.iter().find(|graded| graded.name == plane.name))
            .map(|graded| graded.permissible);
        let tolerance = share.unwrap_or_else(|| resolution(drill, radius));
        let target = -wanted.unbalance;
        let Search { holes, left: remaining, complete } =
            search(target, &plane.allowed, drill, radius, tolerance);
        left.push(-remaining);
        planes.push(DrilledPlane {
            plane: plane.name.clone(),
            wanted: target,
            holes,
            left: remaining,
            tolerance,
            kept: remaining.norm() <= tolerance,
            complete,
        });
    }
    let grade_after = graded(sheet, after(sheet, &correction, &left))?;
    let holds = match grade_after.as_ref().and_then(|grade| grade.kept) {
        Some(kept) => kept,
        None => planes.iter().all(|plane| plane.kept),
    };
    Ok(Drilling {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        correction,
        planes,
        grade_after,
        holds,
    })
}

/// What is left on the rotor after the correction, where it leaves `left` undone.
fn after(sheet: &Sheet, correction: &Correction, left: &[Complex64]) -> Option<Vec<PlaneUnbalance>> {
    let z_of = |name: &str| sheet.planes.iter().find(|plane| plane.name == name)?.z;
    let undone: Option<Vec<PlaneUnbalance>> = correction
        .planes
        .iter()
        .zip(left)
        .map(|(plane, left)| {
            let (name, z) = (plane.plane.clone(), z_of(&plane.plane)?);
            Some(PlaneUnbalance { name, z, unbalance: -left })
        })
        .collect();
    if correction.runs.is_some() {
        return undone;
    }
    // What is displayed, less all that was wanted, is what two planes cannot take away: nothing, or a couple.
    let wanted = correction.planes.iter().map(|plane| {
        Some(PlaneUnbalance { name: plane.plane.clone(), z: z_of(&plane.plane)?, unbalance: plane.unbalance })
    });
    let wanted: Option<Vec<PlaneUnbalance>> = wanted.collect();
    Some(crate::displayed(&sheet.displays).into_iter().chain(wanted?).chain(undone?).collect())
}

/// What one step of depth makes with the smallest drill, or rounding where any depth may be drilled [kg m].
fn resolution(drill: &Drill, radius: f64) -> f64 {
    let diameter = drill.diameters.iter().copied().fold(f64::INFINITY, f64::min);
    let per_depth = drill.density * std::f64::consts::PI * diameter * diameter / 4.0 * radius;
    per_depth * drill.depth_step.unwrap_or(1e-9)
}

#[cfg(test)]
mod tests;
