//! Files of the front ends: one writer for all of them, regular files alone to read, names that a terminal may show.
//!
//! ```
//! use lanchester_files::{NewFile, Over};
//! use std::io::Write;
//! # let folder = std::env::temp_dir().join(format!("lanchester-files-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! let file = NewFile::beside(&folder.join("engine.toml"), Over::Nothing)?;
//! file.file().write_all(b"name = \"twin\"\n")?;
//! file.put()?;
//! # assert_eq!(std::fs::read(folder.join("engine.toml"))?, b"name = \"twin\"\n");
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod new_file;
mod regular;
mod secret_file;
mod shown;

pub use new_file::{NewFile, Over, PutError};
pub use regular::open_regular;
pub use secret_file::SecretFile;
pub use shown::shown;
