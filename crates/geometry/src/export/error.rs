//! Why a part cannot be exported.

use lanchester_shape::{GeometryError, Point};

/// A point in the words of a message.
fn place(point: &Point) -> String {
    format!("({:.4} mm, {:.4} mm)", 1e3 * point.x, 1e3 * point.y)
}

/// A part or a demand that no exported file can meet. Points are in the part's own frame.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// Nothing to export.
    #[error("an export needs at least one part, got none\nhint: name a part")]
    NoPart,
    /// Several parts where an outline is asked for.
    #[error(
        "a drawing holds the outline of one part, got {got}\nhint: name one counterweight, or one balance shaft of one weight"
    )]
    OneOutline {
        /// How many.
        got: usize,
    },
    /// A part whose outline cannot be drawn.
    #[error(transparent)]
    Outline(#[from] GeometryError),
    /// A chamfer that begins along the outline, or touches it where it does not cross it.
    #[error(
        "{part}: a chamfer touches the outline at {} without crossing it\nhint: begin the chamfer a little farther in or out", place(.at)
    )]
    ChamferTouches {
        /// The part.
        part: String,
        /// Where [m].
        at: Point,
    },
    /// A place that is no number.
    #[error(
        "place and turn of {part} must be finite, got z = {z} m and {turn} rad\nhint: give finite values"
    )]
    Place {
        /// The part.
        part: String,
        /// Where it was put [m].
        z: f64,
        /// How it was turned [rad].
        turn: f64,
    },
    /// A wall between a bore and the outline or another contour that is too thin to be told from none.
    #[error(
        "{part}: the bore at {} leaves a wall of {:.3e} mm, at least 1e-5 mm can be exported\nhint: move it inwards, or draw the notch into the outline", place(.at), 1e3 * .wall
    )]
    NoWall {
        /// The part.
        part: String,
        /// Centre of the bore [m].
        at: Point,
        /// Thickness of the wall [m].
        wall: f64,
    },
    /// Two inserts that touch, but not one behind the other on one axis.
    #[error(
        "{part}: the inserts at {} and {} touch\nhint: leave a wall between them, or put them on one axis, one behind the other", place(.first), place(.second)
    )]
    InsertsTouch {
        /// The part.
        part: String,
        /// Centre of the one [m].
        first: Point,
        /// Centre of the other [m].
        second: Point,
    },
    /// An edge that is too short to be told from none.
    #[error(
        "{part}: an edge of the outline at {} is {:.3e} mm long, at least 1e-5 mm can be exported\nhint: leave the edge out and join its neighbours", place(.at), 1e3 * .length
    )]
    ShortEdge {
        /// The part.
        part: String,
        /// Where it begins [m].
        at: Point,
        /// Its chord [m].
        length: f64,
    },
    /// A part or an insert that is too short along the crank axis to be told from none.
    #[error(
        "{part}: the {what} is {:.3e} mm, at least 1e-5 mm can be exported\nhint: lengths inside are metres", 1e3 * .length
    )]
    TooThin {
        /// The part.
        part: String,
        /// Which length.
        what: &'static str,
        /// How long it is [m].
        length: f64,
    },
    /// A facet error that no mesh can have.
    #[error(
        "the facet error must be between {:.3e} mm and {:.3e} mm for these parts, got {:.3e} mm\nhint: 0.01 mm is fine for viewing, 0.001 mm for measuring", 1e3 * .least, 1e3 * .most, 1e3 * .got
    )]
    FacetError {
        /// What 32-bit floats can still tell [m].
        least: f64,
        /// The largest extent of the parts [m].
        most: f64,
        /// What was asked for [m].
        got: f64,
    },
    /// Facets of neighbouring arcs that would cross.
    #[error(
        "{part}: with a facet error of {:.3e} mm the facets near {} would cross another edge\nhint: ask for a smaller facet error", 1e3 * .facet_error, place(.at)
    )]
    FacetsCross {
        /// The solid.
        part: String,
        /// A point of a facet [m], in the frame of the assembly.
        at: Point,
        /// The facet error [m].
        facet_error: f64,
    },
    /// A solid that is too thin against the whole.
    #[error(
        "{part} is only {:.3e} mm thick, at least {:.3e} mm stay in 32-bit floats beside the other parts\nhint: export it alone near the origin, or as STEP", 1e3 * .extent, 1e3 * .least
    )]
    LostInRounding {
        /// The solid.
        part: String,
        /// Its least extent in x, y and z [m].
        extent: f64,
        /// What can be told [m].
        least: f64,
    },
    /// More bytes than the format can hold.
    #[error(
        "the file would have {bytes} bytes, this format holds at most 4294967295\nhint: ask for a larger facet error"
    )]
    TooLarge {
        /// How many.
        bytes: usize,
    },
}
