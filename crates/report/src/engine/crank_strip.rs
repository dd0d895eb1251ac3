//! A crankshaft from the side in a narrow strip above a plot along it, to the scale of the plot's abscissa.

use crate::kit::svg::{Anchor, Path, Svg, text_width};
use lanchester_model::{Engine, Throw};

/// Height of a strip [px].
pub(crate) const HEIGHT: f64 = 92.0;

/// Where the shaft's axis lies below the strip's upper edge [px].
const AXIS: f64 = 36.0;
/// Height of the longest throw [px].
const TALLEST: f64 = 26.0;

/// Draws crankshaft `index` (from 0) at theta = 0, x up, its main bearings with their numbers below; `place` takes z [m]
/// to the screen and `top` is the strip's upper edge.
pub(crate) fn draw(
    svg: &mut Svg,
    engine: &Engine,
    index: usize,
    mains: &[f64],
    top: f64,
    place: impl Fn(f64) -> f64,
) {
    let axis = top + AXIS;
    let mut throws: Vec<(usize, &Throw)> =
        engine.throws.iter().enumerate().filter(|(_, t)| t.crankshaft == index).collect();
    throws.sort_by(|a, b| a.1.z.total_cmp(&b.1.z));
    let radius = throws.iter().fold(1e-9f64, |m, (_, t)| m.max(t.radius));
    let scale = TALLEST / radius;
    let height = |throw: usize| scale * engine.throws[throw].radius * engine.pin_angle(throw, 0.0).cos();

    for weight in engine.counterweights.iter().filter(|w| w.crankshaft == index && w.unbalance > 0.0) {
        let tall = 1.15 * TALLEST * (engine.crankshafts[index].phase + weight.angle).cos();
        // A weight that points at the reader shows its width.
        let tall = if tall.abs() < 0.25 * TALLEST { 0.25 * TALLEST } else { tall };
        svg.rect("weight", place(weight.z) - 4.0, axis, 8.0, -tall);
    }
    let (left, right) = (mains.first().copied().unwrap_or(0.0), mains.last().copied().unwrap_or(0.0));
    let mut path = Path::new().move_to((place(left) - 10.0, axis));
    let mut last = f64::NEG_INFINITY;
    for &(throw, at) in &throws {
        let [front, rear] = webs(at, mains);
        // Neighbouring pins of a split pair share the web between them.
        let front = place(front).max(last);
        last = place(rear);
        let y = axis - height(throw);
        path = path.line_to((front, axis)).line_to((front, y)).line_to((last, y)).line_to((last, axis));
    }
    svg.path("shaft-line", &path.line_to((place(right).max(last) + 10.0, axis)));
    for &(throw, at) in &throws {
        svg.circle("pin", (place(at.z), axis - height(throw)), 2.6);
    }
    let mut free_from = f64::NEG_INFINITY;
    for (number, &main) in mains.iter().enumerate() {
        let x = place(main);
        svg.rect("metal", x - 5.0, axis - 8.0, 10.0, 5.0);
        svg.rect("metal", x - 5.0, axis + 3.0, 10.0, 5.0);
        let name = (number + 1).to_string();
        let half = 0.5 * text_width(&name, 12.0) + 3.0;
        if x - half > free_from {
            svg.text("small muted", (x, top + HEIGHT - 10.0), Anchor::Middle, &name);
            free_from = x + half;
        }
    }
}

/// Planes of the webs of a throw [m]; where the file gives none, midway to the mains beside it.
fn webs(throw: &Throw, mains: &[f64]) -> [f64; 2] {
    throw.webs.unwrap_or_else(|| {
        let nearest = mains.iter().map(|z| (z - throw.z).abs()).fold(f64::INFINITY, f64::min);
        let half = 0.5 * nearest.min(throw.radius);
        [throw.z - half, throw.z + half]
    })
}
