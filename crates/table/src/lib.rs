//! Columns of results as Parquet and CSV, and back from Parquet.
//!
//! A table is a function of its rows and metadata alone: the bytes do not depend on the pieces in which the rows came. It keeps the SHA-256
//! of each of its row groups and of its footer, which are verified before anything is read from them. Nothing here
//! opens a file; tables are written into any sink and read from any source of bytes.
//!
//! ```
//! use lanchester_table::{Column, Form, Rows, TableReader, TableWriter, Values};
//! let columns = vec![Column::whole("case"), Column::real("force_N")];
//! let mut bytes = Vec::new();
//! let mut writer = TableWriter::new(Form::Parquet, &mut bytes, &columns)?;
//! writer.push(Rows::of(vec![Values::Whole(vec![0, 1]), Values::Real(vec![2.5, 0.0])]))?;
//! writer.finish(&[("note".to_owned(), "an example".to_owned())])?;
//! let mut reader = TableReader::open(lanchester_table::Bytes::from(bytes))?;
//! assert_eq!(reader.metadata("note"), Some("an example"));
//! assert_eq!(reader.next(&columns)?.map(|rows| rows.len()), Some(2));
//! # Ok::<(), lanchester_table::TableError>(())
//! ```
#![forbid(unsafe_code)]

mod column;
mod csv;
mod error;
mod reader;
mod seal;
mod writer;

pub use column::{Column, Kind, Rows, Values};
pub use error::TableError;
pub use parquet::file::reader::ChunkReader as Source;
pub use reader::{Bytes, TableReader};
pub use seal::{BLOCKS, SEAL, csv_seal};
pub use writer::{Form, TableWriter};
