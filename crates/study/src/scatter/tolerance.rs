//! Tolerances: what varies, by how much, how it is distributed, and for which parts together.

use crate::scatter::error::ScatterError;
use lanchester_model::Engine;
use serde::Serialize;

/// A quantity of the engine that varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
    /// Offset of a piston pin's line from the crank axis [m].
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
            Varied::Offset => "piston-pin offset",
            Varied::CylinderPlane => "cylinder plane",
            Varied::CylinderAngle => "cylinder angle",
            Varied::CounterweightUnbalance => "counterweight unbalance",
            Varied::CounterweightAngle => "counterweight angle",
            Varied::ShaftUnbalance => "balance-shaft unbalance",
            Varied::ShaftPhase => "balance-shaft phase",
        }
    }

    /// Parts of the engine that have it.
    pub(crate) fn parts(self, engine: &Engine) -> usize {
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Extent {
    /// Every part has its own.
    PerPart,
    /// One for all parts of an engine: a batch, a setting of the machine.
    Common,
}

/// A tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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

/// One deviation that is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Variable {
    /// Place of its tolerance in the list.
    pub tolerance: usize,
    /// The part; `None`: all of them.
    pub part: Option<usize>,
    pub half_width: f64,
    pub distribution: Distribution,
}

/// The deviations of all tolerances, in the order of the list, part by part.
pub(crate) fn variables(engine: &Engine, tolerances: &[Tolerance]) -> Result<Vec<Variable>, ScatterError> {
    if tolerances.is_empty() {
        return Err(ScatterError::NoTolerance);
    }
    let mut variables = Vec::new();
    for (place, tolerance) in tolerances.iter().enumerate() {
        let (half_width, distribution) = (tolerance.half_width, tolerance.distribution);
        if !(half_width >= 0.0 && half_width.is_finite()) {
            let (needed, got) = ("finite and not negative", half_width);
            return Err(ScatterError::Number { quantity: "half width of a tolerance", needed, got });
        }
        if let Distribution::Normal { sigmas } = distribution
            && !(0.1..=8.0).contains(&sigmas)
        {
            let quantity = "standard deviations in a half width";
            return Err(ScatterError::Number { quantity, needed: "from 0.1 to 8", got: sigmas });
        }
        let parts = tolerance.quantity.parts(engine);
        if parts == 0 {
            return Err(ScatterError::NoSuchPart { place: place + 1, quantity: tolerance.quantity.name() });
        }
        let variable = |part| Variable { tolerance: place, part, half_width, distribution };
        match tolerance.extent {
            Extent::Common => variables.push(variable(None)),
            Extent::PerPart => variables.extend((0..parts).map(|part| variable(Some(part)))),
        }
    }
    Ok(variables)
}
