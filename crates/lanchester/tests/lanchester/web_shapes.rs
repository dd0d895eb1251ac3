//! Counterweights designed on their webs: one mass in all places, nothing that the check refuses.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::file::{EngineFile, read, write_back};
use lanchester::geometry::{Design, DesignOutcome, Objective};
use lanchester::model::Engine;
use lanchester::{
    CounterweightRequest, adopted, check_counterweights, counterweight_front, crankshaft_parts,
    design_counterweights, with_counterweights,
};

const EXAMPLE: &str = include_str!("../../../../examples/in-line-3-counterweights.toml");

/// The example with its counterweights as they are.
fn example() -> EngineFile {
    let read = read(EXAMPLE);
    read.file.unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn engine(text: &str) -> Engine {
    read(text).engine().unwrap()
}

fn request() -> CounterweightRequest {
    let task = example().tasks.shape_task.unwrap();
    CounterweightRequest { weights: Vec::new(), unbalance: None, task, evolution: None }
}

fn designs(engine: &Engine) -> Vec<(usize, Design)> {
    let designs = design_counterweights(engine, &request()).unwrap();
    let found = designs.weights.iter().map(|weight| match &weight.outcome {
        DesignOutcome::Found(best) => {
            assert!(best.proved);
            (weight.index, best.design)
        }
        DesignOutcome::Infeasible(why) => panic!("{}: {why:?}", weight.name),
    });
    found.collect()
}

fn is_near(a: f64, b: f64, relative: f64, what: &str) {
    assert!((a / b - 1.0).abs() < relative, "{what}: {a} {b}");
}

/// The same number from the optimum, the front, the check of the fitted engine, its file read again, and the solids less what they cover of the web.
#[test]
fn xcheck_design_front_check_and_solid_have_one_mass() {
    let before = example().engine;
    let found = designs(&before);
    let front = counterweight_front(&before, &request(), Objective::SweptRadius, 5).unwrap();
    let fitted = with_counterweights(&before, &found, request().task.density).unwrap();
    let again = engine(&write_back(EXAMPLE, &fitted).unwrap());
    let checked = check_counterweights(&fitted).unwrap();
    let read_again = check_counterweights(&again).unwrap();
    let bare = before.without_counterweights();
    let bodies = [&bare, &fitted].map(|engine| check_counterweights(engine).unwrap());
    let [plain, whole] = bodies.map(|body| body.crankshafts[0].mass.mass);
    let mut sum = 0.0;
    for ((_, design), (check, read)) in
        found.iter().zip(checked.counterweights.iter().zip(&read_again.counterweights))
    {
        is_near(design.mass, check.mass, 1e-9, "check");
        is_near(design.mass, read.mass, 1e-4, "file");
        is_near(design.unbalance, 88.76e-3, 1e-9, "unbalance");
        is_near(design.inertia, check.polar_inertia, 1e-9, "inertia");
        // A front has one envelope for all of its designs, nearer by the micrometres that one of them misses between two directions.
        is_near(design.mass, front.front.designs[0].mass, 1e-5, "front");
        // Within the solid are the web's disc, 26 mm of 46.35 mm radius, and the flank that it covers.
        let disc = 7850.0 * 0.026 * std::f64::consts::PI * 0.04635f64.powi(2);
        let flank = check.part_mass - disc - check.mass;
        assert!(flank > 1e-3 && flank < 5e-3, "{flank}");
        let parts = crankshaft_parts(&fitted, 0, std::slice::from_ref(&check.name)).unwrap();
        is_near(parts[0].part.moments().mass, check.part_mass, 1e-12, "solid");
        sum += design.mass;
    }
    // What the whole crankshaft gains, from its own integration.
    is_near(whole - plain, sum, 1e-9, "crankshaft");
    for (_, design) in adopted(&before, &request(), &front, &front.front.designs[0]).unwrap() {
        is_near(design.mass, found[0].1.mass, 1e-5, "adopted");
    }
}

/// What is returned keeps the clearance; it is lighter than what a circle allows, and no lighter than the best of all.
#[test]
fn the_true_envelope_bounds_design_and_front() {
    let before = example().engine;
    let designs = design_counterweights(&before, &request()).unwrap();
    for weight in &designs.weights {
        let DesignOutcome::Found(best) = &weight.outcome else { panic!("{weight:?}") };
        let envelope = weight.envelope.as_ref().unwrap();
        let circle = weight.room.as_ref().unwrap().radius;
        assert!(envelope.smallest() > circle - 2e-6, "{} {circle}", envelope.smallest());
        assert!(best.value >= weight.without_room.unwrap());
        let mut round = request();
        round.weights = vec![weight.name.clone()];
        round.task.limits.swept_radius = Some(circle);
        let round = design_counterweights(&before, &round).unwrap();
        let DesignOutcome::Found(round) = &round.weights[0].outcome else { panic!("{round:?}") };
        // The piston comes down thirty degrees beside the middle of the shape, where no circle but one about the axis gains much.
        assert!(best.value < round.value * (1.0 - 5e-4), "{} {}", best.value, round.value);
    }
    let density = request().task.density;
    let fitted = with_counterweights(&before, &self::designs(&before), density).unwrap();
    let checked = check_counterweights(&fitted).unwrap();
    assert!(checked.is_kept, "{:?}", checked.clearances.unwrap().smallest);
    for against in [Objective::SweptRadius, Objective::Inertia, Objective::Thickness] {
        let mut wide = request();
        wide.task.thickness.least = 0.022;
        let front = counterweight_front(&before, &wide, against, 6).unwrap();
        assert!(front.front.proved && !front.front.designs.is_empty(), "{against:?}");
        for design in &front.front.designs {
            is_near(design.balance, 1.0, 2e-7, "balance");
            let all: Vec<(usize, Design)> = front.weights.iter().map(|index| (*index, *design)).collect();
            let fitted = with_counterweights(&before, &all, density).unwrap();
            let checked = check_counterweights(&fitted).unwrap();
            assert!(checked.is_kept, "{against:?} {:?}", checked.clearances.unwrap().smallest);
        }
    }
}

/// No room, no shape: a web that is itself too near is none that a counterweight could be right on.
#[test]
fn what_cannot_keep_clear_is_no_design() {
    for change in [
        ("crankcase_radius = \"100 mm\"", "crankcase_radius = \"47 mm\""),
        ("skirt_length = \"11 mm\"", "skirt_length = \"60 mm\""),
        ("shank_thickness = \"18 mm\"", "shank_thickness = \"28 mm\""),
    ] {
        let engine = engine(&EXAMPLE.replace(change.0, change.1));
        let designs = design_counterweights(&engine, &request()).unwrap();
        for weight in &designs.weights {
            assert!(matches!(weight.outcome, DesignOutcome::Infeasible(_)), "{change:?} {weight:?}");
            assert!(weight.envelope.as_ref().unwrap().limit.is_some());
        }
        let front = counterweight_front(&engine, &request(), Objective::Inertia, 4).unwrap();
        assert!(front.front.designs.is_empty(), "{change:?}");
    }
}
