//! How long a run takes: ten revolutions at free speed, tolerance 1e-9, of a single and a V6 with a sealed gas; with every reaction, on mounts, and the periodic motion.
use criterion::{Criterion, criterion_group, criterion_main};
use lanchester_file::{read, template};
use lanchester_model::*;
use lanchester_multibody::{BlockMotion, Duration, GasPressure, LoadLaw, RotorInertia, Simulation, Train};
use std::f64::consts::TAU;
use std::hint::black_box;

/// A closed cylinder of compression ratio 9, fired by a factor on the expansion.
struct Sealed;

impl GasPressure for Sealed {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        let own = own.rem_euclid(2.0 * TAU);
        // Two revolutions: expansion, exhaust, intake, compression.
        let volume = |angle: f64| 1.0 + 4.0 * (1.0 - angle.cos());
        match own {
            own if own < TAU / 2.0 => 1e5 * (2.0 * (9.0f64 / volume(own)).powf(1.35) - 1.0),
            own if own < 1.5 * TAU => 0.0,
            own => 1e5 * ((9.0f64 / volume(own)).powf(1.35) - 1.0),
        }
    }

    fn cycle(&self) -> f64 {
        2.0 * TAU
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        vec![0.0, TAU / 2.0, 1.5 * TAU]
    }
}

/// An engine of the gallery with bores, firing angles and a block on four mounts.
fn engine(name: &str) -> Engine {
    let template = template(name).expect("the gallery has it");
    let file = read(template.text).file.expect("the gallery's files are valid");
    let mut engine = file.engine.into_parts();
    let count = engine.cylinders.len();
    for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
        cylinder.bore.get_or_insert(0.086);
        cylinder.firing_angle.get_or_insert(2.0 * TAU * index as f64 / count as f64);
    }
    engine.block = Some(Block {
        mass: 180.0,
        centre: [0.05, 0.01, 0.02],
        inertia: [12.0, 11.0, 6.0],
        products: [0.1, -0.2, 0.15],
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    });
    for (y, z) in [(0.25, 0.3), (-0.25, 0.28), (0.22, -0.25), (-0.25, -0.27)] {
        let spring = MountSpring { damping: [400.0; 3], ..MountSpring::along_frame([2e5, 1.2e5, 1e5]) };
        engine.mounts.push(Mount { name: format!("mount {y} {z}"), x: -0.1, y, z, spring: Some(spring) });
    }
    Engine::new(engine).expect("it is valid")
}

/// The gas of the Modelica library's V6: polynomials in the place of the piston, one turn a cycle.
struct ModelicaGas;

impl GasPressure for ModelicaGas {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        let own = own.rem_euclid(TAU);
        let (sin, cos) = own.sin_cos();
        let pin = 0.05 * cos + (0.175f64.powi(2) - (0.05 * sin).powi(2)).sqrt();
        let x = 1.0 - (0.32 - pin) / 0.195;
        let by = |c: [f64; 5]| c.iter().fold(0.0, |sum, c| sum * x + c);
        let falling = own > TAU / 2.0;
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
        vec![0.0, TAU / 2.0]
    }
}

/// The V6 of the Modelica library: 1.01 s from 10 rad/s under a load that goes with the square of the speed, to 1e-7.
fn modelica(c: &mut Criterion) {
    let deg = f64::to_radians;
    let places = [[-30.0, -30.0], [30.0, 90.0], [-30.0, 210.0], [30.0, 210.0], [-30.0, 90.0], [30.0, -30.0]];
    let rod = Rod {
        length: 0.175,
        big_end_mass: 0.5,
        small_end_mass: 0.5,
        inertia: Some(0.006),
        axial_inertia: 0.0,
        mass_rule: RodMassRule::CentreOfGravity,
        joint: RodJoint::Crankpin,
    };
    let throw = |[_, angle]: [f64; 2]| Throw {
        crankshaft: 0,
        angle: deg(angle),
        z: 0.0,
        radius: 0.05,
        unbalance: 0.0,
        unbalance_offset: 0.0,
        webs: None,
    };
    let cylinder = |(index, [axis, angle]): (usize, [f64; 2])| Cylinder {
        throw: index,
        angle: deg(axis),
        z: 0.0,
        offset: 0.0,
        pin_offset: 0.0,
        bore: Some(0.1),
        piston_mass: 6.0,
        rod: rod.clone(),
        firing_angle: Some(deg(axis - angle).rem_euclid(TAU)),
        chamber: None,
    };
    let crankshaft =
        Crankshaft { name: "crankshaft".into(), ratio: Ratio::ONE, phase: 0.0, x: 0.0, y: 0.0, mains: None };
    let engine = Engine::new(EngineParts {
        name: "V6".into(),
        strokes: Strokes::Two,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 200.0, highest: 200.0 },
        crankshafts: vec![crankshaft],
        throws: places.map(throw).into(),
        cylinders: places.into_iter().enumerate().map(cylinder).collect(),
        ..EngineParts::default()
    })
    .expect("it is valid");
    let inertia = RotorInertia { crankshafts: vec![Some(1.1)], ..RotorInertia::default() };
    let train = Train::new(&engine, &inertia).expect("it turns");
    let mut simulation = Simulation::free(10.0, 1.0);
    simulation.duration = Duration::Time(1.01);
    (simulation.gravity, simulation.tolerance, simulation.step) = (9.81, 1e-7, TAU);
    simulation.load.law = LoadLaw::Quadratic { torque: 100.0, at: 200.0 };
    c.bench_function("V6 of the Modelica library, 1.01 s", |b| {
        b.iter(|| train.run(black_box(&simulation), Some(&ModelicaGas)))
    });
}

fn runs(c: &mut Criterion) {
    let mut group = c.benchmark_group("ten revolutions");
    for (name, template) in [("single", "single"), ("V6", "v6-60")] {
        let engine = engine(template);
        let inertia = RotorInertia {
            crankshafts: vec![Some(0.2); engine.crankshafts.len()],
            shafts: vec![Some(1e-3); engine.shafts.len()],
            ..RotorInertia::default()
        };
        let train = Train::new(&engine, &inertia).expect("it turns");
        let mut plain = Simulation::free(200.0, 10.0);
        plain.load.law = LoadLaw::Viscous { torque: 15.0 * engine.cylinders.len() as f64, at: 200.0 };
        plain.step = TAU;
        let sampled = Simulation { step: TAU / 360.0, reactions: true, ..plain.clone() };
        let on_mounts = Simulation { block: BlockMotion::Mounts, gravity: 9.81, ..sampled.clone() };
        let run = |simulation: &Simulation| train.run(black_box(simulation), Some(&Sealed));
        group.bench_function(format!("{name}, trajectory"), |b| b.iter(|| run(&plain)));
        group.bench_function(format!("{name}, reactions at every degree"), |b| b.iter(|| run(&sampled)));
        group.bench_function(format!("{name}, on mounts, reactions at every degree"), |b| {
            b.iter(|| run(&on_mounts))
        });
        if name == "V6" {
            let quiet = Simulation { reactions: false, ..on_mounts.clone() };
            group.sample_size(10);
            group.bench_function("V6, on mounts, periodic", |b| {
                b.iter(|| train.periodic(black_box(&quiet), Some(&Sealed)))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, runs, modelica);
criterion_main!(benches);
