//! What all trains of an output share: period, pressures, the angles at which these jump.

use super::error::SensitivityError;
use super::operating_point::OperatingPoint;
use super::output::Output;
use lanchester_mechanism::{BearingPart, CylinderGas, GasTrain, Lever, LoadRequest, Mechanism, motion};
use lanchester_results::PeriodicCurve;

/// Shares of the range of a pressure, and of that range a radian, beyond which it jumps or bends.
const JUMP: f64 = 1e-7;
const BEND: f64 = 1e-4;
/// How far beside a knot its two sides are looked at [rad].
const BESIDE: f64 = 1e-9;

/// An operating point with what an output asks of it.
pub(super) struct Prepared<'a> {
    pub point: &'a OperatingPoint,
    /// Period of the loads [rad] of crankshaft 1.
    pub period: f64,
    /// By cylinder; empty where gas does not count.
    pub gas: Vec<PistonGas<'a>>,
    /// Whether the masses count.
    pub has_inertia: bool,
}

/// Pressures on a piston.
pub(super) struct PistonGas<'a> {
    pub pressures: &'a CylinderGas,
    /// `theta` at the firing top dead centre [rad].
    pub firing: f64,
    /// Turns of the own crankshaft for one of crankshaft 1, without sign.
    pub rate: f64,
    /// Angles since firing [rad] at which a pressure jumps or bends.
    pub breaks: Vec<f64>,
    /// Angles since firing [rad] between which it is cubic.
    pub knots: Vec<f64>,
}

impl<'a> Prepared<'a> {
    /// # Errors
    /// [`SensitivityError`] where the loads cannot be computed.
    pub fn new(point: &'a OperatingPoint, output: Output) -> Result<Prepared<'a>, SensitivityError> {
        let request = LoadRequest { speed: Some(point.speed), samples: 1, ..LoadRequest::default() };
        let period = Mechanism::new(&point.engine, &request)?.period();
        let has_inertia = output.part != BearingPart::Gas;
        let (true, Some(gas)) = (output.needs().gas, &point.gas) else {
            return Ok(Prepared { point, period, gas: Vec::new(), has_inertia });
        };
        let period = GasTrain::new(&point.engine, gas, Lever::Exact)?.period();
        let motions = motion(&point.engine, &request)?;
        let engine = &point.engine;
        let piston = |(index, pressures): (usize, &'a CylinderGas)| {
            let cylinder = &engine.cylinders[index];
            let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio;
            let both = [&pressures.cylinder, &pressures.crankcase];
            let mut knots: Vec<f64> = both
                .iter()
                .flat_map(|curve| curve.knots().iter().map(|knot| knot.rem_euclid(curve.period())))
                .collect();
            knots.sort_by(f64::total_cmp);
            knots.dedup_by(|next, knot| *next - *knot <= BESIDE);
            let ranges = both.map(|curve| {
                let [(least, _), (most, _)] = curve.extremes();
                (curve, most - least)
            });
            let is_break = |knot: &f64| ranges.iter().any(|(curve, range)| breaks(curve, *range, *knot));
            let breaks = knots.iter().copied().filter(is_break);
            PistonGas {
                pressures,
                // A lone cylinder needs no firing in the file: it fires at its first top dead centre.
                firing: motions[index].firing_angle.unwrap_or(motions[index].top_dead_centre),
                rate: ratio.value().abs(),
                breaks: breaks.collect(),
                knots,
            }
        };
        let gas = gas.iter().enumerate().map(piston).collect();
        Ok(Prepared { point, period, gas, has_inertia })
    }
}

/// Whether a curve whose values have this range jumps or bends at `knot`.
fn breaks(curve: &PeriodicCurve, range: f64, knot: f64) -> bool {
    let [before, after] = [knot - BESIDE, knot + BESIDE];
    let jump = (curve.at(after) - curve.at(before)).abs();
    let bend = (curve.slope(after) - curve.slope(before)).abs();
    jump > JUMP * range + 2.0 * BESIDE * curve.slope(before).abs() || bend > BEND * range
}
