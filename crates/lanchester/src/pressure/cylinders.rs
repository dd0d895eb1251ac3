//! The gas of an engine at one speed: from its file and its traces to the pressures on every piston.

use crate::pressure::error::GasError;
use crate::pressure::measured::{self, Measured, TraceFile};
use lanchester_cycle::{
    CylinderVolume, IdealCycle, Indicated, TracePlace, ZoneCycle, ZoneSettings, ideal_cycle, indicated,
    single_zone,
};
use lanchester_mechanism::CylinderGas;
use lanchester_model::{
    CrankcasePressure, Engine, Gas, GasCycle, GasProcess, GasSource, PressureTrace, WallBody, WallModel,
};
use lanchester_results::PeriodicCurve;
use serde::Serialize;

/// Version of the form of [`GasReport`].
pub const GAS_REPORT_VERSION: u32 = 1;

/// Pressures on all pistons at one speed, and where they come from.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
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
    /// What the gas does in the chamber of each cylinder; pistons that share a chamber have the same.
    pub indicated: Vec<Indicated>,
    /// The cycles behind the pressures, where they are computed: each once, with its cylinders.
    pub cycles: Vec<ComputedCycle>,
    /// Temperature of the body that takes heat by a conductance [K]: that of the file, else the one at which it settles at this speed.
    pub body_temperature: Option<f64>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// A cycle that was computed, and the cylinders that have it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ComputedCycle {
    /// Cylinder numbers, from 1.
    pub cylinders: Vec<usize>,
    /// The cycle.
    pub cycle: CylinderCycle,
}

/// A cycle that was computed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CylinderCycle {
    /// An ideal cycle.
    Ideal(Box<IdealCycle>),
    /// Single-zone filling and emptying.
    SingleZone(Box<ZoneCycle>),
}

impl CylinderCycle {
    /// Pressure over the angle since firing top dead centre [Pa].
    pub fn pressure(&self) -> &PeriodicCurve {
        match self {
            CylinderCycle::Ideal(cycle) => &cycle.pressure,
            CylinderCycle::SingleZone(cycle) => &cycle.pressure,
        }
    }
}

/// Names of the files that the engine file asks for, each once.
pub fn trace_names(engine: &Engine) -> Vec<&str> {
    let Some(gas) = &engine.gas else { return Vec::new() };
    let traces = match &gas.source {
        GasSource::Traces { traces, .. } => traces.as_slice(),
        GasSource::Cycle(_) => &[],
    };
    let mut names: Vec<&str> = Vec::new();
    for trace in traces.iter().chain(crankcase_trace(gas)) {
        if !names.contains(&trace.file.as_str()) {
            names.push(&trace.file);
        }
    }
    names
}

fn crankcase_trace(gas: &Gas) -> Option<&PressureTrace> {
    match &gas.crankcase {
        CrankcasePressure::Trace(trace) => Some(trace),
        CrankcasePressure::Constant { .. } => None,
    }
}

/// The pressures on all pistons at a speed of crankshaft 1 [rad/s]; `traces` holds the files that [`trace_names`] names.
///
/// Measured traces are checked, closed and interpolated; a cycle is computed once for cylinders whose pistons move alike.
///
/// # Errors
/// [`GasError`] where the engine has no gas, a file is missing or refused, or its cycle cannot be.
pub fn cylinder_gas(engine: &Engine, traces: &[TraceFile], speed: f64) -> Result<GasReport, GasError> {
    let gas = engine.gas.as_ref().ok_or(GasError::NoGas)?;
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(GasError::Speed { got: speed });
    }
    let volumes = CylinderVolume::of_engine(engine, gas.compression_ratio())?;
    let mut warnings = Vec::new();
    let mut body_temperature = None;
    let (source, pressures, cycles) = match &gas.source {
        GasSource::Traces { traces: named, .. } => {
            let measured = measured::pressures(named, traces, gas, &volumes, speed, TracePlace::Cylinder)?;
            let files: Vec<&str> = named.iter().map(|trace| trace.file.as_str()).collect();
            let Measured { curves, warnings: said } = measured;
            warnings.extend(said);
            (format!("measured: {}", files.join(", ")), curves, Vec::new())
        }
        GasSource::Cycle(cycle) => {
            let (cycles, body) = with_settled_body(cycle, &volumes, speed, &mut warnings)?;
            body_temperature = body;
            let of = |number: usize| cycles.iter().find(|cycle| cycle.cylinders.contains(&number));
            let pressures =
                (1..=volumes.len()).filter_map(|number| Some(of(number)?.cycle.pressure().clone())).collect();
            (name_of(&cycle.process).to_string(), pressures, cycles)
        }
    };
    let crankcases = match &gas.crankcase {
        CrankcasePressure::Constant { pressure } => volumes
            .iter()
            .map(|volume| PeriodicCurve::constant(volume.cycle(), *pressure))
            .collect::<Result<Vec<_>, _>>()?,
        CrankcasePressure::Trace(trace) => {
            let named = std::slice::from_ref(trace);
            let measured = measured::pressures(named, traces, gas, &volumes, speed, TracePlace::Crankcase)?;
            warnings.extend(measured.warnings);
            measured.curves
        }
    };
    Ok(GasReport {
        version: GAS_REPORT_VERSION,
        speed,
        source,
        indicated: pressures.iter().zip(&volumes).map(|(curve, volume)| indicated(curve, volume)).collect(),
        cylinders: (pressures.into_iter().zip(crankcases))
            .map(|(cylinder, crankcase)| CylinderGas { cylinder, crankcase })
            .collect(),
        firing_angles: volumes.iter().map(CylinderVolume::firing_angle).collect(),
        cycles,
        body_temperature,
        warnings,
    })
}

fn name_of(process: &GasProcess) -> &'static str {
    match process {
        GasProcess::Otto { .. } => "computed: Otto cycle",
        GasProcess::Diesel { .. } => "computed: Diesel cycle",
        GasProcess::Seiliger { .. } => "computed: Seiliger cycle",
        GasProcess::Sealed => "computed: closed cylinder",
        GasProcess::SingleZone(_) => "computed: single zone",
    }
}

/// Changes of the body's temperature until it settles, at most; each divides the rest by some ten at least.
const MOST_BODIES: usize = 40;

/// Heat that stays in the body, of what comes, where it has settled: cycles repeat themselves to 1e-7.
const SETTLED: f64 = 1e-6;

/// The cycles, and the temperature of the body that takes heat by a conductance: where the file gives none, the one at which as much
/// heat leaves it as comes from all cylinders, by secants.
fn with_settled_body(
    cycle: &GasCycle,
    volumes: &[CylinderVolume],
    speed: f64,
    warnings: &mut Vec<String>,
) -> Result<(Vec<ComputedCycle>, Option<f64>), GasError> {
    let body = match &cycle.process {
        GasProcess::SingleZone(zone) => zone.walls.as_ref().and_then(|walls| match walls.model {
            WallModel::Conductance(body) => Some(body),
            _ => None,
        }),
        _ => None,
    };
    let Some(body) = body else { return Ok((computed(cycle, volumes, speed, warnings)?, None)) };
    if let Some(temperature) = body.temperature {
        return Ok((computed(cycle, volumes, speed, warnings)?, Some(temperature)));
    }
    let at = |temperature: f64, warnings: &mut Vec<String>| {
        let mut warm = cycle.clone();
        if let GasProcess::SingleZone(zone) = &mut warm.process
            && let Some(walls) = &mut zone.walls
        {
            walls.model = WallModel::Conductance(WallBody { temperature: Some(temperature), ..body });
        }
        let cycles = computed(&warm, volumes, speed, warnings)?;
        let heat: f64 = (cycles.iter())
            .map(|own| match &own.cycle {
                CylinderCycle::SingleZone(zone) => {
                    let volume = &volumes[own.cylinders[0] - 1];
                    let per_second = speed * volume.speed_ratio() / volume.cycle();
                    own.cylinders.len() as f64 * zone.passed.wall_heat * per_second
                }
                CylinderCycle::Ideal(_) => 0.0,
            })
            .sum();
        Ok::<_, GasError>((cycles, heat, heat - body.to_ambient * (temperature - body.ambient)))
    };
    let mut own = Vec::new();
    let mut last = (body.ambient, at(body.ambient, &mut own)?.2);
    let mut now = body.ambient + last.1 / (body.to_ambient + volumes.len() as f64 * body.conductance);
    for _ in 0..MOST_BODIES {
        own.clear();
        let (cycles, heat, rest) = at(now, &mut own)?;
        let slope = (rest - last.1) / (now - last.0);
        if rest.abs() <= SETTLED * heat.abs() || !slope.is_finite() || slope == 0.0 {
            warnings.extend(own);
            return Ok((cycles, Some(now)));
        }
        last = (now, rest);
        now -= rest / slope;
    }
    warnings.extend(own);
    warnings.push(format!("the temperature of the body does not settle: it is taken as {:.1} K", last.0));
    Ok((at(last.0, &mut Vec::new())?.0, Some(last.0)))
}

/// The cycle of every kind of cylinder.
fn computed(
    cycle: &GasCycle,
    volumes: &[CylinderVolume],
    speed: f64,
    warnings: &mut Vec<String>,
) -> Result<Vec<ComputedCycle>, GasError> {
    let mut cycles: Vec<ComputedCycle> = Vec::new();
    for (index, volume) in volumes.iter().enumerate() {
        // Pistons of one chamber have one pressure.
        let alike = cycles.iter_mut().find(|known| {
            known.cylinders.contains(&(volume.chamber() + 1))
                || volumes[known.cylinders[0] - 1].moves_as(volume)
        });
        if let Some(known) = alike {
            known.cylinders.push(index + 1);
            continue;
        }
        let computed = match &cycle.process {
            GasProcess::SingleZone(zone) => {
                let own_speed = speed * volume.speed_ratio();
                let computed = single_zone(cycle, zone, volume, own_speed, &ZoneSettings::default())?;
                if !computed.outcome.converged {
                    warnings.push(format!(
                        "the cycle of cylinder {} does not repeat itself: after {} cycles it still changes by {:.1e} of its state",
                        index + 1,
                        computed.outcome.cycles,
                        computed.outcome.change
                    ));
                }
                CylinderCycle::SingleZone(Box::new(computed))
            }
            GasProcess::Otto { .. }
            | GasProcess::Diesel { .. }
            | GasProcess::Seiliger { .. }
            | GasProcess::Sealed => CylinderCycle::Ideal(Box::new(ideal_cycle(cycle, volume)?)),
        };
        cycles.push(ComputedCycle { cylinders: vec![index + 1], cycle: computed });
    }
    Ok(cycles)
}
