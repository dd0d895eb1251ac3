//! Tables and figures of the workshop.

mod factor;
mod grade;
mod mass;
mod primary_ellipse;

pub use factor::{factor_tables, factor_text};
pub use grade::{grade_tables, grade_text};
pub use primary_ellipse::primary_ellipse_figure;
