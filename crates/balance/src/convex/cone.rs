//! One cone programme with finitely many angles, solved by Clarabel. Nothing that it says is believed: values, bounds
//! and feasibility are computed again from its point and its multipliers.

use super::curve::Vector;
use super::programme::{Programme, Support};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};

/// A member at an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touch {
    pub group: usize,
    pub member: usize,
    pub angle: f64,
}

/// What the interior-point method returns.
pub(crate) struct ConePoint {
    pub x: Vec<f64>,
    pub support: Vec<Support>,
    pub prices: Vec<f64>,
    /// It claims that the rows contradict one another.
    pub infeasible: bool,
}

/// Solves the programme with the members judged at `touches` alone.
pub(crate) fn solve(programme: &Programme, touches: &[Touch]) -> Option<ConePoint> {
    let n = programme.variables;
    // One level for each group that is judged.
    let mut place = vec![usize::MAX; programme.groups.len()];
    let mut unknowns = n;
    for (group, place) in place.iter_mut().enumerate() {
        if programme.judged(group) {
            *place = unknowns;
            unknowns += 1;
        }
    }
    let mut triplets = Triplets::default();
    let mut right = Vec::new();
    let mut cones = Vec::new();
    for touch in touches {
        let member = &programme.groups[touch.group].members[touch.member];
        let directions = member.directions(touch.angle);
        let constant = member.constant(touch.angle);
        triplets.add(right.len(), place[touch.group], -1.0);
        right.push(0.0);
        for m in 0..directions.rows {
            for (j, value) in directions.row(m).iter().enumerate() {
                triplets.add(right.len(), j, -value);
            }
            right.push(constant[m]);
        }
        cones.push(SupportedConeT::SecondOrderConeT(directions.rows + 1));
    }
    for row in &programme.rows {
        for &(group, share) in &row.shares {
            triplets.add(right.len(), place[group], share);
        }
        for (j, value) in row.directions.iter().enumerate() {
            triplets.add(right.len(), j, *value);
        }
        right.push(row.most);
    }
    if !programme.rows.is_empty() {
        cones.push(SupportedConeT::NonnegativeConeT(programme.rows.len()));
    }
    let mut cost = vec![0.0; unknowns];
    cost[..n].copy_from_slice(&programme.linear);
    for (group, &place) in place.iter().enumerate() {
        if place != usize::MAX {
            cost[place] = programme.cost[group];
        }
    }
    let matrix =
        CscMatrix::new_from_triplets(right.len(), unknowns, triplets.row, triplets.column, triplets.value);
    let settings = DefaultSettings {
        verbose: false,
        max_iter: 100,
        tol_gap_abs: 1e-11,
        tol_gap_rel: 1e-11,
        tol_feas: 1e-11,
        presolve_enable: false,
        max_threads: 1,
        ..DefaultSettings::default()
    };
    let quadratic = CscMatrix::zeros((unknowns, unknowns));
    let mut solver = DefaultSolver::new(&quadratic, &cost, &matrix, &right, &cones, settings).ok()?;
    solver.solve();
    let solution = &solver.solution;
    let infeasible =
        matches!(solution.status, SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible);
    if solution.x.iter().chain(&solution.z).any(|v| !v.is_finite()) {
        return None;
    }
    let mut at = 0;
    let support = touches
        .iter()
        .map(|touch| {
            let d = programme.groups[touch.group].members[touch.member].dimension();
            let mut y: Vector = Default::default();
            for m in 0..d {
                y[m] = -solution.z[at + 1 + m];
            }
            at += d + 1;
            Support { group: touch.group, member: touch.member, angle: touch.angle, y }
        })
        .collect();
    let prices = solution.z[at..].iter().map(|z| z.max(0.0)).collect();
    Some(ConePoint { x: solution.x[..n].to_vec(), support, prices, infeasible })
}

#[derive(Default)]
struct Triplets {
    row: Vec<usize>,
    column: Vec<usize>,
    value: Vec<f64>,
}

impl Triplets {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        if value != 0.0 {
            self.row.push(row);
            self.column.push(column);
            self.value.push(value);
        }
    }
}
