//! Files that the page put here: a folder in memory.

use lanchester_answers::{
    FileState, Files, LONGEST_FILE, Problem, Status, is_engine_file, may_replace, too_long,
};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Texts by their names; clones are the same shelf.
#[derive(Debug, Clone, Default)]
pub struct Shelf(Arc<Mutex<BTreeMap<String, String>>>);

impl Shelf {
    /// Puts these files here in place of all that were.
    pub fn fill(&self, files: BTreeMap<String, String>) {
        *self.files() = files;
    }

    fn files(&self) -> MutexGuard<'_, BTreeMap<String, String>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Files for Shelf {
    fn place(&self) -> String {
        "this browser".into()
    }

    fn names(&self) -> Vec<String> {
        self.files().keys().filter(|name| is_engine_file(name)).cloned().collect()
    }

    fn open(&self, name: &str) -> Result<FileState, Problem> {
        let text = self.files().get(&plain(name)?.to_string()).cloned();
        let text = text.ok_or_else(|| {
            let message = format!("cannot read {name}: this browser keeps no file of this name");
            Problem::new(Status::Refused, message, "open another file")
        })?;
        Ok(FileState::new(name, text))
    }

    fn save(&self, name: &str, text: &str, over: Option<&str>) -> Result<FileState, Problem> {
        let name = plain(name)?;
        if text.len() as u64 > LONGEST_FILE {
            return Err(too_long(name, LONGEST_FILE));
        }
        let mut files = self.files();
        may_replace(name, files.get(name).map(String::as_str), over)?;
        files.insert(name.to_string(), text.to_string());
        Ok(FileState::new(name, text.to_string()))
    }

    fn named(&self, name: &str, by: &str) -> Result<String, Problem> {
        self.files().get(name).cloned().ok_or_else(|| {
            let message = format!("cannot read {name}: this browser keeps no file of this name");
            let hint = format!("{by} names it: open it from this computer, beside the engine file");
            Problem::new(Status::Refused, message, hint)
        })
    }
}

/// A name that an engine file may have, here as in a folder.
fn plain(name: &str) -> Result<&str, Problem> {
    let is_plain = is_engine_file(name) && !name.contains(['/', '\\', '\0']);
    is_plain.then_some(name).ok_or_else(|| {
        let short: String = name.chars().take(80).collect();
        let message = format!("an engine file is a plain name that ends in .toml, got `{short}`");
        Problem::new(Status::Refused, message, "write it like engine.toml")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_answers::Found;

    #[test]
    fn a_file_is_written_over_what_was_read_alone() {
        let shelf = Shelf::default();
        let first = shelf.save("a.toml", "one", None).unwrap();
        assert_eq!(shelf.save("a.toml", "two", None).unwrap_err().found, Some(Found::Exists));
        let second = shelf.save("a.toml", "two", Some(&first.revision)).unwrap();
        assert_eq!(shelf.open("a.toml").unwrap(), second);
        let changed = shelf.save("a.toml", "three", Some(&first.revision)).unwrap_err();
        assert_eq!((changed.status, changed.found), (Status::Conflict, Some(Found::Changed)));
        shelf.fill(BTreeMap::from([("p.csv".to_string(), "1".to_string())]));
        let removed = shelf.save("a.toml", "three", Some(&second.revision)).unwrap_err();
        assert_eq!(removed.found, Some(Found::Removed));
        assert!(shelf.names().is_empty());
        assert_eq!(shelf.named("p.csv", "[gas]").unwrap(), "1");
        assert!(shelf.named("q.csv", "[gas]").unwrap_err().hint.is_some_and(|hint| hint.contains("[gas]")));
    }

    #[test]
    fn names_are_those_of_a_folder() {
        for name in ["../a.toml", "/a.toml", "b/a.toml", "a.txt", ".toml", "", "a\\b.toml", "a.toml\0"] {
            assert!(Shelf::default().save(name, "x", None).is_err(), "{name}");
        }
    }
}
