//! Physical domains: what effort and flow are.

use crate::unit::Unit;

/// A physical domain of a bond.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Domain {
    /// Force and velocity.
    Translation,
    /// Torque and angular velocity.
    Rotation,
    /// Voltage and current.
    Electric,
    /// Pressure and volume flow.
    Hydraulic,
    /// Temperature and entropy flow.
    Thermal,
    /// Temperature and heat flow: a pseudo-bond, whose flow itself is the power.
    Heat,
    /// Pressure and mass flow: a pseudo-bond, whose energy goes by the heat bond beside it.
    Mass,
}

impl Domain {
    /// Every domain.
    pub const ALL: [Domain; 7] = [
        Domain::Translation,
        Domain::Rotation,
        Domain::Electric,
        Domain::Hydraulic,
        Domain::Thermal,
        Domain::Heat,
        Domain::Mass,
    ];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Domain::Translation => "translation",
            Domain::Rotation => "rotation",
            Domain::Electric => "electric",
            Domain::Hydraulic => "hydraulic",
            Domain::Thermal => "thermal",
            Domain::Heat => "heat",
            Domain::Mass => "mass",
        }
    }

    /// Unit of the effort.
    pub fn effort(self) -> Unit {
        match self {
            Domain::Translation => Unit::of([1, 1, -2, 0, 0]),
            Domain::Rotation => Unit::JOULE,
            Domain::Electric => Unit::of([2, 1, -3, -1, 0]),
            Domain::Hydraulic | Domain::Mass => Unit::of([-1, 1, -2, 0, 0]),
            Domain::Thermal | Domain::Heat => Unit::of([0, 0, 0, 0, 1]),
        }
    }

    /// Unit of the flow.
    pub fn flow(self) -> Unit {
        match self {
            Domain::Translation => Unit::of([1, 0, -1, 0, 0]),
            Domain::Rotation => Unit::of([0, 0, -1, 0, 0]),
            Domain::Electric => Unit::of([0, 0, 0, 1, 0]),
            Domain::Hydraulic => Unit::of([3, 0, -1, 0, 0]),
            Domain::Thermal => Unit::of([2, 1, -3, 0, -1]),
            Domain::Heat => Unit::of([2, 1, -3, 0, 0]),
            Domain::Mass => Unit::of([0, 1, -1, 0, 0]),
        }
    }

    /// Whether effort times flow is power.
    pub fn is_true_bond(self) -> bool {
        !matches!(self, Domain::Heat | Domain::Mass)
    }

    /// Energy that a bond carries in a unit of time.
    pub fn power(self, effort: f64, flow: f64) -> f64 {
        match self {
            Domain::Heat => flow,
            Domain::Mass => 0.0,
            _ => effort * flow,
        }
    }

    /// How effort, flow, displacement and momentum read for people, with their unit: `rad/s` rather than `1/s`.
    pub fn unit_names(self) -> [&'static str; 4] {
        match self {
            Domain::Translation => ["N", "m/s", "m", "N s"],
            Domain::Rotation => ["N m", "rad/s", "rad", "N m s"],
            Domain::Electric => ["V", "A", "C", "V s"],
            Domain::Hydraulic => ["Pa", "m3/s", "m3", "Pa s"],
            Domain::Thermal => ["K", "W/K", "J/K", "K s"],
            Domain::Heat => ["K", "W", "J", "K s"],
            Domain::Mass => ["Pa", "kg/s", "kg", "Pa s"],
        }
    }

    /// Units of resistance, capacitance, inertia and stiffness as they are usually written.
    pub(crate) fn coefficient_names(self) -> [&'static str; 4] {
        match self {
            Domain::Translation => ["N s/m", "m/N", "kg", "N/m"],
            Domain::Rotation => ["N m s/rad", "rad/(N m)", "kg m2", "N m/rad"],
            Domain::Electric => ["Ohm", "F", "H", "V/C"],
            Domain::Hydraulic => ["Pa s/m3", "m3/Pa", "Pa s2/m3", "Pa/m3"],
            Domain::Thermal => ["K2/W", "J/K2", "K2 s/W", "K2/J"],
            Domain::Heat => ["K/W", "J/K", "K s/W", "K/J"],
            Domain::Mass => ["Pa s/kg", "kg/Pa", "Pa s2/kg", "Pa/kg"],
        }
    }
}
