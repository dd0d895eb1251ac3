//! Loads by order, split into parts that turn with the crank and against it.
//!
//! ```text
//! piston, own harmonic n, a_n = n^2 s_n e^{i n phi_0}:
//!   force at e^{+i n phi}: G a_n        at e^{-i n phi}: G conj(a_n)        (couple: H)
//!   torque    T_n = -1/2 i n rate ( m W^2 (s'^2)_n + J W^2 (beta'^2)_n ) e^{i n phi_0}
//!   roll      M_n = -T_n + R a_n + i n J W^2 beta'_n e^{i n phi_0}
//! ```
//! Symbols as in [`crate::train`]; the coefficients of the motion are closed forms ([`crate::series`]) for plain rods
//! and a spectral quadrature ([`crate::sampling`]) for articulated rods and truncated motions. A crankshaft that
//! turns the other way exchanges the two senses.

use crate::drive::{Drive, Linkage};
use crate::result::OrderLoads;
use crate::sampling::sampled_orders;
use crate::series::slider_orders;
use crate::train::{Mechanism, Piston, Rotor};
use lanchester_model::{Engine, Ratio};
use num_complex::Complex64;
use std::collections::BTreeSet;

/// The orders of an engine: all whole ones, and the fractions that its geared crankshafts and shafts bring.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OrderAxis {
    /// Orders times `revolutions`, rising.
    keys: Vec<u64>,
    /// Revolutions of crankshaft 1 in one period.
    revolutions: u32,
    /// Highest order.
    max_order: u32,
}

impl OrderAxis {
    /// Orders 0 to `max_order` of `engine`.
    pub fn of(engine: &Engine, revolutions: u32, max_order: u32) -> OrderAxis {
        let mut axis = OrderAxis { keys: Vec::new(), revolutions, max_order };
        let whole = (0..=max_order).map(|n| u64::from(n) * u64::from(revolutions));
        let mut keys: BTreeSet<u64> = whole.collect();
        for crankshaft in &engine.crankshafts {
            for n in 1..=axis.highest(crankshaft.ratio) {
                keys.insert(axis.key(crankshaft.ratio, n));
            }
        }
        for shaft in engine.shafts.iter().filter(|s| axis.highest(s.ratio) >= 1) {
            keys.insert(axis.key(shaft.ratio, 1));
        }
        axis.keys = keys.into_iter().collect();
        axis
    }

    /// Harmonic `n` of a shaft as a key.
    fn key(&self, ratio: Ratio, n: usize) -> u64 {
        let each =
            u64::from(ratio.numerator().unsigned_abs()) * u64::from(self.revolutions / ratio.denominator());
        n as u64 * each
    }

    /// Highest harmonic of a shaft that is listed.
    pub fn highest(&self, ratio: Ratio) -> usize {
        let limit = u64::from(self.max_order) * u64::from(self.revolutions);
        (limit / self.key(ratio, 1)) as usize
    }

    /// Place of harmonic `n` of a shaft in the list.
    pub fn place(&self, ratio: Ratio, n: usize) -> usize {
        self.keys.binary_search(&self.key(ratio, n)).expect("invariant: every listed harmonic has its order")
    }

    /// The orders.
    pub fn orders(&self) -> impl ExactSizeIterator<Item = f64> {
        self.keys.iter().map(|&key| key as f64 / f64::from(self.revolutions))
    }
}

/// No load of order `order`.
fn empty(order: f64) -> OrderLoads {
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
struct Harmonic {
    force: [Complex64; 2],
    couple: [Complex64; 2],
    roll: Complex64,
    torque: Complex64,
}

impl Harmonic {
    /// Adds it to its order, senses exchanged for a shaft that turns against crankshaft 1.
    fn add_to(&self, order: &mut OrderLoads, ratio: Ratio) {
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

impl Mechanism {
    /// Loads by order, rising, from 0 to the highest order asked for.
    pub fn orders(&self) -> Vec<OrderLoads> {
        let mut orders: Vec<OrderLoads> = self.axis.orders().map(empty).collect();
        for rotor in &self.rotors {
            if self.axis.highest(rotor.ratio) >= 1 {
                rotor.harmonic().add_to(&mut orders[self.axis.place(rotor.ratio, 1)], rotor.ratio);
            }
        }
        for piston in &self.pistons {
            let highest = self.axis.highest(piston.ratio);
            for (n, harmonic) in piston.harmonics(highest).iter().enumerate().skip(1) {
                harmonic.add_to(&mut orders[self.axis.place(piston.ratio, n)], piston.ratio);
            }
        }
        orders
    }
}

impl Rotor {
    fn harmonic(&self) -> Harmonic {
        let zero = Complex64::ZERO;
        Harmonic {
            force: [self.force, zero],
            couple: [self.couple, zero],
            roll: Complex64::new(0.0, -0.5) * self.roll,
            torque: zero,
        }
    }
}

/// Orders of what a piston's loads are made of, n = 0..=highest, phases counted from its cylinder axis.
struct PistonOrders {
    /// `s`, or what has the same second derivative.
    travel: Vec<Complex64>,
    swing_rate: Vec<Complex64>,
    /// `m W^2 s'^2 + J W^2 beta'^2`, twice the kinetic energy over the speed squared.
    energy: Vec<Complex64>,
    /// Master's travel and angular momentum `Im(conj(K) K')` of the knuckle pin.
    knuckle: Option<[Vec<Complex64>; 2]>,
}

impl Piston {
    fn motion_orders(&self, highest: usize) -> PistonOrders {
        if let Drive::Exact(Linkage::Plain(slider)) = &self.drive {
            let orders = slider_orders(slider, highest);
            let squares = orders.travel_rate_squared.iter().zip(&orders.swing_rate_squared);
            let energy = squares.map(|(s, k)| self.mass * s + self.inertia * k).collect();
            return PistonOrders {
                travel: orders.travel,
                swing_rate: orders.swing_rate,
                energy,
                knuckle: None,
            };
        }
        let band = match &self.drive {
            Drive::Exact(_) => 0,
            Drive::Series { own, .. } => 2 * own.travel.len(),
        };
        let mass = self.knuckle.as_ref().map_or(0.0, |k| k.mass);
        let sampled = sampled_orders(highest, band, |phi| {
            let motion = self.drive.motion(phi);
            let [_, s1, ..] = motion.stroke.travel;
            let [_, k, ..] = motion.stroke.swing;
            let energy = self.mass * s1 * s1 + self.inertia * k * k;
            let Some(pin) = motion.knuckle else { return [motion.stroke.travel[0], k, energy, 0.0, 0.0] };
            let [at, rate, ..] = pin.knuckle;
            let energy = energy + mass * rate.norm_sqr();
            [motion.stroke.travel[0], k, energy, (at.conj() * rate).im, pin.master_travel]
        });
        let column = |m: usize| sampled.iter().map(|c| c[m]).collect::<Vec<_>>();
        PistonOrders {
            travel: column(0),
            swing_rate: column(1),
            energy: column(2),
            knuckle: self.knuckle.as_ref().map(|_| [column(4), column(3)]),
        }
    }

    fn harmonics(&self, highest: usize) -> Vec<Harmonic> {
        let orders = self.motion_orders(highest);
        let rate = self.ratio.value();
        (0..=highest)
            .map(|n| {
                let order = n as f64;
                let phase = Complex64::cis(order * self.phase);
                let along = order * order * orders.travel[n] * phase;
                let by_phi = Complex64::new(0.0, order) * phase;
                let torque = -0.5 * rate * by_phi * orders.energy[n];
                let roll = self.roll * along + self.inertia * by_phi * orders.swing_rate[n] - torque;
                let mut harmonic = Harmonic {
                    force: [self.force * along, self.force * along.conj()],
                    couple: [self.couple * along, self.couple * along.conj()],
                    roll,
                    torque,
                };
                if let (Some(mass), Some([travel, momentum]), Some(linkage)) =
                    (&self.knuckle, &orders.knuckle, self.drive.articulated())
                {
                    let knuckle = linkage.knuckle;
                    let travel = order * order * travel[n] * phase;
                    let pin = if n == 1 { linkage.master.radius * phase } else { Complex64::ZERO };
                    // A'' - K'' = -k (B'' - A''): B'' = -n^2 s_n both ways, A'' = -r forward only.
                    let excess = [knuckle * (travel - pin), knuckle * travel.conj()];
                    for (sense, excess) in excess.into_iter().enumerate() {
                        harmonic.force[sense] += mass.force * excess;
                        harmonic.couple[sense] += mass.couple * excess;
                    }
                    let [forward, backward] = excess.map(|c| mass.roll * c);
                    harmonic.roll += Complex64::new(0.0, -0.5) * (forward - backward.conj())
                        - mass.mass * by_phi * momentum[n];
                }
                harmonic
            })
            .collect()
    }
}
