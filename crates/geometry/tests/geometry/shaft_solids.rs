//! Balance shafts as solids, through STEP, and their swept circles.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::hand_made::{RADIUS, counterweight, cylinder, engine, rod_envelope, sector};
use crate::support::step_reader::StepFile;
use lanchester_geometry::clearance::{SweptOverlap, swept_overlaps};
use lanchester_geometry::export::{RESOLUTION, StepHeader, solids, step};
use lanchester_geometry::{ShaftWeightPart, ShaftWeightShape, shaft_solids};
use lanchester_model::{BalanceShaft, Engine, Ratio, ShaftWeight};
use proptest::prelude::*;
use std::f64::consts::PI;

fn weight(z: f64, phase: f64, [shaft_radius, radius, chord, length]: [f64; 4]) -> ShaftWeight {
    let shape = ShaftWeightShape { shaft_radius, radius, chord };
    let part = ShaftWeightPart { shape, length, density: 7850.0, wanted: None };
    ShaftWeight { z, unbalance: part.unbalance(), phase, part: Some(part) }
}

fn shaft(name: &str, [x, y]: [f64; 2], weights: Vec<ShaftWeight>) -> BalanceShaft {
    BalanceShaft { name: name.to_string(), ratio: Ratio::new(-2, 1).unwrap(), x, y, weights, inertia: None }
}

/// Area and first moment of what a disc has beyond a chord, by the textbook's formulas.
fn segment(radius: f64, chord: f64) -> [f64; 2] {
    if chord <= -radius {
        return [PI * radius * radius, 0.0];
    }
    let half = (radius * radius - chord * chord).sqrt();
    [radius * radius * (chord / radius).acos() - chord * half, 2.0 / 3.0 * half.powi(3)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn prop_step_of_a_shaft_has_its_volumes_and_centres(
        r in 0.005..0.02f64, beyond in 0.003..0.04f64, part in 0.02..0.98f64, length in 0.005..0.1f64, second in 0.005..0.02f64,
        axis in prop::array::uniform2(-0.2..0.2f64), phase in -7.0..7.0f64, z in -0.3..0.3f64, gap in 0.001..0.2f64,
    ) {
        let radius = r + beyond;
        let chord = -radius + part * (radius + r);
        let one = [r, radius, chord, length];
        let other = [second, second + 0.02, 0.3 * second, 0.03];
        let z2 = z + length / 2.0 + gap + 0.015;
        // The one behind comes first in the file.
        let shaft = shaft("left", axis, vec![weight(z2, phase + 1.0, other), weight(z, phase, one)]);
        let file = step(&solids(&shaft_solids(&shaft).unwrap()).unwrap(), &StepHeader::default());
        let read = StepFile::parse(&file).solids(1e3 * RESOLUTION);
        let names: Vec<&str> = read.iter().map(|solid| solid.name.as_str()).collect();
        prop_assert_eq!(names, ["left weight 1", "left weight 2", "left bar"]);
        let expected = [(other, z2, phase + 1.0), (one, z, phase)].map(|([r, radius, chord, length], z, phase)| {
            let ([area, first], [shaft, within]) = (segment(radius, chord), segment(r, chord.max(-r)));
            let (area, first) = (area - shaft + PI * r * r, first - within);
            let out = first / area;
            (area * length, [axis[0] + out * phase.cos(), axis[1] + out * phase.sin(), z])
        });
        let bar = (PI * r.min(second).powi(2) * gap, [axis[0], axis[1], z + length / 2.0 + gap / 2.0]);
        for (solid, (volume, centre)) in read.iter().zip(expected.into_iter().chain([bar])) {
            prop_assert!((solid.volume * 1e-9 / volume - 1.0).abs() < 1e-6, "{:?} {}", solid, volume);
            for (read, centre) in solid.centroid.iter().zip(centre) {
                prop_assert!((read * 1e-3 - centre).abs() < 1e-6 * 0.3, "{:?} {:?}", solid, centre);
            }
        }
    }
}

#[test]
fn weights_without_a_shape_are_left_out() {
    let bare = shaft("left", [0.1, 0.0], vec![ShaftWeight::new(0.0, 0.001, 0.0)]);
    assert!(shaft_solids(&bare).unwrap().is_empty());
    let mut half = bare;
    half.weights.push(weight(0.1, 0.0, [0.01, 0.03, 0.0, 0.02]));
    let parts = shaft_solids(&half).unwrap();
    assert_eq!(parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>(), ["left weight 2"]);
    // Two weights that touch have no bar between them.
    half.weights.push(weight(0.12, 0.0, [0.01, 0.03, 0.0, 0.02]));
    assert_eq!(shaft_solids(&half).unwrap().len(), 2);
}

fn with_shafts(shafts: Vec<BalanceShaft>) -> Engine {
    let counterweight = counterweight(sector(0.06, 0.5), [-0.03, -0.01], None);
    engine(vec![cylinder(0, 0.0, 0.0)], vec![counterweight]).with(|parts| parts.shafts = shafts).unwrap()
}

fn found(engine: &Engine) -> Vec<(String, String, f64, [f64; 2])> {
    let rounded = |value: f64| (value * 1e9).round() * 1e-9;
    let one = |overlap: SweptOverlap| {
        let faces = [rounded(overlap.from), rounded(overlap.to)];
        (overlap.weight, overlap.other, rounded(overlap.depth), faces)
    };
    swept_overlaps(engine).unwrap().into_iter().map(one).collect()
}

#[test]
fn swept_circles_overlap_only_in_one_plane() {
    // The counterweight sweeps 60 mm from z -30 to -10 mm, the crankpin its radius at z = 0.
    let sizes = [0.01, 0.03, 0.0, 0.02];
    let at = |z: f64, y: f64| with_shafts(vec![shaft("left", [0.0, y], vec![weight(z, 0.0, sizes)])]);
    assert_eq!(found(&at(-0.015, 0.0901)), []);
    let beside = found(&at(-0.015, 0.085));
    assert_eq!(beside, [("left".to_string(), "counterweight".to_string(), 0.005, [-0.025, -0.01])]);
    // Behind it there is the crankpin alone.
    assert_eq!(found(&at(0.001, 0.085)), []);
    let pin = found(&at(0.001, RADIUS + 0.029));
    assert_eq!(pin, [("left".to_string(), "crankpin 1".to_string(), 0.001, [0.0, 0.0])]);
    // And the big end where its envelope is known.
    let mut with_rod = at(0.015, RADIUS + 0.055);
    assert_eq!(found(&with_rod), []);
    with_rod = with_rod
        .with(|with_rod| {
            with_rod.envelope.as_mut().unwrap().rod = rod_envelope();
        })
        .unwrap();
    let big_end = found(&with_rod);
    assert_eq!(big_end, [("left".to_string(), "big end 1".to_string(), 0.005, [0.005, 0.01])]);
}

#[test]
fn shafts_are_held_against_each_other() {
    let sizes = [0.01, 0.03, 0.0, 0.02];
    let two = |z: f64, x: f64| {
        let left = shaft("left", [0.3, 0.0], vec![weight(0.0, 0.0, sizes), weight(0.01, PI, sizes)]);
        with_shafts(vec![left, shaft("right", [x, 0.0], vec![weight(z, 0.0, sizes)])])
    };
    assert_eq!(found(&two(0.0, 0.361)), []);
    assert_eq!(found(&two(-0.02, 0.35)), []);
    let overlaps = found(&two(-0.005, 0.35));
    let expected = |name: &str, to: f64, from: f64| (name.to_string(), "right".to_string(), 0.01, [from, to]);
    assert_eq!(overlaps, [expected("left weight 1", 0.005, -0.01), expected("left weight 2", 0.005, 0.0)]);
}
