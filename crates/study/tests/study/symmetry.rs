//! Duplicates: counted right against brute force, and invisible in every objective.
use crate::support::{explorer, full, space, two};
use lanchester_model::Strokes;
use lanchester_study::explore::*;
use num_complex::Complex64;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// A layout boiled down to what is physically there: for every cylinder its plane, axis, pin angle and firing angle (in
/// steps), for every web its weight, for every shaft its axis and planes. Places in 1e-6 m, angles in 1e-6 of a turn.
type Fingerprint = (Vec<[i64; 4]>, Vec<(i64, bool)>, Vec<[i64; 6]>);

/// An angle in steps of 1e-6 of a turn, in a cycle of so many revolutions.
fn wrapped(angle: f64, revolutions: i64) -> i64 {
    (angle / TAU * 1e6).round().rem_euclid(1e6 * revolutions as f64) as i64
}

fn place(z: f64) -> i64 {
    (z * 1e6).round() as i64
}

/// A shaft from another side.
fn shaft(design: &ShaftDesign, ends: f64, mirror: f64, turn: f64) -> [i64; 6] {
    let (kind, z) = match design.removes {
        Removes::Force { z } => (0, [z, z]),
        Removes::Couple { z } => (1, z),
        Removes::Both { z } => (2, z),
    };
    let mut z = z.map(|z| place(ends * z));
    z.sort_unstable();
    let axis = Complex64::new(design.x, mirror * design.y) * Complex64::cis(turn);
    let turns = i64::from(design.order) * if design.sense == Sense::Forward { 1 } else { -1 };
    [kind, turns, place(axis.re), place(axis.im), z[0], z[1]]
}

/// The layout from every side: ends, mirror, and every half turn of the block that leaves its axes, brute force. Throw 1 and
/// the time of firing are taken out by trying every cylinder as the first.
fn orbit(layout: &Layout, cycle: i64) -> BTreeSet<Fingerprint> {
    let (axes, leads, places) = (layout.bank_axes(), layout.pin_leads(), layout.bank_places());
    let groups = layout.groups();
    let cylinders: Vec<[f64; 4]> = (0..layout.cylinders)
        .map(|index| {
            let (bank, group) = (index / groups, index % groups);
            let firing = layout.firing_angles.as_ref().map_or(0.0, |angles| angles[index]);
            let pin = layout.throw_angles[group] + leads[bank];
            [layout.group_plane(group) + places[bank], axes[bank], pin, firing]
        })
        .collect();
    let webs: Vec<(f64, bool)> = (0..2 * groups)
        .map(|web| {
            let has = layout.counterweights.webs.as_ref().is_none_or(|webs| webs[web]);
            (layout.group_plane(web / 2) + if web % 2 == 0 { -0.02 } else { 0.02 }, has)
        })
        .collect();
    let mut orbit = BTreeSet::new();
    for ends in [1.0, -1.0] {
        for mirror in [1.0, -1.0] {
            // The block may be turned so that its set of axes is as before.
            for turn in [0.0, PI, axes.iter().sum::<f64>(), axes.iter().sum::<f64>() + PI] {
                let seen: Vec<[f64; 4]> = cylinders
                    .iter()
                    .map(|c| [ends * c[0], mirror * c[1] + turn, mirror * c[2] + turn, mirror * c[3]])
                    .collect();
                let same = |a: &f64, b: &f64| (Complex64::cis(*a) - Complex64::cis(*b)).norm() < 1e-6;
                if !axes.iter().all(|axis| seen.iter().any(|c| same(&c[1], axis))) {
                    continue;
                }
                // Theta counts from throw 1: the pin of bank 1 in the first group; firing from its cylinder.
                let first = seen
                    .iter()
                    .filter(|c| same(&c[1], &axes[0]))
                    .min_by(|a, b| a[0].total_cmp(&b[0]))
                    .expect("a cylinder");
                let mut fingerprint: Vec<[i64; 4]> = seen
                    .iter()
                    .map(|c| {
                        [
                            place(c[0]),
                            wrapped(c[1], 1),
                            wrapped(c[2] - first[2], 1),
                            wrapped(c[3] - first[3], cycle),
                        ]
                    })
                    .collect();
                fingerprint.sort_unstable();
                let mut weights: Vec<(i64, bool)> = webs.iter().map(|w| (place(ends * w.0), w.1)).collect();
                weights.sort_unstable();
                let mut shafts: Vec<_> =
                    layout.shafts.shafts.iter().map(|s| shaft(s, ends, mirror, turn)).collect();
                shafts.sort_unstable();
                orbit.insert((fingerprint, weights, shafts));
            }
        }
    }
    orbit
}

/// Sizes of all first- and second-order loads of a case.
fn sizes(explorer: &Explorer, case: u128) -> Vec<f64> {
    let orders = explorer.orders(case).expect("loads");
    let force = orders.force.iter().flatten().map(|f| f.norm());
    let couple = orders.couple.iter().flatten().map(|m| m.norm());
    let about_z = orders.roll_moment.iter().chain(&orders.shaft_torque).map(|t| t.norm());
    force.chain(couple).chain(about_z).collect()
}

/// Kinds of layout in a space, by brute force. Layouts of one kind must have the same loads.
fn kinds(explorer: &Explorer) -> u128 {
    let parts = explorer.request().space.parts;
    let cycle = i64::from(parts.strokes.revolutions());
    let scale = 24.0 * parts.crank_radius * parts.speed.powi(2);
    let mut seen: BTreeMap<Fingerprint, u128> = BTreeMap::new();
    let mut kinds = 0;
    for case in 0..explorer.size() {
        let layout = explorer.layout(case).expect("a case");
        let orbit = orbit(&layout, cycle);
        match orbit.iter().find_map(|view| seen.get(view)) {
            None => kinds += 1,
            Some(&other) => {
                for (a, b) in sizes(explorer, case).iter().zip(sizes(explorer, other)) {
                    assert!((a - b).abs() < 1e-12 * scale, "cases {case} and {other}: {a} and {b}");
                }
            }
        }
        for view in orbit {
            seen.entry(view).or_insert(case);
        }
    }
    kinds
}

#[track_caller]
fn counted_right(space: Space) {
    let explorer = explorer(space, &[Objective::Shafts], &[]);
    let found = explorer.explore().expect("it runs");
    assert_eq!(found.counts.judged, kinds(&explorer), "{:?}", explorer.request().space);
    assert_eq!(found.counts.judged + found.counts.duplicates, explorer.size());
}

#[test]
fn in_line_orbits() {
    for cylinders in 1..=5 {
        counted_right(space(cylinders, 4, Banks::InLine, false));
    }
    counted_right(space(3, 6, Banks::InLine, true));
    counted_right(space(4, 4, Banks::InLine, true));
    counted_right(space(4, 3, Banks::InLine, true));
}

#[test]
fn lists_that_are_not_symmetric_themselves() {
    let mut space = space(4, 4, Banks::InLine, false);
    space.throw_angles = [0.0, 30.0, 90.0, 200.0].map(f64::to_radians).to_vec();
    counted_right(space.clone());
    space.throw_angles = [30.0, 330.0, 90.0].map(f64::to_radians).to_vec();
    counted_right(space);
}

#[test]
fn v_orbits() {
    counted_right(space(6, 6, two(&[60.0, 90.0], &[0.0, -30.0, 30.0], &[0.02]), false));
    counted_right(space(6, 4, two(&[60.0], &[0.0, 30.0], &[0.02, -0.02]), false));
    counted_right(space(4, 4, two(&[90.0], &[0.0, -30.0], &[0.02]), true));
    counted_right(space(4, 4, two(&[90.0], &[0.0], &[0.02, -0.02, 0.0]), true));
}

#[test]
fn flat_orbits() {
    counted_right(space(4, 6, two(&[180.0], &[0.0, 180.0, 60.0, 300.0], &[0.04]), true));
    counted_right(space(4, 6, two(&[180.0], &[0.0, 180.0, 60.0, 300.0], &[0.04, -0.04]), true));
    counted_right(space(6, 4, two(&[180.0, 120.0], &[0.0, 180.0], &[0.04]), false));
}

#[test]
fn web_patterns_are_seen_from_the_other_end() {
    let pattern = |webs: &[u8]| CounterweightPattern {
        name: "some".into(),
        webs: Some(webs.iter().map(|&web| web == 1).collect()),
        ..full()
    };
    let mut space = space(3, 4, Banks::InLine, false);
    space.counterweights =
        vec![pattern(&[1, 1, 0, 0, 0, 0]), pattern(&[0, 0, 0, 0, 1, 1]), pattern(&[1, 0, 0, 0, 0, 1])];
    counted_right(space.clone());
    space.counterweights.remove(1);
    counted_right(space);
}

#[test]
fn two_strokes_have_one_firing_a_crank() {
    let mut space = space(3, 6, Banks::InLine, true);
    space.parts.strokes = Strokes::Two;
    counted_right(space);
}

#[test]
fn shafts_are_seen_from_every_side() {
    let design = |y: f64, z: f64| ShaftDesign {
        order: 2,
        sense: Sense::Backward,
        x: 0.05,
        y,
        removes: Removes::Both { z: [z, z + 0.2] },
    };
    let mut space = space(3, 4, Banks::InLine, false);
    space.shafts = [(0.1, 0.0), (-0.1, 0.0), (0.1, -0.2), (-0.1, -0.2), (0.1, -0.1), (0.0, -0.1)]
        .map(|(y, z)| ShaftSet { name: "one".into(), shafts: vec![design(y, z)] })
        .to_vec();
    counted_right(space.clone());
    space.shafts.truncate(3);
    counted_right(space.clone());
    space.banks = two(&[180.0, 90.0], &[0.0, 180.0], &[0.03]);
    space.cylinders = 6;
    counted_right(space);
}
