//! What a crank train consists of.

use super::body::CrankBody;
use super::law::TrainLaw;
use super::motion::{ImposedMotion, PeriodicForce};
use super::plane::Plane;
use super::slider::Slider;
use crate::FlexError;

/// A main bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainMain {
    /// Its number in tables.
    pub number: usize,
    /// Index of its surface in the body.
    pub surface: usize,
    /// What ties the journal to the housing.
    pub law: TrainLaw,
    /// Stiffness of the housing behind the shell of a film [N/m]; `None`: rigid.
    pub housing: Option<f64>,
}

/// A cylinder with its big end.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainCylinder {
    /// Its number in tables.
    pub number: usize,
    /// Index of the surface of its pin in the body.
    pub surface: usize,
    /// Middle of the pin in the frame of the crankshaft [m].
    pub pin: Plane,
    /// Rod and piston.
    pub slider: Slider,
    /// What ties the pin to the big end.
    pub law: TrainLaw,
    /// Stiffness of the big end behind the shell of a film [N/m]; `None`: rigid.
    pub housing: Option<f64>,
    /// Gas force on the piston towards the crank over the angle of crankshaft 1 [N].
    pub gas: PeriodicForce,
}

/// A crank train: crankshaft, bearings, rods, pistons, imposed motion.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankTrain {
    /// The crankshaft.
    pub body: CrankBody,
    /// Its main bearings.
    pub mains: Vec<TrainMain>,
    /// Its cylinders.
    pub cylinders: Vec<TrainCylinder>,
    /// Motion of crankshaft 1.
    pub motion: ImposedMotion,
    /// Speed of this crankshaft over that of crankshaft 1, signed.
    pub ratio: f64,
    /// Its angle where that of crankshaft 1 is zero [rad].
    pub phase: f64,
}

impl CrankTrain {
    /// Refuses what cannot run.
    ///
    /// # Errors
    /// [`FlexError::Number`] for fewer than two main bearings, surfaces that the body does not have, a speed that is none, a housing behind a bearing without film; [`FlexError::FreeMotion`] for a rigid crankshaft
    /// whose rigid bearings are indeterminate.
    pub fn check(&self) -> Result<(), FlexError> {
        let refuse = |quantity: &str, needed: &str, got: f64, hint| {
            Err(FlexError::Number { quantity: quantity.to_owned(), needed: needed.to_owned(), got, hint })
        };
        if self.mains.len() < 2 {
            let hint = "a crankshaft on one bearing can tilt: give its other bearings";
            return refuse("number of main bearings", "2 or more", self.mains.len() as f64, hint);
        }
        let surfaces =
            self.mains.iter().map(|own| own.surface).chain(self.cylinders.iter().map(|own| own.surface));
        if let Some(surface) = surfaces.clone().find(|own| *own >= self.body.rows.len()) {
            let needed = format!("below {}", self.body.rows.len());
            return refuse(
                "index of a bearing surface",
                &needed,
                surface as f64,
                "the body has one surface a bearing",
            );
        }
        let speed = self.motion.speed;
        if !(speed > 0.0 && speed.is_finite()) {
            return refuse("speed [rad/s]", "above 0", speed, "a crank train turns");
        }
        let shells = self.mains.iter().map(|own| (&own.law, own.housing));
        let shells = shells.chain(self.cylinders.iter().map(|own| (&own.law, own.housing)));
        for (law, stiffness) in shells.filter_map(|(law, housing)| Some((law, housing?))) {
            if !(stiffness > 0.0 && stiffness.is_finite()) {
                return refuse("stiffness of a housing [N/m]", "above 0", stiffness, "leave it out: rigid");
            }
            if law.film().is_none() {
                let hint = "put it in series with the bearing's own stiffness";
                return refuse("housings behind a bearing without film", "0", 1.0, hint);
            }
        }
        let elastic = self.body.stiffness.iter().any(|k| *k > 0.0);
        let rigid = self.mains.iter().filter(|own| own.law.is_rigid()).count();
        if !elastic && rigid > 2 {
            return refuse(
                "number of rigid main bearings of a rigid crankshaft",
                "at most 2, whose loads follow from equilibrium alone",
                rigid as f64,
                "let the crankshaft or the bearings yield",
            );
        }
        Ok(())
    }
}
