//! How the load of a crankshaft is shared by its main bearings: three rules, because a rigid shaft on more than two bearings leaves it open.
//!
//! Each rule is linear, and a load's share is a function of its plane alone. A force F at z gives `f_j(z) F` to main j, a couple C (`C_x + i C_y`,
//! a pair of forces) gives `-i C f_j'(z)`:
//!
//! ```text
//! cut      f_j: the straight lines between neighbouring mains, 1 at j, 0 at the others         shaft cut at every main
//! springs  f_j = k_j / K + k_j (z_j - zbar)(z - zbar) / SUM k (z - zbar)^2                     rigid shaft on springs k_j
//! beam     f_j: the natural cubic spline, 1 at j, 0 at the others, straight beyond the ends    uniform continuous beam
//! ```
//! The last is Müller-Breslau's: the influence line of a reaction is the elastic line under a unit displacement of that support, and
//! the elastic line of a uniform beam between point loads is a cubic spline. All three carry every force and every couple: `SUM f_j = 1`,
//! `SUM z_j f_j = z`.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

/// Who carries what.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MainRule {
    /// The shaft cut at every main bearing: each throw on the two beside it.
    Cut,
    /// A rigid shaft on radial springs.
    Springs,
    /// A uniform continuous beam on rigid bearings.
    Beam,
}

impl MainRule {
    /// All of them in the order of tables.
    pub const ALL: [MainRule; 3] = [MainRule::Cut, MainRule::Springs, MainRule::Beam];

    /// Name for tables.
    pub fn name(self) -> &'static str {
        match self {
            MainRule::Cut => "cut",
            MainRule::Springs => "springs",
            MainRule::Beam => "beam",
        }
    }
}

/// One rule for the mains of one crankshaft.
#[derive(Debug, Clone, PartialEq)]
pub struct MainShares {
    planes: Vec<f64>,
    rule: MainRule,
    /// Second derivatives of the spline of every main at every main, by rows; empty for the other rules.
    bends: Vec<Vec<f64>>,
    /// Stiffness of the springs.
    weights: Vec<f64>,
}

impl MainShares {
    /// For mains at `planes` [m], rising; `None` for fewer than two. `stiffness` of the mains' springs [N/m], one a main; empty: all alike.
    pub fn new(planes: &[f64], rule: MainRule, stiffness: &[f64]) -> Option<MainShares> {
        let rising = planes.windows(2).all(|pair| pair[1] > pair[0]);
        if planes.len() < 2 || !rising || planes.iter().any(|z| !z.is_finite()) {
            return None;
        }
        let weights =
            if stiffness.len() == planes.len() { stiffness.to_vec() } else { vec![1.0; planes.len()] };
        let bends = if rule == MainRule::Beam { spline_bends(planes) } else { Vec::new() };
        Some(MainShares { planes: planes.to_vec(), rule, bends, weights })
    }

    /// Planes of the mains [m].
    pub fn planes(&self) -> &[f64] {
        &self.planes
    }

    /// The bay of a plane: index of the main before it, the end bays reaching on without end.
    fn bay(&self, z: f64) -> usize {
        let inner = &self.planes[1..self.planes.len() - 1];
        inner.iter().filter(|main| **main <= z).count()
    }

    /// Share of main `main` of a force at `z`, and its slope [1/m].
    pub fn share(&self, main: usize, z: f64) -> [f64; 2] {
        match self.rule {
            MainRule::Cut => {
                let bay = self.bay(z);
                let [front, rear] = [self.planes[bay], self.planes[bay + 1]];
                let slope = 1.0 / (rear - front);
                match main {
                    _ if main == bay => [(rear - z) * slope, -slope],
                    _ if main == bay + 1 => [(z - front) * slope, slope],
                    _ => [0.0, 0.0],
                }
            }
            MainRule::Springs => {
                let total: f64 = self.weights.iter().sum();
                let mean = self.planes.iter().zip(&self.weights).map(|(z, k)| z * k).sum::<f64>() / total;
                let second: f64 =
                    self.planes.iter().zip(&self.weights).map(|(z, k)| k * (z - mean).powi(2)).sum();
                let slope = self.weights[main] * (self.planes[main] - mean) / second;
                [self.weights[main] / total + slope * (z - mean), slope]
            }
            MainRule::Beam => self.spline(main, z),
        }
    }

    fn spline(&self, main: usize, z: f64) -> [f64; 2] {
        let bay = self.bay(z);
        let [front, rear] = [self.planes[bay], self.planes[bay + 1]];
        let length = rear - front;
        let value = |at: usize| f64::from(u8::from(at == main));
        let [y0, y1] = [value(bay), value(bay + 1)];
        let [m0, m1] = [self.bends[main][bay], self.bends[main][bay + 1]];
        let slope = |a: f64, b: f64| {
            (y1 - y0) / length - length * (m1 - m0) / 6.0 + (b * b * m1 - a * a * m0) / (2.0 * length)
        };
        if z < self.planes[0] {
            let first = slope(length, 0.0);
            return [y0 + first * (z - front), first];
        }
        if z > self.planes[self.planes.len() - 1] {
            let last = slope(0.0, length);
            return [y1 + last * (z - rear), last];
        }
        let (a, b) = (rear - z, z - front);
        let chord = (y0 * a + y1 * b) / length;
        let bend = ((a * a * a / length - length * a) * m0 + (b * b * b / length - length * b) * m1) / 6.0;
        [chord + bend, slope(a, b)]
    }

    /// Load of main `main` of a force [N] and a couple [N m] at `z`.
    pub fn load(&self, main: usize, z: f64, force: Complex64, couple: Complex64) -> Complex64 {
        let [share, slope] = self.share(main, z);
        share * force - Complex64::I * slope * couple
    }
}

/// Second derivatives of the natural cubic splines with 1 at one plane and 0 at the others, by the plane with 1.
fn spline_bends(planes: &[f64]) -> Vec<Vec<f64>> {
    let count = planes.len();
    let gap = |k: usize| planes[k + 1] - planes[k];
    let mut system = DMatrix::<f64>::identity(count, count);
    for k in 1..count - 1 {
        system[(k, k - 1)] = gap(k - 1) / 6.0;
        system[(k, k)] = (gap(k - 1) + gap(k)) / 3.0;
        system[(k, k + 1)] = gap(k) / 6.0;
    }
    let factors = system.lu();
    let one = |main: usize| {
        let value = |at: usize| f64::from(u8::from(at == main));
        let kinks = DVector::from_fn(count, |k, _| {
            if k == 0 || k + 1 == count {
                0.0
            } else {
                (value(k + 1) - value(k)) / gap(k) - (value(k) - value(k - 1)) / gap(k - 1)
            }
        });
        let bends = factors.solve(&kinks);
        bends.map_or_else(|| vec![0.0; count], |bends| bends.iter().copied().collect())
    };
    (0..count).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_carries_force_and_couple() {
        let planes = [-0.21, -0.1, 0.02, 0.13, 0.2];
        let stiffness = [1.0, 2.0, 1.5, 3.0, 1.0];
        for rule in MainRule::ALL {
            let shares = MainShares::new(&planes, rule, &stiffness).expect("mains rise");
            for z in [-0.3, -0.21, -0.15, 0.0, 0.02, 0.11, 0.2, 0.26] {
                let all: Vec<[f64; 2]> = (0..planes.len()).map(|main| shares.share(main, z)).collect();
                let sum = |k: usize| all.iter().map(|share| share[k]).sum::<f64>();
                let lever = |k: usize| all.iter().zip(planes).map(|(share, at)| share[k] * at).sum::<f64>();
                assert!((sum(0) - 1.0).abs() < 1e-13 && sum(1).abs() < 1e-12, "{rule:?} {z}: force");
                assert!(
                    (lever(0) - z).abs() < 1e-13 && (lever(1) - 1.0).abs() < 1e-12,
                    "{rule:?} {z}: couple"
                );
            }
        }
    }

    #[test]
    fn two_mains_leave_no_choice() {
        let planes = [-0.07, 0.05];
        let by = |rule| MainShares::new(&planes, rule, &[]).expect("mains rise").share(0, 0.013);
        let [cut, springs, beam] = MainRule::ALL.map(by);
        for other in [springs, beam] {
            assert!((cut[0] - other[0]).abs() < 1e-15 && (cut[1] - other[1]).abs() < 1e-13);
        }
    }

    #[test]
    fn three_equal_spans_have_the_textbook_reactions() {
        // Two equal spans, load in the middle of the first: 13/32, 22/32, -3/32.
        let shares = MainShares::new(&[0.0, 2.0, 4.0], MainRule::Beam, &[]).expect("mains rise");
        for (main, wanted) in [13.0 / 32.0, 22.0 / 32.0, -3.0 / 32.0].into_iter().enumerate() {
            assert!((shares.share(main, 1.0)[0] - wanted).abs() < 1e-15);
        }
        // Slopes are the derivative of the shares.
        for z in [-0.5, 0.3, 1.7, 2.9, 4.4] {
            for main in 0..3 {
                let h = 1e-5;
                let by_difference = (shares.share(main, z + h)[0] - shares.share(main, z - h)[0]) / (2.0 * h);
                assert!((shares.share(main, z)[1] - by_difference).abs() < 1e-9, "{main} {z}");
            }
        }
    }
}
