//! Tolerances of parts.

use super::super::Bound::Positive;
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::key;
use lanchester_units::Dimension::{self, Angle, Length, Mass, Unbalance};

/// Keys of the quantities that vary, and more.
macro_rules! quantities {
    ($($more:expr)?) => {
        &[
            mass("piston_mass", "Of each piston with pin, rings and clips.", "{ plus_minus = \"1.5 g\" }"),
            mass("big_end_mass", "Of each rod's big end.", "{ plus_minus = \"2 g\" }"),
            mass("small_end_mass", "Of each rod's small end.", "{ plus_minus = \"1 g\" }"),
            length(
                "rod_centre",
                "Of each rod's centre of gravity, from the big-end eye: mass moves from one end to the other.",
                "{ plus_minus = \"0.3 mm\" }",
            ),
            length("rod_length", "Of each rod, between the eyes.", "{ plus_minus = \"0.05 mm\" }"),
            length("crank_radius", "Of each throw.", "{ plus_minus = \"0.05 mm\" }"),
            angle("throw_angle", "Of the direction of each throw.", "{ plus_minus = \"0.2 deg\" }"),
            unbalance("throw_unbalance", "Of each throw's own unbalance.", "{ plus_minus = \"20 g mm\" }"),
            length("offset", "Of the line of each piston pin from the crank axis.", "{ plus_minus = \"0.1 mm\" }"),
            length("cylinder_plane", "Of the place of each cylinder along the crank.", "{ plus_minus = \"0.1 mm\" }"),
            angle("cylinder_angle", "Of the direction of each cylinder's axis.", "{ plus_minus = \"0.1 deg\" }"),
            unbalance("counterweight_unbalance", "Of each counterweight.", "{ plus_minus = \"150 g mm\" }"),
            angle("counterweight_angle", "Of the direction of each counterweight.", "{ plus_minus = \"0.5 deg\" }"),
            unbalance("shaft_unbalance", "Of each weight on a balance shaft.", "{ plus_minus = \"30 g mm\" }"),
            angle(
                "shaft_phase",
                "Of each balance shaft against the crank: play and indexing of its gears.",
                "{ plus_minus = \"1 deg\", distribution = \"uniform\" }",
            ),
            $($more)?
        ]
    };
}

pub(super) static TOLERANCES: Table = Table {
    header: "[tolerances]",
    doc: "What the parts of a production may be off, for the scatter of a production: every part by itself. What is one for all parts of an engine (a batch, a setting \
          of a machine) stands in `[tolerances.common]` by the same keys.",
    keys: quantities!(key(
        "common",
        Kind::Table(&COMMON),
        Optional,
        "Tolerances of what is one for all parts of an engine.",
        "{ rod_length = { plus_minus = \"0.1 mm\" } }",
    )),
};

static COMMON: Table = Table {
    header: "[tolerances.common]",
    doc: "What all parts of an engine are off together, besides what each is off by itself. The keys are those of `[tolerances]`.",
    keys: quantities!(),
};

static OF_A_MASS: Table = one("[tolerances.<mass>]", "Tolerance of a mass.", &KEYS_OF_A_MASS);
static OF_A_LENGTH: Table = one("[tolerances.<length>]", "Tolerance of a length.", &KEYS_OF_A_LENGTH);
static OF_AN_ANGLE: Table = one("[tolerances.<angle>]", "Tolerance of an angle.", &KEYS_OF_AN_ANGLE);
static OF_AN_UNBALANCE: Table =
    one("[tolerances.<unbalance>]", "Tolerance of an unbalance.", &KEYS_OF_AN_UNBALANCE);

static KEYS_OF_A_MASS: [Key; 3] = keys(Mass, "\"1.5 g\"");
static KEYS_OF_A_LENGTH: [Key; 3] = keys(Length, "\"0.05 mm\"");
static KEYS_OF_AN_ANGLE: [Key; 3] = keys(Angle, "\"0.2 deg\"");
static KEYS_OF_AN_UNBALANCE: [Key; 3] = keys(Unbalance, "\"30 g mm\"");

const fn one(header: &'static str, doc: &'static str, keys: &'static [Key]) -> Table {
    Table { header, doc, keys }
}

const fn keys(dimension: Dimension, example: &'static str) -> [Key; 3] {
    [
        key(
            "plus_minus",
            Kind::Quantity(dimension, Positive),
            Required,
            "The nominal value may be missed by this either way.",
            example,
        ),
        key(
            "distribution",
            Kind::Choice(&["normal", "uniform"]),
            Optional,
            "Normal and cut off at the tolerance (default), or anywhere within it with the same probability.",
            "\"uniform\"",
        ),
        key(
            "sigmas",
            Kind::Number(Positive),
            Optional,
            "Standard deviations in the half width of a normal distribution, from 0.1 to 8; default 3.",
            "4",
        ),
    ]
}

const fn mass(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Table(&OF_A_MASS), Optional, doc, example)
}

const fn length(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Table(&OF_A_LENGTH), Optional, doc, example)
}

const fn angle(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Table(&OF_AN_ANGLE), Optional, doc, example)
}

const fn unbalance(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Table(&OF_AN_UNBALANCE), Optional, doc, example)
}
