//! A search that is watched: progress on standard error, the time limit, Ctrl-C.
//!
//! Nothing is said in the first two seconds. After them a terminal has a line that changes; anything else has a line after 2, 4, 8,
//! .. seconds and then every minute. The first Ctrl-C ends the search with the best so far, the second one the program.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lanchester::balance::{BalanceSettings, Next, SearchState, StopCause};
use lanchester::model::Engine;
use lanchester::report::search_state_words;
use std::cell::{Cell, OnceCell};
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::time::Instant;

/// Seconds before anything is said.
const SILENCE: f64 = 2.0;

/// Longest time between two lines where standard error is no terminal, and the time between two changes where it is one [s].
const MOST_BETWEEN: f64 = 60.0;
const BETWEEN_CHANGES: f64 = 0.2;

/// Exit status of a program that Ctrl-C has ended.
const INTERRUPTED: i32 = 130;

/// What Ctrl-C finds.
const SEARCHING: u8 = 0;
const STOPPING: u8 = 1;
const OVER: u8 = 2;

/// Watches one search.
pub struct Watch<'a> {
    engine: &'a Engine,
    settings: BalanceSettings,
    began: Instant,
    phase: Arc<AtomicU8>,
    /// When something was said last [s].
    said: Cell<Option<f64>>,
    is_terminal: bool,
    line: OnceCell<ProgressBar>,
}

impl<'a> Watch<'a> {
    pub fn new(engine: &'a Engine, settings: BalanceSettings) -> Watch<'a> {
        let phase = Arc::new(AtomicU8::new(SEARCHING));
        let heard = Arc::clone(&phase);
        // Where signals cannot be heard, Ctrl-C ends the program as it does everywhere.
        let _ = ctrlc::set_handler(move || {
            if heard.compare_exchange(SEARCHING, STOPPING, Ordering::Relaxed, Ordering::Relaxed).is_err() {
                std::process::exit(INTERRUPTED);
            }
            eprintln!("stopping with the best so far; Ctrl-C again ends at once");
        });
        let is_terminal = std::io::stderr().is_terminal();
        Watch {
            engine,
            settings,
            began: Instant::now(),
            phase,
            said: Cell::new(None),
            is_terminal,
            line: OnceCell::new(),
        }
    }

    /// What the search does next.
    pub fn look(&self, state: &SearchState) -> Next {
        if self.phase.load(Ordering::Relaxed) == STOPPING {
            return Next::Stop(StopCause::Cancelled);
        }
        let elapsed = self.began.elapsed().as_secs_f64();
        if is_due(elapsed, self.said.get(), self.is_terminal) {
            self.said.set(Some(elapsed));
            self.say(&search_state_words(self.engine, state));
        }
        self.settings.next(elapsed)
    }

    /// What a search for films and safeties does after so many engines.
    pub fn look_at_films(&self, engines: usize) -> Next {
        if self.phase.load(Ordering::Relaxed) == STOPPING {
            return Next::Stop(StopCause::Cancelled);
        }
        let elapsed = self.began.elapsed().as_secs_f64();
        if is_due(elapsed, self.said.get(), self.is_terminal) {
            self.said.set(Some(elapsed));
            self.say(&format!("oil films and safeties of {engines} engines"));
        }
        self.settings.next(elapsed)
    }

    fn say(&self, words: &str) {
        if !self.is_terminal {
            eprintln!("{words}");
            return;
        }
        let line = self.line.get_or_init(|| {
            let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{spinner} {msg}, {elapsed} (Ctrl-C: the best so far)");
            line.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
                .with_elapsed(self.began.elapsed())
        });
        line.set_message(words.to_owned());
        line.tick();
    }
}

impl Drop for Watch<'_> {
    /// The search is over: the line goes, and Ctrl-C ends the program again.
    fn drop(&mut self) {
        self.phase.store(OVER, Ordering::Relaxed);
        if let Some(line) = self.line.get() {
            line.finish_and_clear();
        }
    }
}

/// Whether something is said after `elapsed` seconds, if something was said last after `said`.
pub(crate) fn is_due(elapsed: f64, said: Option<f64>, is_terminal: bool) -> bool {
    // What is late by rounding is not late.
    let elapsed = elapsed + 1e-9;
    match said {
        None => elapsed >= SILENCE,
        Some(said) if is_terminal => elapsed >= said + BETWEEN_CHANGES,
        Some(said) => elapsed >= said + said.min(MOST_BETWEEN),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds at which something is said in so many, looked at ten times a second.
    fn lines(seconds: u32, is_terminal: bool) -> Vec<f64> {
        let mut said = Vec::new();
        for tenth in 0..=10 * seconds {
            let elapsed = f64::from(tenth) / 10.0;
            if is_due(elapsed, said.last().copied(), is_terminal) {
                said.push(elapsed);
            }
        }
        said
    }

    #[test]
    fn two_seconds_of_silence_then_now_and_then() {
        assert!(lines(1, true).is_empty() && lines(1, false).is_empty());
        assert_eq!(lines(200, false), [2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 124.0, 184.0]);
        assert_eq!(lines(3, true)[..3], [2.0, 2.2, 2.4].map(|at: f64| (at * 10.0).round() / 10.0));
    }
}
