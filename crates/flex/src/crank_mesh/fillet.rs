//! The sharp corner between a bar and a web pulled onto the torus of its fillet.
//!
//! ```text
//! rho: outside the cylinder   zeta: from the web's face into the bar   corner at (0, 0)
//! cylinder, 0 <= zeta <= R    a = (pi/4)(1 - zeta/R)    to (R (1 - cos a), R (1 - sin a))                    (book, eq. 43.9)
//! face,     0 <= rho  <= R    a = (pi/4)(1 + rho/R)
//! inside    times w(u) = (1 - u)^2 (1 + 2 u), u the depth below the cylinder and below the face over H
//! ```

use lanchester_shape::Point;
use std::f64::consts::FRAC_PI_4;

/// A fillet at one end of a bar.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Torus {
    pub centre: Point,
    /// Radius of the bar [m].
    pub bar: f64,
    /// Radius of the fillet [m].
    pub radius: f64,
    /// The web's face [m].
    pub face: f64,
    /// Direction along z into the bar: 1 or -1.
    pub into: f64,
    /// Depths at which the displacement has faded: below the cylinder, below the face [m].
    pub fade: [f64; 2],
}

/// Where a node lies by a fillet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Surface,
    Elsewhere,
}

impl Torus {
    /// Displacement of a point of the body with the sharp corner, and whether it is on the fillet's surface.
    pub fn displacement(&self, at: [f64; 3]) -> ([f64; 3], Side) {
        let from = Point::new(at[0], at[1]) - self.centre;
        let (distance, r, tiny) = (from.norm(), self.radius, 1e-9);
        let (rho, zeta) = (distance - self.bar, self.into * (at[2] - self.face));
        if zeta > r + tiny || zeta < -self.fade[1] || rho > r + tiny || rho < -self.fade[0] {
            return ([0.0; 3], Side::Elsewhere);
        }
        let fade = |depth: f64, over: f64| {
            let u = (depth / over).clamp(0.0, 1.0);
            (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u)
        };
        let on_cylinder = |zeta: f64| {
            let a = FRAC_PI_4 * (1.0 - zeta / r);
            [r * (1.0 - a.cos()), r * (1.0 - a.sin()) - zeta]
        };
        let on_face = |rho: f64| {
            let a = FRAC_PI_4 * (1.0 + rho / r);
            [r * (1.0 - a.cos()) - rho, r * (1.0 - a.sin())]
        };
        let below = [fade(-rho, self.fade[0]), fade(-zeta, self.fade[1])];
        let [out, along] = match (rho > tiny, zeta > tiny) {
            (true, true) => return ([0.0; 3], Side::Elsewhere),
            (false, true) => on_cylinder(zeta.min(r)).map(|u| below[0] * u),
            (true, false) => on_face(rho.min(r)).map(|u| below[1] * u),
            (false, false) => on_face(0.0).map(|u| below[0] * below[1] * u),
        };
        let surface = (rho.abs() <= tiny && zeta >= -tiny) || (zeta.abs() <= tiny && rho >= -tiny);
        let radial = if distance > 0.0 { from * (out / distance) } else { Point::ORIGIN };
        let side = if surface { Side::Surface } else { Side::Elsewhere };
        ([radial.x, radial.y, self.into * along], side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surface_lands_on_the_torus() {
        let torus = Torus {
            centre: Point::new(0.01, 0.0),
            bar: 0.024,
            radius: 0.003,
            face: 0.1,
            into: -1.0,
            fade: [0.009; 2],
        };
        for k in 0..=20 {
            let part = 0.003 * f64::from(k) / 20.0;
            for (rho, zeta) in [(part, 0.0), (0.0, part)] {
                let at = [0.01, 0.024 + rho, 0.1 - zeta];
                let (u, side) = torus.displacement(at);
                assert_eq!(side, Side::Surface);
                let (rho, zeta) = (at[1] + u[1] - 0.024, 0.1 - at[2] - u[2]);
                let distance = (rho - 0.003).hypot(zeta - 0.003);
                assert!((distance - 0.003).abs() < 1e-15, "{rho} {zeta}");
                assert!(u[0].abs() < 1e-18);
            }
        }
        assert_eq!(torus.displacement([0.01, 0.02, 0.2]).0, [0.0; 3]);
    }
}
