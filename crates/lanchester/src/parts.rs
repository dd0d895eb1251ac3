//! Counterweights and weights of balance shafts as parts: designed, checked, given to balancing as bounds.

pub(crate) mod best_shape;
pub(crate) mod check;
pub(crate) mod clearance;
pub(crate) mod design;
pub(crate) mod duty;
pub(crate) mod error;
pub(crate) mod import;
pub(crate) mod shaft_weights;
pub(crate) mod shape_front;
pub(crate) mod solids;
pub(crate) mod web_bounds;
pub(crate) mod web_excess;
pub(crate) mod weights_as_parts;

pub use best_shape::{EvolutionRequest, SharedWithWeb};
pub use check::{
    COUNTERWEIGHT_CHECK_VERSION, CheckedCounterweight, CheckedShaftWeight, CounterweightCheck,
    check_counterweights,
};
pub use clearance::{
    EngineClearanceError, ExactRod, clearance_curve, clearance_model, clearances, largest_swept_radius,
};
pub use design::{
    COUNTERWEIGHT_DESIGNS_VERSION, CounterweightDesigns, CounterweightRequest, DesignedCounterweight,
    adopted, counterweight_front, design_counterweights, with_counterweights, with_outline,
};
pub use error::CounterweightError;
pub use import::{DrawingKind, ImportedOutline, OutlineImport, OutlineImportError, import_outline};
pub use shaft_weights::{
    DesignedShaftWeight, SHAFT_WEIGHT_DESIGNS_VERSION, ShaftWeightDesigns, ShaftWeightPlace,
    design_shaft_weights, named_shaft_weights, shaft_weights_to_design, with_shaft_weights,
};
pub use shape_front::CounterweightFront;
pub use solids::{chosen_parts, crankshaft_parts, engine_parts, shaft_parts};
pub use web_bounds::{WebBoundError, optimise_on_webs};
pub use web_excess::{WebExcess, WebExcesses, web_excesses};
pub use weights_as_parts::{WeightAsPart, weights_as_parts};
