//! The smallest safety of a fillet by finite elements.

use super::meter::EngineDurability;
use super::words::split_hint;
use crate::stress::{FatigueRequest, StressMesh, crank_fatigue};
use lanchester_model::Engine;
use lanchester_task::{Measured, Unmeasured};

impl EngineDurability<'_> {
    /// That of crankshaft 1.
    pub(super) fn fillets(&self, engine: &Engine) -> Measured {
        if !self.request.finite_elements {
            return Measured::Unknown(Unmeasured {
                reason: "the safety of fillets by finite elements takes from seconds to minutes an engine, and is not computed for the hundreds of a search".into(),
                remedy: "name `rule safety`, and judge the engine that is adopted by finite elements".into(),
            });
        }
        if self.request.length != 1.0 {
            return Measured::Unknown(Unmeasured {
                reason: "safeties by finite elements are those of the engine in its own size".into(),
                remedy: "compare the engines as they are".into(),
            });
        }
        let request = FatigueRequest {
            mesh: StressMesh::default(),
            speeds: self.speeds(engine),
            ..FatigueRequest::default()
        };
        let traces = match &self.traces {
            Ok(traces) => traces,
            Err(reason) => return Measured::Unknown(split_hint(reason, "give the pressures in [gas]")),
        };
        let found = match crank_fatigue(engine, traces, &request, &|_| ()) {
            Ok(found) => found,
            Err(error) => {
                return Measured::Unknown(split_hint(
                    &error.to_string(),
                    "give fillets and strengths of the crankshaft",
                ));
            }
        };
        let all = found.speeds.iter().flat_map(|at| {
            // Where nothing can fail by fatigue there is no safety to be small.
            at.fillets.iter().filter_map(move |fillet| Some((at.speed, fillet, fillet.point.safety_of_all?)))
        });
        let least = all.min_by(|a, b| a.2.total_cmp(&b.2));
        least.map_or_else(
            || {
                Measured::Unknown(Unmeasured {
                    reason: "the crankshaft has no fillet".into(),
                    remedy: "give pin_fillet and journal_fillet in [crank.body]".into(),
                })
            },
            |(speed, fillet, value)| Measured::Known {
                value,
                place: fillet.name.clone(),
                speed,
                left_out: String::new(),
            },
        )
    }
}
