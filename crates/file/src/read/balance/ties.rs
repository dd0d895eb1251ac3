//! Weights that follow others.

use super::Reader;
use super::free_weight::DraftFreeWeight;
use lanchester_diagnostic::Mistake;
use lanchester_task::{BalanceTask, Tie};
use lanchester_units::nearest;

impl Reader<'_> {
    /// Finds every leader; whether all are there and lead nobody but followers.
    pub(super) fn follow_leaders(&mut self, weights: &mut [DraftFreeWeight]) -> bool {
        let mut are_good = true;
        for index in 0..weights.len() {
            let Some(follows) = &weights[index].own.follows else { continue };
            let leader = weights.iter().position(|weight| weight.name == follows.leader_name);
            let problem = match leader {
                None => {
                    let names = weights.iter().map(|weight| weight.name.as_str());
                    let hint = match nearest(
                        &follows.leader_name,
                        names.filter(|name| *name != weights[index].name),
                    ) {
                        Some(near) => format!("did you mean \"{near}\"?"),
                        None => "name another weight of [balance]".into(),
                    };
                    let message = format!("there is no free weight \"{}\"", follows.leader_name);
                    Some(Mistake::error("E0205", follows.span.clone(), message).hint(hint))
                }
                Some(leader) if leader == index => {
                    let message = format!("\"{}\" is tied to itself", weights[index].name);
                    Some(
                        Mistake::error("E0511", follows.span.clone(), message)
                            .hint("name another weight of [balance]"),
                    )
                }
                Some(leader) => weights[leader].own.follows.as_ref().map(|next| {
                    let message = format!(
                        "\"{}\" follows \"{}\", which follows \"{}\" itself",
                        weights[index].name, follows.leader_name, next.leader_name
                    );
                    let hint = match root(weights, leader) {
                        Some(root) => format!("let it follow \"{root}\""),
                        None => "let one of them be free".into(),
                    };
                    Mistake::error("E0511", follows.span.clone(), message)
                        .related(next.span.clone(), "follows too")
                        .hint(hint)
                }),
            };
            if let Some(problem) = problem {
                self.mistakes.push(problem);
                are_good = false;
            } else if let Some(follows) = &mut weights[index].own.follows {
                follows.leader = leader;
            }
        }
        are_good
    }
}

/// The free weight at the head of the chain; `None` if it is a ring.
fn root(weights: &[DraftFreeWeight], start: usize) -> Option<&str> {
    let mut at = start;
    for _ in 0..weights.len() {
        let Some(follows) = &weights[at].own.follows else { return Some(&weights[at].name) };
        at = weights.iter().position(|weight| weight.name == follows.leader_name)?;
    }
    None
}

pub(super) fn ties(weights: &[DraftFreeWeight]) -> Vec<Tie> {
    let tie = |(second, weight): (usize, &DraftFreeWeight)| {
        let follows = weight.own.follows.as_ref()?;
        Some(Tie { first: follows.leader?, second, factor: follows.factor, mirrored: follows.mirrored })
    };
    weights.iter().enumerate().filter_map(tie).collect()
}

/// A follower may grow as far as its leader takes it.
pub(super) fn bound_followers(task: &mut BalanceTask) {
    for tie in &task.ties {
        task.weights[tie.second].most = task.weights[tie.first].most.map(|most| most * tie.factor.abs());
    }
}
