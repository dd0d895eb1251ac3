//! Curves of a run of a bond graph: of any graph its states and largest powers, of an engine its pressures, p-V diagrams, speed and torque, the
//! motion of the block, the tilt of the pistons, second-order forces and those of the balance shafts.

use crate::kit::figure::{Figure, Panel};
use crate::kit::rounding;
use crate::kit::xy_plot::XyCurve;
use crate::simulated::figure::{curve, figure, panel};
use lanchester_bondgraph::Simulation;
use std::f64::consts::{PI, TAU};

/// Curves in one plot.
const CURVES: usize = 6;
/// Points of a curve: more would not be seen.
const POINTS: usize = 1200;
/// What of the end of a run is shown where all of it would be a block of ink [rad]: two cycles of four strokes.
const SHOWN: f64 = 4.0 * TAU;

/// The curves of a run as figures.
pub fn bond_graph_figures(run: &Simulation) -> Vec<Figure> {
    let theta = run.values("theta").filter(|_| run.values("crank.flow").is_some());
    let Some(theta) = theta.filter(|theta| theta.len() > 1) else { return of_any_graph(run) };
    let end = theta[theta.len() - 1];
    let first = theta.iter().position(|theta| (end - theta).abs() <= SHOWN).unwrap_or(0);
    let engine = OfEngine { run, theta, shown: first.min(theta.len() - 2)..theta.len() };
    let figures = [
        engine.pressures(),
        engine.loops(),
        engine.speed_and_torque(),
        engine.block(),
        engine.tilt(),
        engine.second_order(),
        engine.shafts(),
    ];
    figures.into_iter().flatten().collect()
}

/// States, a panel for each unit, and the largest powers.
fn of_any_graph(run: &Simulation) -> Vec<Figure> {
    let all = 0..run.time.len();
    let bonds = run.series.iter().position(|series| series.name.ends_with(".effort")).unwrap_or(0);
    let mut units: Vec<&str> = Vec::new();
    for state in &run.series[..bonds] {
        if !units.contains(&state.unit.as_str()) {
            units.push(&state.unit);
        }
    }
    let of_unit = |unit: &&str| {
        let states = run.series[..bonds].iter().filter(|state| state.unit == **unit).take(CURVES);
        let curves = states.enumerate().map(|(style, state)| {
            curve(&state.name.replace('_', " "), style, over_time(run, &state.values, 1.0, &all))
        });
        let curves: Vec<XyCurve> = curves.collect();
        // One curve has no legend: the title names it.
        let of_this: Vec<_> = run.series[..bonds].iter().filter(|state| state.unit == **unit).collect();
        let title = match of_this.as_slice() {
            [one] => one.name.replace('_', " "),
            _ => "states".to_owned(),
        };
        panel(["time", &title], ["s", unit], None, curves)
    };
    let mut panels: Vec<Panel> = units.iter().map(of_unit).collect();
    let most = |values: &[f64]| values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let mut powers: Vec<_> = run
        .series
        .iter()
        .filter_map(|series| {
            Some((series.name.strip_suffix(".power")?, &series.values, most(&series.values)))
        })
        .collect();
    powers.sort_by(|a, b| b.2.total_cmp(&a.2));
    let curves: Vec<XyCurve> = powers
        .iter()
        .take(CURVES)
        .enumerate()
        .map(|(style, (name, values, _))| {
            curve(&name.replace('_', " "), style, over_time(run, values, 1.0, &all))
        })
        .collect();
    if !curves.is_empty() {
        let title = match powers.as_slice() {
            [(name, ..)] => format!("power of {}", name.replace('_', " ")),
            _ => "largest powers".to_owned(),
        };
        panels.push(panel(["time", &title], ["s", "W"], None, curves));
    }
    if panels.is_empty() {
        return Vec::new();
    }
    let caption =
        "States by their unit, and the powers through the bonds that carry most, along their half arrows.";
    vec![figure("bond-graph-run", &format!("Run of {}", run.graph), caption, panels)]
}

/// Points over time, thinned to what can be seen.
fn over_time(
    run: &Simulation,
    values: &[f64],
    factor: f64,
    range: &std::ops::Range<usize>,
) -> Vec<(f64, f64)> {
    let stride = range.len().div_ceil(POINTS).max(1);
    let places = range.clone().step_by(stride);
    places.filter_map(|k| Some((*run.time.get(k)?, factor * values.get(k)?))).collect()
}

/// The run of an engine, and the samples at its end that are shown.
struct OfEngine<'a> {
    run: &'a Simulation,
    theta: &'a [f64],
    shown: std::ops::Range<usize>,
}

impl OfEngine<'_> {
    fn values(&self, name: &str) -> Option<&[f64]> {
        self.run.values(name)
    }

    /// The part that is shown, over the time from its start: axes begin at 0.
    fn end(&self, values: &[f64], factor: f64) -> Vec<(f64, f64)> {
        let start = self.run.time.get(self.shown.start).copied().unwrap_or(0.0);
        let points = over_time(self.run, values, factor, &self.shown);
        points.into_iter().map(|(time, value)| (time - start, value)).collect()
    }

    /// Numbers of the cylinders that have a quantity, with its values.
    fn of_cylinders(&self, name: impl Fn(usize) -> String) -> Vec<(usize, &[f64])> {
        (1..).map_while(|k| Some((k, self.values(&name(k))?))).collect()
    }

    /// One panel with a curve for each cylinder.
    fn cylinder_panel(&self, what: &str, unit: &str, of: &[(usize, Vec<f64>)]) -> Panel {
        let curves =
            of.iter().map(|(k, values)| curve(&format!("cylinder {k}"), k - 1, self.end(values, 1.0)));
        panel(["time", what], ["s", unit], None, curves.collect())
    }

    fn pressures(&self) -> Option<Figure> {
        let absolute = self.of_cylinders(|k| format!("mass{k}.effort"));
        let gauge = self.of_cylinders(|k| format!("p{k}"));
        let (found, what) = if absolute.is_empty() {
            (gauge, "pressure less that under the piston")
        } else {
            (absolute, "pressure")
        };
        if found.is_empty() {
            return None;
        }
        let found: Vec<(usize, Vec<f64>)> =
            found.into_iter().map(|(k, values)| (k, values.to_vec())).collect();
        let caption = "The last revolutions of the run, time from their start.";
        let panels = vec![self.cylinder_panel(what, "Pa", &found)];
        Some(figure("bond-graph-pressures", "Pressures in the cylinders", caption, panels))
    }

    fn loops(&self) -> Option<Figure> {
        let pressures = self.of_cylinders(|k| format!("mass{k}.effort"));
        let volumes = self.of_cylinders(|k| format!("volume{k}"));
        let panels: Vec<Panel> = pressures
            .iter()
            .zip(&volumes)
            .map(|((k, pressure), (_, volume))| {
                let points =
                    self.shown.clone().filter_map(|at| Some((1e3 * volume.get(at)?, *pressure.get(at)?)));
                let name = format!("pressure in cylinder {k}");
                panel(["volume", &name], ["l", "Pa"], None, vec![curve("", 0, points.collect())])
            })
            .collect();
        if panels.is_empty() {
            return None;
        }
        let caption =
            "The last revolutions of the run. The area of a loop is the work that its piston took up.";
        Some(figure("bond-graph-loops", "Pressure over volume", caption, panels))
    }

    fn speed_and_torque(&self) -> Option<Figure> {
        let speed = self.values("crank.flow")?;
        let whole = 0..self.theta.len();
        let rpm = |points: Vec<(f64, f64)>| vec![curve("speed", 0, points)];
        let mut panels = vec![panel(
            ["time", "speed of crankshaft 1"],
            ["s", "rpm"],
            None,
            rpm(over_time(self.run, speed, 30.0 / PI, &whole)),
        )];
        let slides = self.of_cylinders(|k| format!("slide{k}.1.effort"));
        if !slides.is_empty() {
            let torque: Vec<f64> = (0..speed.len())
                .map(|at| -slides.iter().map(|(_, values)| values[at]).sum::<f64>())
                .collect();
            let mut curves = vec![curve("of gas and friction of the pistons", 0, self.end(&torque, 1.0))];
            if let Some(load) = self.values("load.effort") {
                curves.push(curve("of the load", 1, self.end(load, 1.0)));
            }
            panels.push(panel(["time", "torque on the crank"], ["s", "N m"], None, curves));
        }
        let caption = "Speed over the whole run, torque over its last revolutions, time from their start.";
        Some(figure("bond-graph-speed", "Speed and torque", caption, panels))
    }

    fn block(&self) -> Option<Figure> {
        // Twice the vector of a quaternion near 1 is the angle.
        let angles = [("x", "turn_x", 2.0), ("y", "turn_y", 2.0), ("the crank", "turn_z", 2.0)];
        let mut panels: Vec<Panel> = angles
            .iter()
            .filter_map(|(axis, name, factor)| {
                let what = format!("rotation about {axis}");
                let curves = vec![curve("", 0, self.end(self.values(name)?, *factor))];
                Some(panel(["time", &what], ["s", "rad"], None, curves))
            })
            .collect();
        if let Some(roll) = self.values("roll") {
            let curves = vec![curve("", 0, self.end(roll, 1.0))];
            panels.push(panel(["time", "rotation about the crank"], ["s", "rad"], None, curves));
        }
        let names = ["vx", "vy", "vz"].into_iter().enumerate();
        let curves: Vec<XyCurve> = names
            .filter_map(|(style, name)| {
                let values = self.values(&format!("{name}.flow"))?;
                Some(curve(&name[1..], style, self.end(values, 1.0)))
            })
            .collect();
        if panels.is_empty() {
            return None;
        }
        panels.push(panel(["time", "velocity of the block's centre"], ["s", "m/s"], None, curves));
        let caption =
            "The last revolutions of the run, time from their start. The cylinders are one with the block.";
        Some(figure("bond-graph-block", "Motion of the block", caption, panels))
    }

    fn tilt(&self) -> Option<Figure> {
        let found: Vec<(usize, Vec<f64>)> = self
            .of_cylinders(|k| format!("tilt_angle{k}"))
            .into_iter()
            .map(|(k, values)| (k, values.to_vec()))
            .collect();
        if found.is_empty() {
            return None;
        }
        let panels = vec![self.cylinder_panel("tilt of the piston in its cylinder", "rad", &found)];
        let caption =
            "The last revolutions of the run, time from their start, with the skirts as two contacts each.";
        Some(figure("bond-graph-tilt", "Tilt of the pistons", caption, panels))
    }

    /// Second order of the inertia force of each piston over the last revolution.
    fn second_order(&self) -> Option<Figure> {
        let found: Vec<(usize, Vec<f64>)> =
            (1..).map_while(|k| Some((k, self.order_of(&self.piston_force(k)?, 2.0)?))).collect();
        if found.is_empty() {
            return None;
        }
        let sum: Vec<f64> =
            (0..self.theta.len()).map(|at| found.iter().map(|(_, values)| values[at]).sum::<f64>()).collect();
        let noise = rounding::among(found.iter().flat_map(|(_, values)| values.iter().copied()));
        let sum: Vec<f64> = sum.into_iter().map(|value| rounding::clean(value, noise)).collect();
        let mut panels = vec![self.cylinder_panel("second-order force of a piston", "N", &found)];
        let curves = vec![curve("", 0, self.end(&sum, 1.0))];
        panels.push(panel(["time", "of all, each along its cylinder"], ["s", "N"], None, curves));
        let caption = "Force of each piston, without its rod, on the engine along its cylinder: its part that goes with twice the crank angle.";
        Some(figure("bond-graph-second-order", "Second-order forces of the pistons", caption, panels))
    }

    /// Inertia force of a piston on the engine along its cylinder [N].
    fn piston_force(&self, k: usize) -> Option<Vec<f64>> {
        if let Some(along) = self.values(&format!("piston{k}_along.effort")) {
            return Some(along.iter().map(|effort| -effort).collect());
        }
        let [x, y] =
            [self.values(&format!("piston{k}_x.effort"))?, self.values(&format!("piston{k}_y.effort"))?];
        // Its direction where it is largest: towards positive x, or across, towards positive y.
        let size = |at: usize| x[at].hypot(y[at]);
        let at = (0..x.len()).max_by(|a, b| size(*a).total_cmp(&size(*b)))?;
        if size(at) == 0.0 {
            return None;
        }
        let [u, v] = [x[at] / size(at), y[at] / size(at)];
        let sign = if u < -1e-9 || (u.abs() <= 1e-9 && v < 0.0) { -1.0 } else { 1.0 };
        Some(x.iter().zip(y).map(|(x, y)| -sign * (x * u + y * v)).collect())
    }

    /// The part of an order, from the last revolution.
    fn order_of(&self, values: &[f64], order: f64) -> Option<Vec<f64>> {
        let end = *self.theta.last()?;
        let first = self.theta.iter().rposition(|theta| end - theta >= TAU - 1e-9)?;
        let (mut cosine, mut sine, mut turned) = (0.0, 0.0, 0.0);
        for at in first + 1..self.theta.len() {
            let step = self.theta[at] - self.theta[at - 1];
            for k in [at - 1, at] {
                let (sin, cos) = (order * self.theta[k]).sin_cos();
                cosine += 0.5 * step * values[k] * cos;
                sine += 0.5 * step * values[k] * sin;
            }
            turned += step;
        }
        let part = |theta: &f64| {
            let (sin, cos) = (order * theta).sin_cos();
            2.0 * (cosine * cos + sine * sin) / turned
        };
        Some(self.theta.iter().map(part).collect())
    }

    /// Forces of the unbalances, each and together, on one scale: what cancels to rounding is drawn as 0.
    fn shafts(&self) -> Option<Figure> {
        let axes = [(1, "x"), (2, "y")].map(|(port, axis)| (axis, self.unbalance_forces(port)));
        let noise = rounding::among(
            axes.iter().flat_map(|(_, forces)| forces).flat_map(|(_, values)| values).copied(),
        );
        let mut panels = Vec::new();
        for (axis, forces) in axes {
            if forces.is_empty() {
                return None;
            }
            let sum =
                (0..self.theta.len()).map(|at| forces.iter().map(|(_, values)| values[at]).sum::<f64>());
            let sum: Vec<f64> = sum.map(|value| rounding::clean(value, noise)).collect();
            let mut curves = Vec::new();
            if forces.len() > 1 {
                curves.push(curve("together", 0, self.end(&sum, 1.0)));
            }
            for (index, (name, values)) in forces.iter().enumerate() {
                curves.push(curve(name, index + 1, self.end(values, 1.0)));
            }
            panels.push(panel(["time", &format!("force along {axis}")], ["s", "N"], None, curves));
        }
        let caption = "Forces of the unbalances of the balance shafts on the block; below a billionth of the largest they count as 0.";
        Some(figure("bond-graph-shafts", "Forces of the balance shafts", caption, panels))
    }

    /// Force of each unbalance of each shaft on the block along an axis [N].
    fn unbalance_forces(&self, port: usize) -> Vec<(String, Vec<f64>)> {
        let force = |shaft: usize, part: usize| -> Option<Vec<f64>> {
            let efforts = self.values(&format!("shaft{shaft}_unbalance{part}.{port}.effort"))?;
            Some(efforts.iter().map(|effort| -effort).collect())
        };
        let mut found = Vec::new();
        for shaft in 1.. {
            let parts: Vec<Vec<f64>> = (1..).map_while(|part| force(shaft, part)).collect();
            if parts.is_empty() {
                break;
            }
            let is_one = parts.len() == 1;
            found.extend(parts.into_iter().enumerate().map(|(part, values)| match is_one {
                true => (format!("shaft {shaft}"), values),
                false => (format!("shaft {shaft}, unbalance {}", part + 1), values),
            }));
        }
        found
    }
}
