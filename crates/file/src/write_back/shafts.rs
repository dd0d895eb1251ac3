//! `[[shaft]]`.

use super::amount::{Units, angle_near, same_amount, same_direction, same_place};
use super::entry::{Entry, List, NewEntry, list_value};
use super::splice::Splices;
use super::weight::{PART, dimension_text, matches, set_shape, set_unbalance};
use crate::expanded::{quoted, ratio, shaft_shape};
use lanchester_model::ShaftWeightPart;
use lanchester_model::{BalanceShaft, Engine, ShaftWeight};
use lanchester_units::{Dimension, parse};

/// Writes the balance shafts.
pub(super) struct ShaftWriter<'a> {
    /// The engine of the file as it is.
    pub(super) engine: &'a Engine,
    /// z of its reference plane in the file [m].
    pub(super) origin: f64,
    pub(super) units: &'a Units<'a>,
    /// Whether dimensions of shapes are written to the last digit.
    pub(super) exact: bool,
}

/// Whether the weight stays as it is: a part is the same part, or the number that it has.
fn same_weight(a: &ShaftWeight, b: &ShaftWeight) -> bool {
    same_numbers(a, b) && (b.part.is_none() || a.part == b.part)
}

fn same_numbers(a: &ShaftWeight, b: &ShaftWeight) -> bool {
    same_place(a.z, b.z)
        && same_amount(a.unbalance, b.unbalance)
        && (same_direction(a.phase, b.phase) || b.unbalance == 0.0)
}

/// The part of a weight, if it is one of that amount: else the number counts.
fn part_of(weight: &ShaftWeight) -> Option<&ShaftWeightPart> {
    let part = weight.part.as_ref()?;
    ((part.unbalance() - weight.unbalance).abs() <= PART * weight.unbalance).then_some(part)
}

fn same(a: &BalanceShaft, b: &BalanceShaft) -> bool {
    a.ratio == b.ratio
        && same_place(a.x, b.x)
        && same_place(a.y, b.y)
        && a.weights.len() == b.weights.len()
        && a.weights.iter().zip(&b.weights).all(|(a, b)| same_weight(a, b))
}

impl ShaftWriter<'_> {
    /// The file's shafts become `wanted`.
    pub(super) fn write(&self, list: &List<'_>, wanted: &[BalanceShaft], splices: &mut Splices<'_>) {
        let there = &self.engine.shafts;
        let found = matches(there, wanted, |a, b| a.name == b.name, same);
        let mut number = 0;
        for (index, entry) in list.entries.iter().enumerate() {
            match found[index] {
                None => list.remove(index, splices),
                Some(target) => {
                    number += 1;
                    self.change(*entry, &there[index], &wanted[target], number, splices);
                }
            }
        }
        let new: Vec<NewEntry> = (0..wanted.len())
            .filter(|target| !found.contains(&Some(*target)))
            .map(|target| {
                self.new_shaft(&wanted[target], if list.is_inline() { "" } else { splices.line_end })
            })
            .collect();
        list.append("shaft", &new, splices);
    }

    fn change(
        &self,
        entry: Entry<'_>,
        now: &BalanceShaft,
        wanted: &BalanceShaft,
        number: usize,
        splices: &mut Splices<'_>,
    ) {
        if !entry.has("name") && format!("shaft {number}") != wanted.name {
            entry.set("name", &quoted(&wanted.name), &["ratio"], splices);
        }
        if now.ratio != wanted.ratio {
            entry.set("ratio", &ratio(wanted.ratio), &[], splices);
        }
        for (key, now, wanted) in [("x", now.x, wanted.x), ("y", now.y, wanted.y)] {
            if !same_place(now, wanted) {
                let fits = |place: f64| same_place(place, wanted);
                let value = self.units.value(entry, key, wanted, Dimension::Length, fits, splices);
                entry.set(key, &value, &["x", "ratio"], splices);
            }
        }
        let Some(list) = List::of(entry.get("weights")) else { return };
        for (index, own) in list.entries.iter().enumerate() {
            match (now.weights.get(index), wanted.weights.get(index)) {
                (Some(now), Some(wanted)) => self.change_weight(*own, now, wanted, splices),
                _ => list.remove(index, splices),
            }
        }
        let more: Vec<NewEntry> = wanted
            .weights
            .get(list.entries.len()..)
            .unwrap_or(&[])
            .iter()
            .map(|weight| self.new_weight(weight))
            .collect();
        if wanted.weights.is_empty() && !list.is_inline() {
            // The last of its headers goes, and a shaft says what weights it has.
            entry.add("weights", "[]", &["ratio"], splices);
        }
        list.append("shaft.weights", &more, splices);
    }

    fn change_weight(
        &self,
        entry: Entry<'_>,
        now: &ShaftWeight,
        wanted: &ShaftWeight,
        splices: &mut Splices<'_>,
    ) {
        if !same_place(now.z, wanted.z) {
            let fits = |z: f64| same_place(z - self.origin, wanted.z);
            let z = wanted.z + self.origin;
            let value = self.units.value(entry, "z", z, Dimension::Length, fits, splices);
            entry.set("z", &value, &[], splices);
        }
        let part = part_of(wanted).or(now.part.as_ref().filter(|_| same_numbers(now, wanted)));
        match (&now.part, part) {
            (None, None) => {
                if !same_amount(now.unbalance, wanted.unbalance) {
                    set_unbalance(entry, wanted.unbalance, self.units, splices);
                }
            }
            (Some(old), None) => {
                entry.unset_table("shape", splices);
                if !old.wanted.is_some_and(|unbalance| same_amount(unbalance, wanted.unbalance)) {
                    set_unbalance(entry, wanted.unbalance, self.units, splices);
                }
            }
            (old, Some(part)) => {
                if old.as_ref() != Some(part) {
                    let shape = self.shape(part);
                    set_shape(entry, now.unbalance, part.wanted, &shape, "z", self.units, splices);
                }
            }
        }
        if !same_direction(now.phase, wanted.phase) && wanted.unbalance != 0.0 {
            let old = entry.text("phase").and_then(|text| parse(text, Dimension::Angle, "").ok());
            let phase = angle_near(wanted.phase, old.unwrap_or(wanted.phase));
            let fits = |phase: f64| same_direction(phase, wanted.phase);
            let value = self.units.value(entry, "phase", phase, Dimension::Angle, fits, splices);
            entry.set("phase", &value, &["unbalance", "mass", "z"], splices);
        }
    }

    /// `line_end` is empty for a shaft that stands in one line.
    fn new_shaft(&self, shaft: &BalanceShaft, line_end: &str) -> NewEntry {
        let place = |key, place: f64| {
            self.units.new_value(key, place, Dimension::Length, |read| same_place(read, place))
        };
        let weights: Vec<NewEntry> = shaft.weights.iter().map(|weight| self.new_weight(weight)).collect();
        vec![
            ("name", quoted(&shaft.name)),
            ("ratio", ratio(shaft.ratio)),
            ("x", place("x", shaft.x)),
            ("y", place("y", shaft.y)),
            ("weights", list_value(&weights, line_end)),
        ]
    }

    fn new_weight(&self, weight: &ShaftWeight) -> NewEntry {
        let z = self.units.new_value("z", weight.z + self.origin, Dimension::Length, |z| {
            same_place(z - self.origin, weight.z)
        });
        let part = part_of(weight);
        let unbalance = part.map_or(Some(weight.unbalance), |part| part.wanted).map(|amount| {
            let fits = |read: f64| same_amount(read, amount);
            self.units.new_value("unbalance", amount, Dimension::Unbalance, fits)
        });
        let phase = self
            .units
            .new_value("phase", weight.phase, Dimension::Angle, |phase| same_direction(phase, weight.phase));
        let shape = part.map(|part| self.shape(part));
        let entries = [("z", Some(z)), ("unbalance", unbalance), ("phase", Some(phase)), ("shape", shape)];
        entries.into_iter().filter_map(|(key, value)| Some((key, value?))).collect()
    }

    fn shape(&self, part: &ShaftWeightPart) -> String {
        shaft_shape(part, &|value, dimension| dimension_text(value, dimension, self.exact))
    }
}
