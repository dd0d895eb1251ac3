//! Forward and backward substitution by the supernodes of a factor, some right-hand sides side by side.
//!
//! ```text
//! forward, supernodes upwards:     y_c = (b_c - SUM_(k<c) L_ck y_k) / L_cc
//! backward, supernodes downwards:  x_c = (y_c - SUM_(r>c) L_rc x_r) / L_cc
//! ```
//!
//! What it takes is one reading of the factor each way, so right-hand sides share it: entries of one unknown lie side by side, and each entry of
//! the factor is one factor of a whole row. Columns go in panels, whose sums stay in registers. Two halves of the elimination tree go on two threads.

use super::halves::Halves;
use super::real::Real;
use lanchester_numerics::{Kernel, dispatch};

/// Columns of a panel.
const PANEL: usize = 8;

/// Columns of a factor with the same rows below.
#[derive(Debug, Clone, Copy)]
pub(super) struct Supernode<'a, T> {
    /// Its first column.
    pub start: usize,
    /// How many it has.
    pub columns: usize,
    /// Rows below.
    pub below: &'a [u32],
    /// Column after column, from the first row of the supernode on.
    pub values: &'a [T],
}

/// Solves `L L^T x = b` for `WIDTH` right-hand sides, in place.
pub(super) fn substitute<'a, T: Real + 'a, const WIDTH: usize>(
    halves: &Halves,
    supernode: &(impl Fn(usize) -> Supernode<'a, T> + Sync),
    x: &mut [[T; WIDTH]],
) {
    let Halves { halves: [own, other], top } = halves;
    let columns_of = |nodes: &[usize]| {
        let each =
            nodes.iter().map(|node| supernode(*node)).map(|node| node.start..node.start + node.columns);
        each.collect::<Vec<_>>()
    };
    let (others, tops) = (columns_of(other), columns_of(top));
    // The other half has a copy, in which it leaves what it gives to the top.
    let mut y = x.to_vec();
    for rows in &tops {
        y[rows.clone()].fill([T::from_double(0.0); WIDTH]);
    }
    let sweep = |nodes: &[usize], is_upward: bool, x: &mut [[T; WIDTH]]| {
        dispatch(Sweep { nodes, is_upward, supernode, x });
    };
    rayon::join(|| sweep(own, true, x), || sweep(other, true, &mut y));
    for row in tops.into_iter().flatten() {
        for (x, y) in x[row].iter_mut().zip(y[row]) {
            *x += y;
        }
    }
    sweep(top, true, x);
    sweep(top, false, x);
    for rows in columns_of(top) {
        y[rows.clone()].copy_from_slice(&x[rows]);
    }
    rayon::join(|| sweep(own, false, x), || sweep(other, false, &mut y));
    for rows in others {
        x[rows.clone()].copy_from_slice(&y[rows]);
    }
}

/// Substitution through some supernodes, which rise.
struct Sweep<'b, N, T, const WIDTH: usize> {
    nodes: &'b [usize],
    is_upward: bool,
    supernode: &'b N,
    x: &'b mut [[T; WIDTH]],
}

impl<'a, N, T, const WIDTH: usize> Kernel for Sweep<'_, N, T, WIDTH>
where
    T: Real + 'a,
    N: Fn(usize) -> Supernode<'a, T>,
{
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let Sweep { nodes, is_upward, supernode, x } = self;
        let mut rows = Vec::new();
        if is_upward {
            for index in nodes {
                let node = supernode(*index);
                set_rows(&mut rows, &node);
                forward::<FMA, T, WIDTH>(&node, &rows, x);
            }
        } else {
            for index in nodes.iter().rev() {
                let node = supernode(*index);
                set_rows(&mut rows, &node);
                backward::<FMA, T, WIDTH>(&node, &rows, x);
            }
        }
    }
}

/// All rows of a supernode.
fn set_rows<T>(rows: &mut Vec<u32>, node: &Supernode<'_, T>) {
    rows.clear();
    rows.extend(node.start as u32..(node.start + node.columns) as u32);
    rows.extend_from_slice(node.below);
}

/// `a - f b`.
#[inline(always)]
fn less<const FMA: bool, T: Real, const WIDTH: usize>(mut a: [T; WIDTH], f: T, b: [T; WIDTH]) -> [T; WIDTH] {
    for k in 0..WIDTH {
        a[k] = a[k].less_product::<FMA>(f, b[k]);
    }
    a
}

/// The panel of columns from `first` on, from the row `first` on.
#[inline(always)]
fn panel<'a, T, const COLUMNS: usize>(node: &Supernode<'a, T>, first: usize) -> [&'a [T]; COLUMNS] {
    let tall = node.columns + node.below.len();
    std::array::from_fn(|k| &node.values[(first + k) * tall + first..(first + k + 1) * tall])
}

#[inline(always)]
fn forward<const FMA: bool, T: Real, const WIDTH: usize>(
    node: &Supernode<'_, T>,
    rows: &[u32],
    x: &mut [[T; WIDTH]],
) {
    let whole = node.columns / PANEL * PANEL;
    for first in (0..whole).step_by(PANEL) {
        forward_panel::<FMA, T, WIDTH, PANEL>(panel(node, first), &rows[first..], x);
    }
    for first in whole..node.columns {
        forward_panel::<FMA, T, WIDTH, 1>(panel(node, first), &rows[first..], x);
    }
}

#[inline(always)]
fn forward_panel<const FMA: bool, T: Real, const WIDTH: usize, const COLUMNS: usize>(
    columns: [&[T]; COLUMNS],
    rows: &[u32],
    x: &mut [[T; WIDTH]],
) {
    let mut solved = [[T::from_double(0.0); WIDTH]; COLUMNS];
    for c in 0..COLUMNS {
        let mut sum = x[rows[c] as usize];
        for k in 0..c {
            sum = less::<FMA, T, WIDTH>(sum, columns[k][c], solved[k]);
        }
        let by = T::from_double(1.0) / columns[c][c];
        solved[c] = sum.map(|value| value * by);
        x[rows[c] as usize] = solved[c];
    }
    take_away::<FMA, T, WIDTH, COLUMNS>(columns, solved, rows, x);
}

/// Takes from the rows below what the columns of a panel give them.
#[inline(always)]
fn take_away<const FMA: bool, T: Real, const WIDTH: usize, const COLUMNS: usize>(
    columns: [&[T]; COLUMNS],
    solved: [[T; WIDTH]; COLUMNS],
    rows: &[u32],
    x: &mut [[T; WIDTH]],
) {
    let rows = &rows[COLUMNS..];
    let below: [&[T]; COLUMNS] = columns.map(|column| &column[COLUMNS..][..rows.len()]);
    for (row, at) in rows.iter().enumerate() {
        let own = &mut x[*at as usize];
        let mut sum = *own;
        for c in 0..COLUMNS {
            sum = less::<FMA, T, WIDTH>(sum, below[c][row], solved[c]);
        }
        *own = sum;
    }
}

#[inline(always)]
fn backward<const FMA: bool, T: Real, const WIDTH: usize>(
    node: &Supernode<'_, T>,
    rows: &[u32],
    x: &mut [[T; WIDTH]],
) {
    let whole = node.columns / PANEL * PANEL;
    for first in (whole..node.columns).rev() {
        backward_panel::<FMA, T, WIDTH, 1>(panel(node, first), &rows[first..], x);
    }
    for first in (0..whole).step_by(PANEL).rev() {
        backward_panel::<FMA, T, WIDTH, PANEL>(panel(node, first), &rows[first..], x);
    }
}

#[inline(always)]
fn backward_panel<const FMA: bool, T: Real, const WIDTH: usize, const COLUMNS: usize>(
    columns: [&[T]; COLUMNS],
    rows: &[u32],
    x: &mut [[T; WIDTH]],
) {
    let below = less_below::<FMA, T, WIDTH, COLUMNS>(columns, rows, x);
    let mut solved = [[T::from_double(0.0); WIDTH]; COLUMNS];
    for c in (0..COLUMNS).rev() {
        let own = &mut x[rows[c] as usize];
        let mut sum = below[c];
        for k in 0..WIDTH {
            sum[k] += own[k];
        }
        for k in c + 1..COLUMNS {
            sum = less::<FMA, T, WIDTH>(sum, columns[c][k], solved[k]);
        }
        let by = T::from_double(1.0) / columns[c][c];
        solved[c] = sum.map(|value| value * by);
        *own = solved[c];
    }
}

/// Less the products of the columns of a panel with the rows below: sums that never leave registers.
#[inline(always)]
fn less_below<const FMA: bool, T: Real, const WIDTH: usize, const COLUMNS: usize>(
    columns: [&[T]; COLUMNS],
    rows: &[u32],
    x: &[[T; WIDTH]],
) -> [[T; WIDTH]; COLUMNS] {
    let rows = &rows[COLUMNS..];
    let below: [&[T]; COLUMNS] = columns.map(|column| &column[COLUMNS..][..rows.len()]);
    let mut sums = [[T::from_double(0.0); WIDTH]; COLUMNS];
    for (row, at) in rows.iter().enumerate() {
        let value = x[*at as usize];
        for c in 0..COLUMNS {
            sums[c] = less::<FMA, T, WIDTH>(sums[c], below[c][row], value);
        }
    }
    sums
}
