//! Force and moment of some masses as unbalances: what a weight that turns at the same speed must oppose.
//!
//! ```text
//! F = (n w)^2 P e^{i n theta}        P = SUM U e^{i angle}          resultant of forces    [kg m]
//! M = (n w)^2 i Q e^{i n theta}      Q = SUM z U e^{i angle}        moment about z = 0     [kg m^2]
//! ```
//! A reciprocating mass is a pair of masses at the crank radius, one turning with the crank at `n w`, one against it:
//!
//! ```text
//! forward  m r c_n / (2 n^2) e^{i (n (a - b) + b)}       backward  m r conj(c_n) / (2 n^2) e^{i (-n (a - b) + b)}
//! ```
//! with `c_1 = 1` and `c_2 = r/l` as all of these sources have it (the fictitious masses `m/2` and `m Lambda / 8` of the
//! tool paper), or with the exact coefficients.

use lanchester_balance::BalanceError;
use lanchester_mechanism::exact_coefficients;
use lanchester_model::Engine;
use num_complex::Complex64;
use serde::Serialize;
use std::ops::{Add, AddAssign, Sub};

/// Resultant of forces and moment about the origin of turning masses, at `theta = 0`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Resultant {
    /// `P` [kg m].
    pub force: Complex64,
    /// `Q` [kg m^2].
    pub moment: Complex64,
}

impl Resultant {
    /// One unbalance [kg m] in the plane z [m].
    pub fn of(unbalance: Complex64, z: f64) -> Resultant {
        Resultant { force: unbalance, moment: z * unbalance }
    }

    /// Neither force nor moment beyond rounding of masses as large as `scale`.
    pub(crate) fn vanishes(&self, scale: &Scale) -> bool {
        self.force.norm() <= scale.force && self.moment.norm() <= scale.moment
    }
}

impl Add for Resultant {
    type Output = Resultant;
    fn add(self, other: Resultant) -> Resultant {
        Resultant { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

impl AddAssign for Resultant {
    fn add_assign(&mut self, other: Resultant) {
        *self = *self + other;
    }
}

impl Sub for Resultant {
    type Output = Resultant;
    fn sub(self, other: Resultant) -> Resultant {
        Resultant { force: self.force - other.force, moment: self.moment - other.moment }
    }
}

impl std::iter::Sum for Resultant {
    fn sum<I: Iterator<Item = Resultant>>(parts: I) -> Resultant {
        parts.fold(Resultant::default(), Add::add)
    }
}

/// One order of reciprocating masses: what turns with the crank and what turns against it.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct OrderResultant {
    /// Turns with the crank.
    pub forward: Resultant,
    /// Turns against it.
    pub backward: Resultant,
}

impl OrderResultant {
    /// Largest resultant of both over the cycle, force [kg m] and moment [kg m^2].
    pub fn peak(&self) -> (f64, f64) {
        (
            self.forward.force.norm() + self.backward.force.norm(),
            self.forward.moment.norm() + self.backward.moment.norm(),
        )
    }
}

/// What an engine leaves over with all its devices: the four equilibrium equations of its crank and its first two
/// orders in both senses, with the exact motion of the pistons.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EngineResidual {
    /// Throws, big ends and counterweights: force and moment of the whole crank.
    pub crank: Resultant,
    /// Everything that turns at crank speed, pistons and shafts included.
    pub first: OrderResultant,
    /// Everything that turns at twice crank speed.
    pub second: OrderResultant,
}

impl EngineResidual {
    /// Of `engine`, which has one crankshaft and plain rods.
    ///
    /// # Errors
    /// [`BalanceError::Loads`] where a linkage cannot turn.
    pub fn of(engine: &Engine) -> Result<EngineResidual, BalanceError> {
        let crank = all_throws(engine) + counterweights(engine);
        let order = |n: i32, forward: Resultant| -> Result<OrderResultant, BalanceError> {
            let pistons = reciprocating(engine, n, Motion::Exact)?;
            Ok(OrderResultant {
                forward: pistons.forward + forward + shafts(engine, n),
                backward: pistons.backward + shafts(engine, -n),
            })
        };
        Ok(EngineResidual { crank, first: order(1, crank)?, second: order(2, Resultant::default())? })
    }
}

/// Below this, a resultant is rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scale {
    /// [kg m]
    pub force: f64,
    /// [kg m^2]
    pub moment: f64,
}

impl Scale {
    /// Rounding of all masses of an engine.
    pub fn of(engine: &Engine) -> Scale {
        /// Share of the masses of an engine that counts as rounding.
        const ROUNDING: f64 = 1e-9;
        let force: f64 = (0..engine.throws.len())
            .map(|t| {
                let pistons: f64 = riders(engine, t).map(|c| engine.cylinders[c].reciprocating_mass()).sum();
                let throw = &engine.throws[t];
                throw.unbalance.abs() + engine.rod_unbalance(t) + pistons * throw.radius
            })
            .sum();
        let lever = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.z.abs()));
        let radius = engine.throws.iter().fold(0.0f64, |m, t| m.max(t.radius));
        Scale { force: ROUNDING * force, moment: ROUNDING * force * lever.max(radius) }
    }
}

/// Motion of the pistons.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Motion {
    /// `c_1 = 1`, `c_2 = r/l`.
    Published,
    /// The true coefficients.
    Exact,
}

/// Cylinders on a throw, by index.
pub(crate) fn riders(engine: &Engine, throw: usize) -> impl Iterator<Item = usize> + '_ {
    (0..engine.cylinders.len()).filter(move |&c| engine.cylinders[c].throw == throw)
}

/// Crank and big ends of one throw.
pub(crate) fn throw_resultant(engine: &Engine, index: usize) -> Resultant {
    let throw = &engine.throws[index];
    let direction = Complex64::cis(engine.pin_angle(index, 0.0));
    let big_ends = riders(engine, index).map(|c| {
        let cylinder = &engine.cylinders[c];
        Resultant::of(cylinder.rod.big_end_mass * throw.radius * direction, cylinder.z)
    });
    Resultant::of(throw.unbalance * direction, throw.unbalance_plane()) + big_ends.sum()
}

/// Crank and big ends of all throws.
pub(crate) fn all_throws(engine: &Engine) -> Resultant {
    (0..engine.throws.len()).map(|t| throw_resultant(engine, t)).sum()
}

/// Weights on the crankshaft.
pub(crate) fn counterweights(engine: &Engine) -> Resultant {
    let phase = |w: usize| engine.crankshafts[w].phase;
    let weights = engine.counterweights.iter();
    weights
        .map(|w| Resultant::of(Complex64::from_polar(w.unbalance, phase(w.crankshaft) + w.angle), w.z))
        .sum()
}

/// Weights on the shafts that turn at `order` times crank speed, signed.
fn shafts(engine: &Engine, order: i32) -> Resultant {
    let turning = engine.shafts.iter().filter(|s| s.ratio.value() == f64::from(order));
    turning
        .flat_map(|s| &s.weights)
        .map(|w| Resultant::of(Complex64::from_polar(w.unbalance, w.phase), w.z))
        .sum()
}

/// Order `n` of one piston.
pub(crate) fn piston_resultant(
    engine: &Engine,
    index: usize,
    n: i32,
    motion: Motion,
) -> Result<OrderResultant, BalanceError> {
    let cylinder = &engine.cylinders[index];
    let radius = engine.throws[cylinder.throw].radius;
    let coefficient = match (motion, n) {
        (Motion::Published, 1) => Complex64::ONE,
        (Motion::Published, 2) => Complex64::from(radius / cylinder.rod.length),
        (Motion::Published, _) => Complex64::ZERO,
        (Motion::Exact, _) => {
            let order = n.unsigned_abs();
            exact_coefficients(radius, cylinder.rod.length, cylinder.net_offset(), order)?[order as usize]
        }
    };
    let order = f64::from(n);
    let size = 0.5 * cylinder.reciprocating_mass() * radius / (order * order);
    let b = cylinder.angle;
    let turned = order * (engine.pin_angle(cylinder.throw, 0.0) - b);
    Ok(OrderResultant {
        forward: Resultant::of(size * coefficient * Complex64::cis(turned + b), cylinder.z),
        backward: Resultant::of(size * coefficient.conj() * Complex64::cis(b - turned), cylinder.z),
    })
}

/// Order `n` of all pistons.
pub(crate) fn reciprocating(engine: &Engine, n: i32, motion: Motion) -> Result<OrderResultant, BalanceError> {
    let mut sum = OrderResultant::default();
    for index in 0..engine.cylinders.len() {
        let piston = piston_resultant(engine, index, n, motion)?;
        sum.forward += piston.forward;
        sum.backward += piston.backward;
    }
    Ok(sum)
}
