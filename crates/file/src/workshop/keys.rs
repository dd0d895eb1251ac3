//! The keys of the workshop sheet, table by table.

mod crank;

use crate::schema::Bound::{Any, NotNegative, Positive};
use crate::schema::Need::{Optional, Required};
use crate::schema::{Key, Kind, Table, key, quantity};
use crank::{BOBWEIGHT, EXTERNAL, MOST_PINS, PARTS, PIN, SLUG};
use lanchester_units::Dimension::{
    Acceleration, Angle, Density, Inertia, Length, Mass, Speed, Unbalance, Velocity,
};

/// Counts above which a sheet is refused, so that nothing explodes.
const MOST_PLANES: usize = 16;
const MOST_SENSORS: usize = 32;
const MOST_RUNS: usize = 256;
const MOST_WEIGHTS: usize = 32;
const MOST_DISPLAYS: usize = 32;

const SENSES: &[&str] = &["clockwise", "anticlockwise"];

/// The whole sheet.
pub(crate) static SHEET: Table = Table {
    header: "",
    doc: "A workshop sheet holds these keys and tables. Every quantity is a text with its unit.",
    keys: &[
        key("version", Kind::WholeChoice(&[1]), Optional, "Version of the file format.", "1"),
        key("name", Kind::Text(200), Required, "What is balanced.", "\"crankshaft 12\""),
        key("note", Kind::Text(10_000), Optional, "Where the data come from.", "\"test bench, 3 May\""),
        key(
            "rotor",
            Kind::Table(&ROTOR),
            Optional,
            "The rotor and how it is looked at.",
            "{ mass = \"12 kg\" }",
        ),
        key(
            "plane",
            Kind::Tables(&PLANE, MOST_PLANES),
            Optional,
            "Planes where weight may be added or removed.",
            "[{ name = \"front\" }]",
        ),
        key(
            "sensor",
            Kind::Tables(&SENSOR, MOST_SENSORS),
            Optional,
            "Vibration sensors.",
            "[{ name = \"A\", detector = \"rms\" }]",
        ),
        key(
            "run",
            Kind::Tables(&RUN, MOST_RUNS),
            Optional,
            "Measured runs, in the order in which they were made.",
            "[{ speed = \"1500 rpm\", readings = [] }]",
        ),
        key(
            "display",
            Kind::Tables(&DISPLAY, MOST_DISPLAYS),
            Optional,
            "Unbalances that a balancing machine shows; they add up.",
            "[{ plane = \"front\", unbalance = \"35 g mm\", angle = \"120 deg\" }]",
        ),
        key(
            "engine",
            Kind::Text(1000),
            Optional,
            "Engine file that the sheet belongs to, from the sheet's own folder.",
            "\"v8.toml\"",
        ),
        key(
            "bobweight",
            Kind::Table(&BOBWEIGHT),
            Optional,
            "What bobweights are made up for.",
            "{ reciprocating_share = \"50 %\" }",
        ),
        key(
            "parts",
            Kind::Table(&PARTS),
            Optional,
            "Weighed parts of every cylinder.",
            "{ piston = \"560 g\" }",
        ),
        key("pin", Kind::Tables(&PIN, MOST_PINS), Optional, "The crankpins one by one.", "[{ throw = 1 }]"),
        key(
            "external",
            Kind::Tables(&EXTERNAL, MOST_PLANES),
            Optional,
            "Weights outside the crankcase that are to come off.",
            "[{ name = \"damper\" }]",
        ),
        key("slug", Kind::Table(&SLUG), Optional, "Heavy-metal slugs.", "{ diameter = \"25.4 mm\" }"),
    ],
};

static ROTOR: Table = Table {
    header: "[rotor]",
    doc: "The rotor and how it is looked at. Angles are counted on two circles of degrees, one on the rotor and one on \
          the housing, both in the sense `marks` and seen from the same end as `rotation`.",
    keys: &[
        quantity("mass", Mass, Positive, "Mass of the rotor.", "\"12 kg\""),
        quantity("centre", Length, Any, "Its centre of mass along the shaft.", "\"180 mm\""),
        quantity(
            "transverse_inertia",
            Inertia,
            Positive,
            "Moment of inertia about an axis across the shaft through its centre of mass.",
            "\"0.35 kg m2\"",
        ),
        quantity("polar_inertia", Inertia, Positive, "Moment of inertia about the shaft.", "\"0.08 kg m2\""),
        key(
            "supports",
            Kind::Quantities(Length, Any),
            Optional,
            "Its two bearings along the shaft, rising.",
            "[\"0 mm\", \"400 mm\"]",
        ),
        quantity("speed", Speed, Positive, "Highest service speed.", "\"6000 rpm\""),
        key(
            "grade",
            Kind::Text(20),
            Optional,
            "Balance quality grade: G and the permissible speed of the centre of mass in mm/s.",
            "\"G 6.3\"",
        ),
        key(
            "marks",
            Kind::Choice(SENSES),
            Optional,
            "Sense in which angles count, on the rotor and on the housing. Needed where there are runs.",
            "\"anticlockwise\"",
        ),
        key(
            "rotation",
            Kind::Choice(SENSES),
            Optional,
            "Sense in which the rotor turns, seen from the same end. Needed where there are runs.",
            "\"clockwise\"",
        ),
        key(
            "phase",
            Kind::Choice(&["lag", "lead"]),
            Optional,
            "What a positive phase means: \"lag\" counts from the keyphasor's pulse to the next positive peak, \"lead\" \
             from the peak to the next pulse. Needed where there are runs.",
            "\"lag\"",
        ),
        quantity(
            "keyphasor",
            Angle,
            Any,
            "Angle on the housing at which the rotor's zero stands at the pulse; default 0.",
            "\"90 deg\"",
        ),
    ],
};

static PLANE: Table = Table {
    header: "[[plane]]",
    doc: "A plane where weight may be added or removed.",
    keys: &[
        key("name", Kind::Text(100), Required, "Its name.", "\"front\""),
        quantity("z", Length, Any, "Where along the shaft.", "\"40 mm\""),
        quantity(
            "radius",
            Length,
            Positive,
            "Radius at which weights sit, of the surface that is drilled radially, or of the circle of axial holes.",
            "\"60 mm\"",
        ),
        key(
            "angles",
            Kind::Quantities(Angle, Any),
            Optional,
            "Angles on the rotor that may be used; with neither `angles`, `positions` nor `sectors` every angle may be.",
            "[\"0 deg\", \"30 deg\"]",
        ),
        key(
            "positions",
            Kind::Whole(1, 256),
            Optional,
            "So many equally spaced places that may be used, the first at 0 deg.",
            "12",
        ),
        key(
            "sectors",
            Kind::Tables(&SECTOR, 32),
            Optional,
            "Ranges of angles that may be used.",
            "[{ from = \"150 deg\", to = \"210 deg\" }]",
        ),
        key(
            "action",
            Kind::Choice(&["add", "remove"]),
            Optional,
            "Whether weight is put on or taken off; default \"add\", or \"remove\" with `drill`.",
            "\"remove\"",
        ),
        key("drill", Kind::Table(&DRILL), Optional, "How it is drilled.", "{ direction = \"radial\" }"),
    ],
};

static SECTOR: Table = Table {
    header: "sectors",
    doc: "A range of angles on the rotor, from the first on in the sense in which angles count.",
    keys: &[
        key("from", Kind::Quantity(Angle, Any), Required, "Where it begins.", "\"150 deg\""),
        key("to", Kind::Quantity(Angle, Any), Required, "Where it ends.", "\"210 deg\""),
    ],
};

static DRILL: Table = Table {
    header: "drill",
    doc: "How holes are drilled in a plane.",
    keys: &[
        key(
            "direction",
            Kind::Choice(&["radial", "axial"]),
            Required,
            "Towards the axis, or parallel to it.",
            "\"radial\"",
        ),
        key(
            "surface",
            Kind::Choice(&["round", "flat"]),
            Optional,
            "Where a radial hole begins: on a cylinder about the axis, depth counted from its crown, or on a flat; \
             default \"round\".",
            "\"flat\"",
        ),
        key(
            "diameters",
            Kind::Quantities(Length, Positive),
            Required,
            "Diameters of the drills.",
            "[\"8 mm\", \"10 mm\"]",
        ),
        key(
            "max_depth",
            Kind::Quantity(Length, Positive),
            Required,
            "Depth that the tip of the drill may reach.",
            "\"25 mm\"",
        ),
        quantity(
            "depth_step",
            Length,
            Positive,
            "Depths to the end of the full diameter are multiples of this; default any depth.",
            "\"0.5 mm\"",
        ),
        quantity("point", Angle, Positive, "Angle of the drill point; default 118 deg.", "\"118 deg\""),
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density of the material.",
            "\"7.85 g/cm3\"",
        ),
        quantity(
            "land",
            Length,
            NotNegative,
            "Least wall between neighbouring holes, and to the edges of the surface where `width` is given; default 0 mm.",
            "\"3 mm\"",
        ),
        quantity(
            "spacing",
            Length,
            NotNegative,
            "Least distance between the centres of neighbouring holes, on the surface or on the circle of holes; default 0 mm.",
            "\"15 mm\"",
        ),
        quantity(
            "width",
            Length,
            Positive,
            "Width of the drilled surface, the holes in its middle: along the shaft where holes are radial, from its inner to its \
             outer edge where they are axial.",
            "\"22 mm\"",
        ),
        key("most_holes", Kind::Whole(1, 4), Optional, "Most holes of one correction; default 3.", "3"),
        quantity(
            "angle_step",
            Angle,
            Positive,
            "Step of the angles tried for more than one hole where a whole range may be used; default 5 deg.",
            "\"5 deg\"",
        ),
    ],
};

static SENSOR: Table = Table {
    header: "[[sensor]]",
    doc: "A vibration sensor.",
    keys: &[
        key("name", Kind::Text(100), Required, "Its name.", "\"A\""),
        quantity(
            "angle",
            Angle,
            Any,
            "Its angle on the housing; it shows positive when the housing moves towards it. Default 0.",
            "\"90 deg\"",
        ),
        key(
            "detector",
            Kind::Choice(&["peak", "peak-to-peak", "rms"]),
            Required,
            "How its amplitudes are given.",
            "\"rms\"",
        ),
        key(
            "limit",
            Kind::Table(&LIMIT),
            Optional,
            "Largest amplitude that is accepted.",
            "{ velocity = \"1.8 mm/s\" }",
        ),
    ],
};

static LIMIT: Table = Table {
    header: "limit",
    doc: "A vibration amplitude as the sensor's detector gives it: one of the three.",
    keys: &[DISPLACEMENT, VELOCITY, ACCELERATION],
};

const DISPLACEMENT: Key =
    quantity("displacement", Length, NotNegative, "Amplitude of the displacement.", "\"12 um\"");
const VELOCITY: Key =
    quantity("velocity", Velocity, NotNegative, "Amplitude of the velocity.", "\"4.2 mm/s\"");
const ACCELERATION: Key =
    quantity("acceleration", Acceleration, NotNegative, "Amplitude of the acceleration.", "\"1.5 m/s2\"");

static RUN: Table = Table {
    header: "[[run]]",
    doc: "A measured run. Its weights come on top of those that earlier runs left on the rotor.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name.", "\"as received\""),
        key("speed", Kind::Quantity(Speed, Positive), Required, "Its speed.", "\"1500 rpm\""),
        key(
            "readings",
            Kind::Tables(&READING, MOST_SENSORS),
            Required,
            "What the sensors showed, filtered at the speed of rotation.",
            "[{ sensor = \"A\", velocity = \"4.2 mm/s\", phase = \"37 deg\" }]",
        ),
        key(
            "weights",
            Kind::Tables(&WEIGHT, MOST_WEIGHTS),
            Optional,
            "What was put on or taken off for this run: trial weights and corrections alike.",
            "[{ plane = \"front\", unbalance = \"600 g mm\", angle = \"0 deg\", kept = false }]",
        ),
    ],
};

static READING: Table = Table {
    header: "readings",
    doc: "What a sensor showed: displacement, velocity or acceleration, with its phase.",
    keys: &[
        key("sensor", Kind::Text(100), Required, "Name of the sensor.", "\"A\""),
        DISPLACEMENT,
        VELOCITY,
        ACCELERATION,
        key("phase", Kind::Quantity(Angle, Any), Required, "Phase as the instrument shows it.", "\"37 deg\""),
    ],
};

static WEIGHT: Table = Table {
    header: "weights",
    doc: "A weight that was put on or taken off for a run.",
    keys: &[
        key("plane", Kind::Text(100), Required, "Name of its plane.", "\"front\""),
        quantity("unbalance", Unbalance, NotNegative, "Mass times radius.", "\"600 g mm\""),
        quantity("mass", Mass, NotNegative, "Mass, at `radius` or the radius of the plane.", "\"10 g\""),
        quantity("radius", Length, Positive, "Radius of the mass; default that of the plane.", "\"60 mm\""),
        key("angle", Kind::Quantity(Angle, Any), Required, "Angle on the rotor.", "\"0 deg\""),
        key(
            "action",
            Kind::Choice(&["added", "removed"]),
            Optional,
            "Whether it was put on or taken off; default \"added\".",
            "\"removed\"",
        ),
        key(
            "kept",
            Kind::Flag,
            Required,
            "Whether it stayed so after the run; with false it was undone.",
            "false",
        ),
    ],
};

static DISPLAY: Table = Table {
    header: "[[display]]",
    doc: "An unbalance that a balancing machine shows: its heavy spot. A dynamic unbalance is two of kind \"plane\", one a \
          plane; static and couple unbalance are one of kind \"plane\" and one of kind \"couple\".",
    keys: &[
        key(
            "kind",
            Kind::Choice(&["plane", "couple"]),
            Optional,
            "One unbalance in one plane, or two equal ones opposed in two planes; default \"plane\".",
            "\"couple\"",
        ),
        key(
            "plane",
            Kind::Text(100),
            Optional,
            "Name of the plane, where it is one of [[plane]].",
            "\"front\"",
        ),
        key(
            "planes",
            Kind::Quantities(Length, Any),
            Optional,
            "Where a couple's two planes stand along the shaft; `angle` is that in the first.",
            "[\"40 mm\", \"360 mm\"]",
        ),
        quantity("z", Length, Any, "Where along the shaft, instead of `plane`.", "\"0 mm\""),
        key("unbalance", Kind::Quantity(Unbalance, NotNegative), Required, "Its amount.", "\"35 g mm\""),
        key("angle", Kind::Quantity(Angle, Any), Required, "Angle on the rotor.", "\"120 deg\""),
        key(
            "spot",
            Kind::Choice(&["heavy", "light"]),
            Optional,
            "Whether the machine shows the heavy spot or where weight is missing; default \"heavy\".",
            "\"light\"",
        ),
    ],
};
