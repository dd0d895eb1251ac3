//! A solid by its boundary: vertices, edges and faces that share them.

use super::bore::Bore;
use super::slope::Slope;
use super::{ExportError, RESOLUTION};
use lanchester_shape::Contour;
use lanchester_shape::Edge;
use lanchester_shape::Point;

/// A closed body of planes, cylinders and cones, with a name and a colour.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    pub(super) name: String,
    pub(super) colour: [f64; 3],
    /// Corners [m].
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) edges: Vec<Side>,
    pub(super) faces: Vec<Face>,
    /// How many closed shells: the outer one and one for each cavity within.
    pub(super) shells: usize,
}

/// An edge between two vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    /// Vertex where it begins.
    pub from: usize,
    /// Vertex where it ends.
    pub to: usize,
    /// What it runs along.
    pub curve: Curve,
}

/// What an edge runs along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Curve {
    /// A straight line.
    Line,
    /// An arc in the plane z of both vertices.
    Arc(Edge),
    /// On the surface of a chamfer, above or below an edge across the crank.
    Rise(Edge, Slope),
}

impl Curve {
    /// An edge in a plane across the crank.
    pub fn level(edge: &Edge) -> Curve {
        if edge.bulge == 0.0 { Curve::Line } else { Curve::Arc(*edge) }
    }

    /// What it is across the crank, where it is no straight line there.
    pub fn arc(&self) -> Option<Edge> {
        match self {
            Curve::Line => None,
            Curve::Arc(edge) | Curve::Rise(edge, _) => (edge.bulge != 0.0).then_some(*edge),
        }
    }
}

/// Surface of a face, with its normal out of the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Surface {
    /// Plane across the crank axis.
    Level {
        /// Whether its normal points to larger z.
        up: bool,
    },
    /// Plane along the crank axis.
    Flat {
        /// Its normal.
        normal: Point,
    },
    /// Cylinder along the crank axis.
    Round {
        /// Its axis [m].
        centre: Point,
        /// Its radius [m].
        radius: f64,
        /// Whether its normal points away from its axis.
        outwards: bool,
    },
    /// A chamfer: a cone about the crank axis or a plane at an angle against it.
    Slope(Slope),
}

/// A face, with its boundary anticlockwise about its normal.
///
/// A flat or round face is a wall: its only loop is the edge below, an upright, the edge above, an upright; the edge below runs
/// forward where the material lies on its left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Face {
    pub surface: Surface,
    /// Shell that it belongs to.
    pub shell: usize,
    /// Loops, the outer one first, of edges and whether each runs forward.
    pub loops: Vec<Vec<(usize, bool)>>,
}

/// A contour at one height: the numbers of its vertices and edges.
pub(super) struct Ring {
    pub vertices: Vec<usize>,
    pub edges: Vec<usize>,
}

impl Ring {
    fn forward(&self) -> Vec<(usize, bool)> {
        self.edges.iter().map(|edge| (*edge, true)).collect()
    }

    /// Its edges run backward.
    pub fn backward(&self) -> Vec<(usize, bool)> {
        self.edges.iter().rev().map(|edge| (*edge, false)).collect()
    }
}

impl Solid {
    /// A prism over an outer contour with holes through it, and bores, between two heights [m].
    pub(super) fn prism(
        (name, colour): (String, [f64; 3]),
        contours: &[Vec<Edge>],
        bores: &[Bore],
        [front, rear]: [f64; 2],
    ) -> Solid {
        let mut solid = Solid::empty(name, colour);
        let (mut in_front, mut behind) = (Vec::new(), Vec::new());
        for (number, contour) in contours.iter().enumerate() {
            let (low, high) = (solid.ring(contour, front), solid.ring(contour, rear));
            solid.walls(contour, [&low, &high], number == 0, 0);
            in_front.push(low);
            behind.push(high);
        }
        for bore in bores {
            solid.bore(bore, [front, rear], [&mut in_front, &mut behind]);
        }
        solid.level(false, &in_front.iter().collect::<Vec<_>>(), 0);
        solid.level(true, &behind.iter().collect::<Vec<_>>(), 0);
        solid
    }

    /// Without any face yet.
    pub(super) fn empty(name: String, colour: [f64; 3]) -> Solid {
        Solid { name, colour, vertices: Vec::new(), edges: Vec::new(), faces: Vec::new(), shells: 1 }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its colour: red, green and blue between 0 and 1, as a screen shows them.
    pub fn colour(&self) -> [f64; 3] {
        self.colour
    }

    /// Largest coordinate of a point of it, whatever the sign [m]: of the vertices, and of arcs by their box.
    pub(super) fn reach(&self) -> f64 {
        let vertices = self.vertices.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        let arcs = self.edges.iter().filter_map(|side| side.curve.arc());
        arcs.map(|arc| arc.farthest(Point::ORIGIN).0).fold(vertices, f64::max)
    }

    /// A contour at one height.
    pub(super) fn ring(&mut self, contour: &[Edge], z: f64) -> Ring {
        let first = self.vertices.len();
        let count = contour.len();
        self.vertices.extend(contour.iter().map(|edge| [edge.from.x, edge.from.y, z]));
        let vertices: Vec<usize> = (first..first + count).collect();
        let edges = (0..count)
            .map(|k| self.side(vertices[k], vertices[(k + 1) % count], Curve::level(&contour[k])))
            .collect();
        Ring { vertices, edges }
    }

    /// An edge between two vertices.
    pub(super) fn side(&mut self, from: usize, to: usize, curve: Curve) -> usize {
        self.edges.push(Side { from, to, curve });
        self.edges.len() - 1
    }

    /// The walls between a contour at two heights; `around` where the material lies within the contour.
    fn walls(&mut self, contour: &[Edge], [low, high]: [&Ring; 2], around: bool, shell: usize) {
        let count = contour.len();
        let uprights: Vec<usize> =
            (0..count).map(|k| self.side(low.vertices[k], high.vertices[k], Curve::Line)).collect();
        for (k, edge) in contour.iter().enumerate() {
            let (start, end) = (uprights[k], uprights[(k + 1) % count]);
            let boundary = if around {
                vec![(low.edges[k], true), (end, true), (high.edges[k], false), (start, false)]
            } else {
                vec![(low.edges[k], false), (start, true), (high.edges[k], true), (end, false)]
            };
            let surface = wall_surface(edge, around);
            self.faces.push(Face { surface, shell, loops: vec![boundary] });
        }
    }

    /// A face across the axis within the first ring and without the others.
    fn level(&mut self, up: bool, rings: &[&Ring], shell: usize) {
        let (outer, inner) = (rings[0], &rings[1..]);
        let first = if up { outer.forward() } else { outer.backward() };
        let others = inner.iter().map(|ring| if up { ring.backward() } else { ring.forward() });
        let loops = std::iter::once(first).chain(others).collect();
        self.faces.push(Face { surface: Surface::Level { up }, shell, loops });
    }

    /// The walls and shoulders of a bore; where it opens at a face, its ring joins those of that face.
    pub(super) fn bore(
        &mut self,
        bore: &Bore,
        [front, rear]: [f64; 2],
        [in_front, behind]: [&mut Vec<Ring>; 2],
    ) {
        let (opens_in_front, opens_behind) = (bore.opens_in_front, bore.opens_behind);
        let shell = if opens_in_front || opens_behind { 0 } else { self.shells };
        self.shells = self.shells.max(shell + 1);
        let mut before: Option<(f64, Ring)> = None;
        for (number, step) in bore.steps.iter().enumerate() {
            let circle = circle(bore.centre, step.radius);
            let last = number + 1 == bore.steps.len();
            let to = if opens_behind && last { rear } else { front + step.to };
            let (low, high) = (self.ring(&circle, front + step.from), self.ring(&circle, to));
            self.walls(&circle, [&low, &high], false, shell);
            match before {
                None if opens_in_front => in_front.push(low),
                None => self.level(true, &[&low], shell),
                Some((radius, ring)) if radius > step.radius => self.level(false, &[&ring, &low], shell),
                Some((_, ring)) => self.level(true, &[&low, &ring], shell),
            }
            before = Some((step.radius, high));
        }
        if let Some((_, high)) = before {
            if opens_behind { behind.push(high) } else { self.level(false, &[&high], shell) }
        }
    }
}

/// The surface of a wall; `around` where the material lies on the left of its edge.
pub(super) fn wall_surface(edge: &Edge, around: bool) -> Surface {
    if edge.bulge == 0.0 {
        let along = edge.to - edge.from;
        let right = along.right() * (1.0 / along.norm());
        return Surface::Flat { normal: if around { right } else { -right } };
    }
    Surface::Round { centre: edge.centre(), radius: edge.radius(), outwards: (edge.bulge > 0.0) == around }
}

/// The edges of a contour as they are exported: arcs that are not told from their chord become lines.
///
/// # Errors
/// Where an edge is too short.
pub(super) fn exported_edges(name: &str, contour: &Contour) -> Result<Vec<Edge>, ExportError> {
    let count = contour.edges().len();
    let mut edges = Vec::with_capacity(count);
    for edge in contour.edges() {
        let half = edge.half_chord();
        if 2.0 * half < RESOLUTION {
            let (part, at, length) = (name.to_string(), edge.from, 2.0 * half);
            return Err(ExportError::ShortEdge { part, at, length });
        }
        // Between two edges the arc is all that keeps them apart.
        let flat = half * edge.bulge.abs() < RESOLUTION && count > 2;
        edges.push(if flat { Edge { bulge: 0.0, ..*edge } } else { *edge });
    }
    Ok(edges)
}

/// A circle as two half circles, anticlockwise.
pub(super) fn circle(centre: Point, radius: f64) -> Vec<Edge> {
    let (right, left) = (centre + Point::new(radius, 0.0), centre - Point::new(radius, 0.0));
    vec![Edge { from: right, to: left, bulge: 1.0 }, Edge { from: left, to: right, bulge: 1.0 }]
}
