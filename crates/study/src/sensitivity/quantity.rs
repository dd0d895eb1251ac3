//! Quantities: the numbers of an engine that its loads depend on.

use super::operating_point::OperatingPoint;
use super::output::Needs;
use lanchester_model::{Engine, EngineParts, RodJoint};
use lanchester_task::Varied;
use serde::Serialize;

/// An axis of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Up.
    X,
    /// Across.
    Y,
    /// Along the crank.
    Z,
}

impl Axis {
    /// All three.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// Its place in a vector.
    pub(super) fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        }
    }

    /// One of three names.
    fn choose(self, names: [&'static str; 3]) -> &'static str {
        names[self.index()]
    }
}

/// One of the three directions in which a mount yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// The mount's own first one.
    First,
    /// At a right angle to it.
    Second,
    /// At a right angle to both.
    Third,
}

impl Direction {
    /// All three.
    pub const ALL: [Direction; 3] = [Direction::First, Direction::Second, Direction::Third];

    /// Its place in a list of three.
    pub(super) fn index(self) -> usize {
        match self {
            Direction::First => 0,
            Direction::Second => 1,
            Direction::Third => 2,
        }
    }
}

/// A number of the engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Speed of crankshaft 1 [rad/s]. The pressures over the angle stay.
    Speed,
    /// Distance of the cylinders along the crank [m]: planes of throws, main bearings, cylinders and counterweights stretch about the
    /// origin, balance shafts stay.
    Spacing,
    /// What production varies too.
    Part(Varied),
    /// Moment of inertia of a rod about its own centre of gravity [kg m^2], where the file gives it.
    RodInertia,
    /// Offset of the piston pin in its piston [m].
    PinOffset,
    /// Plane of a throw's own unbalance [m].
    ThrowPlane,
    /// Plane of a counterweight [m].
    CounterweightPlane,
    /// Plane of a weight on a balance shaft [m].
    ShaftWeightPlane,
    /// Place of the axis of a crankshaft along x [m]; its cylinders move with it.
    CrankshaftX,
    /// Place of the axis of a crankshaft along y [m]; its cylinders move with it.
    CrankshaftY,
    /// Angle at which a crankshaft is geared to the first [rad].
    CrankshaftPhase,
    /// Distance of the knuckle pin of an articulated rod from the big end of its master rod [m].
    KnuckleRadius,
    /// Angle of a knuckle pin from its master rod [rad].
    KnuckleAngle,
    /// Plane of a main bearing [m].
    MainPlane,
    /// Place of a balance shaft along x [m].
    ShaftX,
    /// Place of a balance shaft along y [m].
    ShaftY,
    /// Bore of a cylinder [m].
    Bore,
    /// Factor on the absolute pressure in a cylinder [1]; what is under the piston stays.
    GasPressure,
    /// Factor on the absolute pressure under a piston [1].
    CrankcasePressure,
    /// Angle of its crankshaft by which the pressures of a cylinder come later [rad]: an ignition that is late, or a top dead centre
    /// that was measured at a wrong angle.
    PressureDelay,
    /// Moment of inertia of the flywheel [kg m^2].
    FlywheelInertia,
    /// Moment of inertia of the crankshafts, as seen at crankshaft 1 [kg m^2].
    CrankshaftInertia,
    /// Mass of the block [kg].
    BlockMass,
    /// Place of the block's centre of mass [m].
    BlockCentre(Axis),
    /// Moment of inertia of the block about its centre [kg m^2].
    BlockInertia(Axis),
    /// Product of inertia of the block: that of an axis and the next, xy, yz, zx [kg m^2].
    BlockProduct(Axis),
    /// Place of a mount [m].
    MountPlace(Axis),
    /// Angle by which a mount with all its directions is turned about an axis of the frame [rad].
    MountTurn(Axis),
    /// Factor on the stiffness of a mount in all its directions, its table included [1]; loss factors stay.
    MountStiffness,
    /// The same in one of its directions.
    MountStiffnessAlong(Direction),
    /// Factor on the loss factors of a mount, its table included [1].
    MountLossFactor,
    /// Factor on the viscous damping of a mount [1].
    MountDamping,
}

/// How a quantity is measured, and what a small change of it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// A mass [kg].
    Mass,
    /// A size, such as a length of a rod [m].
    Length,
    /// A place or an offset [m], which may be 0.
    Place,
    /// A direction [rad].
    Angle,
    /// An unbalance [kg m].
    Unbalance,
    /// A moment of inertia of a part [kg m^2].
    Inertia,
    /// A mass of the block [kg].
    BodyMass,
    /// A moment of inertia of the block or the flywheel [kg m^2].
    BodyInertia,
    /// A speed [rad/s].
    Speed,
    /// A factor on what the file says [1].
    Factor,
}

impl Quantity {
    /// All of them, in the order of tables.
    pub fn all() -> impl Iterator<Item = Quantity> {
        let of_train = [
            Quantity::RodInertia,
            Quantity::PinOffset,
            Quantity::ThrowPlane,
            Quantity::CounterweightPlane,
            Quantity::ShaftWeightPlane,
            Quantity::CrankshaftX,
            Quantity::CrankshaftY,
            Quantity::CrankshaftPhase,
            Quantity::KnuckleRadius,
            Quantity::KnuckleAngle,
            Quantity::MainPlane,
            Quantity::ShaftX,
            Quantity::ShaftY,
            Quantity::Bore,
            Quantity::GasPressure,
            Quantity::CrankcasePressure,
            Quantity::PressureDelay,
            Quantity::FlywheelInertia,
            Quantity::CrankshaftInertia,
            Quantity::BlockMass,
        ];
        let by_axis: [fn(Axis) -> Quantity; 5] = [
            Quantity::BlockCentre,
            Quantity::BlockInertia,
            Quantity::BlockProduct,
            Quantity::MountPlace,
            Quantity::MountTurn,
        ];
        [Quantity::Speed, Quantity::Spacing]
            .into_iter()
            .chain(Varied::ALL.map(Quantity::Part))
            .chain(of_train)
            .chain(by_axis.into_iter().flat_map(|of| Axis::ALL.map(of)))
            .chain([Quantity::MountStiffness])
            .chain(Direction::ALL.map(Quantity::MountStiffnessAlong))
            .chain([Quantity::MountLossFactor, Quantity::MountDamping])
    }

    /// Name for tables, options and messages.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Speed => "speed",
            Quantity::Spacing => "cylinder spacing",
            Quantity::Part(varied) => varied.name(),
            Quantity::RodInertia => "rod inertia",
            Quantity::PinOffset => "piston-pin offset",
            Quantity::ThrowPlane => "throw plane",
            Quantity::CounterweightPlane => "counterweight plane",
            Quantity::ShaftWeightPlane => "balance-shaft weight plane",
            Quantity::CrankshaftX => "crankshaft x",
            Quantity::CrankshaftY => "crankshaft y",
            Quantity::CrankshaftPhase => "crankshaft phase",
            Quantity::KnuckleRadius => "knuckle radius",
            Quantity::KnuckleAngle => "knuckle angle",
            Quantity::MainPlane => "main-bearing plane",
            Quantity::ShaftX => "balance-shaft x",
            Quantity::ShaftY => "balance-shaft y",
            Quantity::Bore => "bore",
            Quantity::GasPressure => "gas pressure",
            Quantity::CrankcasePressure => "crankcase pressure",
            Quantity::PressureDelay => "pressure delay",
            Quantity::FlywheelInertia => "flywheel inertia",
            Quantity::CrankshaftInertia => "crankshaft inertia",
            Quantity::BlockMass => "block mass",
            Quantity::BlockCentre(axis) => {
                axis.choose(["block centre x", "block centre y", "block centre z"])
            }
            Quantity::BlockInertia(axis) => {
                axis.choose(["block inertia about x", "block inertia about y", "block inertia about z"])
            }
            Quantity::BlockProduct(axis) => {
                axis.choose(["block product xy", "block product yz", "block product zx"])
            }
            Quantity::MountPlace(axis) => axis.choose(["mount x", "mount y", "mount z"]),
            Quantity::MountTurn(axis) => {
                axis.choose(["mount turned about x", "mount turned about y", "mount turned about z"])
            }
            Quantity::MountStiffness => "mount stiffness",
            Quantity::MountStiffnessAlong(Direction::First) => "first mount stiffness",
            Quantity::MountStiffnessAlong(Direction::Second) => "second mount stiffness",
            Quantity::MountStiffnessAlong(Direction::Third) => "third mount stiffness",
            Quantity::MountLossFactor => "mount loss factor",
            Quantity::MountDamping => "mount damping",
        }
    }

    /// How it is measured.
    pub fn measure(self) -> Measure {
        match self {
            Quantity::Speed => Measure::Speed,
            Quantity::Spacing | Quantity::KnuckleRadius | Quantity::Bore => Measure::Length,
            Quantity::RodInertia => Measure::Inertia,
            Quantity::FlywheelInertia
            | Quantity::CrankshaftInertia
            | Quantity::BlockInertia(_)
            | Quantity::BlockProduct(_) => Measure::BodyInertia,
            Quantity::Part(varied) => match varied {
                Varied::PistonMass | Varied::BigEndMass | Varied::SmallEndMass => Measure::Mass,
                Varied::RodLength | Varied::CrankRadius => Measure::Length,
                Varied::RodCentre | Varied::Offset | Varied::CylinderPlane => Measure::Place,
                Varied::ThrowAngle
                | Varied::CylinderAngle
                | Varied::CounterweightAngle
                | Varied::ShaftPhase => Measure::Angle,
                Varied::ThrowUnbalance | Varied::CounterweightUnbalance | Varied::ShaftUnbalance => {
                    Measure::Unbalance
                }
            },
            Quantity::PinOffset
            | Quantity::ThrowPlane
            | Quantity::CounterweightPlane
            | Quantity::ShaftWeightPlane
            | Quantity::CrankshaftX
            | Quantity::CrankshaftY
            | Quantity::MainPlane
            | Quantity::ShaftX
            | Quantity::ShaftY
            | Quantity::BlockCentre(_)
            | Quantity::MountPlace(_) => Measure::Place,
            Quantity::CrankshaftPhase
            | Quantity::KnuckleAngle
            | Quantity::PressureDelay
            | Quantity::MountTurn(_) => Measure::Angle,
            Quantity::BlockMass => Measure::BodyMass,
            Quantity::GasPressure
            | Quantity::CrankcasePressure
            | Quantity::MountStiffness
            | Quantity::MountStiffnessAlong(_)
            | Quantity::MountLossFactor
            | Quantity::MountDamping => Measure::Factor,
        }
    }

    /// Whether it is one number of the whole engine.
    pub fn is_of_engine(self) -> bool {
        matches!(
            self,
            Quantity::Speed
                | Quantity::Spacing
                | Quantity::FlywheelInertia
                | Quantity::CrankshaftInertia
                | Quantity::BlockMass
                | Quantity::BlockCentre(_)
                | Quantity::BlockInertia(_)
                | Quantity::BlockProduct(_)
        )
    }

    /// Whether outputs with these needs can depend on it.
    pub(super) fn matters_to(self, needs: Needs) -> bool {
        match self {
            Quantity::Bore
            | Quantity::GasPressure
            | Quantity::CrankcasePressure
            | Quantity::PressureDelay => needs.gas,
            Quantity::MainPlane => needs.mains,
            Quantity::FlywheelInertia | Quantity::CrankshaftInertia => needs.flywheel,
            Quantity::BlockMass
            | Quantity::BlockCentre(_)
            | Quantity::BlockInertia(_)
            | Quantity::BlockProduct(_)
            | Quantity::MountPlace(_)
            | Quantity::MountTurn(_)
            | Quantity::MountStiffness
            | Quantity::MountStiffnessAlong(_)
            | Quantity::MountLossFactor
            | Quantity::MountDamping => needs.mounts,
            _ => true,
        }
    }

    /// The parts that have it, by their index: articulated rods by that of their cylinder.
    pub fn parts(self, point: &OperatingPoint) -> Vec<usize> {
        match self {
            Quantity::KnuckleRadius | Quantity::KnuckleAngle => articulated(&point.engine).collect(),
            _ => (0..self.count(point)).collect(),
        }
    }

    /// How many parts have it.
    fn count(self, point: &OperatingPoint) -> usize {
        let engine = &point.engine;
        match self {
            Quantity::Speed => 1,
            Quantity::Spacing => usize::from(engine.spacing().is_some()),
            Quantity::Part(varied) => varied.parts(engine),
            Quantity::RodInertia if engine.cylinders.iter().any(|c| c.rod.inertia.is_none()) => 0,
            Quantity::RodInertia | Quantity::PinOffset => engine.cylinders.len(),
            Quantity::KnuckleRadius | Quantity::KnuckleAngle => articulated(engine).count(),
            Quantity::ThrowPlane => engine.throws.len(),
            Quantity::CounterweightPlane => engine.counterweights.len(),
            Quantity::ShaftWeightPlane => engine.shafts.iter().map(|shaft| shaft.weights.len()).sum(),
            // The first is where angles count from.
            Quantity::CrankshaftPhase if engine.crankshafts.len() == 1 => 0,
            Quantity::CrankshaftX | Quantity::CrankshaftY | Quantity::CrankshaftPhase => {
                engine.crankshafts.len()
            }
            Quantity::MainPlane => {
                (0..engine.crankshafts.len()).map(|index| engine.main_planes(index).len()).sum()
            }
            Quantity::ShaftX | Quantity::ShaftY => engine.shafts.len(),
            Quantity::Bore if engine.cylinders.iter().any(|c| c.bore.is_none()) => 0,
            Quantity::Bore => engine.cylinders.len(),
            Quantity::GasPressure | Quantity::CrankcasePressure | Quantity::PressureDelay => {
                point.gas.as_ref().map_or(0, Vec::len)
            }
            Quantity::FlywheelInertia => {
                usize::from(point.turning.flywheel.is_some_and(|inertia| inertia > 0.0))
            }
            Quantity::CrankshaftInertia => {
                usize::from(point.turning.crankshaft.is_some_and(|inertia| inertia > 0.0))
            }
            Quantity::BlockMass
            | Quantity::BlockCentre(_)
            | Quantity::BlockInertia(_)
            | Quantity::BlockProduct(_) => usize::from(engine.block.is_some()),
            Quantity::MountPlace(_) => engine.mounts.len(),
            Quantity::MountTurn(_)
            | Quantity::MountStiffness
            | Quantity::MountStiffnessAlong(_)
            | Quantity::MountLossFactor
            | Quantity::MountDamping => {
                let all_yield = engine.mounts.iter().all(|mount| mount.spring.is_some());
                if all_yield { engine.mounts.len() } else { 0 }
            }
        }
    }

    /// The numbers that it is, those of [`Quantity::parts`] in their order: to change one is to change the engine. None for what no single
    /// number holds: spacing, [`Varied::RodCentre`], which moves mass between the ends of a rod, [`Varied::ShaftPhase`], which turns all
    /// weights of a shaft, pressures that come later, mounts that are turned, and factors. Main bearings stay where they are when the rest
    /// moves from then on.
    pub(super) fn numbers<'a>(
        self,
        engine: &'a mut EngineParts,
        point: &'a mut OperatingPoint,
    ) -> Vec<&'a mut f64> {
        match self {
            Quantity::Speed => vec![&mut point.speed],
            Quantity::Spacing
            | Quantity::Part(Varied::RodCentre | Varied::ShaftPhase)
            | Quantity::GasPressure
            | Quantity::CrankcasePressure
            | Quantity::PressureDelay
            | Quantity::MountTurn(_)
            | Quantity::MountStiffness
            | Quantity::MountStiffnessAlong(_)
            | Quantity::MountLossFactor
            | Quantity::MountDamping => Vec::new(),
            Quantity::Part(Varied::PistonMass) => {
                engine.cylinders.iter_mut().map(|c| &mut c.piston_mass).collect()
            }
            Quantity::Part(Varied::BigEndMass) => {
                engine.cylinders.iter_mut().map(|c| &mut c.rod.big_end_mass).collect()
            }
            Quantity::Part(Varied::SmallEndMass) => {
                engine.cylinders.iter_mut().map(|c| &mut c.rod.small_end_mass).collect()
            }
            Quantity::Part(Varied::RodLength) => {
                engine.cylinders.iter_mut().map(|c| &mut c.rod.length).collect()
            }
            Quantity::Part(Varied::Offset) => engine.cylinders.iter_mut().map(|c| &mut c.offset).collect(),
            Quantity::Part(Varied::CylinderPlane) => engine.cylinders.iter_mut().map(|c| &mut c.z).collect(),
            Quantity::Part(Varied::CylinderAngle) => {
                engine.cylinders.iter_mut().map(|c| &mut c.angle).collect()
            }
            Quantity::Part(Varied::CrankRadius) => engine.throws.iter_mut().map(|t| &mut t.radius).collect(),
            Quantity::Part(Varied::ThrowAngle) => engine.throws.iter_mut().map(|t| &mut t.angle).collect(),
            Quantity::Part(Varied::ThrowUnbalance) => {
                engine.throws.iter_mut().map(|t| &mut t.unbalance).collect()
            }
            Quantity::Part(Varied::CounterweightUnbalance) => {
                engine.counterweights.iter_mut().map(|w| &mut w.unbalance).collect()
            }
            Quantity::Part(Varied::CounterweightAngle) => {
                engine.counterweights.iter_mut().map(|w| &mut w.angle).collect()
            }
            Quantity::Part(Varied::ShaftUnbalance) => {
                engine.shafts.iter_mut().flat_map(|s| &mut s.weights).map(|w| &mut w.unbalance).collect()
            }
            Quantity::RodInertia => {
                engine.cylinders.iter_mut().filter_map(|c| c.rod.inertia.as_mut()).collect()
            }
            Quantity::PinOffset => engine.cylinders.iter_mut().map(|c| &mut c.pin_offset).collect(),
            Quantity::ThrowPlane => engine.throws.iter_mut().map(|t| &mut t.unbalance_offset).collect(),
            Quantity::CounterweightPlane => engine.counterweights.iter_mut().map(|w| &mut w.z).collect(),
            Quantity::ShaftWeightPlane => {
                engine.shafts.iter_mut().flat_map(|s| &mut s.weights).map(|w| &mut w.z).collect()
            }
            Quantity::CrankshaftX => engine.crankshafts.iter_mut().map(|c| &mut c.x).collect(),
            Quantity::CrankshaftY => engine.crankshafts.iter_mut().map(|c| &mut c.y).collect(),
            Quantity::CrankshaftPhase => engine.crankshafts.iter_mut().map(|c| &mut c.phase).collect(),
            Quantity::KnuckleRadius => knuckles(engine).map(|[radius, _]| radius).collect(),
            Quantity::KnuckleAngle => knuckles(engine).map(|[_, angle]| angle).collect(),
            Quantity::MainPlane => {
                for index in 0..engine.crankshafts.len() {
                    engine.crankshafts[index].mains = Some(engine.main_planes(index));
                }
                engine.crankshafts.iter_mut().filter_map(|c| c.mains.as_mut()).flatten().collect()
            }
            Quantity::ShaftX => engine.shafts.iter_mut().map(|s| &mut s.x).collect(),
            Quantity::ShaftY => engine.shafts.iter_mut().map(|s| &mut s.y).collect(),
            Quantity::Bore => engine.cylinders.iter_mut().filter_map(|c| c.bore.as_mut()).collect(),
            Quantity::FlywheelInertia => point.turning.flywheel.iter_mut().collect(),
            Quantity::CrankshaftInertia => point.turning.crankshaft.iter_mut().collect(),
            Quantity::BlockMass => engine.block.iter_mut().map(|b| &mut b.mass).collect(),
            Quantity::BlockCentre(axis) => {
                engine.block.iter_mut().map(|b| &mut b.centre[axis.index()]).collect()
            }
            Quantity::BlockInertia(axis) => {
                engine.block.iter_mut().map(|b| &mut b.inertia[axis.index()]).collect()
            }
            Quantity::BlockProduct(axis) => {
                engine.block.iter_mut().map(|b| &mut b.products[axis.index()]).collect()
            }
            Quantity::MountPlace(axis) => engine
                .mounts
                .iter_mut()
                .map(|mount| match axis {
                    Axis::X => &mut mount.x,
                    Axis::Y => &mut mount.y,
                    Axis::Z => &mut mount.z,
                })
                .collect(),
        }
    }
}

/// Cylinders whose rods are articulated.
fn articulated(engine: &Engine) -> impl Iterator<Item = usize> {
    let rods = engine.cylinders.iter().enumerate();
    rods.filter(|(_, cylinder)| matches!(cylinder.rod.joint, RodJoint::Articulated { .. }))
        .map(|(index, _)| index)
}

/// Radii and angles of the knuckle pins of articulated rods.
fn knuckles(engine: &mut EngineParts) -> impl Iterator<Item = [&mut f64; 2]> {
    engine.cylinders.iter_mut().filter_map(|cylinder| match &mut cylinder.rod.joint {
        RodJoint::Articulated { knuckle_radius, knuckle_angle, .. } => Some([knuckle_radius, knuckle_angle]),
        _ => None,
    })
}
