//! A run that Ctrl-C ends with the samples so far.

use std::sync::atomic::{AtomicBool, Ordering};

/// Exit status of a program that Ctrl-C has ended.
const INTERRUPTED: i32 = 130;

/// Whether Ctrl-C was heard.
static HEARD: AtomicBool = AtomicBool::new(false);

/// A run that Ctrl-C ends.
pub struct Interruptible(());

impl Interruptible {
    /// Hears Ctrl-C from now on: the first one ends the run, the second one the program.
    pub fn listening() -> Interruptible {
        // Where signals cannot be heard, Ctrl-C ends the program as it does everywhere.
        let _ = ctrlc::set_handler(|| {
            if HEARD.swap(true, Ordering::Relaxed) {
                std::process::exit(INTERRUPTED);
            }
            eprintln!("stopping with what there is so far; Ctrl-C again ends at once");
        });
        Interruptible(())
    }

    /// Whether the run goes on.
    pub fn goes_on(&self) -> bool {
        !HEARD.load(Ordering::Relaxed)
    }

    /// What is set where it does not.
    pub fn flag(&self) -> &'static AtomicBool {
        &HEARD
    }
}
