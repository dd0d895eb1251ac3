//! The block and its mounts as an engine file.

use super::text::{File, quantity, quoted};
use lanchester_model::Engine;
use lanchester_model::MovingParts;
use lanchester_model::{FRAME_AXES, MountSpring};
use lanchester_units::Dimension;
use std::fmt::Write;

impl File {
    pub(super) fn mounts(&mut self, engine: &Engine) {
        self.block(engine);
        for mount in &engine.mounts {
            self.header("[[mount]]", "");
            self.entry("name", &quoted(&mount.name));
            for (key, value) in [("x", mount.x), ("y", mount.y), ("z", mount.z)] {
                self.entry(key, &quantity(value, Dimension::Length));
            }
            if let Some(spring) = &mount.spring {
                self.spring(spring);
            }
        }
    }

    fn block(&mut self, engine: &Engine) {
        let Some(block) = &engine.block else { return };
        self.header("[block]", "");
        self.entry("mass", &quantity(block.mass, Dimension::Mass));
        self.entry("centre", &list(&block.centre, Dimension::Length));
        let inertia = [block.inertia, block.products].concat();
        let given = if block.products == [0.0; 3] { &inertia[..3] } else { &inertia[..] };
        self.entry("inertia", &list(given, Dimension::Inertia));
        let added = block.moving_parts == MovingParts::Added;
        self.entry("moving_parts", if added { "\"added\"" } else { "\"included\"" });
        self.entry("gravity", &components(block.gravity));
        self.entry("driveline_torque", &list(&block.driveline_torque, Dimension::Torque));
    }

    fn spring(&mut self, spring: &MountSpring) {
        self.entry("stiffness", &list(&spring.stiffness, Dimension::Stiffness));
        if spring.axes != FRAME_AXES {
            self.entry("direction", &components(spring.axes[0]));
            self.entry("second_direction", &components(spring.axes[1]));
        }
        if spring.damping != [0.0; 3] {
            self.entry("damping", &list(&spring.damping, Dimension::Damping));
        }
        if spring.loss_factor != [0.0; 3] {
            self.entry("loss_factor", &components(spring.loss_factor));
        }
        self.entry_unless_zero("preload", spring.preload, Dimension::Force);
        if spring.table.is_empty() {
            return;
        }
        let mut table = String::new();
        for point in &spring.table {
            // Writing to a string cannot fail.
            let _ = writeln!(
                table,
                "    {{ frequency = {}, stiffness = {}, loss_factor = {} }},",
                quantity(point.angular_frequency, Dimension::Speed),
                list(&point.stiffness, Dimension::Stiffness),
                components(point.loss_factor)
            );
        }
        self.entry("table", &format!("[\n{table}]"));
    }
}

fn list(values: &[f64], dimension: Dimension) -> String {
    let values: Vec<String> = values.iter().map(|&value| quantity(value, dimension)).collect();
    format!("[{}]", values.join(", "))
}

/// Bare numbers that read back as they are.
fn components(values: [f64; 3]) -> String {
    let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
    format!("[{}]", values.join(", "))
}
