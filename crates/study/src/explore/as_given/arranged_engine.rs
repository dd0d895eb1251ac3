//! A layout of an arrangement as an engine.

use crate::explore::as_given::arrangement::Arrangement;
use crate::explore::counterweight_pattern::CounterweightPattern;
use crate::explore::parts::Parts;
use lanchester_model::{Counterweight, Cylinder, Engine, EngineParts, Rotation, SpeedRange};
use num_complex::Complex64;
use std::f64::consts::TAU;

impl Arrangement {
    /// Weights on the webs of throw `throw` along its direction, of all groups at lead 0: plane [m] and unbalance [kg m],
    /// negative opposite the throw.
    pub(crate) fn web_weights(&self, pattern: &CounterweightPattern, throw: usize) -> Vec<(f64, f64)> {
        let own = &self.throws[throw];
        let riders = || self.cylinders.iter().filter(|cylinder| cylinder.throw == throw);
        let big_ends: f64 = riders().map(|cylinder| cylinder.rod.big_end_mass).sum();
        let masses: f64 = riders().map(Cylinder::reciprocating_mass).sum();
        let rotating = own.unbalance + big_ends * own.radius;
        let weight = -0.5 * (pattern.rotating * rotating + pattern.reciprocating * masses * own.radius);
        let planes = own.webs.expect("invariant: throws of an arrangement have webs");
        let has_weight = |side: usize| pattern.webs.as_ref().is_none_or(|webs| webs[2 * throw + side]);
        (0..2).filter(|side| has_weight(*side)).map(|side| (planes[side], weight)).collect()
    }

    /// The engine without balance shafts, each group ahead by its lead [rad]; `firing_angles` by chamber.
    pub(crate) fn engine(
        &self,
        parts: &Parts,
        pattern: &CounterweightPattern,
        leads: &[f64],
        firing_angles: Option<&[f64]>,
    ) -> Engine {
        let throws = self.turned_throws(leads);
        let weights = (0..throws.len()).flat_map(|index| {
            self.web_weights(pattern, index).into_iter().map(move |weight| (index, weight))
        });
        let counterweights = weights
            .enumerate()
            .map(|(number, (index, (z, weight)))| {
                let weight = weight * Complex64::cis(throws[index].angle);
                Counterweight {
                    name: format!("web weight {}", number + 1),
                    crankshaft: throws[index].crankshaft,
                    z,
                    unbalance: weight.norm(),
                    angle: weight.arg(),
                    part: None,
                }
            })
            .collect();
        let mut cylinders = self.cylinders.clone();
        if let Some(angles) = firing_angles {
            let cycle = TAU * f64::from(parts.strokes.revolutions());
            for (first, angle) in self.chambers().into_iter().zip(angles) {
                let pistons = cylinders.iter_mut().enumerate();
                let own = pistons.filter(|(index, piston)| piston.chamber.unwrap_or(*index) == first);
                own.for_each(|(_, piston)| piston.firing_angle = Some(angle.rem_euclid(cycle)));
            }
        }
        let engine = EngineParts {
            name: self.name.clone(),
            strokes: parts.strokes,
            rotation: Rotation::Clockwise,
            speed: SpeedRange { lowest: parts.speed, highest: parts.speed },
            crankshafts: self.crankshafts.clone(),
            throws,
            cylinders,
            counterweights,
            ..EngineParts::default()
        };
        Engine::new(engine).expect("invariant: other throw angles leave an engine what it is")
    }
}
