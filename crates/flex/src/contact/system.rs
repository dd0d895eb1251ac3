//! Static equations with contact, by Newton's method on the points that touch.

use super::pair::{Contact, ContactFace, ContactReport};
use crate::FlexError;
use crate::case::StaticCase;
use crate::mesh::Mesh;
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, StaticSolution, StaticSystem};

/// Steps after which the contact has not settled.
const STEPS: usize = 80;

/// Steps that go the whole way: most loads need fewer than these. Those after them go as far as the energy falls, which cannot go round in circles.
const WHOLE: usize = 30;

/// Change of the displacements over their size at which points that open and close are rounding.
const SETTLED: f64 = 1e-9;

/// A mesh with supports and contact.
pub(crate) struct ContactSystem<'a> {
    system: StaticSystem<'a>,
    contact: Contact,
    closed: Vec<bool>,
}

impl<'a> ContactSystem<'a> {
    /// Assembles and factors a mesh, all contact closed.
    ///
    /// # Errors
    /// As [`StaticSystem::new`].
    pub fn new(
        mesh: &'a Mesh,
        case: &StaticCase,
        faces: Vec<ContactFace>,
        stiffness: f64,
        options: SolveOptions,
        watch: &dyn Fn(&SolveEstimate),
    ) -> Result<ContactSystem<'a>, FlexError> {
        let contact = Contact::new(mesh, faces, stiffness);
        let closed = vec![true; contact.len()];
        let system = StaticSystem::new_with(mesh, case, &contact.terms(&closed), options, watch)?;
        Ok(ContactSystem { system, contact, closed })
    }

    /// The least of the energy, which is convex and a square within each pattern of open and closed points: with the pattern of before the
    /// equations are linear, and their solution gives the next pattern.
    ///
    /// # Errors
    /// As [`StaticSystem::solve`]; [`FlexError::NoConvergence`] where the pattern does not settle.
    pub fn solve(&mut self, case: &StaticCase) -> Result<(StaticSolution, ContactReport), FlexError> {
        let mut solution = self.system.solve(&[case])?.remove(0);
        let mut at = solution.displacements.clone();
        for step in 1..=STEPS {
            let gaps = self.contact.gaps(&at);
            let closed: Vec<bool> = gaps.iter().map(|gap| *gap < 0.0).collect();
            if closed == self.closed && at == solution.displacements {
                return Ok((solution, self.contact.report(&gaps, step)));
            }
            self.system.change_terms(&self.contact.terms(&closed))?;
            self.closed = closed;
            solution = self.system.solve(&[case])?.remove(0);
            if is_close(&at, &solution.displacements) {
                return Ok((solution, self.contact.report(&gaps, step)));
            }
            at = if step <= WHOLE {
                solution.displacements.clone()
            } else {
                self.towards(&at, &gaps, &solution.displacements, case)?
            };
        }
        Err(FlexError::NoConvergence {
            what: "the contact of the rings",
            iterations: STEPS,
            residual: f64::NAN,
            needed: 0.0,
            hint: "a load that does not lift the crankshaft off its rings, or another support",
        })
    }

    /// Where the energy is least between two displacements.
    fn towards(
        &self,
        from: &[[f64; 3]],
        gaps: &[f64],
        to: &[[f64; 3]],
        case: &StaticCase,
    ) -> Result<Vec<[f64; 3]>, FlexError> {
        let way: Vec<[f64; 3]> =
            from.iter().zip(to).map(|(from, to)| std::array::from_fn(|k| to[k] - from[k])).collect();
        let along: Vec<f64> = self.contact.gaps(to).iter().zip(gaps).map(|(to, from)| to - from).collect();
        let dot = |a: &[[f64; 3]], b: &[[f64; 3]]| -> f64 {
            a.iter().zip(b).map(|(a, b)| a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).sum()
        };
        let product = self.system.without_terms(&way);
        let (start, bend) =
            (dot(&product, from) - dot(&self.system.forces(case)?, &way), dot(&product, &way));
        let slope = |part: f64| start + part * bend + self.contact.slope(gaps, &along, part);
        // The slope rises; rounding alone makes it positive at the end of a way that the pattern does not change on.
        let scale = slope(0.0).abs();
        if slope(1.0) <= 1e-9 * scale {
            return Ok(to.to_vec());
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if slope(middle) > 0.0 { high = middle } else { low = middle }
        }
        Ok(from.iter().zip(&way).map(|(from, way)| std::array::from_fn(|k| from[k] + low * way[k])).collect())
    }
}

fn is_close(a: &[[f64; 3]], b: &[[f64; 3]]) -> bool {
    let largest = b.iter().flatten().fold(0.0f64, |most, u| most.max(u.abs()));
    a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() <= SETTLED * largest)
}

#[cfg(test)]
mod tests {
    use super::super::{RingShape, add_ring};
    use super::*;
    use crate::Material;
    use crate::element::ElementKind;
    use crate::mesh::{NodeSet, mapped_block, surface, surface_areas};
    use std::f64::consts::FRAC_PI_2;

    /// Inner radius, radius of the contact, outer radius, height [m]; pressure outside [Pa].
    const SIZES: [f64; 4] = [0.02, 0.05, 0.06, 0.01];
    const PRESSURE: f64 = 50e6;

    /// A quarter of a thick tube in a quarter of a ring, plane strain, with a pressure outside: radial displacements at the bore, at both
    /// sides of the contact and outside, and how the faces touch.
    fn tube_in_ring(pressure: f64, stiffness: f64) -> ([f64; 4], ContactReport) {
        let [a, b, c, height] = SIZES;
        let steel = Material::steel();
        let mut mesh = mapped_block(ElementKind::Hexahedron, [8, 8, 1], steel.clone(), |x| {
            let radius = a * (b / a).powf(x[0]);
            let (sin, cos) = (FRAC_PI_2 * x[1]).sin_cos();
            [radius * cos, radius * sin, height * x[2]]
        });
        let radius = |at: &[f64; 3]| at[0].hypot(at[1]);
        let count = mesh.nodes.len();
        mesh.sets
            .push(NodeSet { name: "BAR".to_owned(), nodes: mesh.pick(|at| (radius(at) - b).abs() < 1e-9) });
        let (faces, _) = surface(&mesh);
        let shape = RingShape { thickness: c - b, layers: 3, material: 0 };
        let ring = add_ring(&mut mesh, &faces, "BAR", shape).unwrap();
        mesh.check().unwrap();
        let mut case = StaticCase::default();
        case = case.hold(&mesh.pick(|at| at[1].abs() < 1e-9), 1, 0.0);
        case = case.hold(&mesh.pick(|at| at[0].abs() < 1e-9), 0, 0.0);
        case = case.hold(&mesh.pick(|at| at[2].abs() < 1e-9 || at[2] > height - 1e-9), 2, 0.0);
        for (node, area) in surface_areas(&mesh, &ring.outer) {
            case = case.push(&[(node, 1.0)], area.map(|area| -pressure * area));
        }
        let mut system =
            ContactSystem::new(&mesh, &case, ring.contact, stiffness, SolveOptions::default(), &|_| {})
                .unwrap();
        let (solution, report) = system.solve(&case).unwrap();
        let mean = |is_in: &dyn Fn(usize) -> bool, r: f64| {
            let own: Vec<usize> = (0..mesh.nodes.len())
                .filter(|node| is_in(*node) && (radius(&mesh.nodes[*node]) - r).abs() < 1e-9)
                .collect();
            let moved = |node: &usize| {
                let (at, u) = (mesh.nodes[*node], solution.displacements[*node]);
                (u[0] * at[0] + u[1] * at[1]) / radius(&at)
            };
            own.iter().map(moved).sum::<f64>() / own.len() as f64
        };
        let bar = |node: usize| node < count;
        let ring = |node: usize| node >= count;
        ([mean(&bar, a), mean(&bar, b), mean(&ring, b), mean(&ring, c)], report)
    }

    /// Lame's tube from `a` to `b` with pressures within and outside, plane strain: radial displacement at `r`.
    fn lame([a, b]: [f64; 2], [within, outside]: [f64; 2], r: f64) -> f64 {
        let (e, nu) = (210e9, 0.3);
        let even = (within * a * a - outside * b * b) / (b * b - a * a);
        let rest = (within - outside) * a * a * b * b / (b * b - a * a);
        (1.0 + nu) / e * ((1.0 - 2.0 * nu) * even * r + rest / r)
    }

    #[test]
    fn ring_pressed_onto_a_tube_is_one_thick_tube() {
        // A layer of the stiffness k gives way by p/k: here 4e-5 of what moves.
        let (found, report) = tube_in_ring(PRESSURE, 1e17);
        let [a, b, c, _] = SIZES;
        for (found, r) in found.into_iter().zip([a, b, b, c]) {
            let wanted = lame([a, c], [0.0, PRESSURE], r);
            assert!((found / wanted - 1.0).abs() < 1e-4, "at {r}: {found} {wanted}");
        }
        assert!((report.closed - 1.0).abs() < 1e-12, "{report:?}");
        // Radial stress of the thick tube at the contact.
        let wanted = PRESSURE * c * c / (c * c - a * a) * (1.0 - a * a / (b * b));
        assert!((report.largest_pressure / wanted - 1.0).abs() < 0.01, "{report:?} {wanted}");
    }

    #[test]
    fn layer_of_the_contact_gives_way_by_its_stiffness() {
        let stiffness = 1e13;
        let ([_, bar, ring, _], report) = tube_in_ring(PRESSURE, stiffness);
        assert!(((bar - ring) / report.penetration - 1.0).abs() < 1e-3, "{bar} {ring} {report:?}");
        assert!((report.largest_pressure - stiffness * report.penetration).abs() < 1e-3, "{report:?}");
    }

    #[test]
    fn ring_that_is_pulled_lets_go() {
        let (found, report) = tube_in_ring(-PRESSURE, 1e16);
        let [_, b, c, _] = SIZES;
        assert!(report.closed == 0.0 && report.largest_pressure == 0.0, "{report:?}");
        assert!(found[0].abs() < 1e-15 && found[1].abs() < 1e-15, "the tube carries nothing: {found:?}");
        for (found, r) in found[2..].iter().zip([b, c]) {
            let wanted = lame([b, c], [0.0, -PRESSURE], r);
            assert!((found / wanted - 1.0).abs() < 1e-4, "at {r}: {found} {wanted}");
        }
    }
}
