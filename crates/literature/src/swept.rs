//! A crank by the sweep of the twin-cylinder thesis, with the true peaks of what it finds and the true optimum beside it.

use crate::arrangement_task::swept_task;
use crate::crank_sweep::{CrankLoad, CrankSweep, SweepOptions, SweptCrank, sweep};
use crate::twin_arrangement::{ArrangementOptions, crank_load, with_even_crank};
use lanchester_balance::BalanceError;
use lanchester_balance::optimise_with;
use lanchester_balance::{Answer, Outcome};
use lanchester_mechanism::{Kinematics, LoadRequest, total_loads};
use lanchester_model::Engine;
use serde::Serialize;

/// Version of [`Swept`]; raised when a field changes its meaning or goes.
pub const SWEPT_VERSION: u32 = 1;

/// A sweep of the crank and what there is to know about it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Swept {
    /// [`SWEPT_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 at which loads are judged [rad/s]: the highest of the engine.
    pub speed: f64,
    /// Angles of a revolution that the sweep looks at.
    pub angles: usize,
    /// The published method.
    pub sweep: CrankSweep,
    /// With the basic crank, the true peak over the continuous angle.
    pub basic: SweptCrank,
    /// With the sweep's best step, the true peak over the continuous angle.
    pub best: SweptCrank,
    /// The true optimum, proved.
    pub optimum: Answer,
    /// Whether the optimum has the sweep's one amount for every throw; else every throw is free by itself.
    pub one_amount: bool,
}

impl Swept {
    /// The true optimum: counterweight of throw 1 and the largest load; `None` where it was not proved.
    pub fn optimal(&self) -> Option<SweptCrank> {
        let proved = self.optimum.outcome == Outcome::Optimal;
        let (weight, stage) = (self.optimum.weights.first()?, self.optimum.stages.first()?);
        proved.then(|| SweptCrank { unbalance: weight.unbalance.norm(), criterion: stage.value })
    }
}

/// Sweeps the crank of `engine`, whose counterweights are left out and whose shafts are kept, for the smallest largest
/// `load`, by default the one that the thesis chooses its crank for ([`crank_load`]), and finds the true optimum.
///
/// # Errors
/// As [`sweep`] and [`crank_load`]; [`BalanceError::Missing`] where no load is named and no first order turns with the
/// crank.
///
/// # Example
/// ```
/// use lanchester_literature::{SweepOptions, swept};
/// use lanchester_mechanism::Kinematics;
/// let template = lanchester_file::template("single").expect("it is in the gallery");
/// let single = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
/// let found = swept(&single, None, Kinematics::Exact, &SweepOptions::default())?;
/// let optimum = found.optimal().expect("it is proved");
/// assert!(optimum.criterion <= found.best.criterion && found.best.criterion < 0.6 * found.basic.criterion);
/// # Ok::<(), lanchester_balance::BalanceError>(())
/// ```
pub fn swept(
    engine: &Engine,
    load: Option<CrankLoad>,
    kinematics: Kinematics,
    options: &SweepOptions,
) -> Result<Swept, BalanceError> {
    let rule = || {
        let options = ArrangementOptions { kinematics, ..ArrangementOptions::default() };
        crank_load(engine, &options)?.ok_or_else(|| BalanceError::Missing {
            criterion: "a swept crank".to_string(),
            needed: "a first order of force or couple that turns with the crank",
            hint: "name the load that is swept for, force or couple",
        })
    };
    let load = load.map_or_else(rule, Ok)?;
    let sweep = sweep(engine, load, kinematics, options)?;
    let bare = engine.without_counterweights();
    let task = swept_task(&bare, load);
    let request = LoadRequest { kinematics, ..LoadRequest::default() };
    let true_peak = |unbalance: f64| -> Result<SweptCrank, BalanceError> {
        let peaks = total_loads(&with_even_crank(engine, unbalance), &request)?.peaks;
        let criterion = match load {
            CrankLoad::Force => peaks.force.max.value,
            CrankLoad::Couple => peaks.couple.max.value,
        };
        Ok(SweptCrank { unbalance, criterion })
    };
    Ok(Swept {
        version: SWEPT_VERSION,
        engine: engine.name.clone(),
        speed: engine.speed.highest,
        angles: options.angles,
        basic: true_peak(sweep.basic.unbalance)?,
        best: true_peak(sweep.best().unbalance)?,
        one_amount: task.ties.len() + 1 == task.weights.len(),
        optimum: optimise_with(&bare, &task, kinematics)?,
        sweep,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};

    fn engine(name: &str) -> Engine {
        read(template(name).unwrap().text).engine().unwrap()
    }

    #[test]
    fn the_true_optimum_is_never_above_the_best_step_and_never_far_below() {
        for name in ["single", "twin-360", "twin-180", "v2-90", "boxer-2"] {
            let engine = engine(name);
            let found = swept(&engine, None, Kinematics::Exact, &SweepOptions::default()).unwrap();
            let optimum = found.optimal().unwrap();
            assert!(found.one_amount, "{name}");
            assert!(optimum.criterion <= found.best.criterion * (1.0 + 1e-9), "{name} {optimum:?}");
            // One step moves the load by at most what it weighs, with all throws adding up.
            let arm = engine.throws.iter().map(|t| match found.sweep.load {
                CrankLoad::Force => 1.0,
                CrankLoad::Couple => t.z.abs(),
            });
            let step = found.sweep.step * engine.speed.highest.powi(2) * arm.sum::<f64>();
            // A peak between two angles of the grid is higher by less than 3e-4 of it.
            let slack = 3e-4 * found.best.criterion;
            assert!(found.best.criterion - optimum.criterion <= step + slack, "{name} {optimum:?}");
        }
    }

    #[test]
    fn throws_out_of_line_are_free_by_themselves() {
        let found = swept(&engine("in-line-3"), None, Kinematics::Exact, &SweepOptions::default()).unwrap();
        assert!(!found.one_amount && found.sweep.load == CrankLoad::Couple);
        assert!(found.optimal().unwrap().criterion <= found.best.criterion * (1.0 + 1e-9));
    }

    #[test]
    fn shafts_of_the_file_stay() {
        let with = engine("in-line-3-shaft");
        let without = with.without_shafts();
        let best = |engine: &Engine| {
            let load = Some(CrankLoad::Couple);
            swept(engine, load, Kinematics::Exact, &SweepOptions::default()).unwrap().best.criterion
        };
        assert!((best(&with) - best(&without)).abs() > 1.0);
    }

    #[test]
    fn an_engine_without_a_first_order_needs_the_load_by_name() {
        let four = engine("in-line-4");
        let refused = swept(&four, None, Kinematics::Exact, &SweepOptions::default());
        assert!(matches!(refused, Err(BalanceError::Missing { .. })), "{refused:?}");
    }
}
