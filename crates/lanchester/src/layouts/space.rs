//! From an engine and what is left free of it to a space of layouts.

use crate::layouts::choices::{LayoutChoices, none, own_pattern, usual_angles};
use crate::layouts::kept_cylinders::kept_cylinders;
use crate::layouts::layout_parts::{mean, parts};
use crate::layouts::own::OwnLayout;
use crate::layouts::space_error::{LayoutSize, LayoutSpaceError};
use lanchester_model::Engine;
use lanchester_study::explore::{Banks, Constraint, Space, even_angles};

/// A space, and what the user should know of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LayoutSpace {
    /// The space.
    pub space: Space,
    /// Sizes that were assumed or averaged, in words.
    pub notes: Vec<String>,
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
        let (space, notes) = kept_cylinders(engine, choices, reason)?;
        return Ok(LayoutSpace { space, notes });
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
