//! The envelope in which what turns keeps the wanted clearance, in the directions of its crankshaft.
//!
//! What surrounds a crankshaft turns about it, seen from the crankshaft. With the direction `beta` of a cylinder in that frame, at which its piston's
//! lower edge stands at the height `s(beta)` over the crank axis, a point `p` is struck if at some `beta` it is higher than that, less the clearance,
//! and beside the cylinder axis by no more than the piston is wide:
//!
//! ```text
//! free:  n(beta) . p <= s(beta) - c  for all beta      n(beta): along the cylinder axis      (22.74)
//! ```
//! That is a convex set, a half-plane for every direction. It takes the piston for as wide as the crank. Where that is no loss:
//! a point beyond a half-plane is farthest beyond it in the direction in which `n . p - s` is largest, and there it stands
//! `y = ds/dbeta` beside the crank axis. If that place is below the flat of the piston for every direction whose plane is near
//! enough to matter, the envelope is exact: what leaves it strikes a piston (book, eq. 22.75).

use super::clearance_model::ClearanceModel;
use super::error::ClearanceError;
use super::frame::Frame;
use super::motion::RodMotion;
use super::result::{Obstacle, SweptRoom};
use super::section::Section;
use super::turning_body::{Plate, Spindle};
use crate::design::Reach;
use lanchester_shape::Point;
use std::f64::consts::{PI, TAU};

/// Directions of an envelope: every twentieth of a degree.
const DIRECTIONS: usize = 7200;
/// Steps of the search for the place at which a liner is nearest.
const STEPS: usize = 4000;
/// What a limit that the circle keeps stands above the circle [m].
const ABOVE: f64 = 1e-6;
/// What rounding and the last step of a search may miss [m].
const ROUNDING: f64 = 1e-9;

/// The room in which a counterweight between two planes keeps the wanted clearance from crankcase, pistons and liners.
#[derive(Debug, Clone, PartialEq)]
pub struct ClearanceEnvelope {
    /// Where it comes nearest to the crank axis, and what is there.
    pub nearest: SweptRoom,
    /// Radius of the circle that crankcase and liners leave [m]; infinite without any.
    pub circle: f64,
    /// Whether all that leaves it comes too near to something.
    pub is_exact: bool,
    /// Largest `n . p` in every direction, evenly from the direction of the crankshaft's `x` at angle zero [m], as far as pistons leave less than
    /// the circle.
    limits: Vec<f64>,
}

impl ClearanceEnvelope {
    /// What pistons leave within the circle to a counterweight whose axis stands at `angle` on the crankshaft [rad].
    pub fn around(&self, angle: f64) -> Reach {
        let count = self.limits.len();
        let at = |direction: f64| {
            let place = (direction / TAU).rem_euclid(1.0) * count as f64;
            let (first, part) = (place.floor() as usize % count, place.fract());
            let next = self.limits[(first + 1) % count];
            (1.0 - part) * self.limits[first] + part * next
        };
        let half = count / 2;
        let limit = |k: usize| {
            let beta = PI * k as f64 / half as f64;
            at(angle + beta).min(at(angle - beta))
        };
        Reach::new((0..=half).map(limit).collect())
    }
}

/// A piston or liner beside a plate: its lower end, seen from the crank axis.
struct Beside {
    /// How far the plate keeps from it along the crank alone, at the place nearest to the cylinder axis [m].
    gap: f64,
    /// Half the width over which that is so [m].
    flat: f64,
    /// Place of the cylinder axis beside the crank axis, in the direction of `y` [m].
    offset: f64,
}

impl<M: RodMotion> ClearanceModel<'_, M> {
    /// The envelope of a counterweight on `crankshaft` between two planes [m], of which nothing is farther from the crank axis than `farthest`
    /// [m]; `None` where neither crankcase, pistons nor liners are in the way of any shape. Rods are left out, since they cross the axis:
    /// [`ClearanceModel::largest_thickness`].
    ///
    /// # Errors
    /// Where there is no such crankshaft, the planes do not rise, or geared crankshafts have too long a period.
    pub fn envelope(
        &self,
        crankshaft: usize,
        faces: [f64; 2],
        farthest: f64,
    ) -> Result<Option<ClearanceEnvelope>, ClearanceError> {
        if crankshaft >= self.engine.crankshafts.len() {
            return Err(ClearanceError::Unknown { what: format!("crankshaft of index {crankshaft}") });
        }
        let thickness = faces[1] - faces[0];
        if !(thickness > 0.0 && thickness.is_finite()) {
            let (quantity, needed) = ("distance of the two planes of a counterweight [m]", "positive");
            return Err(ClearanceError::Number { quantity, needed, got: thickness });
        }
        let least = self.envelope.least.unwrap_or(0.0);
        let crankcase = self.envelope.crankcase_radius.map(|radius| (radius - least).max(0.0));
        let mut nearest =
            crankcase.map(|radius| SweptRoom { radius, limit: Obstacle::Crankcase, theta: None, least });
        let mut come_nearer = |radius: f64, limit: Obstacle, theta: Option<f64>| {
            if nearest.as_ref().is_none_or(|nearest| radius < nearest.radius) {
                nearest = Some(SweptRoom { radius: radius.max(0.0), limit, theta, least });
            }
        };
        let plate = [Plate::axis(faces)];
        let obstacles = self.obstacles(crankshaft, None);
        let mut circle = crankcase.unwrap_or(f64::INFINITY);
        for limit in &obstacles[1] {
            for contact in self.contacts(&plate, crankshaft, None, *limit) {
                let radius = beneath_liner(&contact.section, contact.frame, contact.spindle, least);
                circle = circle.min(radius);
                if radius.is_finite() {
                    come_nearer(radius, *limit, None);
                }
            }
        }
        // What matters of pistons is what is nearer than this.
        let farthest = circle.min(farthest);
        // Where pistons leave more than the circle does, the circle is enough.
        let mut limits = vec![farthest + ABOVE; DIRECTIONS];
        let mut is_exact = true;
        for limit in &obstacles[0] {
            for contact in self.contacts(&plate, crankshaft, None, *limit) {
                let Some(beside) = beside_piston(&contact.section, contact.frame, contact.spindle) else {
                    continue;
                };
                if beside.gap > 0.0 && beside.gap >= least {
                    continue;
                }
                let away = ((least - beside.gap) * (least + beside.gap)).max(0.0).sqrt();
                let period = self.period(crankshaft, *limit)?;
                let Some(under) =
                    self.under_piston(contact.spindle, contact.frame, period, away, farthest, &mut limits)
                else {
                    continue;
                };
                if under.height < farthest {
                    come_nearer(under.height, *limit, Some(under.theta));
                }
                // Places count from the crank axis, the piston's own from its axis.
                let [low, high] = under.places.map(|place| place - beside.offset);
                is_exact &= low.abs().max(high.abs()) <= beside.flat;
            }
        }
        let Some(nearest) = nearest else { return Ok(None) };
        // Between two directions a point may pass by a little more (book, "The clearance envelope").
        let bend = self.motions.iter().map(|motion| motion.bounds().travel[1]).fold(0.0, f64::max);
        let ratio = Spindle::of(self.engine, crankshaft).ratio.value();
        let step = TAU / DIRECTIONS as f64;
        let slack = (farthest + 2.0 * bend / (ratio * ratio)) * step * step / 8.0;
        for limit in &mut limits {
            *limit = (*limit - slack).max(0.0);
        }
        Ok(Some(ClearanceEnvelope { nearest, circle, is_exact, limits }))
    }

    /// The largest thickness of a counterweight about the plane `z` [m] that keeps the wanted clearance from the rods beside it, along the crank;
    /// `None` where no rod is beside it. `throw` is that of its web, whose big end runs along it with a play of its own.
    pub fn largest_thickness(&self, crankshaft: usize, throw: Option<usize>, z: f64) -> Option<f64> {
        let least = self.envelope.least.unwrap_or(0.0);
        let plate = [Plate::axis([z, z])];
        let rods = self.obstacles(crankshaft, throw).into_iter().skip(2).take(2).flatten();
        let gaps = rods.flat_map(|rod| {
            let contacts = self.contacts(&plate, crankshaft, throw, rod);
            contacts.into_iter().map(|contact| contact.section.least()).collect::<Vec<f64>>()
        });
        // One in whose plane a rod turns keeps no clearance however thin it is: the check tells that.
        gaps.filter(|gap| *gap > least).map(|gap| 2.0 * (gap - least)).reduce(f64::min)
    }

    /// Lowers the limits to what a piston leaves, `away` below its lower edge [m].
    fn under_piston(
        &self,
        spindle: Spindle,
        frame: Frame,
        period: f64,
        away: f64,
        farthest: f64,
        limits: &mut [f64],
    ) -> Option<Under> {
        let Frame::Piston { foot, along, shift, cylinder } = frame else { return None };
        let ratio = spindle.ratio.value();
        let turns = (period * ratio.abs() / TAU).round().max(1.0) as usize;
        let (base, towards) = ((foot - spindle.axis).dot(along) + shift - away, along.y.atan2(along.x));
        let mut under =
            Under { height: f64::INFINITY, theta: 0.0, places: [f64::INFINITY, f64::NEG_INFINITY] };
        let count = limits.len();
        for (k, limit) in limits.iter_mut().enumerate() {
            let beta = TAU * k as f64 / count as f64;
            for turn in 0..turns {
                let theta = (towards - spindle.phase - beta + TAU * turn as f64) / ratio;
                let pose = self.motions[cylinder].pose(theta);
                let height = base + pose.travel;
                if height < under.height {
                    (under.height, under.theta) = (height, theta.rem_euclid(period));
                }
                if height < farthest {
                    let place = -pose.travel_rate / ratio;
                    under.places = [under.places[0].min(place), under.places[1].max(place)];
                }
                if height < farthest {
                    *limit = limit.min(height);
                }
            }
        }
        (under.height < farthest).then_some(under)
    }
}

/// What a piston leaves.
struct Under {
    /// Its least height over the crank axis, less the clearance [m].
    height: f64,
    /// Angle of crankshaft 1 at which it is that low [rad].
    theta: f64,
    /// Least and largest place beside the crank axis of what touches it [m].
    places: [f64; 2],
}

/// Place of a cylinder axis beside a crank axis, a quarter turn further than the cylinder [m].
fn offset(frame: Frame, spindle: Spindle) -> f64 {
    match frame {
        Frame::Piston { foot, along, .. } => along.cross(foot - spindle.axis),
        Frame::Fixed { at, along } => along.cross(at - spindle.axis),
        Frame::Crankpin { .. } | Frame::Rod { .. } => 0.0,
    }
}

fn beside_piston(section: &Section, frame: Frame, spindle: Spindle) -> Option<Beside> {
    let Section::Piston { radius, cut, .. } = *section else { return None };
    let gap = section.level(Point::ORIGIN).distance;
    let zeta = section.nearest(Point::ORIGIN).1[0].abs();
    let at = zeta.min(cut);
    let flat = ((radius - at) * (radius + at)).max(0.0).sqrt();
    Some(Beside { gap, flat, offset: offset(frame, spindle) })
}

/// Radius of the circle about the crank axis that stays clear of a liner by `least` [m].
fn beneath_liner(section: &Section, frame: Frame, spindle: Spindle, least: f64) -> f64 {
    let (Section::Liner { outer, .. }, Frame::Fixed { at, along }) = (*section, frame) else {
        return f64::INFINITY;
    };
    let end = along.dot(at - spindle.axis);
    let offset = offset(frame, spindle);
    let half = outer + least;
    let step = 2.0 * half / STEPS as f64;
    let radius = |y: f64| {
        // Beside the liner within its height: the distance in its plane alone.
        let beside = section.level(Point::new(0.0, y)).distance;
        if beside > least {
            return f64::INFINITY;
        }
        let below = (end - ((least - beside) * (least + beside)).max(0.0).sqrt()).max(0.0);
        (y + offset).hypot(below)
    };
    let grid = (0..=STEPS).map(|k| -half + step * k as f64);
    let best = grid.min_by(|a, b| radius(*a).total_cmp(&radius(*b))).unwrap_or(0.0);
    // Between its neighbours on the grid the function has one valley.
    let (mut low, mut high) = (best - step, best + step);
    for _ in 0..80 {
        let (first, second) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if radius(first) <= radius(second) { high = second } else { low = first }
    }
    let found = radius(best).min(radius(low)).min(radius(high));
    (found - ROUNDING).max(0.0)
}
