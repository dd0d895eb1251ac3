//! Colours of a scale from 0 to 1: blue, cyan, green, yellow, red, as finite element programs have them.

/// Stops of the scale: red, green, blue as a screen shows them.
const STOPS: [[f64; 3]; 6] = [
    [0.16, 0.25, 0.62],
    [0.13, 0.55, 0.82],
    [0.22, 0.72, 0.52],
    [0.80, 0.84, 0.27],
    [0.96, 0.60, 0.16],
    [0.78, 0.12, 0.14],
];

/// Red, green and blue, as a screen shows them, of a part from 0 to 1; what lies outside is taken for the nearer end, no number for grey.
pub fn colour(part: f64) -> [f64; 3] {
    if part.is_nan() {
        return [0.6; 3];
    }
    let place = part.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let low = (place as usize).min(STOPS.len() - 2);
    let share = place - low as f64;
    std::array::from_fn(|k| (1.0 - share) * STOPS[low][k] + share * STOPS[low + 1][k])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_goes_from_blue_to_red_without_a_jump() {
        assert!(colour(-1.0) == colour(0.0) && colour(2.0) == colour(1.0));
        assert!(colour(0.0)[2] > 0.6 && colour(1.0)[0] > 0.7 && colour(1.0)[2] < 0.2);
        assert_eq!(colour(f64::NAN), [0.6; 3]);
        for k in 0..100 {
            let (a, b) = (colour(f64::from(k) / 100.0), colour(f64::from(k + 1) / 100.0));
            assert!((0..3).all(|c| (a[c] - b[c]).abs() < 0.04));
        }
    }
}
