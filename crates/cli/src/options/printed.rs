//! How texts and tables are printed.

use crate::failure::Failure;
use crate::format::Format;
use clap::{Args, ValueEnum};
use lanchester::report::{csv_in_us_units, text_in_us_units, words_before_tables};

/// What texts and CSV are printed with. JSON, Parquet and figures are SI whatever is asked for.
#[derive(Debug, Clone, Copy, Args)]
pub struct PrintedArguments {
    /// The answer alone, in a few lines; with `--format text`.
    #[arg(long)]
    pub brief: bool,
    /// Units of text and CSV; JSON, Parquet and figures stay SI. Numbers of a text keep the digits that they have.
    #[arg(long, value_enum, default_value_t = Units::Si)]
    pub units: Units,
}

/// Whether an answer is brief, where its numbers have no other units: shares, orders, derivatives by what the file writes in its own units.
#[derive(Debug, Clone, Copy, Args)]
pub struct BriefArguments {
    /// The answer alone, in a few lines; with `--format text`.
    #[arg(long)]
    pub brief: bool,
}

/// What stands between two tables of one CSV: behind the end of a line, an empty one.
const BETWEEN_TABLES: &str = "\r\n\r\n";

/// Systems of units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Units {
    /// N, N m, mm, kg, g mm, bar, MPa, J, kW.
    Si,
    /// lbf, lbf ft, in, lb, oz in, psi, ksi, ft lbf, hp.
    Us,
}

impl BriefArguments {
    /// Refuses a brief answer in a form that is no text.
    ///
    /// # Errors
    /// Where `--brief` is given for one.
    pub fn check(self, is_text: bool) -> Result<(), Failure> {
        match self.brief && !is_text {
            true => Err(Failure::input(
                "--brief is a form of text, and another --format is asked for",
                "leave one of both out",
            )),
            false => Ok(()),
        }
    }
}

impl PrintedArguments {
    /// Refuses a brief answer in a form that is no text.
    ///
    /// # Errors
    /// Where `--brief` is given for one.
    pub fn check(&self, is_text: bool) -> Result<(), Failure> {
        BriefArguments { brief: self.brief }.check(is_text)
    }

    /// A text: the brief one where that is asked for.
    pub fn text(&self, whole: impl FnOnce() -> String, brief: impl FnOnce() -> String) -> String {
        self.words(if self.brief { brief() } else { whole() })
    }

    /// A text that says its answer before its tables: with `--brief` that alone.
    pub fn led(&self, text: String) -> String {
        self.words(if self.brief { words_before_tables(&text) } else { text })
    }

    /// An answer in its form: a text that says its answer before its tables, tables of CSV with an empty line between them, JSON as it is.
    pub fn said(&self, format: Format, answer: String) -> String {
        match format {
            Format::Text => self.led(answer),
            Format::Csv => {
                let one = |table: &str| self.csv(table.trim_end_matches("\r\n").to_owned() + "\r\n");
                answer.split(BETWEEN_TABLES).map(one).collect::<Vec<_>>().join("\r\n")
            }
            Format::Json => answer,
        }
    }

    /// A text that has no brief form.
    pub fn words(&self, text: String) -> String {
        match self.units {
            Units::Si => text,
            Units::Us => text_in_us_units(&text),
        }
    }

    /// One table of CSV.
    pub fn csv(&self, csv: String) -> String {
        match self.units {
            Units::Si => csv,
            Units::Us => csv_in_us_units(&csv),
        }
    }
}
