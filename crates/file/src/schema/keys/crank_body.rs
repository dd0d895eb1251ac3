//! The crankshaft as a body.

use super::super::Bound::{NotNegative, Positive};
use super::super::Need::Required;
use super::super::{Key, Kind, Table};
use super::{key, quantity};
use lanchester_units::Dimension::{Density, Length};

pub(super) static CRANK_BODY: Table = Table {
    header: "[crank.body]",
    doc: "Journals, pins and webs as bodies, the same for all throws. A web is the convex hull of two discs: one about the crank axis, one about the \
          crankpin. The unbalance of every throw follows: that of its pin and of its two plain webs. Every throw needs `web_distance`; the pin is as \
          long as it less `web_thickness`. Where it is the distance of two neighbouring throws or more, they have one web between their pins, as split \
          pins (a flying web) and boxers have: the convex hull of two discs of `pin_end_radius` about both pins, which fills what is between them.",
    keys: &[
        key(
            "density",
            Kind::Quantity(Density, Positive),
            Required,
            "Density of all of it, between 1000 and 23000 kg/m3.",
            "\"7850 kg/m3\"",
        ),
        length("journal_diameter", "Diameter of the main journals.", "\"54 mm\""),
        bore("journal_bore", "Diameter of a bore along the journals; default none.", "\"20 mm\""),
        length("pin_diameter", "Diameter of the crankpins.", "\"48 mm\""),
        bore("pin_bore", "Diameter of a bore along the pins, in their middle; default none.", "\"18 mm\""),
        length("web_thickness", "Thickness of the webs along the crank.", "\"18 mm\""),
        length(
            "web_radius",
            "Radius of a web's disc about the crank axis; the journal lies within it.",
            "\"38 mm\"",
        ),
        length(
            "pin_end_radius",
            "Radius of a web's round end about the crankpin; the pin lies within it.",
            "\"32 mm\"",
        ),
        key(
            "end_journals",
            Kind::QuantityOrPair(Length, Positive),
            Required,
            "Length of both end journals from the face of the web, or a list of the front and the rear one.",
            "[\"30 mm\", \"45 mm\"]",
        ),
    ],
};

const fn length(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    key(name, Kind::Quantity(Length, Positive), Required, doc, example)
}

const fn bore(name: &'static str, doc: &'static str, example: &'static str) -> Key {
    quantity(name, Length, NotNegative, doc, example)
}
