//! The section of the report on the simulated run: speed, torque, block, mounts, and where the energy goes.

use crate::kit::figure::{Figure, Panel};
use crate::kit::section::Section;
use crate::kit::xy_plot::XyCurve;
use crate::simulated::energy::energy_figures;
use crate::simulated::figure::{curve, figure, panel};
use crate::simulated::orders::reaction_figures;
use crate::simulated::result::SimulationResult;
use crate::simulated::run::{audit_words, simulation_tables, simulation_words};
use std::f64::consts::PI;

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
    let (name, unit, axis) = result.abscissa(range.clone());
    let over = |values: &[f64]| -> Vec<(f64, f64)> {
        axis.iter().copied().zip(values[range.clone()].iter().copied()).collect()
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
            vec![panel([name, "torque"], [unit, "N m"], None, curves)],
        ));
    }
    figures.extend(block_figures(result));
    figures.extend(reaction_figures(result));
    figures.extend(energy_figures(result));
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
    let (abscissa, unit, over) = result.abscissa(range.clone());
    let panels: Vec<Panel> = result
        .mounts
        .iter()
        .enumerate()
        .map(|(mount, name)| {
            let along = |k: usize| -> Vec<(f64, f64)> {
                let forces =
                    samples.mounts[range.clone()].iter().map(|all| all.get(mount).map_or(0.0, |f| f[k]));
                over.iter().copied().zip(forces).collect()
            };
            let curves =
                ["x", "y", "z"].into_iter().enumerate().map(|(k, axis)| curve(axis, k, along(k))).collect();
            panel([abscissa, &format!("force on {name}")], [unit, "N"], None, curves)
        })
        .collect();
    if !panels.is_empty() {
        let caption =
            "Force of the block on every mount in the last period, axes of the frame, weight included.";
        figures.push(figure("simulated-mount-forces", "Forces at the mounts", caption, panels));
    }
    figures
}
