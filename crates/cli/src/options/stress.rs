//! Options of `lanchester stress`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;

/// `stress`
#[derive(Debug, Args)]
pub struct StressArguments {
    /// What to compute.
    #[command(subcommand)]
    pub command: StressCommand,
}

/// The commands of the flexible crankshaft. One is made in the life of the program: its size does not matter.
#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant)]
pub enum StressCommand {
    /// Stress in every fillet, on pins and journals, under the loads of gas, inertia and rotation, or under forces of your own.
    #[command(
        after_help = "Examples:\n  lanchester stress static four.toml\n  lanchester stress static four.toml --angle '7 deg' --speed '4000 rpm'\n  \
                            lanchester stress static four.toml --case 'unit radial'\n  \
                            lanchester stress static four.toml --force '1: -65 kN, 10.7 kN' --support clamped-ends\n  \
                            lanchester stress static four.toml --angle '7 deg' --support rings --ring-thickness '5 mm'\n  \
                            lanchester stress static four.toml --angle '380 deg' --size '20 mm' --fillet-elements 2 --support film --pin-pressure film\n  \
                            lanchester stress static four.toml --angle '7 deg' --size '20 mm' --fillet-elements 2 --submodel 2 --submodel-elements 4\n  \
                            lanchester stress static four.toml --size '6 mm' --fillet-elements 8 --format csv > fillets.csv\n  \
                            lanchester stress static four.toml --angle '7 deg' --speed '4000 rpm' --size '12 mm' --fillet-elements 4 --converge"
    )]
    Static(StaticArguments),
    /// Natural frequencies of the crankshaft at rest, their kinds and residuals.
    #[command(
        after_help = "Examples:\n  lanchester stress modes four.toml\n  lanchester stress modes four.toml -n 20 --support journals\n  \
                            lanchester stress modes four.toml --fillet-elements 2 --format csv > modes.csv"
    )]
    Modes(ModesArguments),
    /// Write the mesh with a case, or with modes, for other programs: CalculiX deck, VTU for ParaView, glTF, STL.
    #[command(
        after_help = "Examples:\n  lanchester stress export four.toml --force '1: -65 kN, 10.7 kN' --output case.inp\n  \
                            lanchester stress export four.toml --angle '7 deg' --output case.vtu\n  \
                            lanchester stress export four.toml --angle '7 deg' --output case.glb\n  \
                            lanchester stress export four.toml --angle '0 deg .. 720 deg by 10 deg' --speed '4000 rpm' --output cycle.pvd\n  \
                            lanchester stress export four.toml --modes 10 --output modes.vtu"
    )]
    Export(ExportArguments),
    /// Reduce the crankshaft to its bearing surfaces and a few modes: matrices for programs of multibody dynamics, with checks.
    #[command(
        after_help = "Examples:\n  lanchester stress reduce four.toml\n  lanchester stress reduce four.toml --modes 30 --output four.npz"
    )]
    Reduce(ReduceArguments),
    /// Safety of every fillet against fatigue over the cycle, by finite elements and Findley's criterion; exit status 1 where it is below --safety.
    #[command(
        after_help = "Examples:\n  lanchester stress fatigue four.toml\n  lanchester stress fatigue four.toml --speed '6000 rpm' --surface-factor 0.85 --safety 1.5\n  \
                            lanchester stress fatigue four.toml --size '14 mm' --fillet-elements 4 --format csv > fatigue.csv"
    )]
    Fatigue(FatigueArguments),
    /// The crankshaft turning in its bearings over the cycle, laws of the bearings side by side: stress of every fillet, orbits, least film, loads of the mains;
    /// exit status 1 where a limit fails or a run has no sound end.
    #[command(
        after_help = "Examples:\n  lanchester stress cycle four.toml\n  lanchester stress cycle four.toml --bearings rigid,film --speed '4000 rpm'\n  \
                            lanchester stress cycle four.toml --bearings film --free --modes 30 --figures pictures\n  \
                            lanchester stress cycle four.toml --bearings film --least-film '1 um' --safety 1.5\n  \
                            lanchester stress cycle four.toml --size '14 mm' --fillet-elements 4 --save curves.parquet\n\n\
                            Ctrl-C ends it with what has been computed; a second one ends the program."
    )]
    Cycle(CycleArguments),
    /// Strength by the formulas of IACS UR M53, throw by throw: fillets and oil bores with their safety; exit status 1 where it is below 1.15.
    #[command(
        after_help = "Examples:\n  lanchester stress rule four.toml\n  lanchester stress rule four.toml --speed '6000 rpm' --torsional-vibration '150 N m'\n  \
                            lanchester stress rule four.toml --without-torsion\n  lanchester stress rule four.toml --finite-elements\n  lanchester stress rule four.toml --torsional-vibration '90 N m, 110 N m, 130 N m, 140 N m' --format csv > rule.csv\n\n\
                            Formulas after UR M53, not compared with the printed rule. Every ratio is held to the range of the formulas."
    )]
    Rule(RuleArguments),
    /// Solve a CalculiX deck: C3D10, C3D15, C3D20, sets, materials, displacements, forces, static steps and natural modes.
    #[command(
        after_help = "Examples:\n  lanchester stress solve case.inp\n  lanchester stress solve case.inp --output case.vtu --format json\n\n\
                            Units of a deck: N, mm, tonne, s, MPa. A card that is not read is an error with its line."
    )]
    Solve(SolveArguments),
}

/// Which crankshaft, and how fine its mesh is.
#[derive(Debug, Clone, Args)]
pub struct MeshArguments {
    /// Engine file with [crank.body]; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Number of the crankshaft, from 1.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub crankshaft: usize,
    /// Size of the elements away from fillets, with its unit; default that of [crank.mesh], else 8 mm.
    #[arg(long, value_name = "LENGTH")]
    pub size: Option<String>,
    /// Elements across the 90 deg of a fillet, an even number; 2 are enough for frequencies, 6 or more for stress. Default that of [crank.mesh].
    #[arg(long, value_name = "N")]
    pub fillet_elements: Option<usize>,
    /// Most memory that matrix and factor may take, such as `4 GiB`.
    #[arg(long, value_name = "SIZE", default_value = "8 GiB")]
    pub memory: String,
    /// Factor in double precision from the start; by default in single precision with refinement to double (modes always in double).
    #[arg(long)]
    pub double: bool,
}

/// What holds the crankshaft.
#[derive(Debug, Clone, Args)]
pub struct SupportArguments {
    /// What holds the crankshaft; default: `journals`, for modes `free`.
    #[arg(long, value_enum)]
    pub support: Option<SupportOption>,
    /// With `--support springs`: stiffness per journal and direction, with its unit, such as `500 kN/mm`; along x and y of the block `500 kN/mm : 300 kN/mm`;
    /// one for each journal from the free end on parted by commas. A stiffness of 0 does not hold.
    #[arg(long, value_name = "STIFFNESS", required_if_eq("support", "springs"))]
    pub stiffness: Option<String>,
    /// With `--support rings`: thickness of the rings, with its unit; 5 mm unless given.
    #[arg(long, value_name = "LENGTH")]
    pub ring_thickness: Option<String>,
    /// With `--support rings`: Young's modulus of the rings, with its unit; 210 GPa unless given.
    #[arg(long, value_name = "MODULUS")]
    pub ring_modulus: Option<String>,
}

/// Reductions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ReductionOption {
    /// Modes of the free crankshaft.
    FreeInterface,
    /// Modes with all bearing surfaces and the flywheel's face held.
    CraigBampton,
}

/// Supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SupportOption {
    /// Both end faces clamped.
    ClampedEnds,
    /// The mean of each journal's surface fixed across the axis; the flywheel's end fixed along and about the axis.
    Journals,
    /// The same with a spring at each journal.
    Springs,
    /// A ring around each journal, fixed at its outside, and around each loaded pin, pressed there by the load: contact without friction, which opens
    /// where it would pull. For static cases alone.
    Rings,
    /// The oil films of the main bearings: each load rests in equilibrium with their pressure. For static cases alone.
    Film,
    /// None: loads balanced by the crankshaft's own inertia.
    Free,
}

/// What computes loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LoadsOption {
    /// The closed form, at constant speed.
    ClosedForm,
    /// The run that `simulate` makes of this file: the largest forces among its samples, or those at crank angles of its last period, each with the speed and the
    /// angular acceleration of its instant.
    Simulation,
}

/// How the force on a crankpin is spread over its surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PinPressureOption {
    /// With the cosine of the angle from the force, over the 180 deg that it presses.
    Cosine,
    /// Evenly over the same 180 deg.
    Uniform,
    /// As the oil films of the big ends press at that crank angle: with loads of the closed form.
    Film,
}

/// The loads.
#[derive(Debug, Clone, Args)]
pub struct LoadArguments {
    /// A static case of the file by its name: [[stress.case]], with its loads and support.
    #[arg(
        long,
        value_name = "NAME",
        conflicts_with_all = ["angle", "force", "speed", "support", "stiffness", "ring_thickness", "ring_modulus", "crankshaft"]
    )]
    pub case: Option<String>,
    /// Crank angle with its unit, a list of them or a range such as `0 deg .. 720 deg by 10 deg`; with `--force` the one at which springs with two stiffnesses hold. Default: angles of the largest radial, tangential and resultant force on each pin and firing top dead centres.
    #[arg(long, value_name = "ANGLES")]
    pub angle: Option<String>,
    /// Force on a pin instead, `PIN: RADIAL, TANGENTIAL` with units: radial positive away from the crank axis, tangential positive where it drives
    /// the crankshaft. May be given several times; all act at once.
    #[arg(long, value_name = "FORCE")]
    pub force: Vec<String>,
    /// Speed of crankshaft 1, with its unit; may be given several times. Default: lowest and highest speed of the file, with `--force` standstill, of a simulated run the
    /// one that it starts with.
    #[arg(long, value_name = "SPEED")]
    pub speed: Vec<String>,
    /// Leave out the gas of the file.
    #[arg(long)]
    pub inertia_only: bool,
    /// What computes the loads of gas and inertia.
    #[arg(long, value_enum, default_value_t = LoadsOption::ClosedForm, conflicts_with = "force")]
    pub loads: LoadsOption,
    /// How the force on a crankpin is spread over its surface.
    #[arg(long, value_enum, default_value_t = PinPressureOption::Cosine)]
    pub pin_pressure: PinPressureOption,
}

/// `stress static`
#[derive(Debug, Args)]
pub struct StaticArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// What holds it.
    #[command(flatten)]
    pub support: SupportArguments,
    /// What loads it.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Solve on three meshes, of the size asked for, of 1/1.4 and of half of it: every number with the band about what the three tend to. Without
    /// --fillet-elements they are as fine as 220 000 nodes allow.
    #[arg(long)]
    pub converge: bool,
    /// Mesh what lies between the main journals beside this throw again, with more elements across its fillets, and solve it with the displacements
    /// of the whole crankshaft on its cuts: the stress of fillets of a long crankshaft, whose whole mesh can have few of them.
    #[arg(long, value_name = "THROW", value_parser = clap::value_parser!(u32).range(1..))]
    pub submodel: Option<u32>,
    /// Elements across the fillets of the submodel, an even number above that of the whole; default 6, or 4 where 6 need more than 220 000 nodes, and two more than
    /// the whole where that has 6 and more.
    #[arg(long, value_name = "N", requires = "submodel", value_parser = clap::value_parser!(u32).range(2..=40))]
    pub submodel_elements: Option<u32>,
    /// Least static safety that is wanted: yield strength over the largest stress of all fillets and cases; exit status 1 below it.
    #[arg(long, value_name = "NUMBER")]
    pub safety: Option<f64>,
    /// Write pictures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output; CSV is every fillet under every case.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `stress modes`
#[derive(Debug, Args)]
pub struct ModesArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// What holds it.
    #[command(flatten)]
    pub support: SupportArguments,
    /// How many modes, beyond those of a rigid body.
    #[arg(short = 'n', long = "number", value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=500))]
    pub number: u32,
    /// Solve on three meshes, of the size asked for, of 1/1.4 and of half of it: every frequency with the band about what the three tend to. Without
    /// --fillet-elements they are as fine as 220 000 nodes allow.
    #[arg(long)]
    pub converge: bool,
    /// Count the modes by a second factor, which tells whether any is missing; exit status 1 where one is.
    #[arg(long, conflicts_with = "converge")]
    pub count: bool,
    /// Write pictures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `stress export`
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// What holds it.
    #[command(flatten)]
    pub support: SupportArguments,
    /// What loads it; of several cases the one with the largest fillet stress is written, into a `.pvd` all of them.
    #[command(flatten)]
    pub load: LoadArguments,
    /// Modes instead of a static case: how many.
    #[arg(
        long,
        value_name = "N",
        conflicts_with_all = ["case", "angle", "force", "speed", "inertia_only", "loads", "pin_pressure"],
        value_parser = clap::value_parser!(u32).range(1..=500)
    )]
    pub modes: Option<u32>,
    /// By how much displacements are shown in `.glb` (a round number unless given) and `.stl` (0 unless given).
    #[arg(long, value_name = "FACTOR")]
    pub deformation: Option<f64>,
    /// File to write: `.inp` (CalculiX; N, mm, tonne, s, MPa), `.vtu` (ParaView; SI), `.pvd` (ParaView: all load cases, each in a `.vtu` of its own
    /// beside it, over the crank angle in degrees), `.glb` (viewers: stress as colours, deformation and modes as animated morph targets; m) or `.stl`
    /// (surface alone; mm).
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
}

/// `stress reduce`
#[derive(Debug, Args)]
pub struct ReduceArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// Modes kept with all bearing surfaces fixed.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(0..=500))]
    pub modes: u32,
    /// File to write: `.npz`, which NumPy reads.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// What lowers the fatigue limits of polished specimens.
#[derive(Debug, Args)]
pub struct FactorArguments {
    /// Factor of the surface's finish on the fatigue limits of polished specimens.
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    pub surface_factor: f64,
    /// Factor of the body's size on them.
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    pub size_factor: f64,
    /// Factor of the stress gradient on them.
    #[arg(long, value_name = "FACTOR", default_value = "1")]
    pub gradient_factor: f64,
}

/// `stress fatigue`
#[derive(Debug, Args)]
pub struct FatigueArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// What holds it.
    #[command(flatten)]
    pub support: SupportArguments,
    /// Speed of crankshaft 1, with its unit; may be given several times. Default: lowest and highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Vec<String>,
    /// Leave out the gas of the file.
    #[arg(long)]
    pub inertia_only: bool,
    /// Instants of a revolution.
    #[arg(long, value_name = "N", default_value_t = 72, value_parser = clap::value_parser!(u32).range(8..=1440))]
    pub instants: u32,
    /// What lowers the fatigue limits.
    #[command(flatten)]
    pub factors: FactorArguments,
    /// Least safety that is wanted, of all stress and of its amplitude.
    #[arg(long, value_name = "SAFETY", default_value = "1")]
    pub safety: f64,
    /// Form of the output; CSV has one line for each fillet and speed.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `stress cycle`
#[derive(Debug, Args)]
pub struct CycleArguments {
    /// Which crankshaft, and how fine its mesh is.
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// Laws of the bearings, side by side.
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = [LawOption::Rigid, LawOption::Contact, LawOption::Bushing, LawOption::Film])]
    pub bearings: Vec<LawOption>,
    /// Let films feel how the journals tilt in them: Guembel's films, solved at every instant, some ten times the time of a run in films.
    #[arg(long)]
    pub tilt: bool,
    /// Run every law with a rigid crankshaft too.
    #[arg(long)]
    pub rigid_crankshaft: bool,
    /// Mean speed of crankshaft 1, with its unit. Default: the highest speed of the file.
    #[arg(long, value_name = "SPEED")]
    pub speed: Option<String>,
    /// Let the flywheel turn as gas, inertia and a constant load make it, instead of at constant speed. Needs the inertia of the flywheel.
    #[arg(long)]
    pub free: bool,
    /// Leave out the gas of the file.
    #[arg(long)]
    pub inertia_only: bool,
    /// Natural modes of the crankshaft that are kept, beside the static shapes of all bearings.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=200))]
    pub modes: u32,
    /// Which modes these are: two reductions of one crankshaft, whose answers tell whether the modes are enough.
    #[arg(long, value_enum, default_value_t = ReductionOption::FreeInterface)]
    pub reduction: ReductionOption,
    /// Damping of every mode over the critical one; default: what the crankshaft's material says, else 0.01.
    #[arg(long, value_name = "SHARE")]
    pub damping: Option<f64>,
    /// Instants of a revolution, a multiple of 8.
    #[arg(long, value_name = "N", default_value_t = 360, value_parser = clap::value_parser!(u32).range(32..=3600))]
    pub instants: u32,
    /// Most cycles of a law; where they do not repeat by then, five more give an envelope.
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(2..=1000))]
    pub cycles: u32,
    /// Least static safety that is wanted: yield strength over the largest stress of all laws.
    #[arg(long, value_name = "SAFETY")]
    pub safety: Option<f64>,
    /// Least safety against fatigue that is wanted, of all stress and of its amplitude, with every law.
    #[arg(long, value_name = "SAFETY")]
    pub fatigue_safety: Option<f64>,
    /// What lowers the fatigue limits.
    #[command(flatten)]
    pub factors: FactorArguments,
    /// Least film that is wanted, with its unit.
    #[arg(long, value_name = "LENGTH")]
    pub least_film: Option<String>,
    /// Write all curves over the crank angle into this table, `.parquet` or `.csv`; never overwrites.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// Write pictures as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output; CSV is the peak of every fillet and bearing by law.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// Laws of bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LawOption {
    /// No clearance and no yield.
    Rigid,
    /// Clearance, then a spring with a damper.
    Contact,
    /// Springs with dampers about the middle.
    Bushing,
    /// An oil film.
    Film,
    /// Each bearing as the file says; a film where it says nothing.
    File,
}

/// `stress rule`
#[derive(Debug, Args)]
pub struct RuleArguments {
    /// Engine file with [crank.body], fillets and [crank.material]; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Number of the crankshaft, from 1.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub crankshaft: usize,
    /// Speed of crankshaft 1, with its unit; may be given several times. Default: lowest and highest speed of the file, and between them that of the
    /// largest torque by torsional vibration.
    #[arg(long, value_name = "SPEED")]
    pub speed: Vec<String>,
    /// Amplitude of the torque that torsional vibration adds to that of a rigid crankshaft: one for all throws, or one for each from the free
    /// end on, parted by commas. Default: that of the engine's own chain, as `torsion` has it.
    #[arg(long, value_name = "TORQUE")]
    pub torsional_vibration: Option<String>,
    /// Refuse a file without the data of `torsion`, whose chain gives the torsional vibration at each speed; by default the sheet then leaves it out and says so.
    #[arg(long, conflicts_with = "torsional_vibration")]
    pub with_torsion: bool,
    /// Leave torsional vibration out.
    #[arg(long, conflicts_with_all = ["torsional_vibration", "with_torsion"])]
    pub without_torsion: bool,
    /// Stress concentration factors by finite elements beside those of the formulas: each throw that is not like another meshed and solved, about a minute and 4 to 6 GiB each.
    #[arg(long)]
    pub finite_elements: bool,
    /// With --finite-elements: size of the elements away from fillets, with its unit; default that of [crank.mesh], else 8 mm.
    #[arg(long, value_name = "LENGTH", requires = "finite_elements")]
    pub size: Option<String>,
    /// With --finite-elements: elements across the 90 deg of a fillet, an even number from 6 on.
    #[arg(long, value_name = "N", requires = "finite_elements")]
    pub fillet_elements: Option<usize>,
    /// With --finite-elements: most memory that matrix and factor may take, such as `4 GiB`; default 8 GiB.
    #[arg(long, value_name = "SIZE", requires = "finite_elements")]
    pub memory: Option<String>,
    /// Leave out the gas of the file.
    #[arg(long)]
    pub inertia_only: bool,
    /// Form of the output; CSV has one line for each place and speed.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// `stress solve`
#[derive(Debug, Args)]
pub struct SolveArguments {
    /// Deck to solve; `-` reads standard input.
    #[arg(value_name = "DECK")]
    pub file: PathBuf,
    /// Most memory that matrix and factor may take, such as `4 GiB`.
    #[arg(long, value_name = "SIZE", default_value = "8 GiB")]
    pub memory: String,
    /// Factor in double precision from the start.
    #[arg(long)]
    pub double: bool,
    /// Integrate the mass with the rule of the stiffness, as CalculiX does.
    #[arg(long)]
    pub calculix_mass: bool,
    /// Write displacements, stresses and modes into this file: `.vtu` (ParaView; SI).
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}
