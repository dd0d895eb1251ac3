//! Prints the decks of `validation/external/calculix`: `cargo run -p lanchester-flex --example ccx_decks -- NAME`.

use lanchester_flex::Material;
use lanchester_flex::case::StaticCase;
use lanchester_flex::deck::{Analysis, write_deck};
use lanchester_flex::element::ElementKind;
use lanchester_flex::mesh::mapped_block;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).ok_or("a name such as tetrahedra-static is needed")?;
    let (kind, analysis) = name.split_once('-').ok_or("a name such as tetrahedra-static is needed")?;
    let kind = match kind {
        "tetrahedra" => ElementKind::Tetrahedron,
        "wedges" => ElementKind::Wedge,
        "hexahedra" => ElementKind::Hexahedron,
        _ => return Err("tetrahedra, wedges or hexahedra".into()),
    };
    // A quarter of a bent, thick-walled pipe that widens: curved edges, no two elements alike.
    let mesh = mapped_block(kind, [2, 4, 5], Material::steel(), |x| {
        let radius = 0.02 + 0.012 * x[0] + 0.004 * x[2];
        let (sin, cos) = (1.5 * x[1] + 0.2 * x[2]).sin_cos();
        [radius * cos + 0.02 * x[2] * x[2], radius * sin, 0.09 * x[2]]
    });
    let base = mesh.pick(|x| x[2] < 1e-9);
    let tip: Vec<(u32, f64)> =
        mesh.pick(|x| x[2] > 0.09 - 1e-9).into_iter().map(|node| (node, 1.0)).collect();
    let each = 1.0 / tip.len() as f64;
    let tip: Vec<(u32, f64)> = tip.into_iter().map(|(node, _)| (node, each)).collect();
    let case = StaticCase { name: name.clone(), ..StaticCase::default() }
        .clamp(&base)
        .push(&tip, [900.0, -400.0, 650.0]);
    let analysis = match analysis {
        "static" => Analysis::Static,
        "modes" => Analysis::Frequency(6),
        _ => return Err("static or modes".into()),
    };
    print!("{}", write_deck(&mesh, &case, analysis)?);
    Ok(())
}
