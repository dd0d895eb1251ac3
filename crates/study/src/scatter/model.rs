//! An engine with its deviations, eight samples at a time: force and couple by order.
//!
//! ```text
//! pistons and rods: see plain_rod and articulated
//! turning: U W^2 e^{i angle}          couple: i z times the force
//! ```
//! (book, eq. 4.3 and 4.4). W is the speed of the crankshaft or shaft. Every mass, length, angle and plane is the nominal one plus its
//! deviations; nothing is linearised.

use crate::scatter::articulated::{ArticulatedRods, articulated_rods};
use crate::scatter::crank_speed::CrankSpeed;
use crate::scatter::error::ScatterError;
use crate::scatter::moving_parts::MovingParts;
use crate::scatter::plain_rod::PlainRod;
use crate::scatter::spectrum::{HIGHEST, Spectrum};
use crate::scatter::tolerance::Variable;
use crate::scatter::value::{Deviations, Value};
use lanchester_mechanism::{LoadRequest, Mechanism};
use lanchester_model::{Engine, RodJoint};
use lanchester_numerics::{ComplexLanes, Lanes};
use lanchester_task::{Tolerance, Varied};

/// What turns with a crankshaft or a shaft.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TurningModel {
    /// Place of its order among the orders, and its sense: 0 forward, 1 backward.
    pub slot: [usize; 2],
    /// Square of its speed [1/s^2].
    pub square: f64,
    pub plane: f64,
    pub unbalance: Value,
    pub angle: Value,
}

/// An engine with its deviations, prepared.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Model {
    /// Orders that are there, rising; 1 and 2 are the first two.
    pub orders: Vec<u32>,
    /// Cylinders whose rods sit on a crankpin.
    pub cylinders: Vec<PlainRod>,
    /// Cylinders whose rods sit on the knuckle pins of one of these.
    pub articulated: Vec<ArticulatedRods>,
    pub turning: Vec<TurningModel>,
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
        let all = Deviations { tolerances, variables };
        let crank_speed = |crankshaft: usize| {
            let own = &engine.crankshafts[crankshaft];
            CrankSpeed::of(own.ratio, speed, || format!("the crankshaft \"{}\"", own.name))
        };
        let (cylinders, articulated) = rods(engine, all, &crank_speed)?;
        let shaft_speeds = engine
            .shafts
            .iter()
            .map(|shaft| CrankSpeed::of(shaft.ratio, speed, || format!("the shaft \"{}\"", shaft.name)));
        let shaft_speeds: Vec<CrankSpeed> = shaft_speeds.collect::<Result<_, _>>()?;
        let mut model = Model { orders: vec![1, 2], cylinders, articulated, turning: Vec::new() };
        if all_orders {
            model.add_orders_that_matter()?;
            let of_throws = engine.throws.iter().map(|throw| crank_speed(throw.crankshaft));
            let of_weights = engine.counterweights.iter().map(|weight| crank_speed(weight.crankshaft));
            for turning in of_throws.chain(of_weights).chain(shaft_speeds.iter().map(|own| Ok(*own))) {
                model.add_order(turning?.multiple);
            }
            model.orders.sort_unstable();
        }
        for rod in &mut model.cylinders {
            rod.set_orders(&model.orders)?;
        }
        for rods in &mut model.articulated {
            rods.set_angles(&model.cylinders[rods.master]);
        }
        for (index, throw) in engine.throws.iter().enumerate() {
            let unbalance = all.value(Varied::ThrowUnbalance, index, throw.unbalance);
            let angle = all.value(Varied::ThrowAngle, index, engine.pin_angle(index, 0.0));
            model.add_turning(crank_speed(throw.crankshaft)?, throw.unbalance_plane(), unbalance, angle);
        }
        for (index, weight) in engine.counterweights.iter().enumerate() {
            let unbalance = all.value(Varied::CounterweightUnbalance, index, weight.unbalance);
            let zero = engine.crankshafts[weight.crankshaft].phase;
            let angle = all.value(Varied::CounterweightAngle, index, zero + weight.angle);
            model.add_turning(crank_speed(weight.crankshaft)?, weight.z, unbalance, angle);
        }
        let mut number = 0;
        for (index, (shaft, &own)) in engine.shafts.iter().zip(&shaft_speeds).enumerate() {
            for weight in &shaft.weights {
                let unbalance = all.value(Varied::ShaftUnbalance, number, weight.unbalance);
                let angle = all.value(Varied::ShaftPhase, index, weight.phase);
                number += 1;
                model.add_turning(own, weight.z, unbalance, angle);
            }
        }
        Ok(model)
    }

    fn add_order(&mut self, order: u32) {
        if !self.orders.contains(&order) {
            self.orders.push(order);
        }
    }

    /// Adds the orders of which some cylinder has more than nothing, at the corners of its tolerances.
    fn add_orders_that_matter(&mut self) -> Result<(), ScatterError> {
        let mut of_cranks: Vec<(u32, Vec<bool>)> = Vec::new();
        for (place, rod) in self.cylinders.iter().enumerate() {
            let multiple = rod.crank.multiple;
            let own = of_cranks.iter().position(|(other, _)| *other == multiple).unwrap_or_else(|| {
                of_cranks.push((multiple, vec![false; HIGHEST as usize + 1]));
                of_cranks.len() - 1
            });
            let matters = &mut of_cranks[own].1;
            rod.mark_harmonics(matters)?;
            for rods in self.articulated.iter().filter(|rods| rods.master == place) {
                rods.mark_harmonics(rod, matters);
            }
        }
        for (multiple, matters) in of_cranks {
            for number in (1..=HIGHEST).filter(|&number| matters[number as usize]) {
                self.add_order(number * multiple);
            }
        }
        Ok(())
    }

    /// Adds what turns at a speed, unless its order is one that nobody asks about.
    fn add_turning(&mut self, speed: CrankSpeed, plane: f64, unbalance: Value, angle: Value) {
        if let Some(place) = speed.place(&self.orders) {
            let (slot, square) = ([place, speed.sense], speed.square);
            self.turning.push(TurningModel { slot, square, plane, unbalance, angle });
        }
    }

    /// Force and couple of eight samples with these deviations.
    pub fn spectrum(&self, deviations: &[Lanes], out: &mut Spectrum) {
        out.clear(self.orders.len());
        for cylinder in &self.cylinders {
            cylinder.add_to(deviations, out);
        }
        for rods in &self.articulated {
            rods.add_to(&self.cylinders[rods.master], deviations, out);
        }
        for part in &self.turning {
            let unbalance = part.unbalance.at(deviations);
            let turned = part.angle.direction(deviations);
            let force = ComplexLanes {
                re: Lanes::each(|i| unbalance[i] * part.square * turned.re[i]),
                im: Lanes::each(|i| unbalance[i] * part.square * turned.im[i]),
            };
            let [place, sense] = part.slot;
            out.add(place, sense, &force, &Lanes::all(part.plane));
        }
    }

    /// What all masses together could exert [N], and at their planes [N m]: what rounding and resolution are measured by.
    pub fn scale(&self) -> [f64; 2] {
        let of_rod = |rod: &PlainRod, parts: &MovingParts| {
            (parts.largest_mass() * rod.radius.largest() * rod.crank.square, parts.plane.largest())
        };
        let plain = self.cylinders.iter().map(|rod| of_rod(rod, &rod.parts));
        let articulated = self.articulated.iter().flat_map(|rods| {
            let master = &self.cylinders[rods.master];
            rods.rods.iter().map(move |rod| of_rod(master, &rod.parts))
        });
        let turning = self.turning.iter().map(|t| (t.unbalance.largest() * t.square, t.plane.abs()));
        plain
            .chain(articulated)
            .chain(turning)
            .fold([0.0, 0.0], |sum, (force, plane)| [sum[0] + force, sum[1] + force * plane])
    }
}

/// Cylinders whose rods sit on crankpins, and those on the knuckle pins of their masters; their orders are still open.
fn rods(
    engine: &Engine,
    all: Deviations<'_>,
    crank_speed: &impl Fn(usize) -> Result<CrankSpeed, ScatterError>,
) -> Result<(Vec<PlainRod>, Vec<ArticulatedRods>), ScatterError> {
    let (mut cylinders, mut articulated) = (Vec::new(), Vec::new());
    for (index, cylinder) in engine.cylinders.iter().enumerate() {
        if let RodJoint::Articulated { .. } = cylinder.rod.joint {
            continue;
        }
        let crank = crank_speed(engine.throws[cylinder.throw].crankshaft)?;
        let rod = PlainRod::of(engine, index, all, crank)?;
        articulated.extend(articulated_rods(engine, index, cylinders.len(), &rod, all)?);
        cylinders.push(rod);
    }
    Ok((cylinders, articulated))
}
