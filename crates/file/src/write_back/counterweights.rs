//! `[[counterweight]]` and the short form `[counterweights]`.

use super::amount::{Units, angle_near, same_amount, same_direction, same_place, turn_between};
use super::entry::{Entry, List, NewEntry, block};
use super::splice::Splices;
use super::weight::{PART, dimension_text, matches, set_shape, set_unbalance};
use crate::expanded::{quoted, shape_entries};
use lanchester_model::{Counterweight, Engine};
use lanchester_model::{CounterweightForm, CounterweightPart};
use lanchester_units::{Dimension, parse};
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
    /// Line end of the file.
    pub(super) line_end: &'a str,
    /// Whether dimensions of shapes are written to the last digit.
    pub(super) exact: bool,
}

/// Where a weight sits, as the file says it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Throw(usize),
    /// Number of the web, from 0.
    Web(usize),
    Plane,
}

/// Whether the weight stays as it is: a part is the same part, or the number that it has.
fn same(a: &Counterweight, b: &Counterweight) -> bool {
    same_numbers(a, b) && (b.part.is_none() || a.part == b.part)
}

fn same_numbers(a: &Counterweight, b: &Counterweight) -> bool {
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
            TableStyle::Dotted | TableStyle::Implicit => entry.remove_dotted(splices),
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
        let (old_part, part) = (now.part.as_deref(), self.part_of(wanted));
        let part = part.or(old_part.filter(|_| same_numbers(now, wanted)));
        let old_place = self.place_of(entry);
        let mut place = old_place;
        let place_key = match place {
            Place::Throw(_) => "throw",
            Place::Web(_) => "web",
            Place::Plane => "z",
        };
        // The keys of a part speak of its middle and of its own x.
        let of_part = |part: &CounterweightPart| (part.z, part.angle);
        let (old_z, old_angle) = old_part.map_or((now.z, now.angle), of_part);
        let (new_z, new_angle) = part.map_or((wanted.z, wanted.angle), of_part);
        let is_moved = now.crankshaft != wanted.crankshaft || !same_place(old_z, new_z);
        let web = part.and_then(|part| part.web);
        let leaves_web = part.is_some() && web.is_none() && matches!(place, Place::Web(_));
        if let Some(web) = web {
            if place != Place::Web(web) {
                entry.exchange(place_key, "web", &(web + 1).to_string(), splices);
                entry.unset("crankshaft", splices);
                place = Place::Web(web);
            }
        } else if is_moved || leaves_web {
            let z = new_z + self.origin;
            let fits = |z: f64| same_place(z - self.origin, new_z);
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
        match (old_part, part) {
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
                if old != Some(part) {
                    let shape = self.shape(part, splices.line_end);
                    let wanted = part.wanted;
                    set_shape(entry, now.unbalance, wanted, &shape, place_key, self.units, splices);
                }
            }
        }
        // A weight of nothing has no direction, a part has.
        let is_turned = !same_direction(old_angle, new_angle) && (wanted.unbalance != 0.0 || part.is_some());
        if is_turned || old_place != place {
            let zero = self.zero(place);
            let old = entry.text("angle").and_then(|text| parse(text, Dimension::Angle, "").ok());
            let default = if place == Place::Plane { new_angle } else { PI };
            let angle = angle_near(new_angle - zero, old.unwrap_or(default));
            let fits = |angle: f64| same_direction(zero + angle, new_angle);
            let value = self.units.value(entry, "angle", angle, Dimension::Angle, fits, splices);
            entry.set("angle", &value, &["unbalance", "mass", place_key], splices);
        }
    }

    /// The part of a weight, if it is one of that amount, in that place: else the number counts.
    fn part_of<'w>(&self, weight: &'w Counterweight) -> Option<&'w CounterweightPart> {
        let part = weight.part.as_deref()?;
        let own = self.engine.part_weight(part).ok()?;
        let is_own = (own.unbalance - weight.unbalance).abs() <= PART * weight.unbalance
            && (own.z - weight.z).abs() <= PART * part.part.thickness()
            && (weight.unbalance == 0.0 || turn_between(own.angle, weight.angle).abs() <= PART);
        is_own.then_some(part)
    }

    /// A shape between braces; an outline of its own has a line for each corner.
    fn shape(&self, part: &CounterweightPart, line_end: &str) -> String {
        let text = |value: f64, dimension: Dimension| dimension_text(value, dimension, self.exact);
        let line_end = match part.form {
            CounterweightForm::Family(_) => "",
            _ => line_end,
        };
        let entries: Vec<String> = shape_entries(part, &text, line_end)
            .into_iter()
            .map(|(key, value)| format!("{key} = {value}"))
            .collect();
        format!("{{ {} }}", entries.join(", "))
    }

    /// An entry for a weight that the file does not have yet.
    fn new_entry(&self, weight: &Counterweight) -> NewEntry {
        let part = self.part_of(weight);
        let place = match part {
            None => self.nearest_place(weight),
            Some(CounterweightPart { web: Some(web), .. }) => Place::Web(*web),
            Some(_) => Place::Plane,
        };
        let (z, angle) = part.map_or((weight.z, weight.angle), |part| (part.z, part.angle));
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
                let fits = |read: f64| same_place(read - self.origin, z);
                let z = self.units.new_value("z", z + self.origin, Dimension::Length, fits);
                entry.push(("z", z));
            }
        }
        if let Some(amount) = part.map_or(Some(weight.unbalance), |part| part.wanted) {
            let fits = |unbalance: f64| same_amount(unbalance, amount);
            let unbalance = self.units.new_value("unbalance", amount, Dimension::Unbalance, fits);
            entry.push(("unbalance", unbalance));
        }
        let zero = self.zero(place);
        let fits = |read: f64| same_direction(zero + read, angle);
        let is_default = place != Place::Plane && fits(PI);
        if !is_default {
            let reference = if place == Place::Plane { angle } else { PI };
            let angle = angle_near(angle - zero, reference);
            entry.push(("angle", self.units.new_value("angle", angle, Dimension::Angle, fits)));
        }
        if let Some(part) = part {
            entry.push(("shape", self.shape(part, self.line_end)));
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
