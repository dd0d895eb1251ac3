//! Torsional vibration in words, as a chapter and as text.

use super::figures::torsion_figures;
use super::result::{LimitedQuantity, TorsionResult};
use super::tables::{
    aim_unit, chain_table, critical_table, damped_mode_table, damper_table, meshed_throws_table, mode_table,
    shaft_table, time_energy_table, time_table, torsion_inertia_table, torsion_speed_table, tuning_table,
};
use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use crate::kit::table::Table;
use lanchester_torsion::{Mode, ShaftKind, TuneFree, peak};

const DEGREES: f64 = 180.0 / std::f64::consts::PI;

impl TorsionResult {
    /// What matters most.
    pub fn lead(&self) -> String {
        let sweep = &self.sweep;
        let rpm = |index: usize| number::terminal(number::rpm(sweep.speeds[index]), 0);
        let mut out = String::new();
        match self.twisting() {
            Some(0) | None => {
                if let Some(mode) = self.modes.first() {
                    out += &format!("The first natural frequency is {} Hz. ", number::short(mode.hertz(), 4));
                }
            }
            Some(index) => {
                let below: Vec<String> =
                    self.modes[..index].iter().map(|mode| number::short(mode.hertz(), 4)).collect();
                out += &format!(
                    "The first natural frequency in which the crankshaft twists is {} Hz; below it couplings, damper or pendulums give way at {} Hz. ",
                    number::short(self.modes[index].hertz(), 4),
                    below.join(", ")
                );
            }
        }
        let (at, twist) = peak(&sweep.twist.total);
        out += &format!(
            "The twist between nose and flywheel is at most ±{} deg, at {} rpm",
            number::short(DEGREES * twist, 3),
            rpm(at)
        );
        let stresses = self.stresses();
        let (at, stress) = peak(&stresses);
        if stress > 0.0 {
            out += &format!(
                "; the nominal shear stress at most ±{} MPa, at {} rpm",
                number::short(1e-6 * stress, 3),
                rpm(at)
            );
        }
        out + "."
    }

    /// The lowest mode in which the crankshaft twists more than couplings, damper or pendulums give way.
    pub fn twisting(&self) -> Option<usize> {
        let speed = self.sweep.speeds.last().copied().unwrap_or(0.0);
        let twists = |mode: &Mode| self.crank.chain.strain_share(&mode.shape, ShaftKind::Shaft, speed) > 0.5;
        self.modes.iter().position(twists)
    }

    /// The best setting of the damper, where it was asked for.
    pub(crate) fn tuned_words(&self) -> Option<String> {
        self.tuned.as_ref().map(|tuned| self.tuning_words(tuned))
    }

    /// Damper, tuning, limits and what was assumed.
    pub fn words(&self) -> Vec<String> {
        let mut out = Vec::new();
        out.extend(self.tuned_words());
        for limit in &self.limits {
            let (name, scale, unit) = match limit.quantity {
                LimitedQuantity::Twist => ("twist between nose and flywheel", DEGREES, "deg"),
                LimitedQuantity::Stress => ("vibratory shear stress", 1e-6, "MPa"),
            };
            let verdict = match (limit.is_known, limit.is_kept()) {
                (false, _) => "not known, pendulums swing beyond the linear theory",
                (true, true) => "kept",
                (true, false) => "not kept",
            };
            out.push(format!(
                "Limit of the {name} ±{} {unit}: {verdict}, ±{} {unit} at {} rpm.",
                number::short(scale * limit.allowed, 3),
                number::short(scale * limit.found, 3),
                number::terminal(number::rpm(limit.speed), 0)
            ));
        }
        out.push(format!(
            "Power put in and power lost agree to {:.0e} at every speed. Linear theory about a constant mean speed: {}.",
            self.sweep.balance.max(1e-16),
            self.gas.as_ref().map_or("inertia torques alone, no gas in the file".to_owned(), |gas| format!("gas and inertia torques, {gas}"))
        ));
        out.extend(self.notes.iter().map(|note| format!("{}.", number::capital(note))));
        out
    }

    fn tuning_words(&self, tuned: &lanchester_torsion::TunedDamper) -> String {
        let (scale, unit) = aim_unit(tuned.aim);
        let peak = |value: f64| number::short(scale * value, 4);
        let setting = match tuned.free {
            TuneFree::Damping => format!("damping {} N m s/rad", number::short(tuned.damping, 4)),
            TuneFree::Stiffness => format!("stiffness {} N m/rad", number::short(tuned.stiffness, 4)),
            TuneFree::Both => format!(
                "damping {} N m s/rad and stiffness {} N m/rad",
                number::short(tuned.damping, 4),
                number::short(tuned.stiffness, 4)
            ),
        };
        let proof = match (tuned.is_at_end, tuned.minima) {
            (true, _) => {
                "It lies at the end of the range that was searched: a wider one would give less.".to_owned()
            }
            (false, 1) => format!("The curve over {} settings has this one minimum.", tuned.curve.len()),
            (false, minima) => format!(
                "The curve over {} settings has {minima} minima, of which this is the lowest.",
                tuned.curve.len()
            ),
        };
        format!(
            "Best setting of the damper: {setting}, peak {} {unit} at {} rpm; as given {} {unit}, with the ring locked {} {unit}. {proof}",
            peak(tuned.peak),
            number::terminal(number::rpm(tuned.speed), 0),
            peak(tuned.given),
            peak(tuned.locked)
        )
    }

    fn tables(&self) -> Vec<Table> {
        let mut tables = vec![
            torsion_inertia_table(self),
            chain_table(self),
            mode_table(self),
            damped_mode_table(self),
            critical_table(self),
            shaft_table(self),
        ];
        if !self.meshed.is_empty() {
            tables.insert(2, meshed_throws_table(self));
        }
        tables.extend(damper_table(self));
        tables.extend(tuning_table(self));
        tables.extend(time_table(self));
        tables.extend(time_energy_table(self));
        tables
    }
}

/// Everything as plain text.
pub fn torsion_text(result: &TorsionResult) -> String {
    let mut out = format!("{}, torsional vibration\n\n", result.engine);
    push_wrapped(&mut out, "", &result.lead());
    out.push('\n');
    for words in result.words() {
        push_wrapped(&mut out, "", &words);
    }
    for table in result.tables() {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out
}

/// Twist, torques, stress and damper over speed, as CSV.
pub fn torsion_csv(result: &TorsionResult) -> String {
    torsion_speed_table(result).csv()
}

/// The chapter of a report: the picture first.
pub fn torsion_section(result: &TorsionResult) -> Section {
    Section::new("torsion", "Torsion", "Torsional vibration")
        .lead(result.lead())
        .by_width(torsion_figures(result))
        .paragraphs(result.words())
        .tables(result.tables())
}
