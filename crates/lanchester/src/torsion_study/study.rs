//! Torsional vibration of an engine over its speed range.

use super::error::EngineTorsionError;
use super::excitation::{ExcitingGas, engine_excitation};
use crate::inertias::{rotating_bodies, throw_inertias};
use crate::pressure::measured::TraceFile;
use lanchester_file::EngineFile;
use lanchester_model::{DamperKind, DrivelineInertia, Engine};
use lanchester_report::{
    LimitedQuantity, MeshedThrow, TORSION_VERSION, TimeAmplitudes, TimeCheck, TorsionLimit, TorsionResult,
};
use lanchester_torsion::{
    Chain, CrankChain, CrankChainInput, Excitation, Sweep, TorsionError, TuneAim, TuneFree, TuneRequest,
    as_viscous, campbell, crank_chain, damped_modes, holzer, modes, order_stars, peak, periodic_motion,
    sweep, tune,
};

/// Speeds over the range of the engine where none are asked for.
pub const TORSION_SPEEDS: usize = 201;
/// Highest order where the file names none.
const HIGHEST_ORDER: f64 = 12.0;
/// Points of the curve of a tuning.
const TUNE_POINTS: usize = 41;
/// Natural frequencies with a table of Holzer.
const HOLZER_TABLES: usize = 3;

/// What to compute.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TorsionRequest {
    /// Speeds of crankshaft 1 [rad/s], rising; none: 201 over the range of the engine.
    pub speeds: Vec<f64>,
    /// Highest order; `None`: that of the file, else 12.
    pub highest_order: Option<f64>,
    /// Whether the gas of the file is left out.
    pub without_gas: bool,
    /// What of the damper is to be found, where it is to be tuned; the outer `None`: nothing, the inner one: damping of a viscous one, stiffness of rubber.
    pub tune: Option<Option<TuneFree>>,
    /// What the tuned damper is to keep small.
    pub aim: Option<TuneAim>,
    /// Speed of a check in the time domain [rad/s].
    pub time: Option<f64>,
    /// Stiffness of throws by finite elements ([`crate::meshed_throws`]); none: that of the file or of its sizes.
    pub meshed: Vec<MeshedThrow>,
}

/// Whether a report tells of torsional vibration: the file says something of it.
pub(crate) fn has_torsion(engine: &Engine) -> bool {
    engine.torsion.is_some()
}

/// The torsional chain of an engine.
///
/// # Errors
/// [`TorsionError::Needs`] with all that the file does not say.
pub fn engine_chain(file: &EngineFile, stiffness: &[(usize, f64)]) -> Result<CrankChain, TorsionError> {
    chain_of(&file.engine, driveline(file), stiffness)
}

/// What the crankshaft of a file drives.
pub(crate) fn driveline(file: &EngineFile) -> &[DrivelineInertia] {
    file.tasks.simulation.as_ref().map_or(&[], |input| &input.driveline)
}

fn chain_of(
    engine: &Engine,
    driveline: &[DrivelineInertia],
    stiffness: &[(usize, f64)],
) -> Result<CrankChain, TorsionError> {
    let shares = throw_inertias(engine);
    let throws: Vec<Option<f64>> = (0..engine.throws.len())
        .map(|throw| shares.iter().find(|share| share.throw == throw).map(|share| share.inertia))
        .collect();
    let bodies = rotating_bodies(engine);
    crank_chain(&CrankChainInput { engine, bodies: &bodies, throws: &throws, driveline, stiffness })
}

/// A chain and its forced vibration over speed.
pub(crate) struct Swept {
    pub crank: CrankChain,
    pub excitation: Excitation,
    /// Speeds of crankshaft 1 [rad/s], rising.
    pub speeds: Vec<f64>,
    pub sweep: Sweep,
    /// Where the pressures come from.
    pub gas: Option<String>,
    pub notes: Vec<String>,
}

/// Forced vibration of the chain of an engine over the speeds of a request. The gas is that at a speed over `speed_of_original`.
///
/// # Errors
/// As [`torsion`].
pub(crate) fn swept(
    engine: &Engine,
    driveline: &[DrivelineInertia],
    traces: &[TraceFile],
    request: &TorsionRequest,
    speed_of_original: f64,
) -> Result<Swept, EngineTorsionError> {
    let stiffness: Vec<_> = request.meshed.iter().map(MeshedThrow::taken).collect();
    let mut crank = chain_of(engine, driveline, &stiffness)?;
    let mut notes = std::mem::take(&mut crank.notes);
    let speeds = speeds(engine, request, &mut notes)?;
    let of_file = engine.torsion.as_ref().and_then(|design| design.highest_order);
    let highest = request.highest_order.or(of_file).unwrap_or(HIGHEST_ORDER);
    if !(1.0..=60.0).contains(&highest) {
        return Err(EngineTorsionError::Order { got: highest });
    }
    let gas = ExcitingGas { is_on: !request.without_gas, speed_of_original };
    let (excitation, gas) = engine_excitation(engine, traces, &crank, &speeds, highest, gas)?;
    let sweep = sweep(&crank.chain, &excitation, &speeds)?;
    Ok(Swept { crank, excitation, speeds, sweep, gas, notes })
}

/// So many speeds as a range is looked at [rad/s].
pub(crate) fn speeds_between(low: f64, high: f64) -> Vec<f64> {
    (0..TORSION_SPEEDS).map(|k| low + (high - low) * k as f64 / (TORSION_SPEEDS - 1) as f64).collect()
}

/// Torsional vibration of an engine; `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`EngineTorsionError`] where the file says too little, all at once.
pub fn torsion(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &TorsionRequest,
) -> Result<TorsionResult, EngineTorsionError> {
    let engine = &file.engine;
    let Swept { crank, excitation, speeds, sweep: swept, gas, mut notes } =
        swept(engine, driveline(file), traces, request, 1.0)?;
    let design = engine.torsion.clone().unwrap_or_default();
    if gas.is_none() {
        notes.push("no gas acts: the torques are those of the moving masses alone".to_owned());
    }
    let chain = &crank.chain;
    let last = speeds.last().copied().unwrap_or(1.0);
    let own_modes = modes(chain, last)?;
    let firings: Option<Vec<(usize, f64)>> = engine
        .cylinders
        .iter()
        .map(|cylinder| Some((crank.throws[cylinder.throw], cylinder.firing_angle?)))
        .collect();
    let diagram = campbell(chain, &excitation, &speeds)?;
    let tuned =
        request.tune.map(|free| tuned(chain, &excitation, &speeds, engine, free, request.aim)).transpose()?;
    let time = request.time.map(|speed| time_check(chain, &excitation, speed)).transpose()?;
    let mut result = TorsionResult {
        meshed: request.meshed.clone(),
        version: TORSION_VERSION,
        engine: engine.name.clone(),
        gas,
        damped: damped_modes(chain, last)?,
        holzer: own_modes
            .iter()
            .take(HOLZER_TABLES)
            .map(|mode| holzer(chain, mode.frequency, last))
            .collect(),
        stars: firings
            .map_or_else(Vec::new, |firings| order_stars(chain, &own_modes, &firings, &diagram.orders)),
        campbell: diagram,
        modes: own_modes,
        sweep: swept,
        tuned,
        time,
        limits: Vec::new(),
        notes,
        crank,
    };
    let swing = largest_swing(&result);
    let is_known = swing <= LARGE_SWING;
    let limit = |quantity, allowed: Option<f64>, values: &[f64]| {
        let (at, found) = peak(values);
        allowed.map(|allowed| TorsionLimit { quantity, allowed, found, speed: speeds[at], is_known })
    };
    let stresses = result.stresses();
    if design.stress_limit.is_some() && result.sweep.shafts.iter().all(|shaft| shaft.stress_rate.is_none()) {
        result.notes.push(
            "the limit of the stress is not checked: no section is known; give [crank.body]".to_owned(),
        );
    } else {
        result.limits.extend(limit(LimitedQuantity::Stress, design.stress_limit, &stresses));
    }
    result.limits.extend(limit(LimitedQuantity::Twist, design.twist_limit, &result.sweep.twist.total));
    if !is_known {
        result.notes.push(format!(
            "pendulums swing by ±{:.0} deg, beyond the linear theory: their order falls with the swing",
            swing.to_degrees()
        ));
    }
    Ok(result)
}

/// Swing of a pendulum [rad] beyond which the linear theory is far off.
const LARGE_SWING: f64 = 0.5;

/// Of all pendulums at all speeds [rad].
fn largest_swing(result: &TorsionResult) -> f64 {
    result.sweep.pendulums.iter().map(|pendulum| peak(&pendulum.swing).1).fold(0.0, f64::max)
}

fn speeds(
    engine: &Engine,
    request: &TorsionRequest,
    notes: &mut Vec<String>,
) -> Result<Vec<f64>, EngineTorsionError> {
    if !request.speeds.is_empty() {
        let mut before = 0.0;
        for &got in &request.speeds {
            if !(got > before && got.is_finite()) {
                return Err(EngineTorsionError::Speeds { got, before });
            }
            before = got;
        }
        return Ok(request.speeds.clone());
    }
    let (mut low, high) = (engine.speed.lowest, engine.speed.highest);
    if low >= high {
        low = 0.4 * high;
        notes.push("the file gives one speed: computed is from 40 % of it on".to_owned());
    }
    Ok(speeds_between(low, high))
}

fn tuned(
    chain: &Chain,
    excitation: &Excitation,
    speeds: &[f64],
    engine: &Engine,
    free: Option<TuneFree>,
    aim: Option<TuneAim>,
) -> Result<lanchester_torsion::TunedDamper, TorsionError> {
    let kind = engine.torsion.as_ref().and_then(|design| design.damper).map(|damper| damper.kind);
    let usual = if kind == Some(DamperKind::Rubber) { TuneFree::Stiffness } else { TuneFree::Damping };
    // The peaks are refined between the speeds: half as many do.
    let coarse: Vec<f64> = if speeds.len() > 101 {
        let last = speeds.len() - 1;
        speeds
            .iter()
            .enumerate()
            .filter(|(index, _)| index % 2 == 0 || *index == last)
            .map(|(_, speed)| *speed)
            .collect()
    } else {
        speeds.to_vec()
    };
    let request = TuneRequest {
        aim: aim.unwrap_or(TuneAim::Twist),
        free: free.unwrap_or(usual),
        speeds: coarse,
        damping: None,
        stiffness: None,
        points: TUNE_POINTS,
    };
    tune(chain, excitation, &request)
}

/// Orders, the same in time, and with varying inertia.
fn time_check(chain: &Chain, excitation: &Excitation, speed: f64) -> Result<TimeCheck, TorsionError> {
    let frequency = modes(chain, speed)?.first().map_or(1.0, |mode| mode.frequency);
    let chain = as_viscous(chain, frequency)?;
    let orders = sweep(&chain, excitation, &[speed])?;
    let linear = periodic_motion(&chain, excitation, speed, false)?;
    let varying = periodic_motion(&chain, excitation, speed, true)?;
    let of = |motion: &lanchester_torsion::PeriodicMotion| TimeAmplitudes {
        torques: motion.torques.clone(),
        twist: motion.twist,
        energy: Some(motion.energy),
        energy_error: Some(motion.energy.error()),
    };
    Ok(TimeCheck {
        speed,
        frequency,
        orders: TimeAmplitudes {
            torques: orders.shafts.iter().map(|shaft| shaft.total[0]).collect(),
            twist: orders.twist.total[0],
            energy: None,
            energy_error: None,
        },
        evaluations: linear.evaluations + varying.evaluations,
        linear: of(&linear),
        varying: of(&varying),
    })
}
