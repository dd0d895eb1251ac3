//! Triangles of a plane figure with holes.
//!
//! A constrained Delaunay triangulation with exact predicates (the crate `spade`, used here alone) that keeps every point of
//! the boundary and adds none to it: what shares the boundary fits without gaps.

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Smaller coordinates count as zero, since the predicates are exact only above 1e-43.
const TINY: f64 = 1e-40;

/// Triangles between closed polygons, anticlockwise, by the numbers that their points count in the order of the polygons, and after
/// them the points `within` the figure. All polygons run with the figure on their left, or all with it on their right.
///
/// # Errors
/// Where polygons cross, touch or repeat a point, or a hole lies outside: the number of a point there.
pub(super) fn triangles(polygons: &[Vec<[f64; 2]>], within: &[[f64; 2]]) -> Result<Vec<[usize; 3]>, usize> {
    let mut net = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let mut handles = Vec::new();
    for [x, y] in polygons.iter().flatten().chain(within) {
        let [x, y] = [*x, *y].map(|c| if c.abs() < TINY { 0.0 } else { c });
        let handle = net.insert(Point2::new(x, y)).map_err(|_| handles.len())?;
        if handle.index() != handles.len() {
            return Err(handles.len());
        }
        handles.push(handle);
    }
    let (mut first, mut lines) = (0, Vec::new());
    for polygon in polygons {
        let count = polygon.len();
        for k in 0..count {
            let (from, to) = (first + k, first + (k + 1) % count);
            lines.push((from, to));
            if !net.can_add_constraint(handles[from], handles[to]) {
                return Err(from);
            }
            net.add_constraint(handles[from], handles[to]);
            // A line through another point is put together of two: the walls would not fit.
            if !net.exists_constraint(handles[from], handles[to]) {
                return Err(from);
            }
        }
        first += count;
    }
    // From outside inwards: across a line of the boundary lies the other side.
    let mut inside = vec![None; net.num_all_faces()];
    let mut open = Vec::new();
    inside[net.outer_face().index()] = Some(false);
    for edge in net.directed_edges().filter(|edge| edge.is_outer_edge()) {
        let face = edge.rev().face().fix();
        if inside[face.index()].is_none() {
            inside[face.index()] = Some(edge.is_constraint_edge());
            open.push(face);
        }
    }
    let mut triangles = Vec::new();
    while let Some(face) = open.pop() {
        let Some(triangle) = net.face(face).as_inner() else { continue };
        let filled = inside[face.index()] == Some(true);
        if filled {
            triangles.push(triangle.vertices().map(|vertex| vertex.index()));
        }
        for edge in triangle.adjacent_edges() {
            let beyond = edge.rev().face().fix();
            if inside[beyond.index()].is_none() {
                inside[beyond.index()] = Some(filled != edge.is_constraint_edge());
                open.push(beyond);
            }
        }
    }
    // A hole that coarse facets have left outside crosses nothing, but has its inside filled.
    let mut side = None;
    for (from, to) in lines {
        let edge = net.get_edge_from_neighbors(handles[from], handles[to]).ok_or(from)?;
        let left = inside[edge.face().fix().index()];
        if *side.get_or_insert(left) != left {
            return Err(from);
        }
    }
    // One order, whatever way the faces were found.
    for triangle in &mut triangles {
        let least = (0..3).min_by_key(|k| triangle[*k]).unwrap_or(0);
        triangle.rotate_left(least);
    }
    triangles.sort_unstable();
    Ok(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(half: f64) -> Vec<[f64; 2]> {
        vec![[-half, -half], [half, -half], [half, half], [-half, half]]
    }

    #[test]
    fn a_frame_keeps_its_hole_and_points_on_a_line() {
        let mut outer = square(2.0);
        outer.insert(1, [0.0, -2.0]);
        let mut hole = square(1.0);
        hole.reverse();
        let polygons = [outer, hole];
        let found = triangles(&polygons, &[]).unwrap();
        let points: Vec<_> = polygons.concat();
        let area = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|k| points[k]);
            ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2.0
        };
        assert!(found.iter().all(|t| area(t) > 0.0));
        assert_eq!(found.iter().map(area).sum::<f64>(), 12.0);
        assert_eq!(found.len(), 9);
    }

    #[test]
    fn what_crosses_touches_or_repeats_is_refused() {
        let crossing = vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(triangles(&[crossing], &[]).is_err());
        let touching = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]];
        assert!(triangles(&[touching], &[]).is_err());
        let repeated = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert!(triangles(&[repeated], &[]).is_err());
        let beside = square(1.0).into_iter().rev().map(|[x, y]| [x + 9.0, y]).collect();
        assert!(triangles(&[square(2.0), beside], &[]).is_err());
    }
}
