//! An edge of a contour: a straight line or an arc of a circle.

use crate::area_moments::AreaMoments;
use crate::circular_segment::UnitSegment;
use crate::point::Point;
use serde::{Deserialize, Serialize};

/// A line or an arc.
///
/// The bulge is that of DXF: the tangent of a quarter of the included angle, positive where the arc runs anticlockwise from
/// `from` to `to`, zero for a line, one for a half circle.
///
/// ```text
/// bulge = tan(angle/4)    radius = w (1 + bulge^2)/(2 |bulge|)    height over the chord = w |bulge|    w = half the chord
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Edge {
    /// Where it begins [m].
    pub from: Point,
    /// Where it ends [m].
    pub to: Point,
    /// Tangent of a quarter of the included angle.
    pub bulge: f64,
}

impl Edge {
    /// A straight line.
    pub fn line(from: Point, to: Point) -> Edge {
        Edge { from, to, bulge: 0.0 }
    }

    /// An arc about `centre` from the angle `start` through `sweep` [rad], positive anticlockwise, less than a full turn.
    pub fn arc(centre: Point, radius: f64, start: f64, sweep: f64) -> Edge {
        Edge {
            from: centre + Point::polar(radius, start),
            to: centre + Point::polar(radius, start + sweep),
            bulge: (sweep / 4.0).tan(),
        }
    }

    /// Half the length of the chord [m].
    pub fn half_chord(&self) -> f64 {
        (self.to - self.from).norm() / 2.0
    }

    /// Middle of the chord [m].
    pub fn middle_of_chord(&self) -> Point {
        (self.from + self.to) * 0.5
    }

    /// Middle of the edge itself [m].
    pub fn middle(&self) -> Point {
        self.middle_of_chord() + (self.to - self.from).right() * (0.5 * self.bulge)
    }

    /// Radius [m]; infinite for a line.
    pub fn radius(&self) -> f64 {
        self.half_chord() * (1.0 + self.bulge * self.bulge) / (2.0 * self.bulge.abs())
    }

    /// Centre of an arc [m]; not finite for a line.
    pub fn centre(&self) -> Point {
        let height = (1.0 - self.bulge * self.bulge) / (4.0 * self.bulge);
        self.middle_of_chord() - (self.to - self.from).right() * height
    }

    /// Length along the edge [m].
    pub fn length(&self) -> f64 {
        let angle = 4.0 * self.bulge.abs().atan();
        if angle == 0.0 { 2.0 * self.half_chord() } else { self.radius() * angle }
    }

    /// The same edge run the other way.
    pub fn reversed(&self) -> Edge {
        Edge { from: self.to, to: self.from, bulge: -self.bulge }
    }

    /// Unit tangents at its beginning and at its end.
    pub fn tangents(&self) -> [Point; 2] {
        let chord = self.to - self.from;
        let along = chord * (1.0 / chord.norm());
        let scale = 1.0 / (1.0 + self.bulge * self.bulge);
        let (c, s) = ((1.0 - self.bulge * self.bulge) * scale, 2.0 * self.bulge * scale);
        [along * c + along.right() * s, along * c - along.right() * s]
    }

    /// The point at a part of the length between 0 and 1, and the derivative by that part, on an edge of at most half a turn.
    pub fn at(&self, part: f64) -> (Point, Point) {
        let chord = self.to - self.from;
        let half = 2.0 * self.bulge.atan();
        if half == 0.0 {
            return (self.from + chord * part, chord);
        }
        let scale = 1.0 / half.sin();
        let point = self.from + (chord * ((half * part).sin() * scale)).turned(half * (part - 1.0));
        (point, (chord * (half * scale)).turned(half * (2.0 * part - 1.0)))
    }

    /// The two halves of the edge.
    pub fn halves(&self) -> [Edge; 2] {
        let middle = self.middle();
        // tan(x/2) of x = atan(bulge).
        let bulge = self.bulge / (1.0 + self.bulge.hypot(1.0));
        [Edge { from: self.from, to: middle, bulge }, Edge { from: middle, to: self.to, bulge }]
    }

    /// What the edge adds to the integrals over the inside of its contour, which lies on its left: the triangle to the crank
    /// axis and the segment between chord and arc.
    pub(crate) fn moments(&self) -> AreaMoments {
        if self.bulge.abs() > 1.0 {
            let [first, second] = self.halves();
            return first.moments() + second.moments();
        }
        let triangle = triangle(self.from, self.to);
        if self.bulge == 0.0 { triangle } else { triangle + self.segment() }
    }

    /// The area between chord and arc, negative for a clockwise arc.
    fn segment(&self) -> AreaMoments {
        let chord = self.to - self.from;
        let w = chord.norm() / 2.0;
        let t = chord * (0.5 / w);
        let sign = self.bulge.signum();
        let n = t.right() * sign;
        let unit = UnitSegment::of(2.0 * self.bulge.abs().atan());
        let (w2, w3) = (w * w * sign, w * w * w * sign);
        let (nn, tt) = (unit.nn * w3 * w, unit.tt * w3 * w);
        AreaMoments {
            area: unit.area * w2,
            first: n * (unit.n * w3),
            xx: nn * n.x * n.x + tt * t.x * t.x,
            yy: nn * n.y * n.y + tt * t.y * t.y,
            xy: nn * n.x * n.y + tt * t.x * t.y,
        }
        .moved(self.middle_of_chord())
    }

    /// Largest distance from `point`, and where [m].
    pub fn farthest(&self, point: Point) -> (f64, Point) {
        if self.bulge.abs() > 1.0 {
            let [first, second] = self.halves().map(|half| half.farthest(point));
            return if first.0 >= second.0 { first } else { second };
        }
        let (a, b) = (self.from - point, self.to - point);
        let mut best = if a.norm() >= b.norm() { (a.norm(), self.from) } else { (b.norm(), self.to) };
        let [start, end] = self.tangents();
        // On at most half a turn the distance has one largest value inside, if it grows at first and shrinks at last.
        if self.bulge != 0.0 && start.dot(a) > 0.0 && end.dot(b) < 0.0 {
            let away = self.centre() - point;
            let distance = away.norm() + self.radius();
            if distance > best.0 {
                best = (distance, point + away * (distance / away.norm()));
            }
        }
        best
    }

    /// Least distance from `point`, and where [m].
    pub fn nearest(&self, point: Point) -> (f64, Point) {
        if self.bulge.abs() > 1.0 {
            let [first, second] = self.halves().map(|half| half.nearest(point));
            return if first.0 <= second.0 { first } else { second };
        }
        let (a, b) = (self.from - point, self.to - point);
        let ends = if a.norm() <= b.norm() { (a.norm(), self.from) } else { (b.norm(), self.to) };
        let [start, end] = self.tangents();
        if !(start.dot(a) < 0.0 && end.dot(b) > 0.0) {
            return ends;
        }
        let (distance, towards) = self.offset(point);
        (distance.abs(), point + towards * distance)
    }

    /// Signed distance of the whole line or circle from `point`, and the unit vector along which it is measured: the nearest
    /// point is `point + towards * distance`.
    ///
    /// Of a circle it is the power of the point over the sum of both distances: no difference of two long radii.
    pub(crate) fn offset(&self, point: Point) -> (f64, Point) {
        let (a, b) = (self.from - point, self.to - point);
        let w = self.half_chord();
        let normal = (self.to - self.from).right() * (0.5 / w);
        if self.bulge == 0.0 {
            return (a.dot(normal), normal);
        }
        let away = self.centre() - point;
        let power = a.dot(b) - a.dot(normal) * w * (1.0 - self.bulge * self.bulge) / self.bulge;
        (power / (away.norm() + self.radius()), away * (1.0 / away.norm()))
    }

    /// Largest value of `p . direction` on the edge, for a unit vector.
    pub(crate) fn support(&self, direction: Point) -> f64 {
        if self.bulge.abs() > 1.0 {
            let [first, second] = self.halves().map(|half| half.support(direction));
            return first.max(second);
        }
        let ends = self.from.dot(direction).max(self.to.dot(direction));
        let [start, end] = self.tangents();
        if self.bulge == 0.0 || start.dot(direction) <= 0.0 || end.dot(direction) >= 0.0 {
            return ends;
        }
        // centre . direction + radius, as height over the chord plus what the direction leans off the bisector.
        let w = self.half_chord();
        let along = (self.to - self.from) * (0.5 / w);
        let sine = along.dot(direction);
        let cosine = along.right().dot(direction) * self.bulge.signum();
        let lean = sine * sine / (1.0 + cosine.max(0.0));
        let bulge = self.bulge.abs();
        let top = self.middle_of_chord().dot(direction)
            + w * bulge
            + w * (1.0 - bulge * bulge) / (2.0 * bulge) * lean;
        top.max(ends)
    }

    /// Signed angle [rad] that the edge turns through as seen from `point`, which must not lie on it.
    pub(crate) fn turn_about(&self, point: Point) -> f64 {
        if self.bulge.abs() > 1.0 {
            return self.halves().iter().map(|half| half.turn_about(point)).sum();
        }
        let (a, b) = (self.from - point, self.to - point);
        // Plus zero turns a negative zero into a positive one: on the chord the angle is pi, not -pi.
        let cross = a.cross(b) + 0.0;
        let chord = cross.atan2(a.dot(b));
        if self.bulge == 0.0 {
            return chord;
        }
        let beyond_chord = if self.bulge > 0.0 { cross < 0.0 } else { cross >= 0.0 };
        let w = self.half_chord();
        // Negative power: within the circle.
        let unit = (self.to - self.from).right() * (0.5 / w);
        let power = a.dot(b) - a.dot(unit) * w * (1.0 - self.bulge * self.bulge) / self.bulge;
        if beyond_chord && power < 0.0 { chord + std::f64::consts::TAU * self.bulge.signum() } else { chord }
    }
}

/// Integrals over the triangle from the crank axis to an edge, negative where it runs clockwise.
fn triangle(p: Point, q: Point) -> AreaMoments {
    let cross = p.cross(q);
    AreaMoments {
        area: cross / 2.0,
        first: (p + q) * (cross / 6.0),
        xx: cross * (p.x * p.x + p.x * q.x + q.x * q.x) / 12.0,
        yy: cross * (p.y * p.y + p.y * q.y + q.y * q.y) / 12.0,
        xy: cross * (p.x * q.y + 2.0 * p.x * p.y + 2.0 * q.x * q.y + q.x * p.y) / 24.0,
    }
}
