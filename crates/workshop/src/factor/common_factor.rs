//! One factor for all throws of an engine: what it does to the first order on the block.
//!
//! With every rotating mass balanced in its own throw and the share `f` of the reciprocating masses balanced on top,
//!
//! ```text
//! forward  A - f G,   backward  B         A = SUM p_+ e^{i a},  G = SUM P e^{i a},  B = SUM p_- e^{-i a}   (force)
//!                                          the couple alike, every term times i z
//! least peak    f = Re( A conj(G) ) / |G|^2                  1/2 for centred plain rods, whatever the bank angle
//! one plane     |A - f G| = |B|                              forward and backward part as large: a line
//! ```
//! For a pair of pistons on a V of bank angle `g` whose second pin stands `d` ahead of the first, per reciprocating
//! unbalance of one piston: `A = cos(d/2)`, `G = 2 cos(d/2)`, `B = cos(g - d/2)`. A 90-degree V on shared pins has
//! `B = 0`: 50 % leaves nothing of the first order. On split pins of 30 degrees (even-firing 90-degree V6, `d = -30`)
//! `B = -sin 15`, and `f = (1 - tan 15) / 2 = 36.6 %` leaves a first order that swings across the bisector alone.

use crate::error::WorkshopError;
use crate::factor::throw_masses::throw_masses;
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;

/// What a common factor does to the first order of a force [kg m] or couple [kg m^2], over `w^2`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FactorEffect {
    /// `A`: forward part at the factor 0.
    #[schemars(with = "[f64; 2]")]
    pub forward: Complex64,
    /// `G`: what the factor 1 takes from it.
    #[schemars(with = "[f64; 2]")]
    pub per_share: Complex64,
    /// `B`: backward part, which no factor changes.
    #[schemars(with = "[f64; 2]")]
    pub backward: Complex64,
    /// Sum of the amounts behind these sums: what is far below it is rounding.
    pub size: f64,
}

/// A factor at which the first order swings in one plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OnePlane {
    /// Share of the reciprocating masses.
    pub share: f64,
    /// Direction [rad] in the engine's frame of the force, in (-pi/2, pi/2]; for a couple, of the forces that make
    /// it: 0 is rocking in the plane of the crank axis and x.
    pub direction: f64,
}

impl FactorEffect {
    /// Whether the factor makes no difference: the throws cancel one another whatever it is.
    pub fn indifferent(&self) -> bool {
        self.per_share.norm() <= 1e-9 * self.size
    }

    /// The factor with the smallest peak; `None` where it makes no difference.
    pub fn least_peak(&self) -> Option<f64> {
        (!self.indifferent()).then(|| (self.forward * self.per_share.conj()).re / self.per_share.norm_sqr())
    }

    /// Peak of the first order at a factor.
    pub fn peak(&self, share: f64) -> f64 {
        let clean = |part: f64| if part <= 1e-9 * self.size { 0.0 } else { part };
        clean((self.forward - share * self.per_share).norm()) + clean(self.backward.norm())
    }

    /// The factors at which the first order swings in one plane, the smaller first; `None` where there is none, or
    /// where nothing turns backward so that nothing is left at all.
    pub fn one_plane(&self) -> Option<[OnePlane; 2]> {
        let best = self.least_peak()?;
        if self.backward.norm() <= 1e-9 * self.size {
            return None;
        }
        let rest = (self.forward - best * self.per_share).norm_sqr();
        let step = (self.backward.norm_sqr() - rest).max(0.0).sqrt() / self.per_share.norm();
        if self.backward.norm_sqr() < rest * (1.0 - 1e-12) {
            return None;
        }
        Some([best - step, best + step].map(|share| {
            OnePlane {
                share,
                direction: crate::PrimaryEllipse::of(
                    self.forward - share * self.per_share,
                    self.backward,
                    self.size,
                )
                .tilt,
            }
        }))
    }
}

/// What one factor for all throws of a crankshaft does.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CommonFactor {
    /// To the force of the whole crankshaft [kg m].
    pub force: FactorEffect,
    /// To the couple about the origin [kg m^2], as `SUM z F` (the couple itself is `i` times it).
    pub couple: FactorEffect,
}

/// What one factor for all throws of a crankshaft (by index) does, weights opposite the throws in their planes.
///
/// # Errors
/// [`WorkshopError`] where the loads cannot be computed or there is no such crankshaft.
pub fn common_factor(engine: &Engine, crankshaft: usize) -> Result<CommonFactor, WorkshopError> {
    let Some(shaft) = engine.crankshafts.get(crankshaft) else {
        return Err(WorkshopError::Impossible {
            what: format!(
                "there is no crankshaft {}, the engine has {}",
                crankshaft + 1,
                engine.crankshafts.len()
            ),
            hint: "count crankshafts from 1",
        });
    };
    let empty = FactorEffect {
        forward: Complex64::ZERO,
        per_share: Complex64::ZERO,
        backward: Complex64::ZERO,
        size: 0.0,
    };
    let (mut force, mut couple) = (empty, empty);
    for masses in throw_masses(engine)? {
        let throw = &engine.throws[masses.throw];
        if throw.crankshaft != crankshaft {
            continue;
        }
        let turn = Complex64::cis(shaft.phase + throw.angle);
        let share = masses.reciprocating_unbalance();
        force.per_share += share * turn;
        couple.per_share += share * throw.z * turn;
        force.size += share;
        couple.size += share * throw.z.abs();
        for piston in &masses.pistons {
            let (forward, backward) = (piston.forward * turn, piston.backward * turn.conj());
            force.forward += forward;
            force.backward += backward;
            couple.forward += piston.z * forward;
            couple.backward += piston.z * backward;
            couple.size += forward.norm() * piston.z.abs();
        }
    }
    Ok(CommonFactor { force, couple })
}

/// What a factor does to a pair of pistons in a V, per reciprocating unbalance of one piston, in the frame of the
/// bisector and counted from the middle of the two pins.
///
/// `bank_angle` [rad]; `split_angle` [rad]: how far the pin of bank 2 stands ahead of that of bank 1, 0 for a shared
/// pin.
pub fn pin_pair_effect(bank_angle: f64, split_angle: f64) -> FactorEffect {
    let forward = (0.5 * split_angle).cos();
    FactorEffect {
        forward: forward.into(),
        per_share: (2.0 * forward).into(),
        backward: (bank_angle - 0.5 * split_angle).cos().into(),
        size: 2.0,
    }
}

#[cfg(test)]
mod tests;
