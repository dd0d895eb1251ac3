//! Random tasks: the answer keeps to what is allowed, its values are those of the fitted engine, and nothing that is
//! allowed goes below its bounds.

use crate::optimum::support::*;
use lanchester_balance::{Answer, Outcome, fitted, optimise};
use lanchester_model::*;
use lanchester_task::*;
use proptest::prelude::*;
use std::f64::consts::TAU;

/// What may be done with one weight, as numbers between 0 and 1.
#[derive(Debug, Clone)]
struct Draft {
    z: f64,
    stretch: Option<f64>,
    least: Option<f64>,
    given: bool,
    optional: bool,
    line: Option<f64>,
}

fn draft() -> impl Strategy<Value = Draft> {
    let share = || 0.0..1.0f64;
    (
        share(),
        proptest::option::of(0.05..1.0f64),
        proptest::option::of(share()),
        proptest::bool::weighted(0.2),
        any::<bool>(),
        proptest::option::weighted(0.3, share()),
    )
        .prop_map(|(z, stretch, least, given, optional, line)| Draft {
            z,
            stretch,
            least,
            given,
            optional,
            line,
        })
}

const ENGINES: [&str; 5] = ["single", "twin-270", "in-line-3", "v4-90", "v6-60"];

fn weights(engine: &Engine, drafts: &[Draft]) -> Vec<FreeWeight> {
    let scale = all_masses(engine) / engine.speed.highest.powi(2);
    let most = 0.3 * scale;
    drafts
        .iter()
        .enumerate()
        .map(|(k, draft)| {
            let low = 0.3 * draft.z - 0.15;
            FreeWeight {
                z: draft.stretch.map_or(Place::At(low), |s| Place::Between(low, low + 0.2 * s)),
                least: draft.least.map_or(0.0, |l| if draft.given { most } else { l * most }),
                most: Some(most),
                phase: draft.line.map_or(Phase::Free, |l| Phase::Line(TAU * l)),
                optional: draft.optional,
                ..on_crank(&format!("weight {k}"), 0.0)
            }
        })
        .collect()
}

/// A choice of everything that is not convex, from numbers between 0 and 1; `None` where too many are used.
fn choice(task: &BalanceTask, random: &mut impl FnMut() -> f64) -> Option<BalanceTask> {
    let mut chosen = BalanceTask { most_optional: None, ..task.clone() };
    let mut used = 0;
    chosen.weights.retain_mut(|weight| {
        if let Place::Between(low, high) = weight.z {
            weight.z = Place::At(low + (high - low) * random());
        }
        let angle = TAU * random();
        weight.phase = match weight.phase {
            Phase::Line(own) if weight.least > 0.0 => {
                Phase::Direction(if angle < 3.0 { own } else { own + TAU / 2.0 })
            }
            Phase::Free if weight.least > 0.0 => Phase::Direction(angle),
            phase => phase,
        };
        let keep = !weight.optional || random() < 0.5;
        used += usize::from(weight.optional && keep);
        weight.optional = false;
        keep
    });
    (used <= task.most_optional.unwrap_or(usize::MAX)).then_some(chosen)
}

fn is_allowed(task: &BalanceTask, answer: &Answer) -> Result<(), String> {
    let mut used = 0;
    for (free, found) in task.weights.iter().zip(&answer.weights) {
        let amount = found.unbalance.norm();
        if free.optional {
            used += usize::from(found.used);
            if !found.used {
                continue;
            }
        }
        let most = free.most.unwrap_or(f64::INFINITY);
        if amount < free.least * (1.0 - 1e-9) || amount > most * (1.0 + 1e-9) {
            return Err(format!("amount {amount} outside {} .. {most}", free.least));
        }
        let inside = match free.z {
            Place::At(z) => found.z == z,
            Place::Between(low, high) => (low..=high).contains(&found.z),
        };
        if !inside {
            return Err(format!("{} outside {:?}", found.z, free.z));
        }
        if let Phase::Line(angle) = free.phase
            && (found.unbalance.arg() - angle).sin().abs() * amount > 1e-9 * most
        {
            return Err(format!("{found:?} off its line"));
        }
    }
    if used > task.most_optional.unwrap_or(usize::MAX) {
        return Err(format!("{used} used"));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn prop_nothing_allowed_goes_below_the_bound(
        name in proptest::sample::select(&ENGINES[..]),
        drafts in proptest::collection::vec(draft(), 1..4),
        most_optional in proptest::option::of(0usize..3),
        lever in 0.02..0.5f64,
        seed in any::<u64>(),
    ) {
        let engine = stripped(name);
        let task = BalanceTask {
            weights: weights(&engine, &drafts),
            stages: vec![Stage {
                terms: vec![(lever, Criterion::Peak(Load::Force)), (1.0, Criterion::Peak(Load::Couple))],
            }],
            most_optional,
            ..Default::default()
        };
        let answer = optimise(&engine, &task).unwrap();
        prop_assert_eq!(&answer.outcome, &Outcome::Optimal, "{:?}", answer.method);
        assert_proved(&engine, &answer);
        is_allowed(&task, &answer).map_err(TestCaseError::fail)?;
        let fit = fitted(&engine, &answer);
        let (value, bound) = (answer.stages[0].value, answer.stages[0].lower_bound);
        let scale = all_masses(&engine);
        let seen = lever * grid_peak(&fit, 0, 720) + grid_peak(&fit, 1, 720);
        prop_assert!(seen <= value + 1e-9 * scale && seen >= value - 1e-3 * scale, "{} {}", seen, value);
        let mut state = seed | 1;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for _ in 0..8 {
            let Some(chosen) = choice(&task, &mut random) else { continue };
            let other = optimise(&engine, &chosen).unwrap();
            let other = other.stages[0].value;
            prop_assert!(other >= bound - 1e-10 * scale, "{} below {}", other, bound);
            prop_assert!(other >= value - 1e-8 * value.max(1e-6 * scale), "{} better than {}", other, value);
        }
    }
}
