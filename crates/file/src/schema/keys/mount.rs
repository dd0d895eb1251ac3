//! The block and its mounts.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Key, Kind, Table};
use super::entry::{key, quantity};
use lanchester_units::Dimension::{Damping, Force, Inertia, Length, Mass, Speed, Stiffness, Torque};

pub(super) static BLOCK: Table = Table {
    header: "[block]",
    doc: "The body that stands on the mounts: engine, gearbox and all that is bolted to them.",
    keys: &[
        key("mass", Kind::Quantity(Mass, Positive), Required, "Mass.", "\"140 kg\""),
        key(
            "centre",
            Kind::Quantities(Length, Any),
            Required,
            "Centre of mass: x, y and z.",
            "[\"80 mm\", \"0 mm\", \"40 mm\"]",
        ),
        key(
            "inertia",
            Kind::Quantities(Inertia, Any),
            Required,
            "Moments of inertia about the centre, axes of the frame: xx, yy and zz; then, if given, the products xy, yz and \
             zx, as sums of x y dm (the elements of the tensor are their negatives).",
            "[\"9 kg m2\", \"8 kg m2\", \"5 kg m2\"]",
        ),
        key(
            "moving_parts",
            Kind::Choice(&["included", "added"]),
            Optional,
            "Whether these numbers hold pistons and rods (default), or they are to be added at their mean places. \
             Crankshafts and balance shafts always belong to the numbers.",
            "\"included\"",
        ),
        key("gravity", Kind::Direction, Optional, "Direction of gravity; default along -x.", "[-1, 0, 0]"),
        key(
            "driveline_torque",
            Kind::QuantityOrThree(Torque, Any),
            Optional,
            "Mean torque that engine and gearbox deliver to the driveline; the block feels its opposite. One number turns \
             about z, positive with the crank; three are x, y and z. Default 0.",
            "\"120 N m\"",
        ),
    ],
};

const STIFFNESS_DOC: &str = "Stiffness, the same in all directions, or one for each of the mount's three.";

pub(super) static MOUNT: Table = Table {
    header: "[[mount]]",
    doc: "An engine mount: its place, and how it yields if the motion of the block is asked for.",
    keys: &[
        key("name", Kind::Text(100), Optional, "Its name in tables.", "\"front\""),
        key("x", Kind::Quantity(Length, Any), Required, "Position.", "\"0 mm\""),
        key("y", Kind::Quantity(Length, Any), Required, "Position.", "\"0 mm\""),
        key("z", Kind::Quantity(Length, Any), Required, "Position along the crank.", "\"-88 mm\""),
        key(
            "stiffness",
            Kind::QuantityOrThree(Stiffness, NotNegative),
            Optional,
            STIFFNESS_DOC,
            "[\"200 N/mm\", \"80 N/mm\", \"80 N/mm\"]",
        ),
        key(
            "direction",
            Kind::Direction,
            Optional,
            "Its first direction; default x. Only the direction counts, not the size.",
            "[1, 1, 0]",
        ),
        key(
            "second_direction",
            Kind::Direction,
            Optional,
            "Its second direction, at a right angle to the first; default y. Needed with `direction` unless the mount is the \
             same across it.",
            "[-1, 1, 0]",
        ),
        key(
            "damping",
            Kind::QuantityOrThree(Damping, NotNegative),
            Optional,
            "Viscous damping, one or three; default 0.",
            "\"150 N s/m\"",
        ),
        key(
            "loss_factor",
            Kind::ShareOrThree,
            Optional,
            "Loss factor, one or three: the part of the stiffness in quadrature over the part in phase, at any frequency; \
             default 0.",
            "0.1",
        ),
        quantity(
            "preload",
            Force,
            Any,
            "Force with which the mount pushes the block along its first direction in the position of this file; default 0.",
            "\"350 N\"",
        ),
        key(
            "table",
            Kind::Tables(&POINT, 64),
            Optional,
            "Dynamic stiffness over frequency; `stiffness` is then the static one.",
            "[{ frequency = \"20 Hz\", stiffness = \"250 N/mm\", loss_factor = 0.2 }]",
        ),
    ],
};

static POINT: Table = Table {
    header: "[[mount.table]]",
    doc: "Stiffness and loss of a mount at one frequency; between them they go on straight lines.",
    keys: &[
        FREQUENCY,
        key(
            "stiffness",
            Kind::QuantityOrThree(Stiffness, NotNegative),
            Required,
            STIFFNESS_DOC,
            "\"250 N/mm\"",
        ),
        key("loss_factor", Kind::ShareOrThree, Optional, "Loss factor, one or three; default 0.", "0.2"),
    ],
};

const FREQUENCY: Key =
    key("frequency", Kind::Quantity(Speed, NotNegative), Required, "Frequency.", "\"20 Hz\"");
