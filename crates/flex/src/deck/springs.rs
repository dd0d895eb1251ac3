//! Springs on weighted sums of displacements: an equation with a reference node, and a spring element on that node.
//!
//! ```text
//! u_ref = SUM w_i . u_i        F = k u_ref
//! ```

use crate::FlexError;
use crate::case::{Spring, StaticCase};
use crate::mesh::Mesh;
use std::fmt::Write;

/// Weights below this share of the largest one are rounding.
const ROUNDING: f64 = 1e-14;

/// Reference nodes, equations and spring elements of a case.
pub(super) fn write_springs(text: &mut String, mesh: &Mesh, case: &StaticCase) {
    let number = |index: usize| mesh.nodes.len() + index + 1;
    if case.springs.is_empty() {
        return;
    }
    let _ = writeln!(text, "*NODE, NSET=REFERENCE");
    for (index, spring) in case.springs.iter().enumerate() {
        let at = spring.nodes.first().map_or([0.0; 3], |(node, _)| mesh.nodes[*node as usize]);
        let [x, y, z] = at.map(|value| 1e3 * value);
        let _ = writeln!(text, "{}, {x:.12e}, {y:.12e}, {z:.12e}", number(index));
    }
    for (index, spring) in case.springs.iter().enumerate() {
        let terms = terms(spring);
        let _ = writeln!(text, "** {}\n*EQUATION\n{}", spring.name.replace('\n', " "), terms.len() + 1);
        // The first term is the one that is eliminated: the largest.
        let mut all: Vec<(usize, usize, f64)> =
            terms.iter().map(|(node, axis, weight)| (*node as usize + 1, axis + 1, *weight)).collect();
        all.sort_by(|a, b| b.2.abs().total_cmp(&a.2.abs()).then(a.cmp_place(b)));
        all.push((number(index), 1, -1.0));
        for chunk in all.chunks(4) {
            // CalculiX reads no more than 20 characters of a number.
            let words: Vec<String> =
                chunk.iter().map(|(node, axis, weight)| format!("{node}, {axis}, {weight:.13e}")).collect();
            let _ = writeln!(text, "{}", words.join(", "));
        }
    }
    for (index, spring) in case.springs.iter().enumerate() {
        // 1 N/m is 1e-3 N/mm.
        let (set, stiffness) = (format!("SPRING_{}", index + 1), 1e-3 * spring.stiffness);
        let _ = writeln!(text, "*ELEMENT, TYPE=SPRING1, ELSET={set}");
        let _ = writeln!(text, "{}, {}", mesh.elements.len() + index + 1, number(index));
        let _ = writeln!(text, "*SPRING, ELSET={set}\n1\n{stiffness:.12e}");
    }
    let _ = writeln!(text, "*BOUNDARY\nREFERENCE, 2, 3");
}

/// Terms of the sum: node, axis, weight.
fn terms(spring: &Spring) -> Vec<(u32, usize, f64)> {
    let largest =
        spring.nodes.iter().flat_map(|(_, weight)| *weight).fold(0.0f64, |most, w| most.max(w.abs()));
    let each = spring.nodes.iter().flat_map(|(node, weight)| (0..3).map(|axis| (*node, axis, weight[axis])));
    each.filter(|(_, _, weight)| weight.abs() > ROUNDING * largest).collect()
}

trait Place {
    fn cmp_place(&self, other: &Self) -> std::cmp::Ordering;
}

impl Place for (usize, usize, f64) {
    fn cmp_place(&self, other: &Self) -> std::cmp::Ordering {
        (self.0, self.1).cmp(&(other.0, other.1))
    }
}

/// What a deck says of one equation: node, axis (from 0) and factor of each term.
pub(super) type Equation = Vec<(u32, u8, f64)>;

/// Springs from equations and spring elements: `references` are nodes that no element of the mesh uses, each with its stiffness [N/m].
///
/// # Errors
/// [`FlexError::Deck`] for an equation without exactly one such node along its first axis.
pub(super) fn springs(
    equations: &[(usize, Equation)],
    references: &[(u32, f64, String)],
) -> Result<Vec<Spring>, FlexError> {
    let spring = |(line, equation): &(usize, Equation)| {
        let own = |term: &&(u32, u8, f64)| references.iter().any(|(node, ..)| *node == term.0);
        let ends: Vec<&(u32, u8, f64)> = equation.iter().filter(own).collect();
        let [(node, 0, factor)] = ends[..] else {
            return Err(FlexError::Deck {
                line: *line,
                message: "an equation is read where one of its nodes, along 1, carries a SPRING1 element and belongs to no other element; \
                          give displacements with *BOUNDARY instead"
                    .to_owned(),
            });
        };
        let (stiffness, name) = references
            .iter()
            .find(|(own, ..)| own == node)
            .map_or((0.0, String::new()), |(_, stiffness, name)| (*stiffness, name.clone()));
        let mut nodes: Vec<(u32, [f64; 3])> = Vec::new();
        for (other, axis, weight) in equation.iter().filter(|term| term.0 != *node) {
            let mut own = [0.0; 3];
            own[*axis as usize] = -weight / factor;
            match nodes.binary_search_by_key(other, |(node, _)| *node) {
                Ok(place) => nodes[place].1[*axis as usize] += own[*axis as usize],
                Err(place) => nodes.insert(place, (*other, own)),
            }
        }
        Ok(Spring { name, stiffness, nodes })
    };
    equations.iter().map(spring).collect()
}
