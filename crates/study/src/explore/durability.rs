//! Films and safeties of layouts: told for those that would be found, since each costs as much as a million layouts.

use crate::explore::error::ExploreError;
use crate::explore::explorer::Explorer;
use crate::explore::layout_meter::LayoutMeter;
use lanchester_task::{AtLeast, DurabilityCriterion, Measured};

impl Explorer {
    /// The same search with somebody who tells films and safeties.
    pub fn with_meter(mut self, meter: LayoutMeter) -> Explorer {
        self.meter = Some(meter);
        self
    }

    /// Layouts whose films and safeties were computed.
    pub fn measured_layouts(&self) -> u64 {
        self.meter.as_ref().map_or(0, LayoutMeter::measured)
    }

    /// Films and safeties of a case.
    ///
    /// # Errors
    /// [`ExploreError::TooManyMeasured`] beyond the most that may be measured, [`ExploreError::NoMeter`] where nobody can tell them.
    pub fn durability(
        &self,
        case: u128,
        criteria: &[DurabilityCriterion],
    ) -> Result<Vec<Measured>, ExploreError> {
        let Some(own) = &self.meter else { return Err(ExploreError::NoMeter) };
        own.count().map_err(|most| ExploreError::TooManyMeasured { most })?;
        let engine = self.layout(case)?.engine(&self.request.space.parts)?;
        Ok(own.meter.measure(&engine, criteria))
    }

    /// Whether a case holds these limits; what is not known does not.
    pub(crate) fn is_durable(&self, case: u128, limits: &[AtLeast]) -> Result<bool, ExploreError> {
        let criteria: Vec<DurabilityCriterion> = limits.iter().map(|limit| limit.criterion).collect();
        let measured = self.durability(case, &criteria)?;
        Ok(measured
            .iter()
            .zip(limits)
            .all(|(one, limit)| one.value().is_some_and(|value| value >= limit.least)))
    }
}
