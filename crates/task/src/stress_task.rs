//! Stress of the crankshafts: how fine the file wants them meshed, and its static cases.

use serde::Serialize;

/// What an engine file asks of the stress of its crankshafts: `[crank.mesh]` and `[[stress.case]]`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct StressTask {
    /// The mesh.
    pub mesh: MeshTask,
    /// Static cases by name, in the order of the file.
    pub cases: Vec<StressCaseTask>,
}

impl StressTask {
    /// The case of this name, whatever its capitals.
    pub fn case(&self, name: &str) -> Option<&StressCaseTask> {
        let wanted = name.trim().to_lowercase();
        self.cases.iter().find(|case| case.name.to_lowercase() == wanted)
    }
}

/// How the crankshafts are meshed where nobody asks for something else.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct MeshTask {
    /// Edge of the elements away from fillets [m].
    pub size: Option<f64>,
    /// Elements across the 90 degrees of a fillet: an even number.
    pub fillet_elements: Option<usize>,
    /// File of a mesh instead, a CalculiX deck with sets `PIN_1`, `MAIN_1`, `FLYWHEEL`.
    pub file: Option<String>,
}

/// A static case of the file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StressCaseTask {
    /// Its name; no two of a file are the same but for capitals.
    pub name: String,
    /// Index of its crankshaft.
    pub crankshaft: usize,
    /// What loads it.
    pub load: StressCaseLoad,
    /// Speed of crankshaft 1 [rad/s], whose centrifugal field loads the crankshaft.
    pub speed: Option<f64>,
    /// What holds it.
    pub support: StressSupport,
}

/// What loads a crankshaft in a case of the file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum StressCaseLoad {
    /// Gas and inertia at a crank angle.
    Angle {
        /// The angle [rad].
        angle: f64,
    },
    /// Forces on pins.
    Forces {
        /// The forces.
        forces: Vec<CasePinForce>,
        /// Crank angle [rad]: springs that differ across directions keep to the block.
        angle: Option<f64>,
    },
}

/// A force on a crankpin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CasePinForce {
    /// Index of the throw.
    pub throw: usize,
    /// Along the throw, positive away from the crank axis [N].
    pub radial: f64,
    /// Across it, positive where it drives the crankshaft [N].
    pub tangential: f64,
}

/// What holds a crankshaft in a case of the file.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum StressSupport {
    /// Both end faces clamped.
    ClampedEnds,
    /// The mean of each journal's surface, and the flywheel's end along and about the axis.
    Journals,
    /// Rings with contact around journals and loaded pins.
    Rings {
        /// Outer less inner radius [m].
        thickness: Option<f64>,
        /// Young's modulus [Pa].
        modulus: Option<f64>,
    },
    /// As journals, by springs.
    Springs {
        /// Along x and y of the block [N/m]: one for all journals, or one for each from the free end on.
        stiffness: Vec<[f64; 2]>,
    },
    /// The oil films of the main bearings, in which the crankshaft rests in equilibrium.
    Film,
    /// None: loads are balanced by inertia.
    Free,
}

impl StressSupport {
    /// Words of the engine file for the kinds of support.
    pub const WORDS: [&'static str; 6] = ["clamped-ends", "journals", "rings", "springs", "film", "free"];

    /// Its word in the engine file.
    pub fn word(&self) -> &'static str {
        match self {
            StressSupport::ClampedEnds => "clamped-ends",
            StressSupport::Journals => "journals",
            StressSupport::Rings { .. } => "rings",
            StressSupport::Springs { .. } => "springs",
            StressSupport::Film => "film",
            StressSupport::Free => "free",
        }
    }
}
