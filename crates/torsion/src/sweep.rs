//! Forced vibration over speed: every order in true phase, and its synthesis.

use crate::chain::{Chain, StationKind};
use crate::error::TorsionError;
use crate::excitation::Excitation;
use crate::forced::Forced;
use num_complex::Complex64;
use serde::Serialize;

/// Forced vibration over speed. Amplitudes are half of largest less least value; those by order are moduli.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Sweep {
    /// Speeds of the reference [rad/s].
    pub speeds: Vec<f64>,
    /// Orders, per revolution of the reference.
    pub orders: Vec<f64>,
    /// Every shaft.
    pub shafts: Vec<ShaftSweep>,
    /// Angles of the stations by order.
    pub stations: Vec<StationSweep>,
    /// Nose against flywheel, as seen at the reference.
    pub twist: Curve,
    /// Nose alone.
    pub nose: Curve,
    /// The damper, where there is one.
    pub damper: Option<DamperSweep>,
    /// Pendulums.
    pub pendulums: Vec<PendulumSweep>,
    /// Largest difference of the power put in and the power lost, over the power put in.
    pub balance: f64,
}

/// An angle over speed [rad].
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Curve {
    /// Amplitude of each order at each speed [rad].
    pub by_order: Vec<Vec<f64>>,
    /// Amplitude of all orders in true phase at each speed [rad].
    pub total: Vec<f64>,
    /// Sum of the amplitudes of all orders, whatever their phases [rad].
    pub sum: Vec<f64>,
}

/// A shaft over speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ShaftSweep {
    /// Index of the shaft.
    pub shaft: usize,
    /// Amplitude of the torque of each order at each speed [N m].
    pub by_order: Vec<Vec<f64>>,
    /// Amplitude of the torque of all orders in true phase [N m].
    pub total: Vec<f64>,
    /// Sum of the amplitudes of all orders, whatever their phases [N m].
    pub sum: Vec<f64>,
    /// Mean torque [N m], all of it taken at the end of the chain.
    pub mean: Vec<f64>,
    /// Largest absolute torque, the mean included [N m].
    pub largest: Vec<f64>,
    /// Shear stress over torque at the surface of its section [1/m^3]; `None` where its section is not known.
    pub stress_rate: Option<f64>,
    /// Power lost in it [W].
    pub loss: Vec<f64>,
}

/// Angle of a station over speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StationSweep {
    /// Index of the station.
    pub station: usize,
    /// Amplitude of each order at each speed, at its own speed [rad].
    pub by_order: Vec<Vec<f64>>,
}

/// A damper over speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DamperSweep {
    /// Index of its shaft.
    pub shaft: usize,
    /// Heat [W] at each speed.
    pub power: Vec<f64>,
    /// Amplitude of the ring against the hub in true phase [rad].
    pub ring: Vec<f64>,
    /// The same by order [rad].
    pub by_order: Vec<Vec<f64>>,
}

/// A pendulum absorber over speed.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct PendulumSweep {
    /// Index of its shaft.
    pub shaft: usize,
    /// Amplitude of its swing against the radius in true phase [rad]; large ones are beyond the linear theory.
    pub swing: Vec<f64>,
}

impl ShaftSweep {
    /// Index of the speed at which its amplitude is largest, with that amplitude.
    pub fn peak(&self) -> (usize, f64) {
        peak(&self.total)
    }
}

/// Index and value of the largest.
pub fn peak(values: &[f64]) -> (usize, f64) {
    values.iter().copied().enumerate().fold((0, 0.0), |best, (i, x)| if x > best.1 { (i, x) } else { best })
}

/// Forced vibration of `chain` at these speeds of the reference [rad/s].
///
/// ```text
/// (K + i w C - w^2 J) phi = T,    w = n speed,    T_shaft = (k (1 + i loss) + i w c) rho (phi_from - phi_to)                   (50.6)
/// ```
/// At every order the power that the torques put in is what dampers take, to rounding: `balance` says how nearly.
///
/// # Errors
/// Torques that do not fit the chain; a speed that is 0, negative or none.
pub fn sweep(chain: &Chain, excitation: &Excitation, speeds: &[f64]) -> Result<Sweep, TorsionError> {
    let mut forced = Forced::new(chain, excitation)?;
    if let Some(bad) = speeds.iter().find(|speed| !(**speed > 0.0 && speed.is_finite())) {
        return Err(TorsionError::Number { quantity: "speed [rad/s]", needed: "more than 0", got: *bad });
    }
    let (n, count, many) = (chain.stations().len(), excitation.count, speeds.len());
    let blank = || vec![vec![0.0; many]; count];
    let curve = || Curve { by_order: blank(), total: vec![0.0; many], sum: vec![0.0; many] };
    let mut shafts: Vec<ShaftSweep> = chain
        .shafts()
        .iter()
        .enumerate()
        .map(|(shaft, own)| ShaftSweep {
            shaft,
            by_order: blank(),
            total: vec![0.0; many],
            sum: vec![0.0; many],
            mean: vec![0.0; many],
            largest: vec![0.0; many],
            stress_rate: own.section.map(|section| section.modulus().recip()),
            loss: vec![0.0; many],
        })
        .collect();
    let mut stations: Vec<StationSweep> =
        (0..n).map(|station| StationSweep { station, by_order: blank() }).collect();
    let (mut twist, mut nose) = (curve(), curve());
    let damper_shaft = chain.damper();
    let mut damper = damper_shaft.map(|shaft| DamperSweep {
        shaft,
        power: vec![0.0; many],
        ring: vec![0.0; many],
        by_order: blank(),
    });
    let swinging = |(shaft, own): (usize, &crate::chain::Shaft)| {
        (own.spin_stiffness > 0.0).then(|| PendulumSweep { shaft, swing: vec![0.0; many] })
    };
    let mut pendulums: Vec<PendulumSweep> = chain.shafts().iter().enumerate().filter_map(swinging).collect();
    let load = load_station(chain);
    let (front, rear) = (chain.nose(), chain.flywheel());
    let mut balance: f64 = 0.0;
    let mut orders = vec![Complex64::default(); count];
    for (index, &speed) in speeds.iter().enumerate() {
        forced.solve(speed);
        if forced.input > 0.0 {
            balance = balance.max((forced.input - forced.loss).abs() / forced.input);
        }
        let means = forced.mean_torques(load);
        for at in 1..n {
            let shaft = forced.impedance.shaft[at];
            let own = &mut shafts[shaft];
            fill(&mut orders, forced.own_torque(at));
            let [top, bottom] = forced.synthesis.extremes(orders.iter().copied());
            for (row, t) in own.by_order.iter_mut().zip(&orders) {
                row[index] = t.norm();
                own.sum[index] += row[index];
            }
            let mean = means[at];
            own.total[index] = 0.5 * (top - bottom);
            own.mean[index] = mean;
            own.largest[index] = (mean + top).abs().max((mean + bottom).abs());
            own.loss[index] = forced.shaft_loss[at];
            let is_damper = damper_shaft == Some(shaft);
            let pendulum = pendulums.iter_mut().find(|pendulum| pendulum.shaft == shaft);
            if is_damper || pendulum.is_some() {
                fill(&mut orders, forced.own_twist(at));
                let [top, bottom] = forced.synthesis.extremes(orders.iter().copied());
                if let Some(pendulum) = pendulum {
                    pendulum.swing[index] = 0.5 * (top - bottom);
                }
                if let Some(damper) = damper.as_mut().filter(|_| is_damper) {
                    damper.power[index] = forced.shaft_loss[at];
                    damper.ring[index] = 0.5 * (top - bottom);
                    for (row, t) in damper.by_order.iter_mut().zip(&orders) {
                        row[index] = t.norm();
                    }
                }
            }
        }
        for own in &mut stations {
            for (row, angle) in own.by_order.iter_mut().zip(forced.angle_of(own.station)) {
                row[index] = angle.norm();
            }
        }
        for which in 0..2 {
            let curve = if which == 0 { &mut twist } else { &mut nose };
            if which == 0 {
                fill(&mut orders, forced.between(front, rear));
            } else {
                fill(&mut orders, forced.angle_of(front));
            }
            let [top, bottom] = forced.synthesis.extremes(orders.iter().copied());
            curve.total[index] = 0.5 * (top - bottom);
            for (row, t) in curve.by_order.iter_mut().zip(&orders) {
                row[index] = t.norm();
                curve.sum[index] += row[index];
            }
        }
    }
    Ok(Sweep {
        speeds: speeds.to_vec(),
        orders: excitation.orders(),
        shafts,
        stations,
        twist,
        nose,
        damper,
        pendulums,
        balance,
    })
}

/// Where the mean torque is taken: the last driven station, else the flywheel.
pub(crate) fn load_station(chain: &Chain) -> usize {
    let driven = chain.stations().iter().rposition(|station| station.kind == StationKind::Driven);
    driven.unwrap_or_else(|| chain.flywheel())
}

fn fill(orders: &mut [Complex64], from: impl Iterator<Item = Complex64>) {
    for (order, value) in orders.iter_mut().zip(from) {
        *order = value;
    }
}

/// Complex angles of all stations, at their own speeds [rad], and torques of all shafts [N m], by order, at one speed of the reference [rad/s].
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Response {
    /// Speed [rad/s].
    pub speed: f64,
    /// Orders.
    pub orders: Vec<f64>,
    /// By station, then order.
    #[schemars(with = "Vec<Vec<[f64; 2]>>")]
    pub angles: Vec<Vec<Complex64>>,
    /// By shaft, then order.
    #[schemars(with = "Vec<Vec<[f64; 2]>>")]
    pub torques: Vec<Vec<Complex64>>,
    /// Power put in [W].
    pub input: f64,
    /// Power lost [W].
    pub loss: f64,
}

/// Complex response at one speed.
///
/// # Errors
/// As [`sweep`].
pub fn response(chain: &Chain, excitation: &Excitation, speed: f64) -> Result<Response, TorsionError> {
    let mut forced = Forced::new(chain, excitation)?;
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(TorsionError::Number { quantity: "speed [rad/s]", needed: "more than 0", got: speed });
    }
    forced.solve(speed);
    let n = chain.stations().len();
    let mut torques = vec![Vec::new(); chain.shafts().len()];
    for at in 1..n {
        torques[forced.impedance.shaft[at]] = forced.own_torque(at).collect();
    }
    Ok(Response {
        speed,
        orders: excitation.orders(),
        angles: (0..n).map(|station| forced.angle_of(station).collect()).collect(),
        torques,
        input: forced.input,
        loss: forced.loss,
    })
}
