//! Solutions whose residual is always known: a factor in single precision with conjugate gradients in double, or a double one.

use super::factor::{Factor, FactorPlan, Precision, SolveEstimate};
use super::matrix::{SymmetricMatrix, add, dot, norm};
use crate::FlexError;
use serde::Serialize;

/// Residual over right-hand side that is asked for.
const WANTED: f64 = 1e-11;
/// Residual above which a factor in double precision is made: stiff supports leave rounding of up to that size in either precision.
const ENOUGH: f64 = 1e-9;
/// Iterations after which a factor in double precision is made.
const ITERATIONS: usize = 15;
/// Right-hand sides that go through a factor together.
const TOGETHER: usize = 8;

/// How a system was solved.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SolveReport {
    /// Unknowns.
    pub unknowns: usize,
    /// Entries of the lower triangle of the matrix.
    pub nonzeros: usize,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Floating-point operations of the factor.
    pub factor_operations: f64,
    /// Bytes of matrix and factor.
    pub bytes: u64,
    /// Precision of the factor.
    pub precision: Precision,
    /// Largest number of iterations of a load case.
    pub iterations: usize,
    /// Largest `|K u - f|/|f|` of a load case.
    pub residual: f64,
}

enum Made {
    Single(Factor<f32>),
    Double(Factor<f64>),
}

/// A matrix with its factor.
pub struct Solver {
    matrix: SymmetricMatrix,
    plan: FactorPlan,
    factor: Made,
    precision: Precision,
    memory: u64,
}

/// The factor in this precision; where single precision breaks off, in double.
fn made(
    matrix: &SymmetricMatrix,
    plan: &FactorPlan,
    precision: Precision,
    memory: u64,
) -> Result<Made, FlexError> {
    Ok(match precision {
        Precision::Single => match Factor::new(matrix, plan) {
            Ok(factor) => Made::Single(factor),
            Err(_) => {
                plan.check(Precision::Double, memory)?;
                Made::Double(Factor::new(matrix, plan)?)
            }
        },
        Precision::Double => Made::Double(Factor::new(matrix, plan)?),
    })
}

impl Solver {
    /// Factors a matrix within this many bytes; `watch` sees before what it will cost. Where single precision breaks off, double precision
    /// is tried.
    ///
    /// # Errors
    /// [`FlexError::Memory`], [`FlexError::NotDefinite`].
    pub fn new(
        matrix: SymmetricMatrix,
        precision: Precision,
        memory: u64,
        watch: &dyn Fn(&SolveEstimate),
    ) -> Result<Solver, FlexError> {
        let plan = FactorPlan::new(&matrix)?;
        watch(&plan.estimate(precision));
        plan.check(precision, memory)?;
        let factor = made(&matrix, &plan, precision, memory)?;
        Ok(Solver { matrix, plan, factor, precision, memory })
    }

    /// Factors another matrix with entries at the same places, by the same plan.
    ///
    /// # Errors
    /// [`FlexError::Memory`], [`FlexError::NotDefinite`].
    pub fn replace(&mut self, matrix: SymmetricMatrix) -> Result<(), FlexError> {
        assert_eq!(matrix.values.len(), self.matrix.values.len(), "invariant: one pattern, one plan");
        self.factor = made(&matrix, &self.plan, self.precision, self.memory)?;
        self.matrix = matrix;
        Ok(())
    }

    /// The matrix.
    pub fn matrix(&self) -> &SymmetricMatrix {
        &self.matrix
    }

    /// Applies the factor to right-hand sides one after the other.
    pub fn apply(&self, sides: &mut [f64]) {
        match &self.factor {
            Made::Single(factor) => {
                let mut cast: Vec<f32> = Vec::with_capacity(sides.len());
                // Single precision has a small range: each right-hand side is scaled to one.
                let size = self.plan.unknowns;
                let scales: Vec<f64> = sides.chunks(size).map(largest).collect();
                for (side, scale) in sides.chunks(size).zip(&scales) {
                    cast.extend(side.iter().map(|value| (value / scale) as f32));
                }
                factor.solve(&mut cast);
                for ((side, cast), scale) in sides.chunks_mut(size).zip(cast.chunks(size)).zip(&scales) {
                    for (value, cast) in side.iter_mut().zip(cast) {
                        *value = scale * f64::from(*cast);
                    }
                }
            }
            Made::Double(factor) => factor.solve(sides),
        }
    }

    /// Solves for several right-hand sides, each with its residual computed.
    ///
    /// # Errors
    /// [`FlexError::NoConvergence`]; [`FlexError::Memory`] never, as the limit was for the factor at hand: a factor in double
    /// precision is made where single precision does not converge.
    pub fn solve(&mut self, sides: &[Vec<f64>]) -> Result<(Vec<Vec<f64>>, SolveReport), FlexError> {
        let mut solutions = Vec::with_capacity(sides.len());
        let (mut iterations, mut residual) = (0, 0.0f64);
        for block in sides.chunks(TOGETHER) {
            let (mut solved, mut steps, mut worst) = self.refine(block);
            if (worst.is_nan() || worst > ENOUGH) && matches!(self.factor, Made::Single(_)) {
                self.factor = Made::Double(Factor::new(&self.matrix, &self.plan)?);
                (solved, steps, worst) = self.refine(block);
            }
            // A stiff, slender body leaves rounding of the size of its condition.
            if worst.is_nan() || worst > 1e-8 {
                return Err(FlexError::NoConvergence {
                    what: "the solution of the static equations",
                    iterations: steps,
                    residual: worst,
                    needed: 1e-8,
                    hint: "the body is too slender or its materials too different for double precision",
                });
            }
            solutions.extend(solved);
            iterations = iterations.max(steps);
            residual = residual.max(worst);
        }
        let precision = match self.factor {
            Made::Single(_) => Precision::Single,
            Made::Double(_) => Precision::Double,
        };
        let report = SolveReport {
            unknowns: self.plan.unknowns,
            nonzeros: self.plan.nonzeros,
            factor_entries: self.plan.entries,
            factor_operations: self.plan.operations,
            bytes: self.plan.bytes(precision),
            precision,
            iterations,
            residual,
        };
        Ok((solutions, report))
    }

    /// Conjugate gradients with the factor as preconditioner, all right-hand sides in step.
    ///
    /// ```text
    /// z = (L L^T)^-1 r    b = r.z / (r.z of before)    p = z + b p    a = r.z / p.Kp    u += a p    r -= a Kp       (book, eq. 43.5)
    /// ```
    fn refine(&self, sides: &[Vec<f64>]) -> (Vec<Vec<f64>>, usize, f64) {
        let size = self.plan.unknowns;
        let count = sides.len();
        let mut u = vec![vec![0.0; size]; count];
        let mut r: Vec<Vec<f64>> = sides.to_vec();
        let mut p = vec![vec![0.0; size]; count];
        let mut before = vec![0.0; count];
        let wanted: Vec<f64> = sides.iter().map(|side| WANTED * norm(side)).collect();
        let mut steps = 0;
        for step in 1..=ITERATIONS {
            let open: Vec<usize> = (0..count).filter(|k| norm(&r[*k]) > wanted[*k]).collect();
            if open.is_empty() {
                break;
            }
            steps = step;
            let mut z = Vec::with_capacity(open.len() * size);
            open.iter().for_each(|k| z.extend_from_slice(&r[*k]));
            self.apply(&mut z);
            for (z, k) in z.chunks(size).zip(&open) {
                let k = *k;
                let now = dot(&r[k], z);
                let share = if before[k] == 0.0 { 0.0 } else { now / before[k] };
                before[k] = now;
                for (p, z) in p[k].iter_mut().zip(z) {
                    *p = z + share * *p;
                }
            }
            let along: Vec<&[f64]> = open.iter().map(|k| p[*k].as_slice()).collect();
            for (product, k) in self.matrix.multiply_all(&along).iter().zip(open) {
                let length = before[k] / dot(&p[k], product);
                add(&mut u[k], length, &p[k]);
                add(&mut r[k], -length, product);
            }
        }
        // The residual itself, not what the recurrence says of it.
        let mut worst = 0.0f64;
        for (product, side) in self.matrix.multiply_all(&u).iter().zip(sides) {
            let error: Vec<f64> = product.iter().zip(side).map(|(a, b)| a - b).collect();
            let scale = norm(side);
            if scale > 0.0 {
                worst = worst.max(norm(&error) / scale);
            }
        }
        (u, steps, worst)
    }
}

fn largest(side: &[f64]) -> f64 {
    let largest = side.iter().fold(0.0f64, |sum, value| sum.max(value.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}
