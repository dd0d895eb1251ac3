//! A cylinder whose rod sits on the crankpin.
//!
//! ```text
//! piston:  1/2 m r W^2 c_n(r/l, e/l)  times  e^{i (n phi + b)} forward, its mirror e^{i (-n phi + b)} with conj(c_n) backward
//! big end: m r W^2 e^{i angle}
//! ```
//! (book, eq. 4.3 and 4.4); W is the speed of its crankshaft.

use crate::scatter::coefficients::{CoefficientRange, Span};
use crate::scatter::crank_speed::{CrankSpeed, Harmonic};
use crate::scatter::error::ScatterError;
use crate::scatter::moving_parts::MovingParts;
use crate::scatter::spectrum::{NOTHING, Spectrum};
use crate::scatter::value::{Deviations, Value};
use lanchester_mechanism::exact_coefficients;
use lanchester_model::Engine;
use lanchester_numerics::{ComplexLanes, Lanes};
use lanchester_task::Varied;

/// A cylinder whose rod sits on the crankpin.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlainRod {
    pub parts: MovingParts,
    pub radius: Value,
    /// Direction of the throw.
    pub throw: Value,
    pub crank: CrankSpeed,
    /// Its orders among those of the engine, and the coefficients of each.
    pub harmonics: Vec<Harmonic>,
    pub coefficients: CoefficientRange,
}

impl PlainRod {
    /// Cylinder `index` of an engine, its orders still open.
    ///
    /// # Errors
    /// [`ScatterError::Impossible`] where it is no cylinder everywhere within the tolerances.
    pub fn of(
        engine: &Engine,
        index: usize,
        all: Deviations<'_>,
        crank: CrankSpeed,
    ) -> Result<PlainRod, ScatterError> {
        let throw = engine.cylinders[index].throw;
        let parts = MovingParts::of(engine, index, all);
        let radius = all.value(Varied::CrankRadius, throw, engine.throws[throw].radius);
        let reach = radius.largest() + parts.offset.largest();
        if !(parts.length.span()[0] > reach && radius.span()[0] > 0.0) {
            let reason = "its crank could not turn";
            return Err(ScatterError::Impossible { cylinder: index + 1, reason });
        }
        parts.check_masses(index + 1)?;
        let open = Span { middle: 0.0, half: 0.0 };
        Ok(PlainRod {
            throw: all.value(Varied::ThrowAngle, throw, engine.pin_angle(throw, 0.0)),
            harmonics: Vec::new(),
            coefficients: CoefficientRange::new(radius.over(&parts.length), open, &[])?,
            parts,
            radius,
            crank,
        })
    }

    /// Ranges of rod ratio and offset over rod length.
    fn spans(&self) -> [Span; 2] {
        [self.radius.over(&self.parts.length), self.parts.offset.over(&self.parts.length)]
    }

    /// Takes those of the engine's orders that it has.
    pub fn set_orders(&mut self, orders: &[u32]) -> Result<(), ScatterError> {
        self.harmonics = self.crank.harmonics(orders);
        let own: Vec<u32> = self.harmonics.iter().map(|harmonic| harmonic.number).collect();
        let [ratio, offset] = self.spans();
        self.coefficients = CoefficientRange::new(ratio, offset, &own)?;
        Ok(())
    }

    /// Marks the harmonics of which it has more than nothing, at the corners of its ranges.
    pub fn mark_harmonics(&self, matters: &mut [bool]) -> Result<(), ScatterError> {
        let [ratio, offset] = self.spans();
        let highest = matters.len() as u32 - 1;
        for u in [-1.0, 1.0] {
            for v in [-1.0, 1.0] {
                let (ratio, offset) = (ratio.middle + u * ratio.half, offset.middle + v * offset.half);
                for (order, c) in exact_coefficients(ratio, 1.0, offset, highest)?.iter().enumerate().skip(1)
                {
                    matters[order] |= c.norm() > NOTHING;
                }
            }
        }
        Ok(())
    }

    /// Adds force and couple of eight samples.
    pub fn add_to(&self, deviations: &[Lanes], out: &mut Spectrum) {
        let square = self.crank.square;
        let (radius, length) = (self.radius.at(deviations), self.parts.length.at(deviations));
        let (offset, plane) = (self.parts.offset.at(deviations), self.parts.plane.at(deviations));
        let masses = self.parts.masses(deviations);
        let half = Lanes::each(|i| 0.5 * masses.reciprocating[i] * radius[i] * square);
        let (ratio, offset) =
            (Lanes::each(|i| radius[i] / length[i]), Lanes::each(|i| offset[i] / length[i]));
        let throw = self.throw.direction(deviations);
        let axis = self.parts.axis.direction(deviations);
        let pin = ComplexLanes {
            re: Lanes::each(|i| masses.big_end[i] * radius[i] * square * throw.re[i]),
            im: Lanes::each(|i| masses.big_end[i] * radius[i] * square * throw.im[i]),
        };
        let step = throw.times_conj::<false>(axis);
        let mut turned = step;
        let mut order = 1;
        let forward = self.crank.sense;
        for (own, harmonic) in self.harmonics.iter().enumerate() {
            while order < harmonic.number {
                turned = turned.times::<false>(step);
                order += 1;
            }
            let c = self.coefficients.at(own, &ratio, &offset);
            let along = turned.times::<false>(c);
            let along = ComplexLanes {
                re: Lanes::each(|i| along.re[i] * half[i]),
                im: Lanes::each(|i| along.im[i] * half[i]),
            };
            out.add(harmonic.place, forward, &axis.times::<false>(along), &plane);
            out.add(harmonic.place, 1 - forward, &axis.times_conj::<false>(along), &plane);
            if harmonic.number == 1 {
                out.add(harmonic.place, forward, &pin, &plane);
            }
        }
    }

    /// How far its force [N] of harmonic number `own` in the list may be from the nominal one, and the nominal one, by sense
    /// with the crank and against it; the turning big end is [`PlainRod::big_end_off`].
    pub fn piston_off(&self, own: usize) -> [f64; 2] {
        let [mass, mass_off] = self.parts.reciprocating();
        let square = self.crank.square;
        let [size, spread] = self.coefficients.size_and_spread(own);
        // The nominal coefficient is one within the ranges.
        let nominal = 0.5 * square * mass * self.radius.nominal * (size + spread);
        let off = 0.5
            * square
            * (self.product_off(mass, mass_off) * (size + spread) + mass * self.radius.nominal * spread);
        let order = f64::from(self.harmonics[own].number);
        let angle = order * (self.throw.half + self.parts.axis.half) + self.parts.axis.half;
        [nominal, off + (nominal + off) * angle]
    }

    /// The same of the big end, which turns with the crank.
    pub fn big_end_off(&self) -> [f64; 2] {
        let [mass, mass_off] = self.parts.big_end();
        let square = self.crank.square;
        let size = mass * self.radius.nominal * square;
        let off = self.product_off(mass, mass_off) * square;
        [size, off + (size + off) * self.throw.half]
    }

    /// How far the product of a mass and the crank radius may be off.
    fn product_off(&self, mass: f64, mass_off: f64) -> f64 {
        mass * self.radius.half + mass_off * self.radius.largest()
    }
}
