//! Amounts of a free weight that can be made: steps, lists, equal parts; and what they cost.

use super::Reader;
use crate::document::{Field, Section, Span, Spot};
use lanchester_diagnostic::Mistake;
use lanchester_task::{BalanceTask, Catalogue, Cost, Criterion, FreeWeight, Limit, Seat};
use lanchester_units::{Bound, Dimension};

impl<'a> Reader<'a> {
    /// `step` or `catalogue`, within the least and the largest amount; `Some(None)` where there is neither.
    pub(super) fn catalogue(
        &mut self,
        section: &'a Section,
        radius: Option<f64>,
        (least, most): (f64, Option<f64>),
    ) -> Option<Option<Catalogue>> {
        let (step, list) = (section.texts("step"), section.texts("catalogue"));
        if section.has("step") && section.has("catalogue") {
            self.two_sources(section, "step", "catalogue", "the amounts of the weight");
            return None;
        }
        let key = if section.has("step") { "step" } else { "catalogue" };
        let texts = match (step, list) {
            (Field::Given(texts), _) | (_, Field::Given(texts)) => texts.value,
            (Field::Bad, _) | (_, Field::Bad) => return None,
            (Field::Absent, Field::Absent) => {
                if section.has("equal_parts") && !section.has("drill") {
                    let why = "equal parts have the same amount of their steps or of their list";
                    self.without_effect(
                        section,
                        "equal_parts",
                        why,
                        "add step = \"5 g\", or tie weights with equal_to",
                    );
                }
                return Some(None);
            }
        };
        if section.has("unbalance") {
            self.without_effect(section, key, "`unbalance` gives the amount", "leave one of them out");
            return None;
        }
        let amounts: Vec<Option<f64>> =
            texts.iter().map(|text| self.mass_or_unbalance(section, key, text, radius)).collect();
        let mut amounts: Vec<f64> = amounts.into_iter().collect::<Option<_>>()?;
        let catalogue = match (key, amounts.as_slice()) {
            ("step", [step]) => Catalogue::Steps(*step),
            ("step", other) => {
                let message = format!("`step` needs one amount, got {}", other.len());
                self.mistakes.push(
                    Mistake::error("E0206", section.value_span("step"), message)
                        .hint("write a list as catalogue = [\"120 g\", \"150 g\"]"),
                );
                return None;
            }
            (_, []) => {
                self.mistakes.push(
                    Mistake::error("E0206", section.value_span("catalogue"), "`catalogue` has no amount")
                        .hint("write catalogue = [\"120 g\", \"150 g\"], or leave it out"),
                );
                return None;
            }
            _ => {
                amounts.sort_by(f64::total_cmp);
                amounts.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * b.abs());
                Catalogue::Amounts(amounts)
            }
        };
        let last = most.map_or(catalogue.last(), |most| catalogue.below(most));
        if last == 0 || catalogue.amount(last) < least * (1.0 - 1e-9) {
            let ends = [least, most.unwrap_or(f64::INFINITY)]
                .map(|amount| lanchester_units::readable(amount, Dimension::Unbalance));
            let message = match most {
                Some(_) => format!("no amount of `{key}` lies between {} and {}", ends[0], ends[1]),
                None => format!("no amount of `{key}` is as large as the least amount, {}", ends[0]),
            };
            self.mistakes.push(
                Mistake::error("E0305", section.value_span(key), message)
                    .hint("widen `least` and `most`, or add an amount; a mass counts at `radius`"),
            );
            return None;
        }
        Some(Some(catalogue))
    }

    /// The largest cost; `Some(None)` where there is none.
    pub(super) fn budget(&mut self, section: &'a Section) -> Option<Option<Limit>> {
        match section.number("budget") {
            Field::Given(most) => Some(Some(Limit { criterion: Criterion::Cost, most: most.value })),
            Field::Absent => Some(None),
            Field::Bad => None,
        }
    }

    /// A cost that is asked for must be one of something; what costs something should be asked for, and has an end.
    pub(super) fn check_costs(&mut self, task: &BalanceTask, spans: &[Span]) {
        let costs = |weight: &FreeWeight| weight.cost != Cost::default();
        let priced = task.weights.iter().position(costs);
        if task.asks_for_cost() && priced.is_none() && task.shaft_costs.is_empty() {
            let message = "a cost is asked for, and no weight or shaft costs anything".to_string();
            self.missing(
                self.root.key_span("balance"),
                message,
                "add fixed_cost = 3 or cost_per_kg = 12 to the weights, or fixed_cost to the shafts".into(),
            );
        }
        if let (false, Some(weight)) = (task.asks_for_cost(), priced) {
            self.mistakes.push(
                Mistake::warning("W0204", spans[weight].clone(), "the cost is neither limited nor minimised")
                    .hint("add budget = 40, or \"cost\" to minimise"),
            );
        }
        for (index, weight) in task.weights.iter().enumerate() {
            let on_shaft = matches!(weight.seat, Seat::Shaft(shaft) if task.pays_for_shaft(shaft));
            if weight.most.is_none() && (task.pays_for_weight(index) || on_shaft) {
                self.most_missing(&spans[index], "a weight whose use costs something", "most = \"0.1 kg m\"");
            }
        }
    }

    /// What a weight costs if it is used.
    pub(super) fn cost(&mut self, section: &'a Section, radius: Option<f64>) -> Option<Cost> {
        let fixed = section.number("fixed_cost").or(0.0);
        let [per_kg, per_kg_m] = ["cost_per_kg", "cost_per_kg_m"].map(|key| section.number(key));
        if section.has("cost_per_kg") && section.has("cost_per_kg_m") {
            self.two_sources(section, "cost_per_kg", "cost_per_kg_m", "what the amount costs");
            return None;
        }
        let per_amount = match (per_kg, per_kg_m, radius) {
            (Field::Bad, _, _) | (_, Field::Bad, _) => return None,
            (Field::Given(cost), _, Some(radius)) => cost.value / radius,
            (Field::Given(_), _, None) => {
                self.missing(
                    section.value_span("cost_per_kg"),
                    "`cost_per_kg` needs the radius of the weight".into(),
                    "add radius = \"60 mm\", or give cost_per_kg_m for its unbalance".into(),
                );
                return None;
            }
            (_, Field::Given(cost), _) => cost.value,
            _ => 0.0,
        };
        Some(Cost { fixed: fixed?, per_amount })
    }

    /// An unbalance [kg m], from itself or from a mass at the radius of the weight.
    fn mass_or_unbalance(
        &mut self,
        section: &'a Section,
        key: &str,
        text: &Spot<String>,
        radius: Option<f64>,
    ) -> Option<f64> {
        let mass = lanchester_units::parse(&text.value, Dimension::Mass, key);
        let is_mass = mass.is_ok();
        let own = if is_mass { Dimension::Mass } else { Dimension::Unbalance };
        let value = mass.or_else(|_| lanchester_units::parse(&text.value, Dimension::Unbalance, key));
        let value = value.and_then(|value| {
            lanchester_units::within(
                value,
                own,
                Bound::Positive,
                key,
                &text.value,
                Some("\"5 g\" or \"200 g mm\""),
            )
        });
        let value = match value {
            Ok(value) => value,
            Err(refusal) => {
                let hint = match refusal.code {
                    "E0108" => refusal.hint,
                    _ => "write a mass such as \"5 g\", which counts at `radius`, or an unbalance such as \"200 g mm\"".into(),
                };
                self.mistakes.push(
                    Mistake::error(refusal.code, text.span.clone(), refusal.message)
                        .label(refusal.label)
                        .hint(hint),
                );
                return None;
            }
        };
        match (is_mass, radius) {
            (false, _) => Some(value),
            (true, Some(radius)) => Some(value * radius),
            (true, None) => {
                self.missing(
                    section.value_span(key),
                    format!("a mass in `{key}` needs the radius of the weight"),
                    "add radius = \"60 mm\", or give unbalances such as \"200 g mm\"".into(),
                );
                None
            }
        }
    }
}
