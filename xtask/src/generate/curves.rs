//! Curves of the theory pages, from numbers that the program prints.

use super::chart::{Axis, Chart, Curve, SIZE};
use super::document::{document, file_of};
use super::pen::Pen;
use crate::documents;
use crate::workspace::{root, scratch};
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::f64::consts::PI;
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
pub const CURVES: [Curves; 6] = [
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
        name: "damper-response",
        title: "Twist of one order with three dampers",
        says: "Twist of a six-cylinder crankshaft by order 6 over speed: with little damping a high peak, with very much another one at a lower speed; all curves pass through nearly one point, and the best damping has its peak there.",
        chart: damper_response,
    },
    Curves {
        name: "stress-concentration",
        title: "Stress concentration over the fillet radius",
        says: "The factors of pin and journal fillets over the radius of the fillet: all fall as the radius grows, those of bending most.",
        chart: stress_concentration,
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

/// An example with one text of it in place of another, which it must have.
fn changed(example: &str, from: &str, to: &str) -> Result<String> {
    let text = std::fs::read_to_string(root().join(example))?;
    ensure!(text.contains(from), "{example} has no {from}");
    Ok(text.replace(from, to))
}

fn damper_response(program: &Path) -> Result<Chart<'static>> {
    const ENGINE: &str = "examples/in-line-6-torsion.toml";
    const GIVEN: &str = "damping = \"60 N m s/rad\"";
    let tuned = asked(program, &["torsion", ENGINE, "--tune", "damping"], "")?;
    let best = number(&tuned["tuned"]["damping"])?;
    let cases =
        [(20.0, "s2", "20 N m s/rad"), (best, "s0", "the best damping"), (400.0, "s1", "400 N m s/rad")];
    let mut curves = Vec::new();
    for (damping, class, name) in cases {
        let engine = changed(ENGINE, GIVEN, &format!("damping = \"{damping} N m s/rad\""))?;
        let sweep = &asked(program, &["torsion", "-"], &engine)?["sweep"];
        let orders = numbers(&sweep["orders"])?;
        let index = orders.iter().position(|order| *order == 6.0).context("no order 6")?;
        let speeds = numbers(&sweep["speeds"])?.into_iter().map(|speed| speed * 30.0 / PI);
        let twist = numbers(&sweep["twist"]["by_order"][index])?.into_iter().map(|twist| 1e3 * twist);
        curves.push(Curve { name, class, points: speeds.zip(twist).collect(), dots: None });
    }
    Ok(Chart {
        x: Axis { says: "speed [rpm]", ends: [600.0, 2600.0], step: 500.0, decimals: 0 },
        y: Axis { says: "twist by order 6, amplitude [mrad]", ends: [0.0, 12.0], step: 3.0, decimals: 0 },
        curves,
        labels: Vec::new(),
    })
}

fn stress_concentration(program: &Path) -> Result<Chart<'static>> {
    let names = [
        ("alpha_b", "α_B", "s0"),
        ("alpha_t", "α_T = β_T", "s1"),
        ("beta_b", "β_B", "s2"),
        ("beta_q", "β_Q", "s3"),
    ];
    let mut points = vec![Vec::new(); names.len()];
    for tenths in (15..=60).step_by(5) {
        let radius = format!("fillet = \"{} mm\"", f64::from(tenths) / 10.0);
        let engine = changed("examples/in-line-4-crank-by-elements.toml", "fillet = \"3 mm\"", &radius)?;
        let sheet = asked(program, &["stress", "rule", "-"], &engine)?;
        let web = &sheet["speeds"][0]["throws"][1]["webs"][0];
        let ratio = number(&web["ratios"]["r_pin"])?;
        for (list, (key, ..)) in points.iter_mut().zip(names) {
            list.push((ratio, number(&web["factors"][key]["value"])?));
        }
    }
    let curves = points.into_iter().zip(names).map(|(points, (_, name, class))| Curve {
        name,
        class,
        points,
        dots: None,
    });
    Ok(Chart {
        x: Axis { says: "r = R_H/D = R_G/D", ends: [0.03, 0.13], step: 0.02, decimals: 2 },
        y: Axis { says: "factor", ends: [1.0, 4.0], step: 1.0, decimals: 0 },
        curves: curves.collect(),
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
