//! What the crankshafts are made of: the file's `[crank.material]`.

use crate::origin::{Origin, Sourced};
use serde::Serialize;

/// Material of the crankshafts; their density is in [`crate::CrankBody`]. `None`: neither the file nor its preset says so.
///
/// Numbers of a preset are typical values; those of the file go first.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct CrankMaterial {
    /// A material by its name.
    pub preset: Option<MaterialPreset>,
    /// Young's modulus [Pa].
    pub youngs_modulus: Option<f64>,
    /// Poisson's ratio [1].
    pub poisson_ratio: Option<f64>,
    /// Tensile strength [Pa].
    pub tensile_strength: Option<f64>,
    /// Yield strength [Pa].
    pub yield_strength: Option<f64>,
    /// Amplitude of alternating bending stress (R = -1) that a polished specimen endures [Pa].
    pub fatigue_bending: Option<f64>,
    /// Amplitude of alternating torsional stress (R = -1) that a polished specimen endures [Pa].
    pub fatigue_torsion: Option<f64>,
    /// How the crankshaft is made.
    pub forging: Option<Forging>,
    /// Loss factor of the material [1].
    pub loss_factor: Option<f64>,
    /// Damping of every mode as a share of critical damping [1].
    pub damping_ratio: Option<f64>,
}

/// How a crankshaft is made: the factor `K` of IACS UR M53.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Forging {
    /// Continuous grain flow, or drop forged: 1.05.
    GrainFlow,
    /// Free form forged: 1.0.
    Free,
    /// Cast steel with cold-rolled fillets: 0.93.
    CastRolled,
}

impl Forging {
    /// All of them.
    pub const ALL: [Forging; 3] = [Forging::GrainFlow, Forging::Free, Forging::CastRolled];

    /// Its word in the file.
    pub fn word(self) -> &'static str {
        match self {
            Forging::GrainFlow => "grain-flow",
            Forging::Free => "free",
            Forging::CastRolled => "cast-rolled",
        }
    }

    /// Factor `K` of IACS UR M53 [1].
    pub fn factor(self) -> f64 {
        match self {
            Forging::GrainFlow => 1.05,
            Forging::Free => 1.0,
            Forging::CastRolled => 0.93,
        }
    }
}

/// A material by its name, with typical values. Least strengths of the standards for sections of 40 mm to 100 mm (cast iron: walls up to 30 mm).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub enum MaterialPreset {
    /// EN ISO 683-2, 1.7225.
    #[serde(rename = "42CrMo4 quenched and tempered")]
    Crmo,
    /// EN ISO 683-2, 1.6582.
    #[serde(rename = "34CrNiMo6 quenched and tempered")]
    Crnimo,
    /// EN ISO 683-1, 1.1191.
    #[serde(rename = "C45 quenched and tempered")]
    Carbon,
    /// EN 10267, 1.1303, cooled from forging without further treatment (least values).
    #[serde(rename = "38MnVS6 precipitation hardened")]
    Microalloyed,
    /// EN 1563, 5.3301 (GGG-70).
    #[serde(rename = "EN-GJS-700-2")]
    DuctileIron,
}

impl MaterialPreset {
    /// All of them.
    pub const ALL: [MaterialPreset; 5] = [
        MaterialPreset::Crmo,
        MaterialPreset::Crnimo,
        MaterialPreset::Carbon,
        MaterialPreset::Microalloyed,
        MaterialPreset::DuctileIron,
    ];

    /// Its name in the file.
    pub fn name(self) -> &'static str {
        match self {
            MaterialPreset::Crmo => "42CrMo4 quenched and tempered",
            MaterialPreset::Crnimo => "34CrNiMo6 quenched and tempered",
            MaterialPreset::Carbon => "C45 quenched and tempered",
            MaterialPreset::Microalloyed => "38MnVS6 precipitation hardened",
            MaterialPreset::DuctileIron => "EN-GJS-700-2",
        }
    }

    /// Young's modulus [Pa] and Poisson's ratio [1].
    fn elasticity(self) -> [f64; 2] {
        match self {
            MaterialPreset::DuctileIron => [176e9, 0.275],
            _ => [210e9, 0.3],
        }
    }

    /// Tensile and yield strength [Pa].
    fn strengths(self) -> [f64; 2] {
        match self {
            MaterialPreset::Crmo => [900e6, 650e6],
            MaterialPreset::Crnimo => [1000e6, 800e6],
            MaterialPreset::Carbon => [630e6, 370e6],
            MaterialPreset::Microalloyed => [800e6, 520e6],
            MaterialPreset::DuctileIron => [700e6, 420e6],
        }
    }
}

/// Fatigue strength in bending over tensile strength, where the file gives none: the usual estimate for steels.
const BENDING_SHARE: f64 = 0.45;

impl CrankMaterial {
    /// Young's modulus [Pa].
    pub fn youngs_modulus(&self) -> Option<Sourced> {
        self.own_or(self.youngs_modulus, |preset| preset.elasticity()[0])
    }

    /// Poisson's ratio [1].
    pub fn poisson_ratio(&self) -> Option<Sourced> {
        self.own_or(self.poisson_ratio, |preset| preset.elasticity()[1])
    }

    /// Tensile strength [Pa].
    pub fn tensile_strength(&self) -> Option<Sourced> {
        self.own_or(self.tensile_strength, |preset| preset.strengths()[0])
    }

    /// Yield strength [Pa].
    pub fn yield_strength(&self) -> Option<Sourced> {
        self.own_or(self.yield_strength, |preset| preset.strengths()[1])
    }

    /// Fatigue strength in alternating bending [Pa]; where the file gives none 0.45 of the tensile strength, assumed.
    pub fn fatigue_bending(&self) -> Option<Sourced> {
        let estimate = || Some(assumed(self.tensile_strength()?.value * BENDING_SHARE));
        self.fatigue_bending.map(Sourced::given).or_else(estimate)
    }

    /// Fatigue strength in alternating torsion [Pa]; where the file gives none that in bending over the square root of 3, assumed.
    pub fn fatigue_torsion(&self) -> Option<Sourced> {
        let estimate = || Some(assumed(self.fatigue_bending()?.value / 3_f64.sqrt()));
        self.fatigue_torsion.map(Sourced::given).or_else(estimate)
    }

    /// Factor `K` of IACS UR M53 [1]; free form forging where the file says nothing, assumed.
    pub fn forging_factor(&self) -> Sourced {
        self.forging.map_or(assumed(Forging::Free.factor()), |forging| Sourced::given(forging.factor()))
    }

    fn own_or(&self, own: Option<f64>, of: impl Fn(MaterialPreset) -> f64) -> Option<Sourced> {
        let typical = || self.preset.map(|preset| Sourced { value: of(preset), origin: Origin::Typical });
        own.map(Sourced::given).or_else(typical)
    }
}

fn assumed(value: f64) -> Sourced {
    Sourced { value, origin: Origin::Assumed }
}
