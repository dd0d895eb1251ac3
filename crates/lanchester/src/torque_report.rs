//! Torque, friction, flywheel and power of an engine with the gas of its file; loads of its bearings.

use crate::inertias::{known_inertia, rotating_bodies};
use crate::pressure::cycles::cycle_results;
use crate::pressure::cylinders::{GasReport, cylinder_gas};
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::{
    BearingLoads, BearingPart, BearingRequest, BearingSize, Brake, FlywheelNeed, KnownInertia, OuterTorque,
    PowerCurve, RippleOutcome, Torque, TorqueAtSpeed, TorqueError, TorqueRequest, bearing_loads,
    flywheel_need, speed_ripple, torque, torque_without_gas,
};
use lanchester_model::{
    CrankElementForm, Engine, Flywheel, Friction, GasProcess, GasSource, PlainBearing, RodJoint,
    RotatingBody, RotatingKind, SimulationInput, SpeedRange,
};
use lanchester_report::{
    BearingSizes, BearingsInput, CycleResult, Section, TorqueInput, bearings_section, torque_section,
};
use serde::Serialize;

/// Version of the form of [`TorqueReport`].
pub const TORQUE_REPORT_VERSION: u32 = 2;

/// What to compute.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TorqueReportRequest {
    /// Torque at one speed.
    pub torque: TorqueRequest,
    /// Speeds of crankshaft 1 [rad/s] for the power curve; none: no curve.
    pub speeds: Vec<f64>,
    /// Friction; `None`: that of the file, where it gives some.
    pub friction: Option<Friction>,
    /// Inertia of the flywheel [kg m^2]; `None`: that of the file.
    pub flywheel: Option<f64>,
    /// Inertia of the crankshafts at crankshaft 1 [kg m^2]; `None`: that of the file, or of its crank's body.
    pub crankshaft: Option<f64>,
    /// Fluctuation of the speed that a flywheel is to keep [1]; `None`: that of the file.
    pub fluctuation: Option<f64>,
    /// What the file says of a run in time: its torques over the angle count in the fluctuation.
    pub simulation: Option<Box<SimulationInput>>,
}

/// Torque at one speed, and what follows from it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueReport {
    /// [`TORQUE_REPORT_VERSION`].
    pub version: u32,
    /// Where the pressures come from, in words.
    pub source: String,
    /// Torque, work, orders, energy, firing.
    pub torque: Torque,
    /// The cycles behind the pressures, where they are computed.
    pub cycles: Vec<CycleResult>,
    /// What friction leaves, where it is known.
    pub brake: Option<Brake>,
    /// Whether torques over the angle of the file act besides: in `ripples` and `flywheel`, not in `torque`, `speeds` and `power`.
    pub is_driven_besides: bool,
    /// Speed within the cycle at the speeds of the file's flywheel; without these at the lowest speed of the engine and at that of `torque`:
    /// periodic, or why not.
    pub ripples: Vec<RippleOutcome>,
    /// The flywheel for the fluctuation asked for, at that speed of the file's flywheel that needs most; without these at the lowest
    /// speed of the engine.
    pub flywheel: Option<FlywheelNeed>,
    /// Torque and energy at the speeds asked for.
    pub speeds: Vec<TorqueAtSpeed>,
    /// Power over speed, at the brake where friction is known, else net indicated.
    pub power: Option<PowerCurve>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// Why there is no torque.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TorqueReportError {
    /// No pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// No torque from them.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// Too few speeds for a cubic.
    #[error("the power curve needs three or more different speeds, got {got}")]
    Speeds {
        /// Speeds given.
        got: usize,
    },
}

/// Torque of `engine` with its own gas, without gas in the file that of inertia alone; `traces` holds the files that its file names.
///
/// # Errors
/// [`TorqueReportError`] where the file says too little of its gas.
pub fn torque_report(
    engine: &Engine,
    traces: &[TraceFile],
    request: &TorqueReportRequest,
) -> Result<TorqueReport, TorqueReportError> {
    let speed = request.torque.speed.unwrap_or(engine.speed.highest);
    let outer = OuterTorque::of(request.simulation.as_deref()).map_err(TorqueError::from)?;
    let gas_at = |speed: f64| engine.gas.as_ref().map(|_| cylinder_gas(engine, traces, speed)).transpose();
    let torque_at = |gas: Option<&GasReport>, request: &TorqueRequest| match gas {
        Some(gas) => torque(engine, &gas.cylinders, request),
        None => torque_without_gas(engine, request),
    };
    let gas = gas_at(speed)?;
    let found = torque_at(gas.as_ref(), &request.torque)?;
    let mut warnings = gas.as_ref().map(|gas| gas.warnings.clone()).unwrap_or_default();
    // Without gas nothing drives the engine: what friction takes is not reported.
    let friction = request.friction.or(engine.friction).filter(|_| gas.is_some());
    let none = Flywheel::default();
    let wheel = engine.flywheel.as_ref().unwrap_or(&none);
    let of_file = known_inertia(engine);
    let given = KnownInertia {
        flywheel: request.flywheel.or(of_file.flywheel),
        crankshaft: request.crankshaft.or(of_file.crankshaft),
    };
    let idle = engine.speed.lowest;
    let mut speeds = if wheel.speeds.is_empty() { vec![idle, speed] } else { wheel.speeds.clone() };
    speeds.dedup();
    let fluctuation = request.fluctuation.or(wheel.fluctuation);
    let mut ripples = Vec::new();
    let mut flywheel: Option<FlywheelNeed> = None;
    for own in speeds {
        let own_gas = if own == speed { gas.clone() } else { gas_at(own)? };
        let own_gas = own_gas.as_ref().map(|gas| gas.cylinders.as_slice());
        ripples.push(speed_ripple(engine, own_gas, own, &outer, given)?);
        if let Some(wanted) = fluctuation.filter(|_| own == idle || !wheel.speeds.is_empty()) {
            let need = flywheel_need(engine, own_gas, own, &outer, given, wanted)?;
            // None that keeps it is more than any.
            let amount = |need: &FlywheelNeed| need.flywheel.unwrap_or(f64::INFINITY);
            if flywheel.as_ref().is_none_or(|most| amount(&need) > amount(most)) {
                flywheel = Some(need);
            }
        }
    }
    let mut over_speeds = Vec::new();
    for &speed in &request.speeds {
        let gas = gas_at(speed)?;
        // Means do not need the traces or the orders.
        let own = TorqueRequest { speed: Some(speed), samples: 1, max_order: 1, ..request.torque.clone() };
        over_speeds.push(torque_at(gas.as_ref(), &own)?.at_speed());
        for warning in gas.into_iter().flat_map(|gas| gas.warnings) {
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
    }
    let points: Vec<(f64, f64)> = over_speeds
        .iter()
        .map(|at| {
            let brake = friction.map(|friction| at.indicated.brake(&friction, at.speed).power);
            (at.speed, brake.unwrap_or(at.indicated.power))
        })
        .collect();
    let power = match points.len() {
        0 => None,
        _ if gas.is_none() => None,
        got => Some(PowerCurve::fit(&points).ok_or(TorqueReportError::Speeds { got })?),
    };
    let brake = friction.map(|friction| found.indicated.brake(&friction, speed));
    if brake.is_some_and(|brake| brake.torque <= 0.0) {
        warnings.push(
            "FMEP exceeds IMEP: the brake torque is negative, and the engine does not run by itself".into(),
        );
    }
    if !outer.is_none() {
        warnings.push(BESIDES.into());
    }
    if ripples.iter().any(|ripple| matches!(ripple, RippleOutcome::Periodic(_))) {
        warnings.extend(counted_as_nothing(engine));
    }
    let cycles = match &gas {
        Some(gas) => cycle_results(engine, gas).map_err(GasError::from)?,
        None => Vec::new(),
    };
    Ok(TorqueReport {
        version: TORQUE_REPORT_VERSION,
        cycles,
        source: gas.map_or_else(|| WITHOUT_GAS.to_owned(), |gas| gas.source),
        brake,
        torque: found,
        is_driven_besides: !outer.is_none(),
        ripples,
        flywheel,
        speeds: over_speeds,
        power,
        warnings,
    })
}

/// What stands for the source of the pressures where there are none.
const WITHOUT_GAS: &str = "no gas in the engine file, inertia alone";

/// What the user is told where torques over the angle act besides.
const BESIDES: &str = "the torque of [simulation], or its load over the angle, acts besides: cyclic speed fluctuation, excess energy and flywheel count it, the tables of torque are those of gas and inertia";

/// What the user is told of balance shafts and gears whose inertia is not known: the speed fluctuates as if they had none.
fn counted_as_nothing(engine: &Engine) -> Option<String> {
    let is_driven = |body: &RotatingBody| matches!(body.kind, RotatingKind::Shaft(_) | RotatingKind::Gear(_));
    let bodies = rotating_bodies(engine);
    let unknown = bodies.iter().filter(|body| body.inertia.is_none() && is_driven(body));
    let named: Vec<String> = unknown.map(|body| format!("{} (`{}`)", body.name, body.key)).collect();
    (!named.is_empty()).then(|| {
        format!(
            "not known, and counted as 0 in the cyclic speed fluctuation: the moments of inertia of {}; the key in brackets gives each",
            named.join(", ")
        )
    })
}

/// What the user is told of a flywheel where the inertia of the crankshafts is not known.
pub(crate) const UNKNOWN_CRANKSHAFT: &str =
    "the inertia of the crankshaft is not known: the flywheel found includes it";

/// Loads of the bearings of `engine` with its own gas; without gas in the file those of inertia alone.
///
/// # Errors
/// As [`torque_report`].
pub fn bearing_report(
    engine: &Engine,
    traces: &[TraceFile],
    request: &BearingRequest,
) -> Result<BearingLoads, TorqueReportError> {
    let speed = request.speed.unwrap_or(engine.speed.highest);
    let gas = match &engine.gas {
        Some(_) => Some(cylinder_gas(engine, traces, speed)?.cylinders),
        None => None,
    };
    Ok(bearing_loads(engine, gas.as_deref(), request)?)
}

/// Loads of the bearings with and without their parts: what a report shows.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingStudy {
    /// Gas and inertia together, gas alone, inertia alone; without gas in the file inertia alone.
    pub parts: Vec<BearingLoads>,
    /// All loads without counterweights, where the engine has some.
    pub bare: Option<BearingLoads>,
}

impl BearingStudy {
    /// As a section of a report; `None` where there is nothing to show.
    pub fn section(&self, engine: &Engine) -> Option<Section> {
        let sizes = bearing_sizes(engine);
        bearings_section(&BearingsInput { parts: &self.parts, bare: self.bare.as_ref(), sizes })
    }
}

impl TorqueReport {
    /// As a section of a report.
    pub fn section(&self) -> Section {
        torque_section(&TorqueInput {
            torque: &self.torque,
            source: &self.source,
            brake: self.brake.as_ref(),
            cycles: &self.cycles,
            ripples: &self.ripples,
            flywheel: self.flywheel.as_ref(),
            speeds: &self.speeds,
            power: self.power.as_ref(),
        })
    }
}

/// Loads of the bearings of `engine` at a speed of crankshaft 1 [rad/s].
///
/// # Errors
/// As [`torque_report`].
pub fn bearing_study(
    engine: &Engine,
    traces: &[TraceFile],
    speed: f64,
) -> Result<BearingStudy, TorqueReportError> {
    let gas = match &engine.gas {
        Some(_) => Some(cylinder_gas(engine, traces, speed)?.cylinders),
        None => None,
    };
    let loads = |part, counterweights| {
        let request =
            BearingRequest { speed: Some(speed), part, counterweights, ..BearingRequest::default() };
        bearing_loads(engine, gas.as_deref(), &request)
    };
    let parts: &[BearingPart] = if gas.is_some() { &BearingPart::ALL } else { &[BearingPart::Inertia] };
    let has_weights = engine.counterweights.iter().any(|weight| weight.unbalance > 0.0);
    Ok(BearingStudy {
        parts: parts.iter().map(|part| loads(*part, true)).collect::<Result<_, _>>()?,
        bare: if has_weights { Some(loads(parts[0], false)?) } else { None },
    })
}

/// Speeds at which power over speed is worth telling [rad/s], three or more, rising: those of the measured traces; `count` over the
/// range of the engine for a cycle that knows of speed. None where the pressures do not depend on it.
pub fn power_speeds(engine: &Engine, count: usize) -> Vec<f64> {
    let mut speeds: Vec<f64> = match engine.gas.as_ref().map(|gas| &gas.source) {
        Some(GasSource::Traces { traces, .. }) => traces.iter().filter_map(|trace| trace.speed).collect(),
        Some(GasSource::Cycle(cycle)) if matches!(cycle.process, GasProcess::SingleZone(_)) => {
            let SpeedRange { lowest, highest } = engine.speed;
            let last = count.saturating_sub(1).max(1) as f64;
            (0..count).map(|k| lowest + (highest - lowest) * k as f64 / last).collect()
        }
        Some(GasSource::Cycle(_)) | None => Vec::new(),
    };
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    if speeds.len() < 3 { Vec::new() } else { speeds }
}

/// Sizes of the bearings: those of the file, else of the crank's body. Of the body come the diameters; crankpins as long as the webs leave
/// room, shared by the rods that sit on them, main journals as long as the shortest one; of pins and journals that differ the smallest.
pub fn bearing_sizes(engine: &Engine) -> BearingSizes {
    let body = body_bearings(engine);
    let given = engine.bearings.unwrap_or_default();
    let size = |given: Option<PlainBearing>, body: Option<BearingSize>| match given {
        Some(given) => {
            let diameter = given.diameter.or(body.map(|body| body.diameter))?;
            Some(BearingSize { diameter, width: given.width })
        }
        None => body,
    };
    BearingSizes {
        piston_pin: size(given.piston_pin, None),
        crankpin: size(given.crankpin, body.crankpin),
        main: size(given.main, body.main),
    }
}

fn body_bearings(engine: &Engine) -> BearingSizes {
    let rods = |throw: usize| {
        let on_pin = engine.cylinders.iter().filter(|cylinder| cylinder.throw == throw);
        on_pin.filter(|c| matches!(c.rod.joint, RodJoint::Crankpin)).count().max(1) as f64
    };
    // Of pins and journals that differ the smallest.
    let (mut pin, mut main): (Option<BearingSize>, Option<BearingSize>) = (None, None);
    let smaller = |known: &mut Option<BearingSize>, diameter: f64, width: f64| {
        let least = known.unwrap_or(BearingSize { diameter, width });
        *known = Some(BearingSize { diameter: least.diameter.min(diameter), width: least.width.min(width) });
    };
    for crankshaft in 0..engine.crankshafts.len() {
        for element in engine.crank_elements(crankshaft).unwrap_or_default() {
            match element.form {
                CrankElementForm::Pin { throw, bar, .. } => {
                    smaller(&mut pin, bar.diameter, element.length() / rods(throw));
                }
                CrankElementForm::Journal { bar, .. } => smaller(&mut main, bar.diameter, element.length()),
                _ => {}
            }
        }
    }
    BearingSizes { piston_pin: None, crankpin: pin, main }
}
