//! The text of a DXF file of release 12.

use super::decimal::decimal;
use lanchester_shape::Contour;
use lanchester_shape::Outline;
use lanchester_shape::Point;
use std::fmt::{Display, Write};

/// Layer of the outer contour.
pub const OUTER_LAYER: &str = "OUTER";
/// Layer of the holes.
pub const HOLES_LAYER: &str = "HOLES";
/// Comment at the head, since release 12 has no variable for the unit of length.
pub(super) const UNIT_COMMENT: &str = "lanchester: lengths in millimetres";

/// The text of a DXF file of an outline: ASCII, release 12 (AC1009), lengths in millimetres.
///
/// Each contour is a closed POLYLINE, anticlockwise, whose vertices carry the bulges of the edges; the outer contour is on the layer
/// [`OUTER_LAYER`], holes are on [`HOLES_LAYER`]. Numbers have as many digits as give them back; bulges below 1e-20 become zero.
pub fn dxf(outline: &Outline) -> String {
    let mut file = Groups(String::new());
    file.group(999, UNIT_COMMENT);
    file.begin("HEADER");
    file.group(9, "$ACADVER");
    file.group(1, "AC1009");
    let [low, high] = outline.bounds();
    for (name, corner) in [("$EXTMIN", low), ("$EXTMAX", high)] {
        file.group(9, name);
        file.point(corner);
    }
    file.group(0, "ENDSEC");

    file.begin("TABLES");
    file.groups(&[(0, "TABLE"), (2, "LTYPE"), (70, "1")]);
    file.groups(&[(0, "LTYPE"), (2, "CONTINUOUS"), (70, "0"), (3, "Solid line")]);
    file.groups(&[(72, "65"), (73, "0"), (40, "0.0"), (0, "ENDTAB")]);
    file.groups(&[(0, "TABLE"), (2, "LAYER"), (70, "2")]);
    for (layer, colour) in [(OUTER_LAYER, "7"), (HOLES_LAYER, "1")] {
        file.groups(&[(0, "LAYER"), (2, layer), (70, "0"), (62, colour), (6, "CONTINUOUS")]);
    }
    file.groups(&[(0, "ENDTAB"), (0, "ENDSEC")]);

    file.begin("ENTITIES");
    file.polyline(outline.outer(), OUTER_LAYER);
    for hole in outline.holes() {
        file.polyline(hole, HOLES_LAYER);
    }
    file.groups(&[(0, "ENDSEC"), (0, "EOF")]);
    file.0
}

/// The groups written so far.
struct Groups(String);

impl Groups {
    fn group(&mut self, code: i32, value: impl Display) {
        writeln!(self.0, "{code:3}\n{value}").expect("invariant: writing to a string succeeds");
    }

    fn groups(&mut self, groups: &[(i32, &str)]) {
        for (code, value) in groups {
            self.group(*code, value);
        }
    }

    fn begin(&mut self, section: &str) {
        self.groups(&[(0, "SECTION"), (2, section)]);
    }

    /// A point [m].
    fn point(&mut self, at: Point) {
        self.group(10, decimal(1e3 * at.x));
        self.group(20, decimal(1e3 * at.y));
        self.group(30, "0.0");
    }

    fn polyline(&mut self, contour: &Contour, layer: &str) {
        self.groups(&[(0, "POLYLINE"), (8, layer), (66, "1")]);
        self.point(Point::ORIGIN);
        self.group(70, 1);
        for edge in contour.edges() {
            self.groups(&[(0, "VERTEX"), (8, layer)]);
            self.point(edge.from);
            self.group(42, decimal(edge.bulge));
        }
        self.groups(&[(0, "SEQEND"), (8, layer)]);
    }
}
