//! A graph for other programs: flat Modelica text, GraphML.

use crate::curve::Curve;
use crate::equations::Equations;
use crate::expression::identifier;
use crate::expression::{Id, Printed, Style, Var};
use crate::graph::{Graph, Kind, Law};
use std::fmt::Write;

/// The graph as one flat Modelica model: the laws of elements and junctions without causality, units in comments.
pub fn modelica(equations: &Equations) -> String {
    let graph = &equations.graph;
    let name = |var: Var| equations.variable_name(var, Style::Modelica);
    let printed = Printed { pool: &graph.pool, style: Style::Modelica, name, longest: usize::MAX };
    let law = |id: Id| printed.text(id);
    let var = |var: Var| equations.variable_name(var, Style::Modelica);
    let mut head = format!("model {}\n", model_name(&graph.name));
    for (name, curve) in &graph.pool.curves {
        function(&mut head, &identifier(name), curve);
    }
    let mut body = String::from("equation\n");
    for parameter in &graph.parameters {
        let _ = writeln!(
            head,
            "  parameter Real {} = {:?} \"{}\";",
            identifier(&parameter.name),
            parameter.value,
            parameter.unit
        );
    }
    for (index, bond) in graph.bonds.iter().enumerate() {
        let number = index as u32;
        let units = bond.domain.unit_names();
        let _ = writeln!(head, "  Real {} \"{}\";", var(Var::Effort(number)), units[0]);
        let _ = writeln!(head, "  Real {} \"{}\";", var(Var::Flow(number)), units[1]);
    }
    for (index, signal) in graph.signals.iter().enumerate() {
        let symbol = var(Var::Signal(index as u32));
        match signal.start {
            Some(start) => {
                let _ =
                    writeln!(head, "  Real {symbol}(start = {start:?}, fixed = true) \"{}\";", signal.unit);
                let _ = writeln!(body, "  der({symbol}) = {};", law(signal.value));
            }
            None => {
                let _ = writeln!(head, "  Real {symbol} \"{}\";", signal.unit);
                let _ = writeln!(body, "  {symbol} = {};", law(signal.value));
            }
        }
    }
    for (index, element) in graph.elements.iter().enumerate() {
        let effort = |port: usize| var(Var::Effort(element.ports[port] as u32));
        let flow = |port: usize| var(Var::Flow(element.ports[port] as u32));
        let _ = writeln!(body, "  // {} : {}", element.written, element.name);
        match &element.law {
            Law::Source(value) => {
                let left = if element.kind == Kind::Se { effort(0) } else { flow(0) };
                let _ = writeln!(body, "  {left} = {};", law(*value));
            }
            Law::Resistor { effort: Some(value), .. } => {
                let _ = writeln!(body, "  {} = {};", effort(0), law(*value));
            }
            Law::Resistor { flow: value, .. } => {
                if let Some(value) = value {
                    let _ = writeln!(body, "  {} = {};", flow(0), law(*value));
                }
            }
            Law::Resistors { gives_flows, laws } => {
                for (port, value) in laws.iter().enumerate() {
                    let left = if *gives_flows { flow(port) } else { effort(port) };
                    let _ = writeln!(body, "  {left} = {};", law(*value));
                }
            }
            Law::Store(ports) => {
                for (port, store) in ports.iter().enumerate() {
                    let bond = element.ports[port];
                    let number = bond as u32;
                    let units = graph.bonds[bond].domain.unit_names();
                    let follows = equations.causality.following_bonds.contains(&bond);
                    let mut declare = |symbol: &str, start: f64, unit: &str| {
                        // What a store holds that follows is given by the others.
                        let start = if follows {
                            String::new()
                        } else {
                            format!("(start = {start:?}, fixed = true)")
                        };
                        let _ = writeln!(head, "  Real {symbol}{start} \"{unit}\";");
                    };
                    if let (true, Some(value)) = (store.only_follows(), store.inverse) {
                        let symbol = var(Var::Momentum(number));
                        declare(&symbol, 0.0, units[3]);
                        let _ = writeln!(body, "  {symbol} = {};", law(value));
                        let _ = writeln!(body, "  der({symbol}) = {};", effort(port));
                    }
                    if let Some(value) = store.flow {
                        let symbol = var(Var::Momentum(number));
                        declare(&symbol, store.start[1], units[3]);
                        let less = store.effort.map_or(String::new(), |e| format!(" - ({})", law(e)));
                        let _ = writeln!(body, "  der({symbol}) = {}{less};", effort(port));
                        let _ = writeln!(body, "  {} = {};", flow(port), law(value));
                    }
                    if let Some(value) = store.effort {
                        let symbol = var(Var::Displacement(number));
                        declare(&symbol, store.start[0], units[2]);
                        let gain = store.gain.map_or(String::new(), |gain| format!(" + {}", law(gain)));
                        let _ = writeln!(body, "  der({symbol}) = {}{gain};", flow(port));
                        if store.flow.is_none() {
                            let _ = writeln!(body, "  {} = {};", effort(port), law(value));
                        }
                    }
                }
            }
            Law::Ratio(ratio) if element.kind == Kind::TF => {
                let _ = writeln!(body, "  {} = ({})*{};", flow(1), law(*ratio), flow(0));
                let _ = writeln!(body, "  {} = ({})*{};", effort(0), law(*ratio), effort(1));
            }
            Law::Ratio(ratio) => {
                let _ = writeln!(body, "  {} = ({})*{};", effort(0), law(*ratio), flow(1));
                let _ = writeln!(body, "  {} = ({})*{};", effort(1), law(*ratio), flow(0));
            }
            Law::Matrix(rows) => {
                let columns = rows[0].len();
                for (row, entries) in rows.iter().enumerate() {
                    let terms: Vec<String> = entries
                        .iter()
                        .enumerate()
                        .map(|(column, id)| format!("({})*{}", law(*id), flow(column)))
                        .collect();
                    let _ = writeln!(body, "  {} = {};", flow(columns + row), terms.join(" + "));
                }
                for column in 0..columns {
                    let terms: Vec<String> = rows
                        .iter()
                        .enumerate()
                        .map(|(row, entries)| format!("({})*{}", law(entries[column]), effort(columns + row)))
                        .collect();
                    let _ = writeln!(body, "  {} = {};", effort(column), terms.join(" + "));
                }
            }
            Law::Junction => {
                let zero = element.kind == Kind::Zero;
                let common = |port: usize| if zero { effort(port) } else { flow(port) };
                for port in 1..element.ports.len() {
                    let _ = writeln!(body, "  {} = {};", common(port), common(0));
                }
                let terms: Vec<String> = (0..element.ports.len())
                    .map(|port| {
                        let sign =
                            if graph.bonds[element.ports[port]].sign_into(index) > 0.0 { "+" } else { "-" };
                        format!("{sign} {}", if zero { flow(port) } else { effort(port) })
                    })
                    .collect();
                let _ = writeln!(body, "  0 = {};", terms.join(" "));
            }
        }
    }
    for rule in &graph.rules {
        let _ = writeln!(body, "  when ({}) > 0 then", law(rule.when));
        for (state, value) in &rule.set {
            let _ = writeln!(body, "    reinit({}, {});", var(*state), law(*value));
        }
        if rule.stop {
            let _ = writeln!(body, "    terminate(\"stopped by an event\");");
        }
        let _ = writeln!(body, "  end when;");
    }
    let _ = writeln!(body, "end {};", model_name(&graph.name));
    head + &body
}

/// A table as a function: the piece is found by halving, and continued by none.
fn function(out: &mut String, name: &str, curve: &Curve) {
    let (pieces, end) = curve.pieces();
    let count = pieces.len();
    let first = pieces.first().map_or(0.0, |(start, _)| *start);
    let starts: Vec<String> = pieces.iter().map(|(start, _)| format!("{start:?}")).collect();
    let rows: Vec<String> =
        pieces.iter().map(|(_, [a, b, c, d])| format!("{{{a:?}, {b:?}, {c:?}, {d:?}}}")).collect();
    let inside = if curve.is_periodic() {
        format!("{first:?} + mod(x - ({first:?}), {:?})", end - first)
    } else {
        format!("min(max(x, {first:?}), {end:?})")
    };
    let _ = write!(
        out,
        "  function {name}\n    input Real x;\n    output Real y;\n  protected\n    constant Real starts[{count}] = {{{}}};\n    \
         constant Real pieces[{count}, 4] = {{{}}};\n    Real s;\n    Real h;\n    Integer low;\n    Integer high;\n    Integer middle;\n  \
         algorithm\n    s := {inside};\n    low := 1;\n    high := {};\n    while high - low > 1 loop\n      \
         middle := div(low + high, 2);\n      if starts[middle] <= s then\n        low := middle;\n      else\n        \
         high := middle;\n      end if;\n    end while;\n    h := s - starts[low];\n    \
         y := pieces[low, 1] + h*(pieces[low, 2] + h*(pieces[low, 3] + h*pieces[low, 4]));\n  end {name};\n",
        starts.join(", "),
        rows.join(", "),
        count + 1
    );
}

fn model_name(name: &str) -> String {
    let name = identifier(name);
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("graph_{name}") }
}

/// The graph as GraphML: a node for each element, a directed edge for each bond with its domain and causal stroke.
pub fn graphml(equations: &Equations) -> String {
    let graph: &Graph = &equations.graph;
    let mut out = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n",
    );
    for (id, of) in [("kind", "node"), ("domain", "edge"), ("stroke", "edge")] {
        let _ = writeln!(out, "  <key id=\"{id}\" for=\"{of}\" attr.name=\"{id}\" attr.type=\"string\"/>");
    }
    let _ = writeln!(out, "  <graph id=\"{}\" edgedefault=\"directed\">", escaped(&graph.name));
    for element in &graph.elements {
        let _ = writeln!(
            out,
            "    <node id=\"{}\"><data key=\"kind\">{}</data></node>",
            escaped(&element.name),
            escaped(&element.written)
        );
    }
    for (index, bond) in graph.bonds.iter().enumerate() {
        let stroke = if equations.causality.stroke_at_head[index] { "head" } else { "tail" };
        let _ = writeln!(
            out,
            "    <edge id=\"b{}\" source=\"{}\" target=\"{}\"><data key=\"domain\">{}</data><data key=\"stroke\">{stroke}</data></edge>",
            index + 1,
            escaped(&graph.elements[bond.from].name),
            escaped(&graph.elements[bond.to].name),
            bond.domain.name()
        );
    }
    out + "  </graph>\n</graphml>\n"
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
