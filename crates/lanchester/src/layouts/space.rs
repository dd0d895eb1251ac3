//! From an engine and what is left free of it to a space of layouts.

use crate::layouts::kept_cylinders::kept_cylinders;
use crate::layouts::own::OwnLayout;
use lanchester_model::{Engine, Strokes, greatest_common_divisor};
use lanchester_study::explore::{
    Banks, Constraint, CounterweightPattern, ExploreError, Parts, ShaftSet, Space, even_angles,
};
use std::fmt;

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

/// A space, and what the user should know of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LayoutSpace {
    /// The space.
    pub space: Space,
    /// Sizes that were assumed or averaged, in words.
    pub notes: Vec<String>,
}

/// Why an engine gives no space of layouts.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LayoutSpaceError {
    /// The engine is not one bank, or two alike, on one crankshaft, and its throws cannot be permuted as they are either.
    #[error(
        "a search permutes layouts of one bank, or of two alike, on one crankshaft, or the throws of other engines; {engine} has none \
         of them: {reason}"
    )]
    Banks {
        /// Name of the engine.
        engine: String,
        /// What it is instead.
        reason: String,
    },
    /// A choice of sizes that the layouts of this engine share.
    #[error(
        "layouts of {engine} keep its cylinders, rods and pins, since {reason}: {choice} cannot be chosen"
    )]
    Kept {
        /// Name of the engine.
        engine: String,
        /// Why they keep them.
        reason: String,
        /// The choice.
        choice: &'static str,
    },
    /// Nothing changes the loads of an engine whose throws turn as one.
    #[error("{throws}: nothing to permute; {engine} has the same loads in every firing order")]
    OneThrow {
        /// "one throw", or how several are one.
        throws: &'static str,
        /// Name of the engine.
        engine: String,
    },
    /// A size that the file does not give.
    #[error("{size} is not known from {engine}")]
    Missing {
        /// Which size.
        size: LayoutSize,
        /// Name of the engine.
        engine: String,
    },
    /// One bank is asked for, and with it what only two banks have.
    #[error("an in-line engine has no bank angle, split pins or stagger")]
    InLineWithBanks,
    /// Split pins or a stagger of an engine with one bank.
    #[error("split pins and stagger need two banks, and the engine has one")]
    OneBank,
    /// The search is refused.
    #[error(transparent)]
    Explore(#[from] ExploreError),
}

/// A size without which a search cannot begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayoutSize {
    /// Distance of neighbouring cylinders along the crank.
    Spacing,
    /// Distance of the outer web planes of a group.
    WebDistance,
    /// Thickness of a web.
    WebThickness,
    /// Diameter of a crankpin.
    PinDiameter,
}

impl fmt::Display for LayoutSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LayoutSize::Spacing => "the distance of neighbouring cylinders",
            LayoutSize::WebDistance => "the distance of the webs",
            LayoutSize::WebThickness => "the thickness of the webs",
            LayoutSize::PinDiameter => "the diameter of the crankpins",
        })
    }
}

/// The space of layouts made of the parts of `engine`.
///
/// Layouts have equal, centred cylinders in equal groups; where parts of the engine differ their mean counts, which is
/// noted. An engine that is not one bank, or two alike, on one crankshaft keeps its cylinders, rods and pins where they are, unless one
/// bank or bank angles are chosen.
///
/// # Errors
/// [`LayoutSpaceError`] where something is missing. Whether the space has cases, and how many, its size tells.
///
/// # Example
/// ```
/// use lanchester::{LayoutChoices, layout_space};
/// let template = lanchester::file::template("in-line-4").expect("it is in the gallery");
/// let engine = lanchester::file::read(template.text).engine().expect("the gallery has no mistakes");
/// let found = layout_space(&engine, &LayoutChoices::default(), &[])?;
/// // Three throws at twelve angles, and each of three cylinders fires in one of two revolutions.
/// assert_eq!(found.space.size(u128::MAX)?, 12 * 12 * 12 * 8);
/// # Ok::<(), lanchester::LayoutSpaceError>(())
/// ```
pub fn layout_space(
    engine: &Engine,
    choices: &LayoutChoices,
    constraints: &[Constraint],
) -> Result<LayoutSpace, LayoutSpaceError> {
    let mut notes = Vec::new();
    let own = OwnLayout::of(engine);
    if let (Err(reason), None, false) = (&own, &choices.bank_angles, choices.in_line) {
        return kept_cylinders(engine, choices, reason);
    }
    let banks = banks(choices, &own)?;
    let cylinders = choices.cylinders.unwrap_or(engine.cylinders.len());
    let counted = match banks {
        Banks::InLine | Banks::AsGiven(_) => 1,
        Banks::Two { .. } => 2,
    };
    let own = own.ok();
    let missing = |size| LayoutSpaceError::Missing { size, engine: engine.name.clone() };
    let groups = (cylinders / counted).max(1);
    let own_spacing = own.as_ref().map(|own| own.spacing).filter(|spacing| *spacing > 0.0);
    let spacings = match (&choices.spacings, own_spacing) {
        (Some(spacings), _) => spacings.clone(),
        (None, Some(spacing)) => vec![spacing],
        // A single group has no neighbour: its mains stand half of this before and behind it.
        (None, None) if groups == 1 => {
            vec![own.as_ref().and_then(|own| own.web_distance).map_or(0.1, |d| 2.0 * d)]
        }
        (None, None) => return Err(missing(LayoutSize::Spacing)),
    };
    let parts = parts(engine, choices, own.as_ref(), &spacings, constraints, &mut notes)?;
    let strokes = engine.strokes;
    let counterweights = choices.counterweights.clone().unwrap_or_else(|| vec![own_pattern(engine)]);
    let space = Space {
        parts,
        cylinders,
        banks,
        throw_angles: choices
            .throw_angles
            .clone()
            .unwrap_or_else(|| even_angles(usual_angles(cylinders, strokes))),
        spacings,
        rod_ratios: choices.rod_ratios.clone().unwrap_or_else(|| {
            vec![parts.crank_radius / mean(engine.cylinders.iter().map(|c| c.rod.length))]
        }),
        counterweights,
        shafts: choices.shafts.clone().unwrap_or_else(|| vec![none()]),
        firing: !choices.without_firing,
    };
    Ok(LayoutSpace { space, notes })
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

fn banks(choices: &LayoutChoices, own: &Result<OwnLayout, String>) -> Result<Banks, LayoutSpaceError> {
    let pair = own.as_ref().ok().and_then(|own| own.banks);
    let of_two =
        choices.bank_angles.is_some() || choices.split_angles.is_some() || choices.staggers.is_some();
    if choices.in_line {
        if of_two {
            return Err(LayoutSpaceError::InLineWithBanks);
        }
        return Ok(Banks::InLine);
    }
    let bank_angles = match (&choices.bank_angles, pair) {
        (Some(angles), _) => angles.clone(),
        (None, Some(pair)) => vec![pair.bank_angle],
        (None, None) if of_two => return Err(LayoutSpaceError::OneBank),
        (None, None) => return Ok(Banks::InLine),
    };
    let or = |given: &Option<Vec<f64>>, own: Option<f64>| given.clone().unwrap_or(vec![own.unwrap_or(0.0)]);
    Ok(Banks::Two {
        bank_angles,
        split_angles: or(&choices.split_angles, pair.map(|pair| pair.split_angle)),
        staggers: or(&choices.staggers, pair.map(|pair| pair.stagger)),
    })
}

pub(super) fn parts(
    engine: &Engine,
    choices: &LayoutChoices,
    own: Option<&OwnLayout>,
    spacings: &[f64],
    constraints: &[Constraint],
    notes: &mut Vec<String>,
) -> Result<Parts, LayoutSpaceError> {
    let missing = |size| LayoutSpaceError::Missing { size, engine: engine.name.clone() };
    let needs_webs = constraints.iter().any(|c| matches!(c, Constraint::BearingRoom { .. }));
    let needs_pins = constraints.iter().any(|c| matches!(c, Constraint::PinOverlap { .. }));
    let narrowest = spacings.iter().copied().fold(f64::INFINITY, f64::min);
    let body = engine.crank_body.as_ref();
    let web_distance = match choices.web_distance.or(own.and_then(|own| own.web_distance)) {
        Some(distance) => distance,
        None if needs_webs => return Err(missing(LayoutSize::WebDistance)),
        None => {
            notes.push("webs stand half a spacing apart: the file does not say where they are".to_owned());
            0.5 * narrowest
        }
    };
    let web_thickness = match choices.web_thickness.or(body.map(|body| body.web_thickness)) {
        Some(thickness) => thickness,
        None if needs_webs => return Err(missing(LayoutSize::WebThickness)),
        None => 0.0,
    };
    let pin_diameter = match choices.pin_diameter.or(body.map(|body| body.pin_diameter)) {
        Some(diameter) => diameter,
        None if needs_pins => return Err(missing(LayoutSize::PinDiameter)),
        // Nothing else asks for it.
        None => narrowest,
    };
    let cylinders = &engine.cylinders;
    let known_bore = cylinders.iter().map(|c| c.bore).collect::<Option<Vec<f64>>>();
    let bore = known_bore.map(|bores| averaged("bores", bores.into_iter(), notes));
    if bore.is_none() {
        notes.push("whether neighbouring bores overlap is not checked: the file gives no bore".to_owned());
    }
    if cylinders.iter().any(|c| c.net_offset().abs() > 0.0) {
        notes.push("offsets of cylinders and piston pins are left out: layouts are centred".to_owned());
    }
    if cylinders.iter().any(|c| matches!(c.rod.joint, lanchester_model::RodJoint::Articulated { .. })) {
        notes.push("articulated rods are left out: every rod sits on a crankpin".to_owned());
    }
    let inertias = cylinders.iter().map(|c| c.rod.inertia).collect::<Option<Vec<f64>>>();
    let groups = own.map_or(engine.throws.len(), OwnLayout::groups);
    let unbalances = engine.throws.iter().map(|throw| throw.unbalance);
    let throw_unbalance =
        averaged("unbalances of the throws", unbalances, notes) * engine.throws.len() as f64 / groups as f64;
    Ok(Parts {
        strokes: engine.strokes,
        speed: choices.speed.unwrap_or(engine.speed.highest),
        crank_radius: averaged("crank radii", engine.throws.iter().map(|throw| throw.radius), notes),
        piston_mass: averaged("pistons", cylinders.iter().map(|c| c.piston_mass), notes),
        rod_big_end_mass: averaged(
            "masses at the big ends",
            cylinders.iter().map(|c| c.rod.big_end_mass),
            notes,
        ),
        rod_small_end_mass: averaged(
            "masses at the small ends",
            cylinders.iter().map(|c| c.rod.small_end_mass),
            notes,
        ),
        rod_inertia: inertias.map(|all| averaged("inertias of the rods", all.into_iter(), notes)),
        throw_unbalance,
        web_distance,
        web_thickness,
        pin_diameter,
        end_length: choices.end_length.or(bore).unwrap_or(0.0),
        // Without a bore no two of them overlap.
        bore: bore.unwrap_or(narrowest),
    })
}

/// The mean, noted where the values differ.
fn averaged(what: &str, values: impl Iterator<Item = f64> + Clone, notes: &mut Vec<String>) -> f64 {
    let mean = mean(values.clone());
    if values.clone().any(|value| (value - mean).abs() > 1e-9 * mean.abs()) {
        notes.push(format!("{what} differ in the file: layouts have their mean"));
    }
    mean
}

pub(super) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for value in values {
        sum += value;
        count += 1.0;
    }
    sum / f64::max(count, 1.0)
}
