//! The periodic motion where the past is part of the state: what a governor with a dead time has commanded, and has not reached the gas yet.
//!
//! Over so many periods that none of the past is left, the state at the start alone says where the motion goes: the change over the last of them is a function
//! of it. Fast motions die out in that time by themselves; Newton corrects the slow ones, such as those of the governor's integral, along which that change
//! says enough.

use super::search::{CLOSED, HELPS, IDLE, ITERATIONS, SHARE, Search};
use crate::powered::History;
use nalgebra::{DMatrix, DVector};

/// What changes by less than this share over the periods has died out: it is left to the motion.
const DIED_OUT: f64 = 1e-3;

/// Half the periods for which a departure is followed, beyond those of the past.
const LOOKED_AT: usize = 60;

/// Where a motion comes to in some periods.
struct Ahead {
    end: DVector<f64>,
    /// Change over the last period.
    change: DVector<f64>,
    /// Largest change over any of them, over the size of its kind of state.
    off: f64,
}

impl Search<'_> {
    /// Follows the motion from `x` and the past at hand, which becomes that of the end.
    fn ahead(&mut self, x: &DVector<f64>, periods: usize) -> Option<Ahead> {
        let mut found = Ahead { end: x.clone(), change: x.clone(), off: 0.0 };
        for _ in 0..periods {
            found.change = self.change(&found.end)?;
            found.end += &found.change;
            found.off = found.off.max(self.off(&found.change));
            self.keep_past();
        }
        Some(found)
    }

    /// Newton's steps from `x` and the past at hand, which become the best ones.
    pub(super) fn newton_with_past(&mut self, x: &mut DVector<f64>) {
        let periods = self.periods_of_past() + 1;
        let mut slope: Option<DMatrix<f64>> = None;
        let mut best = (f64::INFINITY, x.clone(), self.past.clone());
        let mut idle = 0;
        for _ in 0..ITERATIONS {
            let past = self.past.clone();
            let Some(plain) = self.ahead(x, periods) else { break };
            let followed = self.past.take();
            idle = if plain.off < 0.5 * best.0 { 0 } else { idle + 1 };
            if plain.off < best.0 {
                best = (plain.off, x.clone(), past.clone());
            }
            if plain.off < CLOSED || idle >= IDLE {
                break;
            }
            if slope.is_none() {
                slope = self.slope_ahead(x, &past, &plain.change, periods);
            }
            let step = slope.as_ref().and_then(|slope| self.step_above(slope, &plain.change, DIED_OUT));
            let Some(step) = step else { break };
            self.iterations += 1;
            self.past = past;
            let beside = &*x + self.bounded(step, x);
            match self.ahead(&beside, periods).map(|found| (self.off(&found.change), found.end)) {
                Some((off, end)) if off < self.off(&plain.change) => {
                    if off > HELPS * self.off(&plain.change) {
                        slope = None;
                    }
                    *x = end;
                }
                _ => {
                    (*x, self.past) = (plain.end, followed);
                    slope = None;
                }
            }
        }
        (self.residual, *x, self.past) = best;
    }

    /// Derivative of the change over the last of `periods` by the state at their start, with the same past.
    fn slope_ahead(
        &mut self,
        x: &DVector<f64>,
        past: &Option<History>,
        change: &DVector<f64>,
        periods: usize,
    ) -> Option<DMatrix<f64>> {
        let mut matrix = DMatrix::zeros(x.len(), x.len());
        for k in 0..x.len() {
            let step = SHARE * self.sizes[k];
            let mut beside = x.clone();
            beside[k] += step;
            self.past.clone_from(past);
            let found = self.ahead(&beside, periods)?;
            matrix.set_column(k, &((found.change - change) / step));
        }
        Some(matrix)
    }

    /// Whether a small departure from the motion at `x` dies out: whether it is less in the second half of the time for which it is followed.
    pub(super) fn dies_out(&mut self, x: &DVector<f64>) -> bool {
        let past = self.past.clone();
        let mut place = DVector::from_fn(x.len(), |k, _| x[k] + SHARE * self.sizes[k]);
        let mut largest = [0.0f64; 2];
        let half = LOOKED_AT + self.periods_of_past();
        for period in 0..2 * half {
            let Some(found) = self.ahead(&place, 1) else {
                largest[1] = f64::INFINITY;
                break;
            };
            place = found.end;
            let own = &mut largest[period / half];
            *own = own.max(self.off(&(&place - x)));
        }
        self.past = past;
        largest[1] < largest[0]
    }
}
