//! Extent along the crank.

/// Lowest and highest of `planes` [m]; 0, 0 if there are none.
pub(crate) fn extent(planes: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] =
        planes.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    if low.is_finite() { [low, high] } else { [0.0, 0.0] }
}
