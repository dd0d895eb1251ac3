//! The matrix method of the tool paper: equal counterweights on chosen webs, a pair of shafts an order.
//!
//! Matrix-based crankshaft balancing tool, Applied Sciences 2021, 11, 8997. Its equations as they are used here:
//!
//! | printed | used | why |
//! |---|---|---|
//! | Eq 1-5 | `CS` = direction and plane of each throw, `Y_cw` the web pattern | of the engine itself |
//! | Eq 6-8 | columns `2 N_fo - 1`, `2 N_fo`; direction of the throw `-+ alpha`, plus 180 deg | printed columns do not follow the firing order |
//! | Eq 10, 11 | throws **plus** counterweights are 0 | as printed `m_c < 0` |
//! | Eq 10, 11 | the pair (forces or moments) with a resultant, both of its equations at once | the printed rule takes one of four |
//! | Eq 12, 14 | third row of the counter-rotating shaft `+` | with `-` the pair has no force along the cylinders |
//! | Eq 13, 20 | planes `-+ l_sh / 2` | `l_sh` is the whole length (Eq 13) |
//! | Eq 15, 16 | each sense for itself, `m_alt / 2` at the crank radius | the same for in-line engines, and right for V engines |
//! | Eq 17 | `m_c (m_alt / 2) / m_rot` | the printed one converts by the wrong radius |
//! | Eq 18-23 | fictitious masses `m_alt Lambda / 8`, factor 4 in forces and moments, own radius | factor and radius are missing in places; the cosine of Eq 21 |
//!
//! One mass for all counterweights and four equations: what is left over is always given, for the whole crank.

use crate::basis::Basis;
use crate::matrices::MethodMatrices;
use crate::remark::Remark;
use crate::resultant::{
    EngineResidual, Motion, OrderResultant, Resultant, Scale, piston_resultant, reciprocating, riders,
    throw_resultant,
};
use crate::shaft_pair::{ShaftOrder, ShaftPair};
use lanchester_balance::BalanceError;
use lanchester_model::{Counterweight, Engine, RodJoint};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::PI;

const METHOD: &str = "the matrix method";

/// What the user of the tool chooses.
#[derive(Debug, Clone, PartialEq)]
pub struct MatrixMethod {
    /// `Y_cw`: which webs carry a counterweight, two a throw, from the free end; all of them if empty.
    pub web_pattern: Vec<bool>,
    /// Counterweight offset angle.
    pub alpha: Alpha,
    /// `r_c`: distance of a counterweight's centre of gravity from the crank axis [m].
    pub counterweight_radius: f64,
    /// First-order shafts, if any.
    pub first: Option<ShaftPair>,
    /// Second-order shafts, if any.
    pub second: Option<ShaftPair>,
    /// Section 3.2: no first-order shaft that turns with the crank, its share goes on the counterweights.
    pub first_on_crank: bool,
}

/// `alpha`: a counterweight stands opposite its throw, turned back by alpha in the front half, forth in the rear half.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Alpha {
    /// As given [rad].
    Given(f64),
    /// The one with the smallest left-over.
    Fitted,
}

/// One of the four equations of equilibrium, Eq 10, for the whole crank at `theta = 0`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Equilibrium {
    /// Which.
    pub name: &'static str,
    /// Sum over the throws [kg m] or [kg m^2].
    pub throws: f64,
    /// Sum over the counterweights, for a mass of 1 kg each.
    pub counterweights_each_kg: f64,
    /// The mass [kg] that this equation alone asks for, Eq 11; none where there is nothing to balance or no lever.
    pub mass_alone: Option<f64>,
    /// What is left with the mass found.
    pub left: f64,
}

/// What the method finds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MatrixBalance {
    /// The geometry matrices.
    pub matrices: MethodMatrices,
    /// `alpha` [rad].
    pub alpha: f64,
    /// What the counterweights are sized for.
    pub basis: Basis,
    /// `m_c`: mass of each counterweight for the rotating masses [kg]; negative: it belongs on the side of its pin.
    pub counterweight_mass: f64,
    /// `m_c1,cs`, Eq 17: what each counterweight takes besides in place of the first-order shaft that turns with the
    /// crank [kg].
    pub counterweight_extra: f64,
    /// The four equations of equilibrium of the rotating masses, whole crank.
    pub equations: [Equilibrium; 4],
    /// First order, if shafts were asked for.
    pub first: Option<ShaftOrder>,
    /// Second order, if shafts were asked for.
    pub second: Option<ShaftOrder>,
    /// The engine with these devices alone.
    #[serde(skip)]
    pub engine: Engine,
    /// What that engine leaves over, with the exact motion.
    pub residual: EngineResidual,
    /// What to know about it.
    pub remarks: Vec<Remark>,
}

/// A web along the crank.
struct Web {
    /// Place of its throw along the crank.
    throw: usize,
    z: f64,
    /// Direction of the throw [rad].
    direction: f64,
    /// -1 in the front half, 1 in the rear half: sign of alpha.
    side: f64,
    weighted: bool,
}

impl Web {
    /// Direction of its counterweight [rad].
    fn weight_direction(&self, alpha: f64) -> f64 {
        self.direction + self.side * alpha + PI
    }
}

/// Unbalances to be opposed, throw by throw along the crank, and the webs that can.
struct Crank<'a> {
    webs: &'a [Web],
    throws: Vec<Resultant>,
    scale: Scale,
}

/// A part of the crank with the component that is balanced.
struct Target {
    basis: Basis,
    value: Complex64,
    /// Throws that count, from the front.
    throws: usize,
}

impl Crank<'_> {
    fn target(&self) -> Target {
        let whole: Resultant = self.throws.iter().copied().sum();
        let half: Resultant = self.throws[..self.throws.len() / 2].iter().copied().sum();
        let all = self.throws.len();
        let candidates = [
            (Basis::Force, whole.force, self.scale.force, all),
            (Basis::Couple, whole.moment, self.scale.moment, all),
            (Basis::HalfForce, half.force, self.scale.force, all / 2),
            (Basis::HalfCouple, half.moment, self.scale.moment, all / 2),
        ];
        let found = candidates.into_iter().find(|(_, value, rounding, _)| value.norm() > *rounding);
        match found {
            Some((basis, value, _, throws)) => Target { basis, value, throws },
            None => Target { basis: Basis::Nothing, value: Complex64::ZERO, throws: 0 },
        }
    }

    /// Sums over the weighted webs, front half and rear half, of unit weights in the direction of their throws.
    fn webs_sum(&self, throws: usize, lever: impl Fn(&Web) -> f64) -> (Complex64, Complex64) {
        let half = |side: f64| {
            let webs = self.webs.iter().filter(|w| w.weighted && w.throw < throws && w.side == side);
            webs.map(|w| lever(w) * Complex64::cis(w.direction)).sum()
        };
        (half(-1.0), half(1.0))
    }

    /// The turn alpha with the smallest left-over.
    ///
    /// With `p = u e^{i alpha}` the left-over `T - conj(p) W_front - p W_rear` is linear in the two parts of `p`. Where a
    /// whole line of them is as good (a force or couple needs but one amount), the one that leaves the least of the
    /// other component of the whole crank.
    fn best_alpha(&self) -> f64 {
        let target = self.target();
        let couple = matches!(target.basis, Basis::Couple | Basis::HalfCouple);
        let [c1, c2] = columns(self.webs_sum(target.throws, |w| if couple { w.z } else { 1.0 }));
        let (g11, g12, g22) = (dot(c1, c1), dot(c1, c2), dot(c2, c2));
        let (h1, h2) = (dot(c1, target.value), dot(c2, target.value));
        let (determinant, trace) = (g11 * g22 - g12 * g12, g11 + g22);
        if trace <= 0.0 {
            return 0.0;
        }
        if determinant > 1e-9 * trace * trace {
            return (g11 * h2 - g12 * h1).atan2(g22 * h1 - g12 * h2);
        }
        let lightest = [h1 / trace, h2 / trace];
        let line = if g11 > g22 { [-g12, g11] } else { [g22, -g12] };
        let [o1, o2] = columns(self.webs_sum(self.throws.len(), |w| if couple { 1.0 } else { w.z }));
        let whole: Resultant = self.throws.iter().copied().sum();
        let other = if couple { whole.force } else { whole.moment };
        let left = other - lightest[0] * o1 - lightest[1] * o2;
        let step = line[0] * o1 + line[1] * o2;
        let t = if step.norm() > 1e-9 * trace { dot(step, left) / step.norm_sqr() } else { 0.0 };
        (lightest[1] + t * line[1]).atan2(lightest[0] + t * line[0])
    }

    /// Unbalance of each weight [kg m] that takes away the most of the target, Eq 10 and 11.
    fn unbalance(&self, alpha: f64, rounding_of_lever: f64) -> Result<(Basis, f64), BalanceError> {
        let target = self.target();
        if target.basis == Basis::Nothing {
            return Ok((Basis::Nothing, 0.0));
        }
        let couple = matches!(target.basis, Basis::Couple | Basis::HalfCouple);
        let (front, rear) = self.webs_sum(target.throws, |w| if couple { w.z } else { 1.0 });
        let weights = -(front * Complex64::cis(-alpha) + rear * Complex64::cis(alpha));
        if weights.norm() <= rounding_of_lever {
            let what = match target.basis {
                Basis::Force | Basis::HalfForce => {
                    "a web pattern whose counterweights have a resultant force"
                }
                _ => "a web pattern whose counterweights have a resultant couple",
            };
            return Err(BalanceError::Unsuited {
                method: METHOD,
                needed: what,
                got: "one whose weights cancel one another".to_owned(),
                hint: "choose other webs",
            });
        }
        Ok((target.basis, -(weights.conj() * target.value).re / weights.norm_sqr()))
    }
}

/// What the two parts of `p` multiply in `conj(p) W_front + p W_rear`.
fn columns((front, rear): (Complex64, Complex64)) -> [Complex64; 2] {
    [front + rear, Complex64::I * (rear - front)]
}

fn dot(a: Complex64, b: Complex64) -> f64 {
    a.re * b.re + a.im * b.im
}

impl MatrixMethod {
    /// Counterweights opposite their throws with `alpha` fitted, on all webs or those of `web_pattern`, no shafts.
    pub fn counterweights(web_pattern: Vec<bool>, counterweight_radius: f64) -> MatrixMethod {
        MatrixMethod {
            web_pattern,
            alpha: Alpha::Fitted,
            counterweight_radius,
            first: None,
            second: None,
            first_on_crank: false,
        }
    }

    /// Balances the bare crank of `engine`, which keeps none of its counterweights and shafts.
    ///
    /// # Errors
    /// [`BalanceError::Unsuited`] where the method does not know such an engine, [`BalanceError::Number`] for an
    /// impossible radius or length, [`BalanceError::Loads`] where a linkage cannot turn.
    pub fn fit(&self, engine: &Engine) -> Result<MatrixBalance, BalanceError> {
        self.check(engine)?;
        let order = along_crank(engine);
        let webs = self.webs(engine, &order)?;
        let scale = Scale::of(engine);
        let rotating =
            Crank { webs: &webs, throws: order.iter().map(|&t| throw_resultant(engine, t)).collect(), scale };
        let with_crank = order.iter().map(|&t| forward_of_throw(engine, t)).collect::<Result<_, _>>()?;
        let reciprocating_forward = Crank { webs: &webs, throws: with_crank, scale };
        let alpha = match self.alpha {
            Alpha::Given(alpha) => alpha,
            Alpha::Fitted if rotating.target().basis == Basis::Nothing => reciprocating_forward.best_alpha(),
            Alpha::Fitted => rotating.best_alpha(),
        };
        let lever = webs.iter().fold(0.0f64, |m, w| m.max(w.z.abs())).min(1.0);
        let (basis, unbalance) = rotating.unbalance(alpha, 1e-9 * lever)?;
        let pistons = reciprocating(engine, 1, Motion::Published)?;
        let extra = if self.first_on_crank && !pistons.forward.vanishes(&scale) {
            reciprocating_forward.unbalance(alpha, 1e-9 * lever)?.1
        } else {
            0.0
        };

        let mut fitted = bare(engine).into_parts();
        let mut matrices = MethodMatrices::default();
        for &throw in &order {
            matrices.crank.push(engine.pin_angle(throw, 0.0), engine.throws[throw].z);
        }
        for (index, web) in webs.iter().enumerate() {
            if !web.weighted {
                matrices.counterweights.push_empty();
                continue;
            }
            let direction = web.weight_direction(alpha);
            matrices.counterweights.push(direction, web.z);
            let amount = unbalance + extra;
            fitted.counterweights.push(Counterweight {
                name: format!("web {}", index + 1),
                crankshaft: 0,
                z: web.z,
                unbalance: amount.abs(),
                angle: if amount < 0.0 { direction + PI } else { direction },
                part: None,
            });
        }
        let first = self.first.map(|pair| {
            let given_up = if self.first_on_crank { Resultant::default() } else { pistons.forward };
            let wanted = OrderResultant { forward: given_up, backward: pistons.backward };
            let columns = (&mut matrices.first_forward, &mut matrices.first_backward);
            ShaftOrder { pistons, ..pair.fit(1, wanted, &scale, &mut fitted, columns) }
        });
        let second = match self.second {
            None => None,
            Some(pair) => {
                let pistons = reciprocating(engine, 2, Motion::Published)?;
                let columns = (&mut matrices.second_forward, &mut matrices.second_backward);
                Some(pair.fit(2, pistons, &scale, &mut fitted, columns))
            }
        };
        let fitted = Engine::new(fitted).map_err(BalanceError::engine)?;
        let residual = EngineResidual::of(&fitted)?;
        let mut balance = MatrixBalance {
            equations: equations(&rotating, &webs, alpha, unbalance, self.counterweight_radius),
            matrices,
            alpha,
            basis,
            counterweight_mass: unbalance / self.counterweight_radius,
            counterweight_extra: extra / self.counterweight_radius,
            first,
            second,
            engine: fitted,
            residual,
            remarks: Vec::new(),
        };
        balance.remarks = balance.remarks(&pistons, &scale);
        Ok(balance)
    }

    fn check(&self, engine: &Engine) -> Result<(), BalanceError> {
        let unsuited =
            |needed, got: String, hint| Err(BalanceError::Unsuited { method: METHOD, needed, got, hint });
        if engine.crankshafts.len() != 1 {
            return unsuited(
                "one crankshaft",
                engine.crankshafts.len().to_string(),
                "balance each for itself",
            );
        }
        let mut banks: Vec<Complex64> = Vec::new();
        for cylinder in &engine.cylinders {
            let axis = Complex64::cis(cylinder.angle);
            if banks.iter().all(|b| (b - axis).norm() > 1e-9) {
                banks.push(axis);
            }
        }
        if banks.len() > 2 {
            let got = format!("{} directions of cylinders", banks.len());
            return unsuited("an in-line or V engine", got, "ask for the optimum instead");
        }
        if engine.cylinders.iter().any(|c| matches!(c.rod.joint, RodJoint::Articulated { .. })) {
            let got = "an articulated rod".to_owned();
            return unsuited("plain connecting rods", got, "ask for the optimum instead");
        }
        let webs = 2 * engine.throws.len();
        if !self.web_pattern.is_empty() && self.web_pattern.len() != webs {
            let got = format!("a pattern of {} for {webs} webs", self.web_pattern.len());
            return unsuited("a web pattern with two places a throw", got, "give 1 or 0 for every web");
        }
        let mut numbers = vec![("counterweight radius [m]", self.counterweight_radius)];
        for pair in [self.first, self.second].into_iter().flatten() {
            numbers.extend([("shaft weight radius [m]", pair.radius), ("shaft length [m]", pair.length)]);
        }
        for (quantity, got) in numbers {
            if !(got > 0.0 && got.is_finite()) {
                let device = METHOD.to_owned();
                return Err(BalanceError::Number { quantity, device, needed: "positive", got });
            }
        }
        Ok(())
    }

    /// Webs along the crank; without a web distance a quarter of the throw spacing either side, as in Eq 7.
    fn webs(&self, engine: &Engine, order: &[usize]) -> Result<Vec<Web>, BalanceError> {
        let planes: Vec<f64> = order.iter().map(|&t| engine.throws[t].z).collect();
        let spacing = planes.windows(2).map(|p| p[1] - p[0]).filter(|a| *a > 0.0).reduce(f64::min);
        let mut webs = Vec::with_capacity(2 * order.len());
        for (place, &throw) in order.iter().enumerate() {
            let [front, rear] = match (engine.throws[throw].webs, spacing) {
                (Some(webs), _) => webs,
                (None, Some(a)) => [planes[place] - 0.25 * a, planes[place] + 0.25 * a],
                (None, None) => {
                    return Err(BalanceError::Unsuited {
                        method: METHOD,
                        needed: "the planes of the webs",
                        got: "a single throw without them".to_owned(),
                        hint: "give crank.web_distance",
                    });
                }
            };
            let side = if 2 * (place + 1) <= order.len() { -1.0 } else { 1.0 };
            for (half, z) in [front, rear].into_iter().enumerate() {
                let weighted = self.web_pattern.get(2 * place + half).copied().unwrap_or(true);
                webs.push(Web { throw: place, z, direction: engine.pin_angle(throw, 0.0), side, weighted });
            }
        }
        Ok(webs)
    }
}

impl MatrixBalance {
    fn remarks(&self, pistons: &OrderResultant, scale: &Scale) -> Vec<Remark> {
        let mut remarks = Vec::new();
        if matches!(self.basis, Basis::HalfForce | Basis::HalfCouple) {
            remarks.push(Remark::HalfCrank);
        }
        let [across, along, moment_across, moment_along] = self.equations.map(|e| e.left);
        let (unbalance, moment) = (across.hypot(along), moment_across.hypot(moment_along));
        if unbalance > 10.0 * scale.force {
            remarks.push(Remark::StaticallyUnbalanced { unbalance });
        }
        if moment > 10.0 * scale.moment {
            remarks.push(Remark::CoupleLeft { moment });
        }
        if pistons.backward.vanishes(scale) && !pistons.forward.vanishes(scale) {
            remarks.push(Remark::FirstOrderForwardOnly);
        }
        for (order, shafts, left) in
            [(1, &self.first, &self.residual.first), (2, &self.second, &self.residual.second)]
        {
            let one_weight = shafts.as_ref().is_some_and(|s| s.basis == Basis::Force);
            let couple = shafts.as_ref().map_or(0.0, |s| s.pistons.peak().1);
            if one_weight && couple > 10.0 * scale.moment {
                remarks.push(Remark::ShaftsLeaveCouple { order, moment: left.peak().1 });
            }
        }
        remarks
    }
}

/// The engine without counterweights, shafts and task.
pub(crate) fn bare(engine: &Engine) -> Engine {
    engine.without_counterweights().without_shafts()
}

/// Throws from the free end to the flywheel, by index.
pub(crate) fn along_crank(engine: &Engine) -> Vec<usize> {
    let mut order: Vec<usize> = (0..engine.throws.len()).collect();
    order.sort_by(|&a, &b| engine.throws[a].z.total_cmp(&engine.throws[b].z));
    order
}

/// What turns with the crank of the first order of the pistons on one throw.
fn forward_of_throw(engine: &Engine, throw: usize) -> Result<Resultant, BalanceError> {
    riders(engine, throw).map(|c| Ok(piston_resultant(engine, c, 1, Motion::Published)?.forward)).sum()
}

/// The four equations of Eq 10 with their sign mended, for the whole crank.
fn equations(crank: &Crank, webs: &[Web], alpha: f64, unbalance: f64, radius: f64) -> [Equilibrium; 4] {
    let throws: Resultant = crank.throws.iter().copied().sum();
    let weights: Resultant = webs
        .iter()
        .filter(|w| w.weighted)
        .map(|w| Resultant::of(Complex64::from_polar(radius, w.weight_direction(alpha)), w.z))
        .sum();
    let mass = unbalance / radius;
    let equation = |name, throws: f64, weights: f64, rounding: f64| Equilibrium {
        name,
        throws,
        counterweights_each_kg: weights,
        mass_alone: (throws.abs() > rounding && weights.abs() > 1e-9 * radius).then(|| -throws / weights),
        left: throws + mass * weights,
    };
    let scale = &crank.scale;
    [
        equation("forces across the cylinders", throws.force.im, weights.force.im, scale.force),
        equation("forces along the cylinders", throws.force.re, weights.force.re, scale.force),
        equation("moments of the forces across", throws.moment.im, weights.moment.im, scale.moment),
        equation("moments of the forces along", throws.moment.re, weights.moment.re, scale.moment),
    ]
}
