//! What may be done where the engine file does not say it.

use crate::balance_task::{BalanceTask, FreeWeight, Place, Seat};
use lanchester_model::Engine;

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
