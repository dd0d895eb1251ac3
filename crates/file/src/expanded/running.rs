//! `[friction]`, `[flywheel]`, `[bearings]` and `[tolerances]`.

use super::text::{File, quantity};
use lanchester_model::Engine;
use lanchester_model::Friction;
use lanchester_task::{Distribution, Extent, Tasks};
use lanchester_units::Dimension;

impl File {
    pub(super) fn friction(&mut self, engine: &Engine, tasks: &Tasks) {
        let damping = tasks.simulation.as_ref().and_then(|input| input.piston_damping);
        if engine.friction.is_some() || damping.is_some() {
            self.header("[friction]", "");
        }
        if let Some(damping) = damping {
            self.entry("piston_damping", &quantity(damping, Dimension::Damping));
        }
        let Some(friction) = engine.friction else { return };
        match friction {
            Friction::Given { fmep } => self.entry("fmep", &quantity(fmep, Dimension::Pressure)),
            Friction::ChenFlynn { constant, peak_pressure, speed, speed_squared } => {
                self.entry("constant", &quantity(constant, Dimension::Pressure));
                self.entry("peak_pressure", &format!("{peak_pressure:?}"));
                self.entry("speed", &quantity(speed, Dimension::PressurePerSpeed));
                self.entry("speed_squared", &quantity(speed_squared, Dimension::PressurePerSpeedSquared));
            }
        }
    }

    pub(super) fn flywheel(&mut self, engine: &Engine) {
        let Some(flywheel) = &engine.flywheel else { return };
        self.header("[flywheel]", "");
        let inertias = [("inertia", flywheel.inertia), ("crankshaft_inertia", flywheel.crankshaft_inertia)];
        for (key, inertia) in inertias {
            if let Some(inertia) = inertia {
                self.entry(key, &quantity(inertia, Dimension::Inertia));
            }
        }
        if let Some(fluctuation) = flywheel.fluctuation {
            self.entry("fluctuation", &format!("{fluctuation:?}"));
        }
        if !flywheel.speeds.is_empty() {
            let list: Vec<String> =
                flywheel.speeds.iter().map(|&speed| quantity(speed, Dimension::Speed)).collect();
            self.entry("speeds", &format!("[{}]", list.join(", ")));
        }
    }

    pub(super) fn tolerances(&mut self, tasks: &Tasks) {
        for (extent, header) in [(Extent::PerPart, "tolerances"), (Extent::Common, "tolerances.common")] {
            for tolerance in tasks.tolerances.iter().filter(|tolerance| tolerance.extent == extent) {
                self.header(&format!("[{header}.{}]", tolerance.quantity.key()), "");
                self.entry("plus_minus", &quantity(tolerance.half_width, tolerance.quantity.dimension()));
                match tolerance.distribution {
                    Distribution::Uniform => self.entry("distribution", "\"uniform\""),
                    Distribution::Normal { sigmas } => self.entry("sigmas", &format!("{sigmas:?}")),
                }
            }
        }
    }
}
