//! Tolerances: what varies from engine to engine, by how much, how it is distributed, and for which parts together.

use lanchester_model::Engine;
use lanchester_units::Dimension;
use serde::Serialize;

/// A quantity of the engine that varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Varied {
    /// Mass of a piston with pin, rings and clips [kg].
    PistonMass,
    /// Mass of a rod's big end [kg].
    BigEndMass,
    /// Mass of a rod's small end [kg].
    SmallEndMass,
    /// Place of a rod's centre of gravity from the big-end eye [m]: moves mass from the big end to the small end.
    RodCentre,
    /// Length of a rod [m].
    RodLength,
    /// Crank radius of a throw [m].
    CrankRadius,
    /// Direction of a throw on the crank [rad].
    ThrowAngle,
    /// Unbalance of a throw itself [kg m].
    ThrowUnbalance,
    /// Offset of a cylinder's axis from the crank axis [m].
    Offset,
    /// Plane of a cylinder along the crank [m].
    CylinderPlane,
    /// Direction of a cylinder's axis [rad].
    CylinderAngle,
    /// Unbalance of a crank counterweight [kg m].
    CounterweightUnbalance,
    /// Direction of a crank counterweight [rad].
    CounterweightAngle,
    /// Unbalance of each weight on a balance shaft [kg m].
    ShaftUnbalance,
    /// Phase of a balance shaft against the crank [rad]: play and indexing of its gears.
    ShaftPhase,
}

impl Varied {
    /// All of them, in the order of the engine file's reference.
    pub const ALL: [Varied; 15] = [
        Varied::PistonMass,
        Varied::BigEndMass,
        Varied::SmallEndMass,
        Varied::RodCentre,
        Varied::RodLength,
        Varied::CrankRadius,
        Varied::ThrowAngle,
        Varied::ThrowUnbalance,
        Varied::Offset,
        Varied::CylinderPlane,
        Varied::CylinderAngle,
        Varied::CounterweightUnbalance,
        Varied::CounterweightAngle,
        Varied::ShaftUnbalance,
        Varied::ShaftPhase,
    ];

    /// Name for tables and messages.
    pub fn name(self) -> &'static str {
        match self {
            Varied::PistonMass => "piston mass",
            Varied::BigEndMass => "big-end mass",
            Varied::SmallEndMass => "small-end mass",
            Varied::RodCentre => "rod centre of gravity",
            Varied::RodLength => "rod length",
            Varied::CrankRadius => "crank radius",
            Varied::ThrowAngle => "throw angle",
            Varied::ThrowUnbalance => "throw unbalance",
            Varied::Offset => "cylinder offset",
            Varied::CylinderPlane => "cylinder plane",
            Varied::CylinderAngle => "cylinder angle",
            Varied::CounterweightUnbalance => "counterweight unbalance",
            Varied::CounterweightAngle => "counterweight angle",
            Varied::ShaftUnbalance => "balance-shaft unbalance",
            Varied::ShaftPhase => "balance-shaft phase",
        }
    }

    /// Key of the engine file's `[tolerances]`.
    pub fn key(self) -> &'static str {
        match self {
            Varied::PistonMass => "piston_mass",
            Varied::BigEndMass => "big_end_mass",
            Varied::SmallEndMass => "small_end_mass",
            Varied::RodCentre => "rod_centre",
            Varied::RodLength => "rod_length",
            Varied::CrankRadius => "crank_radius",
            Varied::ThrowAngle => "throw_angle",
            Varied::ThrowUnbalance => "throw_unbalance",
            Varied::Offset => "offset",
            Varied::CylinderPlane => "cylinder_plane",
            Varied::CylinderAngle => "cylinder_angle",
            Varied::CounterweightUnbalance => "counterweight_unbalance",
            Varied::CounterweightAngle => "counterweight_angle",
            Varied::ShaftUnbalance => "shaft_unbalance",
            Varied::ShaftPhase => "shaft_phase",
        }
    }

    /// What it is measured in.
    pub fn dimension(self) -> Dimension {
        match self {
            Varied::PistonMass | Varied::BigEndMass | Varied::SmallEndMass => Dimension::Mass,
            Varied::RodCentre
            | Varied::RodLength
            | Varied::CrankRadius
            | Varied::Offset
            | Varied::CylinderPlane => Dimension::Length,
            Varied::ThrowUnbalance | Varied::CounterweightUnbalance | Varied::ShaftUnbalance => {
                Dimension::Unbalance
            }
            Varied::ThrowAngle | Varied::CylinderAngle | Varied::CounterweightAngle | Varied::ShaftPhase => {
                Dimension::Angle
            }
        }
    }

    /// How many parts of `engine` have it.
    pub fn parts(self, engine: &Engine) -> usize {
        match self {
            Varied::PistonMass
            | Varied::BigEndMass
            | Varied::SmallEndMass
            | Varied::RodCentre
            | Varied::RodLength
            | Varied::Offset
            | Varied::CylinderPlane
            | Varied::CylinderAngle => engine.cylinders.len(),
            Varied::CrankRadius | Varied::ThrowAngle | Varied::ThrowUnbalance => engine.throws.len(),
            Varied::CounterweightUnbalance | Varied::CounterweightAngle => engine.counterweights.len(),
            Varied::ShaftUnbalance => engine.shafts.iter().map(|shaft| shaft.weights.len()).sum(),
            Varied::ShaftPhase => engine.shafts.len(),
        }
    }
}

/// How a quantity is distributed within its tolerance; its mean is the nominal value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Distribution {
    /// Normal, cut off at the tolerance, which is so many standard deviations (of the uncut distribution).
    Normal {
        /// Half width of the tolerance over the standard deviation; 3 where nothing else is known.
        sigmas: f64,
    },
    /// Anywhere with the same probability.
    Uniform,
}

/// For which parts a deviation is one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Extent {
    /// Every part has its own.
    PerPart,
    /// One for all parts of an engine: a batch, a setting of the machine.
    Common,
}

/// A tolerance: one entry of the engine file's `[tolerances]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Tolerance {
    /// What varies.
    pub quantity: Varied,
    /// The nominal value may be missed by this either way, in the quantity's SI unit.
    pub half_width: f64,
    /// How it is distributed.
    pub distribution: Distribution,
    /// For which parts together.
    pub extent: Extent,
}
