//! Angles that are sums of angles.

use std::f64::consts::TAU;

/// Steps of a degree: angles in a file are hardly ever finer.
const STEPS: f64 = 1e6;

/// What some additions of doubles may lose of an angle within a few turns [deg].
const ROUNDING: f64 = 5e-13;

/// The angle [rad], or the whole number of millionths of a degree that it misses by rounding alone: sums of "120 deg"
/// stay multiples of "120 deg".
pub fn snapped(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    let round = (degrees * STEPS).round() / STEPS;
    if (degrees - round).abs() < ROUNDING { round.to_radians() } else { angle }
}

/// The direction in [0, 2 pi), snapped.
pub fn direction(angle: f64) -> f64 {
    let turned = snapped(angle.rem_euclid(TAU));
    if turned >= TAU { 0.0 } else { turned }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn sums_of_round_angles_stay_round() {
        let third = 120_f64.to_radians();
        for step in -12..=12 {
            let sum = 0.1 + f64::from(step) * third - 0.1;
            assert_eq!(snapped(sum), (120.0 * f64::from(step)).to_radians(), "{step}");
        }
        assert_eq!(direction(480_f64.to_radians()), third);
        assert_eq!(direction(-1e-17), 0.0);
        assert_eq!(direction(3.0 * PI), PI);
    }

    #[test]
    fn other_angles_stay_as_they_are() {
        let seventh = TAU / 7.0;
        assert_eq!(snapped(seventh), seventh);
        assert_eq!(snapped(1.0), 1.0);
        assert_eq!(snapped(snapped(2.5)), snapped(2.5));
    }
}
