//! Bad graph files: every mistake at once, with its place and a hint; never a panic, never a hang.

use lanchester_bondgraph::{Graph, SimulationRequest, equations};

const GOOD: &str = include_str!("../../../../examples/bond-graphs/slider-crank.toml");

#[test]
fn one_change_one_diagnostic_with_place_and_hint() {
    let cases = [
        ("kind = \"Se\"", "kind = \"Sx\"", "E1702", "no kind of element"),
        ("effort = \"5 N m\"", "effort = \"5 N\"", "E1705", "needs a value in N m"),
        ("effort = \"5 N m\"", "effort = \"5\"", "E1705", "got `5` in 1"),
        ("effort = \"5 N m\"", "", "E1709", "no law"),
        ("resistance = \"0.02 N m s\"", "resistance = \"0.02 N m s", "E1701", "TOML"),
        ("resistance = \"0.02 N m s\"", "resistance = \"-0.02 N m s\"", "E1712", "positive"),
        ("inertia = \"m\"", "inertia = \"mm\"", "E1706", "`mm` is not known"),
        ("inertia = \"m\"", "inertia = \"m*(2\"", "E1704", "closing bracket"),
        ("inertia = \"m\"", "inertia = \"0 kg\"", "E1712", "positive"),
        ("\"motor > shaft\"", "\"motor > shat\"", "E1707", "no element `shat`"),
        ("\"motor > shaft\"", "\"motor shaft\"", "E1707", "no bond"),
        ("\"shaft > rub\"", "\"rub > shaft\"", "E1708", "half arrow"),
        ("\"shaft > rub\", ", "", "E1708", "`rub` has no bond"),
        ("\"shaft > rub\"", "\"shaft > rub\", \"guide > rub\"", "E1708", "bonded twice"),
        ("\"slider.2 > guide\"", "\"slider.3 > guide\"", "E1707", "no port"),
        ("domain = \"translation\"", "domain = \"motion\"", "E1702", "no domain"),
        ("domain = \"translation\"", "", "E1710", "not known"),
        ("\"slider.2 > guide\"", "\"slider.2 > guide\", \"guide > shaft\"", "E1710", "joins"),
        ("start = \"0.3 rad\"", "start = \"0.3 m\"", "E1705", "starts in m"),
        ("integral_of = \"shaft.flow\", start = \"0.3 rad\"", "value = \"theta\"", "E1711", "needs itself"),
        ("integral_of = \"shaft.flow\"", "integral_of = \"shaft.effort\"", "E1706", "has one flow"),
        ("r = \"47.75 mm\"", "r = \"l\"\nl2 = \"r + l3\"\nl3 = \"l2\"", "E1711", "needs itself"),
        ("l = \"144 mm\"", "l = \"144 mm\"\ncrank = \"1\"", "E1703", "given twice"),
        ("l = \"144 mm\"", "l = \"144 mm\"\ne = \"1\"", "E1703", "meaning of its own"),
        ("sqrt(l^2", "sqrt(l^2 + r", "E1705", "m2 plus m"),
        ("sin(theta)^2)", "sin(r)^2)", "E1705", "sin of m"),
        ("duration = \"1 s\"", "duration = \"1 m\"", "E1705", "needs s"),
        ("samples = 500", "samples = 1e9", "E1712", "out of range"),
    ];
    for (from, to, code, words) in cases {
        assert!(GOOD.contains(from), "{from}");
        let text = GOOD.replacen(from, to, 1);
        let mistakes = Graph::read(&text).expect_err(to);
        let found = mistakes.iter().find(|mistake| mistake.code == code && mistake.message.contains(words));
        let Some(found) = found else { panic!("{to}: no {code} with \"{words}\" in {mistakes:#?}") };
        assert!(found.line > 1 && found.hint.is_some(), "{found:?}");
        // An element whose bond cannot be read has none.
        let follows =
            |code: &str| code == "E1708" && matches!(words, "no element `shat`" | "no bond" | "no port");
        let others: Vec<_> = mistakes.iter().filter(|own| own.code != code && !follows(own.code)).collect();
        // Behind a mistake of the syntax entries are lost.
        assert!(others.is_empty() || code == "E1701" || words == "bonded twice", "{to}: {others:#?}");
    }
}

/// Codes of all mistakes of a text, in their order.
fn codes(text: &str) -> Vec<(&'static str, String)> {
    let mistakes = Graph::read(text).expect_err("it has mistakes");
    let mut codes: Vec<_> = mistakes.into_iter().map(|own| (own.code, own.message)).collect();
    codes.sort();
    codes
}

/// What can be known is told at once, and nothing that only follows from another mistake.
#[test]
fn several_mistakes_are_told_at_once() {
    let text = (GOOD.replace("inertia = \"m\"", "inertia = \"mass\""))
        .replace("5 N m", "5 V")
        .replace("shaft > rub", "shaft > rob")
        .replace("l = \"144 mm\"", "l = \"144 furlong\"")
        .replace("start = \"0.3 rad\"", "start = \"0.3 rads\"");
    let found = codes(&text);
    let want = [
        ("E1704", "furlong"),
        ("E1704", "`0.3 rads` cannot be read"),
        ("E1705", "`motor` needs a value in N m"),
        ("E1706", "`mass` is not known"),
        ("E1707", "no element `rob`"),
        ("E1708", "`rub` has no bond"),
    ];
    assert_eq!(found.len(), want.len(), "{found:#?}");
    for (code, words) in want {
        assert!(found.iter().any(|(own, message)| *own == code && message.contains(words)), "{found:#?}");
    }
    // A domain that is not known, a law that lacks, a number that cannot be, signals in a circle.
    let found = codes(
        r#"
name = "several"
[elements]
a = { kind = "Se", effort = "1 N" }
b = { kind = "1", domain = "translation" }
c = { kind = "C", capacitance = "-1 m/N" }
g = { kind = "TF", ratio = "0" }
h = { kind = "I" }
x = { kind = "Sx" }
[signals]
s1 = { value = "s2 + x.effort + h.flow" }
s2 = { value = "s1" }
[bonds]
list = ["a > b", "b > c", "b > g.1", "g.2 > h"]
"#,
    );
    let found: Vec<&str> = found.iter().map(|(code, _)| *code).collect();
    // Of the domain behind `g` nothing is said: the kind of `x` may be what lacks there.
    assert_eq!(found, ["E1702", "E1709", "E1711", "E1712"]);
}

/// An integral whose start is a plain 0 may contain itself: its unit is that of the rest.
#[test]
fn an_integral_without_a_unit_may_contain_itself() {
    let text = |integrand: &str| {
        GOOD.replace("[bonds]", &format!("x = {{ integral_of = \"{integrand}\", start = \"0\" }}\n\n[bonds]"))
    };
    let found =
        equations(&Graph::read(&text("guide.flow - x/(0.5 s)")).expect("x in m")).expect("no conflict");
    let run = found.simulate(&SimulationRequest { tolerance: 1e-11, ..found.request() });
    let unit = run.series.iter().find(|own| own.name == "x").map(|own| own.unit.clone());
    assert_eq!(unit.as_deref(), Some("m"));
    // x' + 2 x = v, so that x + 2 times its integral is the way of the piston: checked by its rate at the end.
    let (x, v) = (run.values("x").expect("x"), run.values("guide.flow").expect("v"));
    let (n, h) = (x.len() - 3, run.time[1]);
    let rate = (x[n - 2] - 8.0 * x[n - 1] + 8.0 * x[n + 1] - x[n + 2]) / (12.0 * h);
    assert!((rate - (v[n] - 2.0 * x[n])).abs() < 1e-2 * v[n].abs().max(1.0), "{rate} {}", v[n] - 2.0 * x[n]);
    // Now each part is checked: a length is no speed.
    assert_eq!(codes(&text("guide.flow - x")).iter().map(|own| own.0).collect::<Vec<_>>(), ["E1705"]);
    // Through another signal the unit cannot be known.
    let other = text("guide.flow - y").replace("[bonds]", "y = { value = \"x/(1 s)\" }\n\n[bonds]");
    let found = codes(&other);
    assert!(found[0].1.contains("the unit of `x` is not known"), "{found:#?}");
}

#[test]
fn hostile_texts_neither_panic_nor_hang() {
    let deep = format!("a = \"{}1{}\"", "(".repeat(500), ")".repeat(500));
    let long = format!("a = \"1{}\"", "+1".repeat(10_000));
    let tower = format!("a = \"2{}\"", "^2".repeat(300));
    for parameter in [&deep, &long, &tower] {
        let text = GOOD.replacen("r = \"47.75 mm\"", &format!("r = \"47.75 mm\"\n{parameter}"), 1);
        assert!(Graph::read(&text).is_err());
    }
    // Every text that is cut off anywhere, and every one with a byte gone, is read or refused.
    for at in (0..GOOD.len()).step_by(7) {
        let _ = Graph::read(&GOOD[..at]);
        let without = format!("{}{}", &GOOD[..at], &GOOD[at + 1..]);
        if let Ok(graph) = Graph::read(&without) {
            let _ = equations(&graph);
        }
    }
}

fn run(change: (&str, &str), most: u64) -> lanchester_bondgraph::Simulation {
    let text = GOOD.replacen(change.0, change.1, 1);
    let graph = Graph::read(&text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).expect("no conflict");
    let request = SimulationRequest { most_evaluations: most, ..found.request() };
    found.simulate(&request)
}

#[test]
fn a_run_that_cannot_go_on_says_where_and_keeps_its_samples() {
    // The resistance becomes infinite at half a second.
    let late =
        run(("resistance = \"0.02 N m s\"", "effort = \"0.02 N m s*f/sqrt(1 - t/(0.5 s))\""), 1_000_000);
    assert!(!late.complete && late.ended.contains("0.5") || late.ended.contains("0.49"), "{}", late.ended);
    assert!(late.time.len() > 200 && late.time.len() < 260, "{}", late.time.len());
    assert!(late.series.iter().all(|series| series.values.iter().all(|value| value.is_finite())));
    let short = run(("", ""), 100);
    assert!(!short.complete && short.ended.contains("evaluations"), "{}", short.ended);
}

/// Words of the shipped graphs, exchanged, dropped and doubled at random, with a generator of fixed seed: read, formulated,
/// simulated with bounded work and exported, without panic.
#[test]
fn prop_mutated_graphs_are_refused_or_run() {
    let texts = [
        GOOD,
        include_str!("../../../../examples/bond-graphs/dc-motor.toml"),
        include_str!("../../../../examples/bond-graphs/two-tanks-turbulent.toml"),
        include_str!("../../../../examples/bond-graphs/torsion-chain.toml"),
    ];
    let mut seed = 0x2545_f491_4f6c_dd1du64;
    let mut draw = |below: usize| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as usize % below.max(1)
    };
    let (mut good, mut bad, mut conflicts) = (0, 0, 0);
    for _ in 0..3000 {
        let text = texts[draw(texts.len())];
        let mut words: Vec<String> =
            text.split_inclusive([' ', '"', '\n', '.', '*']).map(str::to_owned).collect();
        for _ in 0..=draw(3) {
            let (a, b) = (draw(words.len()), draw(words.len()));
            match draw(4) {
                0 => words.swap(a, b),
                1 => words[a] = words[b].clone(),
                2 => words[a].clear(),
                _ => words[a] = words[a].replace(['1', '5'], "-3"),
            }
        }
        match Graph::read(&words.concat()) {
            Err(mistakes) => {
                assert!(!mistakes.is_empty());
                bad += 1;
            }
            Ok(graph) => match equations(&graph) {
                Err(mistakes) => {
                    assert!(!mistakes.is_empty());
                    conflicts += 1;
                }
                Ok(found) => {
                    let request = SimulationRequest {
                        most_evaluations: 2000,
                        samples: 5,
                        audit: true,
                        ..found.request()
                    };
                    let run = found.simulate(&request);
                    assert!(
                        !run.time.is_empty() && !run.ended.is_empty(),
                        "{}\n{}",
                        run.ended,
                        words.concat()
                    );
                    let _ = (found.linear(), lanchester_bondgraph::modelica(&found));
                    let _ = found.shown(lanchester_bondgraph::Notation::Latex);
                    let _ = lanchester_bondgraph::drawing(&graph, &found.causality);
                    good += 1;
                }
            },
        }
    }
    assert!(good > 200 && bad > 200, "{good} good, {bad} bad, {conflicts} conflicts");
}

/// A lever whose ratio has a pole after a second: the run ends there and names it.
#[test]
fn a_modulus_that_becomes_infinite_is_named() {
    let text = "[elements]\npush = { kind = \"Se\", effort = \"1 N\" }\na = { kind = \"1\", domain = \"translation\" }\n\
                mass = { kind = \"I\", inertia = \"1 kg\" }\nlever = { kind = \"MTF\", ratio = \"1/sqrt(1 - t/(1 s))\" }\n\
                b = { kind = \"1\", domain = \"translation\" }\noil = { kind = \"R\", resistance = \"1e-3 N s/m\" }\n[bonds]\n\
                list = [\"push > a\", \"a > mass\", \"a > lever.1\", \"lever.2 > b\", \"b > oil\"]\n[simulation]\nduration = \"2 s\"\n";
    let found = equations(&Graph::read(text).expect("good")).expect("no conflict");
    let run = found.simulate(&found.request());
    assert!(!run.complete && run.ended.contains("the ratio of `lever` is"), "{}", run.ended);
    let last = run.time.last().copied().expect("samples so far");
    assert!((0.9..1.0).contains(&last), "{last} s");
}

/// A graph of one mass with a force, with what else stands in its file.
fn mass(law: &str, rest: &str) -> String {
    format!(
        "name = \"x\"\n[elements]\nj = {{ kind = \"1\", domain = \"translation\" }}\nm = {{ kind = \"I\", {law} }}\n\
         s = {{ kind = \"Se\", effort = \"-9.8 N\" }}\n[signals]\nh = {{ integral_of = \"j.flow\", start = \"1 m\" }}\n[bonds]\nlist = [\"s > j\", \"j > m\"]\n{rest}"
    )
}

#[test]
fn an_energy_of_negative_inertia_is_refused() {
    assert!(Graph::read(&mass("energy = \"p1^2/(2 kg)\"", "")).is_ok());
    let mistakes = Graph::read(&mass("energy = \"-p1^2/(2 kg)\"", "")).expect_err("it is negative");
    assert!(mistakes.iter().any(|mistake| mistake.code == "E1712" && mistake.line == 4), "{mistakes:#?}");
}

/// A ball that bounces ever faster ends the run with a word instead of falling through the floor; an event that ends the run is no failure.
#[test]
fn an_event_that_comes_ever_faster_ends_the_run() {
    let run = |rest: &str| {
        let graph = Graph::read(&mass("inertia = \"1 kg\"", rest)).unwrap_or_else(|e| panic!("{e:#?}"));
        let found = equations(&graph).unwrap_or_else(|e| panic!("{e:#?}"));
        found.simulate(&SimulationRequest { duration: 10.0, ..found.request() })
    };
    let bounce = "[[event]]\nwhen = \"-h\"\nset = { \"m.momentum\" = \"-0.5*m.momentum\" }\n";
    let endless = run(bounce);
    assert!(!endless.complete && endless.ended.contains("ever faster"), "{}", endless.ended);
    let lowest = endless.values("h").expect("its height").iter().fold(f64::INFINITY, |l, h| l.min(*h));
    assert!(lowest > -1e-6, "it stays on the floor: {lowest} m");
    let stopped = run(&format!("{bounce}[[event]]\nwhen = \"t - 1 s\"\nstop = true\n"));
    assert!(stopped.complete && stopped.ended.starts_with("stopped by an event"), "{}", stopped.ended);
    assert!(stopped.time.iter().all(|time| *time <= 1.0 + 1e-9));
    let mistakes = Graph::read(&mass("inertia = \"1 kg\"", "[[event]]\nwhen = \"-h\"\nstop = \"yes\"\n"));
    assert!(mistakes.expect_err("stop is true or false").iter().any(|mistake| mistake.code == "E1702"));
}

/// What only shows on the way ends the run with the element and the time, not with numbers that are none.
#[test]
fn what_becomes_infinite_or_jumps_ends_the_run() {
    let run = |text: &str| {
        let graph = Graph::read(text).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
        let found = equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
        found.simulate(&found.request())
    };
    let lever = "name = \"lever\"\n[elements]\nv = { kind = \"1\", domain = \"translation\" }\nw = { kind = \"1\", domain = \"translation\" }\n\
        a = { kind = \"I\", inertia = \"1 kg\" }\nb = { kind = \"I\", inertia = \"1 kg\" }\npush = { kind = \"Se\", effort = \"3 N\" }\n\
        lever = { kind = \"MTF\", ratio = \"1/(1 - 2 1/s*t)\" }\n[bonds]\n\
        list = [\"push > v\", \"v > a\", \"v > lever.1\", \"lever.2 > w\", \"w > b\"]\n";
    let found = run(lever);
    assert!(
        !found.complete && found.ended.starts_with("the ratio of `lever` becomes infinite at 0.5"),
        "{}",
        found.ended
    );
    assert!(found.series.iter().all(|series| series.values.iter().all(|value| value.is_finite())));
    let switch = "name = \"switch\"\n[elements]\nn = { kind = \"1\", domain = \"electric\" }\nbattery = { kind = \"Se\", effort = \"12 V\" }\n\
        switch = { kind = \"MSf\", flow = \"if(t > 0.5 s, 0 A, 1 A)\" }\nl = { kind = \"I\", inertia = \"1 H\" }\n[bonds]\n\
        list = [\"battery > n\", \"switch > n\", \"n > l\"]\n";
    let found = run(switch);
    assert!(!found.complete && found.ended.contains("`l` follows what jumps at 0.5"), "{}", found.ended);
    // The same through a ramp has a voltage: it runs.
    let found = run(&switch.replace("if(t > 0.5 s, 0 A, 1 A)", "1 A*min(max(6 - t/(0.1 s), 0), 1)"));
    assert!(found.complete, "{}", found.ended);
}

/// Two capacitors side by side hold one voltage: starts that differ would need an impulse of current.
#[test]
fn starts_of_followers_and_graphs_of_nothing_are_refused() {
    let pair = |own: &str| {
        let text = format!(
            "name = \"pair\"\n[elements]\nn = {{ kind = \"0\", domain = \"electric\" }}\na = {{ kind = \"C\", capacitance = \"1 F\", effort = \"1 V\" }}\n\
             b = {{ kind = \"C\", capacitance = \"2 F\", effort = \"{own}\" }}\n[bonds]\nlist = [\"n > a\", \"n > b\"]\n"
        );
        equations(&Graph::read(&text).expect("its parts are good")).map_err(|mistakes| mistakes[0].code)
    };
    assert_eq!(pair("5 V").err(), Some("E1714"));
    assert!(pair("1 V").is_ok());
    assert_eq!(Graph::read("[elements]\n").expect_err("nothing")[0].code, "E1709");
    let start = "name = \"x\"\n[elements]\nv = { kind = \"1\", domain = \"translation\" }\nm = { kind = \"I\", inertia = \"1 kg\" }\n[signals]\n\
        x = { integral_of = \"v.flow\", start = \"0/0*1 m\" }\n[bonds]\nlist = [\"v > m\"]\n";
    assert_eq!(Graph::read(start).expect_err("no number")[0].code, "E1704");
}
