//! Triangles across the crank become wedges along it.

use super::net::Net;
use super::places::Places;
use crate::element::ElementKind;
use crate::mesh::{Element, Mesh};
use lanchester_shape::Point;
use std::collections::HashMap;

/// A mesh that grows along z.
pub(super) struct Sweep {
    pub points: Vec<Point>,
    /// Middles of arcs by the ends of their chords.
    pub middles: HashMap<[usize; 2], Point>,
    /// Node of a point (both numbers the same) or edge at a level, in half levels.
    pub nodes: HashMap<([usize; 2], usize), u32>,
    pub mesh: Mesh,
    /// Levels so far [m].
    pub levels: Vec<f64>,
}

impl Sweep {
    pub fn centre(&self, triangle: &[usize; 3]) -> Point {
        (self.points[triangle[0]] + self.points[triangle[1]] + self.points[triangle[2]]) * (1.0 / 3.0)
    }

    pub fn pick(&self, net: &Net, is_in: impl Fn(Point) -> bool) -> Vec<[usize; 3]> {
        net.triangles.iter().filter(|triangle| is_in(self.centre(triangle))).copied().collect()
    }

    /// Adds a layer of wedges between each two levels [m] above `from`; the first one is the last one so far. `triangles` gives those of a height,
    /// each with the index of its material, and `places` where their points are.
    pub fn extrude(
        &mut self,
        from: f64,
        along: &[f64],
        places: &Places<'_>,
        triangles: impl Fn(f64) -> Vec<([usize; 3], u32)>,
    ) {
        if self.levels.is_empty() {
            self.levels.push(from + along[0]);
        }
        for pair in along.windows(2) {
            let low = self.levels.len() - 1;
            self.levels.push(from + pair[1]);
            for (corners, material) in triangles(from + (pair[0] + pair[1]) / 2.0) {
                let edges = [[0, 1], [1, 2], [2, 0]].map(|[a, b]: [usize; 2]| {
                    let (a, b) = (corners[a], corners[b]);
                    [a.min(b), a.max(b)]
                });
                let points = corners.map(|corner| [corner, corner]);
                let mut nodes = Vec::with_capacity(15);
                for (keys, level) in [
                    (points, 2 * low),
                    (points, 2 * low + 2),
                    (edges, 2 * low),
                    (edges, 2 * low + 2),
                    (points, 2 * low + 1),
                ] {
                    nodes.extend(keys.map(|key| self.node(key, level, places)));
                }
                self.mesh.elements.push(Element { kind: ElementKind::Wedge, nodes, material });
            }
        }
    }

    fn node(&mut self, key: [usize; 2], level: usize, places: &Places<'_>) -> u32 {
        if let Some(node) = self.nodes.get(&(key, level)) {
            return *node;
        }
        let chord = (self.points[key[0]] + self.points[key[1]]) * 0.5;
        let plain = self.middles.get(&key).copied().unwrap_or(chord);
        let z = (self.levels[level / 2] + self.levels[level.div_ceil(2)]) / 2.0;
        let at = places.at(key, plain, &self.points, z);
        let node = self.mesh.nodes.len() as u32;
        self.mesh.nodes.push([at.x, at.y, z]);
        self.nodes.insert((key, level), node);
        node
    }
}
