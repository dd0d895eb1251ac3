//! Free damped vibration: all roots of the characteristic equation at once.

use crate::chain::Chain;
use crate::error::TorsionError;
use crate::impedance::Impedance;
use crate::modes::modes;
use lanchester_numerics::ComplexLu;
use num_complex::Complex64;
use serde::Serialize;

const MOST_ITERATIONS: usize = 400;

/// A mode of the damped chain: `phi(t) = Re(shape e^(s t))`.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct DampedMode {
    /// Damped angular frequency [rad/s]; 0 for motion that creeps back.
    pub frequency: f64,
    /// Rate of decay [1/s].
    pub decay: f64,
    /// Share of critical damping: decay over the modulus of s.
    pub damping_ratio: f64,
    /// Angles of the stations at their own speeds, the largest 1.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub shape: Vec<Complex64>,
}

/// Modes of the damped chain while the reference turns at `speed` [rad/s]: those that swing by rising frequency, then those that creep. Loss factors
/// count as a stiffness `k (1 + i loss)`, which has a meaning for motion that swings alone.
///
/// The roots of `det(s^2 J + s C + K)` are found together by Aberth's iteration, rigid turning taken out exactly; the shapes by inverse iteration.
///
/// # Errors
/// Where the roots do not converge: numbers of extreme size.
///
/// # Source
/// Aberth, "Iteration methods for finding all zeros of a polynomial simultaneously", Mathematics of Computation 27 (1973).
pub fn damped_modes(chain: &Chain, speed: f64) -> Result<Vec<DampedMode>, TorsionError> {
    let mut impedance = Impedance::new(chain);
    let n = impedance.size();
    let rigid = impedance.rigid_roots(speed);
    let mut roots: Vec<Complex64> = Vec::with_capacity(2 * n - rigid);
    for (index, mode) in modes(chain, speed)?.iter().enumerate() {
        let shift = 0.01 + 0.003 * index as f64;
        roots.push(mode.frequency * Complex64::new(-shift, 1.0));
        roots.push(mode.frequency * Complex64::new(-shift, -1.001));
    }
    roots.truncate(2 * n - rigid);
    let mut guess = impedance.decay_guess();
    while roots.len() < 2 * n - rigid {
        roots.push(Complex64::new(-guess, 0.01 * guess));
        guess *= 1.7;
    }
    let mut is_done = vec![false; roots.len()];
    for _ in 0..MOST_ITERATIONS {
        for i in 0..roots.len() {
            if is_done[i] {
                continue;
            }
            let s = roots[i];
            let newton = (impedance.log_derivative(s, speed) - rigid as f64 / s).inv();
            let others: Complex64 = (0..roots.len())
                .filter(|j| *j != i)
                .map(|j| (s - roots[j]).inv())
                .filter(|term| term.is_finite())
                .sum();
            let step =
                if newton.is_finite() { newton / (1.0 - newton * others) } else { Complex64::default() };
            if !step.is_finite() {
                roots[i] *= Complex64::new(1.0 + 1e-6, 1e-6);
                continue;
            }
            roots[i] -= step;
            is_done[i] = step.norm() <= 4.0 * f64::EPSILON * roots[i].norm();
            // What cannot be had more exactly comes to rest at some units of the last place.
            is_done[i] |= step.norm() <= 1e-13 * roots[i].norm();
        }
        if is_done.iter().all(|done| *done) {
            break;
        }
    }
    if let Some(open) = is_done.iter().position(|done| !done) {
        return Err(TorsionError::Number {
            quantity: "root of the characteristic equation [1/s]",
            needed: "found",
            got: roots[open].norm(),
        });
    }
    /// Imaginary part over the size of a root below which the root is real.
    const REAL: f64 = 1e-9;
    let mut found = Vec::new();
    for s in roots {
        let swings = s.im.abs() > REAL * s.norm();
        if swings && s.im < 0.0 {
            continue;
        }
        let s = if swings { s } else { Complex64::new(s.re, 0.0) };
        found.push(DampedMode {
            frequency: s.im,
            decay: -s.re,
            damping_ratio: -s.re / s.norm(),
            shape: shape(chain, &impedance, s, speed),
        });
    }
    found.sort_by(|a, b| {
        let creeps = |mode: &DampedMode| mode.frequency == 0.0;
        creeps(a).cmp(&creeps(b)).then(a.frequency.total_cmp(&b.frequency)).then(a.decay.total_cmp(&b.decay))
    });
    Ok(found)
}

fn shape(chain: &Chain, impedance: &Impedance, s: Complex64, speed: f64) -> Vec<Complex64> {
    let n = impedance.size();
    let near = s * Complex64::new(1.0 + 1e-9, 1e-9);
    let mut vector: Vec<Complex64> = (0..n).map(|i| Complex64::new(1.0, 0.1 * (i as f64 + 1.0))).collect();
    if let Ok(factors) = ComplexLu::new(n, impedance.matrix(near, speed)) {
        for _ in 0..3 {
            factors.solve(&mut vector);
            let size = vector.iter().map(|x| x.norm()).fold(0.0, f64::max);
            for x in &mut vector {
                *x /= size;
            }
        }
    }
    let own: Vec<Complex64> =
        (0..n).map(|station| vector[impedance.position[station]] * chain.stations()[station].ratio).collect();
    let peak =
        own.iter().fold(Complex64::default(), |peak, x| if x.norm() > peak.norm() { *x } else { peak });
    own.iter().map(|x| x / peak).collect()
}
