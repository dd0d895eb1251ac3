//! The engine file: from TOML text to a validated, immutable [`Engine`] in SI units.
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
//! let reading = lanchester_model::read(text);
//! assert!(reading.engine.is_none());
//! let shown = lanchester_model::render(&reading.diagnostics, "single.toml", text, false);
//! assert!(shown.contains("single.toml:13:8"), "{shown}");
//! assert!(shown.contains("hint: write \"0.3 kg\""), "{shown}");
//!
//! let engine = lanchester_model::read(&text.replace("0,3", "0.3")).engine.expect("the file is mended");
//! assert_eq!(engine.throws[0].radius, 0.03);
//! ```
#![forbid(unsafe_code)]

mod angle;
mod bearings;
mod block;
mod codes;
mod crank_body;
mod criterion;
mod default_task;
mod diagnostic;
mod document;
mod drilling;
mod engine;
mod expanded;
mod firing;
mod flywheel;
mod free_shaft;
mod friction;
mod gas;
mod give_up;
mod layout;
mod main_load;
mod mains;
mod mount;
mod nearest;
pub mod option;
mod part_weight;
mod plain_web;
mod quantity;
mod ratio;
mod read;
mod room;
mod schema;
mod shaft_part;
mod shape_task;
mod spacing;
mod task;
mod task_options;
mod template;
mod tolerance;
pub mod workshop;
mod write_back;

pub use bearings::{Bearings, PlainBearing};
pub use block::*;
pub use codes::{diagnostic_codes, diagnostic_families};
pub use crank_body::*;
pub use criterion::{criterion, criterion_name, criterion_unit};
pub use default_task::{CrankWeightPlaces, crank_weights, default_task};
pub use diagnostic::{Diagnostic, Related, Severity, render};
pub use drilling::{CatalogueHole, DrillBit, DrillCatalogue};
pub use engine::*;
pub use expanded::expanded;
pub use flywheel::Flywheel;
pub use friction::Friction;
pub use gas::*;
pub use mount::*;
pub use part_weight::{PartFault, PartWeight};
pub use plain_web::{PlainWeb, SharedWeb};
pub use ratio::{Ratio, greatest_common_divisor};
pub use read::{Reading, read};
pub use room::{RoomFault, RoomFaultKind, TaskDevice, room_faults};
pub use schema::{
    KeyInfo, KeyTable, json_schema, key_tables, reference_markdown, sheet_reference_markdown, sheet_schema,
};
pub use shaft_part::{ShaftWeightAim, ShaftWeightPart, ShaftWeightTask};
pub use shape_task::*;
pub use task::*;
pub use task_options::{ChangedTask, TaskOptions};
pub use template::{Template, nearest_template, template, templates};
pub use tolerance::{Distribution, Extent, Tolerance, Varied};
pub use write_back::{
    Edit, EditError, FileEntry, WriteBackError, difference, edit, file_entries, write_back,
};
