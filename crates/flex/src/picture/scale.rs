//! By how much displacements are shown.

use crate::mesh::Mesh;

/// A round factor (1, 2 or 5 times a power of ten) that shows the largest displacement as about `share` of the length of a mesh along z.
pub fn shown_factor(mesh: &Mesh, displacements: &[[f64; 3]], share: f64) -> f64 {
    let length = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let largest = displacements.iter().map(length).fold(0.0, f64::max);
    let along = mesh.nodes.iter().map(|node| node[2]);
    let [from, to] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], z| [a.min(z), b.max(z)]);
    let factor = share * (to - from) / largest;
    if !factor.is_finite() || factor <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(factor.log10().floor());
    power * [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= factor).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factor_is_round_and_not_above_what_was_asked_for() {
        let mesh = Mesh { nodes: vec![[0.0; 3], [0.0, 0.0, 0.4]], ..Mesh::default() };
        for (moved, wanted) in [(1e-4, 200.0), (5e-5, 200.0), (1.9e-5, 1000.0), (0.0, 1.0)] {
            let factor = shown_factor(&mesh, &[[0.0; 3], [0.0, moved, 0.0]], 0.05);
            assert!((factor / wanted - 1.0).abs() < 1e-9, "{moved}: {factor}");
        }
    }
}
