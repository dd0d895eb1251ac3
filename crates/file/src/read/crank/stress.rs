//! `[crank.mesh]` and `[[stress.case]]`: stress of the crankshafts.

use crate::document::{Field, Section, Span};
use crate::read::drafts::Drafts;
use crate::read::reader::Reader;
use crate::read::simulation::optional;
use lanchester_diagnostic::Mistake;
use lanchester_model::{CrankElement, CrankElementForm, Engine};
use lanchester_task::{CasePinForce, MeshTask, StressCaseLoad, StressCaseTask, StressSupport, StressTask};

/// Sizes of elements that are accepted [m].
const SIZES: [f64; 2] = [1e-4, 1.0];

/// A force with the place of its pin.
struct Draft {
    force: CasePinForce,
    pin: Span,
}

impl<'a> Reader<'a> {
    /// What the file asks of stress: the outer `None` says bad, the inner one absent.
    pub(in crate::read) fn stress_task(
        &mut self,
        drafts: Option<&Drafts<'a>>,
        crankshafts: Option<usize>,
    ) -> Option<Option<StressTask>> {
        let mesh = self.mesh_task();
        let (section, broken) = self.section("stress");
        let cases = match section {
            Some(section) => self.stress_cases(section, drafts, crankshafts),
            None => (!broken).then(Vec::new),
        };
        let task = StressTask { mesh: mesh?, cases: cases? };
        Some((task != StressTask::default()).then_some(task))
    }

    /// Springs are one for all journals, or one for each.
    pub(in crate::read) fn check_stress(&mut self, task: Option<&StressTask>, engine: &Engine) {
        let (Some(task), Some(section)) = (task, self.section("stress").0) else { return };
        let tables = section.tables("case").given().unwrap_or(&[]);
        for (case, table) in task.cases.iter().zip(tables) {
            let StressSupport::Springs { stiffness } = &case.support else { continue };
            let Ok(elements) = engine.crank_elements(case.crankshaft) else { continue };
            let is_journal =
                |element: &&CrankElement| matches!(element.form, CrankElementForm::Journal { .. });
            let (journals, got) = (elements.iter().filter(is_journal).count(), stiffness.len());
            if journals == 0 || got == 1 || got == journals {
                continue;
            }
            let message =
                format!("`stiffness` has {got} entries, and the crankshaft has {journals} journals");
            self.mistakes.push(Mistake::error("E0206", table.value_span("stiffness"), message).hint(
                "give one for all journals, or one for each from the free end on; \"0 N/m\" does not hold",
            ));
        }
    }

    fn mesh_task(&mut self) -> Option<MeshTask> {
        let (crank, broken) = self.section("crank");
        let Some(crank) = crank else { return (!broken).then(MeshTask::default) };
        let section = match crank.table("mesh") {
            Field::Absent => return Some(MeshTask::default()),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let (size, elements, file) = (
            optional(section.number("size")),
            section.whole("fillet_elements"),
            optional(section.text("file")),
        );
        let mut is_good = true;
        if let Some(Some(size)) = size
            && !(SIZES[0]..=SIZES[1]).contains(&size)
        {
            let message = format!("`size` must lie between 0.1 mm and 1 m, got {} mm", 1e3 * size);
            self.mistakes.push(
                Mistake::error("E0108", section.value_span("size"), message)
                    .label("out of range")
                    .hint("8 mm are usual"),
            );
            is_good = false;
        }
        if let Field::Given(count) = &elements
            && count.value % 2 != 0
        {
            let message = format!("`fillet_elements` must be an even number, got {}", count.value);
            self.mistakes.push(
                Mistake::error("E0108", count.span.clone(), message)
                    .hint("6 are usual for stress, 2 for frequencies"),
            );
            is_good = false;
        }
        if section.has("file") {
            for key in ["size", "fillet_elements"] {
                if section.has(key) {
                    let why = "the mesh of `file` is as fine as it is";
                    self.without_effect(section, key, why, "leave out one of the two");
                    is_good = false;
                }
            }
        }
        let fillet_elements = optional(elements)?.and_then(|count| usize::try_from(count).ok());
        is_good.then_some(MeshTask { size: size?, fillet_elements, file: file? })
    }

    fn stress_cases(
        &mut self,
        section: &'a Section,
        drafts: Option<&Drafts<'a>>,
        crankshafts: Option<usize>,
    ) -> Option<Vec<StressCaseTask>> {
        let tables = section.tables("case").or(&[])?;
        let mut found = Vec::new();
        let mut names: Vec<String> = Vec::new();
        let mut is_good = true;
        for table in tables {
            let name = self.required(table, "name", table.text("name"));
            if let Some(name) = &name {
                let plain = name.trim().to_lowercase();
                if names.contains(&plain) {
                    let message = format!("two static cases are called \"{name}\"");
                    self.mistakes.push(
                        Mistake::error("E0514", table.value_span("name"), message)
                            .hint("give each its own name"),
                    );
                    is_good = false;
                }
                names.push(plain);
            }
            match (name, self.stress_case(table, drafts, crankshafts)) {
                (Some(name), Some(case)) => found.push(StressCaseTask { name, ..case }),
                _ => is_good = false,
            }
        }
        is_good.then_some(found)
    }

    /// A case without its name.
    fn stress_case(
        &mut self,
        table: &'a Section,
        drafts: Option<&Drafts<'a>>,
        crankshafts: Option<usize>,
    ) -> Option<StressCaseTask> {
        let support = self.stress_support(table);
        let (angle, speed) = (optional(table.number("angle")), optional(table.number("speed")));
        let forces = self.pin_forces(table, drafts.map(|drafts| drafts.throws.len()));
        let number = match table.whole("crankshaft") {
            Field::Given(spot) => self.existing(spot.value, crankshafts, "crankshaft", spot.span).map(Some),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let (support, angle, speed, forces, number) = (support?, angle?, speed?, forces?, number?);
        if forces.is_empty() {
            let Some(angle) = angle else {
                self.missing(
                    table.span.clone(),
                    "a static case needs forces on a pin, or a crank angle".into(),
                    "for example pin = 1 with radial = \"-65 kN\", or angle = \"7 deg\"".into(),
                );
                return None;
            };
            let load = StressCaseLoad::Angle { angle };
            return Some(StressCaseTask {
                name: String::new(),
                crankshaft: number.unwrap_or(0),
                load,
                speed,
                support,
            });
        }
        let mut is_good = true;
        if number.is_some() {
            self.without_effect(
                table,
                "crankshaft",
                "the pins of the forces say which one it is",
                "leave it out",
            );
            is_good = false;
        }
        let is_uneven =
            matches!(&support, StressSupport::Springs { stiffness } if stiffness.iter().any(|[x, y]| x != y));
        if angle.is_some() && !is_uneven {
            let why = "forces along and across a throw turn with the crankshaft, and so does this support";
            let hint = "leave it out; without forces gas and inertia load the crankshaft at this angle";
            self.without_effect(table, "angle", why, hint);
            is_good = false;
        }
        // A throw with mistakes of its own counts as one of crankshaft 1.
        let of = |draft: &Draft| {
            let throw = drafts.and_then(|drafts| drafts.throws[draft.force.throw].as_ref());
            throw.map_or(0, |own| own.throw.crankshaft)
        };
        let crankshaft = of(&forces[0]);
        for draft in &forces[1..] {
            let other = of(draft);
            if other != crankshaft {
                let message = format!(
                    "crankpin {} is on crankshaft {}, that of the first force on crankshaft {}",
                    draft.force.throw + 1,
                    other + 1,
                    crankshaft + 1
                );
                self.mistakes.push(
                    Mistake::error("E0205", draft.pin.clone(), message)
                        .hint("make a case of each crankshaft"),
                );
                is_good = false;
            }
        }
        let is_still = speed.is_none_or(|speed| speed == 0.0);
        if is_still && forces.iter().all(|draft| draft.force.radial == 0.0 && draft.force.tangential == 0.0) {
            self.mistakes.push(
                Mistake::error("E0108", table.span.clone(), "nothing loads this static case")
                    .hint("give a radial or tangential force other than 0, or a speed"),
            );
            is_good = false;
        }
        let forces = forces.into_iter().map(|draft| draft.force).collect();
        let load = StressCaseLoad::Forces { forces, angle };
        is_good.then_some(StressCaseTask { name: String::new(), crankshaft, load, speed, support })
    }

    /// Forces of a case; `None` says bad.
    fn pin_forces(&mut self, table: &'a Section, throws: Option<usize>) -> Option<Vec<Draft>> {
        let short = ["pin", "radial", "tangential"].into_iter().find(|key| table.has(key));
        if let (Some(key), true) = (short, table.has("force")) {
            self.two_sources(table, key, "force", "the forces");
            return None;
        }
        let lists = match short {
            Some(_) => std::slice::from_ref(table),
            None => table.tables("force").or(&[])?,
        };
        let mut drafts: Vec<Draft> = Vec::new();
        let mut is_good = true;
        for own in lists {
            let pin = self.required(own, "pin", own.whole("pin"));
            let [radial, tangential] = ["radial", "tangential"].map(|key| own.number(key).or(0.0));
            let throw =
                pin.and_then(|number| self.existing(number, throws, "crankpin", own.value_span("pin")));
            let (Some(throw), Some(radial), Some(tangential)) = (throw, radial, tangential) else {
                is_good = false;
                continue;
            };
            let span = own.value_span("pin");
            if let Some(before) = drafts.iter().find(|draft| draft.force.throw == throw) {
                let message = format!("two forces act on crankpin {}", throw + 1);
                self.mistakes.push(
                    Mistake::error("E0203", span.clone(), message)
                        .label("second force")
                        .related(before.pin.clone(), "first force")
                        .hint("give their sum"),
                );
                is_good = false;
            }
            drafts.push(Draft { force: CasePinForce { throw, radial, tangential }, pin: span });
        }
        is_good.then_some(drafts)
    }

    fn stress_support(&mut self, table: &'a Section) -> Option<StressSupport> {
        let word = table.word("support").or("journals");
        let stiffness = self.stiffnesses(table);
        let [thickness, modulus] = ["ring_thickness", "ring_modulus"].map(|key| optional(table.number(key)));
        let word = word?;
        let mut is_good = true;
        for (key, of) in [("stiffness", "springs"), ("ring_thickness", "rings"), ("ring_modulus", "rings")] {
            if table.has(key) && word != of {
                let hint = format!("add support = \"{of}\", or leave it out");
                self.without_effect(table, key, &format!("it is that of support = \"{of}\""), &hint);
                is_good = false;
            }
        }
        if word == "springs" && !table.has("stiffness") {
            self.missing(
                table.value_span("support"),
                "springs need their `stiffness`".into(),
                "for example stiffness = [\"500 N/um\"]".into(),
            );
            is_good = false;
        }
        let (stiffness, thickness, modulus) = (stiffness?, thickness?, modulus?);
        is_good.then_some(match word {
            "clamped-ends" => StressSupport::ClampedEnds,
            "rings" => StressSupport::Rings { thickness, modulus },
            "springs" => StressSupport::Springs { stiffness },
            "film" => StressSupport::Film,
            "free" => StressSupport::Free,
            _ => StressSupport::Journals,
        })
    }

    /// Stiffnesses along x and y; none where the file gives none.
    fn stiffnesses(&mut self, table: &'a Section) -> Option<Vec<[f64; 2]>> {
        let tables = table.tables("stiffness").or(&[])?;
        let mut found = Vec::new();
        let mut is_good = true;
        for own in tables {
            let x = self.required(own, "x", own.number("x"));
            match (x, optional(own.number("y"))) {
                (Some(x), Some(y)) => found.push([x, y.unwrap_or(x)]),
                _ => is_good = false,
            }
        }
        if is_good && found.is_empty() && table.has("stiffness") {
            self.mistakes.push(
                Mistake::error("E0206", table.value_span("stiffness"), "`stiffness` has no entry")
                    .hint("give one for all journals, or one for each"),
            );
            return None;
        }
        is_good.then_some(found)
    }
}
