//! Lines of a drawing, joined end to end into closed chains.

use super::{DrawingError, FARTHEST, Place};
use lanchester_shape::Edge;
use lanchester_shape::Point;

/// Bulges below this are none.
const STRAIGHT: f64 = 1e-20;

/// Edges that follow each other, from one entity of the file.
#[derive(Debug, Clone)]
pub(super) struct Strand {
    /// The edges [m], y up.
    pub edges: Vec<Edge>,
    /// Whether the last is joined to the first.
    pub closed: bool,
    /// Where they come from.
    pub place: Place,
}

impl Strand {
    /// A closed or open strand; edges without length are left out, bulges below [`STRAIGHT`] are none.
    ///
    /// # Errors
    /// Where it reaches too far.
    pub fn new(edges: Vec<Edge>, closed: bool, place: Place) -> Result<Strand, DrawingError> {
        let reach = |edge: &Edge| {
            edge.from.norm().max(edge.to.norm()) + 2.0 * edge.half_chord() * edge.bulge.abs().max(1.0)
        };
        // Not a number is too far as well.
        if edges.iter().any(|edge| reach(edge).is_nan() || reach(edge) > FARTHEST) {
            return Err(DrawingError::TooFar { entity: place });
        }
        let long = edges.into_iter().filter(|edge| edge.from != edge.to);
        // No arc of at most FARTHEST stands out by an atom then, and its centre is a number.
        let straight =
            |edge: Edge| if edge.bulge.abs() < STRAIGHT { Edge { bulge: 0.0, ..edge } } else { edge };
        let edges = long.map(straight).collect();
        Ok(Strand { edges, closed, place })
    }

    /// Two half circles.
    pub fn circle(centre: Point, radius: f64) -> Vec<Edge> {
        let [left, right] = [-radius, radius].map(|x| centre + Point::new(x, 0.0));
        vec![Edge { from: left, to: right, bulge: 1.0 }, Edge { from: right, to: left, bulge: 1.0 }]
    }

    /// The corners joined by edges with these bulges, the last to the first where it is closed.
    pub fn of_corners(corners: &[(Point, f64)], closed: bool) -> Vec<Edge> {
        let mut edges: Vec<Edge> = corners
            .windows(2)
            .map(|pair| Edge { from: pair[0].0, to: pair[1].0, bulge: pair[0].1 })
            .collect();
        if let ([(first, _), ..], [.., (last, bulge)], true) = (corners, corners, closed) {
            edges.push(Edge { from: *last, to: *first, bulge: *bulge });
        }
        edges
    }
}

/// A closed chain: each edge with the entity that it comes from.
pub(super) type Chain = Vec<(Edge, Place)>;

/// One end of an open strand.
#[derive(Clone, Copy)]
struct End {
    strand: usize,
    at: Point,
}

/// Closed strands as they are, open ones joined where exactly two ends lie within `gap` [m].
///
/// # Errors
/// Where an end has no partner or more than one.
pub(super) fn chains(strands: Vec<Strand>, gap: f64) -> Result<Vec<Chain>, DrawingError> {
    let mut strands: Vec<Strand> = strands.into_iter().filter(|strand| !strand.edges.is_empty()).collect();
    // A last corner that repeats the first, but for rounding.
    for Strand { edges, .. } in strands.iter_mut().filter(|strand| strand.closed && strand.edges.len() > 1) {
        edges.pop_if(|last| last.bulge == 0.0 && 2.0 * last.half_chord() <= gap);
    }
    let partner = partners(&strands, gap)?;
    let mut used = vec![false; strands.len()];
    let mut chains = Vec::new();
    for start in 0..strands.len() {
        if used[start] {
            continue;
        }
        let mut chain = Chain::new();
        // Ends are numbered 2k for the beginning and 2k + 1 for the end of strand k; the chain enters at `enter`.
        let mut enter = 2 * start;
        while !used[enter / 2] {
            let strand = &strands[enter / 2];
            used[enter / 2] = true;
            let forward = enter % 2 == 0;
            let edges: Vec<Edge> = if forward {
                strand.edges.clone()
            } else {
                strand.edges.iter().rev().map(Edge::reversed).collect()
            };
            chain.extend(edges.into_iter().map(|edge| (edge, strand.place.clone())));
            if strand.closed {
                break;
            }
            enter = partner[enter ^ 1];
        }
        chains.push(chain);
    }
    Ok(chains)
}

/// For each end of each strand the end that it is joined to; closed strands are not asked.
fn partners(strands: &[Strand], gap: f64) -> Result<Vec<usize>, DrawingError> {
    let ends: Vec<End> = strands
        .iter()
        .enumerate()
        .flat_map(|(strand, Strand { edges, .. })| {
            [edges[0].from, edges[edges.len() - 1].to].map(|at| End { strand, at })
        })
        .collect();
    let mut order: Vec<usize> = (0..ends.len()).filter(|k| !strands[ends[*k].strand].closed).collect();
    order.sort_by(|a, b| ends[*a].at.x.total_cmp(&ends[*b].at.x));
    let mut partner = vec![usize::MAX; ends.len()];
    for (place, &first) in order.iter().enumerate() {
        for &second in &order[place + 1..] {
            if ends[second].at.x - ends[first].at.x > gap {
                break;
            }
            if (ends[second].at - ends[first].at).norm() > gap {
                continue;
            }
            for (one, other) in [(first, second), (second, first)] {
                if partner[one] != usize::MAX {
                    let entities =
                        [partner[one], one, other].map(|end| strands[ends[end].strand].place.clone());
                    return Err(DrawingError::Branch { entities: entities.to_vec(), at: ends[one].at });
                }
                partner[one] = other;
            }
        }
    }
    // The first of the file, not the leftmost.
    if let Some(open) =
        (0..ends.len()).find(|k| !strands[ends[*k].strand].closed && partner[*k] == usize::MAX)
    {
        let others = order.iter().filter(|k| **k != open);
        let nearest = others.map(|k| (ends[*k].at - ends[open].at).norm()).min_by(f64::total_cmp);
        let entity = strands[ends[open].strand].place.clone();
        return Err(DrawingError::Open { entity, at: ends[open].at, nearest });
    }
    Ok(partner)
}
