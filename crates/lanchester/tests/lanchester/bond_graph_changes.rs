//! Governor, misfires, fuel, load, clutch and stop of a run: the bond graph against the multibody simulation, with the same pressures.

use crate::bond_graph_engine::{BLOCK, Given, difference, mounts, pressure, single};
use lanchester::bondgraph::{
    EngineBlock, EngineLink, EngineLoad, EngineRequest, Graph, Simulation as GraphRun, SimulationRequest,
    engine_graph, equations,
};
use lanchester::file::{read, template};
use lanchester::model::{Action, DrivelineInertia, Engine, Event, Governor, When};
use lanchester::multibody::{
    BlockMotion, BlockStart, Load, LoadLaw, Occasion, ReactsOn, RotorInertia, Run, RunOutcome, Simulation,
    Train,
};
use std::f64::consts::TAU;

/// How far the two may differ, as a share of the largest value.
const AGREEMENT: f64 = 1e-8;

const STEPS: f64 = 1e-12;

struct Case {
    engine: Engine,
    governor: Option<Governor>,
    events: Vec<Event>,
    driveline: Vec<DrivelineInertia>,
    moves: bool,
    load: LoadLaw,
    /// Dry friction of the crank train [N m].
    friction: f64,
    revolutions: f64,
}

/// A quantity of the graph, and the same of a sample of the simulation.
type Compared = (&'static str, fn(&Run, usize) -> f64);

impl Case {
    fn multibody(&self) -> Run {
        let crankshafts = self.engine.crankshafts.iter().map(|_| Some(0.09)).collect();
        let inertia = RotorInertia { crankshafts, flywheel: 0.0, shafts: Vec::new() };
        let train = Train::new(&self.engine, &inertia).expect("it turns");
        let simulation = Simulation {
            block: if self.moves { BlockMotion::Mounts } else { BlockMotion::Fixed },
            block_start: BlockStart::AsDrawn,
            gravity: 9.80665,
            step: TAU / 12.0,
            tolerance: STEPS,
            load: Load { law: self.load.clone(), reacts_on: ReactsOn::Ground },
            friction_torque: self.friction,
            governor: self.governor,
            events: self.events.clone(),
            driveline: self.driveline.clone(),
            ..Simulation::free(150.0, self.revolutions)
        };
        train.run(&simulation, Some(&Given(pressure()))).expect("it runs")
    }

    fn graph(&self, duration: f64, places: &[f64]) -> GraphRun {
        let link = |link: &DrivelineInertia| EngineLink {
            inertia: link.inertia,
            stiffness: link.stiffness,
            damping: link.damping,
            ratio: link.ratio,
        };
        let request = EngineRequest {
            block: if self.moves { EngineBlock::Space } else { EngineBlock::Fixed },
            mounts: self.moves,
            gravity: 9.80665,
            crankshaft_inertia: vec![0.09; self.engine.crankshafts.len()],
            pressures: vec![pressure(); self.engine.cylinders.len()],
            load: EngineLoad { torque: self.load.clone(), reacts_on_block: false },
            friction_torque: self.friction,
            governor: self.governor,
            events: self.events.clone(),
            driveline: self.driveline.iter().map(link).collect(),
            ..EngineRequest::free(150.0, self.revolutions)
        };
        let description = engine_graph(&self.engine, &request).expect("it has what it needs");
        let graph = Graph::new(&description).unwrap_or_else(|e| panic!("{e:#?}"));
        let found = equations(&graph).unwrap_or_else(|e| panic!("{e:#?}"));
        found.simulate_at(&SimulationRequest { duration, tolerance: STEPS, ..found.request() }, places)
    }

    /// Compares the named quantities; gives both runs.
    fn check(&self, names: &[Compared]) -> (Run, GraphRun) {
        let theirs = self.multibody();
        let time = &theirs.samples.time;
        let ours = self.graph(1.01 * theirs.end[0], &time[1..]);
        for (name, of) in names {
            let own = ours.values(name).unwrap_or_else(|| panic!("no {name}"));
            let count = own.len();
            assert!(count + 1 >= time.len(), "{name}: {count} samples of {}", time.len());
            let other = (0..count).map(|k| of(&theirs, k)).collect();
            let off = difference(&[[own.to_vec(), other]]);
            assert!(off < AGREEMENT, "{name} differs by {off:.3e}");
        }
        (theirs, ours)
    }
}

const SPEED: (&str, fn(&Run, usize) -> f64) = ("crank.flow", |run, k| run.samples.speed[k]);
const ANGLE: (&str, fn(&Run, usize) -> f64) = ("theta", |run, k| run.samples.theta[k]);

/// Fuel cut back, a load that changes once as the speed falls, a stop at a time.
#[test]
fn xcheck_fuel_load_and_stop() {
    let case = Case {
        engine: single(""),
        governor: None,
        events: vec![
            Event { when: When::Angle(3.0 * TAU), action: Action::Fuel(0.4) },
            Event { when: When::SpeedFalls(146.0), action: Action::Load(LoadLaw::Constant(3.0)) },
            Event { when: When::Time(0.62), action: Action::Load(LoadLaw::None) },
            Event { when: When::Time(0.62), action: Action::Fuel(0.9) },
            Event { when: When::Time(0.9), action: Action::Stop },
        ],
        driveline: Vec::new(),
        moves: false,
        load: LoadLaw::Quadratic { torque: 25.0, at: 150.0 },
        friction: 0.0,
        revolutions: 100.0,
    };
    let (theirs, ours) = case.check(&[ANGLE, SPEED]);
    assert_eq!(theirs.outcome, RunOutcome::Stopped);
    assert!(ours.complete && ours.ended.starts_with("stopped by an event"), "{}", ours.ended);
    // All five came, the load that waits for a speed among them.
    let came = |index| theirs.events.iter().any(|happened| happened.what == Occasion::Event { index });
    assert!((0..5).all(came), "{:?}", theirs.events);
    let load = ours.values("load.effort").expect("its load");
    let last = load[load.len() - 1];
    assert!(load[0] > 24.0 && last.abs() < 1e-12, "{} then {last}", load[0]);
}

/// A governor through a load step, its integral waiting at the end of the actuator on the way.
#[test]
fn xcheck_governor() {
    through_a_load_step(0.03);
}

/// The same with an actuator that follows at once.
#[test]
fn xcheck_governor_without_lag() {
    through_a_load_step(0.0);
}

fn through_a_load_step(lag: f64) {
    let case = Case {
        engine: single(""),
        governor: Some(Governor {
            speed: 155.0,
            gain: 0.15,
            integral: 1.5,
            droop: 0.04,
            delay: 0.0,
            lag,
            start: 0.3,
        }),
        events: vec![Event { when: When::Time(0.8), action: Action::Load(LoadLaw::Constant(2.0)) }],
        driveline: Vec::new(),
        moves: false,
        load: LoadLaw::Constant(30.0),
        friction: 0.0,
        revolutions: 60.0,
    };
    let (_, ours) = case.check(&[ANGLE, SPEED]);
    let factor = ours.values("governor").expect("its factor");
    let wanted = ours.values("governor_wanted").expect("what it wants");
    assert!(factor.iter().all(|factor| (-1e-12..=1.0 + 1e-12).contains(factor)));
    let range = |values: &[f64]| {
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)))
    };
    let (low, high) = range(wanted);
    assert!(low < 0.0 && high > 1.0, "it is at both ends on the way: {low} to {high}");
}

/// A misfire shakes the block in space; then the clutch opens, and what was driven turns on.
#[test]
fn xcheck_misfire_and_clutch() {
    let text = template("v2-90").expect("it is in the gallery").text;
    let donor = single(&(BLOCK.to_owned() + &mounts()));
    let engine = read(text).engine().expect("the gallery has no mistakes").with(|engine| {
        for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
            cylinder.bore = Some(0.07);
            cylinder.firing_angle.get_or_insert(TAU * index as f64);
        }
        engine.block.clone_from(&donor.block);
        engine.mounts.clone_from(&donor.mounts);
    });
    let case = Case {
        engine: engine.unwrap_or_else(|faults| panic!("{faults:?}")),
        governor: None,
        events: vec![
            Event { when: When::Angle(2.0 * TAU + 0.3), action: Action::Misfire(1) },
            Event { when: When::Time(0.2), action: Action::ClutchOpen },
        ],
        driveline: vec![
            DrivelineInertia { inertia: 0.4, stiffness: 900.0, damping: 4.0, ratio: 1.0 },
            DrivelineInertia { inertia: 0.1, stiffness: 700.0, damping: 2.0, ratio: 1.5 },
        ],
        moves: true,
        load: LoadLaw::Viscous { torque: 8.0, at: 150.0 },
        friction: 0.0,
        revolutions: 8.0,
    };
    let (theirs, _) = case.check(&[
        ANGLE,
        SPEED,
        ("link1.flow", |run, k| run.samples.driveline[k][0][1]),
        ("link2.flow", |run, k| run.samples.driveline[k][1][1]),
        ("wz.flow", |run, k| run.samples.spin[k][2]),
    ]);
    assert_eq!(theirs.outcome, RunOutcome::Complete);
}

/// The fuel is cut: the crank swings to and fro on the last compression and stands, held by friction, load, or both.
#[test]
fn xcheck_standstill() {
    for (load, friction) in
        [(LoadLaw::Constant(15.0), 0.0), (LoadLaw::None, 12.0), (LoadLaw::Constant(9.0), 8.0)]
    {
        let case = Case {
            engine: single(""),
            governor: None,
            events: vec![Event { when: When::Angle(2.0 * TAU), action: Action::Fuel(0.0) }],
            driveline: Vec::new(),
            moves: false,
            load,
            friction,
            revolutions: 100.0,
        };
        let (theirs, ours) = case.check(&[ANGLE, SPEED]);
        let RunOutcome::AtRest { theta, torque, held_by } = theirs.outcome else {
            panic!("{:?}", theirs.outcome)
        };
        assert!(ours.complete, "{}", ours.ended);
        // Behind the last of the samples of both, where it stands.
        let later = case.graph(1.01 * theirs.end[0], &[1.005 * theirs.end[0]]);
        let last =
            |name: &str| later.values(name).and_then(|values| values.last().copied()).unwrap_or(f64::NAN);
        assert!((last("theta") - theta).abs() < AGREEMENT * theta, "{} {theta}", last("theta"));
        // What holds it there is less than what both have to give.
        let own = ["friction.effort", "load.effort"]
            .map(last)
            .into_iter()
            .filter(|own| own.is_finite())
            .sum::<f64>();
        assert!((own - torque).abs() < 1e-6 * held_by && own.abs() < held_by, "{own} {torque} of {held_by}");
    }
}

/// The same on mounts: the block goes on to swing while the crank stands in it.
#[test]
fn xcheck_standstill_in_a_block_that_moves() {
    let case = Case {
        engine: single(&(BLOCK.to_owned() + &mounts())),
        governor: None,
        events: vec![Event { when: When::Angle(2.0 * TAU), action: Action::Fuel(0.0) }],
        driveline: Vec::new(),
        moves: true,
        load: LoadLaw::None,
        friction: 12.0,
        revolutions: 100.0,
    };
    let (theirs, ours) = case.check(&[ANGLE, SPEED]);
    assert!(matches!(theirs.outcome, RunOutcome::AtRest { .. }), "{:?}", theirs.outcome);
    assert!(
        ours.complete && ours.events.iter().any(|event| event.expression.ends_with(" sticks")),
        "{}",
        ours.ended
    );
}
