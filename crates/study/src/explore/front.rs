//! The Pareto front of cases, and the first of the ranking.
//!
//! One case beats another if it is no worse in every objective and better in one. Objectives are compared in whole
//! steps of their resolution, so that rounding decides nothing and "equal" is transitive: what is kept of a stretch of
//! cases merges with what is kept of another to what both would have given together, in any cutting and order.

use crate::explore::candidate::Candidate;
use crate::explore::error::ExploreError;
use std::cmp::Ordering;

/// Pareto-optimal cases. Of equal ones the lowest number is kept, with their count.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Front {
    candidates: Vec<Candidate>,
    /// Their steps once more, one after the other: what is gone through for every case.
    steps: Vec<i64>,
}

/// Whether `a` is no worse than `b` in every objective.
#[inline]
fn covers(a: &[i64], b: &[i64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b)
}

/// One more of an equal kind.
fn join(kept: &mut Candidate, case: u128, values: &[f64], alike: u128) {
    kept.alike += alike;
    if case < kept.case {
        kept.case = case;
        kept.values.copy_from_slice(values);
    }
}

impl Front {
    pub fn of(candidates: Vec<Candidate>) -> Front {
        let steps = candidates.iter().flat_map(|candidate| candidate.steps.iter().copied()).collect();
        Front { candidates, steps }
    }

    /// Whether a case of the front is better in one objective and no worse in any.
    pub fn covers(&self, steps: &[i64]) -> bool {
        self.steps.chunks_exact(steps.len()).any(|kept| covers(kept, steps) && kept != steps)
    }

    /// Offers a case.
    ///
    /// # Errors
    /// [`ExploreError::FrontTooLarge`] beyond `most`.
    pub fn offer(
        &mut self,
        case: u128,
        steps: &[i64],
        values: &[f64],
        alike: u128,
        most: usize,
    ) -> Result<(), ExploreError> {
        let width = steps.len();
        if let Some(place) = self.steps.chunks_exact(width).position(|kept| covers(kept, steps)) {
            if self.candidates[place].steps == steps {
                join(&mut self.candidates[place], case, values, alike);
            }
            // Who covers much stands in front: most cases are turned away by the first few.
            self.swap(place, place / 2, width);
            return Ok(());
        }
        let mut place = 0;
        while place < self.candidates.len() {
            if covers(steps, &self.steps[place * width..][..width]) {
                let last = self.candidates.len() - 1;
                self.swap(place, last, width);
                self.candidates.truncate(last);
                self.steps.truncate(last * width);
            } else {
                place += 1;
            }
        }
        if self.candidates.len() == most {
            return Err(ExploreError::FrontTooLarge { most });
        }
        self.candidates.push(Candidate { case, values: values.to_vec(), steps: steps.to_vec(), alike });
        self.steps.extend_from_slice(steps);
        Ok(())
    }

    fn swap(&mut self, a: usize, b: usize, width: usize) {
        self.candidates.swap(a, b);
        for k in 0..width {
            self.steps.swap(a * width + k, b * width + k);
        }
    }

    /// The front by objectives, the first one first.
    pub fn sorted(mut self) -> Vec<Candidate> {
        self.candidates.sort_by(|a, b| a.steps.cmp(&b.steps));
        self.candidates
    }

    /// Offers all of another front.
    pub fn merge(&mut self, other: Vec<Candidate>, most: usize) -> Result<(), ExploreError> {
        other.iter().try_for_each(|c| self.offer(c.case, &c.steps, &c.values, c.alike, most))
    }
}

/// The first few kinds of case by their objectives, the first objective counting most.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ranking {
    /// Rising.
    candidates: Vec<Candidate>,
    most: usize,
}

impl Ranking {
    pub fn of(candidates: Vec<Candidate>, most: usize) -> Ranking {
        Ranking { candidates, most }
    }

    /// Offers a case.
    pub fn offer(&mut self, case: u128, steps: &[i64], values: &[f64], alike: u128) {
        if self.candidates.len() == self.most
            && self.candidates.last().is_none_or(|last| last.steps.as_slice() < steps)
        {
            return;
        }
        let place =
            self.candidates.partition_point(|kept| kept.steps.as_slice().cmp(steps) == Ordering::Less);
        match self.candidates.get_mut(place) {
            Some(kept) if kept.steps == steps => join(kept, case, values, alike),
            _ => {
                let candidate = Candidate { case, values: values.to_vec(), steps: steps.to_vec(), alike };
                self.candidates.insert(place, candidate);
                self.candidates.truncate(self.most);
            }
        }
    }

    /// Offers all of another ranking.
    pub fn merge(&mut self, other: Vec<Candidate>) {
        other.iter().for_each(|c| self.offer(c.case, &c.steps, &c.values, c.alike));
    }

    /// Whether a case would be among the first.
    pub fn takes(&self, steps: &[i64]) -> bool {
        self.candidates.len() < self.most
            || self.candidates.last().is_some_and(|last| last.steps.as_slice() >= steps)
    }

    pub fn into_candidates(self) -> Vec<Candidate> {
        self.candidates
    }
}
