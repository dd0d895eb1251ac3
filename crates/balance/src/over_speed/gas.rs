//! The gas of an engine over speed, and the torque with which it turns the block.

use crate::error::BalanceError;
use lanchester_mechanism::{CylinderGas, GasTrain, Lever, MountSystem};
use lanchester_model::Engine;
use num_complex::Complex64;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::rc::Rc;

/// The pressures on all pistons of an engine at any speed.
pub trait GasOverSpeed {
    /// One entry a cylinder, at a speed of crankshaft 1 [rad/s].
    ///
    /// # Errors
    /// Why there are none, in words.
    fn at(&self, speed: f64) -> Result<Vec<CylinderGas>, String>;

    /// Speeds [rad/s], rising, between which the pressures at every angle are linear in the speed, and beyond which they stay as they
    /// are; none where that is not known.
    fn knots(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// The pressures, or why there are none.
pub(crate) fn pressures(gas: &dyn GasOverSpeed, speed: f64) -> Result<Vec<CylinderGas>, BalanceError> {
    gas.at(speed).map_err(|reason| BalanceError::Gas { reason })
}

/// Speeds with their shares whose pressures add up to those at `speed`; `knots` as of [`GasOverSpeed::knots`].
pub(crate) fn parts(knots: &[f64], speed: f64) -> Vec<(f64, f64)> {
    let above = knots.partition_point(|knot| *knot < speed);
    match (above.checked_sub(1).map(|below| knots[below]), knots.get(above)) {
        (Some(below), Some(&next)) if speed < next => {
            let share = (speed - below) / (next - below);
            vec![(1.0 - share, below), (share, next)]
        }
        (_, Some(&first)) => vec![(1.0, first)],
        (Some(last), None) => vec![(1.0, last)],
        (None, None) => vec![(1.0, speed)],
    }
}

/// Highest orders that are tried, one after another.
const HIGHEST: [u32; 4] = [12, 24, 48, 96];

/// What the mounts feel of the orders above the highest one is less than this share of all.
const TAIL: f64 = 1e-6;

/// Orders below this share of the largest vanish.
const VANISHES: f64 = 1e-12;

/// Roll moment of the gas on the block at one speed, by order: no mean, which the mounts hold at rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct GasRoll {
    /// Order and amplitude [N m] of `Re( M e^{i n theta} )`.
    pub orders: Vec<(f64, Complex64)>,
}

/// Roll moments of the gas of an engine over speed, each computed once.
pub(crate) struct GasRolls<'a> {
    engine: Engine,
    gas: &'a dyn GasOverSpeed,
    /// Highest order that the mounts feel.
    pub highest: u32,
    /// Period of the gas [revolutions of crankshaft 1].
    pub revolutions: u32,
    knots: Vec<f64>,
    /// By the bits of the speed, which rise with it.
    known: RefCell<BTreeMap<u64, Rc<GasRoll>>>,
}

impl<'a> GasRolls<'a> {
    /// Of an engine on springs, with as many orders as its mounts feel.
    pub fn of(engine: &Engine, gas: &'a dyn GasOverSpeed) -> Result<GasRolls<'a>, BalanceError> {
        let system = MountSystem::new(engine)?;
        let (mut highest, mut revolutions) = (HIGHEST[0], 1);
        for speed in [engine.speed.lowest, engine.speed.highest] {
            let train = GasTrain::new(engine, &pressures(gas, speed)?, Lever::Exact)?;
            revolutions = (train.period() / TAU).round() as u32;
            let mut felt = Vec::new();
            for order in train.orders(2 * HIGHEST[HIGHEST.len() - 1]).iter().filter(|one| one.order > 0.0) {
                let transfer = system.transfer(order.order * speed, speed)?;
                let passed = transfer.iter().flatten().map(|component| component[5].norm_sqr()).sum::<f64>();
                felt.push((order.order, passed.sqrt() * order.roll_moment.norm()));
            }
            let beyond = |order: f64| felt.iter().filter(|one| one.0 > order).map(|one| one.1).sum::<f64>();
            let all = beyond(0.0);
            let enough = HIGHEST.iter().find(|order| beyond(f64::from(**order)) <= TAIL * all);
            highest = highest.max(*enough.unwrap_or(&HIGHEST[HIGHEST.len() - 1]));
        }
        let engine = engine.clone();
        Ok(GasRolls { engine, gas, highest, revolutions, knots: gas.knots(), known: RefCell::default() })
    }

    /// The roll moment at a speed of crankshaft 1 [rad/s].
    pub fn at(&self, speed: f64) -> Result<Rc<GasRoll>, BalanceError> {
        let mut orders: Vec<(f64, Complex64)> = Vec::new();
        for (share, knot) in parts(&self.knots, speed) {
            let known = self.computed(knot)?;
            // The same cylinders have the same orders.
            if orders.is_empty() {
                orders = known.orders.iter().map(|one| (one.0, share * one.1)).collect();
            } else {
                orders.iter_mut().zip(&known.orders).for_each(|(sum, one)| sum.1 += share * one.1);
            }
        }
        let largest = orders.iter().map(|one| one.1.norm()).fold(0.0, f64::max);
        orders.retain(|one| one.1.norm() > VANISHES * largest);
        Ok(Rc::new(GasRoll { orders }))
    }

    fn computed(&self, speed: f64) -> Result<Rc<GasRoll>, BalanceError> {
        if let Some(known) = self.known.borrow().get(&speed.to_bits()) {
            return Ok(Rc::clone(known));
        }
        let train = GasTrain::new(&self.engine, &pressures(self.gas, speed)?, Lever::Exact)?;
        let orders = train.orders(self.highest).into_iter().filter(|one| one.order > 0.0);
        let roll = Rc::new(GasRoll { orders: orders.map(|one| (one.order, one.roll_moment)).collect() });
        self.known.borrow_mut().insert(speed.to_bits(), Rc::clone(&roll));
        Ok(roll)
    }
}
