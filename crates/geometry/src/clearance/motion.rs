//! How rods and pistons move: what the search for clearances asks of a crank train.

use lanchester_shape::Point;

/// Rod and piston of one cylinder at one angle of crankshaft 1. Rates are per radian of that angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodPose {
    /// Lower pin of the rod (crankpin, or knuckle pin of an articulated rod) in the engine's directions, from the axis of the
    /// cylinder's crankshaft [m].
    pub lower_pin: Point,
    /// Its rate [m/rad].
    pub lower_pin_rate: Point,
    /// Direction from the lower pin to the piston pin, from +x towards +y [rad].
    pub direction: f64,
    /// Its rate.
    pub direction_rate: f64,
    /// Travel `s`: the piston pin from the crankshaft's axis along the cylinder axis [m].
    pub travel: f64,
    /// Its rate [m/rad].
    pub travel_rate: f64,
}

/// Upper bounds of a [`RodPose`] and its derivatives over all angles, per radian of crankshaft 1. They must hold, or the
/// proof of a clearance does not; that they are wide costs time only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodBounds {
    /// Largest distance of the lower pin from the crankshaft's axis, size of its first and of its second derivative [m].
    pub lower_pin: [f64; 3],
    /// Size of the first and the second derivative of the direction.
    pub direction: [f64; 2],
    /// Size of the first and the second derivative of the travel [m].
    pub travel: [f64; 2],
}

/// The motion of one cylinder's rod and piston.
pub trait RodMotion {
    /// Where they stand at the angle `theta` of crankshaft 1 [rad].
    fn pose(&self, theta: f64) -> RodPose;
    /// How far and how fast they go.
    fn bounds(&self) -> RodBounds;
}

impl<M: RodMotion + ?Sized> RodMotion for &M {
    fn pose(&self, theta: f64) -> RodPose {
        (**self).pose(theta)
    }

    fn bounds(&self) -> RodBounds {
        (**self).bounds()
    }
}
