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
