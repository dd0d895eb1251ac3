//! Counterweights without a shape: their centrifugal forces, and where they go.

use crate::crank::one_throw;
use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_case::{BearingSurfaces, CrankCase, CrankLoad, CrankSupport, crank_support};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh, crank_mesh_of_bay};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::statics::{SolveOptions, as_node_forces};
use lanchester_model::Engine;

const COARSE: CrankMeshOptions = CrankMeshOptions { size: 16e-3, fillet_elements: 2, fillets: false };
const FILLETS: &str = "pin_fillet = \"3 mm\"\njournal_fillet = \"3 mm\"\n";
/// 4000 rpm.
const SPEED: f64 = 400.0 * std::f64::consts::PI / 3.0;

fn weight(keys: &str) -> Engine {
    one_throw(&format!("{FILLETS}[[counterweight]]\n{keys}\nunbalance = \"0.01 kg m\"\n"))
}

fn turning(crank: &CrankMesh) -> CrankCase {
    let load = CrankLoad { speed: SPEED, ..CrankLoad::default() };
    solve_crank(crank, &CrankSupport::Journals, &[load], SolveOptions::default()).unwrap().remove(0)
}

/// The forces on nodes have the resultant and the moment of one force at the plane of the weight, through the crank axis.
#[test]
fn forces_have_the_resultant_and_the_moment_of_the_weight() {
    for (keys, place) in [
        ("web = 1", "web 1"),
        ("web = 2\nangle = \"37 deg\"", "web 2"),
        ("z = \"-20 mm\"\nangle = \"100 deg\"", "web 1"),
        ("throw = 1", "web 1 and web 2"),
        ("z = \"5 mm\"", "web 1 and web 2"),
        ("z = \"90 mm\"\nangle = \"-60 deg\"", "end face FLYWHEEL"),
        ("z = \"-50 mm\"", "end face FREE_END"),
    ] {
        let engine = weight(keys);
        let crank = crank_mesh(&engine, 0, COARSE).unwrap();
        let [own] = &crank.mesh.weights[..] else { panic!("{keys}: one weight") };
        assert_eq!(own.place, place, "{keys}");
        let given = &engine.counterweights[0];
        let wanted = [given.unbalance * given.angle.cos(), given.unbalance * given.angle.sin(), 0.0];
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for (node, f) in &own.forces {
            let [x, y, z] = crank.mesh.nodes[*node as usize];
            (0..3).for_each(|k| force[k] += f[k]);
            let own = [y * f[2] - z * f[1], z * f[0] - x * f[2], x * f[1] - y * f[0]];
            (0..3).for_each(|k| moment[k] += own[k]);
        }
        let arm = [-given.z * wanted[1], given.z * wanted[0], 0.0];
        for k in 0..3 {
            // Rounding of some thousand terms of 1e-2 kg m and 1e-3 kg m2 at most.
            assert!((force[k] - wanted[k]).abs() < 1e-14, "{keys}: force {force:?} {wanted:?}");
            assert!((moment[k] - arm[k]).abs() < 1e-14, "{keys}: moment {moment:?} {arm:?}");
        }
    }
}

/// Two journals share the force by the lever, as in the closed form: their means are held in the middle of their surfaces.
#[test]
fn journals_carry_a_weight_by_the_lever() {
    let plain = crank_mesh(&one_throw(FILLETS), 0, COARSE).unwrap();
    let bare = turning(&plain);
    let middle = 14e-3 + 20e-3 + 12.5e-3;
    for (keys, z) in [("web = 1", -24e-3), ("throw = 1", 0.0), ("z = \"90 mm\"\nangle = \"180 deg\"", 90e-3)]
    {
        let crank = crank_mesh(&weight(keys), 0, COARSE).unwrap();
        assert!(crank.mesh.nodes == plain.mesh.nodes);
        let case = turning(&crank);
        let force = -0.01 * SPEED * SPEED;
        for (axis, wanted) in [force, 0.0].into_iter().enumerate() {
            let of = |case: &CrankCase, journal: usize| case.solution.spring_forces[2 * journal + axis];
            for (journal, share) in [(0, 0.5 - 0.5 * z / middle), (1, 0.5 + 0.5 * z / middle)] {
                let own = of(&case, journal) - of(&bare, journal);
                // The solver's residual, 1e-10 of all forces, some 4e3 N, which rigid springs lift to some 1e-6 of them.
                assert!((own + share * wanted).abs() < 1e-5 * force.abs(), "{keys} {journal} {axis}: {own}");
            }
        }
    }
}

/// A weight as a part and the same unbalance without a shape: fillets see much the same.
#[test]
fn fillets_see_much_the_same_with_and_without_the_shape() {
    let part = |web: usize| {
        format!(
            "[[counterweight]]\nweb = {web}\n[counterweight.shape]\nthickness = \"20 mm\"\noutline = [{{ x = \"33 mm\", y = \"-36 mm\" }}, {{ x = \"72 mm\", y = \"-30 mm\" }}, {{ x = \"72 mm\", y = \"30 mm\" }}, {{ x = \"33 mm\", y = \"36 mm\" }}]\n"
        )
    };
    let shaped = one_throw(&format!("{FILLETS}{}{}", part(1), part(2)));
    let plain = shaped.with(|parts| parts.counterweights.iter_mut().for_each(|own| own.part = None)).unwrap();
    let bare = shaped.with(|parts| parts.counterweights.clear()).unwrap();
    let options = CrankMeshOptions { size: 12e-3, fillet_elements: 2, fillets: true };
    let peaks = |engine: &Engine| -> Vec<f64> {
        let case = turning(&crank_mesh(engine, 0, options).unwrap());
        case.peaks.iter().map(|peak| peak.stress.unwrap().von_mises).collect()
    };
    let (with, without, none) = (peaks(&shaped), peaks(&plain), peaks(&bare));
    for ((with, without), none) in with.iter().zip(&without).zip(&none) {
        // Without its counterweights the crankshaft has some twice the stress. A shape stiffens its web too, and its force enters along the web's edge: that makes
        // 6.2 % of what the counterweight does.
        assert!(none - with > 0.9 * with, "{with} {none}");
        assert!((without - with).abs() < 0.08 * (none - with), "{with} {without} {none}");
    }
}

/// A deck without a centrifugal field of its own has them as forces on nodes; a bay has the weights of its webs.
#[test]
fn decks_and_bays_have_the_weights() {
    let crank = crank_mesh(&weight("web = 1"), 0, COARSE).unwrap();
    let support = crank_support(&crank, &BearingSurfaces::new(&crank), &CrankSupport::Journals, 0.0).unwrap();
    let case = StaticCase { speed: SPEED, ..support };
    let forces = as_node_forces(&crank.mesh, &case).unwrap();
    let sum: f64 = forces.forces.iter().map(|own| own.force[0]).sum();
    let [x, ..] = crank.quality.centre;
    let wanted = SPEED * SPEED * (crank.quality.mass * x - 0.01);
    // The mass matrix is exact for straight elements alone; those of the bars are bent.
    assert!((sum / wanted - 1.0).abs() < 1e-4, "{sum} {wanted}");
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/in-line-4-crank-by-elements.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let more = "\n[[counterweight]]\nweb = 3\nunbalance = \"0.01 kg m\"\n[[counterweight]]\nweb = 6\nunbalance = \"0.01 kg m\"\n";
    let engine = lanchester_file::read(&format!("{text}{more}")).engine().unwrap();
    let bay = crank_mesh_of_bay(&engine, 0, CrankMeshOptions { size: 24e-3, ..COARSE }, 2).unwrap();
    let names: Vec<&str> = bay.weights.iter().map(|own| own.place.as_str()).collect();
    assert_eq!(names, ["web 3"]);
}
