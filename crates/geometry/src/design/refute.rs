//! The proof: no shape of the ranges reaches a level better than a given one.
//!
//! Branch and bound over boxes of the five variables. In a box each term has a range of second derivatives, so that it lies above its
//! tangent at the middle less a constant (book, eq. 22.29). If the linear programme of these lower bounds has no solution, the box has no
//! shape that satisfies all terms; nor has it where the sum of the terms with the programme's multipliers is positive throughout
//! (eq. 22.30). What the programme leaves of the box is cut to it; the rest is halved.

use super::COLUMNS;
use super::bend::{Bend, products};
use super::curve::Curve;
use super::descent::{Descent, Reached, sense};
use super::problem::{Kind, Levels, Problem, SHAPE, Term};
use lanchester_numerics::Interval;
use lanchester_numerics::{Jet, Ring};
use lanchester_numerics::{Simplex, SimplexEnd, SimplexRow};
use std::rc::Rc;

/// What rounding may make of a scaled term.
pub(super) const ROUNDING: f64 = 1e-12;
/// What rounding may make of the tableau.
const OF_TABLEAU: f64 = 1e-9;
/// A box smaller than this part of the ranges in every variable is left as it is.
const SMALLEST: f64 = 1e-7;

/// A term with its first derivatives, at the middle of a box.
type Slopes = Jet<f64, SHAPE>;
/// A term with its second derivatives, over a box.
type Curvatures = Curve<Interval>;
/// A box halved this often has its second derivatives enclosed anew.
const FRESH: u32 = 5;

/// What came of the proof.
#[derive(Debug, Clone, Copy)]
pub(super) struct Refutation {
    /// The best shape known, if there is one.
    pub best: Option<Reached>,
    /// Whether every box was refuted.
    pub proved: bool,
    /// Boxes looked at.
    pub boxes: usize,
}

/// A box.
#[derive(Debug, Clone)]
struct Cell {
    low: [f64; SHAPE],
    high: [f64; SHAPE],
    /// Second derivatives of the terms over a box that holds this one.
    bends: Rc<Vec<Bend>>,
    /// How often the box of these was halved.
    age: u32,
}

enum Verdict {
    Refuted,
    /// What is left, with the point of the linear programme.
    Left(Cell, [f64; SHAPE]),
}

/// Working memory of the proof.
#[derive(Default)]
pub(super) struct Refuter {
    simplex: Simplex<COLUMNS>,
    rows: Vec<SimplexRow<COLUMNS>>,
    /// Second derivatives of what keeps the last programme from refuting its box, if that is known.
    open: Option<Bend>,
    /// Of each row the term, and how far that can lie below its tangent in the box.
    sources: Vec<(usize, f64)>,
    terms: Vec<Term<Slopes>>,
    curved: Vec<Term<Curvatures>>,
    plain: Vec<Term<f64>>,
}

impl Refuter {
    /// Tries to show that no shape is better than `best` by more than `gap` of its level, in at most so many boxes; a better one that turns up takes
    /// its place.
    pub fn run(
        &mut self,
        problem: &Problem,
        kind: Kind,
        mut best: Option<Reached>,
        (gap, most_boxes): (f64, usize),
        descent: &mut Descent,
    ) -> Refutation {
        let mut stack = vec![Cell { low: problem.low, high: problem.high, bends: Rc::default(), age: FRESH }];
        let (mut boxes, mut searched, mut left) = (0usize, 1, false);
        while let Some(mut cell) = stack.pop() {
            if boxes == most_boxes {
                left = true;
                break;
            }
            boxes += 1;
            let target = best.map(|best| best.level * (1.0 - sense(kind) * gap));
            if cell.age >= FRESH || cell.bends.is_empty() {
                cell.bends = Rc::new(self.bends(problem, kind, target, &cell));
                cell.age = 0;
            }
            let Verdict::Left(mut cell, point) = self.examine(problem, kind, target, cell) else { continue };
            // A better shape is looked for whenever the number of boxes has doubled.
            let is_searched = boxes >= searched;
            if is_searched {
                searched = 2 * boxes;
            }
            let widest = self.widest(problem, &cell);
            if is_searched || self.open.is_none() || widest.is_none() {
                let found = descent.run(problem, kind, point, best.filter(|_| widest.is_some()));
                // Steps of rounding would go on for ever.
                let is_better = |old: Reached| sense(kind) * (old.level - found.level) > 1e-10 * old.level;
                if found.is_feasible() && best.is_none_or(is_better) {
                    // A target brings terms of its own, and a better one smaller levels in their derivatives.
                    cell.age = FRESH;
                    for other in &mut stack {
                        other.age = FRESH;
                    }
                    best = Some(found);
                    stack.push(cell);
                    continue;
                }
            }
            match widest {
                Some(k) => {
                    let middle = (cell.low[k] + cell.high[k]) / 2.0;
                    cell.age += 1;
                    let (mut first, mut second) = (cell.clone(), cell);
                    first.high[k] = middle;
                    second.low[k] = middle;
                    stack.extend([first, second]);
                }
                None => left = true,
            }
        }
        Refutation { best, proved: !left, boxes }
    }

    /// Cuts a box as long as that takes much away.
    fn examine(&mut self, problem: &Problem, kind: Kind, target: Option<f64>, mut cell: Cell) -> Verdict {
        loop {
            let before = volume(&cell);
            match self.cut(problem, kind, target, cell) {
                Verdict::Left(cut, point) => {
                    if volume(&cut) > 0.5 * before {
                        return Verdict::Left(cut, point);
                    }
                    cell = cut;
                }
                refuted => return refuted,
            }
        }
    }

    /// Second derivatives of the terms over a box.
    fn bends(&mut self, problem: &Problem, kind: Kind, target: Option<f64>, cell: &Cell) -> Vec<Bend> {
        let x: [Curvatures; SHAPE] =
            std::array::from_fn(|k| Curve::variable(Interval::new(cell.low[k], cell.high[k]), k));
        let (levels, objective) = aim(problem, kind, target);
        problem.terms(&problem.quantities(&x), &levels.mapped(Curvatures::of), objective, &mut self.curved);
        self.curved.iter().map(|term| Bend::of(&term.value.bend)).collect()
    }

    fn cut(&mut self, problem: &Problem, kind: Kind, target: Option<f64>, cell: Cell) -> Verdict {
        let (levels, objective) = aim(problem, kind, target);
        let middle: [f64; SHAPE] = std::array::from_fn(|k| (cell.low[k] + cell.high[k]) / 2.0);
        let half: [f64; SHAPE] = std::array::from_fn(|k| (cell.high[k] - cell.low[k]) / 2.0);
        let x: [Slopes; SHAPE] = std::array::from_fn(|k| Jet::variable(middle[k], k));
        let q = problem.quantities(&x);
        problem.terms(&q, &levels.mapped(Slopes::of), objective, &mut self.terms);
        let mut free = [0; SHAPE];
        let mut count = 0;
        for k in 0..SHAPE {
            if cell.high[k] > cell.low[k] {
                free[count] = k;
                count += 1;
            }
        }
        let free = &free[..count];
        // The objective's terms may be positive by v, which is at least `floor`.
        let mut floor = f64::NEG_INFINITY;
        self.rows.clear();
        self.sources.clear();
        let products = products(&half);
        for (number, (term, bend)) in self.terms.iter().zip(cell.bends.iter()).enumerate() {
            let Slopes { value, by } = term.value;
            let spread: f64 = by.iter().zip(&half).map(|(slope, half)| slope.abs() * half).sum();
            let rise: f64 = by.iter().zip(&half).map(|(slope, half)| slope * half).sum();
            let drop = bend.drop(&products);
            let least = value - spread + drop;
            if least > ROUNDING {
                return Verdict::Refuted;
            }
            // A limit that no place of the box can break by its bound leaves the programme as it is.
            if !term.of_objective && value + spread + drop <= 0.0 {
                continue;
            }
            let mut row = SimplexRow { a: [0.0; COLUMNS], b: rise - value - drop };
            for (column, k) in free.iter().enumerate() {
                row.a[column] = by[*k] * 2.0 * half[*k];
            }
            if term.of_objective {
                row.a[count] = -1.0;
                floor = floor.max(least);
            }
            self.rows.push(row);
            self.sources.push((number, drop));
        }
        let floor = if floor.is_finite() { floor } else { 0.0 };
        for row in &mut self.rows {
            // v counts from the floor.
            row.b -= row.a[count] * floor;
        }
        let mut bounds = [1.0; COLUMNS];
        bounds[count] = f64::INFINITY;
        let limit = ROUNDING - floor;
        let end = self.simplex.solve(&self.rows, &bounds[..=count], limit);
        let mut point = middle;
        self.open = None;
        match end {
            SimplexEnd::Infeasible | SimplexEnd::Beyond => Verdict::Refuted,
            SimplexEnd::Stopped => Verdict::Left(cell, point),
            SimplexEnd::Optimal => {
                // The sum of the terms with their multipliers bends as a whole, often upwards where each alone bends down.
                let mut drops = 0.0;
                let (mut value, mut slope, mut sum) = (0.0, [0.0; SHAPE], 1.0);
                for (row, multiplier) in self.simplex.multipliers() {
                    let (number, drop) = self.sources[row];
                    let term = &self.terms[number].value;
                    value += multiplier * term.value;
                    sum += multiplier;
                    for (slope, by) in slope.iter_mut().zip(&term.by) {
                        *slope += multiplier * by;
                    }
                    drops += multiplier * drop;
                }
                let terms = self
                    .simplex
                    .multipliers()
                    .map(|(row, weight)| (weight, &cell.bends[self.sources[row].0]));
                let whole = Bend::sum(terms);
                let [drop_of_whole, least] = whole.least(&slope, &half);
                if value + least > ROUNDING * sum {
                    return Verdict::Refuted;
                }
                let gain = (drop_of_whole - drops).max(0.0);
                if self.simplex.least() + gain > limit {
                    return Verdict::Refuted;
                }
                let (least, tightened) = (self.simplex.point(), self.simplex.tightened(limit, gain));
                let mut cut = cell.clone();
                for (column, k) in free.iter().enumerate() {
                    let width = cell.high[*k] - cell.low[*k];
                    point[*k] = cell.low[*k] + least[column].clamp(0.0, 1.0) * width;
                    // A little wider, for the rounding of the tableau.
                    let [low, high] = [tightened[column][0] - OF_TABLEAU, tightened[column][1] + OF_TABLEAU];
                    if low > high {
                        return Verdict::Refuted;
                    }
                    cut.low[*k] = (cell.low[*k] + low.max(0.0) * width).min(cell.high[*k]);
                    cut.high[*k] = (cell.low[*k] + high.min(1.0) * width).max(cut.low[*k]);
                }
                // Across the rows that hold there what is left is thin, however the box lies: there the sum may bend down.
                let reach: [f64; SHAPE] =
                    std::array::from_fn(|k| (cut.high[k] - middle[k]).max(middle[k] - cut.low[k]));
                let (centre, edges) = self.left(free, &half, limit);
                let asked = OF_TABLEAU * sum - value;
                if whole.least_within(&slope, &self::products(&reach), &centre, &edges, asked) > asked {
                    return Verdict::Refuted;
                }
                // Without their drops the sum of the terms would refute the box, or one that the point breaks must be known better.
                self.open = if self.simplex.least() - drops > limit {
                    Some(whole)
                } else {
                    self.broken(problem, &levels, objective, &point).map(|number| cell.bends[number])
                };
                Verdict::Left(cut, point)
            }
        }
    }

    /// What the programme leaves, from the middle of the box: a parallelepiped by its centre and its half edges.
    fn left(
        &self,
        free: &[usize],
        half: &[f64; SHAPE],
        limit: f64,
    ) -> ([f64; SHAPE], [[f64; SHAPE]; COLUMNS]) {
        let (corner, edges) = self.simplex.parallelepiped(&self.rows, limit);
        let (mut centre, mut scaled) = ([0.0; SHAPE], [[0.0; SHAPE]; COLUMNS]);
        for (column, k) in free.iter().enumerate() {
            centre[*k] = half[*k] * (2.0 * corner[column] - 1.0);
            for (scaled, edge) in scaled.iter_mut().zip(&edges) {
                scaled[*k] = half[*k] * edge[column];
                centre[*k] += scaled[*k];
            }
        }
        (centre, scaled)
    }

    /// The term that a shape breaks most, if it breaks any.
    fn broken(
        &mut self,
        problem: &Problem,
        levels: &Levels<f64>,
        objective: Option<Kind>,
        x: &[f64; SHAPE],
    ) -> Option<usize> {
        problem.terms(&problem.quantities(x), levels, objective, &mut self.plain);
        let values = self.plain.iter().map(|term| term.value).enumerate();
        let worst = values.max_by(|(_, a), (_, b)| a.total_cmp(b));
        worst.filter(|(_, value)| *value > 0.0).map(|(number, _)| number)
    }

    /// The variable whose width moves the terms most, of those that are not small.
    fn widest(&self, problem: &Problem, cell: &Cell) -> Option<usize> {
        let mut best: Option<(usize, f64)> = None;
        let widths: [f64; SHAPE] = std::array::from_fn(|k| cell.high[k] - cell.low[k]);
        for k in 0..SHAPE {
            let smallest = (SMALLEST * (problem.high[k] - problem.low[k])).max(ROUNDING);
            if widths[k] <= smallest {
                continue;
            }
            let most = match &self.open {
                Some(open) => open.turn(k, &widths),
                None => cell.bends.iter().map(|bend| bend.turn(k, &widths)).fold(0.0, f64::max),
            };
            let smear = most * widths[k];
            if best.is_none_or(|(_, most)| smear > most) {
                best = Some((k, smear));
            }
        }
        best.map(|(k, _)| k)
    }
}

/// Levels with the target in them, and what they are the objective of. Without a target what is made small keeps its limit.
fn aim(problem: &Problem, kind: Kind, target: Option<f64>) -> (Levels<f64>, Option<Kind>) {
    match target {
        Some(target) => (problem.levels.with(kind, target), Some(kind)),
        None => (problem.levels, None),
    }
}

fn volume(cell: &Cell) -> f64 {
    let widths = cell.low.iter().zip(&cell.high).map(|(low, high)| high - low);
    widths.filter(|width| *width > 0.0).product()
}
