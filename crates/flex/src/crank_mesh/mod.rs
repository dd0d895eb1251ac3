//! The mesh of a crankshaft from its elements: plane regions across the crank, swept along it, with true fillets.
//!
//! * All circles of journals, pins, bores and fillets make one plane net, the core. Each web adds what its outline has beyond the
//!   fillets of its two bars. Bars and webs take their triangles from these nets, so that they fit at every face.
//! * Triangles become wedges between levels along z: layers within the fillet radius at both sides of a face, growing after.
//! * The sharp corner at a face is pulled onto the torus of the fillet, and the body with it (eq. 43.9).

mod bay;
mod carried;
mod chords;
mod circles;
mod ends;
mod extrude;
mod fillet;
mod levels;
mod lines;
mod net;
mod options;
mod places;
mod plain;
mod rim;
mod rings;
mod segment;
mod slugs;
mod stack;
mod sweep;

pub use options::CrankMeshOptions;
pub use sweep::{CUTS, CrankMesh, FilletPlace, WebPlace, crank_mesh, crank_mesh_of_bay};
