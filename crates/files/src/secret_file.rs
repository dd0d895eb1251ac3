//! A file for the eyes of its user alone.

use crate::new_file::create;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file among the temporary ones of the system that nobody but its user can read; dropped, it is removed.
#[derive(Debug)]
pub struct SecretFile(PathBuf);

impl SecretFile {
    /// Writes one whose name ends in `.ending`.
    ///
    /// # Errors
    /// Of the file system; nothing is left then.
    pub fn new(ending: &str, text: &str) -> io::Result<SecretFile> {
        let (path, mut file) = create(&std::env::temp_dir(), ending, true)?;
        let secret = SecretFile(path);
        file.write_all(text.as_bytes())?;
        Ok(secret)
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for SecretFile {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::SecretFile;

    #[test]
    fn nobody_else_can_read_it_and_it_goes() {
        let secret = SecretFile::new("html", "token").unwrap();
        let path = secret.path().to_path_buf();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "token");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            assert_eq!(path.metadata().unwrap().permissions().mode() & 0o777, 0o600);
        }
        drop(secret);
        assert!(!path.exists());
    }
}
