//! Linear graphs: x' = A x + B u, y = C x + D u, poles, transfer functions.

use crate::equations::{Equations, What, equations};
use crate::expression::{Id, Var};
use crate::graph::{Graph, Kind, Law, Parameter};
use crate::unit::Unit;
use nalgebra::{DMatrix, Schur};
use serde::Serialize;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// More states than these have no transfer functions: their coefficients would be rounding.
const MOST_FOR_TRANSFER: usize = 12;

/// A linear graph.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Linear {
    /// Version of this structure.
    pub version: u32,
    /// States.
    pub states: Vec<String>,
    /// Inputs: the sources.
    pub inputs: Vec<String>,
    /// Outputs: flow of every inertia, effort of every capacitor, and every signal.
    pub outputs: Vec<String>,
    /// A, row by row.
    pub a: Vec<Vec<f64>>,
    /// B.
    pub b: Vec<Vec<f64>>,
    /// C.
    pub c: Vec<Vec<f64>>,
    /// D.
    pub d: Vec<Vec<f64>>,
    /// Poles, the slowest first.
    pub poles: Vec<Pole>,
    /// From each input to each output.
    pub transfer: Vec<Transfer>,
}

/// A pole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pole {
    /// Real part [1/s].
    pub real: f64,
    /// Imaginary part [rad/s].
    pub imaginary: f64,
    /// Absolute value [rad/s].
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
    /// Its natural frequency [Hz].
    pub hertz: f64,
}

/// A transfer function; coefficients of rising powers of s.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Transfer {
    /// Input.
    pub input: String,
    /// Output.
    pub output: String,
    /// Numerator.
    pub numerator: Vec<f64>,
    /// Denominator, the highest coefficient 1.
    pub denominator: Vec<f64>,
}

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
        }
    }
}

impl Equations {
    /// The linear form.
    ///
    /// # Errors
    /// Why there is none.
    pub fn linear(&self) -> Result<Linear, NotLinear> {
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
        let mut outputs: Vec<(String, Id)> = Vec::new();
        for element in &graph.elements {
            let Law::Store(ports) = &element.law else { continue };
            for (port, law) in ports.iter().enumerate() {
                let bond = element.ports[port];
                let name = graph.bond_name(bond);
                outputs.push(match law.flow {
                    Some(_) => (format!("{name}.flow"), free.flows[bond]),
                    None => (format!("{name}.effort"), free.efforts[bond]),
                });
            }
        }
        for (signal, id) in graph.signals.iter().zip(&free.signals) {
            outputs.push((signal.name.clone(), *id));
        }
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
        linear.transfer = linear.transfers();
        Ok(linear)
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
            free.parameters.push(Parameter { name: name.clone(), unit: Unit::NONE, value: 0.0 });
            inputs.push(name);
        }
    }
    (free, inputs)
}

/// Eigenvalues of A, the slowest first, pairs with the positive imaginary part first.
fn poles(a: &[Vec<f64>]) -> Vec<Pole> {
    let n = a.len();
    if n == 0 {
        return Vec::new();
    }
    let matrix = DMatrix::from_fn(n, n, |i, j| a[i][j]);
    let Some(schur) = Schur::try_new(matrix, f64::EPSILON, 10_000) else { return Vec::new() };
    let mut poles: Vec<Pole> = schur
        .complex_eigenvalues()
        .iter()
        .map(|value| {
            let frequency = value.norm();
            let damping = if frequency > 0.0 { -value.re / frequency } else { 0.0 };
            Pole { real: value.re, imaginary: value.im, frequency, damping, hertz: frequency / TAU }
        })
        .collect();
    poles.sort_by(|p, q| {
        let near = (p.frequency - q.frequency).abs() <= 1e-9 * p.frequency.max(q.frequency);
        let by_frequency = if near { std::cmp::Ordering::Equal } else { p.frequency.total_cmp(&q.frequency) };
        by_frequency.then(q.imaginary.total_cmp(&p.imaginary))
    });
    poles
}

impl Linear {
    /// Numerators and the common denominator by Faddeev and Leverrier's recursion, with time scaled to the fastest pole.
    fn transfers(&self) -> Vec<Transfer> {
        let n = self.a.len();
        if n == 0 || n > MOST_FOR_TRANSFER {
            return Vec::new();
        }
        let fastest = self.poles.iter().map(|pole| pole.frequency).fold(0.0, f64::max);
        let scale = if fastest > 0.0 { fastest } else { 1.0 };
        let a = DMatrix::from_fn(n, n, |i, j| self.a[i][j] / scale);
        let unit = DMatrix::<f64>::identity(n, n);
        let mut denominator = vec![0.0; n + 1];
        denominator[n] = 1.0;
        let mut terms = vec![DMatrix::zeros(n, n); n];
        let mut m = DMatrix::zeros(n, n);
        for k in 1..=n {
            m = &a * m + denominator[n - k + 1] * &unit;
            denominator[n - k] = -(&a * &m).trace() / k as f64;
            terms[n - k] = m.clone();
        }
        let mut found = Vec::new();
        for (k, input) in self.inputs.iter().enumerate() {
            for (row, output) in self.outputs.iter().enumerate() {
                let mut numerator: Vec<f64> =
                    denominator.iter().map(|value| value * self.d[row][k]).collect();
                for (power, term) in terms.iter().enumerate() {
                    let mut sum = 0.0;
                    for i in 0..n {
                        for j in 0..n {
                            sum += self.c[row][i] * term[(i, j)] * self.b[j][k];
                        }
                    }
                    numerator[power] += sum / scale;
                }
                // Back to seconds: s = scale times the scaled s; both are divided by scale^n.
                let back = |values: &[f64]| -> Vec<f64> {
                    values
                        .iter()
                        .enumerate()
                        .map(|(power, value)| value * scale.powi(n as i32 - power as i32))
                        .collect()
                };
                let mut numerator = back(&numerator);
                while numerator.len() > 1 && numerator.last() == Some(&0.0) {
                    numerator.pop();
                }
                found.push(Transfer {
                    input: input.clone(),
                    output: output.clone(),
                    numerator,
                    denominator: back(&denominator),
                });
            }
        }
        found
    }
}
