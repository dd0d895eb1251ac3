//! Curves over one axis, from numbers that the program printed.

use super::pen::{Anchor, Pen, Point};

/// Width and height of a chart [px].
pub const SIZE: (f64, f64) = (480.0, 340.0);
const LEFT: f64 = 62.0;
const RIGHT: f64 = 462.0;
const BOTTOM: f64 = 282.0;
/// Height of a line of names.
const NAMES: f64 = 22.0;

/// One axis: what it is, its ends and its marks, in the unit that it names.
pub struct Axis<'a> {
    /// What it is, with its unit.
    pub says: &'a str,
    /// Its ends.
    pub ends: [f64; 2],
    /// Distance of two marks.
    pub step: f64,
    /// Decimals of their numbers.
    pub decimals: usize,
}

/// A curve, or dots.
pub struct Curve<'a> {
    /// Its name; empty where none is listed.
    pub name: &'a str,
    /// Its class: `s0` to `s5`; dots have one of a filled or open circle.
    pub class: &'a str,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// Dots of this radius [px] instead of a line.
    pub dots: Option<f64>,
}

/// Curves over two axes.
pub struct Chart<'a> {
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The vertical one.
    pub y: Axis<'a>,
    /// What is drawn, the first on top.
    pub curves: Vec<Curve<'a>>,
    /// Names beside curves: where they end, and what they say.
    pub labels: Vec<((f64, f64), &'a str)>,
}

impl Chart<'_> {
    /// Draws it.
    pub fn draw(&self, pen: &mut Pen) {
        let named = || self.curves.iter().filter(|curve| !curve.name.is_empty());
        let top = 38.0 + NAMES * named().count().div_ceil(2) as f64;
        let place = |(x, y): (f64, f64)| -> Point {
            let share = |axis: &Axis, v: f64| (v - axis.ends[0]) / (axis.ends[1] - axis.ends[0]);
            (LEFT + (RIGHT - LEFT) * share(&self.x, x), BOTTOM - (BOTTOM - top) * share(&self.y, y))
        };
        for mark in marks(&self.x) {
            let (x, _) = place((mark, self.y.ends[0]));
            pen.line(if mark == 0.0 { "zero" } else { "grid" }, (x, top), (x, BOTTOM));
            pen.remark((x, BOTTOM + 20.0), Anchor::Middle, &signed(mark, self.x.decimals));
        }
        for mark in marks(&self.y) {
            let (_, y) = place((self.x.ends[0], mark));
            pen.line(if mark == 0.0 { "zero" } else { "grid" }, (LEFT, y), (RIGHT, y));
            pen.remark((LEFT - 8.0, y + 5.0), Anchor::End, &signed(mark, self.y.decimals));
        }
        pen.remark((12.0, 20.0), Anchor::Start, self.y.says);
        pen.remark(((LEFT + RIGHT) / 2.0, BOTTOM + 44.0), Anchor::Middle, self.x.says);
        for (index, curve) in named().enumerate() {
            let left = if index % 2 == 0 { 12.0 } else { 246.0 };
            let height = 20.0 + NAMES * (1.0 + (index / 2) as f64);
            let sample = [(left, height - 5.0), (left + 34.0, height - 5.0)];
            match curve.dots {
                Some(radius) => pen.circle(curve.class, (left + 17.0, height - 5.0), radius),
                None => pen.chain(curve.class, &sample),
            }
            pen.words((left + 42.0, height), Anchor::Start, curve.name);
        }
        for curve in self.curves.iter().rev() {
            let points: Vec<Point> = curve.points.iter().map(|point| place(*point)).collect();
            match curve.dots {
                Some(radius) => points.iter().for_each(|point| pen.circle(curve.class, *point, radius)),
                None => pen.chain(curve.class, &points),
            }
        }
        for (point, label) in &self.labels {
            let (x, y) = place(*point);
            pen.words((x, y - 8.0), Anchor::End, label);
        }
    }
}

fn marks(axis: &Axis) -> Vec<f64> {
    let first = (axis.ends[0] / axis.step - 1e-9).ceil() as i64;
    let last = (axis.ends[1] / axis.step + 1e-9).floor() as i64;
    (first..=last).map(|k| k as f64 * axis.step).collect()
}

/// A number with a true minus sign.
fn signed(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}").replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_reach_both_ends() {
        let axis = Axis { says: "", ends: [-0.2, 0.4], step: 0.1, decimals: 1 };
        let texts: Vec<String> = marks(&axis).into_iter().map(|mark| signed(mark, 1)).collect();
        assert_eq!(texts, ["−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3", "0.4"]);
    }
}
