//! Gas on all pistons of an engine, prepared: its torque at crankshaft 1 at any angle, its work and its orders.
//!
//! ```text
//! f(a)     = (p - p_c) pi/4 B^2                               force on the piston towards the crank     (24.1)
//! T(theta) = n f(a) h(phi)                                    h = -s'(phi): virtual work                (24.2)
//! W        = INTEGRAL over the working cycle of f h da  =  - INTEGRAL of f ds                           (24.3)
//! ```
//! | symbol | name                                                                        | unit |
//! |--------|-----------------------------------------------------------------------------|------|
//! | a      | turned by the own crankshaft since firing, in its sense: `abs(n) (theta - theta_f)` | rad  |
//! | n      | speed ratio of the own crankshaft, signed                                   | -    |
//! | phi    | crank from the (master's) cylinder axis: `phi_f + sign(n) a`                | rad  |
//! | s      | travel of the piston pin ([`crate::linkage`])                               | m    |
//!
//! Gas presses on piston and cylinder head along one line, the cylinder axis, with opposite forces. The block therefore feels
//! no force and no couple of it; what is left is the reaction to the torque that leaves through the driveline:
//!
//! ```text
//! block and moving parts as one:   0 = M_z + T         M_z = -T                                         (24.5)
//! ```

use crate::bearings::rod_force::RodForce;
use crate::inertia::orders::empty;
use crate::inertia::request::LoadRequest;
use crate::inertia::result::CylinderMotion;
use crate::torque::gas::CylinderGas;
use crate::torque::request::{Lever, TorqueError};
use crate::train::drive::{Drive, Linkage};
use crate::train::mechanism::{Piston, firing_period, linkage, master_of};
use crate::train::motion::motion;
use crate::train::sampling::sampled_orders;
use crate::train::series::slider_orders;
use crate::train::turned::Turned;
use lanchester_model::{Engine, Ratio, RodJoint};
use lanchester_numerics::{GAUSS_8, about_zero, unit_points};
use lanchester_results::OrderLoads;
use lanchester_results::PeriodicCurve;
use num_complex::Complex64;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// A part of a quadrature is no wider than this [rad], nor than half of what the motion's nearest singularity is away.
const WIDEST: f64 = 0.2;

/// Crank angles that differ by less than this [rad] are the same.
pub(crate) const SAME_PHASE: f64 = 1e-12;

/// Below this share of the first one, orders of the travel add nothing.
const NEGLIGIBLE: f64 = 1e-17;

/// Most orders of the travel: reached only where a linkage nearly locks.
const MAX_TRAVEL_ORDER: f64 = 2000.0;

/// One piston with its gas.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GasPiston {
    /// Force on the piston towards the crank [N] over the own angle.
    pub force: PeriodicCurve,
    /// Speed ratio of the crankshaft.
    pub ratio: Ratio,
    /// `phi` at firing [rad].
    pub at_firing: f64,
    /// `theta` at firing [rad].
    pub firing: f64,
    /// Where the crank points at `theta = 0`, from the (master's) cylinder axis.
    start: Complex64,
    linkage: Linkage,
    drive: Drive,
    radius: f64,
    /// Widest part of a quadrature [rad].
    width: f64,
}

impl GasPiston {
    /// Angle that the own crankshaft has turned since firing, in its sense [rad].
    pub fn own_angle(&self, theta: f64) -> f64 {
        self.ratio.value().abs() * (theta - self.firing)
    }

    /// Crank from the (master's) cylinder axis [rad].
    fn phi(&self, own: f64) -> f64 {
        self.at_firing + self.sense() * own
    }

    fn sense(&self) -> f64 {
        f64::from(self.ratio.numerator().signum())
    }

    /// Whether another piston has the same torque on its own crankshaft at the same angles after its firing, to the last digit of the pressures.
    pub fn works_as(&self, other: &GasPiston) -> bool {
        let turned = about_zero(self.at_firing - other.at_firing, TAU);
        turned.abs() < SAME_PHASE
            && self.ratio == other.ratio
            && self.radius == other.radius
            && self.linkage == other.linkage
            && self.force == other.force
    }

    /// Lever [m] of a force towards the crank, positive where it drives the own crankshaft.
    fn lever(&self, own: f64, lever: Lever) -> f64 {
        let phi = self.phi(own);
        self.lever_at(Complex64::cis(phi), lever)
    }

    /// The same where the crank points along `crank`, of length 1, from the (master's) cylinder axis.
    fn lever_at(&self, crank: Complex64, lever: Lever) -> f64 {
        let by_phi = match lever {
            Lever::Exact => -self.drive.motion_at(crank).stroke.travel[1],
            Lever::Sine => self.radius * crank.im,
        };
        self.sense() * by_phi
    }

    /// Widest part of a quadrature over the own angle [rad].
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Where the crank points, from the (master's) cylinder axis.
    fn crank(&self, turned: &Turned) -> Complex64 {
        self.start * turned.by(self.ratio)
    }

    /// Travel of the piston pin [m].
    pub fn travel(&self, turned: &Turned) -> f64 {
        self.drive.motion_at(self.crank(turned)).stroke.travel[0]
    }

    /// Torque at crankshaft 1 [N m].
    pub fn torque_at(&self, turned: &Turned, lever: Lever) -> f64 {
        let crank = self.crank(turned);
        let force = self.force.at(self.own_angle(turned.theta));
        self.ratio.value().abs() * force * self.lever_at(crank, lever)
    }

    /// Sum over Gauss points of a working cycle of `term(own angle, force, weight)`.
    fn for_each_point(&self, narrow: f64, mut term: impl FnMut(f64, f64, f64)) {
        for (from, h, [a, b, c, d]) in self.force.pieces() {
            let parts = (h / self.width.min(narrow)).ceil().max(1.0);
            let width = h / parts;
            for part in 0..parts as usize {
                for (x, weight) in unit_points(&GAUSS_8) {
                    let u = width * (part as f64 + x);
                    term(from + u, a + u * (b + u * (c + u * d)), weight * width);
                }
            }
        }
    }

    /// Work of the gas on the piston in a working cycle [J], left of eq. (24.3).
    pub fn work(&self, lever: Lever) -> f64 {
        let mut sum = 0.0;
        self.for_each_point(WIDEST, |own, force, weight| sum += weight * force * self.lever(own, lever));
        sum
    }

    /// The same work by the forces in the rods: side thrust, force on the crankpin, lever of the throw; a master's thrust from its
    /// articulated rods included.
    pub fn work_by_rods(&self) -> f64 {
        let zero = Complex64::ZERO;
        // The rod without masses, its angle that of its crank from the (master's) axis.
        let piston = Piston {
            ratio: Ratio::ONE,
            phase: 0.0,
            drive: self.drive.clone(),
            force: zero,
            couple: zero,
            roll: 0.0,
            mass: 0.0,
            inertia: 0.0,
            knuckle: None,
            crank_radius: self.radius,
            analytic_margin: self.linkage.analytic_margin(),
        };
        let rod = RodForce::new(piston, self.linkage, 0.0);
        let mut sum = 0.0;
        self.for_each_point(WIDEST, |own, force, weight| {
            let phi = self.phi(own);
            let tangential = (rod.loads(phi, force).crankpin * Complex64::cis(-phi)).im;
            sum += weight * self.sense() * self.radius * tangential;
        });
        sum
    }

    /// Work of `force` [N] (or of a pressure, a unit of area [J/m^2]), towards the crank over the own angle, in a working cycle
    /// [J], from its orders and those of the travel, right of eq. (24.3): no quadrature over the torque, no rate of the travel.
    ///
    /// ```text
    /// s = SUM s_m e^{i m phi}      W = -P 2 Re SUM over m > 0 of  i m g s_m e^{i m phi_f} f_(-g m k)                 (24.4)
    /// ```
    /// `P` the period, `k` the revolutions of a working cycle, `g` the sense of rotation.
    pub fn work_by_volume(&self, force: &PeriodicCurve) -> f64 {
        let sense = self.sense();
        let per_revolution = (force.period() / TAU).round() as i32;
        let margin = self.linkage.analytic_margin();
        let highest = (40.0 / margin).ceil().min(MAX_TRAVEL_ORDER) as usize + 1;
        let travel = match &self.linkage {
            Linkage::Plain(slider) => slider_orders(slider, highest).travel,
            Linkage::Articulated(articulated) => {
                let orders = sampled_orders(highest, 0, |phi| [articulated.stroke(phi).travel[0]]);
                orders.into_iter().map(|[order]| order).collect()
            }
        };
        let first = travel.get(1).map_or(0.0, |s| s.norm());
        let mut sum = Complex64::ZERO;
        for (m, order) in travel.iter().enumerate().skip(1) {
            let rate = m as f64;
            if rate * order.norm() <= NEGLIGIBLE * first {
                continue;
            }
            let turned = order * Complex64::from_polar(rate, rate * self.at_firing);
            let harmonic = force.coefficient(-(sense as i32) * m as i32 * per_revolution);
            sum += Complex64::new(0.0, sense) * turned * harmonic;
        }
        -2.0 * force.period() * sum.re
    }

    /// Work of `force`, as above, between two own angles.
    pub fn work_between(&self, force: &PeriodicCurve, from: f64, to: f64) -> f64 {
        let period = force.period();
        let mut cuts: Vec<f64> = force
            .knots()
            .iter()
            .map(|knot| from + (knot - from).rem_euclid(period))
            .filter(|cut| *cut < to)
            .chain([from, to])
            .collect();
        cuts.sort_by(f64::total_cmp);
        let mut sum = 0.0;
        for pair in cuts.windows(2) {
            let parts = ((pair[1] - pair[0]) / self.width).ceil().max(1.0);
            let width = (pair[1] - pair[0]) / parts;
            for part in 0..parts as usize {
                for (x, weight) in unit_points(&GAUSS_8) {
                    let own = pair[0] + width * (part as f64 + x);
                    sum += weight * width * force.at(own) * self.lever(own, Lever::Exact);
                }
            }
        }
        sum
    }

    /// Harmonics `n = 0..=highest` of the torque of the own crankshaft over the working cycle, coefficients of
    /// `e^{i n 2 pi a/P}`.
    fn harmonics(&self, highest: usize, lever: Lever) -> Vec<Complex64> {
        let period = self.force.period();
        let rate = TAU / period;
        let mut sums = vec![Complex64::ZERO; highest + 1];
        // A part has at most two radians of the highest harmonic.
        let narrow = 2.0 / (rate * highest.max(1) as f64);
        self.for_each_point(narrow, |own, force, weight| {
            let value = weight * force * self.lever(own, lever);
            let turn = Complex64::cis(-rate * own);
            let mut phase = Complex64::ONE;
            for (n, sum) in sums.iter_mut().enumerate() {
                // Every so often the phase starts afresh, so that rounding does not pile up.
                phase = if n % 32 == 0 { Complex64::cis(-rate * own * n as f64) } else { phase };
                *sum += phase * value;
                phase *= turn;
            }
        });
        sums.into_iter().map(|sum| sum / period).collect()
    }
}

/// Gas on all pistons of an engine, prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct GasTrain {
    pub(crate) pistons: Vec<GasPiston>,
    /// Motion of every cylinder: dead centres and strokes.
    pub(crate) motion: Vec<CylinderMotion>,
    /// Areas of the pistons [m^2].
    pub(crate) areas: Vec<f64>,
    pub(crate) revolutions: u32,
    pub(crate) lever: Lever,
    cycle: f64,
}

impl GasTrain {
    /// The engine's pistons under `gas`, one entry a cylinder.
    ///
    /// # Errors
    /// [`TorqueError`] where bore, firing or pressures are missing or of another cycle, or the lever is not one of this engine.
    pub fn new(engine: &Engine, gas: &[CylinderGas], lever: Lever) -> Result<GasTrain, TorqueError> {
        let (needed, got) = (engine.cylinders.len(), gas.len());
        if needed != got {
            return Err(TorqueError::CylinderCount { needed, got });
        }
        let motion = motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() })?;
        let pistons = (0..needed)
            .map(|index| gas_piston(engine, index, &gas[index], &motion[index], lever))
            .collect::<Result<Vec<_>, TorqueError>>()?;
        let revolutions = firing_period(engine)?;
        let areas = engine.cylinders.iter().map(|c| area(c.bore.unwrap_or(0.0))).collect();
        let cycle = TAU * f64::from(engine.strokes.revolutions());
        Ok(GasTrain { pistons, motion, areas, revolutions, lever, cycle })
    }

    /// Clearance volume [m^3] of a cylinder by the compression ratio; of a chamber that pistons share the part that goes with its piston's
    /// displacement.
    pub(crate) fn clearance(&self, index: usize, compression_ratio: f64) -> f64 {
        let own = |index: usize| self.areas[index] * self.motion[index].stroke;
        match &self.motion[index].chamber {
            Some(chamber) => {
                let all: f64 = chamber.cylinders.iter().map(|number| own(number - 1)).sum();
                chamber.swept / (compression_ratio - 1.0) * own(index) / all
            }
            None => own(index) / (compression_ratio - 1.0),
        }
    }

    /// Period of the torque [rad] of crankshaft 1: a whole number of revolutions and of working cycles of every crankshaft.
    pub fn period(&self) -> f64 {
        TAU * f64::from(self.revolutions)
    }

    /// Torque of the gas at crankshaft 1 [N m], positive in the sense of rotation.
    pub fn torque(&self, theta: f64) -> f64 {
        let turned = Turned::at(theta);
        self.pistons.iter().map(|piston| piston.torque_at(&turned, self.lever)).sum()
    }

    /// Mean torque of each cylinder at crankshaft 1 [N m]: its work over the angle of its cycle.
    pub fn mean_torques(&self) -> Vec<f64> {
        // Pistons that work alike have one work.
        let mut known: Vec<(&GasPiston, f64)> = Vec::new();
        let mut work = |piston| {
            let found = known.iter().find(|(other, _)| other.works_as(piston)).map(|(_, work)| *work);
            found.unwrap_or_else(|| {
                let work = piston.work(self.lever);
                known.push((piston, work));
                work
            })
        };
        self.pistons.iter().map(|piston| work(piston) * piston.ratio.value().abs() / self.cycle).collect()
    }

    /// Orders of the gas up to `max_order`: those that its cylinders can have, rising, also the vanishing ones. Only roll moment
    /// and shaft torque are not zero; order 0 is the mean. Exact to rounding: integrals over the pieces of the pressures.
    pub fn orders(&self, max_order: u32) -> Vec<OrderLoads> {
        let mut orders: BTreeMap<u64, Complex64> = BTreeMap::new();
        let revolutions = u64::from(self.revolutions);
        let strokes = (self.cycle / TAU).round() as u64;
        // Pistons that move alike under one pressure have the same harmonics, counted from their own firing.
        let mut known: Vec<(&GasPiston, Vec<Complex64>)> = Vec::new();
        for piston in &self.pistons {
            let (n, d) =
                (u64::from(piston.ratio.numerator().unsigned_abs()), u64::from(piston.ratio.denominator()));
            // Harmonic 1 of the working cycle, as a key: order times revolutions.
            let key = n * revolutions / (d * strokes);
            let highest = u64::from(max_order) * revolutions / key;
            let place = known.iter().position(|(other, _)| other.works_as(piston));
            let place = place.unwrap_or_else(|| {
                known.push((piston, piston.harmonics(highest as usize, self.lever)));
                known.len() - 1
            });
            for (place, harmonic) in known[place].1.iter().enumerate() {
                let order = (place as u64 * key) as f64 / revolutions as f64;
                let sides = if place == 0 { 1.0 } else { 2.0 };
                let turned = harmonic * Complex64::from_polar(sides, -order * piston.firing);
                *orders.entry(place as u64 * key).or_default() += piston.ratio.value().abs() * turned;
            }
        }
        let loads = orders.into_iter().map(|(key, torque)| OrderLoads {
            roll_moment: -torque,
            shaft_torque: torque,
            ..empty(key as f64 / revolutions as f64)
        });
        loads.collect()
    }
}

/// Orders of inertia and gas together: for mounts, and for whatever takes orders.
///
/// Both lists rise; an order that only one of them has is kept.
pub fn merged_orders(one: &[OrderLoads], other: &[OrderLoads]) -> Vec<OrderLoads> {
    let mut all: Vec<OrderLoads> = one.iter().chain(other).copied().collect();
    all.sort_by(|a, b| a.order.total_cmp(&b.order));
    let mut merged: Vec<OrderLoads> = Vec::with_capacity(all.len());
    for next in all {
        match merged.last_mut().filter(|last| (last.order - next.order).abs() <= 1e-9) {
            Some(last) => {
                last.force_forward += next.force_forward;
                last.force_backward += next.force_backward;
                last.couple_forward += next.couple_forward;
                last.couple_backward += next.couple_backward;
                last.roll_moment += next.roll_moment;
                last.shaft_torque += next.shaft_torque;
            }
            None => merged.push(next),
        }
    }
    merged
}

/// `theta` of firing [rad]; a lone cylinder needs no firing in the file, it fires at its first top dead centre.
pub(crate) fn firing_angle(engine: &Engine, motion: &CylinderMotion) -> Result<f64, TorqueError> {
    let lone = (engine.cylinders.len() == 1).then_some(motion.top_dead_centre);
    motion.firing_angle.or(lone).ok_or(TorqueError::NoFiring { cylinder: motion.cylinder })
}

/// Refuses the lever `r sin phi` where the linkage is another one.
pub(crate) fn check_lever(engine: &Engine, index: usize, lever: Lever) -> Result<(), TorqueError> {
    let cylinder = &engine.cylinders[index];
    let found = match cylinder.rod.joint {
        _ if lever != Lever::Sine => None,
        RodJoint::Articulated { .. } => Some("an articulated rod"),
        _ => (cylinder.net_offset() != 0.0).then_some("an offset"),
    };
    found.map_or(Ok(()), |found| Err(TorqueError::SineLever { cylinder: index + 1, found }))
}

pub(crate) fn area(bore: f64) -> f64 {
    PI / 4.0 * bore * bore
}

fn gas_piston(
    engine: &Engine,
    index: usize,
    gas: &CylinderGas,
    motion: &CylinderMotion,
    lever: Lever,
) -> Result<GasPiston, TorqueError> {
    let number = index + 1;
    let cylinder = &engine.cylinders[index];
    let bore = cylinder.bore.ok_or(TorqueError::NoBore { cylinder: number })?;
    let firing = firing_angle(engine, motion)?;
    let needed = TAU * f64::from(engine.strokes.revolutions());
    for curve in [&gas.cylinder, &gas.crankcase] {
        let got = curve.period();
        if (got - needed).abs() > 1e-9 * needed {
            return Err(TorqueError::Period { cylinder: number, needed, got });
        }
    }
    check_lever(engine, index, lever)?;
    let area = area(bore);
    let force = PeriodicCurve::sum(&[(area, &gas.cylinder), (-area, &gas.crankcase)])
        .map_err(|source| TorqueError::Curve { cylinder: number, source })?;
    let throw = &engine.throws[cylinder.throw];
    let ratio = engine.crankshafts[throw.crankshaft].ratio;
    let axis = engine.cylinders[master_of(cylinder).unwrap_or(index)].angle;
    let linkage = linkage(engine, index)?;
    let at_firing = engine.pin_angle(cylinder.throw, firing) - axis;
    Ok(GasPiston {
        force,
        ratio,
        at_firing,
        firing,
        start: Complex64::cis(at_firing - ratio.value() * firing),
        linkage,
        drive: Drive::Exact(linkage),
        radius: throw.radius,
        width: WIDEST.min(0.5 * linkage.analytic_margin()),
    })
}
