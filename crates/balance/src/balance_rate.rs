//! Balance rate bay by bay: the share of what turns between two neighbouring main bearings that the webs there answer.
//!
//! A bay is held by its two mains as by a lever (book, eq. 13.2); in the shaft's own frame what turns there, throws and rods' big
//! ends, loads them with `A` and `B`, the counterweights of the bay with `A'` and `B'`:
//!
//! ```text
//! A = SUM of share_a U_k      B = SUM of share_b U_k      U_k = amount e^{i angle}                  (13.3)
//! rate = - Re( conj(A) A' + conj(B) B' ) / ( |A|^2 + |B|^2 )                                        (13.4)
//! ```
//! the factor of the rotating parts that comes nearest to what the counterweights take off the two mains. For one throw in the
//! middle of its bay it is the counterweights' unbalance opposite the throw over the rotating unbalance.

use lanchester_mechanism::{Beam, BeamModel};
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;

/// Share of the rotating unbalance of a bay up to which what reaches its mains is rounding.
const NOTHING: f64 = 1e-9;

/// Balance rate of one bay.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BalanceRate {
    /// Number of the crankshaft, from 1.
    pub crankshaft: usize,
    /// Number of the bay from the free end, from 1: between the mains of this number and the next.
    pub bay: usize,
    /// Planes of the two mains [m], from the origin.
    pub between: [f64; 2],
    /// Share of the rotating unbalance that the counterweights of the bay answer [1]: 1 for all of it, negative where they add to it.
    pub rate: f64,
}

/// Balance rates of all bays of all crankshafts, each from the free end on. A bay in which nothing turns that reaches its mains has
/// none; weights beyond the end mains, on flywheel or pulley, are in no bay.
///
/// # Example
/// ```
/// use lanchester_balance::balance_rates;
///
/// let template = lanchester_file::template("in-line-4").expect("it is in the gallery");
/// let engine = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
/// // Its webs take 80 % of the rotating masses.
/// assert!(balance_rates(&engine).iter().all(|bay| (bay.rate - 0.8).abs() < 1e-12));
/// ```
pub fn balance_rates(engine: &Engine) -> Vec<BalanceRate> {
    (0..engine.crankshafts.len()).flat_map(|index| of_crankshaft(engine, index)).collect()
}

fn of_crankshaft(engine: &Engine, index: usize) -> Vec<BalanceRate> {
    let mains = engine.main_planes(index);
    let Some(beam) = Beam::new(&mains, BeamModel::ThrowByThrow) else { return Vec::new() };
    let throws = engine.throws.iter().filter(|throw| throw.crankshaft == index);
    let own = throws
        .map(|throw| (throw.unbalance_plane(), Complex64::from_polar(1.0, throw.angle) * throw.unbalance));
    let rods = engine.cylinders.iter().filter_map(|cylinder| {
        let throw = engine.throws.get(cylinder.throw).filter(|throw| throw.crankshaft == index)?;
        Some((cylinder.z, Complex64::from_polar(cylinder.rod.big_end_mass * throw.radius, throw.angle)))
    });
    let rotating: Vec<(f64, Complex64)> = own.chain(rods).collect();
    let weights = engine.counterweights.iter().filter(|weight| weight.crankshaft == index);
    let weights: Vec<(f64, Complex64)> =
        weights.map(|weight| (weight.z, Complex64::from_polar(weight.unbalance, weight.angle))).collect();
    let bays = mains.windows(2).enumerate().filter_map(|(bay, pair)| {
        let between = [pair[0], pair[1]];
        let turning = Held::of(&beam, between, &rotating);
        let answer = Held::of(&beam, between, &weights);
        let square = turning.along(&turning);
        (square.sqrt() > NOTHING * turning.amount).then(|| BalanceRate {
            crankshaft: index + 1,
            bay: bay + 1,
            between,
            rate: -turning.along(&answer) / square,
        })
    });
    bays.collect()
}

/// What of some loads in a bay its two mains hold.
struct Held {
    shares: [Complex64; 2],
    /// Sum of the sizes of the loads.
    amount: f64,
}

impl Held {
    fn of(beam: &Beam, [front, rear]: [f64; 2], loads: &[(f64, Complex64)]) -> Held {
        let mut held = Held { shares: [Complex64::ZERO; 2], amount: 0.0 };
        for (z, load) in loads.iter().filter(|(z, _)| *z > front && *z < rear) {
            for (sum, (_, share)) in held.shares.iter_mut().zip(beam.shares(*z)) {
                *sum += share * load;
            }
            held.amount += load.norm();
        }
        held
    }

    fn along(&self, other: &Held) -> f64 {
        self.shares.iter().zip(&other.shares).map(|(own, other)| (own.conj() * other).re).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lanchester_file::{read, template};
    use lanchester_model::Counterweight;
    use std::f64::consts::PI;

    fn gallery(name: &str) -> Engine {
        read(template(name).unwrap().text).engine().unwrap()
    }

    fn rates(engine: &Engine) -> Vec<f64> {
        balance_rates(engine).iter().map(|bay| bay.rate).collect()
    }

    /// Rounding of sums of a few products.
    fn assert_rates(engine: &Engine, expected: &[f64]) {
        let rates = rates(engine);
        assert_eq!(rates.len(), expected.len(), "{rates:?}");
        assert!(rates.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{rates:?} {expected:?}");
    }

    #[test]
    fn the_rate_is_the_rotating_share_of_the_file() {
        assert_rates(&gallery("in-line-4"), &[0.8; 4]);
        assert_rates(&gallery("in-line-6"), &[0.7; 6]);
    }

    #[test]
    fn an_engine_without_counterweights_has_none() {
        let engine = gallery("in-line-4").without_counterweights();
        assert_rates(&engine, &[0.0; 4]);
    }

    #[test]
    fn a_weight_across_the_throw_answers_nothing() {
        let mut engine = gallery("in-line-4");
        engine = engine
            .with(|engine| {
                engine.counterweights.iter_mut().for_each(|weight| weight.angle += PI / 2.0);
            })
            .expect("an engine");
        assert_rates(&engine, &[0.0; 4]);
    }

    #[test]
    fn two_opposed_throws_in_a_bay_are_answered_throw_by_throw() {
        // A four on three mains: nothing of a bay's force is left, only its couple, and the webs answer four fifths of that.
        let mut engine = gallery("in-line-4");
        let planes = engine.main_planes(0);
        engine = engine
            .with(|engine| {
                engine.crankshafts[0].mains = Some(vec![planes[0], planes[2], planes[4]]);
            })
            .expect("an engine");
        assert_rates(&engine, &[0.8; 2]);
    }

    #[test]
    fn a_weight_beyond_the_end_mains_is_in_no_bay() {
        let mut engine = gallery("in-line-4");
        let end = engine.main_planes(0)[4];
        engine = engine
            .with(|engine| {
                engine.counterweights.push(Counterweight {
                    name: "flywheel".to_string(),
                    crankshaft: 0,
                    z: end + 0.05,
                    unbalance: 0.01,
                    angle: 0.0,
                    part: None,
                });
            })
            .expect("an engine");
        assert_rates(&engine, &[0.8; 4]);
    }

    #[test]
    fn split_pins_are_answered_where_their_sum_is() {
        // Whatever the angle between its pins: weights that leave nothing on the two mains answer all.
        let engine = gallery("v6-90");
        let mut answered = engine.without_counterweights();
        for (number, throw) in engine.throws.iter().enumerate() {
            for (z, unbalance) in std::iter::once((throw.unbalance_plane(), throw.unbalance)).chain(
                engine
                    .cylinders
                    .iter()
                    .filter(|cylinder| cylinder.throw == number)
                    .map(|cylinder| (cylinder.z, cylinder.rod.big_end_mass * throw.radius)),
            ) {
                answered = answered
                    .with(|answered| {
                        answered.counterweights.push(Counterweight {
                            name: format!("answer {}", answered.counterweights.len()),
                            crankshaft: 0,
                            z,
                            unbalance,
                            angle: throw.angle + PI,
                            part: None,
                        });
                    })
                    .expect("an engine");
            }
        }
        assert_rates(&answered, &vec![1.0; engine.main_planes(0).len() - 1]);
    }
}
