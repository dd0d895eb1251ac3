//! Torsional vibration: `[torsion]`, `[[torsion.branch]]`, `[damper]` and `[[pendulum]]`.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Kind, Table};
use super::entry::{MOST_THROWS, key, quantity};
use lanchester_units::Dimension::{Angle, AngularDamping, AngularStiffness, Inertia, Length, Mass, Pressure};

/// Most branches and sets of pendulums.
const MOST_BRANCHES: usize = 16;
pub(super) const MOST_PENDULUMS: usize = 32;

pub(super) static TORSION: Table = Table {
    header: "[torsion]",
    doc: "Torsional vibration of the crankshaft with what it drives. Inertias come from `[crank.body]`, rods, pistons and `[flywheel]`, stiffnesses from \
          `[crank.body]` and `[crank.material]` by Ker Wilson's lengths; what is behind the flywheel is `[[driveline]]`.",
    keys: &[
        key(
            "stiffness",
            Kind::Quantities(AngularStiffness, Positive),
            Optional,
            "Stiffnesses of the crankshaft from the free end on, instead of those of its sizes: with `[damper]` or `nose_inertia` the piece from the nose to throw 1 \
             first, then each piece from a throw to the next one, last the piece from the last throw to the flywheel. Of several crankshafts one after the \
             other, each in the order of its throws along z.",
            "[\"0.6 MN m/rad\", \"0.9 MN m/rad\"]",
        ),
        key(
            "damping",
            Kind::Table(&DAMPING),
            Optional,
            "Damping of the crankshaft.",
            "{ absolute = \"1.2 N m s/rad\", loss_factor = 0.01 }",
        ),
        quantity(
            "nose_inertia",
            Inertia,
            NotNegative,
            "Inertia at the free end beside the damper: pulley, wheel of the timing drive.",
            "\"0.002 kg m2\"",
        ),
        key(
            "gears",
            Kind::Choice(&["nose", "flywheel"]),
            Optional,
            "End of crankshaft 1 at which balance shafts and gears are driven; default the nose.",
            "\"flywheel\"",
        ),
        key(
            "highest_order",
            Kind::Number(Positive),
            Optional,
            "Highest order of the torques that is taken, from 1 to 60; default 12.",
            "12",
        ),
        quantity(
            "twist_limit",
            Angle,
            Positive,
            "Largest amplitude of the twist between nose and flywheel that is allowed.",
            "\"0.25 deg\"",
        ),
        quantity(
            "stress_limit",
            Pressure,
            Positive,
            "Largest amplitude of the vibratory shear stress, nominal at the surface of the weakest journal or pin, that is allowed.",
            "\"40 MPa\"",
        ),
        key(
            "branch",
            Kind::Tables(&BRANCH, MOST_BRANCHES),
            Optional,
            "Inertias on shafts of their own beside the driveline.",
            "[{ name = \"fan\", at = \"nose\", inertia = \"0.02 kg m2\", stiffness = \"4 kN m/rad\" }]",
        ),
    ],
};

static DAMPING: Table = Table {
    header: "[torsion.damping]",
    doc: "Damping of the crankshaft in torsion.",
    keys: &[
        quantity(
            "absolute",
            AngularDamping,
            NotNegative,
            "Damping of each throw against the ground; default 0.",
            "\"1.2 N m s/rad\"",
        ),
        quantity(
            "relative",
            AngularDamping,
            NotNegative,
            "Damping of the twist of each piece of the crankshaft; default 0.",
            "\"5 N m s/rad\"",
        ),
        key(
            "loss_factor",
            Kind::Share,
            Optional,
            "Loss factor of the crankshaft; default that of `[crank.material]`.",
            "0.01",
        ),
    ],
};

static BRANCH: Table = Table {
    header: "[[torsion.branch]]",
    doc: "An inertia on a torsional spring of its own, beside the driveline: an accessory, a generator at the free end.",
    keys: &[
        key("name", Kind::Text(60), Optional, "Its name; default \"branch 1\" and so on.", "\"fan\""),
        key(
            "at",
            Kind::Text(60),
            Required,
            "What drives it: \"nose\", \"flywheel\", \"throw 2\", or the name of a branch above it.",
            "\"nose\"",
        ),
        key(
            "inertia",
            Kind::Quantity(Inertia, Positive),
            Required,
            "Moment of inertia about its axis.",
            "\"0.02 kg m2\"",
        ),
        key(
            "stiffness",
            Kind::Quantity(AngularStiffness, Positive),
            Required,
            "Stiffness of the shaft before it, at its own speed.",
            "\"4 kN m/rad\"",
        ),
        quantity(
            "damping",
            AngularDamping,
            NotNegative,
            "Damping of that shaft; default 0.",
            "\"0.5 N m s/rad\"",
        ),
        key(
            "ratio",
            Kind::Number(Any),
            Optional,
            "Its speed over that of what drives it, not 0; default 1.",
            "1.8",
        ),
    ],
};

pub(super) static DAMPER: Table = Table {
    header: "[damper]",
    doc: "A damper of torsional vibration at the free end of crankshaft 1: a ring that runs in a viscous fluid, or is bonded to its hub by rubber.",
    keys: &[
        key("type", Kind::Choice(&["viscous", "rubber"]), Required, "Its kind.", "\"viscous\""),
        key(
            "ring_inertia",
            Kind::Quantity(Inertia, Positive),
            Required,
            "Moment of inertia of the ring.",
            "\"0.0045 kg m2\"",
        ),
        key(
            "hub_inertia",
            Kind::Quantity(Inertia, Positive),
            Required,
            "Moment of inertia of hub and housing.",
            "\"0.0025 kg m2\"",
        ),
        quantity(
            "damping",
            AngularDamping,
            Positive,
            "Viscous damping between ring and hub; a viscous damper needs it.",
            "\"6 N m s/rad\"",
        ),
        quantity(
            "stiffness",
            AngularStiffness,
            Positive,
            "Stiffness between ring and hub; a rubber damper needs it, a viscous one may have it.",
            "\"9 kN m/rad\"",
        ),
        key(
            "loss_factor",
            Kind::Share,
            Optional,
            "Loss factor of that stiffness; a rubber damper needs it.",
            "0.2",
        ),
    ],
};

pub(super) static PENDULUM: Table = Table {
    header: "[[pendulum]]",
    doc: "Equal centrifugal pendulums on the webs of a throw: they take away the order `sqrt(pivot_radius / length)`.",
    keys: &[
        key("throw", Kind::Whole(1, MOST_THROWS), Required, "Number of the throw.", "4"),
        key("mass", Kind::Quantity(Mass, Positive), Required, "Mass of one.", "\"0.4 kg\""),
        key(
            "pivot_radius",
            Kind::Quantity(Length, Positive),
            Required,
            "Distance of its pivot from the crank axis; of a bifilar one that of its centre of mass less `length`.",
            "\"90 mm\"",
        ),
        key(
            "length",
            Kind::Quantity(Length, Positive),
            Required,
            "Distance of its centre of mass from the pivot; of a bifilar one the diameter of the hole less that of the roller.",
            "\"10 mm\"",
        ),
        key("number", Kind::Whole(1, 64), Optional, "How many; default 1.", "2"),
        quantity(
            "damping",
            AngularDamping,
            NotNegative,
            "Viscous damping of its swing; default 0.",
            "\"0.002 N m s/rad\"",
        ),
    ],
};
