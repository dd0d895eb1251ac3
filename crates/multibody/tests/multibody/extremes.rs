//! Extremes of a run, the open clutch, a starter that is too weak, and the motion that returns.

use crate::runs::{fired, gas, mean_torque, train};
use lanchester_multibody::*;
use lanchester_results::PeriodicCurve;
use std::f64::consts::{PI, TAU};

/// Largest of a size over samples that are given.
fn largest(samples: &Samples, of: impl Fn(&Samples, usize) -> f64) -> f64 {
    (0..samples.time.len()).map(|k| of(samples, k)).fold(f64::NEG_INFINITY, f64::max)
}

fn size(force: [f64; 3]) -> f64 {
    force.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[test]
fn extremes_do_not_depend_on_the_samples() {
    // A load step on mounts: the largest values stand in the middle of the run, and are not those of the last period.
    let train = train(&fired(4));
    let gas = gas(1.8);
    let torque = mean_torque(&train, &gas);
    let run_of = |step: f64, looks: usize| {
        let mut simulation = Simulation { step, looks, reactions: true, ..Simulation::free(150.0, 40.0) };
        simulation.block = BlockMotion::Mounts;
        simulation.gravity = STANDARD_GRAVITY;
        simulation.load.law = LoadLaw::Viscous { torque, at: 150.0 };
        let action = Action::Load(LoadLaw::Constant(4.0 * torque));
        simulation.events = vec![
            Event { when: When::Angle(4.0 * TAU), action },
            Event {
                when: When::Angle(5.0 * TAU),
                action: Action::Load(LoadLaw::Viscous { torque, at: 150.0 }),
            },
        ];
        train.run(&simulation, Some(&gas)).expect("it runs")
    };
    let degree = PI / 180.0;
    let (fine, coarse) = (run_of(0.1 * degree, 1), run_of(11.3 * degree, 11));
    assert!(coarse.samples.time.len() < 1400);
    let largest_mount = |run: &Run, mount: usize| largest(&run.samples, |s, k| size(s.mounts[k][mount]));
    for mount in 0..4 {
        let exact = largest_mount(&fine, mount);
        let [own, other] = [&coarse, &fine].map(|run| run.extremes.mounts[mount]);
        // Samples a tenth of a degree apart, and parabolas over a degree, which leave what departs from them there.
        assert!((own.value / exact - 1.0).abs() < 1e-6, "{mount}: {own:?} {exact}");
        assert!((own.time - other.time).abs() < 1e-4, "{own:?} {other:?}");
    }
    // That of the whole run is none of the last period.
    let last = fine.last_period_extremes.as_ref().expect("whole periods");
    assert!(
        fine.extremes.mounts.iter().zip(&last.mounts).any(|(whole, last)| whole.value > 1.05 * last.value)
    );
    // Joints: pressures jump at dead centres, which no place of the coarse run but the ends of its steps meets.
    for (index, own) in coarse.extremes.cylinders.iter().enumerate() {
        let of =
            |run: &Run| largest(&run.samples, |s, k| size(s.reactions[k].cylinders[index].piston_pin.force));
        let (sampled, other) = (of(&fine), fine.extremes.cylinders[index].piston_pin);
        assert!(own.piston_pin.value >= sampled * (1.0 - 1e-9), "{} {sampled}", own.piston_pin.value);
        assert!((own.piston_pin.value / other.value - 1.0).abs() < 1e-6, "{own:?} {other:?}");
    }
    // The speed: highest and lowest of the whole run, and the mains by every rule.
    let speed = largest(&fine.samples, |s, k| s.speed[k]);
    assert!((coarse.extremes.speed.most.value / speed - 1.0).abs() < 1e-7);
    for rule in 0..3 {
        let [own, other] = [&coarse, &fine].map(|run| run.extremes.rotors[0].mains[rule][1].value);
        assert!((own / other - 1.0).abs() < 1e-6, "{own} {other}");
    }
}

#[test]
fn a_slider_crank_has_the_largest_force_of_its_formula() {
    // Imposed speed, no gas: the piston pin carries m r w^2 (1 + r/l) at the top dead centre, to the mass of the piston alone.
    let engine = fired(1);
    let train = train(&engine);
    let simulation = Simulation { reactions: true, step: 0.11, ..Simulation::imposed(200.0, 4.0) };
    let run = train.run(&simulation, None).expect("it runs");
    let cylinder = &train.cylinders[0];
    let (r, l) = (cylinder.crankpin.norm(), cylinder.rod.length);
    let exact = cylinder.piston_mass * r * 200.0f64.powi(2) * (1.0 + r / l);
    let pin = run.extremes.cylinders[0].piston_pin;
    // Parabolas through samples of 6.3 deg: four digits, where the samples alone have less.
    assert!((pin.value / exact - 1.0).abs() < 2e-4, "{pin:?} {exact}");
    let turned = (pin.theta / TAU).round() * TAU;
    assert!((pin.theta - turned).abs() < 1e-3, "at a top dead centre: {pin:?}");
}

#[test]
fn an_open_clutch_lets_the_twist_of_its_spring_go() {
    let train = train(&fired(1));
    let link = |inertia, ratio| DrivelineInertia { inertia, stiffness: 900.0, damping: 1.0, ratio };
    let mut simulation = Simulation { tolerance: 1e-12, ..Simulation::free(100.0, 1.0) };
    simulation.duration = Duration::Time(0.6);
    simulation.driveline = vec![link(0.4, 1.0), link(0.1, 2.0)];
    simulation.load.law = LoadLaw::Constant(30.0);
    simulation.events = vec![Event { when: When::Time(0.3), action: Action::ClutchOpen }];
    let run = train.run(&simulation, None).expect("it runs");
    let samples = &run.samples;
    let before = samples.time.iter().rposition(|time| *time < 0.3).unwrap();
    let [twist, torque] = samples.driveline_springs[before][0];
    // A sample lies up to a degree before the event: its twist is near that at the event.
    let lost = 0.5 * 900.0 * twist * twist;
    assert!(lost > 0.05 && (run.energy.clutch / -lost - 1.0).abs() < 0.05, "{lost} {}", run.energy.clutch);
    assert!((torque - 900.0 * twist).abs() < 0.2 * torque.abs(), "the damper is the rest: {torque} {twist}");
    // With it the energy is kept to the tolerance of the steps; without it 1e-5 would be missing.
    assert!(run.audit.energy < 1e-11, "{:?}", run.audit);
    assert!(-run.energy.clutch > 1e-6 * run.energy.throughput);
    let after = samples.time.iter().position(|time| *time > 0.3).unwrap();
    assert!(samples.driveline_springs[after..].iter().all(|springs| springs[0] == [0.0; 2]));
    // Behind the clutch the load brings the driveline down by itself.
    let [first, last] = [after, samples.time.len() - 1].map(|k| samples.driveline[k][0][1]);
    assert!(last < first - 5.0, "{first} {last}");
}

#[test]
fn friction_of_the_pistons_has_a_course() {
    let train = train(&fired(2));
    let mut simulation = Simulation::imposed(120.0, 2.0);
    simulation.piston_damping = 40.0;
    let run = train.run(&simulation, None).expect("it runs");
    let samples = &run.samples;
    let work: f64 = (1..samples.theta.len())
        .map(|k| {
            let mean = 0.5 * (samples.piston_friction_torque[k] + samples.piston_friction_torque[k - 1]);
            mean * (samples.theta[k] - samples.theta[k - 1])
        })
        .sum();
    // A periodic course by the trapezium rule: exact but for rounding and the tolerance of the works.
    assert!(work < -1.0 && (work / run.energy.piston_friction - 1.0).abs() < 1e-9, "{work} {:?}", run.energy);
}

#[test]
fn a_weak_starter_says_where_it_stalls_and_what_is_missing() {
    let train = train(&fired(4));
    let starter = Starter {
        stall_torque: 1.5,
        free_speed: 900.0,
        ratio: 10.0,
        until: 70.0,
        reacts_on: ReactsOn::Block,
    };
    let mut simulation = Simulation::free(0.0, 1.0);
    simulation.duration = Duration::Time(30.0);
    simulation.start_angle = 1.5;
    simulation.friction_torque = 6.0;
    simulation.starter = Some(starter);
    let run = train.run(&simulation, Some(&gas(1.0))).expect("it runs");
    let stall = run.stall.expect("it stalls");
    // The farthest angle of the run, at which the torques are those of the formulas.
    let halts = run.events.iter().map(|event| event.theta);
    let farthest = halts.chain(run.samples.theta.iter().copied()).fold(f64::NEG_INFINITY, f64::max);
    assert!((stall.theta - farthest).abs() < 1e-9, "{stall:?} {farthest}");
    assert!((stall.starter - 15.0).abs() < 1e-12 && stall.held_by == 6.0 && stall.ratio == 10.0, "{stall:?}");
    let mut places = Vec::new();
    train.places_into(stall.theta, &mut places);
    let area = 0.25 * PI * 0.08f64.powi(2);
    let forces: Vec<f64> =
        (0..4).map(|c| area * gas(1.0).pressure(c, train.own_angle(c, stall.theta), 0.0)).collect();
    let others = train.piston_torque(&places, 0.0, &forces, 0.0)[0];
    assert!((stall.others - others).abs() < 1e-9 * others.abs(), "{stall:?} {others}");
    assert!((stall.missing - (6.0 - 15.0 - others)).abs() < 1e-9 * others.abs(), "{stall:?}");

    // With what is missing and a little more it does not stall there; one that lets go has no stall.
    let stronger = 1.5 + 1.01 * stall.missing / 10.0;
    simulation.starter = Some(Starter { stall_torque: stronger, ..starter });
    let run = train.run(&simulation, Some(&gas(1.0))).expect("it runs");
    assert!(run.stall.is_none_or(|next| next.theta > stall.theta + 0.01), "{:?}", run.stall);
    simulation.starter = Some(Starter { stall_torque: 12.0, ..starter });
    (simulation.duration, simulation.start_angle) = (Duration::Time(1.5), 0.4);
    let fired = train.run(&simulation, Some(&gas(1.8))).expect("it runs");
    assert!(fired.events.iter().any(|event| event.what == Occasion::StarterOff) && fired.stall.is_none());
}

/// Pressures through points: no kink of which it tells, but a bend at every point.
struct Points(PeriodicCurve);

impl Points {
    fn new() -> Points {
        let sealed = gas(1.8);
        let period = 2.0 * TAU;
        let knots: Vec<f64> = (0..240).map(|k| period * f64::from(k) / 240.0).collect();
        let values: Vec<f64> = knots.iter().map(|own| sealed.pressure(0, *own, 0.0)).collect();
        Points(PeriodicCurve::through(period, knots, &values).expect("it is a curve"))
    }
}

impl GasPressure for Points {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        self.0.at(own)
    }

    fn bends(&self, _: usize) -> Vec<f64> {
        self.0.pieces().map(|piece| piece.0).collect()
    }
}

#[test]
fn a_motion_closes_where_pressures_bend_at_every_point() {
    let train = train(&fired(4));
    let gas = Points::new();
    let torque = mean_torque(&train, &gas);
    let mut simulation = Simulation::free(150.0, 1.0);
    simulation.block = BlockMotion::Mounts;
    simulation.load.law = LoadLaw::Viscous { torque, at: 150.0 };
    let found = train.periodic(&simulation, Some(&gas)).expect("it runs");
    assert_eq!(found.outcome, PeriodicOutcome::Stable, "{:e} {:?}", found.residual, found.followed);
    // The bound that is sought, though steps across the bends leave the map with more noise than that.
    assert!(found.residual < 1e-10, "{:e}", found.residual);
    let last = found.run.samples.speed.len() - 1;
    assert!((found.run.samples.speed[last] / found.run.samples.speed[0] - 1.0).abs() < 1e-10);
}

#[test]
fn a_start_comes_to_the_motion_that_returns() {
    let train = train(&fired(4));
    let gas = gas(1.8);
    let torque = mean_torque(&train, &gas);
    let mut simulation = Simulation::free(0.0, 1.0);
    simulation.load.law = LoadLaw::Viscous { torque, at: 150.0 };
    simulation.starter = Some(Starter {
        stall_torque: 12.0,
        free_speed: 900.0,
        ratio: 10.0,
        until: 70.0,
        reacts_on: ReactsOn::Block,
    });
    let from_rest = train.periodic(&simulation, Some(&gas)).expect("it runs");
    let from_speed = train.periodic(&Simulation { start_speed: 150.0, ..simulation.clone() }, Some(&gas));
    let from_speed = from_speed.expect("it runs");
    assert_eq!(
        from_rest.outcome,
        PeriodicOutcome::Stable,
        "{:?} {:e} {:?} {:?}",
        from_rest.followed,
        from_rest.residual,
        from_rest.run.outcome,
        from_rest.run.end
    );
    assert!(from_rest.followed.is_some_and(|followed| followed.periods > 0 && !followed.came_to_rest));
    // The same motion, without the starter.
    let [a, b] = [&from_rest, &from_speed].map(|found| found.run.samples.speed[0]);
    assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    assert!(from_rest.run.samples.starter_torque.iter().all(|torque| *torque == 0.0));

    // Too weak: it comes to rest, and the run shows that.
    simulation.starter = simulation.starter.map(|starter| Starter { stall_torque: 1.5, ..starter });
    simulation.friction_torque = 6.0;
    simulation.start_angle = 1.5;
    let weak = train.periodic(&simulation, Some(&crate::runs::gas(1.0))).expect("it runs");
    assert_eq!(weak.outcome, PeriodicOutcome::NotFound);
    assert!(weak.followed.is_some_and(|followed| followed.came_to_rest));
    assert!(matches!(weak.run.outcome, RunOutcome::AtRest { .. }) && weak.run.stall.is_some());
}
