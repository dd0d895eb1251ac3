//! Weights of balance shafts as parts.

use super::super::Bound::{Any, Positive};
use super::super::Need::{Optional, Required};
use super::super::{Kind, Table};
use super::design::range;
use super::entry::{key, quantity};
use lanchester_units::Dimension::{Angle, Density, Length};

pub(super) static SHAFT_WEIGHT_SHAPE: Table = Table {
    header: "[shaft.weights.shape]",
    doc: "The weight as a part: what a disc about the axis of the shaft has beyond a chord, around the shaft, its middle in the plane of the \
          weight and its bisector along `phase`. The shaft within it counts as shaft.",
    keys: &[
        key(
            "shaft_diameter",
            Kind::Quantity(Length, Positive),
            Required,
            "Diameter of the shaft within the weight.",
            "\"24 mm\"",
        ),
        key(
            "radius",
            Kind::Quantity(Length, Positive),
            Required,
            "Radius of the weight, which is its swept radius.",
            "\"36 mm\"",
        ),
        quantity(
            "chord",
            Length,
            Any,
            "Distance of the chord from the axis, towards the weight, less than the radius of the shaft; negative on the far side. Default 0, half a disc.",
            "\"4 mm\"",
        ),
        quantity(
            "half_angle",
            Angle,
            Positive,
            "Instead of `chord`: half the angle of the arc, less than 180 deg; 90 deg for half a disc.",
            "\"80 deg\"",
        ),
        key("length", Kind::Quantity(Length, Positive), Required, "Length along the shaft.", "\"40 mm\""),
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density, between 1000 and 23000 kg/m3.",
            "\"7850 kg/m3\"",
        ),
    ],
};

pub(super) static SHAFT_WEIGHT_DESIGN: Table = Table {
    header: "[shaft_weight_design]",
    doc: "Shapes among which the weights of balance shafts are to be found: what a disc has beyond a chord, around the shaft. radius, chord and length are \
          one value, or a list of the least and the most.",
    keys: &[
        key(
            "minimise",
            Kind::Choice(&["mass", "length", "radius", "inertia"]),
            Optional,
            "What is made as small as possible; default the mass.",
            "\"mass\"",
        ),
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density, between 1000 and 23000 kg/m3.",
            "\"7850 kg/m3\"",
        ),
        key(
            "shaft_diameter",
            Kind::Quantity(Length, Positive),
            Required,
            "Diameter of the shaft within the weights.",
            "\"24 mm\"",
        ),
        range(
            "radius",
            Length,
            Positive,
            Required,
            "Radius of the weight; the largest is the room that it may sweep.",
            "[\"20 mm\", \"36 mm\"]",
        ),
        range(
            "chord",
            Length,
            Any,
            Optional,
            "Distance of the chord from the axis, towards the weight; negative on the far side. Default 0, half a disc.",
            "[\"-10 mm\", \"8 mm\"]",
        ),
        range("length", Length, Positive, Required, "Length along the shaft.", "[\"10 mm\", \"60 mm\"]"),
    ],
};
