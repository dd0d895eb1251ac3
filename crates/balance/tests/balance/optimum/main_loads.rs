//! Loads of main bearings: as criterion, as limit, and as what counterweights are kept for.

use crate::optimum::support::{engine, stage};
use lanchester_balance::{Answer, Outcome, as_it_stands, fitted, optimise};
use lanchester_mechanism::{BearingPart, BearingRequest, bearing_loads};
use lanchester_model::Engine;
use lanchester_task::{
    BalanceTask, CrankWeightPlaces, Criterion, Limit, Load, Mains, Stage, crank_weights, default_task,
};

const RMS: Criterion = Criterion::MainRms(Mains::All);
const LARGEST: Criterion = Criterion::Peak(Load::LargestMainLoad);

/// Root mean square over all mains and the cycle, and the largest load of any [N], from the traces of `bearings`.
fn by_quadrature(engine: &Engine, speed: f64) -> (f64, f64) {
    let request = BearingRequest {
        speed: Some(speed),
        part: BearingPart::Inertia,
        samples: 1440,
        ..BearingRequest::default()
    };
    let loads = bearing_loads(engine, None, &request).expect("a valid engine");
    let mean = |squares: &mut dyn Iterator<Item = f64>| {
        let (count, sum) = squares.fold((0, 0.0), |(count, sum), square| (count + 1, sum + square));
        sum / f64::from(count)
    };
    let of_main = |load: &Vec<num_complex::Complex64>| mean(&mut load.iter().map(|force| force.norm_sqr()));
    let rms = mean(&mut loads.mains.iter().map(|main| of_main(&main.load.load))).sqrt();
    (rms, loads.mains.iter().map(|main| main.load.peak.value).fold(0.0, f64::max))
}

fn effect(answer: &Answer, criterion: Criterion) -> [f64; 2] {
    let found = answer.effects.iter().find(|effect| effect.criterion == criterion).expect("it is reported");
    [found.before, found.after]
}

#[test]
fn a_default_answer_keeps_or_improves_bearings_of_a_four_a_six_and_a_v8() {
    for name in ["in-line-4", "in-line-6", "v8-crossplane"] {
        let engine = engine(name);
        assert!(!engine.counterweights.is_empty(), "{name} has counterweights to ruin");
        let task = BalanceTask { stages: Vec::new(), limits: Vec::new(), ..default_task(&engine) };
        let answer = optimise(&engine, &task).unwrap();
        assert_eq!(answer.outcome, Outcome::Optimal, "{name}");
        let after = fitted(&engine, &answer);
        let speed = engine.speed.highest;
        let (old, new) = (by_quadrature(&engine, speed), by_quadrature(&after, speed));
        assert!(new.0 <= old.0, "{name}: rms {} N before, {} N after", old.0, new.0);
        // As a V8's outer webs that are free stand where they stood, to rounding.
        assert!(new.1 <= old.1 * (1.0 + 1e-12), "{name}: largest {} N before, {} N after", old.1, new.1);
        // What the answer says of them is what `bearings` computes.
        for (criterion, told) in [(RMS, [old.0, new.0]), (LARGEST, [old.1, new.1])] {
            for (got, want) in effect(&answer, criterion).into_iter().zip(told) {
                assert!((got - want).abs() <= 1e-6 * want, "{name}: {criterion:?} {got} N, traces {want} N");
            }
        }
        for criterion in [Load::Force, Load::Couple].map(Criterion::Peak) {
            let [before, after] = effect(&answer, criterion);
            assert!(after <= before + 1e-6 * before.max(1.0), "{name}: {criterion:?} {before} -> {after}");
        }
    }
}

#[test]
fn bearings_decide_before_lightness_where_stages_name_neither() {
    let engine = engine("in-line-4");
    let named = BalanceTask { stages: vec![stage(Load::Force)], limits: Vec::new(), ..default_task(&engine) };
    let answer = optimise(&engine, &named).unwrap();
    assert!(answer.among_equals.iter().any(|stage| stage.terms[0].0 == RMS));
    let [before, after] = effect(&answer, RMS);
    assert!(after <= before);
    // Who asks for the least weights gets them where they are asked for.
    let lightest = Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] };
    let light = BalanceTask { stages: vec![stage(Load::Force), stage(Load::Couple), lightest], ..named };
    let answer = optimise(&engine, &light).unwrap();
    assert!(answer.weights.iter().all(|weight| !weight.used), "{:?}", answer.weights);
}

/// The least squares of all mains' coefficients, by plain normal equations of the traces at many angles.
#[test]
fn the_least_root_mean_square_is_that_of_least_squares() {
    for name in ["in-line-3", "in-line-4", "v8-crossplane"] {
        let engine = engine(name);
        let mut bare = engine.clone();
        bare = bare
            .with(|bare| {
                bare.counterweights.clear();
            })
            .unwrap();
        let task = BalanceTask {
            weights: crank_weights(&engine, CrankWeightPlaces::Webs),
            stages: vec![Stage { terms: vec![(1.0, RMS)] }],
            ..BalanceTask::default()
        };
        let answer = optimise(&bare, &task).unwrap();
        let stage = &answer.stages[0];
        assert_eq!(answer.outcome, Outcome::Optimal, "{name}");
        // Web weights of one bay answer its two mains in any way: each main's share that turns forward vanishes.
        let request = BearingRequest { part: BearingPart::Inertia, ..BearingRequest::default() };
        let loads = bearing_loads(&bare, None, &request).unwrap();
        let mut rest = 0.0;
        for main in &loads.mains {
            let count = main.load.load.len() as f64;
            let square: f64 = main.load.load.iter().map(|force| force.norm_sqr()).sum::<f64>() / count;
            let turning =
                |(theta, force): (&f64, &num_complex::Complex64)| force * num_complex::Complex64::cis(-theta);
            let forward: num_complex::Complex64 =
                loads.theta.iter().zip(&main.load.load).map(turning).sum::<num_complex::Complex64>() / count;
            rest += square - forward.norm_sqr();
        }
        let least = (rest / loads.mains.len() as f64).sqrt();
        assert!(
            (stage.value - least).abs() <= 1e-9 * least,
            "{name}: {} N, least squares {least} N",
            stage.value
        );
        assert!(stage.lower_bound <= least * (1.0 + 1e-9));
    }
}

#[test]
fn a_limit_on_one_main_is_held_and_has_a_price() {
    let engine = engine("in-line-4");
    let mut task = BalanceTask { limits: Vec::new(), ..default_task(&engine) };
    for weight in &mut task.weights {
        weight.radius = None;
    }
    task.stages = vec![Stage { terms: vec![(1.0, Criterion::AddedUnbalance)] }];
    let centre = Criterion::Peak(Load::MainLoad(2));
    let most = 0.7
        * optimise(&engine, &task).unwrap().effects.iter().find(|e| e.criterion == LARGEST).unwrap().after;
    let with = |most: f64| {
        let limits = vec![Limit { criterion: centre, most }];
        optimise(&engine, &BalanceTask { limits, ..task.clone() }).unwrap()
    };
    let answer = with(most);
    assert_eq!(answer.outcome, Outcome::Optimal);
    let limit = &answer.limits[0];
    assert!(limit.value <= most * (1.0 + 1e-9) && limit.price > 0.0, "{limit:?}");
    let wider = with(most * 1.001).stages[0].value;
    let slope = (answer.stages[0].value - wider) / (0.001 * most);
    assert!((slope - limit.price).abs() <= 0.01 * limit.price, "{slope} and {}", limit.price);
}

#[test]
fn every_statistic_is_what_the_traces_say() {
    let engine = engine("in-line-3");
    let request = BearingRequest { part: BearingPart::Inertia, samples: 1440, ..BearingRequest::default() };
    let loads = bearing_loads(&engine, None, &request).unwrap();
    let rms = |index: usize| {
        let load = &loads.mains[index].load.load;
        (load.iter().map(|force| force.norm_sqr()).sum::<f64>() / load.len() as f64).sqrt()
    };
    for index in 0..loads.mains.len() {
        let got = as_it_stands(&engine, Criterion::MainRms(Mains::One(index))).unwrap();
        assert!((got - rms(index)).abs() <= 1e-10 * got, "{got} N, {} N", rms(index));
        let got = as_it_stands(&engine, Criterion::Peak(Load::MainLoad(index))).unwrap();
        let want = loads.mains[index].load.peak.value;
        assert!((got - want).abs() <= 1e-9 * got, "{got} N, {want} N");
    }
    let largest = (0..loads.mains.len()).map(rms).fold(0.0, f64::max);
    let got = as_it_stands(&engine, Criterion::MainRms(Mains::Largest)).unwrap();
    assert!((got - largest).abs() <= 1e-10 * got);
}
