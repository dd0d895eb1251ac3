//! Loads of the main bearings at one speed, at any angle: what an optimum over speeds and angles asks for.

use crate::bearings::plan::{BearingPlan, BearingTrace};
use crate::bearings::request::{BearingPart, BearingRequest};
use crate::curves::true_peak::true_peak;
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::GasTrain;
use crate::torque::request::{Lever, TorqueError};
use lanchester_model::Engine;
use lanchester_numerics::about_zero;
use lanchester_results::Extreme;
use num_complex::Complex64;
use std::sync::Arc;

/// Angles of a revolution.
const SAMPLES: usize = 360;

/// How far beside a jump its sides are taken [rad].
const BESIDE: f64 = 1e-10;

/// Loads of all main bearings of an engine by its inertia, prepared for any speed.
#[derive(Debug, Clone)]
pub struct MainInertia {
    /// At the highest speed of the engine.
    plan: BearingPlan,
    trace: BearingTrace,
}

/// Loads of all main bearings of an engine by the gas of one speed.
#[derive(Debug, Clone)]
pub struct MainGas {
    train: GasTrain,
    trace: BearingTrace,
    /// Angles at which the gas jumps [rad].
    jumps: Vec<f64>,
}

/// Loads of all main bearings of an engine at one speed, throw by throw, of inertia and gas, as those of [`crate::bearing_loads`]:
/// journal on bearing, crankshaft 1 first, each from the free end on.
///
/// ```text
/// F(theta, W) = (W / W_0)^2 F_i(theta, W_0) + SUM over k of a_k F_g(theta; p_k)              (26.7)
/// ```
/// The load of the gas is linear in the pressures: with `SUM of a_k p_k` for pressures it is the same sum of the loads `F_g` of each.
#[derive(Debug, Clone)]
pub struct MainForces {
    inertia: Arc<MainInertia>,
    /// Share and load of each gas.
    gas: Vec<(f64, Arc<MainGas>)>,
    speed: f64,
    /// `(W / W_0)^2`.
    growth: f64,
    /// By main bearing: along x and y at equal angles [N].
    mains: Vec<[Vec<f64>; 2]>,
    /// Angles at which the gas jumps [rad], rising.
    jumps: Vec<f64>,
}

fn request(part: BearingPart) -> BearingRequest {
    BearingRequest { samples: SAMPLES, part, ..BearingRequest::default() }
}

impl MainInertia {
    /// Of `engine`.
    ///
    /// # Errors
    /// As [`crate::bearing_loads`].
    pub fn new(engine: &Engine) -> Result<MainInertia, TorqueError> {
        let plan = BearingPlan::new(engine, None, &request(BearingPart::Inertia))?;
        let mut trace = BearingTrace::default();
        plan.loads_into(&mut trace);
        Ok(MainInertia { plan, trace })
    }
}

impl MainGas {
    /// Of `engine` under `gas`, one entry a cylinder.
    ///
    /// # Errors
    /// As [`crate::bearing_loads`].
    pub fn new(engine: &Engine, gas: &[CylinderGas]) -> Result<MainGas, TorqueError> {
        let train = GasTrain::new(engine, gas, Lever::Exact)?;
        let mut plan = BearingPlan::new(engine, None, &request(BearingPart::Gas))?;
        plan.set_gas(&train);
        let mut trace = BearingTrace::default();
        plan.loads_into(&mut trace);
        let jumps = train.jumps(plan.period);
        Ok(MainGas { train, trace, jumps })
    }
}

impl MainForces {
    /// Of `engine` at `speed` of crankshaft 1 [rad/s] under `gas` of that speed, one entry a cylinder; `None`: inertia alone.
    ///
    /// # Errors
    /// As [`crate::bearing_loads`].
    pub fn new(engine: &Engine, gas: Option<&[CylinderGas]>, speed: f64) -> Result<MainForces, TorqueError> {
        let gas =
            gas.map(|gas| Ok::<_, TorqueError>((1.0, Arc::new(MainGas::new(engine, gas)?)))).transpose()?;
        Ok(MainForces::of(Arc::new(MainInertia::new(engine)?), gas.into_iter().collect(), speed))
    }

    /// At `speed` of crankshaft 1 [rad/s], positive, by `inertia` and by `gas`, each with its share of the pressures, all of one engine (weights on
    /// its crankshafts may differ).
    pub fn of(inertia: Arc<MainInertia>, gas: Vec<(f64, Arc<MainGas>)>, speed: f64) -> MainForces {
        let growth = (speed / inertia.plan.speed).powi(2);
        let count = inertia.plan.grid.len();
        let along = |main: usize, axis: usize| {
            let mut sum: Vec<f64> =
                inertia.trace.mains[main][axis][..count].iter().map(|load| growth * load).collect();
            for (share, gas) in &gas {
                for (sum, load) in sum.iter_mut().zip(&gas.trace.mains[main][axis]) {
                    *sum += share * load;
                }
            }
            sum
        };
        let mains = (0..inertia.plan.mains.len()).map(|main| [0, 1].map(|axis| along(main, axis))).collect();
        let mut jumps: Vec<f64> = gas.iter().flat_map(|(_, gas)| gas.jumps.iter().copied()).collect();
        jumps.sort_by(f64::total_cmp);
        jumps.dedup_by(|next, kept| *next - *kept < BESIDE);
        MainForces { inertia, gas, speed, growth, mains, jumps }
    }

    /// Speed of crankshaft 1 [rad/s].
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Number of main bearings.
    pub fn count(&self) -> usize {
        self.mains.len()
    }

    /// Angles of crankshaft 1 [rad] over one period with their weights, which add up to 1: sums over them are means over the cycle by
    /// the trapezoidal rule on equal steps. At a jump of the gas there is an angle on either side.
    pub fn nodes(&self) -> Vec<(f64, f64)> {
        let period = self.period();
        let apart = |a: f64, b: f64| about_zero(a - b, period).abs();
        let free = |theta: &f64| self.jumps.iter().all(|jump| apart(*jump, *theta) > 2.0 * BESIDE);
        let mut angles: Vec<(f64, bool)> =
            self.inertia.plan.grid.theta().iter().copied().filter(free).map(|theta| (theta, false)).collect();
        // On either side, unless the next jump is as close.
        for jump in &self.jumps {
            let sides = [(jump - BESIDE, false), (jump + BESIDE, true)];
            angles.extend(sides.map(|(theta, after)| (theta.rem_euclid(period), after)));
        }
        angles.sort_by(|a, b| a.0.total_cmp(&b.0));
        angles.dedup_by(|next, kept| next.0 - kept.0 < BESIDE && next.1 == kept.1);
        let count = angles.len();
        let gap = |k: usize| {
            let next = (k + 1) % count;
            // Nothing lies between the two sides of a jump.
            let width = (angles[next].0 - angles[k].0).rem_euclid(period);
            if angles[next].1 && width < 3.0 * BESIDE { 0.0 } else { width }
        };
        let total: f64 = (0..count).map(gap).sum();
        let weight = |k: usize| 0.5 * (gap(k) + gap((k + count - 1) % count)) / total;
        (0..count).map(|k| (angles[k].0, weight(k))).collect()
    }

    /// Load of main bearing `main`, from 0, at the nodes [N].
    pub fn at_nodes(&self, main: usize, nodes: &[(f64, f64)]) -> Vec<Complex64> {
        let [x, y] = &self.mains[main];
        let step = self.period() / x.len() as f64;
        let load = |(theta, _): &(f64, f64)| {
            let place = theta / step;
            let nearest = place.round() as usize % x.len();
            match (place - place.round()).abs() < 1e-12 * place.max(1.0) {
                true => Complex64::new(x[nearest], y[nearest]),
                false => self.at(main, *theta),
            }
        };
        nodes.iter().map(load).collect()
    }

    /// Period of the loads [rad].
    fn period(&self) -> f64 {
        self.inertia.plan.period
    }

    /// Load of main bearing `main`, from 0, at any angle `theta` of crankshaft 1 [rad]: `F_x + i F_y` [N].
    pub fn at(&self, main: usize, theta: f64) -> Complex64 {
        let gas = |cylinder: usize, theta: f64| {
            let of = |(share, gas): &(f64, Arc<MainGas>)| {
                let piston = &gas.train.pistons[cylinder];
                share * piston.force.at(piston.own_angle(theta))
            };
            self.gas.iter().map(of).sum::<f64>() / self.growth
        };
        self.growth * self.inertia.plan.main_at(main, theta, &gas)
    }

    /// Largest load of main bearing `main`, from 0, at equal angles, every degree of crankshaft 1 [N]: no more than its peak.
    pub fn largest_sample(&self, main: usize) -> f64 {
        let [x, y] = &self.mains[main];
        x.iter().zip(y).map(|(x, y)| x * x + y * y).fold(0.0, f64::max).sqrt()
    }

    /// Largest load of main bearing `main`, from 0, over the continuous cycle, with its angle [N].
    pub fn peak(&self, main: usize) -> Extreme {
        let [x, y] = &self.mains[main];
        let sizes: Vec<f64> = x.iter().zip(y).map(|(x, y)| (x * x + y * y).sqrt()).collect();
        true_peak(&sizes, self.period(), &self.jumps, |theta| self.at(main, theta).norm_sqr().sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearings::result::bearing_loads;
    use lanchester_results::{End, PeriodicCurve};
    use std::f64::consts::TAU;

    /// The loads are those of the bearings, in peak and at every angle.
    #[test]
    fn as_the_bearings_have_them() {
        let text = lanchester_file::template("in-line-4").expect("it is in the gallery").text;
        let engine = lanchester_file::read(text).engine().expect("the gallery has no mistakes");
        let knots: Vec<f64> = (0..720).map(|k| TAU * f64::from(k) / 360.0).collect();
        let values: Vec<f64> = knots.iter().map(|t| 1e5 + 5e6 * (-(t / 0.5 - 1.3).powi(2)).exp()).collect();
        let pressure = PeriodicCurve::through(2.0 * TAU, knots, &values).expect("it is a curve");
        let crankcase = PeriodicCurve::constant(2.0 * TAU, 1e5).expect("it is a curve");
        let gas = vec![CylinderGas { cylinder: pressure, crankcase }; engine.cylinders.len()];
        let ends = |low: f64, high: f64| [low, high].map(|value| End { value, slope: 0.0 });
        let steps = PeriodicCurve::from_ends(2.0 * TAU, vec![0.7, 2.0], &[ends(4e6, 3e6), ends(1e5, 1e5)]);
        let jumping =
            CylinderGas { cylinder: steps.expect("it is a curve"), crankcase: gas[0].crankcase.clone() };
        let jumping = vec![jumping; engine.cylinders.len()];
        for gas in [None, Some(gas.as_slice()), Some(jumping.as_slice())] {
            let forces = MainForces::new(&engine, gas, 300.0).expect("it is held");
            let request = BearingRequest { speed: Some(300.0), ..BearingRequest::default() };
            let loads = bearing_loads(&engine, gas, &request).expect("it is held");
            assert_eq!(forces.count(), loads.mains.len());
            for (main, known) in loads.mains.iter().enumerate() {
                let peak = forces.peak(main);
                assert!((peak.value - known.load.peak.value).abs() < 1e-12 * peak.value);
                assert!(peak.value >= forces.largest_sample(main));
                let at = forces.at(main, 1.234).norm();
                assert!(at <= known.load.peak.value * (1.0 + 1e-12));
                let nodes = forces.nodes();
                assert!((nodes.iter().map(|node| node.1).sum::<f64>() - 1.0).abs() < 1e-12);
                let loads = forces.at_nodes(main, &nodes);
                let there = forces.at(main, nodes[77].0);
                assert!((there - loads[77]).norm() < 1e-9 * known.load.peak.value);
                let mean: f64 = nodes.iter().zip(&loads).map(|(node, load)| node.1 * load.norm()).sum();
                assert!((mean - known.load.mean).abs() < 1e-4 * mean, "{mean} {}", known.load.mean);
            }
        }
    }
}
