//! What exact cancellation answers beside the weights: plain data, SI units and radians.

use lanchester_task::Criterion;
use num_complex::Complex64;
use serde::Serialize;

/// Exact cancellation: what had to vanish, and the proof that no lighter weights do it or that none can.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Cancellation {
    /// Every order of the task, in its order.
    pub orders: Vec<CancelledOrder>,
    /// What was found, with its proof.
    pub verdict: CancellationVerdict,
}

/// An order that had to vanish.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CancelledOrder {
    /// One order of a load.
    pub criterion: Criterion,
    /// Its peak without the free devices [N or N m].
    pub without: f64,
    /// Its peak with the answer [N or N m]: from the loads of the engine with the weights fitted, computed anew.
    pub left: f64,
    /// The least that these devices leave of it where nothing else is asked for [N or N m]; 0 where it can vanish alone.
    pub least_alone: f64,
}

/// Whether the orders can vanish together.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum CancellationVerdict {
    /// They vanish. Of all weights that do it the answer has those that come first by the default stages
    /// ([`crate::Answer::among_equals`]), then the lightest; the proof is that nothing lighter than `least` does it.
    Vanish {
        /// Total unbalance of the answer [kg m], or mass [kg] where every weight has a radius.
        total: f64,
        /// That of the lightest weights that do it; the same where nothing but the weights decides.
        least: f64,
        /// Whether the total is a mass.
        is_mass: bool,
        /// No weights that make the orders vanish have a total below `lightest.value`.
        lightest: Functional,
    },
    /// They cannot; each obstruction alone proves it. The weights of the answer leave the least.
    CannotVanish {
        /// At least one, each for orders that hang together through the devices.
        obstructions: Vec<Obstruction>,
    },
}

/// Why orders cannot vanish.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Obstruction {
    /// In words, with numbers and units.
    pub reason: String,
    /// The proof: this functional is 1 with or without the devices, and would be 0 or less if the orders vanished.
    pub functional: Functional,
}

/// A linear functional of the orders, `SUM over terms of Re( conj(factor) * -amount )`: what it says of every choice of
/// the devices.
///
/// With `a_k(U)` what the devices add to the orders, the orders vanish where `a_k(U) = -amount_k`. Let `y` be the
/// factors. A weight of amount 1 changes `SUM Re( conj(y_k) a_k )` by no more than its pull `|(A^H y)_i|`. So
///
/// ```text
/// SUM of cost_i |U_i|  >=  Re( y^H b ) - SUM of charges      if no pull passes the weight's cost by more than its charge pays for
/// ```
/// With costs of 1 (of 1 / radius for masses) this bounds the total; with costs of 0 a value above 0 proves that no `U`
/// makes the orders vanish.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Functional {
    /// Its terms.
    pub terms: Vec<FunctionalTerm>,
    /// What weights with a largest amount, and inertias, can do against it at most: name and amount, in the unit of the
    /// value.
    pub charges: Vec<(String, f64)>,
    /// Sum of the terms less the charges [kg m or kg; 1 for an obstruction].
    pub value: f64,
    /// Largest pull of a weight without a largest amount: over its cost (at most 1) where the total is bounded; over the
    /// most that factors of the same size could pull (0 to rounding) for an obstruction.
    pub largest_pull: f64,
}

/// One part of one order in a functional.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FunctionalTerm {
    /// One order of a load.
    pub criterion: Criterion,
    /// Which part of it.
    pub sense: OrderSense,
    /// `y`: value of the functional per N or N m.
    #[schemars(with = "[f64; 2]")]
    pub factor: Complex64,
    /// The part without the free devices [N or N m].
    #[schemars(with = "[f64; 2]")]
    pub amount: Complex64,
}

/// A part of one order of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OrderSense {
    /// Turns with crankshaft 1: `f_+` of `f_+ e^{i n theta}`.
    Forward,
    /// Turns against it: `f_-` of `f_- e^{-i n theta}`.
    Backward,
    /// Alternates along or about one axis: `m` of `Re( m e^{i n theta} )`; of a mount force, along z.
    Alternating,
}
