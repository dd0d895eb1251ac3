//! Two quantities compared, in per cent.

use crate::case::Run;
use crate::quantity::Key;
use crate::source::Comparison;

/// A quantity and the run that it is taken from.
pub(crate) type Comparable<'a> = (&'a Key, &'a Run);

impl Comparison {
    /// Value against reference [%].
    pub fn of(self, value: Comparable, reference: Comparable) -> Result<f64, String> {
        if let Comparison::MeanError = self {
            let (value, reference) = (value.0.trace_of(value.1)?, reference.0.trace_of(reference.1)?);
            let errors = value.iter().zip(&reference).map(|(v, r)| ((v - r) / r).abs());
            return Ok(100.0 * errors.sum::<f64>() / reference.len() as f64);
        }
        let (value, reference) = (value.0.number_of(value.1)?, reference.0.number_of(reference.1)?);
        /// Forces [N] and couples [N m] below this vanish: where both do, they stay as they are, 0 %, as tables print it.
        const VANISHING: f64 = 1e-6;
        let both_vanish = value.abs() < VANISHING && reference.abs() < VANISHING;
        let increase = if both_vanish { 0.0 } else { 100.0 * (value / reference - 1.0) };
        Ok(match self {
            Comparison::Increase => increase,
            Comparison::Decrease => -increase,
            Comparison::Error | Comparison::MeanError => increase.abs(),
            Comparison::Ratio => increase + 100.0,
        })
    }
}
