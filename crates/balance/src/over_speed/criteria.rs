//! What a task asks for over speed.

use lanchester_task::{BalanceTask, Criterion, Mains};

/// The criteria of a task of one kind, each once.
pub(crate) fn criteria(task: &BalanceTask, counts: impl Fn(&Criterion) -> bool) -> Vec<Criterion> {
    let stages = task.stages_or_default();
    let asked = stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
    let mut criteria: Vec<Criterion> = Vec::new();
    for criterion in asked.chain(task.limits.iter().map(|limit| limit.criterion)) {
        if counts(&criterion) && !criteria.contains(&criterion) {
            criteria.push(criterion);
        }
    }
    criteria
}

/// The main bearings that count.
pub(crate) fn indices(mains: Mains, count: usize) -> Vec<usize> {
    match mains {
        Mains::One(index) => vec![index],
        Mains::All | Mains::Largest => (0..count).collect(),
    }
}
