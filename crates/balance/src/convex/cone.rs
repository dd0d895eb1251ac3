//! One cone programme with finitely many angles, solved by Clarabel. Nothing that it says is believed: values, bounds
//! and feasibility are computed again from its point and its multipliers.

use super::curve::FixedMember;
use super::dense::dot;
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

/// Where the unknowns are counted from, and in what unit: an optimum much smaller than 1 is known to as many digits as
/// one of 1.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    pub origin: Vec<f64>,
    pub unit: f64,
}

/// Solves the programme with the members judged at `touches` alone.
pub(crate) fn solve(programme: &Programme, touches: &[Touch], frame: &Frame) -> Option<ConePoint> {
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
    let members: Vec<Vec<FixedMember>> = (0..programme.groups.len())
        .map(
            |group| {
                if programme.judged(group) { programme.groups[group].at(&frame.origin) } else { Vec::new() }
            },
        )
        .collect();
    let mut triplets = Triplets::default();
    let mut right = Vec::new();
    let mut cones = Vec::new();
    for touch in touches {
        let directions = programme.groups[touch.group].members[touch.member].directions(touch.angle);
        let constant = members[touch.group][touch.member].value(touch.angle);
        triplets.add(right.len(), place[touch.group], -1.0);
        right.push(0.0);
        for m in 0..directions.rows {
            for (j, value) in directions.row(m).iter().enumerate() {
                triplets.add(right.len(), j, -value);
            }
            right.push(constant[m] / frame.unit);
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
        right.push((row.most - dot(&row.directions, &frame.origin)) / frame.unit);
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
        // With many peaks that are nearly level the steps must be known to the last digits.
        iterative_refinement_reltol: 1e-15,
        iterative_refinement_abstol: 1e-15,
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
            let y = solution.z[at + 1..=at + d].iter().map(|z| -z).collect();
            at += d + 1;
            Support { group: touch.group, member: touch.member, angle: touch.angle, y }
        })
        .collect();
    let prices = solution.z[at..].iter().map(|z| z.max(0.0)).collect();
    let x = frame.origin.iter().zip(&solution.x).map(|(origin, step)| origin + frame.unit * step).collect();
    Some(ConePoint { x, support, prices, infeasible })
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
