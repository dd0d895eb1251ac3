//! Line plots and bar plots.

use crate::kit::axis::Axis;
use crate::kit::figure::Panel;
use crate::kit::number::{self, Scale};
use crate::kit::svg::{Anchor, Path, Svg, text_width};

/// Natural width of a plot [px].
pub const WIDTH: f64 = 440.0;
pub(crate) const HEIGHT: f64 = 290.0;
pub(crate) const LEFT: f64 = 60.0;
pub(crate) const RIGHT: f64 = 14.0;
pub(crate) const BOTTOM: f64 = 44.0;
const LEGEND_ROW: f64 = 19.0;

/// One curve.
#[derive(Debug, Clone)]
pub struct Series<'a> {
    /// Name in the legend.
    pub name: String,
    /// Line style: 0 the sum (thick, solid), 1 to 5 its parts (each its own colour and dashes).
    pub style: usize,
    /// Values in SI, one an abscissa.
    pub values: &'a [f64],
}

/// A plot of several curves over the crank angle.
#[derive(Debug, Clone)]
pub struct AnglePlot<'a> {
    /// What the ordinate is: "Force F_x".
    pub quantity: &'a str,
    /// Its SI unit.
    pub unit: &'a str,
    /// Crank angles [rad], evenly spaced from 0, end point excluded.
    pub theta: &'a [f64],
    /// Period [rad].
    pub period: f64,
    /// Curves; the first lies on top.
    pub series: Vec<Series<'a>>,
}

impl AnglePlot<'_> {
    /// Draws the plot.
    pub fn panel(&self) -> Panel {
        self.panel_with_marks(&[])
    }

    /// Draws the plot with dots at these crank angles [rad] and values.
    pub fn panel_with_marks(&self, marks: &[(f64, f64)]) -> Panel {
        let finite = self.series.iter().flat_map(|s| s.values.iter().copied()).filter(|v| v.is_finite());
        let (low, high) = finite.fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
        let scale = Scale::of(high.max(-low), self.unit);
        let axis = Axis::of(low / scale.divisor, high / scale.divisor, 6);
        let turns = (self.period / std::f64::consts::TAU).round().max(1.0);
        let angles = Axis::stepped(0.0, 360.0 * turns, 90.0 * (turns / 2.0).ceil());

        let legend = Legend::of(&self.names(), 4.0, WIDTH + 10.0);
        let top = 26.0 + legend.height;
        let mut svg = Svg::new(WIDTH, HEIGHT + legend.height);
        let (right, bottom) = (WIDTH - RIGHT, svg.height - BOTTOM);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.quantity, scale.unit));
        legend.draw(&mut svg);
        value_axis(&mut svg, &axis, top, bottom);
        for &tick in &angles.ticks {
            let x = angles.place(tick, LEFT, right);
            svg.line("grid", (x, top), (x, bottom));
            svg.text("small", (x, bottom + 17.0), Anchor::Middle, &format!("{tick:.0}"));
        }
        svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, "crank angle θ [deg]");
        for series in self.series.iter().rev() {
            let path = self.curve(series, |degrees, value| {
                (angles.place(degrees, LEFT, right), axis.place(value / scale.divisor, bottom, top))
            });
            svg.path(&format!("s{}", series.style.min(5)), &path);
        }
        for &(theta, value) in marks {
            let x = angles.place(theta.to_degrees(), LEFT, right);
            svg.circle("pin", (x, axis.place(value / scale.divisor, bottom, top)), 4.0);
        }
        let names: Vec<&str> = self.series.iter().map(|s| s.name.as_str()).collect();
        let description = format!(
            "{} over the crank angle from 0 to {:.0} degrees: {}; from {} to {} {}.",
            self.quantity,
            360.0 * turns,
            names.join(", "),
            number::short(low / scale.divisor, 4),
            number::short(high / scale.divisor, 4),
            scale.unit
        );
        Panel::new(svg, description)
    }

    fn names(&self) -> Vec<(String, usize)> {
        self.series.iter().map(|s| (s.name.clone(), s.style)).collect()
    }

    /// At most 361 points: more would not be seen; the period is closed with its first point.
    fn curve(&self, series: &Series<'_>, place: impl Fn(f64, f64) -> (f64, f64)) -> Path {
        let count = self.theta.len().min(series.values.len());
        let stride = count.div_ceil(360).max(1);
        let points = (0..count).step_by(stride).map(|k| place(self.theta[k].to_degrees(), series.values[k]));
        let closing = series.values.first().map(|&v| place(self.period.to_degrees(), v));
        Path::through(points.chain(closing))
    }
}

/// Horizontal grid, zero line and tick labels.
pub(crate) fn value_axis(svg: &mut Svg, axis: &Axis, top: f64, bottom: f64) {
    let right = svg.width - RIGHT;
    for &tick in &axis.ticks {
        let y = axis.place(tick, bottom, top);
        let zero = tick.abs() < 1e-9 * axis.step();
        svg.line(if zero { "zero" } else { "grid" }, (LEFT, y), (right, y));
        svg.text("small", (LEFT - 6.0, y + 4.0), Anchor::End, &number::fixed(tick, axis.decimals));
    }
}

/// The label of a tick below an axis, from its end; one that would be cut off ends with the drawing.
pub(crate) fn tick_below(svg: &mut Svg, (x, bottom): (f64, f64), text: &str) {
    let is_cut = x + 0.5 * text_width(text, 11.5) > svg.width;
    let (at, anchor) = if is_cut { (svg.width, Anchor::End) } else { (x, Anchor::Middle) };
    svg.text("small", (at, bottom + 17.0), anchor, text);
}

/// Rows of line samples with names, above the plot so that they never cover data.
pub(crate) struct Legend {
    entries: Vec<(String, usize, (f64, f64))>,
    pub(crate) height: f64,
}

impl Legend {
    /// Names with their line styles, in rows from `left` up to `width`; one name alone needs no legend.
    pub(crate) fn of(names: &[(String, usize)], left: f64, width: f64) -> Legend {
        if names.len() < 2 {
            return Legend { entries: Vec::new(), height: 0.0 };
        }
        let mut entries = Vec::with_capacity(names.len());
        let (mut x, mut y) = (left, 32.0);
        for (name, style) in names {
            let length = 34.0 + text_width(name, 14.0) + 12.0;
            if x + length > width && x > left {
                (x, y) = (left, y + LEGEND_ROW);
            }
            entries.push((name.clone(), *style, (x, y)));
            x += length;
        }
        Legend { entries, height: y - 32.0 + LEGEND_ROW }
    }

    pub(crate) fn draw(&self, svg: &mut Svg) {
        for (name, style, (x, y)) in &self.entries {
            svg.line(&format!("s{}", style.min(&5)), (*x, y - 4.0), (x + 28.0, y - 4.0));
            svg.text("small", (x + 34.0, *y), Anchor::Start, name);
        }
    }
}

/// One bar of a [`BarPlot`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Where it stands.
    pub at: f64,
    /// Its height in SI, not negative.
    pub value: f64,
}

/// Bars over numbered cases.
#[derive(Debug, Clone)]
pub struct CaseBars<'a> {
    /// What the ordinate is.
    pub quantity: &'a str,
    /// Its SI unit.
    pub unit: &'a str,
    /// What a case is called.
    pub case: &'a str,
    /// One bar a case, side by side, named by its number.
    pub bars: Vec<Bar>,
    /// A level to compare with: its name and value.
    pub level: Option<(&'a str, f64)>,
}

impl CaseBars<'_> {
    /// Draws the bars, each with its value.
    pub fn panel(&self) -> Panel {
        let heights = self.bars.iter().map(|b| b.value).chain(self.level.map(|(_, value)| value));
        let largest = heights.filter(|v| v.is_finite()).fold(0.0f64, f64::max);
        let scale = Scale::of(largest, self.unit);
        let axis = Axis::of(0.0, if largest > 0.0 { 1.06 * largest / scale.divisor } else { 1.0 }, 5);
        let cases = Axis::stepped(-0.6, self.bars.len() as f64 - 0.4, 1.0);
        let mut svg = Svg::new(WIDTH, HEIGHT);
        let (right, top, bottom) = (WIDTH - RIGHT, 36.0, HEIGHT - BOTTOM);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.quantity, scale.unit));
        value_axis(&mut svg, &axis, top, bottom);
        let mut said = Vec::with_capacity(self.bars.len());
        for (index, bar) in self.bars.iter().enumerate() {
            let x = cases.place(index as f64, LEFT, right);
            let y = axis.place(bar.value / scale.divisor, bottom, top);
            let value = number::short(bar.value / scale.divisor, 3);
            svg.rect("bar1", x - 12.0, y, 24.0, bottom - y);
            svg.text("small halo", (x, y - 5.0), Anchor::Middle, &value);
            svg.text("small", (x, bottom + 17.0), Anchor::Middle, &number::order(bar.at));
            said.push(format!("{} {value}", number::order(bar.at)));
        }
        if let Some((name, value)) = self.level {
            let y = axis.place(value / scale.divisor, bottom, top);
            svg.line("limit", (LEFT, y), (right, y));
            svg.text("small halo", (right, y - 5.0), Anchor::End, name);
            said.push(format!("{name} {}", number::short(value / scale.divisor, 3)));
        }
        svg.text("muted small", ((LEFT + right) / 2.0, bottom + 37.0), Anchor::Middle, self.case);
        Panel::new(svg, format!("{} [{}] by {}: {}.", self.quantity, scale.unit, self.case, said.join("; ")))
    }
}

/// Bars over orders.
#[derive(Debug, Clone)]
pub struct BarPlot<'a> {
    /// What the ordinate is.
    pub quantity: &'a str,
    /// Its SI unit.
    pub unit: &'a str,
    /// Bars; those at negative places turn against the crank.
    pub bars: Vec<Bar>,
    /// Bars below this are nothing.
    pub noise: f64,
    /// Both senses, so that zero is the middle.
    pub two_sided: bool,
}

impl BarPlot<'_> {
    /// Draws the plot. Bars too small to be seen are left to the table.
    pub fn panel(&self) -> Panel {
        let bars: Vec<Bar> =
            self.bars.iter().copied().filter(|b| b.value.is_finite() && b.value > self.noise).collect();
        let largest = bars.iter().fold(0.0f64, |m, b| m.max(b.value));
        let shown: Vec<Bar> = bars.into_iter().filter(|b| b.value >= 1e-3 * largest).collect();
        let reach = shown.iter().fold(4.0f64, |m, b| m.max(b.at.abs()));
        let scale = Scale::of(largest, self.unit);
        let axis = Axis::of(0.0, if largest > 0.0 { 1.06 * largest / scale.divisor } else { 1.0 }, 5);
        let low = if self.two_sided { -reach - 0.6 } else { -0.4 };
        let step = (reach / 8.0).ceil().max(1.0);
        let orders = Axis::stepped(low, reach + 0.6, step);

        let mut svg = Svg::new(WIDTH, HEIGHT);
        let (right, top, bottom) = (WIDTH - RIGHT, 52.0, HEIGHT - 56.0);
        svg.text("muted small", (4.0, 13.0), Anchor::Start, &format!("{} [{}]", self.quantity, scale.unit));
        value_axis(&mut svg, &axis, top, bottom);
        let place = |at: f64| orders.place(at, LEFT, right);
        let half = (0.30 * (place(1.0) - place(0.0))).clamp(2.5, 11.0);
        if self.two_sided {
            svg.line("zero", (place(0.0), top - 6.0), (place(0.0), bottom));
            let quarter = (right - LEFT) / 4.0;
            svg.text("small", (place(0.0) - quarter, 34.0), Anchor::Middle, "\u{25c2} against the crank");
            svg.text("small", (place(0.0) + quarter, 34.0), Anchor::Middle, "with the crank \u{25b8}");
        }
        for &tick in &orders.ticks {
            svg.line("zero", (place(tick), bottom), (place(tick), bottom + 4.0));
            let fractional = |b: &&Bar| (b.at - tick).abs() > 1e-6 && (b.at - tick).abs() < 0.75;
            // Half and fractional orders are labelled themselves, a row below.
            for bar in shown.iter().filter(fractional).filter(|b| (b.at / step).fract().abs() > 1e-6) {
                svg.line("zero", (place(bar.at), bottom), (place(bar.at), bottom + 14.0));
            }
            svg.text("small", (place(tick), bottom + 17.0), Anchor::Middle, &number::order(tick));
        }
        for bar in shown.iter().filter(|b| (b.at / step).fract().abs() > 1e-6) {
            svg.text(
                "small strong halo",
                (place(bar.at), bottom + 29.0),
                Anchor::Middle,
                &number::order(bar.at),
            );
        }
        for bar in &shown {
            let class = match (self.two_sided, bar.at < 0.0) {
                (true, true) => "bar2",
                (true, false) => "bar1",
                _ => "bar3",
            };
            let y = axis.place(bar.value / scale.divisor, bottom, top);
            svg.rect(class, place(bar.at) - half, y, 2.0 * half, bottom - y);
        }
        if shown.is_empty() {
            let middle = ((LEFT + right) / 2.0, (top + bottom) / 2.0);
            svg.text("muted halo", middle, Anchor::Middle, "zero at every order");
        }
        self.values(&mut svg, &shown, &scale, |b| {
            (place(b.at), axis.place(b.value / scale.divisor, bottom, top))
        });
        svg.text(
            "muted small",
            ((LEFT + right) / 2.0, HEIGHT - 8.0),
            Anchor::Middle,
            "order [per revolution]",
        );
        Panel::new(svg, self.description(&shown, &scale))
    }

    /// Values over the bars, the largest first, where there is room.
    fn values(&self, svg: &mut Svg, bars: &[Bar], scale: &Scale, place: impl Fn(&Bar) -> (f64, f64)) {
        let mut order: Vec<&Bar> = bars.iter().collect();
        order.sort_by(|a, b| b.value.total_cmp(&a.value));
        let mut taken: Vec<(f64, f64, f64)> = Vec::new();
        for bar in order {
            let (x, y) = place(bar);
            let text = number::short(bar.value / scale.divisor, 3);
            let half = 0.5 * text_width(&text, 13.0) + 2.0;
            let clash = |&(other, level, other_half): &(f64, f64, f64)| {
                (other - x).abs() < half + other_half && (level - y).abs() < 14.0
            };
            let behind_bar = bars
                .iter()
                .any(|b| place(b).1 < y + 2.0 && (place(b).0 - x).abs() < half + 8.0 && b.at != bar.at);
            if taken.iter().any(clash) || behind_bar {
                continue;
            }
            taken.push((x, y, half));
            svg.text("small halo", (x, y - 5.0), Anchor::Middle, &text);
        }
    }

    fn description(&self, bars: &[Bar], scale: &Scale) -> String {
        if bars.is_empty() {
            return format!("{}: zero at every order.", self.quantity);
        }
        let mut list: Vec<String> = Vec::with_capacity(bars.len());
        for bar in bars {
            let sense = match (self.two_sided, bar.at < 0.0) {
                (false, _) => "",
                (true, true) => " against the crank",
                (true, false) => " with the crank",
            };
            let value = number::short(bar.value / scale.divisor, 3);
            list.push(format!("order {}{sense} {value} {}", number::order(bar.at.abs()), scale.unit));
        }
        format!("{} by order: {}.", self.quantity, list.join("; "))
    }
}
