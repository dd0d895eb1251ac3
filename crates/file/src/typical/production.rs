//! Tolerances of a production.

use super::sizes::Sizes;
use super::words::{Block, quantity};
use super::{Found, From};

impl From<'_> {
    pub(super) fn tolerances(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if self.has("tolerances") {
            return Found::There;
        }
        let off = |value: f64, unit: &str, size: f64| {
            format!("{{ plus_minus = {} }}", quantity(value, unit, size, 2))
        };
        let largest = |of: &dyn Fn(&lanchester_model::Cylinder) -> f64| {
            engine.cylinders.iter().map(of).fold(0.0_f64, f64::max)
        };
        let mut block =
            Block::new("[tolerances]", "what a production of such parts keeps, weighed and sorted.");
        let masses: [(&str, f64, &str); 3] = [
            ("piston_mass", 0.005 * largest(&|c| c.piston_mass), "0.5 % of the piston"),
            ("big_end_mass", 0.005 * largest(&|c| c.rod.big_end_mass), "0.5 % of the big end"),
            ("small_end_mass", 0.008 * largest(&|c| c.rod.small_end_mass), "0.8 % of the small end"),
        ];
        for (key, mass, comment) in masses.into_iter().filter(|(_, mass, _)| *mass > 0.0) {
            block = block.line(key, off(mass, "g", 1e-3), comment);
        }
        block =
            block.line("crank_radius", off(6e-4 * 2.0 * sizes.radius, "mm", 1e-3), "0.0006 of the stroke");
        if engine.throws.len() > 1 {
            block =
                block.line("throw_angle", "{ plus_minus = \"0.25 deg\", distribution = \"uniform\" }", "");
        }
        let unbalance = engine.counterweights.iter().map(|w| w.unbalance).fold(0.0_f64, f64::max);
        if unbalance > 0.0 {
            block = block.line(
                "counterweight_unbalance",
                off(0.008 * unbalance, "g mm", 1e-6),
                "0.8 % of the largest counterweight",
            );
        }
        let of_shafts =
            engine.shafts.iter().flat_map(|s| &s.weights).map(|w| w.unbalance).fold(0.0_f64, f64::max);
        if of_shafts > 0.0 {
            block = block
                .line("shaft_unbalance", off(0.008 * of_shafts, "g mm", 1e-6), "0.8 % of the largest weight")
                .line(
                    "shaft_phase",
                    "{ plus_minus = \"1 deg\", distribution = \"uniform\" }",
                    "play of its drive",
                );
        }
        Found::Blocks(vec![block])
    }
}
