//! What is wrong with an outline, a part or a question about them.

use crate::point::Point;

/// Which closed line of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContourPlace {
    /// The outer one.
    Outer,
    /// A hole, counted from 1.
    Hole(usize),
}

impl std::fmt::Display for ContourPlace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ContourPlace::Outer => write!(f, "the outer contour"),
            ContourPlace::Hole(number) => write!(f, "hole {number}"),
        }
    }
}

/// A point in the words of a message.
fn place(point: &Point) -> String {
    format!("({:.4} mm, {:.4} mm)", 1e3 * point.x, 1e3 * point.y)
}

/// A shape or a part that cannot be. Edges are counted from 1, in the order in which they were given.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// Fewer edges than enclose an area.
    #[error(
        "a contour needs three edges, or two of which one is an arc, got {edges}\nhint: give every corner once"
    )]
    TooFewEdges {
        /// Edges that there are.
        edges: usize,
    },
    /// A coordinate or a bulge that is no finite number.
    #[error("edge {edge} has a coordinate or bulge that is not finite\nhint: give finite lengths")]
    NotFinite {
        /// The edge.
        edge: usize,
    },
    /// An edge without length.
    #[error("edge {edge} has no length: it begins and ends at {}\nhint: leave the repeated point out", place(.at))]
    ZeroLength {
        /// The edge.
        edge: usize,
        /// Where.
        at: Point,
    },
    /// Two edges that do not meet.
    #[error(
        "the contour is open: edge {edge} ends at {}, edge {next} begins at {}, {:.3e} mm apart\nhint: join the ends, or allow a larger gap", place(.end), place(.begin), 1e3 * .gap
    )]
    Open {
        /// The edge before the gap.
        edge: usize,
        /// The edge after the gap.
        next: usize,
        /// Where the one ends.
        end: Point,
        /// Where the other begins.
        begin: Point,
        /// Distance between them [m].
        gap: f64,
    },
    /// A contour that crosses or touches itself.
    #[error(
        "the contour crosses or touches itself at {}: edges {first} and {second}\nhint: take the loop out there", place(.at)
    )]
    Crossing {
        /// One edge.
        first: usize,
        /// The other edge.
        second: usize,
        /// Where.
        at: Point,
    },
    /// A contour that runs clockwise.
    #[error(
        "the contour is inside out: it runs clockwise round {:.4} mm2\nhint: give its points in the other order; every contour, of a hole too, runs anticlockwise", 1e6 * .area
    )]
    InsideOut {
        /// Area that it encloses [m^2].
        area: f64,
    },
    /// Two contours of an outline that cross or touch.
    #[error("{first} and {second} cross or touch at {}\nhint: leave material between them", place(.at))]
    ContoursCross {
        /// One contour.
        first: ContourPlace,
        /// The other contour.
        second: ContourPlace,
        /// Where.
        at: Point,
    },
    /// A hole that is not in the material.
    #[error("hole {hole} with its point {} lies {}\nhint: a hole is inside the outer contour and beside the other holes", place(.at), match .within { ContourPlace::Outer => "outside the outer contour".to_string(), other => format!("within {other}") })]
    HoleOutside {
        /// The hole, counted from 1.
        hole: usize,
        /// A point of it.
        at: Point,
        /// The outer contour that it is not within, or the hole that it is within.
        within: ContourPlace,
    },
    /// Two outlines that do not make one piece.
    #[error(
        "the two outlines do not make one piece: one part has a corner at {}, another at {}\nhint: let them overlap or share a length of their edges", place(.first), place(.second)
    )]
    Disjoint {
        /// A corner of one part.
        first: Point,
        /// A corner of another part.
        second: Point,
    },
    /// Two outlines whose union would touch itself.
    #[error(
        "the union of the two outlines touches itself at {}\nhint: let them overlap there, or keep them apart", place(.at)
    )]
    Pinched {
        /// Where.
        at: Point,
    },
    /// Two outlines that run so close to each other that rounding would decide what their union is.
    #[error(
        "near {} the two outlines run so close to each other that rounding would decide what their union is\nhint: let the edges coincide there, or keep them a thousandth of a millimetre apart", place(.at)
    )]
    TooClose {
        /// Where.
        at: Point,
    },
    /// An insert that is not wholly in the material.
    #[error(
        "the insert of radius {:.4} mm at {} {what}\nhint: an insert makes its own bore, in material on all sides", 1e3 * .radius, place(.at)
    )]
    InsertOutside {
        /// Centre of the insert [m].
        at: Point,
        /// Its radius [m].
        radius: f64,
        /// What is wrong with it.
        what: &'static str,
    },
    /// A chamfer deeper than the part is thick.
    #[error(
        "the chamfer goes {:.4} mm deep, where {:.4} mm of thickness are left\nhint: begin it farther out or make it flatter", 1e3 * .deepest, 1e3 * .left
    )]
    ChamferTooDeep {
        /// Its largest depth [m].
        deepest: f64,
        /// What is left for it: the thickness less the chamfers of the other face [m].
        left: f64,
    },
    /// Two chamfers of one face that cut into each other.
    #[error("two chamfers of one face both cut at {}\nhint: keep their lines apart on the face", place(.at))]
    ChamfersMeet {
        /// A point of the outline where both cut.
        at: Point,
    },
    /// A front between an objective and itself.
    #[error("a front needs two different objectives\nhint: ask for the optimum of one")]
    SameObjective,
    /// A number that is not possible.
    #[error("{quantity} must be {needed}, got {got}\nhint: {hint}")]
    Number {
        /// Which number, with its unit.
        quantity: &'static str,
        /// What is possible.
        needed: &'static str,
        /// What was given.
        got: f64,
        /// What to do.
        hint: &'static str,
    },
}
