//! What a chamfer cuts off the edge of a flat part.
//!
//! Its surface goes into the part by a depth that depends on the place alone: on the distance from the crank axis (turned on a
//! lathe, a cone) or on the distance along a direction of the plane (milled, a plane). With `f` that distance, `f0` where the
//! surface leaves the face and `k` the slope:
//!
//! ```text
//! h(x, y) = k max(f(x, y) - f0, 0)                                                        (book, eq. 22.10)
//! cut off:   INTEGRAL h dA,  INTEGRAL h x dA, ..,  INTEGRAL h^2/2 dA, ..  over the outline
//! ```
//! Green's theorem turns each into an integral along the outline, with the inner integral begun at `f0`, where `h` vanishes:
//! the line `f = f0` itself adds nothing. The inner integrand is a polynomial, which three Gauss points integrate exactly;
//! along the outline the integrand is analytic on each piece, and sixteen Gauss points a short piece leave rounding only.

use crate::edge::Edge;
use crate::mass_properties::MassMoments;
use crate::outline::Outline;
use crate::point::Point;
use lanchester_numerics::{GAUSS_16, illinois, unit_points};
use serde::{Deserialize, Serialize};

/// How a chamfer is made.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub enum Cut {
    /// Turned about the crank axis: a cone that leaves the face at this radius [m].
    Turned {
        /// Radius on the face [m].
        radius: f64,
    },
    /// Milled: a plane that leaves the face along a line.
    Milled {
        /// Direction, from `x` towards `y`, in which it gets deeper [rad].
        direction: f64,
        /// Distance of the line on the face from the crank axis, along that direction [m].
        distance: f64,
    },
}

/// Which face of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
pub enum Face {
    /// The one with the smaller z.
    Front,
    /// The one with the larger z.
    Rear,
}

/// A chamfer of a part's edge.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Chamfer {
    /// Its surface.
    pub cut: Cut,
    /// Angle of its surface against the face [rad], between 0 and a quarter turn: 45 degrees is as deep as wide.
    pub angle: f64,
    /// Face that it is on.
    pub face: Face,
}

impl Chamfer {
    /// Distance that the depth grows with [m].
    fn distance(&self, point: Point) -> f64 {
        match self.cut {
            Cut::Turned { .. } => point.norm(),
            Cut::Milled { direction, .. } => point.dot(Point::polar(1.0, direction)),
        }
    }

    /// Where it leaves the face [m].
    fn start(&self) -> f64 {
        match self.cut {
            Cut::Turned { radius } => radius,
            Cut::Milled { distance, .. } => distance,
        }
    }

    /// Depth at a point [m].
    pub fn depth(&self, point: Point) -> f64 {
        self.angle.tan() * (self.distance(point) - self.start()).max(0.0)
    }

    /// Largest depth within a circle [m].
    pub(crate) fn depth_over_circle(&self, centre: Point, radius: f64) -> f64 {
        self.angle.tan() * (self.distance(centre) + radius - self.start()).max(0.0)
    }

    /// Largest depth within an outline [m].
    pub(crate) fn deepest(&self, outline: &Outline) -> f64 {
        let reach = match self.cut {
            Cut::Turned { .. } => outline.swept_radius(),
            Cut::Milled { direction, .. } => outline.reach(Point::polar(1.0, direction)),
        };
        self.angle.tan() * (reach - self.start()).max(0.0)
    }

    /// The pieces of an edge where it cuts.
    fn pieces(&self, edge: &Edge) -> Vec<(f64, f64)> {
        let beyond = |part: f64| self.distance(edge.at(part).0) - self.start();
        let grows = |part: f64| {
            let (point, along) = edge.at(part);
            match self.cut {
                Cut::Turned { .. } => point.dot(along),
                Cut::Milled { direction, .. } => along.dot(Point::polar(1.0, direction)),
            }
        };
        let mut bounds = vec![0.0];
        // On at most half a turn the distance has at most one extreme inside.
        if grows(0.0) * grows(1.0) < 0.0 {
            bounds.push(zero(grows, 0.0, 1.0));
        }
        bounds.push(1.0);
        let mut pieces = Vec::new();
        for pair in bounds.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            match (beyond(a) > 0.0, beyond(b) > 0.0) {
                (true, true) => pieces.push((a, b)),
                (true, false) => pieces.push((a, zero(beyond, a, b))),
                (false, true) => pieces.push((zero(beyond, a, b), b)),
                (false, false) => {}
            }
        }
        pieces
    }

    /// What it cuts off an outline at density 1, with `z` measured from the face into the part.
    pub(crate) fn cut_off(&self, outline: &Outline) -> MassMoments {
        let mut sum = self.cut_along(outline.outer().edges());
        for hole in outline.holes() {
            sum = sum - self.cut_along(hole.edges());
        }
        sum
    }

    fn cut_along(&self, edges: &[Edge]) -> MassMoments {
        let halves = edges
            .iter()
            .flat_map(|edge| if edge.bulge.abs() > 1.0 { edge.halves().to_vec() } else { vec![*edge] });
        let mut sum = MassMoments::default();
        for edge in halves {
            for (from, to) in self.pieces(&edge) {
                // Short against the distance of the poles of 1/r^2, and against a radian of the arc.
                let length = edge.length() * (to - from);
                let turn = 4.0 * edge.bulge.abs().atan() * (to - from);
                let shortness = match self.cut {
                    Cut::Turned { radius } => 2.0 * length / radius,
                    Cut::Milled { .. } => 0.0,
                };
                let count = shortness.max(2.0 * turn).max(1.0).ceil();
                let step = (to - from) / count;
                for piece in 0..count as usize {
                    let start = from + piece as f64 * step;
                    for (place, weight) in unit_points(&GAUSS_16) {
                        let (point, along) = edge.at(start + step * place);
                        sum = sum + self.column(point, along * (step * weight));
                    }
                }
            }
        }
        sum
    }

    /// The inner integral from where the chamfer begins to the outline, times the outline's step.
    fn column(&self, end: Point, along: Point) -> MassMoments {
        let (start, distance) = (self.start(), self.distance(end));
        let direction = match self.cut {
            Cut::Turned { .. } => end * (1.0 / distance),
            Cut::Milled { direction, .. } => Point::polar(1.0, direction),
        };
        let slope = self.angle.tan();
        let mut sum = MassMoments::default();
        for (node, weight) in THREE {
            let f = start + (distance - start) * (1.0 + node) / 2.0;
            let point = end + direction * (f - distance);
            let h = slope * (f - start);
            // dA = f df d(angle) around the axis, df dv along a direction.
            let measure = match self.cut {
                Cut::Turned { .. } => f * end.cross(along) / (distance * distance),
                Cut::Milled { .. } => direction.cross(along),
            };
            let dv = measure * weight * (distance - start) / 2.0;
            let Point { x, y } = point;
            let (h1, h2, h3) = (h * dv, h * h / 2.0 * dv, h * h * h / 3.0 * dv);
            sum = sum
                + MassMoments {
                    mass: h1,
                    first: [x * h1, y * h1, h2],
                    second: [x * x * h1, y * y * h1, h3, y * h2, x * h2, x * y * h1],
                };
        }
        sum
    }

    /// A point of the outline where both chamfers cut, if there is one. From any place where both cut, going on in the
    /// direction in which both get deeper leads to the outline.
    pub(crate) fn overlap(&self, other: &Chamfer, outline: &Outline) -> Option<Point> {
        let edges = outline.contours().flat_map(|contour| contour.edges());
        let halves =
            edges.flat_map(|edge| if edge.bulge.abs() > 1.0 { edge.halves().to_vec() } else { vec![*edge] });
        for edge in halves {
            for (a, b) in self.pieces(&edge) {
                for (c, d) in other.pieces(&edge) {
                    let (from, to) = (a.max(c), b.min(d));
                    if from < to {
                        return Some(edge.at((from + to) / 2.0).0);
                    }
                }
            }
        }
        None
    }
}

/// Zero of a function that changes its sign between `a` and `b`.
fn zero(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    illinois(a, f(a), b, f(b), 0.0, f)
}

/// Gauss's rule of three points on [-1, 1], exact to degree five.
const THREE: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];
