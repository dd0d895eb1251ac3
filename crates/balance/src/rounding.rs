//! Orders that are rounding: what is left of loads that cancel.
//!
//! An order is a sum over masses, each known to some digits of its own. Where they cancel, what is left below
//!
//! ```text
//! 1e-13 SUM |L_n|  +  1e-15 max over m of SUM |L_m|        L_n: load of order n of a single mass
//! ```
//! is rounding of the sum and no load: an in-line four has no first order, not one of 1e-12 N. It is set to 0. Orders that
//! are left by loads which do not cancel keep all their digits, however small they are beside those that did.

use crate::error::BalanceError;
use lanchester_mechanism::{LoadRequest, Mechanism, Selection};
use lanchester_model::{Engine, Ratio};
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// Share of its own masses' loads below which a load of one order is rounding.
const CANCELLED: f64 = 1e-13;

/// Share of the masses' loads of any order below which a load is rounding: that of a quadrature.
const LOST: f64 = 1e-15;

/// Amounts of one order: force and couple in either sense, roll moment, torque.
type Amounts = [f64; 6];

/// Sets to 0 what is rounding in the `orders` of an engine at its highest speed.
///
/// # Errors
/// As [`Mechanism::of`].
pub(crate) fn clear_rounding(
    engine: &Engine,
    request: &LoadRequest,
    orders: &mut [OrderLoads],
) -> Result<(), BalanceError> {
    let mut single = vec![[0.0; 6]; orders.len()];
    for cylinder in 0..engine.cylinders.len() {
        let own = Mechanism::of(engine, request, Selection::Cylinder(cylinder))?.orders();
        single.iter_mut().zip(&own).for_each(|(sum, order)| add(sum, amounts(order)));
    }
    for (ratio, [x, y, z], unbalance) in turning(engine) {
        let order = ratio.value().abs();
        let Some(place) = orders.iter().position(|o| (o.order - order).abs() < 1e-9) else { continue };
        let force = unbalance.abs() * (order * engine.speed.highest).powi(2);
        let couple = z.abs() * force;
        add(&mut single[place], [force, force, couple, couple, x.hypot(y) * force, 0.0]);
    }
    // The torque may cancel in the roll moment of its own cylinder.
    single.iter_mut().for_each(|amounts| amounts[4] += amounts[5]);
    let largest =
        single.iter().fold([0.0; 6], |largest: Amounts, one| std::array::from_fn(|m| largest[m].max(one[m])));
    for (order, single) in orders.iter_mut().zip(&single) {
        let own = amounts(order);
        let components = [
            &mut order.force_forward,
            &mut order.force_backward,
            &mut order.couple_forward,
            &mut order.couple_backward,
            &mut order.roll_moment,
            &mut order.shaft_torque,
        ];
        for (m, component) in components.into_iter().enumerate() {
            if own[m] <= CANCELLED * single[m] + LOST * largest[m] {
                *component = Complex64::ZERO;
            }
        }
    }
    Ok(())
}

/// Everything that turns at a constant rate and is no cylinder's: speed ratio, place [m], unbalance [kg m].
fn turning(engine: &Engine) -> impl Iterator<Item = (Ratio, [f64; 3], f64)> + '_ {
    let crankshaft = |index: usize, z: f64, unbalance: f64| {
        let own = &engine.crankshafts[index];
        (own.ratio, [own.x, own.y, z], unbalance)
    };
    let throws =
        engine.throws.iter().map(move |t| crankshaft(t.crankshaft, t.unbalance_plane(), t.unbalance));
    let weights = engine.counterweights.iter().map(move |w| crankshaft(w.crankshaft, w.z, w.unbalance));
    let shafts =
        engine.shafts.iter().flat_map(|s| s.weights.iter().map(|w| (s.ratio, [s.x, s.y, w.z], w.unbalance)));
    throws.chain(weights).chain(shafts)
}

fn add(sum: &mut Amounts, one: Amounts) {
    sum.iter_mut().zip(one).for_each(|(sum, one)| *sum += one);
}

fn amounts(order: &OrderLoads) -> Amounts {
    [
        order.force_forward.norm(),
        order.force_backward.norm(),
        order.couple_forward.norm(),
        order.couple_backward.norm(),
        order.roll_moment.norm(),
        order.shaft_torque.norm(),
    ]
}
