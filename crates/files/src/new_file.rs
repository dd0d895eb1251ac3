//! The one writer of files: a new file beside its place, whole, then put there.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// What a file may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over<'a> {
    /// Of nothing: the file must not exist.
    Nothing,
    /// Of a file that holds these bytes and no others.
    Text(&'a [u8]),
    /// Of an earlier result, whatever it holds.
    Anything,
}

/// Why a file was not put in its place: what stood there still does.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PutError {
    /// A new file was to be written, and there is one.
    #[error("it exists and is not overwritten")]
    Exists,
    /// Another program changed it meanwhile: its version is kept.
    #[error("another program has changed it")]
    Changed,
    /// Another program removed it meanwhile.
    #[error("another program has removed it")]
    Removed,
    /// It may not be written to.
    #[error("it is read-only")]
    ReadOnly,
    /// A folder, a pipe, a device.
    #[error("it is no regular file")]
    NotAFile,
    /// It belongs to another user, to whom a new file cannot be given.
    #[error("it belongs to another user or group, which a new file cannot keep")]
    Owner,
    /// Another program wrote while two files changed places: what it wrote is kept under another name.
    #[error("another program has written to it at the same moment; one of the two versions is kept as {}", crate::shown(.0))]
    Aside(PathBuf),
    /// What the file system says.
    #[error("{0}")]
    System(#[from] io::Error),
}

/// A file that is being written beside its place, under a name that nothing else has. It takes its place by [`NewFile::put`], whole;
/// dropped before, it is removed.
#[derive(Debug)]
pub struct NewFile<'a> {
    target: PathBuf,
    over: Over<'a>,
    /// Of the file whose place it takes.
    before: Option<Metadata>,
    temporary: PathBuf,
    file: File,
    /// Whether the temporary name is still ours to remove.
    ours: bool,
}

impl<'a> NewFile<'a> {
    /// Begins a file for the place `path`. A link stays a link: the place is what it leads to.
    ///
    /// # Errors
    /// [`PutError`] where it may not go there, or the folder takes no new file.
    pub fn beside(path: &Path, over: Over<'a>) -> Result<NewFile<'a>, PutError> {
        let (target, before) = match over {
            Over::Nothing => match fs::symlink_metadata(path) {
                Ok(_) => return Err(PutError::Exists),
                Err(_) => (path.to_path_buf(), None),
            },
            Over::Anything if fs::symlink_metadata(path).is_err() => (path.to_path_buf(), None),
            Over::Text(_) | Over::Anything => {
                let target = path.canonicalize().map_err(|error| removed(over, error))?;
                let before = fs::metadata(&target).map_err(|error| removed(over, error))?;
                (target, Some(before))
            }
        };
        if let Some(before) = &before {
            if !before.is_file() {
                return Err(PutError::NotAFile);
            }
            if before.permissions().readonly() {
                return Err(PutError::ReadOnly);
            }
        }
        unchanged(&target, over)?;
        let (temporary, file) = create(folder_of(&target), "new", before.is_some())?;
        Ok(NewFile { target, over, before, temporary, file, ours: true })
    }

    /// What is written into.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// Puts it in its place, synchronised, with the owner and the permissions of the file that was there.
    ///
    /// # Errors
    /// [`PutError`]: what stood there still does; where another program changed it since, its version.
    pub fn put(mut self) -> Result<(), PutError> {
        if let Some(before) = &self.before {
            keep_owner(&self.file, before)?;
            self.file.set_permissions(before.permissions())?;
        }
        self.file.sync_all()?;
        match self.over {
            Over::Nothing => self.put_new()?,
            Over::Text(text) => self.put_over(text)?,
            Over::Anything => {
                fs::rename(&self.temporary, &self.target)?;
                self.ours = false;
            }
        }
        // It stands; a folder that cannot be synchronised does so by itself, later.
        #[cfg(unix)]
        let _ = File::open(folder_of(&self.target)).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// A second name fails where there is a file, a new name for the first one would not.
    fn put_new(&mut self) -> Result<(), PutError> {
        match fs::hard_link(&self.temporary, &self.target) {
            Ok(()) => Ok(()),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(PutError::Exists),
            // A file system without second names.
            Err(_) if fs::symlink_metadata(&self.target).is_ok() => Err(PutError::Exists),
            Err(_) => {
                fs::rename(&self.temporary, &self.target)?;
                self.ours = false;
                Ok(())
            }
        }
    }

    fn put_over(&mut self, text: &[u8]) -> Result<(), PutError> {
        unchanged(&self.target, self.over)?;
        #[cfg(target_os = "linux")]
        if self.change_places(text)? {
            return Ok(());
        }
        let _ = text;
        fs::rename(&self.temporary, &self.target)?;
        self.ours = false;
        Ok(())
    }

    /// Both files change places in one step, so that what stood there can still be compared, and put back: no moment is left in which
    /// another program's version is lost. `false`: this file system cannot.
    #[cfg(target_os = "linux")]
    fn change_places(&mut self, text: &[u8]) -> Result<bool, PutError> {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        let exchange = || renameat_with(CWD, &self.temporary, CWD, &self.target, RenameFlags::EXCHANGE);
        let stamp = |file: &File| file.metadata().map(|data| (data.len(), data.modified().ok()));
        let own = stamp(&self.file)?;
        match exchange() {
            Ok(()) => {}
            Err(rustix::io::Errno::NOENT) => return Err(PutError::Removed),
            Err(_) => return Ok(false),
        }
        if fs::read(&self.temporary).is_ok_and(|found| found == text) {
            return Ok(true);
        }
        let is_back = exchange().is_ok();
        if is_back && stamp(&self.file).is_ok_and(|now| now == own) {
            return Err(PutError::Changed);
        }
        // Theirs stands under the temporary name, or they wrote into ours.
        self.ours = false;
        Err(PutError::Aside(self.temporary.clone()))
    }
}

impl Drop for NewFile<'_> {
    fn drop(&mut self) {
        if self.ours {
            // It is of no use; if it cannot be removed either, the first error says enough.
            let _ = fs::remove_file(&self.temporary);
        }
    }
}

fn removed(over: Over, error: io::Error) -> PutError {
    match (over, error.kind()) {
        (Over::Text(_), io::ErrorKind::NotFound) => PutError::Removed,
        _ => error.into(),
    }
}

/// Whether the file still holds what it may be written over.
fn unchanged(target: &Path, over: Over) -> Result<(), PutError> {
    let Over::Text(text) = over else { return Ok(()) };
    match fs::read(target) {
        Ok(found) if found == text => Ok(()),
        Ok(_) => Err(PutError::Changed),
        Err(error) => Err(removed(over, error)),
    }
}

/// A new file of a random name; a secret one is its user's alone: what takes the place of another has no readers before it has that one's
/// permissions.
pub(crate) fn create(folder: &Path, ending: &str, is_secret: bool) -> io::Result<(PathBuf, File)> {
    let mut tries = 0;
    loop {
        let mut random = [0u8; 8];
        getrandom::fill(&mut random).map_err(io::Error::other)?;
        let path = folder.join(format!(".lanchester-{:016x}.{ending}", u64::from_le_bytes(random)));
        let mut options = OpenOptions::new();
        options.write(true).create_new(true);
        #[cfg(unix)]
        if is_secret {
            use std::os::unix::fs::OpenOptionsExt;
            options.mode(0o600);
        }
        #[cfg(not(unix))]
        let _ = is_secret;
        match options.open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && tries < 8 => tries += 1,
            Err(error) => return Err(error),
        }
    }
}

fn folder_of(target: &Path) -> &Path {
    target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(unix)]
fn keep_owner(file: &File, before: &Metadata) -> Result<(), PutError> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let now = file.metadata()?;
    if (now.uid(), now.gid()) == (before.uid(), before.gid()) {
        return Ok(());
    }
    fchown(file, Some(before.uid()), Some(before.gid())).map_err(|_| PutError::Owner)
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) -> Result<(), PutError> {
    Ok(())
}
