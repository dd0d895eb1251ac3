//! Films and safeties of an engine as criteria.

use lanchester::balance::{Answer, BalanceSettings, Durable, DurableEnd, Next, fitted};
use lanchester::file::EngineFile;
use lanchester::film::BearingKind;
use lanchester::mechanism::BearingRequest;
use lanchester::model::Engine;
use lanchester::report::CrankRule;
use lanchester::task::{
    AtLeast, CrankWeightPlaces, DurabilityCriterion, DurabilityMeter, DurabilityWish, Measured,
    crank_weights, default_task,
};
use lanchester::{
    DurabilityRequest, DurableOptions, EngineDurability, FilmMethod, RuleRequest, bearing_films,
    bearing_report, crank_rule, crank_rule_with_torsion, durable_balance, optimise_on_webs,
};

const FOUR: &str = include_str!("../../../../examples/in-line-4-crank-by-elements.toml");
const SIX: &str = include_str!("../../../../examples/in-line-6-torsion.toml");
/// Half the top speed, so that a test run without optimisation is short too.
const SPEED: f64 = 340.0;

fn engine(text: &str) -> Engine {
    lanchester::file::read(text).engine().expect("it has no mistakes")
}

fn at(speed: f64) -> DurabilityRequest {
    DurabilityRequest { speeds: vec![speed], ..DurabilityRequest::default() }
}

fn value(engine: &Engine, request: DurabilityRequest, criterion: DurabilityCriterion) -> f64 {
    let found = EngineDurability::new(Ok(&[]), request).measure(engine, &[criterion]);
    found[0].value().unwrap_or_else(|| panic!("{criterion:?}: {found:?}"))
}

#[test]
fn films_and_safeties_are_those_of_their_own_commands() {
    let engine = engine(FOUR);
    let loads =
        bearing_report(&engine, &[], &BearingRequest { speed: Some(SPEED), ..BearingRequest::default() })
            .unwrap();
    let films = bearing_films(&engine, &loads, &[], FilmMethod::Tables).unwrap();
    let mut smallest = [f64::INFINITY; 2];
    for film in &films.films {
        let own = usize::from(film.kind == BearingKind::Crankpin);
        smallest[own] = smallest[own].min(film.orbit.least_film);
        if film.kind == BearingKind::Main {
            let one = value(&engine, at(SPEED), DurabilityCriterion::MainFilm(Some(film.number - 1)));
            assert_eq!(one, film.orbit.least_film, "main {}", film.number);
        }
    }
    assert_eq!(value(&engine, at(SPEED), DurabilityCriterion::MainFilm(None)), smallest[0]);
    assert_eq!(value(&engine, at(SPEED), DurabilityCriterion::CrankpinFilm(None)), smallest[1]);
    assert_eq!(value(&engine, at(SPEED), DurabilityCriterion::LeastFilm), smallest[0].min(smallest[1]));
    let sheet =
        crank_rule(&engine, &[], &RuleRequest { speeds: vec![SPEED], ..RuleRequest::default() }).unwrap();
    let safeties = sheet.speeds[0].throws.iter().flat_map(|throw| throw.safeties()).map(|one| one.1);
    assert_eq!(
        value(&engine, at(SPEED), DurabilityCriterion::RuleSafety(None)),
        safeties.fold(f64::INFINITY, f64::min)
    );
}

/// With what the crankshaft drives the safety is the smallest of the sheet that the file's own command gives, resonances between the speeds included; without it, or
/// without a chain, it says that torsional vibration is left out.
#[test]
fn torsional_vibration_counts_where_the_engine_has_a_chain() {
    let file = lanchester::file::read(SIX).file.expect("no mistakes");
    let driveline = file.tasks.simulation.as_ref().unwrap().driveline.clone();
    assert!(!driveline.is_empty());
    let measured = |engine: &Engine, driveline| {
        let request = DurabilityRequest { driveline, ..DurabilityRequest::default() };
        EngineDurability::new(Ok(&[]), request)
            .measure(engine, &[DurabilityCriterion::RuleSafety(None)])
            .remove(0)
    };
    let smallest = |sheet: &CrankRule| {
        let safeties = sheet.speeds.iter().flat_map(|speed| &speed.throws).flat_map(|throw| throw.safeties());
        safeties.map(|one| one.1).fold(f64::INFINITY, f64::min)
    };
    let left_out = |measured: &Measured| match measured {
        Measured::Known { left_out, .. } => left_out.clone(),
        Measured::Unknown(why) => panic!("{why:?}"),
    };
    // A ring without its oil: the sixth order is in resonance below the highest speed.
    let weak = file.engine.with(|parts| {
        let damper = parts.torsion.as_mut().unwrap().damper.as_mut().unwrap();
        damper.damping *= 0.02;
    });
    for engine in [file.engine.clone(), weak.unwrap()] {
        let file = EngineFile { engine, ..file.clone() };
        let with = crank_rule_with_torsion(&file, &[], &RuleRequest::default()).unwrap();
        let found = measured(&file.engine, Some(driveline.clone()));
        assert_eq!(found.value(), Some(smallest(&with)));
        assert_eq!(left_out(&found), "");
        let without = measured(&file.engine, None);
        assert_eq!(
            without.value(),
            Some(smallest(&crank_rule(&file.engine, &[], &RuleRequest::default()).unwrap()))
        );
        assert_eq!(left_out(&without), "torsional vibration");
        assert!(found.value() < without.value());
    }
    let chainless = file.engine.with(|parts| parts.flywheel = None).unwrap();
    let reason = left_out(&measured(&chainless, Some(Vec::new())));
    assert!(reason.starts_with("torsional vibration: ") && reason.contains("[flywheel]"), "{reason}");
}

/// An engine half as large again at the same piston speed has the same stresses, of torsional vibration too, so that its safety changes by the rule's strength alone, as it
/// does without vibration.
#[test]
fn similar_engines_vibrate_alike() {
    let file = lanchester::file::read(SIX).file.expect("no mistakes");
    let safety = |length: f64, driveline: Option<Vec<_>>| {
        let request = DurabilityRequest { length, driveline, ..at(270.0) };
        value(&file.engine, request, DurabilityCriterion::RuleSafety(Some(0)))
    };
    let driveline = || Some(file.tasks.simulation.as_ref().unwrap().driveline.clone());
    let (with, without) =
        (safety(1.5, driveline()) / safety(1.0, driveline()), safety(1.5, None) / safety(1.0, None));
    assert!(with < 1.0 && (with / without - 1.0).abs() < 0.01, "{with} {without}");
}

#[test]
fn counterweights_move_films_of_mains_alone() {
    let own = engine(FOUR);
    let webs = crank_weights(&own, CrankWeightPlaces::Webs);
    assert_eq!(webs.len(), 8);
    let task = lanchester::task::BalanceTask { weights: webs, ..default_task(&own) };
    let answer =
        optimise_on_webs(&own, Ok(&[]), &task, None, &BalanceSettings::default(), &|_| Next::Continue)
            .unwrap();
    let weighed = fitted(&own, &answer);
    let of = |engine: &Engine, criterion| value(engine, at(SPEED), criterion);
    for criterion in [DurabilityCriterion::CrankpinFilm(None), DurabilityCriterion::RuleSafety(None)] {
        assert!((of(&weighed, criterion) / of(&own, criterion) - 1.0).abs() < 1e-9, "{criterion:?}");
        assert!(!criterion.depends_on_unbalances());
    }
    let main = DurabilityCriterion::MainFilm(Some(2));
    assert!(of(&weighed, main) > 1.2 * of(&own, main), "{} {}", of(&own, main), of(&weighed, main));
}

/// Forces grow with the square of the lengths at equal piston speed, what a film carries with viscosity times length: with a viscosity that grows as
/// well, the film is the same share of its clearance. Stresses are equal; the rule's strength falls with the diameter.
#[test]
fn similar_engines_have_similar_films_and_a_weaker_crank() {
    let small = engine(FOUR);
    let thicker = |factor: f64| {
        small
            .with(|parts| {
                let design = parts.bearing_design.as_mut().unwrap();
                design.oil.viscosity = design.oil.viscosity.map(|own| own * factor);
            })
            .unwrap()
    };
    let length = 1.5;
    let large = |speed_of_original: f64| DurabilityRequest { length, speed_of_original, ..at(SPEED) };
    for criterion in [DurabilityCriterion::MainFilm(None), DurabilityCriterion::CrankpinFilm(None)] {
        let (own, other) =
            (value(&small, at(SPEED), criterion), value(&thicker(length), large(1.0), criterion));
        // Orbits are integrated to 1e-5 of the clearance, and repeat to a thousandth.
        assert!((other / (length * own) - 1.0).abs() < 5e-3, "{criterion:?}: {own} {other}");
    }
    let rule = DurabilityCriterion::RuleSafety(None);
    let (own, other) = (value(&small, at(SPEED), rule), value(&small, large(1.0), rule));
    assert!(other < own && other > 0.85 * own, "{own} {other}");
}

#[test]
fn what_the_file_does_not_give_is_named_and_never_a_number() {
    let without = |from: &str, to: &str| {
        assert!(FOUR.contains(from), "{from}");
        engine(&FOUR.replace(from, to))
    };
    let asked = [
        DurabilityCriterion::MainFilm(None),
        DurabilityCriterion::CrankpinFilm(None),
        DurabilityCriterion::RuleSafety(None),
    ];
    let found = |engine: &Engine| EngineDurability::new(Ok(&[]), at(SPEED)).measure(engine, &asked);
    let key = |measured: &Measured| match measured {
        Measured::Unknown(why) => format!("{} {}", why.reason, why.remedy),
        Measured::Known { value, .. } => format!("{value}"),
    };
    let oil = found(&without("viscosity = \"10 mPa s\"\n", ""));
    assert!(key(&oil[0]).contains("[bearings.film]") && key(&oil[1]).contains("[bearings.film]"), "{oil:?}");
    let clearance = found(&without("diametral_clearance = \"0.05 mm\"\n", ""));
    assert!(
        clearance[0].value().is_some()
            && key(&clearance[1]).contains("diametral_clearance in [bearings.crankpin]")
    );
    let material = found(&without("preset = \"42CrMo4 quenched and tempered\"\n", ""));
    assert!(material[0].value().is_some() && key(&material[2]).contains("tensile_strength"), "{material:?}");
    let gallery = engine(lanchester::file::template("in-line-6").unwrap().text);
    for measured in found(&gallery) {
        assert_eq!(measured.value(), None);
    }
    let fillets =
        EngineDurability::new(Ok(&[]), at(SPEED)).measure(&gallery, &[DurabilityCriterion::FilletSafety]);
    assert!(key(&fillets[0]).contains("finite elements"));
}

fn balanced(file: &EngineFile, wish: DurabilityWish) -> (Answer, Durable) {
    let mut task = lanchester::task::BalanceTask {
        weights: crank_weights(&file.engine, CrankWeightPlaces::Webs),
        durability: wish,
        ..default_task(&file.engine)
    };
    task.speeds = vec![file.engine.speed.highest];
    let answer = optimise_on_webs(&file.engine, Ok(&[]), &task, None, &BalanceSettings::default(), &|_| {
        Next::Continue
    })
    .unwrap();
    let options = DurableOptions {
        search: lanchester::balance::DurableSettings { most_evaluations: 400 },
        ..DurableOptions::default()
    };
    let found = durable_balance(file, Ok(&[]), &answer, &options, &|_| Next::Continue).unwrap();
    (answer, found)
}

/// With true films: a limit above what the optimum has is reached by weights whose films, computed anew, hold it; force and couple stay.
#[test]
fn a_search_with_true_films_holds_what_it_says() {
    let mut file = lanchester::file::read(FOUR).file.expect("no mistakes");
    file.engine = file.engine.with(|parts| parts.speed.highest = SPEED).unwrap();
    let criterion = DurabilityCriterion::MainFilm(None);
    let (_, plain) = balanced(&file, DurabilityWish::default());
    assert_eq!((plain.end.clone(), plain.evaluations), (DurableEnd::NotAsked, 0));
    let smallest = |found: &Durable| {
        let mains =
            found.rows.iter().filter(|row| matches!(row.criterion, DurabilityCriterion::MainFilm(Some(_))));
        mains.filter_map(|row| row.after.value()).fold(f64::INFINITY, f64::min)
    };
    let least = 1.01 * smallest(&plain);
    let (answer, found) = balanced(
        &file,
        DurabilityWish { maximise: Vec::new(), at_least: vec![AtLeast { criterion, least }] },
    );
    assert!(found.is_moved() && found.is_met(), "{:?} {:?}", found.end, found.limits);
    let after = found.engine(&file.engine, &answer);
    assert!(value(&after, at(SPEED), criterion) >= least * (1.0 - 1e-9));
    for stage in &found.stages {
        assert!(stage.value <= stage.allowed * (1.0 + 1e-6) + 1e-3, "{stage:?}");
    }
}
