//! Where the points of the nets stand along the crank.
//!
//! A line of the net can stand for circles of several bars that are as good as one ([`super::circles`]). At the faces of each bar its points
//! stand on the circles of that bar exactly, along the bar too, and between bars they pass from one place to the other linearly in z:
//!
//! ```text
//! x(z) = x + (1 - t) u_k + t u_(k+1)        t = (z - z_k)/(z_(k+1) - z_k)        u_k: at face k
//! ```
//! Points beside them follow: the displacement is the mean of that of their neighbours, and none at outlines.

use super::circles::{Arrangement, arc_middle};
use super::rim::Rim;
use super::rings::{Rank, layer_radii};
use super::segment::{Bar, TINY, refuse};
use crate::FlexError;
use lanchester_shape::Point;
use std::collections::{BTreeMap, BTreeSet};

/// Sweeps of the relaxation of displacements.
const SWEEPS: usize = 60;

/// A face of a bar.
struct Face {
    z: f64,
    /// Circles of the net that are at this face, with their radii there [m].
    circles: BTreeMap<usize, f64>,
    /// Displacement of each point [m]; empty where none moves.
    moved: Vec<Point>,
    /// Edges along the circles of steps of nose and flange, with the middles of these.
    rims: BTreeMap<[usize; 2], Point>,
}

/// Places of points and edges along z.
pub(super) struct Places<'a> {
    core: &'a Arrangement,
    /// In their order along z.
    faces: Vec<Face>,
}

impl<'a> Places<'a> {
    /// `nets`: what is beside the front and the rear face of each bar; `rims`: of the bars that are thin steps of an end.
    ///
    /// # Errors
    /// A bore that has no room beside a journal or pin.
    pub fn new(
        bars: &[Bar],
        layers: usize,
        core: &'a Arrangement,
        points: &[Point],
        nets: &[Option<Beside<'_>>],
        rims: &[Option<Rim>],
    ) -> Result<Places<'a>, FlexError> {
        let mut faces = Vec::with_capacity(2 * bars.len());
        for (index, bar) in bars.iter().enumerate() {
            for end in 0..2 {
                // A bar that touches it there, at an end of the crankshaft: both share the points of this plane.
                let z = bar.faces[end];
                let next = if end == 0 { index.checked_sub(1) } else { Some(index + 1) };
                let next = next.filter(|next| {
                    bars.get(*next).is_some_and(|next| (next.faces[1 - end] - z).abs() < TINY)
                });
                let mut circles = BTreeMap::new();
                let mut add = |centre: Point, radius: f64| {
                    if let Some(circle) = core.find(centre, radius) {
                        circles.insert(circle, radius);
                    }
                };
                for bar in [Some(index), next].into_iter().flatten().map(|bar| &bars[bar]) {
                    add(bar.centre, bar.radius);
                }
                layer_radii(bar.radius, bar.fillets[end], layers).for_each(|radius| add(bar.centre, radius));
                let beside = nets[2 * index + end];
                let through = beside.iter().flat_map(|beside| beside.bores).map(|bar| &bars[*bar]);
                for own in std::iter::once(bar).filter(|bar| bar.bore > 0.0).chain(through) {
                    add(own.centre, own.bore);
                }
                let here: Vec<&Rim> =
                    [Some(index), next].into_iter().filter_map(|bar| rims[bar?].as_ref()).collect();
                let moved = displacements(&bar.name, core, points, &circles, beside, &here)?;
                let rims =
                    here.iter().flat_map(|rim| rim.edges.iter().map(|edge| (*edge, rim.centre))).collect();
                faces.push(Face { z, circles, moved, rims });
            }
        }
        Ok(Places { core, faces })
    }

    /// A point (both numbers the same) or the middle of an edge at a height. `plain`: its place in the net; `points`: those of all points.
    pub fn at(&self, key: [usize; 2], plain: Point, points: &[Point], z: f64) -> Point {
        let after = self.faces.partition_point(|face| face.z < z - TINY).min(self.faces.len() - 1);
        let (low, high) = (&self.faces[after.saturating_sub(1)], &self.faces[after]);
        let length = high.z - low.z;
        let share = if length < TINY { 1.0 } else { ((z - low.z) / length).clamp(0.0, 1.0) };
        if share == 1.0 {
            return self.on(high, key, plain, points);
        }
        let (one, two) = (self.on(low, key, plain, points), self.on(high, key, plain, points));
        if one == two { one } else { one * (1.0 - share) + two * share }
    }

    fn on(&self, face: &Face, key: [usize; 2], plain: Point, points: &[Point]) -> Point {
        let moved = key.map(|point| face.moved.get(point).copied().unwrap_or(Point::ORIGIN));
        if let Some(centre) = face.rims.get(&key) {
            let [a, b] = [0, 1].map(|end| points[key[end]] + moved[end]);
            return arc_middle(*centre, a, b);
        }
        let along = self.core.along.get(&key).map_or(&[][..], |along| along);
        match along.iter().find(|circle| face.circles.contains_key(circle)) {
            Some(circle) => {
                let [a, b] = [0, 1].map(|end| points[key[end]] + moved[end]);
                arc_middle(self.core.circles[*circle].centre, a, b)
            }
            None => plain + (moved[0] + moved[1]) * 0.5,
        }
    }
}

/// Triangles beside a face.
#[derive(Clone, Copy)]
pub(super) struct Beside<'a> {
    pub triangles: &'a [([usize; 3], Point)],
    /// Points of outlines.
    pub fixed: &'a BTreeSet<usize>,
    /// Bars whose bores go through its webs.
    pub bores: &'a BTreeSet<usize>,
}

/// Displacement of all points at a face.
fn displacements(
    name: &str,
    core: &Arrangement,
    points: &[Point],
    circles: &BTreeMap<usize, f64>,
    beside: Option<Beside<'_>>,
    rims: &[&Rim],
) -> Result<Vec<Point>, FlexError> {
    let mut given: BTreeMap<usize, Point> = BTreeMap::new();
    for (point, through) in core.through.iter().enumerate() {
        let at = points[point];
        let mut to = at;
        let mut is_on = false;
        for (circle, radius) in circles.iter().filter(|(circle, _)| through.contains(circle)) {
            let own = &core.circles[*circle];
            let from = to - own.centre;
            let on = own.centre + from * (radius / from.norm());
            if is_on && (on - to).norm() > TINY {
                if own.rank == Rank::Layer {
                    continue;
                }
                let message = format!(
                    "a bore comes within {:.2} mm of a journal or pin or its fillet at ({:.2}, {:.2}) mm, seen along the crank",
                    1e3 * (on - to).norm(),
                    1e3 * at.x,
                    1e3 * at.y
                );
                return Err(refuse(name, message, "a smaller bore, or a smaller fillet"));
            }
            (to, is_on) = (on, true);
        }
        if is_on {
            given.insert(point, to - at);
        }
    }
    for rim in rims {
        for (point, to) in rim.places(points) {
            let by = to - points[point];
            if given.insert(point, by).is_some_and(|own| (own - by).norm() > TINY) {
                let at = points[point];
                let message = format!(
                    "its circle comes too near to another one at ({:.2}, {:.2}) mm, seen along the crank",
                    1e3 * at.x,
                    1e3 * at.y
                );
                return Err(refuse(name, message, "another diameter"));
            }
        }
    }
    if given.values().all(|moved| moved.norm() < 1e-12) {
        return Ok(Vec::new());
    }
    let mut moved = vec![Point::ORIGIN; points.len()];
    for (point, by) in &given {
        moved[*point] = *by;
    }
    let around = beside.map_or(&[][..], |beside| beside.triangles).iter().map(|(triangle, _)| triangle);
    let mut neighbours: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for triangle in around.chain(rims.iter().flat_map(|rim| &rim.disc)) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            neighbours.entry(a).or_default().insert(b);
            neighbours.entry(b).or_default().insert(a);
        }
    }
    let is_fixed = |point: &usize| beside.is_some_and(|beside| beside.fixed.contains(point));
    neighbours.retain(|point, _| !given.contains_key(point) && !is_fixed(point));
    for _ in 0..SWEEPS {
        for (point, around) in &neighbours {
            let sum = around.iter().fold(Point::ORIGIN, |sum, other| sum + moved[*other]);
            moved[*point] = sum * (1.0 / around.len() as f64);
        }
    }
    Ok(moved)
}
