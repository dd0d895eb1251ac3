//! The throws and cylinders of a layout before the crank has its angles.

use lanchester_model::RodJoint;

/// Place of a cylinder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CylinderPlace {
    /// Index of its throw.
    pub(crate) throw: usize,
    /// Direction of its axis [rad].
    pub(crate) angle: f64,
    /// Plane [m].
    pub(crate) z: f64,
    /// Offset of its axis along +v [m] that the layout itself brings (`bank_offset`, `banks`), `None` where it says nothing.
    pub(crate) offset: Option<f64>,
    /// What its rod's big end sits on.
    pub(crate) joint: RodJoint,
}

/// The throws and cylinders of a layout before the crank has its angles.
pub(super) struct Skeleton {
    pub(super) throws: Vec<ThrowFrame>,
    pub(super) cylinders: Vec<CylinderPlace>,
    /// What one entry of `crank_angles` stands for: "throw", "cylinder", "pair", "row".
    pub(super) entry: &'static str,
}

/// A throw whose angle is that of its entry of `crank_angles` plus `lead`.
pub(super) struct ThrowFrame {
    pub(super) entry: usize,
    pub(super) lead: f64,
    pub(super) z: f64,
}
