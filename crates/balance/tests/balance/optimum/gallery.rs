//! Every engine of the gallery with many kinds of task: proved, each of them.

use crate::optimum::support::*;
use lanchester_balance::{Outcome, optimise};
use lanchester_file::templates;
use lanchester_model::*;
use lanchester_task::*;

/// Weights on the crank ends and middle, and four shafts with two weights each.
fn shafts_and_weights(engine: &Engine) -> BalanceTask {
    let reach = engine.throws.iter().map(|t| t.z.abs()).fold(0.05, f64::max);
    let mut task = BalanceTask {
        weights: [-1.0, 0.1, 0.9].iter().map(|s| on_crank(&format!("crank {s}"), s * reach)).collect(),
        ..Default::default()
    };
    for (index, ratio) in [1, -1, 2, -2].into_iter().enumerate() {
        task.shafts.push(shaft(
            &format!("shaft {ratio}"),
            ratio,
            0.02,
            if index % 2 == 0 { 0.1 } else { -0.1 },
        ));
        for end in [-0.8, 0.7] {
            task.weights.push(weight(&format!("{ratio} at {end}"), Seat::Shaft(index), end * reach));
        }
    }
    task
}

#[test]
fn every_engine_has_its_proved_optimum() {
    let mut failed = String::new();
    for template in templates() {
        let engine = engine(template.name);
        let free = shafts_and_weights(&engine);
        let mut bounded = free.clone();
        let unit = all_masses(&engine) / engine.speed.highest.powi(2);
        for (k, weight) in bounded.weights.iter_mut().enumerate() {
            weight.most = Some(unit * [0.02, 0.1, 0.005][k % 3]);
            weight.radius = Some(0.03);
        }
        let mut heavy = bounded.clone();
        heavy.stages = vec![
            Stage { terms: vec![(1.0, Criterion::Peak(Load::Couple)), (0.3, Criterion::Peak(Load::Force))] },
            stage(Load::RollMoment),
            Stage { terms: vec![(1.0, Criterion::AddedMass)] },
        ];
        let crank = default_task(&engine);
        let roll = BalanceTask { stages: vec![stage(Load::RollMoment), stage(Load::Force)], ..free.clone() };
        let axes = BalanceTask {
            stages: vec![stage(Load::ForceY), stage(Load::CoupleX), stage(Load::ForceX)],
            ..bounded.clone()
        };
        for (name, task) in [
            ("crank", crank),
            ("free", free),
            ("bounded", bounded),
            ("heavy", heavy),
            ("roll", roll),
            ("axes", axes),
        ] {
            let answer = optimise(&engine, &task).unwrap();
            if answer.outcome != Outcome::Optimal {
                failed += &format!("{} {name}: {:?} {:?}\n", template.name, answer.outcome, answer.method);
                for s in &answer.stages {
                    failed += &format!("     {:.6e} gap {:.2e}\n", s.value, s.gap);
                }
            }
        }
    }
    assert!(failed.is_empty(), "{failed}");
}
