//! The unit as a program would use it: through the functions of both standards, by their C names, and as a program should not.

#![allow(unsafe_code, reason = "functions of C")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod crank_train;

use lanchester::{LoadsModel, UNIT_ENGINE, UnitKind, unit_token};
use lanchester_fmu::fmi2::*;
use lanchester_fmu::fmi3::*;
use lanchester_fmu::handle::{ERROR, OK};
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::PathBuf;
use std::ptr::{null, null_mut};
use std::sync::Mutex;

const ENGINE: &str = include_str!("../../../../examples/v6-60.toml");

/// A folder of resources with this engine file.
fn resources(name: &str, text: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(UNIT_ENGINE), text).unwrap();
    folder
}

fn c(text: &str) -> CString {
    CString::new(text).unwrap()
}

/// What units said, as "status message".
static SAID: Mutex<Vec<String>> = Mutex::new(Vec::new());

unsafe extern "C" fn keep(_: *mut c_void, status: i32, _: *const c_char, message: *const c_char) {
    // SAFETY: messages end with a zero.
    let message = unsafe { CStr::from_ptr(message) }.to_string_lossy().into_owned();
    SAID.lock().unwrap().push(format!("{status} {message}"));
}

fn instance3(folder: &std::path::Path, token: &str) -> *mut c_void {
    let (name, token, path) = (c("unit"), c(token), c(folder.to_str().unwrap()));
    // SAFETY: strings that live through the call.
    unsafe {
        fmi3InstantiateCoSimulation(
            name.as_ptr(),
            token.as_ptr(),
            path.as_ptr(),
            0,
            1,
            0,
            0,
            null(),
            0,
            null_mut(),
            Some(keep),
            null(),
        )
    }
}

fn instance2(folder: &std::path::Path, token: &str) -> *mut c_void {
    let (name, token, address) = (c("unit"), c(token), c(&format!("file://{}", folder.display())));
    // SAFETY: strings that live through the call; a unit without callbacks is silent.
    unsafe { fmi2Instantiate(name.as_ptr(), 1, token.as_ptr(), address.as_ptr(), null(), 0, 0) }
}

/// Numbers of an instance of FMI 2.
fn numbers(unit: *mut c_void, references: &[u32]) -> Vec<f64> {
    let mut values = vec![f64::NAN; references.len()];
    // SAFETY: arrays of one length.
    let status = unsafe { fmi2GetReal(unit, references.as_ptr(), references.len(), values.as_mut_ptr()) };
    assert_eq!(status, OK);
    values
}

#[test]
fn both_standards_step_to_the_loads_of_the_closed_form() {
    let folder = resources("steps", ENGINE);
    let token = unit_token(UnitKind::Loads, ENGINE);
    let (two, three) = (instance2(&folder, &token), instance3(&folder, &token));
    assert!(!two.is_null() && !three.is_null());
    let engine = lanchester::file::read(ENGINE).engine().unwrap();
    let mut model = LoadsModel::new(engine, Vec::new()).unwrap();
    let (speed, start, step) = (300.0f64, 0.3f64, 1e-4);
    // SAFETY: arrays of the lengths that are told.
    unsafe {
        assert_eq!(fmi2SetupExperiment(two, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(fmi2SetReal(two, [1u32, 3].as_ptr(), 2, [speed, start].as_ptr()), OK);
        assert_eq!(fmi2EnterInitializationMode(two), OK);
        assert_eq!(fmi2ExitInitializationMode(two), OK);
        assert_eq!(fmi3SetFloat64(three, [1u32, 3].as_ptr(), 2, [speed, start].as_ptr(), 2), OK);
        assert_eq!(fmi3EnterInitializationMode(three, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(three), OK);
    }
    let references: Vec<u32> = (LoadsModel::CRANK_ANGLE..LoadsModel::FIRST_LOAD + 6).collect();
    for count in 0..500 {
        let theta = start + speed * step * f64::from(count);
        let wanted = model.at(speed, theta, false).unwrap();
        let found = numbers(two, &references);
        assert!((found[0] - theta).abs() < 1e-12, "{} {theta}", found[0]);
        let largest = wanted.iter().fold(0.0f64, |size, load| size.max(load.abs()));
        for (own, wanted) in found[1..].iter().zip(&wanted) {
            assert!((own - wanted).abs() <= 1e-10 * largest, "{own} {wanted}");
        }
        let mut again = vec![0.0; references.len()];
        let (mut flags, mut last) = ([9u8; 3], 0.0f64);
        let [event, end, early] = &mut flags;
        // SAFETY: as above.
        unsafe {
            let count = references.len();
            assert_eq!(fmi3GetFloat64(three, references.as_ptr(), count, again.as_mut_ptr(), count), OK);
            assert_eq!(again, found);
            let now = numbers(two, &[0])[0];
            assert_eq!(fmi2DoStep(two, now, step, 1), OK);
            assert_eq!(fmi3DoStep(three, now, step, 1, event, end, early, &mut last), OK);
        }
        assert_eq!((flags, last), ([0; 3], numbers(two, &[0])[0]));
    }
    // SAFETY: instances.
    unsafe {
        assert_eq!(fmi2Terminate(two), OK);
        fmi2FreeInstance(two);
        fmi3FreeInstance(three);
    }
}

#[test]
fn a_saved_state_comes_back() {
    let folder = resources("states", ENGINE);
    let unit = instance2(&folder, &unit_token(UnitKind::Loads, ENGINE));
    // SAFETY: handles and arrays as the standard has them.
    unsafe {
        assert_eq!(fmi2EnterInitializationMode(unit), OK);
        assert_eq!(fmi2ExitInitializationMode(unit), OK);
        assert_eq!(fmi2DoStep(unit, 0.0, 0.01, 1), OK);
        let before = numbers(unit, &[0, 4, 5, 10]);
        let mut state = null_mut();
        assert_eq!(fmi2GetFMUstate(unit, &mut state), OK);
        assert_eq!(fmi2DoStep(unit, 0.01, 0.01, 1), OK);
        assert_ne!(numbers(unit, &[0, 4, 5, 10]), before);
        assert_eq!(fmi2SetFMUstate(unit, state), OK);
        assert_eq!(numbers(unit, &[0, 4, 5, 10]), before);
        assert_eq!(fmi2FreeFMUstate(unit, &mut state), OK);
        assert!(state.is_null());
        // Freed, none, or an instance where a state is due.
        assert_eq!(fmi2SetFMUstate(unit, state), ERROR);
        assert_eq!(fmi2SetFMUstate(unit, unit), ERROR);
        fmi2FreeInstance(unit);
    }
}

#[test]
fn a_step_that_cannot_be_leaves_time_and_angle() {
    // A cycle with heat release needs a speed.
    let text = include_str!("../../../../examples/single-gas.toml");
    let unit = instance2(&resources("standstill", text), &unit_token(UnitKind::Loads, text));
    // SAFETY: one reference and one value.
    unsafe {
        assert_eq!(fmi2EnterInitializationMode(unit), OK);
        assert_eq!(fmi2ExitInitializationMode(unit), OK);
        assert_eq!(fmi2DoStep(unit, 0.0, 0.01, 1), OK);
        let before = numbers(unit, &[0, 4]);
        assert_eq!(fmi2SetReal(unit, &1u32, 1, &0.0), OK);
        assert_eq!(fmi2DoStep(unit, 0.01, 0.01, 1), ERROR);
        assert_eq!(numbers(unit, &[0, 4]), before);
        assert_eq!(fmi2SetBoolean(unit, &2u32, 1, &0), OK);
        assert_eq!(fmi2DoStep(unit, 0.01, 0.01, 1), OK);
        fmi2FreeInstance(unit);
    }
}

#[test]
fn what_a_program_should_not_do_is_an_error_and_no_crash() {
    let folder = resources("hostile", ENGINE);
    let token = unit_token(UnitKind::Loads, ENGINE);
    let unit = instance3(&folder, &token);
    let mut value = [0.0f64];
    // SAFETY: wrong arguments are what is tried; the memory that is named is there.
    unsafe {
        // Before its time, with wrong references and values.
        assert_eq!(fmi3DoStep(unit, 0.0, 0.1, 0, null_mut(), null_mut(), null_mut(), null_mut()), ERROR);
        for reference in [2u32, 11, u32::MAX] {
            assert_eq!(fmi3GetFloat64(unit, &reference, 1, value.as_mut_ptr(), 1), ERROR);
        }
        for (reference, value) in [(1u32, f64::NAN), (1, -1.0), (1, f64::INFINITY), (4, 1.0), (99, 1.0)] {
            assert_eq!(fmi3SetFloat64(unit, &reference, 1, &value, 1), ERROR, "{reference} {value}");
        }
        assert_eq!(fmi3SetBoolean(unit, &2u32, 1, &1u8, 1), ERROR);
        assert_eq!(fmi3GetFloat64(unit, null(), 1, value.as_mut_ptr(), 1), ERROR);
        assert_eq!(fmi3GetFloat64(unit, &1u32, 1, null_mut(), 1), ERROR);
        assert_eq!(fmi3GetFloat64(unit, &1u32, 1, value.as_mut_ptr(), 0), ERROR);
        assert_eq!(fmi3EnterInitializationMode(unit, 0, 0.0, f64::NAN, 0, 0.0), ERROR);
        assert_eq!(fmi3GetInt32(unit, &1u32, 1), ERROR);
        assert_eq!(fmi3GetInt32(unit, null(), 0), OK);
        assert_eq!(fmi3SerializedFMUStateSize(unit), ERROR);
        fmi3Reset(unit);
        assert_eq!(fmi3EnterInitializationMode(unit, 0, 0.0, 5.0, 0, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(unit), OK);
        // Another time than the present one, backwards, without end; the start angle is too late.
        for (now, step) in [(0.0, 0.1), (5.0, -0.1), (5.0, f64::NAN), (f64::NAN, 0.1), (5.0, f64::INFINITY)] {
            let status = fmi3DoStep(unit, now, step, 0, null_mut(), null_mut(), null_mut(), null_mut());
            assert_eq!(status, ERROR, "{now} {step}");
        }
        assert_eq!(fmi3SetFloat64(unit, &3u32, 1, &1.0, 1), ERROR);
        assert_eq!(fmi3DoStep(unit, 5.0, 0.1, 0, null_mut(), null_mut(), null_mut(), null_mut()), OK);
        // Freed twice, used afterwards, null, a stranger.
        fmi3FreeInstance(unit);
        fmi3FreeInstance(unit);
        fmi3FreeInstance(null_mut());
        let mut stranger = 7u64;
        for pointer in [unit, null_mut(), (&raw mut stranger).cast()] {
            assert_eq!(fmi3GetFloat64(pointer, &1u32, 1, value.as_mut_ptr(), 1), ERROR);
        }
    }
    let said = SAID.lock().unwrap();
    for words in [
        "begins at 0 s",
        "must be 0 rad/s or more, and is -1",
        "gives no gas",
        "is computed",
        "not yet initialised",
    ] {
        assert!(said.iter().any(|line| line.contains(words)), "{words}: {said:?}");
    }
}

#[test]
fn units_that_cannot_be_say_why() {
    let good = resources("good", ENGINE);
    let bad = resources("bad", "name = \"x\"\n");
    let cases = [
        (good.clone(), "another token", "export the unit anew".to_owned()),
        (good.join("nowhere"), "t", "cannot read engine.toml".to_owned()),
        (bad, &unit_token(UnitKind::Loads, "name = \"x\"\n"), "engine.toml: ".to_owned()),
    ];
    for (folder, token, words) in cases {
        assert!(instance3(&folder, token).is_null());
        let said = SAID.lock().unwrap();
        assert!(said.iter().any(|line| line.contains(&words)), "{words}: {said:?}");
    }
    // Without strings, for model exchange.
    // SAFETY: null is what is tried.
    unsafe {
        assert!(fmi2Instantiate(null(), 1, null(), null(), null(), 0, 0).is_null());
        assert!(fmi2Instantiate(null(), 0, null(), null(), null(), 0, 0).is_null());
        assert!(fmi3InstantiateModelExchange(null(), null(), null(), 0, 0, null_mut(), Some(keep)).is_null());
    }
}
