//! Reading tables back.

use crate::column::{Column, Kind, Rows, Values};
use crate::error::TableError;
use crate::seal::{Block, is_whole, verified_blocks};
use parquet::basic::Type as Physical;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::file::metadata::RowGroupMetaData;
use parquet::file::reader::{ChunkReader, FileReader, Length, SerializedFileReader};
use std::sync::Arc;

/// Bytes that are shared.
pub use bytes::Bytes;

/// A table in Parquet that is being read, a row group at a time.
pub struct TableReader<R: ChunkReader + 'static> {
    source: Shared<R>,
    reader: SerializedFileReader<Shared<R>>,
    blocks: Vec<Block>,
    next: usize,
}

/// A source that is read by two: to verify it, and for its values.
struct Shared<R>(Arc<R>);

impl<R: Length> Length for Shared<R> {
    fn len(&self) -> u64 {
        self.0.len()
    }
}

impl<R: ChunkReader> ChunkReader for Shared<R> {
    type T = R::T;

    fn get_read(&self, start: u64) -> parquet::errors::Result<R::T> {
        self.0.get_read(start)
    }

    fn get_bytes(&self, start: u64, length: usize) -> parquet::errors::Result<Bytes> {
        self.0.get_bytes(start, length)
    }
}

impl<R: ChunkReader + 'static> TableReader<R> {
    /// Verifies the footer by its hash and reads it; rows are verified when they are read, or by [`TableReader::verify`].
    ///
    /// # Errors
    /// [`TableError`] where it is no table, one that was not ended, or its footer is not what was written.
    pub fn open(source: R) -> Result<TableReader<R>, TableError> {
        let blocks = verified_blocks(&source)?;
        let source = Shared(Arc::new(source));
        let reader = SerializedFileReader::new(Shared(Arc::clone(&source.0)))?;
        if reader.num_row_groups() != blocks.len() {
            let reason = format!("{} row groups have {} hashes", reader.num_row_groups(), blocks.len());
            return Err(TableError::Damaged { reason });
        }
        Ok(TableReader { source, reader, blocks, next: 0 })
    }

    /// Verifies all rows by their hashes.
    ///
    /// # Errors
    /// [`TableError::Altered`] names the first rows that are not what was written.
    pub fn verify(&self) -> Result<(), TableError> {
        (0..self.blocks.len()).try_for_each(|k| self.verify_block(k))
    }

    fn verify_block(&self, k: usize) -> Result<(), TableError> {
        if is_whole(&self.source, &self.blocks[k])? {
            return Ok(());
        }
        let groups = self.reader.metadata().row_groups();
        let rows = |groups: &[RowGroupMetaData]| -> u64 {
            groups.iter().map(|group| u64::try_from(group.num_rows()).unwrap_or(0)).sum()
        };
        Err(TableError::Altered { first: rows(&groups[..k]), rows: rows(&groups[k..=k]), of: self.rows() })
    }

    /// The metadata under a key.
    pub fn metadata(&self, key: &str) -> Option<&str> {
        let all = self.reader.metadata().file_metadata().key_value_metadata()?;
        all.iter().find(|entry| entry.key == key)?.value.as_deref()
    }

    /// Rows of the whole table.
    pub fn rows(&self) -> u64 {
        self.reader.metadata().file_metadata().num_rows().try_into().unwrap_or(0)
    }

    /// The columns; `None` where one is of a kind that this program does not write.
    pub fn columns(&self) -> Option<Vec<Column>> {
        let schema = self.reader.metadata().file_metadata().schema_descr();
        let column = |k: usize| {
            let field = schema.column(k);
            let kind = match field.physical_type() {
                Physical::INT64 => Kind::Whole,
                Physical::DOUBLE => Kind::Real,
                Physical::BYTE_ARRAY => Kind::Text,
                _ => return None,
            };
            Some(Column { name: field.name().to_owned(), kind })
        };
        (0..schema.num_columns()).map(column).collect()
    }

    /// The next rows, verified by their hash; `None` at the end.
    ///
    /// # Errors
    /// [`TableError`] where the table has other columns or these rows are not what was written.
    pub fn next(&mut self, columns: &[Column]) -> Result<Option<Rows>, TableError> {
        let own = self.columns();
        if own.as_deref() != Some(columns) {
            let names = |columns: &[Column]| {
                columns.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ")
            };
            let got = own.map_or("columns of other kinds".to_owned(), |own| names(&own));
            return Err(TableError::Columns { needed: names(columns), got });
        }
        if self.next == self.reader.num_row_groups() {
            return Ok(None);
        }
        self.verify_block(self.next)?;
        let group = self.reader.get_row_group(self.next)?;
        self.next += 1;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let mut all = Vec::with_capacity(columns.len());
        for k in 0..columns.len() {
            all.push(match group.get_column_reader(k)? {
                ColumnReader::Int64ColumnReader(reader) => Values::Whole(values(reader, count)?),
                ColumnReader::DoubleColumnReader(reader) => Values::Real(values(reader, count)?),
                ColumnReader::ByteArrayColumnReader(reader) => {
                    let words = values(reader, count)?.into_iter().map(text);
                    Values::Text(words.collect::<Result<_, _>>()?)
                }
                _ => return Err(TableError::Damaged { reason: "a column has changed its kind".to_owned() }),
            });
        }
        Ok(Some(Rows::of(all)))
    }
}

/// All values of a column of a row group.
fn values<T: DataType>(mut reader: ColumnReaderImpl<T>, count: usize) -> Result<Vec<T::T>, TableError> {
    let mut values = Vec::with_capacity(count);
    while values.len() < count {
        let (read, _, _) = reader.read_records(count - values.len(), None, None, &mut values)?;
        if read == 0 {
            let reason = format!("a column has {} rows of {count}", values.len());
            return Err(TableError::Damaged { reason });
        }
    }
    Ok(values)
}

fn text(bytes: ByteArray) -> Result<String, TableError> {
    let text = bytes.as_utf8().map_err(|error| TableError::Damaged { reason: error.to_string() })?;
    Ok(text.to_owned())
}
