//! Curves of one quantity over another: p-V diagrams, power over speed, polar diagrams.

use crate::axis::Axis;
use crate::figure::Panel;
use crate::number::{self, Scale};
use crate::plot::{BOTTOM, HEIGHT, LEFT, Legend, RIGHT, WIDTH, value_axis};
use crate::svg::{Anchor, Path, Svg};

/// One curve, or dots where `dots`.
pub(crate) struct XyCurve {
    pub name: String,
    /// As in [`crate::plot::Series`].
    pub style: usize,
    /// In SI.
    pub points: Vec<(f64, f64)>,
    pub dots: bool,
}

/// A plot with both axes in SI units.
pub(crate) struct XyPlot<'a> {
    pub abscissa: &'a str,
    pub ordinate: &'a str,
    pub units: [&'a str; 2],
    /// One scale and one length for both axes: a polar diagram.
    pub polar: bool,
    pub curves: Vec<XyCurve>,
}

impl XyPlot<'_> {
    /// Draws it.
    pub fn panel(&self) -> Panel {
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter().copied());
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values
                .filter(|v| v.is_finite())
                .fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
        };
        let mut x_range = range(&mut all().map(|p| p.0));
        let mut y_range = range(&mut all().map(|p| p.1));
        if self.polar {
            let reach =
                [x_range.0, x_range.1, y_range.0, y_range.1].iter().fold(0.0f64, |m, v| m.max(v.abs()));
            (x_range, y_range) = ((-reach, reach), (-reach, reach));
        }
        let largest = |range: (f64, f64)| range.1.max(-range.0);
        let [x_scale, y_scale] =
            [Scale::of(largest(x_range), self.units[0]), Scale::of(largest(y_range), self.units[1])];
        let x_axis = Axis::of(x_range.0 / x_scale.divisor, x_range.1 / x_scale.divisor, 6);
        let y_axis = Axis::of(y_range.0 / y_scale.divisor, y_range.1 / y_scale.divisor, 6);
        let names: Vec<(String, usize)> =
            self.curves.iter().filter(|c| !c.dots).map(|c| (c.name.clone(), c.style)).collect();
        let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
        let top = 26.0 + legend.height;
        let plot = if self.polar { WIDTH - LEFT - RIGHT } else { HEIGHT - 26.0 - BOTTOM };
        let mut svg = Svg::new(WIDTH, top + plot + BOTTOM);
        let (right, bottom) = (WIDTH - RIGHT, top + plot);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.ordinate, y_scale.unit));
        legend.draw(&mut svg);
        value_axis(&mut svg, &y_axis, top, bottom);
        for &tick in &x_axis.ticks {
            let x = x_axis.place(tick, LEFT, right);
            let class = if tick.abs() < 1e-9 * x_axis.step() { "zero" } else { "grid" };
            svg.line(class, (x, top), (x, bottom));
            svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::fixed(tick, x_axis.decimals));
        }
        let middle = ((LEFT + right) / 2.0, bottom + 37.0);
        svg.text("muted small", middle, Anchor::Middle, &format!("{} [{}]", self.abscissa, x_scale.unit));
        for curve in self.curves.iter().rev() {
            let place = |&(x, y): &(f64, f64)| {
                (
                    x_axis.place(x / x_scale.divisor, LEFT, right),
                    y_axis.place(y / y_scale.divisor, bottom, top),
                )
            };
            if curve.dots {
                curve.points.iter().for_each(|point| svg.circle("pin", place(point), 4.0));
            } else {
                svg.path(&format!("s{}", curve.style.min(5)), &Path::through(curve.points.iter().map(place)));
            }
        }
        let said: Vec<&str> = self.curves.iter().map(|c| c.name.as_str()).collect();
        let description = format!(
            "{} over {}: {}; from {} to {} {}.",
            self.ordinate,
            self.abscissa,
            said.join(", "),
            number::short(y_range.0 / y_scale.divisor, 4),
            number::short(y_range.1 / y_scale.divisor, 4),
            y_scale.unit
        );
        Panel::new(svg, description)
    }
}
