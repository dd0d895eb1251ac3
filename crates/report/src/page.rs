//! The report: one HTML page that needs nothing but itself.

use crate::engine::frame_sketch::frame_sketch;
use crate::engine::front_view::front_view;
use crate::engine::side_view::side_view;
use crate::engine::tables::main_data;
use crate::kit::figure::{Figure, STYLE};
use crate::kit::number;
use crate::kit::section::{Part, Section, push_figures};
use crate::kit::table::Table;
use askama::Template;
use lanchester_model::{Engine, Rotation};

/// What made a report: printed at its foot.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Provenance {
    /// Program with its version: "lanchester 0.1.0".
    pub program: String,
    /// Name of the engine file.
    pub input: String,
    /// Hash of the engine file with the name of the hash: "fnv1a 93ab...".
    pub input_hash: String,
    /// Settings of the calculation: name and value.
    pub settings: Vec<(String, String)>,
}

/// What stands around the sections of a report.
#[derive(Debug, Clone, Copy)]
pub struct ReportHead<'a> {
    /// The engine.
    pub engine: &'a Engine,
    /// The speed at which its loads are told [rad/s].
    pub speed: f64,
    /// What made the report.
    pub provenance: &'a Provenance,
    /// Warnings of the engine file, as plain text.
    pub warnings: &'a [String],
    /// The numbers of the first page: before and after, or the peaks as the file stands.
    pub key_numbers: &'a Table,
}

#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    figure_style: &'static str,
    engine: &'a Engine,
    provenance: &'a Provenance,
    margins: Margins,
    warnings: &'a [String],
    findings: Vec<Finding<'a>>,
    key_numbers: String,
    speed: String,
    main_data: Vec<(&'static str, String)>,
    drawings: String,
    sections: &'a [Section],
    turning: &'static str,
    side: &'static str,
    frame: String,
}

/// What a section has found, for the first page.
struct Finding<'a> {
    id: &'static str,
    short: &'static str,
    lead: &'a str,
}

impl Finding<'_> {
    fn of(section: &Section) -> Option<Finding<'_>> {
        let lead = section.parts.iter().find_map(|part| match part {
            Part::Lead(words) => Some(words.as_str()),
            _ => None,
        })?;
        Some(Finding { id: section.id, short: section.short, lead })
    }
}

/// What stands in the margins of every printed sheet, as strings of CSS.
struct Margins {
    engine: String,
    program: String,
    /// Engine file and its hash.
    input: String,
}

impl Margins {
    fn of(engine: &Engine, provenance: &Provenance) -> Margins {
        let named = [&provenance.input, &provenance.input_hash];
        let named: Vec<&str> =
            named.into_iter().map(String::as_str).filter(|text| !text.is_empty()).collect();
        Margins {
            engine: css_string(&engine.name),
            program: css_string(&provenance.program),
            input: css_string(&named.join(" · ")),
        }
    }
}

/// A text as a string of CSS: what would end it, or the style sheet, is written as its number.
fn css_string(text: &str) -> String {
    let mut out = String::from('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' | '<' => out.push_str(&format!("\\{:x} ", u32::from(letter))),
            _ if letter.is_control() => out.push(' '),
            _ => out.push(letter),
        }
    }
    out.push('"');
    out
}

/// The report as one self-contained HTML page: head, the sections in their order, conventions and sources.
pub fn report(head: &ReportHead<'_>, sections: &[Section]) -> String {
    let ReportHead { engine, speed, provenance, warnings, key_numbers } = *head;
    let (turning, side) = match engine.rotation {
        Rotation::Clockwise => ("clockwise", "right"),
        Rotation::Reverse => ("anticlockwise", "left"),
    };
    let page = Page {
        figure_style: STYLE,
        engine,
        provenance,
        margins: Margins::of(engine, provenance),
        warnings,
        findings: sections.iter().filter_map(Finding::of).collect(),
        key_numbers: key_numbers.html(),
        speed: number::short(number::rpm(speed), 4),
        main_data: main_data(engine, speed),
        drawings: figures_html(&drawings(engine)),
        sections,
        turning,
        side,
        frame: figures_html(&[frame_sketch(engine.rotation)]),
    };
    page.render().expect("invariant: writing a page to a string cannot fail")
}

/// Every figure of a report, for files of their own.
pub fn figures(engine: &Engine, sections: &[Section]) -> Vec<Figure> {
    let of_sections = sections.iter().flat_map(Section::figures).cloned();
    drawings(engine).into_iter().chain(of_sections).chain([frame_sketch(engine.rotation)]).collect()
}

/// The engine in both views.
fn drawings(engine: &Engine) -> [Figure; 2] {
    [front_view(engine), side_view(engine)]
}

fn figures_html(figures: &[Figure]) -> String {
    let mut out = String::with_capacity(64 * 1024);
    push_figures(&mut out, figures);
    out
}

#[cfg(test)]
mod tests;
