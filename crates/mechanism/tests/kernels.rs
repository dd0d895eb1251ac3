//! The vector kernels against the scalar code, and with and without vector instructions.
mod support;

use lanchester_mechanism::{LoadRequest, Mechanism, Trace};
use proptest::prelude::*;
use support::assert_close;
use support::random::{ALL_SHAPES, any_engine};

/// The six components of a trace.
fn components(trace: &Trace) -> [&[f64]; 6] {
    [
        &trace.force_x,
        &trace.force_y,
        &trace.couple_x,
        &trace.couple_y,
        &trace.roll_moment,
        &trace.shaft_torque,
    ]
}

proptest! {
    #[test]
    fn prop_trace_is_the_same_with_and_without_vector_instructions(
        engine in any_engine(ALL_SHAPES), samples in 1..100usize,
    ) {
        let mechanism = Mechanism::new(&engine, &LoadRequest::default()).expect("the engine is valid");
        let plan = mechanism.trace_plan(mechanism.angle_grid(samples));
        let (mut best, mut portable) = (Trace::default(), Trace::default());
        plan.trace_into(&mut best);
        plan.trace_into_portable(&mut portable);
        let scale = mechanism.trace(64);
        for (k, (a, b)) in components(&best).into_iter().zip(components(&portable)).enumerate() {
            let largest = components(&scale)[k].iter().fold(1e-3f64, |m, v| m.max(v.abs()));
            for (j, (a, b)) in a.iter().zip(b).enumerate() {
                assert_close("vector against portable", *a, *b, 1e-13 * 8.0 * largest, 0.0, "rounding of a sum");
                let theta = best.theta[j];
                let c = mechanism.components(theta);
                let scalar =
                    [c.force_x, c.force_y, c.couple_x, c.couple_y, c.roll_moment, c.shaft_torque][k];
                assert_close("vector against scalar", *a, scalar, 1e-11 * largest, 0.0, "angles of many turns");
            }
        }
    }
}
