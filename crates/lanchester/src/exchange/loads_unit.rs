//! Functional mock-up units of the loads of an engine.

use crate::engine_report::fnv1a;
use crate::exchange::loads_model::{LoadsModel, LoadsModelError};
use crate::pressure::measured::TraceFile;
use lanchester_exchange::{FmiVersion, FmuDescription, binaries_folder, fmu_archive, model_description};
use std::f64::consts::TAU;
use std::io;

/// Name of the engine file among the resources of a unit.
pub const UNIT_ENGINE: &str = "engine.toml";

/// Name of the binary within a unit, without its ending.
const IDENTIFIER: &str = "lanchester_loads";

/// Name of the file of pressures number `place` among the resources of a unit, in the order of [`crate::trace_names`].
pub fn unit_trace(place: usize) -> String {
    format!("trace-{}.csv", place + 1)
}

/// What tells whether a binary and a description belong to an engine file: the program's version and a hash of the text.
pub fn unit_token(engine_file: &str) -> String {
    format!("lanchester-{}-{:016x}", env!("CARGO_PKG_VERSION"), fnv1a(engine_file.as_bytes()))
}

/// Why there is no unit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LoadsUnitError {
    /// The loads.
    #[error(transparent)]
    Loads(#[from] LoadsModelError),
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

/// The unit of an engine's loads ([`LoadsModel`]) for co-simulation: description, binary, engine file and pressures.
///
/// `engine_file` is the text that `model` was read from, `traces` the files that it names in the order of [`crate::trace_names`].
///
/// # Errors
/// [`LoadsUnitError`].
pub fn loads_unit(
    model: &LoadsModel,
    engine_file: &str,
    traces: &[TraceFile],
    binary: UnitBinary,
    version: FmiVersion,
) -> Result<Vec<u8>, LoadsUnitError> {
    let UnitBinary { bytes, os, arch, suffix } = binary;
    let [fmi, other] = match version {
        FmiVersion::Two => ["2.0", "3.0"],
        FmiVersion::Three => ["3.0", "2.0"],
    };
    let folder = binaries_folder(version, os, arch).ok_or_else(|| LoadsUnitError::Platform {
        fmi,
        other,
        os: os.to_owned(),
        arch: arch.to_owned(),
    })?;
    let engine = model.engine();
    let cycle = TAU * f64::from(engine.strokes.revolutions()) / engine.speed.highest;
    let description = FmuDescription {
        name: engine.name.clone(),
        identifier: IDENTIFIER.to_owned(),
        description: format!("Shaking forces, couples and torque of the engine {}", engine.name),
        program: concat!("lanchester ", env!("CARGO_PKG_VERSION")).to_owned(),
        token: unit_token(engine_file),
        variables: model.variables(),
        stop: cycle,
        step: cycle / 720.0,
    };
    let mut files = vec![
        ("modelDescription.xml".to_owned(), model_description(&description, version).into_bytes()),
        (format!("{folder}/{IDENTIFIER}{suffix}"), bytes),
        (format!("resources/{UNIT_ENGINE}"), engine_file.as_bytes().to_vec()),
    ];
    for (place, trace) in traces.iter().enumerate() {
        files.push((format!("resources/{}", unit_trace(place)), trace.text.clone().into_bytes()));
    }
    Ok(fmu_archive(&files)?)
}
