//! The graphs in `examples/bond-graphs` against their exact answers.

use lanchester_bondgraph::{
    Audit, Cancel, Equations, Graph, Method, NotLinear, Notation, Simulation, SimulationRequest, audit_text,
    equations, linear_text,
};
use nalgebra::{DMatrix, DVector};
use std::sync::atomic::{AtomicBool, Ordering};

fn shipped(text: &str) -> Equations {
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

macro_rules! graph {
    ($name:literal) => {
        shipped(include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml")))
    };
}

fn series<'a>(run: &'a Simulation, name: &str) -> &'a [f64] {
    &run.series.iter().find(|series| series.name == name).unwrap_or_else(|| panic!("no {name}")).values
}

fn matrix(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.first().map_or(0, Vec::len), |i, j| rows[i][j])
}

/// Largest difference of a linear graph's states from the matrix exponential, against the largest of each state.
fn off_the_exponential(equations: &Equations, a: &DMatrix<f64>, constant: &DVector<f64>) -> f64 {
    let request = equations.request();
    let run = equations.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    let n = a.nrows();
    // The constant is a state of its own: x' = A x + b 1.
    let mut whole = DMatrix::zeros(n + 1, n + 1);
    whole.view_mut((0, 0), (n, n)).copy_from(a);
    whole.view_mut((0, n), (n, 1)).copy_from(constant);
    let step = (whole * (request.duration / request.samples as f64)).exp();
    let mut exact = DVector::zeros(n + 1);
    exact[n] = 1.0;
    let (mut worst, mut largest) = (vec![0.0f64; n], vec![0.0f64; n]);
    for sample in 1..run.time.len() {
        exact = &step * exact;
        for state in 0..n {
            worst[state] = worst[state].max((run.series[state].values[sample] - exact[state]).abs());
            largest[state] = largest[state].max(exact[state].abs());
        }
    }
    (0..n).map(|state| worst[state] / largest[state]).fold(0.0, f64::max)
}

#[test]
fn mass_spring_damper_is_the_textbook() {
    let equations = graph!("mass-spring-damper");
    let shown = equations.shown(Notation::Text);
    let rates: Vec<String> =
        shown.rates.iter().map(|rate| format!("{} = {}", rate.left, rate.right)).collect();
    assert_eq!(
        rates,
        [
            "d(mass.momentum)/dt = F - k*spring.displacement - c*mass.momentum/m",
            "d(spring.displacement)/dt = mass.momentum/m",
        ]
    );
    let linear = equations.linear().expect("linear");
    assert_eq!(linear.a, [[-3.0 / 1.2, -250.0], [1.0 / 1.2, 0.0]]);
    let frequency = (250f64 / 1.2).sqrt();
    assert!((linear.poles[0].frequency - frequency).abs() < 1e-12 * frequency);
    assert!((linear.poles[0].damping - 3.0 / (2.0 * (250f64 * 1.2).sqrt())).abs() < 1e-14);
    // Force to spring force: k/(m s^2 + c s + k).
    let transfer = linear.transfer.iter().find(|t| t.output == "spring.effort").expect("there");
    let m = 1.2;
    for (got, want) in transfer.denominator.iter().zip([250.0 / m, 3.0 / m, 1.0]) {
        assert!((got - want).abs() < 1e-12 * want, "{transfer:?}");
    }
    assert!((transfer.numerator[0] - 250.0 / m).abs() < 1e-10, "{transfer:?}");
    let off = off_the_exponential(&equations, &matrix(&linear.a), &DVector::from_vec(vec![10.0, 0.0]));
    assert!(off < 1e-10, "{off:e}");
}

#[test]
fn dc_motor_is_the_textbook() {
    let equations = graph!("dc-motor");
    let linear = equations.linear().expect("linear");
    let (l, r, k, j, b) = (2e-3, 0.5, 0.08, 3e-4, 2e-4);
    let a = DMatrix::from_row_slice(2, 2, &[-r / l, -k / j, k / l, -b / j]);
    assert!((matrix(&linear.a) - &a).norm() < 1e-12 * a.norm());
    let off = off_the_exponential(&equations, &a, &DVector::from_vec(vec![24.0, -0.3]));
    assert!(off < 1e-10, "{off:e}");
}

#[test]
fn two_tanks_are_the_textbook() {
    let equations = graph!("two-tanks");
    let (c1, c2, r) = (0.05 / 9810.0, 0.08 / 9810.0, 1.2e7);
    let a =
        DMatrix::from_row_slice(2, 2, &[-1.0 / (r * c1), 1.0 / (r * c2), 1.0 / (r * c1), -2.0 / (r * c2)]);
    let linear = equations.linear().expect("linear");
    assert!((matrix(&linear.a) - &a).norm() < 1e-12 * a.norm());
    let off = off_the_exponential(&equations, &a, &DVector::from_vec(vec![4e-4, 0.0]));
    assert!(off < 1e-10, "{off:e}");
}

/// Coefficients that are no whole numbers keep their digits: by hand det(s - A) = s^2 + 0.0213889 s + 4.16667e-5.
#[test]
fn transfer_functions_are_printed_with_six_digits() {
    let found = graph!("thermal-chain");
    let text = linear_text(&found.linear().expect("linear"));
    let want = "plate.effort / burner.flow = (0.0025 s + 2.22222e-5) / (s^2 + 0.0213889 s + 4.16667e-5)";
    assert!(text.contains(want), "{text}");
    // The heat into a wall is no state's own variable: it is asked for.
    let names = ["plate.effort".to_owned(), "burner.effort".to_owned()];
    let chosen = found.linear_to(&names).expect("linear");
    assert_eq!(chosen.outputs, names);
    assert_eq!(chosen.c[0], chosen.c[1], "burner and plate share their temperature");
    let refused = found.linear_to(&["plate.speed".to_owned()]).expect_err("no such quantity");
    assert!(matches!(&refused, NotLinear::NoOutput { has, .. } if has.contains(&"plate.flow".to_owned())));
}

/// Free bodies have a pole at 0, undamped ones poles on the imaginary axis, whatever rounding leaves beside; a slow pole stays.
#[test]
fn rounding_is_no_pole_and_no_coefficient() {
    let chain = graph!("torsion-chain").linear().expect("linear");
    assert_eq!((chain.poles[0].real, chain.poles[0].frequency), (0.0, 0.0), "{:?}", chain.poles);
    let transfer = &chain.transfer[0];
    assert_eq!(transfer.denominator[0], 0.0, "{transfer:?}");
    // k1 k2 (J1 + J2 + J3)/(J1 J2 J3) is the next.
    assert!((transfer.denominator[1] / (2e5 * 3e5 * 0.27 / (0.05 * 0.02 * 0.2)) - 1.0).abs() < 1e-14);
    let free = shipped(
        r#"
name = "free"
[elements]
s = { kind = "Se", effort = "1 N" }
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1 kg" }
w = { kind = "1", domain = "translation" }
n = { kind = "I", inertia = "2 kg" }
o = { kind = "0", domain = "translation" }
k = { kind = "C", stiffness = "100 N/m" }
[bonds]
list = ["s > v", "v > m", "v > o", "o > k", "o > w", "w > n"]
"#,
    )
    .linear()
    .expect("linear");
    let rest: Vec<f64> = free.poles.iter().flat_map(|pole| [pole.real, pole.damping]).collect();
    assert_eq!(rest, [0.0; 6]);
    assert!((free.poles[1].imaginary - 150f64.sqrt()).abs() < 1e-14 * 150.0);
    // A mass of 1 kg behind a damper of 1e-9 N s/m beside one behind 1e4 N s/m: thirteen powers of ten apart.
    let slow = shipped(
        r#"
name = "slow"
[elements]
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1 kg" }
b = { kind = "R", resistance = "1e-9 N s/m" }
s = { kind = "Se", effort = "1 N" }
w = { kind = "1", domain = "translation" }
n = { kind = "I", inertia = "1 kg" }
c = { kind = "R", resistance = "1e4 N s/m" }
[bonds]
list = ["s > v", "v > m", "v > b", "w > n", "w > c"]
"#,
    )
    .linear()
    .expect("linear");
    assert_eq!(slow.poles.iter().map(|pole| pole.real).collect::<Vec<_>>(), [-1e-9, -1e4]);
    let denominator = &slow.transfer[0].denominator;
    assert!((denominator[0] / 1e-5 - 1.0).abs() < 1e-15, "{denominator:?}");
}

#[test]
fn torsion_chain_against_the_exact_forced_motion() {
    let equations = graph!("torsion-chain");
    let (j, k, d) = ([0.05, 0.02, 0.2], [2e5, 3e5], 2.0);
    // States: momenta 1, twist 1, momentum 2, twist 2, momentum 3; sine and cosine of the torque as two more.
    let mut a = DMatrix::zeros(7, 7);
    for (shaft, (left, right)) in [(0, 2), (2, 4)].into_iter().enumerate() {
        let twist = left + 1;
        a[(twist, left)] = 1.0 / j[shaft];
        a[(twist, right)] = -1.0 / j[shaft + 1];
        for (row, sign) in [(left, -1.0), (right, 1.0)] {
            a[(row, twist)] += sign * k[shaft];
            a[(row, left)] += sign * d / j[shaft];
            a[(row, right)] -= sign * d / j[shaft + 1];
        }
    }
    a[(0, 5)] = 100.0;
    a[(5, 6)] = 300.0;
    a[(6, 5)] = -300.0;
    let run = equations.simulate(&equations.request());
    assert!(run.complete, "{}", run.ended);
    let names =
        ["disc1.momentum", "shaft1.displacement", "disc2.momentum", "shaft2.displacement", "disc3.momentum"];
    let mut exact = DVector::zeros(7);
    exact[6] = 1.0;
    let step = (a * (0.1 / 200.0)).exp();
    let (mut worst, mut largest) = ([0.0f64; 5], [0.0f64; 5]);
    for sample in 1..run.time.len() {
        exact = &step * exact;
        for (state, name) in names.iter().enumerate() {
            worst[state] = worst[state].max((series(&run, name)[sample] - exact[state]).abs());
            largest[state] = largest[state].max(exact[state].abs());
        }
    }
    for state in 0..5 {
        assert!(
            worst[state] < 1e-10 * largest[state],
            "{}: {:e}",
            names[state],
            worst[state] / largest[state]
        );
    }
}

fn rk4(y: &mut [f64], h: f64, f: impl Fn(&[f64]) -> Vec<f64>) {
    let shifted = |k: &[f64], s: f64| y.iter().zip(k).map(|(y, k)| y + s * k).collect::<Vec<f64>>();
    let k1 = f(y);
    let k2 = f(&shifted(&k1, 0.5 * h));
    let k3 = f(&shifted(&k2, 0.5 * h));
    let k4 = f(&shifted(&k3, h));
    for i in 0..y.len() {
        y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    }
}

const R: f64 = 0.04775;
const L: f64 = 0.144;
const M: f64 = 0.98496667;

fn ratio(theta: f64) -> f64 {
    let (s, c) = theta.sin_cos();
    -R * s - R * R * s * c / (L * L - R * R * s * s).sqrt()
}

/// Slope of the ratio by hand.
fn ratio_slope(theta: f64) -> f64 {
    let (s, c) = theta.sin_cos();
    let root = (L * L - R * R * s * s).sqrt();
    -R * c - R * R * (c * c - s * s) / root - R.powi(4) * s * s * c * c / root.powi(3)
}

#[test]
fn slider_crank_piston_follows_and_the_energy_balance_is_exact() {
    let equations = graph!("slider-crank");
    let follower = &equations.causality.followers[0];
    assert_eq!(follower.element, "piston");
    assert_eq!(follower.path, ["crank", "shaft", "slider", "guide", "piston"]);
    let shown = equations.shown(Notation::Text);
    assert!(shown.mass.is_some(), "M x' = f is printed");
    let mut request = equations.request();
    request.audit = true;
    let run = equations.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    // Lagrange by hand: (J + m s'^2) w' = T - c w - m s' s'' w^2.
    let mut y = [0.3, 100.0];
    let (samples, parts) = (request.samples, 40);
    let h = request.duration / (samples * parts) as f64;
    let mut worst = 0.0f64;
    for sample in 1..=samples {
        for _ in 0..parts {
            rk4(&mut y, h, |y| {
                let (s1, s2) = (ratio(y[0]), ratio_slope(y[0]));
                let torque = 5.0 - 0.02 * y[1] - M * s1 * s2 * y[1] * y[1];
                vec![y[1], torque / (0.05 + M * s1 * s1)]
            });
        }
        worst = worst.max((series(&run, "crank.flow")[sample] - y[1]).abs());
    }
    // Runge's method of order 4 with steps of 5e-5 s is good to some 1e-9 of the speed here.
    assert!(worst < 1e-7, "{worst:e} rad/s");
    let audit = run.audit.as_ref().expect("asked for");
    assert!(audit.whole < 1e-9, "{:e}", audit.whole);
    for residual in &audit.residuals {
        assert!(residual.error < 1e-12, "{residual:?}");
    }
    let kinetic = |i: usize| {
        let (w, v) = (series(&run, "crank.flow")[i], series(&run, "piston.flow")[i]);
        0.5 * (0.05 * w * w + M * v * v)
    };
    let taken = |name: &str| audit.elements.iter().find(|e| e.element == name).expect("there").taken;
    let gained = kinetic(samples) - kinetic(0);
    let work = -taken("motor") - taken("rub");
    assert!((gained - work).abs() < 1e-9 * audit.throughput, "{gained} {work}");
    // The piston follows the crank: it holds 1/2 m v^2 by its law as well.
    let piston = audit.elements.iter().find(|e| e.element == "piston").expect("there");
    let velocity = |i: usize| series(&run, "piston.flow")[i];
    let gained = 0.5 * M * (velocity(samples).powi(2) - velocity(0).powi(2));
    let held = piston.held.expect("its law is linear");
    assert!((held - gained).abs() < 1e-12 * audit.throughput, "{held} {gained}");
    assert!(piston.error.is_some_and(|error| error < 1e-9), "{piston:?}");
}

/// Inertias and springs that follow a source are audited as well; one whose law is not linear is not.
#[test]
fn stores_that_follow_a_source_are_audited() {
    let graph = Graph::read(
        r#"
name = "imposed"
[elements]
drive = { kind = "Sf", flow = "0.5 m/s * sin(20*t/(1 s))" }
rod = { kind = "1", domain = "translation" }
mass = { kind = "I", inertia = "2 kg" }
rub = { kind = "R", resistance = "3 N s/m" }
push = { kind = "Se", effort = "100 N * cos(20*t/(1 s))" }
pot = { kind = "0", domain = "translation" }
spring = { kind = "C", stiffness = "500 N/m" }
damper = { kind = "R", resistance = "7 N s/m" }
[bonds]
list = ["drive > rod", "rod > mass", "rod > rub", "push > pot", "pot > spring", "pot > damper"]
"#,
    )
    .expect("it is good");
    let found = equations(&graph).expect("no conflict");
    let mut request = found.request();
    (request.audit, request.duration) = (true, 0.7);
    let audit = found.simulate(&request).audit.expect("asked for");
    let of = |name: &str| audit.elements.iter().find(|e| e.element == name).expect("there");
    let (v, f) = (0.5 * 14.0f64.sin(), 100.0 * 14.0f64.cos());
    for (name, want) in [("mass", v * v), ("spring", (f * f - 1e4) / 1e3)] {
        let own = of(name);
        assert!((own.held.expect("linear") - want).abs() < 1e-12, "{own:?} {want}");
        assert!(own.error.is_some_and(|error| error < 1e-9), "{own:?}");
    }
    assert_eq!(of("rub").held, None);
}

fn audited(text: &str, duration: f64, tolerance: f64) -> (Simulation, Audit) {
    let found = shipped(text);
    let run = found.simulate(&SimulationRequest { audit: true, duration, tolerance, ..found.request() });
    assert!(run.complete, "{}", run.ended);
    let audit = run.audit.clone().expect("asked for");
    (run, audit)
}

/// A ball that leaves the floor with 0.8 of its speed: what each bounce takes is counted by itself.
#[test]
fn energy_that_events_take_is_no_error() {
    let text = r#"
name = "ball"
[elements]
ball = { kind = "1", domain = "translation" }
mass = { kind = "I", inertia = "0.2 kg" }
weight = { kind = "Se", effort = "-0.2 kg*9.81 m/s2" }
[signals]
height = { integral_of = "ball.flow", start = "1 m" }
[[event]]
when = "-height"
set = { "mass.momentum" = "-0.8*mass.momentum" }
[bonds]
list = ["ball > mass", "weight > ball"]
"#;
    // It falls for 0.4515 s, bounces, and 1.6 times as long later again.
    let (run, audit) = audited(text, 1.4, 1e-11);
    let mass = audit.elements.iter().find(|own| own.element == "mass").expect("there");
    let fall = 0.2 * 9.81;
    let want = fall * (1.0 - 0.8f64.powi(4));
    let lost = mass.taken_by_events.expect("it bounced twice");
    assert!((lost - want).abs() < 1e-9 * want, "{lost} {want}");
    assert!(mass.error.is_some_and(|error| error < 1e-10), "{mass:?}");
    assert!(audit_text(&run).contains("taken by events [J]"));
    // Without the loss it would be all of what the weight gave: the check can fail.
    assert!((mass.held.expect("linear") - mass.taken).abs() > 0.5 * fall, "{mass:?}");
}

/// Stores by a law or an energy: a spring that hardens, k q + c q^3, and a condenser whose plates move.
#[test]
fn stores_by_law_and_energy_are_audited() {
    let text = r#"
name = "microphone"
[elements]
battery = { kind = "Se", effort = "100 V" }
circuit = { kind = "1", domain = "electric" }
r = { kind = "R", resistance = "1e6 Ohm" }
plates = { kind = "C", energy = "q1^2*(1 mm + q2)/(2*8.854e-12 F/m*1e-3 m2)" }
move = { kind = "1", domain = "translation" }
push = { kind = "Se", effort = "2 N*sin(t*90/(1 s))" }
m = { kind = "I", inertia = "1e-3 kg" }
k = { kind = "C", law = "1000 N/m*q + 2e9 N/m^3*q^3" }
b = { kind = "R", resistance = "0.1 N s/m" }
[bonds]
list = ["battery > circuit", "circuit > r", "circuit > plates.1", "move > plates.2", "move > m", "move > k", "move > b", "push > move"]
"#;
    let (run, audit) = audited(text, 0.0103, 1e-11);
    let of = |name: &str| audit.elements.iter().find(|own| own.element == name).expect("there");
    let last = |name: &str| *series(&run, name).last().expect("there");
    let (q1, q2, q) = (last("plates.1.displacement"), last("plates.2.displacement"), last("k.displacement"));
    for (name, want) in
        [("k", 500.0 * q * q + 5e8 * q.powi(4)), ("plates", q1 * q1 * (1e-3 + q2) / (2.0 * 8.854e-12 * 1e-3))]
    {
        let own = of(name);
        assert!((own.held.expect("known") - want).abs() < 1e-12 * want.abs(), "{own:?} {want}");
        assert!(own.error.is_some_and(|error| error < 1e-9), "{own:?}");
    }
}

/// A crank at an imposed speed carries energy to and fro and ends where it began: errors are shares of what passed.
#[test]
fn errors_are_measured_by_what_passed_to_and_fro() {
    let text = r#"
name = "to and fro"
[elements]
drive = { kind = "Sf", flow = "0.5 m/s*sin(2*pi*t/(1 s))" }
rod = { kind = "1", domain = "translation" }
mass = { kind = "I", inertia = "2 kg" }
[bonds]
list = ["drive > rod", "rod > mass"]
"#;
    let (_, audit) = audited(text, 10.0, 1e-9);
    // 1/2 m v^2 = 0.25 J in and out twice a second.
    assert!((audit.throughput - 10.0).abs() < 1e-3, "{}", audit.throughput);
    let mass = audit.elements.iter().find(|own| own.element == "mass").expect("there");
    assert!(mass.error.is_some_and(|error| error < 1e-9), "{mass:?}");
    assert!(mass.taken.abs() < 1e-7, "the net is nothing: {mass:?}");
}

#[test]
fn elastic_rod_agrees_with_the_ideal_one_as_it_stiffens_and_both_methods_agree() {
    let equations = graph!("slider-crank-elastic");
    assert!(equations.causality.followers.is_empty(), "the piston is free");
    let mut request = equations.request();
    request.method = Some(Method::Explicit);
    let explicit = equations.simulate(&request);
    request.method = Some(Method::Implicit);
    let implicit = equations.simulate(&request);
    assert!(explicit.complete && implicit.complete, "{} {}", explicit.ended, implicit.ended);
    let mut worst = 0.0f64;
    for (a, b) in series(&explicit, "crank.flow").iter().zip(series(&implicit, "crank.flow")) {
        worst = worst.max((a - b).abs());
    }
    assert!(worst < 1e-6, "explicit and implicit differ by {worst:e} rad/s");
    let mut ideal = graph!("slider-crank").request();
    ideal.duration = 0.2;
    ideal.samples = 400;
    let ideal = graph!("slider-crank").simulate(&ideal);
    let off = series(&explicit, "crank.flow")
        .iter()
        .zip(series(&ideal, "crank.flow"))
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(off < 0.05, "{off} rad/s off the ideal rod");
    assert!(off > 1e-9, "the rod is elastic");
}

#[test]
fn turbulent_tanks_against_a_fine_independent_integration() {
    let equations = graph!("two-tanks-turbulent");
    let run = equations.simulate(&equations.request());
    assert!(run.complete, "{}", run.ended);
    let (c1, c2) = (0.05 / 9810.0, 0.08 / 9810.0);
    let pipe = |e: f64| 3.5e-6 * e / (e * e + 1.0).powf(0.25);
    let mut y = [9000.0 * c1, 0.0];
    let (samples, parts) = (run.time.len() - 1, 2000);
    let h = 600.0 / (samples * parts) as f64;
    let mut worst = 0.0f64;
    for sample in 1..=samples {
        for _ in 0..parts {
            rk4(&mut y, h, |y| {
                let (p1, p2) = (y[0] / c1, y[1] / c2);
                vec![4e-4 - pipe(p1 - p2), pipe(p1 - p2) - pipe(p2)]
            });
        }
        worst = worst.max((series(&run, "tank1.effort")[sample] - y[0] / c1).abs());
        worst = worst.max((series(&run, "tank2.effort")[sample] - y[1] / c2).abs());
    }
    assert!(worst < 0.05, "{worst} Pa");
}

/// The law of a textbook's orifice, sign(e) sqrt|e|, has an infinite slope at 0: the run says so at once, names the element and the cure; with it
/// the same tanks fill from empty.
#[test]
fn a_root_at_zero_is_named_and_has_a_cure() {
    let good = include_str!("../../../../examples/bond-graphs/two-tanks-turbulent.toml");
    let empty = good.replace(", effort = \"9000 Pa\"", "").replace("tolerance = 1e-11", "tolerance = 1e-9");
    let plain = empty.replace("regroot(e, 1 Pa)/sqrt(1 Pa)", "sign(e)*sqrt(abs(e)/(1 Pa))");
    assert!(plain.contains("sign(e)"), "{plain}");
    for method in [None, Some(Method::Explicit), Some(Method::Implicit)] {
        let found = shipped(&plain);
        let run = found.simulate(&SimulationRequest { method, ..found.request() });
        assert!(!run.complete, "the plain law has come through, and this test means nothing");
        assert!(
            run.ended.contains("the root in the law of `") && run.ended.contains("regroot("),
            "{}",
            run.ended
        );
        assert!(run.statistics.evaluations < 200_000, "{:?}", run.statistics);
        let found = shipped(&empty);
        let run = found.simulate(&SimulationRequest { method, ..found.request() });
        assert!(run.complete, "{}", run.ended);
        // At rest at last: each orifice lets Q through, Kv sqrt(e) = Q, to the width's 1/4 (1/13061)^2.
        let level = (4e-4f64 / 3.5e-6).powi(2);
        let run = found.simulate(&SimulationRequest { method, duration: 3e5, ..found.request() });
        let reached = series(&run, "tank2.effort").last().expect("a sample");
        assert!((reached / level - 1.0).abs() < 1e-7, "{reached} {level}: {}", run.ended);
    }
    // A tank that runs empty, and friction by the root of the speed that starts at rest.
    for text in [
        r#"
name = "drain"
[elements]
tank = { kind = "C", capacitance = "5e-6 m3/Pa", effort = "5000 Pa" }
n = { kind = "0", domain = "hydraulic" }
out = { kind = "R", flow = "3.5e-6 m3/s*sign(e)*sqrt(abs(e)/(1 Pa))" }
[bonds]
list = ["n > tank", "n > out"]
[simulation]
duration = "400 s"
"#,
        r#"
name = "drag"
[elements]
push = { kind = "Se", effort = "1 N*t/(1 s)" }
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1 kg" }
out = { kind = "R", effort = "2 N*sign(f)*sqrt(abs(f)/(1 m/s))" }
[bonds]
list = ["push > v", "v > m", "v > out"]
"#,
    ] {
        let run = shipped(text);
        let run = run.simulate(&run.request());
        assert!(run.ended.contains("the root in the law of `out`"), "{}", run.ended);
        assert!(run.statistics.evaluations < 200_000, "{:?}", run.statistics);
    }
}

/// A diode behind a resistor: the voltage goes through 80 times the exponent's unit between two samples, however far these are apart.
#[test]
fn an_exponential_in_a_loop_is_solved_from_afar() {
    let text = r#"
name = "clipper"
[elements]
s = { kind = "Se", effort = "5 V*sin(100 1/s*t)" }
j = { kind = "1", domain = "electric" }
r1 = { kind = "R", resistance = "100 Ohm" }
d = { kind = "R", flow = "1e-12 A*(exp(e/(0.025 V)) - 1)" }
[bonds]
list = ["s > j", "j > r1", "j > d"]
[simulation]
duration = "0.1 s"
"#;
    let found = shipped(text);
    for samples in [3, 20, 200, 1000] {
        let run = found.simulate(&SimulationRequest { samples, ..found.request() });
        assert!(run.complete, "{samples}: {}", run.ended);
        let (current, voltage) = (series(&run, "d.flow"), series(&run, "d.effort"));
        for (k, t) in run.time.iter().enumerate() {
            let [over, law] = [100.0 * current[k] + voltage[k], 1e-12 * ((voltage[k] / 0.025).exp() - 1.0)];
            assert!((over - 5.0 * (100.0 * t).sin()).abs() < 1e-12 * 5.0, "{samples} {t}");
            assert!((law - current[k]).abs() <= 1e-11 * current[k].abs().max(1e-12), "{samples} {t}");
        }
    }
    // f = -(f^2 + 1) has no solution: the loop is named.
    let none = text
        .replace("5 V*sin(100 1/s*t)", "0 V")
        .replace("resistance = \"100 Ohm\"", "effort = \"1 V*((f/(1 A))^2 + 1)\"")
        .replace("1e-12 A*(exp(e/(0.025 V)) - 1)", "1 A*e/(1 V)");
    let run = shipped(&none);
    let run = run.simulate(&run.request());
    assert!(!run.complete);
    assert!(
        run.ended.contains("no solution of the algebraic loop of") && run.ended.contains("r1"),
        "{}",
        run.ended
    );
}

#[test]
fn slider_crank_as_one_field_by_its_energy_moves_as_the_one_with_a_follower() {
    let mu = "(-r*sin(q) - r^2*sin(q)*cos(q)/sqrt(l^2 - r^2*sin(q)^2))";
    let start = mu.replace('q', "(0.3)").replace("s(0.3)rt", "sqrt");
    let text = format!(
        "name = \"field\"\n[parameters]\nr = \"47.75 mm\"\nl = \"144 mm\"\nm = \"0.98496667 kg\"\nJ = \"0.05 kg m2\"\n\
         [elements]\nmotor = {{ kind = \"Se\", effort = \"5 N m\" }}\nshaft = {{ kind = \"1\", domain = \"rotation\" }}\n\
         train = {{ kind = \"IC\", energy = \"p^2/(2*(J + m*{mu}^2))\", displacement = \"0.3 rad\", \
         momentum = \"(J + m*{start}^2)*100 1/s\" }}\n\
         rub = {{ kind = \"R\", resistance = \"0.02 N m s\" }}\n\
         [bonds]\nlist = [\"motor > shaft\", \"shaft > train\", \"shaft > rub\"]\n\
         [simulation]\nduration = \"1 s\"\nsamples = 500\ntolerance = 1e-11\n"
    );
    let field = shipped(&text);
    let mut request = field.request();
    request.audit = true;
    let run = field.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    let other = graph!("slider-crank");
    let other = other.simulate(&other.request());
    for (a, b) in series(&run, "train.flow").iter().zip(series(&other, "crank.flow")) {
        assert!((a - b).abs() < 1e-8, "{a} {b} rad/s");
    }
    assert!(run.audit.is_some_and(|audit| audit.whole < 1e-12));
}

#[test]
fn lever_with_two_inputs_is_a_transformer_by_its_matrix() {
    let text = "name = \"lever\"\n[elements]\npush = { kind = \"Se\", effort = \"3 N\" }\n\
                a = { kind = \"1\", domain = \"translation\" }\nma = { kind = \"I\", inertia = \"2 kg\" }\n\
                b = { kind = \"1\", domain = \"translation\" }\nmb = { kind = \"I\", inertia = \"5 kg\" }\n\
                lever = { kind = \"TF\", matrix = [[\"1\", \"2\"]] }\nc = { kind = \"1\", domain = \"translation\" }\n\
                oil = { kind = \"R\", resistance = \"7 N s/m\" }\n\
                [bonds]\nlist = [\"push > a\", \"a > ma\", \"a > lever.1\", \"b > mb\", \"b > lever.2\", \"lever.3 > c\", \"c > oil\"]\n";
    let found = shipped(text);
    let linear = found.linear().expect("linear");
    // f_out = f_a + 2 f_b, so e_a = e_out and e_b = 2 e_out.
    let exact = [[-7.0 / 2.0, -7.0 * 2.0 / 5.0], [-2.0 * 7.0 / 2.0, -2.0 * 7.0 * 2.0 / 5.0]];
    for (row, want) in linear.a.iter().zip(exact) {
        for (got, want) in row.iter().zip(want) {
            assert!((got - want).abs() < 1e-14, "{:?}", linear.a);
        }
    }
    let mut request = found.request();
    request.audit = true;
    let audit = found.simulate(&request).audit.expect("asked for");
    let lever = audit.residuals.iter().find(|residual| residual.element == "lever").expect("there");
    assert!(lever.error < 1e-14, "{lever:?}");
}

/// A run that is stopped keeps the samples so far, and says to which tolerance they are.
#[test]
fn a_stopped_run_keeps_its_samples() {
    static AT_ONCE: AtomicBool = AtomicBool::new(true);
    static LATER: AtomicBool = AtomicBool::new(false);
    let equations = graph!("slider-crank");
    // 200 000 revolutions and more, which may take as long as they like.
    let long = SimulationRequest {
        duration: 1e5,
        samples: 100_000,
        most_evaluations: u64::MAX,
        ..equations.request()
    };
    let early = equations.simulate(&SimulationRequest { cancel: Some(Cancel(&AT_ONCE)), ..long });
    assert!(!early.complete && early.ended.contains("first pass"), "{}", early.ended);
    assert!(early.tolerance == 1e-5 && !early.time.is_empty(), "{:e}", early.tolerance);
    let stop = std::thread::spawn(|| {
        // The first pass takes some milliseconds.
        std::thread::sleep(std::time::Duration::from_millis(700));
        LATER.store(true, Ordering::Relaxed);
    });
    let late = equations.simulate(&SimulationRequest { cancel: Some(Cancel(&LATER)), ..long });
    stop.join().expect("it sleeps");
    assert!(!late.complete && late.ended.starts_with("cancelled at"), "{}", late.ended);
    assert_eq!(late.tolerance, long.tolerance);
    assert!(late.time.len() > 10, "{} samples, {}", late.time.len(), late.ended);
}
