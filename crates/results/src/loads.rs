//! Loads on the block: over the crank angle, by two-sided order, and their extremes.
//!
//! All in SI and radians. Components are those of the frame (book, "Conventions"): what the moving parts exert on the block, couples about a
//! reference point.

use crate::extreme::Extremes;
use crate::order::{TwoSided, amplitude};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;

/// The five components on the block and the shaft torque, at one crank angle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Components {
    /// Force along x [N].
    pub force_x: f64,
    /// Force along y [N].
    pub force_y: f64,
    /// Couple about x [N m].
    pub couple_x: f64,
    /// Couple about y [N m].
    pub couple_y: f64,
    /// Roll moment about z on the block [N m].
    pub roll_moment: f64,
    /// Inertia torque that the crank train delivers at crankshaft 1 [N m], positive in the sense of rotation.
    pub shaft_torque: f64,
}

/// Components over one period, at equally spaced crank angles; one vector a component so that it plots as it is.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Trace {
    /// Crank angle of crankshaft 1 [rad], from 0, one period, end point excluded.
    pub theta: Vec<f64>,
    /// Force along x [N].
    pub force_x: Vec<f64>,
    /// Force along y [N].
    pub force_y: Vec<f64>,
    /// Couple about x [N m].
    pub couple_x: Vec<f64>,
    /// Couple about y [N m].
    pub couple_y: Vec<f64>,
    /// Roll moment about z [N m].
    pub roll_moment: Vec<f64>,
    /// Shaft torque [N m].
    pub shaft_torque: Vec<f64>,
}

/// One order of the loads.
///
/// `F_x + i F_y = SUM over orders ( force_forward e^{i n theta} + force_backward e^{-i n theta} )`, the couple
/// `M_x + i M_y` alike; order 0 has its whole mean in `*_forward`. Roll moment and torque are
/// `Re( SUM roll_moment e^{i n theta} )`: their modulus is the amplitude.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OrderLoads {
    /// Order: cycles per revolution of crankshaft 1, not negative; fractions come from geared crankshafts.
    pub order: f64,
    /// Part of the force that turns with the crank [N].
    #[schemars(with = "[f64; 2]")]
    pub force_forward: Complex64,
    /// Part of the force that turns against the crank [N].
    #[schemars(with = "[f64; 2]")]
    pub force_backward: Complex64,
    /// Part of the couple that turns with the crank [N m].
    #[schemars(with = "[f64; 2]")]
    pub couple_forward: Complex64,
    /// Part of the couple that turns against the crank [N m].
    #[schemars(with = "[f64; 2]")]
    pub couple_backward: Complex64,
    /// Roll moment [N m], modulus = amplitude.
    #[schemars(with = "[f64; 2]")]
    pub roll_moment: Complex64,
    /// Shaft torque [N m], modulus = amplitude.
    #[schemars(with = "[f64; 2]")]
    pub shaft_torque: Complex64,
}

impl Trace {
    /// One order of it; the angles are equal steps over `period` [rad], in which the order has whole cycles.
    pub fn order(&self, order: f64, period: f64) -> OrderLoads {
        let (start, revolutions) = (self.theta.first().copied().unwrap_or(0.0), period / TAU);
        let vector = |x: &[f64], y: &[f64]| {
            let samples: Vec<Complex64> = x.iter().zip(y).map(|(x, y)| Complex64::new(*x, *y)).collect();
            TwoSided::of_samples(&samples, start, revolutions, order)
        };
        let one = |values: &[f64]| amplitude(values.iter().copied(), values.len(), start, revolutions, order);
        let (force, couple) = (vector(&self.force_x, &self.force_y), vector(&self.couple_x, &self.couple_y));
        OrderLoads {
            order,
            force_forward: force.forward,
            force_backward: force.backward,
            couple_forward: couple.forward,
            couple_backward: couple.backward,
            roll_moment: one(&self.roll_moment),
            shaft_torque: one(&self.shaft_torque),
        }
    }
}

impl OrderLoads {
    /// Largest resultant of this order's force over the cycle [N]: major half axis of its ellipse.
    pub fn force_peak(&self) -> f64 {
        self.force_forward.norm() + self.force_backward.norm()
    }

    /// Largest resultant of this order's couple over the cycle [N m].
    pub fn couple_peak(&self) -> f64 {
        self.couple_forward.norm() + self.couple_backward.norm()
    }
}

/// Loads of the whole engine, of one kind of part, or of one cylinder.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LoadSet {
    /// Over one period.
    pub trace: Trace,
    /// By order, rising: all whole orders asked for, also the vanishing ones, and the fractions that geared crankshafts
    /// and shafts bring.
    pub orders: Vec<OrderLoads>,
    /// Extremes over the continuous angle (or over the grid, where one was asked for).
    pub peaks: Peaks,
}

/// Extremes of every quantity of a [`LoadSet`].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Peaks {
    /// Force along x.
    pub force_x: Extremes,
    /// Force along y.
    pub force_y: Extremes,
    /// Resultant force `|F_x + i F_y|`.
    pub force: Extremes,
    /// Couple about x.
    pub couple_x: Extremes,
    /// Couple about y.
    pub couple_y: Extremes,
    /// Resultant couple `|M_x + i M_y|`.
    pub couple: Extremes,
    /// Roll moment.
    pub roll_moment: Extremes,
    /// Shaft torque.
    pub shaft_torque: Extremes,
}
