//! The command line of `lanchester explore`.

use crate::format::Format;
use crate::options::printed::PrintedArguments;
use crate::options::run::RunArguments;
use clap::Args;
use std::path::PathBuf;

/// `explore`
#[derive(Debug, Args)]
pub struct ExploreArguments {
    /// Engine file of whose parts the layouts are made; `-` reads standard input. An engine that is not one bank, or two alike, on one crankshaft (VR, W,
    /// radial, geared crankshafts) keeps its cylinders, rods and pins where they are: throw angles, firing orders, counterweights and shafts are searched.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What is free.
    #[command(flatten)]
    pub space: SpaceArguments,
    /// What layouts are judged by, less being better; may be repeated: `force order 1`, `couple order 2`, `forward couple
    /// order 1`, `roll moment order 2`, `inertia torque order 1`, `bending moment`, `main load`, `uneven firing`, `firing order
    /// 1.5`, `neighbours`, `length`, `height`, `counterweights`, `shafts`. Default: force and couple of orders 1 and 2, and the
    /// unevenness of firing unless it must be even.
    #[arg(long, value_name = "OBJECTIVE")]
    pub minimise: Vec<String>,
    /// What layouts must hold; may be repeated: an objective and its largest value, such as `length = 500 mm`.
    #[arg(long, value_name = "LIMIT")]
    pub limit: Vec<String>,
    /// Oil film or safety that layouts on the front and in the ranking must have at least; may be repeated: `main-bearing film = 2 um`, `least film = 1
    /// um`, `rule safety = 1.15`. Layouts have the bearings, oil, gas and sizes of the crankshaft of the file. Each costs tens of milliseconds and more, a
    /// million times the other limits: it is computed for those layouts alone that no other covers, and the counts of cases leave it out.
    #[arg(long, value_name = "LIMIT")]
    pub at_least: Vec<String>,
    /// Oil film or safety that is told of the layouts found, as many as `--rows`; may be repeated. Those of `--at-least` are told in any case.
    #[arg(long, value_name = "CRITERION")]
    pub durability: Vec<String>,
    /// Most layouts whose films and safeties are computed.
    #[arg(long = "max-measured", alias = "most-measured", value_name = "N", default_value_t = 10_000)]
    pub most_measured: u64,
    /// Only layouts that fire evenly, within this angle if one is given.
    #[arg(long, value_name = "TOLERANCE", num_args = 0..=1, default_missing_value = "0 deg", require_equals = true)]
    pub even_firing: Option<String>,
    /// Room for a main bearing between the facing webs of neighbouring throws, at least.
    #[arg(long, value_name = "LENGTH")]
    pub bearing_room: Option<String>,
    /// Overlap of the two pins of a pair seen along the crank, at least.
    #[arg(long, value_name = "LENGTH")]
    pub pin_overlap: Option<String>,
    /// Most cases that are looked at; a larger space is refused with the choice that makes it so large.
    #[arg(long = "max-cases", alias = "most-cases", value_name = "N", default_value_t = 1_000_000_000_000)]
    pub most_cases: u64,
    /// Most layouts on the front.
    #[arg(long = "max-on-front", alias = "most-on-front", value_name = "N", default_value_t = 100_000)]
    pub most_on_front: usize,
    /// Values of an objective that differ by less than this share of what all masses could do together are equal.
    #[arg(long, value_name = "SHARE", default_value_t = 1e-9)]
    pub resolution: f64,
    /// The table of judged cases.
    #[command(flatten)]
    pub run: RunArguments,
    /// Only the layouts of the front into the table.
    #[arg(long, requires = "save")]
    pub front_only: bool,
    /// Rows of the table in the text.
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub rows: usize,
    /// The ranking instead of the front: the first 20 kinds of layout, the first objective counting most.
    #[arg(long)]
    pub ranking: bool,
    /// Make an engine file of this layout of the front, by its number; with --ranking, of the ranking.
    #[arg(long, value_name = "N", requires = "output")]
    pub adopt: Option<usize>,
    /// The engine file of --adopt; never overwrites.
    #[arg(long, short, value_name = "FILE", requires = "adopt")]
    pub output: Option<PathBuf>,
    /// Draw the front as an SVG file into this folder.
    #[arg(long, value_name = "FOLDER")]
    pub figures: Option<PathBuf>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// How text and CSV are printed.
    #[command(flatten)]
    pub printed: PrintedArguments,
}

/// What is free in `explore`, and sizes that the file does not give. A list is `60 deg, 90 deg`, a range `60 deg .. 120 deg by 15
/// deg`, or both with commas between.
#[derive(Debug, Args)]
pub struct SpaceArguments {
    /// Number of cylinders; default: that of the engine.
    #[arg(long, value_name = "N", help_heading = "The space")]
    pub cylinders: Option<usize>,
    /// One bank, whatever the engine has.
    #[arg(long, help_heading = "The space")]
    pub in_line: bool,
    /// Angles between two banks: a list (`60 deg, 90 deg`), a range (`60 deg .. 120 deg by 15 deg`), or both with commas between,
    /// as for all that follow.
    #[arg(long, value_name = "ANGLES", help_heading = "The space")]
    pub bank_angle: Option<String>,
    /// How far the pin of bank 2 stands ahead of that of bank 1.
    #[arg(long, value_name = "ANGLES", help_heading = "The space")]
    pub split_angle: Option<String>,
    /// How far bank 2 stands behind bank 1 along the crank.
    #[arg(long, value_name = "LENGTHS", help_heading = "The space")]
    pub stagger: Option<String>,
    /// Distances of neighbouring throws (or pairs of them).
    #[arg(long, value_name = "LENGTHS", help_heading = "The space")]
    pub spacing: Option<String>,
    /// Crank radius over rod length.
    #[arg(long, value_name = "RATIOS", help_heading = "The space")]
    pub rod_ratio: Option<String>,
    /// Angles that a throw may have from the first one, in the sense in which its crankshaft turns: a list, or `every 30 deg`. Default: every 30 degrees, or
    /// as many parts of a turn as the even firing of so many cylinders needs; for cylinders that stay where they are also the angles of the file.
    #[arg(long, value_name = "ANGLES", help_heading = "The space")]
    pub throw_angles: Option<String>,
    /// Weights on the webs, several with commas between: `none`; `own`, as much as the file has on all webs alike; `full`, every
    /// throw in itself; `80 %` of what turns; `100 % + 50 %`, of what turns and of the reciprocating masses; `full on 1001`,
    /// a digit for each web. Default: own.
    #[arg(long, value_name = "PATTERNS", help_heading = "The space")]
    pub counterweights: Option<String>,
    /// Balance shafts that a layout may have, one set for each --shafts: `none`, or shafts with semicolons between, each
    /// `ORDER @ x, y @ force z` (or `couple z1, z2`, or `both z1, z2`): what its weights remove, and where they stand. ORDER is 1 or 2,
    /// negative against the crank. Default: none.
    #[arg(long, value_name = "SHAFTS", help_heading = "The space")]
    pub shafts: Vec<String>,
    /// Leave the firing orders out.
    #[arg(long, help_heading = "The space")]
    pub without_firing: bool,
    /// Speed of the crankshaft, with its unit; default: the highest of the file.
    #[arg(long, value_name = "SPEED", help_heading = "The space")]
    pub speed: Option<String>,
    /// Distance of the outer web planes of a throw (or pair).
    #[arg(long, value_name = "LENGTH", help_heading = "The space")]
    pub web_distance: Option<String>,
    /// Thickness of a web.
    #[arg(long, value_name = "LENGTH", help_heading = "The space")]
    pub web_thickness: Option<String>,
    /// Diameter of a crankpin.
    #[arg(long, value_name = "LENGTH", help_heading = "The space")]
    pub pin_diameter: Option<String>,
    /// What the engine is longer than the distance of its outermost cylinder axes; default: one bore.
    #[arg(long, value_name = "LENGTH", help_heading = "The space")]
    pub ends: Option<String>,
}
