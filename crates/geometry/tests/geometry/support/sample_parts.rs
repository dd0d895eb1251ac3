//! Parts that an independent CAD kernel has measured: validation/external/gmsh.

use lanchester_geometry::export::PlacedPart;
use lanchester_geometry::{Chamfer, Contour, Corner, Cut, Edge, Face, Insert, Outline, Part, Point};
use std::f64::consts::PI;

const STEEL: f64 = 7850.0;

/// File names of the samples and their parts.
pub fn samples() -> Vec<(&'static str, Vec<PlacedPart>)> {
    vec![
        ("web", vec![web()]),
        ("bored-disc", vec![bored_disc()]),
        ("throw", throw()),
        ("chamfered-web", vec![chamfered_web()]),
    ]
}

/// A web with its counterweight: arcs both ways, lines, an oil hole, a lightening hole of lines and arcs, two heavy slugs.
fn web() -> PlacedPart {
    let rim = Edge::arc(Point::ORIGIN, 0.072, -1.05, 2.1);
    let nose = Edge::arc(Point::new(-0.04, 0.0), 0.03, PI / 2.0, PI);
    // Hollow flanks of 60 degrees.
    let bulge = -(PI / 12.0).tan();
    let flanks = [
        Edge { from: rim.to, to: Point::new(0.0, 0.034), bulge },
        Edge::line(Point::new(0.0, 0.034), nose.from),
        Edge::line(nose.to, Point::new(0.0, -0.034)),
        Edge { from: Point::new(0.0, -0.034), to: rim.from, bulge },
    ];
    let outer = Contour::from_edges(&[rim, flanks[0], flanks[1], nose, flanks[2], flanks[3]], 1e-12).unwrap();
    let oil = Contour::circle(Point::new(-0.045, 0.006), 0.004).unwrap();
    let corner = |x: f64, y: f64, bulge: f64| Corner { at: Point::new(x, y), bulge };
    let lightening = Contour::new(&[
        corner(-0.02, -0.008, 0.3),
        corner(-0.01, 0.0, 0.0),
        corner(-0.02, 0.008, 0.0),
        corner(-0.026, 0.0, -0.2),
    ])
    .unwrap();
    let slug = |y: f64| Insert {
        centre: Point::new(0.05, y),
        radius: 0.009,
        from: 0.0,
        to: 0.024,
        density: 18_000.0,
    };
    let outline = Outline::new(outer, vec![oil, lightening]).unwrap();
    let part = Part::new(outline, 0.024, STEEL).unwrap();
    let part = part.with_insert(slug(0.021)).and_then(|part| part.with_insert(slug(-0.021))).unwrap();
    PlacedPart::new("web", part)
}

/// The outline of the web with every kind of chamfer: turned ones that meet the rim about the crank axis, hollow flanks off it and the nose, milled ones
/// that meet arcs and lines, on both faces, beside a bore.
fn chamfered_web() -> PlacedPart {
    let part = Part::new(web().part.outline().clone(), 0.024, STEEL).unwrap();
    let chamfer = |cut: Cut, degrees: f64, face: Face| Chamfer { cut, angle: f64::to_radians(degrees), face };
    let chamfers = [
        chamfer(Cut::Turned { radius: 0.064 }, 45.0, Face::Front),
        chamfer(Cut::Milled { direction: PI, distance: 0.067 }, 40.0, Face::Rear),
        chamfer(Cut::Milled { direction: 1.9, distance: 0.035 }, 30.0, Face::Rear),
        chamfer(Cut::Milled { direction: 0.0, distance: 0.066 }, 50.0, Face::Rear),
    ];
    let part = chamfers.into_iter().fold(part, |part, chamfer| part.with_chamfer(chamfer).unwrap());
    let bore = Insert { centre: Point::new(0.045, 0.0), radius: 0.009, from: 0.0, to: 0.024, density: 0.0 };
    PlacedPart::new("chamfered web", part.with_insert(bore).unwrap()).moved(0.01)
}

/// A disc with a stepped bore with a slug in its narrow end, a blind hole, and a slug within.
fn bored_disc() -> PlacedPart {
    let insert = |x: f64, y: f64, radius: f64, [from, to]: [f64; 2], density: f64| Insert {
        centre: Point::new(x, y),
        radius,
        from,
        to,
        density,
    };
    let disc = Contour::circle(Point::new(0.005, -0.002), 0.06).unwrap();
    let inserts = [
        insert(0.03, 0.0, 0.012, [0.0, 0.011], 0.0),
        insert(0.03, 0.0, 0.007, [0.011, 0.03], 17_500.0),
        insert(-0.02, 0.02, 0.01, [0.018, 0.03], 0.0),
        insert(-0.02, -0.02, 0.008, [0.006, 0.021], 18_000.0),
    ];
    let part = Part::new(disc.into(), 0.03, STEEL).unwrap();
    let part = inserts.iter().fold(part, |part, insert| part.with_insert(*insert).unwrap());
    PlacedPart::new("bored disc", part).turned(0.7).moved(0.05)
}

/// A crank throw: journal, web, pin, web, journal.
fn throw() -> Vec<PlacedPart> {
    let round = |x: f64, radius: f64, length: f64| {
        let circle = Contour::circle(Point::new(x, 0.0), radius).unwrap();
        Part::new(circle.into(), length, STEEL).unwrap()
    };
    let turn = 2.0 * PI / 3.0;
    vec![
        PlacedPart::new("journal 1", round(0.0, 0.028, 0.03)).moved(-0.055),
        web().turned(turn).moved(-0.028).coloured([0.2, 0.4, 0.7]),
        PlacedPart::new("pin 1", round(-0.04, 0.024, 0.032)).turned(turn),
        web().turned(turn).moved(0.028).coloured([0.2, 0.4, 0.7]),
        PlacedPart::new("journal 2", round(0.0, 0.028, 0.03)).moved(0.055),
    ]
}
