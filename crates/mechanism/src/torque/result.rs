//! What a torque calculation returns: plain data, SI and radians.

use crate::speed::energy::EnergyVariation;
use crate::torque::firing_chart::FiringChart;
use crate::torque::request::Lever;
use lanchester_results::OrderLoads;
use lanchester_results::{Extreme, Extremes};
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const TORQUE_VERSION: u32 = 1;

/// Torque of an engine at one speed: gas, inertia, and both together.
///
/// All torques are at crankshaft 1, positive in the sense of rotation, without friction: net indicated.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Torque {
    /// [`TORQUE_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Lever of gas and inertia.
    pub lever: Lever,
    /// Whether there is gas. Without it its torques and works are 0, and pressures and volumes are left out.
    pub with_gas: bool,
    /// Period [rad] of crankshaft 1: whole revolutions and whole working cycles.
    pub period: f64,
    /// Crank angle [rad] of every trace, from 0, one period, end point excluded.
    pub theta: Vec<f64>,
    /// Gas torque [N m].
    pub gas: Vec<f64>,
    /// Inertia torque at constant speed [N m].
    pub inertia: Vec<f64>,
    /// Extremes of the gas torque over the continuous angle.
    pub gas_extremes: Extremes,
    /// Extremes of the inertia torque.
    pub inertia_extremes: Extremes,
    /// Extremes of both together.
    pub total_extremes: Extremes,
    /// The engine in numbers.
    pub indicated: Indicated,
    /// Energy that both together store and give back, per period.
    pub energy: EnergyVariation,
    /// Energy that gas alone stores and gives back.
    pub gas_energy: EnergyVariation,
    /// Loads by order, gas and inertia together: order 0 (the means), the whole orders, and the fractions that working cycles and
    /// gears bring. Of gas they have roll moment and shaft torque alone.
    pub orders: Vec<OrderLoads>,
    /// Torque by order, split: the orders of `orders`.
    pub harmonics: Vec<TorqueHarmonic>,
    /// By cylinder.
    pub cylinders: Vec<CylinderTorque>,
    /// When they fire.
    pub firing: FiringChart,
}

/// Indicated numbers: from the pressures alone, net (the whole working cycle, pumping included), without friction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Indicated {
    /// Mean torque at crankshaft 1 [N m].
    pub torque: f64,
    /// Power [W]: mean torque times speed.
    pub power: f64,
    /// Swept volume of all cylinders [m^3], of their true strokes.
    pub displacement: f64,
    /// Mean effective pressure of the gas in the cylinders, net [Pa]: their work over the swept volume.
    pub imep: f64,
    /// Mean effective pressure of what is under the pistons [Pa], positive where it takes work from the crank.
    pub crankcase_mep: f64,
    /// Torque a unit of mean effective pressure [m^3]: swept volumes over the angles of their cycles, at crankshaft 1.
    pub torque_per_mep: f64,
    /// Mean piston speed of the fastest cylinder [m/s]: two strokes a revolution.
    pub mean_piston_speed: f64,
    /// Highest cylinder pressure of all cylinders [Pa], absolute.
    pub peak_pressure: f64,
}

/// One order of the torque, modulus = amplitude; order 0 is the mean.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueHarmonic {
    /// Cycles per revolution of crankshaft 1.
    pub order: f64,
    /// Gas [N m].
    #[schemars(with = "[f64; 2]")]
    pub gas: Complex64,
    /// Inertia [N m].
    #[schemars(with = "[f64; 2]")]
    pub inertia: Complex64,
}

impl TorqueHarmonic {
    /// Both together [N m].
    pub fn total(&self) -> Complex64 {
        self.gas + self.inertia
    }
}

/// Torque, work and energy at one of several speeds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct TorqueAtSpeed {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Mean torque, power and pressures, net indicated.
    pub indicated: Indicated,
    /// Extremes of gas and inertia together [N m].
    pub extremes: Extremes,
    /// Energy that both together store and give back.
    pub energy: EnergyVariation,
}

impl Torque {
    /// What is told of one of several speeds.
    pub fn at_speed(&self) -> TorqueAtSpeed {
        TorqueAtSpeed {
            speed: self.speed,
            indicated: self.indicated,
            extremes: self.total_extremes,
            energy: self.energy,
        }
    }
}

/// One cylinder.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderTorque {
    /// Its number, from 1.
    pub cylinder: usize,
    /// Crank angle at which it fires [rad]: its top dead centre.
    pub firing_angle: f64,
    /// Gas torque over the period [N m].
    pub gas: Vec<f64>,
    /// Inertia torque over the period [N m].
    pub inertia: Vec<f64>,
    /// Absolute pressure in the cylinder over the period [Pa].
    pub pressure: Vec<f64>,
    /// Absolute pressure under the piston over the period [Pa].
    pub crankcase: Vec<f64>,
    /// Volume that the piston has left free below its top dead centre [m^3]: with `pressure` the p-V diagram, without the
    /// clearance volume.
    pub volume: Vec<f64>,
    /// Clearance volume [m^3], of the compression ratio of the engine's gas; `None` where the file gives none.
    pub clearance: Option<f64>,
    /// Work in one working cycle.
    pub work: IndicatedWork,
    /// Highest cylinder pressure [Pa] and the angle after firing [rad] at which it stands, from -half to half a working cycle.
    pub peak_pressure: Extreme,
}

/// Work of one cylinder in one working cycle [J], by routes that share no quadrature.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct IndicatedWork {
    /// Swept volume [m^3].
    pub swept: f64,
    /// Of the torque, over the crank angle.
    pub by_torque: f64,
    /// Of the pressures over the volume: from their orders and those of the travel.
    pub by_volume: f64,
    /// Of the force that the rods pass to the crankpin, through side thrust and rod, with the exact lever.
    pub by_rods: f64,
    /// Of the gas in the cylinder alone; net.
    pub cylinder: f64,
    /// That between the bottom dead centres around firing: compression and power; gross.
    pub gross: f64,
    /// What is under the piston, negative where it takes work from the crank.
    pub crankcase: f64,
}

impl IndicatedWork {
    /// Net indicated mean effective pressure [Pa].
    pub fn imep(&self) -> f64 {
        self.cylinder / self.swept
    }

    /// Gross indicated mean effective pressure [Pa].
    pub fn gross_imep(&self) -> f64 {
        self.gross / self.swept
    }

    /// Pumping mean effective pressure [Pa]: gross minus net, positive where gas exchange takes work.
    pub fn pumping_mep(&self) -> f64 {
        (self.gross - self.cylinder) / self.swept
    }
}
