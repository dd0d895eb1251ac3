//! Engines and cycles of the tests.
#![allow(dead_code, reason = "each test file uses a part of it")]

use lanchester_cycle::CylinderVolume;
use lanchester_model::{Engine, Gas, GasCycle, GasSource};

/// A single with this `[gas]`; `offset` moves its cylinder.
pub fn engine(strokes: u32, offset: &str, gas: &str) -> Engine {
    let text = format!(
        "name = \"single\"\nspeed = \"3000 rpm\"\nstrokes = {strokes}\n[layout]\ntype = \"in-line\"\ncylinders = 1\n\
         [cylinders]\noffset = \"{offset}\"\n[crank]\nstroke = \"85 mm\"\n[piston]\nmass = \"0.4 kg\"\nbore = \"86 mm\"\n\
         [rod]\nlength = \"150 mm\"\nmass = \"0.5 kg\"\n{gas}"
    );
    let reading = lanchester_file::read(&text);
    let shown = lanchester_file::render(&reading.diagnostics, "single.toml", &text, false);
    reading.engine().unwrap_or_else(|| panic!("{shown}"))
}

pub fn cycle_of(engine: &Engine) -> &GasCycle {
    match &engine.gas {
        Some(Gas { source: GasSource::Cycle(cycle), .. }) => cycle,
        other => panic!("no cycle: {other:?}"),
    }
}

pub fn volume_of(engine: &Engine) -> CylinderVolume {
    let ratio = match &engine.gas {
        Some(Gas { source: GasSource::Cycle(cycle), .. }) => Some(cycle.compression_ratio),
        _ => None,
    };
    CylinderVolume::of_engine(engine, ratio).expect("a volume").remove(0)
}
