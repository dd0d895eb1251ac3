//! Points and vectors of the plane across the crank.

use serde::{Deserialize, Serialize};
use std::ops::{Add, Mul, Neg, Sub};

/// A point of the plane across the crank, or a vector in it [m].
///
/// The origin is the crank axis; a part's own `x` points along its unbalance (a counterweight: away from its
/// crankpin), `y` a quarter turn further in the sense in which the crank turns.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Point {
    /// Along the part's axis [m].
    pub x: f64,
    /// A quarter turn from it [m].
    pub y: f64,
}

impl Point {
    /// The crank axis.
    pub const ORIGIN: Point = Point { x: 0.0, y: 0.0 };

    /// The point `(x, y)` [m].
    pub const fn new(x: f64, y: f64) -> Point {
        Point { x, y }
    }

    /// The point at `radius` [m] and `angle` [rad] from `x` towards `y`.
    pub fn polar(radius: f64, angle: f64) -> Point {
        Point { x: radius * angle.cos(), y: radius * angle.sin() }
    }

    /// Scalar product [m^2].
    pub fn dot(self, other: Point) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// `x1 y2 - y1 x2`, positive if `other` lies to the left [m^2].
    pub fn cross(self, other: Point) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Length [m].
    pub fn norm(self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Turned by a quarter turn clockwise: the right-hand normal of a direction.
    pub fn right(self) -> Point {
        Point { x: self.y, y: -self.x }
    }

    /// Turned about the origin by `angle` [rad].
    pub fn turned(self, angle: f64) -> Point {
        let (s, c) = angle.sin_cos();
        Point { x: c * self.x - s * self.y, y: s * self.x + c * self.y }
    }

    /// Whether both coordinates are numbers.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Point {
    type Output = Point;
    fn add(self, other: Point) -> Point {
        Point { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Point {
    type Output = Point;
    fn sub(self, other: Point) -> Point {
        Point { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Point {
    type Output = Point;
    fn neg(self) -> Point {
        Point { x: -self.x, y: -self.y }
    }
}

impl Mul<f64> for Point {
    type Output = Point;
    fn mul(self, factor: f64) -> Point {
        Point { x: self.x * factor, y: self.y * factor }
    }
}
