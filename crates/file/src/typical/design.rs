//! Free weights, shapes of counterweights and shaft weights, and what they must stay clear of.

use super::sizes::Sizes;
use super::words::{Block, list, mm, quantity};
use super::{Found, From};
use lanchester_model::SharedWeb;

/// Clearance that is wanted [m], over the bore.
const CLEAR: f64 = 0.015;

/// Room for counterweights.
struct Room {
    /// Radius that a counterweight may have [m].
    arc: f64,
    /// From the piston pin to the lower edge of the skirt [m].
    skirt: f64,
}

impl Room {
    /// The skirt is as short as the counterweights need, within what pistons have.
    fn of(sizes: &Sizes<'_>) -> Room {
        let wanted = sizes.unbalance_of_web();
        let disc = web_radius(sizes);
        let density = 7200.0;
        // First moment of half a ring from the disc of the web outwards: 2/3 (R^3 - r^3).
        let needed = (disc.powi(3) + 1.5 * 1.3 * wanted / (density * sizes.web)).cbrt();
        let dead = sizes.rod - sizes.radius;
        let clear = CLEAR * sizes.bore;
        let skirt = (dead - clear - 1.06 * needed).clamp(0.1 * sizes.bore, 0.4 * sizes.bore);
        Room { arc: dead - clear - skirt, skirt }
    }
}

/// Radius of the disc of a web [m].
fn web_radius(sizes: &Sizes<'_>) -> f64 {
    sizes.engine.crank_body.as_ref().map_or(0.62 * sizes.journal, |body| body.web_radius)
}

impl From<'_> {
    /// Whether a counterweight of the file is a weight of its own, not of the short form.
    fn has_own_weights(&self) -> bool {
        self.has("counterweight")
    }

    pub(super) fn balance(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if self.has("balance") {
            return Found::There;
        }
        if self.has_own_weights() {
            return Found::Not(
                "the counterweights of the file are free without it, by their own names".into(),
            );
        }
        let at_throws = engine.counterweights.iter().any(|weight| weight.name.starts_with("throw"));
        let on_webs = !at_throws
            && engine.throws.iter().all(|throw| throw.webs.is_some())
            && SharedWeb::all(&engine.throws).is_empty();
        let (key, count) = if on_webs { ("webs", 2.0) } else { ("throws", 1.0) };
        let of_throw = |index: usize| {
            let throw = &engine.throws[index];
            let cylinders = engine.cylinders.iter().filter(|c| c.throw == index);
            let masses: f64 = cylinders.map(|c| c.piston_mass + c.rod.mass()).sum();
            throw.unbalance + masses * throw.radius
        };
        let all = (0..engine.throws.len()).map(of_throw).fold(0.0_f64, f64::max);
        let weight = format!(
            "[{{ {key} = \"all\", radius = {}, most = {} }}]",
            mm(0.6 * sizes.bore),
            quantity(1.2 * all / count, "kg mm", 1e-3, 2)
        );
        let block = Block::new("[balance]", "what is free, and what is wanted.")
            .line("minimise", "[\"force\", \"couple\"]", "force first, then couple")
            .line("counterweight", weight, "1.2 times all that moves at a throw is the most");
        Found::Blocks(vec![block])
    }

    pub(super) fn counterweight_design(&self, sizes: &Sizes<'_>) -> Found {
        if self.has("counterweight_design") {
            return Found::There;
        }
        if sizes.engine.throws.iter().any(|throw| throw.webs.is_none()) {
            return Found::Not("it needs the web distance of every throw".into());
        }
        let room = Room::of(sizes);
        let disc = web_radius(sizes);
        let body = sizes.engine.crank_body.as_ref();
        let thickness = body.map_or(sizes.web, |body| body.web_thickness);
        let mut block = Block::new(
            "[counterweight_design]",
            "shapes within the room below the pistons, as thick as the webs.",
        )
        .line("minimise", "\"mass\"", "");
        if body.is_none() {
            block =
                block.line("density", "\"7850 kg/m3\"", "steel").line("web_radius", mm(disc), "0.62 journal");
        }
        let least = (0.7 * disc).max(0.3 * room.arc).min(0.9 * room.arc);
        let block = block
            .line("rectangle_height", list(&[mm(0.0), mm(0.6 * room.arc)]), "up to 0.6 of the largest radius")
            .line("shoulder_height", list(&[mm(0.0), mm(0.4 * room.arc)]), "up to 0.4 of the largest radius")
            .line(
                "arc_radius",
                list(&[mm(least), mm(room.arc)]),
                "up to the pistons at their lower dead centre",
            )
            .line("arc_angle", "[\"40 deg\", \"210 deg\"]", "")
            .line("thickness", mm(thickness), "of the web");
        Found::Blocks(vec![block])
    }

    pub(super) fn clearance(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if self.has("clearance") {
            return Found::There;
        }
        let room = Room::of(sizes);
        let clear = CLEAR * sizes.bore;
        let big_end = 0.72 * sizes.pin;
        let case = (sizes.radius + big_end).max(room.arc) + 4.0 * clear;
        let mut block =
            Block::new("[clearance]", "crankcase, pistons and rods scaled to stroke, bore and crankpin.")
                .line("least", mm(clear), "0.015 bore")
                .line("crankcase_radius", mm(case), "around big ends and counterweights");
        if engine.cylinders.iter().all(|cylinder| cylinder.bore.is_some()) {
            block = block
                .line(
                    "skirt_length",
                    mm(room.skirt),
                    "from 0.1 to 0.4 bore, as short as the counterweights need",
                )
                .line("skirt_width", mm(0.55 * sizes.bore), "0.55 bore");
        }
        let block = block
            .line("big_end_radius", mm(big_end), "0.72 crankpin")
            .line("big_end_width", mm(sizes.rod_width()), "nearly the pin, shared by the rods on it")
            .line("shank_width", mm(0.5 * sizes.pin), "0.5 crankpin")
            .line("shank_thickness", mm(0.6 * sizes.rod_width()), "0.6 of the big end");
        Found::Blocks(vec![block])
    }

    pub(super) fn shaft_weight_design(&self) -> Found {
        let engine = &self.file.engine;
        if self.has("shaft_weight_design") {
            return Found::There;
        }
        let most = engine.shafts.iter().flat_map(|s| &s.weights).map(|w| w.unbalance).fold(0.0_f64, f64::max);
        if most <= 0.0 {
            return Found::Not("the engine has no balance shafts".into());
        }
        // Half a disc of radius R and length L has 2/3 R^3 L times the density: with L = R, R = (1.5 U / density)^(1/4).
        let radius = (1.5 * most / 7850.0).powf(0.25);
        let block = Block::new("[shaft_weight_design]", "half discs about as long as their radius.")
            .line("minimise", "\"mass\"", "")
            .line("density", "\"7850 kg/m3\"", "steel")
            .line("shaft_diameter", mm(0.7 * radius), "0.7 of that radius")
            .line(
                "radius",
                list(&[mm(0.8 * radius), mm(1.3 * radius)]),
                "0.8 to 1.3 of the radius of half a disc as long as it",
            )
            .line("chord", list(&[mm(-0.2 * radius), mm(0.2 * radius)]), "")
            .line("length", list(&[mm(0.3 * radius), mm(2.5 * radius)]), "");
        Found::Blocks(vec![block])
    }
}
