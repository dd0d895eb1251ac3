//! First- and second-order loads of a layout, and the row of numbers that they are summed in.

use crate::explore::objective::Sense;
use lanchester_results::OrderLoads;
use num_complex::Complex64;
use serde::Serialize;

/// Numbers in a row: real and imaginary parts of force and couple (orders 1 and 2, forward and backward), roll moment and
/// torque (orders 1 and 2).
pub(super) const ROW: usize = 24;

/// First- and second-order loads of a layout; index 0 is order 1, index 1 is order 2.
///
/// As in `lanchester_results::OrderLoads`: force and couple are coefficients of `e^{i n theta}` (index 0, forward) and
/// `e^{-i n theta}` (index 1, backward); the modulus of roll moment and torque is their amplitude.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct LayoutOrders {
    /// Force on the block [N], by order and sense.
    #[schemars(with = "[[[f64; 2]; 2]; 2]")]
    pub force: [[Complex64; 2]; 2],
    /// Couple about the middle of the crankshaft [N m], by order and sense.
    #[schemars(with = "[[[f64; 2]; 2]; 2]")]
    pub couple: [[Complex64; 2]; 2],
    /// Roll moment by inertia [N m], by order.
    #[schemars(with = "[[f64; 2]; 2]")]
    pub roll_moment: [Complex64; 2],
    /// Inertia torque at the crankshaft [N m], by order.
    #[schemars(with = "[[f64; 2]; 2]")]
    pub shaft_torque: [Complex64; 2],
}

impl LayoutOrders {
    pub(super) fn of(row: &[f64; ROW]) -> LayoutOrders {
        let at = |k: usize| Complex64::new(row[2 * k], row[2 * k + 1]);
        LayoutOrders {
            force: [[at(0), at(1)], [at(2), at(3)]],
            couple: [[at(4), at(5)], [at(6), at(7)]],
            roll_moment: [at(8), at(9)],
            shaft_torque: [at(10), at(11)],
        }
    }

    pub(super) fn row(&self) -> [f64; ROW] {
        let [[f1, f2], [f3, f4]] = self.force;
        let [[m1, m2], [m3, m4]] = self.couple;
        let [r1, r2] = self.roll_moment;
        let [t1, t2] = self.shaft_torque;
        let all = [f1, f2, f3, f4, m1, m2, m3, m4, r1, r2, t1, t2];
        std::array::from_fn(|k| if k % 2 == 0 { all[k / 2].re } else { all[k / 2].im })
    }

    /// Part of the force of `order` (1 or 2) in one sense [N].
    pub fn force_of(&self, order: u32, sense: Sense) -> Complex64 {
        self.force[order as usize - 1][sense as usize]
    }

    /// Part of the couple of `order` (1 or 2) in one sense [N m].
    pub fn couple_of(&self, order: u32, sense: Sense) -> Complex64 {
        self.couple[order as usize - 1][sense as usize]
    }

    /// Adds loads of orders 1 and 2.
    pub(super) fn add(&mut self, orders: [&OrderLoads; 2]) {
        for (index, loads) in orders.into_iter().enumerate() {
            self.force[index][0] += loads.force_forward;
            self.force[index][1] += loads.force_backward;
            self.couple[index][0] += loads.couple_forward;
            self.couple[index][1] += loads.couple_backward;
            self.roll_moment[index] += loads.roll_moment;
            self.shaft_torque[index] += loads.shaft_torque;
        }
    }

    /// Adds a force in plane `z` that turns with the crank at order 1.
    pub(super) fn add_turning(&mut self, z: f64, force: Complex64) {
        self.force[0][0] += force;
        self.couple[0][0] += Complex64::new(0.0, z) * force;
    }
}
