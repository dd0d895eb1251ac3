//! Parts as files that a CAD program, a printer or a viewer opens: STEP, STL, glTF.
//!
//! [`PlacedPart`]s, each with a name, a place along the crank and a turn about it, become [`Solid`]s: closed shells of planes,
//! cylinders and cones. An insert with a material is a solid of its own, in the bore of its part. The writers
//! touch no file: they give the text or the bytes, the same ones for the same solids.
//!
//! | writer | what | how exact |
//! |---|---|---|
//! | [`step`] | AP214, the analytic surfaces, millimetres, names and colours | rounding; lengths below [`RESOLUTION`] are not told apart |
//! | [`stl`] | binary, triangles, millimetres | chords within the facet error of the arcs; 32-bit floats |
//! | [`glb`] | binary glTF 2.0, triangles with normals, metres, names and colours | as STL |
//!
//! Frame: as the parts, with z along the crank axis. In glTF the outermost node turns it so that x points up.
//!
//! Chamfers are planes and cones. Where one meets a wall the edge is a line, a circle, an ellipse or a hyperbola; on an arc that is not about the crank
//! axis a turned chamfer ends in a curve that STEP has no exact form for: a spline within [`SPLINE_ERROR`] of it.
//!
//! ```
//! use lanchester_geometry::export::{PlacedPart, StepHeader, glb, solids, step, stl};
//! use lanchester_geometry::{Contour, Part, Point};
//!
//! let disc = Contour::circle(Point::ORIGIN, 0.05)?;
//! let web = PlacedPart::new("web 1", Part::new(disc.into(), 0.02, 7850.0)?);
//! let solids = solids(&[web.moved(0.1)])?;
//! assert!(step(&solids, &StepHeader::default()).starts_with("ISO-10303-21;"));
//! assert_eq!(stl(&solids, 1e-5)?.len() % 50, 84 % 50);
//! assert_eq!(&glb(&solids, 1e-5)?[..4], b"glTF");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bore;
mod chamfered;
mod error;
mod gltf;
mod mesh;
mod part_file;
mod placed_part;
mod slope;
mod solid;
mod step;
mod step_curve;
mod stl;
mod surface;
mod triangulation;

pub use error::ExportError;
pub use gltf::glb;
pub use part_file::{PartFormat, part_file};
pub use placed_part::{PlacedPart, solids};
pub use solid::Solid;
pub use step::{StepHeader, step};
pub use step_curve::SPLINE_ERROR;
pub use stl::stl;
pub use surface::{SurfaceMesh, surface_meshes};

/// Lengths below this are not told apart in an exported file [m]: arcs that stand out less over their chord are written as
/// lines; shorter edges, thinner parts and bores that leave a thinner wall are refused.
pub const RESOLUTION: f64 = 1e-8;
