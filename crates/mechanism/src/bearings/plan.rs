//! Forces on pistons, pins and bearings over the cycle: the kernel that runs over all angles.
//!
//! Plain rods go through eight angles at a time, as in [`crate::trace`]; with `W`, `k'`, `s''` from there:
//!
//! ```text
//! F = -m s'' - f                    gas f from its samples                                       (26.1)
//! N = -(q F + J k') / W             wall on the piston along v                                   (26.2)
//! X = (m_p s'' + f) u - N v         rod on the piston pin                                        (26.3)
//! R = F u + N v                     rod on the crankpin, without its big-end mass                (26.4)
//! main j:  SUM over loads of share_j R + e^{i n theta} SUM of share_j U W^2 e^{i angle}          (26.6)
//! ```
//! Articulated rods follow one angle at a time and add to their masters; the thrust that they give to a master's piston reaches the crank in the
//! master's plane.

use crate::bearings::beam::{Beam, BeamModel};
use crate::bearings::request::{BearingPart, BearingRequest};
use crate::bearings::rod_force::{RodForce, RodLoads};
use crate::inertia::internal::turning_loads;
use crate::inertia::trace::{AngleGrid, CrankRow};
use crate::torque::gas::CylinderGas;
use crate::torque::gas_train::GasTrain;
use crate::torque::request::{Lever, TorqueError};
use crate::train::drive::{Drive, Linkage};
use crate::train::mechanism::{Mechanism, firing_period, linkage, master_of};
use lanchester_model::{Engine, Ratio};
use lanchester_numerics::{Kernel, LANES, Lanes, dispatch};
use num_complex::Complex64;

/// Forces over one period in columns, one vector a component; kept from call to call, so that nothing is allocated anew.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BearingTrace {
    /// By cylinder.
    pub rods: Vec<RodTrace>,
    /// By main bearing: crankshaft 1 first, each from the free end on.
    pub mains: Vec<[Vec<f64>; 2]>,
}

/// Forces of one rod and its piston [N].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RodTrace {
    /// Wall on the piston along `v` of the cylinder; the piston presses on the wall with the opposite.
    pub thrust: Vec<f64>,
    /// Rod on the piston pin along `u` and `v` of the cylinder.
    pub piston_pin: [Vec<f64>; 2],
    /// Rod on its lower pin along x and y, with big-end masses: the crankpin (a master with all that its articulated rods bring),
    /// or the knuckle pin of an articulated rod.
    pub lower_pin: [Vec<f64>; 2],
}

/// One rod, prepared.
#[derive(Debug, Clone, PartialEq)]
struct RodRow {
    cylinder: usize,
    /// The same rod at one angle at a time.
    force: RodForce,
    ratio: f64,
    crank: CrankRow,
    mass: f64,
    inertia: f64,
    piston_mass: f64,
    along: Complex64,
    /// Centrifugal force of the big end at `theta = 0` and its table.
    big_end: Complex64,
    sense: f64,
    /// Mains that carry it, with shares.
    shares: [(usize, f64); 2],
}

/// An articulated rod.
#[derive(Debug, Clone, PartialEq)]
struct SlaveRow {
    cylinder: usize,
    master: usize,
    force: RodForce,
    piston_mass: f64,
    /// Centrifugal force of its big end as if it sat on the crankpin, at `theta = 0`.
    big_end: Complex64,
    ratio: f64,
    /// Mains that carry what acts in its own plane, with shares.
    shares: [(usize, f64); 2],
    /// Mains that carry what acts in the plane of its master.
    master_shares: [(usize, f64); 2],
}

impl SlaveRow {
    /// Parts of a force with the mains that carry them.
    fn on_mains(&self, loads: &RodLoads) -> impl Iterator<Item = (usize, Complex64)> {
        let [own, with_master] = loads.by_plane();
        let parts = self.shares.map(|(main, share)| (main, share * own));
        parts.into_iter().chain(self.master_shares.map(|(main, share)| (main, share * with_master)))
    }
}

/// What turns with a crankshaft, at one main: coefficients of its table.
#[derive(Debug, Clone, PartialEq)]
struct TurningRow {
    main: usize,
    table: usize,
    ratio: f64,
    force: Complex64,
    sense: f64,
}

/// An engine at one speed with its gas, prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingPlan {
    pub(crate) speed: f64,
    pub(crate) period: f64,
    pub(crate) grid: AngleGrid,
    /// Crankshaft and plane of every main [m].
    pub(crate) mains: Vec<(usize, f64)>,
    rods: Vec<RodRow>,
    slaves: Vec<SlaveRow>,
    turning: Vec<TurningRow>,
    /// Gas force towards the crank at every angle, padded, by cylinder.
    gas: Vec<Vec<Lanes>>,
}

impl BearingPlan {
    /// Of `engine` under `gas`, one entry a cylinder; `None`: inertia alone.
    ///
    /// # Errors
    /// As [`crate::torque`].
    pub fn new(
        engine: &Engine,
        gas: Option<&[CylinderGas]>,
        request: &BearingRequest,
    ) -> Result<BearingPlan, TorqueError> {
        let with_gas = request.part != BearingPart::Inertia;
        let train = match gas.filter(|_| with_gas) {
            Some(gas) => Some(GasTrain::new(engine, gas, Lever::Exact)?),
            None => None,
        };
        let mechanism = Mechanism::new(engine, &request.loads())?;
        let revolutions = match &train {
            Some(train) => train.revolutions,
            None => firing_period(engine)?,
        };
        request.loads().check_angles(revolutions)?;
        let ratios = engine.crankshafts.iter().map(|crankshaft| crankshaft.ratio);
        let grid = AngleGrid::of(ratios, revolutions, request.samples);
        let inertia = if request.part == BearingPart::Gas { 0.0 } else { 1.0 };
        let blocks = grid.len().div_ceil(LANES);
        let mut plan = BearingPlan {
            speed: mechanism.speed,
            period: std::f64::consts::TAU * f64::from(revolutions),
            mains: Vec::new(),
            rods: Vec::new(),
            slaves: Vec::new(),
            turning: Vec::new(),
            gas: vec![vec![Lanes::ZERO; blocks]; engine.cylinders.len()],
            grid,
        };
        let mut beams = Vec::new();
        for index in 0..engine.crankshafts.len() {
            let planes = engine.main_planes(index);
            let first = plan.mains.len();
            let beam = Beam::new(&planes, BeamModel::ThrowByThrow);
            if let Some(beam) = &beam {
                plan.mains.extend(beam.mains().iter().map(|z| (index, *z)));
                plan.add_turning(engine, index, beam, first, inertia, request.counterweights);
            }
            beams.push((first, beam));
        }
        for index in 0..engine.cylinders.len() {
            plan.add_rod(engine, &mechanism, &beams, index, inertia)?;
        }
        if let Some(train) = &train {
            plan.set_gas(train);
        }
        Ok(plan)
    }

    /// Number of angles.
    pub fn angles(&self) -> usize {
        self.grid.len()
    }

    /// Takes the gas of `train`, which must be of the same engine; allocates nothing.
    pub fn set_gas(&mut self, train: &GasTrain) {
        let step = self.period / self.grid.len() as f64;
        for (piston, lanes) in train.pistons.iter().zip(&mut self.gas) {
            let rate = piston.ratio.value().abs() * step;
            let start = piston.own_angle(0.0);
            let mut samples = piston.force.samples(start, rate);
            for lane in lanes {
                lane.0.fill_with(|| samples.advance());
            }
        }
    }

    fn add_turning(
        &mut self,
        engine: &Engine,
        index: usize,
        beam: &Beam,
        first: usize,
        share: f64,
        counterweights: bool,
    ) {
        let bare;
        let turned = if counterweights {
            engine
        } else {
            bare = engine.without_counterweights();
            &bare
        };
        let ratio = engine.crankshafts[index].ratio;
        let mut forces = vec![Complex64::ZERO; beam.mains().len()];
        for (z, force) in turning_loads(turned, index, self.speed) {
            for (main, part) in beam.shares(z) {
                forces[main] += share * part * force;
            }
        }
        let table = self.grid.place(ratio);
        let sense = sense(ratio);
        self.turning.extend(forces.into_iter().enumerate().map(|(main, force)| TurningRow {
            main: first + main,
            table,
            ratio: ratio.value(),
            force,
            sense,
        }));
    }

    fn add_rod(
        &mut self,
        engine: &Engine,
        mechanism: &Mechanism,
        beams: &[(usize, Option<Beam>)],
        index: usize,
        inertia: f64,
    ) -> Result<(), TorqueError> {
        let cylinder = &engine.cylinders[index];
        let throw = &engine.throws[cylinder.throw];
        let crankshaft = &engine.crankshafts[throw.crankshaft];
        let Some((first, Some(beam))) = beams.get(throw.crankshaft) else { return Ok(()) };
        let shares_at = |z: f64| beam.shares(z).map(|(main, share)| (first + main, share));
        let shares = shares_at(cylinder.z);
        let mut piston = mechanism.pistons[index].clone();
        piston.mass *= inertia;
        piston.inertia *= inertia;
        if let Some(knuckle) = &mut piston.knuckle {
            knuckle.mass *= inertia;
        }
        let square = inertia * (crankshaft.ratio.value() * self.speed).powi(2);
        let angle = crankshaft.phase + throw.angle;
        let big_end = Complex64::from_polar(cylinder.rod.big_end_mass * throw.radius * square, angle);
        let piston_mass = cylinder.piston_mass * square;
        match &piston.drive {
            Drive::Exact(Linkage::Plain(slider)) => self.rods.push(RodRow {
                cylinder: index,
                force: RodForce::new(piston.clone(), linkage(engine, index)?, cylinder.angle),
                ratio: crankshaft.ratio.value(),
                crank: CrankRow::of(&piston, slider, &self.grid),
                mass: piston.mass,
                inertia: piston.inertia,
                piston_mass,
                along: Complex64::cis(cylinder.angle),
                big_end,
                sense: sense(crankshaft.ratio),
                shares,
            }),
            _ => {
                let master = master_of(cylinder).unwrap_or(index);
                let ratio = crankshaft.ratio.value();
                let force = RodForce::new(piston, linkage(engine, index)?, engine.cylinders[master].angle);
                let master_shares = shares_at(engine.cylinders[master].z);
                self.slaves.push(SlaveRow {
                    cylinder: index,
                    master,
                    force,
                    piston_mass,
                    big_end,
                    ratio,
                    shares,
                    master_shares,
                });
            }
        }
        Ok(())
    }

    /// Writes the forces at all angles of the grid; allocates only where `trace` is too small.
    pub fn loads_into(&self, trace: &mut BearingTrace) {
        self.make_room(trace);
        dispatch(BearingKernel { plan: self, trace });
        self.add_slaves(trace);
    }

    fn make_room(&self, trace: &mut BearingTrace) {
        let padded = self.grid.len().div_ceil(LANES) * LANES;
        trace.rods.resize_with(self.gas.len(), RodTrace::default);
        trace.mains.resize_with(self.mains.len(), Default::default);
        for rod in &mut trace.rods {
            rod.thrust.resize(padded, 0.0);
            rod.piston_pin.iter_mut().chain(&mut rod.lower_pin).for_each(|c| c.resize(padded, 0.0));
        }
        trace.mains.iter_mut().flatten().for_each(|c| c.resize(padded, 0.0));
    }

    fn add_slaves(&self, trace: &mut BearingTrace) {
        for row in &self.slaves {
            for (j, &theta) in self.grid.theta().iter().enumerate() {
                let gas = self.gas[row.cylinder][j / LANES].0[j % LANES];
                let loads = row.force.loads(theta, gas);
                let own = &mut trace.rods[row.cylinder];
                own.thrust[j] = loads.thrust;
                own.piston_pin[0][j] = row.piston_mass * loads.acceleration + gas;
                own.piston_pin[1][j] = -loads.thrust;
                (own.lower_pin[0][j], own.lower_pin[1][j]) = (loads.knuckle.re, loads.knuckle.im);
                let master = &mut trace.rods[row.master];
                master.thrust[j] += loads.master_thrust;
                master.piston_pin[1][j] -= loads.master_thrust;
                let on_pin = loads.crankpin + row.big_end * Complex64::cis(row.ratio * theta);
                master.lower_pin[0][j] += on_pin.re;
                master.lower_pin[1][j] += on_pin.im;
                for (main, force) in row.on_mains(&loads) {
                    trace.mains[main][0][j] += force.re;
                    trace.mains[main][1][j] += force.im;
                }
            }
        }
    }
}

/// Forces of one rod and its piston at one angle [N], as in [`RodTrace`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RodInstant {
    pub thrust: f64,
    pub piston_pin: Complex64,
    pub lower_pin: Complex64,
}

impl BearingPlan {
    /// Forces of the rod of cylinder `index` at any crank angle `theta` [rad]; `gas` gives the gas force towards the crank by cylinder
    /// and angle. What is not carried by any main is zero, as in the traces.
    pub(crate) fn rod_at(&self, index: usize, theta: f64, gas: &impl Fn(usize, f64) -> f64) -> RodInstant {
        if let Some(row) = self.slaves.iter().find(|row| row.cylinder == index) {
            let gas = gas(index, theta);
            let loads = row.force.loads(theta, gas);
            let piston_pin = Complex64::new(row.piston_mass * loads.acceleration + gas, -loads.thrust);
            return RodInstant { thrust: loads.thrust, piston_pin, lower_pin: loads.knuckle };
        }
        let Some(row) = self.rods.iter().find(|row| row.cylinder == index) else {
            return RodInstant::default();
        };
        let own_gas = gas(index, theta);
        let loads = row.force.loads(theta, own_gas);
        let mut instant = RodInstant {
            thrust: loads.thrust,
            piston_pin: Complex64::new(row.piston_mass * loads.acceleration + own_gas, -loads.thrust),
            lower_pin: loads.crankpin + row.big_end * Complex64::cis(row.ratio * theta),
        };
        for slave in self.slaves.iter().filter(|slave| slave.master == index) {
            let loads = slave.force.loads(theta, gas(slave.cylinder, theta));
            instant.thrust += loads.master_thrust;
            instant.piston_pin.im -= loads.master_thrust;
            instant.lower_pin += loads.crankpin + slave.big_end * Complex64::cis(slave.ratio * theta);
        }
        instant
    }

    /// Journal on main bearing `main` at any crank angle `theta` [rad] [N].
    pub(crate) fn main_at(&self, main: usize, theta: f64, gas: &impl Fn(usize, f64) -> f64) -> Complex64 {
        let turning = self.turning.iter().filter(|row| row.main == main);
        let mut force: Complex64 = turning.map(|row| row.force * Complex64::cis(row.ratio * theta)).sum();
        let share = |shares: &[(usize, f64); 2]| -> f64 {
            shares.iter().filter(|share| share.0 == main).map(|share| share.1).sum()
        };
        for row in &self.rods {
            let share = share(&row.shares);
            if share != 0.0 {
                force += share * row.force.loads(theta, gas(row.cylinder, theta)).crankpin;
            }
        }
        for row in &self.slaves {
            if share(&row.shares) != 0.0 || share(&row.master_shares) != 0.0 {
                let loads = row.force.loads(theta, gas(row.cylinder, theta));
                force +=
                    row.on_mains(&loads).filter(|part| part.0 == main).map(|part| part.1).sum::<Complex64>();
            }
        }
        force
    }
}

fn sense(ratio: Ratio) -> f64 {
    f64::from(ratio.numerator().signum())
}

/// The kernel with its data.
struct BearingKernel<'a> {
    plan: &'a BearingPlan,
    trace: &'a mut BearingTrace,
}

/// `force` turned with its shaft.
#[inline(always)]
fn turned<const FMA: bool>(force: Complex64, sense: f64, (cos, sin): (Lanes, Lanes)) -> [Lanes; 2] {
    let (re, im) = (Lanes::all(force.re), Lanes::all(force.im));
    let sin = sin * Lanes::all(sense);
    [sin.taken_from::<FMA>(im, cos * re), sin.times_plus::<FMA>(re, cos * im)]
}

impl Kernel for BearingKernel<'_> {
    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let BearingKernel { plan, trace } = self;
        let blocks = plan.grid.len().div_ceil(LANES);
        for row in &plan.turning {
            let [x, y] = &mut trace.mains[row.main];
            for block in 0..blocks {
                let [re, im] = turned::<FMA>(row.force, row.sense, plan.grid.turn(row.table, block));
                x[block * LANES..][..LANES].copy_from_slice(&re.0);
                y[block * LANES..][..LANES].copy_from_slice(&im.0);
            }
        }
        for row in &plan.rods {
            let gas = &plan.gas[row.cylinder];
            let own = &mut trace.rods[row.cylinder];
            let [(front, _), (rear, _)] = row.shares;
            let shares = row.shares.map(|(_, share)| Lanes::all(share));
            for block in 0..blocks {
                let turn = plan.grid.turn(row.crank.table, block);
                let rod = row.crank.rod::<FMA>(turn.0, turn.1);
                let f = gas[block];
                let q = rod.s - Lanes::all(row.crank.offset);
                let along = rod.s2.taken_from::<FMA>(Lanes::all(row.mass), -f);
                let couple = rod.k1 * Lanes::all(row.inertia);
                let thrust = -(q.times_plus::<FMA>(along, couple) * rod.inverse);
                let (re, im) = (Lanes::all(row.along.re), Lanes::all(row.along.im));
                let x = thrust.taken_from::<FMA>(im, along * re);
                let y = thrust.times_plus::<FMA>(re, along * im);
                let end = turned::<FMA>(row.big_end, row.sense, turn);
                let from = block * LANES;
                own.thrust[from..][..LANES].copy_from_slice(&thrust.0);
                let pin = rod.s2.times_plus::<FMA>(Lanes::all(row.piston_mass), f);
                own.piston_pin[0][from..][..LANES].copy_from_slice(&pin.0);
                own.piston_pin[1][from..][..LANES].copy_from_slice(&(-thrust).0);
                own.lower_pin[0][from..][..LANES].copy_from_slice(&(x + end[0]).0);
                own.lower_pin[1][from..][..LANES].copy_from_slice(&(y + end[1]).0);
                for (main, share) in [front, rear].into_iter().zip(shares) {
                    let [to_x, to_y] = &mut trace.mains[main];
                    add::<FMA>(&mut to_x[from..][..LANES], x, share);
                    add::<FMA>(&mut to_y[from..][..LANES], y, share);
                }
            }
        }
    }
}

#[inline(always)]
fn add<const FMA: bool>(to: &mut [f64], value: Lanes, share: Lanes) {
    let mut sum = Lanes::ZERO;
    sum.0.copy_from_slice(to);
    to.copy_from_slice(&value.times_plus::<FMA>(share, sum).0);
}
