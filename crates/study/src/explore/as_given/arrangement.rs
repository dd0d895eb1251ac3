//! Cylinders, rods, pins and crankshafts of an engine as they are: all but the angles of the throws and the firing.
//!
//! A *group* is what keeps its angles among itself: one throw with all its rods, or the throws whose pistons share a chamber.
//! The *lead* of a throw is its angle counted as crankshaft 1 turns, `ratio (phase + angle)` with a ratio of 1 or -1: when
//! the lead of a group grows by d, everything that it does comes d earlier.

use crate::explore::as_given::arrangement_error::ArrangementError;
use lanchester_mechanism::{LoadRequest, motion};
use lanchester_model::{Crankshaft, Cylinder, Engine, Ratio, Throw};
use lanchester_numerics::{about_zero, within_period};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Angles [rad] that miss a turn by less are 0.
const SAME: f64 = 1e-9;

/// What the layouts of an engine as it is share: everything but the angles of its throws, its firing and its weights.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Arrangement {
    /// Name of the engine.
    pub name: String,
    /// Crankshafts with their main bearings; ratios are 1 or -1.
    pub crankshafts: Vec<Crankshaft>,
    /// Throws with the first of each group at lead 0.
    pub throws: Vec<Throw>,
    /// Cylinders, without firing.
    pub cylinders: Vec<Cylinder>,
    /// Group of each throw; groups are numbered by their first throws.
    pub group_of_throw: Vec<usize>,
    /// Top dead centre of each chamber with its group at lead 0 [rad of crankshaft 1].
    pub top_dead_centres: Vec<f64>,
    /// Lead of each group from the first, as the engine has it [rad].
    pub throw_angles: Vec<f64>,
}

/// 1 for a crankshaft that turns with crankshaft 1, -1 for one that turns against it; `None` at another speed.
fn sense(ratio: Ratio) -> Option<f64> {
    [1.0, -1.0].into_iter().find(|sense| ratio.value() == *sense)
}

impl Arrangement {
    /// The arrangement of `engine`. Throws without webs get two, `web_distance` [m] apart.
    ///
    /// # Errors
    /// [`ArrangementError`] where a crankshaft has another speed, a throw drives nothing, or a linkage does not turn.
    pub fn of(engine: &Engine, web_distance: f64) -> Result<Arrangement, ArrangementError> {
        for (index, crankshaft) in engine.crankshafts.iter().enumerate() {
            if sense(crankshaft.ratio).is_none() {
                return Err(ArrangementError::Ratio { crankshaft: index + 1, ratio: crankshaft.ratio });
            }
        }
        let drives = |throw: usize| engine.cylinders.iter().any(|cylinder| cylinder.throw == throw);
        if let Some(throw) = (0..engine.throws.len()).find(|throw| !drives(*throw)) {
            return Err(ArrangementError::IdleThrow { throw: throw + 1 });
        }
        let crankshafts = engine.crankshafts.iter().enumerate().map(|(index, crankshaft)| Crankshaft {
            mains: Some(engine.main_planes(index)),
            ..crankshaft.clone()
        });
        let webs = |throw: &Throw| [-0.5, 0.5].map(|side| throw.z + side * web_distance);
        let throws = engine
            .throws
            .iter()
            .map(|throw| Throw { webs: throw.webs.or_else(|| Some(webs(throw))), ..throw.clone() });
        let cylinders =
            engine.cylinders.iter().map(|cylinder| Cylinder { firing_angle: None, ..cylinder.clone() });
        let mut arrangement = Arrangement {
            name: engine.name.clone(),
            crankshafts: crankshafts.collect(),
            throws: throws.collect(),
            cylinders: cylinders.collect(),
            group_of_throw: groups(engine),
            top_dead_centres: Vec::new(),
            throw_angles: Vec::new(),
        };
        let leads: Vec<f64> =
            (0..arrangement.groups()).map(|group| arrangement.lead(arrangement.first_throw(group))).collect();
        arrangement.throws = arrangement.turned_throws(&leads.iter().map(|lead| -lead).collect::<Vec<_>>());
        let turned = engine.with(|parts| parts.throws.clone_from(&arrangement.throws));
        let turned = turned.expect("invariant: other throw angles leave an engine what it is");
        let motion = motion(&turned, &LoadRequest { samples: 1, ..LoadRequest::default() })?;
        arrangement.top_dead_centres = arrangement
            .chambers()
            .iter()
            .map(|&first| match &motion[first].chamber {
                Some(chamber) => chamber.top_dead_centre,
                None => motion[first].top_dead_centre,
            })
            .collect();
        arrangement.throw_angles =
            leads.iter().map(|lead| within_period(lead - leads[0], TAU, SAME)).collect();
        Ok(arrangement)
    }

    /// Groups: throws whose angles are free of each other.
    pub fn groups(&self) -> usize {
        self.group_of_throw.iter().map(|group| group + 1).max().unwrap_or(0)
    }

    /// First piston of each chamber: what fires once a cycle.
    pub fn chambers(&self) -> Vec<usize> {
        (0..self.cylinders.len()).filter(|&index| self.cylinders[index].chamber.is_none()).collect()
    }

    /// Group of a cylinder.
    pub fn group_of(&self, cylinder: usize) -> usize {
        self.group_of_throw[self.cylinders[cylinder].throw]
    }

    /// Pairs of cylinders that stand side by side in one bank, chambers by their first pistons.
    pub fn neighbours(&self) -> Vec<[usize; 2]> {
        let in_one_bank = |a: &Cylinder, b: &Cylinder| {
            let crankshaft = |c: &Cylinder| self.throws[c.throw].crankshaft;
            crankshaft(a) == crankshaft(b) && about_zero(a.angle - b.angle, TAU).abs() < SAME
        };
        let chambers = self.chambers();
        let next = |&a: &usize| {
            let own = &self.cylinders[a];
            let behind = chambers.iter().copied().filter(|&b| {
                let other = &self.cylinders[b];
                in_one_bank(own, other) && other.z > own.z
            });
            let next = behind.min_by(|&b, &c| self.cylinders[b].z.total_cmp(&self.cylinders[c].z));
            next.map(|b| [a, b])
        };
        chambers.iter().filter_map(next).collect()
    }

    /// Distance of the outermost cylinder axes along the crank [m].
    pub fn length(&self) -> f64 {
        let planes = self.cylinders.iter().map(|cylinder| cylinder.z);
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = planes.fold(ends, |(low, high), z| (low.min(z), high.max(z)));
        high - low
    }

    /// Largest sum of crank radius and rod length [m].
    pub fn height(&self) -> f64 {
        let heights = self.cylinders.iter().map(|c| c.rod.length + self.throws[c.throw].radius);
        heights.fold(0.0, f64::max)
    }

    /// First throw of a group.
    pub(crate) fn first_throw(&self, group: usize) -> usize {
        self.group_of_throw.iter().position(|own| *own == group).expect("invariant: groups have throws")
    }

    /// Sense of a crankshaft: 1 with crankshaft 1, -1 against it.
    pub(crate) fn sense(&self, crankshaft: usize) -> f64 {
        sense(self.crankshafts[crankshaft].ratio).expect("invariant: ratios of an arrangement are 1 or -1")
    }

    /// Lead of a throw [rad].
    pub(crate) fn lead(&self, throw: usize) -> f64 {
        let throw = &self.throws[throw];
        self.sense(throw.crankshaft) * (self.crankshafts[throw.crankshaft].phase + throw.angle)
    }

    /// The throws with each group ahead by so much [rad].
    pub(crate) fn turned_throws(&self, leads: &[f64]) -> Vec<Throw> {
        let turned = |(throw, group): (&Throw, &usize)| Throw {
            angle: throw.angle + self.sense(throw.crankshaft) * leads[*group],
            ..throw.clone()
        };
        self.throws.iter().zip(&self.group_of_throw).map(turned).collect()
    }
}

/// Group of each throw: throws whose pistons share a chamber are one.
fn groups(engine: &Engine) -> Vec<usize> {
    let mut first: Vec<usize> = (0..engine.throws.len()).collect();
    for cylinder in &engine.cylinders {
        let Some(other) = cylinder.chamber else { continue };
        let (a, b) = (first[cylinder.throw], first[engine.cylinders[other].throw]);
        for own in &mut first {
            if *own == a.max(b) {
                *own = a.min(b);
            }
        }
    }
    let mut firsts = first.clone();
    firsts.sort_unstable();
    firsts.dedup();
    first.iter().map(|own| firsts.partition_point(|other| other < own)).collect()
}
