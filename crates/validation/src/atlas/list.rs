//! What `figures.json` of a source holds: every figure that it prints, and how ours is drawn.

use crate::files::Source;
use crate::source::{Edit, KinematicsName};
use lanchester_data::FILES;
use serde::{Deserialize, Serialize};

/// All figures of a source.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FigureList {
    /// Name of the source in the names of files.
    pub short: String,
    /// The figures in the order of the source.
    pub figures: Vec<FigureEntry>,
}

impl FigureList {
    /// That of a source, where it has one.
    pub fn of(source: &Source) -> Option<FigureList> {
        let path = format!("{}/figures.json", source.key);
        let (_, text) = FILES.iter().find(|(name, _)| *name == path)?;
        Some(serde_json::from_str(text).expect("invariant: a test reads every list of figures"))
    }
}

/// Whether ours is drawn, and why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FigureVerdict {
    /// Ours is drawn.
    Drawn,
    /// A command draws it that takes longer than all others together.
    OtherCommand,
    /// A photograph.
    Photo,
    /// A sketch, a drawing or a diagram without values.
    Sketch,
    /// A picture of another program.
    Screenshot,
}

impl FigureVerdict {
    /// All, in the order of the atlas.
    pub const ALL: [FigureVerdict; 5] = [
        FigureVerdict::Drawn,
        FigureVerdict::OtherCommand,
        FigureVerdict::Photo,
        FigureVerdict::Sketch,
        FigureVerdict::Screenshot,
    ];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            FigureVerdict::Drawn => "drawn",
            FigureVerdict::OtherCommand => "drawn by another command",
            FigureVerdict::Photo => "photograph: nothing to compute",
            FigureVerdict::Sketch => "sketch: nothing to compute",
            FigureVerdict::Screenshot => "picture of another program: nothing to compute",
        }
    }
}

/// One figure.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FigureEntry {
    /// Its number, as printed.
    pub figure: String,
    /// What it shows, in our words.
    pub title: String,
    pub verdict: FigureVerdict,
    /// What was chosen where the source does not say.
    #[serde(default)]
    pub chosen: Option<String>,
    /// Why it is not drawn, or what differs.
    #[serde(default)]
    pub remark: Option<String>,
    /// The command that draws it, for [`FigureVerdict::OtherCommand`].
    #[serde(default)]
    pub command: Option<String>,
    /// The source whose engines and tables it is drawn from, if not its own.
    #[serde(default)]
    pub from: Option<String>,
    #[serde(default)]
    pub draw: Vec<DrawEntry>,
    /// Numbers that the source prints of it.
    #[serde(default)]
    pub printed: Vec<PrintedEntry>,
}

/// A number of a table that belongs to a figure.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PrintedEntry {
    pub table: String,
    /// Section of the running text, where several name the quantity.
    #[serde(default)]
    pub section: Option<String>,
    pub quantity: String,
    #[serde(default)]
    pub column: Option<String>,
    /// The curve whose extreme it is.
    #[serde(default)]
    pub curve: Option<String>,
    /// Which extreme.
    #[serde(default)]
    pub extreme: ExtremeName,
}

/// An extreme of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ExtremeName {
    /// Of the absolute value.
    #[default]
    Largest,
    /// The amount of the lowest value.
    Lowest,
    /// Largest less smallest value.
    Range,
    /// The value at the first angle.
    First,
}

/// One drawing of a figure, or several.
#[derive(Deserialize)]
#[serde(tag = "panel", rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum DrawEntry {
    /// Curves over the crank angle.
    Angle(AngleEntry),
    /// Rows of a table over another row of it.
    Table(TableEntry),
    /// A row of a table as bars, one a column.
    Bars(BarsEntry),
    /// Forces or couples of the cylinders as arrows, one after another.
    Vectors(VectorsEntry),
    /// The largest load over the unbalance of the crank.
    Sweep { engine: Vec<Edit> },
    /// Power and torque over speed.
    Power { engine: Vec<Edit> },
    /// The engine from its side and its front.
    Engine { engine: Vec<Edit> },
    /// Curves of a run of the engine's bond graph.
    Run(RunEntry),
    /// The bond graph of an engine, or one of those to start from.
    Graph(GraphEntry),
}

/// Curves over the crank angle.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AngleEntry {
    pub engine: Vec<Edit>,
    pub quantity: String,
    pub unit: String,
    /// What the values are multiplied with, for a unit that takes no prefix.
    #[serde(default)]
    pub factor: Option<f64>,
    #[serde(default)]
    pub kinematics: Option<KinematicsName>,
    /// Degrees by which the curves are moved to the right, where the source counts from elsewhere.
    #[serde(default)]
    pub shift: u32,
    pub curves: Vec<CurveEntry>,
}

/// One of them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CurveEntry {
    pub name: String,
    pub key: String,
    /// Further changes of the engine.
    #[serde(default)]
    pub with: Vec<Edit>,
}

/// Rows of a table over another row of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableEntry {
    pub table: String,
    pub abscissa: String,
    pub ordinates: Vec<String>,
}

/// A row of a table as bars.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BarsEntry {
    /// What they are of, where several tables stand side by side.
    #[serde(default)]
    pub name: Option<String>,
    pub table: String,
    pub quantity: String,
    /// Only these columns.
    #[serde(default)]
    pub columns: Vec<String>,
    #[serde(default)]
    pub level: Option<LevelEntry>,
}

/// A level to compare bars with.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LevelEntry {
    pub name: String,
    pub table: String,
    pub quantity: String,
}

/// Arrows of the cylinders.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct VectorsEntry {
    pub engine: Vec<Edit>,
    pub quantity: String,
    pub unit: String,
    pub couple: bool,
    /// Whether of the rotating masses, not of the reciprocating ones.
    #[serde(default)]
    pub rotating: bool,
    pub order: f64,
}

/// A run of the engine's bond graph.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RunEntry {
    pub engine: String,
    /// Which of the figures of a run.
    pub figure: String,
    /// Initial speed [rpm].
    #[serde(default)]
    pub speed: Option<f64>,
    /// Duration [s].
    #[serde(default)]
    pub duration: Option<f64>,
    #[serde(default)]
    pub samples: Option<usize>,
    /// Whether the block stands still.
    #[serde(default)]
    pub fixed: bool,
    /// Whether sources hold the block and no weight acts.
    #[serde(default)]
    pub held: bool,
    #[serde(default)]
    pub imposed: bool,
    #[serde(default)]
    pub without_shafts: bool,
    /// Distance of the middle of the skirt's contacts from the pin [m], for compliant joints.
    #[serde(default)]
    pub skirt_offset: Option<f64>,
}

/// The drawing of a bond graph.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct GraphEntry {
    /// Name of an engine of the source.
    #[serde(default)]
    pub engine: Option<String>,
    /// Name of a graph to start from.
    #[serde(default)]
    pub graph: Option<String>,
}
