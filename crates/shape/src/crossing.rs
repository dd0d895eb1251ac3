//! Where two edges cross or touch.

use crate::edge::Edge;
use crate::point::Point;

/// Points closer than this part of the size of the contours count as one.
pub(crate) const TOUCH: f64 = 1e-9;
/// Tangential neighbours come this close to each other beside their common corner, by rounding, as part of the size.
const CORNER: f64 = 1e-6;

/// Bulge of an arc that is taken for its chord to begin with. Two crossings with less depth than this part of the edge are
/// not told from none.
const FLAT: f64 = 1e-6;

/// How two edges hang together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Joint {
    /// Not neighbours.
    Apart,
    /// They share this corner.
    Corner(Point),
    /// They share both ends.
    BothEnds,
}

/// A point where two edges of contours of this size meet outside their common corners.
pub(crate) fn crossing(first: &Edge, second: &Edge, joint: Joint, size: f64) -> Option<Point> {
    let tolerance = TOUCH * size;
    if boxes_apart(first, second, tolerance) {
        return None;
    }
    let shared = |point: &Point| match joint {
        Joint::Apart => false,
        Joint::Corner(corner) => (*point - corner).norm() < CORNER * size,
        Joint::BothEnds => [first.from, first.to].iter().any(|end| (*point - *end).norm() < CORNER * size),
    };
    // Ends that lie on the other edge: touching, and edges that run along each other.
    let ends = [(first.from, second), (first.to, second), (second.from, first), (second.to, first)];
    let touching =
        ends.into_iter().filter(|(end, other)| other.nearest(*end).0 < tolerance).map(|(end, _)| end);
    meetings(first, second, tolerance).chain(touching).find(|point| !shared(point))
}

/// The points where the lines or circles of two edges meet, as far as they lie on both edges: at most two, none where one
/// runs along the other.
pub(crate) fn meetings(first: &Edge, second: &Edge, tolerance: f64) -> impl Iterator<Item = Point> {
    let estimates = match (is_flat(first), is_flat(second)) {
        _ if boxes_apart(first, second, tolerance) => [None; 2],
        (true, true) => lines(first, second),
        (true, false) => line_and_arc(first, second),
        (false, true) => line_and_arc(second, first),
        (false, false) => arcs(first, second, tolerance),
    };
    let on_both = move |point: &Point| {
        let slack = tolerance * 10.0;
        first.nearest(*point).0 < slack && second.nearest(*point).0 < slack
    };
    estimates.into_iter().flatten().map(|point| polished(first, second, point)).filter(on_both)
}

/// Whether the chord tells where the edge meets another, to begin with: the centre of a flatter arc is too far away for that.
fn is_flat(edge: &Edge) -> bool {
    edge.bulge.abs() < FLAT
}

/// The common point of both lines or circles near a first estimate, by Newton's method on the distances from them, as long as
/// that brings the point nearer to both. Where they touch, the estimate is as good as any.
fn polished(first: &Edge, second: &Edge, mut point: Point) -> Point {
    let (mut on_first, mut on_second) = (first.offset(point), second.offset(point));
    for _ in 0..6 {
        let ((f, m), (g, n)) = (on_first, on_second);
        let determinant = m.cross(n);
        if determinant.is_nan() || determinant.abs() < 1e-12 {
            break;
        }
        let next = point + Point::new(f * n.y - g * m.y, g * m.x - f * n.x) * (1.0 / determinant);
        let there = (first.offset(next), second.offset(next));
        let nearer = there.0.0.abs() + there.1.0.abs() < f.abs() + g.abs();
        if !nearer {
            break;
        }
        (point, on_first, on_second) = (next, there.0, there.1);
    }
    point
}

fn boxes_apart(first: &Edge, second: &Edge, tolerance: f64) -> bool {
    let reach = |edge: &Edge| edge.half_chord() * edge.bulge.abs().max(1.0);
    let between = first.middle_of_chord() - second.middle_of_chord();
    // A disc about the middle of the chord holds the edge: height and half chord are no longer than its radius.
    between.norm() > 2.0f64.sqrt() * (reach(first) + reach(second)) + tolerance
}

fn lines(first: &Edge, second: &Edge) -> [Option<Point>; 2] {
    let (u, v) = (first.to - first.from, second.to - second.from);
    let determinant = u.cross(v);
    if determinant.abs() <= 1e-12 * u.norm() * v.norm() {
        return [None; 2];
    }
    let t = (second.from - first.from).cross(v) / determinant;
    [Some(first.from + u * t), None]
}

fn line_and_arc(line: &Edge, arc: &Edge) -> [Option<Point>; 2] {
    let (centre, radius) = (arc.centre(), arc.radius());
    let direction = line.to - line.from;
    let unit = direction * (1.0 / direction.norm());
    let foot = line.from + unit * (centre - line.from).dot(unit);
    let distance = (foot - centre).norm();
    let square = (radius - distance) * (radius + distance);
    // A line that just misses the circle touches it, as far as the tolerance of the caller says so.
    let half = square.max(0.0).sqrt();
    [Some(foot + unit * half), Some(foot - unit * half)]
}

fn arcs(first: &Edge, second: &Edge, tolerance: f64) -> [Option<Point>; 2] {
    let (r1, r2) = (first.radius(), second.radius());
    let between = second.centre() - first.centre();
    let distance = between.norm();
    if distance < tolerance {
        return [None; 2];
    }
    let unit = between * (1.0 / distance);
    let along = (distance + (r1 - r2) * (r1 + r2) / distance) / 2.0;
    let half = ((r1 - along) * (r1 + along)).max(0.0).sqrt();
    let foot = first.centre() + unit * along;
    [Some(foot + unit.right() * half), Some(foot - unit.right() * half)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64) -> Point {
        Point::new(x, y)
    }

    #[test]
    fn lines_cross_touch_or_pass() {
        let flat = Edge::line(at(0.0, 0.0), at(2.0, 0.0));
        let through = Edge::line(at(1.0, -1.0), at(1.0, 1.0));
        assert_eq!(crossing(&flat, &through, Joint::Apart, 2.0), Some(at(1.0, 0.0)));
        let onto = Edge::line(at(1.5, 0.0), at(1.0, 1.0));
        assert_eq!(crossing(&flat, &onto, Joint::Apart, 2.0), Some(at(1.5, 0.0)));
        let along = Edge::line(at(1.0, 0.0), at(3.0, 0.0));
        assert!(crossing(&flat, &along, Joint::Apart, 2.0).is_some());
        let past = Edge::line(at(1.0, 0.1), at(1.0, 1.0));
        assert_eq!(crossing(&flat, &past, Joint::Apart, 2.0), None);
    }

    #[test]
    fn arcs_cross_where_their_circles_do() {
        let upper = Edge::arc(at(0.0, 0.0), 1.0, 0.0, std::f64::consts::PI);
        let line = Edge::line(at(0.6, -2.0), at(0.6, 2.0));
        let meeting = crossing(&upper, &line, Joint::Apart, 2.0).unwrap();
        assert!((meeting - at(0.6, 0.8)).norm() < 1e-12);
        let beside = Edge::arc(at(1.0, 0.0), 1.0, 0.1, 2.9);
        let meeting = crossing(&upper, &beside, Joint::Apart, 2.0).unwrap();
        assert!((meeting - at(0.5, 0.75f64.sqrt())).norm() < 1e-12);
        let lower = Edge::arc(at(1.0, 0.0), 1.0, -0.1, -2.9);
        assert_eq!(crossing(&upper, &lower, Joint::Apart, 2.0), None);
    }

    #[test]
    fn tangential_neighbours_do_not_cross() {
        let arc = Edge::arc(at(0.0, 0.0), 1.0, 0.0, 1.5);
        let end = arc.to;
        let line = Edge::line(end, end + arc.tangents()[1] * 3.0);
        assert_eq!(crossing(&arc, &line, Joint::Corner(end), 3.0), None);
        let back = Edge::arc(at(0.0, 0.0), 1.0, 1.5, -0.7);
        assert!(crossing(&arc, &back, Joint::Corner(end), 3.0).is_some());
    }
}
