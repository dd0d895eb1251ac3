//! A range of directions in which the corner of a shape's chord lies, and what the envelope then asks of the shape.
//!
//! An envelope is a radius by direction. In which direction a shape has its corner decides which of the radii hold for its corner and which for
//! its arc, so that every range of directions is a problem of its own, in which all of that is smooth (book, eqs. 22.74 and 22.75):
//!
//! ```text
//! corner (y, w)   within the range:   w cos f - y sin f >= 0 at its beginning, <= 0 at its end
//!                 within the circle through both ends of the envelope there:   y^2 + w^2 - b t.(y, w) - p0 p1 <= 0
//! arc             at each earlier direction f, radius p:   y <= p cos f,
//!                 u (w^2 - y^2 + 2 p cos f y - p^2) + w (1 - u^2)(y - p cos f) <= 0          u = tan(a/2)
//! ```
//! Beyond its corner the flank comes nearer to the axis all the time: the corner keeps the least radius of the directions behind it.

use super::number::Number;
use crate::clearance::RadialEnvelope;

/// Radii closer than this part of them are one.
const SAME: f64 = 1e-9;

/// A direction and the radius in it, in units of the problem's length.
#[derive(Debug, Clone, Copy)]
struct Node {
    cosine: f64,
    radius: f64,
}

/// Directions of the corner, and the envelope around a shape that has it there.
#[derive(Debug, Clone)]
pub(super) struct Sector {
    /// First direction [rad].
    pub from: f64,
    /// Last direction [rad].
    pub to: f64,
    /// Largest distance of the crown.
    pub crown: f64,
    /// Least radius of the envelope in any direction.
    pub least: f64,
    /// What is linear in the corner, of the circle that bounds it.
    slope: [f64; 2],
    /// Square of the distance that it bounds without that.
    square: f64,
    /// Least radius of the directions behind, where that is less than here.
    behind: Option<f64>,
    /// Earlier directions.
    nodes: Vec<Node>,
    /// The nearest of them along the shape's own direction: the chord lies before all.
    ahead: f64,
}

impl Sector {
    /// All of an envelope; `length` is the problem's [m]. Where the radius stays the same there is one.
    pub fn all(envelope: &RadialEnvelope, length: f64) -> Vec<Sector> {
        let all: Vec<[f64; 2]> = envelope
            .directions
            .iter()
            .zip(&envelope.radii)
            .map(|(at, radius)| [*at, radius / length])
            .collect();
        let is_same = |a: f64, b: f64| (a - b).abs() <= SAME * a.abs().max(b.abs());
        // A direction amid equal radii says nothing new.
        let says = |at: &usize| {
            *at == 0
                || *at + 1 == all.len()
                || !(is_same(all[*at - 1][1], all[*at][1]) && is_same(all[*at][1], all[*at + 1][1]))
        };
        let ends: Vec<[f64; 2]> = (0..all.len()).filter(says).map(|at| all[at]).collect();
        let least = ends.iter().map(|end| end[1]).fold(f64::INFINITY, f64::min);
        let node = |[at, radius]: [f64; 2]| Node { cosine: at.cos(), radius };
        let sector = |(number, pair): (usize, &[[f64; 2]])| {
            let ([from, first], [to, last]) = (pair[0], pair[1]);
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let b = (last - first) / half.sin();
            let nodes: Vec<Node> = ends[1..=number].iter().copied().map(node).collect();
            let ahead = nodes.iter().map(|node| node.radius * node.cosine).fold(f64::INFINITY, f64::min);
            let behind = ends[number + 1..].iter().map(|end| end[1]).fold(f64::INFINITY, f64::min);
            Sector {
                from,
                to,
                crown: ends[0][1],
                least,
                slope: [-b * middle.sin(), b * middle.cos()],
                square: first * last,
                behind: (behind < first.max(last) * (1.0 - SAME)).then_some(behind),
                nodes,
                ahead,
            }
        };
        ends.windows(2).enumerate().map(sector).collect()
    }

    /// Whether a corner lies within the directions.
    pub fn holds(&self, y: f64, w: f64) -> bool {
        let direction = w.atan2(y);
        direction >= self.from - SAME && direction <= self.to + SAME
    }

    /// What must not be positive: `y` is the distance of the chord, `w` half of it, `u` the tangent of half the arc's half angle.
    pub fn terms<T: Number>(&self, y: T, w: T, u: T, mut push: impl FnMut(T)) {
        push(y.times(self.from.sin()) - w.times(self.from.cos()));
        push(w.times(self.to.cos()) - y.times(self.to.sin()));
        let (y2, w2) = (y.square(), w.square());
        let corner = y2 + w2;
        push(corner - y.times(self.slope[0]) - w.times(self.slope[1]) - T::of(self.square));
        if let Some(behind) = self.behind {
            push(corner - T::of(behind * behind));
        }
        if self.nodes.is_empty() {
            return;
        }
        push(y - T::of(self.ahead));
        let flat = w - w * u.square();
        let (whole, high) = (u * (w2 - y2) + flat * y, u * y);
        for node in &self.nodes {
            let ahead = node.radius * node.cosine;
            push(whole + high.times(2.0 * ahead) - u.times(node.radius * node.radius) - flat.times(ahead));
        }
    }
}
