//! Engines and loads for tests: the loads in closed form from the first, second and fourth order of the slider-crank
//! (twin thesis, equations for A2 and A4), so that every number of a picture can be checked by hand.

use lanchester_mechanism::*;
use lanchester_model::*;
use lanchester_results::{Extreme, Extremes, LoadSet, OrderLoads, Peaks, Trace};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// An engine of plain cylinders: (throw angle, axis angle) in degrees, 100 mm apart, all equal.
pub fn engine(cylinders: &[(f64, f64)]) -> Engine {
    let count = cylinders.len();
    let z = |k: usize| 0.1 * (k as f64 - 0.5 * (count as f64 - 1.0));
    let throw = |k: usize| Throw {
        crankshaft: 0,
        angle: cylinders[k].0.to_radians(),
        z: z(k),
        radius: 0.04775,
        unbalance: 0.01,
        unbalance_offset: 0.0,
        webs: Some([z(k) - 0.022, z(k) + 0.022]),
    };
    let cylinder = |k: usize| Cylinder {
        throw: k,
        angle: cylinders[k].1.to_radians(),
        z: z(k),
        offset: 0.0,
        pin_offset: 0.0,
        bore: Some(0.0795),
        piston_mass: 0.7754,
        rod: Rod {
            length: 0.144,
            big_end_mass: 0.4191,
            small_end_mass: 0.2096,
            inertia: None,
            axial_inertia: 0.0,
            mass_rule: RodMassRule::Thirds,
            joint: RodJoint::Crankpin,
        },
        firing_angle: Some((cylinders[k].1 - cylinders[k].0).to_radians().rem_euclid(TAU)),
        chamber: None,
    };
    Engine::new(EngineParts {
        name: format!("Sample of {count}"),
        strokes: Strokes::Four,
        rotation: Rotation::Clockwise,
        speed: SpeedRange { lowest: 418.879, highest: 418.879 },
        crankshafts: vec![Crankshaft {
            name: "crankshaft".into(),
            ratio: Ratio::ONE,
            phase: 0.0,
            x: 0.0,
            y: 0.0,
            mains: None,
        }],
        throws: (0..count).map(throw).collect(),
        cylinders: (0..count).map(cylinder).collect(),
        counterweights: (0..count)
            .map(|k| Counterweight {
                name: format!("throw {}", k + 1),
                crankshaft: 0,
                z: z(k),
                unbalance: 0.030,
                angle: cylinders[k].0.to_radians() + 0.5 * TAU,
                part: None,
            })
            .collect(),
        ..EngineParts::default()
    })
    .expect("the parts of an engine")
}

/// The twin with pistons in step and a counter-rotating first-order shaft.
pub fn twin() -> Engine {
    let mut engine = engine(&[(0.0, 0.0), (0.0, 0.0)])
        .with(|parts| parts.name = "In-line twin".to_owned())
        .expect("an engine");
    engine = engine
        .with(|engine| {
            engine.shafts.push(BalanceShaft {
                name: "shaft 1".to_owned(),
                ratio: Ratio::whole(-1).unwrap(),
                x: 0.0,
                y: 0.1,
                weights: vec![ShaftWeight::new(0.0, 0.047, 0.5 * TAU)],
                inertia: None,
            });

            engine.mounts = vec![
                Mount { name: "left".to_owned(), x: -0.05, y: -0.2, z: 0.0, spring: None },
                Mount { name: "right".to_owned(), x: -0.05, y: 0.2, z: 0.0, spring: None },
            ];
        })
        .expect("an engine");
    engine
}

/// Force orders of one source: (order, forward, backward).
type Source = (Part, Option<usize>, f64, Vec<(f64, Complex64, Complex64)>);

/// Loads of such an engine.
pub fn loads(engine: &Engine) -> Loads {
    let speed = engine.speed.highest;
    let square = speed * speed;
    let mut sources: Vec<Source> = Vec::new();
    for (k, cylinder) in engine.cylinders.iter().enumerate() {
        let throw = &engine.throws[cylinder.throw];
        let ratio = engine.crankshafts[throw.crankshaft].ratio.value();
        let l = throw.radius / cylinder.rod.length;
        let (a2, a4) =
            (l + l.powi(3) / 4.0 + 15.0 * l.powi(5) / 128.0, -l.powi(3) / 4.0 - 3.0 * l.powi(5) / 16.0);
        let (a, b) = (throw.angle, cylinder.angle);
        let half = 0.5 * cylinder.reciprocating_mass() * throw.radius * square * ratio * ratio;
        let orders = [(1.0, 1.0), (2.0, a2), (4.0, a4)].map(|(n, c)| {
            let forward = Complex64::from_polar(half * c, n * (a - b) + b);
            let backward = Complex64::from_polar(half * c, -n * (a - b) + b);
            (n * ratio.abs(), forward, backward)
        });
        sources.push((Part::Reciprocating, Some(k), cylinder.z, orders.to_vec()));
        let unbalance = throw.unbalance + engine.rod_unbalance(cylinder.throw);
        let rotating = Complex64::from_polar(unbalance * square * ratio * ratio, a);
        sources.push((Part::Rotating, Some(k), throw.z, vec![(ratio.abs(), rotating, Complex64::default())]));
    }
    for weight in &engine.counterweights {
        let force = Complex64::from_polar(weight.unbalance * square, weight.angle);
        sources.push((Part::Counterweights, None, weight.z, vec![(1.0, force, Complex64::default())]));
    }
    for shaft in &engine.shafts {
        for weight in &shaft.weights {
            let n = shaft.ratio.value();
            let force = Complex64::from_polar(weight.unbalance * square * n * n, weight.phase);
            let zero = Complex64::default();
            let (forward, backward) = if n > 0.0 { (force, zero) } else { (zero, force) };
            sources.push((Part::Shafts, None, weight.z, vec![(n.abs(), forward, backward)]));
        }
    }
    let pick = |keep: &dyn Fn(&Source) -> bool| set(sources.iter().filter(|s| keep(s)));
    let parts = Part::ALL.into_iter().filter(|part| sources.iter().any(|s| s.0 == *part));
    Loads {
        version: RESULT_VERSION,
        engine: engine.name.clone(),
        speed,
        reference: [0.0; 3],
        kinematics: "series to order 4".to_owned(),
        period: TAU,
        total: pick(&|_| true),
        parts: parts.map(|part| PartLoads { part, loads: pick(&|s| s.0 == part) }).collect(),
        cylinders: (0..engine.cylinders.len())
            .map(|k| CylinderLoads { cylinder: k + 1, loads: pick(&|s| s.1 == Some(k)) })
            .collect(),
        motion: engine.cylinders.iter().enumerate().map(|(k, c)| motion(engine, k, c)).collect(),
        diagnosis: Diagnosis {
            findings: Vec::new(),
            summary: "The second order remains: a pair of shafts at twice the crank's speed can remove it."
                .to_owned(),
            roll: String::new(),
        },
    }
}

fn motion(engine: &Engine, index: usize, cylinder: &Cylinder) -> CylinderMotion {
    let throw = &engine.throws[cylinder.throw];
    let top = (cylinder.angle - throw.angle).rem_euclid(TAU);
    CylinderMotion {
        cylinder: index + 1,
        top_dead_centre: top,
        bottom_dead_centre: (top + 0.5 * TAU).rem_euclid(TAU),
        stroke: 2.0 * throw.radius,
        top: throw.radius + cylinder.rod.length,
        max_speed: 21.08,
        max_acceleration: 6022.0,
        max_deceleration: 11156.0,
        max_rod_angle: (throw.radius / cylinder.rod.length).asin(),
        firing_angle: cylinder.firing_angle,
        residual_inertia: cylinder.rod.residual_inertia(),
        chamber: None,
        articulation: None,
        trace: MotionTrace::default(),
    }
}

fn set<'a>(sources: impl Iterator<Item = &'a Source>) -> LoadSet {
    let mut orders: Vec<OrderLoads> = Vec::new();
    let zero = Complex64::default();
    for (_, _, z, list) in sources {
        for &(n, forward, backward) in list {
            let at = orders.iter().position(|o| (o.order - n).abs() < 1e-9).unwrap_or_else(|| {
                orders.push(OrderLoads {
                    order: n,
                    force_forward: zero,
                    force_backward: zero,
                    couple_forward: zero,
                    couple_backward: zero,
                    roll_moment: zero,
                    shaft_torque: zero,
                });
                orders.len() - 1
            });
            let lever = Complex64::new(0.0, *z);
            orders[at].force_forward += forward;
            orders[at].force_backward += backward;
            orders[at].couple_forward += lever * forward;
            orders[at].couple_backward += lever * backward;
            orders[at].roll_moment += 0.02 * backward;
            orders[at].shaft_torque -= 0.02 * backward;
        }
    }
    orders.sort_by(|a, b| a.order.total_cmp(&b.order));
    let mut trace = Trace::default();
    for k in 0..720 {
        let theta = TAU * k as f64 / 720.0;
        let sum = |f: &dyn Fn(&OrderLoads) -> (Complex64, Complex64)| -> Complex64 {
            let turn = |o: &OrderLoads| Complex64::from_polar(1.0, o.order * theta);
            orders.iter().map(|o| f(o).0 * turn(o) + f(o).1 * turn(o).conj()).sum()
        };
        let force = sum(&|o| (o.force_forward, o.force_backward));
        let couple = sum(&|o| (o.couple_forward, o.couple_backward));
        trace.theta.push(theta);
        trace.force_x.push(force.re);
        trace.force_y.push(force.im);
        trace.couple_x.push(couple.re);
        trace.couple_y.push(couple.im);
        trace.roll_moment.push(sum(&|o| (o.roll_moment, zero)).re);
        trace.shaft_torque.push(sum(&|o| (o.shaft_torque, zero)).re);
    }
    let modulus = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect::<Vec<_>>();
    let extremes = |values: &[f64]| {
        let mut out = Extremes::default();
        for (k, &value) in values.iter().enumerate() {
            let theta = TAU * k as f64 / 720.0;
            if k == 0 || value > out.max.value {
                out.max = Extreme { value, theta };
            }
            if k == 0 || value < out.min.value {
                out.min = Extreme { value, theta };
            }
        }
        out
    };
    let peaks = Peaks {
        force_x: extremes(&trace.force_x),
        force_y: extremes(&trace.force_y),
        force: extremes(&modulus(&trace.force_x, &trace.force_y)),
        couple_x: extremes(&trace.couple_x),
        couple_y: extremes(&trace.couple_y),
        couple: extremes(&modulus(&trace.couple_x, &trace.couple_y)),
        roll_moment: extremes(&trace.roll_moment),
        shaft_torque: extremes(&trace.shaft_torque),
    };
    LoadSet { trace, orders, peaks }
}
