//! The weight of a balance shaft: part of a disc beyond a chord, around the shaft.
//!
//! ```text
//!         .-----------.
//!       .'             '.      disc of radius R about the shaft's axis
//!      /                 \     x points up
//!     |                   |
//!     |_______     _______|    chord at the distance c from the axis; below the axis where c is negative
//!             \   /            shaft of radius r
//!              '-'
//! ```
//! The weight is what the disc has beyond the chord and outside the shaft. Book, eqs. (22.53) and (22.54).

use crate::area_moments::AreaMoments;
use crate::circular_segment::{UnitSegment, excess};
use crate::contour::{Contour, Corner};
use crate::error::GeometryError;
use crate::outline::Outline;
use crate::point::Point;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// Weights that overlap by less [m] touch.
const TOUCH: f64 = 1e-9;

/// A weight that is part of a disc around a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ShaftWeightShape {
    /// Radius `r` of the shaft [m].
    pub shaft_radius: f64,
    /// Radius `R` of the weight [m], larger than that of the shaft.
    pub radius: f64,
    /// Distance `c` of the chord from the axis [m], towards the weight; between `-R` and `r`.
    pub chord: f64,
}

impl ShaftWeightShape {
    /// The same shape, if its dimensions are possible.
    ///
    /// # Errors
    /// Where a radius is not positive, the disc is no larger than the shaft, the chord leaves the weight without a hold on the
    /// shaft, or it leaves the whole disc.
    pub fn checked(self) -> Result<ShaftWeightShape, GeometryError> {
        let error = |quantity, needed, got, hint| Err(GeometryError::Number { quantity, needed, got, hint });
        if !(self.shaft_radius > 0.0 && self.shaft_radius.is_finite()) {
            return error("radius of the shaft [m]", "positive", self.shaft_radius, "give a length");
        }
        if !(self.radius > self.shaft_radius && self.radius.is_finite()) {
            let hint = "the weight stands out of the shaft";
            return error("radius of the weight [m]", "larger than that of the shaft", self.radius, hint);
        }
        if self.chord.is_nan() || self.chord >= self.shaft_radius {
            let hint = "beyond that the weight has no hold on the shaft";
            return error("distance of the chord [m]", "less than the radius of the shaft", self.chord, hint);
        }
        if self.chord <= -self.radius {
            let hint = "a whole disc is no weight";
            return error("distance of the chord [m]", "within the disc", self.chord, hint);
        }
        Ok(self)
    }

    /// Integrals over the weight alone, without the shaft, about the shaft's axis.
    ///
    /// ```text
    /// A = s(R) - s(r)     S = 2/3 ((R^2 - c^2)^(3/2) - (r^2 - c^2)^(3/2)), each only where its circle meets the chord
    /// ```
    /// with `s` the area of a circle beyond the chord.
    pub fn moments(&self) -> AreaMoments {
        beyond(self.radius, self.chord) - beyond(self.shaft_radius, self.chord)
    }

    /// Whether it shares metal outside the shaft with another weight about the same axis, turned from it by `angle` [rad]. What overlaps by
    /// less than a nanometre touches.
    ///
    /// What lies beyond both chords reaches outwards without end, so that it has points at every distance from the axis beyond its least.
    pub fn meets(&self, other: &ShaftWeightShape, angle: f64) -> bool {
        let inner = self.shaft_radius.max(other.shaft_radius);
        let outer = self.radius.min(other.radius) - TOUCH;
        let chords = [self.chord + TOUCH, other.chord + TOUCH];
        beyond_both(chords, angle).is_some_and(|distance| distance.max(inner) < outer)
    }

    /// Outline of the shaft with the weight.
    ///
    /// # Errors
    /// Where the dimensions are not possible ([`ShaftWeightShape::checked`]), or edges are too short for a contour.
    pub fn outline(&self) -> Result<Outline, GeometryError> {
        let ShaftWeightShape { shaft_radius: r, radius, chord } = self.checked()?;
        let half_width = |radius: f64| ((radius - chord) * (radius + chord)).sqrt();
        let bulge = |radius: f64| (half_width(radius).atan2(chord) / 2.0).tan();
        let at = |y: f64| Point::new(chord, y);
        let (wide, arc) = (half_width(radius), bulge(radius));
        let mut corners = vec![Corner { at: at(-wide), bulge: arc }, Corner { at: at(wide), bulge: 0.0 }];
        if chord > -r {
            let narrow = half_width(r);
            // The rest of the shaft's circle, around the far side: tan((pi - a)/2).
            corners.push(Corner { at: at(narrow), bulge: bulge(r).recip() });
            corners.push(Corner { at: at(-narrow), bulge: 0.0 });
        }
        Outline::new(Contour::new(&corners)?, Vec::new())
    }
}

/// Least distance from the axis of what lies beyond two chords, whose normals enclose `angle`; none where nothing does.
fn beyond_both(chords: [f64; 2], angle: f64) -> Option<f64> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    let [one, other] = chords.map(|chord| chord.max(0.0));
    // The foot of one normal, if it lies beyond the other chord too.
    if one * cosine >= chords[1] {
        return Some(one);
    }
    if other * cosine >= chords[0] {
        return Some(other);
    }
    if sine == 0.0 {
        return None;
    }
    // Else the corner where the chords meet.
    let [c, d] = chords;
    Some(((c * c + d * d - 2.0 * c * d * cosine).max(0.0)).sqrt() / sine.abs())
}

/// Integrals over what a disc about the axis has beyond a chord.
fn beyond(radius: f64, chord: f64) -> AreaMoments {
    if chord >= radius {
        return AreaMoments::default();
    }
    if chord <= -radius {
        return AreaMoments::disc(Point::ORIGIN, radius);
    }
    let w = ((radius - chord) * (radius + chord)).sqrt();
    let a = w.atan2(chord);
    let first = Point::new(2.0 / 3.0 * w.powi(3), 0.0);
    if a <= FRAC_PI_2 {
        let unit = UnitSegment::of(a);
        let from_chord = AreaMoments {
            area: unit.area * w * w,
            first: Point::new(unit.n * w.powi(3), 0.0),
            xx: unit.nn * w.powi(4),
            yy: unit.tt * w.powi(4),
            xy: 0.0,
        };
        return AreaMoments { first, ..from_chord.moved(Point::new(chord, 0.0)) };
    }
    let (s, k) = (w / radius, chord / radius);
    let fourth = radius.powi(4);
    AreaMoments {
        area: radius * radius * excess(a),
        first,
        xx: fourth * ((a + s * k) / 4.0 - s * k.powi(3) / 2.0),
        yy: fourth * ((a - s * k) / 4.0 - s.powi(3) * k / 6.0),
        xy: 0.0,
    }
}
