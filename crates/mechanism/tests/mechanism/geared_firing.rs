//! Firing on geared crankshafts of fractional ratios, against a simulation that turns the cranks and looks for dead centres.

use crate::support::assert_close;
use lanchester_mechanism::*;
use lanchester_model::*;
use lanchester_results::{End, PeriodicCurve};
use lanchester_testkit::gallery::engine as read;
use std::f64::consts::{PI, TAU};

/// A twin with a crankshaft for each cylinder; the second fires at its `number`-th top dead centre after the first one's firing.
fn file(strokes: u32, ratio: &str, phase: f64, fires: f64) -> String {
    format!(
        "name = \"geared\"\nstrokes = {strokes}\nspeed = \"3000 rpm\"\n[firing]\nangles = [\"0 deg\", \"{fires} deg\"]\n\
         [crank]\nstroke = \"80 mm\"\n[piston]\nmass = \"0.4 kg\"\nbore = \"80 mm\"\n[rod]\nlength = \"140 mm\"\nmass = \"0.5 kg\"\n\
         [[crankshaft]]\nname = \"first\"\n[[crankshaft]]\nname = \"second\"\nratio = \"{ratio}\"\nphase = \"{phase} deg\"\nx = \"300 mm\"\n\
         [[throw]]\nangle = \"0 deg\"\nz = \"0 mm\"\n[[throw]]\ncrankshaft = 2\nangle = \"0 deg\"\nz = \"0 mm\"\n\
         [[cylinder]]\nthrow = 1\nangle = \"0 deg\"\n[[cylinder]]\nthrow = 2\nangle = \"0 deg\"\n"
    )
}

/// Crank angles in a period at which a piston is highest, by looking at its pin every hundredth of a degree.
fn dead_centres(engine: &Engine, cylinder: usize, period: f64) -> Vec<f64> {
    let rod = RodLinkage::new(engine, cylinder).expect("it turns");
    let step = PI / 18_000.0;
    let count = (period / step).round() as usize;
    let travel: Vec<f64> = (0..count).map(|k| rod.at(step * k as f64).travel[0]).collect();
    let is_top = |k: &usize| {
        let (before, after) = (travel[(k + count - 1) % count], travel[(k + 1) % count]);
        travel[*k] > before && travel[*k] >= after
    };
    (0..count).filter(is_top).map(|k| step * k as f64).collect()
}

#[test]
fn every_cylinder_fires_once_in_the_cycle_of_its_own_crankshaft() {
    for (strokes, ratio, phase) in [
        (4, "1/2", 0.0),
        (4, "1/2", 100.0),
        (4, "3/2", 0.0),
        (4, "3/2", 40.0),
        (4, "-2/3", 0.0),
        (4, "-2/3", 75.0),
        (2, "1/2", 30.0),
        (2, "-2/3", 200.0),
        (2, "3/2", 0.0),
        (4, "2", 10.0),
    ] {
        let place = format!("{strokes} strokes, {ratio}, {phase}");
        // Any top dead centre of the second cylinder in the common period may be the one at which it fires.
        let plain = read(
            &file(strokes, ratio, phase, 0.0).replace("[firing]\nangles = [\"0 deg\", \"0 deg\"]\n", ""),
        );
        let value = plain.crankshafts[1].ratio.value().abs();
        let cycle = TAU * f64::from(strokes) / 2.0;
        let period = (1..=24).map(|k| TAU * f64::from(k));
        let is_common = |period: &f64| {
            let whole = |cycles: f64| (cycles - cycles.round()).abs() < 1e-9 && cycles > 0.5;
            whole(period / cycle) && whole(period * value / cycle)
        };
        let period = period.clone().find(is_common).expect("a common period");
        let tops = dead_centres(&plain, 1, period);
        assert_eq!(tops.len(), (period * value / TAU).round() as usize, "{place}");
        for chosen in &tops {
            let engine = read(&file(strokes, ratio, phase, chosen.to_degrees()));
            let chart = firing_chart(&engine).expect("it fires");
            assert_close("period", chart.period, period, 0.0, 1e-12, &place);
            // Turned on from the chosen one: every second top dead centre of a four-stroke, every one of a two-stroke.
            let from = tops.iter().position(|top| top == chosen).expect("one of them");
            let wanted: Vec<f64> = {
                let every = strokes as usize / 2;
                let mut fires: Vec<f64> =
                    (0..tops.len() / every).map(|k| tops[(from + k * every) % tops.len()]).collect();
                fires.sort_by(f64::total_cmp);
                fires
            };
            let got: Vec<f64> = chart
                .firings
                .iter()
                .filter(|firing| firing.cylinder == 2)
                .map(|firing| firing.theta)
                .collect();
            assert_eq!(got.len(), wanted.len(), "{place}");
            for (got, wanted) in got.iter().zip(&wanted) {
                let off = (got - wanted + PI).rem_euclid(TAU) - PI;
                assert!(off.abs() < PI / 9000.0, "{place}: {got} {wanted}");
            }
            // A pressure that begins at each firing and falls through the cycle tells how far the own crankshaft has turned since.
            let ends = [[End { value: 1e5, slope: -1e4 / cycle }, End { value: 9e4, slope: -1e4 / cycle }]];
            let since = PeriodicCurve::from_ends(cycle, vec![0.0], &ends).expect("a curve");
            let gas = vec![CylinderGas { cylinder: since.clone(), crankcase: since }; 2];
            let request = TorqueRequest { samples: 90, ..TorqueRequest::default() };
            let torque = torque(&engine, &gas, &request).expect("a torque");
            for (theta, pressure) in torque.theta.iter().zip(&torque.cylinders[1].pressure) {
                let turned = wanted
                    .iter()
                    .map(|fires| (theta - fires).rem_euclid(period) * value)
                    .fold(f64::INFINITY, f64::min);
                // On a firing itself it may just have begun.
                let near = turned < 1e-3 || cycle - turned < 1e-3;
                let wanted = 1e5 - 1e4 * turned / cycle;
                assert!(near || (pressure - wanted).abs() < 2.0, "{place}: {theta} {pressure} {wanted}");
            }
        }
    }
}

/// What the file says of the angles goes round: the effective file has the same firing.
#[test]
fn the_effective_file_has_the_same_firing() {
    for (ratio, fires) in [("1/2", 720.0), ("3/2", 480.0), ("-2/3", 540.0), ("-2/3", 1080.0)] {
        let engine = read(&file(4, ratio, 0.0, fires));
        let again = read(&lanchester_file::expanded(&engine.clone().into()));
        let angles = |engine: &Engine| engine.cylinders.iter().map(|c| c.firing_angle).collect::<Vec<_>>();
        assert_eq!(angles(&engine), angles(&again), "{ratio}");
    }
}
