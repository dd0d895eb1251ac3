//! What is free in a search over layouts, and what it has where nothing is chosen.

use lanchester_model::{Engine, Strokes, greatest_common_divisor};
use lanchester_study::explore::{CounterweightPattern, ShaftSet};

/// Fewest angles of a throw that are looked at unless others are given.
const ANGLES: u32 = 12;

/// What is free in a search, and sizes that the engine file does not give; `None` is as the engine has it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LayoutChoices {
    /// Speed of the crankshaft [rad/s]; `None`: the highest of the engine.
    pub speed: Option<f64>,
    /// Number of cylinders.
    pub cylinders: Option<usize>,
    /// One bank, whatever the engine has.
    pub in_line: bool,
    /// Angles between two banks [rad].
    pub bank_angles: Option<Vec<f64>>,
    /// How far the pin of bank 2 stands ahead of that of bank 1 [rad].
    pub split_angles: Option<Vec<f64>>,
    /// How far bank 2 stands behind bank 1 [m].
    pub staggers: Option<Vec<f64>>,
    /// Distances of neighbouring groups [m].
    pub spacings: Option<Vec<f64>>,
    /// Crank radius over rod length.
    pub rod_ratios: Option<Vec<f64>>,
    /// Angles of the throws [rad]; `None`: equal parts of a turn, 12 or the next number that holds the even firing intervals, and
    /// where cylinders stay where they are those of the engine.
    pub throw_angles: Option<Vec<f64>>,
    /// Weights on the webs; `None`: [`own_pattern`].
    pub counterweights: Option<Vec<CounterweightPattern>>,
    /// Balance shafts; `None`: none.
    pub shafts: Option<Vec<ShaftSet>>,
    /// Leave the firing orders out.
    pub without_firing: bool,
    /// Distance of the outer web planes of a group [m].
    pub web_distance: Option<f64>,
    /// Thickness of a web [m].
    pub web_thickness: Option<f64>,
    /// Diameter of a crankpin [m].
    pub pin_diameter: Option<f64>,
    /// What the engine is longer than the distance of its outermost cylinder axes [m]; `None`: one bore.
    pub end_length: Option<f64>,
}

/// No balance shaft.
pub(super) fn none() -> ShaftSet {
    ShaftSet { name: "none".to_owned(), shafts: Vec::new() }
}

/// Weights on all webs alike, together as much as the engine has: first for what turns, then for the reciprocating masses.
pub fn own_pattern(engine: &Engine) -> CounterweightPattern {
    let has: f64 = engine.counterweights.iter().map(|weight| weight.unbalance).sum();
    let turning: f64 = (0..engine.throws.len()).map(|throw| engine.rotating_unbalance(throw)).sum();
    let reciprocating: f64 =
        engine.cylinders.iter().map(|c| c.reciprocating_mass() * engine.throws[c.throw].radius).sum();
    let share = |part: f64, whole: f64| if whole > 0.0 { (1e6 * part / whole).round() / 1e6 } else { 0.0 };
    let rotating = share(has.min(turning), turning);
    let reciprocating = share((has - turning).max(0.0), reciprocating);
    let name = if has > 0.0 { "as much as the file" } else { "none" };
    CounterweightPattern { name: name.to_owned(), rotating, reciprocating, webs: None }
}

/// Parts of a turn that hold every even firing interval: a multiple of the fewest, 12 or more.
pub(super) fn usual_angles(cylinders: usize, strokes: Strokes) -> u32 {
    let cylinders = (cylinders.clamp(1, 64)) as u32;
    let revolutions = strokes.revolutions();
    let fewest = cylinders / greatest_common_divisor(cylinders, revolutions);
    fewest * ANGLES.div_ceil(fewest)
}
