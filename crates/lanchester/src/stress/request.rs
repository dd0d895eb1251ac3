//! What is asked of the stress of a crankshaft, and why it may not be answered.

use crate::bearing_films::BearingFilmsError;
use crate::crosscheck::pair::CrossCheckError;
use crate::pressure::error::GasError;
use crate::simulation::SimulateRequest;
use crate::stress::mesh::StressMesh;
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankSupport, PinPressure};
use lanchester_flex::sparse::SolveEstimate;
use lanchester_flex::statics::SolveOptions;
use lanchester_mechanism::TorqueError;
use lanchester_model::SimulationInput;
use lanchester_report::PinForces;
use lanchester_task::Tasks;

/// A force that the user gives, along a throw and across it [N].
pub type GivenForce = PinForces;

/// Where the loads come from.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum StressLoad {
    /// The closed form, at the angles of the largest radial, tangential and resultant force on each pin and at each firing top dead centre.
    #[default]
    Extremes,
    /// The closed form at these crank angles [rad].
    Angles(Vec<f64>),
    /// Forces on pins; without a speed the crankshaft stands still.
    Given {
        /// The forces.
        forces: Vec<GivenForce>,
        /// Crank angle [rad], which turns the crankshaft in springs that differ across directions; 0 where none is given.
        angle: Option<f64>,
    },
}

/// What computes the loads of gas and inertia.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum LoadSource {
    /// The closed form, at constant speed.
    #[default]
    ClosedForm,
    /// A run of the multibody simulation: the largest forces among its samples, or those at crank angles of its last period, each with the speed and the angular
    /// acceleration of its instant.
    Simulation(Box<SimulatedSource>),
}

/// A run that gives loads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SimulatedSource {
    /// What the engine file says of it.
    pub input: Option<SimulationInput>,
    /// What is asked besides.
    pub request: SimulateRequest,
}

impl LoadSource {
    /// The run that an engine file describes.
    pub fn of_run(tasks: &Tasks, request: SimulateRequest) -> LoadSource {
        let input = tasks.simulation.as_deref().cloned();
        LoadSource::Simulation(Box::new(SimulatedSource { input, request }))
    }
}

/// A static case.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticRequest {
    /// Name of the case, which goes before the words of its loads.
    pub name: Option<String>,
    /// Which crankshaft, how fine.
    pub mesh: StressMesh,
    /// What holds it.
    pub support: CrankSupport,
    /// Its loads.
    pub load: StressLoad,
    /// What computes them, but for given forces.
    pub source: LoadSource,
    /// How forces on pins are spread.
    pub pressure: PinPressure,
    /// Speeds of crankshaft 1 [rad/s]; none: the lowest and the highest of the engine, for given forces standstill, and of a simulated run the one that it starts with.
    pub speeds: Vec<f64>,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// A bay that is solved again on a finer mesh.
    pub submodel: Option<SubmodelRequest>,
    /// How to solve.
    pub solve: SolveOptions,
}

impl Default for StaticRequest {
    /// The built-in cases on journals, with the gas of the file.
    fn default() -> StaticRequest {
        StaticRequest {
            name: None,
            mesh: StressMesh::default(),
            support: CrankSupport::Journals,
            load: StressLoad::default(),
            source: LoadSource::default(),
            pressure: PinPressure::default(),
            speeds: Vec::new(),
            gas: true,
            submodel: None,
            solve: SolveOptions::default(),
        }
    }
}

/// A submodel that is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubmodelRequest {
    /// Number of the throw in its bay, from 1.
    pub throw: usize,
    /// Elements across its fillets, more than the whole has; `None`: 6, or the most below that [`MOST_NODES`](crate::MOST_NODES) nodes
    /// leave room for; two more than the whole where that has 6 and more.
    pub fillet_elements: Option<usize>,
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
    /// No run that could give loads.
    #[error(transparent)]
    Simulation(Box<CrossCheckError>),
    /// A crank angle that the run does not pass.
    #[error(
        "the run turns by {turned:.3} revolutions and does not pass {angle:.1} deg in its last period\nhint: let it run for longer, or ask for another angle"
    )]
    NotReached {
        /// The angle [deg].
        angle: f64,
        /// Revolutions of the run.
        turned: f64,
    },
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
    /// A support that is another one at every crank angle.
    #[error(
        "springs whose stiffness along x and y differs hold the crankshaft differently at every crank angle: fatigue over the cycle needs one stiffness for both\nhint: \
         give one stiffness for both directions, or solve single crank angles"
    )]
    AngledSprings,
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
    /// Films that a static case cannot have.
    #[error("no oil films: {reason}\nhint: {hint}")]
    NoFilms {
        /// Why.
        reason: &'static str,
        /// What fixes it.
        hint: &'static str,
    },
    /// The crank train of this engine is none of plain rods.
    #[error(
        "cylinder {cylinder} has an articulated rod: oil films on crankpins and a flexible crankshaft over the cycle know rods on crankpins alone\nhint: static stress and \
         fatigue take articulated rods, with a pressure on the pins that needs no film"
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
    /// A mesh from elsewhere that cannot be used.
    #[error("{name}: {error}")]
    MeshFile {
        /// Its name in the engine file.
        name: String,
        /// Why.
        error: Box<FlexError>,
    },
    /// A mesh from elsewhere that nobody has read.
    #[error(
        "the mesh {name} of [crank.mesh] has not been read\nhint: give a size of the elements, which meshes [crank.body] instead, or leave `file` out of [crank.mesh]"
    )]
    MeshNotRead {
        /// Its name in the engine file.
        name: String,
    },
    /// A study that needs several meshes.
    #[error(
        "a study of convergence needs meshes of three sizes, and {name} of [crank.mesh] is one\nhint: give a size of the elements, which meshes [crank.body] instead"
    )]
    OneMesh {
        /// Its name in the engine file.
        name: String,
    },
    /// Sizes of the sheet after UR M53.
    #[error(transparent)]
    Strength(#[from] lanchester_strength::StrengthError),
    /// A mesh on which factors are none.
    #[error(
        "stress concentration factors need {needed} or more elements across a fillet, got {got}\nhint: the rule's appendix accepts no fewer: ask for {needed}"
    )]
    CoarseFactors {
        /// How many at least.
        needed: usize,
        /// How many were asked for.
        got: usize,
    },
    /// A submodel of a mesh that is not ours.
    #[error(
        "a submodel is cut from a mesh of [crank.body], and {name} of [crank.mesh] is one of another program\nhint: give a size of the elements, which meshes [crank.body] instead"
    )]
    SubmodelOfOwn {
        /// Its name in the engine file.
        name: String,
    },
    /// A submodel that would not be finer.
    #[error(
        "a submodel needs more elements across its fillets than the whole crankshaft, which has {whole}; got {asked}\nhint: an even number above {whole}, or fewer for the whole crankshaft"
    )]
    CoarseSubmodel {
        /// Elements across a fillet of the whole.
        whole: usize,
        /// What was asked for.
        asked: usize,
    },
    /// No finer mesh of the bay that can be solved in minutes.
    #[error(
        "no mesh of the submodel with {least} to {most} elements across its fillets has good elements and no more than {nodes} nodes\nhint: say how many elements its fillets shall have, or give the whole crankshaft fewer"
    )]
    NoSubmodel {
        /// Fewest that were tried, two more than the whole has.
        least: usize,
        /// Most that were tried.
        most: usize,
        /// Most nodes.
        nodes: usize,
    },
    /// A static case that the engine file does not have.
    #[error("no static case of the engine file is called \"{name}\"\nhint: {}", known_cases(.known))]
    NoCase {
        /// The name asked for.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// More crank angles than results of the whole crankshaft can be kept.
    #[error(
        "{got} crank angles, each with the stress of the whole crankshaft, are more than the {most} that are kept at a time\nhint: take larger steps or a part of the cycle; fatigue and the crank train over the cycle go over all of it, at the fillets"
    )]
    Angles {
        /// How many were asked for.
        got: usize,
        /// How many there may be.
        most: usize,
    },
    /// Nobody waits for the answer any more.
    #[error("the computation was cancelled")]
    Cancelled,
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

/// What the file has instead of a case.
fn known_cases(known: &[String]) -> String {
    if known.is_empty() {
        return "the file has none; add a table [[stress.case]]".to_owned();
    }
    let names: Vec<String> = known.iter().map(|name| format!("\"{name}\"")).collect();
    format!("the file has {}", names.join(", "))
}

/// A support in words.
pub fn support_words(support: &CrankSupport) -> String {
    match support {
        CrankSupport::ClampedEnds => "both end faces clamped".to_owned(),
        CrankSupport::Journals => {
            "mean of each journal's surface fixed in the plane across the axis, flywheel end fixed along and about the axis".to_owned()
        }
        CrankSupport::Springs { stiffness } => match stiffness[..] {
            [[x, y]] if x == y => format!(
                "a spring of {:.4} MN/m at each journal in both directions, flywheel end fixed along and about the axis",
                1e-6 * x
            ),
            _ => {
                let of = |(index, [x, y]): (usize, &[f64; 2])| {
                    let which = if stiffness.len() == 1 { "each".to_owned() } else { (index + 1).to_string() };
                    let [x, y] = [x, y].map(|k| in_four_places(1e-6 * k));
                    if x == y { format!("{which} {x}") } else { format!("{which} {x} and {y}") }
                };
                let each: Vec<String> = stiffness.iter().enumerate().map(of).collect();
                format!(
                    "springs at the journals, stiffness along x and y of the block in MN/m: {}; flywheel end fixed along and about the axis",
                    each.join(", ")
                )
            }
        },
        CrankSupport::Rings { thickness, modulus } => format!(
            "rings {} mm thick of {} GPa around the journals, fixed at their outside, and around the loaded pins, which take the load there; contact \
             without friction or tension; flywheel end fixed along and about the axis",
            in_four_places(1e3 * *thickness),
            in_four_places(1e-9 * *modulus)
        ),
        CrankSupport::Films => {
            "in equilibrium with the oil films of the main bearings, flywheel end fixed along and about the axis".to_owned()
        }
        CrankSupport::Free => "none: loads balanced by the inertia of the crankshaft (inertia relief)".to_owned(),
    }
}

/// Without what stands behind the fourth place.
fn in_four_places(value: f64) -> f64 {
    (1e4 * value).round() / 1e4
}
