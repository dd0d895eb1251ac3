//! What a film does: force, moment, torques, power, flow, pressure.

use crate::cells::Cells;
use crate::grid::FilmGrid;
use crate::plane::{Plane, add, cross, dot};
use crate::problem::FilmProblem;
use serde::{Deserialize, Serialize};

/// Result of a film at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FilmSolution {
    /// Force of the film on the journal [N].
    pub force: Plane,
    /// Its moment about the middle of the bearing, across the axis [N m].
    pub moment: Plane,
    /// Torque on the journal about its own centre [N m], sheared over the whole turn (the empty share excepted).
    pub torque: f64,
    /// The same with shear only where there is pressure [N m].
    pub torque_of_pressure_part: f64,
    /// Torque on the shell about its centre [N m].
    pub shell_torque: f64,
    /// Work that force and torques do on the film [W].
    pub power: f64,
    /// The same with shear only where there is pressure [W].
    pub power_of_pressure_part: f64,
    /// Dissipation by shear and pressure flow [W]; equal to `power` but for Guembel's film, whose cut creates oil.
    pub dissipation: f64,
    /// Least film thickness [m], its angle [rad] and place along the axis from the middle [m].
    pub least_film: f64,
    /// Angle of the least film [rad].
    pub least_film_angle: f64,
    /// Place of the least film along the axis [m].
    pub least_film_place: f64,
    /// Largest pressure above that at the ends [Pa].
    pub largest_pressure: f64,
    /// Its angle [rad].
    pub largest_pressure_angle: f64,
    /// Its place along the axis from the middle [m].
    pub largest_pressure_place: f64,
    /// Centre of pressure along the axis from the middle [m].
    pub centre_of_pressure: f64,
    /// Oil that leaves over both ends [m3/s].
    pub side_flow: f64,
    /// Oil that feeds give [m3/s].
    pub feed_flow: f64,
    /// Sets that were solved.
    pub iterations: usize,
    /// Whether the set of cells under pressure was found.
    pub converged: bool,
}

impl FilmSolution {
    pub(crate) fn gather(
        grid: &FilmGrid,
        cells: &Cells,
        problem: &FilmProblem,
        p: &[f64],
        empty: &[f64],
        outflow: &[f64],
    ) -> FilmSolution {
        let (n, m) = (cells.around, cells.axial);
        let bearing = &problem.bearing;
        let motion = &problem.motion;
        let pressure = bearing.pressure_scale(problem.viscosity);
        let share = 1.0 / m as f64;
        let half = 0.5 * bearing.length;
        let tilted = problem.tilt != [0.0, 0.0];
        let (mut force, mut moment) = ([0.0; 2], [0.0; 2]);
        let (mut shear, mut shear_pressed, mut lever) = (0.0, 0.0, 0.0);
        let (mut side, mut feed, mut flow_work) = (0.0, 0.0, 0.0);
        let (mut weight, mut axial) = (0.0, 0.0);
        let (mut peak, mut peak_at) = (f64::NEG_INFINITY, (0, 0));
        for i in 0..n {
            let mut mean = 0.0;
            let mut off = 0.0;
            for j in 0..m {
                let cell = i * m + j;
                mean += p[cell];
                off += p[cell] * grid.place(j);
                if p[cell] > peak {
                    (peak, peak_at) = (p[cell], (i, j));
                }
                let thin = cells.width[i] / cells.thickness[cell];
                shear += thin * (1.0 - empty[cell]);
                shear_pressed += if p[cell] > 0.0 { thin } else { 0.0 };
                side += cells.end[cell] * p[cell];
                if cells.fixed[cell].is_some() {
                    feed += outflow[cell] - cells.source[cell];
                    // And what fills the emptiness that is carried into it.
                    let (upstream, face) = cells.upstream(motion.entrainment, cell);
                    feed += motion.entrainment.abs() * bearing.clearance * cells.face[face] * empty[upstream];
                }
                flow_work += p[cell] * outflow[cell];
                if tilted {
                    // Lever of the pressure about the bearing's centre, the tilt included.
                    let at = add(motion.eccentricity, grid.place(j), problem.tilt);
                    lever += p[cell] * cells.lever(at, i);
                }
            }
            if !tilted {
                lever += mean * cells.lever(motion.eccentricity, i);
            }
            force = add(force, -mean, cells.normal[i]);
            moment = add(moment, -off, cells.normal[i]);
            weight += mean;
            axial += off;
        }
        if grid.half {
            (moment, axial) = ([0.0, 0.0], 0.0);
        }
        let area = bearing.radius * bearing.length * share;
        let scale = pressure * area;
        let force = force.map(|part| part * scale);
        // z-hat x force at the place z.
        let moment = [-moment[1] * scale * half, moment[0] * scale * half];
        // e x F with the tilt's share: lever was taken of n, F is along -n.
        let couple = -lever * scale;
        let viscous = problem.viscosity * bearing.radius.powi(2) * area / bearing.clearance;
        let torque = |shear: f64| -viscous * motion.sliding * shear - 0.5 * couple;
        let power = |shear: f64| {
            viscous * motion.sliding.powi(2) * shear + motion.entrainment * couple
                - dot(force, motion.velocity)
        };
        let (least, angle, place) = least_film(problem, tilted);
        FilmSolution {
            force,
            moment,
            torque: torque(shear),
            torque_of_pressure_part: torque(shear_pressed),
            shell_torque: viscous * motion.sliding * shear - 0.5 * couple,
            power: power(shear),
            power_of_pressure_part: power(shear_pressed),
            dissipation: viscous * motion.sliding.powi(2) * shear + scale * flow_work,
            least_film: least,
            least_film_angle: angle,
            least_film_place: place,
            largest_pressure: peak * pressure,
            largest_pressure_angle: grid.angle(peak_at.0),
            largest_pressure_place: grid.place(peak_at.1) * half,
            centre_of_pressure: if weight == 0.0 { 0.0 } else { axial / weight * half },
            side_flow: side * area,
            feed_flow: feed * area,
            iterations: 0,
            converged: true,
        }
    }
}

fn least_film(problem: &FilmProblem, tilted: bool) -> (f64, f64, f64) {
    let c = problem.bearing.clearance;
    let half = 0.5 * problem.bearing.length;
    let ends: &[f64] = if tilted { &[-1.0, 1.0] } else { &[0.0] };
    let mut least = (f64::INFINITY, 0.0, 0.0);
    for &end in ends {
        let at = add(problem.motion.eccentricity, end, problem.tilt);
        let film = c - crate::plane::length(at);
        if film < least.0 {
            least = (film, at[1].atan2(at[0]), end * half);
        }
    }
    least
}

/// Attitude angle [rad]: from the load's direction (against the film's force) to the eccentricity, in the sense of rotation.
pub fn attitude(force: Plane, eccentricity: Plane) -> f64 {
    let load = [-force[0], -force[1]];
    cross(load, eccentricity).atan2(dot(load, eccentricity))
}
