//! Why the studio does not start.

use std::net::SocketAddr;
use std::path::PathBuf;

/// Why there is no server.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudioError {
    /// Another program listens there.
    #[error(
        "the port {port} is taken\nhint: leave --port out for a free one, or end the program that has it"
    )]
    Taken {
        /// The port.
        port: u16,
    },
    /// No server at this address.
    #[error("cannot listen at {address}: {error}\nhint: leave --port out for a free one")]
    Listen {
        /// Where.
        address: SocketAddr,
        /// What the system says.
        error: std::io::Error,
    },
    /// There is nothing at the path that was given.
    #[error("there is no file or folder {}\nhint: give an engine file, or a folder of engine files, that exists", .path.display())]
    Missing {
        /// The path.
        path: PathBuf,
    },
    /// The folder of the files.
    #[error("cannot use the folder {}: {error}\nhint: give an engine file, or a folder that is there", lanchester_files::shown(.folder))]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
    /// The engine file.
    #[error("{0}")]
    File(String),
    /// The system gives no random numbers, or the server ends by itself.
    #[error("the server cannot run: {0}")]
    System(String),
}
