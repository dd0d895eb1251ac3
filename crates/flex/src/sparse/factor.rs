//! Sparse Cholesky factors, in single or double precision: with their numbers (`real`) the only user of faer.

use super::SymmetricMatrix;
use super::halves::Halves;
use super::real::Real;
use super::substitution::{Supernode, substitute};
use crate::FlexError;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::matmul::matmul;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky, supernodal::SymbolicSupernodalCholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Accum, Mat, Par, Side};
use serde::Serialize;
use std::sync::Arc;

/// Operations a second of a factor, over those of a product of two matrices: its blocks are smaller.
const OF_PRODUCT: f64 = 0.8;
/// Rows of the matrices of that product.
const ROWS: usize = 768;
/// Right-hand sides that go through a factor together: a few, and more than a few.
const NARROW: usize = 4;
const WIDEST: usize = 8;

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
    halves: Arc<Halves>,
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
        let factor = supernodal(&symbolic);
        let (operations, halves) = (operations(factor), Arc::new(halves(factor)));
        let entries = symbolic.len_val();
        Ok(FactorPlan {
            symbolic: Arc::new(symbolic),
            halves,
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

/// The supernodes that the plan asked for.
fn supernodal(symbolic: &SymbolicCholesky<u32>) -> &SymbolicSupernodalCholesky<u32> {
    let SymbolicCholeskyRaw::Supernodal(factor) = symbolic.raw() else {
        unreachable!("invariant: the plan asks for supernodes")
    };
    factor
}

/// The two halves of a factor, by the entries that are read.
fn halves(factor: &SymbolicSupernodalCholesky<u32>) -> Halves {
    let (end, starts) = (factor.supernode_end(), factor.col_ptr_for_val());
    let count = factor.n_supernodes();
    let work: Vec<f64> = (0..count).map(|node| f64::from(starts[node + 1] - starts[node])).collect();
    let above = |node: usize| {
        let row = *factor.supernode(node).pattern().iter().min()?;
        Some(end.partition_point(|end| *end <= row))
    };
    Halves::new(&(0..count).map(above).collect::<Vec<_>>(), &work)
}

/// Sum over the columns of the square of their length.
fn operations(factor: &SymbolicSupernodalCholesky<u32>) -> f64 {
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

/// `L` with `A = L L^T`.
#[derive(Debug, Clone)]
pub struct Factor<T> {
    symbolic: Arc<SymbolicCholesky<u32>>,
    halves: Arc<Halves>,
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
            Ok(()) => Ok(Factor { symbolic: symbolic.clone(), halves: plan.halves.clone(), values }),
            Err(LltError::NonPositivePivot { index }) => Err(FlexError::NotDefinite { unknown: index }),
        }
    }

    /// Solves `A x = b` for several right-hand sides one after the other in `sides`, in place.
    pub fn solve(&self, sides: &mut [T]) {
        let size = self.symbolic.nrows().max(1);
        for some in sides.chunks_mut(WIDEST * size) {
            if some.len() <= NARROW * size {
                self.solve_some::<NARROW>(some);
            } else {
                self.solve_some::<WIDEST>(some);
            }
        }
    }

    /// At most `WIDTH` right-hand sides, side by side.
    fn solve_some<const WIDTH: usize>(&self, sides: &mut [T]) {
        let size = self.symbolic.nrows();
        let mut x = vec![[T::from_double(0.0); WIDTH]; size];
        for (k, side) in sides.chunks(size).enumerate() {
            x.iter_mut().zip(side).for_each(|(x, value)| x[k] = *value);
        }
        let factor = supernodal(&self.symbolic);
        let (begin, end, starts) =
            (factor.supernode_begin(), factor.supernode_end(), factor.col_ptr_for_val());
        let supernode = |index: usize| Supernode {
            start: begin[index] as usize,
            columns: (end[index] - begin[index]) as usize,
            below: factor.supernode(index).pattern(),
            values: &self.values[starts[index] as usize..starts[index + 1] as usize],
        };
        substitute(&self.halves, &supernode, &mut x);
        for (k, side) in sides.chunks_mut(size).enumerate() {
            side.iter_mut().zip(&x).for_each(|(value, x)| *value = x[k]);
        }
    }
}

/// Pivots of `A = L D L^T` above this multiple of the largest diagonal entry leave too few digits to trust the sign of the small ones.
const MOST_GROWTH: f64 = 1e6;

/// How many eigenvalues of a matrix are below zero: as many as pivots of `A = L D L^T` (Sylvester's law of inertia). The plan is that of any matrix with the same
/// pattern. `None` where rounding may have changed a sign.
pub fn negative_eigenvalues(matrix: &SymmetricMatrix, plan: &FactorPlan) -> Option<usize> {
    let size = matrix.size();
    let (starts, rows) = (&matrix.pattern.starts, &matrix.pattern.rows);
    let pattern = SymbolicSparseColMatRef::new_checked(size, size, starts, None, rows);
    let symbolic = &plan.symbolic;
    let par = parallel();
    let mut memory = MemBuffer::new(symbolic.factorize_numeric_ldlt_scratch::<f64>(par, Default::default()));
    let mut values = vec![0.0f64; symbolic.len_val()];
    let outcome: Result<(), LdltError> = rayon::scope(|_| {
        symbolic
            .factorize_numeric_ldlt(
                &mut values,
                SparseColMatRef::new(pattern, &matrix.values),
                Side::Lower,
                LdltRegularization::default(),
                par,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map(|_| ())
    });
    outcome.ok()?;
    let factor = supernodal(symbolic);
    let (begin, end, starts) = (factor.supernode_begin(), factor.supernode_end(), factor.col_ptr_for_val());
    let (mut negative, mut largest) = (0, 0.0f64);
    for node in 0..factor.n_supernodes() {
        let columns = (end[node] - begin[node]) as usize;
        let tall = columns + factor.supernode(node).pattern().len();
        for column in 0..columns {
            let pivot = values[starts[node] as usize + column * (tall + 1)];
            if !pivot.is_finite() {
                return None;
            }
            negative += usize::from(pivot < 0.0);
            largest = largest.max(pivot.abs());
        }
    }
    let usual = matrix.diagonal().iter().fold(0.0f64, |most, value| most.max(value.abs()));
    (largest <= MOST_GROWTH * usual).then_some(negative)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::Pattern;

    /// Springs along a grid of `across` by `along` points, all of them held to the ground too.
    fn grid(across: usize, along: usize) -> SymmetricMatrix {
        let (mut pattern, mut values) = (Pattern { starts: vec![0], ..Pattern::default() }, Vec::new());
        for point in 0..across * along {
            pattern.rows.push(point as u32);
            values.push(4.5);
            let neighbours = [(point % across + 1 < across).then_some(point + 1), Some(point + across)];
            for other in neighbours.into_iter().flatten().filter(|other| *other < across * along) {
                pattern.rows.push(other as u32);
                values.push(-1.0);
            }
            pattern.starts.push(pattern.rows.len() as u32);
        }
        SymmetricMatrix { pattern: Arc::new(pattern), values }
    }

    /// Largest `|A x - b|` for `count` right-hand sides.
    fn residual<T: Real>(matrix: &SymmetricMatrix, count: usize) -> f64 {
        let plan = FactorPlan::new(matrix).expect("it is small");
        let factor = Factor::<T>::new(matrix, &plan).expect("it is definite");
        let size = matrix.size();
        let wanted: Vec<f64> = (0..count * size).map(|k| ((7 * k) % 11) as f64 - 5.0).collect();
        let mut sides: Vec<T> = wanted.iter().map(|value| T::from_double(*value)).collect();
        factor.solve(&mut sides);
        let found: Vec<Vec<f64>> =
            sides.chunks(size).map(|side| side.iter().map(|value| value.to_double()).collect()).collect();
        let products = matrix.multiply_all(&found).concat();
        products.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn any_number_of_right_hand_sides_is_solved_in_both_precisions() {
        // A band as wide as two panels and a rest, and one of single columns.
        for matrix in [grid(19, 40), grid(1, 30)] {
            for count in [1, 2, 4, 5, 8, 9, 17] {
                // Ten roundings of numbers up to 10.
                assert!(residual::<f64>(&matrix, count) < 1e-13, "{count}");
                assert!(residual::<f32>(&matrix, count) < 5e-5, "{count}");
            }
        }
    }

    #[test]
    fn pivots_below_zero_count_eigenvalues() {
        // Eigenvalues of the grid: 4.5 - 2 cos(pi i/(n + 1)) - 2 cos(pi j/(m + 1)).
        let (across, along) = (6, 9);
        let matrix = grid(across, along);
        let plan = FactorPlan::new(&matrix).expect("it is small");
        let cos = |k: usize, count: usize| 2.0 * (std::f64::consts::PI * k as f64 / (count + 1) as f64).cos();
        for shift in [0.1, 0.7, 1.9, 3.3, 4.6, 6.2, 9.0] {
            let mut shifted = matrix.clone();
            for column in 0..matrix.size() {
                shifted.values[matrix.pattern.starts[column] as usize] -= shift;
            }
            let below = (1..=across)
                .flat_map(|i| (1..=along).map(move |j| 4.5 - cos(i, across) - cos(j, along)))
                .filter(|value| *value < shift)
                .count();
            assert_eq!(negative_eigenvalues(&shifted, &plan), Some(below), "{shift}");
        }
    }

    #[test]
    fn a_factor_has_two_halves_that_do_not_know_each_other() {
        // Two grids beside one another, and a last point that springs tie to both.
        let half = grid(6, 30);
        let size = half.size() as u32;
        let (mut pattern, mut values) = (Pattern { starts: vec![0], ..Pattern::default() }, Vec::new());
        for copy in 0..2 {
            for column in 0..half.size() {
                let own = half.pattern.starts[column] as usize..half.pattern.starts[column + 1] as usize;
                pattern.rows.extend(half.pattern.rows[own.clone()].iter().map(|row| row + copy * size));
                values.extend_from_slice(&half.values[own]);
                if column + 1 == half.size() {
                    pattern.rows.push(2 * size);
                    values.push(-1.0);
                }
                pattern.starts.push(pattern.rows.len() as u32);
            }
        }
        pattern.rows.push(2 * size);
        values.push(4.5);
        pattern.starts.push(pattern.rows.len() as u32);
        let matrix = SymmetricMatrix { pattern: Arc::new(pattern), values };
        let plan = FactorPlan::new(&matrix).expect("it is small");
        let factor = supernodal(&plan.symbolic);
        let rows_of = |half: usize| {
            let nodes = plan.halves.halves[half].iter();
            let columns =
                nodes.flat_map(|node| factor.supernode_begin()[*node]..factor.supernode_end()[*node]);
            columns.collect::<Vec<_>>()
        };
        let [own, other] = [0, 1].map(rows_of);
        assert!(!own.is_empty() && !other.is_empty());
        for node in &plan.halves.halves[0] {
            assert!(factor.supernode(*node).pattern().iter().all(|row| !other.contains(row)));
        }
        assert!(residual::<f64>(&matrix, 3) < 1e-13);
    }
}
