//! Combinations of the equations that no choice of the devices satisfies.
//!
//! Equations that share no device, directly or through others, are judged apart, so that each proof names only orders
//! that hang together. Without bounds the residual `rho` of least squares is the proof: `matrix^T rho = 0`,
//! `right . rho = |rho|^2`. With bounds it is the dual of the smallest distance
//!
//! ```text
//! minimise SUM over parts |a u - b|   with   ties, |u_i| <= most_i, u_i >= 0 on a given direction
//! ```

use super::equations::{Equations, RANK};
use super::functional::{Weighed, released, weigh};
use super::lightest::{bounded, pulls};
use crate::convex::curve::{Grid, Member};
use crate::convex::dense::{Matrix, RowFactors, least_squares};
use crate::convex::programme::Group;
use crate::convex::{GAP, solve};
use std::rc::Rc;

/// A distance in natural amounts that is no rounding.
const DISTANCE: f64 = 1e-12;

/// Pulls of an obstruction at devices without a largest amount are below this share of what combinations of
/// the same size can pull.
const STILL: f64 = 1e-9;

/// Rows that hang together through the devices.
#[derive(Debug, Clone, PartialEq)]
struct Block {
    /// Rows of the equations.
    rows: Vec<usize>,
    variables: Vec<usize>,
}

/// Every block that cannot be satisfied, with its proof: a combination of value 1 at no cost.
pub(super) fn obstructions(equations: &Equations, grid: &Rc<Grid>, solves: &mut usize) -> Vec<Weighed> {
    let proof = |block: &Block| {
        by_least_squares(equations, block).or_else(|| by_distance(equations, block, grid, solves))
    };
    blocks(equations).iter().filter_map(proof).collect()
}

/// The residual of the block's equations without regard to bounds.
fn by_least_squares(equations: &Equations, block: &Block) -> Option<Weighed> {
    let mut matrix = Matrix::zeros(0, block.variables.len());
    for &r in &block.rows {
        let row: Vec<f64> = block.variables.iter().map(|&v| equations.matrix[(r, v)]).collect();
        matrix.push(&row);
    }
    let mut rest: Vec<f64> = block.rows.iter().map(|&r| equations.right[r]).collect();
    // Once more, so that the residual is free of the columns to rounding of itself.
    for _ in 0..3 {
        let u = least_squares(&matrix, &rest, RANK);
        rest.iter_mut().zip(matrix.times(&u)).for_each(|(rest, reached)| *rest -= reached);
    }
    let distance = crate::convex::dense::norm(&rest);
    (distance > DISTANCE).then_some(())?;
    let mut multipliers = vec![0.0; equations.matrix.rows];
    block.rows.iter().zip(&rest).for_each(|(&r, rest)| multipliers[r] = rest / distance);
    normed(equations, &multipliers)
}

/// The multipliers of the smallest distance within the bounds.
fn by_distance(equations: &Equations, block: &Block, grid: &Rc<Grid>, solves: &mut usize) -> Option<Weighed> {
    let is_bounded = equations.devices.iter().any(|d| {
        (d.most.is_some() || d.one_sided) && d.variables.iter().any(|v| block.variables.contains(v))
    });
    is_bounded.then_some(())?;
    let nothing = vec![0.0; equations.devices.len()];
    let mut whole = bounded(equations, &nothing, grid);
    let parts: Vec<usize> = (0..equations.parts.len()).filter(|k| block.rows.contains(&(2 * k))).collect();
    for &k in &parts {
        let rows = [equations.matrix.row(2 * k), equations.matrix.row(2 * k + 1)];
        let columns = Matrix::from_rows(whole.variables, rows);
        let base = vec![-equations.right[2 * k], -equations.right[2 * k + 1]];
        whole.groups.push(Group::new(vec![Member::Vector { base, columns }]));
        whole.cost.push(1.0);
    }
    let ties: Vec<&[f64]> =
        (2 * equations.parts.len()..equations.matrix.rows).map(|r| equations.matrix.row(r)).collect();
    let ties = Matrix::from_rows(whole.variables, ties);
    let (_, open) = RowFactors::of(&ties, RANK).bases();
    let tied = whole.restricted(&vec![0.0; whole.variables], &open);
    let (range, _) = RowFactors::of(&tied.seen(), RANK).bases();
    let small = tied.restricted(&vec![0.0; tied.variables], &range);
    let solution = solve(&small, GAP, 1e-6, solves).ok()?;
    let kept: Vec<usize> = (0..whole.rows.len()).collect();
    let mut multipliers = vec![0.0; equations.matrix.rows];
    for one in &solution.support {
        if let Some(&k) = one.group.checked_sub(equations.devices.len()).and_then(|g| parts.get(g)) {
            multipliers[2 * k] = -one.y[0];
            multipliers[2 * k + 1] = -one.y[1];
        }
    }
    // What is left to the ties so that nothing moves: all multipliers together pull at no variable.
    let mut rest = pulls(&whole, &solution, &kept);
    rest.iter_mut().for_each(|r| *r = -*r);
    let of_ties = least_squares(&ties.transposed(), &rest, RANK);
    of_ties.iter().enumerate().for_each(|(i, m)| multipliers[2 * equations.parts.len() + i] = -*m);
    normed(equations, &released(equations, &multipliers))
}

/// The combination with a value of 1, if it proves anything.
fn normed(equations: &Equations, multipliers: &[f64]) -> Option<Weighed> {
    let costs = vec![0.0; equations.devices.len()];
    let value = weigh(equations, multipliers, &costs).value;
    (value > DISTANCE).then_some(())?;
    let scaled: Vec<f64> = multipliers.iter().map(|m| m / value).collect();
    Some(weigh(equations, &scaled, &costs)).filter(|weighed| weighed.pull <= STILL)
}

/// Rows that share variables, directly or through others; ties bind like the parts do.
fn blocks(equations: &Equations) -> Vec<Block> {
    let (rows, variables) = (equations.matrix.rows, equations.matrix.columns);
    // Rows first, then variables, each pointing at another of its block.
    let mut of: Vec<usize> = (0..rows + variables).collect();
    fn root(of: &[usize], mut i: usize) -> usize {
        while of[i] != i {
            i = of[i];
        }
        i
    }
    let mut join = |a: usize, b: usize| {
        let (a, b) = (root(&of, a), root(&of, b));
        of[a.max(b)] = a.min(b);
    };
    for k in 0..equations.parts.len() {
        join(2 * k, 2 * k + 1);
    }
    for device in &equations.devices {
        device.variables.windows(2).for_each(|pair| join(rows + pair[0], rows + pair[1]));
    }
    for r in 0..rows {
        for v in (0..variables).filter(|&v| equations.matrix[(r, v)].abs() > RANK) {
            join(r, rows + v);
        }
    }
    let mut blocks: Vec<(usize, Block)> = Vec::new();
    for i in 0..rows + variables {
        let root = root(&of, i);
        let block = match blocks.iter().position(|b| b.0 == root) {
            Some(place) => &mut blocks[place].1,
            None => {
                blocks.push((root, Block { rows: Vec::new(), variables: Vec::new() }));
                &mut blocks.last_mut().expect("invariant: one was just added").1
            }
        };
        if i < rows { block.rows.push(i) } else { block.variables.push(i - rows) }
    }
    blocks.retain(|b| !b.1.rows.is_empty());
    blocks.into_iter().map(|b| b.1).collect()
}
