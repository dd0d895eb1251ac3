//! The engines of the gallery, from file to orders, against what the textbooks say of their layouts.
//!
//! For first and second order, force and couple, forward and backward: `0` where it vanishes, `x` where it stands.
mod support;

use lanchester_mechanism::{LoadRequest, Mechanism, OrderLoads};
use lanchester_model::{Engine, read, template, templates};
use support::assert_close;

/// Below this part of one cylinder's first-order force (times the length of the crank for couples) a load counts as
/// gone: the files round the unbalance of their shafts to four figures.
const GONE: f64 = 5e-4;
/// Above this part it stands; the smallest that do come from offsets and articulated rods.
const STANDS: f64 = 2e-3;

/// Name, first order, second order: each `F forward, F backward, M forward, M backward`.
const TEXTBOOK: [(&str, &str, &str); 42] = [
    ("single", "0x00", "xx00"),
    ("single-two-shafts", "0000", "xx00"),
    ("twin-360", "xx00", "xx00"),
    ("twin-180", "000x", "xx00"),
    ("twin-270", "000x", "00xx"),
    ("boxer-2", "00xx", "00xx"),
    ("v2-45", "0x00", "xx00"),
    ("v2-60-split", "000x", "0xxx"),
    ("v2-90", "000x", "xxxx"),
    ("in-line-2-two-stroke", "000x", "xx00"),
    ("in-line-3", "000x", "00xx"),
    ("in-line-3-shaft", "0000", "00xx"),
    ("in-line-3-two-stroke", "000x", "00xx"),
    ("in-line-4", "0000", "xx00"),
    ("in-line-4-lanchester", "0000", "0000"),
    ("in-line-4-crossplane", "0000", "0000"),
    ("in-line-5", "000x", "00xx"),
    ("in-line-6", "0000", "0000"),
    ("in-line-8", "0000", "0000"),
    ("boxer-4", "0000", "00xx"),
    ("boxer-6", "0000", "0000"),
    ("flat-12", "0000", "0000"),
    ("v4-90", "0000", "xxxx"),
    ("v6-60", "0000", "000x"),
    ("v6-90", "000x", "00xx"),
    ("v6-90-odd", "0000", "00xx"),
    ("v6-120", "000x", "00xx"),
    ("vr6-15", "00xx", "00xx"),
    ("v8-crossplane", "0000", "0000"),
    ("v8-flat-plane", "0000", "xxxx"),
    ("v10-72", "000x", "00xx"),
    ("v10-90", "0000", "00xx"),
    ("v12-60", "0000", "0000"),
    ("v16-45", "0000", "0000"),
    ("w12-broad-arrow", "0000", "xxx0"),
    ("radial-3", "xx00", "xx00"),
    ("radial-5", "xx00", "xx00"),
    ("radial-7", "xx00", "xx00"),
    ("radial-9", "xx00", "xx00"),
    ("radial-14", "0xxx", "xxxx"),
    ("square-4", "0000", "xx00"),
    ("opposed-piston-3", "00xx", "00xx"),
];

fn engine(name: &str) -> Engine {
    let template = template(name).unwrap_or_else(|| panic!("no template {name}"));
    read(template.text).engine.unwrap_or_else(|| panic!("{name} does not read"))
}

fn orders(engine: &Engine) -> Vec<OrderLoads> {
    Mechanism::new(engine, &LoadRequest::default()).expect("the engine is valid").orders()
}

/// First-order force of cylinder 1's reciprocating mass [N].
fn unit_force(engine: &Engine) -> f64 {
    let cylinder = &engine.cylinders[0];
    cylinder.reciprocating_mass() * engine.throws[cylinder.throw].radius * engine.speed.highest.powi(2)
}

/// Distance of the outermost cylinders [m]; 1 m for a single plane.
fn crank_length(engine: &Engine) -> f64 {
    let z = || engine.cylinders.iter().map(|cylinder| cylinder.z);
    let length = z().fold(f64::MIN, f64::max) - z().fold(f64::MAX, f64::min);
    if length > 0.0 { length } else { 1.0 }
}

#[test]
fn lit_what_vanishes_and_what_stands() {
    assert_eq!(TEXTBOOK.len(), templates().len());
    let mut differences = String::new();
    for (name, first, second) in TEXTBOOK {
        let engine = engine(name);
        let orders = orders(&engine);
        let force = unit_force(&engine);
        let couple = force * crank_length(&engine);
        for (number, wanted) in [(1, first), (2, second)] {
            let order = &orders[number];
            let parts = [
                order.force_forward.norm() / force,
                order.force_backward.norm() / force,
                order.couple_forward.norm() / couple,
                order.couple_backward.norm() / couple,
            ];
            let right = parts.iter().zip(wanted.chars()).all(|(&part, wanted)| match wanted {
                '0' => part < GONE,
                _ => part > STANDS,
            });
            if !right {
                differences += &format!("{name}, order {number}: wanted {wanted}, got {parts:.6?}\n");
            }
        }
    }
    assert!(differences.is_empty(), "{differences}");
}

/// Second coefficient of the acceleration, series to the seventh power of the rod ratio.
fn second_coefficient(engine: &Engine) -> f64 {
    let ratio = engine.throws[0].radius / engine.cylinders[0].rod.length;
    ratio + ratio.powi(3) / 4.0 + 15.0 * ratio.powi(5) / 128.0 + 35.0 * ratio.powi(7) / 512.0
}

/// Closed forms for engines of equal cylinders. The series leaves out 0.07 (r/l)^9, below 1e-5 of its first term.
#[test]
fn lit_amplitudes_in_closed_form() {
    let check = |name: &str, quantity: &str, got: f64, wanted: f64| {
        assert_close(&format!("{name}, {quantity}"), got, wanted, 0.0, 2e-5, "series to the seventh power");
    };
    let first = |name: &str| (engine(name), orders(&engine(name))[1]);
    let second = |name: &str| (engine(name), orders(&engine(name))[2]);

    // In-line three: the couple is sqrt(3) m r w^2 a, half of it backward.
    let (engine, order) = first("in-line-3");
    check(
        "in-line-3",
        "couple",
        order.couple_backward.norm(),
        0.5 * 3_f64.sqrt() * unit_force(&engine) * 0.078,
    );
    // In-line four: 4 m r w^2 A2.
    let (engine, order) = second("in-line-4");
    check("in-line-4", "force", order.force_peak(), 4.0 * unit_force(&engine) * second_coefficient(&engine));
    // In-line five, order 1-2-4-5-3: 0.449 of first and 4.980 of second order, times the spacing.
    let (engine, order) = first("in-line-5");
    let couple = unit_force(&engine) * 0.088;
    assert_close(
        "in-line-5, first",
        2.0 * order.couple_backward.norm() / couple,
        0.449,
        5e-4,
        0.0,
        "three digits",
    );
    let (engine, order) = second("in-line-5");
    let couple = unit_force(&engine) * 0.088 * second_coefficient(&engine);
    assert_close("in-line-5, second", order.couple_peak() / couple, 4.980, 5e-4, 0.0, "three digits");
    // 90-degree V-twin and flat-plane V8: sqrt(2) m r w^2 A2 a pair.
    let (engine, order) = second("v2-90");
    let pair = 2_f64.sqrt() * unit_force(&engine) * second_coefficient(&engine);
    check("v2-90", "force", order.force_peak(), pair);
    let (engine, order) = second("v8-flat-plane");
    let pair = 2_f64.sqrt() * unit_force(&engine) * second_coefficient(&engine);
    check("v8-flat-plane", "force", order.force_peak(), 4.0 * pair);
    // V6 with pins split for even firing: 3 m r w^2 A2 a / 2 of second order at 60 degrees, all of it backward.
    let (engine, order) = second("v6-60");
    let couple = unit_force(&engine) * second_coefficient(&engine) * 0.108;
    check("v6-60", "couple", order.couple_backward.norm(), 1.5 * couple);
    // Broad arrow: across the middle bank three times what is along it.
    let (_, order) = second("w12-broad-arrow");
    let (forward, backward) = (order.force_forward.norm(), order.force_backward.norm());
    check("w12-broad-arrow", "across over along", (forward + backward) / (forward - backward), 3.0);
}

/// The second-order counterbalances of the great radials run at twice crank speed in the sense of the crank.
#[test]
fn lit_radial_second_order_turns_with_the_crank() {
    for name in ["radial-5", "radial-7", "radial-9", "radial-14"] {
        let order = orders(&engine(name))[2];
        let (forward, backward) = if name == "radial-14" {
            (order.couple_forward.norm(), order.couple_backward.norm())
        } else {
            (order.force_forward.norm(), order.force_backward.norm())
        };
        assert!(forward > 10.0 * backward, "{name}: {forward} against {backward}");
    }
}
