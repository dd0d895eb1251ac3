//! Tables as engineers keep them: cells of CSV and of workbooks, from bytes and to bytes.
//!
//! ```
//! use lanchester_sheet::{Cell, read_csv, read_workbook, workbook};
//! let rows = read_csv("rod.length [mm],name\n140,short\n")?;
//! assert_eq!(rows[1].number, 2);
//! let bytes = workbook("cases", &["length [mm]".to_owned()], &[vec![Cell::Number(140.0)]])?;
//! assert_eq!(read_workbook(&bytes)?[1].cells, [Cell::Number(140.0)]);
//! # Ok::<(), lanchester_sheet::SheetError>(())
//! ```
#![forbid(unsafe_code)]

mod sheet;

pub use sheet::{Cell, Row, SheetError, read_csv, read_workbook, separator, workbook};
