//! `[crank.material]`: what the crankshafts are made of.

use crate::document::Field;
use crate::read::reader::Reader;
use lanchester_diagnostic::Mistake;
use lanchester_model::{CrankMaterial, Forging, MaterialPreset};

/// Strengths and moduli that a metal of crankshafts may have [Pa]. The formulas after UR M53 divide by the tensile strength: one in the wrong unit would
/// make any crankshaft safe.
const TENSILE_STRENGTH: [f64; 2] = [100e6, 3000e6];
const YOUNGS_MODULUS: [f64; 2] = [30e9, 500e9];

impl Reader<'_> {
    /// The material: the outer `None` says bad, the inner one absent.
    pub(in crate::read) fn crank_material(&mut self) -> Option<Option<CrankMaterial>> {
        let (crank, broken) = self.section("crank");
        let Some(crank) = crank else { return (!broken).then_some(None) };
        let section = match crank.table("material") {
            Field::Absent => return Some(None),
            Field::Bad => return None,
            Field::Given(spot) => spot.value,
        };
        let number = |key: &str| match section.number(key) {
            Field::Given(spot) => Some(Some(spot.value)),
            Field::Absent => Some(None),
            Field::Bad => None,
        };
        let preset = section.word("preset");
        let forging = section.word("forging");
        if preset.is_bad() || forging.is_bad() {
            return None;
        }
        let material = CrankMaterial {
            preset: preset
                .given()
                .and_then(|word| MaterialPreset::ALL.into_iter().find(|preset| preset.name() == word)),
            youngs_modulus: number("youngs_modulus")?,
            poisson_ratio: number("poisson_ratio")?,
            tensile_strength: number("tensile_strength")?,
            yield_strength: number("yield_strength")?,
            fatigue_bending: number("fatigue_bending")?,
            fatigue_torsion: number("fatigue_torsion")?,
            forging: forging
                .given()
                .and_then(|word| Forging::ALL.into_iter().find(|forging| forging.word() == word)),
            loss_factor: number("loss_factor")?,
            damping_ratio: number("damping_ratio")?,
        };
        if let Some(ratio) = material.poisson_ratio.filter(|ratio| *ratio >= 0.5) {
            let message = format!("`poisson_ratio` must be below 0.5, got {ratio}");
            self.mistakes.push(
                Mistake::error("E0108", section.value_span("poisson_ratio"), message)
                    .label("out of range")
                    .hint("of steel it is 0.3"),
            );
            return None;
        }
        let strengths = [
            ("tensile_strength", material.tensile_strength, TENSILE_STRENGTH),
            ("youngs_modulus", material.youngs_modulus, YOUNGS_MODULUS),
        ];
        for (key, value, [lowest, highest]) in strengths {
            let Some(value) = value.filter(|value| !(lowest..=highest).contains(value)) else { continue };
            let [value, lowest, highest] = [value, lowest, highest].map(|own| own / 1e6);
            let message = format!(
                "`{key}` is outside the accepted range [{lowest} MPa, {highest} MPa], got {value} MPa"
            );
            self.mistakes.push(
                Mistake::error("E0108", section.value_span(key), message)
                    .label("out of range")
                    .hint(format!("check its unit; {}", section.example(key))),
            );
            return None;
        }
        if let (Some(limit), Some(tensile)) = (material.yield_strength(), material.tensile_strength())
            && limit.value > tensile.value
        {
            let [limit, tensile] = [limit, tensile].map(|of| format!("{} MPa", of.value / 1e6));
            let key = if section.has("yield_strength") { "yield_strength" } else { "tensile_strength" };
            let message = format!("the yield strength of {limit} is above the tensile strength of {tensile}");
            self.mistakes.push(
                Mistake::error("E0108", section.value_span(key), message)
                    .hint("check both numbers and their units; the preset gives what the file does not"),
            );
            return None;
        }
        if section.has("loss_factor") && section.has("damping_ratio") {
            self.two_sources(section, "loss_factor", "damping_ratio", "the damping of the crankshaft");
            return None;
        }
        Some(Some(material))
    }
}
