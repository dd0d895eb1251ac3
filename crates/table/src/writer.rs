//! Writing tables.

use crate::column::{Column, Kind, Rows, Values};
use crate::csv;
use crate::error::TableError;
use crate::seal::{BLOCKS, OPEN, SEAL, Sealing};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::Write;
use std::sync::Arc;

/// Rows of a row group: the same in every file, so that its bytes do not depend on the pieces in which the rows come.
const GROUP: usize = 1 << 16;

/// Form of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Apache Parquet, Snappy, with the metadata in its footer.
    Parquet,
    /// CSV, which has no room for metadata.
    Csv,
}

/// A table that is being written; a row group is held at a time.
pub struct TableWriter<W: Write + Send> {
    columns: Vec<Column>,
    waiting: Rows,
    sink: Sink<W>,
}

/// Where the rows go.
enum Sink<W: Write + Send> {
    Parquet(Box<SerializedFileWriter<Sealing<W>>>),
    Csv(Sealing<W>),
}

impl<W: Write + Send> TableWriter<W> {
    /// Begins a table.
    ///
    /// # Errors
    /// [`TableError`] where the sink fails.
    pub fn new(form: Form, sink: W, columns: &[Column]) -> Result<TableWriter<W>, TableError> {
        let mut sink = Sealing::new(sink);
        let sink = match form {
            Form::Parquet => {
                let properties = WriterProperties::builder()
                    .set_compression(Compression::SNAPPY)
                    .set_created_by("lanchester".to_owned())
                    .build();
                let writer = SerializedFileWriter::new(sink, schema(columns)?, Arc::new(properties))?;
                Sink::Parquet(Box::new(writer))
            }
            Form::Csv => {
                csv::write_head(&mut sink, columns)?;
                Sink::Csv(sink)
            }
        };
        Ok(TableWriter { columns: columns.to_vec(), waiting: Rows::empty(columns), sink })
    }

    /// Takes rows.
    ///
    /// # Errors
    /// [`TableError`] where the sink fails, or the rows are of another table.
    pub fn push(&mut self, rows: Rows) -> Result<(), TableError> {
        if !rows.fit(&self.columns) {
            let needed = format!("{} of their kinds", self.columns.len());
            return Err(TableError::Columns { needed, got: rows.columns().len().to_string() });
        }
        self.waiting.append(rows);
        while self.waiting.len() >= GROUP {
            let rest = self.waiting.split_off(GROUP);
            let group = std::mem::replace(&mut self.waiting, rest);
            self.write(&group)?;
        }
        Ok(())
    }

    /// Ends the table and gives its hash. Parquet keeps `metadata`, the hashes of its row groups and that of the footer itself in the footer;
    /// CSV drops them, and the hash is that of its bytes and of `metadata` ([`crate::csv_seal`]).
    ///
    /// # Errors
    /// [`TableError`] where the sink fails.
    pub fn finish(mut self, metadata: &[(String, String)]) -> Result<String, TableError> {
        let rest = std::mem::take(&mut self.waiting);
        if !rest.is_empty() {
            self.write(&rest)?;
        }
        match self.sink {
            Sink::Parquet(mut writer) => {
                for (key, value) in metadata {
                    writer.append_key_value_metadata(KeyValue::new(key.clone(), value.clone()));
                }
                let blocks = writer.inner().blocks();
                writer.append_key_value_metadata(KeyValue::new(BLOCKS.to_owned(), blocks));
                // The last of them, where it is looked for.
                writer.append_key_value_metadata(KeyValue::new(SEAL.to_owned(), OPEN.to_owned()));
                writer.inner_mut().hold();
                writer.finish()?;
                writer.inner_mut().seal()
            }
            Sink::Csv(mut sink) => {
                sink.flush()?;
                Ok(sink.with_metadata(metadata))
            }
        }
    }

    fn write(&mut self, rows: &Rows) -> Result<(), TableError> {
        let writer = match &mut self.sink {
            Sink::Csv(sink) => return Ok(csv::write_rows(sink, rows)?),
            Sink::Parquet(writer) => writer,
        };
        let mut group = writer.next_row_group()?;
        for values in rows.columns() {
            let mut column =
                group.next_column()?.expect("invariant: the schema has every column of the rows");
            match values {
                Values::Whole(values) => {
                    column.typed::<Int64Type>().write_batch(values, None, None)?;
                }
                Values::Real(values) => {
                    column.typed::<DoubleType>().write_batch(values, None, None)?;
                }
                Values::Text(values) => {
                    let values: Vec<ByteArray> =
                        values.iter().map(|text| ByteArray::from(text.as_str())).collect();
                    column.typed::<ByteArrayType>().write_batch(&values, None, None)?;
                }
            }
            column.close()?;
        }
        group.close()?;
        // What the writer still keeps belongs to this block.
        writer.flush()?;
        writer.inner_mut().end_block();
        Ok(())
    }
}

/// The columns as a schema of Parquet.
fn schema(columns: &[Column]) -> Result<Arc<Type>, TableError> {
    let fields = columns
        .iter()
        .map(|column| {
            let (physical, logical) = match column.kind {
                Kind::Whole => (Physical::INT64, None),
                Kind::Real => (Physical::DOUBLE, None),
                Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            };
            let field = Type::primitive_type_builder(&column.name, physical)
                .with_repetition(Repetition::REQUIRED)
                .with_logical_type(logical)
                .build()?;
            Ok(Arc::new(field))
        })
        .collect::<Result<Vec<_>, TableError>>()?;
    Ok(Arc::new(Type::group_type_builder("table").with_fields(fields).build()?))
}
