//! Published trajectories of mechanisms and engines.

use crate::support;
use lanchester_model::{Engine, Rod, RodJoint, RodMassRule, Strokes};
use lanchester_multibody::referee::{BodyLoad, Pose};
use lanchester_multibody::{
    Duration, GasPressure, Guidance, LoadLaw, Motion, RotorInertia, Run, RunOutcome, Simulation, TorqueOrder,
    Train,
};
use lanchester_numerics::{Dop853, Function, Outcome, Settings};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;
use support::{assert_close, cylinder, engine, throw};

/// The gas law of the Modelica library's engines: a polynomial of the piston's travel, another one on the way back.
struct ModelicaGas {
    radius: f64,
    rod: f64,
    /// Length of the chamber and travel of the pin where the piston touches its end [m].
    length: f64,
    top: f64,
}

impl GasPressure for ModelicaGas {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        let own = own.rem_euclid(TAU);
        let (sin, cos) = own.sin_cos();
        let pin = self.radius * cos + (self.rod * self.rod - (self.radius * sin).powi(2)).sqrt();
        let x = 1.0 - (self.top - pin) / self.length;
        let by = |c: [f64; 5]| c.iter().fold(0.0, |sum, c| sum * x + c);
        let falling = own > PI;
        1e5 * if falling {
            by([177.4132, -287.2189, 151.8252, -24.9973, 2.4])
        } else {
            by([145.930, -131.707, 17.3438, 17.9272, 2.4])
        }
    }

    fn cycle(&self) -> f64 {
        TAU
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        vec![0.0, PI]
    }
}

fn rod(length: f64, mass: f64, inertia: f64) -> Rod {
    Rod {
        length,
        big_end_mass: 0.5 * mass,
        small_end_mass: 0.5 * mass,
        inertia: Some(inertia),
        axial_inertia: 0.0,
        mass_rule: RodMassRule::CentreOfGravity,
        joint: RodJoint::Crankpin,
    }
}

/// One crankshaft of this inertia with plain cylinders: axis and throw angle [rad].
fn train(
    places: &[[f64; 2]],
    radius: f64,
    piston: f64,
    rod: &Rod,
    unbalance: f64,
    inertia: f64,
) -> (Engine, Train) {
    let throws = places.iter().map(|place| {
        let own = throw(place[1], 0.0);
        lanchester_model::Throw { radius, unbalance, ..own }
    });
    let cylinders = places.iter().enumerate().map(|(index, place)| lanchester_model::Cylinder {
        piston_mass: piston,
        rod: rod.clone(),
        bore: Some(0.1),
        firing_angle: Some((place[0] - place[1]).rem_euclid(TAU)),
        ..cylinder(index, place[0], 0.0)
    });
    let mut engine = engine("published", throws.collect(), cylinders.collect());
    engine = engine
        .with(|engine| {
            engine.strokes = Strokes::Two;
        })
        .unwrap();
    let inertia = RotorInertia { crankshafts: vec![Some(inertia)], ..RotorInertia::default() };
    let train = Train::new(&engine, &inertia).expect("it turns");
    (engine, train)
}

fn until(train: &Train, simulation: &Simulation, gas: Option<&dyn GasPressure>, time: f64) -> Run {
    let simulation = Simulation { duration: Duration::Time(time), step: 0.05, ..simulation.clone() };
    let run = train.run(&simulation, gas).expect("it can be run");
    assert_eq!(run.outcome, RunOutcome::Complete);
    assert!((run.end[0] - time).abs() < 1e-12);
    run
}

#[test]
fn lit_modelica_v6() {
    let deg = |angle: f64| angle.to_radians();
    let places = [[-30.0, -30.0], [30.0, 90.0], [-30.0, 210.0], [30.0, 210.0], [-30.0, 90.0], [30.0, -30.0]];
    let places = places.map(|place| place.map(deg));
    let (_, train) = train(&places, 0.05, 6.0, &rod(0.175, 1.0, 0.006), 0.0, 1.1);
    let gas = ModelicaGas { radius: 0.05, rod: 0.175, length: 0.195, top: 0.32 };
    let mut simulation = Simulation::free(10.0, 1.0);
    simulation.gravity = 9.81;
    simulation.load.law = LoadLaw::Quadratic { torque: 100.0, at: 200.0 };
    simulation.tolerance = 1e-10;
    let published = [
        [0.250076, 10.5693582, 74.0558742],
        [0.49995, 36.6135188, 133.2665473],
        [0.9999, 128.1349118, 226.7273075],
        [1.01, 130.4325251, 228.2451155],
    ];
    for [time, angle, speed] in published {
        let run = until(&train, &simulation, Some(&gas), time);
        assert_close("angle", run.end[1], angle, 0.0, 1e-5, "the published run has tolerance 1e-6");
        assert_close("speed", run.end[2], speed, 0.0, 1e-5, "the published run has tolerance 1e-6");
        assert!(run.audit.energy < 1e-9 && run.audit.loops < 1e-12, "{:?}", run.audit);
        // Own convergence.
        let finer = until(&train, &Simulation { tolerance: 1e-12, ..simulation.clone() }, Some(&gas), time);
        assert_close(
            "speed at a finer tolerance",
            run.end[2],
            finer.end[2],
            0.0,
            1e-9,
            "tolerance 1e-10 in every step",
        );
        assert_close(
            "angle at a finer tolerance",
            run.end[1],
            finer.end[1],
            0.0,
            1e-9,
            "tolerance 1e-10 in every step",
        );
    }
}

fn single() -> Train {
    let inertia = 1.848 * (0.2f64.powi(2) + 0.06f64.powi(2)) / 12.0;
    let unbalance = 2.0 * 0.77 * 0.05 + 0.544 * 0.1;
    train(&[[0.0, 0.0]], 0.1, 6.047565858, &rod(0.2, 1.848, inertia), unbalance, 1.0114306736).1
}

#[test]
fn lit_modelica_single_with_gas() {
    let gas = ModelicaGas { radius: 0.1, rod: 0.2, length: 0.35, top: 0.35 };
    let mut simulation = Simulation::free(10.0, 1.0);
    simulation.gravity = 9.81;
    for [time, angle, speed] in [[0.2, 10.3122699, 77.6646392], [0.5, 41.0301550, 137.0892000]] {
        let run = until(&single(), &simulation, Some(&gas), time);
        assert_close("angle", run.end[1], angle, 0.0, 5e-5, "figures of the published run");
        assert_close("speed", run.end[2], speed, 0.0, 5e-5, "figures of the published run");
    }
}

#[test]
fn lit_modelica_single_without_gas() {
    let mut simulation = Simulation::free(10.0, 1.0);
    simulation.gravity = 9.81;
    for [time, angle, speed] in [[1.0, 10.7675638, 10.9078436], [5.0, 53.4151973, 11.6403585]] {
        let run = until(&single(), &simulation, None, time);
        assert_close("angle", run.end[1], angle, 0.0, 2e-4, "figures of the published run");
        assert_close("speed", run.end[2], speed, 0.0, 2e-4, "figures of the published run");
    }
}

#[test]
fn lit_slider_crank_from_rest() {
    let inertia = 0.2 * 0.09 / 12.0;
    let (_, train) = train(&[[0.0, 0.0]], 0.1, 0.4, &rod(0.3, 0.2, inertia), 0.0, 0.2 * 0.01 / 3.0);
    let mut simulation = Simulation::free(0.0, 1.0);
    simulation.torque = vec![TorqueOrder { order: 0.0, sin: 0.0, cos: 0.1 }];
    let run = until(&train, &simulation, None, 3.0);
    assert_close("angle", run.end[1], 121.89082, 0.0, 1e-4, "the published run is itself 4e-5 off");
}

/// The same on the referee, which knows neither loop nor crank angle: bodies and joints, put back onto their joints after every hundredth of a second.
#[test]
fn lit_slider_crank_from_rest_on_the_referee() {
    let inertia = 0.2 * 0.09 / 12.0;
    let (_, train) = train(&[[0.0, 0.0]], 0.1, 0.4, &rod(0.3, 0.2, inertia), 0.0, 0.2 * 0.01 / 3.0);
    let mut places = Vec::new();
    train.places_into(0.0, &mut places);
    let judge = train.referee(&Motion::fixed(0.0, 0.0), &places, Guidance::Crankpin).expect("one freedom");
    let (assembly, mut poses) = (judge.assembly, judge.poses);
    let drive = [BodyLoad { body: judge.rotors[0], force: Vector3::zeros(), moment: 0.1 * Vector3::z() }];
    let angle = |poses: &[Pose]| {
        let own = poses[judge.rotors[0]].rotation;
        own[(1, 0)].atan2(own[(0, 0)])
    };
    let mut turned = angle(&poses);
    for piece in 0..300 {
        let mut state = assembly.pack(&poses);
        let mut system = Function::new(assembly.dimension(), |_, y: &[f64], rate: &mut [f64]| {
            assembly.rate(y, &drive, rate);
        });
        let mut settings = Settings::uniform(assembly.dimension(), 1e-9);
        settings.dense = false;
        let [mut t, end] = [piece, piece + 1].map(|k| 0.01 * f64::from(k));
        let outcome =
            Dop853::new(settings).run(&mut system, &mut t, &mut state, end, |_| ControlFlow::Continue(()));
        assert_eq!(outcome, Outcome::Reached);
        poses = assembly.unpack(&state);
        assembly.project(&mut poses).expect("it is near");
        turned += (angle(&poses) - turned + PI).rem_euclid(TAU) - PI;
    }
    assert_close("angle", turned, 121.89082, 0.0, 1e-4, "the published run is itself 4e-5 off");
    let mut simulation = Simulation::free(0.0, 1.0);
    simulation.torque = vec![TorqueOrder { order: 0.0, sin: 0.0, cos: 0.1 }];
    let run = until(&train, &simulation, None, 3.0);
    assert_close("equations of motion", turned, run.end[1], 0.0, 1e-7, "both to their tolerance");
}
