//! Heavy-metal slugs in a counterweight, axes parallel to the shaft.
//!
//! ```text
//! dU = (rho_s - rho) pi/4 d^2 L R            of one slug, exactly: the centre of a round hole is its centroid
//! dU_n = dU SUM cos beta_k,  beta_k = (k - (n-1)/2) a,  2 R sin(a/2) = d + land      n slugs side by side on one radius
//! ```
//! | symbol     | name                                              | unit  |
//! |------------|---------------------------------------------------|-------|
//! | rho_s, rho | density of the slug and of the crank it replaces  | kg/m^3|
//! | d, L       | diameter and length of the slug                   | m     |
//! | R          | distance of its axis from the crank axis          | m     |

use crate::error::WorkshopError;
use crate::rotor::allowed::is_allowed;
use lanchester_task::workshop::Allowed;
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::{FRAC_PI_4, PI};

/// Density of the densest metal, osmium [kg/m^3] (CRC Handbook of Chemistry and Physics: 22.59 g/cm3), rounded up.
const DENSEST: f64 = 22_600.0;

/// Slugs that may be set into one counterweight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Slug {
    /// Diameter [m].
    pub diameter: f64,
    /// Longest length [m]: the counterweight's thickness, or as far as it may be drilled.
    pub longest: f64,
    /// Distance of its axis from the crank axis [m].
    pub radius: f64,
    /// Its density [kg/m^3].
    pub density: f64,
    /// Density of the crank [kg/m^3].
    pub crank_density: f64,
    /// Least metal between two holes and between a hole and the rim [m].
    pub land: f64,
    /// Outer radius of the counterweight [m].
    pub rim: f64,
    /// Angle between the outermost slug axes that the counterweight has room for [rad].
    pub sector: f64,
}

impl Slug {
    /// Unbalance that one slug of length `length` [m] gains [kg m], along its own direction.
    pub fn gain(&self, length: f64) -> f64 {
        (self.density - self.crank_density) * self.area() * length * self.radius
    }

    /// Area of the hole [m^2].
    fn area(&self) -> f64 {
        FRAC_PI_4 * self.diameter * self.diameter
    }

    /// Angle between neighbouring slugs [rad].
    fn pitch(&self) -> f64 {
        2.0 * ((self.diameter + self.land) / (2.0 * self.radius)).asin()
    }

    /// Most slugs side by side.
    fn most(&self) -> usize {
        // Less than one slug a thousandth of a circle: more than the check below lets through.
        1 + ((self.sector + 1e-9) / self.pitch()).floor() as usize
    }

    fn check(&self, plane: &str) -> Result<(), WorkshopError> {
        let refuse = |quantity, needed: String, got, hint| {
            Err(WorkshopError::Number {
                quantity,
                part: format!("the slugs of `{plane}`"),
                needed,
                got,
                hint,
            })
        };
        for (quantity, got) in [
            ("diameter [m]", self.diameter),
            ("longest length [m]", self.longest),
            ("radius [m]", self.radius),
            ("density of the crank [kg/m3]", self.crank_density),
        ] {
            if !(got > 0.0 && got.is_finite()) {
                return refuse(quantity, "positive".into(), got, "measure it on the counterweight");
            }
        }
        if !(self.density > self.crank_density && self.density.is_finite()) {
            return refuse(
                "density [kg/m3]",
                format!("above that of the crank, {} kg/m3", self.crank_density),
                self.density,
                "tungsten heavy metal has 17000 to 18500 kg/m3; for lighter, drill a hole instead",
            );
        }
        if self.density > DENSEST {
            return refuse(
                "density [kg/m3]",
                format!("at most {DENSEST}, that of osmium"),
                self.density,
                "tungsten heavy metal has 17000 to 18500 kg/m3, written \"17 g/cm3\"",
            );
        }
        if !(self.land >= 0.0 && self.land.is_finite()) {
            return refuse("land [m]", "not negative".into(), self.land, "2 to 4 mm is usual");
        }
        let outside = self.radius + 0.5 * self.diameter + self.land;
        if self.rim.is_nan() || outside > self.rim * (1.0 + 1e-12) {
            return refuse(
                "rim radius [m]",
                format!("at least {outside:.6} (radius, half the diameter and the land)"),
                self.rim,
                "move the holes inwards or make them smaller",
            );
        }
        if self.diameter + self.land > self.radius {
            return refuse(
                "diameter [m]",
                format!("with its land at most the radius of its axis, {} m", self.radius),
                self.diameter,
                "move the holes outwards or make them smaller",
            );
        }
        if !(0.0..=PI).contains(&self.sector) {
            return refuse(
                "sector [rad]",
                "from 0 to pi".into(),
                self.sector,
                "a counterweight spans 90 to 150 deg",
            );
        }
        Ok(())
    }
}

/// Slugs for one counterweight.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SlugPlan {
    /// Unbalance that is wanted, in the frame of the crankshaft [kg m].
    #[schemars(with = "[f64; 2]")]
    pub wanted: Complex64,
    /// What the slugs are cut from.
    pub slug: Slug,
    /// Most that one slug gains, along its own direction [kg m].
    pub gain_of_one: f64,
    /// Length of every slug [m].
    pub length: f64,
    /// Direction of every slug, in the frame of the crankshaft [rad].
    pub directions: Vec<f64>,
    /// Unbalance gained [kg m].
    #[schemars(with = "[f64; 2]")]
    pub gained: Complex64,
    /// Mass that the counterweight gains [kg].
    pub added_mass: f64,
    /// Whether the counterweight has room for all that is wanted.
    pub reached: bool,
}

/// The fewest slugs that gain `wanted` in the counterweight `plane`, all of one length, side by side about its direction
/// and all at angles that may be used; as many as fit at their longest where that is not enough.
///
/// # Errors
/// [`WorkshopError`] for slugs that cannot be.
pub fn slug_plan(
    plane: &str,
    wanted: Complex64,
    allowed: &Allowed,
    slug: &Slug,
) -> Result<SlugPlan, WorkshopError> {
    slug.check(plane)?;
    let gain_of_one = slug.gain(slug.longest);
    let amount = wanted.norm();
    let offsets = |count: usize| {
        let (middle, pitch) = (0.5 * (count as f64 - 1.0), slug.pitch());
        (0..count).map(move |k| (k as f64 - middle) * pitch)
    };
    let effect = |count: usize| offsets(count).map(f64::cos).sum::<f64>();
    let direction = wanted.arg();
    // Beyond a quarter turn to either side another slug takes away.
    let fits: Vec<usize> = (1..=slug.most())
        .filter(|n| offsets(*n).all(|beta| beta.abs() < 0.5 * PI && is_allowed(allowed, direction + beta)))
        .collect();
    let fewest = fits.iter().copied().find(|&n| gain_of_one * effect(n) >= amount * (1.0 - 1e-12));
    let (count, length) = match (amount > 0.0, fewest) {
        (false, _) => (0, 0.0),
        (true, Some(n)) => (n, slug.longest * (amount / (gain_of_one * effect(n))).min(1.0)),
        (true, None) => (fits.last().copied().unwrap_or(0), slug.longest),
    };
    let directions: Vec<f64> = offsets(count).map(|beta| direction + beta).collect();
    let gained = directions.iter().map(|d| Complex64::from_polar(slug.gain(length), *d)).sum();
    Ok(SlugPlan {
        wanted,
        slug: *slug,
        gain_of_one,
        length,
        added_mass: count as f64 * (slug.density - slug.crank_density) * slug.area() * length,
        directions,
        gained,
        reached: amount == 0.0 || fewest.is_some(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SLUG: Slug = Slug {
        diameter: 0.0254,
        longest: 0.022,
        radius: 0.070,
        density: 17_000.0,
        crank_density: 7_850.0,
        land: 0.003,
        rim: 0.090,
        sector: 1.6,
    };

    /// The first moment of the mass difference over the hole, by midpoint sums over the disc.
    #[test]
    fn gain_by_direct_integration() {
        let (count, a) = (1200, 0.5 * SLUG.diameter);
        let step = SLUG.diameter / f64::from(count);
        let mut moment = 0.0;
        for i in 0..count {
            for j in 0..count {
                let (x, y) = (-a + (f64::from(i) + 0.5) * step, -a + (f64::from(j) + 0.5) * step);
                if x * x + y * y <= a * a {
                    moment += (SLUG.radius + x) * step * step;
                }
            }
        }
        let wanted = (17_000.0 - 7_850.0) * SLUG.longest * moment;
        // The sum's staircase at the edge of the disc is good to a part in ten thousand.
        assert!((SLUG.gain(SLUG.longest) / wanted - 1.0).abs() < 1e-4);
        // By hand: 9150 * pi/4 * 0.0254^2 * 0.022 * 0.070 = 7.140 g m.
        assert!((SLUG.gain(SLUG.longest) - 7.1401e-3).abs() < 1e-7, "{}", SLUG.gain(SLUG.longest));
    }

    #[test]
    fn one_two_and_too_many() {
        let one = slug_plan("front", Complex64::new(-0.0035, 0.0), &Allowed::Any, &SLUG).unwrap();
        assert_eq!((one.directions.len(), one.reached), (1, true));
        assert!((one.length - 0.022 * 0.0035 / SLUG.gain(0.022)).abs() < 1e-12);
        // Two stand half a pitch to either side: 2 R sin(a/2) = 28.4 mm.
        let two = slug_plan("front", Complex64::new(0.0, 0.012), &Allowed::Any, &SLUG).unwrap();
        assert_eq!(two.directions.len(), 2);
        let apart =
            Complex64::from_polar(0.07, two.directions[0]) - Complex64::from_polar(0.07, two.directions[1]);
        assert!((apart.norm() - 0.0284).abs() < 1e-12);
        assert!((two.gained - two.wanted).norm() < 1e-15);
        let full = slug_plan("front", Complex64::new(0.1, 0.0), &Allowed::Any, &SLUG).unwrap();
        assert!(!full.reached && full.length == 0.022 && full.directions.len() == 4, "{full:?}");
        assert!(full.gained.norm() < 0.1);
        let none = slug_plan("front", Complex64::ZERO, &Allowed::Any, &SLUG).unwrap();
        assert!(none.directions.is_empty() && none.reached);
    }

    /// The counterweight spans 150 to 210 deg: two slugs 23.4 deg apart fit about 180 deg, one about 155 deg, none about 90.
    #[test]
    fn slugs_stay_where_there_is_metal() {
        let web =
            Allowed::Some { angles: Vec::new(), sectors: vec![[150f64.to_radians(), 210f64.to_radians()]] };
        let at = |degrees: f64, amount| {
            let wanted = Complex64::from_polar(amount, degrees.to_radians());
            slug_plan("front", wanted, &web, &SLUG).unwrap()
        };
        assert_eq!((at(180.0, 0.012).directions.len(), at(180.0, 0.012).reached), (2, true));
        assert_eq!((at(155.0, 0.012).directions.len(), at(155.0, 0.012).reached), (1, false));
        assert_eq!((at(90.0, 0.001).directions.len(), at(90.0, 0.001).reached), (0, false));
        assert_eq!(at(90.0, 0.001).gained, Complex64::ZERO);
    }

    #[test]
    fn slugs_that_cannot_be() {
        let refused =
            |slug: Slug| slug_plan("front", Complex64::ONE, &Allowed::Any, &slug).unwrap_err().to_string();
        assert!(refused(Slug { density: 7_000.0, ..SLUG }).contains("above that of the crank"));
        assert!(refused(Slug { density: 170_000.0, ..SLUG }).contains("that of osmium"));
        assert!(refused(Slug { rim: 0.08, ..SLUG }).contains("rim radius [m] of the slugs of `front`"));
        assert!(refused(Slug { radius: 0.02, ..SLUG }).contains("at most the radius of its axis"));
        assert!(refused(Slug { longest: 0.0, ..SLUG }).contains("longest length [m]"));
        assert!(refused(Slug { rim: f64::NAN, ..SLUG }).contains("rim radius"));
        assert!(refused(Slug { sector: 4.0, ..SLUG }).contains("from 0 to pi"));
    }

    proptest! {
        /// What is reached is gained exactly, with one slug fewer than that it would not be.
        #[test]
        fn prop_gains_what_is_wanted(amount in 1e-5f64..0.03, direction in -3.0f64..3.0, d in 0.01f64..0.03) {
            let slug = Slug { diameter: d, ..SLUG };
            let wanted = Complex64::from_polar(amount, direction);
            let plan = slug_plan("front", wanted, &Allowed::Any, &slug).unwrap();
            if plan.reached {
                prop_assert!((plan.gained - wanted).norm() < 1e-12 * amount.max(1e-3));
                prop_assert!(plan.length <= slug.longest);
                if let [first, second, ..] = plan.directions[..] {
                    let room = (plan.directions.len() - 2) as f64 * (second - first).abs();
                    let fewer = slug_plan("front", wanted, &Allowed::Any, &Slug { sector: room, ..slug }).unwrap();
                    prop_assert!(!fewer.reached && fewer.directions.len() + 1 == plan.directions.len());
                }
            } else {
                prop_assert!(plan.gained.norm() < amount);
            }
        }
    }
}
