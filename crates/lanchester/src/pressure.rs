//! The gas of an engine at one speed: from its file and its traces to the pressures on every piston.

use lanchester_cycle::{CycleError, CylinderVolume, IdealCycle, Indicated, ideal_cycle, indicated};
use lanchester_mechanism::{CurveError, CylinderGas, PeriodicCurve};
use lanchester_model::{CrankcasePressure, Engine, Gas, GasCycle, GasSource};
use serde::Serialize;

/// Version of the form of [`GasReport`].
pub const GAS_REPORT_VERSION: u32 = 1;

/// A file that the engine file names, with its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TraceFile {
    /// Its name as the engine file gives it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Pressures on all pistons at one speed, and where they come from.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GasReport {
    /// Version of this form.
    pub version: u32,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Where the pressures come from, in words.
    pub source: String,
    /// Pressures over the angle since each cylinder's own firing top dead centre.
    pub cylinders: Vec<CylinderGas>,
    /// `theta` [rad] of that firing top dead centre, for each cylinder; without a firing in the file its first top dead centre.
    pub firing_angles: Vec<f64>,
    /// What the gas does in each cylinder.
    pub indicated: Vec<Indicated>,
    /// The cycle behind each cylinder's pressure, where it is computed.
    pub cycles: Vec<CylinderCycle>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// A cycle that was computed.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CylinderCycle {
    /// An ideal cycle.
    Ideal(IdealCycle),
}

/// Why there are no pressures.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GasError {
    /// The engine file says nothing of gas.
    #[error("the engine file says nothing of the gas\nhint: add [gas] with [[gas.trace]] or [gas.cycle]")]
    NoGas,
    /// This source of pressures is still to come.
    #[error(
        "{what} cannot be computed by this version\nhint: use an ideal cycle and a constant crankcase pressure"
    )]
    NotYet {
        /// What the engine file asks for.
        what: &'static str,
    },
    /// The cycle cannot be.
    #[error(transparent)]
    Cycle(#[from] CycleError),
}

impl From<CurveError> for GasError {
    fn from(error: CurveError) -> GasError {
        GasError::Cycle(error.into())
    }
}

/// Names of the files that the engine file asks for, each once.
pub fn trace_names(engine: &Engine) -> Vec<&str> {
    let Some(gas) = &engine.gas else { return Vec::new() };
    let traces = match &gas.source {
        GasSource::Traces { traces, .. } => traces.as_slice(),
        GasSource::Cycle(_) => &[],
    };
    let crankcase = match &gas.crankcase {
        CrankcasePressure::Trace(trace) => Some(trace),
        CrankcasePressure::Constant { .. } => None,
    };
    let mut names: Vec<&str> = Vec::new();
    for trace in traces.iter().chain(crankcase) {
        if !names.contains(&trace.file.as_str()) {
            names.push(&trace.file);
        }
    }
    names
}

/// The pressures on all pistons at a speed of crankshaft 1 [rad/s]; `traces` holds the files that [`trace_names`] names.
///
/// # Errors
/// [`GasError`] where the engine has no gas, or its gas cannot be.
pub fn cylinder_gas(engine: &Engine, _traces: &[TraceFile], speed: f64) -> Result<GasReport, GasError> {
    let gas = engine.gas.as_ref().ok_or(GasError::NoGas)?;
    match &gas.source {
        GasSource::Cycle(cycle) => of_cycle(engine, gas, cycle, speed),
        GasSource::Traces { .. } => Err(GasError::NotYet { what: "a measured trace" }),
    }
}

fn of_cycle(engine: &Engine, gas: &Gas, cycle: &GasCycle, speed: f64) -> Result<GasReport, GasError> {
    let volumes = CylinderVolume::of_engine(engine, Some(cycle.compression_ratio))?;
    let mut known: Vec<(usize, IdealCycle)> = Vec::new();
    let mut report = GasReport {
        version: GAS_REPORT_VERSION,
        speed,
        source: "an ideal cycle".into(),
        cylinders: Vec::new(),
        firing_angles: volumes.iter().map(CylinderVolume::firing_angle).collect(),
        indicated: Vec::new(),
        cycles: Vec::new(),
        warnings: Vec::new(),
    };
    for (index, volume) in volumes.iter().enumerate() {
        let ideal = match known.iter().find(|(other, _)| volumes[*other].moves_as(volume)) {
            Some((_, ideal)) => ideal.clone(),
            None => {
                let Some(ideal) = ideal_cycle(cycle, volume)? else {
                    return Err(GasError::NotYet { what: "a single zone" });
                };
                known.push((index, ideal.clone()));
                ideal
            }
        };
        let crankcase = match &gas.crankcase {
            CrankcasePressure::Constant { pressure } => PeriodicCurve::constant(volume.cycle(), *pressure)?,
            CrankcasePressure::Trace(_) => {
                return Err(GasError::NotYet { what: "a measured crankcase pressure" });
            }
        };
        report.indicated.push(indicated(&ideal.pressure, volume));
        report.cylinders.push(CylinderGas { cylinder: ideal.pressure.clone(), crankcase });
        report.cycles.push(CylinderCycle::Ideal(ideal));
    }
    Ok(report)
}
