//! Balancing with trial weights against a simulated rotor whose unbalance is known.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "support/rotor.rs"]
mod rotor;

use lanchester_file::workshop::read_sheet;
use lanchester_workshop::{Correction, NextStep, RemarkKind, WorkshopError, correction};
use num_complex::Complex64;
use rotor::{Bench, ROTOR};

/// Unbalances of the rotor (z, amount, angle on the rotor), in planes where nothing can be corrected.
const UNKNOWN: [(f64, f64, f64); 3] = [(0.02, 3.1e-4, 0.4), (0.21, 2.2e-4, 2.9), (0.37, 4.0e-4, 4.4)];
const PLANES: [(&str, f64); 2] = [("front", 0.08), ("rear", 0.46)];
const SENSORS: [(&str, f64, f64); 2] = [("A", 0.3, 0.0), ("B", 1.9, 0.4)];
const BENCH: Bench = Bench {
    marks_anticlockwise: true,
    turns_anticlockwise: false,
    lag: true,
    keyphasor: 0.9,
    quantity: 1,
    detector: "rms",
};

fn answer(text: &str) -> Result<Correction, WorkshopError> {
    let reading = read_sheet(text);
    let sheet = reading.sheet.unwrap_or_else(|| panic!("{:?}\n{text}", reading.diagnostics));
    correction(&sheet)
}

/// The weights that take the unknown unbalance away, in the planes.
fn wanted(planes: [f64; 2]) -> [Complex64; 2] {
    let distance = planes[1] - planes[0];
    UNKNOWN.iter().fold([Complex64::default(); 2], |[front, rear], (z, amount, angle)| {
        let u = Complex64::from_polar(*amount, *angle);
        [front - u * ((planes[1] - z) / distance), rear - u * ((z - planes[0]) / distance)]
    })
}

fn with(more: &[(f64, f64, f64)]) -> Vec<(f64, f64, f64)> {
    UNKNOWN.iter().chain(more).copied().collect()
}

fn weight(plane: &str, amount: f64, angle: f64, action: &str, kept: bool) -> String {
    format!(
        "{{ plane = \"{plane}\", unbalance = \"{amount} kg m\", angle = \"{angle} rad\", action = \"{action}\", kept = {kept} }}"
    )
}

/// An initial run and a trial run for each plane.
fn sheet(bench: Bench, rpm: f64, action: &str, kept: bool) -> (String, [Complex64; 2]) {
    let sign = if action == "added" { 1.0 } else { -1.0 };
    let (first, second) = ((PLANES[0].1, sign * 5e-4, 1.0), (PLANES[1].1, sign * 4e-4, 5.2));
    let mut text = bench.head(&PLANES, &SENSORS, "");
    text += &bench.run(&ROTOR, "initial", rpm, &UNKNOWN, &SENSORS, "");
    text += &bench.run(
        &ROTOR,
        "front trial",
        rpm,
        &with(&[first]),
        &SENSORS,
        &weight("front", 5e-4, 1.0, action, kept),
    );
    let second_state = if kept { with(&[first, second]) } else { with(&[second]) };
    text += &bench.run(
        &ROTOR,
        "rear trial",
        rpm,
        &second_state,
        &SENSORS,
        &weight("rear", 4e-4, 5.2, action, kept),
    );
    let mut expected = wanted([PLANES[0].1, PLANES[1].1]);
    if kept {
        expected[0] -= Complex64::from_polar(first.1, first.2);
        expected[1] -= Complex64::from_polar(second.1, second.2);
    }
    (text, expected)
}

fn check(found: &Correction, expected: &[Complex64], what: &str) {
    assert_eq!(found.planes.len(), expected.len());
    for (plane, expected) in found.planes.iter().zip(expected) {
        let error = (plane.unbalance - expected).norm() / expected.norm();
        assert!(error < 1e-9, "{what}: {} is {} instead of {expected}", plane.plane, plane.unbalance);
    }
}

#[test]
fn every_convention_finds_the_same_unbalance() {
    let mut count = 0;
    for mask in 0..32u8 {
        let bit = |k: u8| mask >> k & 1 == 1;
        for quantity in 0..3 {
            for detector in ["peak", "peak-to-peak", "rms"] {
                for keyphasor in [0.0, 2.3] {
                    let bench = Bench {
                        marks_anticlockwise: bit(0),
                        turns_anticlockwise: bit(1),
                        lag: bit(2),
                        keyphasor,
                        quantity,
                        detector,
                    };
                    let action = if bit(3) { "added" } else { "removed" };
                    let (text, expected) = sheet(bench, 1700.0, action, bit(4));
                    let what = format!("{bench:?}, {action}, kept {}", bit(4));
                    check(&answer(&text).unwrap(), &expected, &what);
                    count += 1;
                }
            }
        }
    }
    assert_eq!(count, 576);
}

/// A wrong convention must be seen, or the test above would prove nothing.
#[test]
fn a_wrong_sense_gives_another_answer() {
    let (text, expected) = sheet(BENCH, 1700.0, "added", false);
    for (stated, wrong) in [
        ("phase = \"lag\"", "phase = \"lead\""),
        ("rotation = \"clockwise\"", "rotation = \"anticlockwise\""),
    ] {
        assert!(text.contains(stated));
        let found = answer(&text.replace(stated, wrong)).unwrap();
        let error = (found.planes[0].unbalance - expected[0]).norm() / expected[0].norm();
        assert!(error > 0.1, "{wrong}: {error}");
    }
}

/// Where the bearings are round, what a sensor shows depends on its angle only through the convention.
#[test]
fn coefficients_are_those_of_the_machine() {
    let mut round = ROTOR;
    for (_, stiffness, _) in &mut round.bearings {
        stiffness[1] = stiffness[0];
    }
    let sensors = [("A", 0.0, 0.1), ("B", 2.1, 0.1), ("C", -1.2, 0.1)];
    let mut responses = Vec::new();
    for (keyphasor, marks_anticlockwise, lag, quantity) in
        [(0.0, true, true, 1), (1.4, false, true, 0), (-0.6, true, false, 2)]
    {
        let bench = Bench { keyphasor, marks_anticlockwise, lag, quantity, ..BENCH };
        let trial = (PLANES[0].1, 5e-4, 1.0);
        let text = bench.head(&PLANES[..1], &sensors, "")
            + &bench.run(&round, "initial", 1700.0, &UNKNOWN, &sensors, "")
            + &bench.run(
                &round,
                "trial",
                1700.0,
                &with(&[trial]),
                &sensors,
                &weight("front", 5e-4, 1.0, "added", false),
            );
        let found = answer(&text).unwrap();
        responses.extend(found.runs.unwrap().influence.into_iter().map(|influence| influence.response));
    }
    assert_eq!(responses.len(), 9);
    for response in &responses {
        assert!((response / responses[0] - 1.0).norm() < 1e-9, "{response} {}", responses[0]);
    }
    // Far below resonance the rotor goes where the heavy spot pulls it: the velocity leads by a quarter turn.
    assert!(responses[0].arg() > 1.2 && responses[0].arg() < 1.9, "{}", responses[0].arg());
}

#[test]
fn several_speeds_and_sensors_agree() {
    let sensors = [("A", 0.3, 0.0), ("B", 1.9, 0.4), ("C", 1.2, 0.0), ("D", 0.0, 0.4)];
    let planes = PLANES;
    let mut text = BENCH.head(&planes, &sensors, "");
    for rpm in [900.0, 1700.0, 4000.0] {
        let (first, second) = ((PLANES[0].1, 5e-4, 1.0), (PLANES[1].1, 4e-4, 5.2));
        text += &BENCH.run(&ROTOR, "initial", rpm, &UNKNOWN, &sensors, "");
        text += &BENCH.run(
            &ROTOR,
            "front",
            rpm,
            &with(&[first]),
            &sensors,
            &weight("front", 5e-4, 1.0, "added", false),
        );
        text += &BENCH.run(
            &ROTOR,
            "rear",
            rpm,
            &with(&[second]),
            &sensors,
            &weight("rear", 4e-4, 5.2, "added", false),
        );
        text += &BENCH.run(&ROTOR, "again", rpm, &UNKNOWN, &sensors, "");
    }
    let found = answer(&text).unwrap();
    check(&found, &wanted([PLANES[0].1, PLANES[1].1]), "three speeds");
    assert!(found.remarks.is_empty(), "{:?}", found.remarks);
    let runs = found.runs.unwrap();
    // Every fourth run is predicted from the three before it.
    for entry in runs.log.iter().filter(|entry| entry.name == "again") {
        for sensor in &entry.sensors {
            assert!(sensor.missed.unwrap() < 1e-9 * sensor.measured.amplitude);
        }
    }
    for sensor in &runs.sensors {
        assert!(sensor.after.unwrap().amplitude < 1e-9 * sensor.now.amplitude);
        assert!(sensor.scatter.unwrap() < 1e-9 * sensor.now.amplitude);
    }
}

#[test]
fn the_log_goes_on_until_the_limit_holds() {
    let limited = |text: String| {
        text.replace("detector = \"rms\"\n", "detector = \"rms\"\nlimit = { velocity = \"0.05 mm/s\" }\n")
    };
    let (text, expected) = sheet(BENCH, 1700.0, "added", false);
    let before = answer(&limited(text.clone())).unwrap();
    assert_eq!((before.holds, &before.next), (Some(false), &NextStep::Correct));
    let made: Vec<(f64, f64, f64)> =
        PLANES.iter().zip(expected).map(|((_, z), u)| (*z, 0.98 * u.norm(), u.arg())).collect();
    let weights: Vec<String> =
        PLANES.iter().zip(&made).map(|((name, _), (_, u, a))| weight(name, *u, *a, "added", true)).collect();
    let text = text + &BENCH.run(&ROTOR, "corrected", 1700.0, &with(&made), &SENSORS, &weights.join(", "));
    let after = answer(&limited(text)).unwrap();
    assert_eq!((after.holds, &after.next), (Some(true), &NextStep::Finished));
    // Two per cent of the correction is left to do.
    for (plane, expected) in after.planes.iter().zip(expected) {
        assert!((plane.unbalance - 0.02 * expected).norm() < 1e-9 * expected.norm());
    }
    let last = &after.runs.as_ref().unwrap().log[3];
    assert!(last.sensors.iter().all(|sensor| sensor.missed.unwrap() < 1e-12 && sensor.predicted.is_some()));
}

#[test]
fn without_a_trial_run_one_is_asked_for() {
    let text =
        BENCH.head(&PLANES, &SENSORS, "") + &BENCH.run(&ROTOR, "initial", 1700.0, &UNKNOWN, &SENSORS, "");
    let found = answer(&text).unwrap();
    assert_eq!(found.next, NextStep::Try { planes: vec!["front".into(), "rear".into()] });
    assert!(found.planes.is_empty());
}

#[test]
fn contradiction_and_weak_trials_are_told() {
    let (text, _) = sheet(BENCH, 1700.0, "added", false);
    // A run repeated with the weight still on although the sheet says that it was taken off.
    let forgotten = text.clone()
        + &BENCH.run(&ROTOR, "repeated", 1700.0, &with(&[(PLANES[1].1, 4e-4, 5.2)]), &SENSORS, "");
    let found = answer(&forgotten).unwrap();
    let remark = found.remarks.iter().find(|remark| remark.kind == RemarkKind::Contradiction).unwrap();
    assert!(remark.message.contains('%') && remark.hint.contains("taken off"), "{remark:?}");
    assert!(found.runs.unwrap().sensors[0].scatter.unwrap() > 0.0);

    let weak = BENCH.head(&PLANES[..1], &SENSORS, "")
        + &BENCH.run(&ROTOR, "initial", 1700.0, &UNKNOWN, &SENSORS, "")
        + &BENCH.run(
            &ROTOR,
            "trial",
            1700.0,
            &with(&[(PLANES[0].1, 1e-5, 1.0)]),
            &SENSORS,
            &weight("front", 1e-5, 1.0, "added", false),
        );
    let found = answer(&weak).unwrap();
    assert_eq!(found.remarks.len(), 1);
    assert_eq!(found.remarks[0].kind, RemarkKind::WeakTrial);
}

#[test]
fn what_cannot_be_told_is_refused_with_its_reason() {
    let trial = |name: &str, rpm: f64, plane: usize, amount: f64| {
        let (plane, z) = (PLANES[plane].0, PLANES[plane].1);
        BENCH.run(
            &ROTOR,
            name,
            rpm,
            &with(&[(z, amount, 1.0)]),
            &SENSORS,
            &weight(plane, amount, 1.0, "added", false),
        )
    };
    let start =
        BENCH.head(&PLANES, &SENSORS, "") + &BENCH.run(&ROTOR, "initial", 1700.0, &UNKNOWN, &SENSORS, "");

    let other_speed =
        start.clone() + &trial("front trial", 1700.0, 0, 5e-4) + &trial("rear trial", 1900.0, 1, 5e-4);
    let error = answer(&other_speed).unwrap_err();
    assert!(matches!(error, WorkshopError::OtherSpeed { .. }), "{error}");
    assert!(error.to_string().contains("rear trial was made at 1900 rpm, initial at 1700 rpm"), "{error}");

    // A jitter of the speed within a per cent is none.
    let jitter =
        start.clone() + &trial("front trial", 1702.0, 0, 5e-4) + &trial("rear trial", 1695.0, 1, 5e-4);
    assert!(answer(&jitter).is_ok());

    let both = |name: &str, factor: f64| {
        let (u, v) = (factor * 5e-4, factor * 3e-4);
        let weights =
            [weight("front", u, 1.0, "added", false), weight("rear", v, 2.0, "added", false)].join(",");
        BENCH.run(
            &ROTOR,
            name,
            1700.0,
            &with(&[(PLANES[0].1, u, 1.0), (PLANES[1].1, v, 2.0)]),
            &SENSORS,
            &weights,
        )
    };
    let together = start.clone() + &both("one", 1.0) + &both("two", 2.0);
    let error = answer(&together).unwrap_err();
    assert_eq!(
        error,
        WorkshopError::MovedTogether {
            planes: vec!["front".into(), "rear".into()],
            speed_rpm: error_rpm(&error)
        }
    );
    let error = answer(&(start.clone() + &both("one", 1.0))).unwrap_err();
    assert!(matches!(error, WorkshopError::FewRuns { got: 2, needed: 3, .. }), "{error}");

    // A rigid rotor has two planes' worth of freedom: a third is a combination of them.
    let planes = [PLANES[0], PLANES[1], ("middle", 0.2)];
    let three = BENCH.head(&planes, &[SENSORS[0], SENSORS[1], ("C", 1.0, 0.2)], "");
    let sensors = [SENSORS[0], SENSORS[1], ("C", 1.0, 0.2)];
    let mut text = three + &BENCH.run(&ROTOR, "initial", 1700.0, &UNKNOWN, &sensors, "");
    for (name, z) in planes {
        text += &BENCH.run(
            &ROTOR,
            name,
            1700.0,
            &with(&[(z, 5e-4, 1.0)]),
            &sensors,
            &weight(name, 5e-4, 1.0, "added", false),
        );
    }
    let error = answer(&text).unwrap_err();
    assert!(matches!(&error, WorkshopError::Singular { planes } if planes.len() == 3), "{error}");
    assert!(error.to_string().contains("correct in one of these planes"), "{error}");
}

fn error_rpm(error: &WorkshopError) -> f64 {
    match error {
        WorkshopError::MovedTogether { speed_rpm, .. } => *speed_rpm,
        _ => f64::NAN,
    }
}

#[test]
fn one_sensor_cannot_tell_two_planes() {
    let (text, _) = sheet(BENCH, 1700.0, "added", false);
    let without: String =
        text.lines().filter(|line| !line.contains("sensor = \"B\"")).fold(String::new(), |a, l| a + l + "\n");
    let error = answer(&without).unwrap_err();
    assert_eq!(error, WorkshopError::FewReadings { readings: 1, planes: 2 });
}

/// `validation/external/numpy/two_plane.py` reads the sheet and its conventions by itself; the least squares are numpy's.
#[test]
fn ext_numpy_two_plane_crank() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = std::fs::read_to_string(root.join("examples/workshop/two-plane-crank.toml")).unwrap();
    let json = std::fs::read_to_string(root.join("validation/external/numpy/two_plane.json")).unwrap();
    let numpy: serde_json::Value = serde_json::from_str(&json).unwrap();
    let complex =
        |value: &serde_json::Value| Complex64::new(value[0].as_f64().unwrap(), value[1].as_f64().unwrap());
    let found = answer(&text).unwrap();
    let runs = found.runs.as_ref().unwrap();
    assert!((runs.condition.unwrap() / numpy["condition"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert_eq!(runs.influence.len(), 4);
    for influence in &runs.influence {
        // mm/s per g mm: a thousandth over a millionth.
        let theirs =
            complex(&numpy["influence [mm/s per g mm, peak]"][&influence.plane][&influence.sensor]) * 1e3;
        assert!((influence.response - theirs).norm() < 1e-9 * theirs.norm(), "{influence:?} {theirs}");
    }
    for sensor in &runs.sensors {
        let theirs = numpy["scatter [mm/s, rms detector]"][&sensor.sensor].as_f64().unwrap() * 1e-3;
        assert!((sensor.scatter.unwrap() / theirs - 1.0).abs() < 1e-9, "{sensor:?} {theirs}");
    }
    for plane in &found.planes {
        let theirs = complex(&numpy["weights [g mm]"][&plane.plane]) * 1e-6;
        assert!((plane.unbalance - theirs).norm() < 1e-8 * theirs.norm(), "{plane:?} {theirs}");
    }
}
