//! Results of a CalculiX deck: their tables.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_flex::mesh::MeshQuality;
use lanchester_flex::modes::ModeSolution;
use lanchester_flex::sparse::SolveReport;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const DECK_VERSION: u32 = 1;

/// A deck, solved.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SolvedDeck {
    /// [`DECK_VERSION`].
    pub version: u32,
    /// Its mesh.
    pub quality: MeshQuality,
    /// Its steps, in order.
    pub steps: Vec<SolvedStep>,
}

/// A step.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum SolvedStep {
    /// `*STATIC`.
    Static(StaticStep),
    /// `*FREQUENCY`.
    Frequency(ModeSolution),
}

/// A static step.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StaticStep {
    /// Elastic energy [J].
    pub energy: f64,
    /// Largest displacement [m], and the number of its node in the deck.
    pub largest_displacement: (f64, u32),
    /// Largest von Mises stress [Pa], the number of its node, and the jump there over it.
    pub largest_stress: (f64, u32, f64),
    /// Sum of all loads [N].
    pub load: [f64; 3],
    /// Sum of what the supports exert [N].
    pub reaction: [f64; 3],
    /// How the equations were solved.
    pub solve: SolveReport,
}

/// Everything as plain text.
pub fn deck_text(deck: &SolvedDeck) -> String {
    let quality = &deck.quality;
    let mut out = String::new();
    let [tetrahedra, wedges, hexahedra] = quality.elements;
    push_wrapped(
        &mut out,
        "",
        &format!(
            "Mesh: {} nodes, {tetrahedra} C3D10, {wedges} C3D15, {hexahedra} C3D20; smallest scaled Jacobian {:.2} (element {}), volume {} mm3, mass {} kg.",
            number::whole(quality.nodes as u128),
            quality.least_jacobian,
            quality.worst_element,
            number::short(1e9 * quality.volume, 6),
            number::short(quality.mass, 6),
        ),
    );
    for (index, step) in deck.steps.iter().enumerate() {
        out.push('\n');
        match step {
            SolvedStep::Static(step) => out.push_str(&static_table(index + 1, step).noted_text()),
            SolvedStep::Frequency(found) => out.push_str(&modes_table(index + 1, found).noted_text()),
        }
    }
    out
}

/// All steps as CSV, unrounded.
pub fn deck_csv(deck: &SolvedDeck) -> String {
    let table = |(index, step): (usize, &SolvedStep)| match step {
        SolvedStep::Static(step) => static_table(index + 1, step).csv(),
        SolvedStep::Frequency(found) => modes_table(index + 1, found).csv(),
    };
    deck.steps.iter().enumerate().map(table).collect::<Vec<_>>().join("\r\n")
}

fn static_table(number: usize, step: &StaticStep) -> Table {
    let row = |quantity: &str, value: f64, unit: &str, place: String| {
        vec![Cell::text(quantity), Cell::number(value, 7), Cell::text(unit), Cell::text(place)]
    };
    let mut rows = vec![
        row("energy", 1e3 * step.energy, "N mm", String::new()),
        row(
            "largest displacement",
            1e3 * step.largest_displacement.0,
            "mm",
            format!("node {}", step.largest_displacement.1),
        ),
        row(
            "largest von Mises stress",
            1e-6 * step.largest_stress.0,
            "MPa",
            format!("node {}, jump {:.1} %", step.largest_stress.1, 100.0 * step.largest_stress.2),
        ),
    ];
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        rows.push(row(&format!("load along {axis}"), step.load[k], "N", String::new()));
        rows.push(row(&format!("reaction along {axis}"), step.reaction[k], "N", String::new()));
    }
    Table {
        id: "deck-static",
        title: format!("Step {number}: static"),
        note: format!(
            "Residual {:.1e} in {} iterations. A stress at a sharp inner corner has no bound: it grows with every refinement, and its jump \
             stays large.",
            step.solve.residual, step.solve.iterations
        ),
        remark: String::new(),
        columns: vec![
            Column::words("quantity"),
            Column::numbers("value", ""),
            Column::words("unit"),
            Column::words("at"),
        ],
        rows,
    }
}

fn modes_table(number: usize, found: &ModeSolution) -> Table {
    let modes = &found.modes;
    Table::of_columns(
        "deck-modes",
        format!("Step {number}: natural modes"),
        match found.coarse_mass {
            true => "Mass integrated with the rule of the stiffness, as CalculiX does.",
            false => "Mass integrated exactly for elements with straight edges.",
        },
        vec![
            (
                Column::numbers("mode", ""),
                (1..=modes.len()).map(|k| Cell::Number { value: k as f64, decimals: 0 }).collect(),
            ),
            numbers("frequency", "Hz", modes.iter().map(|mode| mode.frequency), 8),
            words("residual", modes.iter().map(|mode| format!("{:.0e}", mode.residual))),
        ],
    )
}
