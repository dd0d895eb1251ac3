//! The engine file: from TOML text to an [`EngineFile`], a validated engine in SI units and what is asked of it.
//!
//! [`read`] takes the text of a file and gives the engine, or all its mistakes at once; [`render`] shows them.
//!
//! ```
//! let text = r#"
//! name = "Single"
//! speed = "3000 rpm"
//!
//! [layout]
//! type = "in-line"
//! cylinders = 1
//!
//! [crank]
//! stroke = "60 mm"
//!
//! [piston]
//! mass = "0,3 kg"
//!
//! [rod]
//! length = "100 mm"
//! mass = "0.3 kg"
//! "#;
//! let reading = lanchester_file::read(text);
//! assert!(reading.file.is_none());
//! let shown = lanchester_file::render(&reading.diagnostics, "single.toml", text, false);
//! assert!(shown.contains("single.toml:13:8"), "{shown}");
//! assert!(shown.contains("hint: write \"0.3 kg\""), "{shown}");
//!
//! let engine = lanchester_file::read(&text.replace("0,3", "0.3")).engine().expect("the file is mended");
//! assert_eq!(engine.throws[0].radius, 0.03);
//! ```
#![forbid(unsafe_code)]

mod codes;
mod document;
mod engine_file;
mod expanded;
mod firing;
mod layout;
mod problem;
mod read;
mod schema;
mod template;
mod typical;
mod values;
pub mod workshop;
mod write_back;

pub use codes::{diagnostic_codes, diagnostic_families};
pub use engine_file::EngineFile;
pub use expanded::expanded;
pub use lanchester_diagnostic::{Diagnostic, Related, Severity, render};
pub use read::simulation::event::event_from_words;
pub use read::simulation::start::{StartOfRun, start_from_words};
pub use read::{Reading, read};
pub use schema::{
    KeyInfo, KeyTable, SCHEMA_ID, json_schema, key_tables, reference_markdown, sheet_reference_markdown,
    sheet_schema,
};
pub use template::{Template, nearest_template, template, templates};
pub use typical::{CompleteError, Completed, EngineKind, LeftOut, TypicalSection, complete};
pub use values::{si_sheet, si_value, values_text};
pub use write_back::{
    Edit, EditError, FileEntry, WriteBackError, difference, edit, file_entries, write_back,
};
