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

/// What a plot shows besides its curves, and how its axes lie.
#[derive(Default, Clone, Copy)]
pub(crate) struct Extras<'a> {
    /// Name of all rays in the legend.
    pub together: &'a str,
    /// Straight lines from the origin to points in SI, each with its own name at its end.
    pub rays: &'a [(String, (f64, f64))],
    /// Whether the axes follow the values though 0 is not among them.
    pub fits: bool,
    /// Lines across the plot at abscissae in SI, with the number of each.
    pub events: &'a [(f64, usize)],
}

impl XyPlot<'_> {
    /// Draws it.
    pub fn panel(&self) -> Panel {
        self.panel_with(&Extras::default())
    }

    /// How many times as large as it is a path is drawn by [`XyPlot::polar`], at 96 px to the inch.
    pub fn magnification(&self) -> f64 {
        const PIXEL: f64 = 0.0254 / 96.0;
        let parts = self.curves.iter().flat_map(|curve| &curve.points).flat_map(|(x, y)| [x.abs(), y.abs()]);
        let reach = parts.filter(|value| value.is_finite()).fold(self.polar.unwrap_or(0.0), f64::max);
        let scale = Scale::of(reach, self.units[0]);
        let axis = Axis::of(-reach / scale.divisor, reach / scale.divisor, 6);
        (WIDTH - LEFT - RIGHT) * PIXEL / ((axis.high - axis.low) * scale.divisor)
    }

    /// The same with straight lines from the origin to points in SI, each with its own name at its end and all with one in the legend.
    pub fn panel_with_rays(&self, together: &str, rays: &[(String, (f64, f64))]) -> Panel {
        self.panel_with(&Extras { together, rays, ..Extras::default() })
    }

    /// The same with whatever is asked for.
    pub fn panel_with(&self, extras: &Extras<'_>) -> Panel {
        let Extras { together, rays, fits, events } = *extras;
        let ends = || rays.iter().map(|(_, end)| *end);
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter().copied()).chain(ends());
        let is_empty = self.curves.iter().all(|curve| curve.points.is_empty());
        let from = if fits && !is_empty { (f64::INFINITY, f64::NEG_INFINITY) } else { (0.0f64, 0.0f64) };
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values.filter(|v| v.is_finite()).fold(from, |(low, high), v| (low.min(v), high.max(v)))
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
        let mut marks: Vec<(f64, usize)> = events
            .iter()
            .map(|(at, number)| (x_axis.place(at / x_scale.divisor, LEFT, right), *number))
            .filter(|(x, _)| (LEFT - 0.5..=right + 0.5).contains(x))
            .collect();
        marks.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (x, _) in &marks {
            svg.line("thin dashed", (*x, top), (*x, bottom));
        }
        // Numbers whose labels would run into one another are one label.
        let mut labels: Vec<(f64, Vec<usize>)> = Vec::new();
        for (x, number) in marks {
            match labels.last_mut() {
                Some((first, numbers)) if x < *first + APART + text_width(&joined(numbers), 12.0) => {
                    numbers.push(number);
                }
                _ => labels.push((x, vec![number])),
            }
        }
        for (x, numbers) in labels {
            svg.text("small strong halo", (x + 3.0, top + 12.0), Anchor::Start, &joined(&numbers));
        }
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

/// Least distance from a label of lines to the next [px].
const APART: f64 = 8.0;

/// Numbers of lines in a label: "4", "6 7", "8\u{2013}13".
fn joined(numbers: &[usize]) -> String {
    match numbers {
        [first, _, .., last] if last - first + 1 == numbers.len() => format!("{first}\u{2013}{last}"),
        _ => numbers.iter().map(usize::to_string).collect::<Vec<_>>().join(" "),
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
    fn an_axis_that_fits_leaves_zero_out_and_events_have_one_label_where_they_are_close() {
        let curve = XyCurve {
            name: "speed".into(),
            style: 0,
            points: (0..=100).map(|k| (f64::from(k) / 100.0, 2000.0 + f64::from(k % 10))).collect(),
            dots: false,
        };
        let plot = XyPlot {
            abscissa: "time",
            ordinate: "speed",
            units: ["s", "rpm"],
            polar: None,
            curves: vec![curve],
        };
        let events = [(0.1, 1), (0.5, 2), (0.51, 3), (0.52, 4), (3.0, 5)];
        let drawn = |fits| {
            let figure = crate::kit::figure::Figure {
                id: "x".into(),
                title: String::new(),
                caption: String::new(),
                panels: vec![plot.panel_with(&Extras { fits, events: &events, ..Extras::default() })],
                columns: 1,
            };
            figure.svg()
        };
        let (fitted, plain) = (drawn(true), drawn(false));
        // A ripple of half a per cent fills the height; with 0 it would be a line.
        assert!(fitted.contains(">2010<") && !fitted.contains(">500<"), "{fitted}");
        assert!(plain.contains(">500<") && !plain.contains(">2002<"), "{plain}");
        // Three close events have one label, and one beyond the curve has none.
        assert!(fitted.contains(">2\u{2013}4<") && !fitted.contains(">5<"), "{fitted}");
    }

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
