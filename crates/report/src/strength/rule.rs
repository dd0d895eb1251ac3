//! The sheet of formulas after UR M53 as a result.

use crate::kit::number;
use crate::kit::paragraph::push_wrapped;
use crate::kit::section::Section;
use lanchester_model::Sourced;
use lanchester_strength::{RangeBreach, ThrowSheet};
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const CRANK_RULE_VERSION: u32 = 1;

/// Strength of a crankshaft by formulas after UR M53.
///
/// Each throw on two supports, alternating stresses alone, torque of a rigid crankshaft with that of torsional vibration as given.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CrankRule {
    /// [`CRANK_RULE_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Number of the crankshaft, from 1.
    pub crankshaft: usize,
    /// Which formulas, and how far they are trusted.
    pub rule: String,
    /// Tensile strength [Pa].
    pub tensile_strength: Sourced,
    /// Factor K of the way of forging [1].
    pub forging: Sourced,
    /// Least safety that the rule accepts [1].
    pub acceptable: f64,
    /// Where the pressures come from, in words; `None`: no gas acts.
    pub gas: Option<String>,
    /// The sheet at each speed.
    pub speeds: Vec<SpeedSheet>,
    /// Meshes of the throws, where their factors by finite elements stand beside those of the formulas.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub by_elements: Vec<ThrowMesh>,
    /// What was assumed and left out.
    pub notes: Vec<String>,
}

/// The mesh of a throw between the middles of its main journals.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowMesh {
    /// Number of the throw, from 1.
    pub throw: usize,
    /// Size of its elements away from fillets [m].
    pub size: f64,
    /// Elements across the 90 degrees of a fillet.
    pub fillet_elements: usize,
    /// Its nodes.
    pub nodes: usize,
    /// Least scaled Jacobian of an element [1].
    pub least_jacobian: f64,
    /// Largest residual of the equations [1].
    pub residual: f64,
    /// Largest jump of the stress between elements over the stress, where fillets are loaded most: a sign of the error [1].
    pub jump: f64,
}

/// The sheet at one speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SpeedSheet {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Throw by throw, from the free end on.
    pub throws: Vec<ThrowSheet>,
}

impl SpeedSheet {
    /// The place with the least safety.
    pub fn least(&self) -> Option<(String, f64)> {
        self.throws.iter().flat_map(ThrowSheet::safeties).min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

impl SpeedSheet {
    /// The same with the factors of all fillets by finite elements; none without them.
    pub fn least_by_elements(&self) -> Option<(String, f64)> {
        self.throws.iter().flat_map(ThrowSheet::safeties_by_elements).min_by(|a, b| a.1.total_cmp(&b.1))
    }
}

impl CrankRule {
    /// The speed with the least safety.
    pub fn decisive(&self) -> Option<&SpeedSheet> {
        let least = |sheet: &SpeedSheet| sheet.least().map_or(f64::INFINITY, |least| least.1);
        self.speeds.iter().min_by(|a, b| least(a).total_cmp(&least(b)))
    }

    /// What the formulas cannot judge, and why: the same at every speed.
    pub fn breaches(&self) -> Vec<(String, RangeBreach)> {
        self.speeds
            .first()
            .map_or_else(Vec::new, |sheet| sheet.throws.iter().flat_map(ThrowSheet::breaches).collect())
    }

    /// What neither the formulas nor finite elements judge, and why: the same at every speed.
    pub fn unjudged(&self) -> Vec<(String, RangeBreach)> {
        self.speeds
            .first()
            .map_or_else(Vec::new, |sheet| sheet.throws.iter().flat_map(ThrowSheet::unjudged).collect())
    }

    /// Whether every place is judged and safe at every speed: by the formulas, or by finite elements where a ratio lies outside their range.
    pub fn is_accepted(&self) -> bool {
        let is_safe = |sheet: &SpeedSheet| sheet.least().is_some_and(|least| least.1 >= self.acceptable);
        self.unjudged().is_empty() && self.speeds.iter().all(is_safe)
    }

    /// The sentences that matter most.
    pub(crate) fn lead(&self) -> String {
        let limit = number::trimmed(self.acceptable, 4);
        let mut words = match self.decisive().and_then(|sheet| Some((sheet, sheet.least()?))) {
            None => "No place has a safety: every web lies outside the range of the formulas.".to_owned(),
            Some((sheet, (place, safety))) => {
                let verdict = if safety >= self.acceptable { "not below" } else { "below" };
                format!(
                    "Least safety Q = {} at {place} at {} rpm, {verdict} the {limit} of the rule.",
                    number::short(safety, 3),
                    number::terminal(number::rpm(sheet.speed), 0),
                )
            }
        };
        let by_elements = |sheet: &SpeedSheet| Some((sheet.speed, sheet.least_by_elements()?));
        let least = self.speeds.iter().filter_map(by_elements).min_by(|a, b| a.1.1.total_cmp(&b.1.1));
        if let Some((speed, (place, safety))) = least {
            words.push_str(&format!(
                " With factors by finite elements the least is Q = {} at {place} at {} rpm.",
                number::short(safety, 3),
                number::terminal(number::rpm(speed), 0),
            ));
        }
        let breaches = self.unjudged();
        if let Some((place, _)) = breaches.first() {
            let others = breaches.iter().any(|(other, _)| other != place);
            words.push_str(&format!(
                " Not judged, because outside the range of the formulas: {place}{}.",
                if others { " and others" } else { "" }
            ));
        }
        words
    }

    /// Words between the lead and the tables.
    pub(crate) fn words(&self) -> Vec<String> {
        let mut words = vec![format!("{}.", number::capital(&self.rule))];
        words.push(format!(
            "Material: tensile strength {} MPa ({}), K = {} ({}). Gas: {}.",
            number::trimmed(1e-6 * self.tensile_strength.value, 4),
            self.tensile_strength.origin,
            number::trimmed(self.forging.value, 3),
            self.forging.origin,
            self.gas.as_deref().unwrap_or("none"),
        ));
        words.extend(self.notes.iter().cloned());
        let unjudged = self.unjudged();
        let refused = self.breaches().into_iter().map(|(place, breach)| {
            let then = match unjudged.iter().any(|(other, _)| *other == place) {
                true => "Change the size, or judge it by finite elements.",
                false => "Its safety is that with factors by finite elements.",
            };
            format!("{}: {breach}. {then}", number::capital(&place))
        });
        words.extend(refused);
        words
    }
}

/// Everything as plain text.
pub fn rule_text(rule: &CrankRule) -> String {
    let mut out = format!("{}, strength of crankshaft {}\n\n", rule.engine, rule.crankshaft);
    push_wrapped(&mut out, "", &rule.lead());
    out.push('\n');
    for words in rule.words() {
        push_wrapped(&mut out, "", &words);
    }
    for table in rule.tables() {
        out.push('\n');
        out.push_str(&table.noted_text());
    }
    out
}

/// The chapter of a report; `None` without a sheet.
pub fn rule_section(rules: &[CrankRule]) -> Option<Section> {
    if rules.is_empty() {
        return None;
    }
    let mut section = Section::new("strength", "Strength", "Strength of the crankshaft");
    for rule in rules {
        if rules.len() > 1 {
            section = section.words(format!("Crankshaft {}:", rule.crankshaft));
        }
        section = section.lead(rule.lead()).paragraphs(rule.words()).tables(rule.tables());
    }
    Some(section)
}
