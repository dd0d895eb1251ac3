//! In-line and VR: a throw for every cylinder.

use super::planes::planes;
use super::skeleton::{CylinderPlace, Skeleton, ThrowFrame};
use super::spec::{LayoutKind, LayoutSpec};
use crate::problem::Problem;
use lanchester_model::RodJoint;
use std::f64::consts::PI;

pub(super) fn skeleton(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Skeleton> {
    let banks = if spec.kind == LayoutKind::Vr { vr_banks(spec, problems)? } else { vec![(0.0, None)] };
    let planes = planes(spec, spec.cylinders, "cylinder", problems)?;
    let throws = planes.iter().enumerate().map(|(entry, &z)| ThrowFrame { entry, lead: 0.0, z }).collect();
    let cylinders = planes
        .iter()
        .enumerate()
        .map(|(throw, &z)| {
            let (angle, offset) = banks[throw % banks.len()];
            CylinderPlace { throw, angle, z, offset, joint: RodJoint::Crankpin }
        })
        .collect();
    Some(Skeleton { throws, cylinders, entry: "cylinder" })
}

/// Angle and offset of the two banks of a VR engine.
///
/// The axes of the banks at `-bank_angle/2` and `+bank_angle/2` cross below the crank, away from the heads, so bank 1
/// passes the crank's axis on its own side, towards -y, and bank 2 towards +y: offsets `-bank_offset`, `+bank_offset`.
fn vr_banks(spec: &LayoutSpec, problems: &mut Vec<Problem>) -> Option<Vec<(f64, Option<f64>)>> {
    let before = problems.len();
    let angle = spec.bank_angle.unwrap_or_else(|| {
        problems.push(
            Problem::new("layout.bank_angle", "bank_angle is missing")
                .hint("a VR engine has a narrow bank angle such as \"15 deg\""),
        );
        0.0
    });
    if spec.bank_angle.is_some_and(|angle| angle <= 0.0 || angle >= PI / 2.0) {
        problems.push(
            Problem::new("layout.bank_angle", "a VR engine needs a bank angle between 0 and 90 deg")
                .hint("type = \"v\" is for wider angles"),
        );
    }
    let offset =
        spec.bank_offset.unwrap_or_else(|| {
            problems.push(Problem::new("layout.bank_offset", "bank_offset is missing").hint(
                "the distance at which the cylinder axes pass the crank's axis; \"0 mm\" if they meet it",
            ));
            0.0
        });
    if offset < 0.0 {
        problems.push(Problem::new("layout.bank_offset", "bank_offset must not be negative"));
    }
    (problems.len() == before).then(|| vec![(-angle / 2.0, Some(-offset)), (angle / 2.0, Some(offset))])
}
