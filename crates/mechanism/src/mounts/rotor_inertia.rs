//! Angular momentum of all that turns in the block, from the inertia of its parts (book, eq. 27.12).

use lanchester_model::RotatingBody;

/// Angular momentum of all that turns, relative to the block, over the speed of crankshaft 1: `SUM rho J` [kg m^2], of every body whose
/// polar inertia is known.
pub fn rotor_inertia_about_z(bodies: &[RotatingBody]) -> f64 {
    bodies.iter().filter_map(RotatingBody::momentum).sum()
}
