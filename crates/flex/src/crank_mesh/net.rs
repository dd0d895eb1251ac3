//! Plane nets of triangles through given chords.

use super::circles::Chords;
use lanchester_shape::Point;
use spade::{AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};

/// Smallest angle that refinement asks for.
const ANGLE: f64 = 26.0;

/// Points and triangles, anticlockwise.
#[derive(Debug, Clone, Default)]
pub(super) struct Net {
    /// The given points first, in their order.
    pub points: Vec<Point>,
    pub triangles: Vec<[usize; 3]>,
}

/// A net through these chords, none of which is cut; triangles away from them have about the edge `size` [m]. It covers the convex hull.
///
/// # Errors
/// A point of a chord that crosses another.
pub(super) fn net(chords: &Chords, size: f64) -> Result<Net, Point> {
    let mut net = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let mut handles = Vec::with_capacity(chords.points.len());
    for point in &chords.points {
        let tidy = |c: f64| if c.abs() < 1e-15 { 0.0 } else { c };
        let handle = net.insert(Point2::new(tidy(point.x), tidy(point.y))).map_err(|_| *point)?;
        if handle.index() != handles.len() {
            return Err(*point);
        }
        handles.push(handle);
    }
    for ([from, to], _) in &chords.chords {
        let (a, b) = (handles[*from], handles[*to]);
        if !net.can_add_constraint(a, b) {
            return Err(chords.points[*from]);
        }
        net.add_constraint(a, b);
    }
    let parameters = RefinementParameters::<f64>::new()
        .keep_constraint_edges()
        .with_angle_limit(AngleLimit::from_deg(ANGLE))
        .with_max_allowed_area(0.45 * size * size)
        .with_max_additional_vertices(20 * chords.points.len() + 20_000);
    net.refine(parameters);
    let points = net.vertices().map(|vertex| Point::new(vertex.position().x, vertex.position().y)).collect();
    let mut triangles: Vec<[usize; 3]> = net
        .inner_faces()
        .map(|face| {
            let mut corners = face.vertices().map(|vertex| vertex.index());
            let first = (0..3).min_by_key(|k| corners[*k]).unwrap_or(0);
            corners.rotate_left(first);
            corners
        })
        .collect();
    triangles.sort_unstable();
    Ok(Net { points, triangles })
}
