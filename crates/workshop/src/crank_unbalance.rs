//! Static, couple and dynamic unbalance of a crankshaft that carries its bobweights.
//!
//! ```text
//! U = SUM U_k                                static unbalance
//! D = SUM (z_k - z_g) U_k                    couple unbalance about the mass centre (ISO 21940-2)
//! e = U / m                                  offset of the mass centre
//! tan 2 alpha = 2 |D| / |I_t - I_p|          tilt of the principal axis through the mass centre
//! z_q = z_g + Re( D conj(U) ) / |U|^2        plane of the single quasi-static unbalance; what is left is across it
//! ```
//! | symbol   | name                                                               | unit   |
//! |----------|--------------------------------------------------------------------|--------|
//! | U_k, z_k | throws, bobweights and counterweights, and their planes            | kg m, m|
//! | m, z_g   | mass of the crank with its bobweights, place of its mass centre    | kg, m  |
//! | I_t, I_p | transverse inertia about the mass centre, polar inertia            | kg m^2 |
//!
//! `D`, taken about the point of the shaft at `z_g`, is also the product of inertia about the mass centre: moving the
//! axis sideways by `e` changes it by `e` times the first moment of the mass along z, which is 0 there.

use crate::error::WorkshopError;
use crate::rotor::plane::{Plane, PlaneUnbalance, in_two_planes};
use lanchester_model::{Engine, Rotation};
use num_complex::Complex64;
use serde::Serialize;

/// What is known of the crankshaft as a body, bobweights on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankBody {
    /// Mass with bobweights [kg].
    pub mass: f64,
    /// Place of its mass centre along the crank [m], from the origin.
    pub mass_centre: f64,
    /// Inertia about a transverse axis through the mass centre [kg m^2].
    pub transverse_inertia: f64,
    /// Inertia about the crank axis [kg m^2].
    pub polar_inertia: f64,
}

/// The kinds of unbalance of ISO 21940-2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum UnbalanceKind {
    /// None.
    Balanced,
    /// The principal axis is parallel to the shaft's.
    Static,
    /// The principal axis crosses the shaft's in the mass centre.
    Couple,
    /// The principal axis crosses the shaft's elsewhere: one weight in one plane would mend it.
    QuasiStatic,
    /// The principal axis neither crosses the shaft's nor is parallel to it.
    Dynamic,
}

impl UnbalanceKind {
    /// Words for tables.
    pub fn name(self) -> &'static str {
        match self {
            UnbalanceKind::Balanced => "balanced",
            UnbalanceKind::Static => "static: the principal axis is parallel to the shaft",
            UnbalanceKind::Couple => "couple: the principal axis crosses the shaft in the mass centre",
            UnbalanceKind::QuasiStatic => "quasi-static: one weight in one plane would mend it",
            UnbalanceKind::Dynamic => "dynamic: it takes two planes",
        }
    }
}

/// A single unbalance that stands for all, but for a couple across it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct QuasiStatic {
    /// Its plane [m], from the origin.
    pub z: f64,
    /// The couple that is left [kg m^2]: perpendicular to the static unbalance.
    pub rest: f64,
}

/// What unbalance does to the crankshaft as a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BodyState {
    /// What is known of the body.
    pub body: CrankBody,
    /// Offset of the mass centre [m], in the frame of the crankshaft.
    #[schemars(with = "[f64; 2]")]
    pub offset: Complex64,
    /// Couple unbalance about the mass centre [kg m^2].
    #[schemars(with = "[f64; 2]")]
    pub couple: Complex64,
    /// Tilt of the principal axis that is nearest the shaft [rad].
    pub tilt: f64,
    /// Direction to which its flywheel end leans [rad], in the frame of the crankshaft.
    pub tilt_direction: f64,
    /// The nearest single unbalance; `None` without static unbalance.
    pub quasi_static: Option<QuasiStatic>,
    /// Its kind.
    pub kind: UnbalanceKind,
}

/// Unbalance of one crankshaft with bobweights.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankUnbalance {
    /// [`crate::WORKSHOP_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Name of the crankshaft.
    pub crankshaft: String,
    /// Sense of rotation, for pictures.
    pub rotation: Rotation,
    /// Throws and bobweights.
    pub throws: Vec<PlaneUnbalance>,
    /// Counterweights of the file.
    pub counterweights: Vec<PlaneUnbalance>,
    /// Static unbalance [kg m].
    #[schemars(with = "[f64; 2]")]
    pub static_unbalance: Complex64,
    /// Couple unbalance about the origin [kg m^2].
    #[schemars(with = "[f64; 2]")]
    pub couple_unbalance: Complex64,
    /// Dynamic unbalance: as two, in the planes asked for.
    pub planes: [PlaneUnbalance; 2],
    /// As a body, where that is known.
    pub body: Option<BodyState>,
}

/// Static, couple and dynamic unbalance of crankshaft `crankshaft` (by index) with a bobweight [kg] on each throw of
/// the engine (all throws, in its order; those of other crankshafts are not looked at).
///
/// # Errors
/// [`WorkshopError`] for a crankshaft that is not there, a wrong number of bobweights, planes that coincide, or a
/// body that cannot be.
pub fn crank_unbalance(
    engine: &Engine,
    crankshaft: usize,
    bobweights: &[f64],
    planes: &[Plane; 2],
    body: Option<CrankBody>,
) -> Result<CrankUnbalance, WorkshopError> {
    let [throws, counterweights] = crank_parts(engine, crankshaft, bobweights)?;
    let parts = [throws.as_slice(), &counterweights].concat();
    let static_unbalance: Complex64 = parts.iter().map(|p| p.unbalance).sum();
    let couple_unbalance: Complex64 = parts.iter().map(|p| p.z * p.unbalance).sum();
    // What every part brings, without the cancelling: rounding is small beside it.
    let size: f64 = parts.iter().map(|p| p.unbalance.norm()).sum();
    Ok(CrankUnbalance {
        version: crate::WORKSHOP_VERSION,
        engine: engine.name.clone(),
        crankshaft: engine.crankshafts[crankshaft].name.clone(),
        planes: in_two_planes(&parts, planes)?,
        body: body
            .map(|body| body_state(body, static_unbalance, couple_unbalance, size, &parts))
            .transpose()?,
        rotation: engine.rotation,
        throws,
        counterweights,
        static_unbalance,
        couple_unbalance,
    })
}

/// Throws with bobweights, and counterweights, of a crankshaft, in its own frame.
pub(super) fn crank_parts(
    engine: &Engine,
    crankshaft: usize,
    bobweights: &[f64],
) -> Result<[Vec<PlaneUnbalance>; 2], WorkshopError> {
    if crankshaft >= engine.crankshafts.len() {
        return Err(WorkshopError::Impossible {
            what: format!(
                "there is no crankshaft {}, the engine has {}",
                crankshaft + 1,
                engine.crankshafts.len()
            ),
            hint: "count crankshafts from 1",
        });
    }
    if bobweights.len() != engine.throws.len() {
        return Err(WorkshopError::Impossible {
            what: format!("{} throws need a bobweight each, got {}", engine.throws.len(), bobweights.len()),
            hint: "give one bobweight for all throws, or one for each",
        });
    }
    let mut throws = Vec::new();
    for (index, throw) in engine.throws.iter().enumerate().filter(|(_, t)| t.crankshaft == crankshaft) {
        let bob = bobweights[index];
        if !(bob >= 0.0 && bob.is_finite()) {
            return Err(WorkshopError::Number {
                quantity: "bobweight [kg]",
                part: format!("throw {}", index + 1),
                needed: "finite and not negative".into(),
                got: bob,
                hint: "give its mass at the crank radius",
            });
        }
        let turn = Complex64::cis(throw.angle);
        let at =
            |name: String, z: f64, unbalance: f64| PlaneUnbalance { name, z, unbalance: unbalance * turn };
        throws.push(at(format!("throw {}", index + 1), throw.unbalance_plane(), throw.unbalance));
        throws.push(at(format!("bobweight {}", index + 1), throw.z, bob * throw.radius));
    }
    let counterweights = engine
        .counterweights
        .iter()
        .filter(|weight| weight.crankshaft == crankshaft)
        .map(|weight| PlaneUnbalance {
            name: format!("counterweight {}", weight.name),
            z: weight.z,
            unbalance: Complex64::from_polar(weight.unbalance, weight.angle),
        })
        .collect();
    Ok([throws, counterweights])
}

/// Parts below this share of all count as none.
const NOTHING: f64 = 1e-9;

fn body_state(
    body: CrankBody,
    static_unbalance: Complex64,
    couple_about_origin: Complex64,
    size: f64,
    parts: &[PlaneUnbalance],
) -> Result<BodyState, WorkshopError> {
    let refuse = |quantity, needed: &str, got, hint| {
        Err(WorkshopError::Number {
            quantity,
            part: "the crankshaft".into(),
            needed: needed.into(),
            got,
            hint,
        })
    };
    if !(body.mass > 0.0 && body.mass.is_finite()) {
        return refuse("mass [kg]", "positive", body.mass, "weigh it with its bobweights");
    }
    if !body.mass_centre.is_finite() {
        return refuse("mass centre [m]", "finite", body.mass_centre, "balance it on an edge");
    }
    if !(body.polar_inertia > 0.0 && body.polar_inertia.is_finite()) {
        return refuse(
            "polar inertia [kg m2]",
            "positive",
            body.polar_inertia,
            "take it from the drawing or a pendulum",
        );
    }
    // No body is rounder than a disc: I_p <= 2 I_t.
    if !(2.0 * body.transverse_inertia >= body.polar_inertia && body.transverse_inertia.is_finite()) {
        return refuse(
            "transverse inertia [kg m2]",
            "at least half the polar inertia",
            body.transverse_inertia,
            "take it about an axis across the crank through its mass centre",
        );
    }
    let couple = couple_about_origin - body.mass_centre * static_unbalance;
    let length = parts.iter().fold(0.0f64, |m, p| m.max((p.z - body.mass_centre).abs()));
    let (no_force, no_couple) =
        (static_unbalance.norm() <= NOTHING * size, couple.norm() <= NOTHING * size * length);
    let quasi_static = (!no_force).then(|| QuasiStatic {
        z: body.mass_centre + (couple * static_unbalance.conj()).re / static_unbalance.norm_sqr(),
        rest: ((couple * static_unbalance.conj()).im / static_unbalance.norm()).abs(),
    });
    let across = quasi_static.map_or(0.0, |q| q.rest);
    let kind = match (no_force, no_couple) {
        (true, true) => UnbalanceKind::Balanced,
        (false, true) => UnbalanceKind::Static,
        (true, false) => UnbalanceKind::Couple,
        (false, false) if across <= NOTHING * size * length => UnbalanceKind::QuasiStatic,
        (false, false) => UnbalanceKind::Dynamic,
    };
    let lean = 0.5 * (2.0 * couple.norm()).atan2((body.transverse_inertia - body.polar_inertia).abs());
    // A body shorter than it is wide leans the other way: its polar axis is the one of the largest inertia.
    let outward = if body.transverse_inertia >= body.polar_inertia { couple } else { -couple };
    Ok(BodyState {
        body,
        offset: if no_force { Complex64::ZERO } else { static_unbalance / body.mass },
        couple: if no_couple { Complex64::ZERO } else { couple },
        tilt: if no_couple { 0.0 } else { lean },
        tilt_direction: if no_couple { 0.0 } else { outward.arg() },
        quasi_static,
        kind,
    })
}

#[cfg(test)]
mod tests;
