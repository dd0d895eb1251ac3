//! Newton's iteration of a stage, condensed to the bearings.
//!
//! The crankshaft is linear, so that all that is not lies in the forces of its ties, two unknowns each, four where tilt counts. With the share `g` of a step in a stage,
//! `q = q_0 + g v`, `v = v_0 + g k`, Newton's correction of the accelerations `k` is
//!
//! ```text
//! A dk = -r - c da + SUM L^T df    A = 1 + g (D + 2 W G) + g^2 (K - W^2 (N - S))    df = J w + h    w = L dk + e_z x p da    L = R E (C, Z)
//! (1 - H J) w = L A^-1 (L^T h - r - c da) + e_z x p da    H = L A^-1 L^T    dk = A^-1 (-r - c da + L^T (h + J w))      (book, eq. 51.7)
//! ```
//! `A` is inverted once for each length of step. A big end with a law of its own is eliminated within its tie, and so is a shell on its housing: `J` and `h` hold them.
//!
//! `da` is the correction of the acceleration of a free flywheel, 0 where the motion is imposed. It turns the frame, so that the tie at `p` feels it as an acceleration
//! across; `c` is its derivative of `r`. It follows from the flywheel's own equation, whose torque is linear in `dk`, `w` and `da` too:
//!
//! ```text
//! (J_f + i^2 dT/da) da = T_L - J_f a - i T                                                                              (book, eq. 51.12)
//! ```
//! What a turn of the frame does to the direction of forces and to the gas, and a correction to `E` of a pin, is left out of the derivatives: shares of (g W)^2 of what is in.

use super::assembly::{Assembly, Inverse};
use super::motion::Turn;
use super::plane::{Plane, length, plus, turn};
use super::spot::{Spot, add, apply, end, middle, moment, quarter};
use super::ties::{Kind, Linear, Moving, Tie, linear, moving};
use crate::sparse::dot;
use lanchester_numerics::Lu;
use rayon::prelude::*;

/// Newton iterations of a stage.
const ITERATIONS: u32 = 14;
/// Those of a state whose shells yield.
const SHELLS: u32 = 6;
/// Last correction over the tolerance of a step.
const CORRECTION: f64 = 0.01;
/// Share of its thickness that a film keeps at least in one iteration.
const KEPT: f64 = 0.2;

/// A state of a stage, where its ties are and what they do there.
struct Trial {
    turn: Turn,
    ties: Vec<(Linear, Moving)>,
}

/// Newton's correction.
struct Correction {
    /// Of the crankshaft's accelerations.
    change: Vec<f64>,
    /// Of the acceleration of crankshaft 1 [rad/s^2].
    turning: f64,
    /// Of the acceleration of every tie, in the block's frame.
    ties: Vec<Spot>,
}

/// The equations of the body at a state, and what its torque is made of.
struct BodyTerms {
    /// r without ties.
    rest: Vec<f64>,
    /// G v, f_c + (N - S) q, f_e + G q.
    coriolis: Vec<f64>,
    centrifugal: Vec<f64>,
    euler: Vec<f64>,
}

/// The ties' own equations.
struct Condensed<'a> {
    own: &'a Inverse,
    /// Of 1 - H J.
    factors: Lu<f64>,
}

/// Derivatives by the angular acceleration.
struct ByTurning {
    change: Vec<f64>,
    moved: Vec<Spot>,
    /// Of the flywheel's torque on the crankshaft: the inertia that it feels [kg m^2].
    torque: f64,
}

impl Assembly<'_> {
    /// Solves a stage for the accelerations in `slope`; with `g = 0` those of a state. The number of iterations, or none where they do not converge.
    pub(super) fn newton(&mut self, t: f64, base: &[f64], g: f64, slope: &mut [f64]) -> Option<u32> {
        let n = self.size;
        let place = self.inverse(g)?;
        let mut y = vec![0.0; self.dimension];
        let mut forces = vec![[0.0; 4]; self.ties.len()];
        // Without a step only the rate of shells is not linear.
        let at_rest = if self.ties.iter().any(|tie| tie.shell.is_some()) { SHELLS } else { 2 };
        let mut iterations = 0;
        loop {
            iterations += 1;
            self.state(base, g, slope, &mut y);
            let trial = self.trial(t, &y, g, slope)?;
            let found = self.correction(place, g, &y, slope, &trial)?;
            let (reach, size) = self.reach(g, &y, &trial, &found);
            if !size.is_finite() {
                return None;
            }
            for (to, change) in slope[n..2 * n].iter_mut().zip(&found.change) {
                *to += reach * change;
            }
            if let Some(wheel) = self.turning() {
                slope[wheel.at + 1] += reach * found.turning;
            }
            for (index, (tie, (part, _))) in self.ties.iter().zip(&trial.ties).enumerate() {
                let w = found.ties[index];
                forces[index] = add(&part.force, reach, &add(&apply(&part.slope, &w), 1.0, &part.constant));
                let mut follow = |at: usize, by: Plane| (0..2).for_each(|k| slope[at + k] += reach * by[k]);
                if let Kind::Free(_, start) = tie.kind {
                    follow(start + 2, part.big_end.at(&w));
                }
                if let Some(shell) = tie.shell {
                    follow(shell.at, part.shell.at(&w));
                }
            }
            let done = size <= CORRECTION && reach == 1.0;
            if (g > 0.0 && done) || (g == 0.0 && iterations == at_rest) {
                break;
            }
            if iterations >= ITERATIONS {
                return None;
            }
        }
        self.state(base, g, slope, &mut y);
        let first = self.first(t, &y, slope);
        let own = self.own(&first);
        self.close(&own, first.angle, &turn(own.angle), &y, slope, &forces)?;
        Some(iterations)
    }

    fn trial(&self, t: f64, y: &[f64], g: f64, slope: &[f64]) -> Option<Trial> {
        let n = self.size;
        let first = self.first(t, y, slope);
        let own = self.own(&first);
        let frame = turn(own.angle);
        let (q, v) = y[..2 * n].split_at(n);
        let one = |tie: &Tie| {
            let at = moving(&self.body, tie, &own, &frame, [q, v, &slope[n..2 * n]]);
            Some((linear(self.train, tie, &own, first.angle, g, &at, [y, slope])?, at))
        };
        // A film that is solved is worth a thread.
        let ties: Option<Vec<_>> = match self.ties.iter().any(|tie| tie.half > 0.0) {
            true => self.ties.par_iter().map(one).collect(),
            false => self.ties.iter().map(one).collect(),
        };
        Some(Trial { ties: ties?, turn: own })
    }

    fn body_terms(&self, turn: &Turn, y: &[f64], k: &[f64]) -> BodyTerms {
        let n = self.size;
        let (q, v) = y[..2 * n].split_at(n);
        let body = &self.body;
        let line = |matrix: &[f64], i: usize, x: &[f64]| dot(&matrix[i * n..(i + 1) * n], x);
        let coriolis: Vec<f64> = (0..n).map(|i| line(&body.gyroscopic, i, v)).collect();
        let centrifugal: Vec<f64> =
            (0..n).map(|i| body.centrifugal_load[i] + line(&body.centrifugal, i, q)).collect();
        let euler: Vec<f64> = (0..n).map(|i| body.euler_load[i] + line(&body.gyroscopic, i, q)).collect();
        let w = turn.speed;
        let rest = (0..n).map(|i| {
            k[i] + self.damping * line(&body.damping, i, v) + 2.0 * w * coriolis[i] + body.stiffness[i] * q[i]
                - w * w * centrifugal[i]
                + turn.acceleration * euler[i]
        });
        BodyTerms { rest: rest.collect(), coriolis, centrifugal, euler }
    }

    fn correction(
        &self,
        place: usize,
        g: f64,
        y: &[f64],
        slope: &[f64],
        trial: &Trial,
    ) -> Option<Correction> {
        let n = self.size;
        let Trial { turn, ties } = trial;
        let terms = self.body_terms(turn, y, &slope[n..2 * n]);
        let condensed = self.condensed(&self.inverses[place], trial)?;
        let mut load: Vec<f64> = terms.rest.iter().map(|rest| -rest).collect();
        for (tie, (part, at)) in self.ties.iter().zip(ties) {
            let rows = self.rows(tie);
            // Into the residual go the force and the constant of the correction at once.
            let push = at.lever.back(&add(&part.force, 1.0, &part.constant));
            for (row, push) in rows.iter().zip(push) {
                load.iter_mut().zip(row).for_each(|(load, row)| *load += row * push);
            }
        }
        let (mut change, mut moved) = self.solve(&condensed, trial, &load, |_| [0.0; 4]);
        let Some(wheel) = self.turning() else {
            return Some(Correction { change, turning: 0.0, ties: moved });
        };
        let by = self.by_turning(&condensed, g, y, trial, &terms);
        let held = ties.iter().map(|(part, at)| moment(&at.place, &add(&part.force, 1.0, &part.constant)));
        let w = turn.speed;
        let torque = dot(&slope[n..2 * n], &terms.euler)
            + turn.acceleration * self.polar(y, &terms)
            + 2.0 * w * dot(&y[n..2 * n], &terms.centrifugal)
            - held.sum::<f64>()
            + self.torque_of(g, trial, &terms, &change, &moved);
        let (ratio, inertia) = (self.train.ratio, wheel.flywheel.inertia);
        let left = y[wheel.at + 2] - inertia * slope[wheel.at + 1] - ratio * torque;
        let turning = left / (inertia + ratio * ratio * by.torque);
        for (change, by) in change.iter_mut().zip(&by.change) {
            *change += ratio * turning * by;
        }
        for (moved, by) in moved.iter_mut().zip(&by.moved) {
            *moved = add(moved, ratio * turning, by);
        }
        Some(Correction { change, turning, ties: moved })
    }

    /// `1 - H J` of all ties.
    fn condensed<'a>(&self, own: &'a Inverse, trial: &Trial) -> Option<Condensed<'a>> {
        let (m, all) = (self.tie_parts, self.tie_rows.len());
        let mut small = vec![0.0; m * m];
        for (to, (_, to_at)) in self.ties.iter().zip(&trial.ties) {
            for (from, (part, from_at)) in self.ties.iter().zip(&trial.ties) {
                // Columns of the compliance between both surfaces, seen at middle and end of the first.
                let mut seen = [[0.0; 4]; 5];
                for (s, seen) in seen.iter_mut().enumerate().take(from.rows()) {
                    let mut column = [0.0; 5];
                    for (r, value) in column.iter_mut().enumerate().take(to.rows()) {
                        *value = own.compliance[(to.row + r) * all + from.row + s];
                    }
                    *seen = to_at.lever.times(&column);
                }
                for i in 0..to.parts() {
                    let h = from_at.lever.times(&seen.map(|column| column[i]));
                    for j in 0..from.parts() {
                        let product: f64 = (0..4).map(|k| h[k] * part.slope[k][j]).sum();
                        small[(to.part + i) * m + from.part + j] = -product;
                    }
                }
            }
        }
        (0..m).for_each(|k| small[k * (m + 1)] += 1.0);
        Some(Condensed { own, factors: Lu::new(m, small).ok()? })
    }

    /// `dk` and `w` under a load on the coordinates and with accelerations of the ties beside `L dk`.
    fn solve(
        &self,
        condensed: &Condensed<'_>,
        trial: &Trial,
        load: &[f64],
        beside: impl Fn(usize) -> Spot,
    ) -> (Vec<f64>, Vec<Spot>) {
        let own = condensed.own;
        let mut change: Vec<f64> =
            own.inverse.chunks(load.len().max(1)).map(|line| dot(line, load)).collect();
        let mut w = Vec::with_capacity(self.tie_parts);
        for (index, (tie, (_, at))) in self.ties.iter().zip(&trial.ties).enumerate() {
            let mut rows = [0.0; 5];
            for (value, row) in rows.iter_mut().zip(self.rows(tie)) {
                *value = dot(row, &change);
            }
            let moved = add(&at.lever.times(&rows), 1.0, &beside(index));
            w.extend(&moved[..tie.parts()]);
        }
        condensed.factors.solve(&mut w);
        let spot = |tie: &Tie| {
            let mut spot = [0.0; 4];
            spot[..tie.parts()].copy_from_slice(&w[tie.part..tie.part + tie.parts()]);
            spot
        };
        let moved: Vec<Spot> = self.ties.iter().map(spot).collect();
        for (tie, ((part, at), w)) in self.ties.iter().zip(trial.ties.iter().zip(&moved)) {
            let push = at.lever.back(&apply(&part.slope, w));
            let images = &own.images[tie.row..tie.row + tie.rows()];
            for (image, push) in images.iter().zip(push).filter(|(_, push)| *push != 0.0) {
                change.iter_mut().zip(image).for_each(|(to, from)| *to += push * from);
            }
        }
        (change, moved)
    }

    /// What a unit of this crankshaft's angular acceleration changes.
    fn by_turning(
        &self,
        condensed: &Condensed<'_>,
        g: f64,
        y: &[f64],
        trial: &Trial,
        terms: &BodyTerms,
    ) -> ByTurning {
        let (n, w) = (self.size, trial.turn.speed);
        let load: Vec<f64> = (0..n)
            .map(|i| -terms.euler[i] - 2.0 * g * (terms.coriolis[i] - w * terms.centrifugal[i]))
            .collect();
        let across = |tie: usize| quarter(&trial.ties[tie].1.place);
        let (change, moved) = self.solve(condensed, trial, &load, across);
        let torque = self.polar(y, terms)
            + 2.0 * g * dot(&y[n..2 * n], &terms.centrifugal)
            + self.torque_of(g, trial, terms, &change, &moved);
        ByTurning { change, moved, torque }
    }

    /// Inertia about the axis at this deformation [kg m^2].
    fn polar(&self, y: &[f64], terms: &BodyTerms) -> f64 {
        let deformed =
            terms.centrifugal.iter().zip(&self.body.centrifugal_load).map(|(all, load)| all + load);
        self.body.polar + y.iter().zip(deformed).map(|(q, own)| q * own).sum::<f64>()
    }

    /// Torque of the flywheel on the crankshaft that these corrections of accelerations need [N m].
    fn torque_of(&self, g: f64, trial: &Trial, terms: &BodyTerms, change: &[f64], moved: &[Spot]) -> f64 {
        let of_ties = trial.ties.iter().zip(moved).map(|((part, at), w)| {
            moment(&at.place, &apply(&part.slope, w)) + g * g * moment(w, &part.force)
        });
        dot(change, &terms.euler) + 2.0 * g * trial.turn.speed * dot(change, &terms.centrifugal)
            - of_ties.sum::<f64>()
    }

    /// How far a correction may go, and how large it is over the tolerances.
    fn reach(&self, g: f64, y: &[f64], trial: &Trial, found: &Correction) -> (f64, f64) {
        let (mut reach, mut size) = (1.0f64, 0.0f64);
        for (index, tie) in self.ties.iter().enumerate() {
            let (part, at) = &trial.ties[index];
            let w = found.ties[index];
            let (law, centre) = match tie.kind {
                Kind::Main(index) => (&self.train.mains[index].law, [0.0; 2]),
                Kind::Free(index, start) => (&self.train.cylinders[index].law, [y[start], y[start + 1]]),
                Kind::Joined(_) => continue,
            };
            let e = tie.within(&at.place, centre, y);
            // A big end without coordinates and a rigid shell do not follow.
            let (big_end, shell) = (part.big_end.at(&w), part.shell.at(&w));
            let follows = [0, 1].map(|k| g * g * big_end[k] + g * shell[k]);
            let mut step = w.map(|part| g * g * part);
            (0..2).for_each(|k| step[k] -= follows[k]);
            size = size.max(length(middle(&step)).max(length(end(&step))) / self.tie_tolerance[index]);
            if let Some(bearing) = law.film() {
                reach = reach.min(within(bearing.clearance, middle(&e), middle(&step)));
            }
        }
        for (change, tolerance) in found.change.iter().zip(&self.coordinate_tolerance) {
            size = size.max((g * g * change).abs() / tolerance);
        }
        if let Some(wheel) = self.turning() {
            size = size.max((g * found.turning).abs() / wheel.tolerance);
        }
        (reach, size)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::{
        CrankBody, CrankTrain, FreeFlywheel, ImposedMotion, PeriodicForce, Slider, TrainCylinder, TrainLaw,
        TrainMain,
    };

    const SPEED: f64 = 400.0;

    /// Five coordinates of any numbers, a big end with a law of its own and one without, one main that yields.
    fn train() -> CrankTrain {
        let n = 5;
        let number = |k: usize| (1.7 * k as f64 + 0.3).sin();
        let row = |from: usize| -> Vec<f64> { (0..n).map(|k| number(from + 3 * k)).collect() };
        let square =
            |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> { (0..n * n).map(|k| of(k / n, k % n)).collect() };
        let body = CrankBody {
            stiffness: vec![0.0, 0.0, 4e7, 9e7, 2e8],
            damping: square(&|i, j| if i == j { 60.0 } else { 0.0 }),
            gyroscopic: square(&|i, j| 0.3 * (number(5 * i + j) - number(5 * j + i))),
            centrifugal: square(&|i, j| 0.2 * (number(5 * i + j) + number(5 * j + i))),
            centrifugal_load: row(31).iter().map(|own| 0.05 * own).collect(),
            euler_load: row(47).iter().map(|own| 0.05 * own).collect(),
            polar: 0.004,
            rows: (0..4).map(|k| [row(60 + 2 * k), row(61 + 2 * k)]).collect(),
            turns: (0..4).map(|k| row(74 + k)).collect(),
            slopes: vec![[vec![0.0; n], vec![0.0; n]]; 4],
            turning: row(90),
        };
        let main = |surface: usize, law| TrainMain { number: surface + 1, surface, law, housing: None };
        let cylinder = |surface: usize, pin: Plane, law| TrainCylinder {
            number: surface - 1,
            surface,
            pin,
            slider: Slider {
                angle: 0.2,
                offset: 0.001,
                length: 0.14,
                piston: 0.4,
                rod: 0.5,
                centre: 0.04,
                inertia: 1.5e-3,
            },
            law,
            housing: None,
            gas: PeriodicForce { period: 12.6, samples: vec![2000.0] },
        };
        CrankTrain {
            body,
            mains: vec![main(0, TrainLaw::bushing(3e8, 2e4)), main(1, TrainLaw::Rigid)],
            cylinders: vec![
                cylinder(2, [0.04, 0.01], TrainLaw::Rigid),
                cylinder(3, [-0.03, 0.02], TrainLaw::bushing(2e8, 1e4)),
            ],
            motion: ImposedMotion::constant(SPEED, 12.6),
            ratio: -1.2,
            phase: 0.4,
        }
    }

    /// The equations with a flywheel that turns under a load, and a state that is none of theirs.
    fn let_go(train: &CrankTrain, inertia: f64, load: f64) -> (Assembly<'_>, Vec<f64>) {
        let flywheel = FreeFlywheel { inertia, train: 0.01, change: 1e-3 };
        let mut assembly = Assembly::new(train, 1e-6, Some(flywheel));
        let mut base = assembly.start();
        let n = assembly.size;
        for (k, value) in base[..2 * n].iter_mut().enumerate() {
            *value = if k < n { 2e-5 } else { 0.05 } * (k as f64).cos();
        }
        assembly.set_flywheel(0.0, &mut base, [0.0, 3.0, load]);
        (assembly, base)
    }

    /// A stage under a load: slope, iterations, torque on the crankshaft.
    fn solved(train: &CrankTrain, inertia: f64, load: f64, g: f64) -> (Vec<f64>, u32, f64) {
        let (mut assembly, base) = let_go(train, inertia, load);
        let mut slope = vec![0.0; base.len()];
        let iterations = assembly.newton(0.0, &base, g, &mut slope).unwrap();
        let wheel = assembly.turning().unwrap().at;
        let speed = train.ratio * (SPEED + slope[wheel]);
        let torque = slope[assembly.sums() + 1] / speed;
        (slope, iterations, torque)
    }

    #[test]
    fn the_flywheel_feels_the_inertia_that_differences_say() {
        let train = train();
        for g in [0.0, 1e-5, 1e-4] {
            // A flywheel of immense inertia turns as its load says.
            let heavy = 1e9;
            let (at, h) = (2000.0, 1.0);
            let [low, high] = [-h, h].map(|by| solved(&train, heavy, heavy * (at + by), g).2);
            let wanted = train.ratio * (high - low) / (2.0 * h);
            let (mut assembly, base) = let_go(&train, heavy, heavy * at);
            let (mut slope, ..) = solved(&train, heavy, heavy * at, g);
            let n = assembly.size;
            let mut y = vec![0.0; base.len()];
            assembly.state(&base, g, &mut slope, &mut y);
            let place = assembly.inverse(g).unwrap();
            let trial = assembly.trial(0.0, &y, g, &slope).unwrap();
            let terms = assembly.body_terms(&trial.turn, &y, &slope[n..2 * n]);
            let condensed = assembly.condensed(&assembly.inverses[place], &trial).unwrap();
            let by = assembly.by_turning(&condensed, g, &y, &trial, &terms);
            let got = train.ratio * train.ratio * by.torque;
            // What the derivatives leave out: (g W)^2 = 2e-3 at the longest stage.
            let bar = 1e-6 + (g * SPEED).powi(2);
            assert!((got / wanted - 1.0).abs() < bar, "{g}: {got} {wanted}");
        }
    }

    #[test]
    fn a_light_flywheel_obeys_its_equation_after_few_iterations() {
        let train = train();
        for (inertia, load) in [(2e-3, -30.0), (0.02, -30.0), (1.0, 200.0)] {
            for g in [0.0, 1e-5, 1e-4] {
                let (slope, iterations, torque) = solved(&train, inertia, load, g);
                let at = slope.len() - super::super::assembly::SUMS - 3;
                let left = load - inertia * slope[at + 1] - train.ratio * torque;
                // Quadratic convergence leaves far less than the correction that counts as none.
                let size = load.abs() + torque.abs();
                assert!(left.abs() < 1e-6 * size, "{inertia} {g}: {left} of {size}");
                // No more iterations than with this acceleration imposed, but for the two that its tolerance takes.
                let imposed = solved(&train, 1e9, 1e9 * slope[at + 1], g).1;
                assert!(iterations <= imposed + 2, "{inertia} {g}: {iterations} {imposed}");
            }
        }
    }
}
