//! Where orders meet natural frequencies, and the star of each order.

use crate::chain::{Chain, StationKind};
use crate::error::TorsionError;
use crate::excitation::Excitation;
use crate::modes::{Mode, modes};
use num_complex::Complex64;
use serde::Serialize;

/// A speed at which an order meets a natural frequency.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Critical {
    /// Number of the mode, from 1.
    pub mode: usize,
    /// The order.
    pub order: f64,
    /// Speed of the reference [rad/s].
    pub speed: f64,
    /// Natural frequency there [rad/s].
    pub frequency: f64,
    /// Torque of this order in the mode, in true phase: `|SUM T_k phi|` [N m].
    pub modal_torque: f64,
    /// Work of a cycle of vibration at 1 rad of the largest station: `pi` times the modal torque [J].
    pub work: f64,
}

/// Data of a Campbell diagram.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Campbell {
    /// Speeds [rad/s].
    pub speeds: Vec<f64>,
    /// Natural frequency of each mode at each speed [rad/s]; only pendulums make it depend on the speed.
    pub frequencies: Vec<Vec<f64>>,
    /// Orders drawn.
    pub orders: Vec<f64>,
    /// Critical speeds within the range, by falling modal torque.
    pub criticals: Vec<Critical>,
}

/// Bisections of a crossing.
const STEPS: usize = 50;

/// Campbell diagram between the first and the last of these speeds [rad/s], which rise.
///
/// # Errors
/// As [`modes`]; torques that do not fit.
pub fn campbell(chain: &Chain, excitation: &Excitation, speeds: &[f64]) -> Result<Campbell, TorsionError> {
    excitation.check(chain)?;
    let depends = chain.shafts().iter().any(|shaft| shaft.spin_stiffness > 0.0);
    let at_rest = modes(chain, speeds.first().copied().unwrap_or(0.0))?;
    let of = |speed: f64| if depends { modes(chain, speed) } else { Ok(at_rest.clone()) };
    let all: Vec<Vec<Mode>> = speeds.iter().map(|speed| of(*speed)).collect::<Result<_, _>>()?;
    let many = all.iter().map(Vec::len).min().unwrap_or(0);
    let frequencies: Vec<Vec<f64>> =
        (0..many).map(|mode| all.iter().map(|at| at[mode].frequency).collect()).collect();
    let orders = excitation.orders();
    let mut criticals = Vec::new();
    for (mode, curve) in frequencies.iter().enumerate() {
        for (k, &order) in orders.iter().enumerate() {
            for i in 1..speeds.len() {
                let gap = |speed: f64, frequency: f64| frequency - order * speed;
                let (mut from, mut to) = (speeds[i - 1], speeds[i]);
                let first = gap(from, curve[i - 1]);
                let last = gap(to, curve[i]);
                if (first > 0.0) == (last > 0.0) {
                    continue;
                }
                if depends {
                    for _ in 0..STEPS {
                        let middle = 0.5 * (from + to);
                        let here = of(middle)?.get(mode).map_or(0.0, |mode| gap(middle, mode.frequency));
                        if (here > 0.0) == (first > 0.0) { from = middle } else { to = middle }
                    }
                } else {
                    from = curve[i] / order;
                }
                let own = of(from)?.swap_remove(mode);
                let torque: Complex64 = excitation
                    .sources
                    .iter()
                    .map(|source| source.order(k, from) * own.shape[source.station])
                    .sum();
                criticals.push(Critical {
                    mode: mode + 1,
                    order,
                    speed: from,
                    frequency: own.frequency,
                    modal_torque: torque.norm(),
                    work: std::f64::consts::PI * torque.norm(),
                });
            }
        }
    }
    criticals.sort_by(|a, b| b.modal_torque.total_cmp(&a.modal_torque));
    Ok(Campbell { speeds: speeds.to_vec(), frequencies, orders, criticals })
}

/// Star of an order: equal torques of all cylinders, in the phases of their firings, times the amplitudes of a mode at their throws.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct OrderStar {
    /// The order.
    pub order: f64,
    /// One vector for each cylinder, of length 1: real part along cylinder 1.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub vectors: Vec<Complex64>,
    /// Length of the sum of the vectors as they are: what a rigid crankshaft feels.
    pub rigid_sum: f64,
    /// For each mode the length of the sum of the vectors times the amplitudes at their throws, the largest throw's 1.
    pub sums: Vec<f64>,
}

/// Stars of these orders: cylinders with the station of their throw and the crank angle at which they fire [rad].
///
/// ```text
/// v_i = e^(-i n (theta_i - theta_1)),    sum_r = |SUM phi_r,i v_i|,    phi_r the shape of mode r over the largest of its throws  (50.10)
/// ```
pub fn order_stars(
    chain: &Chain,
    modes: &[Mode],
    firings: &[(usize, f64)],
    orders: &[f64],
) -> Vec<OrderStar> {
    let first = firings.first().map_or(0.0, |firing| firing.1);
    let is_throw = |station: usize| matches!(chain.stations()[station].kind, StationKind::Throw(_));
    let largest = |mode: &Mode| {
        let throws = mode.shape.iter().enumerate().filter(|(station, _)| is_throw(*station));
        throws.map(|(_, value)| value.abs()).fold(0.0, f64::max)
    };
    let star = |&order: &f64| {
        let vectors: Vec<Complex64> =
            firings.iter().map(|(_, at)| Complex64::cis(-order * (at - first))).collect();
        let sum_of = |mode: &Mode| {
            let pairs = firings.iter().zip(&vectors);
            // Torques drive each crankshaft in its own sense.
            let own = |station: usize| mode.shape[station] * chain.stations()[station].ratio.signum();
            let sum: Complex64 = pairs.map(|((station, _), vector)| vector * own(*station)).sum();
            let scale = largest(mode);
            if scale > 0.0 { sum.norm() / scale } else { 0.0 }
        };
        OrderStar {
            order,
            rigid_sum: vectors.iter().sum::<Complex64>().norm(),
            sums: modes.iter().map(sum_of).collect(),
            vectors,
        }
    };
    orders.iter().map(star).collect()
}
