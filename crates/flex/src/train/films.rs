//! What a film does along an orbit: its largest pressure, from the film solved directly.

use super::law::TrainLaw;
use super::plane::{Plane, length};
use lanchester_film::{FilmError, FilmGrid, FilmProblem, FilmSolution, FilmSolver, JournalMotion};

/// Cells around, and along half the length.
const CELLS: (usize, usize) = (120, 12);

/// A journal at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmInstant {
    /// Journal centre from bearing centre [m].
    pub eccentricity: Plane,
    /// Its rate [m/s].
    pub rate: Plane,
    /// Mean angular speed of both surfaces [rad/s].
    pub entrainment: f64,
}

/// The film of a law at an instant solved directly, with the solver that has its pressure; none of a bearing without film. Cells around, and along half the length.
///
/// # Errors
/// [`FilmError`] for a bearing or an eccentricity out of range.
pub(crate) fn solved_film(
    law: &TrainLaw,
    instant: &FilmInstant,
    cells: (usize, usize),
) -> Result<Option<(FilmSolver, FilmSolution)>, FilmError> {
    let TrainLaw::Film { bearing, table, viscosity, .. } = law else { return Ok(None) };
    let problem = FilmProblem {
        bearing: *bearing,
        viscosity: *viscosity,
        motion: JournalMotion {
            eccentricity: instant.eccentricity,
            velocity: instant.rate,
            entrainment: instant.entrainment,
            sliding: 0.0,
        },
        tilt: [0.0, 0.0],
        cavitation: table.cavitation(),
        feeds: Vec::new(),
    };
    let ratio = instant.eccentricity.map(|part| part / bearing.clearance);
    let mut solver = FilmSolver::new(FilmGrid::graded(cells.0, cells.1, true, ratio)?)?;
    let film = solver.solve(&problem)?;
    Ok(Some((solver, film)))
}

/// Largest pressure [Pa] of a film along instants, and the index of its instant; none of a bearing without film. Solved at so many instants spread over all, and at that
/// of the least film.
///
/// # Errors
/// [`FilmError`] for a bearing out of range.
pub fn largest_film_pressure(
    law: &TrainLaw,
    instants: &[FilmInstant],
    solved: usize,
) -> Result<Option<(f64, usize)>, FilmError> {
    let size = |k: &usize| length(instants[*k].eccentricity);
    let Some(least) = (0..instants.len()).max_by(|a, b| size(a).total_cmp(&size(b))) else { return Ok(None) };
    let stride = instants.len().div_ceil(solved.max(1)).max(1);
    let mut best: Option<(f64, usize)> = None;
    for k in (0..instants.len()).step_by(stride).chain([least]) {
        let Some((_, film)) = solved_film(law, &instants[k], CELLS)? else { return Ok(None) };
        if best.is_none_or(|(most, _)| film.largest_pressure > most) {
            best = Some((film.largest_pressure, k));
        }
    }
    Ok(best)
}
