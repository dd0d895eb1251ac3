//! Stress of a throw's fillets under a moment, a torque and a force of its own: what stress concentration factors are made of.
//!
//! The bay between the middles of its main journals, whose end faces stay plane and rigid. The rear face takes the six motions of a rigid body, one
//! after the other, with the front face held; the motions that a load needs follow from the wrenches that they cost:
//!
//! ```text
//! S x + w_0 = w        S: wrench on the rear face for each of its motions; w_0: that of a load on the pin with both faces held   (book, eq. 49.16)
//! ```

use crate::FlexError;
use crate::case::StaticCase;
use crate::crank_case::{BearingSurfaces, PinLoad, PinPressure, load_pin};
use crate::crank_mesh::{CUTS, CrankMesh};
use crate::element::Stress;
use crate::mesh::cross;
use crate::sparse::{SolveEstimate, SolveReport};
use crate::statics::{NodeStress, SolveOptions, StaticSolution, StaticSystem, node_stresses};
use lanchester_numerics::Lu;
use serde::Serialize;

/// Motion of the rear face: 1 um, and as much at its rim [m]. The problem is linear; the size keeps numbers of one kind together.
const MOTION: f64 = 1e-6;

/// Force on the pin of a case [N].
const FORCE: f64 = 1000.0;

/// A throw between two main bearings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrowSupports {
    /// Number of its pin, from 1.
    pub pin: usize,
    /// Planes of the main bearings in front and behind, where moments of its force vanish [m].
    pub mains: [f64; 2],
}

/// The largest stresses of a fillet under unit loads.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FilletStress {
    /// "pin 1 at web 2".
    pub name: String,
    /// Von Mises stress of a constant bending moment in the plane of the throw [Pa/(N m)].
    pub bending: f64,
    /// Von Mises stress of a force on the pin towards the crank axis, the throw on two supports [Pa/N].
    pub force: f64,
    /// Largest shear stress, (sigma_1 - sigma_3)/2, of a torque through the throw [Pa/(N m)].
    pub torsion: f64,
    /// Largest jump of the von Mises stress between elements at these places over the stress: a sign of the error [1].
    pub jump: f64,
}

/// Stresses of a throw's fillets.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowStress {
    /// Fillet by fillet along the crank; sharp corners are left out, their stress is no number.
    pub fillets: Vec<FilletStress>,
    /// Share of the force that the front main bearing carries [1].
    pub front_share: f64,
    /// How the equations were solved.
    pub report: SolveReport,
}

/// Computes them on the mesh of a bay ([`crate::crank_mesh::crank_mesh_of_bay`]); `watch` sees what the factor will cost before it is made.
///
/// # Errors
/// [`FlexError::Missing`] where the mesh has no such pin or no cuts; else as [`StaticSystem::new`].
pub fn throw_stress(
    bay: &CrankMesh,
    throw: ThrowSupports,
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<ThrowStress, FlexError> {
    let [front, rear] = CUTS.map(|cut| bay.mesh.set(cut).map(|set| set.nodes.as_slice()));
    let (front, rear) = (front?, rear?);
    let face = Face::new(bay, rear);
    let held = StaticCase { name: "rigid end faces".to_owned(), ..StaticCase::default() }.clamp(front);
    let radial = throw_direction(bay, throw.pin)?;
    let surfaces = BearingSurfaces::new(bay);
    let load = PinLoad { pin: throw.pin, force: radial.map(|n| -FORCE * n) };
    let pressed = load_pin(&surfaces, held.clone().clamp(rear), load, PinPressure::Cosine)?;
    let front_share = share(bay, &pressed, throw.mains);
    let mut cases: Vec<StaticCase> = (0..6).map(|k| face.moved(held.clone(), k)).collect();
    cases.push(pressed);
    let mut system = StaticSystem::new_watched(&bay.mesh, &cases[6], options, watch)?;
    let solved = system.solve_moved(&cases.iter().collect::<Vec<_>>())?;
    let wrenches: Vec<[f64; 6]> = solved.iter().map(|solution| face.wrench(solution)).collect();
    // Row by row.
    let stiffness = (0..36).map(|k| wrenches[k % 6][k / 6]).collect();
    let stiffness = Lu::new(6, stiffness).map_err(|_| FlexError::FreeMotion {
        motion: "a throw whose end faces hang together nowhere".to_owned(),
    })?;
    let field = |wanted: [f64; 6], pressed: bool| {
        let mut x = wanted;
        if pressed {
            x.iter_mut().zip(wrenches[6]).for_each(|(x, own)| *x -= own);
        }
        stiffness.solve(&mut x);
        let mut weights = x.to_vec();
        weights.push(f64::from(u8::from(pressed)));
        node_stresses(&bay.mesh, &combined(&solved, &weights))
    };
    let [x, y] = radial;
    // The moment turns about the line across throw and crank axis.
    let bending = field([0.0, 0.0, 0.0, -y, x, 0.0], false);
    let torsion = field([0.0, 0.0, 0.0, 0.0, 0.0, 1.0], false);
    let support = (1.0 - front_share) * FORCE;
    let arm = throw.mains[1] - face.centre[2];
    // The force of the rear bearing, away from the axis, in the middle of the face.
    let force = field([support * x, support * y, 0.0, -arm * support * y, arm * support * x, 0.0], true);
    let fillets = bay.corners.iter().filter(|corner| !corner.nodes.is_empty()).map(|corner| {
        let largest = |of: &dyn Fn(&Stress) -> f64, field: &[NodeStress]| {
            let nodes = corner.nodes.iter().map(|node| field[*node as usize]);
            nodes
                .map(|own| (of(&own.stress), own.jump))
                .fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
        };
        let shear = |stress: &Stress| {
            let [first, _, third] = stress.principal();
            (first - third) / 2.0
        };
        let [of_bending, of_force] = [&bending, &force].map(|field| largest(&Stress::von_mises, field));
        let of_torsion = largest(&shear, &torsion);
        // In pure shear the von Mises stress, whose jump it is, has sqrt(3) times the size.
        let jumps = [
            of_bending.1 / of_bending.0,
            of_force.1 / of_force.0,
            of_torsion.1 / (3f64.sqrt() * of_torsion.0),
        ];
        FilletStress {
            name: corner.name.clone(),
            bending: of_bending.0,
            force: of_force.0 / FORCE,
            torsion: of_torsion.0,
            jump: jumps.into_iter().filter(|jump| jump.is_finite()).fold(0.0, f64::max),
        }
    });
    Ok(ThrowStress { fillets: fillets.collect(), front_share, report: solved[6].report })
}

/// The end face that moves.
struct Face<'a> {
    bay: &'a CrankMesh,
    nodes: &'a [u32],
    /// Where the crank axis meets it [m].
    centre: [f64; 3],
    /// Its radius [m].
    reach: f64,
}

impl<'a> Face<'a> {
    fn new(bay: &'a CrankMesh, nodes: &'a [u32]) -> Face<'a> {
        let places = || nodes.iter().map(|node| bay.mesh.nodes[*node as usize]);
        let z = places().map(|at| at[2]).sum::<f64>() / nodes.len().max(1) as f64;
        let reach = places().map(|at| at[0].hypot(at[1])).fold(f64::MIN_POSITIVE, f64::max);
        Face { bay, nodes, centre: [0.0, 0.0, z], reach }
    }

    /// A place from the middle of the face [m].
    fn arm(&self, node: u32) -> [f64; 3] {
        let at = self.bay.mesh.nodes[node as usize];
        std::array::from_fn(|k| at[k] - self.centre[k])
    }

    /// The case in which the face makes its rigid motion `k`: along x, y, z, about x, y, z.
    fn moved(&self, case: StaticCase, k: usize) -> StaticCase {
        self.nodes.iter().fold(case, |case, node| {
            let mut axis = [0.0; 3];
            axis[k % 3] = if k < 3 { MOTION } else { MOTION / self.reach };
            let u = if k < 3 { axis } else { cross(axis, self.arm(*node)) };
            (0..3).fold(case, |case, axis| case.hold(&[*node], axis as u8, u[axis]))
        })
    }

    /// Force and moment on the face about its middle.
    fn wrench(&self, solution: &StaticSolution) -> [f64; 6] {
        self.nodes.iter().fold([0.0; 6], |sum, node| {
            let force = solution.reactions[*node as usize];
            let moment = cross(self.arm(*node), force);
            std::array::from_fn(|k| sum[k] + if k < 3 { force[k] } else { moment[k - 3] })
        })
    }
}

/// Direction of the throw of a pin, in the frame of the crankshaft.
///
/// # Errors
/// [`FlexError::Missing`] where the mesh has no such pin.
pub fn throw_direction(bay: &CrankMesh, pin: usize) -> Result<[f64; 2], FlexError> {
    let nodes = &bay.mesh.set(&format!("PIN_{pin}"))?.nodes;
    let sum = nodes.iter().fold([0.0; 2], |sum, node| {
        let [x, y, _] = bay.mesh.nodes[*node as usize];
        [sum[0] + x, sum[1] + y]
    });
    let size = sum[0].hypot(sum[1]);
    Ok(sum.map(|part| part / size))
}

/// Share of the loads of a case that the front one of two supports carries.
fn share(bay: &CrankMesh, case: &StaticCase, [first, last]: [f64; 2]) -> f64 {
    let (force, moment) = case.forces.iter().fold(([0.0; 2], [0.0; 2]), |(force, moment), own| {
        let arm = last - bay.mesh.nodes[own.node as usize][2];
        let [x, y, _] = own.force;
        ([force[0] + x, force[1] + y], [moment[0] + arm * x, moment[1] + arm * y])
    });
    let along = moment[0] * force[0] + moment[1] * force[1];
    along / ((force[0].powi(2) + force[1].powi(2)) * (last - first))
}

/// Sum of solutions with weights.
fn combined(solved: &[StaticSolution], weights: &[f64]) -> Vec<[f64; 3]> {
    let mut sum = vec![[0.0; 3]; solved[0].displacements.len()];
    for (solution, weight) in solved.iter().zip(weights).filter(|(_, weight)| **weight != 0.0) {
        for (sum, own) in sum.iter_mut().zip(&solution.displacements) {
            (0..3).for_each(|k| sum[k] += weight * own[k]);
        }
    }
    sum
}
