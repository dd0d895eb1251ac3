//! What is wanted: criteria to minimise, criteria with a limit.

use super::Reader;
use crate::document::{Field, Section, Span, Term};
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_model::Mount;
use lanchester_task::criterion;
use lanchester_task::give_up;
use lanchester_task::main_load;
use lanchester_task::{BalanceTask, Criterion, GiveUp, Limit, Load, Stage};
use lanchester_units::Refusal;

impl<'a> Reader<'a> {
    pub(super) fn stages(&mut self, section: &'a Section, mounts: Option<&[Mount]>) -> Option<Vec<Stage>> {
        let stages = match section.stages("minimise") {
            Field::Given(stages) => stages.value,
            Field::Absent => return Some(Vec::new()),
            Field::Bad => return None,
        };
        let stages: Vec<Option<Stage>> = stages
            .iter()
            .map(|stage| {
                let terms: Vec<Option<(f64, Criterion)>> =
                    stage.value.iter().map(|term| self.weighted(term, mounts)).collect();
                terms.into_iter().collect::<Option<_>>().map(Stage::of)
            })
            .collect();
        stages.into_iter().collect()
    }

    /// A criterion and one over the value that counts as much as those of the others.
    fn weighted(&mut self, term: &Term, mounts: Option<&[Mount]>) -> Option<(f64, Criterion)> {
        let (criterion, amount) = self.term(term, mounts)?;
        let Some((amount, span)) = amount else { return Some((1.0, criterion)) };
        let weight = 1.0 / amount;
        if amount > 0.0 && weight.is_finite() {
            return Some((weight, criterion));
        }
        let message = format!("the value of `{}` must be more than 0", term.name.value);
        self.mistakes.push(
            Mistake::error("E0108", span, message)
                .label("out of range")
                .hint("a criterion counts by its share of the value given here"),
        );
        None
    }

    pub(super) fn limits(&mut self, section: &'a Section, mounts: Option<&[Mount]>) -> Option<Vec<Limit>> {
        let terms = match section.terms("limits") {
            Field::Given(terms) => terms.value,
            Field::Absent => return Some(Vec::new()),
            Field::Bad => return None,
        };
        let limits: Vec<Option<Limit>> = terms
            .iter()
            .map(|term| {
                let (criterion, amount) = self.term(term, mounts)?;
                let (most, span) = amount?;
                if most >= 0.0 {
                    return Some(Limit { criterion, most });
                }
                let message = format!("the limit of `{}` must not be negative", term.name.value);
                self.mistakes.push(
                    Mistake::error("E0108", span, message)
                        .label("out of range")
                        .hint("give the largest amount that it may have"),
                );
                None
            })
            .collect();
        limits.into_iter().collect()
    }

    /// What each stage gives up for those after it.
    pub(super) fn given_up(
        &mut self,
        section: &'a Section,
        stages: &[Stage],
        mounts: Option<&[Mount]>,
    ) -> Option<Vec<GiveUp>> {
        let terms = match section.terms("give_up") {
            Field::Given(terms) => terms.value,
            Field::Absent => return Some(Vec::new()),
            Field::Bad => return None,
        };
        let named = BalanceTask { stages: stages.to_vec(), ..BalanceTask::default() }.stages_or_default();
        let mut list = Vec::new();
        let mut taken: Vec<(usize, Span)> = Vec::new();
        let mut are_good = true;
        for term in terms {
            let Some(amount) = &term.amount else { continue };
            let name: String = term.name.value.chars().take(60).collect();
            let found =
                criterion::named(&term.name.value, mounts).map_err(|refusal| (refusal, &term.name.span));
            let found = found.and_then(|criterion| {
                let stage = give_up::stage_of(&criterion, &named).ok_or_else(|| {
                    let names = named.iter().flat_map(|stage| &stage.terms);
                    let names = names.map(|term| criterion::name_among(&term.1, mounts.unwrap_or(&[])));
                    (give_up::no_stage(&name, &names.collect::<Vec<_>>()), &term.name.span)
                })?;
                let given = give_up::amount(&amount.value, &named[stage], &name);
                given.map(|given| (stage, given)).map_err(|refusal| (refusal, &amount.span))
            });
            match found {
                Ok((stage, given)) => {
                    if let Some((_, first)) = taken.iter().find(|one| one.0 == stage) {
                        let message = format!("the stage of `{name}` gives up something twice");
                        self.mistakes.push(
                            Mistake::error("E0204", term.name.span.clone(), message)
                                .related(first.clone(), "the same stage")
                                .hint("a weighted sum is one stage: name it by one of its criteria"),
                        );
                        are_good = false;
                    }
                    taken.push((stage, term.name.span.clone()));
                    give_up::put(&mut list, stage, given);
                }
                Err((refusal, span)) => {
                    self.refuse(refusal, span);
                    are_good = false;
                }
            }
        }
        are_good.then_some(list)
    }

    /// Orders that must vanish, which leave nothing to minimise or to limit.
    pub(super) fn cancelled(
        &mut self,
        section: &'a Section,
        mounts: Option<&[Mount]>,
    ) -> Option<Vec<(Load, f64)>> {
        let orders = match section.stages("cancel") {
            Field::Given(orders) => orders.value,
            Field::Absent => return Some(Vec::new()),
            Field::Bad => return None,
        };
        for other in ["minimise", "give_up", "limits", "budget"] {
            if section.has(other) {
                let why = "`cancel` asks for weights that make its orders vanish";
                self.without_effect(section, other, why, "leave one of them out");
            }
        }
        let orders: Vec<Option<(Load, f64)>> = orders
            .iter()
            .flat_map(|order| &order.value)
            .map(|term| {
                let (criterion, _) = self.term(term, mounts)?;
                let found = criterion::cancelled(&criterion);
                if found.is_none() {
                    let name: String = term.name.value.chars().take(60).collect();
                    let message = format!("`cancel` {}, got \"{name}\"", criterion::CANCEL_NEEDS);
                    self.mistakes.push(
                        Mistake::error("E0109", term.name.span.clone(), message)
                            .label("not one order of a load")
                            .hint(criterion::cancel_hint(&name)),
                    );
                }
                found
            })
            .collect();
        orders.into_iter().collect()
    }

    fn refuse(&mut self, refusal: Refusal, span: &Span) {
        let Refusal { code, message, label, hint } = refusal;
        self.mistakes.push(Mistake::error(code, span.clone(), message).label(label).hint(hint));
    }

    /// The criterion and the value beside it.
    fn term(&mut self, term: &Term, mounts: Option<&[Mount]>) -> Option<(Criterion, Option<(f64, Span)>)> {
        let criterion = match criterion::named(&term.name.value, mounts) {
            Ok(criterion) => criterion,
            Err(refusal) => {
                self.refuse(refusal, &term.name.span);
                return None;
            }
        };
        let Some(amount) = &term.amount else { return Some((criterion, None)) };
        if criterion == Criterion::Cost {
            self.refuse(criterion::cost_has_no_value(&term.name.value), &term.name.span);
            return None;
        }
        let name: String = term.name.value.chars().take(60).collect();
        match lanchester_units::parse(&amount.value, criterion::dimension(&criterion), &name) {
            Ok(value) => Some((criterion, Some((value, amount.span.clone())))),
            Err(refusal) => {
                self.refuse(refusal, &amount.span);
                None
            }
        }
    }

    /// Where the mass of the free weights is asked for.
    pub(super) fn mass_span(&self, section: &'a Section, mounts: Option<&[Mount]>) -> Option<Span> {
        let limits = section.terms("limits").given().unwrap_or(&[]);
        let stages = section.stages("minimise").given().unwrap_or(&[]);
        let terms = stages.iter().flat_map(|stage| &stage.value).chain(limits);
        terms
            .filter(|term| criterion::named(&term.name.value, mounts) == Ok(Criterion::AddedMass))
            .map(|term| term.name.span.clone())
            .next()
    }

    /// The criteria that are about main bearings, which only the whole engine can tell, with where they stand.
    pub(super) fn of_mains(&self, section: &'a Section, mounts: Option<&[Mount]>) -> Vec<(Criterion, Span)> {
        let limits = section.terms("limits").given().unwrap_or(&[]);
        let stages = section.stages("minimise").given().unwrap_or(&[]);
        let terms = stages.iter().flat_map(|stage| &stage.value).chain(limits);
        terms
            .filter_map(|term| {
                let criterion = criterion::named(&term.name.value, mounts).ok()?;
                main_load::is_about_mains(&criterion).then(|| (criterion, term.name.span.clone()))
            })
            .collect()
    }

    /// Refuses main bearings that the engine does not have.
    pub(super) fn check_named_mains(&mut self, engine: &Engine, of_mains: &[(Criterion, Span)]) {
        for (criterion, span) in of_mains {
            if let Err(refusal) = main_load::check(criterion, engine) {
                self.refuse(refusal, span);
            }
        }
    }

    pub(super) fn check_radii(&mut self, task: &BalanceTask, span: Span) {
        let without: Vec<String> = task
            .weights
            .iter()
            .filter(|weight| weight.radius.is_none())
            .map(|weight| format!("\"{}\"", weight.name))
            .collect();
        if without.is_empty() {
            return;
        }
        const SHOWN: usize = 4;
        let more = match without.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        let names = without.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
        self.missing(
            span,
            format!("\"added mass\" needs the radius of every free weight: {names}{more} have none"),
            "add radius = \"60 mm\" to each, or take \"added unbalance\"".into(),
        );
    }
}
