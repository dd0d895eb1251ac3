//! The task in scaled numbers: the shape's variables and all that must not be positive.
//!
//! Lengths over the largest length of the ranges, unbalance over the least unbalance asked for, so that the density is one.
//! Five variables: `r`, `h`, `H`, half the chord `w = R sin a`, and `a = alpha/2`. In `w` instead of `R` the integrals over the shape are sums of
//! products of what grows, which keeps intervals narrow. The thickness is no variable: everything that is limited or made small grows
//! with it, so that it is best as small as the unbalance and its own range allow, `t = max(t_least, U/(rho S))`
//! (book, eq. 22.27).

use super::number::Number;
use super::sector::Sector;
use super::task::DesignTask;
use crate::clearance::RadialEnvelope;
use lanchester_numerics::Interval;
use lanchester_shape::CounterweightShape;
use lanchester_task::{Objective, Range, Shoulder};
use std::f64::consts::PI;

/// Variables of the shape.
pub(super) const SHAPE: usize = 5;

/// A quantity with a level that it must not pass: a limit, or what is made small.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Mass,
    SweptRadius,
    Inertia,
    Thickness,
    HalfWidth,
    /// Unbalance over the least unbalance asked for: at least its level.
    Balance,
}

impl From<Objective> for Kind {
    fn from(objective: Objective) -> Kind {
        match objective {
            Objective::Mass => Kind::Mass,
            Objective::SweptRadius => Kind::SweptRadius,
            Objective::Inertia => Kind::Inertia,
            Objective::Thickness => Kind::Thickness,
        }
    }
}

/// The level of each kind; not finite where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Levels<T> {
    pub mass: Option<T>,
    pub swept_radius: Option<T>,
    pub inertia: Option<T>,
    pub thickness: T,
    pub half_width: Option<T>,
    pub balance: T,
}

impl<T: Copy> Levels<T> {
    pub fn with(mut self, kind: Kind, level: T) -> Levels<T> {
        match kind {
            Kind::Mass => self.mass = Some(level),
            Kind::SweptRadius => self.swept_radius = Some(level),
            Kind::Inertia => self.inertia = Some(level),
            Kind::Thickness => self.thickness = level,
            Kind::HalfWidth => self.half_width = Some(level),
            Kind::Balance => self.balance = level,
        }
        self
    }

    pub fn of(&self, kind: Kind) -> Option<T> {
        match kind {
            Kind::Mass => self.mass,
            Kind::SweptRadius => self.swept_radius,
            Kind::Inertia => self.inertia,
            Kind::Thickness => Some(self.thickness),
            Kind::HalfWidth => self.half_width,
            Kind::Balance => Some(self.balance),
        }
    }

    pub fn mapped<U>(&self, map: impl Fn(T) -> U) -> Levels<U> {
        Levels {
            mass: self.mass.map(&map),
            swept_radius: self.swept_radius.map(&map),
            inertia: self.inertia.map(&map),
            thickness: map(self.thickness),
            half_width: self.half_width.map(&map),
            balance: map(self.balance),
        }
    }
}

/// What a shape amounts to (book, eqs. 22.21 to 22.24).
pub(super) struct Quantities<T> {
    pub area: T,
    pub first: T,
    pub polar: T,
    web_radius: T,
    shoulder_height: T,
    chord: T,
    half_chord: T,
    sine: T,
    late_sine: T,
    shoulder: T,
    half_tangent: T,
    crown: T,
}

/// The scaled task.
#[derive(Debug, Clone)]
pub(super) struct Problem {
    pub low: [f64; SHAPE],
    pub high: [f64; SHAPE],
    pub levels: Levels<f64>,
    arc_radius: [f64; 2],
    thinnest: f64,
    most_balance: Option<f64>,
    shoulder_angle: Option<[f64; 2]>,
    /// The directions in which the corner of the chord may lie, with the envelope around the shape.
    pub sector: Option<Sector>,
    /// Length that is one [m].
    pub length: f64,
    unbalance: f64,
    density: f64,
}

/// One thing that must not be positive, and whether it holds the level that is asked for.
pub(super) struct Term<T> {
    pub value: T,
    pub of_objective: bool,
}

impl Problem {
    pub fn new(task: &DesignTask) -> Problem {
        let height = match task.shoulder {
            Shoulder::Height(range) => range.most,
            Shoulder::Angle(_) => 0.0,
        };
        let length = [task.web_radius.most, task.rectangle_height.most, task.arc_radius.most, height]
            .into_iter()
            .fold(0.0, f64::max);
        let scaled = |range: Range| [range.least / length, range.most / length];
        let (web, rectangle, arc_radius) =
            (scaled(task.web_radius), scaled(task.rectangle_height), scaled(task.arc_radius));
        // The chord is at least as wide as the web; a little wider, for rounding.
        let flattest = (web[0] / arc_radius[1] * (1.0 - 1e-9)).min(1.0).asin();
        let half_angle =
            [(task.arc_angle.least / 2.0).max(flattest), (task.arc_angle.most / 2.0).min(PI - flattest)];
        let sines = Interval::new(half_angle[0], half_angle[1]).sin();
        let half_width = [arc_radius[0] * sines.low, arc_radius[1] * sines.high];
        let stands_out = [(half_width[0] - web[1]).max(0.0), (half_width[1] - web[0]).max(0.0)];
        let (mut shoulder, mut angle) = match task.shoulder {
            Shoulder::Height(range) => (scaled(range), task.limits.shoulder_angle),
            Shoulder::Angle(range) => {
                ([stands_out[0] * range.least.tan(), stands_out[1] * range.most.tan()], Some(range))
            }
        };
        if let (Shoulder::Angle(own), Some(limit)) = (task.shoulder, task.limits.shoulder_angle) {
            angle = Some(Range::new(own.least.max(limit.least), own.most.min(limit.most)));
        }
        if let Some(limit) = task.limits.shoulder_height.map(scaled) {
            shoulder = [shoulder[0].max(limit[0]), shoulder[1].min(limit[1])];
        }
        let ranges = [web, rectangle, shoulder, half_width, half_angle];
        let mut problem = Problem {
            low: ranges.map(|range| range[0]),
            high: ranges.map(|range| range[1]),
            levels: Levels {
                mass: None,
                swept_radius: None,
                inertia: None,
                thickness: 0.0,
                half_width: None,
                balance: 1.0,
            },
            arc_radius,
            thinnest: 0.0,
            most_balance: task.most_balance.map(|most| most / task.least_balance),
            shoulder_angle: angle.map(|range| [range.least, range.most]),
            sector: None,
            length,
            unbalance: task.unbalance * task.least_balance,
            density: task.density,
        };
        let scale = |kind| problem.unit(kind);
        let limits = &task.limits;
        problem.levels = Levels {
            mass: limits.mass.map(|m| m / scale(Kind::Mass)),
            swept_radius: limits.swept_radius.map(|p| p / scale(Kind::SweptRadius)),
            inertia: limits.inertia.map(|i| i / scale(Kind::Inertia)),
            thickness: task.thickness.most / scale(Kind::Thickness),
            half_width: limits.half_width.map(|w| w / scale(Kind::HalfWidth)),
            balance: 1.0,
        };
        problem.thinnest = task.thickness.least / problem.unit(Kind::Thickness);
        problem
    }

    /// The task within an envelope: one for every range of directions in which the corner of the chord may lie.
    pub fn within(self, envelope: Option<&RadialEnvelope>) -> Vec<Problem> {
        let Some(envelope) = envelope else { return vec![self] };
        let sectors = Sector::all(envelope, self.length);
        let at = |sector| Problem { sector: Some(sector), ..self.clone() };
        // Where the chord can be neither so near nor so wide there is nothing to search.
        let ends = |problem: &Problem| {
            let near = problem.low[1] + problem.low[2];
            let far = problem.high[1] + problem.high[2];
            [problem.low[3].atan2(far), problem.high[3].atan2(near)]
        };
        let all = sectors.into_iter().map(at);
        all.filter(|one| {
            let [least, most] = ends(one);
            one.sector.as_ref().is_some_and(|sector| sector.from <= most && sector.to >= least)
        })
        .collect()
    }

    /// With this level of a quantity.
    pub fn limited(mut self, kind: Kind, level: f64) -> Problem {
        self.levels = self.levels.with(kind, level);
        self
    }

    /// Whether a range is empty: then no shape is within it.
    pub fn is_empty(&self) -> bool {
        self.low.iter().zip(&self.high).any(|(low, high)| low > high)
            || self.shoulder_angle.is_some_and(|[least, most]| least > most)
    }

    /// The shape of these variables.
    pub fn shape(&self, x: &[f64; SHAPE]) -> CounterweightShape {
        CounterweightShape {
            web_radius: x[0] * self.length,
            rectangle_height: x[1] * self.length,
            shoulder_height: x[2] * self.length,
            arc_radius: (x[3] / x[4].sin()).clamp(self.arc_radius[0], self.arc_radius[1]) * self.length,
            arc_angle: 2.0 * x[4],
        }
    }

    /// What one stands for, in SI units.
    pub fn unit(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Mass => self.unbalance / self.length,
            Kind::SweptRadius | Kind::HalfWidth => self.length,
            Kind::Inertia => self.unbalance * self.length,
            Kind::Thickness => self.unbalance / (self.density * self.length.powi(3)),
            Kind::Balance => 1.0,
        }
    }

    /// What a shape amounts to.
    pub fn quantities<T: Number>(&self, x: &[T; SHAPE]) -> Quantities<T> {
        let [r, h, big_h, w, a] = *x;
        let y = h + big_h;
        let [area, first, polar] = a.segment();
        let (r2, w2) = (r.square(), w.square());
        let (segment, lever) = (w2 * area, w2 * w * first);
        let sum = r + w;
        // Nothing is taken away but the web's disc, so that intervals stay narrow.
        let area = segment + sum * big_h + (r * h).times(2.0) - r2.times(PI / 2.0);
        let first =
            segment * y + lever + big_h * (h * sum + big_h * (sum + w).times(1.0 / 3.0)) + r * h.square()
                - (r2 * r).times(2.0 / 3.0);
        let polar = w2.square() * polar
            + (y * lever).times(2.0)
            + y.square() * segment
            + (r * h * (h.square() + r2)).times(2.0 / 3.0)
            + big_h
                * (h.square() * sum
                    + h * big_h * (sum + w).times(2.0 / 3.0)
                    + big_h.square() * (sum + w.times(2.0)).times(1.0 / 6.0)
                    + sum * (w2 + r2).times(1.0 / 6.0))
            - r2.square().times(PI / 4.0);
        let half_tangent = a.half_tangent();
        Quantities {
            area,
            first,
            polar,
            web_radius: r,
            shoulder_height: big_h,
            chord: y,
            half_chord: w,
            sine: a.sin(),
            late_sine: a.late_sine(),
            shoulder: w - r,
            half_tangent,
            crown: y + w * half_tangent,
        }
    }

    /// All that must not be positive, for these levels.
    pub fn terms<T: Number>(
        &self,
        q: &Quantities<T>,
        levels: &Levels<T>,
        objective: Option<Kind>,
        out: &mut Vec<Term<T>>,
    ) {
        out.clear();
        let one = T::of(1.0);
        let is = |kind| objective == Some(kind);
        let mut push = |value: T, of_objective: bool| out.push(Term { value, of_objective });
        let balance = is(Kind::Balance);
        push(levels.balance - levels.thickness * q.first, is(Kind::Thickness) || balance);
        if is(Kind::Thickness) && self.thinnest > 0.0 {
            push(one - levels.thickness.times(1.0 / self.thinnest), true);
        }
        if let Some(most) = self.most_balance {
            push(q.first.times(self.thinnest) - T::of(most), false);
        }
        for (kind, level, integral) in
            [(Kind::Mass, levels.mass, q.area), (Kind::Inertia, levels.inertia, q.polar)]
        {
            if let Some(level) = level {
                push(integral.times(self.thinnest) - level, is(kind));
                push(integral * levels.balance - level * q.first, is(kind) || balance);
            }
        }
        let (r, y, w) = (q.web_radius, q.chord, q.half_chord);
        if let Some(reach) = levels.swept_radius {
            // The corner of the rectangle lies no farther than the corner of the chord.
            let swept = is(Kind::SweptRadius);
            push(r - reach, swept);
            push(y.square() + w.square() - reach.square(), swept);
            push(q.crown - reach, swept);
        }
        if let Some(most) = levels.half_width {
            push(w - most * q.late_sine, is(Kind::HalfWidth));
        }
        let [least, most] = self.arc_radius;
        push(q.sine.times(least) - w, false);
        push(w - q.sine.times(most), false);
        push(-q.shoulder, false);
        push(r - q.crown, false);
        if let Some(sector) = &self.sector {
            push(r - T::of(sector.least), false);
            push(q.crown - T::of(sector.crown), false);
            sector.terms(y, w, q.half_tangent, |value| push(value, false));
        }
        if let Some(range) = self.shoulder_angle {
            for (angle, sign) in [(range[0], 1.0), (range[1], -1.0)] {
                push(
                    q.shoulder.times(sign * angle.sin()) - q.shoulder_height.times(sign * angle.cos()),
                    false,
                );
            }
        }
    }

    /// The level that a shape just reaches: as small as it can be, and as large for the balance. The levels of the others hold.
    pub fn attained(&self, q: &Quantities<f64>, kind: Kind) -> f64 {
        let levels = &self.levels;
        let thickness =
            if q.first > 0.0 { self.thinnest.max(levels.balance / q.first) } else { f64::INFINITY };
        match kind {
            Kind::Mass => q.area * thickness,
            Kind::Inertia => q.polar * thickness,
            Kind::Thickness => thickness,
            Kind::SweptRadius => q.web_radius.max(q.chord.hypot(q.half_chord)).max(q.crown),
            Kind::HalfWidth => q.half_chord / q.late_sine,
            Kind::Balance => {
                let by_mass = levels.mass.map_or(f64::INFINITY, |most| most / q.area);
                let by_inertia = levels.inertia.map_or(f64::INFINITY, |most| most / q.polar);
                q.first * levels.thickness.min(by_mass).min(by_inertia)
            }
        }
    }
}
