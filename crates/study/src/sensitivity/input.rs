//! Inputs: the numbers of an engine that its loads depend on.

use lanchester_model::{Engine, Varied};
use serde::Serialize;

/// A number of the engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Speed of crankshaft 1 [rad/s].
    Speed,
    /// Distance of the cylinders along the crank [m]: planes of throws, cylinders and counterweights stretch about the origin, balance
    /// shafts stay.
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
    /// Place of a balance shaft along x [m].
    ShaftX,
    /// Place of a balance shaft along y [m].
    ShaftY,
}

/// How a quantity is measured, and what a small change of it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
    /// A moment of inertia [kg m^2].
    Inertia,
    /// A speed [rad/s].
    Speed,
}

impl Quantity {
    /// All of them, in the order of tables.
    pub fn all() -> impl Iterator<Item = Quantity> {
        let own = [
            Quantity::RodInertia,
            Quantity::PinOffset,
            Quantity::ThrowPlane,
            Quantity::CounterweightPlane,
            Quantity::ShaftWeightPlane,
            Quantity::ShaftX,
            Quantity::ShaftY,
        ];
        [Quantity::Speed, Quantity::Spacing].into_iter().chain(Varied::ALL.map(Quantity::Part)).chain(own)
    }

    /// Name for tables, options and messages.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Speed => "speed",
            Quantity::Spacing => "cylinder spacing",
            Quantity::Part(varied) => varied.name(),
            Quantity::RodInertia => "rod inertia",
            Quantity::PinOffset => "pin offset in the piston",
            Quantity::ThrowPlane => "throw plane",
            Quantity::CounterweightPlane => "counterweight plane",
            Quantity::ShaftWeightPlane => "balance-shaft weight plane",
            Quantity::ShaftX => "balance-shaft x",
            Quantity::ShaftY => "balance-shaft y",
        }
    }

    /// How it is measured.
    pub fn measure(self) -> Measure {
        match self {
            Quantity::Speed => Measure::Speed,
            Quantity::Spacing => Measure::Length,
            Quantity::RodInertia => Measure::Inertia,
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
            | Quantity::ShaftX
            | Quantity::ShaftY => Measure::Place,
        }
    }

    /// Whether it is one number of the whole engine.
    pub fn is_of_engine(self) -> bool {
        matches!(self, Quantity::Speed | Quantity::Spacing)
    }

    /// How many parts of `engine` have it.
    pub fn parts(self, engine: &Engine) -> usize {
        match self {
            Quantity::Speed => 1,
            Quantity::Spacing => usize::from(engine.spacing().is_some()),
            Quantity::Part(varied) => varied.parts(engine),
            Quantity::RodInertia if engine.cylinders.iter().any(|c| c.rod.inertia.is_none()) => 0,
            Quantity::RodInertia | Quantity::PinOffset => engine.cylinders.len(),
            Quantity::ThrowPlane => engine.throws.len(),
            Quantity::CounterweightPlane => engine.counterweights.len(),
            Quantity::ShaftWeightPlane => engine.shafts.iter().map(|shaft| shaft.weights.len()).sum(),
            Quantity::ShaftX | Quantity::ShaftY => engine.shafts.len(),
        }
    }

    /// The fields of `engine` that hold it, part by part: to change one is to change the engine. None for what no single field holds: speed, spacing,
    /// [`Varied::RodCentre`], which moves mass between the ends of a rod, and [`Varied::ShaftPhase`], which turns all weights of a shaft.
    fn numbers(self, engine: &mut Engine) -> Vec<&mut f64> {
        match self {
            Quantity::Speed | Quantity::Spacing | Quantity::Part(Varied::RodCentre | Varied::ShaftPhase) => {
                Vec::new()
            }
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
            Quantity::ShaftX => engine.shafts.iter_mut().map(|s| &mut s.x).collect(),
            Quantity::ShaftY => engine.shafts.iter_mut().map(|s| &mut s.y).collect(),
        }
    }
}

/// A quantity of one part, or of all parts together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Input {
    /// Which quantity.
    pub quantity: Quantity,
    /// Index of the part; `None` for all parts together.
    pub part: Option<usize>,
}

impl Input {
    /// The quantities of `engine`, each for all parts together.
    pub fn common(engine: &Engine) -> Vec<Input> {
        Quantity::all()
            .filter(|quantity| quantity.parts(engine) > 0)
            .map(|quantity| Input { quantity, part: None })
            .collect()
    }

    /// The quantities of `engine`, part by part; those of the whole engine once.
    pub fn single(engine: &Engine) -> Vec<Input> {
        Quantity::all()
            .flat_map(|quantity| (0..quantity.parts(engine)).map(move |part| (quantity, part)))
            .map(|(quantity, part)| Input { quantity, part: (!quantity.is_of_engine()).then_some(part) })
            .collect()
    }

    /// Whether it is about part `index`.
    pub(super) fn is_of(self, index: usize) -> bool {
        self.part.is_none_or(|part| part == index)
    }

    /// Its value in `engine` at `speed` [rad/s], where all of its parts have the same; directions, places of mass and phases have none.
    pub fn nominal(self, engine: &Engine, speed: f64) -> Option<f64> {
        match self.quantity {
            Quantity::Speed => return Some(speed),
            Quantity::Spacing => return engine.spacing(),
            _ => {}
        }
        let mut copy = engine.clone();
        let values = self.quantity.numbers(&mut copy);
        let mut own =
            values.iter().enumerate().filter(|(index, _)| self.is_of(*index)).map(|(_, value)| **value);
        let first = own.next()?;
        own.all(|value| (value - first).abs() <= 1e-12 * first.abs()).then_some(first)
    }

    /// `engine` and its speed with this quantity off by `deviation`, in its SI unit.
    pub fn deviate(self, engine: &mut Engine, speed: &mut f64, deviation: f64) {
        match self.quantity {
            Quantity::Speed => *speed += deviation,
            Quantity::Spacing => {
                if let Some(spacing) = engine.spacing() {
                    *engine = engine.stretched(1.0 + deviation / spacing);
                }
            }
            Quantity::Part(Varied::RodCentre) => {
                let own = engine.cylinders.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
                for (_, cylinder) in own {
                    let moved = cylinder.rod.mass() * deviation / cylinder.rod.length;
                    cylinder.rod.small_end_mass += moved;
                    cylinder.rod.big_end_mass -= moved;
                }
            }
            Quantity::Part(Varied::ShaftPhase) => {
                let own = engine.shafts.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
                own.flat_map(|(_, shaft)| &mut shaft.weights).for_each(|weight| weight.phase += deviation);
            }
            quantity => {
                let own = quantity.numbers(engine).into_iter().enumerate();
                own.filter(|(index, _)| self.is_of(*index)).for_each(|(_, value)| *value += deviation);
            }
        }
    }
}
