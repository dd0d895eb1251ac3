//! A closed line of straight edges and arcs.

use crate::area_moments::AreaMoments;
use crate::crossing::{Joint, TOUCH, crossing};
use crate::edge::Edge;
use crate::error::GeometryError;
use crate::point::Point;
use serde::Serialize;

/// A corner of a contour and the bulge of the edge that leaves it ([`Edge::bulge`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Where it is [m].
    pub at: Point,
    /// Bulge of the edge from here to the next corner.
    pub bulge: f64,
}

/// A closed line that runs anticlockwise and does not cross or touch itself.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(transparent)]
pub struct Contour {
    edges: Vec<Edge>,
}

impl Contour {
    /// From its corners, each with the bulge of the edge to the next; the last is joined to the first.
    ///
    /// # Errors
    /// Where a number is not finite, an edge has no length, the contour crosses or touches itself, or runs clockwise.
    pub fn new(corners: &[Corner]) -> Result<Contour, GeometryError> {
        let next = |at: usize| corners[(at + 1) % corners.len()].at;
        let edge =
            |(at, corner): (usize, &Corner)| Edge { from: corner.at, to: next(at), bulge: corner.bulge };
        Contour::checked(corners.iter().enumerate().map(edge).collect())
    }

    /// From straight edges between these corners.
    ///
    /// # Errors
    /// As [`Contour::new`].
    pub fn polygon(corners: &[Point]) -> Result<Contour, GeometryError> {
        Contour::new(&corners.iter().map(|at| Corner { at: *at, bulge: 0.0 }).collect::<Vec<_>>())
    }

    /// From edges that follow each other; ends closer than `gap` [m] are joined in their middle.
    ///
    /// # Errors
    /// Where two ends lie farther apart, and as [`Contour::new`].
    pub fn from_edges(edges: &[Edge], gap: f64) -> Result<Contour, GeometryError> {
        let mut joined = edges.to_vec();
        for at in 0..edges.len() {
            let next = (at + 1) % edges.len();
            let (end, begin) = (edges[at].to, edges[next].from);
            let distance = (end - begin).norm();
            if distance.is_nan() || distance > gap {
                return Err(GeometryError::Open { edge: at + 1, next: next + 1, end, begin, gap: distance });
            }
            let middle = if end == begin { end } else { (end + begin) * 0.5 };
            joined[at].to = middle;
            joined[next].from = middle;
        }
        Contour::checked(joined)
    }

    /// A circle.
    ///
    /// # Errors
    /// Where the radius is not positive and finite.
    pub fn circle(centre: Point, radius: f64) -> Result<Contour, GeometryError> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(GeometryError::Number {
                quantity: "radius of a circle [m]",
                needed: "positive",
                got: radius,
                hint: "give a length",
            });
        }
        let ends = [-radius, radius].map(|x| Corner { at: centre + Point::new(x, 0.0), bulge: 1.0 });
        Contour::new(&ends)
    }

    /// From edges of which each begins where the one before it ends.
    pub(crate) fn checked(edges: Vec<Edge>) -> Result<Contour, GeometryError> {
        let arcs = edges.iter().any(|edge| edge.bulge != 0.0);
        if edges.len() < if arcs { 2 } else { 3 } {
            return Err(GeometryError::TooFewEdges { edges: edges.len() });
        }
        let finite = |edge: &Edge| edge.from.is_finite() && edge.to.is_finite() && edge.bulge.is_finite();
        if let Some(at) = edges.iter().position(|edge| !finite(edge)) {
            return Err(GeometryError::NotFinite { edge: at + 1 });
        }
        let size = size(&edges);
        if let Some(at) = edges.iter().position(|edge| 2.0 * edge.half_chord() <= TOUCH * size) {
            return Err(GeometryError::ZeroLength { edge: at + 1, at: edges[at].from });
        }
        let contour = Contour { edges };
        if let Some((first, second, at)) = contour.own_crossing(size) {
            return Err(GeometryError::Crossing { first: first + 1, second: second + 1, at });
        }
        let area = contour.moments().area;
        if area <= 0.0 {
            return Err(GeometryError::InsideOut { area: -area });
        }
        Ok(contour)
    }

    /// From edges that are known to follow each other anticlockwise without crossing.
    pub(crate) fn of_simple_edges(edges: Vec<Edge>) -> Contour {
        Contour { edges }
    }

    fn own_crossing(&self, size: f64) -> Option<(usize, usize, Point)> {
        let count = self.edges.len();
        for first in 0..count {
            for second in first + 1..count {
                let joint = match (second == first + 1, first == 0 && second == count - 1) {
                    (true, true) => Joint::BothEnds,
                    (true, false) => Joint::Corner(self.edges[first].to),
                    (false, true) => Joint::Corner(self.edges[first].from),
                    (false, false) => Joint::Apart,
                };
                if let Some(at) = crossing(&self.edges[first], &self.edges[second], joint, size) {
                    return Some((first, second, at));
                }
            }
        }
        None
    }

    /// Its edges, anticlockwise.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Largest extent [m].
    pub fn size(&self) -> f64 {
        size(&self.edges)
    }

    /// Integrals over its inside, about the crank axis. Relative error of the area near 1e-15 times the number of edges.
    pub fn moments(&self) -> AreaMoments {
        // About a corner of its own, so that a figure far from the axis loses no digits.
        let reference = self.edges[0].from;
        let near = |edge: &Edge| Edge { from: edge.from - reference, to: edge.to - reference, ..*edge };
        let sum = self.edges.iter().fold(AreaMoments::default(), |sum, edge| sum + near(edge).moments());
        sum.moved(reference)
    }

    /// Length of the line [m].
    pub fn length(&self) -> f64 {
        self.edges.iter().map(Edge::length).sum()
    }

    /// Largest distance from `point` [m], and where; exact on arcs.
    pub fn farthest(&self, point: Point) -> (f64, Point) {
        let all = self.edges.iter().map(|edge| edge.farthest(point));
        all.fold((0.0, point), |best, next| if next.0 > best.0 { next } else { best })
    }

    /// Least distance of the line from `point` [m], and where; exact on arcs.
    pub fn nearest(&self, point: Point) -> (f64, Point) {
        let all = self.edges.iter().map(|edge| edge.nearest(point));
        all.fold((f64::INFINITY, point), |best, next| if next.0 < best.0 { next } else { best })
    }

    /// Lower left and upper right corner of the box around it [m].
    pub fn bounds(&self) -> [Point; 2] {
        let reach = |x: f64, y: f64| {
            let direction = Point::new(x, y);
            self.edges.iter().map(|edge| edge.support(direction)).fold(f64::NEG_INFINITY, f64::max)
        };
        [Point::new(-reach(-1.0, 0.0), -reach(0.0, -1.0)), Point::new(reach(1.0, 0.0), reach(0.0, 1.0))]
    }

    /// Whether `point` lies inside. Of a point on the line itself rounding decides.
    pub fn contains(&self, point: Point) -> bool {
        let turn: f64 = self.edges.iter().map(|edge| edge.turn_about(point)).sum();
        turn > std::f64::consts::PI
    }

    /// Turned by `angle` [rad] about the crank axis.
    pub fn turned(&self, angle: f64) -> Contour {
        self.mapped(|point| point.turned(angle))
    }

    /// Moved by `by`.
    pub fn moved(&self, by: Point) -> Contour {
        self.mapped(|point| point + by)
    }

    fn mapped(&self, map: impl Fn(Point) -> Point) -> Contour {
        let edges = self.edges.iter().map(|e| Edge { from: map(e.from), to: map(e.to), ..*e }).collect();
        Contour { edges }
    }

    /// A point where the two lines cross or touch.
    pub(crate) fn meeting(&self, other: &Contour, size: f64) -> Option<Point> {
        let pairs = self.edges.iter().flat_map(|first| other.edges.iter().map(move |second| (first, second)));
        pairs.into_iter().find_map(|(first, second)| crossing(first, second, Joint::Apart, size))
    }
}

/// Largest extent of edges from the beginning of the first [m].
pub(crate) fn size(edges: &[Edge]) -> f64 {
    let start = edges[0].from;
    edges.iter().map(|edge| edge.farthest(start).0).fold(0.0, f64::max)
}
