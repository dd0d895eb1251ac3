//! Causality of textbook graphs: which stores are states, which follow, which loops are left and where they are cut.
//!
//! Graphs as in Karnopp, Margolis, Rosenberg, *System Dynamics*, 5th edition, chapters 3 to 5, and loops by the kinds of van Dijk and
//! Breedveld, Journal of the Franklin Institute 328 (1991), 747-764: between stores, between a store and a source, between resistors,
//! and within the junction structure.

use crate::causality::graph;
use lanchester_bondgraph::{AlgebraicLoop, Graph, Preference, causality, equations};

/// What it is, elements, bonds, states, followers, loops as `elements: variables that cut it`.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str, &'static str);

/// No loop.
const NONE: &str = "";

const CASES: [Case; 36] = [
    ("mass, spring, damper", "s: Se, j: 1, m: I, k: C, d: R", "s > j, j > m, j > k, j > d", "m k", "", NONE),
    ("parallel circuit", "s: Sf, j: 0, m: I, k: C, d: R", "s > j, j > m, j > k, j > d", "m k", "", NONE),
    ("two masses as one", "s: Se, j: 1, m: I, n: I", "s > j, j > m, j > n", "m", "n", NONE),
    ("two capacitors as one", "s: Sf, j: 0, k: C, l: C", "s > j, j > k, j > l", "k", "l", NONE),
    ("mass at imposed speed", "s: Sf, j: 1, m: I", "s > j, j > m", "", "m", NONE),
    ("capacitor on a battery", "s: Se, j: 0, k: C", "s > j, j > k", "", "k", NONE),
    ("divider", "s: Se, j: 1, r: R, o: 0, q: R", "s > j, j > r, j > o, o > q", "", "", "j r o q: r.effort"),
    ("resistor on a battery", "s: Se, j: 1, r: R", "s > j, j > r", "", "", NONE),
    ("resistor in a stream", "s: Sf, j: 0, r: R", "s > j, j > r", "", "", NONE),
    (
        "masses on a lever",
        "s: Se, j: 1, m: I, t: TF, g: 1, n: I",
        "s > j, j > m, j > t.1, t.2 > g, g > n",
        "m",
        "n",
        NONE,
    ),
    (
        "mass and spring on a lever",
        "s: Se, j: 1, m: I, t: TF, g: 1, k: C",
        "s > j, j > m, j > t.1, t.2 > g, g > k",
        "m k",
        "",
        NONE,
    ),
    (
        "motor with coil and rotor",
        "s: Se, j: 1, m: I, y: GY, g: 1, n: I",
        "s > j, j > m, j > y.1, y.2 > g, g > n",
        "m n",
        "",
        NONE,
    ),
    (
        "motor that winds a spring",
        "s: Se, j: 1, m: I, y: GY, g: 1, k: C",
        "s > j, j > m, j > y.1, y.2 > g, g > k",
        "m",
        "k",
        NONE,
    ),
    (
        "motor with resistor, coil, rotor and friction",
        "s: Se, j: 1, m: I, r: R, y: GY, g: 1, n: I, d: R",
        "s > j, j > m, j > r, j > y.1, y.2 > g, g > n, g > d",
        "m n",
        "",
        NONE,
    ),
    (
        "two gyrators are a transformer",
        "s: Se, j: 1, m: I, y: GY, o: 1, z: GY, g: 1, n: I",
        "s > j, j > m, j > y.1, y.2 > o, o > z.1, z.2 > g, g > n",
        "m",
        "n",
        NONE,
    ),
    (
        "two capacitors on a gyrator",
        "a: 0, k: C, y: GY, b: 0, l: C",
        "a > k, a > y.1, y.2 > b, b > l",
        "k l",
        "",
        NONE,
    ),
    (
        "two masses on spring and damper",
        "a: 1, m: I, o: 0, b: 1, k: C, d: R, c: 1, n: I",
        "a > m, a > o, o > b, b > k, b > d, o > c, c > n",
        "m k n",
        "",
        NONE,
    ),
    (
        "two masses on a damper alone",
        "a: 1, m: I, o: 0, d: R, c: 1, n: I",
        "a > m, a > o, o > d, o > c, c > n",
        "m n",
        "",
        NONE,
    ),
    (
        "quarter of a car",
        "road: Sf, o: 0, tyre: C, w: 1, wheel: I, g: Se, p: 0, u: 1, k: C, d: R, b: 1, body: I, h: Se",
        "road > o, o > tyre, o > w, w > wheel, g > w, w > p, p > u, u > k, u > d, p > b, b > body, h > b",
        "tyre wheel k body",
        "",
        NONE,
    ),
    (
        "three capacitors in a triangle",
        "s: Sf, a: 0, k: C, ab: 1, l: C, b: 0, n: C",
        "s > a, a > k, a > ab, ab > l, ab > b, b > n",
        "k l",
        "n",
        NONE,
    ),
    (
        "three inertias in a differential",
        "a: 1, m: I, o: 0, b: 1, n: I, c: 1, p: I",
        "a > m, a > o, o > b, b > n, o > c, c > p",
        "m n",
        "p",
        NONE,
    ),
    (
        "ladder of three resistors and capacitors",
        "s: Se, a: 1, r: R, o: 0, k: C, b: 1, q: R, p: 0, l: C, c: 1, x: R, z: 0, n: C",
        "s > a, a > r, a > o, o > k, o > b, b > q, b > p, p > l, p > c, c > x, c > z, z > n",
        "k l n",
        "",
        NONE,
    ),
    (
        "ladder of a coil, a capacitor and a load",
        "s: Se, a: 1, m: I, o: 0, k: C, r: R",
        "s > a, a > m, a > o, o > k, o > r",
        "m k",
        "",
        NONE,
    ),
    ("friction of Coulomb", "s: Se, j: 1, m: I, e: Re", "s > j, j > m, j > e", "m", "", NONE),
    ("turbulent outlet", "s: Sf, j: 0, k: C, e: Rf", "s > j, j > k, j > e", "k", "", NONE),
    (
        "hardening spring, relativistic mass",
        "s: Se, j: 1, k: Cq, m: Ip, d: R",
        "s > j, j > m, j > k, j > d",
        "m k",
        "",
        NONE,
    ),
    (
        "law of one form behind a loop",
        "s: Se, j: 1, r: Rf, d: R, k: C",
        "s > j, j > r, j > d, j > k",
        "k",
        "",
        "j r d: r.effort",
    ),
    (
        "divider before a capacitor",
        "s: Se, a: 1, r: R, o: 0, q: R, b: 1, p: R, z: 0, k: C",
        "s > a, a > r, a > o, o > q, o > b, b > p, b > z, z > k",
        "k",
        "",
        "a r o q b p: r.effort",
    ),
    (
        "mass that follows through a divider of flows",
        "s: Sf, a: 0, r: R, b: 1, q: R, m: I",
        "s > a, a > r, a > b, b > q, b > m",
        "m",
        "",
        NONE,
    ),
    (
        "bridge of Wheatstone",
        "s: Se, a: 0, ab: 1, r1: R, b: 0, r3: R, ac: 1, r2: R, c: 0, r4: R, bc: 1, r5: R",
        "s > a, a > ab, ab > r1, ab > b, b > r3, a > ac, ac > r2, ac > c, c > r4, b > bc, bc > r5, bc > c",
        "",
        "",
        "ab r1 b r3 ac r2 c r4 bc r5: r1.effort and r2.effort",
    ),
    (
        "two resistors behind a gyrator",
        "s: Se, j: 1, r: R, y: GY, g: 1, q: R",
        "s > j, j > r, j > y.1, y.2 > g, g > q",
        "",
        "",
        "j r y g q: r.effort",
    ),
    (
        "two levers side by side, resistor",
        "s: Se, a: 1, t: TF, u: TF, o: 0, r: R",
        "s > a, a > t.1, t.2 > o, a > u.1, u.2 > o, o > r",
        "",
        "",
        "a t u o: t.1.effort; a t u o: t.1.flow",
    ),
    (
        "two levers side by side, spring",
        "s: Se, a: 1, t: TF, u: TF, o: 0, k: C",
        "s > a, a > t.1, t.2 > o, a > u.1, u.2 > o, o > k",
        "",
        "k",
        "a t u o: t.1.effort; a t u o: t.1.flow",
    ),
    (
        "two levers side by side, mass",
        "s: Se, a: 1, t: TF, u: TF, o: 0, m: I",
        "s > a, a > t.1, t.2 > o, a > u.1, u.2 > o, o > m",
        "m",
        "",
        "a t u o: t.1.effort; a t u o: t.1.flow",
    ),
    (
        "mass at imposed speed behind a lever",
        "s: Sf, t: TF, j: 1, m: I, d: R",
        "s > t.1, t.2 > j, j > m, j > d",
        "",
        "m",
        NONE,
    ),
    (
        "two outputs of one motion",
        "s: Se, a: 1, m: I, t: TFm, n: I, k: C",
        "s > a, a > m, a > t.1, t.2 > n, t.3 > k",
        "m k",
        "n",
        NONE,
    ),
];

fn sorted(names: &[String]) -> String {
    let mut names: Vec<&str> = names.iter().map(String::as_str).collect();
    names.sort_unstable();
    names.join(" ")
}

fn in_order(text: &str) -> String {
    sorted(&text.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
}

#[test]
fn lit_textbook_graphs_have_their_states_followers_and_loops() {
    let mut wrong = Vec::new();
    for (what, elements, bonds, states, followers, loops) in CASES {
        let found = causality(&graph(elements, bonds), Preference::Integral)
            .unwrap_or_else(|mistakes| panic!("{what}: {mistakes:#?}"));
        let names: Vec<String> = found.followers.iter().map(|own| own.element.clone()).collect();
        let told: Vec<String> = found.loops.iter().map(told).collect();
        let got = [sorted(&found.states), sorted(&names), told.join("; ")];
        let want = [in_order(states), in_order(followers), loops.to_owned()];
        if got != want {
            wrong.push(format!("{what}: {got:?}, not {want:?}"));
        }
        // Every one of them has equations: its loops are regular.
        equations(&graph(elements, bonds)).unwrap_or_else(|mistakes| panic!("{what}: {mistakes:#?}"));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn told(own: &AlgebraicLoop) -> String {
    format!("{}: {}", own.elements.join(" "), own.cut_at.join(" and "))
}

/// Value of a quantity at the start of a run.
fn first(graph: &Graph, name: &str) -> f64 {
    let found = equations(graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let run = found.simulate(&found.request());
    assert!(run.complete, "{}", run.ended);
    run.values(name).unwrap_or_else(|| panic!("no {name}"))[0]
}

/// Resistors of 1, 2, 3, 4 and 5 ohm in a bridge on 1 V, by Kirchhoff's laws: nodes b and c.
#[test]
fn an_unbalanced_bridge_has_the_currents_of_kirchhoff() {
    let law = |name: &str, ohm: u32| format!("{name} = {{ kind = \"R\", resistance = \"{ohm} Ohm\" }}\n");
    let resistors: String = (1..=5).map(|k| law(&format!("r{k}"), k)).collect();
    let junction =
        |name: &str, kind: &str| format!("{name} = {{ kind = \"{kind}\", domain = \"electric\" }}\n");
    let junctions: String = ["a", "b", "c"]
        .map(|name| junction(name, "0"))
        .into_iter()
        .chain(["ab", "ac", "bc"].map(|name| junction(name, "1")))
        .collect();
    let text = format!(
        "[elements]\ns = {{ kind = \"Se\", effort = \"1 V\" }}\n{junctions}{resistors}[bonds]\nlist = [\"s > a\", \"a > ab\", \
         \"ab > r1\", \"ab > b\", \"b > r3\", \"a > ac\", \"ac > r2\", \"ac > c\", \"c > r4\", \"b > bc\", \"bc > r5\", \"bc > c\"]\n"
    );
    let graph = Graph::read(&text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    // (1 + 1/3 + 1/5) b - 1/5 c = 1, -1/5 b + (1/2 + 1/4 + 1/5) c = 1/2
    let (p, q, r) = (1.0 + 1.0 / 3.0 + 0.2, 0.2, 0.95);
    let whole = p * r - q * q;
    let (b, c) = ((r + 0.5 * q) / whole, (0.5 * p + q) / whole);
    for (name, want) in [
        ("r3.effort", b),
        ("r4.effort", c),
        ("r5.flow", (b - c) / 5.0),
        ("s.flow", 1.0 - b + (1.0 - c) / 2.0),
    ] {
        let got = first(&graph, name);
        assert!((got - want).abs() < 1e-14, "{name}: {got}, not {want}");
    }
}

/// Two levers of 2 and 3 give their flows to one resistor of 2: 5 f there, 1 N back at the start: f = 1/(5 5 2).
#[test]
fn a_loop_within_the_junctions_is_solved() {
    let text = "[elements]\ns = { kind = \"Se\", effort = \"1 N\" }\na = { kind = \"1\", domain = \"translation\" }\n\
                t = { kind = \"TF\", ratio = \"2\" }\nu = { kind = \"TF\", ratio = \"3\" }\no = { kind = \"0\", domain = \"translation\" }\n\
                r = { kind = \"R\", resistance = \"2 N s/m\" }\n[bonds]\n\
                list = [\"s > a\", \"a > t.1\", \"t.2 > o\", \"a > u.1\", \"u.2 > o\", \"o > r\"]\n";
    let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    assert!((first(&graph, "s.flow") - 1.0 / 50.0).abs() < 1e-15);
    assert!((first(&graph, "r.effort") - 0.2).abs() < 1e-15);
    // With -2 and 2 nothing reaches the resistor whatever the source's flow: no flow balances its force.
    let singular = text.replace("ratio = \"3\"", "ratio = \"-2\"");
    let graph = Graph::read(&singular).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let mistakes = equations(&graph).expect_err("the loop is singular");
    assert!(mistakes.iter().all(|mistake| mistake.code == "E1714"), "{mistakes:?}");
    assert!(mistakes[0].message.contains("is singular"), "{mistakes:?}");
}
