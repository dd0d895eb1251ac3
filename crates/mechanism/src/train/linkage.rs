//! Slider-crank kinematics in closed form: plain rods with offset, and articulated rods on a master.
//!
//! ```text
//! frame of the cylinder: u along its axis, v = i u; phi = angle of the crank from u
//! s(phi) = p + W,  W = sqrt(l^2 - q^2),  sin(beta) = q / l
//! plain rod:        p + i (q + e) = r e^{i phi}                          (crankpin A)
//! articulated rod:  p + i (q + e) = ((1 - k) A + k B) e^{i (b_m - b)}    (knuckle pin K, linear in A and B)
//! ```
//! | symbol | name                                                              | unit |
//! |--------|-------------------------------------------------------------------|------|
//! | s      | piston pin from the crankshaft's axis along u                     | m    |
//! | r, l   | crank radius, rod length                                          | m    |
//! | e      | net offset of the piston pin's line along v                       | m    |
//! | beta   | angle of the rod: it points along `e^{i (b - beta)}`              | rad  |
//! | A, B   | crankpin and the master's piston pin, in the master's frame       | m    |
//! | k      | knuckle radius over master length, times `e^{i knuckle angle}`    | -    |
//! | b, b_m | axis of the cylinder, of the master's cylinder                    | rad  |
//!
//! All derivatives are by the crank's own angle. Valid where `|q| < l`.

use crate::curves::extremes::extremes_over_turn;
use crate::inertia::request::LoadError;
use num_complex::Complex64;

/// A function of the crank angle and its first three derivatives by it.
pub(crate) type Jet = [f64; 4];

/// Travel of the piston pin [m] and angle of the rod [rad], with their derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    /// `s` and its derivatives [m].
    pub travel: Jet,
    /// `e^{i beta}`.
    pub tilt: Complex64,
    /// First three derivatives of `beta` [rad].
    pub swing: [f64; 3],
}

impl Stroke {
    /// `beta` [rad].
    pub fn rod_angle(&self) -> f64 {
        self.tilt.arg()
    }
}

/// Motion of a rod of length `length` whose big end stands at `p` along and `q` beside the line of its piston pin.
///
/// ```text
/// beta'   = k   = q' / W                        W' = -q k
/// beta''  = k'  = (q'' + q k^2) / W
/// beta''' = k'' = (q k k' + q''' + q' k^2 + 2 q k k') / W
/// s'   = p'   - q k
/// s''  = p''  - q' k  - q k'
/// s''' = p''' - q'' k - 2 q' k' - q k''
/// ```
/// The forms have no difference of nearly equal numbers but those of the motion itself.
#[inline(always)]
pub(crate) fn slide(p: Jet, q: Jet, length: f64) -> Stroke {
    let reach = ((length - q[0]) * (length + q[0])).sqrt();
    let inverse = 1.0 / reach;
    let k = q[1] * inverse;
    let k1 = (q[2] + q[0] * k * k) * inverse;
    let k2 = (q[3] + q[1] * k * k + 3.0 * q[0] * k * k1) * inverse;
    Stroke {
        travel: [
            p[0] + reach,
            p[1] - q[0] * k,
            p[2] - q[1] * k - q[0] * k1,
            p[3] - q[2] * k - 2.0 * q[1] * k1 - q[0] * k2,
        ],
        tilt: Complex64::new(reach / length, q[0] / length),
        swing: [k, k1, k2],
    }
}

/// A plain rod on a crankpin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slider {
    /// Crank radius [m].
    pub radius: f64,
    /// Rod length [m].
    pub length: f64,
    /// Net offset along +v [m].
    pub offset: f64,
}

impl Slider {
    /// Refuses a rod that cannot pass its dead centres; `cylinder` counts from 1.
    pub fn check(&self, cylinder: usize) -> Result<(), LoadError> {
        let Slider { radius, length, offset } = *self;
        for got in [radius, length] {
            if !LENGTHS.contains(&got) {
                return Err(LoadError::Length { cylinder, got });
            }
        }
        // The root must be positive as it is computed, not only on paper.
        if (length - offset.abs()) - radius > LOCKED * length {
            Ok(())
        } else {
            Err(LoadError::RodTooShort { cylinder, needed: radius + offset.abs(), length })
        }
    }

    /// Motion at crank angle `phi` from the cylinder axis.
    pub fn stroke(&self, phi: f64) -> Stroke {
        self.stroke_at(Complex64::cis(phi))
    }

    /// Motion where the crank points along `crank`, of length 1, from the cylinder axis.
    #[inline(always)]
    pub fn stroke_at(&self, crank: Complex64) -> Stroke {
        let (s, c) = (self.radius * crank.im, self.radius * crank.re);
        slide([c, -s, -c, s], [s - self.offset, c, -s, -c], self.length)
    }

    /// Crank angle of top dead centre from the cylinder axis [rad]: crank and rod in line.
    pub fn top_dead_centre(&self) -> f64 {
        (self.offset / (self.length + self.radius)).asin()
    }

    /// Crank angle of bottom dead centre from the cylinder axis [rad]: crank folded onto the rod.
    pub fn bottom_dead_centre(&self) -> f64 {
        std::f64::consts::PI + (self.offset / (self.length - self.radius)).asin()
    }
}

/// Lengths [m] that are computed with: beyond them products of a few lengths leave the range of numbers.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-9..=1e6;

/// Closer to locking than this share of its length a rod counts as locked: its root is rounding.
const LOCKED: f64 = 1e-12;

/// Angles at which the reach of an articulated rod is scanned before its extreme is refined.
const CHECK_ANGLES: usize = 720;

/// An articulated rod on the knuckle pin of a master.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Articulated {
    /// The master.
    pub master: Slider,
    /// `k`: knuckle radius over master length, times `e^{i knuckle angle}`.
    pub knuckle: Complex64,
    /// `e^{i (b_m - b)}`: from the master's frame to the slave's.
    pub turn: Complex64,
    /// Rod length, knuckle pin to piston pin [m].
    pub length: f64,
    /// Net offset of the slave's cylinder along its own +v [m].
    pub offset: f64,
}

/// Crankpin, knuckle pin and master's piston pin in the master's frame, with derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KnuckleMotion {
    /// Second derivative of the master's travel [m].
    pub master_acceleration: f64,
    /// Crankpin `A` [m] and derivatives.
    pub crankpin: [Complex64; 4],
    /// Knuckle pin `K` [m] and derivatives.
    pub knuckle: [Complex64; 4],
}

impl Articulated {
    /// Motion of the knuckle pin where the crank points along `crank`, of length 1, from the master's axis.
    pub fn knuckle(&self, crank: Complex64) -> KnuckleMotion {
        self.knuckle_with(crank, self.master.stroke_at(crank).travel)
    }

    /// The same with the master's travel given.
    pub fn knuckle_with(&self, crank: Complex64, master_travel: Jet) -> KnuckleMotion {
        let a = self.master.radius * crank;
        let crankpin = [a, a * Complex64::I, -a, -a * Complex64::I];
        let along = 1.0 - self.knuckle;
        let knuckle = std::array::from_fn(|j| {
            let beside = if j == 0 { self.master.offset } else { 0.0 };
            along * crankpin[j] + self.knuckle * Complex64::new(master_travel[j], beside)
        });
        KnuckleMotion { master_acceleration: master_travel[2], crankpin, knuckle }
    }

    /// Big end of the slave in its own frame: along and beside the line of its piston pin.
    pub fn big_end(&self, motion: &KnuckleMotion) -> (Jet, Jet) {
        let turned = motion.knuckle.map(|k| k * self.turn);
        let mut q = turned.map(|k| k.im);
        q[0] -= self.offset;
        (turned.map(|k| k.re), q)
    }

    /// Motion of the slave at `phi` (crank from the master's axis).
    pub fn stroke(&self, phi: f64) -> Stroke {
        self.stroke_with(&self.knuckle(Complex64::cis(phi)))
    }

    /// Motion of the slave where its knuckle pin moves like this.
    pub fn stroke_with(&self, knuckle: &KnuckleMotion) -> Stroke {
        let (p, q) = self.big_end(knuckle);
        slide(p, q, self.length)
    }
}

impl Articulated {
    /// Refuses a rod that loses its knuckle pin; `cylinder` counts from 1.
    pub fn check(&self, cylinder: usize) -> Result<(), LoadError> {
        if !LENGTHS.contains(&self.length) {
            return Err(LoadError::Length { cylinder, got: self.length });
        }
        let sine = self.largest_sine();
        // Not a number is no reach either.
        if sine < 1.0 - LOCKED {
            Ok(())
        } else {
            Err(LoadError::KnuckleOutOfReach { cylinder, needed: sine * self.length, length: self.length })
        }
    }

    /// Distance from the crankpin to the slave's piston pin [m], and what has the roots and signs of its derivative.
    pub fn reach(&self, phi: f64) -> (f64, f64) {
        let pins = self.knuckle(Complex64::cis(phi));
        let travel = self.stroke_with(&pins).travel;
        let pin = |j: usize| {
            let piston = Complex64::new(travel[j], if j == 0 { self.offset } else { 0.0 });
            piston - pins.crankpin[j] * self.turn
        };
        (pin(0).norm(), (pin(0).conj() * pin(1)).re)
    }

    /// Largest `|q| / l` over a turn: sine of the largest rod angle.
    pub fn largest_sine(&self) -> f64 {
        let beside = |phi: f64| {
            let (_, q) = self.big_end(&self.knuckle(Complex64::cis(phi)));
            (q[0], q[1])
        };
        extremes_over_turn(CHECK_ANGLES, beside).max_abs() / self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fourth-order central difference of `f` over 2e-3 rad: truncation and rounding both near 1e-11 of the values.
    fn difference(f: impl Fn(f64) -> f64, phi: f64) -> f64 {
        let step = 2e-3;
        (8.0 * (f(phi + step) - f(phi - step)) - (f(phi + 2.0 * step) - f(phi - 2.0 * step))) / (12.0 * step)
    }

    fn check(stroke: impl Fn(f64) -> Stroke, scale: f64) {
        for j in 0..24 {
            let phi = 0.1 + 0.26 * f64::from(j);
            let here = stroke(phi);
            for n in 0..3 {
                let travel = difference(|at| stroke(at).travel[n], phi);
                let below = |stroke: Stroke| if n == 0 { stroke.rod_angle() } else { stroke.swing[n - 1] };
                let swing = difference(|at| below(stroke(at)), phi);
                assert!(
                    (here.travel[n + 1] - travel).abs() < 1e-8 * scale,
                    "travel, derivative {n} at {phi}"
                );
                assert!((here.swing[n] - swing).abs() < 1e-8, "swing, derivative {n} at {phi}");
            }
        }
    }

    #[test]
    fn derivatives_are_the_differences() {
        let master = Slider { radius: 0.08, length: 0.3, offset: 0.01 };
        check(|phi| master.stroke(phi), 0.08);
        let slave = Articulated {
            master,
            knuckle: Complex64::from_polar(0.2, 0.7),
            turn: Complex64::cis(-0.7),
            length: 0.25,
            offset: -0.005,
        };
        slave.check(2).unwrap();
        check(|phi| slave.stroke(phi), 0.08);
    }

    #[test]
    fn a_knuckle_out_of_reach_is_an_error() {
        let master = Slider { radius: 0.08, length: 0.3, offset: 0.0 };
        let knuckle = Complex64::from_polar(0.2, std::f64::consts::FRAC_PI_2);
        let slave = Articulated { master, knuckle, turn: Complex64::ONE, length: 0.1, offset: 0.0 };
        assert!(matches!(slave.check(2), Err(LoadError::KnuckleOutOfReach { cylinder: 2, .. })));
    }
}
