//! Forces of the bond graph's compliant joints against the reactions of the multibody simulation: side thrust, piston pins, crankpins and
//! knuckle pins. What they differ by is compliance alone, because it falls by ten as the joints stiffen by ten.

use lanchester::bondgraph::{
    CompliantJoints, Curve, EngineDrive, EngineJoints, EngineRequest, Graph, Method, Simulation,
    SimulationRequest, Unit, engine_graph, equations,
};
use lanchester::file::{read, template};
use lanchester::model::Engine;
use lanchester::multibody::{Guidance, Instant, Motion, RotorInertia, Train};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

/// Speed of crankshaft 1 [rad/s].
const SPEED: f64 = 200.0;
/// Crank angle in which what the start left behind dies away [rad].
const SETTLED: f64 = 0.5;

/// A smooth gauge pressure with a peak of 60 bar at the firing, as cubics [Pa].
fn pressure() -> Curve {
    let value = |psi: f64| 6e6 * (0.5 * psi).cos().powi(2).powi(12);
    let slope =
        |psi: f64| -6e6 * 12.0 * (0.5 * psi).cos().powi(2).powi(11) * (0.5 * psi).sin() * (0.5 * psi).cos();
    let count = 2880;
    let step = 2.0 * TAU / f64::from(count);
    let pieces: Vec<(f64, [f64; 4])> = (0..count)
        .map(|k| {
            let at = step * f64::from(k);
            let (a, b, end, last) = (value(at), slope(at), value(at + step), slope(at + step));
            let rise = (end - a) / step;
            (at, [a, b, (3.0 * rise - 2.0 * b - last) / step, (b + last - 2.0 * rise) / (step * step)])
        })
        .collect();
    Curve::cubics(&pieces, 2.0 * TAU, true, [Unit::NONE, Unit::of([-1, 1, -2, 0, 0])]).expect("pieces rise")
}

fn engine(text: &str) -> Engine {
    let read = read(text);
    read.engine().unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

fn run(engine: &Engine, stiffness: f64, gas: Option<&Curve>) -> Simulation {
    let joints = CompliantJoints {
        stiffness,
        skirt_stiffness: 0.5 * stiffness,
        damping_ratio: 0.7,
        ..CompliantJoints::default()
    };
    let request = EngineRequest {
        drive: EngineDrive::Imposed,
        joints: EngineJoints::Compliant(joints),
        pressures: gas.map_or_else(Vec::new, |gas| vec![gas.clone(); engine.cylinders.len()]),
        samples: 144,
        ..EngineRequest::free(SPEED, 1.0)
    };
    let description = engine_graph(engine, &request).unwrap_or_else(|error| panic!("{error}"));
    let found = equations(&Graph::new(&description).expect("units fit")).expect("no conflict");
    let run = found.simulate(&SimulationRequest {
        tolerance: 1e-9,
        method: Some(Method::Explicit),
        ..found.request()
    });
    assert!(run.complete, "{}", run.ended);
    run
}

/// Largest force, and largest difference, of walls, piston pins and lower pins.
fn off(engine: &Engine, stiffness: f64, gas: Option<&Curve>) -> [[f64; 2]; 3] {
    let inertia = RotorInertia {
        crankshafts: vec![Some(0.1); engine.crankshafts.len()],
        flywheel: 0.0,
        shafts: vec![Some(1e-3); engine.shafts.len()],
    };
    let train = Train::new(engine, &inertia).expect("it turns");
    let shares = train.main_shares(&[]);
    let run = run(engine, stiffness, gas);
    let theta = run.values("theta").expect("its angle");
    let mut kinds = [[0.0f64; 2]; 3];
    for (sample, theta) in theta.iter().enumerate().filter(|(_, theta)| **theta > SETTLED) {
        let forces: Vec<f64> = (0..engine.cylinders.len())
            .map(|index| {
                let area = train.cylinders[index].area.unwrap_or(0.0);
                gas.map_or(0.0, |gas| area * gas.at(train.own_angle(index, *theta), 0))
            })
            .collect();
        let motion = Motion::fixed(*theta, SPEED);
        let mut places = Vec::new();
        train.places_into(*theta, &mut places);
        let theirs = train.reactions(
            &Instant {
                motion: &motion,
                places: &places,
                rates: [0.0; 7],
                gas: &forces,
                gravity: Vector3::zeros(),
                piston_damping: 0.0,
                guidance: Guidance::Crankpin,
            },
            &shares,
        );
        let joint = |name: String| {
            ["spring", "damper"]
                .map(|part| run.values(&format!("{name}_{part}.effort")).expect("a joint")[sample])
                .iter()
                .sum::<f64>()
        };
        for (index, theirs) in theirs.cylinders.iter().enumerate() {
            let k = index + 1;
            let axis = train.cylinders[index].axis;
            let (along, across) = (joint(format!("pin{k}_along")), joint(format!("pin{k}_across")));
            let pin = [along * axis.re - across * axis.im, along * axis.im + across * axis.re];
            let lower = ["x", "y"].map(|axis| joint(format!("crankpin{k}_{axis}")));
            let side = joint(format!("contact{k}_1")) + joint(format!("contact{k}_2"));
            let pairs = [
                ([side, 0.0], [theirs.side_thrust, 0.0]),
                (pin, [theirs.piston_pin.force[0], theirs.piston_pin.force[1]]),
                (lower, [theirs.lower_pin.force[0], theirs.lower_pin.force[1]]),
            ];
            for (kind, (ours, theirs)) in kinds.iter_mut().zip(pairs) {
                kind[0] = kind[0].max(f64::hypot(theirs[0], theirs[1]));
                kind[1] = kind[1].max(f64::hypot(ours[0] - theirs[0], ours[1] - theirs[1]));
            }
        }
    }
    kinds
}

const SINGLE: &str = "name = \"single\"\nstrokes = 4\nspeed = \"2000 rpm\"\nfiring = { order = [1] }\n[layout]\ntype = \"in-line\"\n\
                      cylinders = 1\n[crank]\nstroke = \"85 mm\"\npin_mass = \"0.45 kg\"\n[piston]\nmass = \"0.36 kg\"\nbore = \"86 mm\"\n\
                      pin_offset = \"1 mm\"\n[rod]\nlength = \"150 mm\"\nbig_end_mass = \"0.34 kg\"\nsmall_end_mass = \"0.13 kg\"\n\
                      inertia = \"0.0021 kg m2\"\n";

#[test]
fn xcheck_joint_forces_fall_by_ten() {
    assert!(pressure().at(2.0 * PI, 0) > 5.9e6 && pressure().at(PI, 0) < 1.0, "one peak a turn");
    let gas = pressure();
    let radial = template("radial-5").expect("it is in the gallery").text;
    let twin = template("v2-90").expect("it is in the gallery").text;
    for (engine, gas) in
        [(engine(SINGLE), None), (engine(SINGLE), Some(&gas)), (engine(twin), None), (engine(radial), None)]
    {
        let (soft, stiff) = (off(&engine, 4e9, gas), off(&engine, 4e10, gas));
        for (what, (soft, stiff)) in
            ["side thrust", "piston pins", "lower pins"].iter().zip(soft.iter().zip(stiff))
        {
            let ratio = soft[1] / stiff[1];
            let words =
                format!("{}, gas {}: {what} {soft:?}, {stiff:?}, {ratio}", engine.name, gas.is_some());
            assert!((8.0..12.0).contains(&ratio), "{words}");
            assert!(stiff[1] < 1e-3 * stiff[0], "{words}");
        }
    }
}
