//! Engines of the gallery and of texts.

use lanchester_file::{read, render, template};
use lanchester_model::Engine;

/// An engine of the gallery.
///
/// # Panics
/// Where there is none of that name.
#[track_caller]
pub fn gallery(name: &str) -> Engine {
    let template = template(name).unwrap_or_else(|| panic!("there is no engine {name} in the gallery"));
    engine(template.text)
}

/// The engine of a text.
///
/// # Panics
/// Where the text has mistakes: with all of them.
#[track_caller]
pub fn engine(text: &str) -> Engine {
    let reading = read(text);
    let shown = || render(&reading.diagnostics, "engine.toml", text, false);
    reading.engine().unwrap_or_else(|| panic!("{}", shown()))
}
