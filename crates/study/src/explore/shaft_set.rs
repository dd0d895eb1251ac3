//! Balance shafts as a choice of the search: which order and sense, where, and what they remove.
//!
//! A shaft that turns at order `n` in one sense removes what the engine has of this order and sense, whatever its size:
//!
//! ```text
//! force, one plane:    P = -f                                 (its couple i z P stays)
//! couple, two planes:  P1 = -P2 = i m / (z1 - z2)
//! both:                P1 + P2 = -f,   i (z1 P1 + z2 P2) = -m
//! ```
//! with `f` and `m` the engine's coefficients of `e^{+-i n theta}`, those of the shafts before it in the set included.

use crate::explore::error::ExploreError;
use crate::explore::layout_orders::LayoutOrders;
use crate::explore::objective::Sense;
use lanchester_model::{BalanceShaft, Ratio, ShaftWeight};
use num_complex::Complex64;
use serde::{Deserialize, Serialize};

/// Balance shafts that a layout may have; an empty set is none.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ShaftSet {
    /// What the user calls it.
    pub name: String,
    /// Its shafts.
    pub shafts: Vec<ShaftDesign>,
}

/// A balance shaft whose weights follow from the engine that it serves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ShaftDesign {
    /// Speed over that of the crank: 1 or 2.
    pub order: u32,
    /// With the crank or against it.
    pub sense: Sense,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// What its weights remove.
    pub removes: Removes,
}

/// What the weights of a shaft remove, and the planes in which they stand [m], from the middle of the crankshaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Removes {
    /// The force, by one weight.
    Force {
        /// Plane of the weight [m].
        z: f64,
    },
    /// The couple, by two opposed weights.
    Couple {
        /// Planes of the weights [m].
        z: [f64; 2],
    },
    /// Force and couple, by two weights.
    Both {
        /// Planes of the weights [m].
        z: [f64; 2],
    },
}

impl ShaftDesign {
    /// The forces of its weights at `theta = 0` [N], with their planes [m], in an engine with `orders`.
    fn weights(&self, orders: &LayoutOrders) -> ([(f64, Complex64); 2], usize) {
        let (n, sense) = (self.order as usize - 1, self.sense as usize);
        let (f, m) = (orders.force[n][sense], orders.couple[n][sense]);
        match self.removes {
            Removes::Force { z } => ([(z, -f), (z, Complex64::ZERO)], 1),
            Removes::Couple { z: [z1, z2] } => {
                let p = Complex64::I * m / (z1 - z2);
                ([(z1, p), (z2, -p)], 2)
            }
            Removes::Both { z: [z1, z2] } => {
                // z1 P1 + z2 P2 = i m, P1 + P2 = -f.
                let first = (Complex64::I * m + z2 * f) / (z1 - z2);
                ([(z1, first), (z2, -f - first)], 2)
            }
        }
    }

    /// Adds what it does to the loads.
    pub(crate) fn add_to(&self, orders: &mut LayoutOrders) {
        let (n, sense) = (self.order as usize - 1, self.sense as usize);
        let (weights, count) = self.weights(orders);
        for &(z, p) in &weights[..count] {
            orders.force[n][sense] += p;
            orders.couple[n][sense] += Complex64::new(0.0, z) * p;
            // M_z = Im(conj(axis) P e^{+-i n theta}) = Re(-i conj(axis) P e^{+-i n theta}).
            let roll = Complex64::new(0.0, -1.0) * Complex64::new(self.x, -self.y) * p;
            orders.roll_moment[n] += if self.sense == Sense::Forward { roll } else { roll.conj() };
        }
    }

    /// The shaft of an engine with `orders` at `speed` [rad/s].
    pub(crate) fn shaft(&self, orders: &LayoutOrders, speed: f64, name: String) -> BalanceShaft {
        let turns = if self.sense == Sense::Forward { self.order as i32 } else { -(self.order as i32) };
        let square = (f64::from(turns) * speed).powi(2);
        let (weights, count) = self.weights(orders);
        BalanceShaft {
            inertia: None,
            name,
            ratio: Ratio::whole(turns).expect("invariant: the order of a shaft is 1 or 2"),
            x: self.x,
            y: self.y,
            weights: weights[..count]
                .iter()
                .map(|&(z, p)| ShaftWeight::new(z, p.norm() / square, p.arg()))
                .collect(),
        }
    }

    /// Refuses a shaft that cannot be.
    pub(crate) fn check(&self) -> Result<(), ExploreError> {
        let number = |quantity, needed, got| Err(ExploreError::Number { quantity, needed, got });
        if !(1..=2).contains(&self.order) {
            return number("order of a balance shaft", "1 or 2", f64::from(self.order));
        }
        let planes = match self.removes {
            Removes::Force { z } => [z, z + 1.0],
            Removes::Couple { z } | Removes::Both { z } => z,
        };
        if let Some(&got) = [self.x, self.y, planes[0], planes[1]].iter().find(|v| !v.is_finite()) {
            return number("place of a balance shaft [m]", "finite", got);
        }
        if planes[0] == planes[1] {
            return number("distance of the weights of a balance shaft [m]", "more than 0", 0.0);
        }
        Ok(())
    }

    /// The same shaft in the engine seen from the other end (`z` negated) or in a mirror (its axis at `turn` of it).
    fn seen(&self, ends: bool, turn: impl Fn(f64, f64) -> (f64, f64)) -> ShaftDesign {
        let flip = |z: f64| if ends { -z } else { z };
        let sorted = |z: [f64; 2]| {
            let z = z.map(flip);
            if z[0] <= z[1] { z } else { [z[1], z[0]] }
        };
        let (x, y) = turn(self.x, self.y);
        let removes = match self.removes {
            Removes::Force { z } => Removes::Force { z: flip(z) + 0.0 },
            Removes::Couple { z } => Removes::Couple { z: sorted(z).map(|z| z + 0.0) },
            Removes::Both { z } => Removes::Both { z: sorted(z).map(|z| z + 0.0) },
        };
        // Adding 0 turns -0 into 0.
        ShaftDesign { x: x + 0.0, y: y + 0.0, removes, ..*self }
    }
}

impl ShaftSet {
    /// Its shafts as another view of the engine has them, each as it is compared: weights by plane.
    pub(crate) fn seen(&self, ends: bool, turn: impl Fn(f64, f64) -> (f64, f64)) -> Vec<ShaftDesign> {
        self.shafts.iter().map(|shaft| shaft.seen(ends, &turn)).collect()
    }
}
