//! The geometry matrices of the tool paper: where throws and weights stand.

use num_complex::Complex64;
use serde::Serialize;

/// One column a throw or weight, three rows as in the paper: its `x` (across the cylinders, ours: y), its `y` (along
/// the crank [m], ours: z) and its `z` (along the cylinders, ours: x). First and third row are sine and cosine of the
/// direction at `theta = 0`; a web without a weight has a column of zeros.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Matrix {
    /// First row: sine of the direction.
    pub across: Vec<f64>,
    /// Second row: plane along the crank, from its middle [m].
    pub along_crank: Vec<f64>,
    /// Third row: cosine of the direction.
    pub along_cylinders: Vec<f64>,
}

impl Matrix {
    /// Adds a column: direction [rad] and plane [m].
    pub(crate) fn push(&mut self, direction: f64, z: f64) {
        let turned = Complex64::cis(direction);
        self.across.push(turned.im);
        self.along_crank.push(z);
        self.along_cylinders.push(turned.re);
    }

    /// Adds a column of zeros.
    pub(crate) fn push_empty(&mut self) {
        self.across.push(0.0);
        self.along_crank.push(0.0);
        self.along_cylinders.push(0.0);
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.across.len()
    }

    /// Number of columns that hold a throw or a weight.
    pub fn filled(&self) -> usize {
        let filled = |k: &usize| self.across[*k] != 0.0 || self.along_cylinders[*k] != 0.0;
        (0..self.columns()).filter(filled).count()
    }
}

/// All geometry matrices of one engine.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MethodMatrices {
    /// `CS`, Eq 1 to 4: one column a throw, along the crank.
    pub crank: Matrix,
    /// `CW`, Eq 6 to 9: one column a web.
    pub counterweights: Matrix,
    /// `CW_1,r`, Eq 12 to 14: first-order shaft that turns with the crank.
    pub first_forward: Matrix,
    /// `CW_1,cr`, Eq 12 to 14: first-order shaft that turns against it.
    pub first_backward: Matrix,
    /// `CW_2,r`, Eq 19 to 21: second-order shaft that turns with the crank.
    pub second_forward: Matrix,
    /// `CW_2,cr`, Eq 19 to 21: second-order shaft that turns against it.
    pub second_backward: Matrix,
}
