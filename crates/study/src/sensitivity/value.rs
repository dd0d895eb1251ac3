//! Values of outputs, by the closed forms of `mechanism`: those that loads, torque, bearings and mounts have.

use super::error::SensitivityError;
use super::mount_force::MOUNT_ORDERS;
use super::operating_point::OperatingPoint;
use super::output::{Output, Size, Target};
use lanchester_mechanism::{
    BearingLoads, BearingPart, BearingRequest, CylinderGas, EnergyVariation, Excitation, GasTrain,
    InternalRequest, Lever, LoadRequest, MountSystem, PinLoad, SpeedResponse, Torque, TorqueError,
    TorqueRequest, bearing_loads, inertia_excitations, internal_moments, merged_orders,
    rotor_inertia_about_z, speed_ripple, torque, total_loads, vector_amplitude,
};
use lanchester_model::{Engine, EngineParts, RotatingKind, Sourced};
use lanchester_results::{Extremes, LoadSet, OrderLoads, PeriodicCurve};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Angles of a revolution from which means and orders of bearing loads are taken.
const SAMPLES: usize = 720;

/// Sizes below this share of all forces are rounding.
const NOTHING: f64 = 1e-10;

/// Values of outputs at an operating point.
///
/// # Errors
/// [`SensitivityError`] where one cannot be computed.
pub(super) fn values(point: &OperatingPoint, outputs: &[Output]) -> Result<Vec<f64>, SensitivityError> {
    let mut known = Known::default();
    outputs
        .iter()
        .map(|output| {
            let value = known.value(point, *output, outputs)?;
            Ok(if value.abs() <= nothing(point, *output) { 0.0 } else { value })
        })
        .collect()
}

/// What is rounding of an output: a small share of all forces as if they pulled one way, over the largest distance where it is a
/// moment or an energy.
pub(super) fn nothing(point: &OperatingPoint, output: Output) -> f64 {
    let engine = &point.engine;
    let radius = |throw: usize| engine.throws[throw].radius;
    let cylinders =
        engine.cylinders.iter().map(|c| (c.reciprocating_mass() + c.rod.big_end_mass) * radius(c.throw));
    let throws = engine.throws.iter().map(|throw| throw.unbalance.abs());
    let weights = engine.counterweights.iter().map(|weight| weight.unbalance);
    let shafts = engine
        .shafts
        .iter()
        .flat_map(|shaft| shaft.weights.iter().map(|weight| weight.unbalance * shaft.ratio.value().powi(2)));
    let inertia = cylinders.chain(throws).chain(weights).chain(shafts).sum::<f64>() * point.speed.powi(2);
    let gas = point.gas.as_ref().filter(|_| output.needs().gas);
    let pressed = gas.iter().flat_map(|gas| gas.iter().zip(&engine.cylinders)).map(|(gas, cylinder)| {
        let [(least, _), (most, _)] = gas.cylinder.extremes();
        let [(beneath, _), (above, _)] = gas.crankcase.extremes();
        let pressure = (most - beneath).abs().max((least - above).abs());
        PI / 4.0 * cylinder.bore.unwrap_or(0.0).powi(2) * pressure
    });
    let force = NOTHING * (inertia + pressed.sum::<f64>());
    match output.target {
        Target::SpeedFluctuation => NOTHING,
        Target::Couple
        | Target::RollMoment
        | Target::Torque
        | Target::ExcessEnergy
        | Target::BendingMoment(_) => {
            let planes = engine.cylinders.iter().map(|c| c.z.abs());
            force * planes.chain(engine.throws.iter().map(|t| t.radius)).fold(0.0f64, f64::max)
        }
        _ => force,
    }
}

/// Results that several outputs are taken from.
#[derive(Default)]
struct Known {
    loads: Option<LoadSet>,
    /// With gas and without.
    torques: Vec<(bool, Torque)>,
    bearings: Vec<BearingLoads>,
    mounts: Vec<(BearingPart, SpeedResponse)>,
}

impl Known {
    fn value(
        &mut self,
        point: &OperatingPoint,
        output: Output,
        all: &[Output],
    ) -> Result<f64, SensitivityError> {
        match output.target {
            Target::Force | Target::Couple | Target::RollMoment => {
                if self.loads.is_none() {
                    let request = LoadRequest {
                        speed: Some(point.speed),
                        samples: 1,
                        max_order: highest(all, 1),
                        ..LoadRequest::default()
                    };
                    self.loads = Some(total_loads(&point.engine, &request)?);
                }
                Ok(self.loads.as_ref().map_or(0.0, |loads| of_block(loads, output)))
            }
            Target::Torque | Target::ExcessEnergy => {
                let gas = output.needs().gas;
                let place = match self.torques.iter().position(|(own, _)| *own == gas) {
                    Some(place) => place,
                    None => {
                        self.torques.push((gas, of_point(point, gas, highest(all, 1))?));
                        self.torques.len() - 1
                    }
                };
                Ok(of_torque(&self.torques[place].1, output))
            }
            Target::SpeedFluctuation => {
                let gas = point.gas.as_deref().filter(|_| output.needs().gas);
                let found = speed_ripple(&point.engine, gas, point.speed, &point.outer, point.turning)?;
                match found.trouble() {
                    Some([reason, fix]) => Err(SensitivityError::NoFluctuation {
                        reason: reason.to_owned(),
                        fix: fix.to_owned(),
                    }),
                    None => Ok(found.periodic().map_or(0.0, |ripple| ripple.fluctuation)),
                }
            }
            Target::BendingMoment(one) => bending_moment(point, one),
            Target::MountForce(one) => {
                let place = self.mounts.iter().position(|(part, _)| *part == output.part);
                let place = match place {
                    Some(place) => place,
                    None => {
                        let response = on_mounts(point, output.part, highest(all, MOUNT_ORDERS))?;
                        self.mounts.push((output.part, response));
                        self.mounts.len() - 1
                    }
                };
                Ok(of_mounts(&self.mounts[place].1, one, output.size))
            }
            target => {
                let place = self.bearings.iter().position(|loads| loads.part == output.part);
                let place = match place {
                    Some(place) => place,
                    None => {
                        let request = BearingRequest {
                            speed: Some(point.speed),
                            part: output.part,
                            counterweights: true,
                            samples: SAMPLES,
                        };
                        self.bearings.push(bearing_loads(&point.engine, point.gas.as_deref(), &request)?);
                        self.bearings.len() - 1
                    }
                };
                Ok(of_bearings(&self.bearings[place], target, output.size))
            }
        }
    }
}

/// The highest order asked for, at least `least`.
fn highest(outputs: &[Output], least: u32) -> u32 {
    let order = |output: &Output| match output.size {
        Size::Order(order) => order.ceil() as u32,
        Size::Peak | Size::Mean => 0,
    };
    outputs.iter().map(order).fold(least, u32::max)
}

fn of_block(loads: &LoadSet, output: Output) -> f64 {
    let Size::Order(order) = output.size else {
        let Extremes { max, min } = match output.target {
            Target::Force => loads.peaks.force,
            Target::Couple => loads.peaks.couple,
            _ => return loads.peaks.roll_moment.max_abs(),
        };
        return max.value.max(min.value);
    };
    let own = loads.orders.iter().find(|own| (own.order - order).abs() < 1e-9);
    own.map_or(0.0, |own: &OrderLoads| match output.target {
        Target::Force => own.force_peak(),
        Target::Couple => own.couple_peak(),
        _ => own.roll_moment.norm(),
    })
}

/// Torque of an operating point; that of inertia alone as of an engine with one pressure on both sides of its pistons.
fn of_point(point: &OperatingPoint, gas: bool, max_order: u32) -> Result<Torque, TorqueError> {
    let request =
        TorqueRequest { speed: Some(point.speed), max_order, samples: 1, ..TorqueRequest::default() };
    match point.gas.as_ref().filter(|_| gas) {
        Some(gas) => torque(&point.engine, gas, &request),
        None => {
            let (engine, gas) = unloaded(&point.engine)?;
            torque(&engine, &gas, &request)
        }
    }
}

/// The engine with pistons on which no gas presses.
fn unloaded(engine: &Engine) -> Result<(Engine, Vec<CylinderGas>), TorqueError> {
    let complete = |parts: &mut EngineParts| {
        for cylinder in &mut parts.cylinders {
            cylinder.bore.get_or_insert(1.0);
            cylinder.firing_angle.get_or_insert(0.0);
        }
    };
    let engine = engine.with(complete).expect("invariant: a bore of 1 m is one");
    let cycle = TAU * f64::from(engine.strokes.revolutions());
    let even = |cylinder: usize| {
        let curve = PeriodicCurve::constant(cycle, 0.0)
            .map_err(|source| TorqueError::Curve { cylinder: cylinder + 1, source })?;
        Ok(CylinderGas { cylinder: curve.clone(), crankcase: curve })
    };
    let gas = (0..engine.cylinders.len()).map(even).collect::<Result<_, TorqueError>>()?;
    Ok((engine, gas))
}

fn of_torque(torque: &Torque, output: Output) -> f64 {
    if output.target == Target::ExcessEnergy {
        let energy: EnergyVariation = match output.part {
            BearingPart::Gas => torque.gas_energy,
            _ => torque.energy,
        };
        return energy.excess;
    }
    let order = match output.size {
        Size::Peak => {
            let extremes = match output.part {
                BearingPart::All => torque.total_extremes,
                BearingPart::Gas => torque.gas_extremes,
                BearingPart::Inertia => torque.inertia_extremes,
            };
            return extremes.max_abs();
        }
        Size::Mean => 0.0,
        Size::Order(order) => order,
    };
    let found = torque.harmonics.iter().find(|own| (own.order - order).abs() < 1e-9);
    let of = |harmonic: Complex64| if order == 0.0 { harmonic.re } else { harmonic.norm() };
    found.map_or(0.0, |own| match output.part {
        BearingPart::All => of(own.total()),
        BearingPart::Gas => of(own.gas),
        BearingPart::Inertia => of(own.inertia),
    })
}

/// The number of `one` of a list, or the largest of all.
fn one_or_largest<T>(list: &[T], one: Option<usize>, number: impl Fn(&T) -> f64) -> f64 {
    match one {
        Some(index) => list.get(index).map_or(0.0, number),
        None => list.iter().map(number).fold(0.0, f64::max),
    }
}

fn of_bearings(loads: &BearingLoads, target: Target, size: Size) -> f64 {
    let pin = |pin: &PinLoad| match size {
        Size::Peak => pin.peak.value,
        Size::Mean => pin.mean,
        Size::Order(order) => {
            let sides = [order, -order].map(|order| coefficient(&pin.load, order, loads.period).norm());
            sides.iter().sum()
        }
    };
    match target {
        Target::MainBearing(one) => one_or_largest(&loads.mains, one, |main| pin(&main.load)),
        Target::Crankpin(one) => one_or_largest(&loads.cylinders, one, |own| pin(&own.lower_pin)),
        Target::PistonPin(one) => one_or_largest(&loads.cylinders, one, |own| pin(&own.piston_pin)),
        _ => {
            let Target::SideThrust(one) = target else { return 0.0 };
            one_or_largest(&loads.cylinders, one, |own| match size {
                Size::Peak => own.largest_thrust.value.abs(),
                Size::Mean => mean_size(&own.side_thrust),
                Size::Order(order) => {
                    let thrust: Vec<Complex64> = own.side_thrust.iter().map(|t| (*t).into()).collect();
                    2.0 * coefficient(&thrust, order, loads.period).norm()
                }
            })
        }
    }
}

/// Mean of the size of what runs straight between equally spaced samples of a period.
fn mean_size(samples: &[f64]) -> f64 {
    let next = samples.iter().cycle().skip(1);
    let parts = samples.iter().zip(next).map(|(from, to)| match from * to < 0.0 {
        true => 0.5 * (from * from + to * to) / (from.abs() + to.abs()),
        false => 0.5 * (from.abs() + to.abs()),
    });
    parts.sum::<f64>() / samples.len() as f64
}

/// Coefficient of `e^{i order theta}` of equally spaced samples of a period; 0 where the order has no whole cycles in it.
fn coefficient(samples: &[Complex64], order: f64, period: f64) -> Complex64 {
    let cycles = order * period / TAU;
    if (cycles - cycles.round()).abs() > 1e-6 {
        return Complex64::ZERO;
    }
    lanchester_results::coefficient(samples.iter().copied(), samples.len(), 0.0, period / TAU, order)
}

/// Largest bending moment of a crankshaft, or of all, under what turns with it.
fn bending_moment(point: &OperatingPoint, one: Option<usize>) -> Result<f64, SensitivityError> {
    let request = InternalRequest { speed: Some(point.speed), samples: 1, ..InternalRequest::default() };
    let found = internal_moments(&point.engine, &request)?.crankshafts;
    let own = found.iter().filter(|own| one.is_none_or(|index| own.crankshaft == index + 1));
    Ok(own.map(|own| own.free_beam.peak_moment.value).fold(0.0, f64::max))
}

fn on_mounts(
    point: &OperatingPoint,
    part: BearingPart,
    max_order: u32,
) -> Result<SpeedResponse, SensitivityError> {
    let engine = &point.engine;
    let mut excitation = match part {
        BearingPart::Gas => Excitation { speed: point.speed, orders: Vec::new() },
        _ => inertia_excitations(engine, &[point.speed], max_order)?.swap_remove(0),
    };
    if let Some(gas) = point.gas.as_ref().filter(|_| part != BearingPart::Inertia) {
        let orders = GasTrain::new(engine, gas, Lever::Exact)?.orders(max_order);
        excitation.orders = merged_orders(&excitation.orders, &orders);
    }
    let system = MountSystem::new(engine)?.with_rotors(rotors_about_z(point));
    let response = system.response(&[excitation])?;
    Ok(response.speeds.into_iter().next().unwrap_or(SpeedResponse {
        speed: point.speed,
        orders: Vec::new(),
        peaks: Vec::new(),
    }))
}

/// Angular momentum of the rotors over the speed [kg m^2], with the flywheel and the crankshafts of the point where it knows them.
fn rotors_about_z(point: &OperatingPoint) -> f64 {
    let turning = point.turning;
    let squares: f64 = point.engine.crankshafts.iter().map(|shaft| shaft.ratio.value().powi(2)).sum();
    let mut bodies = point.engine.rotating_bodies(&[]);
    for body in &mut bodies {
        // The crankshafts together, as seen at crankshaft 1: an equal part to each.
        let own = match body.kind {
            RotatingKind::Flywheel => turning.flywheel,
            RotatingKind::Crankshaft(_) => turning.crankshaft.map(|seen| seen / squares),
            RotatingKind::Shaft(_) | RotatingKind::Gear(_) => None,
        };
        body.inertia = own.map(Sourced::given).or(body.inertia);
    }
    rotor_inertia_about_z(&bodies)
}

fn of_mounts(response: &SpeedResponse, one: Option<usize>, size: Size) -> f64 {
    let Size::Order(order) = size else {
        return one_or_largest(&response.peaks, one, |peak| peak.value);
    };
    let found = response.orders.iter().find(|own| (own.order - order).abs() < 1e-9);
    found.map_or(0.0, |own| one_or_largest(&own.forces, one, vector_amplitude))
}

/// Values of an operating point; none of one that cannot be.
pub(super) fn possible(point: &OperatingPoint, outputs: &[Output]) -> Option<Vec<f64>> {
    let engine = &point.engine;
    let mut masses =
        engine.cylinders.iter().flat_map(|c| [c.piston_mass, c.rod.big_end_mass, c.rod.small_end_mass]);
    let radii = engine.throws.iter().map(|throw| throw.radius);
    let bores = engine.cylinders.iter().filter_map(|cylinder| cylinder.bore);
    let mut mains = engine.crankshafts.iter().filter_map(|crankshaft| crankshaft.mains.as_ref());
    if point.speed <= 0.0 || radii.chain(bores).any(|size| size <= 0.0) || masses.any(|mass| mass < 0.0) {
        return None;
    }
    if mains.any(|planes| !planes.is_sorted_by(|front, rear| front < rear)) {
        return None;
    }
    values(point, outputs).ok()
}
