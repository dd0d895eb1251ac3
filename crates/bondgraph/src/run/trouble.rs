//! Why a run ended early, in words that name the element.

use crate::causality::loops::AlgebraicLoop;
use crate::equations::Equations;
use crate::expression::{Id, Var};
use crate::graph::{Element, Law};
use crate::run::compiled::Compiled;
use crate::run::seconds::seconds;
use crate::run::simulate::Pass;
use lanchester_numerics::{Outcome, System};

/// A ratio that is so many times as large as at the start has no bound.
const GROWN: f64 = 1e6;

/// Unknowns that are named at most.
const MOST_NAMES: usize = 4;

impl Equations {
    /// Ends a pass before the first sample at which a quantity is no finite number: no step need have met it.
    pub(crate) fn end_where_not_finite(&self, compiled: &mut Compiled, pass: &mut Pass) {
        let bad = |values: &Vec<f64>| values.iter().position(|value| !value.is_finite());
        let found = pass.variables.iter().enumerate().find_map(|(at, values)| Some((at, bad(values)?)));
        let Some((at, which)) = found else { return };
        let bonds = self.graph.bonds.len();
        let name = match which {
            effort if effort < bonds => format!("{}.effort", self.graph.bond_name(effort)),
            flow if flow < 2 * bonds => format!("{}.flow", self.graph.bond_name(flow - bonds)),
            signal => {
                self.graph.signals.get(signal - 2 * bonds).map_or_else(String::new, |own| own.name.clone())
            }
        };
        let (t, state) = &pass.samples[at];
        pass.ended = match self.unsolved(compiled, *t, state) {
            Some(words) => words,
            None => format!("`{name}` becomes no finite number at {t} s"),
        };
        pass.complete = false;
        // The start stays, whatever it is.
        pass.samples.truncate(at.max(1));
        pass.variables.truncate(at.max(1));
    }

    /// The state that changes fastest for its size where no step is short enough, in words.
    pub(crate) fn fastest(
        &self,
        compiled: &mut Compiled,
        t: f64,
        y: &[f64],
        largest: &[f64],
        outcome: Outcome,
    ) -> String {
        if !matches!(outcome, Outcome::StepTooSmall { .. }) {
            return String::new();
        }
        let mut rates = vec![0.0; largest.len()];
        compiled.derivative(t, y, &mut rates);
        let share = |index: &usize| rates[*index].abs() / largest[*index].max(f64::MIN_POSITIVE);
        let found = (0..self.states.len()).max_by(|a, b| share(a).total_cmp(&share(b)));
        found.map_or_else(String::new, |index| format!("; {} changes fastest", self.states[index].symbol))
    }

    /// Ratios of transformers and gyrators that have grown beyond measure since the start, in words; empty where none has.
    pub(crate) fn grown_moduli(&self, compiled: &mut Compiled, t: f64, y: &[f64]) -> String {
        let start: Vec<f64> = self.states.iter().map(|state| state.start).collect();
        let mut moduli = |t: f64, y: &[f64]| -> Vec<f64> {
            let variables = compiled.variables(t, y, self.graph.signals.len());
            let ratio = |element: &Element| match element.law {
                Law::Ratio(ratio) => self.value_at(ratio, t, y, &variables),
                _ => 0.0,
            };
            self.graph.elements.iter().map(ratio).collect()
        };
        let (now, first) = (moduli(t, y), moduli(0.0, &start));
        let grown: Vec<String> = (self.graph.elements.iter().zip(now.iter().zip(&first)))
            .filter(|(_, (now, first))| now.is_nan() || now.abs() > GROWN * first.abs().max(1e-3))
            .map(|(element, (now, _))| format!("`{}` is {now:.3e}", element.name))
            .collect();
        if grown.is_empty() { String::new() } else { format!("; the ratio of {} there", grown.join(", ")) }
    }

    /// Value of an expression of the graph, from states, efforts, flows and signals.
    fn value_at(&self, id: Id, t: f64, y: &[f64], variables: &[f64]) -> f64 {
        let bonds = self.graph.bonds.len();
        let content = |bond: u32, what: &str| {
            let symbol = format!("{}.{what}", self.graph.bond_name(bond as usize));
            self.states.iter().position(|state| state.symbol == symbol).map_or(0.0, |state| y[state])
        };
        self.graph.pool.evaluate(id, &|var| match var {
            Var::Time => t,
            Var::Parameter(index) => self.graph.parameters[index as usize].value,
            Var::Effort(bond) => variables[bond as usize],
            Var::Flow(bond) => variables[bonds + bond as usize],
            Var::Displacement(bond) => content(bond, "displacement"),
            Var::Momentum(bond) => content(bond, "momentum"),
            Var::Signal(signal) => {
                let name = &self.graph.signals[signal as usize].name;
                match self.states.iter().position(|state| state.name == *name) {
                    Some(state) => y[state],
                    None => variables[2 * bonds + signal as usize],
                }
            }
            _ => 0.0,
        })
    }

    /// A root whose argument is 0, or would be within a millionth of the duration, in words: no method gets past its infinite slope.
    pub(crate) fn root_at_zero(
        &self,
        compiled: &mut Compiled,
        duration: f64,
        t: f64,
        y: &[f64],
    ) -> Option<String> {
        let graph = &self.graph;
        let signals = graph.signals.len();
        let of_elements = graph.elements.iter().map(|element| (&element.name, element.laws()));
        let of_signals = graph.signals.iter().map(|signal| (&signal.name, vec![signal.value]));
        let roots: Vec<(&String, Id)> = of_elements
            .chain(of_signals)
            .flat_map(|(name, laws)| {
                laws.into_iter().flat_map(move |law| graph.pool.roots(law)).map(move |root| (name, root))
            })
            .collect();
        if roots.is_empty() {
            return None;
        }
        let mut rates = vec![0.0; y.len().max(compiled.dimension())];
        compiled.derivative(t, y, &mut rates);
        let variables = compiled.variables(t, y, signals);
        let step = 1e-9 * duration;
        let ahead: Vec<f64> = y.iter().zip(&rates).map(|(y, rate)| y + step * rate).collect();
        let later = compiled.variables(t + step, &ahead, signals);
        let is_at_zero = |argument: Id| {
            let [now, then] = [(t, y, &variables), (t + step, &ahead, &later)]
                .map(|(t, y, v)| self.value_at(argument, t, y, v));
            // The time in which it would be 0 is |x / x'|. Where a rate is no number there is the value alone.
            now == 0.0 || now.abs() <= 1e-6 * duration * ((then - now) / step).abs()
        };
        let (name, _) = roots.into_iter().find(|(_, argument)| is_at_zero(*argument))?;
        Some(format!(
            ": the root in the law of `{name}` is taken at 0 there, where its slope is infinite; write regroot(x, width), a root that is regular at 0, for sign(x)*sqrt(abs(x)), with a width far below the values that matter"
        ))
    }

    /// That the unknowns of algebraic loops have no solution, in words; `None` where they have.
    fn unsolved(&self, compiled: &mut Compiled, t: f64, y: &[f64]) -> Option<String> {
        if compiled.is_solved(t, y) {
            return None;
        }
        let left: Vec<&str> = (self.unknowns.iter())
            .filter(|unknown| unknown.solved.is_none())
            .map(|unknown| unknown.name.as_str())
            .collect();
        let within = |own: &&AlgebraicLoop| own.cut_at.iter().any(|cut| left.contains(&cut.as_str()));
        let elements = match self.causality.loops.iter().find(within) {
            Some(found) => format!("the algebraic loop of {}", found.elements.join(", ")),
            None => "the equations of stores that follow".into(),
        };
        let names =
            left.iter().take(MOST_NAMES).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        Some(format!("no solution of {elements} is found for {names} at {t} s"))
    }

    pub(crate) fn in_words(&self, compiled: &mut Compiled, outcome: Outcome, t: f64, y: &[f64]) -> String {
        let at = seconds(t);
        let state = |index: usize| match self.states.get(index) {
            Some(state) => format!("{} (last {:.6e} {})", state.symbol, y[index], state.unit_name),
            None => "an energy".to_owned(),
        };
        match outcome {
            Outcome::TooManyEvaluations { limit } => {
                format!("{limit} evaluations were not enough: at {at} s")
            }
            Outcome::NotFinite { component } => {
                if let Some(time) = compiled.unsolved_at()
                    && let Some(words) = self.unsolved(compiled, time, y)
                {
                    return words;
                }
                format!("the rate of {} is no finite number behind {at} s", state(component))
            }
            Outcome::StepTooSmall { .. } => {
                format!("no step is short enough at {at} s: a quantity jumps or grows without bound")
            }
            Outcome::Singular => format!("Newton's matrix is singular at {at} s"),
            other => format!("{other:?} at {at} s"),
        }
    }
}
