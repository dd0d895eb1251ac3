//! Shape functions and their derivatives in the element's own coordinates.
//!
//! ```text
//! tetrahedron   L = (1-r-s-t, r, s, t)        corner L_i (2 L_i - 1)                     edge 4 L_i L_j
//! wedge         L = (1-r-s, r, s), -1<=t<=1   corner L_i (1 -+ t)(2 L_i - 2 -+ t)/2      edge 2 L_i L_j (1 -+ t)    L_i (1 - t^2)
//! hexahedron    -1 <= r, s, t <= 1            corner (1+rr_i)(1+ss_i)(1+tt_i)(rr_i+ss_i+tt_i-2)/8    edge (1-r^2)(1+ss_i)(1+tt_i)/4
//! ```
//! (book, eq. 43.1.) The upper sign is that of the lower triangle of a wedge.

use super::ElementKind;

/// Values `n` of the shape functions at a point and their derivatives `d` by the element's three coordinates.
#[derive(Debug, Clone, Copy)]
pub struct ShapeValues {
    /// Values.
    pub n: [f64; 20],
    /// Derivatives by (r, s, t).
    pub d: [[f64; 3]; 20],
}

const HEXAHEDRON: [[f64; 3]; 20] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [0.0, -1.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, -1.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [-1.0, 0.0, 1.0],
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

/// The element's own coordinates of its node `node`.
pub fn local_coordinates(kind: ElementKind, node: usize) -> [f64; 3] {
    let corner = |corner: usize| -> [f64; 3] {
        match kind {
            ElementKind::Tetrahedron => {
                [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]][corner]
            }
            ElementKind::Wedge => {
                let [r, s] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][corner % 3];
                [r, s, if corner < 3 { -1.0 } else { 1.0 }]
            }
            ElementKind::Hexahedron => HEXAHEDRON[corner],
        }
    };
    if node < kind.corners() {
        return corner(node);
    }
    let [a, b] = kind.edges()[node - kind.corners()].map(corner);
    std::array::from_fn(|k| (a[k] + b[k]) / 2.0)
}

/// Shape functions of an element of this kind at the point `at` of its own coordinates.
pub fn shape_values(kind: ElementKind, at: [f64; 3]) -> ShapeValues {
    let mut values = ShapeValues { n: [0.0; 20], d: [[0.0; 3]; 20] };
    match kind {
        ElementKind::Tetrahedron => tetrahedron(at, &mut values),
        ElementKind::Wedge => wedge(at, &mut values),
        ElementKind::Hexahedron => hexahedron(at, &mut values),
    }
    values
}

fn tetrahedron([r, s, t]: [f64; 3], values: &mut ShapeValues) {
    let l = [1.0 - r - s - t, r, s, t];
    let dl = [[-1.0, -1.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for i in 0..4 {
        values.n[i] = l[i] * (2.0 * l[i] - 1.0);
        values.d[i] = dl[i].map(|d| (4.0 * l[i] - 1.0) * d);
    }
    for (place, [a, b]) in ElementKind::Tetrahedron.edges().iter().enumerate() {
        values.n[4 + place] = 4.0 * l[*a] * l[*b];
        values.d[4 + place] = std::array::from_fn(|k| 4.0 * (dl[*a][k] * l[*b] + l[*a] * dl[*b][k]));
    }
}

fn wedge([r, s, t]: [f64; 3], values: &mut ShapeValues) {
    let l = [1.0 - r - s, r, s];
    let dl = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
    for (side, sign) in [(0, -1.0), (1, 1.0)] {
        let height = 1.0 + sign * t;
        for i in 0..3 {
            let bracket = 2.0 * l[i] - 2.0 + sign * t;
            let node = 3 * side + i;
            values.n[node] = 0.5 * l[i] * height * bracket;
            let by_l = 0.5 * height * (bracket + 2.0 * l[i]);
            values.d[node] = [by_l * dl[i][0], by_l * dl[i][1], 0.5 * l[i] * sign * (bracket + height)];
            let j = (i + 1) % 3;
            let edge = 6 + 3 * side + i;
            values.n[edge] = 2.0 * l[i] * l[j] * height;
            for k in 0..2 {
                values.d[edge][k] = 2.0 * height * (dl[i][k] * l[j] + l[i] * dl[j][k]);
            }
            values.d[edge][2] = 2.0 * l[i] * l[j] * sign;
        }
    }
    for i in 0..3 {
        values.n[12 + i] = l[i] * (1.0 - t * t);
        values.d[12 + i] = [dl[i][0] * (1.0 - t * t), dl[i][1] * (1.0 - t * t), -2.0 * t * l[i]];
    }
}

fn hexahedron(at: [f64; 3], values: &mut ShapeValues) {
    for (node, place) in HEXAHEDRON.iter().enumerate() {
        // Along each axis: linear (1 + x x_i) at an end, quadratic (1 - x^2) in the middle.
        let factor: [f64; 3] =
            std::array::from_fn(
                |k| {
                    if place[k] == 0.0 { 1.0 - at[k] * at[k] } else { 1.0 + at[k] * place[k] }
                },
            );
        let slope: [f64; 3] = std::array::from_fn(|k| if place[k] == 0.0 { -2.0 * at[k] } else { place[k] });
        let product = factor[0] * factor[1] * factor[2];
        let by = [
            slope[0] * factor[1] * factor[2],
            factor[0] * slope[1] * factor[2],
            factor[0] * factor[1] * slope[2],
        ];
        if node < 8 {
            let bracket = at[0] * place[0] + at[1] * place[1] + at[2] * place[2] - 2.0;
            values.n[node] = product * bracket / 8.0;
            values.d[node] = std::array::from_fn(|k| (by[k] * bracket + product * place[k]) / 8.0);
        } else {
            values.n[node] = product / 4.0;
            values.d[node] = by.map(|d| d / 4.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_function_is_one_at_its_own_node_and_zero_at_the_others() {
        for kind in ElementKind::ALL {
            for node in 0..kind.nodes() {
                let values = shape_values(kind, local_coordinates(kind, node));
                for other in 0..kind.nodes() {
                    let wanted = f64::from(u8::from(node == other));
                    assert!((values.n[other] - wanted).abs() < 1e-14, "{kind:?} {node} {other}");
                }
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        let (at, step) = ([0.21, 0.34, 0.17], 1e-6);
        for kind in ElementKind::ALL {
            let values = shape_values(kind, at);
            for k in 0..3 {
                let moved = |sign: f64| {
                    let mut moved = at;
                    moved[k] += sign * step;
                    shape_values(kind, moved)
                };
                let (up, down) = (moved(1.0), moved(-1.0));
                for node in 0..kind.nodes() {
                    let slope = (up.n[node] - down.n[node]) / (2.0 * step);
                    assert!((slope - values.d[node][k]).abs() < 1e-8, "{kind:?} node {node} axis {k}");
                }
            }
        }
    }
}
