//! Sparse Cholesky factors, in single or double precision: the only user of faer.

use super::SymmetricMatrix;
use crate::FlexError;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::matmul::matmul;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::traits::RealField;
use faer::{Accum, Conj, Mat, MatMut, Par, Side};
use serde::Serialize;
use std::sync::Arc;

/// Operations a second of a factor, over those of a product of two matrices: its blocks are smaller.
const OF_PRODUCT: f64 = 0.8;
/// Rows of the matrices of that product.
const ROWS: usize = 768;

/// Degree of parallelism that is asked for: bits depend on it, not on the number of threads.
#[cfg(not(target_arch = "wasm32"))]
fn parallel() -> Par {
    Par::rayon(2)
}

/// Within a browser there is one thread.
#[cfg(target_arch = "wasm32")]
fn parallel() -> Par {
    Par::Seq
}

/// How many digits a factor carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Precision {
    /// 24 bits: half the memory, for iterative refinement.
    Single,
    /// 53 bits.
    Double,
}

/// What a factor will cost, known before it is made.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SolveEstimate {
    /// Unknowns.
    pub unknowns: usize,
    /// Entries of the lower triangle of the matrix.
    pub nonzeros: usize,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Floating-point operations of the factor.
    pub operations: f64,
    /// Bytes of matrix and factor.
    pub bytes: u64,
    /// Precision of the factor.
    pub precision: Precision,
}

impl SolveEstimate {
    /// Time that the factor will take where a product of matrices makes so many operations a second [s]; [`make_product`] is what to time for it.
    pub fn seconds(&self, product_rate: f64) -> f64 {
        self.operations / (OF_PRODUCT * product_rate)
    }
}

/// What a factor will cost.
#[derive(Debug, Clone)]
pub struct FactorPlan {
    symbolic: Arc<SymbolicCholesky<u32>>,
    /// Unknowns.
    pub unknowns: usize,
    /// Entries of the lower triangle of the matrix.
    pub nonzeros: usize,
    /// Entries of the factor.
    pub entries: usize,
    /// Floating-point operations of the factor.
    pub operations: f64,
}

impl FactorPlan {
    /// Where the factor of a matrix has entries, unknowns eliminated in their order.
    ///
    /// # Errors
    /// [`FlexError::TooLarge`] where they cannot be numbered.
    pub fn new(matrix: &SymmetricMatrix) -> Result<FactorPlan, FlexError> {
        let size = matrix.size();
        let (starts, rows) = (&matrix.pattern.starts, &matrix.pattern.rows);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        // faer 0.24 takes `Identity` to mean that the upper triangle is given, whatever side it is told.
        let identity: Vec<u32> = (0..size as u32).collect();
        let symbolic = factorize_symbolic_cholesky(
            SymbolicSparseColMatRef::new_checked(size, size, starts, None, rows),
            Side::Lower,
            SymmetricOrdering::Custom(PermRef::new_checked(&identity, &identity, size)),
            params,
        )
        .map_err(|_| FlexError::TooLarge { unknowns: size })?;
        let operations = operations(&symbolic);
        let entries = symbolic.len_val();
        Ok(FactorPlan {
            symbolic: Arc::new(symbolic),
            unknowns: size,
            nonzeros: rows.len(),
            entries,
            operations,
        })
    }

    /// Bytes of the matrix and its factor.
    pub fn bytes(&self, precision: Precision) -> u64 {
        let number = match precision {
            Precision::Single => 4,
            Precision::Double => 8,
        };
        // The factor, the values cast to its precision, and the matrix with its row numbers, once with all unknowns and once without those held.
        (self.entries * number + self.nonzeros * (number + 24)) as u64
    }

    /// What it will cost in this precision.
    pub fn estimate(&self, precision: Precision) -> SolveEstimate {
        SolveEstimate {
            unknowns: self.unknowns,
            nonzeros: self.nonzeros,
            factor_entries: self.entries,
            operations: self.operations,
            bytes: self.bytes(precision),
            precision,
        }
    }

    /// Refuses a factor above this many bytes.
    ///
    /// # Errors
    /// [`FlexError::Memory`].
    pub fn check(&self, precision: Precision, allowed: u64) -> Result<(), FlexError> {
        let needed = self.bytes(precision);
        if needed <= allowed {
            return Ok(());
        }
        Err(FlexError::Memory { unknowns: self.unknowns, entries: self.entries, needed, allowed })
    }
}

/// Makes a product of two matrices with as many threads as a factor, some milliseconds of work, and returns its operations: whoever times it
/// knows what a factor will take. The first one also wakes the threads.
pub fn make_product(precision: Precision) -> f64 {
    match precision {
        Precision::Single => product::<f32>(),
        Precision::Double => product::<f64>(),
    }
}

fn product<T: Real>() -> f64 {
    let one = Mat::<T>::from_fn(ROWS, ROWS, |row, column| T::from_double(1.0 / (1 + row + column) as f64));
    let mut product = Mat::<T>::zeros(ROWS, ROWS);
    rayon::scope(|_| matmul(&mut product, Accum::Replace, &one, &one, T::from_double(1.0), parallel()));
    std::hint::black_box(product);
    2.0 * (ROWS as f64).powi(3)
}

/// Sum over the columns of the square of their length.
fn operations(symbolic: &SymbolicCholesky<u32>) -> f64 {
    let SymbolicCholeskyRaw::Supernodal(factor) = symbolic.raw() else { return f64::NAN };
    let (begin, end) = (factor.supernode_begin(), factor.supernode_end());
    (0..factor.n_supernodes())
        .map(|node| {
            let (columns, below) =
                (f64::from(end[node] - begin[node]), factor.supernode(node).pattern().len());
            let tall = columns + below as f64;
            // Sum of (tall - k)^2 for k from 0 to columns - 1.
            columns * tall * tall - tall * columns * (columns - 1.0)
                + (columns - 1.0) * columns * (2.0 * columns - 1.0) / 6.0
        })
        .sum()
}

/// Numbers that a factor may be made of.
pub trait Real: RealField + Copy + Send + Sync {
    /// The nearest one.
    fn from_double(value: f64) -> Self;
    /// The same in double precision.
    fn to_double(self) -> f64;
}

impl Real for f64 {
    fn from_double(value: f64) -> f64 {
        value
    }
    fn to_double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    fn from_double(value: f64) -> f32 {
        value as f32
    }
    fn to_double(self) -> f64 {
        f64::from(self)
    }
}

/// `L` with `A = L L^T`.
#[derive(Debug, Clone)]
pub struct Factor<T> {
    symbolic: Arc<SymbolicCholesky<u32>>,
    values: Vec<T>,
}

impl<T: Real> Factor<T> {
    /// The factor of a matrix by its plan.
    ///
    /// # Errors
    /// [`FlexError::NotDefinite`].
    pub fn new(matrix: &SymmetricMatrix, plan: &FactorPlan) -> Result<Factor<T>, FlexError> {
        let size = matrix.size();
        let cast: Vec<T> = matrix.values.iter().map(|value| T::from_double(*value)).collect();
        let (starts, rows) = (&matrix.pattern.starts, &matrix.pattern.rows);
        let pattern = SymbolicSparseColMatRef::new_checked(size, size, starts, None, rows);
        let symbolic = &plan.symbolic;
        let par = parallel();
        let mut memory = MemBuffer::new(symbolic.factorize_numeric_llt_scratch::<T>(par, Default::default()));
        let mut values = vec![T::from_double(0.0); symbolic.len_val()];
        // On a thread of the pool: from outside, each of its many products would be handed over and waited for.
        let outcome = rayon::scope(|_| {
            symbolic
                .factorize_numeric_llt(
                    &mut values,
                    SparseColMatRef::new(pattern, &cast),
                    Side::Lower,
                    Default::default(),
                    par,
                    MemStack::new(&mut memory),
                    Default::default(),
                )
                .map(|_| ())
        });
        match outcome {
            Ok(()) => Ok(Factor { symbolic: symbolic.clone(), values }),
            Err(LltError::NonPositivePivot { index }) => Err(FlexError::NotDefinite { unknown: index }),
        }
    }

    /// Solves `A x = b` for several right-hand sides one after the other in `sides`, in place.
    pub fn solve(&self, sides: &mut [T]) {
        let size = self.symbolic.nrows();
        let columns = sides.len() / size.max(1);
        let par = if columns > 1 { parallel() } else { Par::Seq };
        let mut memory = MemBuffer::new(self.symbolic.solve_in_place_scratch::<T>(columns, par));
        let right = MatMut::from_column_major_slice_mut(sides, size, columns);
        let factor = LltRef::new(&self.symbolic, &self.values);
        let solve = || factor.solve_in_place_with_conj(Conj::No, right, par, MemStack::new(&mut memory));
        match par {
            Par::Seq => solve(),
            // On a thread of the pool, as in `new`.
            _ => rayon::scope(|_| solve()),
        }
    }
}
