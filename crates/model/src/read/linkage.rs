//! Whether every crank can turn.

use super::{Drafts, Reader};
use crate::diagnostic::Mistake;
use crate::engine::{Cylinder, RodJoint, Throw};
use crate::quantity::{self, Dimension};
use std::f64::consts::TAU;

/// Crank angles at which an articulated rod is checked.
const GRID: usize = 1440;

/// Share of the limit by which a rod must be longer: below it a linkage turns on paper, but not in doubles.
const CLEARANCE: f64 = 1e-9;

/// Share of its length by which an articulated rod must clear its limit on the grid: between two grid angles the
/// reach grows by less than `(tau / GRID)^2 / 8` of it, about 2e-6.
const MARGIN: f64 = 1e-5;

impl<'a> Reader<'a> {
    /// Every linkage must turn: `l > r + |e|`, and an articulated rod must reach its piston pin all round.
    pub(super) fn check_linkages(&mut self, drafts: &Drafts<'a>) {
        let is_plain = |cylinder: &Cylinder| !matches!(cylinder.rod.joint, RodJoint::Articulated { .. });
        for draft in drafts.cylinders.iter().flatten().filter(|draft| is_plain(&draft.cylinder)) {
            let cylinder = &draft.cylinder;
            let Some(throw) = &drafts.throws[cylinder.throw] else { continue };
            let offset = cylinder.net_offset();
            let limit = throw.throw.radius + offset.abs();
            if cylinder.rod.length > limit * (1.0 + CLEARANCE) {
                continue;
            }
            let [length, limit] =
                [cylinder.rod.length, limit].map(|value| quantity::readable(value, Dimension::Length));
            let what = if offset == 0.0 { "crank radius" } else { "crank radius plus offset" };
            let mut mistake = Mistake::error(
                "E0303",
                draft.length_span.clone(),
                format!("rod length {length} is not longer than {what} {limit}: the crank cannot turn"),
            )
            .label("too short")
            .hint("rod length is measured between eye centres");
            if !throw.radius_span.is_empty() {
                mistake = mistake.related(throw.radius_span.clone(), "crank radius");
            }
            self.mistakes.push(mistake);
        }
        for draft in drafts.cylinders.iter().flatten() {
            let RodJoint::Articulated { master, .. } = draft.cylinder.rod.joint else { continue };
            let (Some(master), Some(throw)) =
                (&drafts.cylinders[master], &drafts.throws[draft.cylinder.throw])
            else {
                continue;
            };
            let Some(reach) = largest_reach(&throw.throw, &master.cylinder, &draft.cylinder) else {
                continue;
            };
            let length = draft.cylinder.rod.length;
            if reach < length * (1.0 - MARGIN) {
                continue;
            }
            let [length, reach] = [length, reach].map(|value| quantity::readable(value, Dimension::Length));
            self.mistakes.push(
                Mistake::error(
                    "E0304",
                    draft.length_span.clone(),
                    format!(
                        "the articulated rod of {length} must bridge {reach} between knuckle pin and cylinder axis: \
                         the crank cannot turn"
                    ),
                )
                .label("too short")
                .hint("check its length between eye centres, knuckle_radius and knuckle_angle"),
            );
        }
    }
}

/// Largest distance of the knuckle pin from the line of the piston pin over a revolution [m]; `None` if the master's
/// own linkage does not turn.
///
/// In the master's frame the crankpin stands at `r e^{i p}`, its rod points along
/// `(sqrt(l^2 - (r sin p - e)^2) + i (e - r sin p)) / l`; the knuckle pin stands off the crankpin in that direction,
/// turned by the knuckle angle. Only its part across the slave's axis counts.
fn largest_reach(throw: &Throw, master: &Cylinder, slave: &Cylinder) -> Option<f64> {
    let RodJoint::Articulated { knuckle_radius, knuckle_angle, .. } = slave.rod.joint else { return None };
    let (r, l, e) = (throw.radius, master.rod.length, master.net_offset());
    let mut largest = 0.0_f64;
    for step in 0..GRID {
        let pin = TAU * step as f64 / GRID as f64;
        let across = e - r * pin.sin();
        let along = l * l - across * across;
        if along <= 0.0 {
            return None;
        }
        let rod_angle = across.atan2(along.sqrt());
        let turn = master.angle - slave.angle;
        let knuckle = r * (pin + turn).sin() + knuckle_radius * (rod_angle + knuckle_angle + turn).sin();
        largest = largest.max((knuckle - slave.net_offset()).abs());
    }
    Some(largest)
}
