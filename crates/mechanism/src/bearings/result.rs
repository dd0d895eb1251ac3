//! Loads of pistons, pins and bearings over the cycle, in the frames in which they wear.

use crate::bearings::plan::{BearingPlan, BearingTrace};
use crate::bearings::request::{BearingPart, BearingRequest};
use crate::curves::true_mean::true_mean;
use crate::curves::true_peak::true_peak;
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::GasTrain;
use crate::torque::request::{Lever, TorqueError};
use crate::train::rod_place::RodLinkage;
use lanchester_model::Engine;
use lanchester_results::Extreme;
use num_complex::Complex64;
use serde::Serialize;

/// Version of these structures; raised when a field changes its meaning or goes.
pub const BEARINGS_VERSION: u32 = 1;

/// Loads of all bearings at one speed.
///
/// No weight, no play, no friction, no oil film; rigid parts; main bearings throw by throw, as if the shaft were cut at each of them.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingLoads {
    /// [`BEARINGS_VERSION`].
    pub version: u32,
    /// Name of the engine.
    pub engine: String,
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    /// Which loads count.
    pub part: BearingPart,
    /// Whether the weights on the crankshafts count.
    pub counterweights: bool,
    /// Period [rad] of crankshaft 1.
    pub period: f64,
    /// Crank angle [rad] of every trace, from 0, one period, end point excluded.
    pub theta: Vec<f64>,
    /// By cylinder.
    pub cylinders: Vec<CylinderBearings>,
    /// Main bearings: crankshaft 1 first, each from the free end on.
    pub mains: Vec<MainBearing>,
    /// Numbers of the crankshafts, from 1, of which no bearing is told because they have no throw.
    pub without_mains: Vec<usize>,
}

/// Piston, pins and rod of one cylinder.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct CylinderBearings {
    /// Its number, from 1.
    pub cylinder: usize,
    /// Side thrust: piston on the cylinder wall along `v` [N].
    pub side_thrust: Vec<f64>,
    /// Largest of its sizes over the continuous angle; `value` keeps the sign.
    pub largest_thrust: Extreme,
    /// Rod on the piston pin, `u + i v` of the cylinder frame [N].
    pub piston_pin: PinLoad,
    /// Rod on its lower pin, `x + i y` of the block's frame [N]: the crankpin, with all that a master's articulated rods bring, or
    /// the knuckle pin of an articulated rod. The big-end masses count.
    pub lower_pin: PinLoad,
    /// The same on the crankpin along the throw, positive away from the crank axis [N]; empty for an articulated rod.
    pub radial: Vec<f64>,
    /// And across it, positive where it drives the crankshaft [N]: torque over crank radius. Empty for an articulated rod.
    pub tangential: Vec<f64>,
    /// The lower pin on the rod's bearing in the rod's frame, real part along the rod towards the piston [N].
    #[schemars(with = "Vec<[f64; 2]>")]
    pub rod_frame: Vec<Complex64>,
}

/// A main bearing.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MainBearing {
    /// Number of its crankshaft, from 1.
    pub crankshaft: usize,
    /// Its number on that crankshaft, from 1.
    pub main: usize,
    /// Its plane [m], from the origin.
    pub z: f64,
    /// Journal on the bearing, `x + i y` of the block's frame [N].
    pub load: PinLoad,
    /// Bearing on the journal in the journal's frame: real part along throw 1 of its crankshaft, imaginary part a quarter turn on in
    /// the sense of increasing angles [N].
    #[schemars(with = "Vec<[f64; 2]>")]
    pub journal_frame: Vec<Complex64>,
}

/// A load over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PinLoad {
    /// At every angle [N].
    #[schemars(with = "Vec<[f64; 2]>")]
    pub load: Vec<Complex64>,
    /// Largest size and its angle, over the continuous angle.
    pub peak: Extreme,
    /// Mean size over the continuous angle [N].
    pub mean: f64,
}

impl PinLoad {
    /// From its samples at equal angles of `period` and its value at any angle.
    fn of(load: Vec<Complex64>, period: f64, jumps: &[f64], value: impl Fn(f64) -> Complex64) -> PinLoad {
        let sizes: Vec<f64> = load.iter().map(|force| force.norm()).collect();
        let mean = true_mean(&sizes, period, jumps, |theta| value(theta).norm());
        let peak = true_peak(&sizes, period, jumps, |theta| value(theta).norm());
        PinLoad { load, peak, mean }
    }

    /// Pressures on a bearing of this size.
    pub fn pressure(&self, size: BearingSize) -> BearingPressure {
        let area = size.diameter * size.width;
        BearingPressure { size, mean: self.mean / area, peak: self.peak.value / area }
    }
}

/// Size of a plain bearing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingSize {
    /// Diameter of the pin or journal [m].
    pub diameter: f64,
    /// Bearing width [m].
    pub width: f64,
}

/// Load over the projected area `diameter * width` [Pa].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BearingPressure {
    /// Of which size.
    pub size: BearingSize,
    /// Mean over the cycle.
    pub mean: f64,
    /// Largest.
    pub peak: f64,
}

/// Loads of the bearings of `engine` under `gas`, one entry a cylinder; `None`: of inertia alone.
///
/// # Errors
/// As [`crate::torque`].
pub fn bearing_loads(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    request: &BearingRequest,
) -> Result<BearingLoads, TorqueError> {
    let plan = BearingPlan::new(engine, gas, request)?;
    let mut trace = BearingTrace::default();
    plan.loads_into(&mut trace);
    let theta = plan.grid.theta().to_vec();
    let train = match gas.filter(|_| request.part != BearingPart::Inertia) {
        Some(gas) => Some(GasTrain::new(engine, gas, Lever::Exact)?),
        None => None,
    };
    let force = |cylinder: usize, theta: f64| {
        let piston = train.as_ref().map(|train| &train.pistons[cylinder]);
        piston.map_or(0.0, |piston| piston.force.at(piston.own_angle(theta)))
    };
    let jumps = train.as_ref().map_or_else(Vec::new, |train| train.jumps(plan.period));
    let count = theta.len();
    let cylinders = trace
        .rods
        .iter()
        .enumerate()
        .map(|(index, rod)| {
            let complex = |c: &[Vec<f64>; 2]| joined(c, count);
            let linkage = RodLinkage::new(engine, index)?;
            let lower_pin = complex(&rod.lower_pin);
            let [radial, tangential] = on_crankpin(engine, index, &theta, &lower_pin);
            let rod_frame = theta
                .iter()
                .zip(&lower_pin)
                .map(|(theta, force)| -force * Complex64::cis(-linkage.at(*theta).direction[0]))
                .collect();
            let side_thrust: Vec<f64> = rod.thrust[..count].iter().map(|thrust| -thrust).collect();
            let sizes: Vec<f64> = side_thrust.iter().map(|thrust| thrust.abs()).collect();
            let thrust_at = |theta: f64| -plan.rod_at(index, theta, &force).thrust;
            let size = true_peak(&sizes, plan.period, &jumps, |theta| thrust_at(theta).abs());
            let sign = if thrust_at(size.theta) < 0.0 { -1.0 } else { 1.0 };
            Ok(CylinderBearings {
                cylinder: index + 1,
                largest_thrust: Extreme { value: sign * size.value, theta: size.theta },
                side_thrust,
                piston_pin: PinLoad::of(complex(&rod.piston_pin), plan.period, &jumps, |theta| {
                    plan.rod_at(index, theta, &force).piston_pin
                }),
                radial,
                tangential,
                rod_frame,
                lower_pin: PinLoad::of(lower_pin, plan.period, &jumps, |theta| {
                    plan.rod_at(index, theta, &force).lower_pin
                }),
            })
        })
        .collect::<Result<Vec<_>, TorqueError>>()?;
    let mains = plan.mains.iter().zip(&trace.mains).enumerate().map(|(place, (&(crankshaft, z), load))| {
        let before = plan.mains[..place].iter().filter(|main| main.0 == crankshaft).count();
        let load = joined(load, count);
        let shaft = &engine.crankshafts[crankshaft];
        let journal = |(theta, force): (&f64, &Complex64)| {
            -force * Complex64::cis(-(shaft.ratio.value() * theta + shaft.phase))
        };
        MainBearing {
            crankshaft: crankshaft + 1,
            main: before + 1,
            z,
            journal_frame: theta.iter().zip(&load).map(journal).collect(),
            load: PinLoad::of(load, plan.period, &jumps, |theta| plan.main_at(place, theta, &force)),
        }
    });
    let mains = mains.collect();
    let bare = |index: &usize| plan.mains.iter().all(|main| main.0 != *index);
    let without_mains = (0..engine.crankshafts.len()).filter(bare).map(|index| index + 1).collect();
    Ok(BearingLoads {
        version: BEARINGS_VERSION,
        engine: engine.name.clone(),
        speed: plan.speed,
        part: request.part,
        counterweights: request.counterweights,
        period: plan.period,
        theta,
        cylinders,
        mains,
        without_mains,
    })
}

/// Forces on the crankpin along and across its throw; empty on a knuckle pin.
fn on_crankpin(engine: &Engine, index: usize, theta: &[f64], forces: &[Complex64]) -> [Vec<f64>; 2] {
    let cylinder = &engine.cylinders[index];
    if crate::train::mechanism::master_of(cylinder).is_some() {
        return [Vec::new(), Vec::new()];
    }
    let ratio = engine.crankshafts[engine.throws[cylinder.throw].crankshaft].ratio;
    let sense = f64::from(ratio.numerator().signum());
    let turned = theta.iter().zip(forces).map(|(theta, force)| {
        let on_pin = force * Complex64::cis(-engine.pin_angle(cylinder.throw, *theta));
        (on_pin.re, sense * on_pin.im)
    });
    let (radial, tangential) = turned.unzip();
    [radial, tangential]
}

fn joined([re, im]: &[Vec<f64>; 2], count: usize) -> Vec<Complex64> {
    re[..count].iter().zip(im).map(|(re, im)| Complex64::new(*re, *im)).collect()
}
