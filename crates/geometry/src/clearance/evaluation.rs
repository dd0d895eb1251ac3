//! Clearances of all counterweights and webs, the curve of one, and the room that there is.

use crate::clearance::clearance_model::{ClearanceModel, has_big_end};
use crate::clearance::contact::Contact;
use crate::clearance::error::ClearanceError;
use crate::clearance::motion::RodMotion;
use crate::clearance::overlap::{deepest, overlapping_angles};
use crate::clearance::result::{
    BigEndClearance, BodyClearances, CLEARANCE_VERSION, Clearance, ClearanceCurve, Clearances, DepthAlong,
    Obstacle, Overlap, Smallest, SweptRoom,
};
use crate::clearance::search::{CLEARANCE_GAP, nearest, nearest_below};
use crate::clearance::turning_body::{Plate, Spindle, TurningBody};
use lanchester_shape::Point;

/// Plates that overlap by less than this along z [m] touch: it is rounding.
const TOUCH: f64 = 1e-9;

impl<M: RodMotion> ClearanceModel<'_, M> {
    /// The smallest distance of every counterweight and web from what is in its way, over all angles and in space, with its
    /// proof.
    ///
    /// Chamfers and bores of inserts count as full material, so that a distance is a lower bound where there are any. A search
    /// ends [`CLEARANCE_GAP`] above its proved bound; `bound` says how far it came where it had to be given up before.
    ///
    /// # Errors
    /// [`ClearanceError::NoShape`] where nothing that turns has a shape; [`ClearanceError::PeriodTooLong`].
    pub fn clearances(&self) -> Result<Clearances, ClearanceError> {
        if self.bodies.is_empty() {
            return Err(ClearanceError::NoShape);
        }
        let bodies = self.bodies.iter().map(|body| self.of_body(body)).collect::<Result<Vec<_>, _>>()?;
        let big_ends = self.big_ends();
        let of_bodies = bodies.iter().flat_map(|body| {
            body.clearances
                .iter()
                .map(|clearance| Smallest { body: body.name.clone(), clearance: clearance.clone() })
        });
        let of_big_ends = big_ends.iter().map(|end| Smallest {
            body: format!("big end {}", end.cylinder),
            clearance: end.clearance.clone(),
        });
        let is_side =
            |c: &Clearance| matches!(c.obstacle, Obstacle::BigEndSide { .. }) && c.overlap.is_none();
        let all = of_bodies.chain(of_big_ends).filter(|one| !is_side(&one.clearance));
        let all: Vec<Smallest> = all.collect();
        let is_kept = all.iter().all(|one| one.clearance.is_kept);
        let smallest = all.into_iter().min_by(|a, b| a.clearance.signed().total_cmp(&b.clearance.signed()));
        Ok(Clearances {
            version: CLEARANCE_VERSION,
            least: self.envelope.least,
            bodies,
            big_ends,
            smallest,
            is_kept,
        })
    }

    /// By how much one counterweight or web, by its index in [`Clearances::bodies`], misses the wanted clearance [m]; none where it keeps it, proved as
    /// [`ClearanceModel::clearances`] does. What overlaps misses all of it at least.
    ///
    /// # Errors
    /// [`ClearanceError`] where there is no such counterweight or web; [`ClearanceError::PeriodTooLong`].
    pub fn missed(&self, body: usize) -> Result<Option<f64>, ClearanceError> {
        let Some(body) = self.bodies.get(body) else {
            return Err(ClearanceError::Unknown { what: format!("counterweight or web of index {body}") });
        };
        let least = self.envelope.least.unwrap_or(0.0);
        let enough = least - CLEARANCE_GAP;
        let mut most: Option<f64> = None;
        let mut miss = |by: f64| most = Some(most.map_or(by, |most: f64| most.max(by)));
        if let Some(radius) = self.envelope.crankcase_radius {
            let left = radius - body.farthest().0;
            if left < enough || left < 0.0 {
                miss(least - left);
            }
        }
        for obstacle in self.obstacles(body.crankshaft, body.throw).into_iter().flatten() {
            let contacts = self.contacts(&body.plates, body.crankshaft, body.throw, obstacle);
            let is_side = matches!(obstacle, Obstacle::BigEndSide { .. });
            let near = contacts.iter().map(|contact| contact.section.least()).fold(f64::INFINITY, f64::min);
            if near > least {
                continue;
            }
            let period = self.period(body.crankshaft, obstacle)?;
            // Without a wanted clearance nothing may overlap, and touching is none.
            let wanted = if is_side { TOUCH } else { enough.max(TOUCH) };
            let found = nearest_below(&contacts, &self.motions, 0.0, period, wanted);
            if !is_side && found.bound < enough {
                miss(least - found.bound);
            } else if found.distance == 0.0 && !self.overlapping(&contacts, period).is_empty() {
                miss(least.max(TOUCH));
            }
        }
        Ok(most)
    }

    /// The distance of a counterweight or web, by its index in [`Clearances::bodies`], from an obstacle at `count` angles.
    ///
    /// # Errors
    /// [`ClearanceError`] where there is no such body or obstacle, or no angle is asked for.
    pub fn curve(
        &self,
        body: usize,
        obstacle: Obstacle,
        count: usize,
    ) -> Result<ClearanceCurve, ClearanceError> {
        let Some(body) = self.bodies.get(body) else {
            return Err(ClearanceError::Unknown { what: format!("counterweight or web of index {body}") });
        };
        if !(1..=1_000_000).contains(&count) {
            let (quantity, needed) = ("number of angles", "from 1 to 1000000");
            return Err(ClearanceError::Number { quantity, needed, got: count as f64 });
        }
        let period = self.period(body.crankshaft, obstacle)?;
        let theta: Vec<f64> = (0..count).map(|at| period * at as f64 / count as f64).collect();
        if let (Obstacle::Crankcase, Some(radius)) = (obstacle, self.envelope.crankcase_radius) {
            let distance = vec![(radius - body.farthest().0).max(0.0); count];
            return Ok(ClearanceCurve { theta, distance, period });
        }
        let contacts = self.contacts(&body.plates, body.crankshaft, body.throw, obstacle);
        if contacts.is_empty() {
            return Err(ClearanceError::Unknown {
                what: format!("obstacle {obstacle:?} for \"{}\"", body.name),
            });
        }
        let distance = theta.iter().map(|at| nearest(&contacts, &self.motions, *at, 0.0).distance).collect();
        Ok(ClearanceCurve { theta, distance, period })
    }

    /// The largest swept radius of a counterweight on `crankshaft` between two planes [m] that keeps the wanted clearance
    /// from crankcase, pistons and liners whatever its shape; `None` where none of them is given.
    ///
    /// It is the least distance, over all angles, of the stretch of the crank axis between the planes from the obstacle,
    /// less the wanted clearance: no point of the counterweight is farther from that stretch than the swept radius. That is
    /// sufficient, not necessary: a counterweight that is on the other side of the crank when the piston comes down may be
    /// larger. Rods are left out, since they cross the axis.
    ///
    /// # Errors
    /// [`ClearanceError`] where there is no such crankshaft or the planes do not rise.
    pub fn largest_swept_radius(
        &self,
        crankshaft: usize,
        faces: [f64; 2],
    ) -> Result<Option<SweptRoom>, ClearanceError> {
        if crankshaft >= self.engine.crankshafts.len() {
            return Err(ClearanceError::Unknown { what: format!("crankshaft of index {crankshaft}") });
        }
        let thickness = faces[1] - faces[0];
        if !(thickness > 0.0 && thickness.is_finite()) {
            let (quantity, needed) = ("distance of the two planes of a counterweight [m]", "positive");
            return Err(ClearanceError::Number { quantity, needed, got: thickness });
        }
        let least = self.envelope.least.unwrap_or(0.0);
        let mut room = self.envelope.crankcase_radius.map(|radius| SweptRoom {
            radius: (radius - least).max(0.0),
            least,
            limit: Obstacle::Crankcase,
            theta: None,
        });
        let axis = [Plate::axis(faces)];
        for limit in self.obstacles(crankshaft, None).into_iter().take(2).flatten() {
            let contacts = self.contacts(&axis, crankshaft, None, limit);
            let lowest = contacts.iter().map(|c| c.section.least()).fold(f64::INFINITY, f64::min);
            if room.as_ref().is_some_and(|room| lowest - least >= room.radius) {
                continue;
            }
            let found = nearest(&contacts, &self.motions, 0.0, self.period(crankshaft, limit)?);
            let radius = (found.bound - least).max(0.0);
            if room.as_ref().is_none_or(|room| radius < room.radius) {
                let theta = matches!(limit, Obstacle::Piston { .. }).then_some(found.theta);
                room = Some(SweptRoom { radius, least, limit, theta });
            }
        }
        Ok(room)
    }

    fn of_body(&self, body: &TurningBody) -> Result<BodyClearances, ClearanceError> {
        let (swept_radius, plate, point) = body.farthest();
        let spindle = Spindle::of(self.engine, body.crankshaft);
        let mut clearances = Vec::new();
        if let Some(radius) = self.envelope.crankcase_radius {
            let z = 0.5 * (plate.faces[0] + plate.faces[1]);
            clearances.push(self.in_crankcase(&spindle, point, z, radius));
        }
        for kind in self.obstacles(body.crankshaft, body.throw) {
            let with_contacts = |obstacle: Obstacle| {
                let contacts = self.contacts(&body.plates, body.crankshaft, body.throw, obstacle);
                let least = contacts.iter().map(|c| c.section.least()).fold(f64::INFINITY, f64::min);
                (least, obstacle, contacts)
            };
            let mut candidates: Vec<_> = kind.into_iter().map(with_contacts).collect();
            candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut nearest_of_kind = f64::INFINITY;
            let mut found = Vec::new();
            for (least, obstacle, contacts) in candidates {
                if contacts.is_empty() || least > nearest_of_kind {
                    continue;
                }
                let clearance = self.of_contacts(body.crankshaft, obstacle, &contacts)?;
                nearest_of_kind = nearest_of_kind.min(clearance.distance);
                found.push((least, clearance));
            }
            clearances.extend(found.into_iter().filter(|one| one.0 <= nearest_of_kind).map(|one| one.1));
        }
        Ok(BodyClearances {
            name: body.name.clone(),
            crankshaft: body.crankshaft,
            faces: body.faces(),
            swept_radius,
            chamfers_ignored: body.has_chamfers,
            clearances,
        })
    }

    fn of_contacts(
        &self,
        crankshaft: usize,
        obstacle: Obstacle,
        contacts: &[Contact],
    ) -> Result<Clearance, ClearanceError> {
        let period = self.period(crankshaft, obstacle)?;
        let found = nearest(contacts, &self.motions, 0.0, period);
        let hit = if found.distance > 0.0 { Vec::new() } else { self.overlapping(contacts, period) };
        let deep = (hit.first().is_some_and(|contact| contact.section.overlap_along_crank().is_none()))
            .then(|| deepest(&hit, &self.motions, period));
        let overlap = (!hit.is_empty()).then(|| {
            let angles = overlapping_angles(&hit, &self.motions, period);
            let along_crank = hit.iter().filter_map(|c| c.section.overlap_along_crank()).fold(0.0, f64::max);
            let (depth, depth_bound, along) = match &deep {
                Some(deep) => (deep.depth, deep.bound, DepthAlong::Cylinder),
                None => (along_crank, along_crank, DepthAlong::Crank),
            };
            Overlap { angles, depth, depth_bound, along }
        });
        let (contact, theta, point) = match &deep {
            Some(deep) => (&hit[deep.contact], deep.theta, deep.point),
            None => (&contacts[found.contact], found.theta, found.point),
        };
        let pose = contact.frame.pose(&self.motions, theta);
        let on_body = contact.placed(point, theta);
        let seen = pose.seen(on_body);
        let (foot, [z, foot_z]) = contact.section.nearest(seen);
        // Where the body reaches in, what it overlaps begins at the lower edge.
        let foot = if deep.is_some() { Point::new(0.0, foot.y) } else { foot };
        let (on_obstacle, plane) = (pose.placed(foot), obstacle.plane(self.engine));
        let is_clear = found.bound + CLEARANCE_GAP >= self.envelope.least.unwrap_or(0.0);
        let is_side = matches!(obstacle, Obstacle::BigEndSide { .. });
        Ok(Clearance {
            obstacle,
            distance: found.distance,
            bound: found.bound,
            theta: (!contacts.iter().all(|contact| contact.is_rigid)).then_some(theta),
            on_body: [on_body.x, on_body.y, z + plane],
            on_obstacle: [on_obstacle.x, on_obstacle.y, foot_z + plane],
            is_kept: (is_clear || is_side) && overlap.is_none(),
            overlap,
        })
    }

    /// Those of some contacts that overlap at some angle, more than they touch.
    fn overlapping<'b>(&self, contacts: &[Contact<'b>], period: f64) -> Vec<Contact<'b>> {
        let is_hit = |contact: &&Contact| {
            contact.section.overlap_along_crank().is_none_or(|deep| deep > TOUCH)
                && nearest(std::slice::from_ref(*contact), &self.motions, 0.0, period).distance == 0.0
        };
        contacts.iter().filter(is_hit).cloned().collect()
    }

    /// What turns about a spindle and reaches to `point` in the plane `z`, within a crankcase.
    fn in_crankcase(&self, spindle: &Spindle, point: Point, z: f64, radius: f64) -> Clearance {
        let swept = point.norm();
        let on_body = spindle.axis + point.turned(spindle.angle(0.0));
        let on_case = spindle.axis + (on_body - spindle.axis) * (radius / swept);
        let distance = (radius - swept).max(0.0);
        let overlap = (swept > radius).then(|| Overlap {
            angles: vec![[0.0, std::f64::consts::TAU / spindle.ratio.value().abs()]],
            depth: swept - radius,
            depth_bound: swept - radius,
            along: DepthAlong::Radius,
        });
        Clearance {
            obstacle: Obstacle::Crankcase,
            distance,
            bound: distance,
            theta: None,
            on_body: [on_body.x, on_body.y, z],
            on_obstacle: [on_case.x, on_case.y, z],
            is_kept: overlap.is_none() && distance + CLEARANCE_GAP >= self.envelope.least.unwrap_or(0.0),
            overlap,
        }
    }

    fn big_ends(&self) -> Vec<BigEndClearance> {
        let (Some(radius), Some(rod)) = (self.envelope.crankcase_radius, self.envelope.rod) else {
            return Vec::new();
        };
        let with_big_end = self.engine.cylinders.iter().enumerate().filter(|(_, c)| has_big_end(c));
        let clearance = |(index, cylinder): (usize, &lanchester_model::Cylinder)| {
            let throw = &self.engine.throws[cylinder.throw];
            let spindle = Spindle::of(self.engine, throw.crankshaft);
            let swept_radius = throw.radius + rod.big_end_radius;
            let point = Point::polar(swept_radius, throw.angle);
            let clearance = self.in_crankcase(&spindle, point, cylinder.z, radius);
            BigEndClearance { cylinder: index + 1, swept_radius, clearance }
        };
        with_big_end.map(clearance).collect()
    }
}
