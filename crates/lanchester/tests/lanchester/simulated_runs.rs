//! Simulated runs of engine files. Energy: a closed cylinder keeps it, and the fuel's is found again.
//!
//! The rigid runs of Louvigny and others (2009): three revolutions of a single at an imposed 4000 rpm, simulated, against what the paper prints.

use lanchester::file::{EngineFile, read};
use lanchester::model::RunLength;
use lanchester::multibody::RunOutcome;
use lanchester::report::SimulationResult;
use lanchester::{CrossCheckRequest, SimulateRequest, TraceFile, crosscheck, simulate};
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::Path;

/// The run of the stored engine file, as the guide has it.
fn run(gas: bool) -> (EngineFile, SimulationResult) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let text = fs::read_to_string(folder.join("flexible-paper/rigid-run.toml")).unwrap();
    let file = read(&text).file.unwrap();
    let name = "../traces/pressure-4000.csv";
    let trace = fs::read_to_string(folder.join("traces/pressure-4000.csv")).unwrap();
    let traces = [TraceFile { name: name.to_owned(), text: trace }];
    let request = SimulateRequest { gas: Some(gas), step: Some(PI / 180.0), ..SimulateRequest::default() };
    let result = simulate(&file, &traces, &request).unwrap();
    assert_eq!(result.run.outcome, RunOutcome::Complete);
    (file, result)
}

/// Position, speed and acceleration of the piston over three revolutions are those of the textbook's slider-crank, written here once more, to rounding; the
/// printed acceleration "about 11000 m/s2" is that at top dead centre, rounded.
#[test]
fn lit_louvigny_2009_motion_of_the_piston() {
    let (file, result) = run(false);
    let samples = &result.run.samples;
    let (w, r, l) = (4000.0 * PI / 30.0, 0.0955 / 2.0, 0.144);
    assert!((samples.theta.last().unwrap() - 3.0 * TAU).abs() < 1e-9 && samples.theta.len() == 3 * 360 + 1);
    let mut largest: f64 = 0.0;
    for (theta, reactions) in samples.theta.iter().zip(&samples.reactions) {
        let (sin, cos) = theta.sin_cos();
        let rod = (l * l - r * r * sin * sin).sqrt();
        let wanted = [
            r * cos + rod,
            -w * (r * sin + r * r * sin * cos / rod),
            -w * w
                * (r * cos
                    + r * r * (cos * cos - sin * sin) / rod
                    + (r * r * sin * cos).powi(2) / rod.powi(3)),
        ];
        for (k, (got, wanted)) in reactions.cylinders[0].travel.into_iter().zip(wanted).enumerate() {
            let scale = [l, w * r, w * w * r][k];
            assert!((got - wanted).abs() < 1e-9 * scale, "theta {theta}, derivative {k}: {got} {wanted}");
        }
        largest = largest.max(reactions.cylinders[0].travel[2].abs());
    }
    // 11156 m/s2: 1.4 % above the rounded number of the paper.
    assert!((largest / 11_000.0 - 1.0).abs() < 0.02, "{largest}");
    // A third of the rod's mass oscillates: 10835 N is the paper's product with the rounded acceleration.
    let oscillating = file.engine.cylinders[0].piston_mass + file.engine.cylinders[0].rod.mass() / 3.0;
    assert!((oscillating * 11_000.0 / 10_835.0 - 1.0).abs() < 1e-3, "{oscillating}");
}

/// Rod force on the crankpin with the synthetic trace, towards the crank axis and in the sense of rotation: what is left is the misfit of the trace, which
/// `validate` lists for the closed form.
#[test]
fn lit_louvigny_2009_rod_force_on_the_crankpin() {
    let (_, result) = run(true);
    let samples = &result.run.samples;
    // The second cycle of four strokes has not ended: forces are largest after the first firing, and after that two revolutions later.
    let of = |k: usize, sign: f64, from: f64| {
        let all = samples.theta.iter().zip(&samples.reactions);
        let near = all.filter(|(theta, _)| (**theta - from).abs() < 0.5 * PI);
        near.map(|(theta, own)| (sign * own.cylinders[0].throw_frame[k], (theta - from).to_degrees()))
            .fold((f64::NEG_INFINITY, 0.0), |best, own| if own.0 > best.0 { own } else { best })
    };
    for from in [0.0, 2.0 * TAU] {
        let (radial, radial_at) = of(0, -1.0, from);
        let (tangential, tangential_at) = of(1, 1.0, from);
        let index = (from.to_degrees()).round() as usize;
        let at_top = -samples.reactions[index].cylinders[0].throw_frame[0];
        for (name, got, printed, misfit) in [
            ("radial", radial, 65e3, 0.5e3),
            ("its angle", radial_at, 7.0, 1.5),
            ("tangential", tangential, 36e3, 0.1e3),
            ("its angle", tangential_at, 24.0, 1.5),
            ("radial at top dead centre", at_top, 45e3, 0.4e3),
        ] {
            assert!((got - printed).abs() <= misfit, "{name} from {from}: {got}, printed {printed}");
        }
    }
}

fn file_of(text: &str) -> EngineFile {
    let found = read(text);
    found.file.unwrap_or_else(|| panic!("{:?}", found.diagnostics))
}

fn run_of(file: &EngineFile) -> SimulationResult {
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
    let result = run_of(&file_of(text));
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
    let result = run_of(&file_of(text));
    let heat = result.heat.expect("a computed cycle");
    assert!((heat.fuel - 3.0 * 1000.0).abs() < 1e-9 * heat.fuel, "{heat:?}");
    assert!(heat.walls > 0.02 * heat.fuel && heat.exhaust > 0.1 * heat.fuel, "{heat:?}");
    let taken = heat.unburned + heat.walls + heat.exhaust + heat.indicated;
    assert!((taken - heat.fuel).abs() < 1e-9 * heat.fuel, "{heat:?}");
    let period = result.run.last_period.expect("a whole period");
    assert!((period.gas / heat.indicated - 1.0).abs() < 0.01, "{} {heat:?}", period.gas);
    // A governed engine does not tell how much it burns.
    let governed = text.to_owned() + "\n[governor]\nspeed = \"2000 rpm\"\ngain = \"0.02 1/rpm\"\n";
    assert_eq!(run_of(&file_of(&governed)).heat, None);
}

/// On mounts with a loss factor the block rests where the same springs without one hold it, whatever the loss factor, and swings about that place.
#[test]
fn a_block_on_mounts_with_a_loss_factor_rests_where_their_static_stiffness_holds_it() {
    let text = include_str!("../../../../examples/generator-set-3.toml");
    let rest = |damping: &str| {
        let text = text.replace("damping = \"250 N s/m\"", damping);
        assert_eq!(text.matches(damping).count(), 4, "each of its four mounts");
        let file = read(&text).file.unwrap();
        let request = SimulateRequest {
            speed: Some(1500.0 * PI / 30.0),
            length: Some(RunLength::Revolutions(1.0)),
            ..SimulateRequest::default()
        };
        simulate(&file, &[], &request).unwrap().run.samples.position[0][0]
    };
    let wanted = rest("damping = \"250 N s/m\"");
    // 3.3 mm: the weight over the sum of the stiffnesses.
    assert!((wanted + 3.327e-3).abs() < 1e-5, "{wanted}");
    for loss in ["0.02", "0.08", "0.12", "0.15"] {
        let found = rest(&format!("loss_factor = {loss}"));
        assert!((found / wanted - 1.0).abs() < 1e-9, "loss factor {loss}: {found} {wanted}");
    }
}

/// Runs, films and comparisons of rungs are the same bit by bit however many threads there are.
#[test]
fn answers_have_the_same_bits_for_any_number_of_threads() {
    let text = include_str!("../../../../examples/three-cylinder.toml");
    let file = file_of(text);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let run = serde_json::to_string(&run_of(&file)).unwrap();
            let check = crosscheck(&file.engine, &[], &CrossCheckRequest::default()).unwrap();
            (run, serde_json::to_string(&check).unwrap())
        })
    };
    let alone = with(1);
    assert!(alone.0.len() > 100_000 && alone.1.contains("bond graph"), "something was computed");
    for threads in [2, 3] {
        assert!(with(threads) == alone, "{threads} threads");
    }
}
