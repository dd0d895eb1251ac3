//! Events of a run while the gas is states: misfire, fuel, load, clutch and stop of the three-cylinder engine of the bond-graph thesis.

use lanchester_bondgraph::{
    EngineDrive, EngineLink, EngineLoad, EngineRequest, GasStates, Graph, LoadLaw, Simulation,
    SimulationRequest, engine_graph, equations,
};
use lanchester_file::read;
use lanchester_model::{Action, Engine, Event, When};
use std::f64::consts::TAU;

const SPEED: f64 = TAU * 2000.0 / 60.0;

fn engine() -> Engine {
    let read = read(include_str!("../../../../examples/three-cylinder.toml"));
    read.engine().unwrap_or_else(|| panic!("{:#?}", read.diagnostics))
}

fn run(events: Vec<Event>, change: impl Fn(&mut EngineRequest), cycles: f64) -> Simulation {
    let engine = engine();
    let mut request = EngineRequest {
        crankshaft_inertia: vec![0.6],
        gas_states: Some(GasStates::of(&engine).expect("a single zone")),
        events,
        ..EngineRequest::free(SPEED, 2.0 * cycles)
    };
    change(&mut request);
    let description = engine_graph(&engine, &request).unwrap_or_else(|error| panic!("{error}"));
    let graph = Graph::new(&description).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let found = equations(&graph).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    let asked = SimulationRequest { tolerance: 1e-9, samples: 720 * cycles as usize, ..found.request() };
    found.simulate(&asked)
}

fn values<'a>(run: &'a Simulation, name: &str) -> &'a [f64] {
    run.values(name).unwrap_or_else(|| panic!("no {name}"))
}

/// An angle at which no cylinder burns: the first has, the second fires a third of a cycle behind it [rad].
const BETWEEN: f64 = 3.0;

/// Heat that a cylinder releases in the cycle behind an angle at which the first fires [J].
fn cycle(run: &Simulation, cylinder: usize, from: f64) -> f64 {
    heat(run, cylinder, [from + BETWEEN, from + 2.0 * TAU + BETWEEN])
}

/// Heat that a cylinder releases between two angles [J].
fn heat(run: &Simulation, cylinder: usize, [from, to]: [f64; 2]) -> f64 {
    let (rate, theta) = (values(run, &format!("release_rate{cylinder}")), values(run, "theta"));
    (1..theta.len())
        .filter(|k| theta[*k] > from && theta[*k] <= to)
        .map(|k| 0.5 * (rate[k] + rate[k - 1]) * (run.time[k] - run.time[k - 1]))
        .sum()
}

/// At imposed speed no cylinder knows of another: a misfire of the second stops its heat, lets its pressure fall to that of compression, and leaves the
/// others as they are to the tolerance.
#[test]
fn a_misfire_stops_the_heat_of_its_cylinder_alone() {
    let imposed = |request: &mut EngineRequest| request.drive = EngineDrive::Imposed;
    let misfire = Event { when: When::Angle(2.0 * TAU), action: Action::Misfire(1) };
    let (whole, missing) = (run(Vec::new(), imposed, 5.0), run(vec![misfire], imposed, 5.0));
    assert!(missing.complete, "{}", missing.ended);
    let theta = values(&whole, "theta");
    for k in 1..=3 {
        let name = format!("mass{k}.effort");
        let (a, b) = (values(&whole, &name), values(&missing, &name));
        let most = a.iter().fold(0.0f64, |most, p| most.max(*p));
        let until = if k == 2 { 2.0 * TAU } else { f64::INFINITY };
        for (index, (a, b)) in a.iter().zip(b).enumerate().filter(|(index, _)| theta[*index] < until) {
            assert!((a - b).abs() < 1e-6 * most, "{name} at {}: {a} and {b}", theta[index]);
        }
    }
    let last = [8.0 * TAU, 10.0 * TAU];
    let fired = heat(&whole, 2, last);
    assert!((950.0..1010.0).contains(&fired), "{fired} J of the file's 1000 J a cycle");
    assert_eq!(heat(&missing, 2, last), 0.0);
    // Compression alone: ratio 10 from about 1 bar, less what the walls take.
    let peak = |run: &Simulation| {
        let pressure = values(run, "mass2.effort").iter().zip(theta);
        pressure.filter(|(_, at)| **at > last[0]).fold(0.0f64, |most, (p, _)| most.max(*p))
    };
    assert!(peak(&whole) > 3e6 && (1.2e6..2.6e6).contains(&peak(&missing)), "{} Pa", peak(&missing));
}

/// Fuel is a factor on the heat; the load is taken anew; behind an open clutch nothing is driven; the run stops.
#[test]
fn fuel_load_clutch_and_stop_act_with_gas_as_states() {
    let events = vec![
        Event { when: When::Angle(4.0 * TAU + BETWEEN), action: Action::Fuel(0.4) },
        Event { when: When::Angle(6.0 * TAU), action: Action::Load(LoadLaw::Constant(30.0)) },
        Event { when: When::Angle(8.0 * TAU), action: Action::ClutchOpen },
        Event { when: When::Angle(10.0 * TAU), action: Action::Stop },
    ];
    let change = |request: &mut EngineRequest| {
        request.driveline = vec![EngineLink { inertia: 0.3, stiffness: 3000.0, damping: 6.0, ratio: 1.0 }];
        request.load = EngineLoad { torque: LoadLaw::Constant(90.0), reacts_on_block: false };
    };
    let run = run(events, change, 12.0);
    assert!(run.complete && run.ended.starts_with("stopped by an event"), "{}", run.ended);
    let theta = values(&run, "theta");
    let end = theta[theta.len() - 1];
    assert!(end <= 10.0 * TAU && end > 9.9 * TAU, "it stops at {} revolutions", end / TAU);
    for k in 1..=3 {
        let (before, after) = (cycle(&run, k, 2.0 * TAU), cycle(&run, k, 6.0 * TAU));
        assert!((after / before - 0.4).abs() < 2e-3, "cylinder {k}: {before} J, then {after} J");
    }
    let load = values(&run, "load.effort");
    let at = |revolutions: f64| theta.iter().position(|at| *at > revolutions * TAU).expect("it comes so far");
    assert!((load[at(5.9)] - 90.0).abs() < 1e-9 && (load[at(6.1)] - 30.0).abs() < 1e-9);
    // Behind the open clutch the load alone brakes what was driven: 30 N m on 0.3 kg m2.
    let own = values(&run, "link1.flow");
    let (a, b) = (at(8.1), at(9.9));
    let slowing = (own[a] - own[b]) / (run.time[b] - run.time[a]);
    assert!((slowing - 100.0).abs() < 1e-6, "{slowing} rad/s2");
}
