//! A crankshaft in rings with contact.

use crate::crank::one_throw;
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, CrankSupport, PinLoad};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::statics::SolveOptions;

/// With sharp corners, which is enough for contact.
fn throw() -> CrankMesh {
    let options = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: false };
    crank_mesh(&one_throw(""), 0, options).unwrap()
}

const FORCE: [f64; 2] = [-65e3, 10.66e3];

fn on_rings(crank: &CrankMesh, modulus: f64, factors: &[f64]) -> Vec<CrankCase> {
    let load = |factor: &f64| CrankLoad {
        pins: vec![PinLoad { pin: 1, force: FORCE.map(|force| factor * force) }],
        ..CrankLoad::default()
    };
    let loads: Vec<CrankLoad> = factors.iter().map(load).collect();
    let support = CrankSupport::Rings { thickness: 5e-3, modulus };
    solve_crank(crank, &support, &loads, SolveOptions::default()).unwrap()
}

/// Largest stress in the webs.
fn peak(case: &CrankCase) -> f64 {
    case.webs.iter().filter_map(|peak| peak.stress).fold(0.0, |most, stress| stress.von_mises.max(most))
}

#[test]
fn crankshaft_in_rings_is_in_balance_and_touches_them_on_one_side() {
    let crank = throw();
    let cases = on_rings(&crank, 210e9, &[1.0, 2.0, -1.0]);
    for (case, factor) in cases.iter().zip([1.0, 2.0, -1.0]) {
        let solution = &case.solution;
        for axis in 0..2 {
            let wanted = factor * FORCE[axis];
            assert!((solution.load[axis] - wanted).abs() < 1e-6, "the load is what was asked for");
            // The stiff springs of the flywheel's end leave rounding of that size in their forces.
            let rest = solution.reaction[axis] + solution.load[axis];
            assert!(rest.abs() < 1e-7 * 65e3, "axis {axis}: {rest} N");
        }
        let contact = case.contact.unwrap();
        println!("{factor}: {contact:?}, {} mm, {} MPa", 1e3 * case.largest_displacement, 1e-6 * peak(case));
        assert!((0.15..0.75).contains(&contact.closed), "no ring pulls: {contact:?}");
        assert!(contact.penetration < 0.01 * case.largest_displacement, "{contact:?}");
    }
    // Without a gap at rest the contact grows with the load: twice the load, twice the stress. The other way round it is another problem.
    assert!((cases[1].largest_displacement / cases[0].largest_displacement - 2.0).abs() < 1e-6);
    assert!((peak(&cases[1]) / peak(&cases[0]) - 2.0).abs() < 1e-6);
    assert!((cases[2].solution.energy / cases[0].solution.energy - 1.0).abs() > 1e-3);
}

#[test]
fn softer_rings_take_more_energy() {
    let crank = throw();
    let energy = |modulus: f64| on_rings(&crank, modulus, &[1.0]).remove(0).solution.energy;
    let [soft, steel, stiff] = [21e9, 210e9, 2100e9].map(energy);
    assert!(soft > steel && steel > stiff, "{soft} {steel} {stiff}");
}

#[test]
fn ring_that_is_none_is_refused() {
    let crank = throw();
    let load = CrankLoad { pins: vec![PinLoad { pin: 1, force: FORCE }], ..CrankLoad::default() };
    for (thickness, modulus) in [(0.0, 210e9), (5e-3, f64::NAN)] {
        let support = CrankSupport::Rings { thickness, modulus };
        let error =
            solve_crank(&crank, &support, std::slice::from_ref(&load), SolveOptions::default()).unwrap_err();
        assert!(matches!(error, FlexError::Number { .. }), "{error}");
    }
    let rings = CrankSupport::Rings { thickness: 5e-3, modulus: 210e9 };
    let other = CrankLoad { pins: vec![PinLoad { pin: 7, force: FORCE }], ..CrankLoad::default() };
    let error = solve_crank(&crank, &rings, &[other], SolveOptions::default()).unwrap_err();
    assert!(error.to_string().contains("PIN_7"), "{error}");
}

/// Crankshafts that stand for that of the flexible paper, 65 kN at 7 degrees: what `validate` prints.
#[test]
fn twin_of_the_flexible_paper_on_rings() {
    for (name, wanted) in [("three-mains", 0.10e-3), ("two-mains", 0.14e-3)] {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/flexible-paper");
        let text = std::fs::read_to_string(format!("{folder}/{name}.toml")).unwrap();
        let engine = lanchester_file::read(&text).engine().unwrap();
        let options = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: false };
        let crank = crank_mesh(&engine, 0, options).unwrap();
        let case = on_rings(&crank, 210e9, &[1.0]).remove(0);
        let moved = case.largest_displacement;
        println!("{name}: {} mm, {:?}", 1e3 * moved, case.contact);
        assert!((moved - wanted).abs() < 0.005e-3, "{name}: {moved}");
    }
}
