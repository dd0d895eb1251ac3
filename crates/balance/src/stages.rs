//! Stage after stage, each without degrading the previous ones, and the lightest of what is left equal.
//!
//! Every optimum `x'` of a stage shares what the multipliers of one optimum `x` fix (complementarity):
//!
//! ```text
//! A_k (x' - x) = (t'_g - t_g) u_k    at every angle with a multiplier: the peak keeps its direction and its level
//! u_k A'_k (x' - x) = 0              and stays a peak
//! SUM c (t' - t) + p (x' - x) = 0    and every row with a price stays tight
//! ```
//! The next stage moves in the null space of these equations alone. What they leave open (other angles) is kept by a
//! row, a ten-thousand-millionth wider than the value reached.

use crate::convex::curve::Member;
use crate::convex::dense::{Matrix, RowFactors, add_scaled, norm};
use crate::convex::programme::{Programme, Row, Solution, UNSEEN};
use crate::convex::{Failure, GAP, better, proved, solve};
use crate::judged::Judged;
use crate::problem::Problem;
use lanchester_task::criterion_unit;

/// Share of the unbalanced load below which an optimum counts as vanishing.
const FLOOR: f64 = 1e-6;

/// Share of all moving masses' loads below which a load is rounding.
const ROUNDING: f64 = 1e-13;

/// Share of that rounding to which a proof goes all the same, if it can.
const TRIES: f64 = 1e-6;

/// How far a later stage may pass the value of an earlier one, relative to it.
const KEEPS: f64 = 1e-10;

/// Multipliers below this share of the group's weight fix nothing.
const NOISE: f64 = 1e-6;

/// Levels below this share of the unbalanced load vanish.
const VANISHES: f64 = 1e-10;

/// One stage's proof.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StageProof {
    /// Lower bound, in the unit of the stage.
    pub bound: f64,
    /// The least value that was reached, in the unit of the stage.
    pub least: f64,
    /// How far later stages may raise it, in the unit of the stage.
    pub allowed: f64,
    /// What a level of 1 is in the unit of the stage.
    pub scale: f64,
    /// Gap that was aimed at, in the unit of the stage.
    pub aim: f64,
    /// Largest gap that counts as closed, in the unit of the stage: what was aimed at, or rounding.
    pub target: f64,
    /// Solution in the coordinates of the stage.
    pub solution: Solution,
    /// Shadow price of every row of the problem: SI unit of the stage over the level of the row.
    pub prices: Vec<f64>,
}

/// Where the stages led.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reached {
    pub x: Vec<f64>,
    pub stages: Vec<StageProof>,
    /// What decided among equals, by its place in [`Problem::implied`].
    pub among_equals: Vec<(usize, StageProof)>,
}

/// All stages and the lightest answer. `Err`: the first stage has no solution.
pub(crate) fn run(problem: &Problem, solves: &mut usize) -> Result<Reached, Failure> {
    let mut walk = Walk::new(problem);
    for stage in 0..problem.stages.len() {
        walk.giving_stage(stage, solves)?;
    }
    Ok(walk.settle(solves))
}

/// An earlier stage that later ones hold: its value and how far it may be passed, in the unit of the stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Held {
    pub value: f64,
    pub slack: f64,
    /// Whether the stage is at its least wherever its choices are: then it is minimised again, and the later stages
    /// move where it does not change.
    pub exact: bool,
}

/// A point and the directions that are still open.
#[derive(Clone)]
pub(crate) struct Walk<'a> {
    problem: &'a Problem,
    /// The problem's programme with rows that keep what earlier stages reached.
    programme: Programme,
    pub x: Vec<f64>,
    /// Orthonormal columns.
    open: Matrix,
    pub proofs: Vec<StageProof>,
}

impl<'a> Walk<'a> {
    pub fn new(problem: &'a Problem) -> Walk<'a> {
        let equalities = RowFactors::of(&problem.operator.equalities, 1e-12);
        let (_, open) = equalities.bases();
        Walk {
            problem,
            programme: problem.programme.clone(),
            x: equalities.shortest(&problem.operator.equal_to),
            open,
            proofs: Vec::new(),
        }
    }

    /// A point that keeps the ties, and the directions that they leave open.
    pub fn start(self) -> (Vec<f64>, Matrix) {
        (self.x, self.open)
    }

    /// Holds an earlier stage of the problem.
    pub fn hold(&mut self, stage: usize, held: Held, solves: &mut usize) -> Result<(), Failure> {
        let terms = &self.problem.stages[stage];
        if held.exact {
            self.stage(terms, solves)?;
            let bound = self.proofs.last().map_or(f64::NEG_INFINITY, |proof| proof.bound);
            return if bound <= held.value + held.slack { Ok(()) } else { Err(Failure::Infeasible) };
        }
        let (cost, scale, _) = self.problem.cost(terms);
        self.programme.rows.push(Row {
            shares: cost.into_iter().enumerate().filter(|c| c.1 > 0.0).collect(),
            directions: vec![0.0; self.programme.variables],
            most: (held.value + held.slack) / scale,
        });
        Ok(())
    }

    /// A stage of the problem which later ones may raise by what it gives up: they move wherever it is not passed.
    fn giving_stage(&mut self, stage: usize, solves: &mut usize) -> Result<(), Failure> {
        let mut alone = self.clone();
        alone.stage(&self.problem.stages[stage], solves)?;
        let proof = alone.proofs.last_mut().ok_or(Failure::NoPoint)?;
        let allowed = self.problem.allowed(stage, proof.least);
        if allowed <= proof.target {
            *self = alone;
            return Ok(());
        }
        proof.allowed = allowed;
        let held = Held { value: proof.least, slack: allowed, exact: false };
        self.proofs = alone.proofs;
        self.hold_from(alone.x, stage, held, solves)
    }

    /// Holds an earlier stage, which `x` keeps.
    pub fn hold_from(
        &mut self,
        x: Vec<f64>,
        stage: usize,
        held: Held,
        solves: &mut usize,
    ) -> Result<(), Failure> {
        self.x = x;
        self.hold(stage, held, solves)
    }

    pub fn stage(&mut self, terms: &[(f64, Judged)], solves: &mut usize) -> Result<(), Failure> {
        let (cost, scale, unbalanced) = self.problem.cost(terms);
        // Loads that are rounding of what the single masses do count as nothing.
        let operator = &self.problem.operator;
        let natural = |(weight, judged): &(f64, Judged)| match criterion_unit(&judged.criterion) {
            "N" => weight * operator.natural_force,
            "N m" => weight * operator.natural_moment,
            // What the stages before leave open by rounding moves amounts by a ten-millionth of the natural ones.
            _ => 1e6 * weight * judged.scale,
        };
        let rounding = ROUNDING * terms.iter().map(natural).sum::<f64>() / scale;
        let loads = terms.iter().all(|t| t.1.groups.iter().all(|g| self.problem.is_load(g.0)));
        let floor = (FLOOR * unbalanced / scale).max(if loads { TRIES * rounding / GAP } else { 0.0 });
        self.programme.cost.clone_from(&cost);
        let (solution, prices) = self.minimise(floor, solves)?;
        let largest = solution.value.max(if loads { floor } else { FLOOR });
        let aim = 10.0 * GAP * largest * scale;
        self.proofs.push(StageProof {
            bound: solution.bound * scale,
            least: solution.value * scale,
            allowed: 0.0,
            scale,
            aim,
            target: aim.max(rounding * scale),
            prices: prices.iter().map(|p| p * scale).collect(),
            solution,
        });
        Ok(())
    }

    /// Minimises the present costs in the open directions, moves there and closes what the optimum fixes.
    fn minimise(&mut self, floor: f64, solves: &mut usize) -> Result<(Solution, Vec<f64>), Failure> {
        let (local, kept) = self.local()?;
        let (range, _) = RowFactors::of(&local.seen(), UNSEEN).bases();
        let small = local.restricted(&vec![0.0; local.variables], &range);
        let mut solution = match vanishing(&small, solves) {
            Some(solution) => solution,
            None => match idle_rows(&small, floor, solves) {
                Some(idle) if proved(&idle, GAP, floor) => idle,
                // What is proved without the rows holds with them.
                idle => match (idle, solve(&small, GAP, floor, solves)) {
                    (Some(idle), Ok(all)) => better(idle, all),
                    (Some(idle), Err(_)) => idle,
                    (None, all) => all?,
                },
            },
        };
        if let Some(bound) = self.bound_of_sums(&small, &kept, &solution, solves) {
            solution.bound = solution.bound.max(bound);
        }
        let step = range.times(&solution.x);
        let fixed = face(&local, &solution);
        let mut prices = vec![0.0; self.problem.programme.rows.len()];
        for (place, price) in kept.iter().zip(&solution.prices) {
            if let Some(to) = prices.get_mut(*place) {
                *to = *price;
            }
        }
        self.advance(&step);
        self.close(&fixed);
        let value = solution.value;
        let row = Row {
            shares: self.programme.cost.iter().copied().enumerate().filter(|c| c.1 > 0.0).collect(),
            directions: vec![0.0; self.programme.variables],
            most: value + KEEPS * value.abs().max(floor) + f64::EPSILON,
        };
        self.programme.rows.push(row);
        self.programme.cost.iter_mut().for_each(|c| *c = 0.0);
        Ok((solution, prices))
    }

    /// A bound where the largest of several sums is minimised, by one sum with the prices of their rows as weights:
    ///
    /// ```text
    /// max over s of m_s(x) >= SUM q_s m_s(x)        q_s >= 0, SUM q_s = 1
    /// ```
    /// An error of the weights costs its square.
    fn bound_of_sums(
        &self,
        small: &Programme,
        kept: &[usize],
        solution: &Solution,
        solves: &mut usize,
    ) -> Option<f64> {
        let row_of = |place: usize| self.problem.sums.iter().find(|one| one.0 == place).map(|one| one.1);
        let mut one = small.clone();
        for group in 0..small.groups.len() {
            let own = |place: &usize| row_of(*place) == Some(group);
            let prices = || {
                let places = kept.iter().zip(&solution.prices).enumerate();
                places.filter(|(_, (place, _))| own(place)).map(|(row, (_, price))| (row, price.max(0.0)))
            };
            let all: f64 = prices().map(|one| one.1).sum();
            let cost = std::mem::take(&mut one.cost[group]);
            if all <= 0.0 || cost <= 0.0 {
                one.cost[group] = cost;
                continue;
            }
            for (row, price) in prices() {
                for &(term, share) in &small.rows[row].shares {
                    one.cost[term] += cost * price / all * share;
                }
            }
        }
        if one.cost == small.cost {
            return None;
        }
        // What is left out holds nothing up: the bound stays one.
        let rows = small.rows.iter().zip(kept).filter(|(_, place)| row_of(**place).is_none());
        one.rows = rows.map(|(row, _)| row.clone()).collect();
        crate::infeasible::reduced(&one, solves).ok().map(|found| found.bound)
    }

    fn advance(&mut self, step: &[f64]) {
        let change = self.open.times(step);
        for (x, change) in self.x.iter_mut().zip(&change) {
            *x += change;
        }
    }

    fn close(&mut self, free: &Matrix) {
        self.open = self.open.product(free);
    }

    /// The programme in the open directions, without rows that these do not touch, and the places of those kept.
    fn local(&self) -> Result<(Programme, Vec<usize>), Failure> {
        let mut local = self.programme.restricted(&self.x, &self.open);
        let touched: Vec<bool> = local.groups.iter().map(|g| g.moves()).collect();
        let mut kept = Vec::new();
        let mut rows = Vec::new();
        let zero = vec![0.0; local.variables];
        for (place, row) in local.rows.iter().enumerate() {
            let moved =
                row.shares.iter().any(|s| touched[s.0]) || row.directions.iter().any(|h| h.abs() > UNSEEN);
            if moved {
                kept.push(place);
                rows.push(row.clone());
                continue;
            }
            let level = |group: usize| crate::criterion::level(&local.groups[group], &local.grid, &zero);
            let sum: f64 = row.shares.iter().map(|&(g, share)| share * level(g)).sum();
            if sum - row.most > 10.0 * self.programme.holds * row.most.abs().max(1.0) {
                return Err(Failure::Infeasible);
            }
        }
        local.rows = rows;
        Ok((local, kept))
    }

    /// Decides among equals: by the loads that the task does not name, then by the weights.
    pub fn settle(mut self, solves: &mut usize) -> Reached {
        let stages = std::mem::take(&mut self.proofs);
        let mut among_equals = Vec::new();
        for (place, terms) in self.problem.implied.iter().enumerate() {
            let local = self.programme.restricted(&self.x, &self.open);
            if !terms.iter().flat_map(|t| &t.1.groups).any(|g| local.groups[g.0].moves()) {
                continue;
            }
            // What was asked stands whether or not this has a solution.
            if self.stage(terms, solves).is_err() {
                self.programme.cost.iter_mut().for_each(|c| *c = 0.0);
                break;
            }
            among_equals.extend(self.proofs.pop().map(|proof| (place, proof)));
        }
        self.lighten(solves);
        Reached { x: self.x, stages, among_equals }
    }

    /// Among equals the lightest: the sums that every load sees stay exactly as they are.
    fn lighten(&mut self, solves: &mut usize) {
        if self.problem.operator.weights.is_empty() {
            return;
        }
        // Open directions are known to the accuracy of the optima behind them only; of loads that do not change nothing
        // is given up, so that all directions count again, unless the stages judge amounts.
        let judged: Vec<&Judged> = self.problem.judged().collect();
        let amounts = judged.iter().any(|j| j.groups.iter().any(|g| !self.problem.is_load(g.0)));
        let start = if amounts { self.open.clone() } else { Walk::new(self.problem).open };
        let whole = self.problem.programme.restricted(&self.x, &start);
        let mut seen = Matrix::zeros(0, start.columns);
        for group in judged.iter().flat_map(|j| j.seen()).filter(|group| self.problem.is_load(*group)) {
            whole.groups[group].add_directions(&mut seen);
        }
        let (_, free) = RowFactors::of(&seen, UNSEEN).bases();
        if free.columns == 0 {
            return;
        }
        self.open = start.product(&free);
        let factors: Vec<f64> = self.lightness();
        for (groups, factor) in self.problem.amounts.iter().zip(factors) {
            groups.iter().for_each(|&group| self.programme.cost[group] = factor);
        }
        // The answer is as good without it: a failure here leaves an arbitrary split.
        let _ = self.minimise(0.0, solves);
    }

    /// Cost of a unit of each weight.
    fn lightness(&self) -> Vec<f64> {
        let units = self.problem.operator.weights.iter().map(|w| w.unit);
        let costs: Vec<f64> = match &self.problem.radii {
            Some(radii) => units.zip(radii).map(|(unit, radius)| unit / radius).collect(),
            None => units.collect(),
        };
        let largest = costs.iter().copied().fold(0.0, f64::max);
        costs.iter().map(|c| c / largest).collect()
    }
}

/// A basis of the directions in which every optimum lies.
fn face(programme: &Programme, solution: &Solution) -> Matrix {
    let (n, groups) = (programme.variables, programme.groups.len());
    let mut rows = Matrix::zeros(0, n + groups);
    let mut line = vec![0.0; n + groups];
    // Levels are counted in the reach of their group, and every row by its largest number.
    let mut fix = |directions: &[f64], levels: &[(usize, f64)], reach: f64| {
        line.fill(0.0);
        line[..n].copy_from_slice(directions);
        levels.iter().for_each(|&(group, factor)| line[n + group] += factor * programme.groups[group].reach);
        let size = line.iter().fold(reach, |a, b| a.max(b.abs()));
        line.iter_mut().for_each(|value| *value /= size);
        rows.push(&line);
    };
    let terms = programme.terms_of_a_mean();
    let mut followers: Vec<Option<Vec<f64>>> = vec![None; groups];
    for one in &solution.support {
        let weight = programme.weight(one.group, &solution.prices);
        let size = norm(&one.y);
        let member = &programme.groups[one.group].members[one.member];
        if size <= NOISE * weight || weight <= NOISE || solution.levels[one.group] <= VANISHES {
            continue;
        }
        let reach = programme.groups[one.group].reach;
        let directions = member.directions(one.angle);
        if terms[one.group] {
            // Its level follows the variables: only what is across it is fixed.
            let mut along = vec![0.0; n];
            directions.add_transposed(&one.y, 1.0 / size, &mut along);
            for m in 0..directions.rows {
                let mut across = directions.row(m).to_vec();
                add_scaled(&mut across, -one.y[m] / size, &along);
                fix(&across, &[], reach);
            }
            followers[one.group] = Some(along);
            continue;
        }
        for m in 0..directions.rows {
            fix(directions.row(m), &[(one.group, -one.y[m] / size)], reach);
        }
        if let Member::Curve(curve) = member {
            let (_, slope) = curve.directions(one.angle);
            let mut along = vec![0.0; n];
            slope.add_transposed(&one.y, 1.0 / size, &mut along);
            fix(&along, &[], reach);
        }
    }
    for group in 0..groups {
        if programme.weight(group, &solution.prices) > NOISE && solution.levels[group] <= VANISHES {
            for columns in programme.groups[group].members.iter().map(Member::columns) {
                (0..columns.rows).for_each(|i| fix(columns.row(i), &[], programme.groups[group].reach));
            }
            fix(&vec![0.0; n], &[(group, 1.0)], programme.groups[group].reach);
        }
    }
    let costs: Vec<(usize, f64)> = programme.cost.iter().copied().enumerate().filter(|c| c.1 > 0.0).collect();
    let mut kept = |directions: &[f64], shares: &[(usize, f64)]| {
        let mut directions = directions.to_vec();
        let mut own: Vec<(usize, f64)> = Vec::new();
        for &(group, share) in shares {
            match &followers[group] {
                Some(along) => add_scaled(&mut directions, share, along),
                None => own.push((group, share)),
            }
        }
        // What follows adds up to rounding where the costs are least.
        if !followers.iter().all(Option::is_none) && own.is_empty() {
            return;
        }
        fix(&directions, &own, f64::MIN_POSITIVE);
    };
    kept(&programme.linear, &costs);
    for (row, price) in programme.rows.iter().zip(&solution.prices) {
        if *price > NOISE {
            kept(&row.directions, &row.shares);
        }
    }
    let (_, free) = RowFactors::of(&rows, 1e-8).bases();
    let moves = Matrix::from_rows(free.columns, (0..n).map(|j| free.row(j)));
    let (range, _) = RowFactors::of(&moves.transposed(), 1e-8).bases();
    range
}

/// The optimum without any row, if a point near it holds all rows.
///
/// Most limits and largest amounts are wide enough not to matter; without them fewer directions are seen.
fn idle_rows(programme: &Programme, floor: f64, solves: &mut usize) -> Option<Solution> {
    let loads = |g: usize| programme.groups[g].members.iter().all(|m| matches!(m, Member::Curve(_)));
    if programme.rows.is_empty() || !(0..programme.groups.len()).all(|g| programme.cost[g] == 0.0 || loads(g))
    {
        return None;
    }
    let free = Programme { rows: Vec::new(), ..programme.clone() };
    let (range, _) = RowFactors::of(&free.seen(), UNSEEN).bases();
    let small = free.restricted(&vec![0.0; free.variables], &range);
    let mut solution = solve(&small, GAP, floor, solves).ok()?;
    solution.x = range.times(&solution.x);
    if programme.violation(&solution.x, &programme.levels(&solution.x)) > 0.0 {
        let open = face(&free, &solution);
        let inside = programme.restricted(&solution.x, &open);
        let step = crate::infeasible::closest_inside(&inside, solves)?;
        let step = open.times(&step);
        solution.x = solution.x.iter().zip(&step).map(|(x, s)| x + s).collect();
    }
    solution.levels = programme.levels(&solution.x);
    let value = programme.value(&solution.x, &solution.levels);
    let holds = programme.violation(&solution.x, &solution.levels) <= programme.holds;
    if !holds {
        return None;
    }
    solution.value = value;
    solution.prices = vec![0.0; programme.rows.len()];
    Some(solution)
}

/// Whether the costs can be made to vanish, and where.
fn vanishing(programme: &Programme, solves: &mut usize) -> Option<Solution> {
    let mut columns = Matrix::zeros(0, programme.variables);
    let mut right = Vec::new();
    // What nothing may pass does not vanish while the loads below it stay.
    let passed =
        |row: &Row| row.most == 0.0 && !row.shares.is_empty() && row.directions.iter().any(|h| *h < 0.0);
    if programme.linear.iter().any(|p| *p != 0.0) || programme.rows.iter().any(passed) {
        return None;
    }
    for (group, _) in programme.cost.iter().enumerate().filter(|c| *c.1 > 0.0) {
        for member in &programme.groups[group].members {
            let seen = member.columns();
            match member {
                Member::Curve(curve) if curve.untouched() > 1e-14 => return None,
                Member::Curve(curve) => right.extend(curve.touched_coefficients().iter().map(|c| -c)),
                Member::Vector { base, .. } => right.extend(base.iter().map(|c| -c)),
            }
            (0..seen.rows).for_each(|i| columns.push(seen.row(i)));
        }
    }
    let factors = RowFactors::of(&columns, UNSEEN);
    let mut x = crate::convex::dense::least_squares(&columns, &right, UNSEEN);
    let solved = |x: &[f64]| {
        columns.times(x).iter().zip(&right).all(|(a, b)| (a - b).abs() <= 1e-14 * programme.variables as f64)
    };
    if !solved(&x) {
        return None;
    }
    let levels = programme.levels(&x);
    if programme.violation(&x, &levels) > programme.holds {
        // Somewhere else in the directions that keep the costs at nothing, if anywhere.
        let (_, free) = factors.bases();
        let inside = programme.restricted(&x, &free);
        let step = crate::infeasible::closest_inside(&inside, solves)?;
        x = x.iter().zip(free.times(&step)).map(|(x, s)| x + s).collect();
    }
    let levels = programme.levels(&x);
    (programme.violation(&x, &levels) <= programme.holds).then(|| Solution {
        value: programme.value(&x, &levels),
        bound: programme.offset,
        levels,
        x,
        support: Vec::new(),
        prices: vec![0.0; programme.rows.len()],
    })
}
