//! Viscosity of engine oils over temperature, and what heats and cools a film.
//!
//! ```text
//! log10 log10(nu + 0.7) = A - B log10 T        nu in cSt, T in K (Walther; ASTM D341)        mu = nu rho
//! ```

use crate::error::{FilmError, require};
use serde::{Deserialize, Serialize};

/// Specific heat of mineral oil at work [J/(kg K)], typical.
pub const SPECIFIC_HEAT: f64 = 2000.0;
/// Share of the friction power that leaves with the oil, the rest by the housing; typical.
pub const HEAT_SHARE: f64 = 0.8;
/// Density where none is given [kg/m3], typical at work.
pub const DENSITY: f64 = 850.0;

/// Typical kinematic viscosities [cSt] at 40 and 100 degC of grades of SAE J300; a product's sheet is better.
const GRADES: [(&str, f64, f64); 12] = [
    ("0W-16", 35.0, 7.2),
    ("0W-20", 44.0, 8.5),
    ("0W-30", 55.0, 10.8),
    ("0W-40", 75.0, 13.5),
    ("5W-20", 48.0, 8.7),
    ("5W-30", 63.0, 10.8),
    ("5W-40", 84.0, 14.0),
    ("10W-30", 70.0, 10.6),
    ("10W-40", 96.0, 14.2),
    ("15W-40", 108.0, 14.5),
    ("20W-50", 165.0, 18.8),
    ("30", 94.0, 11.0),
];

/// An oil whose viscosity follows its temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct OilCurve {
    /// A of Walther's line.
    pub intercept: f64,
    /// B of Walther's line.
    pub slope: f64,
    /// Density [kg/m3].
    pub density: f64,
}

impl OilCurve {
    /// The line through two kinematic viscosities [m2/s] at two temperatures [K].
    ///
    /// # Errors
    /// [`FilmError::Number`] where they do not fall with temperature or the density is not above 0.
    pub fn through(cool: (f64, f64), hot: (f64, f64), density: f64) -> Result<OilCurve, FilmError> {
        check_density(density)?;
        require(
            cool.0 > 0.0 && hot.0 > cool.0,
            "higher of the two temperatures of the oil [K]",
            "above the lower one",
            hot.0,
        )?;
        require(
            hot.1 > 0.0 && cool.1 > hot.1,
            "kinematic viscosity at the lower temperature [m2/s]",
            "above that at the higher one",
            cool.1,
        )?;
        let double = |viscosity: f64| (viscosity * 1e6 + 0.7).log10().log10();
        require(
            double(hot.1).is_finite(),
            "kinematic viscosity at the higher temperature [m2/s]",
            "above 0.3e-6",
            hot.1,
        )?;
        let slope = (double(cool.1) - double(hot.1)) / (hot.0.log10() - cool.0.log10());
        Ok(OilCurve { intercept: double(cool.1) + slope * cool.0.log10(), slope, density })
    }

    /// A grade such as "SAE 5W-30" with typical viscosities; `None` where the grade is not in the list ([`oil_grades`]).
    pub fn of_grade(name: &str, density: f64) -> Option<OilCurve> {
        let wanted = name.trim().to_uppercase();
        let wanted = wanted.strip_prefix("SAE").unwrap_or(&wanted).trim().to_owned();
        let (_, cool, hot) = GRADES.iter().find(|(grade, ..)| *grade == wanted)?;
        OilCurve::through((313.15, cool * 1e-6), (373.15, hot * 1e-6), density).ok()
    }

    /// Dynamic viscosity [Pa s] at a temperature [K].
    pub fn viscosity(&self, temperature: f64) -> f64 {
        let exponent = 10f64.powf(self.intercept - self.slope * temperature.log10());
        (10f64.powf(exponent) - 0.7) * 1e-6 * self.density
    }
}

/// Names of the grades that [`OilCurve::of_grade`] knows.
pub fn oil_grades() -> impl Iterator<Item = &'static str> {
    GRADES.iter().map(|(grade, ..)| *grade)
}

/// Accepted densities of oils [kg/m3].
pub const OIL_DENSITY: [f64; 2] = [500.0, 2000.0];

/// Refuses a density that no lubricant has.
///
/// # Errors
/// [`FilmError::Number`].
pub fn check_density(density: f64) -> Result<(), FilmError> {
    require(
        (OIL_DENSITY[0]..=OIL_DENSITY[1]).contains(&density),
        "density of the oil [kg/m3]",
        "from 500 to 2000",
        density,
    )
}

/// Rise of the oil's temperature through a bearing [K]: share P / (rho c_p Q).
pub fn temperature_rise(power: f64, flow: f64, density: f64) -> f64 {
    HEAT_SHARE * power / (density * SPECIFIC_HEAT * flow)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_goes_through_both_points_and_grades_are_found() {
        let oil = OilCurve::of_grade("SAE 5W-30", 850.0).expect("known");
        assert!((oil.viscosity(313.15) / (63e-6 * 850.0) - 1.0).abs() < 1e-12);
        assert!((oil.viscosity(373.15) / (10.8e-6 * 850.0) - 1.0).abs() < 1e-12);
        // Two points of a line fix a third: at 150 degC such an oil has 4 to 5 cSt.
        assert!((3.8e-6..5.0e-6).contains(&(oil.viscosity(423.15) / 850.0)));
        assert!(OilCurve::of_grade("5w-30", 850.0).is_some() && OilCurve::of_grade("olive", 850.0).is_none());
        assert!(OilCurve::through((313.15, 1e-5), (373.15, 2e-5), 850.0).is_err());
    }
}
