//! An engine on its mounts under its own loads.

use crate::inertias::rotating_bodies;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_mechanism::RotorEffects;
use lanchester_mechanism::{
    GasTrain, Lever, MountError, MountRequest, MountStudy, MountSystem, TorqueError, inertia_excitations,
    merged_orders, mount_study, rotor_inertia_about_z,
};
use lanchester_model::{Engine, Gas, GasProcess, GasSource};
use lanchester_results::OrderLoads;
use rayon::prelude::*;

/// Speeds of [`mounts`].
#[derive(Debug, Clone, PartialEq)]
pub enum MountSpeeds {
    /// So many from the lowest to the highest of the engine, both included; one if these are one.
    Range(usize),
    /// These [rad/s].
    List(Vec<f64>),
}

impl MountSpeeds {
    pub(crate) fn of(&self, engine: &Engine) -> Vec<f64> {
        let count = match self {
            MountSpeeds::List(list) => return list.clone(),
            MountSpeeds::Range(count) => *count,
        };
        let (lowest, highest) = (engine.speed.lowest, engine.speed.highest);
        let steps = if lowest < highest { count.max(2) - 1 } else { 0 };
        (0..=steps).map(|k| lowest + (highest - lowest) * k as f64 / steps.max(1) as f64).collect()
    }
}

/// Why an engine on its mounts cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MountedError {
    /// The block and its mounts.
    #[error(transparent)]
    Mounts(#[from] MountError),
    /// The pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// The torque of the gas.
    #[error(transparent)]
    Torque(#[from] TorqueError),
}

/// The block of `engine` on its mounts, shaken by its inertia loads of orders up to `max_order`, and by the gas at each speed
/// if the file gives it and `gas` has the files that [`crate::trace_names`] names. `points`: of the block, whose motion is told [m].
///
/// ```
/// use lanchester::{MountSpeeds, mounts};
///
/// let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4-mounts.toml"));
/// let engine = lanchester::file::read(text).engine().expect("the example has no mistakes");
/// let study = mounts(&engine, &MountSpeeds::Range(3), 8, Some(&[]), &[])?;
/// let (idle, top) = (&study.response.speeds[0], &study.response.speeds[2]);
/// // The torque rod feels the gas at idle far more than the inertia forces at top speed.
/// assert!(idle.peaks[2].value > 10.0 * top.peaks[2].value);
/// # Ok::<(), lanchester::MountedError>(())
/// ```
///
/// # Errors
/// [`MountedError`]: as [`mount_study`], [`cylinder_gas`] and [`GasTrain::new`], and where a speed is not positive.
pub fn mounts(
    engine: &Engine,
    speeds: &MountSpeeds,
    max_order: u32,
    gas: Option<&[TraceFile]>,
    points: &[[f64; 3]],
) -> Result<MountStudy, MountedError> {
    mounts_with_rotors(engine, speeds, max_order, gas, points, RotorEffects::BOTH)
}

/// The same with these of the rotors' effects: without them, that is what a block does whose rotors are held fast in it.
///
/// # Errors
/// As [`mounts`].
pub fn mounts_with_rotors(
    engine: &Engine,
    speeds: &MountSpeeds,
    max_order: u32,
    gas: Option<&[TraceFile]>,
    points: &[[f64; 3]],
    effects: RotorEffects,
) -> Result<MountStudy, MountedError> {
    // What cannot be held is refused before any gas is computed.
    MountSystem::new(engine)?;
    let mut excitations = inertia_excitations(engine, &speeds.of(engine), max_order)?;
    let mut words = "inertia loads".to_owned();
    let mut warnings: Vec<String> = Vec::new();
    let mut driven = 0.0f64;
    if let (Some(traces), true) = (gas, engine.gas.is_some()) {
        let speeds: Vec<f64> = excitations.iter().map(|excitation| excitation.speed).collect();
        let gas = gas_at_speeds(engine, traces, &speeds, max_order)?;
        for (excitation, gas) in excitations.iter_mut().zip(gas) {
            driven = driven.max(gas.mean_torque);
            excitation.orders = merged_orders(&excitation.orders, &gas.orders);
            words = format!("inertia loads and gas ({})", gas.source);
            for warning in &gas.warnings {
                if !warnings.contains(warning) {
                    warnings.push(warning.clone());
                }
            }
        }
    }
    let reacting = engine.block.as_ref().is_none_or(|block| block.driveline_torque != [0.0; 3]);
    if driven > LEAST_MEAN && !reacting {
        warnings.push(format!(
            "the gas drives with up to {driven:.1} N m on average, and `driveline_torque` of [block] is 0: at rest the mounts \
             carry none of it"
        ));
    }
    let rotors = Some(rotor_inertia_about_z(&rotating_bodies(engine)));
    let request = MountRequest { points: points.to_vec(), excitation: words, warnings, rotors, effects };
    Ok(mount_study(engine, &excitations, &request)?)
}

/// Mean torque of the gas below which none is told [N m]: a closed cylinder leaves rounding.
const LEAST_MEAN: f64 = 0.001;

/// What the gas does to the block at one speed.
#[derive(Debug, Clone)]
struct GasAtSpeed {
    orders: Vec<OrderLoads>,
    /// Of all cylinders [N m].
    mean_torque: f64,
    source: String,
    warnings: Vec<String>,
}

/// Whether the pressures over the angle are others at another speed.
pub(crate) fn depends_on_speed(gas: &Gas) -> bool {
    match &gas.source {
        GasSource::Traces { traces, .. } => traces.len() > 1,
        GasSource::Cycle(cycle) => matches!(cycle.process, GasProcess::SingleZone(_)),
    }
}

/// The gas at each of `speeds`: once where it does not depend on them, else on all processors.
fn gas_at_speeds(
    engine: &Engine,
    traces: &[TraceFile],
    speeds: &[f64],
    max_order: u32,
) -> Result<Vec<GasAtSpeed>, MountedError> {
    let at = |speed: f64| -> Result<GasAtSpeed, MountedError> {
        let report = cylinder_gas(engine, traces, speed)?;
        let train = GasTrain::new(engine, &report.cylinders, Lever::Exact)?;
        Ok(GasAtSpeed {
            orders: train.orders(max_order),
            mean_torque: train.mean_torques().iter().sum(),
            source: report.source,
            warnings: report.warnings,
        })
    };
    if !engine.gas.as_ref().is_some_and(depends_on_speed) {
        // Every speed is still refused that a cycle would refuse.
        let Some(&first) = speeds.iter().find(|speed| **speed <= 0.0).or(speeds.first()) else {
            return Ok(Vec::new());
        };
        return Ok(vec![at(first)?; speeds.len()]);
    }
    let all: Vec<Result<GasAtSpeed, MountedError>> = speeds.par_iter().map(|speed| at(*speed)).collect();
    all.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is computed once, or on several processors, is what every speed gives by itself.
    #[test]
    fn the_gas_over_speeds_is_that_of_each_speed() {
        let zone = include_str!("../../../examples/single-gas.toml");
        let single = lanchester_file::read(zone).engine().expect("the example has no mistakes");
        for engine in [example(), single] {
            let speeds = [200.0, 310.0, 450.0];
            let together = gas_at_speeds(&engine, &[], &speeds, 6).expect("it has gas");
            for (speed, together) in speeds.iter().zip(&together) {
                let gas = cylinder_gas(&engine, &[], *speed).expect("it has gas");
                let train = GasTrain::new(&engine, &gas.cylinders, Lever::Exact).expect("a train");
                assert_eq!(together.orders, train.orders(6));
            }
            assert!(gas_at_speeds(&engine, &[], &[200.0, -1.0], 6).is_err());
        }
    }

    fn example() -> Engine {
        let text = include_str!("../../../examples/in-line-4-mounts.toml");
        lanchester_file::read(text).engine().expect("the example has no mistakes")
    }

    #[test]
    fn the_range_of_the_file_has_both_ends() {
        let engine = example();
        let study = mounts(&engine, &MountSpeeds::Range(7), 4, None, &[]).expect("it is held");
        let speeds: Vec<f64> = study.response.speeds.iter().map(|s| s.speed).collect();
        assert_eq!(speeds.len(), 7);
        assert_eq!((speeds[0], speeds[6]), (engine.speed.lowest, engine.speed.highest));
        let one = engine
            .with(|parts| parts.speed = lanchester_model::SpeedRange { lowest: 300.0, highest: 300.0 })
            .unwrap();
        let study = mounts(&one, &MountSpeeds::Range(7), 4, None, &[]).expect("it is held");
        assert_eq!(study.response.speeds.len(), 1);
    }

    #[test]
    fn an_in_line_four_shakes_its_mounts_at_second_order() {
        let speeds = MountSpeeds::List(vec![400.0]);
        let study = mounts(&example(), &speeds, 4, None, &[[0.3, 0.0, 0.0]]).expect("it is held");
        let at = &study.response.speeds[0];
        let size = |order: f64, mount: usize| {
            let found = at.orders.iter().find(|o| o.order == order).expect("it is listed");
            lanchester_mechanism::vector_amplitude(&found.forces[mount])
        };
        assert!((0..3).all(|mount| size(1.0, mount) < 1e-6 * size(2.0, mount)));
        assert!((0..3).all(|mount| (size(2.0, mount) / at.peaks[mount].value - 1.0).abs() < 0.2));
        assert_eq!(study.points[0].displacement[0].len(), at.orders.len());
        // Far above all natural frequencies mounts isolate.
        let last = study.transmissibility.ratio.last().expect("there are frequencies");
        assert!(last.iter().all(|t| *t < 0.5), "{last:?}");
        assert!((study.transmissibility.ratio[0][0] - 1.0).abs() < 0.2);
    }

    #[test]
    fn a_block_that_is_not_held_is_refused_before_the_gas() {
        // No load is computed at a speed below 0: what is refused first is the block.
        let mut engine = example();
        engine = engine
            .with(|engine| {
                engine.mounts.clear();
            })
            .expect("an engine");
        let speeds = MountSpeeds::List(vec![-1.0]);
        let refused = mounts(&engine, &speeds, 4, Some(&[]), &[]).expect_err("nothing holds it");
        assert!(matches!(refused, MountedError::Mounts(MountError::NoMounts)), "{refused}");
    }

    #[test]
    fn gas_shakes_the_block_by_its_torque_alone() {
        let engine = example();
        let speeds = MountSpeeds::List(vec![200.0]);
        let [with, without] = [Some(&[] as &[TraceFile]), None]
            .map(|gas| mounts(&engine, &speeds, 4, gas, &[]).expect("it is held").response.speeds[0].clone());
        let second = |at: &lanchester_mechanism::SpeedResponse| {
            at.orders.iter().find(|o| o.order == 2.0).expect("it is listed").load
        };
        let (with, without) = (second(&with), second(&without));
        assert!((0..5).all(|c| (with[c] - without[c]).norm() < 1e-9 * without[0].norm()));
        assert!((with[5] - without[5]).norm() > 10.0, "{} {}", with[5], without[5]);
    }

    #[test]
    fn a_torque_that_nothing_reacts_to_is_told() {
        let mut engine = example();
        let speeds = MountSpeeds::List(vec![200.0, 400.0]);
        let told = |engine: &Engine, gas: Option<&[TraceFile]>| {
            mounts(engine, &speeds, 4, gas, &[]).expect("it is held").warnings
        };
        assert_eq!(told(&engine, Some(&[])), Vec::<String>::new());
        engine = engine
            .with(|engine| {
                engine.block.as_mut().expect("it has a block").driveline_torque = [0.0; 3];
            })
            .expect("an engine");
        assert_eq!(told(&engine, None), Vec::<String>::new());
        let warnings = told(&engine, Some(&[]));
        assert!(warnings.len() == 1 && warnings[0].contains("N m on average"), "{warnings:?}");
    }

    #[test]
    fn a_three_of_four_strokes_shakes_its_mounts_at_half_orders() {
        let mut engine = example();
        let template = lanchester_file::template("in-line-3").expect("the gallery has it");
        let three = lanchester_file::read(template.text).engine().expect("the gallery has no mistakes");
        engine = three
            .with(|parts| {
                parts.gas.clone_from(&engine.gas);
                parts.block.clone_from(&engine.block);
                parts.mounts.clone_from(&engine.mounts);
            })
            .unwrap();
        let study = mounts(&engine, &MountSpeeds::List(vec![100.0]), 4, Some(&[]), &[]).expect("it is held");
        let at = &study.response.speeds[0];
        let roll =
            |order: f64| at.orders.iter().find(|o| o.order == order).expect("it is listed").load[5].norm();
        // Evenly fired every 240 deg: order 1.5 and its multiples.
        assert!(roll(1.5) > 50.0, "{} N m", roll(1.5));
        for order in [0.5, 1.0, 2.0, 2.5] {
            assert!(roll(order) < 1e-6 * roll(1.5), "{order}: {} N m", roll(order));
        }
    }

    /// Section 6.1.1 of the twin thesis: two mounts 88 mm from the middle take 8253 N each in the in-line twin and 4126 N in
    /// the boxer. Here each is a stiff pair, left and right, since two mounts alone let the block turn.
    #[test]
    fn lit_stiff_mounts_share_the_first_order_of_both_twins() {
        for (text, printed, tolerance) in [
            // Computed with the oscillating mass rounded to 0.985 kg: 8252 N with the mass itself.
            (include_str!("../../../examples/twin-in-line-in-phase.toml"), 8252.0, 0.5),
            (include_str!("../../../examples/twin-boxer-in-phase.toml"), 4126.0, 0.5),
        ] {
            let mut engine = lanchester_file::read(text).engine().expect("the example has no mistakes");
            let block = lanchester_model::Block {
                mass: 60.0,
                centre: [0.0; 3],
                inertia: [2.0; 3],
                products: [0.0; 3],
                moving_parts: lanchester_model::MovingParts::Included,
                gravity: [-1.0, 0.0, 0.0],
                driveline_torque: [0.0; 3],
            };
            engine = engine
                .with(|engine| {
                    engine.block = Some(block);
                })
                .expect("an engine");
            let places = [(-0.2, -0.088), (0.2, -0.088), (-0.2, 0.088), (0.2, 0.088)];
            engine = engine
                .with(|engine| {
                    engine.mounts = places
                        .into_iter()
                        .map(|(y, z)| lanchester_model::Mount {
                            name: format!("{y} {z}"),
                            x: 0.0,
                            y,
                            z,
                            spring: Some(lanchester_model::MountSpring::along_frame([1e13; 3])),
                        })
                        .collect();
                })
                .expect("an engine");
            let speeds = MountSpeeds::List(vec![4000.0 * std::f64::consts::PI / 30.0]);
            let study = mounts(&engine, &speeds, 1, None, &[]).expect("it is held");
            let first =
                study.response.speeds[0].orders.iter().find(|o| o.order == 1.0).expect("it is listed");
            for pair in first.forces.chunks(2) {
                // The basic crank balances all that rotates: the force is along x alone.
                let along = |j: usize| (pair[0][j] + pair[1][j]).norm();
                assert!((along(0) - printed).abs() <= tolerance, "{}: {} N", engine.name, along(0));
                assert!(along(1) < 1e-6 * printed);
            }
        }
    }
}
