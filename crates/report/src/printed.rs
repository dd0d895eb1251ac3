//! What a command prints, in the units of the United States: texts and tables of CSV that are already set, with every
//! quantity converted. Results themselves are SI and stay so.

mod csv;
mod layout;
mod sentence;
mod text;

pub use csv::csv_in_us_units;
pub use text::text_in_us_units;
