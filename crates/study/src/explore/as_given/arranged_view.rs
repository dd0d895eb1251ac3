//! Views from which an arrangement is the same arrangement: from the other end, in a mirror, turned about the crank.
//!
//! ```text
//! ends    z -> -z
//! mirror  at a plane through the crank axis, sense of rotation reversed with it: leads negated, time reversed
//! turn    about the crank axis: a radial engine by the angle between two cylinders
//! ```
//! A view counts where every cylinder stands, from there, where an equal one stood, on an equal throw; every main bearing and
//! every web alike. Geared crankshafts are looked at from the other end alone.

use crate::explore::as_given::arrangement::Arrangement;
use crate::explore::counterweight_pattern::CounterweightPattern;
use crate::explore::symmetry::{Renumbering, SAME_PLACE};
use lanchester_model::{Cylinder, RodJoint, Throw};
use lanchester_numerics::about_zero;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Angles closer than this [rad] are one.
const SAME_ANGLE: f64 = 1e-9;

/// A view from which an arrangement is the same.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArrangedView {
    /// From the other end.
    pub ends: bool,
    /// `e^{i turn}`.
    turn: Complex64,
    /// Which group and which chamber stands where.
    pub renumbering: Renumbering,
    /// The web that stands, from here, where a web stood.
    webs: Vec<usize>,
}

/// The motion of a view.
#[derive(Debug, Clone, Copy)]
struct Motion {
    ends: bool,
    mirror: bool,
    turn: f64,
}

impl Motion {
    fn plane(self, z: f64) -> f64 {
        if self.ends { -z } else { z }
    }

    /// An angle or an offset that a mirror negates.
    fn handed(self, value: f64) -> f64 {
        if self.mirror { -value } else { value }
    }
}

fn same_angle(a: f64, b: f64) -> bool {
    about_zero(a - b, TAU).abs() < SAME_ANGLE
}

fn same_place(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME_PLACE
}

fn same_mass(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

impl ArrangedView {
    /// All views of an arrangement but the plain one.
    pub fn all(arrangement: &Arrangement) -> Vec<ArrangedView> {
        let one = arrangement.crankshafts.len() == 1;
        let first = arrangement.cylinders[0].angle;
        let mut views = Vec::new();
        for (ends, mirror) in [(false, false), (true, false), (false, true), (true, true)] {
            if mirror && !one {
                continue;
            }
            let mut turns: Vec<f64> = Vec::new();
            for cylinder in &arrangement.cylinders {
                let turn = about_zero(cylinder.angle - if mirror { -first } else { first }, TAU);
                let is_new = !turns.iter().any(|other| same_angle(*other, turn));
                if is_new && (one || same_angle(turn, 0.0)) {
                    turns.push(turn);
                }
            }
            let plain = |turn: f64| !ends && !mirror && same_angle(turn, 0.0);
            let motions =
                turns.into_iter().filter(|turn| !plain(*turn)).map(|turn| Motion { ends, mirror, turn });
            views.extend(motions.filter_map(|motion| ArrangedView::of(arrangement, motion)));
        }
        views
    }

    /// Where a point stands from here [m].
    pub fn place(&self, x: f64, y: f64) -> (f64, f64) {
        let place = Complex64::new(x, y);
        let place = self.turn * if self.renumbering.mirror { place.conj() } else { place };
        (place.re, place.im)
    }

    /// Place in `patterns` of pattern `index` as this view has it.
    pub fn pattern(&self, patterns: &[CounterweightPattern], index: usize) -> Option<usize> {
        let own = &patterns[index];
        let Some(webs) = own.webs.as_ref() else { return Some(index) };
        let seen: Vec<bool> = self.webs.iter().map(|&from| webs[from]).collect();
        if seen == *webs {
            return Some(index);
        }
        patterns.iter().position(|other| {
            let shares = (other.rotating, other.reciprocating) == (own.rotating, own.reciprocating);
            shares && other.webs.as_ref() == Some(&seen)
        })
    }

    /// The view of a motion; `None` where the arrangement is another one from there.
    fn of(arrangement: &Arrangement, motion: Motion) -> Option<ArrangedView> {
        let cylinders = &arrangement.cylinders;
        // Where each cylinder stands from there.
        let mut image = vec![usize::MAX; cylinders.len()];
        for (index, cylinder) in cylinders.iter().enumerate() {
            let stands = (0..cylinders.len()).find(|other| {
                !image.contains(other) && is_place_of(arrangement, motion, cylinder, &cylinders[*other])
            });
            image[index] = stands?;
        }
        let mut throw_image = vec![usize::MAX; arrangement.throws.len()];
        for (cylinder, &stands) in cylinders.iter().zip(&image) {
            let throw = &mut throw_image[cylinder.throw];
            if *throw != usize::MAX && *throw != cylinders[stands].throw {
                return None;
            }
            *throw = cylinders[stands].throw;
        }
        let mut group_image = vec![usize::MAX; arrangement.groups()];
        for (index, &stands) in throw_image.iter().enumerate() {
            let (own, other) = (arrangement.group_of_throw[index], arrangement.group_of_throw[stands]);
            let is_first = arrangement.first_throw(own) == index;
            if is_first != (arrangement.first_throw(other) == stands)
                || (group_image[own] != usize::MAX && group_image[own] != other)
                || !is_same_throw(arrangement, motion, index, stands)
            {
                return None;
            }
            group_image[own] = other;
        }
        let linked = cylinders.iter().zip(&image).all(|(cylinder, &stands)| {
            let other = &cylinders[stands];
            let joint = match (cylinder.rod.joint, other.rod.joint) {
                (
                    RodJoint::Articulated { master, knuckle_radius, knuckle_angle },
                    RodJoint::Articulated { master: other, knuckle_radius: radius, knuckle_angle: angle },
                ) => {
                    image[master] == other
                        && same_place(knuckle_radius, radius)
                        && same_angle(motion.handed(knuckle_angle), angle)
                }
                (own, other) => own == other,
            };
            joint && cylinder.chamber.map(|first| image[first]) == other.chamber
        });
        if !linked || !has_same_mains(arrangement, motion) {
            return None;
        }
        let chambers = arrangement.chambers();
        let chamber_from = chambers.iter().map(|&stood| {
            let own = image.iter().position(|stands| *stands == stood)?;
            chambers.iter().position(|chamber| *chamber == own)
        });
        let group_from = (0..group_image.len()).map(|stood| group_image.iter().position(|&g| g == stood));
        let web_from = (0..2 * throw_image.len()).map(|web| {
            let throw = throw_image.iter().position(|stands| *stands == web / 2)?;
            Some(2 * throw + if motion.ends { 1 - web % 2 } else { web % 2 })
        });
        Some(ArrangedView {
            ends: motion.ends,
            turn: Complex64::cis(motion.turn),
            renumbering: Renumbering {
                mirror: motion.mirror,
                groups: group_from.collect::<Option<_>>()?,
                cylinders: chamber_from.collect::<Option<_>>()?,
            },
            webs: web_from.collect::<Option<_>>()?,
        })
    }
}

/// Whether `cylinder` stands, from there, where `other` stood, and is equal to it.
fn is_place_of(arrangement: &Arrangement, motion: Motion, cylinder: &Cylinder, other: &Cylinder) -> bool {
    let crankshaft = |cylinder: &Cylinder| arrangement.throws[cylinder.throw].crankshaft;
    let (own, its) = (&cylinder.rod, &other.rod);
    let inertia = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => same_mass(a, b),
        (a, b) => a == b,
    };
    crankshaft(cylinder) == crankshaft(other)
        && same_angle(motion.handed(cylinder.angle) + motion.turn, other.angle)
        && same_place(motion.plane(cylinder.z), other.z)
        && same_place(motion.handed(cylinder.offset), other.offset)
        && same_place(motion.handed(cylinder.pin_offset), other.pin_offset)
        && cylinder.bore == other.bore
        && same_mass(cylinder.piston_mass, other.piston_mass)
        && same_place(own.length, its.length)
        && same_mass(own.big_end_mass, its.big_end_mass)
        && same_mass(own.small_end_mass, its.small_end_mass)
        && inertia(own.inertia, its.inertia)
        && std::mem::discriminant(&own.joint) == std::mem::discriminant(&its.joint)
}

/// Whether throw `index` stands, from there, where throw `stands` stood, and is equal to it.
fn is_same_throw(arrangement: &Arrangement, motion: Motion, index: usize, stands: usize) -> bool {
    let (own, other): (&Throw, &Throw) = (&arrangement.throws[index], &arrangement.throws[stands]);
    let webs = match (own.webs, other.webs) {
        (Some([front, rear]), Some(webs)) => {
            let seen = if motion.ends { [-rear, -front] } else { [front, rear] };
            (0..2).all(|side| same_place(seen[side], webs[side]))
        }
        (own, other) => own.is_none() && other.is_none(),
    };
    webs && same_place(motion.plane(own.z), other.z)
        && same_place(motion.plane(own.unbalance_offset), other.unbalance_offset)
        && same_place(own.radius, other.radius)
        && same_mass(own.unbalance, other.unbalance)
        // Within its group; the first of each stands at 0.
        && same_angle(motion.handed(arrangement.lead(index)), arrangement.lead(stands))
}

fn has_same_mains(arrangement: &Arrangement, motion: Motion) -> bool {
    arrangement.crankshafts.iter().all(|crankshaft| {
        let own = crankshaft.mains.iter().flatten();
        let mut seen: Vec<f64> = own.clone().map(|&z| motion.plane(z)).collect();
        seen.sort_by(f64::total_cmp);
        own.zip(seen).all(|(a, b)| same_place(*a, b))
    })
}
