//! A vector diagram of a published figure: arrows one after another, and their sum.

use crate::kit::figure::Panel;
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Svg};
use num_complex::Complex64;

const SIZE: f64 = 300.0;
const MARGIN: f64 = 46.0;
/// Distance of a name from the middle of its arrow [px].
const LABEL: f64 = 24.0;

/// Arrows one after another: the real part up, the imaginary part to the right.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedVectors {
    /// What they are.
    pub quantity: String,
    /// Their SI unit.
    pub unit: String,
    /// Names and arrows.
    pub arrows: Vec<(String, Complex64)>,
}

impl PublishedVectors {
    /// What is left of all of them.
    pub fn sum(&self) -> Complex64 {
        self.arrows.iter().map(|(_, arrow)| arrow).sum()
    }

    /// Draws them.
    pub fn panel(&self) -> Panel {
        let mut ends = vec![Complex64::default()];
        for (_, arrow) in &self.arrows {
            ends.push(ends[ends.len() - 1] + arrow);
        }
        let range = |of: fn(&Complex64) -> f64| {
            ends.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            })
        };
        let (up, right) = (range(|end| end.re), range(|end| end.im));
        let reach = (up.1 - up.0).max(right.1 - right.0);
        let pixels = if reach > 0.0 { (SIZE - 2.0 * MARGIN) / reach } else { 0.0 };
        let middle = Complex64::new(0.5 * (up.0 + up.1), 0.5 * (right.0 + right.1));
        let place = |end: Complex64| {
            (0.5 * SIZE + pixels * (end.im - middle.im), 0.5 * SIZE + 16.0 - pixels * (end.re - middle.re))
        };
        let largest = self.arrows.iter().map(|(_, arrow)| arrow.norm()).fold(0.0, f64::max);
        let scale = Scale::of(largest, &self.unit);
        let amount = |arrow: Complex64| {
            // What rounding leaves of arrows that close is nothing.
            let size = if arrow.norm() > 1e-9 * largest { arrow.norm() } else { 0.0 };
            format!("{} {}", number::short(size / scale.divisor, 4), scale.unit)
        };
        let mut svg = Svg::new(SIZE, SIZE + 32.0);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &self.quantity);
        let sum = self.sum();
        svg.arrow("arrow sum slim", place(ends[0]), place(sum), 13.0);
        let is_seen = |arrow: &Complex64| pixels * arrow.norm() >= 0.5;
        for ((_, arrow), from) in self.arrows.iter().zip(&ends) {
            svg.arrow("arrow a1", place(*from), place(from + arrow), 10.0);
        }
        for ((name, arrow), from) in self.arrows.iter().zip(&ends).filter(|((_, arrow), _)| is_seen(arrow)) {
            // Beside the arrow, on the side away from the middle.
            let (x, y) = place(from + 0.5 * arrow);
            let across = arrow * Complex64::new(0.0, 1.0 / arrow.norm());
            let away = from + 0.5 * arrow - middle;
            let side = if (across * away.conj()).re < 0.0 { -LABEL } else { LABEL };
            svg.text(
                "small halo",
                (x + side * across.im, y + 4.0 - 0.6 * side * across.re),
                Anchor::Middle,
                name,
            );
        }
        let said = format!("sum {}", amount(sum));
        svg.text("small", (0.5 * SIZE, SIZE + 26.0), Anchor::Middle, &said);
        let arrows: Vec<String> =
            self.arrows.iter().map(|(name, arrow)| format!("{name} {}", amount(*arrow))).collect();
        Panel::new(svg, format!("{}: {}; {said}.", self.quantity, arrows.join("; ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_closed_chain_has_no_sum_and_an_open_one_has_it() {
        let third = std::f64::consts::TAU / 3.0;
        let chain = |count: i32| PublishedVectors {
            quantity: "F".to_owned(),
            unit: "N".to_owned(),
            arrows: (0..count)
                .map(|k| (format!("cylinder {}", k + 1), Complex64::from_polar(2.0, third * f64::from(k))))
                .collect(),
        };
        assert!(chain(3).panel().description.ends_with("sum 0 N."), "{}", chain(3).panel().description);
        assert!(chain(2).panel().description.ends_with("sum 2.000 N."), "{}", chain(2).panel().description);
    }
}
