//! The convex programme of a box of choices: nothing that the box allows is lost.
//!
//! ```text
//! plane z in [z_1, z_2]:      U = U_1 + U_2     z U = z_1 U_1 + z_2 U_2      |U_1| + |U_2| <= most
//! axis in an area:            S = SUM S_c       conj(axis) S = SUM conj(axis_c) S_c       S: all weights of the shaft
//! phase in [a, a + b]:        Im U e^{-i a} >= 0       Im U e^{-i (a + b)} <= 0       of U_1, U_2, S_c alike
//! least amount in a sector:   Re U e^{-i (a + b/2)} >= least cos(b/2)
//! at most k optional devices: SUM |U| / most <= k
//! ```
//! Beyond a main bearing other mains carry a weight: a stretch of a crankshaft has a corner at every main inside it, and a weight
//! between two of them its parts at these two alone, so that loads of mains lose nothing either.
//!
//! A weight at `z` is `U_1 = (z_2 - z) / (z_2 - z_1) U` and `U_2` the rest: both have its phase and their amounts add up
//! to its own, so that largest amounts, added mass and added unbalance lose nothing. What the programme allows beyond
//! the box is `U_1` and `U_2` with unlike phases; the error is of the order of stretch times sector. With one given
//! direction there is none: such a weight is found without any division.

use super::choices::{Choices, Heading, Use, on_shaft, open};
use crate::convex::curve::Member;
use crate::convex::dense::{Matrix, RowFactors, norm};
use crate::convex::programme::{Group, Row};
use crate::error::BalanceError;
use crate::operator::{AxisArea, Corner, EngineLoads, Operator};
use crate::problem::{Problem, Rule};
use crate::settings::{BalanceSettings, Watch};
use lanchester_model::Engine;
use lanchester_task::{BalanceTask, Phase, Place, Seat};
use num_complex::Complex64;

/// Equations that contradict one another by more than this have no solution.
const CONTRADICTS: f64 = 1e-9;

/// A task with everything that does not depend on the choices.
pub(super) struct Ground<'a> {
    pub engine: &'a Engine,
    /// Without what the task takes over.
    pub bare: Engine,
    pub loads: EngineLoads,
    pub task: &'a BalanceTask,
    /// How far the search goes.
    pub settings: BalanceSettings,
    /// Asked before each node.
    pub watch: &'a Watch<'a>,
}

impl Ground<'_> {
    /// The convex programme of a box; `None` where its given amounts contradict the ties.
    pub fn problem(&self, choices: &Choices) -> Result<Option<Problem>, BalanceError> {
        let task = self.chosen_task(choices);
        let places = self.places(choices);
        let areas = self.areas(choices);
        let operator = Operator::with(&self.loads, &self.bare, &task, &places, &areas)?;
        let mut problem = Problem::new(self.engine, &task, operator)?;
        for weight in 0..task.weights.len() {
            self.add_heading(&mut problem, choices, weight);
            if choices.usage(self.task, weight) == Use::Yes {
                self.add_least(&mut problem, choices, weight);
            }
        }
        for shaft in 0..task.shafts.len() {
            if !problem.operator.axes[shaft].is_empty() {
                self.add_area(&mut problem, choices, &areas[shaft], shaft);
            }
        }
        self.add_count(&mut problem, choices);
        Ok(consistent(&problem).then_some(problem))
    }

    /// The task with the directions, places and the inertia of the box.
    fn chosen_task(&self, choices: &Choices) -> BalanceTask {
        let mut task = self.task.clone();
        for (index, (weight, choice)) in task.weights.iter_mut().zip(&choices.weights).enumerate() {
            if !open(choice.z) {
                weight.z = Place::At(0.5 * (choice.z[0] + choice.z[1]));
            }
            weight.optional = choices.usage(self.task, index) == Use::Open;
            (weight.least, weight.most) = (choices.least(self.task, index), choices.most(self.task, index));
            match choice.heading {
                Heading::Ray(angle) => {
                    weight.phase = Phase::Direction(angle);
                    // Said by an equation in place of two bounds that leave no room between them.
                    if choices.given(self.task, index) && choices.usage(self.task, index) == Use::Yes {
                        weight.most = None;
                    }
                }
                Heading::Line(angle) => weight.phase = Phase::Line(angle),
                Heading::Any | Heading::Sector { .. } | Heading::Tangent(_) => weight.phase = Phase::Free,
            }
        }
        for (shaft, choice) in task.shafts.iter_mut().zip(&choices.shafts) {
            shaft.optional = choice.usage == Use::Open;
        }
        task.inertias = choices.inertia.map(|index| self.task.inertias[index].clone()).into_iter().collect();
        task
    }

    /// Corners of every weight; none of one that is not used.
    fn places(&self, choices: &Choices) -> Vec<Vec<(Complex64, f64)>> {
        let axis = |seat: Seat| match seat {
            Seat::Crankshaft(index) => {
                let crankshaft = &self.engine.crankshafts[index];
                Complex64::new(crankshaft.x, crankshaft.y)
            }
            Seat::Shaft(index) => corners(choices, index)[0],
        };
        let place = |weight: usize| {
            if choices.usage(self.task, weight) == Use::No {
                return Vec::new();
            }
            let axis = axis(self.task.weights[weight].seat);
            let [low, high] = choices.weights[weight].z;
            if !open([low, high]) {
                return vec![(axis, 0.5 * (low + high))];
            }
            let mains = match self.task.weights[weight].seat {
                Seat::Crankshaft(index) => self.engine.main_planes(index),
                Seat::Shaft(_) => Vec::new(),
            };
            let inside = mains.into_iter().filter(|main| open([low, *main]) && open([*main, high]));
            [low].into_iter().chain(inside).chain([high]).map(|z| (axis, z)).collect()
        };
        (0..self.task.weights.len()).map(place).collect()
    }

    fn areas(&self, choices: &Choices) -> Vec<AxisArea> {
        let area = |shaft: usize| {
            let mut headings = on_shaft(self.task, shaft)
                .filter(|&w| choices.usage(self.task, w) != Use::No)
                .map(|w| choices.weights[w].heading);
            let Some(first) = headings.next() else { return AxisArea::default() };
            let direction = match first {
                Heading::Ray(angle) if headings.all(|h| h == first) => Some(angle),
                _ => None,
            };
            AxisArea { corners: corners(choices, shaft), direction }
        };
        (0..self.task.shafts.len()).map(area).collect()
    }

    /// Keeps a weight's corners in its sector.
    fn add_heading(&self, problem: &mut Problem, choices: &Choices, weight: usize) {
        let Heading::Sector { start, width } = choices.weights[weight].heading else { return };
        let columns = &problem.operator.weights[weight];
        let unit = columns.unit;
        for corner in columns.corners.clone() {
            add_sector(problem, &[(1.0, &corner)], [start, width], unit);
        }
    }

    fn add_least(&self, problem: &mut Problem, choices: &Choices, weight: usize) {
        let least = choices.least(self.task, weight);
        if least <= 0.0 {
            return;
        }
        let columns = &problem.operator.weights[weight];
        let (unit, corners) = (columns.unit, columns.corners.clone());
        let terms: Vec<(f64, &Corner)> = corners.iter().map(|c| (1.0, c)).collect();
        let along = |problem: &Problem, angle: f64, sign: f64| {
            let turned = |value: Complex64| sign * (value * Complex64::cis(-angle)).re / unit;
            directions(problem, &terms, turned)
        };
        match choices.weights[weight].heading {
            Heading::Ray(angle) if choices.given(self.task, weight) => {
                let row = along(problem, angle, 1.0);
                problem.given.push((weight, problem.operator.equalities.rows));
                problem.operator.equalities.push(&row);
                problem.operator.equal_to.push(least / unit);
            }
            Heading::Ray(angle) | Heading::Tangent(angle) => {
                let row = along(problem, angle, -1.0);
                // A tangent moves with its circle: its price is that of the amount.
                add_ruled_row(problem, row, -least / unit, (Rule::LeastAmount(weight), unit));
            }
            Heading::Sector { start, width } => {
                let row = along(problem, start + 0.5 * width, -1.0);
                add_row(problem, row, -least * (0.5 * width).cos() / unit);
            }
            Heading::Any | Heading::Line(_) => {}
        }
    }

    /// Bounds what a shaft's weights have at the corners of its area.
    fn add_area(&self, problem: &mut Problem, choices: &Choices, area: &AxisArea, shaft: usize) {
        let others = problem.operator.axes[shaft].clone();
        let weights: Vec<Corner> =
            on_shaft(self.task, shaft).flat_map(|w| problem.operator.weights[w].corners.clone()).collect();
        let unit = on_shaft(self.task, shaft).map(|w| problem.operator.weights[w].unit).fold(0.0, f64::max);
        // What the other corners leave is at the first one.
        let first: Vec<(f64, &Corner)> =
            weights.iter().map(|c| (1.0, c)).chain(others.iter().map(|c| (-1.0, c))).collect();
        let parts: Vec<Vec<(f64, &Corner)>> =
            std::iter::once(first).chain(others.iter().map(|c| vec![(1.0, c)])).collect();
        if let Some(angle) = area.direction {
            let row = directions(problem, &parts[0], |value| -(value * Complex64::cis(-angle)).re / unit);
            add_row(problem, row, 0.0);
            return;
        }
        let own = on_shaft(self.task, shaft)
            .filter(|&w| choices.usage(self.task, w) != Use::No)
            .map(|w| choices.weights[w].heading)
            .collect::<Vec<_>>();
        let heading = match own[..] {
            // The sum of one is that one.
            [only @ Heading::Sector { .. }] => only,
            _ => choices.shafts[shaft].heading,
        };
        if let Heading::Sector { start, width } = heading {
            parts.iter().for_each(|part| add_sector(problem, part, [start, width], unit));
        }
        let most: Option<f64> = on_shaft(self.task, shaft).map(|w| choices.most(self.task, w)).sum();
        if let Some(most) = most {
            let mut shares = Vec::new();
            for part in &parts {
                let columns = plane(problem, part, unit);
                shares.push((add_group(problem, vec![columns]), 1.0));
            }
            let nothing = vec![0.0; problem.operator.variables];
            problem.programme.rows.push(Row { shares, directions: nothing, most: most / unit });
            problem.rules.push((Rule::Plain, 1.0));
        }
    }

    /// At most so many of the devices that are not decided.
    fn add_count(&self, problem: &mut Problem, choices: &Choices) {
        let Some(most) = self.task.most_optional else { return };
        let left = most.saturating_sub(choices.used(self.task)) as f64;
        let mut shares = Vec::new();
        let usage = |weights: &[usize], problem: &mut Problem| {
            let mut members = Vec::new();
            for &weight in weights {
                let most = choices.most(self.task, weight).filter(|most| *most > 0.0)?;
                let corners = problem.operator.weights[weight].corners.clone();
                let terms: Vec<(f64, &Corner)> = corners.iter().map(|c| (1.0, c)).collect();
                members.push(plane(problem, &terms, most));
            }
            (!members.is_empty()).then(|| (add_group(problem, members), 1.0))
        };
        for (weight, choice) in choices.weights.iter().enumerate() {
            if choice.usage == Use::Open && self.task.weights[weight].optional {
                shares.extend(usage(&[weight], problem));
            }
        }
        for (shaft, choice) in choices.shafts.iter().enumerate() {
            if choice.usage == Use::Open && self.task.shafts[shaft].optional {
                let own: Vec<usize> =
                    on_shaft(self.task, shaft).filter(|&w| choices.usage(self.task, w) != Use::No).collect();
                shares.extend(usage(&own, problem));
            }
        }
        if shares.len() as f64 > left {
            let nothing = vec![0.0; problem.operator.variables];
            problem.programme.rows.push(Row { shares, directions: nothing, most: left });
            problem.rules.push((Rule::Plain, 1.0));
        }
    }
}

/// Corners of the area of a shaft's axis, one of a fixed one.
pub(super) fn corners(choices: &Choices, shaft: usize) -> Vec<Complex64> {
    let ends = |stretch: [f64; 2]| {
        if open(stretch) { stretch.to_vec() } else { vec![0.5 * (stretch[0] + stretch[1])] }
    };
    let choice = &choices.shafts[shaft];
    let ys = ends(choice.y);
    ends(choice.x).iter().flat_map(|&x| ys.iter().map(move |&y| Complex64::new(x, y))).collect()
}

/// A row of factors of the variables: a linear function of a sum of unbalances.
fn directions(problem: &Problem, terms: &[(f64, &Corner)], of: impl Fn(Complex64) -> f64) -> Vec<f64> {
    let mut row = vec![0.0; problem.operator.variables];
    for (factor, corner) in terms {
        for &(variable, value) in &corner.terms {
            row[variable] += factor * of(value);
        }
    }
    row
}

/// A sum of unbalances as a vector in the plane, in units of `unit`.
fn plane(problem: &Problem, terms: &[(f64, &Corner)], unit: f64) -> Member {
    let rows = [
        directions(problem, terms, |value| value.re / unit),
        directions(problem, terms, |value| value.im / unit),
    ];
    let columns = Matrix::from_rows(problem.operator.variables, rows.iter().map(Vec::as_slice));
    Member::vector(columns)
}

fn add_group(problem: &mut Problem, members: Vec<Member>) -> usize {
    problem.programme.groups.push(Group::new(members));
    problem.programme.cost.push(0.0);
    problem.programme.groups.len() - 1
}

fn add_row(problem: &mut Problem, directions: Vec<f64>, most: f64) {
    add_ruled_row(problem, directions, most, (Rule::Plain, 1.0));
}

fn add_ruled_row(problem: &mut Problem, directions: Vec<f64>, most: f64, rule: (Rule, f64)) {
    problem.programme.rows.push(Row { shares: Vec::new(), directions, most });
    problem.rules.push(rule);
}

/// Keeps a sum of unbalances in the sector from `start` on through `width`.
fn add_sector(problem: &mut Problem, terms: &[(f64, &Corner)], [start, width]: [f64; 2], unit: f64) {
    for (angle, sign) in [(start, -1.0), (start + width, 1.0)] {
        let row = directions(problem, terms, |value| sign * (value * Complex64::cis(-angle)).im / unit);
        add_row(problem, row, 0.0);
    }
}

fn consistent(problem: &Problem) -> bool {
    let operator = &problem.operator;
    let x = RowFactors::of(&operator.equalities, 1e-12).shortest(&operator.equal_to);
    let rest: Vec<f64> =
        operator.equalities.times(&x).iter().zip(&operator.equal_to).map(|(a, b)| a - b).collect();
    norm(&rest) <= CONTRADICTS * (1.0 + norm(&operator.equal_to))
}
