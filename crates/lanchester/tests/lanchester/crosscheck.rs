//! The closed form against the multibody simulation: no engine of the gallery or of the examples disagrees anywhere.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::file::{read, templates};
use lanchester::model::{Engine, EngineParts};
use lanchester::report::{Condition, CrossRow, CrossVerdict};
use lanchester::{CrossCheckRequest, TraceFile, crosscheck, trace_names};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;

fn examples() -> Vec<(Engine, Vec<TraceFile>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    let engine = |path: &Path| {
        let engine = read(&fs::read_to_string(path).unwrap()).engine().unwrap();
        let trace = |name: &str| TraceFile {
            name: name.to_owned(),
            text: fs::read_to_string(folder.join(name)).unwrap(),
        };
        let traces = trace_names(&engine).into_iter().map(trace).collect();
        (engine, traces)
    };
    files.iter().map(|path| engine(path)).collect()
}

fn check(engine: &Engine, traces: &[TraceFile]) -> usize {
    let check = crosscheck(engine, traces, &CrossCheckRequest::default())
        .unwrap_or_else(|e| panic!("{}: {e}", engine.name));
    for condition in &check.conditions {
        for row in &condition.rows {
            assert_ne!(
                row.verdict,
                CrossVerdict::Disagrees,
                "{}, {:?}: {row:?}",
                engine.name,
                condition.condition
            );
        }
        assert!(condition.not_applicable.is_some() == condition.rows.is_empty(), "{}", engine.name);
    }
    assert!(check.agrees());
    check.conditions.iter().filter(|condition| condition.not_applicable.is_none()).count()
}

#[test]
fn xcheck_gallery() {
    for template in templates() {
        let engine = read(template.text).engine().expect("the gallery has no mistakes");
        assert!(check(&engine, &[]) >= 1);
    }
}

#[test]
fn xcheck_examples() {
    for (engine, traces) in examples() {
        assert!(check(&engine, &traces) >= 1);
    }
}

/// The engine with a flywheel of this inertia [kg m^2].
fn turning(engine: &Engine, inertia: f64) -> Engine {
    let add = |parts: &mut EngineParts| {
        let wheel = parts.flywheel.get_or_insert_default();
        (wheel.inertia, wheel.crankshaft_inertia) = (Some(inertia), Some(0.05));
    };
    engine.with(add).unwrap()
}

/// With the inertia of everything that turns, the free speed is that of the energy integral.
#[test]
fn xcheck_free_speed() {
    let fired: Vec<_> = examples().into_iter().filter(|(engine, _)| engine.gas.is_some()).collect();
    assert!(fired.len() >= 2);
    for (engine, traces) in fired {
        let engine = turning(&engine, 0.4);
        assert!(check(&engine, &traces) >= 2, "{}", engine.name);
    }
}

#[test]
fn a_bar_below_rounding_is_not_kept() {
    // The comparison must be able to fail: a bar below rounding.
    let engine = read(templates()[0].text).engine().unwrap();
    let request = CrossCheckRequest {
        bar: Some(1e-19),
        conditions: vec![Condition::LikeForLike],
        ..CrossCheckRequest::default()
    };
    assert!(!crosscheck(&engine, &[], &request).unwrap().agrees());
}

/// The engine on mounts of the examples, its rubber replaced by dampers, which have an exact form in time.
#[test]
fn xcheck_moving_block() {
    let (mut engine, traces) =
        examples().into_iter().find(|(engine, _)| engine.block.is_some() && engine.gas.is_some()).unwrap();
    engine = engine
        .with(|engine| {
            for spring in engine.mounts.iter_mut().filter_map(|mount| mount.spring.as_mut()) {
                spring.table.clear();
                spring.loss_factor = [0.0; 3];
                spring.damping = [400.0; 3];
            }
        })
        .unwrap();
    let engine = turning(&engine, 0.3);
    let request = CrossCheckRequest {
        speed: Some(150.0),
        conditions: vec![Condition::MovingBlock],
        ..CrossCheckRequest::default()
    };
    let check = crosscheck(&engine, &traces, &request).unwrap();
    let condition = &check.conditions[0];
    assert_eq!(condition.not_applicable, None);
    let place = condition.rows.iter().position(|row| row.bar.is_some()).expect("the ratio has a bar");
    let ratio = &condition.rows[place];
    assert_eq!(ratio.verdict, CrossVerdict::Agrees, "{ratio:?}");
    // Neither cause, the first alone, the second alone: each of them matters.
    for left in &condition.rows[place - 3..place] {
        assert!(left.multibody < 0.5 * left.closed_form.unwrap(), "the rotors matter: {left:?}");
    }
    // So does the ratio for a little gas.
    let held: Vec<_> = condition.rows.iter().filter(|row| row.bar.is_some()).collect();
    assert_eq!(held.len(), 2);
    assert!(held.iter().all(|row| row.verdict == CrossVerdict::Agrees), "{held:?}");
    assert!(condition.rows.iter().any(|row| row.quantity.starts_with("forces at the mounts")));
    // Half orders come with the gas.
    let half = |row: &&CrossRow| row.order.is_some_and(|order| order.fract() != 0.0);
    assert!(condition.rows[place + 1..].iter().any(|row| half(&row) && row.quantity.ends_with("with gas")));
}

/// Rubber by its chains in both computations: what is left of the linear response is that of the moving masses alone, and halves with them.
#[test]
fn xcheck_moving_block_on_mounts_with_loss_factors_and_tables() {
    let has_table = |engine: &Engine| {
        engine.mounts.iter().flat_map(|mount| &mount.spring).any(|spring| !spring.table.is_empty())
    };
    let (engine, traces) = examples().into_iter().find(|(engine, _)| has_table(engine)).unwrap();
    let ask = |speed: f64| CrossCheckRequest {
        speed: Some(speed),
        conditions: vec![Condition::MovingBlock],
        ..CrossCheckRequest::default()
    };
    let engine = turning(&engine, 0.3);
    let check = crosscheck(&engine, &traces, &ask(314.0)).unwrap();
    let condition = &check.conditions[0];
    assert_eq!(condition.not_applicable, None);
    let held: Vec<_> = condition.rows.iter().filter(|row| row.bar.is_some()).collect();
    assert_eq!(held.len(), 2);
    assert!(held.iter().all(|row| row.verdict == CrossVerdict::Agrees), "{held:?}");
    // Where no chain comes close enough, nothing is compared, and the reason names the mount.
    let check = crosscheck(&engine, &traces, &ask(84.0)).unwrap();
    let reason = check.conditions[0].not_applicable.as_ref().expect("a hydraulic mount at idle");
    assert!(reason.contains("engine side") && reason.contains("%"), "{reason}");
}

/// The generator set of the examples has all that the four conditions need. What the free speed changes is what its first-order estimate says, but for the square
/// of the fluctuation; what both causes leave of condition D is small beside them.
#[test]
fn xcheck_all_conditions_of_the_generator_set() {
    let (engine, traces) =
        examples().into_iter().find(|(engine, _)| engine.name.starts_with("Generator set")).unwrap();
    let request = CrossCheckRequest { speed: Some(1500.0 * PI / 30.0), ..CrossCheckRequest::default() };
    let check = crosscheck(&engine, &traces, &request).unwrap();
    assert!(check.agrees());
    for condition in &check.conditions {
        assert_eq!(condition.not_applicable, None, "{:?}", condition.condition);
    }
    let of = |wanted: Condition| check.conditions.iter().find(|own| own.condition == wanted).unwrap();
    let couple = of(Condition::FreeSpeed).rows.iter().find(|row| row.quantity.starts_with("couple")).unwrap();
    assert!(couple.difference > 1e-4 * couple.scale, "the fluctuation shows: {couple:?}");
    let (_, left) = couple.reason.as_ref().unwrap().rsplit_once("which leaves ").unwrap();
    let left: f64 = left.trim_end_matches(" N m").parse().unwrap();
    assert!(left < 0.05 * couple.difference, "the estimate holds: {couple:?}");
    let free: Vec<_> = of(Condition::AllFree).rows.iter().filter(|row| row.closed_form.is_some()).collect();
    assert!(free.iter().any(|row| row.unit == "rad" && row.order == Some(1.5)), "the firing order rolls it");
    for row in free {
        assert!(row.difference < 0.05 * row.scale, "{row:?}");
    }
}

/// The bond graph follows the multibody simulation of an engine with gas, balance shaft and mounts.
#[test]
fn xcheck_bond_graph() {
    let text = include_str!("../../../../examples/three-cylinder.toml");
    let engine = read(text).engine().expect("the example has no mistakes");
    let request = CrossCheckRequest { conditions: vec![Condition::AllFree], ..CrossCheckRequest::default() };
    let found = crosscheck(&engine, &[], &request).unwrap();
    let condition = &found.conditions[0];
    assert_eq!(condition.not_applicable, None);
    let rows: Vec<_> = condition.rows.iter().filter(|row| row.bond_graph.is_some()).collect();
    assert_eq!(rows.len(), 4);
    for row in rows {
        assert!(row.bond_graph.unwrap() > 0.0 && row.closed_form.is_none(), "{row:?}");
        assert_eq!(row.verdict, CrossVerdict::Agrees, "{row:?}");
    }
}

/// Condition A holds the gas as states against the cycle.
#[test]
fn xcheck_gas_of_the_bond_graph() {
    let engine = read(include_str!("../../../../examples/three-cylinder.toml")).engine().unwrap();
    let request =
        CrossCheckRequest { conditions: vec![Condition::LikeForLike], ..CrossCheckRequest::default() };
    let check = crosscheck(&engine, &[], &request).unwrap();
    let row = |name: &str| -> CrossRow {
        let rows = &check.conditions[0].rows;
        rows.iter().find(|row| row.quantity.contains(name)).unwrap_or_else(|| panic!("{name}")).clone()
    };
    let gas = row("gas as states");
    for name in ["force", "couple", "roll moment", "shaft torque"] {
        let load = row(&format!("{name}, bond graph"));
        assert!(load.bond_graph.is_some_and(|own| own > 0.0), "{load:?}");
        assert!(load.order.is_none() && load.verdict == CrossVerdict::Agrees, "{load:?}");
    }
    assert!(gas.bond_graph.is_some() && gas.share() < 1e-6 && gas.verdict == CrossVerdict::Agrees, "{gas:?}");
}
