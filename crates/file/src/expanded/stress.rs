//! `[crank.mesh]` and `[[stress.case]]`.

use super::text::{File, quantity, quoted};
use lanchester_task::{StressCaseLoad, StressSupport, Tasks};
use lanchester_units::Dimension;

impl File {
    pub(super) fn crank_mesh(&mut self, tasks: &Tasks) {
        let Some(mesh) = tasks.stress.as_ref().map(|stress| &stress.mesh) else { return };
        if mesh == &lanchester_task::MeshTask::default() {
            return;
        }
        self.header("[crank.mesh]", "");
        if let Some(size) = mesh.size {
            self.entry("size", &quantity(size, Dimension::Length));
        }
        if let Some(count) = mesh.fillet_elements {
            self.entry("fillet_elements", &count.to_string());
        }
        if let Some(file) = &mesh.file {
            self.entry("file", &quoted(file));
        }
    }

    pub(super) fn stress_cases(&mut self, tasks: &Tasks) {
        for case in tasks.stress.iter().flat_map(|stress| &stress.cases) {
            self.header("[[stress.case]]", "");
            self.entry("name", &quoted(&case.name));
            match &case.load {
                StressCaseLoad::Angle { angle } => {
                    if case.crankshaft > 0 {
                        self.entry("crankshaft", &(case.crankshaft + 1).to_string());
                    }
                    self.entry("angle", &quantity(*angle, Dimension::Angle));
                }
                StressCaseLoad::Forces { forces, angle } => {
                    let force = |own: &lanchester_task::CasePinForce| {
                        let [radial, tangential] =
                            [own.radial, own.tangential].map(|force| quantity(force, Dimension::Force));
                        format!("{{ pin = {}, radial = {radial}, tangential = {tangential} }}", own.throw + 1)
                    };
                    let list: Vec<String> = forces.iter().map(force).collect();
                    self.entry("force", &format!("[{}]", list.join(", ")));
                    if let Some(angle) = angle {
                        self.entry("angle", &quantity(*angle, Dimension::Angle));
                    }
                }
            }
            if let Some(speed) = case.speed {
                self.entry("speed", &quantity(speed, Dimension::Speed));
            }
            self.entry("support", &quoted(case.support.word()));
            match &case.support {
                StressSupport::Rings { thickness, modulus } => {
                    if let Some(thickness) = thickness {
                        self.entry("ring_thickness", &quantity(*thickness, Dimension::Length));
                    }
                    if let Some(modulus) = modulus {
                        self.entry("ring_modulus", &quantity(*modulus, Dimension::Pressure));
                    }
                }
                StressSupport::Springs { stiffness } => {
                    let one = |[x, y]: &[f64; 2]| {
                        let [along, across] = [*x, *y].map(|k| quantity(k, Dimension::Stiffness));
                        if x == y { along } else { format!("{{ x = {along}, y = {across} }}") }
                    };
                    let list: Vec<String> = stiffness.iter().map(one).collect();
                    self.entry("stiffness", &format!("[{}]", list.join(", ")));
                }
                StressSupport::ClampedEnds
                | StressSupport::Journals
                | StressSupport::Film
                | StressSupport::Free => {}
            }
        }
    }
}
