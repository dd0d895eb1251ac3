//! What a counterweight that is a part weighs on the crankshaft: its unbalance, plane and direction.

use crate::angle;
use crate::crank::body::{CounterweightForm, CounterweightPart, CrankBody};
use crate::engine_parts::{EngineParts, Throw};
use lanchester_shape::{GeometryError, Outline, Point};
use std::f64::consts::PI;

/// Unbalance, plane and direction of a part on its crankshaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartWeight {
    /// Unbalance [kg m], not negative.
    pub unbalance: f64,
    /// Plane [m], from the origin.
    pub z: f64,
    /// Direction on the crankshaft [rad].
    pub angle: f64,
}

/// Why a part is no single weight.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PartFault {
    /// Its first moments along z do not point where its unbalance does: it makes a couple of its own.
    #[error("the part has a couple of {couple:.3e} kg m2 across its unbalance, which no single weight has")]
    Couple {
        /// Product of inertia across the unbalance, about the middle of the part [kg m^2].
        couple: f64,
    },
    /// Too large for the range of numbers.
    #[error("the unbalance of the part is outside the range accepted for engines")]
    TooLarge,
    /// The plain web on which it sits cannot be.
    #[error(transparent)]
    Web(#[from] GeometryError),
    /// What it shares with the plain web on which it sits cannot be told.
    #[error("what the part shares with the plain web cannot be told: {0}")]
    Overlap(GeometryError),
}

/// Parts of an unbalance, along x and along y, below this share of mass times swept radius are rounding, and so are planes beside the own ones.
const ROUNDING: f64 = 1e-12;
/// Couples below this share of mass times swept radius times thickness are none.
const NO_COUPLE: f64 = 1e-9;
/// Unbalance [kg m] and place [m] beyond which no engine goes.
pub const LARGEST_UNBALANCE: f64 = 1e12;

impl EngineParts {
    /// What `part` weighs as a counterweight of this engine.
    ///
    /// # Errors
    /// [`PartFault`] if no single weight is the same.
    pub fn part_weight(&self, part: &CounterweightPart) -> Result<PartWeight, PartFault> {
        let body = part.web.map_or(self.crank_body, |web| self.body_at_web(web));
        part_weight(part, &self.throws, body.as_ref())
    }
}

/// As [`EngineParts::part_weight`], while the engine is still being read: `body` has the sizes at the web on which the part sits.
pub fn part_weight(
    part: &CounterweightPart,
    throws: &[Throw],
    body: Option<&CrankBody>,
) -> Result<PartWeight, PartFault> {
    let moments = part.part.moments();
    let mut first = Point::new(moments.first[0], moments.first[1]);
    // The first moments times z, about the middle of the part.
    let mut lever = Point::new(moments.second[4], moments.second[3]);
    let on_web = part.web.and_then(|web| Some((throws.get(web / 2)?, web % 2)));
    if let (Some(body), Some((throw, side))) = (body, on_web) {
        let offset = throw.webs.map_or(0.0, |webs| webs[side] - part.z);
        let (web, half) = (body.web_thickness, part.part.thickness() / 2.0);
        let (taken, middle) = match part.form {
            CounterweightForm::Web => {
                let plain = plain_web(body, throw, part.angle)?.moments();
                (plain.first * (body.density * web), offset)
            }
            CounterweightForm::Family(_) => {
                let plain = plain_web(body, throw, part.angle)?;
                let shared = overlap(part.part.outline(), &plain).map_err(PartFault::Overlap)?;
                let (from, to) = ((offset - web / 2.0).max(-half), (offset + web / 2.0).min(half));
                (shared * (part.part.density() * (to - from).max(0.0)), (from + to) / 2.0)
            }
            CounterweightForm::Counterweight => (Point::ORIGIN, 0.0),
        };
        first = first - taken;
        lever = lever - taken * middle;
    }
    let reach = moments.mass * part.part.outline().swept_radius();
    let thickness = part.part.thickness();
    // Without this a nearly balanced part would point where rounding does.
    let clean = |value: f64| if value.abs() <= ROUNDING * reach { 0.0 } else { value };
    let first = Point::new(clean(first.x), clean(first.y));
    let unbalance = first.norm();
    let along = if unbalance > 0.0 { first * (1.0 / unbalance) } else { Point::new(1.0, 0.0) };
    let couple = if unbalance > 0.0 { along.cross(lever).abs() } else { lever.norm() };
    let offset = if unbalance > 0.0 { along.dot(lever) / unbalance } else { 0.0 };
    let is_finite = [unbalance, couple, offset].iter().all(|value| value.abs() <= LARGEST_UNBALANCE);
    if !is_finite {
        return Err(PartFault::TooLarge);
    }
    if couple > NO_COUPLE * reach * thickness {
        return Err(PartFault::Couple { couple });
    }
    let offset = if offset.abs() <= ROUNDING * thickness { 0.0 } else { offset };
    let turn = match along {
        Point { x, y: 0.0 } if x > 0.0 => 0.0,
        Point { y: 0.0, .. } => PI,
        Point { x, y } => y.atan2(x),
    };
    let angle = if turn == 0.0 { part.angle } else { angle::direction(part.angle + turn) };
    Ok(PartWeight { unbalance, z: part.z + offset, angle })
}

/// First moments of what two outlines share [m^3]: what both have more than their union.
fn overlap(one: &Outline, other: &Outline) -> Result<Point, GeometryError> {
    let union = one.union(other)?;
    Ok(one.moments().first + other.moments().first - union.moments().first)
}

/// The plain web of a throw in the frame of a part that stands at `angle` [rad].
fn plain_web(body: &CrankBody, throw: &Throw, angle: f64) -> Result<Outline, GeometryError> {
    Ok(body.web(throw.radius)?.turned(throw.angle + PI - angle))
}
