//! The gas field and resistors of several ports against closed forms.

use lanchester_bondgraph::{Description, Equations, Graph, equations};

fn found(description: &Description) -> Equations {
    let graph = Graph::new(description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"))
}

const R: f64 = 287.05;
const CV: f64 = 720.0;

fn gas(volume: &str, pressure: &str) -> Description {
    Description::new("vessel").element(
        "gas",
        "Gas",
        &[
            ("gas_constant", "287.05 J/kg/K"),
            ("heat_capacity", "720 J/kg/K"),
            ("volume", volume),
            ("pressure", pressure),
            ("temperature", "300 K"),
        ],
    )
}

/// An adiabatic vessel that was nearly empty ends at `gamma T_0`: the energy in it is the enthalpy that came in.
#[test]
fn a_vessel_that_fills_becomes_hot() {
    let flow = "1e-4 kg/s*tanh((e1 - e3)/(1e3 Pa))";
    let laws = format!("{flow} ; 1007.05 J/kg/K*e2*{flow} ; -{flow} ; -1007.05 J/kg/K*e2*{flow}");
    let vessel = gas("1 l", "10 Pa")
        .element("still", "Sf", &[("flow", "0 m3/s")])
        .element("mass", "0", &[("domain", "mass")])
        .element("heat", "0", &[("domain", "heat")])
        .element("outside", "Se", &[("effort", "1 bar"), ("domain", "mass")])
        .element("warmth", "Se", &[("effort", "300 K"), ("domain", "heat")])
        .element("valve", "R", &[("flow", &laws)])
        .bonds(&["still > gas.1", "mass > gas.2", "heat > gas.3"])
        .bonds(&["outside > valve.1", "warmth > valve.2", "mass > valve.3", "heat > valve.4"]);
    let found = found(&vessel);
    assert_eq!(found.causality.states, ["gas.1", "gas.2", "gas.3"]);
    let mut request = found.request();
    (request.duration, request.audit) = (40.0, true);
    let run = found.simulate(&request);
    assert!(run.complete, "{}", run.ended);
    let last = |name: &str| *run.values(name).unwrap_or_else(|| panic!("{name}")).last().expect("samples");
    let start = 10.0 * 1e-3 / (R * 300.0);
    let (mass, temperature, pressure) =
        (last("gas.2.displacement"), last("heat.effort"), last("mass.effort"));
    let expected = (start * CV * 300.0 + (mass - start) * (CV + R) * 300.0) / (mass * CV);
    assert!((temperature - expected).abs() < 1e-7 * expected, "{temperature} K, not {expected} K");
    assert!((temperature / 300.0 - (1.0 + R / CV)).abs() < 1e-4, "gamma T_0");
    assert!((pressure - 1e5).abs() < 1.0, "{pressure} Pa");
    let audit = run.audit.expect("asked for");
    assert!(audit.whole < 1e-9, "{}", audit.whole);
}

/// Without valves and walls the compression is isentropic, and its work is what the energy gains.
#[test]
fn a_sealed_vessel_is_compressed_isentropically() {
    let vessel = gas("0.5 l", "1 bar")
        .element("piston", "Sf", &[("flow", "0.45 l/s")])
        .element("no_mass", "Sf", &[("flow", "0 kg/s")])
        .element("no_heat", "Sf", &[("flow", "0 W")])
        .bonds(&["piston > gas.1", "no_mass > gas.2", "no_heat > gas.3"]);
    let found = found(&vessel);
    let mut request = found.request();
    (request.duration, request.tolerance, request.audit) = (1.0, 1e-11, true);
    let run = found.simulate(&request);
    let gamma = 1.0 + R / CV;
    let expected = 1e5 * 10f64.powf(gamma);
    let pressure = *run.values("gas.1.effort").expect("its pressure").last().expect("samples");
    assert!((pressure - expected).abs() < 1e-9 * expected, "{pressure} Pa, not {expected} Pa");
    let audit = run.audit.expect("asked for");
    let work = (expected * 0.05e-3 - 1e5 * 0.5e-3) / (gamma - 1.0);
    let own = audit.elements.iter().find(|element| element.element == "gas").expect("the gas");
    assert!((own.taken - work).abs() < 1e-9 * work, "{} J, not {work} J", own.taken);
    assert!(own.error.expect("its energy is a state") < 1e-9);
}

#[test]
fn a_gas_says_what_it_lacks() {
    let lacking = Description::new("vessel")
        .element("gas", "Gas", &[("gas_constant", "287 J/kg/K"), ("heat_capacity", "720 J/kg/K")])
        .element("a", "Sf", &[("flow", "0 m3/s")])
        .element("b", "Sf", &[("flow", "0 kg/s")])
        .element("c", "Sf", &[("flow", "0 W")])
        .bonds(&["a > gas.1", "b > gas.2", "c > gas.3"]);
    let mistakes = Graph::new(&lacking).expect_err("no volume, pressure and temperature");
    assert!(
        mistakes.iter().any(|m| m.code == "E1709" && m.message.contains("has no volume")),
        "{mistakes:?}"
    );
}
