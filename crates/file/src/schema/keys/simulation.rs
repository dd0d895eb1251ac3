//! A run in time: `[simulation]`, `[load]`, `[starter]`, `[governor]` and `[[driveline]]`.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Kind, Table};
use super::entry::{key, quantity};
use lanchester_units::Dimension::{
    Angle, AngularDamping, AngularStiffness, Energy, Inertia, Length, PerSpeed, Power, Rate, Speed,
    Stiffness, Time, Torque, Velocity,
};

/// Most inertias of a driveline, events of a run, and points of a table.
pub(super) const MOST_LINKS: usize = 8;
const MOST_EVENTS: usize = 64;
const MOST_POINTS: usize = 256;

/// Most named points of the block, and most gears with teeth.
const MOST_NAMED: usize = 32;

/// Where the reaction to a torque goes.
const GROUND_OR_BLOCK: &[&str] = &["ground", "block"];

pub(super) static SIMULATION: Table = Table {
    header: "[simulation]",
    doc: "A run in time of the crank train as rigid bodies. All keys have defaults, and options of the command go before them.",
    keys: &[
        key(
            "speed",
            Kind::Choice(&["free", "imposed"]),
            Optional,
            "Whether the torques set the speed (default), or a drive that takes whatever torque it needs.",
            "\"imposed\"",
        ),
        key(
            "imposed_against",
            Kind::Choice(&["block", "ground"]),
            Optional,
            "Whether an imposed speed is relative to the block (default) or absolute, which differs by the block's roll.",
            "\"ground\"",
        ),
        key(
            "imposed",
            Kind::Tables(&IMPOSED, MOST_POINTS),
            Optional,
            "Profile of an imposed speed: points that rise in time, straight between, constant before and behind.",
            "[{ at = \"0 s\", speed = \"800 rpm\" }, { at = \"2 s\", speed = \"3000 rpm\" }]",
        ),
        key(
            "start",
            Kind::Table(&START),
            Optional,
            "State at the start.",
            "{ speed = \"800 rpm\", angle = \"0 deg\", block = \"equilibrium\" }",
        ),
        key(
            "duration",
            Kind::Text(40),
            Optional,
            "A number of revolutions, a time, or \"periodic\": the motion that repeats, one period of it; default 10 revolutions.",
            "\"10 revolutions\"",
        ),
        key(
            "block",
            Kind::Choice(&["mounts", "fixed"]),
            Optional,
            "Whether the block moves on its mounts or stands still; default on its mounts where the file gives them in a form that a run in time can use.",
            "\"mounts\"",
        ),
        key(
            "gravity",
            Kind::Text(40),
            Optional,
            "\"on\" (default, 9.80665 m/s2), \"off\", or an acceleration; it acts on every body along `gravity` of [block].",
            "\"off\"",
        ),
        key(
            "gas",
            Kind::Choice(&["given", "states", "off"]),
            Optional,
            "Whether the pressures of [gas] act (default) or not; `\"states\"`: the bond graph has volume, mass and energy of the gas as states, other \
             runs take the pressures.",
            "\"given\"",
        ),
        quantity("step", Angle, Positive, "Crank angle between two samples; default 1 deg.", "\"1 deg\""),
        key(
            "tolerance",
            Kind::Number(Positive),
            Optional,
            "Relative tolerance of every step, from 1e-13 to 1e-2; default 1e-9.",
            "1e-9",
        ),
        key(
            "tolerances",
            Kind::Table(&TOLERANCES),
            Optional,
            "Absolute tolerances by kind of state, where they are not to follow from `tolerance`.",
            "{ speed = \"1e-6 rad/s\", displacement = \"1e-6 mm\" }",
        ),
        key(
            "guidance",
            Kind::Choice(&["crankpin", "piston"]),
            Optional,
            "Which pin guides the rods along the crank axis: where a rod's loads out of its plane are taken; default crankpin.",
            "\"piston\"",
        ),
        key(
            "mains",
            Kind::Choice(&["cut", "springs", "beam"]),
            Optional,
            "By which rule main bearings share what a rigid shaft on more than two leaves open, in tables of one rule and pictures: the shaft cut at every main (default), a rigid shaft on springs, a continuous beam. All three are in the result.",
            "\"beam\"",
        ),
        key(
            "main_stiffness",
            Kind::Quantities(Stiffness, Positive),
            Optional,
            "Stiffness of every main bearing of crankshaft 1 for loads shared by the rule `springs`; default all alike.",
            "[\"1000 kN/mm\", \"800 kN/mm\", \"1000 kN/mm\"]",
        ),
        key(
            "torque",
            Kind::Tables(&TORQUE_ORDER, MOST_POINTS),
            Optional,
            "Torque on crankshaft 1 over its angle, from the ground, as a sum of orders, or from a file: [{ file = \"torque.csv\" }]; instead of the gas or beside it.",
            "[{ order = 0, cos = \"60 N m\" }, { order = 0.5, sin = \"150 N m\" }]",
        ),
        key(
            "crankshaft",
            Kind::Choice(&["unbalances", "body"]),
            Optional,
            "Whether the crankshafts turn as their unbalances and polar inertia say (default), or as the bodies of [crank.body], with centre, products of inertia and unlike inertias across the axis.",
            "\"body\"",
        ),
        key(
            "point",
            Kind::Tables(&POINT, MOST_NAMED),
            Optional,
            "Points of the block whose motion the result gives.",
            "[{ name = \"top of the head\", x = \"350 mm\", y = \"0 mm\", z = \"0 mm\" }]",
        ),
        key(
            "mesh",
            Kind::Tables(&MESH, MOST_NAMED),
            Optional,
            "External spur gears by which crankshaft 1 drives other shafts: their force along the line of action, which the bearings carry.",
            "[{ shaft = \"balance shaft\", pressure_angle = \"20 deg\", z = \"-60 mm\" }]",
        ),
        key(
            "event",
            Kind::Tables(&EVENT, MOST_EVENTS),
            Optional,
            "What happens on the way.",
            "[{ when = \"3 revolutions\", do = \"misfire 3\" }]",
        ),
    ],
};

static IMPOSED: Table = Table {
    header: "[[simulation.imposed]]",
    doc: "A point of an imposed speed.",
    keys: &[
        key("at", Kind::Quantity(Time, NotNegative), Required, "Time since the start.", "\"0 s\""),
        key("speed", Kind::Quantity(Speed, NotNegative), Required, "Speed of crankshaft 1.", "\"800 rpm\""),
    ],
};

static START: Table = Table {
    header: "[simulation.start]",
    doc: "State at the start of a run.",
    keys: &[
        quantity(
            "speed",
            Speed,
            NotNegative,
            "Speed of crankshaft 1; default the highest of the file.",
            "\"800 rpm\"",
        ),
        quantity("angle", Angle, Any, "Crank angle; default 0.", "\"0 deg\""),
        key(
            "block",
            Kind::Choice(&["equilibrium", "as drawn"]),
            Optional,
            "Whether the block stands where its mounts carry weight and mean torque (default), or in the position of the file.",
            "\"equilibrium\"",
        ),
    ],
};

static TOLERANCES: Table = Table {
    header: "[simulation.tolerances]",
    doc: "Absolute tolerances of a run's steps by kind of state.",
    keys: &[
        quantity("angle", Angle, Positive, "Of the angles of crank and driveline.", "\"1e-9 rad\""),
        quantity("speed", Speed, Positive, "Of their speeds.", "\"1e-6 rad/s\""),
        quantity("displacement", Length, Positive, "Of the place of the block.", "\"1e-6 mm\""),
        quantity("turn", Angle, Positive, "Of the turn of the block.", "\"1e-9 rad\""),
        quantity("velocity", Velocity, Positive, "Of its velocity.", "\"1e-4 mm/s\""),
        quantity("spin", Speed, Positive, "Of its angular velocity.", "\"1e-7 rad/s\""),
        quantity("energy", Energy, Positive, "Of works.", "\"1e-6 J\""),
    ],
};

static POINT: Table = Table {
    header: "[[simulation.point]]",
    doc: "A point of the block.",
    keys: &[
        key("name", Kind::Text(80), Required, "Its name in tables and pictures.", "\"top of the head\""),
        quantity("x", Length, Any, "Its place; default 0.", "\"350 mm\""),
        quantity("y", Length, Any, "Its place; default 0.", "\"0 mm\""),
        quantity("z", Length, Any, "Its place along the crank axis; default 0.", "\"0 mm\""),
    ],
};

static MESH: Table = Table {
    header: "[[simulation.mesh]]",
    doc: "External spur gears between crankshaft 1 and a shaft that it drives directly, which turns the other way.",
    keys: &[
        key(
            "shaft",
            Kind::Text(80),
            Required,
            "Name of the driven crankshaft, balance shaft or gear.",
            "\"balance shaft\"",
        ),
        key(
            "pressure_angle",
            Kind::Quantity(Angle, NotNegative),
            Required,
            "Angle between the line of action and the common tangent of the pitch circles, up to 45 deg.",
            "\"20 deg\"",
        ),
        key("z", Kind::Quantity(Length, Any), Required, "Middle plane of the teeth.", "\"-60 mm\""),
    ],
};

static TORQUE_ORDER: Table = Table {
    header: "[[simulation.torque]]",
    doc: "One order of a torque over the crank angle: `sin sin(order theta) + cos cos(order theta)`; or a whole curve from a file. Negative torque brakes.",
    keys: &[
        key("order", Kind::Order, Optional, "The order; 0 is the mean. Needed without `file`.", "0.5"),
        quantity("sin", Torque, Any, "Factor of the sine; default 0.", "\"150 N m\""),
        quantity("cos", Torque, Any, "Factor of the cosine; default 0.", "\"60 N m\""),
        key(
            "file",
            Kind::Text(200),
            Optional,
            "A CSV file beside the engine file with the angle of crankshaft 1 and the torque on it, each headed with its unit, such as `theta [deg]` and `torque [N m]`, over one period; \
             between the samples the torque is the periodic cubic spline, of which the orders up to the 64th of the period act.",
            "\"torque.csv\"",
        ),
        quantity(
            "period",
            Angle,
            Positive,
            "Angle after which the torque of a file repeats; default as many whole revolutions as its angles span.",
            "\"720 deg\"",
        ),
    ],
};

static EVENT: Table = Table {
    header: "[[simulation.event]]",
    doc: "Something that happens once, at a time, at an angle, or when the speed passes a value.",
    keys: &[
        key(
            "when",
            Kind::Text(80),
            Required,
            "A time, an angle or a number of revolutions from the start, or \"speed falls to\" and \"speed rises to\" a speed.",
            "\"3 revolutions\"",
        ),
        key(
            "do",
            Kind::Text(80),
            Required,
            "\"misfire\" and the number of a cylinder, which fires no more; \"fuel\" and a share, of all cylinders; \"load\" and a torque; \
             \"clutch open\"; \"stop\".",
            "\"misfire 3\"",
        ),
    ],
};

pub(super) static LOAD: Table = Table {
    header: "[load]",
    doc: "What takes the power in a run, at the end of the driveline. Default with gas: constant, the mean that the engine gives at the start speed; of a periodic motion in proportion to the speed.",
    keys: &[
        key(
            "type",
            Kind::Choice(&["constant", "viscous", "quadratic", "power", "table", "none"]),
            Required,
            "Law of its torque against the rotation: constant, proportional to the speed or to its square, of constant power, or a table over the speed or over the angle.",
            "\"constant\"",
        ),
        quantity(
            "torque",
            Torque,
            NotNegative,
            "Torque; of a viscous or quadratic load that at the speed `at`.",
            "\"95 N m\"",
        ),
        quantity(
            "at",
            Speed,
            Positive,
            "Speed at which a viscous or quadratic load takes `torque`.",
            "\"2000 rpm\"",
        ),
        quantity("power", Power, NotNegative, "Power of a load of constant power.", "\"15 kW\""),
        quantity(
            "least_speed",
            Speed,
            Positive,
            "Speed below which the torque of a load of constant power stays what it is there.",
            "\"300 rpm\"",
        ),
        key(
            "table",
            Kind::Tables(&LOAD_POINT, MOST_POINTS),
            Optional,
            "Points of a table, straight between: all with `speed` (constant beyond), all with `angle` (repeating), or all with both: then for each speed in turn the angles.",
            "[{ speed = \"1000 rpm\", torque = \"50 N m\" }, { speed = \"3000 rpm\", torque = \"90 N m\" }]",
        ),
        quantity(
            "period",
            Angle,
            Positive,
            "Angle after which a table over the angle repeats; default 360 deg.",
            "\"360 deg\"",
        ),
        key(
            "reacts_on",
            Kind::Choice(GROUND_OR_BLOCK),
            Optional,
            "Where its reaction goes: the ground (default), or the block, as of a generator or pump that is bolted to the engine.",
            "\"block\"",
        ),
    ],
};

static LOAD_POINT: Table = Table {
    header: "[[load.table]]",
    doc: "A point of the torque of a load.",
    keys: &[
        quantity("speed", Speed, NotNegative, "Speed of the shaft that it sits on.", "\"1000 rpm\""),
        quantity("angle", Angle, NotNegative, "Angle of the shaft that it sits on.", "\"90 deg\""),
        key("torque", Kind::Quantity(Torque, Any), Required, "Torque against the rotation.", "\"50 N m\""),
    ],
};

pub(super) static STARTER: Table = Table {
    header: "[starter]",
    doc: "What starts the engine: its torque falls with the speed in a straight line, and it lets go at a speed.",
    keys: &[
        key(
            "stall_torque",
            Kind::Quantity(Torque, Positive),
            Required,
            "Torque of the starter at standstill.",
            "\"12 N m\"",
        ),
        key(
            "free_speed",
            Kind::Quantity(Speed, Positive),
            Required,
            "Speed of the starter without torque.",
            "\"3000 rpm\"",
        ),
        key(
            "ratio",
            Kind::Number(Positive),
            Required,
            "Speed of the starter over that of crankshaft 1.",
            "10",
        ),
        key(
            "until",
            Kind::Quantity(Speed, Positive),
            Required,
            "Speed of crankshaft 1 at which it lets go.",
            "\"350 rpm\"",
        ),
        key(
            "reacts_on",
            Kind::Choice(GROUND_OR_BLOCK),
            Optional,
            "Where its reaction goes; default the block.",
            "\"block\"",
        ),
    ],
};

pub(super) static GOVERNOR: Table = Table {
    header: "[governor]",
    doc: "What holds the speed of a run: it scales the fired part of the gas by a factor from 0 to 1. Needs `[gas]`.",
    keys: &[
        key(
            "speed",
            Kind::Quantity(Speed, Positive),
            Required,
            "Speed that it holds without load.",
            "\"1500 rpm\"",
        ),
        key(
            "gain",
            Kind::Quantity(PerSpeed, NotNegative),
            Required,
            "Change of the factor for each unit of speed below that.",
            "\"0.02 1/rpm\"",
        ),
        quantity(
            "integral",
            Rate,
            NotNegative,
            "Reciprocal of the reset time of the integral part; default 0: none.",
            "\"0.5 1/s\"",
        ),
        key(
            "droop",
            Kind::Share,
            Optional,
            "Drop of the speed that it holds from no load to full load; default 0.",
            "\"4 %\"",
        ),
        quantity(
            "delay",
            Time,
            NotNegative,
            "Dead time: what it commands reaches the gas so much later; default 0.",
            "\"20 ms\"",
        ),
        quantity(
            "lag",
            Time,
            NotNegative,
            "Time constant of its actuator, a lag of first order behind the dead time; default 0.",
            "\"50 ms\"",
        ),
        key("start", Kind::Share, Optional, "Factor at the start; default 0.", "\"30 %\""),
    ],
};

pub(super) static DRIVELINE: Table = Table {
    header: "[[driveline]]",
    doc: "An inertia behind the flywheel, on a torsional spring: clutch, dual-mass flywheel, shaft of a brake. In order from the engine.",
    keys: &[
        key(
            "inertia",
            Kind::Quantity(Inertia, Positive),
            Required,
            "Moment of inertia about its axis.",
            "\"0.9 kg m2\"",
        ),
        key(
            "stiffness",
            Kind::Quantity(AngularStiffness, NotNegative),
            Required,
            "Torsional stiffness of the spring before it.",
            "\"1200 N m/rad\"",
        ),
        quantity(
            "damping",
            AngularDamping,
            NotNegative,
            "Viscous damping of that spring; default 0.",
            "\"3 N m s/rad\"",
        ),
        key(
            "ratio",
            Kind::Number(Any),
            Optional,
            "Its speed over that of what is before it, not 0; default 1.",
            "1",
        ),
    ],
};
