//! Who asked, and whether they still wait for the answer.

use crate::lanes::Place;
use crate::state::Studio;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a question has from the one who asks it.
pub(crate) struct Asker {
    pub(crate) studio: Arc<Studio>,
    /// Its place among the questions of its lane, if it has a lane.
    place: Option<Place>,
    gone: Arc<AtomicBool>,
}

/// Held while the answer is waited for: the server drops it when the connection is closed.
pub(crate) struct Waiting(Arc<AtomicBool>);

impl Asker {
    pub(crate) fn new(studio: Arc<Studio>, place: Option<Place>) -> (Asker, Waiting) {
        let gone = Arc::new(AtomicBool::new(false));
        (Asker { studio, place, gone: gone.clone() }, Waiting(gone))
    }

    /// Whether no newer question took the place of this one, and the window is still there.
    pub(crate) fn waits(&self) -> bool {
        let is_newest = self.place.as_ref().is_none_or(|place| self.studio.lanes.is_newest(place));
        is_newest && !self.gone.load(Ordering::Relaxed)
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
