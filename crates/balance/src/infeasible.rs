//! Limits that cannot hold together: by how much, and how close each can be reached alone.

use crate::convex::dense::Matrix;
use crate::convex::programme::{Programme, Row, Solution};
use crate::convex::solve;
use crate::problem::{Problem, Rule};
use crate::stages::GAP;

/// What stands between the limits and an answer.
pub(crate) struct Obstacle {
    /// Common factor by which the limits must be relaxed.
    pub relaxation: f64,
    /// Smallest value of each limited criterion alone, in its own unit.
    pub closest: Vec<f64>,
}

/// Finds the smallest common relaxation of the limits and the closest value of each.
pub(crate) fn obstacle(problem: &Problem, solves: &mut usize) -> Obstacle {
    let (_, open) = crate::convex::dense::RowFactors::of(&problem.operator.equalities, 1e-12).bases();
    let zero = vec![0.0; problem.operator.variables];
    let is_limit = |r: usize| matches!(problem.rules.get(r), Some((Rule::Limit(_), _)));
    let local = problem.programme.restricted(&zero, &open);
    let relaxed = relax(&local, &is_limit);
    let relaxation = reduced(&relaxed, solves).map_or(f64::INFINITY, |s| s.x[local.variables]);
    let mut closest = Vec::new();
    for judged in &problem.limits {
        let mut alone = local.clone();
        alone.rows =
            local.rows.iter().enumerate().filter(|(r, _)| !is_limit(*r)).map(|r| r.1.clone()).collect();
        judged.groups.iter().for_each(|&(group, share)| alone.cost[group] += share);
        let least = reduced(&alone, solves);
        closest.push(least.map_or(judged.unbalanced, |s| s.value.max(0.0) * judged.scale));
    }
    Obstacle { relaxation, closest }
}

/// A point that holds the rows of a programme with room to spare, if there is one.
pub(crate) fn closest_inside(programme: &Programme, solves: &mut usize) -> Option<Vec<f64>> {
    let relaxed = relax(programme, &|r| programme.rows[r].most > 0.0 && !programme.rows[r].shares.is_empty());
    let solution = reduced(&relaxed, solves)?;
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
fn reduced(programme: &Programme, solves: &mut usize) -> Option<Solution> {
    let (range, _) = crate::convex::dense::RowFactors::of(&programme.seen(), 1e-11).bases();
    let small = programme.restricted(&vec![0.0; programme.variables], &range);
    let mut solution = solve(&small, GAP, 1e-6, solves).ok()?;
    solution.x = range.times(&solution.x);
    Some(solution)
}
