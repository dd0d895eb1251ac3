//! What the gas does: indicated work by p dV, mean effective pressure, peaks, the p-V diagram.

use crate::volume::CylinderVolume;
use lanchester_numerics::GAUSS_8;
use lanchester_results::PeriodicCurve;
use serde::Serialize;
use std::f64::consts::TAU;

/// What the gas in one cylinder does in a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Indicated {
    /// Net indicated work [J]: of the whole cycle.
    pub work: f64,
    /// Work of compression and expansion, from bottom to bottom dead centre around firing [J]; all of it for two strokes.
    pub gross_work: f64,
    /// Work of the gas exchange [J], negative where it costs; 0 for two strokes.
    pub exchange_work: f64,
    /// Net indicated mean effective pressure [Pa]: work over displaced volume.
    pub mean_effective_pressure: f64,
    /// Displaced volume [m^3].
    pub displaced_volume: f64,
    /// Largest pressure [Pa].
    pub peak_pressure: f64,
    /// Angle of the largest pressure [rad], within half a cycle of the firing top dead centre.
    pub peak_angle: f64,
    /// Smallest pressure [Pa].
    pub least_pressure: f64,
}

/// A point of the p-V diagram.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PvPoint {
    /// Angle since firing top dead centre [rad].
    pub angle: f64,
    /// Volume [m^3].
    pub volume: f64,
    /// Absolute pressure [Pa].
    pub pressure: f64,
}

/// What the gas does in a cycle: integrals on the pieces of the curve with the exact motion.
pub fn indicated(pressure: &PeriodicCurve, volume: &CylinderVolume) -> Indicated {
    let bottom = volume.bottom_angle();
    let gross_work = work_between(pressure, volume, bottom - TAU, bottom);
    let rest = volume.cycle() - TAU;
    let exchange_work = if rest > 0.0 { work_between(pressure, volume, bottom, bottom + rest) } else { 0.0 };
    let work = gross_work + exchange_work;
    let [(least_pressure, _), (peak_pressure, peak_angle)] = pressure.extremes();
    let half = volume.cycle() / 2.0;
    Indicated {
        work,
        gross_work,
        exchange_work,
        mean_effective_pressure: work / volume.displaced(),
        displaced_volume: volume.displaced(),
        peak_pressure,
        peak_angle: if peak_angle > half { peak_angle - volume.cycle() } else { peak_angle },
        least_pressure,
    }
}

/// Work of a pressure from angle `from` to `to` [J].
///
/// ```text
/// W = INTEGRAL p dV/dpsi dpsi                                                            (28.8)
/// ```
/// Gauss's rule of eight points on every piece of the pressure, cut where it is wide: exact for a cubic times a
/// motion that is smooth over it.
pub fn work_between(pressure: &PeriodicCurve, volume: &CylinderVolume, from: f64, to: f64) -> f64 {
    let period = pressure.period();
    let mut work = 0.0;
    for (knot, length, [a, b, c, d]) in pressure.pieces() {
        // The first repetition of the piece that ends beyond `from`.
        let mut start = knot + period * ((from - knot - length) / period).ceil();
        while start < to {
            let (low, high) = (start.max(from), (start + length).min(to));
            let count = ((high - low) / WIDEST).ceil();
            for part in 0..count as u32 {
                let step = (high - low) / count;
                let middle = low + step * (f64::from(part) + 0.5);
                for (x, weight) in GAUSS_8 {
                    for psi in [middle - x * step, middle + x * step] {
                        let u = psi - start;
                        let value = a + u * (b + u * (c + u * d));
                        work += step * weight * value * volume.at(psi)[1];
                    }
                }
            }
            start += period;
        }
    }
    work
}

/// The p-V diagram at `count` equal steps over a cycle; the first angle is 0.
pub fn pressure_volume(pressure: &PeriodicCurve, volume: &CylinderVolume, count: usize) -> Vec<PvPoint> {
    let step = volume.cycle() / count as f64;
    (0..count)
        .map(|k| {
            let angle = step * k as f64;
            PvPoint { angle, volume: volume.at(angle)[0], pressure: pressure.at(angle) }
        })
        .collect()
}

/// Widest interval of the rule [rad].
const WIDEST: f64 = 0.1;
