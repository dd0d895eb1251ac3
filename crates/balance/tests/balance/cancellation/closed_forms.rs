//! Engines whose exact cancellation is known in closed form.

use crate::cancellation::support::*;
use lanchester_balance::*;
use lanchester_model::*;
use lanchester_task::*;

const FORCE_1: (Load, f64) = (Load::Force, 1.0);
const COUPLE_1: (Load, f64) = (Load::Couple, 1.0);
const FORCE_2: (Load, f64) = (Load::Force, 2.0);

/// Total of what one cylinder's crank throw and rod turn [kg m].
fn rotating(engine: &Engine) -> f64 {
    masses(engine).1 + engine.throws[0].unbalance
}

#[test]
fn single_cylinder_with_two_shafts_of_first_order() {
    let engine = stripped("single");
    let (reciprocating, _) = masses(&engine);
    // A weight on the crank takes the rotating part and the half that turns with it, the shaft the other half.
    let mut one = task(on_crank(&[0.0]), &[FORCE_1]);
    add_shaft(&mut one, -1, 0.0, 0.0, &[0.0]);
    let answer = optimise(&engine, &one).unwrap();
    let total = assert_vanishes(&engine, &answer);
    close(total, rotating(&engine) + reciprocating, 1e-9, "crank and one shaft");
    close(answer.weights[1].unbalance.norm(), 0.5 * reciprocating, 1e-9, "the shaft");
    // Two counter-rotating shafts at y = +-d, x = 0 and nothing on the crank.
    let mut two = task(Vec::new(), &[FORCE_1]);
    add_shaft(&mut two, 1, 0.0, 0.08, &[0.0]);
    add_shaft(&mut two, -1, 0.0, -0.08, &[0.0]);
    let answer = optimise(&engine, &two).unwrap();
    close(assert_vanishes(&engine, &answer), rotating(&engine) + reciprocating, 1e-9, "two shafts");
}

#[test]
fn single_cylinder_second_order_needs_both_senses() {
    let engine = stripped("single");
    let (reciprocating, _) = masses(&engine);
    let c2 = second_order(&engine);
    let mut both = task(Vec::new(), &[FORCE_2]);
    add_shaft(&mut both, 2, 0.0, 0.05, &[0.0]);
    add_shaft(&mut both, -2, 0.0, -0.05, &[0.0]);
    let total = assert_vanishes(&engine, &optimise(&engine, &both).unwrap());
    close(total, reciprocating * c2 / 4.0, 1e-9, "m r c_2 / 8 each");
    let mut one = task(Vec::new(), &[FORCE_2]);
    add_shaft(&mut one, 2, 0.0, 0.05, &[0.0]);
    let answer = optimise(&engine, &one).unwrap();
    let proofs = assert_cannot(&engine, &answer);
    assert_eq!(proofs.len(), 1);
    assert!(proofs[0].reason.contains("turning against the crank"), "{}", proofs[0].reason);
    let left = cancellation(&answer).orders[0].left;
    close(left, 0.5 * reciprocating * c2 * engine.speed.highest.powi(2), 1e-8, "half stays");
}

#[test]
fn in_line_four_with_lanchesters_shafts() {
    let engine = stripped("in-line-4");
    let (reciprocating, _) = masses(&engine);
    let mut shafts = task(Vec::new(), &[FORCE_2]);
    add_shaft(&mut shafts, 2, -0.05, 0.1, &[0.0]);
    add_shaft(&mut shafts, -2, -0.05, -0.1, &[0.0]);
    let answer = optimise(&engine, &shafts).unwrap();
    let total = assert_vanishes(&engine, &answer);
    // 4 m r w^2 c_2 = 2 (2 w)^2 U
    let each = 0.5 * reciprocating * second_order(&engine);
    close(total, 2.0 * each, 1e-9, "both shafts");
    answer.weights.iter().for_each(|w| close(w.unbalance.norm(), each, 1e-9, &w.name));
}

#[test]
fn in_line_three_with_one_shaft_against_the_crank() {
    let engine = stripped("in-line-3");
    let (reciprocating, _) = masses(&engine);
    let planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    let spacing = planes[1] - planes[0];
    let mut three = beside_crank(&planes, &[FORCE_1, COUPLE_1]);
    let reach = 0.15;
    add_shaft(&mut three, -1, 0.0, 0.1, &[-reach, reach]);
    let answer = optimise(&engine, &three).unwrap();
    let total = assert_vanishes(&engine, &answer);
    // |SUM z e^{ia}| = sqrt(3) spacing; the outer throws are spacing away from the middle.
    let sum = 3f64.sqrt() * spacing;
    let crank = (rotating(&engine) + 0.5 * reciprocating) * sum / spacing;
    let shaft = 0.5 * reciprocating * sum / reach;
    close(total, crank + shaft, 1e-8, "crank and shaft");
    assert!(!answer.weights[1].used, "the middle weight has no lever");
    // Without the shaft half of the reciprocating couple stays.
    let crank_only = task(on_crank(&planes), &[FORCE_1, COUPLE_1]);
    let answer = optimise(&engine, &crank_only).unwrap();
    assert_cannot(&engine, &answer);
    let orders = &cancellation(&answer).orders;
    let half = 0.5 * reciprocating * sum * engine.speed.highest.powi(2);
    close(orders[1].left, half, 1e-8, "couple");
    close(orders[1].least_alone, half, 1e-8, "couple alone");
    assert!(
        orders[0].left < 1e-9 * all_masses(&engine) && orders[0].least_alone < 1e-9 * all_masses(&engine)
    );
}

#[test]
fn parallel_twin_with_crank_weights_alone() {
    let engine = stripped("twin-360");
    let (reciprocating, _) = masses(&engine);
    let planes: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
    let answer = optimise(&engine, &task(on_crank(&planes), &[FORCE_1])).unwrap();
    let proofs = assert_cannot(&engine, &answer);
    let [only] = proofs else { panic!("one proof, got {proofs:#?}") };
    let [term] = &only.functional.terms[..] else { panic!("one term, got {only:#?}") };
    assert_eq!(term.sense, OrderSense::Backward);
    assert!(only.reason.contains("turn with it, none against the crank"), "{}", only.reason);
    let half = reciprocating * engine.speed.highest.powi(2);
    close(term.amount.norm(), half, 1e-9, "the half against the crank");
    close(cancellation(&answer).orders[0].left, half, 1e-8, "least remaining");
    // The crank is raised to the rotating part and half of the reciprocating one.
    let raised: num_complex::Complex64 = answer.weights.iter().map(|w| w.unbalance).sum();
    close(raised.norm(), 2.0 * rotating(&engine) + reciprocating, 1e-8, "crank weights");
}

#[test]
fn right_angled_v_twin_vanishes_with_crank_weights_alone() {
    let engine = stripped("v2-90");
    let (reciprocating, big_end) = masses(&engine);
    let crank: f64 = engine.throws.iter().map(|t| t.unbalance).sum();
    let answer = optimise(&engine, &task(on_crank(&[0.0]), &[FORCE_1])).unwrap();
    let total = assert_vanishes(&engine, &answer);
    close(total, crank + 2.0 * big_end + reciprocating, 1e-9, "the classical rule");
}

#[test]
fn v_six_by_bank_angle() {
    let of = |name: &str, shaft: Option<i32>| {
        let engine = stripped(name);
        let ends: Vec<f64> = engine.throws.iter().map(|t| t.z).collect();
        let (first, last) = (ends[0], ends[ends.len() - 1]);
        let mut six = task(on_crank(&[first, last]), &[FORCE_1, COUPLE_1]);
        if let Some(ratio) = shaft {
            add_shaft(&mut six, ratio, 0.0, 0.1, &[first, last]);
        }
        let answer = optimise(&engine, &six).unwrap();
        (engine, answer)
    };
    // A pair's parts against the crank cancel where its second pin stands at the first + 2 bank angle - 180 degrees:
    // shared pins at 90 degrees, pins 60 degrees behind at 60 degrees. The crank takes the rest.
    for name in ["v6-90-odd", "v6-60"] {
        let (engine, answer) = of(name, None);
        assert_vanishes(&engine, &answer);
    }
    // Even firing at 90 degrees splits the pins by 30 degrees: a couple against the crank stays, and one shaft takes it.
    let (engine, answer) = of("v6-90", None);
    let proofs = assert_cannot(&engine, &answer);
    let couple = Criterion::Order(Load::Couple, 1.0);
    let against = |t: &FunctionalTerm| t.sense == OrderSense::Backward && t.criterion == couple;
    assert!(proofs.iter().all(|p| p.functional.terms.iter().all(against)), "{proofs:#?}");
    let (engine, answer) = of("v6-90", Some(-1));
    assert_vanishes(&engine, &answer);
}
