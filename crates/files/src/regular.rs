//! Regular files alone.

use std::fs::{File, OpenOptions};
use std::io;
use std::path::Path;

/// Opens a regular file for reading. A named pipe, at which opening waits for a writer, and a device are refused.
///
/// # Errors
/// Of the file system; [`io::ErrorKind::InvalidInput`] where it is no regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    let is_regular = |metadata: std::fs::Metadata| match metadata.is_file() {
        true => Ok(()),
        false => Err(io::Error::new(io::ErrorKind::InvalidInput, "it is no regular file")),
    };
    is_regular(std::fs::metadata(path)?)?;
    let mut options = OpenOptions::new();
    options.read(true);
    // What takes its place meanwhile does not make the opening wait.
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NONBLOCK.bits().cast_signed());
    }
    let file = options.open(path)?;
    is_regular(file.metadata()?)?;
    Ok(file)
}
