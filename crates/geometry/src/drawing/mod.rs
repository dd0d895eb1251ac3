//! Outlines as flat drawings that CAD programs, laser cutters and browsers open: DXF and SVG, written and read.
//!
//! The drawing's x and y are those of the outline, its origin is the crank axis. Nothing here touches a file: writers give the
//! text, the same one for the same outline, readers take the bytes.
//!
//! | | written | read |
//! |---|---|---|
//! | DXF | R12 text, millimetres: a closed POLYLINE with bulges for each contour, on the layers `OUTER` and `HOLES` | LINE, ARC, CIRCLE, POLYLINE and LWPOLYLINE with bulges, of the model space |
//! | SVG | one path of lines and circular arcs, one user unit a millimetre, y turned | path without Bezier curves, circle, rect, polygon, polyline, line; groups and transforms |
//!
//! **Bores.** [`part_dxf`] and [`part_svg`] draw a part with the bores of its inserts, each with centre lines and a note of diameter, depth and
//! material. An empty bore from face to face is a hole of the outline. Slugs and blind bores are circles on the layer `BORES` (in SVG the group
//! `lanchester-bores`); they are read into [`Drawing::bores`], apart from the outline.
//!
//! **Contours.** Closed lines of a file are contours. Loose lines and arcs are joined where exactly two ends lie within the gap that
//! [`DrawingOptions`] states. The sense in which they run means nothing; the largest contour is the outer one, those
//! within it are holes. Another outer contour, one within a hole, an open chain and a branch are errors.
//!
//! **Units.** A DXF file says its unit in `$INSUNITS`, or in the comment that [`dxf`] writes, since R12 has no such variable. An SVG file
//! says it by a `width` in mm, cm, Q, in, pt or pc together with a `viewBox`. Else the caller must.
//!
//! **What is not read.** Curves that are no lines or arcs (splines, ellipses, Bezier curves), blocks, lines with a width, hidden entities
//! and everything unknown are errors that name the entity and its line. Left out, and listed in [`Drawing::ignored`], are entities on the layers that
//! the caller names, and what draws no contour:
//! - DXF: TEXT, MTEXT, ATTDEF, DIMENSION and its variants, LEADER, MULTILEADER, TOLERANCE, POINT, HATCH, VIEWPORT, all of the paper space;
//! - SVG: text, title, desc, metadata, defs, style sheets that hide, move or cut nothing, elements of other namespaces.
//!
//! Colours, line types, stroke widths, fills with their rules, and constant heights above the plane are not looked at. Lines without length are left out unlisted; bulges below 1e-20 are taken for none.
//!
//! ```
//! use lanchester_geometry::drawing::{DrawingOptions, dxf, read_dxf, read_svg, svg};
//! use lanchester_geometry::{Contour, Outline, Point};
//!
//! let disc = Contour::circle(Point::new(0.03, 0.0), 0.05)?;
//! let bore = Contour::circle(Point::new(0.05, 0.0), 0.01)?;
//! let web = Outline::new(disc, vec![bore])?;
//! let options = DrawingOptions::default();
//! for read in [read_dxf(dxf(&web).as_bytes(), &options)?, read_svg(svg(&web).as_bytes(), &options)?] {
//!     assert!((read.outline.moments().area / web.moments().area - 1.0).abs() < 1e-14);
//!     assert_eq!(read.outline.holes().len(), 1);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bore;
mod decimal;
mod dxf_entities;
mod dxf_reader;
mod dxf_tags;
mod dxf_writer;
mod error;
mod nesting;
mod options;
mod strand;
mod svg_path;
mod svg_reader;
mod svg_scanner;
mod svg_shapes;
mod svg_transform;
mod svg_writer;

pub use bore::{BORES_LAYER, Bore, CENTRE_LINES_LAYER, NOTES_LAYER};
pub use dxf_reader::read_dxf;
pub use dxf_writer::{HOLES_LAYER, OUTER_LAYER, dxf, part_dxf};
pub use error::{DrawingError, Place};
pub use options::{Drawing, DrawingOptions, Ignored};
pub use svg_reader::read_svg;
pub use svg_writer::{part_svg, svg};

/// Farthest that a drawing may reach from its origin [m].
pub const FARTHEST: f64 = 1e6;
/// Least extent of a contour of a drawing [m].
pub const SMALLEST: f64 = 1e-9;
