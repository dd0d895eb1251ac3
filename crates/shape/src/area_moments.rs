//! Area, first and second moments of a plane figure about the crank axis.

use crate::point::Point;
use serde::{Deserialize, Serialize};
use std::ops::{Add, Mul, Sub};

/// Integrals over a plane figure, about the crank axis.
///
/// ```text
/// area = INTEGRAL dA     first = INTEGRAL (x, y) dA     second = INTEGRAL (x^2, y^2, x y) dA
/// [m^2]                  [m^3]                          [m^4]
/// ```
/// They add: a hole is subtracted. Parallel axes: [`AreaMoments::moved`].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct AreaMoments {
    /// Area [m^2].
    pub area: f64,
    /// First moments: area times centroid [m^3].
    pub first: Point,
    /// `INTEGRAL x^2 dA` [m^4].
    pub xx: f64,
    /// `INTEGRAL y^2 dA` [m^4].
    pub yy: f64,
    /// `INTEGRAL x y dA` [m^4].
    pub xy: f64,
}

impl AreaMoments {
    /// Centroid [m]; not a number where the area is zero.
    pub fn centroid(&self) -> Point {
        self.first * (1.0 / self.area)
    }

    /// Polar second moment `INTEGRAL (x^2 + y^2) dA` about the crank axis [m^4].
    pub fn polar(&self) -> f64 {
        self.xx + self.yy
    }

    /// Of the same figure moved by `by`.
    pub fn moved(&self, by: Point) -> AreaMoments {
        let AreaMoments { area, first, xx, yy, xy } = *self;
        AreaMoments {
            area,
            first: first + by * area,
            xx: xx + 2.0 * by.x * first.x + by.x * by.x * area,
            yy: yy + 2.0 * by.y * first.y + by.y * by.y * area,
            xy: xy + by.x * first.y + by.y * first.x + by.x * by.y * area,
        }
    }

    /// Of a disc of this radius [m] about `centre`.
    pub fn disc(centre: Point, radius: f64) -> AreaMoments {
        let area = std::f64::consts::PI * radius * radius;
        let quarter = area * radius * radius / 4.0;
        AreaMoments { area, first: Point::ORIGIN, xx: quarter, yy: quarter, xy: 0.0 }.moved(centre)
    }
}

impl Add for AreaMoments {
    type Output = AreaMoments;
    fn add(self, other: AreaMoments) -> AreaMoments {
        AreaMoments {
            area: self.area + other.area,
            first: self.first + other.first,
            xx: self.xx + other.xx,
            yy: self.yy + other.yy,
            xy: self.xy + other.xy,
        }
    }
}

impl Mul<f64> for AreaMoments {
    type Output = AreaMoments;
    fn mul(self, factor: f64) -> AreaMoments {
        let AreaMoments { area, first, xx, yy, xy } = self;
        AreaMoments {
            area: area * factor,
            first: first * factor,
            xx: xx * factor,
            yy: yy * factor,
            xy: xy * factor,
        }
    }
}

impl Sub for AreaMoments {
    type Output = AreaMoments;
    fn sub(self, other: AreaMoments) -> AreaMoments {
        self + other * -1.0
    }
}
