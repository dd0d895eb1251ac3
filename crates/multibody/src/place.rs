//! Where piston and rod of a cylinder are: its loop, closed exactly, and the derivatives of the constraint.
//!
//! ```text
//! |W - P| = l,   W = s u + e v,   d = W - P                       s: the root away from the crank
//! s'     = d.P' / (d.u)                  d' = s' u - P'
//! s''    = (d.P'' - |d'|^2) / (d.u)      d'' = s'' u - P''
//! sigma' = (i d).d' / l^2                sigma'' = (i d).d'' / l^2
//! knuckle pin:  K = P + k d,   k = (knuckle radius / master's length) e^{i knuckle angle}
//! ```
//! | symbol | name                                                          | unit |
//! |--------|---------------------------------------------------------------|------|
//! | P, W   | lower pin and piston pin from the crankshaft's axis           | m    |
//! | s      | travel of the piston pin along the cylinder axis              | m    |
//! | sigma  | angle of the rod, from lower pin to piston pin                | rad  |
//! | u, v   | directions along the cylinder axis and across, `v = i u`      | -    |
//!
//! Primes are derivatives by the crank angle of crankshaft 1.

use crate::train::{LowerPin, Train};
use num_complex::Complex64;

/// Places of piston and rod of one cylinder, from the axis of its crankshaft, with their derivatives by theta.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place {
    /// Lower pin of the rod [m].
    pub lower_pin: [Complex64; 3],
    /// From the lower pin to the piston pin [m].
    pub rod: [Complex64; 3],
    /// Travel of the piston pin [m].
    pub travel: [f64; 3],
    /// First two derivatives of the rod's angle.
    pub swing: [f64; 2],
}

/// `a . b` of two vectors across the crank axis.
pub(crate) fn dot(a: Complex64, b: Complex64) -> f64 {
    a.re * b.re + a.im * b.im
}

/// `z` component of `a x b`.
pub(crate) fn cross(a: Complex64, b: Complex64) -> f64 {
    a.re * b.im - a.im * b.re
}

impl Place {
    /// From the lower pin with its derivatives.
    #[inline]
    fn close(lower_pin: [Complex64; 3], length: f64, axis: Complex64, offset: f64) -> Place {
        let across = offset - dot(lower_pin[0], axis * Complex64::I);
        let along = ((length - across) * (length + across)).sqrt();
        let d = Complex64::new(along, across) * axis;
        let s = dot(lower_pin[0], axis) + along;
        // One division for all: they take most of the time.
        let [by_along, by_square] = {
            let square = length * length;
            let both = 1.0 / (along * square);
            [square * both, along * both]
        };
        let s1 = dot(d, lower_pin[1]) * by_along;
        let d1 = s1 * axis - lower_pin[1];
        let s2 = (dot(d, lower_pin[2]) - d1.norm_sqr()) * by_along;
        let d2 = s2 * axis - lower_pin[2];
        Place {
            lower_pin,
            rod: [d, d1, d2],
            travel: [s, s1, s2],
            swing: [cross(d, d1) * by_square, cross(d, d2) * by_square],
        }
    }

    /// A point of the rod at `share` of its length, from the crankshaft's axis, with its derivatives.
    #[inline]
    pub fn on_rod(&self, share: f64) -> [Complex64; 3] {
        [0, 1, 2].map(|k| self.lower_pin[k] + share * self.rod[k])
    }
}

impl Train {
    /// Places of all cylinders at crank angle `theta` [rad], into `places`.
    pub fn places_into(&self, theta: f64, places: &mut Vec<Place>) {
        places.resize(self.cylinders.len(), Place::default());
        // Cylinders on shafts of one speed share the direction.
        let mut turned = (1.0, Complex64::cis(theta));
        for &index in &self.order {
            let cylinder = &self.cylinders[index];
            let lower_pin = match cylinder.lower_pin {
                LowerPin::Crankpin => {
                    let ratio = self.rotors[cylinder.rotor].ratio;
                    if ratio != turned.0 {
                        turned = (ratio, Complex64::cis(ratio * theta));
                    }
                    let pin = cylinder.crankpin * turned.1;
                    [pin, pin * Complex64::I * ratio, -ratio * ratio * pin]
                }
                LowerPin::Knuckle { master, place } => {
                    let master: &Place = &places[master];
                    [0, 1, 2].map(|k| master.lower_pin[k] + place * master.rod[k])
                }
            };
            places[index] = Place::close(lower_pin, cylinder.rod.length, cylinder.axis, cylinder.net_offset);
        }
    }

    /// Largest departure of any loop from its rod length [m].
    pub fn loop_residual(&self, places: &[Place]) -> f64 {
        let off = places.iter().zip(&self.cylinders).map(|(place, cylinder)| {
            let pin = place.travel[0] * cylinder.axis + cylinder.net_offset * Complex64::I * cylinder.axis;
            ((pin - place.lower_pin[0]).norm_sqr().sqrt() - cylinder.rod.length).abs()
        });
        off.fold(0.0, f64::max)
    }
}
