//! What calculations on mounts return: plain data.
//!
//! SI and radians, axes of the frame. A `[f64; 6]` or `[Complex64; 6]` holds x, y, z, about x, about y, about z, at the
//! block's centre. A complex amplitude `Q` of order n stands for `Re( Q e^{i n theta} )`.

use crate::mounts::rotor_effects::RotorEffects;
use lanchester_results::Extreme;
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const MOUNT_RESULT_VERSION: u32 = 1;

/// Names of the six coordinates of the block.
pub const COORDINATES: [&str; 6] = ["x", "y", "z", "about x", "about y", "about z (roll)"];

/// The body that moves: the file's block, with pistons and rods where they are to be added.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountedBody {
    /// Mass [kg].
    pub mass: f64,
    /// Of it pistons and rods that were added [kg].
    pub added_mass: f64,
    /// Centre of mass [m].
    pub centre: [f64; 3],
    /// Inertia tensor about the centre [kg m^2].
    pub inertia: [[f64; 3]; 3],
}

/// The block at rest under gravity and mean torque.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountStatics {
    /// Displacement of the centre [m] and rotation [rad] from the position of the file.
    pub motion: [f64; 6],
    /// One entry a mount.
    pub mounts: Vec<MountAtRest>,
}

/// One mount at rest. Forces are those of the block on the mount.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountAtRest {
    /// Name.
    pub name: String,
    /// Deflection [m].
    pub deflection: [f64; 3],
    /// Deflection along the mount's own three directions [m].
    pub own_deflection: [f64; 3],
    /// Force [N]: the sum of the three shares.
    pub force: [f64; 3],
    /// The force along the mount's own three directions [N].
    pub own_force: [f64; 3],
    /// Share of gravity [N].
    pub gravity: [f64; 3],
    /// Share of the driveline's torque [N].
    pub torque: [f64; 3],
    /// Share of the preloads of all mounts [N].
    pub preload: [f64; 3],
}

/// Rigid-body modes of the block.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountModes {
    /// Undamped modes, rising.
    pub modes: Vec<MountMode>,
    /// Damped modes, rising by `|root|`. More than six where some are overdamped.
    pub damped: Vec<DampedMode>,
    /// Line about which the free block turns under a torque about z: the torque-roll axis.
    pub torque_roll_axis: AxisLine,
    /// Centre of stiffness of the mounts at rest.
    pub stiffness_centre: StiffnessCentre,
}

/// A line in space.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct AxisLine {
    /// A point of it [m].
    pub point: [f64; 3],
    /// Its direction, a unit vector.
    pub direction: [f64; 3],
}

/// One undamped mode.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountMode {
    /// Natural angular frequency [rad/s]. With a table of stiffness over frequency it is the one at which the stiffness is
    /// that of the table there.
    pub angular_frequency: f64,
    /// Shape: displacement of the centre [m] and rotation [rad], with `shape^T M shape = 1 kg m^2`; its largest energy
    /// share moves in the positive sense.
    pub shape: [f64; 6],
    /// Share of the kinetic energy in each coordinate; they add up to 1. One can be negative where a product of inertia
    /// couples two rotations.
    pub energy: [f64; 6],
    /// Share of the elastic energy in each mount; they add up to 1.
    pub mount_energy: Vec<f64>,
    /// Coordinate with the largest share, an index into [`COORDINATES`].
    pub main: usize,
    /// What is not in that coordinate: 1 minus its share.
    pub coupling: f64,
}

/// One damped mode: the motion `Re( shape e^{root t} )`.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DampedMode {
    /// Root [1/s]: real part the rate of growth (negative), imaginary part the angular frequency [rad/s].
    #[schemars(with = "[f64; 2]")]
    pub root: Complex64,
    /// Damping ratio `-Re(root) / |root|`; 1 where it does not oscillate.
    pub damping_ratio: f64,
    /// Shape at the centre; its largest component in the mass norm is real.
    #[schemars(with = "[[f64; 2]; 6]")]
    pub shape: [Complex64; 6],
}

/// Centre of stiffness: where the coupling of translation and rotation is symmetric.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StiffnessCentre {
    /// The point [m].
    pub point: [f64; 3],
    /// Stiffness along the principal directions [N/m], rising.
    pub stiffness: [f64; 3],
    /// Those directions, unit vectors.
    pub directions: [[f64; 3]; 3],
    /// Residual coupling there, relative: the largest element of the coupling over the geometric mean of the largest stiffness
    /// of translation and of rotation. Where it vanishes, a force through this point does not turn the block: the point is
    /// the elastic centre.
    pub coupling: f64,
}

/// Forces at the mounts and motion of the block against speed, by order.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountResponse {
    /// [`MOUNT_RESULT_VERSION`].
    pub version: u32,
    /// Names of the mounts.
    pub mounts: Vec<String>,
    /// The block's centre [m].
    pub centre: [f64; 3],
    /// One entry a speed, as they were asked for.
    pub speeds: Vec<SpeedResponse>,
    /// Mounts whose table of stiffness does not reach all frequencies of the excitation.
    pub beyond_table: Vec<BeyondTable>,
}

/// A mount whose table ends before the excitation does: beyond it the end's values are used.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BeyondTable {
    /// Index of the mount.
    pub mount: usize,
    /// Angular frequencies of the table's ends [rad/s].
    pub table: [f64; 2],
    /// Lowest and highest angular frequency of the excitation [rad/s].
    pub excitation: [f64; 2],
}

/// Response at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SpeedResponse {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// One entry an order that turns, as in the excitation; order 0 is left out.
    pub orders: Vec<OrderResponse>,
    /// Largest resultant force at each mount over the cycle [N], and the crank angle.
    pub peaks: Vec<Extreme>,
}

/// Response to one order at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OrderResponse {
    /// Order.
    pub order: f64,
    /// Load on the block: force [N] and moment about its centre [N m].
    #[schemars(with = "[[f64; 2]; 6]")]
    pub load: [Complex64; 6],
    /// Displacement of the centre [m] and rotation [rad].
    #[schemars(with = "[[f64; 2]; 6]")]
    pub motion: [Complex64; 6],
    /// Force of the block on each mount [N].
    #[schemars(with = "Vec<[[f64; 2]; 3]>")]
    pub forces: Vec<[Complex64; 3]>,
    /// The same if the mounts were stiff, in the proportions of their static stiffness: the load shared as at rest [N].
    #[schemars(with = "Vec<[[f64; 2]; 3]>")]
    pub stiff_forces: Vec<[Complex64; 3]>,
    /// All mounts together: force [N] and moment about the block's centre [N m].
    #[schemars(with = "[[f64; 2]; 6]")]
    pub transmitted: [Complex64; 6],
}

impl OrderResponse {
    /// Force that the mounts pass on over the force that excites the block, both as root of the sum of squares of the
    /// components; `None` without a force.
    pub fn force_transmissibility(&self) -> Option<f64> {
        ratio(&self.transmitted[..3], &self.load[..3])
    }

    /// The same for the moment about the block's centre.
    pub fn moment_transmissibility(&self) -> Option<f64> {
        ratio(&self.transmitted[3..], &self.load[3..])
    }

    /// Displacement of a point of the block [m]; `centre` is that of the block.
    pub fn motion_at(&self, centre: [f64; 3], point: [f64; 3]) -> [Complex64; 3] {
        let [ux, uy, uz, px, py, pz] = self.motion;
        let [x, y, z] = [0, 1, 2].map(|j| point[j] - centre[j]);
        [ux + py * z - pz * y, uy + pz * x - px * z, uz + px * y - py * x]
    }
}

fn ratio(out: &[Complex64], load: &[Complex64]) -> Option<f64> {
    let size = |list: &[Complex64]| list.iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt();
    let load = size(load);
    (load > 0.0).then(|| size(out) / load)
}

/// All that is told of an engine on its mounts.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MountStudy {
    /// [`MOUNT_RESULT_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// What shakes it, in words.
    pub excitation: String,
    /// What the user should know of that.
    pub warnings: Vec<String>,
    /// The body that moves.
    pub body: MountedBody,
    /// Angular momentum of all rotors whose inertia is known over the speed of crankshaft 1 [kg m^2].
    pub rotors: f64,
    /// What of them acts on the motion.
    pub rotor_effects: RotorEffects,
    /// At rest.
    pub at_rest: MountStatics,
    /// Natural motions.
    pub modes: MountModes,
    /// Against speed, by order.
    pub response: MountResponse,
    /// Motion of the points asked for, against speed, by order.
    pub points: Vec<PointMotion>,
    /// What all mounts together pass on, against frequency.
    pub transmissibility: Transmissibility,
}

/// Motion of a point of the block.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PointMotion {
    /// The point [m].
    pub point: [f64; 3],
    /// Displacement [m] at each speed, for each order of the response.
    #[schemars(with = "Vec<Vec<[[f64; 2]; 3]>>")]
    pub displacement: Vec<Vec<[Complex64; 3]>>,
}

/// Force transmissibility against frequency.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Transmissibility {
    /// Angular frequencies [rad/s], rising in equal ratios.
    pub angular_frequency: Vec<f64>,
    /// For a unit load in each coordinate at the block's centre: the force transmitted in the same coordinate.
    pub ratio: Vec<[f64; 6]>,
}

/// Largest size of the vector `Re( V e^{i alpha} )` over alpha: the major half axis of its ellipse (book, eq. 27.11).
///
/// ```text
/// |Re(V e^{i a})|^2 = ( |V|^2 + Re( V.V e^{2 i a} ) ) / 2
/// ```
pub fn vector_amplitude(vector: &[Complex64; 3]) -> f64 {
    let size: f64 = vector.iter().map(|c| c.norm_sqr()).sum();
    let square: Complex64 = vector.iter().map(|c| c * c).sum();
    (0.5 * (size + square.norm())).sqrt()
}
