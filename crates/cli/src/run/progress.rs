//! A bar on standard error with rate and remaining time; nothing where that is no terminal.

use indicatif::{HumanCount, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::time::Duration;

/// Cases that are done.
pub struct Progress(ProgressBar);

impl Progress {
    /// Of so many cases, so many of which are done already.
    pub fn new(cases: u128, done: u128) -> Progress {
        let done = count(done);
        // What an earlier run did tells nothing of the speed of this one.
        let rate = move |state: &ProgressState| {
            let seconds = state.elapsed().as_secs_f64();
            (seconds > 0.0).then(|| state.pos().saturating_sub(done) as f64 / seconds)
        };
        let show_rate = move |state: &ProgressState, out: &mut dyn Write| {
            let _ = write!(out, "{} a second", HumanCount(rate(state).unwrap_or(0.0) as u64));
        };
        let show_rest = move |state: &ProgressState, out: &mut dyn Write| {
            let rest = state.len().unwrap_or(0).saturating_sub(state.pos()) as f64;
            let left = rate(state).filter(|rate| *rate > 0.0).map(|rate| rest / rate);
            let _ = match left.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()) {
                Some(left) => write!(out, "{} left", HumanDuration(left)),
                None => Ok(()),
            };
        };
        let bar = ProgressBar::with_draw_target(Some(count(cases)), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template(
            "{bar:32} {percent:>3} %  {human_pos} of {human_len} cases, {rate}, {rest}",
        );
        bar.set_style(
            style
                .unwrap_or_else(|_| ProgressStyle::default_bar())
                .with_key("rate", show_rate)
                .with_key("rest", show_rest),
        );
        Progress(bar.with_position(done))
    }

    /// So many are done.
    pub fn at(&self, cases: u128) {
        self.0.set_position(count(cases));
    }

    /// Says something without disturbing the bar.
    pub fn say(&self, words: &str) {
        self.0.suspend(|| eprintln!("{words}"));
    }

    /// Takes the bar away.
    pub fn done(&self) {
        self.0.finish_and_clear();
    }
}

fn count(cases: u128) -> u64 {
    u64::try_from(cases).unwrap_or(u64::MAX)
}
