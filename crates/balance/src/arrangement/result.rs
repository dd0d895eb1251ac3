//! What the search over arrangements answers: plain data, SI units and radians.

use crate::Answer;
use crate::arrangement::request::Judged;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const ARRANGEMENTS_VERSION: u32 = 1;

/// All arrangements, by cylinder spacing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Arrangements {
    /// [`ARRANGEMENTS_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// What was judged.
    pub criterion: Judged,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Value that is good enough, in the criterion's SI unit.
    pub limit: Option<f64>,
    /// Where that value comes from.
    pub limit_source: Option<String>,
    /// Rules and sizes that were taken where the request gives none, in words.
    pub assumptions: Vec<String>,
    /// One entry a spacing, in the order of the request.
    pub spacings: Vec<SpacingArrangements>,
    /// Where nobody reaches the limit: the best that there is.
    pub nearest: Option<Nearest>,
}

/// The arrangements at one cylinder spacing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SpacingArrangements {
    /// Cylinder spacing [m]; `None` where the engine has all its throws and cylinders in one plane.
    pub spacing: Option<f64>,
    /// Every z of throws, cylinders and counterweights over that of the engine file.
    pub scale: f64,
    /// The criterion with nothing added (balance shafts of the engine file taken out).
    pub baseline: f64,
    /// All that were examined, by rising number of shafts.
    pub arrangements: Vec<Arrangement>,
    /// Indices of those that no other beats, by falling residual.
    pub front: Vec<usize>,
    /// Index of the simplest that reaches the limit and has a place: fewest shafts, meshes, then mass.
    pub simplest: Option<usize>,
    /// What was not examined, and why.
    pub left_out: Vec<String>,
}

/// One arrangement with its weights, drive and price.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Arrangement {
    /// In words: "crank weights, second-order shafts with and against the crank".
    pub name: String,
    /// In short: "crank +2 -2", each number a balance shaft by its speed over that of the crank; "crank -1, lightest"
    /// with the lightest weights that hold the limit; "nothing".
    pub label: String,
    /// Whether its weights are the lightest that hold the limit; else they leave the smallest residual.
    pub lightest: bool,
    /// Whether weights are added to the crank.
    pub crank_weights: bool,
    /// Its balance shafts.
    pub shafts: Vec<ArrangedShaft>,
    /// Peak of the criterion that is left. Not a number for an arrangement that cannot hold the further limits.
    pub residual: f64,
    /// Whether the residual is at or below the limit, within 1e-6 of it.
    pub reaches_limit: Option<bool>,
    /// Peak of the resultant force that is left [N].
    pub force: f64,
    /// Peak of the resultant couple about the origin that is left [N m].
    pub couple: f64,
    /// Peak of the roll moment that is left [N m], at the places of the shafts.
    pub roll_moment: f64,
    /// Largest load of inertia on any main bearing over the cycle, throw by throw [N].
    pub main_load: f64,
    /// Largest bending moment along any crankshaft as a free beam under what turns with it [N m].
    pub bending_moment: f64,
    /// How the shafts are driven; `None` without shafts or without a place for them.
    pub drive: Option<DriveTrain>,
    /// The narrowest place between the parts; `None` without shafts. Negative where no allowed position clears.
    pub clearance: Option<Clearance>,
    /// What it costs.
    pub price: Price,
    /// Whether it has a place and a drive, and holds the further limits.
    pub possible: bool,
    /// Whether no other arrangement at this spacing beats it.
    pub on_front: bool,
    /// The weights, with the proof that these devices leave no less.
    pub answer: Answer,
}

/// A balance shaft of an arrangement.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ArrangedShaft {
    /// Name, as in the answer.
    pub name: String,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: i32,
    /// Weights in one plane or two.
    pub layout: ShaftLayout,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Outer radius of its weights [m].
    pub weight_sweep: f64,
    /// Length of its longest weight along the axis [m].
    pub weight_length: f64,
    /// Mass of its weights [kg].
    pub weight_mass: f64,
    /// Mass of the bare shaft [kg].
    pub shaft_mass: f64,
    /// Inertia of weights and shaft about its own axis [kg m^2].
    pub inertia: f64,
    /// Planes of its two bearings [m].
    pub bearing_planes: [f64; 2],
    /// Radial load of each bearing [N]; it turns with the shaft at a constant amount.
    pub bearing_loads: [f64; 2],
}

/// The weights of a balance shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum ShaftLayout {
    /// One weight: a force.
    Single {
        /// Plane [m].
        z: f64,
    },
    /// Two equal and opposed weights: a couple.
    Double {
        /// Planes [m].
        z: [f64; 2],
    },
    /// Two weights, each its own amount and phase: a force and a couple.
    TwoPlanes {
        /// Planes [m].
        z: [f64; 2],
    },
}

/// Gears (and chains or belts) between crank and shafts.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DriveTrain {
    /// Every gear, idlers too.
    pub gears: Vec<Gear>,
    /// Every mesh, chain or belt.
    pub links: Vec<DriveLink>,
    /// Gear planes beyond the end of the crank.
    pub planes: usize,
}

/// A gear or sprocket.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Gear {
    /// What it sits on.
    pub seat: GearSeat,
    /// Position of its axis [m].
    pub x: f64,
    /// Position of its axis [m].
    pub y: f64,
    /// Pitch diameter [m].
    pub pitch_diameter: f64,
    /// Speed over that of crankshaft 1, signed.
    pub ratio: f64,
    /// Gear plane, from 1 at the end of the crank outwards.
    pub plane: usize,
}

/// What a gear sits on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GearSeat {
    /// Crankshaft 1.
    Crank,
    /// A balance shaft, by index.
    Shaft(usize),
    /// Its own stud.
    Idler,
}

/// Two gears that mesh, or two sprockets that a chain or belt joins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct DriveLink {
    /// Index of the driving gear.
    pub driver: usize,
    /// Index of the driven gear.
    pub driven: usize,
    /// Whether a chain or belt joins them.
    pub chain: bool,
}

/// The narrowest place.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "ArrangementClearance")]
pub struct Clearance {
    /// Distance between the two parts [m]; negative: they overlap.
    pub distance: f64,
    /// Which parts, in words, with the crank angle for moving ones.
    pub between: String,
}

/// What an arrangement costs.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Price {
    /// Balance shafts.
    pub shafts: usize,
    /// Weights, on crank and shafts.
    pub weights: usize,
    /// Gear meshes.
    pub meshes: usize,
    /// Idlers.
    pub idlers: usize,
    /// Chains or belts.
    pub chains: usize,
    /// Bearings of shafts and idlers.
    pub bearings: usize,
    /// Unbalance added, all weights together [kg m].
    pub unbalance: f64,
    /// Mass of all weights [kg].
    pub weight_mass: f64,
    /// Mass of bare shafts, gears and idlers [kg].
    pub drive_mass: f64,
    /// Inertia of everything added, at the crank [kg m^2]: each part times its ratio squared.
    pub inertia: f64,
    /// Largest load of a shaft bearing [N].
    pub bearing_load: f64,
    /// Power that the crank gives to turn the shafts [W]: bearing friction and mesh losses.
    pub drive_power: f64,
    /// Largest torque in a mesh or chain, at the driven gear [N m].
    pub drive_torque: f64,
}

impl Price {
    /// Mass of everything added [kg].
    pub fn mass(&self) -> f64 {
        self.weight_mass + self.drive_mass
    }
}

/// The best where nobody reaches the limit.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Nearest {
    /// Index of its spacing.
    pub spacing: usize,
    /// Index of the arrangement there.
    pub arrangement: usize,
    /// What it leaves, in the criterion's SI unit.
    pub residual: f64,
    /// How close it comes, in words.
    pub reason: String,
}
