//! STEP files read back by a reader of their own: closed shells, volume and centroid over the analytic faces.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::random_outline;
use crate::support::random_part;
use crate::support::step_reader;

use crate::support::random_part::{any_part, volumes};
use crate::support::step_reader::{ReadSolid, StepFile};
use lanchester_geometry::export::{ExportError, PlacedPart, RESOLUTION, StepHeader, solids, step};
use lanchester_geometry::{Contour, Corner, Insert, Outline, Part, Point};
use proptest::prelude::*;

/// Points may lie off curves and surfaces by the resolution that the file states [mm].
const SLACK: f64 = 1e3 * RESOLUTION;

fn read(parts: &[PlacedPart]) -> Vec<ReadSolid> {
    StepFile::parse(&step(&solids(parts).unwrap(), &StepHeader::default())).solids(SLACK)
}

fn disc(radius: f64) -> Outline {
    Contour::circle(Point::ORIGIN, radius).unwrap().into()
}

fn plate(radius: f64, thickness: f64) -> Part {
    Part::new(disc(radius), thickness, 7850.0).unwrap()
}

fn insert(x: f64, radius: f64, from: f64, to: f64, density: f64) -> Insert {
    Insert { centre: Point::new(x, 0.0), radius, from, to, density }
}

/// Relative to the volume, and to its largest coordinate: 1e-6 is promised, rounding and flat arcs leave less.
fn agrees(solid: &ReadSolid, (volume, centroid): (f64, [f64; 3])) -> bool {
    let size = centroid.iter().fold(0.05f64, |most, x| most.max(x.abs()));
    (solid.volume * 1e-9 / volume - 1.0).abs() < 1e-6
        && (0..3).all(|i| (solid.centroid[i] * 1e-3 - centroid[i]).abs() < 1e-6 * size)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn prop_step_solids_are_closed_and_have_the_volume_of_the_part(part in any_part()) {
        let read = read(&[PlacedPart::new("web", part.clone())]);
        let exact = volumes(&part);
        prop_assert_eq!(read.len(), exact.len());
        for (solid, exact) in read.iter().zip(exact) {
            prop_assert!(agrees(solid, exact), "{:?} against {:?}", solid, exact);
        }
    }

    #[test]
    fn prop_placing_moves_and_turns_the_solid(part in any_part(), z in -0.3..0.3f64, turn in -4.0..4.0f64) {
        let read = read(&[PlacedPart::new("web", part.clone()).turned(turn).moved(z)]);
        for (solid, (volume, [x, y, height])) in read.iter().zip(volumes(&part)) {
            let Point { x, y } = Point::new(x, y).turned(turn);
            prop_assert!(agrees(solid, (volume, [x, y, height + z])), "{:?}", solid);
        }
    }
}

#[test]
fn discs_and_rings_keep_all_digits() {
    let ring = Outline::new(
        Contour::circle(Point::ORIGIN, 0.05).unwrap(),
        vec![Contour::circle(Point::new(0.01, 0.0), 0.02).unwrap()],
    );
    let part = Part::new(ring.unwrap(), 0.02, 7850.0).unwrap();
    let read = read(&[PlacedPart::new("ring", part)]);
    let exact = std::f64::consts::PI * (50.0f64.powi(2) - 20.0f64.powi(2)) * 20.0;
    assert!((read[0].volume / exact - 1.0).abs() < 1e-13, "{}", read[0].volume);
    assert_eq!(read[0].faces, 6);
}

#[test]
fn bores_are_shoulders_cavities_and_solids_of_their_own() {
    let part = plate(0.05, 0.02)
        .with_insert(insert(0.02, 0.008, 0.0, 0.012, 0.0))
        .and_then(|part| part.with_insert(insert(0.02, 0.005, 0.012, 0.02, 18_000.0)))
        .and_then(|part| part.with_insert(insert(-0.02, 0.006, 0.005, 0.015, 17_000.0)))
        .and_then(|part| part.with_insert(insert(0.0, 0.004, 0.0, 0.01, 18_000.0)))
        .and_then(|part| part.with_insert(insert(0.0, 0.004, 0.01, 0.02, 0.0)))
        .unwrap();
    let text = step(&solids(&[PlacedPart::new("web", part.clone())]).unwrap(), &StepHeader::default());
    assert_eq!(text.matches("BREP_WITH_VOIDS").count(), 1);
    let file = StepFile::parse(&text);
    assert!(file.is_in_millimetres());
    let read = file.solids(SLACK);
    let names: Vec<&str> = read.iter().map(|solid| solid.name.as_str()).collect();
    assert_eq!(names, ["web", "web, insert 2", "web, insert 3", "web, insert 4"]);
    // Rim 2 and faces 2; stepped bore 4 and a shoulder; cavity 2 and 2; one bore through for two inserts of one radius 2.
    assert_eq!(read[0].faces, 4 + 5 + 4 + 2);
    for (solid, exact) in read.iter().zip(volumes(&part)) {
        assert!(agrees(solid, exact), "{solid:?} against {exact:?}");
    }
}

#[test]
fn an_assembly_keeps_names_colours_and_places() {
    let journal = || plate(0.03, 0.025);
    let pin = Part::new(Contour::circle(Point::new(0.04, 0.0), 0.02).unwrap().into(), 0.03, 7850.0).unwrap();
    let parts = [
        PlacedPart::new("journal 1", journal()),
        PlacedPart::new("pin 1", pin.clone()).turned(0.5).moved(0.1).coloured([1.0, 0.5, -3.0]),
        PlacedPart::new("journal 2's 'ü\\'", journal()).moved(0.2),
    ];
    let text = step(&solids(&parts).unwrap(), &StepHeader::default());
    assert!(text.contains("COLOUR_RGB('',1.,0.5,0.)"));
    let file = StepFile::parse(&text);
    let read = file.solids(SLACK);
    assert_eq!(read[1].name, "pin 1");
    assert_eq!(read[2].name, "journal 2's '\\X2\\00FC\\X0\\\\\\'");
    let Point { x, y } = Point::polar(0.04, 0.5);
    assert!(agrees(&read[1], (std::f64::consts::PI * 0.0004 * 0.03, [x, y, 0.1])), "{:?}", read[1]);
    let styled = file.entities.values().filter(|entity| entity[0].0 == "STYLED_ITEM").count();
    assert_eq!(styled, 3);
}

#[test]
fn the_same_solids_give_the_same_bytes_and_the_time_is_the_callers() {
    let once =
        || step(&solids(&[PlacedPart::new("web", plate(0.05, 0.02))]).unwrap(), &StepHeader::default());
    assert_eq!(once(), once());
    let header = StepHeader { title: "crank".into(), time: "2026-11-21T20:00:00".into() };
    let text = step(&solids(&[PlacedPart::new("web", plate(0.05, 0.02))]).unwrap(), &header);
    assert!(text.contains("FILE_NAME('crank','2026-11-21T20:00:00',"));
    assert!(once().contains("'1970-01-01T00:00:00'"));
}

#[test]
fn arcs_that_hardly_leave_their_chord_become_lines() {
    // 5 nm over a chord of 100 mm: a radius of 250 km, whose centre would cost the digits that it describes.
    let corner = |x: f64, y: f64, bulge: f64| Corner { at: Point::new(x, y), bulge };
    let square = |bulge: f64| {
        let corners =
            [corner(0.0, 0.0, bulge), corner(0.1, 0.0, 0.0), corner(0.1, 0.1, 0.0), corner(0.0, 0.1, 0.0)];
        let part = Part::new(Contour::new(&corners).unwrap().into(), 0.02, 7850.0).unwrap();
        step(&solids(&[PlacedPart::new("square", part)]).unwrap(), &StepHeader::default())
    };
    assert!(!square(1e-7).contains("CIRCLE"));
    assert!(square(1e-6).contains("CIRCLE"));
}

#[test]
fn what_cannot_be_exported_is_refused() {
    assert_eq!(solids(&[]).unwrap_err(), ExportError::NoPart);
    let refused = |inserts: &[Insert]| {
        let part = inserts.iter().fold(plate(0.05, 0.02), |part, insert| part.with_insert(*insert).unwrap());
        solids(&[PlacedPart::new("web", part)]).unwrap_err()
    };
    // Side by side without a wall, one behind the other off the axis, onto the rim.
    let beside = refused(&[insert(0.0, 0.01, 0.0, 0.02, 0.0), insert(0.02, 0.01, 0.0, 0.02, 0.0)]);
    assert!(matches!(beside, ExportError::InsertsTouch { .. }), "{beside}");
    let behind = refused(&[insert(0.0, 0.01, 0.0, 0.01, 0.0), insert(0.005, 0.01, 0.01, 0.02, 0.0)]);
    assert!(matches!(behind, ExportError::InsertsTouch { .. }), "{behind}");
    let rim = refused(&[insert(0.04, 0.01 - 1e-9, 0.0, 0.02, 0.0)]);
    assert!(matches!(rim, ExportError::NoWall { wall, .. } if wall < 2e-9), "{rim}");
    let placed = PlacedPart::new("web", plate(0.05, 0.02)).moved(f64::NAN);
    assert!(matches!(solids(&[placed]).unwrap_err(), ExportError::Place { .. }));
    let thin = PlacedPart::new("web", plate(0.05, 1e-9));
    assert!(matches!(solids(&[thin]).unwrap_err(), ExportError::TooThin { what: "thickness", .. }));
    let thin = refused(&[insert(0.0, 0.01, 0.0, 1e-9, 0.0)]);
    assert!(matches!(thin, ExportError::TooThin { what: "length of an insert", .. }), "{thin}");
    let short = [Point::ORIGIN, Point::new(0.01, 0.0), Point::new(0.01, 5e-9), Point::new(0.0, 0.01)];
    let part = Part::new(Contour::polygon(&short).unwrap().into(), 0.02, 7850.0).unwrap();
    let error = solids(&[PlacedPart::new("web", part)]).unwrap_err();
    assert!(matches!(error, ExportError::ShortEdge { length, .. } if length < 6e-9), "{error}");
}

#[test]
fn a_wrong_file_would_be_seen() {
    let text = step(&solids(&[PlacedPart::new("web", plate(0.05, 0.02))]).unwrap(), &StepHeader::default());
    let is_refused = |text: String| {
        std::panic::catch_unwind(|| {
            let read = StepFile::parse(&text).solids(SLACK);
            assert!(agrees(&read[0], (std::f64::consts::PI * 0.0025 * 0.02, [0.0; 3])));
        })
        .is_err()
    };
    assert!(!is_refused(text.clone()));
    // Radii, a unit vector, the senses of a face and of an edge, a point.
    for (after, from, to) in [
        ("CYLINDRICAL_SURFACE", ",50.);", ",50.001);"),
        ("CIRCLE", ",50.);", ",50.001);"),
        ("EDGE_CURVE", "(0.,0.,1.)", "(0.,0.,2.)"),
        ("ADVANCED_FACE", ",.T.);", ",.F.);"),
        ("ORIENTED_EDGE", ",.F.);", ",.T.);"),
        ("VERTEX_POINT", ",10.)", ",11.)"),
    ] {
        let (before, rest) = text.split_at(text.find(after).unwrap());
        assert!(rest.contains(from), "{after} {from}");
        assert!(is_refused(format!("{before}{}", rest.replacen(from, to, 1))), "{after} {from} -> {to}");
    }
}
