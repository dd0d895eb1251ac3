//! Orbit of a journal under a periodic load.
//!
//! Quasi-static (no mass; Booker's mobility method): the film's force balances the load at every instant, `e' = w_m z x e + v(e, -load)`, v from the
//! inverted table. Dynamic: `m e'' = load + film + contact`. Both by Radau IIA, since mobility and damping span many decades.

use crate::bearing::{JournalBearing, JournalMotion, check_viscosity};
use crate::contact::contact_force;
use crate::error::{FilmError, require};
use crate::grid::FilmGrid;
use crate::plane::{Plane, add, direction, length, quarter};
use crate::problem::FilmProblem;
use crate::solution::FilmSolution;
use crate::solver::FilmSolver;
use crate::table::FilmTable;
use lanchester_numerics::{Outcome, Radau5, Settings, Step, System};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;

/// Most periods until the orbit repeats.
const MOST_PERIODS: usize = 30;
/// Change of the orbit from period to period, over the clearance, that counts as none.
pub(crate) const REPEATS: f64 = 1e-3;
/// Instants at which pressure, friction and flow are taken.
const INSTANTS: usize = 120;
/// Films of these: cells around and along half the length.
const CELLS: (usize, usize) = (120, 12);
/// Instants and cells, around and along the whole length, of a journal whose axis is tilted.
const TILTED_INSTANTS: usize = 40;
const TILTED_CELLS: (usize, usize) = (96, 16);
/// Eccentricity ratio at an end from which on a tilted journal touches there.
const TOUCHES: f64 = 0.9995;

/// What acts on a journal over one period, at equally spaced instants from 0, the end excluded, in a frame that does not turn.
#[derive(Debug, Clone, PartialEq)]
pub struct JournalCycle {
    /// Duration of the period [s].
    pub duration: f64,
    /// Load on the journal [N].
    pub load: Vec<Plane>,
    /// Mean of the angular speeds of journal and shell [rad/s].
    pub entrainment: Vec<f64>,
    /// Journal's less shell's angular speed [rad/s].
    pub sliding: Vec<f64>,
}

/// What an orbit is computed of.
#[derive(Debug, Clone, Copy)]
pub struct OrbitRequest<'a> {
    /// The bearing.
    pub bearing: JournalBearing,
    /// Its table: same length over diameter.
    pub table: &'a FilmTable,
    /// Viscosity [Pa s].
    pub viscosity: f64,
    /// Load and speeds.
    pub cycle: &'a JournalCycle,
    /// Composite roughness [m], 0: no contact.
    pub roughness: f64,
    /// Mass that the journal moves with [kg]; `None`: quasi-static.
    pub mass: Option<f64>,
}

/// How an orbit ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OrbitOutcome {
    /// It repeats within a thousandth of the clearance.
    Periodic,
    /// It does not after the most periods allowed; the last one is given.
    NotPeriodic,
    /// The integration ended early: the film has no thickness left for this load.
    Overloaded,
}

/// The orbit over one period, and what the film does on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct FilmOrbit {
    /// How it ended.
    pub outcome: OrbitOutcome,
    /// Periods integrated.
    pub periods: usize,
    /// Largest change from the last period but one, over the clearance.
    pub change: f64,
    /// Journal centre at every instant of the load [m].
    pub eccentricity: Vec<Plane>,
    /// Least film [m].
    pub least_film: f64,
    /// Instant of the least film, over the period.
    pub least_film_at: f64,
    /// Direction of the least film [rad].
    pub least_film_angle: f64,
    /// Least film at an end of the bearing [m], where the journal's axis is tilted; below 0 where that end would touch. `None`: parallel axes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least_edge_film: Option<f64>,
    /// Largest film pressure [Pa] and its instant over the period.
    pub largest_pressure: f64,
    /// Instant of the largest pressure, over the period.
    pub largest_pressure_at: f64,
    /// Friction power, mean over the period [W]: torques and motion of the journal, contact left out.
    pub friction_power: f64,
    /// The same with shear only where there is pressure [W]: the bound from below, of a shell that is empty elsewhere.
    #[serde(default)]
    pub friction_power_of_pressure_part: f64,
    /// Oil that leaves at the ends, mean [m3/s].
    pub side_flow: f64,
    /// Oil that grooves and holes give, mean [m3/s]; 0 where the film has none.
    #[serde(default)]
    pub feed_flow: f64,
    /// Share of the period with contact of the roughness.
    pub contact_time: f64,
    /// Largest share of the load that contact takes.
    pub contact_share: f64,
    /// Largest difference of the table's force from that of the film solved directly, over the load; 0 where every film of the orbit is solved directly.
    pub table_error: f64,
    /// Steps of the integrator.
    pub steps: u64,
}

impl FilmOrbit {
    /// Least film at the middle or, where the journal is tilted, at an end of the bearing [m].
    pub fn least_anywhere(&self) -> f64 {
        self.least_edge_film.map_or(self.least_film, |edge| edge.min(self.least_film))
    }
}

struct Orbit<'a> {
    request: OrbitRequest<'a>,
    scale: f64,
}

/// The periodic cubic through `n` samples at a place over the period: four samples with their weights.
pub(crate) fn cubic(s: f64, n: usize) -> [(usize, f64); 4] {
    let place = s.rem_euclid(1.0) * n as f64;
    let i = (place as usize).min(n - 1);
    let t = place - i as f64;
    let weights = [
        -0.5 * t * (1.0 - t) * (1.0 - t),
        1.0 + t * t * (1.5 * t - 2.5),
        t * (0.5 + t * (2.0 - 1.5 * t)),
        -0.5 * t * t * (1.0 - t),
    ];
    [0, 1, 2, 3].map(|k| ((i + n + k - 1) % n, weights[k]))
}

impl JournalCycle {
    /// Mean of the angular speeds at a place over the period [rad/s].
    pub(crate) fn entrainment_at(&self, s: f64) -> f64 {
        cubic(s, self.entrainment.len()).iter().map(|(i, weight)| weight * self.entrainment[*i]).sum()
    }
}

impl Orbit<'_> {
    fn load(&self, s: f64) -> Plane {
        let load = &self.request.cycle.load;
        let four = cubic(s, load.len());
        [0, 1].map(|k| four.iter().map(|(i, weight)| weight * load[*i][k]).sum())
    }

    /// Contact on the journal [N].
    fn contact(&self, ratio: Plane) -> Plane {
        let (along, size) = direction(ratio);
        let force = contact_force(&self.request.bearing, self.request.roughness, size);
        along.map(|part| -force * part)
    }

    /// e' [m/s] of the quasi-static journal.
    fn quasi_static(&self, s: f64, ratio: Plane) -> Result<Plane, FilmError> {
        let contact = self.contact(ratio);
        let film = add(self.load(s).map(|l| -l), -1.0, contact);
        let v = self.request.table.velocity(ratio, film.map(|f| f / self.scale))?;
        let speed = self.request.cycle.entrainment_at(s) * self.request.bearing.clearance;
        Ok(add(v, speed, quarter(ratio)))
    }
}

impl System for Orbit<'_> {
    fn dimension(&self) -> usize {
        if self.request.mass.is_some() { 4 } else { 2 }
    }

    fn derivative(&mut self, s: f64, y: &[f64], derivative: &mut [f64]) {
        let ratio = [y[0], y[1]];
        let (c, duration) = (self.request.bearing.clearance, self.request.cycle.duration);
        derivative.fill(f64::NAN);
        match self.request.mass {
            None => {
                if let Ok(velocity) = self.quasi_static(s, ratio) {
                    derivative.copy_from_slice(&velocity.map(|v| v * duration / c));
                }
            }
            Some(mass) => {
                // State: e/c and its rate per period.
                let rate = [y[2], y[3]].map(|part| part * c / duration);
                let speed = self.request.cycle.entrainment_at(s) * c;
                let v = add(rate, -speed, quarter(ratio));
                if let Ok(film) = self.request.table.impedance(ratio, v) {
                    let contact = self.contact(ratio);
                    let load = self.load(s);
                    for k in 0..2 {
                        derivative[k] = y[2 + k];
                        derivative[2 + k] =
                            (load[k] + contact[k] + film.force[k] * self.scale) / mass * duration * duration
                                / c;
                    }
                }
            }
        }
    }
}

/// Orbit of a journal under a periodic load, and the film along it.
///
/// # Errors
/// [`FilmError`] for a bearing or viscosity out of range, a table of another length, a load of fewer than 16 samples, no speed at all.
pub fn journal_orbit(request: &OrbitRequest) -> Result<FilmOrbit, FilmError> {
    let Traced { system, orbit, outcome, periods, change, steps } = trace(request)?;
    let mut found = match request.mass {
        None => films(&system, &orbit, None)?,
        Some(_) => {
            let (n, step) = (orbit.len(), 2.0 * request.cycle.duration / orbit.len() as f64);
            let velocity = |i: usize| {
                let (before, after) = (orbit[(i + n - 1) % n], orbit[(i + 1) % n]);
                [0, 1].map(|k| (after[k] - before[k]) / step * request.bearing.clearance)
            };
            let velocities: Vec<Plane> = (0..n).map(velocity).collect();
            films(&system, &orbit, Some(Along { velocities: &velocities, slopes: None, reached: n }))?
        }
    };
    found.outcome = outcome;
    (found.periods, found.change, found.steps) = (periods, change, steps);
    Ok(found)
}

/// The least film of an orbit, without what only films solved directly along it tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastFilm {
    /// How the orbit ended.
    pub outcome: OrbitOutcome,
    /// Least film [m].
    pub thickness: f64,
    /// Its instant over the period.
    pub at: f64,
}

/// The least film of [`journal_orbit`], to the last bit, in a small part of its time.
///
/// # Errors
/// As [`journal_orbit`].
pub fn orbit_least_film(request: &OrbitRequest) -> Result<LeastFilm, FilmError> {
    let Traced { orbit, outcome, .. } = trace(request)?;
    let least = farthest(&orbit);
    let thickness = request.bearing.clearance * (1.0 - length(orbit[least]));
    Ok(LeastFilm { outcome, thickness, at: least as f64 / orbit.len() as f64 })
}

/// An orbit as it was integrated.
struct Traced<'a> {
    system: Orbit<'a>,
    /// Eccentricity over clearance at every instant of the load.
    orbit: Vec<Plane>,
    outcome: OrbitOutcome,
    periods: usize,
    change: f64,
    steps: u64,
}

fn trace<'a>(request: &OrbitRequest<'a>) -> Result<Traced<'a>, FilmError> {
    let (bearing, cycle) = (&request.bearing, request.cycle);
    check(request)?;
    let mut system = Orbit { request: *request, scale: bearing.force_scale(request.viscosity) };
    let mut state = vec![0.0; system.dimension()];
    let apart = |a: &Plane, b: &Plane| length([a[0] - b[0], a[1] - b[1]]);
    let found = repeated(&mut system, &mut state, cycle.load.len(), MOST_PERIODS, apart, |_| ());
    let Repeated { states: orbit, outcome, periods, change, steps, .. } = found;
    Ok(Traced { system, orbit, outcome, periods, change, steps })
}

/// Periods that were integrated until they repeat.
pub(crate) struct Repeated<const D: usize> {
    /// The first components of the state at every instant of the last period; where it ended early, those before it at the rest.
    pub states: Vec<[f64; D]>,
    pub outcome: OrbitOutcome,
    pub periods: usize,
    pub change: f64,
    pub steps: u64,
    /// How many instants the last period reached.
    pub reached: usize,
}

/// Integrates period after period, each of length 1, until `apart` two neighbouring ones is less than [`REPEATS`] at every one of `n` instants; `watch` is shown
/// every step. The first half of a state with rates, or all of one without, has the tolerance of a place.
pub(crate) fn repeated<const D: usize>(
    system: &mut impl System,
    state: &mut [f64],
    n: usize,
    most: usize,
    apart: impl Fn(&[f64; D], &[f64; D]) -> f64,
    mut watch: impl FnMut(&Step),
) -> Repeated<D> {
    let mut settings = Settings::uniform(state.len(), 1e-5);
    settings.longest_step = 0.02;
    settings.most_evaluations = 3_000_000;
    let places = if state.len() > 2 { state.len() / 2 } else { state.len() };
    settings.absolute.iter_mut().skip(places).for_each(|absolute| *absolute = 1e-3);
    let mut integrator = Radau5::new(settings);
    let mut states = vec![[0.0; D]; n];
    let (mut change, mut periods, mut outcome) = (f64::INFINITY, 0, OrbitOutcome::NotPeriodic);
    let mut reached = n;
    while periods < most {
        let (mut s, mut next) = (periods as f64, 0);
        let start = s;
        let mut now = vec![[0.0; D]; n];
        let end = integrator.run(system, &mut s, state, start + 1.0, |step| {
            watch(step);
            while next < n && start + next as f64 / n as f64 <= step.to {
                let at = start + next as f64 / n as f64;
                now[next] = std::array::from_fn(|k| step.component(k, at));
                next += 1;
            }
            ControlFlow::Continue(())
        });
        periods += 1;
        if end != Outcome::Reached {
            outcome = OrbitOutcome::Overloaded;
            states[..next].copy_from_slice(&now[..next]);
            reached = next;
            break;
        }
        change = states.iter().zip(&now).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
        states = now;
        if periods > 1 && change < REPEATS {
            outcome = OrbitOutcome::Periodic;
            break;
        }
    }
    Repeated { states, outcome, periods, change, steps: integrator.statistics().steps, reached }
}

/// Index of the largest eccentricity.
fn farthest(orbit: &[Plane]) -> usize {
    (0..orbit.len()).max_by(|a, b| length(orbit[*a]).total_cmp(&length(orbit[*b]))).unwrap_or(0)
}

/// Refuses what no orbit can be computed of.
pub(crate) fn check_cycle(
    bearing: &JournalBearing,
    cycle: &JournalCycle,
    roughness: f64,
) -> Result<(), FilmError> {
    bearing.check()?;
    let n = cycle.load.len();
    let fewest = n.min(cycle.entrainment.len()).min(cycle.sliding.len());
    if fewest < 16 || fewest < n {
        return Err(FilmError::Samples { needed: n.max(16), got: fewest });
    }
    require(cycle.duration > 0.0, "duration of the period [s]", "above 0", cycle.duration)?;
    let numbers = cycle.load.iter().flatten().chain(&cycle.entrainment).chain(&cycle.sliding);
    for number in numbers {
        require(number.is_finite(), "load [N] and speed [rad/s] over the period", "finite numbers", *number)?;
    }
    let mean = cycle.entrainment.iter().sum::<f64>() / n as f64;
    if mean == 0.0 {
        return Err(FilmError::NoSpeed { speed: mean });
    }
    require(roughness >= 0.0, "composite roughness [m]", "0 or above", roughness)
}

fn check(request: &OrbitRequest) -> Result<(), FilmError> {
    check_viscosity(request.viscosity)?;
    check_cycle(&request.bearing, request.cycle, request.roughness)?;
    require(
        request.mass.is_none_or(|mass| mass > 0.0),
        "mass at the journal [kg]",
        "above 0",
        request.mass.unwrap_or(1.0),
    )?;
    let own = request.bearing.slenderness();
    require(
        (request.table.slenderness() / own - 1.0).abs() < 1e-6,
        "length over diameter of the table",
        "that of the bearing",
        request.table.slenderness(),
    )
}

/// How a journal moves along its orbit.
#[derive(Clone, Copy)]
pub(crate) struct Along<'a> {
    /// Its velocity at every instant [m/s].
    pub velocities: &'a [Plane],
    /// The slope of its axis at every instant [rad], where it counts.
    pub slopes: Option<&'a [Plane]>,
    /// How many instants the orbit has reached.
    pub reached: usize,
}

/// Film along an orbit of eccentricity ratios whose motion is known.
///
/// # Errors
/// [`FilmError`] where a film cannot be solved.
pub(crate) fn films_along(
    request: &OrbitRequest,
    orbit: &[Plane],
    along: Along,
) -> Result<FilmOrbit, FilmError> {
    let system = Orbit { request: *request, scale: request.bearing.force_scale(request.viscosity) };
    films(&system, orbit, Some(along))
}

/// Film along an orbit; without a known motion that of the quasi-static journal.
fn films(system: &Orbit, orbit: &[Plane], along: Option<Along>) -> Result<FilmOrbit, FilmError> {
    let request = &system.request;
    let (bearing, cycle) = (&request.bearing, request.cycle);
    let slopes = along.and_then(|along| along.slopes);
    let reached = along.map_or(orbit.len(), |along| along.reached.min(orbit.len()));
    // How much further the axis lies at the end +L/2, over the clearance.
    let tilt = |i: usize| {
        let slope = slopes.map_or([0.0; 2], |slopes| slopes[i]);
        slope.map(|part| 0.5 * bearing.length * part / bearing.clearance)
    };
    let edge = |i: usize| {
        let reach = [1.0, -1.0].map(|sign| length(add(orbit[i], sign, tilt(i))));
        reach[0].max(reach[1])
    };
    let n = orbit.len();
    let least = farthest(&orbit[..reached]);
    let mut found = FilmOrbit {
        outcome: OrbitOutcome::NotPeriodic,
        periods: 0,
        change: 0.0,
        eccentricity: orbit.iter().map(|e| e.map(|part| part * bearing.clearance)).collect(),
        least_film: bearing.clearance * (1.0 - length(orbit[least])),
        least_film_at: least as f64 / n as f64,
        least_film_angle: orbit[least][1].atan2(orbit[least][0]),
        least_edge_film: slopes
            .map(|_| bearing.clearance * (1.0 - (0..reached).map(edge).fold(0.0, f64::max))),
        largest_pressure: 0.0,
        largest_pressure_at: 0.0,
        friction_power: 0.0,
        friction_power_of_pressure_part: 0.0,
        side_flow: 0.0,
        feed_flow: 0.0,
        contact_time: 0.0,
        contact_share: 0.0,
        table_error: 0.0,
        steps: 0,
    };
    let largest_load = cycle.load.iter().map(|load| length(*load)).fold(0.0, f64::max);
    let motion = |i: usize| -> Result<JournalMotion, FilmError> {
        let velocity = match along {
            None => system.quasi_static(i as f64 / n as f64, orbit[i])?,
            Some(along) => along.velocities[i],
        };
        Ok(JournalMotion {
            eccentricity: orbit[i].map(|part| part * bearing.clearance),
            velocity,
            entrainment: cycle.entrainment[i],
            sliding: cycle.sliding[i],
        })
    };
    let solve = |i: usize, tilt: Plane| -> Result<FilmSolution, FilmError> {
        let problem = FilmProblem {
            bearing: *bearing,
            viscosity: request.viscosity,
            motion: motion(i)?,
            tilt,
            cavitation: request.table.cavitation(),
            feeds: Vec::new(),
        };
        let grid = match problem.is_symmetric() {
            true => FilmGrid::graded(CELLS.0, CELLS.1, true, orbit[i])?,
            false => FilmGrid::graded(TILTED_CELLS.0, TILTED_CELLS.1, false, orbit[i])?,
        };
        FilmSolver::new(grid)?.solve(&problem)
    };
    let spread = |count: usize| (0..count.min(n)).map(move |k| k * n / count.min(n)).filter(|i| *i < reached);
    let mut instants: Vec<usize> =
        spread(if slopes.is_some() { TILTED_INSTANTS } else { INSTANTS }).collect();
    let regular = instants.len() as f64;
    instants.push(least);
    if slopes.is_some() {
        // The peak lies between few instants: parallel axes tell where.
        let mut most = (least, 0.0);
        for i in spread(INSTANTS) {
            let pressure = solve(i, [0.0; 2])?.largest_pressure;
            if pressure > most.1 {
                most = (i, pressure);
            }
        }
        let near = (n / INSTANTS / 2).max(1);
        instants.extend(
            [most.0.saturating_sub(near), most.0, most.0 + near].into_iter().filter(|i| *i < reached),
        );
    }
    for (k, &i) in instants.iter().enumerate() {
        let (s, at) = (i as f64 / n as f64, orbit[i]);
        let contact = system.contact(at);
        // A journal that touches at its end has no film there: parallel axes then.
        let tilt = if edge(i) < TOUCHES { tilt(i).map(|part| part * bearing.clearance) } else { [0.0; 2] };
        let film = solve(i, tilt)?;
        if film.largest_pressure > found.largest_pressure {
            (found.largest_pressure, found.largest_pressure_at) = (film.largest_pressure, s);
        }
        let load = length(cycle.load[i]);
        if load > 0.0 {
            // Of a shaft the load is that of the film itself, and passes near zero.
            let over = if slopes.is_some() { largest_load } else { load };
            let table = request.table.impedance(at, motion(i)?.closing())?.force.map(|f| f * system.scale);
            found.table_error = found.table_error.max(length(add(table, -1.0, film.force)) / over);
            found.contact_share = found.contact_share.max(length(contact) / load);
        }
        if (k as f64) < regular {
            found.friction_power += film.power / regular;
            found.friction_power_of_pressure_part += film.power_of_pressure_part / regular;
            found.side_flow += film.side_flow / regular;
            found.contact_time += if length(contact) > 0.0 { 1.0 / regular } else { 0.0 };
        }
    }
    Ok(found)
}
