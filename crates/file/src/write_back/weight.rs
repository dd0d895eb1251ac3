//! What weights on crankshafts and on shafts have in common when they are written.

use super::amount::{Units, same_amount, same_place};
use super::entry::Entry;
use super::splice::Splices;
use crate::expanded::{quantity, quoted};
use lanchester_units::{Dimension, parse, rewritten};

/// What a weight may differ from its part, relatively, in thicknesses and in radians: more is another weight.
pub(super) const PART: f64 = 1e-9;

/// For each part that is there the one that it becomes, by its name; of several of one name first those that are the
/// same already.
pub(super) fn matches<T>(
    there: &[T],
    wanted: &[T],
    same_name: impl Fn(&T, &T) -> bool,
    same: impl Fn(&T, &T) -> bool,
) -> Vec<Option<usize>> {
    let mut found: Vec<Option<usize>> = vec![None; there.len()];
    let mut is_taken = vec![false; wanted.len()];
    for must_be_same in [true, false] {
        for (part, found) in there.iter().zip(&mut found) {
            if found.is_some() {
                continue;
            }
            let is_match = |target: &usize| {
                let other = &wanted[*target];
                !is_taken[*target] && same_name(part, other) && (!must_be_same || same(part, other))
            };
            *found = (0..wanted.len()).find(is_match);
            if let Some(target) = *found {
                is_taken[target] = true;
            }
        }
    }
    found
}

/// Writes the shape of a part into the entry of a weight. The unbalance that the entry has stays as the wanted one, or becomes `wanted`;
/// `now` is what mass and radius say.
pub(super) fn set_shape(
    entry: Entry<'_>,
    now: f64,
    wanted: Option<f64>,
    shape: &str,
    place_key: &'static str,
    units: &Units<'_>,
    splices: &mut Splices<'_>,
) {
    let fits = |unbalance: f64| move |read: f64| same_amount(read, unbalance);
    if entry.has("mass") {
        let unbalance = wanted.unwrap_or(now);
        let value = units.new_value("unbalance", unbalance, Dimension::Unbalance, fits(unbalance));
        entry.exchange("mass", "unbalance", &value, splices);
        entry.unset("radius", splices);
    } else if let Some(wanted) = wanted {
        let old = entry.text("unbalance").and_then(|text| parse(text, Dimension::Unbalance, "").ok());
        if !old.is_some_and(|old| same_amount(old, wanted)) {
            let value = units.value(entry, "unbalance", wanted, Dimension::Unbalance, fits(wanted), splices);
            entry.set("unbalance", &value, &[place_key], splices);
        }
    }
    let behind = ["angle", "phase", "unbalance", "mass", place_key];
    if entry.has("shape") && !entry.has_inline("shape") {
        entry.unset_table("shape", splices);
        entry.add("shape", shape, &behind, splices);
    } else {
        entry.set("shape", shape, &behind, splices);
    }
}

/// A dimension of a shape as text; `exact`: to the last digit.
pub(super) fn dimension_text(value: f64, dimension: Dimension, exact: bool) -> String {
    let unit = match dimension {
        Dimension::Length => "0 mm",
        Dimension::Angle => "0 deg",
        Dimension::Density => "0 kg/m3",
        _ => return quantity(value, dimension),
    };
    let fits = |read: f64| if exact { read == value } else { same_place(read, value) };
    quoted(&rewritten(unit, value, dimension, fits).unwrap_or_default())
}

/// Sets the unbalance of a weight; mass and radius stay mass and radius if they can.
pub(super) fn set_unbalance(entry: Entry<'_>, unbalance: f64, units: &Units<'_>, splices: &mut Splices<'_>) {
    let fits = |read: f64| same_amount(read, unbalance);
    let radius = entry.text("radius").and_then(|text| parse(text, Dimension::Length, "").ok());
    match radius {
        Some(radius) if radius > 0.0 => {
            let fits = |mass: f64| same_amount(mass * radius, unbalance);
            let value = units.value(entry, "mass", unbalance / radius, Dimension::Mass, fits, splices);
            entry.set("mass", &value, &[], splices);
        }
        Some(_) => {
            // At the radius 0 no mass has any unbalance.
            let value = units.new_value("unbalance", unbalance, Dimension::Unbalance, fits);
            entry.exchange("mass", "unbalance", &value, splices);
            entry.unset("radius", splices);
        }
        None => {
            let value = units.value(entry, "unbalance", unbalance, Dimension::Unbalance, fits, splices);
            entry.set("unbalance", &value, &[], splices);
        }
    }
}
