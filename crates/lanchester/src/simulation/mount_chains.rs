//! Mounts with loss factors or tables over frequency in a run: Maxwell chains over the band of its orders.

use lanchester_model::{Engine, MAX_LOSS_FACTOR, MountPoint};
use lanchester_multibody::{MultibodyError, Train};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Largest error of a fit of mounts that a run is made with.
const MOST_MISFIT: f64 = 0.1;

/// Highest order of the band over which mounts are fitted.
const FITTED_ORDER: f64 = 4.0;

/// Angular frequencies [rad/s] from the lowest order at the lowest of `speeds` above 0 to [`FITTED_ORDER`] at the highest; without one, of the engine's own.
pub(crate) fn chain_band(engine: &Engine, train: &Train, speeds: &[f64]) -> [f64; 2] {
    let mut speeds: Vec<f64> = speeds.iter().copied().filter(|speed| *speed > 0.0).collect();
    if speeds.is_empty() {
        speeds = vec![engine.speed.lowest, engine.speed.highest];
    }
    let lowest_order = if engine.gas.is_some() { 1.0 / f64::from(train.strokes) } else { 1.0 };
    let lowest = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    [lowest_order * lowest, FITTED_ORDER * speeds.iter().copied().fold(0.0, f64::max)]
}

/// Fits Maxwell chains to mounts with loss factors or tables over frequency, and says over which band [rad/s] and how well; `None` without such mounts.
pub(crate) fn fit_mounts(train: &mut Train, band: [f64; 2]) -> Result<Option<String>, MultibodyError> {
    let [low, high] = band.map(|frequency| frequency / TAU);
    let mut names = Vec::new();
    let mut most: f64 = 0.0;
    for mount in train.mounts.iter_mut().filter(|mount| mount.frequency_dependent) {
        let error = mount.fit(band);
        most = most.max(error);
        names.push(mount.name.clone());
        if error > MOST_MISFIT {
            return Err(MultibodyError::NoMounts {
                missing: format!(
                    "springs and dashpots that are at rest as stiff as mount `{}` come no closer than {:.0} % to its loss factor or table between {low:.1} and {high:.1} Hz, where 10 % is allowed: it needs its `damping` instead",
                    mount.name,
                    100.0 * error,
                ),
            });
        }
    }
    if names.is_empty() {
        return Ok(None);
    }
    Ok(Some(format!(
        "Loss factors and tables of {} are Maxwell chains, fitted from {low:.1} to {high:.1} Hz: at most {:.1} % off; at rest as stiff as the file says.",
        names.join(", "),
        100.0 * most
    )))
}

/// The engine whose mounts have, at these angular frequencies [rad/s], the complex stiffness of the chains of `train`, which were fitted.
pub(crate) fn with_chains(engine: &Engine, train: &Train, frequencies: &[f64]) -> Engine {
    let changed = engine.with(|parts| {
        for (mount, place) in parts.mounts.iter_mut().zip(&train.mounts) {
            let (Some(spring), Some(chains)) = (&mut mount.spring, &place.chains) else { continue };
            let point = |frequency: &f64| {
                let of = chains.each_ref().map(|chain| chain.stiffness(*frequency));
                let loss = |k: Complex64| if k.re > 0.0 { (k.im / k.re).min(MAX_LOSS_FACTOR) } else { 0.0 };
                MountPoint {
                    angular_frequency: *frequency,
                    stiffness: of.map(|k| k.re),
                    loss_factor: of.map(loss),
                }
            };
            spring.loss_factor = [0.0; 3];
            spring.table = frequencies.iter().map(point).collect();
        }
    });
    changed.expect("invariant: a chain has a stiffness at every frequency")
}
