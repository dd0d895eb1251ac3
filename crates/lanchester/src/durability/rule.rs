//! The smallest safety of a throw by the formulas after UR M53.

use super::meter::EngineDurability;
use super::words::split_hint;
use crate::pressure::measured::TraceFile;
use crate::stress::rule::{CrankRuleError, RuleRequest, crank_rule_of_size};
use crate::stress::rule_torsion::{Chained, RuleTorsionError};
use lanchester_model::Engine;
use lanchester_report::CrankRule;
use lanchester_task::{DurabilityCriterion, Measured, Unmeasured};
use std::sync::PoisonError;

impl EngineDurability<'_> {
    /// That of a throw, or of all.
    pub(super) fn rule_of(&self, engine: &Engine, criterion: DurabilityCriterion) -> Measured {
        if !self.request.weights_alone || self.request.driveline.is_some() {
            return self.rule_now(engine, criterion);
        }
        let mut known = self.rule.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, measured)) = known.iter().find(|(own, _)| *own == criterion) {
            return measured.clone();
        }
        let measured = self.rule_now(engine, criterion);
        known.push((criterion, measured.clone()));
        measured
    }

    fn rule_now(&self, engine: &Engine, criterion: DurabilityCriterion) -> Measured {
        let DurabilityCriterion::RuleSafety(wanted) = criterion else { return unknown_throw() };
        let traces = match &self.traces {
            Ok(traces) => traces,
            Err(reason) => return Measured::Unknown(split_hint(reason, "give the pressures in [gas]")),
        };
        let mut smallest: Option<Measured> = None;
        for crankshaft in 0..engine.crankshafts.len() {
            if engine.throws.iter().all(|throw| throw.crankshaft != crankshaft)
                || wanted.is_some_and(|index| {
                    engine.throws.get(index).map(|own| own.crankshaft) != Some(crankshaft)
                })
            {
                continue;
            }
            let asked = RuleRequest { crankshaft, speeds: self.speeds(engine), ..RuleRequest::default() };
            let (found, left_out) = match self.sheet(engine, traces, &asked) {
                Ok(found) => found,
                Err(error) => {
                    return Measured::Unknown(split_hint(
                        &error.to_string(),
                        "complete [crank.body] and [crank.material]",
                    ));
                }
            };
            for sheet in &found.speeds {
                let of_throw = |throw: &&lanchester_strength::ThrowSheet| {
                    wanted.is_none_or(|index| throw.throw == index + 1)
                };
                for throw in sheet.throws.iter().filter(of_throw) {
                    if let Some((place, breach)) = throw.breaches().next() {
                        return Measured::Unknown(Unmeasured {
                            reason: format!(
                                "{place} is outside the range of the formulas after UR M53: {breach}"
                            ),
                            remedy: "judge it by finite elements, or change its sizes".into(),
                        });
                    }
                    for (place, value) in throw.safeties() {
                        let one = Measured::Known {
                            value,
                            place,
                            speed: sheet.speed / self.request.speed_of_original,
                            left_out: left_out.clone(),
                        };
                        smallest = Some(match smallest.take() {
                            Some(known) => known.smaller(one),
                            None => one,
                        });
                    }
                }
            }
        }
        smallest.unwrap_or_else(unknown_throw)
    }

    /// The sheet of a crankshaft, and what it leaves out.
    fn sheet(
        &self,
        engine: &Engine,
        traces: &[TraceFile],
        asked: &RuleRequest,
    ) -> Result<(CrankRule, String), CrankRuleError> {
        let size = [self.request.length, self.request.speed_of_original];
        let without = |why: &str| {
            let sheet = crank_rule_of_size(engine, traces, asked, size)?;
            Ok((sheet, format!("torsional vibration{why}")))
        };
        let Some(driveline) = &self.request.driveline else { return without("") };
        let ends = asked
            .speeds
            .iter()
            .fold([f64::INFINITY, 0.0_f64], |[low, high], speed| [low.min(*speed), high.max(*speed)]);
        match (Chained { engine, driveline, traces, size }).sheet(asked, Some(ends)) {
            Ok(sheet) => Ok((sheet, String::new())),
            Err(RuleTorsionError::Rule(error)) => Err(error),
            Err(RuleTorsionError::Torsion(error)) => {
                without(&format!(": {}", error.to_string().replace("\nhint:", ";")))
            }
        }
    }
}

fn unknown_throw() -> Measured {
    Measured::Unknown(Unmeasured {
        reason: "the engine has no such throw".into(),
        remedy: "judge it by something else".into(),
    })
}
