//! The seal of a table: the SHA-256 of each of its blocks and of its footer, kept in that footer, so that a flipped bit is found, and where,
//! before it is a result.
//!
//! ```text
//! block 1 | block 2 | ... | block n | tail: indexes, footer, its length, PAR1
//! lanchester.block_sha256   "length:hash" of every block, in order
//! lanchester.sha256         hash of the tail, with sixty-four zeros in its own place
//! ```
//! A block is a row group, the first one with the mark before it. The hash of the tail is over those of the blocks, so it stands for the
//! whole file; what is read is verified alone, and read once.

use crate::error::TableError;
use parquet::file::reader::ChunkReader;
use sha2::{Digest, Sha256};
use std::io::{self, Read, Write};

/// Under this key the footer keeps the hash of the tail.
pub const SEAL: &str = "lanchester.sha256";

/// Under this key the footer keeps lengths and hashes of the blocks.
pub const BLOCKS: &str = "lanchester.block_sha256";

/// What stands in the place of the hash while it is computed.
pub(crate) const OPEN: &str = "0000000000000000000000000000000000000000000000000000000000000000";

/// What stands between key and hash: the second field of a pair, a text of 64 bytes (Thrift's compact form).
const BETWEEN: [u8; 2] = [0x18, 64];

/// How a table in Parquet begins and ends.
const MARK: &[u8] = b"PAR1";

/// Bytes of a table that have a hash of their own: a row group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Block {
    pub(crate) start: u64,
    length: u64,
    hash: String,
}

/// A sink that hashes what goes through it, block by block. From [`Sealing::hold`] on it keeps the bytes back, until the hash stands among
/// them.
pub(crate) struct Sealing<W: Write> {
    sink: W,
    hash: Sha256,
    /// Bytes of the block that has begun, and of all before it.
    length: u64,
    start: u64,
    blocks: Vec<Block>,
    held: Option<Vec<u8>>,
}

impl<W: Write> Sealing<W> {
    pub(crate) fn new(sink: W) -> Sealing<W> {
        Sealing { sink, hash: Sha256::new(), length: 0, start: 0, blocks: Vec::new(), held: None }
    }

    /// Ends a block.
    pub(crate) fn end_block(&mut self) {
        let hash = hex(std::mem::take(&mut self.hash));
        self.blocks.push(Block { start: self.start, length: self.length, hash });
        self.start += self.length;
        self.length = 0;
    }

    /// The blocks so far, as the footer keeps them.
    pub(crate) fn blocks(&self) -> String {
        let all: Vec<String> =
            self.blocks.iter().map(|block| format!("{}:{}", block.length, block.hash)).collect();
        all.join(" ")
    }

    /// Keeps back all that comes from now on: the footer, in which the hash has its place.
    pub(crate) fn hold(&mut self) {
        self.held.get_or_insert_default();
    }

    /// Puts the hash into the footer that is kept back, writes it and gives the hash.
    pub(crate) fn seal(&mut self) -> Result<String, TableError> {
        let mut tail = self.held.take().unwrap_or_default();
        let place = place(&tail).ok_or_else(|| damaged("the footer has no room for the hash"))?;
        let hash = hex(Sha256::new_with_prefix(&tail));
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
        self.length += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

/// The blocks of a table in Parquet, whose tail is what was written, byte for byte.
pub(crate) fn verified_blocks(source: &impl ChunkReader) -> Result<Vec<Block>, TableError> {
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
    let footer_start = length - 8 - footer;
    let size = usize::try_from(footer + 8).map_err(|_| damaged("its footer is too long"))?;
    let mut tail = source.get_bytes(footer_start, size)?.to_vec();
    // Not verified yet: where the tail begins, which must be verified as a whole.
    let blocks = listed(&tail).ok_or(TableError::Unsealed)?;
    let start = blocks.last().map_or(Some(0), |last| last.start.checked_add(last.length));
    let start = start.filter(|start| *start <= footer_start).ok_or(TableError::AlteredFooter)?;
    let place = place(&tail).ok_or(TableError::Unsealed)?;
    let kept = tail[place..place + OPEN.len()].to_vec();
    tail[place..place + OPEN.len()].copy_from_slice(OPEN.as_bytes());
    let mut hash = Sha256::new();
    feed(&mut hash, source.get_read(start)?.take(footer_start - start))?;
    hash.update(&tail);
    let found = hex(hash);
    if found.as_bytes() == kept { Ok(blocks) } else { Err(TableError::AlteredFooter) }
}

/// Whether a block is what was written, byte for byte.
pub(crate) fn is_whole(source: &impl ChunkReader, block: &Block) -> Result<bool, TableError> {
    let mut hash = Sha256::new();
    feed(&mut hash, source.get_read(block.start)?.take(block.length))?;
    Ok(hex(hash) == block.hash)
}

/// The blocks that a footer tells of.
fn listed(footer: &[u8]) -> Option<Vec<Block>> {
    let key = footer.windows(BLOCKS.len()).rposition(|some| some == BLOCKS.as_bytes())?;
    let mut rest = footer[key + BLOCKS.len()..].iter();
    // A text in Thrift's compact form: its field, then its length, seven bits a byte, the lowest first.
    (*rest.next()? == BETWEEN[0]).then_some(())?;
    let mut size = 0_usize;
    for shift in (0..u32::BITS).step_by(7) {
        let byte = rest.next()?;
        size |= usize::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            break;
        }
    }
    let text = std::str::from_utf8(rest.as_slice().get(..size)?).ok()?;
    let mut start = 0_u64;
    let mut blocks = Vec::new();
    for entry in text.split_terminator(' ') {
        let (length, hash) = entry.split_once(':')?;
        let length = length.parse().ok()?;
        blocks.push(Block { start, length, hash: hash.to_owned() });
        start = start.checked_add(length)?;
    }
    Some(blocks)
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
