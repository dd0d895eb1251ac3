//! Layouts of engines whose cylinders stay where they are: V of offset banks, W, radials, geared crankshafts.

mod arranged_engine;
mod arranged_loads;
mod arranged_view;
mod arrangement;
mod arrangement_error;

pub(crate) use arranged_loads::ArrangedLoads;
pub(crate) use arranged_view::ArrangedView;
pub use arrangement::Arrangement;
pub use arrangement_error::ArrangementError;
