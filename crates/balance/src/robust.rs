//! Weights for a production: the worst of sampled engines, or the mean of the worst share of them, is minimised.
//!
//! ```text
//! v_s(x) = peak of the load of sample s        the devices do the same in every sample, its own loads differ
//! worst:              minimise max over s of v_s(x)
//! mean of the worst:  minimise t + 1/k SUM e_s      with  v_s(x) - t <= e_s,  0 <= e_s        (k of n samples)
//! bound:              SUM q_s v_s(x) <= mean of the k largest     for all 0 <= q_s <= 1/k, SUM q_s <= 1
//! ```
//! Samples are rows only where they are among the worst of some answer: those that are missing are added until none is. The bound
//! is that of a cone programme of its own, with the multipliers of the samples as the weights q of a sum.
//!
//! Source: Rockafellar and Uryasev, "Optimization of conditional value-at-risk", Journal of Risk 2 (2000), theorem 1.

use crate::answer::Answer;
use crate::branch;
use crate::check::check;
use crate::convex::curve::Member;
use crate::convex::dense::Matrix;
use crate::convex::programme::{Group, Programme, Row};
use crate::criterion::{level, vectors};
use crate::error::BalanceError;
use crate::fitted::bare;
use crate::infeasible::reduced;
use crate::judged::Judged;
use crate::operator::{Operator, middle};
use crate::optimum::found::with_devices;
use crate::problem::Problem;
use crate::stages::{Walk, run};
use crate::wave::curve;
use lanchester_mechanism::Kinematics;
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Criterion, Limit, Load, criterion_unit};
use serde::Serialize;

/// Version of [`RobustAnswer`]; raised when a field changes its meaning or goes.
pub const ROBUST_VERSION: u32 = 1;

/// Most rounds in which samples become rows.
const MOST_ROUNDS: usize = 40;

/// Samples that are rows to begin with, for each of those that count.
const FIRST: usize = 2;

/// How far a later stage may pass the measure or a stage before it, and a sample a limit, as a share of it.
const KEEPS: f64 = 1e-6;

/// Resamplings behind the standard error.
const RESAMPLINGS: usize = 400;

/// What of the samples is minimised.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RobustMeasure {
    /// The largest.
    Worst,
    /// The mean of this share of them, the largest ones: at least one sample.
    MeanOfWorst(f64),
}

/// Sampled engines, and what of them counts.
#[derive(Debug, Clone, Copy)]
pub struct RobustRequest<'a> {
    /// Engines that are optimised for; they differ from the engine of the task in masses, lengths, places and directions alone.
    pub samples: &'a [Engine],
    /// Others, drawn independently, on which the answer is judged anew; may be none.
    pub second: &'a [Engine],
    /// What of them is minimised.
    pub measure: RobustMeasure,
    /// Seed of the resampling behind the standard error.
    pub seed: u64,
}

/// The best weights for sampled engines.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RobustAnswer {
    /// [`ROBUST_VERSION`].
    pub version: u32,
    /// The devices, and what they do to the engine as it is meant.
    pub answer: Answer,
    /// What is judged of every sample.
    pub criterion: Criterion,
    /// Its SI unit.
    pub unit: String,
    /// What of the samples is minimised.
    pub measure: RobustMeasure,
    /// Samples, and how many of them, the largest, are averaged.
    pub samples: usize,
    /// How many of them, the largest, are averaged.
    pub averaged: usize,
    /// Seed of samples and resampling.
    pub seed: u64,
    /// The measure of the samples.
    pub value: f64,
    /// The measure before stages behind the first took what it gives up.
    pub least: f64,
    /// No weights that hold the limits bring the measure of these samples below this.
    pub lower_bound: f64,
    /// Stages behind the first, minimised on the engine as it is meant.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub later: Vec<RobustStage>,
    /// The limits, which hold for the engine as it is meant.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<RobustLimit>,
    /// Standard error of the value by resampling the samples (bootstrap); of the worst it tells little.
    pub standard_error: f64,
    /// The measure of an independent second set of samples, if there is one: free of having been optimised for.
    pub second_value: Option<f64>,
    /// Samples of the second set.
    pub second_samples: usize,
    /// The measure of the first samples with the weights that are best for the engine as it is meant.
    pub ordinary: f64,
    /// The criterion of the engine as it is meant, with these weights.
    pub nominal: f64,
    /// The same with the weights that are best for it.
    pub ordinary_nominal: f64,
    /// Cone programmes solved.
    pub solves: usize,
}

/// A stage behind the first.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RobustStage {
    /// Its criteria.
    pub criteria: Vec<Criterion>,
    /// Its value on the engine as it is meant, weighted as the task says.
    pub value: f64,
    /// No weights that keep the stages before it and the limits go below this.
    pub lower_bound: f64,
}

/// A limit, which holds for the engine as it is meant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RobustLimit {
    /// What is limited.
    pub criterion: Criterion,
    /// Its largest value.
    pub most: f64,
    /// What the engine as it is meant has.
    pub nominal: f64,
    /// The largest of the samples, for peaks of loads.
    pub worst: Option<f64>,
    /// How many samples pass the limit, for peaks of loads.
    pub beyond: Option<usize>,
}

/// Finds the weights of `task` that minimise the measure of its first stage over sampled engines, then its other stages on the engine as it
/// is meant, each keeping those before it but for what they give up. Limits hold for the engine as it is meant.
///
/// # Errors
/// [`BalanceError`] as [`crate::optimise`]; [`BalanceError::Unsuited`] where the task has choices, orders to cancel, limits that cannot
/// hold, loads over the range of speeds, or a first criterion without a peak; where there is no sample.
///
/// # Source
/// Book, "The optimum and its proof", "A production of engines".
pub fn optimise_robust(
    engine: &Engine,
    task: &BalanceTask,
    request: &RobustRequest<'_>,
) -> Result<RobustAnswer, BalanceError> {
    optimise_robust_while(engine, task, request, &|| true)
}

/// As [`optimise_robust`], as long as `goes_on` says so: it is asked between samples and between cone programmes.
///
/// # Errors
/// As [`optimise_robust`]; [`BalanceError::BrokenOff`] where it no longer goes on.
pub fn optimise_robust_while(
    engine: &Engine,
    task: &BalanceTask,
    request: &RobustRequest<'_>,
    goes_on: &dyn Fn() -> bool,
) -> Result<RobustAnswer, BalanceError> {
    let check_on = || if goes_on() { Ok(()) } else { Err(BalanceError::BrokenOff) };
    check(engine, task)?;
    let criterion = suits(engine, task, request)?;
    let operator = Operator::new(&bare(engine, task), task, Kinematics::Exact, &middle(engine, task))?;
    let problem = Problem::new(engine, task, operator)?;
    let mut solves = 0;
    let ordinary = run(&problem, &mut solves).map_err(|_| {
        let hint = "relax the limits: they hold for the engine as it is meant";
        unsuited("limits that can hold together", "some that cannot".into(), hint)
    })?;
    let samples = Samples::of(&problem, task, criterion, request.samples, goes_on)?;
    let count = samples.groups.len();
    let averaged = match request.measure {
        RobustMeasure::Worst => 1,
        RobustMeasure::MeanOfWorst(share) => ((share * count as f64).round() as usize).clamp(1, count),
    };
    let search = Search { problem: &problem, samples: &samples, averaged, goes_on };
    let (best, bound) = search.best(&ordinary.x, &mut solves);
    check_on()?;
    let least = mean_of_largest(&samples.values(&best), averaged);
    let scale = samples.scale;
    let (x, later) =
        later_stages(&search, &best, least, &mut solves).or_else(|error| check_on().and(Err(error)))?;
    let values = samples.values(&x);
    let value = mean_of_largest(&values, averaged);
    let second = Samples::of(&problem, task, criterion, request.second, goes_on)?;
    let second_averaged = (averaged * second.groups.len()).div_ceil(count).max(1);
    let judged = &problem.stages[0][0].1;
    Ok(RobustAnswer {
        version: ROBUST_VERSION,
        answer: with_devices(engine, task, Kinematics::Exact, &problem, &x)?,
        criterion,
        unit: criterion_unit(&criterion).into(),
        measure: request.measure,
        samples: count,
        averaged,
        seed: request.seed,
        value: scale * value,
        least: scale * least,
        lower_bound: scale * bound.min(least),
        later,
        limits: limits(&problem, task, request.samples, &x, goes_on)?,
        standard_error: scale * standard_error(&values, averaged, request.seed),
        second_value: (!second.groups.is_empty())
            .then(|| scale * mean_of_largest(&second.values(&x), second_averaged)),
        second_samples: second.groups.len(),
        ordinary: scale * mean_of_largest(&samples.values(&ordinary.x), averaged),
        nominal: problem.value(judged, &x),
        ordinary_nominal: problem.value(judged, &ordinary.x),
        solves,
    })
}

/// Minimises the stages behind the first on the engine as it is meant, while the measure rises by no more than the first gives up.
fn later_stages(
    search: &Search<'_>,
    best: &[f64],
    least: f64,
    solves: &mut usize,
) -> Result<(Vec<f64>, Vec<RobustStage>), BalanceError> {
    let (problem, scale) = (search.problem, search.samples.scale);
    let (mut x, mut found, mut kept) = (best.to_vec(), Vec::new(), Vec::new());
    let most = |stage: usize, least: f64| least + problem.allowed(stage, least).max(KEEPS * least);
    let held = most(0, scale * least) / scale;
    for (stage, terms) in problem.stages.iter().enumerate().skip(1) {
        let (cost, unit, _) = problem.cost(terms);
        let (next, bound) = search.later(terms, held, &kept, &x, solves).ok_or_else(|| {
            let hint = "name fewer stages, or let the first give up more";
            unsuited("stages that can be minimised one after another", "one that could not".into(), hint)
        })?;
        let value = |x: &[f64]| terms.iter().map(|(w, judged)| w * problem.value(judged, x)).sum::<f64>();
        x = next;
        let shares: Vec<(usize, f64)> = cost.into_iter().enumerate().filter(|one| one.1 > 0.0).collect();
        kept.push(Row { shares, directions: Vec::new(), most: most(stage, value(&x)) / unit });
        found.push(RobustStage {
            criteria: terms.iter().map(|(_, judged)| judged.criterion).collect(),
            value: value(&x),
            lower_bound: (unit * bound).min(value(&x)),
        });
    }
    // Later stages may have raised earlier ones by what these gave up.
    for (stage, terms) in found.iter_mut().zip(problem.stages.iter().skip(1)) {
        stage.value = terms.iter().map(|(w, judged)| w * problem.value(judged, &x)).sum();
    }
    Ok((x, found))
}

/// What the limits have on the engine as it is meant and, where they are about peaks of loads, on the samples.
fn limits(
    problem: &Problem,
    task: &BalanceTask,
    engines: &[Engine],
    x: &[f64],
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<RobustLimit>, BalanceError> {
    let of_one = |(limit, judged): (&Limit, &Judged)| {
        let is_peak = matches!(limit.criterion, Criterion::Peak(load) | Criterion::Order(load, _) if load != Load::BendingMoment);
        let worst = match is_peak {
            true => {
                let samples = Samples::of(problem, task, limit.criterion, engines, goes_on)?;
                let values = samples.values(x).into_iter().map(|level| samples.scale * level);
                Some(values.collect::<Vec<f64>>())
            }
            false => None,
        };
        let beyond = worst
            .as_ref()
            .map(|values| values.iter().filter(|value| **value > limit.most * (1.0 + KEEPS)).count());
        Ok(RobustLimit {
            criterion: limit.criterion,
            most: limit.most,
            nominal: problem.value(judged, x),
            worst: worst.map(|values| values.into_iter().fold(0.0, f64::max)),
            beyond,
        })
    };
    task.limits.iter().zip(&problem.limits).map(of_one).collect()
}

fn unsuited(needed: &'static str, got: String, hint: &'static str) -> BalanceError {
    BalanceError::Unsuited { method: "an optimum over samples", needed, got, hint }
}

/// What to ask for.
const ONE_LOAD: &str =
    "name one load first, such as force; what comes after it is minimised on the engine as it is meant";

/// The criterion of a task that samples can be judged by.
fn suits(
    engine: &Engine,
    task: &BalanceTask,
    request: &RobustRequest<'_>,
) -> Result<Criterion, BalanceError> {
    if request.samples.is_empty() {
        return Err(unsuited("at least one sample", "none".into(), "draw some engines"));
    }
    if let RobustMeasure::MeanOfWorst(share) = request.measure
        && !(share > 0.0 && share <= 1.0)
    {
        let hint = "0.05 is the mean of the worst 5 %";
        return Err(unsuited("a share of the worst above 0 and up to 1", format!("{share}"), hint));
    }
    if branch::is_needed(task) {
        // A bound of the nominal engine says nothing of the samples, whose loads differ with every choice.
        return Err(unsuited(
            "devices without choices: each choice would have to be proved on every sample",
            "places, amounts or devices to be chosen".into(),
            "choose without it first, and ask again with what was chosen",
        ));
    }
    if !task.cancel.is_empty() {
        let hint = "minimise instead: what vanishes on one engine does not vanish on another";
        return Err(unsuited("something to minimise", "orders to cancel".into(), hint));
    }
    let over_speed = |criterion: &Criterion| {
        let on_springs = |load: Load| load.is_at_mounts() && engine.is_on_springs();
        criterion.counts_gas()
            || matches!(criterion, Criterion::Peak(load) | Criterion::Order(load, _) if on_springs(*load))
    };
    let later = task.stages.iter().skip(1).flat_map(|stage| &stage.terms).map(|term| term.1);
    if later.chain(task.limits.iter().map(|limit| limit.criterion)).any(|one| over_speed(&one)) {
        return Err(unsuited(
            "limits and later stages at the highest speed",
            "a force at mounts on springs, or a load with gas".into(),
            "leave it out: these are judged over the range of speeds",
        ));
    }
    let first = task.stages.first().map_or(&[][..], |stage| &stage.terms);
    match first {
        [(_, criterion @ (Criterion::Peak(load) | Criterion::Order(load, _)))]
            if *load != Load::BendingMoment && !load.is_at_mounts() =>
        {
            Ok(*criterion)
        }
        _ => Err(unsuited(
            "the peak of a load on the block or of a main bearing",
            "another criterion".into(),
            ONE_LOAD,
        )),
    }
}

/// The load of every sample as a group of the variables of the problem.
struct Samples {
    groups: Vec<Group>,
    /// What a level of 1 is in the unit of the criterion.
    scale: f64,
    grid: std::rc::Rc<crate::convex::curve::Grid>,
}

impl Samples {
    fn of(
        problem: &Problem,
        task: &BalanceTask,
        criterion: Criterion,
        engines: &[Engine],
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Samples, BalanceError> {
        let scale = problem.stages[0][0].1.scale;
        let grid = std::rc::Rc::clone(&problem.operator.grid);
        let mut groups = Vec::new();
        for engine in engines {
            if !goes_on() {
                return Err(BalanceError::BrokenOff);
            }
            let places = middle(engine, task);
            let operator = Operator::new(&bare(engine, task), task, Kinematics::Exact, &places)?;
            // A variable means the same unbalance in every sample.
            let mut stretch = vec![1.0; operator.variables];
            for (own, nominal) in operator.weights.iter().zip(&problem.operator.weights) {
                for (variable, _) in own.corners.iter().flat_map(|corner| &corner.terms) {
                    stretch[*variable] = nominal.unit / own.unit;
                }
            }
            let (load, order) = match criterion {
                Criterion::Order(load, order) => (load, Some(order)),
                Criterion::Peak(load) => (load, None),
                _ => return Err(unsuited("the peak of a load", "another criterion".into(), ONE_LOAD)),
            };
            let (vectors, _) = vectors(engine, &operator, load)?;
            let key = order.map(|order| (order * f64::from(operator.grid.revolutions)).round() as u32);
            let member = |waves: &Vec<crate::wave::Wave>| {
                let own: Vec<crate::wave::Wave> = waves
                    .iter()
                    .map(|wave| {
                        let mut wave = key.map_or_else(|| wave.clone(), |key| wave.only(key));
                        for (variable, _, part) in &mut wave.parts {
                            part.iter_mut().for_each(|value| *value *= stretch[*variable]);
                        }
                        wave
                    })
                    .collect();
                Member::Curve(curve(&own, scale, operator.variables, &grid))
            };
            groups.push(Group::new(vectors.iter().map(member).collect()));
        }
        Ok(Samples { groups, scale, grid })
    }

    /// Level of every sample.
    fn values(&self, x: &[f64]) -> Vec<f64> {
        self.groups.iter().map(|group| level(group, &self.grid, x)).collect()
    }
}

/// A programme over some of the samples.
struct SampleProgramme {
    programme: Programme,
    /// Point and directions of the variables.
    origin: Vec<f64>,
    wider: Matrix,
    /// Row of the first sample.
    first: usize,
    /// The measure of the samples in terms of the variables.
    measure: Vec<f64>,
}

impl SampleProgramme {
    /// The variables of the problem at a solution.
    fn point(&self, z: &[f64]) -> Vec<f64> {
        self.origin.iter().zip(self.wider.times(z)).map(|(x, step)| x + step).collect()
    }
}

struct Search<'a> {
    problem: &'a Problem,
    samples: &'a Samples,
    averaged: usize,
    goes_on: &'a dyn Fn() -> bool,
}

impl Search<'_> {
    /// The best point, and what no point goes below [level].
    fn best(&self, start: &[f64], solves: &mut usize) -> (Vec<f64>, f64) {
        let value = |x: &[f64]| mean_of_largest(&self.samples.values(x), self.averaged);
        let (mut best, mut least) = (start.to_vec(), value(start));
        let mut bound = 0.0f64;
        let mut rows = largest(&self.samples.values(start), FIRST * self.averaged);
        for _ in 0..MOST_ROUNDS {
            if !(self.goes_on)() {
                break;
            }
            let Some((x, weights)) = self.over(&rows, solves) else { break };
            if value(&x) < least {
                (least, best) = (value(&x), x.clone());
            }
            bound = bound.max(self.bound(&rows, &weights, solves));
            let before = rows.len();
            for sample in largest(&self.samples.values(&x), self.averaged) {
                if !rows.contains(&sample) {
                    rows.push(sample);
                }
            }
            if rows.len() == before {
                break;
            }
        }
        (best, bound)
    }

    /// The base in the directions that ties leave open, with `extra` variables behind that nothing sees yet.
    fn open(&self, extra: usize) -> (Programme, Vec<f64>, Matrix) {
        let walk = Walk::new(self.problem);
        let (origin, open) = walk.start();
        let mut wider = Matrix::zeros(open.rows, open.columns + extra);
        for i in 0..open.rows {
            wider.row_mut(i)[..open.columns].copy_from_slice(open.row(i));
        }
        (self.problem.programme.restricted(&origin, &wider), origin, wider)
    }

    /// The programme with some of the samples: behind the variables stand the threshold and, for a mean, what each sample has above it.
    fn with_samples(&self, rows: &[usize]) -> SampleProgramme {
        let worst = self.averaged == 1;
        let extra = if worst { 1 } else { 1 + rows.len() };
        let (mut programme, origin, wider) = self.open(extra);
        let own = wider.columns - extra;
        programme.cost.iter_mut().for_each(|cost| *cost = 0.0);
        let first = programme.rows.len();
        for (number, &sample) in rows.iter().enumerate() {
            programme.groups.push(restricted(&self.samples.groups[sample], &origin, &wider));
            programme.cost.push(0.0);
            let mut directions = vec![0.0; wider.columns];
            directions[own] = -1.0;
            if !worst {
                directions[own + 1 + number] = -1.0;
            }
            let shares = vec![(programme.groups.len() - 1, 1.0)];
            programme.rows.push(Row { shares, directions, most: 0.0 });
        }
        let mut measure = vec![0.0; wider.columns];
        measure[own] = 1.0;
        for variable in own..wider.columns {
            let mut directions = vec![0.0; wider.columns];
            directions[variable] = -1.0;
            programme.rows.push(Row { shares: Vec::new(), directions, most: 0.0 });
            if variable > own {
                measure[variable] = 1.0 / self.averaged as f64;
            }
        }
        SampleProgramme { programme, origin, wider, first, measure }
    }

    /// The optimum over some of the samples, the others not counted, and the multiplier of each.
    fn over(&self, rows: &[usize], solves: &mut usize) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut asked = self.with_samples(rows);
        asked.programme.linear.clone_from(&asked.measure);
        let solution = reduced(&asked.programme, solves).ok()?;
        let prices = solution.prices[asked.first..asked.first + rows.len()].to_vec();
        Some((asked.point(&solution.x), prices))
    }

    /// The least of a later stage, on the engine as it is meant, while the measure stays at most at `held` and later stages before it
    /// keep their rows; also what no point goes below [level of the stage].
    fn later(
        &self,
        terms: &[(f64, Judged)],
        held: f64,
        kept: &[Row],
        start: &[f64],
        solves: &mut usize,
    ) -> Option<(Vec<f64>, f64)> {
        let (cost, ..) = self.problem.cost(terms);
        let mut rows = largest(&self.samples.values(start), FIRST * self.averaged);
        for _ in 0..MOST_ROUNDS {
            if !(self.goes_on)() {
                return None;
            }
            let mut asked = self.with_samples(&rows);
            asked.programme.cost[..cost.len()].copy_from_slice(&cost);
            let nothing = vec![0.0; asked.wider.columns];
            let keep = |row: &Row| Row { directions: nothing.clone(), ..row.clone() };
            asked.programme.rows.extend(kept.iter().map(keep));
            let directions = asked.measure.clone();
            asked.programme.rows.push(Row { shares: Vec::new(), directions, most: held });
            let solution = reduced(&asked.programme, solves).ok()?;
            let x = asked.point(&solution.x);
            let values = self.samples.values(&x);
            let before = rows.len();
            if mean_of_largest(&values, self.averaged) > held * (1.0 + KEEPS) {
                for sample in largest(&values, self.averaged) {
                    if !rows.contains(&sample) {
                        rows.push(sample);
                    }
                }
            }
            if rows.len() == before {
                return Some((x, solution.bound));
            }
        }
        None
    }

    /// What no point goes below, by a sum of samples with these weights [level].
    fn bound(&self, rows: &[usize], weights: &[f64], solves: &mut usize) -> f64 {
        let most = 1.0 / self.averaged as f64;
        let sum: f64 = weights.iter().map(|weight| weight.max(0.0)).sum();
        if sum <= 0.0 {
            return 0.0;
        }
        let (mut programme, origin, wider) = self.open(0);
        programme.cost.iter_mut().for_each(|cost| *cost = 0.0);
        for (&sample, weight) in rows.iter().zip(weights) {
            programme.groups.push(restricted(&self.samples.groups[sample], &origin, &wider));
            programme.cost.push((weight.max(0.0) / sum).min(most));
        }
        reduced(&programme, solves).map_or(0.0, |solution| solution.bound)
    }
}

fn restricted(group: &Group, origin: &[f64], directions: &Matrix) -> Group {
    let members = group.members.iter().map(|member| member.restricted(origin, directions)).collect();
    Group { members, reach: group.reach }
}

/// The numbers of the `count` largest values, the largest first.
fn largest(values: &[f64], count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    order.truncate(count);
    order
}

/// Mean of the `count` largest values.
fn mean_of_largest(values: &[f64], count: usize) -> f64 {
    let chosen = largest(values, count);
    chosen.iter().map(|&place| values[place]).sum::<f64>() / chosen.len().max(1) as f64
}

/// Standard deviation of the mean of the largest over resamplings with replacement.
fn standard_error(values: &[f64], averaged: usize, seed: u64) -> f64 {
    let mut state = seed;
    // SplitMix64 (Steele, Lea and Flood 2014).
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    };
    let count = values.len();
    let means: Vec<f64> = (0..RESAMPLINGS)
        .map(|_| {
            let drawn: Vec<f64> = (0..count).map(|_| values[(next() % count as u64) as usize]).collect();
            mean_of_largest(&drawn, averaged)
        })
        .collect();
    let mean = means.iter().sum::<f64>() / RESAMPLINGS as f64;
    let square: f64 = means.iter().map(|value| (value - mean).powi(2)).sum();
    (square / (RESAMPLINGS - 1) as f64).sqrt()
}
