//! The block and its mounts.

use super::running::three;
use super::sizes::Sizes;
use super::words::{Block, mm, number, quantity};
use super::{Found, From};
use lanchester_model::Strokes;
use serde_json::Value as Json;
use std::f64::consts::TAU;

/// Damping of the block's bounce as a share of critical damping.
const DAMPING: f64 = 0.08;

/// The engine as a box: its least and greatest x, y and z [m].
struct Bounds([[f64; 2]; 3]);

impl Bounds {
    fn of(sizes: &Sizes<'_>) -> Bounds {
        let engine = sizes.engine;
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut hold = |point: [f64; 3]| {
            for (bound, value) in bounds.iter_mut().zip(point) {
                *bound = [bound[0].min(value), bound[1].max(value)];
            }
        };
        let case = 1.5 * sizes.radius + 0.3 * sizes.bore;
        for throw in &engine.throws {
            let shaft = &engine.crankshafts[throw.crankshaft];
            for [x, y] in [[case, 0.0], [-case, 0.0], [0.0, case], [0.0, -case]] {
                hold([shaft.x + x, shaft.y + y, throw.z]);
            }
        }
        let top = sizes.radius + sizes.rod + 0.9 * sizes.bore;
        for cylinder in &engine.cylinders {
            let Some(throw) = engine.throws.get(cylinder.throw) else { continue };
            let shaft = &engine.crankshafts[throw.crankshaft];
            let (sin, cos) = cylinder.angle.sin_cos();
            // A chamber between two pistons has no head.
            let shares = cylinder.chamber.is_some();
            let top = if shares { 0.0 } else { top };
            for side in [-0.6 * sizes.bore, 0.6 * sizes.bore] {
                for end in [-0.7 * sizes.bore, 0.7 * sizes.bore] {
                    hold([
                        shaft.x + top * cos - side * sin,
                        shaft.y + top * sin + side * cos,
                        cylinder.z + end,
                    ]);
                }
            }
        }
        Bounds(bounds)
    }

    fn middle(&self) -> [f64; 3] {
        self.0.map(|[least, most]| 0.5 * (least + most))
    }

    fn size(&self) -> [f64; 3] {
        self.0.map(|[least, most]| most - least)
    }
}

impl From<'_> {
    pub(super) fn block(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if engine.block.is_some() {
            return Found::There;
        }
        let bounds = Bounds::of(sizes);
        let [own, a_litre] = sizes.ratios.mass;
        let moving: f64 = engine.cylinders.iter().map(|c| c.piston_mass + c.rod.mass()).sum();
        // Whatever the rule says, an engine weighs several times what moves in it.
        let mass = (own + a_litre * sizes.swept * 1e3).max(6.0 * moving);
        let ([x, y, z], size) = (bounds.middle(), bounds.size());
        let about =
            |a: usize, b: usize| quantity(mass * (size[a].powi(2) + size[b].powi(2)) / 12.0, "kg m2", 1.0, 2);
        let block = Block::new("[block]", "the engine as a box around its cylinders and its crankcase.")
            .line(
                "mass",
                quantity(mass, "kg", 1.0, 2),
                &format!(
                    "{} kg and {} kg for each litre of swept volume",
                    number(own, 3),
                    number(a_litre, 3)
                ),
            )
            // The crankshaft makes the lower part heavier.
            .line(
                "centre",
                three([mm(0.8 * x), mm(y), mm(z + self.origin)]),
                "middle of the box, lower by a fifth",
            )
            .line("inertia", three([about(1, 2), about(0, 2), about(0, 1)]), "of the box");
        Found::Blocks(vec![block])
    }

    /// Bounce of the block on its mounts [Hz]: that of the kind, but well below the firings at the lowest speed.
    fn bounce(&self, sizes: &Sizes<'_>) -> f64 {
        let engine = sizes.engine;
        let revolutions = if engine.strokes == Strokes::Two { 1.0 } else { 2.0 };
        let firing = sizes.firings / revolutions * engine.speed.lowest / TAU;
        sizes.ratios.bounce.min(0.6 * firing.max(engine.speed.lowest / TAU))
    }

    pub(super) fn mounts(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        let Some(block) = &engine.block else {
            return Found::Not("it needs the mass of [block]".into());
        };
        let count = if engine.mounts.is_empty() { 4 } else { engine.mounts.len() };
        let bounce = self.bounce(sizes);
        let stiffness = block.mass * (TAU * bounce).powi(2) / count as f64;
        let damping = 2.0 * DAMPING * (stiffness * block.mass / count as f64).sqrt();
        let values = [stiffness, 0.5 * stiffness, 0.5 * stiffness].map(|k| quantity(k, "N/mm", 1e3, 2));
        let comment = format!(
            "the block bounces at {} Hz, as {} does; half as stiff across",
            number(bounce, 2),
            self.kind.engine()
        );
        if !engine.mounts.is_empty() {
            let bare = engine.mounts.iter().enumerate().filter(|(_, mount)| mount.spring.is_none());
            let stiff: Vec<&str> = values.iter().map(|value| value.trim_matches('"')).collect();
            let set = |(index, _)| {
                (format!("mount[{index}].stiffness"), Json::from(stiff.clone()), comment.clone())
            };
            let keys: Vec<(String, Json, String)> = bare.map(set).collect();
            return if keys.is_empty() { Found::There } else { Found::Keys(keys) };
        }
        let bounds = Bounds::of(sizes);
        let size = bounds.size();
        let [x, y, z] = block.centre;
        let half = [size[1].max(0.3 * size[0]), size[2].max(0.3 * size[0])].map(|size| 0.42 * size);
        let mut blocks = Vec::new();
        for (end, along) in [("front", -1.0), ("rear", 1.0)] {
            for (side, across) in [("left", -1.0), ("right", 1.0)] {
                let head = if blocks.is_empty() { "four mounts under the corners of the box." } else { "" };
                let values = values.clone();
                blocks.push(
                    Block::new("[[mount]]", head)
                        .line("name", format!("\"{end} {side}\""), "")
                        .line("x", mm(x - 0.3 * size[0]), "")
                        .line("y", mm(y + across * half[0]), "")
                        .line("z", mm(z + along * half[1] + self.origin), "")
                        .line("stiffness", three(values), if blocks.is_empty() { &comment } else { "" })
                        .line(
                            "damping",
                            quantity(damping, "N s/m", 1.0, 2),
                            if blocks.is_empty() { "8 % of critical damping of the bounce" } else { "" },
                        ),
                );
            }
        }
        Found::Blocks(blocks)
    }
}
