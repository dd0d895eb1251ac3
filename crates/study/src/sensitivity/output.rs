//! Outputs: peaks and orders of the loads on the block.

use super::train::DualLoads;
use lanchester_mechanism::{Extremes, LoadError, LoadRequest, LoadSet, OrderLoads, total_loads};
use lanchester_model::{Criterion, Engine, Load};
use num_dual::Dual64;
use serde::Serialize;

/// Loads below this share of all inertia forces are rounding.
const NOTHING: f64 = 1e-10;

/// A load on the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BlockLoad {
    /// Resultant force [N].
    Force,
    /// Resultant couple about the origin [N m].
    Couple,
    /// Roll moment of inertia [N m].
    RollMoment,
}

/// A size that depends on the inputs, 0 being best.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Output {
    /// Of which load.
    pub load: BlockLoad,
    /// Order [cycles per revolution of crankshaft 1] whose size it is; `None`: the peak over the continuous angle.
    pub order: Option<f64>,
}

impl Output {
    /// The peaks of all loads.
    pub fn peaks() -> Vec<Output> {
        [BlockLoad::Force, BlockLoad::Couple, BlockLoad::RollMoment]
            .map(|load| Output { load, order: None })
            .to_vec()
    }

    /// The output that a criterion of the engine file stands for; `None` for one of something else.
    pub fn of(criterion: Criterion) -> Option<Output> {
        let (load, order) = match criterion {
            Criterion::Peak(load) => (load, None),
            Criterion::Order(load, order) => (load, Some(order)),
            _ => return None,
        };
        let load = match load {
            Load::Force => BlockLoad::Force,
            Load::Couple => BlockLoad::Couple,
            Load::RollMoment => BlockLoad::RollMoment,
            _ => return None,
        };
        Some(Output { load, order })
    }

    /// Name for tables, in the words of criteria.
    pub fn name(self) -> String {
        let load = match self.load {
            BlockLoad::Force => "force",
            BlockLoad::Couple => "couple",
            BlockLoad::RollMoment => "roll moment",
        };
        match self.order {
            None => format!("peak {load}"),
            Some(order) => format!("{load} of order {order}"),
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        if self.load.is_force() { "N" } else { "N m" }
    }

    /// What is rounding, at `speed` [rad/s]: a small share of all inertia forces as if they pulled one way.
    pub(super) fn nothing(self, engine: &Engine, speed: f64) -> f64 {
        let radius = |throw: usize| engine.throws[throw].radius;
        let cylinders =
            engine.cylinders.iter().map(|c| (c.reciprocating_mass() + c.rod.big_end_mass) * radius(c.throw));
        let throws = engine.throws.iter().map(|throw| throw.unbalance.abs());
        let weights = engine.counterweights.iter().map(|weight| weight.unbalance);
        let shafts = engine.shafts.iter().flat_map(|shaft| {
            shaft.weights.iter().map(|weight| weight.unbalance * shaft.ratio.value().powi(2))
        });
        let force = cylinders.chain(throws).chain(weights).chain(shafts).sum::<f64>() * speed * speed;
        let planes = engine.cylinders.iter().map(|c| c.z.abs()).chain(engine.throws.iter().map(|t| t.radius));
        match self.load.is_force() {
            true => NOTHING * force,
            false => NOTHING * force * planes.fold(0.0f64, f64::max),
        }
    }

    fn value(self, loads: &LoadSet) -> f64 {
        let Some(order) = self.order else {
            let Extremes { max, min } = match self.load {
                BlockLoad::Force => loads.peaks.force,
                BlockLoad::Couple => loads.peaks.couple,
                BlockLoad::RollMoment => loads.peaks.roll_moment,
            };
            return max.value.abs().max(if self.load == BlockLoad::RollMoment {
                min.value.abs()
            } else {
                0.0
            });
        };
        let own = loads.orders.iter().find(|own| (own.order - order).abs() < 1e-9);
        own.map_or(0.0, |own: &OrderLoads| match self.load {
            BlockLoad::Force => own.force_peak(),
            BlockLoad::Couple => own.couple_peak(),
            BlockLoad::RollMoment => own.roll_moment.norm(),
        })
    }
}

/// Values of outputs of an engine at `speed` [rad/s].
///
/// # Errors
/// As [`total_loads`].
pub(super) fn values(engine: &Engine, speed: f64, outputs: &[Output]) -> Result<Vec<f64>, LoadError> {
    let highest = outputs.iter().filter_map(|output| output.order).fold(1.0, f64::max);
    let request = LoadRequest {
        speed: Some(speed),
        samples: 1,
        max_order: highest.ceil() as u32,
        ..LoadRequest::default()
    };
    let loads = total_loads(engine, &request)?;
    let value = |output: &Output| {
        let value = output.value(&loads);
        if value <= output.nothing(engine, speed) { 0.0 } else { value }
    };
    Ok(outputs.iter().map(value).collect())
}

/// A complex number with its derivative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Component {
    pub re: Dual64,
    pub im: Dual64,
}

impl BlockLoad {
    pub(super) fn is_force(self) -> bool {
        self == BlockLoad::Force
    }

    /// What its size is the root of the squares of.
    pub(super) fn parts(self, loads: &DualLoads) -> Vec<Dual64> {
        match self {
            BlockLoad::Force => loads.force.to_vec(),
            BlockLoad::Couple => loads.couple.to_vec(),
            BlockLoad::RollMoment => vec![loads.roll],
        }
    }

    /// What the size of one order is the sum of: the parts that turn with the crank and against it; of the roll moment its amplitude.
    pub(super) fn components(self, order: f64, all: &[(f64, DualLoads)]) -> Vec<Component> {
        let share = 1.0 / all.len() as f64;
        let coefficient = |order: f64, weight: f64| {
            let zero = Dual64::new(0.0, 0.0);
            all.iter().fold(Component { re: zero, im: zero }, |sum, (theta, loads)| {
                let (sin, cos) = (order * theta).sin_cos();
                let parts = self.parts(loads);
                let (x, y) = (parts[0], parts.get(1).copied().unwrap_or(zero));
                Component {
                    re: sum.re + (x * cos + y * sin) * (weight * share),
                    im: sum.im + (y * cos - x * sin) * (weight * share),
                }
            })
        };
        match self {
            BlockLoad::RollMoment => vec![coefficient(order, 2.0)],
            BlockLoad::Force | BlockLoad::Couple => vec![coefficient(order, 1.0), coefficient(-order, 1.0)],
        }
    }
}
