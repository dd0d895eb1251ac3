//! Inertia of pistons and rods about the crank axis over the angle of their own crankshaft, from the exact motion.
//!
//! The loop of each cylinder is closed by its constraint, not by a formula for slider and crank: |W - P| = l with P the crankpin (or the knuckle pin on a
//! master rod) and W the piston pin on its line.
//!
//! ```text
//! J(g) = SUM m_A |P'|^2 + m s'^2 - (m_A a^2 + m_B b^2 - I) sigma'^2,    T(g) = -1/2 J'(g) w^2 at constant speed                 (50.13)
//! ```
//! primes by the angle g of the own crankshaft; m_A the big end, m_B the small end, m the small end with the piston, sigma the rod's
//! angle.

use lanchester_model::{Cylinder, Engine, EngineParts, RodJoint};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Samples over a revolution of the own crankshaft.
pub const SAMPLES: usize = 720;

/// Motion of a rod's lower end and of the rod with its piston, over the angle of the own crankshaft.
struct RodMotion {
    /// Derivative of the lower end.
    lower: Complex64,
    /// Derivative of the piston's place along its line.
    piston: f64,
    /// Derivative of the rod's angle.
    turn: f64,
    /// Direction of the rod, from its lower end to the piston pin.
    direction: Complex64,
}

fn closed(cylinder: &Cylinder, at: Complex64, lower: Complex64) -> RodMotion {
    let axis = Complex64::cis(cylinder.angle);
    let (own, slope) = (at * axis.conj(), lower * axis.conj());
    let across = cylinder.net_offset() - own.im;
    let along = (cylinder.rod.length.powi(2) - across * across).max(0.0).sqrt();
    RodMotion {
        lower,
        piston: slope.re + across * slope.im / along,
        turn: -slope.im / along,
        direction: Complex64::new(along, across) / cylinder.rod.length * axis,
    }
}

fn motion(engine: &EngineParts, cylinder: &Cylinder, own: f64) -> RodMotion {
    let throw = &engine.throws[cylinder.throw];
    let pin =
        Complex64::from_polar(throw.radius, own + throw.angle + engine.crankshafts[throw.crankshaft].phase);
    let lower = Complex64::i() * pin;
    match cylinder.rod.joint {
        RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
            let lead = motion(engine, &engine.cylinders[master], own);
            let arm = lead.direction * Complex64::from_polar(knuckle_radius, knuckle_angle);
            closed(cylinder, pin + arm, lower + Complex64::i() * arm * lead.turn)
        }
        _ => closed(cylinder, pin, lower),
    }
}

/// Inertia of all rods and pistons on a throw at [`SAMPLES`] angles of its own crankshaft over a revolution [kg m^2].
pub fn train_inertia(engine: &Engine, throw: usize) -> Vec<f64> {
    let on_pin: Vec<&Cylinder> = engine.cylinders.iter().filter(|cylinder| cylinder.throw == throw).collect();
    let at = |sample: usize| {
        let own = TAU * sample as f64 / SAMPLES as f64;
        let of = |cylinder: &&Cylinder| {
            let moves = motion(engine, cylinder, own);
            cylinder.rod.big_end_mass * moves.lower.norm_sqr()
                + cylinder.reciprocating_mass() * moves.piston.powi(2)
                - cylinder.rod.residual_inertia() * moves.turn.powi(2)
        };
        on_pin.iter().map(of).sum()
    };
    (0..SAMPLES).map(at).collect()
}

/// Mean of the inertia over a revolution [kg m^2], and its orders: `J = mean + Re SUM J_k e^(i k g)`.
pub fn inertia_orders(samples: &[f64], count: usize) -> (f64, Vec<Complex64>) {
    crate::excitation::orders_of(samples, count)
}

/// Orders of the torque of the moving masses over the square of the speed of their own crankshaft, as (50.13) says:
/// `T_k = -1/2 i k J_k`.
pub fn torque_orders(samples: &[f64], count: usize) -> Vec<Complex64> {
    let (_, orders) = inertia_orders(samples, count);
    orders.iter().enumerate().map(|(k, j)| Complex64::new(0.0, -0.5 * (k + 1) as f64) * j).collect()
}
