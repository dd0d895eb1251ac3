//! Pictures of a crankshaft over the cycle: stress, orbits in their clearances, loads of the mains.

use super::result::{BearingCycle, CrankCycle, CycleRun};
use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::plot::{AnglePlot, Series};
use crate::kit::xy_plot::{XyCurve, XyPlot};
use crate::torque::figures::closed;
use lanchester_film::BearingKind;
use std::f64::consts::TAU;

/// Points of a drawn circle.
const CIRCLE: usize = 120;
/// Line styles of a plot.
const STYLES: usize = 6;

/// All pictures.
pub fn crank_cycle_figures(found: &CrankCycle) -> Vec<Figure> {
    [stress(found), orbits(found), films(found), mains(found)].into_iter().flatten().collect()
}

/// Runs with as many instants as the first: those that were stopped have fewer.
fn whole(found: &CrankCycle) -> Vec<&CycleRun> {
    let count = found.runs.iter().map(|run| run.theta.len()).max().unwrap_or(0);
    found.runs.iter().filter(|run| count > 0 && run.theta.len() == count).collect()
}

fn plot(
    found: &CrankCycle,
    quantity: &str,
    unit: &str,
    theta: &[f64],
    series: Vec<Series<'_>>,
) -> Option<Panel> {
    let plot = AnglePlot { quantity, unit, theta, period: found.period, series };
    (!plot.series.is_empty()).then(|| plot.panel())
}

/// Stress of the worst fillets: one plot a fillet, one curve a law.
fn stress(found: &CrankCycle) -> Option<Figure> {
    let runs: Vec<&CycleRun> = whole(found).into_iter().filter(|run| !run.fillets.is_empty()).collect();
    let first = runs.first()?;
    let largest = |k: usize| runs.iter().map(|run| run.fillets[k].peak).fold(0.0, f64::max);
    let mut order: Vec<usize> = (0..first.fillets.len()).collect();
    order.sort_by(|a, b| largest(*b).total_cmp(&largest(*a)));
    let panels = order.into_iter().take(4).filter_map(|k| {
        let series = runs.iter().enumerate().map(|(style, run)| Series {
            name: run.name(),
            style: (style + 1) % STYLES,
            values: &run.fillets[k].over_cycle,
        });
        let quantity = format!("{}, von Mises", number::capital(&first.fillets[k].name));
        plot(found, &quantity, "Pa", &first.theta, series.collect())
    });
    let panels: Vec<Panel> = panels.collect();
    Some(Figure {
        id: "cycle-stress".to_owned(),
        title: "Stress of the most stressed fillets over the cycle".to_owned(),
        caption: "Largest von Mises stress in each fillet at every crank angle, by law of the bearings."
            .to_owned(),
        columns: 2,
        panels,
    })
}

/// Orbits of all journals and pins with a law that lets them move.
fn orbits(found: &CrankCycle) -> Option<Figure> {
    let runs: Vec<&CycleRun> = found.runs.iter().filter(|run| !run.bearings.is_empty()).collect();
    let first = runs.first()?;
    let panel = |k: usize| {
        let moves = |run: &&&CycleRun| run.bearings[k].largest_eccentricity > 1e-12;
        let moving: Vec<(usize, &CycleRun)> =
            runs.iter().enumerate().filter(|(_, run)| moves(run)).map(|(i, run)| (i, *run)).collect();
        let own = &first.bearings[k];
        let clearance = moving.iter().filter_map(|(_, run)| run.bearings[k].clearance).next();
        let mut curves: Vec<XyCurve> = moving
            .iter()
            .map(|(style, run)| XyCurve {
                name: run.name(),
                style: (style + 1) % STYLES,
                points: closed(run.bearings[k].orbit.iter().map(|[x, y]| (*y, *x))),
                dots: false,
            })
            .collect();
        if curves.is_empty() {
            return None;
        }
        if let Some(clearance) = clearance {
            let circle = (0..CIRCLE).map(|k| {
                let (sin, cos) = (TAU * k as f64 / CIRCLE as f64).sin_cos();
                (clearance * sin, clearance * cos)
            });
            curves.push(XyCurve {
                name: "clearance".to_owned(),
                style: 0,
                points: closed(circle),
                dots: false,
            });
        }
        let name = number::capital(&own.name());
        let (up, across) = match own.kind {
            BearingKind::Main => (format!("{name}: centre along x"), "centre along y"),
            BearingKind::Crankpin => (format!("{name}: centre towards the piston"), "centre across the rod"),
        };
        let least = clearance.unwrap_or(0.0);
        let plot = XyPlot { abscissa: across, ordinate: &up, units: ["m", "m"], polar: Some(least), curves };
        Some(plot.panel())
    };
    let panels: Vec<Panel> = (0..first.bearings.len()).filter_map(panel).collect();
    (!panels.is_empty()).then(|| Figure {
        id: "cycle-orbits".to_owned(),
        title: "Orbits in their clearances".to_owned(),
        caption: "Centre of each journal or pin from that of its bearing over the cycle, by law; a big end's in the frame of its rod. The circle is the clearance of law \
                  contact and of the film: what is left to it is the film."
            .to_owned(),
        columns: panels.len().min(3),
        panels,
    })
}

/// Thinnest place of every film over the crank angle.
fn films(found: &CrankCycle) -> Option<Figure> {
    let mut panels = Vec::new();
    for run in whole(found) {
        for kind in [BearingKind::Main, BearingKind::Crankpin] {
            let own: Vec<&BearingCycle> =
                run.bearings.iter().filter(|own| own.kind == kind && own.film.is_some()).collect();
            let values: Vec<Vec<f64>> = own
                .iter()
                .map(|own| {
                    let last = &own.orbit[own.orbit.len() - run.theta.len()..];
                    last.iter().map(|[x, y]| own.clearance.unwrap_or(0.0) - x.hypot(*y)).collect()
                })
                .collect();
            let series = own.iter().zip(&values).enumerate().map(|(style, (own, values))| Series {
                name: own.name(),
                style: (style + 1) % STYLES,
                values,
            });
            let of = match kind {
                BearingKind::Main => "mains",
                BearingKind::Crankpin => "big ends",
            };
            let quantity = format!("Thinnest film, {of} ({})", run.name());
            panels.extend(plot(found, &quantity, "m", &run.theta, series.collect()));
        }
    }
    (!panels.is_empty()).then(|| Figure {
        id: "cycle-films".to_owned(),
        title: "Films over the cycle".to_owned(),
        caption: "Thickness in the middle of each bearing where it is thinnest; 0 is the shell.".to_owned(),
        columns: 2,
        panels,
    })
}

/// Load of every main: by law, and of the rigid crankshaft by the three rules.
fn mains(found: &CrankCycle) -> Option<Figure> {
    let runs = whole(found);
    let first = runs.first()?;
    let count = first.bearings.iter().filter(|own| own.kind == BearingKind::Main).count();
    let size = |loads: &[[f64; 2]]| loads.iter().map(|[x, y]| x.hypot(*y)).collect::<Vec<f64>>();
    let mut panels = Vec::new();
    for main in 0..count {
        let mut values: Vec<(String, Vec<f64>)> = Vec::new();
        let same = |rules: &&super::result::MainRules| rules.theta.len() == first.theta.len();
        if let Some(rules) = found.rules.as_ref().filter(same) {
            // Two mains leave no choice: one rule tells all.
            let all = if count == 2 { 1 } else { 3 };
            for (name, loads) in rules.names.iter().zip(&rules.loads[main]).take(all) {
                values.push((format!("rule: {name}"), size(loads)));
            }
        }
        values.extend(runs.iter().map(|run| (run.name(), size(&run.bearings[main].load))));
        let series = values.iter().enumerate().map(|(style, (name, values))| Series {
            name: name.clone(),
            style: style % STYLES,
            values,
        });
        let quantity = format!("Load of main {}", first.bearings[main].number);
        panels.extend(plot(found, &quantity, "N", &first.theta, series.collect()));
    }
    Some(Figure {
        id: "cycle-mains".to_owned(),
        title: "Loads of the main bearings over the cycle".to_owned(),
        caption: "Size of the load, by law of the bearings shared out by stiffness, and of the rigid crankshaft by the rules of the simulation.".to_owned(),
        columns: 2,
        panels,
    })
}
