//! Equations of motion of the train, and their stages condensed to the bearings.
//!
//! The crankshaft is linear, so that all that is not lies in the forces of its ties, two unknowns each. With the share `g` of a step in a stage,
//! `q = q_0 + g v`, `v = v_0 + g k`, Newton's correction of the accelerations `k` is
//!
//! ```text
//! A dk = -r + SUM C^T R^T df    A = 1 + g (D + 2 W G) + g^2 (K - W^2 N)    df = J R C dk + h
//! (1 - H J) w = C A^-1 (C^T h - r)    H = C A^-1 C^T    dk = A^-1 (-r + C^T (h + J w))                        (book, eq. 51.7)
//! ```
//! `A` is inverted once for each length of step. A big end with a law of its own is eliminated within its tie: `J` and `h` hold its inertia.

use super::body::{CrankBody, Held};
use super::law::TrainLaw;
use super::motion::Turn;
use super::parts::{CrankTrain, TrainCylinder};
use super::plane::{Plane, QUARTER, Square, back, length, plus, times, turn, turned_back};
use super::ties::{Kind, Moving, Tie, linear, moving};
use crate::sparse::dot;
use lanchester_numerics::{Lu, StageSystem};

/// Newton iterations of a stage.
const ITERATIONS: u32 = 14;
/// Last correction over the tolerance of a step.
const CORRECTION: f64 = 0.01;
/// Share of its thickness that a film keeps at least in one iteration.
const KEPT: f64 = 0.2;
/// Thickness over clearance that a mixed state must leave a film.
const LEAST_FILM: f64 = 0.002;
/// Energies that are summed: gas, drive, damping, bearings, size of the power of all.
pub(crate) const SUMS: usize = 5;
/// Inverses that are kept.
const KEPT_INVERSES: usize = 40;

struct Inverse {
    key: [u64; 2],
    inverse: Vec<f64>,
    /// A^-1 C^T, by ties.
    images: Vec<Vec<f64>>,
    /// C A^-1 C^T.
    compliance: Vec<f64>,
}

/// The equations of a train.
pub(crate) struct Assembly<'a> {
    pub(super) train: &'a CrankTrain,
    pub(super) body: CrankBody,
    pub(super) held: Held,
    pub(super) ties: Vec<Tie>,
    pub(super) size: usize,
    dimension: usize,
    /// Factor on the damping.
    pub damping: f64,
    /// Tolerances of coordinates and ties.
    pub coordinate_tolerance: Vec<f64>,
    pub tie_tolerance: Vec<f64>,
    tolerance: f64,
    inverses: Vec<Inverse>,
    matrices: Option<([u64; 3], Vec<f64>, Vec<f64>)>,
    pub factorisations: u64,
}

impl<'a> Assembly<'a> {
    pub fn new(train: &'a CrankTrain, tolerance: f64) -> Assembly<'a> {
        let rigid: Vec<usize> =
            train.mains.iter().filter(|main| main.law.is_rigid()).map(|main| main.surface).collect();
        let (body, held) = train.body.held(&rigid);
        let size = body.size();
        let mut dimension = 2 * size;
        let mut ties = Vec::new();
        for (index, main) in train.mains.iter().enumerate().filter(|(_, main)| !main.law.is_rigid()) {
            ties.push(Tie { kind: Kind::Main(index), surface: main.surface, centre: [0.0; 2] });
        }
        for (index, own) in train.cylinders.iter().enumerate() {
            let kind = if own.law.is_rigid() {
                Kind::Joined(index)
            } else {
                dimension += 4;
                Kind::Free(index, dimension - 4)
            };
            ties.push(Tie { kind, surface: own.surface, centre: own.pin });
        }
        dimension += SUMS;
        let reference = reference_force(train);
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
                TrainLaw::Film { bearing, .. } => bearing.clearance,
            }
        };
        let tie_tolerance = ties.iter().map(|tie| tolerance * reach(tie)).collect();
        Assembly {
            train,
            body,
            held,
            ties,
            size,
            dimension,
            damping: 1.0,
            coordinate_tolerance,
            tie_tolerance,
            tolerance,
            inverses: Vec::new(),
            matrices: None,
            factorisations: 0,
        }
    }

    /// A state to start from: the crankshaft undeformed, all centres together.
    pub fn start(&self) -> Vec<f64> {
        let mut y = vec![0.0; self.dimension];
        let turn = self.turn(0.0);
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

    /// Angle, speed and acceleration of this crankshaft.
    pub(super) fn turn(&self, t: f64) -> Turn {
        let first = self.train.motion.at(t);
        let ratio = self.train.ratio;
        Turn {
            angle: ratio * first.angle + self.train.phase,
            speed: ratio * first.speed,
            acceleration: ratio * first.acceleration,
        }
    }

    /// D + 2 W G and K - W^2 N + W' G.
    fn prepare(&mut self, turn: Turn) {
        let key = [turn.speed.to_bits(), turn.acceleration.to_bits(), self.damping.to_bits()];
        if self.matrices.as_ref().is_some_and(|(own, ..)| *own == key) {
            return;
        }
        let n = self.size;
        let (w, a) = (turn.speed, turn.acceleration);
        let body = &self.body;
        let by_velocity: Vec<f64> =
            body.damping.iter().zip(&body.gyroscopic).map(|(d, g)| self.damping * d + 2.0 * w * g).collect();
        let mut by_place: Vec<f64> =
            body.centrifugal.iter().zip(&body.gyroscopic).map(|(c, g)| a * g - w * w * c).collect();
        for (k, square) in body.stiffness.iter().enumerate() {
            by_place[k * (n + 1)] += square;
        }
        self.matrices = Some((key, by_velocity, by_place));
    }

    /// Index of the inverse for a share of a step.
    fn inverse(&mut self, share: f64) -> Option<usize> {
        let key = [share.to_bits(), self.damping.to_bits()];
        if let Some(found) = self.inverses.iter().position(|own| own.key == key) {
            return Some(found);
        }
        let n = self.size;
        let mean = self.train.ratio * self.train.motion.speed;
        self.prepare(Turn { angle: 0.0, speed: mean, acceleration: 0.0 });
        let (_, by_velocity, by_place) = self.matrices.as_ref()?;
        let matrix: Vec<f64> = by_velocity
            .iter()
            .zip(by_place)
            .enumerate()
            .map(|(k, (v, p))| f64::from(u8::from(k / n == k % n)) + share * v + share * share * p)
            .collect();
        let factors = Lu::new(n, matrix).ok()?;
        self.factorisations += 1;
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
        let rows: Vec<&Vec<f64>> = self.ties.iter().flat_map(|tie| &self.body.rows[tie.surface]).collect();
        let images: Vec<Vec<f64>> =
            rows.iter().map(|row| inverse.chunks(n.max(1)).map(|line| dot(line, row)).collect()).collect();
        let compliance = rows.iter().flat_map(|row| images.iter().map(|image| dot(row, image))).collect();
        if self.inverses.len() >= KEPT_INVERSES {
            self.inverses.remove(0);
        }
        self.inverses.push(Inverse { key, inverse, images, compliance });
        Some(self.inverses.len() - 1)
    }

    fn newton(&mut self, t: f64, base: &[f64], g: f64, slope: &mut [f64]) -> Option<u32> {
        let n = self.size;
        let turn = self.turn(t);
        let theta = self.train.motion.at(t).angle;
        let frame = super::plane::turn(turn.angle);
        let place = self.inverse(g)?;
        self.prepare(turn);
        let mut y = vec![0.0; self.dimension];
        let m = 2 * self.ties.len();
        let mut rest = vec![0.0; n];
        let mut forces = vec![[0.0; 2]; self.ties.len()];
        let mut iterations = 0;
        loop {
            iterations += 1;
            self.state(base, g, slope, &mut y);
            let (q, v) = y[..2 * n].split_at(n);
            let k = &slope[n..2 * n];
            let (_, by_velocity, by_place) = self.matrices.as_ref()?;
            let body = &self.body;
            for i in 0..n {
                let line = i * n..(i + 1) * n;
                rest[i] = k[i] + dot(&by_velocity[line.clone()], v) + dot(&by_place[line], q)
                    - turn.speed * turn.speed * body.centrifugal_load[i]
                    + turn.acceleration * body.euler_load[i];
            }
            let mut parts = Vec::with_capacity(self.ties.len());
            let mut jacobian = Vec::with_capacity(self.ties.len());
            for tie in &self.ties {
                let at = moving(&self.body, tie, &turn, &frame, [q, v, k]);
                let part = linear(self.train, tie, &turn, theta, g, &at, [&y, slope])?;
                let rows = &body.rows[tie.surface];
                // Into the residual go the force and the constant of the correction at once.
                let push = back(&frame, plus(part.force, 1.0, part.constant));
                for i in 0..n {
                    rest[i] -= rows[0][i] * push[0] + rows[1][i] * push[1];
                }
                jacobian.push(turned_back(&frame, &part.slope));
                parts.push((part, at));
            }
            let own = &self.inverses[place];
            let mut change: Vec<f64> = own.inverse.chunks(n.max(1)).map(|line| -dot(line, &rest)).collect();
            if m > 0 {
                let mut w: Vec<f64> = self
                    .ties
                    .iter()
                    .flat_map(|tie| {
                        body.rows[tie.surface].iter().map(|row| dot(row, &change)).collect::<Vec<_>>()
                    })
                    .collect();
                let mut small = vec![0.0; m * m];
                for row in 0..m {
                    for (tie, j) in jacobian.iter().enumerate() {
                        let h = [own.compliance[row * m + 2 * tie], own.compliance[row * m + 2 * tie + 1]];
                        let entry = back(j, h);
                        small[row * m + 2 * tie] = -entry[0];
                        small[row * m + 2 * tie + 1] = -entry[1];
                    }
                    small[row * (m + 1)] += 1.0;
                }
                Lu::new(m, small).ok()?.solve(&mut w);
                for (tie, j) in jacobian.iter().enumerate() {
                    let push = times(j, [w[2 * tie], w[2 * tie + 1]]);
                    for (axis, push) in push.iter().enumerate() {
                        let image = &own.images[2 * tie + axis];
                        change.iter_mut().zip(image).for_each(|(to, from)| *to += push * from);
                    }
                }
            }
            // How far the correction may go, and how large it is.
            let (mut reach, mut size) = (1.0f64, 0.0f64);
            let mut moved = Vec::with_capacity(self.ties.len());
            for (index, tie) in self.ties.iter().enumerate() {
                let rows = &body.rows[tie.surface];
                let w = times(&frame, [dot(&rows[0], &change), dot(&rows[1], &change)]);
                let (part, at) = &parts[index];
                let (shift, follow) = part.big_end;
                let end = plus(shift, 1.0, times(&follow, w));
                let law = match tie.kind {
                    Kind::Main(index) => Some((&self.train.mains[index].law, [0.0; 2])),
                    Kind::Free(index, start) => {
                        Some((&self.train.cylinders[index].law, [y[start], y[start + 1]]))
                    }
                    Kind::Joined(_) => None,
                };
                if let Some((law, centre)) = law {
                    let e = plus(at.place, -1.0, centre);
                    let step = plus(w, -1.0, end).map(|part| g * g * part);
                    size = size.max(length(step) / self.tie_tolerance[index]);
                    if let TrainLaw::Film { bearing, .. } = law {
                        reach = reach.min(within(bearing.clearance, e, step));
                    }
                }
                moved.push((w, end));
            }
            for (change, tolerance) in change.iter().zip(&self.coordinate_tolerance) {
                size = size.max((g * g * change).abs() / tolerance);
            }
            if !size.is_finite() {
                return None;
            }
            for (to, change) in slope[n..2 * n].iter_mut().zip(&change) {
                *to += reach * change;
            }
            for (index, tie) in self.ties.iter().enumerate() {
                let (w, end) = moved[index];
                let part = &parts[index].0;
                let by = plus(times(&part.slope, w), 1.0, part.constant);
                forces[index] = plus(part.force, reach, by);
                if let Kind::Free(_, start) = tie.kind {
                    slope[start + 2] += reach * end[0];
                    slope[start + 3] += reach * end[1];
                }
            }
            let done = size <= CORRECTION && reach == 1.0;
            if (g > 0.0 && done) || (g == 0.0 && iterations == 2) {
                break;
            }
            if iterations >= ITERATIONS {
                return None;
            }
        }
        self.state(base, g, slope, &mut y);
        self.close(&turn, theta, &frame, &y, slope, &forces)?;
        Some(iterations)
    }

    /// State of a stage for its accelerations, and the velocities into the slope.
    fn state(&self, base: &[f64], g: f64, slope: &mut [f64], y: &mut [f64]) {
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
        }
    }

    /// Powers into the slope.
    fn close(
        &self,
        turn: &Turn,
        theta: f64,
        frame: &Square,
        y: &[f64],
        slope: &mut [f64],
        forces: &[Plane],
    ) -> Option<()> {
        let n = self.size;
        let (q, v) = y[..2 * n].split_at(n);
        let body = &self.body;
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * n..(i + 1) * n], x);
        let (mut damped, mut momentum) = (0.0, 0.0);
        for i in 0..n {
            damped += v[i] * line(&body.damping, i, v);
            let of_place = line(&body.centrifugal, i, q);
            momentum += slope[n + i] * (body.euler_load[i] + line(&body.gyroscopic, i, q))
                + turn.acceleration * q[i] * (2.0 * body.centrifugal_load[i] + of_place)
                + 2.0 * turn.speed * v[i] * (body.centrifugal_load[i] + of_place);
        }
        momentum += turn.acceleration * body.polar;
        let (mut gas, mut bearings) = (0.0, 0.0);
        for (tie, force) in self.ties.iter().zip(forces) {
            let at = moving(&self.body, tie, turn, frame, [q, v, &slope[n..2 * n]]);
            momentum -= force[1] * at.place[0] - force[0] * at.place[1];
            let (index, end) = match tie.kind {
                Kind::Main(_) => {
                    bearings += super::plane::dot(*force, at.velocity);
                    continue;
                }
                Kind::Joined(index) => (index, at),
                Kind::Free(index, start) => {
                    let [place, velocity] = [[y[start], y[start + 1]], [y[start + 2], y[start + 3]]];
                    bearings += super::plane::dot(*force, plus(at.velocity, -1.0, velocity));
                    (index, Moving { place, velocity, ..Moving::default() })
                }
            };
            let own = &self.train.cylinders[index];
            let pressed = own.gas.at(theta);
            let state = own.slider.state(end.place, end.velocity, [0.0; 2], pressed)?;
            gas -= pressed * state.piston_velocity;
        }
        let drive = turn.speed * momentum;
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
    pub fn error(&self, t: f64, error: &[f64]) -> f64 {
        let n = self.size;
        let rate = 10.0 * (self.train.ratio * self.train.motion.speed).abs();
        let mut largest = 0.0f64;
        for (k, tolerance) in self.coordinate_tolerance.iter().enumerate() {
            largest = largest.max(error[k].abs() / tolerance);
        }
        let frame = turn(self.turn(t).angle);
        for (tie, tolerance) in self.ties.iter().zip(&self.tie_tolerance) {
            let rows = &self.body.rows[tie.surface];
            for (from, scale) in [(0, 1.0), (n, rate)] {
                let own = &error[from..from + n];
                let mut e = times(&frame, [dot(&rows[0], own), dot(&rows[1], own)]);
                if let Kind::Free(_, start) = tie.kind {
                    let at = start + if from == 0 { 0 } else { 2 };
                    e = plus(e, -1.0, [error[at], error[at + 1]]);
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
        weights
    }

    /// Whether a state leaves every film some thickness, and every rod its line.
    pub fn has_films(&self, t: f64, y: &[f64]) -> bool {
        let n = self.size;
        let turn = self.turn(t);
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
            match law {
                TrainLaw::Film { bearing, .. } => {
                    length(plus(at.place, -1.0, centre)) < (1.0 - LEAST_FILM) * bearing.clearance
                }
                _ => true,
            }
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

/// Share of a step of an eccentricity after which a film keeps some of its thickness.
fn within(clearance: f64, e: Plane, step: Plane) -> f64 {
    let film = clearance - length(e);
    let allowed = clearance - KEPT * film;
    if length(plus(e, 1.0, step)) <= allowed {
        return 1.0;
    }
    // |e + s step| = allowed.
    let [a, b, c] = [
        super::plane::dot(step, step),
        super::plane::dot(e, step),
        super::plane::dot(e, e) - allowed * allowed,
    ];
    ((-b + (b * b - a * c).max(0.0).sqrt()) / a).clamp(0.0, 1.0)
}

/// Size of the forces in the train [N]: gas, inertia of pistons and rods, centrifugal force of the crankshaft.
fn reference_force(train: &CrankTrain) -> f64 {
    let speed = train.ratio * train.motion.speed;
    let of = |own: &TrainCylinder| {
        own.gas.largest() + (own.slider.piston + own.slider.rod) * length(own.pin) * speed * speed
    };
    train.cylinders.iter().map(of).fold(0.0, f64::max).max(1.0)
}
