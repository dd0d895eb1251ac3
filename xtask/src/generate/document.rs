//! A drawing as a picture of its own, with the styles of the report's figures.

use super::pen::{Pen, escape};

/// The styles of the report's figures, light and dark.
const STYLE: &str = include_str!("../../../crates/report/templates/figure.css");
/// What sketches and curves of the theory add: larger words, symbols as the formulas have them.
const SKETCH: &str = "svg.figure { font-size: 15px; }\n\
     .figure .remark { font-size: 14px; }\n\
     .figure .symbol { font: italic 19px \"STIX Two Text\", Cambria, \"Latin Modern Roman\", \"Times New Roman\", serif; }\n\
     .figure .index { font-size: 72%; }\n\
     .figure .hatch { stroke: var(--mid); stroke-width: 1; }\n\
     .figure .film { fill: var(--c1); fill-opacity: 0.22; stroke: none; }\n";

/// Where a picture of the theory stands in the repository.
pub fn file_of(name: &str) -> String {
    format!("docs/src/images/theory/{name}.svg")
}

/// A drawing with its name, its title, what it says to readers who cannot see it, and its size [px].
pub fn document(pen: Pen, name: &str, title: &str, says: &str, (width, height): (f64, f64)) -> String {
    let (title, says, body) = (escape(title), escape(says), pen.into_body());
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" aria-labelledby=\"{name}-title {name}-desc\">\n\
         <title id=\"{name}-title\">{title}</title>\n<desc id=\"{name}-desc\">{says}</desc>\n\
         <style>\n{STYLE}{SKETCH}</style>\n<rect class=\"sheet\" width=\"100%\" height=\"100%\"/>\n{body}</svg>\n"
    )
}
