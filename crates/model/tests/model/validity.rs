//! An engine is valid by construction: parts that no engine has are faults, all at once, never a panic or an accepted number.

use lanchester_file::{read, templates};
use lanchester_model::{
    Block, Counterweight, CrankcasePressure, Cylinder, Engine, EngineParts, Envelope, Flywheel, Friction,
    Gas, GasSource, Liner, Mount, MovingParts, PressureTrace, Ratio, Rod, RodJoint, Throw,
};

fn gallery(name: &str) -> Engine {
    let template = templates().iter().find(|one| one.name == name).unwrap();
    read(template.text).engine().unwrap()
}

/// A change of a good engine, what it is a change of, and a word of what it needs.
type Case = (&'static str, fn(&mut EngineParts), &'static str, &'static str);

const CASES: [Case; 32] = [
    ("in-line-4", |e| e.cylinders[2].throw = 9, "cylinders[2]", "throw must be from 0 to 3"),
    ("in-line-4", |e| e.throws[1].crankshaft = 1, "throws[1]", "crankshaft must be from 0 to 0"),
    (
        "in-line-4",
        |e| e.cylinders[0].piston_mass = -1.0,
        "cylinders[0]",
        "piston_mass [kg] must be 0 or more",
    ),
    (
        "in-line-4",
        |e| e.cylinders[3].piston_mass = f64::NAN,
        "cylinders[3]",
        "piston_mass [kg] must be 0 or more",
    ),
    ("in-line-4", |e| e.cylinders[0].z = f64::INFINITY, "cylinders[0]", "z [m] must be a finite number"),
    ("in-line-4", |e| e.cylinders[0].bore = Some(0.0), "cylinders[0]", "bore [m] must be more than 0"),
    ("in-line-4", |e| e.throws[0].radius = 0.0, "throws[0]", "radius [m] must be more than 0"),
    (
        "in-line-4",
        |e| e.throws[0].angle = f64::NEG_INFINITY,
        "throws[0]",
        "angle [rad] must be a finite number",
    ),
    ("in-line-4", |e| e.throws[0].webs = Some([0.1, -0.1]), "throws[0]", "webs [m] must be front then rear"),
    ("in-line-4", |e| e.cylinders[1].rod.length = 0.01, "cylinders[1].rod", "length [m] must be more than"),
    ("in-line-4", |e| e.cylinders[1].offset = 1.0, "cylinders[1].rod", "length [m] must be more than"),
    ("in-line-4", |e| e.cylinders[1].chamber = Some(1), "cylinders[1]", "chamber must be the first piston"),
    ("in-line-4", |e| e.speed.lowest = 1e4, "speed", "highest [rad/s] must be at least"),
    ("in-line-4", |e| e.speed.highest = -1.0, "speed", "highest [rad/s] must be more than 0"),
    (
        "in-line-4",
        |e| e.crankshafts[0].ratio = Ratio::new(1, 2).unwrap(),
        "crankshafts[0]",
        "ratio must be 1",
    ),
    (
        "in-line-4",
        |e| e.crankshafts[0].mains = Some(vec![0.0]),
        "crankshafts[0]",
        "mains must be two or more",
    ),
    (
        "in-line-4",
        |e| e.crankshafts[0].mains = Some(vec![0.1, 0.0]),
        "crankshafts[0]",
        "mains [m] must be rising",
    ),
    (
        "in-line-3",
        |e| e.counterweights[0].unbalance = -0.01,
        "counterweights[0]",
        "unbalance [kg m] must be 0 or more",
    ),
    (
        "in-line-3",
        |e| e.counterweights[1] = e.counterweights[0].clone(),
        "counterweights[1]",
        "name must be another",
    ),
    (
        "in-line-3-shaft",
        |e| e.shafts[0].weights[0].phase = f64::NAN,
        "shafts[0].weights[0]",
        "phase [rad] must be",
    ),
    ("radial-7", |e| long_way(e), "cylinders[0].rod", "master must be"),
    ("radial-7", |e| e.cylinders[6].rod.length = 0.05, "cylinders[6].rod", "length [m] must be more than"),
    (
        "twin-360",
        |e| e.mounts = vec![mount("a"), mount("a")],
        "mounts[1]",
        "name must be another than that of mounts[0]",
    ),
    ("twin-360", |e| e.block = Some(thin_block()), "block", "inertia [kg m^2] must be that of some body"),
    (
        "in-line-4",
        |e| e.friction = Some(Friction::Given { fmep: f64::NAN }),
        "friction",
        "fmep [Pa] must be 0 or more",
    ),
    (
        "in-line-4",
        |e| e.friction = Some(Friction::Given { fmep: -1e6 }),
        "friction",
        "fmep [Pa] must be 0 or more",
    ),
    ("in-line-4", |e| e.gas = Some(traces(Vec::new())), "gas", "traces must be one or more"),
    (
        "in-line-4",
        |e| e.gas = Some(Gas { crankcase: crankcase(f64::NAN), ..traces(vec![trace()]) }),
        "gas",
        "crankcase pressure [Pa] must be more than 0",
    ),
    (
        "in-line-4",
        |e| e.gas = Some(traces(vec![PressureTrace { speed: Some(f64::NAN), ..trace() }])),
        "gas",
        "speed of a trace [rad/s] must be more than 0",
    ),
    (
        "in-line-4",
        |e| e.flywheel = Some(Flywheel { fluctuation: Some(5.0), ..Flywheel::default() }),
        "flywheel",
        "fluctuation must be more than 0 and less than 2",
    ),
    (
        "in-line-4",
        |e| e.envelope = Some(Envelope { least: Some(f64::NAN), ..Envelope::default() }),
        "envelope",
        "least [m] must be 0 or more",
    ),
    (
        "in-line-4",
        |e| {
            e.envelope = Some(Envelope { liner: Some(Liner { end: 0.1, wall: -1.0 }), ..Envelope::default() })
        },
        "envelope",
        "wall of the liner [m] must be more than 0",
    ),
];

fn trace() -> PressureTrace {
    PressureTrace {
        file: "pressure.csv".into(),
        speed: None,
        gauge: false,
        top_dead_centre: 0.0,
        counted_from_first: false,
    }
}

fn crankcase(pressure: f64) -> CrankcasePressure {
    CrankcasePressure::Constant { pressure }
}

fn traces(traces: Vec<PressureTrace>) -> Gas {
    Gas {
        ambient_pressure: 1e5,
        source: GasSource::Traces { traces, compression_ratio: None },
        crankcase: crankcase(1e5),
    }
}

fn long_way(parts: &mut EngineParts) {
    parts.cylinders[0].rod.joint =
        RodJoint::Articulated { master: 99, knuckle_radius: 0.05, knuckle_angle: 0.0 };
}

fn mount(name: &str) -> Mount {
    Mount { name: name.into(), x: 0.0, y: 0.0, z: 0.0, spring: None }
}

/// No body has a moment larger than the sum of the two others.
fn thin_block() -> Block {
    Block {
        mass: 50.0,
        centre: [0.0; 3],
        inertia: [9.0, 1.0, 1.0],
        products: [0.0; 3],
        moving_parts: MovingParts::Included,
        gravity: [-1.0, 0.0, 0.0],
        driveline_torque: [0.0; 3],
    }
}

#[test]
fn parts_of_no_engine_are_refused_with_their_place() {
    for (name, change, part, says) in CASES {
        let engine = gallery(name);
        let faults = engine.with(change).expect_err(says);
        let found = faults
            .iter()
            .any(|fault| fault.part == part && fault.to_string().contains(says) && !fault.remedy.is_empty());
        assert!(found, "{part}: {says}\n{faults:#?}");
    }
}

#[test]
fn all_faults_come_at_once() {
    let spoil = |parts: &mut EngineParts| {
        parts.cylinders[0].piston_mass = -1.0;
        parts.cylinders[1].throw = 7;
        parts.throws[2].z = f64::NAN;
    };
    assert_eq!(gallery("in-line-4").with(spoil).unwrap_err().len(), 3);
}

#[test]
fn every_engine_of_the_gallery_is_made_of_its_parts() {
    for template in templates() {
        let engine = read(template.text).engine().unwrap();
        assert_eq!(Engine::new(engine.clone().into_parts()).as_ref(), Ok(&engine), "{}", template.name);
        assert_eq!(engine.with(|_| {}).as_ref(), Ok(&engine), "{}", template.name);
    }
}

/// Without a file, in a few lines; what is missing has its default.
#[test]
fn an_engine_is_built_by_hand() {
    let cylinder = |throw: usize| Cylinder {
        throw,
        z: 0.05 - 0.1 * throw as f64,
        piston_mass: 0.3,
        rod: Rod::by_thirds(0.12, 0.4),
        ..Cylinder::default()
    };
    let throw = |angle: f64, z: f64| Throw { angle, z, radius: 0.04, ..Throw::default() };
    let parts = EngineParts {
        name: "Twin".into(),
        speed: lanchester_model::SpeedRange { lowest: 100.0, highest: 600.0 },
        crankshafts: vec![lanchester_model::Crankshaft::default()],
        throws: vec![throw(0.0, 0.05), throw(std::f64::consts::PI, -0.05)],
        cylinders: vec![cylinder(0), cylinder(1)],
        ..EngineParts::default()
    };
    let twin = Engine::new(parts).unwrap();
    assert_eq!(twin.crankshafts[0].ratio, Ratio::ONE);
    assert!((twin.rod_unbalance(0) - 0.4 * 2.0 / 3.0 * 0.04).abs() < 1e-15);
    // Nothing at all is no engine: it has no speed.
    assert_eq!(Engine::new(EngineParts::default()).unwrap_err().len(), 2);
    let weight = Counterweight { name: "w".into(), unbalance: 0.01, ..Counterweight::default() };
    let fitted = twin.with(|parts| parts.counterweights.push(weight)).unwrap();
    assert_eq!(fitted.without_counterweights(), twin);
}
