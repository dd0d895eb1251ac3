//! A counterweight as a part.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Kind, Table};
use super::entry::{key, quantity};
use lanchester_units::Dimension::{Angle, Density, Length};

/// Corners of one contour.
const MOST_CORNERS: usize = 2000;
const MOST_OPENINGS: usize = 64;
const MOST_INSERTS: usize = 64;
const MOST_CHAMFERS: usize = 8;

pub(super) static SHAPE: Table = Table {
    header: "[counterweight.shape]",
    doc: "The counterweight as a flat part, its middle in the plane of the entry: a rectangle, a trapezoid and a circular segment around the disc of the web \
          (`rectangle_height`, `shoulder_height` or `shoulder_angle`, `arc_radius`, `arc_angle`), or an `outline` of its own. x and y count from the \
          crank axis, x along the `angle` of the entry (away from the crankpin, unless the entry says otherwise), y a quarter turn further in the sense in \
          which the crank turns.",
    keys: &[
        key(
            "thickness",
            Kind::Quantity(Length, Positive),
            Required,
            "Thickness along the crank.",
            "\"20 mm\"",
        ),
        quantity(
            "density",
            Density,
            Positive,
            "Density, between 1000 and 23000 kg/m3; default that of [crank.body].",
            "\"7850 kg/m3\"",
        ),
        quantity(
            "web_radius",
            Length,
            Positive,
            "Radius of the web's disc, and half width of the rectangle; default that of [crank.body]. The disc, and on \
             a web all that lies on the plain web of [crank.body], is no part of the counterweight.",
            "\"38 mm\"",
        ),
        quantity(
            "rectangle_height",
            Length,
            NotNegative,
            "Height of the rectangle, from the crank axis.",
            "\"20 mm\"",
        ),
        quantity("shoulder_height", Length, NotNegative, "Height of the trapezoid.", "\"12 mm\""),
        quantity(
            "shoulder_angle",
            Angle,
            NotNegative,
            "Instead of `shoulder_height`: angle between the flank of the trapezoid and the chord of the arc, from 0 (a flat step) to 89 deg.",
            "\"30 deg\"",
        ),
        quantity("arc_radius", Length, Positive, "Radius of the arc.", "\"80 mm\""),
        quantity(
            "arc_angle",
            Angle,
            Positive,
            "Included angle of the arc, less than a full turn.",
            "\"120 deg\"",
        ),
        key(
            "outline",
            Kind::Tables(&CORNER, MOST_CORNERS),
            Optional,
            "Corners of an outline of its own, anticlockwise (from x towards y), each once; the last is joined to the first.",
            "[{ x = \"40 mm\", y = \"-30 mm\" }]",
        ),
        key(
            "encloses",
            Kind::Choice(&["counterweight", "web"]),
            Optional,
            "What the outline encloses: the counterweight alone (default), or the whole web with its counterweight. The latter needs `web` and \
             [crank.body]; the unbalance of the weight is then what the web has more than a plain one.",
            "\"web\"",
        ),
        key(
            "openings",
            Kind::Tables(&OPENING, MOST_OPENINGS),
            Optional,
            "Openings of the outline.",
            "[{ corners = [] }]",
        ),
        key(
            "inserts",
            Kind::Tables(&INSERT, MOST_INSERTS),
            Optional,
            "Bores along the crank, filled or not.",
            "[{ x = \"60 mm\", y = \"0 mm\", radius = \"8 mm\", density = \"18000 kg/m3\" }]",
        ),
        key(
            "chamfers",
            Kind::Tables(&CHAMFER, MOST_CHAMFERS),
            Optional,
            "Chamfers of the edge.",
            "[{ face = \"rear\", angle = \"45 deg\", radius = \"70 mm\" }]",
        ),
    ],
};

static CORNER: Table = Table {
    header: "[[counterweight.shape.outline]]",
    doc: "A corner of an outline or of an opening, and the edge to the next corner.",
    keys: &[
        key("x", Kind::Quantity(Length, Any), Required, "Place along the weight's angle.", "\"40 mm\""),
        key("y", Kind::Quantity(Length, Any), Required, "Place a quarter turn further.", "\"-30 mm\""),
        key(
            "bulge",
            Kind::Number(Any),
            Optional,
            "Tangent of a quarter of the included angle of the arc to the next corner, as in DXF: positive anticlockwise, 1 for a half circle, default 0 for a \
             straight line.",
            "0.4",
        ),
    ],
};

static OPENING: Table = Table {
    header: "[[counterweight.shape.openings]]",
    doc: "An opening through the part.",
    keys: &[key(
        "corners",
        Kind::Tables(&CORNER, MOST_CORNERS),
        Required,
        "Its corners, anticlockwise too.",
        "[{ x = \"50 mm\", y = \"0 mm\", bulge = 1 }]",
    )],
};

static INSERT: Table = Table {
    header: "[[counterweight.shape.inserts]]",
    doc: "A bore along the crank axis, filled with another material or empty.",
    keys: &[
        key("x", Kind::Quantity(Length, Any), Required, "Centre of the bore.", "\"60 mm\""),
        key("y", Kind::Quantity(Length, Any), Required, "Centre of the bore.", "\"0 mm\""),
        key("radius", Kind::Quantity(Length, Positive), Required, "Radius of the bore.", "\"8 mm\""),
        quantity(
            "density",
            Density,
            Positive,
            "Density of what is in it; without it the bore is empty.",
            "\"18000 kg/m3\"",
        ),
        key(
            "face",
            Kind::Choice(&["front", "rear"]),
            Optional,
            "With `depth`: face that it begins on; the front is towards the free end.",
            "\"front\"",
        ),
        quantity("depth", Length, Positive, "Depth from that face; default through the part.", "\"12 mm\""),
    ],
};

static CHAMFER: Table = Table {
    header: "[[counterweight.shape.chamfers]]",
    doc: "A chamfer: turned about the crank axis (`radius`), or milled along a line (`distance`, `direction`).",
    keys: &[
        key(
            "face",
            Kind::Choice(&["front", "rear"]),
            Required,
            "Face that it is on; the front is towards the free end.",
            "\"rear\"",
        ),
        key(
            "angle",
            Kind::Quantity(Angle, Positive),
            Required,
            "Angle of its surface against the face, less than 90 deg.",
            "\"45 deg\"",
        ),
        quantity(
            "radius",
            Length,
            Positive,
            "Turned: where it leaves the face, from the crank axis.",
            "\"70 mm\"",
        ),
        quantity(
            "distance",
            Length,
            Positive,
            "Milled: where it leaves the face, from the crank axis along `direction`.",
            "\"65 mm\"",
        ),
        quantity(
            "direction",
            Angle,
            Any,
            "Milled: direction in which it gets deeper, from x towards y.",
            "\"20 deg\"",
        ),
    ],
};
