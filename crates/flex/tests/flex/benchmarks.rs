//! Published benchmarks of elastic bodies.

use lanchester_flex::Material;
use lanchester_flex::case::StaticCase;
use lanchester_flex::element::ElementKind;
use lanchester_flex::known_bodies::{
    held_quarter, quarter_cylinder, thick_plate_stress, torsional_frequencies,
};
use lanchester_flex::statics::{SolveOptions, node_stresses, solve_static};

const YOUNG: f64 = 210e9;
const POISSON: f64 = 0.3;
const DENSITY: f64 = 7850.0;

/// NAFEMS, The Standard NAFEMS Benchmarks, 1990, test LE10: -5.38 MPa.
#[test]
fn lit_nafems_le10_thick_plate() {
    let found = [[4, 6, 2], [8, 12, 4], [12, 18, 6]].map(|cells| thick_plate_stress(cells).unwrap());
    // -5.505, -5.414 and -5.389 MPa: nearer with every refinement.
    let off = found.map(|stress| (stress / -5.38e6 - 1.0).abs());
    assert!(off[2] < off[1] && off[1] < off[0] && off[1] < 0.02 && off[2] < 0.005, "{found:?}");
}

/// Timoshenko and Goodier, Theory of Elasticity, section 32, in plane strain: a long cylinder with a bore that turns about its axis, its length held,
///
/// ```text
/// s_t = k rho W^2 (a^2 + b^2 + a^2 b^2/r^2 - (1 + 2 nu)/(3 - 2 nu) r^2)    s_r = k rho W^2 (a^2 + b^2 - a^2 b^2/r^2 - r^2)    k = (3 - 2 nu)/(8 (1 - nu))
/// ```
#[test]
fn lit_turning_cylinder_has_its_centrifugal_stress() {
    let [inner, outer, height, speed] = [0.02_f64, 0.1, 0.02, 1000.0];
    for kind in ElementKind::ALL {
        let mesh = quarter_cylinder(kind, 16, [inner, outer, height]);
        let case = StaticCase { speed, ..held_quarter(&mesh, height) };
        let solution = solve_static(&mesh, &case, SolveOptions::default()).unwrap();
        let stresses = node_stresses(&mesh, &solution.displacements);
        let k = (3.0 - 2.0 * POISSON) / (8.0 * (1.0 - POISSON)) * DENSITY * speed * speed;
        let (aa, bb) = (inner * inner, outer * outer);
        let by_bore = |r: f64| aa * bb / (r * r);
        let tangential =
            |r: f64| k * (aa + bb + by_bore(r) - (1.0 + 2.0 * POISSON) / (3.0 - 2.0 * POISSON) * r * r);
        let radial = |r: f64| k * (aa + bb - by_bore(r) - r * r);
        // u = r e_t, E e_t = (1 - nu^2) s_t - nu (1 + nu) s_r.
        let moved = |r: f64| {
            r / YOUNG * ((1.0 - POISSON * POISSON) * tangential(r) - POISSON * (1.0 + POISSON) * radial(r))
        };
        let (mut at_bore, mut count, mut worst) = (0.0, 0.0, 0.0f64);
        for (node, place) in mesh.nodes.iter().enumerate() {
            let r = place[0].hypot(place[1]);
            let (cos, sin) = (place[0] / r, place[1] / r);
            let u = solution.displacements[node];
            let off = (u[0] * cos + u[1] * sin) / moved(r) - 1.0;
            // As wanted of a thick ring under pressure.
            assert!(off.abs() < 1e-3, "{kind:?}: displacement at {r}: {off}");
            let [xx, yy, _, xy, ..] = stresses[node].stress.0;
            let hoop = xx * sin * sin + yy * cos * cos - 2.0 * xy * sin * cos;
            worst = worst.max((hoop - tangential(r)).abs() / tangential(inner));
            if (r - inner).abs() < 1e-9 {
                (at_bore, count) = (at_bore + hoop / tangential(inner), count + 1.0);
            }
        }
        // Both as in the thick cylinder under pressure, whose elements grow as much from one to the next.
        assert!((at_bore / count - 1.0f64).abs() < 1e-3, "{kind:?}: {}", at_bore / count);
        assert!(worst < 0.01, "{kind:?}: {worst}");
    }
}

/// f_n = (n/2L) sqrt(G/rho) of a free round bar, exact: its cross-sections do not warp.
#[test]
fn lit_free_round_bar_has_its_first_three_torsional_modes() {
    let length = 0.4_f64;
    let torsion = torsional_frequencies([length, 0.02], 24, 26).unwrap();
    let wave = (Material::steel().lame()[1] / DENSITY).sqrt();
    for n in 1..=3 {
        let off = torsion[n - 1] / (n as f64 * wave / (2.0 * length)) - 1.0;
        assert!(off.abs() < 1e-4, "{n}: {off}");
    }
}
