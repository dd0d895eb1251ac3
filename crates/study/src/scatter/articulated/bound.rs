//! How far an articulated rod's loads may be off at most.
//!
//! ```text
//! |f(p) - f(p_0)|  <=  SUM over i of |df/dp_i (p_0)| h_i  +  1/2 sup over p and d of |d^2 f (p; d, d)|        |d_i| <= h_i
//! ```
//! (book, eq. 30.11, Taylor's theorem along the straight line from the nominal lengths `p_0` to any others in the box). The first derivatives are
//! those of each order, as exact as the orders themselves. The second ones are enclosed by interval arithmetic, over the whole box of
//! tolerances and over boxes of crank angles that cover a turn: their mean over the turn bounds every order, their largest
//! the peak.

use crate::scatter::articulated::motion::{Dimensions, VARIED};
use crate::scatter::articulated::rod::ArticulatedRod;
use crate::scatter::plain_rod::PlainRod;
use lanchester_numerics::{Interval, Jet, Ring};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Boxes of a turn, and how often one is halved where it proves nothing.
const BOXES: usize = 128;
const HALVED: u32 = 10;

/// Share of its length that a rod must reach along its cylinder, squared: above the rounding of the intervals.
const REACH: f64 = 1e-9;

/// What the rounding of intervals and sums may hide.
const ROUNDING: f64 = 1.0 + 1e-9;

/// What a rod's force is at most off, by mass and square of the crank's speed.
pub(crate) struct ArticulatedBound {
    /// Nominal size of each of the master's harmonics, in one sense [m], and how far it may be off.
    pub harmonics: Vec<[f64; 2]>,
    /// Nominal peak over the crank angle [m], and how far the force may be off at any angle.
    pub peak: [f64; 2],
}

/// A turn in boxes of crank angles, on each of which the rod reaches its piston pin everywhere within the tolerances.
#[derive(Default)]
pub(crate) struct TurnBoxes {
    boxes: Vec<Interval>,
    /// Its reach along the cylinder over its length is nowhere less than this.
    pub least_reach: f64,
}

/// The turn of a rod in boxes; `None`: it is not known to reach everywhere.
pub(crate) fn turn_boxes(rod: &ArticulatedRod, master: &PlainRod) -> Option<TurnBoxes> {
    let whole = dimensions(rod, master, |nominal, half| Interval::new(nominal - half, nominal + half));
    let square = whole.length.low.powi(2);
    if whole.length.low <= 0.0 {
        return None;
    }
    let mut found = TurnBoxes { boxes: Vec::new(), least_reach: 1.0 };
    let mut open: Vec<(Interval, u32)> = (0..BOXES)
        .map(|k| {
            let at = |k: usize| TAU * k as f64 / BOXES as f64;
            (Interval::new(at(k), at(k + 1)), HALVED)
        })
        .collect();
    while let Some((angles, left)) = open.pop() {
        let least = whole.reach_square(&rod.pin, angles).low / square;
        if least > REACH {
            found.boxes.push(angles);
            found.least_reach = found.least_reach.min(least.sqrt());
        } else if left == 0 {
            return None;
        } else {
            let middle = 0.5 * (angles.low + angles.high);
            open.push((Interval::new(angles.low, middle), left - 1));
            open.push((Interval::new(middle, angles.high), left - 1));
        }
    }
    Some(found)
}

/// Dimensions from each nominal value and how far it may be off.
fn dimensions<T: Copy>(rod: &ArticulatedRod, master: &PlainRod, of: impl Fn(f64, f64) -> T) -> Dimensions<T> {
    Dimensions::from_array(rod.dimensions(master).map(|[nominal, half]| of(nominal, half)))
}

impl ArticulatedBound {
    /// Of a rod that was found to turn everywhere within the tolerances; `angles`: of the sums for sizes and first derivatives.
    pub fn of(rod: &ArticulatedRod, master: &PlainRod, angles: usize) -> ArticulatedBound {
        type Line = Jet<Interval, 1>;
        let throw_off = master.throw.half + master.parts.axis.half;
        // Along all lines at once: each dimension changes by any number within its tolerance.
        let nominal = dimensions(rod, master, |nominal, _| Line::of(nominal));
        let from_nominal = dimensions(rod, master, |nominal, half| Line {
            value: Interval::of(nominal),
            by: [Interval::new(-half, half)],
        });
        let anywhere = dimensions(rod, master, |nominal, half| {
            let by = Interval::new(-half, half);
            let value = Line { value: Interval::new(nominal - half, nominal + half), by: [by] };
            Jet { value, by: [Line { value: by, by: [Interval::of(0.0)] }] }
        });
        let size = |range: Interval| range.sizes()[1];
        let (mut mean, mut most, mut peak, mut rate) = (0.0, 0.0f64, 0.0f64, 0.0f64);
        for turn in turn_boxes(rod, master).unwrap_or_default().boxes {
            let fixed = Line { value: turn, by: [Interval::of(0.0)] };
            let second = anywhere.force(&rod.pin, Jet { value: fixed, by: [Line::of(0.0)] });
            let second = 0.5 * size(second.by[0].by[0]);
            mean += second * (turn.high - turn.low) / TAU;
            most = most.max(size(from_nominal.force(&rod.pin, fixed).by[0]) + second);
            let turning = nominal.force(&rod.pin, Jet::variable(turn, 0));
            peak = peak.max(size(turning.value));
            rate = rate.max(size(turning.by[0]));
        }
        let harmonics = first_derivatives(rod, master, angles)
            .into_iter()
            .map(|([size, off], number)| {
                [size * ROUNDING, (off + mean + f64::from(number) * size * throw_off) * ROUNDING]
            })
            .collect();
        ArticulatedBound { harmonics, peak: [peak * ROUNDING, (most + rate * throw_off) * ROUNDING] }
    }
}

/// Size of each of the master's harmonics [m], how far the first derivatives by all dimensions let it be off, and its number.
fn first_derivatives(rod: &ArticulatedRod, master: &PlainRod, angles: usize) -> Vec<([f64; 2], u32)> {
    let all = rod.dimensions(master);
    let jets: [Jet<f64, VARIED>; VARIED] = std::array::from_fn(|k| Jet::variable(all[k][0], k));
    let dimensions = Dimensions::from_array(jets);
    let at = |j: usize| TAU * j as f64 / angles as f64;
    let forces: Vec<Jet<f64, VARIED>> =
        (0..angles).map(|j| dimensions.force(&rod.pin, Jet::of(at(j)))).collect();
    let of = |number: u32| {
        let mut sums = [Complex64::ZERO; VARIED + 1];
        for (j, force) in forces.iter().enumerate() {
            let turn = Complex64::cis(-at(number as usize * j % angles)) / angles as f64;
            sums[VARIED] += force.value * turn;
            for k in 0..VARIED {
                sums[k] += force.by[k] * turn;
            }
        }
        let off = (0..VARIED).map(|k| sums[k].norm() * all[k][1]).sum();
        [sums[VARIED].norm(), off]
    };
    master.harmonics.iter().map(|harmonic| (of(harmonic.number), harmonic.number)).collect()
}
