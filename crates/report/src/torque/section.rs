//! The section of the report on torque: gas, inertia, work, firing, cyclic speed fluctuation, flywheel and power.

use crate::gas::result::CycleResult;
use crate::gas::tables::{cycle_figures, cycle_table};
use crate::kit::number;
use crate::kit::section::Section;
use crate::torque::figures::{power_figure, ripple_figure, torque_figures};
use crate::torque::tables::{
    flywheel_table, power_table, ripple_table, ripple_words, torque_speeds_table, torque_tables,
};
use lanchester_mechanism::{Brake, FlywheelNeed, PowerCurve, RippleOutcome, Torque, TorqueAtSpeed};

/// Torque at one speed, and what follows from it.
#[derive(Debug, Clone, Copy)]
pub struct TorqueInput<'a> {
    /// Torque, work, orders, energy, firing.
    pub torque: &'a Torque,
    /// Where the pressures come from, in words.
    pub source: &'a str,
    /// What friction leaves, where it is known.
    pub brake: Option<&'a Brake>,
    /// The cycles behind the pressures, where they are computed.
    pub cycles: &'a [CycleResult],
    /// Speed within the cycle at several speeds, or why it is not known.
    pub ripples: &'a [RippleOutcome],
    /// The flywheel that a fluctuation needs, where one is wanted.
    pub flywheel: Option<&'a FlywheelNeed>,
    /// Torque and energy at several speeds.
    pub speeds: &'a [TorqueAtSpeed],
    /// Power over speed, where pressures at several speeds are known.
    pub power: Option<&'a PowerCurve>,
}

/// Torque, as a section of a report.
pub fn torque_section(input: &TorqueInput<'_>) -> Section {
    let torque = input.torque;
    let mut figures = torque_figures(torque);
    if torque.cylinders.len() == 1 {
        // One cylinder is the engine.
        figures.retain(|figure| figure.id != "torque-by-cylinder");
    }
    figures.extend(ripple_figure(input.ripples));
    if !input.cycles.is_empty() {
        figures.extend(cycle_figures(input.cycles));
    }
    figures.extend(input.power.map(power_figure));
    let mut tables = torque_tables(torque, input.brake);
    // Orders stand below their figure.
    tables.swap(1, 2);
    if !input.cycles.is_empty() {
        tables.push(cycle_table(input.cycles));
    }
    if input.ripples.iter().any(|ripple| ripple.periodic().is_some()) {
        tables.push(ripple_table(input.ripples));
    }
    tables.extend(input.flywheel.map(flywheel_table));
    if !input.speeds.is_empty() {
        tables.push(torque_speeds_table(input.speeds));
    }
    tables.extend(input.power.map(power_table));
    let title = if torque.with_gas { "Torque with gas" } else { "Torque of inertia" };
    Section::new("torque-over-cycle", "Torque", title)
        .lead(lead(input))
        .words(words(input))
        .words(ripple_words(input.ripples))
        .by_width(figures)
        .tables(tables)
}

/// Mean torque, power and what the flywheel holds.
fn lead(input: &TorqueInput<'_>) -> String {
    let torque = input.torque;
    let rpm = number::terminal(number::rpm(torque.speed), 0);
    if !torque.with_gas {
        return format!(
            "The engine file says nothing of the gas: at {rpm} rpm this is the torque of inertia alone, without a mean. A flywheel has to hold {} J.",
            number::short(torque.energy.excess, 4),
        );
    }
    let of_brake = input.brake.map_or(String::new(), |brake| {
        format!(
            " Friction leaves {} N m and {} kW at the brake.",
            number::short(brake.torque, 4),
            number::short(brake.power / 1e3, 4)
        )
    });
    format!(
        "At {rpm} rpm the gas gives {} N m in the mean and {} kW, net indicated.{of_brake} A flywheel has to hold {} J.",
        number::short(torque.indicated.torque, 4),
        number::short(torque.indicated.power / 1e3, 4),
        number::short(torque.energy.excess, 4)
    )
}

/// Where the pressures come from.
fn words(input: &TorqueInput<'_>) -> String {
    if input.torque.with_gas { format!("Pressures: {}.", input.source) } else { String::new() }
}
