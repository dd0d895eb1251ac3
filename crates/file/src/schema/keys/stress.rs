//! Stress of the crankshafts: `[crank.mesh]`, `[stress]` and `[[stress.case]]`.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{MOST_CRANKSHAFTS, MOST_THROWS, key, quantity};
use lanchester_units::Dimension::{Angle, Force, Length, Pressure, Speed, Stiffness};

/// Most cases of a file.
const MOST_CASES: usize = 256;

pub(super) static CRANK_MESH: Table = Table {
    header: "[crank.mesh]",
    doc: "How the crankshafts are meshed for stress and natural modes where the command does not say so.",
    keys: &[
        quantity(
            "size",
            Length,
            Positive,
            "Edge of the elements away from fillets, between 0.1 mm and 1 m; default 8 mm.",
            "\"8 mm\"",
        ),
        key(
            "fillet_elements",
            Kind::Whole(2, 40),
            Optional,
            "Elements across the 90 deg of a fillet, an even number; default 6 for stress, or as many as 220 000 nodes leave room for, 2 for frequencies and stiffness.",
            "6",
        ),
        key(
            "file",
            Kind::Text(500),
            Optional,
            "A mesh of your own instead, as a CalculiX deck (N, mm, tonne, s) beside this file, with node sets PIN_1 and so on, MAIN_1 and so on, and FLYWHEEL; of crankshaft 1 alone.",
            "\"crank.inp\"",
        ),
    ],
};

pub(super) static STRESS: Table = Table {
    header: "[stress]",
    doc: "Static cases of the crankshafts beside those that the program makes itself.",
    keys: &[key(
        "case",
        Kind::Tables(&STRESS_CASE, MOST_CASES),
        Optional,
        "Static cases by name.",
        "[{ name = \"unit radial\", pin = 1, radial = \"-65 kN\" }]",
    )],
};

const PIN: Key = key(
    "pin",
    Kind::Whole(1, MOST_THROWS),
    Optional,
    "Number of the crankpin that a force acts on, as the throws are counted.",
    "1",
);
const RADIAL: Key = quantity(
    "radial",
    Force,
    Any,
    "Force on the pin along the throw, positive away from the crank axis; default 0.",
    "\"-65 kN\"",
);
const TANGENTIAL: Key = quantity(
    "tangential",
    Force,
    Any,
    "Force on the pin across the throw, positive where it drives the crankshaft; default 0.",
    "\"10.7 kN\"",
);

static STRESS_CASE: Table = Table {
    header: "[[stress.case]]",
    doc: "A static case: forces on pins, or gas and inertia at a crank angle, and what holds the crankshaft.",
    keys: &[
        key("name", Kind::Text(100), Required, "Its name; capitals do not count.", "\"unit radial\""),
        PIN,
        RADIAL,
        TANGENTIAL,
        key(
            "force",
            Kind::Tables(&STRESS_FORCE, MOST_THROWS as usize),
            Optional,
            "Forces on several pins instead of `pin`, `radial` and `tangential`.",
            "[{ pin = 1, radial = \"-65 kN\" }, { pin = 2, radial = \"12 kN\" }]",
        ),
        quantity(
            "angle",
            Angle,
            Any,
            "Crank angle at which gas and inertia load the crankshaft; beside forces the one at which springs with two stiffnesses hold.",
            "\"7 deg\"",
        ),
        quantity(
            "speed",
            Speed,
            NotNegative,
            "Speed of crankshaft 1, whose centrifugal field acts; default with forces none, with an angle the lowest and the highest speed of the file.",
            "\"4000 rpm\"",
        ),
        key(
            "crankshaft",
            Kind::Whole(1, MOST_CRANKSHAFTS),
            Optional,
            "Number of the crankshaft of a case without forces; default 1. With forces it is that of their pins.",
            "1",
        ),
        key(
            "support",
            Kind::Choice(&["clamped-ends", "journals", "rings", "springs", "film", "free"]),
            Optional,
            "What holds it: both end faces clamped; the mean of each journal's surface; rings with contact around journals and loaded pins; a spring at each journal; \
             the oil films of the main bearings, in which it rests; nothing (loads balanced by inertia). Default journals.",
            "\"clamped-ends\"",
        ),
        key(
            "stiffness",
            Kind::ValuesOrTables(&STRESS_STIFFNESS, MOST_THROWS as usize + 1),
            Optional,
            "Of springs: one entry for all journals, or one for each from the free end on.",
            "[\"500 N/um\", { x = \"500 N/um\", y = \"300 N/um\" }]",
        ),
        quantity(
            "ring_thickness",
            Length,
            Positive,
            "Of rings: outer less inner radius; default 5 mm.",
            "\"5 mm\"",
        ),
        quantity(
            "ring_modulus",
            Pressure,
            Positive,
            "Of rings: Young's modulus; default 210 GPa.",
            "\"210 GPa\"",
        ),
    ],
};

static STRESS_FORCE: Table = Table {
    header: "[[stress.case.force]]",
    doc: "A force on a crankpin.",
    keys: &[Key { need: Required, ..PIN }, RADIAL, TANGENTIAL],
};

static STRESS_STIFFNESS: Table = Table {
    header: "[[stress.case.stiffness]]",
    doc: "Stiffness of the spring at a journal; without `y` its value may stand alone.",
    keys: &[
        Key {
            need: Required,
            ..quantity(
                "x",
                Stiffness,
                NotNegative,
                "Along x of the block, which is up; 0 does not hold.",
                "\"500 N/um\"",
            )
        },
        quantity("y", Stiffness, NotNegative, "Along y of the block; default that along x.", "\"300 N/um\""),
    ],
};
