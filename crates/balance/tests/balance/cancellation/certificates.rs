//! Proofs recomputed for the engines of the gallery, with weights and shafts drawn at random.

use crate::cancellation::support::*;
use lanchester_balance::*;
use lanchester_file::{Template, templates};
use lanchester_model::*;
use lanchester_task::*;
use num_complex::Complex64;
use proptest::prelude::*;

/// Orders that may be asked for.
const ORDERS: [(Load, f64); 6] = [
    (Load::Force, 1.0),
    (Load::Couple, 1.0),
    (Load::Force, 2.0),
    (Load::Couple, 2.0),
    (Load::RollMoment, 1.0),
    (Load::RollMoment, 2.0),
];

/// A random task for any engine: up to four planes on the crank, up to three shafts with one or two planes.
fn any_task() -> impl Strategy<Value = BalanceTask> {
    let planes = prop::collection::btree_set(-8i32..=8, 0..=4);
    let shaft =
        (prop::sample::select(vec![-2, -1, 1, 2]), -3i32..=3, prop::collection::btree_set(-9i32..=9, 1..=2));
    let orders = prop::sample::subsequence(ORDERS.to_vec(), 1..=4);
    (planes, prop::collection::vec(shaft, 0..=3), orders).prop_map(|(planes, shafts, orders)| {
        let planes: Vec<f64> = planes.into_iter().map(|z| 0.03 * f64::from(z)).collect();
        let mut made = task(on_crank(&planes), &orders);
        for (index, (ratio, y, planes)) in shafts.into_iter().enumerate() {
            let planes: Vec<f64> = planes.into_iter().map(|z| 0.025 * f64::from(z)).collect();
            // No two shafts on one axis: they could not be told apart.
            add_shaft(&mut made, ratio, 0.11 * (index as f64 + 1.0), 0.07 * f64::from(y), &planes);
        }
        made
    })
}

/// A random change of the unbalances that leaves every order of `cancel` where it is: any change, made good by the
/// answer to what it adds.
fn repaired(engine: &Engine, task: &BalanceTask, change: &[Complex64]) -> Option<f64> {
    // The engine with the change fitted; the weights that cancel it then have the names of the free ones.
    let mut carrier = engine.clone().into_parts();
    let mut shafts: Vec<BalanceShaft> = task
        .shafts
        .iter()
        .map(|s| {
            let at = |place: Place| if let Place::At(value) = place { value } else { 0.0 };
            BalanceShaft {
                name: format!("given {}", s.name),
                ratio: s.ratio,
                x: at(s.x),
                y: at(s.y),
                weights: Vec::new(),
                inertia: None,
            }
        })
        .collect();
    for (free, change) in task.weights.iter().zip(change) {
        let Place::At(z) = free.z else { continue };
        let (unbalance, phase) = change.to_polar();
        match free.seat {
            Seat::Crankshaft(crankshaft) => carrier.counterweights.push(Counterweight {
                name: format!("given {}", free.name),
                crankshaft,
                z,
                unbalance,
                angle: phase - engine.crankshafts[crankshaft].phase,
                part: None,
            }),
            Seat::Shaft(shaft) => shafts[shaft].weights.push(ShaftWeight::new(z, unbalance, phase)),
        }
    }
    carrier.shafts.extend(shafts.into_iter().filter(|s| !s.weights.is_empty()));
    let carrier = Engine::new(carrier).expect("an engine");
    let answer = optimise(&carrier, task).ok()?;
    let CancellationVerdict::Vanish { .. } = cancellation(&answer).verdict else { return None };
    // Change and answer together cancel the orders of the engine.
    Some(answer.weights.iter().zip(change).map(|(w, c)| (w.unbalance + c).norm()).sum())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn prop_every_answer_proves_itself(
        which in any::<prop::sample::Index>(),
        task in any_task(),
    ) {
        let all: Vec<&Template> = templates().iter().collect();
        let name = all[which.index(all.len())].name;
        let engine = stripped(name);
        if task.weights.is_empty() {
            return Ok(());
        }
        let answer = optimise(&engine, &task).unwrap();
        match &cancellation(&answer).verdict {
            CancellationVerdict::Vanish { .. } => {
                assert_vanishes(&engine, &answer);
            }
            CancellationVerdict::CannotVanish { .. } => {
                assert_cannot(&engine, &answer);
                // What cannot vanish together leaves something; what can vanish alone may.
                let natural = all_masses(&engine);
                let stays = |o: &CancelledOrder| o.left > 1e-12 * natural * lever(&engine).min(1.0);
                prop_assert!(cancellation(&answer).orders.iter().any(stays), "{name}: {answer:#?}");
            }
        }
        for order in &cancellation(&answer).orders {
            prop_assert!(order.least_alone <= order.left * (1.0 + 1e-7) + 1e-9 * all_masses(&engine), "{order:?}");
        }
    }

    #[test]
    fn prop_nothing_lighter_among_random_changes(
        which in any::<prop::sample::Index>(),
        parts in prop::collection::vec((-1.0f64..1.0, -1.0f64..1.0), 6),
        size in -4i32..=0,
    ) {
        let names = ["in-line-3", "single", "v6-90", "twin-360", "boxer-2"];
        let engine = stripped(names[which.index(names.len())]);
        let mut task = task(on_crank(&[-0.09, -0.02, 0.05]), &[(Load::Force, 1.0), (Load::Couple, 1.0)]);
        add_shaft(&mut task, -1, 0.0, 0.1, &[-0.12, 0.0, 0.15]);
        let best = assert_vanishes(&engine, &optimise(&engine, &task).unwrap());
        let natural = all_masses(&engine) / engine.speed.highest.powi(2) * 10f64.powi(size);
        let change: Vec<Complex64> = parts.iter().map(|(x, y)| natural * Complex64::new(*x, *y)).collect();
        let other = repaired(&engine, &task, &change).expect("three planes a side cancel force and couple");
        prop_assert!(other >= best * (1.0 - 1e-9), "{other} below {best}");
    }
}
