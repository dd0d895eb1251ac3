//! The section of the report on the engine as a bond graph.

use crate::graph::picture::{kept, picture, stem};
use crate::kit::figure::Figure;
use crate::kit::flow::energy_flow;
use crate::kit::number;
use crate::kit::section::Section;
use crate::kit::table::{Cell, Column, Table};
use crate::simulated::figure::{curve, figure, panel};
use lanchester_bondgraph::{
    Audit, Causality, Equation, Kind, Placed, ShownEquations, ShownUnknown, Simulation, mathml,
};
use serde::Serialize;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Version of [`BondGraphResult`]; raised when a field changes its meaning or goes.
pub const BOND_GRAPH_VERSION: u32 = 1;

/// Longest equation of a table, in letters.
const LONGEST: usize = 240;
/// More common parts of the state equations than these are not written out.
const MOST_PARTS: usize = 40;
/// Curves of power in one plot.
const CURVES: usize = 5;

/// The engine as a bond graph, with a run of one working cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BondGraphResult {
    /// [`BOND_GRAPH_VERSION`].
    pub version: u32,
    /// What was assumed, and what of the file the graph leaves out.
    pub notes: Vec<String>,
    /// Places of its elements and bonds.
    pub drawing: Placed,
    /// Its causality.
    pub causality: Causality,
    /// Its equations as plain text.
    pub equations: ShownEquations,
    /// The same in LaTeX, in the same order.
    pub formulas: ShownEquations,
    /// A run of one working cycle with the energy through every bond.
    pub run: Simulation,
}

/// The engine as a bond graph, as a section of a report.
pub fn bond_graph_section(result: &BondGraphResult) -> Section {
    let section = Section::new("bond-graph", "Bond graph", "As a bond graph")
        .words(
            "Every part as an element that exchanges power through bonds: an effort and a flow whose product is power. The graph shares \
             nothing with the other computations but the engine file.",
        )
        .paragraphs(result.notes.iter().cloned())
        .words(causality_words(result))
        .rows(picture(&result.drawing))
        .tables(causality_tables(&result.equations, &result.causality))
        .tables(equation_tables(result))
        .paragraphs(not_written_out(&result.equations))
        .words(run_words(&result.run))
        .rows(curves(&result.run));
    match &result.run.audit {
        Some(audit) => {
            section.words(audit_words(audit)).rows(energy_figure(audit)).tables([energy_table(audit)])
        }
        None => section,
    }
}

fn causality_words(result: &BondGraphResult) -> String {
    let Placed { elements, bonds, .. } = &result.drawing;
    let Causality { states, followers, loops, .. } = &result.causality;
    let loops = match loops.as_slice() {
        [] => "There is no algebraic loop.".to_owned(),
        loops => {
            let each = loops.iter().map(|own| {
                format!("through {}, cut at {}", own.elements.join(", "), own.cut_at.join(" and "))
            });
            format!("Algebraic loops: {}.", each.collect::<Vec<_>>().join("; "))
        }
    };
    format!(
        "{} elements and {} bonds. {} stores are in integral causality and {} follow others. {loops}",
        elements.len(),
        bonds.len(),
        states.len(),
        followers.len()
    )
}

fn words_table(id: &'static str, title: &str, note: &str, heads: &[&str], rows: Vec<Vec<Cell>>) -> Table {
    // Numbers first: a first column of names would be set with indices.
    let columns =
        std::iter::once(Column::words("no.")).chain(heads.iter().map(|head| Column::words(*head))).collect();
    let rows = rows
        .into_iter()
        .enumerate()
        .map(|(index, row)| std::iter::once(Cell::text((index + 1).to_string())).chain(row).collect());
    Table { id, title: title.into(), note: note.into(), remark: String::new(), columns, rows: rows.collect() }
}

/// States, and stores that follow, those of tiles that are alike once.
pub fn causality_tables(equations: &ShownEquations, causality: &Causality) -> Vec<Table> {
    let states = equations.states.iter();
    let rows = states.map(|state| {
        vec![Cell::text(&state.symbol), Cell::text(number::short(state.start, 6)), Cell::text(&state.unit)]
    });
    let note = "Momenta and displacements of stores in integral causality, and integrals of signals.";
    let mut tables =
        vec![words_table("bond-graph-states", "States", note, &["state", "start", "unit"], rows.collect())];
    // Stores of like parts, with the first of their paths.
    let mut alike: Vec<(String, Vec<&str>, String)> = Vec::new();
    for follower in &causality.followers {
        let key = stem(&follower.element);
        match alike.iter_mut().find(|(known, ..)| *known == key) {
            Some((_, names, _)) => names.push(&follower.element),
            None => alike.push((key, vec![&follower.element], follower.path.join(", "))),
        }
    }
    if !alike.is_empty() {
        let rows =
            alike.into_iter().map(|(_, names, path)| vec![Cell::text(names.join(", ")), Cell::text(path)]);
        tables.push(words_table(
            "bond-graph-followers",
            "Stores that follow others",
            "In derivative causality: no states. Through: of the first of them, what leads it first.",
            &["store", "through"],
            rows.collect(),
        ));
    }
    tables
}

/// Whether the common parts of the state equations are too many for a report.
fn is_long(shown: &ShownEquations) -> bool {
    shown.common.len() > MOST_PARTS
}

/// That common parts are left out, and how many.
fn not_written_out(shown: &ShownEquations) -> Option<String> {
    is_long(shown).then(|| {
        format!(
            "The {} common parts of the state equations are not printed here: the equations of the graph, computed by themselves, have them all.",
            shown.common.len()
        )
    })
}

/// Equations as text, and the same in LaTeX.
type Pairs = Vec<(Equation, Equation)>;

/// Laws of the elements that are drawn, junctions, and state equations where they can be read; long ones are left out and counted.
fn equation_tables(result: &BondGraphResult) -> Vec<Table> {
    let (shown, formulas) = (&result.equations, &result.formulas);
    let kept = kept(&result.drawing);
    let names: Vec<&str> = kept.iter().flat_map(|kept| kept.elements.iter().copied()).collect();
    let is_drawn = |equation: &Equation| names.is_empty() || names.contains(&equation.of.as_str());
    let pairs = |texts: &[Equation], formulas: &[Equation], is_kept: &dyn Fn(&Equation) -> bool| -> Pairs {
        let both = texts.iter().cloned().zip(formulas.iter().cloned());
        both.filter(|(text, _)| is_kept(text)).collect()
    };
    let all = |_: &Equation| true;
    let is_printed = |_: &Equation| !is_long(shown);
    let is_first = |equation: &Equation| !ends_with_other_number(&equation.of);
    [
        ("bond-graph-laws", "Laws of the elements", pairs(&shown.elements, &formulas.elements, &is_drawn)),
        (
            "bond-graph-junctions",
            "Laws of the junctions",
            pairs(&shown.junctions, &formulas.junctions, &is_drawn),
        ),
        ("bond-graph-signals", "Signals", pairs(&shown.signals, &formulas.signals, &is_first)),
        (
            "bond-graph-common",
            "Common parts of the state equations",
            pairs(&shown.common, &formulas.common, &is_printed),
        ),
        (
            "bond-graph-unknowns",
            "Rates of stores that follow, and what cuts loops",
            pairs(&unknowns(shown, shown), &unknowns(formulas, shown), &all),
        ),
        ("bond-graph-equations", "State equations", pairs(&shown.rates, &formulas.rates, &all)),
    ]
    .into_iter()
    .filter_map(|(id, title, equations)| equation_table(id, title, equations))
    .collect()
}

/// The unknowns of `from`; where the text is too long to be written out, the derivative as it stands.
fn unknowns(from: &ShownEquations, text: &ShownEquations) -> Vec<Equation> {
    let equation = |(unknown, text): (&ShownUnknown, &ShownUnknown)| {
        let first = unknown.value.split(" = ").next().unwrap_or_default();
        let right = if text.value.len() > LONGEST { first } else { &unknown.value };
        let (left, unit) = (unknown.symbol.clone(), unknown.unit.clone());
        Equation { of: text.symbol.clone(), left, right: right.to_owned(), unit }
    };
    from.unknowns.iter().zip(&text.unknowns).map(equation).collect()
}

fn equation_table(id: &'static str, title: &str, equations: Pairs) -> Option<Table> {
    let (short, long): (Pairs, Pairs) =
        equations.into_iter().partition(|(equation, _)| equation.right.len() <= LONGEST);
    let row = |(text, formula): (Equation, Equation)| {
        let formula = Cell::Formula {
            text: format!("{} = {}", text.left, text.right),
            mathml: mathml(&format!("{} = {}", formula.left, formula.right)),
        };
        vec![Cell::text(&text.of), formula, Cell::text(&text.unit)]
    };
    if short.is_empty() {
        return None;
    }
    let rows = short.into_iter().map(row).collect();
    let mut table = words_table(id, title, "", &["of", "equation", "unit"], rows);
    if !long.is_empty() {
        table.remark = format!("{} of more than {LONGEST} letters are left out.", long.len());
    }
    Some(table)
}

/// Whether a name ends with the number of another cylinder than the first.
fn ends_with_other_number(name: &str) -> bool {
    let letters = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let digits = &name[letters.len()..];
    !digits.is_empty() && digits != "1" && !letters.ends_with('r')
}

fn run_words(run: &Simulation) -> String {
    let end = run.time.last().copied().unwrap_or(0.0);
    let done = if run.complete { "complete".to_owned() } else { format!("incomplete: {}", run.ended) };
    format!(
        "One working cycle from the start: {done}, {} s. Cost: {} steps, {} evaluations of {} operations.",
        number::short(end, 4),
        run.statistics.steps,
        run.statistics.evaluations,
        run.operations
    )
}

/// Speed, motion of the block, and the powers that are largest, over the revolutions.
fn curves(run: &Simulation) -> Vec<Figure> {
    let Some(theta) = run.values("theta").filter(|theta| theta.len() > 1) else { return Vec::new() };
    let start = theta[0];
    let over = |values: &[f64], factor: f64| -> Vec<(f64, f64)> {
        theta.iter().zip(values).map(|(theta, value)| ((theta - start) / TAU, factor * value)).collect()
    };
    let mut panels = Vec::new();
    if let Some(speed) = run.values("crank.flow") {
        let curves = vec![curve("speed", 0, over(speed, 30.0 / PI))];
        panels.push(panel(["revolutions", "speed of crankshaft 1"], ["1", "rpm"], None, curves));
    }
    for (title, unit, names) in [
        ("velocity of the block's centre", "m/s", ["vx", "vy", "vz"]),
        ("angular velocity of the block", "rad/s", ["wx", "wy", "wz"]),
    ] {
        let known = names.iter().enumerate();
        let curves: Vec<_> = known
            .filter_map(|(style, name)| {
                let values = run.values(&format!("{name}.flow"))?;
                Some(curve(&name[1..], style, over(values, 1.0)))
            })
            .collect();
        if !curves.is_empty() {
            panels.push(panel(["revolutions", title], ["1", unit], None, curves));
        }
    }
    let mut powers: Vec<(&str, &[f64], f64)> = run
        .audit
        .iter()
        .flat_map(|audit| &audit.elements)
        .filter_map(|element| {
            let values = run.values(&format!("{}.power", element.element))?;
            let most = values.iter().fold(0.0f64, |most, power| most.max(power.abs()));
            Some((element.element.as_str(), values, most))
        })
        .collect();
    powers.sort_by(|a, b| b.2.total_cmp(&a.2));
    powers.truncate(CURVES);
    let curves: Vec<_> = powers
        .iter()
        .enumerate()
        .map(|(style, (name, values, _))| curve(&name.replace('_', " "), style, over(values, 1.0)))
        .collect();
    if !curves.is_empty() {
        panels.push(panel(["revolutions", "largest powers"], ["1", "W"], None, curves));
    }
    let caption = "Powers along the half arrow: into stores and resistors, out of sources.";
    vec![figure("bond-graph-curves", "One working cycle of the bond graph", caption, panels)]
}

fn audit_words(audit: &Audit) -> String {
    let worst = audit.residuals.iter().fold(0.0f64, |most, residual| most.max(residual.error));
    let store = audit.elements.iter().filter_map(|element| element.error).fold(0.0f64, f64::max);
    format!(
        "Energy: all one-ports together took in {:.1e} of what {} carried to and fro ({} J, the most of all bonds). Powers at junctions, \
         transformers and gyrators cancel to {worst:.1e} of the largest there; stores hold what they took in to {store:.1e}.",
        audit.whole,
        audit.measured_at,
        number::short(audit.throughput, 4)
    )
}

/// What an element's energy counts as.
fn group(kind: Kind, element: &str) -> String {
    if element.contains("weight") {
        return "weight".into();
    }
    match kind {
        Kind::I => "kinetic energy".into(),
        Kind::C => "springs".into(),
        _ => {
            let words = stem(element).replace('_', " ");
            words.split_whitespace().collect::<Vec<_>>().join(" ")
        }
    }
}

/// Energies that groups of elements took in [J].
fn groups(audit: &Audit) -> BTreeMap<String, f64> {
    let mut groups: BTreeMap<String, f64> = BTreeMap::new();
    for element in &audit.elements {
        *groups.entry(group(element.kind, &element.element)).or_default() += element.taken;
    }
    groups
}

fn energy_figure(audit: &Audit) -> Option<Figure> {
    let groups = groups(audit);
    let side = |sign: f64| -> Vec<(String, f64)> {
        let of = groups.iter().filter(|(_, taken)| sign * **taken > 0.0);
        of.map(|(name, taken)| (name.clone(), taken.abs())).collect()
    };
    let panel = energy_flow(&side(-1.0), &side(1.0), &[])?;
    let caption = "Energy that elements gave, left, and took in, right, over the cycle; elements that are alike together.";
    Some(figure("bond-graph-energy", "Energy through the bonds", caption, vec![panel]))
}

fn energy_table(audit: &Audit) -> Table {
    let rows = groups(audit).into_iter().map(|(name, taken)| vec![Cell::text(name), Cell::number(taken, 6)]);
    Table {
        id: "bond-graph-energy",
        title: "Energy by elements".into(),
        note: "What they took in over the cycle; negative: what they gave.".into(),
        remark: String::new(),
        columns: vec![Column::words("elements"), Column::numbers("energy", "J")],
        rows: rows.collect(),
    }
}
