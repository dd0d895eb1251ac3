//! Dry friction that sticks and slips, against exact answers.

use lanchester_bondgraph::{Graph, Method, Simulation, SimulationRequest, equations};

fn run(text: &str, more: impl Fn(&mut SimulationRequest)) -> Simulation {
    let found = equations(&Graph::read(text).unwrap_or_else(|m| panic!("{m:#?}"))).expect("no conflict");
    let mut request = found.request();
    more(&mut request);
    found.simulate(&request)
}

const BRAKE: &str = "name = \"brake\"\n[elements]\nshaft = { kind = \"1\", domain = \"rotation\" }\n\
                     disc = { kind = \"I\", inertia = \"2 kg m2\", flow = \"10 rad/s\" }\n\
                     rub = { kind = \"R\", effort = \"4 N m*sign(f)\" }\n\
                     [bonds]\nlist = [\"shaft > disc\", \"shaft > rub\"]\n[simulation]\nduration = \"8 s\"\n";

#[test]
fn a_brake_stops_a_disc_and_holds_it() {
    for method in [Method::Explicit, Method::Implicit] {
        let run = run(BRAKE, |request| request.method = Some(method));
        assert!(run.complete, "{}", run.ended);
        // It stands after J w / M = 5 s.
        let sticks: Vec<&str> = run.events.iter().map(|event| event.expression.as_str()).collect();
        assert!(sticks.last().is_some_and(|last| last.ends_with(" sticks")), "{sticks:?}");
        assert!(run.events.iter().all(|event| (event.time - 5.0).abs() < 1e-9), "{:?}", run.events);
        let speed = run.values("shaft.flow").expect("a junction");
        for (t, speed) in run.time.iter().zip(speed) {
            let exact = (10.0 - 2.0 * t).max(0.0);
            assert!((speed - exact).abs() < 1e-8, "{t} s: {speed}");
        }
        // Nothing turns it: nothing is held.
        let torque = run.values("shaft_rub.effort").or_else(|| run.values("rub.effort")).expect("its bond");
        assert!(torque.last().is_some_and(|torque| torque.abs() < 1e-9), "{torque:?}");
    }
}

/// A block on a rough table, pulled by a spring whose far end moves at 1 mm/s: it stays until k v t = F, slips, sticks again.
const STICK_SLIP: &str = include_str!("../../../../examples/bond-graphs/stick-slip.toml");

#[test]
fn a_block_on_a_rough_table_sticks_and_slips() {
    for audit in [false, true] {
        let run = run(STICK_SLIP, |request| request.audit = audit);
        assert!(run.complete, "{}", run.ended);
        let gives_way: Vec<f64> = (run.events.iter())
            .filter(|event| event.expression.ends_with(" sticks") && !event.on)
            .map(|event| event.time)
            .collect();
        // From rest under 3 N: 1 N/s, so 3 s to the first slip; then the same time between all others.
        assert!((gives_way[0] - 3.0).abs() < 1e-6, "{gives_way:?}");
        assert!(gives_way.len() > 3, "{:?}", run.events);
        let between: Vec<f64> = gives_way.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(between.iter().all(|own| (own - between[0]).abs() < 1e-4), "{between:?}");
        let (speed, force) =
            (run.values("slide.flow").expect("a junction"), run.values("spring.effort").expect("a spring"));
        // While it stands, the friction is the force of the spring.
        let rough = run.values("rough.effort").expect("friction");
        for ((t, speed), (force, rough)) in run.time.iter().zip(speed).zip(force.iter().zip(rough)) {
            if *t < 2.999 {
                assert!(
                    speed.abs() < 1e-12 && (force - t).abs() < 1e-9 && (rough - force).abs() < 1e-9,
                    "{t} s"
                );
            }
            assert!(rough.abs() <= 3.0 + 1e-9, "{t} s: {rough}");
        }
        if let Some(audit) = &run.audit {
            assert!(audit.whole.abs() < 1e-8, "{:?}", audit.whole.abs());
        }
    }
}

/// Two blocks upon each other: under 3 N both move together with 3 N / (2 kg + 1 kg), under 9 N the upper one slides on the lower at its friction of
/// 4 N: (9 - 4) N / 1 kg and 4 N / 2 kg.
#[test]
fn blocks_upon_each_other_move_together_or_apart() {
    for (pull, [upper, lower]) in [(3.0, [1.0, 1.0]), (9.0, [5.0, 2.0])] {
        let text = format!(
            "name = \"blocks\"\n[elements]\npull = {{ kind = \"Se\", effort = \"{pull} N\" }}\n\
             upper = {{ kind = \"1\", domain = \"translation\" }}\nlower = {{ kind = \"1\", domain = \"translation\" }}\n\
             between = {{ kind = \"0\", domain = \"translation\" }}\nrough = {{ kind = \"R\", effort = \"4 N*sign(f)\" }}\n\
             one = {{ kind = \"I\", inertia = \"1 kg\" }}\ntwo = {{ kind = \"I\", inertia = \"2 kg\" }}\n\
             [bonds]\nlist = [\"pull > upper\", \"upper > one\", \"upper > between\", \"between > rough\", \"between > lower\", \"lower > two\"]\n\
             [simulation]\nduration = \"2 s\"\n"
        );
        let run = run(&text, |_| {});
        assert!(run.complete, "{}", run.ended);
        for (name, rate) in [("upper.flow", upper), ("lower.flow", lower)] {
            let end = run.values(name).and_then(|values| values.last()).expect("a junction");
            assert!((end - 2.0 * rate).abs() < 1e-9, "{pull} N, {name}: {end}");
        }
    }
}
