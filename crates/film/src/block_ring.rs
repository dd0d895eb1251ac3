//! A ring of unknowns, so many a column, each column coupled to its two neighbours.
//!
//! ```text
//! A_i p_i - E_i p_(i-1) - E_(i+1) p_(i+1) = s_i      A, E symmetric; E_i couples columns i - 1 and i, E_0 the last and the first
//! ```
//! The last column is set apart: `p_i = a_i + T_i p_last` for the others, eliminated one after the other.

use crate::axial::{Block, Line, SHAPES};

const ZERO: Block = [[0.0; SHAPES]; SHAPES];

/// Factors of a ring.
#[derive(Debug, Clone, Default)]
pub(crate) struct BlockRing {
    /// E of each column.
    couplings: Vec<Block>,
    /// Inverse of what elimination leaves of A.
    inverse: Vec<Block>,
    /// From the next column to this one: inverse times E.
    next: Vec<Block>,
    /// From the last column to this one.
    ring: Vec<Block>,
}

impl BlockRing {
    /// Factors of a ring of three or more columns, positive definite.
    pub fn new(diagonal: &[Block], couplings: Vec<Block>) -> BlockRing {
        let last = couplings.len() - 1;
        let mut own = BlockRing {
            inverse: vec![ZERO; last + 1],
            next: vec![ZERO; last],
            ring: vec![ZERO; last],
            couplings,
        };
        let (mut left, mut closing) = (diagonal[0], own.couplings[0]);
        for i in 0..last {
            if i + 1 == last {
                plus(&mut closing, 1.0, &own.couplings[last]);
            }
            own.inverse[i] = inverse(left);
            own.ring[i] = product(&own.inverse[i], &closing);
            if i + 1 < last {
                let coupling = &own.couplings[i + 1];
                own.next[i] = product(&own.inverse[i], coupling);
                left = diagonal[i + 1];
                plus(&mut left, -1.0, &product(coupling, &own.next[i]));
                closing = product(coupling, &own.ring[i]);
            }
        }
        for i in (0..last - 1).rev() {
            let through = product(&own.next[i], &own.ring[i + 1]);
            plus(&mut own.ring[i], 1.0, &through);
        }
        let mut left = diagonal[last];
        plus(&mut left, -1.0, &product(&own.couplings[last], &own.ring[last - 1]));
        plus(&mut left, -1.0, &product(&own.couplings[0], &own.ring[0]));
        own.inverse[last] = inverse(left);
        own
    }

    /// Solves in place.
    pub fn solve(&self, p: &mut [Line]) {
        let last = p.len() - 1;
        for i in 0..last {
            let here = times(&self.inverse[i], &p[i]);
            p[i] = here;
            if i + 1 < last {
                add(&mut p[i + 1], &times(&self.couplings[i + 1], &here));
            }
        }
        for i in (0..last - 1).rev() {
            let from = times(&self.next[i], &p[i + 1]);
            add(&mut p[i], &from);
        }
        let mut side = p[last];
        add(&mut side, &times(&self.couplings[last], &p[last - 1]));
        add(&mut side, &times(&self.couplings[0], &p[0]));
        let end = times(&self.inverse[last], &side);
        p[last] = end;
        for (p, ring) in p.iter_mut().zip(&self.ring) {
            add(p, &times(ring, &end));
        }
    }
}

/// `A x`.
#[inline(always)]
pub(crate) fn times(a: &Block, x: &Line) -> Line {
    let mut y = [0.0; SHAPES];
    for (i, y) in y.iter_mut().enumerate() {
        for k in 0..SHAPES {
            *y += a[i][k] * x[k];
        }
    }
    y
}

#[inline(always)]
fn add(to: &mut Line, from: &Line) {
    for k in 0..SHAPES {
        to[k] += from[k];
    }
}

/// `A + s B` into A.
#[inline(always)]
pub(crate) fn plus(to: &mut Block, share: f64, from: &Block) {
    for i in 0..SHAPES {
        for k in 0..SHAPES {
            to[i][k] += share * from[i][k];
        }
    }
}

#[inline(always)]
fn product(a: &Block, b: &Block) -> Block {
    let mut c = ZERO;
    for i in 0..SHAPES {
        for k in 0..SHAPES {
            let share = a[i][k];
            for j in 0..SHAPES {
                c[i][j] += share * b[k][j];
            }
        }
    }
    c
}

/// Inverse of a positive definite block, by Gauss and Jordan without pivots.
#[inline(always)]
fn inverse(mut a: Block) -> Block {
    for k in 0..SHAPES {
        let pivot = 1.0 / a[k][k];
        a[k][k] = 1.0;
        for j in 0..SHAPES {
            a[k][j] *= pivot;
        }
        let row = a[k];
        for (i, other) in a.iter_mut().enumerate() {
            if i == k {
                continue;
            }
            let share = other[k];
            other[k] = 0.0;
            for j in 0..SHAPES {
                other[j] -= share * row[j];
            }
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solved_ring_gives_its_right_side() {
        let count = 7;
        let number = |i: usize, j: usize, k: usize| ((13 * i + 7 * j + 3 * k) as f64).sin();
        let symmetric = |i: usize, share: f64, whole: f64| {
            let mut block = ZERO;
            for j in 0..SHAPES {
                for k in 0..SHAPES {
                    block[j][k] = share * (number(i, j, k) + number(i, k, j));
                }
                block[j][j] += whole;
            }
            block
        };
        let diagonal: Vec<Block> = (0..count).map(|i| symmetric(i, 0.2, 9.0)).collect();
        let couplings: Vec<Block> = (0..count).map(|i| symmetric(i + 50, 0.1, 1.0)).collect();
        let wanted: Vec<Line> = (0..count).map(|i| std::array::from_fn(|k| number(i, k, 90))).collect();
        let mut p = wanted.clone();
        BlockRing::new(&diagonal, couplings.clone()).solve(&mut p);
        for i in 0..count {
            let (before, after) = ((i + count - 1) % count, (i + 1) % count);
            let own = times(&diagonal[i], &p[i]);
            let [west, east] = [times(&couplings[i], &p[before]), times(&couplings[after], &p[after])];
            for k in 0..SHAPES {
                assert!((own[k] - west[k] - east[k] - wanted[i][k]).abs() < 1e-12, "{i} {k}");
            }
        }
    }
}
