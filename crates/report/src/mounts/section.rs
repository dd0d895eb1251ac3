//! The section of the report on the block and its mounts.

use crate::kit::number;
use crate::kit::section::Section;
use crate::mounts::figures::mount_figures;
use crate::mounts::tables::{mount_axes_words, mount_tables, mounted_body_words};
use crate::mounts::text::mount_remarks;
use lanchester_mechanism::MountStudy;
use lanchester_model::Engine;
use std::f64::consts::TAU;

/// The block on its mounts, as a section of a report.
pub fn mounts_section(engine: &Engine, study: &MountStudy) -> Section {
    Section::new("mounts", "Mounts", "On the mounts")
        .lead(lead(study))
        .words(format!("The block as one rigid body on its mounts, shaken by {}.", study.excitation))
        .words(mounted_body_words(study))
        .words(mount_axes_words(study))
        .paragraphs(mount_remarks(study))
        .rows(mount_figures(engine, study))
        .tables(mount_tables(study))
}

/// The largest force at a mount over all speeds, and where the modes of the block lie.
fn lead(study: &MountStudy) -> String {
    let response = &study.response;
    let peaks = response
        .speeds
        .iter()
        .flat_map(|at| at.peaks.iter().enumerate().map(move |(mount, peak)| (peak.value, mount, at.speed)));
    let largest = peaks.max_by(|a, b| a.0.total_cmp(&b.0));
    let force = largest.map_or_else(String::new, |(peak, mount, speed)| {
        format!(
            "The largest force at a mount is {} N, at {} at {} rpm.",
            number::short(peak, 4),
            response.mounts[mount],
            number::trimmed(number::rpm(speed), 4)
        )
    });
    let modes = study.modes.modes.iter().map(|mode| mode.angular_frequency / TAU);
    let (low, high) = modes.fold((f64::INFINITY, 0.0f64), |(low, high), f| (low.min(f), high.max(f)));
    match low.is_finite() {
        true => format!(
            "{force} The rigid-body modes lie from {} to {} Hz.",
            number::short(low, 3),
            number::short(high, 3)
        ),
        false => force,
    }
}
