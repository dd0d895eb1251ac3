//! Gas and friction.

use super::sizes::Sizes;
use super::words::{Block, number, quantity};
use super::{Found, From};

impl From<'_> {
    pub(super) fn gas(&self, sizes: &Sizes<'_>) -> Found {
        if sizes.engine.gas.is_some() {
            return Found::There;
        }
        if sizes.engine.cylinders.iter().any(|cylinder| cylinder.bore.is_none()) {
            return Found::Not("it needs the bore of every cylinder".into());
        }
        if sizes.engine.cylinders.iter().any(|cylinder| cylinder.firing_angle.is_none()) {
            return Found::Not("it needs the firing order".into());
        }
        let ratios = sizes.ratios;
        let energy = sizes.energy() * sizes.swept / sizes.firings;
        // A charge without enough heat does not reach the usual peak at constant volume.
        let compressed = ratios.intake * ratios.compression_ratio.powf(1.4);
        let rise = 0.4 * sizes.energy() * (ratios.compression_ratio - 1.0);
        let peak = ratios.peak.min(compressed + 0.7 * rise);
        let of = format!("of {}", self.kind.engine());
        let gas = Block::new("[gas]", format!("one ideal cycle {of} at full load, the same at every speed."))
            .line("compression_ratio", number(ratios.compression_ratio, 3), &of);
        let cycle = Block::new("[gas.cycle]", "")
            .line(
                "type",
                "\"seiliger\"",
                "heat at constant volume up to the peak pressure, then at constant pressure",
            )
            .line("peak_pressure", quantity(peak, "bar", 1e5, 3), &of);
        let intake = Block::new("[gas.intake]", "").line(
            "pressure",
            quantity(ratios.intake, "bar", 1e5, 3),
            if ratios.intake > 1.05e5 { "charged" } else { "not charged" },
        );
        let fuel = Block::new("[gas.fuel]", "").line(
            "energy",
            quantity(energy, "J", 1.0, 3),
            &format!("{} J for each cm3 of swept volume", number(sizes.energy() * 1e-6, 3)),
        );
        Found::Blocks(vec![gas, cycle, intake, fuel])
    }

    pub(super) fn friction(&self) -> Found {
        let engine = &self.file.engine;
        if engine.friction.is_some() {
            return Found::There;
        }
        if engine.gas.is_none() {
            return Found::Not("it needs [gas]".into());
        }
        let block = Block::new("[friction]", "the usual constants of Chen and Flynn's form.")
            .line(
                "constant",
                quantity(self.kind.ratios().friction, "bar", 1e5, 2),
                &format!("of {}", self.kind.engine()),
            )
            .line("peak_pressure", "0.005", "share of the peak pressure")
            .line("speed", "\"0.09 bar s/m\"", "for each m/s of mean piston speed")
            .line("speed_squared", "\"0.0009 bar s2/m2\"", "");
        Found::Blocks(vec![block])
    }
}
