//! The flexible crankshaft of an engine over the cycle on its oil films, and what comes of it as quantities.
//!
//! | quantity | what it is |
//! |---|---|
//! | `cycle stress film` | largest von Mises stress of all fillets over the cycle [Pa] |
//! | `cycle angle film` | crank angle at which it is [rad] |
//! | `cycle play film` | largest distance of the pin of cylinder 1 from the middle of its big end [m] |
//!
//! The mesh is that of `stress.size` and `stress.fillet elements`; the highest speed of the engine, constant.

use crate::gas_run::traces;
use crate::stress::StressFit;
use lanchester::flex::train::BasisOptions;
use lanchester::model::Engine;
use lanchester::report::{CrankCycle, CycleLaw};
use lanchester::{CycleRequest, StressMesh, crank_cycle};

/// Instants of a revolution, and modes of the crankshaft.
const INSTANTS: usize = 360;
const MODES: usize = 16;

/// A quantity of a crankshaft over the cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CycleKey {
    what: What,
    law: CycleLaw,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    Stress,
    Angle,
    Play,
}

impl CycleKey {
    /// The quantity of this name; `None` if it is not one of these.
    pub fn parse(text: &str) -> Option<CycleKey> {
        let (what, law) = text.strip_prefix("cycle ")?.split_once(' ')?;
        let what = match what {
            "stress" => What::Stress,
            "angle" => What::Angle,
            "play" => What::Play,
            _ => return None,
        };
        let law = CycleLaw::FOUR.into_iter().find(|own| own.name() == law)?;
        Some(CycleKey { what, law })
    }

    /// Its value.
    pub fn of(self, found: &CrankCycle) -> Result<f64, String> {
        let run = found.runs.iter().find(|run| run.law == self.law).ok_or("the law was not run")?;
        let worst = run.worst().ok_or_else(|| run.outcome_words())?;
        Ok(match self.what {
            What::Stress => worst.peak,
            What::Angle => run.critical_angle(worst),
            What::Play => {
                let own = run.bearings.iter().find(|own| own.kind == lanchester::film::BearingKind::Crankpin);
                own.map_or(f64::NAN, |own| own.largest_eccentricity)
            }
        })
    }
}

/// Runs an engine.
pub(crate) fn cycle_of(engine: &Engine, fit: &StressFit) -> Result<CrankCycle, String> {
    let request = CycleRequest {
        mesh: StressMesh { options: fit.mesh(), ..StressMesh::default() },
        basis: BasisOptions { modes: MODES, ..BasisOptions::default() },
        laws: vec![CycleLaw::Film],
        instants: INSTANTS,
        ..CycleRequest::default()
    };
    crank_cycle(engine, &traces(), &request, &|_| true).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        assert_eq!(
            CycleKey::parse("cycle angle film"),
            Some(CycleKey { what: What::Angle, law: CycleLaw::Film })
        );
        assert!(CycleKey::parse("cycle angle").is_none() && CycleKey::parse("cycle stress oil").is_none());
    }
}
