//! The flexible crankshaft over the cycle: limits that other computations know.

use lanchester::flex::crank_mesh::CrankMeshOptions;
use lanchester::flex::train::{BasisKind, BasisOptions, CycleOutcome, FreeSpeed};
use lanchester::mechanism::{
    BearingPart, BearingRequest, OuterTorque, RippleOutcome, bearing_loads, speed_ripple,
};
use lanchester::model::Engine;
use lanchester::report::{
    Condition, CrankCycle, CrankKind, CrossVerdict, CycleLaw, CycleSpeed, crank_cycle_figures, cycle_brief,
    cycle_csv,
};
use lanchester::{
    CrossCheckRequest, CycleRequest, CycleStage, FatigueRequest, StaticRequest, StressLoad, StressMesh,
    crank_cycle, crank_fatigue, crosscheck, cylinder_gas, rotating_bodies, static_stress,
};
use std::f64::consts::PI;

const FILE: &str = r#"
name = "single"
speed = ["4000 rpm"]
strokes = 4
[layout]
type = "in-line"
cylinders = 1
spacing = "90 mm"
[firing]
order = [1]
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
[crank.material]
preset = "42CrMo4 quenched and tempered"
[piston]
mass = "0.5 kg"
bore = "86 mm"
[rod]
length = "150 mm"
mass = "0.6 kg"
[flywheel]
inertia = "0.2 kg m2"
[gas]
compression_ratio = 10
cycle = { type = "otto" }
fuel = { energy = "800 J" }
"#;

fn engine() -> Engine {
    lanchester::file::read(FILE).engine().unwrap()
}

/// With fillets of 4 mm, which leave the journals longer; the mesh has twice as many nodes.
fn fine_engine() -> Engine {
    lanchester::file::read(&FILE.replace("fillet = \"6 mm\"", "fillet = \"4 mm\"")).engine().unwrap()
}

fn request(laws: &[CycleLaw]) -> CycleRequest {
    let options = CrankMeshOptions { size: 0.02, fillet_elements: 2, ..CrankMeshOptions::default() };
    CycleRequest {
        mesh: StressMesh { options, ..StressMesh::default() },
        laws: laws.to_vec(),
        rigid_crank: true,
        basis: BasisOptions { modes: 6, ..BasisOptions::default() },
        instants: 96,
        ..CycleRequest::default()
    }
}

fn largest(loads: &[[f64; 2]]) -> f64 {
    loads.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max)
}

fn run(found: &CrankCycle, law: CycleLaw, crank: CrankKind) -> &lanchester::report::CycleRun {
    found.runs.iter().find(|run| run.law == law && run.crank == crank).unwrap()
}

/// Centrifugal load of the two fillets of the pin on each of the two mains at 4000 rpm [N]: by Pappus's rule, 4 mm about a pin of 48 mm, at 47.75 mm.
fn load_of_fillets(radius: f64) -> f64 {
    let (pin, throw) = (24e-3, 47.75e-3);
    let area = (1.0 - PI / 4.0) * radius * radius;
    // Middle of the region between two lines at right angles and the arc that touches both.
    let middle = radius * (10.0 - 3.0 * PI) / (3.0 * (4.0 - PI));
    let mass = 7850.0 * area * 2.0 * PI * (pin + middle);
    mass * throw * (4000.0 * PI / 30.0f64).powi(2)
}

#[test]
fn a_rigid_crankshaft_has_the_loads_of_the_simulation_and_the_films_of_its_own_kind() {
    let asked = CycleRequest { gas: false, ..request(&CycleLaw::FOUR) };
    let found = crank_cycle(&fine_engine(), &[], &asked, &|_| true).unwrap();
    assert_eq!(found.runs.len(), 8);
    let rules = found.rules.as_ref().unwrap();
    let rigid = run(&found, CycleLaw::Rigid, CrankKind::Rigid);
    for main in 0..2 {
        let theirs = &rules.loads[main][0];
        let ours = &rigid.bearings[main].load;
        assert_eq!(ours.len(), theirs.len());
        let apart: Vec<[f64; 2]> = ours.iter().zip(theirs).map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect();
        // The mesh has the fillets of the pin, which the file's numbers have not; with them alone both are the same.
        assert!((largest(&apart) / load_of_fillets(4e-3) - 1.0).abs() < 0.02, "{main}: {}", largest(&apart));
    }
    // By inertia a film of the dynamic rigid crankshaft is that of the massless journal.
    let film = run(&found, CycleLaw::Film, CrankKind::Rigid);
    for own in &film.bearings {
        let least = own.film.unwrap();
        let ratio = least.thickness / least.quasi_static.unwrap();
        // The fillets' mass, and a sample every 3.75 deg.
        assert!((ratio - 1.0).abs() < 0.01, "{}: {ratio}", own.name());
        assert!(
            (least.at_ends / least.thickness - 1.0).abs() < 1e-9,
            "a rigid crankshaft on two like mains has no slope"
        );
    }
    for own in &found.runs {
        assert!(own.energy_error <= 1e-4, "{}: {}", own.name(), own.energy_error);
        assert_eq!(own.outcome, CycleOutcome::Periodic, "{}", own.name());
        assert_eq!(own.fillets.len(), if own.crank == CrankKind::Flexible { 4 } else { 0 });
    }
    assert!(found.is_sound() && found.static_safety().unwrap() > 1.0);
    // A bearing that yields lets the centres part by load over stiffness about; none goes through its contact.
    let bushing = run(&found, CycleLaw::Bushing, CrankKind::Flexible);
    let own = &bushing.bearings[0];
    let ratio = own.largest_eccentricity * 2e9 / own.largest_load;
    assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
    let (heads, rows) = found.traces();
    // One period of an engine without gas: a revolution; law and angle, speed, torque, four of each bearing, four fillets.
    assert_eq!(
        (heads.len(), rows.len()),
        (4 + 4 * 3 + 4, found.runs.iter().map(|run| run.theta.len()).sum())
    );
    assert!(rows.iter().all(|(_, row)| row.len() + 1 == heads.len()));
    assert_eq!(crank_cycle_figures(&found).len(), 4);
    let csv = cycle_csv(&found);
    assert!(csv.contains("pin 1 at web 1,von Mises") && csv.contains("pin 1 at web 1,safety of all"));
    fatigue_is_that_of_the_closed_form(&found);
}

/// Slow against its vibration, in rigid bearings, the crankshaft has the safety of fatigue under the loads of the closed form.
fn fatigue_is_that_of_the_closed_form(found: &CrankCycle) {
    let asked = FatigueRequest {
        mesh: request(&[]).mesh,
        speeds: vec![found.speed],
        gas: false,
        ..FatigueRequest::default()
    };
    let wanted = crank_fatigue(&fine_engine(), &[], &asked, &|_| {}).unwrap();
    let own = run(found, CycleLaw::Rigid, CrankKind::Flexible);
    let allowed = found.fatigue.unwrap().findley.allowed;
    assert_eq!(own.fatigue.len(), 4);
    for ((own, wanted), peak) in own.fatigue.iter().zip(&wanted.speeds[0].fillets).zip(&own.fillets) {
        let value = own.point.plane.value;
        let ratio = value / wanted.point.plane.value;
        // Patterns of the pressure up to its fourth order on a coarse mesh, and what is left of vibration.
        assert!((ratio - 1.0).abs() < 0.03 && own.name == wanted.name, "{}: {ratio}", own.name);
        assert!((own.point.safety_of_all.unwrap() * value / allowed - 1.0).abs() < 1e-9);
        assert!((peak.peak / own.von_mises - 1.0).abs() < 1e-12);
    }
    let (run, worst) = found.most_fatigued().unwrap();
    let least = run.fatigue.iter().filter_map(|own| own.point.safety_of_all).fold(f64::INFINITY, f64::min);
    assert_eq!(worst.point.safety_of_all, Some(least));
    let all = found.runs.iter().flat_map(|run| &run.fatigue).map(|own| own.point);
    let least = all
        .flat_map(|own| [own.safety_of_all, own.safety_of_amplitude])
        .flatten()
        .fold(f64::INFINITY, f64::min);
    let (_, weakest) = found.weakest().unwrap();
    assert_eq!(weakest.least_safety(), least);
    assert!(weakest.is_safe(0.99 * least) && !weakest.is_safe(1.01 * least));
    // A rigid crankshaft has no stress that could tire.
    assert!(self::run(found, CycleLaw::Film, CrankKind::Rigid).fatigue.is_empty());
}

/// Counterweights without a shape load the mains as in the closed form: on a web, in the plane of the throw, and at the flywheel.
#[test]
fn counterweights_without_a_shape_load_the_mains_as_in_the_closed_form() {
    let weights = "[[counterweight]]\nweb = 1\nunbalance = \"0.02 kg m\"\n[[counterweight]]\nthrow = 1\nangle = \"150 deg\"\nunbalance = \"0.01 kg m\"\n\
                   [[counterweight]]\nname = \"flywheel\"\nz = \"75 mm\"\nangle = \"60 deg\"\nunbalance = \"0.004 kg m\"\n";
    let engine = lanchester::file::read(&format!("{FILE}{weights}")).engine().unwrap();
    let asked = CycleRequest { gas: false, ..request(&[CycleLaw::Rigid]) };
    let found = crank_cycle(&engine, &[], &asked, &|_| true).unwrap();
    assert_eq!(found.sheet.crank.weights.len(), 3);
    let rules = found.rules.as_ref().unwrap();
    let rigid = run(&found, CycleLaw::Rigid, CrankKind::Rigid);
    for main in 0..2 {
        let theirs = &rules.loads[main][0];
        let ours = &rigid.bearings[main].load;
        let apart: Vec<[f64; 2]> = ours.iter().zip(theirs).map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect();
        assert!((largest(&apart) / load_of_fillets(6e-3) - 1.0).abs() < 0.02, "{main}: {}", largest(&apart));
    }
    // Static cases: all supports together carry what all mains carry.
    let speed = engine.speed.highest;
    let inertia = BearingRequest {
        speed: Some(speed),
        part: BearingPart::Inertia,
        samples: 72,
        ..BearingRequest::default()
    };
    let closed = bearing_loads(&engine, None, &inertia).unwrap();
    let samples = [5, 33, 58];
    let load = StressLoad::Angles(samples.map(|k| closed.theta[k]).to_vec());
    let mesh = asked.mesh.clone();
    let request = StaticRequest { mesh, load, gas: false, speeds: vec![speed], ..StaticRequest::default() };
    let solved = static_stress(&engine, &[], &request, &|_| ()).unwrap();
    for (case, k) in solved.cases.iter().zip(samples) {
        let wanted = closed.mains.iter().map(|main| main.journal_frame[k]);
        let [x, y] = wanted.fold([0.0; 2], |[x, y], own| [x + own.re, y + own.im]);
        // Fillets of the pin, which the closed form has not, load the mains along the throw.
        let apart = [x - case.reaction[0], y - case.reaction[1]];
        assert!((apart[0] / (2.0 * load_of_fillets(6e-3)) - 1.0).abs() < 0.02, "{k}: {apart:?}");
        assert!(apart[1].abs() < 0.02 * load_of_fillets(6e-3), "{k}: {apart:?}");
    }
}

/// With a heavy flywheel, and with one so light that the crankshaft twists beside it.
#[test]
fn a_free_rigid_crankshaft_swings_as_the_closed_form_says() {
    for (inertia, speed) in [("0.2", "4000 rpm"), ("0.02", "7000 rpm")] {
        let file = FILE.replace("0.2 kg m2", &format!("{inertia} kg m2")).replace("4000 rpm", speed);
        let engine = lanchester::file::read(&file).engine().unwrap();
        let asked = CycleRequest { motion: CycleSpeed::Free, ..request(&[CycleLaw::Rigid]) };
        let found = crank_cycle(&engine, &[], &asked, &|_| true).unwrap();
        assert!(found.is_sound(), "{inertia}");
        let gas = cylinder_gas(&engine, &[], engine.speed.highest).unwrap();
        let known = lanchester::mechanism::KnownInertia::of_bodies(&rotating_bodies(&engine));
        let ripple =
            speed_ripple(&engine, Some(&gas.cylinders), engine.speed.highest, &OuterTorque::default(), known)
                .unwrap();
        let RippleOutcome::Periodic(ripple) = ripple else { panic!("{ripple:?}") };
        let rigid = run(&found, CycleLaw::Rigid, CrankKind::Rigid);
        let extremes =
            |speed: &[f64]| speed.iter().fold((f64::INFINITY, 0.0f64), |(a, b), w| (a.min(*w), b.max(*w)));
        let (low, high) = extremes(&rigid.speed);
        let swing = ripple.extremes.range();
        // Samples every 3.75 deg, the mesh's inertia beside the file's.
        assert!((low - ripple.extremes.min.value).abs() < 0.01 * swing, "{low} {:?}", ripple.extremes);
        assert!((high - ripple.extremes.max.value).abs() < 0.01 * swing, "{high} {:?}", ripple.extremes);
        let free = rigid.free_speed.unwrap();
        assert!(free.change <= 1e-3 && rigid.cycles <= 8, "{free:?} {}", rigid.cycles);
        // What the load takes is what the gas gives.
        assert!((free.load + ripple.load).abs() < 2e-3 * ripple.load, "{free:?} {}", ripple.load);
        let flexible = run(&found, CycleLaw::Rigid, CrankKind::Flexible);
        assert!(flexible.outcome == CycleOutcome::Periodic && flexible.energy_error <= 1e-4, "{inertia}");
        assert!(flexible.worst().unwrap().peak > 1e6);
        if inertia == "0.2" {
            // The flexible one turns its flywheel much the same.
            let top = extremes(&flexible.speed).1;
            assert!((top - high).abs() < 0.1 * swing, "{top} {high}");
        }
    }
}

#[test]
fn a_run_that_has_not_settled_says_so() {
    let asked = CycleRequest { gas: false, rigid_crank: false, most_cycles: 1, ..request(&[CycleLaw::Film]) };
    let mut found = crank_cycle(&engine(), &[], &asked, &|_| true).unwrap();
    let run = &mut found.runs[0];
    // One cycle is followed by up to five, which may repeat; what they left else is said with what to do.
    run.outcome = CycleOutcome::NotPeriodic;
    run.orbit_change = Some(0.0123);
    let words = run.outcome_words();
    assert!(
        words.contains("orbits by 1.23 % of the clearance") && words.contains("allow more cycles"),
        "{words}"
    );
    run.free_speed = Some(FreeSpeed { load: -40.0, change: 0.013 });
    let words = run.outcome_words();
    assert!(!run.is_sound() && words.contains("the free speed by 1.30 % of its swing"), "{words}");
    let cycles = run.cycles;
    let brief = cycle_brief(&found).replace('\n', " ");
    assert!(brief.contains(&format!("has not found its speed in {cycles} cycles")), "{brief}");
}

#[test]
fn what_is_stopped_is_told_so_far() {
    let first = |stage: CycleStage| !matches!(stage, CycleStage::Running { law: CycleLaw::Film, .. });
    let asked =
        CycleRequest { gas: false, rigid_crank: false, ..request(&[CycleLaw::Rigid, CycleLaw::Film]) };
    let found = crank_cycle(&engine(), &[], &asked, &first).unwrap();
    assert_eq!(found.runs[0].outcome, CycleOutcome::Periodic);
    assert_eq!(found.runs[1].outcome, CycleOutcome::Stopped);
    assert!(found.runs[1].bearings.is_empty() && !found.is_sound());
}

#[test]
fn the_last_rung_agrees_where_it_must() {
    let request =
        CrossCheckRequest { conditions: vec![Condition::FlexibleCrank], ..CrossCheckRequest::default() };
    let check = crosscheck(&engine(), &[], &request).unwrap();
    let rows = &check.conditions[0].rows;
    assert!(check.agrees() && rows.len() == 3, "{rows:?}");
    assert_eq!(rows[0].verdict, CrossVerdict::Agrees);
    assert!(rows[0].share() <= 1e-4, "{:?}", rows[0]);
    // A mesh with sharp corners has the masses of the file's numbers; an elastic crankshaft rings behind the jump of the pressure.
    assert_eq!(rows[1].verdict, CrossVerdict::Agrees, "{:?}", rows[1]);
    assert!(rows[2].verdict == CrossVerdict::DiffersAsItMust && rows[2].reason.is_some(), "{:?}", rows[2]);
    let bare =
        lanchester::file::read(lanchester::file::template("in-line-4").unwrap().text).engine().unwrap();
    let check = crosscheck(&bare, &[], &request).unwrap();
    assert!(check.conditions[0].not_applicable.as_ref().unwrap().contains("[crank.body]"));
    // Not asked for, it does not run.
    let usual = crosscheck(&bare, &[], &CrossCheckRequest::default()).unwrap();
    assert_eq!(usual.conditions.len(), 4);
}

/// Free modes with shapes balanced by inertia, and Craig and Bampton's modes with shapes balanced at the bearings, are two reductions of one crankshaft: with enough
/// modes both have the same stress in every fillet over the cycle, and the same loads.
#[test]
fn two_reductions_of_one_crankshaft_have_the_same_stress() {
    let of = |kind: BasisKind| {
        let plain = request(&[CycleLaw::Rigid]);
        let basis = BasisOptions { kind, modes: 24, ..plain.basis };
        let asked = CycleRequest { basis, rigid_crank: false, gas: false, ..plain };
        crank_cycle(&engine(), &[], &asked, &|_| true).unwrap()
    };
    let (free, held) = (of(BasisKind::FreeInterface), of(BasisKind::CraigBampton));
    let [one, two] = [&free, &held].map(|found| run(found, CycleLaw::Rigid, CrankKind::Flexible));
    assert_eq!(one.fillets.len(), 4);
    for (a, b) in one.fillets.iter().zip(&two.fillets) {
        let off = b.peak / a.peak - 1.0;
        assert!(off.abs() < 2e-3, "{}: {} and {} Pa, {off}", a.name, a.peak, b.peak);
    }
    for (a, b) in one.bearings.iter().zip(&two.bearings) {
        let off = b.largest_load / a.largest_load - 1.0;
        assert!(off.abs() < 2e-3, "{}: {off}", a.name());
    }
}

/// Widths, and what stands behind the shells.
const HOUSED: &str = r#"
[bearings.main]
width = "22 mm"
housing_stiffness = "1000 kN/mm"
[bearings.crankpin]
width = "24 mm"
[bearings.film]
viscosity = "10 mPa s"
"#;

#[test]
fn films_that_feel_the_tilt_tell_the_film_at_the_ends_and_housings_yield() {
    let engine = lanchester::file::read(&format!("{FILE}{HOUSED}")).engine().unwrap();
    let laws = [CycleLaw::Bushing, CycleLaw::Film];
    let asked = |tilt| CycleRequest { gas: false, rigid_crank: false, tilt, ..request(&laws) };
    let told = |tilt| {
        let found = crank_cycle(&engine, &[], &asked(tilt), &|_| true).unwrap();
        assert!(found.is_sound(), "{tilt}");
        found
    };
    let (parallel, tilted) = (told(false), told(true));
    for (found, is_tilted) in [(&parallel, false), (&tilted, true)] {
        // 1000 kN/mm behind the usual 2000.
        let bushing = &run(found, CycleLaw::Bushing, CrankKind::Flexible).bearings;
        assert!(bushing[0].law.contains("6.667e8 N/m"), "{}", bushing[0].law);
        assert!(bushing[2].law.contains("2.000e9 N/m"), "{}", bushing[2].law);
        for own in &run(found, CycleLaw::Film, CrankKind::Flexible).bearings {
            let film = own.film.unwrap();
            assert_eq!(
                own.law.contains("housing 1.000e9 N/m"),
                own.number <= 2 && own.name().starts_with("main")
            );
            assert_eq!(
                (film.is_tilted, film.thickness == film.at_ends),
                (is_tilted, is_tilted),
                "{}",
                own.name()
            );
        }
        let left_out =
            found.notes.iter().any(|note| note.contains("tilt of journals in the law of the film"));
        assert_eq!(left_out, !is_tilted);
    }
    // A film that feels the tilt sets the journal upright.
    let at_ends = |found: &CrankCycle| {
        run(found, CycleLaw::Film, CrankKind::Flexible).bearings[0].film.unwrap().at_ends
    };
    assert!(at_ends(&tilted) > at_ends(&parallel), "{} {}", at_ends(&tilted), at_ends(&parallel));
}

#[test]
fn tilt_without_films_of_guembel_is_refused() {
    let refused = |text: &str, law: CycleLaw| {
        let engine = lanchester::file::read(text).engine().unwrap();
        let asked = CycleRequest { gas: false, tilt: true, ..request(&[law]) };
        crank_cycle(&engine, &[], &asked, &|_| true).unwrap_err().to_string()
    };
    let said = refused(FILE, CycleLaw::Rigid);
    assert!(said.contains("no bearing that is run has one") && said.contains("hint: tilt belongs"), "{said}");
    let said = refused(&format!("{FILE}{HOUSED}cavitation = \"reynolds\"\n"), CycleLaw::Film);
    assert!(said.contains("Guembel's") && said.contains("cavitation = \"gumbel\""), "{said}");
}
