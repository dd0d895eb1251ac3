//! Crankshafts as bodies in a run: what [crank.body] says of their centres and inertia tensors beside what unbalances and polar inertia say.

use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::Engine;
use lanchester_multibody::{MultibodyError, Train};
use lanchester_units::{Dimension, readable};
use num_complex::Complex64;

/// Unbalance in metres and product of inertia in square metres of mass that are rounding.
const ROUNDING: f64 = 1e-9;

/// What a note tells of every crankshaft that is a body; where `as_body`, the rotors of `train` get their moments.
///
/// # Errors
/// [`MultibodyError::NoCrankBody`] where they are wanted and the file has no such body.
pub(crate) fn crank_bodies(
    engine: &Engine,
    train: &mut Train,
    as_body: bool,
) -> Result<Vec<String>, MultibodyError> {
    let mut notes = Vec::new();
    for (index, shaft) in engine.crankshafts.iter().enumerate() {
        let body = match crankshaft(engine, index) {
            Ok(body) => body,
            Err(error) if as_body => {
                return Err(MultibodyError::NoCrankBody {
                    name: shaft.name.clone(),
                    reason: error.to_string(),
                });
            }
            Err(_) => continue,
        };
        let turn = Complex64::cis(shaft.phase);
        let (unbalance, couple) = (body.unbalance.unbalance, body.unbalance.couple);
        let first = Complex64::new(unbalance.x, unbalance.y) * turn;
        let product = Complex64::new(couple.x, couple.y) * turn;
        // Products of inertia stand with their minus sign.
        let [[xx, xy, _], [_, yy, _], _] = body.mass.inertia_about_axis;
        let unequal = Complex64::new(yy - xx, -2.0 * xy) * turn * turn;
        let rotor = &train.rotors[index];
        notes.push(format!(
            "{} as a body: {:.4} kg with its centre at z = {:.2} mm; its inertias across the axis are {} and {} (largest and smallest). {} {}",
            shaft.name,
            body.mass.mass,
            1e3 * body.mass.centre[2],
            readable(0.5 * (xx + yy + unequal.norm()), Dimension::Inertia),
            readable(0.5 * (xx + yy - unequal.norm()), Dimension::Inertia),
            departs((first - rotor.first_moment).norm(), (product - rotor.product).norm(), body.mass.mass),
            match as_body {
                true => "The run takes those of the body.",
                false => "The run takes unbalances and polar inertia (`crankshaft = \"body\"` in [simulation]: those of the body).",
            }
        ));
        if as_body {
            train.set_body(index, first, product, unequal);
        }
    }
    Ok(notes)
}

/// By how much unbalance [kg m] and product of inertia [kg m2] of a body of this mass [kg] depart from those of its throws and counterweights, in words.
fn departs(unbalance: f64, product: f64, mass: f64) -> String {
    if unbalance.max(product) < ROUNDING * mass {
        return "Its unbalance and product of inertia are those of its throws and counterweights.".to_owned();
    }
    format!(
        "Its unbalance departs from that of its throws and counterweights by {unbalance:.2e} kg m, its product of inertia by {product:.2e} kg m2."
    )
}
