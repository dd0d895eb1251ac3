//! Counterweights as parts of a whole engine: one mass everywhere, shapes within the clearance envelope, and optima that can be built.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester::balance::fitted;
use lanchester::balance::{BalanceSettings, Next};
use lanchester::geometry::clearance::Obstacle;
use lanchester::geometry::{Design, DesignOutcome, Objective};
use lanchester::model::{BalanceTask, Engine, Phase, default_task};
use lanchester::{
    CounterweightDesigns, CounterweightRequest, FitLimit, check_counterweights, counterweight_front,
    crankshaft_parts, design_counterweights, optimise_what_fits, with_counterweights,
};

fn three() -> Engine {
    let text = include_str!("../../../examples/in-line-3-counterweights.toml");
    lanchester::model::read(text).engine.expect("the example has no mistakes")
}

fn request(engine: &Engine) -> CounterweightRequest {
    let task = engine.shape_task.unwrap();
    CounterweightRequest { weights: Vec::new(), unbalance: None, task, evolution: None }
}

/// The engine with its best shapes.
fn built(engine: &Engine, designs: &CounterweightDesigns) -> Engine {
    let design = |weight: &lanchester::DesignedCounterweight| match &weight.outcome {
        DesignOutcome::Found(best) => (weight.index, best.design),
        DesignOutcome::Infeasible(why) => panic!("{}: {why:?}", weight.name),
    };
    let found: Vec<(usize, Design)> = designs.weights.iter().map(design).collect();
    with_counterweights(engine, &found, designs.task.density).unwrap()
}

#[test]
fn a_counterweight_has_one_mass() {
    let engine = three();
    let designs = design_counterweights(&engine, &request(&engine)).unwrap();
    let DesignOutcome::Found(best) = &designs.weights[0].outcome else { panic!("it can be met") };
    let masses = designs.weights[0].on_web.unwrap();
    // The flank of the web, 30 deg off, holds a little of the shape.
    assert!(masses.within_web > 1e-3 && masses.within_web < 5e-3, "{masses:?}");
    assert!((best.design.mass - masses.mass - masses.within_web).abs() < 1e-12);
    let radius = best.design.shape.web_radius;
    let disc = 7850.0 * best.design.thickness * std::f64::consts::PI * radius * radius;
    assert!((masses.whole_part - disc - best.design.mass).abs() < 1e-9);

    let fitted = built(&engine, &designs);
    let checked = check_counterweights(&fitted).unwrap();
    let weight = &checked.counterweights[0];
    assert!((weight.mass - masses.mass).abs() < 1e-9 && (weight.whole_part - masses.whole_part).abs() < 1e-9);
    assert!((weight.polar_inertia - masses.polar_inertia).abs() < 1e-12);
    let sections = &checked.crankshafts[0].sections;
    let section = sections.iter().find(|section| section.name == weight.name && section.throw == Some(0));
    let section = sections
        .iter()
        .find(|section| section.kind == lanchester::geometry::crankshaft::SectionKind::Counterweight)
        .or(section)
        .unwrap();
    assert!((section.mass - masses.mass).abs() < 1e-9, "{} {}", section.mass, masses.mass);
    let part = &crankshaft_parts(&fitted, 0, &["web 1".to_owned()]).unwrap()[0];
    assert!((part.part.mass_properties().mass - masses.whole_part).abs() < 1e-12);

    let front = counterweight_front(&engine, &request(&engine), Objective::Inertia, 4).unwrap();
    assert!(front.front.proved, "{front:?}");
    // Each end is proved to a millionth.
    assert!((front.on_web[0].mass / masses.mass - 1.0).abs() < 2e-6, "{:?} {masses:?}", front.on_web[0]);
}

#[test]
fn the_best_shape_lies_on_the_clearance_envelope() {
    let engine = three();
    let designs = design_counterweights(&engine, &request(&engine)).unwrap();
    let weight = &designs.weights[0];
    let DesignOutcome::Found(best) = &weight.outcome else { panic!("it can be met") };
    let masses = weight.on_web.unwrap();
    assert!(best.proved && weight.room_is_exact == Some(true));
    let room = weight.room.as_ref().unwrap();
    assert_eq!(room.limit, Obstacle::Piston { cylinder: 1 });
    assert!((room.radius - 0.0925).abs() < 1e-7, "{room:?}");
    // A circle of that radius, which keeps any shape clear, leaves 1.6053 kg; without clearance there are 1.29 kg.
    let mut circle = request(&engine);
    circle.task.limits.swept_radius = Some(room.radius);
    let within = design_counterweights(&engine, &circle).unwrap().weights[0].on_web.unwrap().mass;
    assert!((within - 1.6053).abs() < 1e-4, "{within}");
    println!(
        "{} within the envelope, {within} within the circle, {:?} without",
        masses.mass, weight.without_room
    );
    assert!(masses.mass < within * 0.9995 && masses.mass > weight.without_room.unwrap());

    // The clearance that is proved of the part is the wanted one, and reached.
    let checked = check_counterweights(&built(&engine, &designs)).unwrap();
    let clearances = checked.clearances.unwrap();
    assert!(checked.is_kept && clearances.is_kept);
    for body in clearances.bodies.iter().filter(|body| body.name != "web 3" && body.name != "web 4") {
        let own = body.clearances.iter();
        let own = own.filter(|one| !matches!(one.obstacle, Obstacle::BigEndSide { .. }));
        let least = own.map(|one| one.distance).fold(f64::INFINITY, f64::min);
        assert!((least - 1.5e-3).abs() < 1e-6, "{}: {least}", body.name);
    }
}

#[test]
fn the_optimum_of_what_fits_can_be_built() {
    let engine = three();
    let mut asked: BalanceTask = default_task(&engine);
    for weight in &mut asked.weights {
        weight.fits = true;
    }
    let by_default =
        optimise_what_fits(&engine, &default_task(&engine), &BalanceSettings::default(), &|_| Next::Continue)
            .unwrap();
    let bounded =
        optimise_what_fits(&engine, &asked, &BalanceSettings::default(), &|_| Next::Continue).unwrap();
    assert_eq!(bounded.bounds.len(), 4);
    assert!(by_default.bounds.iter().all(|bound| bound.is_default));
    for (one, other) in bounded.bounds.iter().zip(&by_default.bounds) {
        assert!(!one.is_default && one.most == other.most && one.proved.unwrap() >= one.most, "{one:?}");
        assert!(one.limits.contains(&FitLimit::Thickness), "{one:?}");
    }
    for (bound, found) in bounded.bounds.iter().zip(&bounded.answer.weights) {
        println!("{bound:?} {found:?}");
        assert!(found.unbalance.norm() <= bound.most * (1.0 + 1e-6), "{bound:?} {found:?}");
    }
    let balanced = fitted(&engine, &bounded.answer);
    let designs = design_counterweights(&balanced, &request(&balanced)).unwrap();
    let checked = check_counterweights(&built(&balanced, &designs)).unwrap();
    assert!(checked.is_kept && checked.counterweights.iter().all(|weight| weight.is_met), "{checked:?}");
    // In its direction a web holds that much, and not a thousandth more.
    let bound = &bounded.bounds[0];
    let mut single = balanced.clone();
    let place = single.counterweights.iter().position(|weight| weight.name == bound.name).unwrap();
    single.counterweights[place].angle = bound.direction;
    for (factor, fits) in [(1.0, true), (1.001, false)] {
        let weights = vec![bound.name.clone()];
        let unbalance = Some(bound.most * factor);
        let request = CounterweightRequest { weights, unbalance, ..request(&single) };
        let designs = design_counterweights(&single, &request).unwrap();
        let found = matches!(designs.weights[0].outcome, DesignOutcome::Found(_));
        assert_eq!(found, fits, "{factor} of {bound:?}");
    }
}

#[test]
fn mirrored_weights_share_the_bound_that_fits_both() {
    let engine = three();
    let mut task = default_task(&engine);
    task.ties = vec![lanchester::model::Tie { first: 0, second: 2, factor: 1.0, mirrored: true }];
    task.weights[0].fits = true;
    task.weights[2].phase = Phase::Free;
    let bounded =
        optimise_what_fits(&engine, &task, &BalanceSettings::default(), &|_| Next::Continue).unwrap();
    let found = &bounded.answer.weights;
    assert!((found[2].unbalance - found[0].unbalance.conj()).norm() < 1e-7);
    for bound in &bounded.bounds {
        let found = found.iter().find(|weight| weight.name == bound.name).unwrap();
        assert!(found.unbalance.norm() <= bound.most * (1.0 + 1e-6), "{bound:?}");
    }
}

#[test]
fn what_fits_needs_shapes() {
    let mut engine = three();
    let mut task = default_task(&engine);
    task.weights[1].fits = true;
    engine.shape_task = None;
    let error = optimise_what_fits(&engine, &task, &BalanceSettings::default(), &|_| Next::Continue)
        .unwrap_err()
        .to_string();
    assert!(error.contains("\"web 2\"") && error.contains("[counterweight_design]"), "{error}");
    // Without shapes nothing is bounded by default.
    task.weights[1].fits = false;
    assert!(
        optimise_what_fits(&engine, &task, &BalanceSettings::default(), &|_| Next::Continue)
            .unwrap()
            .bounds
            .is_empty()
    );
}
