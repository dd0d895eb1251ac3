//! `[layout]`.

use super::super::Bound::{Any, NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Kind, Table};
use super::entry::{MOST_CYLINDERS, for_layouts, key, quantity};
use lanchester_units::Dimension::{Angle, Length};

const BANKED: &[&str] = &["v", "boxer", "flat", "w"];
const SHARED: &[&str] = &["v", "flat", "w"];
const NOT_RADIAL: &[&str] = &["in-line", "v", "boxer", "flat", "vr", "w"];

pub(super) static LAYOUT: Table = Table {
    header: "[layout]",
    doc: "Short form of a common layout, instead of `[[throw]]` and `[[cylinder]]`.",
    keys: &[
        key(
            "type",
            Kind::Choice(&["in-line", "v", "boxer", "flat", "vr", "w", "radial"]),
            Required,
            "Which layout it is.",
            "\"in-line\"",
        ),
        key(
            "cylinders",
            Kind::Whole(1, MOST_CYLINDERS),
            Required,
            "Number of cylinders; of a radial, in each row.",
            "4",
        ),
        for_layouts(
            NOT_RADIAL,
            quantity(
                "spacing",
                Length,
                Positive,
                "Distance between neighbouring cylinders of a bank (in-line), between the planes of neighbouring \
                 pairs or groups (v, boxer, flat, w), between successive cylinders along the crank (vr).",
                "\"88 mm\"",
            ),
        ),
        for_layouts(
            NOT_RADIAL,
            key(
                "positions",
                Kind::Quantities(Length, Any),
                Optional,
                "Instead of `spacing`: z of each of these planes, rising.",
                "[\"-150 mm\", \"-50 mm\", \"50 mm\", \"150 mm\"]",
            ),
        ),
        key(
            "crank_angles",
            Kind::Quantities(Angle, Any),
            Optional,
            "Direction of each throw, the first 0 deg: one for each cylinder (in-line, vr, separate pins), pin \
             (shared pins), pair (split pins and boxer: its first pin) or row (radial). Default: from the firing \
             order with even intervals.",
            "[\"0 deg\", \"180 deg\", \"180 deg\", \"0 deg\"]",
        ),
        key(
            "crank_phase",
            Kind::Quantity(Angle, Any),
            Optional,
            "Instead of `crank_angles`: crank angle between the throws of cylinders that follow in the firing order.",
            "\"120 deg\"",
        ),
        for_layouts(
            BANKED,
            key(
                "numbering",
                Kind::Choice(&["by-bank", "alternating"]),
                Optional,
                "Cylinder numbers run along bank 1 first (default), or alternate between the banks.",
                "\"by-bank\"",
            ),
        ),
        for_layouts(
            BANKED,
            quantity(
                "bank_stagger",
                Length,
                Any,
                "Distance along z between the banks' cylinders of a pair, bank 1 towards the free end; default 0 on a shared pin, needed for pins of their own.",
                "\"20 mm\"",
            ),
        ),
        for_layouts(
            &["v", "vr"],
            quantity(
                "bank_angle",
                Angle,
                Positive,
                "Angle between the banks: bank 1 stands at minus half of it, bank 2 at plus half.",
                "\"60 deg\"",
            ),
        ),
        for_layouts(
            &["vr"],
            quantity(
                "bank_offset",
                Length,
                NotNegative,
                "Distance at which the cylinder axes pass the crank axis; they cross below it, on the side away from \
                 the heads.",
                "\"12.5 mm\"",
            ),
        ),
        for_layouts(
            SHARED,
            key(
                "pins",
                Kind::Choice(&["shared", "split", "separate"]),
                Optional,
                "Crankpins of a pair or group: one for all (default), one each side by side with `split_angle` \
                 between them (v), or a throw for every cylinder.",
                "\"shared\"",
            ),
        ),
        for_layouts(
            &["v"],
            quantity(
                "split_angle",
                Angle,
                Any,
                "With split pins: direction of bank 2's pin from bank 1's pin.",
                "\"30 deg\"",
            ),
        ),
        for_layouts(
            &["v", "flat", "radial"],
            key(
                "rods",
                Kind::Choice(&["side-by-side", "fork-and-blade", "articulated"]),
                Optional,
                "How rods share a pin: side by side (default but for radial), fork and blade (v, flat), or on a master \
                 rod (v, flat; default of radial).",
                "\"side-by-side\"",
            ),
        ),
        for_layouts(
            &["w"],
            key(
                "banks",
                Kind::Tables(&BANK, 8),
                Optional,
                "The banks, each with its angle.",
                "[{ angle = \"-60 deg\" }, { angle = \"0 deg\" }, { angle = \"60 deg\" }]",
            ),
        ),
        for_layouts(
            &["radial"],
            key("rows", Kind::Whole(1, 16), Optional, "Number of rows; default 1.", "2"),
        ),
        for_layouts(
            &["radial"],
            quantity("row_spacing", Length, Positive, "Distance between neighbouring rows.", "\"180 mm\""),
        ),
        for_layouts(
            &["radial"],
            key(
                "row_angles",
                Kind::Quantities(Angle, Any),
                Optional,
                "Turn of each row as a whole; default 0.",
                "[\"0 deg\", \"20 deg\"]",
            ),
        ),
        for_layouts(
            &["radial"],
            key(
                "master",
                Kind::Whole(1, MOST_CYLINDERS),
                Optional,
                "Number, within each row, of the cylinder with the master rod; default 1.",
                "1",
            ),
        ),
        for_layouts(
            &["radial"],
            quantity(
                "knuckle_radius",
                Length,
                Positive,
                "Distance of the knuckle pins from the crankpin.",
                "\"60 mm\"",
            ),
        ),
        for_layouts(
            &["radial"],
            key(
                "knuckle_angles",
                Kind::Quantities(Angle, Any),
                Optional,
                "Direction of the knuckle pin of each cylinder of a row but the master's, in the order of their \
                 numbers, from the master rod's line; default: the angle between the cylinders.",
                "[\"72 deg\", \"144 deg\", \"216 deg\", \"288 deg\"]",
            ),
        ),
    ],
};

pub(super) static BANK: Table = Table {
    header: "[[layout.banks]]",
    doc: "A bank of a W engine.",
    keys: &[
        key("angle", Kind::Quantity(Angle, Any), Required, "Direction of its cylinder axes.", "\"-60 deg\""),
        quantity(
            "offset",
            Length,
            Any,
            "Offset of its cylinder axes from the crank axis; default 0.",
            "\"0 mm\"",
        ),
    ],
};
