//! A crankshaft cut across its axis wherever a piece of it begins or ends: in each slab the outline of all that is there.

use super::CrankshaftError;
use super::element::Element;
use lanchester_shape::{AreaMoments, GeometryError, Outline};

/// Ends closer than this part of the length of the crankshaft are one plane: some roundings.
const SAME_PLANE: f64 = 1e-12;

/// Pieces that touch, as one outline.
#[derive(Debug, Clone)]
pub(super) struct Group {
    /// What it is made of, in rising order.
    pub members: Vec<usize>,
    pub outline: Outline,
}

/// What is between two planes next to each other.
#[derive(Debug, Clone)]
pub(super) struct Slab {
    pub faces: [f64; 2],
    /// Each element that is there, with what it adds to the area of those before it, and what it has in common with them.
    pub members: Vec<(usize, [AreaMoments; 2])>,
    /// Pieces of one material that touch.
    pub groups: Vec<Group>,
}

/// The slabs of a crankshaft, along z.
pub(super) fn slabs(elements: &[Element]) -> Result<Vec<Slab>, CrankshaftError> {
    let mut planes: Vec<f64> = elements.iter().flat_map(|element| element.faces).collect();
    planes.sort_by(f64::total_cmp);
    let tolerance = SAME_PLANE * (planes[planes.len() - 1] - planes[0]);
    planes.dedup_by(|next, plane| *next - *plane <= tolerance);
    let mut slabs = Vec::new();
    for pair in planes.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let is_there =
            |element: &Element| element.faces[0] <= from + tolerance && element.faces[1] >= to - tolerance;
        let members: Vec<usize> = (0..elements.len()).filter(|k| is_there(&elements[*k])).collect();
        if !members.is_empty() {
            slabs.push(slab(elements, [from, to], &members)?);
        }
    }
    Ok(slabs)
}

fn slab(elements: &[Element], faces: [f64; 2], present: &[usize]) -> Result<Slab, CrankshaftError> {
    let mut all = Vec::new();
    let mut members = Vec::new();
    let mut area = AreaMoments::default();
    for member in present {
        let alone = elements[*member].outline.moments();
        let apart = all.is_empty();
        join(elements, &mut all, *member)?;
        let grown =
            all.iter().fold(AreaMoments::default(), |sum, group: &Group| sum + group.outline.moments());
        let added = if apart { alone } else { grown - area };
        members.push((*member, [added, alone - added]));
        area = grown;
    }
    let first = &elements[present[0]];
    let prisms: Vec<usize> = present.iter().copied().filter(|k| !elements[*k].has_chamfers()).collect();
    if prisms.len() == present.len() && present.iter().all(|k| elements[*k].density == first.density) {
        return Ok(Slab { faces, members, groups: all });
    }
    let mut groups: Vec<Group> = Vec::new();
    let mut densities: Vec<f64> = prisms.iter().map(|k| elements[*k].density).collect();
    densities.sort_by(f64::total_cmp);
    densities.dedup();
    for density in densities {
        let mut same = Vec::new();
        for member in prisms.iter().filter(|k| elements[**k].density == density) {
            join(elements, &mut same, *member)?;
        }
        groups.extend(same);
    }
    Ok(Slab { faces, members, groups })
}

/// Adds an element to the groups; those that it touches become one with it.
fn join(elements: &[Element], groups: &mut Vec<Group>, member: usize) -> Result<(), CrankshaftError> {
    let mut joined = Group { members: vec![member], outline: elements[member].outline.clone() };
    let mut apart = Vec::new();
    for group in groups.drain(..) {
        match group.outline.union(&joined.outline) {
            Ok(outline) => {
                joined.members.extend(group.members);
                joined.outline = outline;
            }
            Err(GeometryError::Disjoint { .. }) => apart.push(group),
            Err(source) => {
                let first = elements[group.members[0]].name.clone();
                let second = elements[member].name.clone();
                return Err(CrankshaftError::Joint { first, second, source });
            }
        }
    }
    joined.members.sort_unstable();
    apart.push(joined);
    *groups = apart;
    Ok(())
}
