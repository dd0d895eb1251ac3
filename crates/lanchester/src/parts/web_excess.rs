//! Weights that do not fit on their webs, whoever chose them: methods that know no bound of what fits are held against it afterwards.

use crate::parts::best_shape::LargestShapes;
use crate::parts::duty::web_of;
use crate::parts::error::CounterweightError;
use lanchester_model::Engine;
use lanchester_task::ShapeTask;
use serde::Serialize;

/// A weight that passes what fits by less than this part of it fits.
const KEPT: f64 = 1e-6;

/// What is known of counterweights and their webs.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct WebExcesses {
    /// Weights that are larger than what fits on their webs.
    pub too_large: Vec<WebExcess>,
    /// Names of weights that stand on no web that stands free: what fits there is not known.
    pub elsewhere: Vec<String>,
    /// How many weights were held against what fits.
    pub checked: usize,
}

/// A weight that is larger than what fits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WebExcess {
    /// Name of the weight.
    pub name: String,
    /// The web, counted from 1 through all throws.
    pub web: usize,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// The largest unbalance that shapes and clearance allow there in its direction [kg m].
    pub bound: f64,
    /// What bounds it.
    pub by: String,
}

/// The counterweights of an engine against what fits on their webs, by `shapes` and the wanted clearance. Nothing is known, and none is
/// checked, without shapes or without the body of the crank; weights that are parts have a shape already.
///
/// # Errors
/// Where a shape or a clearance has no meaning.
pub fn web_excesses(engine: &Engine, shapes: Option<&ShapeTask>) -> Result<WebExcesses, CounterweightError> {
    let mut found = WebExcesses::default();
    let (Some(_), Some(shapes)) = (engine.crank_body, shapes) else { return Ok(found) };
    let mut known = LargestShapes::default();
    for weight in
        engine.counterweights.iter().filter(|weight| weight.part.is_none() && weight.unbalance > 0.0)
    {
        let Some(web) = web_of(engine, weight) else {
            found.elsewhere.push(weight.name.clone());
            continue;
        };
        let alone = engine
            .with(|parts| parts.counterweights = vec![weight.clone()])
            .map_err(CounterweightError::engine)?;
        let (bound, by) = known.largest(&alone, 0, shapes)?;
        found.checked += 1;
        if weight.unbalance > bound * (1.0 + KEPT) {
            let (name, unbalance) = (weight.name.clone(), weight.unbalance);
            found.too_large.push(WebExcess { name, web: web + 1, unbalance, bound, by });
        }
    }
    Ok(found)
}
