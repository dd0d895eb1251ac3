//! Compliant joints: their motion and forces go over into those of ideal joints as they stiffen, and they keep energy.

use lanchester_bondgraph::{
    CompliantJoints, EngineBlock, EngineDrive, EngineJoints, EngineRequest, Equations, Graph, Simulation,
    SimulationRequest, engine_graph, equations,
};
use lanchester_file::{read, template};
use lanchester_model::Engine;

fn engine(text: &str) -> Engine {
    let read = read(text);
    read.engine().unwrap_or_else(|| panic!("{:#?}", read.diagnostics))
}

/// A single with an offset of its piston pin.
fn single() -> Engine {
    engine(
        "name = \"single\"\nstrokes = 4\nspeed = \"2000 rpm\"\nfiring = { order = [1] }\n[layout]\ntype = \"in-line\"\ncylinders = 1\n\
         [crank]\nstroke = \"85 mm\"\npin_mass = \"0.45 kg\"\n[piston]\nmass = \"0.36 kg\"\nbore = \"86 mm\"\npin_offset = \"1 mm\"\n\
         [rod]\nlength = \"150 mm\"\nbig_end_mass = \"0.34 kg\"\nsmall_end_mass = \"0.13 kg\"\ninertia = \"0.0021 kg m2\"\n",
    )
}

fn found(engine: &Engine, request: &EngineRequest) -> Equations {
    let description = engine_graph(engine, request).unwrap_or_else(|error| panic!("{error}"));
    let graph = Graph::new(&description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

fn run(found: &Equations, tolerance: f64) -> Simulation {
    let run = found.simulate(&SimulationRequest { tolerance, ..found.request() });
    assert!(run.complete, "{}", run.ended);
    run
}

fn values<'a>(run: &'a Simulation, name: &str) -> &'a [f64] {
    run.values(name).unwrap_or_else(|| panic!("no {name}"))
}

/// Joints of a stiffness, skirts a quarter of it; crankshafts of a mass in bearings that give way.
fn joints(stiffness: f64, crankshafts: Vec<Option<[f64; 2]>>) -> EngineJoints {
    EngineJoints::Compliant(CompliantJoints {
        stiffness,
        skirt_stiffness: 0.25 * stiffness,
        damping_ratio: 0.3,
        crankshafts,
        ..CompliantJoints::default()
    })
}

/// Largest difference of some quantities between compliant joints of a stiffness and ideal ones.
fn off(
    engine: &Engine,
    request: &EngineRequest,
    stiffness: f64,
    mass: Option<f64>,
    names: &[String],
) -> Vec<f64> {
    let ideal = run(&found(engine, request), 1e-9);
    let crankshafts = vec![mass.map(|mass| [mass, 0.01]); engine.crankshafts.len()];
    let request = EngineRequest { joints: joints(stiffness, crankshafts), ..request.clone() };
    let compliant = run(&found(engine, &request), 1e-9);
    let difference = |name: &String| {
        let pairs = values(&ideal, name).iter().zip(values(&compliant, name));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    names.iter().map(difference).collect()
}

/// As the joints stiffen by 10 the difference to ideal ones falls by 10.
fn falls_by_ten(engine: &Engine, request: &EngineRequest, mass: Option<f64>, names: &[String]) {
    let soft = off(engine, request, 4e8, mass, names);
    let stiff = off(engine, request, 4e9, mass, names);
    for ((name, soft), stiff) in names.iter().zip(soft).zip(stiff) {
        let ratio = soft / stiff;
        assert!((8.5..11.5).contains(&ratio), "{}: {name} {soft:e} {stiff:e}, {ratio}", engine.name);
    }
}

#[test]
fn compliant_joints_go_over_into_ideal_ones() {
    let request = EngineRequest {
        crankshaft_inertia: vec![0.09],
        gravity: 9.81,
        samples: 90,
        piston_damping: 4.0,
        ..EngineRequest::free(150.0, 0.5)
    };
    let names = ["theta", "crank.flow"].map(str::to_owned);
    falls_by_ten(&single(), &request, None, &names);
    falls_by_ten(&single(), &request, Some(9.0), &names);
}

/// Of an imposed speed the piston's travel is left.
#[test]
fn the_piston_goes_over_into_its_ideal_travel() {
    let request = EngineRequest {
        drive: EngineDrive::Imposed,
        samples: 90,
        start_angle: 0.4,
        ..EngineRequest::free(200.0, 0.5)
    };
    let engine = single();
    falls_by_ten(&engine, &request, None, &["s1".to_owned()]);
    falls_by_ten(&engine, &request, Some(9.0), &["s1".to_owned()]);
}

/// Every spring starts with what it carries: over the first degrees its force is that of a run a turn later, when all has settled.
#[test]
fn nothing_rattles_at_the_start() {
    let request = EngineRequest {
        drive: EngineDrive::Imposed,
        joints: joints(2e8, vec![Some([9.0, 0.0])]),
        samples: 360,
        gravity: 9.81,
        ..EngineRequest::free(200.0, 2.0)
    };
    let run = run(&found(&single(), &request), 1e-9);
    for name in [
        "crankpin1_motion.5",
        "crankpin1_motion.6",
        "pin1_motion.7",
        "pin1_motion.8",
        "contact1_motion.3",
        "contact1_motion.4",
    ] {
        let forces = values(&run, &format!("{name}.effort"));
        let largest = forces.iter().fold(0.0f64, |most, force| most.max(force.abs()));
        for (early, late) in forces.iter().zip(&forces[180..]).take(20) {
            assert!(
                (early - late).abs() < 0.02 * largest,
                "{name}: {early} at the start, {late} later, of {largest}"
            );
        }
    }
}

/// A block in space on nothing but its inertia, articulated rods, geared crankshafts: what the bodies carry beside their own motion.
#[test]
fn the_block_in_space_goes_over_too() {
    const BLOCK: &str = "[block]\nmass = \"90 kg\"\ncentre = [\"60 mm\", \"8 mm\", \"15 mm\"]\n\
                         inertia = [\"5 kg m2\", \"4.5 kg m2\", \"2.2 kg m2\", \"0.1 kg m2\", \"0.15 kg m2\", \"-0.2 kg m2\"]\n";
    for (name, mass) in [("in-line-3", Some(14.0)), ("v2-90", None)] {
        let text = template(name).expect("it is in the gallery").text.to_owned() + BLOCK;
        let engine = engine(&text);
        let count = engine.crankshafts.len();
        for block in [EngineBlock::Plane, EngineBlock::Space] {
            let request = EngineRequest {
                block,
                crankshaft_inertia: vec![0.09; count],
                gravity: 9.81,
                samples: 60,
                ..EngineRequest::free(150.0, 0.5)
            };
            let mut names = ["theta", "wz.flow", "vx.flow"].map(str::to_owned).to_vec();
            if block == EngineBlock::Space {
                names.extend(["wx.flow", "wy.flow"].map(str::to_owned));
            }
            falls_by_ten(&engine, &request, mass, &names);
        }
    }
}

/// Articulated rods on their master, crankshafts geared to one another.
#[test]
fn articulated_rods_and_geared_crankshafts_go_over() {
    for name in ["radial-5", "square-4"] {
        let engine = engine(template(name).expect("it is in the gallery").text);
        let count = engine.crankshafts.len();
        let request = EngineRequest {
            crankshaft_inertia: vec![0.09; count],
            samples: 60,
            ..EngineRequest::free(120.0, 0.5)
        };
        falls_by_ten(&engine, &request, None, &["theta".to_owned(), "crank.flow".to_owned()]);
    }
}

/// Without dampers, load and friction the whole keeps its energy, and no store of the mechanism follows in a fixed block.
#[test]
fn compliant_joints_keep_energy() {
    let mut joints = CompliantJoints { damping_ratio: 0.0, ..CompliantJoints::default() };
    joints.crankshafts = vec![Some([9.0, 0.0])];
    let request = EngineRequest {
        joints: EngineJoints::Compliant(joints),
        crankshaft_inertia: vec![0.09],
        ..EngineRequest::free(150.0, 1.0)
    };
    let found = found(&single(), &request);
    assert!(found.causality.followers.iter().all(|follower| follower.element.contains("unbalance")));
    let run = found.simulate(&SimulationRequest { tolerance: 1e-10, audit: true, ..found.request() });
    assert!(run.complete, "{}", run.ended);
    let audit = run.audit.expect("asked for");
    assert!(audit.whole < 1e-9, "{:e}", audit.whole);
}

#[test]
fn a_body_without_mass_is_refused() {
    let refused = |engine: &Engine, joints: CompliantJoints| {
        let request = EngineRequest {
            joints: EngineJoints::Compliant(joints),
            crankshaft_inertia: vec![0.09],
            ..EngineRequest::free(150.0, 1.0)
        };
        engine_graph(engine, &request).expect_err("nothing to move").to_string()
    };
    let light = single().with(|engine| engine.cylinders[0].piston_mass = 0.0).expect("valid");
    let message = refused(&light, CompliantJoints::default());
    assert!(message.contains("a piston with a mass in cylinder 1"), "{message}");
    let message = refused(&single(), CompliantJoints { stiffness: 0.0, ..CompliantJoints::default() });
    assert!(message.contains("a stiffness above 0"), "{message}");
    let message =
        refused(&single(), CompliantJoints { damping_ratio: f64::NAN, ..CompliantJoints::default() });
    assert!(message.contains("damping ratio"), "{message}");
}

/// Engines that are symmetric about the middle of their blocks: nothing tilts them but rounding, which must not be followed.
#[test]
fn what_symmetry_keeps_at_zero_costs_no_steps() {
    const BLOCK: &str = "[block]\nmass = \"90 kg\"\ncentre = [\"60 mm\", \"0 mm\", \"0 mm\"]\n\
                         inertia = [\"5 kg m2\", \"4.5 kg m2\", \"2.2 kg m2\"]\n";
    for name in ["in-line-4", "in-line-6", "boxer-6"] {
        let text = template(name).expect("it is in the gallery").text.to_owned() + BLOCK;
        let engine = engine(&text);
        let steps = |block: EngineBlock| {
            let request = EngineRequest {
                block,
                crankshaft_inertia: vec![0.09],
                samples: 60,
                ..EngineRequest::free(150.0, 0.1)
            };
            run(&found(&engine, &request), 1e-10).statistics
        };
        let (plane, space) = (steps(EngineBlock::Plane), steps(EngineBlock::Space));
        assert!(
            space.evaluations < plane.evaluations + plane.evaluations / 4,
            "{space:?} steps in space, {plane:?} in the plane"
        );
    }
}
