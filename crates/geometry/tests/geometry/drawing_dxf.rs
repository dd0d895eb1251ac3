//! Outlines as DXF: written and read back, files in the style of common programs, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::random_outline;
use crate::support::random_web;

use crate::random_outline::any_star;
use crate::support::random_web::{any_web, assert_same};
use lanchester_geometry::drawing::{DrawingError, DrawingOptions, Place, dxf, read_dxf};
use lanchester_geometry::{Contour, GeometryError, Outline, Point};
use proptest::prelude::*;
use std::f64::consts::PI;

const MILLIMETRES: DrawingOptions = DrawingOptions { unit: Some(1e-3), gap: 1e-6, leave_out: Vec::new() };

/// A file of these entities, each a kind and its groups, with more sections before.
fn file(before: &str, entities: &[(&str, &[(i32, &str)])]) -> String {
    let mut text = format!("{before}  0\nSECTION\n  2\nENTITIES\n");
    for (kind, groups) in entities {
        text += &format!("  0\n{kind}\n");
        for (code, value) in *groups {
            text += &format!("{code:3}\n{value}\n");
        }
    }
    text + "  0\nENDSEC\n  0\nEOF\n"
}

fn header(unit: &str) -> String {
    format!("  0\r\nSECTION\r\n  2\r\nHEADER\r\n  9\r\n$INSUNITS\r\n 70\r\n     {unit}\r\n  0\r\nENDSEC\r\n")
}

fn read(text: &str) -> Outline {
    read_dxf(text.as_bytes(), &MILLIMETRES).unwrap().outline
}

fn refused(text: &str) -> DrawingError {
    read_dxf(text.as_bytes(), &MILLIMETRES).unwrap_err()
}

type Groups = [(i32, &'static str)];

const TRIANGLE: [(&str, &Groups); 3] = [
    ("LINE", &[(8, "0"), (10, "0.0"), (20, "0.0"), (11, "30.0"), (21, "0.0")]),
    ("LINE", &[(8, "0"), (10, "0.0"), (20, "40.0"), (11, "30.0"), (21, "0.0")]),
    ("LINE", &[(8, "0"), (10, "0.0"), (20, "0.0"), (11, "0.0"), (21, "40.0")]),
];

/// The triangle with one more entity.
fn with(kind: &'static str, groups: &'static Groups) -> String {
    let mut all = TRIANGLE.to_vec();
    all.push((kind, groups));
    file("", &all)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn prop_dxf_gives_the_outline_back(web in any_web(any_star(), prop::collection::vec(any_star(), 0..3))) {
        let text = dxf(&web);
        prop_assert!(text.is_ascii() && text == dxf(&web));
        // Its own comment tells the unit.
        let read = read_dxf(text.as_bytes(), &DrawingOptions::default()).unwrap();
        prop_assert!(read.unit == 1e-3 && read.ignored.is_empty());
        assert_same(&read.outline, &web);
        // The corners themselves, but for one rounding.
        for (found, exact) in read.outline.outer().edges().iter().zip(web.outer().edges()) {
            prop_assert!(found.bulge == exact.bulge || exact.bulge.abs() < 1e-19);
            prop_assert!((found.from - exact.from).norm() <= 4e-16 * exact.from.norm());
        }
    }

    #[test]
    fn prop_loose_lines_and_arcs_are_joined(star in any_star(), turn in 0usize..7, backwards in any::<u32>()) {
        // Every edge an entity of its own, in another order and sense, as CENTRE, radius and angles where it is an arc.
        let contour = Contour::new(&star).unwrap();
        let mut entities = Vec::new();
        for (k, edge) in contour.edges().iter().enumerate() {
            let edge = if backwards >> k & 1 == 1 { edge.reversed() } else { *edge };
            // Angles about a centre far away do not place the ends.
            if edge.bulge.abs() < 1e-3 {
                let (p, q) = (edge.from * 1e3, edge.to * 1e3);
                entities.push(format!("0\nLINE\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", p.x, p.y, q.x, q.y));
                continue;
            }
            let arc = if edge.bulge > 0.0 { edge } else { edge.reversed() };
            let (c, r) = (arc.centre(), arc.radius());
            let angle = |p: Point| (p - c).y.atan2((p - c).x).to_degrees();
            let c = c * 1e3;
            let r = r * 1e3;
            entities.push(format!(
                "0\nARC\n10\n{}\n20\n{}\n40\n{r}\n50\n{}\n51\n{}\n", c.x, c.y, angle(arc.from), angle(arc.to)
            ));
        }
        let count = entities.len();
        entities.rotate_left(turn % count);
        entities.swap(0, count / 2);
        let text = format!("0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\nEOF\n", entities.concat());
        let read = read_dxf(text.as_bytes(), &MILLIMETRES).unwrap().outline;
        let flat: f64 = contour.edges().iter().filter(|edge| edge.bulge.abs() < 1e-3).map(|edge| edge.half_chord().powi(2) * edge.bulge * (4.0 / 3.0) * (1.0 + edge.bulge.powi(2) / 5.0)).sum();
        let exact = contour.moments().area - flat;
        // Of a flat segment the next power of the bulge is the fifth.
        prop_assert!((read.moments().area - exact).abs() < 1e-11 * contour.length().powi(2), "{} {exact}", read.moments().area);
    }

    #[test]
    fn prop_random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(read_dxf(&bytes, &MILLIMETRES).is_err());
    }

    #[test]
    fn prop_mutated_files_never_panic(
        star in any_star(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in any::<Option<prop::sample::Index>>(),
        moved in any::<(prop::sample::Index, prop::sample::Index)>(),
    ) {
        let mut bytes = dxf(&Contour::new(&star).unwrap().into()).into_bytes();
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
        let (from, to) = (moved.0.index(lines.len()), moved.1.index(lines.len()));
        lines.swap(from, to);
        let mut bytes = lines.join(&b'\n');
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        // Either an outline or a reason, whatever the reason.
        if let Err(error) = read_dxf(&bytes, &MILLIMETRES) {
            prop_assert!(error.to_string().contains("hint: "), "{error}");
        }
    }

    #[test]
    fn prop_numbers_of_any_size_never_panic(numbers in prop::collection::vec(any::<f64>(), 12), bulge in any::<f64>()) {
        let vertex = |k: usize| format!("0\nVERTEX\n10\n{:?}\n20\n{:?}\n42\n{bulge:?}\n", numbers[2 * k], numbers[2 * k + 1]);
        let text: String = (0..4).map(vertex).collect();
        let arc = format!("0\nARC\n10\n{:?}\n20\n{:?}\n40\n{:?}\n50\n{:?}\n51\n{bulge:?}\n", numbers[8], numbers[9], numbers[10], numbers[11]);
        for entities in [format!("0\nPOLYLINE\n70\n1\n{text}0\nSEQEND\n"), arc] {
            let text = format!("0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
            if let Ok(read) = read_dxf(text.as_bytes(), &MILLIMETRES) {
                prop_assert!(read.outline.moments().area > 0.0);
            }
        }
    }
}

#[test]
fn the_text_is_that_of_release_12() {
    let disc = Contour::circle(Point::ORIGIN, 0.0625).unwrap();
    let bore = Contour::circle(Point::new(0.03125, 0.0), 0.015625).unwrap();
    let text = dxf(&Outline::new(disc, vec![bore]).unwrap());
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[..2], ["999", "lanchester: lengths in millimetres"]);
    assert!(text.contains("  9\n$ACADVER\n  1\nAC1009\n") && text.ends_with("  0\nEOF\n"));
    assert!(text.contains("$EXTMIN\n 10\n-62.5\n 20\n-62.5\n"));
    let head = "  0\nPOLYLINE\n  8\nOUTER\n 66\n1\n 10\n0.0\n 20\n0.0\n 30\n0.0\n 70\n1\n";
    let first = "  0\nVERTEX\n  8\nOUTER\n 10\n-62.5\n 20\n0.0\n 30\n0.0\n 42\n1.0\n";
    let second = "  0\nVERTEX\n  8\nOUTER\n 10\n62.5\n 20\n0.0\n 30\n0.0\n 42\n1.0\n  0\nSEQEND\n";
    assert!(text.contains(&[head, first, second].concat()), "{text}");
    assert!(text.contains("  8\nHOLES\n 10\n15.625\n"));
}

#[test]
fn a_plate_of_loose_entities_with_a_hole_and_annotations() {
    // Release 2000 style: inches in the header, a slot of two lines and two arcs, a drilled hole, a dimension and a note.
    let slot: [(&str, &Groups); 7] = [
        (
            "LINE",
            &[
                (5, "2F"),
                (100, "AcDbEntity"),
                (8, "CUT"),
                (100, "AcDbLine"),
                (10, "-1.0"),
                (20, "-0.5"),
                (30, "0.0"),
                (11, "1.0"),
                (21, "-0.5"),
                (31, "0.0"),
            ],
        ),
        ("ARC", &[(8, "CUT"), (10, "1.0"), (20, "0.0"), (40, "0.5"), (50, "270.0"), (51, "90.0")]),
        ("LINE", &[(8, "CUT"), (10, "-1.0"), (20, "0.5"), (11, "1.0"), (21, "0.5")]),
        ("ARC", &[(8, "CUT"), (10, "-1.0"), (20, "0.0"), (40, "0.5"), (50, "90.0"), (51, "270.0")]),
        ("CIRCLE", &[(8, "CUT"), (10, "1.0"), (20, "0.0"), (30, "0.0"), (40, "0.25")]),
        ("DIMENSION", &[(8, "DIM"), (2, "*D1"), (10, "1.0"), (20, "2.0"), (70, "32")]),
        ("LINE", &[(8, "Centre"), (10, "-2.0"), (20, "0.0"), (11, "2.0"), (21, "0.0")]),
    ];
    let options = DrawingOptions { leave_out: vec!["CENTRE".to_string()], ..DrawingOptions::default() };
    let read = read_dxf(file(&header("1"), &slot).as_bytes(), &options).unwrap();
    assert_eq!(read.unit, 0.0254);
    let exact = (2.0 + PI * 0.25 - PI * 0.0625) * 0.0254 * 0.0254;
    assert!((read.outline.moments().area / exact - 1.0).abs() < 1e-14);
    assert!((read.outline.swept_radius() - 1.5 * 0.0254).abs() < 1e-16);
    let ignored: Vec<(&str, &str)> = read.ignored.iter().map(|i| (&i.entity.entity[..], i.why)).collect();
    assert_eq!(ignored, [("DIMENSION", "it draws no contour"), ("LINE", "its layer is left out")]);
    // With the centre line it is open, and without a unit it is nothing.
    let error = read_dxf(file(&header("1"), &slot).as_bytes(), &DrawingOptions::default()).unwrap_err();
    assert!(matches!(error, DrawingError::Open { .. }), "{error}");
    for unit in [String::new(), header("0")] {
        let error = read_dxf(file(&unit, &slot).as_bytes(), &options).unwrap_err();
        assert_eq!(error, DrawingError::NoUnit { why: "it has no $INSUNITS" });
    }
    let error = read_dxf(file(&header("77"), &slot).as_bytes(), &options).unwrap_err();
    assert_eq!(error, DrawingError::UnknownUnit { line: 8, got: "77".to_string() });
}

#[test]
fn light_polylines_with_bulges_run_either_way() {
    // A half disc, clockwise, its first corner repeated at the end but for the sixth digit.
    let half: [(&str, &Groups); 1] = [(
        "LWPOLYLINE",
        &[
            (8, "0"),
            (90, "3"),
            (70, "1"),
            (43, "0.0"),
            (10, "0.0"),
            (20, "-10.0"),
            (42, "-1.0"),
            (10, "0.0"),
            (20, "10.0"),
            (10, "0.000001"),
            (20, "-10.0"),
        ],
    )];
    let web = read(&file("", &half));
    assert!((web.moments().area / (50e-6 * PI) - 1.0).abs() < 1e-7);
    assert!((web.moments().centroid().x + 0.04 / (3.0 * PI)).abs() < 1e-9);
    // The same seen from below: x turned round.
    let below: [(&str, &Groups); 1] = [(
        "LWPOLYLINE",
        &[
            (90, "2"),
            (70, "1"),
            (10, "0.0"),
            (20, "-10.0"),
            (42, "-1.0"),
            (10, "0.0"),
            (20, "10.0"),
            (210, "0.0"),
            (220, "0.0"),
            (230, "-1.0"),
        ],
    )];
    let turned = read(&file("", &below));
    assert!((turned.moments().centroid().x - 0.04 / (3.0 * PI)).abs() < 1e-15);
    // As an arc and a line, the arc seen from below.
    let loose: [(&str, &Groups); 2] = [
        (
            "ARC",
            &[
                (10, "0"),
                (20, "0"),
                (40, "10"),
                (50, "90"),
                (51, "270"),
                (230, "-1.0"),
                (210, "0"),
                (220, "0"),
            ],
        ),
        ("LINE", &[(10, "0"), (20, "10"), (11, "0"), (21, "-10")]),
    ];
    let loose = read(&file("", &loose));
    assert!((loose.moments().first - turned.moments().first).norm() < 1e-14 * turned.moments().area);
}

#[test]
fn gaps_are_closed_as_far_as_stated() {
    let gap: [(&str, &Groups); 3] =
        [TRIANGLE[0], TRIANGLE[1], ("LINE", &[(10, "0.0"), (20, "0.002"), (11, "0.0"), (21, "40.0")])];
    let error = refused(&file("", &gap));
    let DrawingError::Open { ref entity, at, nearest: Some(nearest) } = error else { panic!("{error}") };
    assert_eq!(*entity, Place { entity: "LINE".to_string(), line: 5 });
    assert!(at == Point::ORIGIN && (nearest - 2e-6).abs() < 1e-15);
    assert_eq!(
        error.to_string(),
        "the line that ends with LINE at line 5 is open at (0.0000 mm, 0.0000 mm), 2.000e-3 mm from the next end\nhint: close it, allow a larger gap, or name the layer of auxiliary lines as one to leave out"
    );
    let wider = DrawingOptions { gap: 3e-6, ..MILLIMETRES };
    let web = read_dxf(file("", &gap).as_bytes(), &wider).unwrap().outline;
    assert!((web.moments().area - 600e-6).abs() < 30e-9);
    let nothing = DrawingOptions { gap: f64::NAN, ..MILLIMETRES };
    assert!(matches!(read_dxf(b"0", &nothing), Err(DrawingError::Gap { .. })));
    let nothing = DrawingOptions { unit: Some(-1.0), ..MILLIMETRES };
    assert_eq!(read_dxf(b"0", &nothing), Err(DrawingError::Unit { got: -1.0 }));
}

#[test]
fn what_is_no_line_or_arc_is_refused_with_its_place() {
    assert!((read(&file("", &TRIANGLE)).moments().area - 600e-6).abs() < 1e-18);
    let refused_entity = |kind: &'static str, groups: &'static Groups| {
        let error = refused(&with(kind, groups));
        let DrawingError::Unsupported { entity, why, .. } = error else { panic!("{kind}: {error}") };
        assert_eq!(entity, Place { entity: kind.to_string(), line: 41 });
        why
    };
    for kind in ["SPLINE", "ELLIPSE", "INSERT", "SOLID", "ACAD_PROXY_ENTITY"] {
        refused_entity(kind, &[(8, "0")]);
    }
    let rising = refused_entity("LINE", &[(10, "1"), (20, "1"), (11, "2"), (21, "2"), (31, "5")]);
    assert_eq!(rising, "rises out of the plane of the drawing");
    let tilted = refused_entity("CIRCLE", &[(10, "1"), (20, "1"), (40, "2"), (210, "1"), (230, "0")]);
    assert_eq!(tilted, "does not lie in the plane of the drawing");
    assert_eq!(
        refused_entity("CIRCLE", &[(10, "1"), (20, "1"), (40, "-2")]),
        "has a radius that is not positive"
    );
    assert_eq!(refused_entity("LWPOLYLINE", &[(43, "0.5"), (10, "1"), (20, "1")]), "has a width");
    let error = refused(&with("CIRCLE", &[(10, "1"), (20, "1")]));
    assert_eq!(
        error.to_string(),
        "CIRCLE at line 41 has no radius (40)\nhint: the file is damaged; export it again"
    );
    let error = refused(&with("CIRCLE", &[(10, "1"), (20, "1"), (40, "1O")]));
    assert_eq!(error, DrawingError::Syntax { line: 48, needed: "a finite number", got: "1O".to_string() });
    let error = refused(&with("CIRCLE", &[(10, "1e12"), (20, "1"), (40, "1")]));
    assert!(matches!(error, DrawingError::TooFar { .. }));
    let error = refused(&with("POLYLINE", &[(70, "1")]));
    assert!(matches!(error, DrawingError::Missing { missing: "SEQEND", .. }));
    let layer = "  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nLAYER\n  0\nLAYER\n  2\n0\n 70\n0\n 62\n-7\n  0\nENDTAB\n  0\nENDSEC\n";
    assert!(matches!(refused(&file(layer, &TRIANGLE)), DrawingError::Hidden { .. }));
    // Paper space and texts do no harm, and are listed.
    let read = read_dxf(with("LINE", &[(67, "1")]).as_bytes(), &MILLIMETRES).unwrap();
    assert_eq!(read.ignored[0].why, "it is in the paper space");
}

#[test]
fn contours_that_make_no_outline_are_refused_with_their_entities() {
    let circle = |kind: &'static str| match kind {
        "beside" => with("CIRCLE", &[(10, "100"), (20, "0"), (40, "5")]),
        "through" => with("CIRCLE", &[(10, "0"), (20, "0"), (40, "5")]),
        _ => with("CIRCLE", &[(10, "10"), (20, "10"), (40, "5")]),
    };
    assert_eq!(read(&circle("inside")).holes().len(), 1);
    let line = |line| Place { entity: "LINE".to_string(), line };
    let error = refused(&circle("beside"));
    let second = Place { entity: "CIRCLE".to_string(), line: 41 };
    assert_eq!(error, DrawingError::SeveralOuter { first: line(5), second: second.clone() });
    let error = refused(&circle("through"));
    let DrawingError::Outline { entities, error: GeometryError::ContoursCross { at, .. } } = error else {
        panic!("{error}")
    };
    assert_eq!(entities, [line(5), second]);
    assert!((at.norm() - 0.005).abs() < 1e-12);
    let rings: [(&str, &Groups); 3] = [
        ("CIRCLE", &[(10, "0"), (20, "0"), (40, "5")]),
        ("CIRCLE", &[(10, "0"), (20, "0"), (40, "15")]),
        ("CIRCLE", &[(10, "0"), (20, "0"), (40, "10")]),
    ];
    let DrawingError::Island { inner, hole } = refused(&file("", &rings)) else { panic!() };
    assert_eq!((inner.line, hole.line), (5, 21));
    // A line drawn twice, and a figure of eight.
    let error = refused(&with("LINE", &[(8, "0"), (10, "0.0"), (20, "0.0"), (11, "30.0"), (21, "0.0")]));
    assert!(matches!(error, DrawingError::Branch { ref entities, .. } if entities.len() == 3), "{error}");
    let eight: [(&str, &Groups); 1] = [(
        "LWPOLYLINE",
        &[
            (70, "1"),
            (10, "0"),
            (20, "0"),
            (10, "10"),
            (20, "10"),
            (10, "10"),
            (20, "0"),
            (10, "0"),
            (20, "10"),
        ],
    )];
    let error = refused(&file("", &eight));
    assert_eq!(
        error.to_string(),
        "LWPOLYLINE at line 5: the contour crosses or touches itself at (5.0000 mm, 5.0000 mm): edges 1 and 3\nhint: take the loop out there"
    );
    let open: [(&str, &Groups); 1] =
        [("LWPOLYLINE", &[(70, "0"), (10, "0"), (20, "0"), (10, "10"), (20, "10"), (10, "10"), (20, "0")])];
    assert!(matches!(refused(&file("", &open)), DrawingError::Open { .. }));
    assert_eq!(refused(&file("", &[])), DrawingError::NoContour { left_out: 0 });
}

#[test]
fn damaged_files_are_told_apart() {
    let whole = file("", &TRIANGLE);
    for (bytes, part) in [
        (&b"AutoCAD Binary DXF\r\n\x1a\0"[..], "binary DXF"),
        (b"AC1032\0\0", "DWG"),
        (b" \n", "empty"),
        (b"0\nEOF\n", "no section ENTITIES"),
        (b"hello\nworld\n", "needed the code of a group, got \"hello\""),
        (&whole.as_bytes()[..whole.len() - 30], "needed"),
    ] {
        let error = read_dxf(bytes, &MILLIMETRES).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
    // Names in an old code page do no harm.
    let mut bytes = whole.into_bytes();
    bytes.splice(0..0, *b"999\nBl\xe4tter\n");
    assert!(read_dxf(&bytes, &MILLIMETRES).is_ok());
}

#[test]
fn drawings_below_a_nanometre_are_refused() {
    let dot: [(&str, &Groups); 1] = [("CIRCLE", &[(10, "0"), (20, "0"), (40, "1e-8")])];
    assert!(matches!(refused(&file("", &dot)), DrawingError::TooSmall { .. }));
}
