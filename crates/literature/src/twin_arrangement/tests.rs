//! Devices against the thesis's formulas, and residuals against first principles.

use super::*;
use lanchester_file::{read, template};
use lanchester_mechanism::{PeakMode, loads, series_coefficients};

fn engine(name: &str) -> Engine {
    read(template(name).unwrap().text).engine().unwrap()
}

fn fitted(name: &str, arrangement: TwinArrangement) -> Engine {
    arranged(&engine(name), arrangement, &ArrangementOptions::default()).unwrap()
}

fn first_and_second(engine: &Engine) -> [OrderLoads; 2] {
    let loads = loads(engine, &LoadRequest::default()).unwrap();
    [loads.total.orders[1], loads.total.orders[2]]
}

#[test]
fn numbers_go_both_ways() {
    for (k, arrangement) in TwinArrangement::ALL.into_iter().enumerate() {
        assert_eq!(arrangement.number(), k + 1);
        assert_eq!(TwinArrangement::from_number(k + 1), Some(arrangement));
    }
    assert_eq!((TwinArrangement::from_number(0), TwinArrangement::from_number(10)), (None, None));
}

#[test]
fn shafts_have_the_unbalance_of_the_formulas() {
    let twin = engine("twin-360");
    let options = ArrangementOptions::of_thesis();
    let cylinder = &twin.cylinders[0];
    let radius = twin.throws[0].radius;
    let first = radius * cylinder.reciprocating_mass();
    let second = first * series_coefficients(radius / cylinder.rod.length, 2, 5)[2] / 4.0;
    let four = arranged(&twin, TwinArrangement::TwoFirstTwoSecond, &options).unwrap();
    let amounts: Vec<f64> = four.shafts.iter().map(|s| s.weights[0].unbalance).collect();
    for (amount, expected) in amounts.iter().zip([first, first, second, second]) {
        // Formula against order coefficients: rounding alone.
        assert!((amount - expected).abs() <= 1e-13 * expected, "{amount} {expected}");
    }
    let axes: Vec<f64> = four.shafts.iter().map(|s| s.y).collect();
    assert_eq!(axes, [0.1, -0.1, 0.1, -0.1]);
    assert!(four.shafts.iter().all(|s| s.weights.len() == 1 && s.weights[0].z == 0.0));
}

#[test]
fn out_of_phase_twins_get_double_shafts() {
    let twin = fitted("twin-180", TwinArrangement::OneFirst);
    let cylinder = &twin.cylinders[0];
    let half = 0.5 * twin.throws[0].radius * cylinder.reciprocating_mass();
    let [front, rear] = &twin.shafts[0].weights[..] else { panic!("a double shaft has two weights") };
    assert_eq!([front.z, rear.z], [twin.cylinders[0].z, twin.cylinders[1].z]);
    for weight in [front, rear] {
        assert!((weight.unbalance - half).abs() <= 1e-13 * half);
    }
    let opposed = (front.phase - rear.phase).rem_euclid(std::f64::consts::TAU);
    assert!((opposed - std::f64::consts::PI).abs() < 1e-12);
    assert_eq!(crank_load(&twin, &ArrangementOptions::default()), Ok(Some(CrankLoad::Couple)));
}

/// Layouts with a first-order force, with a couple alone, with both, with neither; V, boxer, offset and split pins.
const LAYOUTS: [&str; 12] = [
    "single",
    "twin-360",
    "twin-180",
    "twin-270",
    "boxer-2",
    "in-line-3",
    "in-line-4",
    "in-line-5",
    "v2-45",
    "v2-90",
    "v6-90-odd",
    "vr6-15",
];

#[test]
fn shafts_cancel_their_orders_in_any_layout() {
    for name in LAYOUTS {
        let scale = {
            let basic = fitted(name, TwinArrangement::Basic);
            let speed = basic.speed.highest;
            let mass: f64 = basic.cylinders.iter().map(|c| c.reciprocating_mass()).sum();
            mass * basic.throws[0].radius * speed * speed
        };
        let small = |amount: f64| amount <= 1e-9 * scale;
        for arrangement in TwinArrangement::ALL {
            let [first, second] = first_and_second(&fitted(name, arrangement));
            let place = format!("{name} {arrangement:?}");
            if arrangement.first_order_shafts() == 2 {
                assert!(small(first.force_peak()) && small(first.couple_peak()), "{place}");
            }
            if arrangement.first_order_shafts() == 1 {
                assert!(small(first.force_backward.norm()) && small(first.couple_backward.norm()), "{place}");
                assert!(small(first.force_forward.norm()), "{place}");
            }
            if arrangement.second_order_shafts() == 2 {
                assert!(small(second.force_peak()) && small(second.couple_peak()), "{place}");
            }
            if arrangement.second_order_shafts() == 1 {
                assert!(small(second.force_forward.norm()) && small(second.couple_forward.norm()), "{place}");
            }
        }
    }
}

#[test]
fn the_basic_crank_leaves_no_rotating_force() {
    for name in LAYOUTS {
        let engine = fitted(name, TwinArrangement::Basic);
        let loads = loads(&engine, &LoadRequest::default()).unwrap();
        let of = |part: Part| loads.parts.iter().find(|p| p.part == part).unwrap().loads.orders[1];
        let left = of(Part::Rotating).force_forward + of(Part::Counterweights).force_forward;
        let alone: f64 = (0..engine.throws.len()).map(|k| engine.rotating_unbalance(k).abs()).sum();
        assert!(left.norm() <= 1e-12 * alone * loads.speed * loads.speed, "{name}");
    }
}

#[test]
fn the_optimised_crank_is_the_sweep_s_best_and_lowers_the_peak() {
    let options = ArrangementOptions::of_thesis();
    for name in ["single", "twin-360", "twin-180", "boxer-2"] {
        let plain = engine(name);
        let swept = swept_crank(&plain, TwinArrangement::OptimisedCrank, &options).unwrap().unwrap();
        let crank = arranged(&plain, TwinArrangement::OptimisedCrank, &options).unwrap();
        assert!((crank.counterweights[0].unbalance - swept.best().unbalance).abs() < 1e-17, "{name}");
        let request = LoadRequest {
            kinematics: options.kinematics,
            peaks: PeakMode::Grid(360),
            ..LoadRequest::default()
        };
        let peaks = loads(&crank, &request).unwrap().total.peaks;
        let peak = match swept.load {
            CrankLoad::Force => peaks.force.max.value,
            CrankLoad::Couple => peaks.couple.max.value,
        };
        // The loads sum the same parts in another order.
        assert!((peak - swept.best().criterion).abs() <= 1e-11 * peak, "{name}");
        assert!(peak < swept.basic.criterion, "{name}");
        assert_eq!(swept_crank(&plain, TwinArrangement::TwoFirst, &options), Ok(None));
    }
}

#[test]
fn an_order_that_is_balanced_already_needs_no_shaft() {
    let four = engine("in-line-4");
    assert_eq!(fitted("in-line-4", TwinArrangement::TwoFirst).shafts, []);
    assert_eq!(crank_load(&four, &ArrangementOptions::default()), Ok(None));
    let optimised = fitted("in-line-4", TwinArrangement::OptimisedCrank);
    assert_eq!(optimised.counterweights, fitted("in-line-4", TwinArrangement::Basic).counterweights);
}

#[test]
fn given_amounts_stand_in_the_place_of_found_ones() {
    let given = GivenAmounts { crank: Some(0.03), first_order: Some(0.04), second_order: Some(0.001) };
    let options = ArrangementOptions { given, ..ArrangementOptions::default() };
    let twin = arranged(&engine("twin-180"), TwinArrangement::OneFirstOneSecond, &options).unwrap();
    assert!(twin.counterweights.iter().all(|w| (w.unbalance - 0.03).abs() < 1e-17));
    assert!(twin.shafts[0].weights.iter().all(|w| w.unbalance == 0.04));
    assert!(twin.shafts[1].weights.iter().all(|w| w.unbalance == 0.001));
    let given = GivenAmounts { crank: Some(-0.03), ..GivenAmounts::default() };
    let options = ArrangementOptions { given, ..ArrangementOptions::default() };
    let refused = arranged(&engine("twin-180"), TwinArrangement::Basic, &options);
    assert!(matches!(refused, Err(BalanceError::Number { .. })));
}

#[test]
fn geared_crankshafts_are_refused() {
    let refused = arranged(&engine("square-4"), TwinArrangement::Basic, &ArrangementOptions::default());
    assert!(matches!(refused, Err(BalanceError::Missing { .. })));
}
