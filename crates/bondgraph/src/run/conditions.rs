//! Conditions as the graph writes them.

use crate::equations::Equations;
use crate::expression::{Function, Id, Node, Pool, Printed, Style, Var};
use crate::graph::Element;
use std::collections::HashMap;

/// Longest condition that is written out.
const LONGEST: usize = 160;

impl Equations {
    /// Text of each switch function, such as `pipe.effort > 0`; `pool` and `number` are those by which parameters became numbers.
    pub(crate) fn conditions(
        &self,
        pool: &mut Pool,
        number: &impl Fn(Var) -> Option<Id>,
        by_numbers: &mut HashMap<Id, Id>,
        switches: &[Id],
    ) -> Vec<String> {
        let graph = &self.graph;
        let of_laws =
            graph.elements.iter().flat_map(Element::laws).chain(graph.signals.iter().map(|own| own.value));
        let mut written: Vec<Id> = Vec::new();
        for law in of_laws.collect::<Vec<_>>() {
            for part in graph.pool.parts(law) {
                match graph.pool.node(part) {
                    Node::If(g, ..) | Node::Call(Function::Sign | Function::Abs, g) => written.push(g),
                    Node::Min(a, b) => written.push(pool.difference(b, a)),
                    Node::Max(a, b) => written.push(pool.difference(a, b)),
                    _ => {}
                }
            }
        }
        let states: Vec<Id> =
            (0..self.states.len() as u32).map(|state| pool.var(Var::State(state))).collect();
        // What the equations made of each: variables of bonds by states, parameters as numbers.
        let resolved = |var: Var| match var {
            Var::Effort(bond) => Some(self.efforts[bond as usize]),
            Var::Flow(bond) => Some(self.flows[bond as usize]),
            Var::Signal(signal) => Some(self.signals[signal as usize]),
            Var::Displacement(bond) | Var::Momentum(bond) => {
                let what = if matches!(var, Var::Momentum(_)) { "momentum" } else { "displacement" };
                let symbol = format!("{}.{what}", graph.bond_name(bond as usize));
                let state = self.states.iter().position(|state| state.symbol == symbol)?;
                Some(states[state])
            }
            _ => None,
        };
        let mut names: HashMap<Id, Id> = HashMap::new();
        let mut by_bonds = HashMap::new();
        for condition in written {
            let inner = pool.substitute(condition, &mut by_bonds, &resolved);
            let folded = pool.substitute(inner, by_numbers, number);
            names.entry(folded).or_insert(condition);
        }
        for ((when, _), rule) in self.rules.iter().zip(&graph.rules) {
            let folded = pool.substitute(*when, by_numbers, number);
            names.insert(folded, rule.when);
        }
        let name = |var: Var| self.variable_name(var, Style::Text);
        let printed = Printed { pool, style: Style::Text, name, longest: LONGEST };
        switches
            .iter()
            .map(|switch| format!("{} > 0", printed.text(names.get(switch).copied().unwrap_or(*switch))))
            .collect()
    }
}
