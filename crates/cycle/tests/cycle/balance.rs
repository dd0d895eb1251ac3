//! The balances of mass and energy of a single zone, integrated anew from the curves that it returns: volume and areas by plane geometry, flows and
//! heat to the walls from pressure and temperature, by Simpson's rule.

use crate::support::{cycle_of, engine, volume_of};
use lanchester_cycle::{ZoneCycle, ZoneSettings, mass_flow, single_zone};
use lanchester_model::{Engine, GasProcess, SingleZone, WallModel};
use std::f64::consts::{PI, TAU};

const SPEED: f64 = 3000.0 * PI / 30.0;
const GAMMA: f64 = 1.33;
const GAS_CONSTANT: f64 = 287.05;
const BORE: f64 = 0.086;
const WALL: f64 = 450.0;

const REST: &str = "[gas]\ncompression_ratio = 10.5\n[gas.cycle]\ntype = \"single-zone\"\nheat_capacity_ratio = 1.33\n\
    [gas.intake]\npressure = \"0.95 bar\"\ntemperature = \"310 K\"\nopens = \"345 deg\"\ncloses = \"590 deg\"\nlift = \"8 mm\"\ndiameter = \"34 mm\"\n\
    [gas.exhaust]\npressure = \"1.05 bar\"\ntemperature = \"900 K\"\nopens = \"130 deg\"\ncloses = \"375 deg\"\nlift = \"7 mm\"\ndiameter = \"30 mm\"\n\
    [gas.fuel]\nequivalence_ratio = 0.98\nefficiency = \"97 %\"\n[gas.heat_release]\nstart = \"-18 deg\"\nduration = \"60 deg\"\n";

const CONSTANT: &str = "[gas.walls]\nmodel = \"constant\"\ncoefficient = \"600 W/m2/K\"\n";
const CONDUCTANCE: &str = "[gas.walls]\nmodel = \"conductance\"\nconductance = \"2 W/K\"\nbody_capacity = \"30 kJ/K\"\nbody_to_ambient = \"20 W/K\"\n\
    body_temperature = \"380 K\"\nfactor = 1.5\n";
const TABLE: &str = "[gas.walls]\nmodel = \"table\"\nangles = [\"-180 deg\", \"-20 deg\", \"15 deg\", \"140 deg\", \"400 deg\"]\n\
    coefficients = [\"150 W/m2/K\", \"700 W/m2/K\", \"1600 W/m2/K\", \"400 W/m2/K\", \"250 W/m2/K\"]\n";

/// The zone of an engine.
fn zone_of(engine: &Engine) -> &SingleZone {
    match &cycle_of(engine).process {
        GasProcess::SingleZone(zone) => zone,
        other => panic!("no single zone: {other:?}"),
    }
}

fn run(engine: &Engine) -> ZoneCycle {
    let settings = ZoneSettings {
        step_tolerance: 1e-13,
        cycle_tolerance: 1e-10,
        piece: PI / 1440.0,
        ..ZoneSettings::default()
    };
    single_zone(cycle_of(engine), zone_of(engine), &volume_of(engine), SPEED, &settings).expect("a cycle")
}

/// Depth of the piston below its top dead centre [m] and its rate [m/rad], by plane geometry.
fn depth(psi: f64) -> [f64; 2] {
    let (r, l): (f64, f64) = (0.0425, 0.15);
    let along = (l * l - (r * psi.sin()).powi(2)).sqrt();
    [r + l - r * psi.cos() - along, r * psi.sin() + r * r * psi.sin() * psi.cos() / along]
}

/// Volume [m^3] and its rate [m^3/rad].
fn volume(psi: f64) -> [f64; 2] {
    let area = 0.25 * PI * BORE * BORE;
    let [depth, rate] = depth(psi);
    [area * (0.085 / 9.5 + depth), area * rate]
}

/// Effective area of valves [m^2].
fn area(psi: f64, [opens, closes]: [f64; 2], lift: f64, diameter: f64) -> f64 {
    let since = (psi - opens.to_radians()).rem_euclid(2.0 * TAU);
    let open = (closes - opens).to_radians();
    if since >= open { 0.0 } else { 0.7 * PI * diameter * lift * (PI * since / open).sin().powi(2) }
}

/// Mass in through intake and exhaust [kg/rad] and its enthalpy [J/rad].
fn flows(psi: f64, pressure: f64, temperature: f64) -> ([f64; 2], f64) {
    let sides =
        [([345.0, 590.0], 0.008, 0.034, [0.95e5, 310.0]), ([130.0, 375.0], 0.007, 0.030, [1.05e5, 900.0])];
    let specific_heat = GAMMA * GAS_CONSTANT / (GAMMA - 1.0);
    let (mut masses, mut enthalpy) = ([0.0; 2], 0.0);
    for (k, (open, lift, diameter, outside)) in sides.into_iter().enumerate() {
        let area = area(psi, open, lift, diameter);
        let inwards = outside[0] > pressure;
        let [upstream, downstream] =
            if inwards { [outside, [pressure, temperature]] } else { [[pressure, temperature], outside] };
        let flow = mass_flow(area, upstream, downstream[0], GAMMA, GAS_CONSTANT) / SPEED;
        masses[k] = if inwards { flow } else { -flow };
        enthalpy += masses[k] * specific_heat * upstream[1];
    }
    (masses, enthalpy)
}

/// The coefficient of the file [W/(m^2 K)] by its lines.
fn coefficient(model: &WallModel, psi: f64) -> f64 {
    let points =
        [(-180.0, 150.0), (-20.0, 700.0), (15.0, 1600.0), (140.0, 400.0), (400.0, 250.0), (540.0, 150.0)];
    match model {
        WallModel::Constant { .. } => 600.0,
        WallModel::Conductance(_) => 0.0,
        _ => {
            let at = (psi.to_degrees() + 180.0).rem_euclid(720.0) - 180.0;
            let pair = points.windows(2).find(|pair| at >= pair[0].0 && at <= pair[1].0).expect("all angles");
            pair[0].1 + (pair[1].1 - pair[0].1) * (at - pair[0].0) / (pair[1].0 - pair[0].0)
        }
    }
}

#[test]
fn the_returned_curves_close_the_balances_of_mass_and_energy() {
    for walls in [CONSTANT, TABLE, CONDUCTANCE] {
        let engine = engine(4, "0 mm", &format!("{REST}{walls}"));
        let model = &zone_of(&engine).walls.as_ref().expect("walls").model;
        let cycle = run(&engine);
        assert!(cycle.outcome.converged);
        // What it says of itself.
        assert!(cycle.balance.energy_share < 1e-8 && cycle.balance.mass_share < 1e-8, "{:?}", cycle.balance);
        let bore = 0.25 * PI * BORE * BORE;
        let to_walls = |psi: f64, temperature: f64| {
            if matches!(model, WallModel::Conductance(_)) {
                return 1.5 * 2.0 * (temperature - 380.0) / SPEED;
            }
            let area = 2.1 * bore + PI * BORE * depth(psi)[0];
            coefficient(model, psi) * area * (temperature - WALL) / SPEED
        };
        let state = |psi: f64| (cycle.pressure.at(psi), cycle.temperature.at(psi));
        // Rates [mass, energy without heat release, heat to the walls].
        let rates = |psi: f64| {
            let (pressure, temperature) = state(psi);
            let (masses, enthalpy) = flows(psi, pressure, temperature);
            let heat = to_walls(psi, temperature);
            [masses[0] + masses[1], enthalpy - pressure * volume(psi)[1] - heat, heat]
        };
        // A quarter of a degree off the kinks of closing, from there a whole cycle in windows.
        let start = cycle.closing_angle + 1e-6;
        let windows = 24;
        let width = (2.0 * TAU - 2e-6) / f64::from(windows);
        let mut heat = 0.0;
        for window in 0..windows {
            let from = start + width * f64::from(window);
            let count = 2000;
            let h = width / f64::from(count);
            let mut sum = [0.0; 3];
            for k in 0..=count {
                let weight = if k == 0 || k == count {
                    1.0
                } else if k % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                let rate = rates(from + h * f64::from(k));
                (0..3).for_each(|j| sum[j] += weight * h / 3.0 * rate[j]);
            }
            let to = from + width;
            let mass = cycle.mass.at(to) - cycle.mass.at(from);
            assert!((mass - sum[0]).abs() < 1e-5 * cycle.trapped.mass, "{from}: {mass} {}", sum[0]);
            let stored = |psi: f64| cycle.pressure.at(psi) * volume(psi)[0] / (GAMMA - 1.0);
            let released = cycle.since_closing.released.at(to) - cycle.since_closing.released.at(from);
            let missing = stored(to) - stored(from) - released - sum[1];
            assert!(missing.abs() < 1e-5 * cycle.heat, "{from}: {missing}");
            heat += sum[2];
        }
        assert!((heat / cycle.passed.wall_heat - 1.0).abs() < 1e-4, "{heat} {}", cycle.passed.wall_heat);
        // A perfect gas at every angle.
        for k in 0..500 {
            let psi = cycle.closing_angle + 2.0 * TAU * (f64::from(k) + 0.37) / 500.0;
            let (pressure, temperature) = state(psi);
            let wanted = cycle.mass.at(psi) * GAS_CONSTANT * temperature / volume(psi)[0];
            assert!((pressure / wanted - 1.0).abs() < 1e-6, "{psi}: {pressure} {wanted}");
        }
        // What is trapped fresh came in fresh, and none is lost but through the exhaust.
        assert!(
            cycle.trapping_efficiency <= 1.0 + 1e-6 && cycle.trapping_efficiency > 0.9,
            "{}",
            cycle.trapping_efficiency
        );
        let efficiency = cycle.fuel_efficiency.expect("it is fired");
        assert!((efficiency - 0.97 * cycle.passed.work / cycle.heat).abs() < 1e-12);
    }
}

#[test]
fn a_table_of_one_value_is_the_constant() {
    let one = "[gas.walls]\nmodel = \"table\"\nangles = [\"0 deg\"]\ncoefficients = [\"600 W/m2/K\"]\n";
    let [table, constant] = [one, CONSTANT].map(|walls| run(&engine(4, "0 mm", &format!("{REST}{walls}"))));
    let ratio = table.passed.wall_heat / constant.passed.wall_heat - 1.0;
    // The table's angle is one more event: other steps of the solver.
    assert!(ratio.abs() < 1e-8, "{ratio:e}");
}

#[test]
fn tables_that_cannot_be_are_refused() {
    for (walls, says) in [
        ("model = \"table\"\nangles = [\"0 deg\"]\n", "needs `coefficients`"),
        ("model = \"constant\"\n", "coefficient"),
        ("model = \"woschni\"\ncoefficient = \"600 W/m2/K\"\n", "has no effect"),
        (
            "model = \"table\"\nangles = [\"10 deg\", \"0 deg\"]\ncoefficients = [\"1 W/m2/K\", \"2 W/m2/K\"]\n",
            "must rise",
        ),
        (
            "model = \"table\"\nangles = [\"0 deg\", \"720 deg\"]\ncoefficients = [\"1 W/m2/K\", \"2 W/m2/K\"]\n",
            "within one cycle",
        ),
    ] {
        let text = format!(
            "name = \"single\"\nspeed = \"3000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\n[crank]\nstroke = \"85 mm\"\n\
             [piston]\nmass = \"0.4 kg\"\nbore = \"86 mm\"\n[rod]\nlength = \"150 mm\"\nmass = \"0.5 kg\"\n{REST}[gas.walls]\n{walls}"
        );
        let reading = lanchester_file::read(&text);
        let shown = lanchester_file::render(&reading.diagnostics, "single.toml", &text, false);
        assert!(reading.file.is_none() && shown.contains(says), "{shown}");
    }
}
