//! The crank train that other programs step through, against one run of the simulation.

use lanchester::file::EngineFile;
use lanchester::{CrankTrainFault, CrankTrainModel, CrankTrainState, RunLength, SimulateRequest, simulate};

fn file(text: &str) -> EngineFile {
    lanchester::file::read(text).file.unwrap()
}

const GENERATOR: &str = include_str!("../../../../examples/generator-set-3.toml");

fn outputs(model: &mut CrankTrainModel, state: &CrankTrainState) -> Vec<(String, f64)> {
    let names = model.variables().into_iter().skip(CrankTrainModel::FIRST_OUTPUT as usize);
    let values = model.outputs(state).unwrap();
    assert_eq!(names.len(), values.len());
    names.map(|own| own.name).zip(values).collect()
}

/// The engine without what runs it: it turns at its highest speed against the mean torque of its gas.
fn engine() -> &'static str {
    GENERATOR.split_once("# The generator is bolted").unwrap().0
}

/// The story of the generator set from rest: the starter, the first compressions over time, the switch to the angle, events: step by step as in one run.
#[test]
fn the_generator_set_starts_as_in_one_run() {
    let file = file(GENERATOR);
    let end = 1.6;
    // From rest a run at the tolerance of the file is itself ten times that off the truth.
    let length = Some(RunLength::Time(end));
    let request = SimulateRequest { length, tolerance: Some(1e-12), ..SimulateRequest::default() };
    let run = simulate(&file, &[], &request).unwrap().run;
    let mut model = CrankTrainModel::new(&file, &[]).unwrap();
    let mut state = model.state();
    assert_eq!(state.inputs.load, 0.0);
    let mut said = Vec::new();
    for k in 1..=1600 {
        let step = model.advance(&mut state, end * f64::from(k) / 1600.0).unwrap();
        assert!(!step.is_stopped);
        said.extend(step.happened);
    }
    assert!(said.len() >= 3 && said[0].contains("fuel 0 %"), "{said:?}");
    assert_eq!(said.len(), run.events.len(), "{said:?} {:?}", run.events);
    let own = outputs(&mut model, &state);
    let value = |name: &str| own.iter().find(|(own, _)| own == name).unwrap().1;
    let tolerance = 10.0 * 1e-9;
    assert!((value("crank_angle") / run.end[1] - 1.0).abs() < tolerance, "{} {:?}", own[0].1, run.end);
    assert!((value("speed") / run.end[2] - 1.0).abs() < tolerance, "{} {:?}", value("speed"), run.end);
    // The mounts carry the weight.
    let carried: f64 = (1..=4).map(|mount| value(&format!("mount_{mount}_force_x"))).sum();
    assert!((carried / -(190.0 * 9.80665) - 1.0).abs() < 0.2, "{carried}");
}

/// Without a load in the file the input has it, from the start on the torque that a run takes; on top of the start's conditions it acts as any load.
#[test]
fn the_input_is_the_load_where_the_file_gives_none() {
    let file = file(engine());
    let request = SimulateRequest { length: Some(RunLength::Time(0.2)), ..SimulateRequest::default() };
    let run = simulate(&file, &[], &request).unwrap().run;
    let mut model = CrankTrainModel::new(&file, &[]).unwrap();
    let mut state = model.state();
    assert!((state.inputs.load / -run.samples.load_torque[0] - 1.0).abs() < 1e-12);
    let start = outputs(&mut model, &state);
    for (own, wanted) in [
        (start[0].1, run.samples.theta[0]),
        (start[2].1, run.samples.acceleration[0]),
        (start[3].1, run.samples.gas_torque[0]),
        (start[4].1, run.samples.load_torque[0]),
    ] {
        assert!((own - wanted).abs() <= 1e-9 * wanted.abs().max(1.0), "{own} {wanted}");
    }
    for k in 1..=100 {
        model.advance(&mut state, 0.002 * f64::from(k)).unwrap();
    }
    let end = outputs(&mut model, &state);
    let tolerance = 10.0 * run.tolerances.relative;
    assert!((end[0].1 / run.end[1] - 1.0).abs() < tolerance, "{} {:?}", end[0].1, run.end);
    assert!((end[1].1 / run.end[2] - 1.0).abs() < tolerance, "{} {:?}", end[1].1, run.end);
}

/// What stops, what cannot be, and what a state is after it.
#[test]
fn stops_and_refusals_leave_a_good_state() {
    let text = format!("{}\n[[simulation.event]]\nwhen = \"15 ms\"\ndo = \"stop\"\n", engine());
    let mut model = CrankTrainModel::new(&file(&text), &[]).unwrap();
    let mut state = model.state();
    let step = model.advance(&mut state, 0.1).unwrap();
    assert!(step.is_stopped && (step.time - 0.015).abs() < 1e-9 && step.time == state.time());
    assert_eq!(step.happened.len(), 1, "{:?}", step.happened);
    let before = state.clone();
    state.inputs.load = f64::NAN;
    assert!(model.advance(&mut state, 0.2).is_err() && model.outputs(&state).is_err());
    state.inputs.load = 1e300;
    let fault = model.advance(&mut state, 0.2).unwrap_err();
    assert!(matches!(fault, CrankTrainFault::Failed { .. }), "{fault:?}");
    assert!(fault.to_string().contains("crank angle"), "{fault}");
    state.inputs.load = before.inputs.load;
    assert_eq!(state, before);
    assert!(model.advance(&mut state, 0.01).is_err(), "a step backwards");
    assert_eq!(state, before);
    // Free speed needs the inertia of the crankshaft.
    let (before, rest) = engine().split_once("[flywheel]").unwrap();
    let text = format!("{before}{}", &rest[rest.find("# Engine, generator").unwrap()..]);
    let refused = CrankTrainModel::new(&file(&text), &[]).err().unwrap().to_string();
    assert!(refused.contains("moment of inertia"), "{refused}");
}
