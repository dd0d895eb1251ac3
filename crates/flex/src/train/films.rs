//! What a film does along an orbit: its largest pressure, from the film solved directly.

use super::law::{KeptTilt, TrainLaw};
use super::plane::{Plane, QUARTER, plus, times};
use lanchester_film::{
    FilmError, FilmGrid, FilmProblem, FilmSolution, FilmSolver, JournalMotion, TiltedMotion, tilted_pressure,
};

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
    /// How much further the end of the journal lies than its middle [m], and the rate of that [m/s]: of films of tilted journals alone.
    pub tilt: [Plane; 2],
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
    let furthest = |own: &FilmInstant| {
        let ([x, y], [a, b]) = (own.eccentricity, own.tilt[0]);
        super::spot::furthest(&[x, y, a, b])
    };
    let size = |k: &usize| furthest(&instants[*k]);
    let Some(least) = (0..instants.len()).max_by(|a, b| size(a).total_cmp(&size(b))) else { return Ok(None) };
    let stride = instants.len().div_ceil(solved.max(1)).max(1);
    let mut best: Option<(f64, usize)> = None;
    for k in (0..instants.len()).step_by(stride).chain([least]) {
        let pressure = match tilted(law, &instants[k])? {
            Some(pressure) => pressure,
            None => {
                let Some((_, film)) = solved_film(law, &instants[k], CELLS)? else { return Ok(None) };
                film.largest_pressure
            }
        };
        if best.is_none_or(|(most, _)| pressure > most) {
            best = Some((pressure, k));
        }
    }
    Ok(best)
}

/// Largest pressure [Pa] of the film of a tilted journal; none of another law.
fn tilted(law: &TrainLaw, own: &FilmInstant) -> Result<Option<f64>, FilmError> {
    let TrainLaw::TiltedFilm { bearing, viscosity, .. } = law else { return Ok(None) };
    let [tilt, tilt_rate] = own.tilt;
    let over = |e: Plane| e.map(|part| part / bearing.clearance);
    // Beyond the shell there is no pressure to tell of.
    let Some(kept) = KeptTilt::new(over(own.eccentricity), over(tilt)) else { return Ok(Some(f64::NAN)) };
    let closing = |e: Plane, rate: Plane| plus(rate, -own.entrainment, times(&QUARTER, e));
    let motion = TiltedMotion {
        eccentricity: over(own.eccentricity),
        tilt: kept.tilt,
        closing: closing(own.eccentricity, own.rate),
        closing_by_tilt: closing(tilt, tilt_rate),
    };
    Ok(Some(bearing.pressure_scale(*viscosity) * tilted_pressure(bearing.slenderness(), &motion)?))
}
