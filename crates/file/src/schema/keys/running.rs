//! What belongs to the running engine: friction, flywheel and bearings.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{MOST_CYLINDERS, key, quantity};
use lanchester_units::Dimension::{
    Angle, Damping, Density, Inertia, KinematicViscosity, Length, Pressure, PressurePerSpeed,
    PressurePerSpeedSquared, Speed, Stiffness, Temperature, Viscosity,
};

/// Most main bearings that differ.
const MOST_MAINS: usize = 128;

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
        key("film", Kind::Table(&FILM), Optional, "Oil of the bearings.", "{ viscosity = \"10 mPa s\" }"),
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
    keys: &[
        DIAMETER,
        WIDTH,
        CLEARANCE,
        LAW,
        SPRING,
        DAMPER,
        GROOVES,
        HOUSING,
        key(
            "each",
            Kind::Tables(&EACH_CRANKPIN, MOST_CYLINDERS as usize),
            Optional,
            "Bearings that differ, by the number of their cylinder.",
            "[{ number = 2, diametral_clearance = \"0.07 mm\" }]",
        ),
    ],
};

static MAIN: Table = Table {
    header: "[bearings.main]",
    doc: "Main journals; without it the size in `[crank.body]`, where that is there.",
    keys: &[
        DIAMETER,
        WIDTH,
        CLEARANCE,
        LAW,
        SPRING,
        DAMPER,
        GROOVES,
        HOUSING,
        key(
            "each",
            Kind::Tables(&EACH_MAIN, MOST_MAINS),
            Optional,
            "Bearings that differ, by their number from the free end on, those of crankshaft 1 first.",
            "[{ number = 3, width = \"26 mm\" }]",
        ),
    ],
};

const EACH_NUMBER: Key = key("number", Kind::Whole(1, 1000), Required, "Its number, from 1.", "3");
const EACH_WIDTH: Key = quantity(
    "width",
    Length,
    Positive,
    "Width of the bearing that carries; default that of all.",
    "\"26 mm\"",
);
const CLEARANCE: Key = quantity(
    "diametral_clearance",
    Length,
    Positive,
    "Diameter of the shell less that of the pin or journal.",
    "\"0.06 mm\"",
);
const LAW: Key = key(
    "model",
    Kind::Choice(&["rigid", "contact", "bushing", "film"]),
    Optional,
    "Which law it follows in runs with clearance.",
    "\"film\"",
);
const SPRING: Key = quantity(
    "stiffness",
    Stiffness,
    Positive,
    "Stiffness of the laws `contact` and `bushing`.",
    "\"2000 kN/mm\"",
);
const DAMPER: Key = quantity(
    "damping",
    Damping,
    NotNegative,
    "Damping of the laws `contact` and `bushing`.",
    "\"2e4 N s/m\"",
);
const GROOVES: Key = key(
    "grooves",
    Kind::Tables(&GROOVE, 8),
    Optional,
    "Oil grooves in the middle of the shell.",
    "[{ from = \"-60 deg\", to = \"60 deg\", width = \"4 mm\" }]",
);
const HOUSING: Key = key(
    "housing_stiffness",
    Kind::QuantityOrWord(Stiffness, Positive, "rigid"),
    Optional,
    "Stiffness of its housing, or \"rigid\"; static cases in oil films and `stress cycle` use it.",
    "\"1000 kN/mm\"",
);

static GROOVE: Table = Table {
    header: "[[bearings.main.grooves]]",
    doc: "An oil groove, its angles in the frame of the shell: of a main bearing from +x towards +y, of a crankpin bearing from the rod's line towards the piston.",
    keys: &[
        key("from", Kind::Quantity(Angle, Any), Required, "Where it begins.", "\"-60 deg\""),
        key("to", Kind::Quantity(Angle, Any), Required, "Where it ends, at most a turn on.", "\"60 deg\""),
        key("width", Kind::Quantity(Length, Positive), Required, "Its width along the crank.", "\"4 mm\""),
    ],
};

static EACH_MAIN: Table = Table {
    header: "[[bearings.main.each]]",
    doc: "A main bearing that differs from all.",
    keys: &[EACH_NUMBER, EACH_WIDTH, CLEARANCE, LAW, SPRING, DAMPER, GROOVES, HOUSING],
};

static EACH_CRANKPIN: Table = Table {
    header: "[[bearings.crankpin.each]]",
    doc: "A crankpin bearing that differs from all.",
    keys: &[EACH_NUMBER, EACH_WIDTH, CLEARANCE, LAW, SPRING, DAMPER, GROOVES, HOUSING],
};

static FILM: Table = Table {
    header: "[bearings.film]",
    doc: "Oil of the bearings: its viscosity, or its name and temperature.",
    keys: &[
        quantity("viscosity", Viscosity, Positive, "Dynamic viscosity.", "\"10 mPa s\""),
        quantity(
            "kinematic_viscosity",
            KinematicViscosity,
            Positive,
            "Kinematic viscosity, instead of `viscosity`, with `density`.",
            "\"12 cSt\"",
        ),
        key("oil", Kind::Text(60), Optional, "Name of an oil, instead of `viscosity`.", "\"SAE 5W-30\""),
        quantity("temperature", Temperature, Positive, "Temperature of the oil in the film.", "\"110 degC\""),
        quantity("density", Density, Positive, "Density of the oil.", "\"850 kg/m3\""),
        key(
            "cavitation",
            Kind::Choice(&["full", "gumbel", "reynolds", "mass-conserving"]),
            Optional,
            "How the film breaks.",
            "\"gumbel\"",
        ),
        quantity("supply_pressure", Pressure, NotNegative, "Supply pressure above ambient.", "\"4 bar\""),
        quantity("roughness", Length, NotNegative, "Composite roughness of both surfaces.", "\"0.5 um\""),
    ],
};
