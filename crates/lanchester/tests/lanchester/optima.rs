//! Optima held against another solver on loads that share no code with ours: `validation/optima/derive.py`.

use lanchester::balance::{Outcome, optimise};
use lanchester::file::{read, template};
use lanchester::model::Ratio;
use lanchester::task::{BalanceTask, Criterion, FreeShaft, FreeWeight, Limit, Load, Place, Seat, Stage};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn criterion(name: &str) -> Criterion {
    Criterion::Peak(match name {
        "force" => Load::Force,
        "couple" => Load::Couple,
        "roll moment" => Load::RollMoment,
        other => panic!("no load is called {other}"),
    })
}

/// The task of a case: its weights in addition to those of the template.
fn task(case: &Value) -> BalanceTask {
    let mut task = BalanceTask::default();
    for (k, weight) in case["weights"].as_array().expect("weights").iter().enumerate() {
        let ratio = weight["ratio"].as_i64().expect("a whole ratio") as i32;
        let (x, y) = (number(&weight["x"]), number(&weight["y"]));
        let seat = match (ratio, x, y) {
            (1, 0.0, 0.0) => Seat::Crankshaft(0),
            _ => {
                let (x, y) = (Place::At(x), Place::At(y));
                let ratio = Ratio::whole(ratio).expect("not 0");
                task.shafts.push(FreeShaft {
                    name: format!("added shaft {k}"),
                    ratio,
                    x,
                    y,
                    optional: false,
                });
                Seat::Shaft(task.shafts.len() - 1)
            }
        };
        task.weights.push(FreeWeight {
            most: weight["most"].as_f64(),
            ..FreeWeight::new(format!("added weight {k}"), seat, Place::At(number(&weight["z"])))
        });
    }
    let minimise = case["minimise"].as_str().expect("a criterion");
    task.stages = vec![Stage { terms: vec![(1.0, criterion(minimise))] }];
    let limits = case["limits"].as_object().expect("limits");
    task.limits =
        limits.iter().map(|(name, most)| Limit { criterion: criterion(name), most: number(most) }).collect();
    task
}

#[test]
fn ext_ecos_optima_of_the_gallery() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/optima/optima.json");
    let text = std::fs::read_to_string(path).expect("the evidence is in the repository");
    let document: Value = serde_json::from_str(&text).expect("JSON");
    let cases = document["cases"].as_array().expect("cases");
    assert!(cases.len() >= 25, "{} cases", cases.len());
    let mut wrong = Vec::new();
    for case in cases {
        let name = case["template"].as_str().expect("a template");
        let said = format!("{name}, {} under {}", case["minimise"], case["limits"]);
        let engine = read(template(name).expect("in the gallery").text).engine().expect("no mistakes");
        let answer = optimise(&engine, &task(case)).unwrap_or_else(|error| panic!("{said}: {error}"));
        if case["found"].is_null() {
            if !matches!(answer.outcome, Outcome::Infeasible { .. }) {
                wrong
                    .push(format!("{said}: the other solver finds it infeasible, ours {:?}", answer.outcome));
            }
            continue;
        }
        let (value, peak) = (number(&case["found"]["value"]), number(&case["found"]["peak"]));
        let Some(stage) = answer.stages.first() else {
            wrong.push(format!("{said}: {:?}", answer.outcome));
            continue;
        };
        let before = number(&case["before"]);
        // Their bound holds to 1e-8 of what is balanced, and their fine grid misses 1e-7 of the peak at most.
        let room = 1e-8 * before + 2e-7 * peak;
        if !(stage.value >= value - room && stage.value <= peak + room && stage.lower_bound <= peak + room) {
            wrong.push(format!("{said}: {} to {} there, {} here", value, peak, stage.value));
        }
        if stage.gap > 1e-8 * stage.value.max(1e-6 * before) {
            wrong.push(format!("{said}: gap {} of {}", stage.gap, stage.value));
        }
    }
    assert!(wrong.is_empty(), "{} differences:\n{}", wrong.len(), wrong.join("\n"));
}
