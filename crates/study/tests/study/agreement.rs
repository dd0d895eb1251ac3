//! The search's loads are those of the layouts as engines.
use crate::support;
use crate::support::parts;
use lanchester_mechanism::{BeamModel, InternalRequest, LoadRequest, internal_moments, loads};
use lanchester_study::explore::*;
use lanchester_testkit::{Within, assert_close};
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::TAU;

#[track_caller]
fn close(what: &str, got: Complex64, wanted: Complex64, scale: f64) {
    assert_close(what, got, wanted, Within::of(scale, 1e-12, "rounding of all that is summed"));
}

fn sense() -> impl Strategy<Value = Sense> {
    prop::sample::select(vec![Sense::Forward, Sense::Backward])
}

prop_compose! {
    fn any_shaft()(
        order in 1..=2u32, sense in sense(), x in -0.2..0.2f64, y in -0.2..0.2f64,
        kind in 0..3u8, z in -0.3..0.0f64, length in 0.1..0.4f64,
    ) -> ShaftDesign {
        let removes = match kind {
            0 => Removes::Force { z },
            1 => Removes::Couple { z: [z, z + length] },
            _ => Removes::Both { z: [z, z + length] },
        };
        ShaftDesign { order, sense, x, y, removes }
    }
}

prop_compose! {
    /// A space of one case or two with everything in it.
    fn any_space()(
        groups in 1..7usize, in_line in any::<bool>(), bank in 0.2..180.0f64, split in prop::option::of(-170.0..190.0f64),
        stagger in -0.03..0.03f64, angles in prop::collection::vec(0.01..TAU, 1..4), ratio in 0.1..0.5f64,
        rotating in 0.0..2.0f64, reciprocating in 0.0..1.0f64, webs in prop::option::of(prop::collection::vec(any::<bool>(), 12)),
        shafts in prop::collection::vec(any_shaft(), 0..3), unbalance in -0.01..0.03f64, inertia in prop::option::of(0.0..0.004f64),
    ) -> Space {
        let banks = match in_line {
            true => Banks::InLine,
            false => support::two(&[bank], &[split.unwrap_or(0.0)], &[stagger]),
        };
        let webs = webs.map(|webs| webs[..2 * groups].to_vec());
        Space {
            parts: Parts { throw_unbalance: unbalance, rod_inertia: inertia, ..parts() },
            cylinders: if in_line { groups } else { 2 * groups },
            banks,
            throw_angles: angles,
            spacings: vec![0.1],
            rod_ratios: vec![ratio],
            counterweights: vec![CounterweightPattern { name: "any".into(), rotating, reciprocating, webs }],
            shafts: vec![ShaftSet { name: "any".into(), shafts }],
            firing: false,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn prop_loads_are_those_of_the_engine(space in any_space(), place in 0.0..1.0f64) {
        let parts = space.parts;
        let explorer = support::explorer(space, &[Objective::Shafts], &[]);
        let case = ((explorer.size() as f64 * place) as u128).min(explorer.size() - 1);
        let layout = explorer.layout(case).expect("a case");
        let engine = layout.engine(&parts).expect("an engine");
        let all = loads(&engine, &LoadRequest { max_order: 2, samples: 1, ..LoadRequest::default() }).expect("loads");
        let got = explorer.orders(case).expect("loads");
        // Rounding is measured against all that was summed: masses and shafts at the farthest plane.
        let mut unbalance = layout.cylinders as f64 * 1.2 * parts.crank_radius * 4.0;
        unbalance += layout.groups() as f64 * parts.throw_unbalance.abs();
        unbalance += engine.shafts.iter().flat_map(|s| &s.weights).map(|w| 4.0 * w.unbalance).sum::<f64>();
        unbalance += engine.counterweights.iter().map(|w| w.unbalance).sum::<f64>();
        let force = unbalance * parts.speed.powi(2);
        for n in 1..=2u32 {
            let order = &all.total.orders[n as usize];
            let k = n as usize - 1;
            close("force forward", got.force_of(n, Sense::Forward), order.force_forward, force);
            close("force backward", got.force_of(n, Sense::Backward), order.force_backward, force);
            close("couple forward", got.couple_of(n, Sense::Forward), order.couple_forward, force);
            close("couple backward", got.couple_of(n, Sense::Backward), order.couple_backward, force);
            close("roll moment", got.roll_moment[k], order.roll_moment, force);
            close("torque", got.shaft_torque[k], order.shaft_torque, force);
        }
    }

    #[test]
    fn prop_bending_moment_and_main_loads_are_those_of_the_crankshaft(space in any_space()) {
        let parts = space.parts;
        let explorer = support::explorer(space, &[Objective::BendingMoment, Objective::MainLoad], &[]);
        let found = explorer.explore().expect("it runs");
        for candidate in &found.front {
            let layout = explorer.layout(candidate.case).expect("a case");
            let engine = layout.engine(&parts).expect("an engine");
            let inside = internal_moments(&engine, &InternalRequest { samples: 8, ..InternalRequest::default() }).expect("a beam");
            let crank = &inside.crankshafts[0];
            let wanted = [crank.of(BeamModel::FreeBeam).peak_moment.value, crank.of(BeamModel::ThrowByThrow).peak_main.value];
            let force = (1.2 * parts.crank_radius * 4.0 + 0.03) * 12.0 * parts.speed.powi(2);
            for k in 0..2 {
                prop_assert!((candidate.values[k] - wanted[k]).abs() <= 1e-12 * force, "{:?} {:?}", candidate.values, wanted);
            }
        }
    }
}
