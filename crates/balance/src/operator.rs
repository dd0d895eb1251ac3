//! Devices as linear operators: the loads of an engine with free devices, affine in what is to be found.
//!
//! ```text
//! weight at (x, y, z) turning at ratio n:   F = n^2 w^2 U e^{i n theta}     M_x + i M_y = i z F     M_z = x F_y - y F_x
//! inertia J at ratio -k, crank train J1:    M_z = M_z0 + s T    s = 1 - (J1 - k J) / (J1 + k^2 J) = J k (k + 1) / (J1 + k^2 J)
//! ```
//! `T` is the torque that the crank train delivers, `M_z0` the roll moment at constant speed. With the crank train free
//! to follow its torque nothing is delivered: `(J1 + k^2 J) theta'' = T`, and the change of `(J1 - k J) theta'` reacts on
//! the block in place of `T`. The rest of `M_z0` (side thrust, rod inertia, off-axis weights) stays as it is.

use crate::convex::curve::Grid;
use crate::convex::dense::Matrix;
use crate::error::BalanceError;
use crate::over_speed::criteria::criteria;
use crate::over_speed::places::SpeedPlaces;
use crate::rounding::clear_rounding;
use crate::wave::Wave;
use lanchester_mechanism::{
    Beam, BeamModel, Kinematics, LoadError, LoadRequest, MainOrders, Mechanism, main_orders,
};
use lanchester_model::{Engine, Ratio};
use lanchester_results::OrderLoads;
use lanchester_task::{BalanceTask, Criterion, FreeInertia, Phase, Place, Seat, Statistic};
use num_complex::Complex64;
use std::rc::Rc;

/// Angles of the grid in a revolution, at least.
const ANGLES: usize = 720;

/// Orders above the last kept one are below this share of the largest.
const TAIL: f64 = 1e-14;

/// Longest common period of all shafts [revolutions of crankshaft 1].
const MOST_REVOLUTIONS: u32 = 120;

/// Components of the loads, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Channel {
    ForceX,
    ForceY,
    CoupleX,
    CoupleY,
    RollMoment,
}

/// Where a weight may stand: a place, or one end of the stretch or area that it may stand in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Corner {
    /// `x + i y` of its axis [m].
    pub axis: Complex64,
    /// Plane [m].
    pub z: f64,
    /// Variables and what a unit of each is [kg m].
    pub terms: Vec<(usize, Complex64)>,
}

/// A free weight in terms of the variables.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WeightColumns {
    pub ratio: Ratio,
    pub corners: Vec<Corner>,
    /// Natural amount [kg m].
    pub unit: f64,
}

/// What the engine itself does: the part of an [`Operator`] that does not depend on the devices.
#[derive(Debug, Clone)]
pub(crate) struct EngineLoads {
    orders: Vec<OrderLoads>,
    /// Loads of the main bearings.
    mains: Vec<MainOrders>,
    /// Period [revolutions of crankshaft 1].
    revolutions: u32,
    /// Speed of crankshaft 1 [rad/s].
    speed: f64,
    natural_force: f64,
    natural_moment: f64,
    /// Where its loads over speed are judged.
    places: Rc<SpeedPlaces>,
}

impl EngineLoads {
    /// Of an engine without what the task takes over.
    pub fn of(engine: &Engine, kinematics: Kinematics) -> Result<EngineLoads, BalanceError> {
        let (orders, revolutions) = orders(engine, kinematics)?;
        let speed = engine.speed.highest;
        let (natural_force, natural_moment) = natural(engine, speed);
        let mains = main_orders(engine, &LoadRequest { kinematics, ..LoadRequest::default() })?;
        let places = Rc::default();
        Ok(EngineLoads { orders, mains, revolutions, speed, natural_force, natural_moment, places })
    }

    /// The same with places at which its loads over speed are judged.
    pub fn judged_at(self, places: &Rc<SpeedPlaces>) -> EngineLoads {
        EngineLoads { places: Rc::clone(places), ..self }
    }
}

/// The area that a shaft's axis may be found in.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct AxisArea {
    /// Its corners; the shaft's weights stand on the first one.
    pub corners: Vec<Complex64>,
    /// Direction of all weights on the shaft, where they have only one.
    pub direction: Option<f64>,
}

/// The loads of an engine with free devices.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Operator {
    /// Speed of crankshaft 1 [rad/s].
    pub speed: f64,
    pub grid: Rc<Grid>,
    /// By [`Channel`].
    pub channels: [Wave; 5],
    /// Load of every main bearing along x and y, in the order of [`Engine::main_bearings`].
    pub mains: Vec<[Wave; 2]>,
    pub variables: usize,
    pub weights: Vec<WeightColumns>,
    /// Variable of the inertia's share `s` and its largest value.
    pub inertia: Option<(usize, f64)>,
    /// Variables that are not negative.
    pub positive: Vec<usize>,
    /// Shafts whose axis is to be found: corners of the area beyond the first, which the shaft's weights stand on.
    pub axes: Vec<Vec<Corner>>,
    /// `equalities x = equal_to`: weights that depend on one another, and given amounts in a given direction.
    pub equalities: Matrix,
    /// Right side of the equalities.
    pub equal_to: Vec<f64>,
    /// What forces are measured against [N].
    pub natural_force: f64,
    /// What moments are measured against [N m].
    pub natural_moment: f64,
    /// Variables that the largest of several means does not pass.
    pub largest: Vec<(Criterion, usize)>,
    /// Where loads over speed are judged; no place of mounts: at the highest speed.
    pub places: Rc<SpeedPlaces>,
}

impl Operator {
    pub fn channel(&self, channel: Channel) -> &Wave {
        &self.channels[channel as usize]
    }

    /// The operator of `engine` with the devices of `task`; `places` gives the corners of every weight.
    ///
    /// The engine comes without what the task takes over.
    pub fn new(
        engine: &Engine,
        task: &BalanceTask,
        kinematics: Kinematics,
        places: &[Vec<(Complex64, f64)>],
    ) -> Result<Operator, BalanceError> {
        Operator::with(&EngineLoads::of(engine, kinematics)?, engine, task, places, &[])
    }

    /// As [`Operator::new`] where the engine's loads are known, with the areas of the shafts' axes.
    pub fn with(
        engine_loads: &EngineLoads,
        engine: &Engine,
        task: &BalanceTask,
        places: &[Vec<(Complex64, f64)>],
        areas: &[AxisArea],
    ) -> Result<Operator, BalanceError> {
        let &EngineLoads { ref orders, ref mains, revolutions: own, speed, .. } = engine_loads;
        let ratios: Vec<Ratio> = task.weights.iter().map(|w| ratio_of(engine, task, w.seat)).collect();
        let of_gas = engine_loads.places.revolutions.max(1);
        let revolutions = (1..=MOST_REVOLUTIONS)
            .find(|r| {
                r % own == 0 && r % of_gas == 0 && ratios.iter().all(|ratio| r % ratio.denominator() == 0)
            })
            .ok_or(LoadError::PeriodTooLong { limit: MOST_REVOLUTIONS })?;
        let mut operator = Operator {
            speed,
            grid: Rc::new(Grid::new(1, 1)),
            channels: Default::default(),
            mains: mains.iter().map(|main| main_waves(engine, main, revolutions)).collect(),
            variables: 0,
            weights: Vec::new(),
            inertia: None,
            positive: Vec::new(),
            axes: Vec::new(),
            equalities: Matrix::zeros(0, 0),
            equal_to: Vec::new(),
            natural_force: engine_loads.natural_force,
            natural_moment: engine_loads.natural_moment,
            largest: Vec::new(),
            places: Rc::clone(&engine_loads.places),
        };
        for order in orders {
            operator.add_order(order, revolutions);
        }
        for (index, weight) in task.weights.iter().enumerate() {
            operator.add_weight(ratios[index], weight.phase, weight.most, &places[index], revolutions);
            if let Seat::Crankshaft(crankshaft) = weight.seat {
                operator.load_mains(mains, crankshaft, index, revolutions);
            }
        }
        for (shaft, area) in areas.iter().enumerate() {
            operator.add_axis(task, shaft, area, revolutions);
        }
        if let Some(inertia) = task.inertias.first() {
            let torque = torque(orders, revolutions);
            operator.add_inertia(inertia, &torque);
        }
        operator.add_largest(task);
        operator.equalities = operator.ties(task);
        operator.equal_to = vec![0.0; operator.equalities.rows];
        let waves = operator.channels.iter().chain(operator.mains.iter().flatten());
        let highest = waves.flat_map(|c| c.base.keys().chain(c.parts.iter().map(|p| &p.1)));
        let of_gas = operator.places.highest_order * revolutions;
        let highest = highest.copied().max().unwrap_or(0).max(of_gas) as usize;
        let count = (ANGLES * revolutions as usize).max(8 * highest);
        operator.grid = Rc::new(Grid::new(revolutions, count));
        Ok(operator)
    }

    /// Unbalance [kg m] of weight `index`, all corners together, and its centroid: axis and plane.
    pub fn unbalance(&self, index: usize, x: &[f64]) -> Complex64 {
        self.weights[index].corners.iter().map(|c| c.unbalance(x)).sum()
    }

    fn channel_mut(&mut self, channel: Channel) -> &mut Wave {
        &mut self.channels[channel as usize]
    }

    fn add_order(&mut self, order: &OrderLoads, revolutions: u32) {
        let key = key(order.order, revolutions);
        for (x, y, forward, backward) in [
            (Channel::ForceX, Channel::ForceY, order.force_forward, order.force_backward),
            (Channel::CoupleX, Channel::CoupleY, order.couple_forward, order.couple_backward),
        ] {
            let (even, odd) = (forward + backward, forward - backward);
            self.channel_mut(x).add_base(key, even.re, -odd.im);
            self.channel_mut(y).add_base(key, even.im, odd.re);
        }
        let roll = order.roll_moment;
        self.channel_mut(Channel::RollMoment).add_base(key, roll.re, -roll.im);
    }

    /// Two variables a corner, one on a given line.
    fn add_weight(
        &mut self,
        ratio: Ratio,
        phase: Phase,
        most: Option<f64>,
        places: &[(Complex64, f64)],
        revolutions: u32,
    ) {
        let square = (ratio.value() * self.speed).powi(2);
        let natural = self.natural_force / square;
        let unit = most.filter(|m| *m > 0.0).map_or(natural, |m| m.min(natural));
        let directions: Vec<Complex64> = match phase {
            Phase::Free => vec![Complex64::ONE, Complex64::I],
            Phase::Line(angle) | Phase::Direction(angle) => vec![Complex64::cis(angle)],
        };
        let key = turning_key(ratio, revolutions);
        let sense = if ratio.numerator() > 0 { 1.0 } else { -1.0 };
        let mut corners = Vec::new();
        for &(axis, z) in places {
            let mut terms = Vec::new();
            for direction in &directions {
                let variable = self.variables;
                self.variables += 1;
                if matches!(phase, Phase::Direction(_)) {
                    self.positive.push(variable);
                }
                let unbalance = unit * direction;
                terms.push((variable, unbalance));
                let force = square * unbalance;
                let couple = Complex64::new(0.0, z) * force;
                let roll = axis.conj() * force;
                for (x, y, of) in
                    [(Channel::ForceX, Channel::ForceY, force), (Channel::CoupleX, Channel::CoupleY, couple)]
                {
                    self.channel_mut(x).add_part(variable, key, of.re, -sense * of.im);
                    self.channel_mut(y).add_part(variable, key, of.im, sense * of.re);
                }
                // Im( Y e^{i n theta} ).
                self.channel_mut(Channel::RollMoment).add_part(variable, key, roll.im, sense * roll.re);
            }
            corners.push(Corner { axis, z, terms });
        }
        self.weights.push(WeightColumns { ratio, corners, unit });
    }

    /// What weight `index` on a crankshaft adds to the loads of its mains, each corner shared out as by a lever.
    fn load_mains(&mut self, mains: &[MainOrders], crankshaft: usize, index: usize, revolutions: u32) {
        let own: Vec<usize> = (0..mains.len()).filter(|&m| mains[m].crankshaft == crankshaft).collect();
        let planes: Vec<f64> = own.iter().map(|&m| mains[m].z).collect();
        let Some(beam) = Beam::new(&planes, BeamModel::ThrowByThrow) else { return };
        let WeightColumns { ratio, ref corners, .. } = self.weights[index];
        let square = (ratio.value() * self.speed).powi(2);
        let key = turning_key(ratio, revolutions);
        let sense = if ratio.numerator() > 0 { 1.0 } else { -1.0 };
        for corner in corners {
            for (main, share) in beam.shares(corner.z) {
                let [x, y] = &mut self.mains[own[main]];
                for (variable, unbalance) in &corner.terms {
                    let force = share * square * unbalance;
                    x.add_part(*variable, key, force.re, -sense * force.im);
                    y.add_part(*variable, key, force.im, sense * force.re);
                }
            }
        }
    }

    /// The sum `S` of the weights of a shaft shared out among the corners of its area: only the roll moment sees it.
    fn add_axis(&mut self, task: &BalanceTask, shaft: usize, area: &AxisArea, revolutions: u32) {
        let ratio = task.shafts[shaft].ratio;
        let own = |index: &usize| task.weights[*index].seat == Seat::Shaft(shaft);
        let unit = (0..task.weights.len()).filter(own).map(|w| self.weights[w].unit).fold(0.0, f64::max);
        let square = (ratio.value() * self.speed).powi(2);
        let directions = area
            .direction
            .map_or_else(|| vec![Complex64::ONE, Complex64::I], |angle| vec![Complex64::cis(angle)]);
        let key = turning_key(ratio, revolutions);
        let sense = if ratio.numerator() > 0 { 1.0 } else { -1.0 };
        let mut corners = Vec::new();
        for &axis in area.corners.iter().skip(1) {
            let mut terms = Vec::new();
            for direction in &directions {
                let variable = self.variables;
                self.variables += 1;
                if area.direction.is_some() {
                    self.positive.push(variable);
                }
                terms.push((variable, unit * direction));
                let roll = (axis - area.corners[0]).conj() * square * unit * direction;
                self.channel_mut(Channel::RollMoment).add_part(variable, key, roll.im, sense * roll.re);
            }
            corners.push(Corner { axis, z: 0.0, terms });
        }
        self.axes.push(corners);
    }

    fn add_inertia(&mut self, inertia: &FreeInertia, torque: &Wave) {
        let variable = self.variables;
        self.variables += 1;
        self.positive.push(variable);
        for (&key, [cos, sin]) in &torque.base {
            self.channel_mut(Channel::RollMoment).add_part(variable, key, *cos, *sin);
        }
        self.inertia = Some((variable, most_share(inertia)));
    }

    /// A variable for each mean with gas that is judged at several speeds.
    fn add_largest(&mut self, task: &BalanceTask) {
        let is_mean = |one: &Criterion| matches!(one, Criterion::MainsWithGas(Statistic::Mean, _));
        if self.places.cycles.len() > 1 {
            for criterion in criteria(task, is_mean) {
                self.largest.push((criterion, self.variables));
                self.variables += 1;
            }
        }
    }

    /// Rows of `U_second - factor U_first = 0` (or its mirror image).
    fn ties(&self, task: &BalanceTask) -> Matrix {
        let mut rows = Matrix::zeros(0, self.variables);
        for tie in &task.ties {
            let (first, second) = (&self.weights[tie.first], &self.weights[tie.second]);
            let unit = first.unit.max(second.unit);
            let mut pair = [vec![0.0; self.variables], vec![0.0; self.variables]];
            for (variable, value) in second.corners.iter().flat_map(|c| &c.terms) {
                pair[0][*variable] += value.re / unit;
                pair[1][*variable] += value.im / unit;
            }
            let sign = if tie.mirrored { -1.0 } else { 1.0 };
            for (variable, value) in first.corners.iter().flat_map(|c| &c.terms) {
                pair[0][*variable] -= tie.factor * value.re / unit;
                pair[1][*variable] -= sign * tie.factor * value.im / unit;
            }
            pair.iter().for_each(|row| rows.push(row));
        }
        rows
    }
}

impl Corner {
    pub fn unbalance(&self, x: &[f64]) -> Complex64 {
        self.terms.iter().map(|(variable, unit)| x[*variable] * unit).sum()
    }
}

/// The load of a main bearing along x and y.
fn main_waves(engine: &Engine, main: &MainOrders, revolutions: u32) -> [Wave; 2] {
    let each = turning_key(engine.crankshafts[main.crankshaft].ratio, revolutions);
    let mut waves = [Wave::default(), Wave::default()];
    for order in &main.orders {
        for (wave, force) in waves.iter_mut().zip([order.x, order.y]) {
            wave.add_base(order.harmonic * each, force.re, -force.im);
        }
    }
    waves
}

/// Key of what turns at a ratio.
fn turning_key(ratio: Ratio, revolutions: u32) -> u32 {
    (u64::from(ratio.numerator().unsigned_abs()) * u64::from(revolutions / ratio.denominator())) as u32
}

/// Speed ratio of what a weight sits on.
pub(crate) fn ratio_of(engine: &Engine, task: &BalanceTask, seat: Seat) -> Ratio {
    match seat {
        Seat::Crankshaft(index) => engine.crankshafts[index].ratio,
        Seat::Shaft(index) => task.shafts[index].ratio,
    }
}

/// Axis and plane of every weight whose place is given; the middle of what is free.
pub(crate) fn middle(engine: &Engine, task: &BalanceTask) -> Vec<Vec<(Complex64, f64)>> {
    let mean = |place: Place| match place {
        Place::At(value) => value,
        Place::Between(low, high) => 0.5 * (low + high),
    };
    let of = |seat: Seat| match seat {
        Seat::Crankshaft(index) => {
            let crankshaft = &engine.crankshafts[index];
            Complex64::new(crankshaft.x, crankshaft.y)
        }
        Seat::Shaft(index) => {
            let shaft = &task.shafts[index];
            Complex64::new(mean(shaft.x), mean(shaft.y))
        }
    };
    task.weights.iter().map(|w| vec![(of(w.seat), mean(w.z))]).collect()
}

/// `s` of an inertia `J`.
pub(crate) fn share_of(inertia: &FreeInertia, amount: f64) -> f64 {
    let k = inertia.ratio;
    amount * k * (k + 1.0) / (inertia.crank_inertia + k * k * amount)
}

/// The inertia `J` of a share `s`.
pub(crate) fn inertia_of(inertia: &FreeInertia, share: f64) -> f64 {
    let k = inertia.ratio;
    share * inertia.crank_inertia / (k * (k + 1.0 - share * k))
}

/// Largest share; without a bound on the inertia all but a billionth of what an endless one has.
fn most_share(inertia: &FreeInertia) -> f64 {
    let endless = (inertia.ratio + 1.0) / inertia.ratio * (1.0 - 1e-9);
    inertia.most.map_or(endless, |most| share_of(inertia, most).min(endless))
}

fn key(order: f64, revolutions: u32) -> u32 {
    (order * f64::from(revolutions)).round() as u32
}

fn torque(orders: &[OrderLoads], revolutions: u32) -> Wave {
    let mut wave = Wave::default();
    for order in orders {
        wave.add_base(key(order.order, revolutions), order.shaft_torque.re, -order.shaft_torque.im);
    }
    wave
}

/// Loads by order up to where nothing is left, and the period in revolutions.
fn orders(engine: &Engine, kinematics: Kinematics) -> Result<(Vec<OrderLoads>, u32), BalanceError> {
    let mut max_order = 24;
    loop {
        let request = LoadRequest { kinematics, max_order, ..LoadRequest::default() };
        let mechanism = Mechanism::new(engine, &request)?;
        let mut orders = mechanism.orders();
        clear_rounding(engine, &request, &mut orders)?;
        let revolutions = (mechanism.period() / std::f64::consts::TAU).round() as u32;
        let amounts =
            |o: &OrderLoads| [o.force_peak(), o.couple_peak(), o.roll_moment.norm(), o.shaft_torque.norm()];
        let largest = |from: f64| {
            let far = orders.iter().filter(|o| o.order > from).map(amounts);
            far.fold([0.0f64; 4], |a, b| std::array::from_fn(|m| a[m].max(b[m])))
        };
        let (all, tail) = (largest(-1.0), largest(0.75 * f64::from(max_order)));
        if max_order >= 1000 || (0..4).all(|m| tail[m] <= TAIL * all[m]) {
            return Ok((orders, revolutions));
        }
        max_order = (2 * max_order).min(1000);
    }
}

/// All moving masses at their largest acceleration at `speed` [rad/s], as if nothing cancelled [N], and that at the largest
/// lever [N m]: what the loads that are left are rounding beside.
pub fn natural(engine: &Engine, speed: f64) -> (f64, f64) {
    let mut force = 0.0;
    let mut lever = 0.0f64;
    for throw in &engine.throws {
        let ratio = engine.crankshafts[throw.crankshaft].ratio.value();
        force += throw.unbalance.abs() * (ratio * speed).powi(2);
        lever = lever.max(throw.z.abs()).max(throw.radius);
    }
    for cylinder in &engine.cylinders {
        let throw = &engine.throws[cylinder.throw];
        let ratio = engine.crankshafts[throw.crankshaft].ratio.value();
        let mass = cylinder.piston_mass + cylinder.rod.mass();
        force += mass * throw.radius * (ratio * speed).powi(2);
    }
    for weight in &engine.counterweights {
        let ratio = engine.crankshafts[weight.crankshaft].ratio.value();
        force += weight.unbalance * (ratio * speed).powi(2);
    }
    let force = if force > 0.0 { force } else { speed * speed };
    (force, force * if lever > 0.0 { lever } else { 1.0 })
}
