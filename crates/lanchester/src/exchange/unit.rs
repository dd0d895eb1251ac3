//! Functional mock-up units: what those of all models share.

use crate::engine_report::fnv1a;
use crate::pressure::measured::TraceFile;
use lanchester_exchange::{
    FmiVersion, FmuDescription, FmuVariable, binaries_folder, fmu_archive, model_description,
};
use std::io;

/// Name of the engine file among the resources of a unit.
pub const UNIT_ENGINE: &str = "engine.toml";

/// What a unit computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitKind {
    /// The loads of the closed form at a speed that is given: [`crate::LoadsModel`].
    Loads,
    /// The crank train at free speed: [`crate::CrankTrainModel`].
    CrankTrain,
}

impl UnitKind {
    /// All of them.
    pub const ALL: [UnitKind; 2] = [UnitKind::Loads, UnitKind::CrankTrain];

    /// Name of the binary within the unit, without its ending.
    pub fn identifier(self) -> &'static str {
        match self {
            UnitKind::Loads => "lanchester_loads",
            UnitKind::CrankTrain => "lanchester_crank_train",
        }
    }
}

/// Name of the file of pressures number `place` among the resources of a unit, in the order of [`crate::trace_names`].
pub fn unit_trace(place: usize) -> String {
    format!("trace-{}.csv", place + 1)
}

/// What tells which model a unit has, and whether a binary and a description belong to an engine file: the program's version and a hash of the text.
pub fn unit_token(kind: UnitKind, engine_file: &str) -> String {
    let kind = match kind {
        UnitKind::Loads => "loads",
        UnitKind::CrankTrain => "crank-train",
    };
    format!("lanchester-{kind}-{}-{:016x}", env!("CARGO_PKG_VERSION"), fnv1a(engine_file.as_bytes()))
}

/// Why there is no unit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum UnitError {
    /// The standard has no name for the platform of the binary.
    #[error("FMI {fmi} has no folder for binaries of {os} on {arch}: export FMI {other}")]
    Platform {
        /// Version of the standard.
        fmi: &'static str,
        /// The other one.
        other: &'static str,
        /// Operating system, as `std::env::consts::OS`.
        os: String,
        /// Processor, as `std::env::consts::ARCH`.
        arch: String,
    },
    /// The archive.
    #[error("the unit cannot be packed: {0}")]
    Archive(#[from] io::Error),
}

/// The library of crate `lanchester-fmu` for one platform.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitBinary {
    /// What the file holds.
    pub bytes: Vec<u8>,
    /// Operating system, as `std::env::consts::OS`.
    pub os: &'static str,
    /// Processor, as `std::env::consts::ARCH`.
    pub arch: &'static str,
    /// Ending of libraries there, with its dot.
    pub suffix: &'static str,
}

/// What a unit is made from, whatever its model.
#[derive(Debug, Clone)]
pub struct UnitParts<'a> {
    /// The text that the model was read from.
    pub engine_file: &'a str,
    /// The files that it names, in the order of [`crate::trace_names`].
    pub traces: &'a [TraceFile],
    /// The library.
    pub binary: UnitBinary,
    /// Which standard.
    pub version: FmiVersion,
}

/// What the description of a unit says of its model.
pub(crate) struct UnitText {
    pub kind: UnitKind,
    pub name: String,
    pub description: String,
    pub variables: Vec<FmuVariable>,
    /// End of an experiment to begin with, and its step [s].
    pub stop: f64,
    pub step: f64,
}

/// The unit for co-simulation: description, binary, engine file and pressures.
pub(crate) fn packed(text: UnitText, parts: UnitParts<'_>) -> Result<Vec<u8>, UnitError> {
    let UnitParts { engine_file, traces, binary, version } = parts;
    let UnitBinary { bytes, os, arch, suffix } = binary;
    let [fmi, other] = match version {
        FmiVersion::Two => ["2.0", "3.0"],
        FmiVersion::Three => ["3.0", "2.0"],
    };
    let folder = binaries_folder(version, os, arch).ok_or_else(|| UnitError::Platform {
        fmi,
        other,
        os: os.to_owned(),
        arch: arch.to_owned(),
    })?;
    let identifier = text.kind.identifier();
    let description = FmuDescription {
        name: text.name,
        identifier: identifier.to_owned(),
        description: text.description,
        program: concat!("lanchester ", env!("CARGO_PKG_VERSION")).to_owned(),
        token: unit_token(text.kind, engine_file),
        variables: text.variables,
        stop: text.stop,
        step: text.step,
    };
    let mut files = vec![
        ("modelDescription.xml".to_owned(), model_description(&description, version).into_bytes()),
        (format!("{folder}/{identifier}{suffix}"), bytes),
        (format!("resources/{UNIT_ENGINE}"), engine_file.as_bytes().to_vec()),
    ];
    for (place, trace) in traces.iter().enumerate() {
        files.push((format!("resources/{}", unit_trace(place)), trace.text.clone().into_bytes()));
    }
    Ok(fmu_archive(&files)?)
}
