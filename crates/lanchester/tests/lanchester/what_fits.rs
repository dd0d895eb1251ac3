//! What fits on the webs bounds the free weights, and every weight of the optimum can be built.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::balance::{Answer, BalanceSettings, Next, Outcome, fitted};
use lanchester::file::{EngineFile, read, write_back};
use lanchester::geometry::DesignOutcome;
use lanchester::model::Engine;
use lanchester::task::{BalanceTask, CrankWeightPlaces, TaskOptions, default_task};
use lanchester::{
    CounterweightRequest, WebBoundError, check_counterweights, design_counterweights, optimise_on_webs,
    web_excesses, with_counterweights,
};

const EXAMPLE: &str = include_str!("../../../../examples/in-line-3-counterweights.toml");

fn file(text: &str) -> EngineFile {
    let read = read(text);
    read.file.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn on_webs(file: &EngineFile, task: &BalanceTask) -> Result<Answer, WebBoundError> {
    let EngineFile { engine, tasks } = file;
    let shapes = tasks.shape_task.as_ref();
    optimise_on_webs(engine, Ok(&[]), task, shapes, &BalanceSettings::default(), &|_| Next::Continue)
}

fn every_web(engine: &Engine, most: Option<&str>) -> BalanceTask {
    let options = TaskOptions {
        counterweights: Some(CrankWeightPlaces::Webs),
        most: most.map(str::to_owned),
        ..TaskOptions::default()
    };
    options.change(engine, default_task(engine)).unwrap().task
}

/// Balances, writes the answer into the file, designs the weights that the file now asks for, and checks the engine with them.
fn is_built(text: &str, task: impl Fn(&Engine) -> BalanceTask) -> Answer {
    let before = file(text);
    let answer = on_webs(&before, &task(&before.engine)).unwrap();
    assert_eq!(answer.outcome, Outcome::Optimal);
    for bound in &answer.web_bounds {
        let found = answer.weights.iter().find(|weight| weight.name == bound.name).unwrap();
        assert!(found.unbalance.norm() <= bound.bound * (1.0 + 1e-6), "{bound:?} {found:?}");
    }
    let written = write_back(text, &fitted(&before.engine, &answer)).unwrap();
    let EngineFile { engine: after, tasks } = file(&written);
    let shapes = tasks.shape_task.unwrap();
    let heavy = after.counterweights.iter().filter(|weight| weight.unbalance > 1e-6);
    let weights: Vec<String> = heavy.map(|weight| weight.name.clone()).collect();
    assert!(!weights.is_empty());
    let request = CounterweightRequest { weights, unbalance: None, task: shapes, evolution: None };
    let designs = design_counterweights(&after, &request).unwrap();
    let mut found = Vec::new();
    for weight in &designs.weights {
        let DesignOutcome::Found(best) = &weight.outcome else {
            panic!("{} cannot have {} kg m: {:?}", weight.name, weight.duty, weight.outcome)
        };
        assert!(best.design.balance > 1.0 - 1e-6, "{best:?}");
        found.push((weight.index, best.design));
    }
    let parts = with_counterweights(&after, &found, shapes.density).unwrap();
    let checked = check_counterweights(&parts).unwrap();
    let own = checked.counterweights.iter().filter(|weight| request.weights.contains(&weight.name));
    assert!(own.clone().all(|weight| weight.is_met), "{:?}", own.collect::<Vec<_>>());
    assert!(checked.clearances.as_ref().unwrap().is_kept, "{:?}", checked.clearances.unwrap().smallest);
    answer
}

#[test]
fn what_balance_asks_for_can_be_built() {
    let answer = is_built(EXAMPLE, |engine| every_web(engine, Some("what fits")));
    assert_eq!(answer.web_bounds.len(), 6);
    // Without bounds the optimum asks for more than fits on some web.
    let before = file(EXAMPLE);
    let free = lanchester::balance::optimise(&before.engine, &every_web(&before.engine, None)).unwrap();
    let exceeds = |bound: &lanchester::balance::WebBound| {
        let found = free.weights.iter().find(|weight| weight.name == bound.name).unwrap();
        found.unbalance.norm() > bound.bound
    };
    assert!(answer.web_bounds.iter().any(exceeds), "{:?}", answer.web_bounds);
    let close = EXAMPLE.replace("crankcase_radius = \"100 mm\"", "crankcase_radius = \"92.9 mm\"");
    // As near as the pin's end of the web allows.
    let tight = is_built(&close, |engine| every_web(engine, None));
    for (tight, wide) in tight.web_bounds.iter().zip(&answer.web_bounds) {
        assert!(tight.bound < 0.99 * wide.bound, "{tight:?} {wide:?}");
        assert_eq!(tight.by, "clearance from crankcase");
    }
}

/// With a body and shapes in the file it is the default; an amount in its place counts.
#[test]
fn it_is_the_default_where_shapes_are_known() {
    let before = file(EXAMPLE);
    let asked = on_webs(&before, &every_web(&before.engine, Some("what fits"))).unwrap();
    let usual = on_webs(&before, &every_web(&before.engine, None)).unwrap();
    assert_eq!(asked.web_bounds, usual.web_bounds);
    assert_eq!(asked.weights, usual.weights);
    let given = on_webs(&before, &every_web(&before.engine, Some("10 kg mm"))).unwrap();
    assert!(given.web_bounds.is_empty());
    assert!(given.weights.iter().all(|weight| weight.unbalance.norm() < 10.001e-3));
}

#[test]
fn the_file_says_it_and_what_is_missing_is_told() {
    let asks = "\n[balance]\n[[balance.counterweight]]\nwebs = \"all\"\nmost = \"what fits\"\n";
    let before = file(&format!("{EXAMPLE}{asks}"));
    let task = before.tasks.balance.clone().unwrap();
    assert!(task.weights.iter().all(|weight| weight.fits && weight.most.is_none()));
    assert_eq!(on_webs(&before, &task).unwrap().web_bounds.len(), 6);
    let start = EXAMPLE.find("# Among these shapes").unwrap();
    let end = EXAMPLE.find("# What the turning").unwrap();
    let bare = file(&format!("{}{}{asks}", &EXAMPLE[..start], &EXAMPLE[end..]));
    let error = on_webs(&bare, bare.tasks.balance.as_ref().unwrap()).unwrap_err().to_string();
    assert!(error.contains("[counterweight_design]") && error.contains("hint:"), "{error}");
    let wrong = format!("{EXAMPLE}{}", asks.replace("what fits", "what fit"));
    let told = read(&wrong);
    assert!(told.file.is_none());
    assert!(
        told.diagnostics
            .iter()
            .any(|one| one.hint.as_ref().is_some_and(|hint| hint.contains("did you mean \"what fits\"?"))),
        "{:?}",
        told.diagnostics
    );
    let options = TaskOptions { prefix: "--", most: Some("what fit".into()), ..TaskOptions::default() };
    let refused = options.change(&before.engine, task).unwrap_err();
    assert!(refused.hint.contains("did you mean --most 'what fits'?"), "{refused:?}");
}

/// The optimum on the webs fits; the same weights a tenth heavier, as a method without bounds may choose them, do not, and are named.
#[test]
fn weights_that_do_not_fit_are_named() {
    let file = file(EXAMPLE);
    let answer = on_webs(&file, &every_web(&file.engine, None)).unwrap();
    let best = fitted(&file.engine, &answer);
    let shapes = file.tasks.shape_task.as_ref();
    let known = web_excesses(&best, shapes).unwrap();
    assert_eq!((known.too_large.len(), known.elsewhere.len()), (0, 0), "{known:?}");
    assert!(known.checked > 0);
    let bounded = |name: &str| answer.web_bounds.iter().find(|bound| bound.name == name);
    let heavier = best
        .with(|parts| {
            for weight in &mut parts.counterweights {
                if let Some(bound) = bounded(&weight.name) {
                    weight.unbalance = 1.1 * bound.bound;
                }
            }
        })
        .unwrap();
    let found = web_excesses(&heavier, shapes).unwrap();
    assert!(!found.too_large.is_empty() && found.checked >= known.checked, "{found:?}");
    for excess in &found.too_large {
        let bound = bounded(&excess.name).expect("it was bounded");
        assert_eq!(excess.web, bound.web);
        assert!(excess.unbalance > excess.bound && !excess.by.is_empty(), "{excess:?} {bound:?}");
    }
    // Weights on throws stand on no web, and without shapes nothing is known.
    let throws =
        best.with(|parts| parts.counterweights.iter_mut().for_each(|weight| weight.z += 1e-3)).unwrap();
    let told = web_excesses(&throws, shapes).unwrap();
    assert_eq!((told.checked, told.elsewhere.len()), (0, best.counterweights.len()));
    assert_eq!(web_excesses(&heavier, None).unwrap(), Default::default());
}
