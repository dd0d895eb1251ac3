//! Energy audit: through every bond, at every junction and two-port, in every store, of the whole.

use crate::equations::Equations;
use crate::expression::{Id, Pool, Var};
use crate::graph::{Kind, Law, StorePort};
use serde::Serialize;
use std::collections::HashMap;

/// Where the energy went.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Audit {
    /// Energy through each bond, along its half arrow [J].
    pub bonds: Vec<BondEnergy>,
    /// Energy that each one-port took in [J]; of sources negative what they gave.
    pub elements: Vec<ElementEnergy>,
    /// Largest difference of powers at each junction and two-port over all samples, against the largest power there.
    pub residuals: Vec<Residual>,
    /// Largest energy that a bond carried [J]: what the errors are measured by.
    pub throughput: f64,
    /// Sum of what all one-ports took in, against the throughput: the error of the whole.
    pub whole: f64,
}

/// Energy through one bond.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BondEnergy {
    /// The bond.
    pub bond: String,
    /// Its energy [J].
    pub energy: f64,
}

/// Energy of one element.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ElementEnergy {
    /// The element.
    pub element: String,
    /// Its kind.
    pub kind: Kind,
    /// What it took in [J].
    pub taken: f64,
    /// Change of what it holds by its law [J], where that is linear; also of a store that follows others.
    pub held: Option<f64>,
    /// Their difference against the throughput.
    pub error: Option<f64>,
}

/// Error of one junction or two-port.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Residual {
    /// The element.
    pub element: String,
    /// Largest sum of powers against the largest power.
    pub error: f64,
}

pub(crate) fn audit(
    equations: &Equations,
    samples: &[(f64, Vec<f64>)],
    variables: &[Vec<f64>],
    end: &[f64],
) -> Audit {
    let graph = &equations.graph;
    let count = graph.bonds.len();
    let energies = &end[equations.states.len()..];
    let throughput = energies.iter().fold(0.0f64, |most, energy| most.max(energy.abs()));
    let measure = if throughput > 0.0 { throughput } else { 1.0 };
    let bonds =
        (0..count).map(|bond| BondEnergy { bond: graph.bond_name(bond), energy: energies[bond] }).collect();
    let (mut elements, mut residuals) = (Vec::new(), Vec::new());
    let mut whole = 0.0;
    let mut pool = graph.pool.clone();
    for (index, element) in graph.elements.iter().enumerate() {
        let many = matches!(element.kind, Kind::Zero | Kind::One | Kind::TF | Kind::GY);
        if many {
            let mut error = 0.0f64;
            for values in variables {
                let powers = element.ports.iter().map(|bond| {
                    let power = graph.bonds[*bond].domain.power(values[*bond], values[count + *bond]);
                    graph.bonds[*bond].sign_into(index) * power
                });
                let (sum, most) =
                    powers.fold((0.0, 0.0f64), |(sum, most), power| (sum + power, most.max(power.abs())));
                if most > 0.0 {
                    error = error.max((sum / most).abs());
                }
            }
            residuals.push(Residual { element: element.name.clone(), error });
        } else {
            let taken: f64 =
                element.ports.iter().map(|bond| graph.bonds[*bond].sign_into(index) * energies[*bond]).sum();
            whole += taken;
            let held = held(equations, &mut pool, index, samples, variables);
            elements.push(ElementEnergy {
                element: element.name.clone(),
                kind: element.kind,
                taken,
                held,
                error: held.map(|held| (held - taken).abs() / measure),
            });
        }
    }
    Audit { bonds, elements, residuals, throughput, whole: whole.abs() / measure }
}

/// Change of the energy of a linear store between first and last sample.
fn held(
    equations: &Equations,
    pool: &mut Pool,
    element: usize,
    samples: &[(f64, Vec<f64>)],
    variables: &[Vec<f64>],
) -> Option<f64> {
    let graph = &equations.graph;
    let Law::Store(ports) = &graph.elements[element].law else { return None };
    if graph.elements[element].kind == Kind::Gas {
        // Its energy is what its third port holds.
        let symbol = format!("{}.displacement", graph.bond_name(graph.elements[element].ports[2]));
        let state = equations.states.iter().position(|state| state.symbol == symbol)?;
        return Some(samples.last()?.1[state] - samples.first()?.1[state]);
    }
    if !ports.iter().all(|port| port.inverse.is_some_and(|law| is_linear(pool, law))) {
        return None;
    }
    let last = samples.len().checked_sub(1)?;
    let mut change = 0.0;
    for (port, bond) in ports.iter().zip(&graph.elements[element].ports) {
        change += energy(equations, port, *bond, &samples[last], &variables[last])?
            - energy(equations, port, *bond, &samples[0], &variables[0])?;
    }
    // A law that asks for more than efforts, flows and signals has none.
    change.is_finite().then_some(change)
}

/// Whether a law of efforts and flows is linear in them, without a part that they do not bring.
fn is_linear(pool: &mut Pool, law: Id) -> bool {
    let is_own = |var: &Var| matches!(var, Var::Effort(_) | Var::Flow(_));
    let own: Vec<Var> = pool.variables(&[law]).into_iter().filter(is_own).collect();
    let zero = pool.constant(0.0);
    let rest = pool.substitute(law, &mut HashMap::new(), &|var| is_own(&var).then_some(zero));
    let is_straight = |var: Var| {
        let slope = pool.derivative(law, var, &mut HashMap::new());
        !pool.depends(slope, |var| is_own(&var))
    };
    own.into_iter().all(is_straight) && pool.is_zero(rest)
}

/// Half of content times its co-variable at a port: its share of the energy of a linear store. What a store that follows holds is what
/// its law gives for the flow, or effort, that the others impose on it.
fn energy(
    equations: &Equations,
    port: &StorePort,
    bond: usize,
    (time, state): &(f64, Vec<f64>),
    variables: &[f64],
) -> Option<f64> {
    let graph = &equations.graph;
    let count = graph.bonds.len();
    let is_inertia = graph.elements[graph.bonds[bond].to].kind == Kind::I;
    let content = if equations.causality.following_bonds.contains(&bond) {
        graph.pool.evaluate(port.inverse?, &|var| match var {
            Var::Time => *time,
            Var::Parameter(index) => graph.parameters[index as usize].value,
            Var::Effort(bond) => variables[bond as usize],
            Var::Flow(bond) => variables[count + bond as usize],
            Var::Signal(index) => variables[2 * count + index as usize],
            _ => f64::NAN,
        })
    } else {
        let what = if is_inertia { "momentum" } else { "displacement" };
        let symbol = format!("{}.{what}", graph.bond_name(bond));
        state[equations.states.iter().position(|state| state.symbol == symbol)?]
    };
    // Of a heat store the content itself is the energy.
    Some(match graph.bonds[bond].domain.is_true_bond() {
        true => 0.5 * content * variables[if is_inertia { count + bond } else { bond }],
        false => content,
    })
}
