//! Springs with stiffness per journal and direction.

use crate::crank::one_throw;
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, CrankSupport, PinLoad, crank_cases};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::statics::SolveOptions;

fn throw() -> CrankMesh {
    let options = CrankMeshOptions { size: 20e-3, fillet_elements: 2, fillets: false };
    crank_mesh(&one_throw(""), 0, options).unwrap()
}

fn load(force: [f64; 2], turn: f64) -> CrankLoad {
    CrankLoad { pins: vec![PinLoad { pin: 1, force }], turn, ..CrankLoad::default() }
}

fn solve(
    crank: &CrankMesh,
    stiffness: &[[f64; 2]],
    loads: &[CrankLoad],
) -> Result<Vec<CrankCase>, FlexError> {
    let support = CrankSupport::Springs { stiffness: stiffness.to_vec() };
    solve_crank(crank, &support, loads, SolveOptions::default())
}

#[test]
fn one_stiffness_is_that_of_every_journal() {
    let crank = throw();
    let cases = |stiffness: &[[f64; 2]]| {
        let support = CrankSupport::Springs { stiffness: stiffness.to_vec() };
        crank_cases(&crank, &support, &[load([-1e4, 2e3], 0.7)]).unwrap()
    };
    assert_eq!(cases(&[[2e9; 2]]), cases(&[[2e9; 2], [2e9; 2]]));
    // Two journals, two directions, the flywheel's end.
    assert_eq!(cases(&[[2e9; 2]])[0].springs.len(), 2 * 2 + 2);
}

/// Soft springs carry nearly all the energy of a force F along them: F^2/(2 (k_1 + k_2)), shared evenly by a throw in the middle.
#[test]
fn springs_keep_to_the_block_as_the_crankshaft_turns() {
    let crank = throw();
    let (soft, stiff, force) = (2e6, 2e9, 1e4);
    for turn in [0.0, 0.5, -2.0, std::f64::consts::FRAC_PI_2] {
        let (sin, cos) = f64::sin_cos(turn);
        // A force along x of the block, seen from the crankshaft.
        let case =
            solve(&crank, &[[soft, stiff]], &[load([force * cos, -force * sin], turn)]).unwrap().remove(0);
        let wanted = force * force / (2.0 * 2.0 * soft);
        let ratio = case.solution.energy / wanted;
        // What the body itself and its turning in the springs take.
        assert!((1.0..1.05).contains(&ratio), "turn {turn}: {ratio}");
        let across =
            solve(&crank, &[[soft, stiff]], &[load([force * sin, force * cos], turn)]).unwrap().remove(0);
        assert!(
            across.solution.energy < 0.05 * wanted,
            "turn {turn}: a force along y meets the stiff springs"
        );
    }
}

#[test]
fn loads_at_several_angles_are_as_each_alone() {
    let crank = throw();
    let stiffness = [[3e8, 1e8], [2e8, 4e8]];
    let loads = [load([-1e4, 2e3], 0.3), load([-2e4, 0.0], 1.1), load([5e3, 5e3], 0.3)];
    let together = solve(&crank, &stiffness, &loads).unwrap();
    for (case, load) in together.iter().zip(&loads) {
        let alone = solve(&crank, &stiffness, std::slice::from_ref(load)).unwrap().remove(0);
        let ratio = case.solution.energy / alone.solution.energy;
        // Solved to a residual of 1e-10.
        assert!((ratio - 1.0).abs() < 1e-8, "{ratio}");
        for axis in 0..2 {
            let rest = case.solution.reaction[axis] + case.solution.load[axis];
            assert!(rest.abs() < 1e-9 * 2e4, "axis {axis}: {rest} N");
        }
    }
    // The softer journal moves more, and gives the softer case.
    let even = solve(&crank, &[[2e8; 2]], &loads[..1]).unwrap().remove(0);
    assert!((even.solution.energy / together[0].solution.energy - 1.0).abs() > 0.01);
}

#[test]
fn stiffness_that_is_none_or_of_no_journal_is_refused() {
    let crank = throw();
    let refused = |stiffness: &[[f64; 2]]| solve(&crank, stiffness, &[load([1e4, 0.0], 0.0)]).unwrap_err();
    let count = refused(&[[1e9; 2]; 3]).to_string();
    assert!(count.contains("1 for all journals, or 2") && count.contains("got 3"), "{count}");
    assert!(matches!(refused(&[[-1.0, 1e9]]), FlexError::Number { .. }));
    // A journal of stiffness 0 is not held: nothing keeps the crankshaft from swinging about the other one.
    assert!(matches!(refused(&[[1e9; 2], [0.0; 2]]), FlexError::FreeMotion { .. }));
}
