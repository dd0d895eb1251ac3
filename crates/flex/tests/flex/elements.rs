//! Elements against closed forms: patch tests, rigid motions, thick cylinder, plate with a hole, beam, bar in torsion.

use lanchester_flex::case::{StaticCase, rigid_motions};
use lanchester_flex::element::ElementKind;
use lanchester_flex::known_bodies::{pressed_quarter, quarter_cylinder, round_bar};
use lanchester_flex::mesh::{mapped_block, quality, surface};
use lanchester_flex::modes::{ModeKind, modes};
use lanchester_flex::sparse::{Precision, Quantity, Structure};
use lanchester_flex::statics::{SolveOptions, node_stresses, solve_static};
use lanchester_flex::{FlexError, Material};
use std::f64::consts::{FRAC_PI_2, TAU};

const STEEL: [f64; 3] = [210e9, 0.3, 7850.0];

fn steel() -> Material {
    Material::steel()
}

/// Bends the inner planes of a unit cube so that no element is a parallelepiped.
fn distorted(x: [f64; 3]) -> [f64; 3] {
    let bubble = x.iter().map(|x| x * (1.0 - x)).product::<f64>();
    std::array::from_fn(|k| x[k] + [1.6, -1.3, 1.1][k] * bubble)
}

fn close(what: &str, got: f64, wanted: f64, relative: f64) {
    assert!((got - wanted).abs() <= relative * wanted.abs(), "{what}: got {got}, wanted {wanted}");
}

fn options(precision: Precision) -> SolveOptions {
    SolveOptions { precision, ..SolveOptions::default() }
}

#[test]
fn patch_of_distorted_elements_has_the_constant_stress() {
    // Linear displacements on the surface: the same strain within, whatever the shape of the elements. The mid-side nodes are in the
    // middle of their edges, where the elements hold a linear field exactly.
    let slope = [[1.0e-3, 4e-4, -2e-4], [3e-4, -5e-4, 6e-4], [-1e-4, 2e-4, 8e-4]];
    let [lambda, mu] = steel().lame();
    let trace = lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
    for kind in ElementKind::ALL {
        let mesh = mapped_block(kind, [2, 2, 2], steel(), distorted).straightened();
        let on_surface = mesh.pick(|x| x.iter().any(|x| x.abs() < 1e-9 || (x - 1.0).abs() < 1e-9));
        assert!(on_surface.len() < mesh.nodes.len(), "some nodes are free");
        let mut case = StaticCase::default();
        let field = |x: [f64; 3], axis: usize| (0..3).map(|k| slope[axis][k] * x[k]).sum::<f64>();
        for node in &on_surface {
            for axis in 0..3 {
                case = case.hold(&[*node], axis, field(mesh.nodes[*node as usize], axis as usize));
            }
        }
        let solution = solve_static(&mesh, &case, options(Precision::Double)).unwrap();
        for (place, u) in mesh.nodes.iter().zip(&solution.displacements) {
            for axis in 0..3 {
                assert!((u[axis] - field(*place, axis)).abs() < 1e-14, "{kind:?}: displacement at {place:?}");
            }
        }
        for stress in node_stresses(&mesh, &solution.displacements) {
            for (k, (a, b)) in [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].into_iter().enumerate() {
                let wanted = mu * (slope[a][b] + slope[b][a]) + if a == b { trace } else { 0.0 };
                assert!(
                    (stress.stress.0[k] - wanted).abs() < 1e-4,
                    "{kind:?}: stress {k}: {} {wanted}",
                    stress.stress.0[k]
                );
            }
        }
    }
}

#[test]
fn rigid_motions_need_no_force_and_have_the_mass_of_the_body() {
    for kind in ElementKind::ALL {
        let mesh = mapped_block(kind, [2, 2, 2], steel(), distorted);
        let structure = Structure::new(&mesh, &[]);
        let stiffness = structure.assemble(&mesh, Quantity::Stiffness, &[]);
        let mass = structure.assemble(&mesh, Quantity::Mass, &[]);
        let largest = stiffness.diagonal().into_iter().fold(0.0, f64::max);
        for (k, motion) in rigid_motions(&mesh).iter().enumerate() {
            let x = structure.gather(motion);
            let mut f = vec![0.0; x.len()];
            stiffness.multiply(&x, &mut f);
            let force = f.iter().fold(0.0f64, |most, f| most.max(f.abs()));
            assert!(force < 2e-14 * largest, "{kind:?}: motion {k} needs {force}");
            if k < 3 {
                close("mass", mass.form(&x), STEEL[2], 1e-12);
            }
        }
    }
}

#[test]
fn assembly_and_solution_have_the_same_bits_for_any_number_of_threads() {
    let mesh =
        mapped_block(ElementKind::Wedge, [6, 5, 12], steel(), |x| [0.1 * x[0], 0.1 * x[1], 0.4 * x[2]]);
    let base = mesh.pick(|x| x[2] == 0.0);
    let tip: Vec<(u32, f64)> = mesh.pick(|x| x[2] > 0.3999).into_iter().map(|node| (node, 1.0)).collect();
    let case = StaticCase::default().clamp(&base).push(&tip, [3.0, 1.0, 2.0]);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let structure = Structure::new(&mesh, &[]);
            let matrix = structure.assemble(&mesh, Quantity::Stiffness, &[]);
            (matrix, solve_static(&mesh, &case, SolveOptions::default()).unwrap())
        })
    };
    let (one, two) = (run(1), run(2));
    assert_eq!(one.0, two.0);
    assert_eq!(one.1, two.1);
}

/// Hoop stresses at the bore of a thick cylinder under pressure within, and the worst relative errors of the radial displacement and of the
/// hoop stress through the wall.
fn lame(kind: ElementKind, through: usize) -> (f64, f64, f64) {
    // Timoshenko and Goodier, Theory of Elasticity, section 28: plane strain, pressure p at the inner radius a.
    let [a, b, height] = LAME;
    let [e, nu, _] = STEEL;
    let mesh = quarter_cylinder(kind, through, LAME);
    assert_eq!(surface(&mesh).1, 0);
    let case = pressed_quarter(&mesh, LAME, PRESSURE);
    let solution = solve_static(&mesh, &case, SolveOptions::default()).unwrap();
    let ratio = PRESSURE * a * a / (b * b - a * a);
    let moved = |r: f64| (1.0 + nu) / e * ratio * ((1.0 - 2.0 * nu) * r + b * b / r);
    let stresses = node_stresses(&mesh, &solution.displacements);
    let (mut at_bore, mut count, mut off, mut worst) = (0.0, 0.0, 0.0f64, 0.0f64);
    for (node, place) in mesh.nodes.iter().enumerate() {
        let (r, angle) = (place[0].hypot(place[1]), place[1].atan2(place[0]));
        let (sin, cos) = angle.sin_cos();
        let u = solution.displacements[node];
        off = off.max(((u[0] * cos + u[1] * sin) / moved(r) - 1.0).abs());
        let [xx, yy, _, xy, ..] = stresses[node].stress.0;
        let hoop = xx * sin * sin + yy * cos * cos - 2.0 * xy * sin * cos;
        let wanted = ratio * (1.0 + b * b / (r * r));
        worst = worst.max((hoop / wanted - 1.0).abs());
        if (r - a).abs() < 1e-9 {
            (at_bore, count) = (at_bore + hoop / wanted, count + 1.0);
        }
    }
    for k in 0..3 {
        assert!((solution.reaction[k] + solution.load[k]).abs() < 1e-9 * PRESSURE * a * height, "balance");
    }
    assert!(solution.report.residual < 1e-10);
    (at_bore / count, off, worst)
}

/// Inner and outer radius and height [m], pressure within [Pa].
const LAME: [f64; 3] = [0.02, 0.05, 0.01];
const PRESSURE: f64 = 40e6;

#[test]
fn lit_lame_thick_cylinder() {
    for kind in ElementKind::ALL {
        let [first, second, third] = [4, 8, 16].map(|through| lame(kind, through));
        for (_, moved, _) in [first, second, third] {
            assert!(moved < 1e-4, "{kind:?}: displacement {moved}");
        }
        for (hoop, ..) in [second, third] {
            close(&format!("{kind:?}: mean hoop stress at the bore"), hoop, 1.0, 1e-3);
        }
        // The worst node: stresses are extrapolated linearly from within the elements, and a node at an edge of the body has few of them. The
        // error falls with an order above 1.5, and what it falls to is zero.
        let [coarse, middle, fine] = [first.2, second.2, third.2];
        let ratio = (coarse - middle) / (middle - fine);
        assert!(ratio > 2.0f64.powf(1.4) && fine < 3e-3, "{kind:?}: {coarse} {middle} {fine}");
        let limit = fine - (middle - fine) / (ratio - 1.0);
        assert!(limit.abs() < 1e-3, "{kind:?}: the error tends to {limit}");
    }
}

#[test]
fn lit_kirsch_hole_has_three_times_the_stress() {
    // Kirsch 1898: an infinite plate under tension s along x; at the hole's edge 3 s across, -s along. The displacements of the exact
    // solution (plane strain) are given at a circle of four radii.
    let (a, far, nu, tension) = (0.01_f64, 0.04_f64, 0.3_f64, 100e6_f64);
    let mu = steel().lame()[1];
    let kappa = 3.0 - 4.0 * nu;
    let mesh = mapped_block(ElementKind::Wedge, [12, 12, 1], steel(), |x| {
        let (radius, (sin, cos)) = (a * (far / a).powf(x[0]), (FRAC_PI_2 * x[1]).sin_cos());
        [radius * cos, radius * sin, 0.002 * x[2]]
    });
    let exact = |x: [f64; 3]| {
        let (r, t) = (x[0].hypot(x[1]) / a, x[1].atan2(x[0]));
        let factor = tension * a / (8.0 * mu);
        [
            factor
                * (r * (kappa + 1.0) * t.cos() + 2.0 / r * ((1.0 + kappa) * t.cos() + (3.0 * t).cos())
                    - 2.0 / r.powi(3) * (3.0 * t).cos()),
            factor
                * (r * (kappa - 3.0) * t.sin() + 2.0 / r * ((1.0 - kappa) * t.sin() + (3.0 * t).sin())
                    - 2.0 / r.powi(3) * (3.0 * t).sin()),
        ]
    };
    let mut case = StaticCase::default();
    case = case.hold(&mesh.pick(|x| x[1].abs() < 1e-9 && x[0] < far - 1e-9), 1, 0.0);
    case = case.hold(&mesh.pick(|x| x[0].abs() < 1e-9 && x[1] < far - 1e-9), 0, 0.0);
    case = case.hold(&mesh.pick(|_| true), 2, 0.0);
    for node in mesh.pick(|x| x[0].hypot(x[1]) > far - 1e-9) {
        let moved = exact(mesh.nodes[node as usize]);
        for axis in 0..2u8 {
            case = case.hold(&[node], axis, moved[axis as usize]);
        }
    }
    let solution = solve_static(&mesh, &case, SolveOptions::default()).unwrap();
    let stresses = node_stresses(&mesh, &solution.displacements);
    let at = |x: f64, y: f64| mesh.pick(|p| (p[0] - x).abs() < 1e-9 && (p[1] - y).abs() < 1e-9)[0] as usize;
    close("stress across the load", stresses[at(0.0, a)].stress.0[0], 3.0 * tension, 0.02);
    close("stress along the load", stresses[at(a, 0.0)].stress.0[1], -tension, 0.05);
    let middle = at(0.0, a);
    close("displacement", solution.displacements[middle][1], exact(mesh.nodes[middle])[1], 1e-3);
}

#[test]
fn lit_slender_beam_bends_as_timoshenko_says() {
    // Tip force on a cantilever: F L^3/(3 E I) + F L/(k G A), k = 10 (1 + nu)/(12 + 11 nu) (Cowper 1966).
    let (length, side, force) = (0.5_f64, 0.02_f64, 100.0_f64);
    let [e, nu, _] = STEEL;
    let mesh = mapped_block(ElementKind::Hexahedron, [1, 1, 25], steel(), |x| {
        [side * (x[0] - 0.5), side * (x[1] - 0.5), length * x[2]]
    });
    let tip = mesh.pick(|x| x[2] > length - 1e-9);
    let weights: Vec<(u32, f64)> = tip.iter().map(|node| (*node, 1.0 / tip.len() as f64)).collect();
    // Held so that the end can contract: the clamp adds nothing that the beam does not have.
    let base = mesh.pick(|x| x[2] == 0.0);
    let line_x = mesh.pick(|x| x[2] == 0.0 && x[0].abs() < 1e-9);
    let line_y = mesh.pick(|x| x[2] == 0.0 && x[1].abs() < 1e-9);
    let case = StaticCase::default().hold(&base, 2, 0.0).hold(&line_x, 0, 0.0).hold(&line_y, 1, 0.0);
    let case = case.push(&weights, [force, 0.0, 0.0]);
    let solution = solve_static(&mesh, &case, SolveOptions::default()).unwrap();
    let mean =
        tip.iter().map(|node| solution.displacements[*node as usize][0]).sum::<f64>() / tip.len() as f64;
    let (area, inertia) = (side * side, side.powi(4) / 12.0);
    let shear = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    let wanted =
        force * length.powi(3) / (3.0 * e * inertia) + force * length / (shear * steel().lame()[1] * area);
    close("tip", mean, wanted, 1e-3);
    close("energy", solution.energy, force * mean / 2.0, 2e-5);
    // The same bent by its ends' inertia: a free body under opposite forces needs no support.
    let free = StaticCase { inertia_relief: true, ..StaticCase::default() }.push(&weights, [force, 0.0, 0.0]);
    let relieved = solve_static(&mesh, &free, SolveOptions::default()).unwrap();
    let acceleration = relieved.accelerations.unwrap();
    close("acceleration", acceleration[0], force / (STEEL[2] * area * length), 1e-9);
    let polar = STEEL[2] * area * length * (length * length + side * side) / 12.0;
    close("turning", acceleration[4], force * length / 2.0 / polar, 1e-6);
    assert!(relieved.reactions.iter().flatten().all(|force| force.abs() < 1e-5), "the anchors carry nothing");
}

#[test]
fn lit_free_round_bar_in_torsion() {
    // f_n = (n/2L) sqrt(G/rho), exact for a round bar: its cross-sections do not warp.
    let (length, radius) = (0.4_f64, 0.02_f64);
    let mesh = round_bar(length, radius, 16);
    let found = modes(&mesh, &StaticCase::default(), 16, SolveOptions::default()).unwrap();
    assert!(found.modes[..6].iter().all(|mode| mode.kind == ModeKind::Rigid && mode.frequency < 1.0));
    assert!(found.modes.iter().all(|mode| mode.residual < 1e-8));
    let wave = (steel().lame()[1] / STEEL[2]).sqrt();
    let torsion: Vec<f64> =
        found.modes.iter().filter(|mode| mode.kind == ModeKind::Torsion).map(|mode| mode.frequency).collect();
    close("first", torsion[0], wave / (2.0 * length), 1e-4);
    close("second", torsion[1], wave / length, 1e-4);
    // Counted by the signs of a factor, the modes that are asked for are all there is, also where the last one has a like.
    for asked in [7, 8, 9, 12] {
        let options = SolveOptions { count_modes: true, ..SolveOptions::default() };
        let counted = modes(&mesh, &StaticCase::default(), asked, options).unwrap();
        assert_eq!(counted.modes.len(), asked);
        let count = counted.count.unwrap();
        let below = found.modes.iter().filter(|mode| mode.frequency < count.below).count();
        assert_eq!((count.counted, count.found), (Some(below), below), "{asked}");
        assert_eq!(count.missing(), Some(0));
        // Bending modes 7 and 8 are one pair: between them is no gap.
        assert!(below == asked || below + 1 == asked, "{asked} {below}");
        assert!(asked != 7 || below == 6);
    }
    // Bending comes in pairs, of one frequency; Euler and Bernoulli's is an upper bound of it.
    let bending: Vec<f64> = found.modes[6..]
        .iter()
        .filter(|mode| matches!(mode.kind, ModeKind::BendingX | ModeKind::BendingY | ModeKind::Mixed))
        .map(|mode| mode.frequency)
        .collect();
    close("pair", bending[0], bending[1], 1e-6);
    let euler = 4.730_040_745f64.powi(2) / (TAU * length * length)
        * (STEEL[0] * radius * radius / (4.0 * STEEL[2])).sqrt();
    assert!(bending[0] < euler && bending[0] > 0.95 * euler, "{} {euler}", bending[0]);
}

#[test]
fn free_motion_is_named_before_anything_is_factored() {
    let mesh = mapped_block(ElementKind::Hexahedron, [1, 1, 4], steel(), |x| [0.1 * x[0], 0.1 * x[1], x[2]]);
    let ends = mesh.pick(|x| x[2] == 0.0 || x[2] == 1.0);
    let case = StaticCase::default().hold(&ends, 0, 0.0).hold(&ends, 1, 0.0);
    let error = solve_static(&mesh, &case, SolveOptions::default()).unwrap_err();
    assert!(matches!(&error, FlexError::FreeMotion { motion } if motion.contains("along z")), "{error}");
    let small = SolveOptions { memory: 1000, ..SolveOptions::default() };
    let held = case.hold(&ends[..1], 2, 0.0);
    let error = solve_static(&mesh, &held, small).unwrap_err();
    assert!(matches!(error, FlexError::Memory { .. }), "{error}");
    let mut folded = mesh.clone();
    folded.elements[2].nodes.swap(0, 1);
    assert!(matches!(quality(&folded), Err(FlexError::Inverted { element: 3, .. })));
}
