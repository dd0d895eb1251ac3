//! How a correction is made: holes that are drilled, slugs that are pressed in.

pub(crate) mod drilling;
pub(crate) mod hole;
pub(crate) mod hole_search;
pub(crate) mod slug;

pub use drilling::{DrilledPlane, Drilling, drilling};
pub use hole::Hole;
pub use slug::{Slug, SlugPlan, slug_plan};
