//! Integration rules: those of CalculiX for stiffness, rules exact for straight elements for mass.

use super::ElementKind;

/// A point of an integration rule in the element's own coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegrationPoint {
    /// Where.
    pub at: [f64; 3],
    /// Weight; the weights add up to the volume of the element in its own coordinates.
    pub weight: f64,
}

/// Points and weights of Gauss's rule with three points on (-1, 1).
const GAUSS_3: [[f64; 2]; 3] =
    [[-0.774_596_669_241_483_4, 5.0 / 9.0], [0.0, 8.0 / 9.0], [0.774_596_669_241_483_4, 5.0 / 9.0]];
/// With four points.
const GAUSS_4: [[f64; 2]; 4] = [
    [-0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
    [-0.339_981_043_584_856_26, 0.652_145_154_862_546_2],
    [0.339_981_043_584_856_26, 0.652_145_154_862_546_2],
    [0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
];
/// The three points of a triangle, exact to degree 2.
const TRIANGLE_3: [[f64; 2]; 3] = [[1.0 / 6.0, 1.0 / 6.0], [2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0]];
/// Ends of the four points of a tetrahedron, exact to degree 2: `(5 -+ sqrt 5)/20` and what is left.
const TETRAHEDRON: [f64; 2] = [0.138_196_601_125_010_5, 0.585_410_196_624_968_5];
const GAUSS_2: f64 = 0.577_350_269_189_625_8;

/// The rule of the stiffness matrix, as CalculiX has it: 4 points for C3D10, 3 x 3 for C3D15, 27 for C3D20, in its order.
pub fn stiffness_rule(kind: ElementKind) -> Vec<IntegrationPoint> {
    match kind {
        ElementKind::Tetrahedron => tetrahedron_points(),
        ElementKind::Wedge => {
            let layer = |[t, weight]: [f64; 2]| {
                TRIANGLE_3.map(|[r, s]| IntegrationPoint { at: [r, s, t], weight: weight / 6.0 })
            };
            GAUSS_3.into_iter().flat_map(layer).collect()
        }
        ElementKind::Hexahedron => {
            let mut points = Vec::with_capacity(27);
            for [t, wt] in GAUSS_3 {
                for [s, ws] in GAUSS_3 {
                    for [r, wr] in GAUSS_3 {
                        points.push(IntegrationPoint { at: [r, s, t], weight: wr * ws * wt });
                    }
                }
            }
            points
        }
    }
}

fn tetrahedron_points() -> Vec<IntegrationPoint> {
    let [a, b] = TETRAHEDRON;
    [[a, a, a], [b, a, a], [a, b, a], [a, a, b]]
        .into_iter()
        .map(|at| IntegrationPoint { at, weight: 1.0 / 24.0 })
        .collect()
}

/// A rule that is exact for the products of shape functions of an element with straight edges.
pub fn mass_rule(kind: ElementKind) -> Vec<IntegrationPoint> {
    match kind {
        // Collapsed cube: r = u, s = v (1 - u), t = w (1 - u)(1 - v).
        ElementKind::Tetrahedron => {
            let unit = |[x, weight]: [f64; 2]| [(1.0 + x) / 2.0, weight / 2.0];
            let mut points = Vec::with_capacity(36);
            for [u, wu] in GAUSS_4.map(unit) {
                for [v, wv] in GAUSS_3.map(unit) {
                    for [w, ww] in GAUSS_3.map(unit) {
                        let (p, q) = (1.0 - u, 1.0 - v);
                        points.push(IntegrationPoint {
                            at: [u, v * p, w * p * q],
                            weight: wu * wv * ww * p * p * q,
                        });
                    }
                }
            }
            points
        }
        // Six points of a triangle, exact to degree 4, in three layers.
        ElementKind::Wedge => {
            let mut points = Vec::with_capacity(18);
            for [t, wt] in GAUSS_3 {
                for (a, weight) in [
                    (0.445_948_490_915_964_9, 0.223_381_589_678_011_47),
                    (0.091_576_213_509_770_74, 0.109_951_743_655_321_87),
                ] {
                    let b = 1.0 - 2.0 * a;
                    for [r, s] in [[a, a], [b, a], [a, b]] {
                        points.push(IntegrationPoint { at: [r, s, t], weight: wt * weight / 2.0 });
                    }
                }
            }
            points
        }
        ElementKind::Hexahedron => stiffness_rule(kind),
    }
}

/// The points at which strains are superconvergent: 4 of a tetrahedron, 3 x 2 of a wedge, 2 x 2 x 2 of a hexahedron.
pub fn recovery_points(kind: ElementKind) -> Vec<[f64; 3]> {
    match kind {
        ElementKind::Tetrahedron => tetrahedron_points().into_iter().map(|point| point.at).collect(),
        ElementKind::Wedge => {
            [-GAUSS_2, GAUSS_2].into_iter().flat_map(|t| TRIANGLE_3.map(|[r, s]| [r, s, t])).collect()
        }
        ElementKind::Hexahedron => {
            let corner = |k: usize| {
                let at = super::local_coordinates(ElementKind::Hexahedron, k);
                at.map(|x| GAUSS_2 * x)
            };
            (0..8).map(corner).collect()
        }
    }
}

/// Weights of the values at [`recovery_points`] in the linear (wedge, hexahedron: times linear) field through them at `at`.
pub(super) fn recovery_weights(kind: ElementKind, [r, s, t]: [f64; 3]) -> Vec<f64> {
    match kind {
        ElementKind::Tetrahedron => {
            let [a, b] = TETRAHEDRON;
            [1.0 - r - s - t, r, s, t].iter().map(|l| (l - a) / (b - a)).collect()
        }
        ElementKind::Wedge => {
            let triangle = [1.0 - r - s, r, s].map(|l| 2.0 * l - 1.0 / 3.0);
            [-1.0, 1.0]
                .into_iter()
                .flat_map(|side| triangle.map(|l| l * (1.0 + side * t / GAUSS_2) / 2.0))
                .collect()
        }
        ElementKind::Hexahedron => (0..8)
            .map(|k| {
                let corner = super::local_coordinates(ElementKind::Hexahedron, k);
                let x = [r, s, t];
                (0..3).map(|k| (1.0 + corner[k] * x[k] / GAUSS_2) / 2.0).product()
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape_values;
    use super::*;

    /// Integral of `r^a s^b t^c` over the element in its own coordinates.
    fn exact(kind: ElementKind, [a, b, c]: [i32; 3]) -> f64 {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        let line = |n: i32| if n % 2 == 0 { 2.0 / f64::from(n + 1) } else { 0.0 };
        match kind {
            ElementKind::Tetrahedron => factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3),
            ElementKind::Wedge => factorial(a) * factorial(b) / factorial(a + b + 2) * line(c),
            ElementKind::Hexahedron => line(a) * line(b) * line(c),
        }
    }

    #[test]
    fn rules_integrate_what_they_promise() {
        for kind in ElementKind::ALL {
            for (rule, degree) in [(stiffness_rule(kind), 2), (mass_rule(kind), 4)] {
                for a in 0..=degree {
                    for b in 0..=degree - a {
                        for c in 0..=degree - a - b {
                            let sum: f64 = rule
                                .iter()
                                .map(|p| p.weight * p.at[0].powi(a) * p.at[1].powi(b) * p.at[2].powi(c))
                                .sum();
                            assert!((sum - exact(kind, [a, b, c])).abs() < 1e-14, "{kind:?} {a} {b} {c}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn recovery_reproduces_a_linear_field() {
        let field = |[r, s, t]: [f64; 3]| 1.0 + 2.0 * r - 3.0 * s + 0.5 * t;
        for kind in ElementKind::ALL {
            let points = recovery_points(kind);
            for node in 0..kind.nodes() {
                let at = super::super::local_coordinates(kind, node);
                let weights = recovery_weights(kind, at);
                let value: f64 = weights.iter().zip(&points).map(|(w, p)| w * field(*p)).sum();
                assert!((value - field(at)).abs() < 1e-13);
            }
            let sum: f64 = shape_values(kind, points[0]).n.iter().sum();
            assert!((sum - 1.0).abs() < 1e-14);
        }
    }
}
