//! What the main and crankpin bearings are like beyond their sizes: clearance, grooves, law, oil. Their sizes are in [`crate::Bearings`].

use serde::Serialize;

/// What the file's `[bearings.main]`, `[bearings.crankpin]` and `[bearings.film]` say beyond sizes. `None`: not said.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct BearingDesign {
    /// All main bearings.
    pub main: BearingData,
    /// Main bearings that differ, with their index counted as [`crate::EngineParts::main_bearings`].
    pub main_each: Vec<(usize, BearingData)>,
    /// All crankpin bearings.
    pub crankpin: BearingData,
    /// Crankpin bearings that differ, with the index of their cylinder.
    pub crankpin_each: Vec<(usize, BearingData)>,
    /// Their oil.
    pub oil: Oil,
}

/// Data of a plain bearing. Lengths in m.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct BearingData {
    /// Width that carries [m], of one that differs from the rest.
    pub width: Option<f64>,
    /// Diametral clearance [m].
    pub diametral_clearance: Option<f64>,
    /// Which law it follows.
    pub model: Option<BearingLaw>,
    /// Stiffness of the laws `contact` and `bushing` [N/m].
    pub stiffness: Option<f64>,
    /// Damping of the laws `contact` and `bushing` [N s/m].
    pub damping: Option<f64>,
    /// Oil grooves of the shell; `None`: not said, empty: none.
    pub grooves: Option<Vec<OilGroove>>,
    /// Stiffness of the housing.
    pub housing: Option<Housing>,
}

/// Which law a bearing follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BearingLaw {
    /// Without clearance.
    Rigid,
    /// Clearance, then a spring.
    Contact,
    /// A spring about the middle.
    Bushing,
    /// An oil film.
    Film,
}

impl BearingLaw {
    /// All of them.
    pub const ALL: [BearingLaw; 4] =
        [BearingLaw::Rigid, BearingLaw::Contact, BearingLaw::Bushing, BearingLaw::Film];

    /// Its word in the file.
    pub fn word(self) -> &'static str {
        match self {
            BearingLaw::Rigid => "rigid",
            BearingLaw::Contact => "contact",
            BearingLaw::Bushing => "bushing",
            BearingLaw::Film => "film",
        }
    }
}

/// An oil groove in the middle of a shell.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OilGroove {
    /// Where it begins [rad], in the shell's frame: of a main bearing that of the engine, of a crankpin bearing from the rod's line towards
    /// the piston, positive from +x to +y.
    pub from: f64,
    /// Where it ends [rad], more than `from`, at most a turn on.
    pub to: f64,
    /// Its width along the crank [m].
    pub width: f64,
}

/// Stiffness of a bearing's housing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Housing {
    /// It does not yield.
    Rigid,
    /// A spring [N/m].
    Stiffness(f64),
}

/// The oil of the bearings: `[bearings.film]`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct Oil {
    /// Dynamic viscosity [Pa s].
    pub viscosity: Option<f64>,
    /// Name of an oil, such as "SAE 5W-30", whose viscosity follows from its temperature.
    pub name: Option<String>,
    /// Its temperature [K].
    pub temperature: Option<f64>,
    /// Density [kg/m^3].
    pub density: Option<f64>,
    /// How the film breaks.
    pub cavitation: Option<Cavitation>,
    /// Supply pressure above ambient [Pa].
    pub supply_pressure: Option<f64>,
    /// Composite roughness of both surfaces [m].
    pub roughness: Option<f64>,
}

/// How an oil film breaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Cavitation {
    /// It does not: negative pressures stay.
    Full,
    /// Negative pressures of the full film count as none.
    Gumbel,
    /// Pressure and its slope vanish together.
    Reynolds,
    /// With the mass of oil kept.
    MassConserving,
}

impl Cavitation {
    /// All of them.
    pub const ALL: [Cavitation; 4] =
        [Cavitation::Full, Cavitation::Gumbel, Cavitation::Reynolds, Cavitation::MassConserving];

    /// Its word in the file.
    pub fn word(self) -> &'static str {
        match self {
            Cavitation::Full => "full",
            Cavitation::Gumbel => "gumbel",
            Cavitation::Reynolds => "reynolds",
            Cavitation::MassConserving => "mass-conserving",
        }
    }
}

impl BearingData {
    /// These data where they say something, else those of all.
    pub fn over(&self, all: &BearingData) -> BearingData {
        BearingData {
            width: self.width.or(all.width),
            diametral_clearance: self.diametral_clearance.or(all.diametral_clearance),
            model: self.model.or(all.model),
            stiffness: self.stiffness.or(all.stiffness),
            damping: self.damping.or(all.damping),
            grooves: self.grooves.clone().or_else(|| all.grooves.clone()),
            housing: self.housing.or(all.housing),
        }
    }
}
