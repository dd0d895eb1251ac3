//! Natural modes by shift-and-invert block Lanczos in the inner product of the mass.
//!
//! ```text
//! K x = l M x        (K + s M)^-1 M x = x/(l + s)        x^T M x = 1        f = sqrt(l)/2 pi                 (book, eq. 43.8)
//! ```
//! With `s > 0` a free body's matrix has a Cholesky factor, and its six rigid motions come out with `l = 0`.

use crate::FlexError;
use crate::case::StaticCase;
use crate::eigen::symmetric_eigen;
use crate::mesh::Mesh;
use crate::sparse::{
    Factor, FactorPlan, Precision, Quantity, SolveEstimate, Structure, SymmetricMatrix, add, dot,
    negative_eigenvalues, norm,
};
use crate::statics::SolveOptions;
use serde::Serialize;
use std::ops::Range;

/// Vectors that go through the factor together: clusters of no more modes are found at once.
const BLOCK: usize = 4;
/// Slices along z in which the kinds of motion are told apart.
const SLICES: usize = 24;
/// A mode whose eigenvalue is a smaller share of the shift is a motion of the rigid body.
const RIGID: f64 = 1e-5;
/// Residual of a mode that is accepted, where rounding lets it become so small.
const WANTED: f64 = 1e-8;
/// What rounding of a mode's shape and of `K x` leaves, over the size of the products that `K x` is summed from.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Share of a vector that its block leaves of it, below which it is taken from the whole basis anew.
const SHRUNK: f64 = 0.1;
/// Share of a vector beside the basis that is rounding.
const NOTHING: f64 = 1e-13;
/// Rows of vectors that are worked on together.
const PIECE: usize = 1024;

/// What mainly moves in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ModeKind {
    /// The body as a whole.
    Rigid,
    /// Slices along x.
    BendingX,
    /// Slices along y.
    BendingY,
    /// Slices turn about the z axis.
    Torsion,
    /// Motion along z.
    Axial,
    /// Nothing has half the kinetic energy.
    Mixed,
}

/// A natural mode.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Mode {
    /// Natural frequency [Hz].
    pub frequency: f64,
    /// What mainly moves.
    pub kind: ModeKind,
    /// Shares of the kinetic energy: slices that move along x or tilt with it, the same along y, turning about z, moving along z; the rest deforms slices.
    pub shares: [f64; 4],
    /// `|K x - l M x|/|K x|`; of a rigid motion, whose `K x` is rounding, over `s |M x|`. No more than 1e-8, or than what rounding leaves: thin
    /// elements have a `K` of large numbers that cancel.
    pub residual: f64,
    /// Displacements of the nodes, of modal mass 1 kg.
    pub shape: Vec<[f64; 3]>,
}

/// Modes of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ModeSolution {
    /// Modes, the lowest first.
    pub modes: Vec<Mode>,
    /// The shift `s` [1/s^2].
    pub shift: f64,
    /// Vectors of the Lanczos basis.
    pub basis: usize,
    /// Unknowns.
    pub unknowns: usize,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Floating-point operations of the factor.
    pub factor_operations: f64,
    /// Whether the mass is that of CalculiX, integrated with the rule of the stiffness.
    pub coarse_mass: bool,
    /// With modes counted: how many there are.
    pub count: Option<ModeCount>,
}

/// How many modes a body has, by the signs of a factor of `K - s M` (Sylvester's law of inertia).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ModeCount {
    /// Below this frequency [Hz]: in a gap between modes, above the highest one where there is one.
    pub below: f64,
    /// Modes there, rigid motions included; `None` where rounding leaves the count in doubt.
    pub counted: Option<usize>,
    /// Modes found there, rigid motions included.
    pub found: usize,
}

impl ModeCount {
    /// How many modes are missing; `None` where that is not known.
    pub fn missing(&self) -> Option<usize> {
        self.counted.map(|counted| counted.saturating_sub(self.found))
    }
}

/// The lowest modes of a mesh with the supports of a case, whose loads do not count; of a case without supports the rigid motions come
/// first.
///
/// # Errors
/// As [`Mesh::check`]; [`FlexError::Memory`], [`FlexError::NotDefinite`], [`FlexError::NoConvergence`], and
/// [`FlexError::Number`] where the mesh has fewer modes.
pub fn modes(
    mesh: &Mesh,
    case: &StaticCase,
    count: usize,
    options: SolveOptions,
) -> Result<ModeSolution, FlexError> {
    modes_watched(mesh, case, count, options, &|_| {})
}

/// The same; `watch` sees what the factor will cost before it is made.
///
/// # Errors
/// As [`modes`].
pub fn modes_watched(
    mesh: &Mesh,
    case: &StaticCase,
    count: usize,
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<ModeSolution, FlexError> {
    mesh.check()?;
    if let Some(material) = mesh.materials.iter().find(|material| material.density <= 0.0) {
        let (quantity, needed) = ("density [kg/m^3]", "above zero");
        return Err(FlexError::Material {
            material: material.name.clone(),
            quantity,
            needed,
            got: material.density,
        });
    }
    let free = StaticCase { inertia_relief: true, ..case.clone() };
    free.check(mesh)?;
    let terms = case.terms();
    let structure = Structure::new(mesh, &terms);
    let mut kept = vec![true; 3 * mesh.nodes.len()];
    for fixed in &case.fixed {
        kept[structure.unknown(fixed.node, fixed.axis as usize)] = false;
    }
    let stiffness = structure.assemble(mesh, Quantity::Stiffness, &terms).restricted(&kept);
    let quantity = if options.coarse_mass { Quantity::CoarseMass } else { Quantity::Mass };
    let mass = structure.assemble(mesh, quantity, &[]).restricted(&kept);
    if count == 0 || count + BLOCK > stiffness.size() {
        return Err(FlexError::Number {
            quantity: "the number of modes".to_owned(),
            needed: format!("from 1 to {}", stiffness.size().saturating_sub(BLOCK)),
            got: count as f64,
            hint: "ask for fewer modes, or refine the mesh",
        });
    }
    let shift = shift(mesh);
    let shifted = stiffness.plus(shift, &mass);
    let plan = FactorPlan::new(&shifted)?;
    watch(&plan.estimate(Precision::Double));
    plan.check(Precision::Double, options.memory)?;
    let factor = Factor::<f64>::new(&shifted, &plan)?;
    drop(shifted);
    // One more where they are counted, to know the gap above the highest.
    let more = usize::from(options.count_modes && count + 1 + BLOCK <= stiffness.size());
    let mut pairs = lanczos(&factor, &stiffness, &mass, count + more, shift)?;
    drop(factor);
    let basis = pairs.basis;
    let count_of = |values: &[f64]| counted(&stiffness, &mass, &plan, values, shift);
    let values: Vec<f64> = pairs.found.iter().map(|(value, ..)| *value).collect();
    let modes_counted = options.count_modes.then(|| count_of(&values)).flatten();
    pairs.found.truncate(count);
    let place = |(value, vector, residual): (f64, Vec<f64>, f64)| {
        let mut full = vec![0.0; kept.len()];
        let mut values = vector.into_iter();
        for (full, _) in full.iter_mut().zip(&kept).filter(|(_, kept)| **kept) {
            *full = values.next().unwrap_or_default();
        }
        let shape = structure.scatter(&full);
        let shares = shares(mesh, &shape);
        let kind = if value.abs() < RIGID * shift { ModeKind::Rigid } else { kind(shares) };
        Mode { frequency: value.max(0.0).sqrt() / std::f64::consts::TAU, kind, shares, residual, shape }
    };
    Ok(ModeSolution {
        modes: pairs.found.into_iter().map(place).collect(),
        shift,
        basis,
        unknowns: plan.unknowns,
        factor_entries: plan.entries,
        factor_operations: plan.operations,
        coarse_mass: options.coarse_mass,
        count: modes_counted,
    })
}

/// Share of a value above it that parts it from the next one.
const GAP: f64 = 1e-5;

/// Counts the modes below the highest gap between these values.
fn counted(
    stiffness: &SymmetricMatrix,
    mass: &SymmetricMatrix,
    plan: &FactorPlan,
    values: &[f64],
    shift: f64,
) -> Option<ModeCount> {
    let is_gap = |k: &usize| values[*k] > RIGID * shift && values[*k] > (1.0 + GAP) * values[*k - 1].max(0.0);
    let found = (1..values.len()).rev().find(is_gap)?;
    let middle = (values[found - 1].max(0.0) + values[found]) / 2.0;
    let counted = negative_eigenvalues(&stiffness.plus(-middle, mass), plan);
    Some(ModeCount { below: middle.sqrt() / std::f64::consts::TAU, counted, found })
}

/// One hundredth of `E/(rho L^2)`, with the length of the body: some way below the first mode of a stout one.
fn shift(mesh: &Mesh) -> f64 {
    let extent = |axis: usize| {
        let (low, high) = mesh.nodes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), node| {
            (low.min(node[axis]), high.max(node[axis]))
        });
        high - low
    };
    let length = extent(0).hypot(extent(1)).hypot(extent(2));
    let waves = mesh.materials.iter().map(|material| material.youngs_modulus / material.density);
    0.01 * waves.fold(0.0, f64::max) / (length * length)
}

/// Modes found.
pub(crate) struct Pairs {
    pub found: Vec<(f64, Vec<f64>, f64)>,
    pub basis: usize,
}

/// Vectors of the basis `q`, and `M q`.
struct Basis<'a> {
    mass: &'a SymmetricMatrix,
    /// Root of a usual diagonal entry of the mass.
    usual: f64,
    q: Vec<Vec<f64>>,
    mq: Vec<Vec<f64>>,
}

impl Basis<'_> {
    /// Takes the parts along the basis from `first` on from vectors, twice; their sizes, vector by vector.
    fn orthogonalise(&self, first: usize, vectors: &mut [Vec<f64>]) -> Vec<Vec<f64>> {
        let size = self.mass.size();
        let mut parts = vec![vec![0.0; self.q.len() - first]; vectors.len()];
        for _ in 0..2 {
            let mut now = vec![vec![0.0; self.q.len() - first]; vectors.len()];
            // Each piece of the basis is read once for all vectors.
            for rows in pieces(size) {
                for (k, mq) in self.mq[first..].iter().enumerate() {
                    for (now, w) in now.iter_mut().zip(vectors.iter()) {
                        now[k] += dot(&mq[rows.clone()], &w[rows.clone()]);
                    }
                }
            }
            for rows in pieces(size) {
                for (k, q) in self.q[first..].iter().enumerate() {
                    for (now, w) in now.iter().zip(vectors.iter_mut()) {
                        add(&mut w[rows.clone()], -now[k], &q[rows.clone()]);
                    }
                }
            }
            for (parts, now) in parts.iter_mut().zip(now) {
                add(parts, 1.0, &now);
            }
        }
        parts
    }

    /// Adds what vectors have beside the basis, as long as it has not `most`: one that has nothing left, against its size before, is not
    /// added. The parts of each along the basis, those of the block before it included.
    fn extend(&mut self, mut vectors: Vec<Vec<f64>>, most: usize) -> Vec<Vec<f64>> {
        let before: Vec<f64> = vectors.iter().map(|w| norm(w)).collect();
        let first = self.q.len();
        let mut parts = self.orthogonalise(0, &mut vectors);
        for ((w, parts), before) in vectors.into_iter().zip(&mut parts).zip(before) {
            // Beside one another too; what that takes nearly all of is taken from the whole basis anew.
            let mut own = [w];
            let left = norm(&own[0]);
            parts.extend(self.orthogonalise(first, &mut own).remove(0));
            if norm(&own[0]) < SHRUNK * left {
                let more = self.orthogonalise(0, &mut own).remove(0);
                add(parts, 1.0, &more);
            }
            let [w] = own;
            if self.q.len() < most {
                self.push(w, before);
            }
        }
        parts
    }

    /// Adds a vector that is orthogonal to the basis; one that has nothing left is not added.
    fn push(&mut self, mut w: Vec<f64>, before: f64) {
        let mut mw = vec![0.0; w.len()];
        self.mass.multiply(&w, &mut mw);
        let length = dot(&w, &mw).max(0.0).sqrt();
        if length <= NOTHING * before * self.usual {
            return;
        }
        for value in w.iter_mut().chain(mw.iter_mut()) {
            *value /= length;
        }
        self.q.push(w);
        self.mq.push(mw);
    }

    /// Combinations of the basis.
    fn combined<'a>(&self, shares: impl Iterator<Item = &'a [f64]> + Clone) -> Vec<Vec<f64>> {
        let size = self.mass.size();
        let mut sums: Vec<Vec<f64>> = shares.clone().map(|_| vec![0.0; size]).collect();
        for rows in pieces(size) {
            for (sum, shares) in sums.iter_mut().zip(shares.clone()) {
                for (q, share) in self.q.iter().zip(shares) {
                    add(&mut sum[rows.clone()], *share, &q[rows.clone()]);
                }
            }
        }
        sums
    }
}

/// Pieces of vectors that stay in the fast memory of a processor.
fn pieces(size: usize) -> impl Iterator<Item = Range<usize>> {
    (0..size).step_by(PIECE).map(move |start| start..(start + PIECE).min(size))
}

/// The lowest modes by the factor of `K + s M`: value, vector of modal mass 1, residual.
pub(crate) fn lanczos(
    factor: &Factor<f64>,
    stiffness: &SymmetricMatrix,
    mass: &SymmetricMatrix,
    count: usize,
    shift: f64,
) -> Result<Pairs, FlexError> {
    let size = mass.size();
    let most = (4 * count + 100).min(size);
    let usual = (mass.diagonal().iter().sum::<f64>() / size as f64).sqrt();
    let mut basis = Basis { mass, usual, q: Vec::new(), mq: Vec::new() };
    let mut random = 0x9E37_79B9_7F4A_7C15u64;
    let mut draw = || {
        // Steele, Lea and Flood's SplitMix64: a start that is the same on every machine.
        random = random.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = random;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64 - 0.5
    };
    let starts = (0..BLOCK.min(size)).map(|_| (0..size).map(|_| draw()).collect()).collect();
    basis.extend(starts, most);
    // The projected operator, column after column.
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut best = f64::INFINITY;
    while columns.len() < basis.q.len() {
        let first = columns.len();
        let block = basis.q.len() - first;
        let mut sides: Vec<f64> = basis.mq[first..].concat();
        factor.solve(&mut sides);
        columns.extend(basis.extend(sides.chunks(size).map(<[f64]>::to_vec).collect(), most));
        let done = columns.len();
        let exhausted = done == basis.q.len();
        if done < count + BLOCK && !exhausted {
            continue;
        }
        let mut projected = vec![0.0; done * done];
        for (k, parts) in columns.iter().enumerate() {
            for (j, part) in parts.iter().enumerate().take(k + 1) {
                projected[j * done + k] = *part;
                projected[k * done + j] = *part;
            }
        }
        let (_, vectors) = symmetric_eigen(&projected, done);
        // What leaves the space: the tail of a Ritz vector in the last block.
        let tail = |k: usize| {
            let vector = &vectors[(done - 1 - k) * done..(done - k) * done];
            vector[done - block..].iter().map(|x| x * x).sum::<f64>().sqrt()
        };
        let wanted = count.min(done);
        let worst = (0..wanted).map(tail).fold(0.0, f64::max);
        if worst > 1e-7 && !exhausted {
            continue;
        }
        let mut found = Vec::with_capacity(wanted);
        // The residual over what is accepted of it.
        let mut over = 0.0f64;
        let shapes = basis.combined(vectors.chunks(done).rev().take(wanted));
        for some in shapes.chunks(BLOCK) {
            let (stiff, massive) = (stiffness.multiply_all(some), mass.multiply_all(some));
            for ((x, kx), mx) in some.iter().zip(&stiff).zip(&massive) {
                let (mode, least) = checked(stiffness, x, kx, mx, shift);
                over = over.max(mode.2 / WANTED.max(least));
                found.push(mode);
            }
        }
        best = best.min(over);
        if best <= 1.0 || exhausted {
            if best > 1.0 {
                break;
            }
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            return Ok(Pairs { found, basis: done });
        }
    }
    Err(FlexError::NoConvergence {
        what: "the natural modes",
        iterations: columns.len(),
        residual: best * WANTED,
        needed: WANTED,
        hint: "ask for fewer modes at a time",
    })
}

/// Rayleigh quotient, vector of modal mass one, residual; and, where that is more than wanted, the least residual that rounding leaves.
fn checked(
    stiffness: &SymmetricMatrix,
    x: &[f64],
    kx: &[f64],
    mx: &[f64],
    shift: f64,
) -> ((f64, Vec<f64>, f64), f64) {
    let modal = dot(x, mx);
    let value = dot(x, kx) / modal;
    let rest: Vec<f64> = kx.iter().zip(mx).map(|(k, m)| k - value * m).collect();
    let against = if value.abs() < RIGID * shift { shift * norm(mx) } else { norm(kx) };
    let residual = norm(&rest) / against;
    let mut least = 0.0;
    if residual > WANTED {
        let mut sizes = vec![0.0; x.len()];
        stiffness.multiply_sizes(x, &mut sizes);
        least = ROUNDING * norm(&sizes) / against;
    }
    // The sign is that of the largest component: the same on every machine.
    let largest = x.iter().fold(0.0f64, |best, value| if value.abs() > best.abs() { *value } else { best });
    let factor = largest.signum() / modal.sqrt();
    ((value, x.iter().map(|value| factor * value).collect(), residual), least)
}

/// Shares of the kinetic energy by slices along z: moving along x or tilting with it, the same along y, turning about z, motion along z; together at most 1.
fn shares(mesh: &Mesh, shape: &[[f64; 3]]) -> [f64; 4] {
    let lumps = lumped_mass(mesh);
    let (low, high) = mesh
        .nodes
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), node| (low.min(node[2]), high.max(node[2])));
    let slice = |z: f64| (((z - low) / (high - low) * SLICES as f64) as usize).min(SLICES - 1);
    // Mass, centre, momentum, moment of momentum and polar inertia of each slice; then what its motion along z needs.
    let mut sums = [[0.0; 13]; SLICES];
    let mut all = 0.0;
    for ((place, u), m) in mesh.nodes.iter().zip(shape).zip(&lumps) {
        let sum = &mut sums[slice(place[2])];
        let [x, y, _] = *place;
        let along = [u[2], x * u[2], y * u[2], x * x, y * y, x * y];
        let across = [1.0, x, y, u[0], u[1], x * u[1] - y * u[0], x * x + y * y];
        let parts = across.into_iter().chain(along);
        for (sum, part) in sum.iter_mut().zip(parts) {
            *sum += m * part;
        }
        all += m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
    let mut shares = [0.0; 4];
    for [m, x, y, px, py, spin, polar, pz, xz, yz, xx, yy, xy] in sums.into_iter().filter(|sum| sum[0] > 0.0)
    {
        let own = polar - (x * x + y * y) / m;
        let rate = if own > 1e-12 * polar { (spin - (x * py - y * px) / m) / own } else { 0.0 };
        // A slice that turns about the crank axis moves its centre too: that is torsion, the rest of its motion is bending.
        let (vx, vy) = (px / m + rate * y / m, py / m - rate * x / m);
        // Both move the centre, and what they do together belongs to neither: the energy of the slice as a rigid body goes to them in proportion to what each has alone.
        let parts = [m * vx * vx, m * vy * vy, rate * rate * polar];
        let alone: f64 = parts.iter().sum();
        let whole = (px * px + py * py) / m + rate * rate * own;
        if alone > 0.0 {
            (0..3).for_each(|k| shares[k] += parts[k] / alone * whole / all);
        }
        // Along z a slice moves as a whole, or tilts about the axis as a bent bar does: u_z = a + b x + c y.
        let own = [xx - x * x / m, yy - y * y / m, xy - x * y / m];
        let moved = [xz - x * pz / m, yz - y * pz / m];
        let determinant = own[0] * own[1] - own[2] * own[2];
        let [b, c] = match determinant > 1e-9 * xx * yy {
            true => [
                (own[1] * moved[0] - own[2] * moved[1]) / determinant,
                (own[0] * moved[1] - own[2] * moved[0]) / determinant,
            ],
            false => [0.0; 2],
        };
        let a = (pz - b * x - c * y) / m;
        let parts = [b * b * xx, c * c * yy, m * a * a];
        let alone: f64 = parts.iter().sum();
        let whole = pz * pz / m + b * moved[0] + c * moved[1];
        if alone > 0.0 {
            [0, 1, 3].into_iter().zip(parts).for_each(|(k, part)| shares[k] += part / alone * whole / all);
        }
    }
    shares
}

fn kind(shares: [f64; 4]) -> ModeKind {
    let kinds = [ModeKind::BendingX, ModeKind::BendingY, ModeKind::Torsion, ModeKind::Axial];
    let best = (0..4).max_by(|a, b| shares[*a].total_cmp(&shares[*b])).unwrap_or(0);
    if shares[best] >= 0.5 { kinds[best] } else { ModeKind::Mixed }
}

/// Mass of each node [kg]: that of its elements in equal shares to corners, so that it is never negative.
fn lumped_mass(mesh: &Mesh) -> Vec<f64> {
    let mut lumps = vec![0.0; mesh.nodes.len()];
    for element in &mesh.elements {
        let places = mesh.places(element);
        let volume: f64 = crate::element::stiffness_rule(element.kind)
            .iter()
            .map(|point| point.weight * crate::element::jacobian_determinant(element.kind, &places, point.at))
            .sum();
        let share = volume * mesh.materials[element.material as usize].density / element.nodes.len() as f64;
        for node in &element.nodes {
            lumps[*node as usize] += share;
        }
    }
    lumps
}
