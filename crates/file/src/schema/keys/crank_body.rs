//! The crankshaft as a body.

use super::super::Bound::Any;
use super::super::Bound::{NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{MOST_CRANKSHAFTS, MOST_THROWS, key, quantity};
use lanchester_units::Dimension::{Angle, Density, Length, Pressure};

/// Most tables of elements of a kind, and of steps of nose or flange.
const MOST_ELEMENTS: usize = 2 * MOST_THROWS as usize + 1;
const MOST_STEPS: usize = 16;

pub(super) static CRANK_BODY: Table = Table {
    header: "[crank.body]",
    doc: "Journals, pins and webs as bodies, the same for all throws but for those with a table of their own. A web is the convex hull of two discs: one about the crank axis, one about the \
          crankpin. The unbalance of every throw follows: that of its pin and of its two plain webs. Every throw needs `web_distance`; the pin is as \
          long as it less `web_thickness`. Where it is the distance of two neighbouring throws or more, they have one web between their pins, as split \
          pins (a flying web) and boxers have: the convex hull of two discs of `pin_end_radius` about both pins, which fills what is between them. An \
          unbalance or masses given in `[crank]` or `[[throw]]` count instead of that of the body, in the plane of the throw, and must agree with it to 5 %; from 1 % on a warning says which counts.",
    keys: &[
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density of all of it, between 1000 and 23000 kg/m3.",
            "\"7850 kg/m3\"",
        ),
        length("journal_diameter", "Diameter of the main journals.", "\"54 mm\""),
        bore("journal_bore", "Diameter of a bore along the journals; default none.", "\"20 mm\""),
        length("pin_diameter", "Diameter of the crankpins.", "\"48 mm\""),
        bore("pin_bore", "Diameter of a bore along the pins, in their middle; default none.", "\"18 mm\""),
        length("web_thickness", "Thickness of the webs along the crank.", "\"18 mm\""),
        length(
            "web_radius",
            "Radius of a web's disc about the crank axis; the journal lies within it.",
            "\"38 mm\"",
        ),
        length(
            "pin_end_radius",
            "Radius of a web's round end about the crankpin; the pin lies within it.",
            "\"32 mm\"",
        ),
        key(
            "end_journals",
            Kind::QuantityOrPair(Length, Positive),
            Required,
            "Length of both end journals from the face of the web, or a list of the front and the rear one.",
            "[\"30 mm\", \"45 mm\"]",
        ),
        FILLET_OF_PINS,
        FILLET_OF_JOURNALS,
        quantity(
            "pin_recess",
            Length,
            NotNegative,
            "How deep the fillets of the pins are cut into the webs; default 0.",
            "\"0.5 mm\"",
        ),
        quantity(
            "journal_recess",
            Length,
            NotNegative,
            "How deep the fillets of the journals are cut into the webs; default 0.",
            "\"0.5 mm\"",
        ),
        OIL_HOLE_KEY,
        elements(
            "journal",
            &JOURNAL,
            "Journals that differ.",
            "[{ numbers = [3], diameter = \"60 mm\" }]",
            MOST_ELEMENTS,
        ),
        elements(
            "pin",
            &PIN,
            "Crankpins that differ.",
            "[{ numbers = [2], bore = \"20 mm\" }]",
            MOST_ELEMENTS,
        ),
        elements(
            "web",
            &WEB,
            "Webs that differ.",
            "[{ numbers = [1, 8], thickness = \"24 mm\" }]",
            MOST_ELEMENTS,
        ),
        elements(
            "nose",
            &NOSE,
            "Round steps before the first journal, from the free end on.",
            "[{ length = \"40 mm\", diameter = \"30 mm\" }]",
            MOST_STEPS,
        ),
        elements(
            "flange",
            &FLANGE,
            "Round steps behind the last journal, from it on.",
            "[{ length = \"12 mm\", diameter = \"110 mm\" }]",
            MOST_STEPS,
        ),
    ],
};

const FILLET_OF_PINS: Key = quantity(
    "pin_fillet",
    Length,
    NotNegative,
    "Radius of the fillets between pins and webs; 0 is a sharp corner. It adds no mass.",
    "\"3 mm\"",
);
const FILLET_OF_JOURNALS: Key = quantity(
    "journal_fillet",
    Length,
    NotNegative,
    "Radius of the fillets between journals and webs; 0 is a sharp corner. It adds no mass.",
    "\"3 mm\"",
);
const OIL_HOLE_KEY: Key = key(
    "oil_hole",
    Kind::Table(&OIL_HOLE),
    Optional,
    "Oil hole in the pin. It takes no mass.",
    "{ diameter = \"5 mm\", angle = \"60 deg\" }",
);
const NUMBERS: Key = key(
    "numbers",
    Kind::Wholes(1, 1000),
    Required,
    "Which ones, counted from 1: journals along their crankshaft, pins as the throws, webs through all throws.",
    "[1, 8]",
);
const DIAMETER: Key = quantity("diameter", Length, Positive, "Diameter; default that of all.", "\"60 mm\"");
const BORE: Key =
    quantity("bore", Length, NotNegative, "Diameter of the bore along it; default that of all.", "\"20 mm\"");
const FILLET: Key =
    quantity("fillet", Length, NotNegative, "Radius of its fillets; default that of all.", "\"4 mm\"");
const RECESS: Key =
    quantity("recess", Length, NotNegative, "Depth of their undercut; default that of all.", "\"0.5 mm\"");
const CRANKSHAFT_NUMBER: Key = key(
    "crankshaft",
    Kind::Whole(1, MOST_CRANKSHAFTS),
    Optional,
    "Number of its crankshaft; default 1.",
    "1",
);
const STEP_LENGTH: Key =
    key("length", Kind::Quantity(Length, Positive), Required, "Length along the crank.", "\"40 mm\"");
const STEP_DIAMETER: Key =
    key("diameter", Kind::Quantity(Length, Positive), Required, "Diameter.", "\"30 mm\"");
const STEP_BORE: Key =
    quantity("bore", Length, NotNegative, "Diameter of a bore along its middle; default none.", "\"12 mm\"");

static OIL_HOLE: Table = Table {
    header: "[crank.body.oil_hole]",
    doc: "Oil hole across a crankpin, for strength by rules: it is left out of masses and drawings.",
    keys: &[
        key("diameter", Kind::Quantity(Length, Positive), Required, "Diameter of the hole.", "\"5 mm\""),
        quantity(
            "angle",
            Angle,
            Any,
            "Direction of its mouth about the middle of the pin, from that of the throw, positive with the crank; default 0.",
            "\"60 deg\"",
        ),
    ],
};

static JOURNAL: Table = Table {
    header: "[[crank.body.journal]]",
    doc: "Journals that differ from those of all. They count along their crankshaft from the free end; where webs touch is none.",
    keys: &[NUMBERS, CRANKSHAFT_NUMBER, DIAMETER, BORE, FILLET, RECESS],
};

static PIN: Table = Table {
    header: "[[crank.body.pin]]",
    doc: "Crankpins that differ from those of all.",
    keys: &[NUMBERS, DIAMETER, BORE, FILLET, RECESS, OIL_HOLE_KEY],
};

static WEB: Table = Table {
    header: "[[crank.body.web]]",
    doc: "Webs that differ from those of all: 1 in front of pin 1, 2 behind it, and so on. A web of another thickness keeps its face towards the \
          pin, and its middle moves with the other face; `position` puts it elsewhere.",
    keys: &[
        NUMBERS,
        quantity(
            "thickness",
            Length,
            Positive,
            "Thickness along the crank; default that of all.",
            "\"24 mm\"",
        ),
        quantity(
            "radius",
            Length,
            Positive,
            "Radius of its disc about the crank axis; default that of all.",
            "\"45 mm\"",
        ),
        quantity(
            "pin_end_radius",
            Length,
            Positive,
            "Radius of its round end about the crankpin; default that of all.",
            "\"36 mm\"",
        ),
        quantity(
            "position",
            Length,
            Any,
            "Plane of its middle in the z of this file; of one web alone.",
            "\"-66 mm\"",
        ),
    ],
};

static NOSE: Table = Table {
    header: "[[crank.body.nose]]",
    doc: "A round step before the first journal.",
    keys: &[STEP_LENGTH, STEP_DIAMETER, STEP_BORE, CRANKSHAFT_NUMBER],
};

static FLANGE: Table = Table {
    header: "[[crank.body.flange]]",
    doc: "A round step behind the last journal.",
    keys: &[STEP_LENGTH, STEP_DIAMETER, STEP_BORE, CRANKSHAFT_NUMBER],
};

pub(super) static CRANK_MATERIAL: Table = Table {
    header: "[crank.material]",
    doc: "What the crankshafts are made of; their density is in `[crank.body]`. Numbers go before those of the preset, which are typical values.",
    keys: &[
        key(
            "preset",
            Kind::Choice(&[
                "42CrMo4 quenched and tempered",
                "34CrNiMo6 quenched and tempered",
                "C45 quenched and tempered",
                "38MnVS6 precipitation hardened",
                "EN-GJS-700-2",
            ]),
            Optional,
            "A material by its name, with typical values of elasticity and strength.",
            "\"42CrMo4 quenched and tempered\"",
        ),
        quantity("youngs_modulus", Pressure, Positive, "Young's modulus.", "\"210 GPa\""),
        key("poisson_ratio", Kind::Number(NotNegative), Optional, "Poisson's ratio, below 0.5.", "0.3"),
        quantity("tensile_strength", Pressure, Positive, "Tensile strength.", "\"900 MPa\""),
        quantity("yield_strength", Pressure, Positive, "Yield strength.", "\"650 MPa\""),
        quantity(
            "fatigue_bending",
            Pressure,
            Positive,
            "Fatigue strength in alternating bending, polished; default 0.45 of the tensile strength.",
            "\"430 MPa\"",
        ),
        quantity(
            "fatigue_torsion",
            Pressure,
            Positive,
            "Fatigue strength in alternating torsion, polished; default that in bending over the square root of 3.",
            "\"250 MPa\"",
        ),
        key(
            "forging",
            Kind::Choice(&["grain-flow", "free", "cast-rolled"]),
            Optional,
            "How it is made: with continuous grain flow, free form forged, or cast with rolled fillets.",
            "\"grain-flow\"",
        ),
        key("loss_factor", Kind::Number(NotNegative), Optional, "Loss factor of the material.", "0.01"),
        key(
            "damping_ratio",
            Kind::Share,
            Optional,
            "Damping of every mode as a share of critical damping, instead of `loss_factor`.",
            "\"1 %\"",
        ),
    ],
};

const fn elements(
    name: &'static str,
    table: &'static Table,
    doc: &'static str,
    example: &'static str,
    most: usize,
) -> Key {
    key(name, Kind::Tables(table, most), Optional, doc, example)
}

const fn length(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Quantity(Length, Positive), Required, doc, example)
}

const fn bore(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    quantity(name, Length, NotNegative, doc, example)
}
