//! Weights, balance shafts, mounts.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{MOST_CRANKSHAFTS, MOST_THROWS, MOST_WEIGHTS, key, quantity};
use super::part::SHAPE;
use super::shaft_part::SHAFT_WEIGHT_SHAPE;
use lanchester_units::Dimension::{Angle, Density, Inertia, Length, Mass, Unbalance};

pub(super) static COUNTERWEIGHTS: Table = Table {
    header: "[counterweights]",
    doc: "Short form: one weight opposite every throw, or half of it on each of its webs.",
    keys: &[
        key(
            "rotating_share",
            Kind::Share,
            Optional,
            "Share of the throw's own unbalance and the big ends of its rods that is balanced; default 0.",
            "\"100 %\"",
        ),
        key(
            "reciprocating_share",
            Kind::Share,
            Optional,
            "Share of the reciprocating masses of the throw's cylinders, at the crank radius; default 0.",
            "\"50 %\"",
        ),
        key(
            "at",
            Kind::Choice(&["throws", "webs"]),
            Optional,
            "In the planes of the throws (default), or half on each web (needs `web_distance`).",
            "\"webs\"",
        ),
    ],
};

const WEIGHT_UNBALANCE: Key =
    quantity("unbalance", Unbalance, NotNegative, "Mass times radius.", "\"0.0205 kg m\"");
const WEIGHT_MASS: Key =
    quantity("mass", Mass, NotNegative, "With `radius`, instead of `unbalance`.", "\"0.41 kg\"");
const WEIGHT_RADIUS: Key =
    quantity("radius", Length, NotNegative, "Distance of its centre of gravity from the axis.", "\"50 mm\"");

pub(super) static COUNTERWEIGHT: Table = Table {
    header: "[[counterweight]]",
    doc: "A weight on a crankshaft: at a throw, on a web, or anywhere along z.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name in tables.", "\"flywheel\""),
        key("throw", Kind::Whole(1, MOST_THROWS), Optional, "In the plane of this throw.", "1"),
        key(
            "web",
            Kind::Whole(1, 2 * MOST_THROWS),
            Optional,
            "On this web: webs 1 and 2 belong to throw 1, 3 and 4 to throw 2, and so on.",
            "1",
        ),
        quantity("z", Length, Any, "In this plane.", "\"10 mm\""),
        key(
            "crankshaft",
            Kind::Whole(1, MOST_CRANKSHAFTS),
            Optional,
            "With `z`: number of the crankshaft; default 1.",
            "1",
        ),
        WEIGHT_UNBALANCE,
        WEIGHT_MASS,
        WEIGHT_RADIUS,
        quantity(
            "angle",
            Angle,
            Any,
            "Direction: at a throw or on a web from the throw, default 180 deg; with `z` from the crankshaft's zero, \
             default 0 deg.",
            "\"180 deg\"",
        ),
        key(
            "shape",
            Kind::Table(&SHAPE),
            Optional,
            "The part that it is: plane, unbalance and direction are then those of the part, whose own x points along `angle`; \
             `unbalance` is what it should have, and a warning tells a miss of more than 1 %.",
            "{ thickness = \"20 mm\" }",
        ),
    ],
};

pub(super) static SHAFT: Table = Table {
    header: "[[shaft]]",
    doc: "A balance shaft: weights on an axis parallel to the crankshaft.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name in tables.", "\"left\""),
        key(
            "ratio",
            Kind::Ratio,
            Required,
            "Speed over that of crankshaft 1; negative turns the other way.",
            "-1",
        ),
        quantity("x", Length, Any, "Place of its axis; default 0.", "\"0 mm\""),
        quantity("y", Length, Any, "Place of its axis; default 0.", "\"100 mm\""),
        quantity(
            "inertia",
            Inertia,
            NotNegative,
            "Its polar moment of inertia about its axis: counts in torque and cyclic speed fluctuation, in the roll of the block and in runs in time.",
            "\"0.0008 kg m2\"",
        ),
        key(
            "weights",
            Kind::Tables(&SHAFT_WEIGHT, MOST_WEIGHTS),
            Required,
            "Its weights.",
            "[{ z = \"0 mm\", unbalance = \"0.01 kg m\", phase = \"180 deg\" }]",
        ),
    ],
};

pub(super) static GEAR: Table = Table {
    header: "[[gear]]",
    doc: "A balanced wheel that turns with the crank: a gear, a pulley, a sprocket. Its inertia counts in torque and cyclic speed fluctuation (times the ratio squared), \
          in the roll of the block (times the ratio) and in runs in time. It is a number, or follows from a disc of this diameter and width.",
    keys: &[
        key(
            "name",
            Kind::Text(100),
            Optional,
            "Its name in tables; default \"gear 1\".",
            "\"camshaft gear\"",
        ),
        key(
            "ratio",
            Kind::Ratio,
            Required,
            "Speed over that of crankshaft 1; negative turns the other way; 1 for what is fixed to it.",
            "\"-1/2\"",
        ),
        quantity("x", Length, Any, "Place of its axis; default 0.", "\"80 mm\""),
        quantity("y", Length, Any, "Place of its axis; default 0.", "\"0 mm\""),
        quantity(
            "inertia",
            Inertia,
            NotNegative,
            "Moment of inertia about its axis, with what turns with it.",
            "\"0.0006 kg m2\"",
        ),
        quantity(
            "diameter",
            Length,
            Positive,
            "Instead of `inertia`: diameter, of a gear that of its pitch circle.",
            "\"120 mm\"",
        ),
        quantity("width", Length, Positive, "Width along its axis.", "\"18 mm\""),
        quantity("density", Density, Positive, "Its density.", "\"7850 kg/m3\""),
        quantity("bore", Length, NotNegative, "Diameter of its bore; default none.", "\"30 mm\""),
    ],
};

pub(super) static SHAFT_WEIGHT: Table = Table {
    header: "[[shaft.weights]]",
    doc: "A weight on a balance shaft.",
    keys: &[
        key("z", Kind::Quantity(Length, Any), Required, "Its plane.", "\"0 mm\""),
        WEIGHT_UNBALANCE,
        WEIGHT_MASS,
        WEIGHT_RADIUS,
        quantity("phase", Angle, Any, "Direction when throw 1 points along +x; default 0.", "\"180 deg\""),
        key(
            "shape",
            Kind::Table(&SHAFT_WEIGHT_SHAPE),
            Optional,
            "The part that it is: its unbalance is then that of the part; `unbalance` is what it should have, and a warning tells a miss of more than 1 %.",
            "{ radius = \"36 mm\", length = \"40 mm\" }",
        ),
    ],
};
