//! Times of the solver on a crankshaft: `cargo bench -p lanchester-flex --bench reach -- FILE SIZE_MM FILLET_ELEMENTS [static]`.

use lanchester_flex::case::StaticCase;
use lanchester_flex::crank_mesh::{CrankMeshOptions, crank_mesh};
use lanchester_flex::modes::modes;
use lanchester_flex::statics::{SolveOptions, StaticSystem, node_stresses};
use std::time::Instant;

/// Largest memory of this process, where the system tells it.
fn memory() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM"));
    line.map_or("unknown".to_owned(), |line| line.replace("VmHWM:", "").trim().to_owned())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let (file, size, elements, only_static) = match arguments.as_slice() {
        [file, size, elements] => (file, size, elements, false),
        [file, size, elements, word] if word == "static" => (file, size, elements, true),
        _ => {
            println!("nothing measured: give FILE SIZE_MM FILLET_ELEMENTS [static]");
            return Ok(());
        }
    };
    let engine = lanchester_file::read(&std::fs::read_to_string(file)?)
        .engine()
        .ok_or("the engine file has mistakes")?;
    let options = CrankMeshOptions {
        size: 1e-3 * size.parse::<f64>()?,
        fillet_elements: elements.parse()?,
        fillets: true,
    };
    let start = Instant::now();
    let crank = crank_mesh(&engine, 0, options)?;
    println!(
        "mesh {:.2} s: {} nodes, {} wedges",
        start.elapsed().as_secs_f64(),
        crank.quality.nodes,
        crank.quality.elements[1]
    );
    let mesh = &crank.mesh;
    let pin = mesh.set("PIN_1")?;
    let weight = 1.0 / pin.nodes.len() as f64;
    let load: Vec<(u32, f64)> = pin.nodes.iter().map(|node| (*node, weight)).collect();
    let ends = [mesh.set("FREE_END")?, mesh.set("FLYWHEEL")?].map(|set| set.nodes.clone()).concat();
    let case = StaticCase { name: "clamped ends".to_owned(), ..StaticCase::default() }
        .clamp(&ends)
        .push(&load, [-65e3, 0.0, 0.0]);
    let start = Instant::now();
    let mut system = StaticSystem::new(mesh, &case, SolveOptions::default())?;
    println!("assembled and factored {:.2} s", start.elapsed().as_secs_f64());
    let solution = &system.solve(&[&case])?[0];
    println!("solved {:.2} s after the start: {:?}", start.elapsed().as_secs_f64(), solution.report);
    let stresses = node_stresses(mesh, &solution.displacements);
    println!(
        "stresses {:.2} s after the start; energy {:.6} J",
        start.elapsed().as_secs_f64(),
        solution.energy
    );
    for corner in &crank.corners {
        let peak =
            corner.nodes.iter().map(|node| stresses[*node as usize].stress.von_mises()).fold(0.0, f64::max);
        println!("  {}: {:.1} MPa", corner.name, 1e-6 * peak);
    }
    let start = Instant::now();
    let more = vec![&case; 8];
    system.solve(&more)?;
    println!("eight more load cases {:.3} s", start.elapsed().as_secs_f64());
    println!("largest memory so far {}", memory());
    drop(system);
    if only_static {
        return Ok(());
    }
    let start = Instant::now();
    let found = modes(mesh, &StaticCase::default(), 16, SolveOptions::default())?;
    println!(
        "ten modes beyond the rigid ones {:.2} s, basis {}, factor {:.2e} entries {:.2e} operations",
        start.elapsed().as_secs_f64(),
        found.basis,
        found.factor_entries as f64,
        found.factor_operations
    );
    println!("largest memory {}", memory());
    for mode in &found.modes {
        println!("  {:.2} Hz {:?} residual {:.1e}", mode.frequency, mode.kind, mode.residual);
    }
    Ok(())
}
