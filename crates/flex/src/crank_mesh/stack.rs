//! The plane net of a stack of webs: discs of its two bars from the core, around them what its outlines add.

use super::chords::{Chords, Polygon, outline_chords};
use super::circles::Arrangement;
use super::extrude::Sweep;
use super::lines::split;
use super::net::{Net, net};
use super::options::CrankMeshOptions;
use super::segment::{Bar, Stack, TINY, refuse};
use super::slugs::Slug;
use crate::FlexError;
use lanchester_geometry::crankshaft::CrankshaftBody;
use lanchester_shape::{Contour, Edge, Outline, Point};
use std::collections::{BTreeMap, BTreeSet};

/// Room that an outline leaves around the fillet of a bar [m].
const ROOM: f64 = 0.2e-3;

/// A prism of the body.
pub(super) struct Solid {
    pub name: String,
    pub outline: Outline,
    pub faces: [f64; 2],
}

/// What the nets of a crankshaft have in common.
pub(super) struct Core<'a> {
    pub bars: &'a [Bar],
    pub net: &'a Net,
    pub circles: &'a Arrangement,
    pub slugs: &'a [Slug],
    pub options: CrankMeshOptions,
}

/// Triangles of a stack, and the prisms that fill them.
pub(super) struct StackNet {
    /// Discs of the bars first.
    pub triangles: Vec<([usize; 3], Point)>,
    /// Points of outlines, inserts and holes.
    pub outlines: BTreeSet<usize>,
    /// Bars whose bores go through.
    pub bores: BTreeSet<usize>,
    /// How many belong to the discs.
    discs: usize,
    solids: Vec<(Polygon, [f64; 2])>,
    /// Of inserts and holes: outline, faces, material or none of a hole.
    slugs: Vec<(Polygon, [f64; 2], Option<u32>)>,
}

impl StackNet {
    /// Planes where something begins or ends.
    pub fn planes(&self) -> impl Iterator<Item = f64> {
        self.solids
            .iter()
            .flat_map(|(_, faces)| *faces)
            .chain(self.slugs.iter().flat_map(|(_, faces, _)| *faces))
    }

    /// Triangles that are filled at a height, with their material; beside a bar only those beyond its disc.
    pub fn filled(&self, z: f64, beside_bar: bool) -> Vec<([usize; 3], u32)> {
        let is_there = |faces: &[f64; 2]| faces[0] < z && z < faces[1];
        let there: Vec<&Polygon> =
            self.solids.iter().filter(|(_, faces)| is_there(faces)).map(|(polygon, _)| polygon).collect();
        let slugs: Vec<_> = self.slugs.iter().filter(|(_, faces, _)| is_there(faces)).collect();
        let skipped = if beside_bar { self.discs } else { 0 };
        let material = |at: Point| match slugs.iter().find(|(polygon, ..)| polygon.contains(at)) {
            Some((_, _, material)) => *material,
            None => Some(0),
        };
        self.triangles[skipped..]
            .iter()
            .filter(|(_, at)| there.iter().any(|polygon| polygon.contains(*at)))
            .filter_map(|(triangle, at)| Some((*triangle, material(*at)?)))
            .collect()
    }
}

/// The prisms of a stack, those that reach over its bars along the crank included.
pub(super) fn solids(body: &CrankshaftBody, stack: &Stack, bars: &[Bar]) -> Vec<Solid> {
    let all = body.outlines().map(|(name, outline, faces)| Solid { name: name.to_owned(), outline, faces });
    let all: Vec<Solid> = all.collect();
    let meet = |faces: &[f64; 2], other: &[f64; 2]| faces[0].max(other[0]) + TINY < faces[1].min(other[1]);
    let mut own: Vec<usize> = (0..all.len()).filter(|k| meet(&all[*k].faces, &stack.faces)).collect();
    // What reaches on over a bar, plane by plane.
    for (end, bar) in stack.bars.iter().enumerate().filter_map(|(end, bar)| Some((end, &bars[(*bar)?]))) {
        let mut plane = stack.faces[end];
        loop {
            let next = (0..all.len()).find(|k| {
                let solid = &all[*k];
                let begins = solid.faces[1 - end];
                (begins - plane).abs() < TINY
                    && meet(&solid.faces, &bar.faces)
                    && reaches_over(&solid.outline, bar)
            });
            let Some(next) = next else { break };
            let others = (0..all.len()).filter(|k| {
                meet(&all[*k].faces, &all[next].faces)
                    && meet(&all[*k].faces, &bar.faces)
                    && reaches_over(&all[*k].outline, bar)
            });
            own.extend(others);
            plane = all[next].faces[end];
        }
    }
    own.sort_unstable();
    own.dedup();
    let mut all: Vec<Option<Solid>> = all.into_iter().map(Some).collect();
    own.into_iter().filter_map(|k| all[k].take()).collect()
}

/// Whether an outline has more than the disc of a bar.
pub(super) fn reaches_over(outline: &Outline, bar: &Bar) -> bool {
    outline.outer().farthest(bar.centre).0 > bar.radius + TINY
}

/// Makes the net of a stack; its points go into the sweep.
pub(super) fn stack_net(
    sweep: &mut Sweep,
    stack: &Stack,
    solids: &[Solid],
    core: &Core,
) -> Result<StackNet, FlexError> {
    let Core { bars, options, .. } = *core;
    // What the core gives: the discs of both bars out to their outermost ring.
    let discs: Vec<(Point, f64)> = stack
        .bars
        .iter()
        .flatten()
        .map(|bar| {
            // Bars of one axis and radius share their circles.
            let own = &bars[*bar];
            let same = |other: &&Bar| {
                (other.centre - own.centre).norm() < TINY && (other.radius - own.radius).abs() < TINY
            };
            let fillets = bars.iter().filter(same).flat_map(|bar| bar.fillets);
            (own.centre, own.radius + fillets.fold(0.0, f64::max))
        })
        .collect();
    for solid in solids {
        check_room(stack, solid, &discs)?;
    }
    let polygons: Vec<Polygon> =
        discs.iter().map(|(centre, radius)| core.circles.circle(*centre, *radius)).collect();
    let is_core = |at: Point| polygons.iter().any(|polygon| polygon.contains(at));
    let mut all = sweep.pick(core.net, is_core);
    let discs = all.len();
    // Edges of one triangle are the boundary of the discs.
    let mut edges: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for triangle in &all {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    let mut outer = Chords::default();
    let mut names: Vec<usize> = Vec::new();
    for (edge, _) in edges.into_iter().filter(|(_, count)| *count == 1) {
        let ends = edge.map(|point| {
            names.iter().position(|name| *name == point).unwrap_or_else(|| {
                names.push(point);
                outer.points.push(core.net.points[point]);
                names.len() - 1
            })
        });
        let middle = sweep.middles.get(&edge).copied();
        outer.chords.push((ends, middle.unwrap_or((outer.points[ends[0]] + outer.points[ends[1]]) * 0.5)));
    }
    // Edges of all outlines, cut where those of others begin, so that what runs along each other has the same chords.
    let bore = |hole: &Contour| {
        stack.bars.into_iter().flatten().find(|bar| {
            let bar = &bars[*bar];
            bar.bore > 0.0 && hole.contains(bar.centre) && is_circle(hole, bar.centre, bar.bore)
        })
    };
    let holes = solids.iter().flat_map(|solid| solid.outline.holes());
    let bores = holes.filter_map(bore).collect();
    let slugs: Vec<&Slug> = core
        .slugs
        .iter()
        .filter(|slug| solids.iter().any(|solid| slug.is_in(&solid.name, solid.faces)))
        .collect();
    let edges_of = |solid: &Solid| -> Vec<Edge> {
        let contours = solid.outline.contours().enumerate();
        let plain = contours.filter(|(k, contour)| *k == 0 || bore(contour).is_none());
        plain.flat_map(|(_, contour)| contour.edges().to_vec()).collect()
    };
    let circle = |slug: &&Slug| slug.edges();
    let lines: Vec<Vec<Edge>> = solids.iter().map(edges_of).chain(slugs.iter().map(circle)).collect();
    let lines = split(&lines);
    for (k, edges) in lines.iter().enumerate() {
        let size =
            if k < solids.len() { options.size } else { options.size.min(slugs[k - solids.len()].radius) };
        let own = outline_chords(edges, size);
        // Holes of bores are circles of the core already.
        for ([a, b], middle) in own.chords.iter().filter(|(_, middle)| !is_core(*middle)) {
            let ends = [*a, *b].map(|point| {
                let at = own.points[point];
                let found = outer.points.iter().position(|point| (*point - at).norm() < TINY);
                found.unwrap_or_else(|| {
                    outer.points.push(at);
                    outer.points.len() - 1
                })
            });
            let is_there = |(other, _): &([usize; 2], Point)| *other == ends || *other == [ends[1], ends[0]];
            if ends[0] != ends[1] && !outer.chords.iter().any(is_there) {
                outer.chords.push((ends, *middle));
            }
        }
    }
    let polygon = |k: usize| {
        let size =
            if k < solids.len() { options.size } else { options.size.min(slugs[k - solids.len()].radius) };
        outline_chords(&lines[k], size).polygon()
    };
    let filled = (0..solids.len()).map(|k| {
        let mut polygon = polygon(k);
        for hole in solids[k].outline.holes() {
            if let Some(bar) = bore(hole).map(|bar| &bars[bar]) {
                polygon.0.extend(core.circles.circle(bar.centre, bar.bore).0);
            }
        }
        (polygon, solids[k].faces)
    });
    let filled: Vec<(Polygon, [f64; 2])> = filled.collect();
    let slugs: Vec<(Polygon, [f64; 2], Option<u32>)> = slugs
        .iter()
        .enumerate()
        .map(|(k, slug)| (polygon(solids.len() + k), slug.faces, slug.material))
        .collect();
    let is_smooth = |at: usize, to: [usize; 2]| {
        let [at, a, b] = [at, to[0], to[1]].map(|point| names.get(point).copied());
        at.zip(a).zip(b).is_some_and(|((at, a), b)| core.circles.is_smooth(at, [a, b]))
    };
    let outside = net(&outer, options.size, is_smooth).map_err(|at| {
        let message = format!("outlines of its slabs cross at ({:.2}, {:.2}) mm", 1e3 * at.x, 1e3 * at.y);
        refuse(
            &stack.name,
            message,
            "let the counterweight share the edges of its web, or end inside or outside of them",
        )
    })?;
    // Points of the outer net in the numbers of the sweep.
    let first = sweep.points.len();
    let number = |point: usize| if point < names.len() { names[point] } else { first + point - names.len() };
    sweep.points.extend_from_slice(&outside.points[names.len()..]);
    for ([a, b], middle) in &outer.chords {
        let (a, b) = (number(*a), number(*b));
        sweep.middles.insert([a.min(b), a.max(b)], *middle);
    }
    let outlines = (names.len()..outer.points.len()).map(number).collect();
    all.extend(
        outside
            .triangles
            .iter()
            .map(|triangle| triangle.map(number))
            .filter(|triangle| !is_core(sweep.centre(triangle))),
    );
    let triangles = all.into_iter().map(|triangle| (triangle, sweep.centre(&triangle))).collect();
    Ok(StackNet { triangles, outlines, bores, discs, solids: filled, slugs })
}

fn is_circle(contour: &Contour, centre: Point, radius: f64) -> bool {
    (contour.nearest(centre).0 - radius).abs() < TINY && (contour.farthest(centre).0 - radius).abs() < TINY
}

/// An outline encloses a disc with its fillet, or stays clear of it.
fn check_room(stack: &Stack, solid: &Solid, discs: &[(Point, f64)]) -> Result<(), FlexError> {
    let is_web = solid.faces[0].max(stack.faces[0]) + TINY < solid.faces[1].min(stack.faces[1]);
    for (centre, radius) in discs {
        let (room, encloses) =
            (solid.outline.outer().nearest(*centre).0, solid.outline.outer().contains(*centre));
        if room >= radius + ROOM && (is_web && encloses || !solid.outline.contains(*centre)) {
            continue;
        }
        let (room, needed) = (1e3 * room, 1e3 * (radius + ROOM));
        if is_web {
            let message = format!(
                "the outline of {} comes to {room:.2} mm from the middle of a journal or pin, whose fillet with some room reaches {needed:.2} mm",
                solid.name
            );
            return Err(refuse(&stack.name, message, "a smaller fillet or a larger web"));
        }
        let message = format!(
            "{} goes on beyond the web's face along the crank, and its outline comes to {room:.2} mm from the middle of a journal or pin there, which needs {needed:.2} mm for \
             its fillet with some room",
            solid.name
        );
        return Err(refuse(
            &stack.name,
            message,
            "make the counterweight no thicker than its web, or keep it clear of the fillet",
        ));
    }
    Ok(())
}
