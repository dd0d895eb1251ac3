//! Views from which a layout is the same engine: from the other end, in a mirror, turned by half a turn.
//!
//! ```text
//! ends    z -> -z          groups from the other end; bank 2 stands before bank 1 where it stood behind
//! mirror  at the plane between the banks (in line: of the cylinders), sense of rotation reversed with it so that the crank
//!         still turns from +x to +y: throw angles negated, banks exchanged, time reversed
//! half    a flat engine turned by half a turn: banks exchanged, the split angle negated
//! ```
//! Each view changes throw 1, so that angles are counted anew from the one that is first now, and firing from the cylinder
//! that is number 1 now. All magnitudes of force, couple, moment, torque and firing are the same from every view. The views
//! form a group of 4 elements, 8 for flat engines; an orbit may leave the space where its lists are not symmetric themselves. The
//! case of lowest number stands for all that lie in the space.

use crate::explore::shaft_set::{Removes, ShaftDesign, ShaftSet};
use crate::explore::space::{Banks, Space, same_angle};
use num_complex::Complex64;
use std::f64::consts::PI;

/// Planes and axes closer than this [m] are one.
pub(crate) const SAME_PLACE: f64 = 1e-9;

/// A view from another side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct View {
    /// From the other end.
    pub ends: bool,
    /// In a mirror.
    pub mirror: bool,
    /// Turned by half a turn: flat engines only.
    pub half: bool,
}

impl View {
    /// All views but the plain one.
    pub const OTHERS: [View; 7] = {
        let mut views = [View { ends: false, mirror: false, half: false }; 7];
        let mut code = 1;
        while code < 8 {
            views[code - 1] = View { ends: code & 1 != 0, mirror: code & 2 != 0, half: code & 4 != 0 };
            code += 1;
        }
        views
    };

    /// Whether the banks change places.
    pub fn exchanges_banks(self) -> bool {
        self.mirror != self.half
    }

    /// Digits of the sizes (in the order of [`crate::explore::Choice`], up to the shafts) as this view has them; `None`
    /// where the space has no such sizes.
    pub fn sizes(self, space: &Space, digits: &[usize; 7]) -> Option<[usize; 7]> {
        let mut seen = *digits;
        let mut bank_angle = None;
        if let Banks::Two { bank_angles, split_angles, staggers } = &space.banks {
            let angle = bank_angles[digits[1]];
            bank_angle = Some(angle);
            if self.half {
                if !same_angle(angle, PI) {
                    return None;
                }
                let split = -split_angles[digits[2]];
                seen[2] = split_angles.iter().position(|other| same_angle(*other, split))?;
            }
            let reversals = u8::from(self.ends) + u8::from(self.mirror) + u8::from(self.half);
            if reversals % 2 == 1 {
                let stagger = -staggers[digits[3]];
                seen[3] = staggers.iter().position(|other| (other - stagger).abs() < SAME_PLACE)?;
            }
        } else if self.half {
            return None;
        }
        seen[5] = self.pattern(space, digits[5])?;
        seen[6] = self.shafts(space, digits[6], bank_angle)?;
        Some(seen)
    }

    /// The pattern of web weights as this view has it.
    fn pattern(self, space: &Space, index: usize) -> Option<usize> {
        let own = &space.counterweights[index];
        let Some(webs) = own.webs.as_ref().filter(|_| self.ends) else { return Some(index) };
        let reversed: Vec<bool> = webs.iter().rev().copied().collect();
        if reversed == *webs {
            return Some(index);
        }
        space.counterweights.iter().position(|other| {
            let shares = (other.rotating, other.reciprocating) == (own.rotating, own.reciprocating);
            shares && other.webs.as_ref() == Some(&reversed)
        })
    }

    /// The shafts as this view has them.
    fn shafts(self, space: &Space, index: usize, bank_angle: Option<f64>) -> Option<usize> {
        // Beyond the widest V the x axis is that of bank 1, and the mirror stands half a bank angle from it.
        let wide = bank_angle.filter(|angle| angle.to_degrees() > 170.0);
        let turn = |x: f64, y: f64| {
            let mut place = Complex64::new(x, y);
            if self.mirror {
                place = wide.map_or(Complex64::ONE, Complex64::cis) * place.conj();
            }
            if self.half {
                place = -place;
            }
            (place.re, place.im)
        };
        seen_shafts(&space.shafts, index, self.ends, turn)
    }

    /// Which group and which cylinder stands, from here, where each stood.
    pub fn renumbering(self, groups: usize, banks: usize) -> Renumbering {
        Renumbering {
            mirror: self.mirror,
            groups: (0..groups).map(|group| if self.ends { groups - 1 - group } else { group }).collect(),
            cylinders: (0..groups * banks).map(|index| self.cylinder(index, groups, banks)).collect(),
        }
    }

    /// The cylinder that stands, from here, where cylinder `index` stood.
    fn cylinder(self, index: usize, groups: usize, banks: usize) -> usize {
        let (bank, group) = (index / groups, index % groups);
        let group = if self.ends { groups - 1 - group } else { group };
        let bank = if banks == 2 && self.exchanges_banks() { 1 - bank } else { bank };
        bank * groups + group
    }
}

/// How a view numbers groups and cylinders.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Renumbering {
    /// In a mirror: throw angles negated, time reversed.
    pub mirror: bool,
    /// The group that stands, from there, where each group stood.
    pub groups: Vec<usize>,
    /// The cylinder (or chamber) that stands, from there, where each stood.
    pub cylinders: Vec<usize>,
}

impl Renumbering {
    /// Throw angles as the view has them, as places in the list of angles: `difference` is the place of the difference
    /// of two, with place 0 for angle 0. `false` where an angle is not in the list.
    #[inline]
    pub fn throws(&self, throws: &[u16], difference: &DifferenceTable, seen: &mut [u16]) -> bool {
        let first = throws[self.groups[0]];
        for (own, &from) in seen.iter_mut().zip(&self.groups) {
            let (a, b) = if self.mirror { (first, throws[from]) } else { (throws[from], first) };
            match difference.of(a, b) {
                Some(place) => *own = place,
                None => return false,
            }
        }
        true
    }
}

/// Place in `sets` of set `index` as a view has it: from the other end or not, each axis moved by `turn`.
pub(crate) fn seen_shafts(
    sets: &[ShaftSet],
    index: usize,
    ends: bool,
    turn: impl Fn(f64, f64) -> (f64, f64),
) -> Option<usize> {
    let seen = sets[index].seen(ends, turn);
    let own = |place: usize| sets[place].seen(false, |x: f64, y: f64| (x, y));
    if alike(&seen, &own(index)) {
        return Some(index);
    }
    (0..sets.len()).find(|&place| alike(&seen, &own(place)))
}

/// Whether two sets are the same shafts, in any order.
fn alike(a: &[ShaftDesign], b: &[ShaftDesign]) -> bool {
    let close = |x: f64, y: f64| (x - y).abs() < SAME_PLACE;
    let both = |x: [f64; 2], y: [f64; 2]| close(x[0], y[0]) && close(x[1], y[1]);
    let same = |a: &ShaftDesign, b: &ShaftDesign| {
        let removes = match (a.removes, b.removes) {
            (Removes::Force { z: x }, Removes::Force { z: y }) => close(x, y),
            (Removes::Couple { z: x }, Removes::Couple { z: y })
            | (Removes::Both { z: x }, Removes::Both { z: y }) => both(x, y),
            _ => false,
        };
        removes && a.order == b.order && a.sense == b.sense && close(a.x, b.x) && close(a.y, b.y)
    };
    let mut left: Vec<&ShaftDesign> = b.iter().collect();
    a.len() == b.len()
        && a.iter().all(|shaft| {
            left.iter().position(|other| same(shaft, other)).map(|place| left.swap_remove(place)).is_some()
        })
}

/// Places of the differences of all angles in their list.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DifferenceTable {
    count: usize,
    places: Vec<u16>,
}

/// An angle that is not in the list.
const NONE: u16 = u16::MAX;

impl DifferenceTable {
    pub fn new(angles: &[f64]) -> DifferenceTable {
        use crate::explore::space::{SAME_ANGLE, centred};
        // Sorted by direction, so that a search takes few steps.
        let mut sorted: Vec<(f64, u16)> = angles.iter().map(|&a| centred(a)).zip(0..).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let find = |angle: f64| {
            let angle = centred(angle);
            let near = sorted.partition_point(|entry| entry.0 < angle - SAME_ANGLE) % sorted.len();
            let hit = [near, 0].into_iter().map(|k| sorted[k]).find(|entry| same_angle(entry.0, angle));
            hit.map_or(NONE, |entry| entry.1)
        };
        let places = angles.iter().flat_map(|a| angles.iter().map(move |b| a - b)).map(find).collect();
        DifferenceTable { count: angles.len(), places }
    }

    /// Place of angle `a` less angle `b`.
    #[inline]
    pub fn of(&self, a: u16, b: u16) -> Option<u16> {
        let place = self.places[a as usize * self.count + b as usize];
        (place != NONE).then_some(place)
    }
}
