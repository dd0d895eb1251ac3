//! Smooth functions as cubic pieces, as fine as a bound on their error asks for.

use crate::error::CycleError;
use lanchester_results::{End, PeriodicCurve};

/// Largest error of a piece at its middle, over its value.
const ERROR: f64 = 1e-11;
/// Widest piece [rad].
const WIDEST: f64 = 0.2;
/// Halvings of a piece, at most.
const DEEPEST: u32 = 12;

/// A periodic curve as it is put together, from angle 0 on.
#[derive(Debug, Default)]
pub(crate) struct Pieces {
    knots: Vec<f64>,
    ends: Vec<[End; 2]>,
}

impl Pieces {
    /// Goes on from `from` to `to` with a smooth function: its value and slope at an angle.
    pub(crate) fn smooth(&mut self, from: f64, to: f64, function: &dyn Fn(f64) -> End) {
        let count = ((to - from) / WIDEST).ceil().max(1.0);
        let step = (to - from) / count;
        let mut start = (from, function(from));
        for k in 1..=count as u32 {
            let at = if f64::from(k) == count { to } else { from + step * f64::from(k) };
            let end = (at, function(at));
            self.halve(start, end, function, 0);
            start = end;
        }
    }

    fn halve(&mut self, from: (f64, End), to: (f64, End), function: &dyn Fn(f64) -> End, depth: u32) {
        let width = to.0 - from.0;
        let middle = from.0 + width / 2.0;
        let exact = function(middle);
        let cubic = (from.1.value + to.1.value) / 2.0 + width * (from.1.slope - to.1.slope) / 8.0;
        if (cubic - exact.value).abs() <= ERROR * exact.value.abs() || depth == DEEPEST {
            self.knots.push(from.0);
            self.ends.push([from.1, to.1]);
        } else {
            self.halve(from, (middle, exact), function, depth + 1);
            self.halve((middle, exact), to, function, depth + 1);
        }
    }

    /// Goes on with one value.
    pub(crate) fn constant(&mut self, from: f64, value: f64) {
        let end = End { value, slope: 0.0 };
        self.knots.push(from);
        self.ends.push([end, end]);
    }

    pub(crate) fn curve(self, period: f64) -> Result<PeriodicCurve, CycleError> {
        Ok(PeriodicCurve::from_ends(period, self.knots, &self.ends)?)
    }
}
