//! Sketch of the modes: the block as a box, at rest and at the end of its swing, from the side and from the free end.

use crate::kit::figure::{Figure, Panel};
use crate::kit::number;
use crate::kit::svg::{Anchor, Path, Svg};
use lanchester_mechanism::{COORDINATES, MountMode, MountStudy};
use lanchester_model::Engine;
use std::f64::consts::TAU;

const WIDTH: f64 = 440.0;
const HEIGHT: f64 = 230.0;

/// The largest motion of a corner over the size of the box.
const SWING: f64 = 0.12;

/// A panel for each mode, with a side view (z to the right, x up) and a view from the free end (y to the right, x up).
pub(crate) fn mount_shapes(engine: &Engine, study: &MountStudy) -> Figure {
    let panels = study.modes.modes.iter().enumerate().map(|(k, mode)| panel(engine, study, k + 1, mode));
    Figure {
        id: "mount-modes".to_owned(),
        title: "Mode shapes of the block".to_owned(),
        caption: "The block as a box about mounts, crankshaft and centre of mass, at rest (thin) and at the end of its swing \
                  (dashed): from the side, z to the right, and from the free end, y to the right; x is up. Dots are mounts."
            .to_owned(),
        panels: panels.collect(),
        columns: 2,
    }
}

/// Corners of the box about all that is known of the block.
fn bounds(engine: &Engine, study: &MountStudy) -> [[f64; 2]; 3] {
    let mounts = engine.mounts.iter().map(|m| [m.x, m.y, m.z]);
    let crank = engine.throws.iter().map(|t| [0.0, 0.0, t.z]);
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for point in mounts.chain(crank).chain([study.body.centre]) {
        for (bound, value) in bounds.iter_mut().zip(point) {
            *bound = [bound[0].min(value), bound[1].max(value)];
        }
    }
    let size = bounds.iter().map(|b| b[1] - b[0]).fold(0.0, f64::max);
    // A box without depth would look like a line.
    bounds.map(|[low, high]| {
        let room = (0.15 * size - (high - low)).max(0.0) / 2.0;
        [low - room, high + room]
    })
}

fn panel(engine: &Engine, study: &MountStudy, number_of_mode: usize, mode: &MountMode) -> Panel {
    let bounds = bounds(engine, study);
    let corners: Vec<[f64; 3]> =
        (0..8).map(|k| [bounds[0][k & 1], bounds[1][k >> 1 & 1], bounds[2][k >> 2 & 1]]).collect();
    let moved = |p: [f64; 3]| -> [f64; 3] {
        let [ux, uy, uz, px, py, pz] = mode.shape;
        let [x, y, z] = [0, 1, 2].map(|j| p[j] - study.body.centre[j]);
        [ux + py * z - pz * y, uy + pz * x - px * z, uz + px * y - py * x]
    };
    let size = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let largest = corners.iter().map(|c| size(moved(*c))).fold(0.0, f64::max);
    let extent = bounds.map(|b| b[1] - b[0]);
    let swing = if largest > 0.0 { SWING * size(extent) / largest } else { 0.0 };
    let swung = |p: [f64; 3]| {
        let m = moved(p);
        [0, 1, 2].map(|j| p[j] + swing * m[j])
    };
    let mut svg = Svg::new(WIDTH, HEIGHT);
    let hertz = number::short(mode.angular_frequency / TAU, 4);
    let name = format!("Mode {number_of_mode}: {hertz} Hz, {}", COORDINATES[mode.main]);
    let share = number::fixed(100.0 * mode.energy[mode.main], 0);
    svg.text("strong", (4.0, 16.0), Anchor::Start, &format!("{name} {share} %"));
    // Both views to one scale, with room for the swing.
    let scale = ((WIDTH - 60.0) / (1.4 * (extent[2] + extent[1]))).min((HEIGHT - 60.0) / (1.4 * extent[0]));
    let middle = bounds.map(|b| 0.5 * (b[0] + b[1]));
    let side = 30.0 + 0.7 * scale * extent[2];
    let front = WIDTH - 30.0 - 0.7 * scale * extent[1];
    let height = 0.5 * (HEIGHT + 20.0);
    for (across, at) in [(2, side), (1, front)] {
        let place =
            |p: [f64; 3]| (at + scale * (p[across] - middle[across]), height - scale * (p[0] - middle[0]));
        for (class, move_it) in [("thin", false), ("s1", true)] {
            for a in 0..8usize {
                for b in [a | 1, a | 2, a | 4] {
                    if b != a {
                        let ends =
                            [a, b].map(|k| place(if move_it { swung(corners[k]) } else { corners[k] }));
                        svg.path(class, &Path::through(ends));
                    }
                }
            }
        }
        for mount in &engine.mounts {
            let point = [mount.x, mount.y, mount.z];
            svg.circle("dot", place(point), 3.0);
            svg.arrow("a2", place(point), place(swung(point)), 6.0);
        }
    }
    Panel::new(svg, format!("{name}, {share} % of the energy."))
}
