//! Cells for shares, grams and unbalances.

use crate::kit::number;
use crate::kit::table::Cell;
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
        rotor_angle(value.arg(), 1),
    ]
}

/// An angle on the rotor in degrees from 0 to 360; what would be printed as 360 is 0.
pub(super) fn rotor_degrees(angle: f64, decimals: usize) -> f64 {
    let degrees = angle.to_degrees().rem_euclid(360.0);
    if degrees >= 360.0 - 0.5 * 0.1_f64.powi(decimals as i32) { 0.0 } else { degrees }
}

/// The same as a cell.
pub(super) fn rotor_angle(angle: f64, decimals: usize) -> Cell {
    Cell::Number { value: rotor_degrees(angle, decimals), decimals }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_turn_is_printed_as_none() {
        for (degrees, decimals, shown) in
            [(359.96, 1, 0.0), (359.94, 1, 359.94), (359.6, 0, 0.0), (-90.0, 0, 270.0)]
        {
            assert!((rotor_degrees(f64::to_radians(degrees), decimals) - shown).abs() < 1e-9, "{degrees}");
        }
    }
}
