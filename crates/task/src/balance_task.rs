//! What may be done to balance an engine, and what is wanted: the section `[balance]` of the engine file.
//!
//! A *free weight* is an unbalance whose amount and phase are to be found, on a crankshaft or on a free shaft. A free
//! weight or shaft that has the name of a weight or shaft of the engine stands in its place: the engine is judged
//! without the old one.

use crate::drilling::DrillCatalogue;
use crate::durability::DurabilityWish;
use lanchester_model::Ratio;
use serde::Serialize;

/// The largest amount of a weight that shapes and clearance give.
pub const WHAT_FITS: &str = "what fits";

/// Free weights, shafts and inertias, with what is to be minimised and what must hold.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct BalanceTask {
    /// Balance shafts that may be fitted.
    pub shafts: Vec<FreeShaft>,
    /// Weights on the crankshafts and on these shafts.
    pub weights: Vec<FreeWeight>,
    /// Inertias that turn against a crankshaft.
    pub inertias: Vec<FreeInertia>,
    /// Weights that depend on one another.
    pub ties: Vec<Tie>,
    /// What is minimised: the first stage first, each next one without degrading the previous ones. Empty: force, then
    /// couple. Among answers that all stages leave equal the one is chosen whose force and couple, as far as no stage
    /// names them, and then roll moment are least; of those, where a weight on a crankshaft is free, the one with the least
    /// root mean square of main-bearing loads, then the least largest one, then the least bending moment; of those the
    /// lightest.
    pub stages: Vec<Stage>,
    /// How far later stages may raise each stage above its least value, in the order of the stages (of the default ones where
    /// none are named); a stage without an entry gives up nothing.
    pub give_up: Vec<GiveUp>,
    /// What must hold.
    pub limits: Vec<Limit>,
    /// What each shaft costs if it is used, in the order of the shafts; a shaft without an entry costs nothing.
    pub shaft_costs: Vec<f64>,
    /// Speeds [rad/s] of crankshaft 1 at which forces at mounts with springs and loads with gas are judged, the largest of all counting;
    /// empty: the whole range of the engine. All other loads are largest at the highest speed.
    pub speeds: Vec<f64>,
    /// What loads at each of these speeds are multiplied by before the largest counts, in their order; a speed without an entry has 1.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub speed_weights: Vec<f64>,
    /// Orders of loads that must vanish exactly, instead of stages and limits. Of all weights that do it those come first that the
    /// default stages and what decides among equals put first.
    pub cancel: Vec<(Load, f64)>,
    /// Most of the optional weights, shafts and inertias that may be used at once.
    pub most_optional: Option<usize>,
    /// Films and safeties that must not fall below a value or are to be large, after the optimum of the stages.
    #[serde(skip_serializing_if = "DurabilityWish::is_empty")]
    pub durability: DurabilityWish,
}

impl BalanceTask {
    /// The stages: those named or, where none are, force and then couple.
    pub fn stages_or_default(&self) -> Vec<Stage> {
        if !self.stages.is_empty() {
            return self.stages.clone();
        }
        [Load::Force, Load::Couple].map(|load| Stage { terms: vec![(1.0, Criterion::Peak(load))] }).to_vec()
    }

    /// Judges loads over speed at these speeds [rad/s], each with its weight, and at no others.
    pub fn judge_at(&mut self, speeds: &[(f64, f64)]) {
        self.speeds = speeds.iter().map(|one| one.0).collect();
        let weighted = speeds.iter().any(|one| one.1 != 1.0);
        self.speed_weights = if weighted { speeds.iter().map(|one| one.1).collect() } else { Vec::new() };
    }

    /// The speeds [rad/s], each with its weight.
    pub fn weighted_speeds(&self) -> Vec<(f64, f64)> {
        let weights = self.speed_weights.iter().copied().chain(std::iter::repeat(1.0));
        self.speeds.iter().copied().zip(weights).collect()
    }

    /// Whether anything that is minimised or limited counts the gas.
    pub fn counts_gas(&self) -> bool {
        let stages = self.stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
        let mut asked = stages.chain(self.limits.iter().map(|limit| limit.criterion));
        asked.any(|criterion| criterion.counts_gas())
    }

    /// What a shaft costs if it is used.
    pub fn shaft_cost(&self, shaft: usize) -> f64 {
        self.shaft_costs.get(shaft).copied().unwrap_or(0.0)
    }

    /// Whether costs are minimised or limited.
    pub fn asks_for_cost(&self) -> bool {
        let of_stages = self.stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
        of_stages.chain(self.limits.iter().map(|limit| limit.criterion)).any(|one| one == Criterion::Cost)
    }

    /// Whether it matters that a weight is left out: its use costs something, and the cost is asked for.
    pub fn pays_for_weight(&self, weight: usize) -> bool {
        self.weights[weight].cost.fixed > 0.0 && self.asks_for_cost()
    }

    /// Whether it matters that a shaft is left out.
    pub fn pays_for_shaft(&self, shaft: usize) -> bool {
        self.shaft_cost(shaft) > 0.0 && self.asks_for_cost()
    }

    /// Whether anything that is minimised or limited is a force at mounts.
    pub fn counts_mounts(&self) -> bool {
        let stages = self.stages.iter().flat_map(|stage| &stage.terms).map(|term| term.1);
        let mut asked = stages.chain(self.limits.iter().map(|limit| limit.criterion));
        asked.any(
            |one| matches!(one, Criterion::Peak(load) | Criterion::Order(load, _) if load.is_at_mounts()),
        )
    }

    /// Takes all other weights out, with the ties that they are in.
    pub fn keep_weights(&mut self, keep: impl Fn(&FreeWeight) -> bool) {
        let kept: Vec<bool> = self.weights.iter().map(keep).collect();
        let place = |index: usize| kept[..index].iter().filter(|kept| **kept).count();
        self.ties.retain(|tie| kept[tie.first] && kept[tie.second]);
        for tie in &mut self.ties {
            (tie.first, tie.second) = (place(tie.first), place(tie.second));
        }
        let mut index = 0;
        self.weights.retain(|_| {
            index += 1;
            kept[index - 1]
        });
    }
}

/// A coordinate that is given or to be found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// Given [m].
    At(f64),
    /// Anywhere from the first to the second [m], `first < second`.
    Between(f64, f64),
}

/// A balance shaft that may be fitted.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FreeShaft {
    /// Name for tables and for the engine file.
    pub name: String,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: Ratio,
    /// Position of its axis [m].
    pub x: Place,
    /// Position of its axis [m].
    pub y: Place,
    /// Whether it may be left out.
    pub optional: bool,
}

/// What a free weight sits on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Seat {
    /// A crankshaft of the engine (its web, flywheel or pulley), by index.
    Crankshaft(usize),
    /// A shaft of [`BalanceTask::shafts`], by index.
    Shaft(usize),
}

/// An unbalance that is to be found: `U = amount e^{i phase}` at `theta = 0`, in the engine's frame.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FreeWeight {
    /// Name for tables and for the engine file.
    pub name: String,
    /// What it sits on.
    pub seat: Seat,
    /// Plane [m], from the origin.
    pub z: Place,
    /// Least amount [kg m], 0 or more. An optional weight is either left out or has at least this.
    pub least: f64,
    /// Largest amount [kg m]; equal to `least` for a given amount.
    pub most: Option<f64>,
    /// Whether its largest amount is what fits on its web, by shapes and clearance.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub fits: bool,
    /// Direction at `theta = 0` in the engine's frame (crankshaft phase included).
    pub phase: Phase,
    /// Whether it may be left out.
    pub optional: bool,
    /// Distance of its centre of gravity from the axis it turns about [m]: its mass is amount over radius.
    pub radius: Option<f64>,
    /// Amounts that can be made, within `least` and `most`; none: every amount.
    pub catalogue: Option<Catalogue>,
    /// The holes whose unbalances are its catalogue, if it is one of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drill: Option<DrillCatalogue>,
    /// What it costs if it is used.
    pub cost: Cost,
    /// Name of the parts that it is one of: used weights with the same name have the same amount of their catalogue.
    pub equal_parts: Option<String>,
}

impl FreeWeight {
    /// A weight of any amount and direction.
    pub fn new(name: impl Into<String>, seat: Seat, z: Place) -> FreeWeight {
        let name = name.into();
        FreeWeight {
            name,
            seat,
            z,
            least: 0.0,
            most: None,
            fits: false,
            phase: Phase::Free,
            optional: false,
            radius: None,
            catalogue: None,
            drill: None,
            cost: Cost::default(),
            equal_parts: None,
        }
    }

    /// With these holes as its catalogue, up to the largest of them where it has no largest amount. Its direction is that of the weight:
    /// opposite to an empty hole.
    pub fn drilled(mut self, drill: DrillCatalogue) -> FreeWeight {
        let amounts = drill.holes().iter().map(|hole| hole.unbalance).collect();
        let catalogue = Catalogue::Amounts(amounts);
        self.most = self.most.or(catalogue.largest());
        self.catalogue = Some(catalogue);
        self.drill = Some(drill);
        self
    }
}

/// What a weight costs if it is used, in whatever unit the file counts: nothing where it is not.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Cost {
    /// Whatever its amount.
    pub fixed: f64,
    /// For every unit of its amount [1/(kg m)].
    pub per_amount: f64,
}

/// Amounts of which a free weight has one, or none at all.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Catalogue {
    /// Whole multiples of this [kg m].
    Steps(f64),
    /// These [kg m], rising, all above 0.
    Amounts(Vec<f64>),
}

impl Catalogue {
    /// Amounts that differ by less than this share are one.
    const ONE_AMOUNT: f64 = 1e-9;

    /// Its amount number `index` [kg m]; number 0 is none at all. Beyond the last one it is infinite.
    pub fn amount(&self, index: usize) -> f64 {
        match (self, index) {
            (_, 0) => 0.0,
            (_, usize::MAX) => f64::INFINITY,
            (Catalogue::Steps(step), _) => step * index as f64,
            (Catalogue::Amounts(list), _) => list.get(index - 1).copied().unwrap_or(f64::INFINITY),
        }
    }

    /// Number of its last amount; `usize::MAX` where it has no end.
    pub fn last(&self) -> usize {
        match self {
            Catalogue::Steps(_) => usize::MAX,
            Catalogue::Amounts(list) => list.len(),
        }
    }

    /// Its largest amount [kg m]; none where it has no end.
    pub fn largest(&self) -> Option<f64> {
        Some(self.amount(self.last())).filter(|amount| amount.is_finite())
    }

    /// Number of its largest amount that is no larger than `amount`, to rounding.
    pub fn below(&self, amount: f64) -> usize {
        let most = amount * (1.0 + Self::ONE_AMOUNT);
        match self {
            Catalogue::Steps(step) => (most / step).floor().max(0.0) as usize,
            Catalogue::Amounts(list) => list.iter().take_while(|one| **one <= most).count(),
        }
    }

    /// Number of its amount that is nearest to `amount`.
    pub fn nearest(&self, amount: f64) -> usize {
        let below = self.below(amount);
        let is_next = self.amount(below.saturating_add(1)) - amount < amount - self.amount(below);
        if is_next { below + 1 } else { below }
    }
}

/// Direction of a free weight at `theta = 0`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Phase {
    /// To be found.
    Free,
    /// Along this direction [rad] or opposite to it, whichever is better.
    Line(f64),
    /// Along this direction [rad].
    Direction(f64),
}

/// An inertia geared to turn against crankshaft 1 (Heron flywheel, geared alternator): with the crank train free to
/// follow its torque it takes part of the roll moment.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FreeInertia {
    /// Name for tables.
    pub name: String,
    /// Its speed over that of crankshaft 1, as a positive number: it turns the other way.
    pub ratio: f64,
    /// Inertia of everything that turns with crankshaft 1 [kg m^2], flywheel included.
    pub crank_inertia: f64,
    /// Largest inertia [kg m^2].
    pub most: Option<f64>,
    /// Whether it may be left out.
    pub optional: bool,
}

/// `U_second = factor * U_first`, or `factor * conj(U_first)` if mirrored (in the plane of x and z).
///
/// A leader follows nobody. In an engine that was read the follower's own direction is free, its least amount 0, its
/// largest that which the leader's allows, and it is not optional: the leader's choices are its own.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Tie {
    /// Index of the leading weight.
    pub first: usize,
    /// Index of the weight that follows it.
    pub second: usize,
    /// 1: equal, -1: opposed.
    pub factor: f64,
    /// Whether the phase is mirrored.
    pub mirrored: bool,
}

/// A load over the cycle whose largest amount is judged; about the origin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Load {
    /// Resultant force `|F_x + i F_y|` [N].
    Force,
    /// Force along x [N].
    ForceX,
    /// Force along y [N].
    ForceY,
    /// Resultant couple `|M_x + i M_y|` [N m].
    Couple,
    /// Couple about x [N m].
    CoupleX,
    /// Couple about y [N m].
    CoupleY,
    /// Roll moment [N m].
    RollMoment,
    /// Force at one mount [N], by index.
    MountForce(usize),
    /// Largest force at any mount [N].
    LargestMountForce,
    /// Force at one mount [N], by index, of inertia and of the torque of the gas about its mean: on springs, over the range of
    /// speeds or at the speeds of the task.
    MountForceWithGas(usize),
    /// Largest such force at any mount [N].
    LargestMountForceWithGas,
    /// Inertia load of one main bearing [N], by index: those of crankshaft 1 first, each from the free end on
    /// ([`lanchester_model::Engine::main_bearings`]). Every throw is held by the two main bearings beside it.
    MainLoad(usize),
    /// Largest inertia load of any main bearing [N].
    LargestMainLoad,
    /// Largest bending moment along crankshaft 1 [N m].
    BendingMoment,
}

impl Load {
    /// Whether it is a force at mounts.
    pub fn is_at_mounts(self) -> bool {
        matches!(self, Load::MountForce(_) | Load::LargestMountForce) || self.counts_gas()
    }

    /// Whether the gas counts.
    pub fn counts_gas(self) -> bool {
        matches!(self, Load::MountForceWithGas(_) | Load::LargestMountForceWithGas)
    }
}

/// Which main bearings count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Mains {
    /// All of them together: the statistic is taken over bearings and cycle.
    All,
    /// The one with the largest.
    Largest,
    /// One, by index as in [`Load::MainLoad`].
    One(usize),
}

/// What counts of a load over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Statistic {
    /// Root mean square.
    Rms,
    /// Mean of the amount.
    Mean,
    /// Largest amount.
    Peak,
}

/// What is judged.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// Peak of a load over the continuous cycle, at the highest speed of the engine.
    Peak(Load),
    /// Peak of one order of a load (both senses together).
    Order(Load, f64),
    /// Root mean square of main-bearing loads of inertia over the continuous cycle [N], at the highest speed.
    MainRms(Mains),
    /// Mean of the amount of main-bearing loads of inertia over equal angles of the cycle [N], at the highest speed.
    MainMean(Mains),
    /// Main-bearing loads of inertia and gas [N], the largest over the range of speeds, or over the speeds of the task.
    MainsWithGas(Statistic, Mains),
    /// Mass of all free weights [kg]: every one needs its radius.
    AddedMass,
    /// Sum of the amounts of all free weights [kg m].
    AddedUnbalance,
    /// Cost of all free weights and shafts that are used ([`Cost`], [`BalanceTask::shaft_costs`]), in the unit of the file.
    Cost,
}

impl Criterion {
    /// Whether the gas counts.
    pub fn counts_gas(self) -> bool {
        match self {
            Criterion::Peak(load) | Criterion::Order(load, _) => load.counts_gas(),
            other => matches!(other, Criterion::MainsWithGas(..)),
        }
    }
}

/// Criteria that are minimised together: the sum of weight times criterion.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Stage {
    /// Positive weights and criteria.
    pub terms: Vec<(f64, Criterion)>,
}

impl Stage {
    /// These terms; a single one counts with weight 1, as its value alone then says what is minimised.
    pub fn of(mut terms: Vec<(f64, Criterion)>) -> Stage {
        if let [(weight, _)] = &mut terms[..] {
            *weight = 1.0;
        }
        Stage { terms }
    }
}

/// How far later stages may raise a stage above its least value.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GiveUp {
    /// Not at all.
    #[default]
    Nothing,
    /// By this share of the least value: 0.01 is 1 %.
    Share(f64),
    /// By this much, in the SI unit of the stage's criterion.
    Amount(f64),
}

impl GiveUp {
    /// How far a stage with this least value may be raised, in its unit.
    pub fn amount(self, least: f64) -> f64 {
        match self {
            GiveUp::Nothing => 0.0,
            GiveUp::Share(share) => share * least,
            GiveUp::Amount(amount) => amount,
        }
    }
}

/// A criterion that must not pass a value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Limit {
    /// What.
    pub criterion: Criterion,
    /// Largest value, in the criterion's SI unit.
    pub most: f64,
}
