//! What may be done to balance the engine.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{MOST_CRANKSHAFTS, MOST_SHAFTS, MOST_THROWS, MOST_WEIGHTS, key, quantity};
use lanchester_task::WHAT_FITS;
use lanchester_units::Dimension::{Angle, Density, Inertia, Length, Speed, Unbalance};

/// Optional devices of a file: weights, shafts and their weights, inertias.
const MOST_OPTIONAL: i64 = 1000;
const MOST_INERTIAS: usize = 16;
/// Speeds at which loads are judged.
const MOST_SPEEDS: usize = 100;

pub(super) static BALANCE: Table = Table {
    header: "[balance]",
    doc: "What may be done to balance the engine, and what is wanted. A free weight or shaft that has the name of a \
          weight or shaft of the engine stands in its place. Without any device, every counterweight of the engine is \
          free; if it has none, there is one on every web, or on every throw where a web distance is missing.\n\n\
          A criterion is the peak over the cycle, at the highest speed, of `force`, `force x`, `force y`, `couple`, \
          `couple x`, `couple y`, `roll moment`, `mount force` (the largest of all mounts), `mount force NAME`, both of inertia alone or with the \
          torque of the gas about its mean on mounts with stiffness (`mount force with gas`, `mount force NAME with gas`), \
          `main-bearing load` (the largest of all main bearings, inertia alone), `main-bearing load 3` or `bending moment`; \
          one order of it with ` order 2` or ` order 0.5` behind; the root mean square over the cycle \
          `main-bearing load rms` (all main bearings together), `main-bearing load 3 rms` or \
          `largest main-bearing load rms`, the mean `main-bearing load mean` or `main-bearing load 3 mean`; any of these with \
          the gas of the file, `main-bearing load with gas`, `main-bearing load 3 rms with gas`; or \
          `added mass`, `added unbalance` or `cost` of the free weights (and shafts). Main bearings are numbered from the free end on, those of \
          crankshaft 1 first. A higher speed raises all loads of inertia, but neither the forces at mounts with stiffness nor \
          loads with gas: these count over the whole range of speeds, or at `speeds`, the largest of all.",
    keys: &[
        key(
            "minimise",
            Kind::Stages,
            Optional,
            "Criteria in order of priority, each next one without degrading the previous ones; default force, then couple. \
             Among equals: of force and couple what is not named; then, if a weight on a crankshaft is free, \
             `main-bearing load rms`, `main-bearing load`, `bending moment`; then the lightest. Several at once stand in a table, each with the value that counts as much as those of the others: their \
             shares of these values are added.",
            "[\"force\", { couple = \"10 N m\", \"roll moment\" = \"40 N m\" }]",
        ),
        key(
            "give_up",
            Kind::GiveUps,
            Optional,
            "What stages after it may cost a stage: criteria of `minimise` (or `force` and `couple` where it is left out), each \
             with a share of the least value that it reached, or an amount in its unit. A weighted sum goes by any of its \
             criteria and takes a share. Default nothing.",
            "{ force = \"1 %\" }",
        ),
        key(
            "limits",
            Kind::Limits,
            Optional,
            "Criteria and the largest value of each.",
            "{ couple = \"5 N m\", \"force order 1\" = \"200 N\" }",
        ),
        key(
            "at_least",
            Kind::AtLeast,
            Optional,
            "Oil films and safeties that must not fall below a value: `least film` (of all main and big-end bearings over the cycle), \
             `main-bearing film`, `main-bearing film 3`, `crankpin film 2`, `rule safety` (UR M53). The optimum \
             of `minimise` is found and proved first; where it does not hold one of these, a local search moves its weights, without a global optimum.",
            "{ \"main-bearing film\" = \"2 um\", \"rule safety\" = 1.3 }",
        ),
        key(
            "maximise",
            Kind::Durabilities,
            Optional,
            "Oil films and safeties that a local search makes large after the optimum of `minimise`, in order of priority, without raising any stage beyond \
             what `give_up` allows.",
            "[\"main-bearing film\"]",
        ),
        key(
            "budget",
            Kind::Number(NotNegative),
            Optional,
            "Largest cost of all weights and shafts that are used, in the unit of their costs.",
            "40",
        ),
        key(
            "cancel",
            Kind::Orders,
            Optional,
            "Orders of loads that must vanish exactly, instead of `minimise` and `limits`; of all weights that do it those with the least \
             force, couple and main-bearing loads, then the lightest.",
            "[\"force order 1\", \"couple order 1\"]",
        ),
        key(
            "most_optional",
            Kind::Whole(0, MOST_OPTIONAL),
            Optional,
            "Most of the optional weights, shafts and inertias that may be used at once; default all.",
            "2",
        ),
        key(
            "speeds",
            Kind::ValuesOrTables(&JUDGED_SPEED, MOST_SPEEDS),
            Optional,
            "Speeds at which forces at mounts with springs and loads with gas are judged, the largest of all counting, each times the \
             weight of its speed; default the whole range of `speed`, resonances included, with weight 1. All other loads are largest \
             at the highest speed.",
            "[\"1500 rpm\", { speed = \"3000 rpm\", weight = 2 }]",
        ),
        key(
            "counterweight",
            Kind::Tables(&FREE_COUNTERWEIGHT, MOST_WEIGHTS),
            Optional,
            "Weights on the crankshafts that are to be found.",
            "[{ web = 1 }]",
        ),
        key(
            "shaft",
            Kind::Tables(&FREE_SHAFT, MOST_SHAFTS),
            Optional,
            "Balance shafts that may be fitted.",
            "[{ ratio = -1, weights = [{ z = \"0 mm\" }] }]",
        ),
        key(
            "inertia",
            Kind::Tables(&FREE_INERTIA, MOST_INERTIAS),
            Optional,
            "Inertias geared to turn against crankshaft 1: they take part of the roll moment.",
            "[{ ratio = 2, crank_inertia = \"0.2 kg m2\" }]",
        ),
    ],
};

static JUDGED_SPEED: Table = Table {
    header: "[[balance.speeds]]",
    doc: "A speed at which forces at mounts with springs and loads with gas are judged; without a weight its value may stand alone.",
    keys: &[
        Key {
            need: Required,
            ..quantity("speed", Speed, Positive, "Speed of crankshaft 1.", "\"3000 rpm\"")
        },
        key(
            "weight",
            Kind::Number(Positive),
            Optional,
            "What loads at this speed are multiplied by before the largest counts, in objectives and limits; default 1.",
            "2",
        ),
    ],
};

const LINE: Key = quantity(
    "line",
    Angle,
    Any,
    "Instead of a direction: along this direction or opposite to it, whichever is better.",
    "\"180 deg\"",
);
const LEAST: Key = quantity(
    "least",
    Unbalance,
    NotNegative,
    "Least amount (of an optional one: if it is used).",
    "\"0.01 kg m\"",
);
const MOST: Key = key(
    "most",
    Kind::QuantityOrWord(Unbalance, Positive, WHAT_FITS),
    Optional,
    "Largest amount; needed if it is optional or stands at a place to be found. `\"what fits\"`: the largest unbalance that the shapes of \
     `[counterweight_design]` and the wanted clearance allow on its web; that is the default where the file has `[crank.body]` and \
     `[counterweight_design]`.",
    "\"0.1 kg m\"",
);
const MOST_ON_SHAFT: Key = quantity(
    "most",
    Unbalance,
    Positive,
    "Largest amount; needed if it is optional, stands on an optional shaft or at a place to be found.",
    "\"0.1 kg m\"",
);
const GIVEN: Key =
    quantity("unbalance", Unbalance, Positive, "Instead of `least` and `most`: its amount.", "\"0.05 kg m\"");
const RADIUS: Key = quantity(
    "radius",
    Length,
    Positive,
    "Distance of its centre of gravity from the axis; needed for `added mass`.",
    "\"60 mm\"",
);
const STEP: Key = key(
    "step",
    Kind::Amounts,
    Optional,
    "It is made in whole steps of this: a mass at `radius`, or an unbalance. None at all is allowed too, unless `least` says more.",
    "\"5 g\"",
);
const CATALOGUE: Key = key(
    "catalogue",
    Kind::Amounts,
    Optional,
    "It is one of these, or left away: masses at `radius`, or unbalances.",
    "[\"120 g\", \"150 g\", \"180 g\"]",
);
const DRILL: Key = key(
    "drill",
    Kind::Table(&DRILLED),
    Optional,
    "Instead of `step` or `catalogue`: it is one drilled hole, or a slug of heavy metal in one, or left away. Its direction, where it is \
     given, is that of the hole; the answer tells drill and depth.",
    "{ direction = \"radial\", radius = \"60 mm\", max_depth = \"25 mm\", density = \"7.85 g/cm3\" }",
);
static DRILLED: Table = Table {
    header: "drill",
    doc: "Holes of which a weight is one. An empty hole is as a weight on the opposite side; a slug adds what it weighs beyond the metal that \
          was drilled away.",
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
            "radius",
            Kind::Quantity(Length, Positive),
            Required,
            "Radius of the surface that is drilled radially, or of the circle of axial holes.",
            "\"60 mm\"",
        ),
        key(
            "diameters",
            Kind::Quantities(Length, Positive),
            Optional,
            "Diameters of the drills; default whole and half millimetres from 1 mm to 20 mm.",
            "[\"8 mm\", \"10 mm\", \"12 mm\"]",
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
            "Depths to the end of the full diameter are multiples of this; default 1 mm.",
            "\"0.5 mm\"",
        ),
        quantity("point", Angle, Positive, "Angle of the drill point; default 118 deg.", "\"118 deg\""),
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density of what is drilled.",
            "\"7.85 g/cm3\"",
        ),
        quantity(
            "slug_density",
            Density,
            Positive,
            "Density of the slug that fills the hole but for its point, flush with the surface; default none, an empty hole.",
            "\"18 g/cm3\"",
        ),
    ],
};
const EQUAL_PARTS: Key = key(
    "equal_parts",
    Kind::Text(100),
    Optional,
    "Name of the part that it is: all weights with this name that are used have the same amount, each in its own direction. With `step` or \
     `catalogue`, the same for all of them.",
    "\"web weight\"",
);
const FIXED_COST: Key = key(
    "fixed_cost",
    Kind::Number(NotNegative),
    Optional,
    "What it costs if it is used, whatever its amount: money, minutes or grams, as `budget` counts; default 0.",
    "3.5",
);
const COST_PER_KG: Key = key(
    "cost_per_kg",
    Kind::Number(NotNegative),
    Optional,
    "What a kilogram of it costs at `radius`; default 0.",
    "12",
);
const COST_PER_KG_M: Key = key(
    "cost_per_kg_m",
    Kind::Number(NotNegative),
    Optional,
    "Instead of `cost_per_kg`: what a kilogram metre of its unbalance costs.",
    "200",
);
const OPTIONAL: Key =
    key("optional", Kind::Truth, Optional, "Whether it may be left out; default false.", "true");
const EQUAL_TO: Key = key(
    "equal_to",
    Kind::Text(100),
    Optional,
    "It follows the free weight of this name, in amount and in direction when throw 1 points along +x; bounds and \
     direction are that one's.",
    "\"front\"",
);
const OPPOSED_TO: Key =
    key("opposed_to", Kind::Text(100), Optional, "As `equal_to`, in the opposite direction.", "\"front\"");
const MIRRORED_TO: Key = key(
    "mirrored_to",
    Kind::Text(100),
    Optional,
    "As `equal_to`, with the direction mirrored in the plane of x and z.",
    "\"front\"",
);
const FACTOR: Key = key(
    "factor",
    Kind::Number(Any),
    Optional,
    "With `equal_to`, `opposed_to` or `mirrored_to`: times this number, not 0; default 1.",
    "0.5",
);

/// The keys of a free weight, one list for crankshafts and balance shafts: its own first, then what all have, `most` among it.
macro_rules! weight_keys {
    ($most:expr, $($own:expr),* $(,)?) => {
        &[
            $($own,)*
            LINE,
            LEAST,
            $most,
            GIVEN,
            RADIUS,
            STEP,
            CATALOGUE,
            DRILL,
            EQUAL_PARTS,
            FIXED_COST,
            COST_PER_KG,
            COST_PER_KG_M,
            OPTIONAL,
            EQUAL_TO,
            OPPOSED_TO,
            MIRRORED_TO,
            FACTOR,
        ]
    };
}

pub(super) static FREE_COUNTERWEIGHT: Table = Table {
    header: "[[balance.counterweight]]",
    doc: "A weight on a crankshaft whose amount and direction are to be found: at a throw, on a web, or anywhere along \
          z.",
    keys: weight_keys!(
        MOST,
        key(
            "name",
            Kind::Text(100),
            Optional,
            "Its name; default \"throw 1\", \"web 1\" or, with `z`, \"free weight 1\". With `throws` or `webs`: the \
             beginning of the names.",
            "\"front\"",
        ),
        key("throw", Kind::Whole(1, MOST_THROWS), Optional, "In the plane of this throw.", "1"),
        key("throws", Kind::Choice(&["all"]), Optional, "One in the plane of every throw.", "\"all\""),
        key("web", Kind::Whole(1, 2 * MOST_THROWS), Optional, "On this web.", "1"),
        key("webs", Kind::Choice(&["all"]), Optional, "One on every web.", "\"all\""),
        key(
            "z",
            Kind::QuantityOrPair(Length, Any),
            Optional,
            "In this plane, or in one to be found between two.",
            "[\"-50 mm\", \"50 mm\"]",
        ),
        key(
            "crankshaft",
            Kind::Whole(1, MOST_CRANKSHAFTS),
            Optional,
            "With `z`: number of the crankshaft; default 1.",
            "1",
        ),
        quantity(
            "angle",
            Angle,
            Any,
            "Its direction, if that is given: at a throw or on a web from the throw, with `z` from the crankshaft's \
             zero.",
            "\"180 deg\"",
        ),
    ),
};

static FREE_SHAFT: Table = Table {
    header: "[[balance.shaft]]",
    doc: "A balance shaft that may be fitted.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name; default \"free shaft 1\".", "\"lower\""),
        key(
            "ratio",
            Kind::Ratio,
            Required,
            "Speed over that of crankshaft 1; negative turns the other way.",
            "-1",
        ),
        key(
            "x",
            Kind::QuantityOrPair(Length, Any),
            Optional,
            "Place of its axis, or one to be found between two; default 0.",
            "[\"-80 mm\", \"80 mm\"]",
        ),
        FIXED_COST,
        key(
            "y",
            Kind::QuantityOrPair(Length, Any),
            Optional,
            "Place of its axis, or one to be found between two; default 0.",
            "\"100 mm\"",
        ),
        OPTIONAL,
        key(
            "weights",
            Kind::Tables(&FREE_SHAFT_WEIGHT, MOST_WEIGHTS),
            Required,
            "Its weights.",
            "[{ z = \"0 mm\", most = \"0.02 kg m\" }]",
        ),
    ],
};

static FREE_SHAFT_WEIGHT: Table = Table {
    header: "[[balance.shaft.weights]]",
    doc: "A weight on a balance shaft that may be fitted.",
    keys: weight_keys!(
        MOST_ON_SHAFT,
        key(
            "name",
            Kind::Text(100),
            Optional,
            "Its name; default that of the shaft with its number behind, such as \"lower 1\".",
            "\"lower front\"",
        ),
        key(
            "z",
            Kind::QuantityOrPair(Length, Any),
            Required,
            "Its plane, or one to be found between two.",
            "\"0 mm\"",
        ),
        quantity(
            "phase",
            Angle,
            Any,
            "Its direction when throw 1 points along +x, if that is given.",
            "\"180 deg\"",
        ),
    ),
};

static FREE_INERTIA: Table = Table {
    header: "[[balance.inertia]]",
    doc: "An inertia geared to turn against crankshaft 1, such as a flywheel or an alternator.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name; default \"inertia 1\".", "\"alternator\""),
        key(
            "ratio",
            Kind::Number(Positive),
            Required,
            "Its speed over that of crankshaft 1, as a positive number.",
            "2.5",
        ),
        key(
            "crank_inertia",
            Kind::Quantity(Inertia, Positive),
            Optional,
            "Inertia of everything that turns with crankshaft 1, flywheel included; default what `[flywheel]` and `[crank.body]` give, which it must not contradict.",
            "\"0.2 kg m2\"",
        ),
        quantity("most", Inertia, Positive, "Largest inertia; needed if it is optional.", "\"0.02 kg m2\""),
        OPTIONAL,
    ],
};
