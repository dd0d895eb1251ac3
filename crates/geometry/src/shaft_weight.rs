//! The best weight of a balance shaft: the lightest, the shortest or the one of least radius for an unbalance.
//!
//! Of the shapes of [`ShaftWeightShape`] with the density `rho` and the length `L`, `U = rho L S(R, c)` and `m = rho L A(R, c) = U A/S`. What follows is
//! derived in the book, eqs. (22.55) to (22.59): `S` grows with `R` and falls with `|c|`; `A/S` falls with `R` and with `c`, also along
//! a line of equal `S`. Each optimum is therefore at the end of a range, or where a range of another dimension ends, and found by
//! halving a monotonous function: no search, nothing to prove beyond.

use lanchester_model::Range;
use lanchester_shape::{GeometryError, Part, ShaftWeightShape, plausible_density};
use serde::Serialize;

/// What of a shaft's weight is made as small as possible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShaftWeightAim {
    /// Its mass.
    Mass,
    /// Its length along the shaft; among equal ones its mass.
    Length,
    /// Its radius; among equal ones its mass.
    Radius,
}

/// A weight to be found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftWeightTask {
    /// Unbalance that it must have [kg m].
    pub unbalance: f64,
    /// Density [kg/m^3].
    pub density: f64,
    /// Radius of the shaft [m].
    pub shaft_radius: f64,
    /// Radius `R` [m].
    pub radius: Range,
    /// Distance `c` of the chord from the axis [m]; negative on the far side.
    pub chord: Range,
    /// Length `L` along the shaft [m].
    pub length: Range,
    /// What is to be small.
    pub aim: ShaftWeightAim,
}

/// A weight with its dimensions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShaftWeightDesign {
    /// Its shape.
    pub shape: ShaftWeightShape,
    /// Its length [m].
    pub length: f64,
    /// Its density [kg/m^3].
    pub density: f64,
    /// Its mass without the shaft [kg].
    pub mass: f64,
    /// Its unbalance [kg m].
    pub unbalance: f64,
    /// Its moment of inertia about the shaft's axis [kg m^2], without the shaft.
    pub polar_inertia: f64,
    /// Distance of its centre from the axis [m], without the shaft.
    pub centre: f64,
}

impl ShaftWeightDesign {
    /// A weight of this shape.
    pub fn new(shape: ShaftWeightShape, length: f64, density: f64) -> ShaftWeightDesign {
        let (moments, line) = (shape.moments(), density * length);
        let (mass, unbalance) = (line * moments.area, line * moments.first.x);
        let polar_inertia = line * moments.polar();
        ShaftWeightDesign {
            shape,
            length,
            density,
            mass,
            unbalance,
            polar_inertia,
            centre: moments.centroid().x,
        }
    }

    /// The weight and the piece of the shaft within it, as a part with its middle plane at z = 0.
    ///
    /// # Errors
    /// Where its dimensions are not possible.
    pub fn part(&self) -> Result<Part, GeometryError> {
        Part::new(self.shape.outline()?, self.length, self.density)
    }
}

/// What became of a task.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "outcome")]
pub enum ShaftWeightOutcome {
    /// The best weight: none within the ranges is better, rounding apart.
    Best(ShaftWeightDesign),
    /// No weight within the ranges has the unbalance.
    Infeasible {
        /// The least unbalance within the ranges [kg m].
        least: f64,
        /// The largest one [kg m].
        most: f64,
    },
}

impl ShaftWeightTask {
    /// The best weight.
    ///
    /// # Errors
    /// Where a number has no meaning.
    pub fn best(&self) -> Result<ShaftWeightOutcome, GeometryError> {
        self.check()?;
        let nearest = 0.0f64.clamp(self.chord.least, self.chord.most);
        let line = self.unbalance / self.density;
        // First moments that go with the ends of the range of length; rounding must not refuse what is just possible.
        let room = 1.0 + 1e-12;
        let (fewest, most) = (line / self.length.most / room, line / self.length.least * room);
        let widest = self.first(self.radius.most, nearest);
        let farthest =
            if self.chord.least.abs() > self.chord.most.abs() { self.chord.least } else { self.chord.most };
        let narrowest = self.first(self.radius.least, farthest);
        if widest < fewest || narrowest > most {
            return Ok(ShaftWeightOutcome::Infeasible {
                least: self.density * self.length.least * narrowest,
                most: self.density * self.length.most * widest,
            });
        }
        let (radii, moments) = match self.aim {
            ShaftWeightAim::Mass => (self.radius, [fewest, most]),
            ShaftWeightAim::Length => {
                let largest = widest.clamp(fewest, most);
                (self.radius, [largest, largest])
            }
            ShaftWeightAim::Radius => {
                let enough = |radius: f64| self.first(radius, nearest) >= fewest;
                let Range { least, most: largest } = self.radius;
                let radius =
                    if enough(least) { least } else { halving(|radius| !enough(radius), least, largest) };
                (Range::new(radius, radius), [fewest, most])
            }
        };
        let (radius, chord) = self.lightest(radii, moments, nearest);
        let shape = ShaftWeightShape { shaft_radius: self.shaft_radius, radius, chord };
        let length = (line / shape.moments().first.x).clamp(self.length.least, self.length.most);
        Ok(ShaftWeightOutcome::Best(ShaftWeightDesign::new(shape, length, self.density)))
    }

    /// Radius and chord of the lightest weight whose first moment lies between two values: the largest chord for which there is a
    /// radius, and then the largest radius.
    fn lightest(&self, radii: Range, [fewest, most]: [f64; 2], nearest: f64) -> (f64, f64) {
        let Range { least: low, most: high } = self.chord;
        let enough = |chord: f64| self.first(radii.most, chord) >= fewest;
        let few = |chord: f64| self.first(radii.least, chord) <= most;
        let chord = if !enough(high) {
            // Too little that far out: nearer to the axis.
            halving(enough, nearest, high)
        } else if few(high) {
            high
        } else {
            // Too much even with the least radius: over to the far side, where metal is taken back.
            halving(|chord| !few(chord), (-high.abs()).max(low), low)
        };
        let fits = |radius: f64| self.first(radius, chord) <= most;
        let radius = if fits(radii.most) { radii.most } else { halving(fits, radii.least, radii.most) };
        (radius, chord)
    }

    /// First moment of the weight's area [m^3].
    fn first(&self, radius: f64, chord: f64) -> f64 {
        ShaftWeightShape { shaft_radius: self.shaft_radius, radius, chord }.moments().first.x
    }

    fn check(&self) -> Result<(), GeometryError> {
        let error = |quantity, needed, got, hint| Err(GeometryError::Number { quantity, needed, got, hint });
        plausible_density(self.density)?;
        if !(self.unbalance > 0.0 && self.unbalance.is_finite()) {
            let hint = "give the unbalance of the shaft's weight";
            return error("unbalance [kg m]", "positive", self.unbalance, hint);
        }
        for (quantity, range) in [
            ("radius of the weight [m]", self.radius),
            ("distance of the chord [m]", self.chord),
            ("length of the weight [m]", self.length),
        ] {
            let ordered = range.least <= range.most && range.least.is_finite() && range.most.is_finite();
            if !ordered {
                return error(
                    quantity,
                    "a finite range from small to large",
                    range.most,
                    "exchange both ends",
                );
            }
        }
        if self.length.least <= 0.0 {
            return error(
                "length of the weight [m]",
                "positive",
                self.length.least,
                "raise the least length",
            );
        }
        let corner = |radius, chord| ShaftWeightShape { shaft_radius: self.shaft_radius, radius, chord };
        corner(self.radius.least, self.chord.least).checked()?;
        corner(self.radius.least, self.chord.most).checked()?;
        Ok(())
    }
}

/// The last place on the way from one end to the other where a condition holds that holds at the first end.
fn halving(holds: impl Fn(f64) -> bool, mut holding: f64, mut other: f64) -> f64 {
    for _ in 0..200 {
        let middle = (holding + other) / 2.0;
        if middle == holding || middle == other {
            break;
        }
        if holds(middle) { holding = middle } else { other = middle }
    }
    holding
}
