//! Loads of a crankshaft from a simulated run: at imposed speed those of the closed form, at free speed in balance with what speeds the crankshaft up.

use lanchester::file::EngineFile;
use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::geometry::crankshaft::crankshaft;
use lanchester::model::RunLength;
use lanchester::report::StaticStress;
use lanchester::{
    LoadSource, SimulateRequest, StaticRequest, StressError, StressLoad, StressMesh, static_stress,
};
use std::f64::consts::PI;

/// A throw with bodies, a flywheel and a closed cylinder; `rest` says more of cylinders.
fn file(layout: &str, rest: &str) -> EngineFile {
    let text = format!(
        r#"
name = "throw"
speed = ["2000 rpm", "4000 rpm"]
[layout]
{layout}
[crank]
stroke = "95.5 mm"
web_distance = "48 mm"
[crank.body]
density = "7850 kg/m3"
journal_diameter = "55 mm"
pin_diameter = "48 mm"
web_thickness = "20 mm"
web_radius = "40 mm"
pin_end_radius = "36 mm"
end_journals = ["25 mm", "25 mm"]
pin_fillet = "6 mm"
journal_fillet = "6 mm"
[flywheel]
inertia = "0.08 kg m2"
[piston]
mass = "0.5 kg"
bore = "80 mm"
{rest}
"#
    );
    let found = lanchester::file::read(&text);
    found.file.unwrap_or_else(|| panic!("{:?}", found.diagnostics))
}

const SINGLE: &str = "type = \"in-line\"\ncylinders = 1\nspacing = \"90 mm\"";
const ROD: &str =
    "[rod]\nlength = \"150 mm\"\nmass = \"0.6 kg\"\ncentre_of_gravity = \"45 mm\"\ninertia = \"0.002 kg m2\"";
const GAS: &str = "[gas]\ncompression_ratio = 9\n[gas.cycle]\ntype = \"sealed\"\npressure = \"1 bar\"\nheat_capacity_ratio = 1.35";

fn solved(file: &EngineFile, load: StressLoad, source: LoadSource, speed: f64) -> StaticStress {
    let options = CrankMeshOptions { size: 0.02, fillet_elements: 2, ..CrankMeshOptions::default() };
    let mesh = StressMesh { options, ..StressMesh::default() };
    let request = StaticRequest { mesh, load, source, speeds: vec![speed], ..StaticRequest::default() };
    static_stress(&file.engine, &[], &request, &|_| {}).unwrap()
}

fn run(file: &EngineFile, imposed: bool) -> LoadSource {
    let request = SimulateRequest {
        imposed: Some(imposed),
        on_mounts: Some(false),
        gravity: Some(false),
        length: Some(RunLength::Revolutions(4.0)),
        ..SimulateRequest::default()
    };
    LoadSource::of_run(&file.tasks, request)
}

/// At imposed speed, in a block that stands and without weight, both rungs give the same forces and the same stress, of articulated rods too.
#[test]
fn at_imposed_speed_they_are_those_of_the_closed_form() {
    let radial = "type = \"radial\"\ncylinders = 3\nknuckle_radius = \"40 mm\"\n[firing]\norder = [1, 3, 2]";
    let slaves = format!("{ROD}\n{GAS}\n[articulated_rod]\nlength = \"110 mm\"\nmass = \"0.4 kg\"");
    let single = format!("{ROD}\n{GAS}");
    for (layout, rest) in [(SINGLE, &single), (radial, &slaves)] {
        let file = file(layout, rest);
        let angles = [0.0f64, 24.0, 77.5, 371.0].map(f64::to_radians).to_vec();
        let speed = 3000.0 * PI / 30.0;
        let load = StressLoad::Angles(angles);
        let closed = solved(&file, load.clone(), LoadSource::ClosedForm, speed);
        let simulated = solved(&file, load, run(&file, true), speed);
        assert_eq!(simulated.gas, closed.gas);
        for (one, two) in closed.cases.iter().zip(&simulated.cases) {
            let (a, b) = (&one.forces[0], &two.forces[0]);
            let size = a.radial.hypot(a.tangential);
            let off = (a.radial - b.radial).hypot(a.tangential - b.tangential) / size;
            // Half a degree lies between samples.
            let between = one.theta.is_some_and(|theta| (theta.to_degrees() - 77.5).abs() < 1e-9);
            assert!(off < if between { 1e-5 } else { 1e-9 }, "{layout} {:?}: {off}", one.theta);
            assert!((two.speed / speed - 1.0).abs() < 1e-9 && two.loading.acceleration.abs() < 1e-6);
            let peak = |case: &lanchester::report::StressCase| {
                case.result
                    .peaks
                    .iter()
                    .filter_map(|peak| peak.stress)
                    .map(|own| own.von_mises)
                    .fold(0.0, f64::max)
            };
            assert!((peak(one) / peak(two) - 1.0).abs() < 1e-5, "{} {}", peak(one), peak(two));
        }
    }
}

/// Without gas and load the rod alone speeds the crankshaft up: `J W' = r F_t`, and its speed is that of the energy that the masses give back.
#[test]
fn at_free_speed_they_are_in_balance_with_what_speeds_the_crankshaft_up() {
    let file = file(SINGLE, ROD);
    let speed = 3000.0 * PI / 30.0;
    let found = solved(&file, StressLoad::Extremes, run(&file, false), speed);
    assert!(found.cases.len() >= 2, "{}", found.cases.len());
    let crank = crankshaft(&file.engine, 0).unwrap().polar_inertia;
    let mut largest = 0.0f64;
    for case in &found.cases {
        let torque = 0.5 * 0.0955 * case.forces[0].tangential;
        let wanted = torque / (0.08 + crank);
        assert!(
            (case.loading.acceleration - wanted).abs() < 1e-9 * speed * speed,
            "{} {wanted}",
            case.loading.acceleration
        );
        assert!(case.name.contains("largest") && case.name.contains("on pin 1"), "{}", case.name);
        largest = largest.max(wanted.abs());
    }
    // The tangential case speeds it up by some thousand rad/s2.
    assert!(largest > 500.0, "{largest}");
    assert!(found.cases.iter().any(|case| (case.speed / speed - 1.0).abs() > 1e-3), "the speed swings");
    assert!(found.notes.iter().any(|note| note.contains("simulated run of")), "{:?}", found.notes);
}

/// A run that is too short for an angle says so.
#[test]
fn an_angle_that_the_run_does_not_pass_is_refused() {
    let file = file(SINGLE, ROD);
    let request = SimulateRequest { length: Some(RunLength::Revolutions(0.5)), ..SimulateRequest::default() };
    let request = StaticRequest {
        load: StressLoad::Angles(vec![300.0f64.to_radians()]),
        source: LoadSource::of_run(&file.tasks, request),
        ..StaticRequest::default()
    };
    let error = static_stress(&file.engine, &[], &request, &|_| {}).unwrap_err();
    assert!(matches!(error, StressError::NotReached { .. }), "{error}");
    assert!(
        error.to_string().contains("0.500 revolutions") && error.to_string().contains("300.0 deg"),
        "{error}"
    );
}
