//! What the crankshaft must stay clear of.

use super::super::Bound::{NotNegative, Positive};
use super::super::{Key, Table};
use super::entry::quantity;
use lanchester_units::Dimension::Length;

pub(super) static CLEARANCE: Table = Table {
    header: "[clearance]",
    doc: "What the crankshaft and its counterweights must stay clear of; what is left out is not there.",
    keys: &[
        quantity("least", Length, NotNegative, "Least clearance that is wanted to everything.", "\"1 mm\""),
        length("crankcase_radius", "Inner radius of the crankcase about the crank axis.", "\"105 mm\""),
        length(
            "skirt_length",
            "From the axis of the piston pin to the lower edge of the skirt. Needs the bore of the pistons.",
            "\"35 mm\"",
        ),
        length(
            "skirt_width",
            "Width of the piston's lower end along the crank; default the bore.",
            "\"48 mm\"",
        ),
        length(
            "liner_end",
            "Distance of the lower end of the cylinder liners from the crank axis, along the cylinder axis; with `liner_wall`. Needs the bore of the \
             pistons.",
            "\"85 mm\"",
        ),
        length("liner_wall", "Thickness of the liners' wall; with `liner_end`.", "\"4 mm\""),
        length(
            "big_end_radius",
            "Radius of the rod's big end with its bolts about the crankpin; the four keys of the rod go together.",
            "\"40 mm\"",
        ),
        length("big_end_width", "Width of the big end along the crank.", "\"22 mm\""),
        length("shank_width", "Width of the rod's shank across rod and crank.", "\"26 mm\""),
        length("shank_thickness", "Thickness of the shank along the crank.", "\"16 mm\""),
    ],
};

const fn length(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    quantity(name, Length, Positive, doc, example)
}
