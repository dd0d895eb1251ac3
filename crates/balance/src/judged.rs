//! A criterion as sums of groups of a convex programme.

use lanchester_task::Criterion;

/// A criterion in terms of the groups of a programme: `scale * SUM of share * level`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Judged {
    pub criterion: Criterion,
    /// Groups with their shares.
    pub groups: Vec<(usize, f64)>,
    /// Where the largest of several such sums counts: these, and the variable that none of them passes, which `groups` has.
    pub largest: Option<LargestSum>,
    /// What a level of 1 is in the criterion's unit.
    pub scale: f64,
    /// The criterion where all variables are 0.
    pub unbalanced: f64,
}

/// Sums of groups none of which passes a variable:
///
/// ```text
/// minimise u   with   SUM over j of w_j |F_s(theta_j)| <= u   for every speed s
/// ```
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LargestSum {
    pub variable: usize,
    pub sums: Vec<Vec<(usize, f64)>>,
}

impl Judged {
    /// The criterion at the levels of the groups, in its own unit.
    pub fn value(&self, level: impl Fn(usize) -> f64) -> f64 {
        // An empty sum is a negative zero.
        let sum = |groups: &[(usize, f64)]| {
            0.0 + self.scale * groups.iter().map(|&(group, share)| share * level(group)).sum::<f64>()
        };
        match &self.largest {
            Some(largest) => largest.sums.iter().map(|groups| sum(groups)).fold(0.0, f64::max),
            None => sum(&self.groups),
        }
    }

    /// All groups that it depends on.
    pub fn seen(&self) -> impl Iterator<Item = usize> {
        let sums = self.largest.iter().flat_map(|largest| largest.sums.iter().flatten());
        self.groups.iter().chain(sums).map(|one| one.0)
    }
}
