//! Energy audit: through every bond, at every junction and two-port, in every store, of the whole.

use crate::equations::Equations;
use crate::expression::{Id, Pool, Var};
use crate::graph::{Kind, Law, StorePort};
use lanchester_numerics::{GAUSS_16, gauss};
use serde::Serialize;
use std::collections::HashMap;

/// Share to which the energy of a law is integrated.
const SHARE: f64 = 1e-13;
/// Halvings of the way that a law is integrated over: enough for a kink.
const HALVINGS: u32 = 40;

/// Where the energy went.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Audit {
    /// Energy through each bond, along its half arrow [J].
    pub bonds: Vec<BondEnergy>,
    /// Energy that each one-port took in [J]; of sources negative what they gave.
    pub elements: Vec<ElementEnergy>,
    /// Largest difference of powers at each junction and two-port over all samples, against the largest power there.
    pub residuals: Vec<Residual>,
    /// What the errors are measured by [J]: energy that passed through the bond which carried the most, to and fro between the samples.
    pub throughput: f64,
    /// That bond.
    pub measured_at: String,
    /// Sum of what all one-ports took in, against the throughput: the error of the whole.
    pub whole: f64,
}

/// Energy through one bond.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BondEnergy {
    /// The bond.
    pub bond: String,
    /// Its energy [J].
    pub energy: f64,
}

/// Energy of one element.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ElementEnergy {
    /// The element.
    pub element: String,
    /// Its kind.
    pub kind: Kind,
    /// What it took in [J].
    pub taken: f64,
    /// Change of what it holds by its law [J], where that gives an energy; also of a store that follows others.
    pub held: Option<f64>,
    /// What events took out of it by setting what it holds [J]; absent where none did.
    pub taken_by_events: Option<f64>,
    /// What it took in less what it holds more and what events took, against the throughput.
    pub error: Option<f64>,
}

/// Error of one junction or two-port.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Residual {
    /// The element.
    pub element: String,
    /// Largest sum of powers against the largest power.
    pub error: f64,
}

/// A place of the run: time, states, and efforts, flows and signals.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    pub time: f64,
    pub state: Vec<f64>,
    pub variables: Vec<f64>,
}

/// An event that set states: just before and just behind it.
pub(crate) type Jump = [Place; 2];

pub(crate) fn audit(
    equations: &Equations,
    samples: &[(f64, Vec<f64>)],
    variables: &[Vec<f64>],
    jumps: &[Jump],
    end: &[f64],
) -> Audit {
    let graph = &equations.graph;
    let (count, states) = (graph.bonds.len(), equations.states.len());
    let energies = &end[states..];
    let passed = |bond: usize| -> f64 {
        let of = |state: &[f64]| state[states + bond];
        let between: f64 = samples.windows(2).map(|pair| (of(&pair[1].1) - of(&pair[0].1)).abs()).sum();
        between + samples.last().map_or(0.0, |last| (energies[bond] - of(&last.1)).abs())
    };
    let most = (0..count).map(|bond| (bond, passed(bond))).max_by(|a, b| a.1.total_cmp(&b.1));
    let (measured_at, throughput) =
        most.map_or((String::new(), 0.0), |(bond, energy)| (graph.bond_name(bond), energy));
    let measure = if throughput > 0.0 { throughput } else { 1.0 };
    let bonds =
        (0..count).map(|bond| BondEnergy { bond: graph.bond_name(bond), energy: energies[bond] }).collect();
    let (mut elements, mut residuals) = (Vec::new(), Vec::new());
    let mut whole = 0.0;
    let mut stores = Stores { equations, pool: graph.pool.clone() };
    let ends = samples.first().zip(samples.last()).zip(variables.first().zip(variables.last()));
    let ends = ends.map(|((a, b), (of_a, of_b))| {
        let place = |(time, state): &(f64, Vec<f64>), variables: &[f64]| Place {
            time: *time,
            state: state.clone(),
            variables: variables.to_vec(),
        };
        [place(a, of_a), place(b, of_b)]
    });
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
            let held = ends.as_ref().and_then(|ends| stores.gained(index, ends));
            let lost: Option<Vec<f64>> =
                jumps.iter().map(|jump| stores.gained(index, jump).map(|gained| -gained)).collect();
            let lost = lost.map(|list| list.iter().sum::<f64>()).filter(|lost| *lost != 0.0);
            elements.push(ElementEnergy {
                element: element.name.clone(),
                kind: element.kind,
                taken,
                held,
                taken_by_events: lost,
                error: held.map(|held| (held + lost.unwrap_or(0.0) - taken).abs() / measure),
            });
        }
    }
    Audit { bonds, elements, residuals, throughput, measured_at, whole: whole.abs() / measure }
}

/// What stores hold by their laws.
struct Stores<'a> {
    equations: &'a Equations,
    pool: Pool,
}

impl Stores<'_> {
    /// What a store holds more at the second of two places [J].
    fn gained(&mut self, element: usize, [from, to]: &[Place; 2]) -> Option<f64> {
        let graph = &self.equations.graph;
        let own = &graph.elements[element];
        let Law::Store(ports) = &own.law else { return None };
        let change = if own.kind == Kind::Gas {
            // Its energy is what its third port holds.
            let state = self.state(own.ports[2], "displacement")?;
            to.state[state] - from.state[state]
        } else if let Some(energy) = own.energy {
            if self.pool.depends(energy, |var| !is_of_ports(var, &own.ports)) {
                // Something else changes it, through no bond.
                return None;
            }
            self.value(energy, to) - self.value(energy, from)
        } else if ports.iter().all(|port| port.inverse.is_some_and(|law| is_linear(&mut self.pool, law))) {
            let mut change = 0.0;
            for (port, bond) in ports.iter().zip(&own.ports) {
                change += self.of_linear(port, *bond, to)? - self.of_linear(port, *bond, from)?;
            }
            change
        } else if let [port] = ports.as_slice() {
            self.by_law(port, own.ports[0], own.kind == Kind::I, [from, to])?
        } else {
            return None;
        };
        // A law that asks for more than efforts, flows and signals has none.
        change.is_finite().then_some(change)
    }

    /// The integral of the law of a port over its content.
    fn by_law(&self, port: &StorePort, bond: usize, is_inertia: bool, places: [&Place; 2]) -> Option<f64> {
        let graph = &self.equations.graph;
        let (what, own) = match is_inertia {
            true => ("momentum", Var::Momentum(bond as u32)),
            false => ("displacement", Var::Displacement(bond as u32)),
        };
        let state = self.state(bond, what)?;
        let [from, to] = places.map(|place| place.state[state]);
        if !graph.bonds[bond].domain.is_true_bond() {
            // Of a heat store the content itself is the energy.
            return Some(to - from);
        }
        let law = if is_inertia { port.flow? } else { port.effort? };
        if graph.pool.depends(law, |var| var != own && !matches!(var, Var::Parameter(_))) {
            return None;
        }
        let at = |content: f64| {
            graph.pool.evaluate(law, &|var| match var {
                Var::Parameter(index) => graph.parameters[index as usize].value,
                _ => content,
            })
        };
        let whole = gauss(&GAUSS_16, from, to, at);
        let size = gauss(&GAUSS_16, from, to, |content| at(content).abs()).abs();
        Some(halved(&at, from, to, whole, SHARE * size, HALVINGS))
    }

    fn state(&self, bond: usize, what: &str) -> Option<usize> {
        let symbol = format!("{}.{what}", self.equations.graph.bond_name(bond));
        self.equations.states.iter().position(|state| state.symbol == symbol)
    }

    /// Value of an expression at a place.
    fn value(&self, id: Id, place: &Place) -> f64 {
        let graph = &self.equations.graph;
        let count = graph.bonds.len();
        let content = |bond: u32, what: &str| {
            self.state(bond as usize, what).map_or(f64::NAN, |state| place.state[state])
        };
        self.pool.evaluate(id, &|var| match var {
            Var::Time => place.time,
            Var::Parameter(index) => graph.parameters[index as usize].value,
            Var::Effort(bond) => place.variables[bond as usize],
            Var::Flow(bond) => place.variables[count + bond as usize],
            Var::Signal(index) => place.variables[2 * count + index as usize],
            Var::Displacement(bond) => content(bond, "displacement"),
            Var::Momentum(bond) => content(bond, "momentum"),
            _ => f64::NAN,
        })
    }

    /// Half of content times its co-variable at a port: its share of the energy of a linear store. What a store that follows holds is what
    /// its law gives for the flow, or effort, that the others impose on it.
    fn of_linear(&self, port: &StorePort, bond: usize, place: &Place) -> Option<f64> {
        let graph = &self.equations.graph;
        let count = graph.bonds.len();
        let is_inertia = graph.elements[graph.bonds[bond].to].kind == Kind::I;
        let content = if self.equations.causality.following_bonds.contains(&bond) {
            self.value(port.inverse?, place)
        } else {
            place.state[self.state(bond, if is_inertia { "momentum" } else { "displacement" })?]
        };
        // Of a heat store the content itself is the energy.
        Some(match graph.bonds[bond].domain.is_true_bond() {
            true => 0.5 * content * place.variables[if is_inertia { count + bond } else { bond }],
            false => content,
        })
    }
}

/// Whether a variable is a number or belongs to one of these bonds.
fn is_of_ports(var: Var, ports: &[usize]) -> bool {
    match var {
        Var::Parameter(_) => true,
        Var::Effort(bond) | Var::Flow(bond) | Var::Displacement(bond) | Var::Momentum(bond) => {
            ports.contains(&(bond as usize))
        }
        _ => false,
    }
}

/// An integral, its parts halved until both halves together give what the whole gave.
fn halved(at: &impl Fn(f64) -> f64, from: f64, to: f64, whole: f64, error: f64, left: u32) -> f64 {
    let middle = 0.5 * (from + to);
    let [first, second] = [(from, middle), (middle, to)].map(|(a, b)| gauss(&GAUSS_16, a, b, at));
    let sum = first + second;
    if left == 0 || sum.is_nan() || (sum - whole).abs() <= error {
        return sum;
    }
    halved(at, from, middle, first, error, left - 1) + halved(at, middle, to, second, error, left - 1)
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
