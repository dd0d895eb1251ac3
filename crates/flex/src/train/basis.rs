//! From the mesh of a crankshaft to its body in few coordinates.
//!
//! Free natural modes, or those with the bearings held (Craig and Bampton), and the static shapes of a pressure on every bearing surface, of a torque at the flywheel and of the centrifugal field, each balanced by
//! the inertia of the body as a whole. What is left of them beside the modes is made orthonormal in the mass and diagonal in the stiffness:
//!
//! ```text
//! u = R q_r + V q_e    V^T M V = 1    V^T K V = diag(w^2)    K v_j = f_j - M R (R^T f_j)                     (book, eq. 51.2)
//! ```

use super::body::CrankBody;
use super::centrifugal::{carried_by_mains, geometric};
use super::coupling::{BearingPlace, Coupling, turning};
use super::stress::StressBasis;
use crate::FlexError;
use crate::case::{Spring, StaticCase, rigid_motions};
use crate::crank_case::BearingSurfaces;
use crate::crank_mesh::CrankMesh;
use crate::eigen::symmetric_eigen;
use crate::mesh::Mesh;
use crate::modes::{ModeKind, modes_watched};
use crate::reduction::project;
use crate::sparse::{Quantity, SolveEstimate, Structure, SymmetricMatrix, add, dot};
use crate::statics::{SolveOptions, StaticSystem};
use serde::Serialize;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_2_PI;

/// Cases that are solved at once.
const TOGETHER: usize = 8;
/// Stiffness by which surfaces are held for Craig and Bampton's modes [N/m]: far above that of a crankshaft.
const HELD: f64 = 1e11;
/// Share of a static shape beside the modes, in its mass, below which it adds nothing.
const LEFT: f64 = 1e-9;

/// Which modes stand beside the static shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BasisKind {
    /// Those of the free crankshaft; static shapes are balanced by the inertia of the body as a whole.
    #[default]
    FreeInterface,
    /// Craig and Bampton's: those with the mean motions of all bearing surfaces and of the flywheel's face held; static shapes are balanced at these.
    CraigBampton,
}

/// How many coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BasisOptions {
    /// Which modes.
    pub kind: BasisKind,
    /// Natural modes, of the free crankshaft beyond the rigid motions.
    pub modes: usize,
    /// Share of critical damping of every mode.
    pub damping: f64,
    /// Whether moments that tilt the bearing surfaces have static shapes too.
    pub tilt: bool,
    /// Bytes that matrix and factor may take.
    pub memory: u64,
}

impl Default for BasisOptions {
    fn default() -> BasisOptions {
        BasisOptions {
            kind: BasisKind::FreeInterface,
            modes: 20,
            damping: 0.01,
            tilt: false,
            memory: 8 << 30,
        }
    }
}

/// A crankshaft in few coordinates, with the stress of each.
#[derive(Debug, Clone)]
pub struct CrankBasis {
    /// The body.
    pub body: CrankBody,
    /// Stress at the fillets.
    pub stress: StressBasis,
    /// Natural frequencies of the modes that were kept [Hz].
    pub frequencies: Vec<f64>,
}

/// Reduces a crankshaft to its modes and the shapes of its bearings; `watch` sees what factors will cost.
///
/// # Errors
/// [`FlexError`] where a surface is missing or the equations have no solution.
pub fn crank_basis(
    crank: &CrankMesh,
    bearings: &[BearingPlace],
    options: BasisOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<CrankBasis, FlexError> {
    if !(0.0..1.0).contains(&options.damping) {
        return Err(FlexError::Number {
            quantity: "share of critical damping".to_owned(),
            needed: "0 to below 1".to_owned(),
            got: options.damping,
            hint: "steel cranks have 0.005 to 0.02",
        });
    }
    let mesh = &crank.mesh;
    let surfaces = BearingSurfaces::new(crank);
    let couplings: Vec<Coupling> = bearings
        .iter()
        .map(|place| Coupling::new(mesh, surfaces.areas(&place.set)?, place))
        .collect::<Result<_, _>>()?;
    let turn = turning(mesh, surfaces.areas("FLYWHEEL")?)?;
    let solve = SolveOptions { memory: options.memory, ..SolveOptions::default() };
    let held = match options.kind {
        BasisKind::FreeInterface => StaticCase::default(),
        BasisKind::CraigBampton => held_surfaces(mesh, &couplings, &turn, surfaces.areas("FLYWHEEL")?),
    };
    let rigid = if options.kind == BasisKind::FreeInterface { 6 } else { 0 };
    let found = modes_watched(mesh, &held, options.modes + rigid, solve, watch)?;
    let modes: Vec<_> = found.modes.into_iter().filter(|mode| mode.kind != ModeKind::Rigid).collect();

    let base = StaticCase { name: "static shapes".to_owned(), inertia_relief: true, ..StaticCase::default() };
    let shape_base = match options.kind {
        BasisKind::FreeInterface => base.clone(),
        BasisKind::CraigBampton => held,
    };
    let mut shapes = Vec::new();
    for coupling in &couplings {
        shapes.push(coupling.push(shape_base.clone(), [1e3, 0.0]));
        shapes.push(coupling.push(shape_base.clone(), [0.0, 1e3]));
        if options.tilt {
            shapes.extend([[1.0, 0.0], [0.0, 1.0]].map(|moment| coupling.tilt(shape_base.clone(), moment)));
        }
    }
    let mut twist = shape_base.clone();
    for (node, w) in &turn {
        twist = twist.push(&[(*node, 1.0)], [w[0], w[1], 0.0]);
    }
    shapes.push(twist);
    shapes.push(StaticCase { speed: 100.0, ..shape_base });
    let mut cases = Vec::new();
    // What a pressure over one half has beside its cosine: |cos|, by its first orders.
    for coupling in &couplings {
        let p = FRAC_2_PI / coupling.projected();
        cases.push(coupling.press(base.clone(), |_| 1e3 * p));
        for order in [2.0, 4.0] {
            let share = if order == 2.0 { 2.0 / 3.0 } else { -2.0 / 15.0 };
            cases.push(coupling.press(base.clone(), |a| 1e3 * p * share * (order * a).cos()));
            cases.push(coupling.press(base.clone(), |a| 1e3 * p * share * (order * a).sin()));
        }
    }
    let mut system = StaticSystem::new_watched(mesh, &base, solve, watch)?;
    cases.push(carried_by_mains(mesh, &base, &system, bearings, &couplings)?);
    let mut patterns = displacements(&mut system, &cases)?;
    let carried = patterns.pop().unwrap_or_default();
    let solved = match options.kind {
        BasisKind::FreeInterface => displacements(&mut system, &shapes)?,
        BasisKind::CraigBampton => {
            drop(system);
            let turning = shapes.last().unwrap_or(&base);
            displacements(&mut StaticSystem::new_watched(mesh, turning, solve, watch)?, &shapes)?
        }
    };

    let structure = Structure::new(mesh, &[]);
    let mass = structure.assemble(mesh, Quantity::Mass, &[]);
    let stiffness = structure.assemble(mesh, Quantity::Stiffness, &[]);
    let mut vectors = Orthonormal { mass: &mass, vectors: Vec::new(), images: Vec::new() };
    // Motion along z first: no force acts along it, so that it is left out.
    let motions = rigid_motions(mesh);
    for k in [2, 0, 1, 3, 4, 5] {
        vectors.add(structure.gather(&motions[k]));
    }
    for mode in &modes {
        vectors.add(structure.gather(&mode.shape));
    }
    for shape in &solved {
        vectors.add(structure.gather(shape));
    }
    let all = vectors.vectors;
    let (rigid, elastic) = (&all[1..6], &all[6..]);
    // Diagonal stiffness of what deforms.
    let count = elastic.len();
    let mut reduced = vec![0.0; count * count];
    for (column, image) in stiffness.multiply_all(elastic).iter().enumerate() {
        for row in 0..=column {
            let value = dot(&elastic[row], image);
            (reduced[row * count + column], reduced[column * count + row]) = (value, value);
        }
    }
    let (squares, shapes) = symmetric_eigen(&reduced, count);
    let mut basis: Vec<Vec<f64>> = rigid.to_vec();
    for shape in shapes.chunks(count.max(1)) {
        let mut vector = vec![0.0; stiffness.size()];
        for (share, own) in shape.iter().zip(elastic) {
            add(&mut vector, *share, own);
        }
        basis.push(vector);
    }
    let stiff: Vec<f64> = [0.0; 5].into_iter().chain(squares).collect();
    let frequencies = stiff.iter().map(|k| k.max(0.0).sqrt() / std::f64::consts::TAU).collect();
    let model = project(mesh, &[], &structure, [&stiffness, &mass], &basis, 0, frequencies);
    let stressed = geometric(mesh, &structure, &carried, &basis);
    let fields: Vec<Vec<[f64; 3]>> = basis.iter().map(|vector| structure.scatter(vector)).collect();
    let moved: Vec<Vec<[Plane; 2]>> = couplings
        .iter()
        .map(|coupling| fields.iter().map(|field| coupling.motion(field)).collect())
        .collect();
    let rows = |which: usize| -> Vec<[Vec<f64>; 2]> {
        let of = |own: &Vec<[Plane; 2]>| [0, 1].map(|k| own.iter().map(|motion| motion[which][k]).collect());
        moved.iter().map(of).collect()
    };
    let turning = fields
        .iter()
        .map(|field| {
            turn.iter()
                .map(|(node, w)| w[0] * field[*node as usize][0] + w[1] * field[*node as usize][1])
                .sum()
        })
        .collect();
    let n = basis.len();
    let mut damping = vec![0.0; n * n];
    for (k, square) in stiff.iter().enumerate() {
        damping[k * (n + 1)] = 2.0 * options.damping * square.max(0.0).sqrt();
    }
    let across: Vec<[f64; 3]> = mesh.nodes.iter().map(|[x, y, _]| [*x, *y, 0.0]).collect();
    let body = CrankBody {
        stiffness: stiff,
        damping,
        gyroscopic: model.gyroscopic,
        centrifugal: model.centrifugal.iter().zip(&stressed).map(|(n, s)| n - s).collect(),
        centrifugal_load: model.centrifugal_load,
        euler_load: model.euler_load,
        polar: mass.form(&structure.gather(&across)),
        rows: rows(0),
        turns: couplings
            .iter()
            .map(|coupling| fields.iter().map(|field| coupling.turn(mesh, field)).collect())
            .collect(),
        slopes: rows(1),
        turning,
    };
    let stress = StressBasis::new(crank, &fields, &patterns);
    Ok(CrankBasis { body, stress, frequencies: modes.iter().map(|mode| mode.frequency).collect() })
}

type Plane = super::plane::Plane;

/// Displacements under each case.
fn displacements(
    system: &mut StaticSystem<'_>,
    cases: &[StaticCase],
) -> Result<Vec<Vec<[f64; 3]>>, FlexError> {
    let mut solved = Vec::with_capacity(cases.len());
    for block in cases.chunks(TOGETHER) {
        let solutions = system.solve(&block.iter().collect::<Vec<_>>())?;
        solved.extend(solutions.into_iter().map(|solution| solution.displacements));
    }
    Ok(solved)
}

/// Stiff springs on the mean motions of all bearing surfaces, and on the flywheel's face along and about the axis.
fn held_surfaces(
    mesh: &Mesh,
    couplings: &[Coupling],
    turn: &[(u32, Plane)],
    face: &BTreeMap<u32, [f64; 3]>,
) -> StaticCase {
    let area: f64 = face.values().map(|area| area[2].abs()).sum();
    let arm =
        face.keys().map(|node| mesh.nodes[*node as usize]).map(|[x, y, _]| x.hypot(y)).fold(0.0, f64::max);
    let along = face.iter().map(|(node, own)| (*node, [0.0, 0.0, own[2].abs() / area])).collect();
    let about = turn.iter().map(|(node, w)| (*node, [arm * w[0], arm * w[1], 0.0])).collect();
    let spring = |name: &str, nodes| Spring { name: name.to_owned(), stiffness: HELD, nodes };
    let mut springs = vec![spring("FLYWHEEL z", along), spring("FLYWHEEL turning", about)];
    for coupling in couplings {
        springs.extend(coupling.translation().map(|nodes| spring("bearing", nodes)));
    }
    StaticCase { name: "surfaces held".to_owned(), springs, ..StaticCase::default() }
}

/// Vectors orthonormal in the mass, and their images.
struct Orthonormal<'a> {
    mass: &'a SymmetricMatrix,
    vectors: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
}

impl Orthonormal<'_> {
    /// Takes what a vector has beside those that are there.
    fn add(&mut self, mut vector: Vec<f64>) {
        let mut image = vec![0.0; vector.len()];
        self.mass.multiply(&vector, &mut image);
        let before = dot(&vector, &image).sqrt();
        if before.is_nan() || before <= 0.0 {
            return;
        }
        vector.iter_mut().for_each(|value| *value /= before);
        for _ in 0..3 {
            for (own, image) in self.vectors.iter().zip(&self.images) {
                let share = dot(image, &vector);
                add(&mut vector, -share, own);
            }
        }
        self.mass.multiply(&vector, &mut image);
        let left = dot(&vector, &image).sqrt();
        if left.is_nan() || left < LEFT {
            return;
        }
        vector.iter_mut().chain(image.iter_mut()).for_each(|value| *value /= left);
        self.vectors.push(vector);
        self.images.push(image);
    }
}
