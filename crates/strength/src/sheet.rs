//! The sheet: throw by throw from nominal stresses to safety.

use crate::crank_throws::RuleThrow;
use crate::error::StrengthError;
use crate::factors::{FactorValues, OilFactors, RuleFactors};
use crate::fatigue_strength::{fatigue_strength, oil_bore_radius};
use crate::nominal::{NominalBore, NominalWeb, alternation};
use crate::ratios::{RangeBreach, SectionRatios};
use crate::section::WebSection;
use serde::Serialize;

/// Least safety Q = sigma_DW/sigma_v that the rule accepts [1].
pub const ACCEPTABLE: f64 = 1.15;

/// Bending stress that misalignment and the deformation of bedplate and bearings add in trunk-piston engines [Pa].
pub const ADDITIONAL: f64 = 10e6;

/// What every sheet says of itself.
pub const RULE_WORDS: &str = "formulas after UR M53, not compared with the printed rule";

/// Material of the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RuleMaterial {
    /// Tensile strength sigma_B [Pa].
    pub tensile_strength: f64,
    /// Factor K of the way of forging [1].
    pub forging: f64,
}

/// Forces of all rods on a pin over the cycle.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct ThrowLoad {
    /// Along the throw, positive away from the crank axis [N].
    pub radial: Vec<f64>,
    /// Across it, positive where it drives the crankshaft [N].
    pub tangential: Vec<f64>,
    /// Amplitude of the torque that torsional vibration adds in its pin and journals [N m].
    pub vibration: f64,
}

/// A fillet: from factors to safety.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletSheet {
    /// Alternating bending stress, with the additional one [Pa].
    pub bending: f64,
    /// Alternating torsional stress [Pa].
    pub torsion: f64,
    /// Alternating equivalent stress [Pa].
    pub equivalent: f64,
    /// Fatigue strength [Pa].
    pub strength: f64,
    /// Safety Q [1].
    pub safety: f64,
}

/// An oil bore: from nominal stress to safety.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BoreSheet {
    /// Its diameter [m].
    pub diameter: f64,
    /// Its direction from that of the throw [rad].
    pub angle: f64,
    /// Loads and nominal stresses.
    pub nominal: NominalBore,
    /// Where it is too large for the formulas: no factors, no safety.
    pub breach: Option<RangeBreach>,
    /// Stress concentration factors.
    pub factors: Option<OilFactors>,
    /// Stresses and safety.
    pub stress: Option<FilletSheet>,
}

/// A web by finite elements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ElementWeb {
    /// Its factors.
    pub factors: FactorValues,
    /// The pin's fillet.
    pub pin_fillet: FilletSheet,
    /// The journal's fillet.
    pub journal_fillet: FilletSheet,
}

/// A web with its two fillets.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct WebSheet {
    /// Its number along the crankshaft, from 1.
    pub web: usize,
    /// Number of the journal at it, from 1.
    pub journal: usize,
    /// Sizes.
    pub section: WebSection,
    /// Their ratios.
    pub ratios: SectionRatios,
    /// Loads and nominal stresses.
    pub nominal: NominalWeb,
    /// Ratios outside the range of the formulas; where there is one, there are no factors and no safety.
    pub breaches: Vec<RangeBreach>,
    /// Stress concentration factors.
    pub factors: Option<RuleFactors>,
    /// The pin's fillet.
    pub pin_fillet: Option<FilletSheet>,
    /// The journal's fillet.
    pub journal_fillet: Option<FilletSheet>,
    /// Both by finite elements, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by_elements: Option<ElementWeb>,
}

impl WebSheet {
    fn is_meshed_as_it_is(&self) -> bool {
        self.section.pin_recess == 0.0 && self.section.journal_recess == 0.0
    }

    /// The sheets of its pin's and its journal's fillet: by the formulas, or by finite elements where a ratio lies outside their range. Elements do not
    /// judge fillets with an undercut, which their mesh does not have.
    pub fn judged(&self) -> [Option<FilletSheet>; 2] {
        let other = self.by_elements.filter(|_| self.is_meshed_as_it_is());
        [
            self.pin_fillet.or(other.map(|own| own.pin_fillet)),
            self.journal_fillet.or(other.map(|own| own.journal_fillet)),
        ]
    }
}

/// A throw.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowSheet {
    /// Its number, from 1.
    pub throw: usize,
    /// Planes of its main bearings [m].
    pub mains: [f64; 2],
    /// Alternating radial force on its pin [N].
    pub radial: f64,
    /// Alternating tangential force on its pin [N].
    pub tangential: f64,
    /// Alternating torque in its journals in front and behind, of a rigid crankshaft at constant speed [N m].
    pub torques: [f64; 2],
    /// Amplitude of the torque of torsional vibration, added to them [N m].
    pub vibration: f64,
    /// Its webs.
    pub webs: [WebSheet; 2],
    /// Oil bore of its pin, if it has one.
    pub bore: Option<BoreSheet>,
}

impl ThrowSheet {
    /// The same sheet with the factors of its webs by finite elements beside those of the formulas.
    #[must_use]
    pub fn with_elements(mut self, factors: [FactorValues; 2], material: RuleMaterial) -> ThrowSheet {
        for (web, factors) in self.webs.iter_mut().zip(factors) {
            let [pin_fillet, journal_fillet] = fillet_sheets(&web.section, &web.nominal, factors, material);
            web.by_elements = Some(ElementWeb { factors, pin_fillet, journal_fillet });
        }
        self
    }

    /// All places that have a safety: words and safety.
    pub fn safeties(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        let of_web = |web: &WebSheet| {
            let [pin, journal] = web.judged();
            [
                pin.map(|own| (format!("pin {} at web {}", self.throw, web.web), own.safety)),
                journal.map(|own| (format!("journal {} at web {}", web.journal, web.web), own.safety)),
            ]
        };
        let bore = self.bore.as_ref().and_then(|bore| bore.stress);
        let bore = bore.map(|own| (format!("oil bore of pin {}", self.throw), own.safety));
        self.webs.iter().flat_map(of_web).chain([bore]).flatten()
    }

    /// Safety of all fillets with their factors by finite elements; nothing without them.
    pub fn safeties_by_elements(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        let of_web = |web: &WebSheet| {
            let own = web.by_elements?;
            Some([
                (format!("pin {} at web {}", self.throw, web.web), own.pin_fillet.safety),
                (format!("journal {} at web {}", web.journal, web.web), own.journal_fillet.safety),
            ])
        };
        self.webs.iter().filter_map(of_web).flatten()
    }

    /// What neither the formulas nor finite elements judge, and why.
    pub fn unjudged(&self) -> impl Iterator<Item = (String, RangeBreach)> + '_ {
        let by_elements = |place: &String| {
            self.webs.iter().any(|web| web.judged()[0].is_some() && *place == format!("web {}", web.web))
        };
        self.breaches().filter(move |(place, _)| !by_elements(place))
    }

    /// What the formulas cannot judge, and why: webs that finite elements judge instead among them.
    pub fn breaches(&self) -> impl Iterator<Item = (String, RangeBreach)> + '_ {
        let of_web = |web: &'_ WebSheet| {
            let place = format!("web {}", web.web);
            web.breaches.clone().into_iter().map(move |breach| (place.clone(), breach))
        };
        let bore = self.bore.as_ref().and_then(|bore| bore.breach);
        let bore = bore.map(|breach| (format!("oil bore of pin {}", self.throw), breach));
        self.webs.iter().flat_map(of_web).chain(bore)
    }
}

/// The sheet of all throws of a crankshaft, from the free end on; `loads` in the same order, the torque leaves at the flywheel.
///
/// # Errors
/// [`StrengthError::Loads`] where the loads do not fit the throws.
pub fn rule_sheet(
    throws: &[RuleThrow],
    loads: &[ThrowLoad],
    material: RuleMaterial,
) -> Result<Vec<ThrowSheet>, StrengthError> {
    let angles = loads.first().map_or(0, |load| load.radial.len());
    let fits = |load: &ThrowLoad| load.radial.len() == angles && load.tangential.len() == angles;
    if loads.len() != throws.len() || angles == 0 || !loads.iter().all(fits) {
        let lengths: Vec<String> = loads
            .iter()
            .map(|load| format!("{} radial and {} tangential", load.radial.len(), load.tangential.len()))
            .collect();
        let got = if lengths.is_empty() { "none".to_owned() } else { lengths.join(", ") };
        return Err(StrengthError::Loads { needed: throws.len(), got });
    }
    // Torque that reaches each journal from the free end.
    let mut torque = vec![0.0; angles];
    let mut sheets = Vec::with_capacity(throws.len());
    for (throw, load) in throws.iter().zip(loads) {
        let front = alternation(torque.iter().copied());
        for (sum, force) in torque.iter_mut().zip(&load.tangential) {
            *sum += throw.radius * force;
        }
        let rear = alternation(torque.iter().copied());
        sheets.push(throw_sheet(throw, load, [front, rear], material));
    }
    Ok(sheets)
}

fn throw_sheet(throw: &RuleThrow, load: &ThrowLoad, torques: [f64; 2], material: RuleMaterial) -> ThrowSheet {
    let radial = alternation(load.radial.iter().copied());
    let all = torques.map(|torque| torque + load.vibration);
    let webs = [0, 1].map(|side| web_sheet(throw, side, NominalWeb::new(throw, side, radial, all), material));
    let bore = throw.oil_hole.map(|hole| {
        let torque = all[0].max(all[1]);
        let nominal = NominalBore::new(throw, hole.angle, &load.radial, &load.tangential, torque);
        let ratios = throw.sections[0].ratios();
        let (breach, factors) = (ratios.oil_breach(), ratios.d_oil.map(OilFactors::new));
        let factors = factors.filter(|_| breach.is_none());
        let stress = factors.map(|factors| bore_stress(throw, hole.diameter, factors, nominal, material));
        BoreSheet { diameter: hole.diameter, angle: hole.angle, nominal, breach, factors, stress }
    });
    ThrowSheet {
        throw: throw.throw + 1,
        mains: throw.mains,
        radial,
        tangential: alternation(load.tangential.iter().copied()),
        torques,
        vibration: load.vibration,
        webs,
        bore,
    }
}

fn web_sheet(throw: &RuleThrow, side: usize, nominal: NominalWeb, material: RuleMaterial) -> WebSheet {
    let section = throw.sections[side];
    let ratios = section.ratios();
    let breaches = ratios.breaches();
    let factors = breaches.is_empty().then(|| RuleFactors::new(&ratios));
    let fillets = factors.as_ref().map(|own| fillet_sheets(&section, &nominal, own.values(), material));
    let [pin_fillet, journal_fillet] = [0, 1].map(|end| fillets.map(|own| own[end]));
    WebSheet {
        web: throw.web_numbers[side],
        journal: throw.journals[side],
        section,
        ratios,
        nominal,
        breaches,
        factors,
        pin_fillet,
        journal_fillet,
        by_elements: None,
    }
}

/// The pin's and the journal's fillet of a web from its nominal stresses and factors.
///
/// ```text
/// sigma_v = sqrt(sigma^2 + 3 tau^2)        sigma: bending with the additional stress                                       (49.10)
/// ```
pub(crate) fn fillet_sheets(
    section: &WebSection,
    nominal: &NominalWeb,
    factors: FactorValues,
    material: RuleMaterial,
) -> [FilletSheet; 2] {
    let RuleMaterial { tensile_strength, forging } = material;
    let fillet = |bending: f64, torsion: f64, diameter: f64, radius: f64| {
        let bending = bending + ADDITIONAL;
        let equivalent = (bending * bending + 3.0 * torsion * torsion).sqrt();
        let strength = fatigue_strength(forging, tensile_strength, diameter, radius);
        FilletSheet { bending, torsion, equivalent, strength, safety: strength / equivalent }
    };
    [
        fillet(
            factors.alpha_b * nominal.sigma_b,
            factors.alpha_t * nominal.pin_tau,
            section.pin_diameter,
            section.pin_fillet,
        ),
        fillet(
            factors.beta_b * nominal.sigma_b + factors.beta_q * nominal.sigma_q,
            factors.beta_t * nominal.journal_tau,
            section.journal_diameter,
            section.journal_fillet,
        ),
    ]
}

/// ```text
/// sigma_v = (sigma_BO + 2 sqrt(sigma_BO^2 + (9/4) sigma_TO^2))/3                                                   (49.11)
/// ```
/// the rule's (sigma_BO/3)(1 + 2 sqrt(1 + (9/4)(sigma_TO/sigma_BO)^2)), without its division by a bending stress that may vanish. K above 1
/// holds for fillets alone.
fn bore_stress(
    throw: &RuleThrow,
    diameter: f64,
    factors: OilFactors,
    nominal: NominalBore,
    material: RuleMaterial,
) -> FilletSheet {
    let (bending, torsion) = (factors.gamma_b * nominal.sigma, factors.gamma_t * nominal.tau);
    let equivalent = (bending + 2.0 * (bending * bending + 2.25 * torsion * torsion).sqrt()) / 3.0;
    let strength = fatigue_strength(
        material.forging.min(1.0),
        material.tensile_strength,
        throw.sections[0].pin_diameter,
        oil_bore_radius(diameter),
    );
    FilletSheet { bending, torsion, equivalent, strength, safety: strength / equivalent }
}
