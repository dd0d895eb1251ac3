//! Mean motion of a bearing surface, and forces on it as a pressure.
//!
//! With the area vectors `a` of its nodes (outward), `P = a a^T/|a|` and the plane `z_c` of the bearing, the rigid translation `t` and slope `s` along z that fit the normal
//! displacements best:
//!
//! ```text
//! [t; s] = [G_0 G_1; G_1 G_2]^-1 SUM [P u; (z - z_c) P u]    G_k = SUM (z - z_c)^k P                             (book, eq. 51.1)
//! ```
//! A force on `t` acts through the same weights: a pressure `p_1 cos(a - a_F)` along the whole surface, with no moment about `z_c`.

use super::plane::{Plane, Square};
use crate::FlexError;
use crate::case::StaticCase;
use crate::mesh::Mesh;
use lanchester_numerics::Lu;
use std::collections::BTreeMap;

/// Where a bearing sits on a crankshaft.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingPlace {
    /// What it is called.
    pub name: String,
    /// Node set of its surface.
    pub set: String,
    /// Its middle along the crank [m].
    pub z: f64,
    /// Its width [m].
    pub width: f64,
}

/// Weights of the nodes of a bearing surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Coupling {
    /// Node, its area vector [m^2].
    areas: Vec<(u32, [f64; 3])>,
    /// Weights of translation and slope.
    weights: Vec<(u32, [Square; 2])>,
}

impl Coupling {
    /// Of the surface with these area vectors, as far as it lies within the bearing.
    pub fn new(
        mesh: &Mesh,
        areas: &BTreeMap<u32, [f64; 3]>,
        place: &BearingPlace,
    ) -> Result<Coupling, FlexError> {
        let beside = |node: u32| mesh.nodes[node as usize][2] - place.z;
        let all: Vec<(u32, [f64; 3])> = areas
            .iter()
            .filter(|(_, area)| area[0].hypot(area[1]) > 0.0)
            .map(|(node, area)| (*node, *area))
            .collect();
        let within: Vec<(u32, [f64; 3])> =
            all.iter().filter(|(node, _)| beside(*node).abs() <= 0.5 * place.width + 1e-9).copied().collect();
        // A bearing between two levels of nodes, or with one alone, has no slope: the whole surface carries it.
        let spread = |nodes: &[(u32, [f64; 3])]| {
            let ends = nodes.iter().map(|(node, _)| beside(*node));
            ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
        };
        let [low, high] = spread(&within);
        let areas = if high - low > 0.3 * place.width { within } else { all };
        let [low, high] = spread(&areas);
        if !(low..=high).contains(&0.0) || high <= low {
            return Err(FlexError::Number {
                quantity: format!("plane of {} [m]", place.name),
                needed: format!(
                    "within its surface {}, {:.6} to {:.6}",
                    place.set,
                    place.z + low,
                    place.z + high
                ),
                got: place.z,
                hint: "planes of bearings and lengths of journals and pins must belong to one crankshaft",
            });
        }
        let mut gram = vec![0.0; 16];
        for (node, [x, y, _]) in &areas {
            let (z, size) = (beside(*node), x.hypot(*y));
            let a = [*x, *y];
            for i in 0..4 {
                for j in 0..4 {
                    gram[4 * i + j] += a[i % 2] * a[j % 2] / size * z.powi((i / 2 + j / 2) as i32);
                }
            }
        }
        let factors = Lu::new(4, gram).map_err(|_| FlexError::Missing {
            what: "bearing surface",
            name: place.set.clone(),
            hint: "a bearing needs a surface around the whole bar",
        })?;
        let weight = |(node, [x, y, _]): &(u32, [f64; 3])| {
            let (z, size) = (beside(*node), x.hypot(*y));
            let a = [*x, *y];
            let mut own = [[[0.0; 2]; 2]; 2];
            for k in 0..2 {
                let mut column: Vec<f64> =
                    (0..4).map(|i| a[i % 2] * a[k] / size * z.powi((i / 2) as i32)).collect();
                factors.solve(&mut column);
                for i in 0..4 {
                    own[i / 2][i % 2][k] = column[i];
                }
            }
            (*node, own)
        };
        Ok(Coupling { weights: areas.iter().map(weight).collect(), areas })
    }

    /// Translation and slope of the surface under displacements of all nodes.
    pub fn motion(&self, displacements: &[[f64; 3]]) -> [Plane; 2] {
        let mut sum = [[0.0; 2]; 2];
        for (node, weights) in &self.weights {
            let [u, v, _] = displacements[*node as usize];
            for (sum, w) in sum.iter_mut().zip(weights) {
                for k in 0..2 {
                    sum[k] += w[k][0] * u + w[k][1] * v;
                }
            }
        }
        sum
    }

    /// Weights of the nodes in the translation along x and along y.
    pub fn translation(&self) -> [Vec<(u32, [f64; 3])>; 2] {
        [0, 1].map(|k| self.weights.iter().map(|(node, [w, _])| (*node, [w[k][0], w[k][1], 0.0])).collect())
    }

    /// Mean rotation about the bar's own axis under displacements of all nodes.
    pub fn turn(&self, mesh: &Mesh, displacements: &[[f64; 3]]) -> f64 {
        let weight = |[x, y, _]: &[f64; 3]| x.hypot(*y);
        let all: f64 = self.areas.iter().map(|(_, area)| weight(area)).sum();
        let middle: Plane = [0, 1].map(|k| {
            self.areas.iter().map(|(node, area)| weight(area) * mesh.nodes[*node as usize][k]).sum::<f64>()
                / all
        });
        let (mut moment, mut polar) = (0.0, 0.0);
        for (node, area) in &self.areas {
            let ([x, y, _], [u, v, _]) = (mesh.nodes[*node as usize], displacements[*node as usize]);
            let arm = [x - middle[0], y - middle[1]];
            moment += weight(area) * (arm[0] * v - arm[1] * u);
            polar += weight(area) * (arm[0] * arm[0] + arm[1] * arm[1]);
        }
        moment / polar
    }

    /// Adds a force on the translation.
    pub fn push(&self, mut case: StaticCase, force: Plane) -> StaticCase {
        for (node, [w, _]) in &self.weights {
            let own = [0, 1].map(|k| w[0][k] * force[0] + w[1][k] * force[1]);
            case = case.push(&[(*node, 1.0)], [own[0], own[1], 0.0]);
        }
        case
    }

    /// Adds a moment on the slope [N m].
    pub fn tilt(&self, mut case: StaticCase, moment: Plane) -> StaticCase {
        for (node, [_, w]) in &self.weights {
            let own = [0, 1].map(|k| w[0][k] * moment[0] + w[1][k] * moment[1]);
            case = case.push(&[(*node, 1.0)], [own[0], own[1], 0.0]);
        }
        case
    }

    /// Adds a pressure by the angle about the bar's axis, which pushes inwards.
    pub fn press(&self, mut case: StaticCase, pressure: impl Fn(f64) -> f64) -> StaticCase {
        for (node, [x, y, _]) in &self.areas {
            let p = pressure(y.atan2(*x));
            case = case.push(&[(*node, 1.0)], [-p * x, -p * y, 0.0]);
        }
        case
    }

    /// Half the sum of the sizes of the area vectors: the projected area [m^2] that carries a pressure `cos a`.
    pub fn projected(&self) -> f64 {
        0.5 * self.areas.iter().map(|(_, [x, y, _])| x.hypot(*y)).sum::<f64>()
    }
}

/// Mean rotation about z of an end face: node and its weights along x and y.
pub(crate) fn turning(mesh: &Mesh, areas: &BTreeMap<u32, [f64; 3]>) -> Result<Vec<(u32, Plane)>, FlexError> {
    let all: f64 = areas.values().map(|area| area[2].abs()).sum();
    let even: Vec<(u32, f64)> = areas
        .iter()
        .map(|(node, area)| (*node, area[2].abs() / all))
        .filter(|(_, weight)| *weight > 1e-9)
        .collect();
    let at = |node: u32| mesh.nodes[node as usize];
    let centre: Plane = [0, 1].map(|k| even.iter().map(|(node, w)| w * at(*node)[k]).sum());
    let arm = |node: u32| [at(node)[0] - centre[0], at(node)[1] - centre[1]];
    let polar: f64 = even.iter().map(|(node, w)| w * arm(*node).iter().map(|x| x * x).sum::<f64>()).sum();
    if !(all > 0.0 && polar > 0.0) {
        return Err(FlexError::Missing {
            what: "end face",
            name: "FLYWHEEL".to_owned(),
            hint: "the flywheel's end face turns the crankshaft: it needs an area",
        });
    }
    Ok(even
        .iter()
        .map(|(node, w)| {
            let [x, y] = arm(*node);
            (*node, [-w * y / polar, w * x / polar])
        })
        .collect())
}
