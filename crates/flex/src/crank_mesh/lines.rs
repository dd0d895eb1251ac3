//! Edges of outlines cut where others begin on them.

use lanchester_shape::{Edge, Point};
use std::f64::consts::TAU;

/// A corner this close to an edge lies on it [m].
const ON: f64 = 1e-7;
/// A corner this close to an end of an edge is that end [m].
const END: f64 = 2e-5;

/// Cuts the edges of each outline at the corners of all that lie on them: edges that run along each other become the same pieces.
pub(super) fn split(outlines: &[Vec<Edge>]) -> Vec<Vec<Edge>> {
    let mut corners: Vec<Point> = Vec::new();
    for edge in outlines.iter().flatten() {
        for end in [edge.from, edge.to] {
            if corners.iter().all(|corner| (*corner - end).norm() > ON) {
                corners.push(end);
            }
        }
    }
    outlines.iter().map(|edges| edges.iter().flat_map(|edge| pieces(edge, &corners)).collect()).collect()
}

fn pieces(edge: &Edge, corners: &[Point]) -> Vec<Edge> {
    let is_inside = |corner: &&Point| {
        (**corner - edge.from).norm() > END
            && (**corner - edge.to).norm() > END
            && edge.nearest(**corner).0 < ON
    };
    let mut parts: Vec<(f64, Point)> =
        corners.iter().filter(is_inside).map(|corner| (part(edge, *corner), *corner)).collect();
    parts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut pieces = Vec::with_capacity(parts.len() + 1);
    let (mut from, mut at) = (0.0, edge.from);
    let turn = edge.bulge.atan();
    for (to, corner) in parts.into_iter().chain([(1.0, edge.to)]) {
        pieces.push(Edge { from: at, to: corner, bulge: (turn * (to - from)).tan() });
        (from, at) = (to, corner);
    }
    pieces
}

/// Part of an edge's length at which a point on it lies.
fn part(edge: &Edge, at: Point) -> f64 {
    if edge.bulge == 0.0 {
        let chord = edge.to - edge.from;
        return (at - edge.from).dot(chord) / chord.dot(chord);
    }
    let (start, own) = (edge.from - edge.centre(), at - edge.centre());
    let angle = start.cross(own).atan2(start.dot(own));
    let turn = 4.0 * edge.bulge.atan();
    (angle * turn.signum()).rem_euclid(TAU) / turn.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_that_run_along_each_other_become_the_same_pieces() {
        let arc = Edge::arc(Point::new(0.01, 0.0), 0.04, 0.2, 2.5);
        let part_of = Edge::arc(Point::new(0.01, 0.0), 0.04, 2.0, -1.2);
        let line = Edge::line(Point::new(0.0, 0.0), Point::new(0.1, 0.0));
        let on_it = Edge::line(Point::new(0.06, 0.0), Point::new(0.06, 0.03));
        let found = split(&[vec![arc, line], vec![part_of, on_it]]);
        assert_eq!(found[0].len(), 3 + 2);
        assert_eq!(found[1].len(), 1 + 1);
        let (one, two) = (found[0][1], found[1][0].reversed());
        assert!((one.from - two.from).norm() < 1e-15 && (one.to - two.to).norm() < 1e-15);
        assert!((one.bulge - two.bulge).abs() < 1e-12);
        let length: f64 = found[0][..3].iter().map(Edge::length).sum();
        assert!((length - arc.length()).abs() < 1e-15);
    }
}
