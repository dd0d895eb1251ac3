//! What may be asked of a torque calculation, and why it may be refused.

use crate::inertia::request::{Kinematics, LoadError, LoadRequest};
use lanchester_results::CurveError;
use serde::Serialize;

/// Lever with which the force along the cylinder axis turns the crank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Lever {
    /// The lever of the linkage, `-ds/dphi`: virtual work, exact for every rod.
    Exact,
    /// `r sin phi`: the lever of a rod that stays parallel to the cylinder axis, as in the twin thesis, eq. 22. It loses
    /// the part of the work that the slant of the rod gives. Only for centred plain rods.
    Sine,
}

impl Lever {
    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Lever::Exact => "exact lever",
            Lever::Sine => "lever r sin(theta)",
        }
    }
}

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueRequest {
    /// Speed of crankshaft 1 [rad/s]; `None`: the highest speed of the engine. The pressures must be those of this speed.
    pub speed: Option<f64>,
    /// Lever of gas and inertia.
    pub lever: Lever,
    /// Motion from which the inertia follows; gas always moves with the exact one.
    pub kinematics: Kinematics,
    /// Highest order listed, in cycles per revolution of crankshaft 1.
    pub max_order: u32,
    /// Angles of the traces in one revolution of crankshaft 1.
    pub samples: usize,
}

impl Default for TorqueRequest {
    /// The exact lever at the highest speed, orders to 8, every degree.
    fn default() -> Self {
        TorqueRequest {
            speed: None,
            lever: Lever::Exact,
            kinematics: Kinematics::Exact,
            max_order: 8,
            samples: 360,
        }
    }
}

impl TorqueRequest {
    /// The inertia loads that go with it, about the origin.
    pub(crate) fn loads(&self) -> LoadRequest {
        LoadRequest {
            speed: self.speed,
            kinematics: self.kinematics,
            max_order: self.max_order,
            samples: self.samples,
            ..LoadRequest::default()
        }
    }
}

/// Why there is no torque, or no load with gas.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TorqueError {
    /// The inertia loads cannot be computed.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The pressures cannot be computed with.
    #[error("pressures of cylinder {cylinder}: {source}")]
    Curve {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// Why.
        source: CurveError,
    },
    /// Pressures for too many or too few cylinders.
    #[error("pressures must be given for each of the {needed} cylinders, got {got}")]
    CylinderCount {
        /// Cylinders of the engine.
        needed: usize,
        /// Pressures given.
        got: usize,
    },
    /// Pressures of another cycle.
    #[error(
        "pressures of cylinder {cylinder} must have a period of {needed} rad, the working cycle, got {got} rad"
    )]
    Period {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// Angle of the working cycle [rad].
        needed: f64,
        /// Period of the curve [rad].
        got: f64,
    },
    /// No bore.
    #[error(
        "gas needs the bore of cylinder {cylinder}\nhint: add bore = \"79.5 mm\" to [piston] or to the cylinder"
    )]
    NoBore {
        /// Cylinder number, from 1.
        cylinder: usize,
    },
    /// No firing angle.
    #[error(
        "gas needs the firing of cylinder {cylinder}\nhint: add [firing] with the firing order, as order = [1, 3, 4, 2]"
    )]
    NoFiring {
        /// Cylinder number, from 1.
        cylinder: usize,
    },
    /// The sine lever knows neither offsets nor articulated rods.
    #[error(
        "the lever r sin(theta) needs centred plain rods, got {found} in cylinder {cylinder}\nhint: ask for the exact lever"
    )]
    SineLever {
        /// Cylinder number, from 1.
        cylinder: usize,
        /// What it has instead.
        found: &'static str,
    },
}
