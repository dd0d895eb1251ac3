//! The short form of a layout (`[layout]`) expanded to throws and cylinders.
//!
//! SI units and radians; z is counted along the crank from the middle of the arrangement. Nothing here reads text: the
//! reader fills a [`LayoutSpec`], and every [`Problem`] names the key that it is about, so that the reader finds the
//! place in the file.

mod banks;
mod crank;
mod keys;
mod planes;
mod radial;
mod row;
mod skeleton;
mod spec;

pub(crate) use skeleton::CylinderPlace;
pub(crate) use spec::{Bank, LayoutKind, LayoutSpec, Numbering, Pins, Rods};

use crate::problem::Problem;

/// Most cylinders that a short form expands to. Above the largest piston engines built (56), and small enough
/// that a slip of the keyboard does not fill the memory.
const MOST_CYLINDERS: usize = 240;

/// The layout in the general form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arrangement {
    /// Throws from the free end to the flywheel, the first at 0.
    pub(crate) throws: Vec<ThrowPlace>,
    /// Cylinders by number.
    pub(crate) cylinders: Vec<CylinderPlace>,
}

/// Place of a throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ThrowPlace {
    /// Direction on the crankshaft [rad], in [0, 2 pi).
    pub(crate) angle: f64,
    /// Plane [m].
    pub(crate) z: f64,
}

/// Throws and cylinders of the layout, or everything that is wrong with it.
pub(crate) fn arrange(spec: &LayoutSpec) -> Result<Arrangement, Vec<Problem>> {
    let mut problems = Vec::new();
    keys::check(spec, &mut problems);
    let rows = if spec.kind == LayoutKind::Radial { spec.rows.unwrap_or(1) } else { 1 };
    let count = spec.cylinders.saturating_mul(rows);
    if count == 0 || count > MOST_CYLINDERS {
        let key = if spec.cylinders == 0 || rows == 1 { "layout.cylinders" } else { "layout.rows" };
        problems
            .push(Problem::new(key, format!("needs 1 to {MOST_CYLINDERS} cylinders in all, got {count}")));
        return Err(problems);
    }
    let skeleton = match spec.kind {
        LayoutKind::InLine | LayoutKind::Vr => row::skeleton(spec, &mut problems),
        LayoutKind::V | LayoutKind::Boxer | LayoutKind::Flat | LayoutKind::W => {
            banks::skeleton(spec, &mut problems)
        }
        LayoutKind::Radial => radial::skeleton(spec, &mut problems),
    };
    let Some(skeleton) = skeleton else { return Err(problems) };
    let angles = crank::angles(spec, &skeleton, &mut problems);
    let (Some(angles), true) = (angles, problems.is_empty()) else { return Err(problems) };
    let throws =
        skeleton.throws.iter().zip(angles).map(|(throw, angle)| ThrowPlace { angle, z: throw.z }).collect();
    Ok(Arrangement { throws, cylinders: skeleton.cylinders })
}

#[cfg(test)]
mod tests;
