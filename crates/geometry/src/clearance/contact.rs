//! A plate that turns against a body that moves: the distance at a point of the outline and an angle, and how it changes.
//!
//! Cells are ranges of crank angle times a part of an edge. Within a cell the point of the outline, in the frame of the body, is
//!
//! ```text
//! y = y0 + y_theta dtheta + y_part dpart + rest       |rest| <= 1/2 (A dtheta^2 + 2 B |dtheta dpart| + C dpart^2)    (22.63)
//! A = n^2 rho + |o''| + 2 |a'| (|n| rho + |o'|) + (|a''| + a'^2)(rho + |o|)     B = (|n| + |a'|) L     C = L turn
//! ```
//! | symbol        | name                                                                     | unit |
//! |---------------|--------------------------------------------------------------------------|------|
//! | n, rho        | speed ratio of what turns, largest distance of the edge from its axis    | -, m |
//! | o, a          | origin of the body's frame from that axis, its angle; their derivatives  | m    |
//! | L, turn       | length and included angle of the edge; `part` runs from 0 to 1           | m    |
//!
//! The distance `f` is convex but for a known bend `K` ([`Section`]), so that its tangent is a lower bound:
//! `f >= f0 + grad f . (y - y0) - K (across)^2/2`, and `|grad f| <= 1` takes the rest in.

use crate::clearance::frame::{Frame, FrameBounds, Pose};
use crate::clearance::motion::RodMotion;
use crate::clearance::section::{Level, Section};
use crate::clearance::turning_body::{Piece, Plate, Spindle};
use lanchester_shape::Point;

/// A plate against a body.
#[derive(Debug, Clone)]
pub(super) struct Contact<'a> {
    /// What turns.
    pub plate: &'a Plate,
    /// What it turns with.
    pub spindle: Spindle,
    /// What the body moves with.
    pub frame: Frame,
    /// The body.
    pub section: Section,
    /// Whether the body turns with the same crankshaft.
    pub is_rigid: bool,
    bounds: FrameBounds,
}

/// A range of crank angles and a part of an edge, as middles and half widths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range2 {
    /// Angle of crankshaft 1 [rad].
    pub theta: f64,
    /// Half its range.
    pub half_angle: f64,
    /// Part of the edge.
    pub part: f64,
    /// Half its range.
    pub half_part: f64,
}

/// The point in the middle of a cell, in the frame of the body, and what bounds the others.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    /// The point [m].
    pub at: Point,
    /// Its change over half the range of angles [m].
    pub by_angle: Point,
    /// Its change over half the range of the edge [m].
    pub by_part: Point,
    /// Bound of the rest from the angle alone [m].
    pub rest_of_angle: f64,
    /// Bound of the rest [m].
    pub rest: f64,
}

impl<'a> Contact<'a> {
    /// A plate on a spindle against a body.
    pub fn new<M: RodMotion>(
        plate: &'a Plate,
        spindle: Spindle,
        frame: Frame,
        section: Section,
        is_rigid: bool,
        motions: &[M],
    ) -> Contact<'a> {
        let bounds = frame.bounds(motions, spindle.axis);
        Contact { plate, spindle, frame, section, is_rigid, bounds }
    }

    /// The middle of a cell on `piece`, with the body's pose at its angle.
    pub fn local(&self, piece: &Piece, cell: &Range2, pose: &Pose) -> Local {
        let ratio = self.spindle.ratio.value();
        let (sin, cos) = self.spindle.angle(cell.theta).sin_cos();
        let turned = |p: Point| Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        let (point, along) = piece.edge.at(cell.part);
        let (arm, along) = (turned(point), turned(along));
        let at = pose.seen(self.spindle.axis + arm);
        let rate = pose.directed(-arm.right() * ratio - pose.rate) + at.right() * pose.spin;
        let half_angle = if self.is_rigid { 0.0 } else { cell.half_angle };
        let (h, k) = (half_angle, cell.half_part);
        let [first, second] = self.bounds.angle;
        let [away, speed, acceleration] = self.bounds.origin;
        let (n, rho) = (ratio.abs(), piece.reach);
        let a = n * n * rho
            + acceleration
            + 2.0 * first * (n * rho + speed)
            + (second + first * first) * (rho + away);
        let rest_of_angle = 0.5 * a * h * h;
        let rest =
            rest_of_angle + (n + first) * piece.length * h * k + 0.5 * piece.length * piece.turn * k * k;
        Local { at, by_angle: rate * h, by_part: pose.directed(along) * k, rest_of_angle, rest }
    }

    /// Whether the plate holds the origin of the body's frame at an angle.
    pub fn holds_body(&self, pose: &Pose, theta: f64) -> bool {
        let inside = (pose.origin - self.spindle.axis).turned(-self.spindle.angle(theta));
        self.section.is_bounded() && self.plate.outline.as_ref().is_some_and(|o| o.contains(inside))
    }

    /// The point of a piece in the engine [m].
    pub fn placed(&self, point: Point, theta: f64) -> Point {
        self.spindle.axis + point.turned(self.spindle.angle(theta))
    }
}

impl Local {
    /// Least distance in the cell, at least: first of all that the angle alone can do, then of all.
    pub fn bounds(&self, section: &Section, level: &Level) -> [f64; 2] {
        let slope = |by: Point| level.gradient.dot(by).abs();
        let (of_angle, of_part) = (slope(self.by_angle), slope(self.by_part));
        let bend = section.bend();
        let across = |rest: f64, part: f64| {
            let way = self.by_angle.y.abs() + part * self.by_part.y.abs() + rest;
            0.5 * bend * way * way
        };
        [
            level.distance - of_angle - self.rest_of_angle - across(self.rest_of_angle, 0.0),
            level.distance - of_angle - of_part - self.rest - across(self.rest, 1.0),
        ]
    }

    /// Whether halving the range of angles promises more than halving that of the edge.
    pub fn is_wider_in_angle(&self) -> bool {
        let by_angle = self.by_angle.norm() + self.rest_of_angle;
        let by_part = self.by_part.norm() + (self.rest - self.rest_of_angle);
        by_angle > by_part
    }
}
