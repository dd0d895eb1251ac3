//! How large loads are, so that rounding noise is told from loads.

use crate::kit::rounding::{below, largest_moment};
use lanchester_balance::natural;
use lanchester_mechanism::Loads;
use lanchester_model::Engine;
use lanchester_results::LoadSet;

/// The largest loads of the whole, of any part or of any cylinder: what has to cancel for a total to vanish.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Magnitude {
    /// Force [N].
    pub force: f64,
    /// Couple [N m].
    pub couple: f64,
    /// Roll moment [N m].
    pub roll_moment: f64,
    /// Shaft torque [N m].
    pub shaft_torque: f64,
}

impl Magnitude {
    /// Of a load calculation.
    pub fn of(loads: &Loads) -> Magnitude {
        let sets = std::iter::once(&loads.total)
            .chain(loads.parts.iter().map(|p| &p.loads))
            .chain(loads.cylinders.iter().map(|c| &c.loads));
        let mut largest = Magnitude::default();
        for set in sets {
            largest.take(set);
        }
        let moment = |own: f64| largest_moment(own, largest.force);
        Magnitude {
            force: largest.force,
            couple: moment(largest.couple),
            roll_moment: moment(largest.roll_moment),
            shaft_torque: moment(largest.shaft_torque),
        }
    }

    /// Of all moving masses together at the highest speed, if nothing cancelled: where loads are known of the whole alone.
    pub fn of_masses(engine: &Engine) -> Magnitude {
        let (force, moment) = natural(engine, engine.speed.highest);
        Magnitude { force, couple: moment, roll_moment: moment, shaft_torque: moment }
    }

    /// Below this a load of this unit is noise; 0 for units of other kinds.
    pub fn noise_of_unit(&self, unit: &str) -> f64 {
        match unit {
            "N" => self.force_noise(),
            "N m" => self.couple_noise(),
            _ => 0.0,
        }
    }

    fn take(&mut self, set: &LoadSet) {
        let larger = |a: f64, b: f64| if b.is_finite() { a.max(b) } else { a };
        self.force = larger(self.force, set.peaks.force.max_abs());
        self.couple = larger(self.couple, set.peaks.couple.max_abs());
        self.roll_moment = larger(self.roll_moment, set.peaks.roll_moment.max_abs());
        self.shaft_torque = larger(self.shaft_torque, set.peaks.shaft_torque.max_abs());
    }

    /// Below this a force is noise [N].
    pub fn force_noise(&self) -> f64 {
        below(self.force)
    }

    /// Below this a couple is noise [N m].
    pub fn couple_noise(&self) -> f64 {
        below(self.couple)
    }

    /// Below this a roll moment is noise [N m].
    pub fn roll_noise(&self) -> f64 {
        below(self.roll_moment)
    }

    /// Below this a shaft torque is noise [N m].
    pub fn torque_noise(&self) -> f64 {
        below(self.shaft_torque)
    }
}
