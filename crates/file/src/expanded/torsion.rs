//! `[torsion]`, `[[torsion.branch]]`, `[damper]` and `[[pendulum]]`.

use super::text::{File, quantity, quoted};
use lanchester_model::{BranchPlace, Engine, GearEnd, TorsionDesign};
use lanchester_units::Dimension;

impl File {
    pub(super) fn torsion(&mut self, engine: &Engine) {
        let Some(design) = &engine.torsion else { return };
        let own = TorsionDesign { damper: None, pendulums: Vec::new(), ..design.clone() };
        let others = design.damper.is_some() || !design.pendulums.is_empty();
        if own != TorsionDesign::default() || !others {
            self.torsion_keys(&own);
        }
        if let Some(damper) = &design.damper {
            self.header("[damper]", "");
            self.entry("type", &quoted(damper.kind.word()));
            self.entry("ring_inertia", &quantity(damper.ring_inertia, Dimension::Inertia));
            self.entry("hub_inertia", &quantity(damper.hub_inertia, Dimension::Inertia));
            self.entry_unless_zero("damping", damper.damping, Dimension::AngularDamping);
            self.entry_unless_zero("stiffness", damper.stiffness, Dimension::AngularStiffness);
            if damper.stiffness > 0.0 {
                self.entry("loss_factor", &format!("{:?}", damper.loss_factor));
            }
        }
        for pendulum in &design.pendulums {
            self.header("[[pendulum]]", "");
            self.entry("throw", &(pendulum.throw + 1).to_string());
            self.entry("mass", &quantity(pendulum.mass, Dimension::Mass));
            self.entry("pivot_radius", &quantity(pendulum.pivot_radius, Dimension::Length));
            self.entry("length", &quantity(pendulum.length, Dimension::Length));
            self.entry("number", &pendulum.number.to_string());
            self.entry_unless_zero("damping", pendulum.damping, Dimension::AngularDamping);
        }
    }

    fn torsion_keys(&mut self, design: &TorsionDesign) {
        self.header("[torsion]", "");
        if !design.stiffness.is_empty() {
            let list: Vec<String> =
                design.stiffness.iter().map(|value| quantity(*value, Dimension::AngularStiffness)).collect();
            self.entry("stiffness", &format!("[{}]", list.join(", ")));
        }
        let dampings = [("absolute", design.absolute_damping), ("relative", design.relative_damping)];
        let mut damping: Vec<String> = dampings
            .iter()
            .filter_map(|(key, value)| {
                Some(format!("{key} = {}", quantity((*value)?, Dimension::AngularDamping)))
            })
            .collect();
        damping.extend(design.loss_factor.map(|loss| format!("loss_factor = {loss:?}")));
        if !damping.is_empty() {
            self.entry("damping", &format!("{{ {} }}", damping.join(", ")));
        }
        if let Some(inertia) = design.nose_inertia {
            self.entry("nose_inertia", &quantity(inertia, Dimension::Inertia));
        }
        if design.gears != GearEnd::default() {
            self.entry("gears", &quoted(design.gears.word()));
        }
        if let Some(order) = design.highest_order {
            self.entry("highest_order", &format!("{order:?}"));
        }
        if let Some(limit) = design.twist_limit {
            self.entry("twist_limit", &quantity(limit, Dimension::Angle));
        }
        if let Some(limit) = design.stress_limit {
            self.entry("stress_limit", &quantity(limit, Dimension::Pressure));
        }
        for branch in &design.branches {
            self.header("[[torsion.branch]]", "");
            self.entry("name", &quoted(&branch.name));
            let at = match branch.at {
                BranchPlace::Nose => "nose".to_owned(),
                BranchPlace::Flywheel => "flywheel".to_owned(),
                BranchPlace::Throw(throw) => format!("throw {}", throw + 1),
                BranchPlace::Branch(index) => {
                    design.branches.get(index).map_or_else(String::new, |other| other.name.clone())
                }
            };
            self.entry("at", &quoted(&at));
            self.entry("inertia", &quantity(branch.inertia, Dimension::Inertia));
            self.entry("stiffness", &quantity(branch.stiffness, Dimension::AngularStiffness));
            self.entry_unless_zero("damping", branch.damping, Dimension::AngularDamping);
            self.entry("ratio", &format!("{:?}", branch.ratio));
        }
    }
}
