//! A mesh and a case as a deck.

use crate::FlexError;
use crate::case::StaticCase;
use crate::element::ElementKind;
use crate::mesh::Mesh;
use std::fmt::Write;

/// What `ccx` is to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Analysis {
    /// The static case.
    Static,
    /// So many natural modes with the supports of the case.
    Frequency(usize),
}

/// The deck of a case: nodes, elements, sets, materials, supports and loads; the results asked for are displacements and reactions of all
/// nodes, stresses at the integration points and the energy. A spring on a weighted sum of displacements is an equation between them and a
/// reference node of its own, on which a spring element acts; the reference nodes follow those of the mesh.
///
/// # Errors
/// [`FlexError::Missing`] where the case has what the deck cannot say, inertia relief or a turning body:
/// [`crate::statics::as_node_forces`] gives these as forces on nodes.
pub fn write_deck(mesh: &Mesh, case: &StaticCase, analysis: Analysis) -> Result<String, FlexError> {
    let lacks = [
        (case.inertia_relief, "inertia relief", "give it as forces on nodes"),
        (case.turns(), "field of a turning body", "give it as forces on nodes"),
    ];
    for (is_there, what, hint) in lacks {
        if is_there && analysis == Analysis::Static {
            return Err(FlexError::Missing { what: "card of the deck for", name: what.to_owned(), hint });
        }
    }
    let mut deck = String::new();
    let text = &mut deck;
    line(
        text,
        format_args!(
            "*HEADING\n{} (units: N, mm, tonne, s, MPa)\n*NODE, NSET=NALL",
            case.name.replace('\n', " ")
        ),
    );
    for (index, node) in mesh.nodes.iter().enumerate() {
        let [x, y, z] = node.map(|value| 1e3 * value);
        line(text, format_args!("{}, {x:.12e}, {y:.12e}, {z:.12e}", index + 1));
    }
    let mut sets: Vec<(ElementKind, u32)> =
        mesh.elements.iter().map(|element| (element.kind, element.material)).collect();
    sets.sort_by_key(|(kind, material)| (*material, *kind as usize));
    sets.dedup();
    for (kind, material) in &sets {
        line(text, format_args!("*ELEMENT, TYPE={}, ELSET={}", kind.deck_name(), set_name(*kind, *material)));
        for (index, element) in mesh.elements.iter().enumerate() {
            if (element.kind, element.material) == (*kind, *material) {
                let _ = write!(text, "{}", index + 1);
                for (place, node) in element.nodes.iter().enumerate() {
                    // No more than 16 entries in a line.
                    let break_here = if place == 15 { ",\n" } else { "," };
                    let _ = write!(text, "{break_here}{}", node + 1);
                }
                text.push('\n');
            }
        }
    }
    line(text, format_args!("*ELSET, ELSET=EALL"));
    for (kind, material) in &sets {
        line(text, format_args!("{}", set_name(*kind, *material)));
    }
    for set in &mesh.sets {
        line(text, format_args!("*NSET, NSET={}", set.name));
        for chunk in set.nodes.chunks(12) {
            let numbers: Vec<String> = chunk.iter().map(|node| (node + 1).to_string()).collect();
            line(text, format_args!("{},", numbers.join(", ")));
        }
    }
    for (index, material) in mesh.materials.iter().enumerate() {
        let (e, density) = (1e-6 * material.youngs_modulus, 1e-12 * material.density);
        line(
            text,
            format_args!(
                "*MATERIAL, NAME=M{}\n*ELASTIC\n{e:.12e}, {:.12e}",
                index + 1,
                material.poisson_ratio
            ),
        );
        line(text, format_args!("*DENSITY\n{density:.12e}"));
    }
    for (kind, material) in &sets {
        line(
            text,
            format_args!("*SOLID SECTION, ELSET={}, MATERIAL=M{}", set_name(*kind, *material), material + 1),
        );
    }
    super::springs::write_springs(text, mesh, case);
    let zero: Vec<_> = case.fixed.iter().filter(|fixed| fixed.value == 0.0).collect();
    if !zero.is_empty() {
        line(text, format_args!("*BOUNDARY"));
        for fixed in zero {
            line(text, format_args!("{}, {}, {}", fixed.node + 1, fixed.axis + 1, fixed.axis + 1));
        }
    }
    line(text, format_args!("*STEP"));
    match analysis {
        Analysis::Static => {
            line(text, format_args!("*STATIC"));
            for fixed in case.fixed.iter().filter(|fixed| fixed.value != 0.0) {
                let (axis, value) = (fixed.axis + 1, 1e3 * fixed.value);
                line(text, format_args!("*BOUNDARY\n{}, {axis}, {axis}, {value:.12e}", fixed.node + 1));
            }
            if !case.forces.is_empty() {
                line(text, format_args!("*CLOAD"));
            }
            for force in &case.forces {
                for (axis, value) in force.force.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                    line(text, format_args!("{}, {}, {value:.12e}", force.node + 1, axis + 1));
                }
            }
            line(text, format_args!("*NODE PRINT, NSET=NALL\nU\n*NODE PRINT, NSET=NALL, TOTALS=ONLY\nRF"));
            line(text, format_args!("*EL PRINT, ELSET=EALL\nS\n*EL PRINT, ELSET=EALL, TOTALS=ONLY\nELSE"));
        }
        Analysis::Frequency(count) => {
            line(text, format_args!("*FREQUENCY\n{count}\n*NODE FILE\nU"));
        }
    }
    line(text, format_args!("*END STEP"));
    Ok(deck)
}

fn set_name(kind: ElementKind, material: u32) -> String {
    format!("E{}_{}", material + 1, kind.deck_name())
}

fn line(text: &mut String, what: std::fmt::Arguments<'_>) {
    let _ = writeln!(text, "{what}");
}
