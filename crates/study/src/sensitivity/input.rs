//! Inputs: quantities of one part, or of all parts of a kind together.

use super::operating_point::OperatingPoint;
use super::quantity::Quantity;
use lanchester_mechanism::PeriodicCurve;
use lanchester_model::{Mount, MountSpring, Varied};
use serde::Serialize;

/// A quantity of one part, or of all parts together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Input {
    /// Which quantity.
    pub quantity: Quantity,
    /// Index of the part; `None` for all parts together.
    pub part: Option<usize>,
}

impl Input {
    /// The quantities of an engine, each for all parts together.
    pub fn common(point: &OperatingPoint) -> Vec<Input> {
        Quantity::all()
            .filter(|quantity| quantity.parts(point) > 0)
            .map(|quantity| Input { quantity, part: None })
            .collect()
    }

    /// The quantities of an engine, part by part; those of the whole engine once.
    pub fn single(point: &OperatingPoint) -> Vec<Input> {
        Quantity::all()
            .flat_map(|quantity| (0..quantity.parts(point)).map(move |part| (quantity, part)))
            .map(|(quantity, part)| Input { quantity, part: (!quantity.is_of_engine()).then_some(part) })
            .collect()
    }

    /// An input by which nothing changes.
    pub(super) fn idle() -> Input {
        Input { quantity: Quantity::PinOffset, part: Some(usize::MAX) }
    }

    /// Whether it is about part `index`.
    pub(super) fn is_of(self, index: usize) -> bool {
        self.part.is_none_or(|part| part == index)
    }

    /// Its value, where all of its parts have the same; directions, places of mass and phases have none.
    pub fn nominal(self, point: &OperatingPoint) -> Option<f64> {
        match self.quantity {
            Quantity::Spacing => return point.engine.spacing(),
            Quantity::GasPressure | Quantity::MountStiffness | Quantity::MountDamping => return Some(1.0),
            _ => {}
        }
        let mut copy = point.clone();
        let values = self.quantity.numbers(&mut copy);
        let mut own =
            values.iter().enumerate().filter(|(index, _)| self.is_of(*index)).map(|(_, value)| **value);
        let first = own.next()?;
        own.all(|value| (value - first).abs() <= 1e-12 * first.abs()).then_some(first)
    }

    /// Puts this quantity of `point` off by `deviation`, in its SI unit.
    pub fn deviate(self, point: &mut OperatingPoint, deviation: f64) {
        match self.quantity {
            Quantity::Spacing => {
                if let Some(spacing) = point.engine.spacing() {
                    point.engine = point.engine.stretched(1.0 + deviation / spacing);
                }
            }
            Quantity::Part(Varied::RodCentre) => {
                let cylinders = point.engine.cylinders.iter_mut().enumerate();
                for (_, cylinder) in cylinders.filter(|(index, _)| self.is_of(*index)) {
                    let moved = cylinder.rod.mass() * deviation / cylinder.rod.length;
                    cylinder.rod.small_end_mass += moved;
                    cylinder.rod.big_end_mass -= moved;
                }
            }
            Quantity::Part(Varied::ShaftPhase) => {
                let own = point.engine.shafts.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
                own.flat_map(|(_, shaft)| &mut shaft.weights).for_each(|weight| weight.phase += deviation);
            }
            Quantity::GasPressure => {
                let gas = point.gas.iter_mut().flatten().enumerate();
                for (_, gas) in gas.filter(|(index, _)| self.is_of(*index)) {
                    gas.cylinder = PeriodicCurve::sum(&[(1.0 + deviation, &gas.cylinder)])
                        .expect("invariant: a curve times a finite factor is a curve");
                }
            }
            Quantity::MountStiffness => self.scale_springs(&mut point.engine.mounts, deviation, stiffen),
            Quantity::MountDamping => self.scale_springs(&mut point.engine.mounts, deviation, damp),
            quantity => {
                let own = quantity.numbers(point).into_iter().enumerate();
                own.filter(|(index, _)| self.is_of(*index)).for_each(|(_, value)| *value += deviation);
            }
        }
    }

    fn scale_springs(self, mounts: &mut [Mount], deviation: f64, scale: fn(&mut MountSpring, f64)) {
        let own = mounts.iter_mut().enumerate().filter(|(index, _)| self.is_of(*index));
        own.filter_map(|(_, mount)| mount.spring.as_mut()).for_each(|spring| scale(spring, 1.0 + deviation));
    }
}

fn stiffen(spring: &mut MountSpring, factor: f64) {
    let of_table = spring.table.iter_mut().flat_map(|point| &mut point.stiffness);
    spring.stiffness.iter_mut().chain(of_table).for_each(|value| *value *= factor);
}

fn damp(spring: &mut MountSpring, factor: f64) {
    let of_table = spring.table.iter_mut().flat_map(|point| &mut point.loss_factor);
    let lost = spring.loss_factor.iter_mut().chain(of_table);
    lost.chain(&mut spring.damping).for_each(|value| *value *= factor);
}
