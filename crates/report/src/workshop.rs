//! Tables and figures of the workshop.

mod bobweight;
mod correction;
mod crank;
mod crank_plot;
mod drilling;
mod factor;
mod grade;
mod mass;
mod primary_ellipse;
mod vibration_plot;

pub use bobweight::{bobweight_tables, bobweight_text};
pub use correction::{correction_tables, correction_text};
pub use crank::{crank_tables, crank_text, external_tables, external_text, internal_tables, internal_text};
pub use crank_plot::crank_figure;
pub use drilling::{drilling_tables, drilling_text};
pub use factor::{factor_tables, factor_text};
pub use grade::{grade_tables, grade_text};
pub use primary_ellipse::primary_ellipse_figure;
pub use vibration_plot::vibration_figure;
