//! Reduced models against the full one with the same rigid interfaces, made independently as dense matrices.

use lanchester_flex::element::ElementKind;
use lanchester_flex::mesh::{Mesh, NodeSet, mapped_block, quality};
use lanchester_flex::reduction::{Interface, ReducedModel, Reduction, ReductionOptions, interfaces, reduce};
use lanchester_flex::sparse::{Quantity, Structure, SymmetricMatrix};
use lanchester_flex::{FlexError, Material};
use std::f64::consts::TAU;

/// A cranked bar, so that bending, torsion and axial motion are coupled.
fn bar() -> Mesh {
    let length = 0.3;
    let mut mesh = mapped_block(ElementKind::Wedge, [1, 1, 8], Material::steel(), |[x, y, z]| {
        let out = 0.05 * (std::f64::consts::PI * z).sin().powi(2);
        [0.03 * (x - 0.5) + out, 0.024 * (y - 0.5), length * z]
    });
    for (name, from, to) in [("MAIN_1", 0.0, 0.01), ("PIN_1", 0.14, 0.16), ("MAIN_2", 0.29, 0.3)] {
        let nodes = mesh.pick(|at| at[2] > from - 1e-9 && at[2] < to + 1e-9);
        mesh.sets.push(NodeSet { name: name.to_owned(), nodes });
    }
    mesh
}

fn reduced(mesh: &Mesh, modes: usize) -> (Vec<Interface>, Reduction) {
    let names: Vec<String> = mesh.sets.iter().map(|set| set.name.clone()).collect();
    let own = interfaces(mesh, &names).unwrap();
    let options = ReductionOptions { modes, ..ReductionOptions::default() };
    let reduction = reduce(mesh, &own, options).unwrap();
    (own, reduction)
}

/// Stiffness and mass of the full mesh with rigid interfaces: coordinates of the interfaces, then every free unknown of every node, dense.
struct Dense {
    size: usize,
    stiffness: Vec<f64>,
    mass: Vec<f64>,
}

fn dense(mesh: &Mesh, own: &[Interface]) -> Dense {
    let structure = Structure::new(mesh, &[]);
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut bound = vec![false; mesh.nodes.len()];
    for interface in own {
        for axis in 0..6 {
            let mut field = vec![[0.0; 3]; mesh.nodes.len()];
            for node in &interface.nodes {
                bound[*node as usize] = true;
                field[*node as usize] = interface.motion(axis, mesh.nodes[*node as usize]);
            }
            columns.push(structure.gather(&field));
        }
    }
    for node in (0..mesh.nodes.len()).filter(|node| !bound[*node]) {
        for axis in 0..3 {
            let mut field = vec![[0.0; 3]; mesh.nodes.len()];
            field[node][axis] = 1.0;
            columns.push(structure.gather(&field));
        }
    }
    let size = columns.len();
    let project = |matrix: &SymmetricMatrix| {
        let mut dense = vec![0.0; size * size];
        let mut image = vec![0.0; matrix.size()];
        for (j, column) in columns.iter().enumerate() {
            matrix.multiply(column, &mut image);
            for (i, row) in columns.iter().enumerate() {
                dense[i * size + j] = row.iter().zip(&image).map(|(a, b)| a * b).sum();
            }
        }
        dense
    };
    Dense {
        size,
        stiffness: project(&structure.assemble(mesh, Quantity::Stiffness, &[])),
        mass: project(&structure.assemble(mesh, Quantity::Mass, &[])),
    }
}

impl Dense {
    /// Frequencies [Hz], rising: the same generalised problem, all coordinates kept.
    fn frequencies(&self, springs: &[(usize, f64)]) -> Vec<f64> {
        let model = ReducedModel {
            points: Vec::new(),
            frequencies: vec![0.0; self.size],
            stiffness: self.stiffness.clone(),
            mass: self.mass.clone(),
            gyroscopic: Vec::new(),
            centrifugal: Vec::new(),
            centrifugal_load: Vec::new(),
            euler_load: Vec::new(),
        };
        model.with_springs(springs).modes().iter().map(|mode| mode.frequency).collect()
    }

    /// Gauss with pivots: a third way to a static answer.
    fn solve(&self, springs: &[(usize, f64)], side: &[(usize, f64)]) -> Vec<f64> {
        let size = self.size;
        let mut a = self.stiffness.clone();
        for (k, stiffness) in springs {
            a[k * (size + 1)] += stiffness;
        }
        let mut b = vec![0.0; size];
        for (k, force) in side {
            b[*k] += force;
        }
        for k in 0..size {
            let best =
                (k..size).max_by(|p, q| a[p * size + k].abs().total_cmp(&a[q * size + k].abs())).unwrap();
            for column in 0..size {
                a.swap(k * size + column, best * size + column);
            }
            b.swap(k, best);
            for row in k + 1..size {
                let factor = a[row * size + k] / a[k * size + k];
                if factor != 0.0 {
                    for column in k..size {
                        a[row * size + column] -= factor * a[k * size + column];
                    }
                    b[row] -= factor * b[k];
                }
            }
        }
        for k in (0..size).rev() {
            let sum: f64 = (k + 1..size).map(|column| a[k * size + column] * b[column]).sum();
            b[k] = (b[k] - sum) / a[k * size + k];
        }
        b
    }
}

/// Springs on displacements of both mains and on the rotation of the second: what holds the bar.
const SPRINGS: [(usize, f64); 6] = [(0, 2e8), (1, 2e8), (12, 3e8), (13, 3e8), (14, 1e8), (17, 4e5)];

#[test]
fn static_response_is_that_of_the_full_model() {
    let mesh = bar();
    let (own, reduction) = reduced(&mesh, 4);
    let full = dense(&mesh, &own);
    let size = reduction.model.size();
    assert_eq!(size, 22);
    // The reduced matrices as a dense system of their own.
    let held = Dense { size, stiffness: reduction.model.stiffness.clone(), mass: Vec::new() };
    for (coordinate, force) in [(6, -65e3), (7, 10.7e3), (8, 3e3), (9, 150.0), (10, 90.0), (11, -200.0)] {
        let [ours, theirs] =
            [held.solve(&SPRINGS, &[(coordinate, force)]), full.solve(&SPRINGS, &[(coordinate, force)])];
        let largest = theirs[..18].iter().fold(0.0f64, |most, q| most.max(q.abs()));
        for k in 0..18 {
            assert!(
                (ours[k] - theirs[k]).abs() < 1e-8 * largest,
                "{coordinate} {k}: {} {}",
                ours[k],
                theirs[k]
            );
        }
        // Every free node, too.
        let moved = reduction.displacements(&ours);
        let bound: Vec<u32> = own.iter().flat_map(|interface| interface.nodes.clone()).collect();
        let inner = (0..mesh.nodes.len()).filter(|node| !bound.contains(&(*node as u32)));
        for (place, node) in inner.enumerate() {
            for axis in 0..3 {
                let wanted = theirs[18 + 3 * place + axis];
                assert!((moved[node][axis] - wanted).abs() < 1e-8 * largest, "node {node}");
            }
        }
    }
    assert!(reduction.residual < 1e-11, "{}", reduction.residual);
}

#[test]
fn frequencies_are_those_of_the_full_model_free_and_on_springs() {
    let mesh = bar();
    // Modes up to five times the highest frequency that counts; with 16 of them, up to 23 kHz, 0.1 % is
    // kept up to 3.2 kHz only.
    let (own, reduction) = reduced(&mesh, 40);
    let full = dense(&mesh, &own);
    let highest = reduction.model.frequencies[39] / 5.0;
    let size = reduction.model.size();
    for springs in [&[][..], &SPRINGS] {
        let wanted = full.frequencies(springs);
        let found = reduction.model.with_springs(springs).modes();
        let mut compared = 0;
        for (mode, wanted) in found.iter().zip(&wanted).filter(|(_, wanted)| **wanted < highest) {
            // By Rayleigh's bound a reduced model is never softer.
            let off = mode.frequency - wanted;
            assert!(
                off > -1e-6 * highest && off < 1e-3 * wanted + 1e-6 * highest,
                "{} {wanted}",
                mode.frequency
            );
            compared += 1;
        }
        assert!(compared >= 12, "{compared} of {size}");
        let rigid = found.iter().take_while(|mode| mode.frequency < 1e-6 * highest).count();
        assert_eq!(rigid, if springs.is_empty() { 6 } else { 0 });
        for mode in &found {
            let q = &mode.coordinates;
            let modal: f64 =
                (0..size * size).map(|k| q[k / size] * reduction.model.mass[k] * q[k % size]).sum();
            assert!((modal - 1.0).abs() < 1e-9, "{modal}");
        }
    }
    // Fixed-interface frequencies: the full model with every reference point held by rigid springs.
    let rigid: Vec<(usize, f64)> = (0..18).map(|k| (k, 1e16)).collect();
    for (ours, wanted) in reduction.model.frequencies.iter().zip(full.frequencies(&rigid)) {
        assert!((ours / wanted - 1.0).abs() < 1e-5, "{ours} {wanted}");
    }
}

#[test]
fn rigid_motions_carry_mass_inertia_and_the_turning_body() {
    let mesh = bar();
    let (own, Reduction { model, .. }) = reduced(&mesh, 6);
    let body = quality(&mesh).unwrap();
    let size = model.size();
    // A rigid motion about the origin in the coordinates of the points.
    let about = Interface { name: String::new(), point: [0.0; 3], nodes: Vec::new() };
    let motion = |axis: usize| {
        let mut q = vec![0.0; size];
        for (k, interface) in own.iter().enumerate() {
            q[6 * k..6 * k + 3].copy_from_slice(&about.motion(axis, interface.point));
            if axis > 2 {
                q[6 * k + axis] = 1.0;
            }
        }
        q
    };
    let form = |matrix: &[f64], a: &[f64], b: &[f64]| {
        (0..size * size).map(|k| a[k / size] * matrix[k] * b[k % size]).sum::<f64>()
    };
    let along = |load: &[f64], a: &[f64]| load.iter().zip(a).map(|(f, a)| f * a).sum::<f64>();
    let rigid: Vec<Vec<f64>> = (0..6).map(motion).collect();
    let stiff = model.stiffness.iter().fold(0.0f64, |most, k| most.max(k.abs()));
    for (axis, q) in rigid.iter().enumerate() {
        assert!(form(&model.stiffness, q, q).abs() < 1e-9 * stiff, "axis {axis}");
        let wanted = if axis < 3 { body.mass } else { body.inertia[axis - 3] };
        assert!((form(&model.mass, q, q) / wanted - 1.0).abs() < 1e-9, "axis {axis}");
    }
    let [x, y, _] = body.centre;
    // Translation along x and y: Coriolis couples them, the centrifugal matrix is the mass, its load the first moment.
    assert!((form(&model.gyroscopic, &rigid[0], &rigid[1]) / -body.mass - 1.0).abs() < 1e-9);
    assert!((form(&model.gyroscopic, &rigid[1], &rigid[0]) / body.mass - 1.0).abs() < 1e-9);
    assert!((form(&model.centrifugal, &rigid[0], &rigid[0]) / body.mass - 1.0).abs() < 1e-9);
    assert!(form(&model.centrifugal, &rigid[2], &rigid[2]).abs() < 1e-12);
    assert!((along(&model.centrifugal_load, &rigid[0]) / (body.mass * x) - 1.0).abs() < 1e-9);
    assert!((along(&model.euler_load, &rigid[0]) + body.mass * y).abs() < 1e-12);
    assert!((along(&model.euler_load, &rigid[5]) / body.inertia[2] - 1.0).abs() < 1e-9);
    assert!((0..size * size).all(|k| {
        let (row, column) = (k / size, k % size);
        (model.gyroscopic[k] + model.gyroscopic[column * size + row]).abs() < 1e-12
    }));
}

#[test]
fn a_model_is_saved_and_read_again_and_damage_is_refused() {
    let mesh = bar();
    let (_, Reduction { model, .. }) = reduced(&mesh, 3);
    let bytes = model.to_npz();
    assert_eq!(ReducedModel::from_npz(&bytes).unwrap(), model);
    assert_eq!(model.to_npz(), bytes, "the same model is the same file");
    assert!(matches!(ReducedModel::from_npz(&bytes[..bytes.len() / 2]), Err(FlexError::File { .. })));
    assert!(matches!(ReducedModel::from_npz(b"PK"), Err(FlexError::File { .. })));
    let other = lanchester_flex::reduction::write_npz(&[]);
    let error = ReducedModel::from_npz(&other).unwrap_err();
    assert!(error.to_string().contains("names"), "{error}");
}

#[test]
fn interfaces_that_are_none_are_refused() {
    let mut mesh = bar();
    let none = reduce(&mesh, &[], ReductionOptions::default()).unwrap_err();
    assert!(matches!(none, FlexError::Number { .. }), "{none}");
    let missing = interfaces(&mesh, &["PIN_9".to_owned()]).unwrap_err();
    assert!(matches!(missing, FlexError::Missing { .. }), "{missing}");
    mesh.sets.push(NodeSet { name: "TWICE".to_owned(), nodes: mesh.sets[0].nodes.clone() });
    let taken = interfaces(&mesh, &["MAIN_1".to_owned(), "TWICE".to_owned()]).unwrap_err();
    assert!(matches!(taken, FlexError::Number { .. }), "{taken}");
    let (own, reduction) = reduced(&bar(), 2);
    assert!(TAU * reduction.model.frequencies[0] > 0.0 && own.len() == 3);
    let most = ReductionOptions { modes: 100_000, ..ReductionOptions::default() };
    assert!(matches!(reduce(&bar(), &own, most), Err(FlexError::Number { .. })));
    let small = ReductionOptions { memory: 1000, ..ReductionOptions::default() };
    assert!(matches!(reduce(&bar(), &own, small), Err(FlexError::Memory { .. })));
}
