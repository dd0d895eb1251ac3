//! Torsional vibration, with the damper of the file or one that is tried out.

use crate::api::Api;
use crate::asker::Asker;
use crate::problem::Problem;
use crate::questions::reading::engine_file;
use lanchester::file::EngineFile;
use lanchester::model::{Engine, TorsionDamper};
use lanchester::report::TorsionLimit;
use lanchester::torsion::{Campbell, Curve, Mode, TunedDamper};
use lanchester::{TorsionRequest, torsion};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An engine, and numbers of its damper in the place of those of the file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TorsionQuestion {
    /// The engine file.
    text: String,
    /// Moment of inertia of the damper's ring [kg m^2].
    #[serde(default)]
    ring_inertia: Option<f64>,
    /// Viscous damping between ring and hub [N m s/rad].
    #[serde(default)]
    damping: Option<f64>,
    /// Stiffness between ring and hub [N m/rad].
    #[serde(default)]
    stiffness: Option<f64>,
    /// Whether the best setting of the damper is sought: damping of a viscous one, stiffness of rubber.
    #[serde(default)]
    tune: bool,
}

/// Torsional vibration of an engine over its speeds: amplitudes, half of largest less least value.
#[derive(Debug, Serialize, JsonSchema)]
struct TorsionAnswer {
    /// Where the pressures come from, in words; `null` where no gas acts.
    gas: Option<String>,
    /// Names of the stations along the chain.
    stations: Vec<String>,
    /// Undamped natural modes.
    modes: Vec<Mode>,
    /// Place among them of the lowest in which the crankshaft twists; `null` where it twists in none of them.
    twisting: Option<usize>,
    /// Orders and natural frequencies over speed, with the speeds at which they meet.
    campbell: Campbell,
    /// Speeds of crankshaft 1 [rad/s].
    speeds: Vec<f64>,
    /// Orders, per revolution of crankshaft 1.
    orders: Vec<f64>,
    /// Twist between nose and flywheel [rad].
    twist: Curve,
    /// Largest nominal shear stress of all shafts at each speed [Pa]; empty where no section is known.
    stress: Vec<f64>,
    /// The damper, where there is one.
    damper: Option<DamperAnswer>,
    /// The best setting of the damper, where it was asked for.
    tuned: Option<TunedDamper>,
    /// Limits of the file.
    limits: Vec<TorsionLimit>,
    /// What was assumed and left out.
    notes: Vec<String>,
}

/// A damper over speed.
#[derive(Debug, Serialize, JsonSchema)]
struct DamperAnswer {
    /// The damper that these numbers are of.
    used: TorsionDamper,
    /// Heat [W] at each speed.
    power: Vec<f64>,
    /// Amplitude of the ring against the hub [rad].
    ring: Vec<f64>,
}

pub(crate) fn questions(api: Api) -> Api {
    api.post("/api/torsion", "Torsional vibration: `lanchester torsion`.", vibration)
}

fn vibration(asker: &Asker, question: TorsionQuestion) -> Result<TorsionAnswer, Problem> {
    let file = with_damper(asker.studio.with_torques(engine_file(&question.text)?)?, &question)?;
    let traces = asker.studio.traces(&file.engine)?;
    let request = TorsionRequest { tune: question.tune.then_some(None), ..TorsionRequest::default() };
    let found = torsion(&file, &traces, &request).map_err(Problem::refused)?;
    let stress = match found.sweep.shafts.iter().any(|shaft| shaft.stress_rate.is_some()) {
        true => found.stresses(),
        false => Vec::new(),
    };
    let twisting = found.twisting();
    let used = file.engine.torsion.as_ref().and_then(|design| design.damper);
    let damper = used.zip(found.sweep.damper);
    Ok(TorsionAnswer {
        gas: found.gas,
        stations: found.crank.chain.stations().iter().map(|station| station.name.clone()).collect(),
        twisting,
        modes: found.modes,
        campbell: found.campbell,
        speeds: found.sweep.speeds,
        orders: found.sweep.orders,
        twist: found.sweep.twist,
        stress,
        damper: damper.map(|(used, own)| DamperAnswer { used, power: own.power, ring: own.ring }),
        tuned: found.tuned,
        limits: found.limits,
        notes: found.notes,
    })
}

/// The engine with the numbers that are tried out.
fn with_damper(file: EngineFile, question: &TorsionQuestion) -> Result<EngineFile, Problem> {
    let tried = [question.ring_inertia, question.damping, question.stiffness];
    if tried.iter().all(Option::is_none) {
        return Ok(file);
    }
    if let Some(got) = tried.iter().flatten().find(|value| !(**value >= 0.0 && value.is_finite())) {
        return Err(Problem::refused(format!(
            "numbers of a damper must be 0 or more, got {got}\nhint: leave one out for that of the file"
        )));
    }
    let mut parts = file.engine.clone().into_parts();
    let Some(damper) = parts.torsion.as_mut().and_then(|design| design.damper.as_mut()) else {
        return Err(Problem::refused(
            "the engine file has no damper whose numbers could be tried\nhint: add a section [damper]",
        ));
    };
    let [ring_inertia, damping, stiffness] = tried;
    damper.ring_inertia = ring_inertia.unwrap_or(damper.ring_inertia);
    damper.damping = damping.unwrap_or(damper.damping);
    damper.stiffness = stiffness.unwrap_or(damper.stiffness);
    let engine = Engine::new(parts).map_err(|faults| {
        let all: Vec<String> = faults.iter().map(ToString::to_string).collect();
        Problem::refused(all.join("\n"))
    })?;
    Ok(EngineFile { engine, ..file })
}
