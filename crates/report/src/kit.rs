//! What every topic draws and writes with: numbers, tables, figures, plots and drawings.

pub(crate) mod axis;
pub(crate) mod csv;
pub(crate) mod dimension;
pub(crate) mod figure;
pub(crate) mod flow;
pub(crate) mod magnitude;
pub(crate) mod number;
pub(crate) mod paragraph;
pub(crate) mod plot;
pub(crate) mod polar;
pub(crate) mod rounding;
pub(crate) mod section;
pub(crate) mod sheet;
pub(crate) mod svg;
pub(crate) mod table;
pub(crate) mod tornado;
pub(crate) mod us_unit;
pub(crate) mod view;
pub(crate) mod xy_plot;

pub use csv::{motion_csv, orders_csv, trace_csv};
pub use figure::{Figure, Panel};
pub use section::{Part, Section};
pub use svg::escape;
pub use table::{Cell, Column, Table, csv_text};
pub use tornado::tornado_figure;
