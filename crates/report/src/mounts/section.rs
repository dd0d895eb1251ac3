//! The section of the report on the block and its mounts.

use crate::kit::section::Section;
use crate::mounts::figures::mount_figures;
use crate::mounts::tables::{mount_axes_words, mount_tables, mounted_body_words};
use crate::mounts::text::mount_remarks;
use lanchester_mechanism::MountStudy;
use lanchester_model::Engine;

/// The block on its mounts, as a section of a report.
pub fn mounts_section(engine: &Engine, study: &MountStudy) -> Section {
    Section::new("mounts", "Mounts", "On the mounts")
        .words(format!("The block as one rigid body on its mounts, shaken by {}.", study.excitation))
        .words(mounted_body_words(study))
        .words(mount_axes_words(study))
        .paragraphs(mount_remarks(study))
        .rows(mount_figures(engine, study))
        .tables(mount_tables(study))
}
