//! Who asked, and whether they still wait for the answer.

use crate::state::Studio;

/// What a question has from the one who asks it.
pub struct Asker<'a> {
    pub(crate) studio: &'a Studio,
    waits: &'a dyn Fn() -> bool,
}

impl<'a> Asker<'a> {
    /// One who waits as long as `waits` says so.
    pub fn new(studio: &'a Studio, waits: &'a dyn Fn() -> bool) -> Asker<'a> {
        Asker { studio, waits }
    }

    /// Whether no newer question took the place of this one, and the window is still there.
    pub fn waits(&self) -> bool {
        (self.waits)()
    }
}
