//! What became of the cases: none is lost without a reason.

use serde::{Deserialize, Serialize};

/// Why a case of the space is no engine.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Invalid {
    /// The rod is not longer than the crank radius: a rod ratio of 1 or more.
    RodTooShort,
    /// The webs of neighbouring groups overlap: the spacing is less than web distance and web thickness.
    WebsOverlap,
    /// The bores of neighbouring cylinders of a bank overlap: the spacing is less than the bore.
    BoresOverlap,
}

impl Invalid {
    /// The reason in words.
    pub fn text(self) -> &'static str {
        match self {
            Invalid::RodTooShort => "the rod is not longer than the crank radius",
            Invalid::WebsOverlap => "the webs of neighbouring throws overlap",
            Invalid::BoresOverlap => "neighbouring bores overlap",
        }
    }
}

/// Cases of invalid geometry for one reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct InvalidCount {
    /// The reason.
    pub reason: Invalid,
    /// Cases.
    pub cases: u128,
}

/// Cases that broke one constraint.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Broken {
    /// The constraint in words, as in the request.
    pub constraint: String,
    /// Cases for which it was the first that they broke. Constraints on sizes that many cases share are judged first,
    /// then those on the crank, then those on the firing; within these in the order of the request.
    pub cases: u128,
}

/// What became of the cases looked at: `cases` is the sum of all the others.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Counts {
    /// Cases looked at.
    pub cases: u128,
    /// No engine, by the first reason that holds; counted before duplicates are.
    pub invalid: Vec<InvalidCount>,
    /// Equivalent to a case of lower number by symmetry.
    pub duplicates: u128,
    /// By constraint, in the order of the request.
    pub broken: Vec<Broken>,
    /// Judged by the objectives.
    pub judged: u128,
}

impl Counts {
    /// Nothing looked at yet.
    pub(crate) fn new(constraints: Vec<String>) -> Counts {
        let broken = constraints.into_iter().map(|constraint| Broken { constraint, cases: 0 }).collect();
        Counts { cases: 0, invalid: Vec::new(), duplicates: 0, broken, judged: 0 }
    }

    /// Counts cases of invalid geometry.
    pub(crate) fn add_invalid(&mut self, reason: Invalid, cases: u128) {
        self.cases += cases;
        match self.invalid.iter_mut().find(|count| count.reason == reason) {
            Some(count) => count.cases += cases,
            None => {
                self.invalid.push(InvalidCount { reason, cases });
                self.invalid.sort_by_key(|count| count.reason);
            }
        }
    }

    /// Adds what became of other cases.
    pub(crate) fn add(&mut self, other: &Counts) {
        for count in &other.invalid {
            self.add_invalid(count.reason, count.cases);
            self.cases -= count.cases;
        }
        self.cases += other.cases;
        self.duplicates += other.duplicates;
        self.judged += other.judged;
        for (own, other) in self.broken.iter_mut().zip(&other.broken) {
            own.cases += other.cases;
        }
    }

    /// Why nothing was judged, if nothing was: the reason that took the last case.
    pub fn emptied_by(&self) -> Option<String> {
        if self.judged > 0 || self.cases == 0 {
            return None;
        }
        let mut left = self.cases;
        for count in &self.invalid {
            left -= count.cases;
            if left == 0 {
                return Some(format!(
                    "none of the {} cases is an engine: {}",
                    self.cases,
                    count.reason.text()
                ));
            }
        }
        // Of the constraints, the one that most cases break first.
        let most = self.broken.iter().max_by_key(|broken| broken.cases)?;
        Some(format!(
            "no case is left: of {} cases that are engines, duplicates aside, {} break the constraint `{}`",
            left - self.duplicates,
            most.cases,
            most.constraint
        ))
    }
}
