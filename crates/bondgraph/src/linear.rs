//! Linear graphs: x' = A x + B u, y = C x + D u, poles, transfer functions.

use crate::equations::{Equations, What, equations};
use crate::expression::{Id, Var};
use crate::graph::{Graph, Kind, Law, Parameter};
use crate::linear::result::ROUNDINGS;
use crate::linear::transfer::transfers;
use crate::unit::Unit;
use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{DMatrix, Schur};
use serde::Serialize;
use std::collections::HashMap;
use std::f64::consts::TAU;

mod exact;
mod result;
mod transfer;

pub use result::{Linear, Pole, Transfer};

/// Why a graph has no linear form.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum NotLinear {
    /// The rate of a state or an output is no linear function.
    Nonlinear {
        /// Which.
        quantity: String,
    },
    /// An algebraic loop is not linear.
    Loop {
        /// The variable that cuts it.
        quantity: String,
    },
    /// A source drives a store that follows: the rate of the input would enter.
    DrivenStore {
        /// The store.
        store: String,
    },
    /// The graph has a mistake that only shows with its sources as inputs.
    Equations,
    /// What was asked for as an output is no quantity of the graph.
    NoOutput {
        /// What was asked for.
        name: String,
        /// What there is.
        has: Vec<String>,
    },
}

impl NotLinear {
    /// The reason in words, and what helps.
    pub fn in_words(&self) -> [String; 2] {
        match self {
            NotLinear::Nonlinear { quantity } => [
                format!("the graph is not linear: {quantity} has slopes that change"),
                "poles and transfer functions belong to linear graphs; simulate it instead".into(),
            ],
            NotLinear::Loop { quantity } => [
                format!("the algebraic loop through {quantity} is not linear"),
                "give its resistors a resistance instead of a law".into(),
            ],
            NotLinear::DrivenStore { store } => [
                format!(
                    "a source of flow drives {store} directly, so that the rate of the input would enter"
                ),
                "put a spring between, or drive it by an effort".into(),
            ],
            NotLinear::Equations => [
                "with its sources as free inputs the graph has no equations".into(),
                "look at its causality".into(),
            ],
            NotLinear::NoOutput { name, has } => {
                [format!("the graph has no quantity `{name}`"), format!("it has {}", has.join(", "))]
            }
        }
    }
}

impl Equations {
    /// The linear form, with the flow of every inertia, the effort of every capacitor and every signal as outputs.
    ///
    /// # Errors
    /// Why there is none.
    pub fn linear(&self) -> Result<Linear, NotLinear> {
        self.linear_to(&[])
    }

    /// The linear form with the outputs of these names, as `spring.effort`; with none as [`Equations::linear`] has them.
    ///
    /// # Errors
    /// Why there is none, also where a name is not known.
    pub fn linear_to(&self, wanted: &[String]) -> Result<Linear, NotLinear> {
        let (graph, inputs) = with_free_sources(&self.graph);
        let free = equations(&graph).map_err(|_| NotLinear::Equations)?;
        let count = self.graph.parameters.len();
        let is_input = |var: Var| matches!(var, Var::Parameter(index) if index as usize >= count);
        let mut pool = free.graph.pool.clone();
        for unknown in &free.unknowns {
            if let What::Following(held) = unknown.what
                && pool.depends(held, is_input)
            {
                return Err(NotLinear::DrivenStore { store: graph.bond_name(unknown.bond) });
            }
            if unknown.solved.is_none() && free.unknowns.len() <= 4 {
                return Err(NotLinear::Loop { quantity: unknown.name.clone() });
            }
        }
        let outputs = if wanted.is_empty() { free.usual_outputs() } else { free.chosen_outputs(wanted)? };
        let by_state: Vec<Var> = (0..free.states.len() as u32).map(Var::State).collect();
        let by_input: Vec<Var> = (0..inputs.len()).map(|k| Var::Parameter((count + k) as u32)).collect();
        let mut slopes = |id: Id, by: &[Var], quantity: &str| -> Result<Vec<f64>, NotLinear> {
            by.iter()
                .map(|var| {
                    let slope = pool.derivative(id, *var, &mut HashMap::new());
                    let fixed =
                        !pool.depends(slope, |var| !matches!(var, Var::Parameter(_)) || is_input(var));
                    let value = pool.evaluate(slope, &|var| match var {
                        Var::Parameter(index) => {
                            graph.parameters.get(index as usize).map_or(f64::NAN, |p| p.value)
                        }
                        _ => f64::NAN,
                    });
                    if fixed && value.is_finite() {
                        Ok(value)
                    } else {
                        Err(NotLinear::Nonlinear { quantity: quantity.to_owned() })
                    }
                })
                .collect()
        };
        let (mut a, mut b, mut c, mut d) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for state in &free.states {
            a.push(slopes(state.rate, &by_state, &state.symbol)?);
            b.push(slopes(state.rate, &by_input, &state.symbol)?);
        }
        for (name, id) in &outputs {
            c.push(slopes(*id, &by_state, name)?);
            d.push(slopes(*id, &by_input, name)?);
        }
        let names: Vec<String> = outputs.into_iter().map(|(name, _)| name).collect();
        let mut linear = Linear {
            version: 1,
            states: free.states.iter().map(|state| state.symbol.clone()).collect(),
            inputs,
            outputs: names,
            poles: poles(&a),
            a,
            b,
            c,
            d,
            transfer: Vec::new(),
        };
        linear.transfer = transfers(&linear);
        Ok(linear)
    }

    /// Flow of every inertia, effort of every capacitor, every signal.
    fn usual_outputs(&self) -> Vec<(String, Id)> {
        let mut outputs = Vec::new();
        for element in &self.graph.elements {
            let Law::Store(ports) = &element.law else { continue };
            for (port, law) in ports.iter().enumerate() {
                let bond = element.ports[port];
                let name = self.graph.bond_name(bond);
                outputs.push(match law.flow {
                    Some(_) => (format!("{name}.flow"), self.flows[bond]),
                    None => (format!("{name}.effort"), self.efforts[bond]),
                });
            }
        }
        let signals = self.graph.signals.iter().zip(&self.signals);
        outputs.extend(signals.map(|(signal, id)| (signal.name.clone(), *id)));
        outputs
    }

    /// Efforts and flows of bonds, what a junction shares, and signals, by their names.
    fn chosen_outputs(&self, wanted: &[String]) -> Result<Vec<(String, Id)>, NotLinear> {
        let graph = &self.graph;
        let mut known: Vec<(String, Id)> = Vec::new();
        for bond in 0..graph.bonds.len() {
            let name = graph.bond_name(bond);
            known.push((format!("{name}.effort"), self.efforts[bond]));
            known.push((format!("{name}.flow"), self.flows[bond]));
        }
        for element in graph.elements.iter().filter(|element| element.is_junction()) {
            let bond = element.ports[0];
            known.push(match element.kind {
                Kind::One => (format!("{}.flow", element.name), self.flows[bond]),
                _ => (format!("{}.effort", element.name), self.efforts[bond]),
            });
        }
        let signals = graph.signals.iter().zip(&self.signals);
        known.extend(signals.map(|(signal, id)| (signal.name.clone(), *id)));
        let of = |name: &String| {
            let found = known.iter().find(|(own, _)| own == name.trim()).cloned();
            found.ok_or_else(|| NotLinear::NoOutput {
                name: name.clone(),
                has: known.iter().map(|(own, _)| own.clone()).collect(),
            })
        };
        wanted.iter().map(of).collect()
    }
}

/// The graph with the value of each source as a parameter of its own.
fn with_free_sources(graph: &Graph) -> (Graph, Vec<String>) {
    let mut free = graph.clone();
    let mut inputs = Vec::new();
    for element in &mut free.elements {
        if let Law::Source(value) = &mut element.law {
            *value = free.pool.var(Var::Parameter(free.parameters.len() as u32));
            let what = if element.kind == Kind::Se { "effort" } else { "flow" };
            let name = format!("{}.{what}", element.name);
            free.parameters.push(Parameter {
                name: name.clone(),
                unit: Unit::NONE,
                written_unit: None,
                value: 0.0,
            });
            inputs.push(name);
        }
    }
    (free, inputs)
}

/// Eigenvalues of A, the slowest first, pairs with the positive imaginary part first.
///
/// Schur's form is exact for a matrix beside A whose distance is the rounding of n sums of products, and A itself is rounded: a part of a pole
/// below that distance is 0. The norm is that of the balanced matrix, which the choice of units does not change.
fn poles(a: &[Vec<f64>]) -> Vec<Pole> {
    let n = a.len();
    if n == 0 {
        return Vec::new();
    }
    let mut matrix = DMatrix::from_fn(n, n, |i, j| a[i][j]);
    balance_parlett_reinsch(&mut matrix);
    let rounding = (n as f64 + ROUNDINGS) * f64::EPSILON * matrix.norm();
    let Some(schur) = Schur::try_new(matrix, f64::EPSILON, 10_000) else { return Vec::new() };
    let clean = |part: f64| if part.abs() <= rounding { 0.0 } else { part };
    let mut poles: Vec<Pole> = schur
        .complex_eigenvalues()
        .iter()
        .map(|value| {
            let (real, imaginary) = (clean(value.re), clean(value.im));
            let frequency = real.hypot(imaginary);
            let damping = if real == 0.0 { 0.0 } else { -real / frequency };
            Pole { real, imaginary, frequency, damping, hertz: frequency / TAU }
        })
        .collect();
    poles.sort_by(|p, q| {
        let near = (p.frequency - q.frequency).abs() <= 1e-9 * p.frequency.max(q.frequency);
        let by_frequency = if near { std::cmp::Ordering::Equal } else { p.frequency.total_cmp(&q.frequency) };
        by_frequency.then(q.imaginary.total_cmp(&p.imaginary))
    });
    poles
}
