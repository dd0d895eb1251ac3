//! Dimension lines of a technical drawing, in millimetres.

use crate::kit::number;
use crate::kit::svg::{Anchor, Svg, text_width};

/// Size of the figures [px].
const FONT: f64 = 12.5;
/// Length of an arrow head [px].
const HEAD: f64 = 7.0;
/// How far an extension line reaches beyond its dimension line [px].
const BEYOND: f64 = 4.0;

/// A length as drawings have it: millimetres, at most two decimals, no zeros at the end.
pub(crate) fn millimetres(length: f64) -> String {
    let text = number::fixed(1e3 * length, 2);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// A vertical dimension at `x` between two heights on the screen; extension lines come from `from`, one for each height.
pub(crate) fn vertical(svg: &mut Svg, x: f64, heights: [f64; 2], from: [f64; 2], label: &str) {
    for (height, start) in heights.into_iter().zip(from) {
        let towards = (x - start).signum();
        svg.line("dimension", (start + 3.0 * towards, height), (x + BEYOND * towards, height));
    }
    let [low, high] = [heights[0].max(heights[1]), heights[0].min(heights[1])];
    let middle = (low + high) / 2.0;
    let half_text = 0.5 * text_width(label, FONT);
    if low - high > 2.0 * HEAD + FONT + 6.0 {
        // The line is broken for the figure.
        svg.arrow("arrow measure", (x, middle + 0.7 * FONT), (x, low), HEAD);
        svg.arrow("arrow measure", (x, middle - 0.7 * FONT), (x, high), HEAD);
        svg.text("halo", (x, middle + 0.35 * FONT), Anchor::Middle, label);
    } else {
        svg.arrow("arrow measure", (x, low + 3.0 * HEAD), (x, low), HEAD);
        svg.arrow("arrow measure", (x, high - 3.0 * HEAD), (x, high), HEAD);
        svg.line("dimension", (x, low), (x, high));
        let side = if from[0] > x { -1.0 } else { 1.0 };
        svg.text("halo", (x + side * (half_text + 6.0), middle + 0.35 * FONT), Anchor::Middle, label);
    }
}

/// A horizontal dimension at height `y` between two places; extension lines come from `from`, one for each place.
pub(crate) fn horizontal(svg: &mut Svg, y: f64, places: [f64; 2], from: [f64; 2], label: &str) {
    for (place, start) in places.into_iter().zip(from) {
        let towards = (y - start).signum();
        svg.line("dimension", (place, start + 3.0 * towards), (place, y + BEYOND * towards));
    }
    let [left, right] = [places[0].min(places[1]), places[0].max(places[1])];
    let width = text_width(label, FONT);
    if right - left > width + 2.0 * HEAD + 12.0 {
        let middle = (left + right) / 2.0;
        svg.arrow("arrow measure", (middle - 0.5 * width - 4.0, y), (left, y), HEAD);
        svg.arrow("arrow measure", (middle + 0.5 * width + 4.0, y), (right, y), HEAD);
        svg.text("halo", (middle, y + 0.35 * FONT), Anchor::Middle, label);
    } else {
        svg.arrow("arrow measure", (left - 3.0 * HEAD, y), (left, y), HEAD);
        svg.arrow("arrow measure", (right + 3.0 * HEAD, y), (right, y), HEAD);
        svg.line("dimension", (left, y), (right, y));
        svg.text("halo", (right + 3.0 * HEAD + 4.0, y + 0.35 * FONT), Anchor::Start, label);
    }
}

/// A leader with an arrow at `tip`, its label beyond `end` on the side that it comes from.
pub(crate) fn leader(svg: &mut Svg, tip: (f64, f64), end: (f64, f64), label: &str) {
    let side = if end.0 >= tip.0 { 1.0 } else { -1.0 };
    let shoulder = (end.0 + side * 8.0, end.1);
    svg.arrow("arrow measure", end, tip, HEAD);
    svg.line("dimension", end, shoulder);
    let anchor = if side > 0.0 { Anchor::Start } else { Anchor::End };
    svg.text("halo", (shoulder.0 + side * 3.0, shoulder.1 + 0.35 * FONT), anchor, label);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_no_needless_zeros() {
        assert_eq!(millimetres(0.0785), "78.5");
        assert_eq!(millimetres(0.02), "20");
        assert_eq!(millimetres(0.001_234_6), "1.23");
        assert_eq!(millimetres(0.1), "100");
        assert_eq!(millimetres(0.0), "0");
    }
}
