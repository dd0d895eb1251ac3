//! Condition E: the crankshaft by finite elements in rigid bearings against the closed form, stiffened until it is rigid and as it is.
//!
//! Of the stiffened one the loads that gas, pistons and rods bring to the mains must be those of the closed form: both have the same masses. The crankshaft's own
//! centrifugal loads differ by what one of both bodies has alone. Of the crankshaft as it is the rest differs by how it yields and vibrates.

use crate::crosscheck::pair::{CrossCheckError, Pair};
use crate::stress::cycle::housed_law::HousedLaw;
use crate::stress::cycle::train::{Bearing, Composed, bearing_places};
use lanchester_flex::crank_mesh::{CrankMeshOptions, crank_mesh};
use lanchester_flex::train::{
    BasisOptions, BearingPlace, CrankBody, CrankTrain, CycleInstant, CycleOptions, CycleOutcome, TrainLaw,
    crank_basis, run_cycles,
};
use lanchester_mechanism::{BearingRequest, bearing_loads};
use lanchester_model::Engine;
use lanchester_report::{CrossRow, CrossVerdict};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

/// Share of the largest load by which the stiffened crankshaft may differ.
const RIGID: f64 = 1e-4;
/// How many times as stiff.
const STIFFER: f64 = 1e4;
/// Elements of a mesh that must move right, and no more; with sharp corners it has the masses of the file's numbers.
const SIZE: f64 = 0.016;
const MODES: usize = 10;
/// Share of critical damping of the stiffened crankshaft, so that a jump of the pressure does not ring, and of the real one.
const STILL: f64 = 0.5;
const REAL: f64 = 0.01;
/// Instants of a revolution.
const SAMPLES: usize = 120;
/// Steps of the gas force [rad] and its change in one over its range that counts as a jump, and how far beside it nothing is compared [rad].
const STEP: f64 = PI / 1440.0;
const JUMP: f64 = 0.02;
const BESIDE: f64 = PI / 90.0;

/// Loads of all mains at every instant.
type Mains = Vec<Vec<Complex64>>;

/// The rows of all crankshafts, or why there are none.
pub(crate) fn flexible(pair: &Pair<'_>) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    let engine = pair.engine;
    if engine.crank_body.is_none() {
        return Ok(Err("the file has no [crank.body] to mesh".into()));
    }
    let mut rows = Vec::new();
    for crankshaft in 0..engine.crankshafts.len() {
        let places = match bearing_places(engine, crankshaft) {
            Ok(places) => places,
            Err(error) => return Ok(Err(error.to_string().replace('\n', "; "))),
        };
        let options = CrankMeshOptions { size: SIZE, fillets: false, ..CrankMeshOptions::default() };
        let surfaces: Vec<BearingPlace> = places.iter().map(|own| own.surface.clone()).collect();
        let basis = BasisOptions { modes: MODES, damping: STILL, ..BasisOptions::default() };
        let body = crank_mesh(engine, crankshaft, options)
            .and_then(|crank| crank_basis(&crank, &surfaces, basis, &|_| {}))
            .map(|basis| basis.body);
        match body {
            Ok(body) => match of_crankshaft(pair, crankshaft, &places, &body)? {
                Ok(own) => rows.extend(own),
                Err(reason) => return Ok(Err(reason)),
            },
            Err(error) => return Ok(Err(error.to_string().replace('\n', "; "))),
        }
    }
    Ok(Ok(rows))
}

fn of_crankshaft(
    pair: &Pair<'_>,
    crankshaft: usize,
    places: &[Bearing],
    body: &CrankBody,
) -> Result<Result<Vec<CrossRow>, String>, CrossCheckError> {
    let engine = pair.engine;
    let request = BearingRequest { speed: Some(pair.speed), samples: SAMPLES, ..BearingRequest::default() };
    let whole = bearing_loads(engine, pair.gas, &request)?;
    let closed = |engine: &Engine| -> Result<Mains, CrossCheckError> {
        let loads = bearing_loads(engine, pair.gas, &request)?;
        let own = loads.mains.into_iter().filter(|main| main.crankshaft == crankshaft + 1);
        Ok(own.map(|main| main.load.load).collect())
    };
    let bare = engine.with(|parts| {
        parts.counterweights.clear();
        for throw in &mut parts.throws {
            (throw.unbalance, throw.unbalance_offset) = (0.0, 0.0);
        }
    });
    let Ok(bare) = bare else { return Ok(Err("a crankshaft without masses is refused".into())) };
    let (all, of_rods) = (closed(engine)?, closed(&bare)?);

    let composed =
        Composed::new(engine, &|index, theta| pair.gas_force(index, theta), pair.speed, whole.period, places);
    let laws = vec![HousedLaw { law: TrainLaw::Rigid, housing: None }; places.len()];
    let turns = (whole.period / TAU).round().max(1.0) as usize;
    let options = CycleOptions { samples: turns * SAMPLES, tolerance: 1e-6, ..CycleOptions::default() };
    let run = |body: CrankBody, with_rods: bool| -> Result<Mains, String> {
        let mut train = composed.train(body, &laws);
        if !with_rods {
            train.cylinders.clear();
        }
        loads_of(&train, options)
    };
    let stiff = body.stiffened(STIFFER);
    let mut real = body.clone();
    real.damping.iter_mut().for_each(|d| *d *= REAL / STILL);
    let runs = [run(stiff.clone(), true), run(stiff, false), run(real, true)];
    let [stiff, alone, real] = match runs {
        [Ok(stiff), Ok(alone), Ok(real)] => [stiff, alone, real],
        [stiff, alone, real] => {
            let reason = [stiff, alone, real].into_iter().find_map(Result::err).unwrap_or_default();
            return Ok(Err(reason));
        }
    };

    let count = places.iter().filter(|own| own.is_main()).count();
    let planes: Vec<f64> = places.iter().take(count).map(|own| own.surface.z).collect();
    let kept = away_from_jumps(pair, whole.theta.as_slice());
    let named = |name: &str| match engine.crankshafts.len() {
        1 => name.to_owned(),
        _ => format!("crankshaft {}: {name}", crankshaft + 1),
    };
    let difference = |a: &Mains, b: &Mains| -> Mains {
        a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a - b).collect()).collect()
    };
    let scale = largest(&of_rods, &kept);
    let mut rows = Vec::new();
    let by_rods = difference(&stiff, &alone);
    if count == 2 {
        let values =
            [scale, largest(&by_rods, &kept), largest(&difference(&by_rods, &of_rods), &kept), scale];
        rows.push(CrossRow::held(
            &named("mains under gas, pistons and rods, stiffened"),
            "N",
            None,
            values,
            RIGID,
        ));
    } else {
        // More than two share the load by stiffness, however stiff: forces and couples of all together are open to no choice.
        for (name, unit, power) in [("force of all mains", "N", 0), ("couple of all mains", "N m", 1)] {
            let sum = |mains: &Mains| -> Mains {
                let at = |k: usize| mains.iter().zip(&planes).map(|(own, z)| own[k] * z.powi(power)).sum();
                vec![(0..mains[0].len()).map(at).collect()]
            };
            let (theirs, ours) = (sum(&of_rods), sum(&by_rods));
            let reach = planes.iter().fold(0.0f64, |most, z| most.max(z.abs()));
            let own = largest(&theirs, &kept).max(1e-3 * scale * if power == 1 { reach } else { 1.0 });
            let values = [
                largest(&theirs, &kept),
                largest(&ours, &kept),
                largest(&difference(&ours, &theirs), &kept),
                own,
            ];
            let name = format!("{name} under gas, pistons and rods, stiffened");
            rows.push(CrossRow::held(&named(&name), unit, None, values, RIGID));
        }
        let reason = format!(
            "a rigid crankshaft on {count} mains leaves their loads open: the closed form cuts it at every main, here its stiffness shares them out"
        );
        rows.push(told(&named("mains, share by stiffness"), [&of_rods, &by_rods], &kept, scale, reason));
    }
    let own = difference(&all, &of_rods);
    let shared =
        "a rigid crankshaft on more than two mains leaves their loads open: its stiffness shares them out";
    let reason = match count {
        2 => "the mesh leaves out what the body of the closed form has",
        _ => shared,
    };
    rows.push(told(
        &named("mains, centrifugal loads of the crankshaft"),
        [&own, &alone],
        &kept,
        scale,
        reason.to_owned(),
    ));
    let beyond = largest(&difference(&real, &stiff), &kept);
    let sharing = if count == 2 { "" } else { ", and its stiffness shares the loads out" };
    let reason = format!(
        "the crankshaft deflects and vibrates, by which its mains have up to {beyond:.4e} N more or less than stiffened{sharing}; loads beside jumps of a pressure are left out"
    );
    rows.push(told(&named("mains, crankshaft as it is"), [&all, &real], &kept, scale, reason));
    Ok(Ok(rows))
}

/// A row that differs as it must, unless it does not.
fn told(name: &str, [theirs, ours]: [&Mains; 2], kept: &[usize], scale: f64, reason: String) -> CrossRow {
    let apart: Mains =
        theirs.iter().zip(ours).map(|(a, b)| a.iter().zip(b).map(|(a, b)| b - a).collect()).collect();
    let values = [largest(theirs, kept), largest(ours, kept), largest(&apart, kept), scale];
    let mut row = CrossRow::held(name, "N", None, values, RIGID);
    if row.verdict != CrossVerdict::Agrees && row.difference.is_finite() {
        (row.verdict, row.bar, row.reason) = (CrossVerdict::DiffersAsItMust, None, Some(reason));
    }
    row
}

fn largest(mains: &Mains, kept: &[usize]) -> f64 {
    mains.iter().flat_map(|own| kept.iter().map(|k| own[*k].norm())).fold(0.0, f64::max)
}

/// Loads of the journals on the mains over the recorded cycle.
fn loads_of(train: &CrankTrain, options: CycleOptions) -> Result<Mains, String> {
    let found = run_cycles(train, options).map_err(|error| error.to_string().replace('\n', "; "))?;
    let cycle = found.recorded.last().filter(|_| !matches!(found.outcome, CycleOutcome::Broken { .. }));
    let cycle = cycle.ok_or("the crank train with the flexible crankshaft broke off")?;
    let load = |own: &CycleInstant, main: usize| {
        let [x, y] = own.main_forces[main];
        -Complex64::new(x, y)
    };
    Ok((0..train.mains.len())
        .map(|main| cycle.instants.iter().map(|own| load(own, main)).collect())
        .collect())
}

/// Indices of the angles that stand beside no jump of a pressure.
fn away_from_jumps(pair: &Pair<'_>, theta: &[f64]) -> Vec<usize> {
    let count = pair.train.cylinders.len();
    let largest = |index: usize| theta.iter().map(|at| pair.gas_force(index, *at).abs()).fold(0.0, f64::max);
    let sizes: Vec<f64> = (0..count).map(largest).collect();
    let jumps = |at: f64| {
        let steps = (BESIDE / STEP) as i32;
        (-steps..steps).any(|k| {
            (0..count).any(|index| {
                let [before, after] = [k, k + 1].map(|k| pair.gas_force(index, at + STEP * f64::from(k)));
                (after - before).abs() > JUMP * sizes[index]
            })
        })
    };
    (0..theta.len()).filter(|k| !jumps(theta[*k])).collect()
}
