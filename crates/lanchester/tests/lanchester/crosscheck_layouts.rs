//! Every opinion on every load of the twin thesis's engines with their arrangements, and of radial engines with gas on mounts.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::file::{complete, read, template};
use lanchester::literature::{ArrangementOptions, TwinArrangement, arranged};
use lanchester::model::{Engine, Flywheel};
use lanchester::report::{Condition, CrossCheck, CrossRow, CrossVerdict};
use lanchester::{CrossCheckRequest, TraceFile, crosscheck, trace_names};
use std::fs;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

/// Nothing disagrees, and these conditions apply, no others.
fn agrees(engine: &Engine, traces: &[TraceFile], conditions: &[Condition]) -> CrossCheck {
    let check = crosscheck(engine, traces, &CrossCheckRequest::default())
        .unwrap_or_else(|error| panic!("{}: {error}", engine.name));
    for condition in &check.conditions {
        let wanted = conditions.contains(&condition.condition);
        assert_eq!(
            condition.not_applicable.is_none(),
            wanted,
            "{}: {:?}",
            engine.name,
            condition.not_applicable
        );
        for row in &condition.rows {
            assert_ne!(row.verdict, CrossVerdict::Disagrees, "{}: {row:?}", engine.name);
        }
    }
    assert!(check.agrees());
    check
}

/// Largest size of the force of the closed form over the cycle [N], which the simulation has too.
fn force(check: &CrossCheck) -> f64 {
    let row = check.conditions[0].rows.iter().find(|row| row.quantity == "force" && row.order.is_none());
    row.unwrap().multibody
}

/// Block, flywheel and mounts for an engine that its file describes without.
fn mounted(text: &str, mass: f64) -> String {
    let mut text = format!(
        "{text}\n[flywheel]\ninertia = \"0.4 kg m2\"\ncrankshaft_inertia = \"0.05 kg m2\"\n\n[block]\nmass = \"{mass} kg\"\ncentre = [\"40 mm\", \"10 mm\", \"60 mm\"]\ninertia = [\"{} kg m2\", \"{} kg m2\", \"{} kg m2\"]\n",
        0.08 * mass,
        0.07 * mass,
        0.05 * mass
    );
    for (place, [y, z]) in [[250, 300], [-250, 280], [220, -250], [-250, -270]].into_iter().enumerate() {
        text += &format!(
            "\n[[mount]]\nname = \"mount {place}\"\nx = \"-150 mm\"\ny = \"{y} mm\"\nz = \"{z} mm\"\nstiffness = [\"{} N/mm\", \"{} N/mm\", \"{} N/mm\"]\ndamping = \"400 N s/m\"\n",
            mass,
            0.6 * mass,
            0.5 * mass
        );
    }
    text
}

/// The four in-line twins of the thesis (in phase and out of phase, longer and shorter stroke) as the examples have them, basic crank, and each in all nine
/// arrangements of crank and shafts.
#[test]
fn xcheck_in_line_twins_of_the_thesis() {
    let mut largest = Vec::new();
    for name in ["in-phase", "in-phase-shorter", "out-of-phase", "out-of-phase-shorter"] {
        let path = folder("examples").join(format!("twin-in-line-{name}.toml"));
        let engine = read(&fs::read_to_string(path).unwrap()).engine().unwrap();
        largest.push(force(&agrees(&engine, &[], &[Condition::LikeForLike])));
        for arrangement in TwinArrangement::ALL {
            let own = arranged(&engine, arrangement, &ArrangementOptions::of_thesis()).unwrap();
            assert_eq!(own.shafts.is_empty(), arrangement.number() < 3, "{}", arrangement.name());
            agrees(&own, &[], &[Condition::LikeForLike]);
        }
    }
    // Pins in line add the first order that opposed pins cancel.
    assert!(largest[0] > 3.0 * largest[2] && largest[1] > 3.0 * largest[3], "{largest:?}");
    assert!(largest[0] > 1.05 * largest[1], "the longer stroke shakes more: {largest:?}");
}

/// The same four under full load with the synthetic traces that fit the thesis, with a flywheel and on mounts: all conditions.
#[test]
fn xcheck_in_line_twins_of_the_thesis_under_load() {
    let all = [Condition::LikeForLike, Condition::FreeSpeed, Condition::MovingBlock, Condition::AllFree];
    for name in ["in-phase-longer", "in-phase-shorter", "out-of-phase-longer", "out-of-phase-shorter"] {
        let folder = folder("validation/traces");
        let text = fs::read_to_string(folder.join(format!("{name}.toml"))).unwrap();
        let engine = read(&mounted(&text, 120.0)).engine().unwrap();
        let trace = |name: &str| TraceFile {
            name: name.into(),
            text: fs::read_to_string(folder.join(name)).unwrap(),
        };
        let traces: Vec<_> = trace_names(&engine).into_iter().map(trace).collect();
        assert_eq!(traces.len(), 4);
        agrees(&engine, &traces, &all);
    }
}

/// A radial engine with gas, flywheel, block and mounts.
fn radial(cylinders: usize, mass: f64) -> Engine {
    let text = template(&format!("radial-{cylinders}")).unwrap().text;
    let gas = "[gas]\ncompression_ratio = 6.5\ncycle = { type = \"otto\" }\nfuel = { energy = \"2 kJ\" }";
    read(&format!("{}\n{gas}\n", mounted(text, mass))).engine().unwrap()
}

/// What rings in the joint of one articulated rod rings in all on its master rod: no sample behind a step of any pressure on it counts.
#[test]
fn xcheck_radial_engines_with_gas() {
    let all = [Condition::LikeForLike, Condition::FreeSpeed, Condition::MovingBlock, Condition::AllFree];
    for cylinders in [3, 5] {
        let check = agrees(&radial(cylinders, 600.0), &[], &all);
        let rows = &check.conditions[0].rows;
        let joints: Vec<&CrossRow> =
            rows.iter().filter(|row| row.quantity.ends_with("bond graph with compliant joints")).collect();
        assert_eq!(joints.len(), 3);
        for row in joints {
            // Compliance alone: the square of the order over the stiffness, far below the bar.
            assert!(row.share() < 1e-3 && row.multibody > 1e3, "{row:?}");
        }
    }
}

/// The same of nine cylinders on soft mounts, whose moving masses count with their square too.
#[test]
fn xcheck_heavy_radial_on_soft_mounts() {
    let mut engine = radial(9, 800.0);
    engine = engine
        .with(|parts| {
            parts.flywheel =
                Some(Flywheel { inertia: Some(3.0), crankshaft_inertia: Some(0.3), ..Flywheel::default() });
            for spring in parts.mounts.iter_mut().filter_map(|mount| mount.spring.as_mut()) {
                spring.stiffness = spring.stiffness.map(|own| 0.0125 * own);
            }
        })
        .unwrap();
    let request =
        CrossCheckRequest { conditions: vec![Condition::MovingBlock], ..CrossCheckRequest::default() };
    let check = crosscheck(&engine, &[], &request).unwrap();
    let held: Vec<_> = check.conditions[0].rows.iter().filter(|row| row.bar.is_some()).collect();
    assert_eq!(held.len(), 2);
    for row in &held {
        assert_eq!(row.verdict, CrossVerdict::Agrees, "{row:?}");
        assert!((row.multibody - 2.0).abs() < 0.01, "{row:?}");
    }
    // Of the gas the plain ratio is off: its row says what was taken out.
    let reason = held[1].reason.as_ref().unwrap();
    assert!(reason.starts_with("without what goes with the square of the moving mass"), "{reason}");
}

/// Where inertia hardly moves the block, what is rounding of it is held against nothing, and no step of a run follows it: a V12's momentum along the crank stays
/// below a ten-millionth of that across.
#[test]
fn xcheck_engines_that_hardly_shake() {
    for (name, conditions) in
        [("flat-12", [Condition::MovingBlock].as_slice()), ("v12-60", &[Condition::AllFree])]
    {
        let completed = complete(template(name).unwrap().text, &[], None).unwrap();
        let engine = read(&completed.text).engine().unwrap();
        let request = CrossCheckRequest { conditions: conditions.to_vec(), ..CrossCheckRequest::default() };
        let check = crosscheck(&engine, &[], &request).unwrap();
        assert_eq!(check.conditions[0].not_applicable, None, "{name}");
        assert!(check.agrees(), "{name}: {:?}", check.conditions[0].rows);
    }
}
