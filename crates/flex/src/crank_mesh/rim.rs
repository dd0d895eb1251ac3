//! Steps of nose or flange that are thinner than the journal beside them.
//!
//! Their cross-section is made of the journal's triangles whose middles lie within the step; their rim is pulled onto the step's circle
//! ([`super::places`]), and the triangles around it follow. So the net of pins and webs has no line for them.

use super::net::Net;
use super::segment::Bar;
use lanchester_shape::Point;
use std::collections::{BTreeMap, BTreeSet};

/// Rounds in which the rim is straightened.
const ROUNDS: usize = 40;
/// Least edges of a rim.
const LEAST: usize = 6;
/// Shares of the radius within which triangles are taken.
const TRIED: [f64; 13] = [1.0, 0.97, 1.03, 0.94, 1.06, 0.91, 1.09, 0.88, 1.12, 0.85, 1.15, 0.82, 1.18];

/// The cross-section of a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rim {
    pub centre: Point,
    pub radius: f64,
    /// Triangles within it.
    pub triangles: Vec<[usize; 3]>,
    /// Triangles of the journal's disc, which it is a part of.
    pub disc: Vec<[usize; 3]>,
    /// Edges along it.
    pub edges: BTreeSet<[usize; 2]>,
}

fn edges_of(triangle: &[usize; 3]) -> [[usize; 2]; 3] {
    [[0, 1], [1, 2], [2, 0]].map(|[a, b]: [usize; 2]| {
        let (a, b) = (triangle[a], triangle[b]);
        [a.min(b), a.max(b)]
    })
}

impl Rim {
    /// The rim of a step among the triangles of a journal's disc: of the lines of edges that run near its circle the one whose triangles keep the best shape on it;
    /// `None` where no closed line does, away from the disc's own edge.
    /// `taken`: points of the rims of other steps.
    pub fn of(bar: &Bar, net: &Net, disc: &[[usize; 3]], taken: &BTreeSet<usize>) -> Option<Rim> {
        let is_free = |rim: &Rim| rim.edges.iter().flatten().all(|point| !taken.contains(point));
        let near = TRIED.iter().filter_map(|share| Rim::near(bar, net, disc, share * bar.radius));
        let tried = near.filter(is_free);
        let rated = tried.map(|rim| (rim.shape(net), rim));
        rated.max_by(|(one, _), (two, _)| one.total_cmp(two)).map(|(_, rim)| rim)
    }

    /// The line around the triangles whose middles lie within a radius.
    fn near(bar: &Bar, net: &Net, disc: &[[usize; 3]], radius: f64) -> Option<Rim> {
        let middle = |triangle: &[usize; 3]| {
            triangle.iter().fold(Point::ORIGIN, |sum, point| sum + net.points[*point]) * (1.0 / 3.0)
        };
        let mut within: Vec<bool> =
            disc.iter().map(|triangle| (middle(triangle) - bar.centre).norm() < radius).collect();
        let mut beside: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (index, triangle) in disc.iter().enumerate() {
            for edge in edges_of(triangle) {
                beside.entry(edge).or_default().push(index);
            }
        }
        let is_rim = |within: &[bool], edge: &[usize; 2]| match beside[edge][..] {
            [a, b] => within[a] != within[b],
            _ => false,
        };
        // Two edges of one triangle along the circle would be flat where they meet.
        let mut is_settled = false;
        for _ in 0..ROUNDS {
            let bent = (0..disc.len()).find(|index| {
                edges_of(&disc[*index]).iter().filter(|edge| is_rim(&within, edge)).count() > 1
            });
            match bent {
                Some(index) => within[index] = !within[index],
                None => {
                    is_settled = true;
                    break;
                }
            }
        }
        let outer: BTreeSet<usize> =
            beside.iter().filter(|(_, own)| own.len() == 1).flat_map(|(edge, _)| *edge).collect();
        let edges: BTreeSet<[usize; 2]> =
            beside.keys().filter(|edge| is_rim(&within, edge)).copied().collect();
        let mut ends: BTreeMap<usize, usize> = BTreeMap::new();
        for point in edges.iter().flatten() {
            *ends.entry(*point).or_default() += 1;
        }
        let is_closed = ends.iter().all(|(point, count)| *count == 2 && !outer.contains(point));
        if !is_settled || edges.len() < LEAST || !is_closed {
            return None;
        }
        let triangles =
            disc.iter().zip(&within).filter(|(_, own)| **own).map(|(triangle, _)| *triangle).collect();
        Some(Rim { centre: bar.centre, radius: bar.radius, triangles, disc: disc.to_vec(), edges })
    }

    /// Least sine of an angle between two edges of its triangles, with the rim on its circle and its edges as arcs of it; below 0 where one is folded.
    fn shape(&self, net: &Net) -> f64 {
        let places = self.places(&net.points);
        let at = |point: usize| places.get(&point).copied().unwrap_or(net.points[point]);
        // Direction in which an edge leaves a point.
        let leaves = |from: usize, to: usize| {
            let chord = at(to) - at(from);
            if !self.edges.contains(&[from.min(to), from.max(to)]) {
                return chord * (1.0 / chord.norm());
            }
            let out = at(from) - self.centre;
            let along = Point::new(-out.y, out.x);
            along * (along.dot(chord).signum() / along.norm())
        };
        let sine = |triangle: &[usize; 3], k: usize| {
            let [a, b, c] = [0, 1, 2].map(|step| triangle[(k + step) % 3]);
            leaves(a, b).cross(leaves(a, c))
        };
        let mut least = f64::INFINITY;
        for triangle in self.disc.iter().filter(|own| own.iter().any(|point| places.contains_key(point))) {
            let [a, b, c] = triangle.map(at);
            let side = (b - a).cross(c - a).signum();
            let plain = triangle.map(|point| net.points[point]);
            let before = (plain[1] - plain[0]).cross(plain[2] - plain[0]).signum();
            for k in 0..3 {
                least = least.min(before * side * sine(triangle, k).abs());
            }
        }
        least
    }

    /// Its points, each with its place on the circle.
    pub fn places(&self, points: &[Point]) -> BTreeMap<usize, Point> {
        let on = |point: &usize| {
            let from = points[*point] - self.centre;
            (*point, self.centre + from * (self.radius / from.norm()))
        };
        self.edges.iter().flatten().map(on).collect()
    }
}
