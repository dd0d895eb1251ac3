//! The kinds of elements, their edges and faces.

use serde::{Deserialize, Serialize};

/// A quadratic solid element.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ElementKind {
    /// Tetrahedron with 10 nodes, C3D10.
    Tetrahedron,
    /// Wedge with 15 nodes, C3D15.
    Wedge,
    /// Hexahedron with 20 nodes, C3D20.
    Hexahedron,
}

impl ElementKind {
    /// All kinds.
    pub const ALL: [ElementKind; 3] = [ElementKind::Tetrahedron, ElementKind::Wedge, ElementKind::Hexahedron];

    /// How many nodes it has.
    pub fn nodes(self) -> usize {
        match self {
            ElementKind::Tetrahedron => 10,
            ElementKind::Wedge => 15,
            ElementKind::Hexahedron => 20,
        }
    }

    /// How many of them are corners; these come first.
    pub fn corners(self) -> usize {
        match self {
            ElementKind::Tetrahedron => 4,
            ElementKind::Wedge => 6,
            ElementKind::Hexahedron => 8,
        }
    }

    /// Its name in a CalculiX deck.
    pub fn deck_name(self) -> &'static str {
        match self {
            ElementKind::Tetrahedron => "C3D10",
            ElementKind::Wedge => "C3D15",
            ElementKind::Hexahedron => "C3D20",
        }
    }

    /// Its cell type in a VTK file.
    pub fn vtk_type(self) -> u8 {
        match self {
            ElementKind::Tetrahedron => 24,
            ElementKind::Wedge => 26,
            ElementKind::Hexahedron => 25,
        }
    }

    /// The corners at both ends of each mid-side node, in the order of those nodes.
    pub fn edges(self) -> &'static [[usize; 2]] {
        match self {
            ElementKind::Tetrahedron => &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
            ElementKind::Wedge => &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
            ElementKind::Hexahedron => &[
                [0, 1],
                [1, 2],
                [2, 3],
                [3, 0],
                [4, 5],
                [5, 6],
                [6, 7],
                [7, 4],
                [0, 4],
                [1, 5],
                [2, 6],
                [3, 7],
            ],
        }
    }

    /// Its faces as corners, seen from outside against the clock.
    pub fn faces(self) -> &'static [&'static [usize]] {
        match self {
            ElementKind::Tetrahedron => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
            ElementKind::Wedge => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            ElementKind::Hexahedron => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
        }
    }

    /// Place among the element's nodes of the mid-side node between two corners.
    pub fn middle(self, a: usize, b: usize) -> Option<usize> {
        let is_edge = |edge: &[usize; 2]| *edge == [a, b] || *edge == [b, a];
        self.edges().iter().position(is_edge).map(|place| self.corners() + place)
    }
}
