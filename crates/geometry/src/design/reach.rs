//! How far a counterweight may reach in each direction: a convex envelope, as half-planes.

use super::arc::support;
use super::problem::{Plane, Problem, SHAPE};
use lanchester_shape::CounterweightShape;
use std::f64::consts::PI;

/// The largest `n . p` of the points `p` of a counterweight, for directions `n` evenly from its axis (0) to the opposite (half a turn); a shape of the
/// family is symmetric, so that one half is enough.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    limits: Vec<f64>,
}

/// A plane that is passed by less than this part of the problem's length is kept.
const KEPT: f64 = 1e-10;

impl Reach {
    /// Limits [m] in the directions `k PI/(count - 1)`.
    ///
    /// # Panics
    /// Where there are fewer than two: no direction but the axis.
    pub fn new(limits: Vec<f64>) -> Reach {
        assert!(limits.len() >= 2, "a reach has the directions of both ends");
        Reach { limits }
    }

    /// The direction number `k` [rad].
    fn direction(&self, k: usize) -> f64 {
        PI * k as f64 / (self.limits.len() - 1) as f64
    }

    /// What both leave; both have the same directions.
    pub fn common(self, other: Reach) -> Reach {
        let both = self.limits.iter().zip(&other.limits);
        Reach { limits: both.map(|(one, other)| one.min(*other)).collect() }
    }

    /// Whether both leave the same, to a nanometre.
    pub fn is_like(&self, other: &Reach) -> bool {
        let both = self.limits.iter().zip(&other.limits);
        self.limits.len() == other.limits.len() && both.into_iter().all(|(a, b)| (a - b).abs() <= 1e-9)
    }

    /// By how much a shape passes the planes [m], zero or less where it passes none.
    pub fn excess(&self, shape: &CounterweightShape) -> f64 {
        let (a, w) = (shape.arc_angle / 2.0, shape.half_width());
        let (h, r) = (shape.rectangle_height, shape.web_radius);
        let passed = self.limits.iter().enumerate().map(|(k, limit)| {
            let beta = self.direction(k);
            let arc = shape.chord_distance() * beta.cos() + w * support(a, beta, 0);
            arc.max(h * beta.cos() + r * beta.sin()).max(r) - limit
        });
        passed.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The plane that a shape passes most, if it passes any.
    pub(super) fn broken(&self, problem: &Problem, x: &[f64; SHAPE]) -> Option<Plane> {
        let [r, h, big_h, w, a] = *x;
        let mut worst: Option<(f64, Plane)> = None;
        for (k, limit) in self.limits.iter().enumerate() {
            let limit = limit / problem.length;
            // Nothing of a shape is farther than this.
            if limit >= h + big_h + 2.0 * w.max(r) / a.sin().max(1e-3) {
                continue;
            }
            let beta = self.direction(k);
            let arc = (h + big_h) * beta.cos() + w * support(a, beta, 0);
            let flank = h * beta.cos() + r * beta.sin();
            let excess = arc.max(flank).max(r) - limit;
            if excess > KEPT && worst.is_none_or(|(most, _)| excess > most) {
                worst = Some((excess, Plane { beta, limit }));
            }
        }
        worst.map(|(_, plane)| plane)
    }
}
