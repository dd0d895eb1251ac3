//! The crank train at free speed: both standards against one run of the simulation, states, stops, and what a program should not do.

use crate::{SAID, instance2, instance3, numbers, resources};
use lanchester::{CrankTrainModel, RunLength, SimulateRequest, UnitKind, simulate, unit_token};
use lanchester_fmu::fmi2::*;
use lanchester_fmu::fmi3::*;
use lanchester_fmu::handle::{DISCARD, ERROR, OK};
use std::ffi::c_void;
use std::ptr::null_mut;

const ENGINE: &str = include_str!("../../../../examples/generator-set-3.toml");
const LOAD: u32 = CrankTrainModel::LOAD_TORQUE;
const FUEL: u32 = CrankTrainModel::FUEL;
const ANGLE: u32 = CrankTrainModel::FIRST_OUTPUT;
const SPEED: u32 = ANGLE + 1;

/// The generator set on its mounts without governor, starter and events: it turns at its highest speed.
fn plain() -> &'static str {
    ENGINE.split_once("# The generator is bolted").unwrap().0
}

fn token(text: &str) -> String {
    unit_token(UnitKind::CrankTrain, text)
}

fn set(unit: *mut c_void, reference: u32, value: f64) -> i32 {
    // SAFETY: one reference and one value.
    unsafe { fmi2SetReal(unit, &reference, 1, &value) }
}

/// An instance of FMI 2 that runs.
fn running(name: &str, text: &str) -> *mut c_void {
    let unit = instance2(&resources(name, text), &token(text));
    assert!(!unit.is_null());
    // SAFETY: an instance.
    unsafe {
        assert_eq!(fmi2SetupExperiment(unit, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(fmi2EnterInitializationMode(unit), OK);
        assert_eq!(fmi2ExitInitializationMode(unit), OK);
    }
    unit
}

fn step(unit: *mut c_void, now: f64, step: f64) -> i32 {
    // SAFETY: an instance.
    unsafe { fmi2DoStep(unit, now, step, 1) }
}

#[test]
fn both_standards_step_through_one_run() {
    let text = plain();
    let file = lanchester::file::read(text).file.unwrap();
    let end = 0.15;
    let request = SimulateRequest { length: Some(RunLength::Time(end)), ..SimulateRequest::default() };
    let run = simulate(&file, &[], &request).unwrap().run;
    let two = running("crank-two", text);
    let three = instance3(&resources("crank-three", text), &token(text));
    assert!(!three.is_null());
    // Time starts elsewhere: the run counts from there.
    let start = 7.0;
    // SAFETY: an instance.
    unsafe {
        assert_eq!(fmi3EnterInitializationMode(three, 0, 0.0, start, 0, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(three), OK);
    }
    let count = CrankTrainModel::new(&file, &[]).unwrap().variables().len() as u32;
    let references: Vec<u32> = (1..count).collect();
    let steps = 150;
    let (mut flags, mut last) = ([9u8; 3], 0.0f64);
    for k in 0..steps {
        let size = end / f64::from(steps);
        assert_eq!(step(two, size * f64::from(k), size), OK);
        let [event, terminate, early] = &mut flags;
        // SAFETY: places of flags and a number.
        unsafe {
            let now = start + size * f64::from(k);
            assert_eq!(fmi3DoStep(three, now, size, 1, event, terminate, early, &mut last), OK);
        }
        assert_eq!(flags, [0; 3]);
    }
    let found = numbers(two, &references);
    let mut again = vec![0.0; references.len()];
    // SAFETY: arrays of one length.
    unsafe {
        let count = references.len();
        assert_eq!(fmi3GetFloat64(three, references.as_ptr(), count, again.as_mut_ptr(), count), OK);
    }
    // Times of the two differ by rounding.
    for (own, other) in found.iter().zip(&again) {
        assert!((own - other).abs() <= 1e-7 * own.abs().max(1.0), "{own} {other}");
    }
    let at = |reference: u32| found[reference as usize - 1];
    let tolerance = 10.0 * run.tolerances.relative;
    assert!((at(ANGLE) / run.end[1] - 1.0).abs() < tolerance, "{} {:?}", at(ANGLE), run.end);
    assert!((at(SPEED) / run.end[2] - 1.0).abs() < tolerance, "{} {:?}", at(SPEED), run.end);
    // SAFETY: instances.
    unsafe {
        fmi2FreeInstance(two);
        fmi3FreeInstance(three);
    }
}

#[test]
fn inputs_act_and_a_saved_state_comes_back_to_the_bit() {
    let unit = running("crank-state", plain());
    let count = numbers(unit, &[0]).len();
    assert_eq!(count, 1);
    let all = [0, LOAD, FUEL, ANGLE, SPEED, SPEED + 1, SPEED + 3];
    assert_eq!(step(unit, 0.0, 0.02), OK);
    let mut state = null_mut();
    // SAFETY: a place for a handle.
    assert_eq!(unsafe { fmi2GetFMUstate(unit, &mut state) }, OK);
    let here = numbers(unit, &all);
    let go = |load: f64, fuel: f64| {
        // SAFETY: a state of this unit.
        assert_eq!(unsafe { fmi2SetFMUstate(unit, state) }, OK);
        assert_eq!(numbers(unit, &all), here);
        assert_eq!((set(unit, LOAD, load), set(unit, FUEL, fuel)), (OK, OK));
        (0..20).for_each(|k| assert_eq!(step(unit, 0.02 + 0.005 * f64::from(k), 0.005), OK));
        numbers(unit, &all)
    };
    let first = go(50.0, 1.0);
    let heavy = go(90.0, 1.0);
    let lean = go(50.0, 0.2);
    assert_eq!(go(50.0, 1.0), first);
    assert!(heavy[4] < first[4] - 1.0 && lean[4] < first[4] - 1.0, "{first:?} {heavy:?} {lean:?}");
    // The state of another unit is refused.
    let other = running("crank-other", ENGINE);
    // SAFETY: handles that live.
    unsafe {
        assert_eq!(fmi2SetFMUstate(other, state), ERROR);
        assert_eq!(fmi2FreeFMUstate(unit, &mut state), OK);
        // As when it was made.
        assert_eq!(fmi2Reset(unit), OK);
        assert_eq!(fmi2EnterInitializationMode(unit), OK);
        assert_eq!(fmi2ExitInitializationMode(unit), OK);
        assert_eq!(step(unit, 0.0, 0.02), OK);
        assert_eq!(numbers(unit, &all), here);
        fmi2FreeInstance(unit);
        fmi2FreeInstance(other);
    }
}

/// The file's event stops the run: FMI 2 discards the rest of the step and says where it got to, FMI 3 asks to end.
#[test]
fn an_event_of_the_file_stops_the_run() {
    let text = format!("{}\n[[simulation.event]]\nwhen = \"12 ms\"\ndo = \"stop\"\n", plain());
    let unit = running("crank-stop", &text);
    let (mut time, mut stopped) = (0.0, 9);
    // SAFETY: places of one value.
    unsafe {
        assert_eq!(step(unit, 0.0, 0.01), OK);
        assert_eq!(fmi2GetBooleanStatus(unit, 3, &mut stopped), OK);
        assert_eq!(stopped, 0);
        assert_eq!(step(unit, 0.01, 0.01), DISCARD);
        assert_eq!(fmi2GetRealStatus(unit, 2, &mut time), OK);
        assert_eq!(fmi2GetBooleanStatus(unit, 3, &mut stopped), OK);
        assert!((time - 0.012).abs() < 1e-9 && stopped == 1, "{time} {stopped}");
        assert_eq!(fmi2GetBooleanStatus(unit, 1, &mut stopped), ERROR);
        assert_eq!(step(unit, time, 0.01), ERROR);
        fmi2FreeInstance(unit);
    }
    let unit = instance3(&resources("crank-stop-3", &text), &token(&text));
    let (mut flags, mut last) = ([9u8; 3], 0.0f64);
    let [event, terminate, early] = &mut flags;
    // SAFETY: places of flags and a number.
    unsafe {
        assert_eq!(fmi3EnterInitializationMode(unit, 0, 0.0, 1.0, 0, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(unit), OK);
        assert_eq!(fmi3DoStep(unit, 1.0, 0.05, 1, event, terminate, early, &mut last), OK);
        fmi3FreeInstance(unit);
    }
    assert_eq!(flags, [0, 1, 0]);
    assert!((last - 1.012).abs() < 1e-9, "{last}");
    assert!(SAID.lock().unwrap().iter().any(|line| line.contains("event 1: stop")));
}

#[test]
fn what_a_program_should_not_do_is_an_error_with_its_reason() {
    let unit = instance3(&resources("crank-hostile", plain()), &token(plain()));
    let set = |reference: u32, value: f64| {
        // SAFETY: one reference and one value.
        unsafe { fmi3SetFloat64(unit, &reference, 1, &value, 1) }
    };
    let start_speed = CrankTrainModel::START_SPEED;
    for (reference, value) in [
        (LOAD, f64::NAN),
        (FUEL, 1.5),
        (FUEL, -0.1),
        (start_speed, -1.0),
        (ANGLE, 1.0),
        (0, 1.0),
        (4000, 1.0),
    ] {
        assert_eq!(set(reference, value), ERROR, "{reference} {value}");
    }
    let go = |now: f64, step: f64| {
        // SAFETY: null is no place, which the standard forbids and the unit allows.
        unsafe { fmi3DoStep(unit, now, step, 0, null_mut(), null_mut(), null_mut(), null_mut()) }
    };
    assert_eq!(go(0.0, 0.1), ERROR);
    // SAFETY: an instance.
    unsafe {
        assert_eq!(fmi3EnterInitializationMode(unit, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(set(start_speed, 120.0), OK);
        assert_eq!(fmi3ExitInitializationMode(unit), OK);
    }
    assert_eq!(numbers3(unit, &[SPEED]), [120.0]);
    assert_eq!(set(start_speed, 130.0), ERROR);
    assert_eq!(go(0.0, 0.01), OK);
    let before = numbers3(unit, &[0, ANGLE, SPEED]);
    // A step that fails leaves time and state, and the next one may succeed.
    let load = numbers3(unit, &[LOAD])[0];
    assert_eq!(set(LOAD, -1e300), OK);
    assert_eq!(go(0.01, 0.01), ERROR);
    assert_eq!(set(LOAD, load), OK);
    assert_eq!(numbers3(unit, &[0, ANGLE, SPEED]), before);
    for (now, step) in [(0.0, 0.01), (0.01, -0.01), (0.01, f64::NAN)] {
        assert_eq!(go(now, step), ERROR, "{now} {step}");
    }
    assert_eq!(go(0.01, 0.0), OK);
    assert_eq!(numbers3(unit, &[0, ANGLE, SPEED]), before);
    assert_eq!(go(0.01, 0.01), OK);
    // SAFETY: an instance.
    unsafe { fmi3FreeInstance(unit) };
    // An engine without what free speed needs.
    let (before, rest) = plain().split_once("[flywheel]").unwrap();
    let text = format!("{before}{}", &rest[rest.find("# Engine, generator").unwrap()..]);
    assert!(instance3(&resources("crank-no-inertia", &text), &token(&text)).is_null());
    let said = SAID.lock().unwrap();
    for words in [
        "load_torque must be a finite number",
        "fuel must be from 0 to 1, and is 1.5",
        "start_speed must be 0 rad/s or more",
        "start_speed is a parameter",
        "the step begins at 0 s",
        "moment of inertia",
    ] {
        assert!(said.iter().any(|line| line.contains(words)), "{words}: {said:?}");
    }
}

/// Numbers of an instance of FMI 3.
fn numbers3(unit: *mut c_void, references: &[u32]) -> Vec<f64> {
    let mut values = vec![f64::NAN; references.len()];
    let count = references.len();
    // SAFETY: arrays of one length.
    let status = unsafe { fmi3GetFloat64(unit, references.as_ptr(), count, values.as_mut_ptr(), count) };
    assert_eq!(status, OK);
    values
}
