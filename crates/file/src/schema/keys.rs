//! The keys of the engine file, table by table.

mod balance;
mod clearance;
mod crank_body;
mod design;
mod devices;
mod entry;
mod gas;
mod layout;
mod mount;
mod part;
mod running;
mod shaft_part;
mod simulation;
mod stress;
mod tolerances;
mod torsion;
mod train;

pub(crate) use entry::{key, quantity};

use super::Bound::{Any, Positive};
use super::Need::{Optional, Required};
use super::{Kind, Table};
use balance::BALANCE;
use clearance::CLEARANCE;
use design::COUNTERWEIGHT_DESIGN;
use devices::{COUNTERWEIGHT, COUNTERWEIGHTS, GEAR, SHAFT};
use entry::{MOST_CRANKSHAFTS, MOST_CYLINDERS, MOST_MOUNTS, MOST_SHAFTS, MOST_THROWS, MOST_WEIGHTS};
use gas::GAS;
use lanchester_units::Dimension::{Angle, Length, Speed};
use layout::LAYOUT;
use mount::{BLOCK, MOUNT};
use running::{BEARINGS, FLYWHEEL, FRICTION};
use shaft_part::SHAFT_WEIGHT_DESIGN;
use simulation::{DRIVELINE, GOVERNOR, LOAD, MOST_LINKS, SIMULATION, STARTER};
use stress::STRESS;
use tolerances::TOLERANCES;
use torsion::{DAMPER, MOST_PENDULUMS, PENDULUM, TORSION};
use train::{ARTICULATED_ROD, CRANK, CRANKSHAFT, CYLINDER, CYLINDERS, PISTON, ROD, THROW};

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
            "counterweight_design",
            Kind::Table(&COUNTERWEIGHT_DESIGN),
            Optional,
            "Shapes among which counterweights are to be found.",
            "{ minimise = \"mass\" }",
        ),
        key(
            "clearance",
            Kind::Table(&CLEARANCE),
            Optional,
            "What the crankshaft must stay clear of.",
            "{ least = \"1 mm\" }",
        ),
        key(
            "shaft",
            Kind::Tables(&SHAFT, MOST_SHAFTS),
            Optional,
            "Balance shafts.",
            "[{ ratio = -1, weights = [] }]",
        ),
        key(
            "gear",
            Kind::Tables(&GEAR, MOST_SHAFTS),
            Optional,
            "Gears, pulleys and other wheels that turn with the crank at a fixed ratio.",
            "[{ ratio = -1, inertia = \"0.0006 kg m2\" }]",
        ),
        key(
            "shaft_weight_design",
            Kind::Table(&SHAFT_WEIGHT_DESIGN),
            Optional,
            "Shapes among which the weights of balance shafts are to be found.",
            "{ minimise = \"mass\" }",
        ),
        key(
            "balance",
            Kind::Table(&BALANCE),
            Optional,
            "What may be done to balance the engine, and what is wanted.",
            "{ minimise = [\"force\"] }",
        ),
        key(
            "gas",
            Kind::Table(&GAS),
            Optional,
            "Gas in the cylinders: measured traces, or a cycle to be computed.",
            "{ cycle = { type = \"otto\" } }",
        ),
        key(
            "friction",
            Kind::Table(&FRICTION),
            Optional,
            "Friction of the engine: gives brake torque and power.",
            "{ fmep = \"1.2 bar\" }",
        ),
        key(
            "flywheel",
            Kind::Table(&FLYWHEEL),
            Optional,
            "The flywheel, and how evenly the engine is to turn.",
            "{ inertia = \"0.15 kg m2\" }",
        ),
        key(
            "simulation",
            Kind::Table(&SIMULATION),
            Optional,
            "A run in time of the crank train as rigid bodies.",
            "{ duration = \"10 revolutions\" }",
        ),
        key(
            "load",
            Kind::Table(&LOAD),
            Optional,
            "What takes the power in a run.",
            "{ type = \"constant\", torque = \"95 N m\" }",
        ),
        key(
            "starter",
            Kind::Table(&STARTER),
            Optional,
            "What starts the engine in a run.",
            "{ stall_torque = \"12 N m\", free_speed = \"3000 rpm\", ratio = 10, until = \"350 rpm\" }",
        ),
        key(
            "governor",
            Kind::Table(&GOVERNOR),
            Optional,
            "What holds the speed of a run.",
            "{ speed = \"1500 rpm\", gain = \"0.02 1/rpm\", delay = \"20 ms\" }",
        ),
        key(
            "driveline",
            Kind::Tables(&DRIVELINE, MOST_LINKS),
            Optional,
            "Inertias behind the flywheel in a run and in torsional vibration, in order from the engine.",
            "[{ inertia = \"0.9 kg m2\", stiffness = \"1200 N m/rad\" }]",
        ),
        key(
            "torsion",
            Kind::Table(&TORSION),
            Optional,
            "Torsional vibration of the crankshaft.",
            "{ damping = { absolute = \"1.2 N m s/rad\" } }",
        ),
        key(
            "damper",
            Kind::Table(&DAMPER),
            Optional,
            "The damper of torsional vibration at the free end.",
            "{ type = \"viscous\", ring_inertia = \"0.0045 kg m2\", hub_inertia = \"0.0025 kg m2\", damping = \"6 N m s/rad\" }",
        ),
        key(
            "pendulum",
            Kind::Tables(&PENDULUM, MOST_PENDULUMS),
            Optional,
            "Centrifugal pendulums on the webs of a throw.",
            "[{ throw = 4, mass = \"0.4 kg\", pivot_radius = \"90 mm\", length = \"10 mm\" }]",
        ),
        key(
            "stress",
            Kind::Table(&STRESS),
            Optional,
            "Static cases of the crankshafts.",
            "{ case = [{ name = \"unit radial\", pin = 1, radial = \"-65 kN\" }] }",
        ),
        key(
            "tolerances",
            Kind::Table(&TOLERANCES),
            Optional,
            "What the parts of a production may be off.",
            "{ piston_mass = { plus_minus = \"1.5 g\" } }",
        ),
        key(
            "bearings",
            Kind::Table(&BEARINGS),
            Optional,
            "Sizes of the bearings, for the pressures on them.",
            "{ crankpin = { diameter = \"48 mm\", width = \"22 mm\" } }",
        ),
        key(
            "block",
            Kind::Table(&BLOCK),
            Optional,
            "The body that stands on the mounts.",
            "{ mass = \"140 kg\", centre = [\"80 mm\", \"0 mm\", \"40 mm\"], inertia = [\"9 kg m2\", \"8 kg m2\", \"5 kg m2\"] }",
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
            "For each cylinder the angle of crankshaft 1 at which it fires, counted from the firing of cylinder 1. A geared cylinder fires once in a working cycle of its \
             own crankshaft; any of its firings may be given.",
            "[\"0 deg\", \"180 deg\"]",
        ),
    ],
};
