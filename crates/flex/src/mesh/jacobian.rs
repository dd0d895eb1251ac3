//! Whether an element is turned inside out.

use crate::FlexError;
use crate::element::{ElementKind, jacobian_determinant, local_coordinates, stiffness_rule};

/// Smallest determinant of the Jacobian of an element over its mean, at nodes and integration points.
pub(super) fn scaled_jacobian(kind: ElementKind, nodes: &[[f64; 3]]) -> f64 {
    let rule = stiffness_rule(kind);
    let inner: Vec<f64> = rule.iter().map(|point| jacobian_determinant(kind, nodes, point.at)).collect();
    let weights: f64 = rule.iter().map(|point| point.weight).sum();
    let mean = rule.iter().zip(&inner).map(|(point, value)| point.weight * value).sum::<f64>() / weights;
    let at_nodes =
        (0..kind.nodes()).map(|node| jacobian_determinant(kind, nodes, local_coordinates(kind, node)));
    let least = inner.iter().copied().chain(at_nodes).fold(f64::INFINITY, f64::min);
    if mean > 0.0 { least / mean } else { -1.0 }
}

pub(super) fn check_element(
    index: usize,
    kind: ElementKind,
    nodes: &[[f64; 3]],
    needed: f64,
) -> Result<(), FlexError> {
    let jacobian = scaled_jacobian(kind, nodes);
    if jacobian > needed {
        return Ok(());
    }
    Err(FlexError::Inverted { element: index + 1, at: middle(kind, nodes), jacobian, needed })
}

pub(super) fn middle(kind: ElementKind, nodes: &[[f64; 3]]) -> [f64; 3] {
    let corners = &nodes[..kind.corners()];
    std::array::from_fn(|k| corners.iter().map(|node| node[k]).sum::<f64>() / corners.len() as f64)
}
