//! Events: what rises through zero, and which states it sets.

use super::Checker;
use crate::description::Text;
use crate::expression::{Node, Scope, Var, parse};
use crate::graph::Rule;
use crate::unit::Unit;

impl Checker<'_> {
    /// All `[[event]]`.
    pub(super) fn rules(&mut self) -> Vec<Rule> {
        let description = self.description;
        let mut rules = Vec::new();
        for event in &description.events {
            let when = parse(&event.when, self);
            let set: Vec<_> =
                event.set.iter().filter_map(|(state, value)| self.setting(state, value)).collect();
            if let Some(when) = when {
                rules.push(Rule { when: when.id, set, stop: event.stop, span: event.when.span.clone() });
            }
        }
        rules
    }

    /// A state and its new value.
    fn setting(&mut self, state: &Text, value: &Text) -> Option<(Var, crate::expression::Id)> {
        let found = self.state(&state.text);
        let parsed = parse(value, self);
        let Some((var, unit)) = found else {
            let message = format!("`{}` is no state that an event could set", state.text);
            let hint = "there are signals that are integrals, momentum of an I and displacement of a C";
            self.mistakes.push("E1706", &state.span, message, hint);
            return None;
        };
        let parsed = parsed?;
        if let (Some(a), Some(b)) = (unit, parsed.unit)
            && a != b
        {
            let message = format!("`{}` is in {a}, its new value in {b}", state.text);
            self.mistakes.push("E1705", &value.span, message, "check the units of the parts");
        }
        Some((var, parsed.id))
    }

    /// A state by its name, and its unit.
    pub(super) fn state(&mut self, name: &str) -> Option<(Var, Option<Unit>)> {
        let parsed = self.name(name).ok()?;
        let var = match self.pool.node(parsed.id) {
            Node::Var(Var::Signal(index)) => {
                self.signals[index as usize].start.map(|_| Var::Signal(index))?
            }
            Node::Var(var @ (Var::Momentum(_) | Var::Displacement(_))) => var,
            _ => return None,
        };
        Some((var, parsed.unit))
    }
}
