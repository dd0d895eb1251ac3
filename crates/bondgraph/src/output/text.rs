//! Results as text for people, and samples as CSV.

use crate::causality::Causality;
use crate::causality::loops::AlgebraicLoop;
use crate::graph::Graph;
use crate::linear::{Linear, Transfer};
use crate::output::parts::EquationPart;
use crate::output::shown::{Notation, ShownEquations};
use crate::run::motion::{PeriodicEnd, PeriodicMotion};
use crate::run::simulate::Simulation;
use std::fmt::Write;

/// Rows of a run that are shown at most where not all are asked for.
const MOST_ROWS: usize = 40;
/// Events that are listed at most.
const MOST_EVENTS: usize = 12;
/// Multipliers that are listed at most.
const MOST_MULTIPLIERS: usize = 12;

/// Causality in words.
pub fn causality_text(graph: &Graph, causality: &Causality) -> String {
    let mut out = format!("{}: causality, step by step\n", graph.name);
    for (index, step) in causality.steps.iter().enumerate() {
        let _ = writeln!(out, "{:3}. {}; settled: {}", index + 1, step.text, step.bonds.join(", "));
    }
    let _ = writeln!(out, "\nStates: {}", listed(&causality.states));
    if causality.followers.is_empty() {
        out += "No store follows others.\n";
    }
    for follower in &causality.followers {
        let (first, rest) = follower.path.split_first().map_or(("", [].as_slice()), |(f, r)| (f.as_str(), r));
        let through = rest.split_last().map_or(String::new(), |(_, through)| through.join(", "));
        let through = if through.is_empty() { through } else { format!(" through {through}") };
        if follower.path.len() == 1 {
            let _ = writeln!(out, "{} follows by choice: not a state", follower.element);
            continue;
        }
        let _ = writeln!(out, "{} follows {first}{through}: not a state", follower.element);
    }
    if causality.loops.is_empty() {
        out += "No algebraic loop.\n";
    }
    for AlgebraicLoop { elements, cut_at } in &causality.loops {
        let _ = writeln!(out, "Algebraic loop of {}, cut at {}", elements.join(", "), cut_at.join(" and "));
    }
    out
}

/// A graph in a few lines: what it is made of, which stores are states, how many follow.
pub fn graph_text(graph: &Graph, causality: &Causality) -> String {
    let mut kinds: Vec<(&str, usize)> = Vec::new();
    for element in &graph.elements {
        let written = element.written.as_str();
        match kinds.iter_mut().find(|(known, _)| *known == written) {
            Some((_, count)) => *count += 1,
            None => kinds.push((written, 1)),
        }
    }
    let kinds: Vec<String> = kinds.into_iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    let mut out =
        format!("{}: {} elements and {} bonds\n", graph.name, graph.elements.len(), graph.bonds.len());
    let _ = writeln!(out, "elements: {}", kinds.join(", "));
    let _ = writeln!(out, "{} stores are states: {}", causality.states.len(), listed(&causality.states));
    let follow = match causality.followers.len() {
        0 => "no store follows others".to_owned(),
        count => format!("{count} stores follow others: no states of their own"),
    };
    let loops = match causality.loops.len() {
        0 => "no algebraic loop".to_owned(),
        1 => "one algebraic loop".to_owned(),
        count => format!("{count} algebraic loops"),
    };
    let _ = writeln!(out, "{follow}; {loops}");
    out
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "none".into() } else { names.join(", ") }
}

/// Equations as plain text.
pub fn equations_text(shown: &ShownEquations) -> String {
    let mut out = format!("{}\n", shown.graph);
    for EquationPart { title, lines } in shown.parts() {
        let _ = writeln!(out, "\n{title}");
        for line in &lines {
            let unit = match line.equation.unit.as_str() {
                "" => String::new(),
                unit => format!("   [{unit}]"),
            };
            let why = line.why.as_ref().map_or(String::new(), |why| format!(" ({why})"));
            let _ = writeln!(out, "  {}{unit}{why}", line.formula(Notation::Text));
        }
    }
    out
}

/// The linear form as text.
pub fn linear_text(linear: &Linear) -> String {
    let mut out = String::new();
    let blocks = [
        ("A", &linear.a, &linear.states, &linear.states),
        ("B", &linear.b, &linear.states, &linear.inputs),
        ("C", &linear.c, &linear.outputs, &linear.states),
        ("D", &linear.d, &linear.outputs, &linear.inputs),
    ];
    for (name, rows, row_names, columns) in blocks {
        if rows.is_empty() || columns.is_empty() {
            continue;
        }
        let _ = writeln!(out, "{name}   columns: {}", columns.join(", "));
        for (row, values) in row_names.iter().zip(rows.iter()) {
            let values: Vec<String> = values.iter().map(|value| format!("{value:>13.6e}")).collect();
            let _ = writeln!(out, "  {row:<28} {}", values.join(" "));
        }
        out.push('\n');
    }
    out += "Poles        real [1/s]  imaginary [rad/s]   damping ratio   natural frequency [Hz]\n";
    for pole in &linear.poles {
        let _ = writeln!(
            out,
            "        {:>15} {:>18} {:>15} {:>24}",
            digits(pole.real),
            digits(pole.imaginary),
            digits(pole.damping),
            digits(pole.hertz)
        );
    }
    if !linear.transfer.is_empty() {
        out += "\nTransfer functions, in powers of s\n";
    }
    for transfer in &linear.transfer {
        let _ = writeln!(
            out,
            "  {} / {} = ({}) / ({})",
            transfer.output,
            transfer.input,
            polynomial(&transfer.numerator),
            polynomial(&transfer.denominator)
        );
    }
    out
}

/// Six significant digits, without zeros at the end.
fn digits(value: f64) -> String {
    significant(value, 6)
}

/// So many significant digits, without zeros at the end.
fn significant(value: f64, count: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { value.to_string() };
    }
    // The exponent after rounding to the digits that are shown.
    let scientific = format!("{value:.*e}", count - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let short = |text: &str| -> String {
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        } else {
            text.to_owned()
        }
    };
    match exponent {
        -4..=5 => short(&format!("{value:.*}", (count as i32 - 1 - exponent).max(0) as usize)),
        _ => format!("{}e{exponent}", short(mantissa)),
    }
}

fn polynomial(coefficients: &[f64]) -> String {
    let terms: Vec<String> = coefficients
        .iter()
        .enumerate()
        .rev()
        .filter(|(_, c)| **c != 0.0)
        .map(|(power, c)| {
            let number = digits(*c);
            let factor = match number.as_str() {
                "1" if power > 0 => String::new(),
                "-1" if power > 0 => "-".into(),
                _ if power > 0 => format!("{number} "),
                _ => number,
            };
            match power {
                0 => factor,
                1 => format!("{factor}s"),
                _ => format!("{factor}s^{power}"),
            }
        })
        .collect();
    if terms.is_empty() { "0".into() } else { terms.join(" + ").replace("+ -", "- ") }
}

impl Transfer {
    /// As a fraction in LaTeX, in falling powers of s.
    pub fn latex(&self) -> String {
        let of = |coefficients: &[f64]| -> String {
            let mut out = String::new();
            for word in polynomial(coefficients).split(' ') {
                let power = word.strip_prefix("s^").map(|power| format!("s^{{{power}}}"));
                let number = word.split_once('e').map(|(m, e)| format!("{m}\\cdot 10^{{{e}}}"));
                out += &power.or(number).unwrap_or_else(|| word.to_owned());
                out.push(' ');
            }
            out.trim_end().to_owned()
        };
        match self.denominator.as_slice() {
            [_] => of(&self.numerator),
            _ => format!("\\frac{{{}}}{{{}}}", of(&self.numerator), of(&self.denominator)),
        }
    }
}

/// A simulation as text: how it ran, of an engine its speed, torque and block, and the extremes of every quantity.
pub fn simulation_text(run: &Simulation) -> String {
    simulation_head(run) + &quantities_text(run, run.series.len())
}

/// The same with the extremes of states and signals alone where there are many quantities, and the number of those that are left out.
pub fn simulation_text_in_short(run: &Simulation) -> (String, usize) {
    // States come first.
    let bonds = run.series.iter().position(|own| own.name.ends_with(".effort")).unwrap_or(run.series.len());
    let shown = if run.series.len() <= MOST_ROWS { run.series.len() } else { bonds.min(MOST_ROWS) };
    (simulation_head(run) + &quantities_text(run, shown), run.series.len() - shown)
}

/// Of a run of an engine: speed, torque of load or drive, way of the block.
fn engine_text(run: &Simulation) -> String {
    let (Some(_), Some(speed)) = (run.values("theta"), run.values("crank.flow")) else {
        return String::new();
    };
    let four = |value: f64| significant(value, 4);
    let rpm = 30.0 / std::f64::consts::PI;
    // A crank that stands keeps what rounding leaves of its speed.
    let tenths = |value: f64| format!("{:.1}", (10.0 * value).round() / 10.0 + 0.0);
    let range = |values: &[f64]| {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        values.iter().fold(ends, |(least, most), value| (least.min(*value), most.max(*value)))
    };
    let (least, most) = range(speed);
    let (first, last) = (speed.first().unwrap_or(&f64::NAN), speed.last().unwrap_or(&f64::NAN));
    let mut out = format!(
        "speed of crankshaft 1: {} rpm at the start, {} rpm at the end, {} to {} rpm on the way\n",
        tenths(rpm * first),
        tenths(rpm * last),
        tenths(rpm * least),
        tenths(rpm * most)
    );
    for (name, what) in [("load", "load"), ("drive", "drive that keeps the speed")] {
        let Some(torque) = run.values(&format!("{name}.effort")) else { continue };
        let (least, most) = range(torque);
        let pairs = run.time.windows(2).zip(torque.windows(2));
        let integral: f64 = pairs.map(|(t, torque)| 0.5 * (t[1] - t[0]) * (torque[0] + torque[1])).sum();
        let length = run.time.last().unwrap_or(&0.0) - run.time.first().unwrap_or(&0.0);
        if length > 0.0 {
            let mean = four(integral / length);
            let _ = writeln!(
                out,
                "torque of the {what}: {mean} N m on average, {} to {} N m",
                four(least),
                four(most)
            );
        }
    }
    let ways: Vec<String> = ["x", "y", "z"]
        .iter()
        .filter_map(|axis| {
            let (least, most) = range(run.values(&format!("{axis}_block"))?);
            Some(format!("{} mm in {axis}", four(1e3 * (most - least))))
        })
        .collect();
    if !ways.is_empty() {
        let _ = writeln!(out, "the block moves to and fro by {}", ways.join(", "));
    }
    out + "\n"
}

/// How a run went.
fn simulation_head(run: &Simulation) -> String {
    let methods: Vec<&str> = run
        .methods
        .iter()
        .map(|method| match method {
            crate::run::simulate::Method::Explicit => "DOP853 (explicit, order 8)",
            crate::run::simulate::Method::Implicit => "Radau IIA (implicit, order 5)",
        })
        .collect();
    let mut out = format!("{}: {}\n", run.graph, run.ended);
    out += &engine_text(run);
    let _ = writeln!(out, "method: {}; tolerance {:e}", methods.join(", then "), run.tolerance);
    if let Some(from) = run.stiff_from {
        let _ = writeln!(
            out,
            "stiff from {from:.6} s on, by measurement: steps were held by stability, not by accuracy"
        );
    }
    let s = &run.statistics;
    let _ = writeln!(
        out,
        "{} steps, {} rejected, {} evaluations of {} operations, {} events\n",
        s.steps, s.rejected, s.evaluations, run.operations, s.events
    );
    if let Some(periodic) = &run.periodic {
        out += &periodic_text(periodic);
    }
    out + &events_text(run)
}

/// Start, extremes and end of the first quantities.
fn quantities_text(run: &Simulation, count: usize) -> String {
    let mut out = String::new();
    let _ =
        writeln!(out, "{:<32} {:>15} {:>15} {:>15} {:>15}", "quantity", "start", "least", "largest", "end");
    for series in &run.series[..count] {
        let least = series.values.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = series.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (first, last) = (series.values.first(), series.values.last());
        let _ = writeln!(
            out,
            "{:<32} {:>15.7e} {least:>15.7e} {largest:>15.7e} {:>15.7e}",
            format!("{} [{}]", series.name, series.unit),
            first.copied().unwrap_or(f64::NAN),
            last.copied().unwrap_or(f64::NAN)
        );
    }
    out
}

/// The first events with time and condition.
fn events_text(run: &Simulation) -> String {
    let mut out = String::new();
    if run.events.is_empty() {
        return out;
    }
    out += "events\n";
    for event in run.events.iter().take(MOST_EVENTS) {
        let (what, becomes) = match (event.expression.strip_suffix(" sticks"), event.on) {
            (Some(speed), true) => (speed, "sticks"),
            (Some(speed), false) => (speed, "gives way"),
            (None, true) => (event.expression.as_str(), "becomes true"),
            (None, false) => (event.expression.as_str(), "ends"),
        };
        let _ = writeln!(out, "  {:>14.9} s  {what} {becomes}", event.time);
    }
    if run.events.len() > MOST_EVENTS {
        let _ = writeln!(out, "  and {} more (all in JSON)", run.events.len() - MOST_EVENTS);
    }
    out + "\n"
}

/// How the search for a periodic motion ended.
fn periodic_text(motion: &PeriodicMotion) -> String {
    let found = match motion.outcome {
        PeriodicEnd::Stable if motion.multipliers.is_empty() => "given: no state is free to depart from it",
        PeriodicEnd::Stable => "stable: what departs from it comes back",
        PeriodicEnd::Neutral => "neutral: some departures stay, for example of a speed that nothing prefers",
        PeriodicEnd::Unstable => "unstable: small departures grow",
        PeriodicEnd::NotFound => "not found",
    };
    let mut out = format!("periodic motion: {found}\n");
    if let Some(instead) = &motion.instead {
        let _ = writeln!(out, "what happened instead: {instead}");
    } else {
        let _ = writeln!(
            out,
            "period {} s; changes over it {:.1e} of the size of each state after {} iterations",
            motion.period, motion.residual, motion.iterations
        );
    }
    let shown: Vec<String> = (motion.multipliers.iter().take(MOST_MULTIPLIERS))
        .filter(|[_, imaginary]| *imaginary >= 0.0)
        .map(|[real, imaginary]| match *imaginary {
            0.0 => format!("{real:.6}"),
            imaginary => format!("{real:.6} ± {imaginary:.6} i"),
        })
        .collect();
    if !shown.is_empty() {
        let _ = writeln!(out, "multipliers, the largest first: {}", shown.join(", "));
    }
    out + "\n"
}

/// The samples as CSV, one row each.
pub fn simulation_csv(run: &Simulation) -> String {
    let mut out = String::from("time [s]");
    for series in &run.series {
        let _ = write!(out, ",{} [{}]", series.name, series.unit);
    }
    out.push('\n');
    for (index, time) in run.time.iter().enumerate() {
        let _ = write!(out, "{time}");
        for series in &run.series {
            let _ = write!(out, ",{}", series.values[index]);
        }
        out.push('\n');
    }
    out
}

/// The energy audit as text.
pub fn audit_text(run: &Simulation) -> String {
    let Some(audit) = &run.audit else { return String::new() };
    let mut out = format!("{}: energy through every bond, {}\n\n", run.graph, run.ended);
    for bond in &audit.bonds {
        let _ = writeln!(out, "{:<32} {:>16.8e} J", bond.bond, bond.energy);
    }
    // What events took is a column where there are any.
    let with_events = audit.elements.iter().any(|element| element.taken_by_events.is_some());
    let width = audit.elements.iter().map(|own| own.element.chars().count()).max().unwrap_or(0).max(20);
    let row = |cells: [&str; 5]| {
        let [element, taken, events, held, error] = cells;
        let events = if with_events { format!(" {events:>20}") } else { String::new() };
        format!("{element:<width$} {taken:>16}{events} {held:>16} {error:>12}\n")
    };
    out += "\n";
    out += &row(["element", "took in [J]", "taken by events [J]", "holds more [J]", "error"]);
    for element in &audit.elements {
        let joule = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:.8e}"));
        let error = element.error.map_or(String::new(), |error| format!("{error:.1e}"));
        let [taken, events, held] = [Some(element.taken), element.taken_by_events, element.held].map(joule);
        out += &row([&element.element, &taken, &events, &held, &error]);
    }
    let worst = audit.residuals.iter().map(|r| r.error).fold(0.0, f64::max);
    let _ = writeln!(out, "\nlargest power lost in a junction or two-port: {worst:.1e} of the power there");
    let _ = writeln!(out, "error of the whole: {:.1e}", audit.whole);
    let _ = writeln!(
        out,
        "errors are shares of {:.6e} J: what `{}` carried to and fro between the samples, the most of all bonds",
        audit.throughput, audit.measured_at
    );
    out
}
