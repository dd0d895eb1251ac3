//! The vector kernels against the scalar code, and with and without vector instructions.
use crate::support::random::{ALL_SHAPES, any_engine};
use crate::support::{assert_close, list, scales};
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_results::Trace;
use proptest::prelude::*;

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
        let scale = scales(&engine);
        for (k, (a, b)) in components(&best).into_iter().zip(components(&portable)).enumerate() {
            for (j, (a, b)) in a.iter().zip(b).enumerate() {
                let reason = "rounding relative to the largest part";
                assert_close("vector against portable", *a, *b, 1e-13 * scale[k], 0.0, reason);
                let scalar = list(mechanism.components(best.theta[j]))[k];
                assert_close("vector against scalar", *a, scalar, 1e-12 * scale[k], 0.0, "angles of a few turns");
            }
        }
    }
}
