//! The pressures of a gas report as a run of the multibody simulation takes them.

use lanchester_mechanism::{CylinderGas, PeriodicCurve};
use lanchester_multibody::GasPressure;

/// Jump of a value or of a slope over a radian, as a share of the curve's range, that counts as a kink.
const KINK: f64 = 1e-6;

/// Pressures on all pistons at one speed, taken at every speed.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenGas<'a> {
    gas: &'a [CylinderGas],
    kinks: Vec<Vec<f64>>,
}

impl<'a> GivenGas<'a> {
    /// From one entry a cylinder.
    pub fn new(gas: &'a [CylinderGas]) -> GivenGas<'a> {
        let kinks = gas.iter().map(|own| [kinks(&own.cylinder), kinks(&own.crankcase)].concat()).collect();
        GivenGas { gas, kinks }
    }
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
    fn pressure(&self, cylinder: usize, own_angle: f64, _: f64) -> f64 {
        let own = &self.gas[cylinder];
        own.cylinder.at(own_angle) - own.crankcase.at(own_angle)
    }

    fn cycle(&self) -> f64 {
        self.gas.first().map_or(2.0 * std::f64::consts::TAU, |own| own.cylinder.period())
    }

    fn kinks(&self, cylinder: usize) -> Vec<f64> {
        self.kinks[cylinder].clone()
    }
}
