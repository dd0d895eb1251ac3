//! Force and couple by order, eight samples at a time.

use lanchester_numerics::{ComplexLanes, Lanes};

/// Orders below this share of the first are left out.
pub(crate) const NOTHING: f64 = 1e-13;

/// Highest harmonic of a crankshaft that is looked at.
pub(crate) const HIGHEST: u32 = 60;

/// Force [N] and couple about the origin [N m] by order and sense: 0 forward, 1 backward.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Spectrum {
    pub force: Vec<[ComplexLanes; 2]>,
    pub couple: Vec<[ComplexLanes; 2]>,
}

impl Spectrum {
    /// Nothing, of so many orders.
    pub fn clear(&mut self, orders: usize) {
        for all in [&mut self.force, &mut self.couple] {
            all.clear();
            all.resize(orders, [ComplexLanes::ZERO; 2]);
        }
    }

    /// Adds a force in a plane to force and couple.
    #[inline]
    pub fn add(&mut self, place: usize, sense: usize, force: &ComplexLanes, plane: &Lanes) {
        let sum = &mut self.force[place][sense];
        sum.re = Lanes::each(|i| sum.re[i] + force.re[i]);
        sum.im = Lanes::each(|i| sum.im[i] + force.im[i]);
        // i z F.
        let sum = &mut self.couple[place][sense];
        sum.re = Lanes::each(|i| sum.re[i] - plane[i] * force.im[i]);
        sum.im = Lanes::each(|i| sum.im[i] + plane[i] * force.re[i]);
    }
}
