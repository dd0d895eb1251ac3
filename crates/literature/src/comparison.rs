//! A published method fitted to an engine, with the true optimum of the same devices beside it.

use crate::half_rules::{
    BalanceFactor, BalancerPhase, FourCylinderBalance, FourCylinderRule, ThreeCylinderBalance,
    ThreeCylinderRule,
};
use crate::matrix_method::{MatrixBalance, MatrixMethod};
use crate::printed_v::{AngleRule, PrintedV};
use crate::resultant::EngineResidual;
use lanchester_balance::Answer;
use lanchester_balance::BalanceError;
use lanchester_balance::fitted;
use lanchester_balance::optimise;
use lanchester_mechanism::{LoadRequest, loads};
use lanchester_model::Engine;
use lanchester_results::OrderLoads;
use lanchester_task::{BalanceTask, Criterion, FreeShaft, FreeWeight, Load, Place, Seat, Stage, Tie};
use num_complex::Complex64;
use serde::Serialize;

/// Version of [`MethodAnswer`]; raised when a field changes its meaning or goes.
pub const METHOD_ANSWER_VERSION: u32 = 1;

/// Orders that a [`MethodAnswer`] lists.
const ORDERS: u32 = 4;

/// A published method with the choices of its user.
#[derive(Debug, Clone, PartialEq)]
pub enum PublishedMethod {
    /// The matrix method, its equations corrected.
    Matrix(MatrixMethod),
    /// The matrix method with the shafts as its source sizes them for a V engine.
    MatrixAsPrinted(MatrixMethod, AngleRule),
    /// 50 % rule of an in-line three with its balancer shaft.
    ThreeCylinder(ThreeCylinderRule),
    /// Two second-order shafts of an in-line four.
    FourCylinder(FourCylinderRule),
    /// The rotating masses and a share of the reciprocating ones on the counterweights, of any engine.
    Factor(BalanceFactor),
}

/// What a method found in its own terms.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "method")]
pub enum MethodFound {
    /// Of [`PublishedMethod::Matrix`] and [`PublishedMethod::MatrixAsPrinted`].
    Matrix {
        /// Found with the corrected equations.
        balance: Box<MatrixBalance>,
        /// The shafts as the source sizes them for a V engine; none for an engine in line or without both pairs.
        printed: Option<Box<PrintedV>>,
        /// Whether the engine has those in place of the corrected ones.
        printed_used: bool,
    },
    /// Of [`PublishedMethod::ThreeCylinder`].
    ThreeCylinder {
        /// Found with the chosen phase of the balancer.
        balance: Box<ThreeCylinderBalance>,
        /// The phase chosen.
        phase: BalancerPhase,
        /// The other phase.
        other: Box<ThreeCylinderBalance>,
    },
    /// Of [`PublishedMethod::FourCylinder`].
    FourCylinder {
        /// What it found.
        balance: Box<FourCylinderBalance>,
    },
    /// Of [`PublishedMethod::Factor`].
    Factor {
        /// Share of the reciprocating masses that the counterweights take.
        share: f64,
        /// What the engine leaves over.
        residual: EngineResidual,
    },
}

/// A weight of the method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodWeight {
    /// Its name.
    pub name: String,
    /// The shaft that it sits on; none: the crankshaft.
    pub shaft: Option<String>,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: String,
    /// Plane [m].
    pub z: f64,
    /// Unbalance [kg m]: modulus = amount, argument = direction at `theta = 0` in the engine's frame.
    pub unbalance: Complex64,
    /// Mass [kg], where the method has a radius for it.
    pub mass: Option<f64>,
    /// Unbalance of the optimum in its place [kg m].
    pub optimum: Complex64,
}

/// One order of the loads on the block, force [N] and couple [N m] in both senses, at the highest speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OrderLeft {
    /// Order.
    pub order: f64,
    /// Amounts of force with and against the crank, couple with and against it, without the devices.
    pub without: [f64; 4],
    /// The same with the method's devices.
    pub method: [f64; 4],
    /// The same with the optimum.
    pub optimum: [f64; 4],
}

/// A published method fitted to an engine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodAnswer {
    /// [`METHOD_ANSWER_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// What the method found in its own terms.
    pub found: MethodFound,
    /// Its weights, with those of the optimum.
    pub weights: Vec<MethodWeight>,
    /// What is left by order.
    pub orders: Vec<OrderLeft>,
    /// The optimum of the same devices, every amount and direction free; in its effects `before` is the method.
    pub optimum: Answer,
    /// The engine with the method's devices.
    #[serde(skip)]
    pub fitted: Engine,
    /// The engine with the optimum's.
    #[serde(skip)]
    pub best: Engine,
}

impl PublishedMethod {
    /// Fits the method to `engine` and seeks the optimum of `stages` with the same devices; without stages force, then
    /// couple. Among equally good ones the optimum is the lightest.
    ///
    /// # Errors
    /// As the methods themselves.
    pub fn fit(&self, engine: &Engine, stages: &[Stage]) -> Result<MethodAnswer, BalanceError> {
        let (found, after) = self.found(engine)?;
        let own = Own::of(self, &after);
        let mut task = own.task;
        task.stages = if stages.is_empty() {
            [Load::Force, Load::Couple].map(|l| stage(Criterion::Peak(l))).to_vec()
        } else {
            stages.to_vec()
        };
        // Lightness is what is compared: bearings do not decide before it.
        let weighs =
            |term: &(f64, Criterion)| matches!(term.1, Criterion::AddedMass | Criterion::AddedUnbalance);
        if !task.stages.iter().flat_map(|stage| &stage.terms).any(weighs) {
            task.stages.push(stage(Criterion::AddedUnbalance));
        }
        let optimum = optimise(&after, &task)?;
        let best = fitted(&after, &optimum);
        let mut weights = own.weights;
        for (weight, found) in weights.iter_mut().zip(&optimum.weights) {
            weight.optimum = if found.used { found.unbalance } else { Complex64::ZERO };
        }
        let without = lanchester_balance::bare(&after, &task);
        Ok(MethodAnswer {
            version: METHOD_ANSWER_VERSION,
            engine: engine.name.clone(),
            found,
            weights,
            orders: orders_left(&without, &after, &best)?,
            optimum,
            fitted: after,
            best,
        })
    }

    fn found(&self, engine: &Engine) -> Result<(MethodFound, Engine), BalanceError> {
        Ok(match self {
            PublishedMethod::Matrix(method) => {
                let balance = method.fit(engine)?;
                let printed = match in_line(engine) || method.first.is_none() || method.second.is_none() {
                    true => None,
                    false => Some(Box::new(method.printed_v(engine, AngleRule::Continuous)?)),
                };
                let after = balance.engine.clone();
                (MethodFound::Matrix { balance: Box::new(balance), printed, printed_used: false }, after)
            }
            PublishedMethod::MatrixAsPrinted(method, rule) => {
                if in_line(engine) {
                    return Err(BalanceError::Unsuited {
                        method: "the printed variant of the matrix method",
                        needed: "a V engine",
                        got: "cylinders in line".to_owned(),
                        hint: "take the corrected equations: in line they give the printed masses",
                    });
                }
                let printed = method.printed_v(engine, *rule)?;
                let after = printed.engine.clone();
                let balance = Box::new(method.fit(engine)?);
                let printed = Some(Box::new(printed));
                (MethodFound::Matrix { balance, printed, printed_used: true }, after)
            }
            PublishedMethod::ThreeCylinder(rule) => {
                let balance = rule.fit(engine)?;
                let phase = match rule.phase {
                    BalancerPhase::CouplePeak => BalancerPhase::OppositeFirstThrow,
                    BalancerPhase::OppositeFirstThrow => BalancerPhase::CouplePeak,
                };
                let other = ThreeCylinderRule { phase, ..*rule }.fit(engine)?;
                let after = balance.engine.clone();
                let (balance, other) = (Box::new(balance), Box::new(other));
                (MethodFound::ThreeCylinder { balance, phase: rule.phase, other }, after)
            }
            PublishedMethod::FourCylinder(rule) => {
                let balance = rule.fit(engine)?;
                let after = balance.engine.clone();
                (MethodFound::FourCylinder { balance: Box::new(balance) }, after)
            }
            PublishedMethod::Factor(factor) => {
                let after = factor.fit(engine);
                let residual = EngineResidual::of(&after)?;
                (MethodFound::Factor { share: factor.0, residual }, after)
            }
        })
    }

    /// Radius of its weights [m] on the crank and on a shaft of an order, where it has them.
    fn radius(&self, order: Option<i32>) -> Option<f64> {
        let (PublishedMethod::Matrix(method) | PublishedMethod::MatrixAsPrinted(method, _)) = self else {
            return None;
        };
        match order {
            None => Some(method.counterweight_radius),
            Some(1) => method.first.map(|pair| pair.radius),
            Some(_) => method.second.map(|pair| pair.radius),
        }
    }
}

/// Whether all cylinders stand in one direction.
fn in_line(engine: &Engine) -> bool {
    let axis = |k: usize| Complex64::cis(engine.cylinders[k].angle);
    (1..engine.cylinders.len()).all(|k| (axis(k) - axis(0)).norm() < 1e-9)
}

fn stage(criterion: Criterion) -> Stage {
    Stage { terms: vec![(1.0, criterion)] }
}

/// The devices that a method brought.
struct Own {
    weights: Vec<MethodWeight>,
    task: BalanceTask,
}

impl Own {
    fn of(method: &PublishedMethod, engine: &Engine) -> Own {
        let mut own = Own { weights: Vec::new(), task: BalanceTask::default() };
        if !matches!(method, PublishedMethod::FourCylinder(_)) {
            for weight in &engine.counterweights {
                let shaft = &engine.crankshafts[weight.crankshaft];
                let unbalance = Complex64::from_polar(weight.unbalance, shaft.phase + weight.angle);
                let mass = method.radius(None).map(|radius| weight.unbalance / radius);
                own.add(&weight.name, None, shaft.ratio.to_string(), (weight.z, unbalance, mass));
                own.free(FreeWeight::new(
                    &weight.name,
                    Seat::Crankshaft(weight.crankshaft),
                    Place::At(weight.z),
                ));
            }
        }
        if matches!(method, PublishedMethod::Factor(_)) {
            return own;
        }
        for (index, shaft) in engine.shafts.iter().enumerate() {
            own.task.shafts.push(FreeShaft {
                name: shaft.name.clone(),
                ratio: shaft.ratio,
                x: Place::At(shaft.x),
                y: Place::At(shaft.y),
                optional: false,
            });
            let radius = method.radius(Some(shaft.ratio.numerator().abs()));
            for (k, weight) in shaft.weights.iter().enumerate() {
                let name = match shaft.weights.len() {
                    1 => shaft.name.clone(),
                    _ => format!("{}, weight {}", shaft.name, k + 1),
                };
                let unbalance = Complex64::from_polar(weight.unbalance, weight.phase);
                let mass = radius.map(|radius| weight.unbalance / radius);
                let on = Some(shaft.name.clone());
                own.add(&name, on, shaft.ratio.to_string(), (weight.z, unbalance, mass));
                own.free(FreeWeight::new(&name, Seat::Shaft(index), Place::At(weight.z)));
            }
        }
        own
    }

    /// One more free weight; of two in one plane of one shaft the second follows the first, for nothing tells them apart.
    fn free(&mut self, weight: FreeWeight) {
        let second = self.task.weights.len();
        let alike = |w: &FreeWeight| w.seat == weight.seat && w.z == weight.z;
        if let Some(first) = self.task.weights.iter().position(alike) {
            self.task.ties.push(Tie { first, second, factor: 1.0, mirrored: false });
        }
        self.task.weights.push(weight);
    }

    fn add(
        &mut self,
        name: &str,
        shaft: Option<String>,
        ratio: String,
        (z, unbalance, mass): (f64, Complex64, Option<f64>),
    ) {
        let name = name.to_owned();
        self.weights.push(MethodWeight { name, shaft, ratio, z, unbalance, mass, optimum: Complex64::ZERO });
    }
}

fn orders_left(without: &Engine, method: &Engine, best: &Engine) -> Result<Vec<OrderLeft>, BalanceError> {
    let request = LoadRequest { samples: 8, max_order: ORDERS, ..LoadRequest::default() };
    let [without, method, best] = [without, method, best].map(|engine| loads(engine, &request));
    let (without, method, best) = (without?, method?, best?);
    let amounts = |o: &OrderLoads| {
        [o.force_forward, o.force_backward, o.couple_forward, o.couple_backward].map(Complex64::norm)
    };
    let listed = method.total.orders.iter().filter(|o| o.order > 0.0 && o.order <= f64::from(ORDERS));
    Ok(listed
        .map(|own| {
            let same = |orders: &[OrderLoads]| {
                orders.iter().find(|o| o.order == own.order).map_or([0.0; 4], amounts)
            };
            OrderLeft {
                order: own.order,
                without: same(&without.total.orders),
                method: amounts(own),
                optimum: same(&best.total.orders),
            }
        })
        .collect())
}
