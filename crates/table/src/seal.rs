//! The seal of a table: the SHA-256 of all its bytes, kept in its own footer, so that a flipped bit is found before it is a result.

use crate::error::TableError;
use parquet::file::reader::ChunkReader;
use sha2::{Digest, Sha256};
use std::io::{self, Read, Write};

/// Under this key the footer keeps the hash.
pub const SEAL: &str = "lanchester.sha256";

/// What stands in the place of the hash while it is computed.
pub(crate) const OPEN: &str = "0000000000000000000000000000000000000000000000000000000000000000";

/// What stands between key and hash: the second field of a pair, a text of 64 bytes (Thrift's compact form).
const BETWEEN: [u8; 2] = [0x18, 64];

/// How a table in Parquet begins and ends.
const MARK: &[u8] = b"PAR1";

/// A sink that hashes what goes through it. From [`Sealing::hold`] on it keeps the bytes back, until the hash stands among them.
pub(crate) struct Sealing<W: Write> {
    sink: W,
    hash: Sha256,
    held: Option<Vec<u8>>,
}

impl<W: Write> Sealing<W> {
    pub(crate) fn new(sink: W) -> Sealing<W> {
        Sealing { sink, hash: Sha256::new(), held: None }
    }

    /// Keeps back all that comes from now on: the footer, in which the hash has its place.
    pub(crate) fn hold(&mut self) {
        self.held.get_or_insert_default();
    }

    /// Puts the hash into the footer that is kept back, writes it and gives the hash.
    pub(crate) fn seal(&mut self) -> Result<String, TableError> {
        let mut tail = self.held.take().unwrap_or_default();
        let place = place(&tail).ok_or_else(|| damaged("the footer has no room for the hash"))?;
        self.hash.update(&tail);
        let hash = hex(self.hash.clone());
        tail[place..place + hash.len()].copy_from_slice(hash.as_bytes());
        self.sink.write_all(&tail)?;
        self.sink.flush()?;
        Ok(hash)
    }

    /// The hash of what was written and of the metadata that another file keeps.
    pub(crate) fn with_metadata(self, metadata: &[(String, String)]) -> String {
        with_metadata(self.hash, metadata)
    }
}

impl<W: Write> Write for Sealing<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(held) = &mut self.held {
            held.extend_from_slice(bytes);
            return Ok(bytes.len());
        }
        let written = self.sink.write(bytes)?;
        self.hash.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

/// Whether a table in Parquet is what was written, byte for byte.
pub(crate) fn verify(source: &impl ChunkReader) -> Result<(), TableError> {
    let length = source.len();
    let ends = 2 * MARK.len() as u64 + 4;
    if length < ends {
        return Err(damaged("it is too short"));
    }
    let end = source.get_bytes(length - 8, 8)?;
    let footer = u64::from(u32::from_le_bytes([end[0], end[1], end[2], end[3]]));
    if &end[4..] != MARK || footer + ends > length {
        return Err(damaged("it has no end"));
    }
    let start = length - 8 - footer;
    let size = usize::try_from(footer + 8).map_err(|_| damaged("its footer is too long"))?;
    let mut tail = source.get_bytes(start, size)?.to_vec();
    let place = place(&tail).ok_or(TableError::Unsealed)?;
    let kept = tail[place..place + OPEN.len()].to_vec();
    tail[place..place + OPEN.len()].copy_from_slice(OPEN.as_bytes());
    let mut hash = Sha256::new();
    feed(&mut hash, source.get_read(0)?.take(start))?;
    hash.update(&tail);
    if hex(hash).as_bytes() == kept { Ok(()) } else { Err(TableError::Altered) }
}

/// The hash of a CSV table and of the metadata that stands beside it, as [`crate::TableWriter::finish`] gives it.
///
/// # Errors
/// Of the source.
pub fn csv_seal(table: impl Read, metadata: &[(String, String)]) -> Result<String, TableError> {
    let mut hash = Sha256::new();
    feed(&mut hash, table)?;
    Ok(with_metadata(hash, metadata))
}

fn with_metadata(mut hash: Sha256, metadata: &[(String, String)]) -> String {
    for (key, value) in metadata {
        // Lengths keep keys and values apart.
        for text in [key, value] {
            hash.update((text.len() as u64).to_le_bytes());
            hash.update(text);
        }
    }
    hex(hash)
}

fn feed(hash: &mut Sha256, mut source: impl Read) -> Result<(), TableError> {
    let mut some = vec![0; 1 << 16];
    loop {
        match source.read(&mut some) {
            Ok(0) => return Ok(()),
            Ok(count) => hash.update(&some[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error.into()),
        }
    }
}

/// Where the hash stands in a footer: behind the last such key, whatever the values before it say.
fn place(tail: &[u8]) -> Option<usize> {
    let key = tail.windows(SEAL.len()).rposition(|some| some == SEAL.as_bytes())?;
    let place = key + SEAL.len() + BETWEEN.len();
    let hash = tail.get(place..place + OPEN.len())?;
    let is_hash = hash.iter().all(|letter| matches!(letter, b'0'..=b'9' | b'a'..=b'f'));
    (is_hash && tail[place - BETWEEN.len()..place] == BETWEEN).then_some(place)
}

fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

fn damaged(reason: &str) -> TableError {
    TableError::Damaged { reason: reason.to_owned() }
}
