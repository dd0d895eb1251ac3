//! Files of pressures: what is taken, in which forms, and what is refused with which words.

use crate::support::{engine, volume_of};
use lanchester_cycle::{
    MeasuredTrace, TraceError, TraceFault, TraceOptions, TracePlace, at_speed, check_firing, indicated,
    read_trace, trace_codes,
};
use lanchester_results::PeriodicCurve;
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

const FOUR: TraceOptions = TraceOptions {
    name: "p.csv",
    cycle: 2.0 * TAU,
    gauge: false,
    ambient_pressure: 101_325.0,
    top_dead_centre: 0.0,
    place: TracePlace::Cylinder,
};

/// A smooth periodic pressure [bar] with its peak 10 deg after firing.
fn bar(degrees: f64) -> f64 {
    let half = (degrees - 10.0).to_radians() / 4.0;
    1.0 + 60.0 * half.cos().powi(60)
}

fn file(header: &str, angles: impl Iterator<Item = f64>, value: impl Fn(f64) -> String) -> String {
    let mut text = format!("{header}\n");
    for angle in angles {
        writeln!(text, "{angle},{}", value(angle)).expect("a text takes all");
    }
    text
}

fn steps(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    (0..=((to - from) / step).round() as i32).map(move |k| from + step * f64::from(k))
}

fn plain(from: f64, to: f64) -> String {
    file("theta [deg],p [bar]", steps(from, to, 1.0), |angle| bar(angle).to_string())
}

fn read(text: &str) -> Result<MeasuredTrace, TraceError> {
    read_trace(text, &FOUR)
}

fn only(trace: MeasuredTrace) -> PeriodicCurve {
    assert!(trace.warnings.is_empty() && trace.columns.len() == 1, "{:?}", trace.warnings);
    trace.columns.into_iter().next().expect("a column").1
}

fn follows(curve: &PeriodicCurve, case: &str) {
    for k in 0..720 {
        let degrees = f64::from(k) + 0.5;
        let (got, wanted) = (curve.at(degrees.to_radians()) / 1e5, bar(degrees));
        // Samples a degree apart: the spline's error is some 1e-5 of the peak.
        assert!((got - wanted).abs() < 2e-3, "{case} at {degrees} deg: {got} {wanted}");
    }
}

#[test]
fn any_range_step_and_unit_gives_the_same_pressure() {
    for (from, to) in [(-360.0, 360.0), (0.0, 720.0), (0.0, 719.0), (-180.0, 540.0), (-359.0, 360.0)] {
        follows(&only(read(&plain(from, to)).expect("a trace")), &format!("{from} to {to}"));
    }
    let uneven = steps(-360.0, -40.0, 2.0).chain(steps(-39.5, 60.0, 0.5)).chain(steps(62.0, 360.0, 2.0));
    let text =
        file("# bench 7\n crank angle [deg] , p1 (MPa)", uneven, |angle| (bar(angle) / 10.0).to_string());
    follows(&only(read(&text).expect("a trace")), "uneven");
    for (unit, factor) in [("Pa", 1e5), ("kPa", 100.0), ("psi", 14.503_773_773)] {
        let text =
            file(&format!("a [°],p [{unit}]"), steps(0.0, 720.0, 1.0), |a| (bar(a) * factor).to_string());
        follows(&only(read(&text).expect("a trace")), unit);
    }
    let mut text = String::from("\u{feff}p [bar];theta [rad]\r\n");
    for angle in steps(0.0, 719.0, 1.0) {
        write!(text, "{};{}\r\n", bar(angle), angle.to_radians()).expect("a text takes all");
    }
    follows(&only(read(&text).expect("a trace")), "semicolons, radians, angle last");
}

#[test]
fn gauge_and_dead_centre_are_those_of_the_options() {
    let text =
        file("theta [deg],p [bar]", steps(0.0, 720.0, 1.0), |a| (bar(a - 360.0) - 1.01325).to_string());
    let options = TraceOptions { gauge: true, top_dead_centre: TAU, ..FOUR };
    follows(&only(read_trace(&text, &options).expect("a trace")), "gauge from the other dead centre");
}

#[test]
fn columns_keep_their_order() {
    let text = file("theta [deg],p1 [bar],p2 [bar]", steps(0.0, 719.0, 1.0), |a| {
        format!("{},{}", bar(a), 2.0 * bar(a))
    });
    let trace = read(&text).expect("a trace");
    assert_eq!(trace.columns.iter().map(|c| c.0.as_str()).collect::<Vec<_>>(), ["p1 [bar]", "p2 [bar]"]);
    assert!((trace.columns[1].1.at(0.3) / trace.columns[0].1.at(0.3) - 2.0).abs() < 1e-12);
}

#[test]
fn a_small_gap_of_closing_is_spread_and_told_a_large_one_refused() {
    let drifting = |by: f64, from: f64| {
        let value = |a: f64| (bar(a) + from + by * (a / 720.0)).to_string();
        file("theta [deg],p [bar]", steps(-360.0, 360.0, 1.0), value)
    };
    let trace = read(&drifting(0.3, 0.0)).expect("it is mended");
    assert!(trace.warnings[0].contains("does not close by 0.3000 bar"), "{:?}", trace.warnings);
    follows(&trace.columns[0].1, "drift taken out");
    let error = read(&drifting(3.0, 1.5)).expect_err("too much");
    assert!(matches!(error.fault, TraceFault::NotClosed { by, .. } if (by - 3e5).abs() < 1.0), "{error}");
    assert!(error.to_string().contains("differ by 3.0000 bar"), "{error}");
    // The same drift where the first angle is not repeated.
    let open: String = drifting(3.0, 1.5).lines().take(721).map(|line| format!("{line}\n")).collect();
    assert!(matches!(read(&open).expect_err("too much").fault, TraceFault::NotClosed { .. }));
}

#[track_caller]
fn refused(text: &str, line: Option<u64>, words: &str) {
    let error = read(text).expect_err(words);
    let shown = error.to_string();
    assert!(shown.contains(words), "{shown}");
    assert_eq!(error.line, line, "{shown}");
    assert!(shown.contains("hint: "), "{shown}");
}

#[test]
fn bad_files_are_told_with_their_line() {
    let good = plain(0.0, 720.0);
    refused("", Some(1), "angles is needed, got 0");
    refused("theta [deg],p [bar]\n", None, "0 samples are too few");
    refused(&plain(0.0, 20.0), None, "21 samples are too few");
    refused(&good.replace("p [bar]", "p"), Some(1), "\"p\" names no unit");
    refused(&good.replace("p [bar]", "p [barg]"), Some(1), "names no unit");
    refused(&good.replace("theta [deg]", "t [bar]"), Some(1), "got 0");
    refused(&file("theta [deg]", [1.0].into_iter(), |_| String::new()), Some(1), "no column of pressures");
    refused(&good.replace("\n5,", "\nfive,"), Some(7), "\"five\" in the column \"theta [deg]\" is no number");
    refused(&good.replace("\n5,", "\n5,1,"), Some(7), "3 values where the header has 2");
    let comma = good.replace(',', ";").replace('.', ",");
    refused(&comma, Some(2), "decimal comma");
    refused(&good.replace("\n300,", "\n299,"), Some(302), "299.0000 deg does not lie beyond 299.0000 deg");
    let reversed: Vec<&str> = good.lines().rev().collect();
    let reversed = format!("theta [deg],p [bar]\n{}", reversed[..721].join("\n"));
    refused(&reversed, Some(2), "the wrong sense");
    refused(&plain(-360.0, 720.0), Some(1082), "span 1080.0000 deg, more than the cycle of 720 deg");
    refused(&plain(0.0, 360.0), Some(362), "nothing between 360.0000 deg and 720.0000 deg");
    let without = |last: i32| -> String {
        let kept = good.lines().filter(|line| {
            let angle = line.split(',').next().and_then(|angle| angle.parse::<i32>().ok());
            angle.is_none_or(|angle| !(100..=last).contains(&angle))
        });
        kept.map(|line| format!("{line}\n")).collect()
    };
    assert!(read(&without(108)).is_ok(), "10 deg from sample to sample are taken");
    refused(&without(109), Some(102), "nothing between 99.0000 deg and 110.0000 deg");
}

#[test]
fn implausible_pressures_are_told() {
    let lowered =
        |by: f64| file("theta [deg],p [bar]", steps(0.0, 720.0, 1.0), |a| (bar(a) - by).to_string());
    refused(&lowered(1.01), None, "are these gauge pressures?");
    refused(
        &file("theta [deg],p [bar]", steps(0.0, 720.0, 1.0), |a| (bar(a) * 14.5).to_string()),
        None,
        "any engine reaches",
    );
    let gauge = TraceOptions { gauge: true, ..FOUR };
    let below = read_trace(&lowered(2.1), &gauge).expect_err("below a vacuum");
    assert!(below.to_string().contains("below a vacuum"), "{below}");
    let absolute = read_trace(&lowered(0.0), &gauge).expect("it may be");
    assert!(absolute.warnings[0].contains("are these absolute pressures?"), "{:?}", absolute.warnings);
    let odd = read(&lowered(0.9)).expect("it may be");
    assert!(odd.warnings[0].contains("are these gauge pressures?"), "{:?}", odd.warnings);
    let spike =
        file(
            "theta [deg],p [bar]",
            steps(0.0, 720.0, 8.0),
            |a| if a == 8.0 { "90".into() } else { "1".into() },
        );
    refused(&spike, None, "too coarsely");
}

#[test]
fn firing_dead_centre_and_sense_are_checked_against_the_engine() {
    let engine = engine(4, "0 mm", "");
    let volume = volume_of(&engine);
    let curve = only(read(&plain(0.0, 720.0)).expect("a trace"));
    assert_eq!(check_firing("p", &curve, &volume), Ok(Vec::new()));
    let other = check_firing("p", &curve.delayed(TAU), &volume).expect_err("gas exchange").to_string();
    assert!(other.contains("top dead centre of the gas exchange"), "{other}");
    let off = check_firing("p", &curve.delayed(PI / 2.0), &volume).expect_err("far off").to_string();
    assert!(off.contains("lies 100.0 deg after"), "{off}");
    // Counted backwards: the peak comes before dead centre, and the gas takes up work.
    let mirrored = file("theta [deg],p [bar]", steps(-360.0, 360.0, 1.0), |a| bar(-a).to_string());
    let mirrored = only(read(&mirrored).expect("a trace"));
    let error = check_firing("p", &mirrored, &volume).expect_err("backwards");
    assert!(
        matches!(error, TraceFault::Backwards { work, .. } if (work + indicated(&curve, &volume).work).abs() < 1e-3),
        "{error}"
    );
}

#[test]
fn every_code_is_listed_and_has_a_bad_file() {
    let good = plain(0.0, 720.0);
    let with = |value: fn(f64) -> f64| {
        file("theta [deg],p [bar]", steps(0.0, 720.0, 1.0), |angle| value(angle).to_string())
    };
    let reversed: Vec<&str> = good.lines().rev().collect();
    let spike = |angle: f64| if angle == 8.0 { "90".to_owned() } else { "1".to_owned() };
    let files = [
        ("E1602", good.replace("p [bar]", "p")),
        ("E1603", String::new()),
        ("E1604", file("theta [deg]", [1.0].into_iter(), |_| String::new())),
        ("E1605", good.replace("\n5,", "\n5,1,")),
        ("E1606", good.replace(',', ";").replace('.', ",")),
        ("E1607", good.replace("\n5,", "\nfive,")),
        ("E1608", plain(0.0, 20.0)),
        ("E1609", format!("theta [deg],p [bar]\n{}", reversed[..721].join("\n"))),
        ("E1610", good.replace("\n300,", "\n299,")),
        ("E1611", plain(-360.0, 720.0)),
        ("E1612", plain(0.0, 360.0)),
        ("E1613", with(|angle| bar(angle) + 0.01 * angle)),
        ("E1614", with(|angle| bar(angle) - 1.01)),
        ("E1615", with(|angle| 14.5 * bar(angle))),
        ("E1616", file("theta [deg],p [bar]", steps(0.0, 720.0, 8.0), spike)),
    ];
    let mut seen = BTreeSet::new();
    for (code, text) in files {
        let error = read(&text).expect_err(code);
        assert_eq!(error.fault.code(), code, "{error}");
        assert!(error.to_string().starts_with("p.csv:") && error.to_string().contains(&format!(" {code}: ")));
        seen.insert(code);
    }
    // What only the engine can tell.
    let volume = volume_of(&engine(4, "0 mm", ""));
    let curve = only(read(&good).expect("a trace"));
    let mirrored = only(read(&with(|angle| bar(-angle))).expect("a trace"));
    for (code, curve) in [("E1617", curve.delayed(PI / 2.0)), ("E1618", mirrored)] {
        assert_eq!(check_firing("p", &curve, &volume).expect_err(code).code(), code);
        seen.insert(code);
    }
    // The number of columns is checked where all cylinders are known; a text is always CSV, and its angles rise.
    let curve = PeriodicCurve::constant(-1.0, 1.0).expect_err("no period");
    // Files of torque have tests of their own.
    let others = [
        TraceFault::TorqueHeading { column: String::new() },
        TraceFault::Torques { got: 2 },
        TraceFault::TorqueNotClosed { by: 1.0, share: 0.1 },
        TraceFault::Csv { message: String::new() },
        TraceFault::Columns { got: 2, cylinders: 4 },
        curve.into(),
    ];
    seen.extend(others.iter().map(TraceFault::code));
    let listed: BTreeSet<&str> = trace_codes().iter().map(|(code, _)| *code).collect();
    assert_eq!(seen, listed);
}

#[test]
fn between_speeds_pressures_are_interpolated_beyond_held() {
    let [low, high] = [1.0, 3.0].map(|level| PeriodicCurve::constant(2.0 * TAU, level).expect("a curve"));
    let measured = [(Some(100.0), &low), (Some(300.0), &high)];
    for (speed, level, held) in
        [(50.0, 1.0, true), (100.0, 1.0, false), (150.0, 1.5, false), (300.0, 3.0, false), (400.0, 3.0, true)]
    {
        let (curve, is_held) = at_speed(&measured, speed).expect("a curve");
        assert!((curve.at(0.7) - level).abs() < 1e-12 && is_held == held, "{speed}: {}", curve.at(0.7));
    }
    assert_eq!(at_speed(&[(None, &low)], 777.0).expect("a curve"), (low.clone(), false));
    assert!(at_speed(&[], 1.0).is_err());
}

#[test]
fn every_code_has_one_meaning_in_files_of_all_kinds() {
    let all = lanchester_file::diagnostic_codes().iter().chain(trace_codes());
    let mut codes: Vec<&str> = all.map(|(code, _)| *code).collect();
    let count = codes.len();
    codes.sort_unstable();
    codes.dedup();
    assert_eq!(codes.len(), count, "a code is given twice");
}

#[test]
fn every_code_has_a_family_and_every_family_a_code() {
    let all = lanchester_file::diagnostic_codes().iter().chain(trace_codes());
    let of_codes: BTreeSet<&str> = all.map(|(code, _)| &code[1..3]).collect();
    let named: BTreeSet<&str> =
        lanchester_file::diagnostic_families().iter().map(|(digits, _)| *digits).collect();
    assert_eq!(of_codes, named);
}
