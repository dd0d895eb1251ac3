//! What is asked of the stress of a crankshaft, and why it may not be answered.

use crate::bearing_films::BearingFilmsError;
use crate::pressure::error::GasError;
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::CrankSupport;
use lanchester_flex::crank_mesh::CrankMeshOptions;
use lanchester_flex::sparse::SolveEstimate;
use lanchester_flex::statics::SolveOptions;
use lanchester_mechanism::TorqueError;
use lanchester_report::PinForces;

/// Which crankshaft, how fine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StressMesh {
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// Size of its elements.
    pub options: CrankMeshOptions,
}

/// A force that the user gives, along a throw and across it [N].
pub type GivenForce = PinForces;

/// Where the loads come from.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum StressLoad {
    /// The closed form, at the angles of the largest radial, tangential and resultant force on each pin and at each firing top dead centre.
    #[default]
    Extremes,
    /// The closed form at this crank angle [rad].
    Angle(f64),
    /// Forces on pins; without a speed the crankshaft stands still.
    Given(Vec<GivenForce>),
}

/// A static case.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// What holds it.
    pub support: CrankSupport,
    /// Its loads.
    pub load: StressLoad,
    /// Speeds of crankshaft 1 [rad/s]; none: the lowest and the highest of the engine, for given forces standstill.
    pub speeds: Vec<f64>,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// How to solve.
    pub solve: SolveOptions,
}

impl Default for StaticRequest {
    /// The built-in cases on journals, with the gas of the file.
    fn default() -> StaticRequest {
        StaticRequest {
            mesh: StressMesh::default(),
            support: CrankSupport::Journals,
            load: StressLoad::default(),
            speeds: Vec::new(),
            gas: true,
            solve: SolveOptions::default(),
        }
    }
}

/// Natural modes.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesRequest {
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// What holds it; free: the rigid motions come first.
    pub support: CrankSupport,
    /// How many modes beyond the rigid motions.
    pub count: usize,
    /// How to solve.
    pub solve: SolveOptions,
}

impl Default for ModesRequest {
    /// Ten modes of the free crankshaft.
    fn default() -> ModesRequest {
        ModesRequest {
            mesh: StressMesh::default(),
            support: CrankSupport::Free,
            count: 10,
            solve: SolveOptions::default(),
        }
    }
}

/// How far a computation is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StressStage {
    /// Meshed: so many nodes, so many elements.
    Meshed(usize, usize),
    /// What the factor will cost, before it is made.
    Factoring(SolveEstimate),
}

/// Why there is no stress.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StressError {
    /// Mesh, supports or equations.
    #[error(transparent)]
    Flex(#[from] FlexError),
    /// No pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// No loads from them.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// All corners are sharp.
    #[error(
        "no fillet of crankshaft {crankshaft} has a radius: the stress of a sharp corner is unbounded\nhint: give pin_fillet and journal_fillet in [crank.body]"
    )]
    NoFillet {
        /// Its number, from 1.
        crankshaft: usize,
    },
    /// No fatigue limits.
    #[error(
        "fatigue limits are needed, the material has neither of its own nor a tensile strength to estimate them from\nhint: give fatigue_bending and fatigue_torsion, tensile_strength or a preset in [crank.material]"
    )]
    NoFatigueLimit,
    /// Fatigue limits that the criterion cannot hold both.
    #[error(transparent)]
    Limits(#[from] lanchester_strength::LimitsError),
    /// A bearing that cannot have its law.
    #[error("{bearing}: {error}")]
    Bearing {
        /// Which one.
        bearing: String,
        /// Why.
        error: lanchester_film::FilmError,
    },
    /// No oil films.
    #[error(transparent)]
    Films(#[from] BearingFilmsError),
    /// The crank train of this engine is none of plain rods.
    #[error(
        "cylinder {cylinder} has an articulated rod: a flexible crankshaft over the cycle knows rods on crankpins alone\nhint: static stress and fatigue take articulated rods"
    )]
    Articulated {
        /// Its number.
        cylinder: usize,
    },
    /// A crankshaft without cylinders or bearings to turn in.
    #[error("crankshaft {crankshaft} needs {needed}, it has {got}\nhint: {hint}")]
    Train {
        /// Its number.
        crankshaft: usize,
        /// What is needed.
        needed: &'static str,
        /// What is there.
        got: usize,
        /// What fixes it.
        hint: &'static str,
    },
    /// A speed that swings and is not known.
    #[error("the speed within the cycle is not known: {reason}\nhint: {hint}")]
    FreeSpeed {
        /// Why.
        reason: String,
        /// What fixes it.
        hint: String,
    },
    /// A crankshaft or pin that is not there.
    #[error("{what} {number} is needed, the engine has {there}\nhint: numbers count from 1")]
    Missing {
        /// Crankshaft or pin.
        what: &'static str,
        /// Its number.
        number: usize,
        /// What is there, in words.
        there: String,
    },
}

/// A support in words.
pub fn support_words(support: CrankSupport) -> String {
    match support {
        CrankSupport::ClampedEnds => "both end faces clamped".to_owned(),
        CrankSupport::Journals => {
            "mean of each journal's surface fixed in the plane across the axis, flywheel end fixed along and about the axis".to_owned()
        }
        CrankSupport::Springs { stiffness } => format!(
            "a spring of {:.4} MN/m at each journal in both directions, flywheel end fixed along and about the axis",
            1e-6 * stiffness
        ),
        CrankSupport::Rings { thickness, modulus } => format!(
            "rings {} mm thick of {} GPa around the journals, fixed at their outside, and around the loaded pins, which take the load there; contact \
             without friction or tension; flywheel end fixed along and about the axis",
            in_four_places(1e3 * thickness),
            in_four_places(1e-9 * modulus)
        ),
        CrankSupport::Free => "none: loads balanced by the inertia of the crankshaft (inertia relief)".to_owned(),
    }
}

/// Without what stands behind the fourth place.
fn in_four_places(value: f64) -> f64 {
    (1e4 * value).round() / 1e4
}
