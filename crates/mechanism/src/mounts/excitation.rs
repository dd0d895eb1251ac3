//! What shakes the block: loads by order at each speed.

use crate::inertia::request::LoadRequest;
use crate::mounts::error::MountError;
use crate::train::mechanism::Mechanism;
use lanchester_model::Engine;
use lanchester_results::OrderLoads;
use nalgebra::{Vector3, Vector6};
use num_complex::Complex64;

/// Loads on the block by order at one speed, couples and roll moment about the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Loads by order, rising; [`crate::merged_orders`] adds those of gas to those of inertia.
    pub orders: Vec<OrderLoads>,
}

/// Inertia loads of `engine` at each of `speeds` [rad/s], orders to `max_order`.
///
/// They are computed once: at constant speed every order grows with the speed squared.
///
/// # Errors
/// As [`crate::loads`], and where a speed is not positive.
pub fn inertia_excitations(
    engine: &Engine,
    speeds: &[f64],
    max_order: u32,
) -> Result<Vec<Excitation>, MountError> {
    let request = LoadRequest { speed: Some(1.0), max_order, ..LoadRequest::default() };
    let unit = Mechanism::new(engine, &request)?.orders();
    if let Some(&bad) = speeds.iter().find(|s| !(**s > 0.0 && **s <= 1e60)) {
        return Err(MountError::Number {
            quantity: "speed [rad/s]".to_owned(),
            needed: "positive and at most 1e60",
            got: bad,
        });
    }
    let scaled = |speed: f64, o: &OrderLoads| {
        let factor = speed * speed;
        OrderLoads {
            order: o.order,
            force_forward: factor * o.force_forward,
            force_backward: factor * o.force_backward,
            couple_forward: factor * o.couple_forward,
            couple_backward: factor * o.couple_backward,
            roll_moment: factor * o.roll_moment,
            shaft_torque: factor * o.shaft_torque,
        }
    };
    let at = |&speed: &f64| Excitation { speed, orders: unit.iter().map(|o| scaled(speed, o)).collect() };
    Ok(speeds.iter().map(at).collect())
}

/// Force and moment about `centre` as complex amplitudes (book, eq. 27.9).
///
/// ```text
/// F_x = Re( ( f_n + conj f_-n ) e^{i n theta} )      F_y = Re( -i ( f_n - conj f_-n ) e^{i n theta} )
/// ```
/// the couple alike.
pub(crate) fn amplitudes(load: &OrderLoads, centre: [f64; 3]) -> Vector6<Complex64> {
    let plane = |forward: Complex64, backward: Complex64| {
        let back = backward.conj();
        [forward + back, (forward - back) * -Complex64::I]
    };
    let [fx, fy] = plane(load.force_forward, load.force_backward);
    let [mx, my] = plane(load.couple_forward, load.couple_backward);
    let force = Vector3::new(fx, fy, Complex64::ZERO);
    let lever = Vector3::from(centre).map(Complex64::from);
    let moment = Vector3::new(mx, my, load.roll_moment) - lever.cross(&force);
    Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
