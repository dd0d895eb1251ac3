//! From the frame of the engine to the screen, seen from the free end: x up, +y to the right (to the left for an
//! engine that turns the other way), so that the crank turns clockwise on the screen (anticlockwise).

use lanchester_model::Rotation;
use num_complex::Complex64;

/// A plane across the crank on the screen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    /// Where the crank axis stands [px].
    pub centre: (f64, f64),
    /// Pixels for one unit.
    pub scale: f64,
    /// 1, or -1 if +y points left.
    pub side: f64,
}

impl View {
    pub fn new(rotation: Rotation, centre: (f64, f64), scale: f64) -> View {
        View { centre, scale, side: side(rotation) }
    }

    /// Point `x + i y` on the screen.
    pub fn at(&self, point: Complex64) -> (f64, f64) {
        let (dx, dy) = self.span(point);
        (self.centre.0 + dx, self.centre.1 + dy)
    }

    /// Vector `x + i y` on the screen.
    pub fn span(&self, vector: Complex64) -> (f64, f64) {
        (self.side * vector.im * self.scale, -vector.re * self.scale)
    }

    /// Screen angle (x right, y down) of a direction in the frame, continuous in it.
    pub fn angle(&self, direction: f64) -> f64 {
        // e^{i a} is (side sin a, -cos a) on the screen.
        if self.side > 0.0 {
            direction - std::f64::consts::FRAC_PI_2
        } else {
            -direction - std::f64::consts::FRAC_PI_2
        }
    }
}

/// 1 if +y points right, -1 if it points left.
pub(crate) fn side(rotation: Rotation) -> f64 {
    match rotation {
        Rotation::Clockwise => 1.0,
        Rotation::Reverse => -1.0,
    }
}

/// A rectangle that grows around points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub low: (f64, f64),
    pub high: (f64, f64),
}

impl Bounds {
    pub fn empty() -> Bounds {
        Bounds { low: (f64::INFINITY, f64::INFINITY), high: (f64::NEG_INFINITY, f64::NEG_INFINITY) }
    }

    /// Takes in a disc.
    pub fn take(&mut self, at: (f64, f64), radius: f64) {
        if at.0.is_finite() && at.1.is_finite() {
            self.low = (self.low.0.min(at.0 - radius), self.low.1.min(at.1 - radius));
            self.high = (self.high.0.max(at.0 + radius), self.high.1.max(at.1 + radius));
        }
    }

    pub fn width(&self) -> f64 {
        (self.high.0 - self.low.0).max(1e-6)
    }

    pub fn height(&self) -> f64 {
        (self.high.1 - self.low.1).max(1e-6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_crank_turns_clockwise_and_the_reverse_engine_anticlockwise() {
        for (rotation, right) in [(Rotation::Clockwise, 1.0), (Rotation::Reverse, -1.0)] {
            let view = View::new(rotation, (100.0, 100.0), 10.0);
            assert_eq!(view.at(Complex64::new(1.0, 0.0)), (100.0, 90.0));
            assert_eq!(view.at(Complex64::new(0.0, 1.0)), (100.0 + 10.0 * right, 100.0));
            for direction in [0.3f64, 2.0, -1.0] {
                let (dx, dy) = view.span(Complex64::from_polar(1.0, direction));
                let angle = view.angle(direction);
                assert!((10.0 * angle.cos() - dx).abs() < 1e-12 && (10.0 * angle.sin() - dy).abs() < 1e-12);
            }
        }
    }
}
