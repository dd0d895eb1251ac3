//! Stiffness, consistent mass and geometric stiffness of one element.
//!
//! ```text
//! K_ij = INT lambda g_i g_j^T + mu (g_j g_i^T + (g_i . g_j) I) dV        g_i: gradient of shape function i       (book, eq. 43.2)
//! M_ij = INT rho N_i N_j dV I                                                                                    (book, eq. 43.3)
//! S_ij = INT g_i . sigma g_j dV I                                                                                (book, eq. 51.14)
//! ```

use super::quadrature::IntegrationPoint;
use super::{ElementKind, ShapeValues, shape_values};
use crate::Material;

/// A full symmetric matrix over the degrees of freedom of an element, three for each node in turn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ElementMatrix {
    /// Degrees of freedom.
    pub size: usize,
    /// Entries, row by row.
    pub values: Vec<f64>,
}

/// Determinant of the Jacobian of a map from the element's own coordinates [m^3], and gradients of the shape functions [1/m].
pub(crate) fn gradients(nodes: &[[f64; 3]], shape: &ShapeValues) -> (f64, [[f64; 3]; 20]) {
    let j = jacobian(nodes, shape);
    let cofactor = |a: usize, b: usize| {
        let (a1, a2, b1, b2) = ((a + 1) % 3, (a + 2) % 3, (b + 1) % 3, (b + 2) % 3);
        j[a1][b1] * j[a2][b2] - j[a1][b2] * j[a2][b1]
    };
    let determinant = (0..3).map(|b| j[0][b] * cofactor(0, b)).sum::<f64>();
    let mut result = [[0.0; 3]; 20];
    let mut inverse = [[0.0; 3]; 3];
    for a in 0..3 {
        for b in 0..3 {
            inverse[a][b] = cofactor(a, b) / determinant;
        }
    }
    for (node, gradient) in result.iter_mut().enumerate().take(nodes.len()) {
        for axis in 0..3 {
            gradient[axis] = (0..3).map(|k| inverse[k][axis] * shape.d[node][k]).sum();
        }
    }
    (determinant, result)
}

/// `j[k][axis]`: derivative of the place by the element's coordinate `k`.
fn jacobian(nodes: &[[f64; 3]], shape: &ShapeValues) -> [[f64; 3]; 3] {
    let mut j = [[0.0; 3]; 3];
    for (node, place) in nodes.iter().enumerate() {
        for k in 0..3 {
            for axis in 0..3 {
                j[k][axis] += shape.d[node][k] * place[axis];
            }
        }
    }
    j
}

/// Determinant of the Jacobian at a point of the element's own coordinates [m^3]: positive everywhere in a valid element.
pub fn jacobian_determinant(kind: ElementKind, nodes: &[[f64; 3]], at: [f64; 3]) -> f64 {
    let [a, b, c] = jacobian(nodes, &shape_values(kind, at));
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// Stiffness matrix [N/m] of an element with these nodes [m].
pub fn stiffness_matrix(
    kind: ElementKind,
    nodes: &[[f64; 3]],
    material: &Material,
    rule: &[(IntegrationPoint, ShapeValues)],
    matrix: &mut ElementMatrix,
) {
    let (count, [lambda, mu]) = (kind.nodes(), material.lame());
    clear(matrix, 3 * count);
    let size = matrix.size;
    for (point, shape) in rule {
        let (determinant, g) = gradients(nodes, shape);
        let (l, m) = (lambda * point.weight * determinant, mu * point.weight * determinant);
        for i in 0..count {
            for j in 0..=i {
                let dot = m * (g[i][0] * g[j][0] + g[i][1] * g[j][1] + g[i][2] * g[j][2]);
                for a in 0..3 {
                    let row = &mut matrix.values[(3 * i + a) * size + 3 * j..][..3];
                    for b in 0..3 {
                        row[b] += l * g[i][a] * g[j][b] + m * g[j][a] * g[i][b];
                    }
                    row[a] += dot;
                }
            }
        }
    }
    mirror(matrix);
}

/// Consistent mass matrix [kg] of an element with these nodes [m].
pub fn mass_matrix(
    kind: ElementKind,
    nodes: &[[f64; 3]],
    density: f64,
    rule: &[(IntegrationPoint, ShapeValues)],
    matrix: &mut ElementMatrix,
) {
    let count = kind.nodes();
    clear(matrix, 3 * count);
    let size = matrix.size;
    for (point, shape) in rule {
        let (determinant, _) = gradients(nodes, shape);
        let mass = density * point.weight * determinant;
        for i in 0..count {
            for j in 0..=i {
                let value = mass * shape.n[i] * shape.n[j];
                for a in 0..3 {
                    matrix.values[(3 * i + a) * size + 3 * j + a] += value;
                }
            }
        }
    }
    mirror(matrix);
}

/// Geometric stiffness [N/m] of an element with these nodes [m] under the stress of their displacements [m].
pub fn geometric_matrix(
    kind: ElementKind,
    nodes: &[[f64; 3]],
    material: &Material,
    displacements: &[[f64; 3]],
    rule: &[(IntegrationPoint, ShapeValues)],
    matrix: &mut ElementMatrix,
) {
    let (count, [lambda, mu]) = (kind.nodes(), material.lame());
    clear(matrix, 3 * count);
    let size = matrix.size;
    for (point, shape) in rule {
        let (determinant, g) = gradients(nodes, shape);
        // slope[a][b]: derivative of displacement a along b.
        let mut slope = [[0.0; 3]; 3];
        for (u, g) in displacements.iter().zip(&g) {
            for a in 0..3 {
                for b in 0..3 {
                    slope[a][b] += u[a] * g[b];
                }
            }
        }
        let pressure = lambda * (slope[0][0] + slope[1][1] + slope[2][2]);
        let volume = point.weight * determinant;
        let stress: [[f64; 3]; 3] = std::array::from_fn(|a| {
            std::array::from_fn(|b| {
                volume * (mu * (slope[a][b] + slope[b][a]) + if a == b { pressure } else { 0.0 })
            })
        });
        for i in 0..count {
            let pull: [f64; 3] = std::array::from_fn(|a| (0..3).map(|b| stress[a][b] * g[i][b]).sum());
            for j in 0..=i {
                let value = pull[0] * g[j][0] + pull[1] * g[j][1] + pull[2] * g[j][2];
                for a in 0..3 {
                    matrix.values[(3 * i + a) * size + 3 * j + a] += value;
                }
            }
        }
    }
    mirror(matrix);
}

fn clear(matrix: &mut ElementMatrix, size: usize) {
    matrix.size = size;
    matrix.values.clear();
    matrix.values.resize(size * size, 0.0);
}

/// Copies the blocks below the diagonal to those above.
fn mirror(matrix: &mut ElementMatrix) {
    let size = matrix.size;
    for row in 0..size {
        for column in row + 1..size {
            matrix.values[row * size + column] = matrix.values[column * size + row];
        }
    }
}
