//! An engine as moving solids: what a viewer draws, with the poses of the exact linkages.
//!
//! Frame: the engine's, z along the crank axis from the free end to the flywheel, x up, `theta` the angle of crankshaft 1. Metres
//! and radians.
//!
//! Where the file describes the crankshaft as a body its journals, pins, webs and counterweights are the solids that are exported;
//! elsewhere they are plausible ones of the right places, radii and directions, and weights given by number alone are sectors whose
//! size goes with their unbalance, called "symbolic" in their name. Nothing of a scene enters a computation.

mod balance_shaft;
mod crank;
mod cylinder;
mod mesh;
mod piston;
mod proportions;
mod rod;
mod symbolic;

use lanchester_mechanism::firing_period;
use lanchester_model::{Engine, Rotation};
use mesh::Meshes;
use serde::Serialize;
use std::f64::consts::TAU;

pub use mesh::SceneMesh;

/// Poses of a moving part in one revolution of its crankshaft: halfway between two of them a straight line is within 0.1 % of the crank radius.
const STEPS: usize = 128;

/// The solids of an engine and how they move.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Scene {
    /// Whether +y is to the left for who looks from the free end with x up: an engine that turns the other way is the mirror image of its numbers.
    pub mirrored: bool,
    /// Angle of crankshaft 1 after which everything repeats, firing too [rad].
    pub period: f64,
    /// Poses of a part that slides or swings, evenly over its own period.
    pub steps: usize,
    /// Shapes, each of one part or of several.
    pub meshes: Vec<SceneMesh>,
    /// What is seen.
    pub parts: Vec<ScenePart>,
}

/// A part of the scene.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ScenePart {
    /// Name, such as "piston 3". It says "symbolic" where the size stands for an unbalance and not for a shape.
    pub name: String,
    /// What it is.
    pub kind: SceneKind,
    /// The key of the engine file that says most of it, as the short form of the file has it: "piston.mass".
    pub path: Option<String>,
    /// Number of the cylinder to which it belongs, from 1.
    pub cylinder: Option<usize>,
    /// Index of the engine's counterweight that it is.
    pub weight: Option<usize>,
    /// Index of its shape.
    pub mesh: usize,
    /// How the frame of its shape moves.
    pub motion: SceneMotion,
}

/// What a part of the scene is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SceneKind {
    /// A main journal.
    Journal,
    /// A crankpin.
    Crankpin,
    /// A web of a crankshaft.
    Web,
    /// A weight on a crankshaft.
    Counterweight,
    /// A connecting rod.
    Rod,
    /// A piston with its pin.
    Piston,
    /// A balance shaft without its weights.
    Shaft,
    /// A weight of a balance shaft.
    ShaftWeight,
    /// A cylinder liner.
    Bore,
}

/// How the frame of a part moves in the frame of the engine: a place, and a turn about z. Angles count from +x towards +y.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum SceneMotion {
    /// It stands.
    Fixed {
        /// Place [m].
        x: f64,
        /// Place [m].
        y: f64,
        /// Place [m].
        z: f64,
        /// Its turn [rad].
        angle: f64,
    },
    /// It turns at a constant ratio: by `angle + ratio * theta`.
    Turn {
        /// Axis [m].
        x: f64,
        /// Axis [m].
        y: f64,
        /// Place along the axis [m].
        z: f64,
        /// Its turn at `theta = 0` [rad].
        angle: f64,
        /// Speed over that of crankshaft 1, signed.
        ratio: f64,
    },
    /// It slides along its own x: it stands at `travel` from the place.
    Slide {
        /// Place at no travel [m].
        x: f64,
        /// Place at no travel [m].
        y: f64,
        /// Place [m].
        z: f64,
        /// Direction in which it slides, and its turn [rad].
        angle: f64,
        /// Angle of crankshaft 1 after which it repeats [rad].
        period: f64,
        /// Travel at [`Scene::steps`] even steps of the period, the first at `theta = 0` [m].
        travel: Vec<f64>,
    },
    /// It swings.
    Swing {
        /// Places at [`Scene::steps`] even steps of the period, the first at `theta = 0` [m].
        x: Vec<f64>,
        /// Places [m].
        y: Vec<f64>,
        /// Place along the crank [m].
        z: f64,
        /// Its turns [rad].
        angle: Vec<f64>,
        /// Angle of crankshaft 1 after which it repeats [rad].
        period: f64,
    },
}

/// The scene of an engine. Parts that cannot be drawn, such as webs of impossible outlines, are left out.
pub fn scene(engine: &Engine) -> Scene {
    let mut builder = Builder {
        engine,
        meshes: Meshes::new(proportions::facet_error(engine)),
        parts: Vec::new(),
        proportions: proportions::Proportions::of(engine),
    };
    for crankshaft in 0..engine.crankshafts.len() {
        builder.crankshaft(crankshaft);
    }
    for cylinder in 0..engine.cylinders.len() {
        builder.cylinder(cylinder);
    }
    for shaft in 0..engine.shafts.len() {
        builder.balance_shaft(shaft);
    }
    let mirrored = engine.rotation == Rotation::Reverse;
    Scene { mirrored, period: period(engine), steps: STEPS, meshes: builder.meshes.all, parts: builder.parts }
}

/// A scene while it is being made.
struct Builder<'a> {
    engine: &'a Engine,
    meshes: Meshes,
    parts: Vec<ScenePart>,
    proportions: proportions::Proportions,
}

impl Builder<'_> {
    /// Adds a part with a shape; none without one.
    fn add(&mut self, mesh: Option<SceneMesh>, part: ScenePart) {
        if let Some(mesh) = mesh.filter(|mesh| !mesh.indices.is_empty()) {
            let mesh = self.meshes.index(mesh);
            self.parts.push(ScenePart { mesh, ..part });
        }
    }
}

/// A part of the engine as a whole; its shape comes with [`Builder::add`].
fn part(name: String, kind: SceneKind, path: impl Into<String>, motion: SceneMotion) -> ScenePart {
    ScenePart { name, kind, path: Some(path.into()), cylinder: None, weight: None, mesh: 0, motion }
}

/// That of the loads with gas; a working cycle where ratios have none in common.
fn period(engine: &Engine) -> f64 {
    let cycle = engine.strokes.revolutions();
    let common = firing_period(engine).unwrap_or(cycle);
    TAU * f64::from(if common.is_multiple_of(cycle) { common } else { common * cycle })
}
