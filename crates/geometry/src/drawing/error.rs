//! Why a drawing gives no outline.

use lanchester_shape::GeometryError;
use lanchester_shape::Point;

/// An entity of a drawing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Its kind, as the file names it.
    pub entity: String,
    /// Line of the file where it begins, counted from 1.
    pub line: usize,
}

impl Place {
    /// An entity of this kind, shortened where the file is not one of ours to print.
    pub(super) fn new(entity: &str, line: usize) -> Place {
        let printable = entity.chars().map(|c| if c.is_control() { '?' } else { c });
        Place { entity: printable.take(40).collect(), line }
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} at line {}", self.entity, self.line)
    }
}

/// A point in the words of a message.
fn point(point: &Point) -> String {
    format!("({:.4} mm, {:.4} mm)", 1e3 * point.x, 1e3 * point.y)
}

/// Several entities in the words of a message.
fn places(places: &[Place]) -> String {
    places.iter().map(Place::to_string).collect::<Vec<_>>().join(", ")
}

/// A drawing that is not one outline, or a demand that cannot be. Points are in metres, y up, in the frame of the drawing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A unit that is no length.
    #[error("the unit of a drawing must be from 1e-12 m to 1e6 m, got {got} m\nhint: 0.001 for millimetres")]
    Unit {
        /// What was given [m].
        got: f64,
    },
    /// A gap that is no distance.
    #[error(
        "the gap to join ends must be from 0 to 1 m, got {got} m\nhint: 1e-6 is a thousandth of a millimetre"
    )]
    Gap {
        /// What was given [m].
        got: f64,
    },
    /// Neither file nor caller says the unit.
    #[error("the drawing does not say its unit of length: {why}\nhint: give the unit")]
    NoUnit {
        /// What the file lacks.
        why: &'static str,
    },
    /// A unit of the file that has no length.
    #[error(
        "line {line}: unit {got} is not known\nhint: give the unit, or draw in millimetres ($INSUNITS 4)"
    )]
    UnknownUnit {
        /// Where.
        line: usize,
        /// Its code.
        got: String,
    },
    /// Bytes that are not the text of such a file.
    #[error("this is no {format} text: {why}\nhint: {hint}")]
    NotText {
        /// Which format.
        format: &'static str,
        /// What it is instead.
        why: &'static str,
        /// What to do.
        hint: &'static str,
    },
    /// XML that is not well formed.
    #[error("line {line}: {message}\nhint: export the drawing again as plain SVG")]
    Xml {
        /// Where.
        line: usize,
        /// What the XML reader says.
        message: String,
    },
    /// Something else was needed there.
    #[error(
        "line {line}: needed {needed}, got \"{got}\"\nhint: the file is damaged or cut off; export it again"
    )]
    Syntax {
        /// Where.
        line: usize,
        /// What belongs there.
        needed: &'static str,
        /// What is there.
        got: String,
    },
    /// An entity that lacks something.
    #[error("{entity} has no {missing}\nhint: the file is damaged; export it again")]
    Missing {
        /// Which.
        entity: Place,
        /// What it lacks.
        missing: &'static str,
    },
    /// An entity that is no line and no arc, or cannot be read as one.
    #[error("{entity} {why}\nhint: {hint}")]
    Unsupported {
        /// Which.
        entity: Place,
        /// What is wrong with it.
        why: &'static str,
        /// What to do.
        hint: &'static str,
    },
    /// An entity that the drawing does not show.
    #[error(
        "{entity} on \"{layer}\" is hidden\nhint: delete it, show it, or name that layer as one to leave out"
    )]
    Hidden {
        /// Which.
        entity: Place,
        /// Its layer, or what hides it.
        layer: String,
    },
    /// Coordinates beyond [`super::FARTHEST`].
    #[error("{entity} reaches farther than 1e6 m from the origin\nhint: check the unit")]
    TooFar {
        /// Which.
        entity: Place,
    },
    /// A contour below [`super::SMALLEST`].
    #[error("the contour with {entity} is smaller than 1e-9 m\nhint: check the unit")]
    TooSmall {
        /// Which.
        entity: Place,
    },
    /// Nothing to make an outline of.
    #[error(
        "the drawing has no closed line ({left_out} entities left out)\nhint: draw the outline with lines and arcs in the model space, on a layer that is not left out"
    )]
    NoContour {
        /// How many entities were left out.
        left_out: usize,
    },
    /// A chain that does not close.
    #[error("the line that ends with {entity} is open at {}{}\nhint: close it, allow a larger gap, or name the layer of auxiliary lines as one to leave out", point(.at), distance(*.nearest))]
    Open {
        /// The entity at the open end.
        entity: Place,
        /// Where.
        at: Point,
        /// Distance of the nearest other end [m], if there is one.
        nearest: Option<f64>,
    },
    /// More than two ends at one place.
    #[error("more than two lines end at {}: {}\nhint: delete what was drawn twice, or allow a smaller gap", point(.at), places(.entities))]
    Branch {
        /// What ends there.
        entities: Vec<Place>,
        /// Where.
        at: Point,
    },
    /// A contour beside another one.
    #[error(
        "two outer contours: one with {first}, one with {second}\nhint: one outline per drawing; delete the others or move them to a layer to leave out"
    )]
    SeveralOuter {
        /// An entity of the larger one.
        first: Place,
        /// An entity of the other one.
        second: Place,
    },
    /// A contour within a hole.
    #[error(
        "the contour with {inner} lies within the hole with {hole}\nhint: material within a hole is another part; draw it by itself"
    )]
    Island {
        /// An entity of the inner one.
        inner: Place,
        /// An entity of the hole.
        hole: Place,
    },
    /// A contour that is no contour.
    #[error("{}: {error}", places(.entities))]
    Contour {
        /// The entities of the edges that the error names, else the one that it begins with.
        entities: Vec<Place>,
        /// What is wrong.
        error: GeometryError,
    },
    /// Contours that do not go together.
    #[error("{}: {error}", places(.entities))]
    Outline {
        /// An entity of each.
        entities: Vec<Place>,
        /// What is wrong.
        error: GeometryError,
    },
}

fn distance(distance: Option<f64>) -> String {
    distance.map_or_else(String::new, |distance| format!(", {:.3e} mm from the next end", 1e3 * distance))
}
