//! The workshop sheet: what is measured on a real rotor, crank or engine, and what may be done to it.
//!
//! A sheet is a TOML file of its own, read like an engine file: every quantity with its unit, all mistakes at once.
//! [`read_sheet`] gives the [`Sheet`]; each `workshop` command uses the tables that it needs.

mod bobweight;
mod display;
mod keys;
mod rotor;
mod run;
mod slug;

pub(crate) use keys::SHEET;

use crate::document::{self, Section, Spot};
use crate::read::Reader;
use lanchester_diagnostic::{Diagnostic, Mistake, Mistakes};
use lanchester_task::workshop::Sheet;
use lanchester_units::nearest;

/// What reading a workshop sheet gives.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetReading {
    /// The sheet; `None` if and only if a diagnostic is an error.
    pub sheet: Option<Sheet>,
    /// All mistakes and doubts, sorted by their place in the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a workshop sheet: TOML text, as the book's page on the workshop describes it.
///
/// All mistakes are found at once, every key has an effect or a diagnostic, and no text makes this panic.
pub fn read_sheet(text: &str) -> SheetReading {
    let mut mistakes = Mistakes::default();
    let document = document::parse(text, &SHEET, &mut mistakes);
    let mut reader = Reader { root: &document.root, whole: document.whole, mistakes: &mut mistakes };
    let sheet = reader.sheet();
    if !reader.mistakes.any_error() {
        reader.report_unused();
    }
    debug_assert!(sheet.is_some() || mistakes.any_error(), "a file without a sheet has an error");
    let sheet = sheet.filter(|_| !mistakes.any_error());
    SheetReading { sheet, diagnostics: mistakes.into_diagnostics(text) }
}

impl<'a> Reader<'a> {
    fn sheet(&mut self) -> Option<Sheet> {
        let root = self.root;
        // A sheet of version 1 is the only one there is: the kind of the key has checked it.
        let version = root.whole("version");
        let name = self.required(root, "name", root.text("name"));
        let note = root.text("note");
        let rotor = self.rotor();
        let planes = self.planes();
        let sensors = self.sensors();
        let runs = self.runs(planes.as_deref(), sensors.as_deref());
        let displays = self.displays(planes.as_deref());
        let engine = root.text("engine");
        let bobweight = self.bobweight_sheet();
        let externals = self.externals();
        let slug = self.slug_room();
        if version.is_bad() || note.is_bad() || engine.is_bad() {
            return None;
        }
        Some(Sheet {
            name: name?,
            note: note.given(),
            rotor: rotor?,
            planes: planes?,
            sensors: sensors?,
            runs: runs?,
            displays: displays?,
            engine: engine.given(),
            bobweight: bobweight?,
            externals: externals?,
            slug: slug?,
        })
    }

    /// The place in `names` of a name that the file uses; a mistake if there is none.
    fn named(&mut self, given: &Spot<String>, names: &[String], what: &str) -> Option<usize> {
        let found = names.iter().position(|name| *name == given.value);
        // Tables may hide behind a mistake of syntax.
        if found.is_none() && self.whole {
            let near = nearest(&given.value, names.iter().map(String::as_str));
            let hint = match (near, names) {
                (Some(near), _) => format!("did you mean \"{near}\"?"),
                (None, []) => format!("add a [[{what}]] of this name"),
                (None, names) => format!("there is {}", names.join(", ")),
            };
            let shown: String = given.value.chars().take(60).collect();
            let message = format!("{what} \"{shown}\" does not exist");
            self.mistakes.push(Mistake::error("E0205", given.span.clone(), message).hint(hint));
        }
        found
    }

    /// A name that another table of its kind has already.
    fn check_names(&mut self, sections: &[Section], names: &[Option<String>], what: &str) {
        let named = sections.iter().zip(names);
        let names: Vec<_> =
            named.filter_map(|(section, name)| Some((name.clone()?, section.value_span("name")))).collect();
        self.refuse_same_names("E1101", what, &names);
    }
}
