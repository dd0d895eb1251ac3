//! Weights of which there are steps and lists only, against all of them one by one.

use crate::optimum::support::*;
use lanchester_balance::{Answer, BalanceError, Method, Outcome, optimise, optimise_watched};
use lanchester_balance::{BalanceSettings, Next, StopCause};
use lanchester_model::*;
use lanchester_task::*;

fn solved(engine: &Engine, task: &BalanceTask) -> Answer {
    let answer = optimise(engine, task).expect("a valid task");
    assert_eq!(answer.outcome, Outcome::Optimal, "{answer:#?}");
    answer
}

/// Weights opposite to the throws of a three, with catalogues.
fn three(catalogue: &[Catalogue], stages: &[Load]) -> (Engine, BalanceTask) {
    let engine = stripped("in-line-3");
    let weights = engine
        .throws
        .iter()
        .zip(catalogue)
        .enumerate()
        .map(|(k, (throw, catalogue))| FreeWeight {
            phase: Phase::Direction(throw.angle + std::f64::consts::PI),
            catalogue: Some(catalogue.clone()),
            most: Some(0.02),
            ..on_crank(&format!("w{k}"), throw.z - 0.01 * k as f64)
        })
        .collect();
    let stages = stages.iter().map(|load| stage(*load)).collect();
    (engine, BalanceTask { weights, stages, ..Default::default() })
}

/// The least of the first stage over all combinations of amounts, each in its given direction, by given amounts alone.
fn enumerated(engine: &Engine, task: &BalanceTask, allowed: impl Fn(&[f64]) -> bool) -> (f64, Vec<f64>) {
    let list = |weight: &FreeWeight| -> Vec<f64> {
        let catalogue = weight.catalogue.as_ref().expect("every weight has one");
        let most = weight.most.expect("every weight has one");
        (0..).map(|k| catalogue.amount(k)).take_while(|a| *a <= most * (1.0 + 1e-12)).collect()
    };
    let lists: Vec<Vec<f64>> = task.weights.iter().map(list).collect();
    let count: usize = lists.iter().map(Vec::len).product();
    let mut best = (f64::INFINITY, Vec::new());
    for number in 0..count {
        let mut rest = number;
        let amounts: Vec<f64> = lists
            .iter()
            .map(|list| {
                let own = list[rest % list.len()];
                rest /= list.len();
                own
            })
            .collect();
        if !allowed(&amounts) {
            continue;
        }
        let mut engine = engine.clone();
        for (weight, amount) in task.weights.iter().zip(&amounts) {
            let (Place::At(z), Phase::Direction(phase)) = (weight.z, weight.phase) else {
                panic!("{weight:?}")
            };
            engine = engine
                .with(|engine| {
                    engine.counterweights.push(Counterweight {
                        name: weight.name.clone(),
                        crankshaft: 0,
                        z,
                        unbalance: *amount,
                        angle: phase - engine.crankshafts[0].phase,
                        part: None,
                    });
                })
                .expect("an engine");
        }
        let value = lanchester_balance::as_it_stands(&engine, task.stages[0].terms[0].1).expect("a load");
        if value < best.0 {
            best = (value, amounts);
        }
    }
    best
}

fn amounts(answer: &Answer) -> Vec<f64> {
    answer.weights.iter().map(|w| w.unbalance.norm()).collect()
}

fn assert_same(answer: &Answer, (value, want): &(f64, Vec<f64>)) {
    let stage = &answer.stages[0];
    assert!(
        (stage.value - value).abs() <= 1e-8 * value,
        "{} {value} {want:?} {:?}",
        stage.value,
        amounts(answer)
    );
    assert!(stage.lower_bound <= value * (1.0 + 1e-9) && stage.gap <= 1e-7 * value, "{stage:#?}");
}

#[test]
fn steps_are_the_best_of_all_steps() {
    let steps = |step: f64| vec![Catalogue::Steps(step); 3];
    for (catalogue, load) in
        [(steps(0.003), Load::Couple), (steps(0.0045), Load::Force), (steps(0.0021), Load::LargestMainLoad)]
    {
        let (engine, task) = three(&catalogue, &[load]);
        let answer = solved(&engine, &task);
        assert_same(&answer, &enumerated(&engine, &task, |_| true));
        // Amounts are whole steps, to the last digit.
        for (amount, catalogue) in amounts(&answer).iter().zip(&catalogue) {
            let Catalogue::Steps(step) = catalogue else { unreachable!() };
            assert!((amount / step - (amount / step).round()).abs() < 1e-12, "{amount} {step}");
        }
        assert!(matches!(answer.method, Method::BranchAndBound { .. }));
        // Whole steps are no better than any amount.
        let mut any = task.clone();
        any.weights.iter_mut().for_each(|weight| weight.catalogue = None);
        assert!(solved(&engine, &any).stages[0].value <= answer.stages[0].value * (1.0 + 1e-9));
    }
}

#[test]
fn lists_are_the_best_of_all_lists_and_may_be_left_out() {
    let list = |amounts: &[f64]| Catalogue::Amounts(amounts.to_vec());
    let catalogue =
        [list(&[0.0031, 0.0122, 0.0171]), list(&[0.0008, 0.012]), list(&[0.002, 0.0047, 0.0095, 0.0199])];
    for load in [Load::Couple, Load::Force, Load::BendingMoment] {
        let (engine, task) = three(&catalogue, &[load]);
        let answer = solved(&engine, &task);
        assert_same(&answer, &enumerated(&engine, &task, |_| true));
    }
    // The list ends what may be chosen.
    let (engine, mut task) = three(&catalogue, &[Load::Couple]);
    task.weights.iter_mut().for_each(|weight| weight.most = None);
    let open = solved(&engine, &task);
    let (_, bounded) = three(&catalogue, &[Load::Couple]);
    assert!(
        (open.stages[0].value - solved(&engine, &bounded).stages[0].value).abs()
            < 1e-8 * open.stages[0].value
    );
}

#[test]
fn equal_parts_are_equal() {
    let (engine, mut task) = three(&vec![Catalogue::Steps(0.0013); 3], &[Load::Couple]);
    for weight in [0, 2] {
        task.weights[weight].equal_parts = Some("ends".into());
    }
    let answer = solved(&engine, &task);
    let found = amounts(&answer);
    assert!((found[0] - found[2]).abs() < 1e-15 && found[0] > 0.0, "{found:?}");
    assert_same(&answer, &enumerated(&engine, &task, |amounts| amounts[0] == amounts[2]));
    let mut free = task.clone();
    free.weights.iter_mut().for_each(|weight| weight.equal_parts = None);
    assert!(solved(&engine, &free).stages[0].value <= answer.stages[0].value * (1.0 + 1e-9));
}

/// Any direction: a grid of directions of the one amount that is allowed is no better.
#[test]
fn directions_are_found_with_the_amounts() {
    let engine = stripped("in-line-3");
    let list = Catalogue::Amounts(vec![0.002, 0.005]);
    let free = FreeWeight { catalogue: Some(list.clone()), ..on_crank("a", 0.05) };
    let task =
        BalanceTask { weights: vec![free.clone()], stages: vec![stage(Load::Couple)], ..Default::default() };
    let answer = solved(&engine, &task);
    let mut least = f64::INFINITY;
    for k in 0..720 {
        let phase = Phase::Direction(f64::from(k).to_radians() / 2.0);
        let one = FreeWeight { phase, ..free.clone() };
        let one = BalanceTask { weights: vec![one], ..task.clone() };
        least = least.min(
            enumerated(
                &engine,
                &BalanceTask {
                    weights: vec![FreeWeight { most: Some(0.005), ..one.weights[0].clone() }],
                    ..one
                },
                |_| true,
            )
            .0,
        );
    }
    let value = answer.stages[0].value;
    assert!(value <= least * (1.0 + 1e-9) && value > least * (1.0 - 1e-3), "{value} {least}");
    let found = amounts(&answer)[0];
    assert!([0.0, 0.002, 0.005].iter().any(|amount| (found - amount).abs() < 1e-14), "{found}");
}

#[test]
fn optional_weights_and_limits_go_with_catalogues() {
    let (engine, mut task) = three(&vec![Catalogue::Steps(0.002); 3], &[Load::Couple]);
    task.weights.iter_mut().for_each(|weight| weight.optional = true);
    task.most_optional = Some(2);
    let answer = solved(&engine, &task);
    let used = |amounts: &[f64]| amounts.iter().filter(|a| **a > 0.0).count();
    assert!(used(&amounts(&answer)) <= 2);
    assert_same(&answer, &enumerated(&engine, &task, |amounts| used(amounts) <= 2));
    // Least amounts leave the first steps out.
    let (engine, mut task) = three(&vec![Catalogue::Steps(0.002); 3], &[Load::Force]);
    task.weights.iter_mut().for_each(|weight| weight.least = 0.0035);
    let answer = solved(&engine, &task);
    assert_same(&answer, &enumerated(&engine, &task, |amounts| amounts.iter().all(|a| *a >= 0.0039)));
    // A limit on the mass of all.
    let (engine, mut task) = three(&vec![Catalogue::Steps(0.002); 3], &[Load::Couple]);
    task.limits = vec![Limit { criterion: Criterion::AddedUnbalance, most: 0.0145 }];
    let answer = solved(&engine, &task);
    assert_same(&answer, &enumerated(&engine, &task, |amounts| amounts.iter().sum::<f64>() <= 0.0145));
}

#[test]
fn a_search_that_stops_tells_an_honest_gap() {
    let (engine, task) = three(&vec![Catalogue::Steps(0.0003); 3], &[Load::Couple]);
    let settings = BalanceSettings { max_nodes: 3, ..BalanceSettings::default() };
    let stopped = optimise_watched(&engine, &task, None, &settings, &|_| Next::Continue).unwrap();
    let whole = solved(&engine, &task);
    let (part, all) = (&stopped.stages[0], &whole.stages[0]);
    assert!(
        part.lower_bound <= all.value * (1.0 + 1e-9) && part.value >= all.value * (1.0 - 1e-9),
        "{part:#?} {all:#?}"
    );
    if part.gap > 1e-7 * part.value {
        assert!(
            matches!(stopped.outcome, Outcome::Stopped { cause: StopCause::MaxNodes, .. }),
            "{stopped:#?}"
        );
    }
}

#[test]
fn later_stages_keep_the_steps() {
    let (engine, task) = three(&vec![Catalogue::Steps(0.0025); 3], &[Load::Force, Load::Couple]);
    let answer = solved(&engine, &task);
    let (least, _) = enumerated(&engine, &task, |_| true);
    assert!((answer.stages[0].value - least).abs() < 1e-8 * least);
    // Equal weights at all throws leave the force as it is: of those the couple decides.
    let mut best = f64::INFINITY;
    let second = BalanceTask { stages: vec![task.stages[1].clone()], ..task.clone() };
    for number in 0..9usize.pow(3) {
        let want = [number % 9, number / 9 % 9, number / 81].map(|k| 0.0025 * k as f64);
        let of = |stage: usize| {
            let task = BalanceTask { stages: vec![task.stages[stage].clone()], ..task.clone() };
            enumerated_one(&engine, &task, &want)
        };
        if of(0) <= least * (1.0 + 1e-8) {
            best = best.min(of(1));
        }
    }
    assert!(
        (answer.stages[1].value - best).abs() < 1e-7 * best,
        "{} {best} {second:?}",
        answer.stages[1].value
    );
}

fn enumerated_one(engine: &Engine, task: &BalanceTask, amounts: &[f64]) -> f64 {
    let mut engine = engine.clone();
    for (weight, amount) in task.weights.iter().zip(amounts) {
        let (Place::At(z), Phase::Direction(phase)) = (weight.z, weight.phase) else { panic!("{weight:?}") };
        engine = engine
            .with(|engine| {
                engine.counterweights.push(Counterweight {
                    name: weight.name.clone(),
                    crankshaft: 0,
                    z,
                    unbalance: *amount,
                    angle: phase - engine.crankshafts[0].phase,
                    part: None,
                });
            })
            .expect("an engine");
    }
    lanchester_balance::as_it_stands(&engine, task.stages[0].terms[0].1).expect("a load")
}

#[test]
fn what_is_no_catalogue_is_refused() {
    let refused = |change: &dyn Fn(&mut FreeWeight)| {
        let (engine, mut task) = three(&vec![Catalogue::Steps(0.002); 3], &[Load::Couple]);
        change(&mut task.weights[0]);
        optimise(&engine, &task).expect_err("it has no meaning")
    };
    for catalogue in [Catalogue::Steps(0.0), Catalogue::Steps(f64::NAN), Catalogue::Amounts(vec![-1.0])] {
        let error = refused(&|w| w.catalogue = Some(catalogue.clone()));
        assert!(matches!(error, BalanceError::Number { .. }), "{error}");
    }
    for change in [
        &(|w: &mut FreeWeight| w.catalogue = Some(Catalogue::Amounts(Vec::new())))
            as &dyn Fn(&mut FreeWeight),
        &|w| w.catalogue = Some(Catalogue::Amounts(vec![0.002, 0.001])),
        &|w| (w.least, w.most) = (0.0021, Some(0.0039)),
        &|w| (w.catalogue, w.equal_parts) = (None, Some("a".into())),
    ] {
        let error = refused(change);
        assert!(matches!(error, BalanceError::Unsuited { .. }), "{error}");
    }
}

/// Holes towards the axis in a counterweight of steel, or slugs of heavy metal in them.
fn drills(slug_density: Option<f64>) -> DrillCatalogue {
    DrillCatalogue {
        direction: workshop::DrillDirection::Radial,
        surface: workshop::Surface::Round,
        radius: 0.07,
        diameters: vec![0.012, 0.016, 0.02],
        max_depth: 0.03,
        depth_step: 0.006,
        point: 118_f64.to_radians(),
        density: 7850.0,
        slug_density,
    }
}

/// The best of all holes and slugs, by given amounts alone; the answer names drill and depth of each.
#[test]
fn drilled_weights_are_the_best_of_all_holes() {
    for load in [Load::Couple, Load::BendingMoment] {
        let (engine, mut task) = three(&vec![Catalogue::Steps(1.0); 3], &[load]);
        let slugs = [None, Some(18_000.0), Some(18_000.0)];
        for (weight, slug) in task.weights.iter_mut().zip(slugs) {
            let own = FreeWeight { most: None, ..weight.clone() };
            *weight = own.drilled(drills(slug));
        }
        let answer = solved(&engine, &task);
        assert_same(&answer, &enumerated(&engine, &task, |_| true));
        assert!(answer.weights.iter().any(|weight| weight.used));
        for (weight, slug) in answer.weights.iter().zip(slugs) {
            let Some(hole) = weight.hole else {
                assert!(!weight.used, "{weight:?}");
                continue;
            };
            assert_eq!((hole.unbalance - weight.unbalance.norm()).abs() < 1e-12, weight.used, "{weight:?}");
            assert_eq!(hole.slug_density, slug);
            assert!(hole.tip <= 0.03 + 1e-12 && drills(slug).holes().contains(&hole), "{hole:?}");
        }
    }
    // A catalogue that is not that of the holes is refused.
    let (engine, mut task) = three(&vec![Catalogue::Steps(0.001); 3], &[Load::Couple]);
    task.weights[0].drill = Some(drills(None));
    assert!(matches!(optimise(&engine, &task), Err(BalanceError::Unsuited { .. })));
}
