//! A bay cut out of a crankshaft, against the crankshaft as a whole.

use crate::crank::one_throw;
use lanchester_flex::FlexError;
use lanchester_flex::crank_case::{CrankCase, CrankLoad, CrankSupport, PinLoad, SurfacePeak};
use lanchester_flex::crank_mesh::{CUTS, CrankMesh, CrankMeshOptions, crank_mesh, crank_mesh_of_bay};
use lanchester_flex::crank_solve::solve_crank;
use lanchester_flex::statics::SolveOptions;
use lanchester_flex::submodel::{SolvedCrank, SubmodelCase, solve_submodel};
use lanchester_model::Engine;

const COARSE: CrankMeshOptions = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: true };

/// Two throws on three mains.
fn twin() -> Engine {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/flexible-paper");
    let text = std::fs::read_to_string(format!("{folder}/three-mains.toml")).unwrap();
    lanchester_file::read(&text).engine().unwrap()
}

/// Gas on pin 1 at rest; both pins while the crankshaft turns, in springs that differ across directions.
fn loads() -> Vec<CrankLoad> {
    let pin = |pin, force| PinLoad { pin, force };
    vec![
        CrankLoad { pins: vec![pin(1, [-65e3, 10.66e3])], ..CrankLoad::default() },
        CrankLoad {
            pins: vec![pin(1, [12e3, -5e3]), pin(2, [8e3, 30e3])],
            speed: 600.0,
            ..CrankLoad::default()
        },
    ]
}

fn solved(crank: &CrankMesh, support: &CrankSupport, loads: &[CrankLoad]) -> Vec<CrankCase> {
    solve_crank(crank, support, loads, SolveOptions::default()).unwrap()
}

fn cut_out(
    crank: &CrankMesh,
    support: &CrankSupport,
    cases: &[CrankCase],
    bay: &CrankMesh,
) -> Result<Vec<SubmodelCase>, FlexError> {
    let loads = loads();
    let whole = SolvedCrank { crank, support, loads: &loads, cases };
    solve_submodel(whole, bay, SolveOptions::default(), &|_| {})
}

/// As fine as the whole, a bay has its stresses. Without the forces of the springs on its journals some fillets are off by 1 to 13 %.
#[test]
fn bay_as_fine_as_the_whole_has_its_stresses() {
    let engine = twin();
    let crank = crank_mesh(&engine, 0, COARSE).unwrap();
    let mut same = 0;
    let support = CrankSupport::Springs { stiffness: vec![[2e8, 5e8]] };
    let cases = solved(&crank, &support, &loads());
    for (pin, fillets) in [(1, 0..4), (2, 4..8)] {
        let bay = crank_mesh_of_bay(&engine, 0, COARSE, pin).unwrap();
        let names: Vec<&str> = bay.corners.iter().map(|corner| corner.name.as_str()).collect();
        let wanted: Vec<&str> = crank.corners[fillets.clone()].iter().map(|own| own.name.as_str()).collect();
        assert_eq!(names, wanted);
        let found = cut_out(&crank, &support, &cases, &bay).unwrap();
        for (own, case) in found.iter().zip(&cases) {
            assert!(own.cut_difference < 0.05, "pin {pin}: {}", own.cut_difference);
            let peak = |peak: &SurfacePeak| peak.stress.unwrap();
            let whole = &case.peaks[fillets.clone()];
            let largest = whole.iter().map(|own| peak(own).von_mises).fold(0.0, f64::max);
            for (name, fine, whole) in
                own.result.peaks.iter().zip(whole).map(|(a, b)| (&a.name, peak(a), peak(b)))
            {
                let off = (fine.von_mises - whole.von_mises).abs() / largest;
                let apart = (0..3).map(|axis| (fine.at[axis] - whole.at[axis]).abs()).fold(0.0, f64::max);
                // Peaks at another place: the whole net has points there by the circles of the other pin.
                let most = if apart < 1e-6 { 0.002 } else { 0.05 };
                assert!(off < most, "pin {pin}, {name}: {fine:?} {whole:?}");
                same += usize::from(apart < 1e-6);
            }
        }
    }
    assert!(same >= 15, "{same} of 16 peaks are at one place");
}

/// The gain: a bay with 4 elements across its fillets in a crankshaft with 2 has the stresses of a crankshaft with 4, of which that with 2 lacks 10 %.
#[test]
fn finer_bay_has_the_stresses_of_a_finer_whole() {
    let fillets = "pin_fillet = \"6 mm\"\njournal_fillet = \"6 mm\"";
    let engine = one_throw(fillets);
    let fine = CrankMeshOptions { fillet_elements: 4, ..COARSE };
    let loads = &loads()[..1];
    let [coarse, whole] = [COARSE, fine].map(|options| crank_mesh(&engine, 0, options).unwrap());
    let [before, wanted] =
        [&coarse, &whole].map(|crank| solved(crank, &CrankSupport::Journals, loads).remove(0));
    let bay = crank_mesh_of_bay(&engine, 0, fine, 1).unwrap();
    let cases = [before];
    let own = SolvedCrank { crank: &coarse, support: &CrankSupport::Journals, loads, cases: &cases };
    let found = solve_submodel(own, &bay, SolveOptions::default(), &|_| {}).unwrap().remove(0);
    for ((fine, whole), coarse) in found.result.peaks.iter().zip(&wanted.peaks).zip(&cases[0].peaks) {
        let [fine, whole, coarse] = [fine, whole, coarse].map(|peak| peak.stress.unwrap().von_mises);
        assert!((fine / whole - 1.0).abs() < 0.01, "{fine} {whole}");
        assert!(coarse < 0.93 * fine, "{coarse} {fine}");
    }
}

#[test]
fn what_cannot_be_cut_out_is_refused() {
    let engine = twin();
    let crank = crank_mesh(&engine, 0, COARSE).unwrap();
    let bay = crank_mesh_of_bay(&engine, 0, COARSE, 1).unwrap();
    assert!(CUTS.iter().all(|cut| bay.mesh.set(cut).is_ok()));
    let free = cut_out(&crank, &CrankSupport::Free, &[], &bay).unwrap_err();
    assert!(free.to_string().contains("balanced by its inertia"), "{free}");
    let rings = CrankSupport::Rings { thickness: 5e-3, modulus: 210e9 };
    assert_eq!(cut_out(&crank, &rings, &[], &bay).unwrap_err(), FlexError::Nonlinear);
    // A bay of another crankshaft lies outside the mesh.
    let other = crank_mesh(&one_throw("pin_fillet = \"3 mm\""), 0, COARSE).unwrap();
    let outside = cut_out(&other, &CrankSupport::Journals, &[], &bay).unwrap_err();
    assert!(outside.to_string().contains("leaves the mesh"), "{outside}");
    let missing = crank_mesh_of_bay(&engine, 0, COARSE, 3).unwrap_err();
    assert!(missing.to_string().contains("crankpin 3 is needed"), "{missing}");
}
