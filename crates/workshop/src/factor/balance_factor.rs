//! The balance factor of a throw, by every definition in use.
//!
//! ```text
//! w = -Re W                                        the counterweight's part opposite the throw
//! reciprocating share      f = (w - R) / P         motorcycle practice; V8 shops: "100 % rotating, f of reciprocating"
//! wet reciprocating share  (w - R - o r) / P       with the oil that fills the crank counted as rotating
//! share of total           w / (R + P)
//! bobweight                m_bob = (w - U) / r     the mass at the crankpin that brings crank and counterweight to rest
//! bobweight share          m_bob / SUM (m_A + m_osc)
//! axis ratio               residual along the cylinders over residual across them
//! ```
//! Symbols as in [`crate::ThrowMasses`]; `o` is the mass of the oil. All of these are linear in `w` but the axis
//! ratio, so each gives `w`, and `w` gives all others. For a single, `f` alone tells the ellipse: the residual first
//! order is `(1 - f) P` along the cylinder and `f P` across it.

use crate::error::WorkshopError;
use crate::factor::primary_ellipse::PrimaryEllipse;
use crate::factor::throw_masses::{ThrowMasses, throw_masses};
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::PI;

/// What is known of the counterweight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind", content = "value")]
pub enum FactorGiven {
    /// As the engine file has it.
    AsBuilt,
    /// Share of the reciprocating mass, crank without oil.
    ReciprocatingShare(f64),
    /// Share of the reciprocating mass with the oil counted as rotating.
    WetReciprocatingShare(f64),
    /// Counterweight over rotating plus reciprocating unbalance.
    TotalShare(f64),
    /// Bobweight [kg].
    Bobweight(f64),
    /// Bobweight over all masses at the pin, big ends and reciprocating.
    BobweightShare(f64),
    /// The counterweight's part opposite the throw [kg m].
    Counterweight(f64),
    /// Residual first order along the cylinders over that across them; 1 is the circle.
    AxisRatio(f64),
    /// The smallest peak of the first-order force that a counterweight can give.
    LeastPeak,
}

/// What is asked of [`balance_factors`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FactorRequest {
    /// What is known.
    pub given: FactorGiven,
    /// Oil in each throw [kg], as a mass at the crank radius.
    pub oil: f64,
    /// Direction of the counterweight from the throw [rad]; `None`: as built, or opposite the throw where there is none.
    pub angle: Option<f64>,
}

impl Default for FactorRequest {
    /// As built, without oil.
    fn default() -> Self {
        FactorRequest { given: FactorGiven::AsBuilt, oil: 0.0, angle: None }
    }
}

/// Balance factors of one throw.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowFactor {
    /// Number of the throw, from 1.
    pub throw: usize,
    /// Numbers of its cylinders, from 1.
    pub cylinders: Vec<usize>,
    /// Its masses.
    pub masses: ThrowMasses,
    /// Oil [kg] at the crank radius.
    pub oil: f64,
    /// Counterweight in the frame of the throw [kg m].
    #[schemars(with = "[f64; 2]")]
    pub counterweight: Complex64,
    /// Its part opposite the throw [kg m].
    pub opposite: f64,
    /// Share of the reciprocating mass; `None` where nothing reciprocates.
    pub reciprocating_share: Option<f64>,
    /// Share of the reciprocating mass with the oil counted as rotating.
    pub wet_reciprocating_share: Option<f64>,
    /// Counterweight over rotating and reciprocating unbalance.
    pub total_share: Option<f64>,
    /// Bobweight [kg].
    pub bobweight: f64,
    /// Bobweight over all masses at the pin.
    pub bobweight_share: Option<f64>,
    /// The residual first-order force of the running engine, oil included.
    pub ellipse: PrimaryEllipse,
    /// Residual amplitude along the cylinders' axis [kg m].
    pub along: f64,
    /// Residual amplitude across it [kg m].
    pub across: f64,
    /// The share of the reciprocating mass with the smallest peak of the first-order force.
    pub least_peak_share: Option<f64>,
}

impl ThrowFactor {
    /// The residual first-order force at another share of the reciprocating mass, the counterweight in the same
    /// direction; `None` where nothing reciprocates or the counterweight stands beside the throw.
    pub fn ellipse_at(&self, share: f64) -> Option<PrimaryEllipse> {
        let angle = match self.counterweight.norm() > 0.0 {
            true => self.counterweight.arg(),
            false => PI,
        };
        let given = FactorGiven::ReciprocatingShare(share);
        let request = FactorRequest { given, oil: self.oil, angle: Some(angle) };
        let other = throw_factor(self.masses.clone(), &request).ok()?;
        self.reciprocating_share.map(|_| other.ellipse)
    }
}

/// Balance factors of every throw.
///
/// # Errors
/// [`WorkshopError`] where the loads cannot be computed, or what is given leads to no counterweight.
pub fn balance_factors(engine: &Engine, request: &FactorRequest) -> Result<Vec<ThrowFactor>, WorkshopError> {
    check(
        "oil [kg]",
        request.oil,
        request.oil >= 0.0,
        "a finite mass, not negative",
        "give its mass at the crank radius",
    )?;
    throw_masses(engine)?.into_iter().map(|masses| throw_factor(masses, request)).collect()
}

fn check(
    quantity: &'static str,
    got: f64,
    fits: bool,
    needed: &str,
    hint: &'static str,
) -> Result<(), WorkshopError> {
    if fits && got.is_finite() {
        return Ok(());
    }
    Err(WorkshopError::Number {
        quantity,
        part: "the counterweight".into(),
        needed: needed.into(),
        got,
        hint,
    })
}

fn throw_factor(masses: ThrowMasses, request: &FactorRequest) -> Result<ThrowFactor, WorkshopError> {
    let counterweight = counterweight(&masses, request)?;
    let oil = request.oil * masses.radius;
    let (rotating, reciprocating) = (masses.rotating_unbalance(), masses.reciprocating_unbalance());
    let opposite = -counterweight.re;
    let share = |part: f64, whole: f64| (whole > 0.0).then(|| part / whole);
    let bobweight = (opposite - masses.crank) / masses.radius;
    let forward = masses.forward() + rotating + oil + counterweight;
    let size = rotating.abs() + reciprocating + opposite.abs();
    let ellipse = PrimaryEllipse::of(forward, masses.backward(), size);
    let least = least_peak(&masses, oil);
    Ok(ThrowFactor {
        throw: masses.throw + 1,
        cylinders: masses.pistons.iter().map(|p| p.cylinder + 1).collect(),
        oil: request.oil,
        counterweight,
        opposite,
        reciprocating_share: share(opposite - rotating, reciprocating),
        wet_reciprocating_share: share(opposite - rotating - oil, reciprocating),
        total_share: share(opposite, rotating + reciprocating),
        bobweight,
        bobweight_share: share(bobweight, masses.big_ends + masses.reciprocating),
        along: ellipse.along(masses.axis),
        across: ellipse.along(masses.axis + 0.5 * PI),
        ellipse,
        least_peak_share: share(least - rotating, reciprocating),
        masses,
    })
}

/// The opposite part that leaves nothing of the real part of the forward first order.
fn least_peak(masses: &ThrowMasses, oil: f64) -> f64 {
    masses.rotating_unbalance() + oil + masses.forward().re
}

/// The counterweight behind what is given, in the frame of the throw.
fn counterweight(masses: &ThrowMasses, request: &FactorRequest) -> Result<Complex64, WorkshopError> {
    let built = masses.counterweight;
    let none = built.norm() <= 1e-12 * (masses.rotating_unbalance().abs() + masses.reciprocating_unbalance());
    if request.given == FactorGiven::AsBuilt {
        if let Some(angle) = request.angle {
            check("direction [rad]", angle, true, "finite", "give an angle such as 180 deg")?;
            return Ok(Complex64::from_polar(built.norm(), angle));
        }
        return Ok(built);
    }
    let angle = request.angle.unwrap_or(if none { PI } else { built.arg() });
    check(
        "direction [rad]",
        angle,
        angle.cos() < -1e-3,
        "on the side away from the throw (more than 90 deg from it)",
        "a factor is the part of the counterweight opposite the throw: give an angle, for example 180 deg",
    )?;
    let opposite = opposite(masses, request)?;
    check("unbalance [kg m]", opposite, true, "finite", "check the factor")?;
    Ok(Complex64::new(-opposite, -opposite * angle.tan()))
}

/// `w` from what is given.
fn opposite(masses: &ThrowMasses, request: &FactorRequest) -> Result<f64, WorkshopError> {
    let (rotating, reciprocating) = (masses.rotating_unbalance(), masses.reciprocating_unbalance());
    let oil = request.oil * masses.radius;
    Ok(match request.given {
        FactorGiven::AsBuilt => -masses.counterweight.re,
        FactorGiven::ReciprocatingShare(share) => rotating + share * reciprocating,
        FactorGiven::WetReciprocatingShare(share) => rotating + oil + share * reciprocating,
        FactorGiven::TotalShare(share) => share * (rotating + reciprocating),
        FactorGiven::Bobweight(mass) => masses.crank + mass * masses.radius,
        FactorGiven::BobweightShare(share) => {
            masses.crank + share * (masses.big_ends + masses.reciprocating) * masses.radius
        }
        FactorGiven::Counterweight(unbalance) => unbalance,
        FactorGiven::LeastPeak => least_peak(masses, oil),
        FactorGiven::AxisRatio(ratio) => {
            check("axis ratio", ratio, ratio >= 0.0, "not negative", "along over across: 1 is the circle")?;
            // Along: c + s - w, across: w - c + s, with c all that turns forward and s the backward part on the axis.
            let centre = least_peak(masses, oil);
            let swing = (masses.backward() * Complex64::cis(-2.0 * masses.axis)).re;
            (centre + swing + ratio * (centre - swing)) / (1.0 + ratio)
        }
    })
}

#[cfg(test)]
mod tests;
