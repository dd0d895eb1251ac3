//! Dimensions and the units that they are written in.

use super::decimal::decimal;
use super::word_list::one_of;
use std::f64::consts::PI;

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Length, in m.
    Length,
    /// Mass, in kg.
    Mass,
    /// Angle, in rad.
    Angle,
    /// Speed of rotation, in rad/s.
    Speed,
    /// Mass times radius, in kg m.
    Unbalance,
    /// Moment of inertia, in kg m^2.
    Inertia,
    /// A part of a whole, 1 for all of it.
    Share,
    /// Force, in N.
    Force,
    /// Pressure, in Pa.
    Pressure,
    /// Moment of a force, in N m.
    Torque,
    /// Mass per volume, in kg/m^3.
    Density,
    /// Velocity, in m/s.
    Velocity,
    /// Acceleration, in m/s^2.
    Acceleration,
    /// Area, in m^2.
    Area,
    /// Absolute temperature, in K.
    Temperature,
    /// Energy, in J.
    Energy,
    /// Energy per mass, in J/kg.
    SpecificEnergy,
    /// Heat per mass and temperature, in J/(kg K).
    SpecificHeat,
    /// Heat transfer coefficient, in W/(m^2 K).
    HeatTransfer,
    /// Heat flow per temperature, in W/K.
    ThermalConductance,
    /// Heat per temperature, in J/K.
    HeatCapacity,
    /// Force per length, in N/m.
    Stiffness,
    /// Force per velocity, in N s/m.
    Damping,
    /// Pressure per velocity, in Pa s/m.
    PressurePerSpeed,
    /// Pressure per velocity squared, in Pa s^2/m^2.
    PressurePerSpeedSquared,
    /// Time, in s.
    Time,
    /// Power, in W.
    Power,
    /// Torque per angle, in N m/rad.
    AngularStiffness,
    /// Torque per speed of rotation, in N m s/rad.
    AngularDamping,
    /// Share per speed of rotation, in s/rad.
    PerSpeed,
    /// Per time, in 1/s.
    Rate,
    /// Dynamic viscosity, in Pa s.
    Viscosity,
    /// Dynamic viscosity over density, in m2/s.
    KinematicViscosity,
}

impl Dimension {
    /// All dimensions, in the order of the reference.
    pub const ALL: [Dimension; 33] = [
        Dimension::Length,
        Dimension::Mass,
        Dimension::Angle,
        Dimension::Speed,
        Dimension::Unbalance,
        Dimension::Inertia,
        Dimension::Share,
        Dimension::Force,
        Dimension::Pressure,
        Dimension::Torque,
        Dimension::Density,
        Dimension::Velocity,
        Dimension::Acceleration,
        Dimension::Area,
        Dimension::Temperature,
        Dimension::Energy,
        Dimension::SpecificEnergy,
        Dimension::SpecificHeat,
        Dimension::HeatTransfer,
        Dimension::ThermalConductance,
        Dimension::HeatCapacity,
        Dimension::Stiffness,
        Dimension::Damping,
        Dimension::PressurePerSpeed,
        Dimension::PressurePerSpeedSquared,
        Dimension::Time,
        Dimension::Power,
        Dimension::AngularStiffness,
        Dimension::AngularDamping,
        Dimension::PerSpeed,
        Dimension::Rate,
        Dimension::Viscosity,
        Dimension::KinematicViscosity,
    ];

    /// Name with its article, for messages.
    pub fn with_article(self) -> &'static str {
        match self {
            Dimension::Length => "a length",
            Dimension::Mass => "a mass",
            Dimension::Angle => "an angle",
            Dimension::Speed => "a speed",
            Dimension::Unbalance => "an unbalance",
            Dimension::Inertia => "a moment of inertia",
            Dimension::Share => "a share",
            Dimension::Force => "a force",
            Dimension::Pressure => "a pressure",
            Dimension::Torque => "a torque",
            Dimension::Density => "a density",
            Dimension::Velocity => "a velocity",
            Dimension::Acceleration => "an acceleration",
            Dimension::Area => "an area",
            Dimension::Temperature => "a temperature",
            Dimension::Energy => "an energy",
            Dimension::SpecificEnergy => "an energy per mass",
            Dimension::SpecificHeat => "a specific heat",
            Dimension::HeatTransfer => "a heat transfer coefficient",
            Dimension::ThermalConductance => "a thermal conductance",
            Dimension::HeatCapacity => "a heat capacity",
            Dimension::Stiffness => "a stiffness",
            Dimension::Damping => "a damping coefficient",
            Dimension::PressurePerSpeed => "a pressure per speed",
            Dimension::PressurePerSpeedSquared => "a pressure per speed squared",
            Dimension::Time => "a time",
            Dimension::Power => "a power",
            Dimension::AngularStiffness => "a torsional stiffness",
            Dimension::AngularDamping => "a torsional damping coefficient",
            Dimension::PerSpeed => "a share per speed",
            Dimension::Rate => "a rate",
            Dimension::Viscosity => "a viscosity",
            Dimension::KinematicViscosity => "a kinematic viscosity",
        }
    }

    /// Name for tables and the JSON Schema.
    pub fn name(self) -> &'static str {
        self.with_article().trim_start_matches("a ").trim_start_matches("an ")
    }

    /// Units in the order in which hints name them.
    pub fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }

    /// `m, mm, cm, um, in, ft or thou`.
    pub fn unit_list(self) -> String {
        one_of(self.units().map(|unit| unit.name))
    }
}

/// A unit: `value in SI = number * 10^exponent * factor + zero`.
#[derive(Debug)]
pub struct Unit {
    /// As it is written: "mm".
    pub name: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    pub(super) exponent: i32,
    pub(super) factor: f64,
    /// Where its scale begins, in SI: 0 but for temperatures.
    pub(super) zero: f64,
}

const fn unit(dimension: Dimension, name: &'static str, exponent: i32, factor: f64) -> Unit {
    Unit { name, dimension, exponent, factor, zero: 0.0 }
}

const fn from_zero(dimension: Dimension, name: &'static str, factor: f64, zero: f64) -> Unit {
    Unit { name, dimension, exponent: 0, factor, zero }
}

/// International pound [kg] and inch [m] (exact since 1959), standard gravity [m/s^2] (CGPM 1901).
const POUND: f64 = 0.453_592_37;
const INCH: f64 = 0.0254;
const STANDARD_GRAVITY: f64 = 9.806_65;
/// 0 degrees Celsius [K].
const ICE_POINT: f64 = 273.15;

pub(super) static UNITS: [Unit; 120] = {
    use Dimension::*;
    [
        unit(Length, "mm", -3, 1.0),
        unit(Length, "m", 0, 1.0),
        unit(Length, "cm", -2, 1.0),
        unit(Length, "um", -6, 1.0),
        unit(Length, "in", 0, INCH),
        unit(Length, "ft", 0, 0.3048),
        unit(Length, "thou", -3, INCH),
        unit(Mass, "kg", 0, 1.0),
        unit(Mass, "g", -3, 1.0),
        unit(Mass, "lb", 0, POUND),
        unit(Mass, "oz", 0, POUND / 16.0),
        unit(Mass, "mg", -6, 1.0),
        unit(Angle, "deg", 0, PI / 180.0),
        unit(Angle, "rad", 0, 1.0),
        unit(Speed, "rpm", 0, PI / 30.0),
        unit(Speed, "rad/s", 0, 1.0),
        unit(Speed, "Hz", 0, 2.0 * PI),
        unit(Speed, "krpm", 3, PI / 30.0),
        unit(Unbalance, "kg m", 0, 1.0),
        unit(Unbalance, "kg mm", -3, 1.0),
        unit(Unbalance, "g mm", -6, 1.0),
        unit(Unbalance, "g cm", -5, 1.0),
        unit(Unbalance, "g m", -3, 1.0),
        unit(Unbalance, "g in", -3, INCH),
        unit(Unbalance, "oz in", 0, POUND / 16.0 * INCH),
        unit(Unbalance, "lb in", 0, POUND * INCH),
        unit(Inertia, "kg m2", 0, 1.0),
        unit(Inertia, "kg mm2", -6, 1.0),
        unit(Inertia, "kg cm2", -4, 1.0),
        unit(Inertia, "g m2", -3, 1.0),
        unit(Inertia, "g mm2", -9, 1.0),
        unit(Inertia, "lb in2", 0, POUND * INCH * INCH),
        unit(Inertia, "lbf in s2", 0, POUND * STANDARD_GRAVITY * INCH),
        unit(Share, "%", -2, 1.0),
        unit(Force, "N", 0, 1.0),
        unit(Force, "kN", 3, 1.0),
        unit(Force, "lbf", 0, POUND * STANDARD_GRAVITY),
        unit(Pressure, "bar", 5, 1.0),
        unit(Pressure, "Pa", 0, 1.0),
        unit(Pressure, "kPa", 3, 1.0),
        unit(Pressure, "MPa", 6, 1.0),
        unit(Pressure, "GPa", 9, 1.0),
        unit(Pressure, "psi", 0, POUND * STANDARD_GRAVITY / (INCH * INCH)),
        unit(Torque, "N m", 0, 1.0),
        unit(Torque, "kN m", 3, 1.0),
        unit(Torque, "lbf ft", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(Torque, "lbf in", 0, POUND * STANDARD_GRAVITY * INCH),
        unit(Density, "kg/m3", 0, 1.0),
        unit(Density, "g/cm3", 3, 1.0),
        unit(Density, "kg/dm3", 3, 1.0),
        unit(Density, "lb/in3", 0, POUND / (INCH * INCH * INCH)),
        unit(Density, "lb/ft3", 0, POUND / (0.3048 * 0.3048 * 0.3048)),
        unit(Velocity, "mm/s", -3, 1.0),
        unit(Velocity, "m/s", 0, 1.0),
        unit(Velocity, "in/s", 0, INCH),
        unit(Acceleration, "m/s2", 0, 1.0),
        unit(Acceleration, "mm/s2", -3, 1.0),
        unit(Area, "mm2", -6, 1.0),
        unit(Area, "cm2", -4, 1.0),
        unit(Area, "m2", 0, 1.0),
        unit(Area, "in2", 0, INCH * INCH),
        unit(Temperature, "K", 0, 1.0),
        from_zero(Temperature, "degC", 1.0, ICE_POINT),
        from_zero(Temperature, "degF", 1.0 / 1.8, ICE_POINT - 32.0 / 1.8),
        unit(Energy, "J", 0, 1.0),
        unit(Energy, "kJ", 3, 1.0),
        unit(Energy, "ft lbf", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(SpecificEnergy, "MJ/kg", 6, 1.0),
        unit(SpecificEnergy, "kJ/kg", 3, 1.0),
        unit(SpecificEnergy, "J/kg", 0, 1.0),
        unit(SpecificHeat, "J/kg/K", 0, 1.0),
        unit(SpecificHeat, "kJ/kg/K", 3, 1.0),
        unit(HeatTransfer, "W/m2/K", 0, 1.0),
        unit(HeatTransfer, "kW/m2/K", 3, 1.0),
        unit(ThermalConductance, "W/K", 0, 1.0),
        unit(ThermalConductance, "kW/K", 3, 1.0),
        unit(HeatCapacity, "J/K", 0, 1.0),
        unit(HeatCapacity, "kJ/K", 3, 1.0),
        unit(Stiffness, "N/mm", 3, 1.0),
        unit(Stiffness, "N/m", 0, 1.0),
        unit(Stiffness, "kN/mm", 6, 1.0),
        unit(Stiffness, "N/um", 6, 1.0),
        unit(Stiffness, "MN/m", 6, 1.0),
        unit(Stiffness, "GN/m", 9, 1.0),
        unit(Stiffness, "lbf/in", 0, POUND * STANDARD_GRAVITY / INCH),
        unit(Damping, "N s/m", 0, 1.0),
        unit(Damping, "N s/mm", 3, 1.0),
        unit(Damping, "lbf s/in", 0, POUND * STANDARD_GRAVITY / INCH),
        unit(PressurePerSpeed, "bar s/m", 5, 1.0),
        unit(PressurePerSpeed, "kPa s/m", 3, 1.0),
        unit(PressurePerSpeed, "Pa s/m", 0, 1.0),
        unit(PressurePerSpeedSquared, "bar s2/m2", 5, 1.0),
        unit(PressurePerSpeedSquared, "kPa s2/m2", 3, 1.0),
        unit(PressurePerSpeedSquared, "Pa s2/m2", 0, 1.0),
        unit(Time, "s", 0, 1.0),
        unit(Time, "ms", -3, 1.0),
        unit(Time, "min", 0, 60.0),
        unit(Time, "h", 0, 3600.0),
        unit(Power, "kW", 3, 1.0),
        unit(Power, "W", 0, 1.0),
        unit(Power, "PS", 0, 75.0 * STANDARD_GRAVITY),
        unit(Power, "hp", 0, 550.0 * 0.3048 * POUND * STANDARD_GRAVITY),
        unit(AngularStiffness, "N m/rad", 0, 1.0),
        unit(AngularStiffness, "kN m/rad", 3, 1.0),
        unit(AngularStiffness, "MN m/rad", 6, 1.0),
        unit(AngularStiffness, "N m/deg", 0, 180.0 / PI),
        unit(AngularStiffness, "lbf in/rad", 0, POUND * STANDARD_GRAVITY * INCH),
        unit(AngularStiffness, "lbf ft/rad", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(AngularDamping, "N m s/rad", 0, 1.0),
        unit(AngularDamping, "lbf in s/rad", 0, POUND * STANDARD_GRAVITY * INCH),
        unit(AngularDamping, "lbf ft s/rad", 0, POUND * STANDARD_GRAVITY * 12.0 * INCH),
        unit(PerSpeed, "1/rpm", 0, 30.0 / PI),
        unit(PerSpeed, "s/rad", 0, 1.0),
        unit(Rate, "1/s", 0, 1.0),
        unit(Viscosity, "mPa s", -3, 1.0),
        unit(Viscosity, "Pa s", 0, 1.0),
        unit(Viscosity, "cP", -3, 1.0),
        unit(KinematicViscosity, "cSt", -6, 1.0),
        unit(KinematicViscosity, "mm2/s", -6, 1.0),
        unit(KinematicViscosity, "m2/s", 0, 1.0),
    ]
};

/// Other names that are read as a unit: they say the same.
pub const ALIASES: [(&str, &str); 5] =
    [("/min", "rpm"), ("1/min", "rpm"), ("r/min", "rpm"), ("rev/min", "rpm"), ("min-1", "rpm")];

/// The unit of this name: `kg m`, `kg*m`, `kg·m` and `kgm` are one, so are `m2`, `m^2` and `m²`.
pub(super) fn find_unit(text: &str) -> Option<&'static Unit> {
    let name = canonical(text);
    let name = ALIASES.iter().find(|(alias, _)| *alias == name).map_or(name, |(_, unit)| (*unit).to_string());
    UNITS
        .iter()
        .find(|unit| unit.name == name)
        .or_else(|| UNITS.iter().find(|unit| unit.name.contains(' ') && unit.name.replace(' ', "") == name))
}

pub(super) fn canonical(text: &str) -> String {
    let text = text
        .replace(['*', '·', '⋅', '\u{a0}'], " ")
        .replace('²', "2")
        .replace('³', "3")
        .replace('^', "")
        .replace("⁻¹", "-1")
        .replace(['µ', 'μ'], "u");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl Unit {
    /// Texts that may read back as `value`, the shortest first.
    pub(super) fn candidates(&self, value: f64) -> impl Iterator<Item = String> {
        let number = (value - self.zero) / self.factor;
        [Some(12), None].into_iter().map(move |digits| {
            let text = match digits {
                Some(digits) => format!("{number:.digits$e}"),
                None => format!("{number:e}"),
            };
            decimal(&text, -self.exponent)
        })
    }
}
