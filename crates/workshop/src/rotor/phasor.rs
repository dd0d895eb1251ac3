//! From what the instrument shows to complex numbers, and back: the only place that knows senses and phases.
//!
//! ```text
//! s = +1 if the rotor turns in the sense in which angles count, -1 if against it
//! unbalance U at angle a on the rotor          u = U exp(i s a)
//! sensor at angle b, keyphasor at angle k      v = V exp(i (phase - s (k - b)))      phase as a lead
//! ```
//! A point of the rotor at angle a stands at `k + a + s omega t` on the housing if t counts from the pulse, so an
//! unbalance pulls towards the sensor as `cos(k + a - b + s omega t) = Re exp(i omega t) exp(i s (k + a - b))`: with the
//! factor `exp(-i s (k - b))` taken off, v/u is the response of the machine alone, and its argument is the angle by
//! which the peak of the velocity leads the passing of the heavy spot at the sensor.

use lanchester_task::workshop::{
    Detector, PhaseConvention, Rotor, Sense, Sensor, Vibration, VibrationQuantity,
};
use num_complex::Complex64;
use std::f64::consts::{SQRT_2, TAU};

/// How angles and phases of a sheet are counted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Convention {
    /// +1 if the rotor turns in the sense in which angles count, -1 if against it.
    sense: f64,
    /// +1 if phases are leads, -1 if lags.
    lead: f64,
    keyphasor: f64,
}

impl Convention {
    /// The convention of a rotor; `None` where it is not stated.
    pub(crate) fn of(rotor: &Rotor) -> Option<Convention> {
        let (marks, rotation): (Sense, Sense) = (rotor.marks?, rotor.rotation?);
        Some(Convention {
            sense: if marks == rotation { 1.0 } else { -1.0 },
            lead: if rotor.phase? == PhaseConvention::Lead { 1.0 } else { -1.0 },
            keyphasor: rotor.keyphasor,
        })
    }

    /// An unbalance [kg m] at an angle on the rotor.
    pub(crate) fn unbalance(&self, amount: f64, angle: f64) -> Complex64 {
        Complex64::from_polar(amount, self.sense * angle)
    }

    /// The unbalance as amount times `exp(i angle on the rotor)`; its own inverse.
    pub(crate) fn on_rotor(&self, unbalance: Complex64) -> Complex64 {
        if self.sense > 0.0 { unbalance } else { unbalance.conj() }
    }

    /// Peak of the vibration velocity [m/s] as a complex number, freed from where sensor and keyphasor stand.
    pub(crate) fn velocity(
        &self,
        sensor: &Sensor,
        vibration: Vibration,
        phase: f64,
        speed: f64,
    ) -> Complex64 {
        let peak = vibration.amplitude * peak_of(sensor.detector);
        let shown =
            Complex64::from_polar(peak, self.lead * phase - self.sense * (self.keyphasor - sensor.angle));
        shown * to_velocity(vibration.quantity, speed)
    }

    /// What the instrument shows of a velocity: amplitude and phase within [0, 2 pi).
    pub(crate) fn shown(
        &self,
        sensor: &Sensor,
        quantity: VibrationQuantity,
        velocity: Complex64,
        speed: f64,
    ) -> (Vibration, f64) {
        let shown = velocity / to_velocity(quantity, speed)
            * Complex64::from_polar(1.0, self.sense * (self.keyphasor - sensor.angle));
        let amplitude = shown.norm() / peak_of(sensor.detector);
        (Vibration { quantity, amplitude }, (self.lead * shown.arg()).rem_euclid(TAU))
    }
}

/// Peak over what the detector gives.
pub(crate) fn peak_of(detector: Detector) -> f64 {
    match detector {
        Detector::Peak => 1.0,
        Detector::PeakToPeak => 0.5,
        Detector::Rms => SQRT_2,
    }
}

/// Velocity over the quantity, for a vibration `Re exp(i speed t)`.
pub(crate) fn to_velocity(quantity: VibrationQuantity, speed: f64) -> Complex64 {
    match quantity {
        VibrationQuantity::Displacement => Complex64::new(0.0, speed),
        VibrationQuantity::Velocity => Complex64::new(1.0, 0.0),
        VibrationQuantity::Acceleration => Complex64::new(0.0, -1.0 / speed),
    }
}
