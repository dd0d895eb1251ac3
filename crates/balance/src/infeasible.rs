//! Limits that cannot hold together: by how much, and how close each can be reached alone.

use crate::convex::dense::{Matrix, RowFactors};
use crate::convex::programme::{Programme, Row, Solution};
use crate::convex::{Failure, GAP, solve};
use crate::problem::{Problem, Rule};

/// What stands between the limits and an answer.
pub(crate) struct Obstacle {
    /// Common factor by which the limits must be relaxed.
    pub relaxation: f64,
    /// Smallest value of each limited criterion alone, in its own unit.
    pub closest: Vec<f64>,
}

/// The smallest common relaxation of the limits.
pub(crate) struct Relaxed {
    pub x: Vec<f64>,
    /// The factor.
    pub value: f64,
    /// No smaller factor is enough.
    pub bound: f64,
}

/// The smallest common relaxation of the limits.
pub(crate) fn relaxation(problem: &Problem, solves: &mut usize) -> Result<Relaxed, Failure> {
    let (origin, open) = directions(problem);
    let local = problem.programme.restricted(&origin, &open);
    let solution = reduced(&relax(&local, &|r| is_limit(problem, r)), solves)?;
    let (step, factor) = solution.x.split_at(local.variables);
    let x = origin.iter().zip(open.times(step)).map(|(x, s)| x + s).collect();
    Ok(Relaxed { x, value: factor[0], bound: solution.bound })
}

/// Finds the smallest common relaxation of the limits and the closest value of each.
pub(crate) fn obstacle(problem: &Problem, solves: &mut usize) -> Obstacle {
    let relaxation = relaxation(problem, solves).map_or(f64::INFINITY, |relaxed| relaxed.value);
    let (origin, open) = directions(problem);
    let local = problem.programme.restricted(&origin, &open);
    let mut closest = Vec::new();
    for judged in &problem.limits {
        let mut alone = local.clone();
        alone.rows = local
            .rows
            .iter()
            .enumerate()
            .filter(|(r, _)| !is_limit(problem, *r))
            .map(|r| r.1.clone())
            .collect();
        judged.groups.iter().for_each(|&(group, share)| alone.cost[group] += share);
        let least = reduced(&alone, solves);
        closest.push(least.map_or(judged.unbalanced, |s| s.value.max(0.0) * judged.scale));
    }
    Obstacle { relaxation, closest }
}

/// A point that holds the equalities, and the directions that keep them.
fn directions(problem: &Problem) -> (Vec<f64>, Matrix) {
    let equalities = RowFactors::of(&problem.operator.equalities, 1e-12);
    let (_, open) = equalities.bases();
    (equalities.shortest(&problem.operator.equal_to), open)
}

fn is_limit(problem: &Problem, row: usize) -> bool {
    matches!(problem.rules.get(row), Some((Rule::Limit(_), _)))
}

/// A point that holds the rows of a programme with room to spare, if there is one.
pub(crate) fn closest_inside(programme: &Programme, solves: &mut usize) -> Option<Vec<f64>> {
    let relaxed = relax(programme, &|r| programme.rows[r].most > 0.0 && !programme.rows[r].shares.is_empty());
    let solution = reduced(&relaxed, solves).ok()?;
    let (x, s) = solution.x.split_at(programme.variables);
    (s[0] <= 1.0).then(|| x.to_vec())
}

/// The programme that minimises the common factor `s` of the limits of some rows.
fn relax(programme: &Programme, relaxes: &dyn Fn(usize) -> bool) -> Programme {
    let n = programme.variables;
    // Every variable as before, and the factor, which nothing but its rows sees.
    let mut wider = Matrix::zeros(n, n + 1);
    (0..n).for_each(|j| wider[(j, j)] = 1.0);
    let mut relaxed = programme.restricted(&vec![0.0; n], &wider);
    relaxed.cost.iter_mut().for_each(|c| *c = 0.0);
    relaxed.linear = vec![0.0; n + 1];
    relaxed.linear[n] = 1.0;
    relaxed.offset = 0.0;
    for (r, row) in relaxed.rows.iter_mut().enumerate() {
        if relaxes(r) && row.most > 0.0 {
            row.directions[n] = -row.most;
            row.most = 0.0;
        }
    }
    let mut directions = vec![0.0; n + 1];
    directions[n] = -1.0;
    relaxed.rows.push(Row { shares: Vec::new(), directions, most: 0.0 });
    relaxed
}

/// Solves in the directions that matter.
pub(crate) fn reduced(programme: &Programme, solves: &mut usize) -> Result<Solution, Failure> {
    let (range, _) = RowFactors::of(&programme.seen(), 1e-11).bases();
    let small = programme.restricted(&vec![0.0; programme.variables], &range);
    let mut solution = solve(&small, GAP, 1e-6, solves)?;
    solution.x = range.times(&solution.x);
    Ok(solution)
}
