//! Named parts at their places along the crank.

use super::bore::{Bore, bores, open_ends};
use super::slope::Slope;
use super::solid::{Solid, circle, exported_edges};
use super::{ExportError, RESOLUTION};
use lanchester_shape::Edge;
use lanchester_shape::Face;
use lanchester_shape::Part;
use lanchester_shape::Point;

/// Colour of a part that is given none: steel.
const STEEL: [f64; 3] = [0.62, 0.65, 0.69];
/// Colour of an insert: heavy metal.
const HEAVY_METAL: [f64; 3] = [0.32, 0.30, 0.36];

/// A part with a name, a place and a turn: one piece of an assembly, such as a crankshaft of webs, journals and pins.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedPart {
    /// Name that the file shows.
    pub name: String,
    /// The part in its own frame.
    pub part: Part,
    /// How far it is moved along the crank axis [m], beyond the part's own place.
    pub z: f64,
    /// Angle by which it is turned about the crank axis, from `x` towards `y` [rad].
    pub turn: f64,
    /// Red, green and blue, as a screen shows them; what lies outside 0 to 1 is taken for the nearer of the two.
    pub colour: [f64; 3],
}

impl PlacedPart {
    /// A part where it stands in its own frame, in the colour of steel.
    pub fn new(name: impl Into<String>, part: Part) -> PlacedPart {
        PlacedPart { name: name.into(), part, z: 0.0, turn: 0.0, colour: STEEL }
    }

    /// Moved by `z` along the crank axis [m].
    pub fn moved(self, z: f64) -> PlacedPart {
        PlacedPart { z: self.z + z, ..self }
    }

    /// Turned by `angle` about the crank axis, from `x` towards `y` [rad].
    pub fn turned(self, angle: f64) -> PlacedPart {
        PlacedPart { turn: self.turn + angle, ..self }
    }

    /// In a colour: red, green and blue between 0 and 1, as a screen shows them.
    pub fn coloured(self, colour: [f64; 3]) -> PlacedPart {
        PlacedPart { colour, ..self }
    }

    /// Its solids: the part with its bores, and its inserts in the order of the part, except holes.
    fn solids(&self) -> Result<Vec<Solid>, ExportError> {
        let part = &self.part;
        if !(self.z.is_finite() && self.turn.is_finite()) {
            return Err(ExportError::Place { part: self.name.clone(), z: self.z, turn: self.turn });
        }
        let lengths = part.inserts().iter().map(|insert| ("length of an insert", insert.to - insert.from));
        for (what, length) in std::iter::once(("thickness", part.thickness())).chain(lengths) {
            if length < RESOLUTION {
                return Err(ExportError::TooThin { part: self.name.clone(), what, length });
            }
        }
        let place = |point: Point| if self.turn == 0.0 { point } else { point.turned(self.turn) };
        let contours = part.outline().contours().map(|contour| {
            let edges = exported_edges(&self.name, contour)?;
            let turn = |edge: Edge| Edge { from: place(edge.from), to: place(edge.to), ..edge };
            Ok(edges.into_iter().map(turn).collect())
        });
        let contours = contours.collect::<Result<Vec<Vec<Edge>>, ExportError>>()?;
        let mut bores = bores(&self.name, part)?;
        for bore in &mut bores {
            bore.centre = place(bore.centre);
        }
        let front = part.faces()[0] + self.z;
        let rear = front + part.thickness();
        let colour = self.colour.map(|part| if part > 0.0 { part.min(1.0) } else { 0.0 });
        let body = if part.chamfers().is_empty() {
            Solid::prism((self.name.clone(), colour), &contours, &bores, [front, rear])
        } else {
            self.chamfered(&contours, &bores, [front, rear], colour)?
        };
        let mut solids = vec![body];
        for (number, insert) in part.inserts().iter().enumerate() {
            if insert.density == 0.0 {
                continue;
            }
            let name = format!("{}, insert {}", self.name, number + 1);
            let (opens_in_front, opens_behind) = open_ends(insert, part.thickness());
            let ends = [
                if opens_in_front { front } else { front + insert.from },
                if opens_behind { rear } else { front + insert.to },
            ];
            let outline = circle(place(insert.centre), insert.radius);
            solids.push(Solid::prism((name, HEAVY_METAL), &[outline], &[], ends));
        }
        Ok(solids)
    }
}

impl PlacedPart {
    /// The part itself with its chamfers.
    fn chamfered(
        &self,
        contours: &[Vec<Edge>],
        bores: &[Bore],
        faces: [f64; 2],
        colour: [f64; 3],
    ) -> Result<Solid, ExportError> {
        let (part, outline) = (&self.part, self.part.outline());
        let of = |face: Face| -> Vec<Slope> {
            let chamfers = part.chamfers().iter().filter(|chamfer| chamfer.face == face);
            chamfers.map(|chamfer| Slope::new(chamfer, self.turn, faces)).collect()
        };
        let slopes = [of(Face::Front), of(Face::Rear)];
        let deepest = slopes.each_ref().map(|slopes| {
            let reach = |direction: Point| outline.reach(direction.turned(-self.turn));
            slopes.iter().map(|slope| slope.deepest(outline.swept_radius(), reach)).fold(0.0, f64::max)
        });
        let length = part.thickness() - deepest[0] - deepest[1];
        if length < RESOLUTION {
            let what = "wall that the chamfers leave at their deepest";
            return Err(ExportError::TooThin { part: self.name.clone(), what, length });
        }
        Solid::chamfered((self.name.clone(), colour), contours, bores, faces, [&slopes[0], &slopes[1]])
    }
}

/// The solids of an assembly. A part comes before its inserts, parts in the order that they are given in.
///
/// Parts may touch or overlap: nothing joins them.
///
/// # Errors
/// Where there is no part, or one of them cannot be exported ([`ExportError`]).
pub fn solids(parts: &[PlacedPart]) -> Result<Vec<Solid>, ExportError> {
    if parts.is_empty() {
        return Err(ExportError::NoPart);
    }
    let mut solids = Vec::new();
    for part in parts {
        solids.extend(part.solids()?);
    }
    Ok(solids)
}
