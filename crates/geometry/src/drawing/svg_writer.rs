//! The text of an SVG file.

use super::bore::{DrawnBore, opened};
use super::decimal::decimal;
use lanchester_shape::{Edge, GeometryError, Outline, Part, Point};
use std::fmt::Write;

/// Bulge of a quarter turn, and a little for rounding.
const QUARTER: f64 = 0.414_213_562_373_1;
/// Below this an arc is its chord: the area between them is lost in the rounding of the corners.
const STRAIGHT: f64 = 1e-16;
/// Group of the circles of slugs and blind bores.
pub(super) const BORES_GROUP: &str = "lanchester-bores";
/// Group of centre lines and notes.
pub(super) const MARKS_GROUP: &str = "lanchester-marks";

/// The text of an SVG file of an outline: one user unit is a millimetre, also of the `width` and `height`.
///
/// One path holds all contours, filled by the even-odd rule; the y axis is turned, so that the drawing looks as in a frame with y up, and the
/// crank axis is the origin. Arcs of circles are arc commands. An arc of more than a quarter turn is written as two or four of equal length: a
/// chord and a radius do not tell the angle of a half circle to better than the root of their last digit.
pub fn svg(outline: &Outline) -> String {
    written(outline, &[])
}

/// The text of an SVG file of a part: its outline as [`svg`] has it, with the bores of its inserts.
///
/// An empty bore from face to face is a hole of the outline. Slugs and blind bores are circles of the group `lanchester-bores`; centre lines,
/// and a note with diameter, depth and material at every bore, are in the group `lanchester-marks`.
///
/// # Errors
/// Where a bore that goes through has no common outline with the part.
pub fn part_svg(part: &Part) -> Result<String, GeometryError> {
    let bores = DrawnBore::all(part);
    Ok(written(&opened(part, &bores)?, &bores))
}

fn written(outline: &Outline, bores: &[DrawnBore]) -> String {
    let [low, high] = outline.bounds().map(|corner| corner * 1e3);
    let margin = 0.05 * (high.x - low.x).max(high.y - low.y);
    let [width, height] = [high.x - low.x, high.y - low.y].map(|length| decimal(length + 2.0 * margin));
    let (left, top) = (decimal(low.x - margin), decimal(-high.y - margin));
    let mut path = String::new();
    for contour in outline.contours() {
        let start = contour.edges()[0].from;
        write!(path, "M {}", point(start)).expect("invariant: writing to a string succeeds");
        for (at, edge) in contour.edges().iter().enumerate() {
            let last = at + 1 == contour.edges().len();
            if !(last && edge.bulge.abs() < STRAIGHT) {
                path.push_str(&command(edge));
            }
        }
        path.push_str(" Z ");
    }
    let path = path.trim_end();
    let marks = marks(bores);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"{left} {top} {width} {height}\">\n\
         <path fill=\"#d9d9d9\" fill-rule=\"evenodd\" stroke=\"#000000\" stroke-width=\"0.25\" d=\"{path}\"/>\n{marks}</svg>\n"
    )
}

/// The groups of bores and of their centre lines and notes; nothing where there are none.
fn marks(bores: &[DrawnBore]) -> String {
    if bores.is_empty() {
        return String::new();
    }
    let (mut circles, mut marks) = (String::new(), String::new());
    for drawn in bores {
        let [x, y, radius] = [drawn.bore.centre.x, -drawn.bore.centre.y, drawn.bore.radius]
            .map(|length| decimal(1e3 * length));
        if !drawn.is_opening {
            circles += &format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>\n");
        }
        for [from, to] in drawn.centre_lines() {
            let [x1, y1, x2, y2] = [from.x, -from.y, to.x, -to.y].map(|length| decimal(1e3 * length));
            marks += &format!("<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>\n");
        }
        let (place, height) = drawn.note_place();
        let [x, y, height] = [place.x, -place.y, height].map(|length| decimal(1e3 * length));
        let (diameter, note) = (drawn.diameter(), &drawn.note);
        marks += &format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{height}\" font-family=\"sans-serif\" fill=\"#000000\" stroke=\"none\">\u{2300}{diameter} {note}</text>\n"
        );
    }
    format!(
        "<g id=\"{BORES_GROUP}\" fill=\"#9db4c8\" stroke=\"#000000\" stroke-width=\"0.25\">\n{circles}</g>\n\
         <g id=\"{MARKS_GROUP}\" stroke=\"#000000\" stroke-width=\"0.15\" stroke-dasharray=\"4 1 0.5 1\">\n{marks}</g>\n"
    )
}

/// A point [m], y turned.
fn point(at: Point) -> String {
    format!("{} {}", decimal(1e3 * at.x), decimal(-1e3 * at.y))
}

fn command(edge: &Edge) -> String {
    if edge.bulge.abs() < STRAIGHT {
        return format!(" L {}", point(edge.to));
    }
    if edge.bulge.abs() > QUARTER {
        return edge.halves().iter().map(command).collect();
    }
    let radius = decimal(1e3 * edge.radius());
    // Positive angles of SVG run from x to its y, which points down.
    let sense = if edge.bulge > 0.0 { 0 } else { 1 };
    format!(" A {radius} {radius} 0 0 {sense} {}", point(edge.to))
}
