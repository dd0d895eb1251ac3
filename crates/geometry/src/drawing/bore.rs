//! Bores of a part on a drawing: circles with centre lines and a note.
//!
//! A bore that goes through and stays empty is an opening, and so a hole of the outline. A slug of another metal and a blind bore are no
//! openings: they are drawn on layers of their own, which the readers here keep apart from the outline.

use super::DrawingError;
use super::strand::Strand;
use lanchester_shape::{Contour, GeometryError, Insert, Outline, Part, Point};

/// Layer of the circles of slugs and blind bores.
pub const BORES_LAYER: &str = "BORES";
/// Layer of centre lines.
pub const CENTRE_LINES_LAYER: &str = "CENTRE_LINES";
/// Layer of notes: diameter, depth and material of bores.
pub const NOTES_LAYER: &str = "NOTES";

/// How far a centre line reaches beyond its circle, in parts of the radius.
const BEYOND: f64 = 0.25;
/// Share of the thickness within which a bore reaches a face.
const AT_FACE: f64 = 1e-9;

/// A circle on the layer of bores of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bore {
    /// Its centre [m].
    pub centre: Point,
    /// Its radius [m].
    pub radius: f64,
}

impl Bore {
    /// The circle of a strand that is one.
    pub(super) fn of(strand: &Strand) -> Result<Bore, DrawingError> {
        match &strand.edges[..] {
            [first, second] if strand.closed && first.bulge.abs() == 1.0 && second.bulge.abs() == 1.0 => {
                let centre = (first.from + second.from) * 0.5;
                Ok(Bore { centre, radius: (first.from - centre).norm() })
            }
            _ => Err(DrawingError::Unsupported {
                entity: strand.place.clone(),
                why: "is no circle, and stands on the layer of bores",
                hint: "move it to another layer",
            }),
        }
    }
}

/// A bore of a part with its centre lines and its note.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DrawnBore {
    pub bore: Bore,
    /// Whether it is an opening, which is a hole of the outline.
    pub is_opening: bool,
    /// What follows the diameter: "through", "10 mm deep from the front face, 18000 kg/m3".
    pub note: String,
}

impl DrawnBore {
    /// All bores of a part.
    pub fn all(part: &Part) -> Vec<DrawnBore> {
        part.inserts().iter().map(|insert| DrawnBore::of(insert, part.thickness())).collect()
    }

    fn of(insert: &Insert, thickness: f64) -> DrawnBore {
        let slack = AT_FACE * thickness;
        let (at_front, at_rear) = (insert.from <= slack, insert.to >= thickness - slack);
        let mut note = match (at_front, at_rear) {
            (true, true) => "through".to_owned(),
            (true, false) => format!("{} mm deep from the front face", millimetres(insert.to)),
            (false, true) => format!("{} mm deep from the rear face", millimetres(thickness - insert.from)),
            (false, false) => {
                let [from, to] = [insert.from, insert.to].map(millimetres);
                format!("from {from} to {to} mm behind the front face")
            }
        };
        if insert.density > 0.0 {
            note += &format!(", {} kg/m3", trimmed(insert.density, 1));
        }
        let bore = Bore { centre: insert.centre, radius: insert.radius };
        DrawnBore { bore, is_opening: at_front && at_rear && insert.density == 0.0, note }
    }

    /// Its centre lines: along x, along y [m].
    pub fn centre_lines(&self) -> [[Point; 2]; 2] {
        let Bore { centre, radius } = self.bore;
        let reach = (1.0 + BEYOND) * radius;
        [Point::new(reach, 0.0), Point::new(0.0, reach)].map(|way| [centre - way, centre + way])
    }

    /// Where its note begins [m], and how high its letters are.
    pub fn note_place(&self) -> (Point, f64) {
        let Bore { centre, radius } = self.bore;
        let height = (0.25 * radius).clamp(0.5e-3, 3e-3);
        (centre + Point::new(0.8 * radius, 0.8 * radius), height)
    }

    /// Diameter in millimetres, as the note has it.
    pub fn diameter(&self) -> String {
        millimetres(2.0 * self.bore.radius)
    }
}

/// The outline of a part with the bores that are openings as holes.
pub(super) fn opened(part: &Part, bores: &[DrawnBore]) -> Result<Outline, GeometryError> {
    let outline = part.outline();
    let mut holes = outline.holes().to_vec();
    for drawn in bores.iter().filter(|drawn| drawn.is_opening) {
        holes.push(Contour::circle(drawn.bore.centre, drawn.bore.radius)?);
    }
    match holes.len() == outline.holes().len() {
        true => Ok(outline.clone()),
        false => Outline::new(outline.outer().clone(), holes),
    }
}

/// A length in millimetres, to a thousandth.
fn millimetres(length: f64) -> String {
    trimmed(1e3 * length, 3)
}

/// At most so many decimals, without zeros at the end.
fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
