//! The engine as a bond graph against the multibody simulation, which shares nothing with it but the engine file: the same pressures, ten
//! revolutions, every quantity of the motion.

use lanchester::bondgraph::{
    Curve, EngineBlock, EngineLoad, EngineRequest, EngineStart, Equations, Graph, SimulationRequest, Unit,
    engine_graph, equations,
};
use lanchester::file::{read, template};
use lanchester::model::Engine;
use lanchester::multibody::{
    BlockMotion, BlockStart, GasPressure, Load, LoadLaw, Motion, ReactsOn, RotorInertia, Run, RunOutcome,
    Simulation, Train,
};
use lanchester::{BondGraphRequest, SimulateRequest, cylinder_gas, engine_bond_graph, simulate};
use std::f64::consts::{PI, TAU};

/// How far the two may differ, as a share of the largest value of their kind.
const AGREEMENT: f64 = 1e-8;

/// Tolerance of the steps of both: pieces of the pressure meet with jumps of their second derivative, which cost digits.
const STEPS: f64 = 1e-13;

/// One pressure for every cylinder.
pub(crate) struct Given(pub(crate) Curve);

impl GasPressure for Given {
    fn pressure(&self, _: usize, own: f64, _: f64) -> f64 {
        self.0.at(own, 0)
    }

    fn kinks(&self, _: usize) -> Vec<f64> {
        vec![0.0]
    }
}

/// Gauge pressure of a polytropic compression and a hotter expansion over two turns, as cubics: it jumps at the firing dead centre alone.
pub(crate) fn pressure() -> Curve {
    let volume = |angle: f64| 1.0 + 4.5 * (1.0 - angle.cos());
    let value = |angle: f64| -> [f64; 2] {
        let turn = angle - TAU;
        // From 0 on: expansion, two strokes of exchange, compression up to 4 pi.
        let p = |fired: f64, a: f64| 1e5 * fired * (10.0 / volume(a)).powf(1.3);
        let slope = |fired: f64, a: f64| -1.3 * p(fired, a) * 4.5 * a.sin() / volume(a);
        match angle {
            a if a < PI => [p(2.0, a), slope(2.0, a)],
            a if a < 3.0 * PI => {
                // A smooth fall from the end of the expansion to the start of the compression.
                let x = (a - PI) / TAU;
                let blend = x * x * (3.0 - 2.0 * x);
                let ends = [p(2.0, PI), p(1.0, PI)];
                [ends[0] + blend * (ends[1] - ends[0]), 6.0 * x * (1.0 - x) / TAU * (ends[1] - ends[0])]
            }
            _ => [p(1.0, turn), slope(1.0, turn)],
        }
    };
    let count = 5760;
    let step = 2.0 * TAU / f64::from(count);
    let pieces: Vec<(f64, [f64; 4])> = (0..count)
        .map(|k| {
            let start = step * f64::from(k);
            let ([a, b], [end, slope]) = (value(start), value(start + step * (1.0 - 1e-14)));
            let rise = (end - a) / step;
            let square = (3.0 * rise - 2.0 * b - slope) / step;
            let cube = (b + slope - 2.0 * rise) / (step * step);
            (start, [a - 1e5, b, square, cube])
        })
        .collect();
    let units = [Unit::NONE, Unit::of([-1, 1, -2, 0, 0])];
    Curve::cubics(&pieces, 2.0 * TAU, true, units).expect("pieces rise")
}

pub(crate) const BLOCK: &str = r#"
[block]
mass = "90 kg"
centre = ["60 mm", "8 mm", "15 mm"]
inertia = ["5 kg m2", "4.5 kg m2", "2.2 kg m2", "0.1 kg m2", "0.15 kg m2", "-0.2 kg m2"]
"#;

const MOUNTS: [[&str; 3]; 4] = [
    ["-90 mm", "220 mm", "-240 mm"],
    ["-90 mm", "-220 mm", "-250 mm"],
    ["-80 mm", "210 mm", "260 mm"],
    ["-90 mm", "-220 mm", "240 mm"],
];

pub(crate) fn mounts() -> String {
    let mount = |[x, y, z]: [&str; 3]| {
        format!(
            "[[mount]]\nx = \"{x}\"\ny = \"{y}\"\nz = \"{z}\"\ndirection = [1, 0.2, 0]\nsecond_direction = [-0.2, 1, 0]\n\
                 stiffness = [\"90 N/mm\", \"60 N/mm\", \
             \"50 N/mm\"]\ndamping = [\"300 N s/m\", \"250 N s/m\", \"200 N s/m\"]\n"
        )
    };
    MOUNTS.map(mount).concat()
}

fn engine(text: &str) -> Engine {
    let read = read(text);
    read.engine().unwrap_or_else(|| panic!("{:?}", read.diagnostics))
}

/// What is compared: the engine, its inertias, what acts.
struct Case {
    engine: Engine,
    inertia: RotorInertia,
    block: EngineBlock,
    fired: bool,
    load: f64,
    speed: f64,
    start: EngineStart,
    start_angle: f64,
    equilibrium: bool,
    piston_damping: f64,
    /// Dry, in proportion to the speed, to its square.
    friction: [f64; 3],
    gravity: f64,
}

impl Case {
    fn new(engine: Engine, block: EngineBlock) -> Case {
        let crankshafts = engine.crankshafts.iter().map(|_| Some(0.09)).collect();
        let shafts = engine.shafts.iter().map(|_| Some(0.0004)).collect();
        Case {
            inertia: RotorInertia { crankshafts, flywheel: 0.0, shafts },
            engine,
            block,
            fired: true,
            load: 12.0,
            speed: 150.0,
            start: EngineStart::default(),
            start_angle: 0.0,
            equilibrium: false,
            piston_damping: 4.0,
            friction: [0.0; 3],
            gravity: 9.80665,
        }
    }

    fn multibody(&self) -> Run {
        let train = Train::new(&self.engine, &self.inertia).expect("it turns");
        let simulation = Simulation {
            block: if self.block == EngineBlock::Fixed { BlockMotion::Fixed } else { BlockMotion::Mounts },
            block_start: match self.equilibrium {
                true => BlockStart::Equilibrium,
                false => BlockStart::Moving { velocity: self.start.velocity, spin: self.start.spin },
            },
            start_angle: self.start_angle,
            gravity: self.gravity,
            step: TAU / 12.0,
            tolerance: STEPS,
            piston_damping: self.piston_damping,
            friction_torque: self.friction[0],
            friction_growth: [self.friction[1], self.friction[2]],
            load: Load { law: LoadLaw::Constant(self.load), reacts_on: ReactsOn::Ground },
            ..Simulation::free(self.speed, 10.0)
        };
        let gas = Given(pressure());
        let gas = self.fired.then_some(&gas as &dyn GasPressure);
        let run = train.run(&simulation, gas).expect("it runs");
        assert_eq!(run.outcome, RunOutcome::Complete);
        run
    }

    fn graph(&self) -> Equations {
        let of = |list: &[Option<f64>]| list.iter().map(|inertia| inertia.unwrap_or(0.0)).collect();
        let count = self.engine.cylinders.len();
        let request = EngineRequest {
            block: self.block,
            mounts: true,
            start: self.start,
            start_angle: self.start_angle,
            equilibrium: self.equilibrium,
            gravity: self.gravity,
            crankshaft_inertia: of(&self.inertia.crankshafts),
            shaft_inertia: of(&self.inertia.shafts),
            pressures: if self.fired { vec![pressure(); count] } else { Vec::new() },
            piston_damping: self.piston_damping,
            friction_torque: self.friction[0],
            friction_growth: [self.friction[1], self.friction[2]],
            load: EngineLoad { torque: LoadLaw::Constant(self.load), reacts_on_block: false },
            ..EngineRequest::free(self.speed, 10.0)
        };
        let description = engine_graph(&self.engine, &request).expect("it has what it needs");
        let graph = Graph::new(&description).unwrap_or_else(|e| panic!("{e:?}"));
        equations(&graph).unwrap_or_else(|e| panic!("{e:?}"))
    }

    /// Largest differences by kind of quantity, over the largest value of the kind.
    fn differences(&self) -> Vec<(String, f64)> {
        let run = self.multibody();
        let samples = &run.samples;
        let found = self.graph();
        let request = SimulationRequest { duration: run.end[0], tolerance: STEPS, ..found.request() };
        let ours = found.simulate_at(&request, &samples.time[1..]);
        assert!(ours.complete, "{}", ours.ended);
        let pair = |name: &str, theirs: Vec<f64>| -> [Vec<f64>; 2] {
            [ours.values(name).unwrap_or_else(|| panic!("{name}")).to_vec(), theirs]
        };
        let mut kinds = vec![
            ("angle", vec![pair("theta", samples.theta.clone())]),
            ("speed", vec![pair("crank.flow", samples.speed.clone())]),
        ];
        if self.block != EngineBlock::Fixed {
            let all = [0, 1, 2].map(|k| samples.spin.iter().map(|spin| spin[k]).collect::<Vec<f64>>());
            let names = ["wx", "wy", "wz"];
            let first = if self.block == EngineBlock::Plane { 2 } else { 0 };
            let spins = (first..3).map(|k| pair(&format!("{}.flow", names[k]), all[k].clone()));
            kinds.push(("spin", spins.collect()));
            let mut springs = Vec::new();
            for (index, mount) in self.engine.mounts.iter().enumerate() {
                let axes = mount.spring.as_ref().expect("it has a spring").axes;
                let at = nalgebra::Vector3::new(mount.x, mount.y, mount.z);
                for (way, axis) in axes.iter().enumerate() {
                    if self.block == EngineBlock::Plane && axis[2] != 0.0 {
                        continue;
                    }
                    let moved = (0..samples.time.len()).map(|k| {
                        let motion = Motion {
                            position: samples.position[k].into(),
                            orientation: samples.orientation[k],
                            ..Motion::fixed(0.0, 0.0)
                        };
                        let moved = motion.position + motion.rotation() * at - at;
                        moved.dot(&nalgebra::Vector3::from(*axis))
                    });
                    springs.push(pair(
                        &format!("mount{}_{}_spring.displacement", index + 1, way + 1),
                        moved.collect(),
                    ));
                }
            }
            kinds.push(("mounts", springs));
        }
        kinds.into_iter().map(|(kind, pairs)| (kind.to_owned(), difference(&pairs))).collect()
    }

    fn check(&self) {
        for (kind, difference) in self.differences() {
            assert!(difference < AGREEMENT, "{}: {kind} differs by {difference:.3e}", self.engine.name);
        }
    }
}

/// Largest difference over the largest value of all pairs.
pub(crate) fn difference(pairs: &[[Vec<f64>; 2]]) -> f64 {
    let largest = pairs.iter().flat_map(|[_, theirs]| theirs).fold(0.0f64, |most, x| most.max(x.abs()));
    let mut off = 0.0f64;
    for [ours, theirs] in pairs {
        assert_eq!(ours.len(), theirs.len());
        for (a, b) in ours.iter().zip(theirs) {
            off = off.max((a - b).abs());
        }
    }
    off / largest
}

pub(crate) fn single(extra: &str) -> Engine {
    let text = format!(
        "name = \"single\"\nstrokes = 4\nspeed = \"2000 rpm\"\nfiring = {{ order = [1] }}\n[layout]\ntype = \"in-line\"\ncylinders = 1\n\
         [crank]\nstroke = \"85 mm\"\npin_mass = \"0.45 kg\"\n[piston]\nmass = \"0.36 kg\"\nbore = \"86 mm\"\npin_offset = \"1 mm\"\n\
         [rod]\nlength = \"150 mm\"\nbig_end_mass = \"0.34 kg\"\nsmall_end_mass = \"0.13 kg\"\ninertia = \"0.0021 kg m2\"\n{extra}"
    );
    engine(&text)
}

/// Largest difference of the gas as states, turned until it repeats, from the cycle that is computed without any mechanism, over the peak.
pub(crate) fn gas_states_off(engine: &Engine, turns: f64) -> f64 {
    let speed = engine.speed.highest;
    let cycles = cylinder_gas(engine, &[], speed).expect("a single zone");
    let request = BondGraphRequest {
        imposed: Some(true),
        block: Some(EngineBlock::Fixed),
        gas_as_states: true,
        ..BondGraphRequest::default()
    };
    let found = engine_bond_graph(engine, &[], &request).expect("it has what it needs");
    let graph = Graph::new(&found.description).unwrap_or_else(|e| panic!("{e:?}"));
    let found = equations(&graph).unwrap_or_else(|e| panic!("{e:?}"));
    let cycle = 2.0 * TAU / speed;
    let count = 240;
    let places: Vec<f64> = (1..=count).map(|k| cycle * (turns + f64::from(k) / f64::from(count))).collect();
    let asked = SimulationRequest { duration: (turns + 1.0) * cycle, tolerance: 1e-10, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    assert!(run.complete, "{}", run.ended);
    let mut off = 0.0f64;
    for index in 0..engine.cylinders.len() {
        let theirs = &cycles.cylinders[index].cylinder;
        let [_, (peak, _)] = theirs.extremes();
        let ours = run.values(&format!("mass{}.effort", index + 1)).expect("its pressure");
        let angle = run.values(&format!("psi{}", index + 1)).expect("its angle");
        for (pressure, psi) in ours.iter().zip(angle).skip(1) {
            off = off.max((pressure - theirs.at(*psi)).abs() / peak);
        }
    }
    off
}

#[test]
fn xcheck_gas_states_against_the_cycle() {
    let engine = engine(include_str!("../../../../examples/three-cylinder.toml"));
    let off = gas_states_off(&engine, 11.0);
    assert!(off < 1e-6, "{off:e}");
}

/// Heat to the walls by each law, fuel by the mixture: what the closed cylinder holds decides on heat release and Woschni's pressure.
#[test]
fn xcheck_gas_states_with_walls_against_the_cycle() {
    let text = include_str!("../../../../examples/single-gas.toml");
    for model in [
        "model = \"woschni\"",
        "model = \"hohenberg\"\nfactor = 1.3",
        "model = \"constant\"\ncoefficient = \"400 W/m2/K\"",
        "model = \"conductance\"\nconductance = \"1.2 W/K\"\nbody_capacity = \"36.8 kJ/K\"\nbody_to_ambient = \"9 W/K\"",
    ] {
        let mut text = text.replace("model = \"woschni\"", model);
        if model.contains("conductance") {
            // One body has one temperature.
            for key in ["piston_temperature", "head_temperature", "liner_temperature"] {
                text = text.lines().filter(|line| !line.starts_with(key)).collect::<Vec<_>>().join("\n");
            }
        }
        let off = gas_states_off(&engine(&text), 14.0);
        assert!(off < 1e-6, "{model}: {off:e}");
    }
}

/// Starter from a low speed, a load behind a driveline with a ratio, torque over the angle: all that the file's run may hold.
#[test]
fn xcheck_starter_driveline_and_load_against_the_simulation() {
    hold_run_under("type = \"quadratic\"\ntorque = \"60 N m\"\nat = \"1000 rpm\"\n");
    // Over angle and speed, within and beyond its speeds.
    let point = |speed: f64, angle: f64, torque: f64| {
        format!("{{ speed = \"{speed} rpm\", angle = \"{angle} deg\", torque = \"{torque} N m\" }},")
    };
    let points = [
        (300.0, 20.0, 5.0),
        (300.0, 200.0, 12.0),
        (450.0, 0.0, 9.0),
        (450.0, 90.0, 30.0),
        (450.0, 250.0, -4.0),
    ];
    let table: String = points.map(|(speed, angle, torque)| point(speed, angle, torque)).concat();
    hold_run_under(&format!("type = \"table\"\ntable = [{table}]\n"));
}

fn hold_run_under(load: &str) {
    let whole = include_str!("../../../../examples/three-cylinder.toml");
    let text = whole.split("[load]").next().expect("what comes before its load").to_owned()
        + r#"
[simulation]
start = { speed = "150 rpm", block = "as drawn" }
duration = "0.6 s"
gas = "off"
tolerance = 1e-12
torque = [{ order = 1.5, sin = "40 N m" }, { order = 0, cos = "25 N m" }]
[load]
reacts_on = "block"
LAW
[starter]
stall_torque = "30 N m"
free_speed = "4000 rpm"
ratio = 10
until = "280 rpm"
[[driveline]]
inertia = "0.4 kg m2"
stiffness = "900 N m/rad"
damping = "4 N m s/rad"
ratio = 1.5
[[driveline]]
inertia = "0.2 kg m2"
stiffness = "500 N m/rad"
damping = "2 N m s/rad"
"#;
    let file = read(&text.replace("LAW", load));
    let file = file.file.unwrap_or_else(|| panic!("{:?}", file.diagnostics));
    let theirs = simulate(&file, &[], &SimulateRequest::default()).expect("it runs").run;
    assert_eq!(theirs.outcome, RunOutcome::Complete);
    let input = file.tasks.simulation.as_deref().cloned().expect("it is given");
    let request = BondGraphRequest { simulation: input, ..BondGraphRequest::default() };
    let found = engine_bond_graph(&file.engine, &[], &request).expect("it has what it needs");
    let graph = Graph::new(&found.description).unwrap_or_else(|e| panic!("{e:#?}"));
    let found = equations(&graph).unwrap_or_else(|e| panic!("{e:#?}"));
    let samples = &theirs.samples;
    let asked = SimulationRequest { tolerance: 1e-12, ..found.request() };
    let ours = found.simulate_at(&asked, &samples.time[1..]);
    assert!(ours.complete, "{}", ours.ended);
    assert!(ours.events.iter().any(|event| event.on), "the starter lets go");
    let of = |name: &str| ours.values(name).unwrap_or_else(|| panic!("{name}")).to_vec();
    let link = |k: usize| samples.driveline.iter().map(|links| links[k][1]).collect::<Vec<f64>>();
    for (name, theirs) in [
        ("crank.flow", samples.speed.clone()),
        ("link1.flow", link(0)),
        ("link2.flow", link(1)),
        ("wz.flow", samples.spin.iter().map(|spin| spin[2]).collect()),
        ("wx.flow", samples.spin.iter().map(|spin| spin[0]).collect()),
    ] {
        let off = difference(&[[of(name), theirs]]);
        assert!(off < AGREEMENT, "{name} differs by {off:.3e}");
    }
}

#[test]
fn xcheck_single_in_a_fixed_block() {
    let mut case = Case::new(single(""), EngineBlock::Fixed);
    case.check();
    case.fired = false;
    case.load = 0.0;
    case.check();
}

/// Friction that follows the speed, over a speed that changes by more than a third.
#[test]
fn xcheck_friction_that_follows_the_speed() {
    let friction = [2.0, 0.03, 2e-4];
    for block in [EngineBlock::Fixed, EngineBlock::Space] {
        let engine = single(&(BLOCK.to_owned() + &mounts()));
        let case = Case { friction, load: 0.0, fired: false, ..Case::new(engine, block) };
        let run = case.multibody();
        let speeds = &run.samples.speed;
        let (first, last) = (speeds[0], speeds[speeds.len() - 1]);
        assert!(last < first / 1.3, "{first} {last}");
        case.check();
        // What the friction grows by is felt.
        let still = Case { friction: [2.0 + 0.03 * 150.0 + 2e-4 * 150.0 * 150.0, 0.0, 0.0], ..case };
        let other = still.multibody().samples.speed;
        assert!((other[other.len() - 1] - last).abs() > 1e-3 * first);
    }
}

/// Chen and Flynn's friction of a file: dry, linear and square parts are those that `simulate` uses.
#[test]
fn xcheck_friction_of_a_file() {
    let text = include_str!("../../../../examples/single-gas.toml").to_owned()
        + "[friction]\nconstant = \"0.4 bar\"\npeak_pressure = 0.005\nspeed = \"0.09 bar s/m\"\nspeed_squared = \"90 Pa s2/m2\"\n\
           [flywheel]\ninertia = \"0.15 kg m2\"\ncrankshaft_inertia = \"0.02 kg m2\"\n";
    let file = read(&text).file.expect("it is good");
    let speed = 90.0;
    let asked = SimulateRequest {
        speed: Some(speed),
        on_mounts: Some(false),
        load: Some(LoadLaw::Constant(20.0)),
        ..SimulateRequest::default()
    };
    let theirs = simulate(&file, &[], &asked).expect("it runs").run.samples;
    let request = BondGraphRequest {
        speed: Some(speed),
        block: Some(EngineBlock::Fixed),
        load: Some(LoadLaw::Constant(20.0)),
        ..BondGraphRequest::default()
    };
    let found = engine_bond_graph(&file.engine, &[], &request).expect("it has what it needs");
    assert!(found.notes.iter().any(|note| note.contains("it follows the speed")), "{:?}", found.notes);
    let found = equations(&Graph::new(&found.description).expect("units fit")).expect("no conflict");
    let ours = found.simulate(&found.request());
    assert!(ours.complete, "{}", ours.ended);
    // The parts of theirs from three of its samples.
    let last = theirs.speed.len() - 1;
    let rows = [0, last / 2, last].map(|k| {
        let w = theirs.speed[k];
        ([1.0, w, w * w], -theirs.friction_torque[k])
    });
    let matrix = nalgebra::Matrix3::from_fn(|i, k| rows[i].0[k]);
    let parts = matrix.lu().solve(&nalgebra::Vector3::from_fn(|i, _| rows[i].1)).expect("three speeds");
    let values = |name: &str| ours.values(name).unwrap_or_else(|| panic!("{name}"));
    let (speeds, efforts) = (values("crank.flow"), values("friction.effort"));
    let least = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let most = speeds.iter().copied().fold(0.0, f64::max);
    assert!(most > 1.05 * least, "{least} {most}");
    for (w, effort) in speeds.iter().zip(efforts) {
        let theirs = parts[0] + w * (parts[1] + w * parts[2]);
        assert!((effort - theirs).abs() < 1e-7 * theirs, "{w}: {effort} {theirs}");
    }
}

/// Everything symmetric about the plane of the cylinder: the block moves in it alone.
#[test]
fn xcheck_single_with_its_block_in_the_plane() {
    let mut text = String::from(
        "[block]\nmass = \"60 kg\"\ncentre = [\"50 mm\", \"8 mm\", \"0 mm\"]\ninertia = [\"2 kg m2\", \"2 kg m2\", \"1.4 kg m2\"]\n",
    );
    for (y, z) in [("200 mm", "150 mm"), ("-200 mm", "150 mm"), ("200 mm", "-150 mm"), ("-200 mm", "-150 mm")]
    {
        text += &format!(
            "[[mount]]\nx = \"-90 mm\"\ny = \"{y}\"\nz = \"{z}\"\ndirection = [1, 0.2, 0]\nsecond_direction = [-0.2, 1, 0]\n\
                 stiffness = [\"60 N/mm\", \"40 N/mm\", \
             \"40 N/mm\"]\ndamping = [\"200 N s/m\", \"150 N s/m\", \"150 N s/m\"]\n"
        );
    }
    Case::new(single(&text), EngineBlock::Plane).check();
}

#[test]
fn xcheck_single_with_its_block_in_space() {
    let mut case = Case::new(single(&(BLOCK.to_owned() + &mounts())), EngineBlock::Space);
    case.start.spin = [0.05, -0.03, 0.04];
    case.start.velocity = [0.01, 0.02, -0.03];
    case.check();
    // A rod so thick that its turn about its own line is felt.
    let slender = case.differences();
    let thick = case.engine.with(|engine| engine.cylinders[0].rod.axial_inertia = 0.0015);
    case.engine = thick.unwrap_or_else(|faults| panic!("{faults:?}"));
    case.check();
    assert_eq!(slender.len(), case.differences().len());
}

/// The block at rest where the mounts carry the weight and the reaction to the load: found by both on their own, at an angle where pistons and
/// unbalances stand askew.
#[test]
fn xcheck_start_in_equilibrium() {
    for name in ["v2-90", "in-line-3-shaft", "radial-5"] {
        let case = of_gallery(name, EngineBlock::Space);
        let engine = case.engine.with(|engine| {
            if let Some(block) = &mut engine.block {
                block.mass *= 4.0;
                block.inertia = block.inertia.map(|inertia| 4.0 * inertia);
            }
        });
        let engine = engine.unwrap_or_else(|faults| panic!("{faults:?}"));
        let load = 4.0 * engine.cylinders.len() as f64;
        let mut case = Case { engine, load, start_angle: 0.8, equilibrium: true, ..case };
        case.check();
        // What differs from a start as drawn is more than the two may differ by.
        let settled = case.multibody();
        case.equilibrium = false;
        let drawn = case.multibody();
        assert!((settled.samples.position[0][0] - drawn.samples.position[0][0]).abs() > 1e-4);
    }
}

/// An engine of the gallery on mounts, with firings and bores of its own.
fn of_gallery(name: &str, block: EngineBlock) -> Case {
    let mut engine = engine(template(name).expect("it is in the gallery").text);
    let count = engine.cylinders.len();
    engine = engine
        .with(|engine| {
            for (index, cylinder) in engine.cylinders.iter_mut().enumerate() {
                cylinder.bore = Some(0.07 + 0.001 * index as f64);
                if cylinder.firing_angle.is_none() {
                    cylinder.firing_angle = Some(2.0 * TAU * index as f64 / count as f64);
                }
            }
        })
        .unwrap();
    let donor = single(&(BLOCK.to_owned() + &mounts()));
    engine = engine
        .with(|engine| {
            engine.block.clone_from(&donor.block);

            engine.mounts.clone_from(&donor.mounts);
        })
        .unwrap();
    Case { load: 40.0, ..Case::new(engine, block) }
}

/// Every layout of the gallery, its block in space: all shafts, vees, articulated rods, geared crankshafts, shared chambers.
#[test]
fn xcheck_every_engine_of_the_gallery_in_space() {
    for template in lanchester::file::templates() {
        let case = of_gallery(template.name, EngineBlock::Space);
        // A block that even the parts of a radial engine leave an inertia.
        let engine = case.engine.with(|engine| {
            if let Some(block) = &mut engine.block {
                block.mass *= 4.0;
                block.inertia = block.inertia.map(|inertia| 4.0 * inertia);
            }
        });
        let engine = engine.unwrap_or_else(|faults| panic!("{faults:?}"));
        Case { load: 4.0 * engine.cylinders.len() as f64, engine, ..case }.check();
    }
}

#[test]
fn xcheck_radial_in_a_fixed_block() {
    of_gallery("radial-5", EngineBlock::Fixed).check();
}

/// Every layout of the gallery, its block fixed: all shafts, articulated rods, geared crankshafts, shared chambers.
#[test]
fn xcheck_every_engine_of_the_gallery() {
    for template in lanchester::file::templates() {
        let case = of_gallery(template.name, EngineBlock::Fixed);
        // A fixed block needs no numbers, and a load that every engine can take.
        let engine = case.engine.with(|engine| {
            engine.block = None;
            engine.mounts.clear();
        });
        let engine = engine.unwrap_or_else(|faults| panic!("{faults:?}"));
        Case { load: 4.0 * engine.cylinders.len() as f64, engine, ..case }.check();
    }
}
