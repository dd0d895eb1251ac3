//! Criteria of an engine, each from the room that knows it.

use super::meter::EngineDurability;
use lanchester_model::Engine;
use lanchester_task::{DurabilityCriterion, DurabilityMeter, Measured};

impl DurabilityMeter for EngineDurability<'_> {
    fn measure(&self, engine: &Engine, criteria: &[DurabilityCriterion]) -> Vec<Measured> {
        let films = self.films_of(engine, criteria);
        let of = |criterion: &DurabilityCriterion| match criterion {
            DurabilityCriterion::RuleSafety(_) => self.rule_of(engine, *criterion),
            DurabilityCriterion::FilletSafety => self.fillets(engine),
            film => films.of(*film),
        };
        criteria.iter().map(of).collect()
    }
}
