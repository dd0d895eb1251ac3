//! Tables and figures of the workshop.

mod grade;

pub use grade::{grade_tables, grade_text};
