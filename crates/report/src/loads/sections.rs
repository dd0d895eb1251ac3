//! The sections of the report on shaking forces and moments.

use crate::engine::crank_view::crank_view;
use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::section::Section;
use crate::loads::findings::findings_table;
use crate::loads::hodograph::{couple_hodograph, force_hodograph};
use crate::loads::motion_plot::motion_plot;
use crate::loads::over_angle::{over_angle, vanishing};
use crate::loads::share_plot::share_plots;
use crate::loads::spectrum::{couple_spectrum, force_spectrum, roll_spectrum};
use crate::loads::speed_table::speed_table;
use crate::loads::star::{couple_stars, force_stars, told_orders};
use crate::loads::story::{Told, story};
use crate::loads::tables::{
    articulation_table, couple_orders_table, cylinders_table, force_orders_table, motion_table, parts_table,
    peaks_table, rod_inertia_table, roll_orders_table,
};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;

/// Diagnosis, numbers, curves, devices, hodographs, stars and steps, each as a section of a report.
pub fn loads_sections(engine: &Engine, loads: &Loads) -> Vec<Section> {
    let mut sections = vec![diagnosis(loads), numbers(engine, loads), over_the_cycle(loads)];
    sections.extend(devices(engine, loads));
    sections.extend([paths(engine, loads), stars(engine, loads), steps(engine, loads)]);
    sections
}

fn diagnosis(loads: &Loads) -> Section {
    let mut spectra = vec![force_spectrum(loads), couple_spectrum(loads)];
    if loads.total.peaks.roll_moment.max_abs() > Magnitude::of(loads).roll_noise() {
        spectra.push(roll_spectrum(loads));
    }
    let findings = (!loads.diagnosis.findings.is_empty()).then(|| findings_table(loads));
    Section::new("diagnosis", "Diagnosis", "What shakes this engine")
        .lead(&loads.diagnosis.summary)
        .lead(&loads.diagnosis.roll)
        .tables(findings)
        .side_by_side(spectra)
}

fn numbers(engine: &Engine, loads: &Loads) -> Section {
    let mut tables = vec![
        peaks_table(loads),
        parts_table(loads),
        force_orders_table(loads),
        couple_orders_table(loads),
        roll_orders_table(loads),
        cylinders_table(loads),
    ];
    tables.extend(speed_table(engine, loads));
    let words = format!(
        "All loads are what the moving parts exert on the block; couples and roll moment are about {}. Motion: {}.",
        reference(loads),
        loads.kinematics
    );
    Section::new("numbers", "Numbers", "The loads in numbers").words(words).tables(tables)
}

fn over_the_cycle(loads: &Loads) -> Section {
    let names = vanishing(loads);
    let words = match names.split_last() {
        None => String::new(),
        Some((last, [])) => format!("{last} vanishes at every crank angle, part by part, and needs no plot."),
        Some((last, others)) => {
            let others = others.join(", ");
            format!("{others} and {last} vanish at every crank angle, part by part, and need no plot.")
        }
    };
    Section::new("cycle", "Over the cycle", "Over the crank angle")
        .symbols(words)
        .side_by_side(over_angle(loads))
}

/// The crank with its weights, and what each throw and device adds: none without devices.
fn devices(engine: &Engine, loads: &Loads) -> Option<Section> {
    let figures = crank_view(engine).into_iter().chain(share_plots(engine, loads));
    let section = Section::new("balance", "Devices", "Throws against devices").rows(figures);
    (!section.is_empty()).then_some(section)
}

fn paths(engine: &Engine, loads: &Loads) -> Section {
    let figures = [force_hodograph(loads, engine.rotation), couple_hodograph(loads, engine.rotation)];
    Section::new("paths", "Hodographs", "Hodographs").side_by_side(figures)
}

fn stars(engine: &Engine, loads: &Loads) -> Section {
    let mut figures = vec![force_stars(loads, engine.rotation), couple_stars(loads, engine.rotation)];
    figures.retain(|figure| !figure.panels.is_empty());
    let words = match figures.is_empty() {
        true => "No cylinder has any force: there is nothing to draw.",
        false => "",
    };
    Section::new("stars", "Stars", "Stars").words(words).rows(figures)
}

fn steps(engine: &Engine, loads: &Loads) -> Section {
    let told = told_orders(loads).into_iter().take(2).map(Told::Order).chain([Told::Whole]);
    let figures = told.filter_map(|told| story(engine, loads, told));
    Section::new("steps", "Step by step", "Step by step").rows(figures)
}

/// How the pistons move, as a section of a report.
pub fn motion_section(loads: &Loads) -> Section {
    let mut tables = vec![motion_table(loads)];
    tables.extend(articulation_table(loads));
    tables.extend(rod_inertia_table(loads));
    Section::new("motion-of-cylinders", "Motion", "Motion of the cylinders")
        .rows(motion_plot(loads))
        .tables(tables)
}

fn reference(loads: &Loads) -> String {
    if loads.reference.iter().all(|v| v.abs() < 1e-12) {
        return "the origin".to_owned();
    }
    let [x, y, z] = loads.reference.map(|v| number::short(1e3 * v, 4));
    format!("the point x = {x}, y = {y}, z = {z} mm")
}
