//! Cylinders whose rods sit on the knuckle pins of a master rod, eight samples at a time.
//!
//! ```text
//! piston:    1/2 m r W^2 a_n  times  e^{i (n phi + b)} forward, its mirror e^{i (-n phi + b)} with conj(a_n) backward
//!            a_n = (e^{i tau} - i k'') [n = 1] + k' (c_n - [n = 1]) + (2 n^2 / r) U_n        k' + i k'' = k e^{i tau}
//! big end:   m r W^2 (1/2 k c_n + (1 - k) [n = 1])  times  e^{i (n phi + b_m)} forward,
//!            1/2 m r W^2 k conj(c_n)                times  e^{i (-n phi + b_m)} backward
//! ```
//! (book, eq. 30.8 and 30.9). `c_n` are the master's coefficients, `k = (g / l_m) e^{i psi}`, and `U_n` the orders of the rod's reach
//! along its cylinder, from [`crate::scatter::articulated::quadrature`]; other symbols as in [`crate::scatter::articulated::motion`].

use crate::scatter::articulated::bound::{ArticulatedBound, turn_boxes};
use crate::scatter::articulated::motion::KnucklePin;
use crate::scatter::articulated::quadrature::{LaneDimensions, MasterRoots, Quadrature};
use crate::scatter::articulated::rod::ArticulatedRod;
use crate::scatter::error::ScatterError;
use crate::scatter::moving_parts::MovingParts;
use crate::scatter::plain_rod::PlainRod;
use crate::scatter::spectrum::{HIGHEST, NOTHING, Spectrum};
use crate::scatter::value::Deviations;
use lanchester_model::{Engine, RodJoint};
use lanchester_numerics::{ComplexLanes, LANES, Lanes};
use num_complex::Complex64;

/// Fewest angles of a quadrature.
const FEWEST: usize = 16;

/// Most angles of a quadrature: reached only where a rod nearly loses its knuckle pin.
const MOST: usize = 2048;

/// Fewest angles of the sums for the worst case.
const FEWEST_OF_BOUND: usize = 256;

/// Rounding of a reach over the rod's length, as far as it is not short: error of an order that is let stand.
const EXACT: f64 = 1e-16;

/// Angles by which the harmonics are found that matter.
const LOOKED: usize = 256;

/// The articulated rods of one master.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ArticulatedRods {
    /// Place of the master among the plain rods.
    pub master: usize,
    pub rods: Vec<ArticulatedRod>,
    quadrature: Quadrature,
}

/// The articulated rods of the master in cylinder `index`, which is at `place` among the plain rods; their orders are still open.
///
/// # Errors
/// [`ScatterError::Impossible`] where one is no cylinder everywhere within the tolerances.
pub(crate) fn articulated_rods(
    engine: &Engine,
    index: usize,
    place: usize,
    master: &PlainRod,
    all: Deviations<'_>,
) -> Result<Option<ArticulatedRods>, ScatterError> {
    let mut rods = Vec::new();
    for (own, cylinder) in engine.cylinders.iter().enumerate() {
        let RodJoint::Articulated { master: driver, knuckle_radius, knuckle_angle } = cylinder.rod.joint
        else {
            continue;
        };
        if driver != index {
            continue;
        }
        let pin = KnucklePin { radius: knuckle_radius, angle: knuckle_angle };
        let mut rod = ArticulatedRod { parts: MovingParts::of(engine, own, all), pin, least_reach: 1.0 };
        let Some(turn) = turn_boxes(&rod, master) else {
            let reason = "its crank could not turn";
            return Err(ScatterError::Impossible { cylinder: own + 1, reason });
        };
        rod.least_reach = turn.least_reach;
        rod.parts.check_masses(own + 1)?;
        rods.push(rod);
    }
    let quadrature = Quadrature::new(FEWEST, &[]);
    Ok((!rods.is_empty()).then_some(ArticulatedRods { master: place, rods, quadrature }))
}

impl ArticulatedRod {
    /// Adds force and couple of eight samples, from the motion of its master.
    fn add_to(
        &self,
        master: &MasterMotion<'_>,
        reach: &[ComplexLanes],
        deviations: &[Lanes],
        out: &mut Spectrum,
    ) {
        let MasterMotion { rod, radius, inverse_radius, axis: master_axis, .. } = master;
        let own = self.dimensions_of(master, deviations);
        let plane = self.parts.plane.at(deviations);
        let axis = self.parts.axis.direction(deviations);
        let masses = self.parts.masses(deviations);
        let square = rod.crank.square;
        let half = Lanes::each(|i| 0.5 * masses.reciprocating[i] * radius[i] * square);
        let big = Lanes::each(|i| masses.big_end[i] * radius[i] * square);
        let knuckle = self.knuckle(master);
        let forward = rod.crank.sense;
        for (place, harmonic) in rod.harmonics.iter().enumerate() {
            let (c, turned, reach) = (&master.coefficients[place], &master.turned[place], &reach[place]);
            let first = if harmonic.number == 1 { 1.0 } else { 0.0 };
            let a = ComplexLanes {
                re: Lanes::each(|i| {
                    first * own.turn.re[i]
                        + own.arm.re[i] * (c.re[i] - first)
                        + reach.re[i] * inverse_radius[i]
                }),
                im: Lanes::each(|i| {
                    first * (own.turn.im[i] - own.arm.im[i])
                        + own.arm.re[i] * c.im[i]
                        + reach.im[i] * inverse_radius[i]
                }),
            };
            let along = scaled(&turned.times::<false>(a), &half);
            out.add(harmonic.place, forward, &axis.times::<false>(along), &plane);
            out.add(harmonic.place, 1 - forward, &axis.times_conj::<false>(along), &plane);
            // Both ways what the master's piston takes the knuckle pin along, forward what the crankpin does.
            let piston = turned.times::<false>(*c);
            let arm = knuckle.times::<false>(*master_axis);
            let piston = scaled(&piston, &Lanes::each(|i| 0.5 * big[i]));
            let mut along = arm.times::<false>(piston);
            if harmonic.number == 1 {
                let pin = ComplexLanes {
                    re: Lanes::each(|i| 1.0 - knuckle.re[i]),
                    im: Lanes::each(|i| -knuckle.im[i]),
                };
                let pin = scaled(&master.throw.times::<false>(pin), &big);
                along = ComplexLanes { re: along.re + pin.re, im: along.im + pin.im };
            }
            out.add(harmonic.place, forward, &along, &plane);
            out.add(harmonic.place, 1 - forward, &arm.times_conj::<false>(piston), &plane);
        }
    }

    /// `k` of eight samples.
    fn knuckle(&self, master: &MasterMotion<'_>) -> ComplexLanes {
        let (sin, cos) = self.pin.angle.sin_cos();
        let size = Lanes::each(|i| self.pin.radius / master.length[i]);
        ComplexLanes { re: Lanes::each(|i| size[i] * cos), im: Lanes::each(|i| size[i] * sin) }
    }

    /// Dimensions of eight samples.
    fn dimensions_of(&self, master: &MasterMotion<'_>, deviations: &[Lanes]) -> LaneDimensions {
        let turn = master.axis.times_conj::<false>(self.parts.axis.direction(deviations));
        LaneDimensions {
            radius: master.radius,
            master_length: master.length,
            master_offset: master.offset,
            arm: self.knuckle(master).times::<false>(turn),
            turn,
            length: self.parts.length.at(deviations),
            offset: self.parts.offset.at(deviations),
        }
    }
}

#[inline]
fn scaled(vector: &ComplexLanes, by: &Lanes) -> ComplexLanes {
    ComplexLanes { re: vector.re * *by, im: vector.im * *by }
}

/// Motion of a master of eight samples.
struct MasterMotion<'a> {
    rod: &'a PlainRod,
    radius: Lanes,
    inverse_radius: Lanes,
    length: Lanes,
    offset: Lanes,
    throw: ComplexLanes,
    axis: ComplexLanes,
    /// `c_n` by harmonic.
    coefficients: Vec<ComplexLanes>,
    /// `e^{i n phi}` at `theta = 0` by harmonic.
    turned: Vec<ComplexLanes>,
}

impl MasterMotion<'_> {
    fn of<'a>(rod: &'a PlainRod, deviations: &[Lanes]) -> MasterMotion<'a> {
        let (radius, length) = (rod.radius.at(deviations), rod.parts.length.at(deviations));
        let offset = rod.parts.offset.at(deviations);
        let (throw, axis) = (rod.throw.direction(deviations), rod.parts.axis.direction(deviations));
        let step = throw.times_conj::<false>(axis);
        let (mut turned, mut order) = (step, 1);
        let (ratio, beside) =
            (Lanes::each(|i| radius[i] / length[i]), Lanes::each(|i| offset[i] / length[i]));
        let mut all = Vec::with_capacity(rod.harmonics.len());
        for harmonic in &rod.harmonics {
            while order < harmonic.number {
                turned = turned.times::<false>(step);
                order += 1;
            }
            all.push(turned);
        }
        let coefficients =
            (0..rod.harmonics.len()).map(|own| rod.coefficients.at(own, &ratio, &beside)).collect();
        let inverse_radius = radius.map(|r| 1.0 / r);
        MasterMotion { rod, radius, inverse_radius, length, offset, throw, axis, coefficients, turned: all }
    }
}

impl ArticulatedRods {
    /// Marks the harmonics of which some rod's reach has more than nothing, at the corners of its tolerances.
    pub fn mark_harmonics(&self, master: &PlainRod, matters: &mut [bool]) {
        let numbers: Vec<u32> = (1..=HIGHEST).collect();
        let quadrature = Quadrature::new(LOOKED, &numbers);
        let (mut roots, mut orders) = (MasterRoots::new(), Vec::new());
        for corner in self.rods.iter().flat_map(|rod| rod.corners(master)) {
            quadrature.master_roots(&corner.radius, &corner.master_length, &corner.master_offset, &mut roots);
            quadrature.orders(&corner, &roots, &mut orders);
            let largest = |c: &ComplexLanes| {
                (0..LANES).map(|i| c.re[i].hypot(c.im[i]) / corner.radius[i]).fold(0.0, f64::max)
            };
            let mut missing = 0;
            for (&number, c) in numbers.iter().zip(&orders) {
                let is_there = largest(c) > NOTHING;
                matters[number as usize] |= is_there;
                missing = if is_there { 0 } else { missing + 1 };
                // The orders fall from each to the next: what comes after three that are nothing is rounding, times n^2.
                if missing == 3 {
                    break;
                }
            }
        }
    }

    /// Chooses the angles for the master's harmonics: so many that at no corner of the tolerances an order is off by a rounding.
    pub fn set_angles(&mut self, master: &PlainRod) {
        let numbers: Vec<u32> = master.harmonics.iter().map(|harmonic| harmonic.number).collect();
        let highest = numbers.iter().copied().max().unwrap_or(1) as usize;
        // Near locking the reach is the root of a small difference, and its rounding the larger.
        let corners: Vec<(LaneDimensions, f64)> = self
            .rods
            .iter()
            .flat_map(|rod| rod.corners(master).into_iter().map(|corner| (corner, EXACT / rod.least_reach)))
            .collect();
        let mut count = FEWEST.max((highest + 1).next_multiple_of(4));
        loop {
            self.quadrature = Quadrature::new(count, &numbers);
            let finer = Quadrature::new(2 * count, &numbers);
            if count >= MOST
                || corners
                    .iter()
                    .all(|(corner, exact)| agree(corner, *exact, &self.quadrature, &finer, &numbers))
            {
                return;
            }
            count = (count + count / 4).next_multiple_of(4);
        }
    }

    /// Adds force and couple of eight samples.
    pub fn add_to(&self, master: &PlainRod, deviations: &[Lanes], out: &mut Spectrum) {
        let motion = MasterMotion::of(master, deviations);
        let (mut roots, mut reach) = (MasterRoots::new(), Vec::new());
        self.quadrature.master_roots(&motion.radius, &motion.length, &motion.offset, &mut roots);
        for rod in &self.rods {
            let own = rod.dimensions_of(&motion, deviations);
            self.quadrature.orders(&own, &roots, &mut reach);
            rod.add_to(&motion, &reach, deviations, out);
        }
    }

    /// How far the loads of each rod may be off.
    pub fn bounds<'a>(
        &'a self,
        master: &'a PlainRod,
    ) -> impl Iterator<Item = (&'a ArticulatedRod, ArticulatedBound)> {
        // Derivatives have slower orders than the reach itself.
        let angles = (4 * self.quadrature.count).max(FEWEST_OF_BOUND);
        self.rods.iter().map(move |rod| (rod, ArticulatedBound::of(rod, master, angles)))
    }
}

/// Whether two quadratures give the same orders of the reach, to `exact` of the rod's length.
fn agree(rod: &LaneDimensions, exact: f64, one: &Quadrature, other: &Quadrature, numbers: &[u32]) -> bool {
    let orders = |quadrature: &Quadrature| {
        let (mut roots, mut orders) = (MasterRoots::new(), Vec::new());
        quadrature.master_roots(&rod.radius, &rod.master_length, &rod.master_offset, &mut roots);
        quadrature.orders(rod, &roots, &mut orders);
        orders
    };
    let pairs = orders(one).into_iter().zip(orders(other));
    numbers.iter().zip(pairs).all(|(&number, (a, b))| {
        let weight = 2.0 * f64::from(number).powi(2);
        (0..LANES).all(|i| {
            let off = Complex64::new(a.re[i] - b.re[i], a.im[i] - b.im[i]).norm();
            off <= exact * weight * rod.length[i]
        })
    })
}
