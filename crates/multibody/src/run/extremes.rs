//! Largest and smallest values over a run, as its result has them.

use serde::Serialize;

/// A value of a run, and where it stands.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Peak {
    /// Value.
    pub value: f64,
    /// Time [s].
    pub time: f64,
    /// Crank angle of crankshaft 1 since the angle 0 [rad].
    pub theta: f64,
}

/// Largest and smallest value of a run.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Bounds {
    /// Largest.
    pub most: Peak,
    /// Smallest.
    pub least: Peak,
}

/// Of what is carried at one cylinder.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CylinderExtremes {
    /// Amount of the side thrust [N].
    pub side_thrust: Peak,
    /// Force in the piston pin [N].
    pub piston_pin: Peak,
    /// Force in the lower pin [N].
    pub lower_pin: Peak,
    /// Force of the rod on the crankpin along its throw, outwards positive [N]; 0 for a knuckle pin.
    pub along_throw: Bounds,
    /// The same across the throw, positive where it drives [N].
    pub across_throw: Bounds,
}

/// Of what is carried at one crankshaft or balance shaft.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct RotorExtremes {
    /// Force on every main bearing [N], by rule ([`crate::MainRule::ALL`]), then by main.
    pub mains: [Vec<Peak>; 3],
    /// Torque of gear or chain [N m].
    pub gear_torque: Bounds,
    /// Force of its teeth [N].
    pub gear_force: Peak,
    /// Force on all bearings together [N].
    pub bearing_force: Peak,
    /// Moment on all bearings together across the axis, about the axis in the plane of the origin [N m].
    pub bearing_moment: Peak,
}

/// Largest and smallest values over a run, or over its last period.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct RunExtremes {
    /// Speed of crankshaft 1 relative to the block [rad/s].
    pub speed: Bounds,
    /// Place of the block's origin along x, y and z [m]; empty with a fixed block.
    pub position: Vec<Bounds>,
    /// Turn of the block about x, y and z [rad]; empty with a fixed block.
    pub turn: Vec<Bounds>,
    /// Force of every mount [N].
    pub mounts: Vec<Peak>,
    /// Torque of every spring of the driveline with its damper, on the inertia behind it [N m].
    pub driveline: Vec<Bounds>,
    /// Torque that the crank train delivers at crankshaft 1 [N m], where reactions were asked for.
    pub shaft_torque: Option<Bounds>,
    /// By cylinder, where reactions were asked for.
    pub cylinders: Vec<CylinderExtremes>,
    /// Crankshafts, then balance shafts, where reactions were asked for.
    pub rotors: Vec<RotorExtremes>,
}
