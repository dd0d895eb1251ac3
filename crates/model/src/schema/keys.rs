//! The keys of the engine file, table by table.

use super::Bound::{Any, NotNegative, Positive};
use super::Need::{Optional, Required};
use super::{Bound, Key, Kind, Need, Table};
use crate::quantity::Dimension::{self, Angle, Inertia, Length, Mass, Speed, Unbalance};

/// Counts above which a file is refused, so that nothing explodes.
const MOST_CYLINDERS: i64 = 64;
const MOST_THROWS: i64 = 64;
const MOST_CRANKSHAFTS: i64 = 8;
const MOST_WEIGHTS: usize = 256;
const MOST_SHAFTS: usize = 64;
const MOST_MOUNTS: usize = 64;

const fn key(name: &'static str, kind: Kind, need: Need, doc: &'static str, example: &'static str) -> Key {
    Key { name, kind, need, doc, example, layouts: &[] }
}

const fn quantity(
    name: &'static str,
    dimension: Dimension,
    bound: Bound,
    doc: &'static str,
    example: &'static str,
) -> Key {
    key(name, Kind::Quantity(dimension, bound), Optional, doc, example)
}

const fn for_layouts(layouts: &'static [&'static str], key: Key) -> Key {
    Key { layouts, ..key }
}

/// The whole file.
pub(crate) static FILE: Table = Table {
    header: "",
    doc: "An engine file holds these keys and tables. Every quantity is a text with its unit.",
    keys: &[
        key("version", Kind::WholeChoice(&[1]), Optional, "Version of the file format.", "1"),
        key("name", Kind::Text(200), Required, "What the engine is called.", "\"Four in line\""),
        key(
            "note",
            Kind::Text(10_000),
            Optional,
            "Where the data come from.",
            "\"workshop manual, page 12\"",
        ),
        key("strokes", Kind::WholeChoice(&[2, 4]), Optional, "Strokes in a working cycle; default 4.", "4"),
        key(
            "rotation",
            Kind::Choice(&["clockwise", "reverse"]),
            Optional,
            "Sense of rotation seen from the free end with x up; default clockwise. Reverse mirrors y.",
            "\"clockwise\"",
        ),
        key(
            "speed",
            Kind::QuantityOrPair(Speed, Positive),
            Required,
            "Speed of crankshaft 1, or a list of the lowest and the highest.",
            "[\"800 rpm\", \"4000 rpm\"]",
        ),
        quantity(
            "origin",
            Length,
            Any,
            "Place along the crank, in the z of this file, of the reference plane; default midway between the first \
             and the last throw plane.",
            "\"0 mm\"",
        ),
        key("firing", Kind::Table(&FIRING), Optional, "When the cylinders fire.", "{ order = [1, 3, 4, 2] }"),
        key(
            "layout",
            Kind::Table(&LAYOUT),
            Optional,
            "Short form of the throws and cylinders.",
            "{ type = \"in-line\" }",
        ),
        key("crank", Kind::Table(&CRANK), Optional, "What holds for all throws.", "{ stroke = \"95.5 mm\" }"),
        key("piston", Kind::Table(&PISTON), Optional, "What holds for all pistons.", "{ mass = \"0.5 kg\" }"),
        key(
            "rod",
            Kind::Table(&ROD),
            Optional,
            "What holds for all connecting rods.",
            "{ length = \"144 mm\" }",
        ),
        key(
            "articulated_rod",
            Kind::Table(&ARTICULATED_ROD),
            Optional,
            "What holds for all rods that sit on a master rod.",
            "{ length = \"120 mm\" }",
        ),
        key(
            "cylinders",
            Kind::Table(&CYLINDERS),
            Optional,
            "What holds for all cylinders.",
            "{ offset = \"12 mm\" }",
        ),
        key(
            "cylinder",
            Kind::Tables(&CYLINDER, MOST_CYLINDERS as usize),
            Optional,
            "The cylinders one by one; with a layout, what differs for one of them.",
            "[{ number = 2 }]",
        ),
        key(
            "counterweights",
            Kind::Table(&COUNTERWEIGHTS),
            Optional,
            "Short form: one weight opposite every throw.",
            "{ rotating_share = \"100 %\" }",
        ),
        key(
            "counterweight",
            Kind::Tables(&COUNTERWEIGHT, MOST_WEIGHTS),
            Optional,
            "Weights on the crankshafts, one by one.",
            "[{ web = 1, unbalance = \"0.02 kg m\" }]",
        ),
        key(
            "shaft",
            Kind::Tables(&SHAFT, MOST_SHAFTS),
            Optional,
            "Balance shafts.",
            "[{ ratio = -1, weights = [] }]",
        ),
        key("mount", Kind::Tables(&MOUNT, MOST_MOUNTS), Optional, "Engine mounts.", "[{ name = \"front\" }]"),
        key(
            "crankshaft",
            Kind::Tables(&CRANKSHAFT, MOST_CRANKSHAFTS as usize),
            Optional,
            "Geared crankshafts; needed only if there is more than one, or to name it.",
            "[{ name = \"inlet\" }]",
        ),
        key(
            "throw",
            Kind::Tables(&THROW, MOST_THROWS as usize),
            Optional,
            "The throws one by one (general form).",
            "[{ angle = \"0 deg\", z = \"-44 mm\" }]",
        ),
    ],
};

static FIRING: Table = Table {
    header: "[firing]",
    doc: "When the cylinders fire: an order or the angles themselves.",
    keys: &[
        key(
            "order",
            Kind::Wholes(1, MOST_CYLINDERS),
            Optional,
            "Numbers of the cylinders in the order in which they fire.",
            "[1, 3, 4, 2]",
        ),
        key(
            "angles",
            Kind::Quantities(Angle, Any),
            Optional,
            "For each cylinder the crank angle at which it fires, counted from the firing of cylinder 1.",
            "[\"0 deg\", \"180 deg\"]",
        ),
    ],
};

const BANKED: &[&str] = &["v", "boxer", "flat", "w"];
const SHARED: &[&str] = &["v", "flat", "w"];
const NOT_RADIAL: &[&str] = &["in-line", "v", "boxer", "flat", "vr", "w"];

static LAYOUT: Table = Table {
    header: "[layout]",
    doc: "Short form of a common layout, instead of `[[throw]]` and `[[cylinder]]`.",
    keys: &[
        key(
            "type",
            Kind::Choice(&["in-line", "v", "boxer", "flat", "vr", "w", "radial"]),
            Required,
            "Which layout it is.",
            "\"in-line\"",
        ),
        key(
            "cylinders",
            Kind::Whole(1, MOST_CYLINDERS),
            Required,
            "Number of cylinders; of a radial, in each row.",
            "4",
        ),
        for_layouts(
            NOT_RADIAL,
            quantity(
                "spacing",
                Length,
                Positive,
                "Distance between neighbouring cylinders of a bank (in-line), between the planes of neighbouring \
                 pairs or groups (v, boxer, flat, w), between successive cylinders along the crank (vr).",
                "\"88 mm\"",
            ),
        ),
        for_layouts(
            NOT_RADIAL,
            key(
                "positions",
                Kind::Quantities(Length, Any),
                Optional,
                "Instead of `spacing`: z of each of these planes, rising.",
                "[\"-150 mm\", \"-50 mm\", \"50 mm\", \"150 mm\"]",
            ),
        ),
        key(
            "crank_angles",
            Kind::Quantities(Angle, Any),
            Optional,
            "Direction of each throw, the first 0 deg: one for each cylinder (in-line, vr, separate pins), pin \
             (shared pins), pair (split pins and boxer: its first pin) or row (radial). Default: from the firing \
             order with even intervals.",
            "[\"0 deg\", \"180 deg\", \"180 deg\", \"0 deg\"]",
        ),
        key(
            "crank_phase",
            Kind::Quantity(Angle, Any),
            Optional,
            "Instead of `crank_angles`: crank angle between the throws of cylinders that follow in the firing order.",
            "\"120 deg\"",
        ),
        for_layouts(
            BANKED,
            key(
                "numbering",
                Kind::Choice(&["by-bank", "alternating"]),
                Optional,
                "Cylinder numbers run along bank 1 first (default), or alternate between the banks.",
                "\"by-bank\"",
            ),
        ),
        for_layouts(
            BANKED,
            quantity(
                "bank_stagger",
                Length,
                Any,
                "Distance along z between the banks' cylinders of a pair, bank 1 towards the free end; default 0.",
                "\"20 mm\"",
            ),
        ),
        for_layouts(
            &["v", "vr"],
            quantity(
                "bank_angle",
                Angle,
                Positive,
                "Angle between the banks: bank 1 stands at minus half of it, bank 2 at plus half.",
                "\"60 deg\"",
            ),
        ),
        for_layouts(
            &["vr"],
            quantity(
                "bank_offset",
                Length,
                NotNegative,
                "Distance at which the cylinder axes pass the crank axis; they cross below it, on the side away from \
                 the heads.",
                "\"12.5 mm\"",
            ),
        ),
        for_layouts(
            SHARED,
            key(
                "pins",
                Kind::Choice(&["shared", "split", "separate"]),
                Optional,
                "Crankpins of a pair or group: one for all (default), one each side by side with `split_angle` \
                 between them (v), or a throw for every cylinder.",
                "\"shared\"",
            ),
        ),
        for_layouts(
            &["v"],
            quantity(
                "split_angle",
                Angle,
                Any,
                "With split pins: direction of bank 2's pin from bank 1's pin.",
                "\"30 deg\"",
            ),
        ),
        for_layouts(
            &["v", "flat", "radial"],
            key(
                "rods",
                Kind::Choice(&["side-by-side", "fork-and-blade", "articulated"]),
                Optional,
                "How rods share a pin: side by side (default but for radial), fork and blade (v, flat), or on a master \
                 rod (v, flat; default of radial).",
                "\"side-by-side\"",
            ),
        ),
        for_layouts(
            &["w"],
            key(
                "banks",
                Kind::Tables(&BANK, 8),
                Optional,
                "The banks, each with its angle.",
                "[{ angle = \"-60 deg\" }, { angle = \"0 deg\" }, { angle = \"60 deg\" }]",
            ),
        ),
        for_layouts(
            &["radial"],
            key("rows", Kind::Whole(1, 16), Optional, "Number of rows; default 1.", "2"),
        ),
        for_layouts(
            &["radial"],
            quantity("row_spacing", Length, Positive, "Distance between neighbouring rows.", "\"180 mm\""),
        ),
        for_layouts(
            &["radial"],
            key(
                "row_angles",
                Kind::Quantities(Angle, Any),
                Optional,
                "Turn of each row as a whole; default 0.",
                "[\"0 deg\", \"20 deg\"]",
            ),
        ),
        for_layouts(
            &["radial"],
            key(
                "master",
                Kind::Whole(1, MOST_CYLINDERS),
                Optional,
                "Number, within each row, of the cylinder with the master rod; default 1.",
                "1",
            ),
        ),
        for_layouts(
            &["radial"],
            quantity(
                "knuckle_radius",
                Length,
                Positive,
                "Distance of the knuckle pins from the crankpin.",
                "\"60 mm\"",
            ),
        ),
        for_layouts(
            &["radial"],
            key(
                "knuckle_angles",
                Kind::Quantities(Angle, Any),
                Optional,
                "Direction of the knuckle pin of each cylinder of a row but the master's, in the order of their \
                 numbers, from the master rod's line; default: the angle between the cylinders.",
                "[\"72 deg\", \"144 deg\", \"216 deg\", \"288 deg\"]",
            ),
        ),
    ],
};

static BANK: Table = Table {
    header: "[[layout.banks]]",
    doc: "A bank of a W engine.",
    keys: &[
        key("angle", Kind::Quantity(Angle, Any), Required, "Direction of its cylinder axes.", "\"-60 deg\""),
        quantity(
            "offset",
            Length,
            Any,
            "Offset of its cylinder axes from the crank axis; default 0.",
            "\"0 mm\"",
        ),
    ],
};

static CRANK: Table = Table {
    header: "[crank]",
    doc: "What holds for all throws. Without `unbalance` or masses the crank itself is balanced.",
    keys: &[STROKE, RADIUS, THROW_UNBALANCE, PIN_MASS, WEB_MASS, WEB_RADIUS, WEB_DISTANCE],
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

static PISTON: Table = Table {
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

static ROD: Table = Table {
    header: "[rod]",
    doc: "What holds for all connecting rods.",
    keys: &[ROD_LENGTH, ROD_MASS, BIG_END_MASS, SMALL_END_MASS, CENTRE_OF_GRAVITY, INERTIA],
};

static ARTICULATED_ROD: Table = Table {
    header: "[articulated_rod]",
    doc: "What holds for all rods that sit on a master rod.",
    keys: &[
        ROD_LENGTH,
        ROD_MASS,
        BIG_END_MASS,
        SMALL_END_MASS,
        CENTRE_OF_GRAVITY,
        INERTIA,
        KNUCKLE_RADIUS,
        KNUCKLE_ANGLE,
    ],
};

static CYLINDER_ROD: Table = Table {
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
        KNUCKLE_RADIUS,
        KNUCKLE_ANGLE,
    ],
};

static CYLINDER_PISTON: Table = Table {
    header: "[cylinder.piston]",
    doc: "The piston of one cylinder. Keys not given come from `[piston]`.",
    keys: PISTON.keys,
};

static CYLINDERS: Table = Table {
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

static CYLINDER: Table = Table {
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
        key("piston", Kind::Table(&CYLINDER_PISTON), Optional, "Its piston.", "{ mass = \"0.78 kg\" }"),
        key("rod", Kind::Table(&CYLINDER_ROD), Optional, "Its rod.", "{ mass = \"0.63 kg\" }"),
    ],
};

static COUNTERWEIGHTS: Table = Table {
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

static COUNTERWEIGHT: Table = Table {
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
    ],
};

static SHAFT: Table = Table {
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
        key(
            "weights",
            Kind::Tables(&SHAFT_WEIGHT, MOST_WEIGHTS),
            Required,
            "Its weights.",
            "[{ z = \"0 mm\", unbalance = \"0.01 kg m\", phase = \"180 deg\" }]",
        ),
    ],
};

static SHAFT_WEIGHT: Table = Table {
    header: "[[shaft.weights]]",
    doc: "A weight on a balance shaft.",
    keys: &[
        key("z", Kind::Quantity(Length, Any), Required, "Its plane.", "\"0 mm\""),
        WEIGHT_UNBALANCE,
        WEIGHT_MASS,
        WEIGHT_RADIUS,
        quantity("phase", Angle, Any, "Direction when throw 1 points along +x; default 0.", "\"180 deg\""),
    ],
};

static MOUNT: Table = Table {
    header: "[[mount]]",
    doc: "An engine mount.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name in tables.", "\"front\""),
        key("x", Kind::Quantity(Length, Any), Required, "Position.", "\"0 mm\""),
        key("y", Kind::Quantity(Length, Any), Required, "Position.", "\"0 mm\""),
        key("z", Kind::Quantity(Length, Any), Required, "Position along the crank.", "\"-88 mm\""),
    ],
};

static CRANKSHAFT: Table = Table {
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
    ],
};

static THROW: Table = Table {
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
