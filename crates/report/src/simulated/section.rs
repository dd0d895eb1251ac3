//! The section of the report on the simulated run: speed, torque, block, mounts, and where the energy goes.

use crate::kit::figure::{Figure, Panel};
use crate::kit::flow::energy_flow;
use crate::kit::section::Section;
use crate::kit::xy_plot::XyCurve;
use crate::simulated::figure::{curve, figure, panel};
use crate::simulated::orders::reaction_figures;
use crate::simulated::result::SimulationResult;
use crate::simulated::run::{audit_words, simulation_tables, simulation_words};
use std::f64::consts::{PI, TAU};

/// A simulated run, as a section of a report.
pub fn simulation_section(result: &SimulationResult) -> Section {
    let (beside, broad): (Vec<Figure>, Vec<Figure>) =
        simulation_figures(result).into_iter().partition(|figure| figure.panels.len() <= 1);
    Section::new("simulated", "Simulated", "Simulated")
        .words("The run that the file describes, with all parts as rigid bodies.")
        .paragraphs(simulation_words(result))
        .words(audit_words(&result.run))
        .rows(beside)
        .rows(broad)
        .tables(simulation_tables(result))
}

/// Every figure of a simulated run.
pub fn simulation_figures(result: &SimulationResult) -> Vec<Figure> {
    let samples = &result.run.samples;
    if samples.time.len() < 2 {
        return Vec::new();
    }
    let rpm = samples.speed.iter().map(|speed| speed * 30.0 / PI);
    let speed = samples.time.iter().copied().zip(rpm).collect();
    let mut events: Vec<(f64, f64)> =
        result.run.events.iter().map(|event| (event.time, event.speed * 30.0 / PI)).collect();
    events.retain(|(time, speed)| time.is_finite() && speed.is_finite());
    let mut curves = vec![curve("speed", 0, speed)];
    if !events.is_empty() {
        curves.push(XyCurve { name: "events".into(), style: 0, points: events, dots: true });
    }
    let mut figures = vec![figure(
        "simulated-speed",
        "Speed over the run",
        "Speed of crankshaft 1 relative to the block; dots: events.",
        vec![panel(["time", "speed"], ["s", "rpm"], None, curves)],
    )];
    let range = result.last_period();
    let start = samples.theta[range.start];
    let over = |values: &[f64]| -> Vec<(f64, f64)> {
        let theta = samples.theta[range.clone()].iter().map(|theta| (theta - start) / TAU);
        theta.zip(values[range.clone()].iter().copied()).collect()
    };
    let torques = [
        ("gas", &samples.gas_torque),
        ("load", &samples.load_torque),
        ("friction", &samples.friction_torque),
        ("starter", &samples.starter_torque),
        ("driveline", &samples.driveline_torque),
        ("drive and others", &samples.outside_torque),
    ];
    let acting = torques.into_iter().filter(|(_, values)| values[range.clone()].iter().any(|t| *t != 0.0));
    let curves: Vec<XyCurve> =
        acting.enumerate().map(|(style, (name, values))| curve(name, style, over(values))).collect();
    if !curves.is_empty() {
        figures.push(figure(
            "simulated-torque",
            "Torques in the last period",
            "Torques on crankshaft 1, positive with the rotation.",
            vec![panel(["revolutions", "torque"], ["1", "N m"], None, curves)],
        ));
    }
    figures.extend(block_figures(result));
    figures.extend(reaction_figures(result));
    let e = &result.run.energy;
    let works = [
        ("gas", e.gas),
        ("load", e.load),
        ("starter", e.starter),
        ("friction", e.friction),
        ("pistons' friction", e.piston_friction),
        ("drive and others", e.outside),
        ("mounts' dampers", e.mount_damping),
        ("driveline's dampers", e.driveline_damping),
        ("kinetic energy", e.kinetic[0] - e.kinetic[1]),
        ("mounts' springs", e.mounts[0] - e.mounts[1]),
        ("gravity", e.gravity[0] - e.gravity[1]),
        ("driveline's springs", e.driveline[0] - e.driveline[1]),
    ];
    let side = |sign: f64| -> Vec<(String, f64)> {
        let of = works.iter().filter(|(_, work)| sign * work > 0.0);
        of.map(|(name, work)| ((*name).to_owned(), work.abs())).collect()
    };
    if let Some(panel) = energy_flow(&side(1.0), &side(-1.0)) {
        let caption = format!(
            "Works and stored energies over the run, widths in proportion. They close to {:.1e} of the throughput.",
            result.run.audit.energy
        );
        figures.push(figure("simulated-energy", "Where the energy goes", &caption, vec![panel]));
    }
    figures
}

/// Orbit of the block and forces at the mounts in the last period, where it moves.
fn block_figures(result: &SimulationResult) -> Vec<Figure> {
    let samples = &result.run.samples;
    let range = result.last_period();
    let positions = samples.position.get(range.clone()).unwrap_or_default();
    if positions.len() < 2 {
        return Vec::new();
    }
    let count = positions.len() as f64;
    let mean = [0, 1, 2].map(|k| positions.iter().map(|p| p[k]).sum::<f64>() / count);
    let orbit = positions.iter().map(|p| (p[1] - mean[1], p[0] - mean[0])).collect();
    let mut figures = vec![figure(
        "simulated-orbit",
        "Orbit of the block's origin",
        "Path of the origin about its mean place in the last period, seen along the crank axis.",
        vec![panel(["y", "x"], ["m", "m"], Some(0.0), vec![curve("origin", 0, orbit)])],
    )];
    let paths: Vec<XyCurve> = result
        .points
        .iter()
        .enumerate()
        .filter_map(|(style, point)| {
            let own = point.displacement.get(range.clone())?;
            let mean = [0, 1].map(|k| own.iter().map(|at| at[k]).sum::<f64>() / count);
            let path = own.iter().map(|at| (at[1] - mean[1], at[0] - mean[0])).collect();
            Some(curve(&point.name, style, path))
        })
        .collect();
    if !paths.is_empty() {
        figures.push(figure(
            "simulated-points",
            "Orbits of points of the block",
            "Paths about their mean places in the last period, seen along the crank axis.",
            vec![panel(["y", "x"], ["m", "m"], Some(0.0), paths)],
        ));
    }
    let start = samples.theta[range.start];
    let panels: Vec<Panel> = result
        .mounts
        .iter()
        .enumerate()
        .map(|(mount, name)| {
            let along = |k: usize| -> Vec<(f64, f64)> {
                let theta = samples.theta[range.clone()].iter().map(|theta| (theta - start) / TAU);
                let forces =
                    samples.mounts[range.clone()].iter().map(|all| all.get(mount).map_or(0.0, |f| f[k]));
                theta.zip(forces).collect()
            };
            let curves =
                ["x", "y", "z"].into_iter().enumerate().map(|(k, axis)| curve(axis, k, along(k))).collect();
            panel(["revolutions", &format!("force on {name}")], ["1", "N"], None, curves)
        })
        .collect();
    if !panels.is_empty() {
        let caption =
            "Force of the block on every mount in the last period, axes of the frame, weight included.";
        figures.push(figure("simulated-mount-forces", "Forces at the mounts", caption, panels));
    }
    figures
}
