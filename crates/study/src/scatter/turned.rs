//! Directions that deviate, eight samples at a time.

use lanchester_numerics::{ComplexLanes, Lanes};

/// `e^{i (angle + deviation)}`, `angle` given as its cosine and sine.
#[inline(always)]
pub(crate) fn turned(cos: f64, sin: f64, deviation: &Lanes) -> ComplexLanes {
    // The series errs by less than 1e-16 up to here.
    const SMALL: f64 = 0.02;
    if deviation.0.iter().all(|d| d.abs() < SMALL) {
        let c = Lanes::each(|i| {
            let square = deviation[i] * deviation[i];
            1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)))
        });
        let s = Lanes::each(|i| {
            let square = deviation[i] * deviation[i];
            deviation[i] * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0))))
        });
        return ComplexLanes {
            re: Lanes::each(|i| cos * c[i] - sin * s[i]),
            im: Lanes::each(|i| sin * c[i] + cos * s[i]),
        };
    }
    ComplexLanes {
        re: Lanes::each(|i| cos * deviation[i].cos() - sin * deviation[i].sin()),
        im: Lanes::each(|i| sin * deviation[i].cos() + cos * deviation[i].sin()),
    }
}
