//! The six components of a load, each with its name, unit and place in the results.

use crate::kit::magnitude::Magnitude;
use lanchester_results::{Extremes, OrderLoads, Peaks, Trace};
use num_complex::Complex64;

/// A component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Component {
    ForceX,
    ForceY,
    CoupleX,
    CoupleY,
    Roll,
    Torque,
}

impl Component {
    pub const ALL: [Component; 6] = [
        Component::ForceX,
        Component::ForceY,
        Component::CoupleX,
        Component::CoupleY,
        Component::Roll,
        Component::Torque,
    ];

    /// Name for files.
    pub fn id(self) -> &'static str {
        match self {
            Component::ForceX => "force-x",
            Component::ForceY => "force-y",
            Component::CoupleX => "couple-x",
            Component::CoupleY => "couple-y",
            Component::Roll => "roll-moment",
            Component::Torque => "shaft-torque",
        }
    }

    /// Name with its symbol.
    pub fn name(self) -> &'static str {
        match self {
            Component::ForceX => "Force F_x",
            Component::ForceY => "Force F_y",
            Component::CoupleX => "Couple M_x",
            Component::CoupleY => "Couple M_y",
            Component::Roll => "Roll moment M_z",
            Component::Torque => "Shaft torque T",
        }
    }

    pub fn unit(self) -> &'static str {
        match self {
            Component::ForceX | Component::ForceY => "N",
            _ => "N m",
        }
    }

    pub fn trace(self, trace: &Trace) -> &[f64] {
        match self {
            Component::ForceX => &trace.force_x,
            Component::ForceY => &trace.force_y,
            Component::CoupleX => &trace.couple_x,
            Component::CoupleY => &trace.couple_y,
            Component::Roll => &trace.roll_moment,
            Component::Torque => &trace.shaft_torque,
        }
    }

    pub fn extremes(self, peaks: &Peaks) -> Extremes {
        match self {
            Component::ForceX => peaks.force_x,
            Component::ForceY => peaks.force_y,
            Component::CoupleX => peaks.couple_x,
            Component::CoupleY => peaks.couple_y,
            Component::Roll => peaks.roll_moment,
            Component::Torque => peaks.shaft_torque,
        }
    }

    pub fn noise(self, magnitude: &Magnitude) -> f64 {
        match self {
            Component::ForceX | Component::ForceY => magnitude.force_noise(),
            Component::CoupleX | Component::CoupleY => magnitude.couple_noise(),
            Component::Roll => magnitude.roll_noise(),
            Component::Torque => magnitude.torque_noise(),
        }
    }

    /// Complex amplitude `c` of one order: the component is `Re(c e^{i n theta})`.
    ///
    /// From `w = f e^{i n theta} + b e^{-i n theta}` follow `Re w = Re((f + conj b) e^{i n theta})` and
    /// `Im w = Re(-i (f - conj b) e^{i n theta})`.
    pub fn amplitude(self, order: &OrderLoads) -> Complex64 {
        let along = |f: Complex64, b: Complex64| f + b.conj();
        let across = |f: Complex64, b: Complex64| Complex64::new(0.0, -1.0) * (f - b.conj());
        match self {
            Component::ForceX => along(order.force_forward, order.force_backward),
            Component::ForceY => across(order.force_forward, order.force_backward),
            Component::CoupleX => along(order.couple_forward, order.couple_backward),
            Component::CoupleY => across(order.couple_forward, order.couple_backward),
            Component::Roll => order.roll_moment,
            Component::Torque => order.shaft_torque,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_of_an_order_add_up_to_its_arrows() {
        let order = OrderLoads {
            order: 2.0,
            force_forward: Complex64::new(3.0, -1.0),
            force_backward: Complex64::new(0.5, 2.0),
            couple_forward: Complex64::default(),
            couple_backward: Complex64::default(),
            roll_moment: Complex64::default(),
            shaft_torque: Complex64::default(),
        };
        for theta in [0.0, 0.7, 2.0] {
            let turn = Complex64::from_polar(1.0, order.order * theta);
            let whole = order.force_forward * turn + order.force_backward * turn.conj();
            assert!((whole.re - (Component::ForceX.amplitude(&order) * turn).re).abs() < 1e-14);
            assert!((whole.im - (Component::ForceY.amplitude(&order) * turn).re).abs() < 1e-14);
        }
    }
}
