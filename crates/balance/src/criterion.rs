//! What is judged, as groups of a convex programme.
//!
//! A load is a list of vectors, each with up to three components that are trigonometric polynomials of the crank angle
//! and affine in the variables; its peak is the largest amount of any of them at any angle. [`vectors`] is the one place
//! that knows the loads.

use crate::bending;
use crate::convex::curve::{Curve, Grid, Member};
use crate::convex::dense::{Matrix, norm, shortened};
use crate::convex::programme::Group;
use crate::cost;
use crate::error::BalanceError;
use crate::mounts;
use crate::operator::{Channel, Operator};
use crate::over_speed::gas_range::indices;
use crate::over_speed::places::GasCycle;
use crate::wave::{Wave, curve};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Load, Mains, Statistic};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Directions that change a root mean square by less than this share of the most that any does change it by rounding only.
const SHORTENED: f64 = 1e-15;

/// Equal angles of a revolution at which a mean over the cycle is judged.
const MEAN_ANGLES: usize = 180;

/// A criterion in terms of the groups of a programme: `scale * SUM of share * level`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Judged {
    pub criterion: Criterion,
    /// Groups with their shares.
    pub groups: Vec<(usize, f64)>,
    /// Where the largest of several such sums counts: these, and the variable that none of them passes, which `groups` has.
    pub largest: Option<LargestSum>,
    /// What a level of 1 is in the criterion's unit.
    pub scale: f64,
    /// The criterion where all variables are 0.
    pub unbalanced: f64,
}

/// Sums of groups none of which passes a variable:
///
/// ```text
/// minimise u   with   SUM over j of w_j |F_s(theta_j)| <= u   for every speed s
/// ```
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LargestSum {
    pub variable: usize,
    pub sums: Vec<Vec<(usize, f64)>>,
}

impl Judged {
    /// The criterion at the levels of the groups, in its own unit.
    pub fn value(&self, level: impl Fn(usize) -> f64) -> f64 {
        // An empty sum is a negative zero.
        let sum = |groups: &[(usize, f64)]| {
            0.0 + self.scale * groups.iter().map(|&(group, share)| share * level(group)).sum::<f64>()
        };
        match &self.largest {
            Some(largest) => largest.sums.iter().map(|groups| sum(groups)).fold(0.0, f64::max),
            None => sum(&self.groups),
        }
    }

    /// All groups that it depends on.
    pub fn seen(&self) -> impl Iterator<Item = usize> {
        let sums = self.largest.iter().flat_map(|largest| largest.sums.iter().flatten());
        self.groups.iter().chain(sums).map(|one| one.0)
    }
}

/// The vectors whose largest amount is the peak of `load`, and whether it is a force (else a moment).
pub(crate) fn vectors(
    engine: &Engine,
    operator: &Operator,
    load: Load,
) -> Result<(Vec<Vec<Wave>>, bool), BalanceError> {
    let channels = |list: &[Channel]| vec![list.iter().map(|&c| operator.channel(c).clone()).collect()];
    Ok(match load {
        Load::Force => (channels(&[Channel::ForceX, Channel::ForceY]), true),
        Load::ForceX => (channels(&[Channel::ForceX]), true),
        Load::ForceY => (channels(&[Channel::ForceY]), true),
        Load::Couple => (channels(&[Channel::CoupleX, Channel::CoupleY]), false),
        Load::CoupleX => (channels(&[Channel::CoupleX]), false),
        Load::CoupleY => (channels(&[Channel::CoupleY]), false),
        Load::RollMoment => (channels(&[Channel::RollMoment]), false),
        Load::MountForce(index) | Load::MountForceWithGas(index) => {
            let at_speeds = mount_forces(engine, operator, load)?.into_iter();
            let own = at_speeds.map(|all| all.into_iter().nth(index)).collect::<Option<Vec<_>>>();
            let needed = "a mount of that number";
            (own.ok_or_else(|| missing("force at a mount", needed, "count the [[mount]] entries"))?, true)
        }
        Load::LargestMountForce | Load::LargestMountForceWithGas => {
            (mount_forces(engine, operator, load)?.concat(), true)
        }
        Load::MainLoad(index) => {
            let of_main = main_loads(operator)?.get(index).cloned();
            let needed = "a main bearing of that number";
            let hint = "count the main bearings, those of crankshaft 1 first";
            (vec![of_main.ok_or_else(|| missing("main-bearing load", needed, hint))?.to_vec()], true)
        }
        Load::LargestMainLoad => (main_loads(operator)?.iter().map(|main| main.to_vec()).collect(), true),
        Load::BendingMoment => unreachable!("invariant: the bending moment is judged by itself"),
    })
}

pub(crate) fn missing(criterion: &str, needed: &'static str, hint: &'static str) -> BalanceError {
    BalanceError::Missing { criterion: criterion.to_string(), needed, hint }
}

/// The loads of all main bearings, of which there must be some.
fn main_loads(operator: &Operator) -> Result<&[[Wave; 2]], BalanceError> {
    if operator.mains.is_empty() {
        return Err(missing("main-bearing load", "a crankshaft with a throw", "judge something else"));
    }
    Ok(&operator.mains)
}

fn mount_forces(
    engine: &Engine,
    operator: &Operator,
    load: Load,
) -> Result<Vec<Vec<Vec<Wave>>>, BalanceError> {
    if engine.mounts.is_empty() {
        return Err(missing(
            "mount force",
            "the places of the mounts",
            "add [[mount]] entries to the engine file",
        ));
    }
    mounts::forces(engine, operator, load.counts_gas())
}

/// Adds the groups of `criterion` to `groups` and says how to read them.
///
/// `amounts` are the groups of the weights' corners (see [`amounts`]).
pub(crate) fn judge(
    engine: &Engine,
    task: &BalanceTask,
    operator: &Operator,
    criterion: Criterion,
    amounts: &[Vec<usize>],
    groups: &mut Vec<Group>,
) -> Result<Judged, BalanceError> {
    match criterion {
        Criterion::Peak(Load::BendingMoment) => {
            bending::judge(engine, task, operator, criterion, true, groups)
        }
        Criterion::Peak(load) => {
            let (vectors, force) = vectors(engine, operator, load)?;
            Ok(peak(operator, criterion, &vectors, force, groups))
        }
        Criterion::Order(load, order) => {
            if !(order.is_finite() && order >= 0.0) {
                return Err(BalanceError::Number {
                    quantity: "order",
                    device: "criterion".into(),
                    needed: "0 or more",
                    got: order,
                });
            }
            if load == Load::BendingMoment {
                return bending::judge(engine, task, operator, criterion, order == 1.0, groups);
            }
            let key = order_key(order, operator.grid.revolutions);
            let (vectors, force) = vectors(engine, operator, load)?;
            let only: Vec<Vec<Wave>> =
                vectors.iter().map(|v| v.iter().map(|w| w.only(key)).collect()).collect();
            Ok(peak(operator, criterion, &only, force, groups))
        }
        Criterion::MainRms(mains) => {
            let all = main_loads(operator)?;
            let one =
                |index: usize| vectors(engine, operator, Load::MainLoad(index)).map(|_| &all[index..=index]);
            let sets: Vec<&[[Wave; 2]]> = match mains {
                Mains::All => vec![all],
                Mains::Largest => all.chunks(1).collect(),
                Mains::One(index) => vec![one(index)?],
            };
            Ok(rms(operator, criterion, &sets, groups))
        }
        Criterion::MainMean(mains) => {
            let all = main_loads(operator)?;
            if let Mains::One(index) = mains {
                vectors(engine, operator, Load::MainLoad(index))?;
            }
            let waves = indices(mains, all.len()).into_iter().map(|main| &all[main]);
            let count = MEAN_ANGLES * operator.grid.revolutions as usize;
            let angles = (0..count).map(|k| TAU * k as f64 / count as f64);
            let members =
                waves.flat_map(|main| angles.clone().map(|phi| (1.0, standing(operator, main, phi))));
            Ok(mean(operator, criterion, members.collect(), groups))
        }
        Criterion::MainsWithGas(statistic, mains) => {
            let count = main_loads(operator)?.len();
            if let Mains::One(index) = mains {
                vectors(engine, operator, Load::MainLoad(index))?;
            }
            let indices = indices(mains, count);
            let cycles = &operator.places.cycles;
            match statistic {
                Statistic::Peak => {
                    let peaks = operator.places.peaks.iter().filter(|peak| indices.contains(&peak.main));
                    let members = peaks.map(|peak| peak.vector(operator)).collect();
                    Ok(largest_of(operator, criterion, members, groups))
                }
                Statistic::Rms => {
                    let waves = |cycle: &GasCycle| -> Vec<[Wave; 2]> {
                        indices.iter().map(|main| cycle.waves(operator, *main)).collect()
                    };
                    let at_speeds: Vec<Vec<[Wave; 2]>> = cycles.iter().map(waves).collect();
                    let each = if mains == Mains::Largest { 1 } else { indices.len() };
                    let sets: Vec<&[[Wave; 2]]> = at_speeds.iter().flat_map(|all| all.chunks(each)).collect();
                    Ok(rms(operator, criterion, &sets, groups))
                }
                Statistic::Mean => {
                    let of = |cycle: &GasCycle| -> Vec<(f64, Member)> {
                        indices.iter().flat_map(|main| cycle.vectors(operator, *main)).collect()
                    };
                    let all: Vec<Vec<(f64, Member)>> = cycles.iter().map(of).collect();
                    Ok(largest_mean(operator, criterion, all, groups))
                }
            }
        }
        Criterion::Cost => Ok(cost::judge(task, operator, amounts, groups)),
        Criterion::AddedUnbalance => Ok(sum(criterion, operator, amounts, |_| Ok(1.0))?),
        Criterion::AddedMass => Ok(sum(criterion, operator, amounts, |weight| {
            let weight = &task.weights[weight];
            let radius =
                weight.radius.ok_or_else(|| BalanceError::NoRadius { weight: weight.name.clone() })?;
            Ok(1.0 / radius)
        })?),
    }
}

/// The key of an order; of one between those that the engine has, which is not there, the key of none.
pub(crate) fn order_key(order: f64, revolutions: u32) -> u32 {
    let key = order * f64::from(revolutions);
    let whole = (key - key.round()).abs() < 1e-6 && key < 1e9;
    if whole { key.round() as u32 } else { u32::MAX }
}

/// A group of curves, scaled by its largest amount without the devices.
fn peak(
    operator: &Operator,
    criterion: Criterion,
    vectors: &[Vec<Wave>],
    force: bool,
    groups: &mut Vec<Group>,
) -> Judged {
    let natural = if force { operator.natural_force } else { operator.natural_moment };
    let curves: Vec<Curve> =
        vectors.iter().map(|v| curve(v, natural, operator.variables, &operator.grid)).collect();
    let nothing = vec![0.0; operator.variables];
    let largest = |curve: &Curve| curve.at(&nothing).summits(&operator.grid, 0.0)[0].amount;
    let unbalanced = curves.iter().map(largest).fold(0.0, f64::max);
    let unit = if unbalanced > 1e-7 { unbalanced } else { 1.0 };
    let (unbalanced, scale) = (unbalanced * natural, unit * natural);
    let members = curves.iter().map(|curve| Member::Curve(curve.in_unit(unit))).collect();
    groups.push(Group::new(members));
    Judged { criterion, groups: vec![(groups.len() - 1, 1.0)], largest: None, scale, unbalanced }
}

/// A group of one vector for each set of loads, whose length is the root mean square over the set and the cycle (Parseval):
///
/// ```text
/// rms^2 = 1/M SUM over loads of ( |c_0|^2 + 1/2 SUM over k of |c_k|^2 + |s_k|^2 )        c, s affine in the variables
/// ```
/// Coefficients that no variable touches are one number; the others are shortened to a row a variable.
fn rms(operator: &Operator, criterion: Criterion, sets: &[&[[Wave; 2]]], groups: &mut Vec<Group>) -> Judged {
    let vector = |set: &&[[Wave; 2]]| {
        let mut columns = Matrix::zeros(0, operator.variables);
        let (mut base, mut rest) = (Vec::new(), 0.0f64);
        for wave in set.iter().flatten() {
            let mut touched: BTreeMap<u32, [Vec<f64>; 2]> = BTreeMap::new();
            for &(variable, key, part) in &wave.parts {
                let rows =
                    touched.entry(key).or_insert_with(|| [(); 2].map(|_| vec![0.0; operator.variables]));
                rows.iter_mut().zip(part).for_each(|(row, part)| row[variable] += part);
            }
            let factor = |key: u32| {
                let share = if key == 0 { 1.0 } else { 0.5 };
                (share / set.len() as f64).sqrt() / operator.natural_force
            };
            for (key, value) in &wave.base {
                if !touched.contains_key(key) {
                    rest = value.iter().fold(rest, |rest, v| rest.hypot(factor(*key) * v));
                }
            }
            for (key, rows) in touched {
                let own = wave.base.get(&key).copied().unwrap_or_default();
                for (mut row, own) in rows.into_iter().zip(own) {
                    row.iter_mut().for_each(|value| *value *= factor(key));
                    columns.push(&row);
                    base.push(factor(key) * own);
                }
            }
        }
        let (columns, mut base) = shortened(&columns, &base, SHORTENED);
        let last = base.len() - 1;
        base[last] = base[last].hypot(rest);
        (columns, base)
    };
    let vectors: Vec<(Matrix, Vec<f64>)> = sets.iter().map(vector).collect();
    let unbalanced = vectors.iter().map(|v| norm(&v.1)).fold(0.0, f64::max);
    let unit = if unbalanced > 1e-7 { unbalanced } else { 1.0 };
    let member = |(columns, base)| Member::Vector { base, columns }.in_unit(unit);
    groups.push(Group::new(vectors.into_iter().map(member).collect()));
    let natural = operator.natural_force;
    Judged {
        criterion,
        groups: vec![(groups.len() - 1, 1.0)],
        largest: None,
        scale: unit * natural,
        unbalanced: unbalanced * natural,
    }
}

/// The load of a main bearing at one angle `phi`, measured against the natural force.
fn standing(operator: &Operator, main: &[Wave; 2], phi: f64) -> Member {
    let mut columns = Matrix::zeros(2, operator.variables);
    let mut base = vec![0.0; 2];
    for (row, wave) in main.iter().enumerate() {
        let value = |key: u32, [cos, sin]: [f64; 2]| {
            let (s, c) = (f64::from(key) * phi).sin_cos();
            (cos * c + sin * s) / operator.natural_force
        };
        base[row] = wave.base.iter().map(|(key, own)| value(*key, *own)).sum();
        for &(variable, key, part) in &wave.parts {
            columns[(row, variable)] += value(key, part);
        }
    }
    Member::Vector { base, columns }
}

/// A group of fixed vectors whose largest amount counts, measured against the natural force.
fn largest_of(
    operator: &Operator,
    criterion: Criterion,
    members: Vec<Member>,
    groups: &mut Vec<Group>,
) -> Judged {
    let nothing = vec![0.0; operator.variables];
    let amount = |member: &Member| member.summits(&operator.grid, &nothing, 0.0)[0].amount;
    let unbalanced = members.iter().map(amount).fold(0.0, f64::max);
    let unit = if unbalanced > 1e-7 { unbalanced } else { 1.0 };
    groups.push(Group::new(members.into_iter().map(|member| member.in_unit(unit)).collect()));
    let natural = operator.natural_force;
    let (scale, unbalanced) = (unit * natural, unbalanced * natural);
    Judged { criterion, groups: vec![(groups.len() - 1, 1.0)], largest: None, scale, unbalanced }
}

/// A group for each of `members`, whose amounts have this mean:
///
/// ```text
/// mean = SUM over j of w_j |F(theta_j)| / SUM of w_j        over the cycle and all loads together
/// ```
fn mean(
    operator: &Operator,
    criterion: Criterion,
    members: Vec<(f64, Member)>,
    groups: &mut Vec<Group>,
) -> Judged {
    let nothing = vec![0.0; operator.variables];
    let total: f64 = members.iter().map(|one| one.0).sum();
    let amount =
        |(weight, member): &(f64, Member)| weight * member.summits(&operator.grid, &nothing, 0.0)[0].amount;
    let unbalanced = members.iter().map(amount).sum::<f64>() / total.max(f64::MIN_POSITIVE);
    let unit = if unbalanced > 1e-7 { unbalanced } else { 1.0 };
    let first = groups.len();
    let weights: Vec<f64> = members.iter().map(|one| one.0 / total).collect();
    groups.extend(members.into_iter().map(|(_, member)| Group::new(vec![member.in_unit(unit)])));
    let natural = operator.natural_force;
    Judged {
        criterion,
        groups: (first..).zip(weights).collect(),
        largest: None,
        scale: unit * natural,
        unbalanced: unbalanced * natural,
    }
}

/// The largest of several means: a variable of its own that none of them passes, unless there is only one.
fn largest_mean(
    operator: &Operator,
    criterion: Criterion,
    mut all: Vec<Vec<(f64, Member)>>,
    groups: &mut Vec<Group>,
) -> Judged {
    let own = operator.largest.iter().find(|one| one.0 == criterion).map(|one| one.1);
    let Some(variable) = own else {
        return mean(operator, criterion, all.pop().unwrap_or_default(), groups);
    };
    let means: Vec<Judged> = all.into_iter().map(|one| mean(operator, criterion, one, groups)).collect();
    let (scale, unbalanced) =
        means.iter().fold((0.0f64, 0.0f64), |most, one| (most.0.max(one.scale), most.1.max(one.unbalanced)));
    let in_scale = |one: Judged| -> Vec<(usize, f64)> {
        one.groups.into_iter().map(|(group, share)| (group, share * one.scale / scale)).collect()
    };
    let sums = means.into_iter().map(in_scale).collect();
    let mut columns = Matrix::zeros(1, operator.variables);
    columns[(0, variable)] = 1.0;
    groups.push(Group::new(vec![Member::vector(columns)]));
    let largest = Some(LargestSum { variable, sums });
    Judged { criterion, groups: vec![(groups.len() - 1, 1.0)], largest, scale, unbalanced }
}

/// A sum over the amounts of all weights, each times its factor.
fn sum(
    criterion: Criterion,
    operator: &Operator,
    amounts: &[Vec<usize>],
    factor: impl Fn(usize) -> Result<f64, BalanceError>,
) -> Result<Judged, BalanceError> {
    let mut shares = Vec::new();
    for (weight, groups) in amounts.iter().enumerate() {
        let share = factor(weight)? * operator.weights[weight].unit;
        shares.extend(groups.iter().map(|&group| (group, share)));
    }
    let scale = shares.iter().map(|s| s.1).fold(0.0, f64::max);
    let scale = if scale > 0.0 { scale } else { 1.0 };
    shares.iter_mut().for_each(|s| s.1 /= scale);
    Ok(Judged { criterion, groups: shares, largest: None, scale, unbalanced: 0.0 })
}

/// One group for the amount of each corner of each weight, in units of the weight.
pub(crate) fn amounts(operator: &Operator, groups: &mut Vec<Group>) -> Vec<Vec<usize>> {
    let mut result = Vec::new();
    for weight in &operator.weights {
        let mut of_weight = Vec::new();
        for corner in &weight.corners {
            // On a line of phase the amount is that of one number.
            let rows = corner.terms.len();
            let mut columns = Matrix::zeros(rows, operator.variables);
            for (k, (variable, value)) in corner.terms.iter().enumerate() {
                if rows == 1 {
                    columns[(0, *variable)] = value.norm() / weight.unit;
                } else {
                    columns[(0, *variable)] = value.re / weight.unit;
                    columns[(1, *variable)] = value.im / weight.unit;
                }
                debug_assert!(k < 2, "invariant: a corner has one variable or two");
            }
            groups.push(Group::new(vec![Member::vector(columns)]));
            of_weight.push(groups.len() - 1);
        }
        result.push(of_weight);
    }
    result
}

/// Level of a group whether or not the programme judges it.
pub(crate) fn level(group: &Group, grid: &Grid, x: &[f64]) -> f64 {
    group.members.iter().map(|m| m.summits(grid, x, 0.0)[0].amount).fold(0.0, f64::max)
}
