//! The text of a DXF file of release 12.

use super::bore::{BORES_LAYER, CENTRE_LINES_LAYER, DrawnBore, NOTES_LAYER, opened};
use super::decimal::decimal;
use lanchester_shape::{Contour, GeometryError, Outline, Part, Point};
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
    written(outline, &[])
}

/// The text of a DXF file of a part: its outline as [`dxf`] has it, with the bores of its inserts.
///
/// An empty bore from face to face is a hole of the outline. Slugs and blind bores are CIRCLEs on the layer [`BORES_LAYER`]. Every bore has
/// centre lines on [`CENTRE_LINES_LAYER`] and a TEXT with its diameter, depth and material on [`NOTES_LAYER`].
///
/// # Errors
/// Where a bore that goes through has no common outline with the part.
pub fn part_dxf(part: &Part) -> Result<String, GeometryError> {
    let bores = DrawnBore::all(part);
    Ok(written(&opened(part, &bores)?, &bores))
}

fn written(outline: &Outline, bores: &[DrawnBore]) -> String {
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
    let of_bores = [
        (BORES_LAYER, "5", "CONTINUOUS"),
        (CENTRE_LINES_LAYER, "3", "CENTER"),
        (NOTES_LAYER, "8", "CONTINUOUS"),
    ];
    let of_bores = if bores.is_empty() { &[][..] } else { &of_bores[..] };
    let types = if bores.is_empty() { 1 } else { 2 };
    file.groups(&[(0, "TABLE"), (2, "LTYPE")]);
    file.group(70, types);
    file.groups(&[(0, "LTYPE"), (2, "CONTINUOUS"), (70, "0"), (3, "Solid line")]);
    file.groups(&[(72, "65"), (73, "0"), (40, "0.0")]);
    if !bores.is_empty() {
        file.groups(&[(0, "LTYPE"), (2, "CENTER"), (70, "0"), (3, "Center ____ _ ____ _ ____")]);
        file.groups(&[(72, "65"), (73, "4"), (40, "10.0")]);
        file.groups(&[(49, "6.0"), (49, "-1.5"), (49, "1.0"), (49, "-1.5")]);
    }
    file.groups(&[(0, "ENDTAB"), (0, "TABLE"), (2, "LAYER")]);
    file.group(70, 2 + of_bores.len());
    let of_outline = [(OUTER_LAYER, "7", "CONTINUOUS"), (HOLES_LAYER, "1", "CONTINUOUS")];
    for (layer, colour, line) in of_outline.iter().chain(of_bores) {
        file.groups(&[(0, "LAYER"), (2, layer), (70, "0"), (62, colour), (6, line)]);
    }
    file.groups(&[(0, "ENDTAB"), (0, "ENDSEC")]);

    file.begin("ENTITIES");
    file.polyline(outline.outer(), OUTER_LAYER);
    for hole in outline.holes() {
        file.polyline(hole, HOLES_LAYER);
    }
    for drawn in bores {
        file.bore(drawn);
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

    fn bore(&mut self, drawn: &DrawnBore) {
        if !drawn.is_opening {
            self.groups(&[(0, "CIRCLE"), (8, BORES_LAYER)]);
            self.point(drawn.bore.centre);
            self.group(40, decimal(1e3 * drawn.bore.radius));
        }
        for [from, to] in drawn.centre_lines() {
            self.groups(&[(0, "LINE"), (8, CENTRE_LINES_LAYER)]);
            self.point(from);
            self.group(11, decimal(1e3 * to.x));
            self.group(21, decimal(1e3 * to.y));
            self.group(31, "0.0");
        }
        let (place, height) = drawn.note_place();
        self.groups(&[(0, "TEXT"), (8, NOTES_LAYER)]);
        self.point(place);
        self.group(40, decimal(1e3 * height));
        self.group(1, format_args!("%%c{} {}", drawn.diameter(), drawn.note));
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
