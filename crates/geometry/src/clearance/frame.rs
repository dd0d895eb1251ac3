//! Frames that move with pistons, liners, crankpins and rods, as seen from what turns.

use crate::clearance::motion::RodMotion;
use crate::clearance::turning_body::Spindle;
use lanchester_shape::Point;

/// What a body moves with.
#[derive(Debug, Clone, Copy)]
pub(super) enum Frame {
    /// A point of a piston on its cylinder axis, `x` along the axis away from the crank.
    Piston {
        /// Foot of the cylinder axis next to the crank axis [m].
        foot: Point,
        /// Direction of the cylinder axis.
        along: Point,
        /// Place of the point from the piston pin [m].
        shift: f64,
        /// Index of the cylinder.
        cylinder: usize,
    },
    /// A place that stands still.
    Fixed {
        /// The place [m].
        at: Point,
        /// Direction of its `x`.
        along: Point,
    },
    /// A crankpin; its directions are those of the engine.
    Crankpin {
        /// Its crankshaft.
        spindle: Spindle,
        /// Where it stands at the angle zero of its crankshaft, from its axis [m].
        at: Point,
    },
    /// The lower pin of a rod, `x` towards the piston pin.
    Rod {
        /// Axis of its crankshaft [m].
        axis: Point,
        /// Index of the cylinder.
        cylinder: usize,
    },
}

/// Where a frame stands, and its rates per radian of crankshaft 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pose {
    /// Its origin [m].
    pub origin: Point,
    /// Rate of the origin [m/rad].
    pub rate: Point,
    /// Direction of its `x`.
    pub along: Point,
    /// Rate of its angle.
    pub spin: f64,
}

/// Bounds over all angles: distance of the origin from the axis of what turns with its first two derivatives [m], and the
/// first two derivatives of the angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct FrameBounds {
    /// Of the origin.
    pub origin: [f64; 3],
    /// Of the angle.
    pub angle: [f64; 2],
}

impl Frame {
    /// Where it stands.
    pub fn pose<M: RodMotion>(&self, motions: &[M], theta: f64) -> Pose {
        match *self {
            Frame::Piston { foot, along, shift, cylinder } => {
                let pose = motions[cylinder].pose(theta);
                Pose {
                    origin: foot + along * (pose.travel + shift),
                    rate: along * pose.travel_rate,
                    along,
                    spin: 0.0,
                }
            }
            Frame::Fixed { at, along } => Pose { origin: at, rate: Point::ORIGIN, along, spin: 0.0 },
            Frame::Crankpin { spindle, at } => {
                let arm = at.turned(spindle.angle(theta));
                Pose {
                    origin: spindle.axis + arm,
                    rate: -arm.right() * spindle.ratio.value(),
                    along: Point::new(1.0, 0.0),
                    spin: 0.0,
                }
            }
            Frame::Rod { axis, cylinder } => {
                let pose = motions[cylinder].pose(theta);
                Pose {
                    origin: axis + pose.lower_pin,
                    rate: pose.lower_pin_rate,
                    along: Point::polar(1.0, pose.direction),
                    spin: pose.direction_rate,
                }
            }
        }
    }

    /// How far and fast it goes, seen from a crank axis.
    pub fn bounds<M: RodMotion>(&self, motions: &[M], from: Point) -> FrameBounds {
        match *self {
            Frame::Piston { foot, shift, cylinder, .. } => {
                // Rates alone matter: it does not turn.
                let [first, second] = motions[cylinder].bounds().travel;
                FrameBounds { origin: [(foot - from).norm() + shift.abs(), first, second], angle: [0.0; 2] }
            }
            Frame::Fixed { at, .. } => {
                FrameBounds { origin: [(at - from).norm(), 0.0, 0.0], angle: [0.0; 2] }
            }
            Frame::Crankpin { spindle, at } => {
                let (radius, ratio) = (at.norm(), spindle.ratio.value().abs());
                let origin = [(spindle.axis - from).norm() + radius, ratio * radius, ratio * ratio * radius];
                FrameBounds { origin, angle: [0.0; 2] }
            }
            Frame::Rod { axis, cylinder } => {
                let bounds = motions[cylinder].bounds();
                let [reach, first, second] = bounds.lower_pin;
                let origin = [(axis - from).norm() + reach, first, second];
                FrameBounds { origin, angle: bounds.direction }
            }
        }
    }
}

impl Pose {
    /// A point of the engine in the frame.
    pub fn seen(&self, point: Point) -> Point {
        let away = point - self.origin;
        Point::new(self.along.dot(away), self.along.cross(away))
    }

    /// A vector of the engine in the frame's directions.
    pub fn directed(&self, vector: Point) -> Point {
        Point::new(self.along.dot(vector), self.along.cross(vector))
    }

    /// A point of the frame in the engine.
    pub fn placed(&self, point: Point) -> Point {
        self.origin + self.along * point.x - self.along.right() * point.y
    }
}
