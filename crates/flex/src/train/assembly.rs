//! Equations of motion of the train: what its state is, and how much of it counts.
//!
//! The state: coordinates of the crankshaft and their rates, places and velocities of big ends with laws of their own, places of shells on yielding housings, deviation of a
//! free flywheel's angle, its rate and the load, sums of energies.

use super::body::{CrankBody, Held};
use super::flywheel::{FreeFlywheel, HARDLY};
use super::law::TrainLaw;
use super::motion::Turn;
use super::parts::{CrankTrain, TrainCylinder};
use super::plane::{Plane, QUARTER, Square, length, plus, times, turn};
use super::spot::{Spot, middle, moment, work};
use super::ties::{Kind, Moving, Shell, Tie, moving};
use crate::sparse::dot;
use lanchester_numerics::{Lu, StageSystem};

/// Share of the tolerance for the speed of a free flywheel: its errors add up over a cycle, while those of vibration die.
const ADDING: f64 = 0.1;
/// Thickness over clearance that a mixed state must leave a film.
const LEAST_FILM: f64 = 0.002;
/// Energies that are summed: gas, drive, damping, bearings, size of the power of all.
pub(crate) const SUMS: usize = 5;
/// Inverses that are kept.
const KEPT_INVERSES: usize = 40;

/// Of a length of step.
pub(super) struct Inverse {
    key: [u64; 2],
    /// A^-1.
    pub inverse: Vec<f64>,
    /// A^-1 (C, Z)^T: one of each row of the ties.
    pub images: Vec<Vec<f64>>,
    /// (C, Z) A^-1 (C, Z)^T.
    pub compliance: Vec<f64>,
}

/// A free flywheel in the state.
pub(super) struct Wheel {
    pub flywheel: FreeFlywheel,
    /// Where its deviation [rad] begins, followed by its rate and the load.
    pub at: usize,
    /// Tolerance of the rate [rad/s].
    pub tolerance: f64,
    /// Whether it is let go: until then the motion is imposed.
    turns: bool,
}

/// The equations of a train.
pub(crate) struct Assembly<'a> {
    pub(super) train: &'a CrankTrain,
    pub(super) body: CrankBody,
    pub(super) held: Held,
    pub(super) ties: Vec<Tie>,
    /// Rows of the body that move the ties.
    pub(super) tie_rows: Vec<Vec<f64>>,
    /// Components of the ties' motion.
    pub(super) tie_parts: usize,
    pub(super) size: usize,
    pub(super) dimension: usize,
    wheel: Option<Wheel>,
    /// Factor on the damping.
    pub damping: f64,
    /// Tolerances of coordinates and ties.
    pub coordinate_tolerance: Vec<f64>,
    pub tie_tolerance: Vec<f64>,
    tolerance: f64,
    pub(super) inverses: Vec<Inverse>,
}

impl<'a> Assembly<'a> {
    /// The equations of a train with these tolerances; a flywheel turns freely once it is let go.
    pub fn new(train: &'a CrankTrain, tolerance: f64, flywheel: Option<FreeFlywheel>) -> Assembly<'a> {
        let rigid: Vec<usize> =
            train.mains.iter().filter(|main| main.law.is_rigid()).map(|main| main.surface).collect();
        let (body, held) = train.body.held(&rigid);
        let size = body.size();
        let mut dimension = 2 * size;
        let mut ties: Vec<Tie> = Vec::new();
        let (mut tie_rows, mut tie_parts) = (Vec::new(), 0);
        let mut tie = |kind: Kind, surface: usize, centre: Plane, law: &TrainLaw, shell: Option<Shell>| {
            let half = law.film().filter(|_| law.is_tilted()).map_or(0.0, |own| 0.5 * own.length);
            let own = Tie { kind, surface, centre, half, shell, row: tie_rows.len(), part: tie_parts };
            tie_rows.extend(body.rows[surface].iter().chain([&body.turns[surface]]).cloned());
            if half > 0.0 {
                tie_rows.extend(body.slopes[surface].iter().cloned());
            }
            tie_parts += own.parts();
            ties.push(own);
        };
        let mut components = |count: usize| {
            dimension += count;
            dimension - count
        };
        for (index, main) in train.mains.iter().enumerate().filter(|(_, main)| !main.law.is_rigid()) {
            let shell = main.housing.map(|stiffness| Shell { at: components(2), stiffness });
            tie(Kind::Main(index), main.surface, [0.0; 2], &main.law, shell);
        }
        for (index, own) in train.cylinders.iter().enumerate() {
            let kind = match own.law.is_rigid() {
                true => Kind::Joined(index),
                false => Kind::Free(index, components(4)),
            };
            let shell = own.housing.map(|stiffness| Shell { at: components(2), stiffness });
            tie(kind, own.surface, own.pin, &own.law, shell);
        }
        let reference = reference_force(train);
        let wheel = flywheel.map(|flywheel| {
            dimension += 3;
            let tolerance = ADDING * tolerance * speed_swing(train, flywheel, reference);
            Wheel { flywheel, at: dimension - 3, tolerance, turns: false }
        });
        dimension += SUMS;
        let coordinate_tolerance = (0..size)
            .map(|k| {
                let row = |rows: &[Vec<f64>; 2]| rows[0][k].hypot(rows[1][k]);
                let largest = ties.iter().map(|tie| row(&body.rows[tie.surface])).fold(0.0, f64::max);
                let inner = body.centrifugal_load[k].abs() * train.motion.speed.powi(2) / reference;
                let square = body.stiffness[k];
                if square > 0.0 {
                    tolerance * reference * largest.max(inner).max(1e-9) / square
                } else {
                    f64::INFINITY
                }
            })
            .collect();
        let reach = |tie: &Tie| {
            let law = match tie.kind {
                Kind::Main(index) => &train.mains[index].law,
                Kind::Free(index, _) | Kind::Joined(index) => &train.cylinders[index].law,
            };
            match law {
                TrainLaw::Rigid => f64::INFINITY,
                TrainLaw::Bushing { stiffness, .. } => {
                    reference / stiffness.iter().flatten().fold(1.0f64, |most, k| most.max(k.abs()))
                }
                TrainLaw::Contact { clearance, stiffness, .. } => clearance.max(reference / stiffness),
                TrainLaw::Film { bearing, .. } | TrainLaw::TiltedFilm { bearing, .. } => bearing.clearance,
            }
        };
        let tie_tolerance = ties.iter().map(|tie| tolerance * reach(tie)).collect();
        Assembly {
            train,
            body,
            held,
            ties,
            tie_rows,
            tie_parts,
            size,
            dimension,
            wheel,
            damping: 1.0,
            coordinate_tolerance,
            tie_tolerance,
            tolerance,
            inverses: Vec::new(),
        }
    }

    /// A state to start from: the crankshaft undeformed, all centres together.
    pub fn start(&self) -> Vec<f64> {
        let mut y = vec![0.0; self.dimension];
        let turn = self.own(&self.first(0.0, &y, &[]));
        let frame = super::plane::turn(turn.angle);
        for tie in &self.ties {
            if let Kind::Free(_, at) = tie.kind {
                let place = times(&frame, tie.centre);
                let velocity = times(&QUARTER, place).map(|v| turn.speed * v);
                y[at..at + 2].copy_from_slice(&place);
                y[at + 2..at + 4].copy_from_slice(&velocity);
            }
        }
        y
    }

    /// The flywheel that turns freely now.
    pub(super) fn turning(&self) -> Option<&Wheel> {
        self.wheel.as_ref().filter(|wheel| wheel.turns)
    }

    /// Motion of crankshaft 1: imposed, or that of a state; of an empty slope without acceleration.
    pub(super) fn first(&self, t: f64, y: &[f64], slope: &[f64]) -> Turn {
        let motion = &self.train.motion;
        match self.turning() {
            None => motion.at(t),
            Some(Wheel { at, .. }) => Turn {
                angle: motion.speed * t + y[*at],
                speed: motion.speed + y[at + 1],
                acceleration: slope.get(at + 1).copied().unwrap_or_default(),
            },
        }
    }

    /// Angle, speed and acceleration of this crankshaft from those of crankshaft 1.
    pub(super) fn own(&self, first: &Turn) -> Turn {
        let ratio = self.train.ratio;
        Turn {
            angle: ratio * first.angle + self.train.phase,
            speed: ratio * first.speed,
            acceleration: ratio * first.acceleration,
        }
    }

    /// Deviation, its rate and the load of a free flywheel.
    pub fn flywheel(&self, y: &[f64]) -> Option<[f64; 3]> {
        self.turning().map(|wheel| [0, 1, 2].map(|k| y[wheel.at + k]))
    }

    /// Lets the flywheel go with this deviation, rate and load, or sets them; big ends move along with their pins.
    pub fn set_flywheel(&mut self, t: f64, y: &mut [f64], values: [f64; 3]) {
        let before = self.pins(t, y);
        if let Some(wheel) = &mut self.wheel {
            y[wheel.at..wheel.at + 3].copy_from_slice(&values);
            wheel.turns = true;
        }
        let after = self.pins(t, y);
        for ((start, old), (_, new)) in before.into_iter().zip(after) {
            for axis in 0..2 {
                y[start + axis] += new.place[axis] - old.place[axis];
                y[start + 2 + axis] += new.velocity[axis] - old.velocity[axis];
            }
        }
    }

    /// Pins in big ends that have coordinates, with the first of these.
    fn pins(&self, t: f64, y: &[f64]) -> Vec<(usize, Moving)> {
        let turn = self.own(&self.first(t, y, &[]));
        let frame = super::plane::turn(turn.angle);
        let (q, v) = y[..2 * self.size].split_at(self.size);
        let still = vec![0.0; self.size];
        let pin = |tie: &Tie| match tie.kind {
            Kind::Free(_, start) => Some((start, moving(&self.body, tie, &turn, &frame, [q, v, &still]))),
            Kind::Main(_) | Kind::Joined(_) => None,
        };
        self.ties.iter().filter_map(pin).collect()
    }

    /// Index of the inverse for a share of a step.
    pub(super) fn inverse(&mut self, share: f64) -> Option<usize> {
        let key = [share.to_bits(), self.damping.to_bits()];
        if let Some(found) = self.inverses.iter().position(|own| own.key == key) {
            return Some(found);
        }
        let n = self.size;
        let w = self.train.ratio * self.train.motion.speed;
        let body = &self.body;
        let mut matrix: Vec<f64> = (0..n * n)
            .map(|k| {
                let by_velocity = self.damping * body.damping[k] + 2.0 * w * body.gyroscopic[k];
                share * by_velocity - share * share * w * w * body.centrifugal[k]
            })
            .collect();
        for (k, square) in body.stiffness.iter().enumerate() {
            matrix[k * (n + 1)] += 1.0 + share * share * square;
        }
        let factors = Lu::new(n, matrix).ok()?;
        let mut inverse = vec![0.0; n * n];
        let mut column = vec![0.0; n];
        for j in 0..n {
            column.fill(0.0);
            column[j] = 1.0;
            factors.solve(&mut column);
            for i in 0..n {
                inverse[i * n + j] = column[i];
            }
        }
        let rows = &self.tie_rows;
        let images: Vec<Vec<f64>> =
            rows.iter().map(|row| inverse.chunks(n.max(1)).map(|line| dot(line, row)).collect()).collect();
        let compliance = rows.iter().flat_map(|row| images.iter().map(|image| dot(row, image))).collect();
        if self.inverses.len() >= KEPT_INVERSES {
            self.inverses.remove(0);
        }
        self.inverses.push(Inverse { key, inverse, images, compliance });
        Some(self.inverses.len() - 1)
    }

    /// Rows of a tie's surface: displacement, rotation, slope where tilt counts.
    pub(super) fn rows(&self, tie: &Tie) -> &[Vec<f64>] {
        &self.tie_rows[tie.row..tie.row + tie.rows()]
    }

    /// State of a stage for its accelerations, and the velocities into the slope.
    pub(super) fn state(&self, base: &[f64], g: f64, slope: &mut [f64], y: &mut [f64]) {
        let n = self.size;
        for i in 0..n {
            y[n + i] = base[n + i] + g * slope[n + i];
            y[i] = base[i] + g * y[n + i];
            slope[i] = y[n + i];
        }
        for tie in &self.ties {
            if let Kind::Free(_, start) = tie.kind {
                for axis in 0..2 {
                    let (at, rate) = (start + axis, start + 2 + axis);
                    y[rate] = base[rate] + g * slope[rate];
                    y[at] = base[at] + g * y[rate];
                    slope[at] = y[rate];
                }
            }
            if let Some(shell) = tie.shell {
                for at in [shell.at, shell.at + 1] {
                    y[at] = base[at] + g * slope[at];
                }
            }
        }
        if let Some(wheel) = &self.wheel {
            let at = wheel.at;
            if !wheel.turns {
                slope[at + 1] = 0.0;
            }
            y[at + 1] = base[at + 1] + g * slope[at + 1];
            y[at] = base[at] + g * y[at + 1];
            y[at + 2] = base[at + 2];
            slope[at] = y[at + 1];
            slope[at + 2] = 0.0;
        }
    }

    /// Torque of the flywheel on the crankshaft [N m]: rate of the moment of momentum (book, eq. 51.5) less the moments of the ties' forces about the axis.
    pub(super) fn torque(&self, turn: &Turn, y: &[f64], k: &[f64], moments: f64) -> f64 {
        let n = self.size;
        let (q, v) = y[..2 * n].split_at(n);
        let body = &self.body;
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * n..(i + 1) * n], x);
        let mut rate = turn.acceleration * body.polar;
        for i in 0..n {
            let of_place = line(&body.centrifugal, i, q);
            rate += k[i] * (body.euler_load[i] + line(&body.gyroscopic, i, q))
                + turn.acceleration * q[i] * (2.0 * body.centrifugal_load[i] + of_place)
                + 2.0 * turn.speed * v[i] * (body.centrifugal_load[i] + of_place);
        }
        rate - moments
    }

    /// Powers into the slope.
    pub(super) fn close(
        &self,
        turn: &Turn,
        theta: f64,
        frame: &Square,
        y: &[f64],
        slope: &mut [f64],
        forces: &[Spot],
    ) -> Option<()> {
        let n = self.size;
        let (q, v) = y[..2 * n].split_at(n);
        let body = &self.body;
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * n..(i + 1) * n], x);
        let damped: f64 = (0..n).map(|i| v[i] * line(&body.damping, i, v)).sum();
        let mut moments = 0.0;
        let (mut gas, mut bearings) = (0.0, 0.0);
        for (tie, force) in self.ties.iter().zip(forces) {
            let at = moving(&self.body, tie, turn, frame, [q, v, &slope[n..2 * n]]);
            moments += moment(&at.place, force);
            let (index, place, velocity) = match tie.kind {
                Kind::Main(_) => {
                    bearings += work(&tie.within(&at.velocity, [0.0; 2], slope), force);
                    continue;
                }
                Kind::Joined(index) => (index, middle(&at.place), middle(&at.velocity)),
                Kind::Free(index, start) => {
                    let [place, velocity] = [[y[start], y[start + 1]], [y[start + 2], y[start + 3]]];
                    bearings += work(&tie.within(&at.velocity, velocity, slope), force);
                    (index, place, velocity)
                }
            };
            let own = &self.train.cylinders[index];
            let pressed = own.gas.at(theta);
            let state = own.slider.state(place, velocity, [0.0; 2], pressed)?;
            gas -= pressed * state.piston_velocity;
        }
        let drive = turn.speed * self.torque(turn, y, &slope[n..2 * n], moments);
        let sums = self.dimension - SUMS;
        slope[sums..].copy_from_slice(&[
            gas,
            drive,
            self.damping * damped,
            bearings,
            gas.abs() + drive.abs() + bearings.abs(),
        ]);
        slope.iter().all(|value| value.is_finite()).then_some(())
    }

    /// Estimated error over the tolerances: deformation of the crankshaft and eccentricity of every tie, places and velocities.
    /// With a free flywheel the rate of its deviation, and the deviation over a radian of the crankshaft.
    pub fn error(&self, t: f64, y: &[f64], error: &[f64]) -> f64 {
        let n = self.size;
        let speed = self.train.motion.speed;
        let rate = 10.0 * (self.train.ratio * speed).abs();
        let mut largest = 0.0f64;
        if let Some(wheel) = self.turning() {
            let [angle, rate] = [error[wheel.at], error[wheel.at + 1]].map(f64::abs);
            largest = rate.max(speed * angle) / wheel.tolerance;
        }
        for (k, tolerance) in self.coordinate_tolerance.iter().enumerate() {
            largest = largest.max(error[k].abs() / tolerance);
        }
        let frame = turn(self.own(&self.first(t, y, &[])).angle);
        for (tie, tolerance) in self.ties.iter().zip(&self.tie_tolerance) {
            let rows = self.rows(tie);
            for (from, scale) in [(0, 1.0), (n, rate)] {
                let own = &error[from..from + n];
                let mut e = times(&frame, [dot(&rows[0], own), dot(&rows[1], own)]);
                if let Kind::Free(_, start) = tie.kind {
                    let at = start + if from == 0 { 0 } else { 2 };
                    e = plus(e, -1.0, [error[at], error[at + 1]]);
                }
                if let Some(shell) = tie.shell.filter(|_| from == 0) {
                    e = plus(e, -1.0, [error[shell.at], error[shell.at + 1]]);
                }
                if let [_, _, _, x, y] = rows {
                    let end = tie.half * length([dot(x, own), dot(y, own)]);
                    largest = largest.max(end / (tolerance * scale));
                }
                largest = largest.max(length(e) / (tolerance * scale));
            }
        }
        largest
    }

    /// Weights that make the components of a state comparable: square roots of energies; none of the sums.
    pub fn weights(&self) -> Vec<f64> {
        let n = self.size;
        let reference = reference_force(self.train);
        let mut weights = vec![0.0; self.dimension];
        let speed = self.train.motion.speed;
        for k in 0..n {
            weights[k] = self.body.stiffness[k].sqrt().max(speed);
            weights[n + k] = 1.0;
        }
        for (tie, tolerance) in self.ties.iter().zip(&self.tie_tolerance) {
            if let Some(shell) = tie.shell {
                weights[shell.at..shell.at + 2].fill(shell.stiffness.sqrt());
            }
            if let Kind::Free(index, start) = tie.kind {
                let slider = &self.train.cylinders[index].slider;
                // A tie's tolerance is a fixed share of its reach.
                let reach = tolerance / self.tolerance;
                for axis in 0..2 {
                    weights[start + axis] = (reference / reach).sqrt();
                    weights[start + 2 + axis] = (slider.piston + slider.rod).sqrt();
                }
            }
        }
        if let Some(Wheel { flywheel, at, .. }) = &self.wheel {
            // The load over a cycle changes the speed.
            let inertia = flywheel.whole().sqrt();
            weights[at + 1] = inertia;
            weights[at + 2] = self.train.motion.duration() / inertia;
        }
        weights
    }

    /// Whether a state leaves every film some thickness, and every rod its line.
    pub fn has_films(&self, t: f64, y: &[f64]) -> bool {
        let n = self.size;
        let turn = self.own(&self.first(t, y, &[]));
        let frame = super::plane::turn(turn.angle);
        let (q, v) = y[..2 * n].split_at(n);
        let still = vec![0.0; n];
        self.ties.iter().all(|tie| {
            let at = moving(&self.body, tie, &turn, &frame, [q, v, &still]);
            let (law, centre) = match tie.kind {
                Kind::Main(index) => (&self.train.mains[index].law, [0.0; 2]),
                Kind::Free(index, start) => (&self.train.cylinders[index].law, [y[start], y[start + 1]]),
                Kind::Joined(_) => return true,
            };
            let e = tie.within(&at.place, centre, y);
            law.film().is_none_or(|bearing| length(middle(&e)) < (1.0 - LEAST_FILM) * bearing.clearance)
        })
    }

    /// Where the sums of energies begin.
    pub fn sums(&self) -> usize {
        self.dimension - SUMS
    }

    /// Size of the elastic deformation: square root of its energy.
    pub fn deformation(&self, a: &[f64], b: &[f64]) -> f64 {
        let square = |(stiffness, (a, b)): (&f64, (&f64, &f64))| stiffness * (a - b) * (a - b);
        self.train.body.stiffness.iter().zip(a.iter().zip(b)).map(square).sum::<f64>().sqrt()
    }
}

impl StageSystem for Assembly<'_> {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn slope(&mut self, t: f64, y: &[f64], slope: &mut [f64]) -> bool {
        slope.fill(0.0);
        self.newton(t, y, 0.0, slope).is_some()
    }

    fn stage(&mut self, t: f64, base: &[f64], share: f64, slope: &mut [f64]) -> Option<u32> {
        self.newton(t, base, share, slope)
    }
}

/// Size of the forces in the train [N]: gas, inertia of pistons and rods, centrifugal force of the crankshaft.
fn reference_force(train: &CrankTrain) -> f64 {
    let speed = train.ratio * train.motion.speed;
    let of = |own: &TrainCylinder| {
        own.gas.largest() + (own.slider.piston + own.slider.rod) * length(own.pin) * speed * speed
    };
    train.cylinders.iter().map(of).fold(0.0, f64::max).max(1.0)
}

/// Size of the swing of a free flywheel's speed [rad/s]: what the largest force on the longest throw does over a radian.
fn speed_swing(train: &CrankTrain, flywheel: FreeFlywheel, force: f64) -> f64 {
    let throw = train.cylinders.iter().map(|own| length(own.pin)).fold(0.0, f64::max);
    let speed = train.motion.speed;
    (force * throw / (flywheel.whole() * speed)).max(HARDLY * speed)
}
