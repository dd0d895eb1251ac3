//! Clearance: how near counterweights and webs come to crankcase, pistons, liners and rods, in space and over all angles.
//!
//! Everything that turns is a plate (a counterweight, a plain web) between two planes; the obstacles are
//!
//! * the crankcase: a circle about the axis of the crankshaft;
//! * the piston: a cylinder of the bore's diameter about the cylinder axis, from its lower edge upwards, cut off before and behind
//!   where its width is given;
//! * the liner: a tube about the cylinder axis, from its lower end upwards;
//! * the rod: a disc about the crankpin and a bar from its lower pin to the piston pin. An articulated rod is its bar; the disc
//!   about the crankpin is that of its master and should hold the knuckle pins.
//!
//! The least distance is found by branch and bound over crank angle and outline, and proved: book, "The counterweight as
//! a part", eqs. (22.60) to (22.67). Rods and pistons move as [`RodMotion`] says; nothing bends, and there is no play.

mod clearance_model;
mod contact;
mod envelope;
mod error;
mod evaluation;
mod frame;
mod motion;
mod overlap;
mod result;
mod search;
mod section;
mod swept;
mod turning_body;

pub use clearance_model::ClearanceModel;
pub use envelope::RadialEnvelope;
pub use error::ClearanceError;
pub use motion::{RodBounds, RodMotion, RodPose};
pub use result::{
    BigEndClearance, BodyClearances, CLEARANCE_VERSION, Clearance, ClearanceCurve, Clearances, DepthAlong,
    Obstacle, Overlap, Smallest, SweptRoom,
};
pub use search::CLEARANCE_GAP;
pub use swept::{SweptOverlap, swept_overlaps};
