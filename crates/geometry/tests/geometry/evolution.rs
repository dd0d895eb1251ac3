//! The evolutionary search against the proved optimum: it meets every limit and never wins.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::support::random_design::{paper, violation};
use lanchester_geometry::{
    DesignLimits, DesignOutcome, DesignSettings, DesignTask, Objective, Range, Shoulder, design, evolve,
};
use proptest::prelude::*;

fn range(least: std::ops::Range<f64>, width: f64) -> impl Strategy<Value = Range> {
    (least, prop_oneof![1 => Just(0.0), 4 => 0.0..width]).prop_map(|(least, w)| Range::new(least, least + w))
}

/// Tasks that can be met and some that cannot: every dimension free or given, every limit there or not.
fn any_task() -> impl Strategy<Value = DesignTask> {
    let flank = prop_oneof![
        range(0.0..1.0, 0.4).prop_map(Shoulder::Angle),
        range(0.0..0.02, 0.02).prop_map(Shoulder::Height)
    ];
    let shape = (
        range(0.01..0.03, 0.02),
        range(0.0..0.03, 0.02),
        flank,
        range(0.04..0.07, 0.03),
        range(0.8..3.0, 2.5),
        range(0.004..0.02, 0.02),
    );
    let limit = |values: std::ops::Range<f64>| prop::option::of(values);
    let angle = prop::option::weighted(0.3, range(0.0..0.6, 0.9));
    let limits = (limit(0.1..0.6), limit(0.06..0.11), limit(1e-4..1e-3), limit(0.03..0.09), angle);
    let duty = (4e-3..1.5e-2, 0.8..1.0, prop::option::of(1.0..1.4));
    (shape, limits, duty).prop_map(
        |(shape, (mass, swept_radius, inertia, half_width, shoulder_angle), (unbalance, least, most))| {
            DesignTask {
                unbalance,
                least_balance: least,
                most_balance: most,
                density: 8000.0,
                web_radius: shape.0,
                rectangle_height: shape.1,
                shoulder: shape.2,
                arc_radius: shape.3,
                arc_angle: shape.4,
                thickness: shape.5,
                limits: DesignLimits {
                    mass,
                    swept_radius,
                    inertia,
                    half_width,
                    shoulder_angle,
                    shoulder_height: None,
                },
                settings: DesignSettings::default(),
            }
        },
    )
}

const OBJECTIVES: [Objective; 4] =
    [Objective::Mass, Objective::SweptRadius, Objective::Inertia, Objective::Thickness];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn prop_evolution_meets_all_limits_and_never_wins(
        task in any_task(), which in 0usize..4, seed in any::<u64>()
    ) {
        let objective = OBJECTIVES[which];
        let outcome = design(&task, objective).unwrap();
        let evolution = evolve(&task, objective, seed, 4000).unwrap();
        prop_assert!(!evolution.proved && evolution.evaluations == 4000);
        prop_assert_eq!(evolution.best.is_some(), evolution.feasible > 0);
        let Some(best) = evolution.best else { return Ok(()) };
        prop_assert!(violation(&task, &best.design) < 1e-9, "{:?}", best);
        match outcome {
            // The bound is the optimum less the proved gap.
            DesignOutcome::Found(optimum) => {
                prop_assert!(optimum.proved);
                prop_assert!(best.value >= optimum.bound * (1.0 - 1e-9), "{best:?} beats {optimum:?}");
            }
            DesignOutcome::Infeasible(why) => prop_assert!(!why.proved, "{best:?} meets what is proved infeasible"),
        }
    }
}

#[test]
fn evolution_comes_near_the_optimum_and_repeats_itself() {
    for objective in OBJECTIVES {
        let DesignOutcome::Found(optimum) = design(&paper(), objective).unwrap() else { panic!("feasible") };
        let ratios = (0..8)
            .map(|seed| evolve(&paper(), objective, seed, 5000).unwrap().best.unwrap().value / optimum.value);
        let ratios: Vec<f64> = ratios.collect();
        // Many runs end beside the optimum (mass: 0.2 % above it, inertia up to 2 %), the best of a few seeds meets it.
        assert!(ratios.iter().all(|ratio| (1.0 - 1e-6..1.03).contains(ratio)), "{objective:?}: {ratios:?}");
        assert!(ratios.iter().any(|ratio| *ratio < 1.0 + 1e-4), "{objective:?}: {ratios:?}");
    }
    let mass = |seed| evolve(&paper(), Objective::Mass, seed, 500).unwrap();
    assert_eq!(mass(7), mass(7));
    assert_ne!(mass(7).best.unwrap().design, mass(8).best.unwrap().design);
}

#[test]
fn what_is_out_of_reach_is_no_design() {
    let limits = DesignLimits { swept_radius: Some(0.045), ..DesignLimits::default() };
    let evolution = evolve(&DesignTask { limits, ..paper() }, Objective::Mass, 1, 1000).unwrap();
    assert!(evolution.best.is_none() && evolution.feasible == 0);
    let none = evolve(&paper(), Objective::Mass, 1, 0).unwrap_err().to_string();
    assert!(none.starts_with("evaluations of an evolutionary search must be one or more"), "{none}");
    assert!(evolve(&DesignTask { density: 1.0, ..paper() }, Objective::Mass, 1, 10).is_err());
    // Fewer evaluations than a generation has designs.
    assert_eq!(evolve(&paper(), Objective::Mass, 1, 5).unwrap().evaluations, 5);
}
