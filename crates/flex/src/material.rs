//! An elastic material.

use crate::FlexError;
use serde::{Deserialize, Serialize};

/// A linear elastic, isotropic material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Young's modulus [Pa].
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Density [kg/m^3].
    pub density: f64,
}

impl Material {
    /// Typical steel: 210 GPa, 0.3, 7850 kg/m^3.
    pub fn steel() -> Material {
        Material { name: "steel".to_owned(), youngs_modulus: 210e9, poisson_ratio: 0.3, density: 7850.0 }
    }

    /// Lame's constants `lambda` and `mu` [Pa].
    pub fn lame(&self) -> [f64; 2] {
        let (e, nu) = (self.youngs_modulus, self.poisson_ratio);
        [e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (2.0 * (1.0 + nu))]
    }

    /// Refuses what is no elastic material.
    ///
    /// # Errors
    /// [`FlexError::Material`] unless `E > 0`, `-1 < nu < 0.5`, density not negative.
    pub fn check(&self) -> Result<(), FlexError> {
        let refuse = |quantity, needed, got| {
            Err(FlexError::Material { material: self.name.clone(), quantity, needed, got })
        };
        if !(self.youngs_modulus > 0.0 && self.youngs_modulus.is_finite()) {
            return refuse("Young's modulus [Pa]", "above zero", self.youngs_modulus);
        }
        if !(self.poisson_ratio > -1.0 && self.poisson_ratio < 0.5) {
            return refuse("Poisson's ratio", "between -1 and 0.5", self.poisson_ratio);
        }
        if !(self.density >= 0.0 && self.density.is_finite()) {
            return refuse("density [kg/m^3]", "zero or above", self.density);
        }
        Ok(())
    }
}
