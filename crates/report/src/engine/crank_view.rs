//! The crank with its webs, weights and balance shafts, from the side and from above, at theta = 0.
//!
//! As the geometry plot of the matrix-based crankshaft balancing tool, Applied Sciences 2021, 11, 8997, Figures 11
//! and 14.

use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg};
use crate::kit::view::side;
use lanchester_model::{Engine, Throw};
use num_complex::Complex64;

const WIDTH: f64 = 440.0;
const MARGIN: f64 = 26.0;
const STRIP: f64 = 58.0;

/// Which plane is seen: x up from the side, y up or down from above.
#[derive(Clone, Copy, PartialEq)]
enum Plane {
    Side,
    Above,
}

/// From (z, height) [m] to the screen.
struct Sheet {
    left: f64,
    axis: f64,
    z0: f64,
    scale: f64,
    plane: Plane,
    /// 1 if +y points down from above (it does where +y points right from the free end).
    down: f64,
}

impl Sheet {
    /// Height of a direction in this plane, upwards on the screen.
    fn up(&self, vector: Complex64) -> f64 {
        match self.plane {
            Plane::Side => vector.re,
            Plane::Above => -self.down * vector.im,
        }
    }

    fn z(&self, z: f64) -> f64 {
        self.left + (z - self.z0) * self.scale
    }
}

/// The crank, or the cranks, with everything that turns with and beside them; `None` for an engine without weights.
pub fn crank_view(engine: &Engine) -> Option<Figure> {
    if engine.counterweights.is_empty() && engine.shafts.is_empty() {
        return None;
    }
    let mut panels = Vec::new();
    for index in 0..engine.crankshafts.len() {
        if engine.throws.iter().any(|t| t.crankshaft == index) {
            panels.extend([Plane::Side, Plane::Above].map(|plane| panel(engine, index, plane)));
        }
    }
    let mut caption = "At θ = 0, free end left. Every weight reaches out as the root of its unbalance does; one that points \
                       at the reader or away shows as a low block."
        .to_owned();
    if !engine.shafts.is_empty() {
        caption += " Balance shafts are drawn below one another, not at their places (the view from the free end shows \
                    those), their weights to a scale of their own.";
    }
    Some(Figure {
        id: "crank-view".to_owned(),
        title: "Crank, counterweights and balance shafts".to_owned(),
        caption,
        panels,
        columns: 2,
    })
}

fn panel(engine: &Engine, index: usize, plane: Plane) -> Panel {
    let throws: Vec<usize> =
        (0..engine.throws.len()).filter(|&t| engine.throws[t].crankshaft == index).collect();
    let radius = throws.iter().fold(0.0f64, |m, &t| m.max(engine.throws[t].radius));
    let gap = spacing(engine, &throws, radius);
    let shafts = if index == 0 { engine.shafts.len() } else { 0 };
    let planes = throws.iter().map(|&t| engine.throws[t].z);
    let weights = engine.counterweights.iter().filter(|w| w.crankshaft == index).map(|w| w.z);
    let on_shafts = engine.shafts[..shafts].iter().flat_map(|s| &s.weights).map(|w| w.z);
    let (low, high) = planes
        .chain(weights)
        .chain(on_shafts)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    let (low, high) = (low - 0.7 * gap, high + 0.7 * gap);
    let scale = ((WIDTH - 2.0 * MARGIN) / (high - low)).min(52.0 / radius);
    let reach = 1.75 * radius * scale;
    let axis = 24.0 + reach;
    let sheet = Sheet {
        left: 0.5 * WIDTH - 0.5 * (high - low) * scale,
        axis,
        z0: low,
        scale,
        plane,
        down: side(engine.rotation),
    };
    let height = axis + reach + 8.0 + STRIP * shafts as f64;
    let mut svg = Svg::new(WIDTH, height);
    let title = match plane {
        Plane::Side => "from the side, x up",
        Plane::Above if sheet.down > 0.0 => "from above, y down",
        Plane::Above => "from above, y up",
    };
    let crank = &engine.crankshafts[index];
    let title =
        if engine.crankshafts.len() > 1 { format!("{}, {title}", crank.name) } else { title.to_owned() };
    svg.name("small muted", (8.0, 14.0), Anchor::Start, &title);
    draw_counterweights(&mut svg, &sheet, engine, index, radius, gap);
    draw_crank(&mut svg, &sheet, engine, &throws, radius, gap, (low, high));
    draw_shafts(&mut svg, &sheet, engine, shafts, gap, axis + reach);
    let count = engine.counterweights.iter().filter(|w| w.crankshaft == index).count();
    let description = format!(
        "Crank with {} throws and {count} counterweights, {shafts} balance shafts below, {title}.",
        throws.len()
    );
    Panel::new(svg, description)
}

/// Smallest distance of the throws.
fn spacing(engine: &Engine, throws: &[usize], radius: f64) -> f64 {
    let mut planes: Vec<f64> = throws.iter().map(|&t| engine.throws[t].z).collect();
    planes.sort_by(f64::total_cmp);
    planes.windows(2).map(|p| p[1] - p[0]).filter(|g| *g > 1e-4).fold(2.4 * radius, f64::min)
}

/// Planes of the two webs, a quarter of the spacing either side where the file does not say.
fn webs(throw: &Throw, gap: f64) -> [f64; 2] {
    throw.webs.unwrap_or([throw.z - 0.25 * gap, throw.z + 0.25 * gap])
}

fn draw_crank(
    svg: &mut Svg,
    sheet: &Sheet,
    engine: &Engine,
    throws: &[usize],
    radius: f64,
    gap: f64,
    (low, high): (f64, f64),
) {
    let half = |share: f64| share * radius * sheet.scale;
    svg.line("axis-line", (sheet.z(low), sheet.axis), (sheet.z(high), sheet.axis));
    let mut journals: Vec<f64> = vec![low + 0.2 * gap];
    let mut order = throws.to_vec();
    order.sort_by(|&a, &b| engine.throws[a].z.total_cmp(&engine.throws[b].z));
    for &throw in &order {
        let [front, rear] = webs(&engine.throws[throw], gap);
        journals.extend([front, rear]);
    }
    journals.push(high - 0.2 * gap);
    for ends in journals.chunks(2).filter(|ends| ends[1] > ends[0]) {
        let width = sheet.z(ends[1]) - sheet.z(ends[0]);
        svg.rect("metal", sheet.z(ends[0]), sheet.axis - half(0.22), width, 2.0 * half(0.22));
    }
    let thick = (0.14 * gap * sheet.scale).max(3.0);
    let mut labels: Vec<(f64, f64, Vec<usize>)> = Vec::new();
    for &throw in &order {
        let data = &engine.throws[throw];
        let pin = sheet.up(Complex64::from_polar(data.radius, engine.pin_angle(throw, 0.0))) * sheet.scale;
        let [front, rear] = webs(data, gap);
        let (top, bottom) = (sheet.axis - pin.max(0.0) - half(0.3), sheet.axis - pin.min(0.0) + half(0.3));
        let width = sheet.z(rear) - sheet.z(front);
        svg.rect("metal", sheet.z(front), sheet.axis - pin - half(0.2), width, 2.0 * half(0.2));
        for web in [front, rear] {
            svg.rect("metal", sheet.z(web) - 0.5 * thick, top, thick, bottom - top);
        }
        let x = 0.5 * (sheet.z(front) + sheet.z(rear));
        match labels.iter_mut().find(|(at, _, _)| (*at - x).abs() < 8.0) {
            Some((_, _, numbers)) => numbers.push(throw + 1),
            None => labels.push((x, sheet.axis - pin + 4.0, vec![throw + 1])),
        }
    }
    for (x, y, numbers) in labels {
        svg.text("small strong halo", (x, y), Anchor::Middle, &number::list(&numbers));
    }
}

fn draw_counterweights(svg: &mut Svg, sheet: &Sheet, engine: &Engine, index: usize, radius: f64, gap: f64) {
    let weights = || engine.counterweights.iter().filter(|w| w.crankshaft == index && w.unbalance > 0.0);
    let largest = weights().fold(0.0f64, |m, w| m.max(w.unbalance));
    let thick = (0.2 * gap * sheet.scale).max(5.0);
    for weight in weights() {
        let length = 1.6 * radius * sheet.scale * (weight.unbalance / largest).sqrt();
        let direction = Complex64::cis(engine.crankshafts[index].phase + weight.angle);
        block(svg, (sheet.z(weight.z), sheet.axis), thick, length, sheet.up(direction), 0.5);
    }
}

/// Every shaft in a strip of its own.
fn draw_shafts(svg: &mut Svg, sheet: &Sheet, engine: &Engine, shafts: usize, gap: f64, top: f64) {
    let shafts = &engine.shafts[..shafts];
    let largest = shafts.iter().flat_map(|s| &s.weights).fold(0.0f64, |m, w| m.max(w.unbalance));
    let thick = (0.2 * gap * sheet.scale).clamp(6.0, 22.0);
    for (place, shaft) in shafts.iter().enumerate() {
        let y = top + STRIP * (place as f64 + 0.5) + 12.0;
        let ends = shaft.weights.iter().fold((0.0f64, 0.0f64), |(a, b), w| (a.min(w.z), b.max(w.z)));
        let (left, right) = (sheet.z(ends.0 - 0.25 * gap), sheet.z(ends.1 + 0.25 * gap));
        for weight in shaft.weights.iter().filter(|w| w.unbalance > 0.0) {
            let length = 18.0 * (weight.unbalance / largest).sqrt();
            block(svg, (sheet.z(weight.z), y), thick, length, sheet.up(Complex64::cis(weight.phase)), 0.4);
        }
        svg.path("outline", &Path::new().move_to((left, y)).line_to((right, y)));
        let ratio = shaft.ratio.to_string().replace('-', "\u{2212}");
        let label = format!("s {}: {}, {ratio} \u{d7} crank speed", place + 1, shaft.name);
        svg.name("small muted halo", (8.0, y - 21.0), Anchor::Start, &label);
    }
}

/// A weight at a place on an axis: `length` times the visible part of its direction, at least a low block.
fn block(svg: &mut Svg, (x, y): (f64, f64), thick: f64, length: f64, up: f64, low: f64) {
    if up.abs() * length < low * thick {
        svg.rect("weight", x - 0.5 * thick, y - 0.5 * low * length, thick, low * length);
    } else {
        svg.rect("weight", x - 0.5 * thick, y, thick, -up * length);
    }
}
