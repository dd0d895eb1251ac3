//! The three-cylinder engine of the bond-graph thesis (Singh 2017, chapter 3), with the inputs that it leaves open chosen as in
//! `examples/three-cylinder.toml`: its gas as states, and its rocking without and with the balancer shaft.

use lanchester_bondgraph::{
    EngineBlock, EngineDrive, EngineLoad, EngineRequest, Equations, GasStates, GasWalls, Graph, LoadLaw,
    Simulation, SimulationRequest, engine_graph, equations,
};
use lanchester_file::read;
use lanchester_model::Engine;
use num_complex::Complex64;
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
        start: 300.0,
    });
    request.gas_states = Some(gas);
    request.piston_damping = 20.0;
    // A quadratic load that takes 190 N m at 2000 rpm.
    request.load =
        EngineLoad { torque: LoadLaw::Quadratic { torque: 190.0, at: speed }, reacts_on_block: false };
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
    // Figure 3.24: the same by the trapezium rule over the samples, half a degree apart at most.
    let area: f64 = (1..=3)
        .map(|k| {
            let (p, v) = (values(&run, &format!("mass{k}.effort")), values(&run, &format!("volume{k}")));
            (1..p.len()).map(|i| 0.5 * (p[i] + p[i - 1]) * (v[i] - v[i - 1])).sum::<f64>()
        })
        .sum();
    assert!((area - work).abs() < 1e-4 * work, "loops of {area} J, {work} J at the pistons");
}

/// Amplitude of an order of a quantity over its last `turns` whole turns of the crank; samples are dense.
fn order_of(theta: &[f64], values: &[f64], order: f64, turns: f64) -> f64 {
    let end = theta[theta.len() - 1];
    let first = theta.iter().rposition(|at| end - at >= turns * TAU - 1e-6).expect("it turns so far");
    // The window is a whole number of turns but for a part of a sample: the mean would leak into every order.
    let mean = values[first..].iter().sum::<f64>() / (values.len() - first) as f64;
    let (mut cosine, mut sine) = (0.0, 0.0);
    for at in first + 1..theta.len() {
        let step = theta[at] - theta[at - 1];
        for k in [at - 1, at] {
            let (sin, cos) = (order * theta[k]).sin_cos();
            cosine += 0.5 * step * (values[k] - mean) * cos;
            sine += 0.5 * step * (values[k] - mean) * sin;
        }
    }
    2.0 * f64::hypot(cosine, sine) / (end - theta[first])
}

/// Figures 3.25 and 4.14: the speed settles where the load takes the mean torque of the engine, and its ripple repeats with the firings, every 240
/// and 180 deg. A lighter flywheel than Table 3.9's settles ten times as fast.
#[test]
fn lit_singh_speed_settles_and_ripples_with_the_firings() {
    let four =
        read(include_str!("../../../../validation/three-four-cylinder-thesis/four-cylinder-simulated.toml"));
    for (engine, firing) in [(engine(), 1.5), (four.engine().expect("it has no mistakes"), 2.0)] {
        let speed = TAU * 2000.0 / 60.0;
        let mut request = request(&engine, speed);
        request.crankshaft_inertia = vec![0.3];
        request.gas_states = Some(GasStates::of(&engine).expect("a single zone"));
        request.piston_damping = 20.0;
        request.load =
            EngineLoad { torque: LoadLaw::Quadratic { torque: 190.0, at: speed }, reacts_on_block: false };
        let found = found(&engine, &request);
        let cycle = 2.0 * TAU / speed;
        let settled = 30.0 * cycle;
        let places: Vec<f64> = (1..=2160).map(|k| settled + 1.5 * cycle * f64::from(k) / 2160.0).collect();
        let asked = SimulationRequest { duration: settled + 1.5 * cycle, tolerance: 1e-7, ..found.request() };
        let run = found.simulate_at(&asked, &places);
        assert!(run.complete, "{}", run.ended);
        let without_start = |name: &str| values(&run, name)[1..].to_vec();
        let (theta, speeds) = (without_start("theta"), without_start("crank.flow"));
        let mean = |values: &[f64]| {
            let end = theta[theta.len() - 1];
            let first = theta.iter().rposition(|at| end - at >= 2.0 * TAU - 1e-6).expect("a cycle");
            let sum: f64 = (first + 1..theta.len())
                .map(|k| 0.5 * (theta[k] - theta[k - 1]) * (values[k] + values[k - 1]))
                .sum();
            sum / (end - theta[first])
        };
        let count = engine.cylinders.len();
        let slides: Vec<Vec<f64>> =
            (1..=count).map(|k| without_start(&format!("slide{k}.1.effort"))).collect();
        let torque: Vec<f64> =
            (0..theta.len()).map(|at| -slides.iter().map(|own| own[at]).sum::<f64>()).collect();
        let load = without_start("load.effort");
        let (given, taken) = (mean(&torque), mean(&load));
        assert!(taken > 50.0 && (given - taken).abs() < 2e-3 * taken, "{given} N m given, {taken} N m taken");
        // Orders of the firing and its multiples alone.
        let ripple = order_of(&theta, &speeds, firing, 2.0);
        assert!(ripple > 1e-3 * mean(&speeds), "{ripple} rad/s");
        for half in 1..=8 {
            let order = 0.5 * f64::from(half);
            if (order / firing).fract() != 0.0 {
                let other = order_of(&theta, &speeds, order, 2.0);
                assert!(other < 0.01 * ripple, "order {order}: {other} rad/s beside {ripple} rad/s");
            }
        }
    }
}

/// Samples of the last revolution.
const SAMPLES: usize = 96;

/// The rocking of the block over one revolution.
struct Rocking {
    /// First and second order of pitch and yaw [rad/s].
    orders: [f64; 2],
    /// Third order of the roll about the crank [rad/s].
    roll: Complex64,
    /// Third order of the moment that the rocking gives the roll [N m].
    given: Complex64,
}

/// Order `n` of samples over one revolution, equally spaced in time: the factor of `exp(i n angle)`.
fn part(angles: &[f64], values: &[f64], order: f64) -> Complex64 {
    let turned =
        values.iter().zip(angles).map(|(value, angle)| Complex64::from_polar(*value, -order * angle));
    turned.sum::<Complex64>() * 2.0 / values.len() as f64
}

/// The moment about the crank that pitch and yaw bring about. Each of the masses m of pistons, rods and unbalances at r = (x, y, z), which moves by
/// r' = (x', y', 0) a radian, has the acceleration w' x r + w x (w x r) + 2 w x r' beside the one that it has in a block that stands. It acts on the
/// block by its moment, and on the drive, whose torque comes from the ground and goes through the crank into the block, by its power:
///
/// ```text
/// M = SUM m ( z (x wx' + y wy') + z (x' wy' - y' wx')
///             + (x' wx + y' wy - x wy + y wx)(x wx + y wy) - (x x' + y y')(wx^2 + wy^2) )
/// ```
///
/// The Coriolis terms cancel in it. Its third order comes from the first order of the rocking with the second of the places of the pistons, and the other
/// way round: none of it is there where nothing rocks with the first order.
fn given(engine: &Engine, speed: f64, theta: &[f64], [wx, wy]: [&[f64]; 2]) -> Vec<f64> {
    let count = wx.len();
    let phase: Vec<f64> = (1..=count).map(|k| TAU * k as f64 / count as f64).collect();
    // Rates by the orders of the motion over time.
    let rate = |values: &[f64]| -> Vec<f64> {
        let parts: Vec<Complex64> = (1..24).map(|n| part(&phase, values, f64::from(n))).collect();
        let at = |angle: &f64| {
            let terms = parts.iter().enumerate().map(|(n, part)| {
                let n = (n + 1) as f64;
                (Complex64::i() * n * speed * part * Complex64::from_polar(1.0, n * angle)).re
            });
            terms.sum()
        };
        phase.iter().map(at).collect()
    };
    let (fast_x, fast_y) = (rate(wx), rate(wy));
    (0..count)
        .map(|k| {
            let theta = theta[k];
            let mut masses: Vec<[f64; 6]> = Vec::new();
            for cylinder in &engine.cylinders {
                let throw = &engine.throws[cylinder.throw];
                let (sin, cos) = (theta + throw.angle).sin_cos();
                let (r, rod) = (throw.radius, &cylinder.rod);
                let along = (rod.length.powi(2) - (r * sin).powi(2)).sqrt();
                let (s, rate) = (r * cos + along, -r * sin - r * r * sin * cos / along);
                masses.push([cylinder.piston_mass + rod.small_end_mass, s, 0.0, cylinder.z, rate, 0.0]);
                masses.push([rod.big_end_mass, r * cos, r * sin, throw.z, -r * sin, r * cos]);
            }
            let mut moment = 0.0;
            let (a, b) = (wx[k], wy[k]);
            for [m, x, y, z, dx, dy] in masses {
                moment += m * z * (x * fast_x[k] + y * fast_y[k] + dx * fast_y[k] - dy * fast_x[k]);
                moment += m * (dx * a + dy * b - x * b + y * a) * (x * a + y * b);
                moment -= m * (x * dx + y * dy) * (a * a + b * b);
            }
            let crank =
                engine.throws.iter().map(|throw| (throw.z, 1.0, theta + throw.angle, throw.unbalance));
            let weights = (engine.counterweights.iter())
                .map(|weight| (weight.z, 1.0, theta + weight.angle, weight.unbalance));
            let shafts = engine.shafts.iter().flat_map(|shaft| {
                let ratio = shaft.ratio.value();
                let own = move |phase: f64| ratio * theta + phase;
                shaft.weights.iter().map(move |weight| (weight.z, ratio, own(weight.phase), weight.unbalance))
            });
            for (z, ratio, angle, unbalance) in crank.chain(weights).chain(shafts) {
                let (sin, cos) = angle.sin_cos();
                moment += unbalance * z * (cos * fast_x[k] + sin * fast_y[k]);
                moment -= unbalance * z * ratio * (sin * fast_y[k] + cos * fast_x[k]);
            }
            moment
        })
        .collect()
}

fn rocking(engine: &Engine) -> Rocking {
    let speed = 209.0;
    let mut request = request(engine, speed);
    request.block = EngineBlock::Space;
    request.mounts = true;
    request.drive = EngineDrive::Imposed;
    // A torque between block and crank would not roll the block: pistons and rods here have no angular momentum about the crank.
    request.against_ground = true;
    let found = found(engine, &request);
    let turn = TAU / speed;
    let start = 66.0 * turn;
    let places: Vec<f64> = (1..=SAMPLES).map(|k| start + turn * k as f64 / SAMPLES as f64).collect();
    let asked = SimulationRequest { duration: start + turn, tolerance: 1e-9, ..found.request() };
    let run = found.simulate_at(&asked, &places);
    assert!(run.complete, "{}", run.ended);
    let [wx, wy, wz] = ["wx.flow", "wy.flow", "wz.flow"].map(|name| &values(&run, name)[1..]);
    // The crank angle against the block, which has rolled a little: the third order would turn by three times that.
    let theta = &values(&run, "theta")[1..];
    let both = |order: f64| part(theta, wx, order).norm().hypot(part(theta, wy, order).norm());
    Rocking {
        orders: [both(1.0), both(2.0)],
        roll: part(theta, wz, 3.0),
        given: part(theta, &given(engine, speed, theta, [wx, wy]), 3.0),
    }
}

/// Moment over angular velocity of the roll at an angular frequency: mounts, block and what moves in it, at its mean places; the crank is driven from the
/// ground and does not follow. The centre of mass lies beside the crank, and moves freely so far above the natural frequencies.
fn roll_impedance(engine: &Engine, frequency: f64) -> Complex64 {
    let block = engine.block.as_ref().expect("it has one");
    let wheel = engine.flywheel.as_ref().expect("it has one");
    let rotors = wheel.inertia.unwrap_or(0.0) + wheel.crankshaft_inertia.unwrap_or(0.0);
    let (mut inertia, mut mass, mut first) = (block.inertia[2] - rotors, block.mass, 0.0);
    for cylinder in &engine.cylinders {
        let (r, rod) = (engine.throws[cylinder.throw].radius, &cylinder.rod);
        let moving = cylinder.piston_mass + rod.small_end_mass;
        let count = 720;
        for k in 0..count {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(count)).sin_cos();
            let s = r * cos + (rod.length.powi(2) - (r * sin).powi(2)).sqrt();
            inertia += moving * s * s / f64::from(count);
            first += moving * s / f64::from(count);
        }
        inertia += rod.big_end_mass * r * r;
        mass += moving + rod.big_end_mass;
    }
    inertia -= first * first / mass;
    let [mut stiffness, mut damping] = [0.0; 2];
    for mount in &engine.mounts {
        let spring = mount.spring.as_ref().expect("it has stiffness");
        stiffness += spring.stiffness[0] * mount.y * mount.y;
        damping += spring.damping[0] * mount.y * mount.y;
    }
    Complex64::new(damping, inertia * frequency - stiffness / frequency)
}

/// Figures 3.26 and 3.27: the shaft at the printed phase leaves 2 sin 15 deg of the first-order pitch and yaw, opposite the peak nothing. The
/// second-order couple stays, which the thesis does not say, and the roll about the crank is untouched by any balancer: what it changes by is what the
/// rocking itself gives it.
#[test]
fn lit_singh_rocking_without_and_with_the_balancer() {
    let base = engine();
    let with = |phase: Option<f64>| {
        let engine = base.with(|engine| match phase {
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
    let (at_printed, at_opposite) = (with(Some(180.0)), with(Some(210.0)));
    let printed = at_printed.orders[0] / without.orders[0];
    let opposite = at_opposite.orders[0] / without.orders[0];
    assert!(without.orders[1] > 0.01 * without.orders[0], "the second-order couple rocks too");
    let impedance = roll_impedance(&base, 3.0 * 209.0);
    for own in [at_printed, at_opposite] {
        let second = (own.orders[1] / without.orders[1] - 1.0).abs();
        let change = own.roll - without.roll;
        let explained = (own.given - without.given) / impedance;
        let size = without.roll.norm();
        assert!(second < 1e-2, "the second order stays: {second}");
        let left = (change - explained).norm() / size;
        println!("roll: {:.3e} changed, {left:.3e} unexplained", change.norm() / size);
        assert!(
            left < 2e-5,
            "the roll stays but for what the rocking gives it: {change}, {explained} of {size}"
        );
    }
    assert!((printed - 2.0 * 15f64.to_radians().sin()).abs() < 0.002, "printed phase leaves {printed}");
    assert!(opposite < 0.005, "opposite the peak {opposite} is left");
}

/// Orders of what holds a block still, over one revolution: forces of the sources along x and y.
fn held(engine: &Engine, speed: f64, names: &[&str], order: f64) -> Vec<[f64; 2]> {
    let request = EngineRequest {
        drive: EngineDrive::Imposed,
        block: EngineBlock::Held,
        samples: 144,
        tolerance: 1e-10,
        ..EngineRequest::free(speed, 1.0)
    };
    let found = found(engine, &request);
    let run = found.simulate(&found.request());
    assert!(run.complete, "{}", run.ended);
    let part = |name: &&str| {
        // A force on the block is the opposite of what holds or moves the part.
        let values = &values(&run, &format!("{name}.effort"))[1..];
        let sum = values.iter().enumerate().fold([0.0; 2], |[c, s], (k, value)| {
            let (sin, cos) = (order * TAU * (k + 1) as f64 / 144.0).sin_cos();
            [c - value * cos / 72.0, s - value * sin / 72.0]
        });
        [sum[0], sum[1]]
    };
    names.iter().map(part).collect()
}

/// Figures 4.15 and 4.16 with Table 4.3, at 20.72 rad/s: the second order of the pistons, the forces of both shafts, what is left.
#[test]
fn lit_singh_secondary_forces_and_those_of_the_shafts() {
    let text = include_str!("../../../../validation/three-four-cylinder-thesis/four-cylinder.toml");
    let engine = read(text).engine().expect("it has no mistakes");
    let (speed, mass, r, l) = (20.72, 2.0, 0.06f64, 0.2);
    // 4 m r^2/l w^2, and the second order of the exact slider crank: 4 m r w^2 (q + q^3/4 + 15 q^5/128 + 35 q^7/512 + ...), q = r/l.
    let (series, q) = (4.0 * mass * r * r / l * speed * speed, r / l);
    let exact = 4.0
        * mass
        * r
        * speed
        * speed
        * (q + q.powi(3) / 4.0 + 15.0 * q.powi(5) / 128.0 + 35.0 * q.powi(7) / 512.0);
    assert!((series - 61.82).abs() < 0.01 && (exact - 63.27).abs() < 0.01, "{series} N, {exact} N");
    let bare = engine.without_shafts();
    let [cosine, sine] = held(&bare, speed, &["hold_vx"], 2.0)[0];
    // Terms from q^9 on are left out: less than a hundred-thousandth.
    assert!((cosine - exact).abs() < 1e-5 * exact && sine.abs() < 1e-9 * exact, "{cosine} N, {sine} N");
    // Both shafts: 0.018 kg m each at twice the speed; vertical parts cancel, horizontal ones add up against the pistons.
    let names = ["shaft1_unbalance1.1", "shaft2_unbalance1.1", "shaft1_unbalance1.2", "shaft2_unbalance1.2"];
    let [x1, x2, y1, y2] = held(&engine, speed, &names, 2.0)[..] else { panic!("four forces") };
    for x in [x1, x2] {
        assert!((x[0] + 0.5 * series).abs() < 1e-3 * series && x[1].abs() < 1e-9 * series, "{x:?}");
    }
    assert!((y1[1].abs() - 0.5 * series).abs() < 1e-3 * series, "{y1:?}");
    assert!((y1[0] + y2[0]).abs().max((y1[1] + y2[1]).abs()) < 1e-10 * series, "{y1:?} {y2:?}");
    let left = held(&engine, speed, &["hold_vx", "hold_vy"], 2.0);
    assert!((left[0][0] - (exact - series)).abs() < 2e-3 * series, "{left:?}, {} N", exact - series);
    assert!(left[1][0].hypot(left[1][1]) < 1e-10 * series, "{left:?}");
    // Order 4, which no shaft of twice the speed touches: 4 m r w^2 (q^3/4 + 3 q^5/16 + ...).
    let fourth = held(&engine, speed, &["hold_vx"], 4.0)[0];
    let want = 4.0 * mass * r * speed * speed * (q.powi(3) / 4.0 + 3.0 * q.powi(5) / 16.0);
    assert!((fourth[0].abs() - want).abs() < 0.02 * want, "{fourth:?}, {want} N");
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
