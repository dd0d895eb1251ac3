//! Values as the file writes them: its own units, no more digits than they need.

use super::entry::{Entry, quoted_like};
use super::splice::Splices;
use crate::expanded::quoted;
use lanchester_model::angle;
use lanchester_numerics::about_zero;
use lanchester_units::{Dimension, parse, rewritten};
use std::f64::consts::TAU;
use toml_spanner::Item;

/// What a written value may miss of its own size: a sum of many of them stays true to 1e-9.
const RELATIVE: f64 = 1e-11;
/// What a written place [m] may miss near zero.
const PLACE: f64 = 1e-13;
/// What a written direction [rad] may miss.
const DIRECTION: f64 = 1e-11;

pub(super) fn same_amount(a: f64, b: f64) -> bool {
    (a - b).abs() <= RELATIVE * b.abs()
}

pub(super) fn same_place(a: f64, b: f64) -> bool {
    (a - b).abs() <= (RELATIVE * b.abs()).max(PLACE)
}

/// Whether two angles are one direction.
pub(super) fn same_direction(a: f64, b: f64) -> bool {
    turn_between(a, b).abs() <= DIRECTION
}

/// From one direction to another [rad], in [-pi, pi).
pub(super) fn turn_between(a: f64, b: f64) -> f64 {
    about_zero(a - b, TAU)
}

/// Units that the file uses.
pub(super) struct Units<'a> {
    root: &'a Item<'a>,
}

impl<'a> Units<'a> {
    pub(super) fn new(root: &'a Item<'a>) -> Units<'a> {
        Units { root }
    }

    /// A quantity of the file whose unit a new one takes: of the same key if there is one.
    fn sample(&self, key: &str, dimension: Dimension) -> &'a str {
        let is_one = |text: &str| parse(text, dimension, "").is_ok();
        let of_key = find(self.root, &|name, text| name == key && is_one(text));
        let any = || find(self.root, &|_, text| is_one(text));
        of_key.or_else(any).unwrap_or(match dimension {
            Dimension::Length => "0 mm",
            Dimension::Angle => "0 deg",
            Dimension::Mass => "0 kg",
            _ => "0 kg m",
        })
    }

    /// The value of a new key.
    pub(super) fn new_value(
        &self,
        key: &str,
        value: f64,
        dimension: Dimension,
        fits: impl Fn(f64) -> bool,
    ) -> String {
        quoted(&rewritten(self.sample(key, dimension), value, dimension, fits).unwrap_or_default())
    }

    /// The value of a key, in its own unit if it is there.
    pub(super) fn value(
        &self,
        entry: Entry<'_>,
        key: &str,
        value: f64,
        dimension: Dimension,
        fits: impl Fn(f64) -> bool,
        splices: &Splices<'_>,
    ) -> String {
        let old = entry.get(key);
        match old.and_then(Item::as_str).and_then(|text| rewritten(text, value, dimension, &fits)) {
            Some(text) => quoted_like(old, &text, splices),
            None => self.new_value(key, value, dimension, fits),
        }
    }
}

/// The first text of the tree whose key and content are right.
fn find<'a>(item: &'a Item<'a>, is_right: &dyn Fn(&str, &str) -> bool) -> Option<&'a str> {
    let below = |name: &str, item: &'a Item<'a>| match item.as_str() {
        Some(text) => is_right(name, text).then_some(text),
        None => find(item, is_right),
    };
    match (item.as_table(), item.as_array()) {
        (Some(table), _) => table.iter().find_map(|(key, item)| below(key.name, item)),
        (_, Some(array)) => array.iter().find_map(|item| below("", item)),
        _ => None,
    }
}

/// The angle [rad] of this direction that is nearest to `reference`; round angles stay round.
pub(super) fn angle_near(direction: f64, reference: f64) -> f64 {
    // Of two that are half a turn away the smaller.
    let turns = ((reference - direction) / TAU - 0.5).ceil();
    if turns == 0.0 { direction } else { angle::snapped(direction + turns * TAU) }
}
