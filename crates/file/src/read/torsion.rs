//! `[torsion]`, `[[torsion.branch]]`, `[damper]` and `[[pendulum]]`.

use super::reader::Reader;
use super::simulation::optional;
use crate::document::{Field, Section};
use lanchester_diagnostic::Mistake;
use lanchester_model::{
    BranchPlace, DamperKind, GearEnd, PendulumAbsorber, TorsionBranch, TorsionDamper, TorsionDesign,
};

/// Orders that are accepted as the highest one.
const ORDERS: [f64; 2] = [1.0, 60.0];

impl<'a> Reader<'a> {
    /// What the file says of torsional vibration: the outer `None` says bad, the inner one absent. `throws`: how many there are.
    pub(super) fn torsion(&mut self, throws: Option<usize>) -> Option<Option<TorsionDesign>> {
        let damper = self.damper();
        let pendulums = self.pendulums(throws);
        let (section, broken) = self.section("torsion");
        let own = match section {
            Some(section) => self.torsion_keys(section, throws),
            None => (!broken).then(TorsionDesign::default),
        };
        let (damper, pendulums, own) = (damper?, pendulums?, own?);
        let is_given = section.is_some() || damper.is_some() || !pendulums.is_empty();
        let design = TorsionDesign { damper, pendulums, ..own };
        if let Some(section) = section {
            self.check_stiffnesses(section, &design, throws?)?;
        }
        Some(is_given.then_some(design))
    }

    fn torsion_keys(&mut self, section: &'a Section, throws: Option<usize>) -> Option<TorsionDesign> {
        let stiffness = match section.numbers("stiffness") {
            Field::Given(spot) => Some(spot.value.iter().map(|one| one.value).collect()),
            Field::Absent => Some(Vec::new()),
            Field::Bad => None,
        };
        let [nose_inertia, twist_limit, stress_limit] =
            ["nose_inertia", "twist_limit", "stress_limit"].map(|key| optional(section.number(key)));
        let gears = section
            .word("gears")
            .or("nose")
            .and_then(|word| GearEnd::ALL.into_iter().find(|end| end.word() == word));
        let highest_order = self.highest_order(section);
        let damping = match section.table("damping") {
            Field::Given(spot) => {
                let [absolute, relative, loss] =
                    ["absolute", "relative", "loss_factor"].map(|key| optional(spot.value.number(key)));
                match (absolute, relative, loss) {
                    (Some(absolute), Some(relative), Some(loss)) => Some([absolute, relative, loss]),
                    _ => None,
                }
            }
            Field::Absent => Some([None; 3]),
            Field::Bad => None,
        };
        let branches = self.branches(section, throws);
        let [absolute_damping, relative_damping, loss_factor] = damping?;
        Some(TorsionDesign {
            stiffness: stiffness?,
            absolute_damping,
            relative_damping,
            loss_factor,
            nose_inertia: nose_inertia?,
            gears: gears?,
            highest_order: highest_order?,
            twist_limit: twist_limit?,
            stress_limit: stress_limit?,
            damper: None,
            pendulums: Vec::new(),
            branches: branches?,
        })
    }

    fn highest_order(&mut self, section: &'a Section) -> Option<Option<f64>> {
        let order = optional(section.number("highest_order"))?;
        if let Some(order) = order.filter(|order| !(ORDERS[0]..=ORDERS[1]).contains(order)) {
            let message = format!("`highest_order` must lie between 1 and 60, got {order}");
            self.mistakes.push(
                Mistake::error("E0108", section.value_span("highest_order"), message)
                    .label("out of range")
                    .hint("for example highest_order = 12"),
            );
            return None;
        }
        Some(order)
    }

    /// A list of stiffnesses has one for each piece of the crankshafts.
    fn check_stiffnesses(
        &mut self,
        section: &'a Section,
        design: &TorsionDesign,
        throws: usize,
    ) -> Option<()> {
        let got = design.stiffness.len();
        let has_nose = design.damper.is_some() || design.nose_inertia.is_some_and(|inertia| inertia > 0.0);
        let needed = throws + usize::from(has_nose);
        if got == 0 || got == needed {
            return Some(());
        }
        let nose = if has_nose { "from the nose to the first throw, one " } else { "" };
        let message = format!("`stiffness` has {got} entries, and the crankshaft has {needed} pieces");
        let hint = format!(
            "give one {nose}between each two neighbouring throws, and one from the last throw to the flywheel"
        );
        self.mistakes.push(Mistake::error("E1901", section.value_span("stiffness"), message).hint(hint));
        None
    }

    fn branches(&mut self, section: &'a Section, throws: Option<usize>) -> Option<Vec<TorsionBranch>> {
        let tables = section.tables("branch").or(&[])?;
        let mut found: Vec<TorsionBranch> = Vec::new();
        let mut is_good = true;
        for (index, table) in tables.iter().enumerate() {
            let name = table.text("name").or(format!("branch {}", index + 1));
            let place = self.required(table, "at", table.text("at"));
            let [inertia, stiffness] =
                ["inertia", "stiffness"].map(|key| self.required(table, key, table.number(key)));
            let (damping, ratio) = (table.number("damping").or(0.0), table.number("ratio").or(1.0));
            if ratio == Some(0.0) {
                self.mistakes.push(
                    Mistake::error("E0110", table.value_span("ratio"), "`ratio` is 0")
                        .hint("give the speed of this branch over that of what drives it"),
                );
                is_good = false;
            }
            if let Some(name) = &name
                && found.iter().any(|other| other.name == *name)
            {
                let message = format!("two branches are called \"{name}\"");
                self.mistakes.push(
                    Mistake::error("E0514", table.value_span("name"), message).hint("give each its own name"),
                );
                is_good = false;
            }
            let at = place.and_then(|place| self.branch_place(table, &place, &found, throws));
            match (name, at, inertia, stiffness, damping, ratio) {
                (Some(name), Some(at), Some(inertia), Some(stiffness), Some(damping), Some(ratio)) => {
                    found.push(TorsionBranch { name, at, inertia, stiffness, damping, ratio });
                }
                _ => is_good = false,
            }
        }
        is_good.then_some(found)
    }

    fn branch_place(
        &mut self,
        table: &'a Section,
        place: &str,
        before: &[TorsionBranch],
        throws: Option<usize>,
    ) -> Option<BranchPlace> {
        if let Some(index) = before.iter().position(|branch| branch.name == place) {
            return Some(BranchPlace::Branch(index));
        }
        match place {
            "nose" => return Some(BranchPlace::Nose),
            "flywheel" => return Some(BranchPlace::Flywheel),
            _ => {}
        }
        if let Some(number) = place.strip_prefix("throw ").and_then(|text| text.trim().parse::<i64>().ok()) {
            return self.existing(number, throws, "throw", table.value_span("at")).map(BranchPlace::Throw);
        }
        let message = format!("nothing that drives a branch is called \"{place}\"");
        self.mistakes.push(
            Mistake::error("E0205", table.value_span("at"), message)
                .hint("write \"nose\", \"flywheel\", \"throw 2\", or the name of a branch above this one"),
        );
        None
    }

    /// `[damper]`: the outer `None` says bad, the inner one absent.
    fn damper(&mut self) -> Option<Option<TorsionDamper>> {
        let (section, broken) = self.section("damper");
        let Some(section) = section else { return (!broken).then_some(None) };
        let word = self.required(section, "type", section.word("type"));
        let [ring_inertia, hub_inertia] =
            ["ring_inertia", "hub_inertia"].map(|key| self.required(section, key, section.number(key)));
        let kind = DamperKind::ALL.into_iter().find(|kind| Some(kind.word()) == word)?;
        let (damping, stiffness, loss_factor) = match kind {
            DamperKind::Viscous => {
                if section.has("loss_factor") && !section.has("stiffness") {
                    let why = "the ring has no stiffness";
                    self.without_effect(section, "loss_factor", why, "leave it out, or give `stiffness`");
                }
                let damping = self.required(section, "damping", section.number("damping"));
                (damping, section.number("stiffness").or(0.0), section.number("loss_factor").or(0.0))
            }
            DamperKind::Rubber => {
                if section.has("damping") {
                    let why = "the loss factor is the damping of a rubber damper";
                    self.without_effect(section, "damping", why, "leave it out, or change the type");
                }
                let [stiffness, loss_factor] =
                    ["stiffness", "loss_factor"].map(|key| self.required(section, key, section.number(key)));
                (Some(0.0), stiffness, loss_factor)
            }
        };
        Some(Some(TorsionDamper {
            kind,
            ring_inertia: ring_inertia?,
            hub_inertia: hub_inertia?,
            damping: damping?,
            stiffness: stiffness?,
            loss_factor: loss_factor?,
        }))
    }

    fn pendulums(&mut self, throws: Option<usize>) -> Option<Vec<PendulumAbsorber>> {
        let tables = self.root.tables("pendulum").or(&[])?;
        let mut found = Vec::new();
        let mut is_good = true;
        for table in tables {
            let throw = self.required(table, "throw", table.whole("throw"));
            let [mass, pivot_radius, length] =
                ["mass", "pivot_radius", "length"].map(|key| self.required(table, key, table.number(key)));
            let (number, damping) = (table.whole("number").or(1), table.number("damping").or(0.0));
            let throw =
                throw.and_then(|number| self.existing(number, throws, "throw", table.value_span("throw")));
            match (throw, mass, pivot_radius, length, number, damping) {
                (Some(throw), Some(mass), Some(pivot_radius), Some(length), Some(number), Some(damping)) => {
                    let number = usize::try_from(number).unwrap_or(1);
                    found.push(PendulumAbsorber { throw, mass, pivot_radius, length, number, damping });
                }
                _ => is_good = false,
            }
        }
        is_good.then_some(found)
    }
}
