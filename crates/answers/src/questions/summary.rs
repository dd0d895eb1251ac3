//! The engine in short: what the page shows always, and its devices with the keys that say them.

use lanchester::file::{EngineFile, FileEntry, file_entries};
use lanchester::mechanism::{LoadRequest, motion};
use lanchester::model::Engine;
use lanchester::{RunStart, SimulateRequest};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;

/// The engine in short.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EngineSummary {
    name: String,
    /// The word of the file's layout; empty for an engine in its general form.
    layout: String,
    cylinders: usize,
    strokes: u32,
    /// Swept volume [m^3]; 0 where a bore is not known.
    displacement: f64,
    /// Lowest speed [rad/s].
    lowest_speed: f64,
    /// Highest speed [rad/s].
    highest_speed: f64,
    /// Angle of crankshaft 1 after which the firing repeats [rad].
    period: f64,
    counterweights: Vec<DeviceSummary>,
    shafts: Vec<ShaftSummary>,
    has_gas: bool,
    has_mounts: bool,
    has_bearings: bool,
    has_crank_body: bool,
    has_shape_task: bool,
    has_balance: bool,
    has_envelope: bool,
    /// Where a run in time starts.
    run_start: RunStarts,
}

/// Where a run in time starts, by the drive that it is asked for.
#[derive(Debug, Serialize, JsonSchema)]
struct RunStarts {
    /// With the drive of the file.
    given: RunStart,
    /// At free speed.
    free: RunStart,
    /// At imposed speed.
    imposed: RunStart,
}

/// A weight.
#[derive(Debug, Serialize, JsonSchema)]
struct DeviceSummary {
    name: String,
    /// Its entry in the file: `counterweight[0]`; none where the short form makes it.
    path: Option<String>,
    /// Unbalance [kg m].
    unbalance: f64,
    /// Direction at theta = 0 [rad]: of a counterweight in the frame of its crankshaft, of a shaft's weight in the engine's.
    angle: f64,
    /// Its direction as the file counts it [rad]: from its throw, or from the zero of its crankshaft or shaft.
    direction: f64,
    /// The throw from which the file counts its direction, from 1.
    from_throw: Option<usize>,
    /// Plane [m].
    z: f64,
    /// Whether it is a part with a shape.
    has_part: bool,
}

/// A balance shaft.
#[derive(Debug, Serialize, JsonSchema)]
struct ShaftSummary {
    name: String,
    /// Its entry in the file.
    path: Option<String>,
    /// Speed over that of crankshaft 1, signed.
    ratio: f64,
    /// Position of its axis [m].
    x: f64,
    /// Position of its axis [m].
    y: f64,
    weights: Vec<DeviceSummary>,
}

pub(crate) fn summary(file: &EngineFile, text: &str) -> EngineSummary {
    let EngineFile { engine, tasks } = file;
    let entries = file_entries(text);
    let word = |path: &str| {
        let entry = entries.iter().find(|entry| entry.path == path)?;
        entry.value.as_str().map(str::to_string)
    };
    let count = |list: &str| {
        let indices = entries.iter().filter_map(|entry| {
            let rest = entry.path.strip_prefix(list)?.strip_prefix('[')?;
            rest.split(']').next()?.parse::<usize>().ok()
        });
        indices.max().map_or(0, |last| last + 1)
    };
    // Entries of a list come in the order of the file, behind what the short form makes.
    let given = count("counterweight");
    let first = engine.counterweights.len().saturating_sub(given);
    let counterweights = engine.counterweights.iter().enumerate().map(|(index, weight)| {
        let path = index.checked_sub(first).map(|entry| format!("counterweight[{entry}]"));
        let from_throw = throw_of(path.as_deref(), &weight.name, &entries);
        let zero = from_throw.and_then(|throw| engine.throws.get(throw - 1)).map_or(0.0, |throw| throw.angle);
        let angle = weight.part.as_ref().map_or(weight.angle, |part| part.angle);
        DeviceSummary {
            name: weight.name.clone(),
            path,
            unbalance: weight.unbalance,
            angle: weight.angle,
            direction: angle - zero,
            from_throw,
            z: weight.z,
            has_part: weight.part.is_some(),
        }
    });
    let given = count("shaft");
    let first = engine.shafts.len().saturating_sub(given);
    let shafts = engine.shafts.iter().enumerate().map(|(index, shaft)| {
        let path = index.checked_sub(first).map(|entry| format!("shaft[{entry}]"));
        let weights = shaft.weights.iter().enumerate().map(|(number, weight)| DeviceSummary {
            name: shaft.weight_name(number),
            path: path.as_ref().map(|path| format!("{path}.weights[{number}]")),
            unbalance: weight.unbalance,
            angle: weight.phase,
            direction: weight.phase,
            from_throw: None,
            z: weight.z,
            has_part: weight.part.is_some(),
        });
        ShaftSummary {
            name: shaft.name.clone(),
            ratio: shaft.ratio.value(),
            x: shaft.x,
            y: shaft.y,
            weights: weights.collect(),
            path: path.clone(),
        }
    });
    EngineSummary {
        name: engine.name.clone(),
        layout: word("layout.type").unwrap_or_default(),
        cylinders: engine.cylinders.len(),
        strokes: 2 * engine.strokes.revolutions(),
        displacement: displacement(engine),
        lowest_speed: engine.speed.lowest,
        highest_speed: engine.speed.highest,
        period: 2.0 * PI * f64::from(engine.strokes.revolutions()),
        counterweights: counterweights.collect(),
        shafts: shafts.collect(),
        has_gas: engine.gas.is_some(),
        has_mounts: engine.block.is_some() && engine.is_on_springs(),
        has_bearings: engine.bearings.is_some(),
        has_crank_body: engine.crank_body.is_some(),
        has_shape_task: tasks.shape_task.is_some(),
        has_balance: tasks.balance.is_some(),
        has_envelope: engine.envelope.is_some(),
        run_start: {
            let input = tasks.simulation.as_deref();
            let start = |imposed| {
                RunStart::of(engine, input, &SimulateRequest { imposed, ..SimulateRequest::default() })
            };
            RunStarts { given: start(None), free: start(Some(false)), imposed: start(Some(true)) }
        },
    }
}

/// The throw from which a counterweight's direction counts, from 1: that of its entry, or of its name in the short form.
fn throw_of(path: Option<&str>, name: &str, entries: &[FileEntry]) -> Option<usize> {
    let number = |key: &str| match path {
        Some(path) => {
            let own = format!("{path}.{key}");
            let value = &entries.iter().find(|entry| entry.path == own)?.value;
            usize::try_from(value.as_u64()?).ok()
        }
        None => name.strip_prefix(key)?.strip_prefix(' ')?.parse().ok(),
    };
    number("throw").or_else(|| Some(number("web")?.div_ceil(2))).filter(|throw| *throw > 0)
}

/// Swept volume [m^3]; 0 where a bore is not known or a linkage does not turn.
fn displacement(engine: &Engine) -> f64 {
    let strokes = motion(engine, &LoadRequest { samples: 1, ..LoadRequest::default() }).unwrap_or_default();
    let swept = engine.cylinders.iter().zip(&strokes);
    let swept: Option<f64> =
        swept.map(|(cylinder, motion)| Some(PI / 4.0 * cylinder.bore?.powi(2) * motion.stroke)).sum();
    swept.unwrap_or(0.0)
}
