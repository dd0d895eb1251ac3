//! Main-bearing loads with gas over the range of speeds, and their mean, as criteria and limits.

use lanchester::balance::{
    Answer, BalanceError, BalanceSettings, Next, Outcome, as_it_stands, fitted, optimise,
};
use lanchester::mechanism::{BearingRequest, MainBearing, MainForces, bearing_loads};
use lanchester::model::{Engine, SpeedRange};
use lanchester::task::{BalanceTask, Criterion, Limit, Mains, Stage, Statistic, default_task};
use lanchester::{cylinder_gas, optimised};

fn four() -> Engine {
    let text = include_str!("../../../../examples/in-line-4-mounts.toml");
    lanchester::file::read(text).engine().expect("the example has no mistakes")
}

const fn gas(statistic: Statistic, mains: Mains) -> Criterion {
    Criterion::MainsWithGas(statistic, mains)
}

const PEAK: Criterion = gas(Statistic::Peak, Mains::Largest);
const RMS: Criterion = gas(Statistic::Rms, Mains::All);

fn stages(criteria: &[Criterion]) -> Vec<Stage> {
    criteria.iter().map(|criterion| Stage { terms: vec![(1.0, *criterion)] }).collect()
}

fn answered(engine: &Engine, task: &BalanceTask) -> Answer {
    optimised(engine, Ok(&[]), task, &BalanceSettings::default(), &|_| Next::Continue)
        .expect("it has an answer")
}

/// What an engine has of a criterion as it stands.
fn standing(engine: &Engine, criterion: Criterion) -> f64 {
    let task = BalanceTask { stages: stages(&[criterion]), ..BalanceTask::default() };
    after(&answered(engine, &task), criterion)
}

fn after(answer: &Answer, criterion: Criterion) -> f64 {
    answer.effects.iter().find(|effect| effect.criterion == criterion).expect("it is told").after
}

fn with_weights(engine: &Engine, factor: f64) -> Engine {
    let mut engine = engine.clone();
    engine = engine
        .with(|engine| {
            engine.counterweights.iter_mut().for_each(|weight| weight.unbalance *= factor);
        })
        .unwrap();
    engine
}

/// Largest peak and largest root mean square of all mains over so many speeds, by the traces of `bearings`.
fn over_speeds(engine: &Engine, count: usize) -> [f64; 2] {
    let SpeedRange { lowest, highest } = engine.speed;
    let mut largest = [0.0f64; 2];
    for k in 0..=count {
        let speed = lowest + (highest - lowest) * k as f64 / count as f64;
        let gas = cylinder_gas(engine, &[], speed).expect("it has gas").cylinders;
        let at = |samples: usize| {
            let request = BearingRequest { speed: Some(speed), samples, ..BearingRequest::default() };
            bearing_loads(engine, Some(&gas), &request).expect("it is held").mains
        };
        let square = |mains: &[MainBearing]| {
            let all = mains.iter().flat_map(|main| &main.load.load).map(|force| force.norm_sqr());
            all.sum::<f64>() / mains.iter().map(|main| main.load.load.len()).sum::<usize>() as f64
        };
        // The gas jumps at samples: what that leaves goes with the step, and is taken off (Richardson).
        let (coarse, fine) = (at(360), at(720));
        let squares = 2.0 * square(&fine) - square(&coarse);
        let peak = fine.iter().map(|main| main.load.peak.value).fold(0.0, f64::max);
        largest = [largest[0].max(peak), largest[1].max(squares.sqrt())];
    }
    largest
}

/// Its peak lies at low speed, where weights do little.
#[test]
fn weights_hardly_touch_the_peak_with_gas_of_the_transverse_four() {
    let four = four();
    for factor in [0.0, 1.0, 2.0] {
        let engine = with_weights(&four, factor);
        let value = standing(&engine, PEAK);
        assert!((value - 22_690.0).abs() < 10.0, "{factor}: {value} N");
        let [peak, rms] = over_speeds(&engine, 24);
        assert!((value - peak).abs() < 1e-6 * peak, "{factor}: {value} N, {peak} N");
        let told = standing(&engine, RMS);
        assert!(told >= rms * (1.0 - 1e-5) && told < rms * 1.001, "{factor}: {told} N, {rms} N");
    }
}

#[test]
fn the_least_peak_and_the_least_root_mean_square_over_the_range() {
    let four = four();
    for (place, criterion) in [PEAK, RMS].into_iter().enumerate() {
        let task = BalanceTask { stages: stages(&[criterion]), limits: Vec::new(), ..default_task(&four) };
        let answer = answered(&four, &task);
        assert_eq!(answer.outcome, Outcome::Optimal);
        let stage = &answer.stages[0];
        assert!(stage.gap >= 0.0 && stage.gap <= 2e-6 * stage.value, "{stage:?}");
        let best = fitted(&four, &answer);
        let value = over_speeds(&best, 60)[place];
        assert!(value <= stage.value * (1.0 + 2e-5), "{criterion:?}: {value} N beside {stage:?}");
        let told = answer.gas_speeds.as_ref().expect("it is judged over a range");
        assert!(told.range && told.excess <= 1e-6, "{told:?}");
        // The peak stands at angles and speeds that are told: there the loads are as large as the value.
        assert_eq!(stage.active.is_empty(), criterion == RMS, "{stage:?}");
        for active in &stage.active {
            let speed = active.speed.expect("with gas it is judged over speeds");
            let gas = cylinder_gas(&four, &[], speed).expect("it has gas").cylinders;
            let forces = MainForces::new(&best, Some(&gas), speed).expect("it is held");
            let here = |main: usize| forces.at(main, active.theta).norm();
            let largest = (0..forces.count()).map(here).fold(0.0, f64::max);
            assert!((largest / stage.value - 1.0).abs() < 1e-4, "{active:?}: {largest} N");
        }
        // The file's own weights and others near the best do no better.
        let own = over_speeds(&four, 24)[place];
        assert!(stage.lower_bound <= own * (1.0 + 1e-5) && stage.value <= own * (1.0 + 1e-5));
        for trial in 0..12 {
            let mut other = best.clone();
            other = other
                .with(|other| {
                    for (k, weight) in other.counterweights.iter_mut().enumerate() {
                        let turn = f64::from(trial) * 1.7 + k as f64 * 2.3;
                        weight.unbalance *= 1.0 + 0.05 * turn.sin();
                        weight.angle += 0.05 * turn.cos();
                    }
                })
                .unwrap();
            let theirs = over_speeds(&other, 24)[place];
            assert!(theirs >= stage.lower_bound * (1.0 - 1e-5), "{trial}: {theirs} N beside {stage:?}");
        }
    }
}

#[test]
fn a_limit_with_gas_holds_over_the_range() {
    let four = four();
    let free = BalanceTask { stages: stages(&[RMS]), limits: Vec::new(), ..default_task(&four) };
    let least = answered(&four, &free).stages[0].value;
    let light = |most: f64| {
        let limits = vec![Limit { criterion: RMS, most }];
        let task = BalanceTask { stages: stages(&[Criterion::AddedUnbalance]), limits, ..free.clone() };
        answered(&four, &task)
    };
    let held = light(1.02 * least);
    assert_eq!(held.outcome, Outcome::Optimal);
    let there = over_speeds(&fitted(&four, &held), 60)[1];
    assert!(there <= 1.02 * least * (1.0 + 2e-5), "{there} N beside {least} N");
    let refused = light(0.9 * least);
    let Outcome::Infeasible { relaxation, .. } = refused.outcome else { panic!("{:?}", refused.outcome) };
    assert!((relaxation - 1.0 / 0.9).abs() < 0.002, "{relaxation}");
}

#[test]
fn means_are_those_of_the_bearings() {
    let four = four();
    let speed = four.speed.highest;
    let request = BearingRequest { speed: Some(speed), ..BearingRequest::default() };
    let pressures = cylinder_gas(&four, &[], speed).expect("it has gas").cylinders;
    for gas_too in [false, true] {
        let loads = bearing_loads(&four, gas_too.then_some(pressures.as_slice()), &request).expect("held");
        let means: Vec<f64> = loads.mains.iter().map(|main| main.load.mean).collect();
        let all = means.iter().sum::<f64>() / means.len() as f64;
        for (mains, want) in [(Mains::All, all), (Mains::One(1), means[1])] {
            let got = match gas_too {
                false => as_it_stands(&four, Criterion::MainMean(mains)).expect("it has mains"),
                true => {
                    let criterion = gas(Statistic::Mean, mains);
                    let task = BalanceTask {
                        stages: stages(&[criterion]),
                        speeds: vec![speed],
                        ..BalanceTask::default()
                    };
                    after(&answered(&four, &task), criterion)
                }
            };
            assert!((got - want).abs() < 1e-3 * want, "{gas_too} {mains:?}: {got} N, {want} N");
        }
    }
    // The least mean is below the mean of the least root mean square, and above the bound.
    let least = |criterion: Criterion| {
        let task = BalanceTask { stages: stages(&[criterion]), limits: Vec::new(), ..default_task(&four) };
        optimise(&four, &task).expect("it has an answer")
    };
    let mean = Criterion::MainMean(Mains::All);
    let (by_mean, by_rms) = (least(mean), least(Criterion::MainRms(Mains::All)));
    let of_rms = as_it_stands(&fitted(&four, &by_rms), mean).expect("it has mains");
    let stage = &by_mean.stages[0];
    assert!(stage.value <= of_rms * (1.0 + 1e-9), "{stage:?} {of_rms}");
    assert!(stage.gap <= 1e-6 * stage.value, "{stage:?}");
    let own = as_it_stands(&fitted(&four, &by_mean), mean).expect("it has mains");
    assert!((own - stage.value).abs() < 1e-6 * own);
}

/// The largest of several means: at least that of each speed alone, at most what the best for one speed has at the others, and no
/// speed passes it.
#[test]
fn the_largest_mean_over_speeds() {
    let four = four();
    let criterion = gas(Statistic::Mean, Mains::One(2));
    let mean_at = |engine: &Engine, speed: f64| {
        let pressures = cylinder_gas(engine, &[], speed).expect("it has gas").cylinders;
        let request = BearingRequest { speed: Some(speed), samples: 720, ..BearingRequest::default() };
        bearing_loads(engine, Some(&pressures), &request).expect("it is held").mains[2].load.mean
    };
    let asked = |speeds: &[f64], weights: &[f64]| {
        let task = BalanceTask {
            stages: stages(&[criterion]),
            limits: Vec::new(),
            speeds: speeds.to_vec(),
            speed_weights: weights.to_vec(),
            ..default_task(&four)
        };
        let answer = answered(&four, &task);
        let stage = &answer.stages[0];
        assert!(stage.gap >= 0.0 && stage.gap <= 2e-6 * stage.value, "{stage:?}");
        (stage.value, stage.lower_bound, fitted(&four, &answer))
    };
    let speeds = [150.0, 620.0];
    for weights in [[1.0, 1.0], [2.5, 1.0]] {
        let (value, bound, best) = asked(&speeds, &weights);
        let largest = |engine: &Engine| {
            let means = speeds.iter().zip(weights).map(|(speed, weight)| weight * mean_at(engine, *speed));
            means.fold(0.0, f64::max)
        };
        let found = largest(&best);
        assert!((found - value).abs() < 1e-3 * value, "{found} N beside {value} N");
        for (speed, weight) in speeds.iter().zip(weights) {
            let (alone, _, of_alone) = asked(&[*speed], &[weight]);
            assert!(value >= alone * (1.0 - 1e-6), "{speed}: {alone} N beside {value} N");
            assert!(bound <= largest(&of_alone) * 1.001, "{speed}: {bound} N");
        }
        for trial in 0..12 {
            let mut other = best.clone();
            other = other
                .with(|other| {
                    for (k, weight) in other.counterweights.iter_mut().enumerate() {
                        let turn = f64::from(trial) * 1.7 + k as f64 * 2.3;
                        weight.unbalance *= 1.0 + 0.2 * turn.sin();
                        weight.angle += 0.2 * turn.cos();
                    }
                })
                .unwrap();
            assert!(largest(&other) >= bound * 0.999, "{trial}: {} N beside {bound} N", largest(&other));
        }
    }
    let (value, _, best) = asked(&[], &[]);
    let SpeedRange { lowest, highest } = four.speed;
    let over = (0..=40).map(|k| mean_at(&best, lowest + (highest - lowest) * f64::from(k) / 40.0));
    let over = over.fold(0.0, f64::max);
    assert!(over <= value * 1.001 && over > 0.99 * value, "{over} N beside {value} N");
}

#[test]
fn one_bearing_at_given_speeds() {
    let four = four();
    let criterion = gas(Statistic::Peak, Mains::One(2));
    let speeds = vec![200.0, 500.0];
    let task = BalanceTask {
        stages: stages(&[criterion]),
        limits: Vec::new(),
        speeds: speeds.clone(),
        ..default_task(&four)
    };
    let answer = answered(&four, &task);
    let best = fitted(&four, &answer);
    let peaks = speeds.iter().map(|speed| {
        let pressures = cylinder_gas(&best, &[], *speed).expect("it has gas").cylinders;
        MainForces::new(&best, Some(&pressures), *speed).expect("it is held").peak(2).value
    });
    let largest = peaks.fold(0.0, f64::max);
    let stage = &answer.stages[0];
    assert!((largest - stage.value).abs() < 2e-6 * largest, "{largest} N beside {stage:?}");
    assert!(!answer.gas_speeds.expect("they are given").range);
}

#[test]
fn what_is_missing_is_told() {
    let refused = |engine: &Engine, criterion: Criterion| {
        let task = BalanceTask { stages: stages(&[criterion]), ..BalanceTask::default() };
        let asked = optimised(engine, Ok(&[]), &task, &BalanceSettings::default(), &|_| Next::Continue);
        asked.expect_err("it is refused").to_string()
    };
    let without = four().with(|parts| parts.gas = None).unwrap();
    assert!(refused(&without, PEAK).contains("add [gas]"));
    let task = BalanceTask { stages: stages(&[PEAK]), ..BalanceTask::default() };
    let settings = BalanceSettings::default();
    let unread = optimised(&four(), Err("no trace".into()), &task, &settings, &|_| Next::Continue);
    // A computed cycle needs no trace.
    assert!(matches!(unread, Ok(_) | Err(BalanceError::Gas { .. })));
}
