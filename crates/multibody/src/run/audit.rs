//! Audits of a run: energy against works, momenta in space, loops, quaternion.

use crate::powered::{self, Powered, WORKS};
use crate::run::result::{Audit, EnergyLedger};
use crate::run::runner::Runner;
use crate::simulation::{BlockMotion, Drive, LoadLaw, ReactsOn};
use nalgebra::Vector3;
use std::collections::VecDeque;
use std::f64::consts::TAU;

/// What is compared over a run.
pub(crate) struct Auditor {
    start: [f64; 4],
    last: [f64; 4],
    largest_energy: f64,
    /// Of what springs and gravity store.
    largest_stored: f64,
    largest_work: f64,
    off: f64,
    audit: Audit,
    /// Momenta at the start: linear, angular about the origin of the frame.
    momenta: Option<[Vector3<f64>; 2]>,
    largest: [f64; 2],
    changed: [f64; 2],
    /// Crank angle through which sums are kept [rad].
    period: f64,
    /// What stood at the samples of the last period, and at the one before it.
    sums: VecDeque<Sums>,
}

/// Energies and works at a sample.
struct Sums {
    theta: f64,
    energies: [f64; 4],
    works: [f64; WORKS],
    clutch: f64,
}

/// Samples whose crank angles are a period apart to this bound mark its ends [rad].
const SAME_ANGLE: f64 = 1e-6;

/// Share of the energy that springs and gravity store against which the audit is measured at the least.
const AT_REST: f64 = 1e-3;

/// Momenta in space.
fn momenta(powered: &Powered<'_>, theta: f64, state: &[f64]) -> [Vector3<f64>; 2] {
    let motion = powered.motion(theta, state);
    let equations = powered.train.equations(&motion, &powered.places);
    let own = equations.momenta(&motion.speeds());
    let rotation = motion.rotation();
    let linear = rotation * Vector3::new(own[0], own[1], own[2]);
    let angular = rotation * Vector3::new(own[3], own[4], own[5]) + motion.position.cross(&linear);
    [linear, angular]
}

impl Auditor {
    pub fn new(runner: &mut Runner<'_>) -> Auditor {
        let (theta, state) = (runner.state[0], runner.state.clone());
        let start = runner.powered.energy(theta, &state);
        let simulation = runner.powered.simulation;
        let alone = simulation.block == BlockMotion::Floating
            && simulation.gravity == 0.0
            && simulation.torque.is_empty()
            && simulation.driveline.is_empty()
            && matches!(simulation.drive, Drive::Free)
            && (simulation.load.law == LoadLaw::None || simulation.load.reacts_on == ReactsOn::Block)
            && simulation.starter.is_none_or(|starter| starter.reacts_on == ReactsOn::Block);
        let momenta = alone.then(|| momenta(&runner.powered, theta, &state));
        Auditor {
            start,
            last: start,
            largest_energy: 0.0,
            largest_stored: 0.0,
            largest_work: 0.0,
            off: 0.0,
            audit: Audit::default(),
            momenta,
            largest: [0.0; 2],
            changed: [0.0; 2],
            period: TAU * f64::from(runner.powered.train.revolutions),
            sums: VecDeque::new(),
        }
    }

    /// Compares at one sample, which is the last evaluation of `powered`.
    pub fn look(&mut self, powered: &Powered<'_>, theta: f64, state: &[f64]) {
        self.audit.loops = self.audit.loops.max(powered.train.loop_residual(&powered.places));
        let energy = powered.energy_here(theta, state);
        let works = &state[powered.layout.works()..];
        let clutch = powered.conditions.clutch_work;
        self.sums.push_back(Sums { theta, energies: energy, works: powered.layout.all_works(state), clutch });
        let from = theta - self.period - SAME_ANGLE;
        while self.sums.get(1).is_some_and(|second| second.theta < from) {
            self.sums.pop_front();
        }
        let stored: f64 = energy.iter().sum::<f64>() - self.start.iter().sum::<f64>();
        self.off = self.off.max((stored - works.iter().sum::<f64>() - clutch).abs());
        self.largest_stored = self.largest_stored.max(energy[1..].iter().map(|own| own.abs()).sum());
        self.largest_energy = self.largest_energy.max(energy[0].abs());
        self.largest_work = self.largest_work.max(works.iter().map(|work| work.abs()).sum::<f64>() - clutch);
        if powered.layout.moving {
            let at = powered.layout.pose() + 3;
            let size: f64 = state[at..at + 4].iter().map(|q| q * q).sum::<f64>().sqrt();
            self.audit.quaternion = self.audit.quaternion.max((size - 1.0).abs());
        }
        if let Some(start) = self.momenta {
            let now = momenta(powered, theta, state);
            let motion = powered.motion(theta, state);
            // What single parts have: the whole may have none.
            let parts = [self.largest_energy.max(1e-300), motion.speed.abs().max(1.0)];
            let scale = [
                (2.0 * parts[0] * powered.train.block.map_or(1.0, |b| b.mass)).sqrt(),
                2.0 * parts[0] / parts[1],
            ];
            for k in 0..2 {
                self.changed[k] = self.changed[k].max((now[k] - start[k]).norm());
                self.largest[k] = self.largest[k].max(now[k].norm()).max(scale[k]);
            }
        }
    }

    /// Works and energies over the last period between two samples, if the crank turns forward through it.
    fn last_period(&self) -> Option<EnergyLedger> {
        // Its end is the last sample, or the one before where the run ends between two.
        let mut ends = (1..self.sums.len()).rev().take(2);
        let (first, last) = ends.find_map(|last| {
            let start = self.sums[last].theta - self.period;
            let mut before = self.sums.iter().take(last);
            Some((before.position(|own| (own.theta - start).abs() <= SAME_ANGLE)?, last))
        })?;
        let turned = self.sums.range(first..=last);
        if !turned.clone().is_sorted_by(|a, b| a.theta <= b.theta) {
            return None;
        }
        let (start, end) = (&self.sums[first], &self.sums[last]);
        let works: [f64; WORKS] = std::array::from_fn(|k| end.works[k] - start.works[k]);
        let largest = turned.map(|own| own.energies[0].abs()).fold(0.0, f64::max);
        let clutch = end.clutch - start.clutch;
        let throughput = largest + works.iter().map(|work| work.abs()).sum::<f64>() - clutch;
        Some(ledger([start.energies, end.energies], works, clutch, throughput))
    }

    pub fn close(mut self, runner: &mut Runner<'_>) -> (Audit, EnergyLedger, Option<EnergyLedger>) {
        let last_period = self.last_period();
        let works: [f64; WORKS] = runner.powered.layout.all_works(&runner.state);
        let (theta, state) = (runner.state[0], runner.state.clone());
        self.last = runner.powered.energy(theta, &state);
        let throughput = self.largest_energy + self.largest_work;
        // Where nothing moves, the rounding of what springs and gravity store is all there is.
        self.audit.energy = self.off / throughput.max(AT_REST * self.largest_stored).max(f64::MIN_POSITIVE);
        if self.momenta.is_some() {
            let share = |k: usize| self.changed[k] / self.largest[k].max(f64::MIN_POSITIVE);
            self.audit.linear_momentum = Some(share(0));
            self.audit.angular_momentum = Some(share(1));
        }
        let clutch = runner.powered.conditions.clutch_work;
        (self.audit, ledger([self.start, self.last], works, clutch, throughput), last_period)
    }
}

fn ledger(energies: [[f64; 4]; 2], works: [f64; WORKS], clutch: f64, throughput: f64) -> EnergyLedger {
    let both = |k: usize| energies.map(|own| own[k]);
    EnergyLedger {
        kinetic: both(0),
        mounts: both(1),
        gravity: both(2),
        driveline: both(3),
        gas: works[powered::GAS],
        load: works[powered::LOAD],
        starter: works[powered::STARTER],
        friction: works[powered::FRICTION],
        piston_friction: works[powered::PISTON_FRICTION],
        outside: works[powered::OUTSIDE],
        mount_damping: works[powered::MOUNT_DAMPING],
        driveline_damping: works[powered::DRIVELINE_DAMPING],
        clutch,
        throughput,
    }
}
