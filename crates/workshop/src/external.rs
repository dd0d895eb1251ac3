//! Internal to external balance: what flywheel and damper must carry for the counterweights inside.
//!
//! A rigid crank does not mind where its weights stand, as long as their sum and their moment along the shaft stay
//! (see [`crate::in_two_planes`]). The main bearings and the crank's bending do: weights outside carry their forces
//! through the whole shaft.

use crate::crank_unbalance::crank_parts;
use crate::error::WorkshopError;
use crate::rotor::plane::{Plane, PlaneUnbalance, in_two_planes};
use lanchester_model::{Engine, EngineParts};
use num_complex::Complex64;
use serde::Serialize;

/// Weights that flywheel and damper must carry.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ExternalBalance {
    /// [`crate::WORKSHOP_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Name of the crankshaft.
    pub crankshaft: String,
    /// Share of every counterweight inside that stays.
    pub kept_share: f64,
    /// Static unbalance of the crank with its bobweights, without weights outside [kg m].
    #[schemars(with = "[f64; 2]")]
    pub static_unbalance: Complex64,
    /// Couple unbalance about the origin [kg m^2].
    #[schemars(with = "[f64; 2]")]
    pub couple_unbalance: Complex64,
    /// The weights outside that bring both to 0.
    pub weights: [PlaneUnbalance; 2],
    /// Distance of each weight's centre of gravity from the axis [m], and its mass [kg] there, where the distance is given.
    pub masses: [Option<RadiusAndMass>; 2],
}

/// A weight by its mass at a radius: their product is its unbalance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RadiusAndMass {
    /// Distance of the centre of gravity from the axis [m].
    pub radius: f64,
    /// Mass [kg].
    pub mass: f64,
}

/// What weights in the two planes bring crankshaft `crankshaft` (by index) into balance with its bobweights (one a
/// throw of the engine [kg]), if the share `kept_share` of every counterweight of the file stays. `radii` [m]: where
/// the centres of gravity of the two weights stand, for their masses.
///
/// # Errors
/// As [`crate::crank_unbalance`], for a share outside 0 to 1 and for a radius that is not above 0.
pub fn external_balance(
    engine: &Engine,
    crankshaft: usize,
    bobweights: &[f64],
    planes: &[Plane; 2],
    radii: [Option<f64>; 2],
    kept_share: f64,
) -> Result<ExternalBalance, WorkshopError> {
    if !(0.0..=1.0).contains(&kept_share) {
        return Err(WorkshopError::Number {
            quantity: "share that stays",
            part: "the counterweights".into(),
            needed: "from 0 to 1".into(),
            got: kept_share,
            hint: "a share is written 60% or 0.6",
        });
    }
    for (plane, radius) in planes.iter().zip(radii) {
        if let Some(radius) = radius.filter(|radius| !(radius.is_finite() && *radius > 0.0)) {
            return Err(WorkshopError::Number {
                quantity: "radius [m] of the weight",
                part: format!("plane `{}`", plane.name),
                needed: "above 0".into(),
                got: radius,
                hint: "it is the distance of the weight's centre of gravity from the crank axis",
            });
        }
    }
    let keep = |parts: &mut EngineParts| {
        for weight in &mut parts.counterweights {
            weight.unbalance *= kept_share;
            weight.part = None;
        }
    };
    let engine = engine.with(keep).expect("invariant: a share of a weight is a weight");
    let parts = crank_parts(&engine, crankshaft, bobweights)?.concat();
    let size: f64 = parts.iter().map(|p| p.unbalance.norm()).sum();
    let mut weights = in_two_planes(&parts, planes)?;
    for weight in &mut weights {
        // Rounding is no weight.
        weight.unbalance =
            if weight.unbalance.norm() <= 1e-12 * size { Complex64::ZERO } else { -weight.unbalance };
    }
    let mass = |k: usize| {
        radii[k].map(|radius| RadiusAndMass { radius, mass: weights[k].unbalance.norm() / radius })
    };
    let masses = [mass(0), mass(1)];
    Ok(ExternalBalance {
        version: crate::WORKSHOP_VERSION,
        engine: engine.name.clone(),
        crankshaft: engine.crankshafts[crankshaft].name.clone(),
        kept_share,
        static_unbalance: parts.iter().map(|p| p.unbalance).sum(),
        couple_unbalance: parts.iter().map(|p| p.z * p.unbalance).sum(),
        weights,
        masses,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FactorRequest, balance_factors, crank_unbalance};
    use lanchester_file::{read, template};
    use lanchester_model::Counterweight;

    fn planes() -> [Plane; 2] {
        [Plane { name: "damper".into(), z: -0.26 }, Plane { name: "flywheel".into(), z: 0.31 }]
    }

    /// With the weights outside bolted on, the lightened crank is in balance; a single's by the lever by hand.
    #[test]
    fn the_crank_is_in_balance_with_its_weights_outside() {
        for name in ["v8-crossplane", "in-line-3", "single"] {
            let mut engine = read(template(name).unwrap().text).engine().unwrap();
            let factors = balance_factors(&engine, &FactorRequest::default()).unwrap();
            let bobs: Vec<f64> = factors.iter().map(|f| f.bobweight).collect();
            let all = external_balance(&engine, 0, &bobs, &planes(), [None; 2], 1.0).unwrap();
            assert!(all.weights.iter().all(|w| w.unbalance == Complex64::ZERO), "{name}");
            let external = external_balance(&engine, 0, &bobs, &planes(), [Some(0.08), None], 0.7).unwrap();
            if name == "single" {
                let missing = 0.3 * factors[0].opposite;
                assert!((external.weights[0].unbalance + missing * 0.31 / 0.57).norm() < 1e-15);
                let [Some(damper), None] = external.masses else { panic!("{:?}", external.masses) };
                assert!((damper.mass - missing * 0.31 / 0.57 / 0.08).abs() < 1e-13);
            }
            engine = engine
                .with(|engine| {
                    for weight in &mut engine.counterweights {
                        weight.unbalance *= 0.7;
                    }
                })
                .expect("an engine");
            for weight in &external.weights {
                engine = engine
                    .with(|engine| {
                        engine.counterweights.push(Counterweight {
                            name: weight.name.clone(),
                            crankshaft: 0,
                            z: weight.z,
                            unbalance: weight.unbalance.norm(),
                            angle: weight.unbalance.arg(),
                            part: None,
                        });
                    })
                    .expect("an engine");
            }
            let inside = [Plane { name: "a".into(), z: -0.1 }, Plane { name: "b".into(), z: 0.1 }];
            let left = crank_unbalance(&engine, 0, &bobs, &inside, None).unwrap();
            assert!(left.planes.iter().all(|p| p.unbalance.norm() < 1e-15), "{name}");
            assert!(external.weights[0].unbalance.norm() > 1e-4, "{name} has something to carry");
        }
    }

    #[test]
    fn a_share_beyond_all_is_refused() {
        let engine = read(template("single").unwrap().text).engine().unwrap();
        let error = external_balance(&engine, 0, &[0.5], &planes(), [None; 2], 1.4).unwrap_err().to_string();
        assert!(error.contains("from 0 to 1, got 1.4"), "{error}");
        let error =
            external_balance(&engine, 0, &[0.5], &planes(), [None, Some(0.0)], 0.5).unwrap_err().to_string();
        assert!(error.contains("`flywheel`") && error.contains("above 0, got 0"), "{error}");
    }
}
