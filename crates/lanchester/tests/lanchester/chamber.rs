//! Pistons that share a combustion chamber: one pressure for all of them, on the volume that they leave together.

use lanchester::cycle::{CylinderVolume, work_between};
use lanchester::mechanism::{
    BearingPart, BearingRequest, GasTrain, Lever, TorqueRequest, bearing_loads, firing_chart, torque,
};
use lanchester::model::Engine;
use lanchester::{CylinderCycle, MountSpeeds, TraceFile, cylinder_gas};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

const SPEED: f64 = 150.0;

const OTTO: &str =
    "[gas]\ncompression_ratio = 12\n[gas.cycle]\ntype = \"otto\"\npeak_pressure = \"90 bar\"\n";

const PORTS: &str = "[gas]\ncompression_ratio = 12\n[gas.cycle]\ntype = \"single-zone\"\n\
    [gas.intake]\npressure = \"1.3 bar\"\ntemperature = \"60 degC\"\nopens = \"127 deg\"\narea = \"16 cm2\"\n\
    [gas.exhaust]\npressure = \"1.05 bar\"\ntemperature = \"700 K\"\nopens = \"110 deg\"\narea = \"14 cm2\"\n\
    [gas.fuel]\nequivalence_ratio = 0.6\n[gas.heat_release]\nstart = \"-8 deg\"\nduration = \"60 deg\"\n\
    [gas.walls]\nmodel = \"hohenberg\"\npiston_temperature = \"280 degC\"\nhead_temperature = \"200 degC\"\nliner_temperature = \"150 degC\"\n";

fn engine(phase: &str, gas: &str) -> Engine {
    let template = lanchester::file::template("opposed-piston-3").expect("it is in the gallery");
    let text = format!("{}\n{gas}", template.text.replace("169 deg", phase));
    let reading = lanchester::file::read(&text);
    let shown = lanchester::file::render(&reading.diagnostics, "engine.toml", &text, false);
    reading.engine().unwrap_or_else(|| panic!("{shown}"))
}

/// Volume of the first chamber but for its clearance and a constant, by plane geometry.
fn volume(engine: &Engine, theta: f64) -> f64 {
    let of = |index: usize| {
        let cylinder = &engine.cylinders[index];
        let throw = &engine.throws[cylinder.throw];
        let crankshaft = &engine.crankshafts[throw.crankshaft];
        let phi = crankshaft.ratio.value() * theta + crankshaft.phase + throw.angle - cylinder.angle;
        let (r, l) = (throw.radius, cylinder.rod.length);
        let travel = r * phi.cos() + (l * l - (r * phi.sin()).powi(2)).sqrt();
        -0.25 * PI * cylinder.bore.expect("it has a bore").powi(2) * travel
    };
    of(0) + of(3)
}

#[test]
fn the_volume_is_that_of_both_pistons_and_its_dead_centre_lies_between_theirs() {
    for (phase, ratio) in [("169 deg", 12.0), ("180 deg", 12.0), ("150 deg", 18.0)] {
        let engine = engine(phase, OTTO);
        let volumes = CylinderVolume::of_engine(&engine, Some(ratio)).expect("volumes");
        let own = &volumes[0];
        assert_eq!(*own, volumes[3]);
        let steps: Vec<f64> = (0..7200).map(|k| TAU * f64::from(k) / 7200.0).collect();
        let least = steps.iter().map(|theta| volume(&engine, *theta)).fold(f64::INFINITY, f64::min);
        let most = steps.iter().map(|theta| volume(&engine, *theta)).fold(f64::NEG_INFINITY, f64::max);
        let close = |got: f64, wanted: f64| (got - wanted).abs() < 1e-6 * (most - least);
        assert!(close(own.displaced(), most - least), "{phase}");
        // Largest over smallest volume is the compression ratio.
        assert!((own.at(own.bottom_angle())[0] / own.at(0.0)[0] - ratio).abs() < 1e-9, "{phase}");
        for theta in steps.iter().step_by(97) {
            let wanted = volume(&engine, *theta) - least + own.clearance();
            assert!(close(own.at(own.own_angle(*theta))[0], wanted), "{phase} {theta}");
        }
        // The inlet crank lags by 180 deg less its phase: the chamber is smallest half-way.
        let lag = PI - engine.crankshafts[1].phase;
        let top = (own.firing_angle() + PI).rem_euclid(TAU) - PI;
        assert!((top - 0.5 * lag).abs() < 1e-9, "{phase}: {top}");
    }
}

#[test]
fn both_pistons_feel_one_pressure_and_share_the_work_of_the_chamber() {
    for (phase, gas) in [("169 deg", OTTO), ("169 deg", PORTS), ("155 deg", PORTS), ("180 deg", OTTO)] {
        let engine = engine(phase, gas);
        let report = cylinder_gas(&engine, &[], SPEED).expect("pressures");
        assert_eq!(report.cycles.len(), 1, "all chambers are alike");
        let request = TorqueRequest { speed: Some(SPEED), ..TorqueRequest::default() };
        let found = torque(&engine, &report.cylinders, &request).expect("a torque");
        let volumes = CylinderVolume::of_engine(&engine, Some(12.0)).expect("volumes");
        for (first, second) in [(0, 3), (1, 4), (2, 5)] {
            let [one, two] = [first, second].map(|index| &found.cylinders[index]);
            assert_eq!(one.pressure, two.pressure, "{phase}: one chamber, one pressure at every angle");
            // p dV of the chamber, on its own volume and over its own quadrature.
            let curve = &report.cylinders[first].cylinder;
            let chamber = work_between(curve, &volumes[first], 0.0, volumes[first].cycle());
            let both = one.work.cylinder + two.work.cylinder;
            assert!((both - chamber).abs() < 1e-9 * chamber.abs(), "{phase}: {both} {chamber}");
            assert!((report.indicated[first].work - chamber).abs() < 1e-9 * chamber.abs());
        }
        // What the first piston works beyond the second is its lead.
        let lead = found.cylinders[0].work.cylinder - found.cylinders[3].work.cylinder;
        let work = found.cylinders[0].work.cylinder;
        if phase == "180 deg" {
            assert!(lead.abs() < 1e-9 * work.abs(), "{lead}");
        } else {
            assert!(
                lead > 0.02 * work.abs(),
                "{phase}: the piston that leads takes more of the work: {lead} {work}"
            );
        }
        // A chamber fires once.
        let chart = firing_chart(&engine).expect("it fires");
        assert_eq!(chart.order(), [1, 2, 3]);
        assert_eq!(chart.unevenness, 0.0);
        // Bearings and roll moment follow from the same pressures: gas force at the chamber's firing on both crankpins.
        let bearings =
            BearingRequest { speed: Some(SPEED), part: BearingPart::Gas, ..BearingRequest::default() };
        let loads = bearing_loads(&engine, Some(&report.cylinders), &bearings).expect("loads");
        let train = GasTrain::new(&engine, &report.cylinders, Lever::Exact).expect("a train");
        let mean: f64 = train.mean_torques().iter().sum();
        assert!((mean - found.indicated.torque).abs() < 1e-9 * mean.abs() && !loads.theta.is_empty());
    }
}

#[test]
fn ports_open_where_their_own_piston_uncovers_them() {
    let engine = engine("169 deg", PORTS);
    let report = cylinder_gas(&engine, &[], SPEED).expect("pressures");
    let CylinderCycle::SingleZone(cycle) = &report.cycles[0].cycle else { panic!("a single zone") };
    assert!(cycle.outcome.converged && cycle.balance.energy_share < 1e-7, "{:?}", cycle.balance);
    // The exhaust piston leads by 11 deg: 5.5 deg before the chamber. Its ports close as much after its own bottom dead centre as they open
    // before it; those of the inlet, whose piston lags, later: closing begins with the later one.
    let after = |opens: f64, shift: f64| 2.0 * (180.0 + shift) - opens;
    let latest = after(127.0, 5.5).max(after(110.0, -5.5));
    assert!(
        (cycle.closing_angle.to_degrees() + 360.0 - latest).abs() < 1e-6,
        "{}",
        cycle.closing_angle.to_degrees()
    );
}

#[test]
fn a_trace_has_a_column_for_each_chamber_or_that_of_its_first_piston() {
    let gas = "[gas]\n[[gas.trace]]\nfile = \"p.csv\"\n";
    let engine = engine("169 deg", gas);
    let file = |columns: usize| {
        let head: String = (1..=columns).map(|column| format!(",p{column} [bar]")).collect();
        let line = |degrees: i32| {
            let value = |column: usize| {
                let turned = f64::from(degrees - 12).to_radians() / 2.0;
                1.2 + (40.0 + 5.0 * column as f64) * turned.cos().powi(40)
            };
            let values: String = (0..columns).map(|column| format!(",{}", value(column))).collect();
            format!("\n{degrees}{values}")
        };
        TraceFile {
            name: "p.csv".into(),
            text: format!("theta [deg]{head}{}", (0..360).map(line).collect::<String>()),
        }
    };
    for columns in [1, 3, 6] {
        let report = cylinder_gas(&engine, &[file(columns)], SPEED).expect("pressures");
        for (first, second) in [(0, 3), (1, 4), (2, 5)] {
            assert_eq!(report.cylinders[first].cylinder, report.cylinders[second].cylinder, "{columns}");
        }
        let different = report.cylinders[0].cylinder != report.cylinders[1].cylinder;
        assert_eq!(different, columns > 1);
    }
    assert!(cylinder_gas(&engine, &[file(4)], SPEED).is_err());
}

#[test]
fn a_chamber_that_cannot_be_is_refused() {
    let template = lanchester::file::template("opposed-piston-3").expect("it is in the gallery").text;
    for (from, to, says) in [
        ("chamber = 1", "chamber = 4", "lower number"),
        ("chamber = 1", "chamber = 9", "does not exist"),
        ("chamber = 2", "chamber = 4", "has none of its own"),
        ("ratio = 1\n", "ratio = 2\n", "crankshafts of one speed"),
    ] {
        let text = template.replace(from, to);
        assert_ne!(text, template);
        let reading = lanchester::file::read(&text);
        let shown = lanchester::file::render(&reading.diagnostics, "engine.toml", &text, false);
        assert!(reading.file.is_none() && shown.contains(says), "{shown}");
    }
}

/// The block on its mounts feels the torque of both pistons of a chamber under its one pressure: p dV of the chamber by plane geometry.
#[test]
fn the_mounts_feel_the_torque_of_the_chamber() {
    let block = "[block]\nmass = \"400 kg\"\ncentre = [\"0 mm\", \"0 mm\", \"0 mm\"]\n\
        inertia = [\"30 kg m2\", \"30 kg m2\", \"20 kg m2\"]\n";
    let mount = |name: &str, x: i32, y: i32, z: i32| {
        format!(
            "[[mount]]\nname = \"{name}\"\nx = \"{x} mm\"\ny = \"{y} mm\"\nz = \"{z} mm\"\n\
             stiffness = [\"300 N/mm\", \"300 N/mm\", \"300 N/mm\"]\ndamping = [\"2 N s/mm\", \"2 N s/mm\", \"2 N s/mm\"]\n"
        )
    };
    let mounts =
        [mount("front", -300, 0, -250), mount("left", 200, 300, 250), mount("right", 200, -300, 250)];
    let engine = engine("169 deg", &format!("{OTTO}{block}{}", mounts.concat()));
    let speeds = MountSpeeds::List(vec![SPEED]);
    let roll = |gas: Option<&[TraceFile]>| {
        let found = lanchester::mounts(&engine, &speeds, 6, gas, &[]).expect("it is held").response;
        found.speeds[0].orders.iter().find(|one| one.order == 3.0).expect("order 3").load[5]
    };
    let of_gas = roll(Some(&[])) - roll(None);
    let report = cylinder_gas(&engine, &[], SPEED).expect("pressures");
    let volumes = CylinderVolume::of_engine(&engine, Some(12.0)).expect("volumes");
    let count = 14_400;
    let step = TAU / f64::from(count);
    // Three chambers a third of a revolution apart: order 3 of one, three times. The pressure jumps at ends of steps.
    let third: Complex64 = (0..count)
        .map(|k| {
            let theta = (f64::from(k) + 0.5) * step;
            let slope = (volume(&engine, theta + 1e-5) - volume(&engine, theta - 1e-5)) / 2e-5;
            let gas = &report.cylinders[0];
            let own = volumes[0].own_angle(theta);
            (gas.cylinder.at(own) - gas.crankcase.at(own)) * slope * Complex64::cis(-3.0 * theta)
        })
        .sum();
    let wanted = -3.0 * 2.0 / f64::from(count) * third;
    assert!(wanted.norm() > 100.0, "{wanted}");
    assert!((of_gas - wanted).norm() < 1e-3 * wanted.norm(), "{of_gas} {wanted}");
}
