//! A place for every shaft of an arrangement, and its drive.
//!
//! Among the allowed positions those are taken that clear crank sweep, rods, cylinders and one another, by rising
//! roll moment that the shafts add (within a hundredth of what one of them alone would add), then by rising number of
//! meshes, chains, gear planes, and by gear size. A pair of shafts of one order adds
//!
//! ```text
//! |Y_+ - conj(Y_-)|,  Y = conj(axis) SUM U w_s^2
//! ```
//! which a mirrored pair of equal weights brings to 0.

use crate::arrangement::drive::{Axes, DriveTree, drive_trees};
use crate::arrangement::envelope::Envelope;
use crate::arrangement::request::{ArrangementRequest, Positions};
use crate::arrangement::result::{Clearance, DriveTrain};
use num_complex::Complex64;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Places of one order that are carried on.
const KEPT: usize = 24;

/// Sets of places for which a drive is built.
const DRIVEN: usize = 48;

/// A shaft that needs a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tenant {
    /// Speed over that of crankshaft 1, signed.
    pub ratio: i32,
    /// Outer radius of its weights [m], a whole number of millimetres.
    pub sweep: f64,
    /// `SUM U w_s^2` of its weights [N].
    pub force: Complex64,
}

/// Where the shafts stand and how they are driven.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placement {
    /// Positions, one a shaft.
    pub places: Vec<Complex64>,
    /// The drive.
    pub drive: DriveTrain,
    /// The narrowest place, weights and drive together.
    pub clearance: Clearance,
}

/// A position with the room around it.
#[derive(Debug, Clone, PartialEq)]
struct Spot {
    place: Complex64,
    clearance: Clearance,
}

/// The allowed positions of an engine.
pub(crate) struct Ground<'a> {
    envelope: &'a Envelope,
    request: &'a ArrangementRequest,
    /// Positions by the sweep of the weights [mm].
    spots: HashMap<u32, Vec<Spot>>,
}

/// Some shafts, placed.
#[derive(Debug, Clone)]
struct Group {
    places: Vec<Complex64>,
    roll: f64,
    apart: f64,
    clearance: Clearance,
}

impl<'a> Ground<'a> {
    pub fn new(envelope: &'a Envelope, request: &'a ArrangementRequest) -> Ground<'a> {
        Ground { envelope, request, spots: HashMap::new() }
    }

    /// Positions for weights of this sweep, those that do not clear too.
    fn spots(&mut self, sweep: f64) -> Vec<Spot> {
        let key = (sweep * 1e3).round() as u32;
        let (envelope, request) = (self.envelope, self.request);
        self.spots.entry(key).or_insert_with(|| allowed(envelope, request, sweep)).clone()
    }

    /// The best place of all shafts with their drive, or the narrowest place of the best that there is.
    pub fn place(&mut self, tenants: &[Tenant]) -> Result<Placement, Clearance> {
        let least = self.request.parts.clearance;
        let mut groups: Vec<(Vec<usize>, Vec<Group>)> = Vec::new();
        for order in [1, 2] {
            let members: Vec<usize> =
                (0..tenants.len()).filter(|k| tenants[*k].ratio.abs() == order).collect();
            if !members.is_empty() {
                let chosen: Vec<Tenant> = members.iter().map(|k| tenants[*k]).collect();
                groups.push((members, self.group(&chosen)?));
            }
        }
        let mut sets = combined(tenants, &groups, least)?;
        sets.truncate(DRIVEN);
        let ratios: Vec<i32> = tenants.iter().map(|t| t.ratio).collect();
        let trees = drive_trees(&ratios, self.request.drive);
        self.driven(&ratios, sets, &trees)
    }

    /// The best places of the one or two shafts of an order.
    fn group(&mut self, members: &[Tenant]) -> Result<Vec<Group>, Clearance> {
        let least = self.request.parts.clearance;
        let mut open: Vec<Vec<Spot>> = Vec::with_capacity(members.len());
        for member in members {
            let spots = self.spots(member.sweep);
            let narrow = spots.iter().max_by(|a, b| a.clearance.distance.total_cmp(&b.clearance.distance));
            let best = narrow.map(|s| named(member, s.clearance.clone()));
            let clear: Vec<Spot> =
                spots.iter().filter(|s| s.clearance.distance >= least * (1.0 - 1e-9)).cloned().collect();
            if clear.is_empty() {
                return Err(best.unwrap_or_else(nowhere));
            }
            open.push(clear);
        }
        let mut out = Vec::new();
        let mut widest: Option<Clearance> = None;
        match (members, &open[..]) {
            ([one], [spots]) => out.extend(spots.iter().map(|spot| Group {
                places: vec![spot.place],
                roll: (spot.place.conj() * one.force).norm(),
                apart: spot.place.norm(),
                clearance: Clearance { distance: f64::INFINITY, between: String::new() },
            })),
            ([a, b], [first, second]) => {
                for s in first {
                    for t in second {
                        let apart = (s.place - t.place).norm();
                        let between =
                            Clearance { distance: apart - a.sweep - b.sweep, between: String::new() };
                        if between.distance < least {
                            if widest.as_ref().is_none_or(|w| between.distance > w.distance) {
                                widest = Some(between);
                            }
                            continue;
                        }
                        let y = [s.place.conj() * a.force, t.place.conj() * b.force];
                        let y = if a.ratio > 0 { y } else { [y[1], y[0]] };
                        out.push(Group {
                            places: vec![s.place, t.place],
                            roll: (y[0] - y[1].conj()).norm(),
                            apart,
                            clearance: between,
                        });
                    }
                }
                let Some(widest) = widest.filter(|_| out.is_empty()) else {
                    return Ok(self.kept(members, &open, out));
                };
                return Err(Clearance { between: weights_of(a, b), ..widest });
            }
            _ => return Err(nowhere()),
        }
        Ok(self.kept(members, &open, out))
    }

    /// The best groups by roll moment, then by distance.
    fn kept(&self, members: &[Tenant], open: &[Vec<Spot>], mut groups: Vec<Group>) -> Vec<Group> {
        let step = 0.01
            * members.iter().map(|m| m.force.norm()).sum::<f64>()
            * groups.iter().flat_map(|g| &g.places).map(|p| p.norm()).fold(0.0, f64::max);
        for group in &mut groups {
            group.roll = if step > 0.0 { (group.roll / step).round() * step } else { 0.0 };
        }
        groups.sort_by(by_roll);
        groups.truncate(KEPT);
        // In words only for those that are kept.
        for group in &mut groups {
            if let [a, b] = members {
                group.clearance.between = weights_of(a, b);
            }
            for ((member, spots), place) in members.iter().zip(open).zip(&group.places) {
                let own = spots.iter().find(|s| s.place == *place).map(|s| &s.clearance);
                if let Some(own) = own.filter(|own| own.distance < group.clearance.distance) {
                    group.clearance = named(member, own.clone());
                }
            }
        }
        groups
    }

    /// The first set of places with the best drive.
    fn driven(&self, ratios: &[i32], sets: Vec<Group>, trees: &[DriveTree]) -> Result<Placement, Clearance> {
        let parts = &self.request.parts;
        let fewest = trees.first().map_or(0, |t| t.meshes);
        let mut best: Option<(usize, f64, Placement)> = None;
        let mut narrow: Option<Clearance> = None;
        let mut roll = f64::INFINITY;
        for Group { places, roll: own_roll, clearance, .. } in sets {
            // A drive for less roll moment goes before any with fewer meshes.
            if best.is_some() && own_roll > roll * (1.0 + 1e-9) + 1e-9 {
                break;
            }
            let axes = Axes { places: &places, ratios, journal_radius: self.envelope.journal_radius, parts };
            for tree in trees {
                if best.as_ref().is_some_and(|b| tree.meshes > b.0) {
                    break;
                }
                let (drive, gap) = axes.drive(tree);
                if gap.distance < parts.clearance * (1.0 - 1e-9) {
                    if narrow.as_ref().is_none_or(|n| gap.distance > n.distance) {
                        narrow = Some(gap);
                    }
                    continue;
                }
                let size: f64 = drive.gears.iter().map(|g| g.pitch_diameter * g.pitch_diameter).sum();
                if best.as_ref().is_none_or(|b| tree.meshes < b.0 || size < b.1 * (1.0 - 1e-6)) {
                    roll = own_roll;
                    let narrowest = if gap.distance < clearance.distance { gap } else { clearance.clone() };
                    let places = places.clone();
                    best = Some((tree.meshes, size, Placement { places, drive, clearance: narrowest }));
                }
                if tree.meshes == fewest {
                    break;
                }
            }
        }
        match best {
            Some((_, _, placement)) => Ok(placement),
            None => Err(narrow.unwrap_or_else(nowhere)),
        }
    }
}

/// Whole sets of places, the weights of different orders clear of one another, by rising roll moment and distance.
fn combined(
    tenants: &[Tenant],
    groups: &[(Vec<usize>, Vec<Group>)],
    least: f64,
) -> Result<Vec<Group>, Clearance> {
    let free = Clearance { distance: f64::INFINITY, between: String::new() };
    let nobody = vec![Complex64::ZERO; tenants.len()];
    let mut sets = vec![Group { places: nobody, roll: 0.0, apart: 0.0, clearance: free.clone() }];
    let mut placed: Vec<usize> = Vec::new();
    let mut widest: Option<Clearance> = None;
    for (members, choices) in groups {
        let mut next = Vec::new();
        for set in &sets {
            for group in choices {
                let mut places = set.places.clone();
                let mut narrow = free.clone();
                for (&k, &place) in members.iter().zip(&group.places) {
                    places[k] = place;
                    for &other in &placed {
                        let apart = (place - set.places[other]).norm();
                        let room = apart - tenants[k].sweep - tenants[other].sweep;
                        if room < narrow.distance {
                            let between = weights_of(&tenants[other], &tenants[k]);
                            narrow = Clearance { distance: room, between };
                        }
                    }
                }
                if narrow.distance < least {
                    if widest.as_ref().is_none_or(|w| narrow.distance > w.distance) {
                        widest = Some(narrow);
                    }
                    continue;
                }
                let clearance = [&group.clearance, &set.clearance]
                    .into_iter()
                    .fold(narrow, |n, c| if c.distance < n.distance { c.clone() } else { n });
                let (roll, apart) = (set.roll + group.roll, set.apart + group.apart);
                next.push(Group { places, roll, apart, clearance });
            }
        }
        sets = next;
        placed.extend(members);
    }
    if sets.is_empty() {
        return Err(widest.unwrap_or_else(nowhere));
    }
    sets.sort_by(by_roll);
    Ok(sets)
}

/// By rising roll moment, then distance in whole micrometres, so that of equals the first stays first.
fn by_roll(a: &Group, b: &Group) -> std::cmp::Ordering {
    let distance = |group: &Group| (group.apart * 1e6).round();
    a.roll.total_cmp(&b.roll).then(distance(a).total_cmp(&distance(b)))
}

/// No position at all.
fn nowhere() -> Clearance {
    Clearance { distance: f64::NEG_INFINITY, between: "no position is allowed".to_owned() }
}

fn weights_of(a: &Tenant, b: &Tenant) -> String {
    format!("the weights of shaft {:+} and of shaft {:+}", a.ratio, b.ratio)
}

fn named(tenant: &Tenant, clearance: Clearance) -> Clearance {
    let between = format!("the weights of shaft {:+} {}", tenant.ratio, clearance.between);
    Clearance { between, ..clearance }
}

/// The allowed positions for weights of this sweep.
fn allowed(envelope: &Envelope, request: &ArrangementRequest, sweep: f64) -> Vec<Spot> {
    // The sine of 180 deg is not quite 0.
    let exact = |v: f64| if v.abs() < 1e-12 { 0.0 } else { v };
    let spot = |place: Complex64| {
        let place = Complex64::new(exact(place.re), exact(place.im));
        let nearest = envelope.nearest(place);
        let (x, y) = (1e3 * place.re, 1e3 * place.im);
        let between = format!("at x = {x:.0} mm, y = {y:.0} mm and {}", nearest.part.name());
        Spot { place, clearance: Clearance { distance: nearest.distance - sweep, between } }
    };
    match &request.positions {
        Positions::Points { points } => points.iter().map(|p| spot(Complex64::new(p[0], p[1]))).collect(),
        Positions::Box { x, y, step } => {
            let count = |range: &[f64; 2]| ((range[1] - range[0]) / step + 1e-9).floor() as usize + 1;
            let (rows, columns) = (count(x), count(y));
            (0..rows * columns)
                .map(|k| {
                    let (row, column) = ((k / columns) as f64, (k % columns) as f64);
                    spot(Complex64::new(x[0] + step * row, y[0] + step * column))
                })
                .collect()
        }
        Positions::Ring { step } => {
            let count = (TAU / step).round().max(1.0) as usize;
            // From below, so that the place opposite to the cylinders is the first of equals.
            (0..count)
                .map(|k| {
                    spot(ring_place(envelope, request, sweep, 0.5 * TAU + k as f64 * TAU / count as f64))
                })
                .collect()
        }
    }
}

/// Nearest place to the crank in direction `angle` [rad] that clears, or the last one looked at: no farther than three
/// times crank sweep and weights.
fn ring_place(envelope: &Envelope, request: &ArrangementRequest, sweep: f64, angle: f64) -> Complex64 {
    let unit = Complex64::cis(angle);
    let need = sweep + request.parts.clearance;
    let crank = envelope.cranks[0].1;
    let mut distance = crank + need;
    for _ in 0..24 {
        // Distances change by no more than the step, so that nothing free is passed over.
        let lack = need - envelope.nearest(distance * unit).distance;
        if lack <= 1e-9 || distance > 3.0 * (crank + sweep) {
            break;
        }
        distance += lack.max(1e-4);
    }
    distance * unit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::request::PartSizes;
    use crate::arrangement::sample::twin;

    fn tenants(list: &[(i32, f64)]) -> Vec<Tenant> {
        let force = |ratio: i32| Complex64::new(-4000.0 / f64::from(ratio.abs()), 0.0);
        list.iter().map(|&(ratio, sweep)| Tenant { ratio, sweep, force: force(ratio) }).collect()
    }

    #[test]
    fn a_pair_stands_mirrored_and_clears_everything() {
        let (engine, request) = (twin(), ArrangementRequest::default());
        let envelope = Envelope::of(&engine, &request.parts);
        let wanted = tenants(&[(1, 0.045), (-1, 0.045), (2, 0.025), (-2, 0.025)]);
        let placed = Ground::new(&envelope, &request).place(&wanted).unwrap();
        let p = &placed.places;
        assert!((p[0] - p[1].conj()).norm() < 1e-9 && (p[2] - p[3].conj()).norm() < 1e-9, "{p:?}");
        for (k, a) in p.iter().enumerate() {
            assert!(envelope.nearest(*a).distance - wanted[k].sweep >= request.parts.clearance - 1e-9);
            for (j, b) in p.iter().enumerate().skip(k + 1) {
                assert!((a - b).norm() >= wanted[k].sweep + wanted[j].sweep + request.parts.clearance);
            }
        }
        assert!(placed.clearance.distance >= request.parts.clearance - 1e-9, "{:?}", placed.clearance);
        // The narrowest place is told, whether it lies at the crank or between the shafts.
        let mut narrowest = f64::INFINITY;
        for (k, a) in p.iter().enumerate() {
            narrowest = narrowest.min(envelope.nearest(*a).distance - wanted[k].sweep);
            for (j, b) in p.iter().enumerate().skip(k + 1) {
                narrowest = narrowest.min((a - b).norm() - wanted[k].sweep - wanted[j].sweep);
            }
        }
        assert!(placed.clearance.distance <= narrowest + 1e-12 && !placed.clearance.between.is_empty());
    }

    #[test]
    fn a_position_inside_the_crank_sweep_says_by_how_much() {
        let engine = twin();
        let parts = PartSizes { crank_sweep: Some(0.09), ..PartSizes::default() };
        let positions = Positions::Points { points: vec![[-0.05, 0.0], [-0.10, 0.0]] };
        let request = ArrangementRequest { positions, parts, ..ArrangementRequest::default() };
        let envelope = Envelope::of(&engine, &request.parts);
        let refused = Ground::new(&envelope, &request).place(&tenants(&[(-1, 0.03)])).unwrap_err();
        // 100 mm from the crank: 90 mm sweep and 30 mm weights overlap by 20 mm.
        assert!((refused.distance + 0.02).abs() < 1e-12, "{refused:?}");
        assert!(refused.between.contains("x = -100 mm") && refused.between.contains("crank sweep"));
    }

    #[test]
    fn one_position_is_not_enough_for_two_shafts() {
        let engine = twin();
        let positions = Positions::Points { points: vec![[-0.2, 0.0]] };
        let request = ArrangementRequest { positions, ..ArrangementRequest::default() };
        let envelope = Envelope::of(&engine, &request.parts);
        let refused = Ground::new(&envelope, &request).place(&tenants(&[(2, 0.03), (-2, 0.03)])).unwrap_err();
        assert!((refused.distance + 0.06).abs() < 1e-12 && refused.between.contains("shaft +2"));
    }

    #[test]
    fn a_box_is_searched_on_its_grid() {
        let engine = twin();
        let positions = Positions::Box { x: [-0.18, -0.10], y: [-0.10, 0.10], step: 0.01 };
        let request = ArrangementRequest { positions, ..ArrangementRequest::default() };
        let envelope = Envelope::of(&engine, &request.parts);
        let placed = Ground::new(&envelope, &request).place(&tenants(&[(2, 0.03), (-2, 0.03)])).unwrap();
        for place in placed.places {
            let steps = [(place.re + 0.18) / 0.01, (place.im + 0.1) / 0.01];
            assert!(steps.iter().all(|s| (s - s.round()).abs() < 1e-9));
        }
    }
}
