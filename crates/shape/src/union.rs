//! The union of two outlines.
//!
//! All edges are cut where they meet the other outline and where a corner lies on them. A piece stays where it is outside the other
//! outline; of two pieces that run along each other one stays if both have their material on the same side, none where they are
//! the seam between two neighbours or the two sides of one tip. What stays is put together again into closed contours. Nothing is moved: a corner of the
//! union is a corner of an outline or a meeting of two edges, and areas hold to rounding.
//!
//! Points and edges closer than some roundings count as one, so that edges which coincide but for rounding are found to coincide.
//! An edge that is too short for a contour is left out where that changes the area least. Where chains stay open or what is left
//! touches itself, all is done again with a larger distance: that moves corners, and the long edges that end there.

use crate::contour::{self, Contour};
use crate::crossing::{TOUCH, meetings};
use crate::edge::Edge;
use crate::error::GeometryError;
use crate::outline::Outline;
use crate::point::Point;

/// The distance that counts as none over the least length of an edge ([`TOUCH`] of the size), one attempt after the other: some
/// roundings; so much that no edges come too close; and more.
const ATTEMPTS: [f64; 4] = [1e-3, 2.0, 20.0, 200.0];
/// Bulge of an eighth of a turn: longer arcs are cut, so that radius and chord tell the angle of each part without loss.
const EIGHTH: f64 = 0.198_912_367_379_658;
/// Edges are joined into one where that moves none of their points by more than this part of the size: a few roundings.
const SAME: f64 = 1e-14;
/// Arcs are joined up to this bulge (three quarters of a turn), since a short chord tells little of a long arc.
const LONGEST: f64 = 2.414_213_562_373_095;

impl Outline {
    /// The outline of all that lies in this one or in the other: exact to rounding, also where edges coincide or touch.
    ///
    /// Holes that neither fills stay, and new ones may come to be. What is closer than 2e-9 of the size may be taken for touching.
    ///
    /// # Errors
    /// Where the outlines do not overlap and share no length of edge, where the union touches itself in a point, or where edges run
    /// so close beside each other that rounding decides.
    pub fn union(&self, other: &Outline) -> Result<Outline, GeometryError> {
        let origin = self.outer().edges()[0].from;
        let size = self.outer().farthest(origin).0.max(other.outer().farthest(origin).0);
        let areas = [self, other].map(|outline| outline.moments().area);
        let mut failure = GeometryError::TooClose { at: origin };
        for attempt in ATTEMPTS {
            let tolerance = attempt * TOUCH * size;
            match Joining::new([self, other], tolerance).union(size) {
                Ok(union) => {
                    let (area, slack) = (union.moments().area, tolerance * size);
                    if area >= areas[0].max(areas[1]) - slack && area <= areas[0] + areas[1] + slack {
                        return Ok(union);
                    }
                }
                Err(error @ GeometryError::Disjoint { .. }) if attempt > 1.0 => return Err(error),
                Err(GeometryError::Crossing { at, .. } | GeometryError::ZeroLength { at, .. }) => {
                    failure = GeometryError::TooClose { at };
                }
                Err(error) => failure = error,
            }
        }
        Err(failure)
    }
}

/// An edge of one of both outlines, with the material on its left, between two nodes.
#[derive(Clone, Copy)]
struct Piece {
    /// Whose it is: 0 or 1.
    owner: usize,
    from: usize,
    to: usize,
    edge: Edge,
}

/// Two outlines cut at each other.
struct Joining<'a> {
    outlines: [&'a Outline; 2],
    tolerance: f64,
    /// Points where pieces begin and end, none closer to another than the tolerance.
    nodes: Vec<Point>,
    pieces: Vec<Piece>,
}

impl<'a> Joining<'a> {
    fn new(outlines: [&'a Outline; 2], tolerance: f64) -> Joining<'a> {
        let mut joining = Joining { outlines, tolerance, nodes: Vec::new(), pieces: Vec::new() };
        let edges = outlines.map(directed_edges);
        let ends: Vec<[usize; 2]> =
            edges.iter().flatten().map(|edge| [joining.node(edge.from), joining.node(edge.to)]).collect();
        for first in &edges[0] {
            for second in &edges[1] {
                for meeting in meetings(first, second, tolerance) {
                    joining.node(meeting);
                }
            }
        }
        let owners = [0, 1].into_iter().flat_map(|owner| edges[owner].iter().map(move |edge| (owner, edge)));
        for ((owner, edge), ends) in owners.zip(ends) {
            joining.cut(owner, edge, ends);
        }
        joining
    }

    /// The node at a point: one that is there, or a new one.
    fn node(&mut self, point: Point) -> usize {
        let near = self.nodes.iter().position(|node| (*node - point).norm() <= self.tolerance);
        near.unwrap_or_else(|| {
            self.nodes.push(point);
            self.nodes.len() - 1
        })
    }

    /// Cuts an edge at the nodes that lie on it.
    fn cut(&mut self, owner: usize, edge: &Edge, [start, end]: [usize; 2]) {
        let chord = edge.to - edge.from;
        // On at most a quarter of a turn the points of an arc follow each other along the chord too.
        let along = |node: &usize| (self.nodes[*node] - edge.from).dot(chord) / chord.dot(chord);
        let mut on_it: Vec<usize> = (0..self.nodes.len())
            .filter(|node| *node != start && *node != end)
            .filter(|node| (0.0..1.0).contains(&along(node)))
            .filter(|node| edge.nearest(self.nodes[*node]).0 <= self.tolerance)
            .collect();
        on_it.sort_by(|a, b| along(a).total_cmp(&along(b)));
        let whole = on_it.is_empty();
        let mut from = start;
        for to in on_it.into_iter().chain([end]) {
            if from == to {
                continue;
            }
            let (p, q) = (self.nodes[from], self.nodes[to]);
            let edge = if whole { Edge { from: p, to: q, ..*edge } } else { between(edge, p, q) };
            self.pieces.push(Piece { owner, from, to, edge });
            from = to;
        }
    }

    /// Whether a piece is part of the boundary of the union.
    fn stays(&self, piece: &Piece) -> bool {
        let [own, others] = [piece.owner, 1 - piece.owner].map(|owner| self.along(piece, owner));
        // Nothing of its own is left where it goes there and back: the tip of a cusp, or a gap, too narrow to be told from none.
        if own == 0 || others < 0 {
            return false;
        }
        if others > 0 {
            return piece.owner == 0;
        }
        let other = self.outlines[1 - piece.owner];
        let places = [0.5, 0.25, 0.75].map(|part| piece.edge.at(part).0);
        let clearest = places.into_iter().map(|place| (other.nearest(place).0, place));
        let (_, place) =
            clearest.fold((-1.0, places[0]), |best, next| if next.0 > best.0 { next } else { best });
        !other.contains(place)
    }

    /// How many pieces of an owner run along a piece in its direction, less those that run against it.
    fn along(&self, piece: &Piece, owner: usize) -> isize {
        let near = |other: &&Piece| {
            other.owner == owner && (other.edge.middle() - piece.edge.middle()).norm() <= 2.0 * self.tolerance
        };
        let sense = |other: &Piece| match (other.from, other.to) {
            ends if ends == (piece.from, piece.to) => 1,
            ends if ends == (piece.to, piece.from) => -1,
            _ => 0,
        };
        self.pieces.iter().filter(near).map(sense).sum()
    }

    fn union(&self, size: f64) -> Result<Outline, GeometryError> {
        let kept: Vec<Piece> = self.pieces.iter().filter(|piece| self.stays(piece)).copied().collect();
        let mut leaving = vec![None; self.nodes.len()];
        for (number, piece) in kept.iter().enumerate() {
            if leaving[piece.from].replace(number).is_some() {
                return Err(GeometryError::Pinched { at: self.nodes[piece.from] });
            }
        }
        let (mut outer, mut holes) = (None::<Contour>, Vec::new());
        let mut used = vec![false; kept.len()];
        for first in 0..kept.len() {
            let mut chain = Vec::new();
            let mut next = first;
            while !used[next] {
                used[next] = true;
                chain.push(kept[next].edge);
                let node = kept[next].to;
                next = leaving[node].ok_or(GeometryError::TooClose { at: self.nodes[node] })?;
            }
            if chain.is_empty() {
                continue;
            }
            if next != first {
                return Err(GeometryError::TooClose { at: self.nodes[kept[next].from] });
            }
            let chain = Contour::of_simple_edges(joined(without_short(chain), size));
            let area = chain.moments().area;
            if area.abs() <= self.tolerance * chain.length() {
                // A gap too narrow to be told from none.
            } else if area < 0.0 {
                let edges = chain.edges().iter().rev().map(Edge::reversed).collect();
                holes.push(Contour::checked(edges)?);
            } else if let Some(outer) = &outer {
                let (first, second) = (outer.edges()[0].from, chain.edges()[0].from);
                return Err(GeometryError::Disjoint { first, second });
            } else {
                outer = Some(Contour::checked(chain.edges().to_vec())?);
            }
        }
        let outer = outer.ok_or(GeometryError::TooClose { at: self.nodes[0] })?;
        Outline::new(outer, holes)
    }
}

/// All edges with the material on their left, arcs cut so that none is longer than an eighth of a turn or half of that before.
fn directed_edges(outline: &Outline) -> Vec<Edge> {
    let outer = outline.outer().edges().iter().copied();
    let holes = outline.holes().iter().flat_map(|hole| hole.edges().iter().map(Edge::reversed));
    outer.chain(holes).flat_map(short).collect()
}

fn short(edge: Edge) -> Vec<Edge> {
    if edge.bulge.abs() <= EIGHTH * 1.000_001 {
        return vec![edge];
    }
    edge.halves().into_iter().flat_map(short).collect()
}

/// The part of a line or of a short arc between two of its points: half its chord is the radius times the sine of half its angle.
fn between(edge: &Edge, from: Point, to: Point) -> Edge {
    if edge.bulge == 0.0 {
        return Edge::line(from, to);
    }
    let (radius, half) = (edge.radius(), (to - from).norm() / 2.0);
    let cosine = ((radius - half) * (radius + half)).max(0.0).sqrt();
    Edge { from, to, bulge: (half / (radius + cosine)).copysign(edge.bulge) }
}

/// A closed chain without edges that are too short for a contour: the neighbours of such an edge meet at one of its ends, or
/// beside it where their lines or circles do, whichever changes the area least.
fn without_short(mut edges: Vec<Edge>) -> Vec<Edge> {
    while edges.len() > 2 {
        let least = TOUCH * contour::size(&edges);
        let Some(at) = edges.iter().position(|edge| 2.0 * edge.half_chord() <= least) else { break };
        let (before, after) = ((at + edges.len() - 1) % edges.len(), (at + 1) % edges.len());
        let [first, short, last] = [before, at, after].map(|at| edges[at]);
        let at_corner = |corner| [between(&first, first.from, corner), between(&last, corner, last.to)];
        let change = |corner: &Point| {
            let old = [last, short, first].map(|edge| edge.reversed());
            let sliver = at_corner(*corner).into_iter().chain(old).collect();
            Contour::of_simple_edges(sliver).moments().area.abs()
        };
        let beside = meetings(&first, &last, least).filter(|at| (*at - short.from).norm() <= 2.0 * least);
        let corners = [short.from, short.to].into_iter().chain(beside);
        let corner = corners.min_by(|a, b| change(a).total_cmp(&change(b)));
        [edges[before], edges[after]] = at_corner(corner.expect("invariant: an edge has two ends"));
        edges.remove(at);
    }
    edges
}

/// A closed chain with edges joined that go on along the same line or circle.
fn joined(chain: Vec<Edge>, size: f64) -> Vec<Edge> {
    let mut edges: Vec<Edge> = Vec::with_capacity(chain.len());
    for edge in chain {
        match edges.last_mut() {
            Some(last) => match together(last, &edge, size) {
                Some(both) => *last = both,
                None => edges.push(edge),
            },
            None => edges.push(edge),
        }
    }
    if edges.len() > 2
        && let Some(both) = together(&edges[edges.len() - 1], &edges[0], size)
    {
        edges[0] = both;
        edges.pop();
    }
    edges
}

/// Two edges as one, if that moves none of their points.
fn together(first: &Edge, second: &Edge, size: f64) -> Option<Edge> {
    let (a, b) = (first.bulge, second.bulge);
    if a * b < 0.0 || (a == 0.0) != (b == 0.0) || a.abs().atan() + b.abs().atan() > LONGEST.atan() + 1e-6 {
        return None;
    }
    let both = Edge { from: first.from, to: second.to, bulge: (a + b) / (1.0 - a * b) };
    let on_it = |point: Point| both.nearest(point).0 <= SAME * size;
    let moves_none = [first.middle(), first.to, second.middle()].into_iter().all(on_it);
    (moves_none && 2.0 * both.half_chord() > TOUCH * size).then_some(both)
}
