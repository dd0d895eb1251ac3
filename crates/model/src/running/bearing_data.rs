//! All that is known of one bearing of an engine.

use crate::engine_parts::EngineParts;
use crate::running::bearing_design::BearingData;
use crate::running::bearings::PlainBearing;

impl EngineParts {
    /// All that is known of main bearing `index`, counted as [`EngineParts::main_bearings`]: its own data over those of all, with the
    /// width of `[bearings.main]`.
    pub fn main_bearing_data(&self, index: usize) -> BearingData {
        let size = self.bearings.and_then(|bearings| bearings.main);
        let Some(design) = &self.bearing_design else { return sized(BearingData::default(), size) };
        let own = design.main_each.iter().find(|(own, _)| *own == index);
        sized(own.map_or_else(|| design.main.clone(), |(_, own)| own.over(&design.main)), size)
    }

    /// All that is known of the crankpin bearing of cylinder `index`: its own data over those of all, with the width of
    /// `[bearings.crankpin]`.
    pub fn crankpin_bearing_data(&self, index: usize) -> BearingData {
        let size = self.bearings.and_then(|bearings| bearings.crankpin);
        let Some(design) = &self.bearing_design else { return sized(BearingData::default(), size) };
        let own = design.crankpin_each.iter().find(|(own, _)| *own == index);
        sized(own.map_or_else(|| design.crankpin.clone(), |(_, own)| own.over(&design.crankpin)), size)
    }
}

fn sized(data: BearingData, size: Option<PlainBearing>) -> BearingData {
    BearingData { width: data.width.or(size.map(|size| size.width)), ..data }
}
