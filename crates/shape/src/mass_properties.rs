//! Mass, centre, unbalance and inertia of a solid.

use crate::area_moments::AreaMoments;
use crate::point::Point;
use serde::Serialize;
use std::ops::{Add, Mul, Sub};

/// Integrals of the density over a solid: mass, first and second moments about the point of the crank axis at z = 0.
///
/// They add; what is cut away is subtracted. `x` and `y` as in [`Point`], `z` along the crank axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MassMoments {
    /// Mass [kg].
    pub mass: f64,
    /// First moments in `x`, `y` and `z` [kg m].
    pub first: [f64; 3],
    /// Second moments `xx`, `yy`, `zz`, `yz`, `zx`, `xy` [kg m^2].
    pub second: [f64; 6],
}

/// Mass properties of a solid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MassProperties {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m]: in the plane as [`Point`], and along the crank axis.
    pub centre: [f64; 3],
    /// Unbalance: mass times distance of its centre from the crank axis, as a vector [kg m].
    pub unbalance: Point,
    /// Inertia tensor about the point of the crank axis at z = 0 [kg m^2]; the products stand with their minus sign.
    pub inertia_about_axis: [[f64; 3]; 3],
    /// Inertia tensor about the centre of mass, along the same axes [kg m^2].
    pub inertia_about_centre: [[f64; 3]; 3],
}

impl MassMoments {
    /// Mass properties that follow.
    pub fn properties(&self) -> MassProperties {
        let centre = self.first.map(|first| first / self.mass);
        let at_centre = self.moved([-centre[0], -centre[1], -centre[2]]);
        MassProperties {
            mass: self.mass,
            centre,
            unbalance: Point::new(self.first[0], self.first[1]),
            inertia_about_axis: self.inertia(),
            inertia_about_centre: at_centre.inertia(),
        }
    }

    /// Of a prism over a figure between two planes [m], at density 1 [kg/m^3].
    pub fn prism(figure: &AreaMoments, [front, rear]: [f64; 2]) -> MassMoments {
        let (thickness, middle) = (rear - front, (rear + front) / 2.0);
        let AreaMoments { area, first, xx, yy, xy } = *figure * thickness;
        let zz = middle * middle + thickness * thickness / 12.0;
        MassMoments {
            mass: area,
            first: [first.x, first.y, area * middle],
            second: [xx, yy, area * zz, first.y * middle, first.x * middle, xy],
        }
    }

    /// First moments across the axis: the unbalance [kg m].
    pub fn unbalance(&self) -> Point {
        Point::new(self.first[0], self.first[1])
    }

    /// Moments `INTEGRAL z (x, y) dm` [kg m^2]: the couple that turns with the solid, over the square of the speed.
    pub fn couple(&self) -> Point {
        Point::new(self.second[4], self.second[3])
    }

    /// Of the same solid turned about the crank axis by `angle` [rad].
    pub fn turned(&self, angle: f64) -> MassMoments {
        let [xx, yy, zz, _, _, xy] = self.second;
        let (s, c) = angle.sin_cos();
        let (unbalance, couple) = (self.unbalance().turned(angle), self.couple().turned(angle));
        MassMoments {
            mass: self.mass,
            first: [unbalance.x, unbalance.y, self.first[2]],
            second: [
                c * c * xx - 2.0 * s * c * xy + s * s * yy,
                s * s * xx + 2.0 * s * c * xy + c * c * yy,
                zz,
                couple.y,
                couple.x,
                s * c * (xx - yy) + (c * c - s * s) * xy,
            ],
        }
    }

    /// Of the same solid moved by this vector [m].
    pub fn moved(&self, by: [f64; 3]) -> MassMoments {
        let MassMoments { mass, first, second } = *self;
        let product = |i: usize, j: usize| by[i] * first[j] + by[j] * first[i] + mass * by[i] * by[j];
        let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)];
        MassMoments {
            mass,
            first: [0, 1, 2].map(|i| first[i] + mass * by[i]),
            second: [0, 1, 2, 3, 4, 5].map(|k| second[k] + product(pairs[k].0, pairs[k].1)),
        }
    }

    /// Inertia tensor about the origin [kg m^2].
    pub fn inertia(&self) -> [[f64; 3]; 3] {
        let [xx, yy, zz, yz, zx, xy] = self.second;
        [[yy + zz, -xy, -zx], [-xy, zz + xx, -yz], [-zx, -yz, xx + yy]]
    }
}

impl MassProperties {
    /// Polar inertia about the crank axis [kg m^2].
    pub fn polar_inertia(&self) -> f64 {
        self.inertia_about_axis[2][2]
    }
}

impl Add for MassMoments {
    type Output = MassMoments;
    fn add(self, other: MassMoments) -> MassMoments {
        MassMoments {
            mass: self.mass + other.mass,
            first: [0, 1, 2].map(|i| self.first[i] + other.first[i]),
            second: [0, 1, 2, 3, 4, 5].map(|i| self.second[i] + other.second[i]),
        }
    }
}

impl Mul<f64> for MassMoments {
    type Output = MassMoments;
    fn mul(self, factor: f64) -> MassMoments {
        MassMoments {
            mass: self.mass * factor,
            first: self.first.map(|v| v * factor),
            second: self.second.map(|v| v * factor),
        }
    }
}

impl Sub for MassMoments {
    type Output = MassMoments;
    fn sub(self, other: MassMoments) -> MassMoments {
        self + other * -1.0
    }
}
