//! The folder of engine files: the only place that the studio reads from and writes to.

use lanchester_answers::{
    FileState, Files, Found, LONGEST_FILE, Problem, Status, is_engine_file, revision, text_of, too_long,
};
use lanchester_files::{NewFile, Over, PutError, open_regular};
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

/// A file of pressures may be this long.
const LONGEST_TRACE: u64 = 64 << 20;
/// Names that are listed.
const MOST_NAMES: usize = 500;

/// The folder.
#[derive(Debug, Clone)]
pub(crate) struct Folder {
    root: PathBuf,
}

impl Folder {
    /// The folder, links resolved.
    pub(crate) fn new(folder: &Path) -> io::Result<Folder> {
        let root = if folder.as_os_str().is_empty() { Path::new(".") } else { folder }.canonicalize()?;
        if root.is_dir() { Ok(Folder { root }) } else { Err(io::ErrorKind::NotADirectory.into()) }
    }
}

impl Files for Folder {
    /// Its path.
    fn place(&self) -> String {
        self.root.display().to_string()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.root).into_iter().flatten().flatten();
        // Links are followed; a named pipe would let whoever opens it wait for ever.
        let files = entries.filter(|entry| entry.path().is_file());
        let names = files.filter_map(|entry| entry.file_name().into_string().ok());
        let mut names: Vec<String> = names.filter(|name| is_engine_file(name)).collect();
        names.sort();
        names.truncate(MOST_NAMES);
        names
    }

    fn open(&self, name: &str) -> Result<FileState, Problem> {
        let path = self.engine_file(name)?;
        let text = self.read(&path, name, LONGEST_FILE)?;
        Ok(FileState::new(name, text))
    }

    fn save(&self, name: &str, text: &str, over: Option<&str>) -> Result<FileState, Problem> {
        let path = self.engine_file(name)?;
        if text.len() as u64 > LONGEST_FILE {
            return Err(too_long(name, LONGEST_FILE));
        }
        let refused = |error: PutError| match error {
            PutError::Exists => Found::Exists.problem(name),
            PutError::Changed => Found::Changed.problem(name),
            PutError::Removed => Found::Removed.problem(name),
            _ => {
                let hint = "the text is still here: save it under another name, or download it";
                Problem::new(Status::Refused, format!("cannot write {name}: {error}"), hint)
            }
        };
        let put = |path: &Path, over: Over| {
            let file = NewFile::beside(path, over)?;
            file.file().write_all(text.as_bytes())?;
            file.put()
        };
        match over {
            None => put(&path, Over::Nothing).map_err(refused)?,
            Some(over) => {
                // A link stays a link: what it leads to is written.
                let target = path.canonicalize().map_err(|error| match error.kind() {
                    io::ErrorKind::NotFound => refused(PutError::Removed),
                    _ => refused(error.into()),
                })?;
                let target = self.within(&target, name)?;
                let before = self.read(&target, name, LONGEST_FILE)?;
                if revision(&before) != over {
                    return Err(refused(PutError::Changed));
                }
                put(&target, Over::Text(before.as_bytes())).map_err(refused)?;
            }
        }
        Ok(FileState::new(name, text.to_string()))
    }

    /// It stands in this folder.
    fn named(&self, name: &str, by: &str) -> Result<String, Problem> {
        let there = self.root.join(name).canonicalize().map_err(|error| {
            let hint = format!("{by} names it: put it into the folder {}", self.place());
            Problem::new(Status::Refused, format!("cannot read {name}: {error}"), hint)
        })?;
        self.read(&self.within(&there, name)?, name, LONGEST_TRACE)
    }
}

impl Folder {
    /// The path of a file that may be opened and saved: a plain name in this folder.
    fn engine_file(&self, name: &str) -> Result<PathBuf, Problem> {
        let path = Path::new(name);
        let mut parts = path.components();
        let is_plain = matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None));
        if is_plain && is_engine_file(name) {
            return Ok(self.root.join(path));
        }
        Err(Problem::new(
            Status::Refused,
            format!(
                "an engine file is a name in this folder that ends in .toml, got `{}`",
                name.chars().take(80).collect::<String>()
            ),
            format!("write it like engine.toml; the folder is {}", self.place()),
        ))
    }

    fn within(&self, path: &Path, name: &str) -> Result<PathBuf, Problem> {
        if path.starts_with(&self.root) {
            return Ok(path.to_path_buf());
        }
        Err(Problem::new(
            Status::Forbidden,
            format!("{name} lies outside of the folder {}", self.place()),
            "the studio reads and writes this folder alone: move the file into it",
        ))
    }

    fn read(&self, path: &Path, name: &str, longest: u64) -> Result<String, Problem> {
        let path = self.within(&path.canonicalize().unwrap_or_else(|_| path.to_path_buf()), name)?;
        let mut bytes = Vec::new();
        let outcome = open_regular(&path).and_then(|file| file.take(longest + 1).read_to_end(&mut bytes));
        outcome.map_err(|error| {
            Problem::new(Status::Refused, format!("cannot read {name}: {error}"), "open another file")
        })?;
        if bytes.len() as u64 > longest {
            return Err(too_long(name, longest));
        }
        text_of(name, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("lanchester-folder-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Folder::new(&path).unwrap()
    }

    #[test]
    fn a_file_is_written_over_what_was_read_alone() {
        let folder = folder("save");
        let first = folder.save("a.toml", "one", None).unwrap();
        assert_eq!(folder.save("a.toml", "two", None).unwrap_err().found, Some(Found::Exists));
        let second = folder.save("a.toml", "two", Some(&first.revision)).unwrap();
        assert_eq!(folder.open("a.toml").unwrap(), second);
        let changed = folder.save("a.toml", "three", Some(&first.revision)).unwrap_err();
        assert_eq!((changed.status, changed.found), (Status::Conflict, Some(Found::Changed)));
        assert_eq!(folder.open("a.toml").unwrap().text, "two");
        fs::remove_file(folder.root.join("a.toml")).unwrap();
        let removed = folder.save("a.toml", "three", Some(&second.revision)).unwrap_err();
        assert_eq!((removed.status, removed.found), (Status::Conflict, Some(Found::Removed)));
        folder.save("a.toml", "three", None).unwrap();
        assert_eq!(folder.names(), ["a.toml"]);
        fs::remove_dir_all(&folder.root).unwrap();
    }

    #[test]
    fn no_name_leads_out_of_the_folder() {
        let folder = folder("names");
        for name in [
            "../a.toml",
            "/tmp/a.toml",
            "b/a.toml",
            "a.txt",
            ".toml",
            "",
            "..",
            "a.toml/..",
            ".a.toml",
            "a.toml\0",
        ] {
            assert!(folder.open(name).is_err() && folder.save(name, "x", None).is_err(), "{name}");
        }
        fs::remove_dir_all(&folder.root).unwrap();
    }

    /// A named pipe holds up whoever opens it until somebody writes: it is neither listed nor opened.
    #[cfg(unix)]
    #[test]
    fn a_named_pipe_is_no_engine_file() {
        let folder = folder("pipe");
        folder.save("a.toml", "one", None).unwrap();
        let pipe = folder.root.join("pipe.toml");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
        assert!(made.success());
        fs::create_dir(folder.root.join("folder.toml")).unwrap();
        assert_eq!(folder.names(), ["a.toml"]);
        let refused = folder.open("pipe.toml").unwrap_err();
        assert!(refused.message.contains("no regular file"), "{refused:?}");
        assert!(folder.save("pipe.toml", "x", Some("y")).is_err());
        fs::remove_dir_all(&folder.root).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_leads_out_is_not_followed() {
        let (inside, outside) = (folder("inside"), folder("outside"));
        outside.save("secret.toml", "x", None).unwrap();
        std::os::unix::fs::symlink(outside.root.join("secret.toml"), inside.root.join("link.toml")).unwrap();
        assert_eq!(inside.open("link.toml").unwrap_err().status, Status::Forbidden);
        let revision = revision("x");
        assert_eq!(inside.save("link.toml", "y", Some(&revision)).unwrap_err().status, Status::Forbidden);
        assert_eq!(outside.open("secret.toml").unwrap().text, "x");
        fs::remove_dir_all(&inside.root).unwrap();
        fs::remove_dir_all(&outside.root).unwrap();
    }
}
