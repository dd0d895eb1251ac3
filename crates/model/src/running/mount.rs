//! Engine mounts.

use serde::Serialize;

/// An engine mount.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Mount {
    /// Name for tables and pictures.
    pub name: String,
    /// Position [m].
    pub x: f64,
    /// Position [m].
    pub y: f64,
    /// Position [m], from the origin.
    pub z: f64,
    /// How it yields, if the file says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spring: Option<MountSpring>,
}

/// Stiffness and damping of a mount in three directions of its own, at right angles.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountSpring {
    /// Its three directions: unit vectors in the frame.
    pub axes: [[f64; 3]; 3],
    /// Static stiffness along them [N/m], not negative, at least one positive.
    pub stiffness: [f64; 3],
    /// Viscous damping along them [N s/m].
    pub damping: [f64; 3],
    /// Loss factor along them: the dynamic stiffness is `k (1 + i loss_factor)`.
    pub loss_factor: [f64; 3],
    /// Force on the block along the first direction in the position that the file describes [N].
    pub preload: f64,
    /// Dynamic stiffness over frequency, rising; empty where it is the static one at every frequency. With a table its loss
    /// factors count, and [`MountSpring::loss_factor`] is 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub table: Vec<MountPoint>,
}

/// Dynamic stiffness of a mount at one frequency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountPoint {
    /// Angular frequency [rad/s].
    pub angular_frequency: f64,
    /// Storage stiffness along the mount's directions [N/m].
    pub stiffness: [f64; 3],
    /// Loss factor along them.
    pub loss_factor: [f64; 3],
}

/// Directions of a mount that stands as the frame does.
pub const FRAME_AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Largest loss factor that is believed: a loss angle of 72 degrees.
pub const MAX_LOSS_FACTOR: f64 = 3.0;

impl MountSpring {
    /// A spring along the axes of the frame, without damping.
    pub fn along_frame(stiffness: [f64; 3]) -> MountSpring {
        MountSpring {
            axes: FRAME_AXES,
            stiffness,
            damping: [0.0; 3],
            loss_factor: [0.0; 3],
            preload: 0.0,
            table: Vec::new(),
        }
    }
}
