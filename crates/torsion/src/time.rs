//! A check in the time domain: periodic motion with the inertia of rods and pistons as it varies, torques over the true angle of each throw.
//!
//! With `theta_i = W t + phi_i` and the load `L` at the end of the chain,
//!
//! ```text
//! J_i(theta_i) phi_i'' = T_i(theta_i) - 1/2 J_i'(theta_i) theta_i'^2 - c_i phi_i' - SUM (k + c d/dt)(phi_i - phi_j) - L           (50.15)
//! ```
//! `T_i` is the torque of the gas; `J_i` is the mean inertia and those orders that the torque of the masses stands for: `J_k = 2 i T_k / n_k`. Loss factors
//! have no time domain, and pendulums swing as their springs say: both sides of a comparison take the viscous damping of the same loss at one frequency ([`as_viscous`]).

use crate::chain::Chain;
use crate::energy::ChainEnergy;
use crate::error::TorsionError;
use crate::excitation::Excitation;
use crate::sweep::load_station;
use lanchester_numerics::{Dop853, Function, Lu, Outcome, Settings};
use num_complex::Complex64;
use serde::Serialize;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Samples of a period.
const SAMPLES: usize = 960;
/// Steps of Newton's iteration.
const MOST_STEPS: usize = 12;
/// Relative tolerance of the integration.
const TOLERANCE: f64 = 1e-10;

/// Periodic motion in the time domain.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PeriodicMotion {
    /// Mean speed of the reference [rad/s].
    pub speed: f64,
    /// Whether inertia varied and torques followed the true angle.
    pub varies: bool,
    /// Load at the end of the chain that holds the mean speed, at the reference [N m].
    pub load: f64,
    /// Angle of each station over the period at its own speed [rad].
    pub angles: Vec<Vec<f64>>,
    /// Amplitude of each shaft's torque, half of largest less least [N m].
    pub torques: Vec<f64>,
    /// Amplitude of the twist between nose and flywheel [rad].
    pub twist: f64,
    /// Largest difference of the state after a period and before, over the largest state.
    pub closure: f64,
    /// Work and energy over the period.
    pub energy: ChainEnergy,
    /// Newton steps.
    pub steps: usize,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
}

/// The chain with viscous damping in place of loss factors, equal in loss at the angular frequency `frequency` [rad/s]: `c = k loss / frequency`.
///
/// # Errors
/// A frequency that is not above 0.
pub fn as_viscous(chain: &Chain, frequency: f64) -> Result<Chain, TorsionError> {
    if !(frequency > 0.0 && frequency.is_finite()) {
        return Err(TorsionError::Number {
            quantity: "frequency [rad/s]",
            needed: "more than 0",
            got: frequency,
        });
    }
    chain.with(|_, shafts| {
        for shaft in shafts {
            shaft.damping += shaft.stiffness * shaft.loss_factor / frequency;
            shaft.loss_factor = 0.0;
        }
    })
}

/// Orders of a station at the reference: torque of the gas, and its inertia.
struct Driven {
    station: usize,
    mean: f64,
    gas: Vec<Complex64>,
    /// Torque of the masses over speed squared.
    masses: Vec<Complex64>,
}

struct Motion<'a> {
    chain: &'a Chain,
    inertia: Vec<f64>,
    ground: Vec<f64>,
    links: Vec<[f64; 2]>,
    driven: Vec<Driven>,
    step: f64,
    speed: f64,
    load_at: usize,
    varies: bool,
}

impl Motion<'_> {
    /// Torque of the gas, and of the masses: their inertia and its slope.
    fn at(&self, driven: &Driven, theta: f64) -> [f64; 4] {
        let turn = Complex64::cis(self.step * theta);
        let mut phase = Complex64::new(1.0, 0.0);
        let (mut gas, mut masses, mut inertia, mut slope) = (driven.mean, 0.0, 0.0, 0.0);
        for (k, (t, m)) in driven.gas.iter().zip(&driven.masses).enumerate() {
            phase *= turn;
            gas += (t * phase).re;
            let own = m * phase;
            let order = self.step * (k + 1) as f64;
            masses += own.re;
            // J_k = 2 i T_k / n, J' = Re(i n J_k e) = -2 Re(T_k e).
            inertia -= 2.0 * own.im / order;
            slope -= 2.0 * own.re;
        }
        [gas, masses, inertia, slope]
    }

    fn derivative(&self, t: f64, y: &[f64], dy: &mut [f64], load: f64) {
        let n = self.inertia.len();
        let (angle, rate) = y.split_at(n);
        let (first, second) = dy.split_at_mut(n);
        first.copy_from_slice(rate);
        for i in 0..n {
            second[i] = -self.ground[i] * rate[i];
        }
        second[self.load_at] -= load;
        for (shaft, [k, c]) in self.chain.shafts().iter().zip(&self.links) {
            let (a, b) = (shaft.from, shaft.to);
            let torque = k * (angle[a] - angle[b]) + c * (rate[a] - rate[b]);
            second[a] -= torque;
            second[b] += torque;
        }
        for driven in &self.driven {
            let i = driven.station;
            if self.varies {
                let [gas, _, inertia, slope] = self.at(driven, self.speed * t + angle[i]);
                let rate = self.speed + rate[i];
                second[i] += gas - 0.5 * slope * rate * rate;
                second[i] *= self.inertia[i] / (self.inertia[i] + inertia);
            } else {
                let [gas, masses, ..] = self.at(driven, self.speed * t);
                second[i] += gas + masses * self.speed * self.speed;
            }
        }
        for i in 0..n {
            second[i] /= self.inertia[i];
        }
    }

    /// Powers of gas, of the torque that stands for varying inertia, of the load and of the dampers [W].
    fn powers(&self, t: f64, y: &[f64], load: f64) -> [f64; 4] {
        let n = self.inertia.len();
        let (angle, rate) = y.split_at(n);
        let [mut gas, mut masses, mut damping] = [0.0; 3];
        for driven in &self.driven {
            let i = driven.station;
            let speed = self.speed + rate[i];
            let from = if self.varies { angle[i] } else { 0.0 };
            let [own, of_masses, ..] = self.at(driven, self.speed * t + from);
            gas += own * speed;
            if !self.varies {
                masses += of_masses * self.speed * self.speed * speed;
            }
        }
        for (c, rate) in self.ground.iter().zip(rate) {
            damping += c * rate * (self.speed + rate);
        }
        for (shaft, [_, c]) in self.chain.shafts().iter().zip(&self.links) {
            damping += c * (rate[shaft.from] - rate[shaft.to]).powi(2);
        }
        [gas, masses, load * (self.speed + rate[self.load_at]), damping]
    }

    /// Kinetic and elastic energy [J].
    fn energy(&self, t: f64, y: &[f64]) -> f64 {
        let n = self.inertia.len();
        let (angle, rate) = y.split_at(n);
        let mut inertia = self.inertia.clone();
        if self.varies {
            for driven in &self.driven {
                let [_, _, varying, _] = self.at(driven, self.speed * t + angle[driven.station]);
                inertia[driven.station] += varying;
            }
        }
        let kinetic: f64 = inertia.iter().zip(rate).map(|(j, rate)| j * (self.speed + rate).powi(2)).sum();
        let links = self.chain.shafts().iter().zip(&self.links);
        let elastic: f64 =
            links.map(|(shaft, [k, _])| k * (angle[shaft.from] - angle[shaft.to]).powi(2)).sum();
        0.5 * (kinetic + elastic)
    }

    /// State after a period; samples and energies of it where asked for.
    fn period(
        &self,
        start: &[f64],
        load: f64,
        evaluations: &mut u64,
        recorded: Option<&mut Recorded>,
    ) -> Result<Vec<f64>, TorsionError> {
        let n = start.len();
        let period = TAU / (self.step * self.speed);
        let mut settings = Settings::uniform(n, TOLERANCE);
        settings.absolute = (0..n).map(|i| if i < n / 2 { 1e-13 } else { 1e-13 * self.speed }).collect();
        settings.dense = recorded.is_some();
        let mut system = Function::new(n, |t, y: &[f64], dy: &mut [f64]| self.derivative(t, y, dy, load));
        let mut solver = Dop853::new(settings);
        let (mut t, mut y) = (0.0, start.to_vec());
        let mut next = 0;
        let mut recorded = recorded;
        let mut state = vec![0.0; n];
        let outcome = solver.run(&mut system, &mut t, &mut y, period, |step| {
            if let Some(recorded) = recorded.as_mut() {
                while next < SAMPLES && period * next as f64 / SAMPLES as f64 <= step.to {
                    step.at(period * next as f64 / SAMPLES as f64, &mut state);
                    recorded.states.push(state.clone());
                    next += 1;
                }
                let energy = &mut recorded.energy;
                step.gauss_points(period / SAMPLES as f64, |t, time, y| {
                    energy.add(time, self.powers(t, y, load))
                });
            }
            ControlFlow::Continue(())
        });
        *evaluations += solver.statistics().evaluations;
        match outcome {
            Outcome::Reached => {
                if let Some(recorded) = recorded {
                    recorded.energy =
                        recorded.energy.closed(self.energy(period, &y) - self.energy(0.0, start));
                }
                Ok(y)
            }
            other => Err(TorsionError::NotPeriodic {
                speed: self.speed,
                why: match other {
                    Outcome::TooManyEvaluations { limit } => {
                        format!("one period takes more than {limit} evaluations of the chain")
                    }
                    _ => "the motion left every bound".to_owned(),
                },
            }),
        }
    }
}

/// What a period leaves behind.
struct Recorded {
    /// States at [`SAMPLES`] instants.
    states: Vec<Vec<f64>>,
    energy: ChainEnergy,
}

/// Periodic motion at the mean speed `speed` [rad/s] by shooting: the state at the start and the load are those after which the state repeats. With `varies`
/// inertia and torques follow the true angle of each throw; without, it is the linear problem of [`crate::sweep`] in the time domain.
///
/// # Errors
/// [`TorsionError::NotPeriodic`]; torques that do not fit; loss factors, which have no time domain.
pub fn periodic_motion(
    chain: &Chain,
    excitation: &Excitation,
    speed: f64,
    varies: bool,
) -> Result<PeriodicMotion, TorsionError> {
    excitation.check(chain)?;
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(TorsionError::Number { quantity: "speed [rad/s]", needed: "more than 0", got: speed });
    }
    if let Some(shaft) = chain.shafts().iter().find(|shaft| shaft.loss_factor > 0.0) {
        return Err(TorsionError::Number {
            quantity: "loss factor of a shaft in the time domain",
            needed: "0",
            got: shaft.loss_factor,
        });
    }
    let n = chain.stations().len();
    let ratio = |station: usize| chain.stations()[station].ratio;
    let links = chain.shafts().iter().enumerate().map(|(index, shaft)| {
        [chain.referred_stiffness(index, speed), shaft.damping * shaft.ratio * shaft.ratio]
    });
    let mut driven: Vec<Driven> = Vec::new();
    for source in &excitation.sources {
        let own = ratio(source.station);
        let speedless = source.inertia.iter().map(|t| t * own);
        let gas = (0..excitation.count)
            .map(|k| (source.order(k, speed) - source.inertia[k] * (speed * speed)) * own);
        // Torques on one station act together.
        match driven.iter_mut().find(|other| other.station == source.station) {
            Some(other) => {
                other.mean += source.mean(speed) * own;
                other.gas.iter_mut().zip(gas).for_each(|(sum, t)| *sum += t);
                other.masses.iter_mut().zip(speedless).for_each(|(sum, t)| *sum += t);
            }
            None => driven.push(Driven {
                station: source.station,
                mean: source.mean(speed) * own,
                gas: gas.collect(),
                masses: speedless.collect(),
            }),
        }
    }
    let motion = Motion {
        chain,
        inertia: (0..n).map(|i| chain.referred_inertia(i)).collect(),
        ground: chain
            .stations()
            .iter()
            .map(|station| station.damping * station.ratio * station.ratio)
            .collect(),
        links: links.collect(),
        load_at: load_station(chain),
        driven,
        step: excitation.step,
        speed,
        varies,
    };
    let size = 2 * n + 1;
    let mean: f64 = motion.driven.iter().map(|driven| driven.mean).sum();
    let mut x = vec![0.0; size];
    x[2 * n] = mean;
    let mut evaluations = 0;
    let held = chain.flywheel();
    let residual = |x: &[f64], evaluations: &mut u64| -> Result<Vec<f64>, TorsionError> {
        let end = motion.period(&x[..2 * n], x[2 * n], evaluations, None)?;
        let mut r: Vec<f64> = end.iter().zip(x).map(|(after, before)| after - before).collect();
        r.push(x[held]);
        Ok(r)
    };
    let scale = |i: usize| match i {
        _ if i < n => 1e-4,
        _ if i < 2 * n => 1e-4 * speed,
        _ => 1e-3 * mean.abs().max(1.0),
    };
    let mut steps = 0;
    let mut closure = f64::INFINITY;
    let mut factors: Option<Lu<f64>> = None;
    while steps < MOST_STEPS {
        let r = residual(&x, &mut evaluations)?;
        let weigh = |i: usize, value: f64| if i < n { value.abs() } else { value.abs() / speed };
        let largest = (0..2 * n).map(|i| weigh(i, x[i])).fold(1e-12, f64::max);
        let before = closure;
        closure = (0..2 * n).map(|i| weigh(i, r[i])).fold(0.0, f64::max) / largest;
        if closure < 1e-7 || (steps > 2 && closure < 1e-5 && closure > 0.3 * before) {
            break;
        }
        // The matrix of differences serves as long as it helps.
        if factors.is_none() || closure > 0.1 * before {
            let mut matrix = vec![0.0; size * size];
            for column in 0..size {
                let mut moved = x.clone();
                moved[column] += scale(column);
                let other = residual(&moved, &mut evaluations)?;
                for row in 0..size {
                    matrix[row * size + column] = (other[row] - r[row]) / scale(column);
                }
            }
            let singular = |_| TorsionError::NotPeriodic {
                speed,
                why: "the matrix of Newton's iteration is singular".into(),
            };
            factors = Some(Lu::new(size, matrix).map_err(singular)?);
        }
        let mut change = r;
        if let Some(factors) = &factors {
            factors.solve(&mut change);
        }
        for (value, change) in x.iter_mut().zip(&change) {
            *value -= change;
        }
        steps += 1;
    }
    if closure.is_nan() || closure >= 1e-4 {
        return Err(TorsionError::NotPeriodic {
            speed,
            why: format!("after {steps} steps the state misses itself by {closure:.1e} of its size"),
        });
    }
    let mut recorded = Recorded { states: Vec::with_capacity(SAMPLES), energy: ChainEnergy::default() };
    motion.period(&x[..2 * n], x[2 * n], &mut evaluations, Some(&mut recorded))?;
    let Recorded { states, energy } = recorded;
    let half = |of: &dyn Fn(&[f64]) -> f64| {
        let (low, high) = states
            .iter()
            .map(|state| of(state))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        0.5 * (high - low)
    };
    let torques = chain.shafts().iter().zip(&motion.links).map(|(shaft, [k, c])| {
        let (a, b) = (shaft.from, shaft.to);
        half(&|y| k * (y[a] - y[b]) + c * (y[n + a] - y[n + b])) / shaft.ratio.abs()
    });
    let nose = chain.nose();
    Ok(PeriodicMotion {
        speed,
        varies,
        load: x[2 * n],
        torques: torques.collect(),
        twist: half(&|y| y[nose] - y[held]),
        angles: (0..n).map(|i| states.iter().map(|state| state[i] * ratio(i)).collect()).collect(),
        closure,
        energy,
        steps,
        evaluations,
    })
}
