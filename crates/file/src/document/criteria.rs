//! Criteria of `[balance]` as they stand: their names and the values beside them. What they mean, only the whole file
//! can tell.

use super::section::{Span, Spot, Term, Value};
use super::value::LONGEST_LIST;
use super::walk::Walk;
use crate::schema::Key;
use lanchester_diagnostic::Mistake;
use toml_spanner::{Item, Value as Toml};

impl Walk<'_> {
    /// A list of criteria and of tables of criteria.
    pub(super) fn stages(
        &mut self,
        key: &Key,
        array: &toml_spanner::Array<'_>,
        item: &Item<'_>,
    ) -> Option<Value> {
        self.criteria_length(key, array, item)?;
        let stages: Vec<Option<Spot<Vec<Term>>>> = array
            .iter()
            .map(|item| {
                let span = item.span().range();
                let terms = match item.value() {
                    Toml::String(name) => {
                        let name = Spot { value: name.to_string(), span: span.clone() };
                        Some(vec![Term { name, amount: None }])
                    }
                    Toml::Table(table) => self.terms(key, table),
                    _ => {
                        self.wrong_kind(key, item, &span);
                        None
                    }
                };
                terms.map(|value| Spot { value, span })
            })
            .collect();
        stages.into_iter().collect::<Option<_>>().map(Value::Stages)
    }

    /// A list of criteria without values: one stage each.
    pub(super) fn orders(
        &mut self,
        key: &Key,
        array: &toml_spanner::Array<'_>,
        item: &Item<'_>,
    ) -> Option<Value> {
        self.criteria_length(key, array, item)?;
        let names: Vec<Option<Spot<Vec<Term>>>> = array
            .iter()
            .map(|item| {
                let span = item.span().range();
                let Toml::String(name) = item.value() else {
                    self.wrong_kind(key, item, &span);
                    return None;
                };
                let name = Spot { value: name.to_string(), span: span.clone() };
                Some(Spot { value: vec![Term { name, amount: None }], span })
            })
            .collect();
        names.into_iter().collect::<Option<_>>().map(Value::Stages)
    }

    /// Refuses a list of criteria that is empty or endless.
    fn criteria_length(&mut self, key: &Key, array: &toml_spanner::Array<'_>, item: &Item<'_>) -> Option<()> {
        let span = item.span().range();
        if array.len() > LONGEST_LIST {
            self.too_many(key, array.len(), LONGEST_LIST, span);
            return None;
        }
        if array.is_empty() {
            let message = format!("`{}` names no criterion", key.name);
            self.mistakes.push(
                Mistake::error("E0206", span, message)
                    .hint(format!("for example {} = {}; or leave it out", key.name, key.example)),
            );
            return None;
        }
        Some(())
    }

    /// An amount whose quantity only the reader knows.
    pub(super) fn amount(&mut self, key: &Key, item: &Item<'_>, key_span: &Span) -> Option<Spot<String>> {
        let span = item.span().range();
        let text = match item.value() {
            Toml::String(text) => text.to_string(),
            // Without its unit the reader refuses it, as everywhere.
            Toml::Integer(_) | Toml::Float(_) => self.text.get(span.clone()).unwrap_or("").to_string(),
            _ => {
                self.wrong_kind(key, item, key_span);
                return None;
            }
        };
        Some(Spot { value: text, span })
    }

    /// A table of criteria and a value of each.
    pub(super) fn terms(&mut self, key: &Key, table: &toml_spanner::Table<'_>) -> Option<Vec<Term>> {
        if table.is_empty() {
            let message = format!("`{}` names no criterion", key.name);
            let hint = format!("for example {} = {}; or leave it out", key.name, key.example);
            self.mistakes.push(Mistake::error("E0206", table.span().range(), message).hint(hint));
            return None;
        }
        if table.len() > LONGEST_LIST {
            self.too_many(key, table.len(), LONGEST_LIST, table.span().range());
            return None;
        }
        let terms: Vec<Option<Term>> = table
            .into_iter()
            .map(|(name, item)| {
                let span = item.span().range();
                let amount = match item.value() {
                    Toml::String(text) => text.to_string(),
                    // Without its unit the reader refuses it, as everywhere.
                    Toml::Integer(_) | Toml::Float(_) => {
                        self.text.get(span.clone()).unwrap_or("").to_string()
                    }
                    _ => {
                        self.wrong_kind(key, item, &name.span.range());
                        return None;
                    }
                };
                let name = Spot { value: name.name.to_string(), span: name.span.range() };
                Some(Term { name, amount: Some(Spot { value: amount, span }) })
            })
            .collect();
        terms.into_iter().collect()
    }
}
