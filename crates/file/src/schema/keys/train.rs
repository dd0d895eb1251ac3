//! The crank train: crankshafts, throws, pistons, rods, cylinders.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::crank_body::{CRANK_BODY, CRANK_MATERIAL};
use super::entry::{MOST_CRANKSHAFTS, MOST_CYLINDERS, MOST_THROWS, key, quantity};
use super::stress::CRANK_MESH;
use lanchester_units::Dimension::{Angle, Inertia, Length, Mass, Unbalance};

pub(super) static CRANK: Table = Table {
    header: "[crank]",
    doc: "What holds for all throws. Without `unbalance` or masses the crank itself is balanced.",
    keys: &[
        STROKE,
        RADIUS,
        THROW_UNBALANCE,
        PIN_MASS,
        WEB_MASS,
        WEB_RADIUS,
        WEB_DISTANCE,
        MAIN_POSITIONS,
        key(
            "body",
            Kind::Table(&CRANK_BODY),
            Optional,
            "Journals, pins and webs as bodies, instead of `unbalance` or masses, or beside them.",
            "{ density = \"7850 kg/m3\" }",
        ),
        key(
            "material",
            Kind::Table(&CRANK_MATERIAL),
            Optional,
            "What the crankshafts are made of: elasticity, strength, damping.",
            "{ preset = \"42CrMo4 quenched and tempered\" }",
        ),
        key(
            "mesh",
            Kind::Table(&CRANK_MESH),
            Optional,
            "How the crankshafts are meshed for stress and natural modes.",
            "{ size = \"8 mm\" }",
        ),
    ],
};

const STROKE: Key = quantity("stroke", Length, Positive, "Twice the crank radius.", "\"95.5 mm\"");
const RADIUS: Key =
    quantity("radius", Length, Positive, "Crank radius, instead of `stroke`.", "\"47.75 mm\"");
const THROW_UNBALANCE: Key = quantity(
    "unbalance",
    Unbalance,
    Any,
    "Unbalance of the crank itself along the throw: pin and webs, no rod, no counterweight.",
    "\"0.01 kg m\"",
);
const PIN_MASS: Key = quantity(
    "pin_mass",
    Mass,
    NotNegative,
    "Instead of `unbalance`: mass at the crank radius.",
    "\"0.5 kg\"",
);
const WEB_MASS: Key =
    quantity("web_mass", Mass, NotNegative, "Mass of each of the throw's two webs.", "\"0.8 kg\"");
const WEB_RADIUS: Key = quantity(
    "web_radius",
    Length,
    Any,
    "Centre of gravity of a web along the throw; negative on the other side.",
    "\"12 mm\"",
);
const WEB_DISTANCE: Key = quantity(
    "web_distance",
    Length,
    Positive,
    "Distance between the middle planes of the two webs; needed for weights on webs.",
    "\"44 mm\"",
);
const MAIN_POSITIONS: Key = key(
    "main_positions",
    Kind::Quantities(Length, Any),
    Optional,
    "Planes of the main bearings in the z of this file, rising; default midway between the throws and as far beyond the \
     ends, throws with no room for a main between them counted as one.",
    "[\"-90 mm\", \"0 mm\", \"90 mm\"]",
);

pub(super) static PISTON: Table = Table {
    header: "[piston]",
    doc: "What holds for all pistons.",
    keys: &[
        quantity(
            "mass",
            Mass,
            NotNegative,
            "Mass of the piston with pin, rings and clips. Needed for every cylinder.",
            "\"0.7754 kg\"",
        ),
        BORE,
        PIN_OFFSET,
    ],
};

const BORE: Key = quantity("bore", Length, Positive, "Bore.", "\"79.5 mm\"");
const PIN_OFFSET: Key = quantity(
    "pin_offset",
    Length,
    Any,
    "Offset of the piston pin from the cylinder axis along +v; default 0.",
    "\"1 mm\"",
);

const ROD_LENGTH: Key = quantity(
    "length",
    Length,
    Positive,
    "Distance between eye centres. Needed for every cylinder.",
    "\"144 mm\"",
);
const ROD_MASS: Key = quantity(
    "mass",
    Mass,
    NotNegative,
    "Mass of the whole rod; alone: two thirds at the big end, one third at the small end.",
    "\"0.6287 kg\"",
);
const BIG_END_MASS: Key =
    quantity("big_end_mass", Mass, NotNegative, "Weighed mass of the big end.", "\"0.42 kg\"");
const SMALL_END_MASS: Key =
    quantity("small_end_mass", Mass, NotNegative, "Weighed mass of the small end.", "\"0.21 kg\"");
const CENTRE_OF_GRAVITY: Key = quantity(
    "centre_of_gravity",
    Length,
    NotNegative,
    "With `mass`: distance of the centre of gravity from the big-end eye.",
    "\"48 mm\"",
);
const INERTIA: Key = quantity(
    "inertia",
    Inertia,
    NotNegative,
    "Moment of inertia about the rod's centre of gravity; needs weighed ends or `centre_of_gravity`.",
    "\"2000 kg mm2\"",
);
const AXIAL_INERTIA: Key = quantity(
    "axial_inertia",
    Inertia,
    NotNegative,
    "Moment of inertia along the line of the eyes, which a run in time feels where the block turns; default 0, a slender rod.",
    "\"100 kg mm2\"",
);
const KNUCKLE_RADIUS: Key = quantity(
    "knuckle_radius",
    Length,
    Positive,
    "Distance of the knuckle pin from the crankpin (articulated rods).",
    "\"60 mm\"",
);
const KNUCKLE_ANGLE: Key = quantity(
    "knuckle_angle",
    Angle,
    Any,
    "Direction of the knuckle pin from the crankpin, from the master rod's line (articulated rods).",
    "\"60 deg\"",
);

pub(super) static ROD: Table = Table {
    header: "[rod]",
    doc: "What holds for all connecting rods.",
    keys: &[ROD_LENGTH, ROD_MASS, BIG_END_MASS, SMALL_END_MASS, CENTRE_OF_GRAVITY, INERTIA, AXIAL_INERTIA],
};

pub(super) static ARTICULATED_ROD: Table = Table {
    header: "[articulated_rod]",
    doc: "What holds for all rods that sit on a master rod.",
    keys: &[
        ROD_LENGTH,
        ROD_MASS,
        BIG_END_MASS,
        SMALL_END_MASS,
        CENTRE_OF_GRAVITY,
        INERTIA,
        AXIAL_INERTIA,
        KNUCKLE_RADIUS,
        KNUCKLE_ANGLE,
    ],
};

pub(super) static CYLINDER_ROD: Table = Table {
    header: "[cylinder.rod]",
    doc: "The rod of one cylinder. Keys not given come from `[rod]`, or from `[articulated_rod]`; masses given here \
          replace all masses and the inertia given there.",
    keys: &[
        key(
            "type",
            Kind::Choice(&["own", "side-by-side", "fork", "blade", "articulated"]),
            Optional,
            "What its big end sits on: a pin of its own (default), a pin shared side by side, fork or blade of a \
             pair, or a knuckle pin on a master rod.",
            "\"own\"",
        ),
        key(
            "master",
            Kind::Whole(1, MOST_CYLINDERS),
            Optional,
            "Articulated rods: number of the cylinder with the master rod.",
            "1",
        ),
        ROD_LENGTH,
        ROD_MASS,
        BIG_END_MASS,
        SMALL_END_MASS,
        CENTRE_OF_GRAVITY,
        INERTIA,
        AXIAL_INERTIA,
        KNUCKLE_RADIUS,
        KNUCKLE_ANGLE,
    ],
};

pub(super) static CYLINDER_PISTON: Table = Table {
    header: "[cylinder.piston]",
    doc: "The piston of one cylinder. Keys not given come from `[piston]`.",
    keys: PISTON.keys,
};

pub(super) static CYLINDERS: Table = Table {
    header: "[cylinders]",
    doc: "What holds for all cylinders.",
    keys: &[quantity(
        "offset",
        Length,
        Any,
        "Offset of the cylinder axes from the crank axis along +v; default 0.",
        "\"12 mm\"",
    )],
};

pub(super) static CYLINDER: Table = Table {
    header: "[[cylinder]]",
    doc: "A cylinder. With a layout: what differs for the cylinder of this number.",
    keys: &[
        key(
            "number",
            Kind::Whole(1, MOST_CYLINDERS),
            Optional,
            "Its number: with a layout, which cylinder is meant (needed); else its place in the file.",
            "2",
        ),
        key(
            "throw",
            Kind::Whole(1, MOST_THROWS),
            Optional,
            "Number of the throw that drives it (general form; an articulated rod takes its master's).",
            "1",
        ),
        quantity(
            "angle",
            Angle,
            Any,
            "Direction of its axis from +x towards +y (general form).",
            "\"0 deg\"",
        ),
        quantity("z", Length, Any, "Plane of its axis; default that of the throw.", "\"-44 mm\""),
        quantity(
            "offset",
            Length,
            Any,
            "Offset of its axis from the crank axis along +v; default from `[cylinders]`.",
            "\"0 mm\"",
        ),
        PIN_OFFSET,
        BORE,
        key(
            "chamber",
            Kind::Whole(1, MOST_CYLINDERS),
            Optional,
            "Opposed pistons, and others that share a combustion chamber: number of the first cylinder of the chamber, lower than its own. All of its pistons \
             have one pressure.",
            "1",
        ),
        key("piston", Kind::Table(&CYLINDER_PISTON), Optional, "Its piston.", "{ mass = \"0.78 kg\" }"),
        key("rod", Kind::Table(&CYLINDER_ROD), Optional, "Its rod.", "{ mass = \"0.63 kg\" }"),
    ],
};

pub(super) static CRANKSHAFT: Table = Table {
    header: "[[crankshaft]]",
    doc: "A crankshaft. The first is the reference: ratio 1, phase 0, on the z axis.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name in tables.", "\"inlet\""),
        key(
            "ratio",
            Kind::Ratio,
            Optional,
            "Speed over that of crankshaft 1; negative turns the other way. Needed but for the first.",
            "-1",
        ),
        quantity("phase", Angle, Any, "Its angle when throw 1 points along +x; default 0.", "\"12 deg\""),
        quantity("x", Length, Any, "Place of its axis; default 0.", "\"300 mm\""),
        quantity("y", Length, Any, "Place of its axis; default 0.", "\"0 mm\""),
        MAIN_POSITIONS,
    ],
};

pub(super) static THROW: Table = Table {
    header: "[[throw]]",
    doc: "A throw: one crankpin. Keys not given come from `[crank]`.",
    keys: &[
        key(
            "crankshaft",
            Kind::Whole(1, MOST_CRANKSHAFTS),
            Optional,
            "Number of its crankshaft; default 1.",
            "1",
        ),
        key(
            "angle",
            Kind::Quantity(Angle, Any),
            Required,
            "Direction on the crankshaft; throw 1 points along +x.",
            "\"180 deg\"",
        ),
        key("z", Kind::Quantity(Length, Any), Required, "Its plane.", "\"-44 mm\""),
        STROKE,
        RADIUS,
        THROW_UNBALANCE,
        PIN_MASS,
        WEB_MASS,
        WEB_RADIUS,
        WEB_DISTANCE,
    ],
};
