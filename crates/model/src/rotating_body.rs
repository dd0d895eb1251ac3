//! One list of all that turns at a fixed ratio to crankshaft 1, with the inertia of each and where it comes from.
//!
//! ```text
//! energy    1/2 J_E w^2    J_E = SUM rho^2 J           rho: speed of the body over that of crankshaft 1, signed
//! momentum      J_M w      J_M = SUM rho J
//! ```
//! Torque and cyclic speed fluctuation take `J_E`, roll and gyroscopic couples of the block `J_M`. What is not known is no number here: the body
//! names the key of the file that would give it, and the sums say what they lack.

use crate::crank::body::CounterweightForm;
use crate::crank::elements::CrankElementForm;
use crate::engine_parts::EngineParts;
use crate::origin::{Origin, Sourced};
use serde::Serialize;

/// A body that turns at a fixed ratio to crankshaft 1.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RotatingBody {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: RotatingKind,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: f64,
    /// Mass [kg], where it is known.
    pub mass: Option<Sourced>,
    /// Centre of mass [m] from the origin, x and y in the directions of the crankshaft at angle zero, where it is known.
    pub centre: Option<[f64; 3]>,
    /// Polar moment of inertia about its own axis [kg m^2], where it is known.
    pub inertia: Option<Sourced>,
    /// Key of the engine file that gives the inertia.
    pub key: &'static str,
}

/// What a rotating body is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RotatingKind {
    /// The crankshaft with this index, with its counterweights, without rods.
    Crankshaft(usize),
    /// The flywheel and all that turns rigidly with crankshaft 1.
    Flywheel,
    /// The balance shaft with this index.
    Shaft(usize),
    /// The gear with this index.
    Gear(usize),
}

/// A crankshaft that is a body, from its shape.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShapedCrankshaft {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass [m].
    pub centre: [f64; 3],
    /// Polar moment of inertia about its axis [kg m^2].
    pub inertia: f64,
}

impl RotatingBody {
    /// Inertia as seen at crankshaft 1 [kg m^2]: times the ratio squared.
    pub fn referred(&self) -> Option<Sourced> {
        self.inertia.map(|inertia| inertia.times(self.ratio * self.ratio))
    }

    /// Angular momentum over the speed of crankshaft 1 [kg m^2]: inertia times the ratio.
    pub fn momentum(&self) -> Option<f64> {
        self.inertia.map(|inertia| inertia.value * self.ratio)
    }

    /// Whether it is a balance shaft or a gear: what turns by gears, beside crankshafts and flywheel.
    pub fn is_geared(&self) -> bool {
        matches!(self.kind, RotatingKind::Shaft(_) | RotatingKind::Gear(_))
    }
}

impl EngineParts {
    /// All that turns at a fixed ratio to crankshaft 1: crankshafts, flywheel, balance shafts, gears.
    ///
    /// `shaped` has the crankshafts that are bodies. `[flywheel] crankshaft_inertia` goes before it and counts for all crankshafts together, as
    /// seen at crankshaft 1: each has an equal part of it about its own axis.
    pub fn rotating_bodies(&self, shaped: &[Option<ShapedCrankshaft>]) -> Vec<RotatingBody> {
        let wheel = self.flywheel.as_ref();
        let squares: f64 = self.crankshafts.iter().map(|shaft| shaft.ratio.value().powi(2)).sum();
        let given = wheel.and_then(|wheel| wheel.crankshaft_inertia).map(|seen| seen / squares);
        let mut bodies = Vec::new();
        for (index, shaft) in self.crankshafts.iter().enumerate() {
            let shape = shaped.get(index).copied().flatten();
            let inertia = given.map(Sourced::given);
            bodies.push(RotatingBody {
                name: shaft.name.clone(),
                kind: RotatingKind::Crankshaft(index),
                ratio: shaft.ratio.value(),
                mass: shape.map(|shape| Sourced::from_shape(shape.mass)),
                centre: shape.map(|shape| shape.centre),
                inertia: inertia.or(shape.map(|shape| Sourced::from_shape(shape.inertia))),
                key: "flywheel.crankshaft_inertia",
            });
        }
        bodies.push(RotatingBody {
            name: "flywheel".to_owned(),
            kind: RotatingKind::Flywheel,
            ratio: 1.0,
            mass: None,
            centre: None,
            inertia: wheel.and_then(|wheel| wheel.inertia).map(Sourced::given),
            key: "flywheel.inertia",
        });
        for (index, shaft) in self.shafts.iter().enumerate() {
            bodies.push(RotatingBody {
                name: shaft.name.clone(),
                kind: RotatingKind::Shaft(index),
                ratio: shaft.ratio.value(),
                mass: None,
                centre: None,
                inertia: shaft.inertia.map(Sourced::given),
                key: "shaft.inertia",
            });
        }
        for (index, gear) in self.gears.iter().enumerate() {
            bodies.push(RotatingBody {
                name: gear.name.clone(),
                kind: RotatingKind::Gear(index),
                ratio: gear.ratio.value(),
                mass: gear.disc.map(|disc| Sourced::from_shape(disc.mass())),
                centre: None,
                inertia: gear.inertia(),
                key: "gear.inertia",
            });
        }
        bodies
    }

    /// Inertia of balance shafts and gears as seen at crankshaft 1 [kg m^2], of those whose inertia is known.
    pub fn geared_inertia(&self) -> f64 {
        let bodies = self.rotating_bodies(&[]);
        let geared = bodies.iter().filter(|body| body.is_geared());
        geared.filter_map(RotatingBody::referred).map(|inertia| inertia.value).sum()
    }

    /// Least and largest inertia of everything that turns with crankshaft 1, as seen there [kg m^2], as far as the engine says it: flywheel and
    /// crankshafts, and at most the big ends of the rods and what is geared to the crank. `None` where flywheel or crankshafts are not known.
    ///
    /// Of crankshafts that are bodies the least are journals, pins and plain webs, the largest those with all counterweights that are parts, even
    /// where parts and webs share metal.
    pub fn crank_inertia_range(&self) -> Option<[f64; 2]> {
        let wheel = self.flywheel.as_ref()?;
        let [least, most] = match wheel.crankshaft_inertia {
            Some(given) => [given; 2],
            None => self.shaped_range()?,
        };
        let big_ends = self.cylinders.iter().map(|cylinder| {
            let throw = &self.throws[cylinder.throw];
            cylinder.rod.big_end_mass
                * (throw.radius * self.crankshafts[throw.crankshaft].ratio.value()).powi(2)
        });
        let flywheel = wheel.inertia?;
        Some([flywheel + least, flywheel + most + big_ends.sum::<f64>() + self.geared_inertia()])
    }

    /// Least and largest inertia of all crankshafts that are bodies, as seen at crankshaft 1 [kg m^2].
    fn shaped_range(&self) -> Option<[f64; 2]> {
        let parts =
            || self.counterweights.iter().filter_map(|weight| Some((weight, weight.part.as_deref()?)));
        let is_whole = |web: usize| {
            parts().any(|(_, part)| part.web == Some(web) && part.form == CounterweightForm::Web)
        };
        let [mut least, mut most] = [0.0; 2];
        for (index, shaft) in self.crankshafts.iter().enumerate() {
            let square = shaft.ratio.value().powi(2);
            for element in self.crank_elements(index).ok()? {
                let polar = element.outline().ok()?.moments().polar();
                let inertia = square * element.density * element.length() * polar;
                let replaced = matches!(element.form, CrankElementForm::Web { web, .. } if is_whole(web));
                least += if replaced { 0.0 } else { inertia };
                most += inertia;
            }
            for (_, part) in parts().filter(|(weight, _)| weight.crankshaft == index) {
                let moments = part.part.moments();
                most += square * (moments.second[0] + moments.second[1]);
            }
        }
        Some([least, most])
    }
}

/// Inertia of several bodies as seen at crankshaft 1.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct InertiaSum {
    /// Of all that is known [kg m^2].
    pub known: f64,
    /// Where it comes from: the least certain of its parts; `None` where nothing is known.
    pub origin: Option<Origin>,
    /// Names of the bodies whose inertia is not known, with the key that would give each.
    pub missing: Vec<(String, &'static str)>,
}

impl InertiaSum {
    /// The sum over these bodies.
    pub fn of(bodies: &[RotatingBody]) -> InertiaSum {
        let mut sum = InertiaSum { known: 0.0, origin: None, missing: Vec::new() };
        for body in bodies {
            match body.referred() {
                Some(inertia) => {
                    sum.known += inertia.value;
                    let origin =
                        sum.origin.map_or(inertia.origin, |known| known.least_certain(inertia.origin));
                    sum.origin = Some(origin);
                }
                None => sum.missing.push((body.name.clone(), body.key)),
            }
        }
        sum
    }
}
