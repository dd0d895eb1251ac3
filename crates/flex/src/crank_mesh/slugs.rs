//! Inserts and holes of counterweights.

use super::segment::refuse;
use crate::{FlexError, Material};
use lanchester_geometry::crankshaft::CrankshaftBody;
use lanchester_shape::{Edge, Point};
use std::f64::consts::FRAC_PI_2;

/// A round slug of another material, or a hole.
pub(super) struct Slug {
    pub centre: Point,
    pub radius: f64,
    pub faces: [f64; 2],
    /// Index of its material; none of a hole.
    pub material: Option<u32>,
    /// Name of the solid that holds it.
    host: String,
}

impl Slug {
    /// Whether a solid of this name between these faces holds it.
    pub fn is_in(&self, name: &str, faces: [f64; 2]) -> bool {
        name == self.host && faces[0] < self.faces[1] && self.faces[0] < faces[1]
    }

    /// Its circle, in quarters.
    pub fn edges(&self) -> Vec<Edge> {
        (0..4).map(|k| Edge::arc(self.centre, self.radius, FRAC_PI_2 * f64::from(k), FRAC_PI_2)).collect()
    }
}

/// All inserts and holes of a body; their materials follow after the first one in `materials`.
///
/// # Errors
/// [`FlexError::Mesh`] for one that comes too near to an edge of its part.
pub(super) fn slugs(body: &CrankshaftBody, materials: &mut Vec<Material>) -> Result<Vec<Slug>, FlexError> {
    let mut found = Vec::new();
    for placed in &body.parts {
        let front = placed.part.faces()[0] + placed.z;
        for insert in placed.part.inserts() {
            if placed.part.outline().nearest(insert.centre).0 < insert.radius + 0.2e-3 {
                let message = format!(
                    "an insert or hole of {:.2} mm diameter leaves less than 0.20 mm of material beside it",
                    2e3 * insert.radius
                );
                return Err(refuse(&placed.name, message, "move it away from the edge, or make it smaller"));
            }
            let material = (insert.density > 0.0).then(|| {
                let known = materials.iter().skip(1).position(|own| own.density == insert.density);
                known.map_or_else(
                    || {
                        let name = format!("insert {:.0} kg/m3", insert.density);
                        materials.push(Material { name, density: insert.density, ..materials[0].clone() });
                        materials.len() as u32 - 1
                    },
                    |place| place as u32 + 1,
                )
            });
            found.push(Slug {
                centre: insert.centre.turned(placed.turn),
                radius: insert.radius,
                faces: [front + insert.from, front + insert.to],
                material,
                host: placed.name.clone(),
            });
        }
    }
    Ok(found)
}
