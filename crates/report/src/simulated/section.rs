//! The section of the report on the simulated run: speed, torque, block, mounts, and where the energy goes.

use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::section::Section;
use crate::kit::xy_plot::XyCurve;
use crate::simulated::beside::ClosedFormBeside;
use crate::simulated::changes::{about_events, changes, numbered, sentence};
use crate::simulated::energy::energy_figures;
use crate::simulated::figure::{curve, figure, fitted, orbit, panel};
use crate::simulated::orders::reaction_figures;
use crate::simulated::result::SimulationResult;
use crate::simulated::run::{audit_words, simulation_tables, simulation_words};
use std::f64::consts::PI;

/// A simulated run, as a section of a report; `closed`: the closed form beside it.
pub fn simulation_section(result: &SimulationResult, closed: Option<&ClosedFormBeside>) -> Section {
    let (beside, broad): (Vec<Figure>, Vec<Figure>) =
        simulation_figures(result, closed).into_iter().partition(|figure| figure.panels.len() <= 1);
    Section::new("simulated", "Simulated", "Simulated")
        .words("The run that the file describes, with all parts as rigid bodies.")
        .paragraphs(simulation_words(result))
        .words(audit_words(&result.run))
        .rows(beside)
        .rows(broad)
        .tables(simulation_tables(result))
}

/// Every figure of a simulated run; `closed`: the closed form beside it.
pub fn simulation_figures(result: &SimulationResult, closed: Option<&ClosedFormBeside>) -> Vec<Figure> {
    let samples = &result.run.samples;
    if samples.time.len() < 2 {
        return Vec::new();
    }
    let rpm = samples.speed.iter().map(|speed| speed * 30.0 / PI);
    let speed = samples.time.iter().copied().zip(rpm).collect();
    let events = numbered(result);
    let marks: Vec<(f64, usize)> = events.iter().map(|(number, time, _)| (*time, *number)).collect();
    let caption = format!("Speed of crankshaft 1 relative to the block.{}", sentence(&events));
    let mut figures = vec![figure(
        "simulated-speed",
        "Speed over the run",
        &caption,
        vec![fitted(["time", "speed"], ["s", "rpm"], &marks, vec![curve("speed", 0, speed)])],
    )];
    figures.extend(about_events(result));
    figures.extend(changes(result));
    let range = result.last_period();
    let (name, unit, axis) = result.abscissa(range.clone());
    let over = |values: &[f64]| -> Vec<(f64, f64)> {
        axis.iter().copied().zip(values[range.clone()].iter().copied()).collect()
    };
    let torques = [
        ("gas", &samples.gas_torque),
        ("load", &samples.load_torque),
        ("friction", &samples.friction_torque),
        ("pistons' friction", &samples.piston_friction_torque),
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
    figures.extend(driveline_figure(result, &marks));
    figures.extend(block_figures(result, closed));
    figures.extend(reaction_figures(result, closed));
    figures.extend(energy_figures(result));
    figures
}

/// Twists, torques and speeds of the driveline over the run.
fn driveline_figure(result: &SimulationResult, events: &[(f64, usize)]) -> Option<Figure> {
    let samples = &result.run.samples;
    let links = samples.driveline.first().map_or(0, Vec::len);
    let over = |name: &str, style: usize, value: &dyn Fn(usize) -> f64| {
        curve(name, style, samples.time.iter().enumerate().map(|(k, time)| (*time, value(k))).collect())
    };
    let springs = |which: usize| -> Vec<XyCurve> {
        (0..links)
            .map(|link| {
                over(&format!("spring {}", link + 1), link, &|k| samples.driveline_springs[k][link][which])
            })
            .collect()
    };
    let rpm = |speed: f64| speed * 30.0 / PI;
    let mut speeds = vec![over("crankshaft 1", 0, &|k| rpm(samples.speed[k]))];
    speeds.extend((0..links).map(|link| {
        over(&format!("inertia {}", link + 1), link + 1, &|k| rpm(samples.driveline[k][link][1]))
    }));
    let panels = vec![
        fitted(["time", "torque"], ["s", "N m"], events, springs(1)),
        fitted(["time", "twist"], ["s", "rad"], events, springs(0)),
        fitted(["time", "speed"], ["s", "rpm"], events, speeds),
    ];
    let caption = "Springs of the driveline in order, each before its inertia: torque with the damper on the inertia behind it and twist, both 0 of an open clutch; speeds of the inertias.";
    (links > 0).then(|| figure("simulated-driveline", "Driveline", caption, panels))
}

/// Orbit of the block and forces at the mounts in the last period, where it moves.
fn block_figures(result: &SimulationResult, closed: Option<&ClosedFormBeside>) -> Vec<Figure> {
    let samples = &result.run.samples;
    let range = result.last_period();
    let positions = samples.position.get(range.clone()).unwrap_or_default();
    if positions.len() < 2 {
        return Vec::new();
    }
    let count = positions.len() as f64;
    let mean = [0, 1, 2].map(|k| positions.iter().map(|p| p[k]).sum::<f64>() / count);
    let path = positions.iter().map(|p| (p[1] - mean[1], p[0] - mean[0])).collect();
    let (drawing, drawn) = orbit(["y", "x"], vec![curve("origin", 0, path)]);
    let mut figures = vec![figure(
        "simulated-orbit",
        "Orbit of the block's origin",
        &format!(
            "Path of the origin about its mean place in the last period, seen along the crank axis, {drawn}."
        ),
        vec![drawing],
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
        let (drawing, drawn) = orbit(["y", "x"], paths);
        figures.push(figure(
            "simulated-points",
            "Orbits of points of the block",
            &format!("Paths about their mean places in the last period, seen along the crank axis, {drawn}."),
            vec![drawing],
        ));
    }
    let (abscissa, unit, over) = result.abscissa(range.clone());
    let theta = &samples.theta[range.clone()];
    let closed = closed.filter(|closed| !closed.mounts.is_empty());
    let panels: Vec<Panel> = result
        .mounts
        .iter()
        .enumerate()
        .map(|(mount, name)| {
            let along = |k: usize| -> Vec<f64> {
                samples.mounts[range.clone()].iter().map(|all| all.get(mount).map_or(0.0, |f| f[k])).collect()
            };
            let drawn = |values: Vec<f64>| over.iter().copied().zip(values).collect();
            let axes = ["x", "y", "z"].into_iter().enumerate();
            let mut curves: Vec<XyCurve> =
                axes.clone().map(|(k, axis)| curve(axis, k, drawn(along(k)))).collect();
            if let Some(closed) = closed {
                for (k, axis) in axes {
                    let own = along(k);
                    let mean = own.iter().sum::<f64>() / own.len().max(1) as f64;
                    let theirs = theta.iter().map(|at| mean + closed.mount_force(mount, k, *at)).collect();
                    curves.push(curve(&format!("{axis}, linear"), k + 3, drawn(theirs)));
                }
            }
            fitted([abscissa, &format!("force on {name}")], [unit, "N"], &[], curves)
        })
        .collect();
    if !panels.is_empty() {
        let linear = match closed {
            Some(closed) => format!(
                " Linear: the response of the section on mounts at {} rpm, about the mean of the simulated force.",
                number::short(number::rpm(closed.speed), 5)
            ),
            None => String::new(),
        };
        let caption = format!(
            "Force of the block on every mount in the last period, axes of the frame, weight included.{linear}"
        );
        figures.push(figure("simulated-mount-forces", "Forces at the mounts", &caption, panels));
    }
    figures
}
