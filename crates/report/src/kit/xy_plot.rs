//! Curves of one quantity over another: p-V diagrams, power over speed, polar diagrams.

use crate::kit::axis::Axis;
use crate::kit::figure::Panel;
use crate::kit::number::{self, Scale};
use crate::kit::plot::{BOTTOM, HEIGHT, LEFT, Legend, RIGHT, WIDTH, tick_below, value_axis};
use crate::kit::svg::{Anchor, Path, Svg, text_width};

/// One curve, or dots where `dots`.
pub(crate) struct XyCurve {
    pub name: String,
    /// As in [`crate::kit::plot::Series`].
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
    /// One scale and one length for both axes, which reach at least this far in SI: a polar diagram.
    pub polar: Option<f64>,
    pub curves: Vec<XyCurve>,
}

impl XyPlot<'_> {
    /// Draws it.
    pub fn panel(&self) -> Panel {
        self.panel_with_rays("", &[])
    }

    /// The same with straight lines from the origin to points in SI, each with its own name at its end and all with one in the legend.
    pub fn panel_with_rays(&self, together: &str, rays: &[(String, (f64, f64))]) -> Panel {
        let ends = || rays.iter().map(|(_, end)| *end);
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter().copied()).chain(ends());
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values
                .filter(|v| v.is_finite())
                .fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
        };
        let mut x_range = range(&mut all().map(|p| p.0));
        let mut y_range = range(&mut all().map(|p| p.1));
        if !rays.is_empty() {
            y_range.1 *= HEADROOM;
        }
        if let Some(least) = self.polar {
            let reach =
                [x_range.0, x_range.1, y_range.0, y_range.1].iter().fold(least, |m, v| m.max(v.abs()));
            (x_range, y_range) = ((-reach, reach), (-reach, reach));
        }
        let largest = |range: (f64, f64)| range.1.max(-range.0);
        let [x_scale, y_scale] =
            [Scale::of(largest(x_range), self.units[0]), Scale::of(largest(y_range), self.units[1])];
        let x_axis = Axis::of(x_range.0 / x_scale.divisor, x_range.1 / x_scale.divisor, 6);
        let y_axis = Axis::of(y_range.0 / y_scale.divisor, y_range.1 / y_scale.divisor, 6);
        let mut names: Vec<(String, usize)> =
            self.curves.iter().filter(|c| !c.dots).map(|c| (c.name.clone(), c.style)).collect();
        if !rays.is_empty() {
            names.push((together.to_owned(), RAY));
        }
        let legend = Legend::of(&names, 4.0, WIDTH + 10.0);
        let top = 26.0 + legend.height;
        let plot = if self.polar.is_some() { WIDTH - LEFT - RIGHT } else { HEIGHT - 26.0 - BOTTOM };
        let mut svg = Svg::new(WIDTH, top + plot + BOTTOM);
        let (right, bottom) = (WIDTH - RIGHT, top + plot);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.ordinate, y_scale.unit));
        legend.draw(&mut svg);
        value_axis(&mut svg, &y_axis, top, bottom);
        for &tick in &x_axis.ticks {
            let x = x_axis.place(tick, LEFT, right);
            let class = if tick.abs() < 1e-9 * x_axis.step() { "zero" } else { "grid" };
            svg.line(class, (x, top), (x, bottom));
            tick_below(&mut svg, (x, bottom), &number::fixed(tick, x_axis.decimals));
        }
        let middle = ((LEFT + right) / 2.0, bottom + 37.0);
        svg.text("muted small", middle, Anchor::Middle, &format!("{} [{}]", self.abscissa, x_scale.unit));
        let place = |&(x, y): &(f64, f64)| {
            (x_axis.place(x / x_scale.divisor, LEFT, right), y_axis.place(y / y_scale.divisor, bottom, top))
        };
        // Names above the ends from left to right, higher where they would run into the one before.
        let mut ends: Vec<(&str, (f64, f64))> =
            rays.iter().map(|(name, end)| (name.as_str(), place(end))).collect();
        ends.sort_by(|a, b| a.1.0.total_cmp(&b.1.0));
        let mut last = (f64::NEG_INFINITY, 0.0);
        for (name, to) in ends {
            svg.line(&format!("s{RAY}"), place(&(0.0, 0.0)), to);
            let half = 0.5 * text_width(name, 12.0);
            let is_free = to.0 - half > last.0 + 3.0;
            let raised = if is_free || last.1 > 0.0 { 0.0 } else { RAISED };
            svg.text("small", (to.0, to.1 - 4.0 - raised), Anchor::Middle, name);
            last = (to.0 + half, raised);
        }
        for curve in self.curves.iter().rev() {
            if curve.dots {
                curve.points.iter().for_each(|point| svg.circle("pin", place(point), 4.0));
            } else {
                let points: Vec<(f64, f64)> = curve.points.iter().map(place).collect();
                svg.path(&format!("s{}", curve.style.min(5)), &Path::through(thinned(&points)));
            }
        }
        let mut said: Vec<&str> = self.curves.iter().map(|c| c.name.as_str()).collect();
        if !rays.is_empty() {
            said.push(together);
            said.extend(rays.iter().map(|(name, _)| name.as_str()));
        }
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

/// Style of rays, height of the plot over its highest value with them, and how much higher a name stands beside another [px].
const RAY: usize = 5;
const HEADROOM: f64 = 1.12;
const RAISED: f64 = 11.0;

/// How far a curve may depart from the line through the points that are kept [px].
const DEPARTURE: f64 = 0.15;

/// The points without those that lie on the line between the others, as far as the eye can tell (Douglas and Peucker).
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept = vec![false; points.len()];
    let mut spans = vec![(0, points.len().saturating_sub(1))];
    if let Some(first) = kept.first_mut() {
        *first = true;
    }
    while let Some((from, to)) = spans.pop() {
        if let Some(last) = kept.get_mut(to) {
            *last = true;
        }
        let worst = (from + 1..to)
            .map(|k| (distance(points[k], points[from], points[to]), k))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((far, k)) = worst
            && (far > DEPARTURE || far.is_nan())
        {
            spans.extend([(from, k), (k, to)]);
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// Distance of a point from the straight piece between two others.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let along = (to.0 - from.0, to.1 - from.1);
    let off = (point.0 - from.0, point.1 - from.1);
    let square = along.0 * along.0 + along.1 * along.1;
    let share =
        if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (off.0 - share * along.0).hypot(off.1 - share * along.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_corners_and_shape() {
        let square = [(0.0, 0.0), (5.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 5.0), (0.0, 0.0)];
        let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)];
        assert_eq!(thinned(&square), corners);
        let circle: Vec<(f64, f64)> = (0..=360)
            .map(|k| f64::from(k).to_radians())
            .map(|t| (200.0 * t.cos(), 200.0 * t.sin()))
            .collect();
        let kept = thinned(&circle);
        assert!(kept.len() < 130, "{}", kept.len());
        let off = |p: &(f64, f64)| {
            kept.windows(2).map(|pair| distance(*p, pair[0], pair[1])).fold(f64::INFINITY, f64::min)
        };
        assert!(circle.iter().all(|p| off(p) <= DEPARTURE));
        assert_eq!((thinned(&[]).len(), thinned(&[(1.0, 2.0)]).len()), (0, 1));
    }
}
