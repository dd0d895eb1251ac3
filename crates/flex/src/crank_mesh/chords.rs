//! Straight chords with the middle of their arc.

use lanchester_shape::{Edge, Point};
use std::f64::consts::PI;

/// Edges of an outline shorter than this are left out [m].
const SHORT: f64 = 2e-5;

/// Points, and chords with the middle of their arc.
#[derive(Debug, Clone, Default)]
pub(super) struct Chords {
    pub points: Vec<Point>,
    pub chords: Vec<([usize; 2], Point)>,
}

/// A closed line of chords.
#[derive(Debug, Clone, Default)]
pub(super) struct Polygon(pub Vec<[Point; 2]>);

impl Polygon {
    /// Whether a point is within: a ray from it crosses an odd number of chords.
    pub fn contains(&self, at: Point) -> bool {
        let crossed = self.0.iter().filter(|[a, b]| {
            let spans = (a.y > at.y) != (b.y > at.y);
            spans && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)
        });
        crossed.count() % 2 == 1
    }
}

impl Chords {
    /// All chords as one polygon, holes included.
    pub fn polygon(&self) -> Polygon {
        Polygon(self.chords.iter().map(|([a, b], _)| [self.points[*a], self.points[*b]]).collect())
    }

    fn point(&mut self, at: Point) -> usize {
        if let Some(found) = self.points.iter().position(|point| (*point - at).norm() < SHORT) {
            return found;
        }
        self.points.push(at);
        self.points.len() - 1
    }
}

/// Chords no longer than `size` and no more than 12 degrees along edges.
pub(super) fn outline_chords(edges: &[Edge], size: f64) -> Chords {
    let mut result = Chords::default();
    // Half the edges where they turn by more than a half circle: points along an edge are exact up to there.
    let halved = edges
        .iter()
        .flat_map(|edge| if edge.bulge.abs() > 0.9 { edge.halves().to_vec() } else { vec![*edge] });
    for edge in halved {
        let turn = 4.0 * edge.bulge.abs().atan();
        let count = ((edge.length() / size).ceil().max((turn / (PI / 15.0)).ceil()) as usize).max(1);
        for k in 0..count {
            let at = |part: f64| edge.at((k as f64 + part) / count as f64).0;
            let ends = [result.point(at(0.0)), result.point(at(1.0))];
            if ends[0] != ends[1] {
                result.chords.push((ends, at(0.5)));
            }
        }
    }
    result
}
