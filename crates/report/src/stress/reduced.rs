//! The reduced model of a crankshaft: its tables and checks.

use super::body::CrankSheet;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_flex::reduction::ReducedModel;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const REDUCED_VERSION: u32 = 1;

/// Free frequencies listed.
const LISTED: usize = 12;

/// A reduced model with its checks.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ReducedCrank {
    /// [`REDUCED_VERSION`].
    pub version: u32,
    /// What was meshed.
    pub sheet: CrankSheet,
    /// The model.
    pub model: ReducedModel,
    /// Largest force that a constraint mode leaves on the free nodes, over its largest force.
    pub residual: f64,
    /// Mass of a rigid translation of the model, over that of the mesh, less one.
    pub mass_error: f64,
    /// Free natural frequencies of the model beyond the rigid motions, and with a third of its fixed-interface modes left out [Hz].
    pub frequencies: Vec<[f64; 2]>,
    /// The first free natural frequencies of the mesh itself [Hz]: bearing surfaces that stay rigid make the model stiffer than that.
    pub of_mesh: Vec<f64>,
}

impl ReducedCrank {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.points_table(), self.frequencies_table()]
    }

    /// Reference points.
    pub(crate) fn points_table(&self) -> Table {
        let points = &self.model.points;
        let along = |k: usize| points.iter().map(move |(_, at)| 1e3 * at[k]);
        Table::of_columns(
            "reduced-points",
            "Reference points",
            "Each moves a bearing surface, or the flywheel's end face, as a rigid body: six coordinates.",
            vec![
                words("surface", points.iter().map(|(name, _)| name.clone())),
                numbers("x", "mm", along(0), 5),
                numbers("y", "mm", along(1), 5),
                numbers("z", "mm", along(2), 5),
            ],
        )
    }

    /// Free frequencies and what the truncation does to them.
    pub(crate) fn frequencies_table(&self) -> Table {
        let rows = &self.frequencies[..self.frequencies.len().min(LISTED)];
        let of_mesh = |cell: &dyn Fn(f64, f64) -> Cell| -> Vec<Cell> {
            let all = rows.iter().enumerate();
            all.map(|(k, [own, _])| self.of_mesh.get(k).map_or(Cell::Empty, |found| cell(*found, *own)))
                .collect()
        };
        let change = rows.iter().map(|[all, fewer]| Cell::text(format!("{:.1e}", fewer / all - 1.0)));
        Table::of_columns(
            "reduced-frequencies",
            "Free natural frequencies of the reduced model",
            "Change: relative, where a third of the fixed-interface modes is left out; the error of the truncation is smaller than that. Of the mesh: without supports, its \
             bearing surfaces free to bend; the model holds each of them rigid, and is stiffer by what stands beside it.",
            vec![
                (
                    Column::numbers("mode", ""),
                    (1..=rows.len()).map(|k| Cell::Number { value: k as f64, decimals: 0 }).collect(),
                ),
                numbers("frequency", "Hz", rows.iter().map(|[all, _]| *all), 6),
                (Column::words("change"), change.collect()),
                (Column::numbers("of the mesh", "Hz"), of_mesh(&|found, _| Cell::number(found, 6))),
                (
                    Column::numbers("stiffer", "%"),
                    of_mesh(&|found, own| Cell::Number { value: 100.0 * (own / found - 1.0), decimals: 1 }),
                ),
            ],
        )
    }

    pub(crate) fn words(&self) -> Vec<String> {
        let frequencies = &self.model.frequencies;
        let highest = frequencies
            .last()
            .map_or(String::new(), |last| format!(", up to {} Hz", number::short(*last, 5)));
        let mut words = vec![format!(
            "{} coordinates: {} of {} reference points, {} modes with all of these fixed{highest}.",
            self.model.size(),
            6 * self.model.points.len(),
            self.model.points.len(),
            frequencies.len(),
        )];
        if let (Some(own), Some(found)) = (self.frequencies.first(), self.of_mesh.first()) {
            words.push(format!(
                "Its lowest free frequency is {} Hz, that of the mesh {} Hz: rigid bearing surfaces stiffen it by {:.1} %.",
                number::short(own[0], 5),
                number::short(*found, 5),
                100.0 * (own[0] / found - 1.0)
            ));
        }
        words.extend(self.sheet.words());
        words.push(format!(
            "Checks: constraint modes leave {:.1e} of their force on free nodes; mass of a rigid translation right to {:.1e}.",
            self.residual,
            self.mass_error.abs()
        ));
        words
    }
}

/// Everything as plain text.
pub fn reduced_text(found: &ReducedCrank) -> String {
    let mut out = format!(
        "{}, reduced model of crankshaft {} (Craig and Bampton, rigid bearing surfaces)\n\n",
        found.sheet.engine, found.sheet.crankshaft
    );
    for words in found.words() {
        push_wrapped(&mut out, "", &words);
    }
    for table in found.tables() {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out
}

/// The free frequencies as CSV, unrounded.
pub fn reduced_csv(found: &ReducedCrank) -> String {
    found.frequencies_table().csv()
}
