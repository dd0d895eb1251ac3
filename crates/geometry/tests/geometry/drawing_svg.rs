//! Outlines as SVG: written and read back, files in the style of common programs, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::random_outline;
use crate::support::random_web;

use crate::random_outline::any_star;
use crate::support::random_web::{any_web, assert_same};
use lanchester_geometry::drawing::{DrawingError, DrawingOptions, Place, dxf, read_dxf, read_svg, svg};
use lanchester_geometry::{Contour, GeometryError, Outline, Point};
use proptest::prelude::*;
use std::f64::consts::PI;

const MILLIMETRES: DrawingOptions = DrawingOptions { unit: Some(1e-3), gap: 1e-6, leave_out: Vec::new() };

fn page(inside: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\">\n{inside}\n</svg>"
    )
}

fn read(inside: &str) -> Outline {
    read_svg(page(inside).as_bytes(), &MILLIMETRES)
        .unwrap_or_else(|error| panic!("{inside}: {error}"))
        .outline
}

fn refused(inside: &str) -> DrawingError {
    read_svg(page(inside).as_bytes(), &MILLIMETRES).unwrap_err()
}

/// Area [mm^2] and centroid [mm], y up.
fn assert_figure(inside: &str, area: f64, centroid: [f64; 2]) {
    let moments = read(inside).moments();
    assert!((moments.area * 1e6 / area - 1.0).abs() < 1e-13, "{inside}: {}", moments.area * 1e6);
    let expected = Point::new(centroid[0], centroid[1]) * 1e-3;
    assert!(
        (moments.centroid() - expected).norm() < 1e-15 + 1e-13 * expected.norm(),
        "{inside}: {:?}",
        moments.centroid()
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn prop_svg_gives_the_outline_back(web in any_web(any_star(), prop::collection::vec(any_star(), 0..3))) {
        let text = svg(&web);
        prop_assert!(text.is_ascii() && text == svg(&web) && !text.contains("NaN") && !text.contains("inf"));
        let read = read_svg(text.as_bytes(), &DrawingOptions::default()).unwrap();
        prop_assert!((read.unit / 1e-3 - 1.0).abs() < 1e-15 && read.ignored.is_empty());
        assert_same(&read.outline, &web);
        // And through the other format as well.
        let again = read_dxf(dxf(&read.outline).as_bytes(), &DrawingOptions::default()).unwrap().outline;
        assert_same(&again, &web);
    }

    #[test]
    fn prop_transforms_move_turn_mirror_and_scale(
        web in any_web(any_star(), prop::collection::vec(any_star(), 0..2)),
        turn in -400.0..400.0f64, x in -50.0..50.0f64, y in -50.0..50.0f64, scale in 0.2..3.0f64, mirrored in any::<bool>(),
    ) {
        let text = svg(&web);
        let d = text.split(" d=\"").nth(1).unwrap().split('"').next().unwrap();
        let flip = if mirrored { "scale(1 -1)" } else { "" };
        let placed = read(&format!("<g transform=\"translate({x},{y})rotate({turn})\"><path transform=\"{flip} scale({scale})\" d=\"{d}\"/></g>"));
        let moments = web.moments();
        prop_assert!((placed.moments().area / (moments.area * scale * scale) - 1.0).abs() < 1e-10);
        let centroid = moments.centroid() * scale;
        let flipped = if mirrored { Point::new(centroid.x, -centroid.y) } else { centroid };
        // What turns clockwise in the file's eyes turns anticlockwise with y up.
        let expected = flipped.turned(-turn.to_radians()) + Point::new(x, -y) * 1e-3;
        prop_assert!((placed.moments().centroid() - expected).norm() < 1e-10);
    }

    #[test]
    fn prop_random_bytes_and_path_data_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), d in "[MmLlHhVvAaZzCcQq0-9eE+., -]{0,60}") {
        prop_assert!(read_svg(&bytes, &MILLIMETRES).is_err());
        for d in [d.clone(), format!("M0 0{d}"), format!("M0 0h9v9{d}z")] {
            let shapes = format!("<path transform='rotate({d})' d='M0 0h1v1z'/><path d='{d}'/>");
            for inside in [shapes, format!("<path d='{d}'/>"), format!("<polygon points='{d}'/>")] {
                if let Err(error) = read_svg(page(&inside).as_bytes(), &MILLIMETRES) {
                    prop_assert!(error.to_string().contains("hint: "), "{error}");
                }
            }
        }
    }

    #[test]
    fn prop_mutated_files_never_panic(
        star in any_star(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in any::<Option<prop::sample::Index>>(),
    ) {
        let mut bytes = svg(&Contour::new(&star).unwrap().into()).into_bytes();
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if let Err(error) = read_svg(&bytes, &DrawingOptions::default()) {
            prop_assert!(error.to_string().contains("hint: "), "{error}");
        }
    }
}

#[test]
fn the_page_is_in_millimetres_with_y_turned() {
    // A quarter of a disc in the first quadrant.
    let corner = |x: f64, y: f64, bulge: f64| lanchester_geometry::Corner { at: Point::new(x, y), bulge };
    let quarter = Contour::new(&[
        corner(0.0, 0.0, 0.0),
        corner(0.0625, 0.0, (PI / 8.0).tan()),
        corner(0.0, 0.0625, 0.0),
    ])
    .unwrap();
    let text = svg(&quarter.into());
    assert!(
        text.contains("width=\"68.75mm\" height=\"68.75mm\" viewBox=\"-3.125 -65.625 68.75 68.75\""),
        "{text}"
    );
    assert!(
        text.contains("d=\"M 0.0 0.0 L 62.5 0.0 A 62.5") && text.contains(" 0 0 0 0.0 -62.5 Z\""),
        "{text}"
    );
}

#[test]
fn shapes_have_their_areas_and_centroids() {
    assert_figure("<circle cx='3' cy='4' r='2'/>", 4.0 * PI, [3.0, -4.0]);
    assert_figure("<ellipse cx='3' cy='4' rx='2' ry='2px'/>", 4.0 * PI, [3.0, -4.0]);
    assert_figure("<rect x='1' y='2' width='4' height='6'/>", 24.0, [3.0, -5.0]);
    for radii in ["rx='1'", "ry='1'", "rx='1' ry='1'"] {
        let text = format!("<rect x='1' y='2' width='4' height='6' {radii}/>");
        assert_figure(&text, 24.0 - (4.0 - PI), [3.0, -5.0]);
    }
    // Half the width leaves two half circles, half of both a circle.
    assert_figure("<rect width='4' height='6' rx='2' ry='2'/>", 8.0 + 4.0 * PI, [2.0, -3.0]);
    assert_figure("<rect width='4' height='4' rx='9'/>", 4.0 * PI, [2.0, -2.0]);
    assert_figure("<polygon points='0,0 3,0 0,3'/>", 4.5, [1.0, -1.0]);
    assert_figure(
        "<polyline points='0,0 3,0'/><line x1='0' y1='3' x2='3' y2='0'/><path d='M0 3V0'/>",
        4.5,
        [1.0, -1.0],
    );
    assert_figure("<path d='M0 0h3v3z'/>", 4.5, [2.0, -1.0]);
    assert_figure(
        "<path d='m 0 0 l 3 0 l -3 3 l 0 -3 z m 0.5 .5 v .5 h .5 z'/>",
        4.375,
        [(4.5 - 0.125 * 2.0 / 3.0) / 4.375, -(4.5 - 0.125 * 5.0 / 6.0) / 4.375],
    );
    // Lines may be scaled unevenly.
    assert_figure("<rect width='1' height='1' transform='scale(2 3) skewX(45)'/>", 6.0, [2.0, -1.5]);
}

#[test]
fn a_page_of_a_drawing_program_with_layers_and_notes() {
    let text = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n\
        <!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\">\n\
        <svg width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\" version=\"1.1\" id=\"svg5\"\n\
          xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\"\n\
          xmlns=\"http://www.w3.org/2000/svg\">\n\
        <sodipodi:namedview id=\"namedview7\" inkscape:zoom=\"0.5\"/>\n<defs id=\"defs2\"/>\n\
        <style>.a{fill:none;stroke:#000}</style>\n\
        <g inkscape:label=\"Notes\" inkscape:groupmode=\"layer\" id=\"layer2\"><path d=\"M 0 0 C 1 1 2 2 3 3\"/></g>\n\
        <g inkscape:label=\"Web\" id=\"layer1\" transform=\"translate(-10,-20)\" style=\"display:inline\">\n\
        <path class=\"a\" style=\"fill:none;stroke:#000000;stroke-width:0.2\" d=\"m 50,20 a 40,40 0 0 1 -40,40 40,40 0 0 1 -40,-40 40,40 0 0 1 40,-40 40,40 0 0 1 40,40 z\"/>\n\
        <circle cx=\"10\" cy=\"30\" r=\"5\"><title>oil</title></circle>\n<text x=\"3\" y=\"4\">web</text></g></svg>\n";
    let error = read_svg(text.as_bytes(), &DrawingOptions::default()).unwrap_err();
    let DrawingError::Unsupported { entity, why: "has a Bezier curve", .. } = error else {
        panic!("{error}")
    };
    assert_eq!(entity, Place { entity: "path".to_string(), line: 9 });
    let options = DrawingOptions { leave_out: vec!["Notes".to_string()], ..DrawingOptions::default() };
    let read = read_svg(text.as_bytes(), &options).unwrap();
    assert_eq!(read.unit, 1e-3);
    let exact = PI * (1600.0 - 25.0) * 1e-6;
    assert!((read.outline.moments().area / exact - 1.0).abs() < 1e-14);
    assert!((read.outline.moments().first.y - PI * 25.0 * 0.01e-6).abs() < 1e-18);
    let ignored: Vec<(&str, usize)> =
        read.ignored.iter().map(|i| (&i.entity.entity[..], i.entity.line)).collect();
    assert_eq!(ignored, [("namedview", 6), ("defs", 7), ("style", 8), ("g", 9), ("title", 12), ("text", 13)]);
}

#[test]
fn units_come_from_the_page_or_the_caller() {
    let page = |head: &str| format!("<svg xmlns='http://www.w3.org/2000/svg' {head}><circle r='2'/></svg>");
    let radius = |head: &str| {
        read_svg(page(head).as_bytes(), &DrawingOptions::default()).map(|read| read.outline.swept_radius())
    };
    for (head, unit) in [
        ("width='2in' height='4in' viewBox='0 0 144 288'", 0.0254 / 72.0),
        ("width='72pt' height='144pt' viewBox='0 0 1 2'", 0.0254),
        ("width='21cm' height='297mm' viewBox='0,0,210,297'", 1e-3),
        // A page size rounded by the program.
        ("width='100mm' height='50.01mm' viewBox='0 0 100 50'", 1e-3),
    ] {
        assert!((radius(head).unwrap() / (2.0 * unit) - 1.0).abs() < 1e-14, "{head}");
    }
    for head in [
        "",
        "width='100' height='50' viewBox='0 0 100 50'",
        "width='100px' height='50px' viewBox='0 0 100 50'",
        "width='100%' height='100%' viewBox='0 0 100 50'",
        "width='100mm' height='50mm'",
        "width='100mm' height='80mm' viewBox='0 0 100 50'",
        "width='100mm' height='80mm' viewBox='0 0 0 50'",
    ] {
        assert!(matches!(radius(head), Err(DrawingError::NoUnit { .. })), "{head}");
        let read = read_svg(page(head).as_bytes(), &MILLIMETRES).unwrap();
        assert!((read.outline.swept_radius() - 2e-3).abs() < 1e-17);
    }
}

#[test]
fn what_would_be_lost_or_moved_is_refused_with_its_place() {
    let circle = "<circle r='9'/>";
    for (inside, needed) in [
        ("<ellipse rx='2' ry='3'/>", "is an ellipse"),
        ("<rect width='9' height='9' rx='2' ry='3'/>", "is an ellipse"),
        ("<path d='M0 0\nA1 2 0 0 0 3 3'/>", "has an arc of an ellipse"),
        ("<path d='M0 0 Q1 2 3 3'/>", "has a Bezier curve"),
        ("<circle r='2' transform='scale(1 2)'/>", "has arcs that a transform turns into ellipses"),
        ("<circle r='2' transform='scale(0)'/>", "is scaled to nothing, or beyond all numbers"),
        ("<circle r='0'/>", "has no size"),
        ("<use href='#a'/>", "repeats another element, which is not read"),
        ("<image href='a.png'/>", "is a picture, not a line"),
        ("<svg><circle r='1'/></svg>", "is not known here"),
        ("<switch/>", "is not known here"),
        ("<circle r='1' clip-path='url(#c)'/>", "is cut by a clip path or a mask"),
        ("<circle r='1' style='transform:scale(2)'/>", "is placed by its style"),
        ("<circle r='1' transform-origin='1 1'/>", "is placed by its style"),
        ("<style>.a { fill:none; display : none }</style>", "hides, cuts or moves lines"),
        ("<style>@import 'a.css';</style>", "hides, cuts or moves lines"),
    ] {
        let error = refused(&format!("{circle}\n{inside}"));
        let DrawingError::Unsupported { entity, why, .. } = error else { panic!("{inside}: {error}") };
        assert_eq!(why, needed, "{inside}");
        assert_eq!(entity.line, if inside.contains('\n') { 4 } else { 3 }, "{inside}");
    }
    for inside in
        ["<g display='none'><circle r='1'/></g>", "<circle r='1' style='fill:none;visibility:hidden'/>"]
    {
        assert!(matches!(refused(inside), DrawingError::Hidden { .. }), "{inside}");
    }
    for (inside, needed) in [
        ("<circle r='1mm'/>", "a finite number without a unit"),
        ("<polygon points='1 2 3'/>", "an even number of coordinates"),
        ("<polygon points='1 2 x'/>", "a number"),
        ("<circle r='1' transform='turn(3)'/>", "a transform of SVG"),
        ("<path d='M0 0 L1'/>", "a number"),
    ] {
        let error = refused(inside);
        assert!(
            matches!(error, DrawingError::Syntax { line: 2, needed: found, .. } if found == needed),
            "{error}"
        );
    }
    assert!(matches!(refused("<circle r='1e300'/>"), DrawingError::TooFar { .. }));
    let sheet = format!("<?xml-stylesheet href='a.css'?>{}", page(circle));
    assert!(matches!(read_svg(sheet.as_bytes(), &MILLIMETRES), Err(DrawingError::Unsupported { .. })));
    for (bytes, part) in [
        (&b"<svg"[..], "line 1: "),
        (b"<html/>", "its outermost element is not svg"),
        (b"\xff\xfe", "it is not UTF-8"),
        (b"", "line 1: "),
    ] {
        let error = read_svg(bytes, &MILLIMETRES).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("hint: "), "{error}");
    }
}

#[test]
fn contours_that_make_no_outline_are_refused_with_their_elements() {
    let error = refused("<path d='M0 0 10 10 10 0 0 10z'/>");
    let DrawingError::Contour { entities, error: GeometryError::Crossing { at, .. } } = error else {
        panic!("{error}")
    };
    assert_eq!(entities, [Place { entity: "path".to_string(), line: 2 }]);
    assert!((at - Point::new(0.005, -0.005)).norm() < 1e-15);
    assert!(matches!(refused("<path d='M0 0 10 10 10 0'/>"), DrawingError::Open { .. }));
    assert!(matches!(refused("<circle r='1'/><circle r='1' cx='4'/>"), DrawingError::SeveralOuter { .. }));
    assert!(matches!(refused("<circle r='1'/><circle r='2'/><circle r='3'/>"), DrawingError::Island { .. }));
    assert!(matches!(refused("<circle r='3'/><circle r='3'/>"), DrawingError::Outline { .. }));
    assert_eq!(refused("<text>web</text>"), DrawingError::NoContour { left_out: 1 });
}

#[test]
fn deep_groups_and_entities_that_grow_are_no_danger() {
    let deep = page(&format!("{}<circle r='2'/>{}", "<g>".repeat(20_000), "</g>".repeat(20_000)));
    // Either read or refused.
    if let Ok(read) = read_svg(deep.as_bytes(), &MILLIMETRES) {
        assert!((read.outline.swept_radius() - 2e-3).abs() < 1e-17);
    }
    let mut entities = "<!ENTITY a0 'lol'>".to_string();
    for k in 1..30 {
        entities += &format!("<!ENTITY a{k} '&a{};&a{};'>", k - 1, k - 1);
    }
    let growing = format!(
        "<!DOCTYPE svg [{entities}]><svg xmlns='http://www.w3.org/2000/svg'><text>&a29;</text></svg>"
    );
    assert!(matches!(read_svg(growing.as_bytes(), &MILLIMETRES), Err(DrawingError::Xml { .. })));
}
