//! Everything that lasts from one question to the next.

use crate::shelf::Shelf;
use lanchester_answers::{Answers, Asker, Question, Reply, Studio, answers, broken_off};
use std::collections::BTreeMap;

/// Puts files on the shelf in place of all that are there: an object of names and texts.
const SHELF: &str = "/shelf";

/// Answers, and the files that the page handed in.
pub struct Module {
    studio: Studio,
    answers: Answers,
    shelf: Shelf,
}

impl Default for Module {
    fn default() -> Module {
        let shelf = Shelf::default();
        let program = concat!("lanchester ", env!("CARGO_PKG_VERSION"));
        let commit = option_env!("LANCHESTER_COMMIT").unwrap_or("unknown commit");
        let program = format!("{program} ({commit}, in a browser)");
        let studio = Studio::new(program, Box::new(shelf.clone()), web_time::since_start);
        Module { studio, answers: answers(), shelf }
    }
}

impl Module {
    /// The answer to a question: `head` is its method and path, like `POST /api/loads`.
    pub fn answer(&self, head: &str, body: &[u8]) -> Reply {
        let (method, path) = head.split_once(' ').unwrap_or(("", head));
        match (method, path) {
            ("PUT", SHELF) => match serde_json::from_slice::<BTreeMap<String, String>>(body) {
                Ok(files) => {
                    self.shelf.fill(files);
                    Reply { status: 200, kind: "application/json", bytes: b"null".to_vec() }
                }
                Err(_) => broken_off().into(),
            },
            // Whoever does not wait any more throws the whole module away.
            _ => self.answers.answer(&Asker::new(&self.studio, &|| true), Question { method, path, body }),
        }
    }
}
