//! Shapes among which counterweights are to be found.

use super::super::Bound::{NotNegative, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Bound, Key, Kind, Need, Table};
use super::entry::{key, quantity};
use lanchester_units::Dimension::{self, Angle, Density, Inertia, Length, Mass};

pub(super) static COUNTERWEIGHT_DESIGN: Table = Table {
    header: "[counterweight_design]",
    doc: "Shapes of a counterweight among which the best is to be found: a rectangle, a trapezoid and a circular segment around the disc of the web. Each \
          dimension is one value, or a list of the least and the most.",
    keys: &[
        key(
            "minimise",
            Kind::Choice(&["mass", "swept radius", "inertia", "thickness"]),
            Optional,
            "What is made as small as possible; default the mass.",
            "\"mass\"",
        ),
        key(
            "balance",
            Kind::ShareOrPair,
            Optional,
            "Least unbalance as a share of what the weight is to have, or a list of the least and the most; default at least 100 %.",
            "[\"98 %\", \"102 %\"]",
        ),
        quantity(
            "density",
            Density,
            Positive,
            "Density, between 1000 and 23000 kg/m3; default that of [crank.body].",
            "\"7850 kg/m3\"",
        ),
        range(
            "web_radius",
            Length,
            Positive,
            Optional,
            "Radius of the web's disc; default that of [crank.body].",
            "\"38 mm\"",
        ),
        range(
            "rectangle_height",
            Length,
            NotNegative,
            Required,
            "Height of the rectangle, from the crank axis.",
            "[\"0 mm\", \"40 mm\"]",
        ),
        range(
            "shoulder_height",
            Length,
            NotNegative,
            Optional,
            "Height of the trapezoid; this or `shoulder_angle` is needed.",
            "[\"0 mm\", \"30 mm\"]",
        ),
        range(
            "shoulder_angle",
            Angle,
            NotNegative,
            Optional,
            "Angle between the flank of the trapezoid and the chord of the arc, at most 89 deg.",
            "[\"20 deg\", \"60 deg\"]",
        ),
        range("arc_radius", Length, Positive, Required, "Radius of the arc.", "[\"60 mm\", \"95 mm\"]"),
        range(
            "arc_angle",
            Angle,
            Positive,
            Required,
            "Included angle of the arc, less than a full turn.",
            "[\"60 deg\", \"180 deg\"]",
        ),
        range("thickness", Length, Positive, Required, "Thickness along the crank.", "\"20 mm\""),
        key(
            "limits",
            Kind::Table(&LIMITS),
            Optional,
            "Limits on what follows from the dimensions.",
            "{ swept_radius = \"90 mm\" }",
        ),
    ],
};

static LIMITS: Table = Table {
    header: "[counterweight_design.limits]",
    doc: "Limits on what follows from the dimensions; none by default.",
    keys: &[
        quantity("mass", Mass, Positive, "Largest mass of the counterweight.", "\"0.9 kg\""),
        quantity(
            "swept_radius",
            Length,
            Positive,
            "Largest distance of web and counterweight from the crank axis.",
            "\"90 mm\"",
        ),
        quantity(
            "inertia",
            Inertia,
            Positive,
            "Largest polar inertia of the counterweight about the crank axis.",
            "\"2000 kg mm2\"",
        ),
        quantity("half_width", Length, Positive, "Largest half width of the counterweight.", "\"70 mm\""),
        range(
            "shoulder_angle",
            Angle,
            NotNegative,
            Optional,
            "Least and largest angle between the flank and the chord of the arc, at most 90 deg.",
            "[\"10 deg\", \"70 deg\"]",
        ),
        range(
            "shoulder_height",
            Length,
            NotNegative,
            Optional,
            "Least and largest height of the trapezoid.",
            "[\"2 mm\", \"25 mm\"]",
        ),
    ],
};

pub(super) const fn range(
    name: &'static str,
    dimension: Dimension,
    bound: Bound,
    need: Need,
    doc: &'static str,
    example: &'static str,
) -> Key {
    key(name, Kind::QuantityOrPair(dimension, bound), need, doc, example)
}
