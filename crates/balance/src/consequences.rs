//! What other weights do to an engine: loads on the block, the mounts and the main bearings, bending of the crankshaft, mass and
//! balance rate, before and after.
//!
//! Everything is of inertia at the highest speed of the engine. Main bearings are those of [`main_inertia_loads`] (throw by throw),
//! the bending moment is that of the crankshaft as a free beam under what turns with it, as the criterion of that name.

use crate::balance_rate::{BalanceRate, balance_rates};
use crate::error::BalanceError;
use crate::operator::natural;
use crate::optimum::optimise;
use lanchester_mechanism::{Beam, BeamModel, MainInertiaLoad, main_inertia_loads, turning_loads};
use lanchester_model::{Counterweight, Engine};
use lanchester_task::{BalanceTask, Criterion, Load, Stage};
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const CONSEQUENCES_VERSION: u32 = 1;

/// Share of a value that a change must pass to be one: optima are closed to less.
const CHANGE: f64 = 1e-6;

/// Share of what all masses would do together, if nothing cancelled, up to which a value is rounding.
const ROUNDING: f64 = 1e-9;

/// Planes closer than this [m] are one.
const SAME_PLANE: f64 = 1e-9;

/// Quantities of an engine that other weights change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Affected {
    /// Peak of the resultant force on the block [N].
    Force,
    /// Peak of the resultant couple [N m].
    Couple,
    /// Peak of the roll moment [N m].
    RollMoment,
    /// Largest force at any mount [N].
    MountForce,
    /// Root mean square of the load on a main bearing over the cycle [N].
    MainLoadRms,
    /// Peak of the load on a main bearing [N].
    MainLoadPeak,
    /// Largest bending moment along a crankshaft [N m].
    BendingMoment,
    /// Mass of all counterweights [kg].
    CounterweightMass,
    /// Sum of the unbalances of all counterweights [kg m].
    CounterweightUnbalance,
    /// Sum of the unbalances of all weights of balance shafts [kg m].
    ShaftUnbalance,
    /// Share of a bay's rotating unbalance that its counterweights answer [1] ([`BalanceRate`]).
    BalanceRate,
}

impl Affected {
    /// Name for tables and sentences.
    pub fn name(self) -> &'static str {
        match self {
            Affected::Force => "force",
            Affected::Couple => "couple",
            Affected::RollMoment => "roll moment",
            Affected::MountForce => "mount force",
            Affected::MainLoadRms => "main-bearing load, RMS",
            Affected::MainLoadPeak => "main-bearing load, peak",
            Affected::BendingMoment => "bending moment",
            Affected::CounterweightMass => "counterweight mass",
            Affected::CounterweightUnbalance => "counterweight unbalance",
            Affected::ShaftUnbalance => "balance-shaft unbalance",
            Affected::BalanceRate => "balance rate",
        }
    }

    /// Its SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Affected::Force | Affected::MountForce | Affected::MainLoadRms | Affected::MainLoadPeak => "N",
            Affected::Couple | Affected::RollMoment | Affected::BendingMoment => "N m",
            Affected::CounterweightMass => "kg",
            Affected::CounterweightUnbalance | Affected::ShaftUnbalance => "kg m",
            Affected::BalanceRate => "1",
        }
    }
}

/// Where in the engine a quantity is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum AffectedPart {
    /// The whole of it.
    Engine,
    /// A crankshaft.
    Crankshaft {
        /// Its number, from 1.
        crankshaft: usize,
    },
    /// A main bearing.
    Main {
        /// Number of its crankshaft, from 1.
        crankshaft: usize,
        /// Its number from the free end, from 1.
        main: usize,
        /// Its plane [m], from the origin.
        z: f64,
    },
    /// What is between two neighbouring main bearings.
    Bay {
        /// Number of its crankshaft, from 1.
        crankshaft: usize,
        /// Number of its front main, from 1.
        bay: usize,
        /// Planes of its two mains [m], from the origin.
        between: [f64; 2],
    },
}

impl AffectedPart {
    /// Whether both are the same part by their numbers, wherever it stands.
    fn is_same(&self, other: &AffectedPart) -> bool {
        let numbers = |part: &AffectedPart| match *part {
            AffectedPart::Engine => (0, 0, 0),
            AffectedPart::Crankshaft { crankshaft } => (1, crankshaft, 0),
            AffectedPart::Main { crankshaft, main, .. } => (2, crankshaft, main),
            AffectedPart::Bay { crankshaft, bay, .. } => (3, crankshaft, bay),
        };
        numbers(self) == numbers(other)
    }
}

/// What became of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// It fell; a balance rate came nearer to 1.
    Better,
    /// It is the same to a millionth.
    Unchanged,
    /// It rose; a balance rate is farther from 1, so that more of the bay's rotating unbalance is left, or more than it is answered.
    Worse,
}

/// One quantity before and after.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Consequence {
    /// Which.
    pub quantity: Affected,
    /// Where.
    pub part: AffectedPart,
    /// With the weights that the engine had, in the unit of the quantity; what is rounding is 0.
    pub before: f64,
    /// With the new ones.
    pub after: f64,
    /// What became of it.
    pub change: Change,
}

/// Bending moment along a crankshaft, before and after: straight between these planes.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BendingAlong {
    /// Number of the crankshaft, from 1.
    pub crankshaft: usize,
    /// Planes [m], from the origin, rising.
    pub z: Vec<f64>,
    /// Bending moment `M_x + i M_y` at `theta = 0` [N m]; it turns with the crankshaft.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub before: Vec<Complex64>,
    /// With the new weights.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub after: Vec<Complex64>,
}

/// What other weights do to an engine.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Consequences {
    /// [`CONSEQUENCES_VERSION`].
    pub version: u32,
    /// Speed of crankshaft 1 [rad/s]: the highest of the engine.
    pub speed: f64,
    /// Every quantity, in the order of [`Affected`]; within one from the free end on.
    pub rows: Vec<Consequence>,
    /// Bending moment along every crankshaft with throws.
    pub bending: Vec<BendingAlong>,
    /// Names of counterweights that are there no more, or have no unbalance any more.
    pub dropped: Vec<String>,
    /// Names of counterweights that were not there before.
    pub added: Vec<String>,
    /// Number of counterweights before and after.
    pub counterweights: [usize; 2],
}

impl Consequences {
    /// Rows of one quantity.
    pub fn of(&self, quantity: Affected) -> impl Iterator<Item = &Consequence> {
        self.rows.iter().filter(move |row| row.quantity == quantity)
    }

    /// What got worse.
    pub fn worse(&self) -> impl Iterator<Item = &Consequence> {
        self.rows.iter().filter(|row| row.change == Change::Worse)
    }

    /// Largest value of a quantity at any part, before and after; `None` where the engine has none.
    pub fn largest(&self, quantity: Affected) -> Option<[f64; 2]> {
        let rows = self.of(quantity).map(|row| [row.before, row.after]);
        rows.reduce(|most, row| [most[0].max(row[0]), most[1].max(row[1])])
    }
}

/// What the weights of `after` do, which is the engine `before` with other counterweights and balance shafts. `mass` gives the mass
/// of a counterweight [kg] where it is known; where it is for all of both engines their sum is a row.
///
/// # Errors
/// [`BalanceError`] where the loads of either engine cannot be computed.
pub fn consequences(
    before: &Engine,
    after: &Engine,
    mass: impl Fn(&Engine, &Counterweight) -> Option<f64>,
) -> Result<Consequences, BalanceError> {
    let [was, is] = [State::of(before, &mass)?, State::of(after, &mass)?];
    let speed = before.speed.highest;
    let scales = {
        let ([force, moment], [other, other_moment]) = (scale(before), scale(after));
        [force.max(other), moment.max(other_moment)]
    };
    let mut rows = Vec::new();
    for (quantity, part, value) in &was.values {
        let same = |row: &&(Affected, AffectedPart, f64)| row.0 == *quantity && row.1.is_same(part);
        if let Some((.., other)) = is.values.iter().find(same) {
            rows.push(row(*quantity, *part, [*value, *other], scales, speed));
        }
    }
    let is_weight = |weight: &&Counterweight| weight.unbalance > ROUNDING * scales[0] / (speed * speed);
    let weights = |engine: &Engine| -> Vec<(usize, String)> {
        let list = engine.counterweights.iter().filter(is_weight);
        list.map(|weight| (weight.crankshaft, weight.name.clone())).collect()
    };
    let [old, new] = [weights(before), weights(after)];
    let without = |list: &[(usize, String)], other: &[(usize, String)]| -> Vec<String> {
        list.iter().filter(|weight| !other.contains(weight)).map(|(_, name)| name.clone()).collect()
    };
    Ok(Consequences {
        version: CONSEQUENCES_VERSION,
        speed,
        rows,
        bending: (0..before.crankshafts.len()).filter_map(|index| bending(before, after, index)).collect(),
        dropped: without(&old, &new),
        added: without(&new, &old),
        counterweights: [old.len(), new.len()],
    })
}

/// The quantities of one engine.
struct State {
    values: Vec<(Affected, AffectedPart, f64)>,
}

impl State {
    fn of(
        engine: &Engine,
        mass: &impl Fn(&Engine, &Counterweight) -> Option<f64>,
    ) -> Result<State, BalanceError> {
        let mut values = Vec::new();
        let mut whole = |quantity, value| values.push((quantity, AffectedPart::Engine, value));
        for (quantity, value) in on_the_block(engine)? {
            whole(quantity, value);
        }
        let mains = main_inertia_loads(engine, None)?;
        let main = |load: &MainInertiaLoad| {
            let MainInertiaLoad { crankshaft, main, z, .. } = *load;
            AffectedPart::Main { crankshaft, main, z }
        };
        values.extend(mains.iter().map(|load| (Affected::MainLoadRms, main(load), load.rms)));
        values.extend(mains.iter().map(|load| (Affected::MainLoadPeak, main(load), load.peak.value)));
        for index in 0..engine.crankshafts.len() {
            if let Some(largest) = largest_bending(engine, index) {
                let part = AffectedPart::Crankshaft { crankshaft: index + 1 };
                values.push((Affected::BendingMoment, part, largest));
            }
        }
        let mut whole = |quantity, value| values.push((quantity, AffectedPart::Engine, value));
        let weights = engine.counterweights.iter().filter(|weight| weight.unbalance > 0.0);
        if let Some(mass) = weights.map(|weight| mass(engine, weight)).sum::<Option<f64>>() {
            whole(Affected::CounterweightMass, mass);
        }
        whole(Affected::CounterweightUnbalance, engine.counterweights.iter().map(|w| w.unbalance).sum());
        let shafts = engine.shafts.iter().flat_map(|shaft| &shaft.weights);
        whole(Affected::ShaftUnbalance, shafts.map(|weight| weight.unbalance).sum());
        values.extend(balance_rates(engine).into_iter().map(|bay| {
            let BalanceRate { crankshaft, bay, between, rate } = bay;
            (Affected::BalanceRate, AffectedPart::Bay { crankshaft, bay, between }, rate)
        }));
        Ok(State { values })
    }
}

/// Largest load of inertia on any main bearing [N] and largest bending moment along any crankshaft [N m].
pub(crate) fn inside_the_crank(engine: &Engine) -> Result<[f64; 2], BalanceError> {
    let mains = main_inertia_loads(engine, None)?;
    let load = mains.iter().map(|main| main.peak.value).fold(0.0, f64::max);
    let moments = (0..engine.crankshafts.len()).filter_map(|index| largest_bending(engine, index));
    Ok([load, moments.fold(0.0, f64::max)])
}

/// Largest bending moment along crankshaft `index` (from 0) [N m]; `None` without mains.
fn largest_bending(engine: &Engine, index: usize) -> Option<f64> {
    let along = bending(engine, engine, index)?;
    Some(along.before.iter().map(|moment| moment.norm()).fold(0.0, f64::max))
}

/// Peaks of the loads on the block and at its mounts.
fn on_the_block(engine: &Engine) -> Result<Vec<(Affected, f64)>, BalanceError> {
    let mut listed = vec![
        (Affected::Force, Criterion::Peak(Load::Force)),
        (Affected::Couple, Criterion::Peak(Load::Couple)),
        (Affected::RollMoment, Criterion::Peak(Load::RollMoment)),
    ];
    if !engine.mounts.is_empty() {
        listed.push((Affected::MountForce, Criterion::Peak(Load::LargestMountForce)));
    }
    let terms = listed.iter().map(|(_, criterion)| (1.0, *criterion)).collect();
    let task = BalanceTask { stages: vec![Stage { terms }], ..BalanceTask::default() };
    let effects = optimise(engine, &task)?.effects;
    let value =
        |criterion| effects.iter().find(|effect| effect.criterion == criterion).map(|effect| effect.after);
    Ok(listed.into_iter().filter_map(|(quantity, criterion)| Some((quantity, value(criterion)?))).collect())
}

/// Bending moment along crankshaft `index` (from 0) of both engines; `None` without mains.
fn bending(before: &Engine, after: &Engine, index: usize) -> Option<BendingAlong> {
    let beam = |engine: &Engine| Beam::new(&engine.main_planes(index), BeamModel::FreeBeam);
    let loads = |engine: &Engine| turning_loads(engine, index, engine.speed.highest);
    let [(old_beam, old), (new_beam, new)] = [(beam(before)?, loads(before)), (beam(after)?, loads(after))];
    let mains = old_beam.mains().iter().chain(new_beam.mains()).copied();
    let mut z: Vec<f64> = old.iter().chain(&new).map(|load| load.0).chain(mains).collect();
    z.sort_by(f64::total_cmp);
    z.dedup_by(|later, kept| *later - *kept < SAME_PLANE);
    let moments = |beam: &Beam, loads: &[(f64, Complex64)]| -> Vec<Complex64> {
        let at = |section: &f64| -> Complex64 {
            loads.iter().map(|(z, force)| Complex64::I * beam.moment_influence(*section, *z) * force).sum()
        };
        z.iter().map(at).collect()
    };
    let (before, after) = (moments(&old_beam, &old), moments(&new_beam, &new));
    Some(BendingAlong { crankshaft: index + 1, z, before, after })
}

/// Force [N] and moment [N m] of all masses of an engine if nothing cancelled, at its highest speed.
fn scale(engine: &Engine) -> [f64; 2] {
    let (force, moment) = natural(engine, engine.speed.highest);
    [force, moment]
}

fn row(
    quantity: Affected,
    part: AffectedPart,
    values: [f64; 2],
    [force, moment]: [f64; 2],
    speed: f64,
) -> Consequence {
    let scale = match quantity.unit() {
        "N" => force,
        "N m" => moment,
        "kg m" => force / (speed * speed),
        _ => 1.0,
    };
    let [before, after] = values.map(|value| if value.abs() <= ROUNDING * scale { 0.0 } else { value });
    // What is left: of a balance rate what the weights do not answer.
    let left = |value: f64| if quantity == Affected::BalanceRate { (1.0 - value).abs() } else { value };
    let rise = left(after) - left(before);
    let change = match rise {
        _ if rise.abs() <= CHANGE * before.abs().max(after.abs()) + ROUNDING * scale => Change::Unchanged,
        rise if rise > 0.0 => Change::Worse,
        _ => Change::Better,
    };
    Consequence { quantity, part, before, after, change }
}
