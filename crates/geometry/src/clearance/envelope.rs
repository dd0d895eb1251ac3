//! The envelope of what moves past a web: how far a counterweight may reach in each direction, over all angles of the crank.
//!
//! The radius in a direction is where the wanted clearance ends first on the way outwards. No distance changes by more than the way gone, so that the
//! way is walked in steps of what is left of the clearance, each of which is free as a whole; every distance over all angles has its proof
//! (book, eq. 22.73).

use crate::clearance::clearance_model::ClearanceModel;
use crate::clearance::error::ClearanceError;
use crate::clearance::motion::RodMotion;
use crate::clearance::result::{Obstacle, SweptRoom};
use crate::clearance::search::nearest;
use crate::clearance::turning_body::Plate;
use lanchester_shape::Point;
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// Directions from that of the counterweight to a quarter turn from it: every two degrees.
const DIRECTIONS: usize = 46;
/// What is left of the clearance where a walk ends [m]: as little as no drawing shows, and enough for a quick proof that a shape keeps it.
const LEFT: f64 = 1e-6;
/// Steps of a walk after which it ends where it is.
const MOST_STEPS: usize = 200;

/// How far a counterweight may reach in each direction, between two planes.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RadialEnvelope {
    /// Directions from that of the counterweight [rad], from 0 to a quarter turn: to either side.
    pub directions: Vec<f64>,
    /// Largest radius in each of them [m], on the nearer of both sides. Between two of them it runs along a circle.
    pub radii: Vec<f64>,
    /// The wanted clearance that it keeps [m].
    pub least: f64,
    /// What is first in the way; none where nothing is within reach.
    pub limit: Option<Obstacle>,
}

impl RadialEnvelope {
    /// The envelope of weights that have the same shape.
    #[must_use]
    pub fn intersection(self, other: &RadialEnvelope) -> RadialEnvelope {
        let limit = if other.smallest() < self.smallest() { other.limit } else { self.limit };
        let radii = self.radii.iter().zip(&other.radii).map(|(a, b)| a.min(*b)).collect();
        RadialEnvelope { radii, limit, ..self }
    }

    /// Everywhere nearer by a length [m].
    #[must_use]
    pub fn shrunk(&self, by: f64) -> RadialEnvelope {
        let radii = self.radii.iter().map(|radius| (radius - by).max(0.0)).collect();
        RadialEnvelope { radii, ..self.clone() }
    }

    /// The radius [m] that keeps clear whatever the shape, in all directions; nothing keeps clear where none is known.
    #[must_use]
    pub fn rounded(&self, room: Option<&SweptRoom>) -> RadialEnvelope {
        let radius = room.map_or(0.0, |room| room.radius);
        let limit = room.map_or(self.limit, |room| Some(room.limit));
        RadialEnvelope { radii: vec![radius; self.radii.len()], limit, ..self.clone() }
    }

    /// Whether it is the same radius in all directions.
    pub fn is_round(&self) -> bool {
        self.smallest() == self.largest()
    }

    /// Least radius [m].
    pub fn smallest(&self) -> f64 {
        self.radii.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Largest radius [m].
    pub fn largest(&self) -> f64 {
        self.radii.iter().copied().fold(0.0, f64::max)
    }
}

impl<M: RodMotion> ClearanceModel<'_, M> {
    /// How far a counterweight on `crankshaft`, on a web of `throw`, may reach between two planes [m], where its direction stands at `angle` on the
    /// crankshaft [rad]: up to `most` [m].
    ///
    /// Bounded by crankcase, pistons, liners and rods at all angles. [`ClearanceModel::clearances`] says of a shape within it whether it keeps
    /// the clearance between the directions too.
    ///
    /// # Errors
    /// [`ClearanceError`] where there is no such crankshaft, the planes do not rise, or geared crankshafts have too long a period.
    pub fn radial_envelope(
        &self,
        crankshaft: usize,
        throw: Option<usize>,
        faces: [f64; 2],
        angle: f64,
        most: f64,
    ) -> Result<RadialEnvelope, ClearanceError> {
        if crankshaft >= self.engine.crankshafts.len() {
            return Err(ClearanceError::Unknown { what: format!("crankshaft of index {crankshaft}") });
        }
        let thickness = faces[1] - faces[0];
        if !(thickness > 0.0 && thickness.is_finite()) {
            let (quantity, needed) = ("distance of the two planes of a counterweight [m]", "positive");
            return Err(ClearanceError::Number { quantity, needed, got: thickness });
        }
        let least = self.envelope.least.unwrap_or(0.0);
        let (mut cap, mut limit) = (most, None);
        if let Some(radius) = self.envelope.crankcase_radius
            && radius - least < cap
        {
            (cap, limit) = ((radius - least - LEFT).max(0.0), Some(Obstacle::Crankcase));
        }
        let mut moving = Vec::new();
        for kind in self.obstacles(crankshaft, throw).into_iter().take(4) {
            for obstacle in kind {
                match obstacle {
                    // What stands still is met in every direction alike.
                    Obstacle::Liner { .. } => {
                        let radius = self.walk(crankshaft, throw, obstacle, faces, angle, cap)?;
                        if radius < cap {
                            (cap, limit) = (radius, Some(obstacle));
                        }
                    }
                    _ => moving.push(obstacle),
                }
            }
        }
        let directions: Vec<f64> =
            (0..DIRECTIONS).map(|at| FRAC_PI_2 * at as f64 / (DIRECTIONS - 1) as f64).collect();
        let mut radii = Vec::with_capacity(DIRECTIONS);
        let mut smallest = cap;
        for at in &directions {
            let mut radius = cap;
            for side in if *at == 0.0 { &[1.0][..] } else { &[1.0, -1.0] } {
                for obstacle in &moving {
                    let here = self.walk(crankshaft, throw, *obstacle, faces, angle + side * at, radius)?;
                    radius = radius.min(here);
                    if radius < smallest {
                        (smallest, limit) = (radius, Some(*obstacle));
                    }
                }
            }
            radii.push(radius);
        }
        Ok(RadialEnvelope { directions, radii, least, limit })
    }

    /// The largest thickness [m] within a range of a counterweight with its middle in the plane `z` that the rods of its own crankshaft leave beside
    /// them: they pass the crank axis, so that nothing else keeps clear of them. The largest of the range where even its least is too much.
    pub fn thickness_between_rods(
        &self,
        crankshaft: usize,
        throw: Option<usize>,
        z: f64,
        [thinnest, thickest]: [f64; 2],
    ) -> f64 {
        let least = self.envelope.least.unwrap_or(0.0);
        let is_own = |rod: &Obstacle| match rod {
            Obstacle::Rod { cylinder } => cylinder
                .checked_sub(1)
                .and_then(|at| self.engine.cylinders.get(at))
                .is_some_and(|cylinder| self.engine.throws[cylinder.throw].crankshaft == crankshaft),
            _ => false,
        };
        let rods: Vec<Obstacle> =
            self.obstacles(crankshaft, throw).into_iter().flatten().filter(is_own).collect();
        let is_free = |thickness: f64| {
            let plate = [Plate::axis([z - thickness / 2.0, z + thickness / 2.0])];
            let keeps = |rod: &Obstacle| {
                let contacts = self.contacts(&plate, crankshaft, throw, *rod);
                contacts.iter().all(|contact| contact.section.least() >= least + LEFT)
            };
            rods.iter().all(keeps)
        };
        if is_free(thickest) || !is_free(thinnest) {
            return thickest;
        }
        let (mut free, mut taken) = (thinnest, thickest);
        while taken - free > 1e-9 {
            let middle = 0.5 * (free + taken);
            if is_free(middle) {
                free = middle;
            } else {
                taken = middle;
            }
        }
        free
    }

    /// How far it is free outwards in a direction [m], at most `most`.
    fn walk(
        &self,
        crankshaft: usize,
        throw: Option<usize>,
        obstacle: Obstacle,
        faces: [f64; 2],
        direction: f64,
        most: f64,
    ) -> Result<f64, ClearanceError> {
        let least = self.envelope.least.unwrap_or(0.0);
        let period = self.period(crankshaft, obstacle)?;
        let mut radius = 0.0;
        for _ in 0..MOST_STEPS {
            let plate = [Plate::point(Point::polar(radius, direction), faces)];
            let contacts = self.contacts(&plate, crankshaft, throw, obstacle);
            if contacts.iter().all(|contact| contact.section.least() >= least + LEFT) {
                return Ok(most);
            }
            let free = nearest(&contacts, &self.motions, 0.0, period).bound - least - LEFT;
            if free <= 0.1 * LEFT {
                break;
            }
            radius += free;
            if radius >= most {
                return Ok(most);
            }
        }
        Ok(radius)
    }
}
