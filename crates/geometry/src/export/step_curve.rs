//! Where a chamfer meets a wall, as STEP has it.
//!
//! | wall | milled | turned |
//! |---|---|---|
//! | straight | line | hyperbola; a line where the wall's plane holds the crank axis |
//! | arc | ellipse | circle about the crank axis; else a spline |
//!
//! The depth over a straight wall at the distance `d` from the crank axis is `k (sqrt(d^2 + t^2) - r)`: a hyperbola with the half axes `k d` along the
//! crank and `d` across it, whose centre is the tip of the cone moved into the wall.

use super::RESOLUTION;
use super::slope::Slope;
use lanchester_shape::{Cut, Edge, Point};

/// How far a spline may lie off the cone and the cylinder that it is the edge of [m].
pub const SPLINE_ERROR: f64 = 1e-9;
/// Below this a curve is not distinguished from a line or a circle [m].
const STRAIGHT: f64 = 0.01 * RESOLUTION;
/// Most pieces of a spline.
const MOST_PIECES: usize = 1 << 14;

/// An edge between a chamfer and a wall.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Rise {
    Line,
    Circle,
    Conic(Conic),
    /// Control points of cubic pieces that share their tangents [m].
    Spline(Vec<[f64; 3]>),
}

/// An ellipse or a hyperbola that runs from its beginning to its end about its normal.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Conic {
    /// Its entity.
    pub kind: &'static str,
    /// [m]
    pub centre: [f64; 3],
    pub normal: [f64; 3],
    /// Direction of the first axis.
    pub first: [f64; 3],
    /// Half axes [m].
    pub axes: [f64; 2],
}

/// What the edge of a chamfer over a wall is.
pub(super) fn rise(plan: &Edge, slope: &Slope) -> Rise {
    let (s, c) = slope.angle.sin_cos();
    let steepness = slope.into * s / c;
    match (slope.cut, plan.bulge == 0.0) {
        (Cut::Milled { .. }, true) => Rise::Line,
        (Cut::Turned { radius }, true) => {
            let chord = plan.to - plan.from;
            let along = chord * (1.0 / chord.norm());
            let foot = plan.from - along * plan.from.dot(along);
            let distance = foot.norm();
            if s / c * distance * distance / (2.0 * radius) < STRAIGHT {
                return Rise::Line;
            }
            Rise::Conic(Conic {
                kind: "HYPERBOLA",
                centre: [foot.x, foot.y, slope.face - steepness * radius],
                first: [0.0, 0.0, slope.into],
                normal: cross([0.0, 0.0, slope.into], [along.x, along.y, 0.0]),
                axes: [s / c * distance, distance],
            })
        }
        (Cut::Milled { .. }, false) => {
            let (centre, radius) = (plan.centre(), plan.radius());
            let deeper = slope.deeper(centre);
            let first = [deeper.x * c, deeper.y * c, slope.into * s];
            let second = -deeper.right() * plan.bulge.signum();
            Rise::Conic(Conic {
                kind: "ELLIPSE",
                centre: [centre.x, centre.y, slope.surface(centre)],
                first,
                normal: cross(first, [second.x, second.y, 0.0]),
                axes: [radius / c, radius],
            })
        }
        (Cut::Turned { .. }, false) => {
            if plan.centre().norm() * s / c < STRAIGHT {
                Rise::Circle
            } else {
                Rise::Spline(spline(plan, slope))
            }
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Control points of as many cubic pieces as keep the spline within [`SPLINE_ERROR`] of cone and cylinder. Each piece has the curve's
/// ends and derivatives, so that its error falls with the fourth power of its length.
fn spline(plan: &Edge, slope: &Slope) -> Vec<[f64; 3]> {
    let mut pieces = 1;
    loop {
        let ends: Vec<([f64; 3], [f64; 3])> = (0..=pieces)
            .map(|k| {
                let part = k as f64 / pieces as f64;
                let (at, along) = plan.at(part);
                let along = along * (1.0 / pieces as f64);
                let rise = slope.into * slope.angle.tan() * slope.deeper(at).dot(along);
                ([at.x, at.y, slope.surface(at)], [along.x, along.y, rise])
            })
            .collect();
        let mut points = vec![ends[0].0];
        let mut error = 0.0f64;
        for pair in ends.windows(2) {
            let ((from, leaving), (to, arriving)) = (pair[0], pair[1]);
            let [b, c] = [[from, leaving, [1.0; 3]], [to, arriving, [-1.0; 3]]]
                .map(|[at, along, sign]| [0, 1, 2].map(|i| at[i] + sign[i] * along[i] / 3.0));
            points.extend([b, c]);
            for t in [0.25, 0.5, 0.75] {
                let (u, v): (f64, f64) = (1.0 - t, t);
                let weights = [u * u * u, 3.0 * u * u * v, 3.0 * u * v * v, v * v * v];
                let [x, y, z] = [0, 1, 2].map(|i| {
                    weights[0] * from[i] + weights[1] * b[i] + weights[2] * c[i] + weights[3] * to[i]
                });
                let at = Point::new(x, y);
                let off_wall = ((at - plan.centre()).norm() - plan.radius()).abs();
                error = error.max(off_wall).max((z - slope.surface(at)).abs());
            }
        }
        points.push(ends[pieces].0);
        // Between the points where it is looked at the error is a little larger.
        if error < 0.5 * SPLINE_ERROR || pieces >= MOST_PIECES {
            return points;
        }
        pieces *= 2;
    }
}
