//! Torsional stiffness of throws between the mid-planes of their main journals.
//!
//! A torque enters one journal and leaves the other through their surfaces, spread evenly, and the mean rotation of each surface is its twist. A round journal with torque along its
//! whole length twists less from its middle to its inner end than one with the torque in its middle; both are those of a bar:
//!
//! ```text
//! 1/k = (f_2 - f_1)/T + SUM [ l - INT c(z)^2 dz ]/(G I_p)      c: part of the torque that has entered, l: from the middle to the inner end of the surface     (book, eq. 43.16)
//! ```

use crate::FlexError;
use crate::case::StaticCase;
use crate::crank_case::{BearingSurfaces, CrankSupport, crank_support};
use crate::crank_mesh::CrankMesh;
use crate::sparse::SolveEstimate;
use crate::statics::{SolveOptions, StaticSystem};
use serde::Serialize;
use std::f64::consts::PI;

/// Torque of a case [N m].
const TORQUE: f64 = 1000.0;

/// A journal at an end of a throw.
#[derive(Debug, Clone, PartialEq)]
pub struct TwistEnd {
    /// Node set of its surface.
    pub set: String,
    /// Its mid-plane, from which stiffness counts [m].
    pub z: f64,
    /// Outer diameter, and that of its bore [m].
    pub diameters: [f64; 2],
}

/// A throw between two journals.
#[derive(Debug, Clone, PartialEq)]
pub struct TwistSpan {
    /// Index of the throw.
    pub throw: usize,
    /// In front and behind.
    pub ends: [TwistEnd; 2],
}

/// Stiffness of a throw.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ThrowTwist {
    /// Index of the throw.
    pub throw: usize,
    /// With journals that may move aside [N m/rad].
    pub free: f64,
    /// With journals whose middles stay on the axis [N m/rad].
    pub held: f64,
}

/// Weights of the rotation of a surface about the crank axis, and of a torque on it.
struct Turning {
    weights: Vec<(u32, [f64; 2])>,
    /// What the spread torque twists less than one in the mid-plane, times G [1/m^3].
    shortfall: f64,
}

impl Turning {
    fn new(
        crank: &CrankMesh,
        surfaces: &BearingSurfaces,
        end: &TwistEnd,
        rear: bool,
    ) -> Result<Turning, FlexError> {
        let areas = surfaces.areas(&end.set)?;
        let mut nodes: Vec<(f64, u32, f64)> = areas
            .iter()
            .map(|(node, [x, y, _])| (crank.mesh.nodes[*node as usize][2], *node, x.hypot(*y)))
            .filter(|(_, _, area)| *area > 0.0)
            .collect();
        nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
        if rear {
            // From the outside of the throw inwards.
            nodes.reverse();
        }
        let all: f64 = nodes.iter().map(|(.., area)| area).sum();
        let weight = |(_, node, area): &(f64, u32, f64)| {
            let [x, y, _] = crank.mesh.nodes[*node as usize];
            let square = x * x + y * y;
            (*node, [-area * y / (all * square), area * x / (all * square)])
        };
        let (mut entered, mut spread) = (0.0, 0.0);
        for pair in nodes.windows(2) {
            entered += pair[0].2 / all;
            spread += entered * entered * (pair[1].0 - pair[0].0).abs();
        }
        let inner = nodes.last().map_or(end.z, |own| own.0);
        let [outer, bore] = end.diameters;
        let polar = PI / 32.0 * (outer.powi(4) - bore.powi(4));
        Ok(Turning {
            weights: nodes.iter().map(weight).collect(),
            shortfall: ((inner - end.z).abs() - spread) / polar,
        })
    }

    fn push(&self, mut case: StaticCase, torque: f64) -> StaticCase {
        for (node, [x, y]) in &self.weights {
            case = case.push(&[(*node, 1.0)], [torque * x, torque * y, 0.0]);
        }
        case
    }

    fn rotation(&self, displacements: &[[f64; 3]]) -> f64 {
        let of = |(node, [x, y]): &(u32, [f64; 2])| {
            let [u, v, _] = displacements[*node as usize];
            x * u + y * v
        };
        self.weights.iter().map(of).sum()
    }
}

/// Stiffnesses of throws of a crankshaft; `watch` sees what factors will cost.
///
/// # Errors
/// [`FlexError`] where a surface is missing or the equations have no solution.
pub fn throw_twists(
    crank: &CrankMesh,
    spans: &[TwistSpan],
    options: SolveOptions,
    watch: &dyn Fn(&SolveEstimate),
) -> Result<Vec<ThrowTwist>, FlexError> {
    let surfaces = BearingSurfaces::new(crank);
    let turnings: Vec<[Turning; 2]> = spans
        .iter()
        .map(|span| {
            let [front, rear] = &span.ends;
            Ok([Turning::new(crank, &surfaces, front, false)?, Turning::new(crank, &surfaces, rear, true)?])
        })
        .collect::<Result<_, FlexError>>()?;
    let Some(material) = crank.mesh.materials.first() else { return Ok(Vec::new()) };
    let modulus = material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
    let stiffness = |support: &CrankSupport| -> Result<Vec<f64>, FlexError> {
        let base = crank_support(crank, &surfaces, support, 0.0)?;
        let cases: Vec<StaticCase> = turnings
            .iter()
            .map(|[front, rear]| rear.push(front.push(base.clone(), -TORQUE), TORQUE))
            .collect();
        let mut system = StaticSystem::new_watched(&crank.mesh, &base, options, watch)?;
        let mut found = Vec::new();
        for block in cases.chunks(8) {
            found.extend(system.solve(&block.iter().collect::<Vec<_>>())?);
        }
        let of = |(solution, [front, rear]): (&crate::statics::StaticSolution, &[Turning; 2])| {
            let twist = rear.rotation(&solution.displacements) - front.rotation(&solution.displacements);
            1.0 / (twist / TORQUE + (front.shortfall + rear.shortfall) / modulus)
        };
        Ok(found.iter().zip(&turnings).map(of).collect())
    };
    let (free, held) = (stiffness(&CrankSupport::Free)?, stiffness(&CrankSupport::Journals)?);
    let each = spans.iter().zip(free.into_iter().zip(held));
    Ok(each.map(|(span, (free, held))| ThrowTwist { throw: span.throw, free, held }).collect())
}
