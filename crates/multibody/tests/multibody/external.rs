//! Programs by others: joint loads, free runs and the moving block by Pinocchio (minimal coordinates with loop constraints) and Exudyn (six coordinates a body).

use crate::support;
use lanchester_model::{Block, Cylinder, Engine, MovingParts, Rod, RodJoint, RodMassRule, Strokes, Throw};
use lanchester_multibody::*;
use nalgebra::Vector3;
use serde_json::Value;
use std::f64::consts::{PI, TAU};

/// The gas of both programs: `peak exp(sharpness (cos(own - shift) - 1))`, one turn a cycle.
struct Gas {
    peak: f64,
    sharpness: f64,
    shift: f64,
}

impl GasPressure for Gas {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        self.peak * (self.sharpness * ((own - self.shift).cos() - 1.0)).exp()
    }

    fn cycle(&self) -> f64 {
        TAU
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        Vec::new()
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(number).collect()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn three(value: &Value) -> [f64; 3] {
    numbers(value).try_into().expect("three numbers")
}

/// The engine that a program was given, read from what it wrote.
fn engine(given: &Value) -> Engine {
    let throw = |own: &Value| Throw {
        radius: number(&own["radius"]),
        unbalance: number(&own["unbalance"]),
        ..support::throw(number(&own["angle"]), number(&own["z"]))
    };
    let cylinder = |own: &Value| {
        let rod = &own["rod"];
        let [length, mass, centre] = ["length", "mass", "centre"].map(|key| number(&rod[key]));
        Cylinder {
            offset: number(&own["offset"]),
            piston_mass: number(&own["piston"]),
            bore: Some(number(&own["bore"])),
            firing_angle: Some(number(&own["firing"])),
            rod: Rod {
                length,
                big_end_mass: mass * (1.0 - centre / length),
                small_end_mass: mass * centre / length,
                inertia: Some(number(&rod["inertia"])),
                axial_inertia: 0.0,
                mass_rule: RodMassRule::CentreOfGravity,
                joint: RodJoint::Crankpin,
            },
            ..support::cylinder(number(&own["throw"]) as usize, number(&own["axis"]), number(&own["z"]))
        }
    };
    let name = given["name"].as_str().expect("a name");
    let throws = list(&given["throws"]).iter().map(throw).collect();
    let made = support::engine(name, throws, list(&given["cylinders"]).iter().map(cylinder).collect());
    let block = &given["block"];
    made.with(|parts| {
        parts.strokes = Strokes::Two;
        parts.block = Some(Block {
            mass: number(&block["mass"]),
            centre: three(&block["centre"]),
            inertia: three(&block["inertia"]),
            products: three(&block["products"]),
            moving_parts: MovingParts::Added,
            gravity: [-1.0, 0.0, 0.0],
            driveline_torque: [0.0; 3],
        });
    })
    .expect("it is valid")
}

/// Largest differences of what a program says of one kind, and the largest value of the kind.
#[derive(Default)]
struct Off([f64; 2]);

impl Off {
    fn add(&mut self, ours: &[f64], theirs: &[f64]) {
        assert_eq!(ours.len(), theirs.len());
        for (ours, theirs) in ours.iter().zip(theirs) {
            self.0[0] = self.0[0].max((ours - theirs).abs());
            self.0[1] = self.0[1].max(theirs.abs());
        }
    }

    fn hold(&self, name: &str, bar: f64) {
        let [off, peak] = self.0;
        assert!(peak > 0.0 && off <= bar * peak, "{name}: off by {off:e} of {peak:e}");
    }
}

struct Case {
    train: Train,
    gas: Gas,
    speed: f64,
    load: f64,
    written: Value,
}

fn cases(text: &str) -> Vec<Case> {
    let all: Value = serde_json::from_str(text).expect("what a program wrote");
    let of = |key: &str| number(&all["gas"][key]);
    let each = list(&all["engines"]).iter().map(|written| {
        let given = &written["engine"];
        let inertia = RotorInertia {
            crankshafts: vec![Some(number(&given["crank_inertia"]))],
            ..RotorInertia::default()
        };
        Case {
            train: Train::new(&engine(given), &inertia).expect("it turns"),
            gas: Gas { peak: of("peak"), sharpness: of("sharpness"), shift: of("shift") },
            speed: number(&given["speed"]),
            load: number(&given["load"]),
            written: written.clone(),
        }
    });
    let each: Vec<Case> = each.collect();
    assert_eq!(each.len(), 3, "single, boxer twin, V6 with split pins");
    each
}

impl Case {
    fn forces(&self, theta: f64) -> Vec<f64> {
        let of = |index: usize| {
            let own = self.train.own_angle(index, theta);
            self.train.cylinders[index].area.expect("it has a bore")
                * self.gas.pressure(index, own, self.speed)
        };
        (0..self.train.cylinders.len()).map(of).collect()
    }

    /// Every joint load at imposed speed.
    fn hold_loads(&self, bar: f64) {
        let mut off: [Off; 5] = Default::default();
        for instant in list(&self.written["imposed"]) {
            let theta = number(&instant["theta"]);
            let motion = Motion::fixed(theta, self.speed);
            let mut places = Vec::new();
            self.train.places_into(theta, &mut places);
            let ours = self.train.reactions(
                &Instant {
                    motion: &motion,
                    places: &places,
                    rates: [0.0; 7],
                    gas: &self.forces(theta),
                    gravity: Vector3::zeros(),
                    piston_damping: 0.0,
                    guidance: Guidance::Crankpin,
                },
                &self.train.main_shares(&[]),
            );
            for (index, own) in ours.cylinders.iter().enumerate() {
                let pins = [("piston_pin", own.piston_pin), ("crankpin", own.lower_pin), ("wall", own.wall)];
                for (off, (name, wrench)) in off.iter_mut().zip(pins) {
                    off.add(&wrench.force[..2], &numbers(&instant[name][index]));
                }
            }
            let bearings = ours.rotors[0].bearings;
            let theirs = numbers(&instant["bearings"]);
            let [fx, fy, _] = bearings.force;
            let [mx, my, _] = bearings.moment;
            off[3].add(&[fx, fy, mx, my], &theirs);
            off[4].add(&[ours.shaft_torque], &[number(&instant["shaft_torque"])]);
        }
        let names = ["piston pins", "crankpins", "walls", "bearings", "shaft torque"];
        off.iter().zip(names).for_each(|(off, name)| off.hold(&format!("{}, {name}", self.train.name), bar));
    }

    /// Angle, but for whole turns, and speed of the free run.
    fn hold_free(&self, bar: f64) {
        let instants = list(&self.written["free"]);
        let mut worst = [0.0f64; 2];
        for instant in instants {
            let mut simulation =
                Simulation { tolerance: 1e-12, step: 1.0, ..Simulation::free(self.speed, 1.0) };
            simulation.duration = Duration::Time(number(&instant["time"]));
            simulation.load.law = LoadLaw::Constant(self.load);
            let run = self.train.run(&simulation, Some(&self.gas)).expect("it runs");
            assert_eq!(run.outcome, RunOutcome::Complete);
            let [_, theta, speed] = run.end;
            let apart = (theta - number(&instant["theta"]) + PI).rem_euclid(TAU) - PI;
            worst =
                [worst[0].max(apart.abs()), worst[1].max((speed / number(&instant["speed"]) - 1.0).abs())];
        }
        assert!(
            instants.len() == 16 && worst.iter().all(|off| *off <= bar),
            "{}: {worst:?}",
            self.train.name
        );
    }

    /// Seven accelerations with the block afloat.
    fn hold_moving(&self, bar: f64) {
        let states = list(&self.written["moving"]);
        assert_eq!(states.len(), 6);
        for state in states {
            let theta = number(&state["theta"]);
            let motion = Motion {
                theta,
                speed: number(&state["speed"]),
                position: Vector3::zeros(),
                orientation: numbers(&state["orientation"]).try_into().expect("four numbers"),
                velocity: three(&state["velocity"]).into(),
                spin: three(&state["spin"]).into(),
            };
            let mut places = Vec::new();
            self.train.places_into(theta, &mut places);
            let gas = self.forces(theta);
            let loads = Loads {
                gravity: motion.rotation().tr_mul(&Vector3::new(-9.81, 0.0, 0.0)),
                inner_torque: number(&state["torque_from_block"]),
                ..Loads::gas(&gas)
            };
            let equations = self.train.equations(&motion, &places);
            let forces = self.train.generalised_forces(&equations, &places, motion.speed, &loads);
            let rates = equations.accelerations(&forces).expect("the mass matrix is positive definite");
            let theirs = numbers(&state["rates"]);
            let mut off = [Off::default(), Off::default(), Off::default()];
            off[0].add(&rates[..3], &theirs[..3]);
            off[1].add(&rates[3..6], &theirs[3..6]);
            off[2].add(&rates[6..], &theirs[6..]);
            off.iter().for_each(|off| off.hold(&format!("{}, block afloat", self.train.name), bar));
        }
    }
}

/// Algebra against algebra: rounding.
#[test]
fn ext_pinocchio() {
    for case in cases(include_str!("../../../../validation/external/multibody/pinocchio.json")) {
        case.hold_loads(1e-9);
        case.hold_free(1e-9);
        case.hold_moving(1e-9);
    }
}

/// Its trapezoidal rule with 14400 steps a revolution is some 1e-6 off.
#[test]
fn ext_exudyn() {
    for case in cases(include_str!("../../../../validation/external/multibody/exudyn.json")) {
        case.hold_loads(1e-5);
        case.hold_free(1e-5);
    }
}
