//! Flat parts of a crank train with exact mass properties: outlines of lines and arcs, plates, inserts, chamfers.
//!
//! Plane across the crank: origin on the crank axis, `x` along the unbalance of the part (a counterweight: away
//! from its crankpin), `y` a quarter turn further in the sense in which the crank turns. SI units.
//!
//! ```
//! use lanchester_shape::{Contour, Outline, Point};
//!
//! let disc = Contour::circle(Point::new(0.03, 0.0), 0.05)?;
//! let bore = Contour::circle(Point::new(0.05, 0.0), 0.01)?;
//! let web = Outline::new(disc, vec![bore])?;
//! assert!((web.swept_radius() - 0.08).abs() < 1e-15);
//! assert!((web.moments().area - std::f64::consts::PI * (0.05f64.powi(2) - 0.01f64.powi(2))).abs() < 1e-15);
//! # Ok::<(), lanchester_shape::GeometryError>(())
//! ```
#![forbid(unsafe_code)]

mod area_moments;
mod chamfer;
mod circular_segment;
mod contour;
mod counterweight_shape;
mod crossing;
mod edge;
mod error;
mod mass_properties;
mod outline;
mod part;
mod point;
mod shaft_weight_shape;
mod union;

pub use area_moments::AreaMoments;
pub use chamfer::{Chamfer, Cut, Face};
pub use contour::{Contour, Corner};
pub use counterweight_shape::CounterweightShape;
pub use edge::Edge;
pub use error::{ContourPlace, GeometryError};
pub use mass_properties::{MassMoments, MassProperties};
pub use outline::Outline;
pub use part::{Insert, PLAUSIBLE_DENSITY, Part, plausible_density};
pub use point::Point;
pub use shaft_weight_shape::ShaftWeightShape;
