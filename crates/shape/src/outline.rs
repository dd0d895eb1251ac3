//! The outline of a flat part: an outer contour with holes.

use crate::area_moments::AreaMoments;
use crate::contour::Contour;
use crate::error::{ContourPlace, GeometryError};
use crate::point::Point;
use serde::Serialize;

/// An outer contour and the holes within it, none of which touches another.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Outline {
    outer: Contour,
    holes: Vec<Contour>,
}

impl Outline {
    /// From its contours, which all run anticlockwise.
    ///
    /// # Errors
    /// Where contours cross or touch, or a hole lies outside the outer contour or within another hole.
    pub fn new(outer: Contour, holes: Vec<Contour>) -> Result<Outline, GeometryError> {
        let size = outer.size();
        for (at, hole) in holes.iter().enumerate() {
            let number = at + 1;
            let others = std::iter::once((ContourPlace::Outer, &outer))
                .chain(holes[..at].iter().enumerate().map(|(k, other)| (ContourPlace::Hole(k + 1), other)));
            for (place, other) in others {
                if let Some(at) = hole.meeting(other, size) {
                    let (first, second) = (place, ContourPlace::Hole(number));
                    return Err(GeometryError::ContoursCross { first, second, at });
                }
                let point = hole.edges()[0].from;
                let misplaced = match place {
                    ContourPlace::Outer => !other.contains(point),
                    ContourPlace::Hole(_) => other.contains(point),
                };
                if misplaced {
                    return Err(GeometryError::HoleOutside { hole: number, at: point, within: place });
                }
                let theirs = other.edges()[0].from;
                if place != ContourPlace::Outer && hole.contains(theirs) {
                    let ContourPlace::Hole(inner) = place else { continue };
                    let within = ContourPlace::Hole(number);
                    return Err(GeometryError::HoleOutside { hole: inner, at: theirs, within });
                }
            }
        }
        Ok(Outline { outer, holes })
    }

    /// The outer contour.
    pub fn outer(&self) -> &Contour {
        &self.outer
    }

    /// The holes.
    pub fn holes(&self) -> &[Contour] {
        &self.holes
    }

    /// All contours, the outer one first.
    pub fn contours(&self) -> impl Iterator<Item = &Contour> {
        std::iter::once(&self.outer).chain(&self.holes)
    }

    /// Integrals over the material, about the crank axis.
    pub fn moments(&self) -> AreaMoments {
        self.holes.iter().fold(self.outer.moments(), |sum, hole| sum - hole.moments())
    }

    /// Swept radius: the farthest point from the crank axis [m].
    pub fn swept_radius(&self) -> f64 {
        self.outer.farthest(Point::ORIGIN).0
    }

    /// The farthest point from the crank axis [m].
    pub fn farthest_point(&self) -> Point {
        self.outer.farthest(Point::ORIGIN).1
    }

    /// Distance from `point` to the nearest edge of any contour [m], and where that is.
    pub fn nearest(&self, point: Point) -> (f64, Point) {
        let all = self.contours().map(|contour| contour.nearest(point));
        all.fold((f64::INFINITY, point), |best, next| if next.0 < best.0 { next } else { best })
    }

    /// Lower left and upper right corner of the box around it [m].
    pub fn bounds(&self) -> [Point; 2] {
        self.outer.bounds()
    }

    /// Largest extent from the crank axis along a unit vector [m].
    pub fn reach(&self, direction: Point) -> f64 {
        self.outer.edges().iter().map(|edge| edge.support(direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether `point` lies in the material. Of a point on an edge rounding decides.
    pub fn contains(&self, point: Point) -> bool {
        self.outer.contains(point) && !self.holes.iter().any(|hole| hole.contains(point))
    }

    /// Turned by `angle` [rad] about the crank axis.
    pub fn turned(&self, angle: f64) -> Outline {
        let holes = self.holes.iter().map(|hole| hole.turned(angle)).collect();
        Outline { outer: self.outer.turned(angle), holes }
    }

    /// Moved by `by`.
    pub fn moved(&self, by: Point) -> Outline {
        let holes = self.holes.iter().map(|hole| hole.moved(by)).collect();
        Outline { outer: self.outer.moved(by), holes }
    }
}

impl From<Contour> for Outline {
    fn from(outer: Contour) -> Outline {
        Outline { outer, holes: Vec::new() }
    }
}
