//! Orbit of a journal whose film is solved itself at every instant: grooves and holes with their supply pressure, and films that keep their oil.
//!
//! Quasi-static, in the shell's frame, in equal steps of time that are the samples of the load. A step's eccentricity `x = e/c` is the root of
//! ```text
//! F_film(x, x') + F_contact(x) + load = 0        x' = (3 x - 4 x_1 + x_2)/(2 dt)                 x_1, x_2: one and two steps before
//! ```
//! by Newton's method. A film that keeps its oil has the emptiness r of every cell as a further unknown, which goes with `d(H r)/dt` by the same
//! formula, so that oil is neither made nor lost from step to step. (Jakobsson, Floberg, Trans. Chalmers 190 (1957); Olsson, Trans. Chalmers 308 (1965).)

use crate::bearing::{JournalBearing, JournalMotion, VISCOSITY};
use crate::cavitation::Cavitation;
use crate::contact::contact_force;
use crate::error::FilmError;
use crate::grid::FilmGrid;
use crate::orbit::{FilmOrbit, JournalCycle, OrbitOutcome, REPEATS, check_cycle};
use crate::plane::{Plane, add, cross, direction, dot, length};
use crate::problem::{Feed, FilmProblem};
use crate::solution::FilmSolution;
use crate::solver::FilmSolver;

/// Most periods until the orbit repeats.
const MOST_PERIODS: usize = 20;
/// Cells around the film, and along half its length.
const CELLS: (usize, usize) = (96, 8);
/// Eccentricity over clearance up to which a step may go: what is beyond it touches.
const FARTHEST: f64 = 0.9995;
/// Share of the load that may be out of balance, and of the largest load where that is more.
const BALANCED: [f64; 2] = [1e-6, 1e-8];
/// Corrections of a step, and halvings of a correction that does not help.
const MOST_CORRECTIONS: usize = 40;
const MOST_HALVINGS: usize = 12;
/// Instants over which the load grows at the very first.
const RAMP: f64 = 24.0;
/// Difference of the eccentricity ratio by which the film's stiffness is taken.
const DIFFERENCE: f64 = 1e-7;

/// What such an orbit is computed of.
#[derive(Debug, Clone, Copy)]
pub struct DirectRequest<'a> {
    /// The bearing.
    pub bearing: JournalBearing,
    /// Cavitation; with [`Cavitation::MassConserving`] the film keeps its oil from step to step.
    pub cavitation: Cavitation,
    /// Load and speeds, in a frame that does not turn.
    pub cycle: &'a JournalCycle,
    /// Angle of the shell at every instant of the load [rad]; empty: it does not turn.
    pub shell: &'a [f64],
    /// Grooves and holes, in the shell's frame.
    pub feeds: &'a [Feed],
    /// Composite roughness [m], 0: no contact.
    pub roughness: f64,
}

/// The journal and its film as they are after a step; another run goes on from here.
#[derive(Debug, Clone)]
pub struct DirectOrbit<'a> {
    request: DirectRequest<'a>,
    /// The film at the instant in question.
    problem: FilmProblem,
    solver: FilmSolver,
    /// Eccentricity ratios in the shell's frame, now and one step before.
    places: [Plane; 2],
    /// H r of every cell, now and one step before.
    empty: [Vec<f64>; 2],
    largest_load: f64,
    /// Change of what is out of balance [N] by the eccentricity ratio, by rows.
    stiffness: Option<[Plane; 2]>,
    /// Whether a first period is behind it.
    is_begun: bool,
}

/// What balances the load at an instant.
struct Balance {
    out: Plane,
    film: FilmSolution,
    contact: Plane,
}

impl<'a> DirectOrbit<'a> {
    /// A journal at rest in the middle of a flooded bearing.
    ///
    /// # Errors
    /// [`FilmError`] as [`crate::journal_orbit`], and for grooves and holes as [`FilmProblem::check`].
    pub fn new(request: &DirectRequest<'a>) -> Result<DirectOrbit<'a>, FilmError> {
        check_cycle(&request.bearing, request.cycle, request.roughness)?;
        let (needed, got) = (request.cycle.load.len(), request.shell.len());
        if got != 0 && got != needed {
            return Err(FilmError::Samples { needed, got });
        }
        // Viscosity and motion are those of each instant.
        let problem = FilmProblem {
            bearing: request.bearing,
            viscosity: VISCOSITY[1],
            motion: JournalMotion::default(),
            tilt: [0.0, 0.0],
            cavitation: request.cavitation,
            feeds: request.feeds.to_vec(),
        };
        problem.check()?;
        let half = problem.is_symmetric();
        let grid = FilmGrid::uniform(CELLS.0, if half { CELLS.1 } else { 2 * CELLS.1 }, half, 0.0)?;
        let cells = grid.around() * grid.axial;
        let largest_load = request.cycle.load.iter().map(|load| length(*load)).fold(0.0, f64::max);
        Ok(DirectOrbit {
            request: *request,
            problem,
            solver: FilmSolver::new(grid)?,
            places: [[0.0; 2]; 2],
            empty: [vec![0.0; cells], vec![0.0; cells]],
            largest_load,
            stiffness: None,
            is_begun: false,
        })
    }

    /// Load at instant `i` [N]; at the very first it grows from next to nothing, for the journal begins in the middle.
    fn load(&self, i: usize) -> Plane {
        let share = if self.is_begun { 1.0 } else { ((i + 1) as f64 / RAMP).min(1.0) };
        self.request.cycle.load[i].map(|part| share * part)
    }

    fn shell(&self, i: usize) -> f64 {
        self.request.shell.get(i).copied().unwrap_or(0.0)
    }

    /// A step's time [s].
    fn step(&self) -> f64 {
        self.request.cycle.duration / self.request.cycle.load.len() as f64
    }

    /// What is out of balance [N] with the journal at `x` at instant `i`.
    fn balance(&mut self, viscosity: f64, i: usize, x: Plane) -> Result<Balance, FilmError> {
        let (c, dt) = (self.request.bearing.clearance, self.step());
        let [now, before] = self.places;
        let velocity = [0, 1].map(|k| c * (3.0 * x[k] - 4.0 * now[k] + before[k]) / (2.0 * dt));
        let sliding = self.request.cycle.sliding[i];
        self.problem.viscosity = viscosity;
        self.problem.motion = JournalMotion {
            eccentricity: x.map(|part| part * c),
            velocity,
            entrainment: 0.5 * sliding,
            sliding,
        };
        if self.request.cavitation == Cavitation::MassConserving {
            let [now, before] = &self.empty;
            let past = now.iter().zip(before).map(|(now, before)| (4.0 * now - before) / (2.0 * dt));
            self.solver.remember(1.5 / dt, past);
        }
        let film = self.solver.solve(&self.problem)?;
        let (along, size) = direction(x);
        let contact = contact_force(&self.request.bearing, self.request.roughness, size);
        let contact = along.map(|part| -contact * part);
        let load = turned(self.load(i), -self.shell(i));
        Ok(Balance { out: add(add(film.force, 1.0, contact), 1.0, load), film, contact })
    }

    /// The eccentricity ratio at instant `i`; `None` where no film carries the load.
    fn place(&mut self, viscosity: f64, i: usize) -> Result<Option<(Plane, Balance)>, FilmError> {
        let [now, before] = self.places;
        // As the journal went on so far, if that leaves a film; else from where it is, or was nearer the middle.
        let ahead = add(now.map(|part| 2.0 * part), -1.0, before);
        for start in [ahead, now, now.map(|part| 0.95 * part)] {
            if length(start) < FARTHEST
                && let Some(found) = self.place_from(viscosity, i, start)?
            {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// The same from a first guess.
    fn place_from(
        &mut self,
        viscosity: f64,
        i: usize,
        mut x: Plane,
    ) -> Result<Option<(Plane, Balance)>, FilmError> {
        let enough = (BALANCED[0] * length(self.load(i))).max(BALANCED[1] * self.largest_load);
        let mut found = self.balance(viscosity, i, x)?;
        // Stiffness of the step before; it is taken anew where it no longer helps.
        let mut is_new = false;
        for _ in 0..MOST_CORRECTIONS {
            if length(found.out) <= enough {
                return Ok(found.film.converged.then_some((x, found)));
            }
            let stiffness = match self.stiffness {
                Some(stiffness) => stiffness,
                None => {
                    is_new = true;
                    self.stiffness_at(viscosity, i, x, found.out)?
                }
            };
            let better = match correction(stiffness, found.out) {
                Some(by) => self.better(viscosity, i, (x, found.out), by, is_new)?,
                None => None,
            };
            let Some((next, trial)) = better else {
                self.stiffness = None;
                if is_new {
                    return Ok(None);
                }
                continue;
            };
            // Broyden's formula.
            let (moved, changed) = (add(next, -1.0, x), add(trial.out, -1.0, found.out));
            let size = dot(moved, moved);
            let missing = [0, 1].map(|row| changed[row] - dot(stiffness[row], moved));
            self.stiffness = Some([0, 1].map(|row| add(stiffness[row], missing[row] / size, moved)));
            is_new = false;
            (x, found) = (next, trial);
        }
        self.stiffness = None;
        Ok(None)
    }

    /// Change of what is out of balance by the eccentricity ratio, by rows, from differences.
    fn stiffness_at(
        &mut self,
        viscosity: f64,
        i: usize,
        x: Plane,
        out: Plane,
    ) -> Result<[Plane; 2], FilmError> {
        let mut rows = [[0.0; 2]; 2];
        for k in 0..2 {
            // Inwards: the film is not to be lost.
            let by = if x[k] > 0.0 { -DIFFERENCE } else { DIFFERENCE };
            let mut near = x;
            near[k] += by;
            let other = self.balance(viscosity, i, near)?;
            for (row, other, out) in [(0, other.out[0], out[0]), (1, other.out[1], out[1])] {
                rows[row][k] = (other - out) / by;
            }
        }
        Ok(rows)
    }

    /// A place on the way `by` from `x` that is less out of balance: half as much at first sight, less after halvings where the stiffness is new.
    fn better(
        &mut self,
        viscosity: f64,
        i: usize,
        (x, out): (Plane, Plane),
        by: Plane,
        is_new: bool,
    ) -> Result<Option<(Plane, Balance)>, FilmError> {
        let mut share = 1.0;
        for halvings in 0..MOST_HALVINGS {
            let next = add(x, share, by);
            if length(next) < FARTHEST {
                let trial = self.balance(viscosity, i, next)?;
                let enough = if is_new { 1.0 } else { 0.5 };
                if length(trial.out) < enough * length(out) {
                    return Ok(Some((next, trial)));
                }
            }
            if !is_new && halvings > 0 {
                return Ok(None);
            }
            share *= 0.5;
        }
        Ok(None)
    }

    /// The orbit with this viscosity [Pa s], from where the journal is.
    ///
    /// # Errors
    /// [`FilmError::Viscosity`].
    pub fn run(&mut self, viscosity: f64) -> Result<FilmOrbit, FilmError> {
        let n = self.request.cycle.load.len();
        let mut orbit = vec![[0.0; 2]; n];
        let mut films = Films::default();
        let (mut change, mut outcome, mut periods) = (f64::INFINITY, OrbitOutcome::NotPeriodic, 0);
        let mut steps = 0;
        'periods: while periods < MOST_PERIODS {
            periods += 1;
            films = Films::default();
            let mut now = vec![[0.0; 2]; n];
            for (i, own) in now.iter_mut().enumerate() {
                let Some((x, found)) = self.place(viscosity, i)? else {
                    outcome = OrbitOutcome::Overloaded;
                    break 'periods;
                };
                // The film of this step is the solver's last but for the differences around it.
                let found = if self.request.cavitation == Cavitation::MassConserving {
                    let found_again = self.balance(viscosity, i, x)?;
                    self.keep_emptiness(x);
                    found_again
                } else {
                    found
                };
                films.add(i, length(self.request.cycle.load[i]), &found);
                self.places = [x, self.places[0]];
                *own = turned(x, self.shell(i));
                steps += 1;
            }
            self.is_begun = true;
            change = orbit.iter().zip(&now).map(|(a, b)| length(add(*a, -1.0, *b))).fold(0.0, f64::max);
            orbit = now;
            if periods > 1 && change < REPEATS {
                outcome = OrbitOutcome::Periodic;
                break;
            }
        }
        let clearance = self.request.bearing.clearance;
        let least = (0..n).max_by(|a, b| length(orbit[*a]).total_cmp(&length(orbit[*b]))).unwrap_or(0);
        Ok(FilmOrbit {
            outcome,
            periods,
            change,
            least_film: clearance * (1.0 - length(orbit[least])),
            least_film_at: least as f64 / n as f64,
            least_film_angle: orbit[least][1].atan2(orbit[least][0]),
            least_edge_film: None,
            largest_pressure: films.pressure,
            largest_pressure_at: films.pressure_at as f64 / n as f64,
            friction_power: films.power / n as f64,
            friction_power_of_pressure_part: films.power_of_pressure_part / n as f64,
            side_flow: films.side_flow / n as f64,
            feed_flow: films.feed_flow / n as f64,
            contact_time: films.contact_time / n as f64,
            contact_share: films.contact_share,
            table_error: 0.0,
            steps,
            eccentricity: orbit.into_iter().map(|x| x.map(|part| part * clearance)).collect(),
        })
    }

    /// Keeps H r of the solver's last film, with the journal at `x`.
    fn keep_emptiness(&mut self, x: Plane) {
        let grid = self.solver.grid();
        let axial = grid.axial;
        let heights = (0..grid.around()).map(|i| {
            let (sin, cos) = grid.angle(i).sin_cos();
            1.0 - x[0] * cos - x[1] * sin
        });
        let heights: Vec<f64> = heights.collect();
        let now = self.solver.emptiness().iter().enumerate().map(|(cell, r)| heights[cell / axial] * r);
        let now: Vec<f64> = now.collect();
        self.empty.swap(0, 1);
        self.empty[0] = now;
    }
}

/// Sums over the films of a period.
#[derive(Default)]
struct Films {
    pressure: f64,
    pressure_at: usize,
    power: f64,
    power_of_pressure_part: f64,
    side_flow: f64,
    feed_flow: f64,
    contact_time: f64,
    contact_share: f64,
}

impl Films {
    fn add(&mut self, i: usize, load: f64, found: &Balance) {
        if found.film.largest_pressure > self.pressure {
            (self.pressure, self.pressure_at) = (found.film.largest_pressure, i);
        }
        let contact = length(found.contact);
        if load > 0.0 {
            self.contact_share = self.contact_share.max(contact / load);
        }
        self.contact_time += if contact > 0.0 { 1.0 } else { 0.0 };
        self.power += found.film.power;
        self.power_of_pressure_part += found.film.power_of_pressure_part;
        self.side_flow += found.film.side_flow;
        self.feed_flow += found.film.feed_flow;
    }
}

/// The change that takes away what is out of balance, by Cramer's rule; `None` where the stiffness is singular.
fn correction([upper, lower]: [Plane; 2], out: Plane) -> Option<Plane> {
    let determinant = cross(upper, lower);
    let by = [
        (upper[1] * out[1] - lower[1] * out[0]) / determinant,
        (lower[0] * out[0] - upper[0] * out[1]) / determinant,
    ];
    by.iter().all(|part| part.is_finite()).then_some(by)
}

/// A vector turned by an angle [rad].
fn turned(a: Plane, by: f64) -> Plane {
    let (sin, cos) = by.sin_cos();
    [a[0] * cos - a[1] * sin, a[0] * sin + a[1] * cos]
}
