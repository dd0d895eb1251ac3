//! What the engine says of a crankshaft that somebody else has meshed.

use lanchester_flex::Material;
use lanchester_flex::own_mesh::OwnMeshPlan;
use lanchester_geometry::crankshaft::crankshaft;
use lanchester_model::{CrankElement, CrankElementForm, Engine};

/// What a mesh of a crankshaft must agree with.
pub(crate) fn own_mesh_plan(engine: &Engine, index: usize) -> OwnMeshPlan {
    let (given, steel) = (engine.crank_material.unwrap_or_default(), Material::steel());
    let body = engine.crank_body.as_ref();
    let material = Material {
        name: "crankshaft".to_owned(),
        youngs_modulus: given.youngs_modulus().map_or(steel.youngs_modulus, |own| own.value),
        poisson_ratio: given.poisson_ratio().map_or(steel.poisson_ratio, |own| own.value),
        density: body.map_or(steel.density, |body| body.density),
    };
    let pins = engine.throws.iter().enumerate().filter(|(_, throw)| throw.crankshaft == index).map(
        |(number, throw)| {
            let (sin, cos) = throw.angle.sin_cos();
            (number + 1, [throw.radius * cos, throw.radius * sin])
        },
    );
    let elements = engine.crank_elements(index).unwrap_or_default();
    let middle = |element: &CrankElement| match element.form {
        CrankElementForm::Journal { .. } => Some(0.5 * (element.faces[0] + element.faces[1])),
        _ => None,
    };
    let of_body: Vec<f64> = elements.iter().filter_map(middle).collect();
    let of_mains = engine.crankshafts[index].mains.clone().unwrap_or_default();
    OwnMeshPlan {
        material,
        pins: pins.collect(),
        journals: if of_body.is_empty() { of_mains } else { of_body },
        mass: crankshaft(engine, index).ok().map(|body| body.mass.mass),
    }
}
