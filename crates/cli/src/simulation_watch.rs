//! A run that Ctrl-C ends with the samples so far.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Exit status of a program that Ctrl-C has ended.
const INTERRUPTED: i32 = 130;

/// Whether the run goes on.
pub struct GoesOn(Arc<AtomicBool>);

impl GoesOn {
    /// Hears Ctrl-C from now on: the first one ends the run, the second one the program.
    pub fn until_interrupted() -> GoesOn {
        let goes_on = Arc::new(AtomicBool::new(true));
        let heard = Arc::clone(&goes_on);
        // Where signals cannot be heard, Ctrl-C ends the program as it does everywhere.
        let _ = ctrlc::set_handler(move || {
            if !heard.swap(false, Ordering::Relaxed) {
                std::process::exit(INTERRUPTED);
            }
            eprintln!("stopping with what there is so far; Ctrl-C again ends at once");
        });
        GoesOn(goes_on)
    }

    pub fn now(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
