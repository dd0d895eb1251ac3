//! The weights of balance shafts as parts: which of them, their duties, the best shapes.

use lanchester_geometry::{
    GeometryError, ShaftWeightDesign, ShaftWeightOutcome, ShaftWeightTask, best_shaft_weight,
};
use lanchester_model::{Engine, ShaftWeight};
use serde::Serialize;

/// Version of [`ShaftWeightDesigns`]; raised when a field changes its meaning or goes.
pub const SHAFT_WEIGHT_DESIGNS_VERSION: u32 = 1;

/// Where a weight of a shaft stands: index in [`Engine::shafts`], and in its weights.
pub type ShaftWeightPlace = (usize, usize);

/// A weight of a shaft and the shape that was found for it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DesignedShaftWeight {
    /// Its name: [`lanchester_model::BalanceShaft::weight_name`].
    pub name: String,
    /// Its place.
    pub place: ShaftWeightPlace,
    /// The unbalance that it must have [kg m].
    pub duty: f64,
    /// What was found.
    pub outcome: ShaftWeightOutcome,
}

/// The shapes found for weights of balance shafts.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftWeightDesigns {
    /// [`SHAFT_WEIGHT_DESIGNS_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Shapes among which they were found.
    pub task: ShaftWeightTask,
    /// The weights, in the order of the engine.
    pub weights: Vec<DesignedShaftWeight>,
}

/// The weights of balance shafts of these names: of a weight, or of a shaft for all of its weights. Names that are none of them come back
/// as they are.
pub fn named_shaft_weights<'n>(
    engine: &Engine,
    names: &'n [String],
) -> (Vec<ShaftWeightPlace>, Vec<&'n String>) {
    let is_named = |name: &String, (shaft, weight): ShaftWeightPlace| {
        let shaft = &engine.shafts[shaft];
        *name == shaft.name || *name == shaft.weight_name(weight)
    };
    let named = places(engine).filter(|place| names.iter().any(|name| is_named(name, *place))).collect();
    let is_other = |name: &&String| !places(engine).any(|place| is_named(name, place));
    (named, names.iter().filter(is_other).collect())
}

/// The weights of balance shafts that have an unbalance and no shape that is fixed: a shape is fixed where the file does not say beside
/// it what unbalance it should have.
pub fn shaft_weights_to_design(engine: &Engine) -> Vec<ShaftWeightPlace> {
    let is_open = |place: &ShaftWeightPlace| {
        let weight = weight_at(engine, *place);
        weight.part.is_none_or(|part| part.wanted.is_some()) && duty_of(weight) > 0.0
    };
    places(engine).filter(is_open).collect()
}

/// The best shape for each of these weights.
///
/// # Errors
/// Where a number of the task has no meaning, or a weight has no unbalance. That no shape has the unbalance is an outcome.
pub fn design_shaft_weights(
    engine: &Engine,
    task: &ShaftWeightTask,
    places: &[ShaftWeightPlace],
) -> Result<ShaftWeightDesigns, GeometryError> {
    let designed = |place: &ShaftWeightPlace| {
        let duty = duty_of(weight_at(engine, *place));
        let outcome = best_shaft_weight(duty, task)?;
        let name = engine.shafts[place.0].weight_name(place.1);
        Ok(DesignedShaftWeight { name, place: *place, duty, outcome })
    };
    Ok(ShaftWeightDesigns {
        version: SHAFT_WEIGHT_DESIGNS_VERSION,
        engine: engine.name.clone(),
        task: *task,
        weights: places.iter().map(designed).collect::<Result<_, _>>()?,
    })
}

/// The engine with `designs` in the place of the weights of balance shafts of these places.
pub fn with_shaft_weights(engine: &Engine, designs: &[(ShaftWeightPlace, ShaftWeightDesign)]) -> Engine {
    let mut fitted = engine.clone().into_parts();
    for ((shaft, weight), design) in designs {
        let weight = &mut fitted.shafts[*shaft].weights[*weight];
        let part = design.part(duty_of(weight));
        (weight.unbalance, weight.part) = (part.unbalance(), Some(part));
    }
    Engine::new(fitted).expect("invariant: a design has a finite unbalance")
}

fn places(engine: &Engine) -> impl Iterator<Item = ShaftWeightPlace> {
    let of_shaft = |(shaft, count): (usize, usize)| (0..count).map(move |weight| (shaft, weight));
    engine.shafts.iter().map(|shaft| shaft.weights.len()).enumerate().flat_map(of_shaft)
}

fn weight_at(engine: &Engine, (shaft, weight): ShaftWeightPlace) -> &ShaftWeight {
    &engine.shafts[shaft].weights[weight]
}

/// The unbalance that a weight should have [kg m].
fn duty_of(weight: &ShaftWeight) -> f64 {
    weight.part.and_then(|part| part.wanted).unwrap_or(weight.unbalance)
}
