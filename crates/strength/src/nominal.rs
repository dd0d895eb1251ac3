//! Nominal alternating stresses of a throw on two supports.

use crate::crank_throws::RuleThrow;
use crate::section::WebSection;
use serde::Serialize;
use std::f64::consts::PI;

/// Half the difference between the largest and the smallest value; 0 of none.
pub fn alternation(values: impl IntoIterator<Item = f64>) -> f64 {
    let ends = values.into_iter().fold(None, |ends: Option<[f64; 2]>, value| {
        Some(ends.map_or([value; 2], |[low, high]| [low.min(value), high.max(value)]))
    });
    ends.map_or(0.0, |[low, high]| 0.5 * (high - low))
}

/// Alternating loads and nominal stresses of a web with its pin and journal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct NominalWeb {
    /// Bending moment of the radial force in the middle of the web [N m].
    pub moment: f64,
    /// Radial force in the web [N].
    pub shear: f64,
    /// Torque in the pin: the larger one of its two sides, with that of torsional vibration [N m].
    pub pin_torque: f64,
    /// Torque in the journal, with that of torsional vibration [N m].
    pub journal_torque: f64,
    /// Section modulus of the web, B W^2/6 [m^3].
    pub modulus: f64,
    /// Its cross section, B W [m^2].
    pub area: f64,
    /// Nominal bending stress of the web [Pa].
    pub sigma_b: f64,
    /// Nominal stress of the radial force [Pa].
    pub sigma_q: f64,
    /// Nominal torsional stress of the pin [Pa].
    pub pin_tau: f64,
    /// Nominal torsional stress of the journal [Pa].
    pub journal_tau: f64,
}

/// Alternating loads and nominal stresses of the pin at its oil bore.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct NominalBore {
    /// Bending moment in the plane of the bore's mouth, in the middle of the pin [N m].
    pub moment: f64,
    /// Section modulus of the bored pin [m^3].
    pub modulus: f64,
    /// Nominal bending stress [Pa].
    pub sigma: f64,
    /// Nominal torsional stress [Pa].
    pub tau: f64,
}

/// pi (D^4 - d^4)/(32 D).
fn bending_modulus(diameter: f64, bore: f64) -> f64 {
    PI * (diameter.powi(4) - bore.powi(4)) / (32.0 * diameter)
}

/// Factor for the restraint by neighbouring throws: that of trunk-piston engines.
const RESTRAINT: f64 = 1.0;

impl NominalWeb {
    /// Of the web on side `side` (0 in front of the pin, 1 behind it), from the alternating radial force and torques.
    ///
    /// ```text
    /// Q = F_R (1 - a) or F_R a      M = Q (distance of the web's middle from its main bearing)                     (49.6)
    /// sigma_B = K_e M/(B W^2/6)     sigma_Q = K_e Q/(B W)     tau = T/(pi (D^4 - d^4)/(16 D))                      (49.7)
    /// ```
    /// a: share of the front main bearing. Constant parts, such as centrifugal forces, cancel in the alternation.
    pub(crate) fn new(throw: &RuleThrow, side: usize, radial: f64, torques: [f64; 2]) -> NominalWeb {
        let WebSection {
            web_thickness,
            web_width,
            pin_diameter,
            pin_bore,
            journal_diameter,
            journal_bore,
            ..
        } = throw.sections[side];
        let share = [throw.front_share(), 1.0 - throw.front_share()][side];
        let shear = share.abs() * radial;
        let moment = shear * (throw.webs[side] - throw.mains[side]).abs();
        let pin_torque = torques[0].max(torques[1]);
        let journal_torque = torques[side];
        let (modulus, area) = (web_width * web_thickness * web_thickness / 6.0, web_width * web_thickness);
        NominalWeb {
            moment,
            shear,
            pin_torque,
            journal_torque,
            modulus,
            area,
            sigma_b: RESTRAINT * moment / modulus,
            sigma_q: RESTRAINT * shear / area,
            pin_tau: pin_torque / (2.0 * bending_modulus(pin_diameter, pin_bore)),
            journal_tau: journal_torque / (2.0 * bending_modulus(journal_diameter, journal_bore)),
        }
    }
}

impl NominalBore {
    /// Of the pin at its oil bore at `angle` from the throw [rad]; radial and tangential force over the cycle [N], tangential positive
    /// where it drives.
    ///
    /// ```text
    /// M = h (F_R cos a + F_T sin a)     h = (z_1 - z)(z - z_0)/(z_1 - z_0)     sigma = M/(pi (D^4 - d^4)/(32 D))   (49.8)
    /// ```
    pub(crate) fn new(
        throw: &RuleThrow,
        angle: f64,
        radial: &[f64],
        tangential: &[f64],
        torque: f64,
    ) -> NominalBore {
        let section = &throw.sections[0];
        let height = throw.front_share() * (throw.pin - throw.mains[0]);
        let (sin, cos) = angle.sin_cos();
        let along = radial.iter().zip(tangential).map(|(r, t)| r * cos + throw.sense * t * sin);
        let moment = height.abs() * alternation(along);
        let modulus = bending_modulus(section.pin_diameter, section.pin_bore);
        NominalBore { moment, modulus, sigma: moment / modulus, tau: torque / (2.0 * modulus) }
    }
}
