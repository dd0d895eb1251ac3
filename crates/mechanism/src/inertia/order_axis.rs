//! Which orders an engine has.

use lanchester_model::{Engine, Ratio};
use std::collections::BTreeSet;

/// Highest harmonic of a slow crankshaft that is listed.
const MAX_HARMONIC: usize = 1000;

/// The orders of an engine: all whole ones, and the fractions that its geared crankshafts and shafts bring.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OrderAxis {
    /// Orders times `revolutions`, rising.
    keys: Vec<u64>,
    /// Revolutions of crankshaft 1 in one period.
    revolutions: u32,
    /// Highest order.
    max_order: u32,
}

impl OrderAxis {
    /// Orders 0 to `max_order` of `engine`.
    pub fn of(engine: &Engine, revolutions: u32, max_order: u32) -> OrderAxis {
        let mut axis = OrderAxis { keys: Vec::new(), revolutions, max_order };
        let whole = (0..=max_order).map(|n| u64::from(n) * u64::from(revolutions));
        let mut keys: BTreeSet<u64> = whole.collect();
        for crankshaft in &engine.crankshafts {
            for n in 1..=axis.highest(crankshaft.ratio) {
                keys.insert(axis.key(crankshaft.ratio, n));
            }
        }
        for shaft in engine.shafts.iter().filter(|s| axis.highest(s.ratio) >= 1) {
            keys.insert(axis.key(shaft.ratio, 1));
        }
        axis.keys = keys.into_iter().collect();
        axis
    }

    /// Harmonic `n` of a shaft as a key.
    fn key(&self, ratio: Ratio, n: usize) -> u64 {
        let each =
            u64::from(ratio.numerator().unsigned_abs()) * u64::from(self.revolutions / ratio.denominator());
        n as u64 * each
    }

    /// Highest harmonic of a shaft that is listed.
    pub fn highest(&self, ratio: Ratio) -> usize {
        let limit = u64::from(self.max_order) * u64::from(self.revolutions);
        ((limit / self.key(ratio, 1)) as usize).min(MAX_HARMONIC)
    }

    /// Place of harmonic `n` of a shaft in the list.
    pub fn place(&self, ratio: Ratio, n: usize) -> usize {
        self.keys.binary_search(&self.key(ratio, n)).expect("invariant: every listed harmonic has its order")
    }

    /// The orders.
    pub fn orders(&self) -> impl ExactSizeIterator<Item = f64> {
        self.keys.iter().map(|&key| key as f64 / f64::from(self.revolutions))
    }
}
