//! What becomes of the speed within the cycle: a periodic speed, an inertia that is not known, or an engine that stops.

use crate::speed::ripple::{FLYWHEEL_VERSION, SpeedRipple, TurningInertia};
use lanchester_model::{RotatingBody, RotatingKind};
use serde::Serialize;

/// Lowest speed over the mean [1] below which an engine counts as stopped: a load that takes the same torque at every angle, and the
/// mean pressures of the cycle, say nothing of an engine that nearly stands still.
pub const STOPPED: f64 = 0.05;

/// What is known of what turns beside pistons and rods; `None`: not known.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct KnownInertia {
    /// Flywheel with clutch, and whatever turns rigidly with crankshaft 1 [kg m^2].
    pub flywheel: Option<f64>,
    /// All crankshafts with their counterweights, as seen at crankshaft 1 [kg m^2]; without the rods.
    pub crankshaft: Option<f64>,
}

/// An inertia that is not known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MissingInertia {
    /// That of the flywheel.
    Flywheel,
    /// That of the crankshafts.
    Crankshaft,
}

impl MissingInertia {
    /// What is missing, in words.
    pub fn name(self) -> &'static str {
        match self {
            MissingInertia::Flywheel => "flywheel",
            MissingInertia::Crankshaft => "crankshaft",
        }
    }

    /// Key of the engine file that gives it.
    pub fn key(self) -> &'static str {
        match self {
            MissingInertia::Flywheel => "flywheel.inertia",
            MissingInertia::Crankshaft => "flywheel.crankshaft_inertia",
        }
    }

    /// What gives it, as a suggested fix.
    fn fix(self) -> &'static str {
        match self {
            MissingInertia::Flywheel => "add `inertia` to [flywheel] (0 kg m2 without one)",
            MissingInertia::Crankshaft => {
                "add `crankshaft_inertia` to [flywheel] (0 kg m2 if the flywheel's includes it), or [crank.body]"
            }
        }
    }
}

impl KnownInertia {
    /// Both known.
    pub fn of(given: TurningInertia) -> KnownInertia {
        KnownInertia { flywheel: Some(given.flywheel), crankshaft: Some(given.crankshaft) }
    }

    /// Of all that turns with an engine: its flywheel, and its crankshafts where all of them are known.
    pub fn of_bodies(bodies: &[RotatingBody]) -> KnownInertia {
        let of = |is_wanted: fn(RotatingKind) -> bool| -> Option<f64> {
            let own = bodies.iter().filter(|body| is_wanted(body.kind));
            own.map(|body| body.referred().map(|inertia| inertia.value)).sum()
        };
        KnownInertia {
            flywheel: of(|kind| kind == RotatingKind::Flywheel),
            crankshaft: of(|kind| matches!(kind, RotatingKind::Crankshaft(_))),
        }
    }

    /// What is not known.
    pub fn missing(self) -> Vec<MissingInertia> {
        let of = |known: Option<f64>, missing| known.is_none().then_some(missing);
        let flywheel = of(self.flywheel, MissingInertia::Flywheel);
        flywheel.into_iter().chain(of(self.crankshaft, MissingInertia::Crankshaft)).collect()
    }

    /// What is known, the rest as 0.
    pub fn known(self) -> TurningInertia {
        TurningInertia { flywheel: self.flywheel.unwrap_or(0.0), crankshaft: self.crankshaft.unwrap_or(0.0) }
    }
}

/// The speed within the cycle, or why there is none.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "outcome")]
pub enum RippleOutcome {
    /// The speed repeats.
    Periodic(Box<SpeedRipple>),
    /// An inertia is not known.
    IncompleteInertia(IncompleteInertia),
    /// The engine stops within the cycle.
    Stops(StoppedEngine),
}

/// A speed that is not known for want of an inertia.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct IncompleteInertia {
    /// [`FLYWHEEL_VERSION`].
    pub version: u32,
    /// Mean speed asked for [rad/s].
    pub mean_speed: f64,
    /// What is not known.
    pub missing: Vec<MissingInertia>,
    /// Keys of the engine file that give it.
    pub keys: Vec<String>,
    /// Why, in words.
    pub reason: String,
    /// What fixes it.
    pub fix: String,
}

/// An engine without energy enough for its cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StoppedEngine {
    /// [`FLYWHEEL_VERSION`].
    pub version: u32,
    /// Mean speed asked for [rad/s].
    pub mean_speed: f64,
    /// Lowest speed over the mean below which an engine counts as stopped [1]: [`STOPPED`].
    pub limit: f64,
    /// Flywheel inertia with which the lowest speed stays just above the limit [kg m^2]; `None` where none does.
    pub flywheel: Option<f64>,
    /// Key of the engine file that gives it.
    pub key: String,
    /// Why, in words.
    pub reason: String,
    /// What fixes it.
    pub fix: String,
}

impl RippleOutcome {
    /// For want of `missing`.
    pub(crate) fn incomplete(mean_speed: f64, missing: Vec<MissingInertia>) -> RippleOutcome {
        RippleOutcome::IncompleteInertia(IncompleteInertia {
            version: FLYWHEEL_VERSION,
            mean_speed,
            reason: missing_words(&missing),
            fix: missing_fix(&missing),
            keys: missing.iter().map(|missing| missing.key().to_owned()).collect(),
            missing,
        })
    }

    /// The lowest speed falls below [`STOPPED`]; `flywheel` keeps it above.
    pub(crate) fn stops(mean_speed: f64, flywheel: Option<f64>) -> RippleOutcome {
        let fix = match flywheel {
            Some(flywheel) => format!(
                "a flywheel of {} g m2 or more keeps it turning: `inertia` in [flywheel]",
                rounded_up(1e3 * flywheel)
            ),
            None => "no flywheel keeps it turning at this speed: a higher speed may".to_owned(),
        };
        let reason = format!(
            "the engine stops: the speed falls below {} % of its mean within the cycle",
            100.0 * STOPPED
        );
        let (version, limit) = (FLYWHEEL_VERSION, STOPPED);
        let key = MissingInertia::Flywheel.key().to_owned();
        RippleOutcome::Stops(StoppedEngine { version, mean_speed, limit, flywheel, key, reason, fix })
    }

    /// Mean speed asked for [rad/s].
    pub fn mean_speed(&self) -> f64 {
        match self {
            RippleOutcome::Periodic(ripple) => ripple.mean_speed,
            RippleOutcome::IncompleteInertia(incomplete) => incomplete.mean_speed,
            RippleOutcome::Stops(stopped) => stopped.mean_speed,
        }
    }

    /// The periodic speed.
    pub fn periodic(&self) -> Option<&SpeedRipple> {
        match self {
            RippleOutcome::Periodic(ripple) => Some(ripple),
            RippleOutcome::IncompleteInertia(_) | RippleOutcome::Stops(_) => None,
        }
    }

    /// Why there is no periodic speed, and what fixes it.
    pub fn trouble(&self) -> Option<[&str; 2]> {
        match self {
            RippleOutcome::Periodic(_) => None,
            RippleOutcome::IncompleteInertia(incomplete) => Some([&incomplete.reason, &incomplete.fix]),
            RippleOutcome::Stops(stopped) => Some([&stopped.reason, &stopped.fix]),
        }
    }
}

/// What is not known, in words.
pub fn missing_words(missing: &[MissingInertia]) -> String {
    let names: Vec<&str> = missing.iter().map(|missing| missing.name()).collect();
    format!("the inertia of the {} is not known", names.join(" and of the "))
}

/// What gives it.
pub fn missing_fix(missing: &[MissingInertia]) -> String {
    missing.iter().map(|missing| missing.fix()).collect::<Vec<_>>().join("; ")
}

/// Three digits, not below `value`.
fn rounded_up(value: f64) -> String {
    if value <= 0.0 {
        return "0".to_owned();
    }
    let digits = 2 - value.log10().floor() as i32;
    let unit = 10f64.powi(-digits);
    format!("{:.*}", digits.max(0) as usize, (value / unit).ceil() * unit)
}
