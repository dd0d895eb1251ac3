//! A finite element mesh as plain data, and its quality.

mod blocks;
mod carried;
mod data;
mod jacobian;
mod places;
mod quality;
mod surface;
mod weight;

pub use blocks::mapped_block;
pub(crate) use carried::cross;
pub use data::{Element, Mesh, NodeSet};
pub use places::PlaceInMesh;
pub use quality::{LEAST_JACOBIAN, MeshQuality, quality};
pub use surface::{SignedArea, SurfaceFace, signed_areas, surface, surface_areas};
pub(crate) use surface::{face_points, weighted_areas};
pub use weight::CarriedWeight;
