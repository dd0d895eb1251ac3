//! Counterweights, webs and crankshafts as real parts: shapes, mass properties, the best shape.
//!
//! Plane across the crank: origin on the crank axis, `x` along the unbalance of the part (a counterweight: away
//! from its crankpin), `y` a quarter turn further in the sense in which the crank turns. SI units.
//!
//! ```
//! use lanchester_geometry::{Contour, Outline, Point};
//!
//! let disc = Contour::circle(Point::new(0.03, 0.0), 0.05)?;
//! let bore = Contour::circle(Point::new(0.05, 0.0), 0.01)?;
//! let web = Outline::new(disc, vec![bore])?;
//! assert!((web.swept_radius() - 0.08).abs() < 1e-15);
//! assert!((web.moments().area - std::f64::consts::PI * (0.05f64.powi(2) - 0.01f64.powi(2))).abs() < 1e-15);
//! # Ok::<(), lanchester_geometry::GeometryError>(())
//! ```
#![forbid(unsafe_code)]

pub mod clearance;
mod counterweight_properties;
pub mod crankshaft;
mod design;
pub mod drawing;
pub mod export;
mod shaft_weight;

pub use counterweight_properties::{counterweight_properties, plain_web};
pub use design::*;
pub use lanchester_model::ShaftWeightPart;
pub use lanchester_shape::*;
pub use lanchester_task::{ShaftWeightAim, ShaftWeightTask};
pub use shaft_weight::{
    NearestShaftWeight, ShaftWeightDesign, ShaftWeightLimit, ShaftWeightOutcome, best_shaft_weight,
    shaft_solids,
};
