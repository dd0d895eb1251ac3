//! A good shape from a given one: sequential linear programming with a trust region.
//!
//! It proves nothing; what it finds is held against all shapes by [`super::refute`].

use super::COLUMNS;
use super::problem::{Kind, Problem, SHAPE, Term};
use lanchester_numerics::{Jet, Ring};
use lanchester_numerics::{Simplex, SimplexEnd, SimplexRow};

const VARIABLES: usize = SHAPE + 1;
type Gradient = Jet<f64, VARIABLES>;

/// A violation below this is rounding, in scaled terms.
pub(super) const FEASIBLE: f64 = 1e-12;
const STEPS: usize = 120;
/// Steps in which the distance to what is known must halve.
const JUDGED: usize = 8;

/// A shape, the level that it reaches and by how much it passes other limits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reached {
    pub x: [f64; SHAPE],
    pub level: f64,
    pub violation: f64,
}

impl Reached {
    pub fn is_feasible(&self) -> bool {
        self.violation <= FEASIBLE && self.level.is_finite()
    }

    /// The other where it is feasible and better, or where this is not feasible; else this.
    fn or_better(self, other: Reached, kind: Kind) -> Reached {
        let is_better = match (self.is_feasible(), other.is_feasible()) {
            (true, true) => sense(kind) * other.level < sense(kind) * self.level,
            (is_feasible, _) => !is_feasible,
        };
        if is_better { other } else { self }
    }
}

/// Working memory of the search.
#[derive(Default)]
pub(super) struct Descent {
    simplex: Simplex<COLUMNS>,
    rows: Vec<SimplexRow<COLUMNS>>,
    terms: Vec<Term<Gradient>>,
    plain: Vec<Term<f64>>,
    /// What a unit of violation is worth in parts of the level, by the multipliers of the last programme.
    worth: f64,
}

/// +1 where the level is made small, -1 where it is made large.
pub(super) fn sense(kind: Kind) -> f64 {
    if kind == Kind::Balance { -1.0 } else { 1.0 }
}

impl Descent {
    /// How good a shape is.
    pub fn reached(&mut self, problem: &Problem, kind: Kind, x: [f64; SHAPE]) -> Reached {
        let q = problem.quantities(&x);
        let level = problem.attained(&q, kind);
        let levels = problem.levels.with(kind, level);
        problem.terms(&q, &levels, Some(kind), &mut self.plain);
        let others = self.plain.iter().filter(|term| !term.of_objective).map(|term| term.value);
        let violation = others.fold(0.0, f64::max);
        // A shape without unbalance reaches no level at all.
        let violation = if q.first > 0.0 { violation } else { violation.max(1e-3 - q.first) };
        Reached { x, level, violation }
    }

    /// The best shape near `x`; given up where it does not get near to what is known already.
    pub fn run(&mut self, problem: &Problem, kind: Kind, x: [f64; SHAPE], known: Option<Reached>) -> Reached {
        let mut here = self.reached(problem, kind, x);
        let mut best = here;
        let mut radius = 0.25;
        let mut penalty: f64 = 10.0;
        let mut stalled = 0;
        let mut behind = f64::INFINITY;
        for at in 1..=STEPS {
            let Some(next) = self.step(problem, kind, &here, radius) else { break };
            let next = self.reached(problem, kind, next);
            // A violation must cost more than it gains.
            penalty = penalty.max((2.0 * self.worth).min(1e9));
            let merit =
                |r: &Reached| sense(kind) * r.level / here.level.abs().max(1e-300) + penalty * r.violation;
            let better = match (here.level.is_finite(), next.level.is_finite()) {
                (true, true) => merit(&next) < merit(&here) - 1e-16,
                (finite, _) => !finite && next.violation <= here.violation,
            };
            if better {
                let gain = (here.level - next.level).abs() / here.level.abs();
                stalled = if gain < 1e-13 && next.violation <= FEASIBLE { stalled + 1 } else { 0 };
                here = next;
                best = best.or_better(here, kind);
                radius = (radius * 2.0).min(0.5);
            } else {
                radius *= 0.3;
            }
            if here.violation > FEASIBLE && radius < 1e-6 && penalty < 1e7 {
                (radius, penalty) = (0.05, penalty * 100.0);
            }
            if radius < 1e-10 || stalled > 2 {
                break;
            }
            if let Some(known) = known
                && at % JUDGED == 0
            {
                let now = sense(kind) * (here.level - known.level) / known.level + penalty * here.violation;
                if now > 0.5 * behind || (now > 0.0 && now < 1e-8) {
                    return best.or_better(here, kind);
                }
                behind = now.max(0.0);
            }
        }
        best.or_better(self.restored(problem, kind, here), kind)
    }

    /// The nearest shape within the limits, if it lies as near as the last digits.
    fn restored(&mut self, problem: &Problem, kind: Kind, mut here: Reached) -> Reached {
        let mut radius = 1e-10;
        while here.violation > FEASIBLE && radius < 1e-3 {
            if let Some(next) = self.step_towards(problem, kind, &here, radius, true) {
                let next = self.reached(problem, kind, next);
                if next.violation < here.violation {
                    here = next;
                }
            }
            radius *= 4.0;
        }
        here
    }

    /// Where the linear programme at a shape leads, within a part of the ranges; where its limits cannot be met, nearer to them.
    fn step(&mut self, problem: &Problem, kind: Kind, here: &Reached, radius: f64) -> Option<[f64; SHAPE]> {
        self.step_towards(problem, kind, here, radius, false)
            .or_else(|| self.step_towards(problem, kind, here, radius, true))
    }

    /// The step to the least level, or with `elastic` to the least violation of the limits.
    fn step_towards(
        &mut self,
        problem: &Problem,
        kind: Kind,
        here: &Reached,
        radius: f64,
        elastic: bool,
    ) -> Option<[f64; SHAPE]> {
        let level = if here.level.is_finite() { here.level } else { 1.0 };
        let x: [Gradient; SHAPE] = std::array::from_fn(|k| Jet::variable(here.x[k], k));
        let q = problem.quantities(&x);
        let levels = problem.levels.mapped(Gradient::of);
        problem.terms(&q, &levels.with(kind, Jet::variable(level, SHAPE)), Some(kind), &mut self.terms);
        // Free variables, each from the lower end of its trust region.
        let mut free = [(0usize, 0.0, 0.0); SHAPE];
        let mut count = 0;
        for k in 0..SHAPE {
            let width = problem.high[k] - problem.low[k];
            if width > 0.0 {
                let low = (here.x[k] - radius * width).max(problem.low[k]);
                let high = (here.x[k] + radius * width).min(problem.high[k]);
                if high > low {
                    free[count] = (k, low, high - low);
                    count += 1;
                }
            }
        }
        if count == 0 {
            return None;
        }
        let free = &free[..count];
        let sign = sense(kind);
        // The level as a start and a variable that is not negative.
        let start = if sign > 0.0 { 0.0 } else { 2.0 * level + 1.0 };
        let mut upper = [1.0; COLUMNS];
        upper[count] = f64::INFINITY;
        self.rows.clear();
        for term in &self.terms {
            if elastic && term.of_objective {
                continue;
            }
            let Gradient { value, by } = term.value;
            let mut row = SimplexRow { a: [0.0; COLUMNS], b: -value };
            for (column, (k, low, width)) in free.iter().enumerate() {
                row.a[column] = by[*k] * width;
                row.b += by[*k] * (here.x[*k] - low);
            }
            row.a[count] = if elastic { -1.0 } else { by[SHAPE] * sign };
            row.b += if elastic { 0.0 } else { by[SHAPE] * (level - start) };
            self.rows.push(row);
        }
        if self.simplex.solve(&self.rows, &upper[..=count], f64::INFINITY) != SimplexEnd::Optimal {
            return None;
        }
        let limits = self.simplex.multipliers().filter(|(row, _)| !elastic && !self.terms[*row].of_objective);
        self.worth = limits.map(|(_, multiplier)| multiplier).sum::<f64>() / level.abs().max(1e-300);
        let point = self.simplex.point();
        let mut next = here.x;
        for (column, (k, low, width)) in free.iter().enumerate() {
            next[*k] = (low + point[column] * width).clamp(problem.low[*k], problem.high[*k]);
        }
        Some(next)
    }
}
