//! The pressures of an engine at any speed, for an optimum that counts the gas over a range of speeds.

use crate::inertias::with_known_rotors;
use crate::mounted::depends_on_speed;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::measured::TraceFile;
use lanchester_balance::{
    Answer, BalanceError, BalanceSettings, GasOverSpeed, Next, SearchState, optimise_watched,
};
use lanchester_mechanism::CylinderGas;
use lanchester_model::{Engine, GasSource};
use lanchester_results::PeriodicCurve;
use lanchester_task::BalanceTask;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Equal steps of speed at whose ends a cycle is computed.
const STEPS: usize = 12;

/// The best that exists for `task`, as [`optimise_watched`]; loads with gas have the pressures of the file, with the `traces` that it
/// names or why they cannot be read. A cycle is computed at 13 speeds of the range at most; between them the pressures
/// over the angle are interpolated, as those of measured traces are. The mounts feel the spin of what turns, of crankshafts that are bodies too.
///
/// # Errors
/// As [`optimise_watched`].
///
/// # Example
/// ```
/// use lanchester::balance::{BalanceSettings, Next};
/// use lanchester::task::{BalanceTask, Criterion, Mains, Stage, Statistic};
///
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4-mounts.toml"));
/// let engine = lanchester::file::read(text).engine().expect("the example has no mistakes");
/// let peak = Criterion::MainsWithGas(Statistic::Peak, Mains::Largest);
/// let task = BalanceTask { stages: vec![Stage::of(vec![(1.0, peak)])], ..BalanceTask::default() };
/// let settings = BalanceSettings::default();
/// let answer = lanchester::optimised(&engine, Ok(&[]), &task, &settings, &|_| Next::Continue)?;
/// // The gas loads the bearings most where the engine is slow.
/// let told = answer.gas_speeds.expect("loads with gas are judged over the range");
/// assert!(told.worst < 0.5 * engine.speed.highest);
/// # Ok::<(), lanchester::balance::BalanceError>(())
/// ```
pub fn optimised(
    engine: &Engine,
    traces: Result<&[TraceFile], String>,
    task: &BalanceTask,
    settings: &BalanceSettings,
    watch: &dyn Fn(&SearchState<'_>) -> Next,
) -> Result<Answer, BalanceError> {
    let gas = SpeedGas::new(engine, traces);
    let gas: Option<&dyn GasOverSpeed> = if engine.gas.is_some() { Some(&gas) } else { None };
    optimise_watched(&with_known_rotors(engine), task, gas, settings, watch)
}

/// The pressures of an engine, each computed once.
pub(crate) struct SpeedGas<'a> {
    engine: &'a Engine,
    traces: Result<&'a [TraceFile], String>,
    /// By step of the range.
    known: RefCell<BTreeMap<usize, Rc<Vec<CylinderGas>>>>,
}

impl<'a> SpeedGas<'a> {
    /// Of `engine`, with the `traces` that its file names or why they cannot be read.
    pub fn new(engine: &'a Engine, traces: Result<&'a [TraceFile], String>) -> SpeedGas<'a> {
        SpeedGas { engine, traces, known: RefCell::default() }
    }
}

impl GasOverSpeed for SpeedGas<'_> {
    fn at(&self, speed: f64) -> Result<Vec<CylinderGas>, String> {
        let Some(gas) = &self.engine.gas else { return self.computed(speed) };
        let (lowest, highest) = (self.engine.speed.lowest, self.engine.speed.highest);
        if !depends_on_speed(gas) {
            return Ok(self.step(0, highest)?.to_vec());
        }
        // Measured traces are interpolated where they are read; outside the range nothing is known to lie between.
        let measured = matches!(gas.source, GasSource::Traces { .. });
        if measured || !(lowest..=highest).contains(&speed) || lowest >= highest {
            return self.computed(speed);
        }
        let place = (speed - lowest) / (highest - lowest) * STEPS as f64;
        let below = (place.floor() as usize).min(STEPS - 1);
        let share = place - below as f64;
        if share == 0.0 || share == 1.0 {
            let step = below + share as usize;
            return Ok(self.step(step, self.speed_of(step))?.to_vec());
        }
        let (first, second) =
            (self.step(below, self.speed_of(below))?, self.step(below + 1, self.speed_of(below + 1))?);
        let between = |a: &PeriodicCurve, b: &PeriodicCurve| {
            PeriodicCurve::sum(&[(1.0 - share, a), (share, b)]).map_err(|error| error.to_string())
        };
        let cylinders = first.iter().zip(second.iter()).map(|(a, b)| {
            Ok(CylinderGas {
                cylinder: between(&a.cylinder, &b.cylinder)?,
                crankcase: between(&a.crankcase, &b.crankcase)?,
            })
        });
        cylinders.collect()
    }

    fn knots(&self) -> Vec<f64> {
        let Some(gas) = &self.engine.gas else { return Vec::new() };
        let (lowest, highest) = (self.engine.speed.lowest, self.engine.speed.highest);
        if !depends_on_speed(gas) || lowest >= highest {
            return vec![highest];
        }
        match &gas.source {
            GasSource::Traces { traces, .. } => {
                let speeds = traces.iter().map(|trace| trace.speed).collect::<Option<Vec<f64>>>();
                let mut speeds = speeds.unwrap_or_default();
                speeds.sort_by(f64::total_cmp);
                speeds
            }
            GasSource::Cycle(_) => (0..=STEPS).map(|step| self.speed_of(step)).collect(),
        }
    }
}

impl SpeedGas<'_> {
    fn computed(&self, speed: f64) -> Result<Vec<CylinderGas>, String> {
        let traces = self.traces.clone()?;
        cylinder_gas(self.engine, traces, speed).map(|gas| gas.cylinders).map_err(|error| error.to_string())
    }

    /// Speed of a step of the range [rad/s].
    fn speed_of(&self, step: usize) -> f64 {
        let (lowest, highest) = (self.engine.speed.lowest, self.engine.speed.highest);
        lowest + (highest - lowest) * step as f64 / STEPS as f64
    }

    /// The pressures at a step of the range, which is at `speed`.
    fn step(&self, step: usize, speed: f64) -> Result<Rc<Vec<CylinderGas>>, String> {
        if let Some(known) = self.known.borrow().get(&step) {
            return Ok(Rc::clone(known));
        }
        let found = Rc::new(self.computed(speed)?);
        self.known.borrow_mut().insert(step, Rc::clone(&found));
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At a computed speed the pressures are those of the cycle there; between two they lie between, close to the cycle's own.
    #[test]
    fn a_computed_cycle_is_interpolated_between_its_speeds() {
        let text = include_str!("../../../../examples/single-gas.toml");
        let engine = lanchester_file::read(text).engine().expect("the example has no mistakes");
        let gas = SpeedGas::new(&engine, Ok(&[]));
        let (lowest, highest) = (engine.speed.lowest, engine.speed.highest);
        let step = (highest - lowest) / STEPS as f64;
        let [known, between, next] = [0.0, 0.5, 1.0].map(|place| {
            let speed = lowest + (3.0 + place) * step;
            let found = gas.at(speed).expect("it has gas");
            (found, cylinder_gas(&engine, &[], speed).expect("it has gas").cylinders)
        });
        assert_eq!(known.0, known.1);
        let peak = |gas: &[CylinderGas]| gas[0].cylinder.extremes()[1].1;
        let ends = [peak(&known.0), peak(&next.0)];
        let middle = peak(&between.0);
        assert!(middle <= ends[0].max(ends[1]) * (1.0 + 1e-12), "{ends:?} {middle}");
        let exact = peak(&between.1);
        assert!((middle - exact).abs() < 0.01 * exact, "{middle} {exact}");
    }
}
