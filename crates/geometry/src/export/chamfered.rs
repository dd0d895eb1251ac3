//! The solid of a part with chamfers.
//!
//! Every edge of the outline is cut where a chamfer begins, so that each of its walls ends on one surface below and on one above. On each face
//! the line where a chamfer begins runs through the material from where the outline goes beyond it to the next place where it
//! comes back: what lies on its left is face, what lies on its right is chamfer.

use super::bore::Bore;
use super::slope::Slope;
use super::solid::{Curve, Face, Ring, Solid, Surface, circle, wall_surface};
use super::{ExportError, RESOLUTION};
use lanchester_shape::{Contour, Cut, Edge, Point};

/// A piece of the outline with the chamfer of the front and of the rear face that cuts it.
struct Piece {
    edge: Edge,
    cuts: [Option<usize>; 2],
}

/// A piece of the boundary of a face: an edge of the solid as it runs about the material.
#[derive(Debug, Clone, Copy)]
struct Step {
    side: usize,
    forward: bool,
    from: usize,
    to: usize,
    plan: Edge,
}

/// The steps along a contour, each with the chamfer that cuts it.
type Cuts = Vec<(Step, Option<usize>)>;

/// Edges of a solid, each with whether it runs forward.
type Loop = Vec<(usize, bool)>;

/// A closed line about the material of a face.
struct Boundary {
    /// The chamfer that it bounds, or the face.
    of: Option<usize>,
    steps: Vec<Step>,
}

impl Solid {
    /// A prism as [`Solid::prism`] with chamfers of its front and its rear face.
    ///
    /// # Errors
    /// Where a chamfer touches the outline without crossing it.
    pub(super) fn chamfered(
        (name, colour): (String, [f64; 3]),
        contours: &[Vec<Edge>],
        bores: &[Bore],
        [front, rear]: [f64; 2],
        slopes: [&[Slope]; 2],
    ) -> Result<Solid, ExportError> {
        let touches = |at: Point| ExportError::ChamferTouches { part: name.clone(), at };
        let mut solid = Solid::empty(name.clone(), colour);
        let mut ends: [Vec<Cuts>; 2] = Default::default();
        for (number, contour) in contours.iter().enumerate() {
            let pieces = pieces(contour, number == 0, slopes);
            let rings = [0, 1].map(|end| solid.end_ring(&pieces, end, [front, rear][end], slopes[end]));
            let count = pieces.len();
            let uprights: Vec<usize> =
                (0..count).map(|k| solid.side(rings[0][k].from, rings[1][k].from, Curve::Line)).collect();
            for (k, piece) in pieces.iter().enumerate() {
                let (low, high) = (rings[0][k].side, rings[1][k].side);
                let boundary =
                    vec![(low, true), (uprights[(k + 1) % count], true), (high, false), (uprights[k], false)];
                solid.faces.push(Face {
                    surface: wall_surface(&piece.edge, true),
                    shell: 0,
                    loops: vec![boundary],
                });
            }
            for (end, ring) in rings.into_iter().enumerate() {
                let cut = ring.into_iter().zip(&pieces).map(|(step, piece)| (step, piece.cuts[end]));
                ends[end].push(cut.collect());
            }
        }
        let (mut in_front, mut behind) = (Vec::new(), Vec::new());
        for bore in bores {
            solid.bore(bore, [front, rear], [&mut in_front, &mut behind]);
        }
        for (end, open) in [in_front, behind].iter().enumerate() {
            let mut boundaries = Vec::new();
            for (number, slope) in slopes[end].iter().enumerate() {
                solid.begin(slope, number, contours, &ends[end], &mut boundaries).map_err(touches)?;
            }
            solid.trace(&ends[end], slopes[end], &mut boundaries).map_err(touches)?;
            solid.end_faces(end == 1, slopes[end], boundaries, open).map_err(touches)?;
        }
        Ok(solid)
    }

    /// The edges of one end of the walls.
    fn end_ring(&mut self, pieces: &[Piece], end: usize, face: f64, slopes: &[Slope]) -> Vec<Step> {
        let first = self.vertices.len();
        let count = pieces.len();
        for (k, piece) in pieces.iter().enumerate() {
            let at = piece.edge.from;
            let touching = [piece.cuts[end], pieces[(k + count - 1) % count].cuts[end]];
            // Where a chamfer begins or ends the corner lies on the face.
            let z = match touching {
                [Some(one), Some(other)] if one == other => slopes[one].height(at),
                _ => face,
            };
            self.vertices.push([at.x, at.y, z]);
        }
        let step = |(k, piece): (usize, &Piece)| {
            let (from, to) = (first + k, first + (k + 1) % count);
            let curve = match piece.cuts[end] {
                Some(cut) => Curve::Rise(piece.edge, slopes[cut]),
                None => Curve::level(&piece.edge),
            };
            let side = self.side(from, to, curve);
            Step { side, forward: true, from, to, plan: piece.edge }
        };
        pieces.iter().enumerate().map(step).collect()
    }

    /// The line on the face where a chamfer begins and the outline does not cross it: a circle within the material.
    fn begin(
        &mut self,
        slope: &Slope,
        number: usize,
        contours: &[Vec<Edge>],
        rings: &[Cuts],
        boundaries: &mut Vec<Boundary>,
    ) -> Result<(), Point> {
        let Cut::Turned { radius } = slope.cut else { return Ok(()) };
        let mut is_cut = false;
        for ring in rings {
            let cut = ring.iter().filter(|(_, cut)| *cut == Some(number)).count();
            if cut != 0 && cut != ring.len() {
                return Ok(());
            }
            is_cut |= cut != 0;
        }
        if !is_cut {
            return Ok(());
        }
        let start = Point::new(radius, 0.0);
        let mut inside = true;
        for (at, contour) in contours.iter().enumerate() {
            let closed = Contour::from_edges(contour, RESOLUTION).map_err(|_| start)?;
            inside &= closed.contains(start) == (at == 0);
        }
        if !inside {
            return Ok(());
        }
        let edges = circle(Point::ORIGIN, radius);
        let ring = self.ring(&edges, slope.face);
        let steps: Vec<Step> = (0..edges.len())
            .map(|k| Step {
                side: ring.edges[k],
                forward: true,
                from: ring.vertices[k],
                to: ring.vertices[(k + 1) % edges.len()],
                plan: edges[k],
            })
            .collect();
        boundaries
            .push(Boundary { of: Some(number), steps: steps.iter().rev().map(Step::reversed).collect() });
        boundaries.push(Boundary { of: None, steps });
        Ok(())
    }

    /// Follows the outline and the lines where chamfers begin about each face and chamfer.
    fn trace(
        &mut self,
        rings: &[Cuts],
        slopes: &[Slope],
        boundaries: &mut Vec<Boundary>,
    ) -> Result<(), Point> {
        let all: Vec<(Step, Option<usize>)> = rings.iter().flatten().copied().collect();
        let at =
            |vertex: usize, solid: &Solid| Point::new(solid.vertices[vertex][0], solid.vertices[vertex][1]);
        let mut lines: Vec<(usize, Step)> = Vec::new();
        for (number, slope) in slopes.iter().enumerate() {
            // Where the outline goes beyond the line and where it comes back.
            let mut crossings: Vec<(f64, usize, bool)> = Vec::new();
            for ring in rings {
                for (k, (step, cut)) in ring.iter().enumerate() {
                    let before = ring[(k + ring.len() - 1) % ring.len()].1 == Some(number);
                    let after = *cut == Some(number);
                    if before != after {
                        crossings.push((slope.along(at(step.from, self)), step.from, after));
                    }
                }
            }
            crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (k, (_, from, leaves)) in crossings.iter().enumerate() {
                if !leaves {
                    continue;
                }
                let (_, to, leaves_again) = crossings[(k + 1) % crossings.len()];
                let plan = slope.line(at(*from, self), at(to, self));
                if leaves_again || plan.half_chord() * 2.0 < RESOLUTION {
                    return Err(plan.from);
                }
                let side = self.side(*from, to, Curve::level(&plan));
                lines.push((number, Step { side, forward: true, from: *from, to, plan }));
            }
        }
        let next = |of: Option<usize>, vertex: usize| -> Option<Step> {
            let (step, cut) = all.iter().find(|(step, _)| step.from == vertex)?;
            if *cut == of {
                return Some(*step);
            }
            match of {
                None => lines.iter().find(|(_, line)| line.from == vertex).map(|(_, line)| *line),
                Some(number) => lines
                    .iter()
                    .find(|(of, line)| *of == number && line.to == vertex)
                    .map(|(_, line)| line.reversed()),
            }
        };
        let mut used = vec![false; all.len()];
        for start in 0..all.len() {
            let (first, of) = all[start];
            if used[start] {
                continue;
            }
            let mut steps = vec![first];
            used[start] = true;
            let mut here = first;
            loop {
                let Some(step) = next(of, here.to) else { return Err(here.plan.to) };
                if step.side == first.side {
                    break;
                }
                if steps.len() > 2 * all.len() {
                    return Err(here.plan.to);
                }
                if let Some(number) = all.iter().position(|(other, _)| other.side == step.side) {
                    used[number] = true;
                }
                steps.push(step);
                here = step;
            }
            boundaries.push(Boundary { of, steps });
        }
        Ok(())
    }

    /// The faces of one end: of each boundary that runs anticlockwise, with the others of its kind that lie within, and the bores.
    fn end_faces(
        &mut self,
        up: bool,
        slopes: &[Slope],
        boundaries: Vec<Boundary>,
        open: &[Ring],
    ) -> Result<(), Point> {
        let (outer, inner): (Vec<Boundary>, Vec<Boundary>) =
            boundaries.into_iter().partition(|boundary| area(&boundary.steps) > 0.0);
        let mut faces: Vec<(Boundary, Vec<Loop>)> =
            outer.into_iter().map(|boundary| (boundary, Vec::new())).collect();
        let face_of =
            |of: Option<usize>, at: Point, faces: &[(Boundary, Vec<Loop>)]| -> Result<usize, Point> {
                let alike: Vec<usize> = (0..faces.len()).filter(|k| faces[*k].0.of == of).collect();
                if let [only] = alike[..] {
                    return Ok(only);
                }
                for number in alike {
                    let edges: Vec<Edge> = faces[number].0.steps.iter().map(|step| step.plan).collect();
                    if Contour::from_edges(&edges, RESOLUTION).map_err(|_| at)?.contains(at) {
                        return Ok(number);
                    }
                }
                Err(at)
            };
        for boundary in inner {
            let number = face_of(boundary.of, boundary.steps[0].plan.from, &faces)?;
            faces[number].1.push(boundary.steps.iter().map(|step| (step.side, step.forward)).collect());
        }
        for ring in open {
            let [x, y, _] = self.vertices[ring.vertices[0]];
            let number = face_of(None, Point::new(x, y), &faces)?;
            faces[number].1.push(ring.backward());
        }
        for (boundary, holes) in faces {
            let surface = match boundary.of {
                Some(number) => Surface::Slope(slopes[number]),
                None => Surface::Level { up },
            };
            let outer = boundary.steps.iter().map(|step| (step.side, step.forward)).collect();
            let mut loops: Vec<Loop> = std::iter::once(outer).chain(holes).collect();
            if !up {
                for boundary in &mut loops {
                    boundary.reverse();
                    boundary.iter_mut().for_each(|(_, forward)| *forward = !*forward);
                }
            }
            self.faces.push(Face { surface, shell: 0, loops });
        }
        Ok(())
    }
}

impl Step {
    fn reversed(&self) -> Step {
        Step {
            side: self.side,
            forward: !self.forward,
            from: self.to,
            to: self.from,
            plan: self.plan.reversed(),
        }
    }
}

/// The pieces of a contour, with the material on their left, cut where chamfers begin.
fn pieces(contour: &[Edge], outer: bool, slopes: [&[Slope]; 2]) -> Vec<Piece> {
    let edges: Vec<Edge> =
        if outer { contour.to_vec() } else { contour.iter().rev().map(Edge::reversed).collect() };
    let mut pieces = Vec::new();
    for edge in edges {
        let halves = if edge.bulge.abs() > 1.0 { edge.halves().to_vec() } else { vec![edge] };
        for half in halves {
            let length = half.length();
            let mut cuts: Vec<f64> =
                slopes.iter().copied().flatten().flat_map(|slope| slope.crossings(&half)).collect();
            cuts.sort_by(f64::total_cmp);
            let mut bounds = vec![0.0];
            for cut in cuts {
                let last = bounds[bounds.len() - 1];
                if (cut - last) * length > RESOLUTION && (1.0 - cut) * length > RESOLUTION {
                    bounds.push(cut);
                }
            }
            bounds.push(1.0);
            let turn = half.bulge.atan();
            for ends in bounds.windows(2) {
                let place = |part: f64| match part {
                    0.0 => half.from,
                    1.0 => half.to,
                    _ => half.at(part).0,
                };
                let bulge = (turn * (ends[1] - ends[0])).tan();
                let piece = Edge { from: place(ends[0]), to: place(ends[1]), bulge };
                let piece = if bounds.len() == 2 { half } else { piece };
                let flat = piece.half_chord() * piece.bulge.abs() < RESOLUTION;
                let edge = if flat { Edge { bulge: 0.0, ..piece } } else { piece };
                let cut = |slopes: &[Slope]| {
                    slopes.iter().position(|slope| slope.beyond(edge.middle()) > RESOLUTION)
                };
                pieces.push(Piece { edge, cuts: slopes.map(cut) });
            }
        }
    }
    pieces
}

/// Area within a closed line, negative where it runs clockwise.
fn area(steps: &[Step]) -> f64 {
    let of = |edge: &Edge| {
        let triangle = edge.from.cross(edge.to) / 2.0;
        let angle = 4.0 * edge.bulge.atan();
        let segment =
            if edge.bulge == 0.0 { 0.0 } else { edge.radius().powi(2) * (angle - angle.sin()) / 2.0 };
        triangle + segment
    };
    steps.iter().map(|step| of(&step.plan)).sum()
}
