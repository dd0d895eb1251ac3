//! Cylinders with their pistons and rods, in the general form and from a layout.

pub(in crate::read) mod chamber;
pub(in crate::read) mod linkage;
pub(in crate::read) mod rod;

use super::cylinder::rod::DraftRod;
use super::{Drafts, Reader};
use crate::document::{Field, Section, Span};
use crate::layout::{Arrangement, CylinderPlace};
use crate::read::crank::DraftThrow;
use lanchester_diagnostic::Mistake;
use lanchester_model::angle;
use lanchester_model::{Crankshaft, Cylinder, RodJoint, Strokes, Throw};

/// A cylinder and where the file speaks of it.
#[derive(Debug, Clone)]
pub(super) struct DraftCylinder<'a> {
    pub(super) cylinder: Cylinder,
    /// Its own table, if it has one.
    pub(super) section: Option<&'a Section>,
    /// Its header, or the layout's.
    pub(super) span: Span,
    pub(super) length_span: Span,
    pub(super) piston_mass_span: Span,
    pub(super) bore_span: Option<Span>,
    /// Whether its rod says that it has its pin for itself.
    pub(super) own_pin: bool,
}

/// Where a cylinder stands, and what its rod's big end sits on.
struct Place {
    throw: usize,
    angle: f64,
    z: f64,
    /// Offset that the layout brings.
    offset: Option<f64>,
    joint: RodJoint,
    own_pin: bool,
}

impl<'a> Reader<'a> {
    /// Throws and cylinders from `[layout]` or from `[[throw]]` and `[[cylinder]]`.
    pub(super) fn throws_and_cylinders(
        &mut self,
        strokes: Option<Strokes>,
        crankshafts: Option<&[Crankshaft]>,
        firing: Option<&'a Section>,
    ) -> Option<Drafts<'a>> {
        let throws = self.root.tables("throw");
        let cylinders = self.root.tables("cylinder");
        match self.root.table("layout") {
            Field::Given(layout) => {
                if self.root.has("throw") {
                    self.mistakes.push(
                        Mistake::error(
                            "E0203",
                            self.root.key_span("throw"),
                            "[layout] and [[throw]] both give the throws",
                        )
                        .related(layout.value.span.clone(), "first source")
                        .hint("keep [layout] for a short form, or [[throw]] and [[cylinder]] for the general one"),
                    );
                }
                let overrides = match cylinders {
                    Field::Given(spot) => spot.value,
                    _ => &[],
                };
                self.drafts_of_layout(layout.value, overrides, strokes, firing)
            }
            Field::Bad => None,
            Field::Absent => {
                let hint = "describe them by [layout], or one by one by [[throw]] and [[cylinder]]";
                if let (Field::Absent, Field::Absent) = (&throws, &cylinders) {
                    self.missing(0..0, "the file has no cylinders".into(), hint.into());
                    return None;
                }
                let (throws, cylinders) = match (throws, cylinders) {
                    (Field::Bad, _) | (_, Field::Bad) => return None,
                    (throws, cylinders) => {
                        (throws.or(&[]).unwrap_or_default(), cylinders.or(&[]).unwrap_or_default())
                    }
                };
                if throws.is_empty() || cylinders.is_empty() {
                    let what = if throws.is_empty() { "[[throw]]" } else { "[[cylinder]]" };
                    self.missing(0..0, format!("the file has no {what}"), hint.into());
                }
                Some(self.drafts_of_tables(throws, cylinders, crankshafts))
            }
        }
    }

    fn drafts_of_tables(
        &mut self,
        throws: &'a [Section],
        cylinders: &'a [Section],
        crankshafts: Option<&[Crankshaft]>,
    ) -> Drafts<'a> {
        let throws: Vec<Option<DraftThrow>> = throws
            .iter()
            .enumerate()
            .map(|(index, section)| self.throw(index, section, crankshafts))
            .collect();
        let driven: Vec<Option<usize>> =
            cylinders.iter().map(|section| self.driving_throw(section, throws.len())).collect();
        let cylinders = cylinders
            .iter()
            .enumerate()
            .map(|(index, section)| {
                let place = self.place_of(index, section, cylinders, &throws, &driven);
                self.cylinder(section.span.clone(), Some(section), place)
            })
            .collect();
        Drafts { throws, cylinders, from_layout: false }
    }

    /// Index of the throw that the cylinder names.
    fn driving_throw(&mut self, section: &'a Section, throws: usize) -> Option<usize> {
        match section.whole("throw") {
            Field::Given(spot) => self.existing(spot.value, Some(throws), "throw", spot.span),
            _ => None,
        }
    }

    /// Place of a cylinder of the general form.
    fn place_of(
        &mut self,
        index: usize,
        section: &'a Section,
        all: &'a [Section],
        throws: &[Option<DraftThrow>],
        driven: &[Option<usize>],
    ) -> Option<Place> {
        if let Field::Given(number) = section.whole("number")
            && number.value != index as i64 + 1
        {
            let due = index + 1;
            self.mistakes.push(
                Mistake::error(
                    "E0207",
                    number.span,
                    format!("cylinder {due} of the file has the number {}", number.value),
                )
                .hint(format!(
                    "[[cylinder]] tables stand in the order of their numbers: write {due}, or leave it out"
                )),
            );
        }
        let angle = self.required(section, "angle", section.number("angle"));
        let rod = section.table("rod").given();
        let kind = rod.map_or(Field::Absent, |rod| rod.word("type")).or("own");
        let (joint, throw) = if kind == Some("articulated") {
            let rod = rod?;
            let master = self.master_of(index, section, rod, all, driven);
            let knuckle = self.knuckle(rod);
            let (master, (knuckle_radius, knuckle_angle)) = (master?, knuckle?);
            (RodJoint::Articulated { master, knuckle_radius, knuckle_angle }, driven[master]?)
        } else {
            if let Some(rod) = rod {
                self.refuse_articulated_keys(rod);
            }
            if !section.has("throw") {
                self.required(section, "throw", section.whole("throw"));
            }
            let joint = match kind? {
                "fork" => RodJoint::Fork,
                "blade" => RodJoint::Blade,
                _ => RodJoint::Crankpin,
            };
            (joint, driven[index]?)
        };
        let z = match section.number("z") {
            Field::Given(spot) => spot.value,
            Field::Bad => return None,
            Field::Absent => throws[throw].as_ref()?.throw.z,
        };
        Some(Place { throw, angle: angle?, z, offset: None, joint, own_pin: kind == Some("own") })
    }

    /// Index of the master's cylinder.
    fn master_of(
        &mut self,
        index: usize,
        section: &'a Section,
        rod: &'a Section,
        all: &'a [Section],
        driven: &[Option<usize>],
    ) -> Option<usize> {
        let number = self.required(rod, "master", rod.whole("master"))?;
        let span = rod.value_span("master");
        let master = self.existing(number, Some(all.len()), "cylinder", span.clone())?;
        if master == index {
            self.mistakes.push(
                Mistake::error("E0508", span, format!("cylinder {number} cannot be its own master"))
                    .hint("name the cylinder whose rod sits on the crankpin"),
            );
            return None;
        }
        let master_rod = all[master].table("rod").given();
        if master_rod.and_then(|rod| rod.word("type").given()) == Some("articulated") {
            self.mistakes.push(
                Mistake::error("E0508", span, format!("the rod of cylinder {number} is articulated itself"))
                    .label("no master rod")
                    .related(all[master].span.clone(), "its cylinder")
                    .hint("a master rod sits on the crankpin"),
            );
            return None;
        }
        if let (Some(own), Some(of_master)) = (driven[index], driven[master])
            && own != of_master
        {
            let (own, of_master) = (own + 1, of_master + 1);
            self.mistakes.push(
                Mistake::error(
                    "E0508",
                    section.value_span("throw"),
                    format!("the master rod sits on throw {of_master}, not on throw {own}"),
                )
                .related(span, "master")
                .hint("leave throw out: an articulated rod goes with its master"),
            );
            return None;
        }
        Some(master)
    }

    /// Radius and angle of the knuckle pin.
    fn knuckle(&mut self, rod: &'a Section) -> Option<(f64, f64)> {
        let layers = self.layers(&[Some(rod)], "articulated_rod");
        let [radius, angle] = ["knuckle_radius", "knuckle_angle"].map(|key| {
            let field = layers.number(key);
            if layers.broken { field.given() } else { self.required(rod, key, field) }
        });
        Some((radius?, angle?))
    }

    fn refuse_articulated_keys(&mut self, rod: &'a Section) {
        for key in ["master", "knuckle_radius", "knuckle_angle"] {
            if rod.has(key) {
                self.without_effect(
                    rod,
                    key,
                    "the rod sits on the crankpin",
                    "add type = \"articulated\", or leave it out",
                );
            }
        }
    }

    fn drafts_of_layout(
        &mut self,
        layout: &'a Section,
        overrides: &'a [Section],
        strokes: Option<Strokes>,
        firing: Option<&'a Section>,
    ) -> Option<Drafts<'a>> {
        let masses = self.throw_masses(&self.layers(&[], "crank"));
        let arrangement = strokes
            .and_then(|strokes| self.arrangement(layout, strokes, firing, masses.as_ref().map(|m| m.radius)));
        let Some(Arrangement { throws, cylinders }) = arrangement else {
            self.check_parts(layout, overrides);
            return None;
        };
        let span = layout.key_span("type");
        let throws = throws
            .iter()
            .map(|place| {
                let masses = masses.as_ref()?;
                let throw = Throw {
                    crankshaft: 0,
                    angle: angle::direction(place.angle),
                    z: place.z,
                    radius: masses.radius,
                    unbalance: masses.unbalance,
                    unbalance_offset: 0.0,
                    webs: None,
                };
                Some(DraftThrow::new(throw, span.clone(), masses))
            })
            .collect();
        let overrides = self.by_number(overrides, cylinders.len());
        let cylinders = cylinders
            .iter()
            .zip(overrides)
            .map(|(place, section)| {
                let own_span = section.map_or(span.clone(), |section| section.span.clone());
                let place = self.overridden_place(place, section);
                self.cylinder(own_span, section, place)
            })
            .collect();
        Some(Drafts { throws, cylinders, from_layout: true })
    }

    /// Mistakes of pistons and rods where their places are not known.
    fn check_parts(&mut self, layout: &'a Section, overrides: &'a [Section]) {
        if overrides.is_empty() {
            self.cylinder(layout.span.clone(), None, None);
        }
        for section in overrides {
            self.cylinder(section.span.clone(), Some(section), None);
        }
        if self.section("articulated_rod").0.is_some() {
            self.rod(&self.layers(&[], "articulated_rod"), RodJoint::Crankpin);
        }
    }

    /// The table of each cylinder that has one.
    fn by_number(&mut self, overrides: &'a [Section], count: usize) -> Vec<Option<&'a Section>> {
        let mut found: Vec<Option<&Section>> = vec![None; count];
        for section in overrides {
            let Some(number) = self.required(section, "number", section.whole("number")) else { continue };
            let span = section.value_span("number");
            let Some(index) = self.existing(number, Some(count), "cylinder", span.clone()) else { continue };
            if let Some(other) = found[index] {
                self.mistakes.push(
                    Mistake::error("E0207", span, format!("cylinder {number} has two tables"))
                        .related(other.value_span("number"), "the other")
                        .hint("write all its keys in one [[cylinder]]"),
                );
            }
            found[index] = Some(section);
        }
        found
    }

    /// Place of a cylinder of a layout with what its own table says.
    fn overridden_place(&mut self, place: &CylinderPlace, section: Option<&'a Section>) -> Option<Place> {
        let mut z = place.z;
        let mut joint = match place.joint {
            RodJoint::Articulated { master, knuckle_radius, knuckle_angle } => {
                RodJoint::Articulated { master, knuckle_radius, knuckle_angle: angle::snapped(knuckle_angle) }
            }
            joint => joint,
        };
        let mut is_good = true;
        if let Some(section) = section {
            for key in ["throw", "angle"] {
                if section.has(key) {
                    self.without_effect(
                        section,
                        key,
                        "[layout] says where the cylinder stands",
                        "leave it out, or write the engine in the general form, to which this one expands",
                    );
                }
            }
            match section.number("z") {
                Field::Given(spot) => z = spot.value,
                Field::Bad => is_good = false,
                Field::Absent => {}
            }
            if let Some(rod) = section.table("rod").given() {
                for key in ["type", "master"] {
                    if rod.has(key) {
                        self.without_effect(
                            rod,
                            key,
                            "[layout] says what the rods sit on",
                            "leave it out, or write the engine in the general form, to which this one expands",
                        );
                    }
                }
                if let RodJoint::Articulated { knuckle_radius, knuckle_angle, .. } = &mut joint {
                    for (key, value) in [("knuckle_radius", knuckle_radius), ("knuckle_angle", knuckle_angle)]
                    {
                        match rod.number(key) {
                            Field::Given(spot) => *value = spot.value,
                            Field::Bad => is_good = false,
                            Field::Absent => {}
                        }
                    }
                } else {
                    for key in ["knuckle_radius", "knuckle_angle"].into_iter().filter(|key| rod.has(key)) {
                        self.without_effect(rod, key, "the rod sits on the crankpin", "leave it out");
                    }
                }
            }
        }
        is_good.then_some(Place {
            throw: place.throw,
            angle: angle::snapped(place.angle),
            z,
            offset: place.offset,
            joint,
            own_pin: false,
        })
    }

    /// Piston, rod and offsets of a cylinder; its mistakes are told even if its place is not known.
    fn cylinder(
        &mut self,
        span: Span,
        section: Option<&'a Section>,
        place: Option<Place>,
    ) -> Option<DraftCylinder<'a>> {
        let bad =
            |name: &str| section.is_some_and(|section| section.has(name) && section.table(name).is_bad());
        let (own_piston, own_rod) = (
            section.and_then(|section| section.table("piston").given()),
            section.and_then(|section| section.table("rod").given()),
        );
        let mut pistons = self.layers(&[own_piston], "piston");
        pistons.broken |= bad("piston");
        let piston_mass = match pistons.number("mass") {
            Field::Given(spot) => Some(spot),
            Field::Bad => None,
            Field::Absent => {
                self.missing_in(&pistons, "the mass of the piston", "mass = \"0.5 kg\"");
                None
            }
        };
        for key in ["bore", "pin_offset"] {
            if let (Some(section), Some(piston)) = (section, own_piston)
                && section.has(key)
                && piston.has(key)
            {
                self.mistakes.push(
                    Mistake::error(
                        "E0203",
                        piston.key_span(key),
                        format!("the cylinder gives `{key}` twice"),
                    )
                    .related(section.key_span(key), "first source")
                    .hint("keep one of the two"),
                );
            }
        }
        let of_cylinder = self.layers(&[section, own_piston], "piston");
        let bore = of_cylinder.number("bore");
        let pin_offset = of_cylinder.number("pin_offset").or(0.0);
        let joint = match (&place, own_rod) {
            (Some(place), _) => place.joint,
            // Only the table of defaults depends on it: the place is lost.
            (None, Some(rod)) if rod.word("type").given() == Some("articulated") => {
                RodJoint::Articulated { master: 0, knuckle_radius: 0.0, knuckle_angle: 0.0 }
            }
            _ => RodJoint::Crankpin,
        };
        let default = if matches!(joint, RodJoint::Articulated { .. }) { "articulated_rod" } else { "rod" };
        let mut rods = self.layers(&[own_rod], default);
        rods.broken |= bad("rod");
        let rod = self.rod(&rods, joint);
        let offset = self.offset(section, place.as_ref().and_then(|place| place.offset));
        let (bore, bore_span) = match bore {
            Field::Given(spot) => (Some(spot.value), Some(spot.span)),
            Field::Bad => return None,
            Field::Absent => (None, None),
        };
        let (piston_mass, DraftRod { rod, length_span }, place) = (piston_mass?, rod?, place?);
        let cylinder = Cylinder {
            throw: place.throw,
            angle: place.angle,
            z: place.z,
            offset: offset?,
            pin_offset: pin_offset?,
            bore,
            piston_mass: piston_mass.value,
            rod,
            firing_angle: None,
            chamber: None,
        };
        Some(DraftCylinder {
            cylinder,
            section,
            span,
            length_span,
            piston_mass_span: piston_mass.span,
            bore_span,
            own_pin: place.own_pin,
        })
    }

    /// Offset of a cylinder axis: its own, else the layout's, else that of `[cylinders]`.
    fn offset(&mut self, section: Option<&'a Section>, of_layout: Option<f64>) -> Option<f64> {
        if let Some(section) = section
            && section.has("offset")
        {
            return section.number("offset").given();
        }
        let (defaults, broken) = self.section("cylinders");
        match (of_layout, defaults) {
            (Some(_), Some(defaults)) if defaults.has("offset") => {
                self.without_effect(
                    defaults,
                    "offset",
                    "the layout gives each bank its offset",
                    "leave it out, or change the offsets in [layout]",
                );
                None
            }
            (Some(offset), _) => Some(offset),
            (None, Some(defaults)) => defaults.number("offset").or(0.0),
            (None, None) => (!broken).then_some(0.0),
        }
    }
}
