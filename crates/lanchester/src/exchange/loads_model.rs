//! Loads of an engine as a model that other programs step through: functional mock-up units.

use crate::inertias::rotating_bodies;
use crate::mounted::depends_on_speed;
use crate::pressure::cylinders::cylinder_gas;
use crate::pressure::error::GasError;
use crate::pressure::measured::TraceFile;
use lanchester_exchange::{FmuKind, FmuRole, FmuVariable};
use lanchester_mechanism::{
    Excitation, GasTrain, Lever, LoadError, LoadRequest, Mechanism, MountError, MountSystem, TorqueError,
    inertia_excitations, merged_orders, rotor_inertia_about_z,
};
use lanchester_model::Engine;
use lanchester_results::OrderLoads;
use num_complex::Complex64;

/// Highest order of the forces on mounts.
const MOUNT_ORDERS: u32 = 8;

/// Why a model has no loads.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadsModelError {
    /// The crank train.
    #[error(transparent)]
    Loads(#[from] LoadError),
    /// The block and its mounts.
    #[error(transparent)]
    Mounts(#[from] MountError),
    /// The pressures.
    #[error(transparent)]
    Gas(#[from] GasError),
    /// The torque of the gas.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// A speed whose square is beyond all numbers.
    #[error("at {got} rad/s the loads are larger than any number")]
    Overflow {
        /// [rad/s]
        got: f64,
    },
    /// A speed that is none.
    #[error("the speed must be 0 rad/s or more, and is {got} rad/s")]
    Speed {
        /// [rad/s]
        got: f64,
    },
}

/// The loads of an engine at any speed and crank angle, in the frame and signs of the engine file: what shakes the block, the torque at
/// crankshaft 1, and the force of the block on each mount.
///
/// They are those of a crankshaft that turns at the present speed for good: inertia loads grow with the speed squared and have no part of
/// its change, the pressures are those of the cycle at that speed, and the block swings as it does once settled, with orders up to 8.
#[derive(Debug)]
pub struct LoadsModel {
    engine: Engine,
    traces: Vec<TraceFile>,
    /// At 1 rad/s.
    mechanism: Mechanism,
    mounts: Option<MountSystem>,
    gas: Option<GasAt>,
    forces: Option<ForcesAt>,
}

/// The gas at one speed.
#[derive(Debug)]
struct GasAt {
    speed: f64,
    train: GasTrain,
    orders: Vec<OrderLoads>,
}

/// Forces on the mounts at one speed: order by order, mount by mount.
#[derive(Debug)]
struct ForcesAt {
    speed: f64,
    has_gas: bool,
    orders: Vec<(f64, Vec<[Complex64; 3]>)>,
}

impl LoadsModel {
    /// Reference of the speed [rad/s], an input.
    pub const SPEED: u32 = 1;
    /// Reference of whether the gas presses, an input.
    pub const GAS: u32 = 2;
    /// Reference of the crank angle at the start [rad], a parameter.
    pub const START_ANGLE: u32 = 3;
    /// Reference of the crank angle [rad], the integral of the speed from the start angle on.
    pub const CRANK_ANGLE: u32 = 4;
    /// Reference of the first load; the others follow.
    pub const FIRST_LOAD: u32 = 5;

    /// An engine, prepared; `traces` holds the files that [`crate::trace_names`] names.
    ///
    /// # Errors
    /// [`LoadsModelError`] where loads, mounts or the gas at the highest speed of the file cannot be computed.
    pub fn new(engine: Engine, traces: Vec<TraceFile>) -> Result<LoadsModel, LoadsModelError> {
        let highest = engine.speed.highest;
        LoadsModel::at_speed(engine, traces, highest, true)
    }

    /// The same, whose loads can be computed at this speed at least [rad/s]; with or without the mounts of the file.
    pub(crate) fn at_speed(
        engine: Engine,
        traces: Vec<TraceFile>,
        speed: f64,
        with_mounts: bool,
    ) -> Result<LoadsModel, LoadsModelError> {
        let request = LoadRequest { speed: Some(1.0), samples: 1, ..LoadRequest::default() };
        let mechanism = Mechanism::new(&engine, &request)?;
        let mounts = match with_mounts && engine.block.is_some() && !engine.mounts.is_empty() {
            true => {
                let rotors = rotor_inertia_about_z(&rotating_bodies(&engine));
                Some(MountSystem::new(&engine)?.with_rotors(rotors))
            }
            false => None,
        };
        let mut model = LoadsModel { engine, traces, mechanism, mounts, gas: None, forces: None };
        let has_gas = model.has_gas();
        model.at(speed, 0.0, has_gas)?;
        Ok(model)
    }

    /// Whether the file gives gas.
    pub fn has_gas(&self) -> bool {
        self.engine.gas.is_some()
    }

    /// The engine.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Time, inputs, the start angle, the crank angle and the loads, in the order of their references from 0 on.
    pub fn variables(&self) -> Vec<FmuVariable> {
        let mut variables: Vec<FmuVariable> = Vec::new();
        let mut push = |name: String, description: String, role, unit, start| {
            let kind = FmuKind::Real { unit, start, range: [None; 2] };
            variables.push(FmuVariable { name, reference: variables.len() as u32, description, role, kind });
        };
        let plain = |text: &str| text.to_owned();
        push(plain("time"), plain("Time"), FmuRole::Time, "s", None);
        let speed = Some(self.engine.speed.highest);
        push(plain("speed"), plain("Speed of crankshaft 1"), FmuRole::Input, "rad/s", speed);
        push(plain("gas"), String::new(), FmuRole::Input, "", None);
        let start = "Crank angle at the start; 0: throw 1 points along x";
        push(plain("start_angle"), plain(start), FmuRole::Parameter, "rad", Some(0.0));
        let angle = "Angle of crankshaft 1: integral of the speed from the start angle on";
        push(plain("crank_angle"), plain(angle), FmuRole::Output, "rad", None);
        let loads = [
            ("force_x", "Shaking force on the block along x", "N"),
            ("force_y", "Shaking force on the block along y", "N"),
            ("couple_x", "Couple on the block about x through the origin", "N.m"),
            ("couple_y", "Couple on the block about y through the origin", "N.m"),
            ("roll_moment", "Roll moment on the block about z, of inertia and gas", "N.m"),
            (
                "torque",
                "Torque that the crank train delivers at crankshaft 1, of inertia and gas, positive in the sense of rotation",
                "N.m",
            ),
        ];
        for (name, description, unit) in loads {
            push(plain(name), plain(description), FmuRole::Output, unit, None);
        }
        let mounts = if self.mounts.is_some() { self.engine.mounts.as_slice() } else { &[] };
        for (place, mount) in mounts.iter().enumerate() {
            let number = place + 1;
            for axis in ["x", "y", "z"] {
                let description = format!(
                    "Force of the block on mount {number} ({}) along {axis}, settled at the present speed, without weight and mean torque",
                    mount.name
                );
                push(format!("mount_{number}_force_{axis}"), description, FmuRole::Output, "N", None);
            }
        }
        if let FmuKind::Real { range, .. } = &mut variables[Self::SPEED as usize].kind {
            *range = [Some(0.0), None];
        }
        let gas = &mut variables[Self::GAS as usize];
        gas.kind = FmuKind::Boolean { start: self.has_gas() };
        gas.description = match self.has_gas() {
            true => "Whether the gas presses on the pistons".to_owned(),
            false => "Whether the gas presses on the pistons: the engine file gives none, so that only false can be".to_owned(),
        };
        variables
    }

    /// The loads at a speed [rad/s] and a crank angle [rad], in the order of [`LoadsModel::variables`].
    ///
    /// # Errors
    /// [`LoadsModelError`]: a negative speed, one whose loads are larger than any number, gas that the file does not give or that its cycle cannot have at this speed, an undamped
    /// block at one of its natural frequencies.
    pub fn at(&mut self, speed: f64, theta: f64, has_gas: bool) -> Result<Vec<f64>, LoadsModelError> {
        if !(speed >= 0.0 && speed.is_finite()) {
            return Err(LoadsModelError::Speed { got: speed });
        }
        if has_gas {
            self.prepare_gas(speed)?;
        }
        let square = speed * speed;
        let inertia = self.mechanism.components(theta);
        let gas = self.gas.as_ref().filter(|_| has_gas).map_or(0.0, |gas| gas.train.torque(theta));
        let mut loads = vec![
            square * inertia.force_x,
            square * inertia.force_y,
            square * inertia.couple_x,
            square * inertia.couple_y,
            square * inertia.roll_moment - gas,
            square * inertia.shaft_torque + gas,
        ];
        if self.mounts.is_some() {
            self.prepare_forces(speed, has_gas)?;
        }
        let forces = self.forces.as_ref().filter(|_| self.mounts.is_some());
        for mount in 0..forces.map_or(0, |_| self.engine.mounts.len()) {
            for axis in 0..3 {
                let of_order = |(order, all): &(f64, Vec<[Complex64; 3]>)| {
                    (all[mount][axis] * Complex64::cis(order * theta)).re
                };
                loads.push(forces.map_or(0.0, |forces| forces.orders.iter().map(of_order).sum()));
            }
        }
        if loads.iter().all(|load| load.is_finite()) {
            Ok(loads)
        } else {
            Err(LoadsModelError::Overflow { got: speed })
        }
    }

    fn prepare_gas(&mut self, speed: f64) -> Result<(), LoadsModelError> {
        let varies = self.engine.gas.as_ref().is_some_and(depends_on_speed);
        // Pressures that are the same at every speed are computed once.
        let speed = if varies { speed } else { self.engine.speed.highest };
        if self.gas.as_ref().is_none_or(|gas| gas.speed != speed) {
            let report = cylinder_gas(&self.engine, &self.traces, speed)?;
            let train = GasTrain::new(&self.engine, &report.cylinders, Lever::Exact)?;
            let orders = if self.mounts.is_some() { train.orders(MOUNT_ORDERS) } else { Vec::new() };
            self.gas = Some(GasAt { speed, train, orders });
        }
        Ok(())
    }

    fn prepare_forces(&mut self, speed: f64, has_gas: bool) -> Result<(), LoadsModelError> {
        let is_known = |own: &ForcesAt| own.speed == speed && own.has_gas == has_gas;
        let Some(system) = self.mounts.as_ref().filter(|_| !self.forces.as_ref().is_some_and(is_known))
        else {
            return Ok(());
        };
        // At rest nothing of inertia shakes.
        let mut orders = match speed > 0.0 {
            true => inertia_excitations(&self.engine, &[speed], MOUNT_ORDERS)?.swap_remove(0).orders,
            false => Vec::new(),
        };
        if let Some(gas) = self.gas.as_ref().filter(|_| has_gas) {
            orders = merged_orders(&orders, &gas.orders);
        }
        let found = system.response(&[Excitation { speed, orders }])?;
        let own = found.speeds.into_iter().next().map_or_else(Vec::new, |own| own.orders);
        let orders = own.into_iter().map(|own| (own.order, own.forces)).collect();
        self.forces = Some(ForcesAt { speed, has_gas, orders });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::mounted::{MountSpeeds, mounts};
    use lanchester_mechanism::loads;

    fn example(text: &str) -> LoadsModel {
        LoadsModel::new(lanchester_file::read(text).engine().unwrap(), Vec::new()).unwrap()
    }

    #[test]
    fn loads_are_those_of_the_closed_form() {
        let mut model = example(include_str!("../../../../examples/v6-60.toml"));
        let speed = 321.0;
        let request = LoadRequest { speed: Some(speed), samples: 36, ..LoadRequest::default() };
        let found = loads(model.engine(), &request).unwrap();
        let trace = &found.total.trace;
        for (place, theta) in trace.theta.iter().enumerate() {
            let own = model.at(speed, *theta, false).unwrap();
            let wanted = [
                (trace.force_x[place], &trace.force_x),
                (trace.force_y[place], &trace.force_y),
                (trace.couple_x[place], &trace.couple_x),
                (trace.couple_y[place], &trace.couple_y),
                (trace.roll_moment[place], &trace.roll_moment),
                (trace.shaft_torque[place], &trace.shaft_torque),
            ];
            assert_eq!(own.len(), wanted.len());
            for (own, (wanted, all)) in own.iter().zip(wanted) {
                let size = all.iter().fold(1e-3f64, |size, value| size.max(value.abs()));
                assert!((own - wanted).abs() <= 1e-11 * size, "{own} {wanted} of {size}");
            }
        }
    }

    #[test]
    fn forces_on_mounts_are_those_of_the_settled_block() {
        let mut model = example(include_str!("../../../../examples/in-line-4-mounts.toml"));
        let speed = 250.0;
        let study = mounts(model.engine(), &MountSpeeds::List(vec![speed]), 8, Some(&[]), &[]).unwrap();
        let settled = &study.response.speeds[0];
        for mount in 0..model.engine().mounts.len() {
            let size = |model: &mut LoadsModel, theta: f64| {
                let own = &model.at(speed, theta, true).unwrap()[6 + 3 * mount..9 + 3 * mount];
                own.iter().map(|force| force * force).sum::<f64>().sqrt()
            };
            let peak = &settled.peaks[mount];
            let found = size(&mut model, peak.theta);
            assert!((found - peak.value).abs() <= 1e-9 * peak.value, "{found} {}", peak.value);
            let elsewhere = (0..720).map(|k| size(&mut model, f64::from(k).to_radians()));
            assert!(elsewhere.fold(0.0, f64::max) <= peak.value * (1.0 + 1e-9));
        }
    }

    #[test]
    fn speeds_and_gas_that_cannot_be_are_refused() {
        let mut without = example(include_str!("../../../../examples/v6-60.toml"));
        assert!(matches!(without.at(-1.0, 0.0, false), Err(LoadsModelError::Speed { .. })));
        assert!(matches!(without.at(f64::NAN, 0.0, false), Err(LoadsModelError::Speed { .. })));
        for speed in [1e300, 1e160] {
            assert!(
                matches!(without.at(speed, 0.5, false), Err(LoadsModelError::Overflow { .. })),
                "{speed}"
            );
        }
        assert!(matches!(without.at(100.0, 0.0, true), Err(LoadsModelError::Gas(GasError::NoGas))));
        assert!(without.at(0.0, 1.0, false).unwrap().iter().all(|load| *load == 0.0));
        // A cycle with heat release needs time.
        let mut single = example(include_str!("../../../../examples/single-gas.toml"));
        assert!(single.at(0.0, 1.0, true).is_err());
    }
}
