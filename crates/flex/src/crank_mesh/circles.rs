//! Circles of the core as points and chords.

use lanchester_shape::Point;
use std::f64::consts::{PI, TAU};

/// Points closer than this are one [m].
const SAME: f64 = 1e-7;

/// Chords near crossings are no longer than this share of the radius: what two circles have in common is narrow.
const LENS: f64 = 0.12;
/// Chords are no longer than this share of the radius.
const ROUND: f64 = 0.25;

/// Edges of an outline shorter than this are left out [m].
const SHORT: f64 = 2e-5;

/// Circles about one centre: a bar with the layers of its fillets, or a bore.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rings {
    pub centre: Point,
    /// Rising [m].
    pub radii: Vec<f64>,
    /// Length of the chords that is wanted [m].
    pub chord: f64,
    pub is_bore: bool,
}

/// Points of all circles, and chords with the middle of their arc.
#[derive(Debug, Clone, Default)]
pub(super) struct Chords {
    pub points: Vec<Point>,
    pub chords: Vec<([usize; 2], Point)>,
    /// Centre and radius of each circle and its chords.
    pub circles: Vec<(Point, f64, Polygon)>,
}

/// A closed line of chords.
#[derive(Debug, Clone, Default)]
pub(super) struct Polygon(pub Vec<[Point; 2]>);

impl Polygon {
    /// Whether a point is within: a ray from it crosses an odd number of chords.
    pub fn contains(&self, at: Point) -> bool {
        let crossed = self.0.iter().filter(|[a, b]| {
            let spans = (a.y > at.y) != (b.y > at.y);
            spans && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)
        });
        crossed.count() % 2 == 1
    }
}

impl Chords {
    /// The chords of a circle; none where it is not there.
    pub fn circle(&self, centre: Point, radius: f64) -> Polygon {
        let own =
            |(at, r, _): &&(Point, f64, Polygon)| (*at - centre).norm() < SAME && (r - radius).abs() < SAME;
        self.circles.iter().find(own).map(|(_, _, polygon)| polygon.clone()).unwrap_or_default()
    }

    /// All chords as one polygon, holes included.
    pub fn polygon(&self) -> Polygon {
        Polygon(self.chords.iter().map(|([a, b], _)| [self.points[*a], self.points[*b]]).collect())
    }

    fn point(&mut self, at: Point, same: f64) -> usize {
        if let Some(found) = self.points.iter().position(|point| (*point - at).norm() < same) {
            return found;
        }
        self.points.push(at);
        self.points.len() - 1
    }
}

/// Angles on a circle at which others cross it.
fn crossings(centre: Point, radius: f64, other: Point, other_radius: f64) -> Option<[f64; 2]> {
    let apart = other - centre;
    let distance = apart.norm();
    if distance < SAME || distance >= radius + other_radius || distance <= (radius - other_radius).abs() {
        return None;
    }
    let cos =
        (radius * radius + distance * distance - other_radius * other_radius) / (2.0 * radius * distance);
    let (towards, half) = (apart.y.atan2(apart.x), cos.clamp(-1.0, 1.0).acos());
    Some([towards - half, towards + half])
}

/// Cuts all circles where they cross, and the rest into chords. Rings about one centre have their points at the same angles but near
/// crossings.
pub(super) fn chords(rings: &[Rings]) -> Chords {
    let mut result = Chords::default();
    for (index, own) in rings.iter().enumerate() {
        let own = &Rings { chord: own.chord.min(ROUND * own.radii[0]), ..own.clone() };
        // Crossings of each ring, and the sectors that hold those of all rings.
        let each: Vec<Vec<f64>> = own
            .radii
            .iter()
            .map(|radius| {
                let others = rings.iter().enumerate().filter(|(other, _)| *other != index);
                let circles =
                    others.flat_map(|(_, other)| other.radii.iter().map(move |r| (other.centre, *r)));
                let angles = circles.filter_map(|(centre, r)| crossings(own.centre, *radius, centre, r));
                let mut angles: Vec<f64> = angles.flatten().map(|angle| angle.rem_euclid(TAU)).collect();
                angles.sort_by(f64::total_cmp);
                angles
            })
            .collect();
        let outer = own.radii[own.radii.len() - 1];
        let gaps = own.radii.windows(2).map(|pair| pair[1] - pair[0]);
        let layer = gaps.fold(own.chord.min(LENS * own.radii[0]), f64::min);
        let sectors = sectors(&each.concat(), 2.5 * layer / own.radii[0], 0.8 * layer / own.radii[0]);
        for (radius, crossed) in own.radii.iter().zip(&each) {
            let mut angles: Vec<f64> = Vec::new();
            if sectors.is_empty() {
                let count = ((TAU * outer / own.chord).ceil() as usize).max(8);
                angles.extend((0..count).map(|k| TAU * k as f64 / count as f64));
            }
            for (k, [from, to]) in sectors.iter().enumerate() {
                // Within the sector: the crossings of this ring, and what is between them by its layer.
                let mut stops = vec![*from];
                stops.extend(
                    crossed.iter().map(|angle| from + (angle - from).rem_euclid(TAU)).filter(|a| a <= to),
                );
                stops.push(*to);
                stops.sort_by(f64::total_cmp);
                for pair in stops.windows(2) {
                    let count = (((pair[1] - pair[0]) * radius / (1.6 * layer).min(own.chord)).round()
                        as usize)
                        .max(1);
                    angles
                        .extend((0..count).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64));
                }
                // After it to the next sector, at the same angles on all rings.
                let next = sectors[(k + 1) % sectors.len()][0];
                let gap = if sectors.len() == 1 { TAU - (to - from) } else { (next - to).rem_euclid(TAU) };
                angles.extend(graded(*to, gap, outer, layer, own.chord));
            }
            angles.sort_by(f64::total_cmp);
            angles.dedup_by(|a, b| (*a - *b).abs() * *radius < SAME);
            let points: Vec<usize> = angles
                .iter()
                .map(|angle| result.point(own.centre + Point::polar(*radius, *angle), SAME))
                .collect();
            let at = |k: usize| own.centre + Point::polar(*radius, angles[k % angles.len()]);
            let polygon = Polygon((0..points.len()).map(|k| [at(k), at(k + 1)]).collect());
            result.circles.push((own.centre, *radius, polygon));
            for k in 0..points.len() {
                let (a, b) = (angles[k], angles[(k + 1) % angles.len()]);
                let middle = a + (b - a).rem_euclid(TAU) / 2.0;
                let ends = [points[k], points[(k + 1) % points.len()]];
                if ends[0] != ends[1] {
                    result.chords.push((ends, own.centre + Point::polar(*radius, middle)));
                }
            }
        }
    }
    result
}

/// Sectors around angles that are no farther apart than `gap`, each wider by `margin` on both sides.
fn sectors(angles: &[f64], gap: f64, margin: f64) -> Vec<[f64; 2]> {
    let mut sorted = angles.to_vec();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len();
    // Begin after the widest gap, so that no sector is cut by the start of the turn.
    let Some(first) = (0..count).max_by(|a, b| {
        let gap = |k: usize| (sorted[k] - sorted[(k + count - 1) % count]).rem_euclid(TAU);
        let wide = |k: usize| if count == 1 { TAU } else { gap(k) };
        wide(*a).total_cmp(&wide(*b))
    }) else {
        return Vec::new();
    };
    let mut sectors: Vec<[f64; 2]> = Vec::new();
    for k in 0..count {
        let mut angle = sorted[(first + k) % count];
        if angle < sorted[first] {
            angle += TAU;
        }
        match sectors.last_mut() {
            Some(sector) if angle - sector[1] <= gap => sector[1] = angle,
            _ => sectors.push([angle, angle]),
        }
    }
    for sector in &mut sectors {
        *sector = [sector[0] - margin, sector[1] + margin];
    }
    sectors
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

/// Chords no longer than `size` and no more than 12 degrees along edges.
pub(super) fn outline_chords(edges: &[lanchester_shape::Edge], size: f64) -> Chords {
    let mut result = Chords::default();
    // Half the edges where they turn by more than a half circle: points along an edge are exact up to there.
    let halved = edges
        .iter()
        .flat_map(|edge| if edge.bulge.abs() > 0.9 { edge.halves().to_vec() } else { vec![*edge] });
    for edge in halved {
        let turn = 4.0 * edge.bulge.abs().atan();
        let count = ((edge.length() / size).ceil().max((turn / (PI / 15.0)).ceil()) as usize).max(1);
        for k in 0..count {
            let at = |part: f64| edge.at((k as f64 + part) / count as f64).0;
            let ends = [result.point(at(0.0), SHORT), result.point(at(1.0), SHORT)];
            if ends[0] != ends[1] {
                result.chords.push((ends, at(0.5)));
            }
        }
    }
    result
}
