//! Bores, web distance, the crankshaft as a body and its material.

use super::sizes::Sizes;
use super::words::{Block, as_written, list, mm, number, quantity};
use super::{Found, From};
use lanchester_model::{CrankBody, CrankDetails, SharedWeb, Throw, throw_unbalances};
use serde_json::Value as Json;

/// Density of steel [kg/m3].
const STEEL: f64 = 7850.0;
/// Density of cast iron with nodular graphite [kg/m3].
const IRON: f64 = 7200.0;

/// Radius of a fillet over the diameter of its pin or journal.
const FILLET: f64 = 0.06;

/// Radius of the end of a web over the diameter of its pin, the usual one first.
const ENDS: [f64; 5] = [0.7, 0.64, 0.8, 0.9, 1.0];

/// Bore of a pin over its diameter, no more than leaves it stiff.
const BORES: [f64; 6] = [0.0, 0.2, 0.3, 0.4, 0.5, 0.6];

/// How near the unbalance of the typical body must come to a given one.
const NEAR: f64 = 0.01;

impl From<'_> {
    pub(super) fn bore(&self, sizes: &Sizes<'_>) -> Found {
        if sizes.engine.cylinders.iter().all(|cylinder| cylinder.bore.is_some()) {
            return Found::There;
        }
        let ratio = number(sizes.ratios.bore_over_stroke, 3);
        let comment = format!("{ratio} times the stroke, as far as the cylinders have room for it");
        Found::Keys(vec![("piston.bore".into(), Json::from(mm(sizes.bore).trim_matches('"')), comment)])
    }

    pub(super) fn web_distance(&self, sizes: &Sizes<'_>) -> Found {
        if sizes.engine.throws.iter().all(|throw| throw.webs.is_some()) {
            return Found::There;
        }
        let comment = "rods of 0.26 bore side by side and a web of 0.22 bore, as far as there is room between the throws";
        let value = Json::from(mm(sizes.web_distance).trim_matches('"'));
        Found::Keys(vec![("crank.web_distance".into(), value, comment.into())])
    }

    /// Half of the weight of a throw on each of its webs: sums and couples stay, and the weights can be parts.
    pub(super) fn counterweight_planes(&self, sizes: &Sizes<'_>) -> Found {
        if !self.has("counterweights") || self.has("counterweights.at") {
            return Found::There;
        }
        if sizes.engine.throws.iter().any(|throw| throw.webs.is_none()) {
            return Found::Not("it needs the web distance of every throw".into());
        }
        if !SharedWeb::all(&sizes.engine.throws).is_empty() {
            return Found::Not("a web between two crankpins carries no counterweight: give them one by one, for the other webs".into());
        }
        let comment = "half on each web, where counterweights usually are; sums stay";
        Found::Keys(vec![("counterweights.at".into(), Json::from("webs"), comment.into())])
    }

    pub(super) fn crank_body(&self, sizes: &Sizes<'_>) -> Found {
        let engine = sizes.engine;
        if engine.crank_body.is_some() {
            return Found::There;
        }
        if !self.has("crank") {
            return Found::Not("the file has no [crank] to which a body could be added".into());
        }
        if engine.throws.iter().any(|throw| throw.webs.is_none()) {
            return Found::Not("it needs the web distance of every throw".into());
        }
        if sizes.web < 0.045 * sizes.bore {
            return Found::Not(format!(
                "webs of {} are all that there is room for between throws with this web distance, less than a crankshaft for a bore of {} needs",
                mm(sizes.web).trim_matches('"'),
                mm(sizes.bore).trim_matches('"')
            ));
        }
        let is_weighed = self.has("throw[0].unbalance")
            || self.entries.iter().any(|entry| {
                let key = entry.path.rsplit('.').next().unwrap_or_default();
                (entry.path.starts_with("crank.") || entry.path.starts_with("throw["))
                    && matches!(key, "unbalance" | "pin_mass" | "web_mass")
            });
        let body = match is_weighed {
            false => Some(plain(sizes, self.density())),
            true => matched(sizes, self.density(), &engine.throws),
        };
        let Some(body) = body else {
            return Found::Not(
                "no crankshaft of usual proportions has the unbalance that the masses of [crank] give; sizes of the real one are needed".into(),
            );
        };
        let comment = match is_weighed {
            true => {
                "a crankshaft scaled to bore and stroke, with webs of the unbalance that the masses of [crank] give."
            }
            false => "a crankshaft scaled to bore and stroke.",
        };
        let mut block = Block::new("[crank.body]", comment)
            .line("density", format!("\"{} kg/m3\"", number(body.density, 4)), "of the material")
            .line(
                "journal_diameter",
                mm(body.journal_diameter),
                &ratio(sizes.ratios.journal_over_bore, "bore", "at most 0.9 stroke"),
            )
            .line(
                "pin_diameter",
                mm(body.pin_diameter),
                &ratio(sizes.ratios.pin_over_bore, "bore", "at most 0.8 stroke"),
            );
        if body.pin_bore > 0.0 {
            block = block.line("pin_bore", mm(body.pin_bore), "lightens the pin to the unbalance of [crank]");
        }
        block = block
            .line(
                "web_thickness",
                mm(body.web_thickness),
                "0.22 bore, at most 0.42 of the room along the crank",
            )
            .line(
                "web_radius",
                hundredths(body.web_radius),
                if is_weighed { "for the unbalance of [crank]" } else { "0.62 journal" },
            )
            .line(
                "pin_end_radius",
                mm(body.pin_end_radius),
                &format!("{} pin", number(body.pin_end_radius / body.pin_diameter, 2)),
            )
            .line(
                "end_journals",
                list(&body.end_journals.map(mm)),
                "twice from the face of the web to the middle of the bearing, at least 0.3 journal",
            )
            .line("pin_fillet", mm(FILLET * body.pin_diameter), &format!("{FILLET} pin"))
            .line("journal_fillet", mm(FILLET * body.journal_diameter), &format!("{FILLET} journal"));
        Found::Blocks(vec![block])
    }

    /// Density of the crankshaft [kg/m3].
    fn density(&self) -> f64 {
        if self.kind.ratios().material.starts_with("EN-GJS") { IRON } else { STEEL }
    }

    pub(super) fn crank_material(&self) -> Found {
        if self.file.engine.crank_material.is_some() {
            return Found::There;
        }
        if !self.has("crank") {
            return Found::Not("the file has no [crank] to which a material could be added".into());
        }
        let material = self.kind.ratios().material;
        let mut block = Block::new(
            "[crank.material]",
            format!("what the crankshaft of {} is usually made of.", self.kind.engine()),
        )
        .line(
            "preset",
            format!("\"{material}\""),
            "its strength and elasticity are typical values too",
        );
        if !material.starts_with("EN-GJS") {
            block = block.line("forging", "\"grain-flow\"", "die forged");
        }
        Found::Blocks(vec![block])
    }
}

/// A length [m] in mm, to hundredths.
fn hundredths(length: f64) -> String {
    quantity((length * 1e5).round() / 1e5, "mm", 1e-3, 6)
}

fn ratio(of: f64, what: &str, but: &str) -> String {
    format!("{} {what}, {but}", number(of, 3))
}

/// Length of the first and the last journal [m]: twice as far as the middle of its bearing is from the face of the web.
fn end_journals(sizes: &Sizes<'_>) -> [f64; 2] {
    let engine = sizes.engine;
    let mut lengths = [0.3 * sizes.journal; 2];
    for shaft in 0..engine.crankshafts.len() {
        let mains = engine.main_planes(shaft);
        let webs =
            engine.throws.iter().filter(|throw| throw.crankshaft == shaft).filter_map(|throw| throw.webs);
        let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
        for [front, rear] in webs {
            (first, last) = (first.min(front), last.max(rear));
        }
        if let (Some(front), Some(rear)) = (mains.first(), mains.last()) {
            let reach = [first - front, rear - last].map(|reach| 2.0 * (reach - 0.5 * sizes.web));
            lengths = [lengths[0].max(reach[0]), lengths[1].max(reach[1])];
        }
    }
    lengths.map(|length| as_written(length.min(2.0 * sizes.journal)))
}

/// A body of the usual proportions.
fn plain(sizes: &Sizes<'_>, density: f64) -> CrankBody {
    CrankBody {
        density,
        journal_diameter: sizes.journal,
        journal_bore: 0.0,
        pin_diameter: sizes.pin,
        pin_bore: 0.0,
        web_thickness: sizes.web,
        web_radius: as_written(0.62 * sizes.journal),
        pin_end_radius: as_written(0.7 * sizes.pin),
        end_journals: end_journals(sizes),
    }
}

/// A body whose throws have the unbalance that the file gives: its webs are round the more, the less that is. A bored pin leaves
/// more to the webs: of all bodies that match, the one with the slimmest webs.
fn matched(sizes: &Sizes<'_>, density: f64, throws: &[Throw]) -> Option<CrankBody> {
    let usual = plain(sizes, density);
    let error = |body: &CrankBody| {
        let found = throw_unbalances(body, &CrankDetails::default(), throws).ok()?;
        let off = throws
            .iter()
            .zip(&found)
            .map(|(throw, found)| (found.unbalance - throw.unbalance) / throw.unbalance.abs());
        off.max_by(|a, b| a.abs().total_cmp(&b.abs()))
    };
    let written = |body: &CrankBody| CrankBody { web_radius: (body.web_radius * 1e5).round() / 1e5, ..*body };
    let mut slimmest: Option<CrankBody> = None;
    for (end, bore) in ENDS.into_iter().flat_map(|end| BORES.map(|bore| (end, bore))) {
        let body = CrankBody {
            pin_end_radius: as_written(end * usual.pin_diameter),
            pin_bore: as_written(bore * usual.pin_diameter),
            ..usual
        };
        let with = |radius: f64| CrankBody { web_radius: radius, ..body };
        // Beyond that radius the end of the pin lies within the disc, and the web is no hull of two.
        let round = 0.999 * (sizes.radius + body.pin_end_radius);
        let (mut small, mut large) = (0.57 * body.journal_diameter, round);
        let (Some(most), Some(least)) = (error(&with(small)), error(&with(large))) else { continue };
        if most < 0.0 || least > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (small + large);
            match error(&with(middle)) {
                Some(off) if off > 0.0 => small = middle,
                _ => large = middle,
            }
        }
        let body = written(&with(0.5 * (small + large)));
        let is_slimmer = slimmest.is_none_or(|other| body.web_radius < 0.97 * other.web_radius);
        if is_slimmer && error(&body).is_some_and(|off| off.abs() <= NEAR) {
            slimmest = Some(body);
        }
    }
    slimmest
}
