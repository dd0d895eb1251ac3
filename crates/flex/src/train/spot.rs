//! Vectors of the middle of a bearing and of its end: how much further the end lies than the middle.

use super::plane::{Plane, QUARTER, Square, cross, length, times};

/// x and y of the middle, x and y of the end beside it.
pub(crate) type Spot = [f64; 4];

/// A matrix, by rows.
pub(crate) type Four = [[f64; 4]; 4];

/// The matrix of nothing.
pub(crate) const NOTHING: Four = [[0.0; 4]; 4];

/// v + s w.
pub(crate) fn add(v: &Spot, s: f64, w: &Spot) -> Spot {
    std::array::from_fn(|k| v[k] + s * w[k])
}

/// A v, of a matrix with any number of rows.
pub(crate) fn apply<const ROWS: usize>(a: &[[f64; 4]; ROWS], v: &Spot) -> [f64; ROWS] {
    a.map(|row| (0..4).map(|k| row[k] * v[k]).sum())
}

/// a A + b B.
pub(crate) fn mixed(a: f64, x: &Four, b: f64, y: &Four) -> Four {
    std::array::from_fn(|i| std::array::from_fn(|j| a * x[i][j] + b * y[i][j]))
}

/// A with the same matrix behind its columns of the middle and behind those of the end.
pub(crate) fn through_blocks(a: &Four, b: &Square) -> Four {
    a.map(|row| {
        let pair = |x: f64, y: f64| [x * b[0][0] + y * b[1][0], x * b[0][1] + y * b[1][1]];
        let ([p, q], [r, s]) = (pair(row[0], row[1]), pair(row[2], row[3]));
        [p, q, r, s]
    })
}

/// A matrix of the middle alone.
pub(crate) fn flat(a: &Square) -> Four {
    let mut all = NOTHING;
    for i in 0..2 {
        all[i][..2].copy_from_slice(&a[i]);
    }
    all
}

/// Its part of the middle.
pub(crate) fn corner(a: &Four) -> Square {
    [0, 1].map(|i| [a[i][0], a[i][1]])
}

/// Columns of the middle.
pub(crate) fn left(a: &Four) -> [Plane; 4] {
    a.map(|row| [row[0], row[1]])
}

/// The middle.
pub(crate) fn middle(v: &Spot) -> Plane {
    [v[0], v[1]]
}

/// The end beside it.
pub(crate) fn end(v: &Spot) -> Plane {
    [v[2], v[3]]
}

/// Both turned by a quarter.
pub(crate) fn quarter(v: &Spot) -> Spot {
    let ([a, b], [c, d]) = (times(&QUARTER, middle(v)), times(&QUARTER, end(v)));
    [a, b, c, d]
}

/// Moment about the crank axis of forces at both.
pub(crate) fn moment(at: &Spot, force: &Spot) -> f64 {
    cross(middle(at), middle(force)) + cross(end(at), end(force))
}

/// Work of forces along displacements of both.
pub(crate) fn work(v: &Spot, force: &Spot) -> f64 {
    (0..4).map(|k| v[k] * force[k]).sum()
}

/// Largest distance from the axis at both ends of a bearing.
pub(crate) fn furthest(e: &Spot) -> f64 {
    [1.0, -1.0].map(|sign| length([e[0] + sign * e[2], e[1] + sign * e[3]])).into_iter().fold(0.0, f64::max)
}
