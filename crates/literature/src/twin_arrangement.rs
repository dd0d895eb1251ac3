//! The nine arrangements of counterweights and balance shafts that the twin-cylinder thesis compares, for any engine
//! on one crankshaft.
//!
//! The counterweights of the crank stand opposite their throws, one a throw; shafts of order n turn at n times the
//! crank's speed. With `f_n`, `c_n` the force and couple of order n of the reciprocating parts that turn with the crank
//! (`n > 0`) or against it (`n < 0`):
//!
//! ```text
//! basic crank        U_k = m_rot r                    rotating masses balanced, throw by throw
//! raised crank       U_k = m_rot r + m_osc r / 2      and the forward half of the first order
//! optimised crank    U_k = U + (m_rot r)_k - (m_rot r)_1      U from a sweep, see `sweep`
//! shaft of order n   SUM U e^{i phase} = -f_n / (n w)^2,   SUM z U e^{i phase} = i c_n / (n w)^2
//! ```
//! A shaft has one weight where one plane within the engine will do (the plain shaft of the thesis), else two in the
//! planes of the outermost cylinders: opposed ones where the force vanishes (its double shaft).
//!
//! | shafts of order n in pairs | thesis                  | cylinder count N in phase |
//! |----------------------------|-------------------------|---------------------------|
//! | first order, each          | `r m_osc / 2` (Eq 25)   | `N r m_osc / 2`           |
//! | second order, each         | `r m_osc A2 / 8` (Eq 28)| `N r m_osc A2 / 8`        |
//!
//! # Source
//! Louvigny, Preliminary design of twin-cylinder engines (2008), sections 4.2 to 4.11.

use crate::crank_sweep::{CrankLoad, CrankSweep, SweepOptions, sweep};
use lanchester_balance::BalanceError;
use lanchester_mechanism::{Kinematics, LoadRequest, Mechanism, Part, Selection};
use lanchester_model::{BalanceShaft, Counterweight, Engine, Ratio, ShaftWeight};
use lanchester_results::OrderLoads;
use num_complex::Complex64;
use serde::Serialize;

/// Share of the engine's largest first-order load below which an order counts as balanced.
const VANISHING: f64 = 1e-9;

/// An arrangement of the twin-cylinder thesis, in its numbering.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TwinArrangement {
    /// 1: the crank balances its rotating masses.
    Basic,
    /// 2: the crank's unbalance makes the largest force or couple smallest.
    OptimisedCrank,
    /// 3: basic crank, two first-order shafts.
    TwoFirst,
    /// 4: raised crank, one first-order shaft against the crank.
    OneFirst,
    /// 5: optimised crank, two second-order shafts.
    OptimisedCrankTwoSecond,
    /// 6: raised crank, one first-order and one second-order shaft.
    OneFirstOneSecond,
    /// 7: raised crank, one first-order and two second-order shafts.
    OneFirstTwoSecond,
    /// 8: basic crank, two first-order shafts and one of second order.
    TwoFirstOneSecond,
    /// 9: basic crank, two first-order and two second-order shafts.
    TwoFirstTwoSecond,
}

/// How the counterweights of the crank are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CrankRule {
    /// They balance the rotating masses.
    Basic,
    /// They balance the rotating masses and half of the reciprocating ones, in place of a forward first-order shaft.
    Raised,
    /// They make the largest force or couple smallest.
    Optimised,
}

impl TwinArrangement {
    /// All of them in the thesis's order.
    pub const ALL: [TwinArrangement; 9] = [
        TwinArrangement::Basic,
        TwinArrangement::OptimisedCrank,
        TwinArrangement::TwoFirst,
        TwinArrangement::OneFirst,
        TwinArrangement::OptimisedCrankTwoSecond,
        TwinArrangement::OneFirstOneSecond,
        TwinArrangement::OneFirstTwoSecond,
        TwinArrangement::TwoFirstOneSecond,
        TwinArrangement::TwoFirstTwoSecond,
    ];

    /// The arrangement of this number in the thesis, 1 to 9.
    pub fn from_number(number: usize) -> Option<TwinArrangement> {
        TwinArrangement::ALL.get(number.checked_sub(1)?).copied()
    }

    /// Its number in the thesis: 1 to 9.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            TwinArrangement::Basic => "basic crank",
            TwinArrangement::OptimisedCrank => "optimised crank",
            TwinArrangement::TwoFirst => "two first-order shafts",
            TwinArrangement::OneFirst => "one first-order shaft",
            TwinArrangement::OptimisedCrankTwoSecond => "optimised crank, two second-order shafts",
            TwinArrangement::OneFirstOneSecond => "one first-order and one second-order shaft",
            TwinArrangement::OneFirstTwoSecond => "one first-order and two second-order shafts",
            TwinArrangement::TwoFirstOneSecond => "two first-order shafts and one second-order shaft",
            TwinArrangement::TwoFirstTwoSecond => "two first-order and two second-order shafts",
        }
    }

    /// How its crank is balanced.
    pub fn crank(self) -> CrankRule {
        match (self, self.first_order_shafts()) {
            (TwinArrangement::OptimisedCrank | TwinArrangement::OptimisedCrankTwoSecond, _) => {
                CrankRule::Optimised
            }
            (_, 1) => CrankRule::Raised,
            _ => CrankRule::Basic,
        }
    }

    /// How many shafts turn at the crank's speed: a single one turns against it.
    pub fn first_order_shafts(self) -> usize {
        match self {
            TwinArrangement::Basic
            | TwinArrangement::OptimisedCrank
            | TwinArrangement::OptimisedCrankTwoSecond => 0,
            TwinArrangement::OneFirst
            | TwinArrangement::OneFirstOneSecond
            | TwinArrangement::OneFirstTwoSecond => 1,
            TwinArrangement::TwoFirst
            | TwinArrangement::TwoFirstOneSecond
            | TwinArrangement::TwoFirstTwoSecond => 2,
        }
    }

    /// How many shafts turn at twice the crank's speed: a single one turns with it.
    pub fn second_order_shafts(self) -> usize {
        match self {
            TwinArrangement::Basic
            | TwinArrangement::OptimisedCrank
            | TwinArrangement::TwoFirst
            | TwinArrangement::OneFirst => 0,
            TwinArrangement::OneFirstOneSecond | TwinArrangement::TwoFirstOneSecond => 1,
            TwinArrangement::OptimisedCrankTwoSecond
            | TwinArrangement::OneFirstTwoSecond
            | TwinArrangement::TwoFirstTwoSecond => 2,
        }
    }
}

/// Where the shafts stand and what the devices are sized with.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrangementOptions {
    /// Axis (x, y) of the first first-order shaft [m], the one against the crank; the second stands at (x, -y).
    pub first_order_axis: [f64; 2],
    /// Axis (x, y) of the first second-order shaft [m], the one with the crank; the second stands at (x, -y).
    pub second_order_axis: [f64; 2],
    /// Motion that the orders are taken from.
    pub kinematics: Kinematics,
    /// How the optimised crank is swept.
    pub sweep: SweepOptions,
    /// Amounts that are given rather than found.
    pub given: GivenAmounts,
}

/// Amounts that stand in the place of found ones: the rounded numbers of a drawing, or of a table.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GivenAmounts {
    /// Counterweight of throw 1 [kg m].
    pub crank: Option<f64>,
    /// Every weight of the first-order shafts [kg m].
    pub first_order: Option<f64>,
    /// Every weight of the second-order shafts [kg m].
    pub second_order: Option<f64>,
}

impl Default for ArrangementOptions {
    /// Exact motion; all shafts beside the crank at y = +-100 mm, as the thesis computes them (it draws the
    /// second-order ones 100 mm above).
    fn default() -> Self {
        ArrangementOptions {
            first_order_axis: [0.0, 0.1],
            second_order_axis: [0.0, 0.1],
            kinematics: Kinematics::Exact,
            sweep: SweepOptions::default(),
            given: GivenAmounts::default(),
        }
    }
}

impl ArrangementOptions {
    /// As the thesis: orders 1, 2 and 4 with powers of the rod ratio up to 5, a sweep in steps of 1e-5 kg m on a
    /// 1-degree grid.
    pub fn of_thesis() -> Self {
        let kinematics = Kinematics::PowerSeries { max_order: 4, max_power: 5 };
        ArrangementOptions { kinematics, ..ArrangementOptions::default() }
    }

    fn request(&self) -> LoadRequest {
        LoadRequest { kinematics: self.kinematics, max_order: 2, ..LoadRequest::default() }
    }
}

/// `engine` with the counterweights and shafts of `arrangement` in the place of its own.
///
/// A shaft whose order needs no balancing is left out, and a crank without a first order to answer stays basic: an
/// in-line four with two first-order shafts is the plain in-line four. Couples are balanced about the origin.
///
/// # Errors
/// [`BalanceError::Loads`] where the engine's loads cannot be computed; [`BalanceError::Missing`] for an engine with
/// several crankshafts, or an optimised crank where the crank can change nothing; [`BalanceError::Number`] for given
/// amounts or sweep options that are not possible.
///
/// # Example
/// ```
/// use lanchester_literature::{ArrangementOptions, TwinArrangement, arranged};
/// let template = lanchester_file::template("twin-360").expect("it is in the gallery");
/// let twin = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
/// let balanced = arranged(&twin, TwinArrangement::TwoFirst, &ArrangementOptions::default())?;
/// assert_eq!(balanced.shafts.len(), 2);
/// # Ok::<(), lanchester_balance::BalanceError>(())
/// ```
pub fn arranged(
    engine: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Result<Engine, BalanceError> {
    let with_shafts = shafts_fitted(engine, arrangement, options)?;
    let crank = match (options.given.crank, arrangement.crank()) {
        (Some(amount), _) => {
            let amount = checked("unbalance of the crank", amount)?;
            even_crank(engine, amount)
        }
        (None, rule) => match (rule, crank_load(engine, options)?) {
            (CrankRule::Basic, _) | (_, None) => basic_crank(engine),
            (CrankRule::Raised, Some(_)) => raised_crank(engine, options)?,
            (CrankRule::Optimised, Some(load)) => {
                let swept = sweep(&with_shafts, load, options.kinematics, &options.sweep)?;
                even_crank(engine, swept.best().unbalance)
            }
        },
    };
    Ok(with_crank(&with_shafts, &crank))
}

/// `engine` with these counterweights, one complex amount along each throw, in the place of its own.
fn with_crank(engine: &Engine, crank: &[Complex64]) -> Engine {
    let counterweights =
        crank.iter().enumerate().map(|(k, &unbalance)| weight(engine, k, unbalance)).collect();
    engine
        .with(|parts| parts.counterweights = counterweights)
        .expect("invariant: weights along the throws have finite amounts and names of their own")
}

/// `engine` with a counterweight of this unbalance [kg m] opposite throw 1 in the place of its own, and as much more or
/// less than the rotating masses opposite every other throw: the crank of one step of a sweep. Shafts stay.
pub fn with_even_crank(engine: &Engine, unbalance: f64) -> Engine {
    with_crank(engine, &even_crank(engine, unbalance))
}

/// The sweep behind the crank of an arrangement: the criterion over the unbalance of the crank, with the arrangement's
/// shafts fitted. `None` where the arrangement has no optimised crank, or the crank has nothing to do.
///
/// # Errors
/// As [`arranged`].
pub fn swept_crank(
    engine: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Result<Option<CrankSweep>, BalanceError> {
    if arrangement.crank() != CrankRule::Optimised {
        return Ok(None);
    }
    let Some(load) = crank_load(engine, options)? else { return Ok(None) };
    let with_shafts = shafts_fitted(engine, arrangement, options)?;
    sweep(&with_shafts, load, options.kinematics, &options.sweep).map(Some)
}

/// Which load the crank's unbalance is chosen for, by the thesis's rule: the force where the reciprocating parts have a
/// first-order force, else the couple where they have a first-order couple, else none.
///
/// # Errors
/// As [`arranged`].
pub fn crank_load(engine: &Engine, options: &ArrangementOptions) -> Result<Option<CrankLoad>, BalanceError> {
    let orders = Reciprocating::of(engine, options)?;
    let first = &orders.orders[1];
    // Only what turns with the crank can be answered by it.
    Ok(if first.force_forward.norm() > orders.negligible_force {
        Some(CrankLoad::Force)
    } else if first.couple_forward.norm() > orders.negligible_couple {
        Some(CrankLoad::Couple)
    } else {
        None
    })
}

/// The engine without counterweights, with the arrangement's shafts.
fn shafts_fitted(
    engine: &Engine,
    arrangement: TwinArrangement,
    options: &ArrangementOptions,
) -> Result<Engine, BalanceError> {
    if engine.crankshafts.len() != 1 {
        return Err(BalanceError::Missing {
            criterion: "an arrangement of the twin-cylinder thesis".to_string(),
            needed: "an engine with one crankshaft",
            hint: "name weights and shafts of a geared engine one by one",
        });
    }
    let orders = Reciprocating::of(engine, options)?;
    let GivenAmounts { first_order, second_order, .. } = options.given;
    let first = ["first order against the crank", "first order with the crank"];
    let second = ["second order with the crank", "second order against the crank"];
    let mut shafts = Vec::new();
    for (k, name) in first.into_iter().take(arrangement.first_order_shafts()).enumerate() {
        let [x, y] = options.first_order_axis;
        let (ratio, at) = if k == 0 { (-1, [x, y]) } else { (1, [x, -y]) };
        shafts.extend(orders.shaft(name, ratio, at, first_order)?);
    }
    for (k, name) in second.into_iter().take(arrangement.second_order_shafts()).enumerate() {
        let [x, y] = options.second_order_axis;
        let (ratio, at) = if k == 0 { (2, [x, y]) } else { (-2, [x, -y]) };
        shafts.extend(orders.shaft(name, ratio, at, second_order)?);
    }
    engine.without_counterweights().with(|parts| parts.shafts = shafts).map_err(BalanceError::engine)
}

/// Counterweights, opposite their throws, that balance the rotating masses: one complex amount along each throw.
fn basic_crank(engine: &Engine) -> Vec<Complex64> {
    (0..engine.throws.len()).map(|k| engine.rotating_unbalance(k).into()).collect()
}

/// Counterweights of this amount on throw 1, and as much more or less than the rotating masses on every other throw.
fn even_crank(engine: &Engine, amount: f64) -> Vec<Complex64> {
    let own = basic_crank(engine);
    own.iter().map(|unbalance| amount + (*unbalance - own[0])).collect()
}

/// Counterweights that answer the rotating masses and the forward first order of the reciprocating ones, throw by
/// throw; complex where an offset turns the first order off the throw.
fn raised_crank(engine: &Engine, options: &ArrangementOptions) -> Result<Vec<Complex64>, BalanceError> {
    let request = options.request();
    let mut crank = basic_crank(engine);
    // On bare throws a cylinder's first order with the crank is its big end's and its reciprocating parts' alone.
    let bare = engine
        .with(|parts| parts.throws.iter_mut().for_each(|throw| throw.unbalance = 0.0))
        .expect("invariant: 0 is an unbalance");
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        let orders = Mechanism::of(&bare, &request, Selection::Cylinder(index))?.orders();
        let speed = engine.speed.highest;
        let forward = orders[1].force_forward / (speed * speed);
        let throw = &engine.throws[cylinder.throw];
        let along = Complex64::cis(-(throw.angle + engine.crankshafts[throw.crankshaft].phase));
        crank[cylinder.throw] += forward * along - cylinder.rod.big_end_mass * throw.radius;
    }
    Ok(crank)
}

/// The counterweight of a throw from its complex amount opposite to the throw.
fn weight(engine: &Engine, throw: usize, unbalance: Complex64) -> Counterweight {
    let own = &engine.throws[throw];
    // Dust of the sum above is no phase.
    let turn = if unbalance.im.abs() < 1e-12 * unbalance.re.abs() {
        if unbalance.re < 0.0 { std::f64::consts::PI } else { 0.0 }
    } else {
        unbalance.arg()
    };
    Counterweight {
        name: format!("throw {}", throw + 1),
        crankshaft: own.crankshaft,
        z: own.z,
        unbalance: unbalance.norm(),
        angle: own.angle + std::f64::consts::PI + turn,
        part: None,
    }
}

fn checked(quantity: &'static str, amount: f64) -> Result<f64, BalanceError> {
    if amount.is_finite() && amount >= 0.0 {
        return Ok(amount);
    }
    let device = "the arrangement".to_string();
    Err(BalanceError::Number { quantity, device, needed: "0 or more and finite", got: amount })
}

/// First and second order of the reciprocating parts.
struct Reciprocating {
    speed: f64,
    orders: Vec<OrderLoads>,
    /// Planes of the first and the last cylinder [m].
    planes: [f64; 2],
    negligible_force: f64,
    negligible_couple: f64,
}

impl Reciprocating {
    fn of(engine: &Engine, options: &ArrangementOptions) -> Result<Reciprocating, BalanceError> {
        let mechanism = Mechanism::of(engine, &options.request(), Selection::Part(Part::Reciprocating))?;
        let speed = engine.speed.highest;
        let force: f64 = engine
            .cylinders
            .iter()
            .map(|c| c.reciprocating_mass() * engine.throws[c.throw].radius * speed * speed)
            .sum();
        let planes = engine.cylinders.iter().map(|c| c.z);
        let first = planes.clone().fold(f64::INFINITY, f64::min);
        let last = planes.fold(f64::NEG_INFINITY, f64::max);
        let lever = first.abs().max(last.abs()).max(last - first);
        Ok(Reciprocating {
            speed,
            orders: mechanism.orders(),
            planes: [first, last],
            negligible_force: VANISHING * force,
            negligible_couple: VANISHING * force * lever,
        })
    }

    /// The shaft that cancels the order of this ratio; `None` where there is nothing to cancel.
    fn shaft(
        &self,
        name: &str,
        ratio: i32,
        [x, y]: [f64; 2],
        given: Option<f64>,
    ) -> Result<Option<BalanceShaft>, BalanceError> {
        let order = &self.orders[ratio.unsigned_abs() as usize];
        let (force, couple) = if ratio > 0 {
            (order.force_forward, order.couple_forward)
        } else {
            (order.force_backward, order.couple_backward)
        };
        let square = (f64::from(ratio) * self.speed).powi(2);
        let sum = -force / square;
        let moment = Complex64::I * couple / square;
        let amounts = self.weights(sum, moment, square);
        if amounts.is_empty() {
            return Ok(None);
        }
        let given = given.map(|amount| checked("unbalance of a shaft's weight", amount)).transpose()?;
        let weights = amounts
            .into_iter()
            .map(|(z, u)| ShaftWeight::new(z, given.unwrap_or(u.norm()), u.arg()))
            .collect();
        let ratio = Ratio::whole(ratio).expect("invariant: orders 1 and 2 in either sense are not 0");
        Ok(Some(BalanceShaft { name: name.to_string(), ratio, x, y, weights, inertia: None }))
    }

    /// Weights with this sum [kg m] and this moment about the origin [kg m^2].
    fn weights(&self, sum: Complex64, moment: Complex64, square: f64) -> Vec<(f64, Complex64)> {
        let [first, last] = self.planes;
        let no_force = sum.norm() * square <= self.negligible_force;
        let no_couple = moment.norm() * square <= self.negligible_couple;
        match (no_force, no_couple) {
            (true, true) => Vec::new(),
            (false, true) if first <= 0.0 && last >= 0.0 => vec![(0.0, sum)],
            (true, false) => {
                let half = moment / (last - first);
                vec![(first, -half), (last, half)]
            }
            _ => {
                let plane = moment / sum;
                let reach = first.abs().max(last.abs()).max(last - first);
                let real = plane.im.abs() <= VANISHING * reach;
                let inside = plane.re >= first - VANISHING * reach && plane.re <= last + VANISHING * reach;
                if real && inside {
                    return vec![(plane.re, sum)];
                }
                let rear = (moment - first * sum) / (last - first);
                vec![(first, sum - rear), (last, rear)]
            }
        }
    }
}

#[cfg(test)]
mod tests;
