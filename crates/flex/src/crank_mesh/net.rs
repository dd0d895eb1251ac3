//! Plane nets of triangles through given chords.

use super::chords::Chords;
use lanchester_shape::Point;
use spade::{AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};
use std::collections::{HashMap, HashSet};

/// Smallest angle that refinement asks for.
const ANGLE: f64 = 26.0;
/// Triangles lower than this are none [m].
const FLAT: f64 = 1e-8;
/// Two chords that meet at a larger angle [rad] are one smooth line, whatever they belong to.
const EAR: f64 = 2.3;

/// Sweeps in which points are moved between their neighbours.
const SWEEPS: usize = 12;

/// Points and triangles, anticlockwise.
#[derive(Debug, Clone, Default)]
pub(super) struct Net {
    /// The given points first, in their order.
    pub points: Vec<Point>,
    pub triangles: Vec<[usize; 3]>,
}

/// A net through these chords, none of which is cut; triangles away from them have about the edge `size` [m]. It covers the convex hull.
/// `is_smooth`: whether the chords from a point to two others belong to one smooth line.
///
/// # Errors
/// A point of a chord that crosses another.
pub(super) fn net(
    chords: &Chords,
    size: f64,
    is_smooth: impl Fn(usize, [usize; 2]) -> bool,
) -> Result<Net, Point> {
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
    if net.inner_faces().any(|face| is_flat(face.positions())) {
        // Nearly straight lines of the hull leave triangles whose circumcentres are out of reach: a frame takes the hull's place.
        frame(&mut net, size).map_err(|_| chords.points[0])?;
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
    let mut net = Net { points, triangles };
    net.flip_ears(chords, is_smooth);
    net.relax(chords.points.len());
    // Points on one straight line of the hull leave triangles of rounding outside it.
    let is_flat = |corners: &[usize; 3]| {
        let side = |k: usize| (net.points[corners[k]] - net.points[corners[(k + 1) % 3]]).norm();
        net.area(*corners) < FLAT * side(0).max(side(1)).max(side(2))
    };
    let triangles = net.triangles.iter().copied().filter(|corners| !is_flat(corners)).collect();
    net.triangles = triangles;
    Ok(net)
}

/// Whether a triangle's circumcentre is too far away to be found among the others: its height is rounding beside its longest side.
fn is_flat(corners: [Point2<f64>; 3]) -> bool {
    let [a, b, c] = corners.map(|at| Point::new(at.x, at.y));
    let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
    (b - a).cross(c - a).abs() < FLAT * longest
}

/// Inserts the corners of a rectangle about all points, two edges of elements away.
fn frame(
    net: &mut ConstrainedDelaunayTriangulation<Point2<f64>>,
    size: f64,
) -> Result<(), spade::InsertionError> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for vertex in net.vertices() {
        let at = vertex.position();
        for (k, value) in [at.x, at.y].into_iter().enumerate() {
            (low[k], high[k]) = (low[k].min(value), high[k].max(value));
        }
    }
    let room = 2.0 * size;
    for (x, y) in [
        (low[0] - room, low[1] - room),
        (high[0] + room, low[1] - room),
        (high[0] + room, high[1] + room),
        (low[0] - room, high[1] + room),
    ] {
        net.insert(Point2::new(x, y))?;
    }
    Ok(())
}

impl Net {
    /// A triangle with two chords of one smooth line, which are arcs, would be folded at the corner between them: its third edge is
    /// turned to that corner.
    fn flip_ears(&mut self, chords: &Chords, is_smooth: impl Fn(usize, [usize; 2]) -> bool) {
        let lines: HashSet<[usize; 2]> = chords.chords.iter().map(|([a, b], _)| key(*a, *b)).collect();
        let mut beside: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
        for (index, triangle) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                beside.entry(key(triangle[k], triangle[(k + 1) % 3])).or_default().push(index);
            }
        }
        for index in 0..self.triangles.len() {
            let triangle = self.triangles[index];
            for k in 0..3 {
                let [v, a, b] = [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
                let is_ear =
                    lines.contains(&key(v, a)) && lines.contains(&key(v, b)) && !lines.contains(&key(a, b));
                if !is_ear || self.angle(v, a, b) < EAR && !is_smooth(v, [a, b]) {
                    continue;
                }
                let others = beside.get(&key(a, b)).cloned().unwrap_or_default();
                let Some(other) = others.into_iter().find(|other| *other != index) else { continue };
                let Some(w) = self.triangles[other].into_iter().find(|point| *point != a && *point != b)
                else {
                    continue;
                };
                let (one, two) = ([v, a, w], [v, w, b]);
                if self.area(one) <= 0.0 || self.area(two) <= 0.0 {
                    continue;
                }
                self.triangles[index] = one;
                self.triangles[other] = two;
                beside.remove(&key(a, b));
                beside.insert(key(v, w), vec![index, other]);
                for (edge, from, to) in [(key(a, w), other, index), (key(v, b), index, other)] {
                    for owner in beside.entry(edge).or_default() {
                        if *owner == from {
                            *owner = to;
                        }
                    }
                }
                break;
            }
        }
    }

    /// Moves points after the first ones towards the middle of their neighbours where that mends the worst triangle around.
    fn relax(&mut self, first: usize) {
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); self.points.len()];
        let mut count: HashMap<[usize; 2], usize> = HashMap::new();
        for (index, triangle) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                around[triangle[k]].push(index);
                *count.entry(key(triangle[k], triangle[(k + 1) % 3])).or_default() += 1;
            }
        }
        let mut is_fixed = vec![false; self.points.len()];
        is_fixed[..first].fill(true);
        for end in count.iter().filter(|(_, count)| **count == 1).flat_map(|(edge, _)| edge) {
            is_fixed[*end] = true;
        }
        for _ in 0..SWEEPS {
            for point in first..self.points.len() {
                if is_fixed[point] || around[point].is_empty() {
                    continue;
                }
                let here = self.points[point];
                // Each neighbour belongs to two of the triangles.
                let corners = around[point].iter().flat_map(|triangle| self.triangles[*triangle]);
                let others = corners.filter(|other| *other != point).map(|other| self.points[other]);
                let middle =
                    others.fold(Point::ORIGIN, |sum, at| sum + at) * (0.5 / around[point].len() as f64);
                let mut best = (self.worst(&around[point]), here);
                for part in [1.0, 0.5, 0.25] {
                    self.points[point] = here + (middle - here) * part;
                    let shape = self.worst(&around[point]);
                    if shape > best.0 {
                        best = (shape, self.points[point]);
                    }
                }
                self.points[point] = best.1;
            }
        }
    }

    /// Shape of the worst of some triangles: `4 sqrt(3) A/(a^2 + b^2 + c^2)`, 1 of an equilateral one.
    fn worst(&self, triangles: &[usize]) -> f64 {
        let shape = |triangle: &usize| {
            let [a, b, c] = self.triangles[*triangle].map(|corner| self.points[corner]);
            let squares = [b - a, c - b, a - c].iter().map(|side| side.dot(*side)).sum::<f64>();
            2.0 * 3f64.sqrt() * (b - a).cross(c - a) / squares
        };
        triangles.iter().map(shape).fold(f64::INFINITY, f64::min)
    }

    fn angle(&self, at: usize, a: usize, b: usize) -> f64 {
        let (u, v) = (self.points[a] - self.points[at], self.points[b] - self.points[at]);
        (u.dot(v) / (u.norm() * v.norm())).clamp(-1.0, 1.0).acos()
    }

    fn area(&self, [a, b, c]: [usize; 3]) -> f64 {
        (self.points[b] - self.points[a]).cross(self.points[c] - self.points[a])
    }
}

fn key(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}
