//! The command line of `lanchester counterweight`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use clap::{Args, Subcommand, ValueEnum};
use lanchester::geometry::Objective;
use std::path::PathBuf;

/// `counterweight`
#[derive(Debug, Args)]
pub struct CounterweightArguments {
    /// What to do.
    #[command(subcommand)]
    pub command: CounterweightCommand,
}

/// What can be done with counterweights. One is made in the life of the program: its size does not matter.
#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant)]
pub enum CounterweightCommand {
    /// The best shape for every counterweight, and for every weight of a balance shaft, with the proof that none is better.
    #[command(
        after_help = "Examples:\n  lanchester counterweight design three.toml\n  lanchester counterweight design three.toml --write\n  \
                            lanchester counterweight design three.toml --minimise 'swept radius' --limit 'mass = 2 kg'\n  \
                            lanchester counterweight design three.toml --weight 'web 1' --dimension 'thickness = 15 mm .. 25 mm'\n  \
                            lanchester counterweight design three.toml --figures figures\n  \
                            lanchester counterweight design lanchester.toml --weight 'with the crank' --write\n\n\
                            Counterweights need the section [counterweight_design] or the options, weights of balance shafts \
                            the section [shaft_weight_design]. A weight of a shaft with a shape and no `unbalance` beside it stays as it is.\n\n\
                            Exit status 1: no shape of the ranges meets all limits; the nearest values that can be met are printed."
    )]
    Design(DesignArguments),
    /// The whole trade between two objectives, such as mass and swept radius; every point is a complete design.
    #[command(
        after_help = "Examples:\n  lanchester counterweight front three.toml\n  lanchester counterweight front three.toml --minimise mass --against inertia --designs 50\n  \
                            lanchester counterweight front three.toml --figures figures --format csv > front.csv\n  \
                            lanchester counterweight front three.toml --adopt 12 --write\n\n\
                            Exit status 1: no shape of the ranges meets all limits."
    )]
    Front(FrontArguments),
    /// Crankshaft, counterweights and weights of balance shafts as they stand in the file: mass, unbalance, inertia, clearance to case,
    /// pistons, liners and rods, and swept circles of shafts that overlap.
    #[command(
        after_help = "Examples:\n  lanchester counterweight check three.toml\n  lanchester counterweight check three.toml --figures figures\n  \
                            lanchester counterweight check three.toml --format csv --table clearances\n\n\
                            Exit status 1: a clearance is less than the file wants, or a weight misses its unbalance by more than 1 %. \
                            Overlapping swept circles are a warning: phases may keep the weights apart."
    )]
    Check(CounterweightCheckArguments),
    /// Counterweights, the whole crankshaft and the balance shafts as STEP, STL or glTF; the outline of one counterweight as DXF or SVG.
    #[command(
        after_help = "Examples:\n  lanchester counterweight export three.toml --output crankshaft.step\n  \
                            lanchester counterweight export three.toml --output web.dxf --weight 'web 1'\n  \
                            lanchester counterweight export three.toml --output crankshaft.glb --facet '0.05 mm'\n  \
                            lanchester counterweight export lanchester.toml --output shaft.step --shaft 'with the crank'"
    )]
    Export(ExportArguments),
    /// Take the outline of a counterweight from a DXF or SVG drawing.
    #[command(
        after_help = "Examples:\n  lanchester counterweight import three.toml web.dxf --weight 'web 1' --thickness '20 mm' --dry-run\n  \
                            lanchester counterweight import three.toml web.dxf --weight 'web 1' --encloses web --leave-out CENTRE --write\n\n\
                            The origin of the drawing is the crank axis, and its x points away from the crankpin."
    )]
    Import(ImportArguments),
}

/// Which weights, and among which shapes.
#[derive(Debug, Args)]
pub struct ShapeArguments {
    /// Engine file; `-` reads standard input. Its section [counterweight_design] says among which shapes.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Name of a counterweight, such as `web 1`. May be given several times; default: every one on a web, but for outlines of
    /// your own. `design` takes names of balance shafts and of their weights too, such as `left weight 2`.
    #[arg(long, value_name = "NAME")]
    pub weight: Vec<String>,
    /// Unbalance that is full balance, for all of them; default: what each of them should have by the file.
    #[arg(long, value_name = "UNBALANCE")]
    pub unbalance: Option<String>,
    /// What is made as small as possible; default: as the file says, or mass.
    #[arg(long, alias = "minimize", value_name = "OBJECTIVE", value_enum)]
    pub minimise: Option<ObjectiveArgument>,
    /// Least and perhaps largest part of full balance: `95 %` or `95 % .. 105 %`.
    #[arg(long, value_name = "SHARE")]
    pub balance: Option<String>,
    /// A dimension or its range, in place of the file's: `web radius`, `rectangle height`, `shoulder height`, `shoulder angle`,
    /// `arc radius`, `arc angle` or `thickness`, as `arc radius = 70 mm .. 90 mm`. May be given several times.
    #[arg(long, value_name = "DIMENSION")]
    pub dimension: Vec<String>,
    /// A limit, in place of the file's: `mass = 2 kg`, `swept radius`, `inertia`, `half width`, or a range of `shoulder angle` or
    /// `shoulder height` that follows from the dimensions. May be given several times.
    #[arg(long, value_name = "LIMIT")]
    pub limit: Vec<String>,
    /// Density, in place of the file's: `7850 kg/m3`.
    #[arg(long, value_name = "DENSITY")]
    pub density: Option<String>,
    /// The proof ends where no shape can be better by more than this share of the value: `1e-6` to `50 %`. Default: 1e-6.
    #[arg(long, value_name = "SHARE")]
    pub gap: Option<String>,
    /// Most boxes of shapes that the proof of one optimum examines; then the best so far is printed as not proved. Default: 200000.
    #[arg(long, value_name = "N")]
    pub max_boxes: Option<usize>,
}

impl ShapeArguments {
    /// Whether any option says something of shapes or duties.
    pub fn has_options(&self) -> bool {
        let ShapeArguments {
            unbalance, minimise, balance, dimension, limit, density, gap, max_boxes, ..
        } = self;
        unbalance.is_some()
            || minimise.is_some()
            || balance.is_some()
            || density.is_some()
            || gap.is_some()
            || max_boxes.is_some()
            || !(dimension.is_empty() && limit.is_empty())
    }
}

/// `counterweight design`
#[derive(Debug, Args)]
pub struct DesignArguments {
    /// Which weights and shapes.
    #[command(flatten)]
    pub shape: ShapeArguments,
    /// How the shapes are found. The evolutionary search of the tool paper (Applied Sciences 2021, 11, 8997) is set beside the proved
    /// optimum.
    #[arg(long, value_enum, default_value_t = DesignMethod::Proof)]
    pub method: DesignMethod,
    /// With `--method evolution`: where its random numbers begin; default 1.
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// With `--method evolution`: how many designs it looks at; default 20000.
    #[arg(long, value_name = "N")]
    pub evaluations: Option<usize>,
    /// Write the shapes into the engine file; comments and order stay.
    #[arg(long, conflicts_with = "dry_run")]
    pub write: bool,
    /// Show what --write would change.
    #[arg(long)]
    pub dry_run: bool,
    /// Write dimensioned drawings as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// How shapes are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DesignMethod {
    /// The true optimum, with its proof.
    Proof,
    /// An evolutionary search beside it; the optimum is what is drawn and written.
    Evolution,
}

/// `counterweight front`
#[derive(Debug, Args)]
pub struct FrontArguments {
    /// Which weights and shapes.
    #[command(flatten)]
    pub shape: ShapeArguments,
    /// The other objective.
    #[arg(long, value_name = "OBJECTIVE", value_enum, default_value_t = ObjectiveArgument::SweptRadius)]
    pub against: ObjectiveArgument,
    /// Number of designs, evenly spread over the other objective.
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub designs: usize,
    /// Take this design of the front for the weights: draw it, and write it with --write.
    #[arg(long, value_name = "NUMBER")]
    pub adopt: Option<usize>,
    /// Write the adopted design into the engine file; comments and order stay.
    #[arg(long, requires = "adopt", conflicts_with = "dry_run")]
    pub write: bool,
    /// Show what --write would change.
    #[arg(long, requires = "adopt")]
    pub dry_run: bool,
    /// Write the front, and the drawing of the adopted design, as SVG files into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// What is made small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ObjectiveArgument {
    /// Mass of the counterweight.
    Mass,
    /// Swept radius of web and counterweight.
    #[value(name = "swept radius", alias = "swept-radius")]
    SweptRadius,
    /// Polar inertia about the crank axis.
    Inertia,
    /// Thickness.
    Thickness,
}

impl From<ObjectiveArgument> for Objective {
    fn from(argument: ObjectiveArgument) -> Objective {
        match argument {
            ObjectiveArgument::Mass => Objective::Mass,
            ObjectiveArgument::SweptRadius => Objective::SweptRadius,
            ObjectiveArgument::Inertia => Objective::Inertia,
            ObjectiveArgument::Thickness => Objective::Thickness,
        }
    }
}

/// `counterweight check`
#[derive(Debug, Args)]
pub struct CounterweightCheckArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Write drawings of the counterweights and of the weights of balance shafts, and the clearances over the crank angle, as SVG files into this
    /// folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Table written with `--format csv`; default: counterweights.
    #[arg(long, value_enum)]
    pub table: Option<CheckTable>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// Tables of `counterweight check --format csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CheckTable {
    /// Every counterweight: unbalance wanted and had, mass, swept radius.
    Counterweights,
    /// Every weight of a balance shaft: unbalance wanted and had, mass, inertia, radius.
    ShaftWeights,
    /// Every journal, pin and web with its mass and polar inertia.
    Sections,
    /// Every counterweight against every obstacle.
    Clearances,
}

/// `counterweight export`
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// File to write; its ending says what it is: step, stl, glb, dxf or svg.
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,
    /// Only this counterweight. May be given several times for STEP, STL and glTF; default: the crankshaft with all of them, or
    /// without [crank.body] all of them, and with crankshaft 1 the balance shafts whose weights have shapes.
    #[arg(long, value_name = "NAME")]
    pub weight: Vec<String>,
    /// Only this balance shaft, where it stands in the engine. May be given several times.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["weight", "crankshaft"])]
    pub shaft: Vec<String>,
    /// Number of the crankshaft, where there are several.
    #[arg(long, value_name = "NUMBER", default_value_t = 1, conflicts_with = "weight")]
    pub crankshaft: usize,
    /// Largest distance between a true arc and its facets, for STL and glTF alone; default 0.01 mm.
    #[arg(long, value_name = "LENGTH")]
    pub facet: Option<String>,
}

/// `counterweight import`
#[derive(Debug, Args)]
pub struct ImportArguments {
    /// Engine file; `-` reads standard input.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Drawing, DXF or SVG.
    #[arg(value_name = "DRAWING")]
    pub drawing: PathBuf,
    /// Name of the counterweight that gets the outline.
    #[arg(long, value_name = "NAME")]
    pub weight: String,
    /// Its thickness; default: that of its present shape, or of the webs in [crank.body].
    #[arg(long, value_name = "LENGTH")]
    pub thickness: Option<String>,
    /// Its density; default: that of its present shape, or of [crank.body].
    #[arg(long, value_name = "DENSITY")]
    pub density: Option<String>,
    /// What the outline encloses.
    #[arg(long, value_enum, default_value_t = Encloses::Counterweight)]
    pub encloses: Encloses,
    /// Unit of the drawing, where it does not say it: mm, cm, m, in.
    #[arg(long, value_name = "UNIT")]
    pub unit: Option<String>,
    /// Ends of lines and arcs that lie at most this far apart are joined.
    #[arg(long, value_name = "LENGTH", default_value = "0.001 mm")]
    pub gap: String,
    /// Layer of the drawing that is left out, such as one of centre lines. May be given several times.
    #[arg(long, value_name = "LAYER")]
    pub leave_out: Vec<String>,
    /// Write the outline into the engine file; comments and order stay.
    #[arg(long, conflicts_with = "dry_run")]
    pub write: bool,
    /// Show what --write would change.
    #[arg(long)]
    pub dry_run: bool,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// What an outline encloses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Encloses {
    /// The counterweight alone.
    Counterweight,
    /// The whole web with its counterweight.
    Web,
}
