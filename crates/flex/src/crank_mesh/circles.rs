//! All circles of the core as one net of chords.
//!
//! Circles cut each other where they cross. Lines that come nearer than a share of a layer have no room for elements between them: they
//! are one line of the net there, whose points know all of their circles. Where one of these is a surface of the body, the points stand on
//! it ([`super::places`]).

use super::chords::{Chords, Polygon};
use super::rings::{Rank, Rings};
use lanchester_shape::Point;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};

/// Points closer than this are one [m].
const SAME: f64 = 1e-7;
/// Length of chords by other circles, in layers.
const CHORD: f64 = 1.4;
/// A point is on a chord that passes at less than this share of what is near.
const PASSES: f64 = 0.6;
/// Points are one at less than this share of what is near, once they have settled.
const ONE: f64 = 0.5;
/// Rounds in which chords that cross or pass points are mended.
const ROUNDS: usize = 40;
/// Steps of a turn in which other circles are sought.
const STEPS: usize = 1440;

/// A circle of the net.
#[derive(Debug, Clone)]
pub(super) struct Circle {
    pub centre: Point,
    /// Radius in the net [m].
    pub radius: f64,
    pub rank: Rank,
    /// Radii of the bars that it stands for [m].
    pub radii: Vec<f64>,
    /// Index of its rings.
    family: usize,
    /// Lines nearer than this are one [m].
    near: f64,
}

impl Circle {
    /// Signed distance of a point from it, positive outside [m].
    fn off(&self, at: Point) -> f64 {
        (at - self.centre).norm() - self.radius
    }

    fn angle(&self, at: Point) -> f64 {
        (at.y - self.centre.y).atan2(at.x - self.centre.x).rem_euclid(TAU)
    }
}

/// Circles as chords between points that they share.
#[derive(Debug, Clone, Default)]
pub(super) struct Arrangement {
    pub chords: Chords,
    pub circles: Vec<Circle>,
    /// Circles through each point.
    pub through: Vec<BTreeSet<usize>>,
    /// Circles along each chord, by its ends.
    pub along: BTreeMap<[usize; 2], Vec<usize>>,
}

/// Middle of the arc about a centre between two points; their mean distance from it where they differ.
pub(super) fn arc_middle(centre: Point, a: Point, b: Point) -> Point {
    let (u, v) = (a - centre, b - centre);
    let half = u.cross(v).atan2(u.dot(v)) / 2.0;
    centre + Point::polar((u.norm() + v.norm()) / 2.0, u.y.atan2(u.x) + half)
}

/// Cuts all circles where they cross, and the rest into chords. Rings about one centre have their points at the same angles but near
/// other circles.
///
/// # Errors
/// A place where chords cross that cannot be mended.
pub(super) fn arrangement(families: &[Rings]) -> Result<Arrangement, Point> {
    let mut own = Arrangement::default();
    for (family, rings) in families.iter().enumerate() {
        own.circles.extend(rings.rings.iter().map(|ring| Circle {
            centre: rings.centre,
            radius: ring.radius,
            rank: ring.rank,
            radii: ring.radii.clone(),
            family,
            near: rings.near(),
        }));
    }
    own.circles.sort_by_key(|circle| circle.rank);
    own.cross();
    let angles: Vec<Angles> = (0..families.len()).map(|family| Angles::of(families, family)).collect();
    for circle in 0..own.circles.len() {
        own.fill(circle, &angles[own.circles[circle].family]);
    }
    own.thin();
    own.mend()?;
    own.finish();
    Ok(own)
}

impl Arrangement {
    /// The chords of the circle that stands for this radius; none where it is not there.
    pub fn circle(&self, centre: Point, radius: f64) -> Polygon {
        let Some(circle) = self.find(centre, radius) else { return Polygon::default() };
        let ring = self.ring(circle);
        let at = |k: usize| self.chords.points[ring[k % ring.len()]];
        Polygon((0..ring.len()).map(|k| [at(k), at(k + 1)]).collect())
    }

    /// Whether the chords from a point to two others are of one circle.
    pub fn is_smooth(&self, at: usize, to: [usize; 2]) -> bool {
        let [one, two] = to.map(|end| self.along.get(&[at.min(end), at.max(end)]));
        one.is_some_and(|one| one.iter().any(|circle| two.is_some_and(|two| two.contains(circle))))
    }

    /// The circle that stands for this radius.
    pub fn find(&self, centre: Point, radius: f64) -> Option<usize> {
        self.circles.iter().position(|circle| {
            (circle.centre - centre).norm() < SAME
                && circle.radii.iter().any(|own| (own - radius).abs() < SAME)
        })
    }

    /// Points of a circle in the order of their angles.
    fn ring(&self, circle: usize) -> Vec<usize> {
        let own = &self.circles[circle];
        let mut ring: Vec<usize> =
            (0..self.through.len()).filter(|point| self.through[*point].contains(&circle)).collect();
        ring.sort_by(|a, b| {
            own.angle(self.chords.points[*a]).total_cmp(&own.angle(self.chords.points[*b])).then(a.cmp(b))
        });
        ring
    }

    fn near(&self, a: usize, b: usize) -> f64 {
        self.circles[a].near.min(self.circles[b].near)
    }

    /// What is near to a point: least of its circles.
    fn near_point(&self, point: usize) -> f64 {
        self.through[point].iter().map(|circle| self.circles[*circle].near).fold(f64::INFINITY, f64::min)
    }

    fn push(&mut self, at: Point, through: impl IntoIterator<Item = usize>) -> usize {
        self.chords.points.push(at);
        self.through.push(through.into_iter().collect());
        self.through.len() - 1
    }

    /// Points where two circles cross; crossings near to each other are one.
    fn cross(&mut self) {
        for b in 0..self.circles.len() {
            for a in 0..b {
                for at in crossings(&self.circles[a], &self.circles[b]).into_iter().flatten() {
                    let near = self.near(a, b);
                    let is_here = |point: &usize| {
                        (self.chords.points[*point] - at).norm() < near.min(self.near_point(*point)).max(SAME)
                    };
                    match (0..self.through.len()).find(is_here) {
                        Some(point) => self.through[point].extend([a, b]),
                        None => _ = self.push(at, [a, b]),
                    }
                }
            }
        }
    }

    /// Gives a circle the points that are as good as on it, and others between them.
    fn fill(&mut self, circle: usize, angles: &Angles) {
        let own = self.circles[circle].clone();
        for point in 0..self.through.len() {
            if own.off(self.chords.points[point]).abs() < own.near.min(self.near_point(point)) {
                self.through[point].insert(circle);
            }
        }
        let stops: Vec<f64> =
            self.ring(circle).into_iter().map(|point| own.angle(self.chords.points[point])).collect();
        for angle in angles.between(own.radius, &stops) {
            let at = own.centre + Point::polar(own.radius, angle);
            let is_here = |point: &usize| {
                (self.chords.points[*point] - at).norm() < own.near.min(self.near_point(*point))
            };
            if let Some(point) = (0..self.through.len()).find(is_here) {
                self.through[point].insert(circle);
                continue;
            }
            // Earlier circles that are as good as here get the point too.
            let others = (0..circle)
                .filter(|other| self.circles[*other].off(at).abs() < self.near(circle, *other))
                .chain([circle]);
            let others: Vec<usize> = others.collect();
            self.push(at, others);
        }
    }

    /// Of two points of a circle at nearly the same angle it keeps the one that is nearer to it.
    fn thin(&mut self) {
        for circle in 0..self.circles.len() {
            let own = self.circles[circle].clone();
            let ring = self.ring(circle);
            for k in 0..ring.len() {
                let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
                let [one, two] = [a, b].map(|point| self.chords.points[point]);
                let apart = (own.angle(two) - own.angle(one)).rem_euclid(TAU).min(PI) * own.radius;
                let far = if own.off(one).abs() > own.off(two).abs() { (a, one) } else { (b, two) };
                if apart < 0.8 * own.near && own.off(far.1).abs() > SAME {
                    self.through[far.0].remove(&circle);
                }
            }
        }
    }

    /// Chords of all circles, with the circles along each.
    fn all_chords(&self) -> BTreeMap<[usize; 2], Vec<usize>> {
        let mut along: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for circle in 0..self.circles.len() {
            let ring = self.ring(circle);
            for k in 0..ring.len() {
                let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
                let circles = along.entry([a.min(b), a.max(b)]).or_default();
                if a != b && !circles.contains(&circle) {
                    circles.push(circle);
                }
            }
        }
        along
    }

    /// Puts each point in the middle between its circles.
    fn settle(&mut self) {
        for (at, through) in self.chords.points.iter_mut().zip(&self.through).filter(|(_, own)| own.len() > 1)
        {
            let on = |circle: &usize| {
                let own = &self.circles[*circle];
                own.centre + (*at - own.centre) * (own.radius / (*at - own.centre).norm())
            };
            let sum = through.iter().map(on).fold(Point::ORIGIN, |sum, on| sum + on);
            *at = sum * (1.0 / through.len() as f64);
        }
    }

    /// Makes one of two points that settled at one place.
    fn merge(&mut self) {
        for b in 0..self.through.len() {
            for a in 0..b {
                let apart = (self.chords.points[a] - self.chords.points[b]).norm();
                if apart < ONE * self.near_point(a).min(self.near_point(b))
                    && !self.through[a].is_empty()
                    && !self.through[b].is_empty()
                {
                    let own = std::mem::take(&mut self.through[b]);
                    self.through[a].extend(own);
                    break;
                }
            }
        }
    }

    /// Chords that pass a point closely go through it, and those that still cross get a point there.
    fn mend(&mut self) -> Result<(), Point> {
        let mut last = Point::ORIGIN;
        for _ in 0..ROUNDS {
            self.settle();
            self.merge();
            let along = self.all_chords();
            let chords: Vec<(&[usize; 2], &Vec<usize>)> = along.iter().collect();
            let mut order: Vec<usize> = (0..self.through.len()).collect();
            order.sort_by(|a, b| self.chords.points[*a].x.total_cmp(&self.chords.points[*b].x));
            let mut more: Vec<(usize, Vec<usize>)> = Vec::new();
            for (ends, circles) in &chords {
                let [p, q] = ends.map(|end| self.chords.points[end]);
                let near =
                    circles.iter().map(|circle| self.circles[*circle].near).fold(f64::INFINITY, f64::min);
                let first = order.partition_point(|point| self.chords.points[*point].x < p.x.min(q.x) - near);
                for point in &order[first..] {
                    let at = self.chords.points[*point];
                    if at.x > p.x.max(q.x) + near {
                        break;
                    }
                    if ends.contains(point) || self.through[*point].is_empty() {
                        continue;
                    }
                    let along = (at - p).dot(q - p) / (q - p).dot(q - p);
                    let off = (q - p).cross(at - p).abs() / (q - p).norm();
                    if (0.0..=1.0).contains(&along) && off < PASSES * near.min(self.near_point(*point)) {
                        more.push((*point, circles.to_vec()));
                    }
                }
            }
            let mut new: Vec<(Point, Vec<usize>)> = Vec::new();
            self.bare_lenses(&along, &mut more, &mut new);
            if more.is_empty() && new.is_empty() {
                let mut by_x: Vec<(f64, f64, usize)> = chords
                    .iter()
                    .enumerate()
                    .map(|(k, (ends, _))| {
                        let [a, b] = ends.map(|end| self.chords.points[end].x);
                        (a.min(b), a.max(b), k)
                    })
                    .collect();
                by_x.sort_by(|a, b| a.0.total_cmp(&b.0));
                for (k, (_, right, one)) in by_x.iter().enumerate() {
                    for (left, _, two) in &by_x[k + 1..] {
                        if left > right {
                            break;
                        }
                        let ((a, of_a), (b, of_b)) = (chords[*one], chords[*two]);
                        if a.iter().any(|end| b.contains(end)) {
                            continue;
                        }
                        let ends = [a[0], a[1], b[0], b[1]].map(|end| self.chords.points[end]);
                        let Some(at) = meeting(ends) else { continue };
                        let all: Vec<usize> = of_a.iter().chain(of_b).copied().collect();
                        let near =
                            all.iter().map(|circle| self.circles[*circle].near).fold(f64::INFINITY, f64::min);
                        let off = |end: &usize| (self.chords.points[*end] - at).norm();
                        let nearest = a
                            .iter()
                            .chain(b)
                            .min_by(|x, y| off(x).total_cmp(&off(y)))
                            .copied()
                            .unwrap_or(a[0]);
                        if off(&nearest) < near {
                            more.push((nearest, all));
                        } else {
                            new.push((at, all));
                        }
                        last = at;
                    }
                }
                if more.is_empty() && new.is_empty() {
                    return Ok(());
                }
            }
            for (at, circles) in new {
                self.push(at, circles);
            }
            for (point, circles) in more {
                last = self.chords.points[point];
                self.through[point].extend(circles);
            }
        }
        Err(last)
    }

    /// Between one chord and the arc of another circle over it triangles would have two chords of one circle, which is flat where they meet: the
    /// chord goes through the points of the arc where they are near, and has a point in its middle elsewhere.
    fn bare_lenses(
        &self,
        along: &BTreeMap<[usize; 2], Vec<usize>>,
        more: &mut Vec<(usize, Vec<usize>)>,
        new: &mut Vec<(Point, Vec<usize>)>,
    ) {
        let rings: Vec<Vec<usize>> = (0..self.circles.len()).map(|circle| self.ring(circle)).collect();
        for ([a, b], circles) in along {
            let common = self.through[*a].intersection(&self.through[*b]);
            for other in common.filter(|other| !circles.contains(other)) {
                let ring = &rings[*other];
                let place = |end: &usize| ring.iter().position(|point| point == end);
                let (Some(one), Some(two)) = (place(a), place(b)) else { continue };
                let steps = (two + ring.len() - one) % ring.len();
                let (first, steps) =
                    if 2 * steps > ring.len() { (two, ring.len() - steps) } else { (one, steps) };
                if steps < 2 {
                    continue;
                }
                let between: Vec<usize> = (1..steps).map(|k| ring[(first + k) % ring.len()]).collect();
                let near =
                    circles.iter().map(|circle| self.near(*circle, *other)).fold(f64::INFINITY, f64::min);
                let own = &self.circles[circles[0]];
                let [p, q] = [a, b].map(|end| self.chords.points[*end]);
                if between.iter().all(|point| own.off(self.chords.points[*point]).abs() < near) {
                    more.extend(between.into_iter().map(|point| (point, circles.clone())));
                } else {
                    new.push((arc_middle(own.centre, p, q), circles.clone()));
                }
                break;
            }
        }
    }

    /// Numbers the points that are used, and gives the chords the middles of their arcs.
    fn finish(&mut self) {
        let along = self.all_chords();
        let mut is_used = vec![false; self.through.len()];
        for point in along.keys().flatten() {
            is_used[*point] = true;
        }
        let mut number = vec![0; is_used.len()];
        let (mut points, mut through) = (Vec::new(), Vec::new());
        for point in (0..is_used.len()).filter(|point| is_used[*point]) {
            number[point] = points.len();
            points.push(self.chords.points[point]);
            through.push(std::mem::take(&mut self.through[point]));
        }
        (self.chords.points, self.through) = (points, through);
        for (ends, circles) in along {
            let ends = ends.map(|end| number[end]);
            if ends[0] == ends[1] {
                continue;
            }
            let [a, b] = ends.map(|end| self.chords.points[end]);
            let arcs = circles.iter().map(|circle| arc_middle(self.circles[*circle].centre, a, b));
            let middle = arcs.fold(Point::ORIGIN, |sum, at| sum + at) * (1.0 / circles.len() as f64);
            self.chords.chords.push((ends, middle));
            self.along.insert(ends, circles);
        }
    }
}

/// Where two circles cross.
fn crossings(one: &Circle, two: &Circle) -> Option<[Point; 2]> {
    let apart = two.centre - one.centre;
    let distance = apart.norm();
    let (a, b) = (one.radius, two.radius);
    if distance < SAME || distance >= a + b || distance <= (a - b).abs() {
        return None;
    }
    let cos = (a * a + distance * distance - b * b) / (2.0 * a * distance);
    let (towards, half) = (apart.y.atan2(apart.x), cos.clamp(-1.0, 1.0).acos());
    Some([towards - half, towards + half].map(|angle| one.centre + Point::polar(a, angle)))
}

/// Where two lines cross between their ends.
fn meeting([a, b, c, d]: [Point; 4]) -> Option<Point> {
    let (u, v) = (b - a, d - c);
    let all = u.cross(v);
    if all == 0.0 {
        return None;
    }
    let (s, t) = ((c - a).cross(v) / all, (c - a).cross(u) / all);
    ((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)).then(|| a + u * s)
}

/// Where rings about one centre have their points.
struct Angles {
    /// Away from other circles: angles of all rings.
    common: Vec<f64>,
    /// Near other circles: from, to, rising [rad].
    sectors: Vec<[f64; 2]>,
    /// Length of chords in the sectors, and away from them [m].
    chords: [f64; 2],
}

impl Angles {
    fn of(families: &[Rings], family: usize) -> Angles {
        let own = &families[family];
        let chord = (CHORD * own.layer).min(own.chord);
        let outer = own.rings[own.rings.len() - 1].radius;
        let sectors = sectors(families, family);
        let is_all = matches!(sectors[..], [[from, to]] if to - from > TAU - 1e-9);
        let mut common = Vec::new();
        if sectors.is_empty() || is_all {
            let count = ((TAU * outer / own.chord).ceil() as usize).max(8);
            common.extend((0..count).map(|k| TAU * k as f64 / count as f64));
        } else {
            for (k, [_, to]) in sectors.iter().enumerate() {
                let next = sectors[(k + 1) % sectors.len()][0];
                let gap = (next - to).rem_euclid(TAU);
                let mut angles = graded(*to, gap, outer, own.layer, own.chord);
                angles.push(to + gap);
                common.extend(angles.into_iter().map(|angle| angle.rem_euclid(TAU)));
            }
        }
        common.sort_by(f64::total_cmp);
        Angles { common, sectors, chords: [chord, own.chord] }
    }

    /// Angles of a ring between those that it has already.
    fn between(&self, radius: f64, stops: &[f64]) -> Vec<f64> {
        let room = 0.6 * self.chords[0] / radius;
        let apart = |a: f64, b: f64| {
            let apart = (a - b).rem_euclid(TAU);
            apart.min(TAU - apart)
        };
        let is_in =
            |angle: f64| self.sectors.iter().any(|[from, to]| (angle - from).rem_euclid(TAU) <= to - from);
        let free =
            self.common.iter().copied().filter(|angle| stops.iter().all(|stop| apart(*stop, *angle) > room));
        let new: Vec<f64> = free.collect();
        let mut all: Vec<f64> = new.iter().chain(stops).copied().collect();
        all.sort_by(f64::total_cmp);
        let mut between = new;
        for k in 0..all.len() {
            let gap = (all[(k + 1) % all.len()] - all[k]).rem_euclid(TAU);
            let gap = if all.len() == 1 { TAU } else { gap };
            let chord = self.chords[usize::from(!is_in(all[k] + gap / 2.0))];
            let count = (gap * radius / chord).round().max(1.0) as usize;
            between.extend((1..count).map(|i| (all[k] + gap * i as f64 / count as f64).rem_euclid(TAU)));
        }
        between
    }
}

/// Sectors in which rings and others, each wider by a layer, have something in common; one of a whole turn where they have everywhere.
fn sectors(families: &[Rings], family: usize) -> Vec<[f64; 2]> {
    let reach = |rings: &Rings| {
        let last = rings.rings.len() - 1;
        [rings.rings[0].radius - rings.layer, rings.rings[last].radius + rings.layer]
    };
    let own = &families[family];
    let [inner, outer] = reach(own);
    let depths = (((outer - inner) / (0.5 * own.layer)).ceil() as usize).max(1);
    let others: Vec<(Point, [f64; 2])> = families
        .iter()
        .filter(|other| (other.centre - own.centre).norm() > SAME)
        .map(|other| (other.centre, reach(other)))
        .collect();
    let is_met = |step: usize| {
        let angle = TAU * step as f64 / STEPS as f64;
        (0..=depths).any(|k| {
            let at = own.centre + Point::polar(inner + (outer - inner) * k as f64 / depths as f64, angle);
            others.iter().any(|(centre, [from, to])| (*from..=*to).contains(&(at - *centre).norm()))
        })
    };
    let met: Vec<bool> = (0..STEPS).map(is_met).collect();
    let Some(first) = (0..STEPS).find(|k| !met[*k] && met[(*k + 1) % STEPS]) else {
        return if met[0] { vec![[0.0, TAU]] } else { Vec::new() };
    };
    let angle = |step: usize| TAU * step as f64 / STEPS as f64;
    let mut found: Vec<[f64; 2]> = Vec::new();
    for step in first + 1..=first + STEPS {
        if !met[step % STEPS] {
            continue;
        }
        match found.last_mut() {
            Some(sector) if angle(step) - sector[1] < 1.5 * TAU / STEPS as f64 => sector[1] = angle(step),
            _ => found.push([angle(step), angle(step)]),
        }
    }
    // Sectors with little between them are one.
    let little = 2.5 * own.layer / own.rings[0].radius;
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for sector in found {
        match joined.last_mut() {
            Some(last) if sector[0] - last[1] < little => last[1] = sector[1],
            _ => joined.push(sector),
        }
    }
    let (first, last) = (joined[0], joined[joined.len() - 1]);
    if joined.len() > 1 && first[0] + TAU - last[1] < little {
        joined[0][0] = last[0] - TAU;
        joined.pop();
    }
    if joined.len() == 1 && TAU - (joined[0][1] - joined[0][0]) < little {
        return vec![[0.0, TAU]];
    }
    joined
}

/// Angles from `from` through `gap`, without its end: chords grow from `layer` at both ends to `chord`.
fn graded(from: f64, gap: f64, radius: f64, layer: f64, chord: f64) -> Vec<f64> {
    let size = |part: f64| {
        let along = part.min(1.0 - part) * gap * radius;
        (1.3 * layer + 0.4 * along).min(chord)
    };
    // As many chords as the integral of their number, at equal steps of it.
    const STEPS: usize = 400;
    let mut sums = vec![0.0];
    for k in 0..STEPS {
        let part = (k as f64 + 0.5) / STEPS as f64;
        sums.push(sums[k] + gap * radius / STEPS as f64 / size(part));
    }
    let all = sums[STEPS];
    let count = (all.round() as usize).max(1);
    (0..count)
        .map(|k| {
            let wanted = all * k as f64 / count as f64;
            let place = sums.partition_point(|sum| *sum <= wanted).clamp(1, STEPS);
            let part = (place as f64 - 1.0 + (wanted - sums[place - 1]) / (sums[place] - sums[place - 1]))
                / STEPS as f64;
            from + gap * part
        })
        .collect()
}
