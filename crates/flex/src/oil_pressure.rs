//! Pressure of oil films on pins and journals.

use crate::FlexError;
use crate::mesh::{Mesh, SurfaceFace, weighted_areas};
use crate::train::{BearingPlace, FilmInstant, Plane, TrainLaw, solved_film};
use lanchester_film::contact_force;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Cells around, and along half the width.
const CELLS: (usize, usize) = (120, 12);
/// Pieces into which a side of a face is cut: film pressure changes within one.
const PARTS: usize = 5;

/// Pressure of an oil film on a pin or journal, in the frame of the crankshaft.
#[derive(Debug, Clone, PartialEq)]
pub struct OilPressure {
    /// Bearing and surface.
    pub place: BearingPlace,
    /// Force of the film on the crankshaft [N].
    pub force: Plane,
    /// Force of the roughness that touches, on the crankshaft [N].
    pub contact: Plane,
    /// Largest pressure [Pa].
    pub largest: f64,
    /// Angles of the middles of the columns about the bar's middle, rising within a turn [rad].
    angles: Vec<f64>,
    /// Pressure of column i and cell j from the middle of the width to its end, at i m + j [Pa].
    pressures: Vec<f64>,
}

impl OilPressure {
    /// Of a film by itself, solved directly; none of a bearing without film. Vectors of the instant are in the frame of the crankshaft.
    ///
    /// # Errors
    /// [`FlexError::Film`] for a bearing or an eccentricity that has no film.
    pub fn of_film(
        place: &BearingPlace,
        law: &TrainLaw,
        instant: &FilmInstant,
    ) -> Result<Option<OilPressure>, FlexError> {
        let TrainLaw::Film { bearing, viscosity, roughness, .. } = law else { return Ok(None) };
        let refused = |error| FlexError::Film { bearing: place.name.clone(), error };
        let Some((solver, film)) = solved_film(law, instant, CELLS).map_err(refused)? else {
            return Ok(None);
        };
        let ratio = instant.eccentricity.map(|part| part / bearing.clearance);
        let scale = bearing.pressure_scale(*viscosity);
        let size = ratio[0].hypot(ratio[1]);
        let touching = contact_force(bearing, *roughness, size);
        Ok(Some(OilPressure {
            place: place.clone(),
            force: film.force,
            contact: if touching > 0.0 { ratio.map(|part| -touching * part / size) } else { [0.0; 2] },
            largest: film.largest_pressure,
            angles: (0..CELLS.0).map(|i| solver.grid().angle(i)).collect(),
            pressures: solver.pressure().iter().map(|p| scale * p).collect(),
        }))
    }

    /// Pressure [Pa] at an angle about the bar's middle [rad] and a place along the crankshaft [m]; 0 beside the bearing.
    pub fn at(&self, angle: f64, z: f64) -> f64 {
        let share = (z - self.place.z).abs() / (0.5 * self.place.width);
        if share >= 1.0 {
            return 0.0;
        }
        let (n, m) = (self.angles.len(), CELLS.1);
        let turned = self.angles[0] + (angle - self.angles[0]).rem_euclid(TAU);
        let next = self.angles.partition_point(|own| *own <= turned);
        let column = next.saturating_sub(1);
        let (low, next) = (self.angles[column], next % n);
        let width = (self.angles[next] - low).rem_euclid(TAU);
        let s = if width > 0.0 { (turned - low) / width } else { 0.0 };
        let of_column = |column: usize| {
            let cell = |j: usize| self.pressures[column * m + j];
            // The middle of the width is a line of symmetry; at the end the pressure is that of the surroundings.
            let at = share * m as f64 - 0.5;
            if at <= 0.0 {
                return cell(0);
            }
            let (j, t) = ((at as usize).min(m - 1), at - at.floor());
            if j + 1 < m {
                (1.0 - t) * cell(j) + t * cell(j + 1)
            } else {
                cell(j) * (1.0 - share) * 2.0 * m as f64
            }
        };
        (1.0 - s) * of_column(column) + s * of_column(next)
    }

    /// Forces of the pressure on the nodes of faces [N].
    pub(crate) fn forces(&self, mesh: &Mesh, faces: &[SurfaceFace], middle: Plane) -> BTreeMap<u32, Plane> {
        let pressure = |at: [f64; 3]| self.at((at[1] - middle[1]).atan2(at[0] - middle[0]), at[2]);
        let areas = weighted_areas(mesh, faces, PARTS, &pressure);
        areas.into_iter().map(|(node, [x, y, _])| (node, [-x, -y])).collect()
    }
}

/// Forces on nodes, turned and stretched together so that their sum is this one exactly [N]; none where they have no sum to stretch.
pub(crate) fn summing_to(forces: &BTreeMap<u32, Plane>, wanted: Plane) -> Option<BTreeMap<u32, Plane>> {
    let [x, y] = forces.values().fold([0.0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]]);
    let size = x * x + y * y;
    let wanted_size = wanted[0].hypot(wanted[1]);
    if size.sqrt() <= 1e-9 * wanted_size || size == 0.0 {
        return None;
    }
    // As complex numbers: every force times wanted / sum.
    let (re, im) = ((wanted[0] * x + wanted[1] * y) / size, (wanted[1] * x - wanted[0] * y) / size);
    Some(forces.iter().map(|(node, [p, q])| (*node, [re * p - im * q, re * q + im * p])).collect())
}
