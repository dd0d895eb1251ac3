//! The best damper of one mass, in closed form.
//!
//! One mass J on a spring, natural frequency w_n, under a harmonic torque of constant amplitude; on it a ring of the inertia mu J.

use std::f64::consts::SQRT_2;

/// The best damper and what it reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestDamper {
    /// Natural frequency of ring and spring over that of the mass; 0 without a spring.
    pub tuning: f64,
    /// Damping `c` over `2 J_ring w_n`.
    pub damping: f64,
    /// Largest amplitude over static deflection; of a damper with a spring the height of the two fixed points.
    pub peak: f64,
}

/// Lanchester's own damper, a ring that viscous friction alone drives.
///
/// ```text
/// c = 2 J_ring w_n / sqrt(2 (1 + mu)(2 + mu)),    peak 1 + 2/mu,    at w^2 = 2 w_n^2 / (2 + mu)                                (50.7)
/// ```
///
/// # Source
/// Den Hartog, "Mechanical Vibrations", 4th ed. (1956), section 3.3.
pub fn best_untuned(mu: f64) -> BestDamper {
    BestDamper {
        tuning: 0.0,
        damping: 1.0 / (SQRT_2 * ((1.0 + mu) * (2.0 + mu)).sqrt()),
        peak: 1.0 + 2.0 / mu,
    }
}

/// A ring on a spring with viscous damping.
///
/// ```text
/// f = 1/(1 + mu),    zeta = sqrt(3 mu / (8 (1 + mu)^3)),    height of both fixed points sqrt(1 + 2/mu)                          (50.8)
/// ```
/// Here as there zeta is `c / (2 J_ring w_n)`.
///
/// # Source
/// Den Hartog, section 3.3; Brock, Journal of Applied Mechanics 13 (1946), for the damping.
pub fn best_tuned(mu: f64) -> BestDamper {
    let tuning = 1.0 / (1.0 + mu);
    BestDamper {
        tuning,
        damping: (3.0 * mu / (8.0 * (1.0 + mu).powi(3))).sqrt(),
        peak: (1.0 + 2.0 / mu).sqrt(),
    }
}

/// Frequencies over w_n of the two points through which all curves of a tuned damper go, whatever its damping.
///
/// ```text
/// g^4 - 2 g^2 (1 + f^2 + mu f^2)/(2 + mu) + 2 f^2/(2 + mu) = 0                                                                 (50.9)
/// ```
pub fn fixed_points(mu: f64, tuning: f64) -> [f64; 2] {
    let square = tuning * tuning;
    let half = (1.0 + square * (1.0 + mu)) / (2.0 + mu);
    let root = (half * half - 2.0 * square / (2.0 + mu)).max(0.0).sqrt();
    [(half - root).max(0.0).sqrt(), (half + root).sqrt()]
}
