//! Bores of parts on drawings, written and read back.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_geometry::drawing::{Drawing, DrawingOptions, part_dxf, part_svg, read_dxf, read_svg};
use lanchester_geometry::{Contour, Insert, Outline, Part, Point};

/// A disc of 100 mm with a through-bore, a slug from the front and a blind bore from the rear.
fn part() -> Part {
    let disc = Contour::circle(Point::new(0.01, 0.0), 0.05).unwrap();
    let opening = Contour::circle(Point::new(-0.02, 0.0), 0.006).unwrap();
    let plate = Part::new(Outline::new(disc, vec![opening]).unwrap(), 0.02, 7850.0).unwrap();
    let bore = |x: f64, y: f64, radius: f64, from: f64, to: f64, density: f64| Insert {
        centre: Point::new(x, y),
        radius,
        from,
        to,
        density,
    };
    [
        bore(0.03, 0.02, 0.008, 0.0, 0.02, 0.0),
        bore(0.03, -0.02, 0.007, 0.0, 0.012, 18_000.0),
        bore(0.0, 0.03, 0.005, 0.015, 0.02, 0.0),
    ]
    .into_iter()
    .fold(plate, |part, insert| part.with_insert(insert).unwrap())
}

fn check(drawing: &Drawing) {
    // The opening of the outline and the bore that goes through, both exact to the digits written.
    let holes = drawing.outline.holes();
    assert_eq!(holes.len(), 2);
    let through = holes.iter().map(Contour::moments).find(|hole| hole.first.y > 0.0).expect("it is there");
    let centre = through.first * (1.0 / through.area);
    assert!((centre - Point::new(0.03, 0.02)).norm() < 1e-14);
    assert!((through.area / (std::f64::consts::PI * 0.008f64.powi(2)) - 1.0).abs() < 1e-13);
    // Slug and blind bore, apart from the outline.
    let [slug, blind] = drawing.bores[..] else { panic!("two bores: {:?}", drawing.bores) };
    assert!((slug.centre - Point::new(0.03, -0.02)).norm() < 1e-15 && (slug.radius - 0.007).abs() < 1e-15);
    assert!((blind.centre - Point::new(0.0, 0.03)).norm() < 1e-15 && (blind.radius - 0.005).abs() < 1e-15);
}

#[test]
fn a_dxf_holds_every_bore_with_centre_lines_and_notes() {
    let text = part_dxf(&part()).unwrap();
    assert!(text.is_ascii());
    let read = read_dxf(text.as_bytes(), &DrawingOptions::default()).unwrap();
    check(&read);
    for note in [
        "%%c16 through",
        "%%c14 12 mm deep from the front face, 18000 kg/m3",
        "%%c10 5 mm deep from the rear face",
    ] {
        assert!(text.contains(note), "{note}");
    }
    // Two centre lines and a note at each of the three.
    assert_eq!(read.ignored.len(), 9, "{:?}", read.ignored);
    assert_eq!(text.matches("\nCENTRE_LINES\n 10\n").count(), 6);
}

#[test]
fn an_svg_holds_every_bore_with_centre_lines_and_notes() {
    let text = part_svg(&part()).unwrap();
    check(&read_svg(text.as_bytes(), &DrawingOptions::default()).unwrap());
    assert_eq!(text.matches("<line ").count(), 6);
    for note in
        ["⌀16 through", "⌀14 12 mm deep from the front face, 18000 kg/m3", "⌀10 5 mm deep from the rear face"]
    {
        assert!(text.contains(note), "{note}");
    }
}

#[test]
fn circles_on_such_a_layer_of_another_program_are_holes() {
    // Without the comment of this program the layer's name means nothing.
    let text = part_dxf(&part()).unwrap();
    let foreign = text.replacen("lanchester: lengths in millimetres", "another program", 1);
    let options = DrawingOptions {
        unit: Some(1e-3),
        leave_out: vec!["CENTRE_LINES".to_owned()],
        ..DrawingOptions::default()
    };
    let read = read_dxf(foreign.as_bytes(), &options).unwrap();
    assert_eq!((read.outline.holes().len(), read.bores.len()), (4, 0));
}
