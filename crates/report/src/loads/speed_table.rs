//! How the loads grow over the speed range of the engine.

use crate::kit::magnitude::Magnitude;
use crate::kit::number;
use crate::kit::table::{Cell, Column, Table, own_cells};
use lanchester_mechanism::Loads;
use lanchester_model::Engine;

/// Speeds of the table, both ends of the range included.
const STEPS: u32 = 5;

/// Largest loads at equally spaced speeds over the range of the file; `None` where the file gives one speed only.
///
/// Inertia loads grow with the square of the speed, so this needs no second calculation.
pub fn speed_table(engine: &Engine, loads: &Loads) -> Option<Table> {
    let (lowest, highest) = (engine.speed.lowest, engine.speed.highest);
    if lowest >= highest {
        return None;
    }
    let magnitude = Magnitude::of(loads);
    let peaks = &loads.total.peaks;
    let speeds: Vec<f64> =
        (0..STEPS).map(|step| lowest + (highest - lowest) * f64::from(step) / f64::from(STEPS - 1)).collect();
    let column = |peak: f64, noise: f64| {
        let peak = if peak <= noise { 0.0 } else { peak };
        own_cells(speeds.iter().map(|speed| peak * (speed / loads.speed).powi(2)), 4)
    };
    let rpm = speeds.iter().map(|speed| Cell::Number { value: number::rpm(*speed), decimals: 0 }).collect();
    Some(Table::of_columns(
        "speeds",
        "Over the speed range",
        "Largest value over the cycle; inertia loads grow with the square of the speed.",
        vec![
            (Column::numbers("speed", "rpm"), rpm),
            (Column::numbers("|F|", "N"), column(peaks.force.max.value, magnitude.force_noise())),
            (Column::numbers("|M|", "N m"), column(peaks.couple.max.value, magnitude.couple_noise())),
            (Column::numbers("|M_z|", "N m"), column(peaks.roll_moment.max_abs(), magnitude.roll_noise())),
            (Column::numbers("|T|", "N m"), column(peaks.shaft_torque.max_abs(), magnitude.torque_noise())),
        ],
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn half_the_speed_a_quarter_of_the_load() {
        let engine = sample::twin();
        let loads = sample::loads(&engine);
        assert!(speed_table(&engine, &loads).is_none(), "one speed needs no table");
        let engine = engine.with(|parts| parts.speed.lowest = 0.5 * loads.speed).expect("a range");
        let table = speed_table(&engine, &loads).expect("a range has a table");
        let force = |row: usize| match table.rows[row][1] {
            Cell::Number { value, .. } => value,
            _ => f64::NAN,
        };
        let last = table.rows.len() - 1;
        assert_eq!(force(last), loads.total.peaks.force.max.value);
        assert!((force(0) / force(last) - 0.25).abs() < 1e-12);
    }
}
