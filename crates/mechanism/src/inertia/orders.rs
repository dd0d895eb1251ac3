//! Loads by order, split into parts that turn with the crank and against it.
//!
//! ```text
//! piston, own harmonic n, a_n = -(s'')_n e^{i n phi_0} = n^2 s_n e^{i n phi_0}:
//!   force at e^{+i n phi}: G a_n        at e^{-i n phi}: G conj(a_n)        (couple: H)
//!   torque    T_n = -1/2 i n rate ( m W^2 (s'^2)_n + J W^2 (beta'^2)_n ) e^{i n phi_0}
//!   roll      M_n = -T_n + R a_n + J W^2 (beta'')_n e^{i n phi_0}
//! ```
//! Symbols as in [`crate::train`]; the coefficients of the motion are closed forms ([`crate::series`]) for plain rods,
//! finite sums for their truncated motions, and a spectral quadrature ([`crate::sampling`]) for articulated rods. A crankshaft that
//! turns the other way exchanges the two senses.

use crate::train::drive::{Drive, Linkage};
use crate::train::mechanism::{Piston, Rotor};
use crate::train::sampling::sampled_orders;
use crate::train::series::slider_orders;
use lanchester_model::Ratio;
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// No load of order `order`.
pub(crate) fn empty(order: f64) -> OrderLoads {
    let zero = Complex64::ZERO;
    OrderLoads {
        order,
        force_forward: zero,
        force_backward: zero,
        couple_forward: zero,
        couple_backward: zero,
        roll_moment: zero,
        shaft_torque: zero,
    }
}

/// One harmonic of a shaft: coefficients of `e^{+i n phi}` and `e^{-i n phi}`, and of `2 Re` for roll and torque.
pub(crate) struct Harmonic {
    pub force: [Complex64; 2],
    pub couple: [Complex64; 2],
    pub roll: Complex64,
    pub torque: Complex64,
}

impl Harmonic {
    /// Adds it to its order, senses exchanged for a shaft that turns against crankshaft 1.
    #[inline(always)]
    pub fn add_to(&self, order: &mut OrderLoads, ratio: Ratio) {
        let forward = usize::from(ratio.numerator() < 0);
        order.force_forward += self.force[forward];
        order.force_backward += self.force[1 - forward];
        order.couple_forward += self.couple[forward];
        order.couple_backward += self.couple[1 - forward];
        let (roll, torque) = (2.0 * self.roll, 2.0 * self.torque);
        order.roll_moment += if forward == 0 { roll } else { roll.conj() };
        order.shaft_torque += if forward == 0 { torque } else { torque.conj() };
    }
}

impl Rotor {
    /// Its one harmonic.
    pub fn harmonic(&self) -> Harmonic {
        let zero = Complex64::ZERO;
        Harmonic {
            force: [self.force, zero],
            couple: [self.couple, zero],
            roll: Complex64::new(0.0, -0.5) * self.roll,
            torque: zero,
        }
    }
}

/// Orders of what a piston's loads are made of, n = 0..=highest, phases counted from its (master's) cylinder axis.
struct PistonOrders {
    /// `s''`.
    acceleration: Vec<Complex64>,
    /// `beta''`.
    spin: Vec<Complex64>,
    /// `m W^2 s' s'' + J W^2 beta' beta''`, and that of the knuckle pin: rate of the kinetic energy.
    power: Vec<Complex64>,
    /// Master's `s''` and moment `Im(conj(K) K'')` of the knuckle pin.
    knuckle: Option<[Vec<Complex64>; 2]>,
}

impl Piston {
    fn motion_orders(&self, highest: usize) -> PistonOrders {
        let closed = match &self.drive {
            Drive::Exact(Linkage::Plain(slider)) => Some(slider_orders(slider, highest)),
            Drive::Series { own, master: None } => Some(own.of_finite(highest)),
            Drive::Exact(Linkage::Articulated(_)) | Drive::Series { .. } => None,
        };
        if let Some(orders) = closed {
            let by_phi = |n: usize| Complex64::new(0.0, n as f64);
            let squares = orders.travel_rate_squared.iter().zip(&orders.swing_rate_squared);
            return PistonOrders {
                acceleration: orders.travel.iter().enumerate().map(|(n, s)| by_phi(n).powi(2) * s).collect(),
                spin: orders.swing_rate.iter().enumerate().map(|(n, k)| by_phi(n) * k).collect(),
                power: squares
                    .enumerate()
                    .map(|(n, (s, k))| 0.5 * by_phi(n) * (self.mass * s + self.inertia * k))
                    .collect(),
                knuckle: None,
            };
        }
        let band = match &self.drive {
            Drive::Exact(_) => 0,
            Drive::Series { own, .. } => 2 * own.travel.len(),
        };
        let mass = self.knuckle.as_ref().map_or(0.0, |k| k.mass);
        // Derivatives are sampled as such: multiplying sampled travel by n^2 would lift its rounding.
        let sampled = sampled_orders(highest, band, |phi| {
            let motion = self.drive.motion(phi);
            let [_, s1, s2, _] = motion.stroke.travel;
            let [k, k1, _] = motion.stroke.swing;
            let power = self.mass * s1 * s2 + self.inertia * k * k1;
            let Some(pin) = motion.knuckle else { return [s2, k1, power, 0.0, 0.0] };
            let [at, rate, change, _] = pin.knuckle;
            let power = power + mass * (rate.conj() * change).re;
            [s2, k1, power, pin.master_acceleration, (at.conj() * change).im]
        });
        let column = |m: usize| sampled.iter().map(|c| c[m]).collect::<Vec<_>>();
        PistonOrders {
            acceleration: column(0),
            spin: column(1),
            power: column(2),
            knuckle: self.knuckle.as_ref().map(|_| [column(3), column(4)]),
        }
    }

    /// Harmonics 0..=highest of its crankshaft.
    pub fn harmonics(&self, highest: usize) -> Vec<Harmonic> {
        let orders = self.motion_orders(highest);
        (0..=highest)
            .map(|n| {
                let phase = Complex64::cis(n as f64 * self.phase);
                let along = -orders.acceleration[n] * phase;
                let torque = -self.ratio.value() * orders.power[n] * phase;
                let roll = self.roll * along + self.inertia * orders.spin[n] * phase - torque;
                let mut harmonic = Harmonic {
                    force: [self.force * along, self.force * along.conj()],
                    couple: [self.couple * along, self.couple * along.conj()],
                    roll,
                    torque,
                };
                if let (Some(mass), Some([acceleration, moment]), Some(linkage)) =
                    (&self.knuckle, &orders.knuckle, self.drive.articulated())
                {
                    let piston = -acceleration[n] * phase;
                    let pin = if n == 1 { linkage.master.radius * phase } else { Complex64::ZERO };
                    // A'' - K'' = k (A'' - B''): B'' both ways, A'' = -r e^{i phi} forward only.
                    let excess = [linkage.knuckle * (piston - pin), linkage.knuckle * piston.conj()];
                    for (sense, excess) in excess.into_iter().enumerate() {
                        harmonic.force[sense] += mass.force * excess;
                        harmonic.couple[sense] += mass.couple * excess;
                    }
                    let [forward, backward] = excess.map(|c| mass.roll * c);
                    harmonic.roll += Complex64::new(0.0, -0.5) * (forward - backward.conj())
                        - mass.mass * moment[n] * phase;
                }
                harmonic
            })
            .collect()
    }
}
