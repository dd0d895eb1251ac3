//! A crankshaft exported as a deck and run by CalculiX, where `ccx` is installed, against our own solution.

use crate::crank::one_throw;
use lanchester_flex::crank_case::{CrankLoad, CrankSupport, PinLoad, crank_cases};
use lanchester_flex::crank_mesh::{CrankMesh, CrankMeshOptions, crank_mesh};
use lanchester_flex::deck::{Analysis, write_deck};
use lanchester_flex::modes::modes;
use lanchester_flex::statics::{SolveOptions, as_node_forces, solve_static};
use std::path::PathBuf;
use std::process::{Command, Stdio};

fn throw() -> CrankMesh {
    let engine = one_throw("pin_fillet = \"6 mm\"\njournal_fillet = \"6 mm\"");
    let options = CrankMeshOptions { size: 24e-3, fillet_elements: 2, fillets: true };
    crank_mesh(&engine, 0, options).unwrap()
}

/// What `ccx` prints of a deck; none where it is not installed.
fn run(name: &str, deck: &str) -> Option<String> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("ccx-{name}"));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("case.inp"), deck).unwrap();
    let mut ccx = Command::new("ccx");
    let status = ccx.args(["-i", "case"]).current_dir(&folder).stdout(Stdio::null()).status();
    let Ok(status) = status else {
        println!("ccx is not installed: {name} is not compared");
        return None;
    };
    assert!(status.success(), "ccx stops at {name}");
    let text = std::fs::read_to_string(folder.join("case.dat")).unwrap();
    Some(text)
}

/// Rows of numbers after the line that begins with `head`.
fn rows(text: &str, head: &str) -> Vec<Vec<f64>> {
    let mut lines = text.lines().map(str::trim).skip_while(|line| !line.starts_with(head)).skip(1);
    let mut found = Vec::new();
    for line in &mut lines {
        let row: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse).collect();
        match row {
            Ok(row) if !row.is_empty() => found.push(row),
            _ if found.is_empty() => {}
            _ => break,
        }
    }
    found
}

#[test]
fn ext_ccx_static_crankshaft() {
    let crank = throw();
    let pin = PinLoad { pin: 1, force: [-65e3 * 0.992, 65e3 * 0.122] };
    let load = CrankLoad { pins: vec![pin], speed: 400.0, ..CrankLoad::default() };
    for (name, support) in [
        ("clamped", CrankSupport::ClampedEnds),
        ("springs", CrankSupport::even_springs(2e9)),
        ("journals", CrankSupport::Journals),
    ] {
        let case = crank_cases(&crank, &support, std::slice::from_ref(&load)).unwrap().remove(0);
        let case = as_node_forces(&crank.mesh, &case).unwrap();
        let deck = write_deck(&crank.mesh, &case, Analysis::Static).unwrap();
        let Some(text) = run(name, &deck) else { return };
        let ours = solve_static(&crank.mesh, &case, SolveOptions::default()).unwrap();
        // The deck asks for the energy of the body alone.
        let springs = case.springs.iter().zip(&ours.spring_forces);
        let in_springs: f64 = springs.map(|(spring, force)| force * force / (2.0 * spring.stiffness)).sum();
        let (energy, theirs) = (1e3 * (ours.energy - in_springs), rows(&text, "total internal energy")[0][0]);
        let of_node = |row: Vec<f64>| (row[0] as usize - 1, [row[1], row[2], row[3]]);
        let moved: Vec<_> = rows(&text, "displacements").into_iter().map(of_node).collect();
        assert!(moved.len() >= crank.mesh.nodes.len(), "{name}: {} displacements", moved.len());
        let largest = 1e3 * ours.displacements.iter().flatten().fold(0.0f64, |most, u| most.max(u.abs()));
        let mut off = 0.0f64;
        for (node, u) in moved.iter().filter(|(node, _)| *node < crank.mesh.nodes.len()) {
            for axis in 0..3 {
                off = off.max((1e3 * ours.displacements[*node][axis] - u[axis]).abs() / largest);
            }
        }
        println!(
            "{name}: {} nodes, energy {energy} {theirs} mJ, largest {largest} mm, off by {off:e}",
            moved.len()
        );
        assert!((energy / theirs - 1.0).abs() < 1e-6, "{name}: {energy} {theirs} mJ");
        assert!(off < 1e-6, "{name}: displacements differ by {off:e} of the largest");
    }
}

#[test]
fn ext_ccx_modes_crankshaft() {
    let crank = throw();
    let case = crank_cases(&crank, &CrankSupport::ClampedEnds, &[CrankLoad::default()]).unwrap().remove(0);
    let deck = write_deck(&crank.mesh, &case, Analysis::Frequency(4)).unwrap();
    let Some(text) = run("modes", &deck) else { return };
    let theirs = rows(&text, "MODE NO    EIGENVALUE");
    let ours = modes(&crank.mesh, &case, 4, SolveOptions::default()).unwrap();
    assert!(theirs.len() >= 4 && ours.modes.len() >= 4);
    for (mode, row) in ours.modes.iter().zip(&theirs) {
        println!("{} {}", mode.frequency, row[3]);
        assert!((mode.frequency / row[3] - 1.0).abs() < 2e-4, "{} {}", mode.frequency, row[3]);
    }
}
