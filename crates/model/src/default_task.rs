//! What may be done where the engine file does not say it.

use crate::engine::Engine;
use crate::task::{BalanceTask, FreeWeight, Place, Seat};

/// The task of an engine without a `[balance]` section: the resultant force, then the couple, made as small as free
/// weights on the crankshafts can make them, and among equals the loads of the main bearings.
///
/// There is one free weight for every counterweight of the engine, under its name, so that it stands in its place.
/// An engine without counterweights gets one on every web; on every throw where a web distance is missing. Weights in
/// one plane of one crankshaft are one.
pub fn default_task(engine: &Engine) -> BalanceTask {
    let places = match (engine.counterweights.is_empty(), engine.throws.iter().all(|t| t.webs.is_some())) {
        (false, _) => CrankWeightPlaces::File,
        (true, true) => CrankWeightPlaces::Webs,
        (true, false) => CrankWeightPlaces::Throws,
    };
    BalanceTask { weights: crank_weights(engine, places), ..BalanceTask::default() }
}

/// Where free weights are put on the crankshafts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CrankWeightPlaces {
    /// Nowhere: only shafts are free.
    None,
    /// In place of every counterweight of the engine, under its name.
    File,
    /// In the plane of every throw.
    Throws,
    /// On every web of the throws that have a web distance, but not on those between two pins.
    Webs,
}

/// One free weight at every such place; weights in one plane of one crankshaft are one. Empty where the engine has no
/// such place.
pub fn crank_weights(engine: &Engine, places: CrankWeightPlaces) -> Vec<FreeWeight> {
    let mut weights: Vec<FreeWeight> = Vec::new();
    let mut add = |name: &str, crankshaft: usize, z: f64| {
        let seat = Seat::Crankshaft(crankshaft);
        if weights.iter().any(|known| known.seat == seat && known.z == Place::At(z)) {
            return;
        }
        let is_taken = |name: &str| weights.iter().any(|known| known.name == name);
        let name = if is_taken(name) {
            (2..).map(|number| format!("{name} {number}")).find(|name| !is_taken(name)).unwrap_or_default()
        } else {
            name.to_string()
        };
        weights.push(FreeWeight::new(name, seat, Place::At(z)));
    };
    match places {
        CrankWeightPlaces::None => {}
        CrankWeightPlaces::File => {
            engine.counterweights.iter().for_each(|w| add(&w.name, w.crankshaft, w.z));
        }
        CrankWeightPlaces::Throws => {
            engine
                .throws
                .iter()
                .enumerate()
                .for_each(|(index, throw)| add(&format!("throw {}", index + 1), throw.crankshaft, throw.z));
        }
        CrankWeightPlaces::Webs => {
            let shared: Vec<usize> =
                engine.shared_webs().into_iter().flat_map(|shared| shared.webs()).collect();
            for (index, throw) in engine.throws.iter().enumerate() {
                let webs = throw.webs.into_iter().flatten().enumerate();
                let webs = webs.map(|(side, z)| (2 * index + side, z));
                for (web, z) in webs.filter(|(web, _)| !shared.contains(web)) {
                    add(&format!("web {}", web + 1), throw.crankshaft, z);
                }
            }
        }
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{read, templates};

    fn task_of(name: &str, change: impl Fn(String) -> String) -> (Engine, BalanceTask) {
        let template = templates().iter().find(|template| template.name == name).expect("a template");
        let text = change(template.text.to_string());
        let engine = read(&text).engine.unwrap_or_else(|| panic!("{name} cannot be read"));
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
                read(template.text).engine.unwrap_or_else(|| panic!("{} cannot be read", template.name));
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
}
