//! What every textbook says of the common layouts: which loads vanish, and which stand right beside them.
use crate::support;
use crate::support::{assert_close, engine, in_line, throw, vee};
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::Engine;
use lanchester_results::OrderLoads;

/// Orders of an engine about the origin.
fn orders(engine: &Engine) -> Vec<OrderLoads> {
    Mechanism::new(engine, &LoadRequest::default()).expect("the engine is valid").orders()
}

/// First-order force of one cylinder's reciprocating mass: m r w^2, with the masses of `support::cylinder`.
const RECIPROCATING: f64 = 0.7 * 0.045 * 300.0 * 300.0;

/// Vanishes by symmetry: only rounding of the largest load is left.
#[track_caller]
fn vanishes(quantity: &str, value: f64) {
    assert_close(
        quantity,
        value,
        0.0,
        1e-12 * 12.0 * RECIPROCATING,
        0.0,
        "rounding of twelve cylinders' sum",
    );
}

/// Stands where the neighbour vanishes: of the size of one cylinder's load, not of rounding.
#[track_caller]
fn stands(quantity: &str, value: f64, least: f64) {
    assert!(value > least, "{quantity}: got {value:e}, wanted more than {least:e}");
}

#[test]
fn in_line_four_has_second_order_force_only() {
    let orders = orders(&in_line(&[0.0, 180.0, 180.0, 0.0]));
    vanishes("first-order force", orders[1].force_peak());
    vanishes("first-order couple", orders[1].couple_peak());
    vanishes("second-order couple", orders[2].couple_peak());
    stands("second-order force", orders[2].force_peak(), RECIPROCATING);
    let difference = orders[2].force_forward.norm() - orders[2].force_backward.norm();
    vanishes("forward less backward second order", difference);
}

#[test]
fn in_line_six_has_nothing_below_sixth_order() {
    let orders = orders(&in_line(&[0.0, 120.0, 240.0, 240.0, 120.0, 0.0]));
    for order in &orders[..6] {
        vanishes("force below sixth order", order.force_peak());
        vanishes("couple below sixth order", order.couple_peak());
    }
    stands("sixth-order force", orders[6].force_peak(), 1e-4 * RECIPROCATING);
    stands("third-order roll moment", orders[3].roll_moment.norm(), 1e-3 * RECIPROCATING);
}

#[test]
fn v_twelve_has_nothing_below_sixth_order() {
    let orders = orders(&vee(60.0, &[0.0, 120.0, 240.0, 240.0, 120.0, 0.0]));
    for order in &orders[..6] {
        vanishes("force below sixth order", order.force_peak());
        vanishes("couple below sixth order", order.couple_peak());
    }
    stands("sixth-order force", orders[6].force_peak(), 1e-4 * RECIPROCATING);
}

#[test]
fn boxer_twin_has_couples_only() {
    let z = 0.02;
    let throws = vec![throw(0.0, -z), throw(std::f64::consts::PI, z)];
    let cylinders = vec![support::cylinder(0, 0.0, -z), support::cylinder(1, std::f64::consts::PI, z)];
    let orders = orders(&engine("boxer", throws, cylinders));
    for order in &orders {
        vanishes("force of any order", order.force_peak());
    }
    stands("first-order couple", orders[1].couple_peak(), z * RECIPROCATING);
    stands("second-order couple", orders[2].couple_peak(), 0.1 * z * RECIPROCATING);
}

#[test]
fn ninety_degree_twin_needs_crank_weights_only_in_first_order() {
    let orders = orders(&vee(90.0, &[0.0]));
    vanishes("backward first-order force", orders[1].force_backward.norm());
    // Rotating 2 m_rot r + U, and the reciprocating masses of both cylinders, m r: all turn forward.
    let wanted = RECIPROCATING + (2.0 * 0.4 * 0.045 + 0.01) * 9e4;
    assert_close("forward first-order force", orders[1].force_forward.norm(), wanted, 0.0, 1e-14, "rounding");
    stands("second-order force", orders[2].force_peak(), 0.1 * RECIPROCATING);
}

#[test]
fn crossplane_eight_has_a_forward_first_order_couple_only() {
    let orders = orders(&vee(90.0, &[0.0, 90.0, 270.0, 180.0]));
    for order in &orders[1..4] {
        vanishes("force below fourth order", order.force_peak());
    }
    vanishes("backward first-order couple", orders[1].couple_backward.norm());
    vanishes("second-order couple", orders[2].couple_peak());
    stands("forward first-order couple", orders[1].couple_forward.norm(), 0.1 * RECIPROCATING);
}
