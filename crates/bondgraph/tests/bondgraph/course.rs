//! The graphs of the course in `examples/bond-graphs` against the literature's equations, term by term or by what must be conserved.

use lanchester_bondgraph::{Equations, Graph, Simulation, SimulationRequest, equations};

fn found(text: &str) -> Equations {
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

macro_rules! text {
    ($name:literal) => {
        include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml"))
    };
}

fn values<'a>(run: &'a Simulation, name: &str) -> &'a [f64] {
    run.values(name).unwrap_or_else(|| panic!("no {name}"))
}

fn run(found: &Equations, tolerance: f64) -> Simulation {
    let run = found.simulate(&SimulationRequest { tolerance, ..found.request() });
    assert!(run.complete, "{}", run.ended);
    run
}

fn assert_matrix(got: &[Vec<f64>], want: &[&[f64]]) {
    for (row, (got, want)) in got.iter().zip(want).enumerate() {
        let size = want.iter().fold(0.0f64, |most, w| most.max(w.abs()));
        for (got, want) in got.iter().zip(*want) {
            assert!((got - want).abs() <= 1e-12 * size, "row {row}: {got}, not {want}");
        }
    }
}

/// One state; both other inertias count with the square of their ratio (Karnopp, Margolis, Rosenberg, section 5.3).
#[test]
fn gear_train_is_one_inertia() {
    let found = found(text!("gear-train"));
    assert_eq!(found.causality.states, ["rotor"]);
    let (j, n, b) = (0.002 + 0.16 * 0.005 + 0.01 * 0.08, 0.1, 0.03);
    let linear = found.linear().expect("linear");
    assert_matrix(&linear.a, &[&[-b * n * n / j]]);
    let run = run(&found, 1e-12);
    for (t, w) in run.time.iter().zip(values(&run, "first.flow")) {
        let want = 2.0 / (b * n * n) * (1.0 - (-b * n * n / j * t).exp());
        assert!((w - want).abs() < 1e-9 * 2.0 / (b * n * n), "{t}: {w}");
    }
}

#[test]
fn hydraulic_press_is_four_states() {
    let found = found(text!("hydraulic-press"));
    assert_eq!(found.causality.states, ["accumulator", "oil", "mass", "spring"]);
    let (area, m, k, c) = (0.004, 120.0, 4e5, 3000.0);
    let (accumulator, pipe, oil) = (2e-11, 4e8, 5e-13);
    let linear = found.linear().expect("linear");
    assert_matrix(
        &linear.a,
        &[
            &[-1.0 / (pipe * accumulator), 1.0 / (pipe * oil), 0.0, 0.0],
            &[1.0 / (pipe * accumulator), -1.0 / (pipe * oil), -area / m, 0.0],
            &[0.0, area / oil, -c / m, -k],
            &[0.0, 0.0, 1.0 / m, 0.0],
        ],
    );
}

/// Fourier's law and two heat capacities; what the burner gives and the air does not take stays in the bodies.
#[test]
fn thermal_chain_keeps_its_heat() {
    let found = found(text!("thermal-chain"));
    let (a, b, g, h) = (400.0, 900.0, 5.0, 3.0);
    let linear = found.linear().expect("linear");
    assert_matrix(&linear.a, &[&[-g / a, g / b], &[g / a, -(g + h) / b]]);
    let mut request = found.request();
    (request.audit, request.tolerance) = (true, 1e-12);
    let run = found.simulate(&request);
    let audit = run.audit.as_ref().expect("asked for");
    assert!(audit.whole < 1e-11, "{:e}", audit.whole);
    let last = |name: &str| *values(&run, name).last().expect("samples");
    let (first, second) = (last("first.effort"), last("second.effort"));
    assert!(
        first > second && second > 293.0 && first < 293.0 + 150.0 / 3.0 + 150.0 / 5.0,
        "{first} {second}"
    );
}

/// Rates of the angles and speeds of two slender links, by Lagrange's equations.
fn links([a, b, u, v]: [f64; 4]) -> [f64; 4] {
    let (m1, m2, l1, l2, g) = (1.2, 0.8, 0.5, 0.4, 9.81);
    let (sin, cos) = (a - b).sin_cos();
    let (first, second) = (m1 * l1 * l1 / 3.0 + m2 * l1 * l1, m2 * l2 * l2 / 3.0);
    let across = 0.5 * m2 * l1 * l2;
    let right = [
        -across * sin * v * v - (0.5 * m1 + m2) * g * l1 * a.sin(),
        across * sin * u * u - 0.5 * m2 * g * l2 * b.sin(),
    ];
    let whole = first * second - (across * cos).powi(2);
    [
        u,
        v,
        (second * right[0] - across * cos * right[1]) / whole,
        (first * right[1] - across * cos * right[0]) / whole,
    ]
}

#[test]
fn double_pendulum_is_lagranges() {
    let found = found(text!("double-pendulum"));
    assert_eq!(found.causality.states, ["turn_1", "turn_2"]);
    let paths: Vec<String> = found.causality.followers.iter().map(|own| own.path.join(" > ")).collect();
    assert_eq!(paths[0], "turn_1 > centre_1 > x_1");
    assert_eq!(paths[2], "turn_1, turn_2 > centre_2 > x_2");
    assert_eq!(paths.len(), 4);
    let run = run(&found, 1e-12);
    let mut state = [1.2, -0.4, 0.0, 0.0];
    let add = |y: [f64; 4], k: [f64; 4], h: f64| [0, 1, 2, 3].map(|i| y[i] + h * k[i]);
    for sample in 1..run.time.len() {
        let steps = 200;
        let h = (run.time[sample] - run.time[sample - 1]) / f64::from(steps);
        for _ in 0..steps {
            let k1 = links(state);
            let k2 = links(add(state, k1, 0.5 * h));
            let k3 = links(add(state, k2, 0.5 * h));
            let k4 = links(add(state, k3, h));
            state = [0, 1, 2, 3].map(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        for (name, want) in [("phi_1", state[0]), ("phi_2", state[1])] {
            let got = values(&run, name)[sample];
            assert!((got - want).abs() < 1e-9, "{name} at {} s: {got}, not {want}", run.time[sample]);
        }
    }
}

/// Ten times as stiff joints are ten times as near to ideal ones.
#[test]
fn stiff_joints_come_near_ideal_ones() {
    let ideal = found(text!("double-pendulum"));
    let duration = 0.4;
    let asked = SimulationRequest { duration, samples: 20, tolerance: 1e-10, ..ideal.request() };
    let ideal = ideal.simulate(&asked);
    let off = |stiffness: &str, damping: &str| {
        let text = text!("double-pendulum-stiff");
        let text = text.replace("\"1e6 N/m\"", stiffness).replace("\"200 N s/m\"", damping);
        let run = found(&text).simulate(&asked);
        assert!(run.complete, "{}", run.ended);
        let pairs = values(&run, "phi_1").iter().zip(values(&ideal, "phi_1"));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let (soft, hard) = (off("\"1e6 N/m\"", "\"200 N s/m\""), off("\"1e7 N/m\"", "\"632 N s/m\""));
    assert!(soft < 1e-3 && (6.0..16.0).contains(&(soft / hard)), "{soft:e}, {hard:e}");
}

/// Kinetic energy and that of the springs, momenta in space and their moment about the origin.
fn conserved(run: &Simulation, sample: usize) -> [f64; 4] {
    let at = |name: &str| values(run, name)[sample];
    let [px, py, qx, qy] =
        ["mass_cx", "mass_cy", "mass_px", "mass_py"].map(|name| at(&format!("{name}.momentum")));
    let (lc, lp) = (at("inertia_c.momentum"), at("inertia_p.momentum"));
    let springs = ["skirt_1", "skirt_2"].map(|name| 0.5e5 * at(&format!("{name}.displacement")).powi(2));
    [
        (px * px + py * py) / 10.0
            + (qx * qx + qy * qy) / 4.0
            + lc * lc / 0.006
            + lp * lp / 0.004
            + springs[0]
            + springs[1],
        px + qx,
        py + qy,
        lc + lp + at("x_c") * py - at("y_c") * px + at("x_p") * qy - at("y_p") * qx,
    ]
}

fn drift(run: &Simulation) -> [f64; 4] {
    let start = conserved(run, 0);
    let mut most = [0.0f64; 4];
    for sample in 1..run.time.len() {
        let now = conserved(run, sample);
        for k in 0..4 {
            // Momenta are measured by the largest single one, 2 N s, their moment by a tenth of a metre of that.
            let size = [start[0], 2.0, 2.0, 0.2][k];
            most[k] = most[k].max((now[k] - start[k]).abs() / size);
        }
    }
    most
}

/// Figures 3.19 and 3.20 of the bond-graph thesis. With contacts that press along one normal everything is conserved.
#[test]
fn prismatic_pair_conserves_energy_and_momenta() {
    let found = found(text!("prismatic-pair"));
    assert_eq!(found.causality.states.len(), 8);
    let run = run(&found, 1e-12);
    let largest = values(&run, "skirt_1.displacement").iter().fold(0.0f64, |most, q| most.max(q.abs()));
    assert!(largest > 1e-5, "the contacts carry load: {largest} m");
    for (what, drift) in ["energy", "momentum x", "momentum y", "moment of momentum"].iter().zip(drift(&run))
    {
        assert!(drift < 1e-10, "{what} drifts by {drift:e}");
    }
}

/// Eqs. (3.23) to (3.31) as printed, with all fourteen moduli: each is the expression of the thesis, `mu_3` to `mu_6` its reciprocal; the nine equations
/// hold along a run, in which energy is conserved but, each body having its own normal, momentum is not.
#[test]
fn lit_singh_moduli_of_the_prismatic_pair_as_printed() {
    let (l_cg, l_p, l_pg, d) = (0.1, 0.2, 0.15, 0.1);
    let found = found(text!("prismatic-pair-printed"));
    let run = run(&found, 1e-12);
    let at = |name: &str, k: usize| values(&run, name)[k];
    let mut momentum = [0.0f64; 2];
    for k in 0..run.time.len() {
        let (th_cg, th_pg, l) = (at("th_cg", k), at("th_pg", k), at("l", k));
        let (x_1, y_1, x_2, y_2) = (at("x_1", k), at("y_1", k), at("x_2", k), at("y_2", k));
        let printed = [
            l_cg * th_cg.sin(),
            -l_cg * th_cg.cos(),
            -1.0 / th_cg.sin(),
            1.0 / th_cg.cos(),
            1.0 / (l - l_p - l_cg - d / 2.0),
            1.0 / (l - l_p - l_cg + d / 2.0),
            (x_1 - x_2) / l,
            (y_1 - y_2) / l,
            -l_pg * th_pg.sin(),
            l_pg * th_pg.cos(),
            -th_pg.sin(),
            th_pg.cos(),
            -(l_p - l_pg + d / 2.0),
            -(l_p - l_pg - d / 2.0),
        ];
        let mu: Vec<f64> = (1..=14).map(|n| at(&format!("mu_{n}"), k)).collect();
        for (place, (ours, printed)) in mu.iter().zip(printed).enumerate() {
            let theirs = if (2..6).contains(&place) { 1.0 / printed } else { printed };
            assert!((ours - theirs).abs() < 1e-12, "mu_{}: {ours}, printed {printed}", place + 1);
        }
        // 3.27 integrated is the distance between the ends.
        assert!((l - (x_1 - x_2).hypot(y_1 - y_2)).abs() < 1e-10, "{l} m");
        // 3.28 to 3.31, sums of the printed terms.
        let [vx, vy, w] = ["cyl_x.flow", "cyl_y.flow", "cyl_turn.flow"].map(|name| at(name, k));
        let [ux, uy, s] = ["pis_x.flow", "pis_y.flow", "pis_turn.flow"].map(|name| at(name, k));
        for (contact, side) in [(1, -0.5), (2, 0.5)] {
            let of_cylinder = -th_cg.sin() * vx + th_cg.cos() * vy + (l - l_p - l_cg + side * d) * w;
            let of_piston = -th_pg.sin() * ux + th_pg.cos() * uy - (l_p - l_pg - side * d) * s;
            let ours = at(&format!("pad_{contact}.flow"), k);
            assert!((ours - (of_piston - of_cylinder)).abs() < 1e-12, "contact {contact}: {ours} m/s");
        }
        let sum =
            |axis: &str| at(&format!("mass_c{axis}.momentum"), k) + at(&format!("mass_p{axis}.momentum"), k);
        for (most, axis) in momentum.iter_mut().zip(["x", "y"]) {
            let start = values(&run, &format!("mass_p{axis}.momentum"))[0];
            *most = most.max((sum(axis) - start).abs());
        }
    }
    let mut request = found.request();
    (request.audit, request.tolerance) = (true, 1e-12);
    let whole = found.simulate(&request).audit.expect("asked for").whole;
    assert!(whole < 1e-10, "energy drifts by {whole:e}");
    assert!(momentum[0].max(momentum[1]) > 1e-6, "momentum drifts by {momentum:?}");
    // Without tilt the contacts are those of the shipped pair that conserves momentum too.
    let ours = run_start(&self::found(text!("prismatic-pair")), "skirt");
    for (a, b) in ours.into_iter().zip(run_start(&found, "pad")) {
        assert!((a - b).abs() < 1e-12, "{a}, {b}");
    }
}

/// Flows of both contacts at the start.
fn run_start(found: &Equations, name: &str) -> [f64; 2] {
    let run = found.simulate(&SimulationRequest { duration: 1e-9, samples: 1, ..found.request() });
    [1, 2].map(|contact| values(&run, &format!("{name}_{contact}.flow"))[0])
}

/// The gas stays isentropic, and all energy is found again.
#[test]
fn single_cylinder_keeps_its_energy() {
    let found = found(text!("single-cylinder"));
    let mut request = found.request();
    (request.audit, request.tolerance) = (true, 1e-11);
    let run = found.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    assert!(run.audit.as_ref().expect("asked for").whole < 1e-9);
    let exponent = 1.0 + 287.0 / 718.0;
    let (pressure, theta) = (values(&run, "gas.2.effort"), values(&run, "theta"));
    assert!(
        theta[theta.len() - 1] > 20.0,
        "it turns through several compressions: {}",
        theta[theta.len() - 1]
    );
    let constant = 1e5 * (5e-5 + 0.09 * 0.005f64).powf(exponent);
    for (pressure, theta) in pressure.iter().zip(theta) {
        let travel = 0.045 * theta.cos() + (0.15f64.powi(2) - (0.045 * theta.sin()).powi(2)).sqrt();
        let volume: f64 = 5e-5 + 0.005 * (0.195 - travel);
        let off = pressure * volume.powf(exponent) / constant - 1.0;
        assert!(off.abs() < 1e-8, "{theta} rad: {off:e}");
    }
}
