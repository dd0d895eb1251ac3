//! The sheet of formulas with the torsional vibration of the engine's own chain.

use crate::pressure::measured::TraceFile;
use crate::stress::rule::{CrankRuleError, RuleRequest, crank_rule, crank_rule_of_size};
use crate::torsion_study::{EngineTorsionError, Swept, TorsionRequest, driveline, speeds_between, swept};
use lanchester_file::EngineFile;
use lanchester_model::{DrivelineInertia, Engine};
use lanchester_report::CrankRule;
use lanchester_units::{Dimension, readable};
use std::collections::BTreeSet;

/// Why there is no such sheet.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RuleTorsionError {
    /// The sheet.
    #[error(transparent)]
    Rule(#[from] CrankRuleError),
    /// The chain.
    #[error(transparent)]
    Torsion(#[from] EngineTorsionError),
}

/// A speed so much beyond an end of the range is not that end's.
const NEARLY: f64 = 1.0 - 1e-9;

/// How far beside a speed the chain is looked at too.
const BESIDE: f64 = 0.02;

/// The sheet of a crankshaft; at each speed every throw has the torque that the shafts beside it in the torsional chain carry, where that is more than
/// the one of a rigid crankshaft. `request.vibration` does not count. Without speeds in the request: the lowest, the highest, and between them that of the largest torque
/// beside the throws.
///
/// # Errors
/// [`RuleTorsionError`] where the file says too little for either.
pub fn crank_rule_with_torsion(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &RuleRequest,
) -> Result<CrankRule, RuleTorsionError> {
    let chained = Chained { engine: &file.engine, driveline: driveline(file), traces, size: [1.0, 1.0] };
    let speed = file.engine.speed;
    chained.sheet(request, request.speeds.is_empty().then_some([speed.lowest, speed.highest]))
}

/// An engine whose sheet counts the torsional vibration of its chain.
pub(crate) struct Chained<'a> {
    pub engine: &'a Engine,
    pub driveline: &'a [DrivelineInertia],
    pub traces: &'a [TraceFile],
    /// Lengths of the engine whose sheet it is over those of `engine`, and the speed of `engine` over its own at which its pistons are as fast.
    pub size: [f64; 2],
}

impl Chained<'_> {
    /// The sheet, and within a range of speeds [rad/s] that of the largest torque beside the throws too.
    pub fn sheet(
        &self,
        request: &RuleRequest,
        range: Option<[f64; 2]>,
    ) -> Result<CrankRule, RuleTorsionError> {
        let rigid = RuleRequest { vibration: Vec::new(), ..request.clone() };
        let mut still = crank_rule_of_size(self.engine, self.traces, &rigid, self.size)?;
        let mut between = None;
        if let Some([low, high]) = range.filter(|[low, high]| low < high) {
            let throws =
                still.speeds.iter().flat_map(|sheet| &sheet.throws).map(|own| own.throw - 1).collect();
            let is_inside = |speed: &f64| *speed * NEARLY > low && *speed < high * NEARLY;
            let swept = self.swept(speeds_between(low, high), request)?;
            between = most_torque(&swept, &throws).filter(is_inside);
            if let Some(speed) = between {
                let there = RuleRequest { speeds: vec![speed], ..rigid };
                let there = crank_rule_of_size(self.engine, self.traces, &there, self.size)?;
                still.speeds.extend(there.speeds);
                still.speeds.sort_by(|a, b| a.speed.total_cmp(&b.speed));
            }
        }
        let mut whole: Option<CrankRule> = None;
        for sheet in &still.speeds {
            let speed = sheet.speed;
            let speeds = vec![speed * (1.0 - BESIDE), speed, speed * (1.0 + BESIDE)];
            let found = self.swept(speeds, request)?;
            let volume = self.size[0].powi(3);
            let vibration: Vec<f64> = sheet
                .throws
                .iter()
                .map(|own| {
                    volume * beyond_rigid(&found, own.throw - 1, own.torques.map(|torque| torque / volume))
                })
                .collect();
            let one = RuleRequest { speeds: vec![speed], vibration, ..request.clone() };
            let mut sheet = crank_rule_of_size(self.engine, self.traces, &one, self.size)?;
            match &mut whole {
                Some(whole) => whole.speeds.append(&mut sheet.speeds),
                None => whole = Some(sheet),
            }
        }
        let mut whole = whole.unwrap_or(still);
        tell(&mut whole, between);
        Ok(whole)
    }

    fn swept(&self, speeds: Vec<f64>, request: &RuleRequest) -> Result<Swept, EngineTorsionError> {
        let asked = TorsionRequest { speeds, without_gas: !request.gas, ..TorsionRequest::default() };
        swept(self.engine, self.driveline, self.traces, &asked, self.size[1])
    }
}

/// Says what of torsional vibration counts, and why a speed was looked at.
fn tell(whole: &mut CrankRule, between: Option<f64>) {
    let words = "The amplitude of torsional vibration is that of the engine's torsional chain at each speed: what the shafts beside a throw carry in true phase of all orders beyond the \
                 torque of a rigid crankshaft.";
    whole.notes.extend(between.map(|speed| {
        format!(
            "{} lies between the lowest and the highest speed: torsional vibration has its largest torque beside the throws there.",
            readable(speed, Dimension::Speed)
        )
    }));
    match whole.notes.iter_mut().find(|note| note.contains("torsional vibration as given")) {
        Some(note) => {
            *note = note.replace(
                "plus the amplitude of torsional vibration as given.",
                "plus that of torsional vibration.",
            );
            note.push(' ');
            note.push_str(words);
        }
        None => whole.notes.push(words.to_owned()),
    }
}

/// The sheet of a crankshaft: with the torsional vibration that `request` gives, else with that of the engine's own chain, else, where the file says too little for
/// the chain, without any, and with a note that says why.
///
/// # Errors
/// [`CrankRuleError`] where the file says too little for the sheet.
pub fn crank_rule_of_file(
    file: &EngineFile,
    traces: &[TraceFile],
    request: &RuleRequest,
) -> Result<CrankRule, CrankRuleError> {
    if !request.vibration.is_empty() {
        return crank_rule(&file.engine, traces, request);
    }
    match crank_rule_with_torsion(file, traces, request) {
        Ok(sheet) => Ok(sheet),
        Err(RuleTorsionError::Rule(error)) => Err(error),
        Err(RuleTorsionError::Torsion(error)) => {
            let mut sheet = crank_rule(&file.engine, traces, request)?;
            let reason = error.to_string().replace("\nhint:", ";");
            sheet.notes.push(format!("The engine has no torsional chain of its own: {reason}."));
            Ok(sheet)
        }
    }
}

/// Speed at which a shaft beside one of these throws carries the largest torque [rad/s].
fn most_torque(found: &Swept, throws: &BTreeSet<usize>) -> Option<f64> {
    let chain = &found.crank.chain;
    let stations: Vec<usize> =
        throws.iter().filter_map(|throw| found.crank.throws.get(*throw).copied()).collect();
    let is_beside = |shaft: &&lanchester_torsion::ShaftSweep| {
        let own = &chain.shafts()[shaft.shaft];
        stations.contains(&own.from) || stations.contains(&own.to)
    };
    let shafts = found.sweep.shafts.iter().filter(is_beside);
    let torques = shafts.flat_map(|shaft| shaft.total.iter().copied().enumerate());
    let (at, _) = torques.max_by(|a, b| a.1.total_cmp(&b.1))?;
    found.speeds.get(at).copied()
}

/// What the shafts beside a throw carry beyond these torques in front and behind [N m], at the middle speed.
fn beyond_rigid(found: &Swept, throw: usize, rigid: [f64; 2]) -> f64 {
    let chain = &found.crank.chain;
    let Some(station) = found.crank.throws.get(throw).copied() else { return 0.0 };
    let of = |shaft: &lanchester_torsion::ShaftSweep| {
        let own = &chain.shafts()[shaft.shaft];
        let torque = match (own.from == station, own.to == station) {
            (true, _) => rigid[1],
            (_, true) => rigid[0],
            _ => return 0.0,
        };
        shaft.total.get(1).map_or(0.0, |total| (total - torque).max(0.0))
    };
    found.sweep.shafts.iter().map(of).fold(0.0, f64::max)
}
