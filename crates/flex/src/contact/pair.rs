//! Faces that lie on each other: where they press, a stiff layer carries the pressure; where they would pull, nothing.

use crate::mesh::{Mesh, face_points};
use crate::sparse::DenseTerm;
use serde::Serialize;

/// A face of a bar and the face of a ring on it, node by node.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactFace {
    /// Nodes of the bar, corners before the middles of edges.
    pub bar: Vec<u32>,
    /// Nodes of the ring at the same places.
    pub ring: Vec<u32>,
    /// Axis of the bar seen along z [m].
    pub centre: [f64; 2],
}

/// How rings and bars touch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ContactReport {
    /// Steps until no point changed between open and closed, each with a factor of its own.
    pub steps: usize,
    /// Share of the area of all rings that touches.
    pub closed: f64,
    /// Largest contact pressure [Pa].
    pub largest_pressure: f64,
    /// How far the stiff layer that stands for the contact gives way there [m].
    pub penetration: f64,
}

/// An integration point of a contact face.
#[derive(Debug, Clone, PartialEq)]
struct ContactPoint {
    face: usize,
    /// Shape functions of the nodes of the face.
    shares: [f64; 8],
    /// Outward normal of the bar, across z.
    normal: [f64; 2],
    /// Area that it stands for [m^2].
    area: f64,
}

/// All contact of a mesh.
///
/// ```text
/// g = n . (u_ring - u_bar)      p = -k min(g, 0)      energy INT k min(g, 0)^2 / 2 dA                       (book, eq. 43.14)
/// ```
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Contact {
    faces: Vec<ContactFace>,
    points: Vec<ContactPoint>,
    /// Pressure for each length that the faces go into each other [N/m^3].
    stiffness: f64,
}

impl Contact {
    pub fn new(mesh: &Mesh, faces: Vec<ContactFace>, stiffness: f64) -> Contact {
        let mut points = Vec::new();
        for (index, face) in faces.iter().enumerate() {
            let places: Vec<[f64; 3]> = face.bar.iter().map(|node| mesh.nodes[*node as usize]).collect();
            for own in face_points(&places) {
                let at = [0, 1].map(|k| own.at[k] - face.centre[k]);
                let radius = at[0].hypot(at[1]);
                let normal = at.map(|x| x / radius);
                points.push(ContactPoint { face: index, shares: own.shares, normal, area: own.area });
            }
        }
        Contact { faces, points, stiffness }
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Gap at each point [m], negative where the faces go into each other.
    pub fn gaps(&self, displacements: &[[f64; 3]]) -> Vec<f64> {
        let gap = |point: &ContactPoint| {
            let face = &self.faces[point.face];
            let apart = face.bar.iter().zip(&face.ring).zip(point.shares).map(|((bar, ring), share)| {
                let (bar, ring) = (displacements[*bar as usize], displacements[*ring as usize]);
                share * (0..2).map(|k| point.normal[k] * (ring[k] - bar[k])).sum::<f64>()
            });
            apart.sum()
        };
        self.points.iter().map(gap).collect()
    }

    /// Stiffness of the points that are closed, face by face.
    pub fn terms(&self, closed: &[bool]) -> Vec<DenseTerm> {
        let mut terms: Vec<DenseTerm> = self.faces.iter().map(empty_term).collect();
        for (point, _) in self.points.iter().zip(closed).filter(|(_, closed)| **closed) {
            let term = &mut terms[point.face];
            let size = term.unknowns.len();
            let half = size / 2;
            // Bar first, then ring, each node with x and y.
            let row: Vec<f64> = (0..size)
                .map(|k| {
                    let sign = if k < half { -1.0 } else { 1.0 };
                    sign * point.shares[(k % half) / 2] * point.normal[k % 2]
                })
                .collect();
            let stiffness = self.stiffness * point.area;
            for (j, a) in row.iter().enumerate() {
                for (i, b) in row.iter().enumerate() {
                    term.values[j * size + i] += stiffness * a * b;
                }
            }
        }
        terms
    }

    /// Derivative of the contact's energy along a motion, both by the gaps.
    pub fn slope(&self, gaps: &[f64], along: &[f64], part: f64) -> f64 {
        let each = self.points.iter().zip(gaps.iter().zip(along));
        each.map(|(point, (gap, along))| self.stiffness * point.area * (gap + part * along).min(0.0) * along)
            .sum()
    }

    pub fn report(&self, gaps: &[f64], steps: usize) -> ContactReport {
        let all: f64 = self.points.iter().map(|point| point.area).sum();
        let closed = self.points.iter().zip(gaps).filter(|(_, gap)| **gap < 0.0);
        let closed: f64 = closed.map(|(point, _)| point.area).sum();
        let penetration = gaps.iter().fold(0.0f64, |most, gap| most.max(-gap));
        ContactReport {
            steps,
            closed: closed / all,
            largest_pressure: self.stiffness * penetration,
            penetration,
        }
    }
}

fn empty_term(face: &ContactFace) -> DenseTerm {
    let nodes = face.bar.iter().chain(&face.ring);
    let unknowns: Vec<u32> = nodes.flat_map(|node| [3 * node, 3 * node + 1]).collect();
    let values = vec![0.0; unknowns.len() * unknowns.len()];
    DenseTerm { unknowns, values }
}
