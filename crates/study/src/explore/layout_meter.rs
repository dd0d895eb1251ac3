//! Whoever tells films and safeties of layouts.

use lanchester_task::DurabilityMeter;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Whoever tells films and safeties of layouts as engines, and how many it has told.
#[derive(Clone)]
pub struct LayoutMeter {
    pub(crate) meter: Arc<dyn DurabilityMeter + Send + Sync>,
    measured: Arc<AtomicU64>,
    most: u64,
}

impl LayoutMeter {
    /// Counts one more layout; the most where that is one too many.
    pub(crate) fn count(&self) -> Result<(), u64> {
        match self.measured.fetch_add(1, Ordering::Relaxed) {
            before if before >= self.most => Err(self.most),
            _ => Ok(()),
        }
    }

    /// One that tells at most so many layouts.
    pub fn new(meter: Arc<dyn DurabilityMeter + Send + Sync>, most: u64) -> LayoutMeter {
        LayoutMeter { meter, measured: Arc::default(), most }
    }

    /// Layouts that were measured.
    pub fn measured(&self) -> u64 {
        self.measured.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for LayoutMeter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LayoutMeter").field("most", &self.most).finish_non_exhaustive()
    }
}

impl PartialEq for LayoutMeter {
    /// Whether both are the same one.
    fn eq(&self, other: &LayoutMeter) -> bool {
        Arc::ptr_eq(&self.meter, &other.meter)
    }
}
