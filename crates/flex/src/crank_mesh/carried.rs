//! Counterweights without a shape, and what of a crankshaft carries each.
//!
//! One on a web is carried by what of the web lies beyond the main journal on its side, where a counterweight would begin (by the whole side where nothing does);
//! one between the two webs of a throw by both; one beside a main journal by the nearer web; one beyond the first or last web, as of a flywheel, by the elements
//! at the end face.

use super::segment::TINY;
use crate::mesh::{CarriedWeight, Mesh};
use lanchester_model::{Counterweight, CrankElement, CrankElementForm, Engine};
use std::collections::HashSet;

/// A part of a crankshaft that carries a weight.
enum Carrier<'a> {
    Webs(Vec<&'a CrankElement>),
    End(&'static str),
}

/// The weights of crankshaft `index` that a mesh of the whole or of a bay carries.
pub(super) fn carried_weights(
    mesh: &Mesh,
    engine: &Engine,
    index: usize,
    elements: &[CrankElement],
) -> Vec<CarriedWeight> {
    let heights = mesh.nodes.iter().map(|node| node[2]);
    let ends = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [a.min(z), b.max(z)]);
    let own = engine
        .counterweights
        .iter()
        .filter(|weight| weight.crankshaft == index && weight.part.is_none() && weight.unbalance > 0.0);
    own.filter_map(|weight| carried_weight(mesh, elements, ends, weight)).collect()
}

fn carried_weight(
    mesh: &Mesh,
    elements: &[CrankElement],
    ends: [f64; 2],
    weight: &Counterweight,
) -> Option<CarriedWeight> {
    let (sin, cos) = weight.angle.sin_cos();
    let unbalance = [weight.unbalance * cos, weight.unbalance * sin];
    let (place, own) = match carrier(elements, weight.z)? {
        Carrier::End(set) => {
            let nodes: HashSet<u32> = mesh.set(set).ok()?.nodes.iter().copied().collect();
            let touches = |k: &usize| mesh.elements[*k].nodes.iter().any(|node| nodes.contains(node));
            (format!("end face {set}"), (0..mesh.elements.len()).filter(touches).collect())
        }
        Carrier::Webs(webs) => {
            let names: Vec<String> = webs.iter().map(|web| web.name()).collect();
            // A bay has some of the webs.
            let is_there = |web: &&CrankElement| web.faces[0] > ends[0] && web.faces[1] < ends[1];
            if !webs.iter().all(is_there) {
                return None;
            }
            let middle = |k: usize| -> [f64; 3] {
                let element = &mesh.elements[k];
                let corners = &element.nodes[..element.kind.corners()];
                std::array::from_fn(|axis| {
                    let sum: f64 = corners.iter().map(|node| mesh.nodes[*node as usize][axis]).sum();
                    sum / corners.len() as f64
                })
            };
            let beyond = |k: &usize, web: &CrankElement, radius: f64| {
                let [x, y, z] = middle(*k);
                x * cos + y * sin > radius && (web.faces[0]..web.faces[1]).contains(&z)
            };
            let of_web = |web: &CrankElement| -> Vec<usize> {
                let all = 0..mesh.elements.len();
                let radius = journal_radius(elements, web);
                let outer: Vec<usize> = all.clone().filter(|k| beyond(k, web, radius)).collect();
                if outer.is_empty() { all.filter(|k| beyond(k, web, 0.0)).collect() } else { outer }
            };
            (names.join(" and "), webs.into_iter().flat_map(of_web).collect::<Vec<usize>>())
        }
    };
    CarriedWeight::over(mesh, &own, [&weight.name, &place], unbalance, weight.z)
}

/// Radius of the larger main journal that ends on a web [m]; 0 of a web between pins.
fn journal_radius(elements: &[CrankElement], web: &CrankElement) -> f64 {
    let touches = |element: &&CrankElement| {
        (element.faces[1] - web.faces[0]).abs() < TINY || (element.faces[0] - web.faces[1]).abs() < TINY
    };
    let radius = |element: &CrankElement| match &element.form {
        CrankElementForm::Journal { bar, .. } => bar.diameter / 2.0,
        _ => 0.0,
    };
    elements.iter().filter(touches).map(radius).fold(0.0, f64::max)
}

/// What carries a weight in the plane `z`.
fn carrier(elements: &[CrankElement], z: f64) -> Option<Carrier<'_>> {
    let is_web = |element: &&CrankElement| matches!(element.form, CrankElementForm::Web { .. });
    let webs = || elements.iter().filter(is_web);
    if let Some(web) = webs().find(|web| web.faces[0] - TINY <= z && z <= web.faces[1] + TINY) {
        return Some(Carrier::Webs(vec![web]));
    }
    let before = webs().rfind(|web| web.faces[1] < z);
    let after = webs().find(|web| web.faces[0] > z);
    Some(match (before, after) {
        (Some(before), Some(after)) => {
            let is_pin = elements.iter().any(|element| {
                matches!(element.form, CrankElementForm::Pin { .. })
                    && element.faces[0] - TINY <= z
                    && z <= element.faces[1] + TINY
            });
            Carrier::Webs(match is_pin {
                true => vec![before, after],
                false if z - before.faces[1] <= after.faces[0] - z => vec![before],
                false => vec![after],
            })
        }
        (None, Some(_)) => Carrier::End("FREE_END"),
        (Some(_), None) => Carrier::End("FLYWHEEL"),
        (None, None) => return None,
    })
}
