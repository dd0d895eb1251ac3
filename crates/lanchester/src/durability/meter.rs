//! Who tells films and safeties, and what is remembered between engines.

use super::memory::FilmMemory;
use super::words::split_hint;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::CylinderGas;
use lanchester_model::{DrivelineInertia, Engine};
use lanchester_task::{DurabilityCriterion, Measured, Unmeasured};
use std::borrow::Cow;
use std::sync::{Arc, Mutex, PoisonError};

/// At which speeds, and of which engines, criteria of durability are told.
#[derive(Debug, Clone, PartialEq)]
pub struct DurabilityRequest {
    /// Speeds of crankshaft 1 [rad/s], the smallest value of all counting; none: the lowest and the highest of the engine.
    pub speeds: Vec<f64>,
    /// The engines differ in weights alone: pressures, big ends and, without torsional vibration, the formulas after UR M53 are computed once, and each film keeps
    /// the temperature that it has with the first engine.
    pub weights_alone: bool,
    /// Lengths of a similar engine over those of the engine that is measured [1]; pressures over the crank angle and roughness stay.
    pub length: f64,
    /// Speed of the measured engine over that of the similar one, at which its pistons are as fast [1].
    pub speed_of_original: f64,
    /// Whether the safety of fillets by finite elements may be computed: it takes from seconds to minutes an engine.
    pub finite_elements: bool,
    /// What the crankshaft drives: the safety after UR M53 counts the torsional vibration of the chain that the engine gives, where it gives one, at the speeds and
    /// between them at that of the largest torque. `None`: torsional vibration is left out.
    pub driveline: Option<Vec<DrivelineInertia>>,
}

impl Default for DurabilityRequest {
    /// Any engine as it is, at its lowest and highest speed, without finite elements.
    fn default() -> DurabilityRequest {
        DurabilityRequest {
            speeds: Vec::new(),
            weights_alone: false,
            length: 1.0,
            speed_of_original: 1.0,
            finite_elements: false,
            driveline: None,
        }
    }
}

/// Films by tables, quasi-static, with the loads of the closed form; safeties after UR M53; safeties of fillets by finite elements.
///
/// # Example
/// ```
/// use lanchester::task::{DurabilityCriterion, DurabilityMeter};
/// use lanchester::{DurabilityRequest, EngineDurability};
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4-crank-by-elements.toml"));
/// let engine = lanchester::file::read(text).engine().expect("the example has no mistakes");
/// let meter = EngineDurability::new(Ok(&[]), DurabilityRequest { speeds: vec![engine.speed.highest], ..DurabilityRequest::default() });
/// let found = meter.measure(&engine, &[DurabilityCriterion::MainFilm(None)]);
/// // The thinnest film is that of the middle bearing, between two throws that point the same way.
/// assert!(found[0].value().is_some_and(|film| film > 0.5e-6 && film < 5e-6), "{found:?}");
/// ```
pub struct EngineDurability<'a> {
    pub(super) traces: Result<Cow<'a, [TraceFile]>, String>,
    pub(super) request: DurabilityRequest,
    pub(super) films: FilmMemory,
    /// Pressures by speed, where engines differ in weights alone.
    gas: Mutex<Vec<(f64, Pressures)>>,
    pub(super) rule: Mutex<Vec<(DurabilityCriterion, Measured)>>,
}

/// Pressures on all pistons; none where the file does not give them.
pub(super) type Pressures = Arc<Option<Vec<CylinderGas>>>;

impl<'a> EngineDurability<'a> {
    /// With the files of pressures that the engine's file names, or why they cannot be read.
    pub fn new(traces: Result<&'a [TraceFile], String>, request: DurabilityRequest) -> EngineDurability<'a> {
        EngineDurability::with(traces.map(Cow::Borrowed), request)
    }

    /// The same with files of its own.
    pub fn of_files(traces: Vec<TraceFile>, request: DurabilityRequest) -> EngineDurability<'static> {
        EngineDurability::with(Ok(Cow::Owned(traces)), request)
    }

    fn with(
        traces: Result<Cow<'a, [TraceFile]>, String>,
        request: DurabilityRequest,
    ) -> EngineDurability<'a> {
        EngineDurability {
            traces,
            request,
            films: FilmMemory::default(),
            gas: Mutex::default(),
            rule: Mutex::default(),
        }
    }

    /// Speeds of the engine that is measured.
    pub(super) fn speeds(&self, engine: &Engine) -> Vec<f64> {
        if !self.request.speeds.is_empty() {
            return self.request.speeds.clone();
        }
        let mut speeds = vec![engine.speed.lowest, engine.speed.highest];
        speeds.dedup();
        speeds
    }

    /// Pressures at a speed.
    pub(super) fn pressures(&self, engine: &Engine, speed: f64) -> Result<Pressures, Unmeasured> {
        if engine.gas.is_none() {
            return Ok(Arc::new(None));
        }
        let mut known = self.gas.lock().unwrap_or_else(PoisonError::into_inner);
        let at = known.iter().find(|(other, _)| *other == speed && self.request.weights_alone);
        if let Some((_, gas)) = at {
            return Ok(gas.clone());
        }
        let unknown = |reason: String| split_hint(&reason, "give the pressures in [gas]");
        let traces = self.traces.as_ref().map_err(|reason| unknown(reason.clone()))?;
        let gas = cylinder_gas(engine, traces, speed).map_err(|error| unknown(error.to_string()))?;
        let gas = Arc::new(Some(gas.cylinders));
        if self.request.weights_alone {
            known.push((speed, gas.clone()));
        }
        Ok(gas)
    }
}
