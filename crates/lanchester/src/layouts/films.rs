//! Films and safeties of layouts: layouts with the bearings, the oil, the gas and the crankshaft's sizes of an engine.

use crate::durability::{DurabilityRequest, EngineDurability};
use crate::layouts::search::holds_for_any_layout;
use crate::pressure::measured::TraceFile;
use lanchester_model::{BearingDesign, Engine, Fault, SpeedRange};
use lanchester_study::explore::{LayoutMeter, Parts};
use lanchester_task::{DurabilityCriterion, DurabilityMeter, Measured, Unmeasured};
use std::sync::Arc;

/// Tells films and safeties of layouts made of the parts of `engine`, of so many at most. Layouts have its bearings and oil (those that differ from the rest
/// left out), its gas where that is computed, and a crankshaft of its sizes; they are judged at its lowest speed and at that of the search.
pub fn layout_meter(engine: &Engine, traces: Vec<TraceFile>, parts: &Parts, most: u64) -> LayoutMeter {
    let meter = EngineDurability::of_files(traces, DurabilityRequest::default());
    LayoutMeter::new(Arc::new(OfLayouts { engine: engine.clone(), parts: *parts, meter }), most)
}

struct OfLayouts {
    engine: Engine,
    parts: Parts,
    meter: EngineDurability<'static>,
}

impl DurabilityMeter for OfLayouts {
    fn measure(&self, layout: &Engine, criteria: &[DurabilityCriterion]) -> Vec<Measured> {
        let own = &self.engine;
        let is_split = layout.throws.len() != layout.main_bearings().len().saturating_sub(1);
        let dressed = layout.with(|parts| {
            parts.name.clone_from(&own.name);
            parts.rotation = own.rotation;
            parts.speed =
                SpeedRange { lowest: own.speed.lowest.min(self.parts.speed), highest: self.parts.speed };
            parts.gas = own.gas.as_ref().filter(|gas| holds_for_any_layout(gas)).cloned();
            parts.bearings = own.bearings;
            parts.bearing_design = own.bearing_design.clone().map(|design| BearingDesign {
                main_each: Vec::new(),
                crankpin_each: Vec::new(),
                ..design
            });
            parts.crank_body = own.crank_body;
            parts.crank_details = own.crank_details.clone();
            parts.crank_material = own.crank_material;
            if !is_split {
                for throw in parts.throws.iter_mut().filter(|throw| throw.webs.is_none()) {
                    throw.webs = Some([-0.5, 0.5].map(|side| throw.z + side * self.parts.web_distance));
                }
            }
        });
        match dressed {
            Ok(engine) => self.meter.measure(&engine, criteria),
            Err(faults) => {
                let fault = Fault::first_of(faults);
                let why = Unmeasured {
                    reason: format!("the layout with the bearings of {} is no engine: {fault}", own.name),
                    remedy: "give sizes of bearings in [bearings.main] and [bearings.crankpin]".into(),
                };
                criteria.iter().map(|_| Measured::Unknown(why.clone())).collect()
            }
        }
    }
}
