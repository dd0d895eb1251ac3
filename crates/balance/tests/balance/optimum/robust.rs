//! Optima over samples of an engine: against the ordinary optimum, brute force and random changes.

use crate::optimum::support::*;
use lanchester_balance::{
    BalanceError, RobustAnswer, RobustMeasure, RobustRequest, as_it_stands, fitted, optimise,
    optimise_robust, optimise_robust_while,
};
use lanchester_model::*;
use lanchester_task::*;

const FORCE: Criterion = Criterion::Peak(Load::Force);

/// Engines whose pistons and throws differ from the nominal one, by a fixed rule.
fn samples(engine: &Engine, from: u32, to: u32) -> Vec<Engine> {
    (from..to)
        .map(|k| {
            let mut one = engine.clone();
            let wave = |factor: f64, part: usize| ((f64::from(k) + 0.37) * factor + part as f64 * 2.3).sin();
            one = one
                .with(|one| {
                    for (part, cylinder) in one.cylinders.iter_mut().enumerate() {
                        cylinder.piston_mass *= 1.0 + 0.04 * wave(1.7, part);
                        cylinder.rod.big_end_mass *= 1.0 + 0.06 * wave(2.9, part);
                    }

                    for (part, throw) in one.throws.iter_mut().enumerate() {
                        throw.unbalance *= 1.0 + 0.05 * wave(0.71, part);
                        throw.angle += 0.01 * wave(3.3, part);
                    }
                })
                .expect("an engine");
            one
        })
        .collect()
}

fn twin() -> (Engine, BalanceTask) {
    let weights = vec![on_crank("front", -0.06), on_crank("rear", 0.05)];
    let task = BalanceTask { weights, stages: vec![stage(Load::Force)], ..Default::default() };
    (stripped("twin-360"), task)
}

fn solved(engine: &Engine, task: &BalanceTask, samples: &[Engine], measure: RobustMeasure) -> RobustAnswer {
    let request = RobustRequest { samples, second: &[], measure, seed: 1 };
    let answer = optimise_robust(engine, task, &request).expect("a valid task");
    let gap = answer.value - answer.lower_bound;
    assert!(gap >= 0.0 && gap <= 1e-5 * answer.value, "{gap} of {}", answer.value);
    assert!(answer.value <= answer.ordinary * (1.0 + 1e-9), "{answer:#?}");
    assert!(answer.nominal >= answer.ordinary_nominal * (1.0 - 1e-8));
    answer
}

/// The peaks of all samples with the weights of an answer, by the loads of each engine with them fitted.
fn peaks(answer: &RobustAnswer, samples: &[Engine]) -> Vec<f64> {
    let mut peaks: Vec<f64> = samples
        .iter()
        .map(|one| as_it_stands(&fitted(one, &answer.answer), answer.criterion).expect("a load"))
        .collect();
    peaks.sort_by(|a, b| b.total_cmp(a));
    peaks
}

#[test]
fn one_sample_is_the_ordinary_optimum() {
    for (name, load) in
        [("twin-360", Load::Force), ("in-line-3", Load::Couple), ("in-line-3", Load::LargestMainLoad)]
    {
        let engine = stripped(name);
        let weights = vec![on_crank("front", -0.06), on_crank("rear", 0.05)];
        let task = BalanceTask { weights, stages: vec![stage(load)], ..Default::default() };
        let one = samples(&engine, 3, 4);
        let want = optimise(&one[0], &task).unwrap().stages[0].value;
        for measure in [RobustMeasure::Worst, RobustMeasure::MeanOfWorst(0.5)] {
            let answer = solved(&engine, &task, &one, measure);
            assert!((answer.value - want).abs() < 1e-6 * want, "{name}: {} {want}", answer.value);
        }
    }
}

#[test]
fn the_measure_is_that_of_the_engines_with_the_weights_fitted() {
    let (engine, task) = twin();
    let all = samples(&engine, 0, 40);
    for (measure, averaged) in [(RobustMeasure::Worst, 1), (RobustMeasure::MeanOfWorst(0.1), 4)] {
        let answer = solved(&engine, &task, &all, measure);
        assert_eq!((answer.samples, answer.averaged), (40, averaged));
        let peaks = peaks(&answer, &all);
        let mean = peaks[..averaged].iter().sum::<f64>() / averaged as f64;
        assert!((answer.value - mean).abs() < 1e-7 * mean, "{} {mean}", answer.value);
        // It is worth it: the ordinary optimum has more of it, and no sample alone allows so little.
        assert!(answer.value < answer.ordinary * (1.0 - 1e-4), "{} {}", answer.value, answer.ordinary);
        let alone = all.iter().map(|one| optimise(one, &task).unwrap().stages[0].value).fold(0.0, f64::max);
        assert!(averaged > 1 || answer.value >= alone * (1.0 - 1e-7), "{} {alone}", answer.value);
        // Random changes of the weights are no better.
        for k in 0..60 {
            let mut other = answer.clone();
            let turn = f64::from(k) * 2.399;
            let size = 10f64.powi(-2 - k % 4) * answer.answer.weights[0].unbalance.norm();
            for (weight, share) in other.answer.weights.iter_mut().zip([0.7, -0.3 + 0.02 * f64::from(k)]) {
                weight.unbalance += share * num_complex::Complex64::from_polar(size, turn);
            }
            let changed = self::peaks(&other, &all);
            let changed = changed[..averaged].iter().sum::<f64>() / averaged as f64;
            assert!(changed >= answer.value * (1.0 - 1e-5), "{k}: {changed} {}", answer.value);
        }
    }
    // A larger share of the worst is less bad.
    let value = |share: f64| solved(&engine, &task, &all, RobustMeasure::MeanOfWorst(share)).value;
    let (few, half, whole) = (value(0.05), value(0.5), value(1.0));
    assert!(few > half && half > whole, "{few} {half} {whole}");
}

/// One weight along one line: a fine search over its amount.
#[test]
fn one_amount_by_brute_force() {
    let engine = stripped("single");
    let direction = engine.throws[0].angle + std::f64::consts::PI;
    let weight = FreeWeight { phase: Phase::Direction(direction), ..on_crank("crank", 0.0) };
    let task = BalanceTask { weights: vec![weight], stages: vec![stage(Load::Force)], ..Default::default() };
    let all = samples(&engine, 0, 30);
    for (measure, averaged) in [(RobustMeasure::Worst, 1), (RobustMeasure::MeanOfWorst(0.2), 6)] {
        let answer = solved(&engine, &task, &all, measure);
        let found = answer.answer.weights[0].unbalance.norm();
        let at = |amount: f64| {
            let mut other = answer.clone();
            other.answer.weights[0].unbalance *= amount / found;
            let peaks = peaks(&other, &all);
            peaks[..averaged].iter().sum::<f64>() / averaged as f64
        };
        let (mut low, mut high) = (0.2 * found, 3.0 * found);
        for _ in 0..60 {
            let (a, b) = (low + (high - low) * 0.382, low + (high - low) * 0.618);
            if at(a) < at(b) { high = b } else { low = a }
        }
        let least = at(0.5 * (low + high));
        assert!((answer.value - least).abs() < 1e-6 * least, "{} {least}", answer.value);
    }
}

#[test]
fn errors_of_sampling_are_told() {
    let (engine, task) = twin();
    let (all, second) = (samples(&engine, 0, 60), samples(&engine, 1000, 1060));
    let measure = RobustMeasure::MeanOfWorst(0.1);
    let request = RobustRequest { samples: &all, second: &second, measure, seed: 5 };
    let answer = optimise_robust(&engine, &task, &request).unwrap();
    assert!(answer.standard_error > 0.0 && answer.standard_error < 0.1 * answer.value, "{answer:#?}");
    let told = answer.second_value.expect("there is a second set");
    let of_second = peaks(&answer, &second)[..6].iter().sum::<f64>() / 6.0;
    assert!((told - of_second).abs() < 1e-7 * told && answer.second_samples == 60);
    // The same seed draws the same error.
    assert_eq!(optimise_robust(&engine, &task, &request).unwrap().standard_error, answer.standard_error);
}

/// A search over drawn engines can be cancelled between any two of its steps; one that is not is the same as without the question.
#[test]
fn it_stops_where_it_is_told_to() {
    use std::cell::Cell;
    let (engine, task) = twin();
    let all = samples(&engine, 0, 30);
    let request = RobustRequest { samples: &all, second: &[], measure: RobustMeasure::Worst, seed: 1 };
    let asked = Cell::new(0);
    let until = |most: usize| {
        asked.set(0);
        let goes_on = || {
            asked.set(asked.get() + 1);
            asked.get() <= most
        };
        optimise_robust_while(&engine, &task, &request, &goes_on)
    };
    let whole = until(usize::MAX).expect("nobody stops it");
    assert_eq!(whole, optimise_robust(&engine, &task, &request).unwrap());
    let questions = asked.get();
    assert!(questions > 30, "{questions}");
    for most in [0, 1, 29, 30, questions - 1] {
        assert_eq!(
            until(most).expect_err("it is stopped"),
            BalanceError::BrokenOff,
            "after {most} questions"
        );
        assert!(asked.get() <= most + 3, "it goes on for {} more", asked.get() - most);
    }
}

/// A limit holds for the engine as it is meant: the optimum is the best of those weights that hold it, by brute force along a line.
#[test]
fn a_limit_holds_for_the_engine_as_it_is_meant() {
    let (engine, free) = twin();
    let all = samples(&engine, 0, 30);
    let couple = Criterion::Peak(Load::Couple);
    let loose = solved(&engine, &free, &all, RobustMeasure::Worst);
    let has = |answer: &RobustAnswer| as_it_stands(&fitted(&engine, &answer.answer), couple).unwrap();
    let own = has(&loose);
    let least =
        optimise(&engine, &BalanceTask { stages: vec![stage(Load::Couple)], ..free.clone() }).unwrap();
    let most = 0.5 * (own + least.stages[0].value);
    assert!(most < 0.999 * own, "{own} {most}");
    let limits = vec![Limit { criterion: couple, most }];
    let task = BalanceTask { limits, ..free.clone() };
    for measure in [RobustMeasure::Worst, RobustMeasure::MeanOfWorst(0.2)] {
        let held = solved(&engine, &task, &all, measure);
        assert!(has(&held) <= most * (1.0 + 1e-7), "{} {most}", has(&held));
        let unlimited = solved(&engine, &free, &all, measure);
        assert!(held.value >= unlimited.value * (1.0 - 1e-7));
        let told = held.limits[0];
        let couples: Vec<f64> =
            all.iter().map(|one| as_it_stands(&fitted(one, &held.answer), couple).unwrap()).collect();
        let worst = couples.iter().copied().fold(0.0, f64::max);
        assert!((told.worst.unwrap() - worst).abs() < 1e-6 * worst, "{told:?} {worst}");
        assert_eq!(told.beyond, Some(couples.iter().filter(|one| **one > most * (1.0 + 1e-6)).count()));
        // Random changes that hold the limit are no better.
        let averaged = held.averaged;
        let mut tried = 0;
        for k in 0..200 {
            let mut other = held.clone();
            let turn = f64::from(k) * 2.399;
            let size = 10f64.powi(-1 - k % 4) * held.answer.weights[0].unbalance.norm();
            for (weight, share) in other.answer.weights.iter_mut().zip([0.7, -0.3 + 0.01 * f64::from(k)]) {
                weight.unbalance += share * num_complex::Complex64::from_polar(size, turn);
            }
            if has(&other) <= most {
                tried += 1;
                let changed = peaks(&other, &all)[..averaged].iter().sum::<f64>() / averaged as f64;
                assert!(changed >= held.value * (1.0 - 1e-6), "{k}: {changed} {}", held.value);
            }
        }
        assert!(tried > 20, "{tried}");
    }
}

/// What comes behind is minimised on the engine as it is meant, and takes what the measure gives up.
#[test]
fn later_stages_take_what_the_measure_gives_up() {
    let (engine, free) = twin();
    let all = samples(&engine, 0, 30);
    let amount = Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] };
    let answer = |give_up: GiveUp, measure| {
        let stages = vec![stage(Load::Force), amount.clone()];
        let task = BalanceTask { stages, give_up: vec![give_up], ..free.clone() };
        let request = RobustRequest { samples: &all, second: &[], measure, seed: 1 };
        optimise_robust(&engine, &task, &request).expect("a valid task")
    };
    for measure in [RobustMeasure::Worst, RobustMeasure::MeanOfWorst(0.2)] {
        let alone = solved(&engine, &free, &all, measure);
        let mut before = f64::INFINITY;
        for share in [0.0, 0.02, 0.1] {
            let found = answer(GiveUp::Share(share), measure);
            assert!((found.least - alone.value).abs() < 1e-6 * alone.value);
            assert!(
                found.value <= found.least * (1.0 + share + 3e-6),
                "{share}: {} {}",
                found.value,
                found.least
            );
            let own = peaks(&found, &all)[..found.averaged].iter().sum::<f64>() / found.averaged as f64;
            assert!((own - found.value).abs() < 1e-6 * own);
            let later = &found.later[0];
            let nominal: f64 = found.answer.weights.iter().map(|weight| weight.unbalance.norm()).sum();
            assert!((later.value - nominal).abs() < 1e-6 * nominal, "{later:?} {nominal}");
            assert!(later.value - later.lower_bound <= 1e-4 * later.value, "{share}: {later:?}");
            assert!(later.value <= before * (1.0 + 1e-6), "{share}: {later:?} {before}");
            before = later.value;
        }
        // All of what is given up is used where it helps.
        let much = answer(GiveUp::Share(0.1), measure);
        assert!(much.later[0].value < 0.999 * answer(GiveUp::Nothing, measure).later[0].value);
        assert!(much.value > 1.09 * much.least, "{} {}", much.value, much.least);
    }
}

#[test]
fn what_samples_cannot_judge_is_refused() {
    let (engine, task) = twin();
    let all = samples(&engine, 0, 3);
    let refused = |task: &BalanceTask, samples: &[Engine], measure: RobustMeasure| {
        let request = RobustRequest { samples, second: &[], measure, seed: 1 };
        let error = optimise_robust(&engine, task, &request).expect_err("it has no meaning");
        assert!(matches!(error, BalanceError::Unsuited { .. }), "{error}");
    };
    refused(&task, &[], RobustMeasure::Worst);
    refused(&task, &all, RobustMeasure::MeanOfWorst(0.0));
    refused(&task, &all, RobustMeasure::MeanOfWorst(1.5));
    let limits = vec![Limit { criterion: FORCE, most: 1.0 }];
    refused(&BalanceTask { limits, ..task.clone() }, &all, RobustMeasure::Worst);
    refused(&BalanceTask { stages: Vec::new(), ..task.clone() }, &all, RobustMeasure::Worst);
    let mass = Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] };
    refused(&BalanceTask { stages: vec![mass], ..task.clone() }, &all, RobustMeasure::Worst);
    let mut chosen = task;
    chosen.weights[0].least = 0.01;
    refused(&chosen, &all, RobustMeasure::Worst);
}
