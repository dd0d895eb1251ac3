//! `[[counterweight]]` and the short form `[counterweights]`.

use super::amount::{Units, angle_near, same_amount, same_direction, same_place};
use super::entry::{Entry, List, NewEntry, block};
use super::matches;
use super::splice::Splices;
use crate::engine::{Counterweight, Engine};
use crate::expanded::quoted;
use crate::quantity::{Dimension, parse};
use std::f64::consts::PI;
use toml_spanner::{Table, TableStyle};

/// Header of the list.
const PATH: &str = "counterweight";

/// Writes the weights on the crankshafts.
pub(super) struct CounterweightWriter<'a> {
    /// The engine of the file as it is.
    pub(super) engine: &'a Engine,
    /// z of its reference plane in the file [m].
    pub(super) origin: f64,
    pub(super) units: &'a Units<'a>,
}

/// Where a weight sits, as the file says it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Throw(usize),
    /// Number of the web, from 0.
    Web(usize),
    Plane,
}

fn same(a: &Counterweight, b: &Counterweight) -> bool {
    a.crankshaft == b.crankshaft
        && same_place(a.z, b.z)
        && same_amount(a.unbalance, b.unbalance)
        && (same_direction(a.angle, b.angle) || b.unbalance == 0.0)
}

impl CounterweightWriter<'_> {
    /// The file's counterweights become `wanted`.
    pub(super) fn write(
        &self,
        root: &Table<'_>,
        list: &List<'_>,
        wanted: &[Counterweight],
        splices: &mut Splices<'_>,
    ) {
        let there = &self.engine.counterweights;
        // The weights of the short form come first.
        let short_count = there.len() - list.entries.len().min(there.len());
        let found = matches(there, wanted, |a, b| a.name == b.name, same);
        let is_kept = |(weight, target): (&Counterweight, &Option<usize>)| {
            target.is_some_and(|target| same(weight, &wanted[target]))
        };
        let short_stays = there.iter().zip(&found).take(short_count).all(is_kept);
        let appended: Vec<NewEntry> = (0..wanted.len())
            .filter(|target| !found.contains(&Some(*target)))
            .map(|target| self.new_entry(&wanted[target]))
            .collect();
        let mut before = Vec::new();
        let mut short_place = None;
        if !short_stays && let Some(short) = root.get("counterweights").and_then(|item| item.as_table()) {
            before = found[..short_count]
                .iter()
                .flatten()
                .map(|target| self.new_entry(&wanted[*target]))
                .collect();
            let has_header = short.style() == TableStyle::Header && !list.is_inline();
            short_place = self.remove_short(root, short, has_header, splices);
        }
        let mut number = 0;
        for (index, entry) in list.entries.iter().enumerate() {
            match found[short_count + index] {
                None => list.remove(index, splices),
                Some(target) => {
                    let earlier =
                        short_place.filter(|place| *place < entry.start()).map_or(0, |_| before.len());
                    self.change(
                        *entry,
                        &there[short_count + index],
                        &wanted[target],
                        earlier + number,
                        splices,
                    );
                    number += 1;
                }
            }
        }
        let Some(place) = short_place else {
            before.extend(appended);
            list.append(PATH, &before, splices);
            return;
        };
        if list.entries.is_empty() {
            before.extend(appended);
        } else {
            list.append(PATH, &appended, splices);
        }
        let line_end = splices.line_end;
        let blocks: Vec<String> = before.iter().map(|entry| block(PATH, entry, line_end)).collect();
        if !blocks.is_empty() {
            splices.insert(place, blocks.join(&format!("{line_end}{line_end}")));
        }
    }

    /// Takes the short form out, its comments stay. With a header of its own: where its place is.
    fn remove_short(
        &self,
        root: &Table<'_>,
        short: &Table<'_>,
        has_header: bool,
        splices: &mut Splices<'_>,
    ) -> Option<usize> {
        let entry = Entry { item: short.as_item(), table: short };
        if has_header {
            return Some(entry.replace_block(splices));
        }
        match short.style() {
            TableStyle::Header => entry.remove_block(splices),
            TableStyle::Inline => {
                Entry { item: root.as_item(), table: root }.unset("counterweights", splices)
            }
            TableStyle::Dotted | TableStyle::Implicit => {
                for (_, value) in short {
                    let end = value.span().range().end;
                    let line = splices.line_start(value.span().range().start);
                    let start = line + splices.indentation(line).len();
                    splices.remove(start..end);
                }
            }
        }
        None
    }

    fn place_of(&self, entry: Entry<'_>) -> Place {
        let number = |key| entry.get(key)?.as_i64().and_then(|n| usize::try_from(n - 1).ok());
        match (number("throw"), number("web")) {
            (Some(throw), _) => Place::Throw(throw),
            (_, Some(web)) => Place::Web(web),
            _ => Place::Plane,
        }
    }

    /// Direction from which the angle of the place counts.
    fn zero(&self, place: Place) -> f64 {
        match place {
            Place::Throw(throw) => self.engine.throws[throw].angle,
            Place::Web(web) => self.engine.throws[web / 2].angle,
            Place::Plane => 0.0,
        }
    }

    fn default_name(&self, place: Place, number: usize) -> String {
        match place {
            Place::Throw(throw) => format!("throw {}", throw + 1),
            Place::Web(web) => format!("web {}", web + 1),
            Place::Plane => format!("weight {}", number + 1),
        }
    }

    /// Changes of an entry that is to be `wanted`; `number` is its new place among the entries, from 0.
    fn change(
        &self,
        entry: Entry<'_>,
        now: &Counterweight,
        wanted: &Counterweight,
        number: usize,
        splices: &mut Splices<'_>,
    ) {
        let old_place = self.place_of(entry);
        let mut place = old_place;
        let place_key = match place {
            Place::Throw(_) => "throw",
            Place::Web(_) => "web",
            Place::Plane => "z",
        };
        let is_moved = now.crankshaft != wanted.crankshaft || !same_place(now.z, wanted.z);
        if is_moved {
            let z = wanted.z + self.origin;
            let fits = |z: f64| same_place(z - self.origin, wanted.z);
            let value = self.units.value(entry, "z", z, Dimension::Length, fits, splices);
            if place == Place::Plane {
                entry.set("z", &value, &[], splices);
            } else {
                entry.exchange(place_key, "z", &value, splices);
                place = Place::Plane;
            }
            if now.crankshaft != wanted.crankshaft || (old_place != place && wanted.crankshaft > 0) {
                let crankshaft = (wanted.crankshaft + 1).to_string();
                entry.set("crankshaft", &crankshaft, &[place_key], splices);
            }
        }
        if !entry.has("name") && self.default_name(place, number) != wanted.name {
            entry.set("name", &quoted(&wanted.name), &[place_key], splices);
        }
        let changes_amount = !same_amount(now.unbalance, wanted.unbalance);
        if changes_amount {
            super::set_unbalance(entry, wanted.unbalance, self.units, splices);
        }
        // A weight of nothing has no direction.
        let is_turned = !same_direction(now.angle, wanted.angle) && wanted.unbalance != 0.0;
        if is_turned || old_place != place {
            let zero = self.zero(place);
            let old = entry.text("angle").and_then(|text| parse(text, Dimension::Angle, "").ok());
            let default = if place == Place::Plane { wanted.angle } else { PI };
            let angle = angle_near(wanted.angle - zero, old.unwrap_or(default));
            let fits = |angle: f64| same_direction(zero + angle, wanted.angle);
            let value = self.units.value(entry, "angle", angle, Dimension::Angle, fits, splices);
            entry.set("angle", &value, &["unbalance", "mass", place_key], splices);
        }
    }

    /// An entry for a weight that the file does not have yet.
    fn new_entry(&self, weight: &Counterweight) -> NewEntry {
        let place = self.nearest_place(weight);
        let mut entry: NewEntry = Vec::new();
        if place == Place::Plane || self.default_name(place, 0) != weight.name {
            entry.push(("name", quoted(&weight.name)));
        }
        match place {
            Place::Throw(throw) => entry.push(("throw", (throw + 1).to_string())),
            Place::Web(web) => entry.push(("web", (web + 1).to_string())),
            Place::Plane => {
                if weight.crankshaft > 0 {
                    entry.push(("crankshaft", (weight.crankshaft + 1).to_string()));
                }
                let fits = |z: f64| same_place(z - self.origin, weight.z);
                let z = self.units.new_value("z", weight.z + self.origin, Dimension::Length, fits);
                entry.push(("z", z));
            }
        }
        let fits = |unbalance: f64| same_amount(unbalance, weight.unbalance);
        let unbalance = self.units.new_value("unbalance", weight.unbalance, Dimension::Unbalance, fits);
        entry.push(("unbalance", unbalance));
        let zero = self.zero(place);
        let fits = |angle: f64| same_direction(zero + angle, weight.angle);
        let is_default = place != Place::Plane && fits(PI);
        if !is_default {
            let reference = if place == Place::Plane { weight.angle } else { PI };
            let angle = angle_near(weight.angle - zero, reference);
            entry.push(("angle", self.units.new_value("angle", angle, Dimension::Angle, fits)));
        }
        entry
    }

    /// The web or the throw in whose plane the weight stands; of several the one that it is named after.
    fn nearest_place(&self, weight: &Counterweight) -> Place {
        let throws =
            || self.engine.throws.iter().enumerate().filter(|(_, t)| t.crankshaft == weight.crankshaft);
        let webs = throws().flat_map(|(index, throw)| {
            let planes = throw.webs.into_iter().flatten().enumerate();
            planes.map(move |(side, z)| (Place::Web(2 * index + side), z))
        });
        let places: Vec<Place> = throws()
            .map(|(index, throw)| (Place::Throw(index), throw.z))
            .chain(webs)
            .filter(|(_, z)| same_place(*z, weight.z))
            .map(|(place, _)| place)
            .collect();
        let named = places.iter().copied().find(|place| self.default_name(*place, 0) == weight.name);
        named.or(places.first().copied()).unwrap_or(Place::Plane)
    }
}
