use super::*;
use crate::firing;
use lanchester_model::{RodJoint, Strokes};
use proptest::option::of;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn engine(kind: LayoutKind, cylinders: usize, order: &[usize]) -> LayoutSpec {
    let mut spec = LayoutSpec::new(kind, cylinders, Strokes::Four);
    spec.order = (!order.is_empty()).then(|| order.to_vec());
    if kind != LayoutKind::Radial {
        spec.spacing = Some(0.1);
    }
    if kind == LayoutKind::Boxer {
        spec.bank_stagger = Some(0.03);
    }
    spec
}

fn v(cylinders: usize, bank_degrees: f64, order: &[usize]) -> LayoutSpec {
    LayoutSpec { bank_angle: Some(bank_degrees.to_radians()), ..engine(LayoutKind::V, cylinders, order) }
}

fn arranged(spec: &LayoutSpec) -> Arrangement {
    arrange(spec).unwrap_or_else(|problems| panic!("{problems:?}"))
}

fn throws(spec: &LayoutSpec) -> Vec<f64> {
    arranged(spec).throws.iter().map(|throw| degrees_of(throw.angle)).collect()
}

/// Degrees to a thousandth.
fn degrees_of(angle: f64) -> f64 {
    (angle.to_degrees() * 1e3).round() / 1e3 + 0.0
}

/// Crank angle [deg] from one firing to the next, in the order of the spec.
fn intervals(spec: &LayoutSpec) -> Vec<f64> {
    let arrangement = arranged(spec);
    let tops: Vec<f64> = arrangement
        .cylinders
        .iter()
        .map(|cylinder| {
            let pin = arrangement.throws[cylinder.throw].angle;
            firing::nominal_top(1.0, pin, cylinder.angle, cylinder.offset.unwrap_or(0.0), spec.reach)
        })
        .collect();
    let order = spec.order.as_ref().unwrap();
    let fired = firing::assign(spec.strokes, &tops, order).unwrap();
    let cycle = 360.0 * f64::from(spec.strokes.revolutions());
    (0..order.len())
        .map(|k| {
            let next = fired[order[(k + 1) % order.len()] - 1];
            let interval = (next - fired[order[k] - 1]).to_degrees().rem_euclid(cycle);
            (interval * 1e3).round() / 1e3
        })
        .collect()
}

fn messages(spec: &LayoutSpec) -> Vec<String> {
    let problems = arrange(spec).expect_err("a layout with a problem");
    problems.iter().map(|problem| format!("{}: {}", problem.key, problem.message)).collect()
}

#[test]
fn lit_in_line_cranks() {
    let in_line = |order: &[usize]| throws(&engine(LayoutKind::InLine, order.len(), order));
    assert_eq!(in_line(&[1, 2]), [0.0, 0.0]);
    assert_eq!(in_line(&[1, 2, 3]), [0.0, 120.0, 240.0]);
    assert_eq!(in_line(&[1, 3, 2]), [0.0, 240.0, 120.0]);
    assert_eq!(in_line(&[1, 3, 4, 2]), [0.0, 180.0, 180.0, 0.0]);
    assert_eq!(in_line(&[1, 2, 4, 5, 3]), [0.0, 216.0, 144.0, 72.0, 288.0]);
    assert_eq!(in_line(&[1, 5, 3, 6, 2, 4]), [0.0, 240.0, 120.0, 120.0, 240.0, 0.0]);
    // Straight eight: two fours at right angles, the inner one between the halves of the outer one.
    assert_eq!(in_line(&[1, 6, 2, 5, 8, 3, 7, 4]), [0.0, 180.0, 270.0, 90.0, 90.0, 270.0, 180.0, 0.0]);
}

#[test]
fn lit_two_stroke_three() {
    let spec = LayoutSpec { strokes: Strokes::Two, ..engine(LayoutKind::InLine, 3, &[1, 2, 3]) };
    assert_eq!(throws(&spec), [0.0, 240.0, 120.0]);
    assert_eq!(intervals(&spec), [120.0; 3]);
}

#[test]
fn a_boxer_without_stagger_is_refused() {
    let boxer = LayoutSpec { bank_stagger: None, ..engine(LayoutKind::Boxer, 2, &[1, 2]) };
    let problems = arrange(&boxer).expect_err("two pins in one plane");
    assert_eq!(problems.iter().map(|problem| problem.key).collect::<Vec<_>>(), ["layout.bank_stagger"]);
}

#[test]
fn lit_boxer_cranks() {
    assert_eq!(throws(&engine(LayoutKind::Boxer, 2, &[1, 2])), [0.0, 180.0]);
    let subaru =
        LayoutSpec { numbering: Some(Numbering::Alternating), ..engine(LayoutKind::Boxer, 4, &[1, 3, 2, 4]) };
    assert_eq!(throws(&subaru), [0.0, 180.0, 180.0, 0.0]);
    let porsche = engine(LayoutKind::Boxer, 6, &[1, 6, 2, 4, 3, 5]);
    assert_eq!(throws(&porsche), [0.0, 180.0, 120.0, 300.0, 240.0, 60.0]);
    assert_eq!(intervals(&porsche), [120.0; 6]);
}

#[test]
fn lit_v8_crossplane_and_flat_plane() {
    // Ford 302: 1 to 4 on the left seen from the front, 5 to 8 on the right.
    let crossplane = v(8, 90.0, &[1, 5, 4, 2, 6, 3, 7, 8]);
    assert_eq!(throws(&crossplane), [0.0, 90.0, 270.0, 180.0]);
    assert_eq!(intervals(&crossplane), [90.0; 8]);
    let flat_plane = v(8, 90.0, &[1, 5, 3, 7, 4, 8, 2, 6]);
    assert_eq!(throws(&flat_plane), [0.0, 180.0, 180.0, 0.0]);
    assert_eq!(intervals(&flat_plane), [90.0; 8]);
}

#[test]
fn lit_v6_split_pins() {
    let split = |bank: f64, angle: f64, order: &[usize]| LayoutSpec {
        pins: Some(Pins::Split),
        split_angle: Some(angle.to_radians()),
        bank_stagger: Some(0.02),
        ..v(6, bank, order)
    };
    let wide = split(90.0, -30.0, &[1, 4, 3, 6, 2, 5]);
    assert_eq!(throws(&wide), [0.0, 330.0, 240.0, 210.0, 120.0, 90.0]);
    assert_eq!(intervals(&wide), [120.0; 6]);
    let narrow = split(60.0, -60.0, &[1, 4, 2, 5, 3, 6]);
    assert_eq!(throws(&narrow), [0.0, 300.0, 120.0, 60.0, 240.0, 180.0]);
    assert_eq!(intervals(&narrow), [120.0; 6]);
    // Sprinter V6 3.0 l diesel, service manual: 72-degree V, order 1-4-2-5-3-6, "throw angles alternate between 48 and
    // 192 degrees" (counted against the rotation).
    let diesel = split(72.0, -48.0, &[1, 4, 2, 5, 3, 6]);
    assert_eq!(throws(&diesel), [0.0, 312.0, 120.0, 72.0, 240.0, 192.0]);
    assert_eq!(intervals(&diesel), [120.0; 6]);
    // The same pins without the split fire at 90 and 150 degrees in turn.
    let odd = LayoutSpec {
        crank_angles: Some([0.0_f64, 240.0, 120.0].map(f64::to_radians).to_vec()),
        ..v(6, 90.0, &[1, 4, 3, 6, 2, 5])
    };
    assert_eq!(intervals(&odd), [90.0, 150.0, 90.0, 150.0, 90.0, 150.0]);
}

#[test]
fn lit_buick_v6_numbers_the_other_bank_first() {
    // Buick 3.8 l V6, service manual: 1-3-5 left, 2-4-6 right, order 1-6-5-4-3-2, pins offset by 30 degrees. Seen from
    // the front the left bank is on the right, at +45 degrees: the banks are those of a W with two banks.
    let bank = |angle: f64| Bank { angle: angle.to_radians(), offset: None };
    let spec = LayoutSpec {
        banks: Some(vec![bank(45.0), bank(-45.0)]),
        pins: Some(Pins::Separate),
        bank_stagger: Some(0.02),
        numbering: Some(Numbering::Alternating),
        ..engine(LayoutKind::W, 6, &[1, 6, 5, 4, 3, 2])
    };
    assert_eq!(throws(&spec), [0.0, 30.0, 240.0, 270.0, 120.0, 150.0]);
    assert_eq!(intervals(&spec), [120.0; 6]);
}

#[test]
fn lit_v12() {
    let spec = v(12, 60.0, &[1, 7, 5, 11, 3, 9, 6, 12, 2, 8, 4, 10]);
    assert_eq!(throws(&spec), [0.0, 240.0, 120.0, 120.0, 240.0, 0.0]);
    assert_eq!(intervals(&spec), [60.0; 12]);
}

#[test]
fn lit_v_twins_fire_unevenly() {
    assert_eq!(intervals(&v(2, 90.0, &[1, 2])), [450.0, 270.0]);
    assert_eq!(intervals(&v(2, 45.0, &[1, 2])), [405.0, 315.0]);
}

#[test]
fn lit_radial_nine() {
    let spec = LayoutSpec {
        knuckle_radius: Some(0.06),
        ..engine(LayoutKind::Radial, 9, &[1, 3, 5, 7, 9, 2, 4, 6, 8])
    };
    assert_eq!(intervals(&spec), [80.0; 9]);
    let arrangement = arranged(&spec);
    assert_eq!(arrangement.cylinders[0].joint, RodJoint::Crankpin);
    for (index, cylinder) in arrangement.cylinders.iter().enumerate().skip(1) {
        let angle = (40.0 * index as f64).to_radians();
        assert!((cylinder.angle - angle).abs() < 1e-12);
        let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = cylinder.joint else {
            panic!("cylinder {} must be articulated", index + 1)
        };
        assert_eq!((master, knuckle_radius), (0, 0.06));
        assert!((knuckle_angle - angle).abs() < 1e-12);
    }
}

/// Two rows of `row` cylinders, half a pitch apart, numbered row by row, firing by the rule of the aircraft mechanic's
/// handbooks: cylinders numbered round the circle (odd ones row 1, even ones row 2), add one number or take off the
/// other.
fn two_row_radial(row: usize, add: usize, take_off: usize) -> LayoutSpec {
    let mut number: usize = 1;
    let mut order = Vec::new();
    for _ in 0..2 * row {
        order.push(if number % 2 == 1 { number.div_ceil(2) } else { row + number / 2 });
        number = if number + add <= 2 * row { number + add } else { number - take_off };
    }
    LayoutSpec {
        rows: Some(2),
        row_spacing: Some(0.15),
        row_angles: Some(vec![0.0, TAU / 2.0 / row as f64]),
        knuckle_radius: Some(0.06),
        master: Some(2),
        ..engine(LayoutKind::Radial, row, &order)
    }
}

#[test]
fn lit_two_row_radials_fire_by_the_mechanics_rule() {
    // "Firing order", Aviation Maintenance Technician Handbook: 14 cylinders +9 or -5, 18 cylinders +11 or -7.
    for (row, add, take_off) in [(7, 9, 5), (9, 11, 7)] {
        let spec = two_row_radial(row, add, take_off);
        assert_eq!(throws(&spec), [0.0, 180.0]);
        let even = 360.0 / row as f64;
        assert!(intervals(&spec).iter().all(|interval| (interval - even).abs() < 1e-3));
    }
    assert_eq!(two_row_radial(7, 9, 5).order.unwrap(), [1, 12, 3, 14, 5, 9, 7, 11, 2, 13, 4, 8, 6, 10]);
}

#[test]
fn masters_of_a_two_row_radial() {
    let masters: Vec<usize> = arranged(&two_row_radial(7, 9, 5))
        .cylinders
        .iter()
        .filter_map(|c| if let RodJoint::Articulated { master, .. } = c.joint { Some(master) } else { None })
        .collect();
    assert_eq!(masters, [[1; 6], [8; 6]].concat());
}

#[test]
fn lit_vr6_pins_make_up_for_bank_angle_and_offset() {
    let spec = LayoutSpec {
        bank_angle: Some(15.0_f64.to_radians()),
        bank_offset: Some(0.0125),
        reach: Some(0.045_15 + 0.164),
        ..engine(LayoutKind::Vr, 6, &[1, 5, 3, 6, 2, 4])
    };
    let angles = throws(&spec);
    // 15 degrees of bank and twice asin(12.5 / 209.15) of offset: 21.85 degrees, "22 degrees" in the books.
    assert_eq!(angles, [0.0, 261.853, 120.0, 141.853, 240.0, 21.853]);
    assert_eq!(intervals(&spec), [120.0; 6]);
    let arrangement = arranged(&spec);
    assert_eq!(arrangement.cylinders[0].offset, Some(-0.0125));
    assert_eq!(arrangement.cylinders[1].offset, Some(0.0125));
    assert!(arrangement.cylinders[0].angle < 0.0);
}

#[test]
fn tool_paper_phase_places_the_throws() {
    let spec = LayoutSpec {
        crank_phase: Some(180.0_f64.to_radians()),
        ..engine(LayoutKind::InLine, 4, &[1, 3, 4, 2])
    };
    assert_eq!(throws(&spec), [0.0, 180.0, 180.0, 0.0]);
    let spec = LayoutSpec {
        crank_phase: Some(90.0_f64.to_radians()),
        ..engine(LayoutKind::InLine, 4, &[1, 2, 4, 3])
    };
    assert_eq!(throws(&spec), [0.0, 270.0, 90.0, 180.0]);
}

#[test]
fn planes_numbers_and_stagger() {
    let spec = LayoutSpec { bank_stagger: Some(0.02), ..v(4, 90.0, &[]) };
    let spec = LayoutSpec { crank_angles: Some(vec![0.0, std::f64::consts::PI]), ..spec };
    let arrangement = arranged(&spec);
    let z: Vec<f64> = arrangement.throws.iter().map(|throw| throw.z).collect();
    assert_eq!(z, [-0.05, 0.05]);
    let places: Vec<(usize, f64)> =
        arrangement.cylinders.iter().map(|c| (c.throw, (c.z * 1e6).round() / 1e6)).collect();
    assert_eq!(places, [(0, -0.06), (1, 0.04), (0, -0.04), (1, 0.06)]);
    let alternating = arranged(&LayoutSpec { numbering: Some(Numbering::Alternating), ..spec });
    let throws: Vec<usize> = alternating.cylinders.iter().map(|c| c.throw).collect();
    assert_eq!(throws, [0, 0, 1, 1]);
    // Separate pins stand where their rods run.
    let boxer = LayoutSpec { bank_stagger: Some(0.03), spacing: None, ..engine(LayoutKind::Boxer, 2, &[]) };
    let z: Vec<f64> = arranged(&boxer).throws.iter().map(|throw| throw.z).collect();
    assert_eq!(z, [-0.015, 0.015]);
}

#[test]
fn joints_of_shared_pins() {
    let fork = LayoutSpec { rods: Some(Rods::ForkAndBlade), spacing: None, ..v(2, 45.0, &[]) };
    let joints: Vec<RodJoint> = arranged(&fork).cylinders.iter().map(|c| c.joint).collect();
    assert_eq!(joints, [RodJoint::Fork, RodJoint::Blade]);
    let articulated = LayoutSpec {
        rods: Some(Rods::Articulated),
        rod_knuckle_radius: Some(0.05),
        crank_angles: Some(vec![0.0, 0.0]),
        ..v(4, 60.0, &[])
    };
    let cylinders = arranged(&articulated).cylinders;
    let RodJoint::Articulated { master, knuckle_angle, .. } = cylinders[3].joint else {
        panic!("articulated")
    };
    assert_eq!(master, 1);
    assert!((knuckle_angle - 60.0_f64.to_radians()).abs() < 1e-15);
}

#[test]
fn w_engine_with_a_pin_for_each_group() {
    let bank = |angle: f64| Bank { angle: angle.to_radians(), offset: None };
    // Napier Lion: three banks of four, 60 degrees apart, on a crank of an in-line four.
    let spec = LayoutSpec {
        banks: Some(vec![bank(-60.0), bank(0.0), bank(60.0)]),
        ..engine(LayoutKind::W, 12, &[1, 5, 9, 3, 7, 11, 4, 8, 12, 2, 6, 10])
    };
    assert_eq!(throws(&spec), [0.0, 180.0, 180.0, 0.0]);
    assert_eq!(intervals(&spec), [60.0; 12]);
}

#[test]
fn every_problem_at_once() {
    let spec = LayoutSpec {
        split_angle: Some(0.5),
        master: Some(1),
        bank_offset: Some(0.01),
        spacing: Some(-0.1),
        ..v(6, 60.0, &[])
    };
    assert_eq!(
        messages(&spec),
        [
            "layout.bank_offset: bank_offset has no effect with type = \"v\"",
            "layout.master: master has no effect with type = \"v\"",
            "layout.split_angle: split_angle has no effect with pins = \"shared\"",
            "layout.spacing: spacing must be more than 0",
        ]
    );
}

#[test]
fn problems_name_what_was_needed() {
    let one = |spec: LayoutSpec| {
        let found = messages(&spec);
        assert_eq!(found.len(), 1, "{found:?}");
        found[0].clone()
    };
    let four = || engine(LayoutKind::InLine, 4, &[]);
    assert_eq!(one(four()), "layout.crank_angles: the angles of the throws are missing");
    assert_eq!(
        one(LayoutSpec { crank_angles: Some(vec![0.0; 3]), ..four() }),
        "layout.crank_angles: needs 4 crank angles, one a cylinder, got 3"
    );
    assert_eq!(
        one(LayoutSpec { crank_angles: Some(vec![1.0, 0.0, 0.0, 0.0]), ..four() }),
        "layout.crank_angles: the first throw must stand at 0 deg, got 57.296 deg"
    );
    assert_eq!(
        one(LayoutSpec { spacing: None, ..engine(LayoutKind::InLine, 4, &[1, 3, 4, 2]) }),
        "layout.spacing: spacing is missing: the distance from one cylinder to the next"
    );
    assert_eq!(
        one(LayoutSpec { positions: Some(vec![0.0, 1.0, 0.5, 2.0]), spacing: None, ..four() }),
        "layout.positions: positions must rise from the free end to the flywheel"
    );
    assert_eq!(
        one(engine(LayoutKind::InLine, 4, &[1, 3, 3, 5])),
        "firing.order: the firing order needs each cylinder once: there is no cylinder 5, cylinder 2 is missing, \
         cylinder 3 fires 2 times, cylinder 4 is missing"
    );
    assert_eq!(
        one(engine(LayoutKind::Boxer, 3, &[])),
        "layout.cylinders: 2 banks need a multiple of 2 cylinders, got 3"
    );
    assert_eq!(
        one(v(6, 60.0, &[1, 4, 2, 5, 3, 6])),
        "firing.order: cylinders 1 and 4 share a throw, but firing every 120 deg wants it at angles 60 deg apart"
    );
    assert_eq!(
        one(v(2, 180.0, &[])),
        "layout.bank_angle: a V needs a bank angle above 0 and up to 170 deg, got 180 deg"
    );
    assert_eq!(
        one(LayoutSpec { knuckle_radius: Some(0.05), master: Some(8), ..engine(LayoutKind::Radial, 7, &[]) }),
        "layout.master: master is a number within a row, 1 to 7, got 8"
    );
    assert_eq!(
        one(engine(LayoutKind::InLine, 1_000_000_000, &[])),
        "layout.cylinders: needs 1 to 240 cylinders in all, got 1000000000"
    );
}

fn any_kind() -> impl Strategy<Value = LayoutKind> {
    use LayoutKind::{Boxer, Flat, InLine, Radial, V, Vr, W};
    prop_oneof![Just(InLine), Just(V), Just(Boxer), Just(Flat), Just(Vr), Just(W), Just(Radial)]
}

/// Any spec, most of them with problems: keys that do not belong, lists of wrong length, negative distances.
fn any_spec() -> impl Strategy<Value = LayoutSpec> {
    let length = || of(-0.05..0.3_f64);
    let angle = || of(-7.0..7.0_f64);
    let angles = || of(proptest::collection::vec(-7.0..7.0_f64, 0..7));
    let pins = of(prop_oneof![Just(Pins::Shared), Just(Pins::Split), Just(Pins::Separate)]);
    let rods = of(prop_oneof![Just(Rods::SideBySide), Just(Rods::ForkAndBlade), Just(Rods::Articulated)]);
    let bank = (angle(), length()).prop_map(|(angle, offset)| Bank { angle: angle.unwrap_or(0.0), offset });
    let order = of((1..9_usize).prop_flat_map(|count| Just((1..=count).collect::<Vec<_>>()).prop_shuffle()));
    let first = (
        any_kind(),
        0..9_usize,
        order,
        length(),
        of(proptest::collection::vec(-0.3..0.3_f64, 0..5)),
        angles(),
    );
    let second = (angle(), length(), angle(), pins, angle(), rods, length());
    let third =
        (of(proptest::collection::vec(bank, 0..4)), of(0..4_usize), length(), angles(), of(0..9_usize));
    let fourth = (length(), angles(), length(), angle(), any::<bool>());
    (first, second, third, fourth).prop_map(|(first, second, third, fourth)| {
        let (kind, cylinders, order, spacing, positions, crank_angles) = first;
        let (crank_phase, bank_stagger, bank_angle, pins, split_angle, rods, bank_offset) = second;
        let (banks, rows, row_spacing, row_angles, master) = third;
        let (knuckle_radius, knuckle_angles, rod_knuckle_radius, rod_knuckle_angle, alternating) = fourth;
        LayoutSpec {
            order,
            spacing,
            positions,
            crank_angles,
            crank_phase,
            bank_stagger,
            bank_angle,
            pins,
            split_angle,
            rods,
            bank_offset,
            banks,
            rows,
            row_spacing,
            row_angles,
            master,
            knuckle_radius,
            knuckle_angles,
            rod_knuckle_radius,
            rod_knuckle_angle,
            numbering: alternating.then_some(Numbering::Alternating),
            ..LayoutSpec::new(kind, cylinders, Strokes::Four)
        }
    })
}

/// The spec with every key that a problem names taken out, or put in with a value that can stand.
fn mended(mut spec: LayoutSpec) -> LayoutSpec {
    /// Puts in what is missing, takes out what is there.
    fn toggle<T>(key: &mut Option<T>, value: T) {
        *key = if key.is_some() { None } else { Some(value) };
    }
    for _ in 0..12 {
        for problem in arrange(&spec).err().unwrap_or_default() {
            match problem.key {
                "layout.cylinders" => spec.cylinders = 6,
                "layout.spacing" => toggle(&mut spec.spacing, 0.1),
                "layout.positions" => spec.positions = None,
                "layout.crank_angles" => {
                    let number = |word: &str| word.parse::<usize>().ok();
                    let count = problem.message.split(' ').find_map(number).unwrap_or(1);
                    spec.crank_angles = Some((0..count).map(|k| 0.7 * k as f64).collect());
                }
                "layout.crank_phase" => spec.crank_phase = None,
                "firing.order" => (spec.order, spec.crank_phase) = (None, None),
                "layout.numbering" => spec.numbering = None,
                "layout.bank_stagger" => toggle(&mut spec.bank_stagger, 0.02),
                "layout.bank_angle" => toggle(&mut spec.bank_angle, 1.0),
                "layout.pins" => spec.pins = None,
                "layout.split_angle" => toggle(&mut spec.split_angle, 1.0),
                "layout.rods" => spec.rods = None,
                "layout.bank_offset" => toggle(&mut spec.bank_offset, 0.01),
                "layout.banks" => {
                    let bank = |angle: f64| Bank { angle, offset: None };
                    toggle(&mut spec.banks, vec![bank(-1.0), bank(0.0), bank(1.0)]);
                }
                "layout.rows" => spec.rows = None,
                "layout.row_spacing" => toggle(&mut spec.row_spacing, 0.1),
                "layout.row_angles" => spec.row_angles = None,
                "layout.master" => spec.master = None,
                "layout.knuckle_radius" => toggle(&mut spec.knuckle_radius, 0.05),
                "layout.knuckle_angles" => spec.knuckle_angles = None,
                "articulated_rod.knuckle_radius" => toggle(&mut spec.rod_knuckle_radius, 0.05),
                "articulated_rod.knuckle_angle" => spec.rod_knuckle_angle = None,
                key => panic!("no such key: {key}"),
            }
        }
    }
    spec
}

proptest! {
    #[test]
    fn prop_an_arrangement_holds_together(spec in any_spec().prop_map(mended)) {
        let arrangement = arrange(&spec);
        prop_assert!(arrangement.is_ok(), "{:?}", arrangement);
        let arrangement = arrangement.unwrap();
        let rows = if spec.kind == LayoutKind::Radial { spec.rows.unwrap_or(1) } else { 1 };
        prop_assert_eq!(arrangement.cylinders.len(), spec.cylinders * rows);
        prop_assert_eq!(arrangement.throws[0].angle, 0.0);
        prop_assert!(arrangement.throws.iter().all(|throw| (0.0..TAU).contains(&throw.angle)));
        for throw in 0..arrangement.throws.len() {
            prop_assert!(arrangement.cylinders.iter().any(|cylinder| cylinder.throw == throw));
        }
        for cylinder in &arrangement.cylinders {
            prop_assert!(cylinder.throw < arrangement.throws.len());
            if let RodJoint::Articulated { master, knuckle_radius, .. } = cylinder.joint {
                let master = &arrangement.cylinders[master];
                prop_assert_eq!(master.joint, RodJoint::Crankpin);
                prop_assert_eq!(master.throw, cylinder.throw);
                prop_assert!(knuckle_radius > 0.0);
            }
        }
    }

    #[test]
    fn prop_any_spec_ends_in_an_arrangement_or_in_problems(spec in any_spec()) {
        if let Err(problems) = arrange(&spec) {
            prop_assert!(!problems.is_empty());
            prop_assert!(problems.iter().all(|problem| problem.key.contains('.') && !problem.message.is_empty()));
        }
    }
}
