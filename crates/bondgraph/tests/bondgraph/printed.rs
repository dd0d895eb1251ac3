//! State equations as they are printed, read again as expressions and evaluated at many states: each must be the textbook's, term by term.

use lanchester_bondgraph::{Description, Equations, Graph, Notation, ShownEquations, equations};

macro_rules! found {
    ($name:literal) => {
        found(include_str!(concat!("../../../../examples/bond-graphs/", $name, ".toml")))
    };
}

fn found(text: &str) -> Equations {
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

/// A name without points: `crank.momentum` is no name of a parameter. The time is 0, as a number: printed numbers have no units, so that `300*t`
/// would have those of a time.
fn plain(text: &str, states: &[&str]) -> String {
    let is_word =
        |letter: Option<char>| letter.is_some_and(|own| own.is_alphanumeric() || "_.".contains(own));
    let letters: Vec<char> = text.chars().collect();
    let text: String = (0..letters.len())
        .map(|k| {
            let before = k.checked_sub(1).map(|k| letters[k]);
            let alone = !is_word(before) && !is_word(letters.get(k + 1).copied());
            if letters[k] == 't' && alone { '0' } else { letters[k] }
        })
        .collect();
    let mut names: Vec<&&str> = states.iter().filter(|state| state.contains('.')).collect();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    names.into_iter().fold(text, |text, name| text.replace(*name, &name.replace('.', "__")))
}

/// Right sides of the printed state equations at a state: a graph of their texts alone.
fn rates(shown: &ShownEquations, state: &[f64]) -> Vec<f64> {
    let symbols: Vec<&str> = shown.states.iter().map(|state| state.symbol.as_str()).collect();
    let mut graph = Description::new("printed")
        .element("only_junction", "1", &[("domain", "translation")])
        .element("only_mass", "I", &[("inertia", "1 kg")])
        .bonds(&["only_junction > only_mass"]);
    for parameter in &shown.parameters {
        graph = graph.parameter(&parameter.left, &parameter.right);
    }
    for (symbol, value) in symbols.iter().zip(state) {
        graph = graph.parameter(&plain(symbol, &symbols), &format!("{value:?}"));
    }
    for part in &shown.common {
        graph = graph.signal(&part.left, &[("value", &plain(&part.right, &symbols))]);
    }
    for (index, rate) in shown.rates.iter().enumerate() {
        graph = graph.signal(&format!("rate__{index}"), &[("value", &plain(&rate.right, &symbols))]);
    }
    let graph = Graph::new(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).expect("nothing but signals");
    let run = found.simulate(&found.request());
    (0..shown.rates.len()).map(|index| run.values(&format!("rate__{index}")).expect("a signal")[0]).collect()
}

/// Numbers from 0 to 1 that look random and are the same on every machine.
fn numbers(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    (0..count)
        .map(|_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        })
        .collect()
}

/// Holds the printed equations against a law of the states, given by their names, at 20 states within `ranges`.
fn are_the_textbook(found: &Equations, ranges: &[(&str, f64, f64)], law: impl Fn(&[f64]) -> Vec<f64>) {
    let shown = found.shown(Notation::Text);
    let order: Vec<usize> = shown
        .states
        .iter()
        .map(|state| {
            let is_it = |range: &(&str, f64, f64)| range.0 == state.symbol;
            ranges.iter().position(is_it).unwrap_or_else(|| panic!("a state {} that is none", state.symbol))
        })
        .collect();
    assert_eq!(order.len(), ranges.len(), "as many states as the textbook");
    let mut sizes = vec![0.0f64; ranges.len()];
    let mut worst = vec![0.0f64; ranges.len()];
    for seed in 1..=20 {
        let values: Vec<f64> = numbers(ranges.len(), seed)
            .iter()
            .zip(ranges)
            .map(|(share, (_, low, high))| low + share * (high - low))
            .collect();
        let own: Vec<f64> = order.iter().map(|place| values[*place]).collect();
        let (got, want) = (rates(&shown, &own), law(&values));
        for (place, got) in order.iter().zip(&got) {
            sizes[*place] = sizes[*place].max(want[*place].abs());
            worst[*place] = worst[*place].max((got - want[*place]).abs());
        }
    }
    for (place, (name, ..)) in ranges.iter().enumerate() {
        // Both are the same sums in another order: some roundings of the largest term.
        assert!(
            worst[place] <= 1e-11 * sizes[place],
            "{name} of {}: {:e} of {:e}",
            shown.graph,
            worst[place],
            sizes[place]
        );
    }
}

/// Newton's law and that of the spring (Karnopp, Margolis, Rosenberg, section 5.1).
#[test]
fn lit_mass_spring_damper() {
    let ranges = [("mass.momentum", -3.0, 3.0), ("spring.displacement", -0.1, 0.1)];
    are_the_textbook(&found!("mass-spring-damper"), &ranges, |y| {
        vec![10.0 - 3.0 * y[0] / 1.2 - 250.0 * y[1], y[0] / 1.2]
    });
}

/// u = L i' + R i + K w and J w' = K i - b w - T (same, section 5.2).
#[test]
fn lit_dc_motor() {
    let ranges = [("coil.momentum", -0.1, 0.1), ("flywheel.momentum", -0.1, 0.1)];
    are_the_textbook(&found!("dc-motor"), &ranges, |y| {
        let (i, w) = (y[0] / 2e-3, y[1] / 3e-4);
        vec![24.0 - 0.5 * i - 0.08 * w, 0.08 * i - 2e-4 * w - 0.3]
    });
}

/// Balances of volume with laminar pipes.
#[test]
fn lit_two_tanks() {
    let (c1, c2) = (0.05 / 9810.0, 0.08 / 9810.0);
    let ranges = [("tank1.displacement", 0.0, 0.1), ("tank2.displacement", 0.0, 0.1)];
    are_the_textbook(&found!("two-tanks"), &ranges, |y| {
        let (p1, p2, r) = (y[0] / c1, y[1] / c2, 1.2e7);
        vec![4e-4 - (p1 - p2) / r, (p1 - p2) / r - p2 / r]
    });
    are_the_textbook(&found!("two-tanks-turbulent"), &ranges, |y| {
        // The root with a width of 1 Pa about 0.
        let pipe = |e: f64| 3.5e-6 * e / (e * e + 1.0).powf(0.25);
        let (p1, p2) = (y[0] / c1, y[1] / c2);
        vec![4e-4 - pipe(p1 - p2), pipe(p1 - p2) - pipe(p2)]
    });
}

/// Three inertias as one at the first shaft.
#[test]
fn lit_gear_train() {
    are_the_textbook(&found!("gear-train"), &[("rotor.momentum", -0.1, 0.1)], |y| {
        let w = y[0] / 0.002;
        let whole = 0.002 + 0.4f64.powi(2) * 0.005 + 0.1f64.powi(2) * 0.08;
        vec![0.002 * (2.0 - 0.1 * 0.1 * 0.03 * w) / whole]
    });
}

/// The pump starts with its full flow.
#[test]
fn lit_hydraulic_press() {
    let ranges = [
        ("accumulator.displacement", 0.0, 1e-4),
        ("oil.displacement", 0.0, 1e-6),
        ("mass.momentum", -30.0, 30.0),
        ("spring.displacement", 0.0, 0.01),
    ];
    are_the_textbook(&found!("hydraulic-press"), &ranges, |y| {
        let (line, cylinder, v) = (y[0] / 2e-11, y[1] / 5e-13, y[2] / 120.0);
        let pipe = (line - cylinder) / 4e8;
        vec![2e-4 - pipe, pipe - 0.004 * v, 0.004 * cylinder - 4e5 * y[3] - 3000.0 * v, v]
    });
}

/// Fourier's law twice.
#[test]
fn lit_thermal_chain() {
    let ranges = [("plate.displacement", 1e5, 2e5), ("housing.displacement", 2e5, 4e5)];
    are_the_textbook(&found!("thermal-chain"), &ranges, |y| {
        let (first, second) = (y[0] / 400.0, y[1] / 900.0);
        let between = 5.0 * (first - second);
        vec![150.0 - between, between - 3.0 * (second - 293.0)]
    });
}

/// Three inertias on two damped shafts, at rest no torque yet.
#[test]
fn lit_torsion_chain() {
    let ranges = [
        ("disc1.momentum", -5.0, 5.0),
        ("shaft1.displacement", -1e-3, 1e-3),
        ("disc2.momentum", -5.0, 5.0),
        ("shaft2.displacement", -1e-3, 1e-3),
        ("disc3.momentum", -5.0, 5.0),
    ];
    are_the_textbook(&found!("torsion-chain"), &ranges, |y| {
        let w = [y[0] / 0.05, y[2] / 0.02, y[4] / 0.2];
        let torque = [2e5 * y[1] + 2.0 * (w[0] - w[1]), 3e5 * y[3] + 2.0 * (w[1] - w[2])];
        vec![-torque[0], w[0] - w[1], torque[0] - torque[1], w[1] - w[2], torque[1]]
    });
}

/// Slopes of the piston's travel by the crank angle: first and second.
fn slopes(theta: f64, r: f64, l: f64) -> [f64; 2] {
    let (s, c) = theta.sin_cos();
    let root = (l * l - r * r * s * s).sqrt();
    [
        -r * s - r * r * s * c / root,
        -r * c - r * r * (c * c - s * s) / root - r.powi(4) * s * s * c * c / root.powi(3),
    ]
}

/// (J + m s'^2) w' = T - b w - m s' s'' w^2 (Lagrange; Shigley and Uicker, *Theory of Machines and Mechanisms*, chapter on engine
/// dynamics).
#[test]
fn lit_slider_crank() {
    let ranges = [("crank.momentum", -6.0, 6.0), ("theta", -4.0, 4.0)];
    are_the_textbook(&found!("slider-crank"), &ranges, |y| {
        let (w, m, j) = (y[0] / 0.05, 0.98496667, 0.05);
        let [s1, s2] = slopes(y[1], 0.04775, 0.144);
        vec![j * (5.0 - 0.02 * w - m * s1 * s2 * w * w) / (j + m * s1 * s1), w]
    });
}

/// The same with spring and damper between slider and piston.
#[test]
fn lit_slider_crank_elastic() {
    let ranges = [
        ("crank.momentum", -6.0, 6.0),
        ("elastic.displacement", -1e-4, 1e-4),
        ("piston.momentum", -4.0, 4.0),
        ("theta", -4.0, 4.0),
    ];
    are_the_textbook(&found!("slider-crank-elastic"), &ranges, |y| {
        let (w, v) = (y[0] / 0.05, y[2] / 0.98496667);
        let [s1, _] = slopes(y[3], 0.04775, 0.144);
        let rate = s1 * w - v;
        let force = 2e8 * y[1] + 200.0 * rate;
        vec![5.0 - 0.02 * w - s1 * force, rate, force, w]
    });
}

/// Two slender links by Lagrange's equations.
#[test]
fn lit_double_pendulum() {
    let (m1, m2, l1, l2, g) = (1.2, 0.8, 0.5, 0.4, 9.81);
    let (j1, j2) = (m1 * l1 * l1 / 12.0, m2 * l2 * l2 / 12.0);
    let ranges = [
        ("turn_1.momentum", -0.2, 0.2),
        ("turn_2.momentum", -0.1, 0.1),
        ("phi_1", -3.0, 3.0),
        ("phi_2", -3.0, 3.0),
    ];
    are_the_textbook(&found!("double-pendulum"), &ranges, |y| {
        let (u, v, a, b) = (y[0] / j1, y[1] / j2, y[2], y[3]);
        let (sin, cos) = (a - b).sin_cos();
        let (first, second) = (m1 * l1 * l1 / 3.0 + m2 * l1 * l1, m2 * l2 * l2 / 3.0);
        let across = 0.5 * m2 * l1 * l2;
        let right = [
            -across * sin * v * v - (0.5 * m1 + m2) * g * l1 * a.sin(),
            across * sin * u * u - 0.5 * m2 * g * l2 * b.sin(),
        ];
        let whole = first * second - (across * cos).powi(2);
        vec![
            j1 * (second * right[0] - across * cos * right[1]) / whole,
            j2 * (first * right[1] - across * cos * right[0]) / whole,
            u,
            v,
        ]
    });
}

/// Newton and Euler for each link, pads at both joints.
#[test]
fn lit_double_pendulum_with_stiff_joints() {
    let (m1, m2, l1, l2, g, k, c) = (1.2, 0.8, 0.5, 0.4, 9.81, 1e6, 200.0);
    let (j1, j2) = (m1 * l1 * l1 / 12.0, m2 * l2 * l2 / 12.0);
    let ranges = [
        ("x_1.momentum", -1.0, 1.0),
        ("y_1.momentum", -1.0, 1.0),
        ("turn_1.momentum", -0.2, 0.2),
        ("x_2.momentum", -1.0, 1.0),
        ("y_2.momentum", -1.0, 1.0),
        ("turn_2.momentum", -0.1, 0.1),
        ("spring_ux.displacement", -1e-4, 1e-4),
        ("spring_uy.displacement", -1e-4, 1e-4),
        ("spring_lx.displacement", -1e-4, 1e-4),
        ("spring_ly.displacement", -1e-4, 1e-4),
        ("phi_1", -3.0, 3.0),
        ("phi_2", -3.0, 3.0),
    ];
    are_the_textbook(&found!("double-pendulum-stiff"), &ranges, |y| {
        let (w1, w2) = (y[2] / j1, y[5] / j2);
        let (one, two) = ([y[0] / m1, y[1] / m1], [y[3] / m2, y[4] / m2]);
        let half = |l: f64, angle: f64| [0.5 * l * angle.cos(), 0.5 * l * angle.sin()];
        let (a, b) = (half(l1, y[10]), half(l2, y[11]));
        // Velocities of the upper end of the first, and of the lower end of the first less the upper of the second.
        let upper = [0, 1].map(|i| one[i] - a[i] * w1);
        let lower = [0, 1].map(|i| one[i] + a[i] * w1 - two[i] + b[i] * w2);
        let top = [0, 1].map(|i| k * y[6 + i] + c * upper[i]);
        let joint = [0, 1].map(|i| k * y[8 + i] + c * lower[i]);
        vec![
            -top[0] - joint[0],
            -top[1] - joint[1] - m1 * g,
            a[0] * (top[0] - joint[0]) + a[1] * (top[1] - joint[1]),
            joint[0],
            joint[1] - m2 * g,
            -b[0] * joint[0] - b[1] * joint[1],
            upper[0],
            upper[1],
            lower[0],
            lower[1],
            w1,
            w2,
        ]
    });
}

/// Eqs. 3.23 to 3.31 of Singh with one normal for both contacts.
#[test]
fn lit_singh_prismatic_pair() {
    let ranges = [
        ("mass_cx.momentum", -5.0, 5.0),
        ("mass_cy.momentum", -5.0, 5.0),
        ("inertia_c.momentum", -0.01, 0.01),
        ("mass_px.momentum", -3.0, 3.0),
        ("mass_py.momentum", -3.0, 3.0),
        ("inertia_p.momentum", -0.02, 0.02),
        ("skirt_1.displacement", -1e-3, 1e-3),
        ("skirt_2.displacement", -1e-3, 1e-3),
        ("x_c", -0.1, 0.1),
        ("y_c", -0.1, 0.1),
        ("th_c", -3.0, 3.0),
        ("x_p", 0.1, 0.3),
        ("y_p", -0.1, 0.1),
        ("th_p", -3.0, 3.0),
    ];
    are_the_textbook(&found!("prismatic-pair"), &ranges, |y| {
        let (vc, wc) = ([y[0] / 5.0, y[1] / 5.0], y[2] / 0.003);
        let (vp, wp) = ([y[3] / 2.0, y[4] / 2.0], y[5] / 0.002);
        let (th_c, th_p) = (y[10], y[13]);
        // The normal of the cylinder, and each contact on the piston's axis.
        let normal = [-th_c.sin(), th_c.cos()];
        let (mut on_c, mut on_p, mut gaps) = ([0.0; 3], [0.0; 3], [0.0; 2]);
        for (contact, b) in [-0.1, 0.0].into_iter().enumerate() {
            let place = [y[11] + b * th_p.cos(), y[12] + b * th_p.sin()];
            let from_c = [place[0] - y[8], place[1] - y[9]];
            let along = th_c.cos() * from_c[0] + th_c.sin() * from_c[1];
            // Rate of the distance across the cylinder as the textbook's: normal velocities of piston and cylinder at the contact.
            let piston = normal[0] * vp[0] + normal[1] * vp[1] + b * (th_p - th_c).cos() * wp;
            let cylinder = normal[0] * vc[0] + normal[1] * vc[1] + along * wc;
            gaps[contact] = piston - cylinder;
            let force = 1e5 * y[6 + contact];
            for i in 0..2 {
                on_p[i] -= force * normal[i];
                on_c[i] += force * normal[i];
            }
            on_p[2] -= force * b * (th_p - th_c).cos();
            on_c[2] += force * along;
        }
        vec![
            on_c[0], on_c[1], on_c[2], on_p[0], on_p[1], on_p[2], gaps[0], gaps[1], vc[0], vc[1], wc, vp[0],
            vp[1], wp,
        ]
    });
}

/// Crank, slider and a closed charge of perfect gas: Lagrange's equation with the gas force, E' = -p V'.
#[test]
fn lit_single_cylinder() {
    let ranges = [
        ("wheel.momentum", 5.0, 15.0),
        // What the piston took of the volume, mass, energy.
        ("gas.1.displacement", 0.0, 4e-4),
        ("gas.2.displacement", 4e-4, 6e-4),
        ("gas.3.displacement", 100.0, 200.0),
        ("theta", -3.0, 3.0),
    ];
    are_the_textbook(&found!("single-cylinder"), &ranges, |y| {
        let (j, m, area) = (0.12, 0.6, 0.005);
        let w = y[0] / j;
        let [s1, s2] = slopes(y[4], 0.045, 0.15);
        let pressure = 287.0 * y[3] / (718.0 * (5e-5 + 0.09 * area - y[1]));
        let piston = area * (1e5 - pressure) - 4.0 * s1 * w;
        let taken = area * s1 * w;
        let torque = s1 * piston - 0.004 * w - m * s1 * s2 * w * w;
        vec![j * torque / (j + m * s1 * s1), taken, 0.0, pressure * taken, w]
    });
}
