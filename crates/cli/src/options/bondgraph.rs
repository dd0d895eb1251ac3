//! The command line of `lanchester bondgraph`.

use crate::format::Format;
use crate::options::simulation::Until;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `bondgraph`
#[derive(Debug, Args)]
pub struct BondgraphArguments {
    /// What to show, and the graph file or engine file (`-`: standard input): causality, equations, linear, simulate, audit, draw or
    /// export; without it causality and equations, of large graphs a summary.
    #[arg(value_names = ["ACTION", "FILE"], required = true, num_args = 1..=2)]
    pub words: Vec<String>,
    /// How equations are written.
    #[arg(long, value_enum, default_value_t = NotationOption::Text)]
    pub notation: NotationOption,
    /// `causality`: which stores it assigns first; `derivative` shows the dual, for study.
    #[arg(long, value_enum, default_value_t = PreferOption::Integral)]
    pub prefer: PreferOption,
    /// Duration of the simulation, with its unit; default: that of the graph file, else 1 s; of an engine file two revolutions.
    #[arg(long = "for", value_name = "TIME")]
    pub duration: Option<String>,
    /// `periodic`: the motion that repeats, one period of it with its multipliers, instead of a run from the start. A graph file says in `[simulation]`
    /// what its `period` is.
    #[arg(long, value_enum, conflicts_with = "duration")]
    pub until: Option<Until>,
    /// Samples of the simulation beside its start.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub samples: Option<u32>,
    /// Relative tolerance of the simulation, 1e-13 to 0.01.
    #[arg(long, value_name = "SHARE")]
    pub tolerance: Option<f64>,
    /// Method of the simulation; default: explicit, and implicit from where stiffness is measured.
    #[arg(long, value_enum)]
    pub method: Option<MethodOption>,
    /// `linear`: outputs, separated by commas: effort or flow of any bond, or a signal, as `spring.effort`; default: flows of inertias, efforts
    /// of capacitors, and signals.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub output: Vec<String>,
    /// Which text `export` writes.
    #[arg(long, value_enum, default_value_t = ExportOption::Modelica)]
    pub to: ExportOption,
    /// `simulate`: every quantity in the text; default: of many, the states.
    #[arg(long)]
    pub all: bool,
    /// Let a simulation take more than ten million evaluations.
    #[arg(long)]
    pub long: bool,
    /// `draw`: bonds as wide as the power through them, over the simulation, in ten seconds.
    #[arg(long)]
    pub moving: bool,
    /// `simulate`: write the curves of the run as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// What the graph of an engine file holds.
    #[command(flatten)]
    pub engine: EngineOptions,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// What the graph of an engine file holds; a graph file says all of it itself.
#[derive(Debug, Args, Default, PartialEq)]
pub struct EngineOptions {
    /// Of an engine file: speed of crankshaft 1 at the start, with its unit; default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Of an engine file: how the block moves; default: in space on its mounts where the file gives them with viscous damping.
    #[arg(long, value_enum)]
    pub block: Option<EngineBlockOption>,
    /// Of an engine file: joints of the crank train; default: ideal.
    #[arg(long, value_enum)]
    pub joints: Option<JointsOption>,
    /// Of an engine file: stiffness of each pin, and of the main bearings together, of compliant joints; default: "200000 N/mm".
    #[arg(long, value_name = "STIFFNESS")]
    pub joint_stiffness: Option<String>,
    /// Of an engine file: stiffness of each of the two contacts of a skirt of compliant joints; default: "50000 N/mm".
    #[arg(long, value_name = "STIFFNESS")]
    pub skirt_stiffness: Option<String>,
    /// Of an engine file: from the piston pin to the middle between both contacts of a skirt of compliant joints, positive towards the crown; default: "0 mm".
    #[arg(long, value_name = "LENGTH")]
    pub skirt_offset: Option<String>,
    /// Of an engine file: damping ratio of compliant joints, 0 to 10; default: 0.2.
    #[arg(long, value_name = "RATIO")]
    pub joint_damping: Option<f64>,
    /// Of an engine file: keep the speed by a source of flow.
    #[arg(long)]
    pub imposed: bool,
    /// Of an engine file: torque of a constant load, with its unit, or `none`; default: with gas the mean that the engine gives at the
    /// start speed, of a periodic motion in proportion to the speed.
    #[arg(long, value_name = "TORQUE")]
    pub load: Option<String>,
    /// Of an engine file: the load is bolted to the block.
    #[arg(long)]
    pub load_on_block: bool,
    /// Of an engine file: gas as states with valves and heat release, instead of the pressures of its cycle.
    #[arg(long, conflicts_with = "inertia_only")]
    pub gas_states: bool,
    /// Of an engine file: leave out its gas.
    #[arg(long)]
    pub inertia_only: bool,
    /// Of an engine file: leave out its balance shafts, to see what they do.
    #[arg(long)]
    pub without_shafts: bool,
    /// Of an engine file: leave out the weight.
    #[arg(long)]
    pub no_gravity: bool,
}

/// How the block of an engine moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EngineBlockOption {
    /// It stands still.
    Fixed,
    /// In the plane across the crank.
    Plane,
    /// In space.
    Space,
    /// In space, held still: what `hold_vx` to `hold_wz` exert is the opposite of the loads on it, about the origin.
    Held,
}

/// Joints of a crank train.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum JointsOption {
    /// Rods and pistons follow the crank.
    Ideal,
    /// Springs and dampers at each joint; crankshaft, rods and pistons move freely in their planes.
    Compliant,
}

/// How equations are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum NotationOption {
    /// Plain text.
    Text,
    /// LaTeX.
    Latex,
}

/// Which stores causality assigns first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PreferOption {
    /// Stores become states.
    Integral,
    /// Stores follow.
    Derivative,
}

/// Methods of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MethodOption {
    /// DOP853, order 8.
    Explicit,
    /// Radau IIA, order 5.
    Implicit,
}

/// Texts for other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExportOption {
    /// One flat Modelica model.
    Modelica,
    /// GraphML.
    Graphml,
    /// Equations and causality as JSON.
    Json,
    /// A graph file.
    Graph,
}
