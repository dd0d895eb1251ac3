//! The 50 % rules: counterweights for the rotating and half the reciprocating masses, shafts for the rest.
//!
//! J. Singh, Mass balancing of 3-cylinder and 4-cylinder inline engines with balancer shafts using bond graph approach,
//! ME thesis, Thapar University, 2017. Its equations as they are used here:
//!
//! | printed | used | why |
//! |---|---|---|
//! | Eq 1.10 | `m_CW r_CW = m_ro r_ro + f m_re r` | printed for `r_CW = r` |
//! | Eq 1.15 | `f = 1/2` minimises `max(f, 1 - f)` | the derivative by the crank angle says nothing about `f` |
//! | Eq 3.2 | third term `cos(2 theta - 480 deg)`, `r^2` | slips |
//! | Eq 3.7, 3.9 | `1.5 cos 2 theta - 0.866 sin 2 theta` | sign |
//! | Eq 3.15 | `B_U = sqrt(3) m_re r a / (2 b)` | as printed |
//! | Sec 3.6.1 | front weight opposite the couple's peak, 30 deg from crank 1 | printed 180 deg from crank 1: 52 % stays |
//! | Eq 3.17 | `CW_U = (m_ro r_ro + m_re r / 2) cos(30 deg) / 2` | as printed |
//! | Eq 3.18, 3.19 | not used | no conditions of equilibrium |
//! | Eq 4.8 | `4 m_re r^2 / l = 2 m_B r_B 2^2` | as printed |
//!
//! The moments are taken from the throws of the engine at hand, so that unequal spacings, either sense of the cranks and
//! unequal masses are covered; for the thesis's engines they are its closed forms.

use crate::matrix_method::{along_crank, bare};
use crate::resultant::{
    EngineResidual, Motion, OrderResultant, Resultant, all_throws, reciprocating, riders,
};
use crate::shaft_pair::shaft_name;
use lanchester_balance::BalanceError;
use lanchester_model::{BalanceShaft, Counterweight, Engine, Ratio, RodJoint, ShaftWeight};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Balance factor `f`: share of the reciprocating masses that the counterweights of a throw take.
///
/// For a single cylinder (Eq 1.11 to 1.14) the first order left is an ellipse with the half axes `1 - f` along the
/// cylinder and `f` across it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalanceFactor(pub f64);

impl BalanceFactor {
    /// The one with the smallest peak: 1/2.
    pub const BEST: BalanceFactor = BalanceFactor(0.5);

    /// Largest first-order force of a single cylinder over `m_re r w^2`: `max(|f|, |1 - f|)`.
    pub fn peak(self) -> f64 {
        self.0.abs().max((1.0 - self.0).abs())
    }

    /// Unbalance of the counterweights of a throw [kg m], Eq 1.10 with its radius: `m_ro r_ro + f m_re r`.
    ///
    /// `throw` is an index of the engine's throws.
    pub fn throw_unbalance(self, engine: &Engine, throw: usize) -> f64 {
        let pistons: f64 = riders(engine, throw).map(|c| engine.cylinders[c].reciprocating_mass()).sum();
        let own = &engine.throws[throw];
        own.unbalance + engine.rod_unbalance(throw) + self.0 * pistons * own.radius
    }

    /// The engine with one such weight opposite every throw in place of its counterweights; its shafts stay.
    pub fn fit(self, engine: &Engine) -> Engine {
        let counterweights = (0..engine.throws.len())
            .map(|index| {
                let amount = self.throw_unbalance(engine, index);
                let throw = &engine.throws[index];
                Counterweight {
                    name: format!("throw {}", index + 1),
                    crankshaft: throw.crankshaft,
                    z: throw.z,
                    unbalance: amount.abs(),
                    angle: if amount < 0.0 { throw.angle } else { throw.angle + PI },
                    part: None,
                }
            })
            .collect();
        engine
            .with(|parts| parts.counterweights = counterweights)
            .expect("invariant: amounts of a finite share are finite")
    }
}

/// Where the front weight of a three-cylinder balancer stands at top dead centre of cylinder 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BalancerPhase {
    /// So that the shaft opposes the couple where it peaks, 30 deg before or after: nothing stays.
    CouplePeak,
    /// 180 deg from crank 1, as section 3.6.1 says: leaves `2 sin 15 deg` = 52 % of what the shaft is for.
    OppositeFirstThrow,
}

/// The three-cylinder rule: half of the first-order couple on the counterweights, half on one counter-rotating shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeCylinderRule {
    /// `b`: distance of the two balance weights [m].
    pub shaft_length: f64,
    /// Axis of the shaft: x, y [m].
    pub shaft_at: [f64; 2],
    /// Where its front weight stands.
    pub phase: BalancerPhase,
}

/// What the three-cylinder rule finds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ThreeCylinderBalance {
    /// Couple of the rotating masses over `w^2` [kg m^2]: `sqrt(3) m_ro r_ro a` (Eq 3.14, Table 3.6).
    pub rotating_moment: f64,
    /// First-order couple of the reciprocating masses over `w^2` [kg m^2]: `sqrt(3) m_re r a` (Eq 3.4, Table 3.7).
    pub first_moment: f64,
    /// First crank angle where it peaks [rad], from top dead centre of cylinder 1.
    pub first_peak_angle: f64,
    /// Second-order couple over `w^2` [kg m^2]: `sqrt(3) m_re r^2 a / l` (Eq 3.9), which Table 3.8 does not list and
    /// nothing balances.
    pub second_moment: f64,
    /// `B_U`: unbalance of each balance weight [kg m] (Eq 3.15).
    pub balancer_unbalance: f64,
    /// `CW_U`: unbalance of each of the four counterweights [kg m] (Eq 3.17).
    pub counterweight_unbalance: f64,
    /// Turn of the front counterweights out of the line of their throw [rad]; the rear ones turn the other way.
    pub counterweight_turn: f64,
    /// What stays of the couple that the shaft is for, 0 to 2.
    pub share_left: f64,
    /// The engine with these devices alone.
    #[serde(skip)]
    pub engine: Engine,
    /// What that engine leaves over, with the exact motion.
    pub residual: EngineResidual,
}

impl ThreeCylinderRule {
    /// Balances `engine`, an in-line three with throws 120 deg apart, which keeps none of its devices.
    ///
    /// # Errors
    /// [`BalanceError::Unsuited`] for another engine, [`BalanceError::Number`] for an impossible shaft length.
    pub fn fit(&self, engine: &Engine) -> Result<ThreeCylinderBalance, BalanceError> {
        let order = in_line(engine, 3, "the three-cylinder rule", "throws 120 deg apart", |turns| {
            // Multiples of 120 deg from the first throw, one each.
            let near =
                |wanted: f64| turns.iter().filter(|t| (**t - Complex64::cis(wanted)).norm() < 1e-6).count();
            (0..3).all(|k| near(TAU * f64::from(k) / 3.0) == 1)
        })?;
        positive("shaft length [m]", self.shaft_length)?;
        let rotating = all_throws(engine);
        let first = reciprocating(engine, 1, Motion::Published)?;
        let second = reciprocating(engine, 2, Motion::Published)?;
        let (front, rear) = (order[0], order[2]);
        let distance = engine.throws[rear].z - engine.throws[front].z;

        let crank = rotating.moment + first.forward.moment;
        let pair = -crank / distance;
        let mut fitted = bare(engine).into_parts();
        for (throw, unbalance) in [(front, -pair), (rear, pair)] {
            let place = &engine.throws[throw];
            let webs = place.webs.unwrap_or([place.z; 2]);
            for (z, end) in webs.into_iter().zip(["front", "rear"]) {
                fitted.counterweights.push(Counterweight {
                    name: format!("throw {} {end}", throw + 1),
                    crankshaft: 0,
                    z,
                    unbalance: 0.5 * unbalance.norm(),
                    angle: unbalance.arg(),
                    part: None,
                });
            }
        }

        let wanted = -first.backward.moment / self.shaft_length;
        let front_weight = match self.phase {
            BalancerPhase::CouplePeak => -wanted,
            BalancerPhase::OppositeFirstThrow => {
                let top = engine.cylinders[riders(engine, front).next().unwrap_or(0)].angle;
                // Counter-rotating: at top dead centre of cylinder 1 crank and weight mirror each other in its axis.
                let crank = engine.pin_angle(front, 0.0);
                Complex64::from_polar(wanted.norm(), 2.0 * top - crank + PI)
            }
        };
        let half = 0.5 * self.shaft_length;
        let weight = |z: f64, u: Complex64| ShaftWeight::new(z, u.norm(), u.arg());
        fitted.shafts.push(BalanceShaft {
            name: "balancer".to_owned(),
            ratio: Ratio::whole(-1).expect("invariant: an order is not 0"),
            x: self.shaft_at[0],
            y: self.shaft_at[1],
            weights: vec![weight(-half, front_weight), weight(half, -front_weight)],
            inertia: None,
        });

        let fitted = Engine::new(fitted).map_err(BalanceError::engine)?;
        let direction = engine.pin_angle(front, 0.0) + PI;
        Ok(ThreeCylinderBalance {
            rotating_moment: rotating.moment.norm(),
            first_moment: first.peak().1,
            first_peak_angle: peak_angle(&first, engine, front),
            // An unbalance at twice crank speed: over w^2 it is four times as large.
            second_moment: 4.0 * second.peak().1,
            balancer_unbalance: wanted.norm(),
            counterweight_unbalance: 0.5 * pair.norm(),
            counterweight_turn: (-pair / Complex64::cis(direction)).arg(),
            share_left: (front_weight + wanted).norm() / wanted.norm(),
            residual: EngineResidual::of(&fitted)?,
            engine: fitted,
        })
    }
}

/// The four-cylinder rule: two shafts at twice crank speed, one in each sense, against the second-order force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourCylinderRule {
    /// Axis of the shaft that turns with the crank: x, y [m].
    pub forward_at: [f64; 2],
    /// Axis of the shaft that turns against it: x, y [m].
    pub backward_at: [f64; 2],
}

/// What the four-cylinder rule finds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FourCylinderBalance {
    /// Rotating masses of the whole crank: it balances itself where they are equal.
    pub rotating: Resultant,
    /// First order of the pistons (Eq 4.1, 4.2).
    pub first: OrderResultant,
    /// Second-order force of the pistons over `w^2` [kg m]: `4 m_re r^2 / l` (Eq 4.3).
    pub second_force: f64,
    /// Second-order couple of the pistons over `w^2` [kg m^2] (Eq 4.4).
    pub second_moment: f64,
    /// `m_B r_B`: unbalance of each shaft [kg m] (Eq 4.8).
    pub shaft_unbalance: f64,
    /// The same with the true second-order coefficient in place of `r/l` [kg m].
    pub exact_shaft_unbalance: f64,
    /// The engine with its counterweights and these shafts alone.
    #[serde(skip)]
    pub engine: Engine,
    /// What that engine leaves over, with the exact motion.
    pub residual: EngineResidual,
}

impl FourCylinderRule {
    /// Balances `engine`, an in-line four with throws at 0, 180, 180, 0 deg; its counterweights stay.
    ///
    /// # Errors
    /// [`BalanceError::Unsuited`] for another engine.
    pub fn fit(&self, engine: &Engine) -> Result<FourCylinderBalance, BalanceError> {
        in_line(engine, 4, "the four-cylinder rule", "throws at 0, 180, 180, 0 deg", |turns| {
            let signs = [1.0, -1.0, -1.0, 1.0];
            turns.iter().zip(signs).all(|(t, sign)| (t - sign).norm() < 1e-6)
        })?;
        let second = reciprocating(engine, 2, Motion::Published)?;
        let exact = reciprocating(engine, 2, Motion::Exact)?;
        let mut fitted = engine.clone().into_parts();
        fitted.shafts.clear();
        let senses = [(1, second.forward, self.forward_at), (-1, second.backward, self.backward_at)];
        for (sense, resultant, [x, y]) in senses {
            let unbalance = -resultant.force;
            fitted.shafts.push(BalanceShaft {
                name: shaft_name(2, sense),
                ratio: Ratio::whole(2 * sense).expect("invariant: an order is not 0"),
                x,
                y,
                weights: vec![ShaftWeight::new(0.0, unbalance.norm(), unbalance.arg())],
                inertia: None,
            });
        }
        // Unbalances at twice crank speed: over w^2 they are four times as large.
        let (force, moment) = second.peak();
        let fitted = Engine::new(fitted).map_err(BalanceError::engine)?;
        Ok(FourCylinderBalance {
            rotating: all_throws(engine),
            first: reciprocating(engine, 1, Motion::Published)?,
            second_force: 4.0 * force,
            second_moment: 4.0 * moment,
            shaft_unbalance: second.backward.force.norm(),
            exact_shaft_unbalance: exact.backward.force.norm(),
            residual: EngineResidual::of(&fitted)?,
            engine: fitted,
        })
    }
}

/// Crank angle from top dead centre of the front cylinder where the first-order couple peaks, in half a turn.
fn peak_angle(first: &OrderResultant, engine: &Engine, front: usize) -> f64 {
    let dead_centre = riders(engine, front).next().map_or(0.0, |c| engine.cylinders[c].angle)
        - engine.pin_angle(front, 0.0);
    let peak = 0.5 * (first.backward.moment.arg() - first.forward.moment.arg());
    (peak - dead_centre).rem_euclid(PI)
}

/// Throws from the front of an in-line engine with one cylinder a throw; `suits` sees their directions from the first.
fn in_line(
    engine: &Engine,
    cylinders: usize,
    method: &'static str,
    needed: &'static str,
    suits: impl Fn(&[Complex64]) -> bool,
) -> Result<Vec<usize>, BalanceError> {
    let unsuited = |needed, got: String| {
        Err(BalanceError::Unsuited {
            method,
            needed,
            got,
            hint: "use the matrix method, or ask for the optimum",
        })
    };
    if engine.cylinders.len() != cylinders || engine.throws.len() != cylinders {
        let got = format!("{} cylinders on {} throws", engine.cylinders.len(), engine.throws.len());
        return unsuited("one throw for each of its cylinders", got);
    }
    let axis = Complex64::cis(engine.cylinders[0].angle);
    let aligned = engine.cylinders.iter().all(|c| (Complex64::cis(c.angle) - axis).norm() < 1e-9);
    let plain = engine.cylinders.iter().all(|c| !matches!(c.rod.joint, RodJoint::Articulated { .. }));
    let own = (0..cylinders).all(|t| riders(engine, t).count() == 1);
    if !(aligned && plain && own && engine.crankshafts.len() == 1) {
        return unsuited("an in-line engine with plain rods, one a throw", "another layout".to_owned());
    }
    let order = along_crank(engine);
    let first = Complex64::cis(engine.pin_angle(order[0], 0.0));
    let turns: Vec<Complex64> =
        order.iter().map(|&t| Complex64::cis(engine.pin_angle(t, 0.0)) / first).collect();
    if !suits(&turns) {
        let degrees: Vec<String> = turns.iter().map(|t| format!("{:.1}", t.arg().to_degrees())).collect();
        return unsuited(needed, format!("{} deg", degrees.join(", ")));
    }
    Ok(order)
}

fn positive(quantity: &'static str, got: f64) -> Result<(), BalanceError> {
    if got > 0.0 && got.is_finite() {
        return Ok(());
    }
    let device = "balance shaft".to_owned();
    Err(BalanceError::Number { quantity, device, needed: "positive", got })
}
