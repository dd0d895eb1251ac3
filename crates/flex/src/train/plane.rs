//! Vectors and matrices across the crank axis.

/// A vector (x, y).
pub type Plane = [f64; 2];

/// A matrix, by rows.
pub type Square = [[f64; 2]; 2];

/// The matrix of one.
pub(crate) const ONE: Square = [[1.0, 0.0], [0.0, 1.0]];

/// Turns by a quarter: e_z x a.
pub(crate) const QUARTER: Square = [[0.0, -1.0], [1.0, 0.0]];

/// Turns by an angle [rad].
pub(crate) fn turn(angle: f64) -> Square {
    let (sin, cos) = angle.sin_cos();
    [[cos, -sin], [sin, cos]]
}

/// A v.
pub(crate) fn times(a: &Square, v: Plane) -> Plane {
    [a[0][0] * v[0] + a[0][1] * v[1], a[1][0] * v[0] + a[1][1] * v[1]]
}

/// A B.
pub(crate) fn product(a: &Square, b: &Square) -> Square {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

/// R A R^T.
pub(crate) fn turned(r: &Square, a: &Square) -> Square {
    let transposed = [[r[0][0], r[1][0]], [r[0][1], r[1][1]]];
    product(r, &product(a, &transposed))
}

/// a A + b B.
pub(crate) fn sum(a: f64, x: &Square, b: f64, y: &Square) -> Square {
    [0, 1].map(|i| [0, 1].map(|j| a * x[i][j] + b * y[i][j]))
}

/// v + s w.
pub(crate) fn plus(v: Plane, s: f64, w: Plane) -> Plane {
    [v[0] + s * w[0], v[1] + s * w[1]]
}

/// Scalar product.
pub(crate) fn dot(a: Plane, b: Plane) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// e_z . (a x b): the moment of a force b at a.
pub(crate) fn cross(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Length.
pub(crate) fn length(a: Plane) -> f64 {
    a[0].hypot(a[1])
}

/// A^-1; what is no number where there is none.
pub(crate) fn inverse(a: &Square) -> Square {
    let det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    [[a[1][1] / det, -a[0][1] / det], [-a[1][0] / det, a[0][0] / det]]
}
