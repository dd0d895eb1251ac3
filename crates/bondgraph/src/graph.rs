//! A bond graph whose names, ports, domains and units are known to be right.

use crate::description::Text;
use crate::domain::Domain;
use crate::expression::{Id, Pool, Var};
use crate::unit::Unit;

/// A bond graph, checked. Expressions are kept in a pool of its own.
#[derive(Debug, Clone)]
pub struct Graph {
    /// Its name.
    pub name: String,
    pub(crate) pool: Pool,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) elements: Vec<Element>,
    pub(crate) bonds: Vec<Bond>,
    pub(crate) signals: Vec<Signal>,
    /// What happens on the way.
    pub(crate) rules: Vec<Rule>,
    /// Duration [s], number of samples, tolerance, as the file asks for.
    pub simulation: Asked,
    /// The text that it was read from, for the places of diagnostics; empty where it was described by calls.
    pub(crate) source: String,
}

/// What a graph file asks of its simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Duration [s].
    pub duration: f64,
    /// The period of its periodic motion.
    pub period: Option<Period>,
    /// Whether that motion is looked for instead of a run over the duration.
    pub periodic: bool,
    /// Samples over it.
    pub samples: usize,
    /// Relative tolerance.
    pub tolerance: f64,
}

/// What ends a period: a time, or the advance of a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Period {
    /// The state that advances; `None`: the time does.
    pub(crate) of: Option<Var>,
    /// By how much, SI; 0: the state comes back the same way.
    pub(crate) advance: f64,
}

#[derive(Debug, Clone)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    pub(crate) unit: Unit,
    /// The unit as its file writes it, where that is one of SI.
    pub(crate) written_unit: Option<String>,
    pub(crate) value: f64,
}

/// The kinds of elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "ElementKind")]
pub enum Kind {
    /// Source of effort.
    Se,
    /// Source of flow.
    Sf,
    /// Resistor.
    R,
    /// Capacitor, spring, tank.
    C,
    /// Inertia.
    I,
    /// Field of stores by an energy function.
    IC,
    /// Perfect gas: volume, mass and internal energy.
    Gas,
    /// Transformer.
    TF,
    /// Gyrator.
    GY,
    /// Junction of one effort.
    Zero,
    /// Junction of one flow.
    One,
}

#[derive(Debug, Clone)]
pub(crate) struct Element {
    pub(crate) name: String,
    /// As written: `MTF`.
    pub(crate) written: String,
    pub(crate) kind: Kind,
    pub(crate) span: std::ops::Range<usize>,
    /// Bond of each port.
    pub(crate) ports: Vec<usize>,
    pub(crate) law: Law,
    /// What a store holds, where its file gives it: by displacements and momenta of its ports, or by their flows.
    pub(crate) energy: Option<Id>,
    /// What a drawing says of its law: a number with its unit, or a short expression.
    pub(crate) value: Option<String>,
}

/// The law of an element in the variables of its bonds.
#[derive(Debug, Clone)]
pub(crate) enum Law {
    /// Effort of Se, flow of Sf.
    Source(Id),
    /// Effort by flow and flow by effort; a law that is given in one form has the other not.
    Resistor {
        effort: Option<Id>,
        flow: Option<Id>,
    },
    /// A resistor of several ports: flows by all efforts, or efforts by all flows.
    Resistors {
        gives_flows: bool,
        laws: Vec<Id>,
    },
    /// Each port of a store or field.
    Store(Vec<StorePort>),
    /// Ratio of TF or GY.
    Ratio(Id),
    /// Flows of the last ports by those of the first: rows of the matrix.
    Matrix(Vec<Vec<Id>>),
    Junction,
}

#[derive(Debug, Clone)]
pub(crate) struct StorePort {
    /// Effort by displacements (and momenta), where the port has a displacement.
    pub(crate) effort: Option<Id>,
    /// Flow by momenta (and displacements), where the port has a momentum.
    pub(crate) flow: Option<Id>,
    /// The stored quantity by the port's own effort (C) or flow (I), where the law can be turned round; of a field by its co-energy by the
    /// flows of all its ports.
    pub(crate) inverse: Option<Id>,
    /// What the displacement gains beside its own flow: the work that goes into the energy of a gas.
    pub(crate) gain: Option<Id>,
    /// Start of displacement and momentum.
    pub(crate) start: [f64; 2],
}

impl StorePort {
    /// Whether the port is given by its co-energy: it can follow alone.
    pub(crate) fn only_follows(&self) -> bool {
        self.effort.is_none() && self.flow.is_none()
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Bond {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) domain: Domain,
}

#[derive(Debug, Clone)]
pub(crate) struct Signal {
    pub(crate) name: String,
    pub(crate) unit: Unit,
    /// The expression, or the integrand of a signal that is a state.
    pub(crate) value: Id,
    /// Start of an integral.
    pub(crate) start: Option<f64>,
}

/// Something that happens where a quantity rises through zero.
#[derive(Debug, Clone)]
pub(crate) struct Rule {
    pub(crate) when: Id,
    /// States and their new values.
    pub(crate) set: Vec<(Var, Id)>,
    /// Whether the simulation ends there.
    pub(crate) stop: bool,
    pub(crate) span: std::ops::Range<usize>,
}

impl Graph {
    /// Names of the elements, in their order.
    pub fn element_names(&self) -> impl Iterator<Item = &str> {
        self.elements.iter().map(|element| element.name.as_str())
    }

    /// What a bond is called: its one-port element, or both ends.
    pub(crate) fn bond_name(&self, bond: usize) -> String {
        let Bond { from, to, .. } = self.bonds[bond];
        // What a gas holds is named after the gas, whatever stands at its other ports.
        let is_gas = self.elements[to].kind == Kind::Gas;
        for end in [to, from].into_iter().filter(|_| !is_gas) {
            if self.elements[end].ports.len() == 1 && !self.elements[end].is_junction() {
                return self.elements[end].name.clone();
            }
        }
        let port = |end: usize| {
            let element = &self.elements[end];
            if element.is_junction() {
                element.name.clone()
            } else {
                let port = element.ports.iter().position(|b| *b == bond).unwrap_or(0) + 1;
                format!("{}.{port}", element.name)
            }
        };
        if !self.elements[to].is_junction() {
            port(to)
        } else if !self.elements[from].is_junction() {
            port(from)
        } else {
            format!("{} > {}", port(from), port(to))
        }
    }

    /// The span of an element, for diagnostics.
    pub(crate) fn place(&self, element: usize) -> Text {
        Text { text: self.elements[element].name.clone(), span: self.elements[element].span.clone() }
    }
}

impl Element {
    pub(crate) fn is_junction(&self) -> bool {
        matches!(self.kind, Kind::Zero | Kind::One)
    }

    /// Its laws as they are written.
    pub(crate) fn laws(&self) -> Vec<Id> {
        match &self.law {
            Law::Source(law) | Law::Ratio(law) => vec![*law],
            Law::Resistor { effort, flow } => effort.iter().chain(flow).copied().collect(),
            Law::Resistors { laws, .. } => laws.clone(),
            Law::Store(ports) => ports.iter().flat_map(|port| port.effort.or(port.flow)).collect(),
            Law::Matrix(rows) => rows.concat(),
            Law::Junction => Vec::new(),
        }
    }
}

impl Bond {
    /// +1 where the half arrow points into the element, else -1.
    pub(crate) fn sign_into(&self, element: usize) -> f64 {
        if self.to == element { 1.0 } else { -1.0 }
    }
}
