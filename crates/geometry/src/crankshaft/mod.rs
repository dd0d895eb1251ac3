//! A crankshaft as a body: what it weighs, where its centre is, how it is out of balance, and its parts for CAD files.
//!
//! Journals, pins, plain webs and counterweights are plates across the crank. Where they overlap, metal is counted once: the crankshaft
//! is cut into slabs wherever a plate begins or ends, each with the outline of the union of what is there ([`Outline::union`]).
//! A web with a counterweight in its plane and of its thickness is one solid. What journals, pins and webs share with a
//! counterweight is theirs; inserts and chamfers of a counterweight cut whatever is at their place.
//!
//! Frame: z along the crank from the free end to the flywheel, from the origin of the engine; x and y those of the crankshaft at
//! angle zero, from its own axis, so that throws stand at their angles.
//!
//! [`Outline::union`]: lanchester_shape::Outline::union

mod body;
mod element;
mod error;
mod piece;
mod slab;

pub use body::{CrankUnbalance, CrankshaftBody, CrankshaftSection, PointWeight, ThrowShare, crankshaft};
pub use element::SectionKind;
pub use error::CrankshaftError;
pub use piece::{CrankshaftPiece, crankshaft_pieces};
