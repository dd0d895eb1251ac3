//! Shares of the main bearings of one rotor, tabulated: every load of a rotor acts in a plane that never changes.

use crate::main_loads::MainLoads;
use crate::main_rules::{MainRule, MainShares};
use crate::train::{LowerPin, Train, Unbalance};
use nalgebra::Vector3;

/// A load on a shaft: force and couple of one row of [`RotorShares`].
pub(crate) struct ShaftLoad {
    /// Force [N]; of the unbalances along a or b by unit.
    pub force: Vector3<f64>,
    /// Couple about the axis [N m]; the same.
    pub couple: Vector3<f64>,
}

/// What every main bearing of a rotor carries of every load on it, by rule.
///
/// Rows: all unbalances `a + i b` along a, along b, the couples of each by its plane along a, along b, the polar inertia, the inertias that differ
/// across the axis, every rod on a crankpin, the teeth.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RotorShares {
    mains: usize,
    /// By row, rule and main: share of a force, and of a couple [1/m].
    table: Vec<[f64; 2]>,
}

impl RotorShares {
    /// Journals on the mains under `loads`; empty without two mains.
    pub(crate) fn carried(&self, loads: &[ShaftLoad]) -> MainLoads {
        if self.mains == 0 {
            return MainLoads::default();
        }
        let count = 3 * self.mains;
        debug_assert!(loads.len() * count == self.table.len(), "a load for every row");
        let mut sums = vec![[0.0; 2]; count];
        for (load, row) in loads.iter().zip(self.table.chunks_exact(count)) {
            let (force, couple) = (load.force, load.couple);
            if [force.x, force.y, couple.x, couple.y] == [0.0; 4] {
                // In a block at rest the gyroscopic couple and those of the planes.
                continue;
            }
            for (sum, [share, slope]) in sums.iter_mut().zip(row) {
                // A couple is a pair of forces: -i C times the slope.
                sum[0] += share * force.x + slope * couple.y;
                sum[1] += share * force.y - slope * couple.x;
            }
        }
        MainLoads::new(sums)
    }
}

impl Train {
    /// Shares of the mains of every rotor; `stiffness` by crankshaft and main, empty: all alike.
    pub fn main_shares(&self, stiffness: &[Vec<f64>]) -> Vec<RotorShares> {
        (0..self.rotors.len())
            .map(|index| self.rotor_shares(index, stiffness.get(index).map_or(&[][..], Vec::as_slice)))
            .collect()
    }

    fn rotor_shares(&self, index: usize, stiffness: &[f64]) -> RotorShares {
        let rotor = &self.rotors[index];
        let rules: Vec<MainShares> = MainRule::ALL
            .into_iter()
            .filter_map(|rule| MainShares::new(&rotor.mains, rule, stiffness))
            .collect();
        if rules.len() < MainRule::ALL.len() {
            return RotorShares::default();
        }
        let mut table = Vec::new();
        // A row as the sum of loads at planes, with the weights of their forces and of their couples.
        let mut row = |parts: &[(f64, [f64; 2])]| {
            for shares in &rules {
                for main in 0..rotor.mains.len() {
                    let mut sum = [0.0; 2];
                    for (z, weights) in parts {
                        let own = shares.share(main, *z);
                        (0..2).for_each(|k| sum[k] += weights[k] * own[k]);
                    }
                    table.push(sum);
                }
            }
        };
        let unbalances = |weights: &dyn Fn(&Unbalance) -> [f64; 2]| -> Vec<(f64, [f64; 2])> {
            rotor.unbalances.iter().map(|unbalance| (unbalance.z, weights(unbalance))).collect()
        };
        row(&unbalances(&|one| [one.moment.re; 2]));
        row(&unbalances(&|one| [one.moment.im; 2]));
        row(&unbalances(&|one| [0.0, one.z * one.moment.re]));
        row(&unbalances(&|one| [0.0, one.z * one.moment.im]));
        let each = (rotor.inertia - rotor.flywheel) / rotor.bays().count() as f64;
        let mut inertia: Vec<(f64, [f64; 2])> = rotor.bays().map(|z| (z, [0.0, each])).collect();
        inertia.push((rotor.mains.last().copied().unwrap_or(0.0), [0.0, rotor.flywheel]));
        row(&inertia);
        let each = 1.0 / rotor.bays().count() as f64;
        let unequal: Vec<(f64, [f64; 2])> = rotor.bays().map(|z| (z, [0.0, each])).collect();
        row(&unequal);
        for cylinder in &self.cylinders {
            if cylinder.rotor == index && cylinder.lower_pin == LowerPin::Crankpin {
                row(&[(cylinder.z, [1.0; 2])]);
            }
        }
        let teeth = self.rotors.iter().enumerate().rev().filter_map(|(other, own)| Some((other, own.mesh?)));
        for (_, mesh) in teeth.filter(|(other, _)| index == 0 || *other == index) {
            row(&[(mesh.z, [1.0; 2])]);
        }
        RotorShares { mains: rotor.mains.len(), table }
    }
}
