//! Outputs: what is asked how far it goes with the numbers of the engine.

use super::error::SensitivityError;
use super::operating_point::OperatingPoint;
use lanchester_mechanism::{BearingPart, missing_fix, missing_words};
use lanchester_model::Engine;
use lanchester_results::{self as results, Counted, Place, Quantity};
use serde::Serialize;

/// A load or a result of loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Target {
    /// Resultant inertia force on the block [N].
    Force,
    /// Resultant inertia couple on the block about the origin [N m].
    Couple,
    /// Roll moment of inertia [N m].
    RollMoment,
    /// Torque at crankshaft 1 [N m].
    Torque,
    /// Largest excess energy of that torque at constant speed [J] (book, eq. 25.2).
    ExcessEnergy,
    /// Fluctuation of the speed, `(w_max - w_min)/w_mean` [1], under a load that takes the mean torque (book, eq. 25.7).
    SpeedFluctuation,
    /// Force of the journal on a main bearing [N], by index: those of crankshaft 1 first, each from the free end on; `None`: the
    /// largest of all.
    MainBearing(Option<usize>),
    /// Force of a rod on its lower pin [N], by cylinder: the crankpin, or the knuckle pin of an articulated rod.
    Crankpin(Option<usize>),
    /// Force of a rod on its piston pin [N], by cylinder.
    PistonPin(Option<usize>),
    /// Force of a piston on its cylinder wall [N], by cylinder.
    SideThrust(Option<usize>),
    /// Force of the block on a mount [N], of orders up to 8.
    MountForce(Option<usize>),
    /// Largest bending moment along a crankshaft under all that turns with it, as a free beam [N m], by index.
    BendingMoment(Option<usize>),
}

/// Which number of a load over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Size {
    /// Largest size over the continuous angle; of what has no angle the size itself.
    Peak,
    /// Mean: of a torque with its sign, of forces the mean of their size.
    Mean,
    /// Size of one order [cycles per revolution of crankshaft 1]: the largest resultant of that order over the cycle.
    Order(f64),
}

/// A number that depends on the inputs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Output {
    /// Of what.
    pub target: Target,
    /// Which loads count; force, couple and roll moment are those of inertia.
    pub part: BearingPart,
    /// Which number of it.
    pub size: Size,
}

/// What outputs need beside the crank train.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Needs {
    /// Pressures.
    pub gas: bool,
    /// Flywheel and crankshafts.
    pub flywheel: bool,
    /// Block and mounts.
    pub mounts: bool,
    /// Planes of main bearings.
    pub mains: bool,
}

impl Output {
    /// An output of the inertia loads.
    pub fn of_inertia(target: Target, size: Size) -> Output {
        Output { target, part: BearingPart::Inertia, size }
    }

    /// The peaks of force, couple and roll moment.
    pub fn peaks() -> Vec<Output> {
        [Target::Force, Target::Couple, Target::RollMoment]
            .map(|target| Output::of_inertia(target, Size::Peak))
            .to_vec()
    }

    /// What it needs beside the crank train.
    pub fn needs(self) -> Needs {
        Needs {
            gas: self.part != BearingPart::Inertia,
            flywheel: self.target == Target::SpeedFluctuation,
            mounts: matches!(self.target, Target::MountForce(_)),
            mains: matches!(self.target, Target::MainBearing(_) | Target::BendingMoment(_)),
        }
    }

    /// What `outputs` need together.
    pub fn needs_of(outputs: &[Output]) -> Needs {
        outputs.iter().map(|output| output.needs()).fold(Needs::default(), |all, own| Needs {
            gas: all.gas || own.gas,
            flywheel: all.flywheel || own.flywheel,
            mounts: all.mounts || own.mounts,
            mains: all.mains || own.mains,
        })
    }

    /// What it is in the words of all studies.
    pub fn output(self, engine: &Engine) -> results::Output {
        let number = |index: Option<usize>| index.map_or(Place::Any, |index| Place::Number(index + 1));
        let mount = |index: usize| match engine.mounts.get(index) {
            Some(mount) => Place::Named(mount.name.clone()),
            None => Place::Number(index + 1),
        };
        let (quantity, place) = match self.target {
            Target::Force => (Quantity::Force, Place::Any),
            Target::Couple => (Quantity::Couple, Place::Any),
            Target::RollMoment => (Quantity::RollMoment, Place::Any),
            Target::Torque => (Quantity::Torque, Place::Any),
            Target::ExcessEnergy => (Quantity::ExcessEnergy, Place::Any),
            Target::SpeedFluctuation => (Quantity::SpeedFluctuation, Place::Any),
            Target::MainBearing(one) => (Quantity::MainBearingLoad, number(one)),
            Target::Crankpin(one) => (Quantity::CrankpinLoad, number(one)),
            Target::PistonPin(one) => (Quantity::PistonPinLoad, number(one)),
            Target::SideThrust(one) => (Quantity::SideThrust, number(one)),
            Target::MountForce(one) => (Quantity::MountForce, one.map_or(Place::Any, mount)),
            Target::BendingMoment(one) => (Quantity::BendingMoment, number(one)),
        };
        let size = match self.size {
            _ if self.has_no_angle() => results::Size::Peak,
            Size::Peak => results::Size::Peak,
            Size::Mean => results::Size::Mean,
            Size::Order(order) => results::Size::Order(order),
        };
        let counted = match (self.part, self.target) {
            (_, Target::Force | Target::Couple | Target::RollMoment | Target::BendingMoment(_)) => {
                Counted::Usual
            }
            (BearingPart::All, _) => Counted::Usual,
            (BearingPart::Gas, _) => Counted::Gas,
            (BearingPart::Inertia, _) => Counted::Inertia,
        };
        results::Output { quantity, axis: None, place, size, sense: None, counted }
    }

    /// Name for tables.
    pub fn name(self, engine: &Engine) -> String {
        self.output(engine).sized_title()
    }

    /// Whether it is one number of the cycle, without a peak, a mean or orders.
    pub(super) fn has_no_angle(self) -> bool {
        matches!(self.target, Target::ExcessEnergy | Target::SpeedFluctuation | Target::BendingMoment(_))
    }

    /// Refuses what the engine does not have.
    pub(super) fn check(self, point: &OperatingPoint) -> Result<(), SensitivityError> {
        let engine = &point.engine;
        let mains = || (0..engine.crankshafts.len()).map(|index| engine.main_planes(index).len()).sum();
        let (of, number, count) = match self.target {
            Target::MainBearing(one) => ("main bearing", one, mains()),
            Target::Crankpin(one) => ("crankpin", one, engine.cylinders.len()),
            Target::PistonPin(one) => ("piston pin", one, engine.cylinders.len()),
            Target::SideThrust(one) => ("side thrust", one, engine.cylinders.len()),
            Target::MountForce(one) => ("mount force", one, engine.mounts.len()),
            Target::BendingMoment(one) => ("bending moment", one, engine.crankshafts.len()),
            _ => ("", None, 0),
        };
        if let Some(index) = number.filter(|index| *index >= count) {
            return Err(SensitivityError::NoSuchNumber { of, got: index + 1, count });
        }
        if let Size::Order(order) = self.size
            && !(order > 0.0 && order <= LARGEST_ORDER)
        {
            return Err(SensitivityError::Order { got: order });
        }
        let missing = point.turning.missing();
        if self.needs().flywheel && !missing.is_empty() {
            let (reason, fix) = (missing_words(&missing), missing_fix(&missing));
            return Err(SensitivityError::NoFluctuation { reason, fix });
        }
        if self.needs().gas && point.gas.is_none() {
            return Err(SensitivityError::NoGas { output: self.name(engine) });
        }
        Ok(())
    }
}

/// Highest order: loads of higher ones are nothing but rounding.
const LARGEST_ORDER: f64 = 1000.0;
