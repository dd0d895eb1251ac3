//! Shares of the main bearings of one rotor, tabulated: every load of a rotor acts in a plane that never changes.

use crate::main_rules::{MainRule, MainShares};
use crate::train::{LowerPin, Train};
use nalgebra::Vector3;

/// A load on a shaft: force and couple at a plane.
pub(crate) struct ShaftLoad {
    /// Plane [m].
    pub z: f64,
    /// Force [N].
    pub force: Vector3<f64>,
    /// Couple about the axis in that plane [N m].
    pub couple: Vector3<f64>,
}

/// What every main bearing of a rotor carries of every load on it, by rule.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RotorShares {
    mains: usize,
    /// Planes of the loads in the order of [`Train::load_planes`].
    planes: usize,
    /// By plane, rule and main: share of a force, and its slope [1/m].
    table: Vec<[f64; 2]>,
}

impl RotorShares {
    /// Journals on the mains under `loads`, by rule and main; empty without two mains. `sums`: room from before.
    pub(crate) fn carried(&self, loads: &[ShaftLoad], sums: &mut Vec<[f64; 2]>) -> [Vec<[f64; 2]>; 3] {
        if self.mains == 0 {
            return Default::default();
        }
        debug_assert!(loads.len() == self.planes, "a load in every plane");
        sums.clear();
        sums.resize(3 * self.mains, [0.0; 2]);
        for (load, row) in loads.iter().zip(self.table.chunks_exact(3 * self.mains)) {
            let (force, couple) = (load.force, load.couple);
            for (sum, [share, slope]) in sums.iter_mut().zip(row) {
                // A couple is a pair of forces: -i C times the slope.
                sum[0] += share * force.x + slope * couple.y;
                sum[1] += share * force.y - slope * couple.x;
            }
        }
        [0, 1, 2].map(|rule| sums[rule * self.mains..(rule + 1) * self.mains].to_vec())
    }
}

impl Train {
    /// Planes in which loads act on a rotor [m]: its unbalances, its rods, what sits behind the last main, the middles of its bays.
    pub(crate) fn load_planes(&self, index: usize) -> Vec<f64> {
        let rotor = &self.rotors[index];
        let mut planes: Vec<f64> = rotor.unbalances.iter().map(|unbalance| unbalance.z).collect();
        let rods = self.cylinders.iter().filter(|c| c.rotor == index && c.lower_pin == LowerPin::Crankpin);
        planes.extend(rods.map(|cylinder| cylinder.z));
        planes.push(rotor.mains.last().copied().unwrap_or(0.0));
        planes.extend(rotor.bays());
        planes
    }

    /// Shares of the mains of every rotor; `stiffness` by crankshaft and main, empty: all alike.
    pub fn main_shares(&self, stiffness: &[Vec<f64>]) -> Vec<RotorShares> {
        let of = |index: usize| {
            let mains = &self.rotors[index].mains;
            let planes = self.load_planes(index);
            let stiffness = stiffness.get(index).map_or(&[][..], Vec::as_slice);
            let rules: Vec<MainShares> = MainRule::ALL
                .into_iter()
                .filter_map(|rule| MainShares::new(mains, rule, stiffness))
                .collect();
            if rules.len() < MainRule::ALL.len() {
                return RotorShares::default();
            }
            let mut table = Vec::with_capacity(planes.len() * rules.len() * mains.len());
            for z in &planes {
                for shares in &rules {
                    table.extend((0..mains.len()).map(|main| shares.share(main, *z)));
                }
            }
            RotorShares { mains: mains.len(), planes: planes.len(), table }
        };
        (0..self.rotors.len()).map(of).collect()
    }
}
