//! How the bodies of the crank train are held together. All in SI units.

use lanchester_model::Engine;
use serde::Serialize;

/// Distance between the two contacts of a skirt over the bore, where nothing else is said.
const SKIRT_OVER_BORE: f64 = 0.8;

/// Joints of the crank train.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EngineJoints {
    /// Rigid: rods and pistons follow the crank.
    Ideal,
    /// Springs and dampers: crankshaft, rods and pistons move freely in their planes.
    Compliant(CompliantJoints),
}

/// Springs and dampers at the joints of the crank train.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CompliantJoints {
    /// Stiffness of every crankpin, knuckle pin and piston pin, along each axis, and of the main bearings together [N/m].
    pub stiffness: f64,
    /// Stiffness of each of the two contacts of a skirt [N/m].
    pub skirt_stiffness: f64,
    /// Damping ratio of each: its damper is `2 zeta sqrt(k m)` with the mass that swings on it.
    pub damping_ratio: f64,
    /// Distance between the two contacts along the cylinder [m]; `None`: 0.8 of the bore, or of the stroke where no bore is known.
    pub skirt_length: Option<f64>,
    /// From the piston's centre at its pin to the middle between both contacts, along the cylinder away from the crank [m]: the wall's force tilts the piston about it.
    pub skirt_offset: f64,
    /// Mass of each crankshaft [kg] and z of its centre [m]; where it is `None` the main bearings are rigid.
    pub crankshafts: Vec<Option<[f64; 2]>>,
}

impl Default for CompliantJoints {
    fn default() -> CompliantJoints {
        CompliantJoints {
            stiffness: 2e8,
            skirt_stiffness: 5e7,
            damping_ratio: 0.2,
            skirt_length: None,
            skirt_offset: 0.0,
            crankshafts: Vec::new(),
        }
    }
}

impl CompliantJoints {
    /// Damper of a spring on which a mass swings [N s/m].
    pub(crate) fn damping(&self, stiffness: f64, mass: f64) -> f64 {
        2.0 * self.damping_ratio * (stiffness * mass).sqrt()
    }

    /// Distance between the two contacts of a piston [m].
    pub(crate) fn contact_distance(&self, engine: &Engine, index: usize) -> f64 {
        self.skirt_length.unwrap_or(SKIRT_OVER_BORE * width(engine, index))
    }

    /// Inertia of a piston about its centre, across the crank's axis: a cylinder of the bore and the skirt's length [kg m^2].
    pub(crate) fn tilt_inertia(&self, engine: &Engine, index: usize) -> f64 {
        let length = self.contact_distance(engine, index);
        engine.cylinders[index].piston_mass * (width(engine, index).powi(2) / 16.0 + length * length / 12.0)
    }

    /// What is wrong with the numbers.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if !positive(self.stiffness) || !positive(self.skirt_stiffness) {
            return Some("a stiffness above 0 at every joint");
        }
        if !(0.0..=10.0).contains(&self.damping_ratio) {
            return Some("a damping ratio of its joints from 0 to 10");
        }
        if self.skirt_length.is_some_and(|length| !positive(length)) {
            return Some("a skirt length above 0");
        }
        if !self.skirt_offset.is_finite() {
            return Some("a place of its skirt contacts that is a number");
        }
        self.crankshafts
            .iter()
            .flatten()
            .any(|[mass, z]| !positive(*mass) || !z.is_finite())
            .then_some("a mass of its crankshaft above 0")
    }
}

/// Bore of a cylinder, or its stroke where no bore is known [m].
fn width(engine: &Engine, index: usize) -> f64 {
    let cylinder = &engine.cylinders[index];
    cylinder.bore.unwrap_or(2.0 * engine.throws[cylinder.throw].radius)
}
