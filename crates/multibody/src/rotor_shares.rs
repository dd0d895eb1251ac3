//! Shares of the main bearings of one rotor, tabulated: every load of a rotor acts in a plane that never changes.

use crate::main_rules::{MainRule, MainShares};
use crate::train::{LowerPin, Train};
use nalgebra::Vector3;
use num_complex::Complex64;

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
    /// By rule, main and plane: share of a force, and its slope [1/m].
    rules: [Vec<[f64; 2]>; 3],
}

impl RotorShares {
    /// Journals on the mains under `loads`, by rule and main; empty without two mains.
    pub(crate) fn carried(&self, loads: &[ShaftLoad]) -> [Vec<[f64; 2]>; 3] {
        debug_assert!(self.mains == 0 || loads.len() == self.planes, "a load in every plane");
        let of = |shares: &[[f64; 2]]| {
            let mut sum = Complex64::ZERO;
            for ([share, slope], load) in shares.iter().zip(loads) {
                // A couple is a pair of forces: -i C times the slope.
                sum.re += share * load.force.x + slope * load.couple.y;
                sum.im += share * load.force.y - slope * load.couple.x;
            }
            [sum.re, sum.im]
        };
        let rule = |table: &Vec<[f64; 2]>| table.chunks_exact(self.planes.max(1)).map(of).collect();
        [rule(&self.rules[0]), rule(&self.rules[1]), rule(&self.rules[2])]
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
            let rules = MainRule::ALL.map(|rule| {
                let Some(shares) = MainShares::new(mains, rule, stiffness) else { return Vec::new() };
                let rows = (0..mains.len()).flat_map(|main| planes.iter().map(move |z| (main, *z)));
                rows.map(|(main, z)| shares.share(main, z)).collect()
            });
            let mains = if rules[0].is_empty() { 0 } else { mains.len() };
            RotorShares { mains, planes: planes.len(), rules }
        };
        (0..self.rotors.len()).map(of).collect()
    }
}
