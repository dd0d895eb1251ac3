//! An engine prepared for its clearances: what turns, what stands in the way, how it moves.

use crate::clearance::contact::Contact;
use crate::clearance::error::ClearanceError;
use crate::clearance::frame::Frame;
use crate::clearance::motion::RodMotion;
use crate::clearance::result::Obstacle;
use crate::clearance::section::Section;
use crate::clearance::turning_body::{Plate, Spindle, TurningBody};
use lanchester_model::{Cylinder, Engine, Envelope, Ratio, RodJoint, greatest_common_divisor};
use lanchester_shape::Point;
use std::f64::consts::TAU;

/// Most turns of crankshaft 1 that are searched.
const MOST_TURNS: u32 = 120;

/// An engine with the motion of its rods, prepared for clearances: [`ClearanceModel::clearances`],
/// [`ClearanceModel::curve`], [`ClearanceModel::largest_swept_radius`].
#[derive(Debug)]
pub struct ClearanceModel<'a, M> {
    pub(super) engine: &'a Engine,
    pub(super) envelope: Envelope,
    pub(super) motions: Vec<M>,
    pub(super) bodies: Vec<TurningBody>,
}

impl<'a, M: RodMotion> ClearanceModel<'a, M> {
    /// Counterweights and webs of `engine` against its envelope, with the motion of every cylinder by number.
    ///
    /// # Errors
    /// [`ClearanceError`] where there is no envelope, a bore is missing, the motions are not as many as the cylinders, or a web
    /// has no outline.
    pub fn new(engine: &'a Engine, motions: Vec<M>) -> Result<ClearanceModel<'a, M>, ClearanceError> {
        let envelope = engine.envelope.unwrap_or_default();
        let Envelope { crankcase_radius, skirt, liner, rod, .. } = &envelope;
        if crankcase_radius.is_none() && skirt.is_none() && liner.is_none() && rod.is_none() {
            return Err(ClearanceError::NoEnvelope);
        }
        if motions.len() != engine.cylinders.len() {
            return Err(ClearanceError::Motions { needed: engine.cylinders.len(), got: motions.len() });
        }
        if (skirt.is_some() || liner.is_some())
            && let Some(bare) = engine.cylinders.iter().position(|cylinder| cylinder.bore.is_none())
        {
            return Err(ClearanceError::NoBore { cylinder: bare + 1 });
        }
        let bodies = TurningBody::all(engine)?;
        Ok(ClearanceModel { engine, envelope, motions, bodies })
    }

    /// Everything that may stand in the way of what turns on a crankshaft, by kind; `throw` is that whose web it is.
    ///
    /// Pistons and liners of another crankshaft count where the axis that is looked at lies no farther up the cylinder than
    /// crank and rod reach: above that is the other side of the piston.
    pub(super) fn obstacles(&self, crankshaft: usize, throw: Option<usize>) -> Vec<Vec<Obstacle>> {
        let mut kinds = vec![Vec::new(); 5];
        let axis = Spindle::of(self.engine, crankshaft).axis;
        for (index, cylinder) in self.engine.cylinders.iter().enumerate() {
            let number = index + 1;
            let own = self.engine.throws[cylinder.throw].crankshaft;
            let height = (axis - Spindle::of(self.engine, own).axis).dot(Point::polar(1.0, cylinder.angle));
            let reach = self.engine.throws[cylinder.throw].radius + cylinder.rod.length;
            if own == crankshaft || height < reach {
                if self.envelope.skirt.is_some() {
                    kinds[0].push(Obstacle::Piston { cylinder: number });
                }
                if self.envelope.liner.is_some() {
                    kinds[1].push(Obstacle::Liner { cylinder: number });
                }
            }
            if self.envelope.rod.is_some() {
                let is_own = throw == Some(cylinder.throw);
                kinds[if is_own { 2 } else { 3 }].push(Obstacle::Rod { cylinder: number });
                if is_own && has_big_end(cylinder) {
                    kinds[4].push(Obstacle::BigEndSide { cylinder: number });
                }
            }
        }
        kinds
    }

    /// The plates of a body against the parts of an obstacle; none for the crankcase, or an obstacle that is not there.
    pub(super) fn contacts<'b>(
        &self,
        plates: &'b [Plate],
        crankshaft: usize,
        throw: Option<usize>,
        obstacle: Obstacle,
    ) -> Vec<Contact<'b>> {
        let spindle = Spindle::of(self.engine, crankshaft);
        let parts = self.parts(crankshaft, throw, obstacle);
        let pairs = plates.iter().flat_map(|plate| parts.iter().map(move |part| (plate, part)));
        let contact = |(plate, part): (&'b Plate, &ObstaclePart)| {
            let section = part.section(plate.faces);
            Contact::new(plate, spindle, part.frame, section, part.is_rigid, &self.motions)
        };
        pairs.map(contact).collect()
    }

    fn parts(&self, crankshaft: usize, throw: Option<usize>, obstacle: Obstacle) -> Vec<ObstaclePart> {
        let number = match obstacle {
            Obstacle::Crankcase => return Vec::new(),
            Obstacle::Piston { cylinder }
            | Obstacle::Liner { cylinder }
            | Obstacle::Rod { cylinder }
            | Obstacle::BigEndSide { cylinder } => cylinder,
        };
        let Some((index, cylinder)) =
            number.checked_sub(1).and_then(|at| Some((at, self.engine.cylinders.get(at)?)))
        else {
            return Vec::new();
        };
        let pin = &self.engine.throws[cylinder.throw];
        let spindle = Spindle::of(self.engine, pin.crankshaft);
        let along = Point::polar(1.0, cylinder.angle);
        // A quarter turn further than the cylinder axis.
        let foot = spindle.axis - along.right() * cylinder.offset;
        let radius = cylinder.bore.map(|bore| bore / 2.0);
        let part = |frame: Frame, body: Body| ObstaclePart { frame, body, z: cylinder.z, is_rigid: false };
        match obstacle {
            Obstacle::Piston { .. } => {
                let (Some(skirt), Some(radius)) = (self.envelope.skirt, radius) else { return Vec::new() };
                let cut = skirt.width.map_or(radius, |width| radius.min(width / 2.0));
                let frame = Frame::Piston { foot, along, shift: -skirt.length, cylinder: index };
                vec![part(frame, Body::Piston { radius, cut })]
            }
            Obstacle::Liner { .. } => {
                let (Some(liner), Some(inner)) = (self.envelope.liner, radius) else { return Vec::new() };
                let frame = Frame::Fixed { at: foot + along * liner.end, along };
                vec![part(frame, Body::Liner { inner, outer: inner + liner.wall })]
            }
            Obstacle::Rod { .. } | Obstacle::BigEndSide { .. } => {
                let Some(rod) = self.envelope.rod else { return Vec::new() };
                let mut parts = Vec::new();
                let is_side = matches!(obstacle, Obstacle::BigEndSide { .. });
                if has_big_end(cylinder) && is_side == (throw == Some(cylinder.throw)) {
                    let frame = Frame::Crankpin { spindle, at: Point::polar(pin.radius, pin.angle) };
                    let body = Body::Disc { radius: rod.big_end_radius, width: rod.big_end_width };
                    parts.push(ObstaclePart { is_rigid: pin.crankshaft == crankshaft, ..part(frame, body) });
                }
                if !is_side {
                    let frame = Frame::Rod { axis: spindle.axis, cylinder: index };
                    let (length, width) = (cylinder.rod.length, rod.shank_width);
                    parts.push(part(frame, Body::Bar { length, width, thickness: rod.shank_thickness }));
                }
                parts
            }
            Obstacle::Crankcase => Vec::new(),
        }
    }

    /// Angle of crankshaft 1 after which the crankshaft that is looked at and an obstacle stand as before [rad].
    pub(super) fn period(&self, crankshaft: usize, obstacle: Obstacle) -> Result<f64, ClearanceError> {
        let own = self.engine.crankshafts[crankshaft].ratio;
        let moved_by = match obstacle {
            Obstacle::Crankcase | Obstacle::Liner { .. } => None,
            Obstacle::Piston { cylinder }
            | Obstacle::Rod { cylinder }
            | Obstacle::BigEndSide { cylinder } => cylinder.checked_sub(1),
        };
        let other = moved_by
            .and_then(|index| self.engine.cylinders.get(index))
            .map_or(own, |c| self.engine.crankshafts[self.engine.throws[c.throw].crankshaft].ratio);
        common_period(own, other)
    }
}

/// The least angle of crankshaft 1 after which shafts at both ratios `p/q` have made whole turns:
/// `lcm(q1, q2)/gcd(p1, p2)` turns.
fn common_period(first: Ratio, second: Ratio) -> Result<f64, ClearanceError> {
    let (p, q) = (first.numerator().unsigned_abs(), first.denominator());
    let (r, s) = (second.numerator().unsigned_abs(), second.denominator());
    let turns = f64::from(q) * f64::from(s / greatest_common_divisor(q, s));
    let period = turns / f64::from(greatest_common_divisor(p, r));
    if period > f64::from(MOST_TURNS) {
        let (first, second) = (first.to_string(), second.to_string());
        return Err(ClearanceError::PeriodTooLong { first, second, limit: MOST_TURNS });
    }
    Ok(TAU * period)
}

/// Whether the rod sits on the crankpin itself: the big end about the crankpin is that of its master otherwise.
pub(super) fn has_big_end(cylinder: &Cylinder) -> bool {
    !matches!(cylinder.rod.joint, RodJoint::Articulated { .. })
}

/// A simple body that an obstacle is made of.
#[derive(Debug, Clone, Copy)]
struct ObstaclePart {
    frame: Frame,
    body: Body,
    /// Plane of its middle [m].
    z: f64,
    is_rigid: bool,
}

/// Sizes of such a body.
#[derive(Debug, Clone, Copy)]
enum Body {
    Piston { radius: f64, cut: f64 },
    Liner { inner: f64, outer: f64 },
    Disc { radius: f64, width: f64 },
    Bar { length: f64, width: f64, thickness: f64 },
}

impl ObstaclePart {
    /// It as seen from a plate between two planes.
    fn section(&self, faces: [f64; 2]) -> Section {
        let slab = faces.map(|z| z - self.z);
        let plates = |thickness: f64| [slab, [-thickness / 2.0, thickness / 2.0]];
        match self.body {
            Body::Piston { radius, cut } => Section::Piston { slab, radius, cut },
            Body::Liner { inner, outer } => Section::Liner { slab, inner, outer },
            Body::Disc { radius, width } => Section::Disc { faces: plates(width), radius },
            Body::Bar { length, width, thickness } => {
                Section::Bar { faces: plates(thickness), length, half_width: width / 2.0 }
            }
        }
    }
}

impl Obstacle {
    /// Plane from which the places along z of its sections count [m].
    pub(super) fn plane(self, engine: &Engine) -> f64 {
        match self {
            Obstacle::Crankcase => 0.0,
            Obstacle::Piston { cylinder }
            | Obstacle::Liner { cylinder }
            | Obstacle::Rod { cylinder }
            | Obstacle::BigEndSide { cylinder } => {
                cylinder.checked_sub(1).and_then(|index| engine.cylinders.get(index)).map_or(0.0, |c| c.z)
            }
        }
    }
}
