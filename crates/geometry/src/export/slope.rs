//! The surface of a chamfer on a part at its place: a cone about the crank axis or a plane.

use super::RESOLUTION;
use lanchester_numerics::illinois;
use lanchester_shape::{Chamfer, Cut, Edge, Face, Point};
use std::f64::consts::PI;

/// A chamfer where it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slope {
    /// Its cut, turned with the part.
    pub cut: Cut,
    /// Angle against the face [rad].
    pub angle: f64,
    /// The face that it goes into [m].
    pub face: f64,
    /// The sense in which it gets deeper: 1 towards larger z from the front face, -1 from the rear face.
    pub into: f64,
}

impl Slope {
    /// A chamfer of a part that is turned by `turn` [rad] and has its faces at `front` and `rear` [m].
    pub fn new(chamfer: &Chamfer, turn: f64, [front, rear]: [f64; 2]) -> Slope {
        let cut = match chamfer.cut {
            Cut::Milled { direction, distance } => Cut::Milled { direction: direction + turn, distance },
            turned => turned,
        };
        let (face, into) = match chamfer.face {
            Face::Front => (front, 1.0),
            Face::Rear => (rear, -1.0),
        };
        Slope { cut, angle: chamfer.angle, face, into }
    }

    /// How far a point lies beyond the line on the face where it begins [m].
    pub fn beyond(&self, at: Point) -> f64 {
        match self.cut {
            Cut::Turned { radius } => at.norm() - radius,
            Cut::Milled { direction, distance } => at.dot(Point::polar(1.0, direction)) - distance,
        }
    }

    /// Unit vector across the crank in which it gets deeper.
    pub fn deeper(&self, at: Point) -> Point {
        match self.cut {
            Cut::Turned { .. } => at * (1.0 / at.norm()),
            Cut::Milled { direction, .. } => Point::polar(1.0, direction),
        }
    }

    /// Height of its surface at a point, also where it lies above the face [m].
    pub fn surface(&self, at: Point) -> f64 {
        self.face + self.into * self.angle.tan() * self.beyond(at)
    }

    /// Height of the part's end at a point [m]: of its surface, or of the face where it does not cut.
    pub fn height(&self, at: Point) -> f64 {
        if self.beyond(at) > RESOLUTION { self.surface(at) } else { self.face }
    }

    /// Unit normal out of the material.
    pub fn normal(&self, at: Point) -> [f64; 3] {
        let (s, c) = self.angle.sin_cos();
        let out = self.deeper(at) * s;
        [out.x, out.y, -self.into * c]
    }

    /// How far the part's end along the crank reaches into it on an outline that extends to `reach` from the axis and along a direction [m].
    pub fn deepest(&self, swept: f64, reach: impl Fn(Point) -> f64) -> f64 {
        let farthest = match self.cut {
            Cut::Turned { radius } => swept - radius,
            Cut::Milled { direction, distance } => reach(Point::polar(1.0, direction)) - distance,
        };
        self.angle.tan() * farthest.max(0.0)
    }

    /// Parts of the length of an edge, of at most half a turn, where it crosses the line on the face, in order.
    pub fn crossings(&self, edge: &Edge) -> Vec<f64> {
        let beyond = |part: f64| self.beyond(edge.at(part).0);
        let grows = |part: f64| {
            let (at, along) = edge.at(part);
            match self.cut {
                Cut::Turned { .. } => at.dot(along),
                Cut::Milled { .. } => self.deeper(at).dot(along),
            }
        };
        // On at most half a turn the distance has at most one extreme inside.
        let mut bounds = vec![0.0, 1.0];
        if grows(0.0) * grows(1.0) < 0.0 {
            bounds.insert(1, zero(grows, 0.0, 1.0));
        }
        let crossed = bounds.windows(2).filter(|ends| (beyond(ends[0]) > 0.0) != (beyond(ends[1]) > 0.0));
        crossed.map(|ends| zero(beyond, ends[0], ends[1])).collect()
    }

    /// Where a point of the line on the face stands along it, with the uncut face on the left.
    pub fn along(&self, at: Point) -> f64 {
        match self.cut {
            Cut::Turned { .. } => at.y.atan2(at.x),
            Cut::Milled { direction, .. } => Point::polar(1.0, direction + PI / 2.0).dot(at),
        }
    }

    /// The piece of the line on the face between two points of it, with the uncut face on the left.
    pub fn line(&self, from: Point, to: Point) -> Edge {
        let bulge = match self.cut {
            Cut::Turned { .. } => {
                let turn = (self.along(to) - self.along(from)).rem_euclid(2.0 * PI);
                (turn / 4.0).tan()
            }
            Cut::Milled { .. } => 0.0,
        };
        Edge { from, to, bulge }
    }
}

/// Zero of a function that changes its sign between `a` and `b`.
fn zero(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    illinois(a, f(a), b, f(b), 0.0, f)
}
