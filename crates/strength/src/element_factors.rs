//! Stress concentration factors from stresses of finite elements.

use crate::crank_throws::RuleThrow;
use crate::factors::FactorValues;
use crate::nominal::NominalWeb;

/// Stresses of a web's two fillets under unit loads of its throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilletStresses {
    /// Of the pin's fillet, of a constant moment in the plane of the throw: von Mises [Pa/(N m)].
    pub pin_bending: f64,
    /// The same of the journal's fillet.
    pub journal_bending: f64,
    /// Of the journal's fillet, of a radial force on the pin, the throw on two supports: von Mises [Pa/N].
    pub journal_force: f64,
    /// Of the pin's fillet, of a torque: largest shear [Pa/(N m)].
    pub pin_torsion: f64,
    /// The same of the journal's fillet.
    pub journal_torsion: f64,
}

impl FilletStresses {
    /// The factors of the web on side `side` of a throw: each stress over the nominal one of the same load.
    ///
    /// ```text
    /// alpha_B, beta_B = sigma_v/(M/(B W^2/6))      alpha_T, beta_T = ((sigma_1 - sigma_3)/2)/(T/(pi (D^4 - d^4)/(16 D)))     (49.17)
    /// beta_Q = (sigma_v - beta_B M/(B W^2/6))/(Q/(B W))         of a force on the pin: M, Q as in (49.6)                    (49.18)
    /// ```
    pub fn factors(&self, throw: &RuleThrow, side: usize) -> FactorValues {
        let nominal = NominalWeb::new(throw, side, 1.0, [1.0, 1.0]);
        let beta_b = self.journal_bending * nominal.modulus;
        let rest = self.journal_force - beta_b * nominal.moment / nominal.modulus;
        FactorValues {
            alpha_b: self.pin_bending * nominal.modulus,
            alpha_t: self.pin_torsion / nominal.pin_tau,
            beta_b,
            beta_q: rest * nominal.area / nominal.shear,
            beta_t: self.journal_torsion / nominal.journal_tau,
        }
    }
}
