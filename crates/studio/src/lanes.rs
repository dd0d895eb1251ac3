//! Which questions replace each other: of one window and one lane only the newest is computed.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

/// Lanes that are remembered: more mean that windows came and went, and forgetting costs no answer.
const MOST_LANES: usize = 4096;

/// The newest question of every lane.
#[derive(Debug, Default)]
pub(crate) struct Lanes {
    newest: Mutex<HashMap<String, u64>>,
}

/// The place of a question in its lane.
#[derive(Debug)]
pub(crate) struct Place {
    lane: String,
    number: u64,
}

impl Lanes {
    /// A new question; all before it in its lane are old now.
    pub(crate) fn enter(&self, client: &str, lane: &str) -> Place {
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        if newest.len() >= MOST_LANES {
            newest.clear();
        }
        let lane = format!("{client} {lane}");
        let number = newest.entry(lane.clone()).or_default();
        *number += 1;
        Place { number: *number, lane }
    }

    /// Whether no newer question came.
    pub(crate) fn is_newest(&self, place: &Place) -> bool {
        let newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        newest.get(&place.lane).is_none_or(|number| *number <= place.number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_newer_question_makes_an_older_one_old() {
        let lanes = Lanes::default();
        let (first, other) = (lanes.enter("a", "loads"), lanes.enter("a", "torque"));
        let elsewhere = lanes.enter("b", "loads");
        assert!(lanes.is_newest(&first) && lanes.is_newest(&other) && lanes.is_newest(&elsewhere));
        let second = lanes.enter("a", "loads");
        assert!(!lanes.is_newest(&first) && lanes.is_newest(&second));
        assert!(lanes.is_newest(&other) && lanes.is_newest(&elsewhere));
    }

    #[test]
    fn windows_that_come_and_go_fill_no_memory() {
        let lanes = Lanes::default();
        for client in 0..3 * MOST_LANES {
            lanes.enter(&client.to_string(), "loads");
        }
        assert!(lanes.newest.lock().unwrap().len() <= MOST_LANES);
    }
}
