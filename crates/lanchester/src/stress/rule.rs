//! Strength of a crankshaft by the formulas after UR M53: sizes from the engine, forces of the closed form.

use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::{BearingPart, BearingRequest, ThrowForce, TorqueError, throw_forces};
use lanchester_model::{Engine, MaterialPreset, Origin};
use lanchester_report::{CRANK_RULE_VERSION, CrankRule, SpeedSheet};
use lanchester_strength::{
    Need, RULE_WORDS, RuleMaterial, RuleThrow, StrengthError, ThrowLoad, rule_sheet, rule_throws,
};
use std::f64::consts::{PI, TAU};

/// Steps in which the extremes of forces and torques are sought [rad].
const STEP: f64 = PI / 360.0;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct RuleRequest {
    /// Index of the crankshaft.
    pub crankshaft: usize,
    /// Speeds of crankshaft 1 [rad/s]; none: the lowest and the highest of the engine.
    pub speeds: Vec<f64>,
    /// Whether the gas of the file acts.
    pub gas: bool,
    /// Amplitude of the torque that torsional vibration adds to that of a rigid crankshaft [N m]: one for all throws or one for each along the
    /// crankshaft; none: no torsional vibration.
    pub vibration: Vec<f64>,
}

impl Default for RuleRequest {
    /// Crankshaft 1 with the gas of the file, without torsional vibration.
    fn default() -> RuleRequest {
        RuleRequest { crankshaft: 0, speeds: Vec::new(), gas: true, vibration: Vec::new() }
    }
}

/// Why there is no sheet.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CrankRuleError {
    /// Sizes or strengths.
    #[error(transparent)]
    Strength(#[from] StrengthError),
    /// No pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// No loads from them.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// Amplitudes that do not fit the throws.
    #[error("torsional vibration needs one amplitude, or one for each of {throws} throws, got {got}")]
    Vibration {
        /// Throws of the crankshaft.
        throws: usize,
        /// Amplitudes given.
        got: usize,
    },
}

/// Whether an engine gives what the sheet begins with: a body with fillets, and a material.
pub(crate) fn has_rule(engine: &Engine) -> bool {
    let strength = engine.crank_material.as_ref().and_then(|material| material.tensile_strength());
    let fillets = engine.crank_details.as_ref().is_some_and(|details| {
        let given = |radius: Option<f64>| radius.is_some_and(|radius| radius > 0.0);
        given(details.pin_fillet.radius) && given(details.journal_fillet.radius)
    });
    engine.crank_body.is_some() && fillets && strength.is_some()
}

/// The sheet of a crankshaft; `traces` holds the files that [`crate::trace_names`] names.
///
/// # Errors
/// [`CrankRuleError`] where the file says too little, all at once. A ratio outside the range of the formulas is no error but part of the sheet.
pub fn crank_rule(
    engine: &Engine,
    traces: &[TraceFile],
    request: &RuleRequest,
) -> Result<CrankRule, CrankRuleError> {
    crank_rule_of_size(engine, traces, request, [1.0, 1.0])
}

/// The sheet of a similar engine: its lengths over those of `engine`, and the speed of `engine` over its own at which its pistons are as fast. Speeds of
/// the request are those of `engine`; pressures over the crank angle are those at its own speed.
///
/// # Errors
/// As [`crank_rule`].
pub(crate) fn crank_rule_of_size(
    engine: &Engine,
    traces: &[TraceFile],
    request: &RuleRequest,
    [length, speed_of_original]: [f64; 2],
) -> Result<CrankRule, CrankRuleError> {
    let material = engine.crank_material.unwrap_or_default();
    let tensile = material.tensile_strength();
    let mut needs = Vec::new();
    if tensile.is_none() {
        needs.push(Need {
            place: "material".to_owned(),
            what: "the tensile strength is needed, it is not given".to_owned(),
            remedy: "give tensile_strength or a preset in [crank.material]".to_owned(),
        });
    }
    let throws = match rule_throws(engine, request.crankshaft) {
        Ok(throws) => throws.into_iter().map(|throw| throw.scaled(length)).collect(),
        Err(StrengthError::Needs { needs: others, .. }) => {
            needs.extend(others);
            Vec::new()
        }
        Err(error) => return Err(error.into()),
    };
    let Some(tensile) = tensile.filter(|_| needs.is_empty()) else {
        return Err(StrengthError::Needs { crankshaft: request.crankshaft + 1, needs }.into());
    };
    let vibration = match request.vibration.as_slice() {
        [] => vec![0.0; throws.len()],
        [all] => vec![*all; throws.len()],
        each if each.len() == throws.len() => each.to_vec(),
        other => return Err(CrankRuleError::Vibration { throws: throws.len(), got: other.len() }),
    };
    let mut speeds = request.speeds.clone();
    if speeds.is_empty() {
        speeds = vec![engine.speed.lowest, engine.speed.highest];
        speeds.dedup();
    }
    let forging = material.forging_factor();
    let numbers = RuleMaterial { tensile_strength: tensile.value, forging: forging.value };
    let (mut sheets, mut source) = (Vec::new(), None);
    for speed in speeds {
        let gas = match &engine.gas {
            Some(_) if request.gas => Some(cylinder_gas(engine, traces, speed / speed_of_original)?),
            _ => None,
        };
        let cylinders = gas.as_ref().map(|gas| gas.cylinders.as_slice());
        let part = if gas.is_some() { BearingPart::All } else { BearingPart::Inertia };
        let asked = BearingRequest { speed: Some(speed), part, ..BearingRequest::default() };
        let period = TAU * f64::from(engine.strokes.revolutions());
        let count = (period / STEP).round() as usize;
        let theta: Vec<f64> = (0..count).map(|k| period * k as f64 / count as f64).collect();
        let over = throw_forces(engine, cylinders, &asked, request.crankshaft, &theta)?;
        let loads: Vec<ThrowLoad> = throws
            .iter()
            .zip(&vibration)
            .map(|(throw, extra)| load_of(throw, *extra, length, &over))
            .collect();
        sheets.push(SpeedSheet { speed, throws: rule_sheet(&throws, &loads, numbers)? });
        source = gas.map(|gas| gas.source).or(source);
    }
    Ok(CrankRule {
        version: CRANK_RULE_VERSION,
        engine: engine.name.clone(),
        crankshaft: request.crankshaft + 1,
        rule: RULE_WORDS.to_owned(),
        tensile_strength: tensile,
        forging,
        acceptable: lanchester_strength::ACCEPTABLE,
        gas: source,
        speeds: sheets,
        by_elements: Vec::new(),
        notes: notes(engine, request),
    })
}

/// Forces grow with the square of the lengths.
fn load_of(throw: &RuleThrow, vibration: f64, length: f64, over: &[Vec<ThrowForce>]) -> ThrowLoad {
    let square = length * length;
    let own = || over.iter().filter_map(|forces| forces.iter().find(|force| force.throw == throw.throw));
    ThrowLoad {
        radial: own().map(|force| square * force.radial).collect(),
        tangential: own().map(|force| square * force.tangential).collect(),
        vibration,
    }
}

fn notes(engine: &Engine, request: &RuleRequest) -> Vec<String> {
    let mut notes = vec![
        "Each throw stands on the two main bearings beside it; forces of the rods act in the middle of its pin. Mean stresses are left out, and with \
         them centrifugal forces of the crankshaft and its counterweights. The web's width is that of the plain web in the middle of the overlap, \
         without counterweights."
            .to_owned(),
    ];
    notes.push(match request.vibration.is_empty() {
        true => "Torque is that of a rigid crankshaft at constant speed, which leaves at the flywheel, throw by throw. Torsional vibration is left out: the \
                 rule wants it, and the torque of the most loaded section for all throws."
            .to_owned(),
        false => "Torque is that of a rigid crankshaft at constant speed, which leaves at the flywheel, throw by throw, plus the amplitude of torsional vibration \
                  as given."
            .to_owned(),
    });
    let material = engine.crank_material.unwrap_or_default();
    if material.forging_factor().origin == Origin::Assumed {
        notes.push(
            "Forging is not given: K of free form forging. Give forging in [crank.material].".to_owned(),
        );
    }
    if material.preset == Some(MaterialPreset::DuctileIron) {
        notes.push("The rule is for forged and cast steel; this crankshaft is of cast iron.".to_owned());
    }
    notes
}
