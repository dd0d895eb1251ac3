//! Natural modes of a crankshaft: their table.

use super::body::CrankSheet;
use super::convergence::Convergence;
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use crate::kit::table::{Cell, Column, Table, numbers, words};
use lanchester_flex::modes::{ModeCount, ModeKind, ModeSolution};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const MODES_VERSION: u32 = 1;

/// Natural modes of a crankshaft at rest.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankModes {
    /// [`MODES_VERSION`].
    pub version: u32,
    /// What was meshed.
    pub sheet: CrankSheet,
    /// What holds it, in words.
    pub support: String,
    /// The modes; their shapes are not serialised.
    pub modes: ModeSolution,
    /// With three meshes: what the frequencies tend to; the modes are those of the finest.
    pub convergence: Option<Convergence>,
}

pub(crate) fn kind_words(kind: ModeKind) -> &'static str {
    match kind {
        ModeKind::Rigid => "rigid body",
        ModeKind::BendingX => "bending in the plane of throw 1",
        ModeKind::BendingY => "bending across the plane of throw 1",
        ModeKind::Torsion => "torsion",
        ModeKind::Axial => "axial",
        ModeKind::Mixed => "mixed",
    }
}

impl CrankModes {
    /// Its table.
    pub(crate) fn table(&self) -> Table {
        let modes = &self.modes.modes;
        let share = |k: usize| {
            let cells = modes.iter().map(|mode| Cell::Number { value: 100.0 * mode.shares[k], decimals: 1 });
            cells.collect::<Vec<Cell>>()
        };
        let residual = modes.iter().map(|mode| Cell::text(format!("{:.0e}", mode.residual)));
        Table::of_columns(
            "stress-modes",
            "Natural modes",
            "Shares of the kinetic energy: slices across the axis that move along throw 1 and across it or tilt so, turn about the axis, or move \
             along it; the rest deforms slices. Residual: |K x - lambda M x| over |K x|.",
            vec![
                (
                    Column::numbers("mode", ""),
                    (1..=modes.len()).map(|k| Cell::Number { value: k as f64, decimals: 0 }).collect(),
                ),
                numbers("frequency", "Hz", modes.iter().map(|mode| mode.frequency), 6),
                words("kind", modes.iter().map(|mode| kind_words(mode.kind).to_owned())),
                (Column::numbers("in plane", "%"), share(0)),
                (Column::numbers("across", "%"), share(1)),
                (Column::numbers("torsion", "%"), share(2)),
                (Column::numbers("axial", "%"), share(3)),
                (Column::words("residual"), residual.collect()),
            ],
        )
    }

    /// The chapter of a report: pictures first.
    pub fn section(&self) -> Section {
        let first = self.modes.modes.first();
        let lead = first.map_or(String::new(), |mode| {
            format!(
                "Lowest natural frequency {} Hz: {}.",
                number::short(mode.frequency, 4),
                kind_words(mode.kind)
            )
        });
        Section::new("crankshaft-modes", "Modes", "Natural modes of the crankshaft")
            .lead(lead)
            .rows(self.figures())
            .paragraphs(self.words())
            .tables(self.convergence.as_ref().map(Convergence::table))
            .tables([self.table()])
    }

    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = vec![format!("Support: {}. At rest: no gyroscopic effect.", self.support)];
        words.extend(self.sheet.words());
        words.push(format!(
            "Solution: {} unknowns, factor of {} entries in double precision, {} vectors of block Lanczos.",
            number::whole(self.modes.unknowns as u128),
            number::whole(self.modes.factor_entries as u128),
            self.modes.basis,
        ));
        words.extend(self.modes.count.as_ref().map(count_words));
        words
    }
}

/// Whether a mode is missing.
fn count_words(count: &ModeCount) -> String {
    let below = number::short(count.below, 5);
    let found = match count.found {
        1 => "one is found".to_owned(),
        found => format!("{found} are found"),
    };
    match (count.counted, count.missing()) {
        (Some(counted), Some(0)) => format!(
            "Counted by the signs of a second factor: {counted} modes below {below} Hz, rigid motions included. None is missing."
        ),
        (Some(counted), _) => format!(
            "Counted by the signs of a second factor: {counted} modes below {below} Hz, rigid motions included, of which {found}: the others are missing. Ask for more modes."
        ),
        _ => format!(
            "Modes below {below} Hz cannot be counted: rounding leaves signs of the second factor in doubt."
        ),
    }
}

/// Everything as plain text.
pub fn modes_text(found: &CrankModes) -> String {
    let mut out =
        format!("{}, natural modes of crankshaft {}\n\n", found.sheet.engine, found.sheet.crankshaft);
    for words in found.words() {
        push_wrapped(&mut out, "", &words);
    }
    for table in found.convergence.as_ref().map(Convergence::table).into_iter().chain([found.table()]) {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out
}

/// The table as CSV, unrounded.
pub fn modes_csv(found: &CrankModes) -> String {
    found.table().csv()
}
