//! Elastic bodies whose stress or frequencies are known, solved with the elements of this crate: tests and the validation page judge the elements
//! by them.

use crate::case::StaticCase;
use crate::crank_mesh::CrankMesh;
use crate::element::ElementKind;
use crate::mesh::{Mesh, mapped_block, surface, surface_areas};
use crate::modes::{ModeKind, modes};
use crate::statics::{SolveOptions, StaticSystem, node_stresses, solve_static};
use crate::{FlexError, Material};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A node is on a face or a circle within this [m].
const ON: f64 = 1e-9;

/// Stress [Pa] along y at the point D of NAFEMS' thick plate (LE10): a quarter of a plate between two ellipses, 0.6 m thick, held in its plane along
/// its outer edge and along z at half its height there, under 1 MPa on its upper face. Published: -5.38 MPa.
///
/// # Errors
/// [`FlexError`] where a direction has no elements.
pub fn thick_plate_stress(cells: [usize; 3]) -> Result<f64, FlexError> {
    let height = 0.6;
    let mesh = mapped_block(ElementKind::Hexahedron, cells, Material::steel(), |x| {
        let (sin, cos) = (FRAC_PI_2 * x[1]).sin_cos();
        let between = |inner: f64, outer: f64| inner + (outer - inner) * x[0];
        [between(2.0, 3.25) * cos, between(1.0, 2.75) * sin, height * x[2]]
    });
    let is_outer = |x: &[f64; 3]| ((x[0] / 3.25).powi(2) + (x[1] / 2.75).powi(2) - 1.0).abs() < ON;
    let outer = mesh.pick(is_outer);
    let mut case = StaticCase::default()
        .hold(&mesh.pick(|x| x[1].abs() < ON && !is_outer(x)), 1, 0.0)
        .hold(&mesh.pick(|x| x[0].abs() < ON && !is_outer(x)), 0, 0.0)
        .hold(&outer, 0, 0.0)
        .hold(&outer, 1, 0.0)
        .hold(&mesh.pick(|x| is_outer(x) && (x[2] - height / 2.0).abs() < ON), 2, 0.0);
    let is_upper = |node: &u32| mesh.nodes[*node as usize][2] > height - ON;
    let (faces, _) = surface(&mesh);
    let upper: Vec<_> = faces.into_iter().filter(|face| face.nodes.iter().all(is_upper)).collect();
    for (node, area) in surface_areas(&mesh, &upper) {
        case = case.push(&[(node, 1.0)], area.map(|area| -1e6 * area));
    }
    let solution = solve_static(&mesh, &case, SolveOptions::default())?;
    let is_point = |x: &[f64; 3]| (x[0] - 2.0).abs() < ON && x[1].abs() < ON && x[2] > height - ON;
    let point = mesh.pick(is_point).first().copied().ok_or(FlexError::Missing {
        what: "node",
        name: "D".to_owned(),
        hint: "give elements in every direction",
    })?;
    Ok(node_stresses(&mesh, &solution.displacements)[point as usize].stress.0[1])
}

/// A quarter of a thick cylinder, of one layer of elements along z, `through` of them through its wall and two more around it, which grow with the radius.
pub fn quarter_cylinder(kind: ElementKind, through: usize, [inner, outer, height]: [f64; 3]) -> Mesh {
    mapped_block(kind, [through, through + 2, 1], Material::steel(), |x| {
        let radius = inner * (outer / inner).powf(x[0]);
        let (sin, cos) = (FRAC_PI_2 * x[1]).sin_cos();
        [radius * cos, radius * sin, height * x[2]]
    })
}

/// What holds a quarter of a cylinder in its planes of symmetry, and its length.
pub fn held_quarter(mesh: &Mesh, height: f64) -> StaticCase {
    StaticCase::default()
        .hold(&mesh.pick(|x| x[1].abs() < ON), 1, 0.0)
        .hold(&mesh.pick(|x| x[0].abs() < ON), 0, 0.0)
        .hold(&mesh.pick(|x| x[2].abs() < ON || x[2] > height - ON), 2, 0.0)
}

/// The case of a quarter of a cylinder with a pressure [Pa] in its bore of this radius [m].
pub fn pressed_quarter(mesh: &Mesh, [inner, _, height]: [f64; 3], pressure: f64) -> StaticCase {
    let inside = |node: &u32| {
        (mesh.nodes[*node as usize][0].hypot(mesh.nodes[*node as usize][1]) - inner).abs() < 1e-6
    };
    let (faces, _) = surface(mesh);
    let bore: Vec<_> = faces.into_iter().filter(|face| face.nodes.iter().all(inside)).collect();
    let held = held_quarter(mesh, height);
    surface_areas(mesh, &bore)
        .into_iter()
        .fold(held, |case, (node, area)| case.push(&[(node, 1.0)], area.map(|area| -pressure * area)))
}

/// Mean hoop stress [Pa] of the nodes at a radius about z.
pub fn hoop_stress(mesh: &Mesh, displacements: &[[f64; 3]], radius: f64) -> f64 {
    let stresses = node_stresses(mesh, displacements);
    let at = mesh.nodes.iter().zip(&stresses).filter(|(x, _)| (x[0].hypot(x[1]) - radius).abs() < ON);
    let hoops: Vec<f64> = at
        .map(|(place, own)| {
            let (sin, cos) = place[1].atan2(place[0]).sin_cos();
            let [xx, yy, _, xy, ..] = own.stress.0;
            xx * sin * sin + yy * cos * cos - 2.0 * xy * sin * cos
        })
        .collect();
    hoops.iter().sum::<f64>() / hoops.len() as f64
}

/// A round bar along z with so many layers of elements.
pub fn round_bar(length: f64, radius: f64, layers: usize) -> Mesh {
    mapped_block(ElementKind::Hexahedron, [4, 4, layers], Material::steel(), |x| {
        let (p, q) = (2.0 * x[0] - 1.0, 2.0 * x[1] - 1.0);
        // Squares to circles (Shirley and Chiu): concentric squares become concentric circles.
        let (r, t) = if p.abs() >= q.abs() {
            (p, if p == 0.0 { 0.0 } else { FRAC_PI_4 * q / p })
        } else {
            (q, FRAC_PI_2 - FRAC_PI_4 * p / q)
        };
        [radius * r * t.cos(), radius * r * t.sin(), length * x[2]]
    })
}

/// Frequencies [Hz] of the torsional modes among the `count` lowest of a free round bar.
///
/// # Errors
/// As [`modes`].
pub fn torsional_frequencies(
    [length, radius]: [f64; 2],
    layers: usize,
    count: usize,
) -> Result<Vec<f64>, FlexError> {
    let options = SolveOptions { count_modes: true, ..SolveOptions::default() };
    let found = modes(&round_bar(length, radius, layers), &StaticCase::default(), count, options)?;
    let torsion = found.modes.iter().filter(|mode| mode.kind == ModeKind::Torsion);
    Ok(torsion.map(|mode| mode.frequency).collect())
}

/// Largest von Mises stress of each round corner of a shaft in pure bending about y and in torsion, over the nominal one at `diameter` [m]: of its
/// bending stress, and of the von Mises stress of its shear. The shaft stands about z, clamped at one end.
///
/// # Errors
/// As [`StaticSystem::new`].
pub fn shoulder_factors(shaft: &CrankMesh, diameter: f64) -> Result<[Vec<f64>; 2], FlexError> {
    let mesh = &shaft.mesh;
    let front = &mesh.set("FREE_END")?.nodes;
    let base = StaticCase::default().clamp(&mesh.set("FLYWHEEL")?.nodes);
    let places: Vec<[f64; 2]> =
        front.iter().map(|node| mesh.nodes[*node as usize]).map(|[x, y, _]| [x, y]).collect();
    let mean = |k: usize| places.iter().map(|place| place[k]).sum::<f64>() / places.len() as f64;
    let middle = [mean(0), mean(1)];
    let apart: Vec<[f64; 2]> = places.iter().map(|[x, y]| [x - middle[0], y - middle[1]]).collect();
    let second: f64 = apart.iter().map(|[x, _]| x * x).sum();
    let polar: f64 = apart.iter().map(|[x, y]| x * x + y * y).sum();
    let (mut bending, mut torsion) = (base.clone(), base.clone());
    // A moment and a torque of 1 kN m without any force: what differs from the shaft's own stress dies out within a diameter.
    for (node, [x, y]) in front.iter().zip(apart) {
        bending = bending.push(&[(*node, 1.0)], [0.0, 0.0, 1e3 * x / second]);
        torsion = torsion.push(&[(*node, 1.0)], [-1e3 * y / polar, 1e3 * x / polar, 0.0]);
    }
    let mut system = StaticSystem::new(mesh, &base, SolveOptions::default())?;
    let solved = system.solve(&[&bending, &torsion])?;
    let nominal = [32.0, 16.0 * 3.0f64.sqrt()].map(|k| k * 1e3 / (PI * diameter.powi(3)));
    let of = |(solution, nominal): (&crate::statics::StaticSolution, f64)| {
        let stresses = node_stresses(mesh, &solution.displacements);
        let largest = |nodes: &[u32]| {
            nodes.iter().map(|node| stresses[*node as usize].stress.von_mises()).fold(0.0, f64::max)
        };
        let round = shaft.corners.iter().filter(|corner| corner.radius > 0.0);
        round.map(|corner| largest(&corner.nodes) / nominal).collect()
    };
    Ok([of((&solved[0], nominal[0])), of((&solved[1], nominal[1]))])
}
