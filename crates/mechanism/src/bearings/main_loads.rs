//! Loads of the main bearings in two numbers each: root mean square and peak over the cycle.

use crate::bearings::plan::{BearingPlan, BearingTrace};
use crate::bearings::request::{BearingPart, BearingRequest};
use crate::curves::true_peak::true_peak;
use crate::torque::request::TorqueError;
use lanchester_model::Engine;
use lanchester_results::Extreme;
use serde::Serialize;

/// Angles of a revolution: many more than the loads of inertia have orders that count.
const SAMPLES: usize = 360;

/// A main bearing under the inertia of pistons, rods, throws and counterweights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct MainInertiaLoad {
    /// Number of its crankshaft, from 1.
    pub crankshaft: usize,
    /// Its number on that crankshaft from the free end, from 1.
    pub main: usize,
    /// Its plane [m], from the origin.
    pub z: f64,
    /// Root mean square of the load over the cycle [N].
    pub rms: f64,
    /// Largest load over the continuous cycle, with its angle [N].
    pub peak: Extreme,
}

/// Load of inertia on every main bearing at `speed` of crankshaft 1 [rad/s]; `None`: the highest of the engine. The main bearings
/// are those of [`crate::bearing_loads`]: throw by throw, rigid, no gas, no weight. Crankshaft 1 first, each from the free end on;
/// none for a crankshaft without throws.
///
/// ```text
/// rms^2 = 1/N SUM over j of |F(j period / N)|^2      exact for a load whose orders end below N/2 (Parseval)
/// ```
///
/// # Errors
/// As [`crate::bearing_loads`].
pub fn main_inertia_loads(engine: &Engine, speed: Option<f64>) -> Result<Vec<MainInertiaLoad>, TorqueError> {
    let request =
        BearingRequest { speed, part: BearingPart::Inertia, counterweights: true, samples: SAMPLES };
    let plan = BearingPlan::new(engine, None, &request)?;
    let mut trace = BearingTrace::default();
    plan.loads_into(&mut trace);
    let count = plan.angles();
    let no_gas = |_: usize, _: f64| 0.0;
    let mains = plan.mains.iter().zip(&trace.mains).enumerate().map(|(place, (&(crankshaft, z), [x, y]))| {
        let squares: Vec<f64> = x[..count].iter().zip(y).map(|(x, y)| x * x + y * y).collect();
        let sizes: Vec<f64> = squares.iter().map(|square| square.sqrt()).collect();
        let before = plan.mains[..place].iter().filter(|main| main.0 == crankshaft).count();
        MainInertiaLoad {
            crankshaft: crankshaft + 1,
            main: before + 1,
            z,
            rms: (squares.iter().sum::<f64>() / count as f64).sqrt(),
            peak: true_peak(&sizes, plan.period, &[], |theta| plan.main_at(place, theta, &no_gas).norm()),
        }
    });
    Ok(mains.collect())
}
