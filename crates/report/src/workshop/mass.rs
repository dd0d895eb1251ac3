//! Cells for shares, grams and unbalances.

use crate::number;
use crate::table::Cell;
use num_complex::Complex64;

/// A share in percent to a tenth; what is missing is empty.
pub(super) fn percent(share: Option<f64>) -> Cell {
    share.map_or(Cell::Empty, |value| Cell::Number { value: 100.0 * value, decimals: 1 })
}

/// A mass [kg] in grams to a tenth, as the scales of a workshop show it.
pub(super) fn grams(mass: f64) -> Cell {
    Cell::Number { value: 1e3 * mass, decimals: 1 }
}

/// An unbalance [kg m] as g mm and the angle on the rotor, 0 to 360 degrees; no angle where there is none above `noise`.
pub(super) fn on_rotor(value: Complex64, noise: f64) -> [Cell; 2] {
    if value.norm() <= noise {
        return [Cell::Number { value: 0.0, decimals: 0 }, Cell::Empty];
    }
    [
        Cell::Number { value: 1e6 * value.norm(), decimals: number::decimals(1e6 * value.norm(), 4) },
        Cell::Number { value: rotor_degrees(value.arg()), decimals: 1 },
    ]
}

/// An angle on the rotor in degrees from 0 to 360; what would be printed as 360.0 is 0.
pub(super) fn rotor_degrees(angle: f64) -> f64 {
    let degrees = angle.to_degrees().rem_euclid(360.0);
    if degrees >= 359.95 { 0.0 } else { degrees }
}
