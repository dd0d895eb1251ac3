//! Tables and films that were computed before.

use lanchester_film::{FilmTable, OrbitOutcome};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Tables and films that were computed before.
#[derive(Default)]
pub(super) struct FilmMemory {
    pub tables: Mutex<Vec<Arc<FilmTable>>>,
    /// Least film with viscosity and outcome, by everything that it depends on.
    pub films: Mutex<HashMap<u64, (f64, f64, OrbitOutcome)>>,
    /// Viscosity that a bearing has at a speed, where engines differ in weights alone.
    pub viscosities: Mutex<HashMap<(bool, usize, usize, u64), f64>>,
}

/// What a mutex holds, whoever panicked with it.
pub(super) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
