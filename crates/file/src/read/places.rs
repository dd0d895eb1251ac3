//! Two parts in one place, parts that nothing holds.

use super::drafts::DraftCylinder;
use super::drafts::Drafts;
use super::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{Crankshaft, RodJoint};
use lanchester_numerics::about_zero;
use lanchester_units::Dimension;
use std::f64::consts::TAU;

/// Places closer than this [m] are one.
const SAME_PLACE: f64 = 1e-9;
/// Directions closer than this [rad] are one.
const SAME_ANGLE: f64 = 1e-9;

fn same_direction(a: f64, b: f64) -> bool {
    about_zero(a - b, TAU).abs() < SAME_ANGLE
}

fn same_place(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME_PLACE
}

impl<'a> Reader<'a> {
    pub(super) fn check_places(&mut self, drafts: &Drafts<'a>, crankshafts: Option<&[Crankshaft]>) {
        self.check_throw_places(drafts);
        self.check_cylinder_places(drafts);
        for throw in 0..drafts.throws.len() {
            self.check_rods_on(drafts, throw);
        }
        self.check_rods_in_one_plane(drafts);
        self.check_knuckles(drafts);
        self.check_idle_parts(drafts, crankshafts);
    }

    /// One pin is one throw.
    fn check_throw_places(&mut self, drafts: &Drafts<'a>) {
        for (index, draft) in drafts.throws.iter().enumerate() {
            let Some(draft) = draft else { continue };
            let twin = drafts.throws[..index].iter().position(|other| {
                other.as_ref().is_some_and(|other| {
                    let (a, b) = (&draft.throw, &other.throw);
                    a.crankshaft == b.crankshaft && same_place(a.z, b.z) && same_direction(a.angle, b.angle)
                })
            });
            let Some(twin) = twin else { continue };
            let (one, two) = (twin + 1, index + 1);
            let other = drafts.throws[twin].as_ref().map_or(0..0, |throw| throw.span.clone());
            self.mistakes.push(
                Mistake::error(
                    "E0501",
                    draft.span.clone(),
                    format!("throws {one} and {two} stand in one place"),
                )
                .related(other, "the other")
                .hint("let their cylinders name one throw, or give each its own z or angle"),
            );
        }
    }

    fn check_cylinder_places(&mut self, drafts: &Drafts<'a>) {
        let crankshaft_of = |draft: &DraftCylinder<'a>| {
            drafts.throws[draft.cylinder.throw].as_ref().map(|throw| throw.throw.crankshaft)
        };
        for (index, draft) in drafts.cylinders.iter().enumerate() {
            let Some(draft) = draft else { continue };
            for (before, other) in drafts.cylinders[..index].iter().enumerate() {
                let Some(other) = other else { continue };
                let (a, b) = (&draft.cylinder, &other.cylinder);
                if crankshaft_of(draft) != crankshaft_of(other) || !same_direction(a.angle, b.angle) {
                    continue;
                }
                if same_place(a.z, b.z) && same_place(a.offset, b.offset) {
                    let (one, two) = (before + 1, index + 1);
                    self.mistakes.push(
                        Mistake::error(
                            "E0501",
                            draft.span.clone(),
                            format!("cylinders {one} and {two} stand in one place"),
                        )
                        .related(other.span.clone(), "the other")
                        .hint("give each its own z, angle or offset"),
                    );
                } else {
                    self.check_overlap(draft, other);
                }
            }
        }
    }

    /// Cylinders side by side must leave room for their bores.
    fn check_overlap(&mut self, one: &DraftCylinder<'a>, other: &DraftCylinder<'a>) {
        let bore_of = |draft: &DraftCylinder<'a>| Some((draft.cylinder.bore?, draft.bore_span.clone()?));
        let (Some(one_bore), Some(other_bore)) = (bore_of(one), bore_of(other)) else { return };
        let (a, b) = (&one.cylinder, &other.cylinder);
        let distance = (a.z - b.z).hypot(a.offset - b.offset);
        if distance >= (one_bore.0 + other_bore.0) / 2.0 {
            return;
        }
        let (bore, span) = if one_bore.0 >= other_bore.0 { one_bore } else { other_bore };
        let [distance, bore] =
            [distance, bore].map(|value| lanchester_units::readable(value, Dimension::Length));
        self.mistakes.push(
            Mistake::warning(
                "W0502",
                span,
                format!("a bore of {bore} overlaps the next: the cylinders stand {distance} apart"),
            )
            .hint("check the bore and the distance between the cylinders"),
        );
    }

    /// Rods that say what they share the pin with, and what is there.
    fn check_rods_on(&mut self, drafts: &Drafts<'a>, throw: usize) {
        let on_pin: Vec<(usize, &DraftCylinder<'a>)> = drafts
            .cylinders
            .iter()
            .enumerate()
            .filter_map(|(index, draft)| Some((index, draft.as_ref()?)))
            .filter(|(_, draft)| draft.cylinder.throw == throw)
            .filter(|(_, draft)| !matches!(draft.cylinder.rod.joint, RodJoint::Articulated { .. }))
            .collect();
        let number = throw + 1;
        if let [(_, alone)] = on_pin.as_slice()
            && !drafts.from_layout
            && alone.cylinder.rod.joint == RodJoint::Crankpin
            && !alone.own_pin
        {
            self.mistakes.push(
                Mistake::warning(
                    "W0506",
                    type_span(alone),
                    format!("a rod side by side with others, but throw {number} has no other"),
                )
                .hint("leave type out"),
            );
        }
        for (place, (index, draft)) in on_pin.iter().enumerate() {
            let Some((before, other)) = on_pin[..place].first() else { continue };
            if draft.own_pin || other.own_pin {
                let (one, two) = (before + 1, index + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0505",
                        draft.span.clone(),
                        format!("the rods of cylinders {one} and {two} both sit on the pin of throw {number}"),
                    )
                    .related(other.span.clone(), "the other")
                    .hint("say how they share it: rod.type = \"side-by-side\", \"fork\", \"blade\" or \"articulated\""),
                );
            }
        }
        let of = |joint: RodJoint| {
            on_pin.iter().filter(move |(_, draft)| draft.cylinder.rod.joint == joint).collect::<Vec<_>>()
        };
        let (forks, blades) = (of(RodJoint::Fork), of(RodJoint::Blade));
        match (forks.as_slice(), blades.as_slice()) {
            ([], []) => {}
            ([(fork, _)], [(blade, draft)]) => {
                let (fork_z, blade_z) =
                    (drafts.cylinders[*fork].as_ref().map_or(0.0, |d| d.cylinder.z), draft.cylinder.z);
                if !same_place(fork_z, blade_z) {
                    let (fork, blade) = (fork + 1, blade + 1);
                    self.mistakes.push(
                        Mistake::error(
                            "E0506",
                            draft.span.clone(),
                            format!("the blade of cylinder {blade} must run in the plane of its fork, cylinder {fork}"),
                        )
                        .hint("give both cylinders the same z"),
                    );
                }
            }
            (forks, blades) => {
                let (got_forks, got_blades) = (forks.len(), blades.len());
                if let Some((_, draft)) = forks.iter().chain(blades).next_back() {
                    self.mistakes.push(
                        Mistake::error(
                            "E0506",
                            type_span(draft),
                            format!(
                                "a throw takes one fork and its blade, throw {number} has {} and {}",
                                counted(got_forks, "fork"),
                                counted(got_blades, "blade")
                            ),
                        )
                        .hint("give every fork one blade on the same throw"),
                    );
                }
            }
        }
    }

    /// Rods side by side whose cylinders stand in one plane: a simplification that is said once.
    fn check_rods_in_one_plane(&mut self, drafts: &Drafts<'a>) {
        for (index, draft) in drafts.cylinders.iter().enumerate() {
            let Some(draft) = draft else { continue };
            let clash = drafts.cylinders[..index].iter().position(|other| {
                other.as_ref().is_some_and(|other| {
                    let (a, b) = (&draft.cylinder, &other.cylinder);
                    let both_on_pin = [a.rod.joint, b.rod.joint]
                        .iter()
                        .all(|joint| !matches!(joint, RodJoint::Articulated { .. }));
                    let pair = [a.rod.joint, b.rod.joint]
                        .iter()
                        .all(|joint| matches!(joint, RodJoint::Fork | RodJoint::Blade));
                    a.throw == b.throw && both_on_pin && !pair && same_place(a.z, b.z)
                })
            });
            let Some(other) = clash else { continue };
            if drafts.cylinders[other].as_ref().is_some_and(|other| other.own_pin || draft.own_pin) {
                continue;
            }
            let (one, two) = (other + 1, index + 1);
            let what = format!(
                "the rods of cylinders {one} and {two} sit side by side on one pin, yet in one plane"
            );
            self.mistakes
                .push(Mistake::warning("W0505", draft.span.clone(), what).label("in one plane").hint(
                if drafts.from_layout {
                    "only a fork and its blade run so: give the banks a stagger, or take it as a simplification"
                } else {
                    "give the cylinders the distance of their rods along z, or take it as a simplification"
                },
            ));
            if drafts.from_layout {
                return;
            }
        }
    }

    fn check_knuckles(&mut self, drafts: &Drafts<'a>) {
        for (index, draft) in drafts.cylinders.iter().enumerate() {
            let Some(draft) = draft else { continue };
            let RodJoint::Articulated { master, knuckle_radius, knuckle_angle } = draft.cylinder.rod.joint
            else {
                continue;
            };
            if let Some(of_master) = &drafts.cylinders[master]
                && !same_place(of_master.cylinder.z, draft.cylinder.z)
            {
                let (slave, master) = (index + 1, master + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0509",
                        draft.span.clone(),
                        format!(
                            "the articulated rod of cylinder {slave} must run in the plane of its master, cylinder {master}"
                        ),
                    )
                    .related(of_master.span.clone(), "its master")
                    .hint("give both cylinders the same z"),
                );
            }
            let twin = drafts.cylinders[..index].iter().position(|other| {
                other.as_ref().is_some_and(|other| match other.cylinder.rod.joint {
                    RodJoint::Articulated { master: m, knuckle_radius: radius, knuckle_angle: angle } => {
                        m == master
                            && same_place(radius, knuckle_radius)
                            && same_direction(angle, knuckle_angle)
                    }
                    _ => false,
                })
            });
            if let Some(twin) = twin {
                let (one, two) = (twin + 1, index + 1);
                self.mistakes.push(
                    Mistake::error(
                        "E0505",
                        draft.span.clone(),
                        format!("the rods of cylinders {one} and {two} sit on one knuckle pin"),
                    )
                    .hint("give each articulated rod its own knuckle_angle"),
                );
            }
        }
    }

    /// Throws that drive nothing and crankshafts that carry nothing.
    fn check_idle_parts(&mut self, drafts: &Drafts<'a>, crankshafts: Option<&[Crankshaft]>) {
        if drafts.cylinders.iter().any(Option::is_none) || drafts.throws.iter().any(Option::is_none) {
            return;
        }
        for (index, throw) in drafts.throws.iter().flatten().enumerate() {
            if !drafts.cylinders.iter().flatten().any(|draft| draft.cylinder.throw == index) {
                let number = index + 1;
                self.mistakes.push(
                    Mistake::warning(
                        "W0508",
                        throw.span.clone(),
                        format!("throw {number} drives no cylinder"),
                    )
                    .hint("say throw = .. in a [[cylinder]], or leave the throw out"),
                );
            }
        }
        let Some(crankshafts) = crankshafts else { return };
        let sections = self.root.tables("crankshaft").given().unwrap_or_default();
        let weighted: Vec<i64> = self
            .root
            .tables("counterweight")
            .given()
            .unwrap_or_default()
            .iter()
            .filter_map(|weight| weight.whole("crankshaft").given())
            .collect();
        for (index, section) in sections.iter().enumerate().take(crankshafts.len()) {
            let has_throw = drafts.throws.iter().flatten().any(|throw| throw.throw.crankshaft == index);
            if index > 0 && !has_throw && !weighted.contains(&(index as i64 + 1)) {
                let number = index + 1;
                self.mistakes.push(
                    Mistake::warning(
                        "W0508",
                        section.span.clone(),
                        format!("crankshaft {number} has no throw and no weight"),
                    )
                    .hint("say crankshaft = .. in a [[throw]], or leave it out"),
                );
            }
        }
    }
}

fn counted(count: usize, what: &str) -> String {
    match count {
        0 => format!("no {what}"),
        1 => format!("one {what}"),
        _ => format!("{count} {what}s"),
    }
}

/// Place of the rod's type, else of the cylinder.
fn type_span(draft: &DraftCylinder<'_>) -> std::ops::Range<usize> {
    let rod = draft.section.and_then(|section| section.table("rod").given());
    match rod {
        Some(rod) if rod.has("type") => rod.value_span("type"),
        _ => draft.span.clone(),
    }
}
