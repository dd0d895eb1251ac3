//! The proof: no shape of the ranges reaches a level better than a given one.
//!
//! Branch and bound over boxes of the five variables. In a box each term has a range of values and of derivatives, so that from
//! a corner `c` of the box
//!
//! ```text
//! term(x) >= term(c) + SUM over k of min(derivative_k over the box) (x_k - c_k)        c the lower corner  (book, eq. 22.29)
//! ```
//! and likewise from the upper corner. If the linear programme of these lower bounds has no solution, the box has no shape that
//! satisfies all terms. What the programme leaves of the box is cut to it; the rest is halved.

use super::descent::{Descent, Reached, sense};
use super::interval::Interval;
use super::jet::Jet;
use super::number::Number;
use super::problem::{Kind, Levels, Problem, SHAPE, Term};
use super::simplex::{COLUMNS, End, Row, Simplex};

/// What rounding may make of a scaled term.
pub(super) const ROUNDING: f64 = 1e-12;
/// A box smaller than this in every variable is left as it is.
const SMALLEST: f64 = 1e-7;
const MOST_BOXES: usize = 200_000;
/// Boxes from which a better shape is looked for.
const SEARCHED: usize = 24;

type Enclosure = Jet<Interval, SHAPE>;

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

#[derive(Debug, Clone, Copy)]
struct Cell {
    low: [f64; SHAPE],
    high: [f64; SHAPE],
}

enum Verdict {
    Refuted,
    /// What is left, with the point of the linear programme.
    Left(Cell, [f64; SHAPE]),
}

/// Working memory of the proof.
#[derive(Default)]
pub(super) struct Refuter {
    simplex: Simplex,
    rows: Vec<Row>,
    terms: Vec<Term<Enclosure>>,
    corners: [Vec<Term<f64>>; 2],
}

impl Refuter {
    /// Tries to show that no shape is better than `best` by more than `gap` of its level; a better one that turns up takes
    /// its place.
    pub fn run(
        &mut self,
        problem: &Problem,
        kind: Kind,
        mut best: Option<Reached>,
        gap: f64,
        descent: &mut Descent,
    ) -> Refutation {
        let mut stack = vec![Cell { low: problem.low, high: problem.high }];
        let (mut boxes, mut searched, mut left) = (0, 0, false);
        while let Some(cell) = stack.pop() {
            boxes += 1;
            if boxes > MOST_BOXES {
                left = true;
                break;
            }
            let target = best.map(|best| best.level * (1.0 - sense(kind) * gap));
            let Verdict::Left(cell, point) = self.examine(problem, kind, target, cell) else { continue };
            let widest = self.widest(problem, &cell);
            let is_small = widest.is_none_or(|(_, width)| width < SMALLEST);
            if searched < SEARCHED || best.is_none() || is_small {
                searched += 1;
                let found = descent.run(problem, kind, point);
                let is_better = |old: Reached| sense(kind) * found.level < sense(kind) * old.level;
                if found.is_feasible() && best.is_none_or(is_better) {
                    best = Some(found);
                    stack.push(cell);
                    continue;
                }
            }
            match widest {
                Some((k, _)) if !is_small => {
                    let middle = (cell.low[k] + cell.high[k]) / 2.0;
                    let (mut first, mut second) = (cell, cell);
                    first.high[k] = middle;
                    second.low[k] = middle;
                    stack.extend([first, second]);
                }
                _ => left = true,
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

    fn cut(&mut self, problem: &Problem, kind: Kind, target: Option<f64>, cell: Cell) -> Verdict {
        let levels = match target {
            Some(target) => problem.levels.with(kind, target),
            None => problem.levels,
        };
        // Without a target what is made small has no level, whatever the task says of it.
        let objective = target.map(|_| kind);
        let x: [Enclosure; SHAPE] =
            std::array::from_fn(|k| Jet::variable(Interval::new(cell.low[k], cell.high[k]), k));
        let q = problem.quantities(&x);
        problem.terms(&q, &levels.mapped(Enclosure::of), objective, &mut self.terms);
        if self.terms.iter().any(|term| term.value.value.low > ROUNDING) {
            return Verdict::Refuted;
        }
        self.corner(problem, objective, &levels, cell.low, 0);
        self.corner(problem, objective, &levels, cell.high, 1);
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
        let of_objective = self.terms.iter().filter(|term| term.of_objective);
        let floor = of_objective.map(|term| term.value.value.low).fold(f64::NEG_INFINITY, f64::max);
        let floor = if floor.is_finite() { floor } else { 0.0 };
        self.rows.clear();
        for (at, term) in self.terms.iter().enumerate() {
            // Terms that cannot be positive in the box say nothing.
            if term.value.value.high <= 0.0 && !term.of_objective {
                continue;
            }
            let offset = if term.of_objective { floor } else { 0.0 };
            let mut lower = Row { a: [0.0; COLUMNS], b: offset - self.corners[0][at].value };
            let mut upper = Row { a: [0.0; COLUMNS], b: offset - self.corners[1][at].value };
            for (column, k) in free.iter().enumerate() {
                let width = cell.high[*k] - cell.low[*k];
                let slope = term.value.by[*k];
                lower.a[column] = slope.low * width;
                upper.a[column] = slope.high * width;
                upper.b += slope.high * width;
            }
            if term.of_objective {
                lower.a[count] = -1.0;
                upper.a[count] = -1.0;
            }
            self.rows.extend([lower, upper]);
        }
        let mut bounds = [1.0; COLUMNS];
        bounds[count] = f64::INFINITY;
        let limit = ROUNDING - floor;
        let end = self.simplex.solve(&self.rows, &bounds[..=count], limit);
        let mut point: [f64; SHAPE] = std::array::from_fn(|k| (cell.low[k] + cell.high[k]) / 2.0);
        match end {
            End::Infeasible | End::Beyond => Verdict::Refuted,
            End::Stopped => Verdict::Left(cell, point),
            End::Optimal => {
                let (least, tightened) = (self.simplex.point(), self.simplex.tightened(limit));
                let mut cut = cell;
                for (column, k) in free.iter().enumerate() {
                    let width = cell.high[*k] - cell.low[*k];
                    point[*k] = cell.low[*k] + least[column].clamp(0.0, 1.0) * width;
                    // A little wider, for the rounding of the tableau.
                    let [low, high] = [tightened[column][0] - 1e-9, tightened[column][1] + 1e-9];
                    if low > high {
                        return Verdict::Refuted;
                    }
                    cut.low[*k] = (cell.low[*k] + low.max(0.0) * width).min(cell.high[*k]);
                    cut.high[*k] = (cell.low[*k] + high.min(1.0) * width).max(cut.low[*k]);
                }
                Verdict::Left(cut, point)
            }
        }
    }

    fn corner(
        &mut self,
        problem: &Problem,
        objective: Option<Kind>,
        levels: &Levels<f64>,
        x: [f64; SHAPE],
        at: usize,
    ) {
        let q = problem.quantities(&x);
        problem.terms(&q, levels, objective, &mut self.corners[at]);
    }

    /// The variable whose width moves the terms most, and the largest width as a part of the ranges.
    fn widest(&self, problem: &Problem, cell: &Cell) -> Option<(usize, f64)> {
        let mut best: Option<(usize, f64)> = None;
        let mut largest = 0.0f64;
        for k in 0..SHAPE {
            let (width, range) = (cell.high[k] - cell.low[k], problem.high[k] - problem.low[k]);
            if width <= 0.0 {
                continue;
            }
            largest = largest.max(width / range);
            let spread = self.terms.iter().map(|term| term.value.by[k].width()).fold(0.0, f64::max);
            let smear = spread * width;
            if best.is_none_or(|(_, most)| smear > most) {
                best = Some((k, smear));
            }
        }
        best.map(|(k, _)| (k, largest))
    }
}

fn volume(cell: &Cell) -> f64 {
    let widths = cell.low.iter().zip(&cell.high).map(|(low, high)| high - low);
    widths.filter(|width| *width > 0.0).product()
}
