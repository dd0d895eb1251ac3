//! What `validation/layouts/derive.py` wrote about a template.

use num_complex::Complex64;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The independent values for one template, SI and radians, in the frame of the book.
#[derive(Debug, Clone, Deserialize)]
pub struct Evidence {
    pub template: String,
    /// What the textbooks say of the layout, in a line.
    pub layout: String,
    pub script: String,
    pub numpy: String,
    pub date: String,
    /// Speed of crankshaft 1.
    pub speed: f64,
    pub strokes: u32,
    pub period_revolutions: u32,
    /// Distance between neighbouring planes of the crank, and between the banks of a pair.
    pub spacing: f64,
    pub stagger: f64,
    pub uncancelled: Uncancelled,
    /// Coefficients of `e^{i n theta}`, n from -8 to 8.
    pub force: Vec<Coefficient>,
    pub couple: Vec<Coefficient>,
    /// `Re(value e^{i n theta})`, n from 0 to 8.
    pub roll_moment: Vec<Coefficient>,
    pub shaft_torque: Vec<Coefficient>,
    pub peaks: Peaks,
    pub cylinders: Vec<DeadCentres>,
    /// How far a firing of `firing` may lie from the dead centre that offsets, articulation or a lead shift.
    pub firing_slack_deg: f64,
    pub firing: Option<Vec<Firing>>,
}

/// What the loads would be if every part pulled the same way: the scale of rounding where all of it cancels.
#[derive(Debug, Clone, Deserialize)]
pub struct Uncancelled {
    pub force: f64,
    pub couple: f64,
    pub moment: f64,
}

#[derive(Debug, Clone, Deserialize)]
pub struct Coefficient {
    pub order: f64,
    value: [f64; 2],
}

impl Coefficient {
    pub fn value(&self) -> Complex64 {
        Complex64::new(self.value[0], self.value[1])
    }

    pub fn scale(&mut self, factor: f64) {
        self.value = self.value.map(|v| v * factor);
    }
}

#[derive(Debug, Clone, Deserialize)]
pub struct Peaks {
    pub force: f64,
    pub couple: f64,
    pub force_x: Range,
    pub force_y: Range,
    pub couple_x: Range,
    pub couple_y: Range,
    pub roll_moment: Range,
    pub shaft_torque: Range,
}

#[derive(Debug, Clone, Deserialize)]
pub struct Range {
    pub max: f64,
    pub min: f64,
}

#[derive(Debug, Clone, Deserialize)]
pub struct DeadCentres {
    pub cylinder: usize,
    pub top_dead_centre: f64,
    pub bottom_dead_centre: f64,
    pub stroke: f64,
    pub top: f64,
}

#[derive(Debug, Clone, Deserialize)]
pub struct Firing {
    pub cylinder: usize,
    /// After cylinder 1, by the layout's even or stated intervals.
    pub angle_deg: f64,
}

/// Where the evidence lies.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../validation/layouts")
}

/// The evidence for a template.
pub fn read(template: &str) -> Result<Evidence, String> {
    let path = folder().join(format!("{template}.json"));
    let text = std::fs::read_to_string(&path).map_err(|error| {
        format!("{template}: no independent evidence ({error}); a layout counts only with it")
    })?;
    serde_json::from_str(&text).map_err(|error| format!("{template}: {error}"))
}

/// Names of all templates for which there is evidence.
pub fn names() -> BTreeSet<String> {
    std::fs::read_dir(folder())
        .expect("validation/layouts exists")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|e| e == "json"))
        .map(|path| path.file_stem().expect("a file has a name").to_string_lossy().into_owned())
        .filter(|name| name != "textbook")
        .collect()
}
