//! How large loads are, so that rounding noise is told from loads.

use lanchester_mechanism::Loads;
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

/// A load below this share of its [`Magnitude`] is rounding noise and is shown as zero.
const NOISE: f64 = 1e-9;

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
        // Couples of an engine that is all in one plane vanish with all their parts: a lever of a centimetre tells
        // noise then.
        let lever = 0.01 * largest.force;
        Magnitude {
            couple: largest.couple.max(lever),
            roll_moment: largest.roll_moment.max(lever),
            shaft_torque: largest.shaft_torque.max(lever),
            ..largest
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
        NOISE * self.force
    }

    /// Below this a couple is noise [N m].
    pub fn couple_noise(&self) -> f64 {
        NOISE * self.couple
    }

    /// Below this a roll moment is noise [N m].
    pub fn roll_noise(&self) -> f64 {
        NOISE * self.roll_moment
    }

    /// Below this a shaft torque is noise [N m].
    pub fn torque_noise(&self) -> f64 {
        NOISE * self.shaft_torque
    }
}
