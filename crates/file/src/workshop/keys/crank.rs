//! The keys of a sheet that are about a crank with its bobweights, and about weights outside and slugs inside.

use crate::schema::Bound::{Any, NotNegative, Positive};
use crate::schema::Need::{Optional, Required};
use crate::schema::{Key, Kind, Table, key, quantity};
use lanchester_units::Dimension::{Angle, Density, Length, Mass, Unbalance};

/// Most pins of a crank, and most rods on one of them.
pub(super) const MOST_PINS: usize = 64;
const MOST_RODS: usize = 32;

pub(super) static BOBWEIGHT: Table = Table {
    header: "[bobweight]",
    doc: "What bobweights are made up for. Parts stand in [parts] and [[pin]].",
    keys: &[
        key(
            "rotating_share",
            Kind::Share,
            Optional,
            "Share of the rotating masses that is balanced; default 100 %.",
            "\"100 %\"",
        ),
        key(
            "reciprocating_share",
            Kind::Share,
            Optional,
            "Share of the reciprocating masses that is balanced; default the share with the smallest first order.",
            "\"50 %\"",
        ),
        quantity(
            "bank_angle",
            Angle,
            NotNegative,
            "Bank angle of a V, to derive the share from.",
            "\"90 deg\"",
        ),
        quantity(
            "split_angle",
            Angle,
            Any,
            "How far the pin of bank 2 stands ahead of that of bank 1; default 0, a shared pin. Needs `bank_angle`.",
            "\"-30 deg\"",
        ),
        key(
            "pins",
            Kind::Whole(1, MOST_PINS as i64),
            Optional,
            "Number of crankpins, where they are all alike and have no [[pin]]; default 1.",
            "4",
        ),
        key(
            "rods",
            Kind::Whole(1, MOST_RODS as i64),
            Optional,
            "Number of rods on each pin; default 1.",
            "2",
        ),
        quantity("oil", Mass, NotNegative, "Oil that turns with each pin; default 0.", "\"4 g\""),
    ],
};

const PART_KEYS: &[Key] = &[
    quantity("big_end", Mass, Positive, "Big end of one rod.", "\"460 g\""),
    quantity(
        "bearing",
        Mass,
        NotNegative,
        "Both shells of its bearing, if they were not weighed with it; default 0.",
        "\"45 g\"",
    ),
    quantity("small_end", Mass, Positive, "Small end of the rod.", "\"170 g\""),
    quantity("piston", Mass, Positive, "Piston alone.", "\"560 g\""),
    quantity("piston_pin", Mass, NotNegative, "Piston pin; default 0.", "\"145 g\""),
    quantity("rings", Mass, NotNegative, "All rings of the piston; default 0.", "\"52 g\""),
    quantity("locks", Mass, NotNegative, "All locks or clips of the piston pin; default 0.", "\"4 g\""),
];

pub(super) static PARTS: Table =
    Table { header: "[parts]", doc: "Weighed parts of one cylinder, for all cylinders.", keys: PART_KEYS };

static PIN_CYLINDER: Table = Table {
    header: "[[pin.cylinder]]",
    doc: "Weighed parts of one rod of the pin; what is not given comes from [parts].",
    keys: PART_KEYS,
};

pub(super) static PIN: Table = Table {
    header: "[[pin]]",
    doc: "A crankpin, where they are not all alike.",
    keys: &[
        key("name", Kind::Text(200), Optional, "Its name; default \"pin\" and its place.", "\"pin 1\""),
        key(
            "throw",
            Kind::Whole(1, MOST_PINS as i64),
            Optional,
            "Number of its throw in the engine file; default its place. Needs `engine`.",
            "1",
        ),
        key(
            "rods",
            Kind::Whole(1, MOST_RODS as i64),
            Optional,
            "Number of its rods, all as in [parts]; default as in [bobweight].",
            "2",
        ),
        quantity("oil", Mass, NotNegative, "Oil that turns with it; default as in [bobweight].", "\"4 g\""),
        key(
            "cylinder",
            Kind::Tables(&PIN_CYLINDER, MOST_RODS),
            Optional,
            "Its rods one by one.",
            "[{ piston = \"561 g\" }]",
        ),
    ],
};

pub(super) static EXTERNAL: Table = Table {
    header: "[[external]]",
    doc: "A weight outside the crankcase that is to come off: on the damper, the flywheel.",
    keys: &[
        key("name", Kind::Text(200), Required, "What carries it.", "\"damper\""),
        quantity("z", Length, Any, "Where along the shaft; needed.", "\"-250 mm\""),
        quantity("unbalance", Unbalance, NotNegative, "Mass times radius.", "\"28 oz in\""),
        quantity("mass", Mass, NotNegative, "Its mass, instead of `unbalance`; needs `radius`.", "\"180 g\""),
        quantity(
            "radius",
            Length,
            Positive,
            "Distance of its centre of gravity from the shaft's axis.",
            "\"75 mm\"",
        ),
        quantity(
            "angle",
            Angle,
            Any,
            "Where its heavy side stands on the rotor; needed. A hole is heavy on the other side.",
            "\"135 deg\"",
        ),
    ],
};

pub(super) static SLUG: Table = Table {
    header: "[slug]",
    doc: "Heavy-metal slugs that may be set into the counterweights at the [[plane]]s, axes parallel to the shaft, on the \
          radius of the plane.",
    keys: &[
        quantity("diameter", Length, Positive, "Diameter; needed.", "\"25.4 mm\""),
        quantity(
            "longest",
            Length,
            Positive,
            "Longest slug: thickness of the counterweight; needed.",
            "\"22 mm\"",
        ),
        quantity("density", Density, Positive, "Density of the slug; needed.", "\"17 g/cm3\""),
        quantity(
            "crank_density",
            Density,
            Positive,
            "Density of the crank; default 7.85 g/cm3, steel.",
            "\"7.2 g/cm3\"",
        ),
        quantity(
            "land",
            Length,
            NotNegative,
            "Least metal between holes, and between a hole and the rim; default 3 mm.",
            "\"3 mm\"",
        ),
        quantity("rim", Length, Positive, "Outer radius of the counterweight; needed.", "\"95 mm\""),
        quantity(
            "sector",
            Angle,
            NotNegative,
            "Angle between the outermost slugs that a counterweight has room for; default 90 deg.",
            "\"110 deg\"",
        ),
    ],
};
