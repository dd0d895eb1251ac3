//! A text in the place of a file.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// Puts a text in the place of a file that exists, whole or not at all; its permissions stay. A link is replaced: give what it
/// leads to.
///
/// # Errors
/// Of the file system, and where the file may not be written to: the file is as it was.
pub fn replace_file(target: &Path, text: &str) -> io::Result<()> {
    let permissions = fs::metadata(target)?.permissions();
    if permissions.readonly() {
        return Err(io::ErrorKind::PermissionDenied.into());
    }
    let mut beside = target.to_path_buf().into_os_string();
    beside.push(format!(".{}.new", std::process::id()));
    let mut file = OpenOptions::new().write(true).create_new(true).open(&beside)?;
    let outcome = file
        .write_all(text.as_bytes())
        .and_then(|()| file.set_permissions(permissions))
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&beside, target));
    if outcome.is_err() {
        // What could not be put in place is of no use; if it cannot be removed either, the first error says enough.
        let _ = fs::remove_file(&beside);
    }
    outcome
}

#[cfg(test)]
mod tests {
    use super::replace_file;
    use std::fs;

    #[test]
    fn a_file_is_replaced_whole_and_what_is_not_ours_stays() {
        let folder = std::env::temp_dir().join(format!("lanchester-replace-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join("engine.toml");
        assert!(replace_file(&file, "one").is_err(), "there is nothing to replace");
        fs::write(&file, "one").unwrap();
        replace_file(&file, "two").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "two");
        // A file of the name that the new text is written to first belongs to somebody else.
        let beside = folder.join(format!("engine.toml.{}.new", std::process::id()));
        fs::write(&beside, "theirs").unwrap();
        assert!(replace_file(&file, "three").is_err());
        assert_eq!(
            (fs::read_to_string(&file).unwrap(), fs::read_to_string(&beside).unwrap()),
            ("two".into(), "theirs".into())
        );
        fs::remove_dir_all(&folder).unwrap();
    }
}
