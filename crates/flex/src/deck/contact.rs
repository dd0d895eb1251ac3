//! Contact of a deck: pairs of surfaces with a pressure in proportion to how far they go into each other.

use crate::FlexError;
use crate::contact::ContactFace;
use crate::mesh::Mesh;
use std::collections::HashMap;
use std::fmt::Write;

/// Adds contact between bars and rings to a deck of this mesh, `stiffness` in N/m^3.
///
/// # Errors
/// [`FlexError::Missing`] for a face that no element of the mesh has.
pub(crate) fn with_contact(
    deck: &str,
    mesh: &Mesh,
    rings: &[&[ContactFace]],
    stiffness: f64,
) -> Result<String, FlexError> {
    let mut faces: HashMap<Vec<u32>, (usize, usize)> = HashMap::new();
    for (index, element) in mesh.elements.iter().enumerate() {
        for (place, face) in element.kind.faces().iter().enumerate() {
            // Faces of an element are in the order of CalculiX.
            faces.insert(sorted(face.iter().map(|k| element.nodes[*k])), (index + 1, place + 1));
        }
    }
    let mut cards = String::new();
    for (ring, own) in rings.iter().enumerate() {
        for (name, is_bar) in [("BAR", true), ("RING", false)] {
            let _ = writeln!(cards, "*SURFACE, NAME={name}_{}", ring + 1);
            for face in own.iter() {
                let nodes = if is_bar { &face.bar } else { &face.ring };
                let corners = sorted(nodes[..nodes.len() / 2].iter().copied());
                let (element, place) = faces.get(&corners).ok_or_else(|| FlexError::Missing {
                    what: "face of an element at node",
                    name: (corners[0] + 1).to_string(),
                    hint: "rings lie on faces of the mesh",
                })?;
                let _ = writeln!(cards, "{element}, S{place}");
            }
        }
    }
    // 1 N/m^3 is 1e-9 N/mm^3.
    let _ = writeln!(
        cards,
        "*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:.12e}",
        1e-9 * stiffness
    );
    for ring in 1..=rings.len() {
        let _ = writeln!(
            cards,
            "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nRING_{ring}, BAR_{ring}"
        );
    }
    Ok(deck.replacen("*STEP\n", &format!("{cards}*STEP\n"), 1))
}

fn sorted(nodes: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut nodes: Vec<u32> = nodes.collect();
    nodes.sort_unstable();
    nodes
}
