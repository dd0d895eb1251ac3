//! From an engine file and its traces to the pressures on its pistons.

use lanchester::model::Engine;
use lanchester::{CylinderCycle, GasError, GasReport, TraceFile, cylinder_gas, trace_names};
use std::f64::consts::PI;
use std::fmt::Write;

const EXAMPLE: &str = include_str!("../../../../examples/single-gas.toml");

fn rpm(speed: f64) -> f64 {
    speed * PI / 30.0
}

fn engine(text: &str) -> Engine {
    let reading = lanchester::file::read(text);
    let shown = lanchester::file::render(&reading.diagnostics, "engine.toml", text, false);
    reading.engine().unwrap_or_else(|| panic!("{shown}"))
}

/// A template of the gallery with this `[gas]`.
fn with_gas(template: &str, gas: &str) -> Engine {
    let template = lanchester::file::template(template).expect("it is in the gallery");
    engine(&format!("{}\n{gas}", template.text))
}

/// Pressures of so many columns, each `lag` degrees later than the one before it.
fn trace(name: &str, columns: usize, lag: f64, peak: f64) -> TraceFile {
    let mut text = String::from("theta [deg]");
    for column in 1..=columns {
        write!(text, ",p{column} [bar]").expect("a text takes all");
    }
    for degrees in 0..720 {
        write!(text, "\n{degrees}").expect("a text takes all");
        for column in 0..columns {
            let half = (f64::from(degrees) - 10.0 - lag * column as f64).to_radians() / 4.0;
            write!(text, ",{}", 1.0 + peak * half.cos().powi(60)).expect("a text takes all");
        }
    }
    TraceFile { name: name.into(), text }
}

fn gas_of(engine: &Engine, traces: &[TraceFile], speed: f64) -> Result<GasReport, GasError> {
    cylinder_gas(engine, traces, rpm(speed))
}

#[test]
fn one_cycle_stands_for_all_cylinders_that_move_alike() {
    let gas = "[gas]\ncompression_ratio = 10\n[gas.cycle]\ntype = \"otto\"\npeak_pressure = \"70 bar\"\n";
    let four = with_gas("in-line-4", gas);
    let report = gas_of(&four, &[], 3000.0).expect("pressures");
    assert_eq!(report.cycles.len(), 1);
    assert_eq!(report.cycles[0].cylinders, [1, 2, 3, 4]);
    assert!(report.cylinders.iter().all(|cylinder| *cylinder == report.cylinders[0]));
    assert!((report.indicated[2].peak_pressure - 70e5).abs() < 1e-2, "{:?}", report.indicated[2]);
    // Master and articulated rods move differently, mirrored ones too.
    let radial = with_gas("radial-9", gas);
    let report = gas_of(&radial, &[], 2000.0).expect("pressures");
    assert_eq!(report.cycles.len(), 9);
    for indicated in &report.indicated {
        let spread = indicated.gross_work / report.indicated[0].gross_work;
        assert!((spread - 1.0).abs() < 0.05, "{indicated:?}");
    }
    assert!(serde_json::to_string(&report).is_ok());
}

#[test]
fn columns_that_count_from_cylinder_1_are_turned_to_their_own_firing() {
    let own = "[gas]\n[[gas.trace]]\nfile = \"p.csv\"\n";
    let first = format!("{own}counted_from = \"cylinder 1\"\n");
    // Firing order 1 3 4 2: cylinder 3 fires second. Columns stand in the order of the cylinders.
    let lags = [0.0, 540.0, 180.0, 360.0];
    let mut text = String::from("theta [deg],p1 [bar],p2 [bar],p3 [bar],p4 [bar]");
    for degrees in 0..720 {
        write!(text, "\n{degrees}").expect("a text takes all");
        for lag in lags {
            let half = (f64::from(degrees) - 10.0 - lag).to_radians() / 4.0;
            write!(text, ",{}", 1.0 + 60.0 * half.cos().powi(60)).expect("a text takes all");
        }
    }
    let together = TraceFile { name: "p.csv".into(), text };
    let report = gas_of(&with_gas("in-line-4", &first), &[together], 3000.0).expect("pressures");
    let alone =
        gas_of(&with_gas("in-line-4", own), &[trace("p.csv", 4, 0.0, 60.0)], 3000.0).expect("pressures");
    for (one, other) in report.cylinders.iter().zip(&alone.cylinders) {
        for k in 0..72 {
            let psi = f64::from(k) * PI / 18.0;
            assert!((one.cylinder.at(psi) / other.cylinder.at(psi) - 1.0).abs() < 1e-9, "{psi}");
        }
    }
}

#[test]
fn traces_are_interpolated_in_speed_and_their_faults_told() {
    let gas = "[gas]\n[[gas.trace]]\nfile = \"low.csv\"\nspeed = \"1000 rpm\"\n[[gas.trace]]\nfile = \"high.csv\"\nspeed = \"3000 rpm\"\n";
    let engine = with_gas("in-line-4", gas);
    assert_eq!(trace_names(&engine), ["low.csv", "high.csv"]);
    let files = [trace("low.csv", 1, 0.0, 40.0), trace("high.csv", 4, 0.0, 60.0)];
    let report = gas_of(&engine, &files, 1500.0).expect("pressures");
    assert!((report.indicated[1].peak_pressure / 1e5 - 46.0).abs() < 1e-3, "{:?}", report.indicated[1]);
    assert!(report.warnings.is_empty(), "{:?}", report.warnings);
    let beyond = gas_of(&engine, &files, 5000.0).expect("pressures");
    assert!(
        beyond.warnings[0].contains("5000 rpm lies outside the measured speeds (1000 to 3000 rpm)"),
        "{:?}",
        beyond.warnings
    );
    assert_eq!(gas_of(&engine, &files[..1], 1500.0), Err(GasError::MissingTrace { name: "high.csv".into() }));
    let three = gas_of(&engine, &[trace("low.csv", 3, 0.0, 40.0), files[1].clone()], 1500.0);
    assert!(three.expect_err("too few").to_string().contains("3 columns of pressure for 4 cylinders"));
    assert!(matches!(gas_of(&engine, &files, 0.0), Err(GasError::Speed { .. })));
    let bare = with_gas("in-line-4", "");
    assert_eq!(gas_of(&bare, &[], 1000.0), Err(GasError::NoGas));
}

#[test]
fn the_crankcase_may_have_a_trace() {
    let gas = "[gas]\ncompression_ratio = 8\n[gas.cycle]\ntype = \"otto\"\npeak_pressure = \"40 bar\"\n[gas.crankcase]\nfile = \"case.csv\"\npressures = \"gauge\"\n";
    let engine = with_gas("in-line-3-two-stroke", gas);
    let mut text = String::from("theta [deg],case [kPa]");
    for degrees in (0..=360).step_by(5) {
        write!(text, "\n{degrees},{}", 20.0 * f64::from(degrees).to_radians().sin())
            .expect("a text takes all");
    }
    let file = TraceFile { name: "case.csv".into(), text };
    let report = gas_of(&engine, &[file], 3000.0).expect("pressures");
    for cylinder in &report.cylinders {
        assert!((cylinder.crankcase.mean() - 101_325.0).abs() < 1e-6);
        assert!((cylinder.crankcase.at(PI / 2.0) - 121_325.0).abs() < 1.0);
        assert_eq!(cylinder.cylinder.period(), cylinder.crankcase.period());
    }
}

#[test]
fn the_example_computes_a_single_zone_that_closes() {
    let engine = engine(EXAMPLE);
    for speed in [1500.0, 4000.0, 7000.0] {
        let report = gas_of(&engine, &[], speed).expect("pressures");
        assert!(report.warnings.is_empty(), "{:?}", report.warnings);
        let CylinderCycle::SingleZone(cycle) = &report.cycles[0].cycle else { panic!("no single zone") };
        assert!(cycle.outcome.converged && cycle.balance.energy_share < 1e-7, "{cycle:?}");
        let bar = report.indicated[0].mean_effective_pressure / 1e5;
        assert!((7.0..14.0).contains(&bar), "{speed}: {bar} bar");
    }
}
