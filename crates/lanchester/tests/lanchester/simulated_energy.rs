//! Energy of simulated runs of engine files: a closed cylinder keeps it, and the fuel's is found again.

use lanchester::file::{EngineFile, read};
use lanchester::report::SimulationResult;
use lanchester::{SimulateRequest, simulate};
use std::f64::consts::TAU;

fn file(text: &str) -> EngineFile {
    let found = read(text);
    found.file.unwrap_or_else(|| panic!("{:?}", found.diagnostics))
}

fn run(file: &EngineFile) -> SimulationResult {
    simulate(file, &[], &SimulateRequest::default()).expect("it runs")
}

/// A closed cylinder gives back what it takes, for a hundred revolutions.
#[test]
fn closed_cylinders_keep_the_energy() {
    let text = r#"
name = "closed"
speed = "400 rpm"
[crank]
stroke = "90 mm"
[[throw]]
angle = "0 deg"
z = "0 mm"
[[throw]]
angle = "90 deg"
z = "100 mm"
[rod]
length = "150 mm"
big_end_mass = "0.4 kg"
small_end_mass = "0.2 kg"
[piston]
mass = "0.5 kg"
bore = "80 mm"
[[cylinder]]
throw = 1
angle = "0 deg"
[[cylinder]]
throw = 2
angle = "0 deg"
[firing]
order = [1, 2]
[flywheel]
inertia = "0.3 kg m2"
[gas]
compression_ratio = 9
[gas.cycle]
type = "sealed"
pressure = "1.5 bar"
heat_capacity_ratio = 1.3
[load]
type = "none"
[simulation]
speed = "free"
start = { speed = "400 rpm" }
duration = "100 revolutions"
tolerance = 1e-12
"#;
    let result = run(&file(text));
    assert_eq!(result.heat, None, "nothing burns");
    let (theta, speed) = (&result.run.samples.theta, &result.run.samples.speed);
    let (least, most) = speed.iter().fold((f64::MAX, 0.0f64), |(a, b), w| (a.min(*w), b.max(*w)));
    assert!(most > 1.1 * least, "the gas brakes and drives: {least} {most}");
    let start = speed[0];
    for (theta, speed) in theta.iter().zip(speed) {
        let turns = theta / TAU;
        if (turns - turns.round()).abs() < 1e-9 {
            assert!((speed / start - 1.0).abs() < 1e-9, "{turns}: {speed}");
        }
    }
    let period = result.run.last_period.expect("a whole period");
    assert!(period.gas.abs() < 1e-9 * result.run.energy.throughput, "{period:?}");
}

/// Each of three cylinders burns its fuel once in a period; walls, exhaust and work take it, and the run's gas does what the cycles do.
#[test]
fn the_fuel_of_a_period_is_found_again() {
    let text = include_str!("../../../../examples/three-cylinder.toml");
    let result = run(&file(text));
    let heat = result.heat.expect("a computed cycle");
    assert!((heat.fuel - 3.0 * 1000.0).abs() < 1e-9 * heat.fuel, "{heat:?}");
    assert!(heat.walls > 0.02 * heat.fuel && heat.exhaust > 0.1 * heat.fuel, "{heat:?}");
    let taken = heat.unburned + heat.walls + heat.exhaust + heat.indicated;
    assert!((taken - heat.fuel).abs() < 1e-9 * heat.fuel, "{heat:?}");
    let period = result.run.last_period.expect("a whole period");
    assert!((period.gas / heat.indicated - 1.0).abs() < 0.01, "{} {heat:?}", period.gas);
    // A governed engine does not tell how much it burns.
    let governed = text.to_owned() + "\n[governor]\nspeed = \"2000 rpm\"\ngain = \"0.02 1/rpm\"\n";
    assert_eq!(run(&file(&governed)).heat, None);
}
