//! Masses and place of a cylinder's piston and rod, with their deviations.

use crate::scatter::error::ScatterError;
use crate::scatter::value::{Deviations, Value};
use lanchester_model::Engine;
use lanchester_numerics::Lanes;
use lanchester_task::Varied;

/// What a cylinder has, whatever its rod sits on.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MovingParts {
    pub piston_mass: Value,
    pub big_end_mass: Value,
    pub small_end_mass: Value,
    /// Mass of the rod over its length: what a shift of its centre moves from end to end.
    pub rod_mass_per_length: f64,
    pub centre: Value,
    /// Length of the rod.
    pub length: Value,
    /// Net offset of the cylinder.
    pub offset: Value,
    pub plane: Value,
    /// Direction of the cylinder's axis.
    pub axis: Value,
}

/// Masses of eight samples [kg].
pub(crate) struct Masses {
    /// Piston and small end.
    pub reciprocating: Lanes,
    /// Big end.
    pub big_end: Lanes,
}

impl MovingParts {
    /// Those of cylinder `index`.
    pub fn of(engine: &Engine, index: usize, all: Deviations<'_>) -> MovingParts {
        let cylinder = &engine.cylinders[index];
        let rod = &cylinder.rod;
        let value = |quantity, nominal| all.value(quantity, index, nominal);
        MovingParts {
            piston_mass: value(Varied::PistonMass, cylinder.piston_mass),
            big_end_mass: value(Varied::BigEndMass, rod.big_end_mass),
            small_end_mass: value(Varied::SmallEndMass, rod.small_end_mass),
            rod_mass_per_length: rod.mass() / rod.length,
            centre: value(Varied::RodCentre, 0.0),
            length: value(Varied::RodLength, rod.length),
            offset: value(Varied::Offset, cylinder.net_offset()),
            plane: value(Varied::CylinderPlane, cylinder.z),
            axis: value(Varied::CylinderAngle, cylinder.angle),
        }
    }

    /// Refuses tolerances within which a mass is negative; `cylinder` counts from 1.
    pub fn check_masses(&self, cylinder: usize) -> Result<(), ScatterError> {
        let masses = [&self.piston_mass, &self.big_end_mass, &self.small_end_mass];
        if masses.iter().any(|mass| mass.span()[0] < 0.0) {
            return Err(ScatterError::Impossible { cylinder, reason: "a mass would be negative" });
        }
        Ok(())
    }

    /// Masses of eight samples.
    #[inline]
    pub fn masses(&self, deviations: &[Lanes]) -> Masses {
        let moved = self.centre.at(deviations);
        let moved = Lanes::each(|i| moved[i] * self.rod_mass_per_length);
        let (piston, small) = (self.piston_mass.at(deviations), self.small_end_mass.at(deviations));
        let big = self.big_end_mass.at(deviations);
        Masses {
            reciprocating: Lanes::each(|i| piston[i] + small[i] + moved[i]),
            big_end: Lanes::each(|i| big[i] - moved[i]),
        }
    }

    /// Nominal reciprocating mass [kg], and how far it may be off.
    pub fn reciprocating(&self) -> [f64; 2] {
        let moved = self.centre.half * self.rod_mass_per_length;
        [
            self.piston_mass.nominal + self.small_end_mass.nominal,
            self.piston_mass.half + self.small_end_mass.half + moved,
        ]
    }

    /// Nominal mass of the big end [kg], and how far it may be off.
    pub fn big_end(&self) -> [f64; 2] {
        let moved = self.centre.half * self.rod_mass_per_length;
        [self.big_end_mass.nominal, self.big_end_mass.half + moved]
    }

    /// All masses at their largest [kg].
    pub fn largest_mass(&self) -> f64 {
        self.piston_mass.largest() + self.small_end_mass.largest() + self.big_end_mass.largest()
    }
}
