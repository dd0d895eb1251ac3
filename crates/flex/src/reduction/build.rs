//! From a mesh to its reduced model.

use super::interface::Interface;
use super::model::ReducedModel;
use crate::FlexError;
use crate::mesh::Mesh;
use crate::modes::{Pairs, lanczos};
use crate::sparse::{
    Factor, FactorPlan, Precision, Quantity, SolveEstimate, Structure, SymmetricMatrix, dot,
};
use serde::Serialize;

/// Right-hand sides that go through the factor together.
const TOGETHER: usize = 8;
/// Residual that a constraint mode may leave.
const RESIDUAL: f64 = 1e-9;

/// How to reduce.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ReductionOptions {
    /// Modes with all reference points fixed.
    pub modes: usize,
    /// Bytes that matrix and factor may take.
    pub memory: u64,
}

impl Default for ReductionOptions {
    fn default() -> ReductionOptions {
        ReductionOptions { modes: 20, memory: 8 << 30 }
    }
}

/// A reduced model with the displacements of its coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// The model.
    pub model: ReducedModel,
    /// Displacements of all nodes for a unit of each coordinate.
    pub basis: Vec<Vec<[f64; 3]>>,
    /// Largest residual of a constraint mode, forces on the free nodes over the largest force.
    pub residual: f64,
}

impl Reduction {
    /// Displacements of all nodes for values of the coordinates.
    pub fn displacements(&self, coordinates: &[f64]) -> Vec<[f64; 3]> {
        let mut sum = vec![[0.0; 3]; self.basis.first().map_or(0, Vec::len)];
        for (vector, q) in self.basis.iter().zip(coordinates).filter(|(_, q)| **q != 0.0) {
            for (sum, u) in sum.iter_mut().zip(vector) {
                for axis in 0..3 {
                    sum[axis] += q * u[axis];
                }
            }
        }
        sum
    }
}

/// Reduces a mesh to its interfaces and fixed-interface modes.
///
/// # Errors
/// As [`Mesh::check`]; [`FlexError::Memory`], [`FlexError::NotDefinite`], [`FlexError::NoConvergence`]; [`FlexError::Number`] without
/// interfaces or with more modes than unknowns.
pub fn reduce(
    mesh: &Mesh,
    interfaces: &[Interface],
    options: ReductionOptions,
) -> Result<Reduction, FlexError> {
    reduce_watched(mesh, interfaces, options, &|_| {})
}

/// The same; `watch` sees what the factor will cost before it is made.
///
/// # Errors
/// As [`reduce`].
pub fn reduce_watched(
    mesh: &Mesh,
    interfaces: &[Interface],
    options: ReductionOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Reduction, FlexError> {
    mesh.check()?;
    let structure = Structure::new(mesh, &[]);
    let stiffness = structure.assemble(mesh, Quantity::Stiffness, &[]);
    let mass = structure.assemble(mesh, Quantity::Mass, &[]);
    let mut free = vec![true; stiffness.size()];
    for node in interfaces.iter().flat_map(|interface| &interface.nodes) {
        for axis in 0..3 {
            free[structure.unknown(*node, axis)] = false;
        }
    }
    let inner = free.iter().filter(|free| **free).count();
    if interfaces.is_empty() || options.modes + 4 > inner {
        let (quantity, got) = if interfaces.is_empty() {
            ("the number of interfaces", 0.0)
        } else {
            ("the number of modes", options.modes as f64)
        };
        return Err(FlexError::Number {
            quantity: quantity.to_owned(),
            needed: format!("above zero and, of modes, at most {}", inner.saturating_sub(4)),
            got,
            hint: "name the surfaces that follow reference points, or ask for fewer modes",
        });
    }
    let inner_stiffness = stiffness.restricted(&free);
    let plan = FactorPlan::new(&inner_stiffness)?;
    watch(&plan.estimate(Precision::Double));
    plan.check(Precision::Double, options.memory)?;
    let factor = Factor::<f64>::new(&inner_stiffness, &plan)?;
    let parts = Parts { structure: &structure, stiffness: &stiffness, free: &free };
    let (mut vectors, residual) = parts.constraint_modes(mesh, interfaces, &factor)?;
    let boundary = vectors.len();
    let mut frequencies = Vec::new();
    if options.modes > 0 {
        let inner_mass = mass.restricted(&free);
        let Pairs { found, .. } = lanczos(&factor, &inner_stiffness, &inner_mass, options.modes, 0.0)?;
        for (value, vector, _) in found {
            frequencies.push(value.max(0.0).sqrt() / std::f64::consts::TAU);
            vectors.push(parts.full(&vector, &vec![0.0; stiffness.size()]));
        }
    }
    let model = project(mesh, interfaces, &structure, [&stiffness, &mass], &vectors, boundary, frequencies);
    let basis = vectors.iter().map(|vector| structure.scatter(vector)).collect();
    Ok(Reduction { model, basis, residual })
}

struct Parts<'a> {
    structure: &'a Structure,
    stiffness: &'a SymmetricMatrix,
    free: &'a [bool],
}

impl Parts<'_> {
    /// Values of the free unknowns put into all of them.
    fn full(&self, inner: &[f64], rest: &[f64]) -> Vec<f64> {
        let mut values = inner.iter();
        let of = |(free, rest): (&bool, &f64)| {
            if *free { values.next().copied().unwrap_or_default() } else { *rest }
        };
        self.free.iter().zip(rest).map(of).collect()
    }

    fn inner(&self, full: &[f64]) -> Vec<f64> {
        self.free.iter().zip(full).filter(|(free, _)| **free).map(|(_, value)| *value).collect()
    }

    /// Static displacements for a unit of each coordinate of each interface, the others held.
    fn constraint_modes(
        &self,
        mesh: &Mesh,
        interfaces: &[Interface],
        factor: &Factor<f64>,
    ) -> Result<(Vec<Vec<f64>>, f64), FlexError> {
        let size = self.stiffness.size();
        let mut given: Vec<Vec<f64>> = Vec::with_capacity(6 * interfaces.len());
        for interface in interfaces {
            for axis in 0..6 {
                let mut vector = vec![0.0; size];
                for node in &interface.nodes {
                    let u = interface.motion(axis, mesh.nodes[*node as usize]);
                    for (k, u) in u.iter().enumerate() {
                        vector[self.structure.unknown(*node, k)] = *u;
                    }
                }
                given.push(vector);
            }
        }
        let mut vectors = given.clone();
        let mut worst = 0.0f64;
        let mut force = vec![0.0; size];
        for block in 0..vectors.len().div_ceil(TOGETHER) {
            let range = TOGETHER * block..(TOGETHER * (block + 1)).min(vectors.len());
            // Solved, and once more for what is left.
            for _ in 0..2 {
                let mut sides = Vec::new();
                for vector in &vectors[range.clone()] {
                    self.stiffness.multiply(vector, &mut force);
                    sides.extend(self.inner(&force));
                }
                factor.solve(&mut sides);
                let inner = sides.len() / range.len();
                for (vector, side) in vectors[range.clone()].iter_mut().zip(sides.chunks(inner)) {
                    let correction = self.full(side, &vec![0.0; size]);
                    for (value, correction) in vector.iter_mut().zip(correction) {
                        *value -= correction;
                    }
                }
            }
            for vector in &vectors[range] {
                self.stiffness.multiply(vector, &mut force);
                let largest = force.iter().fold(0.0f64, |most, f| most.max(f.abs()));
                let rest = self.inner(&force).iter().fold(0.0f64, |most, f| most.max(f.abs()));
                worst = worst.max(rest / largest);
            }
        }
        if worst.is_nan() || worst > RESIDUAL {
            return Err(FlexError::NoConvergence {
                what: "the constraint modes",
                iterations: 2,
                residual: worst,
                needed: RESIDUAL,
                hint: "the body is too slender for double precision",
            });
        }
        Ok((vectors, worst))
    }
}

/// Matrices of the coordinates.
pub(crate) fn project(
    mesh: &Mesh,
    interfaces: &[Interface],
    structure: &Structure,
    [stiffness, mass]: [&SymmetricMatrix; 2],
    vectors: &[Vec<f64>],
    boundary: usize,
    frequencies: Vec<f64>,
) -> ReducedModel {
    let size = vectors.len();
    let full = stiffness.size();
    let turned = |vector: &[f64]| {
        // S u = e_z x u.
        let field: Vec<[f64; 3]> = structure.scatter(vector).iter().map(|[u, v, _]| [-v, *u, 0.0]).collect();
        structure.gather(&field)
    };
    let spun: Vec<Vec<f64>> = vectors.iter().map(|vector| turned(vector)).collect();
    let mut k = vec![0.0; size * size];
    let mut m = vec![0.0; size * size];
    let mut g = vec![0.0; size * size];
    let mut n = vec![0.0; size * size];
    // Modes hang together with nothing in the stiffness.
    for (column, image) in stiffness.multiply_all(&vectors[..boundary]).iter().enumerate() {
        for row in 0..=column {
            let value = dot(&vectors[row], image);
            (k[row * size + column], k[column * size + row]) = (value, value);
        }
    }
    for (column, image) in mass.multiply_all(vectors).iter().enumerate() {
        for row in 0..=column {
            let value = dot(&vectors[row], image);
            (m[row * size + column], m[column * size + row]) = (value, value);
        }
    }
    for (column, image) in mass.multiply_all(&spun).iter().enumerate() {
        for row in 0..size {
            g[row * size + column] = dot(&vectors[row], image);
            if row <= column {
                let value = dot(&spun[row], image);
                (n[row * size + column], n[column * size + row]) = (value, value);
            }
        }
    }
    for (mode, frequency) in frequencies.iter().enumerate() {
        k[(boundary + mode) * (size + 1)] = (std::f64::consts::TAU * frequency).powi(2);
    }
    let against = |field: Vec<[f64; 3]>| -> Vec<f64> {
        let mut image = vec![0.0; full];
        mass.multiply(&structure.gather(&field), &mut image);
        vectors.iter().map(|vector| dot(vector, &image)).collect()
    };
    let mut carried = vec![0.0; full];
    for (node, force) in mesh.weights.iter().flat_map(|weight| &weight.forces) {
        for axis in 0..3 {
            carried[structure.unknown(*node, axis)] += force[axis];
        }
    }
    let mut centrifugal_load = against(mesh.nodes.iter().map(|[x, y, _]| [*x, *y, 0.0]).collect());
    for (load, vector) in centrifugal_load.iter_mut().zip(vectors) {
        *load += dot(vector, &carried);
    }
    ReducedModel {
        points: interfaces.iter().map(|interface| (interface.name.clone(), interface.point)).collect(),
        frequencies,
        stiffness: k,
        mass: m,
        gyroscopic: g,
        centrifugal: n,
        centrifugal_load,
        euler_load: against(mesh.nodes.iter().map(|[x, y, _]| [-y, *x, 0.0]).collect()),
    }
}
