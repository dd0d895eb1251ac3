//! The report: one HTML page that needs nothing but itself.

use crate::bearings::internal_figure::internal_figures;
use crate::bearings::internal_tables::{internal_table, mains_table};
use crate::bearings::section::{BearingsInput, BearingsSection};
use crate::engine::tables as engine_tables;
use crate::kit::figure::{Figure, STYLE};
use crate::kit::number;
use crate::kit::svg::escape;
use crate::kit::table::{Table, push_rich};
use crate::loads::findings::findings_table;
use crate::loads::gallery::Gallery;
use crate::loads::over_angle;
use crate::loads::speed_table::speed_table;
use crate::loads::tables as load_tables;
use crate::mounts::figures::mount_figures;
use crate::mounts::tables::{mount_axes_words, mount_tables, mounted_body_words};
use crate::mounts::text::mount_remarks;
use crate::optimum::section::{OptimumInput, OptimumSection};
use crate::parts::section::{CrankshaftInput, CrankshaftSection};
use crate::simulated::run::SimulationResult;
use crate::simulated::section::SimulationSection;
use crate::torque::section::{TorqueInput, TorqueSection};
use askama::Template;
use lanchester_mechanism::{InternalMoments, Loads, MountStudy};
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

/// Everything that a report shows.
#[derive(Debug, Clone, Copy)]
pub struct ReportInput<'a> {
    /// The engine.
    pub engine: &'a Engine,
    /// Its loads.
    pub loads: &'a Loads,
    /// Shear and bending of its crankshafts, the case that is drawn first; may be empty.
    pub internal: &'a [InternalMoments],
    /// What balancing found; `None` where the file does not ask.
    pub optimum: Option<OptimumInput<'a>>,
    /// The crankshaft as a real part; `None` where the file says nothing of it.
    pub crankshaft: Option<CrankshaftInput<'a>>,
    /// Torque with its gas; `None` where the file does not give it.
    pub torque: Option<TorqueInput<'a>>,
    /// Loads of the bearings; `None` where the file has neither gas nor sizes of bearings.
    pub bearings: Option<BearingsInput<'a>>,
    /// The block on its mounts; `None` where the file does not give it.
    pub mounts: Option<&'a MountStudy>,
    /// The run in time that the file describes; `None` where it describes none.
    pub simulation: Option<&'a SimulationResult>,
    /// What made the report.
    pub provenance: &'a Provenance,
    /// Warnings of the engine file, as plain text.
    pub warnings: &'a [String],
}

#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    figure_style: &'static str,
    engine: &'a Engine,
    loads: &'a Loads,
    provenance: &'a Provenance,
    warnings: &'a [String],
    speed: String,
    main_data: Vec<(&'static str, String)>,
    summary: String,
    roll: String,
    findings: String,
    reference: String,
    turning: &'static str,
    side: &'static str,
    vanishing: String,
    drawings: String,
    spectra: String,
    load_tables: String,
    balance: String,
    curves: String,
    hodographs: String,
    stars: String,
    stories: String,
    optimum: Option<OptimumHtml>,
    crankshaft: Option<SectionHtml>,
    torque: Option<SectionHtml>,
    bearings: Option<SectionHtml>,
    mounts: Option<MountsHtml>,
    simulation: Option<SectionHtml>,
    bending_curves: String,
    bending_tables: String,
    motion_curves: String,
    motion_tables: String,
    engine_tables: String,
    frame: String,
}

/// The section on the optimum.
struct OptimumHtml {
    headline: String,
    method: String,
    tables: String,
    figures: String,
    left: String,
}

/// A section of words, figures and tables.
struct SectionHtml {
    paragraphs: Vec<String>,
    tables: String,
    figures: String,
    /// Figures that need a row of their own.
    broad_figures: String,
}

impl SectionHtml {
    /// Figures of up to `beside` panels stand beside one another, the others below, each in a row of its own.
    fn of(paragraphs: &[String], figures: &[Figure], tables: &[Table], beside: usize) -> SectionHtml {
        let (broad, slim): (Vec<Figure>, Vec<Figure>) =
            figures.iter().cloned().partition(|figure| figure.panels.len() > beside);
        SectionHtml {
            paragraphs: paragraphs.iter().map(|text| unbroken(text)).collect(),
            tables: tables_html(tables),
            figures: figures_html(&slim),
            broad_figures: figures_html(&broad),
        }
    }
}

/// The section on the block and its mounts.
struct MountsHtml {
    excitation: String,
    paragraphs: Vec<String>,
    tables: String,
    figures: String,
}

impl MountsHtml {
    fn of(engine: &Engine, study: &MountStudy) -> MountsHtml {
        let mut paragraphs = vec![mounted_body_words(study), mount_axes_words(study)];
        paragraphs.extend(mount_remarks(study));
        MountsHtml {
            excitation: study.excitation.clone(),
            paragraphs: paragraphs.iter().map(|text| unbroken(text)).collect(),
            tables: tables_html(&mount_tables(study)),
            figures: figures_html(&mount_figures(engine, study)),
        }
    }
}

/// The report as one self-contained HTML page.
pub fn report(input: &ReportInput<'_>) -> String {
    let ReportInput { engine, loads, internal, mounts, provenance, warnings, .. } = *input;
    let crankshaft = input.crankshaft.map(|input| CrankshaftSection::of(engine, &input));
    let torque = input.torque.map(|input| TorqueSection::of(&input));
    let bearings = input.bearings.and_then(|input| BearingsSection::of(&input));
    let optimum = input.optimum.map(|input| OptimumSection::of(engine, &input));
    let gallery = Gallery::of(engine, loads);
    let mut motion_tables = vec![load_tables::motion_table(loads)];
    motion_tables.extend(load_tables::articulation_table(loads));
    motion_tables.extend(load_tables::rod_inertia_table(loads));
    let mut engine_tables = vec![engine_tables::masses_table(engine), engine_tables::throws_table(engine)];
    engine_tables.extend(engine_tables::weights_table(engine));
    let mut load_tables = vec![
        load_tables::peaks_table(loads),
        load_tables::parts_table(loads),
        load_tables::force_orders_table(loads),
        load_tables::couple_orders_table(loads),
        load_tables::roll_orders_table(loads),
        load_tables::cylinders_table(loads),
    ];
    load_tables.extend(speed_table(engine, loads));
    let (turning, side) = match engine.rotation {
        Rotation::Clockwise => ("clockwise", "right"),
        Rotation::Reverse => ("anticlockwise", "left"),
    };
    let page = Page {
        figure_style: STYLE,
        engine,
        loads,
        provenance,
        warnings,
        speed: number::short(number::rpm(loads.speed), 4),
        main_data: engine_tables::main_data(engine, loads.speed),
        summary: unbroken(&loads.diagnosis.summary),
        roll: unbroken(&loads.diagnosis.roll),
        findings: findings_table(loads).html(),
        reference: reference(loads),
        turning,
        side,
        vanishing: vanishing(loads),
        drawings: figures_html(&gallery.drawings),
        spectra: figures_html(&gallery.spectra),
        load_tables: tables_html(&load_tables),
        balance: figures_html(&gallery.balance),
        curves: figures_html(&gallery.curves),
        hodographs: figures_html(&gallery.hodographs),
        stars: figures_html(&gallery.stars),
        stories: figures_html(&gallery.stories),
        optimum: optimum.map(|found| OptimumHtml {
            headline: unbroken(&found.headline),
            method: found.method,
            tables: tables_html(&found.tables),
            figures: figures_html(&found.figures),
            left: unbroken(&found.left),
        }),
        crankshaft: crankshaft.map(|own| SectionHtml::of(&own.paragraphs, &own.figures, &own.tables, 0)),
        torque: torque.map(|own| SectionHtml::of(&own.paragraphs, &own.figures, &own.tables, 2)),
        bearings: bearings.map(|own| SectionHtml::of(&own.paragraphs, &own.figures, &own.tables, 0)),
        mounts: mounts.map(|study| MountsHtml::of(engine, study)),
        simulation: input
            .simulation
            .map(SimulationSection::of)
            .map(|own| SectionHtml::of(&own.paragraphs, &own.figures, &own.tables, 1)),
        bending_curves: figures_html(&internal_figures(engine, internal)),
        bending_tables: bending_tables(engine, internal),
        motion_curves: figures_html(gallery.motion.as_slice()),
        motion_tables: tables_html(&motion_tables),
        engine_tables: tables_html(&engine_tables),
        frame: figures_html(std::slice::from_ref(&gallery.frame)),
    };
    page.render().expect("invariant: writing a page to a string cannot fail")
}

/// Every figure of the report, for files of their own.
pub fn figures(engine: &Engine, loads: &Loads) -> Vec<Figure> {
    Gallery::of(engine, loads).into_figures()
}

/// Tables on bending; empty where nothing bends.
fn bending_tables(engine: &Engine, internal: &[InternalMoments]) -> String {
    match internal.first() {
        Some(case) if !case.crankshafts.is_empty() => {
            tables_html(&[internal_table(engine, internal), mains_table(engine, internal)])
        }
        _ => String::new(),
    }
}

/// The text with its units kept beside their numbers.
fn unbroken(text: &str) -> String {
    [" kN", " N", " m ", " rpm"]
        .iter()
        .fold(text.to_owned(), |text, unit| text.replace(unit, &unit.replacen(' ', "\u{a0}", 1)))
}

fn reference(loads: &Loads) -> String {
    if loads.reference.iter().all(|v| v.abs() < 1e-12) {
        return "the origin".to_owned();
    }
    let [x, y, z] = loads.reference.map(|v| number::short(1e3 * v, 4));
    format!("the point x = {x}, y = {y}, z = {z} mm")
}

/// A sentence on the components that have no plot.
fn vanishing(loads: &Loads) -> String {
    let names = over_angle::vanishing(loads);
    let Some((last, others)) = names.split_last() else { return String::new() };
    let list = if others.is_empty() {
        format!("{last} vanishes")
    } else {
        format!("{} and {last} vanish", others.join(", "))
    };
    let mut out = String::new();
    push_rich(&mut out, &format!("{list} at every crank angle, part by part, and need no plot."));
    out
}

fn tables_html(tables: &[Table]) -> String {
    tables.iter().map(Table::html).collect()
}

fn figures_html(figures: &[Figure]) -> String {
    let mut out = String::with_capacity(64 * 1024);
    for figure in figures {
        let class = match (figure.panels.len(), figure.columns) {
            (0..=2, _) => "plot",
            (_, 2) => "plot many two",
            (_, 3) => "plot many three",
            _ => "plot many",
        };
        out.push_str("<figure class=\"");
        out.push_str(class);
        out.push_str("\" id=\"");
        out.push_str(&escape(&figure.id));
        out.push_str("\">\n<h3>");
        push_rich(&mut out, &figure.title);
        out.push_str("</h3>\n<div class=\"panels\">\n");
        for panel in &figure.panels {
            panel.write_inline(&mut out);
        }
        out.push_str("</div>\n<figcaption>");
        push_rich(&mut out, &figure.caption);
        out.push_str("</figcaption>\n</figure>\n");
    }
    out
}

#[cfg(test)]
mod tests;
