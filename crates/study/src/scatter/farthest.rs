//! How far force and couple of an engine may be from the nominal ones at most, by the triangle inequality.
//!
//! What each part may be off by its masses, lengths, angles and plane is summed, in whatever direction it points (book, eq. 30.5).

use crate::scatter::articulated::{ArticulatedBound, ArticulatedRod, ArticulatedRods};
use crate::scatter::coefficients::CoefficientRange;
use crate::scatter::model::Model;
use crate::scatter::plain_rod::PlainRod;
use crate::scatter::value::Value;
use num_complex::Complex64;

/// Bounds of a model, prepared.
pub(crate) struct Farthest<'a> {
    model: &'a Model,
    articulated: Vec<(&'a PlainRod, &'a ArticulatedRod, ArticulatedBound)>,
}

/// Sums of what the parts may be off: force [N] and couple [N m], by sense.
#[derive(Default)]
struct Sums([[f64; 2]; 2]);

impl Sums {
    /// Adds a vector of this nominal size that may be off so much.
    fn add(&mut self, sense: usize, [size, off]: [f64; 2], plane: &Value) {
        self.0[0][sense] += off;
        self.0[1][sense] += plane.largest() * off + plane.half * size;
    }
}

impl<'a> Farthest<'a> {
    pub fn of(model: &'a Model) -> Farthest<'a> {
        let of_master = |rods: &'a ArticulatedRods| {
            let master = &model.cylinders[rods.master];
            rods.bounds(master).map(move |(rod, bound)| (master, rod, bound))
        };
        Farthest { model, articulated: model.articulated.iter().flat_map(of_master).collect() }
    }

    /// How far force [N] and couple [N m] of the order at `place` may be off, by sense.
    pub fn order(&self, place: usize) -> [[f64; 2]; 2] {
        let mut sums = self.without_articulated_pistons(place);
        for (master, rod, bound) in &self.articulated {
            let Some(own) = master.harmonics.iter().position(|harmonic| harmonic.place == place) else {
                continue;
            };
            for sense in 0..2 {
                sums.add(sense, piston_off(master, rod, bound.harmonics[own]), &rod.parts.plane);
            }
        }
        sums.0
    }

    /// How far force [N] and couple [N m] of all orders may be off at any angle of the crank.
    pub fn peak(&self) -> [f64; 2] {
        let of_orders = |quantity: usize| -> f64 {
            (0..self.model.orders.len())
                .map(|place| self.without_articulated_pistons(place).0[quantity].iter().sum::<f64>())
                .sum()
        };
        let mut sums = Sums::default();
        for (master, rod, bound) in &self.articulated {
            sums.add(0, piston_off(master, rod, bound.peak), &rod.parts.plane);
        }
        [0, 1].map(|quantity| of_orders(quantity) + sums.0[quantity][0])
    }

    fn without_articulated_pistons(&self, place: usize) -> Sums {
        let mut sums = Sums::default();
        for rod in &self.model.cylinders {
            let Some(own) = rod.harmonics.iter().position(|harmonic| harmonic.place == place) else {
                continue;
            };
            for sense in 0..2 {
                sums.add(sense, rod.piston_off(own), &rod.parts.plane);
            }
            if rod.harmonics[own].number == 1 {
                sums.add(rod.crank.sense, rod.big_end_off(), &rod.parts.plane);
            }
        }
        for (master, rod, _) in &self.articulated {
            let Some(own) = master.harmonics.iter().position(|harmonic| harmonic.place == place) else {
                continue;
            };
            for (against, off) in knuckle_off(master, rod, own).into_iter().enumerate() {
                sums.add(master.crank.sense ^ against, off, &rod.parts.plane);
            }
        }
        for t in self.model.turning.iter().filter(|t| t.slot[0] == place) {
            let plane = Value::fixed(t.plane);
            let (size, off) = (t.unbalance.nominal.abs() * t.square, t.unbalance.half * t.square);
            sums.add(t.slot[1], [size, off + (size + off) * t.angle.half], &plane);
        }
        sums
    }
}

/// Nominal size of a piston's force [N] and how far it may be off, from the same by mass and square of the speed.
fn piston_off(master: &PlainRod, rod: &ArticulatedRod, [size, off]: [f64; 2]) -> [f64; 2] {
    let square = master.crank.square;
    let [mass, mass_off] = rod.parts.reciprocating();
    let nominal = square * mass * size;
    let off = square * ((mass + mass_off) * off + mass_off * size);
    [nominal, off + (nominal + off) * rod.parts.axis.half]
}

/// Nominal size of the force [N] of a big end on its knuckle pin and how far it may be off, with the crank and against it, of the
/// master's harmonic `own` in the list.
fn knuckle_off(master: &PlainRod, rod: &ArticulatedRod, own: usize) -> [[f64; 2]; 2] {
    let [mass, mass_off] = rod.parts.big_end();
    let (square, radius) = (master.crank.square, &master.radius);
    let number = f64::from(master.harmonics[own].number);
    let first = if number == 1.0 { 1.0 } else { 0.0 };
    // k, and how far it may be off by the master's length.
    let length = &master.parts.length;
    let arm = rod.pin.radius / length.nominal;
    let arm_off = rod.pin.radius / length.span()[0] - arm;
    let knuckle = Complex64::from_polar(arm, rod.pin.angle);
    let range: &CoefficientRange = &master.coefficients;
    let [size, spread] = range.size_and_spread(own);
    let middle = range.middle(own);
    // The nominal coefficient is one within the ranges.
    let of_piston = 0.5 * (arm * spread + arm_off * (size + spread));
    let forward = (0.5 * knuckle * middle + first * (1.0 - knuckle)).norm() + 0.5 * arm * spread;
    let backward = 0.5 * arm * (size + spread);
    [(forward, of_piston + first * arm_off), (backward, of_piston)].map(|(share, share_off)| {
        let nominal = square * mass * radius.nominal * share;
        let product_off = mass * radius.half + mass_off * radius.largest();
        let off = square * (product_off * (share + share_off) + mass * radius.nominal * share_off);
        let angle = number * (master.throw.half + master.parts.axis.half) + master.parts.axis.half;
        [nominal, off + (nominal + off) * angle]
    })
}
