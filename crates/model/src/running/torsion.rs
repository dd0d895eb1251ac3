//! What the file says of torsional vibration: `[torsion]`, `[[torsion.branch]]`, `[damper]` and `[[pendulum]]`.

use serde::Serialize;

/// Torsional stiffness and damping of the crankshaft, its damper, pendulum absorbers and branches. All that turns has its inertia elsewhere.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct TorsionDesign {
    /// Stiffness between neighbouring planes [N m/rad], from the free end on, crankshaft by crankshaft: before each throw the piece from the plane
    /// before it (the nose, where there is one), last the piece to the flywheel. Empty: from the sizes of the crankshaft.
    pub stiffness: Vec<f64>,
    /// Damping of each throw against the ground [N m s/rad].
    pub absolute_damping: Option<f64>,
    /// Damping of the twist of each piece of the crankshaft [N m s/rad].
    pub relative_damping: Option<f64>,
    /// Loss factor of the crankshaft [1]; `None`: that of its material.
    pub loss_factor: Option<f64>,
    /// Inertia at the free end beside the damper: pulley, timing drive [kg m^2].
    pub nose_inertia: Option<f64>,
    /// Where balance shafts and gears are driven.
    pub gears: GearEnd,
    /// Highest order that is taken.
    pub highest_order: Option<f64>,
    /// Largest amplitude of the twist between nose and flywheel that is allowed [rad].
    pub twist_limit: Option<f64>,
    /// Largest amplitude of the vibratory shear stress that is allowed [Pa].
    pub stress_limit: Option<f64>,
    /// The damper at the free end.
    pub damper: Option<TorsionDamper>,
    /// Pendulum absorbers.
    pub pendulums: Vec<PendulumAbsorber>,
    /// Inertias on shafts of their own beside the driveline.
    pub branches: Vec<TorsionBranch>,
}

/// An end of the crankshaft at which wheels are driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GearEnd {
    /// The free end.
    #[default]
    Nose,
    /// The flywheel.
    Flywheel,
}

impl GearEnd {
    /// Both of them.
    pub const ALL: [GearEnd; 2] = [GearEnd::Nose, GearEnd::Flywheel];

    /// Its word in the file.
    pub fn word(self) -> &'static str {
        match self {
            GearEnd::Nose => "nose",
            GearEnd::Flywheel => "flywheel",
        }
    }
}

/// A damper at the free end: a ring on a hub.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorsionDamper {
    /// Of which kind.
    pub kind: DamperKind,
    /// Moment of inertia of the seismic ring [kg m^2].
    pub ring_inertia: f64,
    /// Moment of inertia of hub and housing [kg m^2].
    pub hub_inertia: f64,
    /// Viscous damping between ring and hub [N m s/rad].
    pub damping: f64,
    /// Stiffness between ring and hub [N m/rad]; 0: none.
    pub stiffness: f64,
    /// Loss factor of that stiffness [1].
    pub loss_factor: f64,
}

/// A kind of damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DamperKind {
    /// The ring runs in a viscous fluid, with or without springs.
    Viscous,
    /// The ring is bonded by rubber.
    Rubber,
}

impl DamperKind {
    /// Both of them.
    pub const ALL: [DamperKind; 2] = [DamperKind::Viscous, DamperKind::Rubber];

    /// Its word in the file.
    pub fn word(self) -> &'static str {
        match self {
            DamperKind::Viscous => "viscous",
            DamperKind::Rubber => "rubber",
        }
    }
}

/// Equal centrifugal pendulums on the webs of one throw.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PendulumAbsorber {
    /// Index of the throw.
    pub throw: usize,
    /// Mass of one [kg].
    pub mass: f64,
    /// Distance of its pivot from the crank axis [m].
    pub pivot_radius: f64,
    /// Distance of its centre of mass from the pivot [m].
    pub length: f64,
    /// How many.
    pub number: usize,
    /// Viscous damping of its swing [N m s/rad].
    pub damping: f64,
}

/// An inertia on a torsional spring beside the driveline: an accessory, a generator at the free end.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorsionBranch {
    /// Its name.
    pub name: String,
    /// What drives it.
    pub at: BranchPlace,
    /// Moment of inertia about its axis [kg m^2].
    pub inertia: f64,
    /// Stiffness of the shaft before it [N m/rad], at its own speed.
    pub stiffness: f64,
    /// Damping of that shaft [N m s/rad].
    pub damping: f64,
    /// Its speed over that of what drives it.
    pub ratio: f64,
}

/// What drives a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BranchPlace {
    /// The free end of the crankshaft.
    Nose,
    /// The flywheel.
    Flywheel,
    /// The throw with this index.
    Throw(usize),
    /// The branch with this index, an earlier one.
    Branch(usize),
}
