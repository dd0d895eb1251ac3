//! Vectors across the crank axis.

/// A vector (x, y) in the frame of the bearing.
pub type Plane = [f64; 2];

/// Scalar product.
pub(crate) fn dot(a: Plane, b: Plane) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// z component of the vector product.
pub(crate) fn cross(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Turned by a quarter: z x a.
pub(crate) fn quarter(a: Plane) -> Plane {
    [-a[1], a[0]]
}

/// Length.
pub(crate) fn length(a: Plane) -> f64 {
    a[0].hypot(a[1])
}

/// a + s b.
pub(crate) fn add(a: Plane, s: f64, b: Plane) -> Plane {
    [a[0] + s * b[0], a[1] + s * b[1]]
}

/// Unit vector along `a`, or x where `a` is zero, and its length.
pub(crate) fn direction(a: Plane) -> (Plane, f64) {
    let size = length(a);
    if size > 0.0 { ([a[0] / size, a[1] / size], size) } else { ([1.0, 0.0], 0.0) }
}
