//! Periodic motions of plain graphs: closed forms, a published limit cycle, and what happens where there is none.

use lanchester_bondgraph::{Graph, PeriodicEnd, Simulation, equations};

fn run(text: &str) -> Simulation {
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    found.simulate(&found.request())
}

fn codes(text: &str) -> Vec<&'static str> {
    Graph::read(text).expect_err("it has a mistake").iter().map(|mistake| mistake.code).collect()
}

const FORCED: &str = r#"
name = "forced"
[elements]
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1.2 kg" }
k = { kind = "C", stiffness = "250 N/m" }
r = { kind = "R", resistance = "3 N s/m" }
push = { kind = "MSe", effort = "10 N*cos(20 rad/s*t)" }
[bonds]
list = ["push > v", "v > m", "v > k", "v > r"]
[simulation]
duration = "periodic"
period = "0.31415926535897932 s"
samples = 64
"#;

/// x = Re F e^(i w t) / (k - m w^2 + i r w); the multipliers are exp(poles T).
#[test]
fn a_forced_oscillator_has_its_closed_form() {
    let run = run(FORCED);
    let motion = run.periodic.as_ref().expect("it was asked for");
    assert_eq!(motion.outcome, PeriodicEnd::Stable, "{motion:?}");
    let (m, r, k, w) = (1.2, 3.0, 250.0, 20.0);
    let (real, imaginary) = (k - m * w * w, r * w);
    let size = real * real + imaginary * imaginary;
    let x = run.values("k.displacement").expect("its place");
    for (t, x) in run.time.iter().zip(x) {
        let (sin, cos) = (w * t).sin_cos();
        let exact = 10.0 * (real * cos + imaginary * sin) / size;
        assert!((x - exact).abs() < 1e-9 * 10.0 / size.sqrt(), "{t}: {x} against {exact}");
    }
    let period = std::f64::consts::PI / 10.0;
    let exact = (-r / (2.0 * m) * period).exp();
    for [a, b] in &motion.multipliers {
        assert!((a.hypot(*b) - exact).abs() < 1e-7, "{a} {b} against {exact}");
    }
}

/// Period and amplitude of van der Pol's oscillator, mu = 1: 6.66328685933 and 2.00861986087 (Andersen, Geer, SIAM J. Appl. Math. 42 (1982); digits
/// by Amore, arXiv:1501.03129). The period is not known before.
#[test]
fn lit_limit_cycle_of_van_der_pol() {
    let text = r#"
name = "van-der-pol"
[elements]
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "1 kg", flow = "1.9 m/s" }
k = { kind = "C", stiffness = "1 N/m", displacement = "0.1 m" }
r = { kind = "MR", effort = "1 N s/m*((k.displacement/(1 m))^2 - 1)*f" }
[bonds]
list = ["v > m", "v > k", "v > r"]
[simulation]
duration = "periodic"
period = "0 m of k.displacement"
samples = 2000
"#;
    let run = run(text);
    let motion = run.periodic.as_ref().expect("it was asked for");
    assert_eq!(motion.outcome, PeriodicEnd::Stable, "{motion:?}");
    assert!((motion.period - 6.66328685933).abs() < 1e-9, "{}", motion.period);
    let x = run.values("k.displacement").expect("its place");
    let most = x.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    assert!((most - 2.00861986087).abs() < 1e-5, "{most}");
    // The other multiplier: exp of the integral of the damping over a period.
    assert_eq!(motion.multipliers.len(), 1);
    let mean = x[..x.len() - 1].iter().map(|x| 1.0 - x * x).sum::<f64>() / (x.len() - 1) as f64;
    let exact = (mean * motion.period).exp();
    assert!((motion.multipliers[0][0] - exact).abs() < 1e-4 * exact, "{:?} {exact}", motion.multipliers);
}

/// Charge that nothing can leave with stays: of all periodic motions the one with the charge of the start.
#[test]
fn what_is_conserved_keeps_its_start() {
    let text = r#"
name = "closed"
[elements]
a = { kind = "0", domain = "electric" }
b = { kind = "0", domain = "electric" }
loop = { kind = "1", domain = "electric" }
one = { kind = "C", capacitance = "2 F", effort = "3 V" }
two = { kind = "C", capacitance = "1 F" }
r = { kind = "R", resistance = "0.4 Ohm" }
u = { kind = "MSe", effort = "1 V*sin(6.283185307179586 rad/s*t)" }
[bonds]
list = ["a > one", "b > two", "a > loop", "loop > b", "loop > r", "u > loop"]
[simulation]
duration = "periodic"
period = "1 s"
"#;
    let run = run(text);
    let motion = run.periodic.as_ref().expect("it was asked for");
    assert_eq!(motion.outcome, PeriodicEnd::Neutral, "{motion:?}");
    let of = |name: &str| run.values(name).expect("its charge")[0];
    let charge = of("one.displacement") + of("two.displacement");
    assert!((charge - 6.0).abs() < 1e-9, "{charge}");
}

#[test]
fn what_happened_instead_is_said() {
    let text = r#"
name = "driven"
[elements]
v = { kind = "1", domain = "translation" }
m = { kind = "I", inertia = "2 kg" }
push = { kind = "Se", effort = "3 N" }
[bonds]
list = ["push > v", "v > m"]
[simulation]
duration = "periodic"
period = "2 s"
"#;
    let found = run(text);
    let motion = found.periodic.as_ref().expect("it was asked for");
    assert_eq!(motion.outcome, PeriodicEnd::NotFound);
    assert!(!found.complete);
    let said = motion.instead.as_deref().expect("it is said");
    assert!(said.contains("m.momentum grows by 6") && said.contains("not in balance"), "{said}");
    // An angle that does not advance.
    let still =
        text.replace("[bonds]", "[signals]\nx = { integral_of = \"v.flow\", start = \"0 m\" }\n[bonds]");
    let found = run(&still.replace("2 s", "1 m of x"));
    let said = found.periodic.and_then(|motion| motion.instead).expect("it is said");
    assert!(said.contains("x does not advance at the start"), "{said}");
}

#[test]
fn a_period_has_its_mistakes() {
    assert_eq!(codes(&FORCED.replace("period = \"0.31415926535897932 s\"\n", "")), ["E1709"]);
    assert_eq!(codes(&FORCED.replace("0.31415926535897932 s", "2 m")), ["E1705"]);
    assert_eq!(codes(&FORCED.replace("0.31415926535897932 s", "-2 s")), ["E1712"]);
    assert_eq!(codes(&FORCED.replace("0.31415926535897932 s", "2 m of k.flow")), ["E1706"]);
    assert_eq!(codes(&FORCED.replace("0.31415926535897932 s", "2 rad of k.displacement")), ["E1705"]);
}
