//! Films and safeties that `[balance]` wants large, or not below a value.

use super::Reader;
use crate::document::{Field, Section, Span};
use lanchester_diagnostic::Mistake;
use lanchester_model::Engine;
use lanchester_task::{AtLeast, DurabilityCriterion, DurabilityWish};
use lanchester_units::BadQuantity;

impl<'a> Reader<'a> {
    /// `maximise` and `at_least`, with the place of each criterion in this order.
    pub(super) fn durability_wish(&mut self, section: &'a Section) -> Option<(DurabilityWish, Vec<Span>)> {
        let (mut wish, mut spans) = (DurabilityWish::default(), Vec::new());
        let mut are_good = true;
        match section.stages("maximise") {
            Field::Given(stages) => {
                for term in stages.value.iter().flat_map(|stage| &stage.value) {
                    let span = term.name.span.clone();
                    match DurabilityCriterion::named(&term.name.value) {
                        Ok(criterion) if wish.maximise.contains(&criterion) => {
                            self.named_twice(criterion, &span);
                            are_good = false;
                        }
                        Ok(criterion) => {
                            wish.maximise.push(criterion);
                            spans.push(span);
                        }
                        Err(bad) => are_good = self.refuse_durability(bad, &span),
                    }
                }
            }
            Field::Absent => {}
            Field::Bad => return None,
        }
        match section.terms("at_least") {
            Field::Given(terms) => {
                for term in terms.value {
                    let Some(amount) = &term.amount else { continue };
                    let criterion = match DurabilityCriterion::named(&term.name.value) {
                        Ok(criterion) => criterion,
                        Err(bad) => {
                            are_good = self.refuse_durability(bad, &term.name.span);
                            continue;
                        }
                    };
                    if wish.at_least.iter().any(|one| one.criterion == criterion) {
                        self.named_twice(criterion, &term.name.span);
                        are_good = false;
                        continue;
                    }
                    match criterion.amount(&amount.value) {
                        Ok(least) => {
                            wish.at_least.push(AtLeast { criterion, least });
                            spans.push(term.name.span.clone());
                        }
                        Err(bad) => are_good = self.refuse_durability(bad, &amount.span),
                    }
                }
            }
            Field::Absent => {}
            Field::Bad => return None,
        }
        are_good.then_some((wish, spans))
    }

    fn named_twice(&mut self, criterion: DurabilityCriterion, span: &Span) {
        let message = format!("\"{}\" is named twice", criterion.name());
        self.mistakes.push(Mistake::error("E0204", span.clone(), message).hint("name it once"));
    }

    fn refuse_durability(&mut self, bad: BadQuantity, span: &Span) -> bool {
        self.mistakes.push(Mistake::error("E0109", span.clone(), bad.message).hint(bad.hint));
        false
    }

    /// Refuses bearings and throws that the engine does not have.
    pub(super) fn check_durability_parts(&mut self, wish: &DurabilityWish, engine: &Engine, spans: &[Span]) {
        for (criterion, span) in wish.criteria().into_iter().zip(spans) {
            if let Err(bad) = criterion.check(engine) {
                self.mistakes.push(Mistake::error("E0205", span.clone(), bad.message).hint(bad.hint));
            }
        }
    }
}
