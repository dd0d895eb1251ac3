//! Flywheel and cyclic speed fluctuation: inertia of the crank train over the angle, and the periodic speed under a constant load.
//!
//! ```text
//! E_kin = 1/2 J(theta) w^2
//! J     = J_0 + SUM over pistons of n^2 ( m s'^2 + J_rod beta'^2 + m_K |K'|^2 )                          (25.6)
//! 1/2 J w^2 = C + INTEGRAL from 0 to theta of (T_gas - T_mean)                                           (25.7)
//! J w w'    = T_gas - T_mean - 1/2 J' w^2
//! C:  2 pi R / w_mean = INTEGRAL over R revolutions of dtheta / w                                        (25.8)
//! ```
//! `J_0`: flywheel, crankshaft, balance shafts and gears of known inertia, the rods' big ends at their pins, each times the square of its speed ratio; constant. The rest
//! as in [`crate::train`], with `m_K` the big-end mass on a knuckle pin less what it has on the crankpin. The torque of inertia is
//! in `J(theta)`: only the gas does work. No friction and a load that takes the mean torque at every angle: the speed is periodic.

use crate::curves::extremes::grid_extremes;
use crate::inertia::request::{LoadError, MAX_REVOLUTIONS};
use crate::speed::energy::{Breaks, STRETCHES};
use crate::speed::ripple::{FLYWHEEL_VERSION, SpeedRipple, TrainInertia, TurningInertia};
use crate::speed::ripple_outcome::{KnownInertia, RippleOutcome, STOPPED};
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::GasTrain;
use crate::torque::outer_torque::OuterTorque;
use crate::torque::request::{Lever, TorqueError, TorqueRequest};
use crate::train::mechanism::{Mechanism, period};
use lanchester_model::{Engine, RodJoint, greatest_common_divisor};
use lanchester_results::{End, PeriodicCurve};
use lanchester_results::{Extreme, Extremes};
use serde::Serialize;
use std::f64::consts::TAU;

/// Angles of a revolution at which the ripple is listed, and between which the square of its speed is taken as cubic.
const SAMPLES: usize = 720;

/// A flywheel for a wanted fluctuation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FlywheelNeed {
    /// Mean speed at which it is kept [rad/s].
    pub speed: f64,
    /// Wanted fluctuation `C_s = (w_max - w_min) / w_mean` [1].
    pub fluctuation: f64,
    /// Inertia of everything by the formula `J = dE / (C_s w^2)` [kg m^2], book, eq. 25.4.
    pub by_formula: f64,
    /// Mean inertia that the train has without its flywheel [kg m^2].
    pub train: f64,
    /// Flywheel by the formula [kg m^2]: what is left, not below zero.
    pub flywheel_by_formula: f64,
    /// Flywheel with which the true speed, of variable inertia, just keeps the fluctuation [kg m^2]; 0 where none is needed,
    /// `None` where none up to half a million times the formula's keeps it.
    pub flywheel: Option<f64>,
    /// Whether the inertia of the crankshafts is known; if not, `train` leaves it out and the flywheels include it.
    pub crankshaft_known: bool,
}

/// The kinetic energy of an engine's train, prepared.
struct KineticTrain {
    /// At one rad/s.
    mechanism: Mechanism,
    /// What does not change with the angle [kg m^2].
    constant: f64,
    big_ends: f64,
    /// Balance shafts and gears of known inertia.
    geared: f64,
    given: TurningInertia,
    /// Revolutions of crankshaft 1 after which all shafts stand as before.
    revolutions: u32,
}

impl KineticTrain {
    fn new(engine: &Engine, given: TurningInertia) -> Result<KineticTrain, TorqueError> {
        let parts = [
            ("inertia of the flywheel [kg m^2]", given.flywheel),
            ("inertia of the crankshafts [kg m^2]", given.crankshaft),
        ];
        for (quantity, got) in parts {
            if !(got >= 0.0 && got.is_finite()) {
                return Err(refused(quantity, "finite and not negative", got));
            }
        }
        let request = TorqueRequest { speed: Some(1.0), samples: 1, ..TorqueRequest::default() };
        let mechanism = Mechanism::new(engine, &request.loads())?;
        // The big end of an articulated rod moves with its knuckle pin, which the piston's entry counts.
        let plain = engine.cylinders.iter().filter(|c| !matches!(c.rod.joint, RodJoint::Articulated { .. }));
        let big_ends = plain
            .map(|cylinder| {
                let throw = &engine.throws[cylinder.throw];
                let ratio = engine.crankshafts[throw.crankshaft].ratio.value();
                cylinder.rod.big_end_mass * (throw.radius * ratio).powi(2)
            })
            .sum::<f64>();
        let geared = engine.geared_inertia();
        Ok(KineticTrain {
            mechanism,
            constant: given.flywheel + given.crankshaft + geared + big_ends,
            big_ends,
            geared,
            given,
            revolutions: period(engine)?,
        })
    }

    /// Inertia of pistons and rods without big ends [kg m^2] at `theta`.
    fn reciprocating(&self, theta: f64) -> f64 {
        let of = |piston: &crate::train::mechanism::Piston| {
            let motion = piston.drive.motion(piston.ratio.value() * theta + piston.phase);
            let [_, s, ..] = motion.stroke.travel;
            let [k, ..] = motion.stroke.swing;
            let pin = piston.knuckle.as_ref().zip(motion.knuckle.as_ref());
            let pin = pin.map_or(0.0, |(mass, pin)| mass.mass * pin.knuckle[1].norm_sqr());
            // Masses are times the square of their own crankshaft's speed, of one rad/s at crankshaft 1.
            piston.mass * s * s + piston.inertia * k * k + pin
        };
        self.mechanism.pistons.iter().map(of).sum()
    }
}

fn refused(quantity: &'static str, needed: &'static str, got: f64) -> TorqueError {
    LoadError::Request { quantity, needed, got }.into()
}

fn check_speed(speed: f64) -> Result<(), TorqueError> {
    if speed > 0.0 && speed <= 1e60 {
        Ok(())
    } else {
        Err(refused("speed [rad/s]", "positive and at most 1e60", speed))
    }
}

/// Inertia of the train of `engine` over the period of its torque.
///
/// # Errors
/// [`TorqueError`] where an inertia is negative or the engine is not valid.
pub fn train_inertia(
    engine: &Engine,
    given: TurningInertia,
    theta: &[f64],
) -> Result<TrainInertia, TorqueError> {
    Ok(inertia_over(&KineticTrain::new(engine, given)?, theta))
}

fn inertia_over(train: &KineticTrain, theta: &[f64]) -> TrainInertia {
    let reciprocating: Vec<f64> = theta.iter().map(|theta| train.reciprocating(*theta)).collect();
    // Equally spaced over whole revolutions: the trapezoidal rule, spectral on a smooth periodic function.
    let reciprocating_mean = reciprocating.iter().sum::<f64>() / theta.len().max(1) as f64;
    let total: Vec<f64> = reciprocating.iter().map(|own| train.constant + own).collect();
    let mut extremes = Extremes {
        max: Extreme { value: f64::NEG_INFINITY, theta: 0.0 },
        min: Extreme { value: f64::INFINITY, theta: 0.0 },
    };
    for (value, theta) in total.iter().zip(theta) {
        if *value > extremes.max.value {
            extremes.max = Extreme { value: *value, theta: *theta };
        }
        if *value < extremes.min.value {
            extremes.min = Extreme { value: *value, theta: *theta };
        }
    }
    TrainInertia {
        given: train.given,
        geared: train.geared,
        big_ends: train.big_ends,
        reciprocating_mean,
        mean: train.constant + reciprocating_mean,
        total,
        extremes,
    }
}

/// Work and inertia on a fine grid: all that the ripple needs.
struct RippleGrid {
    period: f64,
    theta: Vec<f64>,
    /// Torque of gas less load [N m].
    drive: Vec<f64>,
    /// Torque of inertia at one rad/s [N m]: half the fall of the inertia, a radian.
    braked: Vec<f64>,
    /// Twice the work of gas less load from 0 [J].
    work: Vec<f64>,
    load: f64,
    excess: f64,
}

impl RippleGrid {
    fn new(
        train: &KineticTrain,
        gas: Option<&GasTrain>,
        outer: &OuterTorque,
        speed: f64,
    ) -> Result<RippleGrid, LoadError> {
        let own = gas.map_or(train.revolutions, |gas| gas.revolutions);
        let revolutions = own / greatest_common_divisor(own, outer.revolutions) * outer.revolutions;
        if revolutions > MAX_REVOLUTIONS {
            let quantity = "revolutions after which all torques repeat";
            return Err(LoadError::Request { quantity, needed: "at most 120", got: f64::from(revolutions) });
        }
        let outer = outer.at(speed);
        let period = TAU * f64::from(revolutions);
        let count = SAMPLES * revolutions as usize;
        let theta: Vec<f64> = (0..count).map(|j| period * j as f64 / count as f64).collect();
        let load = gas.map_or(0.0, |gas| gas.mean_torques().iter().sum::<f64>()) + outer.mean();
        let parts = STRETCHES * revolutions as usize;
        let of_gas = gas.map(|gas| gas.breaks().angles().to_vec()).unwrap_or_default();
        let turns = (0..revolutions / own).map(|turn| TAU * f64::from(turn * own));
        let jumps = turns.flat_map(|turn| of_gas.iter().map(move |angle| angle + turn));
        let breaks = Breaks::new(period, jumps.chain(outer.kinks(revolutions)), parts);
        let of_gas = |theta: f64| gas.map_or(0.0, |gas| gas.torque(theta)) + outer.torque(theta) - load;
        let work = breaks.accumulated_at(&theta, of_gas);
        let square = speed * speed;
        let total = |theta: f64| of_gas(theta) + load + square * train.mechanism.shaft_torque(theta);
        let excess = breaks.sample(total).energy(load).excess;
        let drive = theta.iter().map(|theta| of_gas(*theta)).collect();
        let braked = theta.iter().map(|theta| train.mechanism.shaft_torque(*theta)).collect();
        Ok(RippleGrid {
            period,
            theta,
            drive,
            braked,
            work: work.into_iter().map(|w| 2.0 * w).collect(),
            load,
            excess,
        })
    }

    /// Inertia at the grid with a flywheel [kg m^2] beside `without`; `None` where nothing turns.
    fn with_flywheel(&self, without: &[f64], flywheel: f64) -> Option<Vec<f64>> {
        let inertia: Vec<f64> = without.iter().map(|j| j + flywheel).collect();
        inertia.iter().all(|j| *j > 0.0).then_some(inertia)
    }

    /// Squares of the speed times inertia, less their lowest: `2 (C + W) = x + rise`.
    fn rise(&self) -> Vec<f64> {
        let lowest = self.work.iter().copied().fold(f64::INFINITY, f64::min);
        self.work.iter().map(|work| work - lowest).collect()
    }

    /// Speeds at the grid with this mean; `inertia` at the grid.
    fn speeds(&self, inertia: &[f64], mean_speed: f64) -> Vec<f64> {
        let rise = self.rise();
        let mean_inertia = inertia.iter().sum::<f64>() / inertia.len() as f64;
        // Time of a period over the one wanted: falls as x rises.
        let time = |x: f64| {
            let sum: f64 = rise.iter().zip(inertia).map(|(rise, j)| (j / (x + rise)).sqrt()).sum();
            sum / inertia.len() as f64 * mean_speed - 1.0
        };
        let most = rise.iter().copied().fold(0.0, f64::max);
        let middle = mean_inertia * mean_speed * mean_speed;
        let heaviest = inertia.iter().copied().fold(0.0, f64::max);
        let (mut low, mut high) =
            ((middle - most).max(0.0) * 1e-3, heaviest * mean_speed * mean_speed * 1.01);
        while time(low) < 0.0 && low > 0.0 {
            low *= 1e-3;
        }
        for _ in 0..200 {
            let trial = 0.5 * (low + high);
            if high - low <= 4.0 * f64::EPSILON * high {
                break;
            }
            if time(trial) > 0.0 { low = trial } else { high = trial }
        }
        rise.iter().zip(inertia).map(|(rise, j)| ((high + rise) / j).sqrt()).collect()
    }

    /// Acceleration at the grid [rad/s^2]: `J w w' = T - T_load - w^2 J'/2`.
    fn accelerations(&self, inertia: &[f64], speeds: &[f64]) -> Vec<f64> {
        let torques = self.drive.iter().zip(&self.braked);
        let states = inertia.iter().zip(speeds);
        torques
            .zip(states)
            .map(|((drive, braked), (inertia, speed))| (drive + speed * speed * braked) / inertia)
            .collect()
    }

    /// Extremes of the speed over the continuous angle: of cubics between the grid through the squares of the speed and their rates, which
    /// stay smooth where it nearly stands still.
    fn extremes(&self, inertia: &[f64], speeds: &[f64]) -> Extremes {
        let accelerations = self.accelerations(inertia, speeds);
        let at = |j: usize| End { value: speeds[j] * speeds[j], slope: 2.0 * accelerations[j] };
        let count = speeds.len();
        let ends: Vec<[End; 2]> = (0..count).map(|j| [at(j), at((j + 1) % count)]).collect();
        let Ok(squares) = PeriodicCurve::from_ends(self.period, self.theta.clone(), &ends) else {
            // Rates beyond all numbers.
            return grid_extremes(speeds, self.period);
        };
        let [min, max] =
            squares.extremes().map(|(square, theta)| Extreme { value: square.max(0.0).sqrt(), theta });
        Extremes { max, min }
    }
}

/// The periodic speed of `engine` under `gas` about the mean `speed` [rad/s], with `known` turning beside pistons and rods; without gas that of
/// inertia alone; `outer` are torques over the angle beside the gas. A speed that is not known, or an engine that stops, is an outcome with its reason.
///
/// # Errors
/// As [`crate::torque`]; an inertia that is negative, or none at all.
pub fn speed_ripple(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    speed: f64,
    outer: &OuterTorque,
    known: KnownInertia,
) -> Result<RippleOutcome, TorqueError> {
    check_speed(speed)?;
    let train = KineticTrain::new(engine, known.known())?;
    let gas = gas.map(|gas| GasTrain::new(engine, gas, Lever::Exact)).transpose()?;
    let missing = known.missing();
    if !missing.is_empty() {
        return Ok(RippleOutcome::incomplete(speed, missing));
    }
    let grid = RippleGrid::new(&train, gas.as_ref(), outer, speed)?;
    let inertia = inertia_over(&train, &grid.theta);
    if inertia.extremes.min.value <= 0.0 {
        let got = inertia.extremes.min.value;
        return Err(refused("inertia of all that turns [kg m^2]", "positive", got));
    }
    let speeds = grid.speeds(&inertia.total, speed);
    let extremes = grid.extremes(&inertia.total, &speeds);
    if stops(&speeds, speed) {
        let without: Vec<f64> = inertia.total.iter().map(|j| j - train.given.flywheel).collect();
        let keeps = |flywheel: f64| {
            let own = grid.with_flywheel(&without, flywheel);
            own.is_some_and(|own| !stops(&grid.speeds(&own, speed), speed))
        };
        let unit = (grid.excess / (speed * speed)).max(inertia.mean).max(f64::MIN_POSITIVE);
        return Ok(RippleOutcome::stops(speed, least_flywheel(unit, keeps)));
    }
    let accelerations = grid.accelerations(&inertia.total, &speeds);
    let acceleration = accelerations.into_iter().map(f64::abs).fold(0.0, f64::max);
    Ok(RippleOutcome::Periodic(Box::new(SpeedRipple {
        version: FLYWHEEL_VERSION,
        mean_speed: speed,
        load: grid.load,
        period: grid.period,
        fluctuation: extremes.range() / speed,
        simple_fluctuation: grid.excess / (inertia.mean * speed * speed),
        excess: grid.excess,
        acceleration,
        extremes,
        theta: grid.theta,
        speed: speeds,
        inertia,
    })))
}

/// Whether an engine of these speeds counts as stopped.
fn stops(speeds: &[f64], mean: f64) -> bool {
    speeds.iter().copied().fold(f64::INFINITY, f64::min) < STOPPED * mean
}

/// Least flywheel [kg m^2] that `keeps` what is wanted, 0 included; `None` if none up to half a million `unit`s does.
fn least_flywheel(unit: f64, keeps: impl Fn(f64) -> bool) -> Option<f64> {
    if keeps(0.0) {
        return Some(0.0);
    }
    let top = (0..20).map(|k| unit * f64::from(1u32 << k)).find(|j| keeps(*j))?;
    let (mut low, mut high) = (0.0, top);
    for _ in 0..100 {
        let trial = 0.5 * (low + high);
        if high - low <= 1e-12 * high {
            break;
        }
        if keeps(trial) { high = trial } else { low = trial }
    }
    Some(high)
}

/// Flywheel of `engine` under `gas` at `speed` [rad/s] for the fluctuation wanted; the flywheel in `known` does not count. Without the inertia of the
/// crankshafts the flywheel includes it.
///
/// # Errors
/// As [`speed_ripple`]; a fluctuation that is not between 0 and 2.
pub fn flywheel_need(
    engine: &Engine,
    gas: Option<&[CylinderGas]>,
    speed: f64,
    outer: &OuterTorque,
    known: KnownInertia,
    fluctuation: f64,
) -> Result<FlywheelNeed, TorqueError> {
    if !(fluctuation > 0.0 && fluctuation < 2.0) {
        return Err(refused("fluctuation of the speed", "between 0 and 2", fluctuation));
    }
    check_speed(speed)?;
    let train = KineticTrain::new(engine, TurningInertia { flywheel: 0.0, ..known.known() })?;
    let gas = gas.map(|gas| GasTrain::new(engine, gas, Lever::Exact)).transpose()?;
    let grid = RippleGrid::new(&train, gas.as_ref(), outer, speed)?;
    let own = inertia_over(&train, &grid.theta);
    let by_formula = grid.excess / (fluctuation * speed * speed);
    let keeps = |flywheel: f64| {
        let inertia = grid.with_flywheel(&own.total, flywheel);
        inertia.is_some_and(|inertia| {
            grid.extremes(&inertia, &grid.speeds(&inertia, speed)).range() / speed <= fluctuation
        })
    };
    Ok(FlywheelNeed {
        speed,
        fluctuation,
        by_formula,
        train: own.mean,
        flywheel_by_formula: (by_formula - own.mean).max(0.0),
        flywheel: least_flywheel(by_formula.max(own.mean).max(f64::MIN_POSITIVE), keeps),
        crankshaft_known: known.crankshaft.is_some(),
    })
}

impl Breaks {
    /// Integrals of `function` from 0 to every one of `theta`, rising.
    fn accumulated_at(&self, theta: &[f64], function: impl Fn(f64) -> f64) -> Vec<f64> {
        let breaks = self.angles();
        let (mut sum, mut from, mut next) = (0.0, 0.0, 1);
        let mut integrals = Vec::with_capacity(theta.len());
        for &to in theta {
            while next < breaks.len() && breaks[next] < to {
                sum += self.stretch(from, breaks[next], &function);
                (from, next) = (breaks[next], next + 1);
            }
            sum += self.stretch(from, to, &function);
            from = to;
            integrals.push(sum);
        }
        integrals
    }
}
