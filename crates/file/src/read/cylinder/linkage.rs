//! Whether every crank can turn.

use crate::read::{Drafts, Reader};
use lanchester_diagnostic::Mistake;
use lanchester_model::linkage::{CLEARANCE, MARGIN, largest_reach};
use lanchester_model::{Cylinder, RodJoint};
use lanchester_units::Dimension;

impl<'a> Reader<'a> {
    /// Every linkage must turn: `l > r + |e|`, and an articulated rod must reach its piston pin all round.
    pub(in crate::read) fn check_linkages(&mut self, drafts: &Drafts<'a>) {
        let is_plain = |cylinder: &Cylinder| !matches!(cylinder.rod.joint, RodJoint::Articulated { .. });
        for draft in drafts.cylinders.iter().flatten().filter(|draft| is_plain(&draft.cylinder)) {
            let cylinder = &draft.cylinder;
            let Some(throw) = &drafts.throws[cylinder.throw] else { continue };
            let offset = cylinder.net_offset();
            let limit = throw.throw.radius + offset.abs();
            if cylinder.rod.length > limit * (1.0 + CLEARANCE) {
                continue;
            }
            let [length, limit] = [cylinder.rod.length, limit]
                .map(|value| lanchester_units::readable(value, Dimension::Length));
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
            let [length, reach] =
                [length, reach].map(|value| lanchester_units::readable(value, Dimension::Length));
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
