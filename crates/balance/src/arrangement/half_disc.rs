//! The weight of a balance shaft as a half disc: how large, how long, how heavy.
//!
//! ```text
//! U = (2/3) rho L R^3      m = (pi/2) rho L R^2      e = U/m = 4 R/(3 pi)      J = m R^2/2
//! ```
//! | symbol | name                                          | unit   |
//! |--------|-----------------------------------------------|--------|
//! | U      | unbalance of the weight                       | kg m   |
//! | R      | outer radius, from the shaft's axis           | m      |
//! | L      | length along the shaft                        | m      |
//! | e      | distance of its centre of gravity             | m      |
//! | J      | inertia about the shaft's axis                | kg m^2 |

use std::f64::consts::PI;

/// A weight in the shape of a half disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfDisc {
    /// `R` [m].
    pub radius: f64,
    /// `L` [m].
    pub length: f64,
    /// `m` [kg].
    pub mass: f64,
}

impl HalfDisc {
    /// Outer radius [m] of a weight of `unbalance` [kg m] that is `length` [m] long.
    pub fn radius_for(unbalance: f64, length: f64, density: f64) -> f64 {
        (1.5 * unbalance / (density * length)).cbrt()
    }

    /// The weight of `unbalance` [kg m] with this outer radius.
    pub fn of(unbalance: f64, radius: f64, density: f64) -> HalfDisc {
        HalfDisc {
            radius,
            length: 1.5 * unbalance / (density * radius.powi(3)),
            mass: unbalance / HalfDisc::centre_of_gravity(radius),
        }
    }

    /// `e` [m] of a half disc of this outer radius.
    pub fn centre_of_gravity(radius: f64) -> f64 {
        4.0 * radius / (3.0 * PI)
    }

    /// `J` [kg m^2].
    pub fn inertia(&self) -> f64 {
        0.5 * self.mass * self.radius * self.radius
    }
}

/// Mass [kg] of a solid cylinder.
pub(crate) fn cylinder_mass(radius: f64, length: f64, density: f64) -> f64 {
    PI * radius * radius * length * density
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_length_mass_and_inertia_agree_with_the_integral() {
        let (unbalance, length, density) = (0.0235, 0.06, 7850.0);
        let radius = HalfDisc::radius_for(unbalance, length, density);
        let weight = HalfDisc::of(unbalance, radius, density);
        assert!((weight.length - length).abs() < 1e-12);
        // Rings of radius r and width dr over half a turn: dm = rho L pi r dr, dU = rho L 2 r^2 dr.
        let count = 20_000;
        let (mut mass, mut moment, mut inertia) = (0.0, 0.0, 0.0);
        for k in 0..count {
            let (r, dr) = (radius * (f64::from(k) + 0.5) / f64::from(count), radius / f64::from(count));
            let ring = density * length * PI * r * dr;
            mass += ring;
            moment += density * length * 2.0 * r * r * dr;
            inertia += ring * r * r;
        }
        // Midpoint rule: relative error near 1/(4 count^2).
        assert!((mass / weight.mass - 1.0).abs() < 1e-8);
        assert!((moment / unbalance - 1.0).abs() < 1e-8);
        assert!((inertia / weight.inertia() - 1.0).abs() < 1e-8);
    }
}
