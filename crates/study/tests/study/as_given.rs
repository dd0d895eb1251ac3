//! Engines whose cylinders stay where they are: loads and firing of their layouts as engines, duplicates by brute force.
use crate::support::{bare, explorer, full, parts};
use lanchester_mechanism::{
    BeamModel, InternalRequest, LoadRequest, firing_chart, internal_moments, total_loads,
};
use lanchester_model::{Engine, RodJoint, Strokes};
use lanchester_study::explore::*;
use lanchester_testkit::{Within, assert_close};
use num_complex::Complex64;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// Engines of the gallery that are not one bank, or two alike, on one crankshaft.
const ENGINES: [&str; 6] =
    ["vr6-15", "w12-broad-arrow", "radial-14", "radial-5", "square-4", "opposed-piston-3"];

fn gallery(name: &str) -> Engine {
    let template = lanchester_file::template(name).expect("it is in the gallery");
    lanchester_file::read(template.text).engine().expect("the gallery has no mistakes").clone()
}

/// Layouts of an engine as it is, judged at its highest speed.
fn space(engine: &Engine, throw_angles: Vec<f64>, firing: bool) -> Space {
    let arrangement = Arrangement::of(engine, 0.05).expect("throws to permute");
    Space {
        parts: Parts { strokes: engine.strokes, speed: engine.speed.highest, ..parts() },
        cylinders: engine.cylinders.len(),
        banks: Banks::AsGiven(Box::new(arrangement)),
        throw_angles,
        spacings: vec![0.1],
        rod_ratios: vec![0.3],
        counterweights: vec![bare()],
        shafts: vec![ShaftSet::default()],
        firing,
    }
}

/// What all masses of an engine could exert together [N], lever 1 m.
fn scale(engine: &Engine) -> f64 {
    let cylinders = engine
        .cylinders
        .iter()
        .map(|c| (c.reciprocating_mass() + c.rod.big_end_mass) * engine.throws[c.throw].radius);
    let throws = engine.throws.iter().map(|throw| throw.unbalance.abs());
    let weights = engine.counterweights.iter().map(|weight| weight.unbalance);
    let shafts = engine.shafts.iter().flat_map(|shaft| &shaft.weights).map(|weight| weight.unbalance);
    let unbalance: f64 = cylinders.chain(throws).chain(weights).chain(shafts).sum();
    unbalance * engine.speed.highest.powi(2)
}

#[track_caller]
fn close(what: &str, got: Complex64, wanted: Complex64, scale: f64) {
    assert_close(what, got, wanted, Within::of(scale, 1e-12, "rounding of all that is summed"));
}

prop_compose! {
    /// An engine of the gallery, some angles, weights on some webs and a balance shaft or none.
    fn any_layouts()(
        engine in prop::sample::select(ENGINES.to_vec()), angles in prop::collection::vec(0.01..TAU, 1..4),
        rotating in 0.0..2.0f64, reciprocating in 0.0..1.0f64, webs in prop::option::of(prop::collection::vec(any::<bool>(), 12)),
        order in prop::option::of(1..=2u32), forward in any::<bool>(), x in -0.2..0.2f64, y in -0.2..0.2f64, z in -0.3..0.0f64,
    ) -> Space {
        let engine = gallery(engine);
        let webs = webs.map(|webs| webs[..2 * engine.throws.len()].to_vec());
        let sense = if forward { Sense::Forward } else { Sense::Backward };
        let shaft = |order| ShaftDesign { order, sense, x, y, removes: Removes::Both { z: [z, z + 0.2] } };
        Space {
            counterweights: vec![CounterweightPattern { name: "any".into(), rotating, reciprocating, webs }],
            shafts: vec![ShaftSet { name: "any".into(), shafts: order.map(shaft).into_iter().collect() }],
            ..space(&engine, angles, true)
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    #[test]
    fn prop_loads_and_firing_are_those_of_the_engine(space in any_layouts(), place in 0.0..1.0f64) {
        let own = space.parts;
        let explorer = explorer(space, &[Objective::Shafts], &[]);
        let case = ((explorer.size() as f64 * place) as u128).min(explorer.size() - 1);
        let layout = explorer.layout(case).expect("a case");
        prop_assert_eq!(explorer.case_of(&layout), Some(case));
        let engine = layout.engine(&own).expect("an engine");
        let request = LoadRequest { max_order: 2, samples: 1, ..LoadRequest::default() };
        let all = total_loads(&engine, &request).expect("loads");
        let got = explorer.orders(case).expect("loads");
        let force = scale(&engine);
        for n in 1..=2u32 {
            let order = &all.orders[n as usize];
            let k = n as usize - 1;
            close("force forward", got.force_of(n, Sense::Forward), order.force_forward, force);
            close("force backward", got.force_of(n, Sense::Backward), order.force_backward, force);
            close("couple forward", got.couple_of(n, Sense::Forward), order.couple_forward, force);
            close("couple backward", got.couple_of(n, Sense::Backward), order.couple_backward, force);
            close("roll moment", got.roll_moment[k], order.roll_moment, force);
            close("torque", got.shaft_torque[k], order.shaft_torque, force);
        }
        let chart = firing_chart(&engine).expect("it fires");
        let unevenness = layout.unevenness(own.strokes).expect("it fires");
        let far = (unevenness - chart.unevenness * chart.even_interval).abs();
        prop_assert!(far < 1e-8, "uneven by {} and {}", unevenness, chart.unevenness * chart.even_interval);
        // Every chamber fires where the layout says: at its dead centre.
        let angles = layout.firing_angles.as_ref().expect("it fires");
        for firing in &chart.firings {
            let off = Complex64::cis(0.5 * firing.theta) - Complex64::cis(0.5 * angles[firing.cylinder - 1]);
            let half = Complex64::cis(0.5 * firing.theta) + Complex64::cis(0.5 * angles[firing.cylinder - 1]);
            let two_stroke = own.strokes == Strokes::Two;
            prop_assert!(off.norm() < 1e-8 || (two_stroke && half.norm() < 1e-8), "{:?} {:?}", firing, angles);
        }
    }

    #[test]
    fn prop_bending_moment_and_main_loads_are_those_of_the_crankshafts(space in any_layouts(), place in 0.0..1.0f64) {
        let own = space.parts;
        let objectives = [Objective::BendingMoment, Objective::MainLoad, Objective::CounterweightUnbalance];
        let explorer = explorer(Space { firing: false, ..space }, &objectives, &[]);
        let case = ((explorer.size() as f64 * place) as u128).min(explorer.size() - 1);
        let (mut values, mut judged) = (vec![0.0; 3], false);
        let run = Run { from: case, to: case + 1 };
        explorer.look(run, &mut |_, own| { values.copy_from_slice(own); judged = true; }).expect("it runs");
        if !judged {
            return Ok(());
        }
        let engine = explorer.layout(case).expect("a case").engine(&own).expect("an engine");
        let inside = internal_moments(&engine, &InternalRequest { samples: 8, ..InternalRequest::default() }).expect("a beam");
        let most = |of: &dyn Fn(&lanchester_mechanism::CrankshaftMoments) -> f64| {
            inside.crankshafts.iter().map(of).fold(0.0, f64::max)
        };
        let wanted = [
            most(&|crank| crank.of(BeamModel::FreeBeam).peak_moment.value),
            most(&|crank| crank.of(BeamModel::ThrowByThrow).peak_main.value),
            engine.counterweights.iter().map(|weight| weight.unbalance).sum::<f64>(),
        ];
        let scales = [scale(&engine), scale(&engine), 1.0];
        for k in 0..3 {
            prop_assert!((values[k] - wanted[k]).abs() <= 1e-12 * scales[k], "{:?} {:?}", values, wanted);
        }
    }
}

/// Sizes of all first- and second-order loads of an engine.
fn sizes(orders: &LayoutOrders) -> Vec<f64> {
    let force = orders.force.iter().flatten().map(|f| f.norm());
    let couple = orders.couple.iter().flatten().map(|m| m.norm());
    let about_z = orders.roll_moment.iter().chain(&orders.shaft_torque).map(|t| t.norm());
    force.chain(couple).chain(about_z).collect()
}

#[test]
fn the_engine_of_the_file_is_one_of_its_layouts() {
    for name in ENGINES {
        let engine = gallery(name).without_counterweights().without_shafts();
        let own = Arrangement::of(&engine, 0.05).expect("throws").throw_angles;
        let mut angles = own.clone();
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
        let explorer = explorer(space(&engine, angles, false), &[Objective::Shafts], &[]);
        let mut layout = explorer.layout(0).expect("a case");
        layout.throw_angles = own;
        let case = explorer.case_of(&layout).expect("its angles are in the list");
        let request = LoadRequest { max_order: 2, samples: 1, ..LoadRequest::default() };
        let all = total_loads(&engine, &request).expect("loads");
        let got = sizes(&explorer.orders(case).expect("loads"));
        let wanted = [&all.orders[1], &all.orders[2]].map(|order| {
            let force = [order.force_forward, order.force_backward].map(|f| f.norm());
            let couple = [order.couple_forward, order.couple_backward].map(|m| m.norm());
            (force, couple, order.roll_moment.norm(), order.shaft_torque.norm())
        });
        let [first, second] = wanted;
        let wanted: Vec<f64> = first
            .0
            .into_iter()
            .chain(second.0)
            .chain(first.1)
            .chain(second.1)
            .chain([first.2, second.2, first.3, second.3])
            .collect();
        for (got, wanted) in got.iter().zip(&wanted) {
            assert!((got - wanted).abs() < 1e-12 * scale(&engine), "{name}: {got} {wanted}");
        }
    }
}

/// Where each cylinder stands, where its pin, and when it fires, from the cylinder that stands where cylinder 1 stood.
type Fingerprint = Vec<[i64; 5]>;

fn wrapped(angle: f64, revolutions: i64) -> i64 {
    (angle / TAU * 1e6).round().rem_euclid(1e6 * revolutions as f64) as i64
}

/// The layout from every side, by brute force: ends, mirror, and every turn about the crank that leaves the set of cylinders.
fn orbit(engine: &Engine, cycle: i64) -> BTreeSet<Fingerprint> {
    let micro = |length: f64| (length * 1e6).round() as i64;
    let place = |z: f64, axis: f64, offset: f64| [micro(z), wrapped(axis, 1), micro(offset)];
    let cylinders = &engine.cylinders;
    let mut own: Vec<[i64; 3]> = cylinders.iter().map(|c| place(c.z, c.angle, c.net_offset())).collect();
    let first = own[0];
    own.sort_unstable();
    let mut orbit = BTreeSet::new();
    for (ends, mirror) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        for from in cylinders {
            let turn = from.angle - mirror * cylinders[0].angle;
            let seen: Vec<([i64; 3], f64, f64)> = cylinders
                .iter()
                .map(|c| {
                    let pin = mirror * engine.throws[c.throw].angle + turn;
                    let firing = mirror * c.firing_angle.unwrap_or(0.0);
                    (place(ends * c.z, mirror * c.angle + turn, mirror * c.net_offset()), pin, firing)
                })
                .collect();
            let mut places: Vec<[i64; 3]> = seen.iter().map(|c| c.0).collect();
            places.sort_unstable();
            if places != own {
                continue;
            }
            let origin = seen.iter().find(|c| c.0 == first).expect("the same set");
            let mut fingerprint: Fingerprint = seen
                .iter()
                .map(|(place, pin, firing)| {
                    let [z, axis, offset] = *place;
                    [z, axis, offset, wrapped(pin - origin.1, 1), wrapped(firing - origin.2, cycle)]
                })
                .collect();
            fingerprint.sort_unstable();
            orbit.insert(fingerprint);
        }
    }
    orbit
}

/// Cases that are judged, against kinds of layout by brute force; layouts of one kind must have the same loads.
#[track_caller]
fn counted_right(name: &str, space: Space) {
    let own = space.parts;
    let explorer = explorer(space, &[Objective::Shafts], &[]);
    let cycle = i64::from(own.strokes.revolutions());
    let (mut seen, mut kinds): (BTreeMap<Fingerprint, u128>, u128) = (BTreeMap::new(), 0);
    for case in 0..explorer.size() {
        let engine = explorer.layout(case).expect("a case").engine(&own).expect("an engine");
        let orbit = orbit(&engine, cycle);
        match orbit.iter().find_map(|view| seen.get(view)) {
            None => kinds += 1,
            Some(&other) => {
                let loads = |case| sizes(&explorer.orders(case).expect("loads"));
                for (a, b) in loads(case).iter().zip(loads(other)) {
                    assert!(
                        (a - b).abs() < 1e-11 * scale(&engine),
                        "{name}: cases {case} and {other}: {a} and {b}"
                    );
                }
            }
        }
        for view in orbit {
            seen.entry(view).or_insert(case);
        }
    }
    let found = explorer.explore().expect("it runs");
    assert_eq!(found.counts.judged, kinds, "{name}");
    assert_eq!(found.counts.judged + found.counts.duplicates, explorer.size(), "{name}");
}

/// The engine with every rod on its crankpin, as its first one is: what turns about the crank may stand anywhere.
fn on_crankpins(engine: &Engine) -> Engine {
    let alike = engine.with(|parts| {
        let (mut rod, mass) = (parts.cylinders[0].rod.clone(), parts.cylinders[0].piston_mass);
        rod.joint = RodJoint::Crankpin;
        for cylinder in &mut parts.cylinders {
            (cylinder.rod, cylinder.piston_mass) = (rod.clone(), mass);
        }
    });
    alike.expect("an engine")
}

#[test]
fn duplicates_are_counted_right() {
    let vr6 = gallery("vr6-15");
    let own = Arrangement::of(&vr6, 0.05).expect("throws").throw_angles;
    counted_right("vr6", space(&vr6, own, false));
    counted_right("vr6", space(&vr6, even_angles(3), false));
    let w12 = gallery("w12-broad-arrow");
    counted_right("w12", space(&w12, even_angles(6), false));
    let radial = on_crankpins(&gallery("radial-14"));
    counted_right("radial 14", space(&radial, even_angles(14), false));
    let radial = on_crankpins(&gallery("radial-7"));
    counted_right("radial 7", space(&radial, vec![0.0], true));
}

/// What an engine as it is can be judged by, in steps of rounding.
fn judged_by(explorer: &Explorer, case: u128) -> Vec<i64> {
    let layout = explorer.layout(case).expect("a case");
    let own = explorer.request().space.parts;
    let engine = layout.engine(&own).expect("an engine");
    let step = 1e-9 * scale(&engine);
    let loads = sizes(&explorer.orders(case).expect("loads"));
    let loads = loads.iter().map(|load| (load / step).round() as i64);
    let chart = firing_chart(&engine).expect("it fires");
    // Whole cycles: two-stroke engines have no half orders.
    let step = if own.strokes == Strokes::Two { 1.0 } else { 0.5 };
    let harmonics = (1..=6).map(|h| {
        let sum: Complex64 =
            chart.firings.iter().map(|f| Complex64::cis(step * f64::from(h) * f.theta)).sum();
        (sum.norm() * 1e6).round() as i64
    });
    let uneven = (chart.unevenness * chart.even_interval * 1e6).round() as i64;
    loads.chain(harmonics).chain([uneven]).collect()
}

/// No view of a layout is lost: what all cases are judged by is what those that are no duplicates are judged by.
#[test]
fn duplicates_have_what_they_are_duplicates_of() {
    let cases = [("square-4", 4), ("opposed-piston-3", 6), ("radial-5", 1), ("vr6-15", 1)];
    for (name, steps) in cases {
        let engine = gallery(name);
        let explorer = explorer(space(&engine, even_angles(steps), true), &[Objective::Shafts], &[]);
        let mut judged = BTreeSet::new();
        let all = Run { from: 0, to: explorer.size() };
        explorer
            .look(all, &mut |case, _| {
                judged.insert(judged_by(&explorer, case));
            })
            .expect("it runs");
        for case in 0..explorer.size() {
            let own = judged_by(&explorer, case);
            let near = |other: &Vec<i64>| own.iter().zip(other).all(|(a, b)| a.abs_diff(*b) <= 2);
            assert!(judged.contains(&own) || judged.iter().any(near), "{name}: case {case}");
        }
    }
}

#[test]
fn a_search_goes_on_from_its_text() {
    for name in ENGINES {
        let request = ExploreRequest::new(
            Space { counterweights: vec![bare(), full()], ..space(&gallery(name), even_angles(2), false) },
            vec![Objective::Force { order: 1 }, Objective::Couple { order: 2 }],
            vec![],
        );
        let text = serde_json::to_string(&request).expect("text");
        assert_eq!(serde_json::from_str::<ExploreRequest>(&text).expect("it reads its own text"), request);
    }
}

#[test]
fn constraints_on_pins_that_stay_are_refused() {
    let space = space(&gallery("vr6-15"), even_angles(3), false);
    let request =
        ExploreRequest::new(space, vec![Objective::Length], vec![Constraint::BearingRoom { least: 0.01 }]);
    let error = Explorer::new(request).expect_err("its planes are its own");
    assert!(matches!(error, ExploreError::FixedPins { .. }), "{error}");
}

#[test]
fn throws_that_cannot_be_permuted_are_named() {
    let half = gallery("square-4").with(|parts| {
        parts.crankshafts[1].ratio = lanchester_model::Ratio::new(-1, 2).expect("a ratio");
    });
    let error = Arrangement::of(&half.expect("an engine"), 0.05).expect_err("another speed");
    assert_eq!(
        error.to_string(),
        "crankshaft 2 must turn at the speed of crankshaft 1, with it or against it (ratio 1 or -1), got ratio -1/2"
    );
    let idle = gallery("vr6-15").with(|parts| parts.throws.push(parts.throws[0].clone()));
    let error = Arrangement::of(&idle.expect("an engine"), 0.05).expect_err("nothing hangs on it");
    assert_eq!(error, ArrangementError::IdleThrow { throw: 7 });
}
