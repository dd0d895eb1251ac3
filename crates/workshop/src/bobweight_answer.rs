//! What `workshop bobweight` answers: the bobweights, the share that is right, and how far they are from the optimum.

use crate::bobweight::{Bobweight, bobweights};
use crate::error::WorkshopError;
use crate::factor::common_factor::{FactorEffect, common_factor, pin_pair_effect};
use crate::rotor::plane::end_planes;
use lanchester_balance::{BalanceError, Outcome, optimise};
use lanchester_mechanism::{LoadError, LoadRequest, total_loads};
use lanchester_model::{Counterweight, Engine};
use lanchester_task::workshop::{BobweightSheet, PinParts, Sheet};
use lanchester_task::{BalanceTask, FreeWeight, Place, Seat};
use serde::Serialize;
use std::f64::consts::PI;

/// A share of the reciprocating masses and what it leaves of the first order.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FactorChoice {
    /// Why it is looked at.
    pub why: String,
    /// The share.
    pub share: f64,
    /// Part that turns with the crank, over that which the reciprocating masses have on all pins.
    pub forward: f64,
    /// Part that turns against it, alike.
    pub backward: f64,
}

/// Peaks over the cycle at the highest speed of the engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ComparedBalance {
    /// How the crank is balanced.
    pub how: String,
    /// Largest resultant force [N].
    pub force: f64,
    /// Largest resultant couple [N m].
    pub couple: f64,
}

/// The engine with the weighed parts, its crank balanced in different ways.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BobweightComparison {
    /// Speed [rad/s].
    pub speed: f64,
    /// The ways; the last is the optimum.
    pub ways: Vec<ComparedBalance>,
    /// Proved for the optimum: no weights at the ends of the crank have a smaller peak force [N] than this.
    pub force_bound: f64,
    /// Proved alike: none that reach that peak force have a smaller peak couple [N m].
    pub couple_bound: f64,
}

/// A bobweight sheet worked out.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BobweightAnswer {
    /// [`crate::WORKSHOP_VERSION`].
    pub version: u32,
    /// Name of the sheet.
    pub name: String,
    /// Name of the engine.
    pub engine: Option<String>,
    /// Share of the rotating masses.
    pub rotating_share: f64,
    /// Share of the reciprocating masses.
    pub reciprocating_share: f64,
    /// Whether the sheet gives that share, or it was derived.
    pub share_given: bool,
    /// The weighed parts of every pin.
    pub pins: Vec<PinParts>,
    /// The bobweights, pin by pin.
    pub bobweights: Vec<Bobweight>,
    /// What the choices are judged by; `None` where nothing is known of the layout, or no share makes a difference.
    pub judged_by: Option<&'static str>,
    /// Shares worth looking at, the sheet's first.
    pub choices: Vec<FactorChoice>,
    /// Comparison with the optimum, where the sheet names an engine.
    pub comparison: Option<BobweightComparison>,
}

/// Works out the bobweights of `sheet`; `engine` is the one that it names.
///
/// # Errors
/// [`WorkshopError`] where the sheet has no bobweights, its pins do not fit the engine, or loads cannot be computed.
pub fn bobweight_answer(sheet: &Sheet, engine: Option<&Engine>) -> Result<BobweightAnswer, WorkshopError> {
    let Some(parts) = &sheet.bobweight else {
        return Err(WorkshopError::missing(
            "the weight of the parts",
            "bobweights",
            "add [parts] with big_end, small_end and piston, and [bobweight] with rods and pins",
        ));
    };
    let weighed_engine = engine.map(|engine| weighed(engine, parts)).transpose()?;
    let effect = match (&weighed_engine, parts.bank_angle) {
        (Some(engine), _) => deciding(engine)?,
        (None, Some(bank)) => Some(("first order of one pin", pin_pair_effect(bank, parts.split_angle))),
        (None, None) => None,
    };
    let derived = effect.as_ref().and_then(|(_, effect)| effect.least_peak());
    let share = match (parts.reciprocating_share, derived) {
        (Some(given), _) => given,
        (None, Some(derived)) => derived,
        // Every plain centred piston has half of its first order turning with the crank.
        (None, None) => 0.5,
    };
    let bobs = bobweights(parts, share)?;
    let comparison = match &weighed_engine {
        Some(engine) => Some(compare(engine, parts, share, derived)?),
        None => None,
    };
    Ok(BobweightAnswer {
        version: crate::WORKSHOP_VERSION,
        name: sheet.name.clone(),
        engine: engine.map(|engine| engine.name.clone()),
        rotating_share: parts.rotating_share,
        reciprocating_share: share,
        share_given: parts.reciprocating_share.is_some(),
        pins: parts.pins.clone(),
        bobweights: bobs,
        judged_by: effect.as_ref().map(|(name, _)| *name),
        choices: effect.map_or(Vec::new(), |(_, effect)| choices(share, parts, &effect)),
        comparison,
    })
}

/// The engine with the weighed parts of the sheet in place of its own, the oil of a pin with its big ends.
///
/// # Errors
/// [`WorkshopError`] where pins and rods of the sheet are not those of the engine.
pub fn weighed(engine: &Engine, sheet: &BobweightSheet) -> Result<Engine, WorkshopError> {
    let mut engine = engine.clone().into_parts();
    let impossible = |what: String, hint| Err(WorkshopError::Impossible { what, hint });
    for index in 0..engine.throws.len() {
        let number = index + 1;
        let Some(pin) = sheet.pins.iter().find(|pin| pin.throw == Some(number)) else {
            return impossible(
                format!("throw {number} of the engine needs a pin in the sheet, got none"),
                "set `pins` in [bobweight] to the number of throws, or add a [[pin]] with its throw",
            );
        };
        let riders: Vec<usize> =
            (0..engine.cylinders.len()).filter(|&c| engine.cylinders[c].throw == index).collect();
        if riders.len() != pin.cylinders.len() {
            return impossible(
                format!(
                    "{} must have as many rods as throw {number} of the engine, {}, got {}",
                    pin.name,
                    riders.len(),
                    pin.cylinders.len()
                ),
                "set `rods` in [bobweight] or in the [[pin]]",
            );
        }
        let oil = pin.oil / riders.len().max(1) as f64;
        for (&cylinder, parts) in riders.iter().zip(&pin.cylinders) {
            let cylinder = &mut engine.cylinders[cylinder];
            cylinder.rod.big_end_mass = parts.rotating() + oil;
            cylinder.rod.small_end_mass = parts.small_end;
            cylinder.piston_mass = parts.reciprocating() - parts.small_end;
        }
    }
    if let Some(pin) = sheet.pins.iter().find(|pin| pin.throw.is_some_and(|t| t > engine.throws.len())) {
        return impossible(
            format!(
                "{} stands for throw {}, but the engine has {}",
                pin.name,
                pin.throw.unwrap_or_default(),
                engine.throws.len()
            ),
            "count throws from 1, in the order of the engine file",
        );
    }
    Engine::new(engine).map_err(|faults| WorkshopError::Impossible {
        what: faults[0].to_string(),
        hint: "check the masses of the sheet",
    })
}

/// Throws whose unbalances cancel but for this share of their sum are thought to cancel: parts of a set differ by less.
const SCATTER: f64 = 0.05;

/// The first order that a common share changes: of the force, or of the couple where the throws cancel anyway.
fn deciding(engine: &Engine) -> Result<Option<(&'static str, FactorEffect)>, WorkshopError> {
    let factor = common_factor(engine, 0)?;
    let cancels = |effect: &FactorEffect| effect.per_share.norm() <= SCATTER * effect.size;
    Ok(match (cancels(&factor.force), cancels(&factor.couple)) {
        (false, _) => Some(("first-order force of the engine", factor.force)),
        (true, false) => Some(("first-order couple of the engine", factor.couple)),
        (true, true) => None,
    })
}

fn choices(share: f64, sheet: &BobweightSheet, effect: &FactorEffect) -> Vec<FactorChoice> {
    let whole = effect.per_share.norm();
    let choice = |why: String, share: f64| {
        let part = |part: f64| if part <= 1e-9 * effect.size { 0.0 } else { part / whole };
        FactorChoice {
            why,
            share,
            forward: part((effect.forward - share * effect.per_share).norm()),
            backward: part(effect.backward.norm()),
        }
    };
    let own = match sheet.reciprocating_share {
        Some(_) => "the sheet's",
        None => "taken: least peak",
    };
    let mut found = vec![choice(own.to_owned(), share)];
    if let (Some(best), Some(_)) = (effect.least_peak(), sheet.reciprocating_share) {
        found.push(choice("least peak".to_owned(), best));
    }
    // What turns backward by the scatter of the parts alone is not worth a share of its own.
    let planes = effect.one_plane().filter(|_| effect.backward.norm() > SCATTER * effect.size);
    for plane in planes.into_iter().flatten() {
        let direction = plane.direction.to_degrees();
        let along = match direction {
            d if d.abs() < 0.05 => "along x".to_owned(),
            d if (d.abs() - 90.0).abs() < 0.05 => "along y".to_owned(),
            d => format!("at {d:.1} deg from x"),
        };
        found.push(choice(format!("one plane, {along}"), plane.share));
    }
    found
}

/// The engine with a crank that is in balance on the machine with these bobweights: what is missing stands opposite
/// every throw.
fn machine_balanced(engine: &Engine, bobs: &[Bobweight]) -> Engine {
    let counterweights = bobs
        .iter()
        .filter_map(|bob| Some((bob, bob.throw? - 1)))
        .enumerate()
        .map(|(number, (bob, index))| {
            let throw = &engine.throws[index];
            let missing = throw.unbalance + bob.mass * throw.radius;
            let turned = if missing < 0.0 { 0.0 } else { PI };
            Counterweight {
                name: format!("bobweight {}", number + 1),
                crankshaft: throw.crankshaft,
                z: throw.z,
                unbalance: missing.abs(),
                angle: throw.angle + turned,
                part: None,
            }
        })
        .collect();
    engine
        .with(|parts| parts.counterweights = counterweights)
        .expect("invariant: bobweights have finite masses")
}

fn peaks(engine: &Engine, how: &str) -> Result<ComparedBalance, LoadError> {
    let peaks = total_loads(engine, &LoadRequest { samples: 1, ..LoadRequest::default() })?.peaks;
    Ok(ComparedBalance { how: how.to_owned(), force: peaks.force.max.value, couple: peaks.couple.max.value })
}

fn compare(
    engine: &Engine,
    sheet: &BobweightSheet,
    share: f64,
    derived: Option<f64>,
) -> Result<BobweightComparison, WorkshopError> {
    let balanced = |share| Ok::<_, WorkshopError>(machine_balanced(engine, &bobweights(sheet, share)?));
    let mut ways = vec![
        peaks(engine, "counterweights of the engine file")?,
        peaks(&balanced(share)?, "in balance with these bobweights")?,
    ];
    if let Some(best) = derived.filter(|best| (best - share).abs() > 1e-9) {
        ways.push(peaks(&balanced(best)?, "in balance with those of the least peak")?);
    }
    let without = engine.without_counterweights();
    let task = BalanceTask { weights: end_weights(engine), ..BalanceTask::default() };
    let answer = optimise(&without, &task).map_err(|error| match error {
        BalanceError::Loads(error) => WorkshopError::Loads(error),
        other => WorkshopError::Impossible { what: other.to_string(), hint: "check the engine file" },
    })?;
    if matches!(answer.outcome, Outcome::Infeasible { .. }) {
        return Err(WorkshopError::Impossible {
            what: "the optimum was not found".into(),
            hint: "balance the engine by itself first: its answer says why",
        });
    }
    let counterweights = answer
        .weights
        .iter()
        .zip(&task.weights)
        .filter_map(|(found, free)| match free.seat {
            Seat::Crankshaft(crankshaft) => Some(Counterweight {
                name: found.name.clone(),
                crankshaft,
                z: found.z,
                unbalance: found.unbalance.norm(),
                angle: found.unbalance.arg() - engine.crankshafts[crankshaft].phase,
                part: None,
            }),
            Seat::Shaft(_) => None,
        })
        .collect();
    let best = without.with(|parts| parts.counterweights = counterweights);
    let best = best.expect("invariant: amounts that are found are finite");
    ways.push(peaks(&best, "optimum: two weights at the ends of the crank")?);
    // Rounding may put a bound a hair below nothing.
    let bound = |stage: usize| answer.stages.get(stage).map_or(0.0, |stage| stage.lower_bound.max(0.0));
    Ok(BobweightComparison {
        speed: engine.speed.highest,
        ways,
        force_bound: bound(0),
        couple_bound: bound(1),
    })
}

/// Free weights at the ends of every crankshaft: on the outermost webs, or in the planes of the outermost throws.
fn end_weights(engine: &Engine) -> Vec<FreeWeight> {
    let mut weights = Vec::new();
    for crankshaft in 0..engine.crankshafts.len() {
        for plane in end_planes(engine, crankshaft) {
            weights.push(FreeWeight::new(
                format!("{} of crankshaft {}", plane.name, crankshaft + 1),
                Seat::Crankshaft(crankshaft),
                Place::At(plane.z),
            ));
        }
    }
    weights
}

#[cfg(test)]
mod tests;
