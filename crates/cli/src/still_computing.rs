//! A word on standard error from commands that compute for long and have no progress of their own.

use std::thread;
use std::time::Duration;

/// Seconds after which it is said first; then the waits double.
const FIRST: u64 = 8;

/// Says from time to time that `command` computes, until the program ends.
pub fn still_computing(command: &'static str) {
    // Without a thread nothing is said, and nothing else changes.
    let _ = thread::Builder::new().spawn(move || {
        let mut elapsed = 0;
        let mut wait = FIRST;
        loop {
            thread::sleep(Duration::from_secs(wait));
            elapsed += wait;
            eprintln!("{command}: still computing after {elapsed} s; Ctrl-C ends it");
            wait = elapsed;
        }
    });
}
