//! The lightest devices that satisfy the equations, and the combination of the equations that proves it.
//!
//! ```text
//! minimise SUM c_i |u_i|   with   matrix u = right,   |u_i| <= most_i,   u_i >= 0 on a given direction
//! ```
//! Every `u` that satisfies the equations is `u_0 + N z`, with the orthonormal null space `N` of the matrix, so that the
//! equations hold to rounding whatever the solver does with `z`.

use super::equations::{Equations, RANK};
use super::functional::{Weighed, weigh};
use crate::convex::curve::{Grid, Member};
use crate::convex::dense::{Matrix, RowFactors, least_squares};
use crate::convex::programme::{Group, Programme, Row, Solution};
use crate::convex::{Failure, GAP, HOLDS, solve};
use std::rc::Rc;

/// Amounts below this share of the largest are tried at nothing.
const SMALL: f64 = 1e-5;

/// What nothing but rounding leaves of the equations.
const REST: f64 = 1e-12;

/// The lightest devices.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Lightest {
    pub u: Vec<f64>,
    /// `SUM c |u|`.
    pub value: f64,
    pub proof: Weighed,
}

/// Finds them; counts cone programmes in `solves`.
pub(super) fn lightest(
    equations: &Equations,
    costs: &[f64],
    grid: &Rc<Grid>,
    solves: &mut usize,
) -> Result<Lightest, Failure> {
    let mut best = on_the_rest(equations, costs, grid, &[], solves)?;
    // At the optimum many weights are nothing at all, which a solver comes close to only.
    let largest = equations.devices.iter().map(|d| equations.size(d, &best.u)).fold(0.0, f64::max);
    let small: Vec<usize> = (0..equations.devices.len())
        .filter(|&i| {
            let size = equations.size(&equations.devices[i], &best.u);
            costs[i] > 0.0 && size <= SMALL * largest
        })
        .collect();
    if let Ok(other) = on_the_rest(equations, costs, grid, &small, solves)
        && !small.is_empty()
        && other.value <= best.value * (1.0 + GAP)
    {
        let proof = if other.proof.value > best.proof.value { other.proof } else { best.proof };
        best = Lightest { proof, ..other };
    }
    Ok(best)
}

/// The lightest with some devices at nothing; its proof is about all of them.
fn on_the_rest(
    equations: &Equations,
    costs: &[f64],
    grid: &Rc<Grid>,
    nothing: &[usize],
    solves: &mut usize,
) -> Result<Lightest, Failure> {
    let n = equations.matrix.columns;
    let mut matrix = equations.matrix.clone();
    let mut right = equations.right.clone();
    for &v in nothing.iter().flat_map(|&i| &equations.devices[i].variables) {
        let mut unit = vec![0.0; n];
        unit[v] = 1.0;
        matrix.push(&unit);
        right.push(0.0);
    }
    let mut origin = least_squares(&matrix, &right, RANK);
    for _ in 0..2 {
        let left: Vec<f64> = matrix.times(&origin).iter().zip(&right).map(|(l, r)| r - l).collect();
        let step = least_squares(&matrix, &left, RANK);
        origin.iter_mut().zip(step).for_each(|(x, s)| *x += s);
    }
    let set_to_nothing = |u: &mut Vec<f64>| {
        nothing.iter().flat_map(|&i| &equations.devices[i].variables).for_each(|&v| u[v] = 0.0);
    };
    set_to_nothing(&mut origin);
    if equations.residual(&origin) > REST {
        return Err(Failure::Infeasible);
    }
    let (_, open) = RowFactors::of(&matrix, RANK).bases();
    let whole = bounded(equations, costs, grid);
    let local = whole.restricted(&origin, &open);
    let (local, kept) = without_untouched(&local)?;
    let (mut u, pulls) = if open.columns == 0 || local.variables == 0 {
        let directions = unit_directions(equations, costs, &origin);
        (origin, directions)
    } else {
        let solution = solve(&local, GAP, 1e-9, solves)?;
        let step = open.times(&solution.x);
        let u: Vec<f64> = origin.iter().zip(step).map(|(o, s)| o + s).collect();
        let pulls = pulls(&whole, &solution, &kept);
        (u, pulls)
    };
    set_to_nothing(&mut u);
    let value = equations.devices.iter().zip(costs).map(|(d, c)| c * equations.size(d, &u)).sum();
    // Two proposals for the proof: from the solver's multipliers, and from the directions of the weights in use.
    let proposals = [pulls, unit_directions(equations, costs, &u)];
    let proof = proposals
        .iter()
        .map(|pulls| {
            let multipliers = multipliers_for(equations, costs, pulls, &u);
            admissible(equations, costs, multipliers)
        })
        .max_by(|a, b| a.value.total_cmp(&b.value))
        .expect("invariant: there are two proposals");
    Ok(Lightest { u, value, proof })
}

/// The devices' amounts as groups, their bounds as rows; nothing else.
pub(super) fn bounded(equations: &Equations, costs: &[f64], grid: &Rc<Grid>) -> Programme {
    let n = equations.matrix.columns;
    let (mut groups, mut rows) = (Vec::new(), Vec::new());
    let unit = |v: usize, value: f64| {
        let mut row = vec![0.0; n];
        row[v] = value;
        row
    };
    for (index, device) in equations.devices.iter().enumerate() {
        let mut columns = Matrix::zeros(0, n);
        device.variables.iter().for_each(|&v| columns.push(&unit(v, 1.0)));
        groups.push(Group::new(vec![Member::vector(columns)]));
        if let Some(most) = device.most {
            let (shares, directions) = match device.weight {
                Some(_) => (vec![(index, 1.0)], vec![0.0; n]),
                None => (Vec::new(), unit(device.variables[0], 1.0)),
            };
            rows.push(Row { shares, directions, most });
        }
        if device.one_sided {
            rows.push(Row { shares: Vec::new(), directions: unit(device.variables[0], -1.0), most: 0.0 });
        }
    }
    Programme {
        variables: n,
        grid: Rc::clone(grid),
        cost: costs.to_vec(),
        linear: vec![0.0; n],
        offset: 0.0,
        holds: HOLDS,
        groups,
        rows,
    }
}

/// The programme without rows that no variable touches, which must hold as they are, and the places of the others.
pub(super) fn without_untouched(programme: &Programme) -> Result<(Programme, Vec<usize>), Failure> {
    let touches = |columns: &Matrix| (0..columns.rows).any(|i| columns.row(i).iter().any(|c| c.abs() > RANK));
    let touched: Vec<bool> =
        programme.groups.iter().map(|g| g.members.iter().any(|m| touches(m.columns()))).collect();
    let zero = vec![0.0; programme.variables];
    let mut kept = Vec::new();
    for (place, row) in programme.rows.iter().enumerate() {
        if row.shares.iter().any(|s| touched[s.0]) || row.directions.iter().any(|h| h.abs() > RANK) {
            kept.push(place);
            continue;
        }
        let level = |group: usize| crate::criterion::level(&programme.groups[group], &programme.grid, &zero);
        let sum: f64 = row.shares.iter().map(|&(group, share)| share * level(group)).sum();
        if sum - row.most > HOLDS * row.most.abs().max(1.0) {
            return Err(Failure::Infeasible);
        }
    }
    let mut local = programme.clone();
    local.rows = kept.iter().map(|&place| programme.rows[place].clone()).collect();
    Ok((local, kept))
}

/// What the multipliers of a solution pull at every variable of the whole programme.
pub(super) fn pulls(whole: &Programme, solution: &Solution, kept: &[usize]) -> Vec<f64> {
    let mut pulls = vec![0.0; whole.variables];
    for one in &solution.support {
        let columns = whole.groups[one.group].members[one.member].columns();
        columns.add_transposed(&one.y[..columns.rows], 1.0, &mut pulls);
    }
    for (&place, price) in kept.iter().zip(&solution.prices) {
        let row = &whole.rows[place];
        crate::convex::dense::add_scaled(&mut pulls, *price, &row.directions);
    }
    pulls
}

/// Cost times direction of every device in use.
fn unit_directions(equations: &Equations, costs: &[f64], u: &[f64]) -> Vec<f64> {
    let mut pulls = vec![0.0; u.len()];
    for (device, cost) in equations.devices.iter().zip(costs) {
        let size = equations.size(device, u);
        if size > 0.0 {
            device.variables.iter().for_each(|&v| pulls[v] = cost * u[v] / size);
        }
    }
    pulls
}

/// The multipliers that pull like this at the devices, first at those in use.
fn multipliers_for(equations: &Equations, costs: &[f64], pulls: &[f64], u: &[f64]) -> Vec<f64> {
    let matrix = &equations.matrix;
    let transposed = matrix.transposed();
    let first = least_squares(&transposed, pulls, RANK);
    // A pull that the equations cannot make shows where a device is at nothing: those may be pulled less.
    let weighed = weigh(equations, &first, costs);
    if weighed.pull <= 1.0 + 1e-9 {
        return first;
    }
    let used: Vec<usize> = equations
        .devices
        .iter()
        .filter(|d| equations.size(d, u) > 0.0)
        .flat_map(|d| d.variables.iter().copied())
        .collect();
    let rows = Matrix::from_rows(transposed.columns, used.iter().map(|&v| transposed.row(v)));
    let right: Vec<f64> = used.iter().map(|&v| pulls[v]).collect();
    least_squares(&rows, &right, RANK)
}

/// The multipliers scaled until no device without a largest amount is pulled beyond its cost.
fn admissible(equations: &Equations, costs: &[f64], mut multipliers: Vec<f64>) -> Weighed {
    let pull = weigh(equations, &multipliers, costs).pull;
    if pull > 1.0 {
        multipliers.iter_mut().for_each(|m| *m /= pull);
    }
    let weighed = weigh(equations, &multipliers, costs);
    if weighed.value > 0.0 && weighed.value.is_finite() {
        return weighed;
    }
    // No amount is negative: nothing at all proves 0.
    weigh(equations, &vec![0.0; equations.matrix.rows], costs)
}
