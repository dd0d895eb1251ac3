//! The three-cylinder engine of the bond-graph thesis (Singh 2017, chapter 3), with the inputs that it leaves open chosen as in
//! `examples/three-cylinder.toml`: its gas as states, and its rocking without and with the balancer shaft.

use lanchester_bondgraph::{
    EngineBlock, EngineDrive, EngineLoad, EngineRequest, Equations, GasStates, GasWalls, Graph, LoadTorque,
    Simulation, SimulationRequest, engine_graph, equations,
};
use lanchester_file::read;
use lanchester_model::Engine;
use std::f64::consts::TAU;

fn engine() -> Engine {
    let read = read(include_str!("../../../../examples/three-cylinder.toml"));
    read.engine().unwrap_or_else(|| panic!("{:#?}", read.diagnostics))
}

fn found(engine: &Engine, request: &EngineRequest) -> Equations {
    let description = engine_graph(engine, request).unwrap_or_else(|error| panic!("{error}"));
    let graph = Graph::new(&description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

fn request(engine: &Engine, speed: f64) -> EngineRequest {
    let wheel = engine.flywheel.as_ref().expect("it has one");
    let inertia = wheel.inertia.unwrap_or(0.0) + wheel.crankshaft_inertia.unwrap_or(0.0);
    EngineRequest { crankshaft_inertia: vec![inertia], ..EngineRequest::free(speed, 4.0) }
}

fn values<'a>(run: &'a Simulation, name: &str) -> &'a [f64] {
    run.values(name).unwrap_or_else(|| panic!("no {name}"))
}

/// Figures 3.23 to 3.25: pressures in the firing order, loops whose area is the work, a speed that settles where the load takes the mean
/// torque.
#[test]
fn lit_singh_pressures_speed_and_torque() {
    let engine = engine();
    let speed = TAU * 2000.0 / 60.0;
    let mut request = request(&engine, speed);
    let mut gas = GasStates::of(&engine).expect("a single zone");
    gas.walls = Some(GasWalls {
        gas_to_body: 1.0,
        body_capacity: 80.0 * 460.0,
        body_to_ambient: 25.0,
        ambient: 300.0,
    });
    request.gas_states = Some(gas);
    request.piston_damping = 20.0;
    // A quadratic load that takes 190 N m at 2000 rpm.
    request.load =
        EngineLoad { torque: LoadTorque::Quadratic(190.0 / (speed * speed)), reacts_on_block: false };
    let found = found(&engine, &request);
    assert!(found.causality.followers.iter().all(|follower| !follower.element.contains("gas")));
    let cycles = 4.0;
    let mut asked = SimulationRequest { audit: true, tolerance: 1e-8, ..found.request() };
    asked.duration = cycles * 2.0 * TAU / speed;
    asked.samples = 4 * 720;
    let run = found.simulate(&asked);
    assert!(run.complete, "{}", run.ended);
    let audit = run.audit.as_ref().expect("asked for");
    assert!(audit.whole < 1e-7, "the energy of the whole: {:e}", audit.whole);
    for residual in &audit.residuals {
        assert!(residual.error < 1e-11, "{residual:?}");
    }
    // Each cylinder's peak lies behind its own firing, a third of the cycle after that before it: 1, 3, 2.
    let theta = values(&run, "theta");
    let peak = |cylinder: usize| {
        let pressure = values(&run, &format!("mass{cylinder}.effort"));
        let last: Vec<usize> =
            (0..theta.len()).filter(|k| theta[*k] > theta[theta.len() - 1] - 2.0 * TAU).collect();
        let at = last.into_iter().max_by(|a, b| pressure[*a].total_cmp(&pressure[*b])).expect("samples");
        (theta[at].rem_euclid(2.0 * TAU).to_degrees(), pressure[at])
    };
    let peaks = [1, 3, 2].map(peak);
    for (place, (angle, pressure)) in peaks.iter().enumerate() {
        let behind = (angle - 240.0 * place as f64).rem_euclid(720.0);
        assert!((5.0..25.0).contains(&behind), "cylinder {place} peaks {behind} deg behind its firing");
        assert!((3e6..1.2e7).contains(pressure), "{pressure} Pa");
    }
    // What the bond into the gas carried is the area of its loop: over whole cycles the work that the piston got.
    let work: f64 = (1..=3)
        .map(|k| -audit.bonds.iter().find(|bond| bond.bond == format!("gas{k}.1")).expect("its bond").energy)
        .sum();
    let heat: f64 = (1..=3)
        .map(|k| {
            audit.elements.iter().find(|own| own.element == format!("combustion{k}")).expect("it burns").taken
        })
        .sum();
    let efficiency = work / -heat;
    assert!((0.25..0.55).contains(&efficiency), "indicated efficiency {efficiency}");
}

/// Largest first-order part of pitch and yaw of the block over the last revolution.
fn rocking(engine: &Engine) -> f64 {
    let speed = 209.0;
    let mut request = request(engine, speed);
    request.block = EngineBlock::Space;
    request.mounts = true;
    request.drive = EngineDrive::Imposed;
    let found = found(engine, &request);
    let turn = TAU / speed;
    let start = 66.0 * turn;
    let count = 96;
    let places: Vec<f64> = (1..=count).map(|k| start + turn * f64::from(k) / f64::from(count)).collect();
    let asked = SimulationRequest { duration: start + turn, tolerance: 1e-8, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    assert!(run.complete, "{}", run.ended);
    let first = |name: &str| {
        let values = &values(&run, name)[1..];
        let sum = values.iter().enumerate().fold([0.0; 2], |[c, s], (k, value)| {
            let (sin, cos) = (TAU * (k + 1) as f64 / f64::from(count)).sin_cos();
            [c + value * cos, s + value * sin]
        });
        sum[0].hypot(sum[1]) * 2.0 / f64::from(count)
    };
    first("wx.flow").hypot(first("wy.flow"))
}

/// Figures 3.26 and 3.27: the shaft at the printed phase leaves 2 sin 15 deg of the first-order pitch and yaw, opposite the peak nothing.
#[test]
fn lit_singh_rocking_without_and_with_the_balancer() {
    let with = |phase: Option<f64>| {
        let engine = engine().with(|engine| match phase {
            None => engine.shafts.clear(),
            Some(degrees) => {
                for (weight, more) in engine.shafts[0].weights.iter_mut().zip([0.0, 180.0]) {
                    weight.phase = (degrees + more).to_radians();
                }
            }
        });
        rocking(&engine.unwrap_or_else(|faults| panic!("{faults:?}")))
    };
    let without = with(None);
    let printed = with(Some(180.0)) / without;
    let opposite = with(Some(210.0)) / without;
    assert!((printed - 2.0 * 15f64.to_radians().sin()).abs() < 0.002, "printed phase leaves {printed}");
    assert!(opposite < 0.005, "opposite the peak {opposite} is left");
}

/// The graph of an engine stands in tiles: one for every cylinder, alike; no element upon another.
#[test]
fn an_engine_is_drawn_in_tiles() {
    let engine = engine();
    let mut request = request(&engine, 209.0);
    request.block = EngineBlock::Space;
    request.mounts = true;
    request.gravity = 9.81;
    request.gas_states = Some(GasStates::of(&engine).expect("a single zone"));
    let found = found(&engine, &request);
    let graph =
        Graph::new(&engine_graph(&engine, &request).expect("it has what it needs")).expect("units fit");
    let placed = lanchester_bondgraph::placed(&graph, &found.causality);
    for (index, element) in placed.elements.iter().enumerate() {
        for other in &placed.elements[..index] {
            let apart = (element.at[0] - other.at[0]).hypot(element.at[1] - other.at[1]);
            assert!(apart > 25.0, "{} lies upon {}", element.name, other.name);
        }
        assert!(element.at[0] <= placed.size[0] && element.at[1] <= placed.size[1], "{}", element.name);
    }
    // The same part of two cylinders is as far from the same other part.
    let at = |name: &str| placed.elements.iter().find(|own| own.name == name).expect("it is drawn").at;
    let apart = |k: usize| {
        let (a, b) = (at(&format!("piston{k}_motion")), at(&format!("gas{k}")));
        [b[0] - a[0], b[1] - a[1]]
    };
    assert_eq!(apart(1), apart(2));
    let svg = lanchester_bondgraph::drawing(&graph, &found.causality);
    for title in ["Block and crank", "Cylinder 3", "Mount 4", "Balance shaft 1", "Surroundings of the gas"] {
        assert!(svg.contains(title), "no tile {title}");
    }
}
