//! An engine with its deviations, eight samples at a time: force and couple by order.
//!
//! ```text
//! piston:  1/2 m r w^2 c_n(r/l, e/l)  times  e^{i (n phi + b)} forward, its mirror e^{i (-n phi + b)} with conj(c_n) backward
//! turning: U w^2 e^{i angle}          couple: i z times the force
//! ```
//! (book, eq. 4.3 and 4.4). Every mass, length, angle and plane is the nominal one plus its deviations; nothing is
//! linearised.

use crate::scatter::coefficients::{CoefficientRange, Span};
use crate::scatter::error::ScatterError;
use crate::scatter::tolerance::Variable;
use crate::scatter::turned::turned;
use lanchester_mechanism::{LoadRequest, Mechanism, exact_coefficients};
use lanchester_model::{Engine, RodJoint};
use lanchester_numerics::{ComplexLanes, Lanes};
use lanchester_task::{Tolerance, Varied};

/// Orders below this share of the first are left out.
const NOTHING: f64 = 1e-13;

/// Highest order that is looked at.
const HIGHEST: u32 = 60;

/// Deviations of one quantity of one part: places of the variables that sum to it.
type Sum = Vec<u32>;

/// Sum of some variables.
#[inline]
fn sum(places: &[u32], deviations: &[Lanes]) -> Lanes {
    let mut total = Lanes::ZERO;
    for &place in places {
        let one = &deviations[place as usize];
        total = Lanes::each(|i| total[i] + one[i]);
    }
    total
}

/// A nominal value with its deviations.
#[derive(Debug, Clone, PartialEq, Default)]
struct Value {
    nominal: f64,
    deviations: Sum,
    /// Largest sum of the deviations.
    half: f64,
}

impl Value {
    #[inline]
    fn at(&self, deviations: &[Lanes]) -> Lanes {
        let total = sum(&self.deviations, deviations);
        Lanes::each(|i| self.nominal + total[i])
    }

    fn span(&self) -> [f64; 2] {
        [self.nominal - self.half, self.nominal + self.half]
    }

    /// Largest absolute value.
    fn largest(&self) -> f64 {
        self.nominal.abs() + self.half
    }
}

#[derive(Debug, Clone, PartialEq)]
struct CylinderModel {
    piston_mass: Value,
    big_end_mass: Value,
    small_end_mass: Value,
    /// Mass of the rod over its length: what a shift of its centre moves from end to end.
    rod_mass_per_length: f64,
    centre: Value,
    radius: Value,
    length: Value,
    offset: Value,
    plane: Value,
    /// Cylinder axis and throw.
    axis: Value,
    throw: Value,
    coefficients: CoefficientRange,
}

/// What turns with the crank or a shaft.
#[derive(Debug, Clone, PartialEq)]
struct TurningModel {
    /// Place of its order among the orders, and its sense: 0 forward, 1 backward.
    slot: [usize; 2],
    /// Square of its speed [1/s^2].
    square: f64,
    plane: f64,
    unbalance: Value,
    angle: Value,
}

/// An engine with its deviations, prepared.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Model {
    /// Orders that are there, rising.
    pub orders: Vec<u32>,
    cylinders: Vec<CylinderModel>,
    turning: Vec<TurningModel>,
    speed: f64,
}

/// Force and couple by order of [`Model::orders`] and sense.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Spectrum {
    pub force: Vec<[ComplexLanes; 2]>,
    pub couple: Vec<[ComplexLanes; 2]>,
}

impl Model {
    /// Prepares an engine; with `all_orders` every order that matters, else orders 1 and 2.
    pub fn new(
        engine: &Engine,
        speed: Option<f64>,
        tolerances: &[Tolerance],
        variables: &[Variable],
        all_orders: bool,
    ) -> Result<Model, ScatterError> {
        let request = LoadRequest { speed, samples: 1, ..LoadRequest::default() };
        // Refuses what is no engine or speed.
        Mechanism::new(engine, &request)?;
        let speed = speed.unwrap_or(engine.speed.highest);
        let value = |quantity: Varied, part: usize, nominal: f64| {
            let mut value = Value { nominal, ..Value::default() };
            for (place, variable) in variables.iter().enumerate() {
                let own = variable.part.is_none_or(|own| own == part);
                if own && tolerances[variable.tolerance].quantity == quantity {
                    value.deviations.push(place as u32);
                    value.half += variable.half_width;
                }
            }
            value
        };
        if engine.crankshafts.len() != 1 {
            let got = format!("{} crankshafts", engine.crankshafts.len());
            return Err(ScatterError::Engine { needed: "one crankshaft", got });
        }
        let mut cylinders = Vec::new();
        for (index, cylinder) in engine.cylinders.iter().enumerate() {
            if let RodJoint::Articulated { .. } = cylinder.rod.joint {
                let got = format!("an articulated rod in cylinder {}", index + 1);
                return Err(ScatterError::Engine { needed: "plain rods", got });
            }
            let throw = &engine.throws[cylinder.throw];
            let radius = value(Varied::CrankRadius, cylinder.throw, throw.radius);
            let length = value(Varied::RodLength, index, cylinder.rod.length);
            let offset = value(Varied::Offset, index, cylinder.net_offset());
            let piston_mass = value(Varied::PistonMass, index, cylinder.piston_mass);
            let big_end_mass = value(Varied::BigEndMass, index, cylinder.rod.big_end_mass);
            let small_end_mass = value(Varied::SmallEndMass, index, cylinder.rod.small_end_mass);
            let reach = radius.largest() + offset.largest();
            let turns = length.span()[0] > reach && radius.span()[0] > 0.0;
            let impossible = |reason| ScatterError::Impossible { cylinder: index + 1, reason };
            if !turns {
                return Err(impossible("its crank could not turn"));
            }
            if [&piston_mass, &big_end_mass, &small_end_mass].iter().any(|mass| mass.span()[0] < 0.0) {
                return Err(impossible("a mass would be negative"));
            }
            cylinders.push(CylinderModel {
                rod_mass_per_length: cylinder.rod.mass() / cylinder.rod.length,
                centre: value(Varied::RodCentre, index, 0.0),
                plane: value(Varied::CylinderPlane, index, cylinder.z),
                axis: value(Varied::CylinderAngle, index, cylinder.angle),
                throw: value(Varied::ThrowAngle, cylinder.throw, throw.angle),
                // Filled when the orders are known.
                coefficients: CoefficientRange::new(
                    spans(&radius, &length, &offset)[0],
                    Span { middle: 0.0, half: 0.0 },
                    &[],
                )?,
                piston_mass,
                big_end_mass,
                small_end_mass,
                radius,
                length,
                offset,
            });
        }
        let mut orders = if all_orders { orders_that_matter(&cylinders)? } else { vec![1, 2] };
        for shaft in &engine.shafts {
            let order = shaft.ratio.numerator().unsigned_abs();
            if shaft.ratio.denominator() != 1 {
                let got = format!("the shaft \"{}\" at {} of it", shaft.name, shaft.ratio);
                return Err(ScatterError::Engine {
                    needed: "shafts at whole multiples of the crank's speed",
                    got,
                });
            }
            if all_orders && !orders.contains(&order) {
                orders.push(order);
            }
        }
        orders.sort_unstable();
        for cylinder in &mut cylinders {
            let [ratio, offset] = spans(&cylinder.radius, &cylinder.length, &cylinder.offset);
            cylinder.coefficients = CoefficientRange::new(ratio, offset, &orders)?;
        }
        let mut turning = Vec::new();
        let crank = orders.iter().position(|&order| order == 1).map_or([0, 0], |place| [place, 0]);
        for (index, throw) in engine.throws.iter().enumerate() {
            turning.push(TurningModel {
                slot: crank,
                square: speed * speed,
                plane: throw.unbalance_plane(),
                unbalance: value(Varied::ThrowUnbalance, index, throw.unbalance),
                angle: value(Varied::ThrowAngle, index, throw.angle),
            });
        }
        for (index, weight) in engine.counterweights.iter().enumerate() {
            turning.push(TurningModel {
                slot: crank,
                square: speed * speed,
                plane: weight.z,
                unbalance: value(Varied::CounterweightUnbalance, index, weight.unbalance),
                angle: value(Varied::CounterweightAngle, index, weight.angle),
            });
        }
        let mut number = 0;
        for (index, shaft) in engine.shafts.iter().enumerate() {
            let turns = f64::from(shaft.ratio.numerator());
            let place = orders.iter().position(|&order| order == shaft.ratio.numerator().unsigned_abs());
            for weight in &shaft.weights {
                let unbalance = value(Varied::ShaftUnbalance, number, weight.unbalance);
                number += 1;
                // Orders that nobody asks about stay out.
                let Some(place) = place else { continue };
                turning.push(TurningModel {
                    slot: [place, usize::from(turns < 0.0)],
                    square: (turns * speed).powi(2),
                    plane: weight.z,
                    unbalance,
                    angle: value(Varied::ShaftPhase, index, weight.phase),
                });
            }
        }
        Ok(Model { orders, cylinders, turning, speed })
    }

    /// Force and couple of eight samples with these deviations.
    pub fn spectrum(&self, deviations: &[Lanes], out: &mut Spectrum) {
        out.force.clear();
        out.force.resize(self.orders.len(), [ComplexLanes::ZERO; 2]);
        out.couple.clear();
        out.couple.resize(self.orders.len(), [ComplexLanes::ZERO; 2]);
        for cylinder in &self.cylinders {
            cylinder.add_to(self, deviations, out);
        }
        for part in &self.turning {
            let unbalance = part.unbalance.at(deviations);
            let turned = direction(&part.angle, deviations);
            let force = ComplexLanes {
                re: Lanes::each(|i| unbalance[i] * part.square * turned.re[i]),
                im: Lanes::each(|i| unbalance[i] * part.square * turned.im[i]),
            };
            let [place, sense] = part.slot;
            add(out, place, sense, &force, &Lanes::all(part.plane));
        }
    }

    /// How far force [N] and couple [N m] of the order at `place` may be from the nominal ones, by sense: what each part
    /// may be off by its masses, lengths, angles and plane, by the triangle inequality.
    pub fn farthest(&self, place: usize) -> [[f64; 2]; 2] {
        let square = self.speed * self.speed;
        let order = f64::from(self.orders[place]);
        let mut sums = [[0.0; 2]; 2];
        let mut add = |sense: usize, size: f64, off: f64, plane: &Value| {
            sums[0][sense] += off;
            sums[1][sense] += plane.largest() * off + plane.half * size;
        };
        for c in &self.cylinders {
            let moved = c.centre.half * c.rod_mass_per_length;
            let mass = c.piston_mass.nominal + c.small_end_mass.nominal;
            let mass_off = c.piston_mass.half + c.small_end_mass.half + moved;
            let product_off = |mass: f64, off: f64| mass * c.radius.half + off * c.radius.largest();
            let [size, spread] = c.coefficients.size_and_spread(place);
            // The nominal coefficient is one within the ranges.
            let nominal = 0.5 * square * mass * c.radius.nominal * (size + spread);
            let off = 0.5
                * square
                * (product_off(mass, mass_off) * (size + spread) + mass * c.radius.nominal * spread);
            let turn = c.throw.half + c.axis.half;
            for (sense, angle) in
                [order * turn + c.axis.half, order * turn + c.axis.half].into_iter().enumerate()
            {
                add(sense, nominal, off + (nominal + off) * angle, &c.plane);
            }
            if self.orders[place] == 1 {
                let big = c.big_end_mass.nominal;
                let size = big * c.radius.nominal * square;
                let off = product_off(big, c.big_end_mass.half + moved) * square;
                add(0, size, off + (size + off) * c.throw.half, &c.plane);
            }
        }
        for t in self.turning.iter().filter(|t| t.slot[0] == place) {
            let plane = Value { nominal: t.plane, ..Value::default() };
            let (size, off) = (t.unbalance.nominal.abs() * t.square, t.unbalance.half * t.square);
            add(t.slot[1], size, off + (size + off) * t.angle.half, &plane);
        }
        sums
    }

    /// What all masses together could exert [N], and at their planes [N m]: what rounding and resolution are measured by.
    pub fn scale(&self) -> [f64; 2] {
        let square = self.speed * self.speed;
        let pistons = self.cylinders.iter().map(|c| {
            let mass = c.piston_mass.largest() + c.small_end_mass.largest() + c.big_end_mass.largest();
            (mass * c.radius.largest() * square, c.plane.largest())
        });
        let turning = self.turning.iter().map(|t| (t.unbalance.largest() * t.square, t.plane.abs()));
        pistons
            .chain(turning)
            .fold([0.0, 0.0], |sum, (force, plane)| [sum[0] + force, sum[1] + force * plane])
    }
}

/// `e^{i angle}` of a value.
#[inline]
fn direction(angle: &Value, deviations: &[Lanes]) -> ComplexLanes {
    let (sin, cos) = angle.nominal.sin_cos();
    turned(cos, sin, &sum(&angle.deviations, deviations))
}

/// Adds a force in a plane to force and couple.
#[inline]
fn add(out: &mut Spectrum, place: usize, sense: usize, force: &ComplexLanes, plane: &Lanes) {
    let sum = &mut out.force[place][sense];
    sum.re = Lanes::each(|i| sum.re[i] + force.re[i]);
    sum.im = Lanes::each(|i| sum.im[i] + force.im[i]);
    // i z F.
    let sum = &mut out.couple[place][sense];
    sum.re = Lanes::each(|i| sum.re[i] - plane[i] * force.im[i]);
    sum.im = Lanes::each(|i| sum.im[i] + plane[i] * force.re[i]);
}

impl CylinderModel {
    fn add_to(&self, model: &Model, deviations: &[Lanes], out: &mut Spectrum) {
        let square = model.speed * model.speed;
        let (radius, length) = (self.radius.at(deviations), self.length.at(deviations));
        let (offset, plane) = (self.offset.at(deviations), self.plane.at(deviations));
        let moved = self.centre.at(deviations);
        let moved = Lanes::each(|i| moved[i] * self.rod_mass_per_length);
        let (piston, small) = (self.piston_mass.at(deviations), self.small_end_mass.at(deviations));
        let big = self.big_end_mass.at(deviations);
        let half = Lanes::each(|i| 0.5 * (piston[i] + small[i] + moved[i]) * radius[i] * square);
        let (ratio, offset) =
            (Lanes::each(|i| radius[i] / length[i]), Lanes::each(|i| offset[i] / length[i]));
        let throw = direction(&self.throw, deviations);
        let axis = direction(&self.axis, deviations);
        let pin = ComplexLanes {
            re: Lanes::each(|i| (big[i] - moved[i]) * radius[i] * square * throw.re[i]),
            im: Lanes::each(|i| (big[i] - moved[i]) * radius[i] * square * throw.im[i]),
        };
        let step = throw.times_conj::<false>(axis);
        let mut turned = step;
        let mut order = 1;
        for (place, &wanted) in model.orders.iter().enumerate() {
            while order < wanted {
                turned = turned.times::<false>(step);
                order += 1;
            }
            let c = self.coefficients.at(place, &ratio, &offset);
            let along = turned.times::<false>(c);
            let along = ComplexLanes {
                re: Lanes::each(|i| along.re[i] * half[i]),
                im: Lanes::each(|i| along.im[i] * half[i]),
            };
            add(out, place, 0, &axis.times::<false>(along), &plane);
            add(out, place, 1, &axis.times_conj::<false>(along), &plane);
            if wanted == 1 {
                add(out, place, 0, &pin, &plane);
            }
        }
    }
}

/// Ranges of rod ratio and offset over rod length.
fn spans(radius: &Value, length: &Value, offset: &Value) -> [Span; 2] {
    let range = |value: &Value| {
        let ends = value.span();
        let all = ends.into_iter().flat_map(|v| length.span().into_iter().map(move |l| v / l));
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let varies = value.half > 0.0 || (length.half > 0.0 && value.nominal != 0.0);
        let half = if varies { 0.5 * (high - low) } else { 0.0 };
        Span { middle: 0.5 * (low + high), half }
    };
    [range(radius), range(offset)]
}

/// Orders of which some cylinder has more than nothing, at the corners of its ranges.
fn orders_that_matter(cylinders: &[CylinderModel]) -> Result<Vec<u32>, ScatterError> {
    let mut matters = vec![false; HIGHEST as usize + 1];
    for cylinder in cylinders {
        let [ratio, offset] = spans(&cylinder.radius, &cylinder.length, &cylinder.offset);
        for u in [-1.0, 1.0] {
            for v in [-1.0, 1.0] {
                let (ratio, offset) = (ratio.middle + u * ratio.half, offset.middle + v * offset.half);
                for (order, c) in exact_coefficients(ratio, 1.0, offset, HIGHEST)?.iter().enumerate().skip(1)
                {
                    matters[order] |= c.norm() > NOTHING;
                }
            }
        }
    }
    // Orders 1 and 2 are always asked for.
    Ok((1..=HIGHEST).filter(|&order| order <= 2 || matters[order as usize]).collect())
}
