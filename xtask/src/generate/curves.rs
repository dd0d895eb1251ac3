//! Curves of the theory pages, from numbers that the program prints.

use super::chart::{Axis, Chart, Curve, SIZE};
use super::document::{document, file_of};
use super::pen::Pen;
use crate::documents;
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// A chart for a page of the theory.
pub struct Curves {
    /// Its name below the pictures of the theory.
    name: &'static str,
    title: &'static str,
    says: &'static str,
    chart: fn(&Path) -> Result<Chart<'static>>,
}

/// All of them.
pub const CURVES: [Curves; 4] = [
    Curves {
        name: "order-coefficients",
        title: "Order coefficients over the rod ratio",
        says: "The coefficients A2, A4 and A6 of a centred cylinder over λ = r/l, exact and by the literature's series to λ⁵: they agree at small λ; A4 and A6 part from λ = 0.3 on.",
        chart: order_coefficients,
    },
    Curves {
        name: "peaks",
        title: "A peak and a grid",
        says: "Roll moment of a single cylinder over the crank angle with the angles of a grid of 15 degrees: the largest value on the grid is below the true peak, which stands between two of its angles.",
        chart: peaks,
    },
    Curves {
        name: "active-angles",
        title: "The optimum and its active angles",
        says: "Couple of an in-line three over the crank angle at its optimum: at the active angles it stands at the smallest peak that the devices allow, and the multipliers there prove it.",
        chart: active_angles,
    },
    Curves {
        name: "bounds",
        title: "Best value and bound",
        says: "Branch and bound of a twin with choices: the best value is found at once, the lower bound rises with the number of nodes until both meet.",
        chart: bounds,
    },
];

impl Curves {
    /// Where it stands in the repository.
    pub fn file(&self) -> String {
        file_of(self.name)
    }

    /// The chart as a document.
    pub fn svg(&self, program: &Path) -> Result<String> {
        let mut pen = Pen::new();
        (self.chart)(program).with_context(|| format!("curves {}", self.name))?.draw(&mut pen);
        Ok(document(pen, self.name, self.title, self.says, SIZE))
    }
}

/// What the program answers, as JSON; a search that was told to stop early has an exit status of its own and answers too.
fn asked(program: &Path, arguments: &[&str], input: &str) -> Result<Value> {
    let mut command = Command::new(program);
    command.args(arguments).args(["--format", "json"]).current_dir(root());
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
    child.stdin.take().context("no standard input")?.write_all(input.as_bytes())?;
    let answer = child.wait_with_output()?;
    serde_json::from_slice(&answer.stdout).with_context(|| format!("no answer to {arguments:?}"))
}

fn number(value: &Value) -> Result<f64> {
    value.as_f64().context("no number where one was expected")
}

fn numbers(value: &Value) -> Result<Vec<f64>> {
    value.as_array().context("no list where one was expected")?.iter().map(number).collect()
}

/// Crank radius, speed and mass of the single cylinder whose orders are drawn: all three cancel.
const CRANK: f64 = 0.05;

fn order_coefficients(program: &Path) -> Result<Chart<'static>> {
    let mut points = vec![Vec::new(); 6];
    for step in 0..=20 {
        let ratio = 0.1 + 0.02 * f64::from(step);
        let engine = format!(
            "name = \"single\"\nspeed = \"1000 rpm\"\n[layout]\ntype = \"in-line\"\ncylinders = 1\n[crank]\nstroke = \"{} mm\"\n\
             [piston]\nmass = \"1 kg\"\n[rod]\nlength = \"{:.6} mm\"\nmass = \"0 kg\"\n",
            2e3 * CRANK,
            1e3 * CRANK / ratio
        );
        for (series, first) in [("exact", 0), ("power:6:5", 3)] {
            let loads = asked(program, &["loads", "-", "--series", series], &engine)?;
            let speed = number(&loads["speed"])?;
            let orders = loads["total"]["orders"].as_array().context("no orders")?;
            for (index, wanted) in [2.0, 4.0, 6.0].into_iter().enumerate() {
                let found = orders.iter().find(|order| order["order"] == wanted);
                let forward = found.map_or(Ok(0.0), |order| number(&order["force_forward"][0]))?;
                // (4.3): the forward force of order n is half of m r ω² c_n.
                points[first + index].push((ratio, 2.0 * forward / (CRANK * speed * speed)));
            }
        }
    }
    // Small beside A2: A4 is drawn 10 times, A6 100 times as large.
    for (list, factor) in points.iter_mut().zip([1.0, 10.0, 100.0].into_iter().cycle()) {
        list.iter_mut().for_each(|point| point.1 *= factor);
    }
    let names = ["exact", "", "", "series to λ⁵", "", ""];
    let curves = points.into_iter().zip(names).enumerate().map(|(index, (points, name))| Curve {
        name,
        class: if index < 3 { "s0" } else { "s2" },
        points,
        dots: None,
    });
    let mut curves: Vec<Curve> = curves.collect();
    // The series over the exact curves.
    curves.rotate_left(3);
    Ok(Chart {
        x: Axis { says: "rod ratio λ = r/l", ends: [0.1, 0.5], step: 0.1, decimals: 1 },
        y: Axis { says: "coefficient", ends: [-0.4, 0.6], step: 0.2, decimals: 1 },
        curves,
        labels: vec![((0.3, 0.32), "A2"), ((0.42, -0.3), "10 × A4"), ((0.44, 0.2), "100 × A6")],
    })
}

fn peaks(program: &Path) -> Result<Chart<'static>> {
    const GRID: usize = 24;
    let engine = "examples/single-gas.toml";
    let loads = asked(program, &["loads", engine], "")?;
    let grid = asked(program, &["loads", engine, "--grid", "24"], "")?;
    let trace = &loads["total"]["trace"];
    let moment: Vec<(f64, f64)> = numbers(&trace["theta"])?
        .into_iter()
        .map(f64::to_degrees)
        .zip(numbers(&trace["roll_moment"])?)
        .collect();
    let peak = |loads: &Value| -> Result<(f64, f64)> {
        let largest = &loads["total"]["peaks"]["roll_moment"]["max"];
        Ok((number(&largest["theta"])?.to_degrees(), number(&largest["value"])?))
    };
    let on_grid: Vec<(f64, f64)> = moment.iter().copied().step_by(moment.len() / GRID).take(7).collect();
    Ok(Chart {
        x: Axis { says: "crank angle θ [deg]", ends: [0.0, 90.0], step: 15.0, decimals: 0 },
        y: Axis { says: "roll moment [N m]", ends: [-200.0, 400.0], step: 100.0, decimals: 0 },
        curves: vec![
            Curve { name: "true peak", class: "bar1", points: vec![peak(&loads)?], dots: Some(6.0) },
            Curve { name: "peak on the grid", class: "bar2", points: vec![peak(&grid)?], dots: Some(6.0) },
            Curve {
                name: "roll moment",
                class: "s0",
                points: moment.into_iter().take_while(|(angle, _)| *angle <= 90.0).collect(),
                dots: None,
            },
            Curve { name: "angles of the grid", class: "dot", points: on_grid, dots: Some(3.5) },
        ],
        labels: Vec::new(),
    })
}

/// The engine of the guide's story on balancing, with its balance shaft.
fn active_angles(program: &Path) -> Result<Chart<'static>> {
    let place = scratch("active-angles")?.join("three.toml");
    let name = place.to_str().context("a name that is no text")?;
    std::fs::write(&place, documents::file_of("docs/src/guide/balancing.md", "three.toml")?)?;
    let answer = asked(program, &["balance", name, "--write"], "")?;
    let stage = answer["stages"].as_array().and_then(|stages| stages.last()).context("no stage")?;
    ensure!(stage["unit"] == "N m", "the last stage is not that of the couple");
    let value = number(&stage["value"])?;
    let loads = asked(program, &["loads", name], "")?;
    let trace = &loads["total"]["trace"];
    let (theta, x, y) =
        (numbers(&trace["theta"])?, numbers(&trace["couple_x"])?, numbers(&trace["couple_y"])?);
    let couple =
        theta.iter().zip(x.iter().zip(&y)).map(|(t, (x, y))| (t.to_degrees(), x.hypot(*y))).collect();
    let active = stage["active"].as_array().context("no active angles")?;
    let angles: Vec<(f64, f64)> =
        active.iter().map(|at| Ok((number(&at["theta"])?.to_degrees(), value))).collect::<Result<_>>()?;
    Ok(Chart {
        x: Axis { says: "crank angle θ [deg]", ends: [0.0, 360.0], step: 90.0, decimals: 0 },
        y: Axis { says: "|M| [N m]", ends: [0.0, 400.0], step: 100.0, decimals: 0 },
        curves: vec![
            Curve { name: "active angles θ_k", class: "bar1", points: angles, dots: Some(6.0) },
            Curve { name: "couple at the optimum", class: "s0", points: couple, dots: None },
            Curve {
                name: "bound",
                class: "s2",
                points: vec![(0.0, number(&stage["lower_bound"])?), (360.0, number(&stage["lower_bound"])?)],
                dots: None,
            },
        ],
        labels: Vec::new(),
    })
}

fn bounds(program: &Path) -> Result<Chart<'static>> {
    let (mut best, mut bound) = (Vec::new(), Vec::new());
    for nodes in [1, 2, 4, 6, 8, 10, 15, 20, 25, 30, 40, 50, 60, 80] {
        let most = nodes.to_string();
        let answer =
            asked(program, &["balance", "examples/twin-270-choices.toml", "--max-nodes", &most], "")?;
        let (stage, nodes) = (&answer["stages"][0], f64::from(nodes));
        best.push((nodes, number(&stage["value"])?));
        bound.push((nodes, number(&stage["lower_bound"])?));
    }
    Ok(Chart {
        x: Axis { says: "most branch-and-bound nodes", ends: [0.0, 80.0], step: 20.0, decimals: 0 },
        y: Axis { says: "force/(1000 N) + couple/(50 N m)", ends: [0.0, 30.0], step: 10.0, decimals: 0 },
        curves: vec![
            Curve { name: "best so far", class: "s0", points: best, dots: None },
            Curve { name: "lower bound", class: "s1", points: bound, dots: None },
        ],
        labels: Vec::new(),
    })
}
