//! Orders against a Fourier transform of the exact trace.
use crate::support::assert_close;
use crate::support::random::{ALL_SHAPES, PLAIN, any_engine};
use lanchester_mechanism::{Kinematics, LoadRequest, Mechanism};
use lanchester_model::Engine;
use lanchester_results::OrderLoads;
use num_complex::Complex64;
use proptest::prelude::*;
use rustfft::FftPlanner;

/// Fourier coefficients of a complex function at positive and negative frequencies, per period.
fn transform(re: &[f64], im: &[f64]) -> Vec<Complex64> {
    let mut values: Vec<Complex64> = re.iter().zip(im).map(|(&a, &b)| Complex64::new(a, b)).collect();
    FftPlanner::new().plan_fft_forward(values.len()).process(&mut values);
    let count = values.len() as f64;
    values.into_iter().map(|v| v / count).collect()
}

/// Compares all orders with the transform of a trace of 512 angles a revolution.
fn compare(engine: &Engine, request: &LoadRequest, tolerance: f64) {
    let mechanism = Mechanism::new(engine, request).expect("the engine is valid");
    let trace = mechanism.trace(512);
    let revolutions = (mechanism.period() / std::f64::consts::TAU).round();
    let zero = vec![0.0; trace.theta.len()];
    let force = transform(&trace.force_x, &trace.force_y);
    let couple = transform(&trace.couple_x, &trace.couple_y);
    let roll = transform(&trace.roll_moment, &zero);
    let torque = transform(&trace.shaft_torque, &zero);
    let largest = |v: &[Complex64]| v.iter().map(|c| c.norm()).fold(1e-3, f64::max);
    let scale = [largest(&force), largest(&couple), largest(&roll), largest(&torque)];
    let count = force.len();
    let mut orders = Vec::new();
    let plan = mechanism.order_plan();
    plan.orders_into(&mut orders);
    let mut portable = Vec::new();
    plan.orders_into_portable(&mut portable);
    for (order, other) in orders.iter().zip(&portable) {
        let key = (order.order * revolutions).round() as usize;
        if key == 0 {
            continue;
        }
        let close = |name: &str, got: Complex64, wanted: Complex64, scale: f64| {
            let reason = "both exact: rounding of sums relative to the largest order";
            assert_close(name, (got - wanted).norm(), 0.0, tolerance * scale, 0.0, reason);
        };
        close("forward force", order.force_forward, force[key], scale[0]);
        close("backward force", order.force_backward, force[count - key], scale[0]);
        close("forward couple", order.couple_forward, couple[key], scale[1]);
        close("backward couple", order.couple_backward, couple[count - key], scale[1]);
        close("roll moment", order.roll_moment, 2.0 * roll[key], scale[2]);
        close("shaft torque", order.shaft_torque, 2.0 * torque[key], scale[3]);
        let values = |o: &OrderLoads| {
            [
                o.force_forward,
                o.force_backward,
                o.couple_forward,
                o.couple_backward,
                o.roll_moment,
                o.shaft_torque,
            ]
        };
        for (k, (a, b)) in values(order).into_iter().zip(values(other)).enumerate() {
            let scale = [scale[0], scale[0], scale[1], scale[1], scale[2], scale[3]][k];
            assert_close("vector against portable", (a - b).norm(), 0.0, 1e-13 * scale, 0.0, "rounding");
        }
    }
}

proptest! {
    #[test]
    fn prop_orders_are_the_transform_of_the_trace(engine in any_engine(ALL_SHAPES), max_order in 1..60u32) {
        compare(&engine, &LoadRequest { max_order, ..LoadRequest::default() }, 1e-12);
    }

    #[test]
    fn prop_orders_of_truncated_motion_are_the_transform_of_its_trace(
        engine in any_engine(ALL_SHAPES), cap in 1..9u32,
    ) {
        let kinematics = Kinematics::Orders(cap);
        compare(&engine, &LoadRequest { kinematics, ..LoadRequest::default() }, 1e-12);
    }

    #[test]
    fn prop_orders_of_the_power_series_are_the_transform_of_its_trace(
        engine in any_engine(PLAIN), max_order in 1..9u32, max_power in 1..9u32,
    ) {
        let mut engine = engine;
        engine = engine.with(|engine| { for cylinder in &mut engine.cylinders {
            (cylinder.offset, cylinder.pin_offset) = (0.0, 0.0);
        } }).unwrap();
        let kinematics = Kinematics::PowerSeries { max_order, max_power };
        compare(&engine, &LoadRequest { kinematics, ..LoadRequest::default() }, 1e-12);
    }
}
