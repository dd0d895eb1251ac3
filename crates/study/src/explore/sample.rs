//! Some of the judged cases, evenly from all of them: the same in any cutting.
//!
//! Every case has a lot, a function of its number alone; those with the smallest lots are kept. Of a stretch and another the smallest
//! lots are those of the smallest lots of each.

use crate::scatter::stream::mixed;
use serde::{Deserialize, Serialize};

/// Cases that are kept.
const MOST: usize = 1500;

/// A judged case with its objectives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct JudgedCase {
    /// Its number in the space.
    pub case: u128,
    /// Its objectives in the order of the request, in SI units.
    pub values: Vec<f64>,
}

/// The lot of a case.
#[inline]
fn lot(case: u128) -> u64 {
    mixed(mixed((case >> 64) as u64) ^ case as u64)
}

/// Judged cases with the smallest lots, rising.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    /// The smallest lots so far, and some that came since they were counted.
    kept: Vec<(u64, JudgedCase)>,
    /// The largest lot that may still be kept.
    bar: u64,
}

impl Default for Sample {
    fn default() -> Sample {
        Sample { kept: Vec::new(), bar: u64::MAX }
    }
}

impl Sample {
    /// Of cases that were kept before.
    pub fn of(cases: Vec<JudgedCase>) -> Sample {
        let mut sample = Sample::default();
        sample.merge(cases);
        sample
    }

    fn cut(&mut self) {
        self.kept.sort_by_key(|(lot, own)| (*lot, own.case));
        self.kept.truncate(MOST);
        if let Some((lot, _)) = self.kept.get(MOST - 1) {
            self.bar = *lot;
        }
    }

    /// Offers a case.
    #[inline]
    pub fn offer(&mut self, case: u128, values: &[f64]) {
        let lot = lot(case);
        if lot > self.bar {
            return;
        }
        self.kept.push((lot, JudgedCase { case, values: values.to_vec() }));
        // As many wait as are kept, so that sorting is rare.
        if self.kept.len() == 2 * MOST {
            self.cut();
        }
    }

    /// Offers all of another sample.
    pub fn merge(&mut self, other: Vec<JudgedCase>) {
        self.kept.extend(other.into_iter().map(|own| (lot(own.case), own)));
        self.cut();
    }

    pub fn into_cases(mut self) -> Vec<JudgedCase> {
        self.cut();
        self.kept.into_iter().map(|(_, own)| own).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sample of a stretch of cases.
    fn sample(cases: std::ops::Range<u128>) -> Sample {
        let mut sample = Sample::default();
        cases.for_each(|case| sample.offer(case, &[case as f64]));
        sample
    }

    #[test]
    fn any_cutting_keeps_the_same_cases() {
        let whole = sample(0..50_000).into_cases();
        assert_eq!(whole.len(), MOST);
        let mut joined = sample(20_000..50_000);
        joined.merge(sample(0..700).into_cases());
        let mut joined = Sample::of(joined.into_cases());
        joined.merge(sample(700..20_000).into_cases());
        assert_eq!(joined.into_cases(), whole);
        // Evenly: each tenth of the cases has about a tenth of them, within five standard errors.
        for tenth in 0..10 {
            let own = whole.iter().filter(|own| own.case / 5000 == tenth).count() as f64;
            assert!((own - 150.0).abs() < 5.0 * (1500.0 * 0.1 * 0.9f64).sqrt(), "{tenth}: {own}");
        }
    }

    #[test]
    fn few_cases_are_all_kept() {
        let mut cases: Vec<u128> = sample(5..905).into_cases().iter().map(|own| own.case).collect();
        cases.sort_unstable();
        assert_eq!(cases, (5..905).collect::<Vec<_>>());
    }
}
