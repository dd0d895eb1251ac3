//! Triangles of a solid whose chords stay within a facet error of its arcs.
//!
//! Every edge is cut into points once, and both its faces use these points: the mesh is watertight by construction. Points lie
//! on the surface, chords inside arcs; an arc of angle `a` and radius `R` needs
//!
//! ```text
//! n = ceil( a/(4 asin sqrt(e/(2 R))) )        e = R (1 - cos(a/(2 n))) = 2 R sin^2(a/(4 n))
//! ```
//! facets for a facet error `e`, and at least one for every eighth of a turn.

use super::slope::Slope;
use super::solid::{Curve, Face, Side, Surface};
use super::triangulation::triangles;
use super::{ExportError, Solid};
use lanchester_shape::{Cut, Edge, Point};
use std::f64::consts::{FRAC_PI_4, TAU};

/// Least facet error as part of the largest coordinate: 32-bit floats tell points half as far apart.
const LEAST: f64 = 1e-7;

/// Triangles over shared points, as 32-bit floats.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mesh {
    /// Points in the unit that was asked for.
    pub points: Vec<[f32; 3]>,
    /// Triangles without those that rounding draws together to a line, which leaves the mesh closed.
    pub triangles: Vec<Triangle>,
}

/// A triangle, anticlockwise as seen from outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Triangle {
    /// Numbers of its points.
    pub corners: [usize; 3],
    /// Normals of the solid's face at these points.
    pub normals: [[f64; 3]; 3],
}

/// The mesh of each solid, with `scale` units of the file in a metre.
///
/// # Errors
/// Where the facet error [m] is too small for 32-bit floats or larger than the parts, facets would cross, or a solid is lost in
/// the rounding of the whole.
pub(super) fn meshes(solids: &[Solid], facet_error: f64, scale: f64) -> Result<Vec<Mesh>, ExportError> {
    let most = solids.iter().map(Solid::reach).fold(0.0, f64::max);
    let least = LEAST * most;
    if !(facet_error >= least && facet_error <= most) {
        return Err(ExportError::FacetError { least, most, got: facet_error });
    }
    let mesh = |solid: &Solid| {
        let net = Net::of(solid, facet_error)?;
        let bound = |axis: usize, choose: fn(f64, f64) -> f64| {
            net.points.iter().map(|point| point[axis]).reduce(choose).unwrap_or(0.0)
        };
        let extent = (0..3).map(|axis| bound(axis, f64::max) - bound(axis, f64::min)).fold(most, f64::min);
        if extent < least {
            return Err(ExportError::LostInRounding { part: solid.name.clone(), extent, least });
        }
        let points: Vec<[f32; 3]> =
            net.points.iter().map(|point| point.map(|x| (scale * x) as f32)).collect();
        let whole = |triangle: &Triangle| {
            let [a, b, c] = triangle.corners.map(|at| points[at]);
            a != b && b != c && c != a
        };
        let triangles: Vec<Triangle> = net.triangles.into_iter().filter(whole).collect();
        Ok(Mesh { points, triangles })
    };
    solids.iter().map(mesh).collect()
}

/// Triangles before rounding.
struct Net {
    /// Points [m].
    points: Vec<[f64; 3]>,
    triangles: Vec<Triangle>,
}

impl Net {
    fn of(solid: &Solid, facet_error: f64) -> Result<Net, ExportError> {
        let mut net = Net { points: solid.vertices.clone(), triangles: Vec::new() };
        let mut counts: Vec<usize> = solid.edges.iter().map(|side| pieces(side, facet_error)).collect();
        for face in solid.faces.iter().filter(|face| is_wall(face)) {
            // Facets go from the edge below to the one above.
            let [low, high] = [0, 2].map(|k| face.loops[0][k].0);
            let most = counts[low].max(counts[high]);
            (counts[low], counts[high]) = (most, most);
        }
        let lines: Vec<Vec<usize>> =
            solid.edges.iter().zip(counts).map(|(side, count)| net.points_along(side, count)).collect();
        for face in &solid.faces {
            if is_wall(face) {
                net.wall(face, &lines);
                continue;
            }
            net.end(face, facet_error, &lines).map_err(|at| {
                let [x, y, _] = net.points[at];
                ExportError::FacetsCross { part: solid.name.clone(), at: Point::new(x, y), facet_error }
            })?;
        }
        Ok(net)
    }

    /// The points along an edge with both its ends.
    fn points_along(&mut self, side: &Side, count: usize) -> Vec<usize> {
        let mut line = vec![side.from];
        let z = self.points[side.from][2];
        for k in 1..count {
            let part = k as f64 / count as f64;
            let point = match side.curve {
                Curve::Line => {
                    let (from, to) = (self.points[side.from], self.points[side.to]);
                    [0, 1, 2].map(|i| from[i] + part * (to[i] - from[i]))
                }
                Curve::Arc(arc) => {
                    let at = point_at(&arc, part);
                    [at.x, at.y, z]
                }
                Curve::Rise(plan, slope) => {
                    let at = point_at(&plan, part);
                    [at.x, at.y, slope.height(at)]
                }
            };
            line.push(self.points.len());
            self.points.push(point);
        }
        line.push(side.to);
        line
    }

    /// A face across the axis or a chamfer.
    fn end(&mut self, face: &Face, facet_error: f64, lines: &[Vec<usize>]) -> Result<(), usize> {
        let polygon = |boundary: &Vec<(usize, bool)>| -> Vec<usize> {
            boundary.iter().flat_map(|(edge, forward)| without_end(&lines[*edge], *forward)).collect()
        };
        let polygons: Vec<Vec<usize>> = face.loops.iter().map(polygon).collect();
        let place = |at: &usize| [self.points[*at][0], self.points[*at][1]];
        let flat: Vec<Vec<[f64; 2]>> =
            polygons.iter().map(|polygon| polygon.iter().map(place).collect()).collect();
        let mut numbers = polygons.concat();
        let (up, within) = match face.surface {
            Surface::Slope(slope) => {
                let within = cone_points(&slope, &flat, facet_error);
                for [x, y] in &within {
                    numbers.push(self.points.len());
                    self.points.push([*x, *y, slope.height(Point::new(*x, *y))]);
                }
                (slope.into < 0.0, within)
            }
            Surface::Level { up } => (up, Vec::new()),
            Surface::Flat { .. } | Surface::Round { .. } => (true, Vec::new()),
        };
        for [a, b, c] in triangles(&flat, &within).map_err(|at| numbers[at])? {
            let corners = if up { [a, b, c] } else { [a, c, b] }.map(|k| numbers[k]);
            let normals = corners.map(|at| self.normal(&face.surface, at));
            self.triangles.push(Triangle { corners, normals });
        }
        Ok(())
    }

    /// Two triangles between each facet of the edge below and the one above it.
    fn wall(&mut self, face: &Face, lines: &[Vec<usize>]) {
        let ((low, around), (high, _)) = (face.loops[0][0], face.loops[0][2]);
        for (below, above) in lines[low].windows(2).zip(lines[high].windows(2)) {
            let [a, b, c, d] = [below[0], below[1], above[1], above[0]];
            let halves = if around { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
            for corners in halves {
                let normals = corners.map(|at| self.normal(&face.surface, at));
                self.triangles.push(Triangle { corners, normals });
            }
        }
    }

    fn normal(&self, surface: &Surface, at: usize) -> [f64; 3] {
        let [x, y, _] = self.points[at];
        let out = match *surface {
            Surface::Level { up } => return [0.0, 0.0, if up { 1.0 } else { -1.0 }],
            Surface::Slope(slope) => return slope.normal(Point::new(x, y)),
            Surface::Flat { normal } => normal,
            Surface::Round { centre, outwards, .. } => {
                let away = Point::new(x, y) - centre;
                away * (if outwards { 1.0 } else { -1.0 } / away.norm())
            }
        };
        [out.x, out.y, 0.0]
    }
}

/// The points of a line but the last in its sense.
fn without_end(line: &[usize], forward: bool) -> Vec<usize> {
    let mut points = line.to_vec();
    if !forward {
        points.reverse();
    }
    points.pop();
    points
}

fn is_wall(face: &Face) -> bool {
    matches!(face.surface, Surface::Flat { .. } | Surface::Round { .. })
}

/// How many facets keep an edge of a solid within the facet error.
fn pieces(side: &Side, facet_error: f64) -> usize {
    let Curve::Rise(plan, slope) = side.curve else {
        return side.curve.arc().map_or(1, |arc| facets(&arc, facet_error));
    };
    let (length, turn) = (plan.length(), 4.0 * plan.bulge.abs().atan());
    let across = if turn == 0.0 { 0.0 } else { plan.radius() * turn * turn };
    // Second derivative of the distance from the axis by the part of the length.
    let along = match slope.cut {
        Cut::Milled { .. } => across,
        Cut::Turned { .. } => length * length / plan.nearest(Point::ORIGIN).0 + across,
    };
    let bend = across.hypot(slope.angle.tan() * along);
    // Triangles of the cone between this edge and other points add their own error: a quarter of it here.
    let part = if let Cut::Turned { .. } = slope.cut { 2.0 } else { 8.0 };
    let count = (bend / (part * facet_error)).sqrt().ceil() as usize;
    count.max(if turn == 0.0 { 1 } else { facets(&plan, facet_error) })
}

/// Points of a cone within polygons across the crank, on circles about its axis, as far apart as facets of the facet error may be
/// wide, but of a fine mesh on few circles: from one to the next a cone is straight.
fn cone_points(slope: &Slope, polygons: &[Vec<[f64; 2]>], facet_error: f64) -> Vec<[f64; 2]> {
    const MOST_CIRCLES: f64 = 48.0;
    let Cut::Turned { radius } = slope.cut else { return Vec::new() };
    let most = polygons.iter().flatten().map(|[x, y]| x.hypot(*y)).fold(radius, f64::max);
    // Triangles between them may be half as wide again.
    let count = (TAU / (2.0 * facet_error / most).sqrt().min(FRAC_PI_4)).ceil();
    let width = TAU / count;
    let growth = width.max((most / radius).ln() / MOST_CIRCLES).exp();
    let lines: Vec<Edge> = polygons
        .iter()
        .flat_map(|polygon| polygon.iter().zip(polygon.iter().cycle().skip(1)))
        .map(|(from, to)| Edge::line(Point::new(from[0], from[1]), Point::new(to[0], to[1])))
        .collect();
    let mut points = Vec::new();
    let mut distance = radius * growth.sqrt();
    while distance < most {
        for k in 0..count as usize {
            let at = Point::polar(distance, k as f64 * width);
            // To the right of it an odd number of lines where it lies within.
            let crossed = |line: &&Edge| {
                (line.from.y > at.y) != (line.to.y > at.y)
                    && (line.to - line.from).cross(at - line.from) * (line.to.y - line.from.y) > 0.0
            };
            let is_near = |line: &Edge| line.nearest(at).0 < 0.4 * width * distance;
            if lines.iter().filter(crossed).count() % 2 == 1 && !lines.iter().any(is_near) {
                points.push([at.x, at.y]);
            }
        }
        distance *= growth;
    }
    points
}

/// How many facets keep an arc within the facet error.
fn facets(arc: &Edge, facet_error: f64) -> usize {
    let (angle, radius) = (4.0 * arc.bulge.abs().atan(), arc.radius());
    // Beyond a quarter of the angle is never needed: there the facets for every eighth of a turn decide.
    let quarter = (facet_error / (2.0 * radius)).sqrt().min(1.0).asin();
    let count = (angle / (4.0 * quarter)).max(angle / FRAC_PI_4).ceil();
    // Two arcs that share both ends keep apart by their middles.
    (count as usize).max(2)
}

/// The point at a part of the length between 0 and 1.
fn point_at(arc: &Edge, part: f64) -> Point {
    if arc.bulge.abs() <= 1.0 {
        return arc.at(part).0;
    }
    let [first, second] = arc.halves();
    if part < 0.5 { first.at(2.0 * part).0 } else { second.at(2.0 * part - 1.0).0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facets_are_as_few_as_the_error_allows() {
        for (radius, sweep, error) in [(0.05, 3.0, 1e-5), (0.05, -6.0, 1e-6), (40.0, 1e-3, 1e-7)] {
            let arc = Edge::arc(Point::new(0.1, 0.2), radius, 0.4, sweep);
            let count = facets(&arc, error);
            let height = |count: usize| 2.0 * radius * (sweep.abs() / (4.0 * count as f64)).sin().powi(2);
            assert!(height(count) <= error * (1.0 + 1e-9), "{count}");
            assert!(height(count - 1) > error, "{count}");
        }
    }
}
