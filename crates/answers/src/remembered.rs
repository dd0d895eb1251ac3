//! Answers that are asked for again at every return to a tab.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

/// How many are kept.
const KEPT: usize = 8;

/// The newest answers of one kind, by all that they depend on.
#[derive(Debug)]
pub(crate) struct Remembered<Q, T> {
    newest: Mutex<VecDeque<(Q, T)>>,
}

impl<Q, T> Default for Remembered<Q, T> {
    fn default() -> Remembered<Q, T> {
        Remembered { newest: Mutex::default() }
    }
}

impl<Q: PartialEq, T: Clone> Remembered<Q, T> {
    /// The answer to `question`: the one that is known, or that of `answer`, which is kept unless it fails.
    pub(crate) fn answer<E>(&self, question: Q, answer: impl FnOnce(&Q) -> Result<T, E>) -> Result<T, E> {
        let lock = || self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        {
            let mut newest = lock();
            if let Some(place) = newest.iter().position(|(known, _)| *known == question)
                && let Some(entry) = newest.remove(place)
            {
                let found = entry.1.clone();
                newest.push_front(entry);
                return Ok(found);
            }
        }
        // Nobody waits for the lock while it is computed.
        let found = answer(&question)?;
        let mut newest = lock();
        newest.push_front((question, found.clone()));
        newest.truncate(KEPT);
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    #[test]
    fn an_answer_is_computed_once_until_eight_others_came() {
        let (remembered, computed) = (Remembered::default(), Cell::new(0));
        let ask = |question: u32| {
            let answer = |question: &u32| {
                computed.set(computed.get() + 1);
                if *question == 99 { Err("no") } else { Ok(question * 10) }
            };
            remembered.answer(question, answer)
        };
        assert_eq!([ask(1), ask(1), ask(2), ask(1)], [Ok(10), Ok(10), Ok(20), Ok(10)]);
        assert_eq!(computed.get(), 2);
        (10..17).for_each(|question| assert!(ask(question).is_ok()));
        // The one asked for last before is still there, the other is not.
        assert_eq!((ask(1), computed.get()), (Ok(10), 9));
        assert_eq!((ask(2), computed.get()), (Ok(20), 10));
        // A failure is asked again.
        assert_eq!((ask(99), ask(99), computed.get()), (Err("no"), Err("no"), 12));
    }
}
