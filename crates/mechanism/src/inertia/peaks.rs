//! Extremes of every quantity of a load set.

use crate::curves::extremes::{grid_extremes, refined_extremes};
use crate::inertia::point::Point;
use crate::inertia::request::PeakMode;
use crate::train::mechanism::Mechanism;
use lanchester_results::{Extreme, Extremes};
use lanchester_results::{Peaks, Trace};

/// Angles in a revolution of the grid that is refined, at least.
const SCAN: usize = 720;

/// Most angles of the refined grid in one period: reached only where a linkage nearly locks.
const MAX_SCAN: usize = 1 << 17;

/// Below this share of the scale a quantity counts as vanishing: what is left is rounding.
const VANISHING: f64 = 1e-9;

/// What loads of an engine are measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    /// All masses at their largest acceleration [N].
    pub force: f64,
    /// That force at the largest lever of the engine [N m].
    pub moment: f64,
}

/// A quantity of the peaks: its value, and what has the roots and signs of its derivative.
type Quantity = fn(&Point) -> (f64, f64);

/// `|a + i b|` and half the derivative of its square: it has the roots and signs of the derivative proper, but stays
/// smooth where the resultant passes through zero.
fn resultant(a: f64, b: f64, slope_a: f64, slope_b: f64) -> (f64, f64) {
    (a.hypot(b), a * slope_a + b * slope_b)
}

impl Mechanism {
    /// Extremes of all quantities; `trace` is that of the load set.
    pub(crate) fn peaks(&self, trace: &Trace, mode: PeakMode, resolution: usize, scale: Scale) -> Peaks {
        let per_revolution = match mode {
            PeakMode::Continuous => resolution,
            PeakMode::Grid(count) => count,
        };
        let count = per_revolution * self.revolutions as usize;
        let own;
        let grid = if trace.theta.len() == count {
            trace
        } else {
            own = self.trace(per_revolution);
            &own
        };
        let find = |values: &[f64], scale: f64, quantity: Quantity| -> Extremes {
            let on_grid = grid_extremes(values, self.period());
            if on_grid.max_abs() <= VANISHING * scale {
                let still = |extreme: Extreme| Extreme { theta: 0.0, ..extreme };
                return Extremes { max: still(on_grid.max), min: still(on_grid.min) };
            }
            match mode {
                PeakMode::Grid(_) => on_grid,
                PeakMode::Continuous => {
                    refined_extremes(values, self.period(), |theta| quantity(&self.point(theta)))
                }
            }
        };
        let sizes = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a.hypot(*b)).collect::<Vec<_>>();
        Peaks {
            force_x: find(&grid.force_x, scale.force, |p| (p.value.force_x, p.slope.force_x)),
            force_y: find(&grid.force_y, scale.force, |p| (p.value.force_y, p.slope.force_y)),
            force: find(&sizes(&grid.force_x, &grid.force_y), scale.force, |p| {
                resultant(p.value.force_x, p.value.force_y, p.slope.force_x, p.slope.force_y)
            }),
            couple_x: find(&grid.couple_x, scale.moment, |p| (p.value.couple_x, p.slope.couple_x)),
            couple_y: find(&grid.couple_y, scale.moment, |p| (p.value.couple_y, p.slope.couple_y)),
            couple: find(&sizes(&grid.couple_x, &grid.couple_y), scale.moment, |p| {
                resultant(p.value.couple_x, p.value.couple_y, p.slope.couple_x, p.slope.couple_y)
            }),
            roll_moment: find(&grid.roll_moment, scale.moment, |p| {
                (p.value.roll_moment, p.slope.roll_moment)
            }),
            shaft_torque: find(&grid.shaft_torque, scale.moment, |p| {
                (p.value.shaft_torque, p.slope.shaft_torque)
            }),
        }
    }

    /// Angles in a revolution of crankshaft 1 that resolve the loads well enough to find every extreme.
    pub(crate) fn resolution(&self) -> usize {
        let rotors = self.rotors.iter().map(|r| 64.0 * r.ratio.value().abs());
        let pistons = self.pistons.iter().map(|p| {
            let margin = p.analytic_margin;
            p.ratio.value().abs() * (64.0f64).max(8.0 * std::f64::consts::TAU / margin)
        });
        let needed = rotors.chain(pistons).fold(SCAN as f64, f64::max).ceil();
        (needed as usize).min(MAX_SCAN / self.revolutions as usize).max(SCAN)
    }

    /// What the loads of this engine are measured against.
    pub(crate) fn scale(&self) -> Scale {
        let rotors = self.rotors.iter().map(|r| (r.force.norm(), r.couple.norm() + r.roll.norm()));
        let pistons = self.pistons.iter().map(|p| {
            let r = p.crank_radius;
            let knuckle = p
                .knuckle
                .as_ref()
                .map_or((0.0, 0.0), |k| (k.mass * r, (k.couple.norm() + k.roll.norm() + k.mass * r) * r));
            let moment = (p.couple.norm() + p.roll.abs() + p.mass * r) * r + p.inertia.abs();
            (p.mass * r + knuckle.0, moment + knuckle.1)
        });
        let sum = rotors.chain(pistons).fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
        Scale { force: sum.0, moment: sum.1 }
    }
}
