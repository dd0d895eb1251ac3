//! The pressures of gas reports as a run of the multibody simulation takes them.

use crate::mounted::depends_on_speed;
use crate::pressure::cylinders::{GasReport, cylinder_gas};
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::CylinderGas;
use lanchester_model::{CrankcasePressure, Engine, GasSource};
use lanchester_multibody::GasPressure;
use lanchester_results::PeriodicCurve;
use std::borrow::Cow;

/// Jump of a value or of a slope over a radian, as a share of the curve's range, that counts as a kink.
const KINK: f64 = 1e-6;

/// Equal steps of the range of speeds at whose ends a cycle is computed.
const STEPS: usize = 4;

/// Pressures on all pistons at one speed, taken at every speed, or at several speeds, on straight lines between and constant beyond.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenGas<'a> {
    /// Speeds [rad/s], rising.
    speeds: Vec<f64>,
    gas: Vec<Cow<'a, [CylinderGas]>>,
    kinks: Vec<Vec<f64>>,
}

impl<'a> GivenGas<'a> {
    /// From one entry a cylinder, whatever the speed.
    pub fn new(gas: &'a [CylinderGas]) -> GivenGas<'a> {
        GivenGas { speeds: vec![0.0], gas: vec![Cow::Borrowed(gas)], kinks: all_kinks(&[gas]) }
    }

    /// From reports at several speeds that rise.
    pub fn over_speed(reports: &'a [GasReport]) -> GivenGas<'a> {
        let gas: Vec<&[CylinderGas]> = reports.iter().map(|report| &report.cylinders[..]).collect();
        let kinks = all_kinks(&gas);
        let gas = gas.into_iter().map(Cow::Borrowed).collect();
        GivenGas { speeds: reports.iter().map(|report| report.speed).collect(), kinks, gas }
    }

    /// The same with its own copy of the pressures.
    pub fn owned(self) -> GivenGas<'static> {
        let gas = self.gas.into_iter().map(|own| Cow::Owned(own.into_owned())).collect();
        GivenGas { speeds: self.speeds, gas, kinks: self.kinks }
    }
}

/// Kinks of every cylinder at any of the speeds, each once.
fn all_kinks(gas: &[&[CylinderGas]]) -> Vec<Vec<f64>> {
    let of = |cylinder: usize| {
        let curves = gas.iter().flat_map(|gas| [&gas[cylinder].cylinder, &gas[cylinder].crankcase]);
        let mut found: Vec<f64> = curves.flat_map(kinks).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|later, kept| *later - *kept < 1e-9);
        found
    };
    (0..gas.first().map_or(0, |gas| gas.len())).map(of).collect()
}

/// Angles at which the value or the slope of a curve jumps.
fn kinks(curve: &PeriodicCurve) -> Vec<f64> {
    let pieces: Vec<(f64, f64, [f64; 4])> = curve.pieces().collect();
    let values = pieces.iter().map(|(_, _, coefficients)| coefficients[0]);
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let least = KINK * (high - low);
    let jumps = |index: usize| {
        let (_, length, [a, b, c, d]) = pieces[(index + pieces.len() - 1) % pieces.len()];
        let end = [a + length * (b + length * (c + length * d)), b + length * (2.0 * c + 3.0 * length * d)];
        let [from, slope, ..] = pieces[index].2;
        (end[0] - from).abs() > least || (end[1] - slope).abs() > least
    };
    (0..pieces.len()).filter(|index| high > low && jumps(*index)).map(|index| pieces[index].0).collect()
}

impl GasPressure for GivenGas<'_> {
    fn pressure(&self, cylinder: usize, own_angle: f64, speed: f64) -> f64 {
        let at = |index: usize| {
            let own = &self.gas[index][cylinder];
            own.cylinder.at(own_angle) - own.crankcase.at(own_angle)
        };
        let after = self.speeds.partition_point(|known| *known <= speed);
        if after == 0 || after == self.speeds.len() {
            return at(after.saturating_sub(1));
        }
        let (low, high) = (self.speeds[after - 1], self.speeds[after]);
        let share = (speed - low) / (high - low);
        let below = at(after - 1);
        below + share * (at(after) - below)
    }

    fn cycle(&self) -> f64 {
        let first = self.gas.first().and_then(|gas| gas.first());
        first.map_or(2.0 * std::f64::consts::TAU, |own| own.cylinder.period())
    }

    fn kinks(&self, cylinder: usize) -> Vec<f64> {
        self.kinks[cylinder].clone()
    }

    fn bends(&self, cylinder: usize) -> Vec<f64> {
        let curves = self.gas.iter().flat_map(|gas| [&gas[cylinder].cylinder, &gas[cylinder].crankcase]);
        let mut found: Vec<f64> = curves.flat_map(|curve| curve.pieces().map(|piece| piece.0)).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|later, kept| *later - *kept < 1e-9);
        found
    }
}

/// The gas at `speed` alone, or where it depends on the speed at several of the range, `speed` among them: those of the measured traces, or some at which a
/// cycle is computed. The place of `speed` in the list comes with it.
pub(crate) fn gas_over_speed(
    engine: &Engine,
    traces: &[TraceFile],
    speed: f64,
    varies: bool,
) -> Result<(Vec<GasReport>, usize), GasError> {
    let gas = engine.gas.as_ref().ok_or(GasError::NoGas)?;
    let mut speeds = vec![speed];
    if varies && depends_on_speed(gas) {
        let (lowest, highest) = (engine.speed.lowest, engine.speed.highest);
        match &gas.source {
            GasSource::Traces { traces, .. } => {
                speeds.extend(traces.iter().filter_map(|trace| trace.speed));
                if let CrankcasePressure::Trace(trace) = &gas.crankcase {
                    speeds.extend(trace.speed);
                }
            }
            GasSource::Cycle(_) => {
                let at = |step: usize| lowest + (highest - lowest) * step as f64 / STEPS as f64;
                speeds.extend((0..=STEPS).map(at));
            }
        }
    }
    speeds.sort_by(f64::total_cmp);
    // The speed that was asked for stays, others as near as that go.
    speeds.dedup_by(|later, kept| {
        let same = *later - *kept < 1e-3 * *later;
        if same && *later == speed {
            *kept = speed;
        }
        same
    });
    let own = speeds.iter().position(|known| *known == speed).unwrap_or(0);
    let reports = speeds.into_iter().map(|speed| cylinder_gas(engine, traces, speed));
    Ok((reports.collect::<Result<_, _>>()?, own))
}
