//! Chamfered parts as STEP, STL and glTF, read back: volume and centroid are those of the part's mass properties.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::random_outline;
use crate::support::random_chamfer;
use crate::support::step_reader;

use crate::support::random_chamfer::{any_chamfered_part, volume};
use crate::support::step_reader::{ReadSolid, StepFile};
use lanchester_geometry::export::{ExportError, PlacedPart, RESOLUTION, StepHeader, solids, step, stl};
use lanchester_geometry::{Chamfer, Contour, Cut, Edge, Face, Insert, Outline, Part, Point};
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Points may lie off curves and surfaces by the resolution that the file states [mm].
const SLACK: f64 = 1e3 * RESOLUTION;

fn written(part: &Part) -> String {
    step(&solids(&[PlacedPart::new("web", part.clone())]).unwrap(), &StepHeader::default())
}

fn read(text: &str) -> ReadSolid {
    StepFile::parse(text).solids(SLACK).remove(0)
}

/// Relative to the volume, and to the size of the part: 1e-6.
fn agrees(solid: &ReadSolid, (volume, centroid): (f64, [f64; 3]), size: f64) -> bool {
    (solid.volume * 1e-9 / volume - 1.0).abs() < 1e-6
        && (0..3).all(|i| (solid.centroid[i] * 1e-3 - centroid[i]).abs() < 1e-6 * size)
}

fn chamfer(cut: Cut, angle: f64, face: Face) -> Chamfer {
    Chamfer { cut, angle, face }
}

fn turned(radius: f64) -> Cut {
    Cut::Turned { radius }
}

fn milled(direction: f64, distance: f64) -> Cut {
    Cut::Milled { direction, distance }
}

fn plate(outline: Outline) -> Part {
    Part::new(outline, 0.02, 7850.0).unwrap()
}

fn disc(x: f64, radius: f64) -> Outline {
    Contour::circle(Point::new(x, 0.0), radius).unwrap().into()
}

fn square() -> Outline {
    let corners = [(-0.04, -0.04), (0.04, -0.04), (0.04, 0.04), (-0.04, 0.04)];
    Contour::polygon(&corners.map(|(x, y)| Point::new(x, y))).unwrap().into()
}

/// The triangles of a binary STL file [m].
fn triangles(bytes: &[u8]) -> Vec<[[f64; 3]; 3]> {
    let float = |bytes: &[u8]| f64::from(f32::from_le_bytes(bytes[..4].try_into().unwrap())) * 1e-3;
    let corner = |record: &[u8], k: usize| [0, 1, 2].map(|i| float(&record[12 + 12 * k + 4 * i..]));
    bytes[84..].chunks_exact(50).map(|record| [0, 1, 2].map(|k| corner(record, k))).collect()
}

/// Every side of a triangle is one of another, run the other way.
fn is_watertight(triangles: &[[[f64; 3]; 3]]) -> bool {
    let mut sides: BTreeMap<[[u64; 3]; 2], i32> = BTreeMap::new();
    for triangle in triangles {
        let bits = triangle.map(|corner| corner.map(f64::to_bits));
        for k in 0..3 {
            let (from, to) = (bits[k], bits[(k + 1) % 3]);
            let (key, sign) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
            *sides.entry(key).or_default() += sign;
        }
    }
    sides.values().all(|sum| *sum == 0)
}

/// Volume and area of a mesh.
fn measured(triangles: &[[[f64; 3]; 3]]) -> (f64, f64) {
    let (mut volume, mut area) = (0.0, 0.0);
    for [a, b, c] in triangles {
        let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        volume += (0..3).map(|i| a[i] * cross[i]).sum::<f64>() / 6.0;
        area += cross.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0;
    }
    (volume, area)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn prop_step_solids_with_chamfers_have_the_volume_of_the_part(part in any_chamfered_part(), turn in -4.0..4.0f64) {
        let placed = PlacedPart::new("web", part.clone()).turned(turn);
        let text = match solids(&[placed]) {
            Ok(solids) => step(&solids, &StepHeader::default()),
            // An edge of no length, or a line that only touches: said, never wrong.
            Err(ExportError::ShortEdge { .. } | ExportError::NoWall { .. } | ExportError::ChamferTouches { .. }) => return Ok(()),
            Err(other) => panic!("{other}"),
        };
        let (exact, [x, y, z]) = volume(&part);
        let Point { x, y } = Point::new(x, y).turned(turn);
        let solid = read(&text);
        prop_assert!(agrees(&solid, (exact, [x, y, z]), part.outline().swept_radius()), "{:?} against {} {:?}", solid, exact, [x, y, z]);
    }

    #[test]
    fn prop_meshes_with_chamfers_are_watertight_and_within_the_facet_error(part in any_chamfered_part(), power in -5.5..-4.0f64) {
        let facet_error = 10f64.powf(power);
        let Ok(made) = solids(&[PlacedPart::new("web", part.clone())]) else { return Ok(()) };
        let bytes = match stl(&made, facet_error) {
            Ok(bytes) => bytes,
            Err(ExportError::FacetsCross { .. }) => return Ok(()),
            Err(other) => panic!("{other}"),
        };
        let all = triangles(&bytes);
        prop_assert!(is_watertight(&all));
        let ((found, area), (exact, _)) = (measured(&all), volume(&part));
        // No place of the surface lies farther off than the facet error.
        prop_assert!((found - exact).abs() <= facet_error * area, "{} {}", found, exact);
        let [front, rear] = part.faces();
        // 32-bit floats of 0.15 m times the slope.
        let slack = 1e-7 * (1.0 + part.chamfers().iter().map(|c| c.angle.tan()).fold(0.0, f64::max));
        for (face, z, into) in [(Face::Front, front, 1.0), (Face::Rear, rear, -1.0)] {
            let cuts: Vec<&Chamfer> = part.chamfers().iter().filter(|chamfer| chamfer.face == face).collect();
            // How far a point lies inside the end of the part.
            let inside = |[x, y, height]: [f64; 3]| {
                let depth = cuts.iter().map(|chamfer| chamfer.depth(Point::new(x, y))).fold(0.0, f64::max);
                into * (height - z) - depth
            };
            let flattest = cuts.iter().map(|chamfer| chamfer.angle.cos()).fold(1.0, f64::min);
            for triangle in &all {
                prop_assert!(triangle.iter().all(|corner| inside(*corner) > -slack));
                if triangle.iter().any(|corner| inside(*corner) > slack) {
                    continue;
                }
                // On the end: its sides and its middle lie within the facet error of face and chamfers.
                let mean = |weights: [f64; 3]| {
                    [0, 1, 2].map(|i| (0..3).map(|k| weights[k] * triangle[k][i]).sum::<f64>())
                };
                let third = 1.0 / 3.0;
                for weights in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [third; 3]] {
                    let off = inside(mean(weights)).abs() * flattest;
                    prop_assert!(off < facet_error + slack, "{} of {}", off, facet_error);
                }
            }
        }
    }
}

#[test]
fn every_kind_of_edge_is_the_exact_curve() {
    // Part, chamfer, and which curves there must be and must not.
    let cases: [(Outline, Cut, &[&str], &[&str]); 5] = [
        (square(), milled(0.0, 0.03), &["PLANE"], &["ELLIPSE", "HYPERBOLA", "SPLINE", "CONICAL", "CIRCLE"]),
        (square(), turned(0.035), &["HYPERBOLA", "CONICAL_SURFACE"], &["ELLIPSE", "SPLINE"]),
        (disc(0.0, 0.05), turned(0.045), &["CONICAL_SURFACE", "CIRCLE"], &["ELLIPSE", "HYPERBOLA", "SPLINE"]),
        (disc(0.01, 0.05), milled(0.4, 0.04), &["ELLIPSE"], &["HYPERBOLA", "SPLINE", "CONICAL"]),
        (
            disc(0.01, 0.05),
            turned(0.045),
            &["B_SPLINE_CURVE_WITH_KNOTS", "CONICAL_SURFACE"],
            &["ELLIPSE", "HYPERBOLA"],
        ),
    ];
    for (outline, cut, present, absent) in cases {
        for face in [Face::Front, Face::Rear] {
            let part = plate(outline.clone()).with_chamfer(chamfer(cut, 0.6, face)).unwrap();
            let text = written(&part);
            for kind in present {
                assert!(text.contains(kind), "{cut:?}: no {kind}");
            }
            for kind in absent {
                assert!(!text.contains(kind), "{cut:?}: {kind}");
            }
            let solid = read(&text);
            assert!(agrees(&solid, volume(&part), 0.05), "{cut:?}: {solid:?} against {:?}", volume(&part));
        }
    }
}

#[test]
fn a_frustum_keeps_its_digits_and_its_bores() {
    let part =
        plate(disc(0.0, 0.05)).with_chamfer(chamfer(turned(0.045), std::f64::consts::FRAC_PI_4, Face::Rear));
    let bore = Insert { centre: Point::new(0.02, 0.0), radius: 0.008, from: 0.0, to: 0.02, density: 0.0 };
    let part = part.unwrap().with_insert(bore).unwrap();
    let solid = read(&written(&part));
    let frustum = std::f64::consts::PI * 5.0 / 3.0 * (50.0f64.powi(2) + 50.0 * 45.0 + 45.0f64.powi(2));
    let exact = frustum + std::f64::consts::PI * (2500.0 * 15.0 - 64.0 * 20.0);
    assert!((solid.volume / exact - 1.0).abs() < 1e-12, "{} {exact}", solid.volume);
    // Two halves of the rim and of the bore, two faces, the chamfer.
    assert_eq!(solid.faces, 7);
}

#[test]
fn a_chamfer_through_the_whole_thickness_is_refused() {
    let depth = chamfer(milled(0.0, 0.03), 2.0f64.atan(), Face::Front);
    let part = plate(square()).with_chamfer(depth).unwrap();
    let error = solids(&[PlacedPart::new("web", part)]).unwrap_err();
    assert!(matches!(error, ExportError::TooThin { .. }), "{error}");
}

#[test]
fn a_chamfer_that_only_touches_cuts_nothing() {
    let arc = Edge::arc(Point::ORIGIN, 0.05, -1.0, 2.0);
    let outline = Contour::from_edges(
        &[arc, Edge::line(arc.to, Point::new(-0.01, 0.0)), Edge::line(Point::new(-0.01, 0.0), arc.from)],
        1e-12,
    );
    let part = plate(outline.unwrap().into()).with_chamfer(chamfer(turned(0.05), 0.5, Face::Rear)).unwrap();
    assert!(!written(&part).contains("CONICAL"));
    assert!(agrees(&read(&written(&part)), volume(&part), 0.05));
}
