//! What may be done where the engine file does not say it.

use lanchester_file::{read, templates};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Place, default_task};

fn task_of(name: &str, change: impl Fn(String) -> String) -> (Engine, BalanceTask) {
    let template = templates().iter().find(|template| template.name == name).expect("a template");
    let text = change(template.text.to_string());
    let engine = read(&text).engine().unwrap_or_else(|| panic!("{name} cannot be read"));
    let task = default_task(&engine);
    (engine, task)
}

#[test]
fn it_takes_over_the_counterweights_of_the_engine() {
    let (engine, task) = task_of("in-line-3", |text| text);
    assert!(!engine.counterweights.is_empty());
    let names: Vec<&String> = task.weights.iter().map(|weight| &weight.name).collect();
    let own: Vec<&String> = engine.counterweights.iter().map(|weight| &weight.name).collect();
    assert_eq!(names, own);
    assert!(task.stages.is_empty() && task.limits.is_empty() && task.shafts.is_empty());
}

#[test]
fn without_counterweights_it_takes_webs_or_throws() {
    let bare = |text: String| match text.find("[counterweights]") {
        Some(at) => text[..at].to_string(),
        None => text,
    };
    let (engine, task) = task_of("in-line-4", bare);
    assert_eq!(task.weights.len(), 2 * engine.throws.len());
    assert_eq!(
        (task.weights[7].name.as_str(), task.weights[7].z),
        ("web 8", Place::At(engine.throws[3].webs.unwrap()[1]))
    );
    let (engine, task) = task_of("in-line-4", |text| {
        bare(text)
            .lines()
            .filter(|line| !line.starts_with("web_distance"))
            .map(|line| format!("{line}\n"))
            .collect()
    });
    let names: Vec<&str> = task.weights.iter().map(|weight| weight.name.as_str()).collect();
    assert_eq!(names, ["throw 1", "throw 2", "throw 3", "throw 4"]);
    assert_eq!(task.weights[1].z, Place::At(engine.throws[1].z));
}

#[test]
fn no_two_of_its_weights_are_one() {
    for template in templates() {
        let engine =
            read(template.text).engine().unwrap_or_else(|| panic!("{} cannot be read", template.name));
        let weights = default_task(&engine).weights;
        assert!(!weights.is_empty());
        for (place, weight) in weights.iter().enumerate() {
            for other in &weights[..place] {
                assert_ne!(weight.name, other.name);
                assert!((weight.seat, weight.z) != (other.seat, other.z), "{}", template.name);
            }
        }
    }
}
