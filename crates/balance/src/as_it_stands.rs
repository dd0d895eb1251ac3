//! A criterion of an engine with nothing added.

use crate::error::BalanceError;
use crate::optimum::optimise;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Stage};

/// What `engine` has of `criterion` as it stands, at its highest speed over the continuous cycle, in the unit of the criterion.
///
/// # Errors
/// [`BalanceError`] where the engine has not what the criterion needs, such as mounts.
///
/// # Example
/// ```
/// use lanchester_balance::as_it_stands;
/// use lanchester_task::{Criterion, Load};
///
/// let template = lanchester_file::template("in-line-6").expect("it is in the gallery");
/// let engine = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
/// // An in-line six is free of second order.
/// assert!(as_it_stands(&engine, Criterion::Order(Load::Force, 2.0))? < 1e-6);
/// # Ok::<(), lanchester_balance::BalanceError>(())
/// ```
pub fn as_it_stands(engine: &Engine, criterion: Criterion) -> Result<f64, BalanceError> {
    let task =
        BalanceTask { stages: vec![Stage { terms: vec![(1.0, criterion)] }], ..BalanceTask::default() };
    let effects = optimise(engine, &task)?.effects;
    Ok(effects.iter().find(|effect| effect.criterion == criterion).map_or(f64::NAN, |effect| effect.after))
}
