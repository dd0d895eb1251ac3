//! Why a table cannot be written or read.

use parquet::errors::ParquetError;

/// Why a table cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// Where it goes to, or comes from, fails: a full disk.
    #[error("{0}")]
    Bytes(String),
    /// What is read is no table, or is damaged.
    #[error("not a table that can be read: {reason}")]
    Damaged {
        /// Why.
        reason: String,
    },
    /// The bytes of a block are not those that were written: a disk or a copy changed them.
    #[error("rows {} to {} of {of} are not those that were written (SHA-256 differs)", first + 1, first + rows)]
    Altered {
        /// Rows before the block.
        first: u64,
        /// Rows of the block.
        rows: u64,
        /// Rows of the table.
        of: u64,
    },
    /// The bytes of the footer are not those that were written.
    #[error("its footer is not the one that was written (SHA-256 differs)")]
    AlteredFooter,
    /// The bytes of a CSV table, or of the metadata beside it, are not those that were written.
    #[error("its bytes are not those that were written (SHA-256 differs)")]
    AlteredText,
    /// It has no hash to be verified by: an older version wrote it, or the place of the hash is damaged.
    #[error("it has no valid hash of its bytes: it is damaged, or an older version wrote it")]
    Unsealed,
    /// The columns are not those that were expected.
    #[error("the table has other columns: needed {needed}, got {got}")]
    Columns {
        /// Names that were needed.
        needed: String,
        /// Names that there are.
        got: String,
    },
}

impl From<std::io::Error> for TableError {
    fn from(error: std::io::Error) -> TableError {
        TableError::Bytes(error.to_string())
    }
}

impl From<ParquetError> for TableError {
    fn from(error: ParquetError) -> TableError {
        match error {
            // The sink's or the source's own words.
            ParquetError::External(error) => TableError::Bytes(error.to_string()),
            other => TableError::Damaged { reason: other.to_string() },
        }
    }
}
