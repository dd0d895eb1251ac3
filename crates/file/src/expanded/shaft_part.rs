//! Weights of balance shafts, and `[shaft_weight_design]`.

use super::part::range_text;
use super::text::{File, quantity};
use lanchester_model::ShaftWeight;
use lanchester_model::ShaftWeightPart;
use lanchester_task::{ShaftWeightAim, Tasks};
use lanchester_units::Dimension;

/// A weight of a shaft in a line of its list.
pub(super) fn weight_line(weight: &ShaftWeight) -> String {
    let unbalance = match &weight.part {
        None => Some(weight.unbalance),
        Some(part) => part.wanted,
    };
    let length = |value: f64| quantity(value, Dimension::Length);
    let entries = [
        ("z", Some(length(weight.z))),
        ("unbalance", unbalance.map(|unbalance| quantity(unbalance, Dimension::Unbalance))),
        ("phase", Some(quantity(weight.phase, Dimension::Angle))),
        ("shape", weight.part.map(|part| shaft_shape(&part, &quantity))),
    ];
    let entries =
        entries.into_iter().filter_map(|(key, value)| value.map(|value| format!("{key} = {value}")));
    format!("    {{ {} }},\n", entries.collect::<Vec<_>>().join(", "))
}

/// A shape between braces; `text` writes a quantity.
pub(crate) fn shaft_shape(part: &ShaftWeightPart, text: &dyn Fn(f64, Dimension) -> String) -> String {
    let length = |value: f64| text(value, Dimension::Length);
    let entries = [
        ("shaft_diameter", length(2.0 * part.shape.shaft_radius)),
        ("radius", length(part.shape.radius)),
        ("chord", length(part.shape.chord)),
        ("length", length(part.length)),
        ("density", text(part.density, Dimension::Density)),
    ];
    let entries = entries.map(|(key, value)| format!("{key} = {value}"));
    format!("{{ {} }}", entries.join(", "))
}

impl File {
    pub(super) fn shaft_weight_task(&mut self, tasks: &Tasks) {
        let Some(task) = &tasks.shaft_weight_task else { return };
        self.header("[shaft_weight_design]", "");
        let word = match task.minimise {
            ShaftWeightAim::Mass => "mass",
            ShaftWeightAim::Length => "length",
            ShaftWeightAim::Radius => "radius",
            ShaftWeightAim::Inertia => "inertia",
        };
        self.entry("minimise", &format!("\"{word}\""));
        self.entry("density", &quantity(task.density, Dimension::Density));
        self.entry("shaft_diameter", &quantity(2.0 * task.shaft_radius, Dimension::Length));
        for (key, range) in [("radius", task.radius), ("chord", task.chord), ("length", task.length)] {
            self.entry(key, &range_text(range, Dimension::Length));
        }
    }
}
