//! The inputs of a computation as numbers: what an engine's text and the changes of a table say, and what rounds to it.

use crate::source::{Change, Edit, NewValue};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Units that the files of `validation/` use, with their SI values; angles in degrees, as quantities have them.
const UNITS: [(&str, f64); 14] = [
    ("mm", 1e-3),
    ("m", 1.0),
    ("kg", 1.0),
    ("g", 1e-3),
    ("kg m", 1.0),
    ("kg mm", 1e-3),
    ("g mm", 1e-6),
    ("kg/m3", 1.0),
    ("rpm", PI / 30.0),
    ("rad/s", 1.0),
    ("deg", 1.0),
    ("rad", 1.0),
    ("kg m2", 1.0),
    ("kN/mm", 1e6),
];

/// Every quantity that stands between quotation marks in a text, and in the changes.
pub(crate) fn inputs(text: &str, changes: &[&Change]) -> Vec<f64> {
    let bare = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let quoted = bare.flat_map(|line| line.split(['"', '\'']).skip(1).step_by(2));
    let values = changes.iter().flat_map(|change| change.values());
    let written = values.filter_map(|value| match value {
        NewValue::Text(text) => Some(text.as_str()),
        _ => None,
    });
    quoted.chain(written).filter_map(quantity).collect()
}

fn quantity(text: &str) -> Option<f64> {
    let (number, unit) = text.trim().split_once(' ')?;
    let (_, factor) = UNITS.iter().find(|(name, _)| *name == unit.trim())?;
    Some(number.parse::<f64>().ok()? * factor)
}

/// Whether a result is one of the inputs, bit for bit but for the rounding of its unit.
pub(crate) fn is_input(result: f64, inputs: &[f64]) -> bool {
    result != 0.0 && inputs.iter().any(|input| (result - input).abs() <= 2.0 * f64::EPSILON * input.abs())
}

/// The corners of the box of values that round to the printed ones of these places.
///
/// Each corner is a further change; the last edit that gives a place counts. Nothing that is printed without a minus
/// sign rounds from below zero.
pub(crate) fn corners(
    edits: &[Edit],
    named: &BTreeMap<String, Change>,
    places: &[String],
) -> Result<Vec<Change>, String> {
    let mut corners = vec![Change::new()];
    for place in places {
        let given = edits.iter().rev().find_map(|edit| match edit {
            Edit::Named(name) => named.get(name)?.get(place),
            Edit::Written(change) => change.get(place),
        });
        let Some(NewValue::Text(text)) = given else { return Err(format!("{place:?} is given nowhere")) };
        let ends = ends(text).ok_or_else(|| format!("{text:?} is no quantity"))?;
        let with = |corner: &Change, end: &String| {
            let mut corner = corner.clone();
            corner.insert(place.clone(), NewValue::Text(end.clone()));
            corner
        };
        corners = corners
            .iter()
            .flat_map(|corner| ends.iter().map(|end| with(corner, end)).collect::<Vec<_>>())
            .collect();
    }
    Ok(corners)
}

/// The two ends of what rounds to a quantity.
fn ends(text: &str) -> Option<[String; 2]> {
    let (number, unit) = text.split_once(' ')?;
    let value: f64 = number.parse().ok()?;
    let decimals = number.split_once('.').map_or(0, |(_, digits)| digits.len());
    let half = 0.5 * 10f64.powi(-(decimals as i32));
    let low = if number.starts_with('-') { value - half } else { (value - half).max(0.0) };
    Some([low, value + half].map(|end| format!("{end:.*} {unit}", decimals + 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_of_a_text_and_of_changes_are_inputs() {
        let change = Change::from([("crank.pin_mass".to_string(), NewValue::Text("2.2 kg".to_string()))]);
        let found = inputs("radius = '45 mm' # not '46 mm'\nx = [\"30 deg\", \"2 kg\"]\nn = 3", &[&change]);
        assert_eq!(found, [0.045, 30.0, 2.0, 2.2]);
        assert!(is_input(0.045, &found) && is_input(45.0 * 1e-3, &found) && !is_input(0.0450001, &found));
        assert!(!is_input(0.0, &[0.0]), "nothing is left of many things");
    }

    #[test]
    fn corners_are_half_a_unit_of_the_last_digit_away() {
        let edit = |value: &str| {
            Edit::Written(Change::from([(
                "shape.shoulder angle".to_string(),
                NewValue::Text(value.to_string()),
            )]))
        };
        let places = ["shape.shoulder angle".to_string()];
        let texts = |edits: &[Edit]| -> Vec<String> {
            let corners = corners(edits, &BTreeMap::new(), &places).unwrap();
            let text = |value: &NewValue| match value {
                NewValue::Text(text) => text.clone(),
                _ => panic!("a text"),
            };
            corners.iter().flat_map(|corner| corner.values()).map(text).collect()
        };
        assert_eq!(texts(&[edit("9 rad"), edit("1.46 rad")]), ["1.455 rad", "1.465 rad"]);
        assert_eq!(texts(&[edit("0.00 rad")]), ["0.000 rad", "0.005 rad"]);
        assert!(corners(&[], &BTreeMap::new(), &places).is_err());
    }
}
