//! Torque over the working cycle: gas at every cylinder's firing angle, and inertia.

use crate::inertia::request::LoadError;
use crate::speed::energy::{Breaks, SHARE_OF_WIDTH, STRETCHES};
use crate::torque::firing_chart::chart_of;
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::{GasTrain, SAME_PHASE, merged_orders};
use crate::torque::request::{Lever, TorqueError, TorqueRequest};
use crate::torque::result::{
    CylinderTorque, Indicated, IndicatedWork, TORQUE_VERSION, Torque, TorqueHarmonic,
};
use crate::train::drive::Drive;
use crate::train::mechanism::{Mechanism, Piston, Selection};
use crate::train::sampling::sampled_orders;
use crate::train::turned::Turned;
use lanchester_model::Engine;
use lanchester_results::Extreme;
use lanchester_results::OrderLoads;
use lanchester_results::PeriodicCurve;
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Share of the range of a gas force that it must change by within [`JUMP_BESIDE`] of its period to be called a jump.
const JUMP: f64 = 1e-3;
const JUMP_BESIDE: f64 = 1e-9;

/// Inertia torque of an engine, with the lever asked for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InertiaTorque {
    mechanism: Mechanism,
    lever: Lever,
    /// Where the crank of every piston points at `theta = 0`, from the (master's) cylinder axis.
    starts: Vec<Complex64>,
}

impl InertiaTorque {
    pub(crate) fn of(
        engine: &Engine,
        request: &TorqueRequest,
        selection: Selection,
    ) -> Result<InertiaTorque, LoadError> {
        let mechanism = Mechanism::of(engine, &request.loads(), selection)?;
        let starts = mechanism.pistons.iter().map(|piston| Complex64::cis(piston.phase)).collect();
        Ok(InertiaTorque { mechanism, lever: request.lever, starts })
    }

    /// At crankshaft 1 [N m], at constant speed, positive in the sense of rotation.
    pub(crate) fn at(&self, theta: f64) -> f64 {
        self.at_turned(&Turned::at(theta))
    }

    /// Speed of crankshaft 1 [rad/s].
    pub(crate) fn speed(&self) -> f64 {
        self.mechanism.speed
    }

    fn at_turned(&self, turned: &Turned) -> f64 {
        match self.lever {
            Lever::Exact => {
                let pistons = self.mechanism.pistons.iter().zip(&self.starts);
                pistons.map(|(piston, start)| piston.torque_at(start * turned.by(piston.ratio))).sum()
            }
            Lever::Sine => {
                self.mechanism.pistons.iter().map(|piston| with_sine_lever(piston, turned.theta)).sum()
            }
        }
    }
}

/// Torque of the force `-m s''` of piston and small end with the lever `r sin phi` [N m]; the inertia of the rod's swing has no
/// lever of this kind and is left out.
fn with_sine_lever(piston: &Piston, theta: f64) -> f64 {
    let phi = piston.ratio.value() * theta + piston.phase;
    let acceleration = piston.drive.motion(phi).stroke.travel[2];
    piston.ratio.value() * piston.mass * acceleration * piston.crank_radius * phi.sin()
}

impl Mechanism {
    /// Inertia torque at crankshaft 1 [N m] at crank angle `theta` [rad], at constant speed.
    pub fn shaft_torque(&self, theta: f64) -> f64 {
        self.pistons.iter().map(|piston| piston.shaft_torque(theta)).sum()
    }
}

impl Piston {
    /// Its part of the inertia torque at crankshaft 1 [N m].
    fn shaft_torque(&self, theta: f64) -> f64 {
        self.torque_at(Complex64::cis(self.ratio.value() * theta + self.phase))
    }

    /// The same where its crank points along `crank`, of length 1, from the (master's) cylinder axis.
    fn torque_at(&self, crank: Complex64) -> f64 {
        let rate = self.ratio.value();
        let motion = self.drive.motion_at(crank);
        let [_, s1, s2, _] = motion.stroke.travel;
        let [k, k1, _] = motion.stroke.swing;
        let own = -rate * (self.mass * s1 * s2 + self.inertia * k * k1);
        let knuckle = self.knuckle.as_ref().zip(motion.knuckle.as_ref());
        let pin = knuckle.map(|(mass, pin)| mass.mass * (pin.knuckle[1].conj() * pin.knuckle[2]).re);
        own - rate * pin.unwrap_or(0.0)
    }
}

/// Torque of `engine` under `gas`, one entry a cylinder: over the period, by cylinder, by order, with work and firing.
///
/// # Errors
/// [`TorqueError`] where bore, firing or pressures are missing or of another cycle, the lever is not one of this engine, or the
/// request is impossible.
pub fn torque(engine: &Engine, gas: &[CylinderGas], request: &TorqueRequest) -> Result<Torque, TorqueError> {
    let train = GasTrain::new(engine, gas, request.lever)?;
    let inertia = InertiaTorque::of(engine, request, Selection::All)?;
    let speed = inertia.mechanism.speed;
    request.loads().check_angles(train.revolutions)?;
    let period = train.period();
    let count = request.samples * train.revolutions as usize;
    let theta: Vec<f64> = (0..count).map(|j| period * j as f64 / count as f64).collect();
    let turned: Vec<Turned> = theta.iter().map(|theta| Turned::at(*theta)).collect();

    let ratio = engine.gas.as_ref().and_then(lanchester_model::Gas::compression_ratio);
    let mut works = KnownWorks::default();
    let cylinders = (0..engine.cylinders.len())
        .map(|index| {
            let own = InertiaTorque::of(engine, request, Selection::Cylinder(index))?;
            let inertia = turned.iter().map(|turned| own.at_turned(turned)).collect();
            let work = works.of(&train, gas, index);
            Ok(CylinderTorque {
                clearance: ratio.map(|ratio| train.clearance(index, ratio)),
                ..cylinder_torque(&train, gas, index, &turned, inertia, work)
            })
        })
        .collect::<Result<Vec<_>, TorqueError>>()?;
    let sum = |part: fn(&CylinderTorque) -> &Vec<f64>| -> Vec<f64> {
        (0..count).map(|j| cylinders.iter().map(|cylinder| part(cylinder)[j]).sum()).collect()
    };
    let breaks = train.breaks();
    let mean = train.mean_torques().iter().sum::<f64>();
    let inertia_orders = inertia_orders(&inertia);
    let gas_orders = train.orders(request.max_order);
    let of_gas = breaks.sample(|theta| train.torque(theta));
    let of_inertia = breaks.sample(|theta| inertia.at(theta));
    let of_both = of_gas.plus(&of_inertia);
    let orders = merged_orders(&inertia_orders, &gas_orders);
    let harmonics = harmonics(&orders, &inertia_orders);
    // The mean of the inertia torque is zero but for the named lever's errors, which are its own.
    let inertia_mean = of_inertia.integral() / period;
    Ok(Torque {
        version: TORQUE_VERSION,
        engine: engine.name.clone(),
        speed,
        lever: request.lever,
        with_gas: true,
        period,
        gas: sum(|cylinder| &cylinder.gas),
        inertia: sum(|cylinder| &cylinder.inertia),
        gas_extremes: of_gas.extremes(),
        inertia_extremes: of_inertia.extremes(),
        total_extremes: of_both.extremes(),
        indicated: indicated(engine, &train, &cylinders, mean, speed),
        energy: of_both.energy(mean + inertia_mean),
        gas_energy: of_gas.energy(mean),
        orders,
        harmonics,
        cylinders,
        firing: chart_of(engine, &train)?,
        theta,
    })
}

impl GasTrain {
    /// Angles from 0 to `period` at which a gas force jumps, rising.
    pub(crate) fn jumps(&self, period: f64) -> Vec<f64> {
        let mut jumps = Vec::new();
        for piston in &self.pistons {
            let ratio = piston.ratio.value().abs();
            let own = piston.force.period();
            let [(least, _), (most, _)] = piston.force.extremes();
            let cycles = (period * ratio / own).round() as usize;
            let beside = JUMP_BESIDE * own;
            for knot in piston.force.knots() {
                let height = piston.force.at(knot + beside) - piston.force.at(knot - beside);
                if height.abs() > JUMP * (most - least) {
                    let turned = (0..cycles).map(|k| piston.firing + (knot + own * k as f64) / ratio);
                    jumps.extend(turned.map(|theta| theta.rem_euclid(period)));
                }
            }
        }
        jumps.sort_by(f64::total_cmp);
        jumps
    }

    /// Angles at which the torque may jump or bend, and enough in between.
    pub(crate) fn breaks(&self) -> Breaks {
        let period = self.period();
        let knots = self.pistons.iter().flat_map(|piston| {
            let ratio = piston.ratio.value().abs();
            let cycles = (period * ratio / piston.force.period()).round() as usize;
            piston.force.knots().iter().flat_map(move |knot| {
                (0..cycles).map(move |k| piston.firing + (knot + piston.force.period() * k as f64) / ratio)
            })
        });
        let narrowest = self
            .pistons
            .iter()
            .map(|piston| SHARE_OF_WIDTH * piston.width() / piston.ratio.value().abs())
            .fold(2.0 * PI / STRETCHES as f64, f64::min);
        Breaks::new(period, knots, (period / narrowest).ceil() as usize)
    }
}

/// Orders of the inertia loads; with the lever `r sin phi` their torque is the one with that lever, and the roll moment
/// reacts on it.
pub(crate) fn inertia_orders(inertia: &InertiaTorque) -> Vec<OrderLoads> {
    let mut orders = inertia.mechanism.orders();
    if inertia.lever == Lever::Sine {
        for loads in &mut orders {
            loads.roll_moment += loads.shaft_torque;
            loads.shaft_torque = Complex64::ZERO;
        }
        let axis = &inertia.mechanism.axis;
        for piston in &inertia.mechanism.pistons {
            let highest = axis.highest(piston.ratio);
            let band = match &piston.drive {
                Drive::Exact(_) => 0,
                Drive::Series { own, .. } => own.travel.len() + 1,
            };
            let orders_of = sampled_orders(highest, band, |phi| {
                [piston.drive.motion(phi).stroke.travel[2] * piston.crank_radius * phi.sin()]
            });
            for (n, [order]) in orders_of.into_iter().enumerate() {
                let phase = Complex64::cis(n as f64 * piston.phase);
                let sides = if n == 0 { 1.0 } else { 2.0 };
                let torque = piston.ratio.value() * piston.mass * order * phase * sides;
                let torque = if piston.ratio.numerator() < 0 { torque.conj() } else { torque };
                let place = if n == 0 { 0 } else { axis.place(piston.ratio, n) };
                orders[place].shaft_torque += torque;
                orders[place].roll_moment -= torque;
            }
        }
    }
    orders
}

fn harmonics(orders: &[OrderLoads], inertia: &[OrderLoads]) -> Vec<TorqueHarmonic> {
    let of_inertia = |order: f64| {
        let found = inertia.iter().find(|loads| (loads.order - order).abs() <= 1e-9);
        found.map_or(Complex64::ZERO, |loads| loads.shaft_torque)
    };
    let harmonic = |loads: &OrderLoads| {
        let inertia = of_inertia(loads.order);
        TorqueHarmonic { order: loads.order, gas: loads.shaft_torque - inertia, inertia }
    };
    orders.iter().map(harmonic).collect()
}

fn indicated(
    engine: &Engine,
    train: &GasTrain,
    cylinders: &[CylinderTorque],
    mean: f64,
    speed: f64,
) -> Indicated {
    let sum = |part: fn(&IndicatedWork) -> f64| cylinders.iter().map(|c| part(&c.work)).sum::<f64>();
    let displacement = sum(|work| work.swept);
    let ratio = |index: usize| {
        let throw = &engine.throws[engine.cylinders[index].throw];
        engine.crankshafts[throw.crankshaft].ratio.value().abs()
    };
    let piston_speed =
        |index: usize| Indicated::piston_speed(train.motion[index].stroke, ratio(index) * speed);
    let cycle = TAU * f64::from(engine.strokes.revolutions());
    let volumes = cylinders.iter().enumerate().map(|(index, c)| c.work.swept * ratio(index) / cycle);
    Indicated {
        torque: mean,
        power: mean * speed,
        displacement,
        imep: sum(|work| work.cylinder) / displacement,
        crankcase_mep: -sum(|work| work.crankcase) / displacement,
        torque_per_mep: volumes.sum(),
        mean_piston_speed: (0..cylinders.len()).map(piston_speed).fold(0.0, f64::max),
        peak_pressure: cylinders.iter().map(|c| c.peak_pressure.value).fold(f64::NEG_INFINITY, f64::max),
    }
}

fn cylinder_torque(
    train: &GasTrain,
    gas: &[CylinderGas],
    index: usize,
    turned: &[Turned],
    inertia: Vec<f64>,
    work: IndicatedWork,
) -> CylinderTorque {
    let (piston, motion, area, gas) =
        (&train.pistons[index], &train.motion[index], train.areas[index], &gas[index]);
    let over = |curve: &PeriodicCurve| {
        turned.iter().map(|turned| curve.at(piston.own_angle(turned.theta))).collect()
    };
    let [_, (peak, at)] = gas.cylinder.extremes();
    let period = gas.cylinder.period();
    let half_off = (at + 0.5 * period).rem_euclid(period) - 0.5 * period;
    CylinderTorque {
        cylinder: index + 1,
        firing_angle: piston.firing,
        gas: turned.iter().map(|turned| piston.torque_at(turned, train.lever)).collect(),
        inertia,
        pressure: over(&gas.cylinder),
        crankcase: over(&gas.crankcase),
        volume: turned.iter().map(|turned| area * (motion.top - piston.travel(turned))).collect(),
        clearance: None,
        work,
        peak_pressure: Extreme { value: peak, theta: half_off },
    }
}

/// Works that were computed already: cylinders that work alike have the same.
#[derive(Default)]
struct KnownWorks<'a>(Vec<(&'a CylinderGas, usize, IndicatedWork)>);

impl<'a> KnownWorks<'a> {
    fn of(&mut self, train: &GasTrain, gas: &'a [CylinderGas], index: usize) -> IndicatedWork {
        let (piston, down) = (&train.pistons[index], train.down(index));
        let alike = |known: &&(&CylinderGas, usize, IndicatedWork)| {
            let (curves, other, _) = **known;
            // The pressures apart from their difference, and the strokes of what they push on.
            *curves == gas[index]
                && train.pistons[other].works_as(piston)
                && train.areas[other] == train.areas[index]
                && train.motion[other].stroke == train.motion[index].stroke
                && (train.down(other) - down).abs() < SAME_PHASE
        };
        if let Some((_, _, work)) = self.0.iter().find(alike) {
            return *work;
        }
        let (gas, area) = (&gas[index], train.areas[index]);
        let work = IndicatedWork {
            swept: area * train.motion[index].stroke,
            by_torque: piston.work(train.lever),
            by_volume: piston.work_by_volume(&piston.force),
            by_rods: piston.work_by_rods(),
            cylinder: area * piston.work_by_volume(&gas.cylinder),
            gross: area * piston.work_between(&gas.cylinder, down - TAU, down),
            crankcase: -area * piston.work_by_volume(&gas.crankcase),
        };
        self.0.push((gas, index, work));
        work
    }
}

impl GasTrain {
    /// Own angle from top to bottom dead centre [rad]; of a chamber that pistons share that of its volume.
    fn down(&self, index: usize) -> f64 {
        let motion = &self.motion[index];
        let [top, bottom] = match &motion.chamber {
            Some(chamber) => [chamber.top_dead_centre, chamber.bottom_dead_centre],
            None => [motion.top_dead_centre, motion.bottom_dead_centre],
        };
        ((bottom - top) * self.pistons[index].ratio.value().abs()).rem_euclid(TAU)
    }
}
