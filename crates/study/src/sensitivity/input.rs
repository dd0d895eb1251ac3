//! Inputs: quantities of one part, or of all parts of a kind together, and how far they go.

use super::follow::{Weights, follow};
use super::operating_point::OperatingPoint;
use super::quantity::{Axis, Measure, Quantity};
use lanchester_mechanism::CylinderGas;
use lanchester_model::{Engine, EngineParts, Fault, MountSpring};
use lanchester_results::PeriodicCurve;
use lanchester_task::Varied;
use serde::Serialize;

/// A quantity of one part, or of all parts together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Input {
    /// Which quantity.
    pub quantity: Quantity,
    /// Index of the part; `None` for all parts together.
    pub part: Option<usize>,
}

impl Input {
    /// The quantities of an engine, each for all parts together.
    pub fn common(point: &OperatingPoint) -> Vec<Input> {
        Quantity::all()
            .filter(|quantity| !quantity.parts(point).is_empty())
            .map(|quantity| Input { quantity, part: None })
            .collect()
    }

    /// The quantities of an engine, part by part; those of the whole engine once.
    pub fn single(point: &OperatingPoint) -> Vec<Input> {
        Quantity::all()
            .flat_map(|quantity| quantity.parts(point).into_iter().map(move |part| (quantity, part)))
            .map(|(quantity, part)| Input { quantity, part: (!quantity.is_of_engine()).then_some(part) })
            .collect()
    }

    /// An input by which nothing changes.
    pub(super) fn idle() -> Input {
        Input { quantity: Quantity::PinOffset, part: Some(usize::MAX) }
    }

    /// Whether it is about part `index`.
    pub(super) fn is_of(self, index: usize) -> bool {
        self.part.is_none_or(|part| part == index)
    }

    /// Its value, where all of its parts have the same; directions, places of mass and phases have none.
    pub fn nominal(self, point: &OperatingPoint) -> Option<f64> {
        match self.quantity {
            Quantity::Spacing => return point.engine.spacing(),
            quantity if quantity.measure() == Measure::Factor => return Some(1.0),
            _ => {}
        }
        let mut copy = point.clone();
        let mut engine = point.engine.clone().into_parts();
        let values = self.quantity.numbers(&mut engine, &mut copy);
        let of_parts = self.quantity.parts(point).into_iter().zip(values);
        let mut own = of_parts.filter(|(index, _)| self.is_of(*index)).map(|(_, value)| *value);
        let first = own.next()?;
        own.all(|value| (value - first).abs() <= 1e-12 * first.abs()).then_some(first)
    }

    /// Puts this quantity of `point` off by `deviation`, in its SI unit; counterweights that follow go with it.
    ///
    /// # Errors
    /// As [`Engine::new`], where no engine has such a quantity.
    pub fn deviate(self, point: &mut OperatingPoint, deviation: f64) -> Result<(), Vec<Fault>> {
        deviate_all(point, [(self, deviation)])
    }

    fn put_off(self, engine: &mut EngineParts, point: &mut OperatingPoint, deviation: f64) {
        match self.quantity {
            Quantity::Spacing => {
                if let Some(spacing) = engine.spacing() {
                    engine.stretch(1.0 + deviation / spacing);
                }
            }
            Quantity::Part(Varied::RodCentre) => {
                let cylinders = engine.cylinders.iter_mut().enumerate();
                for (_, cylinder) in cylinders.filter(|(index, _)| self.is_of(*index)) {
                    let moved = cylinder.rod.mass() * deviation / cylinder.rod.length;
                    cylinder.rod.small_end_mass += moved;
                    cylinder.rod.big_end_mass -= moved;
                }
            }
            Quantity::Part(Varied::ShaftPhase) => {
                let own = engine.shafts.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
                own.flat_map(|(_, shaft)| &mut shaft.weights).for_each(|weight| weight.phase += deviation);
            }
            Quantity::GasPressure => {
                self.change_gas(point, |gas| gas.cylinder = scaled(&gas.cylinder, 1.0 + deviation));
            }
            Quantity::CrankcasePressure => {
                self.change_gas(point, |gas| gas.crankcase = scaled(&gas.crankcase, 1.0 + deviation));
            }
            Quantity::PressureDelay => self.change_gas(point, |gas| {
                gas.cylinder = gas.cylinder.delayed(deviation);
                gas.crankcase = gas.crankcase.delayed(deviation);
            }),
            Quantity::MountTurn(axis) => {
                self.change_springs(engine, |spring| turn(&mut spring.axes, axis, deviation));
            }
            Quantity::MountStiffness => {
                self.change_springs(engine, |spring| stiffen(spring, &[0, 1, 2], 1.0 + deviation));
            }
            Quantity::MountStiffnessAlong(direction) => {
                self.change_springs(engine, |spring| stiffen(spring, &[direction.index()], 1.0 + deviation));
            }
            Quantity::MountLossFactor => self.change_springs(engine, |spring| {
                let of_table = spring.table.iter_mut().flat_map(|point| &mut point.loss_factor);
                spring.loss_factor.iter_mut().chain(of_table).for_each(|value| *value *= 1.0 + deviation);
            }),
            Quantity::MountDamping => self.change_springs(engine, |spring| {
                spring.damping.iter_mut().for_each(|value| *value *= 1.0 + deviation);
            }),
            quantity => {
                let parts = quantity.parts(point);
                let own = parts.into_iter().zip(quantity.numbers(engine, point));
                own.filter(|(index, _)| self.is_of(*index)).for_each(|(_, value)| *value += deviation);
            }
        }
    }

    fn change_gas(self, point: &mut OperatingPoint, change: impl Fn(&mut CylinderGas)) {
        let gas = point.gas.iter_mut().flatten().enumerate();
        gas.filter(|(index, _)| self.is_of(*index)).for_each(|(_, gas)| change(gas));
    }

    fn change_springs(self, engine: &mut EngineParts, change: impl Fn(&mut MountSpring)) {
        let own = engine.mounts.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
        own.filter_map(|(_, mount)| mount.spring.as_mut()).for_each(change);
    }
}

/// Puts quantities of `point` off one after the other, each by its deviation; what comes out is looked at once.
///
/// # Errors
/// As [`Engine::new`].
pub(super) fn deviate_all(
    point: &mut OperatingPoint,
    deviations: impl IntoIterator<Item = (Input, f64)>,
) -> Result<(), Vec<Fault>> {
    let mut engine = point.engine.clone().into_parts();
    for (input, deviation) in deviations {
        let before = (point.weights == Weights::Follow).then(|| engine.clone());
        input.put_off(&mut engine, point, deviation);
        if let Some(before) = before {
            follow(&before, &mut engine);
        }
    }
    engine.turn_negative_weights();
    point.engine = Engine::new(engine)?;
    Ok(())
}

fn scaled(curve: &PeriodicCurve, factor: f64) -> PeriodicCurve {
    PeriodicCurve::sum(&[(factor, curve)]).expect("invariant: a curve times a finite factor is a curve")
}

/// Stiffens a mount in some of its directions, by their places.
fn stiffen(spring: &mut MountSpring, directions: &[usize], factor: f64) {
    let of_table = spring.table.iter_mut().map(|point| &mut point.stiffness);
    for stiffness in std::iter::once(&mut spring.stiffness).chain(of_table) {
        directions.iter().for_each(|direction| stiffness[*direction] *= factor);
    }
}

/// Turns directions about an axis of the frame.
fn turn(directions: &mut [[f64; 3]; 3], axis: Axis, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    let [next, last] = [1, 2].map(|step| (axis.index() + step) % 3);
    for direction in directions {
        let [from, to] = [direction[next], direction[last]];
        (direction[next], direction[last]) = (cos * from - sin * to, sin * from + cos * to);
    }
}

/// How far an input goes either way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// A share of its nominal value [1].
    Share(f64),
    /// So much, in its SI unit.
    Absolute(f64),
}

impl Amount {
    /// Where nobody says: 1 % of a size or a factor, 1 mm of a place, 1 degree of a direction.
    pub fn standard(measure: Measure) -> Amount {
        match measure {
            Measure::Mass
            | Measure::Length
            | Measure::Unbalance
            | Measure::Inertia
            | Measure::BodyMass
            | Measure::BodyInertia
            | Measure::Speed
            | Measure::Factor => Amount::Share(0.01),
            Measure::Place => Amount::Absolute(1e-3),
            Measure::Angle => Amount::Absolute(1f64.to_radians()),
        }
    }

    /// How far it goes either way of `nominal`, in its SI unit; a share of what has no size is taken of 1.
    pub(super) fn half_width(self, nominal: Option<f64>) -> f64 {
        match self {
            Amount::Absolute(amount) => amount,
            Amount::Share(share) => share * nominal.filter(|size| *size != 0.0).unwrap_or(1.0).abs(),
        }
    }
}
