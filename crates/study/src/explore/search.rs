//! The search through stretches of cases, on one thread or on all.

use crate::explore::error::ExploreError;
use crate::explore::explorer::{Exploration, Explorer, Run};
use crate::explore::front::{Front, Ranking};
use crate::explore::sample::Sample;
use crate::explore::walk::{Found, Walk};
use rayon::prelude::*;

/// Cases that one thread looks at in one go.
const STRETCH: u128 = 1 << 15;

/// Stretches that are held at a time.
const STRETCHES: u128 = 64;

impl Explorer {
    /// Looks at a stretch of cases, on all threads of the current pool; the result does not depend on their number, nor
    /// on how the cases are cut into stretches.
    ///
    /// # Errors
    /// [`ExploreError`] where the stretch lies outside the space or was looked at before, or the front grows too large; the
    /// exploration is as before then.
    pub fn run(&self, exploration: &mut Exploration, run: Run) -> Result<(), ExploreError> {
        if run.to > self.size() {
            return Err(ExploreError::NoSuchCase { last: self.size() - 1, got: run.to - 1 });
        }
        let mut grown = exploration.clone();
        grown.mark(run)?;
        let mut front = Front::of(std::mem::take(&mut grown.front));
        let mut ranking = Ranking::of(std::mem::take(&mut grown.ranking), self.request.most_listed);
        let mut sample = Sample::of(std::mem::take(&mut grown.sample));
        let mut from = run.from;
        while from < run.to {
            let to = run.to.min(from + STRETCH * STRETCHES);
            let stretches = u64::try_from((to - from).div_ceil(STRETCH)).expect("invariant: a few stretches");
            let found: Vec<Result<Found, ExploreError>> = (0..stretches)
                .into_par_iter()
                .map(|k| {
                    let start = from + u128::from(k) * STRETCH;
                    Walk::new(self, &mut |_, _| ()).run(start, to.min(start + STRETCH))
                })
                .collect();
            for found in found {
                let found = found?;
                grown.counts.add(&found.counts);
                front.merge(found.front, self.request.most_on_front)?;
                ranking.merge(found.ranking);
                sample.merge(found.sample);
            }
            from = to;
        }
        (grown.front, grown.ranking) = (front.sorted(), ranking.into_candidates());
        grown.sample = sample.into_cases();
        *exploration = grown;
        Ok(())
    }

    /// Looks at a stretch of cases on the calling thread alone; `judged` gets every case that is judged, with its
    /// objectives, in rising order. Stretches merge ([`Explorer::merge`]) to what [`Explorer::run`] finds.
    ///
    /// # Errors
    /// [`ExploreError`] where the stretch lies outside the space, or the front grows too large.
    pub fn look(&self, run: Run, judged: &mut dyn FnMut(u128, &[f64])) -> Result<Exploration, ExploreError> {
        if run.to > self.size() {
            return Err(ExploreError::NoSuchCase { last: self.size() - 1, got: run.to - 1 });
        }
        let mut exploration = self.start();
        exploration.mark(run)?;
        let found = Walk::new(self, judged).run(run.from, run.to)?;
        exploration.counts = found.counts;
        (exploration.front, exploration.ranking) = (found.front, found.ranking);
        exploration.sample = found.sample;
        Ok(exploration)
    }

    /// The whole search at once.
    ///
    /// # Errors
    /// As [`Explorer::run`].
    pub fn explore(&self) -> Result<Exploration, ExploreError> {
        let mut exploration = self.start();
        self.run(&mut exploration, Run { from: 0, to: self.size() })?;
        Ok(exploration)
    }
}
