//! What belongs to the running engine: friction, flywheel and bearings.

use super::super::Bound::{NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::{key, quantity};
use lanchester_units::Dimension::{
    Damping, Inertia, Length, Pressure, PressurePerSpeed, PressurePerSpeedSquared, Speed,
};

pub(super) static FRICTION: Table = Table {
    header: "[friction]",
    doc: "Friction as a mean effective pressure: `fmep`, the same everywhere, or Chen and Flynn's form, `constant + peak_pressure p_max + speed S + speed_squared S^2` with \
          the mean piston speed S. Gives brake torque and power; needs `[gas]`.",
    keys: &[
        quantity(
            "fmep",
            Pressure,
            NotNegative,
            "Friction mean effective pressure, the same at every speed and load.",
            "\"1.2 bar\"",
        ),
        quantity("constant", Pressure, NotNegative, "Constant of Chen and Flynn's form.", "\"0.4 bar\""),
        key(
            "peak_pressure",
            Kind::Number(NotNegative),
            Optional,
            "Share of the highest cylinder pressure in Chen and Flynn's form; default 0.",
            "0.005",
        ),
        quantity(
            "speed",
            PressurePerSpeed,
            NotNegative,
            "What each m/s of mean piston speed adds; default 0.",
            "\"0.09 bar s/m\"",
        ),
        quantity(
            "speed_squared",
            PressurePerSpeedSquared,
            NotNegative,
            "What the square of the mean piston speed adds; default 0.",
            "\"0.0009 bar s2/m2\"",
        ),
        quantity(
            "piston_damping",
            Damping,
            NotNegative,
            "Viscous friction of every piston along its cylinder, of a run in time alone; default 0.",
            "\"20 N s/m\"",
        ),
    ],
};

pub(super) static FLYWHEEL: Table = Table {
    header: "[flywheel]",
    doc: "What turns with crankshaft 1 beside the crank train, and how evenly it is to turn.",
    keys: &[
        quantity(
            "inertia",
            Inertia,
            NotNegative,
            "Moment of inertia of the flywheel, with the clutch and all that turns rigidly with crankshaft 1.",
            "\"0.15 kg m2\"",
        ),
        quantity(
            "crankshaft_inertia",
            Inertia,
            NotNegative,
            "Moment of inertia of the crankshafts with their counterweights, at crankshaft 1, without rods; without it that of `[crank.body]`.",
            "\"0.02 kg m2\"",
        ),
        key(
            "fluctuation",
            Kind::Share,
            Optional,
            "Fluctuation of the speed that is allowed, highest less lowest over mean: the flywheel that keeps it is found.",
            "\"2 %\"",
        ),
        key(
            "speeds",
            Kind::Quantities(Speed, Positive),
            Optional,
            "Speeds at which the ripple is listed and the fluctuation is to be kept; default the ripple at the lowest and the highest speed of the file, the \
             fluctuation at the lowest.",
            "[\"800 rpm\", \"4000 rpm\"]",
        ),
    ],
};

pub(super) static BEARINGS: Table = Table {
    header: "[bearings]",
    doc: "Sizes of the plain bearings, for the pressures on them. Diameters of crankpins and main journals come from `[crank.body]` where it is there.",
    keys: &[
        key(
            "piston_pin",
            Kind::Table(&PISTON_PIN),
            Optional,
            "Piston pin in the rod's small end.",
            "{ diameter = \"22 mm\", width = \"24 mm\" }",
        ),
        key(
            "crankpin",
            Kind::Table(&CRANKPIN),
            Optional,
            "Crankpin in the big end of one rod.",
            "{ diameter = \"48 mm\", width = \"22 mm\" }",
        ),
        key(
            "main",
            Kind::Table(&MAIN),
            Optional,
            "Main journals.",
            "{ diameter = \"54 mm\", width = \"20 mm\" }",
        ),
    ],
};

const DIAMETER: Key = quantity(
    "diameter",
    Length,
    Positive,
    "Diameter of the pin or journal; not beside `[crank.body]`, which has it.",
    "\"48 mm\"",
);
const WIDTH: Key = key(
    "width",
    Kind::Quantity(Length, Positive),
    Required,
    "Width of the bearing that carries.",
    "\"22 mm\"",
);

static PISTON_PIN: Table = Table {
    header: "[bearings.piston_pin]",
    doc: "Piston pin in the rod's small end.",
    keys: &[
        key("diameter", Kind::Quantity(Length, Positive), Required, "Diameter of the pin.", "\"22 mm\""),
        WIDTH,
    ],
};

static CRANKPIN: Table = Table {
    header: "[bearings.crankpin]",
    doc: "Crankpin in the big end of one rod; without it the size in `[crank.body]`, where that is there.",
    keys: &[DIAMETER, WIDTH],
};

static MAIN: Table = Table {
    header: "[bearings.main]",
    doc: "Main journals; without it the size in `[crank.body]`, where that is there.",
    keys: &[DIAMETER, WIDTH],
};
