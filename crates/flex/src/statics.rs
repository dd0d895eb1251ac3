//! Static solutions: displacement, energy, reactions, stress.

use crate::case::{Fixed, NodeForce, StaticCase, rigid_motions};
use crate::eigen::symmetric_eigen;
use crate::mesh::Mesh;
use crate::sparse::{
    DenseTerm, Precision, Quantity, SolveEstimate, SolveReport, Solver, Structure, SymmetricMatrix, add, dot,
};
use crate::{FlexError, element};
use rayon::prelude::*;
use serde::Serialize;

/// Displacements that are given and loads, of all unknowns, and the accelerations that balance them.
type Loaded = (Vec<f64>, Vec<f64>, Option<[f64; 6]>);
/// Superconvergent points of a kind of element, and the weights of their values at its nodes.
type Recovery = (Vec<[f64; 3]>, Vec<Vec<f64>>);

/// How to solve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SolveOptions {
    /// Precision of the factor; the solution is refined to double precision in either.
    pub precision: Precision,
    /// Bytes that matrix and factor may take.
    pub memory: u64,
    /// Whether modes have the mass of CalculiX, integrated with the rule of the stiffness.
    pub coarse_mass: bool,
    /// Whether modes are counted by a second factor, which tells whether any is missing.
    pub count_modes: bool,
}

impl Default for SolveOptions {
    fn default() -> SolveOptions {
        SolveOptions { precision: Precision::Single, memory: 8 << 30, coarse_mass: false, count_modes: false }
    }
}

/// A static solution.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct StaticSolution {
    /// Displacements of the nodes [m].
    pub displacements: Vec<[f64; 3]>,
    /// Elastic energy of body and springs [J].
    pub energy: f64,
    /// Sum of all loads [N].
    pub load: [f64; 3],
    /// Sum of what supports exert on the body [N].
    pub reaction: [f64; 3],
    /// Forces of the supports on nodes that are held [N], zero elsewhere.
    pub reactions: Vec<[f64; 3]>,
    /// Forces of the springs on the body [N], in the order of the case.
    pub spring_forces: Vec<f64>,
    /// With inertia relief: accelerations along x, y, z [m/s^2] and about x, y, z [rad/s^2] that balance the loads, at the middle of the
    /// nodes.
    pub accelerations: Option<[f64; 6]>,
    /// How the equations were solved.
    pub report: SolveReport,
}

/// A mesh with supports, factored once for as many loads as are wanted.
pub struct StaticSystem<'a> {
    mesh: &'a Mesh,
    structure: Structure,
    full: SymmetricMatrix,
    /// The same without terms that change.
    lasting: Option<SymmetricMatrix>,
    mass: Option<SymmetricMatrix>,
    /// What balances loads where nothing holds the body.
    relief: Option<Relief>,
    support: StaticCase,
    kept: Vec<bool>,
    solver: Solver,
}

impl<'a> StaticSystem<'a> {
    /// Assembles and factors a mesh with the supports of a case, whose loads do not count.
    ///
    /// # Errors
    /// As [`Mesh::check`], [`StaticCase::check`]; [`FlexError::Memory`], [`FlexError::NotDefinite`].
    pub fn new(
        mesh: &'a Mesh,
        case: &StaticCase,
        options: SolveOptions,
    ) -> Result<StaticSystem<'a>, FlexError> {
        StaticSystem::new_watched(mesh, case, options, &|_| {})
    }

    /// The same; `watch` sees what the factor will cost before it is made, and before a limit on memory is applied.
    ///
    /// # Errors
    /// As [`StaticSystem::new`].
    pub fn new_watched(
        mesh: &'a Mesh,
        case: &StaticCase,
        options: SolveOptions,
        watch: &dyn Fn(&SolveEstimate),
    ) -> Result<StaticSystem<'a>, FlexError> {
        StaticSystem::new_with(mesh, case, &[], options, watch)
    }

    /// The same with terms that may change their values later.
    pub(crate) fn new_with(
        mesh: &'a Mesh,
        case: &StaticCase,
        changing: &[DenseTerm],
        options: SolveOptions,
        watch: &dyn Fn(&SolveEstimate),
    ) -> Result<StaticSystem<'a>, FlexError> {
        mesh.check()?;
        case.check(mesh)?;
        let terms = case.terms();
        let structure = Structure::new(mesh, &[terms.as_slice(), changing].concat());
        let mut full = structure.assemble(mesh, Quantity::Stiffness, &terms);
        let mut lasting = None;
        if !changing.is_empty() {
            let with = structure.with_terms(&full, changing);
            lasting = Some(std::mem::replace(&mut full, with));
        }
        let needs_mass = case.inertia_relief || case.turns();
        let mass = needs_mass.then(|| structure.assemble(mesh, Quantity::Mass, &[]));
        let relief = match &mass {
            Some(mass) if case.inertia_relief => Some(Relief::new(mesh, &structure, mass)?),
            _ => None,
        };
        let mut kept = vec![true; full.size()];
        for fixed in &case.fixed {
            kept[structure.unknown(fixed.node, fixed.axis as usize)] = false;
        }
        if case.inertia_relief {
            for (node, axis) in anchors(mesh) {
                kept[structure.unknown(node, axis)] = false;
            }
        }
        let solver = Solver::new(full.restricted(&kept), options.precision, options.memory, watch)?;
        Ok(StaticSystem { mesh, structure, full, lasting, mass, relief, support: case.clone(), kept, solver })
    }

    /// Gives the terms that may change other values, and factors anew.
    pub(crate) fn change_terms(&mut self, terms: &[DenseTerm]) -> Result<(), FlexError> {
        let lasting = self.lasting.as_ref().unwrap_or(&self.full);
        let full = self.structure.with_terms(lasting, terms);
        self.solver.replace(full.restricted(&self.kept))?;
        self.full = full;
        Ok(())
    }

    /// Forces that displacements need without the terms that may change [N].
    pub(crate) fn without_terms(&self, displacements: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let mut product = vec![0.0; self.full.size()];
        let matrix = self.lasting.as_ref().unwrap_or(&self.full);
        matrix.multiply(&self.structure.gather(displacements), &mut product);
        self.structure.scatter(&product)
    }

    /// Forces of a case on all nodes [N].
    pub(crate) fn forces(&self, case: &StaticCase) -> Result<Vec<[f64; 3]>, FlexError> {
        Ok(self.structure.scatter(&self.load(case)?))
    }

    /// Solves cases that have the supports of this system.
    ///
    /// # Errors
    /// [`FlexError::NoConvergence`]; [`FlexError::Missing`] where a case needs masses and the first one did not.
    pub fn solve(&mut self, cases: &[&StaticCase]) -> Result<Vec<StaticSolution>, FlexError> {
        let held = self.support.fixed.clone();
        self.solve_held(cases, &|_| &held)
    }

    /// Solves cases that hold the nodes of this system's support, each with displacements of its own.
    ///
    /// # Errors
    /// As [`StaticSystem::solve`].
    pub(crate) fn solve_moved(&mut self, cases: &[&StaticCase]) -> Result<Vec<StaticSolution>, FlexError> {
        self.solve_held(cases, &|case| &case.fixed)
    }

    fn solve_held<'b>(
        &mut self,
        cases: &[&'b StaticCase],
        held: &dyn Fn(&'b StaticCase) -> &'b [Fixed],
    ) -> Result<Vec<StaticSolution>, FlexError> {
        let size = self.full.size();
        let mut loads = Vec::with_capacity(cases.len());
        let mut sides = Vec::with_capacity(cases.len());
        for case in cases {
            case.check(self.mesh)?;
            let mut given = vec![0.0; size];
            for fixed in held(case) {
                given[self.structure.unknown(fixed.node, fixed.axis as usize)] = fixed.value;
            }
            let mut drag = vec![0.0; size];
            if given.iter().any(|value| *value != 0.0) {
                self.full.multiply(&given, &mut drag);
            }
            let mut load = self.load(case)?;
            let accelerations = self.relief.as_ref().map(|relief| relief.balance(&mut load));
            let side: Vec<f64> = (0..size).filter(|k| self.kept[*k]).map(|k| load[k] - drag[k]).collect();
            sides.push(side);
            loads.push((given, load, accelerations));
        }
        let (solutions, report) = self.solver.solve(&sides)?;
        for (free, (u, ..)) in solutions.into_iter().zip(&mut loads) {
            let mut values = free.into_iter();
            for k in (0..size).filter(|k| self.kept[*k]) {
                u[k] = values.next().unwrap_or_default();
            }
        }
        let moved: Vec<&[f64]> = loads.iter().map(|(u, ..)| u.as_slice()).collect();
        let internal = self.full.multiply_all(&moved);
        let solution = |(loaded, internal): (&Loaded, Vec<f64>)| self.solution(loaded, &internal, report);
        Ok(loads.iter().zip(internal).map(solution).collect())
    }

    /// From displacements and loads, and the forces that the displacements need.
    fn solution(
        &self,
        (u, load, accelerations): &Loaded,
        internal: &[f64],
        report: SolveReport,
    ) -> StaticSolution {
        let energy = 0.5 * dot(internal, u);
        let rest = |k: usize| if self.kept[k] { 0.0 } else { internal[k] - load[k] };
        let held: Vec<f64> = (0..u.len()).map(rest).collect();
        let reactions = self.structure.scatter(&held);
        let displacements = self.structure.scatter(u);
        let spring_forces: Vec<f64> = self
            .support
            .springs
            .iter()
            .map(|spring| -spring.stiffness * spring.displacement(&displacements))
            .collect();
        let mut reaction = sum(&reactions);
        for (spring, force) in self.support.springs.iter().zip(&spring_forces) {
            for (_, weight) in &spring.nodes {
                for axis in 0..3 {
                    reaction[axis] += force * weight[axis];
                }
            }
        }
        let load = sum(&self.structure.scatter(load));
        StaticSolution {
            displacements,
            energy,
            load,
            reaction,
            reactions,
            spring_forces,
            accelerations: *accelerations,
            report,
        }
    }

    /// Forces on all unknowns: those of the case, and the field of its turning with the weights that the body carries.
    fn load(&self, case: &StaticCase) -> Result<Vec<f64>, FlexError> {
        let mut load = vec![0.0; self.full.size()];
        for force in &case.forces {
            for axis in 0..3 {
                load[self.structure.unknown(force.node, axis)] += force.force[axis];
            }
        }
        if case.turns() {
            add_turning(self.mesh, &self.structure, self.mass()?, case, &mut load);
        }
        Ok(load)
    }

    fn mass(&self) -> Result<&SymmetricMatrix, FlexError> {
        self.mass.as_ref().ok_or_else(|| FlexError::Missing {
            what: "mass matrix",
            name: self.support.name.clone(),
            hint: "the first case must turn or be relieved too",
        })
    }
}

/// Adds the field of a body that turns about z, `M (W^2 (x, y, 0) - W' (-y, x, 0))` (book, eq. 43.19), and that of the weights that it carries.
fn add_turning(
    mesh: &Mesh,
    structure: &Structure,
    mass: &SymmetricMatrix,
    case: &StaticCase,
    load: &mut [f64],
) {
    let (outwards, backwards) = (case.speed * case.speed, case.acceleration);
    let turned = |[x, y]: [f64; 2]| [outwards * x + backwards * y, outwards * y - backwards * x];
    let places: Vec<[f64; 3]> = mesh
        .nodes
        .iter()
        .map(|[x, y, _]| {
            let [x, y] = turned([*x, *y]);
            [x, y, 0.0]
        })
        .collect();
    let mut field = vec![0.0; load.len()];
    mass.multiply(&structure.gather(&places), &mut field);
    for (load, field) in load.iter_mut().zip(field) {
        *load += field;
    }
    for (node, [x, y, z]) in mesh.weights.iter().flat_map(|weight| &weight.forces) {
        let [x, y] = turned([*x, *y]);
        for (axis, force) in [x, y, outwards * z].into_iter().enumerate() {
            load[structure.unknown(*node, axis)] += force;
        }
    }
}

/// The same case with forces on nodes in the place of the field of its turning and of inertia relief, for which six displacements hold the
/// body without loading it: what a program without either can compute.
///
/// # Errors
/// As [`StaticCase::check`]; [`FlexError::FreeMotion`] for a body without mass.
pub fn as_node_forces(mesh: &Mesh, case: &StaticCase) -> Result<StaticCase, FlexError> {
    case.check(mesh)?;
    if !case.turns() && !case.inertia_relief {
        return Ok(case.clone());
    }
    let structure = Structure::new(mesh, &[]);
    let mass = structure.assemble(mesh, Quantity::Mass, &[]);
    let mut given = vec![[0.0; 3]; mesh.nodes.len()];
    for force in &case.forces {
        for axis in 0..3 {
            given[force.node as usize][axis] += force.force[axis];
        }
    }
    let mut load = structure.gather(&given);
    let mut plain = StaticCase { speed: 0.0, acceleration: 0.0, inertia_relief: false, ..case.clone() };
    if case.turns() {
        add_turning(mesh, &structure, &mass, case, &mut load);
    }
    if case.inertia_relief {
        Relief::new(mesh, &structure, &mass)?.balance(&mut load);
        for (node, axis) in anchors(mesh) {
            plain = plain.hold(&[node], axis as u8, 0.0);
        }
    }
    let forces = structure.scatter(&load).into_iter().enumerate();
    let acting = forces.filter(|(_, force)| force.iter().any(|f| *f != 0.0));
    plain.forces = acting.map(|(node, force)| NodeForce { node: node as u32, force }).collect();
    Ok(plain)
}

/// Takes from a load the inertia of the rigid accelerations that it causes: what is left is in balance.
///
/// ```text
/// (R^T M R) a = R^T f        f - M R a        R: the six rigid motions                   (book, eq. 43.7)
/// ```
struct Relief {
    /// `R`.
    motions: Vec<Vec<f64>>,
    /// `M R`.
    carried: Vec<Vec<f64>>,
    /// Eigenvalues and vectors of `R^T M R`.
    inertia: (Vec<f64>, Vec<f64>),
    /// The turns of the motions are in units of it.
    reach: f64,
}

impl Relief {
    fn new(mesh: &Mesh, structure: &Structure, mass: &SymmetricMatrix) -> Result<Relief, FlexError> {
        let motions: Vec<Vec<f64>> =
            rigid_motions(mesh).iter().map(|motion| structure.gather(motion)).collect();
        let carried = mass.multiply_all(&motions);
        let gram: Vec<f64> = motions.iter().flat_map(|a| carried.iter().map(move |b| dot(a, b))).collect();
        let inertia = symmetric_eigen(&gram, 6);
        if inertia.0[0] <= 1e-12 * inertia.0[5] {
            return Err(FlexError::FreeMotion { motion: "a body without mass has no inertia".to_owned() });
        }
        Ok(Relief { motions, carried, inertia, reach: reach(mesh) })
    }

    /// The accelerations: along the axes and about them.
    fn balance(&self, load: &mut [f64]) -> [f64; 6] {
        let force: Vec<f64> = self.motions.iter().map(|motion| dot(motion, load)).collect();
        let mut acceleration = [0.0; 6];
        let (values, vectors) = &self.inertia;
        for (value, vector) in values.iter().zip(vectors.chunks(6)) {
            let share = dot(vector, &force) / value;
            for k in 0..6 {
                acceleration[k] += share * vector[k];
            }
        }
        for (carried, a) in self.carried.iter().zip(acceleration) {
            add(load, -a, carried);
        }
        std::array::from_fn(|k| if k < 3 { acceleration[k] } else { acceleration[k] / self.reach })
    }
}

/// Solves one case.
///
/// # Errors
/// As [`StaticSystem::new`] and [`StaticSystem::solve`].
pub fn solve_static(
    mesh: &Mesh,
    case: &StaticCase,
    options: SolveOptions,
) -> Result<StaticSolution, FlexError> {
    let mut solutions = StaticSystem::new(mesh, case, options)?.solve(&[case])?;
    Ok(solutions.remove(0))
}

fn sum(field: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|k| field.iter().map(|value| value[k]).sum())
}

/// Largest distance of a node from the middle of all [m].
fn reach(mesh: &Mesh) -> f64 {
    let count = mesh.nodes.len() as f64;
    let middle: [f64; 3] =
        std::array::from_fn(|k| mesh.nodes.iter().map(|node| node[k]).sum::<f64>() / count);
    let squares = |node: &[f64; 3]| (0..3).map(|k| (node[k] - middle[k]).powi(2)).sum::<f64>();
    mesh.nodes.iter().map(squares).fold(0.0, f64::max).sqrt()
}

/// Six displacements of three nodes far apart that hold a free body without loading it: node and axis.
pub(crate) fn anchors(mesh: &Mesh) -> [(u32, usize); 6] {
    let far = |measure: &dyn Fn(&[f64; 3]) -> f64| -> usize {
        let mut best = (0, f64::NEG_INFINITY);
        for (node, place) in mesh.nodes.iter().enumerate() {
            let value = measure(place);
            if value > best.1 {
                best = (node, value);
            }
        }
        best.0
    };
    let a = far(&|place| -place[0] - place[1] - place[2]);
    let from = mesh.nodes[a];
    let apart = |place: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| place[k] - from[k]) };
    let b = far(&|place| apart(place).iter().map(|x| x * x).sum());
    let line = apart(&mesh.nodes[b]);
    let cross = |u: [f64; 3]| {
        [line[1] * u[2] - line[2] * u[1], line[2] * u[0] - line[0] * u[2], line[0] * u[1] - line[1] * u[0]]
    };
    let c = far(&|place| cross(apart(place)).iter().map(|x| x * x).sum());
    // The second node may go along the line from the first; turning about that line moves the third along the normal of their plane.
    let biggest = |v: [f64; 3]| (0..3).max_by(|a, b| v[*a].abs().total_cmp(&v[*b].abs())).unwrap_or(0);
    let (along, normal) = (biggest(line), biggest(cross(apart(&mesh.nodes[c]))));
    let [p, q] = [(along + 1) % 3, (along + 2) % 3];
    let (a, b, c) = (a as u32, b as u32, c as u32);
    [(a, 0), (a, 1), (a, 2), (b, p), (b, q), (c, normal)]
}

/// Stress at a node.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct NodeStress {
    /// Mean over the elements of one material at the node.
    pub stress: element::Stress,
    /// Largest less smallest von Mises stress of those elements [Pa]: a sign of the error.
    pub jump: f64,
}

/// Stress at the nodes, extrapolated from the superconvergent points and averaged within the material with the lowest index there.
pub fn node_stresses(mesh: &Mesh, displacements: &[[f64; 3]]) -> Vec<NodeStress> {
    let tables: Vec<Recovery> = element::ElementKind::ALL
        .iter()
        .map(|kind| (element::recovery_points(*kind), element::extrapolation(*kind)))
        .collect();
    let each: Vec<Vec<element::Stress>> = mesh
        .elements
        .par_iter()
        .map(|cell| {
            let (points, weights) = &tables[cell.kind as usize];
            let places = mesh.places(cell);
            let moved: Vec<[f64; 3]> = cell.nodes.iter().map(|node| displacements[*node as usize]).collect();
            let material = &mesh.materials[cell.material as usize];
            let at: Vec<element::Stress> = points
                .iter()
                .map(|point| element::stress_at(cell.kind, &places, &moved, material, *point))
                .collect();
            let value = |weights: &Vec<f64>| {
                weights.iter().zip(&at).fold(element::Stress::default(), |sum, (w, s)| sum + *s * *w)
            };
            weights.iter().map(value).collect()
        })
        .collect();
    let mut first = vec![u32::MAX; mesh.nodes.len()];
    for cell in &mesh.elements {
        for node in &cell.nodes {
            first[*node as usize] = first[*node as usize].min(cell.material);
        }
    }
    let mut sums =
        vec![(element::Stress::default(), 0.0, f64::INFINITY, f64::NEG_INFINITY); mesh.nodes.len()];
    for (cell, stresses) in mesh.elements.iter().zip(each) {
        for (node, stress) in cell.nodes.iter().zip(stresses) {
            if first[*node as usize] == cell.material {
                let (sum, count, least, most) = &mut sums[*node as usize];
                let equivalent = stress.von_mises();
                (*sum, *count) = (*sum + stress, *count + 1.0);
                (*least, *most) = (least.min(equivalent), most.max(equivalent));
            }
        }
    }
    let mean = |(sum, count, least, most): (element::Stress, f64, f64, f64)| {
        if count > 0.0 {
            NodeStress { stress: sum * (1.0 / count), jump: most - least }
        } else {
            NodeStress::default()
        }
    };
    sums.into_iter().map(mean).collect()
}
